//! Where the model of a steady crack may fail: numbers formed for every row, and the assessment of the worst of them.

use super::SteadyCrackPlan;
use super::columns::at;
use crate::outcome::{Row, Validity};
use crate::plan::assumptions::{Assumption, Limit, assessed, constant_poisson_ratio, not_assessed};
use crate::scene::typed::{CrackControl, ProcessZoneLaw, Units};
use viscotack::estimate::Estimate;

/// The assumptions, in the order of [`SteadyCrackPlan::assumptions`].
const ASSUMPTIONS: [Assumption; 7] = [
    Assumption {
        name: "process zone (m)",
        limit: Limit::Above(1e-9),
        meaning: "a continuum needs a process zone longer than about 1 nm, the size of a molecule",
    },
    Assumption {
        name: "face slope at the process zone",
        limit: Limit::Below(0.3),
        meaning: "linear elasticity wants slopes well below one there",
    },
    Assumption {
        name: "cohesive stress over glassy modulus",
        limit: Limit::Below(0.3),
        meaning: "the material about the process zone must stay linear",
    },
    Assumption {
        name: "process zone over strip half-height",
        limit: Limit::Below(0.05),
        meaning: "the square-root field of the tip must reach beyond the process zone",
    },
    Assumption {
        name: "memory length v·τ_max over strip half-height",
        limit: Limit::Below(0.3),
        meaning: "faster cracks leave stiff material at the clamps, and the energy released is then not that of the relaxed strip",
    },
    Assumption {
        name: "remote stress over cohesive stress",
        limit: Limit::Below(0.1),
        meaning: "the far stress must be small against the cohesive stress",
    },
    Assumption {
        name: "remote strain of the strip",
        limit: Limit::Below(0.2),
        meaning: "small-strain theory; at large stretch take G from the measured energy density instead",
    },
];

impl SteadyCrackPlan {
    /// The numbers that the assumptions are assessed by, for one row.
    pub(super) fn assumptions(&self, values: &[Option<Estimate>]) -> Vec<Option<f64>> {
        let value = |column: usize| values.get(column).copied().flatten().map(|estimate| estimate.value);
        let zone = value(at::PROCESS_ZONE);
        let cohesive = match self.crack.process_zone {
            ProcessZoneLaw::Cohesive { cohesive_stress, .. } => Some(cohesive_stress),
            ProcessZoneLaw::Length(_) => None,
        };
        let si = (self.units == Units::Si).then_some(());
        let (mut zone_over_height, mut memory_over_height, mut stress_ratio, mut strain) = (None, None, None, None);
        if let CrackControl::Strip(strip) = self.crack.control
            && let (Ok(stress), Ok(geometry)) = (self.strip_stress(&strip), self.strip(&strip))
        {
            let height = strip.half_height;
            zone_over_height = zone.map(|zone| zone / height);
            memory_over_height =
                value(at::SPEED).zip(self.plane_material.longest_retardation_time()).map(|(speed, time)| speed * time / height);
            stress_ratio = cohesive.map(|cohesive| stress / cohesive);
            // The stress of unit strain is the stiffness of the strip.
            strain = geometry
                .stress_by_grip_displacement(height, self.youngs_material.relaxed_modulus())
                .ok()
                .map(|stiffness| stress / stiffness);
        }
        vec![
            si.and(zone),
            // u(δ)/δ of one face with the tip radius r: √(2r/δ).
            si.and(value(at::GLASSY_RADIUS).zip(zone).map(|(radius, zone)| (2.0 * radius / zone).sqrt())),
            si.and(cohesive.map(|stress| stress / self.plane_material.glassy_modulus())),
            zone_over_height,
            memory_over_height,
            stress_ratio,
            strain,
        ]
    }

    pub(super) fn assessments(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = assessed(&ASSUMPTIONS, rows);
        entries.extend(constant_poisson_ratio(self.poisson_ratio));
        entries.push(not_assessed(
            "inertia and heat",
            None,
            "left out: speeds must stay far below the shear-wave speed, and the tip isothermal",
        ));
        entries
    }
}
