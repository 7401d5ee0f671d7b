//! Keys of steadily sliding contacts.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

/// A length that only scenes in SI units hold.
const SIZE: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "not available (it is the unit)" };

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "sliding",
        kind: Kind::Table,
        meaning: "A rigid or elastic body that slides steadily over the viscoelastic one: a wave, or one cylinder.",
    },
    Key {
        path: "sliding.wave",
        kind: Kind::Table,
        meaning: "A sinusoidal wave Λ cos kx; without members in a reduced scene. Reduced: lengths in 1/k, displacements in Λ, pressures in E0*kΛ/2.",
    },
    Key { path: "sliding.wave.wavelength", kind: SIZE, meaning: "λ = 2π/k, from crest to crest." },
    Key { path: "sliding.wave.amplitude", kind: SIZE, meaning: "Λ, half the height from trough to crest." },
    Key {
        path: "sliding.cylinder",
        kind: Kind::Table,
        meaning: "One long cylinder across the motion; without members in a reduced scene. Reduced: lengths in any L, displacements in L²/R, pressures in E0*L/2R.",
    },
    Key { path: "sliding.cylinder.radius", kind: SIZE, meaning: "R of the cylinder, whose profile is the parabola x²/2R." },
    Key {
        path: "sliding.counter_body",
        kind: Kind::Table,
        meaning: "The body that carries the wave or the cylinder, if it is not rigid. It rides with the contact and so is at rest in its frame: only its relaxed modulus matters, and it adds (1 − ν²)/E to the creep compliance at every time.",
    },
    Key {
        path: "sliding.counter_body.modulus",
        kind: Kind::Number {
            dimension: Dimension::PRESSURE,
            range: Range::Positive,
            reduced: "not available (E0* is of both bodies together)",
        },
        meaning: "Young's modulus of the counter body; its relaxed one, if it is viscoelastic.",
    },
    Key {
        path: "sliding.counter_body.poisson_ratio",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(-1.0, 0.5), reduced: "not available" },
        meaning: "Its Poisson ratio.",
    },
    Key {
        path: "sliding.contacts",
        kind: Kind::Choices(&[
            Word {
                word: "adhesive",
                meaning: "with the energy balance of [adhesion] at both edges; the default where [adhesion] is given",
            },
            Word { word: "adhesiveless", meaning: "without adhesion: no singular stress at either edge; the default without [adhesion]" },
        ]),
        meaning: "The contacts to solve, on the same axes.",
    },
    Key {
        path: "sliding.columns",
        kind: Kind::Choices(&[
            Word {
                word: "elastic_reference_contact",
                meaning: "wave: the elastic contact of the modulus |E*(ω)| at ω = kv with the same works, process zones and load, penetration or half-width; beside a strength its pull-off, snap-in, separation and toughness (thesis Fig 3.14c)",
            },
            Word {
                word: "friction_parts",
                meaning: "friction of the edges (3.40) and of the bulk, their shares, and which one governs: a part of nine tenths or more",
            },
            Word {
                word: "sensitivities",
                meaning: "∂ln(output)/∂ln(parameter) by the process zones, the works of adhesion, E0, β (E0 and the retardation times held) and all times",
            },
        ]),
        meaning: "Columns that are made on request, of adhesive contacts.",
    },
    Key {
        path: "sliding.speed",
        kind: Kind::Number { dimension: Dimension::SPEED, range: Range::Finite, reduced: "1/k (of a cylinder L) per reference time" },
        meaning: "v of the wave along +x; a negative speed mirrors the contact, at 0 the solid is relaxed.",
    },
    Key {
        path: "sliding.mean_pressure",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::Finite, reduced: "E0*kΛ/2" },
        meaning: "Wave: p̄, the load over the nominal area; zero or negative only with adhesion.",
    },
    Key {
        path: "sliding.load_per_width",
        kind: Kind::Number { dimension: Dimension::LOAD_PER_WIDTH, range: Range::Finite, reduced: "πE0*L²/R" },
        meaning: "Cylinder: the load over its length across the motion; zero or negative only with adhesion.",
    },
    Key {
        path: "sliding.penetration",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Finite, reduced: "Λ" },
        meaning: "Wave: Δ, 0 where the crest touches the mean surface, Λ in full contact.",
    },
    Key {
        path: "sliding.half_width",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "1/k, of a cylinder L" },
        meaning: "Half the width of the contact; the load is found.",
    },
    Key {
        path: "sliding.reached_by",
        kind: Kind::Choice(&[
            Word { word: "loading", meaning: "raised from nothing at this speed: the narrowest stable contact; the default" },
            Word { word: "unloading", meaning: "lowered from the widest partial contact: the widest stable contact" },
            Word {
                word: "long_range",
                meaning: "with a law of attraction: from a long range of the law at the same load; the default there",
            },
            Word { word: "every", meaning: "with a law of attraction: a row of every state that a search finds" },
        ]),
        meaning: "How the mean pressure, load or penetration was reached: which contact is meant where several are stable. The column `other_contacts` says how many others there are.",
    },
    Key {
        path: "sliding.frame_stiffness",
        kind: Kind::Number {
            dimension: Dimension::STIFFNESS_PER_AREA,
            range: Range::Positive,
            reduced: "E0*k/2 (mean pressure over penetration)",
        },
        meaning: "Wave: the stiffness k_f, per nominal area, of a frame that holds Δ + p̄/k_f; adds the column `stable_in_frame`.",
    },
    Key {
        path: "sliding.branch",
        kind: Kind::Table,
        meaning: "A whole curve of adhesive contacts, unstable ones too, with its turns: pull-off, snap-in, separation, folds, zero load. Along a load no load is given besides; along the others the given one is held.",
    },
    Key {
        path: "sliding.branch.parameter",
        kind: Kind::Choice(&[
            Word { word: "mean_pressure", meaning: "wave: every contact at the given speed, between two mean pressures or all of them" },
            Word { word: "load_per_width", meaning: "cylinder: the same between two loads" },
            Word { word: "penetration", meaning: "wave: the same between two penetrations" },
            Word { word: "half_width", meaning: "the same between two half-widths" },
            Word {
                word: "speed",
                meaning: "speeds at the given load, penetration or half-width, from the slow and from the fast contact; leave sliding.speed out",
            },
            Word { word: "work_of_adhesion", meaning: "works of adhesion, process zones held; begins at adhesion.work_of_adhesion" },
            Word {
                word: "process_zone",
                meaning: "process zones, in a fixed ratio, by the length of the trailing one; begins at the given one",
            },
        ]),
        meaning: "What runs between `from` and `to` along the curve.",
    },
    Key {
        path: "sliding.branch.from",
        kind: Kind::NumberOfSweptKey,
        meaning: "The smallest value of the parameter, in its unit; may be left out, with `to`, along mean_pressure, penetration and half_width of a wave.",
    },
    Key { path: "sliding.branch.to", kind: Kind::NumberOfSweptKey, meaning: "The largest value of the parameter." },
    Key {
        path: "sliding.branch.points",
        kind: Kind::Count { least: 2, most: 10_000 },
        meaning: "About how many contacts of the curve are rows, evenly spaced along it, on each of the slow and the fast branch; turns come besides. Default 100.",
    },
    Key {
        path: "sliding.branch.branches",
        kind: Kind::Choice(&[
            Word {
                word: "followed",
                meaning: "the branch of the contact that a plain scene finds; along speeds those of the slow and of the fast contact, and, where a load is beyond what both bear, those that a scan of all speeds finds",
            },
            Word {
                word: "every",
                meaning: "also those that a scan of every contact finds isolated from these, closed ones (isolas) as well; not together with a range of loads or penetrations",
            },
        ]),
        meaning: "Which branches are rows: those that are reached from the ends, or every one. A scan misses a branch that fits between two of its half-widths and two values of the parameter (two per factor e). Default \"followed\".",
    },
    Key {
        path: "sliding.branch.frame_stiffness",
        kind: Kind::Number {
            dimension: Dimension::STIFFNESS_PER_AREA,
            range: Range::Positive,
            reduced: "E0*k/2 (mean pressure over penetration)",
        },
        meaning: "Wave: the stiffness k_f, per nominal area, of a frame that holds Δ + p̄/k_f; adds the column `stable_in_frame`.",
    },
    Key {
        path: "sliding.strength",
        kind: Kind::Table,
        meaning: "What an adhesive contact carries at a speed: pull-off, snap-in, separation, the contact without load, the work to separate. It has no members, and no load is given besides.",
    },
];
