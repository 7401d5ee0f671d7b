//! Plots of a fit: each curve with its data, and below them what is left between both.

use super::carry_out::{Fit, GroupOf};
use super::compare::Comparison;
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line, Marker, Residuals};
use crate::plan::axis_units::put_on;
use crate::scene::written_units::WrittenUnits;

/// Of measured points.
const COLOUR: Colour = Colour::Index(1);
/// An axis of places above zero that span more than this factor is logarithmic.
const WIDE: f64 = 30.0;
/// Of logarithms, which are compared where errors are relative.
const PER_CENT: f64 = 100.0;

impl Fit {
    /// Plots by file stem: for each column of each test the data with the model, and the residuals.
    #[must_use]
    pub fn figures(&self) -> Vec<(String, Figure)> {
        let units = WrittenUnits::of(&self.setup.document.root);
        self.groups
            .iter()
            .enumerate()
            .filter_map(|(place, group)| {
                let test = self.setup.tests.get(group.test)?;
                let column = test.columns.get(group.column?)?;
                let mut figure = self.figure(place, group, test)?;
                put_on(&units, &mut figure);
                Some((format!("fit_{}_{}", column.word, group.test + 1), figure))
            })
            .collect()
    }

    fn figure(&self, place: usize, group: &GroupOf, test: &Comparison) -> Option<Figure> {
        let column = test.columns.get(group.column?)?;
        let model = self.fitted.model.get(group.places.clone())?;
        let quality = self.fitted.quality.get(place)?;
        let rows: Vec<(f64, f64, f64)> = test
            .rows
            .iter()
            .zip(model)
            .filter_map(|(row, model)| Some((*test.abscissa.get(*row)?, *column.values.get(*row)?, *model)))
            .collect();
        let marker = Marker::of_measured(rows.len());
        let labelled = |word: &str, unit: &str| {
            let words = word.replace('_', " ");
            if unit.is_empty() || unit == "1" { words } else { format!("{words} ({unit})") }
        };
        let (low, high) = test.range();
        let across = labelled(&test.against, &test.unit);
        let across = if low > 0.0 && high > WIDE * low { Axis::logarithmic(across) } else { Axis::linear(across) };
        let up = labelled(&column.word, &column.unit);
        let up = if test.relative { Axis::logarithmic(up) } else { Axis::linear(up) };
        let in_values = |model: f64| if test.relative { model.exp() } else { model };
        let (unit, size) = if test.relative { ("%", PER_CENT) } else { (column.unit.as_str(), 1.0) };
        let left = |value: f64, model: f64| size * (model - if test.relative { value.ln() } else { value });
        let data = rows.iter().map(|(place, value, _)| (*place, *value)).collect();
        let line = rows.iter().map(|(place, _, model)| (*place, in_values(*model))).collect();
        Some(
            Figure::new(across, up)
                .with_curve(Curve::new("measured", data).with_line(Line::None).with_marker(marker).with(COLOUR))
                .with_curve(Curve::new("fit", line).with_line(Line::Solid).with_colour(0))
                .with_residuals(Residuals {
                    vertical: Axis::linear(labelled("residual", unit)),
                    points: rows.iter().map(|(place, value, model)| (*place, left(*value, *model))).collect(),
                    marker,
                    colour: COLOUR,
                    root_mean_square: Some(size * quality.root_mean_square),
                    determination: quality.determination,
                }),
        )
    }
}
