//! Source: issue "Sliding branches", part 5: users know the process zone to a factor of three at best; thesis Secs 3.4, 3.7 and 3.8.
//!
//! Goal: every sensitivity of a contact and of what it carries is the derivative of the solution itself, by an independent way each.
//!
//! Parameters: one and three retardation times with moduli that are no units; all three controls; even and uneven works; a wave and a cylinder; an elastic solid.
//!
//! Oracle: central differences of whole solutions with Richardson's extrapolation, made in other numbers than those differentiated (all times by the rate, E0 by
//! the material's modulus at a load in pascals, β by a material built anew); the scaling relations of dimensional analysis; Johnson's pull-off in closed form.
//!
//! Tolerance: the bound plus 1e-9 (strengths: 3e-9) of the extrapolated differences, which are made of solutions good to 1e-11 with steps of 1 to 4 %; relations of one
//! set to its bounds.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use viscotack::material::CreepTerm;
use viscotack::sliding::branch::{BranchProblem, Strength, strength};
use viscotack::sliding::sensitivity::{Parameter, Sensitivity, state_sensitivities, strength_sensitivities};
use viscotack::sliding::steady::{
    Indenter, PartialContact, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding, steady_sliding_near,
};
use viscotack::{Estimate, PlaneMaterial};

const RELAXED: f64 = 0.7e6;

/// A solid of given β with compliances in a fixed ratio; times in units of `time`.
fn solid(relaxed: f64, beta: f64, time: f64, shares: &[(f64, f64)]) -> PlaneMaterial {
    let gained = (1.0 - 1.0 / beta) / relaxed;
    let sum: f64 = shares.iter().map(|share| share.0).sum();
    let terms: Vec<CreepTerm> =
        shares.iter().map(|&(share, at)| CreepTerm { compliance: gained * share / sum, retardation_time: at * time }).collect();
    PlaneMaterial::from_creep(relaxed * beta, &terms, None).unwrap()
}

const ONE: [(f64, f64); 1] = [(1.0, 1.0)];
const THREE: [(f64, f64); 3] = [(0.5, 3.0), (0.3, 0.4), (0.2, 0.01)];

/// All that a solution depends on; pressures in units of a reference modulus.
#[derive(Clone, Copy)]
struct Inputs {
    zone: f64,
    work: f64,
    relaxed: f64,
    beta: f64,
    time: f64,
}

const BASE: Inputs = Inputs { zone: 1.0, work: 1.0, relaxed: 1.0, beta: 1.0, time: 1.0 };

fn varied(parameter: Parameter, logarithm: f64) -> Inputs {
    let factor = logarithm.exp();
    match parameter {
        Parameter::ProcessZone => Inputs { zone: factor, ..BASE },
        Parameter::WorkOfAdhesion => Inputs { work: factor, ..BASE },
        Parameter::RelaxedModulus => Inputs { relaxed: factor, ..BASE },
        Parameter::StiffeningRatio => Inputs { beta: factor, ..BASE },
        Parameter::Time => Inputs { time: factor, ..BASE },
    }
}

fn extrapolated(value: impl Fn(f64) -> f64) -> f64 {
    let slope = |step: f64| (value(step) - value(-step)) / (2.0 * step);
    let [coarse, middle, fine] = [0.04, 0.02, 0.01].map(slope);
    let (first, second) = ((4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0);
    (16.0 * second - first) / 15.0
}

struct Case {
    name: &'static str,
    beta: f64,
    shares: &'static [(f64, f64)],
    indenter: Indenter,
    rate: f64,
    adhesion: WaveAdhesion,
    control: SlidingControl,
}

impl Case {
    fn material(&self, inputs: Inputs) -> PlaneMaterial {
        // The modulus is E0 in another unit; what the contact sees of it is in the works and the load.
        solid(RELAXED * inputs.relaxed, self.beta * inputs.beta, inputs.time, self.shares)
    }

    fn problem(&self, inputs: Inputs) -> SlidingProblem<'static> {
        let adhesion = self.adhesion.with_works_times([inputs.work / inputs.relaxed; 2]).with_zones_times(inputs.zone);
        let control = match self.control {
            SlidingControl::MeanPressure(pressure) => SlidingControl::MeanPressure(pressure / inputs.relaxed),
            other => other,
        };
        SlidingProblem { rate: self.rate, indenter: self.indenter, adhesion: Some(adhesion), work_by_speed: None, control, accuracy: 1e-12 }
    }

    fn solved(&self) -> PartialContact {
        match steady_sliding(&self.material(BASE), &self.problem(BASE)).unwrap() {
            SlidingOutcome::Partial(contact) => *contact,
            SlidingOutcome::Full(_) => panic!("{}: full contact", self.name),
        }
    }
}

fn cases() -> Vec<Case> {
    let even = WaveAdhesion { trailing_zone: 4e-3, ..WaveAdhesion::even(0.004, 8e-3) };
    let uneven = WaveAdhesion { leading_work: 0.002, ..even };
    let (wave, cylinder) = (Indenter::Wave, Indenter::Parabola);
    let load = SlidingControl::MeanPressure;
    vec![
        Case { name: "load", beta: 10.0, shares: &ONE, indenter: wave, rate: 0.05, adhesion: even, control: load(0.06) },
        Case { name: "pull", beta: 10.0, shares: &ONE, indenter: wave, rate: 0.05, adhesion: even, control: load(-0.02) },
        Case { name: "three times, uneven", beta: 30.0, shares: &THREE, indenter: wave, rate: 0.3, adhesion: uneven, control: load(0.2) },
        Case {
            name: "penetration",
            beta: 10.0,
            shares: &ONE,
            indenter: wave,
            rate: 0.4,
            adhesion: even,
            control: SlidingControl::Penetration(0.3),
        },
        Case {
            name: "half-width",
            beta: 20.0,
            shares: &THREE,
            indenter: wave,
            rate: 1.5,
            adhesion: uneven,
            control: SlidingControl::HalfWidth(0.8),
        },
        Case { name: "cylinder", beta: 10.0, shares: &ONE, indenter: cylinder, rate: 0.1, adhesion: even, control: load(0.05) },
    ]
}

fn outputs(contact: &PartialContact, relaxed: f64) -> [f64; 4] {
    let values = &contact.values;
    // In a unit of pressure that does not change.
    [values.half_width.value, values.mean_pressure.value * relaxed, values.penetration.value, values.friction_stress.value * relaxed]
}

#[test]
fn sensitivities_of_contacts_are_derivatives_of_solutions() {
    for case in cases() {
        let contact = case.solved();
        let found = state_sensitivities(&case.material(BASE), &case.problem(BASE), &contact.values).unwrap();
        let sets = [found.half_width, found.mean_pressure, found.penetration, found.friction_stress];
        for (place, parameter) in Parameter::ALL.into_iter().enumerate() {
            for (output, set) in sets.iter().enumerate() {
                if output == 2 && case.indenter == Indenter::Parabola {
                    continue;
                }
                let expected = extrapolated(|logarithm| {
                    let inputs = varied(parameter, logarithm);
                    let near = steady_sliding_near(&case.material(inputs), &case.problem(inputs), &contact.start).unwrap();
                    outputs(&near, inputs.relaxed)[output].abs().ln()
                });
                let Estimate { value, error } = set[place].unwrap();
                println!("{} {parameter:?} {output}: {value:+.9} ± {error:.0e}, differences {:+.1e}", case.name, expected - value);
                assert!((value - expected).abs() <= error + 1e-9 * (1.0 + value.abs()), "{} {parameter:?} {output}", case.name);
                assert!(error <= 1e-8 * (1.0 + value.abs()), "{} {parameter:?} {output}: {error:e}", case.name);
            }
        }
    }
}

fn strength_of(material: &PlaneMaterial, problem: &BranchProblem<'_>) -> [f64; 4] {
    let Strength { pull_off, snap_in, separation, toughness, .. } = strength(material, problem).unwrap();
    [pull_off.unwrap().value.value, snap_in.unwrap().value.value, separation.unwrap().value.value, toughness.unwrap().value.value]
}

#[test]
fn sensitivities_of_strengths_are_derivatives_of_strengths() {
    let adhesion = WaveAdhesion { leading_work: 0.004, ..WaveAdhesion::even(0.006, 0.01) };
    let case = Case {
        name: "strength",
        beta: 10.0,
        shares: &THREE,
        indenter: Indenter::Wave,
        rate: 0.05,
        adhesion,
        control: SlidingControl::MeanPressure(0.0),
    };
    let problem = |inputs: Inputs| BranchProblem::loads(case.rate, case.problem(inputs).adhesion.unwrap(), 1e-10);
    let base = strength(&case.material(BASE), &problem(BASE)).unwrap();
    let found = strength_sensitivities(&case.material(BASE), &problem(BASE), &base).unwrap();
    let sets: [Sensitivity; 4] = [found.pull_off.unwrap(), found.snap_in.unwrap(), found.separation.unwrap(), found.toughness.unwrap()];
    for (place, parameter) in Parameter::ALL.into_iter().enumerate() {
        let at = |logarithm: f64| {
            let inputs = varied(parameter, logarithm);
            let [pull_off, snap_in, separation, toughness] = strength_of(&case.material(inputs), &problem(inputs));
            [pull_off * inputs.relaxed, snap_in * inputs.relaxed, separation, toughness * inputs.relaxed].map(|value| value.abs().ln())
        };
        let [far, near] = [0.02, 0.01].map(|step| {
            let (after, before) = (at(step), at(-step));
            [0, 1, 2, 3].map(|output: usize| (after[output] - before[output]) / (2.0 * step))
        });
        for (output, set) in sets.iter().enumerate() {
            let expected = (4.0 * near[output] - far[output]) / 3.0;
            let Estimate { value, error } = set[place].unwrap();
            println!("{parameter:?} {output}: {value:+.9} ± {error:.0e}, differences {:+.1e}", expected - value);
            assert!((value - expected).abs() <= error + 3e-9 * (1.0 + value.abs()), "{parameter:?} {output}");
            assert!(error <= 3e-8 * (1.0 + value.abs()), "{parameter:?} {output}: {error:e}");
        }
    }
}

/// What a scene asks for is how well the contact is known, and derivatives there lack as much: the bounds cover what a tighter run changes. Oracle: the same at 1e-11.
#[test]
fn bounds_of_sensitivities_cover_what_the_place_lacks() {
    let wide: [(f64, f64); 2] = [(0.99, 7e-7), (0.01, 0.13)];
    let mut compared = 0;
    for (beta, shares, rate, work, zone) in [
        (1.16, &wide[..], 3.1e4, 9e-3, 0.029),
        (5.0, &ONE[..], 0.3, 8e-3, 0.01),
        (20.0, &THREE[..], 2.0, 3e-3, 3e-3),
        (2.0, &wide[..], 30.0, 5e-3, 0.05),
        (100.0, &ONE[..], 1e-2, 1e-3, 1e-3),
    ] {
        let material = solid(RELAXED, beta, 1.0, shares);
        for (indenter, control) in [
            (Indenter::Wave, SlidingControl::MeanPressure(0.0)),
            (Indenter::Wave, SlidingControl::HalfWidth(0.9)),
            (Indenter::Wave, SlidingControl::Penetration(0.2)),
            (Indenter::Parabola, SlidingControl::HalfWidth(0.7)),
        ] {
            let at = |accuracy: f64| {
                let adhesion = Some(WaveAdhesion::even(work, zone));
                let problem = SlidingProblem { rate, indenter, adhesion, work_by_speed: None, control, accuracy };
                let Ok(SlidingOutcome::Partial(partial)) = steady_sliding(&material, &problem) else { return None };
                let found = state_sensitivities(&material, &problem, &partial.values).ok()?;
                Some([found.half_width, found.mean_pressure, found.penetration, found.friction_stress])
            };
            let Some(truth) = at(1e-11) else { continue };
            for accuracy in [1e-3, 1e-5, 1e-7] {
                let found = at(accuracy).unwrap();
                for (one, other) in found.iter().flatten().zip(truth.iter().flatten()) {
                    let (Some(one), Some(other)) = (one, other) else { continue };
                    compared += 1;
                    let off = (one.value - other.value).abs();
                    assert!(off <= one.error + other.error, "β = {beta}, {indenter:?}, {control:?}, {accuracy:e}: {one:?} {other:?}");
                }
            }
        }
    }
    println!("{compared} sensitivities");
    assert!(compared > 400);
}
