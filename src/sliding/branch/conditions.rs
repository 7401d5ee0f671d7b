//! What is asked of a branch, in reduced units.

use crate::closure::work_by_speed::WorkBySpeed;
use crate::material::PlaneMaterial;
use crate::refusal::{Refusal, require_positive};
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::{SlidingControl, WaveAdhesion};
use crate::sliding::steady::{Prepared, SlidingProblem, adhesion_at};

/// Half the narrowest gap of a branch, over the longer process zone.
const GAP_IN_ZONES: f64 = 2.0;

/// What varies along a branch, and what is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BranchPath {
    /// The load: from a narrow contact to a wide one at one speed.
    Loads,
    /// The rate kv at a held load, penetration or half-width.
    Speeds(SlidingControl),
    /// The work of adhesion Γ of the trailing edge, that of the leading one in a fixed ratio to it.
    Adhesions(SlidingControl),
    /// The process zones, both multiplied by one factor.
    Zones(SlidingControl),
}

/// Where a branch begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BranchStart {
    /// At the contact that [`steady_sliding`](crate::sliding::steady::steady_sliding) finds; along speeds: the slow one.
    Slow,
    /// Along speeds: the fast one.
    Fast,
    /// Near given edges, half-width and eccentricity in 1/k, at a given mean pressure and parameter (rate kv in 1/s, Γ, or factor of the zones; along loads of no
    /// meaning).
    Near {
        /// a.
        half_width: f64,
        /// e.
        eccentricity: f64,
        /// p̄.
        mean_pressure: f64,
        /// kv, Γ, or the factor.
        parameter: f64,
    },
}

/// A branch: everything but the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BranchProblem<'a> {
    /// kv (1/s), zero or more; along speeds only the rate at which `adhesion` holds.
    pub rate: f64,
    /// The indenter.
    pub indenter: Indenter,
    /// Adhesion at that rate; along adhesions and zones the one where the branch begins.
    pub adhesion: WaveAdhesion,
    /// How the works of adhesion follow the rate kv (1/s), if they do.
    pub work_by_speed: Option<&'a WorkBySpeed>,
    /// What varies.
    pub path: BranchPath,
    /// Where the branch begins.
    pub start: BranchStart,
    /// Narrowest and widest half-width in 1/k.
    pub half_widths: [f64; 2],
    /// Smallest and largest rate kv (1/s), Γ or factor of the zones; along loads of no meaning.
    pub parameters: [f64; 2],
    /// Wanted |error| ≤ accuracy·max(|value|, scale) of every output, scale one in reduced units.
    pub accuracy: f64,
    /// How many points are kept and solved to the accuracy, evenly spaced along the curve; none is allowed.
    pub points: usize,
}

impl<'a> BranchProblem<'a> {
    /// The branch of all loads on a wave at one rate, as far as the equations mean something: the contact two process zones wide and the gap four. (A zone
    /// that fills half of the gap meets the next contact; there the work of closing has turns of its own.)
    #[must_use]
    pub fn loads(rate: f64, adhesion: WaveAdhesion, accuracy: f64) -> Self {
        let zone = adhesion.trailing_zone.max(adhesion.leading_zone);
        Self {
            rate,
            indenter: Indenter::Wave,
            adhesion,
            work_by_speed: None,
            path: BranchPath::Loads,
            start: BranchStart::Slow,
            half_widths: [zone, std::f64::consts::PI - GAP_IN_ZONES * zone],
            parameters: [0.0, f64::INFINITY],
            accuracy,
            points: 0,
        }
    }

    /// The branch of a held load, penetration or half-width over a range of rates kv (1/s), from the slow or the fast contact.
    #[must_use]
    pub fn speeds(control: SlidingControl, rates: [f64; 2], start: BranchStart, adhesion: WaveAdhesion, accuracy: f64) -> Self {
        Self { path: BranchPath::Speeds(control), start, parameters: rates, ..Self::loads(rates[0], adhesion, accuracy) }
    }

    /// The control that is held; none along loads.
    #[must_use]
    pub const fn held(&self) -> Option<SlidingControl> {
        match self.path {
            BranchPath::Loads => None,
            BranchPath::Speeds(control) | BranchPath::Adhesions(control) | BranchPath::Zones(control) => Some(control),
        }
    }

    /// The steady problem at a point of the branch: `third` is the third unknown.
    pub(in crate::sliding) fn steady(&self, third: f64, control: SlidingControl) -> SlidingProblem<'a> {
        let (rate, adhesion) = self.at(third);
        SlidingProblem {
            rate,
            indenter: self.indenter,
            adhesion: Some(adhesion),
            work_by_speed: self.work_by_speed,
            control,
            accuracy: self.accuracy,
        }
    }

    /// The edge conditions at a point of the branch, for its accurate contacts.
    pub(super) fn prepared(&self, material: &PlaneMaterial, third: f64) -> Result<Prepared, Refusal> {
        let (rate, adhesion) = self.at(third);
        Prepared::new(material, rate, self.indenter, Some(adhesion))
    }

    /// Rate and adhesion at a value of the third unknown.
    pub(super) fn at(&self, third: f64) -> (f64, WaveAdhesion) {
        let value = third.exp();
        match self.path {
            BranchPath::Loads => (self.rate, self.adhesion),
            BranchPath::Speeds(_) => (value, adhesion_at(self.adhesion, self.work_by_speed, self.rate, value)),
            BranchPath::Adhesions(_) => (self.rate, self.adhesion.with_trailing_work(value)),
            BranchPath::Zones(_) => (self.rate, self.adhesion.with_zones_times(value)),
        }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`]; [`Refusal::Undefined`] for the penetration of a parabola.
    pub fn checked(&self) -> Result<(), Refusal> {
        // Those of the steady problem at the start.
        let half_width = require_positive("narrowest half_width", self.half_widths[0])?;
        let control = self.held().unwrap_or(SlidingControl::HalfWidth(half_width));
        let rate = if matches!(self.path, BranchPath::Speeds(_)) { self.parameters[0] } else { self.rate };
        let adhesion = Some(self.adhesion);
        let work_by_speed = self.work_by_speed;
        SlidingProblem { rate, indenter: self.indenter, adhesion, work_by_speed, control, accuracy: self.accuracy }.checked()?;
        let widest = self.half_widths[1];
        if !(widest > half_width && widest < self.indenter.widest()) {
            return Err(Refusal::out_of_range("widest half_width", widest, "above the narrowest one and, of a wave, below π (in 1/k)"));
        }
        if self.path != BranchPath::Loads {
            require_positive("smallest parameter", self.parameters[0])?;
            require_positive("largest parameter", self.parameters[1])?;
            if self.parameters[1] <= self.parameters[0] {
                return Err(Refusal::out_of_range("largest parameter", self.parameters[1], "above the smallest one"));
            }
        }
        if let BranchStart::Near { half_width, parameter, .. } = self.start {
            require_positive("half_width", half_width)?;
            if self.path != BranchPath::Loads {
                require_positive("parameter", parameter)?;
            }
        }
        Ok(())
    }
}
