//! Whether a state stays where it is under what is held.
//!
//! A disturbance that grows without oscillating passes through rest at a fold: there the linearised steady equations are singular. On the
//! way from a very fast disturbance, which meets a stiffer body, to a very slow one each growing disturbance leaves one negative
//! eigenvalue of these equations. They are counted by Arnoldi's method at a held mean gap, on the equations times a symmetric positive operator:
//! without the law all eigenvalues lie right of the imaginary axis, so that few products find those on the left. One more solve gives
//! d(mean pressure)/d(mean gap) along the branch: a held pressure or a frame adds one growing disturbance where the pressure rises with the
//! gap faster than the frame's.

use super::gmres;
use super::grid::{Equations, State, mean};
use super::problem::Problem;
use super::steady::SteadyState;
use crate::sliding::branch::Stability;
use nalgebra::{DMatrix, Schur};

/// Sizes of the Krylov space at which the eigenvalues are looked at: two in a row must agree.
const SIZES: [usize; 7] = [12, 18, 27, 40, 60, 90, 135];
/// Relative change of the eigenvalue nearest to the imaginary axis that two in a row may show.
const AGREEMENT: f64 = 0.2;
/// The Krylov space is complete where the next vector is this part of the largest entry.
const COMPLETE: f64 = 1e-9;
/// Relative residual of d(mean pressure)/d(mean gap).
const SLOPE: f64 = 1e-5;
/// Vectors and products of that solve.
const RESTART: usize = 80;
const PRODUCTS: usize = 400;

/// The stability of a state on one grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OnGrid {
    /// Growing disturbances at a held mean gap; none where they are not certain.
    growing: Option<usize>,
    /// d(mean pressure)/d(mean gap) along the branch.
    pressure_by_gap: Option<f64>,
    /// Products, each times the nodes.
    node_products: usize,
}

impl OnGrid {
    /// Of a state of these equations; their control is replaced.
    pub(super) fn of(equations: &mut Equations, state: &State) -> Self {
        let before = equations.products;
        equations.linearise(state);
        let growing = growing(equations);
        let cost = |equations: &Equations| (equations.products - before) * equations.len();
        // Contact everywhere carries any pressure at one gap.
        if state.contact.iter().all(|contact| *contact) {
            return Self { growing, pressure_by_gap: Some(f64::NEG_INFINITY), node_products: cost(equations) };
        }
        equations.row = [1.0, 0.0, 0.0];
        let n = equations.len();
        let unit = (n as f64).sqrt();
        let (mut rhs, mut step) = (vec![0.0; n + 1], vec![0.0; n + 1]);
        rhs[n] = unit;
        let solved = gmres::solve(equations, &mut gmres::Vectors::default(), &rhs, &mut step, SLOPE, RESTART, PRODUCTS);
        Self { growing, pressure_by_gap: (solved.residual <= SLOPE).then(|| step[n] * unit), node_products: cost(equations) }
    }

    fn in_frame(self, stiffness: f64) -> Stability {
        let (Some(growing), Some(slope)) = (self.growing, self.pressure_by_gap) else { return Stability::Marginal };
        if growing > 0 || slope > stiffness { Stability::Unstable } else { Stability::Stable }
    }

    /// What both grids agree on: near a fold they do not.
    pub(super) fn agreed(grids: &[Self], stiffness: f64) -> Stability {
        let mut all = grids.iter().map(|grid| grid.in_frame(stiffness));
        match all.next() {
            Some(first) if all.all(|other| other == first) => first,
            _ => Stability::Marginal,
        }
    }
}

/// The stability of a state under each way to hold it.
#[derive(Debug, Clone, PartialEq)]
pub struct StateStability {
    pub(super) grids: Vec<OnGrid>,
}

impl StateStability {
    /// Stability under a held mean pressure.
    #[must_use]
    pub fn under_mean_pressure(&self) -> Stability {
        self.in_frame(0.0)
    }

    /// Stability under a held mean gap.
    #[must_use]
    pub fn under_mean_gap(&self) -> Stability {
        self.in_frame(f64::INFINITY)
    }

    /// What it took: products with the stiffness, each times the nodes of its grid.
    #[must_use]
    pub fn node_products(&self) -> usize {
        self.grids.iter().map(|grid| grid.node_products).sum()
    }

    /// Stability in a frame of a stiffness ≥ 0 (pressure unit per Λ): zero for a held pressure, infinite for a held gap.
    #[must_use]
    pub fn in_frame(&self, stiffness: f64) -> Stability {
        OnGrid::agreed(&self.grids, stiffness)
    }
}

impl SteadyState {
    /// Whether it stays where it is, on the two grids below its finest one; where these differ it is marginal.
    #[must_use]
    pub fn stability(&self, problem: &Problem) -> StateStability {
        let on_grid = |(nx, state): &(usize, State)| OnGrid::of(&mut Equations::new(problem, *nx, 1.0, problem.attraction.range), state);
        StateStability { grids: self.coarser.iter().map(on_grid).collect() }
    }
}

/// Negative eigenvalues of the linearised equations at a held mean gap.
fn growing(equations: &mut Equations) -> Option<usize> {
    let n = equations.len();
    let mut first = spread_out(n);
    equations.onto_held_gap(&mut first);
    let length = gmres::norm(&first);
    if length == 0.0 {
        return Some(0);
    }
    first.iter_mut().for_each(|v| *v /= length);
    let mut basis = vec![first];
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut before: Option<(usize, f64)> = None;
    let mut largest = 0.0_f64;
    let softness = equations.positive_softness();
    let mut product = vec![0.0; n];
    for size in SIZES {
        let mut complete = false;
        while columns.len() < size && !complete {
            let last = basis.last()?;
            equations.held_gap_product(&softness, last, &mut product);
            let mut column = vec![0.0; basis.len()];
            // Twice: what rounding leaves of the wall and of the mean gap would show as eigenvalues near zero.
            for _ in 0..2 {
                for (part, v) in column.iter_mut().zip(&basis) {
                    let more = gmres::dot(v, &product);
                    gmres::add(&mut product, -more, v);
                    *part += more;
                }
                equations.onto_held_gap(&mut product);
            }
            let length = gmres::norm(&product);
            largest = column.iter().fold(largest, |m, part| m.max(part.abs()));
            complete = length.is_nan() || length <= COMPLETE * largest;
            column.push(length);
            columns.push(column);
            basis.push(product.iter().map(|v| v / length).collect());
        }
        let here = count(&columns);
        let (number, nearest) = here?;
        let agrees = before.is_some_and(|(other, near)| other == number && (near - nearest).abs() <= AGREEMENT * nearest.abs());
        if agrees || complete {
            return nearest.is_finite().then_some(number);
        }
        before = here;
    }
    None
}

/// The negative eigenvalues of a Hessenberg matrix, and the one nearest to the imaginary axis; NaN where a pair with a negative real part oscillates.
fn count(columns: &[Vec<f64>]) -> Option<(usize, f64)> {
    let size = columns.len();
    let entry = |row: usize, column: usize| columns.get(column).and_then(|list| list.get(row)).copied().unwrap_or(0.0);
    let matrix = DMatrix::from_fn(size, size, entry);
    let values = Schur::try_new(matrix, f64::EPSILON, 100 * size)?.complex_eigenvalues();
    let number = values.iter().filter(|value| value.re < 0.0).count();
    let oscillates = values.iter().any(|value| value.re < 0.0 && value.im.abs() > 0.0);
    let nearest = values.iter().map(|value| value.re).fold(f64::INFINITY, |a: f64, b| if b.abs() < a.abs() { b } else { a });
    Some((number, if oscillates { f64::NAN } else { nearest }))
}

/// A vector with a part along every eigenvector: the same one each time.
fn spread_out(n: usize) -> Vec<f64> {
    let golden = 0.618_033_988_749_894_9;
    let place = |i: usize| (i as f64 * golden).fract();
    let values: Vec<f64> = (0..n).map(|i| place(i) * place(i * i % 65_521) - 0.25).collect();
    let middle = mean(&values);
    values.into_iter().map(|v| v - middle).collect()
}
