//! The works of both edges of a half-width as quadratic forms of their amplitudes.
//!
//! ```text
//! û = (S²c, SC s, p)      S, C = sin, cos(a/2)      σ̂, Δ̂ = (trailing ± leading amplitude)/C,  lines in û      n̂ = σ̂ × Δ̂ without its part along p
//! work_i/2πΓ_i = vᵀÃ_i v     v = (σ̂, Δ̂, n̂)û
//! ```
//! A work is nearly the square of the amplitude of its edge, which is small between large parts; seen from the amplitudes nothing cancels.

use super::forms::{Direction, Form, Line, direction};
use crate::sliding::contact::Indenter;

/// Three rows of three.
pub(super) type Square = [[f64; 3]; 3];

/// Both works over 2πΓ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Works {
    /// v of (c, s, p).
    rows: Square,
    /// Ã.
    pub(super) forms: [Form; 2],
}

impl Works {
    /// From the lines of both amplitudes in û, and the forms seen from them.
    pub(super) fn new(indenter: Indenter, place: f64, [sum, difference]: [Line; 2], forms: [Form; 2]) -> Self {
        let (scales, _) = scales(indenter, place);
        let rows = [sum, difference, third(&sum, &difference)].map(|row| std::array::from_fn(|column| row[column] * scales[column]));
        Self { rows, forms }
    }

    /// The work of an edge over 2πΓ.
    pub(super) fn work(&self, edge: usize, at: Direction, pressure: f64) -> f64 {
        self.forms.get(edge).map_or(f64::NAN, |form| of_form(form, self.seen(at, pressure)))
    }

    /// ∂/∂e and ∂/∂p̄ of it.
    pub(super) fn slopes(&self, edge: usize, indenter: Indenter, eccentricity: f64, pressure: f64) -> [f64; 2] {
        let at = direction(indenter, eccentricity);
        let (turned, v) = (if indenter == Indenter::Wave { (-at.1, at.0) } else { (0.0, 1.0) }, self.seen(at, pressure));
        let Some([a, b, c, d, e, f]) = self.forms.get(edge) else { return [f64::NAN; 2] };
        let gradient = [2.0 * a * v[0] + d * v[1] + e * v[2], 2.0 * b * v[1] + d * v[0] + f * v[2], 2.0 * c * v[2] + e * v[0] + f * v[1]];
        let along = |change: Line| -> f64 { gradient.iter().zip(change).map(|(slope, change)| slope * change).sum() };
        [along(self.rows.map(|[c, s, _]| c * turned.0 + s * turned.1)), along(self.rows.map(|[.., p]| p))]
    }

    /// v of a contact.
    fn seen(&self, (c, s): Direction, p: f64) -> Line {
        self.rows.map(|row| row[0] * c + row[1] * s + row[2] * p)
    }

    /// c² + s² of a wave, c² of a parabola, as a form of v; and (c, s, p) of the three directions of v.
    pub(super) fn unit(&self, indenter: Indenter) -> (Form, Square) {
        let columns = reciprocal(&self.rows);
        let second = if indenter == Indenter::Wave { 1.0 } else { 0.0 };
        let entry = |one: usize, other: usize| columns[one][0] * columns[other][0] + second * columns[one][1] * columns[other][1];
        ([entry(0, 0), entry(1, 1), entry(2, 2), 2.0 * entry(0, 1), 2.0 * entry(0, 2), 2.0 * entry(1, 2)], columns)
    }
}

/// The directions in (c, s, p) along which one part of v is one and the others vanish, of the lines of both amplitudes in û.
pub(super) fn directions(indenter: Indenter, place: f64, lines: [Line; 2]) -> Square {
    reciprocal(&Works::new(indenter, place, lines, [[0.0; 6]; 2]).rows)
}

fn reciprocal(rows: &Square) -> Square {
    let [first, second, third] = rows;
    let columns = [crossed(second, third), crossed(third, first), crossed(first, second)];
    let size: f64 = first.iter().zip(columns[0]).map(|(one, other)| one * other).sum();
    columns.map(|column| column.map(|part| part / size))
}

/// The value of a form of three unknowns: squares first, then products of the first and second, first and third, second and third.
pub(super) fn of_form([a, b, c, d, e, f]: &Form, [x, y, z]: Line) -> f64 {
    a * x * x + b * y * y + c * z * z + d * x * y + e * x * z + f * y * z
}

/// (S², SC, 1) and C of a wave; of a parabola (a²/4, a/2, 1) and 1.
pub(super) fn scales(indenter: Indenter, place: f64) -> (Line, f64) {
    match indenter {
        Indenter::Wave => {
            let cosine = 1.0 / place.exp().hypot(1.0);
            let sine = 1.0 / (-place).exp().hypot(1.0);
            ([sine * sine, sine * cosine, 1.0], cosine)
        }
        Indenter::Parabola => ([(2.0 * place).exp(), place.exp(), 1.0], 1.0),
    }
}

/// Sum and difference of the amplitudes of both edges, in û.
pub(super) fn even_and_odd(indenter: Indenter, place: f64, trailing: &Line, leading: &Line) -> [Line; 2] {
    let (scales, cosine) = scales(indenter, place);
    [1.0, -1.0].map(|sign| std::array::from_fn(|column| (trailing[column] + sign * leading[column]) / (scales[column] * cosine)))
}

/// The line that is seen beside both amplitudes: the profile alone, so that it is distinguished from a pull that is far larger.
pub(super) fn third(sum: &Line, difference: &Line) -> Line {
    let [first, second, _] = crossed(sum, difference);
    [first, second, 0.0]
}

fn crossed(first: &Line, second: &Line) -> Line {
    std::array::from_fn(|index| {
        let (next, last) = ((index + 1) % 3, (index + 2) % 3);
        first[next] * second[last] - first[last] * second[next]
    })
}
