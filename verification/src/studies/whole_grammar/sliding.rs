//! Draws of sliding contacts: states, branches, strengths.

use super::adhesion::{by_speed, works_file};
use super::material::{Scales, Taken, write as material};
use super::text::{ENERGY_PER_AREA, LENGTH, LOAD_PER_WIDTH, NUMBER, PRESSURE, SPEED, STIFFNESS_PER_AREA, Text, quoted};
use std::f64::consts::{PI, TAU};

const TAKEN: Taken = Taken { liquids: true, stiffest: 1e3, most_terms: 8, decades: 8.0 };

/// Reduced units in SI.
struct Scale {
    wave: bool,
    length: f64,
    depth: f64,
    load: f64,
    work: f64,
    speed: f64,
    pressure: f64,
    stiffness: f64,
}

fn body(text: &mut Text, scales: Scales) -> Scale {
    let wave = text.chance(0.75);
    if text.reduced {
        text.put(if wave { "sliding.wave" } else { "sliding.cylinder" }, "{}");
        return Scale { wave, length: 1.0, depth: 1.0, load: 1.0, work: 1.0, speed: 1.0, pressure: 1.0, stiffness: 1.0 };
    }
    let length = text.draw.log_between(1e-7, 1e-2);
    let slope = text.draw.log_between(1e-3, 0.3);
    let depth = slope * length;
    if wave {
        text.put_number("sliding.wave.wavelength", TAU, length, LENGTH);
        text.put_number("sliding.wave.amplitude", 1.0, depth, LENGTH);
    } else {
        text.put_number("sliding.cylinder.radius", 1.0 / slope, length, LENGTH);
    }
    if text.chance(0.15) {
        let stiffer = text.draw.log_between(1.0, 1e3);
        text.put_number("sliding.counter_body.modulus", stiffer, scales.modulus, PRESSURE);
        text.put("sliding.counter_body.poisson_ratio", "0.3");
    }
    let pressure = 0.5 * scales.modulus * slope;
    Scale {
        wave,
        length,
        depth,
        load: if wave { pressure } else { PI * scales.modulus * slope * length },
        work: PI * scales.modulus * slope * depth,
        speed: length / scales.time,
        pressure,
        stiffness: 0.5 * scales.modulus / length,
    }
}

/// Writes `[adhesion]`: Γ, the zone of the trailing edge, and whether works follow the speed, or zones a cohesive stress.
fn adhesion(text: &mut Text, scale: &Scale, speed: f64) -> (f64, f64, bool, bool) {
    let work = text.draw.log_between(1e-4, 0.05);
    let zones = [text.draw.log_between(1e-4, 0.03), text.draw.log_between(1e-4, 0.03)];
    let form = text.draw.below(12);
    match form {
        0..=6 => text.put_number("adhesion.work_of_adhesion", work, scale.work, ENERGY_PER_AREA),
        7 | 8 => {
            let lower = text.draw.between(0.2, 1.0);
            text.put_number("adhesion.trailing_work_of_adhesion", work, scale.work, ENERGY_PER_AREA);
            text.put_number("adhesion.leading_work_of_adhesion", lower * work, scale.work, ENERGY_PER_AREA);
        }
        _ => {
            let per_edge = text.chance(0.5);
            by_speed(text, form - 9, (work, scale.work), (speed, scale.speed), per_edge);
            if form == 11 {
                text.files.push(("works.csv".to_owned(), works_file(work * scale.work, speed * scale.speed)));
            }
        }
    }
    let cohesive = match text.draw.below(4) {
        0 => {
            // δ = αE0*Δγ/(πσ_c²): in reduced units of both.
            let factor = text.draw.between(0.2, 1.0);
            let stress = (factor * 4.0 * work / zones[0]).sqrt();
            // The law by the length of the other zone, which has no use here.
            let law = if zones[1] < 5e-4 {
                "dugdale"
            } else if zones[1] < 2e-3 {
                "exponential"
            } else {
                "constant"
            };
            let named = text.chance(0.3);
            if named && law != "constant" {
                text.put_number("adhesion.process_zone.peak_stress", 3.0 * stress, scale.pressure, PRESSURE);
            } else {
                text.put_number("adhesion.process_zone.cohesive_stress", stress, scale.pressure, PRESSURE);
                text.put_number("adhesion.process_zone.factor", factor, 1.0, NUMBER);
            }
            if named {
                text.put("adhesion.process_zone.law", quoted(law));
            }
            true
        }
        1 => {
            text.put_number("adhesion.process_zone.trailing_length", zones[0], scale.length, LENGTH);
            text.put_number("adhesion.process_zone.leading_length", zones[1], scale.length, LENGTH);
            false
        }
        _ => {
            text.put_number("adhesion.process_zone.length", zones[0], scale.length, LENGTH);
            false
        }
    };
    (work, zones[0], form > 8, cohesive)
}

pub(super) fn write(text: &mut Text) {
    text.reduced = text.chance(0.35);
    let scales = material(text, TAKEN);
    let scale = body(text, scales);
    // Two decades beyond all times on both sides.
    let speed = 10f64.powf(text.draw.between(-5.0, scales.decades.min(4.0) + 2.0));
    let sign = if text.chance(0.15) { -1.0 } else { 1.0 };
    let adhesive = text.chance(0.75);
    let found = if adhesive { Some(adhesion(text, &scale, speed)) } else { None };
    let task = if adhesive { text.draw.below(20) } else { 0 };
    match (task, found) {
        (18, Some((work, zone, follows, cohesive))) => branch(text, &scale, speed, (work, zone, !follows && !cohesive)),
        (19, Some(_)) => {
            text.put("sliding.strength", "{}");
            text.put_number("sliding.speed", speed, scale.speed, SPEED);
            columns(text, &["elastic_reference_contact", "sensitivities"], scale.wave);
        }
        _ => state(text, &scale, sign * speed, found.map(|(work, ..)| work)),
    }
}

/// Some of the optional columns; those of the elastic contact are of a wave.
fn columns(text: &mut Text, names: &[&str], wave: bool) {
    let chosen: Vec<&str> =
        names.iter().copied().filter(|name| (wave || *name != "elastic_reference_contact") && text.chance(0.3)).collect();
    if !chosen.is_empty() {
        text.put("sliding.columns", format!("{chosen:?}"));
    }
}

fn state(text: &mut Text, scale: &Scale, speed: f64, work: Option<f64>) {
    let adhesive = work.is_some();
    let speed = if text.chance(0.03) && adhesive { 0.0 } else { speed };
    text.put_number("sliding.speed", speed, scale.speed, SPEED);
    let load = text.draw.between(if adhesive { -0.02 } else { 0.02 }, 0.4);
    let held = match text.draw.below(3) {
        0 => {
            let width = text.draw.between(0.2, 2.6);
            text.put_number("sliding.half_width", width, scale.length, LENGTH);
            false
        }
        1 if scale.wave => {
            let depth = text.draw.between(0.1, 0.8);
            text.put_number("sliding.penetration", depth, scale.depth, LENGTH);
            true
        }
        _ if scale.wave => {
            text.put_number("sliding.mean_pressure", load, scale.load, PRESSURE);
            if text.chance(0.05) {
                let value = if text.reduced { load } else { load * scale.load };
                super::sweep::write(text, "sliding.mean_pressure", (value, PRESSURE), false);
            }
            true
        }
        _ => {
            text.put_number("sliding.load_per_width", load, scale.load, LOAD_PER_WIDTH);
            true
        }
    };
    if held && text.chance(0.3) {
        let word = text.word(&["loading", "unloading"]);
        text.put("sliding.reached_by", quoted(word));
    }
    if scale.wave && text.chance(0.2) {
        let stiffness = text.draw.log_between(0.05, 20.0);
        text.put_number("sliding.frame_stiffness", stiffness, scale.stiffness, STIFFNESS_PER_AREA);
    }
    if text.chance(0.3) {
        let contacts: &[&str] = match (adhesive, text.chance(0.5)) {
            (true, true) => &["adhesive", "adhesiveless"],
            (true, false) => &["adhesive"],
            (false, _) => &["adhesiveless"],
        };
        text.put("sliding.contacts", format!("{contacts:?}"));
    }
    if adhesive {
        columns(text, &["elastic_reference_contact", "friction_parts", "sensitivities"], scale.wave);
    }
    if text.chance(0.3) {
        let points = 24 + text.draw.below(16);
        text.put("fields.points", points.to_string());
    }
}

fn branch(text: &mut Text, scale: &Scale, speed: f64, (work, zone, free): (f64, f64, bool)) {
    let parameter = match (scale.wave, free) {
        (true, true) => text.word(&["mean_pressure", "penetration", "half_width", "speed", "work_of_adhesion", "process_zone"]),
        (true, false) => text.word(&["mean_pressure", "penetration", "half_width"]),
        (false, true) => text.word(&["load_per_width", "half_width", "speed", "work_of_adhesion"]),
        (false, false) => text.word(&["load_per_width", "half_width"]),
    };
    text.put("sliding.branch.parameter", quoted(parameter));
    text.put("sliding.branch.points", "6");
    let (from, to, unit, units) = match parameter {
        "mean_pressure" => (-0.1, 0.3, scale.load, PRESSURE),
        "load_per_width" => (-0.1, 0.3, scale.load, LOAD_PER_WIDTH),
        "penetration" => (-0.2, 0.6, scale.depth, LENGTH),
        "half_width" => (0.5, 1.5, scale.length, LENGTH),
        "speed" => (0.1 * speed, 10.0 * speed, scale.speed, SPEED),
        "work_of_adhesion" => (0.5 * work, 2.0 * work, scale.work, ENERGY_PER_AREA),
        _ => (0.5 * zone, 2.0 * zone, scale.length, LENGTH),
    };
    let by_load = matches!(parameter, "mean_pressure" | "load_per_width" | "penetration" | "half_width");
    let ranged = !by_load || !scale.wave || text.chance(0.5);
    if ranged {
        text.put_number("sliding.branch.from", from, unit, units);
        text.put_number("sliding.branch.to", to, unit, units);
    }
    if !by_load {
        text.put_number("sliding.half_width", 1.0, scale.length, LENGTH);
    }
    if parameter != "speed" {
        text.put_number("sliding.speed", speed, scale.speed, SPEED);
    }
    if scale.wave && text.chance(0.3) {
        text.put_number("sliding.branch.frame_stiffness", 1.0, scale.stiffness, STIFFNESS_PER_AREA);
    }
    if text.chance(0.3) {
        let word = if ranged && by_load && parameter != "half_width" { "followed" } else { text.word(&["followed", "every"]) };
        text.put("sliding.branch.branches", quoted(word));
    }
}
