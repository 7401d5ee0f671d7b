//! Centre and tilt of a scan: what makes its heights a function of the distance from the centre, by least squares.
//!
//! The function of r is straight in r² within each of a few rings. Gauss and Newton's steps for centre and tilt are orthogonal to it.

use super::distance;
use crate::refusal::Refusal;
use nalgebra::{DMatrix, DVector};

/// Points of a ring in these fits, at least, and rings at most.
const POINTS_OF_A_RING: usize = 4;
const MOST_RINGS: usize = 24;
const STEPS: usize = 60;
/// A tilt is taken out if it lowers the sum of squares by this many times what noise would, for each of its components and
/// of the parameters of the rings.
const SIGNIFICANT: f64 = 20.0;
/// Components of a tilt that a shift explains up to this share of their square are no tilt.
const EXPLAINED: f64 = 1e-6;

/// Centre and tilt, in the coordinates of the frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fit {
    pub(super) centre: [f64; 2],
    pub(super) tilt: [f64; 2],
    /// Σ of the squared distances from a function of r.
    squares: f64,
}

impl Fit {
    pub(super) const fn at(centre: [f64; 2]) -> Self {
        Self { centre, tilt: [0.0; 2], squares: f64::INFINITY }
    }

    /// The height of a point without the tilt.
    pub(super) fn levelled(&self, point: &[f64; 3]) -> f64 {
        point[2] - self.tilt[0] * (point[0] - self.centre[0]) - self.tilt[1] * (point[1] - self.centre[1])
    }
}

/// The curvature and the vertex of the paraboloid nearest to the points: a parabola on a line.
pub(super) fn parabola(points: &[[f64; 3]], line: bool) -> Result<(f64, [f64; 2]), Refusal> {
    let columns = if line { 3 } else { 4 };
    let matrix = DMatrix::from_fn(points.len(), columns, |row, column| {
        points.get(row).map_or(0.0, |point| match column {
            0 => 1.0,
            1 => point[0] * point[0] + point[1] * point[1],
            2 => point[0],
            _ => point[1],
        })
    });
    let right = DVector::from_iterator(points.len(), points.iter().map(|point| point[2]));
    let solution = normal(&matrix, &right).filter(|solution| solution.get(1).is_some_and(|curvature| *curvature != 0.0));
    let Some(solution) = solution else {
        return Err(Refusal::NoSuchState { reason: "the scan is not curved: it has no apex".into(), limit_name: "curvature", limit: 0.0 });
    };
    let of = |column: usize| solution.get(column).copied().unwrap_or(0.0);
    Ok((of(1), [2, 3].map(|column| -0.5 * of(column) / of(1))))
}

/// How far all sides reach from a centre: the points beyond are on some sides only.
pub(super) fn reach(points: &[[f64; 3]], centre: [f64; 2], line: bool) -> f64 {
    let mut least = f64::INFINITY;
    for (axis, middle) in centre.into_iter().enumerate().take(if line { 1 } else { 2 }) {
        let along = points.iter().filter_map(|point| point.get(axis));
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
        least = least.min((middle - low).min(high - middle));
    }
    least
}

/// The best centre, with a tilt if there is one to be seen.
pub(super) fn fit(points: &[[f64; 3]], start: [f64; 2], line: bool) -> Fit {
    let starts = [start, lowest(points)];
    let best = |with_tilt: bool, starts: &[Fit]| {
        let found = starts.iter().map(|start| improved(points, *start, line, with_tilt));
        found.fold(Fit::at(start), |best, found| if found.squares < best.squares { found } else { best })
    };
    let centred = best(false, &starts.map(Fit::at));
    let tilted = best(true, &[centred, Fit::at(starts[1])]);
    let components = if line { 1.0 } else { 2.0 };
    let rings = 2.0 * rings_of(points.len()) as f64;
    let noise = tilted.squares / (points.len() as f64 - rings - 2.0 * components).max(1.0);
    // Rings of other points fit other noise: the sum differs by about the number of their parameters for that reason alone.
    if centred.squares - tilted.squares > (SIGNIFICANT * components + rings) * noise { tilted } else { centred }
}

/// The mean place of the lowest points: near the apex of a shape with a tip, whatever its tilt.
fn lowest(points: &[[f64; 3]]) -> [f64; 2] {
    let mut sorted: Vec<&[f64; 3]> = points.iter().collect();
    sorted.sort_by(|first, second| first[2].total_cmp(&second[2]));
    let count = 3.max(points.len() / 50).min(points.len());
    [0, 1].map(|axis| sorted.iter().take(count).filter_map(|point| point.get(axis)).sum::<f64>() / count as f64)
}

fn rings_of(points: usize) -> usize {
    (points / POINTS_OF_A_RING).clamp(2, MOST_RINGS)
}

/// Steps that lower the sum of squares.
fn improved(points: &[[f64; 3]], start: Fit, line: bool, with_tilt: bool) -> Fit {
    let mut here = start;
    let Some((mut residuals, mut columns)) = linearised(points, &here, line, with_tilt) else { return here };
    here.squares = residuals.norm_squared();
    for _ in 0..STEPS {
        let Some(step) = normal(&columns, &residuals) else { return here };
        let mut share = 1.0;
        let next = loop {
            let trial = moved(&here, &step, share, line, with_tilt);
            if let Some((residuals, columns)) = linearised(points, &trial, line, with_tilt) {
                let squares = residuals.norm_squared();
                if squares < here.squares {
                    break Some((Fit { squares, ..trial }, residuals, columns));
                }
            }
            share *= 0.5;
            if share < 1e-3 {
                break None;
            }
        };
        let Some((better, new_residuals, new_columns)) = next else { return here };
        let gain = here.squares - better.squares;
        (here, residuals, columns) = (better, new_residuals, new_columns);
        if gain <= 1e-13 * here.squares {
            return here;
        }
    }
    here
}

fn moved(fit: &Fit, step: &DVector<f64>, share: f64, line: bool, with_tilt: bool) -> Fit {
    let axes = if line { 1 } else { 2 };
    let mut moved = *fit;
    for (axis, value) in moved.centre.iter_mut().enumerate().take(axes) {
        *value += share * step.get(axis).copied().unwrap_or(0.0);
    }
    if with_tilt {
        for (axis, value) in moved.tilt.iter_mut().enumerate().take(axes) {
            *value += share * step.get(axes + axis).copied().unwrap_or(0.0);
        }
    }
    moved
}

/// Residuals from the rings, and how they fall with centre and tilt, both orthogonal to the rings.
fn linearised(points: &[[f64; 3]], fit: &Fit, line: bool, with_tilt: bool) -> Option<(DVector<f64>, DMatrix<f64>)> {
    let axes = if line { 1 } else { 2 };
    let count = if with_tilt { 2 * axes } else { axes };
    let mut order: Vec<(f64, &[f64; 3])> = points.iter().map(|point| (distance(point, fit.centre), point)).collect();
    order.sort_by(|first, second| first.0.total_cmp(&second.0));
    let rings = rings_of(points.len());
    let mut residuals = DVector::zeros(points.len());
    let mut columns = DMatrix::zeros(points.len(), count);
    for ring in 0..rings {
        let (from, to) = (ring * points.len() / rings, (ring + 1) * points.len() / rings);
        let members = order.get(from..to)?;
        let squares: Vec<f64> = members.iter().map(|(r, _)| r * r).collect();
        let (heights, slope) = without_line(&squares, members.iter().map(|(_, point)| fit.levelled(point)).collect());
        residuals.as_mut_slice().get_mut(from..to)?.copy_from_slice(&heights);
        for column in 0..count {
            let axis = column % axes;
            let along = |point: &[f64; 3]| point.get(axis).zip(fit.centre.get(axis)).map_or(0.0, |(own, centre)| own - centre);
            // Of the function of r², and of the tilt, which turns about the centre.
            let factor = if column < axes { -2.0 * slope } else { 1.0 };
            let (values, _) = without_line(&squares, members.iter().map(|(_, point)| factor * along(point)).collect());
            for (offset, value) in values.into_iter().enumerate() {
                *columns.get_mut((from + offset, column))? = value;
            }
        }
    }
    if with_tilt {
        explained_tilts_left_out(&mut columns, axes);
    }
    residuals.iter().all(|value| value.is_finite()).then_some((residuals, columns))
}

/// A tilt that a shift of the centre explains is no column of its own.
fn explained_tilts_left_out(columns: &mut DMatrix<f64>, axes: usize) {
    for axis in 0..axes {
        let (shift, tilt) = (columns.column(axis).clone_owned(), columns.column(axes + axis).clone_owned());
        let own = shift.norm_squared();
        let rest = if own > 0.0 { &tilt - &shift * (shift.dot(&tilt) / own) } else { tilt.clone() };
        if rest.norm_squared() <= EXPLAINED * tilt.norm_squared() {
            columns.column_mut(axes + axis).fill(0.0);
        }
    }
}

/// Values without the straight line in `x` nearest to them, and its slope.
fn without_line(x: &[f64], values: Vec<f64>) -> (Vec<f64>, f64) {
    let count = x.len() as f64;
    let (middle, mean) = (x.iter().sum::<f64>() / count, values.iter().sum::<f64>() / count);
    let (mut both, mut square) = (0.0, 0.0);
    for (x, value) in x.iter().zip(&values) {
        both += (x - middle) * (value - mean);
        square += (x - middle) * (x - middle);
    }
    let slope = if square > 0.0 { both / square } else { 0.0 };
    (x.iter().zip(values).map(|(x, value)| value - mean - slope * (x - middle)).collect(), slope)
}

/// The least-squares solution of few unknowns; none without numbers. Columns of zeros are left out.
fn normal(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let square = matrix.tr_mul(matrix);
    let scale: Vec<f64> = square.diagonal().iter().map(|value| if *value > 0.0 { value.sqrt().recip() } else { 0.0 }).collect();
    let at = |index: usize| scale.get(index).copied().unwrap_or(0.0);
    let scaled = DMatrix::from_fn(square.nrows(), square.ncols(), |row, column| {
        square.get((row, column)).map_or(0.0, |value| value * at(row) * at(column))
    });
    let projected = DVector::from_iterator(scale.len(), matrix.tr_mul(right).iter().zip(&scale).map(|(value, scale)| value * scale));
    let solution = scaled.svd(true, true).solve(&projected, 1e-13).ok()?;
    let solution = DVector::from_iterator(scale.len(), solution.iter().zip(&scale).map(|(value, scale)| value * scale));
    solution.iter().all(|value| value.is_finite()).then_some(solution)
}
