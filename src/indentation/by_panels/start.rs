//! The first contact: relaxed, or bonded at once.

use super::chain::Chain;
use super::closure::Window;
use super::drive::Instant;
use super::line::{Break, Line, Segment};
use super::problem::Problem;
use crate::indentation::Profile;

/// Radii at which a profile has no smooth continuation, of a contact of about a radius.
pub(super) fn breaks(profile: &Profile, edge: f64) -> Vec<Break> {
    match profile.face() {
        Profile::Table(shape) => shape.roots().into_iter().map(|(place, roots)| Break { place, roots: Some(roots) }).collect(),
        _ => profile.breaks(edge).into_iter().map(|place| Break { place, roots: None }).collect(),
    }
}

/// Samples of the state of a segment of the first contact.
const SAMPLES: usize = 9;

/// The contact bonded at once, at time zero: its segments, on which the profile is smooth.
pub(super) fn glassy(problem: &Problem, line: &mut Line, depth: f64) {
    let n = problem.chain.terms();
    let borders: Vec<f64> = line.broken(-line.edge, 0.0).collect();
    line.inside.clear();
    for pair in borders.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let mut segment = Segment { blank: false, places: vec![middle, half], times: vec![0.0], ..Segment::blank(pair[0], pair[1]) };
        segment.states = vec![0.0; SAMPLES * (n + 1)];
        for q in 0..SAMPLES {
            for k in 0..SAMPLES {
                let angle = std::f64::consts::PI * (k as f64 + 0.5) / SAMPLES as f64;
                let weight = if q == 0 { 1.0 } else { 2.0 } / SAMPLES as f64 * (q as f64 * angle).cos();
                let depth = depth - problem.profile.line(line.edge + middle + half * angle.cos());
                for (i, term) in problem.chain.relaxation.iter().enumerate() {
                    segment.states[q * (n + 1) + i] += weight * term.0 * depth;
                }
            }
        }
        line.inside.push(segment);
    }
}

/// The larger radius in elastic equilibrium, modulus E*, under a penetration.
pub(super) fn elastic_start(profile: &Profile, modulus: f64, adhesion: f64, zone: f64, depth: f64) -> Option<f64> {
    let chain = Chain::new(modulus, modulus, &[], &[]);
    let mut window = Window::new(zone);
    let now = Instant { depth, base: modulus * depth, ..Instant::default() };
    // Those of a table do not depend on the edge.
    let fixed = matches!(profile.face(), Profile::Table(_)).then(|| breaks(profile, zone));
    let mut excess = |edge: f64| {
        let line = fixed.as_ref().map_or_else(|| Line::new(edge, &breaks(profile, edge)), |breaks| Line::new(edge, breaks));
        let value = window.closure((&chain, profile), &line, None, &now, false).value;
        (if depth > profile.line(edge) { -value } else { value }) - adhesion
    };
    let mut high = 1.05 * zone;
    while excess(high) < 0.0 || profile.line(high) < depth || excess(0.9 * high) > excess(high) {
        high *= 1.1;
        if !high.is_finite() {
            return None;
        }
    }
    let mut low = high;
    while excess(low) > 0.0 {
        low *= 0.97;
        if low < zone {
            return None;
        }
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if excess(middle) > 0.0 { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}
