//! The contact of an elastic solid, from which paths in speed start: the relaxed one at vanishing, the glassy one at infinite speed.
//!
//! With the modulus m (1 or β) in units of E0, in reduced quantities:
//! ```text
//! wave        p̄ = m s² − 2√(mΓ tan(a/2)),    Δ = s²(1 − 2 ln s) + 4√(Γ tan(a/2)/m) ln s       s = sin(a/2)
//! parabola    p̄ = m a²/4 − √(2mΓa)
//! ```
//! Different works at the two edges have forms of their own ([`super::uneven_start`]). Of the equilibria at one load the one with dp̄/da > 0 is taken. Source: Johnson 1995 and Westergaard as in [`crate::elastic`]; the parabola is
//! their limit for narrow contacts, the adhesive cylinder of Barquins.

use super::problem::SlidingProblem;
use super::uneven_start::{is_uneven_wave, mean_work, uneven_parabola_shift, uneven_unknowns};
use crate::continuation::root::{LogSlope, increasing_root};
use crate::elastic::johnson_wave::{PARTIAL_CONTACT_LIMIT, WaveBranch};
use crate::elastic::{EquilibriumBranch, JohnsonWave, WestergaardWave};
use crate::refusal::Refusal;
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::{SlidingControl, WaveAdhesion};
use std::f64::consts::PI;

/// The half-width of the elastic contact of a modulus m = E/E0, or the mean pressure if the half-width is prescribed; and the eccentricity.
///
/// # Errors
/// [`Refusal::NoSuchState`] above snap-in and below pull-off, with that limit in units of the problem.
pub(super) fn elastic_unknowns(problem: &SlidingProblem<'_>, adhesion: Option<WaveAdhesion>, modulus: f64) -> Result<[f64; 2], Refusal> {
    if let Some(adhesion) = is_uneven_wave(problem, adhesion) {
        return uneven_unknowns(problem, adhesion, modulus);
    }
    let first = elastic_unknown(problem, adhesion.map_or(0.0, mean_work), modulus)?;
    let half_width = if let SlidingControl::HalfWidth(half_width) = problem.control { half_width } else { first };
    let uneven = adhesion.filter(|adhesion| !adhesion.is_even());
    Ok([first, uneven.map_or(0.0, |adhesion| uneven_parabola_shift(adhesion, half_width, modulus))])
}

/// The first of both, at equal works.
fn elastic_unknown(problem: &SlidingProblem<'_>, work: f64, modulus: f64) -> Result<f64, Refusal> {
    match (problem.indenter, problem.control) {
        (Indenter::Wave, SlidingControl::HalfWidth(half_width)) => {
            let sine = (0.5 * half_width).sin();
            Ok(modulus * sine * sine - 2.0 * (modulus * work * (0.5 * half_width).tan()).sqrt())
        }
        (Indenter::Parabola, SlidingControl::HalfWidth(half_width)) => {
            Ok(0.25 * modulus * half_width * half_width - (2.0 * modulus * work * half_width).sqrt())
        }
        (Indenter::Parabola, SlidingControl::MeanPressure(pressure)) => {
            parabola(pressure / modulus, work / modulus).map_err(|limit| Refusal::NoSuchState {
                reason: "the load pulls harder than an elastic contact at rest can hold".into(),
                limit_name: "pull-off mean pressure",
                limit: limit * modulus,
            })?
        }
        (Indenter::Parabola, SlidingControl::Penetration(_)) => Err(Refusal::Undefined {
            quantity: "the penetration of a cylinder",
            reason: "a line load sinks into a half-plane without bound".into(),
        }),
        (Indenter::Wave, SlidingControl::Penetration(penetration)) if penetration >= 1.0 => Err(Refusal::NoSuchState {
            reason: "the wave is in full contact".into(),
            limit_name: "the penetration of full contact",
            limit: 1.0,
        }),
        (Indenter::Wave, control) => {
            // E* = k = Λ = 1: pressures come in units of E0*kΛ, penetrations in Λ.
            let wave = WestergaardWave::new(1.0, 2.0 * PI, 1.0)?;
            let adhesive = (work > 0.0).then(|| JohnsonWave::new(wave, PI * work / modulus)).transpose()?;
            let state = match (control, adhesive) {
                // Every partial contact is unstable, and under no pull there is none.
                (SlidingControl::MeanPressure(pressure), Some(wave)) if wave.adhesion_parameter() >= PARTIAL_CONTACT_LIMIT => {
                    let (limit_name, limit) = if pressure >= 0.0 {
                        ("the mean pressure of the last partial contact", 0.0)
                    } else {
                        ("Johnson's adhesion parameter from which on no partial contact is stable", PARTIAL_CONTACT_LIMIT)
                    };
                    let reason = "adhesion is so strong that every partial contact of the elastic wave is unstable".into();
                    return Err(Refusal::NoSuchState { reason, limit_name, limit });
                }
                (SlidingControl::MeanPressure(pressure), Some(wave)) => {
                    wave.state_by_mean_pressure(0.5 * pressure / modulus, WaveBranch::Stable)
                }
                (SlidingControl::MeanPressure(pressure), None) => wave.state_by_mean_pressure(0.5 * pressure / modulus),
                (SlidingControl::Penetration(penetration), Some(wave)) => wave.state_by_penetration(penetration, EquilibriumBranch::Stable),
                (SlidingControl::Penetration(penetration), None) => wave.state_by_penetration(penetration),
                (SlidingControl::HalfWidth(half_width), _) => wave.state_by_contact_half_width(half_width),
            };
            let unit = if matches!(control, SlidingControl::MeanPressure(_)) { 2.0 * modulus } else { 1.0 };
            match state {
                Ok(state) if state.is_full_contact() => Err(Refusal::NoSuchState {
                    reason: "the wave is in full contact".into(),
                    limit_name: "the mean pressure of full contact",
                    limit: modulus,
                }),
                Ok(state) => Ok(state.contact_half_width),
                // The sentence of the elastic wave holds numbers in its own units.
                Err(Refusal::NoSuchState { limit_name, limit, .. }) => Err(Refusal::NoSuchState {
                    reason: "an elastic contact at rest has no equilibrium there".into(),
                    limit_name,
                    limit: limit * unit,
                }),
                Err(refusal) => Err(refusal),
            }
        }
    }
}

/// The stable half-width at p̄/m and Γ/m, or the pull-off pressure over m.
fn parabola(pressure: f64, work: f64) -> Result<Result<f64, Refusal>, f64> {
    if work == 0.0 {
        return Ok(Ok(2.0 * pressure.sqrt()));
    }
    // dp̄/da = 0 at a³ = 2Γ, where p̄ = −¾a².
    let narrowest = (2.0 * work).cbrt();
    let pull_off = -0.75 * narrowest * narrowest;
    if pressure <= pull_off {
        return Err(pull_off);
    }
    let function = |half_width: f64| {
        let (press, pull) = (0.25 * half_width * half_width, (2.0 * work * half_width).sqrt());
        LogSlope { value: press - pull - pressure, slope: 2.0 * press - 0.5 * pull }
    };
    // There a²/4 exceeds both what presses and what pulls.
    let widest = 4.0 * narrowest + 4.0 * pressure.abs().sqrt();
    Ok(increasing_root("half_width", function, [narrowest, widest], widest, 1e-14).map(|root| root.argument))
}
