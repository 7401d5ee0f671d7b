//! Shift factors found from a measured table, and what a fit leaves open.

use super::material_data::{TEMPERATURE_TOLERANCE, isotherms, observations, overlap};
use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{FittedData, MaterialData, MeasuredRow, MeasuredSort, Overlap};
use viscotack::material::fit::superposition::{Isotherm, Superposition, superpose};
use viscotack::material::fit::{Quantity, Wanted};

/// Most isotherms whose shifts are found together.
const MOST_ISOTHERMS: usize = 60;

/// Brings all rows to the reference temperature by factors that are found from them.
pub(super) fn superposed(
    table: &Section<'_>,
    data: &mut MaterialData,
    tolerance: Option<f64>,
    reference: Option<f64>,
    vertical: bool,
    wanted: Wanted,
) -> Result<(Overlap, Superposition), SceneError> {
    let wrong = |message: String, label: &str| table.wrong("shift", message, label);
    if data.rows.iter().any(|row| row.temperature.is_none()) {
        let message = format!("an automatic shift needs the temperature of each row, and {:?} has no column with it", data.file);
        return Err(wrong(message, "add a column such as temperature (°C), or leave the shift out"));
    }
    let temperatures = isotherms(data, tolerance.unwrap_or(TEMPERATURE_TOLERANCE), "it is shifted as a whole");
    if temperatures.len() < 2 {
        return Err(wrong("an automatic shift needs data at two temperatures or more, and there is one".into(), "leave it out"));
    }
    if temperatures.len() > MOST_ISOTHERMS {
        let message =
            format!("an automatic shift finds the factors of at most {MOST_ISOTHERMS} temperatures, and there are {}", temperatures.len());
        return Err(wrong(message, "too many temperatures")
            .help("a table of temperatures that were swept has no isotherms: give the factors by wlf, arrhenius, factors or table"));
    }
    let curves: Vec<Isotherm> = temperatures
        .iter()
        .map(|&temperature| {
            let rows: Vec<MeasuredRow> = data.rows.iter().filter(|row| row.temperature == Some(temperature)).copied().collect();
            Isotherm { temperature, data: observations(&rows, data.sort) }
        })
        .collect();
    let superposition = superpose(&curves, reference, vertical, wanted).map_err(|refusal| {
        wrong(format!("no shift can be found from the data: {refusal}"), "automatic")
            .help("give the factors by material.shift.wlf, arrhenius, factors or table, or leave out the temperatures that do not overlap")
    })?;
    for row in &mut data.rows {
        let Some(shift) = superposition.shifts.iter().find(|shift| row.temperature == Some(shift.temperature)) else { continue };
        row.at *= if data.sort == MeasuredSort::Moduli { shift.logarithm } else { -shift.logarithm }.exp();
        let factor = if data.sort == MeasuredSort::Creep { -shift.vertical } else { shift.vertical }.exp();
        row.value *= factor;
        row.loss = row.loss.map(|loss| loss * factor);
    }
    data.warnings.extend(statement(&superposition, vertical));
    Ok((overlap(data, &temperatures), superposition))
}

/// What is odd about the superposition.
fn statement(superposition: &Superposition, vertical: bool) -> Option<String> {
    let percent = |part: f64| format!("{:.2} %", 100.0 * part);
    match (superposition.holds(), superposition.alone) {
        (Some(false), Some(alone)) => Some(format!(
            "time–temperature superposition does not hold: one curve misses the data by {}, and curves of their own follow the isotherms within {}{}",
            percent(superposition.together),
            percent(alone),
            if vertical { "" } else { " (vertical factors were not tried: shift = \"automatic_with_vertical\")" }
        )),
        (None, _) => Some("the isotherms are too short to say whether time–temperature superposition holds".to_owned()),
        _ => None,
    }
}

/// Refuses creep without a glassy modulus, and states what else the data leave open at the ends.
pub(super) fn unfixed(table: &Section<'_>, fitted: &mut FittedData) -> Result<(), SceneError> {
    let (fit, creep) = (&fitted.fit, fitted.data.sort == MeasuredSort::Creep);
    // At times so short and frequencies so low only the constant of the series is left.
    let nothing = f64::MIN_POSITIVE;
    if creep {
        let (compliance, error) = (1.0 / fit.material.glassy_modulus(), fit.band.error(Quantity::Creep, nothing));
        if error >= compliance {
            let message = format!(
                "the creep data do not fix the glassy modulus: its compliance comes out as {compliance:.2e} ± {error:.1e} 1/Pa (a Kelvin–Voigt solid has none)"
            );
            return Err(table.wrong("data", message, "this file").help(
                "add shorter times, down to where the compliance stops falling; or give material.glassy_modulus and material.creep terms in place of the data",
            ));
        }
    } else {
        let (modulus, error) = (fit.material.relaxed_modulus(), fit.band.error(Quantity::Storage, nothing));
        if modulus > 0.0 && error >= modulus {
            fitted.warnings.push(format!(
                "the data do not fix the relaxed modulus: it comes out as {modulus:.2e} ± {error:.1e} Pa; lower frequencies or longer times are needed"
            ));
        }
    }
    let rest = fitted.fit.rest;
    if let (false, Some(solid), Some(liquid)) = (rest.decided(), rest.solid_rms_error, rest.liquid_rms_error) {
        fitted.warnings.push(format!(
            "the data do not tell a solid from a liquid: the best solid that was found follows them within {solid:.2e}, the best liquid (relaxed modulus 0) within {liquid:.2e}; taken is the {}; lower frequencies or longer times would decide",
            if rest.liquid { "liquid" } else { "solid" }
        ));
    }
    Ok(())
}
