//! Source: thesis Sec 2.1, Eqs 2.5–2.9 and 2.19; Gross, *Mathematical Structure of the Theories of Viscoelasticity* (1953).
//!
//! Goal: the two series of one material are two views of the same solid: each converted term, the functions of time and of frequency,
//! and the exact identities between them.
//!
//! ```text
//!   J(t) = 1/E∞ + Σ J_j (1 − e^{−t/τ_j}) + t/η   ⇄   R(t) = E0 + Σ E_i e^{−t/ρ_i}        ∫₀^t R(t − s) J(s) ds = t
//! ```
//! Parameters: 1 to 40 terms over up to 12 decades, β up to 1e6, fluids (E0 = 0), times that agree in six digits, vanishing terms.
//!
//! Oracle: `reference_data/material_conversion.csv` (mpmath, 120 digits, secular roots by bisection in the logarithm of the shift), and
//! identities that need no reference: reciprocity, round trips, invariance under splitting, permuting and a change of units.
//!
//! Tolerance: each term within its own error bound and 1e-14 where the term is well conditioned. What a perturbation of the input by half
//! an ulp does is part of the bound where the two sides start from different doubles. 1e-14 for functions: sums of positive terms.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, missing_docs)]

use crate::support;
use crate::support::physics;

use physics::{Random, in_mpa_ms, random_solid, relative};
use std::collections::HashMap;
use support::{Row, reference_rows};
use viscotack::Refusal;
use viscotack::material::{CreepTerm, GivenSeries, Material, RelaxationTerm};
use viscotack::special::gauss_legendre::UNIT_RULE;

const HALF_ULP: f64 = 0.5 * f64::EPSILON;

/// The rows of one material with one role and key, in the order of the file.
fn column<'a>(rows: &'a [Row], name: &str, role: &str, key: &str) -> Vec<&'a Row> {
    rows.iter().filter(|row| row.text("material") == name && row.text("role") == role && row.text("key") == key).collect()
}

fn numbers(rows: &[Row], name: &str, role: &str, key: &str) -> Vec<f64> {
    column(rows, name, role, key).iter().map(|row| row.number("value")).collect()
}

/// The materials of the file, made from its input rows.
fn materials(rows: &[Row]) -> HashMap<String, Material> {
    let mut result = HashMap::new();
    for row in rows.iter().filter(|row| row.text("key") == "kind") {
        let name = row.text("material");
        let pairs = |strength: &str, time: &str| {
            numbers(rows, name, "input", strength).into_iter().zip(numbers(rows, name, "input", time)).collect::<Vec<_>>()
        };
        let material = if row.text("value") == "creep" {
            let terms: Vec<CreepTerm> = pairs("creep_strength", "retardation_time")
                .into_iter()
                .map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time })
                .collect();
            let flow = numbers(rows, name, "input", "flow_viscosity").first().copied();
            Material::from_creep(numbers(rows, name, "input", "glassy_modulus")[0], &terms, flow)
        } else {
            let terms: Vec<RelaxationTerm> = pairs("relaxation_strength", "relaxation_time")
                .into_iter()
                .map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time })
                .collect();
            Material::from_relaxation(numbers(rows, name, "input", "relaxed_modulus")[0], &terms)
        };
        result.insert(name.to_owned(), material.unwrap());
    }
    result
}

/// (strength, time) of the series that was computed, longest time first.
fn converted(material: &Material) -> Vec<(f64, f64)> {
    match material.given() {
        GivenSeries::Creep => material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect(),
        GivenSeries::Relaxation => material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect(),
    }
}

/// (strength, time) of the series that was given, longest time first.
fn given(material: &Material) -> Vec<(f64, f64)> {
    match material.given() {
        GivenSeries::Relaxation => material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect(),
        GivenSeries::Creep => material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect(),
    }
}

/// The same material made from the series that was computed.
fn back(material: &Material) -> Material {
    match material.given() {
        GivenSeries::Creep => Material::from_relaxation(material.relaxed_modulus(), material.relaxation_terms()),
        GivenSeries::Relaxation => Material::from_creep(material.glassy_modulus(), material.creep_terms(), material.steady_viscosity()),
    }
    .unwrap()
}

#[test]
fn every_converted_term_is_within_its_bar_and_the_bar_is_not_idle() {
    let rows = reference_rows("material_conversion.csv");
    let (mut ratios, mut worst, mut compared, mut tight) = (Vec::new(), 0.0_f64, 0, 0);
    for (name, material) in materials(&rows) {
        let [strength_key, time_key] = match material.given() {
            GivenSeries::Creep => ["relaxation_strength", "relaxation_time"],
            GivenSeries::Relaxation => ["creep_strength", "retardation_time"],
        };
        // The file counts from the shortest time, the material from the longest.
        let mut strengths = numbers(&rows, &name, "output", strength_key);
        let mut times = numbers(&rows, &name, "output", time_key);
        strengths.reverse();
        times.reverse();
        let terms = converted(&material);
        assert_eq!(terms.len(), strengths.len(), "{name}");
        assert_eq!(terms.len(), material.conversion_errors().len(), "{name}");
        for (index, ((strength, time), error)) in terms.iter().zip(material.conversion_errors()).enumerate() {
            let (strength_error, time_error) = (relative(*strength, strengths[index]), relative(*time, times[index]));
            // The reference itself is rounded to a double: half an ulp.
            assert!(strength_error <= error.strength + HALF_ULP, "{name} strength {index}: {strength_error:e} above {:e}", error.strength);
            assert!(time_error <= error.time + HALF_ULP, "{name} time {index}: {time_error:e} above {:e}", error.time);
            compared += 2;
            ratios.push(error.strength / strength_error.max(HALF_ULP));
            ratios.push(error.time / time_error.max(HALF_ULP));
            worst = worst.max(time_error);
            // A term is well conditioned where the last digit of the input is not magnified.
            if error.strength_input < 20.0 * HALF_ULP {
                tight += 1;
                worst = worst.max(strength_error);
                assert!(strength_error <= 1e-14 && time_error <= 1e-14, "{name} {index}: {strength_error:e} {time_error:e}");
                assert!(error.strength <= 3e-14, "{name} {index}: bound {:e}", error.strength);
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    println!(
        "{compared} numbers, {tight} well-conditioned terms, worst {worst:.1e}, bound over error: median {median:.1}, largest {:.0}",
        ratios[ratios.len() - 1]
    );
    assert!(compared > 250 && tight > 70, "{compared} {tight}");
    assert!(median < 100.0, "the bounds are idle: {median}");
}

#[test]
fn functions_of_time_and_frequency() {
    let rows = reference_rows("material_conversion.csv");
    let (mut worst, mut count) = (HashMap::<String, f64>::new(), 0);
    for (name, material) in materials(&rows) {
        for row in rows.iter().filter(|row| row.text("material") == name && row.text("role") == "check") {
            let (key, argument, expected) = (row.text("key"), row.number("argument"), row.number("value"));
            let value = match key {
                "creep" => material.creep(argument),
                "relaxation" => material.relaxation(argument),
                "storage_modulus" => material.complex_modulus(argument).unwrap().storage,
                "loss_modulus" => material.complex_modulus(argument).unwrap().loss,
                other => panic!("{other}"),
            };
            // Far down an exponential, the rounding of t/ρ is magnified by t/ρ: only a fluid relaxes that far.
            let argument_error = if material.relaxed_modulus() == 0.0 && key == "relaxation" {
                argument / material.longest_relaxation_time().unwrap() * f64::EPSILON
            } else {
                0.0
            };
            let error = relative(value, expected);
            assert!(error <= 1e-14 + argument_error, "{name} {key} at {argument:e}: {value:e} for {expected:e} ({error:e})");
            let largest = worst.entry(key.to_owned()).or_default();
            *largest = largest.max(error);
            count += 1;
        }
        for (key, value) in [
            ("glassy_modulus", material.glassy_modulus()),
            ("relaxed_modulus", material.relaxed_modulus()),
            ("flow_viscosity", material.steady_viscosity().unwrap_or(0.0)),
        ] {
            for expected in numbers(&rows, &name, "output", key) {
                assert!(value == expected || relative(value, expected) <= 1e-15, "{name} {key}: {value:e} for {expected:e}");
            }
        }
    }
    println!("{count} values, worst {worst:?}");
    assert!(count > 300);
}

#[test]
fn loss_tangent_is_the_ratio_and_its_limits_are_right() {
    let rows = reference_rows("material_conversion.csv");
    for (name, material) in materials(&rows) {
        let storage = column(&rows, &name, "check", "storage_modulus");
        let loss = numbers(&rows, &name, "check", "loss_modulus");
        for (row, loss) in storage.iter().zip(loss) {
            let modulus = material.complex_modulus(row.number("argument")).unwrap();
            assert!(relative(modulus.loss_tangent(), loss / row.number("value")) <= 2e-14, "{name}");
            assert!(relative(modulus.magnitude(), row.number("value").hypot(loss)) <= 2e-14, "{name}");
        }
        let fast = material.complex_modulus(1e200).unwrap();
        assert!(relative(fast.storage, material.glassy_modulus()) <= 1e-14 && fast.loss_tangent() < 1e-100, "{name}");
        if material.relaxed_modulus() > 0.0 {
            let rest = material.complex_modulus(0.0).unwrap();
            assert!(rest.storage == material.relaxed_modulus() && rest.loss == 0.0 && rest.loss_tangent() == 0.0, "{name}");
        } else {
            assert!(matches!(material.complex_modulus(0.0), Err(Refusal::Undefined { .. })), "{name}");
        }
        assert!(material.complex_modulus(-1.0).is_err() && material.complex_modulus(f64::NAN).is_err());
    }
}

/// A spread-out spectrum: its terms are well conditioned, whatever their number.
fn spread(count: usize, decades: f64, beta: f64, slope: f64) -> Vec<(f64, f64)> {
    (0..count)
        .map(|index| {
            let place = index as f64 / (count as f64 - 1.0).max(1.0);
            let time = 3.7e-9 * 10f64.powf(decades * place) * (1.0 + 0.05 * ((index * 7) % 5) as f64);
            ((beta - 1.0) / count as f64 * (0.4 + 0.3 * ((index * 3) % 4) as f64) * 10f64.powf(slope * place), time)
        })
        .collect()
}

#[test]
fn round_trips_are_exact_to_1e14_for_12_and_40_terms() {
    for (count, decades, beta, slope) in
        [(1, 0.0, 1e6, 0.0), (12, 12.0, 1e3, 0.0), (12, 12.0, 1e6, 0.5), (40, 12.0, 1e4, 0.0), (40, 12.0, 1e6, 3.0), (40, 12.0, 1e6, -3.0)]
    {
        let (relaxed, glassy) = (2.3e5, 7.1e8);
        let creep: Vec<CreepTerm> = spread(count, decades, beta, slope)
            .into_iter()
            .map(|(strength, retardation_time)| CreepTerm { compliance: strength / glassy, retardation_time })
            .collect();
        let relaxation: Vec<RelaxationTerm> = spread(count, decades, beta, slope)
            .into_iter()
            .map(|(strength, relaxation_time)| RelaxationTerm { modulus: strength * relaxed, relaxation_time })
            .collect();
        for material in [Material::from_creep(glassy, &creep, None).unwrap(), Material::from_relaxation(relaxed, &relaxation).unwrap()] {
            let twice = back(&material);
            let mut worst = 0.0_f64;
            for ((strength, time), (again_strength, again_time)) in given(&material).into_iter().zip(converted(&twice)) {
                worst = worst.max(relative(again_strength, strength)).max(relative(again_time, time));
            }
            println!("{count} terms, β {:.0e}, {:?}: {worst:.1e}", material.stiffening_ratio(), material.given());
            assert!(worst <= 1e-14, "{count} terms, β {beta:e}, {:?}: {worst:e}", material.given());
            assert!(relative(twice.glassy_modulus(), material.glassy_modulus()) <= 1e-14);
            assert!(relative(twice.relaxed_modulus(), material.relaxed_modulus()) <= 1e-14);
        }
    }
}

#[test]
fn round_trips_of_random_materials_stay_within_the_bounds() {
    let mut random = Random(11);
    let (mut worst_ratio, mut terms) = (0.0_f64, 0);
    for _ in 0..300 {
        let material = random_solid(&mut random, 20, 12.0, 1e6).as_material().clone();
        let twice = back(&material);
        // The second conversion starts from numbers that carry the errors of the first: how many half ulps, at most?
        let forward = material.conversion_errors().iter().fold(0.0_f64, |most, error| most.max(error.strength).max(error.time));
        let moved = (forward + 2.0 * f64::EPSILON) / HALF_ULP;
        for (((strength, time), (again_strength, again_time)), error) in
            given(&material).into_iter().zip(converted(&twice)).zip(twice.conversion_errors())
        {
            let strength_bar = error.strength + error.strength_input * moved;
            let time_bar = error.time + error.time_input * moved;
            let (strength_error, time_error) = (relative(again_strength, strength), relative(again_time, time));
            assert!(
                strength_error <= strength_bar && time_error <= time_bar,
                "{strength_error:e} {strength_bar:e} {time_error:e} {time_bar:e}"
            );
            worst_ratio = worst_ratio.max(strength_error / strength_bar);
            terms += 1;
        }
    }
    println!("{terms} terms, largest error over bound {worst_ratio:.2}");
}

#[test]
fn nearly_equal_times_are_bounded_by_arithmetic_and_input_together() {
    // The same doubles made in two ways: the second input differs by roundings, so its terms may differ by the input part of the bound.
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for gap in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11] {
        for scale in [1.0, 3.0, 7.0, 11.0, 13.7] {
            let terms = [(2.3e-8, 0.0123), (3.1e-8, 0.0123 * (1.0 + gap)), (5.7e-8, 1.7)];
            let solid = |factor: f64| {
                let creep: Vec<CreepTerm> = terms
                    .iter()
                    .map(|&(compliance, time)| CreepTerm { compliance: compliance * factor / factor, retardation_time: time * factor })
                    .collect();
                Material::from_creep(6.1e8, &creep, None).unwrap()
            };
            let (first, second) = (solid(1.0), solid(scale));
            for ((one, two), (error, other)) in first
                .relaxation_terms()
                .iter()
                .zip(second.relaxation_terms())
                .zip(first.conversion_errors().iter().zip(second.conversion_errors()))
            {
                let strength_bar = error.strength + other.strength + 2.0 * (error.strength_input + other.strength_input);
                let time_bar = error.time + other.time + 2.0 * (error.time_input + other.time_input);
                let strength_error = relative(two.modulus, one.modulus);
                let time_error = relative(two.relaxation_time, one.relaxation_time * scale);
                assert!(strength_error <= strength_bar, "gap {gap:e}: {strength_error:e} above {strength_bar:e}");
                assert!(time_error <= time_bar + f64::EPSILON, "gap {gap:e}: {time_error:e} above {time_bar:e}");
                worst = worst.max(strength_error / strength_bar);
                largest = largest.max(strength_error);
            }
            // However ill a single term is known, the functions are not.
            for time in [1e-5, 1e-3, 0.0123, 0.2, 5.0] {
                assert!(relative(second.relaxation(time * scale), first.relaxation(time)) <= 3e-14, "gap {gap:e} at {time:e}");
            }
        }
    }
    println!("largest change of a strength {largest:.1e}, largest part of its bound {worst:.2}");
    assert!(largest > 1e-8, "the case is not ill conditioned: {largest:e}");
}

/// ∫₀^t R(t − s) J(s) ds by Gauss panels that halve towards both ends.
fn convolution(relaxation: impl Fn(f64) -> f64, creep: impl Fn(f64) -> f64, time: f64) -> f64 {
    let mut sum = 0.0;
    let mut width = 0.25 * time;
    let mut left = width;
    for _ in 0..64 {
        let panel: f64 = UNIT_RULE
            .iter()
            .map(|&(node, weight)| {
                let near = left + width * node;
                weight * (relaxation(time - near) * creep(near) + relaxation(near) * creep(time - near))
            })
            .sum();
        sum += width * panel;
        width *= 0.5;
        left -= width;
    }
    sum
}

#[test]
fn creep_and_relaxation_are_reciprocal_under_convolution() {
    let mut random = Random(23);
    let mut worst = 0.0_f64;
    let rows = reference_rows("material_conversion.csv");
    let named: Vec<Material> = materials(&rows).into_values().collect();
    for material in (0..60).map(|_| random_solid(&mut random, 20, 12.0, 1e6).as_material().clone()).chain(named) {
        let (shortest, longest) = (
            material.relaxation_terms().last().unwrap().relaxation_time,
            material.longest_retardation_time().or(material.longest_relaxation_time()).unwrap(),
        );
        for exponent in [-0.1, 0.1, 0.3, 0.5, 0.7, 0.9, 1.1] {
            let time = shortest * (longest / shortest).powf(exponent) * 1.3;
            let error = relative(convolution(|t| material.relaxation(t), |t| material.creep(t), time), time);
            worst = worst.max(error);
            assert!(error <= 5e-14, "{} terms, t = {time:e}: {error:e}", material.creep_terms().len());
        }
    }
    println!("worst departure from reciprocity {worst:.1e}");
}

#[test]
fn errata_2_5_and_2_6_each_term_has_its_own_time_and_the_two_series_their_own_numbers() {
    let material = Material::from_creep(
        2.2e8,
        &[CreepTerm { compliance: 4.7e-8, retardation_time: 2.9e-4 }, CreepTerm { compliance: 2.7e-7, retardation_time: 0.17 }],
        None,
    )
    .unwrap();
    let time = 3e-3;
    let mended = convolution(|t| material.relaxation(t), |t| material.creep(t), time);
    assert!(relative(mended, time) < 1e-14);
    // As printed in (2.6): the constants of the relaxation series of (2.5), 1/E_i and the same times.
    let printed = convolution(
        |t| material.relaxation(t),
        |t| {
            1.0 / material.glassy_modulus()
                + material.relaxation_terms().iter().map(|term| -(-t / term.relaxation_time).exp_m1() / term.modulus).sum::<f64>()
        },
        time,
    );
    // As printed in both: one τ for all terms.
    let one_time = convolution(
        |t| {
            material.relaxed_modulus()
                + material
                    .relaxation_terms()
                    .iter()
                    .map(|term| term.modulus * (-t / material.longest_relaxation_time().unwrap()).exp())
                    .sum::<f64>()
        },
        |t| material.creep(t),
        time,
    );
    println!(
        "∫R(t−s)J(s)ds/t: mended {}, with the constants of (2.5) in (2.6) {}, with one τ {}",
        mended / time,
        printed / time,
        one_time / time
    );
    assert!(relative(printed, time) > 0.1, "{printed:e}");
    assert!(relative(one_time, time) > 0.1, "{one_time:e}");
}

#[test]
fn errata_2_9_with_2_19_the_symbol_of_a_sliding_field_is_that_of_minus_qv() {
    // In the frame that moves with v the displacement is J(0)u₁(x) + ∫J̇(t)u₁(x + vt)dt (Eq 5.3): a mode e^{iqx} is multiplied by
    // J(0) + ∫J̇ e^{iqvt}dt. The mended symbol 1/E∞ + ΣJ_j/(1 − iqvτ_j) is that integral; (2.9) at ω = qv of (2.19) is its mirror.
    let material = Material::from_creep(
        2.2e8,
        &[CreepTerm { compliance: 4.7e-8, retardation_time: 2.9e-4 }, CreepTerm { compliance: 2.7e-7, retardation_time: 0.17 }],
        None,
    )
    .unwrap();
    let (wavenumber, speed) = (350.0, 0.019);
    let frequency = wavenumber * speed;
    // By parts twice the tail decays: here simply long Gauss panels, ten per period, to 45 retardation times.
    let (mut in_phase, mut quadrature) = (1.0 / material.glassy_modulus(), 0.0);
    let step = 0.3 * 2.9e-4;
    for index in 0..(45.0 * 0.17 / step) as usize {
        for &(node, weight) in UNIT_RULE.iter() {
            let time = step * (index as f64 + node);
            in_phase += weight * step * material.creep_rate(time) * (frequency * time).cos();
            quadrature += weight * step * material.creep_rate(time) * (frequency * time).sin();
        }
    }
    let symbol = |sign: f64| {
        let (mut real, mut imaginary) = (1.0 / material.glassy_modulus(), 0.0);
        for term in material.creep_terms() {
            let x = sign * frequency * term.retardation_time;
            real += term.compliance / (1.0 + x * x);
            imaginary -= term.compliance * x / (1.0 + x * x);
        }
        (real, imaginary)
    };
    let (mended, printed) = (symbol(-1.0), symbol(1.0));
    // A million positive and negative summands: 1e-12 of rounding.
    assert!(relative(in_phase, mended.0) < 1e-11 && relative(quadrature, mended.1) < 1e-11, "{in_phase:e} {quadrature:e} {mended:?}");
    assert!(relative(quadrature, printed.1) > 1.9, "the printed sign would mirror the sliding direction");
    // And it is the reciprocal of the conjugate modulus, E(−qv).
    let modulus = material.complex_modulus(frequency).unwrap();
    let square = modulus.magnitude().powi(2);
    assert!(relative(modulus.storage / square, mended.0) < 1e-14 && relative(modulus.loss / square, mended.1) < 1e-14);
}

#[test]
fn splitting_permuting_and_vanishing_terms_change_nothing() {
    let mut random = Random(37);
    let (mut exact, mut near, mut vanishing) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..60 {
        let solid = random_solid(&mut random, 12, 9.0, 1e5);
        let terms: Vec<CreepTerm> = solid.creep_terms().to_vec();
        let original = Material::from_creep(solid.glassy_modulus(), &terms, None).unwrap();
        let mut reversed = terms.clone();
        reversed.reverse();
        assert_eq!(original, Material::from_creep(solid.glassy_modulus(), &reversed, None).unwrap(), "the order of terms matters");
        let halves = |ratio: f64| -> Material {
            let split: Vec<CreepTerm> = terms
                .iter()
                .flat_map(|term| {
                    let half = 0.5 * term.compliance;
                    [
                        CreepTerm { compliance: half, retardation_time: term.retardation_time },
                        CreepTerm { compliance: half, retardation_time: term.retardation_time * ratio },
                    ]
                })
                .collect();
            Material::from_creep(solid.glassy_modulus(), &split, None).unwrap()
        };
        assert_eq!(original, halves(1.0), "two equal halves are one term");
        let split = halves(1.0 + 1e-9);
        assert!(split.relaxation_terms().len() >= original.relaxation_terms().len());
        let mut more = terms.clone();
        more.push(CreepTerm { compliance: 1e-40 / solid.glassy_modulus(), retardation_time: terms[0].retardation_time * 0.37 });
        let negligible = Material::from_creep(solid.glassy_modulus(), &more, None).unwrap();
        more.push(CreepTerm { compliance: 0.0, retardation_time: 1.0 });
        assert_eq!(negligible, Material::from_creep(solid.glassy_modulus(), &more, None).unwrap(), "a zero term is dropped");
        for exponent in -2..=10 {
            let time = original.relaxation_terms().last().unwrap().relaxation_time * 10f64.powi(exponent);
            exact = exact.max(relative(original.relaxation(time), solid.relaxation(time)));
            // Half of every time moved by 1e-9 moves R by 1e-9 × d ln R/d ln t, at most about ln β of them: a few 1e-9, and not nothing.
            near = near.max(relative(split.relaxation(time), original.relaxation(time)));
            vanishing = vanishing.max(relative(negligible.relaxation(time), original.relaxation(time)));
        }
    }
    println!("R through the other series {exact:.1e}, nearly split {near:.1e}, with a vanishing term {vanishing:.1e}");
    assert!(exact <= 1e-13 && vanishing <= 1e-13);
    assert!(near <= 1e-8 && near > 1e-12, "{near:e}");
}

#[test]
fn units_change_nothing() {
    let mut random = Random(41);
    let mut worst = 0.0_f64;
    for _ in 0..100 {
        let solid = random_solid(&mut random, 12, 12.0, 1e6);
        let scaled = in_mpa_ms(&solid);
        for (index, (one, two)) in solid.relaxation_terms().iter().zip(scaled.relaxation_terms()).enumerate() {
            // The scaled input differs by an ulp: the bound of the input applies.
            let bar = if solid.given() == GivenSeries::Creep {
                let error = solid.conversion_errors()[index];
                2.0 * error.strength + 4.0 * error.strength_input
            } else {
                2.0 * f64::EPSILON
            };
            assert!(relative(two.modulus * 1e6, one.modulus) <= bar);
        }
        for exponent in -1..12 {
            let time = solid.relaxation_terms().last().unwrap().relaxation_time * 10f64.powi(exponent);
            worst = worst.max(relative(scaled.relaxation(time * 1e3) * 1e6, solid.relaxation(time)));
            worst = worst.max(relative(scaled.creep(time * 1e3) * 1e-6, solid.creep(time)));
            let (one, two) = (solid.complex_modulus(1.0 / time).unwrap(), scaled.complex_modulus(1e-3 / time).unwrap());
            worst = worst.max(relative(two.loss_tangent(), one.loss_tangent()));
        }
        assert!(relative(scaled.stiffening_ratio(), solid.stiffening_ratio()) <= 4.0 * f64::EPSILON);
    }
    println!("worst change with units {worst:.1e}");
    assert!(worst <= 2e-14);
}

#[test]
fn limits_and_interlacing() {
    let mut random = Random(53);
    for _ in 0..200 {
        let solid = random_solid(&mut random, 20, 12.0, 1e6);
        assert_eq!(solid.relaxation(f64::INFINITY).to_bits(), solid.relaxed_modulus().to_bits());
        assert!(relative(solid.relaxation(0.0), solid.glassy_modulus()) <= 1e-14);
        assert!(relative(solid.creep(f64::INFINITY), 1.0 / solid.relaxed_modulus()) <= 1e-14);
        assert!(relative(solid.creep(0.0), 1.0 / solid.glassy_modulus()) <= f64::EPSILON);
        assert!(solid.creep(-1.0) == 0.0 && solid.relaxation(-1.0) == 0.0);
        // τ_1 > ρ_1 > τ_2 > ρ_2 …, each up to the rounding of a shift below an ulp.
        for (index, (creep, relaxation)) in solid.creep_terms().iter().zip(solid.relaxation_terms()).enumerate() {
            assert!(relaxation.relaxation_time <= creep.retardation_time, "{index}");
            if let Some(next) = solid.creep_terms().get(index + 1) {
                assert!(next.retardation_time <= relaxation.relaxation_time, "{index}");
            }
        }
    }
    // One term: ρ = τ/β.
    let one = Material::standard_solid(2.3e4, 7.9e8, 0.37).unwrap();
    assert!(relative(one.relaxation_terms()[0].relaxation_time, 0.37 * 2.3e4 / 7.9e8) <= 4.0 * f64::EPSILON);
    assert!(relative(one.stiffening_ratio(), 7.9e8 / 2.3e4) <= 4.0 * f64::EPSILON);
    let elastic = Material::elastic(3.3e6).unwrap();
    assert!(
        elastic.is_elastic() && elastic.creep(1.0) == 1.0 / 3.3e6 && elastic.relaxation(1.0) == 3.3e6 && elastic.stiffening_ratio() == 1.0
    );
}

#[test]
fn a_fluid_flows_with_the_viscosity_of_its_series() {
    let terms = [
        RelaxationTerm { modulus: 6.7e8, relaxation_time: 3.1e-4 },
        RelaxationTerm { modulus: 2.9e6, relaxation_time: 0.23 },
        RelaxationTerm { modulus: 4.1e3, relaxation_time: 61.0 },
    ];
    let fluid = Material::from_relaxation(0.0, &terms).unwrap();
    let viscosity: f64 = terms.iter().map(|term| term.modulus * term.relaxation_time).sum();
    assert!(relative(fluid.steady_viscosity().unwrap(), viscosity) <= f64::EPSILON);
    assert_eq!(fluid.creep_terms().len(), 2);
    assert!(fluid.stiffening_ratio().is_infinite() && fluid.solid_modulus("G").is_err());
    // Late creep is the flow plus a constant: J(2t) − J(t) = t/η.
    let late = 1e6;
    assert!(relative(fluid.creep(2.0 * late) - fluid.creep(late), late / viscosity) <= 1e-12);
    let twice = back(&fluid);
    for (one, two) in fluid.relaxation_terms().iter().zip(twice.relaxation_terms()) {
        assert!(relative(two.modulus, one.modulus) <= 1e-14 && relative(two.relaxation_time, one.relaxation_time) <= 1e-14);
    }
    // A solid whose relaxed modulus tends to zero tends to it.
    for (relaxed, bound) in [(1e-3, 1e-4), (1e-6, 1e-7), (1e-9, 1e-10)] {
        let solid = Material::from_relaxation(relaxed, &terms).unwrap();
        for time in [1e-5, 1e-2, 10.0, 500.0] {
            assert!(relative(solid.creep(time), fluid.creep(time)) <= bound, "E0 = {relaxed:e} at {time:e}");
        }
    }
}
