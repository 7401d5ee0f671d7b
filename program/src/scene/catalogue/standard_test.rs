//! Keys of a standard test of an indenter, which stands for a history.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

const fn number(path: &'static str, dimension: Dimension, range: Range, reduced: &'static str, meaning: &'static str) -> Key {
    Key { path, kind: Kind::Number { dimension, range, reduced }, meaning }
}

const fn time(path: &'static str, range: Range, meaning: &'static str) -> Key {
    number(path, Dimension::TIME, range, "reference time", meaning)
}

const fn length(path: &'static str, range: Range, meaning: &'static str) -> Key {
    number(path, Dimension::LENGTH, range, "the sphere's radius R", meaning)
}

const fn speed(path: &'static str, meaning: &'static str) -> Key {
    number(path, Dimension::SPEED, Range::Positive, "R over the reference time", meaning)
}

const fn frequency(path: &'static str, meaning: &'static str) -> Key {
    number(path, Dimension::FREQUENCY, Range::Positive, "cycles per reference time", meaning)
}

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "test",
        kind: Kind::Table,
        meaning: "A standard test of an indenter, in place of [[history]]: it is written out as segments, which `viscotack explain` prints. It moves the far end of the frame if there is one, else the penetration.",
    },
    Key {
        path: "test.kind",
        kind: Kind::Choice(&[
            Word { word: "pull_off", meaning: "approach, dwell at the place that was reached, retract until the contact is lost" },
            Word { word: "tack", meaning: "approach to `preload`, hold that force, retract until the contact is lost" },
            Word { word: "creep", meaning: "press to `preload` and hold the force; then unload and wait, if `recovery` is given" },
            Word { word: "relaxation", meaning: "approach and hold the place that was reached" },
            Word { word: "dynamic", meaning: "approach, dwell, and oscillate at one frequency after the other" },
            Word { word: "cyclic", meaning: "approach, dwell and retract, so many times" },
        ]),
        meaning: "Which test.",
    },
    speed("test.approach_speed", "How fast it approaches."),
    number("test.preload", Dimension::FORCE, Range::Finite, "πE0*R²", "The force at which the approach ends, or which a creep test holds."),
    length("test.depth", Range::Positive, "How far the approach goes, in place of `preload`."),
    length(
        "test.approach_to",
        Range::Positive,
        "Where the approach ends at the latest, if `preload` is not reached before. Default: the radius of the indenter, and what `preload` bends the frame by.",
    ),
    time("test.rise", Range::Positive, "How long a creep test takes to put the load on, and to take it off. Default: at once."),
    time("test.dwell", Range::NonNegative, "How long it is held after the approach. Default 0; a creep or relaxation test needs it."),
    time("test.recovery", Range::Positive, "How long a creep test waits without load at its end."),
    speed("test.retraction_speed", "How fast it retracts. Default: the speed of the approach."),
    length(
        "test.retract_to",
        Range::Finite,
        "Where the retraction ends, at the latest if the contact is lost before. Default: of a pull-off or tack test the radius of the indenter above first touch; of cycles first touch, 0.",
    ),
    length("test.amplitude", Range::Positive, "Greatest deviation of the oscillations of a dynamic test from their mean."),
    frequency("test.frequency", "Cycles per time of a dynamic test; the first one if there are several."),
    frequency("test.to_frequency", "The last frequency; those between are in equal ratios."),
    Key {
        path: "test.frequencies",
        kind: Kind::Count { least: 2, most: 200 },
        meaning: "How many frequencies from `frequency` to `to_frequency`. Default 5.",
    },
    Key {
        path: "test.cycles",
        kind: Kind::Count { least: 1, most: 5_000 },
        meaning: "Cycles of a cyclic test; cycles at each frequency of a dynamic one, at most so many until they are stationary, with a law of attraction exactly so many. Default of a dynamic test 20.",
    },
];
