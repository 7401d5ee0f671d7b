//! Keys of periodic profiles and surfaces that slide with a law of attraction, or without adhesion.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

/// A length along the surface; in a reduced scene the period is the unit.
const PERIOD: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "not available (the period is 2π)" };
const WAVE_LENGTH: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "1/k, the period being 2π" };
const RMS_HEIGHT: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "Λ" };
const HURST: Kind = Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 1.0), reduced: "1" };
const SEED: Kind = Kind::Count { least: 0, most: u32::MAX };
const ENDS: Kind = Kind::Choice(&[
    Word { word: "mirror", meaning: "followed by its mirror image: no height is changed, the period doubles; the default" },
    Word { word: "window", meaning: "the heights fall to the mean over a tenth of the length at each end" },
    Word { word: "periodic", meaning: "it is a whole period already" },
]);
const LEVELLING: Kind = Kind::Choice(&[
    Word { word: "plane", meaning: "the least-squares line or plane is taken off; the default" },
    Word { word: "mean", meaning: "only the mean is taken off" },
]);

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "sliding.profile",
        kind: Kind::Table,
        meaning: "A periodic profile that slides, with a law of attraction or without adhesion: `harmonics`, a `file`, or `roughness`. Heights are positive towards the viscoelastic body. Reduced: lengths in 1/k of the period, heights in any Λ.",
    },
    Key {
        path: "sliding.profile.period",
        kind: PERIOD,
        meaning: "The period of the harmonics; of a roughness the default is its longest wave.",
    },
    Key { path: "sliding.profile.harmonics", kind: Kind::Tables, meaning: "The waves that make up the profile." },
    Key {
        path: "sliding.profile.harmonics[].number",
        kind: Kind::Count { least: 1, most: 100_000 },
        meaning: "How many of its wavelengths fill the period.",
    },
    Key {
        path: "sliding.profile.harmonics[].amplitude",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Finite, reduced: "Λ" },
        meaning: "Its amplitude: amplitude · cos(2π number x/period + phase).",
    },
    Key {
        path: "sliding.profile.harmonics[].phase",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Finite, reduced: "rad" },
        meaning: "Its phase in radians; default 0.",
    },
    Key {
        path: "sliding.profile.file",
        kind: Kind::Text,
        meaning: "A measured profile in a delimited file beside the scene, with columns `x` and `h`; x rises.",
    },
    Key {
        path: "sliding.profile.columns",
        kind: Kind::Table,
        meaning: "Which columns of the file are meant, where their names do not tell: the name, or the name and \"in\" and a unit.",
    },
    Key { path: "sliding.profile.columns.x", kind: Kind::Text, meaning: "The column of the place." },
    Key { path: "sliding.profile.columns.h", kind: Kind::Text, meaning: "The column of the height." },
    Key { path: "sliding.profile.levelling", kind: LEVELLING, meaning: "What is taken off a measured profile first." },
    Key { path: "sliding.profile.ends", kind: ENDS, meaning: "How a measured profile becomes periodic." },
    Key { path: "sliding.profile.roughness", kind: Kind::Table, meaning: "A self-affine profile with random phases." },
    Key { path: "sliding.profile.roughness.hurst", kind: HURST, meaning: "H; the spectrum falls as q^(−1−2H)." },
    Key { path: "sliding.profile.roughness.rms_height", kind: RMS_HEIGHT, meaning: "The root mean square height." },
    Key { path: "sliding.profile.roughness.longest", kind: WAVE_LENGTH, meaning: "The longest wave." },
    Key { path: "sliding.profile.roughness.shortest", kind: WAVE_LENGTH, meaning: "The shortest wave." },
    Key {
        path: "sliding.profile.roughness.seed",
        kind: SEED,
        meaning: "Seed of the phases: the same seed gives the same profile. Default 0.",
    },
    Key {
        path: "sliding.surface",
        kind: Kind::Table,
        meaning: "A periodic surface that slides, with a law of attraction or without adhesion: a `file` (a map), or `roughness`. Reduced as of a profile.",
    },
    Key { path: "sliding.surface.period", kind: PERIOD, meaning: "The period of a square roughness; the default is its longest wave." },
    Key {
        path: "sliding.surface.file",
        kind: Kind::Text,
        meaning: "A map beside the scene: rows of heights (CSV or NumPy's .npy, with `pixel` and `height_unit`), or columns x, y, z on a regular grid.",
    },
    Key {
        path: "sliding.surface.pixel",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "not available (the period is 2π)" },
        meaning: "The distance of two heights in a map of rows, along both directions.",
    },
    Key {
        path: "sliding.surface.height_unit",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "Λ" },
        meaning: "What a height of 1 in a map of rows is, such as \"1 nm\".",
    },
    Key {
        path: "sliding.surface.columns",
        kind: Kind::Table,
        meaning: "Which columns of a file of x, y, z are meant, where their names do not tell.",
    },
    Key { path: "sliding.surface.columns.x", kind: Kind::Text, meaning: "The column of x." },
    Key { path: "sliding.surface.columns.y", kind: Kind::Text, meaning: "The column of y." },
    Key { path: "sliding.surface.columns.z", kind: Kind::Text, meaning: "The column of the height." },
    Key {
        path: "sliding.surface.direction",
        kind: Kind::Choice(&[
            Word { word: "x", meaning: "along the rows of the map; the default" },
            Word { word: "y", meaning: "along its columns" },
        ]),
        meaning: "Along which direction of the map it slides; a negative speed slides the other way.",
    },
    Key { path: "sliding.surface.levelling", kind: LEVELLING, meaning: "What is taken off a map first." },
    Key { path: "sliding.surface.ends", kind: ENDS, meaning: "How a map becomes periodic." },
    Key {
        path: "sliding.surface.roughness",
        kind: Kind::Table,
        meaning: "A self-affine surface, the same in all directions, with random phases.",
    },
    Key { path: "sliding.surface.roughness.hurst", kind: HURST, meaning: "H; the spectrum falls as q^(−2−2H)." },
    Key { path: "sliding.surface.roughness.rms_height", kind: RMS_HEIGHT, meaning: "The root mean square height." },
    Key { path: "sliding.surface.roughness.longest", kind: WAVE_LENGTH, meaning: "The longest wave." },
    Key { path: "sliding.surface.roughness.shortest", kind: WAVE_LENGTH, meaning: "The shortest wave." },
    Key { path: "sliding.surface.roughness.seed", kind: SEED, meaning: "Seed of the phases. Default 0." },
    Key {
        path: "sliding.mean_gap",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Finite, reduced: "Λ" },
        meaning: "Instead of a mean pressure, with a law of attraction or a profile: the distance of the mean planes of both surfaces; with `frame_stiffness` that at which the frame carries nothing.",
    },
    Key {
        path: "sliding.layer",
        kind: Kind::Table,
        meaning: "A viscoelastic layer in place of the half-space, with a law of attraction or a profile.",
    },
    Key {
        path: "sliding.layer.thickness",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "1/k" },
        meaning: "Its thickness d.",
    },
    Key {
        path: "sliding.layer.backing",
        kind: Kind::Choice(&[
            Word { word: "bonded", meaning: "to a rigid base; the default" },
            Word { word: "free", meaning: "pressed from behind by a uniform pressure, free to bend" },
        ]),
        meaning: "What holds its far face.",
    },
    Key {
        path: "sliding.layer.poisson_ratio",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(-1.0, 0.5), reduced: "1" },
        meaning: "Reduced scenes: its Poisson ratio, default 0.5; in SI units that of the material.",
    },
    Key {
        path: "sliding.most_nodes",
        kind: Kind::Count { least: 256, most: 1 << 20 },
        meaning: "With a law of attraction or a profile: most nodes along the sliding direction that the accuracy may take; default 65536, of a surface 512.",
    },
    Key {
        path: "sliding.loop",
        kind: Kind::Table,
        meaning: "With a law of attraction or a profile: the mean pressure is raised from `sliding.mean_pressure` to `to` and lowered again; where the contact jumps, its row says so.",
    },
    Key {
        path: "sliding.loop.to",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::Finite, reduced: "E0*kΛ/2" },
        meaning: "The largest mean pressure of the loop.",
    },
    Key {
        path: "sliding.loop.points",
        kind: Kind::Count { least: 2, most: 10_000 },
        meaning: "States on each way, evenly spaced in the mean pressure. Default 40.",
    },
];
