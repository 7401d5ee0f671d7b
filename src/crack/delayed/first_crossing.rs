//! When a resting tip starts: the first time at which the work reaches Δγ, proved to be the first.
//!
//! At rest in a zone of one length every M_j obeys Ṁ_j = g_jκ − l_jM_j with κ straight in time, so M_j(t) is a straight line plus one
//! exponential: convex or concave throughout. A zone that follows the load grows and shrinks with it, and M_j grows with the zone: the greater
//! zone of an interval, kept fixed over it, bounds M_j from above. Over an interval a convex one is at most its chord, a concave one at most a parallel to it through the
//! crossing of its end tangents; so κ(κ + ΣM_j) is at most a parabola, and an interval in which that stays below Δγ holds no start. Others are halved, the earlier half
//! first. The bound is of second order in the width: after a slow arrest the work falls away from Δγ like the square of the time.

use super::memory::Term;
use super::moments::fading_moments;
use std::rc::Rc;

/// Intervals looked at before what is left counts as a touch that starts nothing.
const MOST_INTERVALS: u32 = 20_000;

/// A rest: the terms' memories at its start for any zone, and the load over it.
pub(crate) struct Rest<'a> {
    pub(crate) terms: &'a [Term],
    /// The memories in the zone of a load.
    pub(crate) memories: &'a dyn Fn(f64) -> Vec<f64>,
    /// Whether the zone follows the load; if not, the memories are those of any.
    pub(crate) follows: bool,
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
    /// The memories at the start of the rest, in the zone of this moment.
    starts: Rc<Vec<f64>>,
    memories: Vec<f64>,
}

impl Moment {
    fn excess(&self, threshold: f64) -> f64 {
        self.load * (self.load + self.memories.iter().sum::<f64>()) - 1.0 - threshold
    }
}

impl Rest<'_> {
    fn load_at(&self, time: f64) -> f64 {
        if time >= self.duration { self.loads[1] } else { self.loads[0] + (self.loads[1] - self.loads[0]) * (time / self.duration) }
    }

    /// The memories at a time, from those at the start in a zone that is kept.
    fn memories_at(&self, time: f64, starts: &[f64]) -> Vec<f64> {
        let load = self.load_at(time);
        let evolved = |(term, memory): (&Term, &f64)| {
            let (decay, [n0, n1, ..]) = fading_moments(term.rate * time);
            decay * memory + term.gain * time * (load * n0 + (self.loads[0] - load) * n1)
        };
        self.terms.iter().zip(starts).map(evolved).collect()
    }

    /// The moment at a time; of a constant zone the starts are those of any other moment.
    fn at(&self, time: f64, known: Option<&Moment>) -> Moment {
        let load = self.load_at(time);
        let starts = match known.filter(|_| !self.follows) {
            Some(known) => Rc::clone(&known.starts),
            None => Rc::new((self.memories)(load)),
        };
        Moment { time, load, memories: self.memories_at(time, &starts), starts }
    }

    /// An upper bound of the excess between two moments.
    fn bound(&self, start: &Moment, end: &Moment) -> f64 {
        let width = end.time - start.time;
        // In the greater of the zones.
        let (firsts, lasts) = match (self.follows, start.load < end.load) {
            (false, _) => (start.memories.clone(), end.memories.clone()),
            (true, true) => (self.memories_at(start.time, &end.starts), end.memories.clone()),
            (true, false) => (start.memories.clone(), self.memories_at(end.time, &start.starts)),
        };
        // Each M_j is below its chord, raised by how far the crossing of its end tangents is above it.
        let [mut before, mut after] = [0.0; 2];
        for ((term, first), last) in self.terms.iter().zip(&firsts).zip(&lasts) {
            let slopes = [term.gain * start.load - term.rate * first, term.gain * end.load - term.rate * last];
            let chord = (last - first) / width;
            let raised = if slopes[0] > slopes[1] {
                // first + s₀u = last − s₁(w − u)
                let crossing = ((last - first - slopes[1] * width) / (slopes[0] - slopes[1])).clamp(0.0, width);
                ((slopes[0] - chord) * crossing).max(0.0)
            } else {
                0.0
            };
            before += first + raised;
            after += last + raised;
        }
        // Both factors of κ(κ + M) are straight now: the greatest value of a parabola.
        let [load, rise] = [start.load, end.load - start.load];
        let [sum, gain] = [start.load + before, end.load + after - (start.load + before)];
        let at = |part: f64| (load + rise * part) * (sum + gain * part);
        let top = -0.5 * (load * gain + rise * sum) / (rise * gain);
        let within = if top > 0.0 && top < 1.0 { at(top) } else { 0.0 };
        at(0.0).max(at(1.0)).max(within) - 1.0 - self.threshold
    }

    /// The time from the start of the rest to the first start of growth, or none; and how many moments it took.
    pub(crate) fn first_crossing(&self) -> (Option<f64>, u32) {
        let mut count = 2;
        // Intervals still to be looked at, the earliest last.
        let start = self.at(0.0, None);
        let end = self.at(self.duration, Some(&start));
        let mut open = vec![(start, end)];
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
            let middle = self.at(middle, Some(&start));
            count += 1;
            open.push((middle.clone(), end));
            open.push((start, middle));
        }
        (None, count)
    }
}
