//! Stress intensity of a long crack in a strip.
//!
//! Source: thesis Eq 5.46 (K = σ√h, uniaxial); Rivlin & Thomas 1953 for G = 2hW; Rice 1967 for the held strip in plane strain.
//! Goal: the four combinations of sideways strain and plane state.
//!
//! ```text
//!   //////////////   h
//!   _______          —
//!   //////////////   h
//! ```
//!
//! Parameters: h = 6.7 mm, E = 3.1 MPa, σ = 0.21 MPa, ν from −0.4 to 0.499999.
//! Oracle: Hooke's law in three dimensions, solved here for the constrained stresses; W = ½σ:ε; G = 2hW; K² = G·E*. Nothing of c_W.
//! Tolerance: 1e-13, times the condition 1/(1 − 2ν) of the oracle near incompressibility.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use viscotack::Refusal;
use viscotack::elastic::pure_shear_strip::SidewaysStrain;
use viscotack::elastic::{PlaneState, PureShearStrip};

const H: f64 = 6.7e-3;
const E: f64 = 3.1e6;
const STRESS: f64 = 0.21e6;

/// Strain normal to the faces under σ_y = STRESS, with σ_x and σ_z found from the constraints.
fn strain_by_hooke(sideways: SidewaysStrain, plane: PlaneState, nu: f64) -> f64 {
    // Eε_x = σ_x − ν(σ_y + σ_z), Eε_z = σ_z − ν(σ_x + σ_y): a 2×2 system with zero stress or zero strain in each direction.
    let (sx, sz) = match (sideways, plane) {
        (SidewaysStrain::Free, PlaneState::Stress) => (0.0, 0.0),
        (SidewaysStrain::Free, PlaneState::Strain) => (0.0, nu * STRESS),
        (SidewaysStrain::Held, PlaneState::Stress) => (nu * STRESS, 0.0),
        // σ_x = ν(σ_y + σ_z) and σ_z = ν(σ_x + σ_y): by iteration, a contraction for |ν| < 1.
        (SidewaysStrain::Held, PlaneState::Strain) => (0..200).fold((0.0, 0.0), |(sx, sz), _| (nu * (STRESS + sz), nu * (sx + STRESS))),
    };
    (STRESS - nu * (sx + sz)) / E
}

#[test]
fn plane_moduli_are_hookes_law_with_a_free_and_a_held_thickness() {
    for nu in [-0.4, 0.0, 0.21, 0.3, 0.49, 0.5] {
        for plane in [PlaneState::Stress, PlaneState::Strain] {
            let by_hooke = STRESS / strain_by_hooke(SidewaysStrain::Free, plane, nu);
            assert_relative_eq!(plane.modulus(E, nu).unwrap(), by_hooke, max_relative = 4.0 * f64::EPSILON);
            assert_relative_eq!(plane.stiffening(nu).unwrap(), by_hooke / E, max_relative = 4.0 * f64::EPSILON);
        }
    }
}

#[test]
fn energy_of_the_strip_gives_the_stress_intensity() {
    for nu in [-0.4, 0.0, 0.17, 0.33, 0.45, 0.499, 0.499_999] {
        for sideways in [SidewaysStrain::Free, SidewaysStrain::Held] {
            for plane in [PlaneState::Stress, PlaneState::Strain] {
                let strip = PureShearStrip::new(H, sideways, plane, nu).unwrap();
                let strain = strain_by_hooke(sideways, plane, nu);
                let release = 2.0 * H * 0.5 * STRESS * strain;
                let factor = (release * plane.modulus(E, nu).unwrap()).sqrt();
                let tolerance = 1e-15 + 1e-15 / (1.0 - 2.0 * nu);
                assert_relative_eq!(strip.energy_release_rate(STRESS, E).unwrap(), release, epsilon = 0.0, max_relative = 4.0 * tolerance);
                assert_relative_eq!(strip.stress_intensity_factor(STRESS).unwrap(), factor, epsilon = 0.0, max_relative = 4.0 * tolerance);
                assert_relative_eq!(strip.stress(factor).unwrap(), STRESS, epsilon = 0.0, max_relative = 4.0 * tolerance);
                assert_relative_eq!(
                    strip.stress_by_grip_displacement(H * strain, E).unwrap(),
                    STRESS,
                    epsilon = 0.0,
                    max_relative = 4.0 * tolerance
                );
                let millimetres = PureShearStrip::new(H * 1e3, sideways, plane, nu).unwrap();
                let scaled = millimetres.stress_intensity_factor(STRESS * 1e-6).unwrap();
                assert_relative_eq!(
                    scaled * 1e6 * 1e-3_f64.sqrt(),
                    strip.stress_intensity_factor(STRESS).unwrap(),
                    epsilon = 0.0,
                    max_relative = 1e-15
                );
            }
        }
    }
}

#[test]
fn the_thesis_form_is_the_free_strip() {
    let strip = PureShearStrip::new(H, SidewaysStrain::Free, PlaneState::Stress, 0.5).unwrap();
    assert_relative_eq!(strip.stress_intensity_factor(STRESS).unwrap(), STRESS * H.sqrt(), epsilon = 0.0, max_relative = 1e-15);
    // A held incompressible sheet: √(3/4) of it.
    let sheet = PureShearStrip::new(H, SidewaysStrain::Held, PlaneState::Stress, 0.5).unwrap();
    assert_relative_eq!(
        sheet.stress_intensity_factor(STRESS).unwrap(),
        0.75_f64.sqrt() * STRESS * H.sqrt(),
        epsilon = 0.0,
        max_relative = 1e-15
    );
    let refusal = PureShearStrip::new(H, SidewaysStrain::Held, PlaneState::Strain, 0.5).unwrap_err();
    assert!(matches!(refusal, Refusal::Undefined { .. }));
    assert!(PureShearStrip::new(0.0, SidewaysStrain::Free, PlaneState::Stress, 0.3).is_err());
    assert!(strip.energy_release_rate(-1.0, E).is_err() && strip.stress_intensity_factor(f64::NAN).is_err());
}
