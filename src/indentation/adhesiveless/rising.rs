//! A function that rises along the line from a place on, and how far and how much a level is above it: ∫(y − p)₊ ds.

use super::grid::{GRID, NODES, Nodal, dot};
use super::line::Line;

struct Piece {
    low: f64,
    /// Not low + width, which may be less by rounding.
    high: f64,
    width: f64,
    values: Nodal,
    /// ∫p ds up to it.
    before: f64,
}

/// p(s).
pub(super) struct Rising {
    start: f64,
    pieces: Vec<Piece>,
    /// ∫p ds over all pieces.
    whole: f64,
}

/// How far a level is above it.
#[derive(Clone, Copy)]
pub(super) struct Reached {
    pub(super) area: f64,
    pub(super) place: f64,
    /// Whether it is above the last piece too.
    pub(super) beyond: bool,
}

impl Rising {
    fn new(start: f64, stretches: impl Iterator<Item = (f64, f64, Nodal)>) -> Self {
        let mut rising = Self { start, pieces: Vec::new(), whole: 0.0 };
        for (low, high, values) in stretches {
            let width = high - low;
            rising.pieces.push(Piece { low, high, width, values, before: rising.whole });
            rising.whole += width * GRID.integral(&values);
        }
        rising
    }

    pub(super) fn first(&self) -> Option<f64> {
        self.pieces.first().map(|piece| piece.values[0])
    }

    pub(super) fn last(&self) -> Option<f64> {
        self.pieces.last().map(|piece| piece.values[NODES - 1])
    }

    pub(super) fn end(&self) -> f64 {
        self.pieces.last().map_or(self.start, |piece| piece.high)
    }

    /// The whole area between a level and all pieces, above or below.
    pub(super) fn under(&self, level: f64) -> f64 {
        level * (self.end() - self.start) - self.whole
    }

    pub(super) fn reached(&self, level: f64) -> Reached {
        if self.first().is_some_and(|first| level <= first) {
            return Reached { area: 0.0, place: self.start, beyond: false };
        }
        let Some(piece) = self.pieces.get(self.pieces.partition_point(|piece| piece.values[NODES - 1] < level)) else {
            return Reached { area: self.under(level), place: self.end(), beyond: true };
        };
        let xi = GRID.falling_zero(&piece.values.map(|value| level - value));
        let place = piece.low + piece.width * GRID.part(xi);
        let own = piece.width * GRID.integral_to(xi, &piece.values);
        Reached { area: level * (place - self.start) - (piece.before + own), place, beyond: false }
    }

    /// p at a place; none beyond the last piece.
    pub(super) fn value(&self, place: f64) -> Option<f64> {
        let piece = self.pieces.iter().find(|piece| place <= piece.high)?;
        Some(dot(&GRID.at(place - piece.low, piece.high - place), &piece.values))
    }

    /// Places between two at which pieces meet.
    pub(super) fn borders(&self, one: f64, other: f64) -> impl Iterator<Item = f64> {
        let (low, high) = (one.min(other), one.max(other));
        let clear = 1e-9 * high;
        let ends = self.pieces.iter().flat_map(|piece| [piece.low, piece.high]);
        ends.filter(move |place| *place > low + clear && *place < high - clear)
    }
}

impl Line<'_> {
    /// What κ = ΣE_i(all that Δ has done)/E∞* must exceed for a place in contact to press: E0/E∞*·f − ΣE_i/E∞* u_i e^{−t/ρ_i}.
    pub(super) fn holding(&self, kept: &[f64]) -> Rising {
        let soft = self.chain.relaxed / self.chain.glassy;
        let weights: Vec<f64> =
            self.chain.maxwell.iter().zip(kept).map(|((modulus, _), kept)| -modulus / self.chain.glassy * kept).collect();
        Rising::new(0.0, self.contact.iter().map(|stretch| (stretch.low, stretch.high, stretch.weighted(soft, &weights))))
    }

    /// What Δ must exceed for a free place to be touched: f + Σe_j e^{−t/τ_j}.
    pub(super) fn surfaces(&self, recovered: &[f64]) -> Rising {
        Rising::new(self.radius(), self.free.iter().map(|stretch| (stretch.low, stretch.high, stretch.weighted(1.0, recovered))))
    }
}
