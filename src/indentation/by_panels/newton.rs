//! Newton's method for a panel, with the exact memory of its fields.
//!
//! Residuals r_i = C(θ_i) − Δγ − [`Target`]: what a cut between points left at the start, which fades over the panel. With δT(s) the change of the passage,
//! ```text
//! δC = ∂C/∂t δT(θ_i) + ∫ (δC/δT) δT ds                         TimeOfPlace
//! δC = ∂C/∂a δs(θ_i) − ∫ (δC/δT)(dT/ds) δs ds,                 PlaceOfTime, with ∂C/∂a = (r′ − ∂C/∂t T′)/s′ along the path
//! ```

use super::closure::{Closure, Way, Window};
use super::drive::Instant;
use super::gauss::solve;
use super::line::{Segment, series};
use super::path::{Chart, Points, Setting, passed};

/// A converged panel.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    pub(super) chart: Chart,
    pub(super) segment: Segment,
    /// A scale of |∂C/∂a| on it.
    pub(super) stiffness: f64,
    /// C − Δγ at its last point.
    pub(super) end_residual: f64,
    /// What its series of states may miss, as a position.
    pub(super) tail: f64,
}

/// What C − Δγ is to be along a panel: what the cut before it left, of which a part fades on the way, and what that cut left of ∂C/∂t of an edge that
/// turns: it sets out without speed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Target {
    pub(super) residual: f64,
    pub(super) fades: f64,
    pub(super) rate: f64,
}

impl Target {
    pub(super) fn at(&self, theta: f64, time: f64) -> f64 {
        let (gone, left) = (0.5 * (1.0 + theta), 0.5 * (1.0 - theta));
        self.residual * (1.0 - self.fades * gone) + self.rate * time * left * left
    }

    /// The most that its rate adds over a time.
    pub(super) fn added(&self, time: f64) -> f64 {
        4.0 / 27.0 * (self.rate * time).abs()
    }
}

/// Iterations of a panel: a good one takes two or three.
const MOST_ITERATIONS: u32 = 12;
/// A step that leaves more of the residual than this is slow.
const SLOW: f64 = 0.2;
/// Residual over Δγ that rounding leaves.
const ROUNDING: f64 = 2e-13;
/// |s′| over its largest on a panel below which ∂C/∂a is taken from a neighbouring point.
const NEAR_TURN: f64 = 0.3;

/// Newton's method, with ∂C/∂a of an edge moved at once where time is the chart, from values at the nodes; `enough`: the position error at
/// which it stops. None if it does not get there.
pub(super) fn solved(
    points: &Points,
    window: &mut Window,
    setting: &Setting<'_>,
    (chart, span): (Chart, f64),
    mut values: Vec<f64>,
    (target, enough): (Target, f64),
    firmness: Option<f64>,
) -> Option<Panel> {
    let p = points.p;
    let mut now = Instant::default();
    let mut last = f64::INFINITY;
    // The matrix of the last step, the step, and −r before it.
    let mut previous: Option<(Vec<f64>, Vec<f64>, Vec<f64>)> = None;
    for _ in 0..MOST_ITERATIONS {
        let segment = passed(points, setting, chart, span, &values, &[]);
        let mut residuals = vec![0.0; p + 1];
        let mut closures = vec![Closure::default(); p + 1];
        for i in 1..=p {
            let theta = points.nodes[i];
            setting.along(&segment.times, &segment.depths, theta, &mut now);
            let way = Way { panel: &segment, advances: setting.advances, theta };
            closures[i] = setting.excess(window, Some(way), &now, true);
            residuals[i] = closures[i].value - target.at(theta, now.time);
        }
        if !residuals.iter().all(|r| r.is_finite()) {
            return None;
        }
        let along = points.coefficients(&residuals);
        let slopes: Vec<[f64; 3]> =
            points.nodes.iter().map(|&x| [series(&segment.places, x).1, series(&segment.times, x).1, series(&along, x).1]).collect();
        let fastest = slopes.iter().map(|slope| slope[0].abs()).fold(0.0, f64::max);
        let firm = |i: usize| slopes[i][0].abs() >= NEAR_TURN * fastest;
        let by_edge: Vec<f64> = (1..=p)
            .map(|i| {
                let near = (1..=p).filter(|&k| firm(k)).min_by_key(|&k| k.abs_diff(i)).unwrap_or(i);
                let [place, time, residual] = slopes[near];
                let found = (residual - closures[near].rate * time) / place;
                // Beside a turn that is little over little.
                firmness.filter(|firm| !(0.5..2.0).contains(&(found / firm))).unwrap_or(found)
            })
            .collect();
        let stiffness = by_edge.iter().map(|c| c.abs()).sum::<f64>() / p as f64;
        let worst = residuals.iter().fold(0.0_f64, |worst, r| worst.max(r.abs()));
        if !stiffness.is_finite() {
            return None;
        }
        let residual = worst / stiffness;
        // A guess that happens to be good enough is that of every degree and tolerance: their distance would not show its error.
        if residual <= enough && previous.is_some() || worst <= ROUNDING * setting.scale {
            let tail = setting.scale / stiffness * tail(&segment, setting, window.zone);
            let end_residual = closures[p].value;
            return Some(Panel { chart, segment, stiffness, end_residual, tail });
        }
        if residual >= 4.0 * last {
            return None;
        }
        let right: Vec<f64> = residuals[1..].iter().map(|r| -r).collect();
        let slow = residual > SLOW * last;
        last = residual;
        if let (true, Some((matrix, step, before))) = (slow, &mut previous) {
            // What the last step made of the residuals, along it (Broyden): beside a turn the derivatives change within a step.
            let length: f64 = step.iter().map(|x| x * x).sum();
            for i in 0..p {
                let expected: f64 = (0..p).map(|j| matrix[i * p + j] * step[j]).sum();
                let miss = (before[i] - right[i] - expected) / length;
                (0..p).for_each(|j| matrix[i * p + j] += miss * step[j]);
            }
        } else {
            let mut matrix = vec![0.0; p * p];
            for i in 1..=p {
                for j in 1..=p {
                    let basis = |k: usize| points.inverse[k * (p + 1) + j];
                    let entry = &mut matrix[(i - 1) * p + j - 1];
                    *entry = match chart {
                        Chart::TimeOfPlace => (0..=p).map(|k| closures[i].by_times[k] * basis(k)).sum(),
                        Chart::PlaceOfTime => -0.5 * span * (0..=p).map(|k| closures[i].by_places[k] * basis(k)).sum::<f64>(),
                    };
                    if i == j {
                        *entry += if chart == Chart::TimeOfPlace { closures[i].rate } else { by_edge[i - 1] };
                    }
                }
            }
            previous = Some((matrix, Vec::new(), Vec::new()));
        }
        let Some((matrix, step, before)) = &mut previous else { return None };
        step.clone_from(&right);
        *before = right;
        if !solve(&mut matrix.clone(), step) {
            return None;
        }
        values[1..].iter_mut().zip(step.iter()).for_each(|(value, change)| *value += change);
    }
    None
}

/// What the last two coefficients of X hold of it, over the jump that the passage makes: a part of the field that the series may miss. A
/// term that fades within a short way of the edge counts by that way over the zone, and so does the panel itself: the closure is an integral
/// of the field over the zone.
pub(super) fn tail(segment: &Segment, setting: &Setting<'_>, zone: f64) -> f64 {
    let n = setting.chain.terms();
    let terms = if setting.advances { &setting.chain.relaxation } else { &setting.chain.creep };
    let speed = ((segment.place_at(1.0).0 - segment.place_at(-1.0).0) / (segment.time_at(1.0) - segment.time_at(-1.0))).abs();
    let seen = |rate: f64| (speed / (rate * zone)).min(1.0);
    let sum = |row: &[f64]| row[..n].iter().zip(terms).map(|(x, &(_, rate))| x.abs() * seen(rate)).sum::<f64>();
    let last = segment.states.chunks_exact(n + 1).rev().take(2).map(sum).fold(0.0, f64::max);
    let passed = segment.states.get(n).map_or(0.0, |value| value.abs());
    let jump = if setting.advances { passed * setting.chain.glassy } else { passed / setting.chain.glassy };
    // Without adhesion nothing jumps, and the series is of the displacement itself.
    let jump = if setting.adhesion.is_some() { jump } else { setting.scale * if setting.advances { setting.chain.glassy } else { 1.0 } };
    let way = (segment.high - segment.low).abs().max(f64::MIN_POSITIVE);
    if last > 0.0 { last / jump * (way / zone).min(1.0) } else { 0.0 }
}
