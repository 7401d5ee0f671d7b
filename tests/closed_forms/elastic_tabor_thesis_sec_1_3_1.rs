//! Tabor number and its words.
//!
//! Source: thesis Sec 1.3.1; Greenwood, Proc. R. Soc. A 453 (1997) 1277 (E* where the thesis prints E).
//! Goal: the number, its dependence on each argument, the labels.
//! Parameters: a rubber bead (JKR) and a silica bead (transition), a diamond tip (DMT).
//! Oracle: the identity μ³ε³ = R(Δγ/E*)²; and the geometry, the depth of the JKR neck at pull-off under load,
//! −Δ_A = (1/3)(9π/8)^{2/3}(RΔγ²/E*²)^{1/3}, in units of ε, from [`JkrSphere`].
//! Tolerance: 4e-15, a cube root and a dozen roundings.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use viscotack::elastic::tabor::{AdhesionRegime, rigid_pull_off_force};
use viscotack::elastic::{Control, JkrSphere, TaborNumber};

#[test]
fn number_is_the_height_of_the_neck_in_units_of_the_range() {
    for (radius, modulus, work, range, regime) in [
        (1.0e-3, 1.3e6, 0.05, 0.4e-9, AdhesionRegime::JohnsonKendallRoberts),
        (5.0e-6, 3.7e10, 0.05, 0.4e-9, AdhesionRegime::Transition),
        (2.0e-8, 1.1e12, 0.05, 0.4e-9, AdhesionRegime::DerjaguinMullerToporov),
    ] {
        let number = TaborNumber::new(radius, modulus, work, range).unwrap();
        assert_relative_eq!((number.value() * range).powi(3), radius * (work / modulus).powi(2), epsilon = 0.0, max_relative = 4e-15);
        let neck = -JkrSphere::new(radius, modulus, work).unwrap().pull_off(Control::Load).unwrap().penetration;
        assert_relative_eq!(neck / range, number.value() * (9.0 * PI / 8.0_f64).powf(2.0 / 3.0) / 3.0, epsilon = 0.0, max_relative = 4e-15);
        assert_eq!(number.regime(), regime);
        let millimetres = TaborNumber::new(radius * 1e3, modulus * 1e-6, work * 1e-3, range * 1e3).unwrap();
        assert_relative_eq!(number.value(), millimetres.value(), epsilon = 0.0, max_relative = 2e-15);
        let jkr = JkrSphere::new(radius, modulus, work).unwrap().pull_off_force();
        assert_relative_eq!(rigid_pull_off_force(radius, work).unwrap() / jkr, 4.0 / 3.0, epsilon = 0.0, max_relative = 1e-15);
    }
    assert!(TaborNumber::new(1.0, 1.0, 0.0, 1.0).is_err());
    assert!(TaborNumber::new(1.0, 1.0, 1.0, f64::NAN).is_err());
    assert!(TaborNumber::new(1e300, 1e-300, 1e300, 1e-300).is_err());
}
