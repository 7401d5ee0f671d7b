//! The state of a contact on the line, and its exact motion.
//!
//! A point carries the dashpots v_i of the Maxwell branches while it is bonded, and the Voigt strains e_j while it is free, on panels of Gauss nodes.
//! Panels end where a state may have a kink or a jump: at the edge now and wherever it stopped before. When the edge sweeps an interval, the
//! interval gets panels graded towards the new edge, down to the distance the edge travels in half of the shortest relaxation time: the
//! layers there are as wide as that, however small against the step. Each node then knows the instant at which the edge passed it,
//! and both its updates, before and after, are exact.

use super::corners::PLACE_NOISE;
use super::motion::{Motion, Passage, STRAIGHT};
use super::node_update::NodeUpdate;
use super::panel::{POINTS, Panel, RULE};
use super::profile::Profile;
use super::rim::Rim;
use super::row::Row;
use super::springs::{DEGREE, Springs};
use super::zone::Zone;
use super::zone_work::zone_work;
use crate::refusal::{Refusal, require_finite, require_non_negative};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Ratio of neighbouring panels of a graded interval: e^{−x} over 0 ≤ x ≤ 1 is kept by eight nodes to 1e-9.
const GRADING: f64 = 2.0;
/// Panels narrower than this part of the contact are not made: places are only known to 1e-16 of it, nodes then to 1e-5 of a panel.
pub(super) const NARROWEST: f64 = 1e-11;

/// Difference of the loads on either side of an edge that an unresolved layer explains, over what one node makes of the extrapolation to the edge.
const UNRESOLVED: f64 = 10.0;

/// How the edge passes an interval within a move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sweep {
    /// a linear in time.
    Linear,
    /// f(a) linear in time, which starts an adhesiveless contact from a point.
    Profile,
}

/// One panel of the line.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Cell {
    pub(super) low: f64,
    pub(super) high: f64,
    /// Carries v_i (bonded) or e_j (free).
    pub(super) bonded: bool,
}

impl Cell {
    pub(super) fn node(&self, g: usize) -> f64 {
        self.low + (self.high - self.low) * RULE.nodes[g]
    }

    /// f at the nodes.
    pub(super) fn heights(&self, profile: &Profile) -> Row {
        profile.line_row(&RULE.nodes.map(|x| self.low + (self.high - self.low) * x))
    }
}

/// A contact at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact<'a> {
    pub(super) springs: &'a Springs,
    pub(super) profile: Profile,
    pub(super) cells: Vec<Cell>,
    /// n numbers a node, eight nodes a cell.
    pub(super) values: Vec<f64>,
    pub(super) radius: f64,
    pub(super) penetration: f64,
    /// How far the edge went in the last motion that took time (m).
    pub(super) way: f64,
    /// Beyond a sharp rim, if the indenter has one.
    pub(super) rim: Option<Rim>,
    pub(super) updates: u64,
}

impl<'a> Contact<'a> {
    /// An indenter that has bonded, at once, a circle of an untouched surface (radius 0: touches it).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius or numbers that are not finite; [`Refusal::NoSuchState`] beyond the last point of a table.
    pub fn untouched(springs: &'a Springs, profile: Profile, radius: f64, penetration: f64) -> Result<Self, Refusal> {
        Self::bonded(springs, profile, radius, penetration, 0.0)
    }

    /// A contact held so long that the solid has relaxed: v_i = Δ − f where bonded, e_j = 0 elsewhere.
    ///
    /// # Errors
    /// As for [`Contact::untouched`].
    pub fn relaxed(springs: &'a Springs, profile: Profile, radius: f64, penetration: f64) -> Result<Self, Refusal> {
        Self::bonded(springs, profile, radius, penetration, 1.0)
    }

    fn bonded(springs: &'a Springs, profile: Profile, radius: f64, penetration: f64, followed: f64) -> Result<Self, Refusal> {
        require_non_negative("contact_radius", radius)?;
        require_finite("penetration", penetration)?;
        let profile = profile.checked()?;
        profile.holds(radius, 0.0)?;
        let rim = Some(profile.rim()).filter(|rim| rim.is_finite());
        let rim = rim.map(|rim| Rim::new(springs, profile.line(rim), penetration, followed > 0.0));
        let mut contact = Self { springs, profile, cells: Vec::new(), values: Vec::new(), radius, penetration, way: 0.0, rim, updates: 0 };
        if radius > 0.0 {
            let breaks = contact.profile.breaks(radius);
            contact.cells = breaks.windows(2).map(|pair| Cell { low: pair[0], high: pair[1], bonded: true }).collect();
        }
        for cell in &contact.cells {
            for height in cell.heights(&contact.profile) {
                let depth = followed * (penetration - height);
                contact.values.extend(std::iter::repeat_n(depth, springs.terms()));
            }
        }
        Ok(contact)
    }

    /// a (m).
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// Δ (m).
    #[must_use]
    pub const fn penetration(&self) -> f64 {
        self.penetration
    }

    /// Number of panels.
    #[must_use]
    pub fn panels(&self) -> usize {
        self.cells.len()
    }

    /// Points updated in all the moves that led here.
    #[must_use]
    pub const fn updates(&self) -> u64 {
        self.updates
    }

    /// The springs of the line.
    #[must_use]
    pub const fn springs(&self) -> &'a Springs {
        self.springs
    }

    /// The indenter.
    #[must_use]
    pub const fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The contact after a time ≥ 0 (s) in which Δ went linearly, and the edge as `sweep` says, to new values. Exact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius or time, or numbers that are not finite.
    pub fn moved(&self, radius: f64, penetration: f64, time: f64, sweep: Sweep) -> Result<Self, Refusal> {
        require_non_negative("contact_radius", radius)?;
        require_finite("penetration", penetration)?;
        require_non_negative("time", time)?;
        let mut powers = [0.0; DEGREE];
        powers[0] = penetration - self.penetration;
        let passage = match sweep {
            Sweep::Linear => Passage::Radius,
            Sweep::Profile => Passage::PlaceOfTime(STRAIGHT),
        };
        let motion = Motion::new(&self.profile, (self.radius, radius), time, passage, self.penetration, powers);
        Ok(self.after(&motion, penetration))
    }

    /// The contact after a motion that ends at `penetration`.
    pub(super) fn after(&self, motion: &Motion, penetration: f64) -> Self {
        let (cells, values) = self.cut((motion.to, motion.time), motion.towards_rest(&self.profile), (0.0, f64::INFINITY));
        let mut next = Self {
            springs: self.springs,
            profile: self.profile.clone(),
            cells,
            values,
            radius: motion.to,
            penetration,
            way: if motion.time > 0.0 { motion.to - motion.from } else { 0.0 },
            rim: self.rim.as_ref().map(|rim| rim.after(self.springs, motion)),
            updates: self.updates,
        };
        next.updates += (next.cells.len() * POINTS) as u64;
        let n = self.springs.terms();
        let mut node_update = NodeUpdate::new(self.springs, &next.profile, motion);
        for (cell, values) in next.cells.iter_mut().zip(next.values.chunks_exact_mut((POINTS * n).max(1))) {
            let bonded = cell.high <= motion.to || 0.5 * (cell.low + cell.high) < motion.to;
            let heights = if cell.bonded || bonded { cell.heights(&self.profile) } else { [0.0; POINTS] };
            for (g, (state, height)) in values.chunks_exact_mut(n.max(1)).zip(heights).enumerate() {
                match (cell.bonded, bonded) {
                    (true, true) => node_update.bonded(state, height),
                    (false, false) => node_update.free(state),
                    (before, _) => node_update.passed(state, cell.node(g), height, before),
                }
            }
        }
        for cell in &mut next.cells {
            cell.bonded = 0.5 * (cell.low + cell.high) < motion.to;
        }
        next
    }

    /// The cells that touch a window, cut at both edges and graded in the interval that an edge at `radius` will have swept after `time`.
    /// `more`: further cuts.
    pub(super) fn cut(&self, (radius, time): (f64, f64), more: Vec<f64>, window: (f64, f64)) -> (Vec<Cell>, Vec<f64>) {
        let n = self.springs.terms();
        let outer = self.radius.max(radius);
        let end = self.cells.last().map_or(0.0, |cell| cell.high);
        let narrow = NARROWEST * outer.max(end);
        let cuts = self.cuts(radius, time, more, narrow);
        // Less than a narrowest panel beyond the last one is left for a later step.
        let virgin = (outer > end + narrow).then_some(Cell { low: end, high: outer, bonded: false });
        let first_cell = self.cells.partition_point(|cell| cell.high < window.0);
        let (mut cells, mut values) = (Vec::new(), Vec::new());
        for (index, cell) in self.cells.iter().chain(&virgin).enumerate().skip(first_cell) {
            if cell.low > window.1 {
                break;
            }
            let own = self.values.get(index * POINTS * n..(index + 1) * POINTS * n).unwrap_or(&[]);
            let mut left = cell.low;
            let mut whole = true;
            let first = cuts.partition_point(|&cut| cut <= cell.low + narrow);
            for &cut in cuts.iter().skip(first).take_while(|&&cut| cut < cell.high - narrow) {
                if cut > left + narrow {
                    piece(*cell, own, (left, cut), n, &mut cells, &mut values);
                    left = cut;
                    whole = false;
                }
            }
            if whole && !own.is_empty() {
                cells.push(*cell);
                values.extend_from_slice(own);
            } else {
                piece(*cell, own, (left, cell.high), n, &mut cells, &mut values);
            }
        }
        (cells, values)
    }

    /// Panel ends of a move: both edges, and a graded mesh in the swept interval.
    fn cuts(&self, radius: f64, time: f64, more: Vec<f64>, narrow: f64) -> Vec<f64> {
        let mut cuts = more;
        let shortest = self.springs.shortest_time();
        let mut lag = 0.5 * shortest;
        while lag < time && shortest.is_finite() {
            cuts.push(radius + (self.radius - radius) * (lag / time));
            lag *= GRADING;
        }
        // Nothing may stand so near an edge that its own cut would be left out.
        cuts.retain(|cut| [radius, self.radius].iter().all(|edge| (cut - edge).abs() > 2.0 * narrow));
        cuts.extend([self.radius, radius]);
        cuts.sort_by(f64::total_cmp);
        cuts
    }

    /// Σ of the Voigt strains at the nodes of a free cell.
    fn strain_sums(&self, index: usize) -> [f64; POINTS] {
        let n = self.springs.terms();
        std::array::from_fn(|g| {
            let place = (index * POINTS + g) * n;
            self.values.get(place..place + n).map_or(0.0, |strains| strains.iter().sum())
        })
    }

    /// The state at a node.
    pub(super) fn state(&self, index: usize, g: usize) -> &[f64] {
        let n = self.springs.terms();
        let place = (index * POINTS + g) * n;
        self.values.get(place..place + n).unwrap_or(&[])
    }

    /// Q on a bonded cell.
    fn loads(&self, index: usize, cell: &Cell) -> [f64; POINTS] {
        let heights = cell.heights(&self.profile);
        std::array::from_fn(|g| self.springs.load(self.penetration - heights[g], self.state(index, g).iter().copied()))
    }

    /// Q on the panels of the contact.
    #[must_use]
    pub fn line_load(&self) -> Vec<Panel> {
        let cells = self.cells.iter().enumerate().filter(|(_, cell)| cell.bonded);
        cells.map(|(index, cell)| Panel { lower: cell.low, upper: cell.high, values: self.loads(index, cell) }).collect()
    }

    /// W on the panels outside the contact, on to `end` (m).
    #[must_use]
    pub(crate) fn free_displacement(&self, end: f64) -> Vec<Panel> {
        let cells = self.cells.iter().enumerate().filter(|(_, cell)| !cell.bonded);
        let mut panels: Vec<Panel> =
            cells.map(|(index, cell)| Panel { lower: cell.low, upper: cell.high, values: self.strain_sums(index) }).collect();
        let reached = panels.last().map_or(self.radius, |panel| panel.upper);
        if reached < end {
            panels.push(Panel { lower: reached, upper: end, values: [0.0; POINTS] });
        }
        panels
    }

    /// D = W − (Δ − f) on the panels outside the contact, on to `end` (m); beyond a sharp rim the opening since the rim last released.
    #[must_use]
    pub(crate) fn gap_factor(&self, end: f64) -> Vec<Panel> {
        let mut panels = self.free_displacement(end.min(self.profile.rim()));
        for panel in &mut panels {
            let heights = Cell { low: panel.lower, high: panel.upper, bonded: false }.heights(&self.profile);
            for (value, height) in panel.values.iter_mut().zip(heights) {
                *value += height - self.penetration;
            }
        }
        panels.extend(self.rim.as_ref().and_then(|rim| beyond_rim(self.profile.rim(), end, rim.opening(self.penetration))));
        panels
    }

    /// F (N), compression positive.
    #[must_use]
    pub fn force(&self) -> f64 {
        2.0 * self.line_load().iter().map(Panel::integral).sum::<f64>()
    }

    /// Q(a) (Pa m) just inside the edge; 0 without contact.
    ///
    /// Where the edge moves, strains go on through it, and both sides know Q: the panel within, and −E∞*D from without. Behind an edge that advances quickly lies
    /// a layer as thin as its way in the shortest relaxation time, which no panel may resolve: where the two differ by no more than that explains,
    /// the smooth side without is taken, and at an edge that advances in any case: its layer may be too thin to be seen at all. At an edge that rests they differ
    /// by what the solid has relaxed, and the side within is right.
    #[must_use]
    pub(crate) fn edge_load(&self) -> f64 {
        self.edge_load_known().0
    }

    /// Q(a), and what the panel that it is taken from leaves unknown of it: what one node changes of the extrapolation to the edge, and what the rounding of places does
    /// (Pa m).
    fn edge_load_known(&self) -> (f64, f64) {
        let first_free = self.cells.partition_point(|cell| cell.bonded);
        let Some(last_bonded) = first_free.checked_sub(1).filter(|_| self.radius > 0.0) else { return (0.0, 0.0) };
        let Some(cell) = self.cells.get(last_bonded) else { return (0.0, 0.0) };
        let within = Panel { lower: cell.low, upper: cell.high, values: self.loads(last_bonded, cell) };
        let (mut strain, mut uncertainty) = (0.0, 0.0);
        if let Some(cell) = self.cells.get(first_free) {
            let strains = Panel { lower: cell.low, upper: cell.high, values: self.strain_sums(first_free) };
            (strain, uncertainty) = strains.at_end(self.radius);
            uncertainty += strain.abs() * self.place_rounding(cell);
        }
        let glassy = self.springs.glassy;
        let (load, mut own) = within.at_end(self.radius);
        own += load.abs() * self.place_rounding(cell);
        let without = glassy * (self.penetration - self.profile.line(self.radius) - strain);
        let advances = self.way > PLACE_NOISE * NARROWEST * self.radius;
        let is_layer = glassy * uncertainty < own && (without - load).abs() <= UNRESOLVED * own;
        if is_layer || (advances && (without - load).abs() > UNRESOLVED * own) { (without, glassy * uncertainty) } else { (load, own) }
    }

    /// Rounding of places over the width of a panel: of the layer behind a quick edge so much is not known.
    fn place_rounding(&self, cell: &Cell) -> f64 {
        f64::EPSILON * self.radius / (cell.high - cell.low)
    }

    /// K_I (Pa√m), tension positive; 0 without contact.
    #[must_use]
    pub fn stress_intensity_factor(&self) -> f64 {
        self.stress_intensity_known().0
    }

    /// K_I, and what the panels leave unknown of it (Pa√m).
    pub(super) fn stress_intensity_known(&self) -> (f64, f64) {
        if self.radius <= 0.0 {
            return (0.0, 0.0);
        }
        let (load, unknown) = self.edge_load_known();
        let root = (PI * self.radius).sqrt();
        (-load / root, unknown / root)
    }

    /// G_tip = K_I²/(2E∞*) (J/m²).
    #[must_use]
    pub fn tip_release_rate(&self) -> f64 {
        self.stress_intensity_factor().powi(2) / (2.0 * self.springs.glassy)
    }

    /// C (J/m²), Eq 4.9.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a contact not larger than the process zone.
    pub fn zone_work(&self, process_zone: f64) -> Result<f64, Refusal> {
        Ok(zone_work(&Zone::new(self.radius, process_zone)?, &self.line_load(), &self.gap_factor(self.radius + process_zone)))
    }
}

/// D from the rim to `end` (m).
pub(super) fn beyond_rim(rim: f64, end: f64, opening: f64) -> Option<Panel> {
    (end > rim).then_some(Panel { lower: rim, upper: end, values: [opening; POINTS] })
}

/// Part of a cell, its state interpolated; zero where the cell has none.
fn piece(cell: Cell, own: &[f64], (left, right): (f64, f64), n: usize, cells: &mut Vec<Cell>, values: &mut Vec<f64>) {
    cells.push(Cell { low: left, high: right, ..cell });
    if own.is_empty() {
        values.resize(values.len() + POINTS * n, 0.0);
        return;
    }
    for x in RULE.nodes {
        let factors = RULE.interpolation((left + (right - left) * x - cell.low) / (cell.high - cell.low));
        values.extend((0..n).map(|j| (0..POINTS).map(|g| factors[g] * own[g * n + j]).sum::<f64>()));
    }
}
