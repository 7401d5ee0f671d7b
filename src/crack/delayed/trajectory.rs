//! The trajectory of the tip with an error for every number: three runs, each with half the step of the one before.
//!
//! # How the errors are known
//! The runs have 1, 2 and 4 times the lines per process zone. Where the results converge like the square of the step (their differences are
//! in a ratio between 3.2 and 5), the two last are extrapolated, value = x₄ + (x₄ − x₂)/3, and the error is the difference to the
//! extrapolation of the first two plus a part of the last difference that stands for terms of third order. Elsewhere (an arrest between two lines, a load that breaks between them) the finest value
//! stands and the error is the sum of both differences. Rounding is added: each step satisfies the closure to an ulp, which is ε/κΣP_j of a place.

use super::load::LoadHistory;
use super::onset::{Onset, onset};
use super::problem::GrowthProblem;
use super::stepper::{GrowthWork, RawEvent, RawKind, RawSample, Run, run};
use crate::Estimate;
use crate::crack::{Motion, SteadyState, at_drive, virtual_work::VirtualWork};
use crate::refusal::{Refusal, require_non_negative};

/// How finely a history is stepped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Resolution {
    /// Grid lines per process zone of the coarsest of the three runs, 4 to 65536.
    pub lines_per_zone: u32,
    /// The most steps of one run; a history that needs more is refused, never left running.
    pub most_steps: u64,
}

impl Default for Resolution {
    /// 64 lines: about nine digits of a place under a constant load.
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
    /// Work of all three runs.
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
    let runs = [
        run(problem, history, outputs, until, lines, resolution.most_steps)?,
        run(problem, history, outputs, until, 2 * lines, resolution.most_steps)?,
        run(problem, history, outputs, until, 4 * lines, resolution.most_steps)?,
    ];
    let irregular = irregular_part(problem, lines);
    let peak = history.peak();
    let zone = problem.process_zone_at(peak);
    let samples: Vec<Sample> =
        outputs.iter().enumerate().map(|(index, &time)| sample(&runs, irregular, index, time, history.at(time), zone)).collect();
    let mut events = events(&runs, irregular, zone, until);
    // Under one constant load the delay is known to rounding from its own equation.
    if history.stretches().len() == 1
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
    let work = runs.iter().fold(GrowthWork::default(), |sum, run| sum.plus(run.work));
    let residual = runs.iter().map(|run| run.residual).fold(0.0, f64::max);
    Ok(Trajectory { samples, events, residual, work })
}

/// The steady motion that growth under a constant load K tends to: the opening theory of [`VirtualWork`] with the same zone.
///
/// # Errors
/// [`Refusal::NoSuchState`] for a load at or beyond a limit of Eq 5.68; [`Refusal::Undefined`] for an elastic material.
pub fn tends_to(problem: &GrowthProblem<'_>, intensity: f64, tolerance: f64) -> Result<SteadyState, Refusal> {
    let interface = problem.interface_at(intensity);
    let curve = VirtualWork::new(problem.material, Motion::Opening, interface)?;
    at_drive(&curve, interface.body.drive(interface.work_of_adhesion, intensity), tolerance)
}

/// Rounding of a place or speed in the units of the runs, relative to itself and to one process zone.
const ROUNDING: f64 = 1e-14;

/// Errors of third order (loads that break between grid lines) are this part of the last difference, over the lines of the coarsest run.
/// Measured: over 400 random histories at 16 lines no bar of 2160 was too short.
const IRREGULAR_PART: f64 = 4.0;

/// With several times in the material some term has always answered within a step, at a place x_j = ẋ₀τ_j less than a line: its error goes
/// by x_j/m, below the second order in size and above it in slope. The bar then holds the whole last difference: a quarter of it was too
/// short for one value in some hundreds (tests/crack_sec_5_4_order_after_a_start.rs).
const FAST_TERMS_PART: f64 = 1.0;

/// What is added to the bars of extrapolated values, over the last difference.
fn irregular_part(problem: &GrowthProblem<'_>, lines: u32) -> f64 {
    let regular = IRREGULAR_PART / f64::from(lines);
    if problem.material.creep_terms().len() > 1 { regular.max(FAST_TERMS_PART) } else { regular }
}

/// The value and error that three runs of second order give, before units; `scale` is what rounding is measured against.
fn extrapolated([coarse, middle, fine]: [f64; 3], scale: f64, irregular: f64) -> Estimate {
    let (first, second) = (middle - coarse, fine - middle);
    let rounding = ROUNDING * (fine.abs() + scale);
    let ratio = first / second;
    if (3.2..5.0).contains(&ratio) {
        let value = fine + second / 3.0;
        return Estimate::new(value, (value - (middle + first / 3.0)).abs() + irregular * second.abs() + rounding);
    }
    Estimate::new(fine, first.abs() + second.abs() + rounding)
}

fn sample(runs: &[Run; 3], irregular: f64, index: usize, time: f64, intensity: f64, zone: f64) -> Sample {
    let at = |run: &Run| {
        run.samples.get(index).copied().unwrap_or(RawSample { place: 0.0, speed: 0.0, moving: false, bounded: true, doubts: [0.0; 2] })
    };
    let [coarse, middle, fine] = [at(&runs[0]), at(&runs[1]), at(&runs[2])];
    if !fine.bounded {
        return Sample { time, intensity, state: TipState::Unbounded, growth: None, speed: None };
    }
    let agreed = coarse.moving == fine.moving && middle.moving == fine.moving;
    let resting = agreed && !fine.moving;
    let places = [coarse.place, middle.place, fine.place];
    let speeds = [coarse.speed, middle.speed, fine.speed];
    let doubted = |estimate: Estimate, doubt: f64| Estimate::new(estimate.value, estimate.error + doubt);
    let growth =
        if resting && fine.place == 0.0 { Estimate::exact(0.0) } else { doubted(extrapolated(places, 1.0, irregular), fine.doubts[0]) };
    let speed = if resting { Estimate::exact(0.0) } else { doubted(extrapolated(speeds, 0.0, irregular), fine.doubts[1]) };
    let state = if fine.moving { TipState::Growing } else { TipState::Resting };
    Sample { time, intensity, state, growth: Some(growth.scaled(zone)), speed: Some(speed.scaled(zone)) }
}

/// The events of the finest run; those of the others, in the same order, give the errors.
fn events(runs: &[Run; 3], irregular: f64, zone: f64, until: f64) -> Vec<Event> {
    let mut together = true;
    runs[2]
        .events
        .iter()
        .enumerate()
        .map(|(index, fine)| {
            let others = (runs[0].events.get(index), runs[1].events.get(index));
            let (coarse, middle) = match others {
                (Some(coarse), Some(middle)) if together && coarse.kind == fine.kind && middle.kind == fine.kind => (coarse, middle),
                _ => {
                    together = false;
                    (fine, fine)
                }
            };
            let number = |of: &dyn Fn(&RawEvent) -> f64, scale: f64, range: f64| {
                let estimate = extrapolated([of(coarse), of(middle), of(fine)], scale, irregular);
                // The runs no longer tell the same story: all that is certain is the range.
                if together { estimate } else { Estimate::new(estimate.value, range) }
            };
            let place = fine.place.abs().max(1.0);
            let speed = |side: usize| number(&|event| event.speeds[side], 0.0, fine.speeds[side].abs().max(place / until)).scaled(zone);
            let kind = match fine.kind {
                RawKind::Begins => EventKind::GrowthBegins { speed: speed(1) },
                RawKind::Restarts => EventKind::Restart { speed: speed(1) },
                RawKind::Arrests => EventKind::Arrest { speed_before: speed(0) },
                RawKind::Jumps => EventKind::Jump { distance: number(&|event| event.jump, 1.0, 1.0).scaled(zone) },
                RawKind::Kinks => EventKind::Kink { speed_before: speed(0), speed_after: speed(1) },
                RawKind::Unbounded => EventKind::Unbounded,
            };
            let time = number(&|event| event.time, 0.0, until);
            let growth = number(&|event| event.place, 1.0, place);
            Event { kind, time, growth: Estimate::new(growth.value, growth.error + fine.doubt).scaled(zone) }
        })
        .collect()
}

/// TEMPORARY: raw values of runs.
#[must_use]
pub fn raw_values(problem: &GrowthProblem<'_>, history: &LoadHistory, outputs: &[f64], lines: u32) -> Option<(Vec<(u8, f64, f64, bool, f64, f64)>, Vec<(u8, f64, f64, f64, f64, f64, f64)>, u64)> {
    let until = outputs.last().copied()?;
    let run = run(problem, history, outputs, until, lines, 50_000_000).ok()?;
    let samples = run.samples.iter().map(|s| (u8::from(s.bounded), s.place, s.speed, s.moving, s.doubts[0], s.doubts[1])).collect();
    let events = run.events.iter().map(|e| (e.kind as u8, e.time, e.place, e.speeds[0], e.speeds[1], e.jump, e.doubt)).collect();
    Some((samples, events, run.work.closure_evaluations))
}
