//! An edge that rests between its two works of adhesion: whether it does, when it leaves, and when it comes to rest.

use super::edge::{Drive, Imposed};
use super::integrator::{CLOCK, Integrator};
use super::stepping::Way;
use crate::continuation::bracket::halved_if;
use crate::refusal::Refusal;

/// Part of a step within which an edge that leaves has not rested.
const AT_ONCE: f64 = 1e-9;
/// Way of an edge about to rest, over the process zone and the tolerance of the path, that is none.
const NO_WAY: f64 = 1e-3;

/// g of an edge that is as good as balanced.
const BALANCED: f64 = 1e-8;

impl Integrator<'_> {
    /// The way that the edge goes in a step of at most `cap`, which is made shorter where the edge comes to rest within it; none where the edge has rested until the
    /// instant at which it leaves, and is there now.
    pub(super) fn way(&mut self, cap: &mut f64, left: f64, target: f64, imposed: &Imposed<'_>) -> Result<Option<Way>, Refusal> {
        let now = self.pull_at_rest(0.0, imposed)?;
        let last = self.contact.way;
        let pace = self.path_history.nodes().get(1).map_or(f64::INFINITY, |before| (last / before.time).abs());
        // The balance of an edge that moves is known to a tolerance, and to what joined panels change.
        let mut moving = if now == 0.0 || (last != 0.0 && now.abs() <= BALANCED) { -last } else { now };
        loop {
            let then = self.pull_at_rest(*cap, imposed)?;
            if moving != 0.0 && then * moving <= 0.0 {
                let stops = *cap * pace <= NO_WAY * self.tolerance * self.length || *cap <= self.least_step();
                if !stops {
                    *cap *= 0.5;
                    continue;
                }
                if now.abs() <= BALANCED || then == 0.0 {
                    self.restart_at_turn();
                    moving = 0.0;
                    continue;
                }
            }
            if then == 0.0 {
                return Ok(Some(Way::None));
            }
            let inwards = then > 0.0;
            self.problem.edge_law.goes(inwards)?;
            if moving == 0.0 && !self.is_balanced(inwards, imposed)? && self.leave(*cap, left, target, then, imposed)? {
                return Ok(None);
            }
            return Ok(Some(if inwards { Way::Inwards } else { Way::Outwards }));
        }
    }

    /// A step so short that what is left of a way within it is none.
    fn least_step(&self) -> f64 {
        (AT_ONCE * self.first_step()).max(self.shortest_step())
    }

    /// g of the edge where it is after a time: positive where it recedes, negative where it advances, zero where it rests.
    fn pull_at_rest(&mut self, dt: f64, imposed: &Imposed<'_>) -> Result<f64, Refusal> {
        let a = self.contact.radius();
        let pull = self.edge.trial(&self.contact, &self.path_history, (a, dt), Drive::Time, imposed)?.residual;
        let held = pull < 0.0 && a >= self.contact.profile().rim();
        Ok(if held || pull.abs() <= self.edge_tolerance() { 0.0 } else { pull })
    }

    /// Whether C is the work of adhesion of a way already.
    fn is_balanced(&mut self, inwards: bool, imposed: &Imposed<'_>) -> Result<bool, Refusal> {
        let Some(adhesion) = self.problem.adhesion else { return Ok(true) };
        let motion = self.edge.trial(&self.contact, &self.path_history, (self.contact.radius(), 0.0), Drive::Time, imposed)?.motion;
        let work = self.edge.work(&self.contact, &motion)? / adhesion.work_of_adhesion;
        let [trailing, leading] = self.problem.edge_law.levels(0.0);
        Ok((work / if inwards { trailing } else { leading } - 1.0).abs() <= BALANCED)
    }

    /// Goes to the instant at which an edge at rest leaves within a step at whose end it pulls as `then`, unless that is now.
    fn leave(&mut self, cap: f64, left: f64, target: f64, then: f64, imposed: &Imposed<'_>) -> Result<bool, Refusal> {
        let [low, _] = halved_if([0.0, cap], |dt| Ok(self.pull_at_rest(dt, imposed)? * then <= 0.0))?;
        if low <= (AT_ONCE * cap).max(CLOCK * f64::EPSILON * self.time) {
            return Ok(false);
        }
        let trial = self.edge.trial(&self.contact, &self.path_history, (self.contact.radius(), low), Drive::Time, imposed)?;
        self.go(&trial.motion, trial.penetration);
        self.went(low, left, target, 0.0);
        self.restart();
        Ok(true)
    }
}
