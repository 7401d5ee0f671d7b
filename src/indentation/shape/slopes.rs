//! Slopes of a cubic that rises through rising points.

/// z ∼ r^m through the first two points off the axis: below this m the shape has a sharp tip, above it a smooth one.
const SHARP: f64 = 1.5;
/// Slopes of at most so many secants on both sides keep a cubic rising.
const STEEPEST: f64 = 3.0;

/// z′ at every point, of strictly rising `x` (from 0) and `z`: at least four.
pub(super) fn rising(x: &[f64], z: &[f64]) -> Vec<f64> {
    let n = x.len();
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let d: Vec<f64> = z.windows(2).zip(&h).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    // Rows of the tridiagonal system: below, on and above the diagonal, and the right side.
    let mut rows = vec![[0.0; 4]; n];
    let tip = (z[2] / z[1]).ln() / (x[2] / x[1]).ln();
    rows[0] = if tip > SHARP {
        [0.0, 1.0, 0.0, 0.0]
    } else {
        // The first two cubics are one.
        let both = h[0] + h[1];
        [0.0, h[1], both, ((h[0] + 2.0 * both) * h[1] * d[0] + h[0] * h[0] * d[1]) / both]
    };
    for i in 1..n - 1 {
        rows[i] = [h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1], 3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i])];
    }
    let (last, next) = (h[n - 2], h[n - 3]);
    let both = last + next;
    rows[n - 1] = [both, next, 0.0, (last * last * d[n - 3] + (2.0 * both + last) * next * d[n - 2]) / both];
    for i in 1..n {
        let factor = rows[i][0] / rows[i - 1][1];
        rows[i][1] -= factor * rows[i - 1][2];
        rows[i][3] -= factor * rows[i - 1][3];
    }
    let mut slopes = vec![0.0; n];
    for i in (0..n).rev() {
        let above = if i + 1 < n { slopes[i + 1] } else { 0.0 };
        slopes[i] = (rows[i][3] - rows[i][2] * above) / rows[i][1];
    }
    for (i, slope) in slopes.iter_mut().enumerate() {
        let beside = [d[i.saturating_sub(1)], d[i.min(n - 2)]];
        let (flattest, steepest) = (beside[0].min(beside[1]), beside[0].max(beside[1]));
        // Within a convex shape the slope lies between the secants anyway: this holds down what a spline rings at a shoulder.
        let (least, most) = if i == 0 || i == n - 1 { (0.0, f64::INFINITY) } else { (flattest, steepest) };
        *slope = slope.clamp(least, most).min(STEEPEST * flattest);
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::rising;

    #[test]
    fn parabolas_and_cones_are_met() {
        let x = [0.0, 0.1, 0.25, 0.3, 0.7, 1.0];
        let parabola = rising(&x, &x.map(|x| x * x));
        let cone = rising(&x, &x);
        for ((x, first), second) in x.iter().zip(parabola).zip(cone) {
            assert!((first - 2.0 * x).abs() < 1e-14 && (second - 1.0).abs() < 1e-14, "{x} {first} {second}");
        }
    }
}
