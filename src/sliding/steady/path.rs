//! A contact at any speed, reached from the slow or from the fast one, whose forms are known.
//!
//! Far below the process zone over the longest time the solid is relaxed, far above the contact over the shortest it is glassy; both contacts
//! are elastic. From there the speed is changed in steps, each contact being the start of the next (with secant prediction in ln speed). A step
//! whose contact is far from its prediction is a jump to another root: it is refused and halved, not accepted. Paths are followed coarsely; only
//! the contact at their end is solved to the accuracy asked for.

use super::elastic_start::elastic_unknowns;
use super::problem::SlidingProblem;
use super::solution::SlidingWork;
use super::uneven_start::mean_work;
use crate::continuation::two_unknowns::Jacobian;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Resolution};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use std::sync::Arc;

/// The longest step in ln speed.
const LONGEST_STEP: f64 = 1.5;
/// The step that is tried first.
const FIRST_STEP: f64 = 0.5;
/// A path whose steps fall below this has met a fold.
const SHORTEST_STEP: f64 = 1e-3;
/// The slow start: slowest sliding ratio over the smaller process zone.
const SLOW: f64 = 0.1;
/// The fast start: fastest sliding ratio over the contact, by the relaxation times.
const FAST: f64 = 30.0;
/// Largest distance of a contact from its prediction, in units of the room of its unknowns. Just past a turn of the half-width a secant points at a second, wider contact
/// (β = 100, Γ = 0.0015, ζ = 0.5), which lay 0.14 of the room from such a prediction; the right contacts of accepted steps lie within 0.08.
const JUMP: f64 = 0.08;
/// Steps of a path by loads, at least, and the shortest one over the load.
const FEWEST_LOADS: f64 = 6.0;
/// See [`FEWEST_LOADS`].
const SHORTEST_LOAD: f64 = 1e-4;
/// Residual of the contacts on the way.
const TOLERANCE: f64 = 1e-4;

/// A contact from which one like it is found in a few steps: both unknowns, and how the edge conditions follow them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    pub(in crate::sliding) unknowns: [f64; 2],
    pub(in crate::sliding) jacobian: Option<Jacobian>,
}

impl Start {
    /// At given edges; at a prescribed half-width `first` is the mean pressure.
    #[must_use]
    pub const fn at(first: f64, eccentricity: f64) -> Self {
        Self { unknowns: [first, eccentricity], jacobian: None }
    }
}

/// A path that does not reach its end.
#[derive(Debug, Clone)]
pub(in crate::sliding) struct PathEnd {
    /// The last rate, or load, reached.
    pub(in crate::sliding) last: f64,
    /// Whether the contact was widening there.
    pub(in crate::sliding) widening: bool,
}

/// Why there is no start.
#[derive(Debug, Clone)]
pub(in crate::sliding) enum NoStart {
    /// The elastic contact does not exist, or a number is wrong.
    Elastic(Refusal),
    /// A fold was met.
    Fold(PathEnd),
}

impl NoStart {
    /// As a refusal.
    pub(in crate::sliding) fn refusal(self) -> Refusal {
        match self {
            Self::Elastic(refusal) => refusal,
            Self::Fold(PathEnd { last, .. }) => Refusal::NoSuchState {
                reason: "the path from the slow or the fast contact ends at a fold before this speed".into(),
                limit_name: "rate kv (1/s)",
                limit: last,
            },
        }
    }
}

/// From which side the speed is approached.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::sliding) enum From {
    Slow,
    Fast,
}

/// Follows the contact of a material to the rate of the problem; adds to `work`.
pub(in crate::sliding) fn start_at_rate(
    material: &Material,
    problem: &SlidingProblem<'_>,
    from: From,
    work: &mut SlidingWork,
) -> Result<Start, NoStart> {
    let modulus = match from {
        From::Slow => 1.0,
        From::Fast => material.stiffening_ratio(),
    };
    let elastic = |rate: f64| -> Result<Start, NoStart> {
        let unknowns = elastic_unknowns(problem, problem.adhesion_at(rate), modulus).map_err(NoStart::Elastic)?;
        Ok(Start { unknowns, jacobian: None })
    };
    let at_rest = elastic(problem.rate)?;
    let (Some(longest), Some(shortest)) =
        (material.longest_retardation_time(), material.relaxation_terms().iter().map(|term| term.relaxation_time).min_by(f64::total_cmp))
    else {
        return settled(material, problem, problem.rate, modulus, at_rest, work);
    };
    if problem.rate == 0.0 {
        return settled(material, problem, problem.rate, modulus, at_rest, work);
    }
    let half_width = match problem.control {
        SlidingControl::HalfWidth(half_width) => half_width,
        _ => at_rest.unknowns[0],
    };
    let zone = problem.adhesion.map_or(0.1 * half_width, |adhesion| adhesion.trailing_zone.min(adhesion.leading_zone));
    let begin = match from {
        From::Slow => (SLOW * zone / longest).min(problem.rate),
        From::Fast => (FAST * half_width / shortest).max(problem.rate),
    };
    let balance_at = |log_rate: f64| {
        let memory = Arc::new(ContactMemory::new(material, log_rate.exp())?);
        Ok(EdgeBalance::new(memory, problem.indenter, problem.adhesion_at(log_rate.exp()), problem.control, Resolution::Coarse))
    };
    // The elastic contact has the works of the speed at which the path begins.
    let at_rest = if problem.work_by_speed.is_some() { elastic(begin)? } else { at_rest };
    let at_rest = settled(material, problem, begin, modulus, at_rest, work)?;
    let range = Range { begin: begin.ln(), end: problem.rate.ln(), first: FIRST_STEP, longest: LONGEST_STEP, shortest: SHORTEST_STEP };
    follow(balance_at, at_rest, range, work).map_err(|none| match none {
        NoStart::Fold(end) => NoStart::Fold(PathEnd { last: end.last.exp(), ..end }),
        elastic => elastic,
    })
}

/// Whether the elastic contact at the slow or the fast end of all speeds bears what is prescribed; in closed form.
pub(in crate::sliding) fn end_bears(material: &Material, problem: &SlidingProblem<'_>, from: From) -> bool {
    let modulus = match from {
        From::Slow => 1.0,
        From::Fast => material.stiffening_ratio(),
    };
    elastic_unknowns(problem, problem.adhesion_at(problem.rate), modulus).is_ok()
}

/// The contact at a rate near an elastic one: itself where both edges take the same work. A process zone of any length moves a contact of uneven works far from
/// its limit for short ones, the more the smaller the lesser work is; where Newton's method does not get there, the works are taken apart bit by bit.
fn settled(
    material: &Material,
    problem: &SlidingProblem<'_>,
    rate: f64,
    modulus: f64,
    start: Start,
    work: &mut SlidingWork,
) -> Result<Start, NoStart> {
    let Some(adhesion) = problem.adhesion_at(rate).filter(|adhesion| !adhesion.is_even()) else { return Ok(start) };
    let memory = Arc::new(ContactMemory::new(material, rate).map_err(NoStart::Elastic)?);
    let apart = |part: f64| {
        let mean = mean_work(adhesion);
        let of = |edge: f64| mean * (edge / mean).powf(part);
        WaveAdhesion { trailing_work: of(adhesion.trailing_work), leading_work: of(adhesion.leading_work), ..adhesion }
    };
    let balance_at =
        |part: f64| Ok(EdgeBalance::new(Arc::clone(&memory), problem.indenter, Some(apart(part)), problem.control, Resolution::Coarse));
    let range = |begin: f64| Range { begin, end: 1.0, first: 0.25, longest: 0.5, shortest: SHORTEST_STEP };
    // Without a step this is one solution.
    if let Ok(found) = follow(balance_at, start, range(1.0), work) {
        return Ok(found);
    }
    let even = elastic_unknowns(problem, Some(apart(0.0)), modulus).map_err(NoStart::Elastic)?;
    follow(balance_at, Start { unknowns: even, jacobian: None }, range(0.0), work).map_err(|_| {
        NoStart::Elastic(Refusal::NotConverged {
            what: "the edges of a sliding contact with uneven works",
            detail: "no contact with both edges pulled was found near the elastic one; the lesser work may be too small for the length of its process zone".into(),
        })
    })
}

/// Reaches a pull by which neither end of the speed range is held: at no load first, then by loads falling at the rate of the problem.
///
/// An edge that moves at the right speed resists pulls that neither the relaxed nor the glassy contact could.
pub(super) fn start_by_pulling(material: &Material, problem: &SlidingProblem<'_>, work: &mut SlidingWork) -> Result<Start, NoStart> {
    let unloaded = SlidingProblem { control: SlidingControl::MeanPressure(0.0), ..*problem };
    let SlidingControl::MeanPressure(target) = problem.control else {
        return Err(NoStart::Fold(PathEnd { last: problem.rate, widening: false }));
    };
    let start = match start_at_rate(material, &unloaded, From::Slow, work) {
        Ok(start) => start,
        Err(_) => start_at_rate(material, &unloaded, From::Fast, work)?,
    };
    let memory = Arc::new(ContactMemory::new(material, problem.rate).map_err(NoStart::Elastic)?);
    let balance_at = |pressure: f64| {
        let control = SlidingControl::MeanPressure(pressure);
        Ok(EdgeBalance::new(Arc::clone(&memory), problem.indenter, problem.adhesion, control, Resolution::Coarse))
    };
    let longest = target.abs() / FEWEST_LOADS;
    follow(balance_at, start, Range { begin: 0.0, end: target, first: longest, longest, shortest: SHORTEST_LOAD * target.abs() }, work)
}

/// A path parameter: logarithm of the rate, or load.
struct Range {
    begin: f64,
    end: f64,
    first: f64,
    longest: f64,
    shortest: f64,
}

/// Follows the contact as the parameter goes from the beginning to the end of its range.
fn follow(
    balance_at: impl Fn(f64) -> Result<EdgeBalance, Refusal>,
    start: Start,
    range: Range,
    work: &mut SlidingWork,
) -> Result<Start, NoStart> {
    let mut at = |parameter: f64, start: &Start| -> Result<(Start, EdgeBalance), Refusal> {
        let balance = balance_at(parameter)?;
        let found = balance.solve(start.unknowns, start.jacobian, TOLERANCE);
        let evaluations = balance.take_evaluations();
        work.closure_evaluations += evaluations;
        work.contacts += balance.contacts_per_evaluation() * evaluations;
        let found = found?;
        Ok((Start { unknowns: found.unknowns, jacobian: found.jacobian }, balance))
    };
    let mut parameter = range.begin;
    let direction = (range.end - parameter).signum();
    let (mut here, _) = at(parameter, &start).map_err(|_| NoStart::Fold(PathEnd { last: parameter, widening: false }))?;
    let mut steps = 1;
    let mut before: Option<(f64, Start)> = None;
    let mut step = range.first;
    while direction * (range.end - parameter) > 0.0 {
        let next = if (range.end - parameter).abs() <= step { range.end } else { parameter + direction * step };
        let predicted = before.map_or(here, |(then, there)| {
            let part = (next - parameter) / (parameter - then);
            let along = |index: usize| here.unknowns[index] + part * (here.unknowns[index] - there.unknowns[index]);
            Start { unknowns: [along(0), along(1)], jacobian: here.jacobian }
        });
        let accepted = at(next, &predicted).ok().filter(|(found, balance)| {
            let room = balance.room(here.unknowns);
            (0..2).all(|index| (found.unknowns[index] - predicted.unknowns[index]).abs() < JUMP * room[index])
        });
        if let Some((found, _)) = accepted {
            before = Some((parameter, here));
            (parameter, here) = (next, found);
            steps += 1;
            step = (1.5 * step).min(range.longest);
        } else {
            step *= 0.5;
            if step < range.shortest {
                let widening = before.is_some_and(|(_, there)| here.unknowns[0] > there.unknowns[0]);
                return Err(NoStart::Fold(PathEnd { last: parameter, widening }));
            }
        }
    }
    work.path_steps += steps;
    Ok(here)
}
