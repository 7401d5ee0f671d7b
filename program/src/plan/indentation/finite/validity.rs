//! Where the model of an indenter that attracts at a distance reaches its limits.

use super::FiniteRangePlan;
use super::columns::at;
use crate::outcome::{Row, Validity};
use crate::plan::assumptions::{Assumption, Limit, assessed, constant_poisson_ratio, not_assessed};
use crate::plan::measured::{note, records};
use crate::scene::typed::IndentationShape;
use viscotack::finite_range::sphere::Shape;
use viscotack::indentation::TabulatedShape;

/// The assumptions, in the order of [`FiniteRangePlan::assumptions`].
const ASSUMPTIONS: [Assumption; 4] = [
    Assumption {
        name: "contact radius over R",
        limit: Limit::Below(0.3),
        meaning: "the paraboloid stands for the sphere, and the half-space for the body, only where the contact is small",
    },
    Assumption {
        name: "slope of the indenter at the contact radius",
        limit: Limit::Below(0.3),
        meaning: "linear elasticity of a half-space wants slopes well below one",
    },
    Assumption {
        name: "largest tension of the law over glassy modulus",
        limit: Limit::Below(0.3),
        meaning: "the material below the attracting surfaces must stay linear",
    },
    Assumption {
        name: "attraction from beyond the last row of the profile over (3/2)πRΔγ",
        limit: Limit::Below(1e-3),
        meaning: "beyond its last row the profile is taken to go on with the slope it has there, and attracts too; R is that of its tip",
    },
];

/// (3/2)πRΔγ in RΔγ.
const SPHERE: f64 = 1.5 * std::f64::consts::PI;

impl FiniteRangePlan {
    /// The numbers that the assumptions are compared with, for one row.
    pub(super) fn assumptions(&self, row: &Row) -> Vec<Option<f64>> {
        let radius = row.value(at::CONTACT_RADIUS).filter(|radius| *radius > 0.0);
        let (size, slope) = match self.indentation.shape {
            IndentationShape::Sphere { radius: size } => (Some(size), radius.map(|radius| radius / size)),
            IndentationShape::Cone { slope } => (None, Some(slope)),
            IndentationShape::PowerLaw { radius: size, exponent } => (None, radius.map(|radius| (radius / size).powf(exponent - 1.0))),
            IndentationShape::FlatPunch { .. } => (None, None),
            IndentationShape::Table { .. } => (None, self.table().zip(radius).map(|(table, radius)| self.slope(table, radius))),
        };
        let peak = self.reduced.law.peak_stress() / self.material.glassy_modulus();
        let beyond = self.table().filter(|_| self.reduced.rim.is_none()).zip(row.value(at::PENETRATION));
        let beyond = beyond.and_then(|(table, depth)| {
            let depth = depth / self.reduced.scales.gap + self.reduced.zero;
            let attraction = self.course.problem(&self.reduced).attraction_beyond(table.reach(), depth).ok()?;
            Some(attraction / SPHERE)
        });
        vec![radius.zip(size).map(|(radius, size)| radius / size), slope, Some(peak), beyond]
    }

    /// The shape through points, in the units of the solver.
    fn table(&self) -> Option<&TabulatedShape> {
        if let Shape::Table(table) = &self.reduced.shape { Some(table) } else { None }
    }

    /// dz/dr of a table at a coherent radius.
    fn slope(&self, table: &TabulatedShape, radius: f64) -> f64 {
        let units = self.reduced.scales;
        table.slope(radius / units.radius) * units.gap / units.radius
    }

    pub(super) fn limits(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = assessed(&ASSUMPTIONS, rows);
        entries.extend(self.attraction.notes.iter().map(|text| note("law of attraction", text)));
        entries.extend(records(&self.indentation.history, self.accuracy));
        entries.extend(constant_poisson_ratio(self.poisson_ratio));
        entries.push(not_assessed(
            "no friction, inertia or heat",
            None,
            "left out: no shear stress at the interface; a jump goes to the next equilibrium down the energy without any time",
        ));
        entries
    }
}
