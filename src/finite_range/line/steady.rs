//! A steady state with the error of every number from three or more grids.
//!
//! A contact edge falls between nodes, so the error of a number changes sign from grid to grid and no extrapolation helps. The
//! bounds come from the last differences between grids ([`super::bounds`]), plus the effect of the residual.

use super::bounds::{self, Convergence};
use super::grid::{Equations, State};
use super::newton;
use super::problem::{Control, Problem};
use super::reach::{self, Place, Reached};
use super::solution::{self, Certificate, Differences, Fields, Numbers};
use crate::finite_range::law::Law;
use crate::refusal::{Refusal, require_positive};

/// Nodes in the relaxed zone of the law on the grid of the cold start; the finer ones are tried where the coarse one leads astray.
const CELLS: [f64; 3] = [0.5, 2.0, 8.0];

/// Nodes along x of the coarsest grid that a neighbour is followed on.
const COARSEST_OF_A_NEIGHBOUR: usize = 128;

/// A state is reached from one whose gap or frame is this part of the half height further away, or nearer.
const AWAY: f64 = 0.3;
/// It is reached in so many steps, halved down to this part of them; the accuracy on the way.
const LOADS: f64 = 4.0;
const SHORTER: f64 = 64.0;
const ON_THE_WAY: f64 = 0.05;

/// Products times nodes of one damped motion.
const RELAXATION: usize = 20_000_000;

/// No contact: so many ranges above the highest point, where the tail of an exponential law pulls no wave of the body. So many gaps are tried from there.
const FAR: f64 = 12.0;
const GAPS: usize = 16;

/// Numbers that differ by less than this part of themselves belong to one state.
const SAME: f64 = 1e-3;

/// Grids below the finest one on which the stability is assessed.
const GRIDS_OF_STABILITY: usize = 2;

/// Friction below this part of pressure times slope is asked for absolutely.
const SMALL_FRICTION: f64 = 1e-3;

/// How exact a state must be and what it may cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Positive. Allowed relative error of the friction stress (of a thousandth of pressure × slope where it is smaller than that), and error of
    /// the gap and pressure relative to the profile's height and the stress.
    pub accuracy: f64,
    /// Nodes along x of the first grid that may be the answer; the finer ones follow by doubling.
    pub least_nodes: usize,
    /// Nodes along x of the finest grid, a power of two between 64 and 2²².
    pub most_nodes: usize,
}

impl Default for Request {
    fn default() -> Self {
        Self { accuracy: 1e-4, least_nodes: 512, most_nodes: 1 << 16 }
    }
}

/// From where a state was reached; other states may exist at the same input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReachedBy {
    /// From a long range of the law at the same control (see [`reach::Path`]).
    ColdStart(reach::Path),
    /// Followed from a neighbouring state.
    Continuation,
    /// Followed from another mean pressure, gap or frame at the same range, where the starts from long ranges are lost.
    AnotherLoad,
    /// The closed form of full contact.
    FullContact,
}

/// A steady state.
#[derive(Debug, Clone)]
pub struct SteadyState {
    /// The numbers on the finest grid.
    pub numbers: Numbers,
    /// The error bound of each number (same units).
    pub errors: Numbers,
    /// Patches of contact.
    pub patches: usize,
    /// By how many the patches changed from the grid before.
    pub patches_error: usize,
    /// The identities and residual.
    pub certificate: Certificate,
    /// Pressure, gap, profile, surface and contact on the finest grid.
    pub fields: Fields,
    /// The error bounds of the pressure (E0*kΛ/2) and of the gap (Λ) at each node: the largest difference from the grid before, of the nodes
    /// around it, or what is left of the one before.
    pub field_errors: [Vec<f64>; 2],
    /// From where it was reached.
    pub reached_by: ReachedBy,
    /// Whether the accuracy was met; otherwise `nodes_needed` says what grid it would take.
    pub accuracy_met: bool,
    /// Nodes along x that the accuracy is expected to take (error ∝ N^−1.5).
    pub nodes_needed: usize,
    /// Products with the stiffness in the whole search.
    pub products: usize,
    /// The same, each times the nodes of its grid.
    pub node_products: usize,
    /// The state on the two grids before, with their nodes along x.
    pub(super) coarser: Vec<(usize, State)>,
}

impl SteadyState {
    /// Friction stress over mean pressure, in units of the slope kΛ; none where the mean pressure is not positive.
    #[must_use]
    pub fn friction_coefficient(&self) -> Option<f64> {
        (self.numbers.mean_pressure > 0.0).then(|| self.numbers.friction_stress / self.numbers.mean_pressure)
    }

    /// Whether both are one state, as far as their errors say.
    fn is_same(&self, other: &Self) -> bool {
        let numbers = self.numbers.list().into_iter().zip(other.numbers.list());
        let errors = self.errors.list().into_iter().zip(other.errors.list());
        numbers.zip(errors).all(|((a, b), (e, f))| (a - b).abs() <= SAME * a.abs().max(b.abs()) + e + f)
    }

    /// Power dissipated per area, friction stress × kv (unit E0*kΛ²/2 × the unit of kv).
    #[must_use]
    pub fn dissipated_power(&self, problem: &Problem) -> f64 {
        self.numbers.friction_stress * problem.speed
    }
}

/// Reaches the steady state of a problem from nothing and refines it until the accuracy is met.
///
/// # Errors
/// As [`Problem::check`]; [`Refusal::OutOfRange`] for an accuracy that is not positive or a number of nodes that is not allowed;
/// [`Refusal::NotConverged`] where the nodes are too few or the cold start is lost; it says where.
pub fn solve(problem: &Problem, request: &Request) -> Result<SteadyState, Refusal> {
    problem.check()?;
    require_positive("accuracy", request.accuracy)?;
    if request.most_nodes < 64 || request.most_nodes > 1 << 22 || !request.most_nodes.is_power_of_two() {
        return Err(Refusal::out_of_range("most_nodes", request.most_nodes as f64, "a power of two between 64 and 4194304"));
    }
    match from_long_ranges(problem, request) {
        Cold::Found(state) => Ok(*state),
        Cold::TooFewNodes => Err(Refusal::NotConverged {
            what: "the steady state",
            detail: format!(
                "the range needs {} nodes, but at most {} are allowed",
                4 * reach::nodes_for(problem, problem.attraction.range, CELLS[0]),
                request.most_nodes
            ),
        }),
        // What no long range leads to may lie next to a state under another load, at the real range.
        Cold::Lost { refusal, on_a_grid } => from_another_load(problem, request).or_else(|_| {
            // A state that a coarse grid has and a finer one loses may exist.
            let full = if on_a_grid { None } else { super::full::full_contact(problem, request).ok() };
            full.map(|full| from_no_contact(problem, request).unwrap_or(full)).ok_or(refusal)
        }),
    }
}

/// What the search from long ranges came to.
enum Cold {
    Found(Box<SteadyState>),
    /// Every start was lost: on the way, or where the grid was doubled.
    Lost {
        refusal: Refusal,
        on_a_grid: bool,
    },
    /// The range needs more nodes than are allowed.
    TooFewNodes,
}

fn from_long_ranges(problem: &Problem, request: &Request) -> Cold {
    let (mut lost, mut on_coarse_grids) = (Cold::TooFewNodes, Vec::new());
    for cells in cells(problem, request) {
        // Two doublings more are needed for the error.
        if 4 * reach::nodes_for(problem, problem.attraction.range, cells) > request.most_nodes {
            break;
        }
        match reach::cold(problem, request.most_nodes / 4, cells) {
            Ok(reached) => {
                let path = ReachedBy::ColdStart(reached.path);
                match refine(problem, request, reached.clone(), path) {
                    Ok(state) => return Cold::Found(Box::new(state)),
                    Err(refusal) => lost = Cold::Lost { refusal, on_a_grid: true },
                }
                on_coarse_grids.push((reached, path));
            }
            Err(_) if matches!(lost, Cold::Lost { on_a_grid: true, .. }) => {}
            Err(refusal) => lost = Cold::Lost { refusal, on_a_grid: false },
        }
    }
    // A damped motion is the last resort: on coarse grids it may end where an edge hangs on a node, which widens the bounds.
    let damped = |(reached, path)| refine_with(problem, request, reached, path, Motion::MayBeDamped).ok();
    on_coarse_grids.into_iter().find_map(damped).map_or(lost, |state| Cold::Found(Box::new(state)))
}

/// The state, from one under another load: none, or a frame or a gap that is further away, then nearer.
fn from_another_load(problem: &Problem, request: &Request) -> Result<SteadyState, Refusal> {
    let away = AWAY * problem.profile.half_height();
    let (wanted, starts) = match problem.control {
        Control::MeanPressure(wanted) => (wanted, vec![0.0]),
        Control::MeanGap(wanted) => (wanted, vec![wanted + away, wanted - away]),
        Control::Frame { position, .. } => (position, vec![position + away, position - away]),
    };
    let mut last = Refusal::NotConverged { what: "the way from another load", detail: "it has no other load to start from".to_owned() };
    for start in starts {
        match along_loads(problem, request, start, wanted) {
            Ok(state) => return Ok(state),
            Err(refusal) => last = refusal,
        }
    }
    Err(last)
}

fn along_loads(problem: &Problem, request: &Request, start: f64, wanted: f64) -> Result<SteadyState, Refusal> {
    let at = |value: f64| Problem { control: problem.control.with_value(value), ..problem.clone() };
    let rough = Request { accuracy: request.accuracy.max(ON_THE_WAY), ..*request };
    let lost = |detail: &str| Refusal::NotConverged { what: "the way from another load", detail: detail.to_owned() };
    let mut state = match from_long_ranges(&at(start), &rough) {
        Cold::Found(state) => *state,
        Cold::Lost { refusal, .. } => return Err(refusal),
        Cold::TooFewNodes => return Err(lost("its range needs more nodes than are allowed")),
    };
    let (mut value, mut step) = (start, (wanted - start) / LOADS);
    let shortest = step.abs() / SHORTER;
    while step.abs() > 0.0 {
        let last = (wanted - value).abs() <= step.abs() * (1.0 + 1e-9);
        let next = if last { wanted } else { value + step };
        match follow(&at(next), &state, if last { request } else { &rough }) {
            Ok(found) if last => return Ok(SteadyState { reached_by: ReachedBy::AnotherLoad, ..found }),
            Ok(found) => (state, value) = (found, next),
            Err(refusal) if step.abs() < shortest => return Err(refusal),
            Err(_) => step *= 0.5,
        }
    }
    Err(lost("it has no other load to start from"))
}

/// A partial contact, by held mean gaps from no contact on: the surfaces snap into contact, then the gap follows what the control lacks.
fn from_no_contact(problem: &Problem, request: &Request) -> Option<SteadyState> {
    let rough = Request { accuracy: request.accuracy.max(ON_THE_WAY), ..*request };
    let held = |gap: f64| Problem { control: Control::MeanGap(gap), ..problem.clone() };
    // Positive as long as the surfaces are too far from each other.
    let lacks = |state: &SteadyState| match problem.control {
        Control::MeanPressure(wanted) => wanted - state.numbers.mean_pressure,
        Control::MeanGap(wanted) => state.numbers.mean_gap - wanted,
        Control::Frame { stiffness, position } => stiffness * (state.numbers.mean_gap - position) - state.numbers.mean_pressure,
    };
    let is_partial = |state: &SteadyState| state.numbers.contact_fraction > 0.0 && state.numbers.contact_fraction < 1.0;
    let mut gap = problem.profile.heights().iter().copied().fold(0.0, f64::max) + FAR * problem.attraction.range;
    let cells = cells(problem, request).first().copied().unwrap_or(CELLS[0]);
    let parted = reach::without_contact(&held(gap), request.most_nodes / 4, cells)?;
    let mut state = refine(&held(gap), &rough, parted, ReachedBy::AnotherLoad).ok()?;
    let mut step = AWAY * problem.profile.half_height();
    for _ in 0..GAPS {
        let next_gap = if is_partial(&state) && lacks(&state) < 0.0 { gap + step } else { gap - step };
        let next = if next_gap > 0.0 { follow_or_settle(&held(next_gap), &state, &rough).ok() } else { None };
        // Neither the full contact nor the loss of a contact leads on.
        match next.filter(|next| is_partial(next) || next.numbers.contact_fraction < 1.0 && !is_partial(&state)) {
            Some(next) if is_partial(&state) && lacks(&state) * lacks(&next) <= 0.0 => {
                let found = [&next, &state].into_iter().find_map(|near| follow(problem, near, request).ok().filter(is_partial));
                if let Some(found) = found {
                    return Some(SteadyState { reached_by: ReachedBy::AnotherLoad, ..found });
                }
                step *= 0.5;
            }
            Some(next) => (state, gap) = (next, next_gap),
            None => step *= 0.5,
        }
    }
    None
}

/// Every state of the problem that a search finds: profiles lifted by several parts of their height, from several ranges of the law down to
/// the real one; full contact by its closed form. The one that [`solve`] returns comes first. There may be more.
///
/// # Errors
/// As [`solve`], where no state is found.
pub fn every(problem: &Problem, request: &Request) -> Result<Vec<SteadyState>, Refusal> {
    let mut all = vec![solve(problem, request)?];
    let cells = cells(problem, request).first().copied().unwrap_or(CELLS[0]);
    let others = reach::every(problem, request.most_nodes / 4, cells).into_iter().filter_map(|reached| {
        let path = ReachedBy::ColdStart(reached.path);
        refine(problem, request, reached, path).ok()
    });
    // Full contact first: its closed form knows how it was reached.
    for found in super::full::full_contact(problem, request).into_iter().chain(others) {
        if !all.iter().any(|other| other.is_same(&found)) {
            all.push(found);
        }
    }
    Ok(all)
}

/// The cells in the zone that are tried. The tail of an exponential law is longer than a₀ says, so that a quarter of the nodes may do;
/// of a law without a wall half of them may see its spring.
fn cells(problem: &Problem, request: &Request) -> Vec<f64> {
    let fits = |cells: f64| 4 * reach::nodes_for(problem, problem.attraction.range, cells) <= request.most_nodes;
    let fewer = match problem.attraction.law {
        Law::Exponential => 0.25 * CELLS[0],
        _ if problem.attraction.wall().is_none() => 0.5 * CELLS[0],
        _ => CELLS[0],
    };
    if fits(CELLS[0]) { CELLS.to_vec() } else { vec![fewer] }
}

/// The state next to a given one: another load, speed, range or material, the same profile. This is the way to go along a curve, to
/// stay on one of several branches, and to load and unload.
///
/// # Errors
/// As [`solve`]; [`Refusal::OutOfRange`] for a state of another kind of profile; [`Refusal::NotConverged`] if the step is too long or the
/// branch ends.
pub fn follow(problem: &Problem, from: &SteadyState, request: &Request) -> Result<SteadyState, Refusal> {
    problem.check()?;
    require_positive("accuracy", request.accuracy)?;
    let old = &from.fields;
    if old.nx / 8 >= COARSEST_OF_A_NEIGHBOUR && old.ny == 1 {
        // Three differences between grids bound the error better than two.
        if let Ok(state) = follow_from(problem, from, request, 8, End::Refused) {
            return Ok(state);
        }
    }
    follow_from(problem, from, request, third_coarsest(old), End::Refused)
}

/// The state next to a given one, or where its branch ends the one that a damped motion settles in.
fn follow_or_settle(problem: &Problem, from: &SteadyState, request: &Request) -> Result<SteadyState, Refusal> {
    follow(problem, from, request).or_else(|_| follow_from(problem, from, request, third_coarsest(&from.fields), End::Settles))
}

/// Two grids coarser, so that the given grid is the third one of the error; every fourth node is a node there.
fn third_coarsest(old: &Fields) -> usize {
    if old.nx >= 256 && (old.ny == 1 || old.ny.is_multiple_of(8)) { 4 } else { 1 }
}

/// What becomes of a state whose branch ends before the next one.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Refused,
    Settles,
}

/// The same from every so manyth node of the neighbour.
fn follow_from(problem: &Problem, from: &SteadyState, request: &Request, stride: usize, end: End) -> Result<SteadyState, Refusal> {
    let old = &from.fields;
    let mut equations = Equations::new(problem, old.nx / stride, 1.0, problem.attraction.range);
    let stride_y = if old.ny == 1 { 1 } else { stride };
    if equations.grid.ny() * stride_y != old.ny {
        return Err(Refusal::out_of_range("rows of the state", old.ny as f64, "those of the profile"));
    }
    let nodes = (0..old.ny).step_by(stride_y).flat_map(|y| (0..old.nx).step_by(stride).map(move |x| y * old.nx + x));
    let has_wall = problem.attraction.wall().is_some();
    let (gap, contact) = nodes.map(|node| (old.gap[node], has_wall && old.contact[node])).unzip();
    let before = State { gap, contact, mean_pressure: from.numbers.mean_pressure };
    let mut state = before.clone();
    let lost = |detail: String| Refusal::NotConverged { what: "the step to the next state", detail };
    let solved = newton::solve(&mut equations, &mut state, newton::FINE, 6000).or_else(|stalled| match end {
        End::Refused => Err(stalled),
        End::Settles => {
            state.clone_from(&before);
            let nodes = equations.len();
            newton::relax(&mut equations, &mut state, newton::FINE, RELAXATION / nodes)
        }
    });
    let report = solved.map_err(|stalled| lost(format!("residual {:.1e} on {} nodes", stalled.residual, old.nx / stride)))?;
    if end == End::Refused && reach::is_jump(problem, &before, &state) {
        let (old_gap, new_gap) = (before.mean_gap(), state.mean_gap());
        return Err(lost(format!("it jumps from mean gap {old_gap:.5} to {new_gap:.5}: take a shorter step, or the branch ends here")));
    }
    let work = report.products * equations.len();
    let reached = Reached { equations, state, report, products: report.products, work, path: reach::Path::Range };
    refine(problem, request, reached, ReachedBy::Continuation)
}

/// Doubles the grid until enough grids agree.
pub(super) fn refine(problem: &Problem, request: &Request, reached: Reached, reached_by: ReachedBy) -> Result<SteadyState, Refusal> {
    refine_with(problem, request, reached, reached_by, Motion::Newton)
}

/// How a state gets to a finer grid.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Motion {
    Newton,
    /// An edge that moves by many of the finer nodes leads Newton's full steps astray, not damped ones.
    MayBeDamped,
}

fn refine_with(
    problem: &Problem,
    request: &Request,
    reached: Reached,
    reached_by: ReachedBy,
    motion: Motion,
) -> Result<SteadyState, Refusal> {
    let Reached { mut equations, mut state, mut report, mut products, mut work, .. } = reached;
    let mut before: Option<Fields> = None;
    let mut differences = Differences::default();
    let convergence = Convergence::of(&problem.attraction);
    let grids = convergence.grids(problem.profile.is_line());
    let place = Place { range: problem.attraction.range, stiffening: 1.0, ramp: None };
    let half_height = problem.profile.half_height();
    let mut history: Vec<[f64; 7]> = Vec::new();
    let mut coarser: Vec<(usize, State)> = Vec::new();
    loop {
        let (numbers, certificate, fields) = solution::evaluate(&mut equations, &state, report);
        let here = std::mem::take(&mut equations.products);
        products += here;
        work += here * equations.len();
        history.push(numbers.list());
        let nx = equations.grid.nx();
        let stress = numbers.mean_pressure.abs().max(numbers.repulsive_pressure).max(numbers.adhesive_pressure.abs()).max(1e-12);
        let scale = bounds::Scale::new(&equations, stress, half_height);
        let (mut errors, factor) = bounds::of(&history, certificate.spread(), problem, &scale, report.mean_residual);
        errors = bounds::with_edges(errors, problem, &fields);
        let floor = SMALL_FRICTION * stress * half_height;
        let worst_of = |errors: &[f64; 7]| {
            let friction = errors[2] / numbers.friction_stress.abs().max(floor);
            friction.max(errors[1] / numbers.mean_gap.abs().max(half_height)).max(errors[0] / stress) / request.accuracy
        };
        let is_met = |worst: f64| history.len() >= grids && worst <= 1.0 && nx >= request.least_nodes;
        let mut worst = worst_of(&errors);
        if (is_met(worst) || 2 * nx > request.most_nodes) && convergence == Convergence::Edges && bounds::memory_is_unseen(problem, nx) {
            let (shifted, spent) = on_shifted_grid(problem, &equations, &state);
            products += spent;
            work += spent * nx / 2;
            if let (Some(shifted), [.., before, _]) = (shifted, history.as_slice()) {
                errors = std::array::from_fn(|i| errors[i].max((shifted[i] - before[i]).abs()));
            }
            worst = worst_of(&errors);
        }
        let met = is_met(worst);
        let growth = worst.max(1.0).powf(1.0 / 1.5).min(1e6);
        if let Some(before) = &before {
            differences = differences.on_finer_grid(before, &fields, bounds::AGES);
        }
        let last = |nodes: usize| differences.largest(nodes, |age| convergence.weight(age));
        let floors = solution::field_floors(&equations, &report);
        let finish = |met: bool, fields: Fields, products: usize, coarser: Vec<(usize, State)>| SteadyState {
            numbers,
            errors: Numbers::from_list(errors),
            patches: solution::patches(&fields),
            patches_error: before.as_ref().map_or(0, |before| solution::patches(before).abs_diff(solution::patches(&fields))),
            field_errors: with_floors(last(fields.gap.len()), &fields, factor, floors),
            node_products: work,
            certificate,
            fields,
            reached_by,
            accuracy_met: met,
            nodes_needed: ((nx as f64 * growth) as usize).next_power_of_two(),
            products,
            coarser,
        };
        if met || 2 * nx > request.most_nodes {
            if history.len() < 3 {
                return Err(Refusal::NotConverged {
                    what: "the refinement of the grid",
                    detail: format!(
                        "the range needs {nx} nodes and its error two doublings more, but at most {} are allowed",
                        request.most_nodes
                    ),
                });
            }
            return Ok(finish(met, fields, products, coarser));
        }
        let (mut finer, start) = reach::refined(problem, &equations, &state, place);
        let mut next = start.clone();
        let finer_nodes = finer.len();
        let solved = newton::solve(&mut finer, &mut next, newton::FINE, 6000).or_else(|stalled| {
            if motion == Motion::Newton {
                return Err(stalled);
            }
            next.clone_from(&start);
            newton::relax(&mut finer, &mut next, newton::FINE, RELAXATION / finer_nodes)
        });
        match solved {
            Ok(found) if !reach::is_jump(problem, &state, &next) => {
                report = found;
                equations = finer;
                coarser.push((nx, std::mem::replace(&mut state, next)));
                coarser = coarser.split_off(coarser.len().saturating_sub(GRIDS_OF_STABILITY));
                before = Some(fields);
            }
            Ok(_) => {
                return Err(Refusal::NotConverged {
                    what: "the refinement of the grid",
                    detail: format!("the state on {nx} nodes is not the one on {}: the grid was too coarse for this range", 2 * nx),
                });
            }
            // What so many grids agree on is an answer with its error, if not the wanted one; fewer may agree on a state that the next grid has not.
            Err(_) if history.len() >= grids && nx >= request.least_nodes => {
                return Ok(finish(false, fields, products, coarser));
            }
            Err(stalled) => {
                return Err(Refusal::NotConverged {
                    what: "the refinement of the grid",
                    detail: format!("lost from {nx} to {} nodes, residual {:.1e}", 2 * nx, stalled.residual),
                });
            }
        }
    }
}

/// The numbers on the other half of a line's nodes, those that the grid before has not, and the products they took: its edges fall at other places
/// between the nodes. Nothing where the profile has waves that half of the nodes do not carry.
fn on_shifted_grid(problem: &Problem, equations: &Equations, state: &State) -> (Option<[f64; 7]>, usize) {
    let nx = equations.grid.nx() / 2;
    if !problem.profile.is_line() || problem.profile.own_nx() > nx {
        return (None, 0);
    }
    let mut shifted = Equations::new(problem, nx, 1.0, problem.attraction.range);
    shifted.heights = equations.heights.iter().skip(1).step_by(2).copied().collect();
    let mut start = State {
        gap: state.gap.iter().skip(1).step_by(2).copied().collect(),
        contact: state.contact.iter().skip(1).step_by(2).copied().collect(),
        mean_pressure: state.mean_pressure,
    };
    let solved = newton::solve(&mut shifted, &mut start, newton::FINE, 6000);
    let numbers = solved.ok().map(|report| solution::evaluate(&mut shifted, &start, report).0.list());
    (numbers, shifted.products)
}

/// The bounds of fields from their differences, with what rounding and the residual leave; a node in contact has the gap of the wall.
fn with_floors(mut errors: [Vec<f64>; 2], fields: &Fields, factor: f64, floors: [f64; 2]) -> [Vec<f64>; 2] {
    for (which, (errors, floor)) in errors.iter_mut().zip(floors).enumerate() {
        for (error, contact) in errors.iter_mut().zip(&fields.contact) {
            *error *= factor;
            if which == 0 || !*contact || *error > 0.0 {
                *error += floor;
            }
        }
    }
    errors
}
