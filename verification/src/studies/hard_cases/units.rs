//! One scene of each problem in SI, in nm–GPa–ns and in km–Pa–years: the same reduced numbers must come out.
//!
//! The numbers are put in as magnitudes in these units, as a user does whose units are coherent; the expected value is that in SI, solved beforehand.

use super::case::{Expected, Found, HardCase};
use viscotack::crack::delayed::{GrowthProblem, LoadHistory, Resolution, trajectory};
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, at_speed};
use viscotack::estimate::Estimate;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, run};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;
use viscotack::sliding::steady::{Indenter, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

const PROBLEM: &str = "units";
const YEAR: f64 = 3.155_76e7;

/// How many SI units one unit of length, pressure and time is.
#[derive(Clone, Copy)]
struct Units {
    name: &'static str,
    length: f64,
    pressure: f64,
    time: f64,
}

const SI: Units = Units { name: "m–Pa–s", length: 1.0, pressure: 1.0, time: 1.0 };
const OTHERS: [Units; 3] = [
    Units { name: "nm–GPa–ns", length: 1e-9, pressure: 1e9, time: 1e-9 },
    Units { name: "km–Pa–years", length: 1e3, pressure: 1.0, time: YEAR },
    // Every number far from one, in both directions.
    Units { name: "1e60 m–1e-60 Pa–1e60 s", length: 1e60, pressure: 1e-60, time: 1e60 },
];

/// A three-term rubber, E0 = 1.3 MPa, β = 40.
fn rubber(units: Units) -> Result<PlaneMaterial, Refusal> {
    let (relaxed, beta) = (1.3e6 / units.pressure, 40.0);
    let term = |share: f64, time: f64| CreepTerm { compliance: share * (1.0 - 1.0 / beta) / relaxed, retardation_time: time / units.time };
    PlaneMaterial::from_creep(beta * relaxed, &[term(0.5, 2.0), term(0.3, 0.05), term(0.2, 1e-3)], None)
}

fn crack(units: Units) -> Result<Estimate, Refusal> {
    let material = rubber(units)?;
    let interface = Interface {
        work_of_adhesion: 0.7 / (units.pressure * units.length),
        process_zone: ProcessZone::Growing { cohesive_stress: 4e5 / units.pressure, factor: 0.4 },
        body: CrackBody::TwoHalves,
    };
    let state = at_speed(&VirtualWork::new(&material, Motion::Opening, interface)?, 3e-4 / (units.length / units.time), 1e-14)?;
    Ok(state.energy_release_rate_ratio.unwrap_or(state.drive))
}

/// The place of the tip over its zone.
fn delayed(units: Units) -> Result<Estimate, Refusal> {
    let material = rubber(units)?;
    let length = 2e-6 / units.length;
    let interface = Interface {
        work_of_adhesion: 0.7 / (units.pressure * units.length),
        process_zone: ProcessZone::Constant { length },
        body: CrackBody::TwoHalves,
    };
    let problem = GrowthProblem::new(&material, interface, 0.0)?;
    let history = LoadHistory::constant(2.0 * problem.relaxed_limit())?;
    let found = trajectory(&problem, &history, &[1.5 / units.time], Resolution { lines_per_zone: 16, ..Resolution::default() })?;
    let growth = found.samples.first().and_then(|sample| sample.growth);
    Ok(growth.map_or(Estimate::new(f64::NAN, f64::INFINITY), |growth| growth.scaled(1.0 / length)))
}

/// Half the contact width times k.
fn sliding(units: Units) -> Result<Estimate, Refusal> {
    let material = rubber(units)?;
    let problem = SlidingProblem {
        rate: 20.0 * units.time,
        indenter: Indenter::Wave,
        adhesion: Some(WaveAdhesion::even(2e-3, 2e-3)),
        work_by_speed: None,
        control: SlidingControl::MeanPressure(0.3),
        accuracy: 1e-9,
    };
    match steady_sliding(&material, &problem)? {
        SlidingOutcome::Partial(contact) => Ok(contact.values.half_width),
        SlidingOutcome::Full(full) => Ok(full.friction_stress.scaled(f64::NAN)),
    }
}

/// The largest tension over (3/2)πRΔγ.
fn sphere(units: Units) -> Result<Estimate, Refusal> {
    let material = rubber(units)?;
    let radius = 1e-3 / units.length;
    let work_of_adhesion = 0.05 / (units.pressure * units.length);
    let adhesion = Adhesion { work_of_adhesion, process_zone: 4e-6 / units.length };
    let history = History::penetration(4e-6 / units.length).at_speed(-8e-6 / units.length, 2e-6 / (units.length / units.time));
    let problem = IndentationProblem { accuracy: 1e-3, ..IndentationProblem::new(Profile::Paraboloid { radius }, Some(adhesion), history) };
    let found = run(&material, &problem.relaxed())?;
    let jkr = 1.5 * std::f64::consts::PI * radius * work_of_adhesion;
    Ok(found.pull_off_force().map_or(Estimate::new(f64::NAN, f64::INFINITY), |force| force.scaled(1.0 / jkr)))
}

/// A problem: name, reduced quantity, tolerance relative to it, and what computes it.
type Row = (&'static str, &'static str, f64, fn(Units) -> Result<Estimate, Refusal>);

const ROWS: [Row; 4] = [
    ("steady crack", "G/Δγ", 1e-12, crack),
    ("delayed crack", "x₀/δ", 1e-4, delayed),
    ("steady sliding", "ka", 1e-8, sliding),
    ("sphere", "F_off/F_JKR", 5e-3, sphere),
];

/// The cases.
#[must_use]
pub fn cases() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for (name, quantity, relative, compute) in ROWS {
        let expected = compute(SI).map_or(f64::NAN, |estimate| estimate.value);
        for units in OTHERS {
            cases.push(HardCase::new(
                PROBLEM,
                format!("{name} in {}", units.name),
                "moduli, lengths and times are up to sixty decades from one",
                "units change no reduced number: that in SI",
                vec![Expected::Value { quantity, value: expected, tolerance: relative * expected.abs() }],
                move || Ok(Found::default().with(quantity, compute(units)?)),
            ));
        }
    }
    cases
}
