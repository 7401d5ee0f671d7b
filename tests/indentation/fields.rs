//! Source: theory of the line (Sneddon 1965); Johnson, Kendall & Roberts (1971); thesis Figs 4.4, 4.6.
//!
//! Goal: pressure and surface displacement of a contact, elastic or with a path history.
//!
//! Parameters: a sphere R = 1 with E* = 10; a re-advanced contact of a solid with β = 10.
//!
//! Oracle: JKR's closed pressure; the shape of the indenter; the force, as the integral of the pressure.
//!
//! Tolerance: 1e-10 elastic (rounding of the slope of the load); 1e-6 for the integral over pressures with logarithmic and root singularities.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Contact, Profile, Springs, SurfaceFields, Sweep};
use viscotack::special::gauss_legendre::UNIT_RULE_20;

const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };

#[test]
fn elastic_fields_are_closed_forms() {
    let springs = Springs::new(&PlaneMaterial::from_relaxation(10.0, &[]).unwrap()).unwrap();
    let (a, depth) = (0.2, 0.03);
    let fields = SurfaceFields::of(&Contact::untouched(&springs, SPHERE, a, depth).unwrap());
    for r in [0.0, 1e-3, 0.05, 0.1, 0.19, 0.1999] {
        let chord = ((a - r) * (a + r)).sqrt();
        let exact = 10.0 / PI * (2.0 * chord - (a * a - depth) / chord);
        assert!((fields.pressure(r).unwrap() / exact - 1.0).abs() < 1e-10);
        assert!((fields.displacement(r).unwrap() - (depth - 0.5 * r * r)).abs() < 1e-13);
    }
    assert!(fields.pressure(a).is_err() && fields.pressure(-1.0).is_err());
    assert!(fields.pressure(0.3).unwrap().abs() < f64::MIN_POSITIVE);
    // Outside: (2/π)∫₀^a (Δ − s²)/√(r² − s²) ds = (2/π)[Δ asin(a/r) − (r² asin(a/r) − a√(r² − a²))/2].
    for r in [0.2001f64, 0.25, 1.0] {
        let angle = (a / r).asin();
        let exact = 2.0 / PI * (depth * angle - 0.5 * (r * r * angle - a * (r * r - a * a).sqrt()));
        assert!((fields.displacement(r).unwrap() - exact).abs() < 1e-12, "{r}");
    }
}

#[test]
fn a_contact_with_a_past_keeps_shape_and_force() {
    let springs = Springs::new(&PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap()).unwrap();
    let mut contact = Contact::relaxed(&springs, SPHERE, 0.2, 0.03).unwrap();
    for (a, depth, time) in [(0.15, 0.01, 1.0), (0.23, 0.04, 0.7)] {
        let (start, from) = (contact.radius(), contact.penetration());
        for step in 1..=40 {
            let part = f64::from(step) / 40.0;
            contact = contact.moved(start + (a - start) * part, from + (depth - from) * part, time / 40.0, Sweep::Linear).unwrap();
        }
    }
    let fields = SurfaceFields::of(&contact);
    for r in [0.0, 0.1, 0.16, 0.21, 0.2299] {
        assert!((fields.displacement(r).unwrap() - (0.04 - 0.5 * r * r)).abs() < 1e-12);
    }
    // A singularity at the upper end of a panel at most: r = upper − width·x² tames it.
    let mut force = 0.0;
    for panel in contact.line_load() {
        for &(x, weight) in UNIT_RULE_20.iter() {
            let width = panel.upper - panel.lower;
            let r = panel.upper - width * x * x;
            force += weight * 2.0 * width * x * 2.0 * PI * r * fields.pressure(r).unwrap();
        }
    }
    println!("force from pressures {force:e}, from the line {:e}", contact.force());
    assert!((force / contact.force() - 1.0).abs() < 1e-5);
}
