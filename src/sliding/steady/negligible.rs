//! Adhesion so weak that the pull of an edge is lost among the last digits of the load: the contact without it, with bounds that hold what it would change.
//!
//! What adhesion changes goes with the pull, √Γ. A contact whose works are so much larger that they are felt tells how much that is, and the root of the ratio of the
//! works brings it down to those that were asked for. What belongs to the edges alone, such as their release rates, is not known and left out.

use super::problem::SlidingProblem;
use super::solution::{PartialContact, PartialValues, SlidingOutcome, SlidingWork};
use super::solve::contact_on_the_curve;
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::WaveAdhesion;

/// Largest pull of an edge over the load that is negligible beside a contact with edges of its own, whose bounds are too wide.
const LEAST_NEGLIGIBLE: f64 = 1e-11;
/// The same where no such contact is found. What is stronger has roots with digits of their own: works of 1e-13 and more (pulls of 2e-6) all of 800 tried, works of 1e-14
/// all but 6 of 96.
const NEGLIGIBLE: f64 = 1e-5;
/// Pull over the load of the adhesion that is felt.
const FELT: f64 = 1e-4;
/// Its process zones over the half-width, at most.
const LONGEST_ZONE: f64 = 1e-2;
/// Bound over what the root of the works makes of the change.
const SAFETY: f64 = 3.0;

/// Whether adhesion may be that weak in a wide contact.
pub(super) fn may_be_negligible(material: &PlaneMaterial, adhesion: WaveAdhesion) -> bool {
    (material.glassy_modulus() / material.relaxed_modulus() * adhesion.larger_work()).sqrt() < NEGLIGIBLE
}

/// The contact without an adhesion that is too weak for its edges to be resolved; none if it is not, or if nothing but adhesion holds the contact.
pub(super) fn without_negligible_adhesion(
    found: bool,
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    work: &mut SlidingWork,
) -> Option<SlidingOutcome> {
    without_adhesion_below(if found { LEAST_NEGLIGIBLE } else { NEGLIGIBLE }, material, problem, work)
}

fn without_adhesion_below(
    negligible: f64,
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    work: &mut SlidingWork,
) -> Option<SlidingOutcome> {
    let adhesion = problem.adhesion?;
    let bare = SlidingProblem { adhesion: None, work_by_speed: None, ..*problem };
    let mut found = partial(material, &bare, work)?;
    let half_width = found.values.half_width.value;
    let stiffening = material.glassy_modulus() / material.relaxed_modulus();
    // 2√(βΓ tan(a/2)) of a wave, √(2βΓa) of a parabola: no edge pulls harder at any speed.
    let breadth = match problem.indenter {
        Indenter::Wave => 4.0 * (0.5 * half_width).tan(),
        Indenter::Parabola => 2.0 * half_width,
    };
    let load = found.values.mean_pressure.value.abs() + problem.indenter.half_angle_scale(half_width);
    let pull = (stiffening * breadth).sqrt() * adhesion.larger_work().sqrt();
    if pull.is_nan() || pull > negligible * load {
        return None;
    }
    let part = pull / (FELT * load);
    let felt = felt(adhesion, 1.0 / part, half_width);
    let there = partial(material, &SlidingProblem { adhesion: Some(felt), ..bare }, work)?.values;
    let mut accuracy = found.certificate.accuracy;
    let mut widened = |here: &mut Estimate, there: Estimate| {
        let change = (there.value - here.value).abs() + there.error;
        *here = Estimate::new(here.value, here.error + SAFETY * part * change);
        accuracy = accuracy.max(here.error / here.value.abs().max(1.0));
    };
    let PartialValues {
        half_width,
        eccentricity,
        trailing_edge,
        leading_edge,
        penetration,
        mean_pressure,
        friction_stress,
        friction_coefficient,
        interface_work,
        adhesion: _,
    } = &mut found.values;
    widened(half_width, there.half_width);
    widened(eccentricity, there.eccentricity);
    widened(trailing_edge, there.trailing_edge);
    widened(leading_edge, there.leading_edge);
    widened(penetration, there.penetration);
    widened(mean_pressure, there.mean_pressure);
    widened(friction_stress, there.friction_stress);
    widened(interface_work, there.interface_work);
    if let (Some(here), Some(there)) = (friction_coefficient, there.friction_coefficient) {
        widened(here, there);
    }
    found.certificate.accuracy = accuracy;
    found.work = *work;
    Some(SlidingOutcome::Partial(Box::new(found)))
}

/// Works stronger by the square of a factor, zones by the factor itself, as those of one cohesive stress and one far field would be.
fn felt(adhesion: WaveAdhesion, factor: f64, half_width: f64) -> WaveAdhesion {
    let work = |work: f64| {
        let root = factor * work.sqrt();
        root * root
    };
    let zone = |zone: f64| (factor * zone).clamp(zone.min(LONGEST_ZONE * half_width), LONGEST_ZONE * half_width);
    WaveAdhesion {
        trailing_work: work(adhesion.trailing_work),
        leading_work: work(adhesion.leading_work),
        trailing_zone: zone(adhesion.trailing_zone),
        leading_zone: zone(adhesion.leading_zone),
    }
}

fn partial(material: &PlaneMaterial, problem: &SlidingProblem<'_>, work: &mut SlidingWork) -> Option<PartialContact> {
    contact_on_the_curve(material, problem, work).ok()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, clippy::panic)]
    use super::*;
    use crate::sliding::edge_balance::SlidingControl;
    use crate::sliding::steady::steady_sliding;

    /// Weak adhesion that is still felt: its own roots against what is said without it.
    #[test]
    fn bounds_cover_what_negligible_adhesion_changes() {
        let material = PlaneMaterial::standard_solid(1.0, 30.0, 1.0).expect("a material");
        let mut widest: f64 = 0.0;
        for indenter in [Indenter::Wave, Indenter::Parabola] {
            for control in [SlidingControl::MeanPressure(0.2), SlidingControl::HalfWidth(0.9)] {
                for (rate, work) in [(0.0, 1e-13), (0.3, 1e-13), (10.0, 1e-13)] {
                    let adhesion = Some(WaveAdhesion::even(work, 1e-2 * work.sqrt()));
                    let problem = SlidingProblem { rate, indenter, adhesion, work_by_speed: None, control, accuracy: 1e-9 };
                    let rooted = partial(&material, &problem, &mut SlidingWork::default())
                        .unwrap_or_else(|| panic!("no roots of {problem:?}"))
                        .values;
                    assert!(rooted.adhesion.is_some());
                    let negligible = without_adhesion_below(1e-4, &material, &problem, &mut SlidingWork::default());
                    let Some(SlidingOutcome::Partial(negligible)) = negligible else { panic!("{problem:?}") };
                    assert!(negligible.values.adhesion.is_none());
                    for (one, other) in [
                        (negligible.values.half_width, rooted.half_width),
                        (negligible.values.eccentricity, rooted.eccentricity),
                        (negligible.values.mean_pressure, rooted.mean_pressure),
                        (negligible.values.friction_stress, rooted.friction_stress),
                        (negligible.values.penetration, rooted.penetration),
                        (negligible.values.interface_work, rooted.interface_work),
                    ] {
                        let off = (one.value - other.value).abs();
                        assert!(off <= one.error + other.error, "{problem:?}: {one:?} {other:?}");
                        // Pulls are 5e-6 of the load at most.
                        assert!(one.error <= 2e-5 * one.value.abs().max(1.0), "{one:?}");
                        widest = widest.max(off / one.error.max(1e-300));
                    }
                }
            }
        }
        // The bounds hold something: without what adhesion changes some would miss.
        assert!(widest > 1e-2, "{widest}");
    }

    #[test]
    fn adhesion_that_matters_is_not_negligible() {
        let material = PlaneMaterial::elastic(1.0).expect("a material");
        let adhesion = Some(WaveAdhesion::even(1e-12, 1e-9));
        let control = SlidingControl::HalfWidth(1.0);
        let problem = SlidingProblem { rate: 0.0, indenter: Indenter::Wave, adhesion, work_by_speed: None, control, accuracy: 1e-9 };
        assert!(without_negligible_adhesion(true, &material, &problem, &mut SlidingWork::default()).is_none());
        // Nothing but adhesion holds an unloaded contact.
        let negligible = Some(WaveAdhesion::even(1e-100, 1e-53));
        let unloaded = SlidingProblem { adhesion: negligible, control: SlidingControl::MeanPressure(0.0), ..problem };
        assert!(without_negligible_adhesion(false, &material, &unloaded, &mut SlidingWork::default()).is_none());
        assert!(steady_sliding(&material, &SlidingProblem { adhesion: negligible, ..problem }).is_ok());
    }
}
