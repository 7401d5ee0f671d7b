//! The force, F = 2∫₀^a Q ds, exactly as the segments hold it, at any point of a panel.

use super::chain::Chain;
use super::closure::Way;
use super::drive::Instant;
use super::gauss::Gauss;
use super::line::{FADED, Field, Line, Segment, field};
use super::window::{GROWTH, MOST_CUTS};
use crate::indentation::Profile;

/// dF/dt of an edge at rest.
pub(super) fn force_rate(solid: (&Chain, &Profile), line: &Line, now: &Instant) -> f64 {
    Integral { solid, origin: line.edge, now, of: |field: Field| field.rate }.over(line, None)
}

/// F at an instant, with the edge at the origin or on the way.
pub(super) fn force(solid: (&Chain, &Profile), line: &Line, way: Option<Way<'_>>, now: &Instant) -> f64 {
    Integral { solid, origin: line.edge, now, of: |field: Field| field.value }.over(line, way)
}

pub(super) struct Integral<'a, Of> {
    pub(super) solid: (&'a Chain, &'a Profile),
    pub(super) origin: f64,
    pub(super) now: &'a Instant,
    pub(super) of: Of,
}

impl<Of: Fn(Field) -> f64> Integral<'_, Of> {
    fn over(&self, line: &Line, way: Option<Way<'_>>) -> f64 {
        let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
        let advances = way.is_some_and(|way| way.advances);
        let mut sum = 0.0;
        for segment in &line.inside {
            // A panel that turns is followed beyond its start: the last segment then ends where the panel begins.
            let high = if advances { segment.high } else { segment.high.min(edge) };
            if segment.low >= high {
                continue;
            }
            let to = if segment.blank || high < segment.high { segment.theta_at(high) } else { segment.theta_high };
            let from = if segment.blank { segment.theta_at(segment.low) } else { segment.theta_low };
            sum += line
                .pieces(segment, (segment.low, high), (from, to))
                .into_iter()
                .map(|piece| self.part(segment, piece, MOST_CUTS))
                .sum::<f64>();
        }
        if let Some(way) = way.filter(|way| way.advances) {
            sum += line
                .pieces(way.panel, (0.0, edge), (-1.0, way.theta))
                .into_iter()
                .map(|piece| self.part(way.panel, piece, MOST_CUTS))
                .sum::<f64>();
        }
        2.0 * sum
    }

    fn part(&self, segment: &Segment, (from, to): (f64, f64), cuts: u32) -> f64 {
        let (chain, profile) = self.solid;
        if !segment.blank && cuts > 0 {
            let [shortest, longest] = chain.times(true);
            let [first, second] =
                [from, to].map(|theta| (self.now.time - segment.time_at(theta)).abs().clamp(0.5 * shortest, FADED * longest));
            if first.max(second) > GROWTH * first.min(second) {
                let middle = from + if first < second { 0.25 } else { 0.75 } * (to - from);
                return self.part(segment, (from, middle), cuts - 1) + self.part(segment, (middle, to), cuts - 1);
            }
        }
        let (span, rule) = (to - from, Gauss::get());
        let node = |(x, weight): (&f64, f64)| {
            let theta = from + span * x;
            let (place, slope) = segment.place_at(theta);
            weight * span * slope * (self.of)(field(chain, true, segment, theta, profile.line(self.origin + place), self.now))
        };
        rule.nodes.iter().zip(rule.weights).map(node).sum()
    }
}
