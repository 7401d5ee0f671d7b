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

use super::panel::{POINTS, Panel, RULE};
use super::row::{Row, add_product, add_scaled, interpolated, next_chebyshev, product, sum};
use super::zone::{MOST_TERMS, Zone};
use pulp::{Simd, WithSimd};
use std::f64::consts::{FRAC_PI_2, PI};

/// Widest piece of the window: with 8 nodes the smooth kernel is then integrated to rounding for a ≥ 2δ.
const WIDEST: f64 = 0.25;
/// Narrower pieces of the window are rounding.
const SLIVER: f64 = 1e-15;

/// C (J/m²) from Q on panels that cover a − δ…a and D on panels that cover a…a + δ.
///
/// Exact to rounding for fields that are polynomials up to degree 7 on each panel.
#[must_use]
pub fn zone_work(zone: &Zone, line_load: &[Panel], gap_factor: &[Panel]) -> f64 {
    // With the widest vector instructions that the machine has; they round alike.
    pulp::Arch::new().dispatch(Summation { zone, line_load, gap_factor })
}

/// The arguments of [`summed`]: a closure would not be inlined where the wide instructions are.
struct Summation<'a> {
    zone: &'a Zone,
    line_load: &'a [Panel],
    gap_factor: &'a [Panel],
}

impl WithSimd for Summation<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        summed(simd, self.zone, self.line_load, self.gap_factor)
    }
}

#[inline(always)]
fn summed<S: Simd>(simd: S, zone: &Zone, mut line_load: &[Panel], mut gap_factor: &[Panel]) -> f64 {
    let (a, length) = (zone.contact_radius, zone.length);
    // Places in η, the inside mirrored.
    let mirrored = |s: f64| 1.0 - (a - s) / length;
    let outside = |s: f64| (s - a) / length;
    let mut sums = Sums { zone, moments: [0.0; MOST_TERMS], outer: [[0.0; POINTS]; MOST_TERMS], work: 0.0 };
    let mut high = 1.0;
    while high > SLIVER {
        // From the far end of the zone inwards; the first panels are continued to the ends.
        let (bonded, bonded_low) = last_below(&mut line_load, high, mirrored);
        let (free, free_low) = last_below(&mut gap_factor, high, outside);
        let low = bonded_low.max(free_low);
        let pieces = ((high - low) / WIDEST).ceil().max(1.0);
        let width = (high - low) / pieces;
        for piece in 0..pieces as usize {
            let top = high - width * piece as f64;
            let (mut loads, mut gaps) = ([0.0; POINTS], [0.0; POINTS]);
            if let Some(panel) = bonded {
                loads = downwards(simd, panel, mirrored(panel.lower), length, top, width);
            }
            if let Some(panel) = free {
                gaps = downwards(simd, panel, outside(panel.lower), length, top, width);
            }
            sums.add(simd, (top, width), &loads, &gaps);
        }
        high = low;
    }
    sums.work / (PI * PI)
}

/// The last panel that begins below a place, and where it begins; those behind it are done.
#[inline(always)]
fn last_below<'p>(panels: &mut &'p [Panel], high: f64, place: impl Fn(f64) -> f64) -> (Option<&'p Panel>, f64) {
    while let [rest @ .., last] = *panels {
        let low = place(last.lower);
        if rest.is_empty() {
            return (Some(last), 0.0);
        }
        if low < high - SLIVER {
            return (Some(last), low.max(0.0));
        }
        *panels = rest;
    }
    (None, 0.0)
}

/// A field of a panel that begins at `start` at the nodes of a piece, from its top down.
#[inline(always)]
fn downwards<S: Simd>(simd: S, panel: &Panel, start: f64, length: f64, top: f64, width: f64) -> Row {
    let rule = &*RULE;
    let span = (panel.upper - panel.lower) / length;
    // The polynomial goes on a little beyond its panel, where rounding may put an edge.
    interpolated(simd, &panel.values, &rule.nodes.map(|x| ((top - start - width * x) / span).clamp(-1.0, 2.0)))
}

/// Sums over the pieces of the window, from η = 1 and ξ = 0 on.
struct Sums<'z> {
    zone: &'z Zone,
    /// ∫Q T_p dξ so far.
    moments: [f64; MOST_TERMS],
    /// T_q at the nodes of the piece.
    outer: [Row; MOST_TERMS],
    work: f64,
}

impl Sums<'_> {
    /// A piece of given width down from η = `top`, with Q and D at its nodes: all nodes side by side, a polynomial of ξ after the other.
    #[inline(always)]
    fn add<S: Simd>(&mut self, simd: S, (top, width): (f64, f64), loads: &Row, gaps: &Row) {
        let rule = &*RULE;
        let (a, length, terms) = (self.zone.contact_radius, self.zone.length, self.zone.terms);
        let etas: Row = rule.nodes.map(|x| top - width * x);
        // T_p of both places, and those before.
        let x = etas.map(|eta| 2.0 * (2.0 * eta - 1.0));
        let (mut last, mut here) = (x.map(|x| 0.5 * x), [1.0; POINTS]);
        for values in &mut self.outer[..terms] {
            *values = here;
            (last, here) = (here, next_chebyshev(simd, &x, &here, &last));
        }
        let x = rule.nodes.map(|x| 2.0 * (2.0 * (1.0 - top + width * x) - 1.0));
        (last, here) = (x.map(|x| 0.5 * x), [1.0; POINTS]);
        let loads_times_width = loads.map(|load| width * load);
        let mut remembered = [0.0; POINTS];
        for (p, (slopes, moment)) in self.zone.slope.chunks_exact(terms).zip(&mut self.moments).enumerate() {
            let weighted = product(simd, &loads_times_width, &here);
            let mut running = [*moment; POINTS];
            for (column, value) in rule.running.iter().zip(&weighted) {
                add_scaled(simd, &mut running, *value, column);
            }
            let mut kernel = [0.0; POINTS];
            for (slope, outer) in slopes[..terms - p].iter().zip(&self.outer) {
                add_scaled(simd, &mut kernel, *slope, outer);
            }
            add_product(simd, &mut remembered, &running, &kernel);
            *moment += sum(&product(simd, &rule.weights, &weighted));
            (last, here) = (here, next_chebyshev(simd, &x, &here, &last));
        }
        let work: Row = std::array::from_fn(|g| {
            let place = a + length * etas[g];
            let local = -FRAC_PI_2 * loads[g] / (place * (place - length)).sqrt();
            rule.weights[g] * gaps[g] * (local + remembered[g])
        });
        self.work += width * sum(&work);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::super::zone::Slope;
    use super::*;

    /// Digits don't depend on the machine: wide instructions and none, over breaks that coincide, slivers, terms from the fewest to the most.
    #[test]
    fn any_set_of_instructions_gives_the_same_digits() {
        let length = 0.013;
        for a in [1.1 * length, 2.7 * length, 0.24515, 3.0, 400.0] {
            let zone = Zone::new(a, length).unwrap();
            let ends = [0.0, 1e-9, 3e-4, 0.02, 0.3, 0.300_000_000_1, 0.77, 1.3].map(|part: f64| part * length);
            let wave = |s: f64| (300.0 * s).sin() - 0.4 * s;
            let inside: Vec<_> = ends.windows(2).rev().map(|pair| Panel::sampled(a - pair[1], a - pair[0], wave)).collect();
            let outside: Vec<_> = ends.windows(2).map(|pair| Panel::sampled(a + pair[0], a + pair[1], |s| 2.0 - wave(s))).collect();
            let scalar = pulp::Scalar::new().vectorize(Summation { zone: &zone, line_load: &inside, gap_factor: &outside });
            assert!(scalar.is_finite() && scalar != 0.0);
            assert_eq!(scalar.to_bits(), zone_work(&zone, &inside, &outside).to_bits(), "{a}");
            let kernel = pulp::Scalar::new().vectorize(Slope { contact_radius: a, length, terms: zone.terms });
            assert_eq!(kernel, zone.slope, "{a}");
        }
    }
}
