//! Laws with a continuous spectrum, shift factors, and the temperature of a material.

use super::section::Section;
use super::shift_table::shift_table;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::{Climate, ExpandedLaw, MaterialOrigin};
use std::sync::Arc;
use viscotack::material::Material;
use viscotack::material::broad::{BroadKind, BroadLaw, expand};
use viscotack::material::shift::ShiftFactors;

/// Accuracy of an expansion where none is named.
const DEFAULT_ACCURACY: f64 = 1e-6;
/// Decades on both sides of a law's own time over which it is expanded where no range is named.
const DEFAULT_SPAN: f64 = 1e6;

/// The terms of `material.power_law` or `material.fractional_zener`.
pub(super) fn from_law(
    table: &Section<'_>,
    document: &Document,
    key: &'static str,
    (relaxed, glassy): (Option<f64>, Option<f64>),
) -> Result<MaterialOrigin, SceneError> {
    let relaxed = relaxed.ok_or_else(|| table.missing("relaxed_modulus"))?;
    let glassy = glassy.ok_or_else(|| table.missing("glassy_modulus"))?;
    let Some(law) = table.table(key) else { return Err(table.missing(key)) };
    let (exponent, time) = (law.required_number("exponent")?, law.required_number("time")?);
    let (kind, name) = if key == "power_law" {
        (BroadKind::ModifiedPowerLaw(exponent), "modified power law")
    } else {
        (BroadKind::FractionalZener(exponent), "fractional Zener solid")
    };
    let made = BroadLaw::new(kind, relaxed, glassy, time)
        .map_err(|refusal| law.wrong("exponent", format!("the {name} cannot be made: {refusal}"), "of this law"))?;
    let expansion = table.table("expansion");
    let number = |key: &str| -> Result<Option<f64>, SceneError> { expansion.as_ref().map_or(Ok(None), |section| section.number(key)) };
    let accuracy = number("accuracy")?.unwrap_or(DEFAULT_ACCURACY);
    let (slowest, fastest) = (number("slowest_time")?, number("fastest_time")?);
    let stated = [slowest.is_some(), fastest.is_some()];
    let range = [1.0 / slowest.unwrap_or(time * DEFAULT_SPAN), 1.0 / fastest.unwrap_or(time / DEFAULT_SPAN)];
    document.materials().get(&format!("{made:?} {range:?} {stated:?} {accuracy:e}"), || {
        let place = expansion.as_ref().unwrap_or(&law);
        let expansion = expand(&made, range, accuracy)
            .map_err(|refusal| place.wrong("accuracy", format!("the {name} cannot be expanded: {refusal}"), "of this law"))?;
        Ok(MaterialOrigin::Law(Arc::new(ExpandedLaw { law: made, name, range, stated, accuracy, expansion })))
    })
}

/// The shift factors that a scene gives, or how they are found.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shift {
    None,
    Given(ShiftFactors),
    /// From the data, with vertical factors or without.
    Automatic {
        vertical: bool,
    },
}

/// The shift of the material, and what was chosen in reading it.
pub(super) fn shift(table: &Section<'_>, document: &Document) -> Result<(Shift, Vec<String>), SceneError> {
    let Some(shift) = table.table("shift") else { return Ok((Shift::None, Vec::new())) };
    if let Some(word) = table.text("shift") {
        if table.node().get("data").is_none() {
            let message = format!("`material.shift` = {word:?} finds the factors from material.data, and there is none");
            return Err(table.wrong("shift", message, "give factors by wlf, arrhenius, factors or table"));
        }
        return Ok((Shift::Automatic { vertical: word == "automatic_with_vertical" }, Vec::new()));
    }
    if table.units() == Units::Reduced {
        return Err(table.wrong("shift", "`material.shift` needs temperatures, and a scene in reduced units has none", "leave it out"));
    }
    let reference = || table.required_number("reference_temperature");
    let mut notes = Vec::new();
    let factors = match shift.exactly_one(&["wlf", "arrhenius", "factors", "table"])? {
        "wlf" => {
            let Some(wlf) = shift.table("wlf") else { return Err(shift.missing("wlf")) };
            ShiftFactors::WilliamsLandelFerry { c1: wlf.required_number("c1")?, c2: wlf.required_number("c2")?, reference: reference()? }
        }
        "arrhenius" => {
            let Some(arrhenius) = shift.table("arrhenius") else { return Err(shift.missing("arrhenius")) };
            ShiftFactors::Arrhenius { activation_energy: arrhenius.required_number("activation_energy")?, reference: reference()? }
        }
        "factors" => {
            let mut points = Vec::new();
            for item in shift.items("factors") {
                points.push((item.required_number("temperature")?, item.required_number("factor")?));
            }
            points.sort_by(|left, right| left.0.total_cmp(&right.0));
            table_of(&shift, "factors", points, reference()?)?
        }
        _ => {
            let table = shift_table(&shift, document)?;
            notes = table.notes;
            table_of(&shift, "table", table.points, reference()?)?
        }
    };
    Ok((Shift::Given(factors), notes))
}

/// Factors of at least two different temperatures, divided by that at the reference temperature: a table may be relative to any temperature of its own.
fn table_of(shift: &Section<'_>, key: &str, mut points: Vec<(f64, f64)>, reference: f64) -> Result<ShiftFactors, SceneError> {
    if points.len() < 2 {
        return Err(shift.wrong(key, format!("`{}` has {} temperatures", shift.full(key), points.len()), "needs at least two"));
    }
    if points.windows(2).any(|pair| pair[1].0 - pair[0].0 <= 1e-9 * pair[0].0) {
        return Err(shift.wrong(key, format!("`{}` names a temperature twice", shift.full(key)), "leave one out"));
    }
    let of_reference = ShiftFactors::Table(points.clone()).decades(reference).map_err(|refusal| {
        shift.wrong(key, format!("no shift factor at the reference temperature {reference:.2} K: {refusal}"), "these factors")
    })?;
    for (_, factor) in &mut points {
        *factor *= 10f64.powf(-of_reference);
    }
    Ok(ShiftFactors::Table(points))
}

/// The factors, given or found, and the temperature that they are relative to.
fn found(shift: Shift, origin: &MaterialOrigin, reference: Option<f64>) -> (Option<ShiftFactors>, Option<f64>) {
    match (shift, origin) {
        (Shift::Given(factors), _) => (Some(factors), reference),
        (Shift::Automatic { .. }, MaterialOrigin::Data(fitted)) => match &fitted.superposition {
            Some(superposition) => (Some(superposition.factors()), Some(superposition.reference)),
            None => (None, reference),
        },
        (Shift::None | Shift::Automatic { .. }, _) => (None, reference),
    }
}

/// The material at `material.temperature`.
pub(super) fn at_temperature(
    table: &Section<'_>,
    shift: Shift,
    origin: &MaterialOrigin,
    reference: Option<f64>,
    series: Material,
) -> Result<(Material, Option<Climate>), SceneError> {
    let temperature = table.number("temperature")?;
    let (shift, reference) = found(shift, origin, reference);
    let Some(shift) = shift else {
        if let (Some(temperature), reference) = (temperature, reference)
            && reference.is_none_or(|reference| (reference - temperature).abs() > 1e-9 * temperature)
        {
            return Err(table
                .wrong(
                    "temperature",
                    "`material.temperature` is given, but no shift factors",
                    "how does the material follow the temperature?",
                )
                .help("add material.shift and material.reference_temperature"));
        }
        return Ok((series, None));
    };
    let reference = reference.ok_or_else(|| table.missing("reference_temperature"))?;
    let temperature = temperature.unwrap_or(reference);
    let refused = |refusal| table.wrong("temperature", format!("no shift factor: {refusal}"), "at this temperature");
    let factor = shift.factor(temperature).map_err(refused)?;
    let slowed = series.slowed(factor).map_err(refused)?;
    Ok((slowed, Some(Climate { shift, reference, temperature, factor, at_reference: series })))
}
