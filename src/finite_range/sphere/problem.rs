//! What is asked: the bodies, the law of attraction, the history, the accuracy.
//!
//! Everything is in reduced units. With the range h₀ and the work of adhesion Δγ of the law, the radius R of the tip and the relaxed
//! modulus E₀*: gaps and penetrations in h₀, radii in √(R h₀), pressures in Δγ/h₀, forces in RΔγ (JKR pull-off 3π/2), works and energies
//! in RΔγh₀, times in the unit of the retardation times. Force and penetration are positive in compression and into the body.
//! Penetration zero: the apex of the undeformed tip lies one range above the undeformed plane (at the wall, if the law has one).

use super::surface::Surface;
use super::tip::Shape;
use crate::finite_range::law::{Attraction, Law};
use crate::indentation::Oscillation;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};

/// Steps of a cycle, at least, at a relative error of [`OF_A_CYCLE`]; for smaller ones more, as the method is of order four.
const STEPS_OF_A_CYCLE: f64 = 16.0;
const OF_A_CYCLE: f64 = 1e-3;
const ORDER: f64 = 0.25;
/// Times nearer than this part of a cycle are one.
pub(super) const ON_TIME: f64 = 1e-9;

/// The viscoelastic half-space, relative to its relaxed modulus: creep compliance 1/β + Σ f_j (1 − 1/β)(1 − e^{−t/τ_j}).
#[derive(Debug, Clone, PartialEq)]
pub struct Creep {
    /// β = E∞/E₀ ≥ 1, glassy over relaxed modulus; 1 for an elastic body.
    pub stiffening: f64,
    /// f_j > 0, of sum one; empty for an elastic body.
    pub fractions: Vec<f64>,
    /// τ_j > 0, retardation times, as many as fractions; their unit is the unit of every time of the problem.
    pub times: Vec<f64>,
}

/// Where a run begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// Relaxed equilibrium at this penetration: in contact, where a contact exists (below zero penetration the surfaces could also be separated).
    Relaxed(f64),
    /// A body without creep strain at this penetration (a negative one, where the surfaces hardly attract).
    Unstrained(f64),
    /// A contact under this value of another control.
    Held {
        /// What is given.
        control: Control,
        /// Its value.
        value: f64,
        /// Relaxed, or without creep strain.
        relaxed: bool,
    },
}

/// What a leg of the history imposes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Control {
    /// The penetration (h₀), positive into the body.
    Penetration,
    /// The force (RΔγ), positive in compression.
    Force,
    /// The travel of a frame of this stiffness (in RΔγ/h₀, > 0): penetration + force/stiffness (h₀).
    Frame(f64),
}

impl Control {
    fn check(self) -> Result<(), Refusal> {
        if let Self::Frame(stiffness) = self {
            require_positive("frame stiffness", stiffness)?;
        }
        Ok(())
    }

    /// Factors of the penetration and the force in what is imposed.
    pub(super) fn factors(self) -> (f64, f64) {
        match self {
            Self::Penetration => (1.0, 0.0),
            Self::Force => (0.0, 1.0),
            Self::Frame(stiffness) => (1.0, 1.0 / stiffness),
        }
    }
}

/// How the imposed quantity moves during a leg. Values and amplitudes have the unit of that quantity; durations and periods have the
/// unit of the retardation times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// At constant rate to a value within a duration; zero is a step at once, during which nothing creeps.
    Ramp {
        /// The value at the end.
        to: f64,
        /// The time it takes.
        duration: f64,
    },
    /// A sine of steady or swept frequency about a straight way to a value, within a duration > 0.
    Swing {
        /// The mean at the end.
        to: f64,
        /// The time it takes.
        duration: f64,
        /// The sine.
        oscillation: Oscillation,
    },
    /// It stays as it is for a duration > 0.
    Hold(f64),
    /// Sine about its present value.
    Oscillation {
        /// Its amplitude, finite; a negative one begins downwards.
        amplitude: f64,
        /// The period, > 0.
        period: f64,
        /// How many periods, > 0.
        cycles: f64,
    },
}

impl Motion {
    /// How long it takes, in the unit of the retardation times.
    #[must_use]
    pub fn duration(self) -> f64 {
        match self {
            Self::Ramp { duration, .. } | Self::Hold(duration) | Self::Swing { duration, .. } => duration,
            Self::Oscillation { period, cycles, .. } => period * cycles,
        }
    }

    /// What swings, if anything does.
    #[must_use]
    pub(super) fn oscillation(self) -> Option<Oscillation> {
        match self {
            Self::Ramp { .. } | Self::Hold(_) => None,
            Self::Oscillation { amplitude, period, .. } => Some(Oscillation::steady(amplitude, 1.0 / period)),
            Self::Swing { oscillation, .. } => Some(oscillation),
        }
    }

    /// The longest step that sees every swing; without bound where nothing swings.
    #[must_use]
    pub(super) fn longest_step(self, steps_of_a_cycle: f64) -> f64 {
        self.oscillation().map_or(f64::INFINITY, |swing| 1.0 / (steps_of_a_cycle * swing.frequency.max(swing.end_frequency)))
    }

    /// When whole cycles end in a leg that begins at a time; none without an oscillation.
    pub(super) fn ends_of_cycles(self, begin: f64) -> impl Iterator<Item = f64> {
        let duration = self.duration();
        let oscillation = self.oscillation();
        let end = move |number: u64| {
            let oscillation = oscillation?;
            let since = oscillation.time_of(number as f64, duration)?;
            // The last one may be the end of the leg but for rounding.
            let is_last = (duration - since) * oscillation.frequency_at(duration, duration) < ON_TIME;
            Some(begin + if is_last { duration } else { since })
        };
        (1..).map_while(end)
    }

    /// The imposed value and its rate at a time since the beginning of the leg, where the value was `from`.
    #[must_use]
    pub fn at(self, since: f64, from: f64) -> (f64, f64) {
        match self {
            Self::Ramp { to, duration } => (from + (to - from) * since / duration, (to - from) / duration),
            Self::Hold(_) => (from, 0.0),
            Self::Swing { to, duration, oscillation } => {
                let slope = (to - from) / duration;
                let speed = std::f64::consts::TAU * oscillation.frequency_at(since, duration);
                let swing = oscillation.amplitude * speed * oscillation.angle(since, duration).cos();
                (from + slope * since + oscillation.deviation(since, duration), slope + swing)
            }
            Self::Oscillation { amplitude, period, .. } => {
                let frequency = std::f64::consts::TAU / period;
                let (sine, cosine) = (frequency * since).sin_cos();
                (from + amplitude * sine, amplitude * frequency * cosine)
            }
        }
    }
}

/// One piece of the history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Which quantity is imposed.
    pub control: Control,
    /// How it moves.
    pub motion: Motion,
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// The shape of the law; its work and range are the units.
    pub law: Law,
    /// The relaxed Tabor number (RΔγ²/(E₀*² h₀³))^{1/3}, > 0.
    pub tabor: f64,
    /// The face of the undeformed tip.
    pub shape: Shape,
    /// The radius (√(R h₀)) at which it ends with a sharp corner; beyond it nothing attracts.
    pub rim: Option<f64>,
    /// The body.
    pub creep: Creep,
    /// Where it begins.
    pub start: Start,
    /// The legs, one after the other.
    pub history: Vec<Leg>,
    /// Times at which a row is wanted (besides those of the integrator).
    pub instants: Vec<f64>,
    /// Times at which the surface is kept.
    pub surfaces: Vec<f64>,
}

impl Problem {
    /// A paraboloid along a history, without wanted instants or surfaces; other fields by `Problem { shape, ..Problem::new(…) }`.
    #[must_use]
    pub fn new(law: Law, tabor: f64, creep: Creep, start: Start, history: Vec<Leg>) -> Self {
        Self { law, tabor, shape: Shape::Paraboloid, rim: None, creep, start, history, instants: Vec::new(), surfaces: Vec::new() }
    }

    /// The glassy Tabor number, tabor/β^{2/3}.
    #[must_use]
    pub fn glassy_tabor(&self) -> f64 {
        self.tabor * self.creep.stiffening.powf(-2.0 / 3.0)
    }

    /// The attraction (in RΔγ, positive) of what lies beyond a radius at a penetration, both bodies undeformed there:
    /// an upper bound of the true attraction.
    ///
    /// # Errors
    /// [`Refusal`] for a law that is not allowed.
    pub fn attraction_beyond(&self, radius: f64, penetration: f64) -> Result<f64, Refusal> {
        let mut surface = Surface::new(self.law.clone(), self.shape.clone(), self.rim)?;
        surface.set_outside(radius);
        Ok(-surface.outside(penetration).0)
    }

    /// Checks every number of the problem, before anything is computed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] with the first that is not allowed.
    pub fn check(&self) -> Result<(), Refusal> {
        require_positive("tabor", self.tabor)?;
        let creep = &self.creep;
        if !(creep.stiffening >= 1.0 && creep.stiffening.is_finite()) {
            return Err(Refusal::out_of_range("stiffening", creep.stiffening, "one or more"));
        }
        if creep.fractions.len() != creep.times.len() {
            return Err(Refusal::out_of_range("fractions", creep.fractions.len() as f64, "as many as retardation times"));
        }
        for &value in &creep.fractions {
            require_positive("fractions", value)?;
        }
        for &time in &creep.times {
            require_positive("times", time)?;
        }
        let sum: f64 = creep.fractions.iter().sum();
        if !creep.fractions.is_empty() && (sum - 1.0).abs() > 1e-9 {
            return Err(Refusal::out_of_range("fractions", sum, "of sum one"));
        }
        if creep.fractions.is_empty() && creep.stiffening > 1.0 {
            return Err(Refusal::out_of_range("stiffening", creep.stiffening, "one for a body without creep terms"));
        }
        self.shape.check(self.rim)?;
        match self.start {
            Start::Relaxed(penetration) | Start::Unstrained(penetration) => require_finite("start penetration", penetration)?,
            Start::Held { control, value, .. } => {
                control.check()?;
                require_finite("start value", value)?
            }
        };
        for leg in &self.history {
            leg.control.check()?;
            match leg.motion {
                Motion::Ramp { to, duration } => {
                    require_finite("ramp target", to)?;
                    require_non_negative("duration", duration)?;
                }
                Motion::Swing { to, duration, oscillation } => {
                    require_finite("mean", to)?;
                    require_positive("duration", duration)?;
                    oscillation.checked()?;
                }
                Motion::Hold(duration) => {
                    require_positive("duration", duration)?;
                }
                Motion::Oscillation { amplitude, period, cycles } => {
                    require_finite("amplitude", amplitude)?;
                    require_positive("period", period)?;
                    require_positive("cycles", cycles)?;
                }
            }
        }
        for &instant in self.instants.iter().chain(&self.surfaces) {
            require_finite("instant", instant)?;
        }
        Ok(())
    }
}

/// Tolerances of one run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Nodes of an element, 4 to 16.
    pub order: usize,
    /// Largest tail (the larger of the last two Legendre coefficients) of the pressure on an element, and of the gap that a creep strain makes.
    pub mesh: f64,
    /// Largest error of the gap in a step, in h₀.
    pub step: f64,
    /// Largest disagreement of the stage forces in a step, relative to max(5, |F|).
    pub force: f64,
    /// Newton's last correction of the gap over `step`.
    pub newton: f64,
    /// Steps of a cycle of an oscillation, at least: what a cycle does is relative to its amplitude, however small that is beside the range.
    pub steps_of_a_cycle: f64,
    /// Attempted steps after which the run ends with a refusal.
    pub budget: usize,
    /// What the tolerances of the mesh and of a step are multiplied by to assess a run, between 0 and 1.
    pub finer: f64,
    /// Nodes that a mesh may have; a run that needs more ends with a refusal. Seven matrices of so many squared are alive at a time.
    pub most_nodes: usize,
}

/// What tolerances are multiplied by to assess a run. Where the law is kinked, ten times tighter ones cost ten times as much; a quarter halves
/// every element at a kink at least once more (its error falls fourfold), so that two runs never share a mesh there.
const FINER: f64 = 0.1;
const KINKED_FINER: f64 = 0.25;
/// The tolerance of the force falls with this power of that of a step.
const FORCE_WITH_STEP: f64 = 0.7;
/// Nodes of an element where the law is kinked.
const KINKED_ORDER: usize = 6;
/// Tolerance of a step there over that of a smooth law: nodes that pass a kink look like errors of the step, and the mesh decides.
const KINKED_STEP: f64 = 3.0;
/// Tolerance of the mesh there over the relative error, and at most.
const KINKED_MESH: f64 = 300.0;
const COARSEST_KINKED_MESH: f64 = 0.1;
/// Tolerance of the force there over that of a smooth law: stage forces see a kink late.
const KINKED_FORCE: f64 = 0.2;
/// Nodes of the mesh there, at most.
const KINKED_NODES: usize = 2000;

impl Accuracy {
    /// The tolerances that give about this relative error of the pull-off force (1e-3 to 1e-8).
    /// A value outside 1e-8…1e-2 is replaced by the nearer end.
    #[must_use]
    pub fn new(relative: f64) -> Self {
        let relative = relative.clamp(1e-8, 1e-2);
        let force = (1e-2 * (relative / 1e-5).powf(FORCE_WITH_STEP)).clamp(2e-4, 5e-2);
        let mesh = (1e-2 * (relative / 1e-5)).clamp(1e-5, 1e-2);
        let steps_of_a_cycle = STEPS_OF_A_CYCLE * (OF_A_CYCLE / relative).max(1.0).powf(ORDER);
        Self { order: 10, mesh, step: relative, force, newton: 0.05, steps_of_a_cycle, budget: 100_000, finer: FINER, most_nodes: 1200 }
    }

    /// The same for a law. Where it is kinked, elements of low order pay, the error falls in proportion to the tolerance of the mesh (the steps in
    /// time leave kinks behind the edge), and more nodes are needed.
    #[must_use]
    pub fn of_law(relative: f64, law: &Attraction) -> Self {
        let smooth = Self::new(relative);
        if !law.is_kinked() {
            return smooth;
        }
        let mesh = (KINKED_MESH * smooth.step).clamp(1e-5, COARSEST_KINKED_MESH);
        let (step, force) = (KINKED_STEP * smooth.step, KINKED_FORCE * smooth.force);
        Self { order: KINKED_ORDER, most_nodes: KINKED_NODES, mesh, step, force, finer: KINKED_FINER, ..smooth }
    }

    /// The length of steps that no tolerance shortens, over that at a relative error of [`OF_A_CYCLE`].
    pub(super) fn length_of_unbound_steps(&self) -> f64 {
        (STEPS_OF_A_CYCLE / self.steps_of_a_cycle).min(1.0)
    }

    /// Checks every tolerance, and the order against that of the mesher.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] with the first that is not allowed.
    pub fn check(&self, order: usize) -> Result<(), Refusal> {
        require_positive("mesh tolerance", self.mesh)?;
        require_positive("step tolerance", self.step)?;
        require_positive("force tolerance", self.force)?;
        require_positive("newton tolerance", self.newton)?;
        require_positive("steps of a cycle", self.steps_of_a_cycle)?;
        if !(self.finer > 0.0 && self.finer < 1.0) {
            return Err(Refusal::out_of_range("finer", self.finer, "between 0 and 1"));
        }
        let allowed = self.order == order && (4..=16).contains(&order);
        if allowed { Ok(()) } else { Err(Refusal::out_of_range("order", self.order as f64, "that of the mesher, 4 to 16")) }
    }

    /// The tolerances of the run that assesses this one.
    #[must_use]
    pub fn tightened(self) -> Self {
        let Self { mesh, step, force, finer, steps_of_a_cycle, .. } = self;
        let steps_of_a_cycle = steps_of_a_cycle * finer.powf(-ORDER);
        Self { mesh: finer * mesh, step: finer * step, force: finer.powf(FORCE_WITH_STEP) * force, steps_of_a_cycle, ..self }
    }
}
