//! Following a branch both ways from its start, with its turns and its states without load.

use super::conditions::{BranchPath, BranchProblem};
use super::end::{BranchEnd, border, impossible};
use super::equations::BranchEquations;
use super::fold::{Fold, FoldQuantity, LOOSE, Turn, located_fold};
use super::point::{BranchPoint, VARIATIONS, accurate_point, variations_at};
use super::start::start;
use crate::continuation::arclength::{Curve, CurveEnd, Steps, follow, landed};
use crate::continuation::curve::{CurveEquations, CurvePoint, Quantity};
use crate::continuation::fold::{interpolated, part_at};
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::Resolution;
use crate::sliding::edge_balance::{EdgeStates, SlidingControl};
use crate::sliding::steady::{PartialContact, Prepared, SlidingProblem, SlidingWork, Start, near_counted};
use std::cell::Cell;

/// How the coarse curve is followed. Seven digits at [`Resolution::Medium`].
const STEPS: Steps = Steps { first: 0.03, longest: 0.25, shortest: 1e-5, most: 3000, tolerance: 1e-7 };
/// The same on the way to turns that few digits are asked of.
const LOOSE_STEPS: Steps = Steps { tolerance: 1e-5, ..STEPS };
/// The resolution of the coarse curve.
const RESOLUTION: Resolution = Resolution::Medium;
/// A slope whose smallest value is below this part of its change to the neighbours may have turned in between.
const DIP: f64 = 2.0;
/// Parts of a step where it may have.
const REFINED: f64 = 8.0;

/// Arclengths beyond the last point at which it is looked for what forbids the next.
const PREDICTED: [f64; 3] = [1e-5, 1e-4, 1e-3];
/// Turns that are refused before no more are looked for.
const MOST_UNLOCATED: usize = 12;

/// A point of the coarse curve.
pub(super) type Coarse = CurvePoint<EdgeStates>;

/// Work counters of a branch.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct BranchWork {
    /// Points of the coarse curve.
    pub curve_points: u64,
    /// Steps of the curve that were refused and halved.
    pub refused_steps: u64,
    /// Evaluations of both edge conditions, each three contacts.
    pub closure_evaluations: u64,
}

/// A branch of steady contacts.
#[derive(Debug, Clone)]
pub struct Branch {
    /// The kept points in order: along loads from narrow to wide, along parameters as they come, from the backward end to the forward one.
    pub points: Vec<BranchPoint>,
    /// Points, also those without load, that were asked for and refused: arclength and reason.
    pub left_out: Vec<(f64, Refusal)>,
    /// Turns, in order along the curve.
    pub folds: Vec<Fold>,
    /// Turns of the coarse curve that were not solved, at most twelve: what, arclength and reason.
    pub unlocated: Vec<(FoldQuantity, f64, Refusal)>,
    /// Contacts without load, in order along the curve of loads; none along other paths.
    pub zero_load: Vec<BranchPoint>,
    /// How the branch ends behind its first point.
    pub begins: BranchEnd,
    /// How it ends after its last point.
    pub ends: BranchEnd,
    /// What it took.
    pub work: BranchWork,
    pub(super) curve: Vec<Coarse>,
}

impl Branch {
    /// The turns of one quantity.
    pub fn folds_of(&self, quantity: FoldQuantity) -> impl Iterator<Item = &Fold> {
        self.folds.iter().filter(move |fold| fold.quantity == quantity)
    }

    /// The coarse curve, to some seven digits: a, e, p̄ (of a held half-width: p̄ in place of the parasame sums) and Δ at each of its points.
    #[must_use]
    pub fn outline(&self) -> Vec<[f64; 4]> {
        self.curve
            .iter()
            .map(|point| {
                let state = &point.state.state;
                [state.contact().half_width, state.contact().eccentricity, state.mean_pressure(), state.penetration()]
            })
            .collect()
    }

    /// The third unknown along the coarse curve: p̄, or rate kv in 1/s, Γ, factor of the zones.
    #[must_use]
    pub fn outline_parameters(&self, problem: &BranchProblem) -> Vec<f64> {
        self.curve.iter().map(|point| parameter_of(problem, point.unknowns[2])).collect()
    }
}

/// What the third unknown stands for.
pub(super) fn parameter_of(problem: &BranchProblem, third: f64) -> f64 {
    if problem.path == BranchPath::Loads { third } else { third.exp() }
}

/// The branch of a problem.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem; [`Refusal::NoSuchState`] if there is no contact where it begins;
/// [`Refusal::NotConverged`] if no admissible one is found there.
pub fn trace(material: &PlaneMaterial, problem: &BranchProblem) -> Result<Branch, Refusal> {
    let mut work = BranchWork::default();
    let (curve, begins, ends) = coarse(material, problem, false, &mut work)?;
    let (folds, unlocated) = folds(material, problem, &curve, &mut work);
    let (points, mut left_out) = kept(material, problem, &curve, &mut work)?;
    let zero_load = zero_load(material, problem, &curve, &mut left_out, &mut work)?;
    Ok(Branch { points, left_out, folds, unlocated, zero_load, begins, ends, work, curve })
}

/// The branch of loads as far as snap-in, with pull-off, snap-in and separation alone among its turns and no kept points; none if one of them was not found, so that the
/// whole branch has to tell why.
///
/// # Errors
/// Those of [`trace`].
pub(super) fn as_far_as_snap_in(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    work: &mut BranchWork,
) -> Result<Option<Branch>, Refusal> {
    let (curve, begins, ends) = coarse(material, problem, true, work)?;
    let Some(mut folds) = bearing(material, problem, &curve, work) else { return Ok(None) };
    folds.sort_by(|first, second| first.arclength.total_cmp(&second.arclength));
    let mut left_out = Vec::new();
    let zero_load = zero_load(material, problem, &curve, &mut left_out, work)?;
    Ok(Some(Branch { points: Vec::new(), left_out, folds, unlocated: Vec::new(), zero_load, begins, ends, work: *work, curve }))
}

/// Snap-in, pull-off and separation of a coarse curve of loads: the first largest load, the last smallest one before it, the first smallest penetration.
fn bearing(material: &PlaneMaterial, problem: &BranchProblem, curve: &[Coarse], work: &mut BranchWork) -> Option<Vec<Fold>> {
    let mut located = |quantity: FoldQuantity, turn: Turn, before: f64, last: bool| -> Option<Fold> {
        let unknown = quantity.unknown();
        let turns = changes(curve, move |point| point.slope(unknown)).filter(|(from, to)| {
            let minimum = from.slope(unknown) < 0.0;
            minimum == (turn == Turn::Minimum)
                && from.arclength < before
                && border(problem, from).is_none()
                && border(problem, to).is_none()
        });
        let mut turns: Vec<_> = turns.collect();
        if last {
            turns.reverse();
        }
        let (from, to) = *turns.first()?;
        located_fold(material, problem, quantity, from, to, work).ok()
    };
    let snap_in = located(FoldQuantity::MeanPressure, Turn::Maximum, f64::INFINITY, false)?;
    let pull_off = located(FoldQuantity::MeanPressure, Turn::Minimum, snap_in.arclength, true)?;
    let separation = located(FoldQuantity::Penetration, Turn::Minimum, f64::INFINITY, false)?;
    Some(vec![separation, pull_off, snap_in])
}

/// The coarse curve from end to end, or forward only to the first point but one past a largest load.
pub(super) fn coarse(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    to_snap_in: bool,
    work: &mut BranchWork,
) -> Result<(Vec<Coarse>, BranchEnd, BranchEnd), Refusal> {
    problem.checked()?;
    let equations = BranchEquations::new(material, problem, RESOLUTION)?;
    let start = start(material, problem, work)?;
    let toward = if problem.path == BranchPath::Loads { Quantity::Unknown(0) } else { Quantity::Unknown(2) };
    let border = |point: &Coarse| border(problem, point);
    let steps = if to_snap_in && problem.accuracy >= LOOSE { LOOSE_STEPS } else { STEPS };
    let mut run = |sign: f64| -> Result<(Vec<Coarse>, BranchEnd), Refusal> {
        let (before, turned) = (Cell::new(f64::NAN), Cell::new(false));
        let inside = |point: &Coarse| {
            let slope = point.slope(Quantity::Unknown(2));
            let turned_before = turned.get();
            turned.set(turned_before || (before.replace(slope) > 0.0 && slope < 0.0));
            border(point).is_none() && !(to_snap_in && sign > 0.0 && turned_before)
        };
        let Curve { points, end, refused } = follow(&equations, start, toward, sign, &steps, &inside)?;
        work.refused_steps += refused;
        work.curve_points += points.len() as u64;
        let Some(last) = points.last() else { return Ok((points, BranchEnd::TooLong)) };
        let (half_width, parameter) = (last.state.state.contact().half_width, parameter_of(problem, last.unknowns[2]));
        let end = match end {
            CurveEnd::Closed => BranchEnd::Closed,
            CurveEnd::Left => border(last).unwrap_or(BranchEnd::TooLong),
            CurveEnd::MostPoints => BranchEnd::TooLong,
            // An amplitude that changes its sign makes the residual jump: no root follows, but the contact predicted tells.
            CurveEnd::Lost(reason) => match PREDICTED.into_iter().find_map(|step| {
                let next =
                    equations.evaluate(std::array::from_fn(|index| last.unknowns[index] + step * last.tangent[index] * last.scales[index]));
                impossible(equations.prepared(), &last.state, &next.ok()?.state)
            }) {
                Some(witness) => BranchEnd::Impossible { half_width, parameter, witness },
                None => BranchEnd::Lost { half_width, parameter, reason },
            },
            CurveEnd::Inadmissible(next) => match impossible(equations.prepared(), &last.state, &next) {
                Some(witness) => BranchEnd::Impossible { half_width, parameter, witness },
                None => {
                    let reason =
                        Refusal::NotConverged { what: "a point of a branch", detail: "only another, unphysical root is near".into() };
                    BranchEnd::Lost { half_width, parameter, reason }
                }
            },
        };
        Ok((points, end))
    };
    let both = run(1.0).and_then(|(forward, ends)| {
        let (backward, begins) = if ends == BranchEnd::Closed { (Vec::new(), BranchEnd::Closed) } else { run(-1.0)? };
        Ok((forward, ends, backward, begins))
    });
    work.closure_evaluations += equations.evaluations();
    let (forward, ends, backward, begins) = both?;
    let mut curve: Vec<Coarse> = backward
        .into_iter()
        .skip(1)
        .rev()
        .map(|mut point| {
            point.arclength = -point.arclength;
            point.tangent = point.tangent.map(|part| -part);
            point
        })
        .collect();
    curve.extend(forward);
    let curve = refined(&equations, problem, curve, work);
    Ok((curve, begins, ends))
}

/// Neighbouring points between which something changes sign.
pub(super) fn changes<'a>(curve: &'a [Coarse], value: impl Fn(&Coarse) -> f64 + 'a) -> impl Iterator<Item = (&'a Coarse, &'a Coarse)> + 'a {
    curve.windows(2).filter_map(move |pair| match pair {
        [from, to] if (value(from) < 0.0) != (value(to) < 0.0) => Some((from, to)),
        _ => None,
    })
}

/// The contact of a problem near a start, with its work counted whether there is one or not.
pub(super) fn near(prepared: &Prepared, problem: &SlidingProblem, start: &Start, work: &mut BranchWork) -> Result<PartialContact, Refusal> {
    let mut counters = SlidingWork::default();
    let found = near_counted(prepared, problem, start, &mut counters);
    work.closure_evaluations += counters.closure_evaluations;
    found
}

type Turns = (Vec<Fold>, Vec<(FoldQuantity, f64, Refusal)>);

fn folds(material: &PlaneMaterial, problem: &BranchProblem, curve: &[Coarse], work: &mut BranchWork) -> Turns {
    let (mut folds, mut unlocated) = (Vec::new(), Vec::new());
    for &quantity in FoldQuantity::of(problem) {
        let unknown = quantity.unknown();
        for (from, to) in changes(curve, move |point| point.slope(unknown)) {
            if unlocated.len() >= MOST_UNLOCATED {
                break;
            }
            // The last point of the curve is beyond the region asked for.
            if [from, to].iter().any(|point| border(problem, point).is_some()) {
                continue;
            }
            match located_fold(material, problem, quantity, from, to, work) {
                Ok(fold) => folds.push(fold),
                Err(refusal) => unlocated.push((quantity, from.arclength, refusal)),
            }
        }
    }
    folds.sort_by(|first, second| first.arclength.total_cmp(&second.arclength));
    (folds, unlocated)
}

fn zero_load(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    curve: &[Coarse],
    left_out: &mut Vec<(f64, Refusal)>,
    work: &mut BranchWork,
) -> Result<Vec<BranchPoint>, Refusal> {
    if problem.path != BranchPath::Loads {
        return Ok(Vec::new());
    }
    let equations = BranchEquations::new(material, problem, RESOLUTION)?;
    let prepared = problem.prepared(material, 0.0)?;
    let mut found = Vec::new();
    for (from, to) in changes(curve, |point| point.unknowns[2]) {
        let mut at = || -> Result<BranchPoint, Refusal> {
            let (unknowns, _) = landed(&equations, (from, to), Quantity::Unknown(2), 0.0, STEPS.tolerance)?;
            let steady = problem.steady(0.0, SlidingControl::MeanPressure(0.0));
            let start = Start::at(equations.edges(unknowns).half_width, unknowns[1]);
            let contact = near(&prepared, &steady, &start, work)?;
            let arclength = from.arclength + part_at(from, to, 0, unknowns[0]) * (to.arclength - from.arclength);
            let variations = variations_at(&prepared, problem, &contact.values, VARIATIONS, work)?;
            Ok(BranchPoint { arclength, parameter: Estimate::exact(0.0), values: contact.values, variations })
        };
        match at() {
            Ok(values) => found.push(values),
            Err(refusal) => left_out.push((from.arclength, refusal)),
        }
    }
    work.closure_evaluations += equations.evaluations();
    Ok(found)
}

/// Adds points where a slope comes near zero and goes back, so that two turns within a step are not missed.
fn refined(equations: &BranchEquations<'_>, problem: &BranchProblem, curve: Vec<Coarse>, work: &mut BranchWork) -> Vec<Coarse> {
    let near_turn = |first: &Coarse, middle: &Coarse, last: &Coarse| {
        FoldQuantity::of(problem).iter().any(|quantity| {
            let [first, middle, last] = [first, middle, last].map(|point| point.slope(quantity.unknown()));
            let same = first * middle > 0.0 && middle * last > 0.0;
            same && middle.abs() < first.abs().min(last.abs()) && middle.abs() < DIP * (first - middle).abs().max((last - middle).abs())
        })
    };
    let dips: Vec<bool> =
        curve.windows(3).map(|triple| if let [first, middle, last] = triple { near_turn(first, middle, last) } else { false }).collect();
    // The dip may be on either side of the middle point.
    let split =
        |segment: usize| dips.get(segment).copied().unwrap_or(false) || (segment > 0 && dips.get(segment - 1).copied().unwrap_or(false));
    let before = equations.evaluations();
    let mut all = Vec::with_capacity(curve.len());
    let mut after: Vec<Vec<Coarse>> = Vec::with_capacity(curve.len());
    for (segment, pair) in curve.windows(2).enumerate() {
        let mut between = Vec::new();
        if let ([from, to], true) = (pair, split(segment)) {
            let span = to.arclength - from.arclength;
            let steps = Steps { first: span / REFINED, longest: span / REFINED, ..STEPS };
            let along = (0..3).max_by(|&one, &two| from.tangent[one].abs().total_cmp(&from.tangent[two].abs())).unwrap_or(0);
            let inside = |point: &Coarse| point.arclength < 0.999 * span;
            let found = follow(equations, from.unknowns, Quantity::Unknown(along), from.tangent[along].signum(), &steps, &inside);
            if let Ok(found) = found {
                between = found.points.into_iter().skip(1).filter(|point| inside(point)).collect();
                for point in &mut between {
                    point.arclength += from.arclength;
                }
            }
        }
        work.curve_points += between.len() as u64;
        after.push(between);
    }
    work.closure_evaluations += equations.evaluations() - before;
    let mut after = after.into_iter();
    for point in curve {
        all.push(point);
        all.extend(after.next().unwrap_or_default());
    }
    all
}

type Kept = (Vec<BranchPoint>, Vec<(f64, Refusal)>);

/// The points that are kept, evenly spaced.
fn kept(material: &PlaneMaterial, problem: &BranchProblem, curve: &[Coarse], work: &mut BranchWork) -> Result<Kept, Refusal> {
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else { return Ok((Vec::new(), Vec::new())) };
    let (mut points, mut left_out) = (Vec::new(), Vec::new());
    let fine = BranchEquations::new(material, problem, Resolution::Fine)?;
    // Along loads every contact has one speed and adhesion.
    let prepared = (problem.path == BranchPath::Loads).then(|| problem.prepared(material, 0.0)).transpose()?;
    let mut jacobian = None;
    let mut segment = 0;
    for index in 0..problem.points {
        // The first and the last point of the curve may be outside the region: not quite to the ends.
        let part = (index as f64 + 0.5) / problem.points as f64;
        let arclength = first.arclength + part * (last.arclength - first.arclength);
        while curve.get(segment + 2).is_some() && curve.get(segment + 1).is_some_and(|point| point.arclength < arclength) {
            segment += 1;
        }
        let (Some(from), Some(to)) = (curve.get(segment), curve.get(segment + 1)) else { continue };
        let part = ((arclength - from.arclength) / (to.arclength - from.arclength)).clamp(0.0, 1.0);
        let near = interpolated(from, to, part);
        match accurate_point((material, problem, prepared.as_ref()), &fine, (from, to), (part, near), &mut jacobian, work) {
            Ok(point) => points.push(BranchPoint { arclength, ..point }),
            Err(refusal) => left_out.push((arclength, refusal)),
        }
    }
    work.closure_evaluations += fine.evaluations();
    Ok((points, left_out))
}
