//! The influence of a ring of pressure on the surface of a half-space, integrated against polynomials on an interval.
//!
//! w(x) = ∫ G(x, y) q(y) dy with G = 4y K(k)/(π(x + y)), k² = 4xy/(x + y)² (Johnson 1985, section 3.8), in units where E* = 1.
//! By Gauss's arithmetic-geometric mean G = 2y/AGM(max(x, y), √|x² − y²|): no loss of digits near x = y, where G has a logarithm.

/// Points of the rule that integrates up to the logarithm, for every node of an element: ten nodes need 28 for 1e-12.
const NEAR_POINTS_PER_NODE: f64 = 2.8;
/// y − x is the fifth power of the variable of that rule: s⁴ ln s is smooth enough for rounding accuracy.
const NEAR_POWER: i32 = 5;
/// Sources farther from the target than this many of their lengths take the plain Gauss rule: its error is 1e-10 at ten nodes.
const FAR: f64 = 2.0;

/// Two numbers whose relative difference is less than this have their mean to rounding after one more step of the iteration.
const ONE_MORE_STEP: f64 = 1e-8;
/// Steps of the iteration, at most: 1e-300 needs 12.
const MOST_STEPS: usize = 16;

/// G(x, y) at one x: 2y/AGM(max(x, y), √(|x − y|(x + y))), from y and the distances (given by themselves, because they may be far smaller than both).
struct Influence<'a> {
    x: f64,
    y: &'a [f64],
    distances: &'a [f64],
    /// Work space, of the same length.
    means: &'a mut [f64],
    out: &'a mut [f64],
}

impl pulp::WithSimd for Influence<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let Self { x, y, distances, means, out } = self;
        for (((a, b), &y), &distance) in means.iter_mut().zip(out.iter_mut()).zip(y).zip(distances) {
            *a = x.max(y);
            *b = (distance * (x + y)).sqrt();
        }
        for _ in 0..MOST_STEPS {
            let mut differ = false;
            for (a, b) in means.iter_mut().zip(out.iter_mut()) {
                let (arithmetic, geometric) = (0.5 * (*a + *b), (*a * *b).sqrt());
                (*a, *b) = (arithmetic, geometric);
                differ |= arithmetic - geometric > ONE_MORE_STEP * arithmetic;
            }
            if !differ {
                break;
            }
        }
        for ((a, b), &y) in means.iter().zip(out.iter_mut()).zip(y) {
            // At distance zero the mean is zero: a weight of zero goes with it.
            *b = if *b > 0.0 { 4.0 * y / (a + *b) } else { 0.0 };
        }
    }
}

/// A Gauss–Legendre rule on [−1, 1] with what is needed to interpolate through its nodes.
#[derive(Clone)]
pub(super) struct Rule {
    pub(super) nodes: Vec<f64>,
    pub(super) weights: Vec<f64>,
    /// Barycentric weights.
    barycentric: Vec<f64>,
    /// Rows that give the last two Legendre coefficients from values at the nodes.
    pub(super) last_coefficients: [Vec<f64>; 2],
}

impl Rule {
    /// The rule of `order` nodes.
    pub(super) fn new(order: usize) -> Self {
        let (nodes, weights) = legendre_nodes(order);
        // Wang & Xiang (2012): the barycentric weights of Gauss points are (−1)^k √((1 − x²)w).
        let barycentric =
            (0..order).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 } * ((1.0 - nodes[k] * nodes[k]) * weights[k]).sqrt()).collect();
        let row = |degree: usize| (0..order).map(|k| (degree as f64 + 0.5) * weights[k] * legendre(degree, nodes[k]).0).collect();
        let last_coefficients = [row(order.saturating_sub(2)), row(order.saturating_sub(1))];
        Self { nodes, weights, barycentric, last_coefficients }
    }

    /// The values of the Lagrange polynomials at a point of [−1, 1].
    pub(super) fn basis(&self, at: f64, out: &mut [f64]) {
        let mut sum = 0.0;
        for (k, value) in out.iter_mut().enumerate() {
            let distance = at - self.nodes[k];
            if distance == 0.0 {
                out.fill(0.0);
                out[k] = 1.0;
                return;
            }
            *value = self.barycentric[k] / distance;
            sum += *value;
        }
        out.iter_mut().for_each(|value| *value /= sum);
    }
}

/// P_n and its derivative.
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut before, mut now) = (1.0, x);
    if degree == 0 {
        return (1.0, 0.0);
    }
    for n in 1..degree {
        let n = n as f64;
        (before, now) = (now, ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0));
    }
    (now, degree as f64 * (before - x * now) / ((1.0 - x) * (1.0 + x)))
}

/// Nodes (rising) and weights by Newton's method on P_n.
fn legendre_nodes(order: usize) -> (Vec<f64>, Vec<f64>) {
    let mut pairs: Vec<(f64, f64)> = (0..order)
        .map(|k| {
            let mut x = (std::f64::consts::PI * (k as f64 + 0.75) / (order as f64 + 0.5)).cos();
            for _ in 0..8 {
                let (value, slope) = legendre(order, x);
                x -= value / slope;
            }
            let slope = legendre(order, x).1;
            (x, 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope))
        })
        .collect();
    pairs.reverse();
    pairs.into_iter().unzip()
}

/// Nodes and weights on [0, 1].
pub(super) fn unit_rule(points: usize) -> Vec<(f64, f64)> {
    let (nodes, weights) = legendre_nodes(points);
    nodes.iter().zip(&weights).map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w)).collect()
}

/// Points at which an influence is integrated, with work space.
#[derive(Default)]
pub(super) struct Points {
    y: Vec<f64>,
    distances: Vec<f64>,
    /// Weights of the rule, then times G.
    values: Vec<f64>,
    influence: Vec<f64>,
    means: Vec<f64>,
    /// bᵢ/(ξ − ξᵢ), by nodes, and their sums.
    terms: Vec<f64>,
    sums: Vec<f64>,
}

impl Points {
    fn clear(&mut self) {
        self.y.clear();
        self.distances.clear();
        self.values.clear();
    }

    fn push(&mut self, y: f64, distance: f64, weight: f64) {
        self.y.push(y);
        self.distances.push(distance);
        self.values.push(weight);
    }

    /// Multiplies the weights by G(x, y).
    fn times_influence(&mut self, x: f64) {
        let count = self.y.len();
        self.means.resize(count, 0.0);
        self.influence.resize(count, 0.0);
        let Self { y, distances, means, influence, .. } = self;
        pulp::Arch::new().dispatch(Influence { x, y, distances, means, out: influence });
        self.values.iter_mut().zip(&self.influence).for_each(|(value, influence)| *value *= influence);
    }
}

/// Adds Σ value·ℓ_k(y) to the entry of every node k of a rule on an interval.
struct Interpolated<'a> {
    rule: &'a Rule,
    middle: f64,
    half: f64,
    points: &'a mut Points,
    out: &'a mut [f64],
}

impl pulp::WithSimd for Interpolated<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let Points { y, values, terms, sums, .. } = self.points;
        let (count, scale) = (y.len(), 1.0 / self.half);
        terms.resize(count * self.out.len(), 0.0);
        sums.clear();
        sums.resize(count, 0.0);
        for ((node, weight), terms) in self.rule.nodes.iter().zip(&self.rule.barycentric).zip(terms.chunks_exact_mut(count)) {
            for ((term, sum), y) in terms.iter_mut().zip(sums.iter_mut()).zip(y.iter()) {
                let distance = (y - self.middle) * scale - node;
                // On a node its own term outweighs all others.
                *term = weight / if distance == 0.0 { f64::MIN_POSITIVE } else { distance };
                *sum += *term;
            }
        }
        values.iter_mut().zip(sums.iter()).for_each(|(value, sum)| *value /= sum);
        for (out, terms) in self.out.iter_mut().zip(terms.chunks_exact(count)) {
            let mut four = [0.0; 4];
            let (mut a, mut b) = (terms.chunks_exact(4), values.chunks_exact(4));
            for (a, b) in a.by_ref().zip(b.by_ref()) {
                four.iter_mut().zip(a.iter().zip(b)).for_each(|(sum, (a, b))| *sum += a * b);
            }
            *out += four.iter().sum::<f64>() + a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum::<f64>();
        }
    }
}

/// Integrates G(x, y)·ℓ_k(y) over an interval for every node k of a rule.
pub(super) struct Quadrature {
    pub(super) rule: Rule,
    /// Nodes on (0, 1) and weights of the rule used near the target.
    near: Vec<(f64, f64)>,
}

impl Quadrature {
    pub(super) fn new(order: usize) -> Self {
        Self { rule: Rule::new(order), near: unit_rule((NEAR_POINTS_PER_NODE * order as f64).ceil() as usize) }
    }

    /// Whether the plain rule is enough for this target.
    pub(super) fn is_far(&self, x: f64, source: (f64, f64)) -> bool {
        (source.0 - x).max(x - source.1) > FAR * (source.1 - source.0)
    }

    /// The row of the influence matrix: target x, source interval.
    pub(super) fn row(&self, x: f64, source: (f64, f64), points: &mut Points, out: &mut [f64]) {
        let (a, b) = source;
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        points.clear();
        if self.is_far(x, source) {
            for (node, weight) in self.rule.nodes.iter().zip(&self.rule.weights) {
                let y = middle + half * node;
                points.push(y, (x - y).abs(), half * weight);
            }
            points.times_influence(x);
            out.copy_from_slice(&points.values);
            return;
        }
        if x > a {
            self.side(x, -1.0, (x - b).max(0.0), x - a, points);
        }
        if x < b {
            // The image of the target at −x is a second singularity: panels on this side grow with the distance from it.
            let (mut from, end) = ((a - x).max(0.0), b - x);
            while from < end {
                let to = if end <= 3.0 * (x + from) { end } else { 2.0 * x + 3.0 * from };
                self.side(x, 1.0, from, to, points);
                from = to;
            }
        }
        points.times_influence(x);
        out.fill(0.0);
        pulp::Arch::new().dispatch(Interpolated { rule: &self.rule, middle, half, points, out });
    }

    /// The points at distances `from`..`to` on one side of the target.
    fn side(&self, x: f64, sign: f64, from: f64, to: f64, points: &mut Points) {
        let power = f64::from(NEAR_POWER);
        let start = (from / to).powf(1.0 / power);
        for &(t, weight) in &self.near {
            let s = start + (1.0 - start) * t;
            let distance = to * s.powi(NEAR_POWER);
            points.push((x + sign * distance).max(0.0), distance, weight * (1.0 - start) * power * to * s.powi(NEAR_POWER - 1));
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::needless_range_loop)]
mod tests {
    use super::*;

    fn ellip_e(m: f64) -> f64 {
        // Second kind by the mean: E = K(1 − Σ 2^{n−1} c_n²).
        let (mut a, mut b, mut sum, mut factor) = (1.0, (1.0 - m).sqrt(), 0.5 * m, 0.5);
        for _ in 0..40 {
            let c = 0.5 * (a - b);
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            factor *= 2.0;
            sum += factor * c * c;
        }
        std::f64::consts::FRAC_PI_2 / a * (1.0 - sum)
    }

    /// Uniform pressure on the unit disc: w = (4/π) E(x²) (Johnson 1985, eq. 3.29 with E* = 1).
    #[test]
    fn a_uniform_disc() {
        let quadrature = Quadrature::new(10);
        let cells = [(0.0, 0.0625), (0.0625, 0.125), (0.125, 0.25), (0.25, 0.5), (0.5, 0.75), (0.75, 1.0)];
        let mut row = vec![0.0; 10];
        for i in 1..400 {
            let x = f64::from(i) / 400.0 * 0.9999;
            let sum: f64 = cells
                .iter()
                .map(|&cell| {
                    quadrature.row(x, cell, &mut Points::default(), &mut row);
                    row.iter().sum::<f64>()
                })
                .sum();
            let exact = 4.0 / std::f64::consts::PI * ellip_e(x * x);
            assert!((sum - exact).abs() < 2e-10, "{x}: {sum} {exact} {:e}", sum - exact);
        }
    }

    /// The rule near the target against one of 80 points, on elements that touch, that overlap the centre, and on one itself.
    #[test]
    fn the_rule_near_the_target_is_exact() {
        let (quadrature, fine) = (Quadrature::new(10), Quadrature { rule: Rule::new(10), near: unit_rule(80) });
        let pairs = [
            ((1.0, 2.0), (1.0, 2.0)),
            ((0.0, 4.0), (0.0, 4.0)),
            ((4.0, 8.0), (0.0, 4.0)),
            ((0.0, 4.0), (4.0, 8.0)),
            ((3.0, 3.25), (2.0, 3.0)),
            ((2.0, 3.0), (3.0, 3.25)),
            ((0.0, 1.0), (1.0, 2.0)),
        ];
        for (target, source) in pairs {
            let (mut row, mut exact) = (vec![0.0; 10], vec![0.0; 10]);
            for node in &fine.rule.nodes {
                let x = 0.5 * (target.0 + target.1) + 0.5 * (target.1 - target.0) * node;
                quadrature.row(x, source, &mut Points::default(), &mut row);
                fine.row(x, source, &mut Points::default(), &mut exact);
                for (a, b) in row.iter().zip(&exact) {
                    assert!((a - b).abs() < 1e-11, "target {x}, source {source:?}: {:e}", a - b);
                }
            }
        }
    }
}
