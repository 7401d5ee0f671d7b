//! What a fit says in sentences: what the data cannot separate, and what to measure.

use super::carry_out::Fit;

/// Correlation of two parameters beyond which they are known together only.
const TOGETHER: f64 = 0.97;
/// A half interval of a logarithm beyond which a parameter is hardly known.
const WIDE: f64 = 0.5;

/// A number and its unit.
pub(super) fn quantity(value: f64, unit: &str) -> String {
    if value.abs() <= 0.0 {
        return if unit == "1" { "0".to_owned() } else { format!("0 {unit}") };
    }
    known(value, 0.02 * value.abs(), unit)
}

/// A number to the digits that an uncertainty leaves: two of the uncertainty.
pub(super) fn known(value: f64, uncertainty: f64, unit: &str) -> String {
    let size = value.abs();
    // Of an uncertainty that is none, three digits; of a value below its uncertainty, two.
    let ratio = if uncertainty > 0.0 && uncertainty.is_finite() && size > 0.0 { size / uncertainty } else { 50.0 };
    let digits = (ratio.log10().floor() + 2.0).clamp(2.0, 15.0) as usize;
    let rounded = format!("{value:.*e}", digits - 1);
    let exponent = rounded.rsplit_once('e').and_then(|(_, power)| power.parse::<i32>().ok()).unwrap_or(0);
    let text = if (-4..6).contains(&exponent) { format!("{value:.*}", (digits as i32 - 1 - exponent).max(0) as usize) } else { rounded };
    if unit == "1" { text } else { format!("{text} {unit}") }
}

/// Sentences on what the data cannot separate.
pub(super) fn unseparated(fit: &Fit) -> Vec<String> {
    let (parameters, fitted) = (&fit.setup.parameters, &fit.fitted);
    let mut sentences = Vec::new();
    let logarithmic = |place: usize| parameters.get(place).is_some_and(|parameter| parameter.logarithmic);
    for (place, (parameter, interval)) in parameters.iter().zip(&fitted.by_profile).enumerate() {
        let open = match (interval.lower.is_open(), interval.upper.is_open()) {
            (true, true) => Some("neither from below nor from above"),
            (true, false) => Some("from above only"),
            (false, true) => Some("from below only"),
            (false, false) => None,
        };
        if let Some(open) = open {
            sentences.push(format!("the data bound {} {open}, between the values that are allowed", parameter.name));
        } else if logarithmic(place) && (interval.upper.value() / interval.lower.value()).ln() > 2.0 * WIDE {
            let factor = interval.upper.value() / interval.lower.value();
            sentences.push(format!("the data leave {} open within a factor {factor:.2}", parameter.name));
        }
    }
    for (one, row) in fitted.correlations.iter().enumerate() {
        for (other, &correlation) in row.iter().enumerate().skip(one + 1) {
            if correlation.abs() <= TOGETHER {
                continue;
            }
            let name = |place: usize| parameters.get(place).map_or("", |parameter| parameter.name.as_str());
            let errors =
                (fitted.standard_errors.get(one).copied().unwrap_or(0.0), fitted.standard_errors.get(other).copied().unwrap_or(0.0));
            let what = if logarithmic(one) && logarithmic(other) {
                // Along the long axis of the ellipse both logarithms change in this ratio.
                let power = -correlation.signum() * errors.0 / errors.1;
                let left = errors.0 * 2.0_f64.sqrt() * (1.0 - correlation.abs()).sqrt();
                format!("only {} · {}^{power:.2} is known well (to {:.2} %)", name(one), name(other), 196.0 * left)
            } else {
                "only one combination of both is known well".to_owned()
            };
            let first =
                format!("{} and {} are nearly one parameter in these data (correlation {correlation:.3}): {what}", name(one), name(other));
            sentences.push(format!("{first}; {}", remedy(name(one), name(other), fit)));
        }
    }
    sentences
}

/// What to measure so that two numbers come out one by one.
fn remedy(one: &str, other: &str, fit: &Fit) -> String {
    let either = |part: &str| one.contains(part) || other.contains(part);
    if fit.setup.across {
        return "measure over a wider range, or compare a second column".to_owned();
    }
    let radius = fit.setup.task.compare.iter().any(|word| word == "contact_radius");
    if either("process_zone") {
        "at one rate the work of adhesion and the process zone act as one: add a test at a second rate".to_owned()
    } else if either("offset") || either("drift") {
        "include rows before contact and after its loss, where only offsets and drifts are seen".to_owned()
    } else if either("frame_stiffness") {
        "measure the frame on a stiff sample and give it, or compare the penetration".to_owned()
    } else if !radius {
        "compare the contact radius as well, or add a test at another rate".to_owned()
    } else {
        "add a test at another rate or preload".to_owned()
    }
}
