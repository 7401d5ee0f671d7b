//! Where there is no contact of what is held: full contact or a refusal, with the limit at this speed.
//!
//! | held | beyond | answer and limit |
//! |---|---|---|
//! | load | the largest of a stable contact | full contact of a wave; snap-in |
//! | load, penetration | the smallest of a stable contact | refused; pull-off, separation |
//! | half-width | the narrowest, the widest contact | refused; that half-width |
//! | anything | the longest process zone | refused; that zone over the one asked for |
//!
//! A limit where the curve turns is solved as a fold of the branch of loads. One where an edge would be pressed or the faces would meet is closed in on between a
//! contact that can exist and one that cannot.

use super::full::full_contact;
use super::prepared::Prepared;
use super::problem::SlidingProblem;
use super::solution::{SlidingOutcome, SlidingWork};
use super::solve::ReachedBy;
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::branch::{BranchEnd, BranchPath, BranchProblem, FoldQuantity, Impossible, Turn, trace, turn_near};
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::equilibrium::{Crossing, End, EquilibriumCurve, HeldQuantity, Place, SegmentEnd, StableSegment, WhyNot};

/// Folds are located this well, or to the accuracy of the problem if that is less.
const FOLD_ACCURACY: f64 = 1e-9;
/// Zones so much shorter are those of nearly sharp edges.
const SHORT: f64 = 1e-3;

/// What forbids a contact.
const fn forbids(why: WhyNot) -> &'static str {
    match why {
        WhyNot::TrailingPressed => "the trailing edge would be pressed",
        WhyNot::LeadingPressed => "the leading edge would be pressed",
        WhyNot::FacesMeet => "the faces would meet outside the contact",
    }
}

/// The names of the limits of a quantity: largest and smallest of a stable contact, and where contacts cannot exist any more.
struct Names {
    highest: &'static str,
    lowest: &'static str,
    largest_possible: &'static str,
    smallest_possible: &'static str,
    /// Where contacts end that others follow beyond.
    hole: &'static str,
}

const LOADS: Names = Names {
    highest: "mean pressure of snap-in at this speed",
    lowest: "mean pressure of pull-off at this speed",
    largest_possible: "largest mean pressure of a contact at this speed",
    smallest_possible: "smallest mean pressure of a contact at this speed",
    hole: "mean pressure of the last contact before this one",
};
const DEPTHS: Names = Names {
    highest: "largest penetration of a partial contact at this speed",
    lowest: "penetration of separation at this speed",
    largest_possible: "largest penetration of a contact at this speed",
    smallest_possible: "smallest penetration of a contact at this speed",
    hole: "penetration of the last contact before this one",
};

/// A limit: its name, its value and what forbids more.
struct Limit {
    name: &'static str,
    value: Estimate,
    why: Option<WhyNot>,
}

/// What there is instead of a stable contact of a load or penetration; none if that is not known.
pub(super) fn beyond(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    curve: &EquilibriumCurve,
    (quantity, value): (HeldQuantity, f64),
    (refused, reached_by): (&[Crossing], ReachedBy),
    work: SlidingWork,
) -> Option<Result<SlidingOutcome, Refusal>> {
    let names = if quantity == HeldQuantity::MeanPressure { LOADS } else { DEPTHS };
    let known = curve.stable_segments(quantity);
    let wave = problem.indenter == Indenter::Wave;
    let full = |limit: &Limit| full_contact(material, problem, limit.name, limit.value.value, work);
    let pulls = |limit: &Limit| {
        let what = if quantity == HeldQuantity::MeanPressure { "no contact carries this load" } else { "no contact has this penetration" };
        let reason = match limit.why {
            Some(why) => format!("{what}: {}", forbids(why)),
            None if quantity == HeldQuantity::MeanPressure => "the load pulls harder than a contact at this speed can hold".into(),
            None => "the contact is lost before this penetration".into(),
        };
        Err(Refusal::NoSuchState { reason, limit_name: limit.name, limit: limit.value.value })
    };
    // A stable contact that cannot exist: the edge of those that can, on its own segment.
    for crossing in refused {
        let Some(segment) = known.iter().find(|segment| segment.lowest.value <= value && value <= segment.highest.value) else {
            continue;
        };
        let here = (crossing.place, crossing.eccentricity);
        let of = |&(_, place): &(f64, Place)| place;
        let above = segment.along.iter().filter(|(other, _)| *other > value).map(of);
        let below = segment.along.iter().rev().filter(|(other, _)| *other < value).map(of);
        let limit =
            |(limit, why): (f64, WhyNot), name| Limit { name, value: Estimate::new(as_named(quantity, limit), 1e-9), why: Some(why) };
        let found = curve.end_of_possible(quantity, std::iter::once(here).chain(above)).map(|found| limit(found, names.smallest_possible));
        let found = found.or_else(|| {
            curve.end_of_possible(quantity, std::iter::once(here).chain(below)).map(|found| limit(found, names.largest_possible))
        });
        if let Some(limit) = found {
            return Some(pulls(&limit));
        }
    }
    let limit_of = |end: &SegmentEnd, segment: Option<&StableSegment>, upper: bool| -> Limit {
        let (turn_name, last_name) = if upper { (names.highest, names.largest_possible) } else { (names.lowest, names.smallest_possible) };
        let rough = Limit { name: turn_name, value: Estimate::new(as_named(quantity, end.value), 1e-6), why: None };
        // The faces may meet before the end.
        let places = segment.map(|segment| segment.along.iter().map(|&(_, place)| place));
        let found = places
            .and_then(|places| if upper { curve.end_of_possible(quantity, places.rev()) } else { curve.end_of_possible(quantity, places) });
        if let Some((limit, why)) = found {
            return Limit { name: last_name, value: Estimate::new(as_named(quantity, limit), 1e-9), why: Some(why) };
        }
        match end.end {
            End::Turn => {
                let Some(adhesion) = problem.adhesion else { return rough };
                let loads = BranchProblem {
                    indenter: problem.indenter,
                    work_by_speed: problem.work_by_speed,
                    ..BranchProblem::loads(problem.rate, adhesion, problem.accuracy.max(FOLD_ACCURACY))
                };
                let turning = if quantity == HeldQuantity::MeanPressure { FoldQuantity::MeanPressure } else { FoldQuantity::Penetration };
                let start = [end.place, end.eccentricity, end.mean_pressure];
                match turn_near(material, &loads, turning, start) {
                    Ok(value) if (value.value - rough.value.value).abs() < 1e-3 * (1.0 + value.value.abs()) => Limit { value, ..rough },
                    _ => rough,
                }
            }
            End::Stability => rough,
            End::Last => match curve.beyond_the_end(quantity, end) {
                Some((limit, why)) => Limit { name: last_name, value: Estimate::new(as_named(quantity, limit), 1e-9), why: Some(why) },
                None => Limit { name: last_name, ..rough },
            },
        }
    };
    let segments: Vec<&StableSegment> = known.iter().filter(|segment| curve.has_possible(segment)).collect();
    let highest = segments.iter().max_by(|first, second| first.highest.value.total_cmp(&second.highest.value));
    let lowest = segments.iter().min_by(|first, second| first.lowest.value.total_cmp(&second.lowest.value));
    let (Some(highest), Some(lowest)) = (highest, lowest) else {
        // Nothing is stable: a wave that touches closes by itself.
        let largest = curve.largest(quantity).filter(|_| wave)?;
        let name = "largest mean pressure of any partial contact at this speed, none of which is stable";
        // A narrower contact pulls less: at the narrow end of the curve the loads go on to zero.
        let limit = if curve.is_narrowest(&largest) && largest.value < 0.0 {
            Limit { name, value: Estimate::exact(0.0), why: None }
        } else {
            Limit { name, ..limit_of(&largest, None, true) }
        };
        return (quantity == HeldQuantity::MeanPressure).then(|| full(&limit));
    };
    if value >= highest.highest.value {
        let limit = limit_of(&highest.highest, Some(highest), true);
        return Some(if wave && limit.why.is_none() { full(&limit) } else { pulls(&limit) });
    }
    if value <= lowest.lowest.value {
        return Some(pulls(&limit_of(&lowest.lowest, Some(lowest), false)));
    }
    // Between two segments: what is raised past the lower one, or lowered past the upper one, finds no stable contact.
    let limit = match reached_by {
        ReachedBy::Loading => {
            let below = segments.iter().filter(|segment| segment.highest.value <= value);
            let below = below.max_by(|first, second| first.highest.value.total_cmp(&second.highest.value))?;
            limit_of(&below.highest, Some(below), true)
        }
        ReachedBy::Unloading => {
            let above = segments.iter().filter(|segment| segment.lowest.value >= value);
            let above = above.min_by(|first, second| first.lowest.value.total_cmp(&second.lowest.value))?;
            limit_of(&above.lowest, Some(above), false)
        }
    };
    let limit = Limit { name: if limit.why.is_some() { names.hole } else { limit.name }, ..limit };
    Some(if wave && limit.why.is_none() && reached_by == ReachedBy::Loading { full(&limit) } else { pulls(&limit) })
}

/// A held value as it is named: Δ for Δ − 1.
fn as_named(quantity: HeldQuantity, value: f64) -> f64 {
    if quantity == HeldQuantity::Penetration { 1.0 + value } else { value }
}

/// The narrowest or widest half-width of a contact, if the one asked for is beyond it.
pub(super) fn beyond_a_width(curve: &EquilibriumCurve, half_width: f64) -> Option<Refusal> {
    let (limit, wider, why) = curve.nearest_width(half_width)?;
    Some(Refusal::NoSuchState {
        reason: format!("no contact has this half-width: {}", why.map_or("both edges are not pulled", forbids)),
        limit_name: if wider { "narrowest half-width of a contact at this speed" } else { "widest half-width of a contact at this speed" },
        limit,
    })
}

/// The longest process zones with which there is a contact, if those asked for are longer.
pub(super) fn beyond_a_zone(material: &PlaneMaterial, problem: &SlidingProblem<'_>, size: f64) -> Option<Refusal> {
    let adhesion = problem.adhesion?;
    let zone = adhesion.trailing_zone.max(adhesion.leading_zone);
    let half_widths = match problem.indenter {
        Indenter::Wave => [1e-3 * zone, std::f64::consts::PI * (1.0 - 1e-6)],
        Indenter::Parabola => [1e-3 * zone.max(1e-2 * size), 1e2 * (size + zone)],
    };
    let zones = BranchProblem {
        path: BranchPath::Zones(problem.control),
        indenter: problem.indenter,
        work_by_speed: problem.work_by_speed,
        parameters: [1.0, 1.0 / SHORT],
        half_widths,
        ..BranchProblem::loads(problem.rate, adhesion.with_zones_times(SHORT), problem.accuracy.max(FOLD_ACCURACY))
    };
    let branch = trace(material, &zones).ok()?;
    let longest = branch.outline_parameters(&zones).into_iter().fold(0.0, f64::max);
    let why = match branch.ends {
        BranchEnd::Impossible { parameter, witness, .. } if parameter >= longest * (1.0 - 1e-6) => forbids(match witness {
            Impossible::TrailingPressed(_) => WhyNot::TrailingPressed,
            Impossible::LeadingPressed(_) => WhyNot::LeadingPressed,
            Impossible::FacesMeet(_) => WhyNot::FacesMeet,
        }),
        _ if branch.folds_of(FoldQuantity::LogZone).any(|fold| fold.turn == Turn::Maximum) => "their branch turns back",
        _ => return None,
    };
    let limit = longest * SHORT;
    (limit < 1.0).then(|| Refusal::NoSuchState {
        reason: format!("the process zones are too long for the works of adhesion: with longer ones {why}"),
        limit_name: "longest process zones over those asked for",
        limit,
    })
}

/// The load at which a wave without adhesion is in full contact: that of full contact whose pressure vanishes somewhere, |E*(ω)| at ω = kv.
pub(super) fn closing_pressure(material: &PlaneMaterial, prepared: &Prepared) -> Result<f64, Refusal> {
    if prepared.is_elastic() {
        return Ok(1.0);
    }
    let modulus = material.complex_modulus(prepared.rate())?;
    Ok(modulus.storage.hypot(modulus.loss) / material.solid_modulus("full contact in units of E0")?)
}

/// The half-width around which contacts of a cylinder lie: of an elastic one a³ = 2Γ at pull-off, a² = 4p̄ without adhesion.
pub(super) fn size_of(problem: &SlidingProblem<'_>) -> f64 {
    match problem.control {
        SlidingControl::HalfWidth(half_width) => half_width,
        SlidingControl::MeanPressure(held) | SlidingControl::Penetration(held) => {
            problem.adhesion.map_or(0.0, |adhesion| (2.0 * adhesion.larger_work()).cbrt()) + 2.0 * held.abs().sqrt()
        }
    }
}
