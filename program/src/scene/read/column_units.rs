//! Units of columns as instruments write them.

use crate::scene::delimited::{Scale, bare_unit};
use crate::scene::units::UnitError;
use std::f64::consts::PI;

/// What one turn of a frequency is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Counted {
    Cycles,
    Radians,
}

/// Reads a unit; says whether it counts cycles or radians.
pub(super) fn unit(text: &str) -> Result<(Scale, Option<Counted>), UnitError> {
    let text = spelt(text);
    Ok(match text.as_str() {
        "" | "-" | "—" | "1" => (Scale::ONE, None),
        "°" | "deg" | "degree" | "degrees" | "Grad" => (Scale::ONE.times(PI / 180.0), Some(Counted::Radians)),
        "rpm" | "RPM" | "U/min" | "tr/min" => (Scale::of("1/min")?, Some(Counted::Cycles)),
        known => {
            let counted = if known.contains("rad") {
                Some(Counted::Radians)
            } else if known.contains("Hz") {
                Some(Counted::Cycles)
            } else {
                None
            };
            (Scale::of(known)?, counted)
        }
    })
}

/// A unit in the spelling of scenes.
fn spelt(text: &str) -> String {
    let text = bare_unit(text).replace(['º', '˚'], "°").replace("° ", "°").replace("sec", "s").replace("°K", "K");
    match text.strip_prefix("s-") {
        Some(power) => format!("s^-{power}"),
        None => text,
    }
}
