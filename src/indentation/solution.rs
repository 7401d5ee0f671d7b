//! What a history of contact turns out to be.

use crate::estimate::Estimate;

/// A step of the march, as computed.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Defect of the edge condition: C/Δγ − 1, or Q(a) over its scale without adhesion.
    pub residual: f64,
    /// U (J).
    pub stored_energy: f64,
    /// P_d (W).
    pub dissipated_power: f64,
    /// Running ∫F dΔ (J).
    pub external_work: f64,
    /// Running ∫G_tip dA (J): what adhesion gives (advancing) or takes (receding) at the tip.
    pub tip_work: f64,
    /// Running ∫P_d dt (J), and what sudden jumps of the edge set free.
    pub dissipated_energy: f64,
    /// Defect of the power balance F dΔ + G_tip dA = dU + P_d dt over this step (J).
    pub balance_defect: f64,
}

/// What happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The surface jumped into contact at first touch.
    JumpIn,
    /// The edge jumped outwards to another equilibrium.
    JumpOut,
    /// The edge jumped inwards to another, smaller, equilibrium.
    PartialDetachment,
    /// No equilibrium was left: the contact opened.
    Detachment,
    /// The contact shrank to the size of the process zone, where the closure has no meaning; the march treats it as open from here.
    ZoneReached,
}

/// When, and in which state it began.
#[derive(Debug, Clone, Copy, PartialEq)]
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
}

/// Work counters.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
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

/// One march.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// Every step, the start included.
    pub path: Vec<PathPoint>,
    /// Places in the path of the instants to keep.
    pub kept: Vec<usize>,
    /// Events in order.
    pub events: Vec<Event<f64>>,
    /// Counters.
    pub work: IndentationWork,
}

impl Trace {
    /// The largest tension −F at a point of the path (N); none if nothing pulled.
    #[must_use]
    pub fn largest_tension(&self) -> Option<f64> {
        let peak = self.path.iter().map(|point| -point.force).max_by(f64::total_cmp)?;
        (peak > 0.0).then_some(peak)
    }

    /// Σ|defect| of the power balance over the energy turned over.
    #[must_use]
    pub fn balance_defect(&self) -> f64 {
        let (mut defect, mut turned) = (0.0, 0.0);
        for pair in self.path.windows(2) {
            defect += pair[1].balance_defect.abs();
            turned += (pair[1].external_work - pair[0].external_work).abs() + (pair[1].tip_work - pair[0].tip_work).abs();
        }
        if turned > 0.0 { defect / turned } else { 0.0 }
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
    /// U (J).
    pub stored_energy: Estimate,
    /// P_d (W).
    pub dissipated_power: Estimate,
    /// ∫F dΔ (J) since the start.
    pub external_work: Estimate,
    /// ∫P_d dt (J) since the start.
    pub dissipated_energy: Estimate,
    /// Defect of the edge condition.
    pub residual: f64,
}

/// A history of contact with errors: the finer of two marches, the coarser as its judge.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationSolution {
    /// The kept instants.
    pub instants: Vec<Instant>,
    /// Events of the finer march; errors by the same event of the coarser one, infinite if it has none.
    pub events: Vec<Event<Estimate>>,
    /// The largest tension of the history (N); none if nothing pulled.
    pub largest_tension: Option<Estimate>,
    /// Defect of the power balance over the energy turned over.
    pub balance_defect: f64,
    /// Largest defect of the edge condition.
    pub residual: f64,
    /// The finer march itself.
    pub fine: Trace,
    /// Counters of both marches together.
    pub work: IndentationWork,
}
