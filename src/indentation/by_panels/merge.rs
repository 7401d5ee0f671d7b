//! Merging of old segments, so that a history without end needs a bounded memory.
//!
//! Two neighbours away from the edge become one whose X is the strain of the present instant (T = 0), as one series in s over both, if it
//! misses none of the old strains, anywhere in either, by more than an error. Nothing is merged that the closure sees near the edge.

use super::chain::Chain;
use super::line::{Line, Segment};

/// Segments that one series over their union replaces, and the error that it may make in ΣX.
const MERGED: usize = 10;
/// Places at which each of the old ones is looked at, less one.
const LOOKS: u32 = 40;

impl Line {
    /// Joins neighbours of a list, away from the edge, where one series in s holds the present strains of both; `clear`: so far from the edge.
    pub(super) fn merge(&mut self, chain: &Chain, inside: bool, clear: f64, error: f64) {
        let list = if inside { &mut self.inside } else { &mut self.outside };
        let mut k = 0;
        while k + 1 < list.len() {
            let [far, near] = [&list[k], &list[k + 1]];
            let reach = if inside { -near.high } else { near.low };
            let joined = if far.blank || near.blank || reach < clear { None } else { joined(chain, inside, far, near, error) };
            match joined {
                Some(segment) => {
                    list[k] = segment;
                    list.remove(k + 1);
                }
                None => k += 1,
            }
        }
    }
}

/// One segment for two, whose X are those of the present instant (T = 0), if it holds ΣX to an error.
pub(super) fn joined(chain: &Chain, inside: bool, far: &Segment, near: &Segment, error: f64) -> Option<Segment> {
    let n = chain.terms();
    let terms = if inside { &chain.relaxation } else { &chain.creep };
    let (low, high) = if inside { (far.low, near.high) } else { (near.low, far.high) };
    let border = if inside { far.high } else { near.high };
    let now = |s: f64, state: &mut [f64]| {
        let old = if (s < border) == inside { far } else { near };
        let theta = old.theta_at(s);
        let lag = -old.time_at(theta);
        for (j, value) in state.iter_mut().enumerate() {
            *value = (-lag * terms[j].1).exp() * old.state_at(n, j, theta);
        }
    };
    let place = |x: f64| 0.5 * (low + high) + 0.5 * (high - low) * x;
    let mut states = vec![0.0; MERGED * (n + 1)];
    let mut state = vec![0.0; n];
    for k in 0..MERGED {
        let angle = std::f64::consts::PI * (k as f64 + 0.5) / MERGED as f64;
        now(place(angle.cos()), &mut state);
        for q in 0..MERGED {
            let weight = if q == 0 { 1.0 } else { 2.0 } / MERGED as f64 * (q as f64 * angle).cos();
            states[q * (n + 1)..].iter_mut().zip(&state).for_each(|(sum, value)| *sum += weight * value);
        }
    }
    let (places, times) = (vec![0.5 * (low + high), 0.5 * (high - low)], vec![0.0]);
    let merged = Segment {
        low,
        high,
        theta_low: -1.0,
        theta_high: 1.0,
        place: 0.0,
        time: 0.0,
        blank: false,
        straight: true,
        places,
        times,
        depths: vec![],
        states,
    };
    // In each of the two, however narrow it is, and towards its ends, where a root may stand; between them a strain of one term may come and go within a short way.
    let holds = |old: &Segment| {
        (0..=LOOKS).all(|k| {
            let part = 0.5 * (1.0 - (std::f64::consts::PI * f64::from(k) / f64::from(LOOKS)).cos());
            let theta = old.theta_low + (old.theta_high - old.theta_low) * part;
            let lag = -old.time_at(theta);
            let x = (2.0 * old.place_at(theta).0 - low - high) / (high - low);
            let miss = |j: usize| (merged.state_at(n, j, x) - (-lag * terms[j].1).exp() * old.state_at(n, j, theta)).abs();
            (0..n).map(miss).sum::<f64>() <= error
        })
    };
    (holds(far) && holds(near)).then_some(merged)
}
