//! One panel of a process zone: a memory u of a field f, marched over it by a discontinuous Galerkin step.
//!
//! ```text
//! s du/dx = ±(f − u)        + : u remembers what lies nearer to the edge (x = 0),   − : what lies farther inside
//! ```
//! The variable t is √x in the half next to the edge and √(length − x) in the other, so that f·t, u and the field of the other side of the edge
//! are smooth; u is a polynomial of degree 11 in t. Any ratio of the layer s to the panel is admissible: the step is stable and of order 23
//! at its end, for layers that the panels resolve and for those far below them alike.
//!
//! | symbol | meaning |
//! |---|---|
//! | x, t, s | distance from the edge, its root (or that of the rest), layer thickness |
//! | λ | 2·half·σ/s: du/dτ = λ(t f − t u) over τ from −1 to 1 |

use crate::special::gauss_legendre::UNIT_RULE_12;
use nalgebra::{Const, LU, SMatrix, SVector};
use std::sync::LazyLock;

/// Nodes of a panel.
pub(super) const NODES: usize = 12;
/// Values at the nodes of a panel.
pub(super) type Values = SVector<f64, NODES>;
type Square = SMatrix<f64, NODES, NODES>;
type Factors = LU<f64, Const<NODES>, Const<NODES>>;

/// What is common to all panels: nodes on [−1, 1], weights, differentiation, values at the ends.
struct Reference {
    nodes: [f64; NODES],
    weights: [f64; NODES],
    differentiate: Square,
    at_start: Values,
    at_end: Values,
}

static REFERENCE: LazyLock<Reference> = LazyLock::new(Reference::new);

impl Reference {
    fn new() -> Self {
        let (mut nodes, mut weights) = ([0.0; NODES], [0.0; NODES]);
        for (index, &(node, weight)) in UNIT_RULE_12.iter().enumerate().take(NODES) {
            nodes[index] = 2.0 * node - 1.0;
            weights[index] = 2.0 * weight;
        }
        let barycentric: Vec<f64> = (0..NODES)
            .map(|i| 1.0 / (0..NODES).filter(|&j| j != i).map(|j| nodes[i] - nodes[j]).product::<f64>())
            .collect();
        let mut differentiate = Square::zeros();
        for i in 0..NODES {
            for j in 0..NODES {
                if i != j {
                    let entry = barycentric[j] / barycentric[i] / (nodes[i] - nodes[j]);
                    differentiate[(i, j)] = entry;
                    differentiate[(i, i)] -= entry;
                }
            }
        }
        let values_at = |x: f64| {
            let terms = Values::from_fn(|i, _| barycentric[i] / (x - nodes[i]));
            terms / terms.sum()
        };
        Self { nodes, weights, differentiate, at_start: values_at(-1.0), at_end: values_at(1.0) }
    }
}

/// A panel.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    /// Half its length in t.
    half: f64,
    /// t at the nodes, in the order of rising x.
    pub(super) roots: [f64; NODES],
    /// x at the nodes.
    pub(super) distances: [f64; NODES],
    /// Weights of an integral over dx.
    pub(super) weights: [f64; NODES],
}

impl Panel {
    /// The panel between two values of t; `inner`: in the half away from the edge of a zone of the given length.
    pub(super) fn new(low: f64, high: f64, inner: Option<f64>) -> Self {
        let reference = &*REFERENCE;
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let mut panel = Self { half, roots: [0.0; NODES], distances: [0.0; NODES], weights: [0.0; NODES] };
        for index in 0..NODES {
            // x rises as t falls in the inner half.
            let t = if inner.is_some() { middle - half * reference.nodes[index] } else { middle + half * reference.nodes[index] };
            panel.roots[index] = t;
            panel.distances[index] = inner.map_or(t * t, |length| length - t * t);
            panel.weights[index] = 2.0 * t * half * reference.weights[index];
        }
        panel
    }
}

/// Which way a memory looks, and from where it is marched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum March {
    /// It remembers what lies nearer to the edge: known at the edge, marched away from it.
    Nearer,
    /// It remembers what lies farther from the edge: known at the far end of the zone, marched towards the edge.
    Farther,
    /// The same, known at the edge and marched away from it; for layers not thinner than the zone.
    FartherFromEdge,
}

/// The factored step of one panel for one layer.
#[derive(Debug, Clone)]
pub(super) struct Step {
    factors: Factors,
    strength: f64,
    towards_edge: bool,
}

impl Step {
    pub(super) fn new(panel: &Panel, layer: f64, march: March) -> Self {
        let reference = &*REFERENCE;
        let towards_edge = march == March::Farther;
        // λ with the sign of the direction of the march.
        let strength = 2.0 * panel.half / layer * if march == March::FartherFromEdge { -1.0 } else { 1.0 };
        let inflow = if towards_edge { &reference.at_end } else { &reference.at_start };
        let orientation = if towards_edge { -1.0 } else { 1.0 };
        let matrix = Square::from_fn(|i, j| {
            let diagonal = if i == j { strength * panel.roots[i] } else { 0.0 };
            orientation * reference.differentiate[(i, j)] + inflow[i] * inflow[j] / reference.weights[i] + diagonal
        });
        Self { factors: matrix.lu(), strength, towards_edge }
    }

    /// u at the nodes and at the outflow end from t·f at the nodes and u at the inflow end.
    pub(super) fn advance(&self, field_times_root: &Values, inflow_value: f64) -> (Values, f64) {
        let reference = &*REFERENCE;
        let (inflow, outflow) =
            if self.towards_edge { (&reference.at_end, &reference.at_start) } else { (&reference.at_start, &reference.at_end) };
        let mut values =
            Values::from_fn(|i, _| self.strength * field_times_root[i] + inflow[i] * inflow_value / reference.weights[i]);
        // A singular step leaves NaN, which the caller finds in the work.
        if !self.factors.solve_mut(&mut values) {
            values.fill(f64::NAN);
        }
        let out = outflow.dot(&values);
        (values, out)
    }
}
