//! Sums over all harmonics of a layer that is thin against the wavelength.
//!
//! ```text
//! Σ_{m≥1} F(m) e^{imx},    F(m) = f(mkd) Ĉ(m)/mᵖ,    f = A or S,    for kd so small that some 25/kd harmonics count
//! ```
//! # How
//! M terms are added one by one; the rest is an integral with its correction for being a sum (Abel and Plana),
//! ```text
//! Σ_{m≥M} φ(m) = ∫_M^∞ φ dm + φ(M)/2 + i∫₀^∞ [φ(M + is) − φ(M − is)]/(e^{2πs} − 1) ds
//! ```
//! F is analytic to the right of M: Ĉ has its poles on the imaginary axis, f at |mkd| of order one off the real axis. Far from the load
//! (|x| > 60kd) the first integral runs along m = M + σe^{iπ/4}, where e^{imx} falls, in panels that double; what the poles of f would add is
//! e^{−60} of them. Near the load it runs along the real axis to mkd = 25, over at most 240 oscillations. Negative x are taken to positive ones by
//! conjugation. Cost: 400 to 8000 values of F.
//!
//! Source: our own; Abel–Plana as in NIST DLMF, Sec 2.10(i), [dlmf.nist.gov/2.10](https://dlmf.nist.gov/2.10).

use super::layer::Layer;
use super::memory::SlidingMemory;
use crate::special::gauss_legendre::UNIT_RULE_20;
use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_4, PI};

/// M: the terms that are added one by one.
const DIRECT: u32 = 24;
/// |x|/kd beyond which the slanted path is taken.
pub(super) const FAR: f64 = 60.0;
/// mkd of the end of the real path: |A| < 1e-18 there.
const LAST_PRODUCT: f64 = 25.0;
/// Where exponentials end: e^{−40} = 4e-18.
const CUT: f64 = 40.0;
/// Longest panel of the real path, in mkd and in radians of e^{imx}.
const LONGEST: [f64; 2] = [1.0, 6.0];

/// Which factor of the layer is summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Factor {
    /// A: what the layer takes from the half-plane.
    Correction,
    /// S = 1 − A; only far from the load, as it does not fall with m.
    Compliance,
}

/// A layer of a solid in steady sliding.
#[derive(Debug, Clone, Copy)]
pub(super) struct HarmonicSum<'a> {
    pub(super) layer: &'a Layer,
    pub(super) memory: &'a SlidingMemory,
    pub(super) factor: Factor,
    /// p.
    pub(super) power: i32,
}

impl HarmonicSum<'_> {
    /// Re and Im of Σ F(m) e^{imx} at −π ≤ x ≤ π, with the sum of magnitudes that rounding is relative to.
    pub(super) fn at(&self, position: f64) -> (Complex<f64>, f64) {
        let (distance, backward) = (position.abs(), position < 0.0);
        let mut sum = Complex::new(0.0, 0.0);
        let mut size = 0.0;
        for index in 1..DIRECT {
            let m = f64::from(index);
            let term = self.summand(Complex::new(m, 0.0), backward) * Complex::from_polar(1.0, m * distance);
            sum += term;
            size += term.norm();
        }
        let rest = self.rest(distance, backward);
        sum += rest.0;
        size += rest.1;
        // Σ F e^{−im|x|} is the conjugate of Σ F̄ e^{im|x|}.
        (if backward { sum.conj() } else { sum }, size)
    }

    /// F, or the continuation of its conjugate.
    fn summand(&self, m: Complex<f64>, conjugate: bool) -> Complex<f64> {
        let product = m * self.layer.thickness_times_wave_number();
        let factor = match self.factor {
            Factor::Correction => self.layer.complex_correction(product),
            Factor::Compliance => self.layer.complex_compliance_factor(product),
        };
        let turn = if conjugate { Complex::new(0.0, -1.0) } else { Complex::new(0.0, 1.0) };
        let compliance =
            self.memory.terms().iter().fold(Complex::new(self.memory.glassy_compliance(), 0.0), |sum, term| {
                sum + term.compliance / (1.0 - turn * m * term.ratio)
            });
        factor * compliance / m.powi(self.power)
    }

    /// Σ from m = M.
    fn rest(&self, distance: f64, backward: bool) -> (Complex<f64>, f64) {
        let start = f64::from(DIRECT);
        let imaginary = Complex::new(0.0, 1.0);
        let value = |m: Complex<f64>| self.summand(m, backward) * (imaginary * m * distance).exp();
        let first = value(Complex::new(start, 0.0));
        let (mut sum, mut size) = (0.5 * first, 0.5 * first.norm());
        let mut add = |low: f64, high: f64, integrand: &dyn Fn(f64) -> Complex<f64>| {
            for &(node, weight) in UNIT_RULE_20.iter() {
                let part = integrand(low + (high - low) * node) * (weight * (high - low));
                sum += part;
                size += part.norm();
            }
        };
        // The correction for being a sum; e^{sx} grows slower than e^{2πs}.
        let end = CUT / (2.0 * PI - distance);
        let panels = 8;
        for panel in 0..panels {
            let at = |index: i32| end * f64::from(index) / f64::from(panels);
            add(at(panel), at(panel + 1), &|s| {
                let (above, below) = (value(Complex::new(start, s)), value(Complex::new(start, -s)));
                imaginary * (above - below) / (2.0 * PI * s).exp_m1()
            });
        }
        if distance > FAR * self.layer.thickness_times_wave_number() {
            let direction = Complex::from_polar(1.0, FRAC_PI_4);
            let end = CUT / (distance * FRAC_PI_4.sin());
            let (mut low, mut high) = (0.0, 0.5 * start);
            while low < end {
                // No panel longer than three radians of the decay.
                high = f64::min(high, low + 6.0 / distance).min(end);
                add(low, high, &|sigma| direction * value(start + direction * sigma));
                (low, high) = (high, 2.0 * high + start);
            }
        } else {
            let thickness = self.layer.thickness_times_wave_number();
            let end = LAST_PRODUCT / thickness;
            let longest = (LONGEST[0] / thickness).min(LONGEST[1] / distance.max(f64::MIN_POSITIVE));
            let mut low = start;
            while low < end {
                let high = (1.5 * low).min(low + longest).min(end);
                add(low, high, &|m| value(Complex::new(m, 0.0)));
                low = high;
            }
        }
        (sum, size)
    }
}
