//! The one place of this plan that asks [`crate::indentation`] for a march.

use super::IndentationPlan;
use crate::indentation::{Adhesion, Control, History, IndentationProblem, IndentationSolution, Profile, Resolution, Segment, Start, run};
use crate::refusal::Refusal;
use crate::scene::typed::{HistoryQuantity, IndentationShape, IndentationStart, IndentationZone};
use spec_math::Gamma;
use std::f64::consts::PI;

impl IndentationPlan {
    pub(super) fn profile(&self) -> Profile {
        match self.indentation.shape {
            IndentationShape::Sphere { radius } => Profile::Paraboloid { radius },
            IndentationShape::Cone { slope } => Profile::Cone { slope },
            // z = c r^m has f = c (m + 1) s^m ∫₀¹ x^{m+1}/√(1 − x²) dx, and the integral is (√π/2) Γ(m/2 + 1)/Γ(m/2 + 3/2).
            IndentationShape::PowerLaw { radius, exponent } => Profile::PowerLaw {
                coefficient: (exponent + 1.0) * 0.5 * PI.sqrt() * Gamma::gamma(&(0.5 * exponent + 1.0))
                    / Gamma::gamma(&(0.5 * exponent + 1.5))
                    / (exponent * radius.powf(exponent - 1.0)),
                exponent,
            },
        }
    }

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
        if self.timeline.legs.iter().any(|leg| leg.quantity != quantity) || quantity == HistoryQuantity::Frame {
            return Err(Refusal::Undefined { quantity: "a history that changes what it controls", reason: "not yet".into() });
        }
        let segments = self.timeline.legs.iter().map(|leg| Segment { duration: leg.duration, end: leg.end }).collect();
        let history = History { start, segments };
        let control = match quantity {
            HistoryQuantity::Force => Control::Force(history),
            HistoryQuantity::ContactRadius => Control::ContactRadius(history),
            _ => Control::Penetration(history),
        };
        Ok(IndentationProblem {
            profile: self.profile().checked()?,
            adhesion: self.adhesion(),
            control,
            start: match self.indentation.start {
                IndentationStart::Untouched => Start::Untouched,
                IndentationStart::Relaxed => Start::Relaxed,
            },
            instants_per_segment: 1,
            resolution: Resolution::default(),
        })
    }

    pub(super) fn solution(&self) -> Result<IndentationSolution, Refusal> {
        run(&self.material, &self.problem()?)
    }
}
