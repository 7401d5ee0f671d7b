//! A panel of the edge's path: its points, the segment that it makes, and Newton's method for it.
//!
//! A panel goes from the last point on, θ = −1…1, and is a polynomial of degree p through that point and p Radau points. One of two charts
//! is used, each with one unknown a point:
//! ```text
//! TimeOfPlace   s = span·(θ + 1)/2,  T(θ) unknown     smooth where the edge accelerates without limit (a fold: T′ = 0)
//! PlaceOfTime   T = span·(θ + 1)/2,  s(θ) unknown     smooth where the edge turns (s′ = 0)
//! ```

use super::chain::Chain;
use super::closure::{Closure, Way, Window};
use super::drive::{Branch, Instant};
use super::followed::State;
use super::force::force;
use super::gauss::{inverse, radau};
use super::line::{Line, SERIES, Segment, chebyshev, field, series};
use super::prescribed::RADIUS;
use crate::indentation::Profile;
use serde::{Deserialize, Serialize};

/// Which unknown a panel has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Chart {
    TimeOfPlace,
    PlaceOfTime,
}

/// Points of a panel of degree p, and of the states that it leaves.
#[derive(Debug, Clone)]
pub(super) struct Points {
    pub(super) p: usize,
    /// −1 and the Radau points.
    pub(super) nodes: Vec<f64>,
    /// Chebyshev coefficients of the polynomial through values at the nodes.
    pub(super) inverse: Vec<f64>,
    pub(super) samples: Vec<f64>,
    pub(super) fit: Vec<f64>,
}

/// States of passage are kept with so many more coefficients than the path: with p + 4 they add nothing to its error.
const MORE: usize = 4;

impl Points {
    pub(super) fn new(p: usize) -> Self {
        let mut nodes = vec![-1.0];
        nodes.extend(radau(p));
        let mut matrix = vec![0.0; (p + 1) * (p + 1)];
        for (row, &x) in matrix.chunks_exact_mut(p + 1).zip(&nodes) {
            chebyshev(x, row);
        }
        let m = p + MORE + 1;
        let angle = |k: usize| std::f64::consts::PI * (k as f64 + 0.5) / m as f64;
        let samples: Vec<f64> = (0..m).map(|k| angle(k).cos()).collect();
        let weight = |q: usize| if q == 0 { 1.0 } else { 2.0 } / m as f64;
        let fit = (0..m).flat_map(|q| (0..m).map(move |k| weight(q) * (q as f64 * angle(k)).cos())).collect();
        Self { p, inverse: inverse(&matrix, p + 1), nodes, samples, fit }
    }

    /// Chebyshev coefficients of values at the nodes.
    pub(super) fn coefficients(&self, values: &[f64]) -> Vec<f64> {
        self.inverse.chunks_exact(self.p + 1).map(|row| row.iter().zip(values).map(|(a, v)| a * v).sum()).collect()
    }
}

/// How the penetration goes: given in time, or as the path has it, from a state at the origin of the line.
#[derive(Clone, Copy)]
pub(super) enum Motion<'a> {
    Given(&'a Branch),
    /// With the branch of what is given instead.
    Followed(&'a State, &'a Branch),
}

/// What does not change within a panel.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub(super) chain: &'a Chain,
    pub(super) profile: &'a Profile,
    pub(super) line: &'a Line,
    pub(super) motion: Motion<'a>,
    /// Δγ; None for an edge without singularity.
    pub(super) adhesion: Option<f64>,
    /// What residuals are compared with: Δγ, or a displacement.
    pub(super) scale: f64,
    pub(super) advances: bool,
}

impl Setting<'_> {
    /// The drive at the origin of the line.
    pub(super) fn still(&self, instant: &mut Instant) {
        match self.motion {
            Motion::Given(branch) => branch.at(self.chain, self.line.time - branch.start, instant),
            Motion::Followed(state, _) => state.at(self.chain, instant),
        }
        instant.time = 0.0;
    }

    /// The drive at a point of a path T(θ), Δ(θ).
    pub(super) fn along(&self, times: &[f64], depths: &[f64], theta: f64, instant: &mut Instant) {
        let time = series(times, theta).0;
        match self.motion {
            Motion::Given(branch) => branch.at(self.chain, (self.line.time - branch.start) + time, instant),
            Motion::Followed(state, _) => state.along(self.chain, times, depths, theta, instant),
        }
        instant.time = time;
    }

    /// The sudden change of Δ that brings a control to its value; 0 where Δ is given.
    pub(super) fn imbalance(&self, way: Option<Way<'_>>, now: &Instant) -> f64 {
        let Motion::Followed(_, branch) = self.motion else { return 0.0 };
        let Some(control) = branch.control.filter(|control| *control != RADIUS) else { return 0.0 };
        let edge = self.line.edge + way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
        let force = force((self.chain, self.profile), self.line, way, now);
        let (target, _) = branch.value((self.line.time - branch.start) + now.time);
        (target - control.force * force - control.depth * now.depth) / (control.force * 2.0 * self.chain.glassy * edge + control.depth)
    }

    /// The drive after a sudden change of Δ.
    pub(super) fn shift(&self, now: &mut Instant, way: f64) {
        now.depth += way;
        now.base += self.chain.glassy * way;
        now.memory.iter_mut().zip(&self.chain.relaxation).for_each(|(memory, &(modulus, _))| *memory += modulus * way);
    }

    /// C − Δγ, or its like without adhesion, on the way or at the origin.
    pub(super) fn excess(&self, window: &mut Window, way: Option<Way<'_>>, now: &Instant, derivatives: bool) -> Closure {
        let solid = (self.chain, self.profile);
        match self.adhesion {
            Some(adhesion) => {
                let mut closure = window.closure(solid, self.line, way, now, derivatives);
                closure.value -= adhesion;
                closure
            }
            None => {
                let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
                window.smooth(solid, self.line, edge, self.advances, now)
            }
        }
    }
}

/// The segment that a path makes: the state of every point as the edge passes it.
pub(super) fn passed(points: &Points, setting: &Setting<'_>, chart: Chart, span: f64, values: &[f64], depths: &[f64]) -> Segment {
    let depths = if depths.is_empty() { Vec::new() } else { points.coefficients(depths) };
    let straight = vec![0.5 * span, 0.5 * span];
    let curved = points.coefficients(values);
    let (places, times) = if chart == Chart::TimeOfPlace { (straight, curved) } else { (curved, straight) };
    let chain = setting.chain;
    let n = chain.terms();
    let m = points.samples.len();
    let mut sampled = vec![0.0; m * (n + 1)];
    let mut now = Instant::default();
    let (mut before, mut after) = (vec![0.0; n], vec![0.0; n]);
    for (&theta, state) in points.samples.iter().zip(sampled.chunks_exact_mut(n + 1)) {
        let (s, t) = (series(&places, theta).0, series(&times, theta).0);
        setting.along(&times, &depths, theta, &mut now);
        let height = setting.profile.line(setting.line.edge + s);
        let old = setting.line.at(!setting.advances, s);
        let old_theta = old.theta_at(s);
        state[n] = field(chain, !setting.advances, old, old_theta, height, &now).value;
        let depth = now.depth - height;
        let kept = |j: usize, terms: &[(f64, f64)]| {
            if old.blank { 0.0 } else { (-(t - old.time_at(old_theta)) * terms[j].1).exp() * old.state_at(n, j, old_theta) }
        };
        if setting.advances {
            (0..n).for_each(|j| before[j] = kept(j, &chain.creep));
            chain.dashpots(&before, &mut after);
            for i in 0..n {
                state[i] = chain.relaxation[i].0 * (depth - after[i]) - now.memory[i];
            }
        } else {
            (0..n).for_each(|i| before[i] = depth - (kept(i, &chain.relaxation) + now.memory[i]) / chain.relaxation[i].0);
            chain.voigt(&before, &mut after);
            state[..n].copy_from_slice(&after);
        }
    }
    let mut states = vec![0.0; m * (n + 1)];
    for (row, weights) in states.chunks_exact_mut(n + 1).zip(points.fit.chunks_exact(m)) {
        for (values, weight) in sampled.chunks_exact(n + 1).zip(weights) {
            row.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
        }
    }
    let end = series(&places, 1.0).0;
    let (low, high, theta_low, theta_high) = if setting.advances { (0.0, end, -1.0, 1.0) } else { (end, 0.0, 1.0, -1.0) };
    let is_straight = chart == Chart::TimeOfPlace;
    Segment { low, high, theta_low, theta_high, place: 0.0, time: 0.0, blank: false, straight: is_straight, places, times, depths, states }
}

/// The path beyond the end of a segment of it, as values at the points of a next panel: along the cubic through its last part; and Δ there,
/// if it follows.
pub(super) fn continued(points: &Points, previous: &Segment, theta: f64, chart: Chart, span: f64) -> (Vec<f64>, Vec<f64>) {
    let wide = 0.5 * (theta + 1.0);
    let knots: [f64; 4] = std::array::from_fn(|k| theta - wide * k as f64 / 1.5);
    let known = knots.map(|knot| {
        let (s, t) = (previous.place_at(knot).0, previous.time_at(knot));
        let (given, sought) = if chart == Chart::TimeOfPlace { (s, t) } else { (t, s) };
        [given, sought, series(&previous.depths, knot).0]
    });
    let value = |x: f64, which: usize| {
        let weight = |k: usize| {
            let others = (0..4).filter(|&l| l != k);
            others.map(|l| (x - (known[l][0] - known[0][0])) / (known[k][0] - known[l][0])).product::<f64>()
        };
        (0..4).map(|k| weight(k) * (known[k][which] - known[0][which])).sum::<f64>()
    };
    let at = |which: usize| points.nodes.iter().map(|&x| value(0.5 * span * (x + 1.0), which)).collect::<Vec<f64>>();
    let depths = if previous.depths.is_empty() { Vec::new() } else { at(2).iter().map(|way| known[0][2] + way).collect() };
    (at(1), depths)
}

const _: () = assert!(SERIES >= 11 + MORE);
