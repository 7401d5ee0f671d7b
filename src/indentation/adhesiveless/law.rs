//! What is imposed on an interval of time in which the edge goes one way, as equations for Δ at its Chebyshev nodes (Graham).
//!
//! With ℛ the relaxation over E∞*, F/2E∞* is ∫(κ − p)₊ ds of κ = ℛΔ over the chains in contact while the edge recedes ([`Line::holding`]): no passage of
//! the edge is needed. While it advances F/2E∞* = ℛΦ, with Φ = ∫W ds over the whole line, an elastic function of Δ and of the free surface. In both ways
//!
//! ```text
//! c_F A_k(y_k) + c_D Σ_l(ℛ⁻¹)_kl y_l = b_k      y = κ or Δ,   A = ∫(κ − p)₊ ds or Φ,   dA/dy = a
//! ```
//!
//! where c_F F/2E∞* + c_Δ Δ is imposed: convex in y, so that Newton's steps from above go straight down. A duration of zero makes ℛ one: a step.

use super::drive::{DEGREE, decayed, means};
use super::edge::Way;
use super::fresh::Fresh;
use super::line::Line;
use super::linear::{Row, Square, eliminated, solved, transposed};
use super::rising::{Reached, Rising};
use crate::refusal::Refusal;
use std::f64::consts::PI;
use std::sync::LazyLock;

const MOST_ITERATIONS: u32 = 200;
/// An excess over what is imposed that tells the way of the edge.
const CLEAR: f64 = 1e-13;
/// Steps that no longer halve are rounding, if they are so small over the level, or what the series of the line leave, or so many times what is remembered.
const STALLED: f64 = 1e-12;
const MANY: f64 = 16.0;
/// Steps still to come, over what series leave, that are none.
const SETTLED: f64 = 1e-3;
/// After so many that do not halve, so small ones are what kinks of the line leave.
const STUCK: u32 = 40;
const AT_MOST: f64 = 1e-7;
/// What rounding leaves of a level.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// What is imposed.
#[derive(Clone, Copy)]
pub(super) enum Asked {
    /// c_F F/2E∞* + c_D Δ.
    Load {
        of_force: f64,
        of_depth: f64,
    },
    Radius,
}

/// Δ, where the edge is and which way it goes.
pub(super) struct Met {
    pub(super) way: Way,
    pub(super) depths: Row,
    pub(super) places: Row,
    /// Whether the edge rests, to rounding.
    pub(super) rests: bool,
    /// What rounding leaves of Δ: a small contact carries little of what the whole surface remembers.
    pub(super) noise: f64,
}

static PLACES: LazyLock<Row> = LazyLock::new(|| {
    std::array::from_fn(|k| if k + 1 == DEGREE { 1.0 } else { 0.5 - 0.5 * (PI * (k as f64 + 1.0) / DEGREE as f64).cos() })
});
/// Powers 1… of the parts of a duration, node after node.
static POWERS: LazyLock<Square> = LazyLock::new(|| places().map(|node| std::array::from_fn(|l| node.powi(l as i32 + 1))));

/// Parts of a duration at which its nodes lie.
pub(super) fn places() -> Row {
    *PLACES
}

pub(super) struct Law<'l, 'a> {
    pub(super) line: &'l Line<'a>,
    pub(super) fresh: &'l Fresh<'a>,
    duration: f64,
    soft: f64,
    inverse: Square,
    /// e^{−x/ρ_i} and e^{−x/τ_j} at the nodes, term after term.
    pub(super) kept: Vec<Row>,
    pub(super) recovered: Vec<Row>,
}

impl<'l, 'a> Law<'l, 'a> {
    pub(super) fn new(line: &'l Line<'a>, fresh: &'l Fresh<'a>, duration: f64) -> Self {
        let chain = line.chain;
        let nodes = places();
        let kept: Vec<Row> = chain.maxwell.iter().map(|(_, rho)| nodes.map(|node| decayed(node * duration / rho))).collect();
        let recovered = chain.voigt.iter().map(|(rate, _)| nodes.map(|node| decayed(node * duration * rate))).collect();
        let soft = chain.relaxed / chain.glassy;
        // ℛ of the powers of the time, then of values at the nodes.
        let mut of_powers: Square = [[0.0; DEGREE]; DEGREE];
        let powers: &Square = &POWERS;
        for (k, ((row, node), powers)) in of_powers.iter_mut().zip(nodes).zip(powers).enumerate() {
            let mut factors = [soft; DEGREE];
            for ((modulus, rho), kept) in chain.maxwell.iter().zip(&kept) {
                for (factor, mean) in factors.iter_mut().zip(means(node * duration / rho, kept[k])) {
                    *factor += modulus / chain.glassy * mean;
                }
            }
            for ((value, factor), power) in row.iter_mut().zip(factors).zip(powers) {
                *value = factor * power;
            }
        }
        // ℛ = (of powers)(powers)⁻¹: ℛ⁻¹ = (powers)(of powers)⁻¹, from the transposed system. What goes on at once jumps, which powers tell badly: ℛ is one.
        let inverse = if duration == 0.0 {
            std::array::from_fn(|k| std::array::from_fn(|l| if k == l { 1.0 } else { 0.0 }))
        } else {
            transposed(&eliminated(transposed(&of_powers), transposed(powers)))
        };
        Self { line, fresh, duration, soft, inverse, kept, recovered }
    }

    /// ℛ⁻¹ of values over those at the start.
    fn undone(&self, values: &Row) -> Row {
        self.inverse.map(|row| row.iter().zip(values).map(|(entry, value)| entry * value).sum())
    }

    pub(super) fn depths_of(&self, kappa: &Row) -> Row {
        let start = self.line.penetration;
        self.undone(&kappa.map(|kappa| kappa - self.soft * start)).map(|rise| start + rise)
    }

    /// Δ at the nodes for what is imposed there; none where Newton's steps do not end.
    /// `rate`: of Δ now, if it goes on.
    pub(super) fn met(&self, asked: Asked, target: &Row, rate: Option<f64>) -> Result<Option<Met>, Refusal> {
        let line = self.line;
        let a = line.radius();
        let mut inside = line.holding(&self.kept);
        let outside = || line.surfaces(&self.recovered);
        let (of_force, of_depth) = match asked {
            Asked::Radius => return self.met_radius(&inside, &outside(), target).map(Some),
            Asked::Load { of_force, of_depth } => (of_force, of_depth),
        };
        let punch = a > 0.0 && a >= line.profile.rim();
        if a > 0.0 {
            // The edge as it would have to be imposed to stay.
            let stays: Row = std::array::from_fn(|k| inside.last(k).unwrap_or(0.0));
            let depths = self.depths_of(&stays);
            let areas: Row = std::array::from_fn(|k| inside.under(k, stays[k]));
            let excess: Row = std::array::from_fn(|k| target[k] - of_force * areas[k] - of_depth * depths[k]);
            let size = target.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            let clear = excess.iter().find(|excess| excess.abs() > CLEAR * size);
            let Some(excess) = clear else { return Ok(Some(self.staying(&stays))) };
            if punch || *excess < 0.0 {
                return Ok(self.inwards(&mut inside, (of_force, of_depth), target, stays));
            }
        }
        self.outwards(&mut outside(), (of_force, of_depth), target, rate)
    }

    /// Δ that keeps S at the edge at zero: the edge rests, and a punch presses nothing.
    pub(super) fn resting(&self) -> Met {
        let inside = self.line.holding(&self.kept);
        self.staying(&std::array::from_fn(|k| inside.last(k).unwrap_or(0.0)))
    }

    fn staying(&self, stays: &Row) -> Met {
        Met { way: Way::Inwards, depths: self.depths_of(stays), places: [self.line.radius(); DEGREE], rests: true, noise: 0.0 }
    }

    fn inwards(&self, inside: &mut Rising<'_>, (of_force, of_depth): (f64, f64), target: &Row, from: Row) -> Option<Met> {
        let (line, start) = (self.line, self.line.penetration);
        let (a, rim) = (line.radius(), line.profile.rim());
        let base = self.undone(&[self.soft * start; DEGREE]);
        let right: Row = std::array::from_fn(|k| target[k] - of_depth * (start - base[k]));
        let reached = |k: usize, level: f64| {
            // All of a flat punch lets go at once.
            let all = a >= rim && (line.profile.is_flat() || level >= inside.last(k).unwrap_or(0.0));
            if all { Ok(Reached { area: inside.under(k, level), place: a, beyond: false }) } else { Ok(inside.reached(k, level)) }
        };
        let (kappa, places, noise) = self.newton((of_force, of_depth), &right, from, 0.0, reached).ok()??;
        Some(Met { way: Way::Inwards, depths: self.depths_of(&kappa), places, rests: false, noise })
    }

    fn outwards(
        &self,
        outside: &mut Rising<'_>,
        (of_force, of_depth): (f64, f64),
        target: &Row,
        rate: Option<f64>,
    ) -> Result<Option<Met>, Refusal> {
        let (line, chain) = (self.line, self.line.chain);
        let a = line.radius();
        let strains = line.free_strains();
        let under = self.fresh.integral(a);
        let now = a * line.penetration - under + strains.iter().sum::<f64>();
        let springs = line.whole_springs(&strains);
        let remembered = f64::EPSILON * strains.iter().chain(&springs).map(|value| value.abs()).sum::<f64>();
        let left = |k: usize| -> f64 { self.recovered.iter().zip(&strains).map(|(kept, strain)| kept[k] * strain).sum() };
        let history: Row = std::array::from_fn(|k| {
            let held = chain.maxwell.iter().zip(&self.kept).zip(&springs);
            self.soft * now + held.map(|(((modulus, _), kept), spring)| modulus / chain.glassy * kept[k] * spring).sum::<f64>()
        });
        let right = self.undone(&std::array::from_fn(|k| target[k] - of_force * history[k])).map(|value| of_force * now + value);
        let [_, top] = line.known();
        let first: Row = std::array::from_fn(|k| outside.first(k).unwrap_or_else(|| line.profile.line(a)));
        let reached = |k: usize, level: f64| -> Result<Reached, Refusal> {
            // Trials may be deeper than a table tells: as if it ended in a cylinder.
            let known = level.min(top);
            let mut reached = outside.reached(k, known);
            if reached.beyond && reached.place < line.profile.rim() {
                let (from, to) = (reached.place, self.fresh.edge(line, known, reached.place)?);
                let beyond = known * (to - from) - (self.fresh.integral(to) - self.fresh.integral(from));
                reached = Reached { area: reached.area + beyond, place: to, beyond: false };
            }
            let deeper = (level - known) * (reached.place - a).max(0.0);
            Ok(Reached { area: a * level - under + left(k) + reached.area + deeper, ..reached })
        };
        // Δ as it goes on, from where a first step leads above; or no lower than Δ is: a fresh contact on a surface that lies as deep everywhere as at the edge.
        let nodes = places();
        let mut from = [0.0; DEGREE];
        for (k, level) in from.iter_mut().enumerate() {
            *level = if of_depth > 0.0 {
                rate.filter(|_| a > 0.0).map_or(target[k] / of_depth, |rate| line.penetration + rate * nodes[k] * self.duration)
            } else {
                let lift = (first[k] - line.profile.line(a)).max(0.0);
                (lift + self.fresh.at_most((right[k] / of_force).max(0.0)).unwrap_or(top)).min(top)
            };
        }
        let met = self.newton((of_force, of_depth), &right, from, remembered, reached)?;
        if let Some(depth) = met.as_ref().and_then(|(depths, ..)| depths.iter().find(|depth| **depth > top)) {
            line.virgin_edge(*depth, a)?;
        }
        Ok(met.map(|(depths, places, noise)| {
            let noise = noise.max(remembered / places[0].max(f64::MIN_POSITIVE));
            Met { way: Way::Outwards, depths, places, rests: false, noise }
        }))
    }

    /// Newton's steps from above: levels, places, and the size of steps that no longer halve.
    fn newton(
        &self,
        (of_force, of_depth): (f64, f64),
        right: &Row,
        mut level: Row,
        remembered: f64,
        mut reached: impl FnMut(usize, f64) -> Result<Reached, Refusal>,
    ) -> Result<Option<(Row, Row, f64)>, Refusal> {
        let scale = self.line.depth.max(f64::MIN_POSITIVE);
        let stalled = (MANY * self.line.tolerance).max(STALLED);
        let settled = SETTLED * self.line.tolerance;
        let (mut last, mut stuck) = (f64::INFINITY, 0);
        // Levels that are too high, and too low.
        let (mut above, mut below) = (level, [f64::NEG_INFINITY; DEGREE]);
        for _ in 0..MOST_ITERATIONS {
            let along = if of_depth == 0.0 { level } else { self.undone(&level) };
            let (mut excess, mut places) = ([0.0; DEGREE], [0.0; DEGREE]);
            for k in 0..DEGREE {
                let there = reached(k, level[k])?;
                excess[k] = of_force * there.area + of_depth * along[k] - right[k];
                places[k] = there.place;
                if excess[k] > 0.0 {
                    above[k] = level[k];
                } else {
                    below[k] = below[k].max(level[k]);
                }
            }
            let step = if of_depth == 0.0 {
                std::array::from_fn(|k| {
                    if excess[k] == 0.0 {
                        0.0
                    } else if places[k] > 0.0 {
                        // Where a surface lies close all along, rounding may lead below what was too low.
                        let step = excess[k] / (of_force * places[k]);
                        if level[k] - step > below[k] || excess[k] < 0.0 { step } else { 0.5 * (level[k] - below[k]) }
                    } else {
                        // Kinks of the line have led below all that is in contact.
                        -0.5 * (above[k] - level[k])
                    }
                })
            } else {
                let jacobian: Square = std::array::from_fn(|k| {
                    std::array::from_fn(|l| of_depth * self.inverse[k][l] + if k == l { of_force * places[k] } else { 0.0 })
                });
                solved(jacobian, excess)
            };
            let size = step.iter().fold(0.0, |most: f64, step| most.max(step.abs()));
            if !size.is_finite() {
                return Ok(None);
            }
            let whole = level.iter().fold(scale, |most, level| most.max(level.abs()));
            for (level, step) in level.iter_mut().zip(step) {
                *level -= step;
            }
            let small = places.iter().fold(f64::INFINITY, |least, place| least.min(*place)).max(f64::MIN_POSITIVE);
            // The next step is as much smaller again, or more: none, or too small to tell.
            let next = size * (size / last);
            if size <= ROUNDING * whole || (last.is_finite() && next <= settled * whole) {
                return Ok(Some((level, places, 0.0)));
            }
            if (size <= (stalled * whole).max(MANY * remembered / small) && size >= 0.5 * last)
                || (stuck > STUCK && size <= AT_MOST * whole)
            {
                return Ok(Some((level, places, size)));
            }
            stuck += u32::from(size >= 0.5 * last);
            last = size;
        }
        Ok(None)
    }
}
