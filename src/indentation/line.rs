//! The state of a contact on the line, and its exact motion.
//!
//! Voigt strains live on panels of Gauss nodes. Panels end where a strain may have a kink or a jump: at the edge now and wherever it stopped
//! before. When the edge sweeps a stretch, the stretch gets panels graded towards the new edge, down to the distance the edge travels in
//! half of the shortest relaxation time: the layers there are as wide as that, however small against the step. Each node then knows the instant
//! at which the edge passed it, and both its updates, before and after, are exact.

use super::panel::{POINTS, Panel, RULE, value_at};
use super::profile::Profile;
use super::springs::{Lapse, Springs};
use super::zone::{Zone, zone_work};
use crate::refusal::{Refusal, require_finite, require_non_negative};
use std::f64::consts::PI;

/// Ratio of neighbouring panels of a graded stretch: e^{−x} over 0 ≤ x ≤ 1 is kept by eight nodes to 1e-9.
const GRADING: f64 = 2.0;
/// Panels narrower than this part of the contact are not made: places are only known to 1e-16 of it.
const NARROWEST: f64 = 1e-12;

/// Voigt strains on the line; zero beyond the last panel.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Line {
    cells: Vec<(f64, f64)>,
    strains: Vec<f64>,
}

/// How the edge passes a stretch within a move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sweep {
    /// a linear in time.
    Linear,
    /// f(a) linear in time, which starts an adhesiveless contact from a point.
    Profile,
}

/// A contact at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact<'a> {
    springs: &'a Springs,
    profile: Profile,
    line: Line,
    radius: f64,
    penetration: f64,
    updates: u64,
}

impl<'a> Contact<'a> {
    /// An indenter that has bonded, at once, a circle of an untouched surface (radius 0: touches it).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius or numbers that are not finite.
    pub fn untouched(springs: &'a Springs, profile: Profile, radius: f64, penetration: f64) -> Result<Self, Refusal> {
        require_non_negative("contact_radius", radius)?;
        require_finite("penetration", penetration)?;
        Ok(Self::with_strains(springs, profile.checked()?, radius, penetration, 0.0))
    }

    /// A contact held so long that the solid has relaxed: e_j = J_jE0*(Δ − f) where bonded, 0 elsewhere.
    ///
    /// # Errors
    /// As for [`Contact::untouched`].
    pub fn relaxed(springs: &'a Springs, profile: Profile, radius: f64, penetration: f64) -> Result<Self, Refusal> {
        require_non_negative("contact_radius", radius)?;
        require_finite("penetration", penetration)?;
        Ok(Self::with_strains(springs, profile.checked()?, radius, penetration, springs.relaxed))
    }

    fn with_strains(springs: &'a Springs, profile: Profile, radius: f64, penetration: f64, modulus: f64) -> Self {
        let mut line = Line::default();
        if radius > 0.0 {
            line.cells = profile.breaks(radius).windows(2).map(|pair| (pair[0], pair[1])).collect();
        }
        for &(low, high) in &line.cells {
            for x in RULE.nodes {
                let depth = penetration - profile.line(low + (high - low) * x);
                line.strains.extend(springs.creep.iter().map(|&(compliance, _)| compliance * modulus * depth));
            }
        }
        Self { springs, profile, line, radius, penetration, updates: 0 }
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
        self.line.cells.len()
    }

    /// Points updated in all the moves that led here.
    #[must_use]
    pub const fn updates(&self) -> u64 {
        self.updates
    }

    /// The contact after a time ≥ 0 (s) in which Δ went linearly, and the edge as `sweep` says, to new values. Exact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius or time, or numbers that are not finite.
    pub fn moved(&self, radius: f64, penetration: f64, time: f64, sweep: Sweep) -> Result<Self, Refusal> {
        require_non_negative("contact_radius", radius)?;
        require_finite("penetration", penetration)?;
        require_non_negative("time", time)?;
        Ok(self.moved_within(radius, penetration, time, sweep, (0.0, f64::INFINITY)))
    }

    /// The same on the panels that touch a window only.
    pub(super) fn moved_within(&self, radius: f64, penetration: f64, time: f64, sweep: Sweep, window: (f64, f64)) -> Self {
        let n = self.springs.terms();
        let (inner, outer) = (self.radius.min(radius), self.radius.max(radius));
        let cuts = self.cuts(radius, time);
        let end = self.line.cells.last().map_or(0.0, |cell| cell.1);
        let virgin = (outer > end).then_some((end, outer));
        let narrow = NARROWEST * outer.max(end);
        let mut line = Line::default();
        for (index, &(low, high)) in self.line.cells.iter().chain(&virgin).enumerate() {
            if high < window.0 || low > window.1 {
                continue;
            }
            let first = cuts.partition_point(|&cut| cut <= low + narrow);
            let mut left = low;
            let mut copied = true;
            for &cut in cuts.iter().skip(first).take_while(|&&cut| cut < high - narrow) {
                if cut > left + narrow {
                    self.copy_piece(index, (low, high), (left, cut), n, &mut line);
                    left = cut;
                    copied = false;
                }
            }
            if copied && index < self.line.cells.len() {
                line.cells.push((low, high));
                line.strains.extend_from_slice(&self.line.strains[index * POINTS * n..(index + 1) * POINTS * n]);
            } else {
                self.copy_piece(index, (low, high), (left, high), n, &mut line);
            }
        }
        let mut next = Self { line, radius, penetration, ..self.bare() };
        next.updates = self.updates + (next.line.cells.len() * POINTS) as u64;
        self.update(&mut next, (inner, outer), time, sweep);
        next
    }

    fn bare(&self) -> Self {
        Self { springs: self.springs, profile: self.profile, line: Line::default(), radius: 0.0, penetration: 0.0, updates: self.updates }
    }

    fn copy_piece(&self, index: usize, (low, high): (f64, f64), (left, right): (f64, f64), n: usize, line: &mut Line) {
        line.cells.push((left, right));
        let Some(strains) = self.line.strains.get(index * POINTS * n..(index + 1) * POINTS * n) else {
            line.strains.resize(line.strains.len() + POINTS * n, 0.0);
            return;
        };
        for x in RULE.nodes {
            let factors = RULE.interpolation((left + (right - left) * x - low) / (high - low));
            line.strains.extend((0..n).map(|j| (0..POINTS).map(|g| factors[g] * strains[g * n + j]).sum::<f64>()));
        }
    }

    /// Panel ends of a move: both edges, and a graded mesh in the swept stretch.
    fn cuts(&self, radius: f64, time: f64) -> Vec<f64> {
        let mut cuts = vec![self.radius, radius];
        let shortest = self.springs.shortest_time();
        let mut lag = 0.5 * shortest;
        while lag < time && shortest.is_finite() {
            cuts.push(radius + (self.radius - radius) * (lag / time));
            lag *= GRADING;
        }
        cuts.sort_by(f64::total_cmp);
        cuts
    }

    fn update(&self, next: &mut Self, (inner, outer): (f64, f64), time: f64, sweep: Sweep) {
        let n = self.springs.terms();
        if n == 0 {
            return;
        }
        let (mut whole, mut before, mut after) = (Lapse::default(), Lapse::default(), Lapse::default());
        self.springs.lapse(time, &mut whole);
        let rise = next.penetration - self.penetration;
        let advancing = next.radius > self.radius;
        let (start_height, height) = (self.profile.line(self.radius), self.profile.line(next.radius) - self.profile.line(self.radius));
        for (cell, &(low, high)) in next.line.cells.iter().enumerate() {
            for (g, x) in RULE.nodes.iter().enumerate() {
                let s = low + (high - low) * x;
                let place = (cell * POINTS + g) * n;
                let Some(strains) = next.line.strains.get_mut(place..place + n) else { continue };
                let depth = self.penetration - self.profile.line(s);
                if s < inner {
                    self.springs.bonded(strains, depth, rise, &mut whole);
                } else if s > outer {
                    Springs::free(strains, &whole);
                } else {
                    let fraction = match sweep {
                        Sweep::Profile if height != 0.0 => (self.profile.line(s) - start_height) / height,
                        _ => (s - self.radius) / (next.radius - self.radius),
                    };
                    let fraction = fraction.clamp(0.0, 1.0);
                    self.springs.lapse(fraction * time, &mut before);
                    self.springs.lapse((1.0 - fraction) * time, &mut after);
                    if advancing {
                        Springs::free(strains, &before);
                        self.springs.bonded(strains, depth + fraction * rise, (1.0 - fraction) * rise, &mut after);
                    } else {
                        self.springs.bonded(strains, depth, fraction * rise, &mut before);
                        Springs::free(strains, &after);
                    }
                }
            }
        }
    }

    /// Joins neighbouring panels wherever their union keeps every strain to `tolerance` (m); never across the edge.
    pub(super) fn coarsened(&mut self, tolerance: f64) {
        let n = self.springs.terms();
        let mut merged = Line::default();
        let mut next = 0;
        while next < self.line.cells.len() {
            let (low, high) = self.line.cells[next];
            let own = &self.line.strains[next * POINTS * n..(next + 1) * POINTS * n];
            next += 1;
            let Some(&(left, right)) = merged.cells.last() else {
                merged.cells.push((low, high));
                merged.strains.extend_from_slice(own);
                continue;
            };
            let across = (right - self.radius).abs() <= NARROWEST * self.radius;
            // A union much wider than its narrower part is left for later: it would hardly ever hold.
            let joined = if across {
                None
            } else {
                Self::joined((left, right, &merged.strains[merged.strains.len() - POINTS * n..]), (low, high, own), n, tolerance)
            };
            if let Some(values) = joined {
                let keep = merged.strains.len() - POINTS * n;
                merged.strains.truncate(keep);
                merged.strains.extend(values);
                if let Some(last) = merged.cells.last_mut() {
                    *last = (left, high);
                }
            } else {
                merged.cells.push((low, high));
                merged.strains.extend_from_slice(own);
            }
        }
        self.line = merged;
    }

    fn joined(first: (f64, f64, &[f64]), second: (f64, f64, &[f64]), n: usize, tolerance: f64) -> Option<Vec<f64>> {
        let (left, right) = (first.0, second.1);
        let mut values = vec![0.0; POINTS * n];
        for (g, x) in RULE.nodes.iter().enumerate() {
            let s = left + (right - left) * x;
            let (low, high, strains) = if s < first.1 { first } else { second };
            let factors = RULE.interpolation((s - low) / (high - low));
            for j in 0..n {
                values[g * n + j] = (0..POINTS).map(|l| factors[l] * strains[l * n + j]).sum();
            }
        }
        for (low, high, strains) in [first, second] {
            for (g, x) in RULE.nodes.iter().enumerate() {
                let factors = RULE.interpolation((low + (high - low) * x - left) / (right - left));
                for j in 0..n {
                    let value: f64 = (0..POINTS).map(|l| factors[l] * values[l * n + j]).sum();
                    if value.is_nan() || (value - strains[g * n + j]).abs() > tolerance {
                        return None;
                    }
                }
            }
        }
        Some(values)
    }

    /// Σe_j at the nodes of a panel.
    fn strain_sums(&self, cell: usize) -> [f64; POINTS] {
        let n = self.springs.terms();
        std::array::from_fn(|g| {
            let place = (cell * POINTS + g) * n;
            self.line.strains.get(place..place + n).map_or(0.0, |strains| strains.iter().sum())
        })
    }

    fn bonded_at(&self, (low, high): (f64, f64)) -> bool {
        0.5 * (low + high) < self.radius
    }

    fn cell_line_load(&self, cell: usize, (low, high): (f64, f64)) -> [f64; POINTS] {
        let sums = self.strain_sums(cell);
        std::array::from_fn(|g| {
            let s = low + (high - low) * RULE.nodes[g];
            self.springs.glassy * (self.penetration - self.profile.line(s) - sums[g])
        })
    }

    /// Q on the panels of the contact.
    #[must_use]
    pub fn line_load(&self) -> Vec<Panel> {
        let cells = self.line.cells.iter().enumerate().filter(|(_, cell)| self.bonded_at(**cell));
        cells.map(|(index, &(lower, upper))| Panel { lower, upper, values: self.cell_line_load(index, (lower, upper)) }).collect()
    }

    /// W on the panels outside the contact, on to `end` (m).
    #[must_use]
    pub fn free_displacement(&self, end: f64) -> Vec<Panel> {
        let cells = self.line.cells.iter().enumerate().filter(|(_, cell)| !self.bonded_at(**cell));
        let mut panels: Vec<Panel> =
            cells.map(|(index, &(lower, upper))| Panel { lower, upper, values: self.strain_sums(index) }).collect();
        let reached = panels.last().map_or(self.radius, |panel| panel.upper);
        if reached < end {
            panels.push(Panel { lower: reached, upper: end, values: [0.0; POINTS] });
        }
        panels
    }

    /// D = W − (Δ − f) on the panels outside the contact, on to `end` (m).
    #[must_use]
    pub fn gap_factor(&self, end: f64) -> Vec<Panel> {
        let mut panels = self.free_displacement(end);
        for panel in &mut panels {
            for (value, x) in panel.values.iter_mut().zip(RULE.nodes) {
                *value += self.profile.line(panel.lower + (panel.upper - panel.lower) * x) - self.penetration;
            }
        }
        panels
    }

    /// F (N), compression positive.
    #[must_use]
    pub fn force(&self) -> f64 {
        2.0 * self.line_load().iter().map(Panel::integral).sum::<f64>()
    }

    /// Q(a) (Pa m) just inside the edge; 0 without contact.
    #[must_use]
    pub fn edge_load(&self) -> f64 {
        if self.radius > 0.0 { value_at(&self.line_load(), self.radius) } else { 0.0 }
    }

    /// K_I (Pa√m), tension positive; 0 without contact.
    #[must_use]
    pub fn stress_intensity_factor(&self) -> f64 {
        if self.radius > 0.0 { -self.edge_load() / (PI * self.radius).sqrt() } else { 0.0 }
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
        Ok(self.zone_work_with(&Zone::new(self.radius, process_zone)?, process_zone))
    }

    pub(super) fn zone_work_with(&self, zone: &Zone, process_zone: f64) -> f64 {
        zone_work(zone, &self.line_load(), &self.gap_factor(self.radius + process_zone))
    }

    /// U (J), the energy stored in every spring, inside and outside the contact (thesis Eq 4.30 on the line).
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        self.integrate(|load, strains| {
            load * load / self.springs.glassy + strains.iter().zip(&self.springs.creep).map(|(e, (j, _))| e * e / j).sum::<f64>()
        })
    }

    /// P_d (W), the power dissipated in every dashpot (thesis Eq 4.32).
    #[must_use]
    pub fn dissipated_power(&self) -> f64 {
        self.integrate(|load, strains| {
            let terms = strains.iter().zip(&self.springs.creep);
            2.0 * terms.map(|(e, &(j, tau))| (j * load - e) * ((j * load - e) / j) / tau).sum::<f64>()
        })
    }

    fn integrate(&self, density: impl Fn(f64, &[f64]) -> f64) -> f64 {
        let n = self.springs.terms();
        let mut total = 0.0;
        for (index, &(low, high)) in self.line.cells.iter().enumerate() {
            let loads = if self.bonded_at((low, high)) { self.cell_line_load(index, (low, high)) } else { [0.0; POINTS] };
            for (g, (load, weight)) in loads.into_iter().zip(RULE.weights).enumerate() {
                let place = (index * POINTS + g) * n;
                let strains = self.line.strains.get(place..place + n).unwrap_or(&[]);
                total += (high - low) * weight * density(load, strains);
            }
        }
        total
    }

    /// The springs of the line.
    #[must_use]
    pub const fn springs(&self) -> &'a Springs {
        self.springs
    }

    /// The indenter.
    #[must_use]
    pub const fn profile(&self) -> Profile {
        self.profile
    }
}
