//! Draws of indenters.

use super::adhesion::{by_speed, works_file};
use super::attraction;
use super::material::{Scales, Taken, write as material};
use super::protocol::{self, Contact};
use super::text::{ENERGY_PER_AREA, FORCE, FORCE_RATE, FREQUENCY, LENGTH, NUMBER, PRESSURE, SPEED, STIFFNESS, TIME, Text, Units, quoted};
use std::f64::consts::PI;

const TAKEN: Taken = Taken { liquids: true, stiffest: 30.0, most_terms: 3, decades: 2.0 };
/// Adhesive scenes cost a hundred times more.
pub(super) const ADHESIVE: f64 = 0.1;

/// Adhesive scenes of which one attracts at a distance.
const AT_A_DISTANCE: usize = 3;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    Sphere,
    Cone,
    Punch,
    Power,
    Profile,
}

/// Untouched scenes of which one follows a protocol.
const PROTOCOLS: usize = 4;

/// Sizes of the contact in SI: depth, radius, force.
struct Size {
    shape: Shape,
    depth: f64,
    radius: f64,
    force: f64,
    rimmed: bool,
}

fn shape(text: &mut Text, scales: Scales) -> Size {
    let shape = match text.draw.below(if text.reduced { 4 } else { 6 }) {
        0 => Shape::Cone,
        1 => Shape::Punch,
        2 => Shape::Power,
        4 => Shape::Profile,
        _ => Shape::Sphere,
    };
    let size = if text.reduced { 1.0 } else { text.draw.log_between(1e-6, 1e-2) };
    let reach = text.draw.log_between(3e-3, 0.1);
    let radius = reach * size;
    let mut depth = radius * reach;
    let exponent = text.draw.between(1.5, 5.0);
    match shape {
        Shape::Sphere if text.reduced => text.put("indentation.sphere", "{}"),
        Shape::Sphere => text.put_number("indentation.sphere.radius", 1.0, size, LENGTH),
        Shape::Cone => {
            text.put_number("indentation.cone.slope", reach, 1.0, NUMBER);
        }
        Shape::Punch if text.reduced => text.put("indentation.flat_punch", "{}"),
        Shape::Punch => text.put_number("indentation.flat_punch.radius", 1.0, radius, LENGTH),
        Shape::Power => {
            if !text.reduced {
                text.put_number("indentation.power_law.radius", 1.0, size, LENGTH);
            }
            text.put("indentation.power_law.exponent", format!("{exponent:.2}"));
            depth = size * reach.powf(exponent);
        }
        Shape::Profile => profile(text, size),
    }
    let radius = if shape == Shape::Punch && text.reduced { 1.0 } else { radius };
    let rimmed = !matches!(shape, Shape::Punch) && text.chance(0.1);
    if rimmed {
        text.put_number("indentation.rim_radius", 0.9, radius, LENGTH);
    }
    let unit = if text.reduced { 1.0 / PI } else { 1.0 };
    Size { shape, depth, radius, force: unit * scales.modulus * depth * radius, rimmed }
}

/// A table of a parabola, in one of its forms.
fn profile(text: &mut Text, size: f64) {
    let places = [0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3];
    let height = |x: f64| 0.5 * x * x * size;
    match text.draw.below(3) {
        0 => {
            let rows: Vec<String> = places.iter().map(|x| format!("{:e}, {:e}", x * size, height(*x))).collect();
            if text.chance(0.5) {
                text.put_file("indentation.profile", "shape.csv", format!("r (m), z (m)\n{}\n", rows.join("\n")));
            } else {
                text.put_file("indentation.profile", "shape.csv", format!("u, w\n{}\n", rows.join("\n")));
                text.put("indentation.scan.columns.r", quoted("u in m"));
                text.put("indentation.scan.columns.z", quoted("w in m"));
            }
        }
        1 => {
            let rows: Vec<String> = (-12..=12).map(|i| f64::from(i) * 0.025).map(|x| format!("{:e}, {:e}", x * size, height(x))).collect();
            let up = text.chance(0.5);
            let rows = if up {
                (-12..=12).map(|i| f64::from(i) * 0.025).map(|x| format!("{:e}, {:e}", x * size, -height(x))).collect()
            } else {
                rows
            };
            text.put_file("indentation.profile", "scan.csv", format!("u, w\n{}\n", rows.join("\n")));
            text.put("indentation.scan.apex", quoted(if up { "highest" } else { "lowest" }));
            text.put_number("indentation.scan.to", 0.28, size, LENGTH);
            text.put("indentation.scan.largest_residual", "0.1");
            text.put("indentation.scan.columns.x", quoted("u in m"));
            text.put("indentation.scan.columns.z", quoted("w in m"));
        }
        _ => {
            let mut rows = Vec::new();
            for i in -6..=6 {
                for j in -6..=6 {
                    let (x, y) = (0.05 * f64::from(i), 0.05 * f64::from(j));
                    rows.push(format!("{:e}, {:e}, {:e}", x * size, y * size, height(x.hypot(y))));
                }
            }
            text.put_file("indentation.profile", "map.csv", format!("u, v, w\n{}\n", rows.join("\n")));
            for (key, header) in [("x", "u in m"), ("y", "v in m"), ("z", "w in m")] {
                text.put(&format!("indentation.scan.columns.{key}"), quoted(header));
            }
        }
    }
}

fn adhesion(text: &mut Text, scales: Scales, size: &Size) {
    // γ̃ for which the JKR radius at no load is about the radius of the contact, or less.
    let per_area = text.draw.log_between(0.01, 0.3) * size.depth;
    let work = if text.reduced { per_area / PI } else { scales.modulus * per_area };
    let speed = size.radius / scales.time;
    match text.draw.below(8) {
        0 => {
            text.put_number("adhesion.trailing_work_of_adhesion", work, 1.0, ENERGY_PER_AREA);
            text.put_number("adhesion.leading_work_of_adhesion", 0.6 * work, 1.0, ENERGY_PER_AREA);
        }
        form @ 1..=3 => {
            let per_edge = text.chance(0.5);
            by_speed(text, form - 1, (work, 1.0), (speed, 1.0), per_edge);
            if form == 3 {
                text.files.push(("works.csv".to_owned(), works_file(work, speed)));
            }
        }
        _ => text.put_number("adhesion.work_of_adhesion", work, 1.0, ENERGY_PER_AREA),
    }
    let zone = text.draw.log_between(3e-3, 0.1) * size.radius;
    if text.chance(0.6) {
        text.put_number("adhesion.process_zone.length", zone, 1.0, LENGTH);
    } else {
        let factor = text.draw.between(0.2, 1.0);
        let stress =
            if text.reduced { (factor * work / zone).sqrt() / PI.sqrt() } else { (factor * scales.modulus * work / (PI * zone)).sqrt() };
        text.put_number("adhesion.process_zone.cohesive_stress", stress, 1.0, PRESSURE);
        text.put_number("adhesion.process_zone.factor", factor, 1.0, NUMBER);
        if text.chance(0.5) {
            let law = if size.shape == Shape::Punch { text.word(&["growing", "constant"]) } else { "constant" };
            text.put("adhesion.process_zone.law", quoted(law));
        }
    }
    if text.chance(0.2) {
        text.put_number("adhesion.interaction_range", 1e-4, size.radius, LENGTH);
    }
}

pub(super) fn write(text: &mut Text) {
    text.reduced = text.chance(0.25);
    let adhesive = text.chance(ADHESIVE);
    let scales = material(text, if adhesive { Taken { liquids: false, most_terms: 2, ..TAKEN } } else { TAKEN });
    // One adhesive scene in so many attracts at a distance: by digits of the next number that nothing else depends on, so that the others stay as they were.
    if adhesive && text.draw.clone().digits().is_multiple_of(AT_A_DISTANCE) {
        attraction::indenter(text, scales);
        return;
    }
    let size = shape(text, scales);
    if adhesive {
        adhesion(text, scales, &size);
    }
    if !text.reduced && !size.rimmed && size.shape != Shape::Punch && text.chance(0.1) {
        if size.shape != Shape::Sphere || text.chance(0.5) {
            text.put_number("indentation.counter_body.modulus", 10.0, scales.modulus, PRESSURE);
            text.put("indentation.counter_body.poisson_ratio", "0.3");
        }
        if size.shape == Shape::Sphere {
            text.put_number("indentation.counter_body.radius", 30.0, size.radius, LENGTH);
        }
    }
    let framed = text.chance(0.25);
    if framed {
        let stiffness = text.draw.log_between(0.3, 30.0) * size.force / size.depth;
        text.put_number("indentation.frame_stiffness", stiffness, 1.0, STIFFNESS);
    }
    let quick = text.draw.between(0.5, 2.0);
    if text.chance(0.2) {
        text.put("indentation.speed_factor", format!("{quick:.3}"));
    }
    let instants = 1 + text.draw.below(4);
    text.put("indentation.instants", instants.to_string());
    if text.chance(0.3) {
        text.put("indentation.energies", "{}");
    }
    let span = scales.time * text.draw.log_between(0.1, 10.0);
    let first = start(text, &size, adhesive);
    // One scene in so many follows a protocol: by digits of the next number that nothing else depends on, so that the others stay as they were.
    if first.is_empty() && text.draw.clone().digits().is_multiple_of(PROTOCOLS) {
        let sized = !matches!(size.shape, Shape::Cone);
        let contact = Contact { depth: size.depth, radius: size.radius, force: size.force, span, framed, sized, adhesive };
        protocol::write(text, &contact);
        return;
    }
    let segments = history(text, &size, (span, first), framed, adhesive);
    text.put("history", format!("[{}]", segments.join(", ")));
    if text.chance(0.2) {
        let (early, late) = (text.number(0.05, span, TIME), text.number(0.2, span, TIME));
        text.put("indentation.fields.times", format!("[{early}, {late}]"));
        if text.chance(0.5) {
            text.put_number("indentation.fields.to", 2.0, size.radius, LENGTH);
        }
        text.put("indentation.fields.points", "9");
    }
    if !text.reduced && text.chance(0.05) {
        super::sweep::write(text, "indentation.speed_factor", (1.3, NUMBER), true);
    }
}

/// A quantity of an indenter: word, size, units, units of its rate.
fn quantity(word: &'static str, size: &Size) -> (&'static str, f64, Units, Units) {
    match word {
        "force" => (word, size.force, FORCE, FORCE_RATE),
        "contact_radius" => (word, size.radius, LENGTH, SPEED),
        _ => (word, size.depth, LENGTH, SPEED),
    }
}

/// Writes the start; the word that is given at time zero.
fn start(text: &mut Text, size: &Size, adhesive: bool) -> &'static str {
    let words: &[&str] = if size.shape == Shape::Punch { &["penetration", "force"] } else { &["penetration", "force", "contact_radius"] };
    match text.draw.below(4) {
        0 => {
            text.put("indentation.start", quoted("relaxed"));
            given(text, size, words)
        }
        1 => {
            text.put("indentation.start", quoted("untouched"));
            if adhesive || text.chance(0.5) { given(text, size, words) } else { "" }
        }
        _ => "",
    }
}

fn given(text: &mut Text, size: &Size, words: &[&'static str]) -> &'static str {
    let word = words.get(text.draw.below(words.len())).copied().unwrap_or("penetration");
    let (word, value, units, _) = quantity(word, size);
    let part = text.draw.between(0.3, 0.8);
    text.put_number(&format!("indentation.{word}"), part * value, 1.0, units);
    word
}

fn history(text: &mut Text, size: &Size, (span, first): (f64, &'static str), framed: bool, adhesive: bool) -> Vec<String> {
    let words: &[&'static str] = match (framed, size.shape == Shape::Punch, adhesive && first != "contact_radius") {
        (true, ..) => &["frame", "frame", "penetration", "force"],
        (false, true, _) | (false, _, true) => &["penetration", "force"],
        (false, false, _) => &["penetration", "penetration", "force", "contact_radius"],
    };
    let mut word = words.get(text.draw.below(words.len())).copied().unwrap_or("penetration");
    if first == "contact_radius" && text.chance(0.5) {
        word = first;
    }
    let (word, value, units, rates) = quantity(word, size);
    let number = |text: &mut Text, part: f64| text.number(part * value, 1.0, units);
    let time = |text: &mut Text, part: f64| text.number(part, span, TIME);
    let ramp = |text: &mut Text, part: f64, during: f64| {
        let (target, during) = (number(text, part), time(text, during));
        format!("{{ {word} = {target}, duration = {during} }}")
    };
    let hold = |text: &mut Text, during: f64| format!("{{ hold = {} }}", time(text, during));
    let back = text.draw.between(0.2, 0.9);
    let swings = word != "contact_radius";
    match text.draw.below(9) {
        0 => vec![ramp(text, 1.0, 1.0)],
        1 => vec![ramp(text, 1.0, 0.5), hold(text, 1.0)],
        2 => vec![ramp(text, 1.0, 0.3), hold(text, 0.3), ramp(text, back, 0.4), ramp(text, 1.1, 0.4)],
        3 => vec![format!("{{ {word} = {} }}", number(text, 1.0)), hold(text, 1.0)],
        4 if first.is_empty() || first == word => {
            let (target, rate) = (number(text, 1.0), text.number(2.0 * value / span, 1.0, rates));
            vec![format!("{{ {word} = {target}, rate = {rate} }}"), hold(text, 0.5)]
        }
        5 => {
            let wave = text.word(&["triangle", "square"]);
            let (least, most, period) = (number(text, back), number(text, 1.0), time(text, 0.7));
            vec![format!("{{ cycles = 2, period = {period}, lower = {least}, upper = {most}, wave = \"{wave}\", quantity = \"{word}\" }}")]
        }
        6 => vec![table(text, word, (span, value), units)],
        _ if swings => {
            let (amplitude, frequency) = (number(text, 0.1), text.number(5.0 / span, 1.0, FREQUENCY));
            let rest = match text.draw.below(4) {
                0 => format!("cycles = 2, phase = {}", text.draw.between(-3.0, 3.0)),
                1 => format!("cycles = 2, to = {}", number(text, 1.2)),
                2 => "cycles = 12, until_stationary = true".to_owned(),
                _ => {
                    let (later, how) = (text.number(10.0 / span, 1.0, FREQUENCY), text.word(&["linear", "logarithmic"]));
                    format!("to_frequency = {later}, frequency_sweep = \"{how}\", duration = {}", time(text, 0.5))
                }
            };
            vec![
                ramp(text, 1.0, 0.3),
                format!("{{ oscillation = {{ quantity = \"{word}\", amplitude = {amplitude}, frequency = {frequency}, {rest} }} }}"),
            ]
        }
        _ => vec![ramp(text, 1.0, 0.2), ramp(text, back, 0.5)],
    }
}

fn table(text: &mut Text, word: &str, (span, value): (f64, f64), units: Units) -> String {
    let invert = text.chance(0.3);
    let sign = if invert { -1.0 } else { 1.0 };
    let own = units.first().map_or("1", |unit| unit.0);
    let rows: Vec<String> = [(0.0, 0.0), (0.1, 0.3), (0.3, 1.0), (0.5, 1.02), (0.7, 0.6), (1.0, 1.1)]
        .iter()
        .map(|(when, part)| format!("{:e}, {:e}, 0", when * span, sign * part * value))
        .collect();
    let names = if text.reduced {
        ["a".to_owned(), "b".to_owned(), "c".to_owned()]
    } else {
        ["a in s".to_owned(), format!("b in {own}"), "c in N".to_owned()]
    };
    text.files.push(("record.csv".to_owned(), format!("a, b, c\n{}\n", rows.join("\n"))));
    let mut columns = format!("time = \"{}\", {word} = \"{}\"", names[0], names[1]);
    if word != "force" && text.chance(0.5) {
        columns += &format!(", force = \"{}\"", names[2]);
    }
    let mut more = String::new();
    if invert || text.chance(0.3) {
        more += &format!(", invert = {invert}");
    }
    if text.chance(0.4) {
        more += &format!(", tolerance = {}", text.number(1e-3 * value, 1.0, units));
    }
    if text.chance(0.4) {
        more += &format!(", contact_point = {}", text.number(sign * 1e-2 * value, 1.0, units));
    }
    if text.chance(0.3) {
        more += &format!(", noise = \"{}\"", text.word(&["followed", "left_out"]));
    }
    format!("{{ table = \"record.csv\", quantity = \"{word}\", columns = {{ {columns} }}{more} }}")
}
