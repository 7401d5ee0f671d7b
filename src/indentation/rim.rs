//! The opening beyond a sharp rim of the indenter.
//!
//! No indenter stands beyond its rim, so what the solid bulges there is no gap: only opening since the rim last released counts in the closure. One chain
//! of the line carries it, with the rim's own history, against a face at f(rim) that presses and does not adhere:
//! ```text
//! Q_c = E∞*(Δ − f(rim) − Σe_j),   Q = max(Q_c, 0),   D = (Q − Q_c)/E∞*,   τ_j ė_j = J_j Q − e_j
//! ```
//! D is the gap factor everywhere beyond the rim. It starts when Q_c turns negative, and ends when the opening itself is back at zero.

use super::motion::Motion;
use super::springs::{DEGREE, Following, Springs};
use crate::continuation::bracket::halved;
use serde::{Deserialize, Serialize};

/// Parts of a step at which the chain is looked at.
const LOOKS: u32 = 2;
/// Changes within one step; a step follows what is imposed closely enough to hold one or two.
const MOST_CHANGES: u32 = 8;

/// The chain beyond the rim at an instant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Rim {
    /// f(rim).
    height: f64,
    /// v_i while the chain is shut, e_j while it is open.
    state: Vec<f64>,
    open: bool,
}

impl Rim {
    /// On an untouched surface, or after a dwell at Δ so long that the solid has relaxed.
    pub(super) fn new(springs: &Springs, height: f64, penetration: f64, relaxed: bool) -> Self {
        let depth = penetration - height;
        let open = depth <= 0.0;
        let follows = relaxed && !open;
        Self { height, state: vec![if follows { depth } else { 0.0 }; springs.terms()], open }
    }

    pub(super) fn terms(&self) -> usize {
        self.state.len()
    }

    /// D (m) at a penetration.
    pub(super) fn opening(&self, penetration: f64) -> f64 {
        if self.open { (self.state.iter().sum::<f64>() - (penetration - self.height)).max(0.0) } else { 0.0 }
    }

    /// The chain after a motion.
    pub(super) fn after(&self, springs: &Springs, motion: &Motion) -> Self {
        let mut next = self.clone();
        let mut done = 0.0;
        for _ in 0..MOST_CHANGES {
            let rest = Rest::new(motion, done, self.height);
            // A chain that has just changed is at zero: its next sign tells, not that.
            let changes = |part: f64| next.advanced(springs, &rest, part).is_wrong(springs, rest.depth(part));
            let Some(beyond) = (1..=LOOKS).map(|look| f64::from(look) / f64::from(LOOKS)).find(|part| changes(*part)) else {
                return next.advanced(springs, &rest, 1.0);
            };
            let part = if motion.time > 0.0 { halved([0.0, beyond], |part| !changes(part))[1] } else { 1.0 };
            next = next.advanced(springs, &rest, part);
            next.change(springs);
            done += (1.0 - done) * part;
        }
        let rest = Rest::new(motion, done, self.height);
        next.advanced(springs, &rest, 1.0)
    }

    /// Whether the face would have to pull at a shut chain, or has been met by an open one.
    fn is_wrong(&self, springs: &Springs, depth: f64) -> bool {
        if self.open { depth > self.state.iter().sum::<f64>() } else { springs.load(depth, self.state.iter().copied()) < 0.0 }
    }

    fn change(&mut self, springs: &Springs) {
        let before = std::mem::replace(&mut self.state, vec![0.0; springs.terms()]);
        if self.open {
            springs.maxwell(&before, &mut self.state)
        } else {
            springs.voigt(&before, &mut self.state)
        }
        self.open = !self.open;
    }

    /// The chain after a part of the rest of a motion, as it is.
    fn advanced(&self, springs: &Springs, rest: &Rest, part: f64) -> Self {
        let mut next = self.clone();
        if self.open {
            for (strain, &(_, tau)) in next.state.iter_mut().zip(&springs.creep) {
                *strain *= (-part * rest.time / tau).exp();
            }
        } else {
            let mut following = Following::default();
            springs.following(part * rest.time, &rest.first_powers(part), &mut following);
            following.advance(&mut next.state, rest.start);
        }
        next
    }
}

/// What is left of a motion: its time, and Δ − f(rim) = start + Σ w_k u^k.
struct Rest {
    time: f64,
    start: f64,
    powers: [f64; DEGREE],
}

impl Rest {
    fn new(motion: &Motion, done: f64, height: f64) -> Self {
        let (risen, powers) = motion.last_powers(done);
        Self { time: (1.0 - done) * motion.time, start: motion.penetration + risen - height, powers }
    }

    fn first_powers(&self, part: f64) -> [f64; DEGREE] {
        let mut scale = 1.0;
        self.powers.map(|power| {
            scale *= part;
            power * scale
        })
    }

    fn depth(&self, part: f64) -> f64 {
        self.start + self.first_powers(part).iter().sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::super::motion::Passage;
    use super::super::profile::Profile;
    use super::*;
    use crate::material::PlaneMaterial;

    const TAU: f64 = 2.0;
    const GLASSY: f64 = 30.0;
    const RELAXED: f64 = 3.0;

    fn glide(from: f64, to: f64, time: f64) -> Motion {
        let profile = Profile::FlatPunch { radius: 1.0 };
        Motion::new(&profile, (1.0, 1.0), time, Passage::Radius, from, [to - from, 0.0, 0.0, 0.0, 0.0])
    }

    /// A relaxed chain pulled up at once, held, pushed back: e decays from J E0 Δ₀ with τ while open, and the opening is back at zero before K is.
    #[test]
    fn the_opening_counts_from_the_last_release() {
        let springs = Springs::new(&PlaneMaterial::standard_solid(RELAXED, GLASSY, TAU).unwrap()).unwrap();
        let depth = 0.4;
        let rim = Rim::new(&springs, 0.0, depth, true);
        assert!(rim.opening(depth) == 0.0);
        let kept = (1.0 - RELAXED / GLASSY) * depth;
        // Unloading to where the face still presses opens nothing; further down the rest is the opening.
        assert!(rim.after(&springs, &glide(depth, kept + 1e-6, 0.0)).opening(kept + 1e-6) == 0.0);
        let up = rim.after(&springs, &glide(depth, -0.1, 0.0));
        assert!((up.opening(-0.1) - (kept + 0.1)).abs() < 1e-14);
        let held = up.after(&springs, &glide(-0.1, -0.1, 0.7));
        let strain = kept * (-0.7 / TAU).exp();
        assert!((held.opening(-0.1) - (strain + 0.1)).abs() < 1e-14);
        // In steps or at once, over the instant at which the face is met: e(t) = Δ(t) there.
        let whole = held.after(&springs, &glide(-0.1, 0.5, 0.6));
        let halves = held.after(&springs, &glide(-0.1, 0.2, 0.3)).after(&springs, &glide(0.2, 0.5, 0.3));
        assert!(whole.opening(0.5) == 0.0 && halves.opening(0.5) == 0.0);
        for (one, other) in whole.state.iter().zip(&halves.state) {
            assert!((one - other).abs() < 1e-13, "{one} {other}");
        }
        // Up again at once: what the dashpot kept, by the same equations in small steps of Euler's.
        let (mut e, steps) = (strain, 400_000);
        for step in 0..steps {
            let face = -0.1 + 0.6 * (f64::from(step) + 0.5) / f64::from(steps);
            let load = (GLASSY * (face - e)).max(0.0);
            e += 0.6 / f64::from(steps) / TAU * ((1.0 / RELAXED - 1.0 / GLASSY) * load - e);
        }
        let opened = whole.after(&springs, &glide(0.5, -1.0, 0.0)).opening(-1.0);
        assert!((opened - (e + 1.0)).abs() < 1e-6, "{opened} {}", e + 1.0);
    }
}
