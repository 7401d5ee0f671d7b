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
            let after = lines.partition_point(|point| point.0 <= place).min(lines.len().checked_sub(1)?);
            let (&(from, low), &(to, high)) = (lines.get(after.checked_sub(1)?)?, lines.get(after)?);
            (from <= place && place <= to && to > from).then_some(())?;
            Some(value - low - (high - low) * (place - from) / (to - from))
        })
        .collect()
}
