//! Source: thesis Secs 3.2 and 3.3, solved by `sliding::steady`.
//!
//! Goal: every error bound bounds the true error and is no more than a hundred times wider, for requests from 1e-3 to 1e-10, and the request or the floor is reached.
//!
//! Parameters: 240 random problems: n = 1, 2, 6, 12 terms; β from 1 to 1000; ζ of the slowest term from 1e-6 to 1e4 (faster ones over up to eight
//! decades); Γ from 0 to 0.05; process zones 1e-4 to 0.03 (edges not equal); mean pressure, penetration and half-width prescribed; wave and parabola.
//!
//! Oracle: the same problem with 1e-10 asked for, whose integrals take twice the nodes at every place; that the finest level is right is shown by other tests
//! (Fourier symbol, rivals, references).
//!
//! Tolerance: none for bounds. The floor may not be above 2e-10 anywhere; 1e-10 is asked for. States that do not exist (past a fold, a pull that nothing
//! holds, full contact) carry their limit; no problem may be left unconverged.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use rayon::prelude::*;
use support::random::Uniform;
use viscotack::material::CreepTerm;
use viscotack::sliding::steady::{Indenter, PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};
use viscotack::{Estimate, PlaneMaterial, Refusal};

fn draw(random: &mut Uniform) -> (PlaneMaterial, SlidingProblem<'static>, String) {
    let count = [1, 2, 6, 12][random.between(0.0, 4.0) as usize];
    let beta = if random.between(0.0, 1.0) < 0.05 { 1.0 } else { random.log_between(1.1, 1000.0) };
    let relaxed = 1.3e6;
    let decades = random.between(0.0, 8.0);
    let terms: Vec<CreepTerm> = (0..if beta > 1.0 { count } else { 0 })
        .map(|index| CreepTerm {
            compliance: (1.0 - 1.0 / beta) / relaxed / f64::from(count),
            retardation_time: 0.37 * 10f64.powf(-decades * f64::from(index) / f64::from(count)),
        })
        .collect();
    let material = PlaneMaterial::from_creep(relaxed * beta, &terms, None).unwrap();
    let indenter = if random.between(0.0, 1.0) < 0.75 { Indenter::Wave } else { Indenter::Parabola };
    let work = if random.between(0.0, 1.0) < 0.2 { 0.0 } else { random.log_between(1e-4, 0.05) };
    let adhesion = (work > 0.0).then(|| WaveAdhesion {
        trailing_work: work,
        leading_work: work,
        trailing_zone: random.log_between(1e-4, 0.03),
        leading_zone: random.log_between(1e-4, 0.03),
    });
    let kind = random.between(0.0, 3.0) as u32;
    let control = match kind {
        0 => SlidingControl::HalfWidth(random.between(0.3, 2.5)),
        1 if indenter == Indenter::Wave => SlidingControl::Penetration(random.between(0.1, 0.7)),
        _ => SlidingControl::MeanPressure(random.between(if work > 0.0 { -0.02 } else { 0.02 }, 0.4)),
    };
    let rate = random.log_between(1e-6, 1e4) / 0.37;
    let text = format!("n = {count} β = {beta:.1} ζ = {:.1e} Γ = {work:.4} {indenter:?} {control:?} {adhesion:?}", rate * 0.37);
    (material, SlidingProblem { rate, indenter, adhesion, work_by_speed: None, control, accuracy: 1e-10 }, text)
}

fn listed(values: &PartialValues) -> Vec<(&'static str, Estimate)> {
    let mut list = vec![
        ("a", values.half_width),
        ("e", values.eccentricity),
        ("−l₁", values.trailing_edge),
        ("l₂", values.leading_edge),
        ("Δ", values.penetration),
        ("p̄", values.mean_pressure),
        ("friction", values.friction_stress),
        ("U", values.interface_work),
    ];
    list.extend(values.friction_coefficient.map(|value| ("μ", value)));
    if let Some(adhesion) = values.adhesion {
        list.push(("G₁", adhesion.trailing_release));
        list.push(("G₂", adhesion.leading_release));
        list.push(("μ_a", adhesion.adhesive_friction_stress));
    }
    list
}

#[test]
fn bounds_cover_the_error_and_are_not_idle() {
    let mut random = Uniform::new();
    let cases: Vec<_> = (0..240).map(|_| draw(&mut random)).collect();
    let results: Vec<_> = cases
        .par_iter()
        .map(|(material, problem, text)| {
            let best = steady_sliding(material, problem);
            let mut lines = Vec::new();
            let mut ratios = Vec::new();
            let mut kind = "partial";
            let mut floor = 0.0;
            match &best {
                Ok(SlidingOutcome::Partial(best)) => {
                    floor = best.certificate.accuracy;
                    for accuracy in [1e-3, 1e-5, 1e-7, 1e-8] {
                        let found = steady_sliding(material, &SlidingProblem { accuracy, ..*problem });
                        let Ok(SlidingOutcome::Partial(found)) = found else {
                            lines.push(format!("LOST at {accuracy:e}: {text}"));
                            continue;
                        };
                        for ((name, rough), (_, exact)) in listed(&found.values).into_iter().zip(listed(&best.values)) {
                            let error = (rough.value - exact.value).abs();
                            if error > rough.error + exact.error {
                                lines.push(format!(
                                    "UNBOUND {name} at {accuracy:e}: {error:.1e} > {:.1e} + {:.1e}: {text}",
                                    rough.error, exact.error
                                ));
                            }
                            ratios.push((rough.error, error, exact.error));
                        }
                    }
                }
                Ok(SlidingOutcome::Full(full)) => {
                    kind = "full";
                    assert!(full.limit.is_finite() && !full.limit_name.is_empty(), "{full:?}");
                }
                Err(Refusal::NoSuchState { limit, .. }) => {
                    kind = "none";
                    assert!(limit.is_finite(), "{text}");
                }
                Err(refusal) => {
                    kind = "failed";
                    lines.push(format!("FAILED {refusal}: {text}"));
                }
            }
            (kind, lines, ratios, floor)
        })
        .collect();
    let (mut ratios, mut known): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut counts = std::collections::BTreeMap::new();
    let mut floors = Vec::new();
    let mut failures = Vec::new();
    for (kind, lines, pairs, floor) in &results {
        floors.push(*floor);
        *counts.entry(*kind).or_insert(0) += 1;
        failures.extend(lines);
        for &(bar, error, of_truth) in pairs.iter().filter(|(bar, ..)| *bar > 1e-11) {
            ratios.push(bar / error.max(of_truth));
            // Where the error is as small as the bound of the truth, a bound may be a little tighter than that one: no error is known there.
            if error > 2.0 * of_truth {
                known.push(bar / error);
            }
        }
    }
    let quantile = |ratios: &mut Vec<f64>, part: f64| {
        ratios.sort_by(f64::total_cmp);
        ratios[((ratios.len() - 1) as f64 * part) as usize]
    };
    let (least, least_of_all) = (quantile(&mut known, 0.01), quantile(&mut ratios, 0.01));
    let (median, most) = (quantile(&mut ratios, 0.5), quantile(&mut ratios, 0.9));
    floors.sort_by(f64::total_cmp);
    let worst_floor = floors.last().copied().unwrap();
    println!(
        "{counts:?}; bound over error of {} values with bounds above 1e-11: 1 % {least_of_all:.4} ({least:.4} of {} known errors), median {median:.2}, 90 % {most:.2}; \
         worst floor {worst_floor:.1e}",
        ratios.len(),
        known.len()
    );
    assert!(failures.is_empty(), "{failures:#?}");
    assert!(counts["partial"] > 200 && worst_floor < 2e-10, "{counts:?} {worst_floor:e}");
    assert!(least >= 1.0 && median < 3.0 && most < 10.0, "idle bounds");
}
