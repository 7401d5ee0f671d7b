//! A sliding contact at any speed, reached from the slow one.
//!
//! At a sliding ratio far below the process zone the contact is that of the relaxed solid, Johnson's wave in closed form, of which the branch
//! with dp̄/da > 0 is taken. From there the speed is raised in steps, each contact being the start of the next (with secant prediction in ln
//! speed). A step whose contact is far from the prediction is a jump to another root: it is refused and halved, not accepted.

use super::adhesiveless::{AdhesivelessContact, adhesiveless};
use super::contact::{ContactMemory, Prescribed, WaveContact};
use super::equilibrium::{Equilibrium, WaveAdhesion, equilibrium};
use crate::elastic::johnson_wave::WaveBranch;
use crate::elastic::{EquilibriumBranch, JohnsonWave, WestergaardWave};
use crate::material::Material;
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

/// The longest step in ln speed.
const LONGEST_STEP: f64 = 1.0;
/// The step that is tried first.
const FIRST_STEP: f64 = 0.35;
/// A path whose steps fall below this has met a fold.
const SHORTEST_STEP: f64 = 1e-5;
/// The start: slowest sliding ratio over the smaller process zone.
const SLOW: f64 = 0.1;
/// Largest distance of a contact from its prediction, in units of the smaller of a and π − a.
const JUMP: f64 = 0.15;

/// A contact on the path, and what the path took.
#[derive(Debug, Clone, PartialEq)]
pub struct OnPath<T> {
    /// The contact at the speed that was asked for.
    pub contact: T,
    /// Contacts on the way.
    pub steps: u32,
    /// Evaluations of both edge conditions on the way.
    pub evaluations: u32,
}

/// The adhesive contact at a rate kv > 0 (1/s).
///
/// # Errors
/// [`Refusal::NoSuchState`] from the elastic wave (above snap-in, below pull-off), or where the path ends at a fold, with the last rate reached.
pub fn adhesive_contact(
    material: &Material,
    rate: f64,
    adhesion: &WaveAdhesion,
    prescribed: Prescribed,
    tolerance: f64,
) -> Result<OnPath<Equilibrium>, Refusal> {
    let half_width = relaxed_half_width(prescribed, adhesion.reduced_work)?;
    let zone = adhesion.trailing_zone.min(adhesion.leading_zone);
    follow(material, rate, zone, half_width, |memory, start| {
        let found = equilibrium(memory, adhesion, prescribed, start, tolerance)?;
        Ok((found.state.contact(), found.evaluations, found))
    })
}

/// The adhesiveless contact at a rate kv > 0 (1/s).
///
/// # Errors
/// As [`adhesive_contact`].
pub fn adhesiveless_contact(
    material: &Material,
    rate: f64,
    prescribed: Prescribed,
    tolerance: f64,
) -> Result<OnPath<AdhesivelessContact>, Refusal> {
    let wave = unit_wave()?;
    let relaxed = match prescribed {
        Prescribed::MeanPressure(pressure) => wave.state_by_mean_pressure(0.5 * pressure)?,
        Prescribed::Penetration(penetration) => wave.state_by_penetration(penetration)?,
    };
    follow(material, rate, 1e-2, relaxed.contact_half_width, |memory, start| {
        let found = adhesiveless(memory, prescribed, start, tolerance)?;
        Ok((found.state.contact(), found.evaluations, found))
    })
}

/// The friction stress of full contact, ½ Im E(kv)/E0, in E0*k²Λ²/2: half the loss of the first harmonic, whatever the adhesion.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a rate that is not positive; [`Refusal::Undefined`] for a viscous material.
pub fn full_contact_friction(material: &Material, rate: f64) -> Result<f64, Refusal> {
    let relaxed = material.solid_modulus("the friction of a full contact in units of E0")?;
    Ok(0.5 * material.complex_modulus(require_positive("rate", rate)?)?.loss / relaxed)
}

/// E* = k = Λ = 1: pressures come in units of E0*kΛ, penetrations in Λ.
fn unit_wave() -> Result<WestergaardWave, Refusal> {
    WestergaardWave::new(1.0, 2.0 * PI, 1.0)
}

fn relaxed_half_width(prescribed: Prescribed, reduced_work: f64) -> Result<f64, Refusal> {
    let wave = JohnsonWave::new(unit_wave()?, PI * reduced_work)?;
    Ok(match prescribed {
        Prescribed::MeanPressure(pressure) => wave.state_by_mean_pressure(0.5 * pressure, WaveBranch::Stable)?,
        Prescribed::Penetration(penetration) => wave.state_by_penetration(penetration, EquilibriumBranch::Stable)?,
    }
    .contact_half_width)
}

/// Raises the rate from the slow limit; `solve` gives the contact near a start.
fn follow<T>(
    material: &Material,
    rate: f64,
    zone: f64,
    half_width: f64,
    solve: impl Fn(&ContactMemory, WaveContact) -> Result<(WaveContact, u32, T), Refusal>,
) -> Result<OnPath<T>, Refusal> {
    require_positive("rate", rate)?;
    let start = WaveContact { half_width, eccentricity: 0.0 };
    let slow = material.longest_retardation_time().map_or(rate, |time| (SLOW * zone / time).min(rate));
    let mut evaluations = 0;
    let mut at = |log_rate: f64, start: WaveContact| -> Result<(WaveContact, T), Refusal> {
        let (contact, spent, found) = solve(&ContactMemory::new(material, log_rate.exp())?, start)?;
        evaluations += spent;
        Ok((contact, found))
    };
    let (target, mut log_rate) = (rate.ln(), slow.ln());
    let (mut here, mut found) = at(log_rate, start)?;
    let mut before: Option<(f64, WaveContact)> = None;
    let (mut step, mut steps) = (FIRST_STEP, 1);
    while log_rate < target {
        let next = if target - log_rate <= step { target } else { log_rate + step };
        let predicted = before.map_or(here, |(then, there)| {
            let part = (next - log_rate) / (log_rate - then);
            WaveContact {
                half_width: here.half_width + part * (here.half_width - there.half_width),
                eccentricity: here.eccentricity + part * (here.eccentricity - there.eccentricity),
            }
        });
        let room = JUMP * here.half_width.min(PI - here.half_width);
        let near = |contact: &WaveContact| {
            (contact.half_width - predicted.half_width).abs() < room && (contact.eccentricity - predicted.eccentricity).abs() < room
        };
        match at(next, predicted) {
            Ok((contact, solved)) if near(&contact) => {
                before = Some((log_rate, here));
                (log_rate, here, found) = (next, contact, solved);
                steps += 1;
                step = (1.4 * step).min(LONGEST_STEP);
            }
            _ => {
                step *= 0.5;
                if step < SHORTEST_STEP {
                    return Err(Refusal::NoSuchState {
                        reason: "the contact that grows out of the slow one ends at a fold before this speed".into(),
                        limit_name: "rate kv (1/s)",
                        limit: log_rate.exp(),
                    });
                }
            }
        }
    }
    Ok(OnPath { contact: found, steps, evaluations })
}
