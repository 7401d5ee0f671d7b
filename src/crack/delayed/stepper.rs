//! One run at one step size: rest, growth, arrest, restart, jump, kink.
//!
//! # What it does
//! The trajectory is a chain of pieces, straight in time, whose ends satisfy the closure to rounding; each piece's memory is integrated
//! exactly. While the tip runs it is carried from one line of a grid of m lines per process zone to the next, and the unknown is the
//! time (t(x) is smooth where x(t) starts with a jump of speed; and the back of the window then lies on the grid as well). The grid starts where growth
//! or a new stretch of load starts, so the kink one process zone later is a line. Where the load is slow in coming, or the tip slows
//! down, the time step is bounded (m/2 steps in a stretch of load) and the unknown is the place.
//!
//! # How good
//! Second order in 1/m, exact for uniform motion. An arrest is closed in on by halving until the step is 10⁻³/m of the usual one. When
//! all steps of a window agree to rounding under a constant load, the motion is uniform from then on: the rest of the stretch is one piece.

use super::first_crossing::Rest;
use super::load::LoadHistory;
use super::memory::{Memory, SAME_PLACE, Step, Sums, terms_of};
use super::problem::GrowthProblem;
use super::quasi_steady::{QuasiSteady, Steadiness};
use super::zone::RelativeZone;
use crate::refusal::Refusal;

/// What the tip does, as counted by one run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RawKind {
    Begins,
    Restarts,
    Arrests,
    Jumps,
    Kinks,
    Unbounded,
}

/// An event: time (s), place (process zones), speeds before and after (process zones/s), places jumped over.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RawEvent {
    pub(crate) kind: RawKind,
    pub(crate) time: f64,
    pub(crate) place: f64,
    pub(crate) speeds: [f64; 2],
    pub(crate) jump: f64,
    /// What is not known of the place, beyond the error of stepping.
    pub(crate) doubt: f64,
}

/// The tip at an output time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RawSample {
    pub(crate) place: f64,
    pub(crate) speed: f64,
    pub(crate) moving: bool,
    pub(crate) bounded: bool,
    /// What is not known of place and speed, beyond the error of stepping.
    pub(crate) doubts: [f64; 2],
}

/// Work done by a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct GrowthWork {
    /// Steps taken.
    pub steps: u64,
    /// Evaluations of the closure.
    pub closure_evaluations: u64,
    /// Integrals of one term over one piece.
    pub kernel_evaluations: u64,
    /// The most pieces of history held at a time.
    pub most_pieces: u64,
}

impl GrowthWork {
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            closure_evaluations: self.closure_evaluations + other.closure_evaluations,
            kernel_evaluations: self.kernel_evaluations + other.kernel_evaluations,
            most_pieces: self.most_pieces.max(other.most_pieces),
        }
    }
}

/// What a run returns.
pub(crate) struct Run {
    pub(crate) samples: Vec<RawSample>,
    pub(crate) events: Vec<RawEvent>,
    /// The greatest |w/Δγ − 1| after a step of growth.
    pub(crate) residual: f64,
    pub(crate) work: GrowthWork,
}

/// A start of growth right after an arrest must exceed the work of adhesion by this part, or rounding would start it.
const RESTART_THRESHOLD: f64 = 1e-13;

/// Zones per second from which on a speed counts as this: a start within an ulp of the glassy limit has no memory to divide by.
const FASTEST: f64 = 1e150;

/// So near the glassy limit a load has no digits left for the speed: a ramp that passes the limit ends here.
const NEAREST: f64 = 1e-8;

struct Stepper<'a> {
    memory: Memory,
    lines_per_zone: u32,
    outputs: &'a [f64],
    most_steps: u64,
    until: f64,
    /// Time and place of the memory's own zero.
    base: [f64; 2],
    /// The grid: its start, in places of the memory, the lines passed since, and their distance.
    grid: (f64, u64, f64),
    /// Places of rests that are, or may come, within the zone.
    rests: Vec<f64>,
    zone: RelativeZone,
    quasi_steady: QuasiSteady,
    /// Lines passed since the motion was last disturbed.
    undisturbed: u32,
    /// What is not known of place and speed after quasi-steady growth.
    doubts: [f64; 2],
    moving: bool,
    ever_moved: bool,
    speed: f64,
    threshold: f64,
    /// The step all steps of late agree with, and how many do.
    uniform: (f64, u32),
    /// Steps taken when the memory's zero was last moved.
    rebased_at: u64,
    run: Run,
}

/// The load over the rest of a stretch.
#[derive(Clone, Copy)]
struct Ahead {
    load: f64,
    slope: f64,
    left: f64,
    last: f64,
    whole: f64,
    /// When the stretch ends, by the clock of the history.
    end: f64,
    longest_step: f64,
    zone: RelativeZone,
}

impl Ahead {
    fn load_after(&self, duration: f64) -> f64 {
        if duration >= self.left { self.last } else { self.load + self.slope * duration }
    }

    fn step(&self, duration: f64, advance: f64) -> Step {
        let load = self.load_after(duration);
        Step { duration, advance, loads: [self.load, load], zone: self.zone.at(load) }
    }

    /// Whether the zone changes in this stretch.
    fn zone_changes(&self) -> bool {
        self.zone.follows() && self.slope != 0.0
    }

    fn pass(&mut self, duration: f64) {
        self.load = self.load_after(duration);
        self.left = if duration >= self.left { 0.0 } else { self.left - duration };
    }
}

/// Runs a history up to a time, with the tip's state at the `outputs` (times not decreasing, none after `until`).
pub(crate) fn run(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    outputs: &[f64],
    until: f64,
    lines_per_zone: u32,
    most_steps: u64,
) -> Result<Run, Refusal> {
    let limit = problem.glassy_limit();
    let zone = RelativeZone::new(problem, history.peak(), limit);
    let mut stepper = Stepper {
        memory: Memory::new(terms_of(problem.material), zone.at(0.0)),
        lines_per_zone,
        outputs,
        most_steps,
        until,
        base: [0.0; 2],
        grid: (0.0, 0, 1.0),
        rests: Vec::new(),
        zone,
        quasi_steady: QuasiSteady::new(terms_of(problem.material), zone),
        undisturbed: 0,
        doubts: [0.0; 2],
        moving: false,
        ever_moved: false,
        speed: 0.0,
        threshold: 0.0,
        uniform: (0.0, 0),
        rebased_at: 0,
        run: Run { samples: Vec::with_capacity(outputs.len()), events: Vec::new(), residual: 0.0, work: GrowthWork::default() },
    };
    for stretch in history.stretches() {
        if stretch.start > until {
            break;
        }
        let mut duration = stretch.duration;
        let [first, mut last] = [stretch.from / limit, stretch.to / limit];
        if first >= 1.0 {
            stepper.unbounded(stretch.start);
            return Ok(stepper.finished());
        }
        let breaks = last >= 1.0;
        if breaks {
            duration *= (1.0 - first) / (last - first);
            last = 1.0;
        }
        let slope = if duration.is_finite() { (last - first) / duration } else { 0.0 };
        let longest_step = 2.0 * duration / f64::from(lines_per_zone);
        let mut ahead =
            Ahead { load: first, slope, left: duration, last, whole: duration, end: stretch.start + duration, longest_step, zone };
        stepper.enter(&ahead);
        stepper.pass(&mut ahead, breaks)?;
        if stepper.is_over() {
            break;
        }
        if breaks {
            stepper.unbounded(stretch.start + duration);
            return Ok(stepper.finished());
        }
        // The clock is that of the history, not a sum of steps.
        if stretch.duration.is_finite() {
            stepper.base[0] = stretch.start + duration - stepper.memory.clock;
            if stepper.memory.clock > 0.0 && stepper.run.work.steps - stepper.rebased_at > stepper.memory.pieces_held() as u64 {
                stepper.rebase();
            }
        }
    }
    Ok(stepper.finished())
}

impl Stepper<'_> {
    fn time(&self) -> f64 {
        self.base[0] + self.memory.clock
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
        self.grid.0 -= place;
        for rest in &mut self.rests {
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

    /// −(∂w/∂t)/(∂w/∂x), the speed that keeps the work at Δγ.
    fn speed_of(&self, sums: &Sums, load: f64, load_slope: f64) -> f64 {
        let zone = self.zone.at(load);
        let memory_rate = sums.growth + sums.lag / (zone * zone) * self.zone.rate(load, load_slope);
        let rate = load_slope * (2.0 * load + sums.memory) + load * memory_rate;
        let speed = zone * rate / (load * sums.exposure);
        if speed.is_nan() { 0.0 } else { speed.min(FASTEST) }
    }

    fn event(&mut self, kind: RawKind, speeds: [f64; 2], jump: f64) {
        let event = RawEvent { kind, time: self.time(), place: self.place(), speeds, jump, doubt: self.doubts[0] };
        self.run.events.push(event);
    }

    /// A new stretch of load, possibly after a jump of the load.
    fn enter(&mut self, ahead: &Ahead) {
        let zone = ahead.zone.at(ahead.load);
        let here = Step::none(ahead.load, zone);
        let excess = self.excess(&here);
        self.uniform = (0.0, 0);
        self.threshold = if self.ever_moved { RESTART_THRESHOLD } else { 0.0 };
        let before = if self.moving { self.speed } else { 0.0 };
        if excess > 1e-12 {
            // The tip jumps to where the work is Δγ again: within one process zone, beyond which there is no memory and κ < 1.
            let advance = bracketed(zone, 0.5 * zone, |advance, this: &mut Self| -this.excess(&Step { advance, ..here }), self);
            if !self.ever_moved {
                self.event(RawKind::Begins, [0.0, 0.0], 0.0);
            } else if !self.moving {
                self.event(RawKind::Restarts, [0.0, 0.0], 0.0);
            }
            self.event(RawKind::Jumps, [before, before], advance);
            self.rests.push(self.memory.place);
            self.memory.take(&Step { advance, ..here });
            self.moving = true;
            self.ever_moved = true;
        } else if self.moving && excess < -1e-12 {
            self.arrest(before);
        }
        if self.moving {
            self.restart_grid(ahead);
            if self.speed <= 0.0 {
                self.arrest(before);
            }
        }
    }

    fn restart_grid(&mut self, ahead: &Ahead) {
        let zone = ahead.zone.at(ahead.load);
        self.grid = (self.memory.place, 0, zone / f64::from(self.lines_per_zone));
        self.undisturbed = 0;
        let sums = self.sums(&Step::none(ahead.load, zone));
        self.speed = self.speed_of(&sums, ahead.load, ahead.slope);
    }

    fn arrest(&mut self, before: f64) {
        self.event(RawKind::Arrests, [before, 0.0], 0.0);
        self.moving = false;
        self.speed = 0.0;
        self.threshold = self.threshold.max(RESTART_THRESHOLD);
    }

    /// Passes a stretch of load.
    fn pass(&mut self, ahead: &mut Ahead, breaks: bool) -> Result<(), Refusal> {
        while ahead.left > 0.0 && !self.is_over() {
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
                if breaks && (ahead.left <= 1e-9 * ahead.whole || 1.0 - ahead.load <= NEAREST) {
                    break;
                }
                self.grow(ahead, breaks);
            } else {
                self.rest(ahead);
            }
        }
        Ok(())
    }

    fn rest(&mut self, ahead: &mut Ahead) {
        let longest = ahead.left.min(self.until - self.time());
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
        self.accept(ahead, duration, 0.0, [0.0; 2]);
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
            self.moving = true;
            self.ever_moved = true;
            self.uniform = (0.0, 0);
        } else {
            self.threshold = (self.threshold * 10.0).max(RESTART_THRESHOLD);
        }
    }

    /// Whether a place of rest is within the zone of a load.
    fn in_zone(&self, rest: f64, load: f64) -> bool {
        rest + self.zone.at(load) > self.memory.place + SAME_PLACE
    }

    /// One step of growth, or an arrest, or the rest of the stretch in uniform motion.
    fn grow(&mut self, ahead: &mut Ahead, breaks: bool) {
        let zone = ahead.zone.at(ahead.load);
        let calm = !self.rests.iter().any(|rest| self.in_zone(*rest, ahead.load));
        if self.uniform.1 > self.lines_per_zone + 2 && calm && ahead.slope == 0.0 {
            // Steps agree to their own rounding, which is that of many lines: the steady motion is known better.
            let stepped = self.uniform.0 * f64::from(self.lines_per_zone);
            let steady = self.quasi_steady.motion(ahead.load, 0.0).map_or(stepped, |motion| motion.crossing_time);
            self.count_quasi_steady();
            let crossing = if (steady / stepped - 1.0).abs() < 1e-9 { steady } else { stepped };
            let left = ahead.left.min(self.until - self.time());
            if left > 4.0 * crossing {
                self.memory.replace(&[[zone, crossing, ahead.load], [0.0, 0.0, ahead.load]]);
                let advance = zone * (left / crossing);
                self.accept(ahead, left, advance, [zone / crossing; 2]);
                self.memory.replace(&[[zone, crossing, ahead.load], [0.0, 0.0, ahead.load]]);
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
        let line = self.grid.0 + (self.grid.1 + 1) as f64 * self.grid.2 - self.memory.place;
        // The nearest place of rest at the far end of the zone: where it leaves, the speed jumps.
        let rest = self.rests.iter().copied().filter(|rest| self.in_zone(*rest, ahead.load)).fold(f64::INFINITY, f64::min);
        let place = self.memory.place;
        let probe = *ahead;
        let whole_at = |duration: f64| line.min((rest + probe.zone.at(probe.load_after(duration)) - place).max(0.0));
        let longest = ahead.left.min(ahead.longest_step);
        let mut duration = longest.min(2.0 * whole_at(0.0) / self.speed);
        let usual = duration;
        // Whether the closure is met at the grid line within the time, or short of it, or not even where the tip is.
        loop {
            if self.excess(&probe.step(duration, whole_at(duration))) >= 0.0 {
                let guess = whole_at(0.0) / self.speed;
                let time = bracketed(duration, guess, |time, this: &mut Self| this.excess(&probe.step(time, whole_at(time))), self);
                let whole = whole_at(time);
                self.advance(ahead, time, whole, whole >= line);
                return;
            }
            if self.excess(&probe.step(duration, 0.0)) > 0.0 {
                let whole = whole_at(duration);
                let guess = (self.speed * duration).min(0.5 * whole);
                let place = bracketed(whole, guess, |place, this: &mut Self| -this.excess(&probe.step(duration, place)), self);
                self.advance(ahead, duration, place, false);
                return;
            }
            duration *= 0.5;
            if duration <= 1e-3 / f64::from(self.lines_per_zone) * usual.min(longest) || duration < 1e-15 * self.time() {
                self.arrest(self.speed);
                return;
            }
        }
    }

    /// Follows slow growth by its quasi-steady speed, as far as that is good; false if it is not good enough here.
    fn glide(&mut self, ahead: &mut Ahead, breaks: bool) -> bool {
        let tolerance = Steadiness::tolerance(self.lines_per_zone);
        let end = ahead.left.min(self.until - self.time()) - if breaks { 1e-9 * ahead.whole } else { 0.0 };
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
            let doubt = now.doubt().max(four.doubt());
            self.doubts[0] += doubt * advance;
            self.doubts[1] = doubt * now.speed.max(four.speed);
            self.write_outputs(ahead, duration, advance, [now.speed, four.speed]);
            self.memory.clock += duration;
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
            self.memory.replace(&now.way(ahead.load, ahead.slope, zone, self.lines_per_zone, factor));
            let excess = self.excess(&Step::none(ahead.load, zone));
            factor *= 1.0 - excess / now.sensitivity;
            if excess.abs() < 1e-14 {
                break;
            }
        }
        self.rests.clear();
        self.restart_grid(ahead);
        self.speed = now.speed;
        true
    }

    fn count_quasi_steady(&mut self) {
        let evaluations = std::mem::take(&mut self.quasi_steady.evaluations);
        self.run.work.closure_evaluations += evaluations;
        self.run.work.kernel_evaluations += evaluations * self.memory.terms.len() as u64;
    }

    fn advance(&mut self, ahead: &mut Ahead, duration: f64, advance: f64, on_line: bool) {
        let step = ahead.step(duration, advance);
        let sums = self.sums(&step);
        let load = step.loads[1];
        self.run.residual = self.run.residual.max((load * (load + sums.memory) - 1.0).abs());
        let before = self.speed_of(&sums, step.loads[1], ahead.slope);
        if on_line {
            self.grid.1 += 1;
            self.undisturbed = self.undisturbed.saturating_add(1);
            // The way before was that of quasi-steady growth, until it is two zones behind.
            if self.undisturbed > 2 * self.lines_per_zone {
                self.doubts[1] = 0.0;
            }
        }
        let within: Vec<f64> = self.rests.iter().copied().filter(|rest| self.in_zone(*rest, ahead.load)).collect();
        self.accept(ahead, duration, advance, [self.speed, before]);
        self.speed = before;
        if within.iter().any(|rest| !self.in_zone(*rest, ahead.load)) {
            let sums = self.sums(&Step::none(ahead.load, step.zone));
            self.speed = self.speed_of(&sums, ahead.load, ahead.slope);
            self.event(RawKind::Kinks, [before, self.speed], 0.0);
            self.uniform = (0.0, 0);
            self.undisturbed = 0;
        }
        // The greatest zone is 1.
        let behind = self.memory.place - 1.0 + SAME_PLACE;
        self.rests.retain(|rest| *rest > behind);
        if on_line && ahead.zone_changes() {
            self.grid = (self.memory.place, 0, step.zone / f64::from(self.lines_per_zone));
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

    /// Takes a step and writes the outputs that lie in it.
    fn accept(&mut self, ahead: &mut Ahead, duration: f64, advance: f64, speeds: [f64; 2]) {
        self.write_outputs(ahead, duration, advance, speeds);
        self.memory.take(&ahead.step(duration, advance));
        ahead.pass(duration);
        self.run.work.steps += 1;
    }

    /// Writes the outputs that lie in a step; between its ends x is the cubic with both speeds.
    fn write_outputs(&mut self, ahead: &Ahead, duration: f64, advance: f64, speeds: [f64; 2]) {
        let (start, from) = (self.time(), self.place());
        // A sum of steps may be an ulp away from the end of a stretch, where the speed may jump: an output there belongs to this side.
        let end = if ahead.left <= duration { ahead.end } else { start + duration };
        while let Some(&output) = self.outputs.get(self.run.samples.len()) {
            if output >= end && !(ahead.left <= duration && output <= end) {
                break;
            }
            let sample = if advance > 0.0 && duration > 0.0 {
                let u = ((output - start) / duration).clamp(0.0, 1.0);
                // Hermite's cubic; slopes up to three times the mean one keep it monotone (Fritsch and Carlson, 1980).
                let [a, b] = speeds.map(|speed| (speed * duration).clamp(0.0, 3.0 * advance));
                let place = u * u * (3.0 - 2.0 * u) * advance + u * (1.0 - u) * ((1.0 - u) * a - u * b);
                let slope = 6.0 * u * (1.0 - u) * advance + (1.0 - u) * (1.0 - 3.0 * u) * a + u * (3.0 * u - 2.0) * b;
                RawSample {
                    place: from + place.clamp(0.0, advance),
                    speed: slope.max(0.0) / duration,
                    moving: true,
                    bounded: true,
                    doubts: self.doubts,
                }
            } else {
                RawSample { place: from, speed: 0.0, moving: false, bounded: true, doubts: self.doubts }
            };
            self.run.samples.push(sample);
        }
    }

    fn unbounded(&mut self, time: f64) {
        while let Some(&output) = self.outputs.get(self.run.samples.len()) {
            if output >= time {
                break;
            }
            let sample =
                RawSample { place: self.place(), speed: self.speed.max(0.0), moving: self.moving, bounded: true, doubts: self.doubts };
            self.run.samples.push(sample);
        }
        let event = RawEvent {
            kind: RawKind::Unbounded,
            time,
            place: self.place(),
            speeds: [self.speed.max(0.0), 0.0],
            jump: 0.0,
            doubt: self.doubts[0],
        };
        self.run.events.push(event);
        let gone = RawSample { place: self.place(), speed: 0.0, moving: true, bounded: false, doubts: [0.0; 2] };
        self.run.samples.resize(self.outputs.len(), gone);
    }

    fn finished(mut self) -> Run {
        let last = RawSample { place: self.place(), speed: self.speed.max(0.0), moving: self.moving, bounded: true, doubts: self.doubts };
        self.run.samples.resize(self.outputs.len(), last);
        let until = self.until * (1.0 + 4.0 * f64::EPSILON);
        self.run.events.retain(|event| event.time <= until);
        self.run.work.kernel_evaluations += self.memory.kernel_evaluations;
        self.run.work.most_pieces = self.memory.most_pieces as u64;
        self.run
    }
}

/// The place in 0…`upper` where a function negative at 0 and positive at `upper` changes sign: the rule of Anderson and Björck (1973,
/// BIT 13, 253) with halving as its safeguard.
fn bracketed<C>(upper: f64, guess: f64, function: impl Fn(f64, &mut C) -> f64, context: &mut C) -> f64 {
    let (mut low, mut high) = (0.0, upper);
    let (mut f_low, mut f_high) = (f64::NAN, f64::NAN);
    let mut x = if guess > 0.0 && guess < upper { guess } else { 0.5 * upper };
    let (mut slow, mut last_below) = (0, None);
    for _ in 0..200 {
        let width = high - low;
        let value = function(x, context);
        if value.abs() <= f64::EPSILON {
            return x;
        }
        // The end that is kept twice running is weighed less.
        let (kept, passed) = if value < 0.0 { (&mut f_high, &mut f_low) } else { (&mut f_low, &mut f_high) };
        if last_below == Some(value < 0.0) && kept.is_finite() {
            let factor = 1.0 - value / *passed;
            *kept *= if factor > 0.0 { factor } else { 0.5 };
        }
        last_below = Some(value < 0.0);
        *passed = value;
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        if high - low <= 2.0 * f64::EPSILON * high {
            return high;
        }
        slow = if high - low > 0.5 * width { slow + 1 } else { 0 };
        let known = f_low.is_finite() && f_high.is_finite();
        x = if known && slow <= 3 { low + (high - low) * (f_low / (f_low - f_high)) } else { 0.5 * (low + high) };
        if slow > 3 {
            slow = 0;
        }
        if x <= low || x >= high {
            x = 0.5 * (low + high);
        }
        if x <= low || x >= high {
            return high;
        }
    }
    0.5 * (low + high)
}
