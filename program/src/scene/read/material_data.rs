//! From a measured table to a series: shifted to one temperature, fitted, checked.

use super::material_shift::{superposed, unfixed};
use super::material_source::Shift;
use super::material_table::material_data;
use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::{FittedData, MaterialData, MaterialOrigin, MeasuredRow, MeasuredSort, Overlap};
use std::sync::Arc;
use viscotack::material::fit::consistency::{check, widest_gap};
use viscotack::material::fit::overlap::{LogCurve, mismatch};
use viscotack::material::fit::{Observation, Plateau, Quantity, Wanted, complex_modulus, fit};
use viscotack::material::shift::ShiftFactors;

/// Curves of neighbouring temperatures that differ by more than this where they meet do not lie on each other.
const OVERLAP: f64 = 0.1;

/// The series of `material.data`.
pub(super) fn from_data(
    table: &Section<'_>,
    document: &Document,
    poisson_ratio: Option<f64>,
    shift: &Shift,
    reference: Option<f64>,
) -> Result<MaterialOrigin, SceneError> {
    let wanted = table.number("fit_error")?.map_or(Wanted::Scatter, Wanted::Error);
    table.taken("columns");
    let columns = table.node().get("columns").map_or("", |node| node.written());
    let tolerance = table.number("temperature_tolerance")?;
    let words = format!("{:?} {columns} {wanted:?} {poisson_ratio:?} {shift:?} {reference:?} {tolerance:?}", table.text("data"));
    document.materials().get(&words, || {
        let mut data = material_data(table, document, poisson_ratio)?;
        let refused = |refusal| table.wrong("data", format!("no series can be fitted to the data: {refusal}"), "this file");
        let (overlap, superposition) = match shift {
            Shift::Automatic { vertical } => {
                let (overlap, superposition) = superposed(table, &mut data, tolerance, reference, *vertical, wanted)?;
                (Some(overlap), Some(superposition))
            }
            Shift::Given(factors) => (shifted(table, &mut data, Some(factors), reference)?, None),
            Shift::None => (shifted(table, &mut data, None, reference)?, None),
        };
        let observations = observations(&data.rows, data.sort);
        let fit = match &superposition {
            Some(superposition) => superposition.fit.clone(),
            None => fit(&observations, wanted).map_err(refused)?,
        };
        let consistency = check(&observations);
        let plateaus = fit.plateaus(&observations);
        let mut warnings = warnings(&data, &observations, wanted, &fit, consistency.as_ref(), overlap.as_ref());
        warnings.extend(extrapolated(&plateaus, data.sort));
        let mut fitted = FittedData { data, fit, plateaus, consistency, overlap, superposition, warnings };
        unfixed(table, &mut fitted)?;
        Ok(MaterialOrigin::Data(Arc::new(fitted)))
    })
}

/// Temperatures no further apart (K) are one isotherm.
pub(super) const TEMPERATURE_TOLERANCE: f64 = 1.0;

/// The temperatures (K) of a table, rising. An instrument that holds a temperature lets it wander: rows whose temperatures follow each other closely, and as a whole lie
/// within twice the tolerance, get their mean.
pub(super) fn isotherms(data: &mut MaterialData, tolerance: f64, then: &str) -> Vec<f64> {
    let mut every: Vec<f64> = data.rows.iter().filter_map(|row| row.temperature).collect();
    every.sort_by(f64::total_cmp);
    let mut means = Vec::new();
    let (mut wandering, mut widest) = (0, 0.0_f64);
    for run in every.chunk_by(|low, high| high - low <= tolerance) {
        let [low, .., high] = *run else {
            means.extend_from_slice(run);
            continue;
        };
        if high - low > 2.0 * tolerance {
            // A temperature that was swept.
            means.extend(run.iter().copied());
            continue;
        }
        let mean = if low < high { run.iter().sum::<f64>() / run.len() as f64 } else { low };
        for row in &mut data.rows {
            row.temperature = row.temperature.map(|own| if (low..=high).contains(&own) { mean } else { own });
        }
        means.push(mean);
        if low < high {
            wandering += 1;
            widest = widest.max(high - low);
        }
    }
    if wandering > 0 {
        data.warnings.push(format!(
            "{wandering} temperatures wander by up to {widest:.2} K: rows within {tolerance} K of each other are one isotherm; {then}"
        ));
    }
    means.dedup();
    means
}

/// Brings all rows to the reference temperature; gives how well the curves of the temperatures meet.
fn shifted(
    table: &Section<'_>,
    data: &mut MaterialData,
    shift: Option<&ShiftFactors>,
    reference: Option<f64>,
) -> Result<Option<Overlap>, SceneError> {
    let stated = table.number("temperature_tolerance")?;
    let tolerance = stated.unwrap_or(TEMPERATURE_TOLERANCE);
    let own: Vec<Option<f64>> = data.rows.iter().map(|row| row.temperature).collect();
    let temperatures = isotherms(data, tolerance, "each row is shifted from its own temperature");
    if stated.is_some() && temperatures.is_empty() {
        let message = "`material.temperature_tolerance` has no effect on a table without temperatures";
        return Err(table.wrong("temperature_tolerance", message, "leave it out"));
    }
    let Some(shift) = shift else {
        if let [only] = temperatures.as_slice()
            && let Some(reference) = reference
            && (only - reference).abs() > 0.5
        {
            let message = format!("the data were measured at {only:.2} K, and `material.reference_temperature` is {reference:.2} K");
            return Err(table.wrong("reference_temperature", message, "give material.shift to go from one to the other"));
        }
        if temperatures.len() > 1 {
            let message = format!("the data were measured at {} temperatures", temperatures.len());
            return Err(table
                .wrong("data", message, "this file")
                .help("write shift = \"automatic\" into [material], or add --set material.shift=automatic to the command, to find the shift factors from the data; or give material.shift and material.reference_temperature"));
        }
        return Ok(None);
    };
    for (row, own) in data.rows.iter_mut().zip(own) {
        let Some(temperature) = own else { continue };
        let factor = shift.factor(shift.held_within(temperature, tolerance)).map_err(|refusal| {
            table.wrong("shift", format!("no shift factor for {temperature:.2} K, a temperature of the data: {refusal}"), "this shift")
        })?;
        row.at *= if data.sort == MeasuredSort::Moduli { factor } else { 1.0 / factor };
    }
    Ok((temperatures.len() > 1).then(|| overlap(data, &temperatures)))
}

/// How well the shifted curves of neighbouring temperatures lie on each other.
pub(super) fn overlap(data: &MaterialData, temperatures: &[f64]) -> Overlap {
    let curve = |temperature: f64, value: &dyn Fn(&crate::scene::typed::MeasuredRow) -> Option<f64>| -> LogCurve {
        let mut points: LogCurve = data
            .rows
            .iter()
            .filter(|row| row.temperature == Some(temperature))
            .filter_map(|row| Some((row.at.ln(), value(row).filter(|value| *value > 0.0)?.ln())))
            .collect();
        points.sort_by(|left, right| left.0.total_cmp(&right.0));
        points
    };
    let (mut meeting, mut worst) = (0, 0.0_f64);
    for pair in temperatures.windows(2) {
        let of =
            |value: &dyn Fn(&crate::scene::typed::MeasuredRow) -> Option<f64>| mismatch(&curve(pair[0], value), &curve(pair[1], value));
        let differences: Vec<f64> = of(&|row| Some(row.value)).into_iter().chain(of(&|row| row.loss)).collect();
        meeting += usize::from(!differences.is_empty());
        worst = differences.into_iter().fold(worst, f64::max);
    }
    Overlap { temperatures: temperatures.len(), meeting, worst }
}

/// Rows as observations, each relative to itself, in the order of frequency or time.
pub(super) fn observations(rows: &[MeasuredRow], sort: MeasuredSort) -> Vec<Observation> {
    let mut rows: Vec<_> = rows.iter().collect();
    rows.sort_by(|left, right| left.at.total_cmp(&right.at));
    rows.into_iter()
        .flat_map(|row| {
            let one = |quantity| vec![Observation { quantity, at: row.at, value: row.value, scale: row.value }];
            match (sort, row.loss) {
                (MeasuredSort::Moduli, Some(loss)) => complex_modulus(row.at, row.value, loss).to_vec(),
                (MeasuredSort::Moduli, None) => one(Quantity::Storage),
                (MeasuredSort::Relaxation, _) => one(Quantity::Relaxation),
                (MeasuredSort::Creep, _) => one(Quantity::Creep),
            }
        })
        .collect()
}

/// An extrapolated modulus whose stated error is above this part of it is uncertain enough for a caution.
const UNCERTAIN: f64 = 0.1;

/// Moduli at the ends of the spectrum that the data hardly fix.
fn extrapolated(plateaus: &[Plateau; 2], sort: MeasuredSort) -> Vec<String> {
    let uncertain = |one: &&Plateau| one.modulus > 0.0 && one.is_extrapolated() && one.error > UNCERTAIN * one.modulus;
    let words = [("relaxed modulus E0", "below", "longer"), ("glassy modulus E∞", "above", "shorter")];
    words
        .iter()
        .zip(plateaus)
        .filter(|(_, one)| uncertain(one))
        .map(|((name, beyond, times), one)| {
            let place = if sort == MeasuredSort::Moduli {
                format!("{beyond} {:.3e} Hz", one.last / std::f64::consts::TAU)
            } else {
                format!("at times {times} than {:.3e} s", 1.0 / one.last)
            };
            format!(
                "the {name} = ({:.2e} ± {:.0e}) Pa is extrapolated {place}, where the fit has {:.2e} Pa: results that depend on it are as uncertain",
                one.modulus, one.error, one.at_last
            )
        })
        .collect()
}

fn warnings(
    data: &MaterialData,
    observations: &[Observation],
    wanted: Wanted,
    fit: &viscotack::material::fit::SeriesFit,
    consistency: Option<&viscotack::material::fit::consistency::Consistency>,
    overlap: Option<&Overlap>,
) -> Vec<String> {
    let mut odd = data.warnings.clone();
    if let Some([from, to]) = widest_gap(observations) {
        let unit = if data.sort == MeasuredSort::Moduli { "rad/s" } else { "s" };
        odd.push(format!("the data leave a gap from {from:.2e} to {to:.2e} {unit}: the fit there is interpolation"));
    }
    if let Some(overlap) = overlap {
        if overlap.meeting + 1 < overlap.temperatures {
            odd.push(format!(
                "{} of {} neighbouring temperatures do not meet after the shift",
                overlap.temperatures - 1 - overlap.meeting,
                overlap.temperatures - 1
            ));
        }
        if overlap.worst > OVERLAP {
            odd.push(format!(
                "curves of neighbouring temperatures differ by {:.0} % where they meet: the shift factors do not fit the data",
                100.0 * overlap.worst
            ));
        }
    }
    if let Some(consistency) = consistency.filter(|consistency| !consistency.holds()) {
        odd.push(format!(
            "E′ and E″ do not belong together (Kramers and Kronig): a passive solid follows both within {:.1} %; it follows them within {} if E″ is divided by a factor from {:.2} to {:.2}, and scatter explains that with a chance below {}",
            100.0 * consistency.together,
            if consistency.with_factor < 1e-3 { "0.1 %".to_owned() } else { format!("{:.1} %", 100.0 * consistency.with_factor) },
            consistency.factor[0],
            consistency.factor[1],
            if consistency.chance < 1e-4 { "0.01 %" } else { "1 %" }
        ));
    }
    if let (Wanted::Error(error), false) = (wanted, fit.met) {
        odd.push(format!(
            "the wanted error {error:.1e} is not met: the closest series of positive terms that was found follows the data within {:.1e}",
            fit.best_rms_error
        ));
    }
    if fit.rms_error > 0.2 {
        odd.push(format!(
            "the fit misses the data by {:.0} %: no series of positive terms that was tried follows them",
            100.0 * fit.rms_error
        ));
    }
    odd
}
