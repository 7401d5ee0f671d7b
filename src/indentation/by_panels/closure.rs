//! The closure C = Δγ and its derivatives: a product of the fields in the process zone.
//!
//! ```text
//! C = (1/π²δ) ∫₀^δ dy D(a+δ−y) G(y),   G(y) = −Q(a−y) k(δ−y, y) + Σ_p c_p(δ−y) A_p(y),   A_p(y) = ∫₀^y Q(a−y′) T_p′(y′) dy′,   k = Σ_p
//! c_p(η) T_p(ξ)
//! ```
//! (the form ∫K dμ/√(ss′) integrated by parts: jumps of Q need no care). C is linear in D and in Q, so one backward pass over the nodes
//! gives its derivatives by every value of D and of Q, and with the exact memory of the fields those by the instants of the panel under
//! way.

use super::chain::Chain;
use super::drive::Instant;
use super::gauss::{Gauss, NODES};
use super::kernel::{Kernel, MOST};
use super::line::{Field, Line, SERIES, Segment, chebyshev, field};
use super::window::Scene;
use crate::indentation::Profile;
use std::f64::consts::PI;

/// A node of the window.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Node {
    pub(super) y: f64,
    /// dy over the piece's own parameter, of the whole piece.
    pub(super) width: f64,
    pub(super) inner: Field,
    pub(super) outer: Field,
    /// θ on the panel under way, and ds/dθ there; NaN elsewhere.
    pub(super) theta: f64,
    pub(super) slope: f64,
}

/// The panel under way up to a parameter: it advances (grows the inside) or recedes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way<'a> {
    pub(super) panel: &'a Segment,
    pub(super) advances: bool,
    pub(super) theta: f64,
}

/// What a closure is.
#[derive(Debug, Clone, Default)]
pub(super) struct Closure {
    pub(super) value: f64,
    /// ∂C/∂t with all passages as they are.
    pub(super) rate: f64,
    /// Derivatives by the Chebyshev coefficients of T(θ) of the panel under way, and by those of s(θ) at fixed t, over −dT/dθ.
    pub(super) by_times: [f64; SERIES],
    pub(super) by_places: [f64; SERIES],
}

/// Workspace and work counters.
#[derive(Debug, Clone, Default)]
pub(super) struct Window {
    pub(super) zone: f64,
    /// Displacement that it may miss at a break of the profile.
    pub(super) blur: f64,
    pub(super) kernel: Kernel,
    pub(super) nodes: Vec<Node>,
    /// c_p and T_p′ at the nodes, rank after rank.
    pub(super) rows: Vec<f64>,
    pub(super) slopes: Vec<f64>,
    pub(super) closures: u64,
    pub(super) kernel_nodes: u64,
}

impl Window {
    pub(super) fn new(zone: f64) -> Self {
        Self { zone, ..Self::default() }
    }

    /// C at the edge (relative to the line's origin) at an instant; derivatives only if asked.
    pub(super) fn closure(
        &mut self,
        (chain, profile): (&Chain, &Profile),
        line: &Line,
        way: Option<Way<'_>>,
        now: &Instant,
        derivatives: bool,
    ) -> Closure {
        let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
        let scene = Scene { chain, profile, origin: line.edge, edge, zone: self.zone, now };
        self.nodes.clear();
        self.kernel.set(line.edge + edge, self.zone);
        let zone = self.zone;
        match way {
            None => self.between(&scene, line, 0.0, zone),
            Some(way) if way.advances => {
                let (end, theta) = if edge < zone { (edge, -1.0) } else { (zone, way.panel.theta_at(edge - zone)) };
                self.along(&scene, line, way, (way.theta, theta), (0.0, end));
                if edge < zone {
                    self.between(&scene, line, edge, zone);
                }
            }
            Some(way) => {
                let start = zone + edge;
                if start > 0.0 {
                    self.between(&scene, line, 0.0, start);
                }
                let theta = if start > 0.0 { -1.0 } else { way.panel.theta_at(edge + zone) };
                self.along(&scene, line, way, (theta, way.theta), (start.max(0.0), zone));
            }
        }
        self.closures += 1;
        self.kernel_nodes += self.nodes.len() as u64;
        match self.kernel.rank {
            8 => self.summed::<8>(derivatives),
            16 => self.summed::<16>(derivatives),
            _ => self.summed::<MOST>(derivatives),
        }
    }

    /// The condition of an edge without adhesion, as a displacement that has the sign of C − Δγ: D(a) if it advances, −Q(a)/E∞* if it
    /// recedes, of the side that the edge moves into.
    pub(super) fn smooth(
        &mut self,
        (chain, profile): (&Chain, &Profile),
        line: &Line,
        edge: f64,
        advances: bool,
        now: &Instant,
    ) -> Closure {
        let segment = line.at(!advances, edge);
        let found = field(chain, !advances, segment, segment.theta_at(edge), profile.line(line.edge + edge), now);
        self.closures += 1;
        let factor = if advances { 1.0 } else { -chain.glassy.recip() };
        Closure { value: factor * found.value, rate: factor * found.rate, ..Closure::default() }
    }

    /// The sums over the nodes, forwards for the value, backwards for the derivatives.
    pub(super) fn summed<const R: usize>(&mut self, derivatives: bool) -> Closure {
        self.rows.clear();
        self.slopes.clear();
        let mut prefix = [0.0; R];
        let rule = Gauss::get();
        let mut closure = Closure::default();
        let scale = 1.0 / (PI * PI * self.zone);
        let (mut rows, mut slopes) = ([[0.0; R]; NODES], [[0.0; R]; NODES]);
        for start in (0..self.nodes.len()).step_by(NODES) {
            for ((row, slope), node) in rows.iter_mut().zip(&mut slopes).zip(&self.nodes[start..]) {
                *row = self.kernel.row::<R>(self.zone - node.y);
                *slope = self.kernel.slopes::<R>(node.y);
            }
            if derivatives {
                self.rows.extend(rows.as_flattened());
                self.slopes.extend(slopes.as_flattened());
            }
            let loads: [f64; NODES] = std::array::from_fn(|h| self.nodes[start + h].inner.value * self.nodes[start + h].width);
            for (g, row) in rows.iter().enumerate() {
                let node = &self.nodes[start + g];
                let mut running = prefix;
                for h in 0..NODES {
                    add(&mut running, loads[h] * rule.running[g][h], &slopes[h]);
                }
                let seen = dot(&running, row) - node.inner.value * self.kernel.local(node.y);
                let weight = scale * node.width * rule.weights[g];
                closure.value += weight * node.outer.value * seen;
                if derivatives {
                    closure.rate += weight * seen * node.outer.rate;
                    self.passage(&mut closure, start + g, weight * seen * node.outer.memory);
                }
            }
            for h in 0..NODES {
                add(&mut prefix, loads[h] * rule.weights[h], &slopes[h]);
            }
        }
        if derivatives {
            self.backwards::<R>(&mut closure, scale);
        }
        closure
    }

    /// Derivatives by Q.
    pub(super) fn backwards<const R: usize>(&self, closure: &mut Closure, scale: f64) {
        let mut later = [0.0; R];
        let rule = Gauss::get();
        let (rows, _) = self.rows.as_chunks::<R>();
        let (slopes, _) = self.slopes.as_chunks::<R>();
        for start in (0..self.nodes.len()).step_by(NODES).rev() {
            let gaps: [f64; NODES] = std::array::from_fn(|g| {
                let node = &self.nodes[start + g];
                scale * node.width * rule.weights[g] * node.outer.value
            });
            for h in 0..NODES {
                let node = &self.nodes[start + h];
                let mut seen = later.map(|sum| sum * rule.weights[h]);
                for g in 0..NODES {
                    add(&mut seen, gaps[g] * rule.running[g][h], &rows[start + g]);
                }
                let by_load = dot(&seen, &slopes[start + h]) * node.width - gaps[h] * self.kernel.local(node.y);
                closure.rate += by_load * node.inner.rate;
                self.passage(closure, start + h, by_load * node.inner.memory);
            }
            for g in 0..NODES {
                add(&mut later, gaps[g], &rows[start + g]);
            }
        }
    }

    /// Adds the derivative by the instant at which the edge passed a node of the panel under way.
    pub(super) fn passage(&self, closure: &mut Closure, node: usize, by_time: f64) {
        let node = &self.nodes[node];
        if by_time == 0.0 || node.theta.is_nan() {
            return;
        }
        let mut basis = [0.0; SERIES];
        chebyshev(node.theta, &mut basis);
        for ((times, places), b) in closure.by_times.iter_mut().zip(&mut closure.by_places).zip(basis) {
            *times += by_time * b;
            *places += by_time / node.slope * b;
        }
    }
}

pub(super) fn add<const R: usize>(sums: &mut [f64; R], factor: f64, row: &[f64; R]) {
    sums.iter_mut().zip(row).for_each(|(sum, value)| *sum += factor * value);
}

pub(super) fn dot<const R: usize>(one: &[f64; R], two: &[f64; R]) -> f64 {
    one.iter().zip(two).map(|(x, y)| x * y).sum()
}
