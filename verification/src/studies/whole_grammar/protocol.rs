//! Draws of protocols: standard tests, segments that a condition ends, values relative to the present one, groups that repeat.

use super::text::{Accuracies, FORCE, FREQUENCY, LENGTH, SPEED, TIME, Text, quoted};

/// Of an edge that adheres: what only the way shows is found by integrating the way several times, at a tenth of the accuracy.
const SEARCHED: Accuracies = ([1e-2, 1e-3, 1e-2, 1e-3], 1e-4);

/// Sizes of a contact in SI, and how long its history takes.
pub(super) struct Contact {
    pub(super) depth: f64,
    pub(super) radius: f64,
    pub(super) force: f64,
    pub(super) span: f64,
    pub(super) framed: bool,
    /// Whether its shape has a size of its own.
    pub(super) sized: bool,
    pub(super) adhesive: bool,
}

/// Writes a standard test, or segments with conditions.
pub(super) fn write(text: &mut Text, contact: &Contact) {
    if contact.adhesive {
        text.accuracies = Some(SEARCHED);
    }
    if text.chance(0.6) {
        test(text, contact);
    } else {
        let segments = segments(text, contact);
        text.put("history", format!("[{}]", segments.join(", ")));
    }
}

fn test(text: &mut Text, contact: &Contact) {
    let &Contact { depth, force, span, framed, sized, .. } = contact;
    let kind = text.word(&["pull_off", "tack", "creep", "relaxation", "dynamic", "cyclic"]);
    text.put("test.kind", quoted(kind));
    if kind == "creep" {
        text.put_number("test.preload", 0.8, force, FORCE);
        text.put_number("test.dwell", 0.5, span, TIME);
        if text.chance(0.7) {
            text.put_number("test.rise", 0.2, span, TIME);
        }
        if text.chance(0.5) {
            text.put_number("test.recovery", 0.3, span, TIME);
        }
        return;
    }
    let speed = text.draw.between(2.0, 5.0);
    text.put_number("test.approach_speed", speed, depth / span, SPEED);
    if kind == "tack" || text.chance(0.5) {
        text.put_number("test.preload", 0.7, force, FORCE);
        if !sized || framed || text.chance(0.7) {
            text.put_number("test.approach_to", 8.0, depth, LENGTH);
        }
    } else {
        text.put_number("test.depth", 0.9, depth, LENGTH);
    }
    if kind == "relaxation" || text.chance(0.6) {
        text.put_number("test.dwell", 0.2, span, TIME);
    }
    let retracts = matches!(kind, "pull_off" | "tack" | "cyclic");
    if retracts && text.chance(0.6) {
        text.put_number("test.retraction_speed", 1.5 * speed, depth / span, SPEED);
    }
    if matches!(kind, "pull_off" | "tack") && (!sized || text.chance(0.7)) {
        text.put_number("test.retract_to", -6.0, depth, LENGTH);
    } else if kind == "cyclic" && text.chance(0.5) {
        text.put_number("test.retract_to", 0.3, depth, LENGTH);
    }
    if kind == "cyclic" {
        text.put("test.cycles", "2");
    }
    if kind == "dynamic" {
        text.put_number("test.amplitude", 0.05, depth, LENGTH);
        text.put_number("test.frequency", 4.0, 1.0 / span, FREQUENCY);
        if text.chance(0.6) {
            text.put_number("test.to_frequency", 9.0, 1.0 / span, FREQUENCY);
            if text.chance(0.8) {
                text.put("test.frequencies", "2");
            }
        }
        text.put("test.cycles", "12");
    }
}

fn segments(text: &mut Text, contact: &Contact) -> Vec<String> {
    let &Contact { depth, radius, force, span, framed, .. } = contact;
    let word = if framed && text.chance(0.6) { "frame" } else { "penetration" };
    let far = text.number(8.0 * depth, 1.0, LENGTH);
    let rate = text.number(4.0 * depth / span, 1.0, SPEED);
    let condition = match text.draw.below(if framed { 5 } else { 4 }) {
        0 => format!("force = {}", text.number(0.6 * force, 1.0, FORCE)),
        1 => format!("contact_radius = {}", text.number(0.8 * radius, 1.0, LENGTH)),
        2 => format!("penetration = {}", text.number(0.9 * depth, 1.0, LENGTH)),
        3 => format!("time = {}", text.number(0.25 * span, 1.0, TIME)),
        _ => format!("frame = {}", text.number(1.1 * depth, 1.0, LENGTH)),
    };
    let once = condition.starts_with("time");
    let mut segments = vec![format!("{{ {word} = {far}, rate = {rate}, until = {{ {condition} }} }}")];
    let back = text.number(-0.3 * depth, 1.0, LENGTH);
    let pace = if text.chance(0.5) { format!("rate = {rate}") } else { format!("duration = {}", text.number(0.1 * span, 1.0, TIME)) };
    segments.push(format!("{{ quantity = \"{word}\", by = {back}, {pace} }}"));
    if !once && text.chance(0.6) {
        segments.push("{ repeat = 2, segments = 2 }".to_owned());
    }
    if text.chance(0.4) {
        let out = text.number(-6.0 * depth, 1.0, LENGTH);
        segments.push(format!("{{ {word} = {out}, rate = {rate}, until = {{ event = \"detachment\" }} }}"));
    }
    segments
}
