//! What a sliding surface is expected to cost: the one place to tune when the solver changes.

use super::SurfacePlan;
use crate::outcome::Work;
use crate::scene::typed::{SlidingContact, SurfacePath, SurfaceTask};

/// Nodes along x for a relative error of 1e-4, over the period in relaxed zones of the law: measured over the shipped scenes.
const NODES_A_ZONE: f64 = 2.0;
/// How the error falls with the nodes.
const ORDER: f64 = 1.5;
/// Products with the stiffness of a state from nothing, and from a neighbour, counted on the finest grid.
const COLD: f64 = 150.0;
const NEIGHBOUR: f64 = 70.0;
/// Steps of a load that is raised or lowered to the wanted one.
const STEPS: f64 = 12.0;
/// Bytes of a node while a state is solved: the vectors of the linear solver, the transforms, the fields.
const BYTES_A_NODE: u64 = 8 * (60 + 24);

impl SurfacePlan {
    /// The nodes of the finest grid, as expected.
    fn expected_nodes(&self) -> u64 {
        let request = self.request();
        let zone = self
            .attraction(SlidingContact::Adhesive)
            .ok()
            .filter(|law| law.attracts())
            .map_or(0.05, |law| std::f64::consts::FRAC_2_PI * law.work_of_adhesion / law.peak_stress().powi(2));
        let needed = NODES_A_ZONE * std::f64::consts::TAU / zone.max(1e-9) * (1e-4 / self.accuracy).powf(1.0 / ORDER);
        let nodes = (needed.min(1e9) as usize).next_power_of_two().clamp(request.least_nodes, request.most_nodes) as u64;
        if self.is_line() { nodes } else { nodes * nodes }
    }

    pub(super) fn work_of_states(&self, states: u64) -> Work {
        let nodes = self.expected_nodes() as f64;
        let products = match self.sliding.task {
            SurfaceTask::State if self.sliding.reached_by == SurfacePath::LongRange => COLD,
            SurfaceTask::State => COLD + STEPS * NEIGHBOUR,
            SurfaceTask::Loop { points, .. } => COLD + 2.0 * f64::from(points) * NEIGHBOUR,
            SurfaceTask::Branch { points } => 2.0 * (COLD + f64::from(points) * NEIGHBOUR),
        };
        let contacts = self.sliding.contacts.len() as u64;
        let of_a_state = (products * nodes).min(1e18) as u64;
        let fields = self.sliding.field_points.map_or(0, |points| self.points_of_fields(points as usize)) as u64;
        Work {
            kernel_evaluations: of_a_state.saturating_mul(contacts).saturating_mul(states),
            field_evaluations: fields.saturating_mul(contacts).saturating_mul(states),
            ..Work::default()
        }
    }

    /// Nodes at which fields are given, at most.
    const fn points_of_fields(&self, points: usize) -> usize {
        if self.is_line() { points } else { points * points }
    }

    pub(super) fn memory(&self) -> u64 {
        (1 << 20) + BYTES_A_NODE * self.expected_nodes()
    }
}
