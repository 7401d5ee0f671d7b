//! Keys of cracks: steady ones, and those under a load history.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

const LENGTH: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "relaxed zone a₀" };

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "crack",
        kind: Kind::Table,
        meaning: "A crack that opens or closes steadily; with a [[history]], a crack that opens under it, rests, and never heals.",
    },
    Key {
        path: "crack.motion",
        kind: Kind::Choice(&[
            Word { word: "opening", meaning: "the crack runs into the solid; the default" },
            Word { word: "closing", meaning: "the solid heals over the crack" },
        ]),
        meaning: "Which way the tip moves.",
    },
    Key {
        path: "crack.body",
        kind: Kind::Choice(&[
            Word { word: "against_rigid", meaning: "one deformable half on a rigid one: G = K²/(2E*)" },
            Word { word: "two_halves", meaning: "a crack inside one material: G = K²/E*" },
        ]),
        meaning: "Which faces deform: a factor two in the energy, so it has no default.",
    },
    Key {
        path: "crack.plane",
        kind: Kind::Choice(&[
            Word { word: "stress", meaning: "a thin sheet: E* = E" },
            Word { word: "strain", meaning: "a thick body: E* = E/(1 − ν²)" },
        ]),
        meaning: "State of deformation out of the plane; no default.",
    },
    Key {
        path: "crack.theories",
        kind: Kind::Choices(&[
            Word { word: "virtual_work", meaning: "the theory of this program (5.19–5.43); the default" },
            Word { word: "persson_brener", meaning: "bulk loss outside a cut-off length" },
            Word { word: "cohesive_zone", meaning: "Dugdale, Schapery and Greenwood: constant cohesive stress" },
        ]),
        meaning: "The theories to solve, on the same axes.",
    },
    Key {
        path: "crack.speed",
        kind: Kind::Number { dimension: Dimension::SPEED, range: Range::NonNegative, reduced: "a₀ per reference time" },
        meaning: "v of the tip; the load is found.",
    },
    Key {
        path: "crack.energy_release_rate",
        kind: Kind::Number { dimension: Dimension::ENERGY_PER_AREA, range: Range::Positive, reduced: "Δγ" },
        meaning: "G far from the tip; the speed is found.",
    },
    Key {
        path: "crack.stress_intensity",
        kind: Kind::Number { dimension: Dimension::STRESS_INTENSITY, range: Range::Positive, reduced: "√(2E0Δγ)" },
        meaning: "K (closing: the remote K₁); the speed is found.",
    },
    Key {
        path: "crack.strip",
        kind: Kind::Table,
        meaning: "Load through a long strip, clamped at both long edges, with the crack along its middle; the speed is found.",
    },
    Key { path: "crack.strip.half_height", kind: LENGTH, meaning: "h, half the height of the unloaded strip." },
    Key {
        path: "crack.strip.strain",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "not available" },
        meaning: "Strain of the strip far ahead of the tip, held so long that the material is relaxed.",
    },
    Key {
        path: "crack.strip.stress",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::Positive, reduced: "not available" },
        meaning: "Stress of the strip far ahead of the tip, instead of the strain.",
    },
    Key {
        path: "crack.strip.lateral",
        kind: Kind::Choice(&[
            Word { word: "clamped", meaning: "no contraction along the strip (pure shear): the default" },
            Word { word: "uniaxial", meaning: "free contraction along the strip, as in (5.46)" },
        ]),
        meaning: "Whether the strip may contract along its length.",
    },
    Key {
        path: "crack.points",
        kind: Kind::Count { least: 0, most: 1_000_000 },
        meaning: "Under a [[history]]: at how many times the tip is looked at; events are reported besides, all in path.csv. 0 for summary and events alone. Default 200.",
    },
    Key {
        path: "crack.spacing",
        kind: Kind::Choice(&[
            Word { word: "linear", meaning: "equal differences from time zero; the default" },
            Word { word: "logarithmic", meaning: "equal ratios from `first_time`" },
        ]),
        meaning: "Under a [[history]]: how these times are spread up to the end of the last segment.",
    },
    Key {
        path: "crack.first_time",
        kind: Kind::Number { dimension: Dimension::TIME, range: Range::Positive, reduced: "reference time" },
        meaning: "Under a [[history]]: the first of logarithmic times; default 1e-6 of the whole history.",
    },
];
