//! Shift factors that were found from data, and whether a fit is a solid or a liquid, on the screen, as JSON and as a table.

use serde_json::{Value, json};
use std::f64::consts::LN_10;
use std::fmt::Write as _;
use viscotack::material::fit::superposition::Superposition;
use viscotack::material::fit::{LawFit, SeriesFit};

/// The columns of `shift_factors.csv`.
pub(super) const HEADER: &[(&str, &str)] = &[
    ("temperature", "K"),
    ("factor", "1"),
    ("log10_factor", "1"),
    ("log10_factor_error", "1"),
    ("vertical_factor", "1"),
    ("vertical_factor_error", "1"),
];

/// Its rows; errors are two standard deviations.
pub(super) fn rows(superposition: &Superposition) -> Vec<Vec<Option<f64>>> {
    let vertical = has_vertical(superposition);
    superposition
        .shifts
        .iter()
        .map(|shift| {
            let factor = shift.vertical.exp();
            vec![
                Some(shift.temperature),
                Some(shift.logarithm.exp()),
                Some(shift.logarithm / LN_10),
                Some(shift.error / LN_10),
                vertical.then_some(factor),
                vertical.then_some(factor * shift.vertical_error),
            ]
        })
        .collect()
}

fn has_vertical(superposition: &Superposition) -> bool {
    superposition.shifts.iter().any(|shift| shift.vertical_error > 0.0)
}

/// Whether the material is a solid or a liquid, and what that rests on.
pub(super) fn at_rest(fit: &SeriesFit) -> String {
    let rest = &fit.rest;
    let (kind, other, off) = if rest.liquid {
        ("liquid (relaxed modulus 0)", "solid", rest.solid_rms_error)
    } else {
        ("solid", "liquid", rest.liquid_rms_error)
    };
    match off {
        Some(off) if rest.decided() => format!("{kind}: the best {other} that was found follows the data within {off:.2e}"),
        Some(off) => format!("{kind}, but the data do not decide: the best {other} that was found follows them within {off:.2e}"),
        None => format!("{kind}: no fit that was tried came out as a {other}"),
    }
}

/// The factors as text.
pub(super) fn screen(superposition: &Superposition) -> String {
    let mut text = String::new();
    let vertical = has_vertical(superposition);
    let base = superposition.shifts.get(superposition.base).map_or(superposition.reference, |shift| shift.temperature);
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "shifts     found from the data; reference temperature {:.2} K; errors (two standard deviations) are relative to the data at {base:.2} K",
        superposition.reference
    );
    let _ = writeln!(
        text,
        "  {:>15}  {:>10}  {:>20}{}",
        "temperature [K]",
        "a_T",
        "log10 a_T",
        if vertical { "                   b_T" } else { "" }
    );
    for shift in &superposition.shifts {
        let _ = write!(
            text,
            "  {:>15.2}  {:>10.3e}  {:>9.4} ± {:<8.4}",
            shift.temperature,
            shift.logarithm.exp(),
            shift.logarithm / LN_10,
            shift.error / LN_10
        );
        if vertical {
            let factor = shift.vertical.exp();
            let _ = write!(text, "  {factor:>9.4} ± {:<8.4}", factor * shift.vertical_error);
        }
        text.push('\n');
    }
    if let Some(law) = &superposition.williams_landel_ferry {
        let ([c1, c2], [e1, e2]) = (law.constants, law.errors);
        let _ = writeln!(
            text,
            "WLF        c1 = {c1:.4} ± {e1:.2}, c2 = ({c2:.2} ± {e2:.1}) K at {:.2} K: {}",
            law.reference,
            follows(law.follows(), law.largest_decades)
        );
    } else {
        let _ = writeln!(text, "WLF        the factors do not fix both constants");
    }
    if let Some(law) = &superposition.arrhenius {
        let ([energy], [error]) = (law.constants, law.errors);
        let _ = writeln!(
            text,
            "Arrhenius  E_a = ({:.3} ± {:.2}) kJ/mol: {}",
            energy / 1e3,
            error / 1e3,
            follows(law.follows(), law.largest_decades)
        );
    }
    let holds = match superposition.holds() {
        Some(true) => "holds",
        Some(false) => "does NOT hold",
        None => "was not tested",
    };
    let alone = superposition
        .alone
        .map_or_else(|| "isotherms too short for curves of their own".to_owned(), |alone| format!("isotherms by themselves {alone:.2e}"));
    let _ = writeln!(text, "superposition {holds}: scatter about one curve {:.2e}, {alone}", superposition.together);
    text
}

fn follows(follows: Option<bool>, decades: f64) -> String {
    let words = match follows {
        Some(true) => "follows the factors within their errors",
        Some(false) => "does not follow the factors within their errors",
        None => "as many constants as factors, so nothing is tested",
    };
    format!("{words} (largest difference {decades:.3} decades)")
}

/// The factors as JSON.
pub(super) fn summary(superposition: &Superposition) -> Value {
    json!({
        "reference_temperature": superposition.reference,
        "errors_relative_to": superposition.shifts.get(superposition.base).map(|shift| shift.temperature),
        "factors": superposition.shifts.iter().map(|shift| json!({
            "temperature": shift.temperature,
            "factor": shift.logarithm.exp(),
            "log10_factor": shift.logarithm / LN_10,
            "log10_factor_error": shift.error / LN_10,
            "vertical_factor": shift.vertical.exp(),
            "vertical_factor_error": shift.vertical.exp() * shift.vertical_error,
        })).collect::<Vec<_>>(),
        "wlf": superposition.williams_landel_ferry.as_ref().map(|law| law_of(law, &["c1", "c2"])),
        "arrhenius": superposition.arrhenius.as_ref().map(|law| law_of(law, &["activation_energy"])),
        "superposition_holds": superposition.holds(),
        "scatter_together": superposition.together,
        "scatter_alone": superposition.alone,
    })
}

fn law_of<const N: usize>(law: &LawFit<N>, names: &[&str; N]) -> Value {
    let mut value = json!({
        "reference_temperature": law.reference,
        "follows": law.follows(),
        "largest_decades": law.largest_decades,
    });
    if let Value::Object(members) = &mut value {
        for ((name, constant), error) in names.iter().zip(law.constants).zip(law.errors) {
            members.insert((*name).to_owned(), json!(constant));
            members.insert(format!("{name}_error"), json!(error));
        }
    }
    value
}
