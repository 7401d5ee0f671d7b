//! The work of the tension inside a moved edge on the gap outside the old one.
//!
//! ```text
//! (1/2δ) ∫₀^δ tension₊(d) gap₋(δ − d) dd          tension₊ of the contact re-solved with that edge moved out by δ,
//!                                                  gap₋ of the contact as it is; at equilibrium 2πΓ
//! ```
//! By d = δ sin²θ, in panels that halve towards each end down to the thinnest layer of either field. Source: thesis Eqs 3.26–3.30.

use super::fields::ArcPoint;
use super::state::ContactState;
use crate::special::gauss_legendre::UNIT_RULE;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// One of the two edges of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// Where the contact opens, at −a.
    Trailing,
    /// Where the contact closes, at +a.
    Leading,
}

/// The thinnest panel, in units of the thinnest layer.
const THINNEST: f64 = 0.03;
/// Never more panels than this at each end: 4^−30 of the process zone.
const MOST_PANELS: usize = 30;

/// (1/2δ) ∫ tension₊·gap₋ at an edge, in reduced units; `moved` is the contact with that edge moved out by `process_zone`.
#[must_use]
pub fn edge_work(contact: &ContactState, moved: &ContactState, edge: Edge, process_zone: f64) -> f64 {
    let breaks = panels(thinnest_layer(contact), process_zone);
    let integrand = |theta: f64| {
        let (sine, cosine) = theta.sin_cos();
        let (inside, outside) = (process_zone * sine * sine, process_zone * cosine * cosine);
        let width = 2.0 * moved.contact().half_width;
        let gap_width = 2.0 * (std::f64::consts::PI - contact.contact().half_width);
        let (inner, outer) = match edge {
            Edge::Trailing => (
                ArcPoint { from_trailing: inside, from_leading: width - inside },
                ArcPoint { from_trailing: outside, from_leading: gap_width - outside },
            ),
            Edge::Leading => (
                ArcPoint { from_trailing: width - inside, from_leading: inside },
                ArcPoint { from_trailing: gap_width - outside, from_leading: outside },
            ),
        };
        // dd = 2δ sin θ cos θ dθ, over 2δ.
        -moved.pressure(inner) * contact.gap(outer) * sine * cosine
    };
    let mut work = 0.0;
    for pair in breaks.windows(2) {
        if let [low, high] = pair {
            let width = high - low;
            work += UNIT_RULE.iter().map(|&(node, weight)| weight * width * integrand(low + width * node)).sum::<f64>();
        }
    }
    work
}

/// The smallest sliding ratio of the material, a length in 1/k.
fn thinnest_layer(contact: &ContactState) -> f64 {
    let memory = &contact.memory;
    let creep = memory.creep().iter().map(|mode| mode.ratio);
    let relaxation = memory.relaxation.iter().map(|mode| mode.ratio);
    creep.chain(relaxation).fold(f64::INFINITY, f64::min)
}

/// Panel ends in θ from 0 to π/2: halving towards both ends as long as the layer is thinner.
fn panels(layer: f64, process_zone: f64) -> Vec<f64> {
    let mut halves = vec![FRAC_PI_4];
    for _ in 0..MOST_PANELS {
        let last = halves.last().copied().unwrap_or(FRAC_PI_4);
        if process_zone * last * last < THINNEST * layer {
            break;
        }
        halves.push(0.5 * last);
    }
    let mut breaks = vec![0.0];
    breaks.extend(halves.iter().rev());
    breaks.extend(halves.iter().skip(1).map(|half| FRAC_PI_2 - half));
    breaks.push(FRAC_PI_2);
    breaks
}
