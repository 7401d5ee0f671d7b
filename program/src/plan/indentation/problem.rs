//! The one place of this plan that asks [`viscotack::indentation`] for an integration.

use super::IndentationPlan;
use super::timeline::Leg;
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::{HistoryQuantity, Indentation, IndentationShape, IndentationStart, IndentationZone};
use spec_math::Gamma;
use std::f64::consts::PI;
use std::sync::Arc;
use viscotack::indentation::by_panels::solve_periodic;
use viscotack::indentation::{
    Adhesion, Controlled, History, IndentationProblem, IndentationSolution, Profile, Segment, Start, run_watched,
};
use viscotack::refusal::Refusal;

/// The indenter of a scene.
pub(super) fn profile(indentation: &Indentation) -> Result<Profile, Refusal> {
    let face = match indentation.shape {
        IndentationShape::Sphere { radius } => Profile::Paraboloid { radius },
        IndentationShape::Cone { slope } => Profile::Cone { slope },
        IndentationShape::FlatPunch { radius } => Profile::FlatPunch { radius },
        // z = c r^m has f = c (m + 1) s^m ∫₀¹ x^{m+1}/√(1 − x²) dx, and the integral is (√π/2) Γ(m/2 + 1)/Γ(m/2 + 3/2).
        IndentationShape::PowerLaw { radius, exponent } => Profile::PowerLaw {
            coefficient: (exponent + 1.0) * 0.5 * PI.sqrt() * Gamma::gamma(&(0.5 * exponent + 1.0))
                / Gamma::gamma(&(0.5 * exponent + 1.5))
                / (exponent * radius.powf(exponent - 1.0)),
            exponent,
        },
        IndentationShape::Table { ref points, .. } => Profile::table(points)?,
    };
    match indentation.rim_radius {
        Some(rim) => Profile::Rimmed { face: Arc::new(face), rim },
        None => face,
    }
    .checked()
}

impl IndentationPlan {
    /// Δγ and δ, coherent.
    pub(super) fn adhesion(&self) -> Option<Adhesion> {
        let given = self.indentation.adhesion?;
        let work_of_adhesion = given.work_of_adhesion * self.scale.force;
        let process_zone = match given.process_zone {
            IndentationZone::Length(length) => length,
            IndentationZone::Cohesive { cohesive_stress, factor } => {
                let stress = cohesive_stress * self.scale.force;
                factor * self.relaxed * work_of_adhesion / (PI * stress * stress)
            }
        };
        Some(Adhesion { work_of_adhesion, process_zone })
    }

    /// What the solver is asked.
    pub(super) fn problem(&self) -> Result<IndentationProblem, Refusal> {
        let (quantity, start) = self.timeline.start;
        let segment = |leg: &Leg| Segment {
            duration: leg.duration,
            end: leg.end,
            controlled: controlled(leg.quantity),
            oscillation: leg.oscillation,
        };
        let history = History { start, controlled: controlled(quantity), segments: self.timeline.legs.iter().map(segment).collect() };
        let problem = IndentationProblem {
            profile: self.profile.clone(),
            adhesion: self.adhesion(),
            edge_law: self.indentation.edge_law.clone(),
            history,
            frame_stiffness: self.indentation.frame_stiffness.map(|stiffness| stiffness * self.scale.force),
            start: match self.indentation.start {
                IndentationStart::Untouched => Start::Untouched,
                IndentationStart::Relaxed => Start::Relaxed,
            },
            instants_per_segment: 1,
            // Without adhesion the path has few points, and the account of energies costs little: the work of repetitions is from there.
            energies: self.indentation.energies || (self.indentation.adhesion.is_none() && !self.timeline.repetitions.is_empty()),
            accuracy: self.solver_accuracy,
        };
        problem.checked()?;
        Ok(problem)
    }

    pub(super) fn solution(&self, state_watch: &StateWatch<'_>) -> Result<IndentationSolution, Refusal> {
        if self.timeline.periodic {
            let problem = self.problem()?;
            return Ok(solve_periodic(&self.material, &problem, self.indentation.instants)?.solution());
        }
        run_watched(&self.material, &self.problem()?, state_watch.left_off(), Some(state_watch))
    }
}

const fn controlled(quantity: HistoryQuantity) -> Controlled {
    match quantity {
        HistoryQuantity::Force => Controlled::Force,
        HistoryQuantity::ContactRadius => Controlled::ContactRadius,
        HistoryQuantity::Frame => Controlled::Frame,
        // A scene lets an indenter control no others.
        HistoryQuantity::Penetration | HistoryQuantity::StressIntensity | HistoryQuantity::Stress => Controlled::Penetration,
    }
}
