//! Bounds that do not trust one instant: where the errors of two runs cross, their difference is small by chance.

use super::super::rows::Values;
use super::columns::at;

/// A bound is at least this part of the largest one of its column.
const FLOOR: f64 = 0.05;
/// Columns that are found, not imposed or derived from others.
const FOUND: [usize; 8] = [
    at::PENETRATION,
    at::FORCE,
    at::CONTACT_RADIUS,
    at::STORED_ENERGY,
    at::INTERFACE_ENERGY,
    at::EXTERNAL_WORK,
    at::DISSIPATED_ENERGY,
    at::RELEASED_ENERGY,
];

/// The least bound of every column.
pub(super) struct Floors([f64; FOUND.len()]);

fn error(values: &Values, place: usize) -> f64 {
    values.get(place).copied().flatten().map_or(0.0, |value| value.error)
}

impl Floors {
    /// Of the instants of a history.
    pub(super) fn of(instants: &[Values]) -> Self {
        Self(FOUND.map(|place| FLOOR * instants.iter().map(|values| error(values, place)).fold(0.0, f64::max)))
    }

    /// The least bound of a column.
    pub(super) fn at(&self, place: usize) -> f64 {
        FOUND.iter().position(|found| *found == place).and_then(|index| self.0.get(index)).copied().unwrap_or(0.0)
    }

    /// Widens the bounds of a row to them.
    pub(super) fn raise(&self, values: &mut Values) {
        for (place, floor) in FOUND.into_iter().zip(self.0) {
            if let Some(Some(value)) = values.get_mut(place) {
                value.error = value.error.max(floor);
            }
        }
    }
}

/// Extremes of cycles, and the column of instants that each is of.
pub(super) const EXTREMES: [(usize, usize); 6] = [
    (at::SMALLEST_PENETRATION, at::PENETRATION),
    (at::LARGEST_PENETRATION, at::PENETRATION),
    (at::SMALLEST_FORCE, at::FORCE),
    (at::LARGEST_FORCE, at::FORCE),
    (at::SMALLEST_CONTACT_RADIUS, at::CONTACT_RADIUS),
    (at::LARGEST_CONTACT_RADIUS, at::CONTACT_RADIUS),
];

impl Floors {
    /// Widens the bounds of the extremes of a cycle to those of the instants.
    pub(super) fn raise_extremes(&self, values: &mut Values) {
        for (extreme, place) in EXTREMES {
            if let Some(Some(value)) = values.get_mut(extreme) {
                value.error = value.error.max(self.at(place));
            }
        }
    }
}

/// Instants, each with bounds at least as wide as those of the instants beside it.
pub(super) fn widened(instants: &[Values]) -> Vec<Values> {
    let beside = |index: usize, place: usize| {
        let near = [index.checked_sub(1), Some(index), index.checked_add(1)];
        near.into_iter().flatten().filter_map(|index| instants.get(index)).map(|values| error(values, place)).fold(0.0, f64::max)
    };
    let mut all = instants.to_vec();
    for (index, values) in all.iter_mut().enumerate() {
        for place in FOUND {
            if let Some(Some(value)) = values.get_mut(place) {
                value.error = value.error.max(beside(index, place));
            }
        }
    }
    all
}
