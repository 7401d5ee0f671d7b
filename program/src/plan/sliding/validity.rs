//! Where the model of a sliding contact may fail.

use super::SlidingPlan;
use super::columns::at;
use crate::outcome::{Row, Validity};
use crate::plan::assumptions::{Assumption, Limit, assessed, constant_poisson_ratio, not_assessed};
use crate::scene::typed::{SlidingIndenter, SlidingZone, Units};

/// The assumptions, in the order of [`SlidingPlan::assumptions`].
const ASSUMPTIONS: [Assumption; 5] = [
    Assumption {
        name: "process zone over half-width",
        limit: Limit::Below(0.1),
        meaning: "the edge must be small against the contact, whose far field is that of a sharp edge",
    },
    Assumption {
        name: "process zone (m)",
        limit: Limit::Above(1e-9),
        meaning: "a continuum needs a process zone longer than about 1 nm, the size of a molecule",
    },
    Assumption {
        name: "slope kΛ of the wave",
        limit: Limit::Below(0.3),
        meaning: "linear elasticity of a half-plane wants slopes well below one",
    },
    Assumption {
        name: "half-width over radius",
        limit: Limit::Below(0.2),
        meaning: "the parabola stands for the cylinder, and the half-plane for the body, only where the contact is narrow",
    },
    Assumption {
        name: "cohesive stress over glassy modulus",
        limit: Limit::Below(0.3),
        meaning: "the material about the process zone must stay linear",
    },
];

impl SlidingPlan {
    /// The numbers that the assumptions are assessed by, for one row.
    pub(super) fn assumptions(&self, row: &Row) -> Vec<Option<f64>> {
        self.assumed(row.value(at::HALF_WIDTH), [row.value(at::TRAILING_ZONE), row.value(at::LEADING_ZONE)])
    }

    /// The same from a half-width and the process zones.
    pub(super) fn assumed(&self, half_width: Option<f64>, zones: [Option<f64>; 2]) -> Vec<Option<f64>> {
        let si = (self.units == Units::Si).then_some(());
        let zones = || zones.into_iter().flatten();
        let cohesive = match self.sliding.adhesion.map(|adhesion| adhesion.process_zone) {
            Some(SlidingZone::Cohesive { cohesive_stress, .. }) => zones().next().map(|_| cohesive_stress),
            _ => None,
        };
        let (slope, radius) = match self.sliding.indenter {
            SlidingIndenter::Wave { .. } => (Some(self.scale.slope), None),
            SlidingIndenter::Cylinder { radius } => (None, Some(radius)),
        };
        vec![
            zones().reduce(f64::max).zip(half_width).map(|(zone, half_width)| zone / half_width),
            si.and(zones().reduce(f64::min)),
            si.and(slope),
            si.and(half_width.zip(radius).map(|(half_width, radius)| half_width / radius)),
            si.and(cohesive.map(|stress| stress / self.material.glassy_modulus())),
        ]
    }

    pub(super) fn assessments(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = assessed(&ASSUMPTIONS, rows);
        entries.extend(constant_poisson_ratio(self.poisson_ratio));
        entries.push(not_assessed(
            "inertia and heat",
            None,
            "left out: speeds must stay far below the shear-wave speed, and the edges isothermal",
        ));
        entries.push(not_assessed(
            "dry contact",
            None,
            "assumed: no fluid, no air trapped in the gap, and no shear stress at the interface itself",
        ));
        entries
    }
}
