//! Glide: growth over very many zones under a slow load, by its quasi-steady speed.

use super::super::memory::Step;
use super::super::quasi_steady::Steadiness;
use super::grid::Grid;
use super::record::Between;
use super::{Ahead, Stepper};

impl Stepper {
    /// Follows slow growth by its quasi-steady speed, as far as that is good; false if it is not good enough here.
    pub(super) fn glide(&mut self, ahead: &mut Ahead, breaks: bool) -> bool {
        let tolerance = Steadiness::tolerance(self.lines_per_zone);
        let end = ahead.left().min(self.until - self.time()) - if breaks { 1e-9 * ahead.whole } else { 0.0 };
        let (mut moved, mut left) = (0.0, end);
        let Some(mut now) = self.quasi_steady.motion(ahead.load, ahead.slope).filter(|motion| {
            let allowed = tolerance + Steadiness::noise(ahead.load);
            motion.correction * motion.correction <= tolerance && (self.speed / motion.speed - 1.0).abs() <= allowed
        }) else {
            self.count_quasi_steady();
            return false;
        };
        let mut panel = 8.0 * now.crossing_time;
        while left > 0.0 {
            let duration = if panel > 0.99 * left { left } else { panel };
            let at = |part: f64, this: &mut Self| this.quasi_steady.motion(ahead.load_after(part * duration), ahead.slope);
            let nodes = [at(0.25, self), at(0.5, self), at(0.75, self), at(1.0, self)];
            let [Some(one), Some(two), Some(three), Some(four)] = nodes else {
                panel = 0.5 * duration;
                if panel < 4.0 * now.crossing_time { break } else { continue }
            };
            // Boole's rule; the place half-way must be that of the cubic which the outputs are read from.
            let advance = duration / 90.0 * (7.0 * (now.speed + four.speed) + 32.0 * (one.speed + three.speed) + 12.0 * two.speed);
            let half = duration / 12.0 * (now.speed + 4.0 * one.speed + two.speed);
            let cubic = 0.5 * advance + duration / 8.0 * (now.speed - four.speed);
            let rough = (half - cubic).abs() > (Steadiness::PANEL + Steadiness::noise(ahead.load_after(duration))) * advance;
            if rough || four.correction * four.correction > tolerance {
                panel = 0.5 * duration;
                if panel < 4.0 * now.crossing_time { break } else { continue }
            }
            let uncertainty = now.uncertainty().max(four.uncertainty());
            self.uncertainties[0] += uncertainty * advance;
            self.uncertainties[1] = uncertainty * now.speed.max(four.speed);
            self.write_outputs(ahead, duration, advance, [now.speed, four.speed], Between::Read);
            self.memory.wait(duration);
            self.memory.place += advance;
            ahead.pass(duration);
            self.run.work.steps += 1;
            left = if duration >= left { 0.0 } else { left - duration };
            moved += advance;
            now = four;
            panel = 1.5 * duration;
            if self.memory.place > 4.0 {
                self.rebase();
            }
        }
        self.count_quasi_steady();
        self.undisturbed = 0;
        if moved == 0.0 {
            return false;
        }
        let zone = ahead.zone.at(ahead.load);
        self.memory.zone = zone;
        // The way is as good as the motion: its duration is set such that the closure holds to rounding, and the next step starts from there.
        let mut factor = 1.0;
        for _ in 0..4 {
            self.memory.replace(&now.way(ahead.load, ahead.slope, zone, self.lines_per_zone, factor), now.acceleration / (factor * factor));
            let excess = self.excess(&Step::none(ahead.load, zone));
            factor *= 1.0 - excess / now.sensitivity;
            if excess.abs() < 1e-14 {
                break;
            }
        }
        self.rests.clear();
        self.grid = Grid::even(self.memory.place, zone, self.lines_per_zone);
        self.speed = now.speed;
        true
    }

    pub(super) fn count_quasi_steady(&mut self) {
        let evaluations = std::mem::take(&mut self.quasi_steady.evaluations);
        self.run.work.closure_evaluations += evaluations;
        self.run.work.kernel_evaluations += evaluations * self.memory.terms.len() as u64;
    }
}
