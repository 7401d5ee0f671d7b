//! The first state of a run.

use std::f64::consts::{FRAC_2_PI, PI};

use super::newton::Row;
use super::problem::{Control, Problem, Shape, Start};
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
        let (control, value, relaxed) = match problem.start {
            Start::Relaxed(depth) => (Control::Penetration, depth, true),
            Start::Unstrained(depth) => (Control::Penetration, depth, false),
            Start::Held { control, value, relaxed } => (control, value, relaxed),
        };
        let modulus = if relaxed { 1.0 } else { self.chain.instant };
        let (of_depth, of_force) = control.factors();
        let row = Row { penetration: of_depth, force: of_force, value };
        let depth = first_depth(problem.shape, row, self.coupling * modulus);
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
        let contact = first_contact(problem.shape, depth, self.coupling * modulus).filter(|_| relaxed || depth > 0.0 || of_force > 0.0);
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
        let settled = self.settle(&state, &z, row);
        settled.ok_or_else(|| Refusal::NotConverged {
            what: "the first state",
            detail: format!(
                "no equilibrium was found where {} = {value}",
                match control {
                    Control::Penetration => "the penetration",
                    Control::Force => "the force",
                    Control::Frame(_) => "the travel of the frame",
                }
            ),
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

/// The penetration at which a JKR contact (of other tips one without adhesion, roughly) has a value of what is imposed.
fn first_depth(shape: Shape, row: Row, coupling: f64) -> f64 {
    if row.force == 0.0 {
        return row.value / row.penetration;
    }
    let state = |a: f64| match shape {
        Shape::Paraboloid => {
            (a * a - (2.0 * PI * coupling * a).sqrt(), 4.0 / 3.0 * a.powi(3) / coupling - (8.0 * PI * a.powi(3) / coupling).sqrt())
        }
        Shape::Power { .. } => (1.2 * shape.height(a), 1.5 * a * shape.height(a) / coupling),
    };
    let imposed = |a: f64| row.penetration * state(a).0 + row.force * state(a).1 - row.value;
    // The radius at which the force is least is that of 1.5π.
    let least = if shape == Shape::Paraboloid { (9.0 * PI * coupling / 8.0).cbrt() } else { 1e-6 };
    let (mut low, mut high) = (least, 2.0 * least.max(1.0));
    while imposed(high) < 0.0 && high < 1e150 {
        high *= 2.0;
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if imposed(middle) < 0.0 { low = middle } else { high = middle }
    }
    state(low).0
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
