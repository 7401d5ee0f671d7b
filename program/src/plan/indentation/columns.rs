//! The columns of an indentation's table, and what each is measured in.

use super::agreement;
use crate::outcome::{Column, Layout};
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
    EnergyPerArea,
    Stiffness,
    Frequency,
    Angle,
    Number,
}

/// A column.
#[derive(Clone, Copy)]
pub(super) struct Definition {
    pub(super) name: &'static str,
    pub(super) measure: Measure,
    meaning: &'static str,
}

impl Definition {
    /// As a table in these units has it.
    pub(super) fn column(&self, units: Units) -> Column {
        Column { name: self.name, unit: unit(self.measure, units).to_owned(), meaning: self.meaning }
    }
}

/// Positions of the columns of cycles and repetitions from the first of them on, in both theories of an indenter.
pub(super) mod of_cycle {
    pub(crate) const SEGMENT: usize = 0;
    pub(crate) const CYCLE: usize = 1;
    pub(crate) const CYCLE_START: usize = 2;
    pub(crate) const FREQUENCY: usize = 3;
    pub(crate) const WORK_PER_CYCLE: usize = 4;
    pub(crate) const STORAGE_STIFFNESS: usize = 5;
    pub(crate) const LOSS_STIFFNESS: usize = 6;
    pub(crate) const PHASE: usize = 7;
    pub(crate) const SMALLEST_PENETRATION: usize = 8;
    pub(crate) const LARGEST_PENETRATION: usize = 9;
    pub(crate) const SMALLEST_FORCE: usize = 10;
    pub(crate) const LARGEST_FORCE: usize = 11;
    pub(crate) const SMALLEST_CONTACT_RADIUS: usize = 12;
    pub(crate) const LARGEST_CONTACT_RADIUS: usize = 13;
    pub(crate) const DRIFT: usize = 14;
    pub(crate) const SPREAD: usize = 15;
    /// How many there are.
    pub(crate) const ALL: usize = 16;
    /// Those that only an oscillation has.
    pub(crate) const OF_AN_OSCILLATION: [usize; 6] = [FREQUENCY, STORAGE_STIFFNESS, LOSS_STIFFNESS, PHASE, DRIFT, SPREAD];
}

/// Positions among all columns: also of a scene's own rows up to [`at::BALANCE_DEFECT`], behind it by [`position`].
pub(super) mod at {
    use super::of_cycle;

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
    pub(crate) const FORCE_DEVIATION: usize = 14;
    pub(crate) const TIP_RELEASE_RATE: usize = 15;
    pub(crate) const ENERGY_RELEASE_RATE: usize = 16;
    pub(crate) const SEGMENT: usize = 17;
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
    pub(crate) const STEPS: usize = 33;
    pub(crate) const PANELS: usize = 34;
    pub(crate) const PULL_OFF_FORCE: usize = 35;
    pub(crate) const PULL_OFF_TIME: usize = 36;
    pub(crate) const PULL_OFF_PENETRATION: usize = 37;
    pub(crate) const PULL_OFF_RADIUS: usize = 38;
    pub(crate) const WORK_OF_SEPARATION: usize = 39;
    pub(crate) const DWELL_RADIUS: usize = 40;
    pub(crate) const TIME_TO_DETACH: usize = 41;
    pub(crate) const DETACHMENT_TIME: usize = 42;
    pub(crate) const DETACHMENT_PENETRATION: usize = 43;
    pub(crate) const LARGEST_RADIUS: usize = 44;
    pub(crate) const LARGEST_COMPRESSION: usize = 45;
    pub(crate) const END_PENETRATION: usize = 46;
    pub(crate) const END_FORCE: usize = 47;
    pub(crate) const END_RADIUS: usize = 48;
    pub(crate) const RMS_DEVIATION: usize = 49;
    pub(crate) const DETERMINATION: usize = 50;
    /// How many there are.
    pub(crate) const ALL: usize = 51;

    /// Of the state as a whole, in the order of its table.
    pub(crate) const OF_A_STATE: [usize; 27] = [
        PULL_OFF_FORCE,
        PULL_OFF_RATIO,
        PULL_OFF_TIME,
        PULL_OFF_PENETRATION,
        PULL_OFF_RADIUS,
        WORK_OF_SEPARATION,
        DWELL_RADIUS,
        TIME_TO_DETACH,
        DETACHMENT_TIME,
        DETACHMENT_PENETRATION,
        LARGEST_RADIUS,
        LARGEST_COMPRESSION,
        END_PENETRATION,
        END_FORCE,
        END_RADIUS,
        RMS_DEVIATION,
        DETERMINATION,
        FREQUENCY,
        STORAGE_STIFFNESS,
        LOSS_STIFFNESS,
        PHASE,
        WORK_PER_CYCLE,
        DRIFT,
        SPREAD,
        BALANCE_DEFECT,
        STEPS,
        PANELS,
    ];
}

pub(super) const fn column(name: &'static str, measure: Measure, meaning: &'static str) -> Definition {
    Definition { name, measure, meaning }
}

/// What the columns of the same name mean in both theories of an indenter.
pub(super) const DWELL_RADIUS: &str =
    "Contact radius at the end of the last hold in contact before the largest tension; empty without a hold.";
pub(super) const TIME_TO_DETACH: &str = "From the start of the last retraction, where what is imposed begins to fall (in a measured table, where it is largest), to the loss of contact.";
/// The columns of cycles and repetitions, in the order of [`of_cycle`].
pub(super) const OF_CYCLE: [Definition; of_cycle::ALL] = [
    column(
        "segment",
        Measure::Number,
        "In rows of cycles and repetitions: which segment of the history oscillates, or begins what repeats, from 0.",
    ),
    column(
        "cycle",
        Measure::Number,
        "Which cycle of the segment, or which time through what repeats, from 1. Of more than 2000 some are rows, evenly, with the first and the last.",
    ),
    column("cycle_start", Measure::Time, "When the cycle or the repetition begins; its end is the row's time."),
    column("frequency", Measure::Frequency, "One over the cycle's length."),
    column(
        "work_per_cycle",
        Measure::Energy,
        "∮F dΔ over the cycle: what the body and its adhesion dissipate in it. ∫F dΔ over a repetition; its bound is stated, not held to the accuracy.",
    ),
    column(
        "storage_stiffness",
        Measure::Stiffness,
        "Real part of force over penetration, of the fundamental, without the straight line between both ends of the cycle.",
    ),
    column("loss_stiffness", Measure::Stiffness, "Imaginary part of the same."),
    column("phase", Measure::Angle, "By which the force leads the penetration."),
    column("smallest_penetration", Measure::Length, "Over the cycle or the repetition."),
    column("largest_penetration", Measure::Length, "Over the cycle or the repetition."),
    column("smallest_force", Measure::Force, "Over the cycle or the repetition: the strongest pull, if negative."),
    column("largest_force", Measure::Force, "Over the cycle or the repetition."),
    column("smallest_contact_radius", Measure::Length, "Over the cycle or the repetition."),
    column("largest_contact_radius", Measure::Length, "Over the cycle or the repetition."),
    column(
        "drift",
        Measure::Number,
        "Change of mean, work and extremes against the cycle before, over their scales, carried on for the longest relaxation time.",
    ),
    column(
        "spread",
        Measure::Number,
        "In the last cycle of a segment of one frequency: the largest difference among all its cycles, the first tenth left out, of work, stiffnesses and extremes, over their scales.",
    ),
];

/// All columns, of which a scene has those in [`present`].
pub(super) const COLUMNS: [Definition; at::ALL] = [
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
        "Of the state, and in the row of the largest tension: that tension over (3/2)πRΔγ, JKR's pull-off under load (spheres with adhesion).",
    ),
    column(
        "power_balance_defect",
        Measure::Number,
        "Of the state, and in the last instant's row: how far F dΔ + G_tip dA is from dU + P_d dt, summed over the history, over the energy turned over.",
    ),
    column("frame_displacement", Measure::Length, "Δ + F/k_f: the far end of the frame."),
    column(
        "measured_force",
        Measure::Force,
        "The force that the table of the history holds for this time, between its rows by straight lines.",
    ),
    column("force_deviation", Measure::Force, agreement::DEVIATION),
    column(
        "tip_release_rate",
        Measure::EnergyPerArea,
        "G_tip = K_I²/2E∞*, what the edge itself releases for each area (with [indentation.energies]).",
    ),
    column(
        "energy_release_rate",
        Measure::EnergyPerArea,
        "G = dU/dA − F dΔ/dA, the same less what the memory dissipates for each area; empty where the edge rests or turns.",
    ),
    OF_CYCLE[of_cycle::SEGMENT],
    OF_CYCLE[of_cycle::CYCLE],
    OF_CYCLE[of_cycle::CYCLE_START],
    OF_CYCLE[of_cycle::FREQUENCY],
    OF_CYCLE[of_cycle::WORK_PER_CYCLE],
    OF_CYCLE[of_cycle::STORAGE_STIFFNESS],
    OF_CYCLE[of_cycle::LOSS_STIFFNESS],
    OF_CYCLE[of_cycle::PHASE],
    OF_CYCLE[of_cycle::SMALLEST_PENETRATION],
    OF_CYCLE[of_cycle::LARGEST_PENETRATION],
    OF_CYCLE[of_cycle::SMALLEST_FORCE],
    OF_CYCLE[of_cycle::LARGEST_FORCE],
    OF_CYCLE[of_cycle::SMALLEST_CONTACT_RADIUS],
    OF_CYCLE[of_cycle::LARGEST_CONTACT_RADIUS],
    OF_CYCLE[of_cycle::DRIFT],
    OF_CYCLE[of_cycle::SPREAD],
    column("steps", Measure::Number, "Of the state, and in the last instant's row: steps of the integration that its numbers are from."),
    column(
        "most_panels",
        Measure::Number,
        "Of the state, and in the last instant's row: most panels of the line at once, which a run's memory goes with.",
    ),
    column("pull_off_force", Measure::Force, "The largest tension of the history; empty if nothing pulls."),
    column("pull_off_time", Measure::Time, "When the tension is largest: known as well as two tensions near it can be distinguished."),
    column("pull_off_penetration", Measure::Length, "Δ where the tension is largest, known as well as its time."),
    column("pull_off_radius", Measure::Length, "Contact radius where the tension is largest, known as well as its time."),
    column(
        "work_of_separation",
        Measure::Energy,
        "∫F dΔ from where the force begins to pull, before the largest tension, to the loss of contact; its bound is stated, not held to the accuracy.",
    ),
    column("dwell_radius", Measure::Length, DWELL_RADIUS),
    column("time_to_detach", Measure::Time, TIME_TO_DETACH),
    column("detachment_time", Measure::Time, "When the contact is lost for the last time; empty if it is not lost."),
    column("detachment_penetration", Measure::Length, "Δ where the contact is lost for the last time."),
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
];

/// Whether a table of the history has a measured force beside what it controls.
pub(super) fn has_measured_force(indentation: &Indentation) -> bool {
    indentation.history.segments.iter().any(|segment| match segment {
        HistorySegment::Table { table, .. } => table.others.iter().any(|column| column.name == "force"),
        _ => false,
    })
}

/// Whether anything oscillates.
fn oscillates(indentation: &Indentation) -> bool {
    indentation.history.segments.iter().any(|segment| matches!(segment, HistorySegment::Oscillation(_)))
}

/// Whether anything is gone through again and again, but for oscillations.
fn repeats(indentation: &Indentation) -> bool {
    let cycles = |segment: &HistorySegment| matches!(segment, HistorySegment::Cycles { .. });
    !indentation.history.repetitions.is_empty() || indentation.history.segments.iter().any(cycles)
}

/// Whether a scene has a column of cycles and repetitions, by its place among them.
pub(super) fn has_of_cycle(indentation: &Indentation, place: usize) -> bool {
    oscillates(indentation) || repeats(indentation) && !of_cycle::OF_AN_OSCILLATION.contains(&place)
}

/// Which of all columns a scene has, in order.
pub(super) fn present(indentation: &Indentation) -> Vec<usize> {
    let has = |place: &usize| match *place {
        at::FRAME => indentation.frame_stiffness.is_some(),
        at::MEASURED_FORCE | at::FORCE_DEVIATION | at::RMS_DEVIATION | at::DETERMINATION => has_measured_force(indentation),
        at::TIP_RELEASE_RATE | at::ENERGY_RELEASE_RATE => indentation.energies,
        place if (at::SEGMENT..at::STEPS).contains(&place) => has_of_cycle(indentation, place - at::SEGMENT),
        _ => true,
    };
    (0..at::ALL).filter(has).collect()
}

/// Which columns of a scene's rows its table of states has, and which that of what lies on the way.
pub(super) fn layout(indentation: &Indentation) -> Layout {
    let present = present(indentation);
    let position = |wanted: &usize| present.iter().position(|place| place == wanted);
    let way = present.iter().enumerate().filter(|(_, place)| **place < at::PULL_OFF_FORCE).map(|(position, _)| position);
    Layout { labels: Vec::new(), states: at::OF_A_STATE.iter().filter_map(position).collect(), path: way.collect() }
}

/// Where a column of [`at`] stands in the rows of a scene.
pub(super) fn position(indentation: &Indentation, column: usize) -> Option<usize> {
    present(indentation).iter().position(|place| *place == column)
}

pub(super) fn unit(measure: Measure, units: Units) -> &'static str {
    match (measure, units) {
        (Measure::Time, Units::Si) => "s",
        (Measure::Length, Units::Si) => "m",
        (Measure::Force, Units::Si) => "N",
        (Measure::Intensity, Units::Si) => "Pa √m",
        (Measure::Energy, Units::Si) => "J",
        (Measure::Power, Units::Si) => "W",
        (Measure::EnergyPerArea, Units::Si) => "J/m²",
        (Measure::Stiffness, Units::Si) => "N/m",
        (Measure::Frequency, Units::Si) => "1/s",
        (Measure::Angle, _) => "rad",
        (Measure::Number, _) => "1",
        (Measure::Time, Units::Reduced) => "reference time",
        (Measure::Length, Units::Reduced) => "R",
        (Measure::Force, Units::Reduced) => "πE0*R²",
        (Measure::Intensity, Units::Reduced) => "E0*√R",
        (Measure::Energy, Units::Reduced) => "πE0*R³",
        (Measure::Power, Units::Reduced) => "πE0*R³/reference time",
        (Measure::EnergyPerArea | Measure::Stiffness, Units::Reduced) => "πE0*R",
        (Measure::Frequency, Units::Reduced) => "1/reference time",
    }
}

pub(super) fn columns(indentation: &Indentation, units: Units) -> Vec<Column> {
    present(indentation).into_iter().filter_map(|place| COLUMNS.get(place)).map(|definition| definition.column(units)).collect()
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
