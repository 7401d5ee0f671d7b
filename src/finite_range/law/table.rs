//! A law of attraction through given points: monotone cubic pieces (Fritsch & Carlson, 1980), so that the curve never overshoots.

use crate::continuation::bracket::halved;
use crate::refusal::{Refusal, require_positive};

/// A tabulated law in reduced form (gap over range, stress over W/r): points, slopes there, and the work left from each point.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    gaps: Vec<f64>,
    stresses: Vec<f64>,
    slopes: Vec<f64>,
    works: Vec<f64>,
}

impl Table {
    /// The reduced table with its work of adhesion and range (see [`super::Attraction::from_table`]).
    pub(super) fn reduced(gaps: &[f64], stresses: &[f64]) -> Result<(Self, f64, f64), Refusal> {
        let undefined = |reason: &str| Refusal::Undefined { quantity: "the tabulated law", reason: reason.to_owned() };
        if gaps.len() < 3 || gaps.len() != stresses.len() {
            return Err(undefined("it needs at least three points and as many stresses as gaps"));
        }
        if gaps.iter().chain(stresses).any(|v| !v.is_finite()) || gaps.windows(2).any(|w| w[1] <= w[0]) {
            return Err(undefined("its values must be finite and its gaps must increase"));
        }
        let first = stresses.iter().position(|&s| s < 0.0).ok_or_else(|| undefined("it has no tension (negative stress)"))?;
        if stresses[first..].iter().any(|&s| s > 0.0) {
            return Err(undefined("it repels again beyond its first tension"));
        }
        let mut ended = stresses.to_vec();
        if let Some(last) = ended.last_mut() {
            *last = 0.0;
        }
        let raw = Self::through(gaps.to_vec(), ended);
        let peak = require_positive("largest tension of the table", raw.stresses.iter().fold(0.0_f64, |m, &s| m.max(-s)))?;
        let work = require_positive("work of adhesion of the table", raw.work_left(raw.zero()))?;
        let range = require_positive("range of the table", work / peak)?;
        let table = Self::through(raw.gaps.iter().map(|g| g / range).collect(), raw.stresses.iter().map(|s| s / peak).collect());
        Ok((table, work, range))
    }

    fn through(gaps: Vec<f64>, stresses: Vec<f64>) -> Self {
        let n = gaps.len();
        let chord: Vec<f64> = (1..n).map(|i| (stresses[i] - stresses[i - 1]) / (gaps[i] - gaps[i - 1])).collect();
        let mut slopes = vec![0.0; n];
        // The last point joins the zero beyond it smoothly; the first one continues its chord.
        slopes[0] = chord[0];
        for i in 1..n - 1 {
            let (a, b) = (chord[i - 1], chord[i]);
            if a * b > 0.0 {
                let (left, right) = (gaps[i] - gaps[i - 1], gaps[i + 1] - gaps[i]);
                slopes[i] = 3.0 * (left + right) / ((2.0 * right + left) / a + (right + 2.0 * left) / b);
            }
        }
        let mut works = vec![0.0; n];
        for i in (0..n - 1).rev() {
            let h = gaps[i + 1] - gaps[i];
            works[i] = works[i + 1] - h * (0.5 * (stresses[i] + stresses[i + 1]) + h * (slopes[i] - slopes[i + 1]) / 12.0);
        }
        Self { gaps, stresses, slopes, works }
    }

    /// The piece that holds a gap inside the table, with the place in it (0 to 1).
    fn piece(&self, u: f64) -> (usize, f64, f64) {
        let i = self.gaps.partition_point(|&g| g <= u).clamp(1, self.gaps.len() - 1) - 1;
        let h = self.gaps[i + 1] - self.gaps[i];
        (i, (u - self.gaps[i]) / h, h)
    }

    fn below(&self, u: f64) -> Option<f64> {
        (u < self.gaps[0]).then(|| u - self.gaps[0])
    }

    fn beyond(&self, u: f64) -> bool {
        u >= self.gaps[self.gaps.len() - 1]
    }

    /// Coefficients of the cubic of piece `i` in t, lowest power first.
    fn cubic(&self, i: usize, h: f64) -> [f64; 4] {
        let (a, b, c, d) = (self.stresses[i], self.stresses[i + 1], h * self.slopes[i], h * self.slopes[i + 1]);
        [a, c, 3.0 * (b - a) - 2.0 * c - d, 2.0 * (a - b) + c + d]
    }

    pub(super) fn stress(&self, u: f64) -> f64 {
        if let Some(x) = self.below(u) {
            return self.stresses[0] + x * self.slopes[0];
        }
        if self.beyond(u) {
            return 0.0;
        }
        let (i, t, h) = self.piece(u);
        let c = self.cubic(i, h);
        c[0] + t * (c[1] + t * (c[2] + t * c[3]))
    }

    pub(super) fn slope(&self, u: f64) -> f64 {
        if self.below(u).is_some() {
            return self.slopes[0];
        }
        if self.beyond(u) {
            return 0.0;
        }
        let (i, t, h) = self.piece(u);
        let c = self.cubic(i, h);
        (c[1] + t * (2.0 * c[2] + 3.0 * t * c[3])) / h
    }

    pub(super) fn work_left(&self, u: f64) -> f64 {
        if let Some(x) = self.below(u) {
            return self.works[0] + x * (self.stresses[0] + 0.5 * x * self.slopes[0]);
        }
        if self.beyond(u) {
            return 0.0;
        }
        let (i, t, h) = self.piece(u);
        let c = self.cubic(i, h);
        self.works[i] + h * t * (c[0] + t * (c[1] / 2.0 + t * (c[2] / 3.0 + t * c[3] / 4.0)))
    }

    /// The first point of largest tension.
    pub(super) fn peak_gap(&self) -> f64 {
        let least = self.stresses.iter().zip(&self.gaps).min_by(|a, b| a.0.total_cmp(b.0));
        least.map_or(0.0, |(_, &gap)| gap)
    }

    /// The largest slope inside any piece: at an end of it or at the middle of its parabola.
    pub(super) fn steepest(&self) -> f64 {
        let mut most = self.slopes.iter().copied().fold(0.0_f64, f64::max);
        for i in 0..self.gaps.len() - 1 {
            let h = self.gaps[i + 1] - self.gaps[i];
            let c = self.cubic(i, h);
            let t = -c[2] / (3.0 * c[3]);
            if t > 0.0 && t < 1.0 {
                most = most.max((c[1] + t * c[2]) / h);
            }
        }
        most
    }

    pub(super) fn points(&self) -> &[f64] {
        &self.gaps
    }

    /// The gap of a hard wall: the first one, if the table does not begin with repulsion.
    pub(super) fn wall(&self) -> Option<f64> {
        (self.stresses[0] <= 0.0).then(|| self.gaps[0])
    }

    /// Where the stress turns from repulsion to tension (the first gap if the table begins with tension).
    pub(super) fn zero(&self) -> f64 {
        let Some(after) = self.stresses.iter().position(|&s| s <= 0.0).filter(|&i| i > 0) else {
            return self.gaps[0];
        };
        halved([self.gaps[after - 1], self.gaps[after]], |gap| self.stress(gap) > 0.0)[1]
    }
}
