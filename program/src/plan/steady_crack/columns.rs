//! The columns of a steady crack's table, and how each is measured against the wanted accuracy.

use crate::outcome::{Column, FieldPoint};
use crate::scene::typed::Units;

/// A column with its units and its reference scale.
pub(super) struct Definition {
    pub(super) name: &'static str,
    si_unit: &'static str,
    reduced_unit: &'static str,
    meaning: &'static str,
}

/// Positions of the columns in a row, and of the fields at a point.
pub(super) mod at {
    pub(crate) const SPEED: usize = 0;
    pub(crate) const ENERGY_RELEASE_RATE: usize = 1;
    pub(crate) const RATIO: usize = 2;
    pub(crate) const STRESS_INTENSITY: usize = 3;
    pub(crate) const PROCESS_ZONE: usize = 6;
    pub(crate) const GLASSY_RADIUS: usize = 9;
    pub(crate) const DISPLACEMENT: usize = 0;
    pub(crate) const STRESS: usize = 1;
}

pub(super) const COLUMNS: [Definition; 11] = [
    Definition { name: "speed", si_unit: "m/s", reduced_unit: "a₀/τ", meaning: "Speed v of the tip." },
    Definition {
        name: "energy_release_rate",
        si_unit: "J/m²",
        reduced_unit: "Δγ",
        meaning: "G far from the tip, per unit area of crack; accuracy relative to at least Δγ.",
    },
    Definition { name: "energy_release_rate_ratio", si_unit: "1", reduced_unit: "1", meaning: "G/Δγ; accuracy relative to at least 1." },
    Definition {
        name: "stress_intensity",
        si_unit: "Pa √m",
        reduced_unit: "√(2E0Δγ)",
        meaning: "K; of a closing crack the remote K₁. Accuracy relative to at least its value at G = Δγ.",
    },
    Definition {
        name: "tip_stress_intensity",
        si_unit: "Pa √m",
        reduced_unit: "√(2E0Δγ)",
        meaning: "Stress intensity at the very tip: K opening, (E∞/E0)K₁ closing.",
    },
    Definition {
        name: "displacement_intensity",
        si_unit: "√m",
        reduced_unit: "√(2Δγ/E0)",
        meaning: "Closing: K₁/E0*, so that one face opens by this times √(8s/π).",
    },
    Definition {
        name: "process_zone",
        si_unit: "m",
        reduced_unit: "a₀",
        meaning: "Process-zone length δ; in Persson and Brener's theory the cut-off length a.",
    },
    Definition {
        name: "crossing_time",
        si_unit: "s",
        reduced_unit: "τ",
        meaning: "Time in which the tip crosses the process zone (Persson and Brener: a/(2πv)).",
    },
    Definition { name: "speed_exponent", si_unit: "1", reduced_unit: "1", meaning: "d ln G/d ln v at this speed." },
    Definition {
        name: "glassy_tip_radius",
        si_unit: "m",
        reduced_unit: "Δγ/E0",
        meaning: "Radius of the tip of one face seen from very near (opening), or the one radius of a closing tip.",
    },
    Definition {
        name: "relaxed_tip_radius",
        si_unit: "m",
        reduced_unit: "Δγ/E0",
        meaning: "Radius of the tip of one face seen from far away (opening).",
    },
];

pub(super) fn columns(units: Units) -> Vec<Column> {
    COLUMNS
        .iter()
        .map(|definition| Column {
            name: definition.name,
            unit: (if units == Units::Si { definition.si_unit } else { definition.reduced_unit }).to_owned(),
            meaning: definition.meaning,
        })
        .collect()
}

/// The place, then the fields in the order of [`at::DISPLACEMENT`] and [`at::STRESS`].
pub(super) fn field_columns(units: Units) -> Vec<Column> {
    let units = match units {
        Units::Si => ["m", "m", "Pa"],
        // With E0 = Δγ = a₀ = 1 there are two lengths, a₀ and Δγ/E0: an opening K/E0·√s is measured by the root of both.
        Units::Reduced => ["a₀", "√(a₀Δγ/E0)", "√(E0Δγ/a₀)"],
    };
    let columns = [
        ("distance", "Distance from the tip, behind it for the displacement, ahead of it for the stress."),
        ("displacement", "Displacement of one face."),
        ("stress", "Stress of the bonded side, tension positive."),
    ];
    columns.into_iter().zip(units).map(|((name, meaning), unit)| Column { name, unit: unit.to_owned(), meaning }).collect()
}

/// A field at a point.
pub(super) fn field(point: &FieldPoint, place: usize) -> f64 {
    point.values.get(place).map_or(f64::NAN, |estimate| estimate.value)
}
