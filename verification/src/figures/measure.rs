//! Numbers measured on curves: what a feature is about.

use super::curve::Curve;
use serde::Deserialize;

/// What is measured of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Take {
    /// y at `at`, between its neighbours by a straight line on the axes' scales.
    Value,
    /// y of the first point.
    First,
    /// y of the last point.
    Last,
    /// x of the first point.
    FirstPlace,
    /// x of the last point.
    LastPlace,
    /// Largest y.
    Largest,
    /// Smallest y.
    Smallest,
    /// x of the largest y.
    PlaceOfLargest,
    /// x of the smallest y.
    PlaceOfSmallest,
    /// Slope of the straight line through the points, on the axes' scales.
    Slope,
    /// The part of all ups and downs that is up: 1 rises everywhere, 0 falls everywhere.
    Rising,
    /// x where y first crosses `level`.
    Crossing,
    /// How often y crosses `level`.
    Crossings,
    /// Largest distance in y from the curve `than`, over the range of both (on a logarithmic axis of ln y, not divided).
    LargestDistance,
    /// Smallest y over that of the curve `than` at the same x.
    SmallestRatio,
    /// Largest y over that of the curve `than` at the same x.
    LargestRatio,
    /// Half the area that the curve encloses, run through as a loop, signed: mean loop, or a count of ups and downs of hysteresis.
    Area,
    /// Number of points.
    Count,
}

/// The scales on which lines are straight: whether x and y are logarithmic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Scales {
    pub(super) x_log: bool,
    pub(super) y_log: bool,
}

/// Where and with what to measure.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Where<'a> {
    pub(super) at: Option<f64>,
    pub(super) over: Option<[f64; 2]>,
    pub(super) level: Option<f64>,
    pub(super) than: Option<&'a Curve>,
}

/// A measured number, or why there is none.
pub(super) fn measured(take: Take, curve: &Curve, place: Where<'_>, scales: Scales) -> Result<f64, String> {
    let points: Vec<(f64, f64)> =
        curve.solved().into_iter().filter(|(x, _)| place.over.is_none_or(|[low, high]| *x >= low && *x <= high)).collect();
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
        return Err(format!("`{}` has no points there", curve.name));
    };
    let by_y = |one: &&(f64, f64), other: &&(f64, f64)| one.1.total_cmp(&other.1);
    let level = || place.level.ok_or_else(|| "a crossing needs a `level`".to_owned());
    let than = || place.than.ok_or_else(|| "a comparison needs a curve `than`".to_owned());
    let largest = points.iter().max_by(by_y).copied().unwrap_or(first);
    let smallest = points.iter().min_by(by_y).copied().unwrap_or(first);
    let number = match take {
        Take::Value => {
            let at = place.at.ok_or_else(|| "a value needs a place `at`".to_owned())?;
            value_at(&points, at, scales).ok_or_else(|| format!("`{}` has no value at {at}", curve.name))?
        }
        Take::First => first.1,
        Take::Last => last.1,
        Take::FirstPlace => first.0,
        Take::LastPlace => last.0,
        Take::Largest => largest.1,
        Take::Smallest => smallest.1,
        Take::PlaceOfLargest => largest.0,
        Take::PlaceOfSmallest => smallest.0,
        Take::Slope => slope(&points, scales),
        Take::Rising => {
            let steps = points.windows(2).map(|pair| pair[1].1 - pair[0].1);
            let (up, all) = steps.fold((0.0, 0.0), |(up, all), step| (up + step.max(0.0), all + step.abs()));
            up / all
        }
        Take::Crossing => *crossings(&points, level()?, scales).first().ok_or_else(|| format!("`{}` never crosses it", curve.name))?,
        Take::Crossings => crossings(&points, level()?, scales).len() as f64,
        Take::LargestDistance => {
            let other = than()?.solved();
            let range =
                points.iter().chain(&other).fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (_, y)| [low.min(*y), high.max(*y)]);
            compared(&points, &other, scales, |own, other| {
                if scales.y_log { (own / other).ln().abs() } else { (own - other).abs() / (range[1] - range[0]) }
            })
            .fold(f64::NAN, f64::max)
        }
        Take::SmallestRatio => compared(&points, &than()?.solved(), scales, |own, other| own / other).fold(f64::NAN, f64::min),
        Take::LargestRatio => compared(&points, &than()?.solved(), scales, |own, other| own / other).fold(f64::NAN, f64::max),
        Take::Area => 0.5 * points.windows(2).map(|pair| (pair[1].0 - pair[0].0) * (pair[1].1 + pair[0].1)).sum::<f64>(),
        Take::Count => points.len() as f64,
    };
    if number.is_finite() { Ok(number) } else { Err(format!("what is measured on `{}` is no number", curve.name)) }
}

/// A number of both curves at each place of the first that the second reaches.
fn compared<'a>(
    points: &'a [(f64, f64)],
    other: &'a [(f64, f64)],
    scales: Scales,
    number: impl Fn(f64, f64) -> f64 + 'a,
) -> impl Iterator<Item = f64> + 'a {
    points.iter().filter_map(move |(x, y)| value_at(other, *x, scales).map(|value| number(*y, value)))
}

fn scaled(value: f64, log: bool) -> f64 {
    if log { value.ln() } else { value }
}

/// y at a place, in the first segment that holds it.
fn value_at(points: &[(f64, f64)], at: f64, scales: Scales) -> Option<f64> {
    if let Some((_, y)) = points.iter().find(|(x, _)| (x - at).abs() <= 1e-12 * at.abs()) {
        return Some(*y);
    }
    points.windows(2).find_map(|pair| {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        if (x0 - at) * (x1 - at) > 0.0 {
            return None;
        }
        let part = (scaled(at, scales.x_log) - scaled(x0, scales.x_log)) / (scaled(x1, scales.x_log) - scaled(x0, scales.x_log));
        let log = scales.y_log && y0 > 0.0 && y1 > 0.0;
        let value = scaled(y0, log) + part * (scaled(y1, log) - scaled(y0, log));
        Some(if log { value.exp() } else { value })
    })
}

/// The straight line of least squares.
fn slope(points: &[(f64, f64)], scales: Scales) -> f64 {
    let scaled: Vec<(f64, f64)> = points.iter().map(|(x, y)| (scaled(*x, scales.x_log), scaled(y.abs(), scales.y_log))).collect();
    let signed: Vec<(f64, f64)> = if scales.y_log { scaled } else { scaled.iter().zip(points).map(|((x, _), (_, y))| (*x, *y)).collect() };
    let count = signed.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| signed.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let (above, below) = signed
        .iter()
        .fold((0.0, 0.0), |(above, below), point| (above + (point.0 - x) * (point.1 - y), below + (point.0 - x) * (point.0 - x)));
    above / below
}

/// Places where y crosses a level, in order along the curve.
fn crossings(points: &[(f64, f64)], level: f64, scales: Scales) -> Vec<f64> {
    points
        .windows(2)
        .filter(|pair| (pair[0].1 > level) != (pair[1].1 > level))
        .map(|pair| {
            let part = (level - pair[0].1) / (pair[1].1 - pair[0].1);
            let (from, to) = (scaled(pair[0].0, scales.x_log), scaled(pair[1].0, scales.x_log));
            let place = from + part * (to - from);
            if scales.x_log { place.exp() } else { place }
        })
        .collect()
}
