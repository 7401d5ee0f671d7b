//! The closure (thesis Eq 4.9) on the line: work of the interface stresses in the process zone.
//!
//! With s = a − δξ inside and s′ = a + δη outside, exchanging the order of the integrals of Eq 4.9 leaves a smooth kernel,
//! ```text
//! C = (1/π²) ∫₀¹ D(η) I(η) dη,      I(η) = −(π/2) Q(s′ − δ)/√(s′(s′ − δ)) + ∫₀^{1−η} k_ξ(ξ,η) Q(ξ) dξ,
//! k = K(m)/√(s s′),   m = (δ² − (s′ − s)²)/(4 s s′),   K the complete elliptic integral in the parameter m
//! ```
//! Here the form ∫K dμ/√(ss′) with dμ = −Q(a)δ_a + Q′ds was integrated by parts once more: neither Q′ nor the jumps of Q (the atoms left by
//! a re-advancing edge) need any care. k is analytic on the window: a Chebyshev series in ξ and η makes it separable and the
//! double integral is one pass over the panels.
//!
//! As δ → 0, k → π/(2a) and C → K_I²/(2E∞*).

use super::elliptic::elliptic_k;
use super::panel::{POINTS, Panel, RULE, panel_at};
use crate::refusal::Refusal;
use std::f64::consts::{FRAC_PI_2, PI};

/// Widest piece of the window: with 8 nodes the smooth kernel is then integrated to rounding for a ≥ 2δ.
const WIDEST: f64 = 0.25;
/// Most and fewest Chebyshev terms; 1e-14 of k for a ≥ 1.9δ, 1e-9 at 1.2δ.
const TERMS: (usize, usize) = (4, 24);

/// The kernel of one edge position.
#[derive(Debug, Clone, PartialEq)]
pub struct Zone {
    contact_radius: f64,
    length: f64,
    terms: usize,
    /// Chebyshev coefficients of k_ξ, row p for ξ, column q for η.
    slope: Vec<f64>,
}

impl Zone {
    /// The kernel at a contact radius a > δ.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a ≤ δ, where the zone would reach the axis.
    pub fn new(contact_radius: f64, length: f64) -> Result<Self, Refusal> {
        let ratio = contact_radius / length;
        let larger = ratio > 1.0 && ratio.is_finite();
        if !larger {
            return Err(Refusal::out_of_range("contact_radius", contact_radius, "greater than the process zone"));
        }
        // The nearest singularity is s = 0, at ξ = a/δ: Chebyshev coefficients fall like (z + √(z² − 1))^{−p}, z = 2a/δ − 1.
        let z = 2.0 * ratio - 1.0;
        let terms = ((32.0 / z.acosh()).ceil() as usize + 1).clamp(TERMS.0, TERMS.1);
        let count = terms as f64;
        let angle = |i: usize| PI * (i as f64 + 0.5) / count;
        let mut nodes = [0.0; TERMS.1];
        for (i, node) in nodes.iter_mut().enumerate().take(terms) {
            *node = 0.5 * (1.0 - angle(i).cos());
        }
        let mut table = [0.0; TERMS.1 * TERMS.1];
        for i in 0..terms {
            let inside = contact_radius - length * nodes[i];
            for l in 0..terms {
                let outside = contact_radius + length * nodes[l];
                let distance = nodes[i] + nodes[l];
                let m = length * length * (1.0 - distance * distance) / (4.0 * inside * outside);
                table[i * terms + l] = elliptic_k(m) / (inside * outside).sqrt();
            }
        }
        // T_p at x = 2ξ − 1 = −cos(angle): cos(p(π − angle)), with the factors of a discrete cosine transform.
        let mut transform = [0.0; TERMS.1 * TERMS.1];
        for p in 0..terms {
            for i in 0..terms {
                let factor = if p == 0 { 1.0 } else { 2.0 } / count;
                transform[p * terms + i] = factor * (p as f64 * (PI - angle(i))).cos();
            }
        }
        // The coefficients fall with p + q: those with p + q ≥ terms are beyond rounding, and are left out.
        let mut half = [0.0; TERMS.1 * TERMS.1];
        for i in 0..terms {
            for q in 0..terms {
                half[i * terms + q] = (0..terms).map(|l| table[i * terms + l] * transform[q * terms + l]).sum();
            }
        }
        let mut slope = vec![0.0; terms * terms];
        for q in 0..terms {
            // d/dξ = 2 d/dx, by the usual downward recursion.
            let mut derivative = [0.0; TERMS.1 + 2];
            for p in (1..terms).rev() {
                let coefficient: f64 = (0..terms).map(|i| half[i * terms + q] * transform[p * terms + i]).sum();
                derivative[p - 1] = derivative[p + 1] + 2.0 * p as f64 * coefficient;
            }
            derivative[0] *= 0.5;
            for p in 0..terms {
                slope[p * terms + q] = 2.0 * derivative[p];
            }
        }
        Ok(Self { contact_radius, length, terms, slope })
    }

    fn chebyshev(&self, at: f64, values: &mut [f64]) {
        let x = 2.0 * at - 1.0;
        let (mut last, mut here) = (x, 1.0);
        for value in values.iter_mut().take(self.terms) {
            *value = here;
            (last, here) = (here, 2.0 * x * here - last);
        }
    }
}

/// C (J/m²) from Q on panels that cover a − δ…a and D on panels that cover a…a + δ.
///
/// Exact to rounding for fields that are polynomials up to degree 7 on each panel.
#[must_use]
pub fn zone_work(zone: &Zone, line_load: &[Panel], gap_factor: &[Panel]) -> f64 {
    let (a, length, n) = (zone.contact_radius, zone.length, zone.terms);
    // Breaks of both fields in η, the inside mirrored.
    let mut breaks = vec![0.0, 1.0];
    let inside = line_load.iter().flat_map(|panel| [panel.lower, panel.upper]).map(|s| 1.0 - (a - s) / length);
    let outside = gap_factor.iter().flat_map(|panel| [panel.lower, panel.upper]).map(|s| (s - a) / length);
    breaks.extend(inside.chain(outside).filter(|eta| *eta > 0.0 && *eta < 1.0));
    breaks.sort_by(f64::total_cmp);
    let rule = &*RULE;
    let mut moments = [0.0; TERMS.1];
    let mut weighted = [[0.0; TERMS.1]; POINTS];
    let mut outer = [0.0; TERMS.1];
    let mut running = [0.0; TERMS.1];
    let mut work = 0.0;
    for pair in breaks.windows(2).rev() {
        let (low, high) = (pair[0], pair[1]);
        if high - low <= 1e-15 {
            continue;
        }
        let pieces = ((high - low) / WIDEST).ceil().max(1.0);
        let width = (high - low) / pieces;
        for piece in 0..pieces as usize {
            let top = high - width * piece as f64;
            // A piece lies within one panel of each field.
            let bonded = panel_at(line_load, a - length * (1.0 - top + 0.5 * width));
            let free = panel_at(gap_factor, a + length * (top - 0.5 * width));
            let mut loads = [0.0; POINTS];
            for (g, weighted) in weighted.iter_mut().enumerate() {
                let xi = 1.0 - top + width * rule.nodes[g];
                loads[g] = bonded.map_or(0.0, |panel| panel.at(a - length * xi));
                zone.chebyshev(xi, weighted);
                for value in weighted.iter_mut().take(n) {
                    *value *= width * loads[g];
                }
            }
            for (g, load) in loads.iter().enumerate() {
                let eta = top - width * rule.nodes[g];
                let place = a + length * eta;
                zone.chebyshev(eta, &mut outer);
                running[..n].copy_from_slice(&moments[..n]);
                for (factor, weighted) in rule.running[g].iter().zip(&weighted) {
                    for (sum, value) in running[..n].iter_mut().zip(&weighted[..n]) {
                        *sum += factor * value;
                    }
                }
                let mut remembered = 0.0;
                for (p, (row, running)) in zone.slope.chunks_exact(n).zip(&running[..n]).enumerate() {
                    let row: f64 = row[..n - p].iter().zip(&outer[..n - p]).map(|(slope, outer)| slope * outer).sum();
                    remembered += row * running;
                }
                let local = -FRAC_PI_2 * load / (place * (place - length)).sqrt();
                work += width * rule.weights[g] * free.map_or(0.0, |panel| panel.at(place)) * (local + remembered);
            }
            for (weight, weighted) in rule.weights.iter().zip(&weighted) {
                for (moment, value) in moments[..n].iter_mut().zip(&weighted[..n]) {
                    *moment += weight * value;
                }
            }
        }
    }
    work / (PI * PI)
}
