//! What each effect adds: the value with it neutral equals the value without it, and without it the run costs less.
//!
//! Each effect is a pair of scenes, read and solved as a user's: one leaves it out, the other has it with a value that changes nothing. The thickness of a layer has no
//! scene: its kernel stands for it ([`layer`]).

pub mod layer;
pub mod scenes;

use super::cells::{count, number, word};
use super::{Check, Column, Effort, Progress, Section, Table};
use scenes::{Effect, Tolerance, effects};
use std::path::Path;
use std::time::Instant;
use viscotack_program::outcome::{Outcome, Row, Work};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

/// Solves a scene; seconds are the least of some runs.
///
/// # Errors
/// What is wrong with it, in words.
pub fn solved(text: &str, runs: u32) -> Result<(Outcome, f64), String> {
    let mut best = f64::INFINITY;
    let mut outcome = None;
    for _ in 0..runs.max(1) {
        let clock = Instant::now();
        let mut document = Document::parse("effect.toml", text.to_owned(), Path::new(".")).map_err(|error| error.to_string())?;
        read::resolve_includes(&mut document).map_err(|error| error.to_string())?;
        let scene = read::read(&document).map_err(|error| error.rendered())?;
        outcome = Some(plan::run(&document, &scene, Vec::new(), None, &|_| {}).map_err(|error| error.to_string())?);
        best = best.min(clock.elapsed().as_secs_f64());
    }
    outcome.map(|outcome| (outcome, best)).ok_or_else(|| "it was not run".into())
}

/// The rows of the first label of a state: other theories are another effect.
fn partners<'a>(with: &'a Outcome, without: &'a Outcome) -> Vec<(&'a Row, &'a Row)> {
    let time = |outcome: &Outcome, row: &Row| {
        let place = outcome.columns.iter().position(|column| column.name == "time")?;
        row.values.get(place).copied().flatten().map(|estimate| estimate.value)
    };
    // Rows of a history are partners at the same time; fields and cycles add rows between.
    let together = |row: &Row, other: &Row| match (time(without, row), time(with, other)) {
        (Some(one), Some(two)) => (one - two).abs() <= 1e-9 * one.abs().max(two.abs()),
        (None, None) => true,
        _ => false,
    };
    let same = |row: &Row, other: &Row| row.state == other.state && row.labels == other.labels && together(row, other);
    let mut pairs = Vec::new();
    let mut rest: Vec<&Row> = with.rows.iter().collect();
    for row in &without.rows {
        // Labels of contacts name the effect itself: where none matches, rows of a state stand for each other.
        let found = rest.iter().position(|other| same(row, other)).or_else(|| {
            let lone = |outcome: &Outcome| outcome.rows.iter().filter(|other| other.state == row.state).count() == 1;
            (lone(with) && lone(without)).then(|| rest.iter().position(|other| other.state == row.state)).flatten()
        });
        if let Some(place) = found {
            pairs.push((rest.remove(place), row));
        }
    }
    pairs
}

/// The largest difference of a column over its largest value, and how many values were compared.
#[must_use]
pub fn difference(effect: &Effect, with: &Outcome, without: &Outcome) -> (f64, usize) {
    let pairs = partners(with, without);
    let place = |outcome: &Outcome, name: &str| outcome.columns.iter().position(|column| column.name == name);
    let (mut worst, mut compared) = (0.0_f64, 0);
    for name in effect.columns {
        let (Some(first), Some(second)) = (place(with, name), place(without, name)) else { continue };
        let value = |row: &Row, index: usize| row.values.get(index).copied().flatten().map(|estimate| estimate.value);
        let values: Vec<(Option<f64>, Option<f64>)> = pairs.iter().map(|(one, other)| (value(one, first), value(other, second))).collect();
        let scale = values.iter().filter_map(|(_, other)| *other).fold(0.0_f64, |most, value| most.max(value.abs()));
        for pair in values {
            match pair {
                (Some(one), Some(other)) => {
                    let off = (one - other).abs();
                    worst = if off == 0.0 {
                        worst
                    } else if off.is_nan() {
                        f64::INFINITY
                    } else {
                        worst.max(off / scale.max(f64::MIN_POSITIVE))
                    };
                    compared += 1;
                }
                (None, None) => {}
                _ => worst = f64::INFINITY,
            }
        }
    }
    (worst, compared)
}

/// Whether a difference is within what both may differ by.
#[must_use]
pub fn equal(tolerance: Tolerance, difference: f64, compared: usize) -> bool {
    compared > 0
        && match tolerance {
            Tolerance::Exact => difference == 0.0,
            Tolerance::Relative(most, _) => difference <= most,
        }
}

/// Whether the work without an effect is nowhere more and, if the effect costs evaluations, somewhere less.
#[must_use]
pub fn cheaper(effect: &Effect, with: Work, without: Work) -> bool {
    let pairs = [
        (with.closure_evaluations, without.closure_evaluations),
        (with.kernel_evaluations, without.kernel_evaluations),
        (with.linear_solves, without.linear_solves),
        (with.field_evaluations, without.field_evaluations),
    ];
    let total = |work: Work| work.closure_evaluations + work.kernel_evaluations + work.linear_solves + work.field_evaluations;
    if effect.costs {
        total(without) < total(with) && pairs.iter().any(|(with, without)| without < with)
    } else {
        // Other last digits may take a Newton step more or less.
        10 * total(without) <= 11 * total(with)
    }
}

/// One effect with its value neutral beside the same without it.
struct Pair {
    name: &'static str,
    neutral: String,
    /// Which values are held against one another.
    compared: String,
    tolerance: Tolerance,
    difference: f64,
    values: usize,
    /// Whether it must cost evaluations.
    costs: bool,
    cheaper: bool,
    /// Work in words; with, without.
    work: [String; 2],
    evaluations: [u64; 2],
    seconds: [f64; 2],
}

impl Pair {
    fn of_scenes(effect: &Effect, runs: u32) -> Result<Self, String> {
        let (with, seconds_with) = solved(&effect.with, runs)?;
        let (without, seconds_without) = solved(&effect.without, runs)?;
        let (off, values) = difference(effect, &with, &without);
        let work = [with.work(), without.work()];
        let total = |work: Work| work.closure_evaluations + work.kernel_evaluations + work.linear_solves + work.field_evaluations;
        Ok(Self {
            name: effect.name,
            neutral: effect.neutral.to_owned(),
            compared: format!("{} of all rows", effect.columns.join(", ")),
            tolerance: effect.tolerance,
            difference: off,
            values,
            costs: effect.costs,
            cheaper: cheaper(effect, work[0], work[1]),
            work: work.map(|work| work.to_string()),
            evaluations: work.map(total),
            seconds: [seconds_with, seconds_without],
        })
    }

    fn of_layer(runs: u32) -> Result<Self, String> {
        let found = layer::compared(layer::THICK, runs).map_err(|refusal| refusal.to_string())?;
        Ok(Self {
            name: LAYER,
            neutral: format!("a layer of kd = {}, confined and free", layer::THICK),
            compared: "the kernel and its integral around the load; no contact, as none is solved on layers".into(),
            tolerance: Tolerance::Exact,
            difference: found.difference,
            values: found.values,
            costs: true,
            cheaper: found.evaluations[1] < found.evaluations[0],
            work: found.evaluations.map(|count| format!("{count} terms of kernels")),
            evaluations: found.evaluations,
            seconds: found.seconds,
        })
    }

    /// Adds both checks and the row.
    fn reported(self, section: &mut Section, table: &mut Table) {
        let tolerance = match self.tolerance {
            Tolerance::Exact => "to the bit".to_owned(),
            Tolerance::Relative(most, reason) => format!("{most:.0e}: {reason}"),
        };
        section.checks.push(Check::new(
            format!("{}: neutral, it changes nothing", self.name),
            tolerance.as_str(),
            format!("{:.1e}, {} values", self.difference, self.values),
            equal(self.tolerance, self.difference, self.values),
        ));
        let [work_with, work_without] = &self.work;
        section.checks.push(Check::new(
            format!("{}: left out, it costs nothing", self.name),
            if self.costs { "fewer evaluations" } else { "no more evaluations" },
            format!("with {work_with}; without {work_without}"),
            self.cheaper,
        ));
        let [evaluations_with, evaluations_without] = self.evaluations.map(|total| count(total as usize));
        let [seconds_with, seconds_without] = self.seconds.map(number);
        table.rows.push(vec![
            word(self.name),
            word(self.neutral),
            word(self.compared),
            count(self.values),
            number(self.difference),
            word(tolerance),
            evaluations_with,
            evaluations_without,
            seconds_with,
            seconds_without,
        ]);
    }
}

/// The effect that has no scene.
const LAYER: &str = "thickness of the layer (sliding)";

/// The study.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let effects = effects();
    progress.expect(effects.len() as u64 + 1);
    let mut section = Section::new("effects", "What each effect adds");
    section.say(
        "A table that is absent from a scene is an effect that is not simulated. Each effect is put into a scene with a value that changes nothing: the results must be those \
         of the scene without it, to the bit or to a stated tolerance, and the scene without it must cost less, by the solver's own counters. Times are the least of some runs. \
         Contacts on layers are not there: of a layer its kernel is held against the half-plane's.",
    );
    let mut table = Table::new(
        "effects",
        "Cost of effects that change nothing.",
        vec![
            Column::words("effect"),
            Column::words("made neutral by"),
            Column::words("compared"),
            Column::new("values compared", "1"),
            Column::new("largest difference", "1"),
            Column::words("tolerance, and why"),
            Column::new("evaluations with", "1"),
            Column::new("evaluations without", "1"),
            Column::new("time with", "s"),
            Column::new("time without", "s"),
        ],
    );
    let runs = effort.choose(2, 5);
    let mut pairs: Vec<(&'static str, Result<Pair, String>)> = Vec::new();
    for effect in &effects {
        pairs.push((effect.name, Pair::of_scenes(effect, runs)));
        progress.advance(1);
    }
    pairs.push((LAYER, Pair::of_layer(runs)));
    progress.advance(1);
    for (name, pair) in pairs {
        match pair {
            Ok(pair) => pair.reported(&mut section, &mut table),
            Err(reason) => section.checks.push(Check::new(name, "both are solved", reason, false)),
        }
    }
    section.tables.push(table);
    section
}
