//! The plan of a surface that slides steadily and acts at a distance: profile, law, layer, load; states, loops of the load, branches.

mod columns;
mod cost;
mod describe;
mod fields;
mod figures;
mod maps;
mod rows;
mod ways;

use crate::outcome::plot::{Axis, Figure};
use crate::outcome::{Column, Effect, Group, Row, Validity, Work};
use crate::plan::ProblemPlan;
use crate::plan::citations::Citation;
use crate::plan::maps::Answer;
use crate::plan::plane_material::plane_material;
use crate::plan::state_watch::StateWatch;
use crate::scene::sweep::Sweep;
use crate::scene::typed::{PoissonRatio, Scene, SlidingContact, SurfaceLoad, SurfacePath, SurfaceSliding, SurfaceTask, Units};
use columns::at;
use std::f64::consts::TAU;
use viscotack::finite_range::law::Attraction;
use viscotack::finite_range::line::{Control, Modulus, Problem, Profile, Request, Scales, modulus_of};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::layer::Layer;

/// Nodes along x that the accuracy may take where a scene names no number: of a line and of a surface.
const MOST_NODES: [usize; 2] = [1 << 16, 512];
/// The first grid that may be the answer.
const LEAST_NODES: [usize; 2] = [512, 128];

/// States that one scene may have, at most, where every one is asked for.
const STATES: u64 = 16;

/// A sliding surface, ready to be solved.
#[derive(Clone)]
pub(super) struct SurfacePlan {
    sliding: SurfaceSliding,
    /// Both bodies together, with plane moduli.
    material: PlaneMaterial,
    modulus: Modulus,
    poisson_ratio: PoissonRatio,
    /// What one reduced unit is in the units of the scene.
    scales: Scales,
    /// The profile in units of Λ, as it moves towards +x.
    profile: Profile,
    layer: Option<Layer>,
    units: Units,
    accuracy: f64,
    swept: bool,
    /// The shortest range of a sweep over the one of this state.
    shortest_range: f64,
}

impl std::fmt::Debug for SurfacePlan {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("SurfacePlan").field("sliding", &self.sliding).field("scales", &self.scales).finish_non_exhaustive()
    }
}

impl SurfacePlan {
    pub(super) fn new(scene: &Scene, sliding: &SurfaceSliding) -> Result<Self, Refusal> {
        let material = plane_material(scene, sliding.counter_body)?;
        let modulus = modulus_of(&material)?;
        let surface = &sliding.surface;
        let si = scene.units == Units::Si;
        let height = if si { surface.profile.half_height() } else { 1.0 };
        let scales = if si {
            Scales::new(material.relaxed_modulus(), surface.period, height)?
        } else {
            Scales { length: 1.0, height: 1.0, pressure: 1.0, friction: 1.0, work: 1.0 }
        };
        let profile = surface.profile.scaled(1.0 / height)?;
        let profile = if sliding.speed < 0.0 { profile.mirrored() } else { profile };
        let layer =
            sliding.layer.map(|layer| Layer::new(layer.backing, layer.poisson_ratio, layer.thickness / scales.length)).transpose()?;
        if let (Some(_), Some(_)) = (layer, sliding.counter_body) {
            return Err(Refusal::Undefined {
                quantity: "the compliance of a layer and a counter body",
                reason: "the factor of a layer would stiffen the counter body, too; leave sliding.counter_body or sliding.layer out"
                    .to_owned(),
            });
        }
        let plan = Self {
            sliding: sliding.clone(),
            material,
            modulus,
            poisson_ratio: scene.material.poisson(),
            scales,
            profile,
            layer,
            units: scene.units,
            accuracy: scene.accuracy,
            swept: !scene.sweeps.is_empty(),
            shortest_range: shortest_range(scene, sliding),
        };
        plan.attraction(SlidingContact::Adhesive)?;
        let Scales { length, height, pressure, friction, work } = plan.scales;
        let representable = |value: f64| value.is_finite() && value > 0.0;
        if [length, height, pressure, friction, work].into_iter().all(representable) {
            Ok(plan)
        } else {
            Err(Refusal::Undefined {
                quantity: "the scale of the sliding surface",
                reason: "the lengths, moduli and the work of adhesion are zero or so far from each other that numbers overflow".into(),
            })
        }
    }

    const fn is_line(&self) -> bool {
        self.profile.is_line()
    }

    /// kv, whichever way it slides.
    fn frequency(&self) -> f64 {
        self.scales.frequency(self.sliding.speed.abs())
    }

    /// −1 where the surface slides along −x.
    fn direction(&self) -> f64 {
        if self.sliding.speed < 0.0 { -1.0 } else { 1.0 }
    }

    /// The law of a kind of contact in reduced units.
    fn attraction(&self, contact: SlidingContact) -> Result<Attraction, Refusal> {
        match (&self.sliding.attraction, contact) {
            (Some(law), SlidingContact::Adhesive) => law.attraction.in_units(self.scales.height, self.scales.pressure),
            _ => Ok(Attraction::hard_wall()),
        }
    }

    fn control(&self) -> Control {
        match self.sliding.control {
            SurfaceLoad::MeanPressure(pressure) => Control::MeanPressure(pressure / self.scales.pressure),
            SurfaceLoad::MeanGap(gap) => Control::MeanGap(gap / self.scales.height),
            SurfaceLoad::Frame { stiffness, mean_gap } => {
                Control::Frame { stiffness: stiffness * self.scales.height / self.scales.pressure, position: mean_gap / self.scales.height }
            }
        }
    }

    /// What the solver is asked.
    fn problem(&self, contact: SlidingContact) -> Result<Problem, Refusal> {
        Ok(Problem {
            profile: self.profile.clone(),
            modulus: self.modulus.clone(),
            speed: self.frequency(),
            attraction: self.attraction(contact)?,
            layer: self.layer,
            control: self.control(),
        })
    }

    /// How exact, and on how many nodes. No wave of the profile may be cut on the grid of the answer.
    fn request(&self) -> Request {
        let which = usize::from(!self.is_line());
        let own = self.profile.nodes()[0].next_power_of_two();
        // Every place of a field is a node.
        let places = self.sliding.field_points.map_or(0, |points| (points as usize).next_power_of_two());
        let most = self.sliding.most_nodes.map_or(MOST_NODES[which], |nodes| nodes as usize);
        // The largest power of two that is allowed.
        let most = if most.is_power_of_two() { most } else { most.next_power_of_two() / 2 };
        let most = most.max(2 * own).max(places);
        let least = LEAST_NODES[which].max(own).max(places).min(most);
        Request { accuracy: self.accuracy, least_nodes: least, most_nodes: most }
    }
}

fn shortest_range(scene: &Scene, sliding: &SurfaceSliding) -> f64 {
    let swept = scene.sweeps.iter().find(|sweep| sweep.key == "adhesion.range");
    let shortest = swept.and_then(|sweep| sweep.values.iter().copied().reduce(f64::min));
    match (shortest, &sliding.attraction) {
        (Some(shortest), Some(law)) => (shortest / law.attraction.range).min(1.0),
        _ => 1.0,
    }
}

impl ProblemPlan for SurfacePlan {
    fn name(&self) -> &'static str {
        "steady sliding of a surface"
    }

    fn labels(&self) -> &'static [&'static str] {
        match self.sliding.task {
            SurfaceTask::State => &["contact", "state", "reached_by"],
            SurfaceTask::Loop { .. } | SurfaceTask::Branch { .. } => &["contact", "state", "reached_by", "event"],
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

    fn predicted_work(&self, states: u64) -> Work {
        self.work_of_states(states)
    }

    fn rows_of_a_state(&self) -> u64 {
        match self.sliding.task {
            SurfaceTask::State if self.sliding.reached_by == SurfacePath::Every => STATES * self.sliding.contacts.len() as u64,
            SurfaceTask::State => self.sliding.contacts.len() as u64,
            SurfaceTask::Loop { points, .. } => 2 * u64::from(points),
            SurfaceTask::Branch { points } => 2 * u64::from(points) + 16,
        }
    }

    fn memory_of_a_state(&self) -> u64 {
        self.memory()
    }

    fn visited_times(&self) -> Option<[f64; 2]> {
        let speed = self.sliding.speed.abs();
        if speed == 0.0 {
            return None;
        }
        let shortest = TAU * self.scales.length / self.request().most_nodes as f64;
        Some([shortest / speed, 10.0 * TAU * self.scales.length / speed])
    }

    fn columns(&self) -> Vec<Column> {
        columns::columns(self.units)
    }

    fn headline(&self) -> &'static [&'static str] {
        &["speed", "friction_stress", "friction_coefficient", "mean_pressure", "mean_gap", "contact_fraction", "patches"]
    }

    fn field_columns(&self) -> Vec<Column> {
        columns::field_columns(self.is_line(), self.units)
    }

    fn solve(&self, state: usize, swept: &[f64], _: &StateWatch<'_>) -> Vec<Row> {
        match self.sliding.task {
            SurfaceTask::State => self.sliding.contacts.iter().flat_map(|&contact| self.state_rows(contact, state, swept)).collect(),
            SurfaceTask::Loop { to, points } => self.loop_rows(to, points, state, swept),
            SurfaceTask::Branch { points } => self.branch_rows(points, state, swept),
        }
    }

    fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.assessments(rows)
    }

    fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        self.drawings(scene, rows)
    }

    fn answer(&self, rows: &[Row]) -> Option<Answer> {
        let pressed = rows.iter().filter(|row| row.value(at::FRICTION).is_some()).all(|row| row.value(at::COEFFICIENT).is_some());
        let (column, label) = if pressed { (at::COEFFICIENT, self.coefficient_label()) } else { (at::FRICTION, self.friction_label()) };
        (self.sliding.task == SurfaceTask::State).then(|| Answer { column, axis: Axis::linear(label) })
    }

    fn swept_axis(&self, sweep: &Sweep) -> Axis {
        self.axis_of_sweep(sweep)
    }

    fn citations(&self) -> Vec<&'static Citation> {
        self.papers()
    }
}
