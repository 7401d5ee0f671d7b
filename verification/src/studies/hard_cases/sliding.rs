//! Steady sliding contacts of which the outcome is known in closed form: both ends of the speeds, nearly full, nearly no contact, extreme adhesion.

use super::case::{Expected, Found, HardCase, Kind, near};
use super::material::spread;
use crate::rivals::sliding_collocation::richardson::extrapolated;
use crate::rivals::sliding_collocation::{Layout, SlidingCollocation};
use std::f64::consts::PI;
use viscotack::estimate::Estimate;
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;
use viscotack::sliding::SlidingMemory;
use viscotack::sliding::contact::{Prescribed, WaveContact};
use viscotack::sliding::steady::{Indenter, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

const PROBLEM: &str = "steady sliding";
/// What is asked for.
const ACCURACY: f64 = 1e-9;
const WESTERGAARD: &str = "Westergaard's wave of the relaxed or the glassy modulus m: p̄ = m sin²(a/2), Δ = s²(1 − 2 ln s)";
const JOHNSON: &str =
    "Johnson's wave of the modulus m: p̄ = m s² − 2√(mΓ tan(a/2)); a zone moves it by about δ over the narrower of contact and gap";

/// Solves a problem; values in reduced units.
///
/// # Errors
/// Those of the solver.
pub fn solved(material: &PlaneMaterial, problem: &SlidingProblem<'_>) -> Result<Found, Refusal> {
    Ok(match steady_sliding(material, problem)? {
        SlidingOutcome::Partial(contact) => {
            let values = contact.values;
            let mut found = Found::default()
                .is("partial contact")
                .with("a", values.half_width)
                .with("e", values.eccentricity)
                .with("p̄", values.mean_pressure)
                .with("Δ", values.penetration)
                .with("friction stress", values.friction_stress);
            if let Some(adhesion) = values.adhesion {
                found = found.with("G₁/Δγ", adhesion.trailing_release).with("G₂/Δγ", adhesion.leading_release);
            }
            if contact.certificate.accuracy > problem.accuracy { found.is("accuracy not reached") } else { found }
        }
        SlidingOutcome::Full(full) => {
            Found::default().is("full contact").with("friction stress", full.friction_stress).with("limit", Estimate::exact(full.limit))
        }
    })
}

fn wave(rate: f64, adhesion: Option<WaveAdhesion>, control: SlidingControl, accuracy: f64) -> SlidingProblem<'static> {
    SlidingProblem { rate, indenter: Indenter::Wave, adhesion, work_by_speed: None, control, accuracy }
}

fn one_term(beta: f64) -> Result<PlaneMaterial, Refusal> {
    if beta > 1.0 { PlaneMaterial::standard_solid(1.0, beta, 1.0) } else { PlaneMaterial::elastic(1.0) }
}

/// Johnson's load of a half-width at a modulus.
fn johnson(modulus: f64, work: f64, half_width: f64) -> f64 {
    let half = 0.5 * half_width;
    modulus * half.sin().powi(2) - 2.0 * (modulus * work * half.tan()).sqrt()
}

/// The cases.
#[must_use]
pub fn cases() -> Vec<HardCase> {
    let mut cases = ends();
    cases.extend(narrow());
    cases.extend(full());
    cases.extend(zones());
    cases.extend(spectra());
    cases.extend(refused());
    cases
}

/// Slow and fast ends of the speeds, β from 1 to 1e6.
fn ends() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for (beta, rate) in
        [(1.0_f64, 1.0_f64), (1.0 + 1e-9, 1.0), (10.0, 1e-10), (10.0, 1e10), (1e6, 1e-10), (1e6, 1e10), (1e6, 1e300), (10.0, 5e-324)]
    {
        let fast = rate > 1e3;
        let modulus = if fast { beta } else { 1.0 };
        // The next order: ζ slow, 1/ε = β/ζ fast, of the part that the solid stiffens by.
        let next = 3.0 * (beta - 1.0).min(1.0) * if fast { beta / rate } else { rate.min(1.0) };
        let s2 = 0.5f64.sin().powi(2);
        cases.push(HardCase::new(
            PROBLEM,
            format!("no adhesion, β = {beta:e}, ζ = {rate:e}, a = 1"),
            "one of the two memories is a boundary layer of 1e-10 and less, or a constant",
            WESTERGAARD,
            vec![
                near("p̄", modulus * s2, next.max(1e-9)),
                Expected::Value { quantity: "Δ", value: s2 * (1.0 - s2.ln()), tolerance: next.max(1e-9).max(1e-14 * modulus) },
                Expected::Value { quantity: "e", value: 0.0, tolerance: next.max(1e-9) },
            ],
            move || solved(&one_term(beta)?, &wave(rate, None, SlidingControl::HalfWidth(1.0), ACCURACY)),
        ));
    }
    for (beta, rate) in [(1.0_f64, 1.0_f64), (10.0, 1e-10), (10.0, 1e10), (1e6, 1e-10), (1e6, 1e12)] {
        let modulus = if rate > 1.0 { beta } else { 1.0 };
        let (work, zone, a) = (2e-3 * modulus, 1e-5, 1.2);
        cases.push(HardCase::new(
            PROBLEM,
            format!("adhesion, β = {beta:e}, ζ = {rate:e}, a = 1.2"),
            "relaxed at every place, or glassy at every place, the edges included",
            JOHNSON,
            vec![
                Expected::Value { quantity: "p̄", value: johnson(modulus, work, a), tolerance: 3.0 * zone * modulus },
                Expected::Value { quantity: "e", value: 0.0, tolerance: 1e-4 },
            ],
            move || solved(&one_term(beta)?, &wave(rate, Some(WaveAdhesion::even(work, zone)), SlidingControl::HalfWidth(a), 1e-7)),
        ));
    }
    cases
}

/// Contacts and gaps of next to no width.
fn narrow() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for a in [1e-3, 1e-6, 1e-8] {
        cases.push(HardCase::new(
            PROBLEM,
            format!("no adhesion, half-width {a:e}, ζ = 1e-12"),
            "the load is the square of the width: 1e-16 of one",
            "a cylinder of radius 1/(k²Λ): p̄ = a²/4 to a relative a²/12",
            vec![Expected::Value { quantity: "p̄", value: 0.25 * a * a, tolerance: 1e-8 * a * a + a.powi(4) }],
            move || solved(&one_term(10.0)?, &wave(1e-12 * a, None, SlidingControl::HalfWidth(a), 1e-16_f64.max(1e-9 * a * a))),
        ));
        let (work, zone) = (1e-3 * a * a * a, 1e-4 * a);
        cases.push(HardCase::new(
            PROBLEM,
            format!("adhesion, half-width {a:e} with a work of its own size"),
            "the contact is a hundred-millionth of the wave, its zone a ten-thousandth of that",
            "Barquins' cylinder: p̄ = a²/4 − √(2Γa); a zone moves it by about δ/a",
            vec![Expected::Value { quantity: "p̄", value: 0.25 * a * a - (2.0 * work * a).sqrt(), tolerance: 1e-4 * a * a }],
            move || {
                solved(
                    &PlaneMaterial::elastic(1.0)?,
                    &wave(0.0, Some(WaveAdhesion::even(work, zone)), SlidingControl::HalfWidth(a), 1e-9 * a * a),
                )
            },
        ));
    }
    for gap in [1e-2, 1e-4, 1e-8] {
        let a = PI - gap;
        let missing = (0.5 * gap).sin().powi(2);
        cases.push(HardCase::new(
            PROBLEM,
            format!("no adhesion, π − a = {gap:e}, elastic"),
            "the load differs from that of full contact by the square of the gap",
            "Westergaard: 1 − p̄ = sin²((π − a)/2)",
            vec![Expected::Value { quantity: "p̄", value: 1.0 - missing, tolerance: 1e-12 }],
            move || solved(&PlaneMaterial::elastic(1.0)?, &wave(0.0, None, SlidingControl::HalfWidth(a), ACCURACY)),
        ));
        let (work, zone) = (1e-3 * gap, 1e-4 * gap);
        let modulus = 10.0;
        cases.push(HardCase::new(
            PROBLEM,
            format!("adhesion, π − a = {gap:e}, ζ = 1e12"),
            "both edges stand at one gap; penetrations have lost all digits (condition 1e12)",
            JOHNSON,
            vec![Expected::Value { quantity: "p̄", value: johnson(modulus, work, a), tolerance: 3e-4 * modulus }],
            move || solved(&one_term(modulus)?, &wave(1e12, Some(WaveAdhesion::even(work, zone)), SlidingControl::HalfWidth(a), 1e-6)),
        ));
    }
    cases
}

/// Full contact, and the limits beyond which it is the answer.
fn full() -> Vec<HardCase> {
    let friction = |beta: f64, zeta: f64| 0.5 * zeta * (1.0 - 1.0 / beta) / (1.0 + (zeta / beta).powi(2));
    vec![
        HardCase::new(
            PROBLEM,
            "no adhesion, a load of 1 + 1e-9 slowly",
            "a billionth beyond the load of full contact",
            "Westergaard: full from p̄ = 1 on; friction ½ Im E(kv) (thesis 3.43)",
            vec![Expected::Is("full contact"), near("limit", 1.0, 1e-12), near("friction stress", friction(10.0, 1e-6), 1e-12)],
            || solved(&one_term(10.0)?, &wave(1e-6, None, SlidingControl::MeanPressure(1.0 + 1e-9), ACCURACY)),
        ),
        HardCase::new(
            PROBLEM,
            "no adhesion, a load of 1 − 1e-9 at rest",
            "a billionth before the load of full contact",
            "Westergaard: π − a = 2 arcsin √1e-9",
            vec![
                Expected::Is("partial contact"),
                Expected::Value { quantity: "a", value: PI - 2.0 * 1e-9f64.sqrt().asin(), tolerance: 1e-9 },
            ],
            || solved(&one_term(10.0)?, &wave(0.0, None, SlidingControl::MeanPressure(1.0 - 1e-9), ACCURACY)),
        ),
        HardCase::new(
            PROBLEM,
            "Γ = 1 without load at rest",
            "adhesion far above the value at which a wave closes by itself",
            "Johnson: α = 2 > 0.57: no partial contact is stable, full contact; each is pulled, the less the narrower it is: their loads end at zero",
            vec![Expected::Is("full contact"), Expected::Value { quantity: "limit", value: 0.0, tolerance: 0.0 }],
            || solved(&one_term(10.0)?, &wave(0.0, Some(WaveAdhesion::even(1.0, 1e-3)), SlidingControl::MeanPressure(0.0), 1e-6)),
        ),
        HardCase::new(
            PROBLEM,
            "Γ = 1 without load, sliding",
            "what memory gives one edge and takes from the other is more than an eccentricity can make up for",
            "as at rest; with Γ from 0.1 on the eccentricity of a contact grows to −π/2 at Γ = 0.53, and beyond that there is none: no load to name as a limit",
            vec![Expected::Is("full contact")],
            || solved(&one_term(10.0)?, &wave(1e-3, Some(WaveAdhesion::even(1.0, 1e-3)), SlidingControl::MeanPressure(0.0), 1e-6)),
        ),
        HardCase::new(
            PROBLEM,
            "full contact of 20 terms over 20 decades",
            "each term has its peak elsewhere",
            "½ΣE_iε_i/(1 + ε_i²) over the relaxation terms, as it is defined",
            vec![Expected::Is("full contact"), near("friction stress", spread_friction(1e-4), 1e-12)],
            || solved(&spread(100.0, 20, 20.0, 1e10)?, &wave(1e-4, None, SlidingControl::MeanPressure(200.0), ACCURACY)),
        ),
    ]
}

/// ½ Im E(kv) of 20 terms, by their creep terms: E = 1/J, J = 1/β + ΣJ_j/(1 + iωτ_j).
fn spread_friction(rate: f64) -> f64 {
    let Ok(material) = spread(100.0, 20, 20.0, 1e10) else { return f64::NAN };
    let (mut real, mut imaginary) = (1.0 / material.glassy_modulus(), 0.0);
    for term in material.creep_terms() {
        let product = rate * term.retardation_time;
        real += term.compliance / (1.0 + product * product);
        imaginary += term.compliance / (1.0 / product + product);
    }
    0.5 * imaginary / (real * real + imaginary * imaginary)
}

/// Zones from 1e-8 to 0.3 of the contact; adhesion that vanishes.
fn zones() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for part in [1e-8_f64, 1e-6, 1e-4, 1e-2] {
        let (a, work) = (1.0, 1e-3);
        cases.push(HardCase::new(
            PROBLEM,
            format!("a zone of {part:e} of the contact"),
            "the window of the closure is a fraction of an ulp of the wave away from nothing",
            "G = Δγ at both edges of an elastic solid, at any zone; a zone moves the edge of Johnson's wave by 0.65 δ, its load by 0.26 δ",
            vec![
                Expected::Value { quantity: "p̄", value: johnson(1.0, work, a), tolerance: (0.4 * part).max(1e-10) },
                near("G₁/Δγ", 1.0, 1e-5),
                near("G₂/Δγ", 1.0, 1e-5),
            ],
            move || {
                solved(
                    &PlaneMaterial::elastic(1.0)?,
                    &wave(0.0, Some(WaveAdhesion::even(work, part * a)), SlidingControl::HalfWidth(a), 1e-6),
                )
            },
        ));
    }
    cases.push(HardCase::new(
        PROBLEM,
        "a zone of 0.3 of the contact, elastic",
        "the moved contact is another one: nothing is linear in δ",
        "G = Δγ at both edges of an elastic solid, at any zone",
        vec![near("G₁/Δγ", 1.0, 1e-6), near("G₂/Δγ", 1.0, 1e-6), Expected::Value { quantity: "e", value: 0.0, tolerance: 1e-6 }],
        || solved(&PlaneMaterial::elastic(1.0)?, &wave(0.0, Some(WaveAdhesion::even(1e-2, 0.3)), SlidingControl::HalfWidth(1.0), 1e-7)),
    ));
    for work in [1e-12, 1e-20, 1e-25, 1e-30, 1e-100, 1e-300] {
        // p̄ = s² − 2√(Γ tan(a/2)): a zone far below √Γ, so that the closure is that of a sharp edge.
        let s2 = 0.5f64.sin().powi(2);
        let pull = 2.0 * (work * 0.5f64.tan()).sqrt();
        cases.push(HardCase::new(
            PROBLEM,
            format!("Γ = {work:e}"),
            "adhesion disappears among the terms of the load",
            "Johnson's pull goes with √Γ: Westergaard's load remains",
            vec![Expected::Value { quantity: "p̄", value: s2 - pull, tolerance: 0.02 * pull + 1e-11 }],
            move || {
                solved(
                    &PlaneMaterial::elastic(1.0)?,
                    &wave(0.0, Some(WaveAdhesion::even(work, 1e-3 * work.sqrt())), SlidingControl::HalfWidth(1.0), 1e-9),
                )
            },
        ));
    }
    cases.push(HardCase::new(
        PROBLEM,
        "different works of both edges, slowly",
        "the edges stand unevenly although nothing is lost in the bulk",
        "power: friction stress = Γ₁ − Γ₂ of an elastic solid (thesis 3.40 with G = Δγ), up to a few δ",
        vec![Expected::Value { quantity: "friction stress", value: 1.5e-3, tolerance: 1e-7 }],
        || {
            let adhesion = WaveAdhesion { trailing_work: 2e-3, leading_work: 5e-4, trailing_zone: 1e-6, leading_zone: 1e-6 };
            solved(&PlaneMaterial::elastic(1.0)?, &wave(0.0, Some(adhesion), SlidingControl::MeanPressure(0.2), 1e-8))
        },
    ));
    cases
}

/// Wide and degenerate spectra between the ends.
fn spectra() -> Vec<HardCase> {
    let adhesion = Some(WaveAdhesion::even(2e-3, 1e-3));
    // One term of twice the strength, solved beforehand by the partial-fraction form: its load.
    let split = || {
        let term = |retardation_time| CreepTerm { compliance: 0.45, retardation_time };
        PlaneMaterial::from_creep(10.0, &[term(1.0), term(1.0 + 1e-14)], None)
    };
    let unsplit = one_term(10.0).and_then(|material| solved(&material, &wave(3.0, adhesion, SlidingControl::HalfWidth(1.0), 1e-10)));
    let load =
        unsplit.map_or(f64::NAN, |found| found.values.iter().find(|(name, _)| *name == "p̄").map_or(f64::NAN, |(_, value)| value.value));
    vec![
        HardCase::new(
            PROBLEM,
            "two nearly equal times at ζ = 3",
            "in partial fractions both strengths are 1e14 and of opposite signs",
            "the same solid with one term of the sum of both strengths",
            vec![Expected::Value { quantity: "p̄", value: load, tolerance: 1e-8 }],
            move || solved(&split()?, &wave(3.0, adhesion, SlidingControl::HalfWidth(1.0), 1e-9)),
        ),
        HardCase::new(
            PROBLEM,
            "20 terms over 20 decades, ten of them slower than the passage",
            "Πζ_j is 1e100: the partial-fraction form has no digit left",
            "collocation on the kernel itself, which has no fractions: the works at both edges of what was found are 2πΓ",
            vec![
                Expected::Is("partial contact"),
                Expected::Value { quantity: "work of the trailing edge over 2πΓ", value: 1.0, tolerance: 2e-3 },
                Expected::Value { quantity: "work of the leading edge over 2πΓ", value: 1.0, tolerance: 2e-3 },
            ],
            || collocated(&spread(100.0, 20, 20.0, 1e10)?, 1.0, WaveAdhesion::even(2e-3, 1e-2)),
        ),
        HardCase::new(
            PROBLEM,
            "20 terms, all of them slower than the passage by ten decades",
            "Πζ_j is 1e400: no double",
            "glassy: Johnson's wave of m = β",
            vec![Expected::Value { quantity: "p̄", value: johnson(100.0, 2e-3, 1.0), tolerance: 3e-3 * 100.0 }],
            move || solved(&spread(100.0, 20, 20.0, 1e10)?, &wave(1e20, adhesion, SlidingControl::HalfWidth(1.0), 1e-6)),
        ),
    ]
}

/// The contact of half-width one, and the works at its edges by collocation, extrapolated from 60, 120 and 240 elements.
fn collocated(material: &PlaneMaterial, rate: f64, adhesion: WaveAdhesion) -> Result<Found, Refusal> {
    let found = solved(material, &wave(rate, Some(adhesion), SlidingControl::HalfWidth(1.0), 1e-8))?;
    let at = |name: &str| found.values.iter().find(|(quantity, _)| *quantity == name).map_or(f64::NAN, |(_, value)| value.value);
    let contact = WaveContact { half_width: 1.0, eccentricity: at("e") };
    let kernel = SlidingMemory::of_material(material, rate, 1.0)?;
    let mut works = [Vec::new(), Vec::new()];
    for elements in [60, 120, 240] {
        let layout = Layout::WindowAligned { window_elements: elements / 3 };
        let scheme = SlidingCollocation::new(&kernel, layout, elements, 3.0)?;
        let closures = scheme.closures(&adhesion, Prescribed::MeanPressure(at("p̄")), contact)?;
        works[0].push(closures.trailing_work / (2.0 * PI * adhesion.trailing_work));
        works[1].push(closures.leading_work / (2.0 * PI * adhesion.leading_work));
    }
    let work = |values: &[f64]| {
        let best = extrapolated(values, &[3.0, 4.0]);
        Estimate::new(best, (best - extrapolated(values.get(..2).unwrap_or(values), &[3.0])).abs())
    };
    Ok(found.clone().with("work of the trailing edge over 2πΓ", work(&works[0])).with("work of the leading edge over 2πΓ", work(&works[1])))
}

/// Numbers that are wrong, and solids that have no answer.
fn refused() -> Vec<HardCase> {
    let out_of_range = |name: &'static str, problem: SlidingProblem<'static>| {
        HardCase::new(
            PROBLEM,
            name,
            "a wrong number must not reach the equations",
            "refused",
            vec![Expected::Refused(Kind::OutOfRange)],
            move || solved(&one_term(10.0)?, &problem),
        )
    };
    vec![
        out_of_range("a half-width of π", wave(1.0, None, SlidingControl::HalfWidth(PI), ACCURACY)),
        out_of_range("a load that is no number", wave(1.0, None, SlidingControl::MeanPressure(f64::NAN), ACCURACY)),
        out_of_range("an infinite speed", wave(f64::INFINITY, None, SlidingControl::HalfWidth(1.0), ACCURACY)),
        out_of_range("a pull without adhesion", wave(1.0, None, SlidingControl::MeanPressure(-1e-3), ACCURACY)),
        HardCase::new(
            PROBLEM,
            "a viscous material",
            "it has no relaxed modulus to reduce by",
            "no steady contact at rest",
            vec![Expected::Refused(Kind::Undefined)],
            || {
                let material = PlaneMaterial::from_creep(1.0, &[CreepTerm { compliance: 1.0, retardation_time: 1.0 }], Some(10.0))?;
                solved(&material, &wave(1.0, None, SlidingControl::HalfWidth(1.0), ACCURACY))
            },
        ),
    ]
}
