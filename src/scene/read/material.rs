//! The [material] table: moduli, creep or relaxation terms, data or a law, and what must fit together.

use super::material_source::Shift;
use super::section::Section;
use super::{material_data, material_source};
use crate::material::{CreepTerm, Material, RelaxationTerm};
use crate::refusal::Refusal;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::{MaterialOrigin, SceneMaterial};

/// How far fractions may be from summing to one: the rounding of two-digit tables is more, so they are meant to be exact.
const FRACTION_SLACK: f64 = 1e-9;

pub(super) fn read(top: &Section<'_>, document: &Document) -> Result<SceneMaterial, SceneError> {
    let table = top.required_table("material", "every problem has a deformable solid")?;
    let poisson_ratio = table.number("poisson_ratio")?;
    let (shift, mut notes) = material_source::shift(&table, document)?;
    let reference = table.number("reference_temperature")?;
    let way = table.at_most_one(&["creep", "relaxation", "data", "power_law", "fractional_zener"])?;
    belonging(&table, way)?;
    let origin = match way {
        Some("data") => material_data::from_data(&table, document, poisson_ratio, &shift, reference)?,
        Some(law @ ("power_law" | "fractional_zener")) => {
            let moduli = (relaxed(&table)?.or((table.units() == Units::Reduced).then_some(1.0)), table.number("glassy_modulus")?);
            material_source::from_law(&table, document, law, moduli)?
        }
        _ => MaterialOrigin::Terms,
    };
    let measured_warm = matches!(&origin, MaterialOrigin::Data(fitted) if fitted.data.rows.iter().any(|row| row.temperature.is_some()));
    if reference.is_some() && shift == Shift::None && !measured_warm && table.node().get("temperature").is_none() {
        let message = "`material.reference_temperature` has no effect without shift factors";
        return Err(table.wrong("reference_temperature", message, "leave it out, or add material.shift"));
    }
    let series = match (&origin, way) {
        (MaterialOrigin::Data(fitted), _) => fitted.fit.material.clone(),
        (MaterialOrigin::Law(law), _) => law.expansion.material.clone(),
        (MaterialOrigin::Terms, Some("creep")) => from_creep(&table)?,
        (MaterialOrigin::Terms, Some(_)) => from_relaxation(&table)?,
        (MaterialOrigin::Terms, None) => elastic(&table)?,
    };
    if table.units() == Units::Reduced && (series.relaxed_modulus() - 1.0).abs() > 1e-9 {
        let message = format!(
            "in reduced units the relaxed modulus is the unit, but `material.relaxed_modulus` comes out as {}",
            series.relaxed_modulus()
        );
        return Err(table.wrong("relaxed_modulus", message, "must be 1 (or left out)").help("or write the scene in SI units"));
    }
    if let MaterialOrigin::Data(fitted) = &origin {
        notes.extend(fitted.data.notes.iter().cloned());
    }
    let (series, climate) = material_source::at_temperature(&table, shift, &origin, reference, series)?;
    Ok(SceneMaterial { name: table.text("name").map(str::to_owned), series, poisson_ratio, origin, climate, notes })
}

/// Refuses keys that belong to data or to a law where there is none, and moduli beside data.
fn belonging(table: &Section<'_>, way: Option<&str>) -> Result<(), SceneError> {
    // No bound on what leaving terms out changes holds for every problem: a cylinder's friction has a part from every wavelength.
    if table.number("leave_out")?.is_some_and(|part| part > 0.0) {
        return Err(table.wrong("leave_out", "no term of a material is left out any more", "delete this line"));
    }
    let data = way == Some("data");
    if data && table.units() == Units::Reduced {
        return Err(table.wrong("data", "`material.data` is measured in SI units, and the scene is in reduced ones", "this file"));
    }
    let of_data: &[&str] = &["fit_error", "columns", "temperature_tolerance"];
    let of_terms: &[&str] = &["relaxed_modulus", "glassy_modulus", "viscosity"];
    let law = matches!(way, Some("power_law" | "fractional_zener"));
    for (keys, stray, owner) in [
        (of_data, !data, "belongs to material.data, and there is none"),
        (of_terms, data, "follows from material.data"),
        (&["viscosity"], law, "belongs to a creep series"),
        (&["expansion"], !law, "belongs to material.power_law or material.fractional_zener, and there is none"),
    ] {
        if let Some(key) = keys.iter().find(|key| stray && table.node().get(key).is_some()) {
            return Err(table.wrong(key, format!("`material.{key}` {owner}"), "leave it out"));
        }
    }
    if table.units() == Units::Reduced
        && let Some(key) = ["temperature", "reference_temperature"].iter().find(|key| table.node().get(key).is_some())
    {
        return Err(table.wrong(key, format!("`material.{key}` means nothing in a scene in reduced units"), "leave it out"));
    }
    Ok(())
}

/// The relaxed modulus: in reduced units 1 unless given.
fn relaxed(table: &Section<'_>) -> Result<Option<f64>, SceneError> {
    Ok(match (table.number("relaxed_modulus")?, table.units()) {
        (None, Units::Reduced) if table.node().get("glassy_modulus").is_none() || uses_fractions(table) => Some(1.0),
        (given, _) => given,
    })
}

fn uses_fractions(table: &Section<'_>) -> bool {
    ["creep", "relaxation"].into_iter().flat_map(|series| table.items(series)).any(|term| term.node().get("fraction").is_some())
}

fn elastic(table: &Section<'_>) -> Result<Material, SceneError> {
    let modulus = match (relaxed(table)?, table.number("glassy_modulus")?) {
        (Some(relaxed), Some(glassy)) if (relaxed - glassy).abs() > FRACTION_SLACK * glassy => {
            let message = format!(
                "`material.relaxed_modulus` ({relaxed:e}) and `material.glassy_modulus` ({glassy:e}) differ, but there are no creep or relaxation terms that lead from one to the other"
            );
            return Err(table.wrong("glassy_modulus", message, "leave one out, or add material.creep or material.relaxation"));
        }
        (Some(modulus), _) | (None, Some(modulus)) => modulus,
        (None, None) => return Err(table.missing("relaxed_modulus")),
    };
    if table.node().get("viscosity").is_some() {
        return Err(table.wrong("viscosity", "`material.viscosity` belongs to a creep series, and there is none", "add material.creep"));
    }
    refused(table, "relaxed_modulus", Material::elastic(modulus))
}

fn from_creep(table: &Section<'_>) -> Result<Material, SceneError> {
    let items = table.items("creep");
    if items.is_empty() {
        return Err(table.wrong("creep", "`material.creep` is an empty list", "add a term, or leave the key out for an elastic material"));
    }
    let viscosity = table.number("viscosity")?;
    let (strengths, times) = terms(&items, "compliance", "retardation_time")?;
    let (relaxed, glassy) = (relaxed(table)?, table.number("glassy_modulus")?);
    if viscosity.is_some() && table.node().get("relaxed_modulus").is_some() {
        let message = "`material.viscosity` makes the relaxed modulus zero";
        return Err(table.wrong("relaxed_modulus", message, "leave the viscosity or this modulus out"));
    }
    let (glassy, compliances) = match strengths {
        Strengths::Fractions(fractions) => {
            let (relaxed, glassy) = both(table, relaxed, glassy)?;
            // 1/E0 − 1/E∞ with the difference taken first.
            let gained = (glassy - relaxed) / glassy / relaxed;
            (glassy, fractions.iter().map(|fraction| fraction * gained).collect::<Vec<_>>())
        }
        Strengths::Absolute(compliances) => {
            let gained: f64 = compliances.iter().sum();
            let glassy = match (relaxed, glassy) {
                (_, Some(_)) if table.node().get("relaxed_modulus").is_some() => return Err(overdetermined(table, "compliance")),
                (_, Some(glassy)) => glassy,
                (Some(relaxed), None) if relaxed > 0.0 => 1.0 / (1.0 / relaxed - gained),
                (Some(_), None) => {
                    let message = "a relaxed modulus of 0 does not fix the glassy modulus of a creep series";
                    return Err(table.wrong("relaxed_modulus", message, "give glassy_modulus and viscosity instead"));
                }
                (None, None) => return Err(table.missing("glassy_modulus")),
            };
            if !(glassy.is_finite() && glassy > 0.0) {
                let message = format!("the compliances sum to {gained:e}, at least the whole relaxed compliance 1/E0");
                return Err(table.wrong("relaxed_modulus", message, "leaves no positive glassy compliance 1/E∞"));
            }
            (glassy, compliances)
        }
    };
    let terms: Vec<CreepTerm> =
        compliances.into_iter().zip(times).map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).collect();
    refused(table, "creep", Material::from_creep(glassy, &terms, viscosity))
}

fn from_relaxation(table: &Section<'_>) -> Result<Material, SceneError> {
    let items = table.items("relaxation");
    if items.is_empty() {
        return Err(table.wrong(
            "relaxation",
            "`material.relaxation` is an empty list",
            "add a term, or leave the key out for an elastic material",
        ));
    }
    if table.node().get("viscosity").is_some() {
        let message = "`material.viscosity` belongs to a creep series; a relaxation series flows if relaxed_modulus = 0";
        return Err(table.wrong("viscosity", message, "leave it out"));
    }
    let (strengths, times) = terms(&items, "modulus", "relaxation_time")?;
    let (relaxed, glassy) = (relaxed(table)?, table.number("glassy_modulus")?);
    let (relaxed, moduli) = match strengths {
        Strengths::Fractions(fractions) => {
            let (relaxed, glassy) = both(table, relaxed, glassy)?;
            (relaxed, fractions.iter().map(|fraction| fraction * (glassy - relaxed)).collect::<Vec<_>>())
        }
        Strengths::Absolute(moduli) => {
            let lost: f64 = moduli.iter().sum();
            let relaxed = match (relaxed, glassy) {
                (Some(_), Some(_)) => return Err(overdetermined(table, "modulus")),
                (Some(relaxed), None) => relaxed,
                (None, Some(glassy)) => glassy - lost,
                (None, None) => return Err(table.missing("relaxed_modulus")),
            };
            if relaxed < 0.0 {
                let message = format!("the moduli of the terms sum to {lost:e}, more than the glassy modulus");
                return Err(table.wrong("glassy_modulus", message, "leaves a negative relaxed modulus"));
            }
            (relaxed, moduli)
        }
    };
    let terms: Vec<RelaxationTerm> =
        moduli.into_iter().zip(times).map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
    refused(table, "relaxation", Material::from_relaxation(relaxed, &terms))
}

/// The strengths of a series, all given in the same way.
enum Strengths {
    Fractions(Vec<f64>),
    Absolute(Vec<f64>),
}

fn terms(items: &[Section<'_>], strength: &'static str, time: &'static str) -> Result<(Strengths, Vec<f64>), SceneError> {
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
        times.push(item.required_number(time)?);
    }
    if first_way == Some("fraction") {
        let sum: f64 = strengths.iter().sum();
        if (sum - 1.0).abs() > FRACTION_SLACK {
            let message = format!(
                "the fractions of `material.{}` sum to {sum}, not to 1",
                if time == "retardation_time" { "creep" } else { "relaxation" }
            );
            return Err(items
                .last()
                .map_or_else(|| SceneError::general(message.clone()), |last| last.wrong("fraction", &message, "the last of them")));
        }
        Ok((Strengths::Fractions(strengths), times))
    } else {
        Ok((Strengths::Absolute(strengths), times))
    }
}

/// Both moduli, in order.
fn both(table: &Section<'_>, relaxed: Option<f64>, glassy: Option<f64>) -> Result<(f64, f64), SceneError> {
    let relaxed = relaxed.ok_or_else(|| table.missing("relaxed_modulus"))?;
    let glassy = glassy.ok_or_else(|| table.missing("glassy_modulus"))?;
    if relaxed == 0.0 {
        return Err(table.wrong("relaxed_modulus", "fractions need a relaxed modulus above 0", "give absolute terms instead"));
    }
    if relaxed > glassy {
        let message = format!("`material.relaxed_modulus` ({relaxed:e}) is above `material.glassy_modulus` ({glassy:e})");
        return Err(table.wrong("relaxed_modulus", message, "must be at most the glassy modulus"));
    }
    Ok((relaxed, glassy))
}

fn overdetermined(table: &Section<'_>, strength: &str) -> SceneError {
    let message = format!("both moduli and every `{strength}` are given: one of the two moduli follows from the rest");
    table.wrong("glassy_modulus", message, "leave one of the two moduli out, or give `fraction` instead")
}

fn refused(table: &Section<'_>, key: &str, result: Result<Material, Refusal>) -> Result<Material, SceneError> {
    result.map_err(|refusal| table.wrong(key, format!("the material cannot be made: {refusal}"), "from these numbers"))
}
