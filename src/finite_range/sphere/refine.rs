//! Which elements are too long for a state, and which are needlessly short.

use std::sync::Arc;

use super::mesh::{Cell, GRADING, Mesh, Mesher};

/// A field that the mesh must resolve.
pub(super) struct Watched<'a> {
    pub(super) values: &'a [f64],
    /// An error that is allowed anywhere.
    pub(super) tolerance: f64,
    /// An error times the length of its element that is allowed: what is unresolved there moves the surface no more than that.
    pub(super) of_integral: f64,
    /// The same times the radius: what is unresolved there changes the force no more than that.
    pub(super) of_force: f64,
    /// The error that is allowed anywhere is allowed where it changes the force by no more than this.
    pub(super) of_wide_force: f64,
}

impl Watched<'_> {
    fn tolerance(&self, cell: Cell) -> f64 {
        let (length, radius) = (cell.length(), cell.interval().1);
        self.tolerance.min(self.of_wide_force / (radius * length)).max(self.of_integral.min(self.of_force / radius) / length)
    }
}

impl Mesher {
    /// Elements on which the last two Legendre coefficients of a field are too large.
    pub(super) fn unresolved(&self, mesh: &Mesh, fields: &[Watched]) -> Vec<bool> {
        let order = self.order();
        let flag = |(e, &cell): (usize, &Cell)| {
            fields.iter().any(|field| self.tail(&field.values[e * order..(e + 1) * order]) > field.tolerance(cell))
        };
        mesh.cells.iter().enumerate().map(flag).collect()
    }

    fn tail(&self, values: &[f64]) -> f64 {
        let rows = &self.quadrature.rule.last_coefficients;
        rows.iter().map(|row| row.iter().zip(values).map(|(r, v)| r * v).sum::<f64>().abs()).fold(0.0, f64::max)
    }

    /// Merges pairs of halves whose fields the parent reproduces; nothing if there is none.
    pub(super) fn merge(&mut self, mesh: &Mesh, fields: &[Watched]) -> Option<Arc<Mesh>> {
        let order = self.order();
        let (mut cells, mut i) = (Vec::with_capacity(mesh.cells.len()), 0);
        let all = &mesh.cells;
        while i < all.len() {
            let parent = all.get(i + 1).and_then(|&next| all[i].parent_with(next)).filter(|parent| {
                let before = cells.last().is_none_or(|cell: &Cell| parent.length() <= GRADING * cell.length());
                let after = all.get(i + 2).is_none_or(|cell| parent.length() <= GRADING * cell.length());
                let same = |field: &Watched| self.reproduces(&field.values[i * order..(i + 2) * order], field.tolerance(*parent));
                before && after && fields.iter().all(same)
            });
            cells.push(parent.unwrap_or(all[i]));
            i += if parent.is_some() { 2 } else { 1 };
        }
        (cells.len() < all.len()).then(|| self.build(cells))
    }

    /// Whether one polynomial through samples of two halves reproduces them, with room to spare.
    fn reproduces(&self, pair: &[f64], tolerance: f64) -> bool {
        let (order, rule) = (self.order(), &self.quadrature.rule);
        let (mut basis, mut parent) = (vec![0.0; order], vec![0.0; order]);
        let dot = |basis: &[f64], values: &[f64]| basis.iter().zip(values).map(|(b, v)| b * v).sum::<f64>();
        for (k, value) in parent.iter_mut().enumerate() {
            let (node, half) = if rule.nodes[k] < 0.0 { (2.0 * rule.nodes[k] + 1.0, 0) } else { (2.0 * rule.nodes[k] - 1.0, 1) };
            rule.basis(node, &mut basis);
            *value = dot(&basis, &pair[half * order..(half + 1) * order]);
        }
        if self.tail(&parent) > 0.3 * tolerance {
            return false;
        }
        (0..2 * order).all(|k| {
            let shift = if k < order { -0.5 } else { 0.5 };
            rule.basis(0.5 * rule.nodes[k % order] + shift, &mut basis);
            (dot(&basis, &parent) - pair[k]).abs() <= 0.1 * tolerance
        })
    }
}
