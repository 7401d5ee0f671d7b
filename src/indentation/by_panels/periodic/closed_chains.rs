//! The line of a closed path: every chain in its periodic state.
//!
//! Points inside the narrowest contact are always bonded: X = 0 beside the memory P_i of a sinus without end. Points beyond the widest one are always free:
//! X = 0. A point between is bonded from an instant t′ to t″ and free from t″ to t′ + period:
//! ```text
//! x(t″) = D_ρ x(t′) + r,    e(t″) = T x(t″),    e(t′) = D_τ e(t″),    x(t′) = S e(t′)            D = diag e^{−duration/time}, r = ∫e^{−(t″−t)/ρ}W dt/ρ
//! −[E_τ + T E_ρ S (1 + E_τ)] e(t″) = T r                                                         E = D − 1 by expm1
//! ```
//! T S = 1 has been taken off: a term that is 1e12 times slower than the cycle keeps its digits.

use super::super::chain::Chain;
use super::super::gauss::solve;
use super::super::line::{Break, Line, Segment, chebyshev};
use super::closed_path::ClosedPath;
use super::sinus::Sinus;
use crate::indentation::Profile;

/// Halvings of a segment whose series misses a state.
const MOST_CUTS: u32 = 12;

/// What the line is made of.
pub(super) struct ClosedChains<'a> {
    pub(super) chain: &'a Chain,
    pub(super) profile: &'a Profile,
    pub(super) sinus: Sinus,
    pub(super) path: &'a ClosedPath,
    /// δ.
    pub(super) zone: f64,
    /// Nodes of the states of a segment, and what their series may miss of ΣX, free and bonded.
    pub(super) samples: usize,
    pub(super) errors: [f64; 2],
}

/// A point that is passed twice a cycle.
struct Passages {
    /// e as it lets go, X as it is bonded.
    free: Vec<f64>,
    bonded: Vec<f64>,
    /// Q before it lets go, D before it is bonded.
    load: f64,
    gap: f64,
}

impl ClosedChains<'_> {
    /// The line at the start of a cycle, and the places of the turns; None if a chain has no periodic state.
    pub(super) fn line(&self, breaks: impl Fn(f64) -> Vec<Break>) -> Option<Line> {
        let path = self.path;
        let origin = path.way(0.0);
        let edge = path.edge + origin;
        let mut line = Line::new(edge, &breaks(edge));
        let [inmost, outmost] = [path.narrowest, path.widest].map(|turn| path.way(turn) - origin);
        line.inside = vec![Segment::blank(-edge, inmost)];
        line.outside = vec![Segment::blank(outmost, f64::INFINITY)];
        let advances = path.narrowest > path.widest;
        let period = path.period;
        // The branch under way, and the one before it up to where the edge is now: both began within the cycle that ends now.
        let turn = if advances { path.narrowest } else { path.widest };
        let (before, met) = (path.branch(!advances).0, path.passage(!advances, origin));
        for (way, from, to) in [(advances, turn, period), (!advances, before, met)] {
            let mut cuts: Vec<f64> = path.cuts().filter(|cut| *cut > from && *cut < to).collect();
            cuts.insert(0, from);
            cuts.push(to);
            for pair in cuts.windows(2) {
                self.segments(way, (pair[0], pair[1]), origin, MOST_CUTS, &mut line)?;
            }
        }
        // Neighbours share their borders.
        for (list, inside, end) in [(&mut line.inside, true, inmost), (&mut line.outside, false, outmost)] {
            let mut border = end;
            let count = list.len();
            for (k, segment) in list.iter_mut().enumerate().skip(1) {
                let next = match (k + 1 == count, inside) {
                    (true, _) => 0.0,
                    (false, true) => segment.high,
                    (false, false) => segment.low,
                };
                if inside {
                    (segment.low, segment.high) = (border, next)
                } else {
                    (segment.low, segment.high) = (next, border)
                }
                border = next;
            }
            list.retain(|segment| segment.blank || segment.low < segment.high);
        }
        // A branch of no length leaves the border of the blank at the edge.
        if let Some(last) = line.inside.last_mut() {
            last.high = 0.0;
        }
        if let Some(last) = line.outside.last_mut() {
            last.low = 0.0;
        }
        Some(line)
    }

    /// The segments of a piece of a branch; times count from the end of the cycle, places from `origin`.
    fn segments(&self, advances: bool, (from, to): (f64, f64), origin: f64, cuts: u32, line: &mut Line) -> Option<()> {
        if to - from <= 1e-13 * self.path.period {
            return Some(());
        }
        let n = self.chain.terms();
        let m = self.samples;
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut states = vec![0.0; m * (n + 1)];
        let mut places = vec![0.0; m];
        let mut basis = vec![0.0; m];
        for k in 0..m {
            let x = (std::f64::consts::PI * (k as f64 + 0.5) / m as f64).cos();
            chebyshev(x, &mut basis);
            let (way, state) = self.state(advances, middle + half * x)?;
            for (q, b) in basis.iter().enumerate() {
                let weight = if q == 0 { 1.0 } else { 2.0 } / m as f64 * b;
                places[q] += weight * (way - origin);
                states[q * (n + 1)..].iter_mut().zip(&state).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        let ends = [from, to].map(|time| self.path.way(time) - origin);
        let (low, high, theta_low, theta_high) = if advances { (ends[0], ends[1], -1.0, 1.0) } else { (ends[1], ends[0], 1.0, -1.0) };
        let times = vec![middle - self.path.period, half];
        let segment = Segment { theta_low, theta_high, blank: false, straight: false, places, times, states, ..Segment::blank(low, high) };
        // A term that fades within a short way of the edge counts by that way over the zone, and so does a short segment: the closure integrates over the zone.
        let length = high - low;
        let terms = if advances { &self.chain.relaxation } else { &self.chain.creep };
        let seen = |rate: f64| (length / (to - from) / (rate * self.zone)).min(1.0) * (length / self.zone).min(1.0);
        let misses = |x: f64| -> Option<bool> {
            let (_, state) = self.state(advances, middle + half * x)?;
            let miss: f64 = (0..n).map(|j| seen(terms[j].1) * (segment.state_at(n, j, x) - state[j]).abs()).sum();
            Some(miss > self.errors[usize::from(advances)])
        };
        if cuts > 0 {
            for x in [-1.0, -0.9, 0.1, 0.9, 1.0] {
                if misses(x)? {
                    self.segments(advances, (from, middle), origin, cuts - 1, line)?;
                    return self.segments(advances, (middle, to), origin, cuts - 1, line);
                }
            }
        }
        if advances {
            line.inside.push(segment)
        } else {
            line.outside.push(segment)
        }
        Some(())
    }

    /// Way and state of the point that a branch passes at a time.
    fn state(&self, advances: bool, time: f64) -> Option<(f64, Vec<f64>)> {
        let path = self.path;
        let way = path.way(time);
        let other = path.passage(!advances, way);
        let (bonds, frees) = if advances { (time, other) } else { (other, time) };
        let found = self.closed(way, bonds, frees)?;
        let (mut state, last) = if advances { (found.bonded, found.gap) } else { (found.free, found.load) };
        state.push(last);
        Some((way, state))
    }

    /// The periodic state of a point that is bonded at one instant and lets go at another.
    fn closed(&self, way: f64, bonds: f64, frees: f64) -> Option<Passages> {
        let (chain, sinus, period) = (self.chain, &self.sinus, self.path.period);
        let n = chain.terms();
        let turns = self.path.branch(true).1 - self.path.branch(false).0;
        let bonded = (frees + turns - bonds).clamp(0.0, period);
        let free = period - bonded;
        let (start, end) = (bonds, bonds + bonded);
        let height = self.profile.line(self.path.edge + way);
        let creep: Vec<f64> = chain.relaxation.iter().map(|&(_, rate)| sinus.creep(rate, height, start, end)).collect();
        let by_bond: Vec<f64> = chain.relaxation.iter().map(|&(_, rate)| (-bonded * rate).exp_m1()).collect();
        let by_free: Vec<f64> = chain.creep.iter().map(|&(_, rate)| (-free * rate).exp_m1()).collect();
        let mut matrix = vec![0.0; n * n];
        let mut right = vec![0.0; n];
        chain.voigt(&creep, &mut right);
        for j in 0..n {
            for k in 0..n {
                let through: f64 = (0..n).map(|i| chain.to_voigt[j * n + i] * by_bond[i] * chain.to_dashpots[i * n + k]).sum();
                matrix[j * n + k] = -(through * (1.0 + by_free[k]) + if j == k { by_free[j] } else { 0.0 });
            }
            let largest = matrix[j * n..(j + 1) * n].iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            matrix[j * n..(j + 1) * n].iter_mut().for_each(|entry| *entry /= largest);
            right[j] /= largest;
        }
        if !solve(&mut matrix, &mut right) || !right.iter().all(|value| value.is_finite()) {
            return None;
        }
        let voigt: Vec<f64> = right.iter().zip(&by_free).map(|(e, fallen)| e * (1.0 + fallen)).collect();
        let mut dashpots = vec![0.0; n];
        chain.dashpots(&voigt, &mut dashpots);
        let (first, last) = (sinus.depth(start) - height, sinus.depth(end) - height);
        let memory = sinus.memory(chain, start);
        let mut load = chain.relaxed * last;
        let mut states = vec![0.0; n];
        for i in 0..n {
            let modulus = chain.relaxation[i].0;
            states[i] = modulus * (first - dashpots[i]) - memory[i];
            load += modulus * (last - (dashpots[i] * (1.0 + by_bond[i]) + creep[i]));
        }
        Some(Passages { free: right, bonded: states, load, gap: voigt.iter().sum::<f64>() - first })
    }
}
