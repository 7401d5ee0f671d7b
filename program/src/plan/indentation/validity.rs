//! Where the model of an indentation may fail.

use super::IndentationPlan;
use super::columns::{at, position};
use crate::outcome::{Row, Validity};
use crate::plan::assumptions::{Assumption, Limit, assessed, constant_poisson_ratio, not_assessed};
use crate::plan::measured::records;
use crate::scene::typed::{IndentationShape, IndentationZone, Units};
use viscotack::elastic::TaborNumber;
use viscotack::indentation::{Adhesion, Profile, TabulatedShape};

/// The assumptions, in the order of [`IndentationPlan::assumptions`].
const ASSUMPTIONS: [Assumption; 6] = [
    Assumption {
        name: "contact radius over R",
        limit: Limit::Below(0.3),
        meaning: "the paraboloid stands for the sphere, and the half-space for the body, only where the contact is small",
    },
    Assumption {
        name: "slope of the indenter at the edge",
        limit: Limit::Below(0.3),
        meaning: "linear elasticity of a half-space wants slopes well below one",
    },
    Assumption {
        name: "process zone over contact radius",
        limit: Limit::Below(0.2),
        meaning: "the edge must be small against the contact, whose far field is that of a sharp edge; at detachment it hardly ever is",
    },
    Assumption {
        name: "process zone (m)",
        limit: Limit::Above(1e-9),
        meaning: "a continuum needs a process zone longer than about 1 nm, the size of a molecule",
    },
    Assumption {
        name: "cohesive stress over glassy modulus",
        limit: Limit::Below(0.3),
        meaning: "the material about the process zone must stay linear",
    },
    Assumption {
        name: "Tabor number with the glassy modulus",
        limit: Limit::Above(3.0),
        meaning: "adhesion of zero range (JKR) wants a soft body and a short range: 3 or more",
    },
];

impl IndentationPlan {
    /// The shape through points, with or without a rim.
    pub(super) fn tabulated(&self) -> Option<&TabulatedShape> {
        match &self.profile {
            Profile::Table(shape) => Some(shape),
            Profile::Rimmed { face, .. } => match face.as_ref() {
                Profile::Table(shape) => Some(shape),
                _ => None,
            },
            _ => None,
        }
    }

    /// The numbers that the assumptions are assessed by, for one row.
    pub(super) fn assumptions(&self, row: &Row) -> Vec<Option<f64>> {
        // A cycle is assessed by its extremes.
        let of_cycle = |column: usize| position(&self.indentation, column).and_then(|place| row.value(place));
        let held = |radius: &f64| *radius > 0.0;
        let radius = row.value(at::CONTACT_RADIUS).or_else(|| of_cycle(at::LARGEST_CONTACT_RADIUS)).filter(held);
        let smallest = row.value(at::CONTACT_RADIUS).or_else(|| of_cycle(at::SMALLEST_CONTACT_RADIUS)).filter(held);
        let si = (self.units == Units::Si).then_some(());
        let size = match self.indentation.shape {
            IndentationShape::Sphere { radius } => Some(radius),
            IndentationShape::Cone { .. }
            | IndentationShape::FlatPunch { .. }
            | IndentationShape::PowerLaw { .. }
            | IndentationShape::Table { .. } => None,
        };
        let slope = match self.indentation.shape {
            IndentationShape::Sphere { radius: size } => radius.map(|radius| radius / size),
            IndentationShape::Cone { slope } => Some(slope),
            IndentationShape::FlatPunch { .. } => None,
            IndentationShape::PowerLaw { radius: size, exponent } => radius.map(|radius| (radius / size).powf(exponent - 1.0)),
            IndentationShape::Table { .. } => self.tabulated().zip(radius).map(|(shape, radius)| shape.slope(radius)),
        };
        let given = self.indentation.adhesion;
        let law = &self.indentation.edge_law;
        let growth = |adhesion: &Adhesion| {
            let intensity = row.value(at::STRESS_INTENSITY).filter(|_| law.growing_zone);
            intensity.map_or(1.0, |intensity| intensity * intensity / (2.0 * self.relaxed * adhesion.work_of_adhesion))
        };
        let zone = self.adhesion().map(|adhesion| adhesion.process_zone * growth(&adhesion)).filter(|zone| *zone > 0.0);
        let cohesive = match given.map(|adhesion| adhesion.process_zone) {
            Some(IndentationZone::Cohesive { cohesive_stress, .. }) => Some(cohesive_stress * self.scale.force),
            _ => None,
        };
        let tabor = match (given.and_then(|adhesion| adhesion.interaction_range), size, self.adhesion()) {
            (Some(range), Some(size), Some(adhesion)) => {
                TaborNumber::new(size, self.material.glassy_modulus(), adhesion.work_of_adhesion, range).ok().map(TaborNumber::value)
            }
            _ => None,
        };
        vec![
            radius.zip(size).map(|(radius, size)| radius / size),
            slope,
            zone.zip(smallest).map(|(zone, radius)| zone / radius),
            si.and(zone),
            cohesive.map(|stress| stress / self.material.glassy_modulus()),
            tabor,
        ]
    }

    pub(super) fn assessments(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = assessed(&ASSUMPTIONS, rows);
        if self.indentation.adhesion.is_some_and(|adhesion| adhesion.interaction_range.is_none()) {
            entries.push(not_assessed("Tabor number", None, "give adhesion.interaction_range to have it assessed"));
        }
        if self.indentation.edge_law.by_speed.as_ref().is_some_and(|law| law.ends().is_some()) {
            entries.push(not_assessed(
                "speed of the edge within the table of works",
                None,
                "an edge rests, creeps and jumps: beyond the table its ends are held",
            ));
        }
        entries.extend(self.of_the_scan());
        entries.extend(records(&self.indentation.history, self.accuracy));
        entries.extend(constant_poisson_ratio(self.poisson_ratio));
        entries.push(not_assessed(
            "no friction, inertia or heat",
            None,
            "left out: no shear stress at the interface, speeds far below the shear-wave speed, an isothermal edge",
        ));
        entries
    }
}
