//! Growth: from one line to the next, from one time to the next, or an arrest.

use super::super::memory::{SAME_PLACE, Step};
use super::bracket::{bracketed, bracketed_to, near};
use super::record::{Between, RawKind};
use super::{Ahead, Stepper};

/// Where a place of slow arrest leaves the zone, the speed before goes like the root of what is left of the way, which no step follows: terms that answer within the
/// step see the change of speed too late. Measured: the worst of 4200 random histories was off by 3e-4 of that change.
const SLOW_KINK_PART: f64 = 2e-3;

/// Halvings of a step in search of an arrest: more are below the clock.
const MOST_HALVINGS: u32 = 60;

/// The time of an arrest within its step is solved for to this part: the place is known to its square.
const ARREST: f64 = 1e-12;

/// A step on the way to an end that lies between this step and the next: half of what is left. From a line that all runs have in common the last step to an end within
/// their lines would be the same in all of them, and what it errs by would not be seen.
fn before_the_end(step: f64, left: f64) -> f64 {
    if left > step && left < 2.0 * step { 0.5 * left } else { left }
}

impl Stepper {
    /// Whether a place of rest is within the zone of a load.
    pub(super) fn in_zone(&self, rest: f64, load: f64) -> bool {
        rest + self.zone.at(load) > self.memory.place + SAME_PLACE
    }

    /// The first place of rest that leaves the zone as the tip goes on.
    pub(super) fn rest_leaving(&self, load: f64) -> f64 {
        self.rests.iter().copied().filter(|rest| self.in_zone(*rest, load)).fold(f64::INFINITY, f64::min)
    }

    /// One step of growth, or an arrest, or the rest of the segment in uniform motion.
    pub(super) fn grow(&mut self, ahead: &mut Ahead, breaks: bool) {
        let zone = ahead.zone.at(ahead.load);
        ahead.speed = self.speed;
        let calm = !self.rests.iter().any(|rest| self.in_zone(*rest, ahead.load));
        if self.uniform.1 > self.lines_per_zone + 2 && calm && ahead.slope == 0.0 {
            // Steps agree to their own rounding, which is that of many lines: the steady motion is known better.
            let stepped = self.uniform.0 * f64::from(self.lines_per_zone);
            let steady = self.quasi_steady.motion(ahead.load, 0.0).map_or(stepped, |motion| motion.crossing_time);
            self.count_quasi_steady();
            let crossing = if (steady / stepped - 1.0).abs() < 1e-9 { steady } else { stepped };
            let left = ahead.left().min(self.until - self.time());
            if left > 4.0 * crossing {
                self.memory.replace(&[[zone, crossing, ahead.load], [0.0, 0.0, ahead.load]], 0.0);
                let advance = zone * (left / crossing);
                ahead.speed = zone / crossing;
                self.accept(ahead, left, advance, [zone / crossing; 2], Between::Read);
                self.memory.replace(&[[zone, crossing, ahead.load], [0.0, 0.0, ahead.load]], 0.0);
                return;
            }
        }
        if calm
            && ahead.slope != 0.0
            && self.undisturbed >= 2 * self.lines_per_zone
            && self.undisturbed.is_multiple_of(self.lines_per_zone)
            && self.glide(ahead, breaks)
        {
            return;
        }
        let line = self.grid.next_line() - self.memory.place;
        // The nearest place of rest at the far end of the zone: where it leaves, the speed jumps.
        let rest = self.rest_leaving(ahead.load);
        let place = self.memory.place;
        let nearest = line.min(self.longest_advance).min(before_the_end(line, rest + zone - place));
        let probe = *ahead;
        let whole_at = |duration: f64| nearest.min((rest + probe.zone.at(probe.load_after(duration)) - place).max(0.0));
        let longest = before_the_end(line / self.speed, ahead.left()).min(ahead.longest_step);
        let mut duration = longest.min(2.0 * whole_at(0.0) / self.speed);
        // Whether the closure is met at the grid line within the time, or short of it, or not even where the tip is.
        if let Some(time) = self.time_to(&probe, &whole_at, duration)
            && self.still_moves(&probe.step(time, whole_at(time)), &probe)
        {
            self.advance(ahead, time, whole_at(time));
            return;
        }
        for _ in 0..MOST_HALVINGS {
            if self.excess(&probe.step(duration, whole_at(duration))) >= 0.0 {
                let guess = whole_at(0.0) / self.speed;
                let time = bracketed(duration, guess, |time, this: &mut Self| this.excess(&probe.step(time, whole_at(time))), self);
                let whole = whole_at(time);
                if self.still_moves(&probe.step(time, whole), &probe) {
                    self.advance(ahead, time, whole);
                    return;
                }
                duration = time;
            } else {
                let still = probe.step(duration, 0.0);
                let sums = self.sums(&still);
                let excess = still.loads[1] * (still.loads[1] + sums.memory) - 1.0;
                if excess > 0.0 {
                    let place = self.place_at(&probe, duration, whole_at(duration));
                    if self.still_moves(&probe.step(duration, place), &probe) {
                        self.advance(ahead, duration, place);
                        return;
                    }
                } else if self.speed_of(&sums, &still, probe.slope) > 0.0 {
                    if excess >= -self.rounding(&sums, still.loads[1], still.zone) {
                        break;
                    }
                    // The tip stops and would start again within the step: the stop comes first.
                    duration *= 0.5;
                    continue;
                }
            }
            // The tip has stopped on the way, where the speed that the closure wants is zero.
            let last = bracketed_to(
                ARREST,
                duration,
                0.5 * duration,
                |time, this: &mut Self| {
                    let place = this.place_at(&probe, time, whole_at(time));
                    -this.wanted_speed(&probe.step(time, place), &probe)
                },
                self,
            );
            if self.first_step && last < 0.5 * ahead.longest_step {
                // The whole growth would be one step of the same length in every run.
                self.first_step = false;
                ahead.longest_step = 2.0 * last / f64::from(self.lines_per_zone);
                return;
            }
            let place = self.place_at(&probe, last, whole_at(last));
            self.sure = duration - last;
            self.advance(ahead, last, place);
            if self.moving {
                self.arrest(0.0);
            }
            self.slow_rests.push(self.memory.place);
            return;
        }
        // The closure gains less than its rounding: the speed, a sum without differences, is what is known of the way.
        let place = (self.speed * duration).min(whole_at(duration));
        self.advance(ahead, (place / self.speed).min(duration), place);
    }

    /// The time at which the closure is met at the grid line, if it is near that of the present speed.
    fn time_to(&mut self, ahead: &Ahead, whole_at: &dyn Fn(f64) -> f64, longest: f64) -> Option<f64> {
        let speed = self.speed;
        let with_slope = |time: f64, this: &mut Self| {
            let step = ahead.step(time, whole_at(time));
            let sums = this.sums(&step);
            [step.loads[1] * (step.loads[1] + sums.memory) - 1.0, step.loads[1] * sums.exposure / step.zone * speed]
        };
        let guess = whole_at(0.0) / speed;
        if guess > 0.0 && guess < longest { near(longest, guess, with_slope, self) } else { None }
    }

    /// Where the closure is met at the end of a step that ends short of `whole`; where the tip is, if it would have to go back.
    fn place_at(&mut self, ahead: &Ahead, duration: f64, whole: f64) -> f64 {
        if self.excess(&ahead.step(duration, 0.0)) <= 0.0 {
            return 0.0;
        }
        let guess = (self.speed * duration).min(0.5 * whole);
        let with_slope = |place: f64, this: &mut Self| {
            let step = ahead.step(duration, place);
            let sums = this.sums(&step);
            [step.loads[1] * (step.loads[1] + sums.memory) - 1.0, -step.loads[1] * sums.exposure / step.zone]
        };
        if let Some(place) = near(whole, guess, with_slope, self) {
            return place;
        }
        bracketed(whole, guess, |place, this: &mut Self| -this.excess(&ahead.step(duration, place)), self)
    }

    /// The speed at the end of a step with which the closure goes on to hold; negative where it asks the tip to go back.
    fn wanted_speed(&mut self, step: &Step, ahead: &Ahead) -> f64 {
        let sums = self.sums(step);
        self.speed_of(&sums, step, ahead.slope)
    }

    fn still_moves(&mut self, step: &Step, ahead: &Ahead) -> bool {
        self.wanted_speed(step, ahead) > 0.0
    }

    fn advance(&mut self, ahead: &mut Ahead, duration: f64, advance: f64) {
        let step = ahead.step(duration, advance);
        let sums = self.sums(&step);
        let load = step.loads[1];
        let by_last_slope = self.memory.rate_by_last_slope(&step);
        self.run.residual = self.run.residual.max((load * (load + sums.memory) - 1.0).abs());
        let before = self.speed_of(&sums, &step, ahead.slope);
        let on_line = self.grid.reach(self.memory.place + advance);
        if on_line {
            if self.grid.is_even() {
                self.undisturbed = self.undisturbed.saturating_add(1);
            }
            // The way before was that of quasi-steady growth, until it is two zones behind.
            if self.undisturbed > 2 * self.lines_per_zone {
                self.uncertainties[1] = 0.0;
            }
        }
        let between = if std::mem::take(&mut self.first_step) { Between::Read } else { Between::Solved };
        let within: Vec<f64> = self.rests.iter().copied().filter(|rest| self.in_zone(*rest, ahead.load)).collect();
        let at_start = self.speed;
        self.accept(ahead, duration, advance, [self.speed, before], between);
        self.speed = before;
        if advance > 0.0 {
            self.unseen = by_last_slope * (before - (advance - step.bend) / duration);
        }
        if within.iter().any(|rest| !self.in_zone(*rest, ahead.load)) {
            // The lines of the zone behind leave as the tip goes on: none of those ahead is wider.
            let layer = self.grid.layer();
            self.restart_grid(ahead);
            self.grid.refine(layer);
            let slowly = self.slow_rests.iter().any(|rest| within.contains(rest) && !self.in_zone(*rest, ahead.load));
            self.event(RawKind::Kinks, [before, self.speed], 0.0);
            if let Some(event) = self.run.events.last_mut().filter(|_| slowly) {
                // The place is known to SAME_PLACE: what the speed gains there goes with the root.
                let beyond = (SAME_PLACE / advance.max(SAME_PLACE)).sqrt();
                event.speed_uncertainty = SLOW_KINK_PART.max(beyond) * (before - at_start).abs();
            }
            self.uniform = (0.0, 0);
        }
        // The greatest zone is 1.
        let behind = self.memory.place - 1.0 + SAME_PLACE;
        self.rests.retain(|rest| *rest > behind);
        self.slow_rests.retain(|rest| *rest > behind);
        if on_line && ahead.zone_changes() {
            self.grid.rescale(self.memory.place, step.zone);
        }
        // Rounding of one step: of the closure, over what the closure gains in it.
        let noise = 1e-13 + 64.0 * f64::EPSILON * f64::from(self.lines_per_zone) / (ahead.load * sums.exposure);
        if on_line && (duration - self.uniform.0).abs() <= noise * duration {
            self.uniform.1 += 1;
        } else {
            self.uniform = (duration, 0);
        }
        if self.speed <= 0.0 {
            self.arrest(before.max(0.0));
        }
        if self.memory.place > 4.0 {
            self.rebase();
        }
    }
}
