//! The units in which people read the numbers of a run: those of the scene, or a prefix, on the screen and on the page. Files for programs keep SI.

use super::Outcome;
use viscotack::estimate::Estimate;

/// A unit, and its size in that of the files, for every column and every swept number; none: that of the files.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ShownUnits {
    /// Of columns.
    pub columns: Vec<Option<(String, f64)>>,
    /// Of swept numbers.
    pub swept: Vec<Option<(String, f64)>>,
}

impl ShownUnits {
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
