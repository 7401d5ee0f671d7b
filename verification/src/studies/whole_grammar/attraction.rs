//! Draws of laws by which an indenter attracts at a distance.

use super::material::Scales;
use super::text::{Accuracies, ENERGY_PER_AREA, LENGTH, NUMBER, PRESSURE, SPEED, TIME, Text, quoted};
use std::f64::consts::PI;

/// Of a smooth law, and of one with kinks or a hard wall, where each digit costs thirty times more.
const SMOOTH: Accuracies = ([1e-2, 1e-3, 1e-4, 1e-5], 1e-6);
const KINKED: Accuracies = ([1e-2, 1e-3, 1e-2, 1e-3], 1e-4);

/// Scenes of which one follows a protocol.
const PROTOCOLS: usize = 4;

/// A reduced law of Lennard-Jones, for tables.
fn stress(u: f64) -> f64 {
    let c = u.powi(-3);
    8.0 / 3.0 * (c * c * c - c)
}

/// A table of the sphere.
fn parabola(text: &mut Text, size: f64) {
    let rows = (0..=40).map(|k| 0.05 * f64::from(k)).map(|x| format!("{:e}, {:e}", x * size, 0.5 * x * x * size));
    let header = if text.reduced { "r, z" } else { "r (m), z (m)" };
    let rows: Vec<String> = rows.collect();
    text.put_file("indentation.profile", "shape.csv", format!("{header}\n{}\n", rows.join("\n")));
}

/// Writes a whole indenter of finite range: shape, law, start, history.
pub(super) fn indenter(text: &mut Text, scales: Scales) {
    let size = if text.reduced { 1.0 } else { text.draw.log_between(1e-6, 1e-4) };
    let range = size * text.draw.log_between(1e-3, 2e-2);
    let form = text.draw.below(8);
    match form {
        0 => text.put_number("indentation.cone.slope", (range / size).sqrt(), 1.0, NUMBER),
        1 | 2 => {
            if !text.reduced {
                text.put_number("indentation.power_law.radius", 1.0, size, LENGTH);
            }
            text.put("indentation.power_law.exponent", if form == 1 { "2.5" } else { "0.9" });
        }
        3 if text.reduced => text.put("indentation.flat_punch", "{}"),
        3 => text.put_number("indentation.flat_punch.radius", 1.0, size, LENGTH),
        4 => parabola(text, size),
        _ if text.reduced => text.put("indentation.sphere", "{}"),
        _ => text.put_number("indentation.sphere.radius", 1.0, size, LENGTH),
    }
    if form == 5 {
        text.put_number("indentation.rim_radius", 2.0, (size * range).sqrt(), LENGTH);
    }
    // A relaxed Tabor number of 0.2 to 2: Δγ = E0*(μr)^{3/2}/√R.
    let tabor = text.draw.log_between(0.2, 2.0);
    let work = scales.modulus * (tabor * range).powf(1.5) / size.sqrt() / if text.reduced { PI } else { 1.0 };
    let form = text.draw.below(if text.reduced { 2 } else { 4 });
    if form < 2 {
        text.put_number("adhesion.work_of_adhesion", work, 1.0, ENERGY_PER_AREA);
        let law = text.word(&["lennard_jones", "lennard_jones", "cosine", "exponential", "dugdale"]);
        text.put("adhesion.law", quoted(law));
        text.accuracies = Some(if law == "lennard_jones" { SMOOTH } else { KINKED });
        if law == "dugdale" {
            text.put("adhesion.ramp", "0.2");
        }
        if form == 0 {
            text.put_number("adhesion.range", range, 1.0, LENGTH);
        } else {
            text.put_number("adhesion.peak_stress", 1.03 * work / range, 1.0, PRESSURE);
        }
    } else {
        text.accuracies = Some(KINKED);
        let gaps = [0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2, 1.35, 1.6, 2.0, 2.5, 3.2, 4.0, 5.0, 7.0];
        let rows: Vec<String> = gaps.iter().map(|u| format!("{:e}, {:e}", u * range, work / range * stress(*u))).collect();
        if form == 2 {
            text.put_file("adhesion.table", "law.csv", format!("gap (m), stress (Pa)\n{}\n", rows.join("\n")));
        } else {
            text.put_file("adhesion.table", "law.csv", format!("u, w\n{}\n", rows.join("\n")));
            text.put("adhesion.columns.gap", quoted("u in m"));
            text.put("adhesion.columns.stress", quoted("w in Pa"));
        }
    }
    text.put("indentation.instants", "3");
    // One in so many is pressed and pulled as a protocol says: by digits that nothing else depends on.
    if text.draw.clone().digits().is_multiple_of(PROTOCOLS) {
        let depth = 4.0 * range;
        let far = text.number(8.0 * depth, 1.0, LENGTH);
        let speed = depth / (text_time(tabor) * scales.time);
        let rate = text.number(speed, 1.0, SPEED);
        let condition = if text.chance(0.5) {
            format!("penetration = {}", text.number(0.8 * depth, 1.0, LENGTH))
        } else {
            format!("contact_radius = {}", text.number(3.0 * (size * range).sqrt(), 1.0, LENGTH))
        };
        let back = text.number(-depth, 1.0, LENGTH);
        text.put(
            "history",
            format!("[{{ penetration = {far}, rate = {rate}, until = {{ {condition} }} }}, {{ quantity = \"penetration\", by = {back}, rate = {rate} }}]"),
        );
        return;
    }
    text.put("indentation.start", quoted("relaxed"));
    text.put_number("indentation.penetration", 4.0 * range, 1.0, LENGTH);
    let (end, during) = (text.number(-6.0 * range, 1.0, LENGTH), text.number(text_time(tabor), scales.time, TIME));
    text.put("history", format!("[{{ penetration = {end}, duration = {during} }}]"));
}

/// How long the pull takes, over the time of the material.
fn text_time(tabor: f64) -> f64 {
    0.3 + tabor
}
