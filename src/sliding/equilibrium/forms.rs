//! Both edge conditions of one half-width, as quadratic forms.
//!
//! Fields of a contact are linear in u = (cos e, sin e, p̄), of a parabola in (1, e, p̄), and so are those of the contacts with a moved edge at the same penetration. The
//! closure work of an edge is therefore a quadratic form, known from the tensions and gaps of three contacts, and at equilibrium
//! ```text
//! uᵀA_iu = work_i/2πΓ_i = 1 = uᵀIu,    I = diag(1, 1, 0), of a parabola diag(1, 0, 0)        i = trailing, leading
//! ```
//! Two conics uᵀ(A_i − I)u = 0 in the projective plane meet in four points at most: these are the contacts, and there are no others. The points are seen from one that is
//! on neither conic, so that no two of them lie in one direction: along each direction both conics are quadratics, which have a root in common where their resultant, a
//! quartic of the direction, vanishes. Without adhesion both edge amplitudes, linear in u, vanish.

use super::works::{Square, Works};
use crate::continuation::two_unknowns::{largest, solve_two_by_two};
use crate::sliding::contact::Indenter;
use std::f64::consts::PI;

/// Steps of false position between two arguments of opposite signs.
const STEPS: usize = 60;
/// Roots of polynomials are found to this: those of the conditions are polished, and at the roots of a derivative only signs count.
const ROOT: f64 = 1e-9;
/// Newton steps at a point where both conics meet.
const POLISHES: usize = 4;
/// Largest residual of a condition at such a point.
const MEETS: f64 = 1e-5;
/// The frame that conics are seen in: three orthonormal directions of no meaning.
const FRAME: [[f64; 3]; 3] = [[0.608_878, -0.343_442, 0.715_063], [0.512_851, 0.858_127, -0.024_540], [-0.605_186, 0.381_663, 0.698_629]];

/// The six coefficients of a quadratic form in three unknowns: the squares, and the products of the first and second, first and third, second and third.
pub(super) type Form = [f64; 6];
/// The three of a linear form.
pub(super) type Line = [f64; 3];
/// (c, s): (cos e, sin e), of a parabola (1, e).
pub(super) type Direction = (f64, f64);

/// The value of a linear form.
pub(super) fn of_line([c, s, p]: &Line, (cosine, sine): Direction, pressure: f64) -> f64 {
    c * cosine + s * sine + p * pressure
}

/// (cos e, sin e), of a parabola (1, e).
pub(super) fn direction(indenter: Indenter, eccentricity: f64) -> Direction {
    match indenter {
        Indenter::Wave => (eccentricity.cos(), eccentricity.sin()),
        Indenter::Parabola => (1.0, eccentricity),
    }
}

/// A form in scaled unknowns and the frame.
fn conic([a, b, c, d, e, f]: &Form, scales: [f64; 3]) -> Square {
    let plain = [[*a, 0.5 * d, 0.5 * e], [0.5 * d, *b, 0.5 * f], [0.5 * e, 0.5 * f, *c]];
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let mut sum = 0.0;
            for (m, first) in FRAME[row].iter().enumerate() {
                for (n, second) in FRAME[column].iter().enumerate() {
                    sum += first * scales[m] * plain[m][n] * scales[n] * second;
                }
            }
            sum
        })
    })
}

fn combined(first: &Square, second: &Square, factor: f64) -> Square {
    std::array::from_fn(|row| std::array::from_fn(|column| first[row][column] + factor * second[row][column]))
}

fn normalized(matrix: &Square) -> Square {
    let largest = matrix.iter().flatten().fold(f64::MIN_POSITIVE, |largest: f64, entry| largest.max(entry.abs()));
    matrix.map(|row| row.map(|entry| entry / largest))
}

/// Product of two polynomials in y/x, of degrees that add up to four at most.
fn product(first: &[f64], second: &[f64]) -> [f64; 5] {
    let mut out = [0.0; 5];
    for (m, one) in first.iter().enumerate() {
        for (n, other) in second.iter().enumerate() {
            if let Some(slot) = out.get_mut(m + n) {
                *slot += one * other;
            }
        }
    }
    out
}

/// Points in which two conics meet, in the frame.
fn meeting(first: &Square, second: &Square) -> Vec<[f64; 3]> {
    // Along the direction (x, y): a z² + b z + c with b linear and c quadratic in the direction.
    let parts = |conic: &Square| {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = *conic;
        (zz, [2.0 * xz, 2.0 * yz], [xx, 2.0 * xy, yy])
    };
    let ((a1, b1, c1), (a2, b2, c2)) = (parts(first), parts(second));
    let crossed: [f64; 3] = std::array::from_fn(|index| a1 * c2[index] - a2 * c1[index]);
    let linear = [a1 * b2[0] - a2 * b1[0], a1 * b2[1] - a2 * b1[1]];
    let (one, other) = (product(&b1, &c2), product(&b2, &c1));
    let mixed: [f64; 4] = std::array::from_fn(|index| one[index] - other[index]);
    let (square, rest) = (product(&crossed, &crossed), product(&linear, &mixed));
    let quartic: [f64; 5] = std::array::from_fn(|index| square[index] - rest[index]);
    let mut reversed = quartic;
    reversed.reverse();
    // Directions within a half of x, and within a half of y.
    let directions = real_roots(&quartic).into_iter().map(|y| (1.0, y)).chain(real_roots(&reversed).into_iter().map(|x| (x, 1.0)));
    let at = |line: &[f64; 2], (x, y): (f64, f64)| line[0] * x + line[1] * y;
    directions
        .map(|(x, y)| {
            let crossed = crossed[0] * x * x + crossed[1] * x * y + crossed[2] * y * y;
            [x, y, -crossed / at(&linear, (x, y))]
        })
        .collect()
}

/// The real roots of a polynomial (rising powers) between −1 and 1, between those of its derivative where there may be more than one.
fn real_roots(coefficients: &[f64]) -> Vec<f64> {
    let value = |x: f64| coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient);
    let degree = coefficients.len() - 1;
    let most = most_roots(coefficients);
    if degree == 0 || most == 0 {
        return Vec::new();
    }
    let mut ends = vec![-1.0];
    if most > 1 {
        let derivative: [f64; 4] = std::array::from_fn(|power| (power + 1) as f64 * coefficients.get(power + 1).copied().unwrap_or(0.0));
        ends.extend(real_roots(&derivative[..degree]));
    }
    ends.push(1.0);
    ends.windows(2)
        .filter_map(|pair| match *pair {
            [low, high] if (value(low) < 0.0) != (value(high) < 0.0) => Some(between(low, high, &value)),
            _ => None,
        })
        .collect()
}

/// A bound on the number of roots between −1 and 1, met exactly where it is none or one: Descartes' rule for u = (1 + x)/(1 − x).
fn most_roots(coefficients: &[f64]) -> usize {
    // Σ c_k (u − 1)^k (u + 1)^(n − k) by Horner's scheme.
    let (mut sum, mut power) = ([0.0; 5], [1.0, 0.0, 0.0, 0.0, 0.0]);
    for coefficient in coefficients.iter().rev() {
        let (before, of_power) = (sum, power);
        for index in 0..5 {
            let lower = |of: &[f64; 5]| if index == 0 { 0.0 } else { of[index - 1] };
            sum[index] = lower(&before) - before[index] + coefficient * of_power[index];
            power[index] = lower(&of_power) + of_power[index];
        }
    }
    let mut signs = sum.iter().filter(|&&term| term != 0.0).map(|&term| term < 0.0);
    let Some(mut last) = signs.next() else { return 0 };
    signs.filter(|&sign| std::mem::replace(&mut last, sign) != sign).count()
}

/// Both conditions of a half-width.
#[derive(Debug, Clone)]
pub(super) struct Conditions {
    pub(super) indenter: Indenter,
    /// Works over 2πΓ; none without adhesion.
    pub(super) works: Option<Works>,
    /// Amplitudes of the trailing and of the leading edge, in the contact and, with adhesion, in both moved ones.
    pub(super) amplitudes: Vec<Line>,
    /// Δ − 1 of a wave.
    pub(super) depth: Option<Line>,
}

impl Conditions {
    /// Eccentricity and mean pressure of every root of both conditions, whatever the signs of the edges.
    pub(super) fn roots(&self) -> Vec<(f64, f64)> {
        match &self.works {
            Some(works) => self.adhesive(works),
            None => self.smooth(),
        }
    }

    /// Where both amplitudes vanish, p̄ eliminated: a c + b s = 0.
    fn smooth(&self) -> Vec<(f64, f64)> {
        let [first, second] = match &self.amplitudes[..] {
            [first, second, ..] => [first, second],
            _ => return Vec::new(),
        };
        let (a, b) = (first[0] * second[2] - second[0] * first[2], first[1] * second[2] - second[1] * first[2]);
        let eccentricities = match self.indenter {
            Indenter::Wave => {
                let e = (-a).atan2(b);
                vec![e, if e > 0.0 { e - PI } else { e + PI }]
            }
            Indenter::Parabola => vec![-a / b],
        };
        let pressure = |e: f64| {
            let (c, s) = direction(self.indenter, e);
            -((first[0] + second[0]) * c + (first[1] + second[1]) * s) / (first[2] + second[2])
        };
        eccentricities.into_iter().map(|e| (e, pressure(e))).filter(|(e, pressure)| e.is_finite() && *pressure > 0.0).collect()
    }

    /// The points in which both conics meet.
    fn adhesive(&self, works: &Works) -> Vec<(f64, f64)> {
        let (unit, columns) = works.unit(self.indenter);
        // Unknowns in which both conics are of order one.
        let part = |form: &Form, index: usize| form[index].abs() + unit[index].abs();
        let scales: [f64; 3] =
            std::array::from_fn(|index| works.forms.iter().map(|form| (part(form, 0) / part(form, index)).powf(0.25)).product());
        let [first, second] = works.forms.each_ref().map(|form| conic(&std::array::from_fn(|index| form[index] - unit[index]), scales));
        // Across a narrow gap both edges pull almost alike: what distinguishes them has its own size.
        let difference = normalized(&combined(&second, &first, -1.0));
        let mut roots = Vec::new();
        for point in meeting(&normalized(&combined(&first, &second, 1.0)), &difference) {
            let seen: Line = std::array::from_fn(|index| scales[index] * (0..3).map(|row| FRAME[row][index] * point[row]).sum::<f64>());
            let [c, s, p]: Line = std::array::from_fn(|part| seen.iter().zip(&columns).map(|(size, column)| size * column[part]).sum());
            match self.indenter {
                Indenter::Wave => {
                    // A point of the plane is two opposite contacts, with the same works.
                    let Some((e, pressure)) = self.polished(works, (s.atan2(c), p / c.hypot(s))) else { continue };
                    roots.extend([(e, pressure), (if e > 0.0 { e - PI } else { e + PI }, -pressure)]);
                }
                Indenter::Parabola => roots.extend(self.polished(works, (s / c, p / c))),
            }
        }
        roots
    }

    /// A root to the last digits; none if there is none.
    fn polished(&self, works: &Works, (mut eccentricity, mut pressure): (f64, f64)) -> Option<(f64, f64)> {
        let off =
            |eccentricity: f64, pressure: f64| [0, 1].map(|edge| works.work(edge, direction(self.indenter, eccentricity), pressure) - 1.0);
        let mut best = off(eccentricity, pressure);
        for _ in 0..POLISHES {
            let jacobian = [0, 1].map(|edge| works.slopes(edge, self.indenter, eccentricity, pressure));
            let Some(step) = solve_two_by_two(&jacobian, best) else { break };
            let (e, p) = (eccentricity - step[0], pressure - step[1]);
            let next = off(e, p);
            if largest(next) >= largest(best) {
                break;
            }
            (eccentricity, pressure, best) = (e, p, next);
        }
        (largest(best) < MEETS).then_some((eccentricity, pressure))
    }
}

/// A root between two arguments of opposite signs: false position with the Illinois halving.
fn between(mut low: f64, mut high: f64, function: &impl Fn(f64) -> f64) -> f64 {
    let (mut at_low, mut at_high) = (function(low), function(high));
    if at_high == 0.0 {
        return high;
    }
    let mut kept = 0;
    for step in 0..STEPS {
        let part = at_low / (at_low - at_high);
        // Every fourth step halves, whatever the shape.
        let next = if step % 4 == 3 || !part.is_finite() { 0.5 * (low + high) } else { low + part * (high - low) };
        let value = function(next);
        if value == 0.0 || (high - low).abs() <= ROOT {
            return next;
        }
        if (value < 0.0) == (at_low < 0.0) {
            (low, at_low) = (next, value);
            if kept == -1 {
                at_high *= 0.5;
            }
            kept = -1;
        } else {
            (high, at_high) = (next, value);
            if kept == 1 {
                at_low *= 0.5;
            }
            kept = 1;
        }
    }
    0.5 * (low + high)
}
