//! Keys that every scene may hold.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

pub(super) const KEYS: &[Key] = &[
    Key { path: "title", kind: Kind::Text, meaning: "A line that names the scene in tables and plots." },
    Key {
        path: "units",
        kind: Kind::Choice(&[
            Word { word: "si", meaning: "numbers are SI, or texts with a unit; the default" },
            Word { word: "reduced", meaning: "plain numbers in the dimensionless groups of the problem" },
        ]),
        meaning: "The unit system of all numbers.",
    },
    Key {
        path: "accuracy",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 0.1), reduced: "1" },
        meaning: "Wanted bound on each value's error, relative to the larger of the value and its reference scale; default 1e-9 for a steady crack, 1e-3 for a crack under a history, 1e-6 for a sliding contact with edges, 1e-4 for a profile and 1e-2 for a surface with a law of attraction.",
    },
    Key {
        path: "plots",
        kind: Kind::Choices(&[
            Word { word: "svg", meaning: "vectors, drawn in milliseconds; the default" },
            Word { word: "png", meaning: "pixels, 400 dots per inch" },
        ]),
        meaning: "Which pictures `run --out` writes of each plot; `run --no-plots` draws none.",
    },
    Key {
        path: "sweep",
        kind: Kind::TableOrTables,
        meaning: "Solve for many values of one number, or of several: all combinations, the last one varying fastest.",
    },
    Key {
        path: "sweep.key",
        kind: Kind::Text,
        meaning: "The dotted path of the number to vary, for example `crack.speed` or `material.creep.0.compliance`.",
    },
    Key { path: "sweep.from", kind: Kind::NumberOfSweptKey, meaning: "The first value." },
    Key { path: "sweep.to", kind: Kind::NumberOfSweptKey, meaning: "The last value." },
    Key {
        path: "sweep.points",
        kind: Kind::Count { least: 1, most: 10_000_000 },
        meaning: "How many values from first to last; not with [latin_hypercube].",
    },
    Key {
        path: "sweep.spacing",
        kind: Kind::Choice(&[
            Word { word: "logarithmic", meaning: "equal ratios; the default" },
            Word { word: "linear", meaning: "equal differences" },
        ]),
        meaning: "How the values are spread.",
    },
    Key { path: "sweep.values", kind: Kind::NumbersOfSweptKey, meaning: "The values one by one, instead of from, to and points." },
    Key {
        path: "latin_hypercube",
        kind: Kind::Table,
        meaning: "Instead of all combinations of the sweeps, states at random between `from` and `to` of each: of as many equal parts as there are states, each sweep takes each part once.",
    },
    Key { path: "latin_hypercube.states", kind: Kind::Count { least: 2, most: 10_000_000 }, meaning: "How many states." },
    Key {
        path: "latin_hypercube.seed",
        kind: Kind::Count { least: 0, most: u32::MAX },
        meaning: "Seed of the random numbers: the same seed gives the same states. Default 0.",
    },
];
