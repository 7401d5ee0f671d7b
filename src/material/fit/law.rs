//! Laws of temperature through shift factors that were found, weighed by the covariance of the factors.

/// The molar gas constant (J/(mol K)), exact since 2019.
const GAS_CONSTANT: f64 = 8.314_462_618_153_24;

/// Constants of a law with their stated errors (two standard deviations, larger where the law misses the factors by more than their errors).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawFit<const N: usize> {
    /// Reference temperature of the constants (K).
    pub reference: f64,
    /// c₁ and c₂ (K); or E_a (J/mol).
    pub constants: [f64; N],
    /// Their stated errors.
    pub errors: [f64; N],
    /// Largest difference between the law and a factor, in decades.
    pub largest_decades: f64,
    /// Sum of squared differences over the covariance of the factors, per degree of freedom; none without any.
    pub reduced_square: Option<f64>,
}

/// Squared differences per degree of freedom beyond which a law does not follow the factors.
const FOLLOWS: f64 = 4.0;

impl<const N: usize> LawFit<N> {
    /// Whether the factors lie on the law within their errors; none where there are not more factors than constants.
    #[must_use]
    pub fn follows(&self) -> Option<bool> {
        self.reduced_square.map(|square| square <= FOLLOWS)
    }
}

/// The inverse of the lower triangular factor of a covariance, to be applied to vectors; none if it has no such factor.
struct Whitening(Vec<Vec<f64>>);

impl Whitening {
    fn new(covariance: &[Vec<f64>]) -> Option<Self> {
        let mut factor: Vec<Vec<f64>> = Vec::with_capacity(covariance.len());
        for (i, row) in covariance.iter().enumerate() {
            let mut own: Vec<f64> = Vec::with_capacity(i + 1);
            for (j, &value) in row.iter().enumerate().take(i + 1) {
                let sum: f64 = if j == i {
                    own.iter().map(|entry| entry * entry).sum()
                } else {
                    factor.get(j)?.iter().zip(&own).map(|(left, right)| left * right).sum()
                };
                let rest = value - sum;
                own.push(if j == i { rest.sqrt() } else { rest / factor.get(j)?.get(j)? });
            }
            if !own.iter().all(|entry| entry.is_finite()) || own.last().is_none_or(|last| *last <= 0.0) {
                return None;
            }
            factor.push(own);
        }
        Some(Self(factor))
    }

    fn apply(&self, vector: &[f64]) -> Vec<f64> {
        let mut white: Vec<f64> = Vec::with_capacity(vector.len());
        for (row, value) in self.0.iter().zip(vector) {
            let sum: f64 = row.iter().zip(&white).map(|(entry, before)| entry * before).sum();
            white.push((value - sum) / row.last().copied().unwrap_or(1.0));
        }
        white
    }
}

fn product(left: &[f64], right: &[f64]) -> f64 {
    left.iter().zip(right).map(|(one, other)| one * other).sum()
}

/// What errors are multiplied by: two deviations, more where the law misses the factors by more than chance.
fn stretch(square: Option<f64>) -> f64 {
    2.0 * square.filter(|square| *square > FOLLOWS).map_or(1.0, f64::sqrt)
}

fn decades(points: &[(f64, f64)], law: impl Fn(f64) -> f64) -> f64 {
    points.iter().map(|&(temperature, logarithm)| (law(temperature) - logarithm).abs()).fold(0.0, f64::max) / std::f64::consts::LN_10
}

/// ln a_T = (E_a/R)(1/T − 1/T_ref) through (T, ln a_T).
pub(super) fn arrhenius(points: &[(f64, f64)], covariance: &[Vec<f64>], reference: f64) -> Option<LawFit<1>> {
    let whitening = Whitening::new(covariance)?;
    let along: Vec<f64> = points.iter().map(|point| (1.0 / point.0 - 1.0 / reference) / GAS_CONSTANT).collect();
    let (x, y) = (whitening.apply(&along), whitening.apply(&points.iter().map(|point| point.1).collect::<Vec<_>>()));
    let energy = product(&x, &y) / product(&x, &x);
    let misses: f64 = x.iter().zip(&y).map(|(x, y)| (y - energy * x).powi(2)).sum();
    let reduced_square = (points.len() > 1).then(|| misses / (points.len() - 1) as f64);
    let error = stretch(reduced_square) / product(&x, &x).sqrt();
    (energy.is_finite() && error.is_finite()).then(|| LawFit {
        reference,
        constants: [energy],
        errors: [error],
        largest_decades: decades(points, |temperature| energy * (1.0 / temperature - 1.0 / reference) / GAS_CONSTANT),
        reduced_square,
    })
}

/// log₁₀ a_T = −c₁ (T − T_ref)/(c₂ + T − T_ref) through (T, ln a_T); none where the factors do not fix both constants.
pub(super) fn williams_landel_ferry(points: &[(f64, f64)], covariance: &[Vec<f64>], reference: f64) -> Option<LawFit<2>> {
    if points.len() < 2 {
        return None;
    }
    let whitening = Whitening::new(covariance)?;
    let y = whitening.apply(&points.iter().map(|point| point.1).collect::<Vec<_>>());
    // For each c₂ the best c₁ and the misfit.
    let of = |c2: f64| {
        let along: Vec<f64> = points.iter().map(|&(t, _)| -std::f64::consts::LN_10 * (t - reference) / (c2 + t - reference)).collect();
        let x = whitening.apply(&along);
        let c1 = product(&x, &y) / product(&x, &x);
        (x.iter().zip(&y).map(|(x, y)| (y - c1 * x).powi(2)).sum::<f64>(), c1)
    };
    let pole = points.iter().map(|point| reference - point.0).fold(0.0, f64::max);
    // c₂ beyond its least by a log-spaced distance.
    let c2 = |step: f64| pole + 0.1 * 10f64.powf(step);
    let steps = 200;
    let place = |index: usize| 5.0 * index as f64 / steps as f64;
    let best = (0..=steps).min_by(|left, right| of(c2(place(*left))).0.total_cmp(&of(c2(place(*right))).0))?;
    if best == 0 || best == steps {
        return None;
    }
    let (mut low, mut high) = (place(best - 1), place(best + 1));
    for _ in 0..80 {
        let (left, right) = (high - 0.618_033_988_75 * (high - low), low + 0.618_033_988_75 * (high - low));
        if of(c2(left)).0 < of(c2(right)).0 { high = right } else { low = left }
    }
    let c2 = c2(0.5 * (low + high));
    let (misses, c1) = of(c2);
    let slope = |value: &dyn Fn(f64) -> f64| whitening.apply(&points.iter().map(|&(t, _)| value(t - reference)).collect::<Vec<_>>());
    let by_c1 = slope(&|above| -std::f64::consts::LN_10 * above / (c2 + above));
    let by_c2 = slope(&|above| std::f64::consts::LN_10 * c1 * above / (c2 + above).powi(2));
    let (a, b, c) = (product(&by_c1, &by_c1), product(&by_c1, &by_c2), product(&by_c2, &by_c2));
    let determinant = a * c - b * b;
    let reduced_square = (points.len() > 2).then(|| misses / (points.len() - 2) as f64);
    let errors = [(c / determinant).sqrt(), (a / determinant).sqrt()].map(|error| error * stretch(reduced_square));
    (c1 > 0.0 && errors.iter().all(|error| error.is_finite())).then(|| LawFit {
        reference,
        constants: [c1, c2],
        errors,
        largest_decades: decades(points, |t| -std::f64::consts::LN_10 * c1 * (t - reference) / (c2 + t - reference)),
        reduced_square,
    })
}
