//! Rest: the tip stops, waits, and starts again.

use super::super::first_crossing::Rest;
use super::record::{Between, RawKind};
use super::{Ahead, RESTART_THRESHOLD, Stepper};

impl Stepper {
    pub(super) fn rest(&mut self, ahead: &mut Ahead) {
        let longest = ahead.left().min(self.until - self.time());
        // Just after a slow arrest the work falls with the square of the time, and the bound in a zone that shrinks, of first order, would take it apart endlessly.
        let sure = std::mem::take(&mut self.sure);
        if ahead.zone_changes()
            && sure > 0.0
            && sure < longest
            && [0.25, 0.5, 1.0].iter().all(|part| self.excess(&ahead.step(part * sure, 0.0)) <= self.threshold)
        {
            self.accept(ahead, sure, 0.0, [0.0; 2], Between::Read);
            return;
        }
        let memories = |load: f64| self.memory.memories_in(ahead.zone.at(load));
        let rest = Rest {
            terms: &self.memory.terms,
            memories: &memories,
            follows: ahead.zone_changes(),
            loads: [ahead.load, ahead.load_after(longest)],
            duration: longest,
            threshold: self.threshold,
        };
        let (crossing, count) = rest.first_crossing();
        self.run.work.closure_evaluations += u64::from(count);
        self.run.work.kernel_evaluations += u64::from(count) * self.memory.terms.len() as u64;
        let duration = crossing.unwrap_or(longest);
        self.accept(ahead, duration, 0.0, [0.0; 2], Between::Read);
        if crossing.is_none() {
            return;
        }
        if self.ever_moved && duration <= 1e-13 * longest {
            // No time has passed since an arrest: rounding. Ask for more.
            self.threshold *= 10.0;
        }
        self.restart_grid(ahead);
        if self.speed > 0.0 {
            let kind = if self.ever_moved { RawKind::Restarts } else { RawKind::Begins };
            self.event(kind, [0.0, self.speed], 0.0);
            self.rests.push(self.memory.place);
            // What is left of the segment takes as many steps as a whole one.
            ahead.longest_step = 2.0 * ahead.left() / f64::from(self.lines_per_zone);
            self.moving = true;
            self.ever_moved = true;
            self.uniform = (0.0, 0);
        } else {
            self.threshold = (self.threshold * 10.0).max(RESTART_THRESHOLD);
        }
    }

    pub(super) fn arrest(&mut self, before: f64) {
        self.event(RawKind::Arrests, [before, 0.0], 0.0);
        self.moving = false;
        self.speed = 0.0;
        self.threshold = self.threshold.max(RESTART_THRESHOLD);
    }
}
