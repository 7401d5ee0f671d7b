//! When a resting tip starts: the first time at which the work reaches Δγ, proved to be the first.
//!
//! At rest every M_j obeys Ṁ_j = g_jκ − l_jM_j with κ straight in time, so M_j(t) is a straight line plus one exponential: convex or concave
//! throughout. Over an interval a convex one is at most its greater end, a concave one at most the crossing of its end tangents; so
//! κ(κ + ΣM_j) has an upper bound, and an interval whose bound is below Δγ holds no start. Others are halved, the earlier half first.

use super::memory::Term;
use super::moments::fading_moments;

/// Intervals looked at before what is left counts as a touch that starts nothing.
const MOST_INTERVALS: u32 = 20_000;

/// A rest: the terms' memories at its start, and the load over it.
pub(crate) struct Rest<'a> {
    pub(crate) terms: &'a [Term],
    pub(crate) memories: &'a [f64],
    pub(crate) loads: [f64; 2],
    pub(crate) duration: f64,
    /// The work that must be exceeded is Δγ(1 + threshold).
    pub(crate) threshold: f64,
}

/// The state at a time of the rest.
#[derive(Clone)]
struct Moment {
    time: f64,
    load: f64,
    memories: Vec<f64>,
}

impl Moment {
    fn excess(&self, threshold: f64) -> f64 {
        self.load * (self.load + self.memories.iter().sum::<f64>()) - 1.0 - threshold
    }
}

impl Rest<'_> {
    fn at(&self, time: f64) -> Moment {
        let load =
            if time >= self.duration { self.loads[1] } else { self.loads[0] + (self.loads[1] - self.loads[0]) * (time / self.duration) };
        let memories = self
            .terms
            .iter()
            .zip(self.memories)
            .map(|(term, memory)| {
                let (decay, [n0, n1, _]) = fading_moments(term.rate * time);
                decay * memory + term.gain * time * (load * n0 + (self.loads[0] - load) * n1)
            })
            .collect();
        Moment { time, load, memories }
    }

    /// An upper bound of the excess between two moments.
    fn bound(&self, start: &Moment, end: &Moment) -> f64 {
        let width = end.time - start.time;
        let mut sum = 0.0;
        for ((term, first), last) in self.terms.iter().zip(&start.memories).zip(&end.memories) {
            let slopes = [term.gain * start.load - term.rate * first, term.gain * end.load - term.rate * last];
            sum += if slopes[0] > 0.0 && slopes[1] < 0.0 {
                // first + s₀u = last − s₁(w − u)
                let crossing = (last - first - slopes[1] * width) / (slopes[0] - slopes[1]);
                (first + slopes[0] * crossing.clamp(0.0, width)).max(first.max(*last))
            } else {
                first.max(*last)
            };
        }
        let load = start.load.max(end.load);
        load * (load + sum) - 1.0 - self.threshold
    }

    /// The time from the start of the rest to the first start of growth, or none; and how many moments it took.
    pub(crate) fn first_crossing(&self) -> (Option<f64>, u32) {
        let mut count = 2;
        // Intervals still to be looked at, the earliest last.
        let mut open = vec![(self.at(0.0), self.at(self.duration))];
        while let Some((start, end)) = open.pop() {
            if self.bound(&start, &end) <= 0.0 {
                continue;
            }
            let middle = 0.5 * (start.time + end.time);
            let closed = middle <= start.time || middle >= end.time || end.time - start.time <= 2.0 * f64::EPSILON * end.time;
            if closed || count > MOST_INTERVALS {
                if end.excess(self.threshold) > 0.0 {
                    return (Some(end.time), count);
                }
                continue;
            }
            let middle = self.at(middle);
            count += 1;
            open.push((middle.clone(), end));
            open.push((start, middle));
        }
        (None, count)
    }
}
