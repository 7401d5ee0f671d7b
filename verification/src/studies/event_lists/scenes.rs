//! Random scenes of a crack under a load history, as a user types them.
//!
//! Loads lie between and around both limits of Eq 5.68, durations around the retardation times. A table of loads is typed here as the step and the ramps that the
//! reader makes of it, so that a scene needs no second file; a sine is such a table.

use super::super::draw::Draw;
use std::fmt::Write as _;

/// The scene without its accuracy.
#[must_use]
pub fn scene(draw: &mut Draw) -> String {
    let reduced = draw.chance(0.5);
    let terms = if draw.chance(0.4) { 1 } else { 1 + draw.below(12) };
    let beta = draw.log_between(1.2, 1000.0);
    let [longest, work, modulus] =
        if reduced { [1.0; 3] } else { [draw.log_between(1e-4, 1e4), draw.log_between(1e-3, 1e3), draw.log_between(1e3, 1e9)] };
    let mut text = String::new();
    let mut line = |words: std::fmt::Arguments<'_>| {
        let _ = writeln!(text, "{words}");
    };
    if reduced {
        line(format_args!("units = \"reduced\""));
    }
    line(format_args!("[material]"));
    let poisson = draw.between(0.0, 0.5);
    line(format_args!("poisson_ratio = {poisson:.3}"));
    if reduced {
        line(format_args!("glassy_modulus = {beta}"));
    } else {
        line(format_args!("relaxed_modulus = {modulus}\nglassy_modulus = {}", modulus * beta));
    }
    let decades = draw.log_between(0.3, 8.0);
    let weights: Vec<f64> = (0..terms).map(|_| draw.log_between(0.1, 10.0)).collect();
    let total: f64 = weights.iter().sum();
    let series: Vec<String> = weights
        .iter()
        .enumerate()
        .map(|(index, weight)| {
            let place = if index == 0 { 0.0 } else { (index as f64 + draw.between(-0.4, 0.4)) / terms as f64 };
            let time = longest * 10f64.powf(-decades * place);
            format!("{{ fraction = {}, retardation_time = {time} }}", weight / total)
        })
        .collect();
    line(format_args!("creep = [{}]", series.join(", ")));
    line(format_args!("[adhesion]"));
    if !reduced {
        line(format_args!("work_of_adhesion = {work}"));
    }
    let strip = !reduced && draw.chance(0.25);
    let halves = if draw.chance(0.5) { 2.0 } else { 1.0 };
    // Moduli of a reduced scene are plane ones already.
    let strain = !reduced && draw.chance(0.5);
    let plane_modulus = if strain { modulus / (1.0 - poisson_rounded(poisson).powi(2)) } else { modulus };
    let relaxed_limit = (2.0 * work * plane_modulus / halves).sqrt();
    if draw.chance(0.6) {
        line(format_args!(
            "process_zone = {{ length = {} }}",
            if reduced { draw.log_between(0.03, 30.0) } else { draw.log_between(1e-9, 1e-3) }
        ));
    } else {
        // The unit of length of a reduced scene fixes its cohesive stress.
        let cohesive =
            if reduced { String::new() } else { format!("cohesive_stress = {}, ", relaxed_limit / draw.log_between(1e-9, 1e-3).sqrt()) };
        let law = if draw.chance(0.7) { "growing" } else { "constant" };
        line(format_args!("process_zone = {{ {cohesive}law = \"{law}\" }}"));
    }
    line(format_args!("[crack]\npoints = 4"));
    line(format_args!("body = \"{}\"", if halves > 1.5 { "two_halves" } else { "against_rigid" }));
    if !reduced {
        line(format_args!("plane = \"{}\"", if strain { "strain" } else { "stress" }));
    }
    let mut unit = if reduced { std::f64::consts::FRAC_1_SQRT_2 } else { 1.0 } * relaxed_limit;
    let mut key = "stress_intensity";
    if strip {
        // K = σ√h of a strip that is free to contract sideways, to a factor near one.
        let height = draw.log_between(1e-4, 1e-1);
        line(format_args!("[crack.strip]\nhalf_height = {height}\nlateral = \"uniaxial\""));
        unit /= height.sqrt();
        key = "stress";
    }
    let load = |draw: &mut Draw| unit * beta.powf(0.5 * draw.between(0.03, 0.97));
    let low = |draw: &mut Draw| unit * draw.between(0.0, 1.1);
    let span = |draw: &mut Draw| longest * draw.log_between(1e-2, 1e2);
    let mut present = load(draw);
    if draw.chance(0.7) {
        line(format_args!("[[history]]\n{key} = {present}"));
    } else {
        line(format_args!("[[history]]\n{key} = {present}\nduration = {}", span(draw)));
    }
    for _ in 0..1 + draw.below(5) {
        match draw.below(10) {
            0..=2 => {
                let hold = match draw.below(8) {
                    0 => 0.0,
                    1 => longest * draw.log_between(1e2, 1e6),
                    _ => span(draw),
                };
                line(format_args!("[[history]]\nhold = {hold}"));
            }
            3 => {
                present = if draw.chance(0.4) { low(draw) } else { load(draw) };
                line(format_args!("[[history]]\n{key} = {present}"));
            }
            4 | 5 => {
                let next = if draw.chance(0.3) { low(draw) } else { load(draw) };
                if draw.chance(0.5) {
                    line(format_args!("[[history]]\n{key} = {next}\nduration = {}", span(draw)));
                } else {
                    line(format_args!("[[history]]\n{key} = {next}\nrate = {}", ((next - present).abs() + 1e-3 * unit) / span(draw)));
                }
                present = next;
            }
            6 | 7 => {
                let upper = load(draw);
                let lower = upper * draw.between(0.0, 0.98);
                let wave = if draw.chance(0.5) { "square" } else { "triangle" };
                let many = draw.chance(0.2);
                let count = 1 + draw.below(if many { 40 } else { 5 });
                let period = span(draw);
                line(format_args!("[[history]]\ncycles = {count}\nperiod = {period}\nlower = {lower}\nupper = {upper}\nwave = \"{wave}\""));
                present = lower;
            }
            8 => {
                // A table.
                let points = 2 + draw.below(5);
                for index in 0..points {
                    let next = if draw.chance(0.3) { low(draw) } else { load(draw) };
                    let duration = if index == 0 { String::new() } else { format!("\nduration = {}", span(draw)) };
                    line(format_args!("[[history]]\n{key} = {next}{duration}"));
                    present = next;
                }
            }
            _ => {
                // A sine in straight pieces.
                let (upper, pieces, cycles, period) = (load(draw), 16, 1 + draw.below(2), span(draw));
                let lower = upper * draw.between(0.1, 0.95);
                for piece in 0..=pieces * cycles {
                    let angle = std::f64::consts::TAU * piece as f64 / pieces as f64;
                    let next = 0.5 * (upper + lower) - 0.5 * (upper - lower) * angle.cos();
                    let duration = if piece == 0 { String::new() } else { format!("\nduration = {}", period / pieces as f64) };
                    line(format_args!("[[history]]\n{key} = {next}{duration}"));
                    present = next;
                }
            }
        }
    }
    // A history that only steps takes no time.
    line(format_args!("[[history]]\nhold = {}", span(draw)));
    text
}

/// The ratio as it is typed.
fn poisson_rounded(ratio: f64) -> f64 {
    (1e3 * ratio).round() / 1e3
}
