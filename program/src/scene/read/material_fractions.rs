//! The strengths of a series' terms: absolute, or as fractions of what both moduli leave, or of the instantaneous modulus.

use super::section::Section;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;

/// How far fractions may be from summing to one: the rounding of two-digit tables is more, so they are meant to be exact.
pub(super) const FRACTION_SLACK: f64 = 1e-9;

/// The strengths of a series, all given in the same way.
pub(super) enum Strengths {
    Fractions(Vec<f64>),
    Absolute(Vec<f64>),
}

pub(super) fn terms(
    items: &[Section<'_>],
    strength: &'static str,
    time: impl Fn(&Section<'_>) -> Result<f64, SceneError>,
) -> Result<(Strengths, Vec<f64>), SceneError> {
    let (mut strengths, mut times) = (Vec::with_capacity(items.len()), Vec::with_capacity(items.len()));
    let mut first_way = None;
    for item in items {
        let way = item.exactly_one(&[strength, "fraction"])?;
        if *first_way.get_or_insert(way) != way {
            return Err(item.wrong(
                way,
                format!("`{}` among terms given in another way", item.full(way)),
                "give all terms in the same way",
            ));
        }
        strengths.push(item.required_number(way)?);
        times.push(time(item)?);
    }
    Ok((if first_way == Some("fraction") { Strengths::Fractions(strengths) } else { Strengths::Absolute(strengths) }, times))
}

/// Refuses fractions that do not sum to one.
pub(super) fn summing_to_one(table: &Section<'_>, series: &str, sum: f64, help: &str) -> Result<(), SceneError> {
    if (sum - 1.0).abs() <= FRACTION_SLACK {
        return Ok(());
    }
    let message = format!("the fractions of `material.{series}` sum to {sum}, not to 1");
    let last = table.items(series).last().map(|last| last.wrong("fraction", &message, "the last of them"));
    let error = last.unwrap_or_else(|| SceneError::general(message));
    Err(if help.is_empty() { error } else { error.help(help) })
}

/// E0, and the modulus that the fractions of relaxation terms are of: E∞ − E0 where both moduli are given, E∞ where one is.
pub(super) fn of_fractions(
    table: &Section<'_>,
    fractions: &[f64],
    relaxed: Option<f64>,
    glassy: Option<f64>,
) -> Result<(f64, f64), SceneError> {
    let sum: f64 = fractions.iter().sum();
    let left = 1.0 - sum;
    if let (Some(_), Some(_)) = (relaxed, glassy) {
        let help = format!(
            "with both moduli, fractions are of E∞ − E0. Are they of the instantaneous modulus, as in finite-element decks? Then delete the line relaxed_modulus: it follows as {left:.6} of glassy_modulus"
        );
        summing_to_one(table, "relaxation", sum, if left > FRACTION_SLACK && table.units() == Units::Si { &help } else { "" })?;
        let (relaxed, glassy) = both(table, relaxed, glassy)?;
        return Ok((relaxed, glassy - relaxed));
    }
    if left < -FRACTION_SLACK {
        summing_to_one(
            table,
            "relaxation",
            sum,
            "the fractions of relaxation terms are of the instantaneous modulus: they sum to at most 1",
        )?;
    }
    if left <= FRACTION_SLACK {
        let missing = if glassy.is_some() { "relaxed_modulus" } else { "glassy_modulus" };
        let help = "the fractions sum to 1: with both moduli they are of E∞ − E0. Write relaxed_modulus = 0 if the material is a liquid, or the modulus it relaxes to";
        return Err(if glassy.is_some() { table.missing(missing).help(help) } else { table.missing(missing) });
    }
    match (relaxed, glassy) {
        (None, Some(glassy)) => Ok((glassy * left, glassy)),
        (Some(relaxed), None) if relaxed > 0.0 => Ok((relaxed, relaxed / left)),
        (Some(_), None) => {
            let message = "fractions that leave a long-term part contradict a relaxed modulus of 0";
            Err(table.wrong("relaxed_modulus", message, "give glassy_modulus in its place"))
        }
        _ => Err(table.missing("glassy_modulus")),
    }
}

/// Both moduli, in order.
pub(super) fn both(table: &Section<'_>, relaxed: Option<f64>, glassy: Option<f64>) -> Result<(f64, f64), SceneError> {
    let relaxed = relaxed.ok_or_else(|| table.missing("relaxed_modulus"))?;
    let glassy = glassy.ok_or_else(|| table.missing("glassy_modulus"))?;
    if relaxed > glassy {
        let message = format!("`material.relaxed_modulus` ({relaxed:e}) is above `material.glassy_modulus` ({glassy:e})");
        return Err(table.wrong("relaxed_modulus", message, "must be at most the glassy modulus"));
    }
    Ok((relaxed, glassy))
}
