//! Cycles of an oscillation: those that repeat, and the times at which points are wanted.

use super::course::Course;
use super::line::Line;
use crate::indentation::current_segment::CurrentSegment;

/// Points of a cycle.
const OF_CYCLE: u32 = 8;
/// Change of all cycles that are left, over the accuracy and the depth, at which they are one.
const REPEATED: f64 = 1e-5;
/// Change of a cycle over the depth that is rounding.
const NO_CHANGE: f64 = 4e-15;

impl<'a> Course<'a> {
    /// Cycles that are left out because each is the last one again: none where that is not sure to what was asked for.
    pub(super) fn repeated(&mut self, current: &CurrentSegment, at_start: &mut Option<Line<'a>>, next: u64, by: f64) -> u64 {
        let Some(oscillation) = current.segment.oscillation else { return 0 };
        let steady = oscillation.frequency.to_bits() == oscillation.end_frequency.to_bits()
            && current.segment.end.to_bits() == current.from.to_bits()
            && !oscillation.until_stationary;
        if !steady || self.until.is_finite() || next < 3 {
            return 0;
        }
        let last = (by * oscillation.frequency * (1.0 + 1e-12)).floor() as u64;
        let left = (last + 1).saturating_sub(next);
        let before = at_start.replace(self.line.clone());
        let Some(before) = before.filter(|_| left > 1) else { return 0 };
        // Nothing that follows makes a difference larger: so many cycles change by at most so many times as much as this one did, and no more of them
        // than memory lasts.
        let last_change = self.line.distance(&before);
        let remembered = 2.0 * (1.0 + oscillation.frequency * self.chain.memory());
        let change = last_change * remembered.min(left as f64);
        let allowed = REPEATED * self.problem.accuracy * self.line.depth;
        if change > allowed && last_change > NO_CHANGE * self.line.depth {
            return 0;
        }
        self.line.everywhere += change;
        let Some(cycle_integrals) = &mut self.cycle_integrals else { return 0 };
        for _ in 0..left {
            self.record.cycle_again(cycle_integrals);
        }
        self.time = current.end_of_cycle(next + left - 1).unwrap_or(by).min(by);
        self.point(false);
        left
    }

    /// Times up to a target at which points of the path are wanted, the target last.
    pub(super) fn between(&self, current: &CurrentSegment, target: f64) -> Vec<f64> {
        let mut times = Vec::new();
        if let Some(oscillation) = current.segment.oscillation {
            let duration = current.segment.duration;
            let of_cycle = f64::from(OF_CYCLE);
            let mut k = (oscillation.cycles_at(self.time, duration) * of_cycle * (1.0 + 1e-12)).floor();
            loop {
                k += 1.0;
                match oscillation.time_of(k / of_cycle, duration) {
                    Some(time) if time < target * (1.0 - 1e-12) => {
                        if time > self.time {
                            times.push(time);
                        }
                    }
                    _ => break,
                }
            }
        }
        times.retain(|time| *time < target * (1.0 - 1e-13));
        times.push(target);
        times
    }
}
