//! The plan of an indenter with a law of attraction of finite range: the surfaces attract each other everywhere, and there is no edge.
//!
//! The scene, its history and its units are those of an indenter with a process zone; the solver is [`viscotack::finite_range::sphere`].

mod advice;
mod bounds;
mod columns;
mod cost;
mod curve;
mod cycles;
mod describe;
mod drawings;
mod fields;
mod history;
mod parts;
mod repetitions;
mod rows;
mod scales;
mod validity;
mod widened;

use super::known::Known;
use super::scale::Scale;
use super::timeline::Timeline;
use crate::outcome::plot::Figure;
use crate::outcome::{Column, Effect, Group, Layout, Row, Validity, Work};
use crate::plan::ProblemPlan;
use crate::plan::citations::Citation;
use crate::plan::maps::Answer;
use crate::plan::path_curve::PathCurve;
use crate::plan::plane_material::plane_material;
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::{Indentation, PoissonRatio, Scene, SceneAttraction, Units};
pub(super) use advice::beside_an_edge;
use history::Course;
use scales::Reduced;
use viscotack::finite_range::sphere::SUM_OF_DURATIONS;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// An indenter whose surface attracts at a distance, ready to be solved.
#[derive(Debug, Clone)]
pub(in crate::plan) struct FiniteRangePlan {
    indentation: Indentation,
    attraction: SceneAttraction,
    /// In moduli E* = E/(1 − ν²).
    material: PlaneMaterial,
    poisson_ratio: PoissonRatio,
    scale: Scale,
    units: Units,
    accuracy: f64,
    /// Whether a sweep follows.
    swept: bool,
    timeline: Timeline,
    reduced: Reduced,
    course: Course,
    /// What is known of the history that only a solution knows.
    known: Known,
    /// The accuracy that the solver is asked for: tighter where conditions end segments.
    solver_accuracy: f64,
    /// What the scene calls for, and what the other theory would cost.
    advice: Vec<String>,
}

impl FiniteRangePlan {
    pub(in crate::plan) fn new(scene: &Scene, indentation: &Indentation, attraction: &SceneAttraction) -> Result<Self, Refusal> {
        let plan = Self::without_advice(scene, indentation, attraction)?;
        let advice = plan.theories(scene);
        Ok(Self { advice, ..plan })
    }

    fn without_advice(scene: &Scene, indentation: &Indentation, attraction: &SceneAttraction) -> Result<Self, Refusal> {
        let material = plane_material(scene, indentation.counter_body.and_then(|body| body.elastic))?;
        material.solid_modulus("a contact with attraction of finite range")?;
        let scale = Scale::new(scene.units);
        let timeline = Timeline::new(indentation, &scale, &Known::default())?;
        let mut wanted = indentation
            .fields
            .iter()
            .filter(|_| timeline.open.is_empty())
            .flat_map(|fields| &fields.times)
            .map(|time| time / indentation.speed_factor);
        // What is open is known when it is solved: times beyond the end have no row.
        if let Some(late) = wanted.find(|time| *time > timeline.duration() * (1.0 + SUM_OF_DURATIONS)) {
            return Err(Refusal::out_of_range("fields.times", late, "within the history"));
        }
        let reduced = Reduced::new(indentation, attraction, &material, &scale)?;
        let course = Course::new(indentation, &timeline, &reduced, &scale);
        let plan = Self {
            indentation: indentation.clone(),
            attraction: attraction.clone(),
            material,
            poisson_ratio: scene.material.poisson(),
            scale,
            units: scene.units,
            accuracy: scene.accuracy,
            swept: !scene.sweeps.is_empty(),
            reduced,
            course,
            known: Known::default(),
            solver_accuracy: scene.accuracy * if timeline.searches() { parts::WITH_CONDITIONS } else { 1.0 },
            timeline,
            advice: Vec::new(),
        };
        plan.problem()?.check()?;
        if plan.characteristic_numbers().iter().all(|group| group.value.is_finite()) {
            Ok(plan)
        } else {
            Err(Refusal::Undefined {
                quantity: "the scale of the indentation",
                reason: "the lengths, moduli, times and the work of adhesion are so far apart that numbers overflow".into(),
            })
        }
    }
}

impl ProblemPlan for FiniteRangePlan {
    fn name(&self) -> &'static str {
        "indentation"
    }

    fn labels(&self) -> &'static [&'static str] {
        &["row", "event"]
    }

    fn effects(&self) -> Vec<Effect> {
        self.effect_list()
    }

    fn method(&self) -> Vec<String> {
        self.sentences()
    }

    fn groups(&self) -> Vec<Group> {
        self.characteristic_numbers()
    }

    fn predicted_work(&self, states: u64) -> Work {
        self.work_of_a_state() * states
    }

    fn rows_of_a_state(&self) -> u64 {
        self.most_rows()
    }

    fn seconds_a_system(&self) -> f64 {
        self.seconds_of_a_system()
    }

    fn memory_of_a_state(&self) -> u64 {
        self.most_memory()
    }

    fn visited_times(&self) -> Option<[f64; 2]> {
        Some([0.0, self.timeline.duration()]).filter(|visited| visited[1] > 0.0)
    }

    fn abscissa(&self) -> Option<&'static str> {
        Some("time")
    }

    fn columns(&self) -> Vec<Column> {
        columns::columns(&self.indentation, self.units)
    }

    fn headline(&self) -> &'static [&'static str] {
        if self.timeline.oscillates() {
            return &["storage_stiffness", "loss_stiffness", "work_per_cycle", "largest_radius", "end_penetration"];
        }
        &["pull_off_force", "pull_off_ratio", "pull_off_penetration", "work_of_separation", "tabor_number"]
    }

    fn path_headline(&self) -> &'static [&'static str] {
        if self.timeline.oscillates() {
            return &["time", "force", "storage_stiffness", "loss_stiffness", "work_per_cycle"];
        }
        &["time", "penetration", "force", "contact_radius", "pull_off_ratio"]
    }

    fn layout(&self) -> Option<Layout> {
        Some(columns::layout(&self.indentation))
    }

    fn field_columns(&self) -> Vec<Column> {
        columns::field_columns(self.units)
    }

    fn solve(&self, state: usize, swept: &[f64], state_watch: &StateWatch<'_>) -> Vec<Row> {
        let mut rows = match self.resolved(state_watch) {
            Ok(Some(resolved)) => return resolved.solve(state, swept, state_watch),
            Ok(None) => self.rows(state, swept, state_watch),
            Err(refusal) => vec![self.refused(state, swept, &refusal)],
        };
        let table = columns::columns(&self.indentation, self.units);
        super::locate::of_starts(&mut rows, &table, &self.known);
        super::agreement::put_into(&mut rows, &table);
        rows
    }

    fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.limits(rows)
    }

    fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        self.drawings(scene, rows)
    }

    fn curve(&self, tolerance: f64) -> Option<Result<PathCurve, Refusal>> {
        Some(self.way(tolerance))
    }

    fn answer(&self, _: &[Row]) -> Option<Answer> {
        self.main_answer()
    }

    fn citations(&self) -> Vec<&'static Citation> {
        self.papers()
    }
}
