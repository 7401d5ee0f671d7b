//! Source: thesis Eq 4.9 and Sec 4.5 (point B); Johnson, Kendall & Roberts (1971).
//!
//! Goal: the closure on the line is the one equation; relaxed and glassy contacts are elastic ones at the same process zone.
//!
//! Parameters: γ̃ = 1.6e-4, δ̃ = 0.013, Δ̃_B = 0.032, β = 10 (chapter 4), and others, in two unit systems.
//!
//! Oracle: the printed state B; JKR as δ → 0; the closure by quadrature of the two fields ([`viscotack::closure`]) with the closed pressure and
//! gap of JKR's fields at any (a, Δ).
//!
//! Tolerance: printed digits; 1e-10 of the quadrature between the two forms of the closure; O(δ/a) to JKR, seen by halving δ.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::closure::{EdgeFields, process_zone_work};
use viscotack::elastic::{
    JkrSphere,
    control::{Control, EquilibriumBranch},
};
use viscotack::indentation::{Contact, Profile, Springs, elastic_contact, elastic_contact_of_radius, elliptic_k};

const WORK: f64 = 1.6e-4 * PI;
const ZONE: f64 = 0.013;
const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };

/// mpmath.ellipk, 20 digits.
#[test]
fn elliptic_integral_of_the_parameter() {
    for (m, value) in [
        (-3.0, 1.0782578237498216_f64),
        (-0.1, 1.5335928197134567),
        (0.0, std::f64::consts::FRAC_PI_2),
        (1e-3, 1.5711892469233443),
        (0.25, 1.685750354812596),
        (0.5, 1.8540746773013719),
        (0.9, 2.5780921133481732),
    ] {
        assert!((elliptic_k(m) / value - 1.0).abs() < 1e-15, "{m} {} {value}", elliptic_k(m));
    }
}

#[test]
fn point_b_of_the_thesis() {
    let b = elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.032).unwrap();
    println!("point B: a = {} F~ = {}", b.contact_radius, b.force / PI);
    assert!((b.contact_radius - 0.24515).abs() < 5e-6);
    assert!((b.force / PI - 1.868e-3).abs() < 5e-7);
    assert!(b.residual.abs() < 1e-12);
}

/// Fields of an elastic sphere at any (a, Δ): Hertz plus a flat punch.
struct Elastic {
    a: f64,
    lift: f64,
}

impl EdgeFields for Elastic {
    fn tension(&self, d: f64) -> f64 {
        let chord = (d * (2.0 * self.a - d)).sqrt();
        -(2.0 * chord - self.lift / chord) / PI
    }
    fn gap(&self, d: f64) -> f64 {
        let r = self.a + d;
        let chord = (d * (2.0 * self.a + d)).sqrt();
        let angle = chord.atan2(self.a);
        // (1/π)[a·chord + (r² − 2a²) acos(a/r)] + (2/π)(a² − Δ) acos(a/r)
        let hertz = if d < 1e-3 * self.a {
            // ∫_a^r (s² − a²)/√(r² − s²) ds by 400 midpoints of s = r cos θ: for the small distances only.
            (0..4000)
                .map(|i| {
                    let t = angle * (f64::from(i) + 0.5) / 4000.0;
                    (r * t.cos()).powi(2) - self.a * self.a
                })
                .sum::<f64>()
                * angle
                / 4000.0
                * 2.0
                / PI
        } else {
            (self.a * chord + (r * r - 2.0 * self.a * self.a) * angle) / PI
        };
        hertz + 2.0 / PI * self.lift * angle
    }
}

#[test]
fn closure_on_the_line_is_the_closure_of_the_fields() {
    for (a, lift, zone) in [(0.2, 0.02, 0.013), (0.05, 0.01, 0.02), (0.05, 0.003, 0.04), (0.3, 0.05, 1e-4)] {
        let springs = Springs::new(&PlaneMaterial::standard_solid(1.0, 1.0, 1.0).unwrap()).unwrap();
        let line = Contact::untouched(&springs, SPHERE, a, a * a - lift).unwrap().zone_work(zone).unwrap();
        let fields = process_zone_work(&Elastic { a, lift }, zone, 1e-11).unwrap();
        println!("a {a} zone {zone}: line {line:e} fields {:e} relative {:e}", fields.value, line / fields.value - 1.0);
        assert!((line / fields.value - 1.0).abs() < 1e-10);
    }
}

#[test]
fn tends_to_jkr_with_the_first_power_of_the_zone() {
    let (radius, modulus, work) = (3.2e-3, 7.1e5, 0.06);
    let jkr = JkrSphere::new(radius, modulus, work).unwrap();
    let depth = 2.0 * -jkr.pull_off(Control::Penetration).unwrap().penetration;
    let exact = jkr.state_by_penetration(depth, EquilibriumBranch::Stable).unwrap();
    let sphere = Profile::Paraboloid { radius };
    let defects: Vec<f64> = [2e-3, 1e-3, 5e-4]
        .iter()
        .map(|ratio| {
            elastic_contact(&sphere, modulus, work, ratio * exact.contact_radius, depth).unwrap().contact_radius / exact.contact_radius
                - 1.0
        })
        .collect();
    println!("{defects:?}");
    assert!(defects[2].abs() < 5e-4);
    for pair in defects.windows(2) {
        assert!((pair[0] / pair[1] - 2.0).abs() < 0.02);
    }
    // The two controls name the same states.
    let found = elastic_contact(&sphere, modulus, work, 1e-5, depth).unwrap();
    let back = elastic_contact_of_radius(&sphere, modulus, work, 1e-5, found.contact_radius).unwrap();
    assert!((back.penetration / depth - 1.0).abs() < 1e-12 && (back.force / found.force - 1.0).abs() < 1e-11);
}
