//! The work of the tension inside a moved edge on the gap outside the old one.
//!
//! ```text
//! (1/2δ) ∫₀^δ tension₊(d) gap₋(δ − d) dd          tension₊ of the contact re-solved with that edge moved out by δ,
//!                                                  gap₋ of the contact as it is; at equilibrium 2πΓ
//! ```
//! Both fields are memories of elastic ones. They are integrated over the zone from panel to panel, all terms on the same nodes: the panels grow in
//! equal ratios away from both ends, from the thinnest layer of the material, and those of the gap are those of the tension mirrored. Nodes and
//! steps depend on the material, the speed and δ alone and serve every contact on the way to an equilibrium.
//!
//! | memory | remembers | known where |
//! |---|---|---|
//! | tension at the leading edge, M_ε | what is nearer to the edge | 0 at the edge |
//! | tension at the trailing edge, M_ε | what is farther inside | 0 at the edge; if ε < δ by an integral along the contact at δ |
//! | gap behind the trailing edge, ζM_ζ | what is nearer to the edge | 0 at the edge |
//! | gap ahead of the leading edge, ζM_ζ | what is farther away | 0 at the edge; if ζ < δ by an integral along the gap at δ |
//!
//! # The energy release rate by the same integral
//! With the gap* of the contact that slides the OTHER way over the same edges at the same penetration in place of the gap,
//! ```text
//! U(edge moved) − U = ½ ∫₀^δ tension₊(d) gap*(δ − d) dd
//! ```
//! for the kernel 𝒢ᵀ of the reversed motion is the transpose of 𝒢: with 𝒢ᵀp* = h in the contact, ∫p₊h = ∫p*𝒢p₊ − ∫p₊gap* and ∫p h = ∫p*𝒢p, whose first
//! terms are equal. So G needs no difference of energies, which would lose the digits of Γδ. The reversed contact is the mirror image of
//! one with eccentricity −e. For an elastic solid gap* is the gap, and G = Δγ. Source: our own.
//!
//! Source of the closure: thesis Eqs 3.26–3.30.

use super::arcs::{Arcs, Place};
use super::fields::ArcPoint;
use super::indenter::Indenter;
use super::memory::ContactMemory;
use super::panel::{Direction, NODES, Panel, Step, Values};
use super::resolution::Resolution;
use super::state::ContactState;
use super::system::ContactSystem;
use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};

/// One of the two edges of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// Where the contact opens, at −a.
    Trailing,
    /// Where the contact closes, at +a.
    Leading,
}

/// Never more panels than this in each half: 2^(2·40) from the thinnest layer to the zone.
const MOST_PANELS: usize = 40;
/// The panel next to the edge: its length in units of the thinnest layer.
const FIRST_PANEL: f64 = 1.0;

/// (1/2δ) ∫ tension₊·gap₋ at an edge, in reduced units; `moved` is the contact with that edge moved out by `process_zone`.
#[must_use]
pub fn edge_work(contact: &ContactState, moved: &ContactState, edge: Edge, process_zone: f64) -> f64 {
    let zone = ProcessZone::new(&contact.memory, contact.indenter, edge, process_zone, contact.resolution);
    zone.work(contact, &zone.tension(moved)).value
}

/// The pressure at the nodes of a process zone.
#[derive(Debug, Clone, PartialEq)]
pub struct ZonePressure(Vec<Field>);

/// The gap at the nodes of a process zone.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sliding) struct ZoneGap(Vec<Field>);

/// A sum of three pressures or gaps at the nodes of a process zone.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sliding) struct ZoneSum(Vec<Values>);

impl ZoneSum {
    /// Of pressures.
    pub(in crate::sliding) fn of_pressures(of: &[ZonePressure; 3], parts: [f64; 3]) -> Self {
        Self::new(of.each_ref().map(|one| &one.0[..]), parts)
    }

    /// Of gaps.
    pub(in crate::sliding) fn of_gaps(of: &[ZoneGap; 3], parts: [f64; 3]) -> Self {
        Self::new(of.each_ref().map(|one| &one.0[..]), parts)
    }

    fn new([first, second, third]: [&[Field]; 3], parts: [f64; 3]) -> Self {
        let add = |((one, two), three): ((&Field, &Field), &Field)| one.value * parts[0] + two.value * parts[1] + three.value * parts[2];
        Self(first.iter().zip(second).zip(third).map(add).collect())
    }
}

/// What the fields of all contacts of a half-width are sums of, at the nodes of a process zone.
#[derive(Debug, Clone)]
pub(in crate::sliding) struct ZoneFields {
    /// H₀, H₁, W and S.
    inside: Vec<[Values; 4]>,
    /// g_W, |X| cos(y/2), the depth of H₀, and cos(y/2)/|X| and sin(y/2)/|X|.
    outside: Vec<[Values; 5]>,
}

impl ZoneFields {
    /// Those of the other edge, whose zone is as long: sin(y/2) inside and cos(y/2) outside change their signs.
    pub(in crate::sliding) fn mirrored(&self) -> Self {
        Self {
            inside: self.inside.iter().map(|&[flat, odd, wave, slope]| [flat, -odd, wave, -slope]).collect(),
            outside: self.outside.iter().map(|&[wave, slope, depth, even, odd]| [wave, -slope, depth, -even, odd]).collect(),
        }
    }
}

/// A field at the nodes of a panel, and the sizes of the terms that it is a sum of.
#[derive(Debug, Clone, PartialEq)]
struct Field {
    value: Values,
    size: Values,
}

impl Field {
    fn add(&mut self, term: &Values, factor: f64) {
        self.value += term * factor;
        self.size += term.abs() * factor.abs();
    }
}

/// An integral over a process zone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZoneWork {
    /// The integral.
    pub value: f64,
    /// That of the sizes of all terms, which rounding is relative to.
    pub size: f64,
}

/// The process zone of one edge of a sliding contact: panels, and the steps of every term.
#[derive(Debug, Clone)]
pub struct ProcessZone {
    edge: Edge,
    indenter: Indenter,
    length: f64,
    panels: Vec<Panel>,
    /// Half sines and cosines of the distances, panel by panel.
    angles: Vec<[(f64, f64); NODES]>,
    inside: Vec<TermIntegration>,
    outside: Arc<Vec<TermIntegration>>,
    /// Those of the reversed contact, once they are asked for.
    reversed: OnceLock<Arc<Vec<TermIntegration>>>,
}

/// The other edge: the one that the mirror image of a contact has there.
const fn mirrored(edge: Edge) -> Edge {
    match edge {
        Edge::Trailing => Edge::Leading,
        Edge::Leading => Edge::Trailing,
    }
}

/// The integration of one term.
#[derive(Debug, Clone)]
struct TermIntegration {
    layer: f64,
    direction: Direction,
    /// One for each panel.
    steps: Vec<Step>,
}

impl TermIntegration {
    fn new(panels: &[Panel], length: f64, layer: f64, nearer: bool) -> Self {
        let direction = match (nearer, layer < length) {
            (true, _) => Direction::Nearer,
            (false, true) => Direction::Farther,
            (false, false) => Direction::FartherFromEdge,
        };
        Self { layer, direction, steps: panels.iter().map(|panel| Step::new(panel, layer, direction)).collect() }
    }
}

fn outside_integrations(memory: &ContactMemory, panels: &[Panel], length: f64, edge: Edge) -> Vec<TermIntegration> {
    memory.creep().iter().map(|mode| TermIntegration::new(panels, length, mode.ratio, edge == Edge::Trailing)).collect()
}

impl ProcessZone {
    /// The zone of an edge, of a length δ (1/k).
    #[must_use]
    pub fn new(memory: &ContactMemory, indenter: Indenter, edge: Edge, length: f64, resolution: Resolution) -> Self {
        let panels = panels(length, memory.thinnest_layer(), resolution.panel_ratio());
        let angles = panels.iter().map(|panel| panel.distances.map(|distance| indenter.half_sine_cosine(distance))).collect();
        let inside =
            memory.relaxation.iter().map(|mode| TermIntegration::new(&panels, length, mode.ratio, edge == Edge::Leading)).collect();
        let outside = Arc::new(outside_integrations(memory, &panels, length, edge));
        Self { edge, indenter, length, panels, angles, inside, outside, reversed: OnceLock::new() }
    }

    /// The zones of the trailing and of the leading edge; of equal lengths they share what they can.
    #[must_use]
    pub fn both(memory: &ContactMemory, indenter: Indenter, lengths: (f64, f64), resolution: Resolution) -> (Self, Self) {
        let mut trailing = Self::new(memory, indenter, Edge::Trailing, lengths.0, resolution);
        let mut leading = Self::new(memory, indenter, Edge::Leading, lengths.1, resolution);
        if lengths.0.to_bits() == lengths.1.to_bits() {
            trailing.reversed = OnceLock::from(Arc::clone(&leading.outside));
            leading.reversed = OnceLock::from(Arc::clone(&trailing.outside));
        }
        (trailing, leading)
    }

    /// δ (1/k).
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// The fields of a half-width at the nodes, from the systems of the contact with that edge moved out and of the contact itself.
    pub(in crate::sliding) fn fields(&self, moved: &ContactSystem, own: &ContactSystem) -> ZoneFields {
        ZoneFields { inside: self.inside_fields(moved.arcs()), outside: self.outside_fields(own.arcs(), self.edge) }
    }

    /// The pressure inside the edge of a contact with that edge moved out.
    #[must_use]
    pub fn tension(&self, moved: &ContactState) -> ZonePressure {
        ZonePressure(self.pressures(moved, &self.inside_fields(&moved.arcs)))
    }

    /// The same with the fields of its half-width.
    pub(in crate::sliding) fn tension_by(&self, fields: &ZoneFields, moved: &ContactState) -> ZonePressure {
        ZonePressure(self.pressures(moved, &fields.inside))
    }

    /// The gap outside the edge of a contact, with the fields of its half-width.
    pub(in crate::sliding) fn gap_by(&self, fields: &ZoneFields, contact: &ContactState) -> ZoneGap {
        ZoneGap(self.gaps(contact, &self.outside, &fields.outside))
    }

    /// (1/2δ) ∫ tension₊·gap₋, in reduced units; NaN if a field is.
    #[must_use]
    pub fn work(&self, contact: &ContactState, tension: &ZonePressure) -> ZoneWork {
        let fields = self.outside_fields(&contact.arcs, self.edge);
        self.work_of(tension, &ZoneGap(self.gaps(contact, &self.outside, &fields)))
    }

    /// The same of a gap.
    pub(in crate::sliding) fn work_of(&self, tension: &ZonePressure, gap: &ZoneGap) -> ZoneWork {
        self.integral(&tension.0, &gap.0)
    }

    /// (1/2δ) ∫ tension·gap of any two fields.
    pub(in crate::sliding) fn work_on(&self, tension: &ZoneSum, gap: &ZoneSum) -> f64 {
        let mut value = 0.0;
        for ((panel, pressure), gap) in self.panels.iter().zip(&tension.0).zip(gap.0.iter().rev()) {
            for index in 0..NODES {
                value -= panel.weights[index] * pressure[index] * gap[NODES - 1 - index];
            }
        }
        value / (2.0 * self.length)
    }

    /// [U(edge moved) − U]/δ, in reduced units, from the contact with that edge moved out and the mirror image of the contact that slides the
    /// other way ([`ContactState::reversed`]); NaN if a field is.
    #[must_use]
    pub fn release(&self, reversed: &ContactState, tension: &ZonePressure) -> ZoneWork {
        let edge = mirrored(self.edge);
        let integrations = self.reversed.get_or_init(|| Arc::new(outside_integrations(&reversed.memory, &self.panels, self.length, edge)));
        self.integral(&tension.0, &self.gaps(reversed, integrations, &self.outside_fields(&reversed.arcs, edge)))
    }

    fn integral(&self, pressures: &[Field], gaps: &[Field]) -> ZoneWork {
        let (mut value, mut size) = (0.0, 0.0);
        for ((panel, pressure), gap) in self.panels.iter().zip(pressures).zip(gaps.iter().rev()) {
            // The mirrored panel has its nodes in the opposite order.
            for index in 0..NODES {
                let mirror = NODES - 1 - index;
                value -= panel.weights[index] * pressure.value[index] * gap.value[mirror];
                size += panel.weights[index] * pressure.size[index] * gap.size[mirror];
            }
        }
        ZoneWork { value: value / (2.0 * self.length), size: size / (2.0 * self.length) }
    }

    /// H₀, H₁, W and S at the nodes of the zone inside the edge.
    fn inside_fields(&self, arcs: &Arcs) -> Vec<[Values; 4]> {
        let fields_of = |angles: &[(f64, f64); NODES]| {
            let mut fields = [Values::zeros(); 4];
            for (index, &sine_cosine) in angles.iter().enumerate() {
                let Place { root, angle } = arcs.inside_at(sine_cosine, self.edge == Edge::Trailing);
                let [flat, odd, wave] = self.indenter.pressures(angle, root, (0.0, 1.0));
                for (field, value) in fields.iter_mut().zip([flat, odd, wave, self.indenter.slope(angle, root)]) {
                    field[index] = value;
                }
            }
            fields
        };
        self.angles.iter().map(fields_of).collect()
    }

    /// p at the nodes of the zone inside the edge.
    fn pressures(&self, state: &ContactState, fields: &[[Values; 4]]) -> Vec<Field> {
        let half_width = state.edges.half_width;
        let (sin_e, cos_e) = self.indenter.shift(state.edges.eccentricity);
        let elastic: Vec<[Values; 3]> = fields.iter().map(|[flat, odd, wave, slope]| [*flat, *odd, wave * cos_e - slope * sin_e]).collect();
        let combined = |(flat, odd): (f64, f64), [even, uneven, wave]: &[Values; 3]| wave + even * flat + uneven * odd;
        let beta = state.memory.stiffening_ratio();
        let now = state.strengths(None);
        let mut pressures: Vec<Field> = elastic
            .iter()
            .map(|fields| {
                let value = combined(now, fields) * beta;
                Field { size: value.abs(), value }
            })
            .collect();
        for (term, (integration, mode)) in self.inside.iter().zip(&state.memory.relaxation).enumerate() {
            let strengths = state.strengths(Some(term));
            let far = || {
                let inside = ArcPoint { from_trailing: self.length, from_leading: 2.0 * half_width - self.length };
                state.remembered_inside(inside, term)
            };
            self.integrate(
                integration,
                far,
                |panel| elastic.get(panel).map(|fields| combined(strengths, fields)),
                |panel, memory| {
                    if let Some(pressure) = pressures.get_mut(panel) {
                        pressure.add(memory, -mode.modulus);
                    }
                },
            );
        }
        pressures
    }

    /// g_W, |X| cos(y/2), the depth of H₀, and cos(y/2)/|X| and sin(y/2)/|X| at the nodes of the zone outside an edge.
    fn outside_fields(&self, arcs: &Arcs, edge: Edge) -> Vec<[Values; 5]> {
        let fields_of = |angles: &[(f64, f64); NODES]| {
            let mut fields = [Values::zeros(); 5];
            for (index, &sine_cosine) in angles.iter().enumerate() {
                let Place { root, angle } = arcs.outside_at(sine_cosine, edge == Edge::Trailing);
                let (wave, depth) = self.indenter.gaps(angle, root, arcs.half.0, (0.0, 1.0));
                for (field, value) in fields.iter_mut().zip([wave, angle.1 * root, depth, angle.1 / root, angle.0 / root]) {
                    field[index] = value;
                }
            }
            fields
        };
        self.angles.iter().map(fields_of).collect()
    }

    /// The gap at the nodes of the zone outside an edge.
    fn gaps(&self, state: &ContactState, integrations: &[TermIntegration], fields: &[[Values; 5]]) -> Vec<Field> {
        let gap_width = 2.0 * state.edges.half_gap;
        let (sin_e, cos_e) = self.indenter.shift(state.edges.eccentricity);
        let elastic = |[wave, slope, depth, ..]: &[Values; 5]| {
            let value = wave * cos_e + slope * sin_e - depth * state.flat_strength;
            Field { size: value.abs(), value }
        };
        let mut gaps: Vec<Field> = fields.iter().map(elastic).collect();
        for (term, integration) in integrations.iter().enumerate() {
            let (Some(&load), Some(&(outside_cosine, outside_sine))) = (state.loads.get(term), state.outside.get(term)) else { continue };
            let far = || {
                let outside = ArcPoint { from_trailing: gap_width - self.length, from_leading: self.length };
                state.remembered_outside(outside, term)
            };
            let field = |panel: usize| fields.get(panel).map(|[.., even, odd]| odd * outside_cosine + even * outside_sine);
            self.integrate(integration, far, field, |panel, memory| {
                if let Some(gap) = gaps.get_mut(panel) {
                    gap.add(memory, -load * integration.layer * 2.0 / PI);
                }
            });
        }
        gaps
    }

    /// Integrates a memory u = Mf over the zone; `far` gives it at the far end, where it is asked for.
    fn integrate(
        &self,
        term: &TermIntegration,
        far: impl Fn() -> f64,
        field: impl Fn(usize) -> Option<Values>,
        mut use_memory: impl FnMut(usize, &Values),
    ) {
        let mut value = if term.direction == Direction::Farther { far() } else { 0.0 };
        for step in 0..self.panels.len() {
            let index = if term.direction == Direction::Farther { self.panels.len() - 1 - step } else { step };
            let (Some(panel), Some(factored), Some(field)) = (self.panels.get(index), term.steps.get(index), field(index)) else {
                continue;
            };
            let times_root = Values::from_fn(|node, _| panel.roots[node] * field[node]);
            let (memory, out) = factored.advance(&times_root, value);
            use_memory(index, &memory);
            value = out;
        }
    }
}

/// Panels from the edge to the far end, growing away from both ends.
fn panels(length: f64, thinnest: f64, ratio: f64) -> Vec<Panel> {
    let middle = (0.5 * length).sqrt();
    let first = middle.min((FIRST_PANEL * thinnest).sqrt());
    let count = ((middle / first).ln() / ratio.ln()).ceil().clamp(0.0, MOST_PANELS as f64) as usize;
    // The last break is the middle itself; a first panel beyond the resolvable range is longer.
    let step = if count == 0 { 1.0 } else { (middle / first).powf(1.0 / count as f64).min(ratio) };
    let mut breaks: Vec<f64> = (0..=count).rev().map(|power| middle / step.powi(i32::try_from(power).unwrap_or(i32::MAX))).collect();
    breaks.insert(0, 0.0);
    let halves = breaks.windows(2).filter_map(|pair| if let [low, high] = *pair { Some((low, high)) } else { None });
    let mut panels: Vec<Panel> = halves.clone().map(|(low, high)| Panel::new(low, high, None)).collect();
    panels.extend(halves.rev().map(|(low, high)| Panel::new(low, high, Some(length))));
    panels
}
