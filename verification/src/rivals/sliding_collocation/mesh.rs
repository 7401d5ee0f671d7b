//! Non-uniform meshes of an arc whose elements shrink towards both ends (thesis Eqs 3.26–3.34).
//!
//! ```text
//! uniform ζ_l = −α + 2αl/N   ─►   z_l = (1/C) ∫₀^{ζ_l} [cos ξ − cos α]ⁿ dξ,   C so that the ends are mapped on themselves
//! ```
//! Near an end the distance of node l grows as l^{n+1} (as l^{2n+1} where α is close to π): n = ½ is the least the thesis allows for 1/√d. Every node is known
//! by its distances to BOTH ends, so that elements of 1e-12 next to an end are as accurate as those in the middle.

use viscotack::refusal::{Refusal, require_positive};
use viscotack::sliding::contact::ArcPoint;
use viscotack::special::gauss_legendre::UNIT_RULE;

/// The least exponent n the thesis allows (3.32).
const LEAST_DENSITY: f64 = 0.5;
/// A mesh with fewer elements has no interior.
const FEWEST_ELEMENTS: usize = 4;

/// One element: where it begins and ends, and its midpoint, the collocation point (3.28).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Element {
    /// The end on the side of the trailing edge, z_{l−1}.
    pub low: ArcPoint,
    /// The end on the side of the leading edge, z_l.
    pub high: ArcPoint,
    /// ξ_l.
    pub middle: ArcPoint,
    /// h_l (3.29), in 1/k.
    pub width: f64,
}

/// x_p − x_q of two points of one arc, by the end that is nearer to both.
#[must_use]
pub fn separation(p: ArcPoint, q: ArcPoint) -> f64 {
    let leading_half = |point: ArcPoint| point.from_leading < point.from_trailing;
    if leading_half(p) && leading_half(q) { q.from_leading - p.from_leading } else { p.from_trailing - q.from_trailing }
}

/// The point of the arc that reaches `trailing` and `leading` farther (negative: less far).
#[must_use]
pub fn widened(point: ArcPoint, trailing: f64, leading: f64) -> ArcPoint {
    ArcPoint { from_trailing: point.from_trailing + trailing, from_leading: point.from_leading + leading }
}

/// The N + 1 nodes of an arc of `length` (1/k) with the density exponent n of (3.32).
///
/// # Errors
/// [`Refusal::OutOfRange`] for a length that is not positive or beyond a period, n < ½ or N < 4.
pub fn mapped_nodes(length: f64, elements: usize, density: f64) -> Result<Vec<ArcPoint>, Refusal> {
    require_positive("length", length)?;
    if length > std::f64::consts::TAU {
        return Err(Refusal::out_of_range("length", length, "at most 2π (in 1/k), one period"));
    }
    if !(density.is_finite() && density >= LEAST_DENSITY) {
        return Err(Refusal::out_of_range("density", density, "finite and at least 1/2 (3.32)"));
    }
    if elements < FEWEST_ELEMENTS {
        return Err(Refusal::out_of_range("elements", elements as f64, "at least 4"));
    }
    let distances = distances_to_end(length, elements, density);
    let near = |index: usize| distances.get(index).copied().unwrap_or(0.5 * length);
    Ok((0..=elements)
        .map(|index| {
            if 2 * index <= elements {
                let from_trailing = near(index);
                ArcPoint { from_trailing, from_leading: length - from_trailing }
            } else {
                let from_leading = near(elements - index);
                ArcPoint { from_trailing: length - from_leading, from_leading }
            }
        })
        .collect())
}

/// Distances of the nodes 0 … N/2 to their end.
fn distances_to_end(length: f64, elements: usize, density: f64) -> Vec<f64> {
    // cos(α − u) − cos α = 2 sin(α − u/2) sin(u/2), u the distance to the end before mapping; u = v² takes the root of n = ½.
    let density_between = |from: f64, to: f64| -> f64 {
        let (low, high) = (from.sqrt(), to.sqrt());
        let sum = UNIT_RULE.iter().map(|&(node, weight)| {
            let v = low + (high - low) * node;
            let half = 0.5 * v * v;
            weight * 2.0 * v * (2.0 * (0.5 * length - half).sin() * half.sin()).powf(density)
        });
        (high - low) * sum.sum::<f64>()
    };
    let at = |index: usize| length * index as f64 / elements as f64;
    let mut total = 0.0;
    let mut distances = vec![0.0];
    for index in 1..=elements / 2 {
        total += density_between(at(index - 1), at(index));
        distances.push(total);
    }
    if elements % 2 == 1 {
        total += density_between(at(elements / 2), 0.5 * length);
    }
    distances.iter().map(|distance| 0.5 * length * distance / total).collect()
}

/// The elements between consecutive nodes.
#[must_use]
pub fn elements_between(nodes: &[ArcPoint]) -> Vec<Element> {
    nodes
        .windows(2)
        .filter_map(|pair| match pair {
            [low, high] => {
                let middle = ArcPoint {
                    from_trailing: 0.5 * (low.from_trailing + high.from_trailing),
                    from_leading: 0.5 * (low.from_leading + high.from_leading),
                };
                Some(Element { low: *low, high: *high, middle, width: separation(*high, *low) })
            }
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn nodes_are_symmetric_reach_both_ends_and_shrink_as_the_exponent_says() {
        for (length, elements, density) in [(2.2, 40, 0.5), (3.0, 41, 1.0), (1e-3, 400, 3.0)] {
            let nodes = mapped_nodes(length, elements, density).unwrap();
            assert_eq!(nodes.len(), elements + 1);
            for (node, mirrored) in nodes.iter().zip(nodes.iter().rev()) {
                assert!((node.from_trailing - mirrored.from_leading).abs() <= 1e-15 * length);
                assert!((node.from_trailing + node.from_leading - length).abs() <= 1e-15 * length);
            }
            let all = elements_between(&nodes);
            assert!(all.iter().all(|element| element.width > 0.0));
            assert!((all.iter().map(|element| element.width).sum::<f64>() / length - 1.0).abs() < 1e-13);
            // The first two nodes: distances as 1 to 2^{n+1}, up to the curvature of the cosine.
            let growth = (nodes[2].from_trailing / nodes[1].from_trailing).log2() - (density + 1.0);
            assert!(growth.abs() < 0.15, "n = {density}: {growth}");
        }
    }

    #[test]
    fn meshes_that_mean_nothing_are_refused() {
        for (length, elements, density) in
            [(0.0, 40, 1.0), (7.0, 40, 1.0), (1.0, 3, 1.0), (1.0, 40, 0.4), (f64::NAN, 40, 1.0), (1.0, 40, f64::NAN)]
        {
            assert!(mapped_nodes(length, elements, density).is_err());
        }
    }
}
