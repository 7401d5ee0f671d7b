//! From rows to curves: the rows of one kind at one set of outer swept values make a curve against the innermost swept number.

use crate::outcome::Row;
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line};
use crate::scene::sweep::Sweep;
use crate::scene::typed::Scene;

/// Most curves that a legend can distinguish; further ones of an outer sweep are thinned evenly.
const MOST_CURVES: usize = 10;

/// A kind of row, distinguished by its first label: a theory of a crack, a contact with or without adhesion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kind {
    /// The label.
    pub(super) word: &'static str,
    /// Its name in a legend.
    pub(super) name: &'static str,
    /// Its stroke.
    pub(super) line: Line,
}

/// Rows of one kind at one set of outer swept values.
pub(super) struct Family<'a> {
    pub(super) label: String,
    pub(super) kind: Kind,
    pub(super) colour: usize,
    /// Colour of its curves.
    pub(super) shade: Colour,
    pub(super) rows: Vec<&'a Row>,
}

impl Family<'_> {
    /// A stroke is a kind, a colour is a set of outer swept values.
    pub(super) fn curve(&self, points: Vec<(f64, f64)>) -> Curve {
        Curve::new(self.label.clone(), points).with_line(self.kind.line).with(self.shade)
    }

    /// Rows from left to right: their values, and one standard uncertainty of the material above and below.
    fn curve_of(&self, across: fn(&Row) -> f64, of: Ordinate) -> Curve {
        let mut rows: Vec<(f64, &Row)> = self.rows.iter().map(|row| (across(row), *row)).collect();
        if rows.iter().all(|(x, _)| x.is_finite()) {
            rows.sort_by(|left, right| left.0.total_cmp(&right.0));
        }
        let points = rows.iter().map(|(x, row)| (*x, of.factor * value(row, of.column))).collect();
        let deviations = rows.iter().map(|(_, row)| of.factor.abs() * row.material_deviation(of.column).unwrap_or(0.0));
        self.curve(points).with_band(deviations.collect())
    }

    /// One point a row.
    pub(super) fn points(&self, x: impl Fn(&Row) -> f64, y: impl Fn(&Row) -> f64) -> Vec<(f64, f64)> {
        self.rows.iter().map(|row| (x(row), y(row))).collect()
    }
}

/// The value of a column; a row without one is a gap in a curve.
pub(super) fn value(row: &Row, column: usize) -> f64 {
    row.value(column).unwrap_or(f64::NAN)
}

/// The innermost swept number of a row.
pub(super) fn innermost(row: &Row) -> f64 {
    row.swept.last().copied().unwrap_or(f64::NAN)
}

/// The axis of a swept number that has no label of its own.
pub(super) fn swept_axis(sweep: &Sweep) -> Axis {
    let unit = if sweep.unit == "1" { String::new() } else { format!(" ({})", sweep.unit) };
    axis_of(sweep, format!("{}{unit}", plain_name(&sweep.key)))
}

/// An axis spread as the swept values are.
pub(super) fn axis_of(sweep: &Sweep, label: String) -> Axis {
    if sweep.logarithmic { Axis::logarithmic(label) } else { Axis::linear(label) }
}

/// The last part of a key, in words.
fn plain_name(key: &str) -> String {
    key.rsplit('.').next().unwrap_or(key).replace('_', " ")
}

/// What is drawn of a row: a column, and how many times its value.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ordinate {
    pub(super) column: usize,
    pub(super) factor: f64,
}

impl From<usize> for Ordinate {
    fn from(column: usize) -> Self {
        Self { column, factor: 1.0 }
    }
}

/// A figure with a curve of a column for every family.
pub(super) fn figure(
    families: &[Family<'_>],
    (horizontal, vertical): (Axis, Axis),
    across: fn(&Row) -> f64,
    of: impl Into<Ordinate>,
) -> Figure {
    let of = of.into();
    let mut figure =
        families.iter().fold(Figure::new(horizontal, vertical), |figure, family| figure.with_curve(family.curve_of(across, of)));
    say_what_bands_are(&mut figure);
    figure
}

/// A line under a figure whose curves have bands.
pub(super) fn say_what_bands_are(figure: &mut Figure) {
    if figure.curves.iter().any(|curve| !curve.band.is_empty()) {
        figure.add_note("bands: one standard uncertainty of the material");
    }
}

/// The colour of one of so many curves in order.
pub(super) fn shade(place: usize, of: usize) -> Colour {
    // Two are distinguished from each other more easily by two colours.
    if of > 2 { Colour::Sequence { place, of } } else { Colour::Index(place) }
}

/// The sets of outer swept values, in order.
fn outer_sets<'a>(scene: &Scene, rows: &'a [Row]) -> Vec<&'a [f64]> {
    let outer = scene.sweeps.len().saturating_sub(1);
    let mut sets: Vec<&[f64]> = Vec::new();
    for row in rows {
        let set = row.swept.get(..outer).unwrap_or(&[]);
        if sets.last() != Some(&set) && !sets.contains(&set) {
            sets.push(set);
        }
    }
    sets
}

/// Curves of each kind that are drawn, at most.
fn most_sets(kinds: usize) -> usize {
    (MOST_CURVES / kinds.max(1)).max(1)
}

/// What a figure of families leaves out, in words.
pub(super) fn left_out(scene: &Scene, rows: &[Row], kinds: usize) -> Option<String> {
    thinning(outer_sets(scene, rows).len(), most_sets(kinds), "values of the outer sweep")
}

/// "5 of 12 states are drawn", if not all are.
pub(super) fn thinning(all: usize, most: usize, what: &str) -> Option<String> {
    (all > most).then(|| format!("{most} of {all} {what} are drawn"))
}

/// Figures with a note.
pub(super) fn noted(mut figures: Vec<(String, Figure)>, note: Option<String>) -> Vec<(String, Figure)> {
    if let Some(note) = note {
        figures.iter_mut().for_each(|(_, figure)| figure.add_note(&note));
    }
    figures
}

/// The families of a table.
pub(super) fn families<'a>(scene: &Scene, rows: &'a [Row], kinds: &[Kind]) -> Vec<Family<'a>> {
    let outer = scene.sweeps.len().saturating_sub(1);
    let sets = thinned(outer_sets(scene, rows), most_sets(kinds.len()));
    let of = |kind: &Kind, set: &[f64]| -> Vec<&'a Row> {
        rows.iter().filter(|row| row.label(0) == kind.word && row.swept.get(..outer).unwrap_or(&[]) == set).collect()
    };
    let (mut families, mut indifferent_ones): (Vec<Family<'a>>, Vec<Family<'a>>) = (Vec::new(), Vec::new());
    for (index, set) in sets.iter().enumerate() {
        for (place, &kind) in kinds.iter().enumerate() {
            // A kind that does not feel the outer sweep is one curve, drawn once, without its parameters.
            let same = |other: &&[f64]| {
                let (first, second) = (of(&kind, set), of(&kind, other));
                first.len() == second.len() && first.iter().zip(&second).all(|(left, right)| left.values == right.values)
            };
            let indifferent = sets.len() > 1 && sets.iter().all(same);
            if indifferent && index > 0 {
                continue;
            }
            let rows = of(&kind, set);
            let parameters = if outer > 0 && !indifferent { swept_label(scene, set) } else { String::new() };
            let label = match (kinds.len() > 1, parameters.is_empty()) {
                (_, true) => kind.name.to_owned(),
                (true, false) => format!("{}, {parameters}", kind.name),
                (false, false) => parameters,
            };
            let colour = if indifferent {
                sets.len()
            } else if outer > 0 {
                index
            } else {
                place
            };
            // Values of an outer sweep are in order, and so are their colours.
            let shade = if outer > 0 && !indifferent { shade(index, sets.len()) } else { Colour::Index(colour) };
            let family = Family { label, kind, colour, shade, rows };
            if indifferent { indifferent_ones.push(family) } else { families.push(family) }
        }
    }
    // Drawn last, on top of the families.
    families.extend(indifferent_ones);
    families
}

/// `speed 1 mm/s, factor 2.5`.
pub(super) fn swept_label(scene: &Scene, values: &[f64]) -> String {
    scene
        .sweeps
        .iter()
        .zip(values)
        .map(|(sweep, &value)| {
            let (unit, size) = sweep.written.reached(value).map_or((sweep.unit.as_str(), 1.0), |unit| (&unit.name, unit.size));
            let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
            format!("{} {}{unit}", plain_name(&sweep.key), short(value / size))
        })
        .collect::<Vec<_>>()
        .join(", ")
}

/// Three digits, as `2.5` or `$3.2\cdot10^{-7}$`.
pub fn short(value: f64) -> String {
    if value == 0.0 || (1e-2..1e4).contains(&value.abs()) {
        let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
        return format!("{rounded}");
    }
    let text = format!("{value:.2e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa: f64 = mantissa.parse().unwrap_or(1.0);
    if (mantissa - 1.0).abs() < 1e-9 { format!("$10^{{{exponent}}}$") } else { format!("${mantissa}·10^{{{exponent}}}$") }
}

/// At most `most` items, evenly chosen, first and last kept.
pub(super) fn thinned<T: Clone>(items: Vec<T>, most: usize) -> Vec<T> {
    if items.len() <= most || most < 2 {
        return items.into_iter().take(most.max(1)).collect();
    }
    let last = items.len() - 1;
    (0..most).filter_map(|index| items.get(index * last / (most - 1)).cloned()).collect()
}
