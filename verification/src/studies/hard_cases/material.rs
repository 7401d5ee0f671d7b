//! Conversion of series, and solids at the ends of what doubles hold.

use super::case::{Expected, Found, HardCase, Kind, near};
use viscotack::estimate::Estimate;
use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;

const PROBLEM: &str = "material";

/// Terms that fall by a factor each, their compliances equal: 1/E0 = 1 and E∞ = β.
///
/// # Errors
/// Those of making a material.
pub fn spread(beta: f64, terms: usize, decades: f64, longest: f64) -> Result<PlaneMaterial, Refusal> {
    let list: Vec<CreepTerm> = (0..terms)
        .map(|index| CreepTerm {
            compliance: (1.0 - 1.0 / beta) / terms as f64,
            retardation_time: longest * 10f64.powf(-decades * index as f64 / (terms.max(2) - 1) as f64),
        })
        .collect();
    PlaneMaterial::from_creep(beta, &list, None)
}

/// s²·J̄(s)·R̄(s) − 1 at a Laplace variable, J̄ from the creep and R̄ from the relaxation terms: zero for a pair of series that belong together.
fn reciprocity(material: &PlaneMaterial, s: f64) -> f64 {
    let creep: f64 = material.creep_terms().iter().map(|term| term.compliance / (1.0 + s * term.retardation_time)).sum::<f64>()
        + 1.0 / material.glassy_modulus()
        + material.steady_viscosity().map_or(0.0, |viscosity| 1.0 / (viscosity * s));
    let relaxation: f64 = material
        .relaxation_terms()
        .iter()
        .map(|term| term.modulus * s * term.relaxation_time / (1.0 + s * term.relaxation_time))
        .sum::<f64>()
        + material.relaxed_modulus();
    creep * relaxation - 1.0
}

/// The largest defect of reciprocity over decades of s about all times.
fn worst_reciprocity(material: &PlaneMaterial) -> Estimate {
    let worst = (-260..=260).map(|tenth| reciprocity(material, 10f64.powf(f64::from(tenth) / 10.0)).abs()).fold(0.0, f64::max);
    Estimate::new(worst, 0.0)
}

const RECIPROCAL: &str = "s²J̄(s)R̄(s) = 1 at any s (Gross 1953)";

/// The cases.
#[must_use]
pub fn cases() -> Vec<HardCase> {
    let zero = |tolerance: f64| vec![Expected::Value { quantity: "largest defect of reciprocity", value: 0.0, tolerance }];
    let reported = |material: &PlaneMaterial| Ok(Found::default().with("largest defect of reciprocity", worst_reciprocity(material)));
    vec![
        HardCase::new(
            PROBLEM,
            "20 terms over 20 decades, β = 1e6, converted",
            "as polynomials the two series lose all digits",
            RECIPROCAL,
            zero(1e-12),
            move || reported(&spread(1e6, 20, 20.0, 1e10)?),
        ),
        HardCase::new(
            PROBLEM,
            "two retardation times that differ in the last digits",
            "the rates of the other series lie in a gap of some ulp",
            RECIPROCAL,
            zero(1e-12),
            move || {
                let term = |retardation_time| CreepTerm { compliance: 0.45, retardation_time };
                reported(&PlaneMaterial::from_creep(10.0, &[term(1.0), term(1.0 + 4.0 * f64::EPSILON)], None)?)
            },
        ),
        HardCase::new(
            PROBLEM,
            "two times that differ in the last digits respond as one",
            "each strength of the converted pair is known to few digits; their sum to all",
            "a double term of the same time: R(t) of one term of twice the strength",
            vec![near("R(1)", 1.0 + 9.0 * (-10.0_f64).exp(), 1e-13)],
            || {
                let term = |retardation_time| CreepTerm { compliance: 0.45, retardation_time };
                let material = PlaneMaterial::from_creep(10.0, &[term(1.0), term(1.0 + 4.0 * f64::EPSILON)], None)?;
                Ok(Found::default().with("R(1)", Estimate::new(material.relaxation(1.0), 0.0)))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a term of strength 1e-18 beside one of strength one",
            "its relaxation time differs from its retardation time in no digit",
            RECIPROCAL,
            zero(1e-13),
            move || {
                let term = |compliance, retardation_time| CreepTerm { compliance, retardation_time };
                reported(&PlaneMaterial::from_creep(10.0, &[term(0.9, 1.0), term(1e-18, 1e-3)], None)?)
            },
        ),
        HardCase::new(
            PROBLEM,
            "a viscous material of twelve terms",
            "no relaxed modulus: a creep pole at rate zero",
            RECIPROCAL,
            zero(1e-12),
            move || {
                let terms: Vec<RelaxationTerm> =
                    (0..12).map(|index| RelaxationTerm { modulus: 1.0 + f64::from(index), relaxation_time: 10f64.powi(-index) }).collect();
                reported(&PlaneMaterial::from_relaxation(0.0, &terms)?)
            },
        ),
        HardCase::new(
            PROBLEM,
            "moduli of 1e-310 (subnormal)",
            "compliances overflow",
            "1/1e-310 is no double: nothing is left to compute with",
            vec![Expected::Refused(Kind::Either)],
            || PlaneMaterial::standard_solid(1e-310, 1e-309, 1.0).map(|_| Found::default().is("a material")),
        ),
        HardCase::new(
            PROBLEM,
            "moduli of 1e150 and times of 1e-150",
            "squares of both overflow or underflow",
            "units change nothing: R(ρ)/E0 = 1 + 9/e",
            vec![near("R(ρ)/E0", 1.0 + 9.0 * (-1.0_f64).exp(), 1e-14)],
            || {
                let material = PlaneMaterial::standard_solid(1e150, 1e151, 1e-150)?;
                Ok(Found::default().with("R(ρ)/E0", Estimate::new(material.relaxation(1e-151) / 1e150, 0.0)))
            },
        ),
    ]
}
