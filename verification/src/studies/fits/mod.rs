//! Fits of a material to data: how often the stated errors cover the truth, and what many rows take.
//!
//! Solids with nine terms are measured at seven temperatures with 2 % noise and a WLF shift of their own. The shifts are found from the data, a series is
//! fitted, and its E′, E″, J and R are compared with the truth over all reduced frequencies that were measured.

pub mod draws;

use super::cells::{count, number, word};
use super::{Check, Column, Effort, Progress, Section, Table};
use std::time::Instant;
use viscotack::material::Material;
use viscotack::material::fit::superposition::superpose;
use viscotack::material::fit::{Quantity, Wanted, fit};

/// What is compared.
const QUANTITIES: [(Quantity, &str); 4] = [
    (Quantity::Storage, "storage modulus E′"),
    (Quantity::Loss, "loss modulus E″"),
    (Quantity::Creep, "creep compliance J"),
    (Quantity::Relaxation, "relaxation modulus R"),
];
/// Places over the measured range.
const PLACES: usize = 46;
/// What the constants of the law are called.
const CONSTANTS: &str = "WLF constants";
/// Rows of the timed fit.
const ROWS: usize = 100_000;

/// How often stated errors cover.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Tally {
    /// Values whose error covers the truth.
    pub covered: usize,
    /// Values.
    pub all: usize,
    /// Sum of the stated errors: relative ones of a curve, decades of a shift.
    pub width: f64,
    /// Largest distance over stated error.
    pub worst: f64,
}

impl Tally {
    fn add(&mut self, off: f64, error: f64, width: f64) {
        self.all += 1;
        // A NaN is not covered.
        self.covered += usize::from(off <= error);
        self.width += width;
        self.worst = self.worst.max(off / error);
    }

    /// The part that is covered.
    #[must_use]
    pub fn coverage(&self) -> f64 {
        self.covered as f64 / self.all.max(1) as f64
    }
}

/// What a number of solids gave.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Coverage {
    /// E′, E″, J, R.
    pub curves: [Tally; 4],
    /// ln a_T.
    pub shifts: Tally,
    /// c₁ and c₂ of the WLF law through the shifts.
    pub constants: Tally,
    /// Solids for which superposition was said to hold, as it does.
    pub holding: usize,
    /// What could not be fitted.
    pub refusals: Vec<String>,
}

fn value(material: &Material, quantity: Quantity, at: f64) -> f64 {
    match quantity {
        Quantity::Storage => material.complex_modulus(at).map_or(f64::NAN, |modulus| modulus.storage),
        Quantity::Loss => material.complex_modulus(at).map_or(f64::NAN, |modulus| modulus.loss),
        Quantity::Relaxation => material.relaxation(at),
        Quantity::Creep => material.creep(at),
    }
}

/// Fits the first solids.
#[must_use]
pub fn coverage(solids: u64, progress: &Progress) -> Coverage {
    let mut coverage = Coverage::default();
    for seed in 0..solids {
        let found = draws::measured(seed)
            .and_then(|solid| superpose(&solid.isotherms, Some(draws::REFERENCE), false, Wanted::Scatter).map(|found| (solid, found)));
        progress.advance(1);
        let (solid, found) = match found {
            Ok(both) => both,
            Err(refusal) => {
                coverage.refusals.push(format!("solid {seed}: {refusal}"));
                continue;
            }
        };
        let [low, high] = solid.range();
        for (tally, (quantity, _)) in coverage.curves.iter_mut().zip(QUANTITIES) {
            for place in 0..PLACES {
                let frequency = low * (high / low).powf(place as f64 / (PLACES - 1) as f64);
                let at = if matches!(quantity, Quantity::Storage | Quantity::Loss) { frequency } else { 1.0 / frequency };
                let (truth, fitted) = (value(&solid.material, quantity, at), value(&found.fit.material, quantity, at));
                let error = found.fit.band.error(quantity, at);
                tally.add((fitted - truth).abs(), error, error / truth);
            }
        }
        for (_, shift) in found.shifts.iter().enumerate().filter(|(index, _)| *index != found.base) {
            let off = (shift.logarithm - solid.shift(shift.temperature)).abs();
            coverage.shifts.add(off, shift.error, shift.error / std::f64::consts::LN_10);
        }
        if let Some(law) = &found.williams_landel_ferry {
            for ((fitted, error), truth) in law.constants.iter().zip(law.errors).zip(solid.constants) {
                coverage.constants.add((fitted - truth).abs(), error, error / truth);
            }
        }
        coverage.holding += usize::from(found.holds() == Some(true));
    }
    coverage
}

/// The study.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let solids = effort.choose(16, 200);
    progress.expect(solids + 1);
    let mut section = Section::new("fits", "Fits of a material to data");
    section.say(format!(
        "{solids} solids with nine terms, each measured at seven temperatures with {:.0} % noise and shifted by a WLF law of its own. The shifts are found from the data. The \
         stated errors are two standard deviations, of noise, of the shifts, and of the number of terms.",
        100.0 * draws::NOISE
    ));
    let found = coverage(solids, progress);
    // A solid has about eight independent values a curve: the coverage of a few is itself known within some per cent.
    let [low, high] = effort.choose([0.88, 1.0], [0.93, 0.98]);
    let columns = vec![
        Column::words("quantity"),
        Column::new("values", "1"),
        Column::new("covered", "1"),
        Column::new("mean stated error", "1"),
        Column::new("largest distance over stated error", "1"),
    ];
    let mut table = Table::new(
        "coverage",
        "How often the stated error covers the truth; errors of curves and constants are relative, those of the shifts in decades.",
        columns,
    );
    let rows = QUANTITIES
        .iter()
        .map(|(_, name)| *name)
        .zip(found.curves)
        .chain([("shift factor a_T", found.shifts), (CONSTANTS, found.constants)]);
    for (name, tally) in rows {
        // Both constants of a solid are one number nearly.
        let [low, high] = if name == CONSTANTS { effort.choose([0.8, 1.0], [0.91, 1.0]) } else { [low, high] };
        let covered = tally.coverage();
        table.rows.push(vec![
            word(name),
            count(tally.all),
            number(covered),
            number(tally.width / tally.all.max(1) as f64),
            number(tally.worst),
        ]);
        let expected = format!("95 % of the truth within the stated error: between {low} and {high} for {solids} solids");
        section.checks.push(Check::new(
            format!("coverage of the {name}"),
            expected,
            format!("{:.1} % of {}", 100.0 * covered, tally.all),
            (low..=high).contains(&covered),
        ));
    }
    section.tables.push(table);
    section.checks.push(Check::new(
        "every solid is fitted",
        "no refusal: neighbours overlap",
        if found.refusals.is_empty() { "none".to_owned() } else { found.refusals.join("; ") },
        found.refusals.is_empty(),
    ));
    section.checks.push(Check::new(
        "superposition is said to hold",
        "it does hold: for at least 97 of 100 solids, and all but one of few",
        format!("{} of {solids}", found.holding),
        found.holding as f64 >= (0.97 * solids as f64).min(solids as f64 - 1.0),
    ));
    section.checks.push(many_rows());
    progress.advance(1);
    section
}

/// The time that many rows take.
fn many_rows() -> Check {
    let name = format!("{ROWS} rows, 20 terms");
    let expected = "fitted in less than a second, with 20 terms";
    let begin = Instant::now();
    match draws::many(ROWS).and_then(|data| {
        let begin = Instant::now();
        fit(&data, Wanted::Scatter).map(|fit| (fit, begin.elapsed().as_secs_f64()))
    }) {
        Ok((fit, seconds)) => {
            let terms = fit.material.relaxation_terms().len();
            Check::statement(name, expected, format!("{terms} terms in {seconds:.2} s"), seconds < 1.0 && terms == 20)
        }
        Err(refusal) => Check::new(name, expected, format!("{refusal}, after {:.2} s", begin.elapsed().as_secs_f64()), false),
    }
}
