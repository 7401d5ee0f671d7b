//! One run at one step size: rest, growth, arrest, restart, jump, kink.
//!
//! # What it does
//! The trajectory is a chain of pieces, each the parabola in time that starts with the speed at its start and whose end satisfies the closure to
//! rounding; each piece's memory is integrated exactly. While the tip runs it is carried from one line of a grid of m lines per process zone to the next, and the
//! unknown is the time (t(x) is smooth where x(t) starts with a jump of speed; and the back of the window then lies on the grid as well). The grid starts where growth
//! or a new segment of load starts, graded from the shortest time (`grid`), so the kink one process zone later is a line. Where the load is slow in coming, or the tip
//! slows down, the time step is bounded (m/2 steps in a segment of load) and the unknown is the place.
//!
//! # How good
//! Third order in 1/m with a coefficient that does not depend on m: all that happens is a node of every run, and no run takes a start, an arrest or a kink in one
//! step where another takes more (`first_step`, `longest_advance`). Exact for uniform motion. An arrest under a falling load is where the speed that the closure wants is
//! zero, solved for within its step; a step over it would let the tip stop late, in all runs alike. When
//! all steps of a window agree to rounding under a constant load, the motion is uniform from then on: the rest of the segment is one piece.

//!
//! # What happens, and what is only rounding
//! No event is inferred from a residual or from an equality of numbers. A line counts as reached from a thousandth of its distance on (`grid`); the tip stops where the
//! speed is not above zero, by the held memory too, which decides at rest (else an arrest would be undone at once); only a load that jumps moves the tip at once; a
//! step in which the closure gains less than its rounding goes by the speed.

mod bracket;
mod glide;
mod grid;
mod growth;
mod record;
mod rest;

use super::load::LoadHistory;
use super::memory::{Clock, Memory, Step, Sums, terms_of};
use super::problem::GrowthProblem;
use super::quasi_steady::QuasiSteady;
use super::zone::RelativeZone;
use crate::refusal::Refusal;
use bracket::bracketed;
use grid::Grid;
use record::Between;
pub use record::GrowthWork;
pub(crate) use record::{RawEvent, RawKind, RawSample, Run};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A start of growth right after an arrest must exceed the work of adhesion by this part, or rounding would start it.
const RESTART_THRESHOLD: f64 = 1e-13;

/// Zones per second from which on a speed counts as this: a start within an ulp of the glassy limit has no memory to divide by.
const FASTEST: f64 = 1e150;

/// Where more of the exposure than this is of terms that answer within the step, dividing by the rest would cost its digits.
const MOST_IMPLICIT: f64 = 0.999;

/// Loads that differ by less than this part are one load, rounded in two ways.
const SAME_LOAD: f64 = 4.0 * f64::EPSILON;

/// So near the glassy limit a load has no digits left for the speed: a ramp that passes the limit ends here.
const NEAREST: f64 = 1e-8;

/// Steps between two looks at whether a run is to be kept.
const BETWEEN_LOOKS: u64 = 64;

/// A run under way: all that its next step reads.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Stepper {
    memory: Memory,
    lines_per_zone: u32,
    /// Times with an output; a kept run does not hold them.
    #[serde(skip)]
    outputs: Arc<[f64]>,
    most_steps: u64,
    until: f64,
    /// Time and place of the memory's own zero.
    base: [f64; 2],
    grid: Grid,
    /// The shortest retardation time (s).
    shortest_time: f64,
    /// Places of rests that are, or may come, within the zone.
    rests: Vec<f64>,
    /// Those of them where a falling load let the tip stop bit by bit.
    slow_rests: Vec<f64>,
    zone: RelativeZone,
    quasi_steady: QuasiSteady,
    /// Lines passed since the motion was last disturbed.
    undisturbed: u32,
    /// What is not known of place and speed after quasi-steady growth.
    uncertainties: [f64; 2],
    moving: bool,
    /// No step of growth has been taken since it began, or since the load changed its slope.
    first_step: bool,
    /// The longest advance of a step: a place of rest near the end of the zone is reached by as many steps as lie in half a zone.
    longest_advance: f64,
    /// What z ΣN_j lacks after the last step because its way ended with the slope of its parabola and not with the speed.
    unseen: f64,
    ever_moved: bool,
    speed: f64,
    threshold: f64,
    /// How long after an arrest the closure is known to ask the tip to go back (s).
    sure: f64,
    /// The step all steps of late agree with, and how many do.
    uniform: (f64, u32),
    /// Steps taken when the memory's zero was last moved.
    rebased_at: u64,
    run: Run,
    /// Which segment of the load is passed, and what of it lies ahead.
    segment: usize,
    ahead: Option<Ahead>,
    /// Steps taken at the last look.
    looked_at: u64,
}

/// The load over the rest of a segment.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Ahead {
    /// The load now, at the start of the segment and at its end.
    load: f64,
    first: f64,
    last: f64,
    slope: f64,
    /// How long the segment takes, and how much of that has passed (s).
    whole: f64,
    passed: Clock,
    /// When the segment ends, by the clock of the history.
    end: f64,
    longest_step: f64,
    /// The speed of the tip now.
    speed: f64,
    zone: RelativeZone,
}

impl Ahead {
    /// What is left of the segment (s).
    fn left(&self) -> f64 {
        self.whole - self.passed.time()
    }

    fn load_after(&self, duration: f64) -> f64 {
        if duration >= self.left() { self.last } else { self.first + self.slope * (self.passed.time() + duration) }
    }

    fn step(&self, duration: f64, advance: f64) -> Step {
        let load = self.load_after(duration);
        let bend = (self.speed * duration - advance).clamp(-advance, advance);
        Step { duration, advance, bend, loads: [self.load, load], zone: self.zone.at(load) }
    }

    /// Whether the zone changes in this segment.
    fn zone_changes(&self) -> bool {
        self.zone.follows() && self.slope != 0.0
    }

    fn pass(&mut self, duration: f64) {
        self.load = self.load_after(duration);
        if duration >= self.left() {
            // Infinite for a segment that is: nothing passes it.
            self.whole = self.passed.time();
        } else {
            self.passed.pass(duration);
        }
    }
}

/// The speed of a tip: the better one of two while that is above zero, then the one that the held memory gives. A tip that stopped by the better one alone would start
/// again at once, as at rest the held memory decides: an arrest that comes and goes with the length of the steps.
fn unless_stopped(better: f64, held: f64) -> f64 {
    let speed = if better > 0.0 && better.is_finite() { better } else { held };
    if speed.is_nan() { 0.0 } else { speed.min(FASTEST) }
}

/// What a run is asked.
#[derive(Clone, Copy)]
pub(crate) struct Asked<'a> {
    /// Times with an output, not decreasing, none after `until`.
    pub(crate) outputs: &'a [f64],
    pub(crate) until: f64,
    pub(crate) lines_per_zone: u32,
    pub(crate) most_steps: u64,
}

/// Runs a history up to a time, from where the same run was left off if it was; `look` sees it between steps.
pub(crate) fn run(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    asked: Asked<'_>,
    left_off: Option<Stepper>,
    look: &dyn Fn(&Stepper),
) -> Result<Run, Refusal> {
    let limit = problem.glassy_limit();
    let zone = RelativeZone::new(problem, history.peak(), limit);
    let until = asked.until;
    let mut stepper = left_off.unwrap_or_else(|| Stepper::new(problem, zone, asked));
    stepper.outputs = asked.outputs.into();
    for (index, segment) in history.segments().iter().enumerate().skip(stepper.segment) {
        // A load that jumps at the very end is not seen any more, in no run.
        if segment.start > until || (segment.start > 0.0 && until - segment.start <= 4.0 * f64::EPSILON * until) {
            break;
        }
        let mut duration = segment.duration;
        let [first, mut last] = [segment.from / limit, segment.to / limit];
        if first >= 1.0 {
            stepper.unbounded(segment.start);
            return Ok(stepper.finished());
        }
        let breaks = last >= 1.0;
        if breaks {
            duration *= (1.0 - first) / (last - first);
            last = 1.0;
        }
        let slope = if duration.is_finite() { (last - first) / duration } else { 0.0 };
        let longest_step = 2.0 * duration / f64::from(asked.lines_per_zone);
        stepper.segment = index;
        let mut ahead = stepper.ahead.take().unwrap_or_else(|| {
            let ahead = Ahead {
                load: first,
                first,
                last,
                slope,
                whole: duration,
                passed: Clock::default(),
                end: segment.start + duration,
                longest_step,
                speed: 0.0,
                zone,
            };
            stepper.enter(&ahead);
            ahead
        });
        stepper.pass(&mut ahead, breaks, look)?;
        if stepper.is_over() {
            break;
        }
        if breaks {
            stepper.unbounded(segment.start + duration);
            return Ok(stepper.finished());
        }
        // The clock is that of the history, not a sum of steps.
        if segment.duration.is_finite() {
            stepper.base[0] = segment.start + duration - stepper.memory.time();
            if stepper.memory.time() > 0.0 && stepper.run.work.steps - stepper.rebased_at > stepper.memory.pieces_held() as u64 {
                stepper.rebase();
            }
        }
    }
    Ok(stepper.finished())
}

impl Stepper {
    /// A tip that rests under no load.
    fn new(problem: &GrowthProblem<'_>, zone: RelativeZone, asked: Asked<'_>) -> Self {
        let terms = terms_of(problem.material);
        Self {
            lines_per_zone: asked.lines_per_zone,
            outputs: [].into(),
            most_steps: asked.most_steps,
            until: asked.until,
            base: [0.0; 2],
            grid: Grid::even(0.0, 1.0, asked.lines_per_zone),
            shortest_time: 1.0 / terms.iter().map(|term| term.rate).fold(0.0, f64::max),
            rests: Vec::new(),
            slow_rests: Vec::new(),
            zone,
            quasi_steady: QuasiSteady::new(terms.clone(), zone),
            memory: Memory::new(terms, zone.at(0.0)),
            undisturbed: 0,
            uncertainties: [0.0; 2],
            moving: false,
            first_step: false,
            longest_advance: f64::INFINITY,
            unseen: 0.0,
            ever_moved: false,
            speed: 0.0,
            threshold: 0.0,
            sure: 0.0,
            uniform: (0.0, 0),
            rebased_at: 0,
            run: Run { samples: Vec::with_capacity(asked.outputs.len()), events: Vec::new(), residual: 0.0, work: GrowthWork::default() },
            segment: 0,
            ahead: None,
            looked_at: 0,
        }
    }

    /// Lines per process zone of its grid.
    pub(crate) const fn lines_per_zone(&self) -> u32 {
        self.lines_per_zone
    }

    /// Steps taken.
    pub(crate) const fn steps(&self) -> u64 {
        self.run.work.steps
    }

    fn time(&self) -> f64 {
        self.base[0] + self.memory.time()
    }

    /// Whether the last output is reached, to the clock's rounding. A step of growth may end after it, so that no step depends on it.
    fn is_over(&self) -> bool {
        self.until - self.time() <= 4.0 * f64::EPSILON * self.until
    }

    fn place(&self) -> f64 {
        self.base[1] + self.memory.place
    }

    fn rebase(&mut self) {
        self.rebased_at = self.run.work.steps;
        let [time, place] = self.memory.rebase();
        self.base[0] += time;
        self.base[1] += place;
        self.grid.shift(place);
        for rest in self.rests.iter_mut().chain(&mut self.slow_rests) {
            *rest -= place;
        }
    }

    fn sums(&mut self, step: &Step) -> Sums {
        self.run.work.closure_evaluations += 1;
        self.memory.after(step)
    }

    /// w/Δγ − 1 after a step.
    fn excess(&mut self, step: &Step) -> f64 {
        let load = step.loads[1];
        let sums = self.sums(step);
        load * (load + sums.memory) - 1.0
    }

    /// −(∂w/∂t)/(∂w/∂x), the speed that keeps the work at Δγ; not above zero if the tip stops.
    fn speed_of(&self, sums: &Sums, step: &Step, load_slope: f64) -> f64 {
        let (load, zone) = (step.loads[1], step.zone);
        let memory_rate = sums.growth + sums.lag / (zone * zone) * self.zone.rate(load, load_slope);
        let rate = load_slope * (2.0 * load + sums.memory) + load * memory_rate;
        let exposure = sums.exposure + self.memory.exposure_beyond_parabola(step);
        let held = zone * rate / (load * exposure);
        // Terms that answer within the step hold the slope with which its way ends, not that of the parabola: v = v₀ + C(v − slope).
        let part = self.memory.rate_by_last_slope(step) / exposure;
        let speed = if step.advance > 0.0 && step.duration > 0.0 && part < MOST_IMPLICIT {
            (held - part * (step.advance - step.bend) / step.duration) / (1.0 - part)
        } else {
            held
        };
        unless_stopped(speed, held)
    }

    /// What rounding leaves of the closure: of the sums, and of a place that is known to an ulp.
    fn rounding(&self, sums: &Sums, load: f64, zone: f64) -> f64 {
        8.0 * f64::EPSILON * (1.0 + load * sums.exposure * (1.0 + self.memory.place.abs() / zone))
    }

    /// A new segment of load, possibly after a jump of the load. Only a load that jumps can move the tip at once, or leave it behind: no residual of a step can.
    fn enter(&mut self, ahead: &Ahead) {
        let zone = ahead.zone.at(ahead.load);
        let here = Step::none(ahead.load, zone);
        self.uniform = (0.0, 0);
        self.threshold = if self.ever_moved { RESTART_THRESHOLD } else { 0.0 };
        let before = if self.moving { self.speed } else { 0.0 };
        let change = ahead.load - self.memory.load();
        let same = SAME_LOAD * ahead.load;
        let sums = self.sums(&here);
        let excess = ahead.load * (ahead.load + sums.memory) - 1.0;
        if change > same && excess > self.rounding(&sums, ahead.load, zone) {
            // The tip jumps to where the work is Δγ again: within one process zone, beyond which there is no memory and κ < 1.
            let advance = bracketed(zone, 0.5 * zone, |advance, this: &mut Self| -this.excess(&Step { advance, ..here }), self);
            if !self.ever_moved {
                self.event(RawKind::Begins, [0.0, 0.0], 0.0);
            } else if !self.moving {
                self.event(RawKind::Restarts, [0.0, 0.0], 0.0);
            }
            self.event(RawKind::Jumps, [before, before], advance);
            self.rests.push(self.memory.place);
            self.memory.take(&Step { advance, ..here }, None);
            self.moving = true;
            self.ever_moved = true;
        } else if self.moving && change < -same {
            self.arrest(before);
        }
        if self.moving {
            self.restart_grid(ahead);
            if self.speed <= 0.0 {
                self.arrest(before);
            }
        }
    }

    /// The speed from here on, and lines for it.
    fn restart_grid(&mut self, ahead: &Ahead) {
        let zone = ahead.zone.at(ahead.load);
        self.undisturbed = 0;
        self.first_step = true;
        let leaving = self.rest_leaving(ahead.load) + zone - self.memory.place;
        self.longest_advance = 2.0 * leaving / f64::from(self.lines_per_zone);
        let here = Step::none(ahead.load, zone);
        let sums = self.sums(&here);
        let held = self.speed_of(&sums, &here, ahead.slope);
        self.speed = unless_stopped(held + self.unseen / sums.exposure, held);
        let layer = self.speed * self.shortest_time / zone;
        self.grid = Grid::graded(self.memory.place, zone, self.lines_per_zone, layer);
    }

    /// Passes a segment of load.
    fn pass(&mut self, ahead: &mut Ahead, breaks: bool, look: &dyn Fn(&Self)) -> Result<(), Refusal> {
        while ahead.left() > 0.0 && !self.is_over() {
            if self.run.work.steps >= self.looked_at + BETWEEN_LOOKS {
                self.looked_at = self.run.work.steps;
                self.ahead = Some(*ahead);
                look(self);
                self.ahead = None;
            }
            if self.run.work.steps >= self.most_steps {
                return Err(Refusal::NotConverged {
                    what: "the growth of the crack",
                    detail: format!(
                        "{} steps were spent by time {:e}: fewer windows, or fewer lines per zone",
                        self.most_steps,
                        self.time()
                    ),
                });
            }
            if self.moving {
                if breaks && (ahead.left() <= 1e-9 * ahead.whole || 1.0 - ahead.load <= NEAREST) {
                    break;
                }
                self.grow(ahead, breaks);
            } else {
                self.rest(ahead);
            }
        }
        Ok(())
    }

    /// Takes a step and writes the outputs that lie in it.
    fn accept(&mut self, ahead: &mut Ahead, duration: f64, advance: f64, speeds: [f64; 2], between: Between) {
        self.unseen = 0.0;
        self.write_outputs(ahead, duration, advance, speeds, between);
        self.memory.take(&ahead.step(duration, advance), Some(speeds));
        ahead.pass(duration);
        self.run.work.steps += 1;
    }
}
