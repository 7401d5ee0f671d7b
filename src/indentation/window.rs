//! The part of the line that the closure sees, cut once for a trial edge and moved in many trial times.

use super::line::{Cell, Contact, beyond_rim};
use super::motion::Motion;
use super::node_update::NodeUpdate;
use super::panel::{POINTS, Panel, RULE};
use super::rim::Rim;

/// Cells about an edge, as they are before a step.
#[derive(Debug, Clone)]
pub(super) struct Window {
    /// The trial edge.
    pub(super) radius: f64,
    /// The time for which the swept interval is graded.
    pub(super) time: f64,
    /// How far about the edge the fields are held.
    pub(super) reach: f64,
    cells: Vec<Cell>,
    values: Vec<f64>,
    /// f at every node.
    heights: Vec<f64>,
    /// Of the bonded cells within the window: length, ∫f, ∫v_i.
    inner: (f64, f64, Vec<f64>),
    pub(super) loads: Vec<Panel>,
    pub(super) gaps: Vec<Panel>,
    state: Vec<f64>,
}

impl Window {
    /// The cells within `reach` of both edges; `whole`: the inner rest, for forces.
    pub(super) fn new(contact: &Contact<'_>, radius: f64, time: f64, reach: f64, whole: bool) -> Self {
        let bounds = (contact.radius.min(radius - reach), contact.radius.max(radius + reach));
        let (cells, values) = contact.cut((radius, time), Vec::new(), bounds);
        let heights = cells.iter().flat_map(|cell| cell.heights(&contact.profile)).collect();
        let n = contact.springs.terms();
        let mut rest = (0.0, 0.0, vec![0.0; n]);
        if whole {
            let start = cells.first().map_or(0.0, |cell| cell.low);
            for (index, cell) in contact.cells.iter().enumerate().take_while(|(_, cell)| cell.low < start) {
                for (g, (weight, height)) in RULE.weights.iter().zip(cell.heights(&contact.profile)).enumerate() {
                    let weight = weight * (cell.high - cell.low);
                    rest.0 += weight;
                    rest.1 += weight * height;
                    for (sum, value) in rest.2.iter_mut().zip(contact.state(index, g)) {
                        *sum += weight * value;
                    }
                }
            }
        }
        Self { radius, time, reach, cells, values, heights, inner: rest, loads: Vec::new(), gaps: Vec::new(), state: vec![0.0; n] }
    }

    /// Q and D after a motion to the trial edge. Returns the points updated.
    pub(super) fn after(&mut self, contact: &Contact<'_>, motion: &Motion) -> u64 {
        let end = motion.to + self.reach;
        let n = contact.springs.terms();
        let penetration = motion.end_penetration();
        let mut node_update = NodeUpdate::new(contact.springs, &contact.profile, motion);
        self.loads.clear();
        self.gaps.clear();
        for (index, cell) in self.cells.iter().enumerate() {
            let bonded = 0.5 * (cell.low + cell.high) < motion.to;
            let values = std::array::from_fn(|g| {
                let place = index * POINTS + g;
                let height = self.heights[place];
                let before = &self.values[place * n..(place + 1) * n];
                match (cell.bonded, bonded) {
                    (true, true) => node_update.bonded_load(before, height),
                    (false, false) => node_update.free_displacement(before) + height - penetration,
                    (was_bonded, _) => {
                        self.state.copy_from_slice(before);
                        node_update.passed(&mut self.state, cell.node(g), height, was_bonded);
                        if bonded {
                            contact.springs.load(penetration - height, self.state.iter().copied())
                        } else {
                            self.state.iter().sum::<f64>() + height - penetration
                        }
                    }
                }
            });
            let panel = Panel { lower: cell.low, upper: cell.high, values };
            if bonded { self.loads.push(panel) } else { self.gaps.push(panel) }
        }
        let reached = self.gaps.last().map_or(motion.to, |panel| panel.upper);
        let rim = contact.profile.rim();
        if reached < end.min(rim) {
            self.gaps.push(Panel::sampled(reached, end.min(rim), |s| contact.profile.line(s) - penetration));
        }
        let opening = |rim: &Rim| rim.after(contact.springs, motion).opening(penetration);
        self.gaps.extend(contact.rim.as_ref().filter(|_| end > rim).and_then(|chain| beyond_rim(rim, end, opening(chain))));
        (self.cells.len() * POINTS) as u64
    }

    /// F after a motion for which [`Window::after`] has been called.
    pub(super) fn force(&mut self, contact: &Contact<'_>, motion: &Motion) -> f64 {
        let node_update = NodeUpdate::new(contact.springs, &contact.profile, motion);
        let (length, height, dashpots) = &self.inner;
        self.state.copy_from_slice(dashpots);
        node_update.bonded_sum(&mut self.state, motion.penetration * length - height, *length);
        let rest = contact.springs.load(motion.end_penetration() * length - height, self.state.iter().copied());
        2.0 * (rest + self.loads.iter().map(Panel::integral).sum::<f64>())
    }
}
