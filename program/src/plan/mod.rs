//! From a scene to what is done about it: effects, method, predicted work; then the states themselves.
//!
//! ```text
//! scene ──► plan (effects, method, cost) ──► states, in parallel, journalled ──► outcome
//! ```
//! A plan is all that `explain` prints; making one solves nothing. Each problem is a folder here that implements `ProblemPlan`.

mod assumptions;
mod axis_units;
pub mod citations;
pub mod column_reference;
mod curves;
mod delayed_fracture;
pub mod fit;
mod indentation;
mod kept;
mod maps;
pub mod material;
mod measured;
mod path_curve;
mod plane_material;
mod propagate;
mod run;
mod sliding;
mod state_watch;
mod steady_crack;
mod surface;

pub use curves::short as short_number;
pub use path_curve::PathCurve;
pub use run::{RunError, Safe, Sink, journal_header, run, run_planned, run_shard, swept_columns, unsolved};
pub use state_watch::{Progress, Stage};

use crate::outcome::{Assessment, Column, Effect, Group, Layout, Row, Validity, Work, plot};
use crate::scene::sweep::{self, Sweep};
use crate::scene::typed::{Problem, Scene, SceneMaterial};
use citations::Citation;
use delayed_fracture::DelayedFracturePlan;
use indentation::{FiniteRangePlan, IndentationPlan};
use maps::Answer;
use sliding::SlidingPlan;
use state_watch::StateWatch;
use std::fmt::Debug;
use std::sync::Arc;
use steady_crack::SteadyCrackPlan;
use surface::SurfacePlan;
use viscotack::refusal::Refusal;

/// The program with its libraries and a few rows.
const BYTES_OF_THE_PROGRAM: u64 = 12 << 20;
/// A row with its words, certificate and work; a value with its error, as a number and in the tables that are written.
const BYTES_OF_A_ROW: u64 = 800;
const BYTES_OF_A_CELL: u64 = 48;
/// Buffers of the journal, the tables and the pictures where not all rows are held.
const BYTES_OF_A_STREAM: u64 = 5 << 20;
/// A place of a field, and a field there.
const BYTES_OF_A_POINT: u64 = 72;
const BYTES_OF_A_FIELD: u64 = 48;

/// Time of a kernel evaluation, an energy balance, a field point; of a state of a sweep, which is read anew; of a row in the
/// journal and the tables (s).
const SECONDS_A_KERNEL: f64 = 5e-8;
const SECONDS_A_BALANCE: f64 = 1e-6;
const SECONDS_A_POINT: f64 = 2e-6;
const SECONDS_A_STATE: f64 = 5e-5;
const SECONDS_A_ROW: f64 = 2e-5;
/// A row in the journal and in the tables; a value with its error there.
const BYTES_WRITTEN_A_ROW: u64 = 600;
const BYTES_WRITTEN_A_CELL: u64 = 120;

/// What a problem says about one state of a scene, and how it solves it.
trait ProblemPlan: Debug + Send + Sync {
    /// The problem's name.
    fn name(&self) -> &'static str;
    /// What the labels of its rows are.
    fn labels(&self) -> &'static [&'static str];
    /// Effects on and off, and why.
    fn effects(&self) -> Vec<Effect>;
    /// The method, a sentence each.
    fn method(&self) -> Vec<String>;
    /// Characteristic numbers of the scene.
    fn groups(&self) -> Vec<Group>;
    /// Predicted work of the whole sweep of so many states.
    fn predicted_work(&self, states: u64) -> Work;
    /// Time of a linear system (s).
    fn seconds_a_system(&self) -> f64 {
        2e-5
    }
    /// Rows of a state, at most.
    fn rows_of_a_state(&self) -> u64;
    /// Memory that solving a state takes besides its rows (bytes), at most.
    fn memory_of_a_state(&self) -> u64 {
        1 << 20
    }
    /// The times (from, to) that the state visits, if they are known before it is solved: 0 and ∞ are open ends.
    fn visited_times(&self) -> Option<[f64; 2]> {
        None
    }
    /// The column whose values the scene prescribes, such as the time of a history: by it rows of two solutions are compared.
    fn abscissa(&self) -> Option<&'static str> {
        None
    }
    /// The columns of the result.
    fn columns(&self) -> Vec<Column>;
    /// The columns that a table on the screen has room for; none: the first ones.
    fn headline(&self) -> &'static [&'static str] {
        &[]
    }
    /// The same of rows on the way of a state, where the state has a row of its own.
    fn path_headline(&self) -> &'static [&'static str] {
        &[]
    }
    /// Which columns belong to the row of a state and which to the rows on its way; none: each row is a state.
    fn layout(&self) -> Option<Layout> {
        None
    }
    /// The columns of the field table: the place, then the fields.
    fn field_columns(&self) -> Vec<Column>;
    /// Solves the state; one row a label. One that takes long tells the state_watch how far it is, and leaves checkpoints there.
    fn solve(&self, state: usize, swept: &[f64], state_watch: &StateWatch<'_>) -> Vec<Row>;
    /// The model's assumptions held against the rows.
    fn validity(&self, rows: &[Row]) -> Vec<Validity>;
    /// Plots of the rows, by file stem.
    fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, plot::Figure)>;
    /// The way of a history without bounds, at a tolerance; none of a problem without a history that is followed.
    fn curve(&self, _tolerance: f64) -> Option<Result<PathCurve, Refusal>> {
        None
    }
    /// The number that a state of the sweep is solved for, where a picture shows just one.
    fn answer(&self, rows: &[Row]) -> Option<Answer>;
    /// The axis of a swept number.
    fn swept_axis(&self, sweep: &Sweep) -> plot::Axis {
        curves::swept_axis(sweep)
    }
    /// The papers behind what the scene uses.
    fn citations(&self) -> Vec<&'static Citation>;
}

/// The plan of a scene's problem.
fn problem_plan(scene: &Scene) -> Result<Arc<dyn ProblemPlan>, Refusal> {
    Ok(match &scene.problem {
        Problem::SteadyCrack(crack) => Arc::new(SteadyCrackPlan::new(scene, crack)?),
        Problem::DelayedFracture(crack) => Arc::new(DelayedFracturePlan::new(scene, crack)?),
        Problem::Sliding(sliding) => Arc::new(SlidingPlan::new(scene, sliding)?),
        Problem::Surface(sliding) => Arc::new(SurfacePlan::new(scene, sliding)?),
        Problem::Indentation(indentation) => match &indentation.attraction {
            Some(attraction) => Arc::new(FiniteRangePlan::new(scene, indentation, attraction)?),
            None => Arc::new(IndentationPlan::new(scene, indentation)?),
        },
    })
}

/// What will be done about a scene.
#[derive(Debug, Clone)]
pub struct Plan {
    problem: Arc<dyn ProblemPlan>,
    material: SceneMaterial,
    /// Numbers of the scene that are far from what is usual, a sentence each.
    unusual: Vec<String>,
    /// The times that the state visits, if they are known.
    visited: Option<[f64; 2]>,
    states: usize,
    /// States whose rows are held at the end, at most.
    most_kept: usize,
    /// The same scene with each draw of its material, if it asks for them.
    draws: Vec<propagate::Draw>,
}

impl Plan {
    /// Plans a scene.
    ///
    /// # Errors
    /// A number of the scene that the physics refuses.
    pub fn new(scene: &Scene) -> Result<Self, Refusal> {
        let mut problem = problem_plan(scene)?;
        let states = sweep::states(&scene.sweeps);
        let visited = problem.visited_times();
        // A law that the scene reaches beyond is expanded as far.
        let wide = material::widened(scene, visited);
        let scene = wide.as_ref().unwrap_or(scene);
        if wide.is_some() {
            problem = problem_plan(scene)?;
        }
        // Numbers of a scene that are finite may have characteristic ones that are not.
        if let Some(group) = problem.groups().into_iter().find(|group| !group.value.is_finite()) {
            return Err(Refusal::Undefined {
                quantity: "a characteristic number",
                reason: format!("{}: the numbers of the scene are too large or too small for it", group.name),
            });
        }
        let most_kept = kept::most_states(&scene.sweeps, problem.rows_of_a_state());
        Ok(Self {
            problem,
            material: scene.material.clone(),
            unusual: scene.cautions.clone(),
            visited,
            states,
            most_kept,
            draws: propagate::draws(scene),
        })
    }

    /// The problem's name.
    #[must_use]
    pub fn problem(&self) -> &'static str {
        self.problem.name()
    }

    /// What the labels of the rows are: the first distinguishes the rows of one state.
    #[must_use]
    pub fn labels(&self) -> &'static [&'static str] {
        self.problem.labels()
    }

    /// Materials for which each state is solved besides its own.
    #[must_use]
    pub fn draws(&self) -> usize {
        self.draws.len()
    }

    /// Effects on and off, and why.
    #[must_use]
    pub fn effects(&self) -> Vec<Effect> {
        let mut effects = self.problem.effects();
        effects.extend(material::effects(&self.material));
        effects
    }

    /// The method, a sentence each.
    #[must_use]
    pub fn method(&self) -> Vec<String> {
        let mut sentences = self.problem.method();
        if !self.draws.is_empty() {
            sentences.push(format!(
                "the error of the material: each state is solved for {} materials drawn from what the data leave open; their standard deviation is one standard uncertainty; fields have none",
                self.draws.len()
            ));
        }
        sentences
    }

    /// Characteristic numbers of the scene.
    #[must_use]
    pub fn groups(&self) -> Vec<Group> {
        self.problem.groups()
    }

    /// Predicted work of the whole sweep.
    #[must_use]
    pub fn predicted_work(&self) -> Work {
        self.problem.predicted_work(self.states as u64) * (1 + self.draws.len() as u64)
    }

    /// Predicted largest memory of a run (bytes): of the program, of all rows with their tables, and of the states that are solved side by side.
    /// Measured peaks are at most this and at least a quarter of it (`tests/program/explain_predicts_memory.rs`).
    #[must_use]
    pub fn predicted_memory(&self) -> u64 {
        let draws = self.draws.len() as u64;
        let row = BYTES_OF_A_ROW + BYTES_OF_A_CELL * self.columns().len() as u64;
        let point = BYTES_OF_A_POINT + BYTES_OF_A_FIELD * self.field_columns().len() as u64;
        // Of a long sweep only some states are held. Rows of draws are held while their state is solved.
        let states = if self.keeps_all_rows() { self.states } else { self.most_kept } as u64;
        let rows = (self.problem.rows_of_a_state() * (states + draws)).saturating_mul(row);
        let fields = self.problem.predicted_work(states).field_evaluations.saturating_mul(point);
        let at_once = (rayon::current_num_threads() as u64).min(states * (1 + draws));
        let streamed = if self.keeps_all_rows() { 0 } else { BYTES_OF_A_STREAM };
        BYTES_OF_THE_PROGRAM + streamed + rows.saturating_add(fields).saturating_add(at_once * self.problem.memory_of_a_state())
    }

    /// Predicted time of a run (s), from 2 threads on: the states are read, solved and written. Within a factor of ten of what was measured on
    /// machines of 2020 to 2024.
    #[must_use]
    pub fn predicted_seconds(&self) -> f64 {
        let states = self.states as u64;
        let threads = rayon::current_num_threads().min(self.states).max(1) as f64;
        let rows = states.saturating_mul(self.rows_of_a_state()) as f64;
        self.predicted_seconds_of_a_state() * states as f64 / threads + SECONDS_A_ROW * rows
    }

    /// The same of reading and solving one of its states, on one core.
    fn predicted_seconds_of_a_state(&self) -> f64 {
        let work = self.predicted_work();
        let solving = SECONDS_A_KERNEL * work.kernel_evaluations as f64
            + SECONDS_A_BALANCE * work.closure_evaluations as f64
            + self.problem.seconds_a_system() * work.linear_solves as f64
            + SECONDS_A_POINT * work.field_evaluations as f64;
        solving / self.states.max(1) as f64 + if self.states > 1 { SECONDS_A_STATE } else { 0.0 }
    }

    /// Predicted size of the files of a run with `--out` (bytes), and of the journal while it is under way, at most.
    #[must_use]
    pub fn predicted_disk(&self) -> u64 {
        let columns = self.columns().len() as u64;
        let rows = (self.states as u64).saturating_mul(self.rows_of_a_state());
        // The tables, the journal, and up to ten thousand rows of the summary.
        rows.saturating_mul(BYTES_WRITTEN_A_ROW + BYTES_WRITTEN_A_CELL * columns)
    }

    /// Number of states.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.states
    }

    /// Rows of a state, at most.
    #[must_use]
    pub fn rows_of_a_state(&self) -> u64 {
        self.problem.rows_of_a_state()
    }

    /// Whether a run holds all of its rows at once; else they go to files as they come.
    #[must_use]
    pub fn keeps_all_rows(&self) -> bool {
        kept::few(self.states, self.rows_of_a_state())
    }

    /// The columns of the result.
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        self.problem.columns()
    }

    /// The columns that a table on the screen has room for; none: the first ones.
    #[must_use]
    pub fn headline(&self) -> &'static [&'static str] {
        self.problem.headline()
    }

    /// The same of rows on the way of a state.
    #[must_use]
    pub fn path_headline(&self) -> &'static [&'static str] {
        self.problem.path_headline()
    }

    /// Which columns belong to the row of a state and which to the rows on its way; none: each row is a state.
    #[must_use]
    pub fn layout(&self) -> Option<Layout> {
        self.problem.layout()
    }

    /// The columns of the field table: the place, then the fields.
    #[must_use]
    pub fn field_columns(&self) -> Vec<Column> {
        self.problem.field_columns()
    }

    /// Solves the state that the plan was made for; one row a theory, or a kind of contact.
    #[must_use]
    pub fn solve(&self, state: usize, swept: &[f64]) -> Vec<Row> {
        self.solve_at(&StateWatch::new(state, None, &|_| ()), state, swept)
    }

    /// The way of a history without bounds, at a tolerance; none of a problem without one.
    #[must_use]
    pub fn curve(&self, tolerance: f64) -> Option<Result<PathCurve, Refusal>> {
        self.problem.curve(tolerance)
    }

    /// The same, telling a state_watch how far it is, and from the checkpoint that is there.
    fn solve_at(&self, state_watch: &StateWatch<'_>, state: usize, swept: &[f64]) -> Vec<Row> {
        let mut rows: Vec<Row> = self.problem.solve(state, swept, state_watch).into_iter().map(Row::settled).collect();
        propagate::attach(self.problem.as_ref(), &self.draws, &mut rows, swept, state_watch.progress());
        rows
    }

    /// The model's assumptions held against the rows.
    #[must_use]
    pub fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        let mut validity = self.problem.validity(rows);
        validity.extend(material::validity(&self.material, self.visited));
        validity.extend(self.unusual.iter().map(|text| Validity {
            name: "number of the scene".into(),
            value: None,
            assessment: Assessment::Caution,
            meaning: text.clone(),
        }));
        validity.extend(propagate::validity(rows, &self.columns()));
        validity
    }

    /// What may be wrong with the scene before it is solved, a sentence each.
    #[must_use]
    pub fn cautions(&self) -> Vec<String> {
        let of_material = material::validity(&self.material, self.visited);
        let cautions = of_material.into_iter().filter(|entry| entry.assessment == Assessment::Caution && entry.value.is_none());
        cautions.map(|entry| entry.meaning).chain(self.unusual.iter().cloned()).collect()
    }

    /// Plots of the rows, by file stem.
    #[must_use]
    pub fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, plot::Figure)> {
        let maps = maps::figures(self, scene, rows);
        // No two states of a Latin hypercube share a number: there are no curves.
        if sweep::is_together(&scene.sweeps) {
            return maps;
        }
        let mut figures = self.problem.figures(scene, rows);
        figures.extend(maps);
        figures
    }

    /// The papers behind what the scene uses.
    #[must_use]
    pub fn citations(&self) -> Vec<&'static Citation> {
        self.problem.citations()
    }
}
