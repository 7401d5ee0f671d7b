//! Source: Lee (1955), correspondence of elastic and viscoelastic problems: E(s) = 9KG/(3K + G), E*(s) = 4G(3K + G)/(3K + 4G).
//!
//! Goal: the exact series of both moduli from a shear and a bulk series, and nearly equal times of any series.
//!
//! Oracle: `reference_data/isotropic_solid.csv` (mpmath, the rational functions and Talbot's inverse transform, no poles); the rational functions at
//! random frequencies; the creep functions J_E = J_G/3 + J_K/9 and J_E* = J_G/4 + (3/4) J of 3K + G, which are sums of positive terms.
//!
//! Tolerance: 1e-12 of the modulus; each bound covers its error.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::support;
use crate::support::physics;

use physics::Random;
use std::collections::BTreeMap;
use support::reference_rows;
use viscotack::material::isotropic::IsotropicSolid;
use viscotack::material::{CreepTerm, Material, RelaxationTerm};

type Complex = (f64, f64);

fn times((a, b): Complex, (c, d): Complex) -> Complex {
    (a * c - b * d, a * d + b * c)
}

fn over(x: Complex, (c, d): Complex) -> Complex {
    let size = c * c + d * d;
    let (re, im) = times(x, (c, -d));
    (re / size, im / size)
}

fn sum(a: f64, x: Complex, b: f64, y: Complex) -> Complex {
    (a * x.0 + b * y.0, a * x.1 + b * y.1)
}

fn modulus(material: &Material, frequency: f64) -> Complex {
    let modulus = material.complex_modulus(frequency).unwrap();
    (modulus.storage, modulus.loss)
}

fn relative(found: Complex, right: Complex) -> f64 {
    (found.0 - right.0).hypot(found.1 - right.1) / right.0.hypot(right.1)
}

fn series(relaxed: f64, terms: &[(f64, f64)]) -> Material {
    let terms: Vec<RelaxationTerm> = terms.iter().map(|&(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
    Material::from_relaxation(relaxed, &terms).unwrap()
}

#[derive(Default)]
struct Stored {
    relaxed: [f64; 2],
    strengths: [Vec<f64>; 2],
    times: [Vec<f64>; 2],
    /// (key, argument, value)
    checks: Vec<(String, f64, f64)>,
}

#[test]
fn stored_moduli_and_relaxation() {
    let mut solids: BTreeMap<String, Stored> = BTreeMap::new();
    for row in reference_rows("isotropic_solid.csv") {
        let solid = solids.entry(row.text("solid").to_owned()).or_default();
        let (key, value) = (row.text("key"), row.number("value"));
        if row.text("role") == "check" {
            solid.checks.push((key.to_owned(), row.number("argument"), value));
            continue;
        }
        let (part, kind) = key.split_once('_').unwrap();
        let part = usize::from(part == "bulk");
        match kind {
            "relaxed" => solid.relaxed[part] = value,
            "strength" => solid.strengths[part].push(value),
            _ => solid.times[part].push(value),
        }
    }
    assert!(solids.len() >= 24);
    for (name, stored) in solids {
        let made = [0, 1].map(|part| {
            let terms: Vec<(f64, f64)> = stored.strengths[part].iter().copied().zip(stored.times[part].iter().copied()).collect();
            series(stored.relaxed[part], &terms)
        });
        let [shear, bulk] = made;
        let solid = IsotropicSolid::new(shear, bulk).unwrap();
        for pair in stored.checks.chunks(2) {
            let (key, argument, value) = &pair[0];
            let material = if key.starts_with("plane") || key == "force" { solid.plane_strain().as_material() } else { solid.youngs() };
            match key.as_str() {
                "youngs_storage" | "plane_storage" => {
                    let error = relative(modulus(material, *argument), (*value, pair[1].2));
                    assert!(error < 1e-13 && error <= 1e-15 + material.modulus_rounding(), "{name} {key} {argument}: {error:e}");
                }
                "youngs_relaxation" => {
                    for (key, argument, value) in pair {
                        let material = if key.starts_with("plane") { solid.plane_strain().as_material() } else { solid.youngs() };
                        let error = (material.relaxation(*argument) / value - 1.0).abs();
                        assert!(error < 1e-12, "{name} {key} {argument}: {error:e}");
                    }
                }
                _ => {}
            }
        }
    }
}

#[test]
fn random_series_and_bulk_moduli() {
    let mut random = Random(39);
    for draw in 0..3000_u32 {
        let mut term = |scale: f64| {
            let time = random.decade(1e-6, 1e6);
            // Some times are those of both series, to the last digit.
            let time = if random.unit() < 0.3 { 10f64.powi(time.log10().round() as i32) } else { time };
            (scale * random.decade(1e-3, 10.0), time)
        };
        let unit = 7.3e5;
        let shear_terms: Vec<(f64, f64)> = (0..1 + draw % 12).map(|_| term(unit)).collect();
        let bulk_scale = unit * 10f64.powi(draw as i32 % 10 - 3);
        let bulk_terms: Vec<(f64, f64)> = (0..(draw / 12) % 4).map(|_| term(bulk_scale)).collect();
        let relaxed = if draw % 7 == 0 { 0.0 } else { unit * random.decade(1e-3, 10.0) };
        let (shear, bulk) = (series(relaxed, &shear_terms), series(bulk_scale, &bulk_terms));
        let solid = IsotropicSolid::new(shear.clone(), bulk.clone()).unwrap();
        let elastic = |g: f64, k: f64| [9.0 * k * g / (3.0 * k + g), 4.0 * g * (3.0 * k + g) / (3.0 * k + 4.0 * g)];
        let joined: Vec<(f64, f64)> = shear_terms.iter().copied().chain(bulk_terms.iter().map(|&(k, time)| (3.0 * k, time))).collect();
        let together = series(relaxed + 3.0 * bulk_scale, &joined);
        for (index, material) in [solid.youngs(), solid.plane_strain().as_material()].into_iter().enumerate() {
            let ends = [
                (material.glassy_modulus(), shear.glassy_modulus(), bulk.glassy_modulus()),
                (material.relaxed_modulus(), relaxed, bulk_scale),
            ];
            for (found, g, k) in ends {
                let right = elastic(g, k)[index];
                assert!((found - right).abs() <= 1e-12 * right, "draw {draw}: {found:e} for {right:e}");
            }
            assert!(material.relaxation_terms().iter().all(|term| term.modulus > 0.0));
            assert!(material.modulus_rounding() < 1e-11, "draw {draw}: {:e}", material.modulus_rounding());
            for _ in 0..8 {
                let frequency = random.decade(1e-8, 1e8);
                let (g, k) = (modulus(&shear, frequency), modulus(&bulk, frequency));
                let (three, four) = (sum(3.0, k, 1.0, g), sum(3.0, k, 4.0, g));
                let right = if index == 0 {
                    over(times((9.0 * k.0, 9.0 * k.1), g), three)
                } else {
                    over(times((4.0 * g.0, 4.0 * g.1), three), four)
                };
                let error = relative(modulus(material, frequency), right);
                assert!(error < 1e-12, "draw {draw} at {frequency:e}: {error:e}");
                let t = 1.0 / frequency;
                let creep =
                    if index == 0 { shear.creep(t) / 3.0 + bulk.creep(t) / 9.0 } else { shear.creep(t) / 4.0 + 0.75 * together.creep(t) };
                assert!(
                    (material.creep(t) / creep - 1.0).abs() < 1e-10,
                    "draw {draw} creep at {t:e}: {:e}",
                    material.creep(t) / creep - 1.0
                );
            }
        }
    }
}

#[test]
fn moduli_in_proportion_are_a_constant_poisson_ratio() {
    let terms = [(3.1e6, 0.02), (1.7e6, 4.1), (0.9e6, 300.0)];
    let (relaxed, factor) = (0.7e6, 2.9);
    let shear = series(relaxed, &terms);
    let solid = IsotropicSolid::new(shear.clone(), shear.stiffened(factor).unwrap()).unwrap();
    let ratio = (3.0 * factor - 2.0) / (2.0 * (3.0 * factor + 1.0));
    for found in solid.poisson_ratios() {
        assert!((found - ratio).abs() < 1e-15);
    }
    for frequency in [1e-4, 0.3, 5.0, 1e4] {
        let right = modulus(&shear.stiffened(2.0 / (1.0 - ratio)).unwrap(), frequency);
        assert!(relative(modulus(solid.plane_strain().as_material(), frequency), right) < 1e-14);
    }
}

#[test]
fn an_incompressible_limit_and_an_elastic_solid() {
    let shear = series(0.4e6, &[(1.6e6, 0.3)]);
    let solid = IsotropicSolid::new(shear.clone(), Material::elastic(1e18).unwrap()).unwrap();
    for frequency in [0.1, 3.0, 40.0] {
        let (g, plane) = (modulus(&shear, frequency), modulus(solid.plane_strain().as_material(), frequency));
        assert!(relative(plane, (4.0 * g.0, 4.0 * g.1)) < 1e-11);
    }
    let elastic = IsotropicSolid::new(Material::elastic(3.0e6).unwrap(), Material::elastic(5.0e6).unwrap()).unwrap();
    assert!(elastic.youngs().is_elastic() && (elastic.youngs().relaxed_modulus() / 7.5e6 - 1.0).abs() < 1e-15);
    assert!(IsotropicSolid::new(Material::elastic(1e6).unwrap(), series(0.0, &[(1e6, 1.0)])).is_err());
}

/// Times 1 to 100 rounding units apart, two or three of them, of both kinds of series: the same as one term with the summed strength.
#[test]
fn times_a_few_rounding_units_apart() {
    let far = |time: f64, ulps: u64| f64::from_bits(time.to_bits() + ulps);
    for time in [1.0945794310200747, 3.7e-9, 0.7, 8.1e6] {
        for ulps in (0..=100).filter(|ulps| *ulps < 12 || ulps % 11 == 1) {
            for count in [2usize, 3] {
                let close: Vec<f64> =
                    (0..count).map(|index| if index == 1 { far(time, ulps) } else { far(time, ulps / 2 * index as u64) }).collect();
                let others = [(0.3e6, 0.03 * time), (0.2e6, 50.0 * time)];
                let separate: Vec<(f64, f64)> = close.iter().map(|&time| (0.8e6, time)).chain(others).collect();
                let together: Vec<(f64, f64)> = std::iter::once((0.8e6 * count as f64, time)).chain(others).collect();
                let (separate, together) = (series(0.55e6, &separate), series(0.55e6, &together));
                let creeping = |terms: &[(f64, f64)]| {
                    let terms: Vec<CreepTerm> =
                        terms.iter().map(|&(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).collect();
                    Material::from_creep(3e6, &terms, None).unwrap()
                };
                let creep_separate = creeping(&close.iter().map(|&time| (4e-7, time)).chain([(2e-7, 9.0 * time)]).collect::<Vec<_>>());
                let creep_together = creeping(&[(4e-7 * count as f64, time), (2e-7, 9.0 * time)]);
                for (separate, together) in [(&separate, &together), (&creep_separate, &creep_together)] {
                    assert!((separate.glassy_modulus() / together.glassy_modulus() - 1.0).abs() < 1e-15);
                    for at in [0.01, 0.5, 1.0, 2.0, 30.0] {
                        let (t, frequency) = (at * time, at / time);
                        let errors = [
                            separate.relaxation(t) / together.relaxation(t) - 1.0,
                            separate.creep(t) / together.creep(t) - 1.0,
                            relative(modulus(separate, frequency), modulus(together, frequency)),
                            // The means carry the bounds of converted terms.
                            separate.mean_creep(t).value / together.mean_creep(t).value - 1.0,
                        ];
                        assert!(errors.iter().all(|error| error.abs() < 1e-13), "{time:e} {ulps} {count} at {at}: {errors:?}");
                        assert!(separate.mean_creep(t).relative_error < 1e-12 && separate.mean_relaxation(t).relative_error < 1e-12);
                    }
                }
                let solid = IsotropicSolid::new(separate.clone(), Material::elastic(4e6).unwrap()).unwrap();
                let one = IsotropicSolid::new(together.clone(), Material::elastic(4e6).unwrap()).unwrap();
                for at in [0.1, 1.0, 7.0] {
                    let (found, right) =
                        (modulus(solid.plane_strain().as_material(), at / time), modulus(one.plane_strain().as_material(), at / time));
                    assert!(relative(found, right) < 1e-13);
                }
            }
        }
    }
}
