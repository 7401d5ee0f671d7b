//! Source: `material/fit`: solids and liquids, many rows, draws, shifts of isotherms found from the data.
//!
//! Goal: creep and relaxation of liquids are fitted as liquids, of solids as solids, and what cannot be decided is said to be open; many rows give the fit
//! of few; draws scatter as the stated errors say; shift factors come back within their errors, and a failing superposition is found.
//!
//! Oracle: the closed forms that the data were made of. Tolerances: 1e-6 for data without noise; stated errors for the others, with the number of misses
//! that chance allows.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use support::random::Uniform;
use viscotack::material::fit::superposition::{Isotherm, superpose};
use viscotack::material::fit::{Observation, Quantity, SeriesFit, Wanted, complex_modulus, fit};
use viscotack::material::{Material, RelaxationTerm};

/// Standard normal numbers by Box and Muller.
fn normal(uniform: &mut Uniform) -> f64 {
    (-2.0 * uniform.between(1e-300, 1.0).ln()).sqrt() * (std::f64::consts::TAU * uniform.between(0.0, 1.0)).cos()
}

fn curve(
    quantity: Quantity,
    [from, to]: [f64; 2],
    count: u32,
    noise: f64,
    uniform: &mut Uniform,
    of: &dyn Fn(f64) -> f64,
) -> Vec<Observation> {
    (0..=count)
        .map(|index| {
            let at = from * (to / from).powf(f64::from(index) / f64::from(count));
            let value = of(at) * (1.0 + noise * normal(uniform));
            Observation { quantity, at, value, scale: value }
        })
        .collect()
}

fn scatter(data: &[Observation]) -> SeriesFit {
    fit(data, Wanted::Scatter).unwrap()
}

/// E = 2 GPa; η = 8 TPa s; 1/0.9 GPa with 40 s.
fn burgers(flow: f64, time: f64) -> f64 {
    0.5e-9 + flow * time / 8e12 + (1.0 - (-time / 40.0).exp()) / 0.9e9
}

#[test]
fn creep_of_liquids_flows_and_creep_of_solids_does_not() {
    let mut uniform = Uniform::new();
    for flow in [1.0, 0.0] {
        let exact = scatter(&curve(Quantity::Creep, [0.1, 1e4], 40, 0.0, &mut uniform, &|time| burgers(flow, time)));
        assert!((exact.material.glassy_modulus() / 2e9 - 1.0).abs() < 1e-6);
        assert_eq!(exact.rest.liquid, flow > 0.0, "{:?}", exact.rest);
        assert!(exact.rest.decided(), "{:?}", exact.rest);
        match exact.material.steady_viscosity() {
            Some(viscosity) => assert!((viscosity / 8e12 - 1.0).abs() < 1e-6),
            None => assert!((exact.material.relaxed_modulus() * (0.5e-9 + 1.0 / 0.9e9) - 1.0).abs() < 1e-6),
        }
        let mut right = 0;
        for _ in 0..10 {
            let fitted = scatter(&curve(Quantity::Creep, [0.1, 1e4], 40, 0.01, &mut uniform, &|time| burgers(flow, time)));
            let wrong = fitted.rest.liquid != (flow > 0.0);
            assert!(!(wrong && fitted.rest.decided()), "{:?}", fitted.rest);
            right += usize::from(!wrong);
        }
        assert!(right >= 8, "{right}");
    }
    // Over a tenth of its time a solid looks like a liquid: nothing is decided.
    let short = scatter(&curve(Quantity::Creep, [0.01, 4.0], 30, 0.02, &mut uniform, &|time| burgers(0.0, time)));
    assert!(!short.rest.decided(), "{:?}", short.rest);
}

#[test]
fn moduli_and_relaxation_of_liquids_have_no_relaxed_modulus() {
    let mut uniform = Uniform::new();
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    for relaxed in [0.0, 3e5] {
        let material = Material::from_relaxation(relaxed, &[term(2e6, 0.02), term(5e5, 1.0), term(8e4, 20.0)]).unwrap();
        for noise in [0.0, 0.02] {
            let relaxation = curve(Quantity::Relaxation, [1e-3, 200.0], 45, noise, &mut uniform, &|time| material.relaxation(time));
            let mut moduli = Vec::new();
            for index in 0..=36 {
                let at = 1e-2 * 10f64.powf(f64::from(index) / 6.0);
                let modulus = material.complex_modulus(at).unwrap();
                let [storage, loss] = [modulus.storage, modulus.loss].map(|value| value * (1.0 + noise * normal(&mut uniform)));
                moduli.extend(complex_modulus(at, storage, loss));
            }
            for data in [relaxation, moduli] {
                let fitted = scatter(&data);
                assert_eq!(fitted.rest.liquid, relaxed <= 0.0, "{:?} {noise}", fitted.rest);
                let off = (fitted.material.relaxed_modulus() - relaxed).abs();
                assert!(off <= 1e-6 * relaxed + 2.0 * noise * relaxed, "{off:e}");
            }
        }
    }
}

/// Nine terms, a decade apart, and E0 = 0.7 MPa.
fn nine() -> Material {
    let term = |index: i32| RelaxationTerm { modulus: 3e5 * 2f64.powi(8 - index), relaxation_time: 10f64.powi(index - 4) };
    Material::from_relaxation(7e5, &(0..9).map(term).collect::<Vec<_>>()).unwrap()
}

fn sweep(
    material: &Material,
    [from, to]: [f64; 2],
    count: u32,
    noise: f64,
    uniform: &mut Uniform,
    factor: f64,
    vertical: f64,
) -> Vec<Observation> {
    (0..=count)
        .flat_map(|index| {
            let at = from * (to / from).powf(f64::from(index) / f64::from(count));
            let modulus = material.complex_modulus(at * factor).unwrap();
            let [storage, loss] = [modulus.storage, modulus.loss].map(|value| value / vertical * (1.0 + noise * normal(uniform)));
            complex_modulus(at, storage, loss)
        })
        .collect()
}

#[test]
fn many_rows_are_combined_without_loss() {
    let (material, mut uniform) = (nine(), Uniform::new());
    let fitted = scatter(&sweep(&material, [1e-5, 1e5], 6000, 0.0, &mut uniform, 1.0, 1.0));
    assert_eq!(fitted.observations, 12002);
    assert_eq!(fitted.material.relaxation_terms().len(), 9);
    for (found, given) in fitted.material.relaxation_terms().iter().zip(material.relaxation_terms()) {
        assert!((found.modulus / given.modulus - 1.0).abs() < 1e-6 && (found.relaxation_time / given.relaxation_time - 1.0).abs() < 1e-6);
    }
    assert!(fitted.largest_error < 1e-6, "{:e}", fitted.largest_error);
    // With noise the errors are small, and numbers that scatter down weigh no more than those that scatter up: no bias of σ² is left.
    let fitted = scatter(&sweep(&material, [1e-5, 1e5], 20_000, 0.05, &mut uniform, 1.0, 1.0));
    assert!((fitted.rms_error / 0.05 - 1.0).abs() < 0.02, "{}", fitted.rms_error);
    let off: f64 = (0..40)
        .map(|index| {
            let at = 10f64.powf(f64::from(index) / 4.0 - 5.0);
            fitted.material.complex_modulus(at).unwrap().storage / material.complex_modulus(at).unwrap().storage - 1.0
        })
        .sum::<f64>()
        / 40.0;
    assert!(off.abs() < 6e-4, "{off:e}");
}

#[test]
fn draws_scatter_as_the_stated_error_says() {
    let (material, mut uniform) = (nine(), Uniform::new());
    let fitted = scatter(&sweep(&material, [1e-5, 1e5], 50, 0.02, &mut uniform, 1.0, 1.0));
    let draws = fitted.draws(300, 5).unwrap();
    assert_eq!(draws, fitted.draws(300, 5).unwrap());
    assert_eq!(draws[..20], fitted.draws(20, 5).unwrap());
    assert!(draws != fitted.draws(300, 6).unwrap());
    for at in [1e-3, 0.1, 10.0, 1e3] {
        let value = |material: &Material| material.complex_modulus(at).unwrap().loss;
        let square = draws.iter().map(|draw| (value(draw) - value(&fitted.material)).powi(2)).sum::<f64>() / 300.0;
        let ratio = 2.0 * square.sqrt() / fitted.band.error(Quantity::Loss, at);
        assert!((0.7..1.4).contains(&ratio), "{at}: {ratio}");
    }
}

/// ln a_T by WLF with c1 = 9, c2 = 110 K at 293.15 K.
fn shift(temperature: f64) -> f64 {
    let above = temperature - 293.15;
    -std::f64::consts::LN_10 * 9.0 * above / (110.0 + above)
}

#[test]
fn shifts_come_back_within_their_errors() {
    let (material, mut uniform) = (nine(), Uniform::new());
    for (noise, vertical, reference) in
        [(0.0, false, None), (0.02, false, Some(293.15)), (0.01, true, Some(293.15)), (0.02, false, Some(298.0))]
    {
        let isotherms: Vec<Isotherm> = (0..7)
            .map(|index| {
                let temperature = 263.15 + 10.0 * f64::from(index);
                let factor = if vertical { 293.15 / temperature } else { 1.0 };
                Isotherm { temperature, data: sweep(&material, [0.03, 30.0], 12, noise, &mut uniform, shift(temperature).exp(), factor) }
            })
            .collect();
        let found = superpose(&isotherms, reference, vertical, Wanted::Scatter).unwrap();
        assert_eq!(found.holds(), Some(true), "{} {:?}", found.together, found.alone);
        assert!((found.reference - reference.unwrap_or(293.15)).abs() < 1e-9);
        let origin = found.shifts[found.base];
        let mut missed = 0;
        for one in &found.shifts {
            let off = (one.logarithm - origin.logarithm - shift(one.temperature) + shift(origin.temperature)).abs();
            missed += usize::from(off > one.error + 1e-6);
            assert!(off <= 2.5 * one.error + 1e-6, "{} K: {off} with {}", one.temperature, one.error);
            if vertical {
                let off = (one.vertical - (293.15 / one.temperature).ln()).abs();
                assert!(off <= 2.5 * one.vertical_error + 1e-6, "{} K: vertical {off} with {}", one.temperature, one.vertical_error);
            }
        }
        assert!(missed <= 2, "{missed}");
        let law = found.williams_landel_ferry.unwrap();
        assert!(
            (law.constants[0] - 9.0).abs() <= 2.0 * law.errors[0] + 1e-4 && (law.constants[1] - 110.0).abs() <= 2.0 * law.errors[1] + 1e-2,
            "{law:?}"
        );
        // At another temperature the material is drawn with its factor: as well known as at the reference.
        let draws = found.draws_at(283.15, 50, 3).unwrap();
        let truth = material.slowed(shift(283.15).exp()).unwrap().complex_modulus(1.0).unwrap().storage;
        let mean = draws.iter().map(|draw| draw.complex_modulus(1.0).unwrap().storage).sum::<f64>() / 50.0;
        assert!((mean / truth - 1.0).abs() < 1e-5 + 2.0 * noise, "{}", mean / truth);
    }
}

#[test]
fn isotherms_of_two_processes_are_no_one_curve_and_distant_ones_do_not_meet() {
    let mut uniform = Uniform::new();
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    let isotherms: Vec<Isotherm> = (0..6)
        .map(|index| {
            let temperature = 273.15 + 10.0 * f64::from(index);
            let arrhenius = |energy: f64| (energy / 8.314_462_618 * (1.0 / temperature - 1.0 / 293.15)).exp();
            let (fast, slow) = (arrhenius(6e4), arrhenius(2.2e5));
            let terms = [term(3e8, 1e-4 * fast), term(5e7, 1e-2 * fast), term(2e7, 0.1 * slow), term(8e6, slow), term(3e6, 10.0 * slow)];
            let material = Material::from_relaxation(1e6, &terms).unwrap();
            Isotherm { temperature, data: sweep(&material, [0.03, 30.0], 12, 0.01, &mut uniform, 1.0, 1.0) }
        })
        .collect();
    let found = superpose(&isotherms, None, false, Wanted::Scatter).unwrap();
    assert_eq!(found.holds(), Some(false), "{} {:?}", found.together, found.alone);
    let separate: Vec<Isotherm> = [263.15, 333.15]
        .into_iter()
        .map(|temperature: f64| Isotherm {
            temperature,
            data: sweep(&nine(), [0.3, 3.0], 8, 0.01, &mut uniform, shift(temperature).exp(), 1.0),
        })
        .collect();
    let refusal = superpose(&separate, None, false, Wanted::Scatter).unwrap_err().to_string();
    assert!(refusal.contains("do not overlap"), "{refusal}");
    assert!(superpose(&separate[..1], None, false, Wanted::Scatter).is_err());
    assert!(superpose(&separate, Some(400.0), false, Wanted::Scatter).is_err());
}
