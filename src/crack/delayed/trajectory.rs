//! The trajectory of the tip with an error for every number: four runs, each with half the step of the one before.
//!
//! # How the errors are known
//! The runs have ½, 1, 2 and 4 times the lines per process zone. Where the last three do not have the same events in the same order, runs with half the step are added:
//! what happens is no matter of accuracy. The values are those of the finest: of third order in the step, with a coefficient that is the same in all runs, as lines,
//! starts, arrests and kinks are nodes of all of them. Where both ratios of neighbouring differences are near 8, the error is a seventh of the last difference and the
//! bound is that difference; where the last ratio is of that kind, five times as much. No difference counts as less than third order would make of the ones before: two
//! runs may agree by chance. In all other cases (a term whose place ẋ₀τ is about a line, runs of different events) the bound is two and a half times
//! the greatest of the
//! differences, the first one taken as a sixteenth.
//!
//! Nothing is extrapolated. What an extrapolation leaves is a hundredth of its own correction in the median and a quarter in one value of ten thousand (1200 random
//! histories), and no rule on four runs showed which: bounds that held were fifty times the error, bounds of ten times the error missed one value in two hundred.
//! Rounding is added: each step satisfies the closure to an ulp, which is ε/κΣP_j of a place, and sums over a window grow with its lines.

use super::finished_runs::{FinishedRuns, GrowthWatch, Keeper, Unwatched};
use super::load::LoadHistory;
use super::onset::{Onset, onset};
use super::problem::GrowthProblem;
use super::stepper::{Asked, GrowthWork, RawEvent, RawKind, RawSample, Run, run};
use crate::Estimate;
use crate::crack::{Motion, SteadyState, at_drive, virtual_work::VirtualWork};
use crate::refusal::{Refusal, require_non_negative};
use std::ops::Range;

/// How finely a history is stepped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Resolution {
    /// Grid lines per process zone of the second of the four runs, 4 to 65536; the finest has four times as many.
    pub lines_per_zone: u32,
    /// The most steps of one run; a history that needs more is refused, never left running.
    pub most_steps: u64,
}

impl Default for Resolution {
    /// 64 lines: about nine digits of a place.
    fn default() -> Self {
        Self { lines_per_zone: 64, most_steps: 5_000_000 }
    }
}

/// What the tip does at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TipState {
    /// It rests.
    Resting,
    /// It runs.
    Growing,
    /// The load has reached the glassy limit: in this theory the tip has run without bound.
    Unbounded,
}

/// The tip at an output time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// t (s).
    pub time: f64,
    /// K(t) (Pa √m), after the jump where there is one.
    pub intensity: f64,
    /// Rest or growth.
    pub state: TipState,
    /// x₀ − x₀(0) (m); none where unbounded.
    pub growth: Option<Estimate>,
    /// ẋ₀ (m/s); none where unbounded.
    pub speed: Option<Estimate>,
}

/// What happens to the tip; speeds in m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EventKind {
    /// The tip moves for the first time: with this speed, or by a jump at the same time (speed zero).
    GrowthBegins {
        /// Speed just after.
        speed: Estimate,
    },
    /// The tip stops.
    Arrest {
        /// Speed just before: near zero where the load falls slowly, not where it drops.
        speed_before: Estimate,
    },
    /// The tip moves again.
    Restart {
        /// Speed just after.
        speed: Estimate,
    },
    /// The load jumped up and the tip with it.
    Jump {
        /// How far (m).
        distance: Estimate,
    },
    /// A place where the tip rested leaves the process zone: the speed jumps.
    Kink {
        /// Speed just before.
        speed_before: Estimate,
        /// Speed just after.
        speed_after: Estimate,
    },
    /// The load reaches the glassy limit; the history ends here.
    Unbounded,
}

impl EventKind {
    /// The numbers it carries.
    fn numbers(&self) -> Vec<Estimate> {
        match *self {
            Self::GrowthBegins { speed } | Self::Restart { speed } | Self::Arrest { speed_before: speed } => vec![speed],
            Self::Jump { distance } => vec![distance],
            Self::Kink { speed_before, speed_after } => vec![speed_before, speed_after],
            Self::Unbounded => Vec::new(),
        }
    }
}

/// An event with its time and place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// When (s).
    pub time: Estimate,
    /// x₀ − x₀(0) (m) there, before a jump; of an unbounded growth, where the run ended.
    pub growth: Estimate,
}

/// A trajectory with its events and what it cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// At the output times.
    pub samples: Vec<Sample>,
    /// In order of time.
    pub events: Vec<Event>,
    /// The greatest |w/Δγ − 1| that a step of growth left.
    pub residual: f64,
    /// Work of all four runs.
    pub work: GrowthWork,
}

/// The trajectory of a tip under a load history, from an unloaded, rested body at time zero, with samples at `outputs` (s, ≥ 0, not
/// decreasing) and events up to the last of them.
///
/// # Errors
/// [`Refusal::OutOfRange`] for output times that are negative, infinite or decrease, or a resolution out of range;
/// [`Refusal::NotConverged`] when a run needs more steps than allowed.
pub fn trajectory(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    outputs: &[f64],
    resolution: Resolution,
) -> Result<Trajectory, Refusal> {
    refined_until(problem, history, outputs, resolution, &|_| 0.0)
}

/// The same, where runs with half the step are added until the bounds are short enough: `excess` is how many times the longest one is what is wanted. Steps are halved
/// up to 16 384 lines a process zone, and as long as that helps; the caller compares what comes out.
///
/// # Errors
/// Those of [`trajectory`].
pub fn refined_until(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    outputs: &[f64],
    resolution: Resolution,
    excess: &dyn Fn(&Trajectory) -> f64,
) -> Result<Trajectory, Refusal> {
    refined_from(problem, history, outputs, resolution, excess, None, &Unwatched)
}

/// The same from what was finished or under way before, of the same problem, history and times: the numbers are the same, to the last bit. `watch` is handed what there
/// is whenever that is due.
///
/// # Errors
/// Those of [`trajectory`].
pub fn refined_from(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    outputs: &[f64],
    resolution: Resolution,
    excess: &dyn Fn(&Trajectory) -> f64,
    from: Option<FinishedRuns>,
    watch: &dyn GrowthWatch,
) -> Result<Trajectory, Refusal> {
    let lines = resolution.lines_per_zone;
    if !(4..=65_536).contains(&lines) {
        return Err(Refusal::out_of_range("lines_per_zone", f64::from(lines), "between 4 and 65536"));
    }
    let mut until = 0.0;
    for &output in outputs {
        if require_non_negative("output time", output)? < until {
            return Err(Refusal::out_of_range("output time", output, "not less than the one before"));
        }
        until = output;
    }
    let keeper = Keeper::new(from, watch);
    let of_lines = |lines: u32| {
        let asked = Asked { outputs, until, lines_per_zone: lines, most_steps: resolution.most_steps };
        keeper.run(lines, |left_off, keeper| run(problem, history, asked, left_off, &|stepper| keeper.look(stepper)))
    };
    let mut lines = lines;
    let mut runs = [of_lines(lines.div_ceil(2))?, of_lines(lines)?, of_lines(2 * lines)?, of_lines(4 * lines)?];
    let mut dropped = GrowthWork::default();
    // The least excess so far, and how many runs have not lowered it.
    let (mut least, mut in_vain) = (f64::INFINITY, 0);
    loop {
        let found = of_runs(problem, history, outputs, &runs, lines, dropped)?;
        let same = same_story(&runs);
        let excess = excess(&found);
        in_vain = if excess < HELPFUL * least { 0 } else { in_vain + 1 };
        least = least.min(excess);
        if (same && (excess <= 1.0 || in_vain >= MOST_IN_VAIN)) || 8 * lines > MOST_LINES {
            return Ok(found);
        }
        // A run that takes too many steps is not added: the bounds say what is known without it.
        let Ok(finer) = of_lines(8 * lines) else { return Ok(found) };
        lines *= 2;
        runs.rotate_left(1);
        let [.., last] = &mut runs;
        dropped = dropped.plus(last.work);
        *last = finer;
    }
}

/// What four runs say, with the work of runs before them.
fn of_runs(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    outputs: &[f64],
    runs: &[Run; 4],
    lines: u32,
    dropped: GrowthWork,
) -> Result<Trajectory, Refusal> {
    let until = outputs.last().copied().unwrap_or(0.0);
    let peak = history.peak();
    let zone = problem.process_zone_at(peak);
    let samples: Vec<Sample> =
        outputs.iter().enumerate().map(|(index, &time)| sample(runs, f64::from(lines), index, time, history.at(time), zone)).collect();
    let mut events = events(runs, f64::from(lines), zone, until);
    // Under one constant load the delay is known to rounding from its own equation.
    if history.segments().len() == 1
        && let Some(Event { kind: EventKind::GrowthBegins { speed }, time, .. }) = events.first_mut()
        && let Onset::After { delay, initial_speed, .. } = onset(problem, history.last())?
    {
        (*time, *speed) = (delay, initial_speed);
    }
    // Whatever went wrong, no NaN leaves.
    let bad = |estimate: &Estimate| !(estimate.value.is_finite() && estimate.error.is_finite());
    let bad_sample = samples.iter().any(|sample: &Sample| sample.growth.iter().chain(&sample.speed).any(bad));
    if bad_sample || events.iter().any(|event| bad(&event.time) || bad(&event.growth) || event.kind.numbers().iter().any(bad)) {
        return Err(Refusal::NotConverged { what: "the growth of the crack", detail: "a result is not a finite number".into() });
    }
    let work = runs.iter().fold(dropped, |sum, run| sum.plus(run.work));
    let residual = runs.iter().map(|run| run.residual).fold(0.0, f64::max);
    Ok(Trajectory { samples, events, residual, work })
}

/// Lines of the finest run that is added.
const MOST_LINES: u32 = 16_384;
/// A run helps where it makes the longest bound shorter than this part: third order makes it an eighth.
const HELPFUL: f64 = 0.6;
/// Runs that may help nothing before no more are added: what is left is rounding.
const MOST_IN_VAIN: u32 = 2;

/// Whether the three finest runs have the same events in the same order. A rest shorter than the error of a coarse run may be missing there: what happens is not a
/// matter of accuracy, so finer ones decide.
fn same_story(runs: &[Run; 4]) -> bool {
    let [_, one, two, three] = runs;
    let same =
        |other: &Run| other.events.len() == three.events.len() && other.events.iter().zip(&three.events).all(|(a, b)| a.kind == b.kind);
    same(one) && same(two)
}

/// The steady motion that growth under a constant load K (Pa √m) tends to: the opening theory of [`VirtualWork`] with the same zone.
///
/// # Errors
/// [`Refusal::NoSuchState`] for a load at or beyond a limit of Eq 5.68; [`Refusal::Undefined`] for an elastic material.
pub fn tends_to(problem: &GrowthProblem<'_>, intensity: f64, tolerance: f64) -> Result<SteadyState, Refusal> {
    let interface = problem.interface_at(intensity);
    let curve = VirtualWork::new(problem.material, Motion::Opening, interface)?;
    at_drive(&curve, interface.body.drive(interface.work_of_adhesion, intensity), tolerance)
}

/// Rounding of a place in process zones, relative to itself and to one zone, at 64 lines; sums over the lines of a window let it grow with them.
const ROUNDING: f64 = 3e-14;
/// The same of speeds, relative to themselves, at 16 lines: slopes of steps and their terms lose more (measured: 6e-12 at 2048 lines).
const ROUNDING_OF_RATES: f64 = 1e-13;
/// Rounding of a time, relative to itself: the clock is that of the history.
const ROUNDING_OF_TIMES: f64 = 1e-14;

/// What a value is, which says how it is rounded.
#[derive(Debug, Clone, Copy)]
enum Quantity {
    /// In process zones; rounded relative to itself and to one zone.
    Place,
    Rate,
    Time,
}

impl Quantity {
    fn rounding(self, value: f64, lines: f64) -> f64 {
        match self {
            Self::Place => ROUNDING * (1.0 + lines / 64.0) * (value.abs() + 1.0),
            Self::Rate => ROUNDING_OF_RATES * (1.0 + lines / 16.0) * value.abs(),
            Self::Time => ROUNDING_OF_TIMES * value.abs(),
        }
    }
}

/// Ratios of neighbouring differences, the first and the last, where nothing but third order is left; 8 is perfect.
const PERFECT: [Range<f64>; 2] = [6.0..10.5, 7.0..9.2];
/// The bound there, over the last difference, of which the error is a seventh (2700 random histories: most need 0.143, the worst 0.93).
const PERFECT_PART: f64 = 1.0;

/// Ratios of the last differences where something else is left besides third order, or what is left falls faster.
const SIMILAR: Range<f64> = 4.5..40.0;
/// The bound there, over the last difference.
const SIMILAR_PART: f64 = 5.0;

/// The bound of any other value, over the greatest difference.
const IRREGULAR_PART: f64 = 2.5;

/// A difference counts as no less than this part of the one before.
const THIRD_ORDER: f64 = 0.125;

/// The part of the first difference that counts where nothing is regular.
const FIRST_PART: f64 = 1.0 / 16.0;

/// The value and error that four runs of third order give, before units.
fn with_bound([coarsest, coarse, middle, fine]: [f64; 4], quantity: Quantity, lines: f64) -> Estimate {
    let [first, second, third] = [coarse - coarsest, middle - coarse, fine - middle];
    let ratios = [first / second, second / third];
    let [first, second, third] = [first, second, third].map(f64::abs);
    let expected = third.max(THIRD_ORDER * second.max(THIRD_ORDER * first));
    let bar = if PERFECT[0].contains(&ratios[0]) && PERFECT[1].contains(&ratios[1]) {
        PERFECT_PART * expected
    } else if SIMILAR.contains(&ratios[1]) {
        SIMILAR_PART * expected
    } else {
        IRREGULAR_PART * third.max(second).max(FIRST_PART * first)
    };
    Estimate::new(fine, bar + quantity.rounding(fine, lines))
}

fn sample(runs: &[Run; 4], lines: f64, index: usize, time: f64, intensity: f64, zone: f64) -> Sample {
    let at = |run: &Run| {
        run.samples.get(index).copied().unwrap_or(RawSample {
            place: 0.0,
            speed: 0.0,
            moving: false,
            bounded: true,
            uncertainties: [0.0; 2],
        })
    };
    let [coarsest, coarse, middle, fine] = [at(&runs[0]), at(&runs[1]), at(&runs[2]), at(&runs[3])];
    if !fine.bounded {
        return Sample { time, intensity, state: TipState::Unbounded, growth: None, speed: None };
    }
    let agreed = [coarsest, coarse, middle].iter().all(|one| one.moving == fine.moving);
    let resting = agreed && !fine.moving;
    let places = [coarsest.place, coarse.place, middle.place, fine.place];
    let speeds = [coarsest.speed, coarse.speed, middle.speed, fine.speed];
    let widened = |estimate: Estimate, uncertainty: f64| Estimate::new(estimate.value, estimate.error + uncertainty);
    let growth = if resting && fine.place == 0.0 {
        Estimate::exact(0.0)
    } else {
        widened(with_bound(places, Quantity::Place, lines), fine.uncertainties[0])
    };
    let speed = if resting { Estimate::exact(0.0) } else { widened(with_bound(speeds, Quantity::Rate, lines), fine.uncertainties[1]) };
    let state = if fine.moving { TipState::Growing } else { TipState::Resting };
    Sample { time, intensity, state, growth: Some(growth.scaled(zone)), speed: Some(speed.scaled(zone)) }
}

/// The events of the finest run; those of the others, in the same order, give the errors.
fn events(runs: &[Run; 4], lines: f64, zone: f64, until: f64) -> Vec<Event> {
    let (mut together, mut all_together) = (true, true);
    runs[3]
        .events
        .iter()
        .enumerate()
        .map(|(index, fine)| {
            let same = |run: &Run| run.events.get(index).copied().filter(|event| event.kind == fine.kind);
            let others = same(&runs[1]).zip(same(&runs[2])).filter(|_| together);
            together = others.is_some();
            let (coarse, middle) = others.unwrap_or((*fine, *fine));
            // The coarsest run need not tell the same story: its numbers are then those of the next, and nothing looks regular.
            let coarsest = same(&runs[0]).filter(|_| all_together && together);
            all_together = coarsest.is_some();
            let coarsest = coarsest.unwrap_or(coarse);
            let number = |of: &dyn Fn(&RawEvent) -> f64, quantity: Quantity, range: f64| {
                let estimate = with_bound([of(&coarsest), of(&coarse), of(&middle), of(fine)], quantity, lines);
                // The runs no longer tell the same story: all that is certain is the range.
                if together { estimate } else { Estimate::new(estimate.value, range) }
            };
            let place = fine.place.abs().max(1.0);
            let speed = |side: usize| {
                let estimate = number(&|event| event.speeds[side], Quantity::Rate, fine.speeds[side].abs().max(place / until));
                let uncertainty = if fine.speeds[side] > 0.0 { fine.speed_uncertainty } else { 0.0 };
                Estimate::new(estimate.value, estimate.error + uncertainty).scaled(zone)
            };
            let kind = match fine.kind {
                RawKind::Begins => EventKind::GrowthBegins { speed: speed(1) },
                RawKind::Restarts => EventKind::Restart { speed: speed(1) },
                RawKind::Arrests => EventKind::Arrest { speed_before: speed(0) },
                RawKind::Jumps => EventKind::Jump { distance: number(&|event| event.jump, Quantity::Place, 1.0).scaled(zone) },
                RawKind::Kinks => EventKind::Kink { speed_before: speed(0), speed_after: speed(1) },
                RawKind::Unbounded => EventKind::Unbounded,
            };
            let time = number(&|event| event.time, Quantity::Time, until);
            let growth = number(&|event| event.place, Quantity::Place, place);
            Event { kind, time, growth: Estimate::new(growth.value, growth.error + fine.uncertainty).scaled(zone) }
        })
        .collect()
}

/// Where the tip is at some times (s, not decreasing), in lengths of a constant process zone, by one run with so many lines to a zone: no bound, for studies of
/// convergence.
///
/// # Errors
/// As [`trajectory`].
pub fn places_of_one_run(
    problem: &GrowthProblem<'_>,
    history: &LoadHistory,
    times: &[f64],
    lines_per_zone: u32,
) -> Result<Vec<f64>, Refusal> {
    let until = times.last().copied().unwrap_or(0.0);
    let found = run(problem, history, Asked { outputs: times, until, lines_per_zone, most_steps: u64::MAX }, None, &|_| ())?;
    Ok(found.samples.iter().map(|sample| sample.place).collect())
}
