//! The nodes of the closure: the process zone on both sides of the edge, cut into pieces on which both fields are smooth.
//!
//! The window is cut at the borders of all segments, those outside mirrored; between two borders the integral runs in the parameter of the
//! segment that bends most, which removes the root at a turn of the edge, and the panel under way is followed in its own parameter, from
//! its start to the edge, forwards and backwards: so C is analytic through a turn, a fold or a corner of the history. Where a lag grows by
//! more than [`GROWTH`], the piece is cut towards the edge.

use super::chain::Chain;
use super::closure::{Node, Way, Window};
use super::drive::Instant;
use super::gauss::{Gauss, NODES};
use super::line::{FADED, Line, Segment, field};
use crate::indentation::Profile;

/// Growth of a lag over a piece: eight nodes then keep e^{−lag/τ} to 1e-10 of its value at lag 0, whatever the lag.
pub(super) const GROWTH: f64 = 3.0;
/// A piece narrower than this part of the zone is rounding.
const SLIVER: f64 = 1e-14;
/// Most cuts of one piece towards an edge.
pub(super) const MOST_CUTS: u32 = 60;

/// One piece of the window before it is cut: its segments, the one that leads (None: y itself) and its parameter at both ends.
#[derive(Clone, Copy)]
pub(super) struct Piece<'a> {
    pub(super) inner: &'a Segment,
    pub(super) outer: &'a Segment,
    /// The lead and whether it is inside.
    pub(super) lead: Option<bool>,
    pub(super) under_way: Option<bool>,
    pub(super) from: f64,
    pub(super) to: f64,
}

/// What all pieces share.
pub(super) struct Scene<'a> {
    pub(super) chain: &'a Chain,
    pub(super) profile: &'a Profile,
    pub(super) origin: f64,
    pub(super) edge: f64,
    pub(super) zone: f64,
    pub(super) now: &'a Instant,
}

impl Window {
    /// The part of the window beside the panel under way.
    pub(super) fn along(&mut self, scene: &Scene<'_>, line: &Line, way: Way<'_>, (from, to): (f64, f64), (low, high): (f64, f64)) {
        let inside = way.advances;
        let (edge, zone) = (scene.edge, scene.zone);
        // Borders of the other list, as y, from the start to the end.
        let mut borders: Vec<f64> = Vec::new();
        for segment in line.list(!inside) {
            for place in [segment.low, segment.high] {
                let y = if inside { zone - (place - edge) } else { edge - place };
                if y > low + SLIVER * zone && y < high - SLIVER * zone {
                    borders.push(y);
                }
            }
        }
        borders.extend(self.cuts(line, edge).filter(|y| *y > low + SLIVER * zone && *y < high - SLIVER * zone));
        borders.sort_by(f64::total_cmp);
        borders.dedup_by(|x, y| (*x - *y).abs() < SLIVER * zone);
        let mut theta = from;
        let mut y = low;
        for end in borders.into_iter().chain([high]) {
            let next = if (end - high).abs() <= 0.0 { to } else { way.panel.theta_at(if inside { edge - end } else { edge + zone - end }) };
            let middle = 0.5 * (y + end);
            let other = line.at(!inside, if inside { edge + zone - middle } else { edge - middle });
            let (inner, outer) = if inside { (way.panel, other) } else { (other, way.panel) };
            self.graded(scene, Piece { inner, outer, lead: Some(inside), under_way: Some(inside), from: theta, to: next });
            (theta, y) = (next, end);
        }
    }

    /// Breaks of the profile that eight nodes over the zone would miss, on both sides of an edge.
    fn cuts(&self, line: &Line, edge: f64) -> impl Iterator<Item = f64> {
        let (zone, blur) = (self.zone, self.blur);
        let near = line.breaks.iter().filter(move |at| (at.place - edge).abs() < zone && at.cuts(zone, blur));
        near.flat_map(move |at| [edge - at.place, zone - (at.place - edge)])
    }

    /// The part of the window between segments of the path history.
    pub(super) fn between(&mut self, scene: &Scene<'_>, line: &Line, low: f64, high: f64) {
        let (edge, zone) = (scene.edge, scene.zone);
        let mut borders = vec![low, high];
        for (inside, list) in [(true, &line.inside), (false, &line.outside)] {
            for segment in list {
                for place in [segment.low, segment.high] {
                    let y = if inside { edge - place } else { zone - (place - edge) };
                    if y > low && y < high {
                        borders.push(y);
                    }
                }
            }
        }
        borders.extend(self.cuts(line, edge).filter(|y| *y > low && *y < high));
        borders.sort_by(f64::total_cmp);
        for pair in borders.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            if to - from < SLIVER * zone {
                continue;
            }
            let middle = 0.5 * (from + to);
            let (inner, outer) = (line.at(true, edge - middle), line.at(false, edge + zone - middle));
            let thetas = |inside: bool| {
                let segment = if inside { inner } else { outer };
                [from, to].map(|y| segment.theta_at(if inside { edge - y } else { edge + zone - y }))
            };
            let bend = |inside: bool| {
                let segment = if inside { inner } else { outer };
                if segment.straight {
                    return 1.0;
                }
                let [one, two] = thetas(inside).map(|theta| segment.place_at(theta).1.abs());
                one.min(two) / one.max(two)
            };
            let (inner_bend, outer_bend) = (bend(true), bend(false));
            let lead = if inner.straight && outer.straight { None } else { Some(inner_bend < outer_bend || outer.straight) };
            let [from, to] = lead.map_or([from, to], thetas);
            self.graded(scene, Piece { inner, outer, lead, under_way: None, from, to });
        }
    }

    /// Cuts a piece where a lag grows too much, one to three towards the younger end, and fills the parts with nodes in their order.
    pub(super) fn graded(&mut self, scene: &Scene<'_>, piece: Piece<'_>) {
        let times = [piece.from, piece.to].map(|u| lags(scene, &piece, u));
        self.cut(scene, piece, times, MOST_CUTS);
    }

    pub(super) fn cut(&mut self, scene: &Scene<'_>, piece: Piece<'_>, [first, second]: [[f64; 2]; 2], cuts: u32) {
        let asks = |&i: &usize| first[i].max(second[i]) > GROWTH * first[i].min(second[i]);
        let Some(i) = (0..2).find(asks).filter(|_| cuts > 0) else { return self.fill(scene, piece) };
        let part = if first[i] < second[i] { 0.25 } else { 0.75 };
        let middle = piece.from + part * (piece.to - piece.from);
        let between = lags(scene, &piece, middle);
        self.cut(scene, Piece { to: middle, ..piece }, [first, between], cuts - 1);
        self.cut(scene, Piece { from: middle, ..piece }, [between, second], cuts - 1);
    }

    pub(super) fn fill(&mut self, scene: &Scene<'_>, piece: Piece<'_>) {
        let span = piece.to - piece.from;
        let rule = Gauss::get();
        let both = rule.nodes.map(|x| thetas(scene, &piece, piece.from + span * x));
        let mut nodes = [Node { theta: f64::NAN, slope: f64::NAN, ..Node::default() }; NODES];
        for ((node, x), [inner, outer]) in nodes.iter_mut().zip(rule.nodes).zip(&both) {
            let u = piece.from + span * x;
            node.y = match piece.lead {
                None => {
                    node.width = span;
                    u
                }
                Some(inside) => {
                    let (place, slope) = if inside { piece.inner.place_at(*inner) } else { piece.outer.place_at(*outer) };
                    node.width = -slope * span;
                    if piece.under_way.is_some() {
                        (node.theta, node.slope) = (u, slope);
                    }
                    if inside { scene.edge - place } else { scene.edge + scene.zone - place }
                }
            };
        }
        // y rises along the window, so the places fall: eight of them at once, in rising order.
        let heights = [scene.edge, scene.edge + scene.zone].map(|from| {
            let places = std::array::from_fn(|k| scene.origin + (from - nodes[NODES - 1 - k].y));
            scene.profile.line_row(&places)
        });
        for (k, (mut node, [inner, outer])) in nodes.into_iter().zip(both).enumerate() {
            let [height_inside, height_outside] = heights.map(|row| row[NODES - 1 - k]);
            node.inner = field(scene.chain, true, piece.inner, inner, height_inside, scene.now);
            node.outer = field(scene.chain, false, piece.outer, outer, height_outside, scene.now);
            if piece.under_way == Some(true) {
                node.outer.memory = 0.0;
            } else {
                node.inner.memory = if piece.under_way.is_some() { 0.0 } else { node.inner.memory };
            }
            self.nodes.push(node);
        }
    }
}

/// Lags of both fields at a parameter; those that no longer differ in effect are one.
pub(super) fn lags(scene: &Scene<'_>, piece: &Piece<'_>, u: f64) -> [f64; 2] {
    let thetas = thetas(scene, piece, u);
    std::array::from_fn(|i| {
        let segment = if i == 0 { piece.inner } else { piece.outer };
        if segment.blank {
            return f64::MAX;
        }
        let [shortest, longest] = scene.chain.times(i == 0);
        (scene.now.time - segment.time_at(thetas[i])).abs().clamp(0.5 * shortest, FADED * longest)
    })
}

/// The parameters of both segments at a parameter of the piece.
pub(super) fn thetas(scene: &Scene<'_>, piece: &Piece<'_>, u: f64) -> [f64; 2] {
    let y = match piece.lead {
        None => u,
        Some(true) => scene.edge - piece.inner.place_at(u).0,
        Some(false) => scene.edge + scene.zone - piece.outer.place_at(u).0,
    };
    let inner = if piece.lead == Some(true) { u } else { piece.inner.theta_at(scene.edge - y) };
    let outer = if piece.lead == Some(false) { u } else { piece.outer.theta_at(scene.edge + scene.zone - y) };
    [inner, outer]
}
