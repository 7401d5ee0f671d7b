//! The surface of a contact at an instant: its line load and its displacement, sampled from the segments.

use super::chain::Chain;
use super::closure::Way;
use super::drive::Instant;
use super::line::{Line, Segment, field};
use crate::indentation::panel::Panel;
use crate::indentation::{Profile, SurfaceFields};

/// Cuts of a segment where eight nodes do not hold its field, and what they may leave, over the largest value on it.
const MOST_CUTS: u32 = 30;
const LEAVES: f64 = 1e-10;

/// The surface with the edge at the origin or on the way.
pub(super) fn surface((chain, profile): (&Chain, &Profile), line: &Line, way: Option<Way<'_>>, now: &Instant) -> SurfaceFields {
    let edge = way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
    let grows = |bonded: bool| way.filter(|way| way.advances == bonded);
    let mut found = [Vec::new(), Vec::new()];
    for (bonded, panels) in [true, false].into_iter().zip(&mut found) {
        let sampled = |segment: &Segment, low: f64, high: f64, panels: &mut Vec<Panel>| {
            let sample = |radius: f64| {
                let place = radius - line.edge;
                let value = field(chain, bonded, segment, segment.theta_at(place), profile.line(radius), now).value;
                // Of a free point the displacement, of a bonded one the load.
                if bonded { value } else { value + now.depth - profile.line(radius) }
            };
            for pair in line.broken(low, high).collect::<Vec<_>>().windows(2) {
                let ends = (line.edge + pair[0], line.edge + pair[1]);
                if ends.0 < ends.1 {
                    cut(ends, MOST_CUTS, 0.0, &sample, panels);
                }
            }
        };
        for segment in line.list(bonded) {
            // A panel that turns is followed beyond its start: the list that it joins then ends where it begins.
            let (low, high) = match (grows(bonded).is_some(), bonded) {
                (true, _) => (segment.low, segment.high),
                (false, true) => (segment.low, segment.high.min(edge)),
                (false, false) => (segment.low.max(edge), segment.high),
            };
            if low < high && (bonded || !segment.blank) {
                sampled(segment, low, high, panels);
            }
        }
        if let Some(way) = grows(bonded) {
            let (low, high) = if bonded { (0.0, edge) } else { (edge, 0.0) };
            sampled(way.panel, low, high, panels);
        }
        panels.sort_by(|one, other| one.lower.total_cmp(&other.lower));
    }
    let [load, free] = found;
    let radius = line.edge + edge;
    let bonded = |panel: &Panel| Panel::sampled(panel.lower, panel.upper, |s| now.depth - profile.line(s));
    let displacement = load.iter().map(bonded).chain(free).collect();
    SurfaceFields::made_of(radius, load, displacement)
}

/// A segment in panels that hold it.
fn cut((low, high): (f64, f64), cuts: u32, largest: f64, sample: &dyn Fn(f64) -> f64, panels: &mut Vec<Panel>) {
    let panel = Panel::sampled(low, high, sample);
    let largest = panel.values.iter().fold(largest, |most, value| most.max(value.abs()));
    let middle = 0.5 * (low + high);
    let held = [low, middle, high].into_iter().all(|s| (panel.at(s) - sample(s)).abs() <= LEAVES * largest);
    if held || cuts == 0 || middle <= low || middle >= high {
        panels.push(panel);
        return;
    }
    cut((low, middle), cuts - 1, largest, sample, panels);
    cut((middle, high), cuts - 1, largest, sample, panels);
}
