//! Draws of steady cracks.

use super::adhesion::{by_speed, works_file};
use super::material::{Scales, Taken, write as material};
use super::text::{ENERGY_PER_AREA, INTENSITY, LENGTH, NUMBER, PRESSURE, SPEED, Text, quoted};
use std::f64::consts::PI;

pub(super) const TAKEN: Taken = Taken { liquids: true, stiffest: 1e4, most_terms: 12, decades: 10.0 };

/// The interface of a crack: Δγ and the zone at G = Δγ (both SI, or 1).
pub(super) struct Interface {
    pub(super) work: f64,
    pub(super) zone: f64,
    pub(super) halves: f64,
    /// The zone follows from a cohesive stress.
    pub(super) cohesive: bool,
}

/// Writes body, plane and process zone; not yet Δγ.
pub(super) fn interface(text: &mut Text, scales: Scales, closing: bool, steady: bool) -> Interface {
    let two_halves = text.chance(0.5);
    if !text.reduced || text.chance(0.5) {
        text.put("crack.body", quoted(if two_halves { "two_halves" } else { "against_rigid" }));
    }
    if !text.reduced {
        let plane = text.word(&["stress", "strain"]);
        text.put("crack.plane", quoted(plane));
    }
    let halves = if two_halves { 1.0 } else { 2.0 };
    let work = if text.reduced { 1.0 } else { text.draw.log_between(1e-3, 1e3) };
    let laws: &[&str] = match (closing, steady) {
        (true, _) => &["growing", "constant", "schapery"],
        (false, _) => &["growing", "constant"],
    };
    let cohesive = text.chance(0.5);
    let zone = if cohesive {
        let stress = scales.modulus * text.draw.log_between(1e-2, 1e3);
        if !text.reduced {
            text.put_number("adhesion.process_zone.cohesive_stress", stress, 1.0, PRESSURE);
        }
        if text.chance(0.7) {
            let factor = text.draw.between(0.1, 2.0);
            text.put("adhesion.process_zone.factor", format!("{factor:.3}"));
        }
        if text.chance(0.7) {
            let law = text.word(laws);
            text.put("adhesion.process_zone.law", quoted(law));
        }
        if text.reduced { 1.0 } else { scales.modulus * work / (PI * stress * stress * halves) }
    } else {
        let length = if text.reduced { 1.0 } else { text.draw.log_between(1e-9, 1e-3) };
        text.put_number("adhesion.process_zone.length", 1.0, length, LENGTH);
        length
    };
    Interface { work, zone, halves, cohesive }
}

pub(super) fn write(text: &mut Text) {
    text.reduced = text.chance(0.25);
    let scales = material(text, TAKEN);
    let closing = text.chance(0.35);
    if closing || text.chance(0.3) {
        text.put("crack.motion", quoted(if closing { "closing" } else { "opening" }));
    }
    let interface = interface(text, scales, closing, true);
    if text.chance(0.5) {
        let theories: &[&str] = match (text.draw.below(4), interface.cohesive) {
            (0, _) => &["virtual_work"],
            (1, _) => &["virtual_work", "persson_brener"],
            (2, true) => &["cohesive_zone"],
            (_, true) => &["virtual_work", "persson_brener", "cohesive_zone"],
            _ => &["persson_brener"],
        };
        text.put("crack.theories", format!("{theories:?}"));
    }
    control(text, scales, &interface, closing);
    if text.chance(0.3) {
        let from = text.draw.log_between(1e-3, 1.0);
        text.put_number("fields.from", from, interface.zone, LENGTH);
        text.put_number("fields.to", from * 1e6, interface.zone, LENGTH);
        let points = 3 + text.draw.below(6);
        text.put("fields.points", points.to_string());
    }
}

fn control(text: &mut Text, scales: Scales, interface: &Interface, closing: bool) {
    let part = text.draw.between(0.02, 0.98);
    let release = scales.beta.powf(if closing { -part } else { part });
    let speed = 10f64.powf(text.draw.between(-6.0, scales.decades + 4.0));
    let unit = interface.zone / scales.time;
    let work = |text: &mut Text| text.put_number("adhesion.work_of_adhesion", interface.work, 1.0, ENERGY_PER_AREA);
    let ways = if text.reduced { 6 } else { 10 };
    match text.draw.below(ways) {
        0 if !text.reduced => {
            let law = text.draw.below(3);
            let per_edge = text.chance(0.4);
            by_speed(text, law, (interface.work, 1.0), (speed * unit, 1.0), per_edge);
            if law == 2 {
                text.files.push(("works.csv".to_owned(), works_file(interface.work, speed * unit)));
            }
            text.put_number("crack.speed", speed, unit, SPEED);
        }
        0..=3 => {
            work(text);
            let speed = if text.chance(0.03) { 0.0 } else { speed };
            text.put_number("crack.speed", speed, unit, SPEED);
        }
        4 => {
            work(text);
            text.put_number("crack.energy_release_rate", release, interface.work, ENERGY_PER_AREA);
        }
        5 => {
            work(text);
            let intensity = (release * interface.halves * interface.work * scales.modulus).sqrt();
            if text.reduced {
                text.put_number("crack.stress_intensity", release.sqrt(), 1.0, NUMBER);
            } else {
                text.put_number("crack.stress_intensity", intensity, 1.0, INTENSITY);
            }
        }
        6 | 7 => {
            work(text);
            let strain = text.draw.between(0.01, 0.3);
            let height = release * interface.work / (scales.modulus * strain * strain);
            text.put_number("crack.strip.half_height", height, 1.0, LENGTH);
            if text.chance(0.5) {
                text.put_number("crack.strip.strain", strain, 1.0, NUMBER);
            } else {
                text.put_number("crack.strip.stress", strain * scales.modulus, 1.0, PRESSURE);
            }
            if text.chance(0.6) {
                let lateral = text.word(&["clamped", "uniaxial"]);
                text.put("crack.strip.lateral", quoted(lateral));
            }
        }
        8 => {
            work(text);
            text.put_number("crack.speed", speed, unit, SPEED);
            super::sweep::write(text, "crack.speed", (speed * unit, SPEED), true);
        }
        _ => {
            work(text);
            text.put_number("crack.energy_release_rate", release, interface.work, ENERGY_PER_AREA);
            super::sweep::write(text, "adhesion.work_of_adhesion", (interface.work, ENERGY_PER_AREA), true);
        }
    }
}
