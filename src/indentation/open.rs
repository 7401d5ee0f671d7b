//! An indenter that is off the surface, and when it touches.

use super::history::Controlled;
use super::integrator::Integrator;
use super::line::Sweep;
use super::motion::{Motion, Passage};
use super::springs::DEGREE;
use crate::continuation::bracket::halved;
use crate::refusal::Refusal;

impl Integrator<'_> {
    /// W on the axis of an open contact, which the indenter touches first.
    fn surface(&self) -> f64 {
        self.contact.free_displacement(1.0).first().map_or(0.0, |panel| panel.at(0.0))
    }

    /// Whether an open contact stays open under the imposed value.
    pub(super) fn is_open(&self, controlled: Controlled, value: f64) -> bool {
        match controlled {
            // Without a force the frame's end is where the indenter is.
            Controlled::Penetration | Controlled::Frame => value < self.surface(),
            // An indenter pushed by a force stays where it lost contact, until it is pushed again.
            Controlled::Force | Controlled::ContactRadius => value <= 0.0,
        }
    }

    /// The time for which the indenter stays off a surface that creeps back: at most `cap`.
    pub(super) fn until_touch(&self, controlled: Controlled, cap: f64, value: &dyn Fn(f64) -> f64) -> f64 {
        if !self.is_open(controlled, value(0.0)) {
            return 0.0;
        }
        let overlap = |dt: f64| match controlled {
            Controlled::Force | Controlled::ContactRadius => value(dt),
            Controlled::Penetration | Controlled::Frame => match self.contact.moved(0.0, value(dt), dt, Sweep::Linear) {
                Ok(later) => value(dt) - later.free_displacement(1.0).first().map_or(0.0, |panel| panel.at(0.0)),
                Err(_) => -1.0,
            },
        };
        if overlap(cap) <= 0.0 {
            return cap;
        }
        halved([0.0, cap], |dt| overlap(dt) <= 0.0)[1]
    }

    pub(super) fn open(&mut self, controlled: Controlled, dt: f64, value: f64) -> Result<(), Refusal> {
        let depth = match controlled {
            Controlled::Penetration | Controlled::Frame => value,
            Controlled::Force | Controlled::ContactRadius => self.contact.penetration(),
        };
        self.glide(0.0, depth, dt);
        Ok(())
    }

    /// A straight motion, its energies accounted for.
    pub(super) fn glide(&mut self, radius: f64, penetration: f64, dt: f64) {
        let mut powers = [0.0; DEGREE];
        powers[0] = penetration - self.contact.penetration();
        let motion =
            Motion::new(self.contact.profile(), (self.contact.radius(), radius), dt, Passage::Radius, self.contact.penetration(), powers);
        self.go(&motion, penetration);
    }
}
