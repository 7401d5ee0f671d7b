//! Curves: rows selected from the table of a source, with the quantities of the axes.

use super::manifest::{Condition, CurveEntry, ManifestError};
use super::quantity::Quantity;
use super::table::Table;
use viscotack_program::plan::short_number;

/// A point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) x_error: f64,
    pub(super) y_error: f64,
    /// Not drawn dashed.
    pub(super) solid: bool,
}

/// A curve, measured and drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) label: Option<String>,
    /// A NaN is a gap.
    pub(super) points: Vec<Point>,
    pub(super) dashed: bool,
    pub(super) dotted: bool,
    pub(super) marked: bool,
    pub(super) hidden: bool,
    pub(super) colour: usize,
}

impl Curve {
    /// Its points without gaps.
    pub(super) fn solved(&self) -> Vec<(f64, f64)> {
        self.points.iter().map(|point| (point.x, point.y)).filter(|(x, y)| x.is_finite() && y.is_finite()).collect()
    }
}

/// The curves of an entry; `colour` is that of the first one.
pub(super) fn curves(
    place: &str,
    entry: &CurveEntry,
    table: &Table,
    (x, y): (&Quantity, &Quantity),
    colour: usize,
) -> Result<Vec<Curve>, ManifestError> {
    let (x, y) = (entry.x.as_ref().unwrap_or(x), entry.y.as_ref().unwrap_or(y));
    let named = entry.each.iter().chain(&entry.solid_where).chain(&entry.until_largest).chain(&entry.from_largest).map(String::as_str);
    let columns: Vec<&str> = x.columns().into_iter().chain(y.columns()).chain(named).collect();
    if let Some(name) = columns.into_iter().find(|name| !table.numbers.contains_key(*name)) {
        return Err(unknown(place, name, table));
    }
    if let Some(name) = entry.when.keys().find(|name| !table.numbers.contains_key(*name) && !table.words.contains_key(*name)) {
        return Err(unknown(place, name, table));
    }
    let rows: Vec<usize> =
        (0..table.rows).filter(|row| entry.when.iter().all(|(name, condition)| condition.holds(table, name, *row))).collect();
    let families: Vec<(Option<f64>, Vec<usize>)> = match &entry.each {
        None => vec![(None, rows)],
        Some(each) => {
            let mut values: Vec<f64> = Vec::new();
            for value in rows.iter().filter_map(|row| table.number(each, *row)).map(|(value, _)| value) {
                let wanted = entry.only.is_empty() || entry.only.iter().any(|only| near(*only, value));
                if wanted && !values.iter().any(|known| near(*known, value)) {
                    values.push(value);
                }
            }
            let of =
                |value: f64| rows.iter().copied().filter(|row| table.number(each, *row).is_some_and(|(own, _)| near(own, value))).collect();
            values.into_iter().map(|value| (Some(value), of(value))).collect()
        }
    };
    if families.iter().all(|(_, rows)| rows.is_empty()) {
        return Err(ManifestError::Contradiction {
            place: place.to_owned(),
            problem: format!("the curve `{}` selects no row", entry.name),
        });
    }
    let made = families.into_iter().enumerate().map(|(index, (value, rows))| {
        let rows = part(entry, table, rows);
        let mut points: Vec<Point> = rows
            .iter()
            .map(|&row| {
                let (x, x_error) = x.at(table, row).unwrap_or((f64::NAN, 0.0));
                let (y, y_error) = y.at(table, row).unwrap_or((f64::NAN, 0.0));
                let solid = entry.solid_where.as_ref().is_none_or(|column| table.number(column, row).is_some_and(|(value, _)| value > 0.5));
                Point { x, y, x_error, y_error, solid }
            })
            .collect();
        if entry.sorted {
            points.sort_by(|one, other| one.x.total_cmp(&other.x));
        }
        Curve {
            name: entry.name.replace("{}", &value.map_or_else(String::new, plain)),
            label: entry
                .label
                .as_ref()
                .map(|label| label.replace("{}", &value.map_or_else(String::new, |value| short_number(entry.shown_times * value)))),
            points,
            dashed: entry.dashed,
            dotted: entry.dotted,
            marked: entry.marked,
            hidden: entry.hidden,
            colour: entry.colour.unwrap_or(colour) + if entry.one_colour { 0 } else { index },
        }
    });
    Ok(made.collect())
}

fn unknown(place: &str, name: &str, table: &Table) -> ManifestError {
    ManifestError::Unknown { place: place.to_owned(), what: "column", name: name.to_owned(), known: table.names() }
}

/// Swept values are written and read back: equal but for rounding.
fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * one.abs().max(other.abs())
}

/// A number in the name of a curve: `0.05`, `2e-5`.
fn plain(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}

/// The rows before or after a turn.
fn part(entry: &CurveEntry, table: &Table, rows: Vec<usize>) -> Vec<usize> {
    let turn = |column: &str| {
        let value = |row: &usize| table.number(column, *row).map_or(f64::NEG_INFINITY, |(value, _)| value);
        rows.iter().enumerate().max_by(|one, other| value(one.1).total_cmp(&value(other.1))).map_or(0, |(place, _)| place)
    };
    let until = entry.until_largest.as_ref().map_or(rows.len(), |column| turn(column) + 1);
    let from = entry.from_largest.as_ref().map_or(0, |column| turn(column));
    rows.get(from.min(until)..until).unwrap_or_default().to_vec()
}

impl Condition {
    fn holds(&self, table: &Table, name: &str, row: usize) -> bool {
        match self {
            Self::Word(word) => table.words.get(name).and_then(|words| words.get(row)).is_some_and(|own| own == word),
            Self::Number(value) => table.number(name, row).is_some_and(|(own, _)| near(own, *value)),
            Self::Range(range) => table
                .number(name, row)
                .is_some_and(|(own, _)| range.above.is_none_or(|bound| own > bound) && range.below.is_none_or(|bound| own < bound)),
        }
    }
}
