//! Source: `src/fit`: numbers and closures only.
//!
//! Goal: intervals cover what they say, profiles are those of the likelihood, descents from several starts find the lower of two minima, outliers change a
//! robust fit little, and what the data do not fix stays open.
//!
//! Oracle: models in closed form with a known truth; the exact interval of a linear model with normal noise (Student).
//!
//! Tolerance: coverage of 600 intervals within 2 %, which is 2.2 binomial standard deviations; else as stated.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs)]

use viscotack::fit::{Fineness, Group, Loss, Noise, Parameter, Problem, fit, two_sided};
use viscotack::special::normal::Normal;

fn parameter(name: &str, lower: f64, upper: f64) -> Parameter {
    Parameter { name: name.to_owned(), lower, upper, logarithmic: lower > 0.0, first: None }
}

fn group(count: usize, sigma: f64) -> Vec<Group> {
    vec![Group { name: "data".to_owned(), places: 0..count, noise: Noise::Guess(sigma) }]
}

/// A exp(−t/τ) at 60 times.
fn decay(values: &[f64]) -> Vec<f64> {
    (0..60).map(|row| values[0] * (-f64::from(row) * 0.05 / values[1]).exp()).collect()
}

#[test]
fn intervals_cover_the_truth_as_often_as_they_say() {
    let truth = [2.0, 0.7];
    let model = |values: &[f64], _: Fineness| -> Result<Vec<f64>, String> { Ok(decay(values)) };
    let mut covered = [0; 2];
    for draw in 0..300 {
        let mut stream = Normal::of(11, draw);
        let sigma = if draw % 2 == 0 { 0.02 } else { 0.2 };
        let data: Vec<f64> = decay(&truth).iter().map(|value| value + sigma * stream.sample()).collect();
        let parameters = vec![parameter("amplitude", 0.01, 100.0), parameter("time", 0.01, 100.0)];
        let groups = group(data.len(), 0.1);
        let found = fit(&Problem { starts: 3, ..Problem::squares(parameters, data, groups, &model) }).unwrap();
        for (place, truth) in truth.iter().enumerate() {
            covered[0] += usize::from(found.by_profile[place].holds(*truth));
            covered[1] += usize::from(found.by_covariance[place].holds(*truth));
        }
    }
    println!("profile {} of 600, covariance {} of 600", covered[0], covered[1]);
    assert!(covered.iter().all(|count| (558..=582).contains(count)), "{covered:?}");
}

#[test]
fn the_interval_of_a_linear_model_is_students() {
    // y = b at n places: b ± t s/√n, by both routes.
    let mut stream = Normal::of(5, 0);
    let data: Vec<f64> = (0..25).map(|_| 0.3 + stream.sample()).collect();
    let mean = data.iter().sum::<f64>() / 25.0;
    let scatter = (data.iter().map(|datum| (datum - mean).powi(2)).sum::<f64>() / 24.0).sqrt();
    let half = two_sided(0.95, 24.0) * scatter / 5.0;
    let model = |values: &[f64], _: Fineness| -> Result<Vec<f64>, String> { Ok(vec![values[0]; 25]) };
    let problem = Problem {
        parameters: vec![parameter("b", -9.0, 9.0)],
        data,
        groups: group(25, 1.0),
        model: &model,
        loss: Loss::Squares,
        starts: 1,
    };
    let found = fit(&problem).unwrap();
    assert!((found.values[0] - mean).abs() < 1e-4 * half, "{} {mean}", found.values[0]);
    for (interval, tolerance) in [(&found.by_covariance[0], 1e-6), (&found.by_profile[0], 1e-3)] {
        assert!(
            (interval.upper.value() - mean - half).abs() < tolerance * half
                && (mean - half - interval.lower.value()).abs() < tolerance * half
        );
    }
}

#[test]
fn the_lower_of_two_minima_is_found_and_the_other_is_named() {
    // A frequency has a minimum for every few waves that fit into the window.
    let wave = |frequency: f64| -> Vec<f64> { (0..80).map(|row| (frequency * f64::from(row) * 0.1).sin()).collect() };
    let data = wave(3.0);
    let model = |values: &[f64], _: Fineness| -> Result<Vec<f64>, String> { Ok(wave(values[0])) };
    let mut one = parameter("frequency", 0.5, 8.0);
    one.first = Some(5.1);
    let noise = group(data.len(), 0.05);
    let found = fit(&Problem { parameters: vec![one], data, groups: noise, model: &model, loss: Loss::Squares, starts: 4 }).unwrap();
    assert!((found.values[0] - 3.0).abs() < 1e-4, "{:?}", found.values);
    assert!(found.reached_by.1 > found.reached_by.0 && !found.others.is_empty(), "{:?}", found.reached_by);
}

#[test]
fn outliers_change_a_robust_fit_little() {
    let truth = [2.0, 0.7];
    let mut stream = Normal::of(21, 1);
    let mut data: Vec<f64> = decay(&truth).iter().map(|value| value + 0.02 * stream.sample()).collect();
    for row in [3, 17, 18, 40] {
        data[row] += 1.5;
    }
    let model = |values: &[f64], _: Fineness| -> Result<Vec<f64>, String> { Ok(decay(values)) };
    let off = |loss: Loss| {
        let parameters = vec![parameter("amplitude", 0.01, 100.0), parameter("time", 0.01, 100.0)];
        let found = fit(&Problem { parameters, data: data.clone(), groups: group(60, 0.02), model: &model, loss, starts: 2 }).unwrap();
        (found.values[1] / truth[1] - 1.0).abs()
    };
    let (robust, plain) = (off(Loss::Huber), off(Loss::Squares));
    assert!(robust < 0.04 && plain > 3.0 * robust, "{robust} {plain}");
}

#[test]
fn what_the_data_do_not_fix_stays_open() {
    // Only the product of both is seen.
    let model = |values: &[f64], _: Fineness| -> Result<Vec<f64>, String> { Ok(decay(&[values[0] * values[1], 0.7])) };
    let mut stream = Normal::of(2, 9);
    let data: Vec<f64> = decay(&[2.0, 0.7]).iter().map(|value| value + 0.02 * stream.sample()).collect();
    let parameters = vec![parameter("one", 0.1, 10.0), parameter("other", 0.1, 10.0)];
    let found = fit(&Problem { parameters, data, groups: group(60, 0.02), model: &model, loss: Loss::Squares, starts: 3 }).unwrap();
    assert!((found.values[0] * found.values[1] - 2.0).abs() < 0.05);
    assert!(found.by_profile.iter().any(|interval| interval.lower.is_open() || interval.upper.is_open()), "{:?}", found.by_profile);
    assert!(found.correlations[0][1] < -0.99, "{:?}", found.correlations);
}

#[test]
fn a_model_without_solutions_and_too_few_data_are_refused() {
    let model = |_: &[f64], _: Fineness| -> Result<Vec<f64>, String> { Err("no such state".to_owned()) };
    let problem = Problem {
        parameters: vec![parameter("b", 1.0, 9.0)],
        data: vec![1.0; 9],
        groups: group(9, 1.0),
        model: &model,
        loss: Loss::Squares,
        starts: 1,
    };
    assert!(fit(&problem).unwrap_err().to_string().contains("no such state"));
    let few = Problem { data: vec![1.0; 2], groups: group(2, 1.0), ..problem };
    assert!(fit(&few).unwrap_err().to_string().contains("2 data cannot fix 1 parameters"));
}
