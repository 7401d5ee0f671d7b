//! What one motion does to a point of the line: bonded throughout, free throughout, or passed by the edge.

use super::motion::Motion;
use super::profile::Profile;
use super::springs::{Following, Springs};

/// The motion, ready to be applied to many points.
pub(super) struct NodeUpdate<'a> {
    springs: &'a Springs,
    profile: &'a Profile,
    motion: &'a Motion,
    whole: Following,
    part: Following,
    kept: Vec<f64>,
    part_kept: Vec<f64>,
    scratch: Vec<f64>,
}

impl<'a> NodeUpdate<'a> {
    pub(super) fn new(springs: &'a Springs, profile: &'a Profile, motion: &'a Motion) -> Self {
        let (mut whole, mut kept) = (Following::default(), Vec::new());
        springs.following(motion.time, &motion.powers, &mut whole);
        springs.kept(motion.time, &mut kept);
        let scratch = vec![0.0; springs.terms()];
        Self { springs, profile, motion, whole, part: Following::default(), kept, part_kept: Vec::new(), scratch }
    }

    /// v_i after the motion at a point with f that stays bonded.
    pub(super) fn bonded(&self, state: &mut [f64], height: f64) {
        self.whole.advance(state, self.motion.penetration - height);
    }

    /// Q after the motion at a point with f and v_i that stays bonded.
    pub(super) fn bonded_load(&self, state: &[f64], height: f64) -> f64 {
        self.springs.load(self.motion.end_penetration() - height, self.whole.advanced(state, self.motion.penetration - height))
    }

    /// W after the motion at a point with e_j that stays free.
    pub(super) fn free_displacement(&self, state: &[f64]) -> f64 {
        state.iter().zip(&self.kept).map(|(strain, kept)| strain * kept).sum()
    }

    /// v_i after the motion, for the aggregate of many bonded points with W₀ added up; `count` multiplies what W follows.
    pub(super) fn bonded_sum(&self, state: &mut [f64], displacement: f64, count: f64) {
        for ((dashpot, relaxed), followed) in state.iter_mut().zip(&self.whole.relaxed).zip(&self.whole.followed) {
            *dashpot += (displacement - *dashpot) * relaxed + count * followed;
        }
    }

    /// e_j after the motion at a point that stays free.
    pub(super) fn free(&self, state: &mut [f64]) {
        for (strain, kept) in state.iter_mut().zip(&self.kept) {
            *strain *= kept;
        }
    }

    /// A point at s that the edge passes: from v_i to e_j (`was_bonded`), or back.
    pub(super) fn passed(&mut self, state: &mut [f64], s: f64, height: f64, was_bonded: bool) {
        let motion = self.motion;
        let part = motion.part_of_time(self.profile, s);
        let start = motion.penetration - height;
        if was_bonded {
            self.springs.following(part * motion.time, &motion.first_powers(part), &mut self.part);
            self.part.advance(state, start);
            self.scratch.copy_from_slice(state);
            self.springs.voigt(&self.scratch, state);
            self.springs.kept((1.0 - part) * motion.time, &mut self.part_kept);
            decay(state, &self.part_kept);
        } else {
            self.springs.kept(part * motion.time, &mut self.part_kept);
            decay(state, &self.part_kept);
            self.scratch.copy_from_slice(state);
            self.springs.maxwell(&self.scratch, state);
            let (risen, powers) = motion.last_powers(part);
            self.springs.following((1.0 - part) * motion.time, &powers, &mut self.part);
            self.part.advance(state, start + risen);
        }
    }
}

fn decay(state: &mut [f64], kept: &[f64]) {
    for (strain, kept) in state.iter_mut().zip(kept) {
        *strain *= kept;
    }
}
