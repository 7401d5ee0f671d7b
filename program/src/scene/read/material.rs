//! The [material] table: moduli, creep or relaxation terms, data or a law, and what must fit together.

use super::material_fractions::{FRACTION_SLACK, Strengths, both, of_fractions, summing_to_one, terms};
use super::material_source::Shift;
use super::section::Section;
use super::{decks, material_data, material_draws, material_solid, material_source};
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::{IsotropicSeries, MaterialOrigin, SceneMaterial};
use std::sync::Arc;
use viscotack::material::{CreepTerm, Material, RelaxationTerm};
use viscotack::refusal::Refusal;

pub(super) fn read(top: &Section<'_>, document: &Document) -> Result<SceneMaterial, SceneError> {
    let table = top.required_table("material", "every problem has a deformable solid")?;
    let mut poisson_ratio = table.number("poisson_ratio")?;
    let (mut shift, mut notes) = material_source::shift(&table, document)?;
    let mut reference = table.number("reference_temperature")?;
    let way = way(&table)?;
    belonging(&table, way)?;
    let mut made = None;
    let origin = match way {
        Some("shear_modulus") => {
            made = Some(material_solid::from_keys(&table)?);
            MaterialOrigin::Terms
        }
        Some(form) if decks::is_deck(form) => {
            let deck = decks::read(&table, document, form)?;
            if let Some(factors) = deck.shift {
                (shift, reference) = (Shift::Given(factors), deck.reference);
            }
            made = Some(deck.solid);
            MaterialOrigin::Deck(Arc::new(deck.origin))
        }
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
    let isotropic = made.as_mut().and_then(|solid| solid.isotropic.take());
    let series = match (&origin, way) {
        _ if made.is_some() => {
            let solid = made.ok_or_else(|| table.missing("shear_modulus"))?;
            poisson_ratio = solid.poisson_ratio;
            solid.youngs
        }
        (MaterialOrigin::Data(fitted), _) => fitted.fit.material.clone(),
        (MaterialOrigin::Law(law), _) => law.expansion.material.clone(),
        (_, Some("creep")) => from_creep(&table)?,
        (_, Some(_)) => from_relaxation(&table)?,
        (_, None) => elastic(&table)?,
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
    let draws = material_draws::draws(&table, &origin, climate.as_ref())?;
    let isotropic = isotropic
        .map(|at_reference| {
            let slowed = climate.as_ref().map_or_else(|| Ok(at_reference.clone()), |climate| at_reference.slowed(climate.factor));
            let wrong = |refusal| table.wrong("temperature", format!("the solid cannot be shifted: {refusal}"), "to this temperature");
            Ok::<_, SceneError>(Arc::new(IsotropicSeries { at_temperature: slowed.map_err(wrong)?, at_reference }))
        })
        .transpose()?;
    let deck_name = if let MaterialOrigin::Deck(deck) = &origin { deck.name.clone() } else { None };
    let name = table.text("name").map(str::to_owned).or(deck_name);
    let mut cautions = table.text_or_texts("cautions");
    if table.units() == Units::Si
        && let Some(strange) = strange_moduli(&series)
        && !cautions.contains(&strange)
    {
        cautions.push(strange);
    }
    Ok(SceneMaterial { name, series, poisson_ratio, isotropic, origin, climate, notes, cautions, draws })
}

/// Softer than most gels, and as stiff as diamond (Pa).
const USUAL_MODULI: [f64; 2] = [1e3, 1e12];

/// What moduli that hardly any solid has make one ask.
fn strange_moduli(series: &Material) -> Option<String> {
    let glassy = series.glassy_modulus();
    let compared = match glassy {
        soft if soft < USUAL_MODULI[0] => "softer than 1 kPa, as only the softest gels are",
        stiff if stiff > USUAL_MODULI[1] => "stiffer than 1 TPa, as not even diamond is",
        _ => return None,
    };
    Some(format!("the modulus E∞ of an instantaneous load is {glassy:.3e} Pa: {compared}; is the unit right?"))
}

/// Keys that each say what the material is made of.
const WAYS: [&str; 11] =
    ["creep", "relaxation", "data", "power_law", "fractional_zener", "shear_modulus", "abaqus", "ansys", "ls_dyna", "comsol", "moose"];

/// The one of [`WAYS`] that is given; keys that belong to some of them are refused beside the others.
fn way(table: &Section<'_>) -> Result<Option<&'static str>, SceneError> {
    let way = table.at_most_one(&WAYS)?;
    let deck = way.is_some_and(decks::is_deck);
    let of_shear: &[&str] = &["shear_relaxation", "bulk_modulus", "bulk_relaxation"];
    let of_deck: &[&str] = &["deck_units", "deck_material"];
    let of_youngs: &[&str] = &["relaxed_modulus", "glassy_modulus", "viscosity"];
    let shear = way == Some("shear_modulus");
    for (keys, stray, message, label) in [
        (of_shear, !shear, "belongs to material.shear_modulus", "give shear_modulus as well, or leave this out"),
        (&["moduli"], !shear && way != Some("comsol"), "says which shear and bulk modulus are given, and there are none", "leave it out"),
        (of_deck, !deck, "belongs to the deck of a finite-element program, and there is none", "leave it out"),
        (of_youngs, shear, "is Young's, and the moduli here are those of shear and volume", "leave it out"),
        (of_youngs, deck, "follows from the deck", "leave it out"),
        (&["poisson_ratio"], deck, "follows from the deck", "leave it out"),
    ] {
        if let Some(key) = keys.iter().find(|key| stray && table.node().get(key).is_some()) {
            return Err(table.wrong(key, format!("`material.{key}` {message}"), label));
        }
    }
    Ok(way)
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
    let (strengths, times) = terms(&items, "compliance", |item| item.required_number("retardation_time"))?;
    let (relaxed, glassy) = (relaxed(table)?, table.number("glassy_modulus")?);
    if viscosity.is_some() && table.node().get("relaxed_modulus").is_some() {
        let message = "`material.viscosity` makes the relaxed modulus zero";
        return Err(table.wrong("relaxed_modulus", message, "leave the viscosity or this modulus out"));
    }
    let (glassy, compliances) = match strengths {
        Strengths::Fractions(fractions) => {
            summing_to_one(table, "creep", fractions.iter().sum(), "")?;
            let (relaxed, glassy) = both(table, relaxed, glassy)?;
            if relaxed == 0.0 {
                return Err(table.wrong("relaxed_modulus", "fractions need a relaxed modulus above 0", "give absolute terms instead"));
            }
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
    let (strengths, times) = terms(&items, "modulus", material_solid::time)?;
    let (relaxed, glassy) = (relaxed(table)?, table.number("glassy_modulus")?);
    let (relaxed, moduli) = match strengths {
        Strengths::Fractions(fractions) => {
            let (relaxed, lost) = of_fractions(table, &fractions, relaxed, glassy)?;
            (relaxed, fractions.iter().map(|fraction| fraction * lost).collect::<Vec<_>>())
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

fn overdetermined(table: &Section<'_>, strength: &str) -> SceneError {
    let message = format!("both moduli and every `{strength}` are given: one of the two moduli follows from the rest");
    table.wrong("glassy_modulus", message, "leave one of the two moduli out, or give `fraction` instead")
}

fn refused(table: &Section<'_>, key: &str, result: Result<Material, Refusal>) -> Result<Material, SceneError> {
    result.map_err(|refusal| table.wrong(key, format!("the material cannot be made: {refusal}"), "from these numbers"))
}
