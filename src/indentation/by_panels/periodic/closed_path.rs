//! A path of the edge over one cycle that ends where it starts: pieces a(t), each a Chebyshev series in time, between its two turns.

use super::super::line::{chebyshev, series};
use super::super::trail::Trail;

/// Coefficients of a piece: no more than the states of the least degree have.
const COEFFICIENTS: usize = 10;
/// Halvings of a piece.
const MOST_CUTS: u32 = 14;
/// Places at which a turn is looked for in a piece, and halvings of its instant.
const SAMPLES: usize = 16;
const HALVINGS: u32 = 60;
/// Pieces shorter than this part of the cycle are rounding.
const SLIVER: f64 = 1e-9;

/// A piece, from an instant to another.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) from: f64,
    pub(super) to: f64,
    ways: Vec<f64>,
}

impl Piece {
    fn at(&self, time: f64) -> (f64, f64) {
        let half = 0.5 * (self.to - self.from);
        let (value, slope) = series(&self.ways, ((time - self.from) / half - 1.0).clamp(-1.0, 1.0));
        (value, slope / half)
    }
}

/// The path, as ways from a radius `edge`.
#[derive(Debug, Clone)]
pub(super) struct ClosedPath {
    pub(super) edge: f64,
    pub(super) period: f64,
    pub(super) pieces: Vec<Piece>,
    /// The instants of its turns, widest and narrowest, in [0, period).
    pub(super) widest: f64,
    pub(super) narrowest: f64,
}

impl ClosedPath {
    /// From ways over one cycle, closed already, with known cuts; `tolerance` of a way.
    pub(super) fn new((edge, period): (f64, f64), way: impl Fn(f64) -> f64, cuts: &[f64], tolerance: f64) -> Self {
        let mut path = Self { edge, period, pieces: Vec::new(), widest: 0.0, narrowest: 0.0 };
        path.pieces = fitted(&way, &clean(cuts, period), tolerance);
        (path.widest, path.narrowest) = (path.turn(1.0), path.turn(-1.0));
        let turned: Vec<f64> = cuts.iter().copied().chain([path.widest, path.narrowest]).collect();
        path.pieces = fitted(&way, &clean(&turned, period), tolerance);
        path
    }

    /// A cycle of a trail, from a time of it on; what is missing to its start is taken off all along.
    pub(super) fn of_trail(edge: f64, period: f64, trail: &Trail, start: f64, tolerance: f64) -> Self {
        let missing = trail.at(start + period) - trail.at(start);
        let way = |time: f64| trail.at(start + time) + missing * (1.0 - time / period);
        let cuts: Vec<f64> = trail.passed.iter().map(|passed| passed.time - start).collect();
        Self::new((edge, period), way, &cuts, tolerance)
    }

    /// Σ of paths with weights whose sum is 1, on the pieces of the last one.
    pub(super) fn mixed(paths: &[(f64, &Self)], tolerance: f64) -> Option<Self> {
        let (_, last) = paths.last()?;
        let way = |time: f64| paths.iter().map(|(weight, path)| weight * path.way(time)).sum::<f64>();
        let cuts: Vec<f64> = last.cuts().collect();
        Some(Self::new((last.edge, last.period), way, &cuts, tolerance))
    }

    /// The starts of its pieces.
    pub(super) fn cuts(&self) -> impl Iterator<Item = f64> + '_ {
        self.pieces.iter().map(|piece| piece.from)
    }

    fn within(&self, time: f64) -> (f64, f64) {
        let time = time.rem_euclid(self.period);
        let after = self.pieces.partition_point(|piece| piece.from <= time);
        self.pieces.get(after.saturating_sub(1)).map_or((0.0, 0.0), |piece| piece.at(time))
    }

    /// a − edge at any time.
    pub(super) fn way(&self, time: f64) -> f64 {
        self.within(time).0
    }

    /// The instant of the widest (1) or narrowest (−1) contact.
    fn turn(&self, sign: f64) -> f64 {
        let place = |piece: &Piece, k: usize| piece.from + (piece.to - piece.from) * k as f64 / SAMPLES as f64;
        let times: Vec<f64> = self.pieces.iter().flat_map(|piece| (0..SAMPLES).map(move |k| place(piece, k))).collect();
        let Some(best) = (0..times.len()).max_by(|&one, &other| (sign * self.way(times[one])).total_cmp(&(sign * self.way(times[other]))))
        else {
            return 0.0;
        };
        let (mut low, mut high) = (
            if best == 0 { times.last().copied().unwrap_or(0.0) - self.period } else { times[best - 1] },
            times.get(best + 1).copied().unwrap_or(self.period),
        );
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if sign * self.within(middle).1 > 0.0 { low = middle } else { high = middle }
        }
        (0.5 * (low + high)).rem_euclid(self.period)
    }

    /// Start and end of the branch on which it advances, or recedes: turn to turn, the start within the cycle.
    pub(super) fn branch(&self, advances: bool) -> (f64, f64) {
        let (from, to) = if advances { (self.narrowest, self.widest) } else { (self.widest, self.narrowest) };
        (from, if to > from { to } else { to + self.period })
    }

    /// When a branch passes a way.
    pub(super) fn passage(&self, advances: bool, way: f64) -> f64 {
        let (mut low, mut high) = self.branch(advances);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if (self.way(middle) < way) == advances { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// How far it goes against the direction of its branches, at most.
    pub(super) fn backwards(&self) -> f64 {
        let mut most = 0.0_f64;
        for (advances, sign) in [(true, 1.0), (false, -1.0)] {
            let (from, to) = self.branch(advances);
            let samples = SAMPLES * self.pieces.len();
            let mut furthest = f64::NEG_INFINITY;
            for k in 0..=samples {
                let here = sign * self.way(from + (to - from) * k as f64 / samples as f64);
                furthest = furthest.max(here);
                most = most.max(furthest - here);
            }
        }
        most
    }
}

/// Cuts within a cycle in their order, with its ends, none beside another.
fn clean(cuts: &[f64], period: f64) -> Vec<f64> {
    let mut cuts: Vec<f64> = cuts.iter().copied().filter(|cut| *cut > SLIVER * period && *cut < (1.0 - SLIVER) * period).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|next, before| *next - *before < SLIVER * period);
    cuts.insert(0, 0.0);
    cuts.push(period);
    cuts
}

fn fitted(way: &impl Fn(f64) -> f64, cuts: &[f64], tolerance: f64) -> Vec<Piece> {
    let mut pieces = Vec::new();
    cuts.windows(2).for_each(|pair| fit(way, pair[0], pair[1], tolerance, MOST_CUTS, &mut pieces));
    pieces
}

/// A series through samples; in two halves where it misses what is between them.
fn fit(way: &impl Fn(f64) -> f64, from: f64, to: f64, tolerance: f64, cuts: u32, pieces: &mut Vec<Piece>) {
    let time = |x: f64| 0.5 * (from + to) + 0.5 * (to - from) * x;
    let piece = Piece { from, to, ways: interpolated(COEFFICIENTS, |x| way(time(x))) };
    let off = |x: &f64| (series(&piece.ways, *x).0 - way(time(*x))).abs() > tolerance;
    if cuts > 0 && [-1.0, -0.95, -0.6, 0.08, 0.6, 0.95, 1.0].iter().any(off) {
        let middle = 0.5 * (from + to);
        fit(way, from, middle, tolerance, cuts - 1, pieces);
        return fit(way, middle, to, tolerance, cuts - 1, pieces);
    }
    pieces.push(piece);
}

/// Chebyshev coefficients of a function on (−1, 1).
pub(super) fn interpolated(count: usize, function: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut coefficients = vec![0.0; count];
    let mut basis = vec![0.0; count];
    for k in 0..count {
        let x = (std::f64::consts::PI * (k as f64 + 0.5) / count as f64).cos();
        chebyshev(x, &mut basis);
        let value = function(x);
        for (q, (sum, b)) in coefficients.iter_mut().zip(&basis).enumerate() {
            *sum += if q == 0 { 1.0 } else { 2.0 } / count as f64 * b * value;
        }
    }
    coefficients
}
