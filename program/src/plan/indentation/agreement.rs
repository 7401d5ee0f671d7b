//! A measured force beside the computed one: how far they are from each other, and the plot of that.

use super::rows::INSTANT;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::outcome::{Column, Row};
use viscotack::estimate::Estimate;

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
        let deviates = Estimate::new(computed.value - measured.value, computed.error);
        if here.is_some() {
            pairs.push((deviates, measured.value));
        }
        put(row, deviation, Some(deviates));
    }
    let Some(answer) = rows.first_mut() else { return };
    let count = pairs.len() as f64;
    let mean = pairs.iter().map(|(_, measured)| measured).sum::<f64>() / count;
    let root_mean_square = |of: &dyn Fn(&(Estimate, f64)) -> f64| (pairs.iter().map(|pair| of(pair).powi(2)).sum::<f64>() / count).sqrt();
    // The root of a mean square is a norm: errors change it by their own at most.
    let (rms, error) = (root_mean_square(&|(deviates, _)| deviates.value), root_mean_square(&|(deviates, _)| deviates.error));
    let spread = root_mean_square(&|(_, measured)| measured - mean);
    let determination = Estimate::new(1.0 - (rms / spread).powi(2), error * (2.0 * rms + error) / (spread * spread));
    if let Some(place) = place("rms_deviation") {
        put(answer, place, (count > 0.0).then_some(Estimate::new(rms, error)));
    }
    if let Some(place) = place("coefficient_of_determination") {
        put(answer, place, (spread > 0.0 && determination.value.is_finite()).then_some(determination));
    }
}

fn put(row: &mut Row, place: usize, value: Option<Estimate>) {
    if let Some(cell) = row.values.get_mut(place) {
        *cell = value;
    }
}

/// The measured forces of one state as marks, over a quantity; none without any.
pub(super) fn marks<'r>(rows: impl Iterator<Item = &'r Row>, [horizontal, measured]: [usize; 2]) -> Option<Curve> {
    let points = points(rows, [horizontal, measured]);
    (!points.is_empty()).then(|| Curve::new("measured", points).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(1))
}

/// The deviations of one state over a quantity, with a line where there is none; no figure without any.
pub(super) fn figure<'r>(rows: impl Iterator<Item = &'r Row>, places: [usize; 2], horizontal: Axis, vertical: Axis) -> Option<Figure> {
    let points = points(rows, places);
    let (first, last) = (points.first()?.0, points.last()?.0);
    let none = Curve::new("", vec![(first, 0.0), (last, 0.0)]).with_line(Line::Dotted).with_colour(2);
    let deviations = Curve::new("", points).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(1);
    Some(Figure::new(horizontal, vertical).with_curve(none).with_curve(deviations))
}

fn points<'r>(rows: impl Iterator<Item = &'r Row>, [horizontal, vertical]: [usize; 2]) -> Vec<(f64, f64)> {
    let instants = rows.filter(|row| row.label(0) == INSTANT);
    instants.filter_map(|row| Some((row.value(horizontal)?, row.value(vertical)?))).collect()
}
