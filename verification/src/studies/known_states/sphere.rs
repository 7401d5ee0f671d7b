//! Spheres whose contact is known.
//!
//! * At rest: a and Δ are drawn, and Δγ is the work of the textbook fields of an elastic sphere (Sneddon; Johnson 1985, Secs 3.4 and 4.2),
//!   p = (2E*/πR)√(a² − r²) + (E*/π)(Δ − a²/R)/√(a² − r²),  w = [(2a² − r²)asin(a/r) + a√(r² − a²)]/(πR) + (2/π)(Δ − a²/R)asin(a/r),
//!   over the process zone: relaxed contacts, and the glassy one of first touch (Δ = 0).
//! * Without adhesion: Lee and Radok's force of a ramp of depth and a hold, whose integrals are Dawson's function,
//!   F = (4/3)√R∫R(t − t′)dΔ^{3/2} = (4/3)√R Δ^{3/2}[E0* + Σ E_i (3/2z_i)(1 − D(√z_i)/√z_i)] at the end of a ramp of duration t = z_iρ_i.

use super::super::draw::Draw;
use super::zone_work;
use std::f64::consts::PI;
use viscotack::indentation::{Adhesion, Controlled, History, IndentationProblem, Profile};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::special::dawson::dawson_relative_deficit;

/// A contact that is known.
#[derive(Debug, Clone)]
pub struct KnownSphere {
    /// The solid, in moduli E*.
    pub material: PlaneMaterial,
    /// What is asked.
    pub problem: IndentationProblem,
    /// At kept instants: place among them, then Δ (m), F (N), a (m).
    pub instants: Vec<(usize, [f64; 3])>,
    /// What errors of these three are relative to: the terms that they are differences of.
    pub scales: [f64; 3],
    /// How it was made.
    pub kind: &'static str,
}

impl KnownSphere {
    /// In words and numbers.
    #[must_use]
    pub fn described(&self) -> String {
        format!("{}, β {:.4}, {:?}, {:?}", self.kind, self.material.stiffening_ratio(), self.problem.adhesion, self.instants.first())
    }
}

/// (1/2δ)∫ tension·gap of a sphere of radius R on an elastic half-space of modulus E* with contact radius a and depth Δ: the work of adhesion that holds it.
#[must_use]
pub fn elastic_work(radius: f64, modulus: f64, a: f64, depth: f64, zone: f64) -> f64 {
    let excess = depth - a * a / radius;
    zone_work(
        zone,
        zone,
        |inside| {
            let root = (inside * (2.0 * a - inside)).sqrt();
            -(2.0 * modulus / (PI * radius) * root + modulus / PI * excess / root)
        },
        |outside| {
            let r = a + outside;
            let sine = (a / r).asin();
            let root = (outside * (2.0 * a + outside)).sqrt();
            let surface = ((2.0 * a * a - r * r) * sine + a * root) / (PI * radius) + 2.0 / PI * excess * sine;
            surface - (depth - 0.5 * r * r / radius)
        },
    )
}

/// F = 2E*aΔ − (2/3)E*a³/R.
fn elastic_force(radius: f64, modulus: f64, a: f64, depth: f64) -> f64 {
    2.0 * modulus * a * depth - 2.0 / 3.0 * modulus * a * a * a / radius
}

/// Δ, F and a as sums of terms of the size of the flat and of the round part.
fn scales(radius: f64, modulus: f64, a: f64) -> [f64; 3] {
    [a * a / radius, 2.0 * modulus * a * a * a / radius, a]
}

/// Draws one of the three kinds.
///
/// # Errors
/// Those of making a material.
pub fn known_sphere(draw: &mut Draw) -> Result<KnownSphere, Refusal> {
    match draw.below(3) {
        0 => relaxed(draw),
        1 => touched(draw),
        _ => without_adhesion(draw),
    }
}

fn solid(draw: &mut Draw) -> Result<(PlaneMaterial, f64, f64), Refusal> {
    let (relaxed, beta) = (draw.log_between(1e-2, 1e8), draw.log_between(1.2, 300.0));
    let (longest, decades, terms) = (draw.log_between(1e-4, 1e4), draw.between(0.5, 4.0), 1 + draw.below(4));
    Ok((draw.solid(relaxed, beta, longest, terms, decades)?, relaxed, longest))
}

/// A contact at rest under depth, force or frame: nothing may move.
fn relaxed(draw: &mut Draw) -> Result<KnownSphere, Refusal> {
    let (material, _, longest) = solid(draw)?;
    let modulus = material.relaxed_modulus();
    let radius = draw.log_between(1e-6, 1e2);
    let a = radius * draw.log_between(1e-3, 0.3);
    let zone = a * draw.log_between(3e-3, 0.08);
    // √(2πaΔγ/E*)·R/a²: the contact comes off at 4 under a held depth, at 4/3 under a held force.
    let control = draw.below(3);
    let part = draw.between(0.05, if control == 0 { 2.5 } else { 0.9 });
    let depth = a * a / radius * (1.0 - part);
    let force = elastic_force(radius, modulus, a, depth);
    let work_of_adhesion = elastic_work(radius, modulus, a, depth, zone);
    let stiffness = modulus * a * draw.log_between(0.3, 30.0);
    let hold = longest * draw.log_between(1e-2, 1e2);
    let history = match control {
        0 => History::penetration(depth),
        1 => History::force(force),
        _ => History::frame(depth + force / stiffness),
    };
    let mut problem = IndentationProblem::new(
        Profile::Paraboloid { radius },
        Some(Adhesion { work_of_adhesion, process_zone: zone }),
        history.hold(hold),
    )
    .relaxed();
    problem.frame_stiffness = Some(stiffness);
    let state = [depth, force, a];
    Ok(KnownSphere {
        material,
        problem,
        instants: vec![(0, state), (1, state)],
        scales: scales(radius, modulus, a),
        kind: "relaxed and held",
    })
}

/// First touch: glassy, at no depth.
fn touched(draw: &mut Draw) -> Result<KnownSphere, Refusal> {
    let (material, _, longest) = solid(draw)?;
    let modulus = material.glassy_modulus();
    let radius = draw.log_between(1e-6, 1e2);
    let a = radius * draw.log_between(1e-3, 0.3);
    let zone = a * draw.log_between(3e-3, 0.08);
    let work_of_adhesion = elastic_work(radius, modulus, a, 0.0, zone);
    let history = History::penetration(0.0).hold(1e-3 * longest * draw.unit());
    let problem = IndentationProblem::new(Profile::Paraboloid { radius }, Some(Adhesion { work_of_adhesion, process_zone: zone }), history);
    let state = [0.0, elastic_force(radius, modulus, a, 0.0), a];
    Ok(KnownSphere { material, problem, instants: vec![(0, state)], scales: scales(radius, modulus, a), kind: "first touch" })
}

/// The share of a term that is left at the end of a ramp of depth, (3/2z)(1 − D(√z)/√z).
fn left_after_ramp(z: f64) -> f64 {
    let root = z.sqrt();
    1.5 / z * dawson_relative_deficit(root)
}

fn without_adhesion(draw: &mut Draw) -> Result<KnownSphere, Refusal> {
    let (material, _, longest) = solid(draw)?;
    let radius = draw.log_between(1e-6, 1e2);
    let depth = radius * draw.log_between(1e-6, 0.05);
    let (ramp, hold) = (longest * draw.log_between(1e-4, 1e3), longest * draw.log_between(1e-3, 1e2));
    let hertz = 4.0 / 3.0 * radius.sqrt() * depth * depth.sqrt();
    let force = |held: f64| {
        let terms = material.relaxation_terms().iter();
        let left: f64 =
            terms.map(|term| term.modulus * left_after_ramp(ramp / term.relaxation_time) * (-held / term.relaxation_time).exp()).sum();
        hertz * (material.relaxed_modulus() + left)
    };
    let a = (radius * depth).sqrt();
    let history = History::from(Controlled::Penetration, 0.0).ramp(depth, ramp).hold(hold);
    let problem = IndentationProblem::new(Profile::Paraboloid { radius }, None, history);
    let instants = vec![(1, [depth, force(0.0), a]), (2, [depth, force(hold), a])];
    let scales = [depth, force(0.0), a];
    Ok(KnownSphere { material, problem, instants, scales, kind: "pressed in and held, without adhesion" })
}
