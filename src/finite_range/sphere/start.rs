//! The first state of a run.

use std::f64::consts::{FRAC_2_PI, PI};

use super::newton::Row;
use super::problem::{Problem, Shape, Start};
use super::state::State;
use super::step::Solver;
use crate::refusal::Refusal;

/// Voigt elements that are fully relaxed: h/τ without bound.
const RELAXED: f64 = 1e200;
/// Rounds of refinement of a first guess.
const ROUNDS: usize = 40;
/// The mesh reaches so many times the contact radius of the deepest penetration, and at least the outer radius of its fourth root.
const MARGIN: f64 = 1.6;

impl Solver<'_> {
    /// The state in which a run begins.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`] if no equilibrium was found.
    pub(super) fn start(&mut self, problem: &Problem, deepest: f64) -> Result<State, Refusal> {
        let (Start::Relaxed(depth) | Start::Unstrained(depth)) = problem.start;
        let relaxed = matches!(problem.start, Start::Relaxed(_));
        let reach = radius_at_depth(problem.shape, deepest.max(depth).max(1.0));
        let mesh = self.mesher.coarsest(MARGIN * reach);
        let n = mesh.nodes();
        let mut state = State {
            undeformed: mesh.x.iter().map(|&x| self.surface.undeformed(x)).collect(),
            mesh,
            time: 0.0,
            penetration: depth,
            force: 0.0,
            u: vec![0.0; n],
            p: vec![0.0; n],
            strains: vec![vec![0.0; n]; self.chain.terms.len()],
            rate: None,
            work: 0.0,
            viscous: 0.0,
            released: 0.0,
        };
        let modulus = if relaxed { 1.0 } else { self.chain.instant };
        let contact = first_contact(problem.shape, depth, self.coupling * modulus).filter(|_| relaxed || depth > 0.0);
        for _ in 0..ROUNDS {
            state.u = state.mesh.x.iter().map(|&x| self.first_guess(x, problem.shape, depth, contact, modulus)).collect();
            state.p = state.u.iter().map(|&u| self.surface.pressure(u)).collect();
            let flags = self.unresolved(&state);
            match self.refined_if(&state, &flags) {
                Some(finer) => state = finer,
                None => break,
            }
        }
        let z = vec![if relaxed { RELAXED } else { 0.0 }; self.chain.terms.len()];
        let row = Row { penetration: 1.0, force: 0.0, value: depth };
        let settled = self.settle(&state, &z, row);
        settled.ok_or_else(|| Refusal::NotConverged {
            what: "the first state",
            detail: format!("no equilibrium was found at penetration {depth}"),
        })
    }

    /// The unknown on the surface of a JKR contact of radius a; without one, over the undeformed plane.
    fn first_guess(&self, x: f64, shape: Shape, depth: f64, contact: Option<f64>, modulus: f64) -> f64 {
        let coupling = self.coupling * modulus;
        let Some(a) = contact else { return (self.surface.undeformed(x) - depth).max(0.9) };
        let opening = if shape == Shape::Paraboloid { (2.0 * PI * coupling * a).sqrt() } else { 0.0 };
        if x < a {
            let root = (a * a - x * x).sqrt().max(1e-3 * a);
            return self.surface.compressed((FRAC_2_PI * root - opening / (PI * root)) / coupling);
        }
        let (angle, root) = ((a / x).acos(), (x * x - a * a).sqrt());
        let separation =
            if shape == Shape::Paraboloid { ((x * x - 2.0 * a * a) * angle + a * root) / PI } else { shape.height(x) - shape.height(a) };
        self.surface.undeformed(0.0) + separation + FRAC_2_PI * opening * angle
    }
}

/// The radius at which the undeformed tip is as high as a depth.
fn radius_at_depth(shape: Shape, depth: f64) -> f64 {
    match shape {
        Shape::Paraboloid => (2.0 * depth).sqrt(),
        Shape::Power { coefficient, exponent } => (depth / coefficient).powf(1.0 / exponent),
    }
}

/// The radius of the JKR contact at a penetration, the larger one; for other tips that of the overlap. None where there is no contact.
fn first_contact(shape: Shape, depth: f64, coupling: f64) -> Option<f64> {
    let Shape::Paraboloid = shape else { return (depth > 0.0).then(|| 0.8 * radius_at_depth(shape, depth)) };
    // Δ = a² − √(2πma) has its least value where 2a = √(2πm/a)/2.
    let least = (PI * coupling / 8.0).cbrt();
    let excess = |a: f64| a * a - (2.0 * PI * coupling * a).sqrt() - depth;
    if excess(least) > 0.0 {
        return None;
    }
    let (mut low, mut high) = (least, 2.0 * (depth.abs().sqrt() + least) + (2.0 * PI * coupling).powf(0.4) * 2.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    Some(high)
}
