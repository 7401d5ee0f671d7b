//! The picture of the README: pull-off against rate by two theories, beside published boundary-element runs.
//!
//! `cargo run --release -p viscotack-cli --example readme_picture` solves `scenes/published/` for each Tabor number and writes
//! `docs/src/images/pull_off_against_rate.svg`.

use std::{error::Error, f64::consts::PI, fs, path::Path};
use viscotack_program::outcome::plot::{self, Axis, Curve, Figure, LegendPlace, Line, Marker, Width};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

/// Tabor numbers and preloads (ranges) of the published runs that are drawn, all with the modulus ratio and the spectrum of the scene.
const CASES: [(f64, f64); 5] = [(3.24, 55.744), (2.25, 11.13963), (0.9, 20.29415), (0.15, 4.831018), (0.05, 1.12623)];
/// The range of the scenes (R).
const RANGE: f64 = 3.0864e-4;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let published = published(&fs::read_to_string(root.join("reference_data/published_spheres.csv"))?)?;
    let axes = [r"pull-off rate $V\tau_0/h_0$", r"largest tension / JKR's pull-off force"];
    let mut figure = Figure::new(Axis::logarithmic(axes[0]).with_range(0.7, 1.5e6), Axis::linear(axes[1]).with_range(0.0, 11.0))
        .with_width(Width::TwoColumns)
        .with_legend(LegendPlace::Below);
    let edge = solved(&root.join("scenes/published/edge.toml"), &[])?;
    figure.curves.push(Curve::new("theory of an edge, Tabor number 3.24", edge).with_line(Line::Dashed).with_colour(2));
    let mut drawn: Vec<(f64, f64)> = Vec::new();
    for (index, (tabor, preload)) in CASES.into_iter().enumerate() {
        let colour = [0, 1, 3, 4, 6].get(index).copied().unwrap_or(0);
        let work = (tabor * RANGE).powf(1.5) / PI;
        let sets = [format!("adhesion.work_of_adhesion={work:e}"), format!("indentation.penetration={:e}", preload * RANGE)];
        let curve = solved(&root.join("scenes/published/finite_range.toml"), &sets)?;
        figure
            .curves
            .push(Curve::new(format!("attraction with a range, Tabor number {tabor}"), curve).with_line(Line::Solid).with_colour(colour));
        let runs = published
            .iter()
            .filter(|run| (run[2] / tabor - 1.0).abs() < 1e-3 && (run[1] / preload - 1.0).abs() < 1e-3)
            .map(|run| (run[0], run[5]));
        drawn.extend(runs);
    }
    figure
        .curves
        .push(Curve::new("published boundary-element runs", drawn).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(2));
    let file = root.join("docs/src/images/pull_off_against_rate");
    fs::write(file.with_extension("svg"), plot::svg(&figure)?)?;
    Ok(())
}

/// Largest tension over JKR's pull-off force, against the rate.
fn solved(scene: &Path, sets: &[String]) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let mut document = Document::load(scene)?;
    sets.iter().try_for_each(|set| document.set(set))?;
    read::resolve_includes(&mut document)?;
    let outcome = plan::run(&document, &read::read(&document)?, Vec::new(), None, &|_| ())?;
    let column = outcome.columns.iter().position(|column| column.name == "pull_off_ratio").ok_or("no pull-off ratio")?;
    let states = outcome.rows.iter().filter(|row| outcome.is_state(row));
    let points: Vec<(f64, f64)> = states.filter_map(|row| Some((*row.swept.first()?, row.value(column)?))).collect();
    println!("{}: {points:?}", scene.display());
    Ok(points)
}

/// Of the published rows those with the scene's modulus ratio and spectrum: the columns as numbers.
fn published(text: &str) -> Result<Vec<[f64; 6]>, Box<dyn Error>> {
    let mut runs = Vec::new();
    for line in text.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit())) {
        let numbers: Vec<f64> = line.split(',').take(6).map(str::parse).collect::<Result<_, _>>()?;
        let run: [f64; 6] = numbers.try_into().map_err(|_| "a row with too few numbers")?;
        if (run[3] - 0.1).abs() < 1e-6 && (run[4] - 1.6).abs() < 1e-6 {
            runs.push(run);
        }
    }
    Ok(runs)
}
