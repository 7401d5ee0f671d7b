//! How the work of adhesion and the process zone follow the edge.
//!
//! ```text
//! Δγ = Δγ₀ · factor(|da/dt|)                 receding (trailing)
//! Δγ = Δγ₀ · leading_ratio · factor(|da/dt|) advancing (leading)
//! δ  = δ₀ · K_I²/(2E0*Δγ₀)                   growing zone, δ₀ at G = Δγ₀
//! ```
//! An edge rests while C lies between the leading work and the trailing work at speed zero. A trailing work that falls with speed, or a leading one that rises, holds no
//! edge at any speed: with v the speed and C_a > 0 the slope of C at once, a small change of the edge grows as e^{|C_a dv/dΔγ| t}.

use crate::closure::work_by_speed::WorkBySpeed;
use crate::refusal::{Refusal, require_positive};

/// What the edge condition knows besides Δγ₀ and δ₀.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeLaw {
    /// Work of adhesion of an advancing edge over that of a receding one, both at rest; at most 1.
    pub leading_ratio: f64,
    /// What both are multiplied by at the speed of the edge.
    pub by_speed: Option<WorkBySpeed>,
    /// Whether δ follows K_I from a constant cohesive stress; otherwise it is constant.
    pub growing_zone: bool,
}

impl EdgeLaw {
    /// One work of adhesion and one process zone.
    pub const CONSTANT: Self = Self { leading_ratio: 1.0, by_speed: None, growing_zone: false };

    pub(super) fn checked(&self) -> Result<(), Refusal> {
        let ratio = require_positive("leading work of adhesion over the trailing one", self.leading_ratio)?;
        if ratio > 1.0 {
            return Err(Refusal::out_of_range(
                "leading work of adhesion over the trailing one",
                ratio,
                "at most 1: closing gives no more than opening takes",
            ));
        }
        Ok(())
    }

    /// Whether the edge may rest, or has a speed that counts.
    pub(super) fn may_rest(&self) -> bool {
        self.leading_ratio < 1.0 || self.by_speed.is_some()
    }

    /// Works at a speed over Δγ₀: receding, advancing.
    pub(super) fn levels(&self, speed: f64) -> [f64; 2] {
        let [trailing, leading] = self.by_speed.as_ref().map_or([1.0; 2], |law| law.factors(speed));
        [trailing, leading * self.leading_ratio]
    }

    /// C/Δγ − 1 for C/Δγ₀ and an edge that goes a way at a speed; of an edge at rest zero, unless C opens or closes it.
    pub(super) fn excess(&self, work: f64, way: f64, speed: f64) -> f64 {
        let [trailing, leading] = self.levels(if way == 0.0 { 0.0 } else { speed });
        let level = if way < 0.0 {
            trailing
        } else if way > 0.0 {
            leading
        } else {
            work.max(leading).min(trailing)
        };
        work / level - 1.0
    }

    /// Passes an edge on that goes inwards or outwards.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] where no speed of it is stable.
    pub(super) fn goes(&self, inwards: bool) -> Result<(), Refusal> {
        let Some([trailing, leading]) = self.by_speed.as_ref().map(WorkBySpeed::trends) else { return Ok(()) };
        let (runs, quantity, reason) = if inwards {
            (trailing.0, "the speed of the receding edge", "its work of adhesion falls with the speed, so that no speed is stable")
        } else {
            (leading.1, "the speed of the advancing edge", "its work of adhesion rises with the speed, so that no speed is stable")
        };
        if runs { Err(Refusal::Undefined { quantity, reason: reason.into() }) } else { Ok(()) }
    }
}

impl Default for EdgeLaw {
    fn default() -> Self {
        Self::CONSTANT
    }
}
