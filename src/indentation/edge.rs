//! One step: the edge moves by a given distance, the time follows from the edge condition.
//!
//! The residual g(a, dt) of the edge condition falls when the edge advances too far ahead of its time and is positive where it should recede:
//! g = C/Δγ − 1, with the sign of a pressed edge turned, or −Q(a) without adhesion. At dt = 0 the solid answers glassily, and a stable
//! edge has g(a − h) < 0 < g(a + h). The step takes the FIRST instant at which g changes sign at the edge one step ahead (C is a product: later
//! sign changes may be compressed edges), or, if the end of the allowed time comes first, the edge that is right at that end.
//! If g(a − h) ≥ 0 at once, however small h, there is no stable edge nearby: an event.

use super::line::{Contact, Sweep};
use super::panel::value_at;
use super::problem::Adhesion;
use super::zone::Zone;
use crate::refusal::Refusal;

/// What is imposed at a time after the present instant.
pub(super) enum Imposed<'h> {
    /// Δ.
    Penetration(&'h dyn Fn(f64) -> f64),
    /// F.
    Force(&'h dyn Fn(f64) -> f64),
}

/// Where a step ended.
pub(super) enum Step<'a> {
    /// A new state, dt later.
    Moved(Contact<'a>, f64, f64),
    /// No stable edge: it runs inwards (true) or outwards.
    Unstable(bool),
}

/// The edge condition and its counters.
pub(super) struct Edge {
    pub(super) adhesion: Option<Adhesion>,
    /// The kernel of the last trial edge: many trials share one.
    pub(super) kernel: Option<(f64, Zone)>,
    /// Scale of Q without adhesion.
    pub(super) load_scale: f64,
    /// Length scale of changes of Δ, to condition differences.
    pub(super) depth_scale: f64,
    /// Accepted |g|.
    pub(super) tolerance: f64,
    pub(super) evaluations: u64,
    pub(super) updates: u64,
}

/// Doublings of the trial time before the scan gives up; 2^200 spans any history.
const MOST_DOUBLINGS: u32 = 200;
/// Iterations of a bracketed root; regula falsi with Illinois weights needs about 8.
const MOST_ITERATIONS: u32 = 100;

impl Edge {
    pub(super) fn sweep(&self) -> Sweep {
        if self.adhesion.is_some() { Sweep::Linear } else { Sweep::Profile }
    }

    /// The penetration at which the imposed force acts on an edge at `a` after dt: F is affine in Δ.
    pub(super) fn penetration(&mut self, from: &Contact<'_>, a: f64, dt: f64, imposed: &Imposed<'_>) -> Result<f64, Refusal> {
        match imposed {
            Imposed::Penetration(history) => Ok(history(dt)),
            Imposed::Force(history) => {
                let (here, scale, sweep) = (from.penetration(), self.depth_scale, self.sweep());
                let mut force = |depth: f64| {
                    let moved = from.moved(a, depth, dt, sweep)?;
                    self.updates += moved.updates() - from.updates();
                    Ok::<f64, Refusal>(moved.force())
                };
                let (first, second) = (force(here)?, force(here + scale)?);
                Ok(here + scale * (history(dt) - first) / (second - first))
            }
        }
    }

    /// g of a trial edge.
    pub(super) fn residual(&mut self, from: &Contact<'_>, a: f64, dt: f64, imposed: &Imposed<'_>) -> Result<f64, Refusal> {
        let penetration = self.penetration(from, a, dt, imposed)?;
        self.residual_at(from, a, penetration, dt)
    }

    pub(super) fn residual_at(&mut self, from: &Contact<'_>, a: f64, penetration: f64, dt: f64) -> Result<f64, Refusal> {
        self.evaluations += 1;
        let zone = self.adhesion.map_or(0.0, |adhesion| adhesion.process_zone);
        let trial = from.moved_within(a, penetration, dt, self.sweep(), (a - zone, a + zone));
        self.updates += trial.updates() - from.updates();
        let g = match self.adhesion {
            Some(adhesion) => {
                let loads = trial.line_load();
                let kernel = match self.kernel.take() {
                    Some((place, kernel)) if place.to_bits() == a.to_bits() => kernel,
                    _ => Zone::new(a, zone)?,
                };
                let work = trial.zone_work_with(&kernel, zone) / adhesion.work_of_adhesion;
                self.kernel = Some((a, kernel));
                if value_at(&loads, a) > 0.0 { -work.abs() - 1.0 } else { work - 1.0 }
            }
            None => -trial.edge_load() / self.load_scale,
        };
        if g.is_finite() {
            Ok(g)
        } else {
            Err(Refusal::NotConverged { what: "the edge condition", detail: format!("it is not a number at a = {a:e}") })
        }
    }

    /// A step of at most `reach` of the edge and `cap` of time, guessed to take about `guess`.
    pub(super) fn step<'a>(
        &mut self,
        from: &Contact<'a>,
        reach: f64,
        cap: f64,
        guess: f64,
        imposed: &Imposed<'_>,
    ) -> Result<Step<'a>, Refusal> {
        let a = from.radius();
        let guess = guess.min(cap);
        let first_inwards = self.residual(from, a, guess, imposed)? > 0.0;
        for inwards in [first_inwards, !first_inwards] {
            let target = if inwards { a - reach } else { a + reach };
            let sign = if inwards { 1.0 } else { -1.0 };
            let at_once = sign * self.residual(from, target, 0.0, imposed)?;
            if at_once >= 0.0 {
                return Ok(Step::Unstable(inwards));
            }
            let (mut low, mut low_value) = (0.0, at_once);
            // The way not expected is looked at once, at the end of the allowed time.
            let mut trial = if inwards == first_inwards { 0.7 * guess } else { cap };
            for _ in 0..MOST_DOUBLINGS {
                let trial_time = trial.min(cap);
                let value = sign * self.residual(from, target, trial_time, imposed)?;
                if value >= 0.0 {
                    let time = self
                        .root((low, low_value), (trial_time, value), |edge, time| Ok(sign * edge.residual(from, target, time, imposed)?))?;
                    return self.finished(from, target, time, imposed);
                }
                if trial_time >= cap {
                    break;
                }
                (low, low_value) = (trial_time, value);
                trial *= 1.7;
            }
        }
        // Neither neighbour has become right within the cap: the edge is between them at its end.
        let (low, high) = (a - reach, a + reach);
        let (low_value, high_value) = (self.residual(from, low, cap, imposed)?, self.residual(from, high, cap, imposed)?);
        if low_value >= 0.0 || high_value <= 0.0 {
            return Ok(Step::Unstable(low_value >= 0.0));
        }
        let edge = self.root((low, low_value), (high, high_value), |edge, place| edge.residual(from, place, cap, imposed))?;
        self.finished(from, edge, cap, imposed)
    }

    fn finished<'a>(&mut self, from: &Contact<'a>, a: f64, dt: f64, imposed: &Imposed<'_>) -> Result<Step<'a>, Refusal> {
        let penetration = self.penetration(from, a, dt, imposed)?;
        let residual = self.residual_at(from, a, penetration, dt)?;
        let moved = from.moved(a, penetration, dt, self.sweep())?;
        self.updates += moved.updates() - from.updates();
        Ok(Step::Moved(moved, dt, residual))
    }

    /// The zero of a function with values below and above it: regula falsi with Illinois weights, halved when slow.
    pub(super) fn root(
        &mut self,
        below: (f64, f64),
        above: (f64, f64),
        mut function: impl FnMut(&mut Self, f64) -> Result<f64, Refusal>,
    ) -> Result<f64, Refusal> {
        let ((mut low, mut low_value), (mut high, mut high_value)) = (below, above);
        for iteration in 0..MOST_ITERATIONS {
            let chord = (low * high_value - high * low_value) / (high_value - low_value);
            let inside = chord > low.min(high) && chord < low.max(high);
            let point = if inside && iteration % 6 != 5 { chord } else { 0.5 * (low + high) };
            let value = function(self, point)?;
            if value.abs() <= self.tolerance || (high - low).abs() <= 4.0 * f64::EPSILON * high.abs().max(low.abs()) {
                return Ok(point);
            }
            if value < 0.0 {
                (low, low_value) = (point, value);
                high_value *= 0.5;
            } else {
                (high, high_value) = (point, value);
                low_value *= 0.5;
            }
        }
        Err(Refusal::NotConverged { what: "the edge condition", detail: format!("the bracket {low:e} to {high:e} stopped shrinking") })
    }

    /// A stable edge somewhere else, at once: the next one inwards or outwards, or none before `end`.
    pub(super) fn elsewhere(
        &mut self,
        from: &Contact<'_>,
        start: f64,
        inwards: bool,
        reach: f64,
        end: f64,
        imposed: &Imposed<'_>,
    ) -> Result<Option<f64>, Refusal> {
        let mut place = start;
        let mut last = (place, if inwards { 1.0 } else { -1.0 });
        loop {
            place = if inwards { place - reach } else { place + reach };
            if (inwards && place <= end) || (!inwards && place >= end) {
                return Ok(None);
            }
            let value = self.residual(from, place, 0.0, imposed)?;
            if (inwards && value < 0.0) || (!inwards && value > 0.0) {
                if inwards == (last.1 < 0.0) {
                    return Ok(Some(place));
                }
                let here = (place, value);
                let (below, above) = if inwards { (here, last) } else { (last, here) };
                return self.root(below, above, |edge, a| edge.residual(from, a, 0.0, imposed)).map(Some);
            }
            last = (place, value);
        }
    }
}
