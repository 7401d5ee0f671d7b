//! Richardson's extrapolation of values on meshes of N, 2N, 4N … elements.
//!
//! ```text
//! v(N) = v + c₁N^{−p₁} + c₂N^{−p₂} + …      each order p removed in turn:  (2^p v(2N) − v(N))/(2^p − 1)
//! ```

/// The order p that three values on N, 2N and 4N elements show: log₂ of the ratio of their differences; NaN where they do not fall one way.
#[must_use]
pub fn observed_order(coarse: f64, middle: f64, fine: f64) -> f64 {
    ((middle - coarse) / (fine - middle)).log2()
}

/// The value with the given orders removed, from values on N, 2N, 4N … elements; as many orders are used as there are values to remove them.
#[must_use]
pub fn extrapolated(values: &[f64], orders: &[f64]) -> f64 {
    let mut column = values.to_vec();
    for order in orders.iter().take(values.len().saturating_sub(1)) {
        let factor = order.exp2();
        column = column
            .windows(2)
            .filter_map(|pair| match pair {
                [coarse, fine] => Some((factor * fine - coarse) / (factor - 1.0)),
                _ => None,
            })
            .collect();
    }
    column.last().copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_orders_are_seen_and_removed() {
        let value = |elements: f64| 1.5 + 3.0 / elements.powi(2) - 40.0 / elements.powi(3);
        let values = [value(10.0), value(20.0), value(40.0)];
        assert!((extrapolated(&values, &[2.0, 3.0]) - 1.5).abs() < 1e-14);
        assert!((observed_order(1.0, 0.5, 0.375) - 2.0).abs() < 1e-14);
        assert!(observed_order(1.0, 0.5, 0.7).is_nan());
        assert!(extrapolated(&[], &[2.0]).is_nan());
    }
}
