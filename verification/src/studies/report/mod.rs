//! The report as files: `report.html`, one self-contained page; a CSV for each table and plot; `summary.json`.

mod format;
mod page;

use super::run::Report;
use super::section::{Cell, Check, CheckResult, Plot, Table};
use serde_json::{Value, json};
use viscotack_program::outcome::csv_table;

/// Name of the page.
pub const PAGE: &str = "report.html";

/// Every file of a report: name and content.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn files(report: &Report) -> Result<Vec<(String, Vec<u8>)>, csv::Error> {
    let mut files = vec![(PAGE.to_owned(), page::page(report).into_bytes())];
    let mut text = format!("{:#}", summary(report));
    text.push('\n');
    // Where it stands the folder may be replaced by another report.
    files.push(("summary.json".to_owned(), text.into_bytes()));
    files.push(("checks.csv".to_owned(), checks(report)?));
    for section in &report.sections {
        for table in &section.tables {
            files.push((table_name(&section.identifier, table), of_table(table)?));
        }
        for plot in &section.plots {
            files.push((plot_name(&section.identifier, plot), of_plot(plot)?));
        }
    }
    Ok(files)
}

fn table_name(section: &str, table: &Table) -> String {
    format!("{section}_{}.csv", table.identifier)
}

fn plot_name(section: &str, plot: &Plot) -> String {
    format!("{section}_{}_plot.csv", plot.identifier)
}

fn of_table(table: &Table) -> Result<Vec<u8>, csv::Error> {
    let headed = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
    let header: Vec<String> = table.columns.iter().map(|column| headed(&column.name, &column.unit)).collect();
    csv_table::records(&header, &table.rows)
}

fn of_plot(plot: &Plot) -> Result<Vec<u8>, csv::Error> {
    let figure = &plot.figure;
    let header = ["curve".to_owned(), format::plain(&figure.horizontal.label), format::plain(&figure.vertical.label)];
    let number = |value: f64| Cell::Number(value.is_finite().then_some(value));
    let rows: Vec<Vec<Cell>> = figure
        .curves
        .iter()
        .flat_map(|curve| curve.points.iter().map(|(x, y)| vec![Cell::Word(format::plain(&curve.label)), number(*x), number(*y)]))
        .collect();
    csv_table::records(&header, &rows)
}

fn checks(report: &Report) -> Result<Vec<u8>, csv::Error> {
    let header = ["section", "result", "check", "expected", "found"].map(str::to_owned);
    let row = |section: &str, check: &Check| {
        [section, check.result.word(), &check.name, &check.expected, &check.found].map(|word| Cell::Word(word.to_owned())).to_vec()
    };
    let rows: Vec<Vec<Cell>> =
        report.sections.iter().flat_map(|section| section.checks.iter().map(|check| row(&section.identifier, check))).collect();
    csv_table::records(&header, &rows)
}

fn summary(report: &Report) -> Value {
    let count = |result: CheckResult| report.count(result);
    let sections: Vec<Value> = report
        .sections
        .iter()
        .map(|section| {
            let [passed, stated, failed] = [CheckResult::Passed, CheckResult::Stated, CheckResult::Failed].map(|result| section.count(result));
            json!({ "section": section.identifier, "title": section.title, "seconds": section.seconds, "passed": passed, "stated": stated, "failed": failed })
        })
        .collect();
    json!({
        "command": "verify",
        "effort": report.extent(),
        "program": report.stamp.program,
        "compiler": report.stamp.compiler,
        "machine": report.stamp.machine,
        "cores": report.stamp.cores,
        "date": report.stamp.date,
        "seconds": report.seconds,
        "passed": count(CheckResult::Passed),
        "stated": count(CheckResult::Stated),
        "failed": count(CheckResult::Failed),
        "sections": sections,
    })
}
