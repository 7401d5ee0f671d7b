//! The force, F = 2∫₀^a Q ds, exactly as the segments hold it, at any point of a panel.
//!
//! Q = base(t) − E0 f(s) + Σ e^{−(t−T)/ρ_i}X_i: the first two in closed form, so that breaks of the profile need no care;
//! the strains by quadrature, smooth on each segment whatever the profile.

use super::chain::Chain;
use super::closure::Way;
use super::drive::Instant;
use super::gauss::Gauss;
use super::line::{FADED, Field, Line, Segment, field};
use super::window::{GROWTH, MOST_CUTS};
use crate::indentation::Profile;

/// dF/dt of an edge at rest.
pub(super) fn force_rate((chain, _): (&Chain, &Profile), line: &Line, now: &Instant) -> f64 {
    2.0 * (line.edge * now.base_rate + Strains { chain, now, of: |field: Field| field.rate }.over(line, None))
}

/// F at an instant, with the edge at the origin or on the way.
pub(super) fn force((chain, profile): (&Chain, &Profile), line: &Line, way: Option<Way<'_>>, now: &Instant) -> f64 {
    let edge = line.edge + way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
    let strains = Strains { chain, now, of: |field: Field| field.value }.over(line, way);
    2.0 * (edge * now.base - chain.relaxed * profile.volume(edge) + strains)
}

/// ∫ Σ e^{−(t−T)/ρ_i}X_i ds over what is bonded, or its rate.
struct Strains<'a, Of> {
    chain: &'a Chain,
    now: &'a Instant,
    of: Of,
}

impl<Of: Fn(Field) -> f64> Strains<'_, Of> {
    fn over(&self, line: &Line, way: Option<Way<'_>>) -> f64 {
        let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
        let advances = way.is_some_and(|way| way.advances);
        let mut sum = 0.0;
        for segment in line.inside.iter().filter(|segment| !segment.blank) {
            // A panel that turns is followed beyond its start: the last segment then ends where the panel begins.
            let high = if advances { segment.high } else { segment.high.min(edge) };
            if segment.low < high {
                let to = if high < segment.high { segment.theta_at(high) } else { segment.theta_high };
                sum += self.part(segment, (segment.theta_low, to), MOST_CUTS);
            }
        }
        if let Some(way) = way.filter(|way| way.advances) {
            sum += self.part(way.panel, (-1.0, way.theta), MOST_CUTS);
        }
        sum
    }

    fn part(&self, segment: &Segment, (from, to): (f64, f64), cuts: u32) -> f64 {
        let lags = [from, to].map(|theta| self.now.time - segment.time_at(theta));
        let [shortest, longest] = self.chain.times(true);
        let [first, second] = lags.map(|lag| lag.abs().clamp(0.5 * shortest, FADED * longest));
        if cuts > 0 && first.max(second) > GROWTH * first.min(second) {
            let middle = from + if first < second { 0.25 } else { 0.75 } * (to - from);
            return self.part(segment, (from, middle), cuts - 1) + self.part(segment, (middle, to), cuts - 1);
        }
        if lags.iter().all(|lag| *lag > FADED * longest) {
            return 0.0;
        }
        let (span, rule) = (to - from, Gauss::get());
        // The strains alone: of a drive at rest at zero.
        let still = Instant { time: self.now.time, ..Instant::default() };
        let node = |(x, weight): (&f64, f64)| {
            let theta = from + span * x;
            weight * span * segment.place_at(theta).1 * (self.of)(field(self.chain, true, segment, theta, 0.0, &still))
        };
        rule.nodes.iter().zip(rule.weights).map(node).sum()
    }
}
