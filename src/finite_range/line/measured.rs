//! A measured profile or map made periodic: levelled first, then mirrored, tapered, or taken as it is.

use crate::refusal::Refusal;

/// The part of a window at each end over which it rises from zero to one.
const TAPER: f64 = 0.1;

/// What is taken off a measured profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Levelling {
    /// The least-squares line or plane: the tilt of the instrument.
    Plane,
    /// The mean alone.
    Mean,
}

/// How the ends of a measured profile meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// The profile is followed by its mirror image (a map along both directions): no height is changed, the period doubles.
    Mirror,
    /// The heights fall smoothly to the mean over a tenth of the length at each end (cosine taper).
    Window,
    /// The profile is a whole period already.
    Periodic,
}

/// Takes the mean or the least-squares plane off rows of `nx` equally spaced heights, in place. The unit of the heights is free.
pub fn level(nx: usize, heights: &mut [f64], levelling: Levelling) {
    let n = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / n;
    heights.iter_mut().for_each(|h| *h -= mean);
    if levelling == Levelling::Mean || nx == 0 {
        return;
    }
    let ny = heights.len() / nx;
    // On a full grid the two directions are orthogonal.
    let centred = |index: usize, count: usize| index as f64 - 0.5 * (count as f64 - 1.0);
    let slope = |place: &dyn Fn(usize) -> f64| {
        let (product, square) = heights.iter().enumerate().fold((0.0, 0.0), |(p, s), (i, h)| (p + place(i) * h, s + place(i) * place(i)));
        if square > 0.0 { product / square } else { 0.0 }
    };
    let along = slope(&|i| centred(i % nx, nx));
    let across = slope(&|i| centred(i / nx, ny));
    for (i, h) in heights.iter_mut().enumerate() {
        *h -= along * centred(i % nx, nx) + across * centred(i / nx, ny);
    }
}

/// One period made of `ny` rows of `nx` heights: nodes along x, along y, heights. An odd last row or column is left out.
///
/// # Errors
/// [`Refusal::Undefined`] for fewer than four heights along x, for no, two or three rows, or if the heights do not fill the rows.
pub fn periodic(nx: usize, ny: usize, heights: &[f64], ends: Ends) -> Result<(usize, usize, Vec<f64>), Refusal> {
    if nx < 4 || ny == 0 || (ny > 1 && ny < 4) || nx * ny != heights.len() {
        let reason = format!("{ny} rows of {nx} heights are too few: at least 4 along x, and 1 or at least 4 rows");
        return Err(Refusal::Undefined { quantity: "a measured profile", reason });
    }
    let even = |n: usize| if n > 1 { n - n % 2 } else { n };
    // Which height stands at a node of the period.
    let (to_x, to_y) = match ends {
        Ends::Mirror => (2 * nx - 2, if ny > 1 { 2 * ny - 2 } else { 1 }),
        Ends::Window | Ends::Periodic => (even(nx), even(ny)),
    };
    let folded = |i: usize, n: usize| if i < n { i } else { 2 * n - 2 - i };
    let weight = |i: usize, n: usize| if ends == Ends::Window && n > 1 { taper((i as f64 + 0.5) / n as f64) } else { 1.0 };
    let mut out = Vec::with_capacity(to_x * to_y);
    for j in 0..to_y {
        for i in 0..to_x {
            let height = heights[folded(j, ny) * nx + folded(i, nx)];
            out.push(height * weight(i, to_x) * weight(j, to_y));
        }
    }
    Ok((to_x, to_y, out))
}

/// The cosine taper at a place between 0 and 1.
fn taper(place: f64) -> f64 {
    let from_end = place.min(1.0 - place) / TAPER;
    if from_end >= 1.0 { 1.0 } else { 0.5 * (1.0 - (std::f64::consts::PI * from_end).cos()) }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::float_cmp)]
mod tests {
    use super::*;

    #[test]
    fn a_tilted_plane_is_level() {
        let mut heights: Vec<f64> = (0..20).map(|i| 3.0 + 0.5 * f64::from(i % 5) - 0.25 * f64::from(i / 5)).collect();
        level(5, &mut heights, Levelling::Plane);
        assert!(heights.iter().all(|h| h.abs() < 1e-12));
    }

    #[test]
    fn a_mirrored_profile_goes_back_and_a_window_ends_at_zero() {
        let (nx, ny, mirrored) = periodic(4, 1, &[1.0, 2.0, 3.0, 5.0], Ends::Mirror).unwrap();
        assert_eq!((nx, ny, mirrored), (6, 1, vec![1.0, 2.0, 3.0, 5.0, 3.0, 2.0]));
        let (nx, _, tapered) = periodic(41, 1, &[1.0; 41], Ends::Window).unwrap();
        assert_eq!(nx, 40);
        assert!(tapered[0] < 0.05 && tapered[39] < 0.05 && tapered[20] == 1.0);
        assert_eq!(periodic(5, 1, &[1.0, 2.0, 0.0, 1.0, 4.0], Ends::Periodic).unwrap().2.len(), 4);
    }
}
