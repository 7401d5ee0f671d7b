//! The units in which people read the numbers of a run: those of the scene, or a prefix, on the screen and on the page. Files for programs keep SI.

use super::{Outcome, Row};
use crate::scene::written_units::{Spread, WrittenUnits};
use viscotack::estimate::Estimate;

/// A unit for every column and every swept number.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ShownUnits {
    columns: Vec<Option<(String, f64)>>,
    swept: Vec<Option<(String, f64)>>,
}

impl ShownUnits {
    /// Those that suit the rows of an outcome. A scene that writes plain numbers has SI.
    #[must_use]
    pub fn of(written: &WrittenUnits, outcome: &Outcome, rows: &[Row]) -> Self {
        let largest = |number: &dyn Fn(&Row) -> Option<f64>| {
            let numbers = rows.iter().filter(|row| row.status.has_values()).filter_map(number);
            numbers.filter(|number| number.is_finite()).fold(0.0, |most: f64, number| most.max(number.abs()))
        };
        let columns = outcome.columns.iter().enumerate();
        let columns = columns.map(|(index, column)| written.suiting(&column.unit, largest(&|row| row.value(index)), Spread::Even));
        let swept = outcome.swept.iter().enumerate();
        let swept = swept.map(|(place, swept)| written.suiting(&swept.unit, largest(&|row| row.swept.get(place).copied()), Spread::Even));
        Self { columns: columns.collect(), swept: swept.collect() }
    }

    fn shown<'o>(chosen: &'o [Option<(String, f64)>], place: usize, base: &'o str) -> (&'o str, f64) {
        match chosen.get(place) {
            Some(Some((unit, size))) => (unit, *size),
            _ => (base, 1.0),
        }
    }
}

impl Outcome {
    /// The unit in which a column is shown, with its size in that of the column.
    pub(super) fn unit(&self, column: usize) -> (&str, f64) {
        ShownUnits::shown(&self.shown_in.columns, column, self.columns.get(column).map_or("1", |column| &column.unit))
    }

    /// The unit in which a swept number is shown, with its size.
    pub(super) fn swept_unit(&self, place: usize) -> (&str, f64) {
        ShownUnits::shown(&self.shown_in.swept, place, self.swept.get(place).map_or("1", |swept| &swept.unit))
    }
}

/// A value and its error in a unit of another size.
pub(super) fn in_unit(estimate: Estimate, size: f64) -> Estimate {
    Estimate { value: estimate.value / size, error: estimate.error / size }
}
