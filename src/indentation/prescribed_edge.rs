//! Steps of an edge that goes a prescribed way: the penetration from the edge condition.

use super::advance::{MOST_ATTEMPTS, SLOWEST};
use super::elastic_zone::tension_root;
use super::integrator::Integrator;
use super::motion::{Motion, Passage};
use crate::refusal::Refusal;

impl Integrator<'_> {
    /// A step of a prescribed edge.
    pub(super) fn prescribed_step(&mut self, value: &dyn Fn(f64) -> f64, cap: f64, left: f64, target: f64) -> Result<(), Refusal> {
        let mut cap = cap;
        for _ in 0..MOST_ATTEMPTS {
            let way = (value(cap) - self.contact.radius()).abs();
            if way > self.largest_reach() {
                cap *= (0.99 * self.largest_reach() / way).max(0.1);
                continue;
            }
            let (motion, residual, error) = self.prescribed_motion(value(cap), cap, 5)?;
            let error = error / self.opening;
            let ideal = if error > 0.0 { 0.9 * (self.tolerance / error).powf(0.25) } else { self.fastest() };
            let factor = ideal.clamp(SLOWEST, self.fastest());
            if error > self.tolerance && factor < 0.9 && cap > self.shortest_step() {
                cap *= factor;
                continue;
            }
            self.go(&motion, motion.end_penetration());
            self.went(cap, left, target, residual);
            if cap < left || factor < 1.0 {
                self.dt = cap * factor;
            }
            return Ok(());
        }
        Err(Refusal::NotConverged { what: "a step of the prescribed edge", detail: format!("at t = {:e}", self.time) })
    }

    /// A given edge after dt: the penetration from the edge condition.
    pub(super) fn prescribed(&mut self, radius: f64, dt: f64, degree: u32) -> Result<(), Refusal> {
        let (motion, _, _) = self.prescribed_motion(radius, dt, degree)?;
        self.go(&motion, motion.end_penetration());
        Ok(())
    }

    fn prescribed_motion(&mut self, radius: f64, dt: f64, degree: u32) -> Result<(Motion, f64, f64), Refusal> {
        let here = self.contact.penetration();
        let now = self.path_history.nodes().first().copied();
        let powers = |rise: f64| match now {
            Some(_) if dt > 0.0 => self.path_history.powers(rise, degree, |node| (node.time / dt, node.penetration - here)),
            _ => ([rise, 0.0, 0.0, 0.0, 0.0], 0.0),
        };
        let motion = |rise: f64| {
            let (powers, error) = powers(rise);
            (Motion::new(self.contact.profile(), (self.contact.radius(), radius), dt, Passage::Radius, here, powers), error)
        };
        let unit = self.opening;
        // C is a quadratic in the rise; sampled again about its root it keeps its digits.
        let mut about = self.contact.profile().line(radius) - here;
        let mut scale = -unit;
        for _ in 0..2 {
            let mut sample = |x: f64| self.edge.work(&self.contact, &motion(about + scale * x).0);
            let samples = [sample(0.0)?, sample(1.0)?, sample(2.0)?];
            about += scale * tension_root(samples, self.edge.adhesion.work_of_adhesion)?;
            about += 0.5 * unit;
            scale = -0.5 * unit;
        }
        let rise = about - 0.5 * unit;
        let (motion, error) = motion(rise);
        let residual = self.edge.residual(&self.contact, &motion, false)?;
        Ok((motion, residual, error))
    }
}
