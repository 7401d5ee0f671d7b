//! How large steps are, and how exactly they are found: bounds that go with the tolerance by the order of the path, so that two integrations never take the same steps.

use super::integrator::{CLOCK, HALF, Integrator, LOOSEST, NEARLY};
use super::stepping::SMALLEST;

/// Most steps of one segment of a history, or of one of its cycles, at a tolerance of 1e-4 or more; below it they grow with the steps of an integration.
const MOST_STEPS: f64 = 6_000.0;
/// See [`MOST_STEPS`].
const TIGHT: f64 = 1e-4;
/// Largest step of the edge, over the process zone (without adhesion: over a 25th of the contact's size).
const LARGEST_REACH: f64 = 0.5;
/// Of an elastic solid: over the contact radius, where that is more.
const OF_CONTACT: f64 = 0.05;
/// Accepted residual of the edge condition, over the tolerance of the path, and its bounds: rounding below, a certificate above.
const EDGE_TOLERANCE: f64 = 1e-4;
const SMALLEST_EDGE_TOLERANCE: f64 = 1e-12;
const LARGEST_EDGE_TOLERANCE: f64 = 2e-11;
/// Shortest step, over the time since the last corner.
const SHORTEST: f64 = 1e-12;
/// Growth of a step over the one before at the tolerance below: polynomials through points whose distances double tell little of their own errors. It goes with the
/// tolerance by the order of the path: integrations that grow alike err alike, however tight they are.
const GROWTH: f64 = 0.5;
const AT_GROWTH: f64 = 1e-2;
/// The least: below it the error of a step rules alone.
const SMALLEST_GROWTH: f64 = 0.15;
/// Least measure of an error, over the process zone.
const SHORTEST_MEASURE: f64 = 1e-2;

/// The longest step (s) of one that may take `cap` towards an instant that is `left`, where a clock tells `least`.
///
/// What is nearly all that is left is all of it, and of less no more than half is taken: a short last step tells little of its own error, which K follows. Halves
/// that the clock does not tell would go nowhere.
pub(super) fn towards(left: f64, cap: f64, least: f64) -> f64 {
    if cap >= NEARLY * left {
        return left;
    }
    let half = HALF * left;
    if half > least { cap.min(half) } else { left }
}

impl Integrator<'_> {
    /// Steps of a segment, or of a cycle, after which an integration stands still.
    pub(super) fn most_steps(&self) -> u64 {
        (MOST_STEPS * (TIGHT / self.tolerance).powf(1.0 / 6.0).max(1.0)) as u64
    }

    /// Largest step of the edge. Bounds go with the tolerance as well, by the order of the path: two integrations never take the same steps.
    pub(super) fn largest_reach(&self) -> f64 {
        LARGEST_REACH * self.stride() * self.measured_by()
    }

    /// What the way of the edge is measured by: the process zone; nothing fades in an elastic solid, whose edge is the same by whatever steps it came.
    fn measured_by(&self) -> f64 {
        if self.springs.terms() == 0 { self.length.max(OF_CONTACT * self.contact.radius()) } else { self.length }
    }

    /// The first step after a corner: what the clock can still tell, or more.
    pub(super) fn first_step(&self) -> f64 {
        (self.first * self.tolerance.sqrt()).max(CLOCK * f64::EPSILON * self.time)
    }

    /// How much smaller the bounds of steps are than at the loosest tolerance.
    pub(super) fn stride(&self) -> f64 {
        (self.tolerance / LOOSEST).powf(1.0 / 6.0).min(1.0)
    }

    /// Growth of a step over the one before, at most.
    pub(super) fn fastest(&self) -> f64 {
        1.0 + (GROWTH * (self.tolerance / AT_GROWTH).powf(1.0 / 6.0)).clamp(SMALLEST_GROWTH, GROWTH)
    }

    /// No step is made shorter for its error than this.
    pub(super) fn shortest_step(&self) -> f64 {
        (SHORTEST * (self.time - self.corner)).max(CLOCK * f64::EPSILON * self.time)
    }

    /// What an error of the place of the edge is seen against: the stresses that a step leaves behind an adhering edge know the way that it went, and K with them.
    pub(super) fn measure(&self, way: f64) -> f64 {
        let length = self.measured_by();
        (way * length).sqrt().clamp(SHORTEST_MEASURE * length, length)
    }

    /// Accepted residual: well below what the path is known to.
    pub(super) fn edge_tolerance(&self) -> f64 {
        (EDGE_TOLERANCE * self.tolerance).clamp(SMALLEST_EDGE_TOLERANCE, LARGEST_EDGE_TOLERANCE)
    }

    /// The smallest contact that is one.
    pub(super) fn smallest(&self) -> f64 {
        SMALLEST * self.zone_now()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_goes_in_halves_that_the_clock_tells() {
        assert!((towards(1.0, 2.0, 1e-15) - 1.0).abs() < 1e-15 && (towards(1.0, 0.9995, 1e-15) - 1.0).abs() < 1e-15);
        assert!((towards(1.0, 0.9, 1e-15) - 0.5).abs() < 1e-15 && (towards(1.0, 0.2, 1e-15) - 0.2).abs() < 1e-15);
        // A step that never may take what is left arrives all the same: an edge that turned just before an instant had stood still there for 6000 steps.
        let target = 30.0_f64.next_up();
        let (mut time, mut steps) = (target - 1e-9, 0);
        while time < target && steps < 100 {
            let left: f64 = target - time;
            time += towards(left, 0.9 * left, CLOCK * f64::EPSILON * time);
            steps += 1;
        }
        assert!(time >= target && steps < 40, "{steps} steps to {time}");
    }
}
