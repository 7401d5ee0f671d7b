//! What a converged panel is tested for: its defect between the points, and that its first point is the FIRST root.
//!
//! The closure has other roots: at a given place later instants at which it holds again. The path is the branch that starts at the last
//! point. So the panel is led there from a sudden move: its instants (its ways) are scaled by λ = 0…1 up to the first point, and C − Δγ
//! there must keep its sign for all λ < 1. An edge that recedes has too little work when it moves at once, one that advances too much; in
//! time the work comes up to Δγ, at λ = 1.

use super::closure::{Way, Window};
use super::drive::Instant;
use super::line::{Segment, series};
use super::newton::{Panel, Target};
use super::path::{Chart, Points, Setting, passed};

#[derive(Debug, Clone, Copy)]
pub(super) struct Checked {
    /// Largest residual between points, as a position.
    pub(super) defect: f64,
    /// Furthest the edge went.
    pub(super) way: f64,
    pub(super) first: bool,
}

/// Parts of the way to the first point that are looked at; more of them where the residual is not monotone.
const PARTS: [f64; 4] = [0.0, 0.3, 0.6, 0.85];
const MORE_PARTS: usize = 24;
/// Residual over that at λ = 0 above which a sign counts, and the position, over the tolerance, that such a residual is: beside a turn, where all of them are small, the
/// roots are one within the tolerance.
const SIGN_NOISE: f64 = 1e-3;
const WITHIN: f64 = 0.1;

pub(super) fn checked(
    points: &Points,
    window: &mut Window,
    setting: &Setting<'_>,
    panel: &Panel,
    (target, tolerance): (Target, f64),
) -> Checked {
    let mut now = Instant::default();
    let mut at = |window: &mut Window, segment: &Segment, theta: f64| {
        setting.along(&segment.times, &segment.depths, theta, &mut now);
        let way = Way { panel: segment, advances: setting.advances, theta };
        setting.excess(window, Some(way), &now, false).value
    };
    let (nodes, p) = (&points.nodes, points.p);
    let mut defect: f64 = 0.0;
    // In every gap: a kink of the closure shows beside it only.
    for gap in 0..p {
        let theta = 0.5 * (nodes[gap] + nodes[gap + 1]);
        let residual = at(window, &panel.segment, theta) - target.at(theta, panel.segment.time_at(theta));
        defect = defect.max((residual / panel.stiffness).abs());
    }
    let way = nodes.iter().map(|&x| panel.segment.place_at(x).0.abs()).fold(0.0, f64::max);
    let target = target.at(nodes[1], panel.segment.time_at(nodes[1]));
    let noise = WITHIN * tolerance * panel.stiffness;
    let mut now = Instant::default();
    let mut sudden = |window: &mut Window, segment: &Segment| {
        setting.along(&segment.times, &segment.depths, 1.0, &mut now);
        let way = Some(Way { panel: segment, advances: setting.advances, theta: 1.0 });
        // A penetration that follows goes its way, and at the end at once to where its control wants it.
        let shift = setting.imbalance(way, &now);
        setting.shift(&mut now, shift);
        setting.excess(window, way, &now, false).value - target
    };
    let first = first_root(points, window, setting, panel, noise, &mut sudden);
    Checked { defect, way, first }
}

pub(super) fn first_root(
    points: &Points,
    window: &mut Window,
    setting: &Setting<'_>,
    panel: &Panel,
    noise: f64,
    at: &mut impl FnMut(&mut Window, &Segment) -> f64,
) -> bool {
    let theta = points.nodes[1];
    let (way, time) = (panel.segment.place_at(theta).0, panel.segment.time_at(theta));
    let sign = if setting.advances { 1.0 } else { -1.0 };
    if time <= 0.0 || way * sign <= 0.0 {
        // A fold or a turn comes first: the panel is cut before this point.
        return true;
    }
    let of_time = panel.chart == Chart::TimeOfPlace;
    // The way up to the first point as a panel of its own, in the same chart.
    let values = |part: f64| -> Vec<f64> {
        points
            .nodes
            .iter()
            .map(|&x| {
                let theta = -1.0 + 0.5 * (x + 1.0) * (theta + 1.0);
                part * if of_time { panel.segment.time_at(theta) } else { panel.segment.place_at(theta).0 }
            })
            .collect()
    };
    // Δ as it is, if it follows.
    let depths: Vec<f64> = if panel.segment.depths.is_empty() {
        Vec::new()
    } else {
        points.nodes.iter().map(|&x| series(&panel.segment.depths, -1.0 + 0.5 * (x + 1.0) * (theta + 1.0)).0).collect()
    };
    let span = if of_time { way } else { time };
    // Too little work ahead of the edge in place, too much in time: of the sign below until the root.
    let expected = if of_time { sign } else { -sign };
    let mut residual = |window: &mut Window, part: f64| {
        let part = if of_time { part } else { part.max(1e-9) };
        let segment = passed(points, setting, panel.chart, span, &values(part), &depths);
        expected * at(window, &segment)
    };
    let found: Vec<f64> = PARTS.iter().map(|&part| residual(window, part)).collect();
    let noise = noise.max(SIGN_NOISE * found[0].abs());
    let monotone = found.windows(2).all(|pair| pair[1] <= pair[0]);
    found.iter().all(|&value| value > -noise)
        && (monotone || (1..MORE_PARTS).all(|k| residual(window, 0.97 * k as f64 / MORE_PARTS as f64) > -noise))
}
