//! The columns of an indentation's table, and what each is measured in.

use crate::outcome::Column;
use crate::scene::typed::{HistorySegment, Indentation, Units};

/// What a column measures.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    Time,
    Length,
    Force,
    Intensity,
    Energy,
    Power,
    Number,
}

/// A column.
#[derive(Clone, Copy)]
pub(super) struct Definition {
    pub(super) name: &'static str,
    pub(super) measure: Measure,
    meaning: &'static str,
}

/// Positions of the columns in a row.
pub(super) mod at {
    pub(crate) const TIME: usize = 0;
    pub(crate) const PENETRATION: usize = 1;
    pub(crate) const FORCE: usize = 2;
    pub(crate) const CONTACT_RADIUS: usize = 3;
    pub(crate) const STRESS_INTENSITY: usize = 4;
    pub(crate) const STORED_ENERGY: usize = 5;
    pub(crate) const EXTERNAL_WORK: usize = 6;
    pub(crate) const DISSIPATED_ENERGY: usize = 7;
    pub(crate) const DISSIPATED_POWER: usize = 8;
    pub(crate) const RESIDUAL: usize = 9;
    pub(crate) const PULL_OFF_RATIO: usize = 10;
    pub(crate) const BALANCE_DEFECT: usize = 11;
    pub(crate) const FRAME: usize = 12;
    pub(crate) const MEASURED_FORCE: usize = 13;
}

const fn column(name: &'static str, measure: Measure, meaning: &'static str) -> Definition {
    Definition { name, measure, meaning }
}

/// All columns; of the last two a scene may have none.
const COLUMNS: [Definition; 14] = [
    column("time", Measure::Time, "Time from the start of the history; imposed, or found for an event."),
    column("penetration", Measure::Length, "Δ, positive into the surface; accuracy relative to its largest magnitude in the history."),
    column("force", Measure::Force, "F on the indenter, compression positive; accuracy relative to its largest magnitude in the history."),
    column("contact_radius", Measure::Length, "a; 0 without contact."),
    column("stress_intensity", Measure::Intensity, "K_I of the edge, tension positive; accuracy relative to at least √(2E∞*Δγ)."),
    column("stored_energy", Measure::Energy, "Elastic energy of the body, of what recovers outside the contact too."),
    column("external_work", Measure::Energy, "∫F dΔ since the start."),
    column(
        "dissipated_energy",
        Measure::Energy,
        "What the memory has turned into heat since the start, and what jumps of the edge set free.",
    ),
    column("dissipated_power", Measure::Power, "What the memory turns into heat at this time."),
    column("residual", Measure::Number, "Relative defect of the edge condition at this time."),
    column(
        "pull_off_ratio",
        Measure::Number,
        "In the row of the largest tension: that tension over (3/2)πRΔγ, JKR's pull-off under load (spheres with adhesion).",
    ),
    column(
        "power_balance_defect",
        Measure::Number,
        "In the last instant's row: how far F dΔ + G_tip dA is from dU + P_d dt, summed over the history, over the energy turned over.",
    ),
    column("frame_displacement", Measure::Length, "Δ + F/k_f: the far end of the frame."),
    column(
        "measured_force",
        Measure::Force,
        "The force that the table of the history holds for this time, between its rows by straight lines.",
    ),
];

/// Whether a table of the history has a measured force beside what it controls.
pub(super) fn has_measured_force(indentation: &Indentation) -> bool {
    indentation.history.segments.iter().any(|segment| match segment {
        HistorySegment::Table { table, .. } => table.others.iter().any(|column| column.name == "force"),
        _ => false,
    })
}

/// The columns that a scene has; the places of the others stay, so that [`at`] holds.
pub(super) fn definitions(indentation: &Indentation) -> Vec<Definition> {
    let mut all = COLUMNS.to_vec();
    if !has_measured_force(indentation) {
        all.truncate(at::MEASURED_FORCE);
        if indentation.frame_stiffness.is_none() {
            all.truncate(at::FRAME);
        }
    }
    all
}

fn unit(measure: Measure, units: Units) -> &'static str {
    match (measure, units) {
        (Measure::Time, Units::Si) => "s",
        (Measure::Length, Units::Si) => "m",
        (Measure::Force, Units::Si) => "N",
        (Measure::Intensity, Units::Si) => "Pa √m",
        (Measure::Energy, Units::Si) => "J",
        (Measure::Power, Units::Si) => "W",
        (Measure::Number, _) => "1",
        (Measure::Time, Units::Reduced) => "reference time",
        (Measure::Length, Units::Reduced) => "R",
        (Measure::Force, Units::Reduced) => "πE0*R²",
        (Measure::Intensity, Units::Reduced) => "E0*√R",
        (Measure::Energy, Units::Reduced) => "πE0*R³",
        (Measure::Power, Units::Reduced) => "πE0*R³/reference time",
    }
}

pub(super) fn columns(indentation: &Indentation, units: Units) -> Vec<Column> {
    let column = |definition: Definition| Column {
        name: definition.name,
        unit: unit(definition.measure, units).to_owned(),
        meaning: definition.meaning,
    };
    definitions(indentation).into_iter().map(column).collect()
}

/// Positions of the fields at a place.
pub(super) mod field {
    pub(crate) const TIME: usize = 0;
    pub(crate) const PRESSURE: usize = 1;
    pub(crate) const DISPLACEMENT: usize = 2;
}

pub(super) fn field_columns(units: Units) -> Vec<Column> {
    let pressure = if units == Units::Si { "Pa" } else { "πE0*" };
    let columns = [
        ("radius", unit(Measure::Length, units), "Distance from the axis."),
        ("time", unit(Measure::Time, units), "The time of these fields."),
        ("pressure", pressure, "Pressure, tension negative; 0 outside the contact."),
        ("displacement", unit(Measure::Length, units), "Displacement of the surface into the body."),
    ];
    columns.into_iter().map(|(name, unit, meaning)| Column { name, unit: unit.to_owned(), meaning }).collect()
}
