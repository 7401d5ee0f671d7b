//! The columns of an indenter that attracts at a distance.

use super::super::agreement;
use super::super::columns::{self, Definition, Measure, column, has_measured_force, has_of_cycle, of_cycle, unit};
use crate::outcome::{Column, Layout};
use crate::scene::typed::{Indentation, Units};

/// Positions among all columns.
pub(super) mod at {
    use super::of_cycle;

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
    pub(crate) const CYCLE: usize = SEGMENT + of_cycle::CYCLE;
    pub(crate) const CYCLE_START: usize = SEGMENT + of_cycle::CYCLE_START;
    pub(crate) const FREQUENCY: usize = SEGMENT + of_cycle::FREQUENCY;
    pub(crate) const WORK_PER_CYCLE: usize = SEGMENT + of_cycle::WORK_PER_CYCLE;
    pub(crate) const STORAGE_STIFFNESS: usize = SEGMENT + of_cycle::STORAGE_STIFFNESS;
    pub(crate) const LOSS_STIFFNESS: usize = SEGMENT + of_cycle::LOSS_STIFFNESS;
    pub(crate) const PHASE: usize = SEGMENT + of_cycle::PHASE;
    pub(crate) const SMALLEST_PENETRATION: usize = SEGMENT + of_cycle::SMALLEST_PENETRATION;
    pub(crate) const LARGEST_PENETRATION: usize = SEGMENT + of_cycle::LARGEST_PENETRATION;
    pub(crate) const SMALLEST_FORCE: usize = SEGMENT + of_cycle::SMALLEST_FORCE;
    pub(crate) const LARGEST_FORCE: usize = SEGMENT + of_cycle::LARGEST_FORCE;
    pub(crate) const SMALLEST_CONTACT_RADIUS: usize = SEGMENT + of_cycle::SMALLEST_CONTACT_RADIUS;
    pub(crate) const LARGEST_CONTACT_RADIUS: usize = SEGMENT + of_cycle::LARGEST_CONTACT_RADIUS;
    pub(crate) const DRIFT: usize = SEGMENT + of_cycle::DRIFT;
    pub(crate) const SPREAD: usize = SEGMENT + of_cycle::SPREAD;
    pub(crate) const PULL_OFF_FORCE: usize = 30;
    pub(crate) const PULL_OFF_TIME: usize = 31;
    pub(crate) const PULL_OFF_PENETRATION: usize = 32;
    pub(crate) const PULL_OFF_RADIUS: usize = 33;
    pub(crate) const WORK_OF_SEPARATION: usize = 34;
    pub(crate) const WORK_TO_PULL_OFF: usize = 35;
    pub(crate) const DWELL_RADIUS: usize = 36;
    pub(crate) const TIME_TO_DETACH: usize = 37;
    pub(crate) const DETACHMENT_TIME: usize = 38;
    pub(crate) const DETACHMENT_PENETRATION: usize = 39;
    pub(crate) const LARGEST_RADIUS: usize = 40;
    pub(crate) const LARGEST_COMPRESSION: usize = 41;
    pub(crate) const END_PENETRATION: usize = 42;
    pub(crate) const END_FORCE: usize = 43;
    pub(crate) const END_RADIUS: usize = 44;
    pub(crate) const RMS_DEVIATION: usize = 45;
    pub(crate) const DETERMINATION: usize = 46;
    pub(crate) const JUMPS: usize = 47;
    pub(crate) const JUMP_LOSS: usize = 48;
    pub(crate) const TABOR: usize = 49;
    pub(crate) const GLASSY_TABOR: usize = 50;
    pub(crate) const ENERGY_DEFECT: usize = 51;
    pub(crate) const STEPS: usize = 52;
    pub(crate) const NODES: usize = 53;
    /// How many there are.
    pub(crate) const ALL: usize = 54;

    /// Of the last cycle, which the state as a whole has as well.
    pub(crate) const OF_THE_LAST_CYCLE: [usize; 7] = [FREQUENCY, STORAGE_STIFFNESS, LOSS_STIFFNESS, PHASE, WORK_PER_CYCLE, DRIFT, SPREAD];
    /// Energies, which turn into each other.
    pub(crate) const ENERGIES: [usize; 5] = [STORED_ENERGY, INTERFACE_ENERGY, EXTERNAL_WORK, DISSIPATED_ENERGY, RELEASED_ENERGY];
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
    columns::OF_CYCLE[of_cycle::SEGMENT],
    columns::OF_CYCLE[of_cycle::CYCLE],
    columns::OF_CYCLE[of_cycle::CYCLE_START],
    columns::OF_CYCLE[of_cycle::FREQUENCY],
    columns::OF_CYCLE[of_cycle::WORK_PER_CYCLE],
    columns::OF_CYCLE[of_cycle::STORAGE_STIFFNESS],
    columns::OF_CYCLE[of_cycle::LOSS_STIFFNESS],
    columns::OF_CYCLE[of_cycle::PHASE],
    columns::OF_CYCLE[of_cycle::SMALLEST_PENETRATION],
    columns::OF_CYCLE[of_cycle::LARGEST_PENETRATION],
    columns::OF_CYCLE[of_cycle::SMALLEST_FORCE],
    columns::OF_CYCLE[of_cycle::LARGEST_FORCE],
    columns::OF_CYCLE[of_cycle::SMALLEST_CONTACT_RADIUS],
    columns::OF_CYCLE[of_cycle::LARGEST_CONTACT_RADIUS],
    columns::OF_CYCLE[of_cycle::DRIFT],
    columns::OF_CYCLE[of_cycle::SPREAD],
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
        place if (at::SEGMENT..at::PULL_OFF_FORCE).contains(&place) => has_of_cycle(indentation, place - at::SEGMENT),
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
        states: of(&|place| place >= at::PULL_OFF_FORCE || place == at::PULL_OFF_RATIO || at::OF_THE_LAST_CYCLE.contains(&place)),
        path: of(&|place| place < at::PULL_OFF_FORCE),
    }
}

/// Where a column of [`at`] stands in the rows of a scene.
pub(super) fn position(indentation: &Indentation, column: usize) -> Option<usize> {
    present(indentation).iter().position(|place| *place == column)
}

pub(super) fn columns(indentation: &Indentation, units: Units) -> Vec<Column> {
    present(indentation).into_iter().filter_map(|place| COLUMNS.get(place)).map(|definition| definition.column(units)).collect()
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
