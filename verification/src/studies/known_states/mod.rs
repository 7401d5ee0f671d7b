//! States that are known before they are solved: edges, speeds and times are drawn, and the load and the work of adhesion that they take are computed by another
//! route than the solver's. A scene made of them has an answer, so that refusing it is wrong, too.
//!
//! | problem | drawn | what it takes, by |
//! |---|---|---|
//! | [`sliding`] | both edges, load, speed, spectrum | the partial-fraction form of the spectral reduction ([`partial_fractions`]), other integrals and another linear system |
//! | [`crack`] | time in which the zone is crossed, spectrum | the double integrals as printed ([`crate::rivals::raw_crack_work`]) |
//! | [`delayed`] | time of the start, place of the tip in its first two zones | Eq 5.66 and the delay equation in closed form; a geometric series for load cycles |
//! | [`sphere`] | contact radius and depth; a ramp and a dwell without adhesion | textbook fields of a sphere on an elastic half-space; Lee and Radok's integral by Dawson's function |

pub mod crack;
pub mod delayed;
pub mod partial_fractions;
pub mod sliding;
pub mod sphere;

use viscotack::special::gauss_legendre::UNIT_RULE_20;

/// ∫f over [low, high] by twenty Gauss nodes in each piece between the breaks.
pub(super) fn integrated(breaks: &[f64], mut f: impl FnMut(f64) -> f64) -> f64 {
    breaks
        .windows(2)
        .filter_map(|pair| if let [low, high] = *pair { Some((low, high)) } else { None })
        .filter(|(low, high)| high > low)
        .map(|(low, high)| (high - low) * UNIT_RULE_20.iter().map(|&(node, weight)| weight * f(low + (high - low) * node)).sum::<f64>())
        .sum()
}

/// (1/2δ)∫ tension(d)·gap(δ − d) dd with d = δ sin²ψ, which takes the root singularities of both away; pieces halve towards both ends down to the thinnest layer.
pub(super) fn zone_work(zone: f64, thinnest: f64, mut tension: impl FnMut(f64) -> f64, mut gap: impl FnMut(f64) -> f64) -> f64 {
    let quarter = std::f64::consts::FRAC_PI_4;
    let finest = (0.05 * thinnest / zone).sqrt().min(1.0);
    let mut near = vec![quarter];
    while near.last().is_some_and(|last| *last > quarter * finest) && near.len() < 24 {
        near.push(near.last().map_or(0.0, |last| 0.5 * last));
    }
    near.push(0.0);
    near.reverse();
    let far = near.iter().rev().skip(1).map(|angle| 2.0 * quarter - angle);
    let breaks: Vec<f64> = near.iter().copied().chain(far).collect();
    let integral = integrated(&breaks, |angle| {
        let (sine, cosine) = angle.sin_cos();
        tension(zone * sine * sine) * gap(zone * cosine * cosine) * 2.0 * zone * sine * cosine
    });
    0.5 * integral / zone
}
