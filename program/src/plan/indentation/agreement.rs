//! A measured force beside the computed one: how far they are from each other, and both in a plot.

use super::rows::INSTANT;
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line, Marker, Residuals};
use crate::outcome::{Column, Row};
use crate::scene::typed::Units;
use viscotack::estimate::Estimate;

/// What differences and sums of numbers are rounded by, relative.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Of measured points.
const COLOUR: Colour = Colour::Index(1);

/// Of the columns.
pub(super) const DEVIATION: &str = "The computed force less the measured one.";
pub(super) const RMS: &str = "Root of the mean square of the deviations from the measured force, over the instants that have one.";
pub(super) const DETERMINATION: &str = "One less the sum of squared deviations over that of the measured forces from their mean: 1 where both curves are one, negative where the mean fits better.";

/// Fills the columns of deviations in the rows of a state, the answer first: the bound of a deviation is that of the force.
pub(super) fn put_into(rows: &mut [Row], columns: &[Column]) {
    let place = |name: &str| columns.iter().position(|column| column.name == name);
    let time = place("time");
    let (Some(force), Some(measured), Some(deviation)) = (place("force"), place("measured_force"), place("force_deviation")) else {
        return;
    };
    let instants = rows.iter().map(|row| (row.label(0) == INSTANT).then(|| time.and_then(|time| row.value(time)))).collect::<Vec<_>>();
    let mut pairs = Vec::new();
    for (index, row) in rows.iter_mut().enumerate() {
        let of = |place: usize| row.values.get(place).copied().flatten();
        let (Some(computed), Some(measured)) = (of(force), of(measured)) else { continue };
        // Before and after a sudden start there are two instants of one time: the table is of the second.
        let here = instants.get(index).copied().flatten();
        if here.is_some() && instants.get(index + 1).copied().flatten() == here {
            continue;
        }
        let rounding = ROUNDING * (computed.value.abs() + measured.value.abs());
        let deviates = Estimate::new(computed.value - measured.value, computed.error + rounding);
        if here.is_some() {
            pairs.push((deviates, measured.value));
        }
        put(row, deviation, Some(deviates));
    }
    let Some(answer) = rows.first_mut() else { return };
    let Some((root, determination)) = measures(&pairs) else { return };
    if let Some(place) = place("rms_deviation") {
        put(answer, place, Some(root));
    }
    if let Some(place) = place("coefficient_of_determination") {
        put(answer, place, determination);
    }
}

/// Root mean square and coefficient of determination of deviations, each with the measured force that it is from; none of none.
fn measures(pairs: &[(Estimate, f64)]) -> Option<(Estimate, Option<Estimate>)> {
    if pairs.is_empty() {
        return None;
    }
    let mean = pairs.iter().map(|(_, measured)| measured / pairs.len() as f64).sum::<f64>();
    let root_mean_square = |of: &dyn Fn(&(Estimate, f64)) -> f64| root_mean_square(&pairs.iter().map(of).collect::<Vec<_>>());
    // The root of a mean square is a norm: errors change it by their own at most.
    let (rms, error) = (root_mean_square(&|(deviates, _)| deviates.value), root_mean_square(&|(deviates, _)| deviates.error));
    let spread = root_mean_square(&|(_, measured)| measured - mean);
    let determination = Estimate::new(1.0 - (rms / spread).powi(2), error / spread * ((2.0 * rms + error) / spread) + ROUNDING);
    let finite = spread > 0.0 && determination.value.is_finite() && determination.error.is_finite();
    Some((Estimate::new(rms, error), finite.then_some(determination)))
}

/// Over the largest of them, whose square may be no number.
fn root_mean_square(values: &[f64]) -> f64 {
    let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    largest * (values.iter().map(|value| (value / largest).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

fn put(row: &mut Row, place: usize, value: Option<Estimate>) {
    if let Some(cell) = row.values.get_mut(place) {
        *cell = value;
    }
}

/// Puts the measured forces of one state on a figure as marks, over a quantity, and below the curves what is left between both forces.
pub(super) fn put_on(mut figure: Figure, rows: &[&Row], [horizontal, measured, deviation]: [usize; 3], units: Units) -> Figure {
    let instants = || rows.iter().filter(|row| row.label(0) == INSTANT);
    let marks: Vec<(f64, f64)> = instants().filter_map(|row| Some((row.value(horizontal)?, row.value(measured)?))).collect();
    let left: Vec<(f64, Estimate, f64)> = instants()
        .filter_map(|row| Some((row.value(horizontal)?, row.values.get(deviation).copied().flatten()?, row.value(measured)?)))
        .collect();
    let pairs: Vec<(Estimate, f64)> = left.iter().map(|(_, deviates, measured)| (*deviates, *measured)).collect();
    let Some((root, determination)) = measures(&pairs) else { return figure };
    let marker = Marker::of_measured(marks.len());
    // Below the computed curves, which many points would hide.
    figure.curves.insert(0, Curve::new("measured", marks).with_line(Line::None).with_marker(marker).with(COLOUR));
    figure.with_residuals(Residuals {
        vertical: Axis::linear(if units == Units::Si { "residual (N)" } else { "residual" }),
        points: left.into_iter().map(|(place, deviates, _)| (place, deviates.value)).collect(),
        marker,
        colour: COLOUR,
        root_mean_square: Some(root.value),
        determination: determination.map(|part| part.value),
    })
}

#[cfg(test)]
mod tests {
    use super::root_mean_square;

    #[test]
    fn a_root_mean_square_needs_no_squares_that_are_numbers() {
        for unit in [1.0, 1e-200, 1e200] {
            let found = root_mean_square(&[3.0 * unit, -4.0 * unit]) / unit;
            assert!((found - 12.5_f64.sqrt()).abs() < 1e-14, "{found}");
        }
        assert!(root_mean_square(&[0.0, 0.0]).abs() < f64::MIN_POSITIVE && root_mean_square(&[]).abs() < f64::MIN_POSITIVE);
    }
}
