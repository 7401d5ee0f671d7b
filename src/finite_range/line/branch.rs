//! A branch of steady states followed through its folds, by pseudo-arclength in mean gap and mean pressure.
//!
//! A fold in the pressure is where contact is lost (or jumps to full contact) under a dead load; a fold in the gap is where it snaps
//! under an imposed gap. Both are read off the branch and then located on three grids ([`super::fold`]).

use super::bounds;
use super::fold::{Fold, locate};
use super::grid::{Equations, State};
use super::newton;
use super::problem::{Control, Problem};
use super::reach::{self, Place};
use super::solution::{self, Certificate, Numbers};
use super::stability::{OnGrid, StateStability};
use super::steady::Request;
use crate::refusal::{Refusal, require_positive};

/// Longest and shortest step (gap over half height and pressure over the stiffness of one wave, together).
const LONGEST: f64 = 0.08;
const SHORTEST: f64 = 2e-4;
/// Newton steps after which the next arc step is not made longer.
const EASY: usize = 8;
/// Largest change of the contact fraction in one step: near full contact a jump hardly changes gap and pressure.
const SPREAD: f64 = 0.1;
/// Least cosine between two successive steps of one branch.
const STRAIGHT: f64 = 0.7;

/// Nodes along x at least, and states at most, on the way to the fold of a pulled contact; the small load at which it may start, over half of the height.
const PULL_OFF_NODES: usize = 1024;
const PULL_OFF_POINTS: usize = 200;
const LIGHT: f64 = 0.1;

/// The way along the branch from the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Towards larger pressure at first.
    Loading,
    /// Towards smaller pressure at first.
    Unloading,
}

/// Why a trace ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// The contact has covered everything.
    FullContact,
    /// Nothing touches (laws with a wall: no node in contact) and the gap exceeds the highest point by ten ranges.
    Separated,
    /// The branch has the number of points that was asked for.
    Points,
    /// The step became too short; the sentence says where.
    Lost(String),
}

/// What turns at a fold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoldKind {
    /// Least mean pressure: pull-off under a dead load.
    LeastPressure,
    /// Largest mean pressure of a partial contact.
    LargestPressure,
    /// Largest mean gap: separation under an imposed gap.
    LargestGap,
    /// Least mean gap: snap-in under an imposed gap.
    LeastGap,
}

/// A turning point between two points of the branch, and a state near it.
#[derive(Debug, Clone)]
pub struct RoughFold {
    /// What turns.
    pub kind: FoldKind,
    /// The numbers at the nearest point of the branch; they carry no error bound.
    pub point: Numbers,
    pub(super) state: State,
    /// Nodes along x of that state.
    pub nodes: usize,
    /// Steps in gap and pressure next to the point.
    pub(super) spacing: [f64; 2],
}

/// A branch on one grid.
#[derive(Debug, Clone)]
pub struct Branch {
    /// Nodes along x at the end (a small contact makes the grid finer on the way).
    pub nodes: usize,
    /// The states in order.
    pub points: Vec<Numbers>,
    /// The same on grids twice and four times as fine, with their errors, if asked for; none where the finer grids lose a state.
    pub refined: Vec<Option<Refined>>,
    /// Where gap or pressure turn.
    pub folds: Vec<RoughFold>,
    /// Why it ended.
    pub end: End,
}

/// A state of a branch on the finest of three grids.
#[derive(Debug, Clone)]
pub struct Refined {
    /// The numbers.
    pub numbers: Numbers,
    /// The error bound of each number (same units), from the differences between grids.
    pub errors: Numbers,
    /// Patches of contact.
    pub patches: usize,
    /// By how many they changed from the grid before.
    pub patches_error: usize,
    /// The certificate on the finest grid.
    pub certificate: Certificate,
    /// Nodes along x of the finest grid.
    pub nodes: usize,
    /// Products, each times the nodes of its grid.
    pub node_products: usize,
    /// Whether it stays where it is, on the two coarser grids.
    pub stability: StateStability,
}

/// Follows the branch of the cold-started state of `problem` on `nodes` nodes along x, for at most `points` states.
///
/// # Errors
/// As [`Problem::check`]; [`Refusal::NotConverged`] where the start cannot be reached; [`Refusal::OutOfRange`] for no points.
pub fn trace(problem: &Problem, nodes: usize, direction: Direction, points: usize) -> Result<Branch, Refusal> {
    trace_with(problem, nodes, direction, points, false)
}

/// As [`trace`], with each state also on two grids twice and four times as fine.
///
/// # Errors
/// As [`trace`].
pub fn trace_refined(problem: &Problem, nodes: usize, direction: Direction, points: usize) -> Result<Branch, Refusal> {
    trace_with(problem, nodes, direction, points, true)
}

/// The fold at which a contact parts under a falling mean pressure: of the state to which a long range of the law leads at no load, or at a small one.
///
/// # Errors
/// [`Refusal`] for a problem without meaning, and where no fold is found on the way down.
pub fn pull_off(problem: &Problem, request: &Request) -> Result<Fold, Refusal> {
    let largest = request.most_nodes / 4;
    let own = problem.profile.own_nx().next_power_of_two().max(PULL_OFF_NODES);
    let nodes = reach::nodes_for(problem, problem.attraction.range, 0.5).max(own).min(largest);
    let mut lost = Refusal::NotConverged { what: "the fold of a pulled contact", detail: "its branch ends before it turns".to_owned() };
    for (nodes, load) in [(nodes, 0.0), (2 * nodes, 0.0), (nodes, LIGHT * problem.profile.half_height())] {
        let problem = Problem { control: Control::MeanPressure(load), ..problem.clone() };
        let located = start(&problem, nodes.min(largest)).map(|(equations, state)| {
            let mut tracer = Tracer::new(&problem, equations, state, false);
            tracer.until = Some(FoldKind::LeastPressure);
            let branch = tracer.run(Direction::Unloading, PULL_OFF_POINTS);
            branch.folds.iter().find(|fold| fold.kind == FoldKind::LeastPressure).map(|fold| locate(&problem, fold))
        });
        match located {
            Ok(Some(Ok(fold))) => return Ok(fold),
            Ok(Some(Err(refusal))) | Err(refusal) => lost = refusal,
            Ok(None) => {}
        }
    }
    Err(lost)
}

fn trace_with(problem: &Problem, nodes: usize, direction: Direction, points: usize, refine: bool) -> Result<Branch, Refusal> {
    let (equations, state) = start(problem, nodes)?;
    require_positive("points", points as f64)?;
    Ok(Tracer::new(problem, equations, state, refine).run(direction, points))
}

/// The cold-started state on the grid of a branch.
fn start(problem: &Problem, nodes: usize) -> Result<(Equations, State), Refusal> {
    problem.check()?;
    let reached = reach::cold(problem, nodes, 0.5)?;
    let (mut equations, mut state) = (reached.equations, reached.state);
    let place = Place { range: problem.attraction.range, stiffening: 1.0, ramp: None };
    while equations.grid.nx() < nodes {
        (equations, state) = reach::refined(problem, &equations, &state, place);
        newton::solve(&mut equations, &mut state, newton::COARSE, 3000).map_err(|stalled| Refusal::NotConverged {
            what: "the start of the branch",
            detail: format!("lost on {} nodes, residual {:.1e}", equations.grid.nx(), stalled.residual),
        })?;
    }
    Ok((equations, state))
}

struct Tracer<'a> {
    problem: &'a Problem,
    equations: Equations,
    state: State,
    /// Units of gap and pressure.
    units: [f64; 2],
    points: Vec<Numbers>,
    states: Vec<State>,
    refined: Option<Vec<Option<Refined>>>,
    /// The fold after which it may end.
    until: Option<FoldKind>,
}

impl<'a> Tracer<'a> {
    fn new(problem: &'a Problem, equations: Equations, state: State, refine: bool) -> Self {
        let half_height = problem.profile.half_height();
        let one_wave = equations.grid.ny();
        let stiffness = equations.stiffness[one_wave].norm() * equations.len() as f64;
        let units = [half_height, half_height * stiffness];
        Self { problem, equations, state, units, points: Vec::new(), states: Vec::new(), refined: refine.then(Vec::new), until: None }
    }

    fn keep(&mut self, report: newton::Report) {
        let (numbers, _, fields) = solution::evaluate(&mut self.equations, &self.state, report);
        self.points.push(numbers);
        if self.refined.is_some() {
            let refined = self.on_finer_grids(&numbers, solution::patches(&fields));
            self.refined.iter_mut().for_each(|list| list.push(refined.clone()));
        }
        self.states.push(self.state.clone());
        // Only the last three states are needed, for the secant and the folds.
        if self.states.len() > 3 {
            self.states.remove(0);
        }
    }

    /// The present state on two finer grids, on the same line across the branch.
    fn on_finer_grids(&mut self, numbers: &Numbers, patches: usize) -> Option<Refined> {
        let place = Place { range: self.problem.attraction.range, stiffening: 1.0, ramp: None };
        let mut node_products = std::mem::take(&mut self.equations.products) * self.equations.len();
        let mut history = vec![numbers.list()];
        let row = self.equations.row;
        let mut grids = vec![OnGrid::of(&mut self.equations, &self.state)];
        // Counted with the stability.
        self.equations.products = 0;
        self.equations.row = row;
        let (mut equations, mut state) = reach::refined(self.problem, &self.equations, &self.state, place);
        let mut patches = (patches, patches);
        let mut last = None;
        for grid in 0..2 {
            if grid > 0 {
                grids.push(OnGrid::of(&mut equations, &state));
                (equations, state) = reach::refined(self.problem, &equations, &state, place);
            }
            equations.row = self.equations.row;
            let before = state.clone();
            let report = newton::solve(&mut equations, &mut state, newton::FINE, 6000).ok()?;
            if reach::is_jump(self.problem, &before, &state) {
                return None;
            }
            node_products += equations.products * equations.len();
            let (numbers, certificate, fields) = solution::evaluate(&mut equations, &state, report);
            history.push(numbers.list());
            patches = (patches.1, solution::patches(&fields));
            last = Some((numbers, certificate, report.mean_residual, fields));
        }
        let (numbers, certificate, residual, fields) = last?;
        let stress = numbers.mean_pressure.abs().max(numbers.repulsive_pressure).max(numbers.adhesive_pressure.abs()).max(1e-12);
        let scale = bounds::Scale::new(&equations, stress, self.units[0]);
        // Across the branch neither load nor gap is imposed.
        let free = Problem { control: Control::Frame { stiffness: 1.0, position: 0.0 }, ..self.problem.clone() };
        let (errors, _) = bounds::of(&history, certificate.spread(), &free, &scale, residual);
        let errors = bounds::with_edges(errors, self.problem, &fields);
        let stability = StateStability { grids };
        Some(Refined {
            numbers,
            errors: Numbers::from_list(errors),
            patches: patches.1,
            patches_error: patches.0.abs_diff(patches.1),
            certificate,
            nodes: equations.grid.nx(),
            node_products: node_products + stability.node_products(),
            stability,
        })
    }

    fn place(&self, point: &Numbers) -> [f64; 2] {
        [point.mean_gap / self.units[0], point.mean_pressure / self.units[1]]
    }

    fn run(mut self, direction: Direction, wanted: usize) -> Branch {
        let mut folds = Vec::new();
        let mut tangent = if direction == Direction::Loading { [0.0, 1.0] } else { [0.0, -1.0] };
        let mut length = 0.25 * LONGEST;
        let nodes = self.equations.grid.nx();
        let mut end = End::Points;
        self.equations.row = [0.0, 1.0, self.state.mean_pressure];
        match newton::solve(&mut self.equations, &mut self.state, newton::COARSE, 3000) {
            Ok(report) => self.keep(report),
            Err(stalled) => end = End::Lost(format!("the start has the residual {:.1e}", stalled.residual)),
        }
        while !self.points.is_empty() && self.points.len() < wanted {
            match self.step(&mut tangent, &mut length) {
                Ok(()) => {}
                // A contact of few nodes needs a finer grid to go on.
                Err(_) if self.refine(nodes) => length = 0.1 * LONGEST,
                Err(reason) => {
                    end = End::Lost(reason);
                    break;
                }
            }
            folds.extend(self.fold());
            if folds.last().is_some_and(|fold| Some(fold.kind) == self.until) {
                break;
            }
            if let Some(reason) = self.finished() {
                end = reason;
                break;
            }
        }
        Branch { nodes: self.equations.grid.nx(), points: self.points, refined: self.refined.unwrap_or_default(), folds, end }
    }

    /// Goes to the grid twice as fine at the present place, as long as it is at most eight times finer than at the start.
    fn refine(&mut self, start: usize) -> bool {
        if self.equations.grid.nx() >= 8 * start {
            return false;
        }
        let place = Place { range: self.problem.attraction.range, stiffening: 1.0, ramp: None };
        let (mut equations, mut state) = reach::refined(self.problem, &self.equations, &self.state, place);
        equations.row = [1.0 / self.units[0], 0.0, self.state.mean_gap() / self.units[0]];
        let solved = newton::solve(&mut equations, &mut state, newton::COARSE, 3000).is_ok();
        if solved {
            (self.equations, self.state) = (equations, state);
            self.states = vec![self.state.clone()];
        }
        solved
    }

    /// One step along the branch, shortened until it holds.
    fn step(&mut self, tangent: &mut [f64; 2], length: &mut f64) -> Result<(), String> {
        let Some(last) = self.points.last().copied() else { return Err("no start".to_owned()) };
        let here = self.place(&last);
        let before = self.state.clone();
        loop {
            let aim = [here[0] + *length * tangent[0], here[1] + *length * tangent[1]];
            self.equations.row = [tangent[0] / self.units[0], tangent[1] / self.units[1], tangent[0] * aim[0] + tangent[1] * aim[1]];
            self.predict(*length, here);
            let solved = newton::solve(&mut self.equations, &mut self.state, newton::COARSE, 3000);
            if let Ok(report) = solved {
                let there = [self.state.mean_gap() / self.units[0], self.state.mean_pressure / self.units[1]];
                let way = [there[0] - here[0], there[1] - here[1]];
                let size = way[0].hypot(way[1]);
                // The first step has no direction to compare with.
                let spread = before.contact.iter().zip(&self.state.contact).filter(|(a, b)| a != b).count();
                let near = spread as f64 <= SPREAD * before.contact.len() as f64;
                let straight = if self.points.len() == 1 { -1.0 } else { STRAIGHT };
                if near && size > 0.0 && (way[0] * tangent[0] + way[1] * tangent[1]) / size >= straight {
                    *tangent = [way[0] / size, way[1] / size];
                    if report.steps <= EASY {
                        *length = (1.3 * *length).min(LONGEST);
                    }
                    self.keep(report);
                    return Ok(());
                }
            }
            self.state.clone_from(&before);
            *length *= 0.5;
            if *length < SHORTEST {
                return Err(format!("no further state beyond mean gap {:.5}, mean pressure {:.5}", last.mean_gap, last.mean_pressure));
            }
        }
    }

    /// The secant through the last two states, for the gap off contact.
    fn predict(&mut self, length: f64, here: [f64; 2]) {
        let count = self.points.len();
        if count < 2 || self.states.len() < 2 {
            return;
        }
        let back = self.place(&self.points[count - 2]);
        let size = (here[0] - back[0]).hypot(here[1] - back[1]);
        let factor = if size > 0.0 { (length / size).min(2.0) } else { 0.0 };
        let (old, new) = (&self.states[self.states.len() - 2], &self.states[self.states.len() - 1]);
        let wall = self.equations.wall();
        let floor = if wall.is_finite() { wall } else { 0.0 };
        for (i, gap) in self.state.gap.iter_mut().enumerate() {
            let extrapolated = new.gap[i] + factor * (new.gap[i] - old.gap[i]);
            if !new.contact[i] && extrapolated > floor {
                *gap = extrapolated;
            }
        }
        self.state.mean_pressure = new.mean_pressure + factor * (new.mean_pressure - old.mean_pressure);
    }

    /// The fold at the last but one point, if gap or pressure turn there.
    fn fold(&self) -> Vec<RoughFold> {
        let [.., a, b, c] = self.points.as_slice() else { return Vec::new() };
        let [.., state, _] = self.states.as_slice() else { return Vec::new() };
        let spacing = [
            0.5 * (b.mean_gap - a.mean_gap).abs().max((c.mean_gap - b.mean_gap).abs()),
            0.5 * (b.mean_pressure - a.mean_pressure).abs().max((c.mean_pressure - b.mean_pressure).abs()),
        ];
        let turns = |x: f64, y: f64, z: f64| (y - x) * (z - y) < 0.0;
        let rough = |kind| RoughFold { kind, point: *b, state: state.clone(), nodes: self.equations.grid.nx(), spacing };
        let mut found = Vec::new();
        if turns(a.mean_pressure, b.mean_pressure, c.mean_pressure) {
            found.push(rough(if b.mean_pressure < a.mean_pressure { FoldKind::LeastPressure } else { FoldKind::LargestPressure }));
        }
        if turns(a.mean_gap, b.mean_gap, c.mean_gap) {
            found.push(rough(if b.mean_gap < a.mean_gap { FoldKind::LeastGap } else { FoldKind::LargestGap }));
        }
        found
    }

    fn finished(&self) -> Option<End> {
        let highest = self.equations.heights.iter().copied().fold(0.0, f64::max);
        if self.state.contact.iter().all(|c| *c) {
            return Some(End::FullContact);
        }
        let touches = self.state.contact.iter().any(|c| *c);
        (!touches && self.state.mean_gap() > highest + 10.0 * self.problem.attraction.range).then_some(End::Separated)
    }
}
