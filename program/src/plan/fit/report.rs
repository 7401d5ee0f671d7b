//! A fit as files: summary and table of residuals.

use super::Found;
use super::carry_out::Fit;
use super::words::unseparated;
use crate::outcome::build;
use serde_json::{Value, json};
use viscotack::fit::{End, Interval};

/// `summary.json`.
#[must_use]
pub fn summary(found: &Found) -> Value {
    let fit = &found.fit;
    let (setup, fitted) = (&fit.setup, &fit.fitted);
    let end = |end: End| json!({ "value": end.value(), "open": end.is_open() });
    let interval =
        |intervals: &[Interval], place: usize| intervals.get(place).map(|one| json!({ "lower": end(one.lower), "upper": end(one.upper) }));
    let finite = |value: Option<&f64>| value.filter(|value| value.is_finite()).copied();
    let parameters: Vec<Value> = setup
        .parameters
        .iter()
        .zip(&setup.roles)
        .enumerate()
        .map(|(place, (parameter, (_, unit)))| {
            json!({
                "key": parameter.name,
                "value": fitted.values.get(place),
                "unit": unit,
                "from": parameter.lower,
                "to": parameter.upper,
                "logarithmic": parameter.logarithmic,
                "standard_error_of_the_logarithm_or_part_of_the_range": finite(fitted.standard_errors.get(place)),
                "interval_by_profile_95": interval(&fitted.by_profile, place),
                "interval_by_covariance_95": interval(&fitted.by_covariance, place),
            })
        })
        .collect();
    let groups: Vec<Value> = fit
        .groups
        .iter()
        .zip(&fitted.quality)
        .zip(&fitted.sigmas)
        .filter_map(|((group, quality), sigma)| {
            let test = setup.tests.get(group.test)?;
            Some(json!({
                "test": group.test + 1,
                "data": test.file,
                "column": group.column.and_then(|column| test.columns.get(column)).map(|column| column.word.clone()),
                "place_of_a_jump_in": group.column.is_none().then(|| test.against.clone()),
                "relative": test.relative,
                "rows": group.places.len(),
                "noise": sigma,
                "root_mean_square": quality.root_mean_square,
                "determination": quality.determination,
                "runs_test": quality.runs,
            }))
        })
        .collect();
    let others: Vec<Value> = fitted.others.iter().map(|other| json!({ "values": other.values, "rise": other.rise })).collect();
    json!({
        "title": setup.title,
        "program": build::identity(),
        "scene_hash": setup.document.hash(),
        "problem": setup.problem,
        "sound": fit.is_sound(),
        "parameters": parameters,
        "correlations": fitted.correlations,
        "data": groups,
        "chi_squared": fitted.misfit,
        "degrees_of_freedom": fitted.freedom,
        "akaike_corrected": fit.akaike,
        "descents_to_this_minimum": fitted.reached_by.0,
        "descents": fitted.reached_by.1,
        "other_minima": others,
        "evaluations": fitted.evaluations,
        "tolerance_of_the_model": fit.tolerance,
        "moved_by_a_tighter_model_over_standard_error": fit.moved,
        "cautions": unseparated(fit).into_iter().chain(fit.findings.iter().map(|finding| finding.0.clone())).collect::<Vec<_>>(),
        "models": found.models.iter().map(|model| json!({
            "name": model.name,
            "refused": model.fit.as_ref().err(),
            "akaike_above_best": model.rise(&found.models),
            "excluded": model.is_excluded(&found.models),
            "evaluations": model.fit.as_ref().ok().map(|fit| fit.fitted.evaluations),
            "seconds": model.fit.as_ref().ok().map(|fit| fit.seconds),
            "parameters": model.fit.as_ref().ok().map(named),
            "fails": model.fails,
        })).collect::<Vec<_>>(),
        "further_tests": found.further.iter().map(|test| json!({
            "name": test.name,
            "refused": test.shrinkage.as_ref().err(),
            "intervals_over_those_without_it": test.shrinkage.as_ref().ok(),
        })).collect::<Vec<_>>(),
        "seconds": fit.seconds,
    })
}

/// Names and values.
fn named(fit: &Fit) -> Value {
    fit.setup
        .parameters
        .iter()
        .zip(&fit.fitted.values)
        .map(|(parameter, value)| (parameter.name.clone(), json!(value)))
        .collect::<serde_json::Map<_, _>>()
        .into()
}

/// `residuals.csv`: a row for each datum.
///
/// # Errors
/// Those of writing CSV.
pub fn tables(fit: &Fit) -> Result<Vec<(String, Vec<u8>)>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["test", "column", "against", "place", "data", "model", "residual", "residual_over_noise"])?;
    for (group, sigma) in fit.groups.iter().zip(&fit.fitted.sigmas) {
        let Some(test) = fit.setup.tests.get(group.test) else { continue };
        let Some(column) = group.column.and_then(|column| test.columns.get(column)) else { continue };
        for (row, model) in test.rows.iter().zip(fit.fitted.model.get(group.places.clone()).unwrap_or(&[])) {
            let (Some(place), Some(value)) = (test.abscissa.get(*row), column.values.get(*row)) else { continue };
            let (model, residual) = if test.relative { (model.exp(), model - value.ln()) } else { (*model, model - value) };
            writer.write_record([
                (group.test + 1).to_string(),
                column.word.clone(),
                test.against.clone(),
                format!("{place:e}"),
                format!("{value:e}"),
                format!("{model:e}"),
                format!("{:e}", model - value),
                format!("{:.4}", residual / sigma),
            ])?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(vec![("residuals.csv".to_owned(), bytes)])
}
