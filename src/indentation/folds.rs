//! Where t(a) has a fold, the edge accelerates unstably: how far ahead one is, and whether an edge is beyond it.

use super::edge::Imposed;
use super::integrator::Integrator;
use super::line::NARROWEST;
use crate::refusal::Refusal;

/// Where the edge is looked at where a fold has been reached, over the process zone: below it the residual is noise.
const SMALLEST_BEYOND: f64 = 1e-2;
/// Distance from the fold of t(a), over the process zone, at which it may be taken as reached, and at which it is in any case.
const AT_FOLD: f64 = 4e-4;
const NEAREST: f64 = 4e-5;
/// Narrowest panels that tell a place near a fold.
const PLACES: f64 = 100.0;
/// Largest |g| on this side of a fold whose last digits tell no distance.
const FLAT: f64 = 1e-10;
/// Distance of a fold, over the process zone, that is near.
const NEAR_FOLD: f64 = 2.0;
/// Error of g near a fold: what the accepted residual and its last digits leave. With the part of the change below, 0.68 of what is said not to be known was needed
/// among 245 folds of random spheres of wide spectra (integrations at 1e-9 to 1e-8 beside each other).
const NOISE_OF_EDGE: f64 = 5e-14;
/// What is not known of a distance, over what the edge condition changed of it.
const OF_THE_CHANGE: f64 = 0.1;
/// What is not known of a distance that three steps foresee, over it: 0.024 was needed once in 240 random spheres. The edge condition changes no more of it.
const FORESEEN: f64 = 0.05;

/// A fold of t(a) a little ahead of the edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fold {
    /// The way to it (m).
    pub(super) distance: f64,
    /// What is not known of that way, over it.
    pub(super) unknown: f64,
}

impl Integrator<'_> {
    /// The distance of the fold of t(a) that the last three points foresee: where the edge would run away.
    pub(super) fn fold_ahead(&self) -> Option<f64> {
        let [now, one, two] = *self.path_history.nodes().get(..3)? else { return None };
        let (first, second) = (now.radius - one.radius, one.radius - two.radius);
        if first * second <= 0.0 {
            return None;
        }
        let (fast, slow) = (-one.time / first.abs(), (one.time - two.time) / second.abs());
        let bend = 2.0 * (fast - slow) / (first.abs() + second.abs());
        let slope = fast + 0.5 * bend * first.abs();
        // Only a fold that is near counts; further away the path will show itself.
        (bend < 0.0 && slope > 0.0).then(|| -slope / bend).filter(|distance| *distance < 4.0 * first.abs().max(self.reach))
    }

    /// Near a fold dt goes with the square of the way left: the root of the residual is what the place is known to.
    pub(super) fn is_near_fold(&self) -> bool {
        self.fold_ahead().is_some_and(|distance| distance < NEAR_FOLD * self.length)
    }

    /// Whether the edge, moved at once a little further on, would run on by itself; none where there is no place to look at.
    pub(super) fn is_unstable(&mut self, imposed: &Imposed<'_>, way: f64) -> Result<Option<bool>, Refusal> {
        Ok(self.drive_at(imposed, way.max(SMALLEST_BEYOND * self.length))?.map(|drive| drive >= 0.0))
    }

    /// Whether a fold ahead is taken as reached at the distance that it seems to have: what is left of the way is continued by a parabola, which errs by its square.
    pub(super) fn is_at_fold(&mut self, imposed: &Imposed<'_>, distance: f64) -> Result<bool, Refusal> {
        if distance >= AT_FOLD * self.length {
            return Ok(false);
        }
        // Where the edge condition is so flat that its rounding is all that further steps would tell, it is no use to go on.
        Ok(distance < self.nearest_to_fold() || self.drive_at(imposed, distance)?.is_some_and(|drive| drive.abs() < FLAT))
    }

    /// The fold that the path foresees at a distance, as the edge condition tells it: at once, g goes as y·(2d − y) with the way y to a fold at d. Its values at the
    /// foreseen distance and at twice that need no difference of times, whose last digits are gone.
    pub(super) fn fold_by_edge_condition(&mut self, imposed: &Imposed<'_>, distance: f64) -> Result<Fold, Refusal> {
        let (Some(near), Some(far)) = (self.drive_at(imposed, distance)?, self.drive_at(imposed, 2.0 * distance)?) else {
            return Ok(Fold { distance, unknown: FORESEEN });
        };
        // Of α·y − β·y² both values tell α·d = 2g(d) − g(2d)/2 and β·d² = g(d) − g(2d)/2: the fold is at α/(2β).
        let change = (2.0 * near - 0.5 * far) / (2.0 * near - far) - 1.0;
        if change.abs() < FORESEEN {
            let unknown = NOISE_OF_EDGE / near.abs() + OF_THE_CHANGE * change.abs();
            Ok(Fold { distance: (1.0 + change) * distance, unknown: unknown.min(1.0) })
        } else {
            // Neither is to be believed; of a NaN nothing is known.
            Ok(Fold { distance, unknown: change.abs().min(1.0) })
        }
    }

    /// The distance from a fold that is none: less tells nothing, or places have no more digits.
    pub(super) fn nearest_to_fold(&self) -> f64 {
        let resolved = PLACES * NARROWEST * self.contact.radius();
        (NEAREST * self.length).max(resolved.min(AT_FOLD * self.length))
    }

    /// g a way further on as the edge goes, moved there at once, positive where it would run on.
    fn drive_at(&mut self, imposed: &Imposed<'_>, way: f64) -> Result<Option<f64>, Refusal> {
        let [now, before] = *self.path_history.nodes().get(..2).unwrap_or(&[]) else { return Ok(None) };
        let way = way * (now.radius - before.radius).signum();
        if now.radius + way <= self.smallest() || now.radius + way >= self.contact.profile().rim() {
            return Ok(None);
        }
        let (_, value) = self.edge.jumped(&self.contact, now.radius + way, imposed)?;
        Ok(Some(if way < 0.0 { value } else { -value }))
    }
}
