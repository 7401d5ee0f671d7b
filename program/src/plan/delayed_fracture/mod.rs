//! The plan of a crack under a load history: the delay, the speeds and the way of the tip.

mod columns;
mod cost;
mod describe;
mod figures;
mod history;
mod solve;
mod validity;

use crate::outcome::plot::Figure;
use crate::outcome::{Column, Effect, Group, Layout, Row, Validity, Work};
use crate::plan::ProblemPlan;
use crate::plan::citations::Citation;
use crate::plan::maps::Answer;
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::{CohesiveLaw, DelayedFracture, PoissonRatio, ProcessZoneLaw, Scene, Units};
use viscotack::crack::delayed::{GrowthProblem, LoadHistory, Resolution};
use viscotack::crack::{Interface, ProcessZone};
use viscotack::elastic::PureShearStrip;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// A crack under a load history, ready to be solved.
#[derive(Debug, Clone)]
pub(super) struct DelayedFracturePlan {
    crack: DelayedFracture,
    /// Both series with plane moduli.
    plane_material: PlaneMaterial,
    youngs_relaxed_modulus: f64,
    poisson_ratio: PoissonRatio,
    strip: Option<PureShearStrip>,
    /// K(t).
    history: LoadHistory,
    /// Its end (s).
    duration: f64,
    units: Units,
    accuracy: f64,
    swept: bool,
    /// The crack at some values of a swept load, for the cost of the whole sweep.
    examples: Vec<DelayedFracture>,
}

/// Lines per process zone that a history starts with at an accuracy of 1e-7, and at any lower one; and at most.
const FEWEST_LINES: f64 = 64.0;
const MOST_LINES: f64 = 4096.0;
/// Steps of one run before it is refused.
const MOST_STEPS: u64 = 40_000_000;

impl DelayedFracturePlan {
    pub(super) fn new(scene: &Scene, crack: &DelayedFracture) -> Result<Self, Refusal> {
        let strip = match crack.strip {
            None => None,
            Some(strip) => {
                let ratio = scene.material.poisson_ratio.unwrap_or(0.0);
                Some(PureShearStrip::new(strip.half_height, strip.lateral, crack.plane, ratio)?)
            }
        };
        let (history, duration) = history::loads(&crack.history, strip.as_ref())?;
        let plan = Self {
            crack: crack.clone(),
            plane_material: scene.material.plane_series(scene.units, crack.plane)?,
            youngs_relaxed_modulus: scene.material.series.relaxed_modulus(),
            poisson_ratio: scene.material.poisson(),
            strip,
            history,
            duration,
            units: scene.units,
            accuracy: scene.accuracy,
            swept: !scene.sweeps.is_empty(),
            examples: history::examples(scene, crack),
        };
        let problem = plan.problem()?;
        let numbers = [plan.duration, problem.glassy_limit(), problem.process_zone_at(plan.history.peak())];
        let grows = plan.history.peak() == 0.0 || (problem.glassy_limit() > 0.0 && problem.process_zone_at(plan.history.peak()) > 0.0);
        if numbers.iter().all(|number| number.is_finite()) && grows && plan.characteristic_numbers().iter().all(|g| g.value.is_finite()) {
            Ok(plan)
        } else {
            Err(Refusal::Undefined {
                quantity: "the scale of the crack",
                reason: "the moduli, the work of adhesion, the load and the cohesive stress are so far apart that numbers overflow".into(),
            })
        }
    }

    /// The growth problem of the library.
    fn problem(&self) -> Result<GrowthProblem<'_>, Refusal> {
        let process_zone = match self.crack.process_zone {
            ProcessZoneLaw::Length(length) => ProcessZone::Constant { length },
            ProcessZoneLaw::Cohesive { cohesive_stress, factor, law: CohesiveLaw::Constant } => {
                ProcessZone::Constant { length: factor * self.relaxed_zone(cohesive_stress) }
            }
            ProcessZoneLaw::Cohesive { cohesive_stress, factor, .. } => ProcessZone::Growing { cohesive_stress, factor },
        };
        let interface = Interface { work_of_adhesion: self.crack.work_of_adhesion, process_zone, body: self.crack.body };
        GrowthProblem::following(&self.plane_material, interface)
    }

    /// a₀ for a cohesive stress (m).
    fn relaxed_zone(&self, cohesive_stress: f64) -> f64 {
        let squared = self.crack.body.intensity_squared(self.crack.work_of_adhesion, self.plane_material.relaxed_modulus());
        squared / (std::f64::consts::TAU * cohesive_stress * cohesive_stress)
    }

    /// How finely the history is stepped at first: the error falls with the third power of the lines. Steps are halved until the bounds meet the accuracy.
    fn resolution(&self) -> Resolution {
        let finer = (1e-7 / self.accuracy).cbrt();
        let lines = (FEWEST_LINES * finer).ceil().clamp(FEWEST_LINES, MOST_LINES);
        Resolution { lines_per_zone: lines as u32, most_steps: MOST_STEPS }
    }

    /// Times at which the tip is looked at.
    fn output_times(&self) -> Vec<f64> {
        let (points, end) = (self.crack.output.points, self.duration);
        let last = f64::from(points.saturating_sub(1).max(1));
        (0..points)
            .map(|index| match self.crack.output.first {
                _ if index + 1 == points => end,
                Some(first) => (first * (end / first).powf(f64::from(index) / last)).min(end),
                None => end * (f64::from(index) / last),
            })
            .collect()
    }

    /// Whether the load is one step, held for ever: the delay is then known without stepping.
    fn is_one_step(&self) -> bool {
        self.history.segments().iter().all(|segment| segment.from.to_bits() == segment.to.to_bits())
            && self.history.segments().windows(2).all(|pair| matches!(pair, [one, two] if one.to.to_bits() == two.from.to_bits()))
    }
}

impl ProblemPlan for DelayedFracturePlan {
    fn name(&self) -> &'static str {
        "delayed fracture"
    }

    fn labels(&self) -> &'static [&'static str] {
        &["record", "state", "event"]
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
        let example = |crack: &DelayedFracture| {
            let (history, duration) = history::loads(&crack.history, self.strip.as_ref()).ok()?;
            Some(Self { crack: crack.clone(), history, duration, examples: Vec::new(), ..self.clone() }.work_of_a_state())
        };
        let works: Vec<Work> = self.examples.iter().filter_map(example).collect();
        if works.is_empty() {
            return self.work_of_a_state() * states;
        }
        let mut sum = Work::default();
        let count = works.len() as u64;
        works.into_iter().for_each(|work| sum += work);
        let mean = |total: u64| (u128::from(total) * u128::from(states) / u128::from(count)) as u64;
        Work { closure_evaluations: mean(sum.closure_evaluations), kernel_evaluations: mean(sum.kernel_evaluations), ..Work::default() }
    }

    fn rows_of_a_state(&self) -> u64 {
        // The summary, and a few events of each piece of the history.
        u64::from(self.crack.output.points) + 4 * self.history.segments().len() as u64 + 16
    }

    fn abscissa(&self) -> Option<&'static str> {
        Some("time")
    }

    fn columns(&self) -> Vec<Column> {
        columns::columns(self.units)
    }

    fn headline(&self) -> &'static [&'static str] {
        &columns::SUMMARY_HEADLINE
    }

    fn path_headline(&self) -> &'static [&'static str] {
        &columns::HEADLINE
    }

    fn layout(&self) -> Option<Layout> {
        Some(columns::layout())
    }

    fn field_columns(&self) -> Vec<Column> {
        columns::field_columns(self.units)
    }

    fn solve(&self, state: usize, swept: &[f64], state_watch: &StateWatch<'_>) -> Vec<Row> {
        self.rows(state, swept, state_watch)
    }

    fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.assessments(rows)
    }

    fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        self.drawings(scene, rows)
    }

    fn answer(&self, _: &[Row]) -> Option<Answer> {
        Some(self.delay())
    }

    fn citations(&self) -> Vec<&'static Citation> {
        self.papers()
    }
}
