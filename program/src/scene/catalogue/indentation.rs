//! Keys of an indenter pressed on, or pulled off, a body in time.

use super::{Key, Kind, Range, Word};
use crate::scene::typed::HistoryQuantity;
use crate::scene::units::Dimension;

/// A length that only scenes in SI units hold.
const SIZE: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "not available (it is the unit)" };

const fn start_value(quantity: HistoryQuantity, path: &'static str, reduced: &'static str, meaning: &'static str) -> Key {
    Key { path, kind: Kind::Number { dimension: quantity.dimension(), range: quantity.range(), reduced }, meaning }
}

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "indentation",
        kind: Kind::Table,
        meaning: "A rigid round body that is pressed on, or pulled off, the viscoelastic one in time, as [[history]] says. Reduced: lengths in R, times in the reference time, moduli in E0*, forces in πE0*R², pressures in πE0*.",
    },
    Key {
        path: "indentation.sphere",
        kind: Kind::Table,
        meaning: "A sphere, as the paraboloid r²/2R; without members in a reduced scene, where R is the unit of length.",
    },
    Key { path: "indentation.sphere.radius", kind: SIZE, meaning: "R of the sphere." },
    Key { path: "indentation.cone", kind: Kind::Table, meaning: "A cone; in a reduced scene R is any length." },
    Key {
        path: "indentation.cone.slope",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "1" },
        meaning: "Height over radius: the tangent of the angle between its side and the surface.",
    },
    Key {
        path: "indentation.flat_punch",
        kind: Kind::Table,
        meaning: "A punch with a flat face and a sharp rim; without members in a reduced scene, where its radius is the unit of length.",
    },
    Key { path: "indentation.flat_punch.radius", kind: SIZE, meaning: "Of the rim." },
    Key {
        path: "indentation.power_law",
        kind: Kind::Table,
        meaning: "A body of the shape r^m/(m R^(m−1)), which is the paraboloid of a sphere at m = 2; R is left out in a reduced scene.",
    },
    Key { path: "indentation.power_law.radius", kind: SIZE, meaning: "R of the shape: where its slope is one." },
    Key {
        path: "indentation.power_law.exponent",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.5, 20.0), reduced: "1" },
        meaning: "m of the shape.",
    },
    Key {
        path: "indentation.profile",
        kind: Kind::Text,
        meaning: "A file, relative to the scene, with the shape of the body: a header such as `r (µm), z (nm)`, then 4 to 2000 rows from `0, 0` on in which both rise; or a scan over both sides with `x` and `z`, or a map with `x`, `y` and `z`, which is levelled, centred and averaged over rings. In a reduced scene without units, R being any length. Contact and process zone must stay within the last row, unless rim_radius ends the body; with a law of attraction the shape goes on beyond it with the slope that it has there.",
    },
    Key { path: "indentation.scan", kind: Kind::Table, meaning: "What is known of the scan that `profile` names." },
    Key {
        path: "indentation.scan.apex",
        kind: Kind::Choice(&[
            Word { word: "lowest", meaning: "heights rise from the apex, as in a scan of an indenter that points down" },
            Word { word: "highest", meaning: "heights fall from the apex: the indenter points up" },
        ]),
        meaning: "Which point of the scan is the apex. Default: the lowest one if the parabola nearest to the scan opens upwards, else the highest one.",
    },
    Key {
        path: "indentation.scan.to",
        kind: SIZE,
        meaning: "The largest distance from the apex that belongs to the shape. Default: as far as all sides reach.",
    },
    Key {
        path: "indentation.scan.largest_residual",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 1.0), reduced: "1" },
        meaning: "The largest root mean square of the distance between scan and shape, over the height of the shape; beyond it the scan is refused. Default 0.05.",
    },
    Key {
        path: "indentation.scan.columns",
        kind: Kind::Table,
        meaning: "What the columns of `profile` are called, where their names do not say it: each as in the header, with its unit if it has none there, such as `x = \"Lateral in µm\"`.",
    },
    Key { path: "indentation.scan.columns.r", kind: Kind::Text, meaning: "The header of the distance from the axis." },
    Key { path: "indentation.scan.columns.x", kind: Kind::Text, meaning: "The header of the place along a line or map." },
    Key { path: "indentation.scan.columns.y", kind: Kind::Text, meaning: "The header of the place across a map." },
    Key { path: "indentation.scan.columns.z", kind: Kind::Text, meaning: "The header of the height." },
    Key {
        path: "indentation.rim_radius",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "R" },
        meaning: "Where a sphere, cone, power law or profile ends with a sharp corner, as the round end of a cylinder does: the contact grows no further, and with a process zone the rim holds its edge until it lets go; with a law of attraction nothing attracts beyond it. Left out: the shape has no end.",
    },
    Key {
        path: "indentation.counter_body",
        kind: Kind::Table,
        meaning: "The second body, if the viscoelastic one is pressed by an elastic one or if both are round. It adds (1 − ν²)/E to the creep compliance at every time; penetration is the approach of both bodies, displacements are of both surfaces together. A body with a rim is rigid.",
    },
    Key {
        path: "indentation.counter_body.modulus",
        kind: Kind::Number {
            dimension: Dimension::PRESSURE,
            range: Range::Positive,
            reduced: "not available (E0* is of both bodies together)",
        },
        meaning: "Young's modulus of the elastic body; left out with its Poisson ratio, that body is rigid.",
    },
    Key {
        path: "indentation.counter_body.poisson_ratio",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(-1.0, 0.5), reduced: "not available" },
        meaning: "Its Poisson ratio.",
    },
    Key {
        path: "indentation.counter_body.radius",
        kind: SIZE,
        meaning: "R2 of two spheres, of which indentation.sphere.radius is R1; which of both is the elastic one does not matter. The gap is that of R* = R1 R2/(R1 + R2). Left out: one of both bodies is flat.",
    },
    Key {
        path: "indentation.start",
        kind: Kind::Choice(&[
            Word {
                word: "untouched",
                meaning: "an unloaded, rested surface is touched at time zero: with adhesion the contact jumps in at once, glassily; the default",
            },
            Word {
                word: "relaxed",
                meaning: "the contact has been held at the given penetration, force or radius until the body has relaxed",
            },
        ]),
        meaning: "How the history begins.",
    },
    start_value(
        HistoryQuantity::Penetration,
        "indentation.penetration",
        "R",
        "Δ at time zero: of a relaxed start, or to which an untouched surface is pressed at once (default 0, first touch).",
    ),
    start_value(HistoryQuantity::Force, "indentation.force", "πE0*R²", "F at time zero, pressing positive, instead of the penetration."),
    start_value(HistoryQuantity::ContactRadius, "indentation.contact_radius", "R", "a at time zero, instead of the penetration."),
    Key {
        path: "indentation.frame_stiffness",
        kind: Kind::Number { dimension: Dimension::STIFFNESS, range: Range::Positive, reduced: "πE0*R (force over length)" },
        meaning: "k_f of the rig that holds the indenter: its far end moves by Δ + F/k_f, which a segment of the history may control as `frame`.",
    },
    Key {
        path: "indentation.speed_factor",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "1" },
        meaning: "How many times faster the whole history runs than it says, holds and tables included: for sweeps over speed. Default 1.",
    },
    Key {
        path: "indentation.instants",
        kind: Kind::Count { least: 1, most: 10_000 },
        meaning: "How many instants of each ramp and hold are rows of path.csv, its end included; of tables and cycles each corner is one; of an oscillation so many of its last cycle, or of all if there are 12 for each, none if fewer than 12. Default 40.",
    },
    Key {
        path: "indentation.energies",
        kind: Kind::Table,
        meaning: "Adds up stored, dissipated and external work, with the defect of the power balance. It has no members; without it no energy is counted.",
    },
    Key {
        path: "indentation.fields",
        kind: Kind::Table,
        meaning: "Pressure and surface displacement at chosen times. Without it no field is evaluated.",
    },
    Key {
        path: "indentation.fields.times",
        kind: Kind::NumbersOfSweptKey,
        meaning: "The times, from the start of the history; each becomes a row, and holds the fields of that instant.",
    },
    Key {
        path: "indentation.fields.to",
        kind: Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "R" },
        meaning: "The largest distance from the axis. Default: twice the largest contact radius at these times.",
    },
    Key {
        path: "indentation.fields.points",
        kind: Kind::Count { least: 2, most: 100_000 },
        meaning: "How many places from the axis outwards, dense at the edge of the contact. Default 200.",
    },
];
