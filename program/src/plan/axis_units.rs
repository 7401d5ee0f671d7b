//! Axes of plots, and numbers on the screen, in the units that a scene writes.
//!
//! A label ends with the SI unit of its numbers, as in `contact radius $a$ (m)`. The axis takes a unit of the scene for the same dimension: of
//! several the largest that its numbers reach. A linear axis whose numbers suit no unit of the scene takes a prefix. A scene that writes plain numbers keeps SI.

use crate::outcome::plot::{Axis, Figure, Scale};
use crate::outcome::shown_units::ShownUnits;
use crate::outcome::{Outcome, Row};
use crate::scene::written_units::{Spread, WrittenUnits};

/// Changes the axes of a figure, and its numbers with them.
pub(super) fn put_on(units: &WrittenUnits, figure: &mut Figure) {
    if units.is_empty() {
        return;
    }
    let inset = figure.inset.as_deref_mut();
    let map = figure.map.as_mut();
    let across = map.iter().flat_map(|map| &map.across).copied();
    let up = map.iter().flat_map(|map| &map.up).copied();
    let points = || figure.curves.iter().flat_map(|curve| &curve.points);
    let horizontal = relabelled(units, &mut figure.horizontal, points().map(|point| point.0).chain(across));
    let vertical = relabelled(units, &mut figure.vertical, points().map(|point| point.1).chain(up));
    for point in figure.curves.iter_mut().flat_map(|curve| &mut curve.points) {
        *point = (point.0 / horizontal, point.1 / vertical);
    }
    figure.curves.iter_mut().flat_map(|curve| &mut curve.band).for_each(|half| *half /= vertical);
    if let Some(map) = map {
        let colours = relabelled(units, &mut map.colours, map.values.iter().copied());
        map.across.iter_mut().for_each(|place| *place /= horizontal);
        map.up.iter_mut().for_each(|place| *place /= vertical);
        map.values.iter_mut().for_each(|value| *value /= colours);
    }
    if let Some(residuals) = figure.residuals.as_deref_mut() {
        let vertical = relabelled(units, &mut residuals.vertical, residuals.points.iter().map(|point| point.1));
        residuals.points.iter_mut().for_each(|point| *point = (point.0 / horizontal, point.1 / vertical));
        residuals.root_mean_square = residuals.root_mean_square.map(|root| root / vertical);
    }
    if let Some(inset) = inset {
        let horizontal = relabelled(units, &mut inset.horizontal, inset.curves.iter().flat_map(|curve| &curve.points).map(|point| point.0));
        let vertical = relabelled(units, &mut inset.vertical, inset.curves.iter().flat_map(|curve| &curve.points).map(|point| point.1));
        for point in inset.curves.iter_mut().flat_map(|curve| &mut curve.points) {
            *point = (point.0 / horizontal, point.1 / vertical);
        }
    }
}

/// Relabels an axis with a unit that suits its numbers; its size in the unit before.
fn relabelled(units: &WrittenUnits, axis: &mut Axis, numbers: impl Iterator<Item = f64>) -> f64 {
    let largest = axis.range.map_or_else(
        || numbers.filter(|number| number.is_finite()).fold(0.0, |most: f64, number| most.max(number.abs())),
        |(lower, upper)| lower.abs().max(upper.abs()),
    );
    let Some((words, base)) = axis.label.strip_suffix(')').and_then(|label| label.rsplit_once('(')) else { return 1.0 };
    let spread = if axis.scale == Scale::Logarithmic { Spread::Decades } else { Spread::Even };
    let Some((unit, size)) = units.suiting(base, largest, spread) else { return 1.0 };
    axis.label = format!("{words}({unit})");
    axis.range = axis.range.map(|(lower, upper)| (lower / size, upper / size));
    size
}

/// The units that suit the rows of an outcome on the screen. A scene that writes plain numbers has SI.
pub(super) fn shown_in(units: &WrittenUnits, outcome: &Outcome, rows: &[Row]) -> ShownUnits {
    let largest = |number: &dyn Fn(&Row) -> Option<f64>| {
        let numbers = rows.iter().filter(|row| row.status.has_values()).filter_map(number);
        numbers.filter(|number| number.is_finite()).fold(0.0, |most: f64, number| most.max(number.abs()))
    };
    let columns = outcome.columns.iter().enumerate();
    let columns = columns.map(|(index, column)| units.suiting(&column.unit, largest(&|row| row.value(index)), Spread::Even));
    let swept = outcome.swept.iter().enumerate();
    let swept = swept.map(|(place, swept)| units.suiting(&swept.unit, largest(&|row| row.swept.get(place).copied()), Spread::Even));
    ShownUnits { columns: columns.collect(), swept: swept.collect() }
}
