//! What a sliding surface is expected to cost: the one place to tune when the solver changes.

use super::SurfacePlan;
use crate::outcome::Work;
use crate::scene::typed::{SlidingContact, SurfacePath, SurfaceTask};
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::line::Request;

/// Nodes along x for a relative error of 1e-3, a relaxed zone of 1/k and one wave: of a smooth law, of a Dugdale law, of a surface.
const NODES: [f64; 3] = [500.0, 4096.0, 100.0];
/// How they grow with the waves of the profile, with one over the zone, and with one over the accuracy.
const BY_WAVES: f64 = 0.75;
const BY_ZONE: f64 = 1.0 / 3.0;
const BY_ACCURACY: f64 = 0.5;
/// The zone that a contact without adhesion is as dear as.
const WITHOUT_ADHESION: f64 = 0.3;
/// Products with the stiffness of a state from nothing, and from a neighbour, counted on the finest grid.
const COLD: f64 = 140.0;
const NEIGHBOUR: f64 = 110.0;
/// States from nothing that a search for every state is as dear as.
const EVERY: f64 = 8.0;
/// Steps of a load that is raised or lowered to the wanted one.
const STEPS: f64 = 12.0;
/// Bytes of a node while a state is solved: the vectors of the linear solver, the transforms, the fields.
const BYTES_A_NODE: u64 = 8 * (60 + 24);

impl SurfacePlan {
    /// The nodes of the finest grid, as expected; of a swept range at its shortest.
    fn expected_nodes(&self, contact: SlidingContact) -> u64 {
        self.nodes_of(contact, self.request())
    }

    fn nodes_of(&self, contact: SlidingContact, request: Request) -> u64 {
        let law = self.attraction(contact).ok().filter(Attraction::attracts);
        let zone = law.as_ref().map_or(WITHOUT_ADHESION, |law| {
            std::f64::consts::FRAC_2_PI * law.work_of_adhesion / law.peak_stress().powi(2) * self.shortest_range.powi(2)
        });
        let amplitudes = self.profile.amplitudes();
        let highest = amplitudes.iter().copied().fold(0.0, f64::max);
        let waves = amplitudes.iter().filter(|amplitude| **amplitude > 1e-3 * highest).count().max(1) as f64;
        let which = match law.map(|law| law.law) {
            _ if !self.is_line() => NODES[2],
            Some(Law::Dugdale { .. }) => NODES[1],
            _ => NODES[0],
        };
        let needed = which * waves.powf(BY_WAVES) / zone.max(1e-9).powf(BY_ZONE) * (1e-3 / request.accuracy).powf(BY_ACCURACY);
        let nodes = (needed.min(1e9) as usize).next_power_of_two().clamp(request.least_nodes, request.most_nodes) as u64;
        if self.is_line() { nodes } else { nodes * nodes }
    }

    pub(super) fn work_of_states(&self, states: u64) -> Work {
        let products = match self.sliding.task {
            SurfaceTask::State if self.sliding.reached_by == SurfacePath::Every => EVERY * COLD,
            SurfaceTask::State => COLD,
            SurfaceTask::Loop { points, .. } => COLD + 2.0 * f64::from(points) * NEIGHBOUR,
            SurfaceTask::Branch { points } => 2.0 * (COLD + f64::from(points) * NEIGHBOUR),
        };
        let contacts = self.sliding.contacts.len() as u64;
        let nodes: f64 = self.sliding.contacts.iter().map(|&contact| self.expected_nodes(contact) as f64).sum();
        // The states on the way to a load that is raised or lowered are rough.
        let on_the_way = if self.sliding.task == SurfaceTask::State
            && matches!(self.sliding.reached_by, SurfacePath::Loading | SurfacePath::Unloading)
        {
            self.sliding.contacts.iter().map(|&contact| STEPS * NEIGHBOUR * self.nodes_of(contact, self.rough_request()) as f64).sum()
        } else {
            0.0
        };
        let of_a_state = (products * nodes + on_the_way).min(1e18) as u64;
        let fields = self.sliding.field_points.map_or(0, |points| self.points_of_fields(points as usize)) as u64;
        Work {
            kernel_evaluations: of_a_state.saturating_mul(states),
            field_evaluations: fields.saturating_mul(contacts).saturating_mul(states),
            ..Work::default()
        }
    }

    /// Nodes at which fields are given, at most.
    const fn points_of_fields(&self, points: usize) -> usize {
        if self.is_line() { points } else { points * points }
    }

    pub(super) fn memory(&self) -> u64 {
        (1 << 20) + BYTES_A_NODE * self.sliding.contacts.iter().map(|&contact| self.expected_nodes(contact)).max().unwrap_or(0)
    }
}
