//! Keys of the adhesion that holds two faces together.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

const WORK: Kind = Kind::Number {
    dimension: Dimension::ENERGY_PER_AREA,
    range: Range::Positive,
    reduced: "1 for a crack (it is the unit); for a sliding contact the group Γ = Δγ/(πE0*kΛ²), of a cylinder ΔγR²/(πE0*L³), of an indenter γ̃ = Δγ/(πE0*R)",
};

const ZONE_LENGTH: Kind = Kind::Number {
    dimension: Dimension::LENGTH,
    range: Range::Positive,
    reduced: "relaxed zone a₀ of a crack, 1/k or L of a sliding contact, R of an indenter",
};

pub(super) const KEYS: &[Key] = &[
    Key { path: "adhesion", kind: Kind::Table, meaning: "What holds the faces together. Without it no energy balance is solved." },
    Key {
        path: "adhesion.work_of_adhesion",
        kind: WORK,
        meaning: "Δγ, the energy to part a unit area of the interface; of a torn sheet, per unit area of crack (both new faces together).",
    },
    Key {
        path: "adhesion.trailing_work_of_adhesion",
        kind: WORK,
        meaning: "Sliding: Δγ of the trailing edge, where the contact opens; together with `leading_work_of_adhesion`, instead of `work_of_adhesion`. Indentation: Δγ of an edge that recedes.",
    },
    Key {
        path: "adhesion.leading_work_of_adhesion",
        kind: WORK,
        meaning: "Sliding: Δγ of the leading edge, where the contact closes; together with `trailing_work_of_adhesion`, instead of `work_of_adhesion`. Indentation: Δγ of an edge that advances, at most the other; between the two the edge rests.",
    },
    Key {
        path: "adhesion.by_speed",
        kind: Kind::Table,
        meaning: "The works of adhesion follow the speed of the edge: the law Δγ(1 + (v/v₀)ⁿ) by `speed` and `exponent`, or a table. Of sliding contacts, of indenters (the speed of the edge itself), and of cracks of given speed.",
    },
    Key {
        path: "adhesion.by_speed.speed",
        kind: Kind::Number {
            dimension: Dimension::SPEED,
            range: Range::Positive,
            reduced: "1/k (of a cylinder L, of an indenter R) per reference time",
        },
        meaning: "v₀, at which the work is twice that at rest.",
    },
    Key {
        path: "adhesion.by_speed.exponent",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "1" },
        meaning: "n of the law.",
    },
    Key {
        path: "adhesion.by_speed.table",
        kind: Kind::Tables,
        meaning: "Works at growing speeds, instead of all others: ln Δγ runs linearly in ln v from entry to entry, and speeds outside are refused; the edge of an indenter, which rests and jumps, keeps the ends there.",
    },
    Key {
        path: "adhesion.by_speed.table[].speed",
        kind: Kind::Number {
            dimension: Dimension::SPEED,
            range: Range::Positive,
            reduced: "1/k (of a cylinder L, of an indenter R) per reference time",
        },
        meaning: "v of the entry.",
    },
    Key { path: "adhesion.by_speed.table[].work_of_adhesion", kind: WORK, meaning: "Δγ of both edges at that speed." },
    Key { path: "adhesion.by_speed.table[].trailing_work_of_adhesion", kind: WORK, meaning: "Δγ of the trailing edge at that speed." },
    Key { path: "adhesion.by_speed.table[].leading_work_of_adhesion", kind: WORK, meaning: "Δγ of the leading edge at that speed." },
    Key {
        path: "adhesion.by_speed.file",
        kind: Kind::Text,
        meaning: "The same table in a CSV file beside the scene: a first line of column names, then a line an entry, cells as in a scene.",
    },
    Key {
        path: "adhesion.interaction_range",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "R" },
        meaning: "Indentation: the equilibrium distance of the interface potential, by which Tabor's number assesses the theory; it changes no result.",
    },
    Key {
        path: "adhesion.law",
        kind: Kind::Choice(&[
            Word { word: "exponential", meaning: "tension (Δγ/r) e^(−g/r) at the gap g, with a hard wall at g = 0" },
            Word { word: "dugdale", meaning: "constant tension Δγ/r up to the range r, ended by a smooth ramp, with a hard wall" },
            Word { word: "lennard_jones", meaning: "the 3-9 law between half-spaces; r is the gap of zero stress" },
            Word { word: "cosine", meaning: "tension (πΔγ/2r) sin(πg/r) up to r, with a linear repulsion of the same slope below 0" },
        ]),
        meaning: "The stress between the surfaces as a function of their gap, everywhere, in place of a process zone at an edge.",
    },
    Key {
        path: "adhesion.range",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "Λ of a sliding body, R of an indenter" },
        meaning: "r, the length over which the law of attraction acts; together with `law`.",
    },
    Key {
        path: "adhesion.peak_stress",
        kind: Kind::Number {
            dimension: Dimension::PRESSURE,
            range: Range::Positive,
            reduced: "E0*kΛ/2 of a sliding body, πE0* of an indenter",
        },
        meaning: "The largest tension of the law, instead of `range`.",
    },
    Key {
        path: "adhesion.ramp",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 0.9), reduced: "1" },
        meaning: "Half the width, over the range, of the ramp at which the tension of the law \"dugdale\" ends; default 0.1.",
    },
    Key {
        path: "adhesion.table",
        kind: Kind::Text,
        meaning: "A table of the law beside the scene, with columns `gap` and `stress`, instead of `law`, `work_of_adhesion` and `range`. It may begin with repulsion; else its first gap is a hard wall. Beyond its last gap nothing acts.",
    },
    Key {
        path: "adhesion.columns",
        kind: Kind::Table,
        meaning: "Which columns of the table are meant, where their names do not tell: the name, or the name and \"in\" and a unit.",
    },
    Key { path: "adhesion.columns.gap", kind: Kind::Text, meaning: "The column of the gap." },
    Key {
        path: "adhesion.columns.stress",
        kind: Kind::Text,
        meaning: "The column of the stress; the sign of a tension is read off its last rows.",
    },
    Key {
        path: "adhesion.process_zone",
        kind: Kind::Table,
        meaning: "The length over which the edge moves when the balance is struck: a length, or from a cohesive stress.",
    },
    Key { path: "adhesion.process_zone.length", kind: ZONE_LENGTH, meaning: "A fixed process-zone length δ." },
    Key {
        path: "adhesion.process_zone.trailing_length",
        kind: ZONE_LENGTH,
        meaning: "Sliding: δ of the trailing edge, where the contact opens; together with `leading_length`, instead of `length`.",
    },
    Key {
        path: "adhesion.process_zone.leading_length",
        kind: ZONE_LENGTH,
        meaning: "Sliding: δ of the leading edge, where the contact closes; together with `trailing_length`, instead of `length`.",
    },
    Key {
        path: "adhesion.process_zone.cohesive_stress",
        kind: Kind::Number {
            dimension: Dimension::PRESSURE,
            range: Range::Positive,
            reduced: "not available for a crack (a₀ is the unit of length); E0*kΛ/2 of a sliding wave, E0*L/2R of a cylinder, πE0* of an indenter",
        },
        meaning: "σ_c, from which δ follows by `law`; the cohesive-zone theory of a crack takes it as its constant stress.",
    },
    Key {
        path: "adhesion.process_zone.factor",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "1" },
        meaning: "α in δ = α(K/(√(2π)σ_c))²; default 1/π, with which the theory meets Persson and Brener's in both limits.",
    },
    Key {
        path: "adhesion.process_zone.law",
        kind: Kind::Choice(&[
            Word {
                word: "growing",
                meaning: "δ = α(K/(√(2π)σ_c))² at the current load (5.25, 5.41); the default of a crack, and a choice of a flat punch, or of another indenter that is only withdrawn from a relaxed start",
            },
            Word {
                word: "constant",
                meaning: "δ = αa₀, its value at G = Δγ (5.42), a₀ = E0*Δγ/(πσ_c²); what sliding contacts and indenters have by default",
            },
            Word {
                word: "dugdale",
                meaning: "sliding contacts, with peak_stress: a constant tension; δ = αa₀G/Δγ where the contact opens, αa₀Δγ/G where it closes, α = π²/6",
            },
            Word { word: "exponential", meaning: "the same of a tension that falls exponentially with the gap, α = 6.497" },
            Word { word: "schapery", meaning: "closing cracks only: the length of Schapery's cohesive zone (5.43)" },
        ]),
        meaning: "How the length follows from the cohesive stress.",
    },
    Key {
        path: "adhesion.process_zone.peak_stress",
        kind: Kind::Number {
            dimension: Dimension::PRESSURE,
            range: Range::Positive,
            reduced: "E0*kΛ/2 of a sliding wave, E0*L/2R of a cylinder",
        },
        meaning: "Sliding: the largest tension of the law \"dugdale\" or \"exponential\", whose zone grows with its edge.",
    },
];
