//! One step: how the edge passes the line, and how the penetration goes.
//!
//! Within a step the part u of the time that has gone by, 0…1, and the part x of the way that the edge has gone are polynomials of one another:
//! t(y) while the edge drives the step (it stays smooth where the edge accelerates unstably), y(t) while time does (smooth where the edge stands still).
//! y is f(s) of the indenter, which makes a contact that grows from a point smooth, or s itself. Δ = Δ₀ + Σ w_k u^k.

use super::profile::Profile;
use super::springs::DEGREE;
use std::f64::consts::PI;

/// Iterations of an inverse: Newton, halved when it leaves its bracket.
const MOST_ITERATIONS: u32 = 60;

/// Rate of an edge at an end of a step, over its mean, below which it rests there: the time at which it passes a place goes with a root, then.
const AT_REST: f64 = 0.5;
/// Halvings of the time towards a rest.
const MOST_HALVINGS: u32 = 16;

/// How the edge passes an interval within a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Passage {
    /// a linear in time.
    Radius,
    /// u = Σ c_k x^k.
    TimeOfPlace([f64; DEGREE]),
    /// x = Σ c_k u^k.
    PlaceOfTime([f64; DEGREE]),
}

/// One step of edge and penetration.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    /// Edge before and after (m).
    pub(super) from: f64,
    pub(super) to: f64,
    /// y before, and how far it goes.
    start: f64,
    way: f64,
    /// Duration (s).
    pub(super) time: f64,
    pub(super) passage: Passage,
    /// Δ before (m).
    pub(super) penetration: f64,
    /// w_k.
    pub(super) powers: [f64; DEGREE],
}

/// Σ c_k x^k, k from 1.
pub(super) fn polynomial(coefficients: &[f64; DEGREE], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| (sum + c) * x)
}

fn slope(coefficients: &[f64; DEGREE], x: f64) -> f64 {
    coefficients.iter().enumerate().rev().fold(0.0, |sum, (k, c)| sum * x + (k as f64 + 1.0) * c)
}

/// x at which a rising polynomial from (0, 0) to (1, 1) has a value.
fn inverse(coefficients: &[f64; DEGREE], value: f64) -> f64 {
    let (mut low, mut high, mut x) = (0.0, 1.0, value);
    for _ in 0..MOST_ITERATIONS {
        let excess = polynomial(coefficients, x) - value;
        if excess < 0.0 {
            low = x
        } else {
            high = x
        }
        let newton = x - excess / slope(coefficients, x);
        let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= 1e-16 {
            return next;
        }
        x = next;
    }
    x
}

/// The straight polynomial.
pub(super) const STRAIGHT: [f64; DEGREE] = [1.0, 0.0, 0.0, 0.0, 0.0];

impl Motion {
    pub(super) fn new(
        profile: &Profile,
        (from, to): (f64, f64),
        time: f64,
        passage: Passage,
        penetration: f64,
        powers: [f64; DEGREE],
    ) -> Self {
        let start = profile.coordinate(from);
        Self { from, to, start, way: profile.coordinate(to) - start, time, passage, penetration, powers }
    }

    /// Δ at the end.
    pub(super) fn end_penetration(&self) -> f64 {
        self.penetration + self.powers.iter().sum::<f64>()
    }

    /// The part of the time at which the edge passes s.
    pub(super) fn part_of_time(&self, profile: &Profile, s: f64) -> f64 {
        let part = match &self.passage {
            Passage::Radius => (s - self.from) / (self.to - self.from),
            Passage::TimeOfPlace(c) => polynomial(c, (profile.coordinate(s) - self.start) / self.way),
            Passage::PlaceOfTime(c) => inverse(c, ((profile.coordinate(s) - self.start) / self.way).clamp(0.0, 1.0)),
        };
        part.clamp(0.0, 1.0)
    }

    /// Whether t(y) of an edge that drives the step steepens towards its end as where the edge comes to rest: the root there is no polynomial in y.
    pub(super) fn slows_down(&self) -> bool {
        matches!(&self.passage, Passage::TimeOfPlace(c) if slope(c, 1.0) > 1.0 / AT_REST)
    }

    /// Places that halve the time towards an end of the step at which the edge rests: between two of them a polynomial follows the root.
    pub(super) fn towards_rest(&self, profile: &Profile) -> Vec<f64> {
        let Passage::PlaceOfTime(c) = &self.passage else { return Vec::new() };
        let mut places = Vec::new();
        for end in [0.0, 1.0] {
            let rate = slope(c, end).abs();
            let mut left = 0.5;
            // The rate is twice that of the end where as much has been added to it as there was.
            for _ in 0..MOST_HALVINGS {
                if rate > AT_REST || 2.0 * left < rate {
                    break;
                }
                let x = polynomial(c, (end - left).abs()).clamp(0.0, 1.0);
                places.push(profile.inverse_coordinate(self.start + self.way * x, self.from, self.to));
                left *= 0.5;
            }
        }
        places
    }

    /// W − W₀ as powers of the part of a first interval of the time.
    pub(super) fn first_powers(&self, part: f64) -> [f64; DEGREE] {
        let mut scale = 1.0;
        self.powers.map(|power| {
            scale *= part;
            power * scale
        })
    }

    /// W at `part`, less W₀, and what follows as powers of the part of the rest.
    pub(super) fn last_powers(&self, part: f64) -> (f64, [f64; DEGREE]) {
        let rest = 1.0 - part;
        let mut powers = [0.0; DEGREE];
        // Taylor's shift by Horner: the coefficients of Σ w_k (part + rest·y)^k.
        let mut value = 0.0;
        for power in self.powers.iter().rev() {
            // value + Σ powers y^k  →  (… + power)·(part + rest·y)
            value += power;
            for k in (0..DEGREE).rev() {
                let below = if k == 0 { value } else { powers[k - 1] };
                powers[k] = powers[k] * part + below * rest;
            }
            value *= part;
        }
        (value, powers)
    }

    /// |da/dt| at the end; infinite for a motion at once.
    pub(super) fn edge_speed(&self, profile: &Profile) -> f64 {
        (self.area_rate(profile, 1.0) / (2.0 * PI * self.to * self.time)).abs()
    }

    /// dA/du, A = πa², at a part of the time.
    pub(super) fn area_rate(&self, profile: &Profile, part: f64) -> f64 {
        let (from, to) = (self.from, self.to);
        if self.way == 0.0 {
            return 0.0;
        }
        let place = |x: f64| profile.inverse_coordinate(self.start + self.way * x, from, to);
        let (x, rate) = match &self.passage {
            Passage::Radius => {
                let a = from + (to - from) * part;
                return 2.0 * PI * a * (to - from);
            }
            Passage::TimeOfPlace(c) => {
                let x = inverse(c, part);
                (x, 1.0 / slope(c, x))
            }
            Passage::PlaceOfTime(c) => (polynomial(c, part), slope(c, part)),
        };
        let a = place(x);
        2.0 * PI * a * self.way * rate / profile.coordinate_slope(a)
    }

    /// The motion up to a part of the time; `profile` gives the edge there.
    pub(super) fn until(&self, profile: &Profile, part: f64) -> Self {
        let place = match &self.passage {
            Passage::Radius => None,
            Passage::TimeOfPlace(c) => Some(inverse(c, part)),
            Passage::PlaceOfTime(c) => Some(polynomial(c, part)),
        };
        let to = place.map_or(self.from + (self.to - self.from) * part, |x| {
            profile.inverse_coordinate(self.start + self.way * x, self.from, self.to)
        });
        let scaled = |c: &[f64; DEGREE], by: f64, to: f64| {
            let mut scale = 1.0 / to;
            c.map(|c| {
                scale *= by;
                c * scale
            })
        };
        let passage = match (&self.passage, place) {
            (Passage::TimeOfPlace(c), Some(x)) if x > 0.0 => Passage::TimeOfPlace(scaled(c, x, part)),
            (Passage::PlaceOfTime(c), Some(x)) if x > 0.0 => Passage::PlaceOfTime(scaled(c, part, x)),
            _ => Passage::Radius,
        };
        Self::new(profile, (self.from, to), self.time * part, passage, self.penetration, self.first_powers(part))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp)]
    use super::*;

    #[test]
    fn shifted_powers_are_the_same_polynomial() {
        let profile = Profile::Paraboloid { radius: 1.0 };
        let powers = [0.3, -0.2, 0.15, 0.4, -0.05];
        let motion = Motion::new(&profile, (0.1, 0.2), 2.0, Passage::PlaceOfTime([0.8, 0.2, 0.0, 0.0, 0.0]), 1.0, powers);
        for part in [0.0, 0.3, 0.9, 1.0] {
            let (value, rest) = motion.last_powers(part);
            assert!((value - polynomial(&powers, part)).abs() < 1e-15);
            for y in [0.25, 0.7, 1.0] {
                assert!((value + polynomial(&rest, y) - polynomial(&powers, part + (1.0 - part) * y)).abs() < 1e-15);
                assert!((polynomial(&motion.first_powers(part), y) - polynomial(&powers, part * y)).abs() < 1e-15);
            }
        }
        let half = motion.until(&profile, 0.5);
        assert!((motion.part_of_time(&profile, half.to) - 0.5).abs() < 1e-14);
        let s = 0.12;
        assert!((half.part_of_time(&profile, s) * 0.5 - motion.part_of_time(&profile, s)).abs() < 1e-14);
    }
}
