//! The noise of a column, and where it jumps: what is found from the data alone.

/// Median.
fn median(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied()
}

/// Standard deviation of the noise of a smooth column, from the median distance of a row from the middle of its neighbours; never zero.
pub(super) fn noise(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
    let least = 1e-6 * (high - low).max(f64::MIN_POSITIVE);
    let distances = values.windows(3).filter_map(|three| match three {
        [before, value, after] => Some((value - 0.5 * (before + after)).abs()),
        _ => None,
    });
    // The distance has 3/2 of the variance, and its median is 0.6745 of its standard deviation.
    median(distances.collect()).map_or(least, |distance| distance / (0.6745 * 1.5_f64.sqrt())).max(least)
}

/// Rows between which a contact is lost for good: the last in contact and the first out of it. The fall takes one row or some, and all that follows is at rest.
pub(super) fn loss(values: &[f64], pull_is_negative: bool) -> Option<[usize; 2]> {
    let sigma = noise(values);
    let rise = |pair: [usize; 2]| Some(values.get(pair[1])? - values.get(pair[0])?);
    let size = |index: usize| rise([index, index + 1]).map_or(0.0, |rise| if pull_is_negative { rise } else { -rise });
    let largest = (0..values.len().saturating_sub(1)).max_by(|one, other| size(*one).total_cmp(&size(*other)))?;
    let jump = size(largest);
    let (mut from, mut to) = (largest, largest + 1);
    // Rows on the fall itself, which the bandwidth of an instrument makes.
    while from > 0 && size(from - 1) > 8.0 * sigma && size(from - 1) > 0.2 * jump {
        from -= 1;
    }
    while size(to) > 8.0 * sigma && size(to) > 0.2 * jump {
        to += 1;
    }
    let after = values.get(to..)?;
    let rest = median(after.to_vec()).filter(|_| after.len() >= 3)?;
    let fall = (values.get(from)? - rest).abs();
    let quiet = after.iter().all(|value| (value - rest).abs() <= 6.0 * sigma + 0.1 * fall);
    // One row that lies off alone is no contact.
    let held = from.checked_sub(1).and_then(|before| values.get(before)).is_some_and(|before| (before - rest).abs() > 4.0 * sigma);
    // At rest is that nothing touches: no force, which a curve that pulls comes from, or no radius. A load that is held is no such rest.
    let nothing = if pull_is_negative {
        values.get(..from).is_some_and(|before| before.iter().any(|value| *value >= rest - 0.5 * fall))
    } else {
        rest.abs() <= 6.0 * sigma + 0.1 * fall
    };
    (quiet && held && nothing && jump > 8.0 * sigma && fall > 8.0 * sigma).then_some([from, to])
}

#[cfg(test)]
mod tests {
    use super::*;
    use viscotack::special::normal::Normal;

    /// A parabola that is lost at row 70 of 100, with noise.
    fn curve(sigma: f64) -> Vec<f64> {
        let mut stream = Normal::of(3, 1);
        let clean = |row: i32| if row < 70 { -1.0 + (f64::from(row) / 35.0 - 1.5).powi(2) } else { 0.0 };
        (0..100).map(|row| clean(row) + sigma * stream.sample()).collect()
    }

    #[test]
    fn noise_and_loss_are_found() {
        for sigma in [1e-3, 1e-2, 3e-2] {
            let values = curve(sigma);
            assert!((noise(&values) / sigma - 1.0).abs() < 0.35, "{}", noise(&values));
            assert_eq!(loss(&values, true), Some([69, 70]));
        }
        let upside_down: Vec<f64> = curve(1e-2).iter().map(|value| -value).collect();
        assert_eq!(loss(&upside_down, true), None);
        assert_eq!(loss(&upside_down, false), Some([69, 70]));
    }

    /// A pull that is small beside the load before it is lost all the same; a row that lies off alone in what follows is not.
    #[test]
    fn a_small_pull_is_lost_and_an_outlier_is_not() {
        let mut values = curve(1e-2);
        let pressed: Vec<f64> = (0..60).map(|row| 60.0 - f64::from(row)).collect();
        values.splice(0..0, pressed);
        assert_eq!(loss(&values, true), Some([129, 130]));
        let mut still: Vec<f64> = curve(1e-2).split_off(70);
        still[20] -= 0.5;
        assert_eq!(loss(&still, true), None);
    }

    /// What presses on and is held, and what rests under a load that then falls (seen from the end): at rest is a load, not nothing.
    #[test]
    fn a_load_at_rest_is_no_loss() {
        let mut stream = Normal::of(5, 1);
        let mut noisy = |value: f64| value + 0.03 * stream.sample();
        let pressed: Vec<f64> = (0..60).map(|row| noisy(if row < 6 { f64::from(row) / 5.0 } else { 0.85 })).collect();
        assert_eq!(loss(&pressed, true), None);
        let mut unloaded: Vec<f64> = (0..60).map(|row| noisy(if row < 8 { 1.0 } else { 0.5 - f64::from(row) / 40.0 })).collect();
        unloaded.reverse();
        assert_eq!(loss(&unloaded, true), None);
        let smaller: Vec<f64> = (0..60).map(|row| noisy(if row < 40 { 1.0 } else { 0.5 })).collect();
        assert_eq!(loss(&smaller, false), None);
    }

    #[test]
    fn a_curve_that_fades_has_no_loss() {
        let values: Vec<f64> = (0..100).map(|row| -(-f64::from(row) / 20.0).exp()).collect();
        assert_eq!(loss(&values, true), None);
    }
}
