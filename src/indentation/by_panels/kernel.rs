//! The smooth kernel of the closure, k(η, ξ) = K(m)/√(s s′), s = a − ξ, s′ = a + η, m = (δ² − (η + ξ)²)/(4 s s′), as a Chebyshev series in
//! ξ on (0, δ).
//!
//! Its nearest singularity in ξ is s = 0: the series falls as ρ^{−p}, ρ = z + √(z² − 1), z = 2a/δ − 1. The rank is chosen by that, from 6
//! where a ≥ 60 δ to [`MOST`] at a = δ, where the digits left are those of ρ^{−MOST}.

use std::f64::consts::{FRAC_PI_2, PI};

/// Most terms: at a = 1.05 δ they leave 1e-6 of the kernel, at 1.3 δ 1e-13.
pub(super) const MOST: usize = 32;
/// The ranks there are: loops of known length.
pub(super) const WIDTHS: [usize; 3] = [8, 16, MOST];
/// Part of the kernel that the series may leave out: its slope enters with δ/a, so that rounding comes first.
const LEFT_OUT: f64 = 1e-12;

/// For one edge.
#[derive(Debug, Clone, Default)]
pub(super) struct Kernel {
    pub(super) edge: f64,
    pub(super) zone: f64,
    pub(super) rank: usize,
    /// 1/s_k, ξ_k and 1/√s_k, s_k = a − ξ_k.
    pub(super) places: Vec<(f64, f64, f64)>,
    /// T_p(ξ_k)·2/rank.
    pub(super) fit: Vec<f64>,
    pub(super) cosines: Vec<f64>,
    pub(super) terms: usize,
    pub(super) coefficients: Vec<f64>,
}

/// Terms of the power series of K beyond which the arithmetic-geometric mean is used instead.
const MOST_POWERS: usize = 12;

impl Kernel {
    /// For an edge at `edge`.
    pub(super) fn set(&mut self, edge: f64, zone: f64) {
        let z = 2.0 * edge / zone - 1.0;
        let rho = z + (z * z - 1.0).max(0.0).sqrt();
        let rank = if rho > 1.0 { ((1.0 / LEFT_OUT).ln() / rho.ln()).ceil().min(MOST as f64).max(4.0) as usize + 1 } else { MOST };
        let rank = WIDTHS.into_iter().find(|&width| width >= rank).unwrap_or(MOST);
        if rank != self.rank {
            self.rank = rank;
            self.fit.clear();
            for p in 0..rank {
                self.fit.extend((0..rank).map(|k| 2.0 / rank as f64 * (p as f64 * point(k, rank)).cos()));
            }
            self.cosines = (0..rank).map(|k| point(k, rank).cos()).collect();
            // A row for each k, so that the sums run over p side by side.
            let fit = self.fit.clone();
            for p in 0..rank {
                for k in 0..rank {
                    self.fit[k * rank + p] = fit[p * rank + k];
                }
            }
        }
        (self.edge, self.zone) = (edge, zone);
        self.places.clear();
        self.places.extend(self.cosines.iter().map(|cosine| {
            let xi = 0.5 * zone * (1.0 + cosine);
            let place = edge - xi;
            (place.recip(), xi, place.sqrt().recip())
        }));
        let largest = 0.75 * zone * zone / ((edge - zone) * edge).max(f64::MIN_POSITIVE);
        self.terms = if largest < 0.05 { ((1e-17_f64).ln() / largest.ln()).ceil().max(2.0) as usize } else { MOST_POWERS + 1 };
        if self.coefficients.is_empty() {
            let mut c = FRAC_PI_2;
            for n in 0..=MOST_POWERS {
                self.coefficients.push(c);
                let odd = (2.0 * n as f64 + 1.0) / (2.0 * n as f64 + 2.0);
                c *= odd * odd;
            }
        }
    }

    /// Its coefficients c_p of T_p(2ξ/δ − 1) at η; c_0 is not needed.
    pub(super) fn row<const R: usize>(&self, eta: f64) -> [f64; R] {
        let outer = self.edge + eta;
        let (inverse, root) = (0.25 / outer, outer.sqrt().recip());
        let mut m = [0.0; R];
        let mut scale = [0.0; R];
        for ((m, scale), &(by_place, xi, by_root)) in m.iter_mut().zip(&mut scale).zip(&self.places) {
            let reach = eta + xi;
            *m = (self.zone - reach) * (self.zone + reach) * (by_place * inverse);
            *scale = by_root * root;
        }
        let mut values = [0.0; R];
        if self.terms <= MOST_POWERS {
            for &c in self.coefficients[..=self.terms].iter().rev() {
                values.iter_mut().zip(&m).for_each(|(value, m)| *value = *value * m + c);
            }
        } else {
            values = m.map(elliptic);
        }
        let mut row = [0.0; R];
        for ((value, scale), fit) in values.iter().zip(&scale).zip(self.fit.chunks_exact(R)) {
            let value = value * scale;
            row.iter_mut().zip(fit).for_each(|(sum, factor)| *sum += value * factor);
        }
        row
    }

    /// k on η + ξ = δ, where m = 0.
    pub(super) fn local(&self, y: f64) -> f64 {
        FRAC_PI_2 / ((self.edge - y) * (self.edge + self.zone - y)).sqrt()
    }

    /// Slopes of T_p(2y/δ − 1) by y.
    pub(super) fn slopes<const R: usize>(&self, y: f64) -> [f64; R] {
        let x = 2.0 * y / self.zone - 1.0;
        let (mut last, mut here) = (0.0, 2.0 / self.zone);
        let mut slopes = [0.0; R];
        for (p, slope) in slopes.iter_mut().enumerate().skip(1) {
            *slope = p as f64 * here;
            (last, here) = (here, 2.0 * x * here - last);
        }
        slopes
    }
}

/// K by the arithmetic-geometric mean.
pub(super) fn elliptic(m: f64) -> f64 {
    let (mut a, mut g) = (1.0, (1.0 - m).sqrt());
    for _ in 0..12 {
        if (a - g).abs() <= 2e-16 * a {
            break;
        }
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    FRAC_PI_2 / a
}

pub(super) fn point(k: usize, rank: usize) -> f64 {
    PI * (k as f64 + 0.5) / rank as f64
}
