//! Keys of the fields around a tip, or over a wavelength.

use super::{Key, Kind, Range};
use crate::scene::units::Dimension;

const DISTANCE: Kind = Kind::Number { dimension: Dimension::LENGTH, range: Range::Positive, reduced: "relaxed zone a₀" };

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "fields",
        kind: Kind::Table,
        meaning: "Opening and stress around a crack's tip; pressure, gap and surface of a sliding contact. Without it no field is evaluated.",
    },
    Key { path: "fields.from", kind: DISTANCE, meaning: "Crack: smallest distance from the tip." },
    Key { path: "fields.to", kind: DISTANCE, meaning: "Crack: largest distance from the tip." },
    Key {
        path: "fields.points",
        kind: Kind::Count { least: 2, most: 100_000 },
        meaning: "How many: distances from the tip, in equal ratios; or places along the sliding surface, dense at the edges; of a surface along each direction. Default 200, of a surface 128.",
    },
];
