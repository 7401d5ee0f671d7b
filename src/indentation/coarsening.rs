//! Joining panels whose states one polynomial carries, so that a long history needs no more panels than its line has detail.

use super::line::{Cell, Contact, NARROWEST};
use super::panel::{POINTS, RULE};

impl Contact<'_> {
    /// Joins neighbouring panels wherever their union keeps every state to `tolerance` (m); never across the edge.
    pub(super) fn coarsened(&mut self, tolerance: f64) {
        let n = self.springs.terms();
        let size = POINTS * n;
        let mut cells: Vec<Cell> = Vec::with_capacity(self.cells.len());
        let mut values: Vec<f64> = Vec::with_capacity(self.values.len());
        let mut joined = Vec::with_capacity(size);
        for (index, cell) in self.cells.iter().enumerate() {
            let Some(own) = self.values.get(index * size..(index + 1) * size) else { return };
            let join = cells.last().is_some_and(|last: &Cell| {
                let separate = last.bonded != cell.bonded || (last.high - self.radius).abs() <= NARROWEST * self.radius;
                let start = values.len().saturating_sub(size);
                !separate && union((last, values.get(start..).unwrap_or(&[])), (cell, own), n, tolerance, &mut joined)
            });
            if join {
                let start = values.len() - size;
                values.truncate(start);
                values.extend_from_slice(&joined);
                if let Some(last) = cells.last_mut() {
                    last.high = cell.high;
                }
            } else {
                cells.push(*cell);
                values.extend_from_slice(own);
            }
        }
        (self.cells, self.values) = (cells, values);
    }
}

/// The states of two neighbours on one panel, if that keeps them.
fn union(first: (&Cell, &[f64]), second: (&Cell, &[f64]), n: usize, tolerance: f64, joined: &mut Vec<f64>) -> bool {
    let (left, right) = (first.0.low, second.0.high);
    joined.clear();
    for x in RULE.nodes {
        let s = left + (right - left) * x;
        let (cell, states) = if s < first.0.high { first } else { second };
        let factors = RULE.interpolation((s - cell.low) / (cell.high - cell.low));
        joined.extend((0..n).map(|j| (0..POINTS).map(|l| factors[l] * states[l * n + j]).sum::<f64>()));
    }
    [first, second].into_iter().all(|(cell, states)| {
        (0..POINTS).all(|g| {
            let factors = RULE.interpolation((cell.node(g) - left) / (right - left));
            (0..n).all(|j| {
                let value: f64 = (0..POINTS).map(|l| factors[l] * joined[l * n + j]).sum();
                (value - states[g * n + j]).abs() <= tolerance
            })
        })
    })
}
