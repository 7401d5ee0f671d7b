//! K of an edge that outruns the solid.
//!
//! Goal: behind such an edge lies a layer some 1e-10 of the contact thick, in which places have six digits; K has all of them nevertheless.
//!
//! Parameters: two scenes of the study of error bounds (`viscotack verify`) whose K scattered by 1e-8 to 1e-5, alike in all integrations; two tolerances.
//!
//! Oracle: over a surface that nothing has touched W is zero, so that Q at the advancing edge is the glassy answer to the overlap there, K = E∞*(f(a) − Δ)/√(πa),
//! as Q is continuous through an edge that moves. No panel of the line has a part in it.
//!
//! Tolerance: rounding.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::indentation::{Profile, integrate};
use viscotack_verification::studies::calibration::sphere::problem;

const TOLERANCE: f64 = 1e-11;

#[test]
fn the_intensity_of_an_edge_that_outruns_the_solid_is_the_glassy_one() {
    for scene in [368, 788] {
        let (material, problem) = problem(scene, 1e-4).unwrap();
        let Profile::Paraboloid { radius } = problem.profile else { panic!("a sphere") };
        let approach = problem.history.segments[0].duration;
        for tolerance in [1e-3, 1e-5] {
            let trace = integrate(&material, &problem, tolerance).unwrap();
            let (mut worst, mut uncertainty, mut count) = (0.0_f64, 0.0_f64, 0);
            for pair in trace.path.windows(2).filter(|pair| pair[1].time <= approach) {
                let [before, point] = pair else { continue };
                let a = point.contact_radius;
                // Only where the edge stands on fresh ground.
                if a <= before.contact_radius
                    || trace.path.iter().take_while(|one| one.time < point.time).any(|one| one.contact_radius >= a)
                {
                    continue;
                }
                let exact = material.glassy_modulus() * (a * a / radius - point.penetration) / (PI * a).sqrt();
                worst = worst.max((point.stress_intensity_factor / exact - 1.0).abs());
                uncertainty = uncertainty.max(point.unresolved_intensity / exact);
                count += 1;
            }
            println!("scene {scene} at {tolerance:e}: {worst:e} in {count} points");
            assert!(count > 50, "{count} points");
            assert!(worst <= TOLERANCE, "scene {scene}, {tolerance:e}: {worst:e} in {count} points, own uncertainty {uncertainty:e}");
        }
    }
}
