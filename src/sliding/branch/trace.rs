//! Following a branch both ways from its start, with its turns and its states without load.

use super::conditions::{BranchPath, BranchProblem, BranchStart};
use super::equations::BranchEquations;
use super::fold::{Fold, FoldQuantity, located_fold};
use super::point::{BranchPoint, accurate_point, variations_at};
use crate::continuation::arclength::{Curve, CurveEnd, CurvePoint, Quantity, Steps, follow, landed};
use crate::continuation::fold::interpolated;
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{Indenter, Resolution};
use crate::sliding::edge_balance::{EdgeStates, SlidingControl};
use crate::sliding::steady::{
    From, PartialValues, SlidingOutcome, SlidingProblem, SlidingWork, Start, adhesion_at, start_at_rate, steady_sliding,
    steady_sliding_near,
};

/// How the coarse curve is followed. Seven digits at [`Resolution::Medium`].
const STEPS: Steps = Steps { first: 0.03, longest: 0.25, shortest: 1e-5, most: 3000, tolerance: 1e-7, difference: 1e-6 };
/// The resolution of the coarse curve.
const RESOLUTION: Resolution = Resolution::Medium;
/// The half-widths at which the loads of one speed are begun, in this order.
const HALF_WIDTHS: [f64; 10] = [1.2, 0.6, 1.8, 0.3, 2.4, 0.15, 0.08, 0.04, 0.02, 0.01];
/// Accuracy of the contact at which a branch begins.
const START_ACCURACY: f64 = 1e-4;

/// A slope whose smallest value is below this part of its change to the neighbours may have turned in between.
const DIP: f64 = 2.0;
/// Parts of a step where it may have.
const REFINED: f64 = 8.0;

/// 1 − Δ below which a branch is not followed: moved contacts keep it to its last digits, but an ulp of a half-width near π then is 1e-8 of π − a.
const NEAREST_TO_FULL: f64 = 1e-13;
/// Turns that are refused before no more are looked for.
const MOST_UNLOCATED: usize = 12;

/// A point of the coarse curve.
pub(super) type Coarse = CurvePoint<EdgeStates>;

/// How an end of a branch came about.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchEnd {
    /// The narrowest or widest half-width asked for was passed.
    HalfWidth(f64),
    /// The smallest or largest parameter asked for was passed (rate kv in 1/s, Γ, factor of the zones).
    Parameter(f64),
    /// No admissible contact follows; the half-width and parameter of the last one (mean pressure along loads), and the refusal of the next.
    Lost {
        /// a.
        half_width: f64,
        /// The third unknown: p̄, or rate, Γ, factor.
        parameter: f64,
        /// Why.
        reason: Refusal,
    },
    /// So near full contact that a penetration, which moved contacts keep, has too few digits below one; the last half-width.
    NearFull(f64),
    /// The branch is a closed curve, and ends where it begins.
    Closed,
    /// The branch has more points than are followed, 3000 to each side.
    TooLong,
}

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

    /// The coarse curve, to some seven digits: a, e, p̄ (of a held half-width: p̄ in place of the parameter as well) and Δ at each of its points.
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
pub fn trace(material: &Material, problem: &BranchProblem) -> Result<Branch, Refusal> {
    let mut work = BranchWork::default();
    let (curve, begins, ends) = coarse(material, problem, &mut work)?;
    let (folds, unlocated) = folds(material, problem, &curve, &mut work);
    let (points, mut left_out) = kept(material, problem, &curve, &mut work)?;
    let zero_load = zero_load(material, problem, &curve, &mut left_out, &mut work)?;
    Ok(Branch { points, left_out, folds, unlocated, zero_load, begins, ends, work, curve })
}

/// The coarse curve from end to end.
pub(super) fn coarse(
    material: &Material,
    problem: &BranchProblem,
    work: &mut BranchWork,
) -> Result<(Vec<Coarse>, BranchEnd, BranchEnd), Refusal> {
    problem.checked()?;
    let equations = BranchEquations::new(material, problem, RESOLUTION)?;
    let start = start(material, problem, work)?;
    let toward = if problem.path == BranchPath::Loads { Quantity::Unknown(0) } else { Quantity::Unknown(2) };
    let border = |point: &Coarse| border(problem, point);
    let inside = |point: &Coarse| border(point).is_none();
    let mut run = |sign: f64| -> Result<(Vec<Coarse>, BranchEnd), Refusal> {
        let Curve { points, end, evaluations, refused } = follow(&equations, start, toward, sign, &STEPS, &inside)?;
        work.closure_evaluations += evaluations;
        work.refused_steps += refused;
        work.curve_points += points.len() as u64;
        let end = match (end, points.last()) {
            (CurveEnd::Closed, _) => BranchEnd::Closed,
            (CurveEnd::Left, Some(last)) => border(last).unwrap_or(BranchEnd::TooLong),
            (CurveEnd::Lost(reason), Some(last)) => BranchEnd::Lost {
                half_width: last.state.state.contact().half_width,
                parameter: parameter_of(problem, last.unknowns[2]),
                reason,
            },
            _ => BranchEnd::TooLong,
        };
        Ok((points, end))
    };
    let (forward, ends) = run(1.0)?;
    let (backward, begins) = if ends == BranchEnd::Closed { (Vec::new(), BranchEnd::Closed) } else { run(-1.0)? };
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

/// The border of the region asked for that a point has passed.
fn border(problem: &BranchProblem, point: &Coarse) -> Option<BranchEnd> {
    let half_width = point.state.state.contact().half_width;
    let [narrowest, widest] = problem.half_widths;
    if half_width < narrowest {
        return Some(BranchEnd::HalfWidth(narrowest));
    }
    if half_width > widest {
        return Some(BranchEnd::HalfWidth(widest));
    }
    if problem.indenter == Indenter::Wave && point.state.state.mean_separation() < NEAREST_TO_FULL {
        return Some(BranchEnd::NearFull(half_width));
    }
    if problem.path != BranchPath::Loads {
        let [smallest, largest] = problem.parameters;
        let parameter = point.unknowns[2].exp();
        if parameter < smallest * (1.0 - 1e-9) {
            return Some(BranchEnd::Parameter(smallest));
        }
        if parameter > largest * (1.0 + 1e-9) {
            return Some(BranchEnd::Parameter(largest));
        }
    }
    None
}

/// The unknowns at which a branch begins.
fn start(material: &Material, problem: &BranchProblem, work: &mut BranchWork) -> Result<[f64; 3], Refusal> {
    let mut steady = |rate: f64, control: SlidingControl| -> Result<(PartialValues, f64), Refusal> {
        let problem = at_start(problem, rate, control);
        match steady_sliding(material, &problem)? {
            SlidingOutcome::Partial(contact) => {
                work.closure_evaluations += contact.work.closure_evaluations;
                Ok((contact.values, contact.values.half_width.value))
            }
            SlidingOutcome::Full(full) => Err(Refusal::NoSuchState {
                reason: "there is full contact where the branch begins".into(),
                limit_name: full.limit_name,
                limit: full.limit,
            }),
        }
    };
    let placed = |control: SlidingControl, values: &PartialValues, third: f64| match control {
        SlidingControl::HalfWidth(_) => [values.mean_pressure.value, values.eccentricity.value, third],
        _ => [values.half_width.value, values.eccentricity.value, third],
    };
    match (problem.path, problem.start) {
        (BranchPath::Loads, BranchStart::Near { half_width, eccentricity, mean_pressure, .. }) => {
            Ok([half_width, eccentricity, mean_pressure])
        }
        (_, BranchStart::Near { half_width, eccentricity, mean_pressure, parameter }) => Ok(match problem.held() {
            Some(SlidingControl::HalfWidth(_)) => [mean_pressure, eccentricity, parameter.ln()],
            _ => [half_width, eccentricity, parameter.ln()],
        }),
        (BranchPath::Loads, _) => {
            // Which half-widths are reached from the slow or the fast contact at that half-width depends on where the branch turns back.
            let [narrowest, widest] = problem.half_widths;
            let mut widths: Vec<f64> = HALF_WIDTHS.into_iter().filter(|&width| width > narrowest && width < widest).collect();
            if widths.is_empty() {
                widths.push(0.5 * (narrowest + widest));
            }
            let mut first = None;
            let controls = widths.into_iter().map(SlidingControl::HalfWidth).chain([SlidingControl::MeanPressure(0.0)]);
            for control in controls {
                match steady(problem.rate, control) {
                    Ok((values, half_width)) if half_width > narrowest && half_width < widest => {
                        return Ok([half_width, values.eccentricity.value, values.mean_pressure.value]);
                    }
                    Ok(_) => {}
                    Err(refusal) => first = first.or(Some(refusal)),
                }
            }
            Err(first
                .unwrap_or(Refusal::NotConverged { what: "the start of a branch", detail: "no contact within the half-widths".into() }))
        }
        (BranchPath::Speeds(control), from) => {
            let (from, rate) = match from {
                BranchStart::Fast => (From::Fast, problem.parameters[1]),
                _ => (From::Slow, problem.parameters[0]),
            };
            let mut counters = SlidingWork::default();
            let steady = at_start(problem, rate, control);
            let start: Start = start_at_rate(material, &steady, from, &mut counters).map_err(|none| none.refusal())?;
            work.closure_evaluations += counters.closure_evaluations;
            Ok([start.unknowns[0], start.unknowns[1], rate.ln()])
        }
        (BranchPath::Adhesions(control), _) => {
            let (values, _) = steady(problem.rate, control)?;
            Ok(placed(control, &values, problem.adhesion.trailing_work.ln()))
        }
        (BranchPath::Zones(control), _) => {
            let (values, _) = steady(problem.rate, control)?;
            Ok(placed(control, &values, 0.0))
        }
    }
}

/// The contact at which a branch begins, roughly.
fn at_start<'a>(problem: &BranchProblem<'a>, rate: f64, control: SlidingControl) -> SlidingProblem<'a> {
    let &BranchProblem { indenter, work_by_speed, .. } = problem;
    let adhesion = Some(adhesion_at(problem.adhesion, work_by_speed, problem.rate, rate));
    SlidingProblem { rate, indenter, adhesion, work_by_speed, control, accuracy: START_ACCURACY }
}

/// Neighbouring points between which something changes sign.
pub(super) fn changes<'a>(curve: &'a [Coarse], value: impl Fn(&Coarse) -> f64 + 'a) -> impl Iterator<Item = (&'a Coarse, &'a Coarse)> + 'a {
    curve.windows(2).filter_map(move |pair| match pair {
        [from, to] if (value(from) < 0.0) != (value(to) < 0.0) => Some((from, to)),
        _ => None,
    })
}

type Turns = (Vec<Fold>, Vec<(FoldQuantity, f64, Refusal)>);

fn folds(material: &Material, problem: &BranchProblem, curve: &[Coarse], work: &mut BranchWork) -> Turns {
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
    material: &Material,
    problem: &BranchProblem,
    curve: &[Coarse],
    left_out: &mut Vec<(f64, Refusal)>,
    work: &mut BranchWork,
) -> Result<Vec<BranchPoint>, Refusal> {
    if problem.path != BranchPath::Loads {
        return Ok(Vec::new());
    }
    let equations = BranchEquations::new(material, problem, RESOLUTION)?;
    let mut found = Vec::new();
    for (from, to) in changes(curve, |point| point.unknowns[2]) {
        let mut at = || -> Result<BranchPoint, Refusal> {
            let (unknowns, _, evaluations) = landed(&equations, (from, to), Quantity::Unknown(2), 0.0, STEPS.tolerance)?;
            work.closure_evaluations += evaluations;
            let steady = problem.steady(0.0, SlidingControl::MeanPressure(0.0));
            let contact = steady_sliding_near(material, &steady, &Start::at(unknowns[0], unknowns[1]))?;
            work.closure_evaluations += contact.work.closure_evaluations;
            let part = (0.0 - from.unknowns[2]) / (to.unknowns[2] - from.unknowns[2]);
            let arclength = from.arclength + part * (to.arclength - from.arclength);
            let variations = variations_at(material, problem, 0.0, &contact.values, Resolution::Fine, work)?;
            Ok(BranchPoint { arclength, parameter: Estimate::exact(0.0), values: contact.values, variations })
        };
        match at() {
            Ok(values) => found.push(values),
            Err(refusal) => left_out.push((from.arclength, refusal)),
        }
    }
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
                work.closure_evaluations += found.evaluations;
                between = found.points.into_iter().skip(1).filter(|point| inside(point)).collect();
                for point in &mut between {
                    point.arclength += from.arclength;
                }
            }
        }
        work.curve_points += between.len() as u64;
        after.push(between);
    }
    let mut after = after.into_iter();
    for point in curve {
        all.push(point);
        all.extend(after.next().unwrap_or_default());
    }
    all
}

type Kept = (Vec<BranchPoint>, Vec<(f64, Refusal)>);

/// The points that are kept, evenly spaced.
fn kept(material: &Material, problem: &BranchProblem, curve: &[Coarse], work: &mut BranchWork) -> Result<Kept, Refusal> {
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else { return Ok((Vec::new(), Vec::new())) };
    let (mut points, mut left_out) = (Vec::new(), Vec::new());
    let fine = BranchEquations::new(material, problem, Resolution::Fine)?;
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
        match accurate_point(material, problem, &fine, (from, to), part, near, work) {
            Ok(point) => points.push(BranchPoint { arclength, ..point }),
            Err(refusal) => left_out.push((arclength, refusal)),
        }
    }
    Ok((points, left_out))
}
