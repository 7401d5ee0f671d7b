//! The columns of an indenter that attracts at a distance.

use super::super::agreement;
use super::super::columns::{self, Measure, has_measured_force, repeats, unit};
use crate::outcome::{Column, Layout};
use crate::scene::typed::{Indentation, Units};

/// A column.
#[derive(Clone, Copy)]
pub(super) struct Definition {
    pub(super) name: &'static str,
    pub(super) measure: Measure,
    meaning: &'static str,
}

/// Positions among all columns.
pub(super) mod at {
    pub(crate) const TIME: usize = 0;
    pub(crate) const PENETRATION: usize = 1;
    pub(crate) const FORCE: usize = 2;
    pub(crate) const CONTACT_RADIUS: usize = 3;
    pub(crate) const PULL_OFF_RATIO: usize = 4;
    pub(crate) const STORED_ENERGY: usize = 5;
    pub(crate) const INTERFACE_ENERGY: usize = 6;
    pub(crate) const EXTERNAL_WORK: usize = 7;
    pub(crate) const DISSIPATED_ENERGY: usize = 8;
    pub(crate) const RELEASED_ENERGY: usize = 9;
    pub(crate) const RESIDUAL: usize = 10;
    pub(crate) const FRAME: usize = 11;
    pub(crate) const MEASURED_FORCE: usize = 12;
    pub(crate) const FORCE_DEVIATION: usize = 13;
    pub(crate) const SEGMENT: usize = 14;
    pub(crate) const CYCLE: usize = 15;
    pub(crate) const CYCLE_START: usize = 16;
    pub(crate) const WORK_PER_CYCLE: usize = 17;
    pub(crate) const SMALLEST_PENETRATION: usize = 18;
    pub(crate) const LARGEST_PENETRATION: usize = 19;
    pub(crate) const SMALLEST_FORCE: usize = 20;
    pub(crate) const LARGEST_FORCE: usize = 21;
    pub(crate) const SMALLEST_CONTACT_RADIUS: usize = 22;
    pub(crate) const LARGEST_CONTACT_RADIUS: usize = 23;
    pub(crate) const PULL_OFF_FORCE: usize = 24;
    pub(crate) const PULL_OFF_TIME: usize = 25;
    pub(crate) const PULL_OFF_PENETRATION: usize = 26;
    pub(crate) const PULL_OFF_RADIUS: usize = 27;
    pub(crate) const WORK_OF_SEPARATION: usize = 28;
    pub(crate) const WORK_TO_PULL_OFF: usize = 29;
    pub(crate) const DWELL_RADIUS: usize = 30;
    pub(crate) const TIME_TO_DETACH: usize = 31;
    pub(crate) const DETACHMENT_TIME: usize = 32;
    pub(crate) const DETACHMENT_PENETRATION: usize = 33;
    pub(crate) const LARGEST_RADIUS: usize = 34;
    pub(crate) const LARGEST_COMPRESSION: usize = 35;
    pub(crate) const END_PENETRATION: usize = 36;
    pub(crate) const END_FORCE: usize = 37;
    pub(crate) const END_RADIUS: usize = 38;
    pub(crate) const RMS_DEVIATION: usize = 39;
    pub(crate) const DETERMINATION: usize = 40;
    pub(crate) const JUMPS: usize = 41;
    pub(crate) const JUMP_LOSS: usize = 42;
    pub(crate) const TABOR: usize = 43;
    pub(crate) const GLASSY_TABOR: usize = 44;
    pub(crate) const ENERGY_DEFECT: usize = 45;
    pub(crate) const STEPS: usize = 46;
    pub(crate) const NODES: usize = 47;
    /// How many there are.
    pub(crate) const ALL: usize = 48;

    /// Energies, which turn into each other.
    pub(crate) const ENERGIES: [usize; 5] = [STORED_ENERGY, INTERFACE_ENERGY, EXTERNAL_WORK, DISSIPATED_ENERGY, RELEASED_ENERGY];
}

const fn column(name: &'static str, measure: Measure, meaning: &'static str) -> Definition {
    Definition { name, measure, meaning }
}

/// All columns, of which a scene has those in [`present`].
pub(super) const COLUMNS: [Definition; at::ALL] = [
    column("time", Measure::Time, "Time from the start of the history; imposed, or found for an event."),
    column(
        "penetration",
        Measure::Length,
        "Δ, positive into the surface; 0 where the apex of the undeformed body is at the law's gap of zero stress from the undeformed surface.",
    ),
    column("force", Measure::Force, "F on the indenter, compression positive; accuracy relative to its largest magnitude in the history."),
    column("contact_radius", Measure::Length, "Radius at which the gap is that of the law's largest tension; 0 if it is wider everywhere."),
    column(
        "pull_off_ratio",
        Measure::Number,
        "Of the state, and in the row of the largest tension: that tension over (3/2)πRΔγ, JKR's pull-off under load (spheres).",
    ),
    column("stored_energy", Measure::Energy, "Elastic energy of the body: of its instant response and of what recovers."),
    column(
        "interface_energy",
        Measure::Energy,
        "Of the attraction, the integral of the law over the gap; 0 for surfaces far from each other.",
    ),
    column("external_work", Measure::Energy, "∫F dΔ since the start."),
    column("dissipated_energy", Measure::Energy, "What the memory has turned into heat since the start."),
    column("released_energy", Measure::Energy, "What jumps of the surface have set free since the start."),
    column("residual", Measure::Number, "Defect of the energy balance since the start, over the largest energy of the history."),
    column("frame_displacement", Measure::Length, "Δ + F/k_f: the far end of the frame."),
    column(
        "measured_force",
        Measure::Force,
        "The force that the table of the history holds for this time, between its rows by straight lines.",
    ),
    column("force_deviation", Measure::Force, agreement::DEVIATION),
    column("segment", Measure::Number, columns::SEGMENT),
    column("cycle", Measure::Number, columns::CYCLE),
    column("cycle_start", Measure::Time, columns::CYCLE_START),
    column("work_per_cycle", Measure::Energy, columns::WORK_PER_CYCLE),
    column("smallest_penetration", Measure::Length, "Over the repetition."),
    column("largest_penetration", Measure::Length, "Over the repetition."),
    column("smallest_force", Measure::Force, "Over the repetition: the strongest pull, if negative."),
    column("largest_force", Measure::Force, "Over the repetition."),
    column("smallest_contact_radius", Measure::Length, "Over the repetition."),
    column("largest_contact_radius", Measure::Length, "Over the repetition."),
    column("pull_off_force", Measure::Force, "The largest tension of the history; empty if nothing pulls."),
    column("pull_off_time", Measure::Time, "When the tension is largest; soft where the maximum is flat."),
    column("pull_off_penetration", Measure::Length, "Δ where the tension is largest; soft where the maximum is flat."),
    column("pull_off_radius", Measure::Length, "Contact radius where the tension is largest; soft where the maximum is flat."),
    column(
        "work_of_separation",
        Measure::Energy,
        "∫F dΔ of whoever pulls, from where the force begins to pull before the largest tension to the end of that segment of the history (or its start, if it begins in tension); its bound is stated, not held to the accuracy.",
    ),
    column("work_to_pull_off", Measure::Energy, "The same to the largest tension only."),
    column("dwell_radius", Measure::Length, columns::DWELL_RADIUS),
    column("time_to_detach", Measure::Time, columns::TIME_TO_DETACH),
    column(
        "detachment_time",
        Measure::Time,
        "When the contact ends for the last time: the gap becomes wider everywhere than that of the largest tension, smoothly or by a jump; under an imposed force, when no equilibrium is left.",
    ),
    column("detachment_penetration", Measure::Length, "Δ where the contact ends for the last time."),
    column("largest_radius", Measure::Length, "Largest contact radius of the history; its bound is stated, not held to the accuracy."),
    column(
        "largest_compression",
        Measure::Force,
        "Largest force of the history, where it presses; its bound is stated, not held to the accuracy.",
    ),
    column("end_penetration", Measure::Length, "Δ at the end of the history."),
    column("end_force", Measure::Force, "F at the end of the history."),
    column("end_radius", Measure::Length, "Contact radius at the end of the history."),
    column("rms_deviation", Measure::Force, agreement::RMS),
    column("coefficient_of_determination", Measure::Number, agreement::DETERMINATION),
    column("jumps", Measure::Number, "Sudden changes of the surface to another equilibrium; each is an event."),
    column("jump_loss", Measure::Energy, "What all of them set free."),
    column("tabor_number", Measure::Number, "(RΔγ²/(E0*²r³))^{1/3} with the relaxed modulus, r the range of the law."),
    column("glassy_tabor_number", Measure::Number, "The same with the glassy modulus."),
    column("energy_defect", Measure::Number, "Largest defect of the energy balance of the history, over its largest energy."),
    column("steps", Measure::Number, "Steps in time of the computation that the numbers are from."),
    column("nodes", Measure::Number, "Most nodes of its mesh at once."),
];

/// Which of all columns a scene has, in order.
pub(super) fn present(indentation: &Indentation) -> Vec<usize> {
    let has = |place: &usize| match *place {
        at::FRAME => indentation.frame_stiffness.is_some(),
        at::MEASURED_FORCE | at::FORCE_DEVIATION | at::RMS_DEVIATION | at::DETERMINATION => has_measured_force(indentation),
        place if (at::SEGMENT..at::PULL_OFF_FORCE).contains(&place) => repeats(indentation),
        place => indentation.energies || !at::ENERGIES.contains(&place),
    };
    (0..at::ALL).filter(has).collect()
}

/// Which columns of a scene's rows its table of states has, and which that of what lies on the way.
pub(super) fn layout(indentation: &Indentation) -> Layout {
    let present = present(indentation);
    let of = |wanted: &dyn Fn(usize) -> bool| {
        present.iter().enumerate().filter(|(_, place)| wanted(**place)).map(|(position, _)| position).collect()
    };
    Layout {
        labels: Vec::new(),
        states: of(&|place| place >= at::PULL_OFF_FORCE || matches!(place, at::PULL_OFF_RATIO | at::WORK_PER_CYCLE)),
        path: of(&|place| place < at::PULL_OFF_FORCE),
    }
}

/// Where a column of [`at`] stands in the rows of a scene.
pub(super) fn position(indentation: &Indentation, column: usize) -> Option<usize> {
    present(indentation).iter().position(|place| *place == column)
}

pub(super) fn columns(indentation: &Indentation, units: Units) -> Vec<Column> {
    let column = |definition: Definition| Column {
        name: definition.name,
        unit: unit(definition.measure, units).to_owned(),
        meaning: definition.meaning,
    };
    present(indentation).into_iter().filter_map(|place| COLUMNS.get(place)).copied().map(column).collect()
}

/// Positions of the fields at a place.
pub(super) mod field {
    pub(crate) const TIME: usize = 0;
    pub(crate) const PRESSURE: usize = 1;
    pub(crate) const DISPLACEMENT: usize = 2;
    pub(crate) const GAP: usize = 3;
}

pub(super) fn field_columns(units: Units) -> Vec<Column> {
    let pressure = if units == Units::Si { "Pa" } else { "πE0*" };
    let length = unit(Measure::Length, units);
    let columns = [
        ("radius", length, "Distance from the axis."),
        ("time", unit(Measure::Time, units), "The time of these fields."),
        ("pressure", pressure, "Pressure between the surfaces, tension negative."),
        ("displacement", length, "Displacement of the surface into the body."),
        ("gap", length, "Distance between both surfaces."),
    ];
    columns.into_iter().map(|(name, unit, meaning)| Column { name, unit: unit.to_owned(), meaning }).collect()
}
