//! GMRES with right preconditioning (Saad & Schultz, 1986): solves a linear system that is known only by its products.
//!
//! The residual that it reports is the true one, because the preconditioner stands on the right.

/// A square linear system and an approximate inverse.
pub(super) trait LinearSystem {
    /// `output` = matrix × `input`.
    fn multiply(&mut self, input: &[f64], output: &mut [f64]);
    /// `output` ≈ matrix⁻¹ × `input`; must be linear.
    fn precondition(&mut self, input: &[f64], output: &mut [f64]);
}

/// What a solve took and reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Outcome {
    /// Products with the matrix.
    pub(super) products: usize,
    /// Norm of the residual over that of the right-hand side.
    pub(super) residual: f64,
}

/// The vectors of a solve, kept for the next one: on a surface it takes as long to ask the system for their memory as to use it.
#[derive(Debug, Default)]
pub(super) struct Vectors {
    basis: Vec<Vec<f64>>,
    residual: Vec<f64>,
    z: Vec<f64>,
    w: Vec<f64>,
}

impl Vectors {
    /// Writes `values` over a length as the basis vector of an index, which is at most their number.
    fn write(basis: &mut Vec<Vec<f64>>, index: usize, values: &[f64], length: f64) {
        let scaled = values.iter().map(|v| v / length);
        if let Some(vector) = basis.get_mut(index) {
            vector.clear();
            vector.extend(scaled);
        } else {
            basis.push(scaled.collect());
        }
    }
}

/// Adds to `x` (which starts at zero) the solution of matrix × x = `rhs`, until the residual falls below `tolerance` times the
/// right-hand side, or `budget` products are spent. At most `restart` vectors are kept.
pub(super) fn solve(
    system: &mut impl LinearSystem,
    vectors: &mut Vectors,
    rhs: &[f64],
    x: &mut [f64],
    tolerance: f64,
    restart: usize,
    budget: usize,
) -> Outcome {
    let n = rhs.len();
    let scale = norm(rhs);
    let mut products = 0;
    if scale == 0.0 || !scale.is_finite() {
        return Outcome { products, residual: scale };
    }
    let Vectors { basis, residual, z, w } = vectors;
    residual.clear();
    residual.extend_from_slice(rhs);
    z.resize(n, 0.0);
    w.resize(n, 0.0);
    loop {
        let start = norm(residual);
        if start <= tolerance * scale || products >= budget || !start.is_finite() {
            return Outcome { products, residual: start / scale };
        }
        Vectors::write(basis, 0, residual, start);
        let mut triangle = Triangle::new(start);
        while triangle.columns() < restart && products < budget && triangle.residual() > tolerance * scale {
            let k = triangle.columns();
            system.precondition(&basis[k], z);
            system.multiply(z, w);
            products += 1;
            let mut column = orthogonalise(&basis[..=k], w);
            let length = norm(w);
            column.push(length);
            triangle.push(column);
            if length <= 1e-14 * scale || !length.is_finite() {
                break;
            }
            Vectors::write(basis, k + 1, w, length);
        }
        // x += P⁻¹ V y, then the true residual for the next cycle.
        w.fill(0.0);
        for (v, y) in basis.iter().zip(triangle.solution()) {
            add(w, y, v);
        }
        system.precondition(w, z);
        add(x, 1.0, z);
        let (before, expected) = (start, triangle.residual());
        if expected <= tolerance * scale {
            return Outcome { products, residual: expected / scale };
        }
        system.multiply(x, w);
        products += 1;
        for i in 0..n {
            residual[i] = rhs[i] - w[i];
        }
        // A cycle that gains nothing will not gain in the next one.
        if norm(residual) > 0.999 * before {
            return Outcome { products, residual: norm(residual) / scale };
        }
    }
}

/// The Hessenberg matrix of the cycle, made triangular by Givens rotations as it grows.
struct Triangle {
    columns: Vec<Vec<f64>>,
    rotations: Vec<(f64, f64)>,
    rhs: Vec<f64>,
}

impl Triangle {
    fn new(start: f64) -> Self {
        Self { columns: Vec::new(), rotations: Vec::new(), rhs: vec![start] }
    }

    fn columns(&self) -> usize {
        self.columns.len()
    }

    fn residual(&self) -> f64 {
        self.rhs[self.columns()].abs()
    }

    fn push(&mut self, mut column: Vec<f64>) {
        for (i, &(c, s)) in self.rotations.iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            column[i] = c * a + s * b;
            column[i + 1] = c * b - s * a;
        }
        let k = self.columns();
        let length = column[k].hypot(column[k + 1]);
        let (c, s) = if length > 0.0 { (column[k] / length, column[k + 1] / length) } else { (1.0, 0.0) };
        column[k] = length;
        column.truncate(k + 1);
        let old = self.rhs[k];
        self.rhs[k] = c * old;
        self.rhs.push(-s * old);
        self.rotations.push((c, s));
        self.columns.push(column);
    }

    /// The coefficients of the basis; a column without length gets none.
    fn solution(&self) -> Vec<f64> {
        let k = self.columns();
        let mut y = self.rhs[..k].to_vec();
        for i in (0..k).rev() {
            let pivot = self.columns[i][i];
            y[i] = if pivot > 0.0 { y[i] / pivot } else { 0.0 };
            let value = y[i];
            for (row, entry) in self.columns[i][..i].iter().enumerate() {
                y[row] -= entry * value;
            }
        }
        y
    }
}

/// Takes the parts along the basis from a vector, one after the other, and returns them. Each pass takes one part and measures the next one: what costs is memory.
fn orthogonalise(basis: &[Vec<f64>], w: &mut [f64]) -> Vec<f64> {
    let mut column: Vec<f64> = Vec::with_capacity(basis.len() + 1);
    let mut part = basis.first().map_or(0.0, |v| dot(v, w));
    for (index, v) in basis.iter().enumerate() {
        column.push(part);
        match basis.get(index + 1) {
            Some(next) => part = add_and_dot(w, -part, v, next),
            None => add(w, -part, v),
        }
    }
    column
}

/// [`add`], then [`dot`] of the sum with another vector.
fn add_and_dot(to: &mut [f64], factor: f64, from: &[f64], with: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let whole = to.len() / 8 * 8;
    let (to8, to_rest) = to.split_at_mut(whole);
    for ((t, f), w) in to8.chunks_exact_mut(8).zip(from.chunks_exact(8)).zip(with.chunks_exact(8)) {
        for i in 0..8 {
            t[i] += factor * f[i];
            lanes[i] += t[i] * w[i];
        }
    }
    add(to_rest, factor, &from[whole..]);
    let tail: f64 = to_rest.iter().zip(&with[whole..]).map(|(x, y)| x * y).sum();
    lanes.iter().sum::<f64>() + tail
}

/// Sums in eight lanes, so that the compiler can use wide instructions.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a8.zip(b8) {
        for i in 0..8 {
            lanes[i] += x[i] * y[i];
        }
    }
    lanes.iter().sum::<f64>() + tail
}

pub(super) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

pub(super) fn add(to: &mut [f64], factor: f64, from: &[f64]) {
    for (t, f) in to.iter_mut().zip(from) {
        *t += factor * f;
    }
}
