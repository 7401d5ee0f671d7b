//! A measured scan of an indenter, a line or a map, made an axisymmetric shape: levelled, centred, averaged over rings.
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | x, y, z | place and height of a point of the scan; y = 0 on a line | m |
//! | c, t | centre of the shape, and tilt of the scan (a slope) | m; 1 |
//! | r | distance from the centre | m |
//! | h | height above the apex, z − t·(x − c) from there on | m |
//!
//! Centre and tilt make both sides, or all directions, as equal as they can be: they minimise the sum of the squared distances of z from a function of r alone
//! plus a tilt (module `centre`). A tilted paraboloid is a paraboloid with another apex, so a tilt is only taken out where that
//! lowers the sum by more than noise would. The shape is the mean of h over rings, made to rise (module `rings`).

mod centre;
mod rings;

use super::shape::TabulatedShape;
use crate::refusal::{Refusal, require_finite};
use centre::Fit;

/// Fewer points hold no centre and no shape.
pub const FEWEST_POINTS: usize = 8;
/// How often the points that the shape is made of are chosen anew after the centre has moved.
const ROUNDS: usize = 4;
/// A point this much beyond the reach, relative, is a rounding.
const ROUNDING: f64 = 1e-6;

/// Which point of a scan is the apex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Apex {
    /// The lowest one: the heights rise from it, as in a scan of an indenter that points down.
    Lowest,
    /// The highest one: the indenter points up.
    Highest,
}

/// What is known of a scan beforehand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScanOptions {
    /// Which point is the apex; none: the lowest one if the scan is curved upwards as a whole, else the highest one.
    pub apex: Option<Apex>,
    /// The largest distance from the centre that belongs to the shape (m); none: as far as all sides reach.
    pub to: Option<f64>,
    /// The largest root mean square of the residual over the height of the shape.
    pub largest_residual: f64,
}

/// The shape of a scan.
#[derive(Debug, Clone, PartialEq)]
pub struct ScannedShape {
    /// (r, h) (m), from (0, 0) on; both rise.
    pub points: Vec<(f64, f64)>,
    /// Which point is the apex.
    pub apex: Apex,
    /// Whether the points are spread in both directions.
    pub map: bool,
    /// c (m), in the coordinates of the scan.
    pub centre: [f64; 2],
    /// t, in the sense of the scan; zero where the scan shows none.
    pub tilt: [f64; 2],
    /// Root mean square of the distances of the scan from the shape (m).
    pub residual: f64,
    /// The largest of them (m).
    pub largest_residual: f64,
    /// Points of the scan within the reach of the shape.
    pub used: usize,
    /// All points of the scan as (r, h) (m), r negative on the side of smaller x.
    pub levelled: Vec<(f64, f64)>,
}

impl ScannedShape {
    /// The height of the last point over the first (m).
    #[must_use]
    pub fn height(&self) -> f64 {
        self.points.last().map_or(0.0, |point| point.1)
    }

    /// The radius of the last point (m).
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.points.last().map_or(0.0, |point| point.0)
    }
}

/// The axisymmetric shape of points (x, y, z) (m) in any order.
///
/// # Errors
/// [`Refusal::OutOfRange`] for fewer than 8 points or numbers that are not finite; [`Refusal::NoSuchState`] if the scan has no apex inside, flattens
/// outwards, or differs from an axisymmetric shape by more than `largest_residual`.
pub fn axisymmetric(points: &[[f64; 3]], options: &ScanOptions) -> Result<ScannedShape, Refusal> {
    if points.len() < FEWEST_POINTS {
        return Err(Refusal::out_of_range("number of points of a scan", points.len() as f64, "8 or more"));
    }
    for value in points.iter().flatten() {
        require_finite("a coordinate of a scan", *value)?;
    }
    let frame = Frame::of(points)?;
    let mut own: Vec<[f64; 3]> = points.iter().map(|point| frame.inwards(*point)).collect();
    let lines = own.iter().all(|point| point[1] == 0.0);
    let (curvature, mut middle) = centre::parabola(&own, lines)?;
    let apex = options.apex.unwrap_or(if curvature > 0.0 { Apex::Lowest } else { Apex::Highest });
    if apex == Apex::Highest {
        own.iter_mut().for_each(|point| point[2] = -point[2]);
    }
    let wanted = options.to.map(|to| to / frame.width);
    let mut fit = Fit::at(middle);
    let mut used = Vec::new();
    for _ in 0..ROUNDS {
        let reach = wanted.unwrap_or(f64::INFINITY).min(centre::reach(&own, middle, lines));
        used = own.iter().copied().filter(|point| distance(point, middle) <= reach * (1.0 + ROUNDING)).collect();
        if used.len() < FEWEST_POINTS {
            return Err(Refusal::NoSuchState {
                reason: "the apex is not inside the scan: both sides of it are needed".into(),
                limit_name: "points on both sides",
                limit: used.len() as f64,
            });
        }
        // The parabola of what belongs to the shape starts the search nearer than that of the whole scan.
        let start = centre::parabola(&used, lines).map_or(middle, |(_, own)| if distance_of(own, middle) < 0.5 { own } else { middle });
        fit = centre::fit(&used, start, lines);
        let moved = distance_of(fit.centre, middle);
        middle = fit.centre;
        if moved < ROUNDING {
            break;
        }
    }
    let reach = centre::reach(&own, fit.centre, lines);
    if let Some(wanted) = wanted.filter(|wanted| *wanted > reach * (1.0 + ROUNDING)) {
        return Err(Refusal::NoSuchState {
            reason: format!("the shape shall end at {:.4e}, and not all sides of the scan reach so far", wanted * frame.width),
            limit_name: "where the nearest side ends",
            limit: reach * frame.width,
        });
    }
    let levelled: Vec<(f64, f64)> = used.iter().map(|point| (distance(point, fit.centre), fit.levelled(point))).collect();
    let (shape, found) = rings::rising_shape(&levelled, lines)?;
    let residuals = || levelled.iter().map(|(r, h)| h - found.apex_height - shape.height(*r));
    let residual = (residuals().map(|residual| residual * residual).sum::<f64>() / levelled.len() as f64).sqrt();
    let most = residuals().fold(0.0, |most: f64, residual| most.max(residual.abs()));
    let height = found.points.last().map_or(0.0, |point| point.1);
    if residual.is_nan() || residual > options.largest_residual * height {
        return Err(Refusal::NoSuchState {
            reason: format!(
                "the scan differs from a round shape that rises by {:.1} % of its height (root mean square)",
                100.0 * residual / height
            ),
            limit_name: "the largest residual over the height",
            limit: options.largest_residual,
        });
    }
    let sign = if apex == Apex::Highest { -1.0 } else { 1.0 };
    let slope = sign * frame.height / frame.width;
    let all = own.iter().map(|point| {
        let side = if point[0] < fit.centre[0] { -1.0 } else { 1.0 };
        (side * distance(point, fit.centre) * frame.width, (fit.levelled(point) - found.apex_height) * frame.height)
    });
    Ok(ScannedShape {
        points: found.points.iter().map(|(r, h)| (r * frame.width, h * frame.height)).collect(),
        apex,
        map: !lines,
        centre: [0, 1].map(|axis| frame.outwards(fit.centre, axis)),
        tilt: fit.tilt.map(|tilt| tilt * slope),
        residual: residual * frame.height,
        largest_residual: most * frame.height,
        used: levelled.len(),
        levelled: all.collect(),
    })
}

/// Coordinates in which a scan is of the order of one.
struct Frame {
    middle: [f64; 3],
    width: f64,
    height: f64,
}

impl Frame {
    fn of(points: &[[f64; 3]]) -> Result<Self, Refusal> {
        let ends = |axis: usize| {
            points
                .iter()
                .filter_map(|point| point.get(axis))
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
        };
        let (x, y, z) = (ends(0), ends(1), ends(2));
        let (width, height) = (0.5 * (x.1 - x.0).max(y.1 - y.0), z.1 - z.0);
        if !(width > 0.0 && width.is_finite() && height > 0.0 && height.is_finite()) {
            return Err(Refusal::out_of_range("extent of a scan", width.min(height), "greater than 0 in width and height"));
        }
        // The middle of a line of one y is that y, to the bit.
        let middle = |ends: (f64, f64)| ends.0 + 0.5 * (ends.1 - ends.0);
        Ok(Self { middle: [middle(x), middle(y), z.0], width, height })
    }

    fn inwards(&self, point: [f64; 3]) -> [f64; 3] {
        [(point[0] - self.middle[0]) / self.width, (point[1] - self.middle[1]) / self.width, (point[2] - self.middle[2]) / self.height]
    }

    fn outwards(&self, centre: [f64; 2], axis: usize) -> f64 {
        centre.get(axis).zip(self.middle.get(axis)).map_or(0.0, |(own, middle)| own * self.width + middle)
    }
}

fn distance(point: &[f64; 3], centre: [f64; 2]) -> f64 {
    (point[0] - centre[0]).hypot(point[1] - centre[1])
}

fn distance_of(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

/// Whether a shape through points can touch along one circle; the reason if not.
fn touches(points: &[(f64, f64)]) -> Result<TabulatedShape, Refusal> {
    TabulatedShape::through(points)
}
