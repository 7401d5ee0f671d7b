//! Steady cracks: β to 1e6, speeds over twenty decades and more, loads on their limits.

use super::case::{Expected, Found, HardCase, Kind, near};
use super::material::spread;
use crate::rivals::raw_crack_work::RawCrackWork;
use viscotack::crack::cohesive_zone::CohesiveZone;
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyState, at_drive, at_speed};
use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;

const PROBLEM: &str = "steady crack";
/// Tolerance of the root.
const TOLERANCE: f64 = 1e-14;
/// The zone of the cases (m).
const ZONE: f64 = 1e-6;

fn constant(work_of_adhesion: f64) -> Interface {
    Interface { work_of_adhesion, process_zone: ProcessZone::Constant { length: ZONE }, body: CrackBody::AgainstRigid }
}

fn reported(state: &SteadyState) -> Found {
    let found = Found::default().with("v", state.speed).with("D", state.drive);
    match state.energy_release_rate_ratio {
        Some(ratio) => found.with("G/Δγ", ratio),
        None => found,
    }
}

/// G/Δγ of one term at z = δ/(vτ): opening 1/(1 − jφ(z)), closing 1/(1 + (β − 1)φ(βz)), φ = (1 − e^{−z})/z.
fn one_term(beta: f64, motion: Motion, z: f64) -> f64 {
    let mean = |z: f64| if z < 1e-300 { 1.0 } else { -(-z).exp_m1() / z };
    match motion {
        // 1 − jφ = 1/β + j(1 − φ), without cancellation for small z by its series.
        Motion::Opening => {
            let missing = if z < 1e-4 { z / 2.0 - z * z / 6.0 + z * z * z / 24.0 } else { 1.0 - mean(z) };
            1.0 / (1.0 / beta + (1.0 - 1.0 / beta) * missing)
        }
        Motion::Closing => 1.0 / (1.0 + (beta - 1.0) * mean(beta * z)),
    }
}

/// A solid of one term of τ = 1 s and E0 = 1, at v = δ/(zτ).
fn at(beta: f64, motion: Motion, z: f64) -> Result<Found, Refusal> {
    let material = PlaneMaterial::standard_solid(1.0, beta, 1.0)?;
    Ok(reported(&at_speed(&VirtualWork::new(&material, motion, constant(1.0))?, ZONE / z, TOLERANCE)?))
}

fn under(beta: f64, motion: Motion, drive: f64) -> Result<Found, Refusal> {
    let material = PlaneMaterial::standard_solid(1.0, beta, 1.0)?;
    Ok(reported(&at_drive(&VirtualWork::new(&material, motion, constant(1.0))?, drive, TOLERANCE)?))
}

/// The cases.
#[must_use]
pub fn cases() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for (beta, exponent, motion) in [
        (1.0 + 1e-12, 0, Motion::Opening),
        (1e6, 10, Motion::Opening),
        (1e6, -10, Motion::Opening),
        (1e6, 3, Motion::Opening),
        (1e6, 10, Motion::Closing),
        (1e6, -10, Motion::Closing),
        (1e6, -3, Motion::Closing),
    ] {
        let z = 10f64.powi(exponent);
        let name = format!("β = {beta:e}, {motion:?}, vτ/δ = {:e}", 1.0 / z);
        let value = one_term(beta, motion, z);
        // Rounding of β itself counts where β − 1 is small.
        cases.push(HardCase::new(
            PROBLEM,
            name,
            "G/Δγ is within rounding of a limit, or its parts differ by six decades",
            "the collapsed closure of one term (thesis 5.22, 5.39)",
            vec![near("G/Δγ", value, 2e-14)],
            move || at(beta, motion, z),
        ));
    }
    cases.extend(limits());
    cases.extend(spectra());
    cases.extend(extremes());
    cases
}

/// Loads on, before and after the limits of the theory, and both ends of the speeds.
fn limits() -> Vec<HardCase> {
    vec![
        HardCase::new(
            PROBLEM,
            "speed zero",
            "the crossing time is infinite",
            "G = Δγ at rest, exactly",
            vec![near("G/Δγ", 1.0, 4e-15)],
            || {
                let material = PlaneMaterial::standard_solid(1.0, 1e6, 1.0)?;
                Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, constant(1.0))?, 0.0, TOLERANCE)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "infinite speed",
            "the crossing time is zero",
            "G = βΔγ, exactly",
            vec![near("G/Δγ", 1e6, 4e-15)],
            || {
                let material = PlaneMaterial::standard_solid(1.0, 1e6, 1.0)?;
                Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, constant(1.0))?, f64::INFINITY, TOLERANCE)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a load 1e-9 below that of rest",
            "no speed is slow enough",
            "an opening crack needs G > Δγ: the witness is G/Δγ = 1",
            vec![Expected::NoSuchState { limit: 1.0, tolerance: 1e-14 }],
            || under(100.0, Motion::Opening, 1.0 - 1e-9),
        ),
        HardCase::new(
            PROBLEM,
            "a load 1e-12 above that of rest",
            "the speed goes to zero with the distance from the limit",
            "G/Δγ = 1 + (1 − 1/β)vτ/δ to first order: v = 1e-12 δ/(τ(1 − 1/β)); ten ulp of G are 2e-3 of the distance",
            vec![Expected::Value { quantity: "v", value: 1e-12 * ZONE / 0.99, tolerance: 3e-3 * 1e-12 * ZONE }],
            || under(100.0, Motion::Opening, 1.0 + 1e-12),
        ),
        HardCase::new(
            PROBLEM,
            "the load of rest to an ulp",
            "its speed is rounding",
            "it is the load of rest: v = 0",
            vec![Expected::Value { quantity: "v", value: 0.0, tolerance: 1e-15 * ZONE }],
            || under(100.0, Motion::Opening, 1.0 + f64::EPSILON),
        ),
        HardCase::new(
            PROBLEM,
            "the glassy load",
            "the speed is infinite",
            "an opening crack needs G < βΔγ: the witness is β",
            vec![Expected::NoSuchState { limit: 100.0, tolerance: 1e-12 }],
            || under(100.0, Motion::Opening, 100.0),
        ),
        HardCase::new(
            PROBLEM,
            "a load 1e-10 below the glassy one",
            "the speed goes to infinity with the distance from the limit",
            "βΔγ/G = 1 + (β − 1)z/2: z = 2e-10/(β − 1), v = δ/(zτ); ten ulp of G are 2e-5 of the distance",
            vec![near("v", ZONE * 99.0 / 2e-10, 3e-5)],
            || under(100.0, Motion::Opening, 100.0 * (1.0 - 1e-10)),
        ),
        HardCase::new(
            PROBLEM,
            "a closing load 1e-10 above the glassy one",
            "the speed goes to infinity with the distance from the limit",
            "⟨R⟩ = E∞(1 − (1 − 1/β)·βz/2): z = 2e-10/(β − 1), v = δ/(zτ); converted terms leave forty ulp, 1e-4 of the distance",
            vec![near("v", ZONE * 99.0 / 2e-10, 1e-4)],
            || under(100.0, Motion::Closing, 0.01 * (1.0 + 1e-10)),
        ),
        HardCase::new(
            PROBLEM,
            "a closing load that holds the crack open",
            "no speed is slow enough",
            "a closing crack needs G < Δγ: the witness is 1",
            vec![Expected::NoSuchState { limit: 1.0, tolerance: 1e-14 }],
            || under(100.0, Motion::Closing, 1.01),
        ),
        HardCase::new(
            PROBLEM,
            "an elastic solid under a load",
            "any speed is right at one load, none at another",
            "no curve G(v)",
            vec![Expected::Refused(Kind::Undefined)],
            || {
                let material = PlaneMaterial::elastic(1.0)?;
                Ok(reported(&at_drive(&VirtualWork::new(&material, Motion::Opening, constant(1.0))?, 2.0, TOLERANCE)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a speed that is no number",
            "a NaN passes every comparison",
            "refused",
            vec![Expected::Refused(Kind::OutOfRange)],
            || at(100.0, Motion::Opening, f64::NAN),
        ),
    ]
}

/// Wide and degenerate spectra, other theories, the cliff of a closing crack.
fn spectra() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for (motion, time) in [(Motion::Opening, 1e-3), (Motion::Closing, 1e-3), (Motion::Opening, 1e-9)] {
        // The double integrals as printed, at a crossing time: done before the run.
        let wide = spread(1e6, 20, 20.0, 1e8);
        let expected = wide.and_then(|material| {
            let (mean, ..) = RawCrackWork::new(&material, motion, constant(1.0), 1e-11)?.mean(time)?;
            Ok(1.0 / mean)
        });
        let expected = expected.unwrap_or(f64::NAN);
        cases.push(HardCase::new(
            PROBLEM,
            format!("20 terms over 20 decades, {motion:?}, crossing time {time:e} s"),
            "some terms are relaxed, some glassy, and their strengths are six decades apart",
            "the double integrals of Eqs 5.11, 5.19, 5.30, 5.37 as printed",
            vec![near("D", expected, 1e-9)],
            move || {
                let material = spread(1e6, 20, 20.0, 1e8)?;
                Ok(reported(&at_speed(&VirtualWork::new(&material, motion, constant(1.0))?, ZONE / time, TOLERANCE)?))
            },
        ));
    }
    cases.push(HardCase::new(
        PROBLEM,
        "a term split into two of nearly equal times",
        "the converted pair is known to few digits each",
        "the unsplit term",
        vec![near("G/Δγ", one_term(10.0, Motion::Opening, 1.0), 1e-13)],
        || {
            let term = |retardation_time| CreepTerm { compliance: 0.45, retardation_time };
            let material = PlaneMaterial::from_creep(10.0, &[term(1.0), term(1.0 + 1e-15)], None)?;
            Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, constant(1.0))?, ZONE, TOLERANCE)?))
        },
    ));
    cases.push(cliff());
    for (name, motion, fast) in [
        ("Persson and Brener at 1e12 zones per time", Motion::Opening, 1e4),
        ("a constant cohesive stress at 1e12 zones per time", Motion::Opening, 1e4),
    ] {
        let persson = name.starts_with("Persson");
        cases.push(HardCase::new(
            PROBLEM,
            name,
            "the glassy limit of another theory",
            "every theory tends to βΔγ; what is missing goes with vτ/a₀ to the power −1 at least, times β",
            vec![near("G/Δγ", fast, 1e-6)],
            move || {
                let material = PlaneMaterial::standard_solid(1.0, fast, 1.0)?;
                let interface = Interface { process_zone: ProcessZone::Growing { cohesive_stress: 1.0, factor: 1.0 }, ..constant(1.0) };
                let speed = 1e16;
                Ok(reported(&if persson {
                    at_speed(&PerssonBrener::new(&material, motion, interface)?, speed, TOLERANCE)?
                } else {
                    at_speed(&CohesiveZone::new(&material, motion, 1.0, 1.0, CrackBody::AgainstRigid)?, speed, TOLERANCE)?
                }))
            },
        ));
    }
    cases
}

/// The cliff of a closing crack whose zone grows with the remote intensity: parameter z, v and G in closed form.
fn cliff() -> HardCase {
    let (beta, alpha, stress) = (1e6, 1.0, 1.0);
    let interface = Interface { process_zone: ProcessZone::Growing { cohesive_stress: stress, factor: alpha }, ..constant(1.0) };
    // Where d ln G/d ln v is largest, about βz = ln β.
    let z = 14.0 / beta;
    let ratio = one_term(beta, Motion::Closing, z);
    // δ = α a₀ G/Δγ with a₀ = E0Δγ/(πσ_c²) and v = δ/(zτ).
    let speed = alpha * ratio / (std::f64::consts::PI * stress * stress) / z;
    HardCase::new(
        PROBLEM,
        "closing, growing zone, β = 1e6, on the cliff of toughness",
        "d ln G/d ln v is some ten thousand: half an ulp of the speed moves G in its twelfth digit",
        "one term: G and v as functions of the crossing time",
        vec![near("G/Δγ", ratio, 2e-11)],
        move || {
            // Given by its relaxation term: the large parts split exactly.
            let term = RelaxationTerm { modulus: beta - 1.0, relaxation_time: 1.0 / beta };
            let material = PlaneMaterial::from_relaxation(1.0, &[term])?;
            Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Closing, interface)?, speed, TOLERANCE)?))
        },
    )
}

/// Adhesion, zones and moduli at the ends of the doubles; quantities that do not exist.
fn extremes() -> Vec<HardCase> {
    let ratio = one_term(100.0, Motion::Opening, 1.0);
    let scaled = |name: &'static str, modulus: f64, time: f64, work: f64, length: f64| {
        HardCase::new(
            PROBLEM,
            name,
            "magnitudes far from one",
            "G/Δγ depends on β and δ/(vτ) alone",
            vec![near("G/Δγ", ratio, 1e-13)],
            move || {
                let material = PlaneMaterial::standard_solid(modulus, 100.0 * modulus, time)?;
                let interface =
                    Interface { work_of_adhesion: work, process_zone: ProcessZone::Constant { length }, body: CrackBody::TwoHalves };
                Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, interface)?, length / time, TOLERANCE)?))
            },
        )
    };
    vec![
        scaled("a work of adhesion of 1e-300", 1.0, 1.0, 1e-300, 1e-6),
        scaled("a work of adhesion of 1e300", 1.0, 1.0, 1e300, 1e-6),
        scaled("moduli of 1e-150, times of 1e150", 1e-150, 1e150, 1.0, 1.0),
        scaled("moduli of 1e150, zones of 1e-150", 1e150, 1.0, 1.0, 1e-150),
        HardCase::new(
            PROBLEM,
            "a process zone of 5e-324 (subnormal) at 1 m/s",
            "the smallest number there is",
            "δ/(vτ) = 5e-324: glassy",
            vec![near("G/Δγ", 100.0, 1e-14)],
            || {
                let material = PlaneMaterial::standard_solid(1.0, 100.0, 1.0)?;
                let interface = Interface { process_zone: ProcessZone::Constant { length: f64::from_bits(1) }, ..constant(1.0) };
                Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, interface)?, 1.0, TOLERANCE)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a viscous material at rest",
            "it carries no load at rest",
            "no energy release rate far from the tip",
            vec![Expected::Refused(Kind::Undefined)],
            || {
                let material = PlaneMaterial::from_creep(1.0, &[CreepTerm { compliance: 1.0, retardation_time: 1.0 }], Some(10.0))?;
                Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, constant(1.0))?, 0.0, TOLERANCE)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "an opening crack with Schapery's healing zone",
            "the law belongs to the other motion",
            "no such length",
            vec![Expected::Refused(Kind::Undefined)],
            || {
                let material = PlaneMaterial::standard_solid(1.0, 100.0, 1.0)?;
                let interface = Interface { process_zone: ProcessZone::Schapery { cohesive_stress: 1.0, factor: 1.0 }, ..constant(1.0) };
                Ok(reported(&at_speed(&VirtualWork::new(&material, Motion::Opening, interface)?, 1.0, TOLERANCE)?))
            },
        ),
    ]
}
