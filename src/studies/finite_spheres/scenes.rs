//! A random scene as text, and its two solutions against each other.

use crate::outcome::{Outcome, Row, Status};
use crate::plan;
use crate::scene::{Document, read};
use crate::studies::draw::Draw;
use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;

/// Accuracies of both solutions.
const ACCURACIES: [f64; 2] = [1e-3, 1e-5];
/// Columns that are counts or residuals of one run, or are stated as soft: no bound is given for what they mean.
const OWN: [&str; 11] = [
    "steps",
    "nodes",
    "residual",
    "energy_defect",
    "jumps",
    "jump_loss",
    "released_energy",
    "pull_off_time",
    "pull_off_penetration",
    "pull_off_radius",
    "frame_displacement",
];

/// What a scene came to.
#[derive(Debug, Clone, Default)]
pub struct Compared {
    /// Values that both solutions have.
    pub values: usize,
    /// Those that differ by more than both bounds, in words.
    pub outside: Vec<String>,
    /// Why it was not solved and should have been.
    pub failed: Option<String>,
    /// Why it has no state, by physics.
    pub refused: Option<String>,
    /// Whether a solution misses its accuracy and says so.
    pub inaccurate: bool,
    /// What the energy balance leaves.
    pub defect: Option<f64>,
    /// Steps of the coarser one.
    pub steps: f64,
}

/// A scene of a seed, as text.
#[must_use]
pub fn text(seed: u64, scene: u64, accuracy: f64) -> String {
    let mut draw = Draw::of(seed, scene);
    let range = draw.log_between(1e-4, 1e-2);
    let (tabor, beta) = (draw.log_between(0.05, 6.0), draw.log_between(2.0, 1000.0));
    let work = (tabor * range).powf(1.5) / PI;
    let terms = [1, 3, 12][draw.below(3)];
    let weights: Vec<f64> = (0..terms).map(|_| draw.log_between(0.1, 1.0)).collect();
    let total: f64 = weights.iter().sum();
    let spread = if terms == 12 { 0.5 } else { 1.5 };
    let creep: Vec<String> = weights
        .iter()
        .enumerate()
        .map(|(k, weight)| {
            let time = draw.log_between(0.5, 2.0) * 10_f64.powf(spread * (k as f64 - 0.5 * (terms - 1) as f64));
            format!("{{ fraction = {:e}, retardation_time = {time:e} }}", weight / total)
        })
        .collect();
    let law = if draw.chance(0.2) { "cosine" } else { "lennard_jones" };
    // Depths in ranges, for shapes whose height over a contact is of one order.
    let shape = match draw.below(5) {
        0 => format!("cone = {{ slope = {:e} }}", range.sqrt() * draw.log_between(0.5, 2.0)),
        1 => format!("power_law = {{ exponent = {:e} }}", draw.between(1.3, 3.0)),
        _ => "sphere = {}".to_owned(),
    };
    let depth = range * draw.log_between(1.0, 30.0);
    let far = -range * draw.between(6.0, 12.0);
    let relaxed = draw.chance(0.5);
    let mut text = format!(
        "units = \"reduced\"\naccuracy = {accuracy:e}\n[material]\nglassy_modulus = {beta:e}\ncreep = [{}]\n[adhesion]\nwork_of_adhesion = {work:e}\nlaw = \"{law}\"\nrange = {range:e}\n[indentation]\n{shape}\ninstants = 8\n",
        creep.join(", ")
    );
    let _ = if relaxed { write!(text, "start = \"relaxed\"\npenetration = {depth:e}\n") } else { write!(text, "penetration = {far:e}\n") };
    let frame = draw.chance(0.2).then(|| work / range * draw.log_between(0.3, 100.0));
    if let Some(stiffness) = frame {
        let _ = writeln!(text, "frame_stiffness = {stiffness:e}");
    }
    text += "[indentation.energies]\n";
    let mut rate = || range * draw.log_between(1e-3, 1e5);
    let (approach, retreat) = (rate(), rate());
    if !relaxed {
        let _ = write!(text, "[[history]]\npenetration = {depth:e}\nrate = {approach:e}\n");
    }
    for _ in 0..draw.below(3) {
        let duration = draw.log_between(1e-3, 1e3);
        let _ = match draw.below(5) {
            0 => write!(text, "[[history]]\nhold = {duration:e}\n"),
            1 => write!(text, "[[history]]\npenetration = {:e}\n", depth * draw.between(0.5, 1.2)),
            2 => write!(text, "[[history]]\nforce = {:e}\nduration = {duration:e}\n", work * draw.between(-1.0, 20.0)),
            3 => write!(
                text,
                "[[history]]\npenetration = {depth:e}\nduration = {duration:e}\n[[history]]\noscillation = {{ quantity = \"penetration\", amplitude = {:e}, frequency = {:e}, cycles = {} }}\n",
                range * draw.log_between(0.1, 4.0),
                draw.log_between(1e-2, 1e2),
                1 + draw.below(3)
            ),
            _ => write!(text, "[[history]]\npenetration = {:e}\nduration = {duration:e}\n", depth * draw.between(0.3, 1.5)),
        };
    }
    let end = -range * (4.0 + 3.0 * tabor * tabor.max(1.0).sqrt() + 0.3 * depth / range).min(60.0);
    let _ = if frame.is_some() && draw.chance(0.7) {
        write!(text, "[[history]]\nframe = {:e}\nduration = {:e}\n", 6.0 * end, 6.0 * (depth - end) / retreat)
    } else {
        write!(text, "[[history]]\npenetration = {end:e}\nduration = {:e}\n", (depth - end) / retreat)
    };
    text
}

/// Draws a scene and compares its two solutions.
#[must_use]
pub fn compared(seed: u64, scene: u64) -> Compared {
    let solutions = ACCURACIES.map(|accuracy| solved(&text(seed, scene, accuracy)));
    let [coarse, fine] = match solutions {
        [Ok(coarse), Ok(fine)] => [coarse, fine],
        [Err(wrong), _] | [_, Err(wrong)] => return Compared { failed: Some(wrong), ..Compared::default() },
    };
    let mut compared = Compared::default();
    let (Some(first), Some(second)) = (coarse.rows.first(), fine.rows.first()) else { return compared };
    for row in [first, second] {
        let reason = || format!("scene {scene}: {}", row.reason.clone().unwrap_or_default());
        match row.status {
            Status::Solved => {}
            Status::Inaccurate => compared.inaccurate = true,
            Status::NoSuchState => compared.refused = Some(reason()),
            _ => compared.failed = Some(reason()),
        }
    }
    let named = |row: &Row, name: &str| coarse.columns.iter().position(|column| column.name == name).and_then(|place| row.value(place));
    compared.defect = named(first, "energy_defect").into_iter().chain(named(second, "energy_defect")).reduce(f64::max);
    compared.steps = named(first, "steps").unwrap_or(0.0);
    if compared.failed.is_some() || compared.refused.is_some() {
        return compared;
    }
    let instants = |outcome: &Outcome| -> Vec<Row> {
        outcome.rows.iter().filter(|row| ["summary", "instant"].contains(&row.label(0))).cloned().collect()
    };
    for (one, other) in instants(&coarse).iter().zip(&instants(&fine)) {
        for ((column, a), b) in coarse.columns.iter().zip(&one.values).zip(&other.values) {
            let (Some(a), Some(b), false) = (a, b, OWN.contains(&column.name)) else { continue };
            compared.values += 1;
            if (a.value - b.value).abs() > a.error + b.error {
                let place = named(one, "time").unwrap_or(f64::NAN);
                compared.outside.push(format!(
                    "scene {scene}: {} of the {} at {place:e}: {:e} ± {:.1e}, {:e} ± {:.1e}",
                    column.name,
                    one.label(0),
                    a.value,
                    a.error,
                    b.value,
                    b.error
                ));
            }
        }
    }
    compared
}

fn solved(text: &str) -> Result<Outcome, String> {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).map_err(|error| error.to_string())?;
    let scene = read::read(&document).map_err(|error| format!("{error}\n{text}"))?;
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).map_err(|error| error.to_string())
}
