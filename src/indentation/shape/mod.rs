//! A shape given by points, as a profilometer measures it, and its line profile.
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | r, z | distance from the axis, and height of the shape above its lowest point | m |
//! | f(s) | line profile, s∫₀^s z′/√(s² − r²) dr | m |
//!
//! Between the points z is a cubic that rises; the slopes at the points are those of the spline with a continuous second derivative, cut back where
//! they leave the range of the secants beside them, or are so steep that a cubic would not rise (Fritsch and Carlson,
//! [10.1137/0717021](https://doi.org/10.1137/0717021)). On the axis the shape is even in r, z′ = 0, unless
//! the first points say that it has a sharp tip. f and f′ are then exact integrals ([`abel`]); because f has a weak root singularity at each
//! point, (s − r_i)^{5/2}, they are kept as Chebyshev series in √(s − r_i) from point to point ([`series`]), to rounding.

mod abel;
mod series;
mod slopes;

use super::row::Row;
use crate::refusal::{Refusal, require_finite, require_positive};
use crate::special::gauss_legendre::UNIT_RULE_20;
use abel::Piece;
use series::Series;
use std::sync::OnceLock;

/// Fewer points have no smooth shape.
const FEWEST: usize = 4;
/// More points than these take more than a second to transform; a profile is smooth enough to be thinned.
const MOST: usize = 2000;
/// A break this near to an end of a panel, relative, is left out.
const CLEARANCE: f64 = 1e-9;

/// ∫f from a point on: in the root of the way, where f is smooth.
fn integral(series: &Series, from: f64, to: f64) -> f64 {
    let root = (to - from).max(0.0).sqrt();
    UNIT_RULE_20.iter().map(|(x, weight)| weight * 2.0 * root * root * x * series.value(from + (root * x).powi(2))).sum()
}

/// An axisymmetric shape z(r) through points, and its line profile. Cheap to share in an `Arc`.
#[derive(Debug, Clone)]
pub struct TabulatedShape {
    /// Of the last point (m): inside, all lengths are in it.
    end: f64,
    /// z of the last point (m).
    height: f64,
    /// r_i over `end`, from 0 to 1.
    knots: Vec<f64>,
    series: Series,
    /// ∫f up to every point, once it is asked for.
    volumes: OnceLock<Vec<f64>>,
}

impl PartialEq for TabulatedShape {
    /// The integrals follow from the rest.
    fn eq(&self, other: &Self) -> bool {
        self.end.to_bits() == other.end.to_bits()
            && self.height.to_bits() == other.height.to_bits()
            && self.knots == other.knots
            && self.series == other.series
    }
}

impl TabulatedShape {
    /// The shape through points (r, z) (m): the first is (0, 0), both numbers rise from point to point, and there are 4 to 2000.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for points that are not so; [`Refusal::NotConverged`] for points too uneven for a line profile that might fall;
    /// [`Refusal::NoSuchState`] for a shape that flattens outwards so much that its line profile
    /// falls: its contact would not be one circle.
    pub fn through(points: &[(f64, f64)]) -> Result<Self, Refusal> {
        if points.len() < FEWEST || points.len() > MOST {
            return Err(Refusal::out_of_range("number of points of a shape", points.len() as f64, "4 to 2000"));
        }
        let mut before: Option<(f64, f64)> = None;
        for &(r, z) in points {
            require_finite("radius of a point of a shape", r)?;
            require_finite("height of a point of a shape", z)?;
            match before {
                None if r != 0.0 => return Err(Refusal::out_of_range("radius of the first point of a shape", r, "0")),
                None if z != 0.0 => return Err(Refusal::out_of_range("height of the first point of a shape", z, "0")),
                Some((last, _)) if r <= last => {
                    return Err(Refusal::out_of_range("radius of a point of a shape", r, "larger than that of the point before"));
                }
                Some((_, last)) if z <= last => {
                    return Err(Refusal::out_of_range("height of a point of a shape", z, "larger than that of the point before"));
                }
                _ => {}
            }
            before = Some((r, z));
        }
        let (end, height) = before.unwrap_or_default();
        require_positive("mean slope of a shape", height / end)?;
        let knots: Vec<f64> = points.iter().map(|point| point.0 / end).collect();
        let heights: Vec<f64> = points.iter().map(|point| point.1 / height).collect();
        let rises = |values: &[f64]| values.windows(2).all(|pair| pair[1] > pair[0]);
        if !rises(&knots) || !rises(&heights) {
            return Err(Refusal::out_of_range("points of a shape", end, "further apart: they cannot be distinguished from one another"));
        }
        let slopes = slopes::rising(&knots, &heights);
        let series = Series::of(Piece::all(&knots, &heights, &slopes))?;
        if let Some(place) = series.falls_at()? {
            return Err(Refusal::NoSuchState {
                reason: "the shape flattens outwards so much that its contact would not be one circle".into(),
                limit_name: "the radius at which its line profile falls",
                limit: place * end,
            });
        }
        Ok(Self { end, height, knots, series, volumes: OnceLock::new() })
    }

    /// The radius of the last point (m): beyond it there is no shape.
    #[must_use]
    pub const fn reach(&self) -> f64 {
        self.end
    }

    /// z (m) at a radius (m) within the shape; that of the last point beyond it.
    #[must_use]
    pub fn height(&self, r: f64) -> f64 {
        let x = (r / self.end).clamp(0.0, 1.0);
        self.series.piece(x).map_or(0.0, |piece| piece.height(x)) * self.height
    }

    /// z′ at a radius (m) within the shape; that of the last point beyond it.
    #[must_use]
    pub fn slope(&self, r: f64) -> f64 {
        let x = (r / self.end).clamp(0.0, 1.0);
        self.series.piece(x).map_or(0.0, |piece| piece.slope(x)) * (self.height / self.end)
    }

    /// f(s) (m). Beyond the last point f goes on as a parabola, for trials of a search only.
    pub(crate) fn line(&self, s: f64) -> f64 {
        self.series.value(s / self.end) * self.height
    }

    /// The same at eight places in rising order.
    pub(super) fn line_row(&self, places: &Row) -> Row {
        self.series.values(&places.map(|s| s / self.end)).map(|value| value * self.height)
    }

    /// f′(s).
    pub(crate) fn line_slope(&self, s: f64) -> f64 {
        self.series.slope(s / self.end) * (self.height / self.end)
    }

    /// The s (m) between two places at which f has a value: Newton's steps, halved where they leave the bracket.
    pub(super) fn inverse(&self, value: f64, one: f64, other: f64) -> f64 {
        let (mut low, mut high) = (one.min(other), one.max(other));
        let mut s = 0.5 * (low + high);
        for _ in 0..100 {
            let excess = self.line(s) - value;
            if excess < 0.0 {
                low = s
            } else {
                high = s
            }
            let newton = s - excess / self.line_slope(s);
            let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
            if (next - s).abs() <= f64::EPSILON * high {
                return next;
            }
            s = next;
        }
        s
    }

    /// The points (m) between two places, clear of both.
    pub(crate) fn knots(&self, low: f64, high: f64) -> Vec<f64> {
        let (from, to) = (low / self.end * (1.0 + CLEARANCE), high / self.end * (1.0 - CLEARANCE));
        let [first, last] = [from, to].map(|end| self.knots.partition_point(|knot| *knot <= end));
        self.knots.get(first..last).unwrap_or(&[]).iter().filter(|knot| **knot > 0.0).map(|knot| knot * self.end).collect()
    }

    /// Places (m) beyond which f has a root more, and its factors: b·h^{3/2} + c·h^{5/2} at h (m) beyond the place, from jumps of z″ and z‴.
    pub(super) fn roots(&self) -> Vec<(f64, [f64; 2])> {
        let of = |pair: &[Piece]| {
            let [before, piece] = pair else { return None };
            let [second, third] = piece.jumps(before);
            let scale = self.height * (0.5 * piece.low).sqrt();
            let factors = [4.0 / 3.0 * scale * second / self.end.powf(1.5), 16.0 / 15.0 * scale * third / self.end.powf(2.5)];
            Some((piece.low * self.end, factors))
        };
        self.series.pieces().windows(2).filter_map(of).collect()
    }

    fn volumes_of_points(&self) -> Vec<f64> {
        let mut volumes = vec![0.0];
        for pair in self.knots.windows(2) {
            let before = volumes.last().copied().unwrap_or(0.0);
            volumes.push(before + integral(&self.series, pair[0], pair[1]));
        }
        volumes
    }

    /// ∫₀^s f ds′ (m²).
    pub(crate) fn volume(&self, s: f64) -> f64 {
        let x = s / self.end;
        let index = self.knots.partition_point(|knot| *knot <= x.min(1.0)).saturating_sub(1);
        let from = self.knots.get(index).copied().unwrap_or(0.0);
        let before = self.volumes.get_or_init(|| self.volumes_of_points()).get(index).copied().unwrap_or(0.0);
        (before + integral(&self.series, from, x)) * self.height * self.end
    }

    /// 0, the points below a place (m), and the place: between them f is smooth.
    pub(super) fn breaks(&self, end: f64) -> Vec<f64> {
        let inner = self.knots.iter().map(|knot| knot * self.end).filter(|knot| *knot > 0.0 && *knot < end * (1.0 - CLEARANCE));
        std::iter::once(0.0).chain(inner).chain(std::iter::once(end)).collect()
    }
}
