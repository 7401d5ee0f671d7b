//! The plan of a sliding contact: which contacts, at which speed, under which load, with which fields.

mod branch_figures;
mod branch_rows;
mod branches;
mod columns;
mod cost;
mod describe;
mod extra_columns;
mod extra_figures;
mod extras;
mod fields;
mod figures;
mod growing;
mod isolated;
mod liquid;
mod scale;
mod solve;
mod strength_rows;
mod validity;

use crate::outcome::plot::{Axis, Figure};
use crate::outcome::{Column, Effect, Group, Row, Validity, Work};
use crate::plan::ProblemPlan;
use crate::plan::citations::Citation;
use crate::plan::maps::Answer;
use crate::plan::plane_material::plane_material;
use crate::plan::state_watch::StateWatch;
use crate::scene::sweep::Sweep;
use crate::scene::typed::{
    BranchParameter, PoissonRatio, Scene, Sliding, SlidingBranch, SlidingContact, SlidingIndenter, SlidingLoad, SlidingTask, SlidingZone,
    Units,
};
use columns::at;
use scale::Scale;
use viscotack::closure::work_by_speed::WorkBySpeed;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::steady::{Indenter, SlidingControl, SlidingProblem, WaveAdhesion};

/// A sliding contact, ready to be solved.
#[derive(Debug, Clone)]
pub(super) struct SlidingPlan {
    sliding: Sliding,
    /// Both bodies together, with plane moduli.
    material: PlaneMaterial,
    /// The same contact of stiffer solids, of which a liquid is the limit; none of a solid.
    stiffer: Vec<Self>,
    poisson_ratio: PoissonRatio,
    /// How the works of adhesion follow kv, or v/L.
    work_by_rate: Option<WorkBySpeed>,
    scale: Scale,
    units: Units,
    accuracy: f64,
    /// Whether a sweep follows.
    swept: bool,
    /// The speeds of the sweep, or the one of the scene.
    speeds: Vec<f64>,
}

impl SlidingPlan {
    pub(super) fn new(scene: &Scene, sliding: &Sliding) -> Result<Self, Refusal> {
        let material = plane_material(scene, sliding.counter_body)?;
        let (material, stiffer) = liquid::solids(sliding, material)?;
        let relaxed = material.solid_modulus("a steady sliding contact")?;
        let scale = Scale::new(sliding, relaxed, scene.units);
        let mut plan = Self {
            work_by_rate: sliding.work_by_speed.as_ref().map(|law| law.in_unit(scale.length)),
            scale,
            sliding: sliding.clone(),
            material,
            stiffer: Vec::new(),
            poisson_ratio: scene.material.poisson(),
            units: scene.units,
            accuracy: scene.accuracy,
            swept: !scene.sweeps.is_empty(),
            speeds: match (&sliding.task, scene.sweeps.iter().find(|sweep| sweep.key == "sliding.speed")) {
                (SlidingTask::Branch(SlidingBranch { parameter: BranchParameter::Speed, range: Some(range), .. }), _) => range.to_vec(),
                (_, Some(sweep)) => sweep.values.clone(),
                (_, None) => vec![sliding.speed],
            },
        };
        plan.stiffer = stiffer.into_iter().map(|material| plan.of(material)).collect();
        let Scale { length, displacement, slope, pressure, friction, load, work_of_adhesion, energy_per_width } = plan.scale;
        let scales = [length, displacement, slope, pressure, friction, load, work_of_adhesion, energy_per_width];
        let representable = |value: f64| value.is_finite() && value > 0.0;
        if scales.into_iter().all(representable) && plan.characteristic_numbers().iter().all(|group| group.value.is_finite()) {
            Ok(plan)
        } else {
            Err(Refusal::Undefined {
                quantity: "the scale of the sliding contact",
                reason: "the lengths, moduli, loads and the work of adhesion are zero or so far apart that numbers overflow".into(),
            })
        }
    }

    /// The same contact of another material.
    fn of(&self, material: PlaneMaterial) -> Self {
        let scale = Scale::new(&self.sliding, material.relaxed_modulus(), self.units);
        let work_by_rate = self.sliding.work_by_speed.as_ref().map(|law| law.in_unit(scale.length));
        Self { material, scale, work_by_rate, stiffer: Vec::new(), ..self.clone() }
    }

    fn is_wave(&self) -> bool {
        matches!(self.sliding.indenter, SlidingIndenter::Wave { .. })
    }

    /// kv, or v/L: whichever way it slides.
    fn rate(&self, speed: f64) -> f64 {
        speed.abs() / self.scale.length
    }

    /// Γ and both process zones.
    fn reduced_adhesion(&self) -> Option<WaveAdhesion> {
        let adhesion = self.sliding.adhesion?;
        let [trailing_work, leading_work] = adhesion.works.map(|work| work / self.scale.work_of_adhesion);
        let (trailing_zone, leading_zone) = match adhesion.process_zone {
            SlidingZone::Lengths { trailing, leading } => (trailing / self.scale.length, leading / self.scale.length),
            SlidingZone::Cohesive { cohesive_stress, factor, grows } => {
                // αa₀, a₀ = E0*Δγ/(πσ_c²).
                let stress = cohesive_stress / self.scale.pressure;
                let zones = [trailing_work, leading_work].map(|work| 4.0 * factor * work / (stress * stress));
                let [trailing, leading] = if grows { growing::grown(&self.material, self.rate(self.sliding.speed), zones) } else { zones };
                (trailing, leading)
            }
        };
        Some(WaveAdhesion { trailing_work, leading_work, trailing_zone, leading_zone })
    }

    /// What the solver is asked.
    fn problem(&self, contact: SlidingContact) -> Result<SlidingProblem<'_>, Refusal> {
        let control = self.control();
        let without = |limit_name| Refusal::NoSuchState {
            reason: "without adhesion nothing holds a contact that is not pressed".into(),
            limit_name,
            limit: 0.0,
        };
        let adhesion = match (contact, control) {
            (SlidingContact::Adhesive, _) => self.reduced_adhesion(),
            (SlidingContact::Adhesiveless, SlidingControl::MeanPressure(load)) if load <= 0.0 => return Err(without("the load")),
            (SlidingContact::Adhesiveless, SlidingControl::Penetration(depth)) if depth <= 0.0 => return Err(without("the penetration")),
            (SlidingContact::Adhesiveless, _) => None,
        };
        Ok(SlidingProblem {
            rate: self.rate(self.sliding.speed),
            indenter: self.indenter(),
            adhesion,
            work_by_speed: self.work_by_rate.as_ref(),
            control,
            accuracy: self.accuracy,
        })
    }

    fn indenter(&self) -> Indenter {
        if self.is_wave() { Indenter::Wave } else { Indenter::Parabola }
    }

    /// What is prescribed; along every load of no meaning.
    fn control(&self) -> SlidingControl {
        match self.sliding.control {
            SlidingLoad::MeanPressure(load) | SlidingLoad::LoadPerWidth(load) => SlidingControl::MeanPressure(load / self.scale.load),
            SlidingLoad::Penetration(penetration) => SlidingControl::Penetration(penetration / self.scale.displacement),
            SlidingLoad::HalfWidth(half_width) => SlidingControl::HalfWidth(half_width / self.scale.length),
            SlidingLoad::Every => SlidingControl::MeanPressure(0.0),
        }
    }
}

impl ProblemPlan for SlidingPlan {
    fn name(&self) -> &'static str {
        "steady sliding"
    }

    fn labels(&self) -> &'static [&'static str] {
        match self.sliding.task {
            SlidingTask::State => &["contact", "state"],
            SlidingTask::Branch(_) => &["contact", "state", "branch", "event"],
            SlidingTask::Strength => &["contact"],
        }
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

    fn seconds_a_system(&self) -> f64 {
        self.seconds_of_a_system()
    }

    fn predicted_work(&self, states: u64) -> Work {
        self.work_of_states(states) * (1 + self.stiffer.len() as u64)
    }

    fn rows_of_a_state(&self) -> u64 {
        match &self.sliding.task {
            SlidingTask::State => self.sliding.contacts.len() as u64,
            // Along speeds a slow and a fast branch; turns besides.
            SlidingTask::Branch(branch) => 2 * u64::from(branch.points) + 32,
            SlidingTask::Strength => 1,
        }
    }

    fn visited_times(&self) -> Option<[f64; 2]> {
        let speed = self.sliding.speed.abs();
        if self.sliding.task != SlidingTask::State || speed == 0.0 {
            return None;
        }
        let length = match self.sliding.indenter {
            SlidingIndenter::Wave { wavelength, .. } => wavelength,
            SlidingIndenter::Cylinder { radius } => radius,
        };
        // Without adhesion nothing is sharper than the root of the distance to an edge.
        let zone = match self.sliding.adhesion.map(|adhesion| (adhesion.process_zone, adhesion.works)) {
            Some((SlidingZone::Lengths { trailing, leading }, _)) => trailing.min(leading),
            Some((SlidingZone::Cohesive { cohesive_stress, factor, .. }, works)) => {
                let work = works[0].min(works[1]);
                factor * self.material.relaxed_modulus() * work / (std::f64::consts::PI * cohesive_stress * cohesive_stress)
            }
            None => 1e-4 * length,
        };
        Some([0.1 * zone.min(1e-2 * length) / speed, 10.0 * length / speed])
    }

    fn abscissa(&self) -> Option<&'static str> {
        match &self.sliding.task {
            SlidingTask::Branch(branch) => Some(branch.parameter.word()),
            _ => None,
        }
    }

    fn columns(&self) -> Vec<Column> {
        columns::columns(&self.sliding, self.units)
    }

    fn headline(&self) -> &'static [&'static str] {
        match &self.sliding.task {
            SlidingTask::State => &[],
            SlidingTask::Branch(branch) => match branch.parameter {
                BranchParameter::Speed => &["speed", "half_width", "friction_stress", "friction_per_width", "stable_under_load"],
                BranchParameter::WorkOfAdhesion => {
                    &["work_of_adhesion", "half_width", "mean_pressure", "load_per_width", "stable_under_load"]
                }
                BranchParameter::ProcessZone => {
                    &["trailing_process_zone", "half_width", "mean_pressure", "load_per_width", "stable_under_load"]
                }
                _ => &["half_width", "mean_pressure", "load_per_width", "penetration", "stable_under_load", "stable_under_penetration"],
            },
            SlidingTask::Strength => &[
                "pull_off_pressure",
                "pull_off_load_per_width",
                "zero_load_half_width",
                "snap_in_pressure",
                "separation_penetration",
                "toughness",
            ],
        }
    }

    fn field_columns(&self) -> Vec<Column> {
        columns::field_columns(self.sliding.indenter, self.units)
    }

    fn solve(&self, state: usize, swept: &[f64], _: &StateWatch<'_>) -> Vec<Row> {
        match &self.sliding.task {
            SlidingTask::State => self.sliding.contacts.iter().map(|&contact| self.limit_row(contact, state, swept)).collect(),
            SlidingTask::Branch(branch) => self.branch_rows(branch, state, swept),
            SlidingTask::Strength => vec![self.strength_row(state, swept)],
        }
    }

    fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.assessments(rows)
    }

    fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        match &self.sliding.task {
            SlidingTask::State => self.drawings(scene, rows),
            SlidingTask::Branch(branch) => self.branch_drawings(branch, scene, rows),
            SlidingTask::Strength => self.strength_drawings(scene, rows),
        }
    }

    fn answer(&self, rows: &[Row]) -> Option<Answer> {
        let pressed = rows.iter().filter(|row| row.value(at::FRICTION).is_some()).all(|row| row.value(at::COEFFICIENT).is_some());
        let (column, label) = if pressed {
            (at::COEFFICIENT, self.label("friction coefficient", r"$\mu$", "", r"$\mu/k\Lambda$", r"$\mu R/L$"))
        } else {
            (at::FRICTION, self.friction_label())
        };
        // Strengths and branches have tables of their own.
        let plain =
            self.sliding.task == SlidingTask::State && self.columns().get(column).is_some_and(|column| column.name.starts_with("friction"));
        plain.then(|| Answer { column, axis: Axis::linear(label) })
    }

    fn swept_axis(&self, sweep: &Sweep) -> Axis {
        self.axis_of_sweep(sweep)
    }

    fn citations(&self) -> Vec<&'static Citation> {
        self.papers()
    }
}
