//! Source: `material/fit`, `material/shift`, `material/broad`: series from data, time–temperature shift, laws with a continuous spectrum.
//!
//! Goal: a known series comes back from its own moduli; noisy data are followed within the stated error; what no passive solid can do is
//! reported; laws are expanded to their accuracy with a number of terms near the least.
//! Oracle: the series the data were made of; `broad_laws.csv` (mpmath, closed forms confirmed by quadrature of the spectrum).
//! Tolerances: 1e-8 of the modulus for noiseless data; coverage of the stated errors counted over seeds; 1e-12 for the laws themselves
//! (quadrature to rounding); the wanted accuracy for expansions, on frequencies that the expansion did not use.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use support::random::Uniform;
use support::reference_rows;
use viscotack::material::broad::{BroadKind, BroadLaw, expand};
use viscotack::material::fit::consistency::{check, widest_gap};
use viscotack::material::fit::{Observation, Quantity, Wanted, complex_modulus, fit};
use viscotack::material::{ComplexModulus, Material, RelaxationTerm};

fn rubber() -> Material {
    let moduli = [0.22, 0.31, 0.45, 0.71, 1.3, 2.9, 8.1, 27.0, 96.0, 310.0, 690.0, 760.0];
    let terms: Vec<RelaxationTerm> = (2..)
        .step_by(1)
        .zip(moduli)
        .map(|(place, modulus): (i32, f64)| RelaxationTerm { modulus: modulus * 1e6, relaxation_time: 10f64.powi(4 - place) })
        .collect();
    Material::from_relaxation(1.1e6, &terms).unwrap()
}

fn frequencies(from: f64, to: f64, per_decade: f64) -> Vec<f64> {
    let steps = ((to / from).log10() * per_decade).round();
    (0..=steps as usize).map(|index| from * (to / from).powf(index as f64 / steps)).collect()
}

/// Standard normal numbers by Box and Muller.
fn normal(uniform: &mut Uniform) -> f64 {
    (-2.0 * uniform.between(1e-300, 1.0).ln()).sqrt() * (std::f64::consts::TAU * uniform.between(0.0, 1.0)).cos()
}

fn measured(truth: &dyn Fn(f64) -> ComplexModulus, places: &[f64], noise: f64, uniform: &mut Uniform) -> Vec<Observation> {
    places
        .iter()
        .flat_map(|&at| {
            let modulus = truth(at);
            let mut blurred = |value: f64| value * (1.0 + noise * normal(uniform));
            complex_modulus(at, blurred(modulus.storage), blurred(modulus.loss))
        })
        .collect()
}

#[test]
fn a_known_series_comes_back_from_its_moduli() {
    let mut uniform = Uniform::new();
    let mut materials = vec![rubber()];
    // Times anywhere, at least half a decade apart.
    for count in [1, 3, 6] {
        let mut terms = Vec::new();
        let mut time = 1e-4 * uniform.log_between(1.0, 10.0);
        for _ in 0..count {
            terms.push(RelaxationTerm { modulus: 1e6 * uniform.log_between(0.1, 100.0), relaxation_time: time });
            time *= uniform.log_between(3.2, 30.0);
        }
        materials.push(Material::from_relaxation(1e6, &terms).unwrap());
    }
    for material in &materials {
        let fastest = material.relaxation_terms().last().unwrap().relaxation_time;
        let slowest = material.longest_relaxation_time().unwrap();
        let places = frequencies(0.1 / slowest, 10.0 / fastest, 5.0);
        let data = measured(&|at| material.complex_modulus(at).unwrap(), &places, 0.0, &mut uniform);
        let fitted = fit(&data, Wanted::Scatter).unwrap();
        let count = fitted.material.relaxation_terms().len();
        println!("{} terms: {count} found, rms {:e}", material.relaxation_terms().len(), fitted.rms_error);
        assert_eq!(count, material.relaxation_terms().len());
        for (found, given) in fitted.material.relaxation_terms().iter().zip(material.relaxation_terms()) {
            assert!((found.relaxation_time / given.relaxation_time - 1.0).abs() < 1e-8);
            assert!((found.modulus / given.modulus - 1.0).abs() < 1e-8);
        }
        for at in frequencies(0.01 / slowest, 100.0 / fastest, 7.0) {
            let (found, given) = (fitted.material.complex_modulus(at).unwrap(), material.complex_modulus(at).unwrap());
            let error = (found.storage - given.storage).hypot(found.loss - given.loss) / given.magnitude();
            assert!(error < 1e-8, "at {at:e}: {error:e}");
        }
    }
}

#[test]
fn creep_and_relaxation_curves_give_their_series_back() {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    let material = Material::from_relaxation(1e6, &[term(2e6, 30.0), term(5e6, 0.7), term(3e7, 0.011)]).unwrap();
    let times = frequencies(1e-4, 1e4, 10.0);
    for quantity in [Quantity::Relaxation, Quantity::Creep] {
        let value = |time| if quantity == Quantity::Creep { material.creep(time) } else { material.relaxation(time) };
        let data: Vec<Observation> = times.iter().map(|&at| Observation { quantity, at, value: value(at), scale: value(at) }).collect();
        let fitted = fit(&data, Wanted::Scatter).unwrap();
        println!("{quantity:?}: {} terms, rms {:e}", fitted.material.relaxation_terms().len(), fitted.rms_error);
        for &time in &times {
            assert!((fitted.material.creep(time) / material.creep(time) - 1.0).abs() < 1e-8);
            assert!((fitted.material.relaxation(time) / material.relaxation(time) - 1.0).abs() < 1e-8);
        }
    }
}

#[test]
fn noisy_data_are_followed_within_the_stated_error() {
    let rubber = rubber();
    // No series is the truth of the second: what is left out for lack of data is an error, too.
    let law = BroadLaw::new(BroadKind::FractionalZener(0.4), 1e6, 1e9, 1e-3).unwrap();
    let truths: [(&dyn Fn(f64) -> ComplexModulus, usize); 2] =
        [(&|at| rubber.complex_modulus(at).unwrap(), 12), (&|at| law.complex_modulus(at).unwrap(), 8)];
    let mut uniform = Uniform::new();
    let places = frequencies(1e-3, 1e9, 5.0);
    for (truth, seeds) in truths {
        let (mut inside, mut all, mut terms, mut width, mut misses) = (0, 0, 0, 0.0, 0.0_f64);
        for _ in 0..seeds {
            let data = measured(truth, &places, 0.02, &mut uniform);
            let fitted = fit(&data, Wanted::Scatter).unwrap();
            terms += fitted.material.relaxation_terms().len();
            // The scatter of the data comes back as the misfit, less what the free numbers of the fit take.
            assert!((0.012..0.022).contains(&fitted.rms_error), "{}", fitted.rms_error);
            for at in frequencies(1e-3, 1e9, 10.0) {
                let (given, found) = (truth(at), fitted.material.complex_modulus(at).unwrap());
                for (quantity, given, found) in
                    [(Quantity::Storage, given.storage, found.storage), (Quantity::Loss, given.loss, found.loss)]
                {
                    let error = fitted.band.error(quantity, at);
                    all += 1;
                    inside += usize::from((found - given).abs() <= error);
                    width += error / given;
                    misses = misses.max((found - given).abs() / error);
                }
            }
        }
        let coverage = f64::from(inside as u32) / f64::from(all);
        println!(
            "{seeds} seeds: coverage {coverage:.3}, mean terms {:.1}, mean stated error {:.4}, worst miss {misses:.1} of it",
            terms as f64 / seeds as f64,
            width / f64::from(all)
        );
        // Stated: about 95 of 100. The numbers of one fit are not independent, so a dozen fits tell it within some per cent.
        assert!(coverage > 0.90, "{coverage}");
        // And it is no safe distance either: a good deal less than the noise of one number, 0.04 at two deviations.
        assert!(width / f64::from(all) < 0.03);
        assert!(misses < 6.0);
    }
}

#[test]
fn a_larger_wanted_error_takes_fewer_terms() {
    let rubber = rubber();
    let data = measured(&|at| rubber.complex_modulus(at).unwrap(), &frequencies(1e-3, 1e10, 6.0), 0.0, &mut Uniform::new());
    let mut before = usize::MAX;
    for error in [1e-6, 1e-2, 0.05, 0.2] {
        let fitted = fit(&data, Wanted::Error(error)).unwrap();
        let count = fitted.material.relaxation_terms().len();
        println!("{error:e}: {count} terms, {:e}", fitted.rms_error);
        assert!(fitted.met && fitted.rms_error <= error && count <= before);
        before = count;
    }
    assert!(before < 9, "{before}");
    // Below the scatter of the data no number of terms helps, and the fit says so.
    let noisy = measured(&|at| rubber.complex_modulus(at).unwrap(), &frequencies(1e-3, 1e10, 4.0), 0.02, &mut Uniform::new());
    let fitted = fit(&noisy, Wanted::Error(1e-3)).unwrap();
    assert!(!fitted.met && fitted.rms_error < 0.022);
}

#[test]
fn moduli_of_no_passive_solid_are_reported() {
    let rubber = rubber();
    let mut uniform = Uniform::new();
    let places = frequencies(1e-3, 1e9, 5.0);
    let sound = measured(&|at| rubber.complex_modulus(at).unwrap(), &places, 0.02, &mut uniform);
    let consistency = check(&sound).unwrap();
    println!("{consistency:?}");
    assert!(consistency.holds());
    // The local relation is the second, cruder witness.
    assert!(consistency.local.unwrap() < 0.3);
    // Half the loss, and a loss with its peak a decade off, belong to no storage modulus of these data.
    for spoil in [|modulus: ComplexModulus, _: ComplexModulus| 0.5 * modulus.loss, |_, later: ComplexModulus| later.loss] {
        let spoilt = measured(
            &|at| {
                let modulus = rubber.complex_modulus(at).unwrap();
                ComplexModulus { storage: modulus.storage, loss: spoil(modulus, rubber.complex_modulus(10.0 * at).unwrap()) }
            },
            &places,
            0.02,
            &mut uniform,
        );
        let consistency = check(&spoilt).unwrap();
        println!("{consistency:?}");
        assert!(!consistency.holds());
    }
    assert!(widest_gap(&sound).is_none());
    let [from, to] = widest_gap(&sound[..40].iter().chain(&sound[90..]).copied().collect::<Vec<_>>()).unwrap();
    assert!(to / from > 10.0);
}

#[test]
fn numbers_that_are_no_data_are_refused() {
    let one = |at, value, scale| Observation { quantity: Quantity::Storage, at, value, scale };
    let good = [one(1.0, 1.0, 1.0), one(2.0, 1.5, 1.0), one(3.0, 2.0, 1.0)];
    assert!(fit(&good, Wanted::Scatter).is_ok());
    assert!(fit(&good[..2], Wanted::Scatter).is_err());
    assert!(fit(&good, Wanted::Error(f64::NAN)).is_err());
    for bad in [one(0.0, 1.0, 1.0), one(1.0, f64::NAN, 1.0), one(1.0, 1.0, 0.0), one(f64::INFINITY, 1.0, 1.0)] {
        assert!(fit(&[good[0], good[1], bad], Wanted::Scatter).is_err(), "{bad:?}");
    }
    let creep = Observation { quantity: Quantity::Creep, ..good[0] };
    assert!(fit(&[good[0], good[1], creep], Wanted::Scatter).is_err());
}

#[test]
fn laws_are_those_of_mpmath() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for row in reference_rows("broad_laws.csv") {
        let exponent = row.number("exponent");
        let kind =
            if row.text("law") == "power_law" { BroadKind::ModifiedPowerLaw(exponent) } else { BroadKind::FractionalZener(exponent) };
        // Non-unit numbers; E0 = 0 shows the normalised law itself.
        let law = BroadLaw::new(kind, 0.0, 3e8, 0.02).unwrap();
        let modulus = law.complex_modulus(row.number("argument") / 0.02).unwrap();
        for (found, given) in [(modulus.storage, row.number("storage")), (modulus.loss, row.number("loss"))] {
            let error = (found / 3e8 - given).abs() / row.number("storage").hypot(row.number("loss"));
            worst = worst.max(error);
            compared += 1;
        }
    }
    println!("{compared} numbers, worst relative error {worst:e}");
    assert!(compared > 150 && worst < 1e-12, "{worst:e}");
}

/// Linear systems that one expansion may take, of a hundred unknowns each: a work counter, not a time.
const MOST_SOLVES: usize = 150;

/// Laws all over their ranges: narrow, wide and steep spectra, liquids, tight and loose accuracies.
#[test]
fn every_law_is_expanded_by_few_linear_systems() {
    for (kind, accuracies) in [
        (BroadKind::ModifiedPowerLaw(0.05), &[1e-3, 1e-6, 1e-9][..]),
        (BroadKind::ModifiedPowerLaw(0.5), &[1e-3, 1e-6, 1e-9]),
        (BroadKind::ModifiedPowerLaw(2.0), &[1e-3, 1e-6]),
        (BroadKind::ModifiedPowerLaw(8.0), &[1e-3, 1e-6]),
        (BroadKind::FractionalZener(0.05), &[1e-3, 1e-6, 1e-9]),
        (BroadKind::FractionalZener(0.3), &[1e-3, 1e-6, 1e-9]),
        (BroadKind::FractionalZener(0.7), &[1e-3, 1e-6, 1e-9]),
        (BroadKind::FractionalZener(0.95), &[1e-3, 1e-6]),
    ] {
        for &accuracy in accuracies {
            for (relaxed, range) in [(1e6, [1e-4, 1e6]), (0.0, [1e-6, 1e4])] {
                if relaxed == 0.0 && accuracy < 1e-6 {
                    continue;
                }
                let law = BroadLaw::new(kind, relaxed, 1e9, 1.0).unwrap();
                let expansion = expand(&law, range, accuracy).unwrap();
                let mut worst = 0.0_f64;
                for at in frequencies(range[0], range[1], 23.7) {
                    let (given, found) = (law.complex_modulus(at).unwrap(), expansion.material.complex_modulus(at).unwrap());
                    worst = worst.max((given.storage - found.storage).hypot(given.loss - found.loss) / given.magnitude());
                }
                let (terms, rate) = (expansion.material.relaxation_terms().len(), expansion.terms_by_rate);
                println!(
                    "{kind:?} {relaxed:e} {range:?} {accuracy:e}: {terms} terms (rate {rate:.1}), {worst:.2e}, {} systems",
                    expansion.solves
                );
                assert!(expansion.met && worst <= accuracy, "{kind:?} {relaxed:e} {range:?} {accuracy:e}: {worst:e}");
                assert!(expansion.solves <= MOST_SOLVES, "{}", expansion.solves);
            }
        }
    }
}

#[test]
fn laws_are_expanded_to_their_accuracy_over_twelve_decades() {
    for (kind, range, accuracy) in [
        (BroadKind::ModifiedPowerLaw(0.5), [1e-10, 1e2], 1e-6),
        (BroadKind::ModifiedPowerLaw(0.5), [1e-10, 1e2], 1e-3),
        (BroadKind::FractionalZener(0.3), [1e-6, 1e6], 1e-6),
        (BroadKind::FractionalZener(0.5), [1e-6, 1e6], 1e-3),
    ] {
        let law = BroadLaw::new(kind, 1e6, 1e9, 1.0).unwrap();
        let expansion = expand(&law, range, accuracy).unwrap();
        let terms = expansion.material.relaxation_terms();
        let mut worst = 0.0_f64;
        // Frequencies that no step of the expansion used.
        for at in frequencies(range[0], range[1], 23.7) {
            let (given, found) = (law.complex_modulus(at).unwrap(), expansion.material.complex_modulus(at).unwrap());
            worst = worst.max((given.storage - found.storage).hypot(given.loss - found.loss) / given.magnitude());
        }
        println!("{kind:?} to {accuracy:e}: {} terms (rate {:.1}), error {worst:.2e}", terms.len(), expansion.terms_by_rate);
        assert!(expansion.met && worst <= accuracy, "{worst:e}");
        assert!(terms.iter().all(|term| term.modulus > 0.0));
        assert!((expansion.material.glassy_modulus() / 1e9 - 1.0).abs() < accuracy);
        assert!(terms.len() as f64 <= 1.5 * expansion.terms_by_rate, "{}", terms.len());
        assert!(expansion.solves <= MOST_SOLVES, "{}", expansion.solves);
        // The relaxation in time follows, inside the range, within a few times as much.
        if let BroadKind::ModifiedPowerLaw(exponent) = kind {
            for time in frequencies(10.0 / range[1], 0.1 / range[0], 2.0) {
                let given = 1e6 + 9.99e8 * (1.0 + time).powf(-exponent);
                assert!((expansion.material.relaxation(time) / given - 1.0).abs() < 10.0 * accuracy, "{time:e}");
            }
        }
    }
    let law = BroadLaw::new(BroadKind::ModifiedPowerLaw(0.5), 1e6, 1e9, 1.0).unwrap();
    assert!(expand(&law, [1.0, 0.1], 1e-3).is_err() && expand(&law, [0.1, 1.0], 0.0).is_err());
    assert!(BroadLaw::new(BroadKind::FractionalZener(1.0), 1e6, 1e9, 1.0).is_err());
    assert!(BroadLaw::new(BroadKind::ModifiedPowerLaw(0.5), 1e9, 1e6, 1.0).is_err());
}

#[test]
fn moduli_at_the_ends_lie_within_their_stated_errors() {
    // A filled rubber whose slowest decades are not measured, as a test at one temperature leaves them.
    let terms: Vec<RelaxationTerm> = (0..60)
        .rev()
        .map(|index| {
            let place = -9.0 + f64::from(index) * 11.0 / 59.0;
            let strength = (-((place + 5.5) / 1.3_f64).powi(2)).exp() + 0.02 * (-((place + 1.0) / 2.2_f64).powi(2)).exp();
            RelaxationTerm { modulus: 65e6 * strength, relaxation_time: 10f64.powf(place) }
        })
        .collect();
    let truth = Material::from_relaxation(3e6, &terms).unwrap();
    let mut uniform = Uniform::new();
    let places: Vec<f64> = frequencies(0.01, 1.6e6, 3.2).into_iter().map(|frequency| std::f64::consts::TAU * frequency).collect();
    let (mut inside, mut errors) = ([0, 0], Vec::new());
    let count = 24;
    for _ in 0..count {
        let data = measured(&|at| truth.complex_modulus(at).unwrap(), &places, 0.02, &mut uniform);
        let ends = fit(&data, Wanted::Scatter).unwrap().plateaus(&data);
        println!("E0 {:.3e} ± {:.1e}, E∞ {:.3e} ± {:.1e}", ends[0].modulus, ends[0].error, ends[1].modulus, ends[1].error);
        assert!(ends[0].is_extrapolated());
        for ((inside, end), given) in inside.iter_mut().zip(&ends).zip([truth.relaxed_modulus(), truth.glassy_modulus()]) {
            *inside += usize::from((end.modulus - given).abs() <= end.error);
        }
        errors.push(ends[0].error);
    }
    println!("inside: {inside:?} of {count}");
    assert!(inside.iter().all(|inside| inside * 10 >= 8 * count), "{inside:?}");
    // No safe distance either.
    assert!(errors.iter().sum::<f64>() / (count as f64) < 2e6);
}
