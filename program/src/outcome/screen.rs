//! The table on the screen: values with as many digits as their error leaves, and the blocks a reader needs before believing them.

use super::shown_units::in_unit;
use super::tally::Known;
use super::{Assessment, Outcome, Row, Status};
use std::fmt::Write as _;
use viscotack::estimate::Estimate;

/// Most rows that are printed one by one; longer sweeps show their first and last. A page has more room.
const MOST_ROWS: usize = 24;
pub(super) const MOST_ROWS_OF_A_PAGE: usize = 400;

/// Most rows of an unswept scene that are printed in blocks.
pub(super) const MOST_BLOCKS: usize = 4;

/// The whole screen output of a run.
#[must_use]
pub fn render(outcome: &Outcome) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "{}", outcome.title);
    let _ = writeln!(text, "{}", "─".repeat(outcome.title.chars().count().clamp(20, 100)));
    let states: Vec<&Row> = outcome.rows.iter().filter(|row| outcome.is_state(row)).collect();
    let way: Vec<&Row> = outcome.rows.iter().filter(|row| !outcome.is_state(row)).collect();
    // A few blocks are read more easily than a table; a curve is not.
    if outcome.swept.is_empty() && states.len() <= MOST_BLOCKS {
        single(&mut text, outcome, &states);
        if !way.is_empty() {
            table(&mut text, outcome, &way, false);
        }
    } else {
        table(&mut text, outcome, &states, true);
        let left = outcome.tally.rows - outcome.tally.states;
        if left > 0 {
            let _ = writeln!(text, "path.csv has the {left} instants and events on the way of these states");
        }
    }
    if outcome.draws > 0 {
        let _ = writeln!(
            text,
            "\nmaterial ±  one standard uncertainty: the standard deviation of {} draws of the fitted material; ± alone is the numerical error bound",
            outcome.draws
        );
    }
    effects(&mut text, outcome);
    validity(&mut text, outcome);
    let work = outcome.work();
    let _ = writeln!(text, "\nwork       {work}");
    text
}

/// One state: a line a value, a block a row.
fn single(text: &mut String, outcome: &Outcome, rows: &[&Row]) {
    let width = outcome.columns.iter().map(|column| column.name.len()).max().unwrap_or(0);
    for row in rows {
        let words: Vec<&str> = row.labels.iter().map(String::as_str).filter(|word| !word.is_empty()).collect();
        let _ = writeln!(text, "\n{}: {}", words.join(", "), row.status.word());
        if let Some(reason) = &row.reason {
            let _ = writeln!(text, "  {reason}");
        }
        let order: Vec<usize> =
            outcome.layout.as_ref().map_or_else(|| (0..outcome.columns.len()).collect(), |layout| layout.states.clone());
        for index in order {
            if let (Some(column), Some(estimate)) = (outcome.columns.get(index), row.values.get(index).copied().flatten()) {
                let (unit, size) = outcome.unit(index);
                let unit = if unit == "1" { "" } else { unit };
                let material = row.material_deviation(index).map_or_else(String::new, |deviation| {
                    // A number of the scene owes nothing to the material.
                    if deviation > 0.0 { format!("   material ± {:.1e}", deviation / size) } else { "   material ± 0".into() }
                });
                let line = format!("  {:width$}  {} {unit}{material}", column.name, with_error(in_unit(estimate, size)));
                let _ = writeln!(text, "{}", line.trim_end());
            }
        }
        if let Some(note) = row.material.as_ref().and_then(|material| material.note(&outcome.columns)) {
            let _ = writeln!(text, "  material: {note}");
        }
        if let Some(certificate) = row.certificate {
            let admissible = if certificate.admissible { "admissible" } else { "NOT admissible" };
            let _ = writeln!(
                text,
                "  certificate: {admissible}, residual {:.1e}, condition {:.1e}",
                certificate.residual, certificate.condition
            );
        }
    }
}

/// The cells of a table: a line a row, with the columns that vary or matter most, of states, or of what lies on the way of one. The first line names them; of more
/// than so many rows the first and the last are there.
pub(super) fn cells(outcome: &Outcome, rows: &[&Row], of_states: bool, most: usize) -> (Vec<usize>, Vec<Vec<String>>) {
    let headline = if of_states { outcome.headline } else { outcome.path_headline };
    let named = |index: &usize| outcome.columns.get(*index).is_some_and(|column| headline.contains(&column.name));
    let own =
        |index: &usize| outcome.layout.as_ref().is_none_or(|layout| if of_states { &layout.states } else { &layout.path }.contains(index));
    let (mut first, rest): (Vec<usize>, Vec<usize>) = (0..outcome.columns.len())
        .filter(|index| own(index) && wanted(outcome, rows, *index))
        .partition(|index| headline.is_empty() || named(index));
    first.sort_by_key(|index| outcome.columns.get(*index).and_then(|column| headline.iter().position(|name| *name == column.name)));
    let shown: Vec<usize> = if first.is_empty() { rest } else { first }.into_iter().take(5).collect();
    let labels: Vec<usize> = match &outcome.layout {
        Some(layout) if of_states => layout.labels.clone(),
        _ => (0..outcome.labels.len()).collect(),
    };
    let swept = outcome.swept.iter().enumerate();
    let mut header: Vec<String> = swept.map(|(place, swept)| with_unit(&swept.key, outcome.swept_unit(place).0)).collect();
    header.extend(labels.iter().filter_map(|place| outcome.labels.get(*place)).map(|label| (*label).to_owned()));
    let named = shown.iter().filter_map(|&index| Some((outcome.columns.get(index)?, outcome.unit(index).0)));
    header.extend(named.map(|(column, unit)| with_unit(column.name, unit)));
    let mut lines = vec![header];
    let total = total(outcome, of_states);
    for (index, row) in rows.iter().enumerate() {
        // A line that says that one is left out takes its place.
        if total > most + 1 && index >= most / 2 && index + most / 2 < rows.len() {
            if index == most / 2 {
                lines.push(vec![format!("… {} more", total - most)]);
            }
            continue;
        }
        lines.push(line(outcome, row, &labels, &shown));
    }
    (shown, lines)
}

fn total(outcome: &Outcome, of_states: bool) -> usize {
    let tally = &outcome.tally;
    if of_states { tally.states } else { tally.rows - tally.states }
}

fn table(text: &mut String, outcome: &Outcome, rows: &[&Row], of_states: bool) {
    let (shown, lines) = cells(outcome, rows, of_states, MOST_ROWS);
    let _ = write!(text, "\n{}", aligned(&lines));
    remarks(text, outcome, rows, &shown, of_states);
}

/// Under a table: how well its values are known, and what ended otherwise.
pub(super) fn remarks(text: &mut String, outcome: &Outcome, rows: &[&Row], shown: &[usize], of_states: bool) {
    let (tally, total) = (&outcome.tally, total(outcome, of_states));
    bounds(text, outcome, shown, of_states);
    if outcome.draws > 0 {
        let relative =
            |row: &Row, index: usize| row.material_deviation(index).zip(row.value(index)).map(|(deviation, value)| deviation / value.abs());
        for index in shown {
            let all = rows.iter().filter_map(|row| relative(row, *index)).filter(|part| part.is_finite());
            let (low, high) = all.fold((f64::INFINITY, 0.0_f64), |(low, high), part| (low.min(part), high.max(part)));
            if let (Some(column), true) = (outcome.columns.get(*index), low.is_finite()) {
                let _ = writeln!(text, "material ± of {}: {low:.1e} to {high:.1e} of its values", column.name);
            }
        }
        let noted = || rows.iter().filter_map(|row| row.material.as_ref()?.note(&outcome.columns));
        if let Some(first) = noted().next() {
            let _ = writeln!(
                text,
                "material: in {} of {} rows not all draws have the same state, such as: {first}",
                noted().count(),
                rows.len()
            );
        }
    }
    // Solved, and something to say: full contacts.
    if let (true, (count, Some((word, reason)))) = (of_states, &tally.noted) {
        // What is said of one has its numbers.
        let more = if *count == 1 { "" } else { " say more, the first" };
        let space = if word.is_empty() { "" } else { " " };
        let _ = writeln!(text, "{count} of {total} rows{more}{space}{word}: {reason}");
    }
    for status in Status::ALL.into_iter().filter(|status| *status != Status::Solved) {
        let ended = tally.ended(status);
        let count = if of_states { ended.states } else { ended.rows - ended.states };
        if count > 0 {
            let _ = writeln!(text, "{count} of {total} rows {}: {}", status.word(), ended.reason.as_deref().unwrap_or(""));
        }
    }
}

/// How well the values shown are known: a bound for those that meet the accuracy, and which ones do not.
fn bounds(text: &mut String, outcome: &Outcome, shown: &[usize], of_states: bool) {
    let file = if of_states { "states.csv" } else { "path.csv" };
    let named = |index: usize| Some((outcome.columns.get(index)?.name, outcome.tally.known(index, of_states)));
    let known: Vec<(&str, Known)> = shown.iter().filter_map(|&index| named(index)).collect();
    // Of the accuracy all columns count, shown or not.
    let all: Vec<(&str, Known)> = (0..outcome.columns.len()).filter_map(named).collect();
    let largest = known.iter().map(|(_, known)| known.largest).fold(0.0, f64::max);
    let listed = |known: &[(&str, Known)], of: fn(&Known) -> usize| {
        let columns = known.iter().filter(|(_, known)| of(known) > 0);
        columns.map(|(name, known)| format!("{} of {name}", of(known))).collect::<Vec<_>>().join(", ")
    };
    let (small, missed) = (listed(&known, |known| known.small), listed(&all, |known| known.missed));
    let most = if known.iter().all(|(_, known)| known.small + known.missed == 0) { "each value shown" } else { "the other values shown" };
    if !missed.is_empty() {
        let _ = writeln!(text, "NOT known to the accuracy {:e}: {missed}", outcome.accuracy);
    }
    if !small.is_empty() {
        let _ = writeln!(text, "known to their own bounds only, being small or not held to the accuracy: {small}");
    }
    let _ = writeln!(text, "error bounds: at most ± {largest:.0e} of {most}; {file} has every one");
}

/// A column is shown in a table if some row has it and it is no input and no copy of a swept number or of a column before it.
fn wanted(outcome: &Outcome, rows: &[&Row], index: usize) -> bool {
    let Some(column) = outcome.columns.get(index) else { return false };
    let swept = outcome.swept.iter().any(|swept| swept.key.rsplit('.').next() == Some(column.name));
    let same_as = |other: usize| rows.iter().all(|row| row.values.get(index) == row.values.get(other));
    // An input that is not varied.
    let given = || {
        let mut values = rows.iter().filter_map(|row| row.values.get(index).copied().flatten());
        let first = values.next();
        rows.len() > 1 && first.is_some_and(|first| first.error == 0.0 && values.all(|value| value == first))
    };
    !swept && !given() && rows.iter().any(|row| row.values.get(index).is_some_and(Option::is_some)) && !(0..index).any(same_as)
}

fn line(outcome: &Outcome, row: &Row, labels: &[usize], shown: &[usize]) -> Vec<String> {
    let swept = row.swept.iter().enumerate();
    let mut cells: Vec<String> = swept.map(|(place, value)| five_digits(value / outcome.swept_unit(place).1)).collect();
    cells.extend(labels.iter().map(|place| row.label(*place).to_owned()));
    if row.status.has_values() {
        let value = |index: usize| Some(in_unit(row.values.get(index).copied()??, outcome.unit(index).1));
        cells.extend(shown.iter().map(|&index| value(index).map_or_else(String::new, short)));
    } else {
        cells.push(row.status.word().to_owned());
    }
    cells
}

fn aligned(lines: &[Vec<String>]) -> String {
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| lines.iter().filter_map(|line| line.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for line in lines {
        let cells: Vec<String> = line.iter().zip(&widths).map(|(cell, &width)| format!("{cell:width$}")).collect();
        let _ = writeln!(text, "{}", cells.join("  ").trim_end());
    }
    text
}

fn effects(text: &mut String, outcome: &Outcome) {
    let on: Vec<&str> = outcome.effects.iter().filter(|effect| effect.on).map(|effect| effect.name).collect();
    let off: Vec<&str> = outcome.effects.iter().filter(|effect| !effect.on).map(|effect| effect.name).collect();
    let _ = writeln!(text, "\nsimulated  {}", on.join(", "));
    if !off.is_empty() {
        let _ = writeln!(text, "left out   {}", off.join(", "));
    }
}

fn validity(text: &mut String, outcome: &Outcome) {
    let _ = writeln!(text, "\nvalidity of the model (error bounds say nothing about it)");
    for entry in &outcome.validity {
        let mark = match entry.assessment {
            Assessment::Good => "good   ",
            Assessment::Caution => "CAUTION",
            Assessment::NotAssessed => "unknown",
        };
        let value = entry.value.map_or_else(String::new, |value| format!(" = {value:.2e}"));
        let _ = writeln!(text, "  {mark}  {}{value}: {}", entry.name, entry.meaning);
    }
}

fn with_unit(name: &str, unit: &str) -> String {
    if unit == "1" { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// At most ten digits, as many as the error leaves: for sweep tables.
fn short(estimate: Estimate) -> String {
    // Counts and answers to yes or no.
    let whole = estimate.error == 0.0 && estimate.value.fract() == 0.0;
    if whole { plain(estimate.value) } else { rounded(estimate, 9) }
}

/// A value with as many digits as its error leaves, and the error: `1.2345678901 ± 2e-11`.
#[must_use]
pub fn with_error(estimate: Estimate) -> String {
    if estimate.error == 0.0 {
        return format!("{} (exact)", plain(estimate.value));
    }
    let error = format!("{:.0e}", estimate.error);
    format!("{} ± {}", rounded(estimate, 16), error.parse().map_or(error, plain))
}

fn rounded(estimate: Estimate, most_digits: usize) -> String {
    if estimate.value == 0.0 || !estimate.value.is_finite() {
        return plain(estimate.value);
    }
    let relative = estimate.relative_error();
    let digits = if relative == 0.0 { most_digits } else { ((-relative.log10()).ceil().max(0.0) as usize).min(most_digits) };
    let scientific = format!("{:.*e}", digits, estimate.value);
    // The digits of the number as rounded: 9.99 may have become 10.0.
    let power: i32 = scientific.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0);
    match usize::try_from(digits as i32 - power) {
        Ok(decimals) if WRITTEN_OUT.contains(&estimate.value.abs()) => format!("{:.*}", decimals, estimate.value),
        _ => scientific,
    }
}

/// A number that was given: at most five digits.
fn five_digits(value: f64) -> String {
    plain(format!("{value:.4e}").parse().unwrap_or(value))
}

/// Numbers that are read most easily without a power of ten.
const WRITTEN_OUT: std::ops::Range<f64> = 1e-3..1e6;

fn plain(value: f64) -> String {
    if value == 0.0 || WRITTEN_OUT.contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}
