//! The first state of a run.

use spec_math::Gamma;
use std::f64::consts::{FRAC_2_PI, PI};
use std::sync::Arc;

use super::mesh::{Cell, Mesher};
use super::newton::Row;
use super::problem::{Control, Problem, Shape, Start};
use super::state::State;
use super::step::Solver;
use crate::refusal::Refusal;

/// Voigt elements that are fully relaxed: h/τ without bound.
const RELAXED: f64 = 1e200;
/// Rounds of refinement of a first guess.
const ROUNDS: usize = 40;
/// The mesh tolerance of a first guess, at least: its edge is sharper than that of the state.
const OF_A_GUESS: f64 = 0.1;
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
        let deepest = deepest.max(depth).max(1.0);
        let reach = radius_at_depth(problem.shape, deepest).max(first_contact(problem.shape, deepest, self.coupling).unwrap_or(0.0));
        let contact = first_contact(problem.shape, depth, self.coupling * modulus).filter(|_| relaxed || depth > 0.0 || of_force > 0.0);
        let mut cells = Mesher::coarsest(MARGIN * reach);
        let tolerance = self.accuracy.mesh;
        self.accuracy.mesh = tolerance.max(OF_A_GUESS);
        let mut state = self.guessed(problem.shape, depth, contact, modulus, cells.clone());
        for _ in 0..ROUNDS {
            let finer = Mesher::halved(&cells, &self.unresolved(&state));
            if finer == cells || finer.len() * self.mesher.order() > self.accuracy.most_nodes {
                break;
            }
            cells = finer;
            state = self.guessed(problem.shape, depth, contact, modulus, cells.clone());
        }
        // A guess that no mesh resolves is a guess as well.
        state.mesh = self.mesher.build(cells);
        self.accuracy.mesh = tolerance;
        let z = vec![if relaxed { RELAXED } else { 0.0 }; self.chain.terms.len()];
        let settled = self.settle(&state, &z, row);
        self.fine_enough(0.0)?;
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

    /// The first guess on these elements, without their influence matrix.
    fn guessed(&mut self, shape: Shape, depth: f64, contact: Option<f64>, modulus: f64, cells: Vec<Cell>) -> State {
        let mesh = self.mesher.outline(cells);
        let u: Vec<f64> = mesh.x.iter().map(|&x| self.first_guess(x, shape, depth, contact, modulus)).collect();
        State {
            undeformed: mesh.x.iter().map(|&x| self.surface.undeformed(x)).collect(),
            p: u.iter().map(|&u| self.surface.pressure(u)).collect(),
            strains: vec![vec![0.0; mesh.nodes()]; self.chain.terms.len()],
            mesh: Arc::new(mesh),
            time: 0.0,
            penetration: depth,
            force: 0.0,
            u,
            rate: None,
            work: 0.0,
            viscous: 0.0,
            released: 0.0,
        }
    }

    /// The unknown on the surface of a JKR contact of radius a; without one, over the undeformed plane.
    fn first_guess(&self, x: f64, shape: Shape, depth: f64, contact: Option<f64>, modulus: f64) -> f64 {
        let coupling = self.coupling * modulus;
        let Some(a) = contact else { return (self.surface.undeformed(x) - depth).max(0.9) };
        let opening = (2.0 * PI * coupling * a).sqrt();
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

/// The contact of zero range on a tip of height c·x^n: Δ = κa^n − √(2πma), F = 2n/(n+1)·κa^{n+1}/m − √(8πa³/m), with κ by Sneddon (1965).
struct ZeroRange {
    factor: f64,
    exponent: f64,
    coupling: f64,
}

impl ZeroRange {
    fn new(shape: Shape, coupling: f64) -> Self {
        let (coefficient, exponent) = match shape {
            Shape::Paraboloid => (0.5, 2.0),
            Shape::Power { coefficient, exponent } => (coefficient, exponent),
        };
        let gammas = Gamma::gamma(&(0.5 * exponent + 1.0)) / Gamma::gamma(&(0.5 * exponent + 0.5));
        Self { factor: coefficient * PI.sqrt() * gammas, exponent, coupling }
    }

    /// The radius at which the penetration is least, times this power of three.
    fn least(&self, threefold: bool) -> f64 {
        let slope = (2.0 * PI * self.coupling).sqrt() / (2.0 * self.exponent * self.factor);
        (if threefold { 3.0 * slope } else { slope }).powf(1.0 / (self.exponent - 0.5))
    }

    fn penetration(&self, a: f64) -> f64 {
        self.factor * a.powf(self.exponent) - (2.0 * PI * self.coupling * a).sqrt()
    }

    fn force(&self, a: f64) -> f64 {
        let n = self.exponent;
        2.0 * n / (n + 1.0) * self.factor * a.powf(n + 1.0) / self.coupling - (8.0 * PI * a.powi(3) / self.coupling).sqrt()
    }

    /// The radius, from `least` up, at which a rising quantity is zero; `least` if it is positive there.
    fn radius(least: f64, rising: impl Fn(f64) -> f64) -> f64 {
        let (mut low, mut high) = (least, 2.0 * least.max(1.0));
        while rising(high) < 0.0 && high < 1e100 {
            high *= 2.0;
        }
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if rising(middle) < 0.0 { low = middle } else { high = middle }
        }
        low
    }
}

/// The penetration at which a contact of zero range has a value of what is imposed.
fn first_depth(shape: Shape, row: Row, coupling: f64) -> f64 {
    if row.force == 0.0 {
        return row.value / row.penetration;
    }
    let contact = ZeroRange::new(shape, coupling);
    // The force is least at a larger radius than the penetration: there the slope of one is three times that of the other.
    let imposed = |a: f64| row.penetration * contact.penetration(a) + row.force * contact.force(a) - row.value;
    contact.penetration(ZeroRange::radius(contact.least(true), imposed))
}

/// The radius at which the undeformed tip is as high as a depth.
fn radius_at_depth(shape: Shape, depth: f64) -> f64 {
    match shape {
        Shape::Paraboloid => (2.0 * depth).sqrt(),
        Shape::Power { coefficient, exponent } => (depth / coefficient).powf(1.0 / exponent),
    }
}

/// The radius of the contact of zero range at a penetration, the larger one. None where there is no contact.
fn first_contact(shape: Shape, depth: f64, coupling: f64) -> Option<f64> {
    let contact = ZeroRange::new(shape, coupling);
    let least = contact.least(false);
    (contact.penetration(least) <= depth).then(|| ZeroRange::radius(least, |a| contact.penetration(a) - depth))
}
