//! Random materials, speeds and adhesion, and what is held: mostly near a limit.

use super::stability::Held;
use super::states::{Reached, Speed};
use super::width::Bodies;
use crate::studies::draw::Draw;
use std::f64::consts::PI;
use std::sync::Arc;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactMemory, Indenter, Resolution};
use viscotack::sliding::edge_balance::WaveAdhesion;

/// Half-widths of a scan before it is made finer.
const ROWS: usize = 100;
/// Nearest distance to a limit, over the size of the limit.
const NEAREST: f64 = 1e-4;
/// Half of the narrowest gap of a held half-width: in a narrower one the eccentricity is lost in rounding.
const NARROWEST: f64 = 0.05;
/// How far beyond a limit loads go, over the size of the limit.
const BEYOND: f64 = 0.1;

/// Everything but what is held.
#[derive(Debug)]
pub struct Drawn {
    /// The material.
    pub material: PlaneMaterial,
    /// kv.
    pub rate: f64,
    /// Wave or cylinder.
    pub indenter: Indenter,
    /// Its adhesion.
    pub adhesion: Option<WaveAdhesion>,
    /// In words.
    pub described: String,
}

/// What is held, in the words of the study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// Mean pressure of a wave.
    MeanPressure,
    /// Load of a cylinder.
    LoadPerWidth,
    /// Penetration of a wave.
    Penetration,
    /// Half-width of either.
    HalfWidth,
}

/// All of them, with their names.
pub const CONTROLS: [(Control, &str); 4] = [
    (Control::MeanPressure, "mean_pressure"),
    (Control::LoadPerWidth, "load_per_width"),
    (Control::Penetration, "penetration"),
    (Control::HalfWidth, "half_width"),
];

/// A state that is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// What is held.
    pub control: Control,
    /// Its value.
    pub value: f64,
    /// How it was reached.
    pub reached: Reached,
}

/// A problem.
///
/// # Errors
/// Those of making a material.
pub fn drawn(draw: &mut Draw) -> Result<Drawn, Refusal> {
    let (beta, terms) = (draw.log_between(1.2, 1000.0), 1 + draw.below(6));
    let (relaxed, longest, decades) = (draw.log_between(1e3, 1e9), draw.log_between(1e-4, 1e4), draw.between(0.3, 6.0));
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let ratio = draw.log_between(1e-3, 1e4);
    let slowest = material.longest_retardation_time().unwrap_or(longest);
    let indenter = if draw.chance(0.8) { Indenter::Wave } else { Indenter::Parabola };
    let (work, zone) = (draw.log_between(3e-4, 0.05), draw.log_between(1e-5, 0.05));
    let leading_work = if draw.chance(0.3) { work * draw.log_between(0.2, 1.0) } else { work };
    let leading_zone = if draw.chance(0.2) { zone * draw.log_between(0.3, 1.0) } else { zone };
    let adhesion = draw.chance(0.9).then_some(WaveAdhesion { trailing_work: work, leading_work, trailing_zone: zone, leading_zone });
    let described = format!(
        "{indenter:?} β {beta:.6} ({terms} terms) ζ {ratio:.4e} {}",
        adhesion.map_or_else(
            || "no adhesion".into(),
            |it| format!("Γ {:.6} {:.6} δ {:.3e} {:.3e}", it.trailing_work, it.leading_work, it.trailing_zone, it.leading_zone)
        )
    );
    Ok(Drawn { material, rate: ratio / slowest, indenter, adhesion, described })
}

impl Drawn {
    /// All contacts of it.
    ///
    /// # Errors
    /// Those of the scan.
    pub fn speed(&self) -> Result<Speed, Refusal> {
        let memory = Arc::new(ContactMemory::new(&self.material, self.rate)?);
        let at = |resolution: Resolution| Bodies::new(Arc::clone(&memory), self.indenter, self.adhesion, resolution);
        Speed::new(at(Resolution::Medium), at(Resolution::Finest), ROWS, self.indenter == Indenter::Wave)
    }
}

/// A state of a problem: none if it has no stable contact to start from.
pub fn asked(draw: &mut Draw, speed: &Speed) -> Option<Asked> {
    let wave = speed.bodies.indenter == Indenter::Wave;
    let reached = if draw.chance(0.7) { Reached::Loading } else { Reached::Unloading };
    let part = draw.unit();
    if speed.by_load.is_empty() {
        // Nothing is stable at this speed, whatever is held.
        let control = if wave { Control::MeanPressure } else { Control::LoadPerWidth };
        return Some(Asked { control, value: draw.between(-0.3, 0.5), reached });
    }
    if part < 0.2 {
        let stable = speed.by_load.get(draw.below(speed.by_load.len()))?;
        let (first, last) = (stable.contacts.first()?, stable.contacts.last()?);
        let half_width = draw.between(0.9 * first.half_width, 1.05 * last.half_width);
        let value = if wave { half_width.min(PI - NARROWEST) } else { half_width };
        return Some(Asked { control: Control::HalfWidth, value, reached });
    }
    let (held, control) = match (wave, part < 0.45) {
        (true, true) => (Held::Penetration, Control::Penetration),
        (true, false) => (Held::Load, Control::MeanPressure),
        (false, _) => (Held::Load, Control::LoadPerWidth),
    };
    let limits = speed.limits(held);
    let [low, high] = *limits.get(draw.below(limits.len()))?;
    let value = if draw.chance(0.3) {
        draw.between(low, high + BEYOND * high.abs())
    } else {
        let (limit, inward) = if draw.chance(0.5) { (low, 1.0) } else { (high, -1.0) };
        let size = limit.abs().max(1e-3 * (high - low));
        if draw.chance(0.8) {
            limit + inward * draw.log_between(NEAREST * size, 0.5 * (high - low).max(2.0 * NEAREST * size))
        } else {
            limit - inward * draw.log_between(NEAREST * size, BEYOND * size)
        }
    };
    Some(Asked { control, value, reached })
}
