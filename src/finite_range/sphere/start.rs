//! The first state of a run.

use std::f64::consts::{FRAC_2_PI, PI};
use std::sync::Arc;

use super::mesh::{Cell, Mesher};
use super::newton::Row;
use super::problem::{Control, Problem, Start};
use super::state::State;
use super::step::Solver;
use super::tip::Shape;
use super::zero_range::ZeroRange;
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
        let (now, relaxed_contact) = (ZeroRange::of(problem, modulus), ZeroRange::of(problem, 1.0));
        let depth = now.depth(row);
        let deepest = deepest.max(depth).max(1.0);
        let reach = relaxed_contact.reach(deepest).max(relaxed_contact.contact(deepest).unwrap_or(0.0));
        let contact = now.contact(depth).filter(|_| relaxed || depth > 0.0 || of_force > 0.0);
        let mut cells = Mesher::coarsest(MARGIN * reach, problem.rim);
        self.surface.set_outside(cells.last().map_or(0.0, |cell| cell.interval().1));
        let tolerance = self.accuracy.mesh;
        self.accuracy.mesh = tolerance.max(OF_A_GUESS);
        let mut state = self.guessed(&problem.shape, depth, contact, modulus, cells.clone());
        for _ in 0..ROUNDS {
            let finer = Mesher::halved(&cells, &self.unresolved(&state));
            if finer == cells || finer.len() * self.mesher.order() > self.accuracy.most_nodes {
                break;
            }
            cells = finer;
            state = self.guessed(&problem.shape, depth, contact, modulus, cells.clone());
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
    fn guessed(&mut self, shape: &Shape, depth: f64, contact: Option<f64>, modulus: f64, cells: Vec<Cell>) -> State {
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
    fn first_guess(&self, x: f64, shape: &Shape, depth: f64, contact: Option<f64>, modulus: f64) -> f64 {
        let coupling = self.coupling * modulus;
        let Some(a) = contact else { return (self.surface.undeformed(x) - depth).max(0.9) };
        // √(2πma), but for a contact that its rim holds.
        let opening = shape.line(a) - depth;
        if x < a {
            let root = (a * a - x * x).sqrt().max(1e-3 * a);
            let pressed = shape.line_slope(a) / (2.0 * a);
            return self.surface.compressed((FRAC_2_PI * pressed * root - opening / (PI * root)) / coupling);
        }
        let (angle, root) = ((a / x).acos(), (x * x - a * a).sqrt());
        let separation =
            if *shape == Shape::Paraboloid { ((x * x - 2.0 * a * a) * angle + a * root) / PI } else { shape.height(x) - shape.height(a) };
        self.surface.undeformed(0.0) + separation + FRAC_2_PI * opening * angle
    }
}
