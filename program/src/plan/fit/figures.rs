//! Plots of a fit: each curve with its data, and its residuals.

use super::carry_out::Fit;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};

impl Fit {
    /// Plots by file stem: for each column of each test the data with the model, and the residuals over the noise.
    #[must_use]
    pub fn figures(&self) -> Vec<(String, Figure)> {
        let mut found = Vec::new();
        for (group, sigma) in self.groups.iter().zip(&self.fitted.sigmas) {
            let Some(test) = self.setup.tests.get(group.test) else { continue };
            let Some(column) = group.column.and_then(|column| test.columns.get(column)) else { continue };
            let model = self.fitted.model.get(group.places.clone()).unwrap_or(&[]);
            let place = |row: &usize| test.abscissa.get(*row).copied().unwrap_or(f64::NAN);
            let value = |row: &usize| column.values.get(*row).copied().unwrap_or(f64::NAN);
            let axis = |label: String| if test.relative { Axis::logarithmic(label) } else { Axis::linear(label) };
            let wide = {
                let (low, high) = test.range();
                low > 0.0 && high > 30.0 * low
            };
            let across = || {
                let label = test.against.replace('_', " ");
                if wide { Axis::logarithmic(label) } else { Axis::linear(label) }
            };
            let in_values = |model: f64| if test.relative { model.exp() } else { model };
            let data: Vec<(f64, f64)> = test.rows.iter().map(|row| (place(row), value(row))).collect();
            let line: Vec<(f64, f64)> = test.rows.iter().zip(model).map(|(row, model)| (place(row), in_values(*model))).collect();
            let left: Vec<(f64, f64)> = test
                .rows
                .iter()
                .zip(model)
                .map(|(row, model)| (place(row), (model - if test.relative { value(row).ln() } else { value(row) }) / sigma))
                .collect();
            let stem = format!("{}_{}", column.word, group.test + 1);
            let data = Curve::new("data", data).with_line(Line::None).with_marker(Marker::Circle);
            found.push((
                format!("fit_{stem}"),
                Figure::new(across(), axis(column.word.replace('_', " ")))
                    .with_curve(data)
                    .with_curve(Curve::new("fit", line).with_line(Line::Solid)),
            ));
            let zero = {
                let (low, high) = test.range();
                Curve::new("", vec![(low, 0.0), (high, 0.0)]).with_line(Line::Solid)
            };
            let residuals = Curve::new("residuals over noise", left).with_line(Line::None).with_marker(Marker::Circle);
            found.push((
                format!("residuals_{stem}"),
                Figure::new(across(), Axis::linear("(model − data)/noise")).with_curve(zero).with_curve(residuals),
            ));
        }
        found
    }
}
