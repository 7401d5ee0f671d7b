//! A fit as a page for the screen.

use super::Found;
use super::further::Further;
use super::models::Alternative;
use super::words::{known, quantity, unseparated};
use std::fmt::Write;
use viscotack::fit::{End, Interval};

/// The page.
#[must_use]
pub fn screen(found: &Found) -> String {
    let fit = &found.fit;
    let (setup, fitted) = (&fit.setup, &fit.fitted);
    let mut page = String::new();
    let title = setup.title.replace(crate::terminal_text::is_harmful, " ");
    let _ = writeln!(
        page,
        "{title}\nfit of {} numbers to {} data of {} tests, {} evaluations, {:.2} s\n",
        setup.parameters.len(),
        setup.rows(),
        setup.tests.len(),
        fitted.evaluations,
        fit.seconds
    );
    let shown = |interval: &Interval, unit: &str| {
        let half = 0.5 * (interval.upper.value() - interval.lower.value());
        let cell = |end: End| format!("{}{}", if end.is_open() { "open: " } else { "" }, known(end.value(), half, unit));
        format!("{} … {}", cell(interval.lower), cell(interval.upper))
    };
    let rows: Vec<[String; 4]> = setup
        .parameters
        .iter()
        .zip(&setup.roles)
        .enumerate()
        .map(|(place, (parameter, (_, unit)))| {
            let of = |intervals: &[Interval]| intervals.get(place).map_or_else(String::new, |interval| shown(interval, unit));
            let half = fitted.by_profile.get(place).map_or(0.0, |interval| 0.5 * (interval.upper.value() - interval.lower.value()));
            let value = fitted.values.get(place).map_or_else(String::new, |value| known(*value, half, unit));
            [parameter.name.clone(), value, of(&fitted.by_profile), of(&fitted.by_covariance)]
        })
        .collect();
    let head = ["number", "value", "95 % by profile likelihood", "95 % by covariance"].map(str::to_owned);
    table(&mut page, &head, &rows);
    if setup.parameters.len() > 1 {
        let _ = writeln!(page, "\ncorrelations");
        for (one, row) in fitted.correlations.iter().enumerate() {
            for (other, correlation) in row.iter().enumerate().skip(one + 1) {
                let name = |place: usize| setup.parameters.get(place).map_or("", |parameter| parameter.name.as_str());
                let _ = writeln!(page, "  {correlation:+.3}  {} with {}", name(one), name(other));
            }
        }
    }
    let _ = writeln!(page);
    let rows: Vec<[String; 4]> = fit
        .groups
        .iter()
        .zip(&fitted.quality)
        .filter_map(|(group, quality)| {
            let test = setup.tests.get(group.test)?;
            let word = group.column.map_or_else(
                || format!("place of a jump ({})", test.against),
                |column| test.columns.get(column).map_or_else(String::new, |column| column.word.clone()),
            );
            let determination = quality.determination.map_or_else(|| "-".to_owned(), |part| format!("{part:.5}"));
            let runs = quality.runs.map_or_else(|| "-".to_owned(), |runs| format!("{runs:.2}"));
            let scatter = if test.relative {
                format!("{:.2} %", 100.0 * quality.root_mean_square)
            } else {
                format!("{:.3e}", quality.root_mean_square)
            };
            Some([format!("{} of {}", word, test.file), scatter, determination, runs])
        })
        .collect();
    table(&mut page, &["residuals", "root mean square", "determination", "runs test p"].map(str::to_owned), &rows);
    let (same, all) = fitted.reached_by;
    let _ = writeln!(page, "\nstarts     {same} of {all} descents ended in this minimum");
    for other in &fitted.others {
        let values: Vec<String> = setup
            .parameters
            .iter()
            .zip(&setup.roles)
            .zip(&other.values)
            .map(|((parameter, (_, unit)), value)| format!("{} = {}", parameter.name, quantity(*value, unit)))
            .collect();
        let _ = writeln!(page, "           another ended at {} (χ² higher by {:.1e})", values.join(", "), other.rise);
    }
    let moved = fit
        .moved
        .map_or_else(String::new, |moved| format!("; ten times tighter moves no number by more than {moved:.2} of its standard error"));
    let _ = writeln!(page, "accuracy   the model was computed at {:.1e}, as the noise needs{moved}", fit.tolerance);
    let _ = writeln!(page, "criterion  AICc {:.2} (compare with other models of the same data: smaller is better)", fit.akaike);
    for sentence in unseparated(fit) {
        let _ = writeln!(page, "caution    {sentence}");
    }
    for (sentence, useless) in &fit.findings {
        let _ = writeln!(page, "{}    {sentence}", if *useless { "FAILED " } else { "caution" });
    }
    if !found.models.is_empty() {
        of_models(&mut page, &found.models);
    }
    if !found.further.is_empty() {
        of_further(&mut page, fit.setup.parameters.iter().map(|parameter| parameter.name.as_str()).collect(), &found.further);
    }
    page
}

fn of_models(page: &mut String, models: &[Alternative]) {
    let _ = writeln!(page);
    let rows: Vec<[String; 5]> = models
        .iter()
        .map(|model| match &model.fit {
            Ok(fit) => {
                let values: Vec<String> = fit
                    .setup
                    .parameters
                    .iter()
                    .zip(&fit.setup.roles)
                    .zip(&fit.fitted.values)
                    .map(|((parameter, (_, unit)), value)| format!("{} = {}", parameter.name, quantity(*value, unit)))
                    .collect();
                let rise = model.rise(models).map_or_else(String::new, |rise| format!("{rise:.1}"));
                let word = if model.is_excluded(models) { "excluded by these data" } else { "possible" };
                let cost = format!("{} models in {:.2} s", fit.fitted.evaluations, fit.seconds);
                [model.name.to_owned(), rise, word.to_owned(), cost, values.join(", ")]
            }
            Err(reason) => [model.name.to_owned(), "-".to_owned(), "no fit".to_owned(), "-".to_owned(), reason.clone()],
        })
        .collect();
    table(page, &["model", "AICc above best", "these data", "cost of the fit", "numbers"].map(str::to_owned), &rows);
    for model in models {
        for sentence in &model.fails {
            let _ = writeln!(page, "where it fails: {}: {sentence}", model.name);
        }
    }
}

fn of_further(page: &mut String, names: Vec<&str>, tests: &[Further]) {
    let _ = writeln!(page, "\nfurther tests, best first: 95 % intervals with it over those without it ({})", names.join(", "));
    for test in tests {
        match &test.shrinkage {
            Ok(parts) => {
                let parts: Vec<String> = parts.iter().map(|part| format!("{part:.2}")).collect();
                let _ = writeln!(page, "  {:<40} {}", test.name, parts.join("  "));
            }
            Err(reason) => {
                let _ = writeln!(page, "  {:<40} cannot be made: {reason}", test.name);
            }
        }
    }
}

fn table<const N: usize>(page: &mut String, head: &[String; N], rows: &[[String; N]]) {
    let width = |column: usize| {
        std::iter::once(head).chain(rows).filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..N).map(width).collect();
    for row in std::iter::once(head).chain(rows) {
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell}{}", " ".repeat(width - cell.chars().count()))).collect();
        let _ = writeln!(page, "{}", cells.join("  ").trim_end());
    }
}
