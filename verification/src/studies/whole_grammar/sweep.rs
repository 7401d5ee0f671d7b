//! Draws of sweeps.

use super::text::{Text, Units, quoted};

/// A sweep of two values about one.
pub(super) fn write(text: &mut Text, key: &str, (value, units): (f64, Units), positive: bool) {
    text.put("sweep.key", quoted(key));
    let (from, to) = (value, 1.5 * value.abs() + if positive { 0.0 } else { 0.1 });
    if text.chance(0.4) {
        let values = [text.number(from, 1.0, units), text.number(to, 1.0, units)].join(", ");
        text.put("sweep.values", format!("[{values}]"));
        return;
    }
    text.put_number("sweep.from", from, 1.0, units);
    text.put_number("sweep.to", to, 1.0, units);
    if text.chance(0.2) {
        text.put("latin_hypercube.states", "2");
        text.put("latin_hypercube.seed", "7");
    } else {
        text.put("sweep.points", "2");
    }
    let spacing = if positive { text.word(&["logarithmic", "linear"]) } else { "linear" };
    text.put("sweep.spacing", quoted(spacing));
}
