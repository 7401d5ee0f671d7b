//! A contact radius that is given: the path of the edge is known, the penetration is sought.
//!
//! ```text
//! C(a(t), Δ) = Δγ          one unknown a point, Δ; the path a(t) is imposed exactly, in the chart a(t)
//! ```
//! The edge has no event of its own: panels end at corners of the history and on jumps of the state of the line. An edge that is held recedes by [`HELD`] of the
//! zone, so that a hold is a panel like any other.

use super::chain::Chain;
use super::closure::{Way, Window};
use super::drive::{Branch, Instant};
use super::followed::Control;
use super::gauss::solve;
use super::integration::Integration;
use super::line::{Line, Segment};
use super::newton::{Panel, tail};
use super::path::{Chart, Points, Setting, continued, passed};
use super::problem::{End, Problem};
use super::start::breaks;

/// c_F and c_D of a radius: it is neither a force nor a penetration.
pub(super) const RADIUS: Control = Control { force: 0.0, depth: 0.0 };
/// Way of an edge that is held, in process zones: far below any tolerance.
const HELD: f64 = 1e-10;
/// First panel: its way in process zones, and its part of the time left.
const FIRST_WAY: f64 = 0.05;
const FIRST_TIME: f64 = 1e-3;
/// Newton's iterations; C is a quadratic in Δ.
const MOST_ITERATIONS: u32 = 12;
/// A difference of Δ: within this part of the displacement at the edge C is straight, and far above its rounding.
const DIFFERENCE: f64 = 1e-4;
/// What Newton's method may leave, and what a panel may miss between its points, in tolerances.
const LEFT: f64 = 5e-3;
/// A step that leaves more of the residual than this asks for another matrix.
const SLOW: f64 = 0.2;
/// Rounding of C over Δγ.
const ROUNDING: f64 = 1e-13;
/// Shortest panel over the time.
const SHORTEST: f64 = 1e-12;

/// The penetration of a radius in elastic equilibrium, of modulus E*, under tension.
pub(super) fn depth_of(problem: &Problem, modulus: f64, edge: f64) -> Option<f64> {
    let work = problem.adhesion?;
    let profile = &problem.profile;
    let chain = Chain::new(modulus, modulus, &[], &[]);
    let line = Line::new(edge, &breaks(profile, edge));
    let mut window = Window::new(problem.zone);
    let height = profile.line(edge);
    let mut excess = |pull: f64| {
        let now = Instant { depth: height - pull, base: modulus * (height - pull), ..Instant::default() };
        window.closure((&chain, profile), &line, None, &now, false).value - work
    };
    let (mut low, mut high) = (0.0, (work * edge / modulus).sqrt());
    while excess(high) < 0.0 {
        (low, high) = (high, 2.0 * high);
        if !high.is_finite() {
            return None;
        }
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    Some(height - 0.5 * (low + high))
}

impl Integration<'_> {
    /// Whether the segment under way gives the radius.
    pub(super) fn is_prescribed(&self) -> bool {
        self.branch.control == Some(RADIUS)
    }

    /// A panel of a given radius, accepted or refused.
    pub(super) fn prescribed(&mut self) -> Option<End> {
        let zone = self.problem.zone;
        let (left, rate) = (self.branch.end - self.line.time, self.branch.rate);
        let held = rate * left == 0.0 || (rate * left).abs() < HELD * zone;
        let advances = rate > 0.0 && !held;
        let from = self.line.edge;
        let end = self.branch.end - self.branch.start;
        let start = self.line.time - self.branch.start;
        // Off by what rounding left of the last panel at most.
        let way = |branch: &Branch, time: f64| {
            if held { -HELD * zone * time / left } else { branch.value((start + time).min(2.0 * end)).0 - branch.value(start).0 }
        };
        if self.previous.is_none() {
            let first = if held { FIRST_TIME * left } else { (FIRST_WAY * zone / rate.abs()).min(left) };
            self.span = (Chart::PlaceOfTime, first);
            let state = self.state.clone()?;
            // As if it had come here as fast.
            let (turn, sink) = (way(&self.branch, first), state.rate * first);
            let (places, times, depths) = (vec![-turn, turn], vec![-first, first], vec![state.depth - sink, sink]);
            self.previous = Some((advances, Segment { places, times, depths, ..Segment::blank(0.0, 0.0) }, 1.0));
        }
        let mut span = self.span.1.min(left);
        if !held {
            let (kink, strong, _) = self.next_kink(advances);
            let until = kink / rate;
            if strong && span > 0.6 * until {
                span = if span < until { 0.5 * until } else { until };
            }
            let least = (super::jump::FLOOR * zone - from) / rate;
            if rate < 0.0 && span >= least {
                if least <= SHORTEST * self.line.time {
                    return Some(End::Floor);
                }
                span = least;
            }
        }
        let (_, previous, theta) = self.previous.clone()?;
        let (_, depths) = continued(&self.points, &previous, theta, Chart::PlaceOfTime, span);
        let values: Vec<f64> = self.points.nodes.iter().map(|x| way(&self.branch, 0.5 * span * (x + 1.0))).collect();
        let allowed = self.problem.tolerance * self.displacement();
        let mut window = std::mem::take(&mut self.window);
        let found =
            solved_depth(&self.points, &mut window, &self.setting(advances), span, (values, depths), (self.start_residual, allowed));
        self.window = window;
        let factor = match &found {
            None => 0.3,
            Some((_, missed)) => (0.85 * (allowed / missed.max(1e-300)).powf(1.0 / (self.points.p as f64 + 1.0))).clamp(0.3, 3.0),
        };
        let Some((panel, missed)) = found.filter(|(_, missed)| *missed <= allowed) else {
            self.outcome.refused += 1;
            self.span = (Chart::PlaceOfTime, factor.min(0.9) * span);
            return (span < SHORTEST * self.line.time.max(left)).then_some(End::Failed);
        };
        self.outcome.panels += 1;
        self.panel_residual = (missed / allowed * self.problem.tolerance).max(panel.end_residual.abs() / self.scale());
        self.start_residual = panel.end_residual;
        let (piece, prescribed) = (self.piece, self.branch.start.to_bits());
        let ended = self.accept(advances, panel, factor, false);
        if self.piece == piece && self.branch.start.to_bits() == prescribed {
            self.span = (Chart::PlaceOfTime, factor * span);
        }
        ended
    }
}

/// A panel of Δ along a given path, and how far Δ is off between its points at most.
fn solved_depth(
    points: &Points,
    window: &mut Window,
    setting: &Setting<'_>,
    span: f64,
    (values, mut depths): (Vec<f64>, Vec<f64>),
    (start_residual, allowed): (f64, f64),
) -> Option<(Panel, f64)> {
    let p = points.p;
    let mut now = Instant::default();
    let mut at = |window: &mut Window, segment: &Segment, theta: f64| {
        let way = Way { panel: segment, advances: setting.advances, theta };
        setting.along(&segment.times, &segment.depths, theta, &mut now);
        // What the last cut left fades over the panel.
        setting.excess(window, Some(way), &now, false).value - 0.5 * (1.0 - theta) * start_residual
    };
    let mut residuals = |window: &mut Window, depths: &[f64]| {
        let segment = passed(points, setting, Chart::PlaceOfTime, span, &values, depths);
        let found: Vec<f64> = points.nodes[1..].iter().map(|&theta| at(window, &segment, theta)).collect();
        (found, segment)
    };
    let step = DIFFERENCE * (setting.scale * setting.line.edge / setting.chain.glassy).sqrt();
    let (mut firmness, mut last) = (0.0, f64::INFINITY);
    // One matrix serves as long as it leads on.
    let mut matrix: Vec<f64> = Vec::new();
    for _ in 0..MOST_ITERATIONS {
        let (found, segment) = residuals(window, &depths);
        if !found.iter().all(|value| value.is_finite()) {
            return None;
        }
        let worst = found.iter().fold(0.0_f64, |worst, value| worst.max(value.abs()));
        if firmness > 0.0 && (worst <= LEFT * allowed * firmness || worst <= ROUNDING * setting.scale) {
            let nodes = &points.nodes;
            let missed = [0, p / 2, p - 1].into_iter().map(|gap| at(window, &segment, 0.5 * (nodes[gap] + nodes[gap + 1])).abs());
            let missed = missed.fold(0.0, f64::max) / firmness;
            // A part of the displacement, as the tolerance is.
            let tail = tail(&segment, setting, window.zone) * (setting.scale * setting.line.edge / setting.chain.glassy).sqrt();
            let end_residual = at(window, &segment, 1.0);
            // ∂C/∂a is asked for by nothing here.
            let panel = Panel { chart: Chart::PlaceOfTime, segment, stiffness: setting.scale / window.zone, end_residual, tail };
            return Some((panel, missed.max(tail)));
        }
        let slow = worst > SLOW * last;
        last = worst;
        if slow || matrix.is_empty() {
            matrix = vec![0.0; p * p];
            for j in 0..p {
                let mut moved = depths.clone();
                moved[j + 1] += step;
                let (after, _) = residuals(window, &moved);
                (0..p).for_each(|i| matrix[i * p + j] = (after[i] - found[i]) / step);
            }
            firmness = (0..p).map(|i| matrix[i * p + i].abs()).sum::<f64>() / p as f64;
        }
        let mut change: Vec<f64> = found.iter().map(|value| -value).collect();
        if !solve(&mut matrix.clone(), &mut change) {
            return None;
        }
        depths[1..].iter_mut().zip(&change).for_each(|(depth, change)| *depth += change);
    }
    None
}
