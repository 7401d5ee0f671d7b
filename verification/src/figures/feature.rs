//! Features: measured numbers held against what they must be.

use super::curve::Curve;
use super::manifest::{FeatureEntry, ManifestError, Order};
use super::measure::{Scales, Where, measured};
use super::mutation::Mutation;
use serde::{Deserialize, Serialize};

/// How a feature ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FeatureResult {
    /// It holds.
    Passed,
    /// A claim of the thesis that does not come out; what comes out instead does.
    NotConfirmed,
    /// It does not hold, or no mutation breaks it.
    Failed,
}

impl FeatureResult {
    /// Its word in tables.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::NotConfirmed => "not confirmed",
            Self::Failed => "failed",
        }
    }
}

/// A feature with what was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// What must be seen.
    pub claim: String,
    /// Section or equation of the thesis that states it; empty: ours.
    pub source: String,
    /// How it ended.
    pub result: FeatureResult,
    /// What was measured.
    pub measured: Vec<f64>,
    /// What was expected, in words.
    pub expected: String,
    /// Why it is not confirmed, or failed.
    pub why: String,
    /// Mutations of the data that break it.
    pub broken_by: Vec<Mutation>,
}

/// Checks a feature on the curves of its panel.
pub(super) fn checked(place: &str, entry: &FeatureEntry, curves: &[Curve], scales: Scales) -> Result<Checked, ManifestError> {
    let place = format!("{place}, feature \"{}\"", entry.claim);
    let contradiction = |problem: &str| ManifestError::Contradiction { place: place.clone(), problem: problem.to_owned() };
    let mut names: Vec<&str> = entry.curve.iter().chain(&entry.curves).map(String::as_str).collect();
    let count = names.len();
    if count == 0 {
        return Err(contradiction("names no curve"));
    }
    if entry.order.is_some() != (count > 1) {
        return Err(contradiction("an `order` needs several `curves`, and several curves an `order`"));
    }
    // First the curves themselves, then what they are divided by, last the one they are compared with.
    names.extend(entry.per.iter().flat_map(|per| std::iter::once(per.curve.as_str()).chain(per.plus.as_deref())));
    names.extend(entry.than.as_deref());
    let scales = if entry.log { Scales { x_log: true, y_log: true } } else { scales };
    let named: Vec<Curve> = names
        .iter()
        .map(|name| {
            curves.iter().find(|curve| curve.name == *name).cloned().ok_or_else(|| ManifestError::Unknown {
                place: place.clone(),
                what: "curve",
                name: (*name).to_owned(),
                known: curves.iter().map(|curve| format!("`{}`", curve.name)).collect::<Vec<_>>().join(", "),
            })
        })
        .collect::<Result<_, _>>()?;
    let expected = expectation(entry).ok_or_else(|| contradiction("expects nothing"))?;
    let numbers = |named: &[Curve]| numbers(entry, named, count, scales);
    let (measured, holds, problem) = match numbers(&named) {
        Ok(measured) => {
            let holds = holds(entry, &measured);
            (measured, holds, String::new())
        }
        Err(problem) => (Vec::new(), false, problem),
    };
    let broken = |mutation: &Mutation| !numbers(&mutation.of(&named)).is_ok_and(|measured| as_expected(entry, &measured));
    let broken_by: Vec<Mutation> = if problem.is_empty() { Mutation::ALL.into_iter().filter(broken).collect() } else { Vec::new() };
    let (result, why) = match &entry.not_confirmed {
        _ if !problem.is_empty() => (FeatureResult::Failed, problem),
        _ if broken_by.is_empty() => (FeatureResult::Failed, "no mutation of the data breaks it".to_owned()),
        Some(_) if holds => (FeatureResult::Failed, "it is listed as not confirmed, and comes out".to_owned()),
        Some(why) if as_expected(entry, &measured) => (FeatureResult::NotConfirmed, why.clone()),
        Some(_) => (FeatureResult::Failed, format!("neither the claim nor what should come out instead, {:?}", entry.comes_out)),
        None if holds => (FeatureResult::Passed, String::new()),
        None => (FeatureResult::Failed, "it does not hold".to_owned()),
    };
    Ok(Checked { claim: entry.claim.clone(), source: entry.source.clone(), result, measured, expected, why, broken_by })
}

/// One number a curve, divided where asked.
fn numbers(entry: &FeatureEntry, named: &[Curve], count: usize, scales: Scales) -> Result<Vec<f64>, String> {
    let than = entry.than.as_ref().and_then(|_| named.last());
    let place = Where { at: entry.at, over: entry.over, level: entry.level, than };
    named
        .iter()
        .take(count)
        .map(|curve| {
            let number = measured(entry.take, curve, place, scales)?;
            let Some(other) = &entry.per else { return Ok(number) };
            let place = Where { at: other.at.or(entry.at), over: other.over.or(entry.over), ..place };
            let terms = named.iter().skip(count).take(1 + usize::from(other.plus.is_some()));
            let below = terms.map(|curve| measured(other.take.unwrap_or(entry.take), curve, place, scales)).sum::<Result<f64, String>>()?;
            let ratio = number / below;
            if ratio.is_finite() { Ok(ratio) } else { Err(format!("what `{}` is divided by is zero", curve.name)) }
        })
        .collect()
}

/// Whether the claim itself holds.
fn holds(entry: &FeatureEntry, measured: &[f64]) -> bool {
    let each = measured.iter().all(|&number| {
        let equal = entry.equals.is_none_or(|expected| (number - expected).abs() <= tolerance(entry, expected));
        equal
            && entry.above.is_none_or(|bound| number > bound)
            && entry.below.is_none_or(|bound| number < bound)
            && entry.between.is_none_or(|[low, high]| number >= low && number <= high)
    });
    let ordered = match entry.order {
        None => true,
        Some(Order::Increasing) => measured.windows(2).all(|pair| pair[1] > pair[0]),
        Some(Order::Decreasing) => measured.windows(2).all(|pair| pair[1] < pair[0]),
    };
    each && ordered && !measured.is_empty()
}

/// Whether what should come out does: the claim, or the bounds that replace it.
fn as_expected(entry: &FeatureEntry, measured: &[f64]) -> bool {
    if entry.not_confirmed.is_none() {
        return holds(entry, measured);
    }
    let instead = entry.comes_out.is_none_or(|[low, high]| measured.first().is_some_and(|number| *number >= low && *number <= high));
    instead && !holds(entry, measured)
}

fn tolerance(entry: &FeatureEntry, expected: f64) -> f64 {
    let within = entry.within.unwrap_or(0.0);
    if expected == 0.0 { within } else { within * expected.abs() }
}

/// What is expected, in words.
fn expectation(entry: &FeatureEntry) -> Option<String> {
    let mut words = Vec::new();
    words.extend(entry.equals.map(|value| match (entry.within, value == 0.0) {
        (Some(within), true) => format!("{value} ± {within}"),
        (Some(within), false) => format!("{value} ± {} %", (1e11 * within).round() / 1e9),
        (None, _) => format!("{value}"),
    }));
    words.extend(entry.above.map(|bound| format!("above {bound}")));
    words.extend(entry.below.map(|bound| format!("below {bound}")));
    words.extend(entry.between.map(|[low, high]| format!("{low} to {high}")));
    words.extend(entry.order.map(|order| match order {
        Order::Increasing => "increasing".to_owned(),
        Order::Decreasing => "decreasing".to_owned(),
    }));
    (!words.is_empty()).then(|| words.join(", "))
}
