//! The columns of a crack under a load history, and what each is measured against.

use crate::outcome::{Column, Layout};
use crate::scene::typed::Units;

/// Positions of the columns in a row.
pub(super) mod at {
    pub(crate) const TIME: usize = 0;
    pub(crate) const GROWTH: usize = 1;
    pub(crate) const SPEED: usize = 2;
    pub(crate) const STRESS_INTENSITY: usize = 3;
    pub(crate) const RATIO: usize = 4;
    pub(crate) const PROCESS_ZONE: usize = 5;
    pub(crate) const SPEED_BEFORE: usize = 6;
    pub(crate) const JUMP: usize = 7;
    pub(crate) const DELAY: usize = 8;
    pub(crate) const INITIAL_SPEED: usize = 9;
    pub(crate) const STEADY_SPEED: usize = 10;
    pub(crate) const RELAXED_RELEASE: usize = 11;
    pub(crate) const GLASSY_RELEASE: usize = 12;
    pub(crate) const STEPS: usize = 13;
    pub(crate) const PIECES: usize = 14;
}

struct Definition {
    name: &'static str,
    si_unit: &'static str,
    reduced_unit: &'static str,
    meaning: &'static str,
}

const COLUMNS: [Definition; 15] = [
    Definition {
        name: "time",
        si_unit: "s",
        reduced_unit: "τ",
        meaning: "Time since the start of the history; accuracy relative to at least its whole length.",
    },
    Definition {
        name: "growth",
        si_unit: "m",
        reduced_unit: "a₀",
        meaning: "How far the tip has run since then; accuracy relative to at least the process zone. Of the summary: at the end.",
    },
    Definition {
        name: "speed",
        si_unit: "m/s",
        reduced_unit: "a₀/τ",
        meaning: "Speed of the tip, after an event; accuracy relative to at least the greatest speed of the history.",
    },
    Definition {
        name: "stress_intensity",
        si_unit: "Pa √m",
        reduced_unit: "√(2E0Δγ)",
        meaning: "K, after a step of the load; of the summary the greatest.",
    },
    Definition {
        name: "energy_release_rate_ratio",
        si_unit: "1",
        reduced_unit: "1",
        meaning: "G/Δγ, what a rested solid would release under this K, over what the interface takes.",
    },
    Definition { name: "process_zone", si_unit: "m", reduced_unit: "a₀", meaning: "Process-zone length δ under this load." },
    Definition { name: "speed_before", si_unit: "m/s", reduced_unit: "a₀/τ", meaning: "Speed just before a kink or an arrest." },
    Definition { name: "jump", si_unit: "m", reduced_unit: "a₀", meaning: "How far the tip jumped with a step of the load." },
    Definition {
        name: "delay_time",
        si_unit: "s",
        reduced_unit: "τ",
        meaning: "Summary: when the tip moved for the first time; under one constant load from its own equation, to rounding.",
    },
    Definition { name: "initial_speed", si_unit: "m/s", reduced_unit: "a₀/τ", meaning: "Summary: speed just after that." },
    Definition {
        name: "steady_speed",
        si_unit: "m/s",
        reduced_unit: "a₀/τ",
        meaning: "Summary: speed that growth tends to under the last load, from the steady theory.",
    },
    Definition {
        name: "relaxed_release_ratio",
        si_unit: "1",
        reduced_unit: "1",
        meaning: "Summary: cK²/(2E0Δγ) at the greatest load, c the deformable halves; up to 1 nothing ever grows.",
    },
    Definition {
        name: "glassy_release_ratio",
        si_unit: "1",
        reduced_unit: "1",
        meaning: "Summary: cK²/(2E∞Δγ) at the greatest load; from 1 on growth is immediate and without bound.",
    },
    Definition { name: "steps", si_unit: "1", reduced_unit: "1", meaning: "Summary: steps of all four runs." },
    Definition { name: "most_pieces", si_unit: "1", reduced_unit: "1", meaning: "Summary: the most pieces of history held at a time." },
];

/// What a screen has room for.
pub(super) const HEADLINE: [&str; 5] = ["time", "growth", "speed", "stress_intensity", "process_zone"];
/// The same of summaries.
pub(super) const SUMMARY_HEADLINE: [&str; 5] = ["relaxed_release_ratio", "delay_time", "initial_speed", "steady_speed", "process_zone"];

pub(super) const COUNT: usize = COLUMNS.len();

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

/// Which columns belong to the summary of a history, and which to the tip on its way.
pub(super) fn layout() -> Layout {
    Layout {
        // How the history is decided, in words.
        labels: vec![1],
        states: vec![
            at::DELAY,
            at::INITIAL_SPEED,
            at::STEADY_SPEED,
            at::RELAXED_RELEASE,
            at::GLASSY_RELEASE,
            at::STRESS_INTENSITY,
            at::RATIO,
            at::PROCESS_ZONE,
            at::TIME,
            at::GROWTH,
            at::SPEED,
            at::STEPS,
            at::PIECES,
        ],
        path: (at::TIME..=at::JUMP).collect(),
    }
}

/// No field is evaluated: only the place stands.
pub(super) fn field_columns(units: Units) -> Vec<Column> {
    let unit = if units == Units::Si { "m" } else { "a₀" };
    vec![Column { name: "distance", unit: unit.to_owned(), meaning: "Distance from the tip." }]
}

/// The name of a column.
pub(super) fn name(column: usize) -> &'static str {
    COLUMNS.get(column).map_or("", |definition| definition.name)
}
