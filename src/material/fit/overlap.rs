//! Whether curves that were shifted onto each other lie on each other.

/// One curve: places (ln of reduced frequency or time) and the logarithm of what was measured.
pub type LogCurve = Vec<(f64, f64)>;

/// Root-mean-square difference of two curves where both were measured; none where they do not meet.
#[must_use]
pub fn mismatch(left: &LogCurve, right: &LogCurve) -> Option<f64> {
    let one = differences(left, right);
    let other = differences(right, left);
    let all: Vec<f64> = one.into_iter().chain(other).collect();
    (!all.is_empty()).then(|| (all.iter().map(|difference| difference * difference).sum::<f64>() / all.len() as f64).sqrt())
}

/// The points of one curve against the other's straight lines between its points; both sorted by place.
pub(super) fn differences(points: &LogCurve, lines: &LogCurve) -> Vec<f64> {
    points
        .iter()
        .filter_map(|&(place, value)| {
            let pair = lines.windows(2).filter_map(|pair| <[(f64, f64); 2]>::try_from(pair).ok());
            let [(from, low), (to, high)] = pair.into_iter().find(|[from, to]| from.0 <= place && place <= to.0 && to.0 > from.0)?;
            Some(value - low - (high - low) * (place - from) / (to - from))
        })
        .collect()
}
