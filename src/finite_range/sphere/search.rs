//! The instant of the largest tension and of zero force inside accepted steps, by single steps of shorter length.
//!
//! Interpolation between accepted points is not enough: a run may have fewer than twenty of them.

use super::drive::Drive;
use super::state::State;
use super::step::Solver;

/// Single steps of one search.
const TRIALS: usize = 40;
/// Halvings of a step that has no solution.
const HALVINGS: usize = 3;
/// Relative width at which a search for a smooth maximum ends.
const WIDTH: f64 = 1e-6;
/// Newton's tolerance in a search for a maximum, over the usual one: a maximum is flat.
const SHARP: f64 = 1e-3;

impl Solver<'_> {
    /// One step, or two halves where it has no solution: Newton's method may refuse a shorter step where it took a longer one.
    fn advance(&mut self, from: &State, drive: &Drive, h: f64, halvings: usize) -> Option<State> {
        if let Some(trial) = self.step(from, drive, h) {
            return Some(trial.state);
        }
        let halvings = halvings.checked_sub(1)?;
        let middle = self.advance(from, drive, 0.5 * h, halvings)?;
        self.advance(&middle, drive, 0.5 * h, halvings)
    }

    /// The state of largest tension between the first and the last of three states, of which the middle one has the largest.
    pub(super) fn largest_tension(&mut self, states: [&State; 3], drive: &Drive) -> State {
        let [first, middle, _] = states;
        let mut best = middle.clone();
        self.sharpness = SHARP;
        let mut force = |time: f64| {
            let from = if time <= middle.time { first } else { middle };
            // Where no step is found the search goes on at the other side.
            let Some(state) = self.advance(from, drive, time - from.time, HALVINGS) else { return f64::INFINITY };
            let force = state.force;
            if force < best.force {
                best = state;
            }
            force
        };
        minimise(&mut force, states.map(|state| (state.time, state.force)));
        self.sharpness = 1.0;
        best
    }

    /// The state of zero force inside a step.
    pub(super) fn zero_of_force(&mut self, from: &State, to: &State, drive: &Drive) -> State {
        self.crossing([from, to], drive, |_, state| state.force)
    }

    /// The state inside a step in which the gap at the axis is that of the largest tension: where a contact ends or begins.
    pub(super) fn open_axis(&mut self, from: &State, to: &State, drive: &Drive) -> State {
        self.crossing([from, to], drive, |solver, state| state.open_at_axis(&solver.mesher.quadrature.rule, &solver.surface))
    }

    /// The state inside a step in which a quantity that changes its sign is zero.
    fn crossing(&mut self, [from, to]: [&State; 2], drive: &Drive, of: impl Fn(&Self, &State) -> f64) -> State {
        let ends = [of(self, from), of(self, to)];
        let (mut low, mut high) = ((0.0, ends[0]), (to.time - from.time, ends[1]));
        let (mut best, mut least) = if ends[0].abs() < ends[1].abs() { (from.clone(), ends[0]) } else { (to.clone(), ends[1]) };
        let mut side = 0;
        for _ in 0..TRIALS {
            let h = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            if !(h > low.0 && h < high.0) {
                break;
            }
            let Some(state) = self.advance(from, drive, h, HALVINGS) else { break };
            let value = of(self, &state);
            if value.abs() < least.abs() {
                (best, least) = (state, value);
            }
            if value.abs() < 1e-9 * (ends[0].abs() + ends[1].abs()) {
                break;
            }
            // The Illinois rule: an end that stays twice counts half.
            if value * low.1 > 0.0 {
                low = (h, value);
                high.1 *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                high = (h, value);
                low.1 *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        best
    }
}

/// Whether two places of a search are one and the same.
fn same(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

/// Brent's search for a minimum: parabolas, golden sections where they do not help.
fn minimise(f: &mut impl FnMut(f64) -> f64, [first, middle, last]: [(f64, f64); 3]) {
    const GOLDEN: f64 = 0.381_966_011_250_105;
    let (mut a, mut b) = (first.0, last.0);
    let tolerance = WIDTH * (b - a);
    let ((mut x, mut fx), (mut w, mut fw), (mut v, mut fv)) = (middle, first, last);
    let (mut step, mut before) = (b - a, b - a);
    for _ in 0..TRIALS {
        let middle = 0.5 * (a + b);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (b - a) {
            return;
        }
        let mut golden = true;
        if before.abs() > tolerance {
            let (r, q) = ((x - w) * (fx - fv), (x - v) * (fx - fw));
            let (mut p, mut q) = ((x - v) * q - (x - w) * r, 2.0 * (q - r));
            if q > 0.0 {
                p = -p
            } else {
                q = -q
            }
            let earlier = std::mem::replace(&mut before, step);
            if p.abs() < (0.5 * q * earlier).abs() && p > q * (a - x) && p < q * (b - x) {
                step = p / q;
                golden = false;
            }
        }
        if golden {
            before = if x < middle { b - x } else { a - x };
            step = GOLDEN * before;
        }
        let at = if step.abs() >= tolerance { x + step } else { x + tolerance.copysign(step) };
        let value = f(at);
        if value <= fx {
            if at < x {
                b = x
            } else {
                a = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, at, value);
        } else {
            if at < x {
                a = at
            } else {
                b = at
            }
            if value <= fw || same(w, x) {
                (v, fv, w, fw) = (w, fw, at, value);
            } else if value <= fv || same(v, x) || same(v, w) {
                (v, fv) = (at, value);
            }
        }
    }
}
