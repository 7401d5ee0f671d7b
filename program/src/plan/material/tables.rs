//! The tables of a material: curves against frequency and time, terms, and the data beside the fit.

use super::{MaterialReport, shifts};
use crate::outcome::csv_table::plain;
use crate::scene::typed::{MaterialOrigin, MeasuredSort, Units};
use viscotack::estimate::Estimate;
use viscotack::material::fit::Quantity;

/// All tables, by file name.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn tables(report: &MaterialReport) -> Result<Vec<(String, Vec<u8>)>, csv::Error> {
    let si = report.units == Units::Si;
    let unit = |of_si: &'static str, reduced: &'static str| if si { of_si } else { reduced };
    let (pressure, time, frequency, compliance) =
        (unit("Pa", "E0"), unit("s", "reference time"), unit("rad/s", "1/reference time"), unit("1/Pa", "1/E0"));
    let pair = |estimate: Option<Estimate>| [estimate.map(|estimate| estimate.value), estimate.map(|estimate| estimate.error)];
    let moduli: Vec<Vec<Option<f64>>> = report
        .frequencies()
        .into_iter()
        .map(|at| {
            let (storage, loss) = (report.value(Quantity::Storage, at), report.value(Quantity::Loss, at));
            let tangent = storage.zip(loss).map(|(storage, loss)| loss.value / storage.value);
            let mut row = vec![Some(at)];
            row.extend(pair(storage).into_iter().chain(pair(loss)));
            row.push(tangent);
            row
        })
        .collect();
    let responses: Vec<Vec<Option<f64>>> = report
        .times()
        .into_iter()
        .map(|at| {
            let mut row = vec![Some(at)];
            row.extend(pair(report.value(Quantity::Creep, at)).into_iter().chain(pair(report.value(Quantity::Relaxation, at))));
            row
        })
        .collect();
    let series = &report.material.series;
    let (relaxation, creep) = (series.relaxation_terms(), series.creep_terms());
    let terms: Vec<Vec<Option<f64>>> = (0..relaxation.len().max(creep.len()))
        .map(|index| {
            let (relaxing, creeping) = (relaxation.get(index), creep.get(index));
            vec![
                relaxing.map(|term| term.modulus),
                relaxing.map(|term| term.relaxation_time),
                creeping.map(|term| term.compliance),
                creeping.map(|term| term.retardation_time),
            ]
        })
        .collect();
    let mut tables = vec![
        (
            "moduli.csv".to_owned(),
            plain(
                &[
                    ("angular_frequency", frequency),
                    ("storage_modulus", pressure),
                    ("storage_modulus_error", pressure),
                    ("loss_modulus", pressure),
                    ("loss_modulus_error", pressure),
                    ("loss_tangent", "1"),
                ],
                &moduli,
            )?,
        ),
        (
            "responses.csv".to_owned(),
            plain(
                &[
                    ("time", time),
                    ("creep_compliance", compliance),
                    ("creep_compliance_error", compliance),
                    ("relaxation_modulus", pressure),
                    ("relaxation_modulus_error", pressure),
                ],
                &responses,
            )?,
        ),
        (
            "terms.csv".to_owned(),
            plain(&[("modulus", pressure), ("relaxation_time", time), ("compliance", compliance), ("retardation_time", time)], &terms)?,
        ),
    ];
    if let MaterialOrigin::Data(fitted) = &report.material.origin {
        let factor = report.factor();
        let rows: Vec<Vec<Option<f64>>> = fitted
            .data
            .rows
            .iter()
            .map(|row| {
                let at = if fitted.data.sort == MeasuredSort::Moduli { row.at / factor } else { row.at * factor };
                let fit = |quantity| report.value(quantity, at).map(|estimate| estimate.value);
                let mut cells = vec![row.temperature, Some(at), Some(row.value)];
                match fitted.data.sort {
                    MeasuredSort::Moduli => cells.extend([fit(Quantity::Storage), row.loss, fit(Quantity::Loss)]),
                    MeasuredSort::Relaxation => cells.push(fit(Quantity::Relaxation)),
                    MeasuredSort::Creep => cells.push(fit(Quantity::Creep)),
                }
                cells
            })
            .collect();
        let header: &[(&str, &str)] = match fitted.data.sort {
            MeasuredSort::Moduli => &[
                ("measured_at_temperature", "K"),
                ("reduced_angular_frequency", "rad/s"),
                ("storage_modulus", "Pa"),
                ("storage_modulus_fit", "Pa"),
                ("loss_modulus", "Pa"),
                ("loss_modulus_fit", "Pa"),
            ],
            MeasuredSort::Relaxation => {
                &[("measured_at_temperature", "K"), ("reduced_time", "s"), ("relaxation_modulus", "Pa"), ("relaxation_modulus_fit", "Pa")]
            }
            MeasuredSort::Creep => {
                &[("measured_at_temperature", "K"), ("reduced_time", "s"), ("creep_compliance", "1/Pa"), ("creep_compliance_fit", "1/Pa")]
            }
        };
        tables.push(("data.csv".to_owned(), plain(header, &rows)?));
        if let Some(superposition) = &fitted.superposition {
            tables.push(("shift_factors.csv".to_owned(), plain(shifts::HEADER, &shifts::rows(superposition))?));
        }
    }
    Ok(tables)
}
