//! Cracks under load histories of which a time is known.
//!
//! * A constant load: ½cK²J(t_d) = Δγ (5.66) with t_d drawn gives K.
//! * One term, constant load, c = (1 − 1/k)/(1 − 1/β), B = 1/c − 1: dw/dq = [w(q) − w(q − 1)]/c with w = e^{t/τ} has
//!   w = 1 + B e^{q/c} for 0 ≤ q < 1 and w = 1 + B e^{r/c}(e^{1/c} − r/c), r = q − 1, for 1 ≤ q < 2: time and speed at a place that is drawn.
//! * Load cycles from zero: while the tip rests, each term holds a geometric series; the start in a cycle that is drawn gives K.

use super::super::draw::Draw;
use viscotack::crack::delayed::{LoadHistory, LoadSegment, Wave};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// What is known of a history.
#[derive(Debug, Clone)]
pub enum KnownTime {
    /// The tip starts at this time (s).
    Start(f64),
    /// At this time (s) the tip has run so far (m), at this speed (m/s).
    Place {
        /// t.
        time: f64,
        /// x₀.
        growth: f64,
        /// ẋ₀.
        speed: f64,
    },
}

/// A history that is known.
#[derive(Debug, Clone)]
pub struct KnownGrowth {
    /// The plane solid.
    pub material: PlaneMaterial,
    /// Work of adhesion and zone.
    pub interface: Interface,
    /// The load.
    pub history: LoadHistory,
    /// Its time scale: how long it is looked at (s).
    pub until: f64,
    /// What is known.
    pub known: KnownTime,
    /// How it was made.
    pub kind: &'static str,
}

impl KnownGrowth {
    /// In words and numbers.
    #[must_use]
    pub fn described(&self) -> String {
        format!("{}, β {:.4e}, {} terms, {:?}", self.kind, self.material.stiffening_ratio(), self.material.creep_terms().len(), self.known)
    }
}

/// Draws one of the three kinds.
///
/// # Errors
/// Those of making a material or a history.
pub fn known_growth(draw: &mut Draw) -> Result<KnownGrowth, Refusal> {
    match draw.below(4) {
        0 => delay(draw),
        1 | 2 => place(draw),
        _ => cycles(draw),
    }
}

fn interface(draw: &mut Draw) -> Interface {
    Interface {
        work_of_adhesion: draw.log_between(1e-3, 1e3),
        process_zone: ProcessZone::Constant { length: draw.log_between(1e-9, 1e-3) },
        body: if draw.chance(0.5) { CrackBody::AgainstRigid } else { CrackBody::TwoHalves },
    }
}

/// K with ½cK²·compliance = Δγ.
fn load_for(interface: &Interface, compliance: f64) -> f64 {
    (2.0 * interface.work_of_adhesion / (interface.body.deformable_halves() * compliance)).sqrt()
}

fn delay(draw: &mut Draw) -> Result<KnownGrowth, Refusal> {
    let interface = interface(draw);
    let (relaxed, beta) = (draw.log_between(1e2, 1e9), 1.0 + draw.log_between(0.1, 1e4));
    let (longest, decades, terms) = (draw.log_between(1e-6, 1e6), draw.between(0.5, 8.0), 1 + draw.below(8));
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let time = longest * 10f64.powf(draw.between(-decades - 1.0, 0.5));
    // J(t) as it is defined.
    let crept: f64 = material.creep_terms().iter().map(|term| term.compliance * -(-time / term.retardation_time).exp_m1()).sum();
    let load = load_for(&interface, 1.0 / material.glassy_modulus() + crept);
    let history = LoadHistory::constant(load)?;
    Ok(KnownGrowth { material, interface, history, until: 1.5 * time, known: KnownTime::Start(time), kind: "delay under a constant load" })
}

fn place(draw: &mut Draw) -> Result<KnownGrowth, Refusal> {
    let interface = interface(draw);
    let (relaxed, beta) = (draw.log_between(1e2, 1e9), 1.0 + draw.log_between(0.1, 1e3));
    let retardation_time = draw.log_between(1e-6, 1e6);
    let material = PlaneMaterial::standard_solid(relaxed, beta * relaxed, retardation_time)?;
    let c = draw.between(0.08, 0.9);
    // 1 − 1/k = c(1 − 1/β)
    let ratio = 1.0 / (1.0 - c * (1.0 - 1.0 / beta));
    let load = load_for(&interface, 1.0 / (ratio * relaxed));
    let q = draw.between(0.02, 1.95);
    let b = 1.0 / c - 1.0;
    let (w, slope) = if q < 1.0 {
        let growth = b * (q / c).exp();
        (1.0 + growth, growth / c)
    } else {
        let r = q - 1.0;
        let bracket = (1.0 / c).exp() - r / c;
        (1.0 + b * (r / c).exp() * bracket, b * (r / c).exp() * (bracket - 1.0) / c)
    };
    let (time, length) = (retardation_time * w.ln(), zone_length(&interface));
    let speed = length * w / (retardation_time * slope);
    let history = LoadHistory::constant(load)?;
    let known = KnownTime::Place { time, growth: q * length, speed };
    Ok(KnownGrowth { material, interface, history, until: time, known, kind: "place of the tip in its first two zones" })
}

fn zone_length(interface: &Interface) -> f64 {
    match interface.process_zone {
        ProcessZone::Constant { length } => length,
        ProcessZone::Growing { .. } | ProcessZone::Schapery { .. } => f64::NAN,
    }
}

/// What the terms hold at a time after the beginning of load cycles between nothing and one, as long as the tip rests: Σ_j J_j ∫ e^{−(t−t₁)/τ_j}K(t₁)dt₁/τ_j in 1/Pa.
#[must_use]
pub fn held_in_cycles(material: &PlaneMaterial, period: f64, cycle: f64, into: f64) -> f64 {
    material
        .creep_terms()
        .iter()
        .map(|term| {
            let z = period / term.retardation_time;
            let now = -(-into / term.retardation_time).exp_m1();
            // Σ_{m=1}^{N−1} e^{−mz} of the halves before, each (e^{−s/τ})(e^{z/2} − 1).
            let before = if cycle > 1.0 { (-z).exp() * (-(-z * (cycle - 1.0)).exp_m1()) / -(-z).exp_m1() } else { 0.0 };
            term.compliance * (now + (-into / term.retardation_time).exp() * (0.5 * z).exp_m1() * before)
        })
        .sum()
}

fn cycles(draw: &mut Draw) -> Result<KnownGrowth, Refusal> {
    let interface = interface(draw);
    let (relaxed, beta) = (draw.log_between(1e2, 1e9), 1.0 + draw.log_between(0.1, 1e3));
    let (longest, decades, terms) = (draw.log_between(1e-6, 1e6), draw.between(0.1, 2.0), 1 + draw.below(4));
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let cycle = 1.0 + draw.below(12) as f64;
    let period = longest * draw.log_between(0.02, 0.5) / cycle;
    // Late in the half under load: the work at the end of the half before must have been smaller.
    let into = 0.5 * period * draw.between(0.9, 0.99);
    let held = held_in_cycles(&material, period, cycle, into);
    let ended = if cycle > 1.0 { held_in_cycles(&material, period, cycle - 1.0, 0.5 * period) } else { 0.0 };
    if ended >= held {
        return delay(draw);
    }
    let load = load_for(&interface, 1.0 / material.glassy_modulus() + held);
    let wave = LoadSegment::Cycles { count: cycle as u32 + 1, period, lower: 0.0, upper: load, wave: Wave::Square };
    let history = LoadHistory::from_segments(&[wave])?;
    let time = (cycle - 1.0) * period + into;
    Ok(KnownGrowth {
        material,
        interface,
        history,
        until: (cycle - 0.5) * period,
        known: KnownTime::Start(time),
        kind: "start in a load cycle",
    })
}
