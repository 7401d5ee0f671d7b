//! Gauss rule of eight nodes on (0, 1), with the integrals of its Lagrange polynomials up to each node; Radau nodes; small linear systems.

pub(super) const NODES: usize = 8;

/// Nodes, weights, and ∫₀^{x_g} ℓ_h as `running[g][h]`.
#[derive(Debug, Clone, Default)]
pub(super) struct Gauss {
    pub(super) nodes: [f64; NODES],
    pub(super) weights: [f64; NODES],
    pub(super) running: [[f64; NODES]; NODES],
}

/// P_n and P_{n−1} at x.
pub(super) fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut last, mut here) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        (last, here) = (here, ((2.0 * k + 1.0) * x * here - k * last) / (k + 1.0));
    }
    (here, last)
}

/// The zeros in (−1, 1) of a function that has `count` simple ones there, by bisection between samples.
pub(super) fn zeros(count: usize, function: impl Fn(f64) -> f64) -> Vec<f64> {
    let samples = 400 * count;
    let place = |i: usize| -(std::f64::consts::PI * (i as f64 + 0.5) / (samples as f64 + 1.0)).cos();
    let mut found = Vec::new();
    for i in 0..samples {
        let (mut low, mut high) = (place(i), place(i + 1));
        let sign = function(low);
        if sign * function(high) > 0.0 {
            continue;
        }
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if function(middle) * sign > 0.0 { low = middle } else { high = middle }
        }
        found.push(0.5 * (low + high));
    }
    found
}

/// The p Radau points of (−1, 1] that include 1.
pub(super) fn radau(p: usize) -> Vec<f64> {
    let mut points = zeros(p - 1, |x| {
        let (here, last) = legendre(p, x);
        (here - last) / (1.0 - x)
    });
    points.push(1.0);
    points
}

impl Gauss {
    /// Weights of ∫₀ˣ by the values at the nodes.
    pub(super) fn until(&self, x: f64) -> [f64; NODES] {
        let polynomial = |h: usize, at: f64| {
            (0..NODES).filter(|&k| k != h).map(|k| (at - self.nodes[k]) / (self.nodes[h] - self.nodes[k])).product::<f64>()
        };
        std::array::from_fn(|h| (0..NODES).map(|k| x * self.weights[k] * polynomial(h, x * self.nodes[k])).sum())
    }

    /// The one rule.
    pub(super) fn get() -> &'static Self {
        static RULE: std::sync::LazyLock<Gauss> = std::sync::LazyLock::new(Gauss::new);
        &RULE
    }

    pub(super) fn new() -> Self {
        let roots = zeros(NODES, |x| legendre(NODES, x).0);
        let mut rule = Self { nodes: [0.0; NODES], weights: [0.0; NODES], running: [[0.0; NODES]; NODES] };
        for (g, &x) in roots.iter().enumerate() {
            let (here, last) = legendre(NODES, x);
            let slope = NODES as f64 * (x * here - last) / (x * x - 1.0);
            rule.nodes[g] = 0.5 * (1.0 + x);
            rule.weights[g] = 1.0 / ((1.0 - x * x) * slope * slope);
        }
        // ∫₀^{x_g} ℓ_h by the rule itself on (0, x_g): degree 7 is exact.
        rule.running = std::array::from_fn(|g| rule.until(rule.nodes[g]));
        rule
    }
}

/// Solves a square system in place by elimination with row pivots; false if it is singular. The solution replaces the right side.
pub(super) fn solve(matrix: &mut [f64], right: &mut [f64]) -> bool {
    let n = right.len();
    for column in 0..n {
        let Some(pivot) = (column..n).max_by(|&i, &j| matrix[i * n + column].abs().total_cmp(&matrix[j * n + column].abs())) else {
            return false;
        };
        let head = matrix[pivot * n + column];
        if head == 0.0 || !head.is_finite() {
            return false;
        }
        for k in 0..n {
            matrix.swap(pivot * n + k, column * n + k);
        }
        right.swap(pivot, column);
        for row in column + 1..n {
            let factor = matrix[row * n + column] / head;
            for k in column..n {
                matrix[row * n + k] -= factor * matrix[column * n + k];
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|k| matrix[row * n + k] * right[k]).sum();
        right[row] = (right[row] - known) / matrix[row * n + row];
    }
    right.iter().all(|value| value.is_finite())
}

/// The inverse of a small matrix, row by row; only for the fixed interpolation matrices.
pub(super) fn inverse(matrix: &[f64], n: usize) -> Vec<f64> {
    let mut result = vec![0.0; n * n];
    for column in 0..n {
        let mut unit = vec![0.0; n];
        unit[column] = 1.0;
        solve(&mut matrix.to_vec(), &mut unit);
        for row in 0..n {
            result[row * n + column] = unit[row];
        }
    }
    result
}
