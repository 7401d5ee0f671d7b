//! Fits of scenes to curves: how often 95 % intervals hold the truth, and whether a better minimum was missed.
//!
//! Each draw has a truth between bounds, a curve from it at a tolerance beyond the fit's own, and normal noise of 1 or 3 %. A fit starts as a person's does, from
//! the scene's own values and places of its own. A χ² at the truth below that of the fit shows a minimum that was missed: a fault.

mod cases;
mod shipped;

use super::cells::{count, number, word};
use super::draw::Draw;
use super::{Check, Column, Effort, Progress, Section, Table};
use cases::{CASES, Case, Scatter};
use rayon::prelude::*;
use std::fmt::Write;
use std::path::Path;
use viscotack::special::normal::Normal;
use viscotack_program::plan::fit::{Fit, Setup, carry_out};
use viscotack_program::scene::diagnostic::SourceText;
use viscotack_program::scene::document::Document;

/// The seed of all draws.
pub const SEED: u64 = 0xf17c;
/// Noise of the draws, one after the other.
const NOISE: [f64; 2] = [0.01, 0.03];
/// Tolerance of the curves of the truth.
const TIGHT: f64 = 1e-5;

/// What a family of fits gave.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Coverage {
    /// Intervals by profile, and by covariance, that hold the truth.
    pub covered: [usize; 2],
    /// Intervals.
    pub all: usize,
    /// Fits that ended in a worse minimum than that of the truth.
    pub missed: usize,
    /// Mean half width of the intervals by profile of the first number, over its value.
    pub width: f64,
    /// Fits.
    pub fits: usize,
    /// Seconds of all fits.
    pub seconds: f64,
    /// What could not be fitted.
    pub refusals: Vec<String>,
}

fn setup(case: &Case, rows: &str) -> Result<Setup, String> {
    let mut document = Document::parse("scene.toml", case.scene.to_owned(), Path::new(".")).map_err(|error| error.to_string())?;
    document.attach("data.csv", SourceText::new("data.csv", format!("{}\n{rows}", case.header)));
    Setup::new(&mut document).map_err(|error| error.to_string())
}

fn rows(places: &[f64], values: &[f64]) -> String {
    places.iter().zip(values).fold(String::new(), |mut text, (place, value)| {
        let _ = writeln!(text, "{place:e}, {value:e}");
        text
    })
}

/// One fit of a family: the fit, its truth, and χ² at the truth with the noise that the fit found.
///
/// # Errors
/// What refuses, in words.
pub fn drawn(family: usize, draw: u64) -> Result<(Fit, Vec<f64>, f64), String> {
    let case = CASES.get(family).ok_or("no such family")?;
    let mut numbers = Draw::of(SEED + family as u64, draw);
    let truth = case.truth(&mut numbers);
    let places = case.places();
    // The rows of a curve need values before they have any.
    let any: Vec<f64> = (0..places.len()).map(|row| 1.0 + 1e-3 * (row % 2) as f64).collect();
    let empty = setup(case, &rows(&places, &any))?;
    let clean = empty.simulated(&truth, TIGHT)?;
    let noise = NOISE.get(draw as usize % NOISE.len()).copied().unwrap_or(0.01);
    let mut stream = Normal::of(SEED ^ 0x5eed, draw + 1000 * family as u64);
    let largest = clean.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let noisy: Vec<f64> = clean
        .iter()
        .map(|value| match case.scatter {
            Scatter::OfTheLargest => value + noise * largest * stream.sample(),
            Scatter::OfEach => value * (noise * stream.sample()).exp(),
        })
        .collect();
    let setup = setup(case, &rows(&places, &noisy))?;
    let fit = carry_out(setup).map_err(|refusal| refusal.to_string())?;
    let there = fit.misfit_at(&truth)?;
    Ok((fit, truth, there))
}

/// Fits the first draws of a family.
#[must_use]
pub fn coverage(family: usize, draws: u64, progress: &Progress) -> Coverage {
    let of = |draw: u64| {
        let found = drawn(family, draw);
        progress.advance(1);
        found
    };
    let all: Vec<_> = (0..draws).into_par_iter().map(of).collect();
    let mut coverage = Coverage::default();
    for (draw, found) in all.into_iter().enumerate() {
        let (fit, truth, there) = match found {
            Ok(found) => found,
            Err(reason) => {
                coverage.refusals.push(format!("draw {draw}: {reason}"));
                continue;
            }
        };
        let fitted = fit.fitted();
        for (place, truth) in truth.iter().enumerate() {
            coverage.all += 1;
            for (kind, intervals) in [&fitted.by_profile, &fitted.by_covariance].into_iter().enumerate() {
                if let (Some(interval), Some(count)) = (intervals.get(place), coverage.covered.get_mut(kind)) {
                    *count += usize::from(interval.holds(*truth));
                }
            }
        }
        coverage.missed += usize::from(there < fitted.misfit - 0.1);
        coverage.fits += 1;
        coverage.seconds += fit.seconds();
        if let (Some(interval), Some(value)) = (fitted.by_profile.first(), fitted.values.first()) {
            coverage.width += 0.5 * (interval.upper.value() - interval.lower.value()) / value;
        }
    }
    coverage.width /= coverage.fits.max(1) as f64;
    coverage
}

/// The study.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let draws = effort.choose([4, 8, 8, 3], [90, 90, 90, 30]);
    progress.expect(draws.iter().sum());
    let mut section = Section::new("fit_coverage", "Fits of scenes to curves");
    section.say(format!(
        "{} fits of {} families with a known truth each and noise of 1 and 3 %. A fit finds its free numbers and their 95 % intervals, by profile likelihood and by covariance. \
         A fit whose χ² lies above that of the truth has missed a better minimum.",
        draws.iter().sum::<u64>(),
        CASES.len()
    ));
    let mut rows = Vec::new();
    let mut sum = Coverage::default();
    for (family, case) in CASES.iter().enumerate() {
        let found = coverage(family, draws.get(family).copied().unwrap_or(0), progress);
        let part = |covered: usize| covered as f64 / found.all.max(1) as f64;
        rows.push(vec![
            word(case.name),
            count(found.fits),
            number(part(found.covered[0])),
            number(part(found.covered[1])),
            number(found.width),
            count(found.missed),
            number(found.seconds / found.fits.max(1) as f64),
        ]);
        sum.all += found.all;
        sum.covered = [sum.covered[0] + found.covered[0], sum.covered[1] + found.covered[1]];
        sum.missed += found.missed;
        sum.refusals.extend(found.refusals.into_iter().map(|reason| format!("{}: {reason}", case.name)));
    }
    let columns = vec![
        Column::words("fit"),
        Column::new("fits", "1"),
        Column::new("covered by profiles", "1"),
        Column::new("covered by covariances", "1"),
        Column::new("mean half interval of the first number, relative", "1"),
        Column::new("better minima missed", "1"),
        Column::new("mean time beside others", "s"),
    ];
    let mut table = Table::new("fit_coverage", "How often 95 % intervals hold the truth", columns);
    table.rows = rows;
    section.tables.push(table);
    // So many intervals cover by chance within 2.6 standard deviations of 95 %; of all draws 93 to 97 % is asked.
    let slack = (2.6 * (0.95 * 0.05 / sum.all.max(1) as f64).sqrt()).max(0.02);
    let part = sum.covered[0] as f64 / sum.all.max(1) as f64;
    section.checks.push(Check::new(
        "95 % intervals by profile hold the truth",
        format!("{:.1} to {:.1} %", 95.0 - 100.0 * slack, (95.0 + 100.0 * slack).min(100.0)),
        format!("{:.1} % of {}", 100.0 * part, sum.all),
        (part - 0.95).abs() <= slack,
    ));
    section.checks.push(Check::new("no better minimum is missed", "0", sum.missed.to_string(), sum.missed == 0));
    section.checks.push(Check::new("every fit ends", "0 refusals", sum.refusals.join("; "), sum.refusals.is_empty()));
    // The fit of twelve terms takes most of a minute in a build that is not optimised.
    if effort == Effort::Full {
        let (table, check) = shipped::table();
        section.tables.push(table);
        section.checks.push(check);
    }
    section
}
