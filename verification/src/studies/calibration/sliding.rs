//! Bounds of steady sliding contacts.

use super::super::draw::Draw;
use super::super::known_states::sliding::{KNOWN_TO, known_contact};
use super::tally::{Assessed, Compared, Truth};
use super::{ANOTHER_ROUTE, SEED};
use viscotack::estimate::Estimate;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::steady::{
    Indenter, PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, SlidingWork, WaveAdhesion, steady_sliding,
};

/// Accuracies asked for, in turn.
const ACCURACIES: [f64; 3] = [1e-3, 1e-5, 1e-7];
/// The truth is asked for so much more, but not for more than the floor.
const MORE: f64 = 1e-3;
/// See [`MORE`].
const FLOOR: f64 = 1e-10;
/// Another contact than the known one is shown by a half-width that is further off than this.
const ANOTHER_CONTACT: f64 = 1e-3;

/// A random problem: everything that a user may ask of a wave or a cylinder.
///
/// # Errors
/// Those of making a material.
pub fn drawn(draw: &mut Draw) -> Result<(PlaneMaterial, SlidingProblem<'static>), Refusal> {
    let terms = [1, 2, 6, 12][draw.below(4)];
    let beta = draw.log_between(1.1, 1000.0);
    let (relaxed, longest, decades) = (draw.log_between(1e3, 1e9), draw.log_between(1e-4, 1e4), draw.between(0.3, 8.0));
    let material = if draw.chance(0.05) { PlaneMaterial::elastic(relaxed)? } else { draw.solid(relaxed, beta, longest, terms, decades)? };
    let indenter = if draw.chance(0.75) { Indenter::Wave } else { Indenter::Parabola };
    let (work, zones) = (draw.log_between(1e-4, 0.05), [draw.log_between(1e-4, 0.03), draw.log_between(1e-4, 0.03)]);
    let adhesion = draw.chance(0.8).then_some(WaveAdhesion {
        trailing_work: work,
        leading_work: work,
        trailing_zone: zones[0],
        leading_zone: zones[1],
    });
    let control = match draw.below(3) {
        0 => SlidingControl::HalfWidth(draw.between(0.3, 2.5)),
        1 if indenter == Indenter::Wave => SlidingControl::Penetration(draw.between(0.1, 0.7)),
        _ => SlidingControl::MeanPressure(draw.between(if adhesion.is_some() { -0.02 } else { 0.02 }, 0.4)),
    };
    let rate = draw.log_between(1e-6, 1e4) / longest;
    Ok((material, SlidingProblem { rate, indenter, adhesion, work_by_speed: None, control, accuracy: FLOOR }))
}

/// Every number of a contact with its name.
#[must_use]
pub fn listed(values: &PartialValues) -> Vec<(&'static str, Estimate)> {
    let mut list = vec![
        ("half-width", values.half_width),
        ("eccentricity", values.eccentricity),
        ("trailing edge", values.trailing_edge),
        ("leading edge", values.leading_edge),
        ("penetration", values.penetration),
        ("mean pressure", values.mean_pressure),
        ("friction stress", values.friction_stress),
        ("interface work", values.interface_work),
    ];
    list.extend(values.friction_coefficient.map(|value| ("friction coefficient", value)));
    if let Some(adhesion) = values.adhesion {
        list.push(("release of the trailing edge", adhesion.trailing_release));
        list.push(("release of the leading edge", adhesion.leading_release));
        list.push(("adhesive friction stress", adhesion.adhesive_friction_stress));
    }
    list
}

/// A scene, assessed.
#[must_use]
pub fn assessed(scene: u64) -> Assessed {
    let mut draw = Draw::of(SEED ^ 1, scene);
    let accuracy = ACCURACIES[(scene / ANOTHER_ROUTE + scene) as usize % ACCURACIES.len()];
    let mut assessed = Assessed { scene, accuracy, described: String::new(), compared: Vec::new(), truth: Truth::Tighter, trouble: None };
    if scene.is_multiple_of(ANOTHER_ROUTE) {
        assessed.truth = Truth::Another;
        against_known(&mut draw, &mut assessed);
        return assessed;
    }
    let (material, problem) = match drawn(&mut draw) {
        Ok(drawn) => drawn,
        Err(refusal) => {
            assessed.trouble = Some(refusal.to_string());
            return assessed;
        }
    };
    assessed.described = format!("{material:?} {problem:?}");
    let found = steady_sliding(&material, &SlidingProblem { accuracy, ..problem });
    let exact = steady_sliding(&material, &SlidingProblem { accuracy: (MORE * accuracy).max(FLOOR), ..problem });
    match (found, exact) {
        (Ok(SlidingOutcome::Partial(found)), Ok(SlidingOutcome::Partial(exact))) => {
            let pairs = listed(&found.values).into_iter().zip(listed(&exact.values));
            assessed.compared =
                pairs.map(|((quantity, found), (_, truth))| Compared { quantity, found, truth, scale: 1.0, floor: 0.0 }).collect();
            if found.certificate.accuracy > accuracy {
                assessed.trouble = Some(format!("accuracy not reached: {:.1e}", found.certificate.accuracy));
            }
        }
        (Ok(SlidingOutcome::Full(found)), Ok(SlidingOutcome::Full(exact))) => {
            assessed.compared = vec![Compared {
                quantity: "friction stress",
                found: found.friction_stress,
                truth: exact.friction_stress,
                scale: 1.0,
                floor: 0.0,
            }];
        }
        (Err(Refusal::NoSuchState { .. }), Err(Refusal::NoSuchState { .. })) => {}
        (found, exact) => {
            let word = |outcome: &Result<SlidingOutcome, Refusal>| match outcome {
                Ok(SlidingOutcome::Partial(_)) => "a contact".to_owned(),
                Ok(SlidingOutcome::Full(_)) => "full contact".to_owned(),
                Err(refusal) => refusal.to_string(),
            };
            assessed.trouble = Some(format!("{} at {accuracy:e}, but {} for the truth", word(&found), word(&exact)));
        }
    }
    assessed
}

fn against_known(draw: &mut Draw, assessed: &mut Assessed) {
    let known = match known_contact(draw) {
        Ok(known) => known,
        Err(refusal) => {
            assessed.trouble = Some(refusal.to_string());
            return;
        }
    };
    assessed.described = known.described();
    match steady_sliding(&known.material, &known.problem(assessed.accuracy)) {
        Ok(SlidingOutcome::Partial(found)) => {
            let values = listed(&found.values);
            let at = |name: &str| values.iter().find(|(quantity, _)| *quantity == name).map(|(_, estimate)| *estimate);
            assessed.compared = known
                .values()
                .into_iter()
                .filter_map(|(quantity, value)| {
                    let truth = Estimate::new(value, KNOWN_TO * value.abs().max(1.0));
                    Some(Compared { quantity, found: at(quantity)?, truth, scale: 1.0, floor: 0.0 })
                })
                .collect();
            let (a, e, p) = (found.values.half_width.value, found.values.eccentricity.value, found.values.mean_pressure.value);
            let is_another = (a - known.half_width).abs() > ANOTHER_CONTACT || (e - known.eccentricity).abs() > ANOTHER_CONTACT;
            // A load may have more than one contact: another one, confirmed by the same route, is no miss.
            if is_another && known.defect_at(a, e, p).is_some_and(|defect| defect < 30.0 * assessed.accuracy.max(1e-6)) {
                assessed.compared.clear();
            }
        }
        Ok(SlidingOutcome::Full(full)) => assessed.trouble = Some(format!("full contact ({} {:e})", full.limit_name, full.limit)),
        Err(refusal) => assessed.trouble = Some(refusal.to_string()),
    }
}

/// Contacts solved at 1e-3 and at 1e-9.
#[must_use]
pub fn work(scene: u64) -> Option<[u64; 2]> {
    let (material, problem) = drawn(&mut Draw::of(SEED ^ 1, scene)).ok()?;
    let counted = |accuracy: f64| match steady_sliding(&material, &SlidingProblem { accuracy, ..problem }) {
        Ok(SlidingOutcome::Partial(contact)) => Some(contact.work),
        _ => None,
    };
    let of = |work: SlidingWork| work.contacts;
    Some([of(counted(1e-3)?), of(counted(1e-9)?)])
}
