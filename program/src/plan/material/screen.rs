//! A material on the screen, and as JSON.

use super::{MaterialReport, shifts};
use crate::scene::typed::{MaterialOrigin, MeasuredSort, SceneMaterial, Units};
use serde_json::{Value, json};
use std::fmt::Write as _;
use viscotack::material::fit::Plateau;

/// Most terms that are printed one by one.
const MOST_TERMS: usize = 40;

/// The report as a text.
#[must_use]
pub fn screen(report: &MaterialReport) -> String {
    let material = &report.material;
    let series = &material.series;
    let si = report.units == Units::Si;
    let (pressure, time) = if si { ("Pa", "s") } else { ("E0", "reference times") };
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}\n{}\n", report.title, "─".repeat(report.title.chars().count().clamp(20, 100)));
    match &material.origin {
        MaterialOrigin::Terms => {
            let _ = writeln!(text, "terms as given");
        }
        MaterialOrigin::Deck(deck) => {
            let _ = writeln!(text, "read from  {} ({} deck)", deck.file, deck.program);
        }
        MaterialOrigin::Data(fitted) => {
            let fit = &fitted.fit;
            let _ = writeln!(text, "fitted to  {}: {} rows, {} numbers", fitted.data.file, fitted.data.rows.len(), fit.observations);
            let _ = writeln!(text, "misfit     {:.2e} (root mean square, relative), {:.2e} (largest)", fit.rms_error, fit.largest_error);
            let _ = writeln!(
                text,
                "best fit   {:.2e} with {} terms: the closest series with positive strengths that was found",
                fit.best_rms_error, fit.best_terms
            );
            if let Some(consistency) = &fitted.consistency {
                let _ = writeln!(
                    text,
                    "Kramers–Kronig {}: E′ and E″ together within {}, with a free factor on E″ within {} (chance of that by scatter {:.1e}){}",
                    if consistency.holds() { "holds" } else { "FAILS" },
                    within(consistency.together),
                    within(consistency.with_factor),
                    consistency.chance,
                    consistency.local.map_or_else(String::new, |local| format!("; local relation within {local:.1e} (median)"))
                );
            }
            let _ = writeln!(text, "at rest    {}", shifts::at_rest(fit));
            if let Some(overlap) = &fitted.overlap {
                let _ = writeln!(
                    text,
                    "overlap    {} temperatures, {} of {} neighbours meet, within {:.1e}",
                    overlap.temperatures,
                    overlap.meeting,
                    overlap.temperatures - 1,
                    overlap.worst
                );
            }
            if let Some(superposition) = &fitted.superposition {
                text.push_str(&shifts::screen(superposition));
            }
        }
        MaterialOrigin::Law(law) => {
            let _ = writeln!(text, "expansion of a {} from {:.3e} to {:.3e} rad per unit of time", law.name, law.range[0], law.range[1]);
            let _ = writeln!(
                text,
                "error      {:.2e} of |E(ω)| (largest), wanted {:.0e}: {}",
                law.expansion.error,
                law.accuracy,
                if law.expansion.met { "met" } else { "NOT met" }
            );
            let _ = writeln!(
                text,
                "terms      {}; the best rational approximations need about {:.0} by their rate",
                series.relaxation_terms().len(),
                law.expansion.terms_by_rate
            );
        }
    }
    if let Some(climate) = &material.climate {
        let _ = writeln!(
            text,
            "temperature {:.2} K: times are {:.4e} of those at the reference temperature {:.2} K",
            climate.temperature, climate.factor, climate.reference
        );
    }
    let [relaxed, glassy] = plateaus(report);
    let _ = writeln!(text, "\nrelaxed modulus E0   {:.6e}{} {pressure}{}", series.relaxed_modulus(), relaxed[0], relaxed[1]);
    let _ = writeln!(text, "glassy modulus E∞    {:.6e}{} {pressure}{}", series.glassy_modulus(), glassy[0], glassy[1]);
    if series.relaxed_modulus() > 0.0 {
        let _ = writeln!(text, "stiffening E∞/E0     {:.6e}", series.stiffening_ratio());
    }
    if let Some(viscosity) = series.steady_viscosity() {
        let _ = writeln!(text, "steady viscosity     {viscosity:.6e} {pressure} {time}");
    }
    if let Some(solid) = &material.isotropic {
        let solid = &solid.at_temperature;
        let [glassy, relaxed] = solid.poisson_ratios();
        for (name, series) in [
            ("shear modulus G  ", solid.shear()),
            ("bulk modulus K   ", solid.bulk()),
            ("plane modulus E* ", solid.plane_strain().as_material()),
        ] {
            let _ = writeln!(
                text,
                "{name}    {:.6e} {pressure} at once, {:.6e} {pressure} in the end",
                series.glassy_modulus(),
                series.relaxed_modulus()
            );
        }
        let _ = writeln!(text, "Poisson ratio        {glassy:.6} at once, {relaxed:.6} in the end");
    } else if let Some(ratio) = material.poisson_ratio {
        let _ = writeln!(text, "Poisson ratio        {ratio} (constant)");
    }
    let terms = series.relaxation_terms();
    if !terms.is_empty() {
        let _ = writeln!(
            text,
            "\n{} relaxation terms\n  {:>14}  {:>16}",
            terms.len(),
            format!("modulus [{pressure}]"),
            format!("time [{time}]")
        );
        for term in terms.iter().take(MOST_TERMS) {
            let _ = writeln!(text, "  {:14.6e}  {:16.6e}", term.modulus, term.relaxation_time);
        }
        if terms.len() > MOST_TERMS {
            let _ = writeln!(text, "  … {} more in terms.csv", terms.len() - MOST_TERMS);
        }
    }
    for note in &material.notes {
        let _ = writeln!(text, "\nNote: {note}");
    }
    for caution in cautions(material) {
        let _ = writeln!(text, "\nCAUTION: {caution}");
    }
    if let MaterialOrigin::Deck(deck) = &material.origin {
        for note in &deck.notes {
            let _ = writeln!(text, "\nNOTE: {note}");
        }
    }
    text
}

/// What the data say of E0 and E∞: their stated errors, and where they are extrapolated.
fn plateaus(report: &MaterialReport) -> [[String; 2]; 2] {
    let MaterialOrigin::Data(fitted) = &report.material.origin else { return Default::default() };
    let [relaxed, glassy] = &fitted.plateaus;
    [(relaxed, "below", "longer"), (glassy, "above", "shorter")].map(|(one, beyond, times)| {
        // A liquid has the modulus 0, which no datum fixes.
        if one.modulus <= 0.0 {
            return Default::default();
        }
        let last = one.last / report.factor();
        let place = if fitted.data.sort == MeasuredSort::Moduli {
            format!("{beyond} {:.3e} Hz", last / std::f64::consts::TAU)
        } else {
            format!("at times {times} than {:.3e} s", 1.0 / last)
        };
        let note = if one.is_extrapolated() { format!(", extrapolated {place}") } else { String::new() };
        [format!(" ± {:.1e}", one.error), note]
    })
}

/// A misfit in words: below the last printed digit of any table it says nothing.
fn within(misfit: f64) -> String {
    if misfit < 1e-6 { "1e-6".to_owned() } else { format!("{misfit:.2e}") }
}

/// All that is known against the numbers of a material, a sentence each.
pub(super) fn cautions(material: &SceneMaterial) -> Vec<&str> {
    let of_data: &[String] = if let MaterialOrigin::Data(fitted) = &material.origin { &fitted.warnings } else { &[] };
    of_data.iter().chain(&material.cautions).map(String::as_str).collect()
}

/// The report as JSON.
#[must_use]
pub fn summary(report: &MaterialReport) -> Value {
    let material = &report.material;
    let series = &material.series;
    let origin = match &material.origin {
        MaterialOrigin::Terms => json!({ "kind": "terms" }),
        MaterialOrigin::Deck(deck) => {
            json!({ "kind": "deck", "file": deck.file, "program": deck.program, "name": deck.name, "notes": deck.notes })
        }
        MaterialOrigin::Data(fitted) => json!({
            "kind": "data",
            "file": fitted.data.file,
            "rows": fitted.data.rows.len(),
            "rms_error": fitted.fit.rms_error,
            "largest_error": fitted.fit.largest_error,
            "best_rms_error": fitted.fit.best_rms_error,
            "best_terms": fitted.fit.best_terms,
            "kramers_kronig": fitted.consistency.map(|consistency| json!({
                "holds": consistency.holds(),
                "together": consistency.together,
                "with_factor": consistency.with_factor,
                "factor": consistency.factor,
                "chance": consistency.chance,
                "local": consistency.local,
            })),
            "at_rest": {
                "liquid": fitted.fit.rest.liquid,
                "decided": fitted.fit.rest.decided(),
                "solid_rms_error": fitted.fit.rest.solid_rms_error,
                "liquid_rms_error": fitted.fit.rest.liquid_rms_error,
            },
            "shifts": fitted.superposition.as_ref().map(shifts::summary),
            "warnings": cautions(material),
        }),
        MaterialOrigin::Law(law) => json!({
            "kind": law.name,
            "from": law.range[0],
            "to": law.range[1],
            "accuracy": law.accuracy,
            "error": law.expansion.error,
            "terms_by_rate": law.expansion.terms_by_rate,
        }),
    };
    let of_fit = |end: usize| if let MaterialOrigin::Data(fitted) = &material.origin { fitted.plateaus.get(end) } else { None };
    json!({
        "program": format!("viscotack {} {}", crate::VERSION, crate::COMMIT),
        "title": report.title,
        "units": if report.units == Units::Si { "si" } else { "reduced" },
        "origin": origin,
        "notes": material.notes,
        "cautions": cautions(material),
        "met": report.met(),
        "temperature": material.climate.as_ref().map(|climate| climate.temperature),
        "shift_factor": material.climate.as_ref().map(|climate| climate.factor),
        "relaxed_modulus": series.relaxed_modulus(),
        "relaxed_modulus_error": of_fit(0).map(|one| one.error),
        "relaxed_modulus_is_extrapolated": of_fit(0).map(Plateau::is_extrapolated),
        "glassy_modulus": series.glassy_modulus(),
        "glassy_modulus_error": of_fit(1).map(|one| one.error),
        "glassy_modulus_is_extrapolated": of_fit(1).map(Plateau::is_extrapolated),
        "steady_viscosity": series.steady_viscosity(),
        "relaxation": series.relaxation_terms().iter().map(|term| json!({ "modulus": term.modulus, "relaxation_time": term.relaxation_time })).collect::<Vec<_>>(),
        "poisson_ratio": material.poisson_ratio,
        "solid": material.isotropic.as_ref().map(|solid| {
            let solid = &solid.at_temperature;
            let moduli = |series: &viscotack::material::Material| {
                let terms = series.relaxation_terms().iter();
                json!({
                    "instantaneous": series.glassy_modulus(),
                    "long_term": series.relaxed_modulus(),
                    "relaxation": terms.map(|term| json!({ "modulus": term.modulus, "relaxation_time": term.relaxation_time })).collect::<Vec<_>>(),
                })
            };
            json!({
                "shear": moduli(solid.shear()),
                "bulk": moduli(solid.bulk()),
                "plane_strain": moduli(solid.plane_strain().as_material()),
                "poisson_ratio": solid.poisson_ratios(),
            })
        }),
        "creep": series.creep_terms().iter().map(|term| json!({ "compliance": term.compliance, "retardation_time": term.retardation_time })).collect::<Vec<_>>(),
    })
}
