//! Both edge conditions of one half-width, as quadratic forms.
//!
//! Fields of a contact are linear in u = (cos e, sin e, p̄), of a parabola in (1, e, p̄), and so are those of the contacts with a moved edge at the same penetration. The
//! closure work of an edge is therefore a quadratic form
//! ```text
//! work_i/2πΓ_i = uᵀA_i u = 1        i = trailing, leading
//! ```
//! known from the tensions and gaps of three contacts. For each e both conditions give p̄ in closed form; of the two roots the lower one pulls the edge. Where the
//! pressures of the two edges meet along e, there is a contact, and none elsewhere. Without adhesion both edge amplitudes, linear in u, vanish.

use crate::sliding::contact::Indenter;
use std::f64::consts::PI;

/// Eccentricities at which both conditions are compared.
const COMPARED: usize = 240;
/// Bisections and secant steps between two of them.
const STEPS: usize = 60;
/// Eccentricities of a parabola go from −tan to +tan of this, in units of where the load of the other edge balances.
const WIDEST_ANGLE: f64 = 1.5;

/// The six coefficients of a quadratic form in (c, s, p): cc, ss, pp, cs, cp, sp.
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

/// ∂/∂e and ∂/∂p̄ of a form.
pub(super) fn slopes([cc, ss, pp, cs, cp, sp]: &Form, indenter: Indenter, eccentricity: f64, p: f64) -> [f64; 2] {
    let (c, s) = direction(indenter, eccentricity);
    let (by_c, by_s) = (2.0 * cc * c + cs * s + cp * p, 2.0 * ss * s + cs * c + sp * p);
    let by_shift = match indenter {
        Indenter::Wave => by_s * c - by_c * s,
        Indenter::Parabola => by_s,
    };
    [by_shift, 2.0 * pp * p + cp * c + sp * s]
}

/// Both mean pressures at which a form is one, the lower one first; NaN where there is none.
fn pressures([cc, ss, pp, cs, cp, sp]: &Form, (c, s): Direction) -> [f64; 2] {
    let (half, rest) = (0.5 * (cp * c + sp * s), cc * c * c + ss * s * s + cs * c * s - 1.0);
    let root = (half * half - pp * rest).sqrt();
    // Without cancellation: the product of both is rest/pp.
    let sum = if half < 0.0 { -half + root } else { -half - root };
    let (first, second) = (sum / pp, rest / sum);
    [first.min(second), first.max(second)]
}

/// Both conditions of a half-width.
#[derive(Debug, Clone)]
pub(super) struct Conditions {
    pub(super) indenter: Indenter,
    /// The size of eccentricities; one for a wave.
    pub(super) reach: f64,
    /// Works over 2πΓ; none without adhesion.
    pub(super) works: Option<[Form; 2]>,
    /// Amplitudes of the trailing and of the leading edge, in the contact and, with adhesion, in both moved ones.
    pub(super) amplitudes: Vec<Line>,
}

impl Conditions {
    /// Eccentricity and mean pressure of every root of both conditions with both edges pulled on their own; without adhesion: not singular.
    pub(super) fn roots(&self) -> Vec<(f64, f64)> {
        match &self.works {
            Some(works) => self.adhesive(works),
            None => self.adhesiveless(),
        }
    }

    /// The amplitudes vanish: p̄ eliminated, a c + b s = 0.
    fn adhesiveless(&self) -> Vec<(f64, f64)> {
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
        eccentricities.into_iter().map(|e| (e, pressure(e))).filter(|&(_, pressure)| pressure > 0.0).collect()
    }

    fn adhesive(&self, works: &[Form; 2]) -> Vec<(f64, f64)> {
        let place = |index: f64| {
            let part = 2.0 * index / COMPARED as f64 - 1.0;
            match self.indenter {
                Indenter::Wave => part * PI,
                Indenter::Parabola => self.reach * (part * WIDEST_ANGLE).tan(),
            }
        };
        // A load that presses more pulls less on an edge: pulled edges have the lower of both pressures.
        let at = |index: f64| {
            let direction = direction(self.indenter, place(index));
            (pressures(&works[0], direction)[0], pressures(&works[1], direction)[0])
        };
        let difference = |index: f64| {
            let (one, other) = at(index);
            one - other
        };
        let mut roots = Vec::new();
        let mut add = |low: f64, high: f64| {
            let index = between(low, high, &difference);
            roots.push((place(index), at(index).0));
        };
        let values: Vec<f64> = (0..=COMPARED).map(|index| difference(index as f64)).collect();
        for (index, pair) in values.windows(2).enumerate() {
            if let [from, to] = *pair
                && from * to <= 0.0
                && from != 0.0
            {
                add(index as f64, index as f64 + 1.0);
            }
        }
        // Two roots between neighbours: where the difference comes near zero and goes back.
        for (index, triple) in values.windows(3).enumerate() {
            let [from, middle, to] = *triple else { continue };
            if from * middle > 0.0 && middle * to > 0.0 && middle.abs() <= from.abs().min(to.abs()) {
                let (mut low, mut high) = (index as f64, index as f64 + 2.0);
                for _ in 0..STEPS {
                    let (one, other) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                    if difference(one) * middle.signum() < difference(other) * middle.signum() {
                        high = other;
                    } else {
                        low = one;
                    }
                    let nearest = 0.5 * (low + high);
                    if difference(nearest) * middle < 0.0 {
                        add(index as f64, nearest);
                        add(nearest, index as f64 + 2.0);
                        break;
                    }
                }
            }
        }
        roots
    }
}

/// A root between two arguments of opposite signs: false position with the Illinois halving, to the last digits.
pub(super) fn between(mut low: f64, mut high: f64, function: &impl Fn(f64) -> f64) -> f64 {
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
        if value == 0.0 || (high - low).abs() <= 4.0 * f64::EPSILON * (1.0 + next.abs()) {
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
