//! Means over rings that rise outwards: isotonic regression of levelled heights.
//!
//! Neighbouring rings whose means fall are pooled, which gives the rising sequence nearest to the means in least squares (Ayer et al. 1955,
//! [10.1214/aoms/1177728423](https://doi.org/10.1214/aoms/1177728423)). The number of rings is the largest of a list at which few are pooled and the
//! contact of the shape is one circle.

use super::touches;
use crate::indentation::shape::TabulatedShape;
use crate::refusal::Refusal;

/// Numbers of rings that are tried, after every radius by itself.
const RINGS: [usize; 10] = [96, 64, 48, 32, 24, 16, 12, 8, 6, 4];
/// More radii than these are always averaged.
const MOST_RADII: usize = 300;
/// Radii this near to each other, over the largest, are one.
const SAME: f64 = 1e-9;
/// The share of rings that may be pooled.
const POOLED: f64 = 0.25;
/// Points that the height of the apex follows from, at least.
const AT_THE_APEX: usize = 5;

/// Points that rise from (0, 0), and the height that was taken off.
pub(super) struct Found {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) apex_height: f64,
}

/// The mean of some points.
#[derive(Debug, Clone, Copy)]
struct Ring {
    /// Mean of r².
    square: f64,
    height: f64,
    points: f64,
}

/// The shape of levelled points (r, h).
pub(super) fn rising_shape(points: &[(f64, f64)], line: bool) -> Result<(TabulatedShape, Found), Refusal> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|first, second| first.0.total_cmp(&second.0));
    let reach = sorted.last().map_or(0.0, |point| point.0);
    let mut flattens = false;
    let single = single_radii(&sorted, SAME * reach);
    if single.len() <= MOST_RADII {
        match shape(&sorted, &single) {
            Ok((made, found, 0)) => return Ok((made, found)),
            Ok(_) => {}
            Err(_) => flattens = true,
        }
    }
    // At least two points of a line, one on each side, make a ring.
    let least = if line { 2 } else { 3 };
    for count in RINGS.into_iter().filter(|count| count * least <= sorted.len()) {
        match shape(&sorted, &equal_rings(&sorted, count)) {
            Ok((made, found, pooled)) if pooled as f64 <= POOLED * count as f64 => return Ok((made, found)),
            Ok(_) => {}
            Err(_) => flattens = true,
        }
    }
    Err(Refusal::NoSuchState {
        reason: if flattens {
            "the means over its rings flatten outwards so much that the contact of the shape would not be one circle".into()
        } else {
            "the means over its rings do not rise from the apex outwards".into()
        },
        limit_name: "the fewest rings that were tried",
        limit: 4.0,
    })
}

/// A shape of rings, and how many were pooled.
fn shape(sorted: &[(f64, f64)], rings: &[Ring]) -> Result<(TabulatedShape, Found, usize), Refusal> {
    let (found, pooled) = rising(apex(sorted), rings);
    Ok((touches(&found.points)?, found, pooled))
}

/// Points of one radius each.
fn single_radii(sorted: &[(f64, f64)], same: f64) -> Vec<Ring> {
    let mut rings: Vec<Ring> = Vec::new();
    let mut first = f64::NEG_INFINITY;
    for &(r, height) in sorted {
        match rings.last_mut() {
            Some(ring) if r - first <= same => {
                ring.height += (height - ring.height) / (ring.points + 1.0);
                ring.points += 1.0;
            }
            _ => {
                first = r;
                rings.push(Ring { square: r * r, height, points: 1.0 });
            }
        }
    }
    rings
}

/// Rings of equal numbers of points: means, and the outer end of the last one on its straight line in r².
fn equal_rings(sorted: &[(f64, f64)], count: usize) -> Vec<Ring> {
    let mut rings = Vec::with_capacity(count + 1);
    for index in 0..count {
        let Some(members) = sorted.get(index * sorted.len() / count..(index + 1) * sorted.len() / count) else { continue };
        let points = members.len() as f64;
        let square = members.iter().map(|(r, _)| r * r).sum::<f64>() / points;
        let height = members.iter().map(|(_, h)| h).sum::<f64>() / points;
        rings.push(Ring { square, height, points });
        if index + 1 == count
            && let Some((end, _)) = members.last()
        {
            let (height, _) = straight(members, |r| r * r, end * end);
            rings.push(Ring { square: end * end, height, points: 1.0 });
        }
    }
    rings
}

/// The value at `place` of the line in `of(r)` nearest to the heights, and the sum of squares that is left.
fn straight(members: &[(f64, f64)], of: impl Fn(f64) -> f64, place: f64) -> (f64, f64) {
    let count = members.len() as f64;
    let middle = members.iter().map(|(r, _)| of(*r)).sum::<f64>() / count;
    let mean = members.iter().map(|(_, h)| h).sum::<f64>() / count;
    let (mut both, mut square) = (0.0, 0.0);
    for (r, h) in members {
        both += (of(*r) - middle) * (h - mean);
        square += (of(*r) - middle).powi(2);
    }
    let slope = if square > 0.0 { both / square } else { 0.0 };
    let left = members.iter().map(|(r, h)| (h - mean - slope * (of(*r) - middle)).powi(2)).sum();
    (mean + slope * (place - middle), left)
}

/// The height of the apex: of a smooth or a sharp tip, whichever the inner points are nearer to.
fn apex(sorted: &[(f64, f64)]) -> f64 {
    let inner = sorted.get(..AT_THE_APEX.max(sorted.len() / 16).min(sorted.len())).unwrap_or(sorted);
    let (smooth, left) = straight(inner, |r| r * r, 0.0);
    let (sharp, left_of_sharp) = straight(inner, |r| r, 0.0);
    if left_of_sharp < left { sharp } else { smooth }
}

/// Points that rise from the apex, and how many rings had to be pooled.
fn rising(apex: f64, rings: &[Ring]) -> (Found, usize) {
    let mut blocks: Vec<Ring> = vec![Ring { square: 0.0, height: apex, points: 1.0 }];
    let mut pooled = 0;
    for ring in rings {
        // A point on the axis is the apex.
        let mut next = *ring;
        while let Some(last) = blocks.pop_if(|last| last.height >= next.height || last.square >= next.square) {
            let points = last.points + next.points;
            let mean = |of: fn(&Ring) -> f64| (of(&last) * last.points + of(&next) * next.points) / points;
            pooled += usize::from(next.square > 0.0);
            next = Ring { square: mean(|ring| ring.square), height: mean(|ring| ring.height), points };
        }
        blocks.push(next);
    }
    let apex_height = blocks.first().map_or(apex, |first| first.height);
    let mut points = vec![(0.0, 0.0)];
    points.extend(blocks.iter().skip(1).map(|ring| (ring.square.sqrt(), ring.height - apex_height)));
    (Found { points, apex_height }, pooled)
}
