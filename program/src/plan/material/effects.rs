//! What a scene's plan says of its material.

use crate::outcome::{Assessment, Effect, Validity};
use crate::scene::typed::{MaterialOrigin, SceneMaterial};

/// The material's effects: where its terms come from, and its temperature.
pub(in crate::plan) fn effects(material: &SceneMaterial) -> Vec<Effect> {
    let mut effects = Vec::new();
    match &material.origin {
        MaterialOrigin::Terms => {}
        MaterialOrigin::Deck(deck) => effects.push(Effect {
            name: "material from a deck",
            on: true,
            why: format!(
                "{} relaxation terms of Young's modulus from the {} deck {:?}",
                material.series.relaxation_terms().len(),
                deck.program,
                deck.file
            ),
        }),
        MaterialOrigin::Data(fitted) => effects.push(Effect {
            name: "material from data",
            on: true,
            why: format!(
                "{} terms fitted to {} numbers of {:?} within {:.1e} (root mean square)",
                material.series.relaxation_terms().len(),
                fitted.fit.observations,
                fitted.data.file,
                fitted.fit.rms_error
            ),
        }),
        MaterialOrigin::Law(law) => effects.push(Effect {
            name: "material from a law",
            on: true,
            why: format!(
                "{}: {} terms follow its complex modulus within {:.1e} from {:.1e} to {:.1e} rad/s",
                law.name,
                material.series.relaxation_terms().len(),
                law.expansion.error,
                law.range[0],
                law.range[1]
            ),
        }),
    }
    if let MaterialOrigin::Data(_) = material.origin {
        let draws = material.draws.as_ref().map(|draws| draws.len());
        effects.push(Effect {
            name: "error of the material",
            on: draws.is_some(),
            why: draws.map_or_else(
                || "material.uncertainty is not \"propagate\": errors are those of the numbers alone".into(),
                |draws| format!("material.uncertainty = \"propagate\": {draws} draws of the fit"),
            ),
        });
    }
    if let Some(solid) = &material.isotropic {
        let [glassy, relaxed] = solid.at_temperature.poisson_ratios();
        effects.push(Effect {
            name: "bulk modulus",
            on: true,
            why: format!(
                "Young's and the plane modulus are the exact series of 9KG/(3K + G) and 4G(3K + G)/(3K + 4G); Poisson's ratio goes from {glassy:.4} at once to {relaxed:.4} in the end"
            ),
        });
    }
    if let Some(climate) = &material.climate {
        effects.push(Effect {
            name: "temperature",
            on: true,
            why: format!(
                "at {:.2} K every time is multiplied by a_T = {:.4e}; reference {:.2} K",
                climate.temperature, climate.factor, climate.reference
            ),
        });
    }
    effects
}

/// What may be wrong with the material.
pub(in crate::plan) fn validity(material: &SceneMaterial, visited: Option<[f64; 2]>) -> Vec<Validity> {
    let caution =
        |name: &str, value: Option<f64>, meaning: String| Validity { name: name.into(), value, assessment: Assessment::Caution, meaning };
    let mut entries: Vec<Validity> = material
        .notes
        .iter()
        .map(|note| Validity { name: "reading of a table".into(), value: None, assessment: Assessment::Good, meaning: note.clone() })
        .collect();
    entries.extend(material.cautions.iter().map(|text| caution("material", None, text.clone())));
    entries.extend(match &material.origin {
        MaterialOrigin::Terms => Vec::new(),
        MaterialOrigin::Deck(deck) => deck
            .notes
            .iter()
            .map(|note| Validity { name: "deck of the material".into(), value: None, assessment: Assessment::NotAssessed, meaning: note.clone() })
            .collect(),
        MaterialOrigin::Data(fitted) => {
            let mut entries = vec![Validity {
                name: "fit of the material".into(),
                value: Some(fitted.fit.rms_error),
                assessment: if fitted.warnings.is_empty() { Assessment::Good } else { Assessment::Caution },
                meaning: "relative misfit of the series to its data (root mean square)".into(),
            }];
            entries.extend(fitted.warnings.iter().map(|warning| caution("material data", None, warning.clone())));
            entries
        }
        MaterialOrigin::Law(law) => {
            let mut entries = vec![Validity {
                name: "expansion of the material".into(),
                value: Some(law.expansion.error),
                assessment: if law.expansion.met { Assessment::Good } else { Assessment::Caution },
                meaning: format!("largest relative error of the complex modulus; wanted {:.0e}", law.accuracy),
            }];
            // The temperature moves the range with the material; an open end is kept by both limits of the law.
            let factor = material.climate.as_ref().map_or(1.0, |climate| climate.factor);
            let [fastest, slowest] = [factor / law.range[1], factor / law.range[0]];
            if let Some([from, to]) = visited.filter(|[from, to]| (*from > 0.0 && *from < fastest) || (to.is_finite() && *to > slowest)) {
                entries.push(caution(
                    "range of the expansion",
                    None,
                    format!(
                        "times from {from:.1e} to {to:.1e} are visited, and the law is expanded from {fastest:.1e} to {slowest:.1e}: widen material.expansion"
                    ),
                ));
            }
            entries
        }
    });
    entries
}
