//! Data that cannot be what the scene says: found before the fit, or after it.

use super::carry_out::Fit;
use super::compare::{Comparison, curve_of};
use super::setup::{Role, Setup};
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use rayon::prelude::*;
use viscotack::fit::Parameter;

/// Correlation of a model with the negative of the data beyond which it is like them, and by how much less any model must be like the data.
const LIKE: f64 = 0.7;
const LIKE_LESS: f64 = 0.2;
/// Places between the bounds at which a suspicion is looked into, and the bases of their coordinates.
const MANY: u64 = 64;
const PRIMES: [u64; 8] = [2, 3, 5, 7, 11, 13, 17, 19];
/// How far data may reach beyond the history, as part of it.
const BEYOND: f64 = 0.02;
/// Ratio of data to model beyond which units differ.
const OTHER_UNITS: f64 = 30.0;
/// A coefficient of determination below which the model does not describe the data.
const POOR: f64 = 0.5;
/// Standard errors by which a loop of residuals differs from none where more than noise is behind it, and its least part of all that the residuals enclose.
const BEYOND_NOISE: f64 = 5.0;
const OF_LOOP: f64 = 0.3;

/// Checks data against the scene at its own values: the range of the abscissa, and the sign.
pub(super) fn before(setup: &Setup) -> Result<(), SceneError> {
    if setup.across {
        return Ok(());
    }
    for (place, (test, given)) in setup.tests.iter().zip(&setup.task.tests).enumerate() {
        let wrong = |message: String, label: String, help: String| Err(SceneError::at(&given.table.place, message, label).help(help));
        // A scene that does not go at its own values may go elsewhere between the bounds.
        let Ok(curve) = curve_of(&test.document, 1e-2, test.beside) else { continue };
        let Some(way) = curve.column(&test.against) else {
            return wrong(
                format!("{:?} is given against `{}`, which the scene does not have", test.file, test.against),
                "this file".into(),
                "give indentation.frame_stiffness".into(),
            );
        };
        let (low, high) = test.range();
        let (from, to) = way.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
        let slack = BEYOND * (to - from);
        let moves = setup.task.free.iter().any(|free| {
            free.key.starts_with("history.") || free.key == if test.against == "time" { "fit.time_offset" } else { "fit.depth_offset" }
        });
        // A depth that is not controlled reaches as far as the free numbers let it.
        let fixed = test.against == "time" && !moves;
        let ratio = (high - low) / (to - from);
        if (fixed && (low < from - slack || high > to + slack)) || !(1.0 / OTHER_UNITS..=OTHER_UNITS).contains(&ratio) {
            let remedy = if test.against == "time" { "fit.time_offset" } else { "fit.depth_offset" };
            return wrong(
                format!(
                    "the {} of {:?} goes from {low:.4e} to {high:.4e}, that of the scene from {from:.4e} to {to:.4e}",
                    test.against, test.file
                ),
                "must lie within the history".into(),
                format!(
                    "check the unit in the header; if the data count from another zero, free {{ key = \"{remedy}\" }}; if they are of a part of the history, leave the rest out of the scene"
                ),
            );
        }
        let models = |places: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
            let at = |values: Vec<f64>| test.model(&scene_values(setup, &values), setup.offsets(place, &values), 1e-2).ok();
            places.into_par_iter().filter_map(at).collect()
        };
        let few = models(places(setup));
        let mut many: Option<Vec<Vec<f64>>> = None;
        for (number, column) in test.columns.iter().enumerate().filter(|_| !test.relative) {
            let rows = test.rows.len();
            let data: Vec<f64> = test.rows.iter().filter_map(|row| column.values.get(*row)).copied().collect();
            // Nowhere between the bounds is the model like the data, and somewhere like their negative.
            let reversed = |models: &[Vec<f64>]| {
                let with = |model: &Vec<f64>| correlation(&data, model.get(number * rows..(number + 1) * rows).unwrap_or(&[]));
                let (least, most) = models.iter().map(with).fold((0.0_f64, 0.0_f64), |(least, most), one| (least.min(one), most.max(one)));
                least < -LIKE && most < -least - LIKE_LESS
            };
            // A few places may all be unlike good data: a suspicion is held against many.
            if reversed(&few) && reversed(many.get_or_insert_with(|| models(all_over(setup)))) {
                let message =
                    format!("`{}` of {:?} goes the other way than that of the scene: its sign seems reversed", column.word, test.file);
                return wrong(
                    message,
                    "this file".into(),
                    "forces press positive and pull negative here; depths count into the body".into(),
                );
            }
        }
    }
    Ok(())
}

/// Where data and model are compared: at the scene's own values or the middle, and at a quarter and three quarters of each range.
fn places(setup: &Setup) -> Vec<Vec<f64>> {
    let part = |parameter: &Parameter, part: f64| {
        let [low, high] = parameter.ends();
        parameter.value(low + part * (high - low))
    };
    let middle: Vec<f64> = setup.parameters.iter().map(|parameter| part(parameter, 0.5)).collect();
    let own: Vec<f64> = setup.parameters.iter().zip(&middle).map(|(parameter, middle)| parameter.first.unwrap_or(*middle)).collect();
    let mut places = vec![own.clone(), middle];
    for (place, parameter) in setup.parameters.iter().enumerate() {
        for share in [0.25, 0.75] {
            let mut there = own.clone();
            if let Some(value) = there.get_mut(place) {
                *value = part(parameter, share);
            }
            places.push(there);
        }
    }
    places
}

/// Many places between all bounds, evenly.
fn all_over(setup: &Setup) -> Vec<Vec<f64>> {
    let at = |place: u64| {
        let part = |(number, parameter): (usize, &Parameter)| {
            let [low, high] = parameter.ends();
            parameter.value(low + (high - low) * radical_inverse(place, PRIMES.get(number % PRIMES.len()).copied().unwrap_or(2)))
        };
        setup.parameters.iter().enumerate().map(part).collect()
    };
    (1..=MANY).map(at).collect()
}

/// The digits of a number to a base, mirrored at the point (Halton, Numer. Math. 2 (1960) 84).
fn radical_inverse(mut number: u64, base: u64) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0);
    while number > 0 {
        digit /= base as f64;
        value += digit * (number % base) as f64;
        number /= base;
    }
    value
}

fn scene_values<'s>(setup: &'s Setup, values: &[f64]) -> Vec<(&'s super::compare::Put, f64)> {
    let of = |((role, _), value): (&'s (Role, String), &f64)| match role {
        Role::Scene(put) => Some((put, *value)),
        Role::Of(..) => None,
    };
    setup.roles.iter().zip(values).filter_map(of).collect()
}

fn correlation(one: &[f64], other: &[f64]) -> f64 {
    let count = one.len().min(other.len()) as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (m, n) = (mean(one), mean(other));
    let sum = |f: &dyn Fn(f64, f64) -> f64| one.iter().zip(other).map(|(a, b)| f(a - m, b - n)).sum::<f64>();
    let both = (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt();
    if both > 0.0 { sum(&|a, b| a * b) / both } else { 0.0 }
}

/// What a fit shows of its data, a sentence each; the flag says whether the result is of no use as it stands.
pub(super) fn after(fit: &Fit) -> Vec<(String, bool)> {
    let mut found = Vec::new();
    for (group, quality) in fit.groups.iter().zip(&fit.fitted.quality) {
        let (Some(column), Some(test)) = (group.column, fit.setup.tests.get(group.test)) else { continue };
        let Some(compared) = test.columns.get(column) else { continue };
        let poor = quality.determination.is_some_and(|part| part < POOR);
        if poor {
            let data: Vec<f64> = test.rows.iter().filter_map(|row| compared.values.get(*row)).copied().collect();
            let model = fit.fitted.model.get(group.places.clone()).unwrap_or(&[]);
            let size = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>().sqrt();
            let ratio = size(&data) / size(model);
            let units = !test.relative && !(1.0 / OTHER_UNITS..=OTHER_UNITS).contains(&ratio);
            let sentence = if units {
                format!("{} of {:?} is {ratio:.1e} times that of the best model: check its unit, and the bounds", compared.word, test.file)
            } else {
                format!(
                    "the best model does not describe {} of {:?} (coefficient of determination {:.3})",
                    compared.word,
                    test.file,
                    quality.determination.unwrap_or(0.0)
                )
            };
            found.push((sentence, true));
        }
        if let Some(sentence) = offset(fit, test, column, group) {
            found.push((sentence, false));
        }
        if let Some(sentence) = other_loss((test, fit.setup.units), compared, fit.fitted.model.get(group.places.clone()).unwrap_or(&[])) {
            found.push((sentence, false));
        }
        if !poor && let Some(runs) = quality.runs.filter(|runs| *runs < 1e-3) {
            found.push((
                format!("residuals of {} of {:?} keep their sign for long (runs test: p = {runs:.0e}): the model misses something that the noise does not hide, and the intervals are too narrow", compared.word, test.file),
                false,
            ));
        }
    }
    found
}

/// Way in and way out that enclose another work in the data than in the model: hysteresis of the stage that the test was made with, or of the solid.
fn other_loss((test, units): (&Comparison, Units), compared: &super::compare::Compared, model: &[f64]) -> Option<String> {
    if compared.word != "force" || test.relative || test.across.is_some() || test.against == "time" {
        return None;
    }
    let row = |(row, model): (&usize, &f64)| Some((*test.abscissa.get(*row)?, compared.values.get(*row)? - model, *model));
    let rows: Vec<(f64, f64, f64)> = test.rows.iter().zip(model).filter_map(row).collect();
    let (mut work, mut of_all, mut weights) = (0.0, 0.0, 0.0);
    for three in rows.windows(3) {
        let [before, here, after] = three else { continue };
        let weight = 0.5 * (after.0 - before.0);
        if here.2.abs() > 0.0 {
            work += weight * here.1;
            of_all += weight.abs() * here.1.abs();
            weights += weight * weight;
        }
    }
    let error = compared.noise * weights.sqrt();
    (work.abs() > BEYOND_NOISE * error && work.abs() > OF_LOOP * of_all).then(|| {
        format!(
            "way in and way out of {:?} enclose {} {} than in the model ({:.0} times what noise does): hysteresis of the stage does this (test an empty \
             stage, or a stiff surface), or a loss that the model leaves out",
            test.file,
            super::words::quantity(work.abs(), if units == Units::Si { "J" } else { "1" }),
            if work > 0.0 { "more" } else { "less" },
            work.abs() / error
        )
    })
}

/// A force that is not zero where nothing touches.
fn offset(fit: &Fit, test: &Comparison, column: usize, group: &super::carry_out::GroupOf) -> Option<String> {
    let compared = test.columns.get(column).filter(|compared| compared.word == "force")?;
    if fit.setup.roles.iter().any(|(role, _)| matches!(role, Role::Of(of, super::setup::Offset::Force) if *of == group.test))
        || test.relative
    {
        return None;
    }
    let model = fit.fitted.model.get(group.places.clone())?;
    let open: Vec<f64> = test
        .rows
        .iter()
        .zip(model)
        .filter(|(_, model)| model.abs() <= 0.0)
        .filter_map(|(row, _)| compared.values.get(*row))
        .copied()
        .collect();
    let count = open.len() as f64;
    let mean = open.iter().sum::<f64>() / count;
    let own = super::noise::noise(&open) / count.sqrt();
    (open.len() >= 5 && mean.abs() > 5.0 * own).then(|| {
        format!(
            "the force of {:?} is {mean:.2e} where nothing touches, {:.0} of its standard errors: free {{ key = \"fit.force_offset\" }}",
            test.file,
            mean.abs() / own
        )
    })
}
