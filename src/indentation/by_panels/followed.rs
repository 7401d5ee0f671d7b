//! A penetration that is not given: force, frame, or any mix of both.
//!
//! ```text
//! c_F F + c_D Δ = target(t)          force: c_F = 1, c_D = 0;     frame of stiffness k_f: c_F = 1/k_f, c_D = 1
//! ```
//! Δ is a second polynomial of the panel, with one more unknown a point and this as one more residual. Its memory P_i along the panel is
//! P_i(θ) = e^{−T/ρ_i}P_i(origin) + E_i∫ e^{−(T−T′)/ρ_i} Δ′ dθ′, by quadrature graded towards θ. A sudden Δ shifts P_i by E_i, Q by E∞, F
//! by 2E∞a, and no X.

use super::chain::Chain;
use super::closure::{Way, Window};
use super::drive::Instant;
use super::force::force;
use super::gauss::{Gauss, solve};
use super::line::{FADED, series};
use super::newton::{Panel, Target, tail};
use super::path::{Chart, Points, Setting, passed};
use serde::{Deserialize, Serialize};

/// Δ, its rate and P_i at the origin of the line.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct State {
    pub(super) depth: f64,
    pub(super) rate: f64,
    pub(super) memory: Vec<f64>,
}

/// c_F and c_D.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Control {
    pub(super) force: f64,
    pub(super) depth: f64,
}

impl State {
    /// The instant of the state itself.
    pub(super) fn at(&self, chain: &Chain, instant: &mut Instant) {
        (instant.depth, instant.rate) = (self.depth, self.rate);
        instant.memory.clone_from(&self.memory);
        summed(chain, instant);
    }

    /// The instant at a parameter of a path that starts with the state.
    pub(super) fn along(&self, chain: &Chain, times: &[f64], depths: &[f64], theta: f64, instant: &mut Instant) {
        if depths.is_empty() {
            // A sudden way takes no time.
            return self.at(chain, instant);
        }
        let (time, speed) = series(times, theta);
        let (depth, rate) = series(depths, theta);
        (instant.depth, instant.rate) = (depth, rate / speed);
        instant.memory.clear();
        instant.memory.extend(self.memory.iter().zip(&chain.relaxation).map(|(before, &(_, rate))| before * (-time * rate).exp()));
        let scene = Memory { gauss: Gauss::get(), chain, times, depths, now: time };
        scene.add((-1.0, theta), &mut instant.memory, 60);
        summed(chain, instant);
    }

    /// A sudden change of Δ.
    pub(super) fn shift(&mut self, chain: &Chain, way: f64) {
        self.depth += way;
        self.memory.iter_mut().zip(&chain.relaxation).for_each(|(memory, &(modulus, _))| *memory += modulus * way);
    }
}

fn summed(chain: &Chain, instant: &mut Instant) {
    instant.base = chain.relaxed * instant.depth + instant.memory.iter().sum::<f64>();
    let faded: f64 = instant.memory.iter().zip(&chain.relaxation).map(|(memory, &(_, rate))| memory * rate).sum();
    instant.base_rate = chain.glassy * instant.rate - faded;
}

struct Memory<'a> {
    gauss: &'static Gauss,
    chain: &'a Chain,
    times: &'a [f64],
    depths: &'a [f64],
    now: f64,
}

impl Memory<'_> {
    fn add(&self, (from, to): (f64, f64), memory: &mut [f64], cuts: u32) {
        let [shortest, longest] = self.chain.times(true);
        let lag = |theta: f64| (self.now - series(self.times, theta).0).abs().clamp(0.5 * shortest, FADED * longest);
        let (first, second) = (lag(from), lag(to));
        if cuts > 0 && first.max(second) > 5.0 * first.min(second) {
            let middle = from + if first < second { 0.25 } else { 0.75 } * (to - from);
            self.add((from, middle), memory, cuts - 1);
            return self.add((middle, to), memory, cuts - 1);
        }
        for (x, weight) in self.gauss.nodes.iter().zip(self.gauss.weights) {
            let theta = from + (to - from) * x;
            let lag = self.now - series(self.times, theta).0;
            let rise = weight * (to - from) * series(self.depths, theta).1;
            for (memory, &(modulus, rate)) in memory.iter_mut().zip(&self.chain.relaxation) {
                *memory += modulus * rise * (-lag * rate).exp();
            }
        }
    }
}

/// Newton's iterations; the derivatives are differences and serve for all of them while they converge.
const MOST_ITERATIONS: u32 = 12;
/// A difference, in parts of the unknown's own scale; of a place in parts of itself, for beside a turn the first ones are next to nothing and have a root
/// behind them; and the least one, in process zones.
const DIFFERENCE: f64 = 1e-6;
const OF_ITSELF: f64 = 1e-4;
const LEAST_DIFFERENCE: f64 = 1e-12;
/// Duration of a panel, over the shortest time of the solid, in which nothing relaxes.
const FROZEN: f64 = 1e-9;
/// Part of what the edge may leave that the control may: it costs nothing to hold it better.
const FORCE: f64 = 1e-2;
/// What rounding leaves of a control, as a part of the penetration, and of C over Δγ.
const ROUNDING: f64 = 2e-15;
const CLOSURE_ROUNDING: f64 = 2e-13;

/// A panel of edge and penetration, from values of both at the points; `target` at a time since the origin.
pub(super) fn solved_with_depth(
    points: &Points,
    window: &mut Window,
    setting: &Setting<'_>,
    (control, target): (Control, &dyn Fn(f64) -> f64),
    (chart, span): (Chart, f64),
    (mut values, mut depths): (Vec<f64>, Vec<f64>),
    (goal, enough): (Target, f64),
) -> Option<Panel> {
    let p = points.p;
    // Of F or its like by Δ, at once.
    let firmness = |edge: f64| control.force * 2.0 * setting.chain.glassy * edge + control.depth;
    let residuals = |window: &mut Window, values: &[f64], depths: &[f64]| -> (Vec<f64>, super::line::Segment) {
        let segment = passed(points, setting, chart, span, values, depths);
        let mut found = vec![0.0; 2 * p];
        let mut now = Instant::default();
        for i in 1..=p {
            let theta = points.nodes[i];
            let way = Some(Way { panel: &segment, advances: setting.advances, theta });
            setting.along(&segment.times, &segment.depths, theta, &mut now);
            let excess = setting.excess(window, way, &now, false).value;
            found[i - 1] = excess - goal.at(theta, now.time);
            let force = force((setting.chain, setting.profile), setting.line, way, &now);
            let edge = setting.line.edge + segment.place_at(theta).0;
            found[p + i - 1] = (control.force * force + control.depth * now.depth - target(now.time)) / firmness(edge);
        }
        (found, segment)
    };
    let (mut found, mut segment) = residuals(window, &values, &depths);
    let mut matrix: Vec<f64> = Vec::new();
    let mut last = f64::INFINITY;
    let zone = window.zone;
    let reach = values.iter().fold(f64::MIN_POSITIVE, |far, value| far.max(value.abs()));
    let ahead = if setting.advances { 1.0 } else { -1.0 };
    let difference = |value: f64| match chart {
        Chart::TimeOfPlace => DIFFERENCE * reach,
        Chart::PlaceOfTime => ahead * (DIFFERENCE * reach).min(OF_ITSELF * value.abs()).max(LEAST_DIFFERENCE * zone),
    };
    let sink = depths.iter().map(|depth| (depth - depths[0]).abs()).fold(1e-6 * depths[0].abs(), f64::max);
    let depth_scale = depths[0].abs() + setting.profile.line(setting.line.edge);
    let mut stiffness = setting.scale / window.zone;
    for _ in 0..MOST_ITERATIONS {
        if !found.iter().all(|value| value.is_finite()) {
            return None;
        }
        let worst = found[..p].iter().fold(0.0_f64, |worst, r| worst.max(r.abs())) / stiffness;
        let off = found[p..].iter().fold(0.0_f64, |worst, r| worst.max(r.abs()));
        // As a part of what it acts upon, or rounding.
        let allowed = (FORCE * (enough * stiffness / setting.scale) * sink).max(ROUNDING * depth_scale);
        let size = (worst / enough.max(CLOSURE_ROUNDING * setting.scale / stiffness)).max(off / allowed);
        if size <= 1.0 && !matrix.is_empty() {
            let mut now = Instant::default();
            setting.along(&segment.times, &segment.depths, 1.0, &mut now);
            let way = Some(Way { panel: &segment, advances: setting.advances, theta: 1.0 });
            let end_residual = setting.excess(window, way, &now, false).value;
            let tail = setting.scale / stiffness * tail(&segment, setting, window.zone);
            return Some(Panel { chart, segment, stiffness, end_residual, tail });
        }
        if matrix.is_empty() || size > 0.2 * last {
            if size > 4.0 * last {
                return None;
            }
            matrix = vec![0.0; 4 * p * p];
            for j in 0..2 * p {
                let (mut values, mut depths) = (values.clone(), depths.clone());
                let step = if j < p { difference(values[j + 1]) } else { DIFFERENCE * sink };
                if j < p {
                    values[j + 1] += step
                } else {
                    depths[j - p + 1] += step
                }
                let (moved, _) = residuals(window, &values, &depths);
                for i in 0..2 * p {
                    matrix[i * 2 * p + j] = (moved[i] - found[i]) / step;
                }
            }
            // ∂C/∂a at fixed history: of a time, along the path. Where nothing relaxes C depends on time through Δ alone.
            let [shortest, _] = setting.chain.times(true);
            let frozen = setting.chain.terms() == 0 || (segment.time_at(1.0) - segment.time_at(-1.0)).abs() < FROZEN * shortest;
            let slope = |i: usize| {
                let theta = points.nodes[i + 1];
                let diagonal = matrix[i * 2 * p + i];
                let duration = series(&segment.times, theta).1;
                let by_depth = if frozen { matrix[i * 2 * p + p + i] * series(&segment.depths, theta).1 / duration } else { 0.0 };
                let speed = series(&segment.places, theta).1 / duration;
                (if chart == Chart::TimeOfPlace { (diagonal + by_depth) / speed } else { diagonal }).abs()
            };
            stiffness = (0..p).map(slope).sum::<f64>() / p as f64;
        }
        last = size;
        let mut right: Vec<f64> = found.iter().map(|value| -value).collect();
        if !solve(&mut matrix.clone(), &mut right) {
            return None;
        }
        for i in 0..p {
            values[i + 1] += right[i];
            depths[i + 1] += right[p + i];
        }
        (found, segment) = residuals(window, &values, &depths);
    }
    None
}
