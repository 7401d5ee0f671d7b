//! The force, F = 2∫₀^a Q ds, exactly as the segments hold it, at any point of a panel.

use super::chain::Chain;
use super::closure::Way;
use super::drive::Instant;
use super::gauss::Gauss;
use super::line::{FADED, Field, Line, Segment, field};
use super::window::GROWTH;
use crate::indentation::Profile;

/// dF/dt of an edge at rest.
pub(super) fn force_rate(gauss: &Gauss, solid: (&Chain, &Profile), line: &Line, now: &Instant) -> f64 {
    integral(gauss, solid, line, None, now, |field| field.rate)
}

/// F at an instant, with the edge at the origin or on the way.
pub(super) fn force(gauss: &Gauss, solid: (&Chain, &Profile), line: &Line, way: Option<Way<'_>>, now: &Instant) -> f64 {
    integral(gauss, solid, line, way, now, |field| field.value)
}

fn integral(
    gauss: &Gauss,
    (chain, profile): (&Chain, &Profile),
    line: &Line,
    way: Option<Way<'_>>,
    now: &Instant,
    of: impl Fn(Field) -> f64 + Copy,
) -> f64 {
    let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
    let mut sum = 0.0;
    let mut add = |segment: &Segment, from: f64, to: f64| {
        sum += part(gauss, chain, profile, line.edge, segment, now, (from, to), of, 60);
    };
    for segment in &line.inside {
        let advances = way.is_some_and(|way| way.advances);
        // A panel that turns is followed beyond its start: the last segment then ends where the panel begins.
        let high = if advances { segment.high } else { segment.high.min(edge) };
        if segment.low >= high {
            continue;
        }
        let to = if high < segment.high { segment.theta_at(high) } else { segment.theta_high };
        if segment.blank {
            add(segment, segment.theta_at(segment.low), segment.theta_at(high))
        } else {
            add(segment, segment.theta_low, to)
        }
    }
    if let Some(way) = way.filter(|way| way.advances) {
        add(way.panel, -1.0, way.theta);
    }
    2.0 * sum
}

pub(super) fn part(
    gauss: &Gauss,
    chain: &Chain,
    profile: &Profile,
    origin: f64,
    segment: &Segment,
    now: &Instant,
    (from, to): (f64, f64),
    of: impl Fn(Field) -> f64 + Copy,
    cuts: u32,
) -> f64 {
    let [shortest, longest] = chain.times(true);
    let lag = |theta: f64| (now.time - segment.time_at(theta)).abs().clamp(0.5 * shortest, FADED * longest);
    if !segment.blank && cuts > 0 {
        let (first, second) = (lag(from), lag(to));
        if first.max(second) > GROWTH * first.min(second) {
            let middle = from + if first < second { 0.25 } else { 0.75 } * (to - from);
            return [(from, middle), (middle, to)]
                .map(|ends| part(gauss, chain, profile, origin, segment, now, ends, of, cuts - 1))
                .iter()
                .sum();
        }
    }
    let span = to - from;
    gauss
        .nodes
        .iter()
        .zip(gauss.weights)
        .map(|(x, weight)| {
            let theta = from + span * x;
            let (place, slope) = segment.place_at(theta);
            weight * span * slope * of(field(chain, true, segment, theta, profile.line(origin + place), now))
        })
        .sum()
}
