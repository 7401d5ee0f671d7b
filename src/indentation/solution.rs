//! What a history of contact turns out to be.

use super::cycle::Cycle;
use super::spread::Spread;
use super::summary::Summary;
use crate::estimate::Estimate;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// What eight nodes a panel leave unknown of K, over K.
const PANELS: f64 = 3e-9;

/// A step of the integration, as computed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    /// t (s).
    pub time: f64,
    /// Δ (m).
    pub penetration: f64,
    /// F (N), compression positive.
    pub force: f64,
    /// a (m); 0 without contact.
    pub contact_radius: f64,
    /// K_I (Pa√m), tension positive.
    pub stress_intensity_factor: f64,
    /// What the panels beside the edge leave unknown of it (Pa√m).
    pub unresolved_intensity: f64,
    /// Defect of the edge condition: C/Δγ − 1, or Q(a) over its scale without adhesion.
    pub residual: f64,
    /// Piece of the path between corners that the point belongs to; its first point ends the piece before.
    pub piece: u32,
    /// Energies, where asked for.
    pub energies: Option<Energies>,
}

impl PathPoint {
    /// What no integration tells of K_I (Pa√m): eight nodes keep an exponential on a graded panel to 1e-9, and K is their value at an end.
    #[must_use]
    pub fn intensity_floor(&self) -> f64 {
        self.unresolved_intensity + PANELS * self.stress_intensity_factor.abs()
    }

    /// The same of G_tip, which goes with K_I² (J/m²): zero without energies or without K_I.
    #[must_use]
    pub fn tip_release_rate_floor(&self) -> f64 {
        let rate = self.energies.map_or(0.0, |energies| energies.tip_release_rate);
        if rate > 0.0 { 2.0 * rate * (self.intensity_floor() / self.stress_intensity_factor.abs()) } else { 0.0 }
    }
}

/// The account of energies at a step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// U (J).
    pub stored: f64,
    /// P_d (W).
    pub dissipated_power: f64,
    /// Running ∫F dΔ (J).
    pub external_work: f64,
    /// Running ∫G_tip dA (J): what adhesion gives (advancing) or takes (receding) at the tip.
    pub tip_work: f64,
    /// Running ∫P_d dt (J), and what sudden jumps of the edge set free.
    pub dissipated: f64,
    /// Defect of the power balance F dΔ + G_tip dA = dU + P_d dt over this step (J).
    pub balance_defect: f64,
    /// G_tip = K_I²/(2E∞*) (J/m²).
    pub tip_release_rate: f64,
    /// G = G_tip − P_d/(dA/dt) (J/m²), what the whole contact releases for each area; none where the edge is at rest.
    pub energy_release_rate: Option<f64>,
}

/// What happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum EventKind {
    /// The surface jumped into contact at first touch.
    JumpIn,
    /// The edge jumped outwards to another equilibrium.
    JumpOut,
    /// The edge jumped inwards to another, smaller, equilibrium.
    PartialDetachment,
    /// No equilibrium was left: the contact opened.
    Detachment,
    /// The contact shrank to 1.05 process zones; at one the closure has no meaning. The integration treats it as open from here.
    ZoneReached,
    /// Nothing happened: the force pulls most.
    LargestTension,
}

/// When, and in which state it began.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Event<T> {
    /// What.
    pub kind: EventKind,
    /// t (s).
    pub time: T,
    /// Δ (m).
    pub penetration: T,
    /// F (N) just before.
    pub force: T,
    /// a (m) just before.
    pub contact_radius: T,
    /// K_I (Pa√m) just before; zero without contact or without adhesion.
    pub stress_intensity_factor: T,
    /// Energies just before, where asked for: U (J), P_d (W), ∫F dΔ (J) and ∫P_d dt (J) since the start.
    pub energies: Option<[T; 4]>,
    /// G_tip = K_I²/(2E∞*) (J/m²), with the energies.
    pub tip_release_rate: Option<T>,
    /// G = G_tip − P_d/(dA/dt) (J/m²), with the energies: G_tip where the edge accelerates unstably; none where it stands.
    pub energy_release_rate: Option<T>,
}

/// Numbers of an event: t, Δ, F, a, K_I, and the four energies.
pub(super) const NUMBERS: usize = 9;

impl Event<f64> {
    /// What happens in the state of a point.
    pub(super) fn at(kind: EventKind, point: &PathPoint) -> Self {
        Self {
            kind,
            time: point.time,
            penetration: point.penetration,
            force: point.force,
            contact_radius: point.contact_radius,
            stress_intensity_factor: point.stress_intensity_factor,
            energies: point.energies.map(|then| [then.stored, then.dissipated_power, then.external_work, then.dissipated]),
            tip_release_rate: point.energies.map(|then| then.tip_release_rate),
            energy_release_rate: point.energies.and_then(|then| then.energy_release_rate),
        }
    }

    /// What panels leave unknown of its numbers.
    pub(super) fn unknown(&self) -> [f64; NUMBERS] {
        [0.0, 0.0, 0.0, 0.0, PANELS * self.stress_intensity_factor.abs(), 0.0, 0.0, 0.0, 0.0]
    }

    /// One of its [`NUMBERS`], if it is known.
    pub(super) fn number(&self, place: usize) -> Option<f64> {
        let own = [self.time, self.penetration, self.force, self.contact_radius, self.stress_intensity_factor];
        own.get(place).copied().or_else(|| self.energies?.get(place.checked_sub(own.len())?).copied())
    }

    /// The same event with another value for each of its numbers.
    pub(super) fn with<T>(
        &self,
        mut value: impl FnMut(usize, f64) -> T,
        mut rate: impl FnMut(fn(&Self) -> Option<f64>, f64) -> Option<T>,
    ) -> Event<T> {
        Event {
            kind: self.kind,
            time: value(0, self.time),
            penetration: value(1, self.penetration),
            force: value(2, self.force),
            contact_radius: value(3, self.contact_radius),
            stress_intensity_factor: value(4, self.stress_intensity_factor),
            energies: self.energies.map(|[stored, power, work, lost]| [value(5, stored), value(6, power), value(7, work), value(8, lost)]),
            tip_release_rate: self.tip_release_rate.and_then(|own| rate(|event| event.tip_release_rate, own)),
            energy_release_rate: self.energy_release_rate.and_then(|own| rate(|event| event.energy_release_rate, own)),
        }
    }
}

/// Work counters.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct IndentationWork {
    /// Steps taken.
    pub steps: u64,
    /// Evaluations of the edge condition.
    pub closure_evaluations: u64,
    /// Points of the line updated.
    pub history_updates: u64,
    /// Most panels at once.
    pub most_panels: u64,
}

/// One integration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Trace {
    /// What its steps were held to.
    pub tolerance: f64,
    /// Every step, the start included; of more than 40 000 every second one again and again, but for kept instants.
    pub path: Vec<PathPoint>,
    /// Places in the path of the instants to keep.
    pub kept: Vec<usize>,
    /// Events in order.
    pub events: Vec<Event<f64>>,
    /// What no other integration tells of the numbers of each event (s, m, N, m, Pa√m, J, W, J, J): at a fold, beyond the last step, and of K_I.
    pub unknown_of_events: Vec<[f64; NUMBERS]>,
    /// Whole cycles of segments that oscillate, in order.
    pub cycles: Vec<Cycle<f64>>,
    /// By how much the cycles of each segment that oscillates differ, the first tenth left out.
    pub spreads: Vec<Spread>,
    /// Segments that ended early, stationary: which, and how long they took (s).
    pub shortened: Vec<(usize, f64)>,
    /// What is reported of every point, of those as well that a long path no longer holds.
    pub summary: Summary,
    /// Counters.
    pub work: IndentationWork,
    /// Smallest K_I in contact (Pa√m).
    pub smallest_stress_intensity_factor: f64,
    /// Smallest D outside the contact (m).
    pub smallest_gap_factor: f64,
}

impl Default for Trace {
    /// Of no steps.
    fn default() -> Self {
        Self {
            tolerance: 0.0,
            path: Vec::new(),
            kept: Vec::new(),
            events: Vec::new(),
            unknown_of_events: Vec::new(),
            cycles: Vec::new(),
            spreads: Vec::new(),
            shortened: Vec::new(),
            summary: Summary::default(),
            work: IndentationWork::default(),
            smallest_stress_intensity_factor: f64::INFINITY,
            smallest_gap_factor: f64::INFINITY,
        }
    }
}

impl Trace {
    /// The largest tension −F of the path (N), between its points by the polynomial through five; none if nothing pulled.
    #[must_use]
    pub fn largest_tension(&self) -> Option<f64> {
        self.summary.peak().map(|peak| -peak.force)
    }

    /// G (J/m²) as a mean over the step that leads to a point, by two accounts: of the energies, (dU − F dΔ)/dA, and of the tip and what is
    /// dissipated, (G_tip dA − P_d dt)/dA. None without energies, or where the area stays the same.
    #[must_use]
    pub fn release_rates(&self, place: usize) -> Option<(f64, f64)> {
        let (before, after) = (self.path.get(place.checked_sub(1)?)?, self.path.get(place)?);
        let (then, now) = (before.energies?, after.energies?);
        let (inner, outer) = (before.contact_radius, after.contact_radius);
        let area = PI * (outer - inner) * (outer + inner);
        let by_energy = now.stored - then.stored - (now.external_work - then.external_work);
        let by_tip = now.tip_work - then.tip_work - (now.dissipated - then.dissipated);
        (area != 0.0).then_some((by_energy / area, by_tip / area))
    }

    /// Σ|defect| of the power balance over the energy turned over; none without energies.
    #[must_use]
    pub fn balance_defect(&self) -> Option<f64> {
        self.path.last()?.energies?;
        Some(self.summary.balance_defect())
    }
}

/// A kept instant with errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// t (s), exact.
    pub time: f64,
    /// Δ (m).
    pub penetration: Estimate,
    /// F (N).
    pub force: Estimate,
    /// a (m).
    pub contact_radius: Estimate,
    /// K_I (Pa√m).
    pub stress_intensity_factor: Estimate,
    /// Energies, where asked for: U (J), P_d (W), ∫F dΔ (J) and ∫P_d dt (J) since the start.
    pub energies: Option<[Estimate; 4]>,
    /// G_tip = K_I²/(2E∞*) (J/m²), with the energies.
    pub tip_release_rate: Option<Estimate>,
    /// G = dU/dA − F dΔ/dA = G_tip − P_d/(dA/dt) (J/m²), with the energies; none where the edge stands, or turns so near that nothing of it is known.
    pub energy_release_rate: Option<Estimate>,
    /// Defect of the edge condition, C/Δγ − 1.
    pub residual: f64,
}

impl IndentationSolution {
    /// The largest tension −F of the history (N); none if nothing pulled.
    #[must_use]
    pub fn pull_off_force(&self) -> Option<Estimate> {
        self.largest_tension.map(|tension| tension.force.scaled(-1.0))
    }
}

/// A history of contact with errors: an integration, assessed by two behind it that are ten and a hundred times tighter.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationSolution {
    /// The kept instants.
    pub instants: Vec<Instant>,
    /// Events of the integration; errors by the same events of those behind it, infinite if one of these has none.
    pub events: Vec<Event<Estimate>>,
    /// Whole cycles of segments that oscillate.
    pub cycles: Vec<Cycle<Estimate>>,
    /// Where the force pulls most; none if nothing pulled.
    pub largest_tension: Option<Event<Estimate>>,
    /// Defect of the power balance over the energy turned over, where energies were asked for.
    pub balance_defect: Option<f64>,
    /// Smallest K_I at a kept step in contact (Pa√m): below zero the edge would be pressed.
    pub smallest_stress_intensity_factor: f64,
    /// Smallest D of the gap outside the contact at a step (m): below zero faces would overlap.
    pub smallest_gap_factor: f64,
    /// Whether every error met the accuracy.
    pub reached: bool,
    /// Largest defect of the edge condition, C/Δγ − 1.
    pub residual: f64,
    /// The integration itself, or the path by panels.
    pub integration: Trace,
    /// Bounds on Δ, F, a and K at every point of its path, by the other integrations; infinite where one of these does not show them, none of a periodic state.
    pub path_errors: Vec<[f64; 4]>,
    /// Whether it is a path by panels.
    pub by_panels: bool,
    /// Counters of all integrations together.
    pub work: IndentationWork,
}
