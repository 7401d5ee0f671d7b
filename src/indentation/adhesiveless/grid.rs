//! Places of an interval of the line, and what they tell between them.
//!
//! Where the edge turned, states go with the root of the distance, on one side or on both. Along an interval s = low + width·sin²(θ/2), so that a root at
//! either end is smooth in θ, and a Chebyshev series in θ keeps it to rounding: cos 2θ, of a parabola, leaves 2J_n(π), 1e-11 for 17 places and 5e-16 for 21.

use crate::special::gauss_legendre::UNIT_RULE_20;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::LazyLock;

/// Places of an interval, both ends among them.
pub(super) const NODES: usize = 21;
/// Coefficients whose size tells whether a series has ended.
const TAIL: usize = 3;

/// Steps to a zero.
const MOST_STEPS: u32 = 100;
/// A distance from a place, over that to the next one, which a slope stays away.
const NEXT_TO: f64 = 1e-6;

/// A number for each place.
pub(super) type Nodal = [f64; NODES];

pub(super) struct Grid {
    /// sin²(θ/2), and ξ = 2θ/π − 1.
    pub(super) parts: Nodal,
    xi: Nodal,
    /// ∫ds over the width, and from its low end to each place.
    pub(super) weights: Nodal,
    running: [Nodal; NODES],
    /// From values to the last coefficients of the series.
    tail: [Nodal; TAIL],
}

pub(super) static GRID: LazyLock<Grid> = LazyLock::new(Grid::new);

impl Grid {
    fn new() -> Self {
        let last = NODES - 1;
        let angle = |k: usize| PI * k as f64 / last as f64;
        let xi: Nodal = std::array::from_fn(|k| if 2 * k == last { 0.0 } else { -angle(k).cos() });
        let parts: Nodal = std::array::from_fn(|k| match k {
            0 => 0.0,
            k if k == last => 1.0,
            k => (0.25 * PI * (1.0 + xi[k])).sin().powi(2),
        });
        let mut running = [[0.0; NODES]; NODES];
        for k in 1..NODES {
            running[k] = running[k - 1];
            let gap = xi[k] - xi[k - 1];
            for &(node, weight) in UNIT_RULE_20.iter() {
                let place = xi[k - 1] + gap * node;
                let rise = 0.25 * PI * (FRAC_PI_2 * (1.0 + place)).sin() * gap * weight;
                for (sum, value) in running[k].iter_mut().zip(basis(&xi, place)) {
                    *sum += rise * value;
                }
            }
        }
        let weights = running[last];
        let tail = std::array::from_fn(|row| {
            let order = last - row;
            std::array::from_fn(|k| {
                let end = |k: usize| if k == 0 || k == last { 0.5 } else { 1.0 };
                // ξ_k = −cos(angle): T_m(ξ_k) = (−1)^m cos(m·angle).
                let sign = if order.is_multiple_of(2) { 1.0 } else { -1.0 };
                sign * 2.0 / last as f64 * end(k) * end(order) * (order as f64 * angle(k)).cos()
            })
        });
        Self { parts, xi, weights, running, tail }
    }

    /// What each place weighs in the value at a distance from the low end and one from the high end.
    pub(super) fn at(&self, from_low: f64, from_high: f64) -> Nodal {
        let theta = 2.0 * from_low.max(0.0).sqrt().atan2(from_high.max(0.0).sqrt());
        basis(&self.xi, (theta / FRAC_PI_2 - 1.0).clamp(-1.0, 1.0))
    }

    /// ξ where falling values are zero: they are ≥ 0 at the first place and < 0 at the last.
    pub(super) fn falling_zero(&self, values: &Nodal) -> f64 {
        self.falling_zero_near(values, None, f64::EPSILON)
    }

    /// The same by Newton's steps within a bracket, from a guess, to such a step.
    pub(super) fn falling_zero_near(&self, values: &Nodal, guess: Option<f64>, settled: f64) -> f64 {
        let next = values.iter().position(|value| *value < 0.0).unwrap_or(NODES - 1).max(1);
        let (mut low, mut high) = (self.xi[next - 1], self.xi[next]);
        let (above, below) = (values[next - 1], values[next]);
        let rounding = 0.25 * f64::EPSILON * values[0].abs().max(values[NODES - 1].abs());
        if above <= rounding {
            return low;
        }
        let (gap, ends) = (high - low, [low, high]);
        let chord = low + gap * (above / (above - below));
        let mut place = guess.filter(|place| *place > low && *place < high).unwrap_or(chord);
        let mut last = None;
        for _ in 0..MOST_STEPS {
            if place <= low || place >= high {
                // A chord may end at a place itself.
                place = 0.5 * (low + high);
            }
            if place <= low || place >= high {
                return low;
            }
            // Next to a place the slope is a quotient of roundings.
            let inner = place.clamp(ends[0] + NEXT_TO * gap, ends[1] - NEXT_TO * gap);
            let (there, slope) = self.value_and_slope(inner, values);
            let value = if inner.total_cmp(&place).is_eq() { there } else { dot(&basis(&self.xi, place), values) };
            if value.abs() <= rounding {
                return place;
            }
            if value > 0.0 {
                low = place
            } else {
                high = place
            }
            let newton = place - value / slope;
            let step = (newton - place).abs();
            // Where Newton's steps do not halve, the bracket is.
            if newton > low && newton < high && step <= 0.5 * last.unwrap_or(gap) {
                // What its next step would be: each goes with the square of the one before, over the distance to the next place or to an end, where values go with
                // the square of theirs.
                let room = gap.min(1.0 - newton.abs());
                let next = last.map_or(10.0 * step * step / room, |last| step * (step / last).powi(2));
                if next <= settled {
                    return newton;
                }
                (place, last) = (newton, Some(step));
            } else {
                place = 0.5 * (low + high);
                last = None;
            }
        }
        place
    }

    /// The interpolant and its slope at a ξ between places.
    fn value_and_slope(&self, place: f64, values: &Nodal) -> (f64, f64) {
        let over: Nodal = std::array::from_fn(|k| (place - self.xi[k]).recip());
        let weights: Nodal = std::array::from_fn(|k| BARYCENTRIC[k] * over[k]);
        let whole = dot(&weights, &[1.0; NODES]).recip();
        let value = dot(&weights, values) * whole;
        let steeper: Nodal = std::array::from_fn(|k| over[k] * (value - values[k]));
        (value, dot(&weights, &steeper) * whole)
    }

    /// The distance from the low end over the width.
    pub(super) fn part(&self, xi: f64) -> f64 {
        (0.25 * PI * (1.0 + xi)).sin().powi(2)
    }

    /// ∫ of values over the width from the low end to each place.
    pub(super) fn running(&self, values: &Nodal) -> Nodal {
        self.running.map(|row| dot(&row, values))
    }

    /// ∫ of values over the width from the low end on.
    pub(super) fn integral_to(&self, xi: f64, values: &Nodal) -> f64 {
        self.value(xi, &self.running(values))
    }

    /// The interpolant at a ξ.
    pub(super) fn value(&self, xi: f64, values: &Nodal) -> f64 {
        dot(&basis(&self.xi, xi), values)
    }

    /// What gives the last coefficients of a series.
    pub(super) fn last_coefficients(&self) -> impl Iterator<Item = &Nodal> {
        self.tail.iter()
    }

    /// The size of the last coefficients of a series.
    pub(super) fn tail(&self, values: &Nodal) -> f64 {
        self.tail.iter().fold(0.0, |most: f64, row| most.max(dot(row, values).abs()))
    }

    /// ∫ of values over the width.
    pub(super) fn integral(&self, values: &Nodal) -> f64 {
        dot(&self.weights, values)
    }
}

#[inline]
pub(super) fn dot(weights: &Nodal, values: &[f64]) -> f64 {
    let Ok(values) = <&Nodal>::try_from(values) else { return 0.0 };
    // Four sums at a time: one waits for itself.
    let mut sums = [0.0; 4];
    for k in 0..NODES / 4 {
        for (lane, sum) in sums.iter_mut().enumerate() {
            *sum += weights[4 * k + lane] * values[4 * k + lane];
        }
    }
    let rest = weights[NODES - 1] * values[NODES - 1];
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Weights of the barycentric formula of Chebyshev's points with both ends.
const BARYCENTRIC: Nodal = {
    let mut weights = [1.0; NODES];
    let mut k = 0;
    while k < NODES {
        weights[k] = if k % 2 == 0 { 1.0 } else { -1.0 } * if k == 0 || k + 1 == NODES { 0.5 } else { 1.0 };
        k += 1;
    }
    weights
};

/// Lagrange's polynomials at a place.
#[inline]
fn basis(xi: &Nodal, place: f64) -> Nodal {
    let values: Nodal = std::array::from_fn(|k| BARYCENTRIC[k] / (place - xi[k]));
    let over = values.iter().sum::<f64>().recip();
    if over == 0.0 || !over.is_finite() {
        return std::array::from_fn(|k| if place.total_cmp(&xi[k]).is_eq() { 1.0 } else { 0.0 });
    }
    values.map(|value| value * over)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_at_both_ends_are_kept() {
        let grid = &*GRID;
        let of = |part: f64| (part.sqrt() + 2.0) * ((1.0 - part) * part).sqrt() + part;
        let values = grid.parts.map(of);
        for part in [0.0, 1e-9, 1e-3, 0.3, 0.77, 1.0 - 1e-7, 1.0] {
            let found = dot(&grid.at(part, 1.0 - part), &values);
            assert!((found - of(part)).abs() < 2e-13, "{part} {found} {}", of(part));
        }
        // ∫√(x(1 − x)) = π/8, ∫x√(1 − x) = 4/15.
        let exact = PI / 4.0 + 0.5 + 4.0 / 15.0;
        assert!((grid.integral(&values) - exact).abs() < 1e-13, "{}", grid.integral(&values) - exact);
        // The last coefficients are larger than what they leave out: they bound it.
        assert!(grid.tail(&values) < 1e-12, "{}", grid.tail(&values));
        // Zero at the last place, but for rounding, with a slope of zero: halved to where rounding is.
        let mut flat = grid.parts.map(|part| (1.0 - part).powi(2));
        flat[NODES - 1] = -1e-40;
        assert!(1.0 - grid.part(grid.falling_zero(&flat)) < 1e-7);
        let falling = grid.parts.map(|part| 0.3 - part);
        assert!((grid.part(grid.falling_zero(&falling)) - 0.3).abs() < 1e-15);
        // ∫(0.3 − x)₊.
        assert!((grid.integral_to(grid.falling_zero(&falling), &falling) - 0.045).abs() < 1e-15);
    }
}
