//! Draws of surfaces that slide and act at a distance.

use super::material::{Taken, write as material};
use super::text::{ENERGY_PER_AREA, LENGTH, NUMBER, PRESSURE, SPEED, STIFFNESS_PER_AREA, Text, quoted};
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

const TAKEN: Taken = Taken { liquids: false, stiffest: 30.0, most_terms: 4, decades: 3.0 };
/// Heights of a drawn profile or map along each direction.
const POINTS: usize = 16;

/// Nodes along x that a scene allows, and its truth: of a line, of a surface.
const NODES: [[&str; 2]; 2] = [["4096", "16384"], ["256", "512"]];

/// Reduced units in SI.
struct Scale {
    /// 1/k.
    length: f64,
    /// Λ.
    height: f64,
    pressure: f64,
    speed: f64,
    modulus: f64,
}

pub(super) fn write(text: &mut Text) {
    text.reduced = text.chance(0.4);
    let scales = material(text, TAKEN);
    let length = if text.reduced { 1.0 } else { text.draw.log_between(1e-6, 1e-3) };
    let slope = if text.reduced { 1.0 } else { text.draw.log_between(1e-2, 0.3) };
    let (height, pressure) = if text.reduced { (1.0, 1.0) } else { (slope * length, 0.5 * scales.modulus * slope) };
    let scale = Scale { length, height, pressure, speed: if text.reduced { 1.0 } else { length / scales.time }, modulus: scales.modulus };
    let is_line = shape(text, &scale);
    if text.chance(0.15) {
        let thickness = text.draw.log_between(0.3, 5.0);
        text.put_number("sliding.layer.thickness", thickness, scale.length, LENGTH);
        let backing = text.word(&["bonded", "free"]);
        text.put("sliding.layer.backing", quoted(backing));
        if text.reduced && text.chance(0.5) {
            text.put("sliding.layer.poisson_ratio", "0.4");
        }
    } else if !text.reduced && text.chance(0.15) {
        let stiffer = text.draw.log_between(1.0, 1e3);
        text.put_number("sliding.counter_body.modulus", stiffer, scale.modulus, PRESSURE);
        text.put("sliding.counter_body.poisson_ratio", "0.3");
    }
    let adhesive = text.chance(0.75);
    if adhesive {
        law(text, &scale);
    }
    let sign = if text.chance(0.15) { -1.0 } else { 1.0 };
    let speed = sign * 10f64.powf(text.draw.between(-2.0, 2.0));
    text.put_number("sliding.speed", speed, scale.speed, SPEED);
    load(text, &scale, adhesive, is_line);
    // A state of this many nodes takes a tenth of a second; where they do not suffice the row is flagged, and its bounds are compared all the same.
    text.put("sliding.most_nodes", NODES[usize::from(!is_line)][0]);
}

/// The same scene on the grids of its truth.
pub(super) fn on_finer_grids(text: &str) -> String {
    let line = |nodes: &str| format!("most_nodes = {nodes}\n");
    NODES.iter().fold(text.to_owned(), |text, [drawn, finer]| text.replace(&line(drawn), &line(finer)))
}

/// The sliding body, and whether it is a line.
fn shape(text: &mut Text, scale: &Scale) -> bool {
    let kind = text.draw.below(8);
    match kind {
        0..=2 => {
            if !text.reduced {
                text.put_number("sliding.profile.period", TAU, scale.length, LENGTH);
            }
            let mut items = Vec::new();
            for number in 1..=1 + text.draw.below(4) {
                let amplitude = text.draw.between(0.2, 1.0) / (number as f64).powi(2);
                let written = text.number(amplitude, scale.height, LENGTH);
                let phase = text.draw.between(0.0, TAU);
                items.push(format!("{{ number = {number}, amplitude = {written}, phase = {phase:.3} }}"));
            }
            text.put("sliding.profile.harmonics", format!("[{}]", items.join(", ")));
        }
        3 => roughness(text, scale, "sliding.profile", 8.0),
        4 => {
            let mut rows = header(text, &["a", "b"]);
            for i in 0..POINTS {
                let place = TAU * i as f64 / POINTS as f64;
                let _ = writeln!(rows, "{:e}, {:e}", place * scale.length, (place.cos() + 0.3 * (2.0 * place + 1.0).cos()) * scale.height);
            }
            text.put_file("sliding.profile.file", "profile.csv", rows);
            columns(text, "sliding.profile.columns", &[("x", "a"), ("h", "b")]);
            made_periodic(text, "sliding.profile");
        }
        5 => {
            let mut rows = String::new();
            for j in 0..POINTS {
                let cells: Vec<String> = (0..POINTS).map(|i| format!("{:e}", bump(i, j))).collect();
                rows.push_str(&cells.join(" "));
                rows.push('\n');
            }
            text.put_file("sliding.surface.file", "map.txt", rows);
            if !text.reduced {
                text.put_number("sliding.surface.pixel", TAU / POINTS as f64, scale.length, LENGTH);
            }
            if !text.reduced || text.chance(0.5) {
                text.put_number("sliding.surface.height_unit", 1.0, scale.height, LENGTH);
            }
            made_periodic(text, "sliding.surface");
            if text.chance(0.5) {
                let direction = text.word(&["x", "y"]);
                text.put("sliding.surface.direction", quoted(direction));
            }
        }
        6 => {
            let mut rows = header(text, &["a", "b", "c"]);
            let pitch = TAU / POINTS as f64 * scale.length;
            for (j, i) in (0..POINTS).flat_map(|j| (0..POINTS).map(move |i| (j, i))) {
                let _ = writeln!(rows, "{:e}, {:e}, {:e}", i as f64 * pitch, j as f64 * pitch, bump(i, j) * scale.height);
            }
            text.put_file("sliding.surface.file", "points.csv", rows);
            columns(text, "sliding.surface.columns", &[("x", "a"), ("y", "b"), ("z", "c")]);
            made_periodic(text, "sliding.surface");
        }
        _ => roughness(text, scale, "sliding.surface", 3.0),
    }
    kind < 5
}

/// The first line of a file whose names say nothing: the scene explains them.
fn header(text: &Text, names: &[&str]) -> String {
    let unit = if text.reduced { "" } else { " (m)" };
    names.iter().map(|name| format!("{name}{unit}")).collect::<Vec<_>>().join(", ") + "\n"
}

fn columns(text: &mut Text, key: &str, names: &[(&str, &str)]) {
    for (word, name) in names {
        text.put(&format!("{key}.{word}"), quoted(name));
    }
}

fn bump(i: usize, j: usize) -> f64 {
    let (x, y) = (TAU * i as f64 / POINTS as f64, TAU * j as f64 / POINTS as f64);
    0.6 * x.cos() + 0.4 * y.cos() + 0.2 * (x + 2.0 * y).sin()
}

fn roughness(text: &mut Text, scale: &Scale, body: &str, waves: f64) {
    let hurst = text.draw.between(0.3, 1.0);
    text.put(&format!("{body}.roughness.hurst"), format!("{hurst:.3}"));
    let rms = text.draw.between(0.2, 0.6);
    text.put_number(&format!("{body}.roughness.rms_height"), rms, scale.height, LENGTH);
    text.put_number(&format!("{body}.roughness.longest"), TAU, scale.length, LENGTH);
    text.put_number(&format!("{body}.roughness.shortest"), TAU / waves, scale.length, LENGTH);
    if text.chance(0.7) {
        let seed = text.draw.below(1000);
        text.put(&format!("{body}.roughness.seed"), seed.to_string());
    }
    if !text.reduced && text.chance(0.4) {
        text.put_number(&format!("{body}.period"), TAU * 1.0001, scale.length, LENGTH);
    }
}

fn made_periodic(text: &mut Text, body: &str) {
    if text.chance(0.6) {
        let ends = text.word(&["mirror", "window", "periodic"]);
        text.put(&format!("{body}.ends"), quoted(ends));
    }
    if text.chance(0.5) {
        let levelling = text.word(&["plane", "mean"]);
        text.put(&format!("{body}.levelling"), quoted(levelling));
    }
}

fn law(text: &mut Text, scale: &Scale) {
    let work = text.draw.log_between(2e-3, 2e-2);
    let range = text.draw.log_between(0.08, 0.3);
    if text.chance(0.15) {
        // The exponential law by points, in one system of units.
        let unit = scale.pressure * TAU * work / range;
        let mut rows = if text.reduced { "c, d\n".to_owned() } else { "c (m), d (Pa)\n".to_owned() };
        for i in 0..30 {
            let u = 0.4 * f64::from(i);
            let stress = if i == 29 { 0.0 } else { (-u).exp() };
            let _ = writeln!(rows, "{:e}, {:e}", u * range * scale.height, stress * unit);
        }
        text.put_file("adhesion.table", "law.csv", rows);
        columns(text, "adhesion.columns", &[("gap", "c"), ("stress", "d")]);
        return;
    }
    let law = text.word(&["exponential", "dugdale", "lennard_jones", "cosine"]);
    text.put("adhesion.law", quoted(law));
    let work_scale = if text.reduced { 1.0 } else { 2.0 * PI * scale.pressure * scale.height };
    text.put_number("adhesion.work_of_adhesion", work, work_scale, ENERGY_PER_AREA);
    if text.chance(0.5) {
        text.put_number("adhesion.range", range, scale.height, LENGTH);
    } else {
        text.put_number("adhesion.peak_stress", TAU * work / range, scale.pressure, PRESSURE);
    }
    if law == "dugdale" && text.chance(0.6) {
        text.put_number("adhesion.ramp", 0.4, 1.0, NUMBER);
    }
}

fn load(text: &mut Text, scale: &Scale, adhesive: bool, is_line: bool) {
    let by_gap = text.chance(0.3);
    let pressure = text.draw.between(0.05, 0.5);
    let stiffness = if text.reduced { 1.0 } else { scale.pressure / scale.height };
    if by_gap {
        let gap = text.draw.between(0.3, 0.9);
        text.put_number("sliding.mean_gap", gap, scale.height, LENGTH);
        if text.chance(0.4) {
            let stiff = text.draw.log_between(0.5, 20.0);
            text.put_number("sliding.frame_stiffness", stiff, stiffness, STIFFNESS_PER_AREA);
        }
    } else {
        text.put_number("sliding.mean_pressure", pressure, scale.pressure, PRESSURE);
        match text.draw.below(8) {
            // Many states: of lines alone.
            0..=3 if !is_line => {}
            0 => {
                text.put_number("sliding.loop.to", 2.0 * pressure, scale.pressure, PRESSURE);
                text.put("sliding.loop.points", "3");
                return;
            }
            1 => {
                text.put("sliding.branch.parameter", quoted("mean_pressure"));
                text.put("sliding.branch.points", "3");
                return;
            }
            2 | 3 => {
                let word = text.word(&["loading", "unloading", "long_range", "every"]);
                text.put("sliding.reached_by", quoted(word));
            }
            _ => {}
        }
    }
    if text.chance(0.3) {
        let contacts: &[&str] = match (adhesive, text.chance(0.5)) {
            (true, true) => &["adhesive", "adhesiveless"],
            (true, false) => &["adhesive"],
            (false, _) => &["adhesiveless"],
        };
        text.put("sliding.contacts", format!("{contacts:?}"));
    }
    if text.chance(0.3) {
        text.put("fields.points", "16");
    }
}
