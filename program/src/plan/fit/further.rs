//! Which further test would shrink the intervals most: the expected information of tests near those that were made.

use super::carry_out::Fit;
use super::compare::Comparison;
use super::setup::{Role, Setup};
use crate::scene::check::{Units, number};
use crate::scene::document::{Node, Value};
use crate::scene::read;
use crate::scene::units::Dimension;
use rayon::prelude::*;
use viscotack::fit::standard_errors;

/// Step of differences, in coordinates.
const STEP: f64 = 0.01;

/// A test that could be made.
#[derive(Debug, Clone)]
pub struct Further {
    /// What it is.
    pub name: String,
    /// Half of the 95 % interval of each parameter with it, over that without it; or why it cannot be made.
    pub shrinkage: Result<Vec<f64>, String>,
}

impl Further {
    /// Geometric mean of the shrinkage: smaller is better.
    #[must_use]
    pub fn mean(&self) -> f64 {
        match &self.shrinkage {
            Ok(parts) if !parts.is_empty() => (parts.iter().map(|part| part.ln()).sum::<f64>() / parts.len() as f64).exp(),
            _ => f64::INFINITY,
        }
    }
}

/// Tests at other rates, preloads and holds, and the contact radius beside what is compared, best first; each with as many rows and as much noise, over its
/// largest value, as the first test has.
#[must_use]
pub fn further(fit: &Fit) -> Vec<Further> {
    let setup = &fit.setup;
    let Some(first) = setup.tests.first() else { return Vec::new() };
    let mut all: Vec<Further> = candidates(setup, first)
        .into_par_iter()
        .map(|(name, test)| Further { name, shrinkage: test.and_then(|test| shrinkage(fit, test)) })
        .collect();
    all.sort_by(|one, other| one.mean().total_cmp(&other.mean()));
    all
}

type Candidate = (String, Result<Comparison, String>);

fn candidates(setup: &Setup, first: &Comparison) -> Vec<Candidate> {
    let mut found: Vec<Candidate> = vec![("the first test once more".to_owned(), Ok(first.clone()))];
    if setup.across {
        let (low, high) = first.range();
        for (name, from, to) in [("a decade below", low / 10.0, low), ("a decade above", high, high * 10.0)] {
            let mut test = first.clone();
            let count = test.abscissa.len().max(2);
            test.abscissa = (0..count).map(|row| from * (to / from).powf(row as f64 / (count - 1) as f64)).collect();
            found.push((format!("as many rows over {name} of the {}", first.against), Ok(test)));
        }
        return found;
    }
    let changed = |name: String, key: &str, dimension: Dimension, factor: f64, default: Option<f64>| -> Option<Candidate> {
        let node = first.document.root.at(key);
        let now = node.and_then(|node| number(node, key, dimension, setup.units).ok()).or(default)?;
        let mut test = first.clone();
        let place = node.map_or_else(|| setup.task.compare_place.clone(), |node| node.place.clone());
        let put = test.document.replace(key, Node { value: Value::Number(now * factor), place }).map_err(|error| error.to_string());
        let read = put.and_then(|()| read::read_state(&test.document).map(|_| ()).map_err(|error| error.to_string()));
        Some((name, read.map(|()| test)))
    };
    for (word, factor) in [("ten times slower", 0.1), ("ten times faster", 10.0)] {
        let Some((name, test)) = changed(word.to_owned(), "indentation.speed_factor", Dimension::NUMBER, factor, Some(1.0)) else {
            continue;
        };
        // All times of the test go with its speed.
        let stretched = test.map(|mut test| {
            if test.against == "time" {
                test.abscissa.iter_mut().for_each(|time| *time /= factor);
            }
            test.time.iter_mut().flatten().for_each(|time| *time /= factor);
            test
        });
        found.push((name, stretched));
    }
    for (key, dimension) in [("force", Dimension::FORCE), ("penetration", Dimension::LENGTH), ("contact_radius", Dimension::LENGTH)] {
        for (word, factor) in [("a third of the preload", 1.0 / 3.0), ("three times the preload", 3.0)] {
            found.extend(changed(word.to_owned(), &format!("indentation.{key}"), dimension, factor, None));
        }
    }
    let holds = (0..first.document.root.get("history").map_or(0, |node| match &node.value {
        Value::List(items) => items.len(),
        _ => 0,
    }))
        .filter(|index| first.document.root.at(&format!("history.{index}.hold")).is_some());
    for index in holds {
        found.extend(changed(
            format!("segment {index} held ten times as long"),
            &format!("history.{index}.hold"),
            Dimension::TIME,
            10.0,
            None,
        ));
    }
    if !first.columns.iter().any(|column| column.word == "contact_radius")
        && let Some(column) = first.columns.first()
    {
        let mut test = first.clone();
        test.columns.push(super::compare::Compared { word: "contact_radius".to_owned(), unit: "m".to_owned(), ..column.clone() });
        found.push(("the contact radius beside it".to_owned(), Ok(test)));
    }
    if setup.units == Units::Reduced {
        found.retain(|(name, _)| !name.is_empty())
    }
    found
}

/// Standard errors with a further test over those without it.
fn shrinkage(fit: &Fit, mut test: Comparison) -> Result<Vec<f64>, String> {
    // Its jumps will lie elsewhere: rows are compared as they are, jumps add nothing.
    (test.gain, test.loss) = (None, None);
    test.rows = (0..test.abscissa.len()).collect();
    let (setup, fitted) = (&fit.setup, &fit.fitted);
    let parameters = &setup.parameters;
    let put = |values: &[f64]| -> Vec<(super::compare::Put, f64)> {
        let of = setup.roles.iter().zip(values);
        of.filter_map(|((role, _), value)| match role {
            Role::Scene(put) => Some((put.clone(), *value)),
            Role::Of(..) => None,
        })
        .collect()
    };
    let model = |values: &[f64]| -> Result<Vec<f64>, String> {
        let own = put(values);
        let own: Vec<(&super::compare::Put, f64)> = own.iter().map(|(put, value)| (put, *value)).collect();
        test.model(&own, setup.offsets(0, values), fit.tolerance)
    };
    let base = model(&fitted.values)?;
    // The noise of each column over its largest value is that of the first column of the first test.
    let first = setup.tests.first().and_then(|test| test.columns.first()).ok_or("there is no test")?;
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let part = if test.relative { 1.0 } else { largest(&first.values) };
    let noise = fitted.sigmas.first().copied().unwrap_or(1.0) / part;
    let rows = test.rows.len();
    let sigma = |index: usize| {
        let column = index / rows.max(1);
        let own = base.get(column * rows..(column + 1) * rows).unwrap_or(&[]);
        if test.relative { noise } else { noise * largest(own).max(f64::MIN_POSITIVE) }
    };
    let sigmas: Vec<f64> = (0..base.len()).map(sigma).collect();
    // Rows beside a jump change by all of it when the jump moves over them: what no row shows reliably is left out.
    let column = |place: usize| -> Result<Vec<f64>, String> {
        // An offset belongs to its test: another test has its own.
        if matches!(setup.roles.get(place), Some((Role::Of(..), _))) {
            return Ok(vec![0.0; base.len()]);
        }
        let parameter = parameters.get(place).ok_or("no such parameter")?;
        let moved = |side: f64| -> Result<Vec<f64>, String> {
            let mut values = fitted.values.clone();
            if let Some(value) = values.get_mut(place) {
                *value = parameter.value(parameter.coordinate(*value) + side * STEP);
            }
            model(&values)
        };
        let (up, down) = (moved(1.0)?, moved(-1.0)?);
        let slopes = up.iter().zip(&down).zip(&base).zip(&sigmas).map(|(((up, down), base), sigma)| {
            let (one, other) = (up - base, base - down);
            let jumps = (one - other).abs() > 0.5 * (one.abs() + other.abs()).max(3.0 * sigma);
            if jumps { 0.0 } else { 0.5 * (up - down) / (STEP * sigma) }
        });
        Ok(slopes.collect())
    };
    let new: Vec<Vec<f64>> = (0..parameters.len()).into_par_iter().map(column).collect::<Result<_, _>>()?;
    let both: Vec<Vec<f64>> = fitted.jacobian.iter().zip(&new).map(|(old, new)| old.iter().chain(new).copied().collect()).collect();
    let (before, after) = (standard_errors(&fitted.jacobian), standard_errors(&both));
    Ok(before
        .iter()
        .zip(&after)
        .map(|(before, after)| {
            if before.is_finite() {
                after / before
            } else if after.is_finite() {
                1e-3
            } else {
                1.0
            }
        })
        .collect())
}
