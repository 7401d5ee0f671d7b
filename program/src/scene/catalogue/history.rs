//! Keys of a load history: a list of segments, one table each.

use super::{Key, Kind, Range, Word};
use crate::scene::typed::HistoryQuantity;
use crate::scene::units::Dimension;

const fn target(quantity: HistoryQuantity, path: &'static str, reduced: &'static str, meaning: &'static str) -> Key {
    Key { path, kind: Kind::Number { dimension: quantity.dimension(), range: quantity.range(), reduced }, meaning }
}

const fn column(path: &'static str, meaning: &'static str) -> Key {
    Key { path, kind: Kind::Text, meaning }
}

const FREQUENCY: Kind = Kind::Number { dimension: Dimension::FREQUENCY, range: Range::Positive, reduced: "cycles per reference time" };
const TIME: Kind = Kind::Number { dimension: Dimension::TIME, range: Range::Positive, reduced: "reference time" };

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "history",
        kind: Kind::Tables,
        meaning: "What is done to a crack or a sphere, one table a segment, in order, from an unloaded and rested body at time zero. A segment holds exactly one of: a quantity to go to, `by`, `hold`, `table`, `cycles`, `oscillation`, `repeat`.",
    },
    target(
        HistoryQuantity::StressIntensity,
        "history[].stress_intensity",
        "√(2E0Δγ)",
        "Go to this K of a crack: straight, in `duration` or at `rate`; without either, at once.",
    ),
    target(
        HistoryQuantity::Stress,
        "history[].stress",
        "not available",
        "Go to this stress of a cracked strip, far ahead of the tip, in the same way.",
    ),
    target(
        HistoryQuantity::Penetration,
        "history[].penetration",
        "the sphere's radius R",
        "Go to this depth of a sphere, in the same way.",
    ),
    target(HistoryQuantity::Force, "history[].force", "πE0*R²", "Go to this force on a sphere, pressing positive, in the same way."),
    target(
        HistoryQuantity::ContactRadius,
        "history[].contact_radius",
        "the sphere's radius R",
        "Go to this radius of a sphere's contact, in the same way.",
    ),
    target(
        HistoryQuantity::Frame,
        "history[].frame",
        "the sphere's radius R",
        "Go to this displacement of the far end of the frame that holds a sphere, in the same way.",
    ),
    Key {
        path: "history[].by",
        kind: Kind::NumberOfSweptKey,
        meaning: "Go so far from the present value of `quantity`, up or down, in its unit: straight, in `duration` or at `rate`; without either, at once.",
    },
    Key { path: "history[].duration", kind: TIME, meaning: "How long the way to the value takes; excludes `rate`." },
    Key {
        path: "history[].rate",
        kind: Kind::NumberOfSweptKey,
        meaning: "How fast the value is gone to, up or down: greater than 0, in the quantity's unit per time; excludes `duration`.",
    },
    Key {
        path: "history[].hold",
        kind: Kind::Number { dimension: Dimension::TIME, range: Range::NonNegative, reduced: "reference time" },
        meaning: "Hold the last controlled quantity for so long.",
    },
    Key {
        path: "history[].until",
        kind: Kind::Table,
        meaning: "What ends a segment of an indenter on its way: exactly one of its keys. The value to go to, or the length of a hold, is the limit: where the condition is not met by then, the segment ends there, and a row says so.",
    },
    target(
        HistoryQuantity::Force,
        "history[].until.force",
        "πE0*R²",
        "The segment ends when the force comes to this value, from either side.",
    ),
    target(HistoryQuantity::Penetration, "history[].until.penetration", "the sphere's radius R", "The same of the penetration."),
    target(HistoryQuantity::ContactRadius, "history[].until.contact_radius", "the sphere's radius R", "The same of the contact radius."),
    target(
        HistoryQuantity::Frame,
        "history[].until.frame",
        "the sphere's radius R",
        "The same of the displacement of the far end of the frame.",
    ),
    Key {
        path: "history[].until.event",
        kind: Kind::Choice(&[Word { word: "detachment", meaning: "the contact is lost; the segment ends right after it" }]),
        meaning: "The segment ends with this event.",
    },
    Key { path: "history[].until.time", kind: TIME, meaning: "The segment ends at this time of the history, counted from its start." },
    Key {
        path: "history[].repeat",
        kind: Kind::Count { least: 2, most: 10_000 },
        meaning: "Go through the tables before this one so many times in all, the first time included; `segments` says how many tables.",
    },
    Key {
        path: "history[].segments",
        kind: Kind::Count { least: 1, most: 1_000 },
        meaning: "How many tables before this one `repeat` takes; default 1. A group may hold other `repeat` tables.",
    },
    Key {
        path: "history[].table",
        kind: Kind::Text,
        meaning: "Follow a table of a file, relative to the scene: a header such as `time (s), force (mN)`, then rows with times that increase, counted from the first row. Straight lines between rows; the first value is stepped to. More than 2000 rows are followed along fewer corners, see `tolerance`. Text exports of force curves (`# columns: …`), decimal commas, semicolons and rows of units are read. Columns that are not controlled are measured data.",
    },
    Key {
        path: "history[].columns",
        kind: Kind::Table,
        meaning: "What the columns of `table` are called, where their names do not say it: each as in the header, with its unit if it has none there, such as `time = \"Time in s\"`.",
    },
    column("history[].columns.time", "The header of the time."),
    column("history[].columns.penetration", "The header of the penetration."),
    column("history[].columns.force", "The header of the force, controlled or measured."),
    column("history[].columns.contact_radius", "The header of the contact radius."),
    column("history[].columns.frame", "The header of the displacement of the frame's far end."),
    column("history[].columns.stress_intensity", "The header of the stress intensity."),
    column("history[].columns.stress", "The header of the stress."),
    column("history[].columns.growth", "The header of the measured growth of a crack."),
    Key {
        path: "history[].contact_point",
        kind: Kind::NumberOfSweptKey,
        meaning: "What `table` shows where the controlled quantity is zero, in the quantity's unit: it is subtracted from every row. Default 0.",
    },
    Key {
        path: "history[].invert",
        kind: Kind::Flag,
        meaning: "Whether the controlled column of `table` counts the other way, as a height that falls while the indenter goes in; `contact_point` is then what the column shows at contact. Default false.",
    },
    Key {
        path: "history[].tolerance",
        kind: Kind::NumberOfSweptKey,
        meaning: "The largest deviation from a row of `table`, in the quantity's unit, 0 or more: the record is followed along the polyline of fewest corners within it, each corner an instant; 0 follows every row. Default: a quarter of the accuracy times the range of the record if it has more than 2000 rows, else 0.",
    },
    Key {
        path: "history[].noise",
        kind: Kind::Choice(&[
            Word { word: "followed", meaning: "the noise of a record is followed as far as it exceeds the tolerance; the default" },
            Word {
                word: "left_out",
                meaning: "the tolerance is at least five times the noise, which is estimated from the median distance of a row from the straight line between its neighbours",
            },
        ]),
        meaning: "What is done with the noise of `table`.",
    },
    Key {
        path: "history[].quantity",
        kind: Kind::Choice(HistoryQuantity::WORDS),
        meaning: "What `by`, a table or cycles control; may be left out where the problem has only one such quantity.",
    },
    Key { path: "history[].cycles", kind: Kind::Count { least: 1, most: 1_000_000 }, meaning: "Go through so many cycles." },
    Key { path: "history[].period", kind: TIME, meaning: "How long one cycle takes." },
    Key { path: "history[].lower", kind: Kind::NumberOfSweptKey, meaning: "The smaller value of a cycle, in the quantity's unit." },
    Key { path: "history[].upper", kind: Kind::NumberOfSweptKey, meaning: "The larger value of a cycle, in the quantity's unit." },
    Key {
        path: "history[].wave",
        kind: Kind::Choice(&[
            Word { word: "triangle", meaning: "from the lower value straight up in half a period, then straight down; the default" },
            Word { word: "square", meaning: "half a period at the upper value, then half a period at the lower one" },
        ]),
        meaning: "The form of a cycle.",
    },
    Key {
        path: "history[].oscillation",
        kind: Kind::Table,
        meaning: "Swing as a sinus about the present value of a quantity of a sphere, up first unless `phase` says otherwise; every whole cycle gives its stiffness, loss and extremes. Holds exactly one of `cycles`, `duration`, `periodic = true`.",
    },
    Key { path: "history[].oscillation.quantity", kind: Kind::Choice(HistoryQuantity::OSCILLATING), meaning: "What oscillates." },
    Key {
        path: "history[].oscillation.amplitude",
        kind: Kind::NumberOfSweptKey,
        meaning: "Greatest deviation from the mean, greater than 0, in the quantity's unit.",
    },
    Key { path: "history[].oscillation.frequency", kind: FREQUENCY, meaning: "Cycles per time, at the start if it changes." },
    Key {
        path: "history[].oscillation.to_frequency",
        kind: FREQUENCY,
        meaning: "Cycles per time at the end: the frequency goes up or down all the while.",
    },
    Key {
        path: "history[].oscillation.frequency_sweep",
        kind: Kind::Choice(&[
            Word { word: "linear", meaning: "the frequency goes straight in time; the default" },
            Word { word: "logarithmic", meaning: "its logarithm goes straight in time" },
        ]),
        meaning: "How the frequency goes to `to_frequency`.",
    },
    Key {
        path: "history[].oscillation.cycles",
        kind: Kind::Count { least: 1, most: 1_000_000_000 },
        meaning: "How many cycles; with `until_stationary` how many at most.",
    },
    Key { path: "history[].oscillation.duration", kind: TIME, meaning: "How long it lasts, whole cycles or not." },
    Key {
        path: "history[].oscillation.phase",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Finite, reduced: "rad" },
        meaning: "Where in its cycle it begins, in radians: 0 at the mean and up, the default; 1.5708 at the top; 3.1416 at the mean and down. It begins at the present value whatever its phase, and the mean lies as far from that.",
    },
    Key {
        path: "history[].oscillation.to",
        kind: Kind::NumberOfSweptKey,
        meaning: "The mean at the end: it goes there straight, so that the oscillation rides on a ramp. Without it the mean stays.",
    },
    Key {
        path: "history[].oscillation.until_stationary",
        kind: Kind::Flag,
        meaning: "Whether it ends with the first cycle that, to the accuracy of the scene, will not drift any more in the longest relaxation time. Needs `cycles`, a steady frequency and a mean that stays.",
    },
    Key {
        path: "history[].oscillation.periodic",
        kind: Kind::Flag,
        meaning: "Whether the oscillation has gone on for ever: the row is the cycle that repeats itself, found without the cycles that lead to it. For the penetration of an adhesive contact about the one at the start (start = \"relaxed\"), as the only segment, at one frequency; in place of `cycles` and `duration`.",
    },
];
