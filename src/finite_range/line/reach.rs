//! How a state is reached from nothing: a long range on a coarse grid first, then the real range, the real modulus and finer grids.
//!
//! At a long range the equations are nearly convex and few nodes tell everything; every later solve starts next to its solution.
//! Two paths are tried: with the real modulus all the way, then from the relaxed elastic body with E^t, t from 0 to 1.
//! Several states may exist. One that a small disturbance leaves is returned only where no start leads to a stable one.

use super::grid::{Equations, State};
use super::newton::{self, Report, Stalled};
use super::problem::{Control, Problem};
use super::stability::OnGrid;
use crate::finite_range::law::Law;
use crate::refusal::Refusal;
use crate::sliding::branch::Stability;

/// First guesses: the profile lifted by these parts of its highest point, cut at the wall.
const LIFTS: [f64; 5] = [0.3, 0.6, 0.1, 1.0, 1.5];
/// A lift below the deepest point closes the gap everywhere.
const CLOSED: f64 = -100.0;
/// The range at which a cold start begins, over half of the peak-to-valley height.
const LONG_RANGE: f64 = 0.2;
/// The same where every state is looked for: the shortest starts at the real range.
const STARTS: [f64; 4] = [0.4, LONG_RANGE, 0.1, 0.0];
/// Gaps that differ by less than this part of the half height belong to one state.
const SAME: f64 = 1e-3;
/// Largest step in ln(range) and in the power of the modulus times ln(stiffening).
const LONGEST_STEP: f64 = 0.41;
const SHORTEST_STEP: f64 = 4e-3;
/// A change of the mean gap by more than this part of the half height in one step is a jump to another state.
const JUMP: f64 = 0.15;
/// The ramp of a Dugdale law on the way of a cold start.
const WIDE_RAMP: f64 = 0.9;
/// Coarsest grid.
const COARSEST: usize = 64;
/// Nodes of the cold start of a line without attraction.
const WITHOUT_ATTRACTION: usize = 256;
/// Products that one solve may take.
const SOLVE_BUDGET: usize = 3000;
/// Products times nodes that one whole search may take.
const SEARCH_BUDGET: usize = 150_000_000;

/// A state with the equations it solves and the work it took.
#[derive(Clone)]
pub(super) struct Reached {
    pub(super) equations: Equations,
    pub(super) state: State,
    pub(super) report: Report,
    /// Products in the whole search.
    pub(super) products: usize,
    /// The same, each times the nodes of its grid.
    pub(super) work: usize,
    pub(super) path: Path,
}

/// The path by which a cold start succeeded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    /// From a long range, with the real modulus.
    Range,
    /// From a long range with the real modulus, with the ramp of a Dugdale law wide on the way, then its own.
    RangeThenRamp,
    /// From the relaxed elastic body at a long range, then the modulus, then the range.
    ModulusThenRange,
    /// From the relaxed elastic body at a long range, then the range, then the modulus.
    RangeThenModulus,
    /// From a closed gap at the real range and modulus (laws without a hard wall; with one, full contact has a closed form).
    Closed,
}

/// Nodes along x that resolve the zone of the law at an edge: its relaxed length is a₀ = 2W/(π peak²).
pub(super) fn nodes_for(problem: &Problem, range: f64, cells: f64) -> usize {
    let mut law = problem.attraction.clone();
    if !law.attracts() {
        return if problem.profile.is_line() { WITHOUT_ATTRACTION } else { COARSEST };
    }
    law.range = range;
    let mut zone = std::f64::consts::FRAC_2_PI * law.work_of_adhesion / law.peak_stress().powi(2);
    if law.wall().is_none() {
        // Repulsion is a spring as steep as the tension falls: its wave has to be seen, too.
        zone = zone.min(std::f64::consts::FRAC_2_PI / law.steepest_slope());
    }
    let nodes = (std::f64::consts::TAU * cells / zone).min(1e9) as usize;
    nodes.next_power_of_two().max(COARSEST)
}

/// A state from nothing, on the grid that puts `cells` nodes into the zone of the law, but no finer than `largest` nodes along x.
pub(super) fn cold(problem: &Problem, largest: usize, cells: f64) -> Result<Reached, Refusal> {
    let mut search = Search::new(problem, largest, cells);
    let mut unstable = None;
    let convex = search.convex_start();
    for (path, start) in [
        (Path::RangeThenRamp, LONG_RANGE),
        (Path::Range, LONG_RANGE),
        (Path::Range, convex),
        (Path::ModulusThenRange, LONG_RANGE),
        (Path::RangeThenModulus, LONG_RANGE),
        (Path::Closed, LONG_RANGE),
    ] {
        let closed_form =
            path == Path::Closed && problem.attraction.wall().is_some() || path == Path::RangeThenRamp && !has_steep_ramp(problem);
        let lifts = match path {
            Path::Closed => vec![CLOSED],
            // Every first guess leads to the one state there.
            Path::Range if start > LONG_RANGE => search.lifts().into_iter().take(1).collect(),
            _ => search.lifts(),
        };
        for lift in lifts {
            if closed_form || (search.work > SEARCH_BUDGET && path != Path::Closed) {
                break;
            }
            let Some(found) = search.follow(path, lift, start) else { continue };
            let mut reached = search.reached(found, path);
            if reached.grows(problem) {
                unstable.get_or_insert(reached);
            } else {
                return Ok(reached);
            }
        }
    }
    unstable.ok_or(Refusal::NotConverged { what: "the cold start of the steady state", detail: search.last })
}

/// The states to which every start leads, each once.
pub(super) fn every(problem: &Problem, largest: usize, cells: f64) -> Vec<Reached> {
    let mut search = Search::new(problem, largest, cells);
    let mut all: Vec<Reached> = Vec::new();
    let mut add = |reached: Reached| {
        if !all.iter().any(|other| other.is_same(&reached, problem)) {
            all.push(reached);
        }
    };
    cold(problem, largest, cells).into_iter().for_each(&mut add);
    let range = if has_steep_ramp(problem) { Path::RangeThenRamp } else { Path::Range };
    for start in STARTS {
        for lift in search.lifts().into_iter().chain([CLOSED]) {
            if search.work > SEARCH_BUDGET {
                return all;
            }
            let found = search.follow(range, lift, start);
            found.into_iter().for_each(|found| add(search.reached(found, range)));
        }
    }
    all
}

/// The surfaces at a held mean gap that no contact bridges, at the real range.
pub(super) fn without_contact(problem: &Problem, largest: usize, cells: f64) -> Option<Reached> {
    let mut search = Search::new(problem, largest, cells);
    let lift = search.lifts().first().copied()?;
    let found = search.follow(Path::Range, lift, 0.0)?;
    Some(search.reached(found, Path::Range))
}

impl Reached {
    /// Whether a small disturbance grows under what is held.
    fn grows(&mut self, problem: &Problem) -> bool {
        let row = self.equations.row;
        let stability = OnGrid::of(&mut self.equations, &self.state);
        self.equations.row = row;
        OnGrid::agreed(&[stability], problem.control.stiffness()) == Stability::Unstable
    }

    /// Whether another start led to the same state.
    fn is_same(&self, other: &Self, problem: &Problem) -> bool {
        let half_height = problem.profile.half_height();
        let same_grid = self.state.gap.len() == other.state.gap.len();
        let widest = self.state.gap.iter().zip(&other.state.gap).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        same_grid && widest <= SAME * half_height
    }
}

struct Search<'a> {
    problem: &'a Problem,
    largest: usize,
    cells: f64,
    products: usize,
    work: usize,
    last: String,
}

impl<'a> Search<'a> {
    fn new(problem: &'a Problem, largest: usize, cells: f64) -> Self {
        Self { problem, largest, cells, products: 0, work: 0, last: String::from("no start converged") }
    }

    fn reached(&self, (equations, state, report): (Equations, State, Report), path: Path) -> Reached {
        Reached { equations, state, report, products: self.products, work: self.work, path }
    }

    fn lifts(&self) -> Vec<f64> {
        match self.problem.control {
            Control::MeanGap(gap) => vec![gap / self.problem.profile.half_height(), 0.3, 1.0],
            _ => LIFTS.to_vec(),
        }
    }

    /// The range, over half of the height, from which on the tension falls less steeply than the softest wave of the body resists: there is one state.
    /// A thin free layer bends: its long waves are far softer than those of a half-space.
    fn convex_start(&self) -> f64 {
        let Problem { attraction, profile, .. } = self.problem;
        let equations = Equations::new(self.problem, COARSEST.min(self.largest), 1.0, attraction.range);
        let softest = equations.stiffness.iter().skip(1).map(|a| a.re * equations.len() as f64).fold(f64::INFINITY, f64::min);
        let range = attraction.range * (attraction.steepest_slope() / softest).sqrt();
        if range.is_finite() { (range / profile.half_height()).max(LONG_RANGE) } else { LONG_RANGE }
    }

    /// Along a path from a profile lifted by a part of its highest point; `start`: the long range over half of the height.
    fn follow(&mut self, path: Path, lift: f64, start: f64) -> Option<(Equations, State, Report)> {
        let problem = self.problem;
        let half_height = problem.profile.half_height();
        let target = if problem.attraction.attracts() { problem.attraction.range } else { LONG_RANGE * half_height };
        let long = if path == Path::Closed { target } else { target.max(start * half_height) };
        let real_modulus = matches!(path, Path::Range | Path::RangeThenRamp | Path::Closed);
        let mut place = Place {
            range: long,
            stiffening: if real_modulus { 1.0 } else { 0.0 },
            ramp: (path == Path::RangeThenRamp).then_some(WIDE_RAMP),
        };
        let mut equations = Equations::new(problem, COARSEST.min(self.largest), place.stiffening, long);
        equations.set_ramp(place.ramp);
        let floor = if equations.wall().is_finite() { equations.wall() } else { 0.8 * long.min(target * 10.0) };
        let top = lift * half_height;
        let gap: Vec<f64> = equations.heights.iter().map(|h| (top - h).max(0.0) + floor).collect();
        let contact = equations.heights.iter().map(|&h| equations.wall().is_finite() && h >= top).collect();
        let mean_pressure = if let Control::MeanPressure(p) = problem.control { p } else { 0.0 };
        let mut state = State { gap, contact, mean_pressure };
        let mut report = self.solved(&mut equations, &mut state, place)?;
        let legs: &[Leg] = match path {
            Path::Range | Path::Closed => &[Leg::Range],
            Path::RangeThenRamp => &[Leg::Range, Leg::Ramp],
            Path::ModulusThenRange => &[Leg::Modulus, Leg::Range],
            Path::RangeThenModulus => &[Leg::Range, Leg::Modulus],
        };
        for &leg in legs {
            self.refine_to(nodes_for(problem, place.range, self.cells), &mut equations, &mut state, &mut report, place)?;
            self.walk(leg, &mut place, &mut equations, &mut state, &mut report)?;
        }
        Some((equations, state, report))
    }

    /// Goes along one leg in steps that adapt; false steps and jumps halve the step.
    fn walk(&mut self, leg: Leg, place: &mut Place, equations: &mut Equations, state: &mut State, report: &mut Report) -> Option<()> {
        let problem = self.problem;
        let stiffening = (problem.modulus)(problem.speed * 1e6).norm().max(1.5).ln();
        let mut step = LONGEST_STEP;
        loop {
            let left = match leg {
                Leg::Range if !problem.attraction.attracts() => 0.0,
                Leg::Range => (place.range / problem.attraction.range).ln(),
                Leg::Modulus => (1.0 - place.stiffening) * stiffening,
                Leg::Ramp => place.ramp.map_or(0.0, |ramp| (ramp / own_ramp(problem)).ln()),
            };
            if left <= 1e-12 {
                return Some(());
            }
            let last = step >= left;
            let mut next = *place;
            match leg {
                Leg::Range => next.range = if last { problem.attraction.range } else { place.range * (-step).exp() },
                Leg::Modulus => next.stiffening = if last { 1.0 } else { place.stiffening + step / stiffening },
                Leg::Ramp => next.ramp = if last { None } else { place.ramp.map(|ramp| ramp * (-step).exp()) },
            }
            let before = state.clone();
            if leg == Leg::Range {
                self.refine_to(nodes_for(problem, next.range, self.cells), equations, state, report, *place)?;
            } else if leg == Leg::Modulus {
                equations.set_stiffness(problem, next.stiffening);
            }
            let kept = state.clone();
            equations.set_range_of(state, next.range);
            equations.set_ramp(next.ramp.or_else(|| has_steep_ramp(problem).then(|| own_ramp(problem))));
            // Where the shortest step is one too many the state has ceased to exist: the next one that stays may lie far away.
            let ceased = step < 2.0 * SHORTEST_STEP;
            let solved = if ceased {
                self.solved(equations, state, next)
            } else {
                self.note(newton::solve(equations, state, newton::COARSE, SOLVE_BUDGET), equations, next)
            };
            if let Some(found) = solved.filter(|_| ceased || !is_jump(problem, &before, state)) {
                *report = found;
                *place = next;
                step = (1.5 * step).min(LONGEST_STEP);
            } else {
                *state = kept;
                equations.set_range(place.range);
                equations.set_ramp(place.ramp);
                if leg == Leg::Modulus {
                    equations.set_stiffness(problem, place.stiffening);
                }
                step *= 0.5;
                if step < SHORTEST_STEP || self.work > SEARCH_BUDGET {
                    return None;
                }
            }
        }
    }

    fn refine_to(&mut self, nx: usize, equations: &mut Equations, state: &mut State, report: &mut Report, place: Place) -> Option<()> {
        let nx = nx.min(self.largest);
        while equations.grid.nx() < nx {
            let (finer, start) = refined(self.problem, equations, state, place);
            *equations = finer;
            *state = start;
            *report = self.solved(equations, state, place)?;
        }
        Some(())
    }

    /// Solves; where that wanders, moves on to the next state that stays.
    fn solved(&mut self, equations: &mut Equations, state: &mut State, place: Place) -> Option<Report> {
        let start = state.clone();
        let solved = newton::solve(equations, state, newton::COARSE, SOLVE_BUDGET);
        self.note(solved, equations, place).or_else(|| {
            *state = start;
            let relaxed = newton::relax(equations, state, newton::COARSE, SOLVE_BUDGET);
            self.note(relaxed, equations, place)
        })
    }

    fn note(&mut self, solved: Result<Report, Stalled>, equations: &mut Equations, place: Place) -> Option<Report> {
        let products = std::mem::take(&mut equations.products);
        self.products += products;
        self.work += products * equations.len();
        match solved {
            Ok(report) => Some(report),
            Err(stalled) => {
                self.last = format!(
                    "lost at range {:.4e}, modulus to the power {:.3}, on {} nodes: residual {:.1e} after {} Newton steps",
                    place.range,
                    place.stiffening,
                    equations.grid.nx(),
                    stalled.residual,
                    stalled.steps
                );
                None
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Leg {
    Range,
    Modulus,
    Ramp,
}

/// Whether the law is a Dugdale law with a ramp so narrow that a wide one is an easier way.
fn has_steep_ramp(problem: &Problem) -> bool {
    own_ramp(problem) < 0.5 * WIDE_RAMP
}

/// The ramp of a Dugdale law; one of every other law.
const fn own_ramp(problem: &Problem) -> f64 {
    match problem.attraction.law {
        Law::Dugdale { ramp } => ramp,
        _ => 1.0,
    }
}

#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) range: f64,
    pub(super) stiffening: f64,
    /// The ramp of a Dugdale law on the way; none: its own.
    pub(super) ramp: Option<f64>,
}

/// Whether two states differ by too much to be neighbours on one branch.
pub(super) fn is_jump(problem: &Problem, before: &State, after: &State) -> bool {
    let change = match problem.control {
        Control::MeanGap(_) => 0.3 * (after.mean_pressure - before.mean_pressure).abs() / before.mean_pressure.abs().max(1.0),
        _ => (after.mean_gap() - before.mean_gap()).abs() / problem.profile.half_height(),
    };
    change.is_nan() || change > JUMP
}

/// The equations on the grid with half the spacing, and the state interpolated to it.
pub(super) fn refined(problem: &Problem, equations: &Equations, state: &State, place: Place) -> (Equations, State) {
    let mut finer = Equations::new(problem, 2 * equations.grid.nx(), place.stiffening, place.range);
    finer.set_ramp(place.ramp);
    let (nx, ny) = (equations.grid.nx(), equations.grid.ny());
    let (fine_nx, fine_ny) = (finer.grid.nx(), finer.grid.ny());
    let mut gap = Vec::with_capacity(fine_nx * fine_ny);
    let mut contact = Vec::with_capacity(fine_nx * fine_ny);
    for j in 0..fine_ny {
        let (y0, y1) = parents(j, ny, fine_ny);
        for i in 0..fine_nx {
            let (x0, x1) = parents(i, nx, fine_nx);
            let corners = [y0 * nx + x0, y0 * nx + x1, y1 * nx + x0, y1 * nx + x1];
            gap.push(0.25 * corners.iter().map(|&c| state.gap[c]).sum::<f64>());
            contact.push(corners.iter().all(|&c| state.contact[c]));
        }
    }
    (finer, State { gap, contact, mean_pressure: state.mean_pressure })
}

/// The two coarse nodes around a fine one (twice the same one if they coincide).
const fn parents(fine: usize, coarse_count: usize, fine_count: usize) -> (usize, usize) {
    if fine_count == coarse_count {
        return (fine, fine);
    }
    (fine / 2 % coarse_count, fine.div_ceil(2) % coarse_count)
}
