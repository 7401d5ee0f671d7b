//! The shipped scenes with [fit]: what they find beside the truth that their data were made from, and how long it takes.

use super::super::cells::{count, number, word};
use super::super::{Check, Column, Table};
use viscotack_program::plan::fit::{Fit, Setup, carry_out};
use viscotack_program::scene::diagnostic::SourceText;
use viscotack_program::scene::document::Document;

/// A shipped fit: its name, scene and data, and the truth of `scenes/fits/make_data.py`: work of adhesion (J/m²) and frame stiffness (N/m).
struct Shipped {
    name: &'static str,
    scene: &'static str,
    data: &'static str,
    truth: [f64; 2],
}

const SHIPPED: [Shipped; 2] = [
    Shipped {
        name: "pull_off",
        scene: include_str!("../../../../scenes/fits/pull_off.toml"),
        data: include_str!("../../../../scenes/fits/pull_off.csv"),
        truth: [0.055, 180.0],
    },
    Shipped {
        name: "twelve_terms",
        scene: include_str!("../../../../scenes/fits/twelve_terms.toml"),
        data: include_str!("../../../../scenes/fits/twelve_terms.csv"),
        truth: [0.08, 250.0],
    },
];

fn made(shipped: &Shipped) -> Result<Fit, String> {
    let file = format!("{}.toml", shipped.name);
    let mut document = Document::parse(&file, shipped.scene.to_owned(), std::path::Path::new(".")).map_err(|error| error.to_string())?;
    let data = format!("{}.csv", shipped.name);
    document.attach(&data, SourceText::new(&data, shipped.data.to_owned()));
    let setup = Setup::new(&mut document).map_err(|error| error.to_string())?;
    carry_out(setup).map_err(|refusal| refusal.to_string())
}

/// A row for each of them, and whether each truth lies within twice its 95 % interval.
pub(super) fn table() -> (Table, Check) {
    let columns = vec![
        Column::words("scene"),
        Column::new("models solved", "1"),
        Column::new("time beside others", "s"),
        Column::new("work of adhesion", "J/m²"),
        Column::new("its truth", "J/m²"),
        Column::new("frame stiffness", "N/m"),
        Column::new("its truth", "N/m"),
    ];
    let mut table = Table::new("shipped_fits", "Fits of the shipped curves of 500 rows with 1 % noise", columns);
    let mut missed = Vec::new();
    for shipped in &SHIPPED {
        let fit = match made(shipped) {
            Ok(fit) => fit,
            Err(reason) => {
                missed.push(format!("{}: {reason}", shipped.name));
                continue;
            }
        };
        let found = fit.fitted();
        let mut row = vec![word(shipped.name), count(found.evaluations), number(fit.seconds())];
        for ((value, interval), truth) in found.values.iter().zip(&found.by_profile).zip(shipped.truth) {
            row.extend([number(*value), number(truth)]);
            let width = interval.upper.value() - interval.lower.value();
            if (value - truth).abs() > width {
                missed.push(format!("{}: {value} in place of {truth}", shipped.name));
            }
        }
        table.rows.push(row);
    }
    let check = Check::new("the shipped fits find their truth within twice the interval", "both", missed.join("; "), missed.is_empty());
    (table, check)
}
