//! Bounds of pull-off, snap-in, separation and toughness of a sliding wave.
//!
//! The other route finds pull-off as the least load of contacts of held half-widths, without a branch and without fold equations.

use super::super::draw::Draw;
use super::tally::{Assessed, Compared, Truth};
use super::{ANOTHER_ROUTE, SEED};
use viscotack::estimate::Estimate;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{BranchProblem, Strength, strength};
use viscotack::sliding::steady::{Indenter, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

/// Accuracies asked for, in turn.
const ACCURACIES: [f64; 2] = [1e-3, 1e-5];
/// The truth.
const TIGHTER: f64 = 1e-8;
/// Half-widths beside that of pull-off, over it.
const STEP: f64 = 0.004;
/// What five half-widths know of the least load, over one: the sixth difference of the load, h⁴ of its own size, and the bounds of the five.
const BY_WIDTHS: f64 = 3e-8;

fn drawn(draw: &mut Draw) -> Result<(PlaneMaterial, BranchProblem<'static>), Refusal> {
    let terms = 1 + draw.below(3);
    let (beta, longest, decades) = (draw.log_between(1.5, 30.0), draw.log_between(1e-3, 1e3), draw.between(0.3, 3.0));
    let relaxed = draw.log_between(1e3, 1e9);
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let rate = draw.log_between(1e-3, 1e2) / longest;
    let adhesion = WaveAdhesion::even(draw.log_between(5e-4, 0.01), draw.log_between(5e-4, 0.01));
    Ok((material, BranchProblem::loads(rate, adhesion, TIGHTER)))
}

fn listed(strength: &Strength) -> Vec<(&'static str, Option<Estimate>)> {
    vec![
        ("pull-off", strength.pull_off.as_ref().map(|fold| fold.value)),
        ("snap-in", strength.snap_in.as_ref().map(|fold| fold.value)),
        ("separation", strength.separation.as_ref().map(|fold| fold.value)),
        ("half-width without load", strength.zero_load.as_ref().map(|values| values.half_width)),
        ("toughness", strength.toughness.as_ref().ok().map(|toughness| toughness.value)),
    ]
}

/// A scene, assessed.
#[must_use]
pub fn assessed(scene: u64) -> Assessed {
    let accuracy = ACCURACIES[(scene / ANOTHER_ROUTE + scene) as usize % ACCURACIES.len()];
    let another = scene.is_multiple_of(ANOTHER_ROUTE);
    let truth = if another { Truth::Another } else { Truth::Tighter };
    let mut assessed = Assessed { scene, accuracy, described: String::new(), compared: Vec::new(), truth, trouble: None };
    let result = drawn(&mut Draw::of(SEED ^ 2, scene)).and_then(|(material, problem)| {
        assessed.described = format!("{material:?} {problem:?}");
        let found = strength(&material, &BranchProblem { accuracy, ..problem })?;
        if another {
            return Ok(by_widths(&material, &problem, &found).into_iter().collect());
        }
        let exact = strength(&material, &problem)?;
        let mut compared = Vec::new();
        for ((quantity, found), (_, truth)) in listed(&found).into_iter().zip(listed(&exact)) {
            match (found, truth) {
                (Some(found), Some(truth)) => compared.push(Compared { quantity, found, truth, scale: 1.0, floor: 0.0 }),
                (None, None) => {}
                _ => {
                    let detail = format!("it is there at one accuracy and not at the other ({accuracy:e})");
                    return Err(Refusal::NotConverged { what: quantity, detail });
                }
            }
        }
        Ok(compared)
    });
    match result {
        Ok(compared) => assessed.compared = compared,
        Err(refusal) => assessed.trouble = Some(refusal.to_string()),
    }
    assessed
}

/// Pull-off as the least load of five half-widths.
fn by_widths(material: &PlaneMaterial, problem: &BranchProblem<'_>, found: &Strength) -> Option<Compared> {
    let fold = found.pull_off.as_ref()?;
    let least = least_load(material, problem, fold.contact.half_width.value, STEP)?;
    Some(Compared { quantity: "pull-off", found: fold.value, truth: Estimate::new(least, BY_WIDTHS), scale: 1.0, floor: 0.0 })
}

/// The least load of contacts of five held half-widths, `step` over the middle one apart; none if it is not among them.
pub(in crate::studies) fn least_load(material: &PlaneMaterial, problem: &BranchProblem<'_>, middle: f64, step: f64) -> Option<f64> {
    let load = |part: f64| -> Option<f64> {
        let asked = SlidingProblem {
            rate: problem.rate,
            indenter: Indenter::Wave,
            adhesion: Some(problem.adhesion),
            work_by_speed: None,
            control: SlidingControl::HalfWidth(middle * (1.0 + part * step)),
            accuracy: 1e-10,
        };
        match steady_sliding(material, &asked) {
            Ok(SlidingOutcome::Partial(contact)) => Some(contact.values.mean_pressure.value),
            _ => None,
        }
    };
    let loads = [load(-2.0)?, load(-1.0)?, load(0.0)?, load(1.0)?, load(2.0)?];
    // The polynomial through all five, and its least value by Newton's method from the middle.
    let [a, b, c, d, e] = loads;
    let slope = (a - 8.0 * b + 8.0 * d - e) / 12.0;
    let second = (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / 12.0;
    let third = (-a + 2.0 * b - 2.0 * d + e) / 2.0;
    let fourth = a - 4.0 * b + 6.0 * c - 4.0 * d + e;
    let mut x = 0.0;
    for _ in 0..6 {
        x -= (slope + x * (second + x * (0.5 * third + x * fourth / 6.0))) / (second + x * (third + 0.5 * x * fourth));
    }
    let least = c + x * (slope + x * (0.5 * second + x * (third / 6.0 + x * fourth / 24.0)));
    (x.abs() < 2.0).then_some(least)
}

/// Evaluations of both edge conditions at 1e-3 and at 1e-9.
#[must_use]
pub fn work(scene: u64) -> Option<[u64; 2]> {
    let (material, problem) = drawn(&mut Draw::of(SEED ^ 2, scene)).ok()?;
    let counted = |accuracy: f64| Some(strength(&material, &BranchProblem { accuracy, ..problem }).ok()?.work.closure_evaluations);
    Some([counted(1e-3)?, counted(1e-9)?])
}
