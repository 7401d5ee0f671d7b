//! From a scene to what is done about it: effects, method, predicted work; then the states themselves.
//!
//! ```text
//! scene ──► plan (effects, method, cost) ──► states, in parallel, journalled ──► outcome
//! ```
//! A plan is all that `explain` prints; making one solves nothing.

pub mod citations;
mod run;
mod steady_crack;

pub use run::{Progress, RunError, journal_header, run};

use crate::outcome::{Column, Effect, Group, Row, Validity, Work, plot};
use crate::refusal::Refusal;
use crate::scene::sweep;
use crate::scene::typed::{Problem, Scene};
use citations::Citation;
use steady_crack::SteadyCrackPlan;

/// What will be done about a scene.
#[derive(Debug, Clone)]
pub struct Plan {
    problem: ProblemPlan,
    states: usize,
}

#[derive(Debug, Clone)]
enum ProblemPlan {
    SteadyCrack(SteadyCrackPlan),
}

impl Plan {
    /// Plans a scene.
    ///
    /// # Errors
    /// A number of the scene that the physics refuses.
    pub fn new(scene: &Scene) -> Result<Self, Refusal> {
        let Problem::SteadyCrack(crack) = &scene.problem;
        let problem = ProblemPlan::SteadyCrack(SteadyCrackPlan::new(scene, crack)?);
        Ok(Self { problem, states: sweep::states(&scene.sweeps) })
    }

    fn crack(&self) -> &SteadyCrackPlan {
        let ProblemPlan::SteadyCrack(plan) = &self.problem;
        plan
    }

    /// The problem's name.
    #[must_use]
    pub fn problem(&self) -> &'static str {
        "steady crack"
    }

    /// Effects on and off, and why.
    #[must_use]
    pub fn effects(&self) -> Vec<Effect> {
        self.crack().effects()
    }

    /// The method, a sentence each.
    #[must_use]
    pub fn method(&self) -> Vec<String> {
        self.crack().method()
    }

    /// Characteristic numbers of the scene.
    #[must_use]
    pub fn groups(&self) -> Vec<Group> {
        self.crack().groups()
    }

    /// Predicted work of the whole sweep.
    #[must_use]
    pub fn predicted_work(&self) -> Work {
        let one = self.crack().predicted_work();
        let states = self.states as u64;
        Work {
            closure_evaluations: one.closure_evaluations * states,
            kernel_evaluations: one.kernel_evaluations * states,
            field_evaluations: one.field_evaluations * states,
        }
    }

    /// Number of states.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.states
    }

    /// The columns of the result.
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        self.crack().columns()
    }

    /// Solves the state that the plan was made for; one row a theory.
    #[must_use]
    pub fn solve(&self, state: usize, swept: &[f64]) -> Vec<Row> {
        self.crack().solve(state, swept)
    }

    /// The model's assumptions held against the rows.
    #[must_use]
    pub fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.crack().validity(rows)
    }

    /// Plots of the rows, by file stem.
    #[must_use]
    pub fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, plot::Figure)> {
        self.crack().figures(scene, rows)
    }

    /// Units of the field table: distance, displacement, stress.
    #[must_use]
    pub fn field_units(&self) -> [String; 3] {
        self.crack().field_units()
    }

    /// The papers behind what the scene uses.
    #[must_use]
    pub fn citations(&self) -> Vec<&'static Citation> {
        self.crack().citations()
    }
}
