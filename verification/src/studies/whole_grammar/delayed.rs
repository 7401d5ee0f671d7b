//! Draws of cracks under load histories.

use super::crack::interface;
use super::material::{Taken, write as material};
use super::text::{ENERGY_PER_AREA, INTENSITY, INTENSITY_RATE, LENGTH, NUMBER, PRESSURE, PRESSURE_RATE, TIME, Text, Units, quoted};

const TAKEN: Taken = Taken { liquids: true, stiffest: 30.0, most_terms: 3, decades: 2.0 };

/// The controlled quantity: its word, its unit in SI, and the units of its values and rates.
struct Controlled {
    word: &'static str,
    unit: f64,
    units: Units,
    rates: Units,
    per_second: f64,
}

pub(super) fn write(text: &mut Text) {
    text.reduced = text.chance(0.25);
    let scales = material(text, TAKEN);
    if text.chance(0.2) {
        text.put("crack.motion", quoted("opening"));
    }
    let interface = interface(text, scales, false, false);
    text.put_number("adhesion.work_of_adhesion", interface.work, 1.0, ENERGY_PER_AREA);
    let strip = !text.reduced && text.chance(0.3);
    let (word, unit, units, rates) = if strip {
        // Half a percent of strain at G = Δγ.
        let strain = 0.05;
        let height = interface.work / (scales.modulus * strain * strain);
        text.put_number("crack.strip.half_height", height, 1.0, LENGTH);
        if text.chance(0.6) {
            let lateral = text.word(&["clamped", "uniaxial"]);
            text.put("crack.strip.lateral", quoted(lateral));
        }
        ("stress", strain * scales.modulus, PRESSURE, PRESSURE_RATE)
    } else {
        let unit = if text.reduced { 1.0 } else { (interface.halves * interface.work * scales.modulus).sqrt() };
        ("stress_intensity", unit, INTENSITY, INTENSITY_RATE)
    };
    // Between the relaxed and the glassy limit.
    let part = text.draw.between(0.2, 0.8);
    let load = unit * (1.05 * scales.beta.powf(0.5 * part)).max(1.02);
    let span = scales.time * text.draw.log_between(0.5, 5.0);
    let controlled = Controlled { word, unit: load, units, rates, per_second: load / span };
    let segments = history(text, &controlled, span);
    text.put("history", format!("[{}]", segments.join(", ")));
    let points = text.draw.below(8);
    text.put("crack.points", points.to_string());
    if text.chance(0.4) {
        let spacing = text.word(&["linear", "logarithmic"]);
        text.put("crack.spacing", quoted(spacing));
        if spacing == "logarithmic" && text.chance(0.7) {
            text.put_number("crack.first_time", 1e-3, span, TIME);
        }
    }
    if text.chance(0.05) {
        let value = interface.work;
        if !text.reduced {
            super::sweep::write(text, "adhesion.work_of_adhesion", (value, ENERGY_PER_AREA), true);
        } else {
            super::sweep::write(text, "material.glassy_modulus", (1.5 * scales.beta, NUMBER), true);
        }
    }
}

/// Histories of which one goes up by steps.
const STEPPED: usize = 8;

fn history(text: &mut Text, controlled: &Controlled, span: f64) -> Vec<String> {
    let &Controlled { word, unit, units, rates, per_second } = controlled;
    let value = |text: &mut Text, part: f64| text.number(part, unit, units);
    let time = |text: &mut Text, part: f64| text.number(part, span, TIME);
    let go = |text: &mut Text, part: f64| format!("{{ {word} = {} }}", value(text, part));
    let ramp = |text: &mut Text, part: f64, during: f64| {
        let (value, during) = (value(text, part), time(text, during));
        format!("{{ {word} = {value}, duration = {during} }}")
    };
    let hold = |text: &mut Text, during: f64| format!("{{ hold = {} }}", time(text, during));
    let lower = text.draw.between(0.2, 0.8);
    // One in so many goes up by steps that repeat: by digits that nothing else depends on.
    if text.draw.clone().digits().is_multiple_of(STEPPED) {
        let by = value(text, 0.3);
        let pace = if text.chance(0.5) {
            format!("rate = {}", text.number(2.0, per_second, rates))
        } else {
            format!("duration = {}", time(text, 0.1))
        };
        return vec![go(text, lower), format!("{{ by = {by}, {pace} }}"), hold(text, 0.3), "{ repeat = 2, segments = 2 }".to_owned()];
    }
    match text.draw.below(6) {
        0 => vec![go(text, 1.0), hold(text, 1.0)],
        1 => vec![ramp(text, 1.0, 0.5), hold(text, 1.0)],
        2 => {
            let (target, rate) = (value(text, 1.0), text.number(2.0, per_second, rates));
            vec![format!("{{ {word} = {target}, rate = {rate} }}"), hold(text, 0.8)]
        }
        3 => {
            vec![go(text, 1.0), hold(text, 1.0), ramp(text, lower, 0.05), hold(text, 0.3), ramp(text, 1.0, 0.1), hold(text, 0.3)]
        }
        4 => {
            let (count, wave) = (2 + text.draw.below(3), text.word(&["triangle", "square"]));
            let (least, most, period) = (value(text, lower), value(text, 1.0), time(text, 0.4));
            let quantity = if text.chance(0.5) { format!(", quantity = \"{word}\"") } else { String::new() };
            vec![format!("{{ cycles = {count}, period = {period}, lower = {least}, upper = {most}, wave = \"{wave}\"{quantity} }}")]
        }
        _ => {
            let rows: Vec<String> = [(0.0, 0.02), (0.2, 0.5), (0.5, 1.0), (0.9, 1.05), (1.2, lower), (1.6, 1.1)]
                .iter()
                .map(|(when, part)| format!("{:e}, {:e}, 0", when * span, part * unit))
                .collect();
            text.files.push(("record.csv".to_owned(), format!("a, b, g\n{}\n", rows.join("\n"))));
            let names = if text.reduced { ["a", "b", "g"] } else { ["a in s", "b in B", "g in m"] };
            let own = names[1].replace('B', units.first().map_or("1", |unit| unit.0));
            let mut more = String::new();
            if text.chance(0.4) {
                more += &format!(", tolerance = {}", text.number(1e-3, unit, units));
            }
            if text.chance(0.4) {
                more += &format!(", contact_point = {}", text.number(0.01, unit, units));
            }
            if text.chance(0.3) {
                more += ", invert = false";
            }
            if text.chance(0.3) {
                more += &format!(", noise = \"{}\"", text.word(&["followed", "left_out"]));
            }
            vec![format!(
                "{{ table = \"record.csv\", quantity = \"{word}\", columns = {{ time = \"{}\", {word} = \"{own}\", growth = \"{}\" }}{more} }}",
                names[0], names[2]
            )]
        }
    }
}
