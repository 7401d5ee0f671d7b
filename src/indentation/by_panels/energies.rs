//! Energies of a contact: exact integrals over every spring and dashpot of the line, bonded or free, and what is turned over on the way.
//!
//! ```text
//! U   = ∫ [E0W² + Σ q_i²/E_i] ds  (bonded),     ∫ Σ e_j²/J_j ds  (free)                 thesis Eq 4.30 on the line
//! P_d = 2∫ Σ q_i²/(E_iρ_i) ds     (bonded),     2∫ Σ e_j²/(J_jτ_j) ds  (free)           thesis Eq 4.32
//! K_I = −Q(a)/√(πa),   G_tip = K_I²/(2E∞*),     F dΔ + G_tip dA = dU + P_d dt
//! ```
//! A merged segment keeps the sum of its strains only to the merging error, and so do these integrals.

use super::chain::Chain;
use super::closure::Way;
use super::drive::Instant;
use super::gauss::Gauss;
use super::line::{FADED, Line, SERIES, Segment, chebyshev, field};
use super::window::{GROWTH, MOST_CUTS};
use crate::indentation::Profile;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// At an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// U (J).
    pub stored: f64,
    /// P_d (W).
    pub dissipated_power: f64,
}

/// Since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct TurnedOver {
    /// ∫F dΔ (J).
    pub external: f64,
    /// ∫G_tip dA (J).
    pub tip: f64,
    /// ∫P_d dt, and what jumps set free (J).
    pub dissipated: f64,
}

/// K_I (Pa√m) of the edge.
pub(super) fn stress_intensity((chain, profile): (&Chain, &Profile), line: &Line, way: Option<Way<'_>>, now: &Instant) -> f64 {
    let (segment, theta, place) = match way {
        Some(way) if way.advances => (way.panel, way.theta, way.panel.place_at(way.theta).0),
        _ => {
            let place = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
            let segment = line.at(true, place);
            (segment, segment.theta_at(place), place)
        }
    };
    let edge = line.edge + place;
    -field(chain, true, segment, theta, profile.line(edge), now).value / (PI * edge).sqrt()
}

/// U and P_d at an instant, with the edge at the origin or on the way.
pub(super) fn energies(solid: (&Chain, &Profile), line: &Line, way: Option<Way<'_>>, now: &Instant) -> Energies {
    let scene = Scene { solid, origin: line.edge, now };
    let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
    let mut sum = Energies::default();
    for (bonded, list) in [(true, &line.inside), (false, &line.outside)] {
        let grows = way.is_some_and(|way| way.advances == bonded);
        for segment in list {
            if !bonded && segment.blank {
                // Never touched: nothing is stored.
                continue;
            }
            // A panel that turns is followed beyond its start: the list that it joins then ends where it begins.
            let (low, high) = match (grows, bonded) {
                (true, _) => (segment.low, segment.high),
                (false, true) => (segment.low, segment.high.min(edge)),
                (false, false) => (segment.low.max(edge), segment.high),
            };
            if low < high {
                let theta = |s: f64, end: f64, at_end: f64| {
                    if !segment.blank && s.to_bits() == end.to_bits() { at_end } else { segment.theta_at(s) }
                };
                let range = (theta(low, segment.low, segment.theta_low), theta(high, segment.high, segment.theta_high));
                for piece in line.pieces(segment, (low, high), range) {
                    scene.add(bonded, segment, piece, MOST_CUTS, &mut sum);
                }
            }
        }
        if let Some(way) = way.filter(|_| grows) {
            let (places, range) = if bonded { ((0.0, edge), (-1.0, way.theta)) } else { ((edge, 0.0), (way.theta, -1.0)) };
            for piece in line.pieces(way.panel, places, range) {
                scene.add(bonded, way.panel, piece, MOST_CUTS, &mut sum);
            }
        }
    }
    sum
}

struct Scene<'a> {
    solid: (&'a Chain, &'a Profile),
    origin: f64,
    now: &'a Instant,
}

impl Scene<'_> {
    fn add(&self, bonded: bool, segment: &Segment, (from, to): (f64, f64), cuts: u32, sum: &mut Energies) {
        let (chain, profile) = self.solid;
        if !segment.blank && cuts > 0 {
            let [shortest, longest] = chain.times(bonded);
            let [first, second] =
                [from, to].map(|theta| (self.now.time - segment.time_at(theta)).abs().clamp(0.5 * shortest, FADED * longest));
            if first.max(second) > GROWTH * first.min(second) {
                let middle = from + if first < second { 0.25 } else { 0.75 } * (to - from);
                self.add(bonded, segment, (from, middle), cuts - 1, sum);
                return self.add(bonded, segment, (middle, to), cuts - 1, sum);
            }
        }
        let rule = Gauss::get();
        let n = chain.terms();
        let terms = if bonded { &chain.relaxation } else { &chain.creep };
        for (x, weight) in rule.nodes.iter().zip(rule.weights) {
            let theta = from + (to - from) * x;
            let (place, slope) = segment.place_at(theta);
            let width = weight * (to - from) * slope;
            let mut basis = [0.0; SERIES];
            chebyshev(theta, &mut basis);
            let lag = self.now.time - segment.time_at(theta);
            if bonded {
                let reach = self.now.depth - profile.line(self.origin + place);
                sum.stored += width * chain.relaxed * reach * reach;
            }
            for (j, &(size, rate)) in terms.iter().enumerate() {
                let state: f64 =
                    if segment.blank { 0.0 } else { segment.states.chunks_exact(n + 1).zip(&basis).map(|(row, b)| row[j] * b).sum() };
                let here = (-lag * rate).exp() * state + if bonded { self.now.memory[j] } else { 0.0 };
                sum.stored += width * here * here / size;
                sum.dissipated_power += width * 2.0 * here * here / size * rate;
            }
        }
    }
}
