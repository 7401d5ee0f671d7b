//! The plan of an indenter in time: which shape and material, which history, which instants and fields.

mod agreement;
mod answer;
mod columns;
mod cost;
mod curve;
mod cycle_figures;
mod cycles;
mod describe;
mod events;
mod fields;
mod figures;
mod finite;
mod known;
mod locate;
mod parts;
mod problem;
mod protocol;
mod remarks;
mod repetitions;
mod rows;
mod scale;
mod scan;
mod shift;
mod timeline;
mod validity;

use crate::outcome::plot::Figure;
use crate::outcome::{Column, Effect, Group, Layout, Row, Validity, Work};
use crate::plan::ProblemPlan;
use crate::plan::citations::Citation;
use crate::plan::maps::Answer;
use crate::plan::path_curve::PathCurve;
use crate::plan::plane_material::{flow_as_element, plane_material};
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::{HistorySegment, Indentation, IndentationStart, IndentationZone, PoissonRatio, Scene, Units};
pub(super) use finite::FiniteRangePlan;
use known::Known;
use scale::Scale;
use timeline::Timeline;
use viscotack::indentation::Profile;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// An indenter in time, ready to be solved.
#[derive(Debug, Clone)]
pub(super) struct IndentationPlan {
    indentation: Indentation,
    /// In moduli E* = E/(1 − ν²).
    material: PlaneMaterial,
    /// E0*.
    relaxed: f64,
    /// η* of a liquid. With adhesion its flow is an element of a retardation time of [`LONG`] histories.
    flow: Option<f64>,
    poisson_ratio: PoissonRatio,
    scale: Scale,
    units: Units,
    accuracy: f64,
    /// Whether a sweep follows.
    swept: bool,
    timeline: Timeline,
    /// What is known of the history that only a solution knows.
    known: Known,
    /// The accuracy that the solver is asked for: tighter where conditions end segments.
    solver_accuracy: f64,
    /// The history at values all over the sweep of a frequency; none if no frequency is swept.
    examples: Vec<Timeline>,
    profile: Profile,
    /// Whether it is solved without steps in time.
    without_steps: bool,
    /// Which theory the range of the interface calls for, if the scene names it.
    called_for: Option<String>,
}

impl IndentationPlan {
    pub(super) fn new(scene: &Scene, indentation: &Indentation) -> Result<Self, Refusal> {
        let material = plane_material(scene, indentation.counter_body.and_then(|body| body.elastic))?;
        if scene.units == Units::Reduced {
            material.solid_modulus("an indentation in reduced units")?;
        }
        if let (Some(adhesion), true) = (indentation.adhesion, material.relaxed_modulus() == 0.0) {
            liquid_is_possible(indentation, adhesion.process_zone)?;
        }
        let scale = Scale::new(scene.units);
        let timeline = Timeline::new(indentation, &scale, &Known::default())?;
        let mut plan = Self {
            indentation: indentation.clone(),
            relaxed: material.relaxed_modulus(),
            flow: material.steady_viscosity(),
            material,
            poisson_ratio: scene.material.poisson(),
            scale,
            units: scene.units,
            accuracy: scene.accuracy,
            swept: !scene.sweeps.is_empty(),
            known: Known::default(),
            solver_accuracy: scene.accuracy * if timeline.searches() { parts::WITH_CONDITIONS } else { 1.0 },
            timeline,
            examples: examples(scene, indentation, &scale),
            profile: problem::profile(indentation)?,
            without_steps: false,
            called_for: finite::beside_an_edge(scene, indentation),
        };
        plan.without_steps = plan.problem()?.is_without_steps();
        if !plan.without_steps && plan.flow.is_some() {
            let long = plan.timeline.duration() + plan.material.longest_relaxation_time().unwrap_or(0.0);
            plan.material = flow_as_element(&plan.material, LONG * long)?;
            plan.relaxed = plan.material.relaxed_modulus();
        }
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

/// Retardation time of the element that a liquid flows by, over the duration of the history and its longest relaxation time.
const LONG: f64 = 1e8;
/// What that changes of any value, at most, relative: half of 1/[`LONG`] in the flow, a few times as much in what follows from it.
const OF_FLOW: f64 = 1e-7;

/// What a liquid cannot have.
fn liquid_is_possible(indentation: &Indentation, zone: IndentationZone) -> Result<(), Refusal> {
    let refused = |quantity, reason: &str| Err(Refusal::Undefined { quantity, reason: reason.to_owned() });
    if indentation.start == IndentationStart::Relaxed {
        let reason = "the material is a liquid (relaxed modulus 0): adhesion pulls it on for ever; use start = \"untouched\"";
        return refused("a relaxed adhesive contact", reason);
    }
    match zone {
        IndentationZone::Length(_) => Ok(()),
        IndentationZone::Cohesive { .. } => refused(
            "the process zone of a cohesive stress",
            "it is αE0*Δγ/(πσ_c²), and the relaxed modulus E0 is 0; give process_zone = { length = ... }",
        ),
    }
}

/// Values of a swept frequency that the cost of a sweep is assessed by.
const EXAMPLES: usize = 7;

fn examples(scene: &Scene, indentation: &Indentation, scale: &Scale) -> Vec<Timeline> {
    let swept = |key: &str| -> Option<usize> { key.strip_prefix("history.")?.strip_suffix(".oscillation.frequency")?.parse().ok() };
    let Some((index, values)) = scene.sweeps.iter().find_map(|sweep| Some((swept(&sweep.key)?, &sweep.values))) else { return Vec::new() };
    let (count, last) = (EXAMPLES.min(values.len()), values.len().saturating_sub(1));
    (0..count)
        .filter_map(|example| {
            let mut changed = indentation.clone();
            let frequency = *values.get(example * last / count.saturating_sub(1).max(1))?;
            for segment in changed.history.of_table(index) {
                let HistorySegment::Oscillation(oscillation) = segment else { return None };
                oscillation.frequency = frequency;
            }
            Timeline::new(&changed, scale, &Known::default()).ok()
        })
        .collect()
}

impl ProblemPlan for IndentationPlan {
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
        let count = self.examples.len() as u64;
        if count == 0 {
            return self.work_of_a_state() * states;
        }
        let mut sum = Work::default();
        for timeline in &self.examples {
            sum += Self { timeline: timeline.clone(), examples: Vec::new(), ..self.clone() }.work_of_a_state();
        }
        let mean = |total: u64| (u128::from(total) * u128::from(states) / u128::from(count)) as u64;
        Work {
            closure_evaluations: mean(sum.closure_evaluations),
            kernel_evaluations: mean(sum.kernel_evaluations),
            field_evaluations: mean(sum.field_evaluations),
            ..Work::default()
        }
    }

    fn rows_of_a_state(&self) -> u64 {
        self.most_rows()
    }

    fn memory_of_a_state(&self) -> u64 {
        self.most_memory()
    }

    fn visited_times(&self) -> Option<[f64; 2]> {
        // A jump of the edge takes no time: nothing is too fast.
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
        if self.indentation.adhesion.is_some() {
            &["pull_off_force", "pull_off_ratio", "pull_off_penetration", "work_of_separation", "largest_radius"]
        } else {
            &["largest_compression", "largest_radius", "end_penetration", "end_force", "end_radius"]
        }
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
        let mut rows = match self.resolved() {
            Ok(Some(resolved)) => return resolved.solve(state, swept, state_watch),
            Ok(None) => self.rows(state, swept, state_watch),
            Err(refusal) => vec![self.refused(state, swept, &refusal)],
        };
        let table = columns::columns(&self.indentation, self.units);
        locate::of_starts(&mut rows, &table, &self.known);
        if self.flow.is_some() && !self.without_steps {
            let values = rows
                .iter_mut()
                .flat_map(|row| row.values.iter_mut().flatten().chain(row.fields.iter_mut().flat_map(|point| &mut point.values)));
            values.filter(|estimate| estimate.error > 0.0).for_each(|estimate| estimate.error += OF_FLOW * estimate.value.abs());
        }
        agreement::put_into(&mut rows, &table);
        rows
    }

    fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.assessments(rows)
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
