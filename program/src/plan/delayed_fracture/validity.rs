//! Where the model of a crack under a load history may fail: each number at the greatest load and speed of the history.

use super::DelayedFracturePlan;
use super::solve::Scales;
use crate::outcome::{Row, Validity};
use crate::plan::assumptions::{Assumption, Limit, assessed, constant_poisson_ratio, not_assessed};
use crate::scene::typed::{ProcessZoneLaw, Units};
use viscotack::crack::delayed::GrowthProblem;
use viscotack::crack::delayed::validity::growth_validity;

/// The assumptions, in the order of [`DelayedFracturePlan::assumptions`].
const ASSUMPTIONS: [Assumption; 6] = [
    Assumption {
        name: "process zone (m)",
        limit: Limit::Above(1e-9),
        meaning: "a continuum needs a process zone longer than about 1 nm, the size of a molecule",
    },
    Assumption {
        name: "process zone over strip half-height",
        limit: Limit::Below(0.05),
        meaning: "the square-root field of the tip must reach beyond the process zone",
    },
    Assumption {
        name: "remote stress over cohesive stress",
        limit: Limit::Below(0.1),
        meaning: "the far stress must be small against the cohesive stress",
    },
    Assumption {
        name: "cohesive stress over glassy modulus",
        limit: Limit::Below(0.3),
        meaning: "the material about the process zone must stay linear",
    },
    Assumption {
        name: "memory length v·τ_max over strip half-height",
        limit: Limit::Below(0.3),
        meaning: "the fading wake of a fast crack must be short in the strip, or its K is no longer that of the far stress alone",
    },
    Assumption {
        name: "remote strain of the strip",
        limit: Limit::Below(0.2),
        meaning: "small-strain theory: the relaxed strain under the greatest stress",
    },
];

impl DelayedFracturePlan {
    /// The numbers that the assumptions are assessed by.
    pub(super) fn assumptions(&self, problem: &GrowthProblem<'_>, scales: &Scales) -> Vec<Option<f64>> {
        let peak = self.history.peak();
        let zone = problem.process_zone_at(peak);
        let cohesive = match self.crack.process_zone {
            ProcessZoneLaw::Cohesive { cohesive_stress, .. } => Some(cohesive_stress),
            ProcessZoneLaw::Length(_) => None,
        };
        let si = (self.units == Units::Si).then_some(());
        let (mut zone_over_height, mut stress_ratio, mut memory, mut strain) = (None, None, None, None);
        if let (Some(strip), Some(loaded)) = (&self.strip, self.crack.strip)
            && let Ok(stress) = strip.stress(peak)
        {
            let height = loaded.half_height;
            if let Ok(numbers) = growth_validity(zone, height, stress, cohesive) {
                (zone_over_height, stress_ratio) = (Some(numbers.zone_to_half_height), numbers.remote_to_cohesive_stress);
            }
            memory = self.plane_material.longest_retardation_time().map(|time| scales.speed * time / height);
            // The stress of unit strain is the stiffness of the strip.
            strain = strip.stress_by_grip_displacement(height, self.youngs_relaxed_modulus).ok().map(|stiffness| stress / stiffness);
        }
        vec![
            si.and(Some(zone)),
            zone_over_height,
            stress_ratio,
            si.and(cohesive.map(|stress| stress / self.plane_material.glassy_modulus())),
            memory,
            strain,
        ]
    }

    pub(super) fn assessments(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = assessed(&ASSUMPTIONS, rows);
        entries.extend(crate::plan::measured::records(&self.crack.history, self.accuracy));
        entries.extend(constant_poisson_ratio(self.poisson_ratio));
        entries.push(not_assessed(
            "healing, inertia and heat",
            None,
            "left out: the faces never join again, speeds must stay far below the shear-wave speed, and the tip isothermal",
        ));
        entries
    }
}
