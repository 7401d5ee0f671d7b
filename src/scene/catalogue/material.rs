//! Keys of the material: one linear viscoelastic solid, by creep terms or by relaxation terms.

use super::{Key, Kind, Range};
use crate::scene::units::Dimension;

const MODULUS: Kind = Kind::Number { dimension: Dimension::PRESSURE, range: Range::Positive, reduced: "relaxed modulus E0" };
const TIME: Kind = Kind::Number { dimension: Dimension::TIME, range: Range::Positive, reduced: "reference time" };
const FRACTION: Kind = Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 1.0), reduced: "1" };

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "material",
        kind: Kind::Table,
        meaning: "The deformable solid. Without creep or relaxation terms it is elastic: no memory is simulated.",
    },
    Key {
        path: "material.file",
        kind: Kind::Text,
        meaning: "A TOML file whose [material] table is read in place of keys given here; relative to the scene.",
    },
    Key { path: "material.name", kind: Kind::Text, meaning: "What the material is called in tables and plots." },
    Key {
        path: "material.relaxed_modulus",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::NonNegative, reduced: "1 (it is the unit)" },
        meaning: "Young's modulus E0 of a load held for ever; 0 is a viscous material.",
    },
    Key { path: "material.glassy_modulus", kind: MODULUS, meaning: "Young's modulus E∞ of an instantaneous load." },
    Key {
        path: "material.poisson_ratio",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(-1.0, 0.5), reduced: "1" },
        meaning: "Constant Poisson ratio, needed in plane strain and on a half-space.",
    },
    Key {
        path: "material.viscosity",
        kind: Kind::Number { dimension: Dimension::VISCOSITY, range: Range::Positive, reduced: "not available" },
        meaning: "Steady viscosity of a creep series that flows: adds t/η to the compliance and makes the relaxed modulus 0.",
    },
    Key { path: "material.creep", kind: Kind::Tables, meaning: "Terms J_j (1 − exp(−t/τ_j)) of the compliance." },
    Key {
        path: "material.creep[].compliance",
        kind: Kind::Number { dimension: Dimension::COMPLIANCE, range: Range::Positive, reduced: "1/E0" },
        meaning: "J_j; with exactly one of the two moduli.",
    },
    Key {
        path: "material.creep[].fraction",
        kind: FRACTION,
        meaning: "J_j as a fraction of 1/E0 − 1/E∞; with both moduli, all fractions summing to 1.",
    },
    Key { path: "material.creep[].retardation_time", kind: TIME, meaning: "τ_j, the time of a creep test." },
    Key { path: "material.relaxation", kind: Kind::Tables, meaning: "Terms E_i exp(−t/ρ_i) of the modulus." },
    Key { path: "material.relaxation[].modulus", kind: MODULUS, meaning: "E_i; with exactly one of the two moduli." },
    Key {
        path: "material.relaxation[].fraction",
        kind: FRACTION,
        meaning: "E_i as a fraction of E∞ − E0; with both moduli, all fractions summing to 1.",
    },
    Key { path: "material.relaxation[].relaxation_time", kind: TIME, meaning: "ρ_i, the time of a relaxation test." },
];
