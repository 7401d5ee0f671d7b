//! The record of an integration: points of its path, kept instants, events, the account of energies.

use super::checkpoint::ContactState;
use super::cycle::Cycle;
use super::cycle_integrals::CycleIntegrals;
use super::folds::Fold;
use super::line::Contact;
use super::motion::Motion;
use super::panel::RULE;
use super::path_history::Node;
use super::solution::{Energies, Event, EventKind, PathPoint, Trace};
use crate::refusal::Refusal;
use serde::{Deserialize, Serialize};

/// Most points of a path, and most cycles, that are held; kept instants come on top.
const MOST_POINTS: usize = 40_000;
const MOST_CYCLES: usize = 4_096;
/// Newest points that are never dropped: what is continued from them.
const NEWEST: usize = 8;

pub(super) struct Record<'a> {
    pub(super) trace: Trace,
    piece: u32,
    energies: bool,
    /// ∫F dΔ, ∫G_tip dA and ∫P_d dt since the last point.
    turned_over: [f64; 3],
    /// dA/dt at the end of the last motion.
    area_rate: f64,
    /// Whether the next point follows at once: what is set free then is dissipated.
    sudden: bool,
    /// The contact at the last point, for what a sudden change sets free.
    last: Option<Contact<'a>>,
    /// Every so many cycles are kept, and the newest until its segment ends.
    cycle_stride: u64,
    newest_cycle: Option<Cycle<f64>>,
}

/// A record without the solid it is of.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct RecordState {
    trace: Trace,
    piece: u32,
    turned_over: [f64; 3],
    area_rate: f64,
    sudden: bool,
    last: Option<ContactState>,
    cycle_stride: u64,
    newest_cycle: Option<Cycle<f64>>,
}

impl<'a> Record<'a> {
    pub(super) fn state(&self) -> RecordState {
        let Self { trace, piece, energies: _, turned_over, area_rate, sudden, last, cycle_stride, newest_cycle } = self;
        RecordState {
            trace: trace.clone(),
            piece: *piece,
            turned_over: *turned_over,
            area_rate: *area_rate,
            sudden: *sudden,
            last: last.as_ref().map(ContactState::of),
            cycle_stride: *cycle_stride,
            newest_cycle: *newest_cycle,
        }
    }

    /// The record of a state, of the same springs and profile as `like`.
    pub(super) fn restored(state: RecordState, like: &Contact<'a>) -> Result<Self, Refusal> {
        let RecordState { trace, piece, turned_over, area_rate, sudden, last, cycle_stride, newest_cycle } = state;
        let last = last.map(|last| last.restored(like)).transpose()?;
        Ok(Self { trace, piece, energies: last.is_some(), turned_over, area_rate, sudden, last, cycle_stride, newest_cycle })
    }

    pub(super) fn new(contact: &Contact<'a>, energies: bool) -> Self {
        Self {
            trace: Trace::default(),
            piece: 0,
            energies,
            turned_over: [0.0; 3],
            area_rate: 0.0,
            sudden: false,
            last: energies.then(|| contact.clone()),
            cycle_stride: 1,
            newest_cycle: None,
        }
    }

    /// The record of something else than a [`Contact`], which makes its own points.
    pub(super) fn without_contact() -> Self {
        Self {
            trace: Trace::default(),
            piece: 0,
            energies: false,
            turned_over: [0.0; 3],
            area_rate: 0.0,
            sudden: false,
            last: None,
            cycle_stride: 1,
            newest_cycle: None,
        }
    }

    /// The same of a state.
    pub(super) fn restored_without_contact(state: RecordState) -> Self {
        let RecordState { trace, piece, turned_over, area_rate, sudden, last: _, cycle_stride, newest_cycle } = state;
        Self { trace, piece, energies: false, turned_over, area_rate, sudden, last: None, cycle_stride, newest_cycle }
    }

    pub(super) const fn piece(&self) -> u32 {
        self.piece
    }

    pub(super) fn force(&self) -> f64 {
        self.trace.path.last().map_or(0.0, |point| point.force)
    }

    pub(super) fn new_piece(&mut self) {
        self.piece += 1;
    }

    pub(super) fn sudden(&mut self) {
        self.sudden = true;
        self.piece += 1;
    }

    /// The last point is to be kept.
    pub(super) fn keep(&mut self) {
        self.trace.kept.push(self.trace.path.len().saturating_sub(1));
    }

    /// Adds up what a motion turns over, by Gauss points of the motion itself: the line is exact at any instant within it.
    pub(super) fn passed(&mut self, from: &Contact<'a>, motion: &Motion) {
        if !self.energies {
            return;
        }
        self.area_rate = if motion.time > 0.0 { motion.area_rate(from.profile(), 1.0) / motion.time } else { 0.0 };
        let mut sums = [0.0; 3];
        let profile = from.profile();
        for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
            let part = motion.until(profile, *x);
            let middle = from.after(&part, part.end_penetration());
            let (depth_rate, area_rate) = rates(motion, profile, *x);
            sums[0] += weight * depth_rate * middle.force();
            sums[1] += weight * area_rate * middle.tip_release_rate();
            sums[2] += weight * motion.time * middle.dissipated_power();
        }
        for (total, sum) in self.turned_over.iter_mut().zip(sums) {
            *total += sum;
        }
    }

    /// Adds the present state to the path.
    pub(super) fn point(&mut self, time: f64, contact: &Contact<'a>, residual: f64) {
        let loads = contact.line_load();
        let force = 2.0 * loads.iter().map(super::panel::Panel::integral).sum::<f64>();
        let a = contact.radius();
        let (intensity, unresolved) = contact.stress_intensity_known();
        let energies = self.energies.then(|| self.account(contact, force));
        self.push(PathPoint {
            time,
            penetration: contact.penetration(),
            force,
            contact_radius: a,
            stress_intensity_factor: intensity,
            unresolved_intensity: unresolved,
            residual,
            piece: self.piece,
            energies,
        });
        if a > 0.0 {
            if a < contact.profile().rim() {
                // A rim may be pressed.
                let least = &mut self.trace.smallest_stress_intensity_factor;
                *least = least.min(intensity);
            }
            let gaps = contact.gap_factor(0.0);
            let smallest = gaps.iter().flat_map(|panel| panel.values).fold(f64::INFINITY, f64::min);
            let least = &mut self.trace.smallest_gap_factor;
            *least = least.min(smallest);
        }
        self.trace.work.most_panels = self.trace.work.most_panels.max(contact.panels() as u64);
        if self.energies {
            self.last = Some(contact.clone());
        }
    }

    fn account(&mut self, contact: &Contact<'a>, force: f64) -> Energies {
        let stored = contact.stored_energy();
        let (dissipated_power, tip_release_rate) = (contact.dissipated_power(), contact.tip_release_rate());
        let release = tip_release_rate - dissipated_power / self.area_rate;
        let energy_release_rate = (self.area_rate != 0.0 && release.is_finite()).then_some(release);
        let mut now = Energies { stored, dissipated_power, tip_release_rate, energy_release_rate, ..Energies::default() };
        let Some(before) = self.trace.path.last().and_then(|point| point.energies) else { return now };
        let [mut external, tip, lost] = std::mem::take(&mut self.turned_over);
        if std::mem::take(&mut self.sudden) {
            // At once: what acts from outside, a held force or the spring of a frame, is linear in Δ; the rest is lost. The edge's own way there,
            // along which nothing is in equilibrium, tells nothing.
            external = self.last.as_ref().map_or(0.0, |last| 0.5 * (last.force() + force) * (contact.penetration() - last.penetration()));
            now.external_work = before.external_work + external;
            now.tip_work = before.tip_work;
            now.dissipated = before.dissipated + external + before.stored - stored;
        } else {
            now.external_work = before.external_work + external;
            now.tip_work = before.tip_work + tip;
            now.dissipated = before.dissipated + lost;
            now.balance_defect = external + tip - (stored - before.stored) - lost;
        }
        now
    }

    /// A whole cycle has gone by: whether cycles are stationary. Of many cycles only every so many are kept.
    pub(super) fn cycle(&mut self, cycle_integrals: &mut CycleIntegrals, end: f64, tolerance: f64) -> Option<bool> {
        let (cycle, stationary) = cycle_integrals.finished(end, tolerance);
        self.add_cycle(cycle, stationary);
        Some(stationary)
    }

    /// The last cycle once more.
    pub(super) fn cycle_again(&mut self, cycle_integrals: &mut CycleIntegrals) {
        if let Some(cycle) = cycle_integrals.again() {
            self.add_cycle(cycle, false);
        }
    }

    fn add_cycle(&mut self, cycle: Cycle<f64>, stationary: bool) {
        if (cycle.number - 1).is_multiple_of(self.cycle_stride) || stationary {
            self.trace.cycles.push(cycle);
        }
        self.newest_cycle = Some(cycle);
        if self.trace.cycles.len() > MOST_CYCLES {
            self.cycle_stride *= 2;
            let stride = self.cycle_stride;
            self.trace.cycles.retain(|cycle| (cycle.number - 1).is_multiple_of(stride));
        }
    }

    /// How long a segment takes that is known to end early (s).
    pub(super) fn end_of(&self, segment: usize) -> Option<f64> {
        self.trace.shortened.iter().find(|stop| stop.0 == segment).map(|stop| stop.1)
    }

    /// A segment has ended: the last cycle of one that oscillates is kept, and by how much its cycles differ.
    pub(super) fn last_cycle(&mut self, cycle_integrals: Option<CycleIntegrals>) {
        self.trace.spreads.extend(cycle_integrals.and_then(|cycle_integrals| cycle_integrals.spread()));
        if let Some(newest) = self.newest_cycle.take() {
            let there = self.trace.cycles.last().is_some_and(|cycle| (cycle.segment, cycle.number) == (newest.segment, newest.number));
            if !there {
                self.trace.cycles.push(newest);
            }
        }
    }

    /// Adds a point to the path; of a long path every second point is dropped, but for kept ones and the newest.
    pub(super) fn push(&mut self, point: PathPoint) {
        self.trace.summary.add(&point, self.trace.path.last());
        self.trace.path.push(point);
        if self.trace.path.len() > MOST_POINTS + self.trace.kept.len() {
            let newest = self.trace.path.len().saturating_sub(NEWEST);
            let mut kept = self.trace.kept.iter().copied().peekable();
            let (mut path, mut places) = (Vec::with_capacity(MOST_POINTS), Vec::with_capacity(self.trace.kept.len()));
            for (index, point) in self.trace.path.iter().enumerate() {
                let mut stays = index >= newest || index.is_multiple_of(2);
                while kept.peek() == Some(&index) {
                    kept.next();
                    places.push(path.len());
                    stays = true;
                }
                if stays {
                    path.push(*point);
                }
            }
            (self.trace.path, self.trace.kept) = (path, places);
        }
    }

    pub(super) fn event(&mut self, event: Event<f64>) {
        self.trace.events.push(event);
        let floor = self.trace.path.last().map_or(0.0, PathPoint::intensity_floor);
        self.trace.unknown_of_events.push([0.0, 0.0, 0.0, 0.0, floor, 0.0, 0.0, 0.0, 0.0]);
    }

    /// An event in the state of the last point.
    pub(super) fn happened(&mut self, kind: EventKind) {
        if let Some(point) = self.trace.path.last() {
            self.event(Event::at(kind, point));
        }
    }

    /// An event at a fold of t(a) a little ahead of the last point: values continued to it, over the radius, in which all go on smoothly.
    pub(super) fn happened_at_fold(&mut self, kind: EventKind, nodes: &[Node], fold: Option<Fold>) {
        self.happened(kind);
        let (Some(Fold { distance, unknown }), Some([now, one, two])) = (fold, nodes.get(..3)) else { return };
        let (Some(last), Some(event)) = (self.trace.path.last_chunk::<3>(), self.trace.events.last().copied()) else { return };
        let [first, second, third] = last.each_ref().map(|point| Event::at(kind, point));
        if now.radius.total_cmp(&one.radius).is_eq()
            || one.radius.total_cmp(&two.radius).is_eq()
            || now.radius.total_cmp(&two.radius).is_eq()
        {
            // No polynomial goes through these.
            return;
        }
        let newest_first = [(now, third), (one, second), (two, first)];
        let place = now.radius + distance * (now.radius - one.radius).signum();
        let weights = newest_first.map(|(node, _)| {
            let others = newest_first.iter().map(|(other, _)| other.radius).filter(|other| other.to_bits() != node.radius.to_bits());
            others.map(|other| (place - other) / (node.radius - other)).product::<f64>()
        });
        let sum = |values: [f64; 3]| values.iter().zip(weights).map(|(value, weight)| value * weight).sum::<f64>();
        // A node has more digits of the time between points.
        let of_nodes = |of: fn(&Node) -> f64| sum(newest_first.map(|(node, _)| of(node)));
        let continued = |number: usize, own: f64| match number {
            0 => event.time + of_nodes(|node| node.time),
            1 => of_nodes(|node| node.penetration),
            2 => of_nodes(|node| node.force),
            3 => place,
            _ => sum(newest_first.map(|(_, point)| point.number(number).unwrap_or(own))),
        };
        let mut at_fold = event.with(continued, |_, own| Some(own));
        // The edge accelerates unstably: no time is left to dissipate anything. G_tip goes with K².
        let growth = at_fold.stress_intensity_factor / event.stress_intensity_factor;
        at_fold.tip_release_rate = event.tip_release_rate.map(|rate| if rate > 0.0 { rate * growth * growth } else { rate });
        at_fold.energy_release_rate = at_fold.tip_release_rate;
        if let (Some(newest), Some(left)) = (self.trace.events.last_mut(), self.trace.unknown_of_events.last_mut()) {
            for (number, left) in left.iter_mut().enumerate() {
                let change = at_fold.number(number).zip(event.number(number)).map_or(0.0, |(then, now)| then - now);
                *left += unknown * change.abs();
            }
            *newest = at_fold;
        }
    }

    pub(super) fn finished(&mut self) -> Trace {
        std::mem::take(&mut self.trace)
    }
}

/// dΔ/du and dA/du of a motion at a part of its time.
fn rates(motion: &Motion, profile: &super::profile::Profile, part: f64) -> (f64, f64) {
    let depth = motion.powers.iter().enumerate().rev().fold(0.0, |sum, (k, power)| sum * part + (k as f64 + 1.0) * power);
    (depth, motion.area_rate(profile, part))
}
