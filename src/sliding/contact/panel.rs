//! One panel of a process zone: a memory u of a field f, integrated over it by a discontinuous Galerkin step.
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
use nalgebra::{SMatrix, SVector};
use std::sync::LazyLock;

/// Nodes of a panel.
pub(super) const NODES: usize = 12;
/// Values at the nodes of a panel.
pub(super) type Values = SVector<f64, NODES>;
type Square = SMatrix<f64, NODES, NODES>;

/// What is common to all panels: nodes on [−1, 1], weights, differentiation, values at the ends.
struct Reference {
    nodes: [f64; NODES],
    weights: [f64; NODES],
    /// du/dτ with the inflow end weakly imposed, integrated forward and backward, and what the value there contributes.
    forward: Square,
    backward: Square,
    lifted_start: Values,
    lifted_end: Values,
    forward_inverse: Square,
    backward_inverse: Square,
    /// Values of the polynomial at the ends.
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
        let barycentric: Vec<f64> =
            (0..NODES).map(|i| 1.0 / (0..NODES).filter(|&j| j != i).map(|j| nodes[i] - nodes[j]).product::<f64>()).collect();
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
        let (at_start, at_end) = (values_at(-1.0), values_at(1.0));
        let lifted = |inflow: &Values| Values::from_fn(|i, _| inflow[i] / weights[i]);
        let (lifted_start, lifted_end) = (lifted(&at_start), lifted(&at_end));
        let forward = differentiate + lifted_start * at_start.transpose();
        let backward = lifted_end * at_end.transpose() - differentiate;
        // Neither is singular; were one so, the NaN would be found in every work.
        let inverse = |matrix: &Square| matrix.try_inverse().unwrap_or(Square::from_element(f64::NAN));
        let (forward_inverse, backward_inverse) = (inverse(&forward), inverse(&backward));
        Self { nodes, weights, forward, backward, lifted_start, lifted_end, forward_inverse, backward_inverse, at_start, at_end }
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

    /// Its length in x.
    fn extent(&self) -> f64 {
        self.weights.iter().sum()
    }
}

/// Which way a memory looks, and from where it is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    /// It remembers what lies nearer to the edge: known at the edge, integrated away from it.
    Nearer,
    /// It remembers what lies farther from the edge: known at the far end of the zone, integrated towards the edge.
    Farther,
    /// The same, known at the edge and integrated away from it; for layers not thinner than the zone.
    FartherFromEdge,
}

/// Panel length over the layer below which a step is a short Neumann series in it.
const WEAK: f64 = 1e-4;
/// What a Neumann series leaves out.
const SERIES_TOLERANCE: f64 = 1e-17;

/// The step of one panel for one layer.
#[derive(Debug, Clone)]
pub(super) struct Step {
    solver: Solver,
    strength: f64,
    towards_edge: bool,
}

/// How u follows.
#[derive(Debug, Clone)]
enum Solver {
    /// By the inverse of its matrix, which is near the identity or rules its diagonal: a product, and no digit less than by factors.
    Inverse(Box<Square>),
    /// A panel much thinner than its layer: by this many terms of a series, which needs no matrix of its own.
    Series { terms: u32, roots: [f64; NODES] },
}

impl Step {
    pub(super) fn new(panel: &Panel, layer: f64, direction: Direction) -> Self {
        let reference = &*REFERENCE;
        let towards_edge = direction == Direction::Farther;
        // λ with the sign of the direction of the integration.
        let strength = 2.0 * panel.half / layer * if direction == Direction::FartherFromEdge { -1.0 } else { 1.0 };
        let extent = panel.extent() / layer;
        let solver = if extent < WEAK {
            Solver::Series { terms: (SERIES_TOLERANCE.ln() / extent.ln()).ceil() as u32, roots: panel.roots }
        } else {
            let mut matrix = if towards_edge { reference.backward } else { reference.forward };
            for index in 0..NODES {
                matrix[(index, index)] += strength * panel.roots[index];
            }
            // A singular step leaves NaN, which is found in the work.
            Solver::Inverse(Box::new(matrix.try_inverse().unwrap_or(Square::from_element(f64::NAN))))
        };
        Self { solver, strength, towards_edge }
    }

    /// u at the nodes and at the outflow end from t·f at the nodes and u at the inflow end.
    pub(super) fn advance(&self, field_times_root: &Values, inflow_value: f64) -> (Values, f64) {
        let reference = &*REFERENCE;
        let (lifted, outflow, inverse) = if self.towards_edge {
            (&reference.lifted_end, &reference.at_start, &reference.backward_inverse)
        } else {
            (&reference.lifted_start, &reference.at_end, &reference.forward_inverse)
        };
        let source = field_times_root * self.strength + lifted * inflow_value;
        let values = match &self.solver {
            Solver::Inverse(inverse) => **inverse * source,
            Solver::Series { terms, roots } => {
                let mut values = inverse * source;
                for _ in 1..*terms {
                    let next = Values::from_fn(|i, _| source[i] - self.strength * roots[i] * values[i]);
                    values = inverse * next;
                }
                values
            }
        };
        let out = outflow.dot(&values);
        (values, out)
    }
}
