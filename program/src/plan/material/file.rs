//! The material as a TOML file that scenes include by `material.file`.

use super::MaterialReport;
use super::screen::cautions;
use crate::scene::typed::{MaterialOrigin, Units};
use std::fmt::Write as _;
use viscotack::material::shift::ShiftFactors;
use viscotack::material::{GivenSeries, Material};

/// The text of the file: terms at the reference temperature, every digit of them.
#[must_use]
pub fn material_file(report: &MaterialReport) -> String {
    let material = &report.material;
    let series = material.climate.as_ref().map_or(&material.series, |climate| &climate.at_reference);
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = match &material.origin {
        MaterialOrigin::Terms => writeln!(text, "# Terms as given."),
        MaterialOrigin::Deck(deck) => {
            writeln!(text, "# From the {} deck {:?} by viscotack {}.", deck.program, deck.file, crate::VERSION)
        }
        MaterialOrigin::Data(fitted) => writeln!(
            text,
            "# Fitted to {:?} by viscotack {}: {} numbers followed within {:.2e} (root mean square), {:.2e} (largest).",
            fitted.data.file,
            crate::VERSION,
            fitted.fit.observations,
            fitted.fit.rms_error,
            fitted.fit.largest_error
        ),
        MaterialOrigin::Law(law) => writeln!(
            text,
            "# Expansion of a {} by viscotack {}: complex modulus within {:.2e} from {:e} to {:e} rad/s.",
            law.name,
            crate::VERSION,
            law.expansion.error,
            law.range[0],
            law.range[1]
        ),
    };
    for note in &material.notes {
        let _ = writeln!(text, "# Note: {note}.");
    }
    if let MaterialOrigin::Deck(deck) = &material.origin {
        for note in &deck.notes {
            let _ = writeln!(text, "# Note: {note}.");
        }
    }
    let units = if report.units == Units::Reduced { "reduced, for scenes with units = \"reduced\"" } else { "SI" };
    let _ = writeln!(text, "# Units: {units}.\n[material]");
    if let Some(name) = &material.name {
        let _ = writeln!(text, "name = {}", crate::scene::document::toml_text(name));
    }
    let cautions = cautions(material);
    if !cautions.is_empty() {
        // A scene that includes this file shows them.
        let _ = writeln!(text, "cautions = [");
        for caution in cautions {
            let _ = writeln!(text, "  {},", crate::scene::document::toml_text(caution));
        }
        let _ = writeln!(text, "]");
    }
    if let Some(ratio) = material.poisson_ratio {
        let _ = writeln!(text, "poisson_ratio = {ratio:?}");
    }
    if let Some(climate) = &material.climate {
        let _ = writeln!(text, "reference_temperature = {:?}", climate.reference);
        let _ = match &climate.shift {
            ShiftFactors::WilliamsLandelFerry { c1, c2, .. } => writeln!(text, "shift = {{ wlf = {{ c1 = {c1:?}, c2 = {c2:?} }} }}"),
            ShiftFactors::Arrhenius { activation_energy, .. } => {
                writeln!(text, "shift = {{ arrhenius = {{ activation_energy = {activation_energy:?} }} }}")
            }
            ShiftFactors::Table(points) => {
                let items: Vec<String> =
                    points.iter().map(|(kelvin, factor)| format!("  {{ temperature = {kelvin:?}, factor = {factor:?} }},\n")).collect();
                writeln!(text, "shift = {{ factors = [\n{}] }}", items.concat())
            }
        };
    }
    if let Some(solid) = &material.isotropic {
        let solid = &solid.at_reference;
        let relaxes = !solid.shear().is_elastic() || !solid.bulk().is_elastic();
        if relaxes {
            let _ = writeln!(text, "moduli = \"long_term\"");
        }
        for (name, series) in [("shear", solid.shear()), ("bulk", solid.bulk())] {
            let _ = writeln!(text, "{name}_modulus = {:?}", series.relaxed_modulus());
            relaxation(&mut text, &format!("{name}_relaxation"), series);
        }
    } else if series.given() == GivenSeries::Creep {
        let _ = writeln!(text, "glassy_modulus = {:?}", series.glassy_modulus());
        if let Some(viscosity) = series.steady_viscosity() {
            let _ = writeln!(text, "viscosity = {viscosity:?}");
        }
        if !series.creep_terms().is_empty() {
            let _ = writeln!(text, "creep = [");
            for term in series.creep_terms() {
                let _ = writeln!(text, "  {{ compliance = {:?}, retardation_time = {:?} }},", term.compliance, term.retardation_time);
            }
            let _ = writeln!(text, "]");
        }
    } else {
        let _ = writeln!(text, "relaxed_modulus = {:?}", series.relaxed_modulus());
        relaxation(&mut text, "relaxation", series);
    }
    text
}

/// The relaxation terms under a key, if there are any.
fn relaxation(text: &mut String, key: &str, series: &Material) {
    if series.relaxation_terms().is_empty() {
        return;
    }
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{key} = [");
    for term in series.relaxation_terms() {
        let _ = writeln!(text, "  {{ modulus = {:?}, relaxation_time = {:?} }},", term.modulus, term.relaxation_time);
    }
    let _ = writeln!(text, "]");
}
