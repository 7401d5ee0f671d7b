//! Equilibria that Newton's method does not reach: starts, and jumps over a fold.
//!
//! The state slides down its instantaneous energy in the metric A⁻¹, by implicit steps of pseudo-time 1/λ, the mesh following the edge;
//! physically one more uniform Kelvin–Voigt element of vanishing time. The landing does not depend on how λ is chosen.

use super::drive::Drive;
use super::newton::Row;
use super::state::State;
use super::step::{FORCE_SCALE, SHIFTS, Solver};
use crate::refusal::Refusal;

/// Steps of pseudo-time after which the search is given up: a front that crosses a flat face takes one for a part of its own width.
const DESCENT_STEPS: usize = 5000;
/// Steps between attempts to coarsen, the tolerance of the mesh, at least, and its part of the nodes: only the landing must be resolved.
const COARSEN_EVERY: usize = 3;
const OF_A_DESCENT: f64 = 0.1;
const NODES_OF_A_DESCENT: usize = 4;
/// λ at which the search is given up.
const STIFFEST: f64 = 1e7;
/// The least λ.
const SOFTEST: f64 = 1e-9;
/// The surfaces count as parted for good when the smallest gap is this far beyond the largest tension.
const PARTED: f64 = 4.0;
/// A change of the gap (in h₀) that makes a step a jump.
pub(super) const JUMPED: f64 = 0.05;
/// A steady state changes in a step less than so many times what it changes in a third of it.
const STEADY: f64 = 4.0;

/// The forces of one equilibrium on two meshes differ by less than so many tolerances of a step.
const SAME: f64 = 2.0;
/// Steps of pseudo-time after which one on a finer mesh is given up.
const PATIENT: usize = 40;

/// Lengths of the step over a jump that are tried, each so many times the one before.
const LENGTHS: usize = 20;
const LONGER: f64 = 3.0;

/// An implicit Euler step of length h that found an equilibrium, and where it began on the mesh of that.
struct Landed {
    h: f64,
    time: f64,
    state: State,
    old: State,
}

/// An equilibrium whose mesh should be finer.
struct Equilibrium {
    state: State,
    turn: usize,
    /// Whether the mesh before has it as well.
    is_known: bool,
}

/// An implicit Euler step over a jump.
pub(super) struct Landing {
    pub(super) state: State,
    /// Energy lost in it.
    pub(super) released: f64,
    /// Whether the gap changed more than time explains; else Newton's method had given up before a fold, and this is a step.
    pub(super) jumped: bool,
}

impl Solver<'_> {
    /// The equilibrium below a state: strains go to (v_j + z_j J_j p)/(1 + z_j). Nothing if there is none.
    pub(super) fn settle(&mut self, start: &State, z: &[f64], row: Row) -> Option<State> {
        let mut state = start.clone();
        state.rate = None;
        let (mut lambda, mut still) = (1.0, 0);
        // Once an equilibrium was found its mesh is only refined: else what is coarsened on the way would be refined for ever.
        let (mut plain, mut last, mut shifted): (bool, Option<Equilibrium>, usize) = (true, None, 0);
        for turn in 0..DESCENT_STEPS {
            // An equilibrium that two meshes have exists, though on a finer one the nodes at the edge of a wall find none: the steps from it refine it.
            if let Some(known) = last.take_if(|known| known.is_known && self.surface.has_wall() && turn > known.turn + PATIENT) {
                return Some(self.strained(known.state, z));
            }
            let strains = state.strains.clone();
            if plain || still >= 3 {
                if let Some(found) = self.contact(&state, &strains, z, row, None, (&state.u, state.penetration)) {
                    (state.u, state.p, state.penetration, state.force) = (found.u, found.p, found.penetration, found.force);
                    let flags = self.unresolved(&state);
                    let finer = self.refined_if(&state, &flags);
                    let Some(finer) = finer else {
                        return Some(self.lean(self.strained(state, z)));
                    };
                    let allowed = SAME * self.accuracy.step * state.force.abs().max(FORCE_SCALE);
                    let is_known = last.as_ref().is_some_and(|before| (before.state.force - state.force).abs() <= allowed);
                    (last, shifted) = (Some(Equilibrium { state, turn, is_known }), 0);
                    state = finer;
                    continue;
                }
                // Beside an equilibrium it is the nodes at the edge of a wall that find none: other ones may.
                if last.is_some()
                    && shifted < SHIFTS
                    && let Some(finer) = self.refined_at_edge(&state)
                {
                    (state, shifted) = (finer, shifted + 1);
                    continue;
                }
                (plain, still) = (false, 0);
            }
            let old = state.u.clone();
            // A penetration that is free has a damper too: the frame and the weight fall no faster than the surfaces part.
            let damper = lambda * row.force * 2.0 / self.coupling;
            let damped = Row { penetration: row.penetration + damper, value: row.value + damper * state.penetration, ..row };
            let Some(found) = self.contact(&state, &strains, z, damped, Some((lambda, &old)), (&state.u, state.penetration)) else {
                lambda *= 4.0;
                if lambda > STIFFEST {
                    return None;
                }
                continue;
            };
            let moved = |&(&u, &old): &(&f64, &f64)| (self.surface.gap(u) - self.surface.gap(old)).abs() / (0.5 * old).max(1.0);
            let change = found.u.iter().zip(&old).map(|pair| moved(&pair)).fold(0.0, f64::max);
            (state.u, state.p, state.penetration, state.force) = (found.u, found.p, found.penetration, found.force);
            if row.penetration == 0.0 && row.value < 0.0 && self.parted(&state) {
                return None;
            }
            still = if change < 0.01 { still + 1 } else { 0 };
            lambda = (lambda
                / if change < 0.01 {
                    10.0
                } else if change < 0.15 {
                    3.0
                } else {
                    1.0
                })
            .max(SOFTEST);
            state = self.followed(state, last.is_none() && turn % COARSEN_EVERY == 0);
        }
        None
    }

    /// A state of the descent on the mesh that its front needs; what the front has left needs no elements any more. Where too many are needed it goes
    /// on without: the landing decides.
    fn followed(&mut self, mut state: State, coarsen: bool) -> State {
        // Creep strains are kept as they are known.
        if coarsen && let Some(coarser) = self.coarsened(&state) {
            state = coarser;
        }
        let (accuracy, too_fine) = (self.accuracy, self.too_fine);
        self.accuracy.mesh = accuracy.mesh.max(OF_A_DESCENT);
        self.accuracy.most_nodes = accuracy.most_nodes / NODES_OF_A_DESCENT;
        let flags = self.unresolved(&state);
        if let Some(finer) = self.refined_if(&state, &flags) {
            state = finer;
        }
        (self.accuracy, self.too_fine) = (accuracy, too_fine);
        state
    }

    /// The state on a finer mesh, if an element is flagged that can still be halved.
    pub(super) fn refined_if(&mut self, state: &State, flags: &[bool]) -> Option<State> {
        if !flags.contains(&true) {
            return None;
        }
        let nodes = state.mesh.nodes() + self.mesher.order() * flags.iter().filter(|&&flag| flag).count();
        if nodes > self.accuracy.most_nodes {
            self.too_fine = Some(nodes);
            return None;
        }
        let finer = self.refined(state, flags);
        (finer.mesh.cells != state.mesh.cells).then_some(finer)
    }

    /// Refuses to go on where a mesh was needed that is too fine.
    pub(super) fn fine_enough(&self, time: f64) -> Result<(), Refusal> {
        self.too_fine.map_or(Ok(()), |nodes| {
            let detail = format!(
                "{nodes} nodes are needed at time {time}, {} are the most: a wide contact with a short range, or a hard wall; a looser accuracy needs fewer",
                self.accuracy.most_nodes
            );
            Err(Refusal::NotConverged { what: "the mesh", detail })
        })
    }

    /// The state without needless elements.
    fn lean(&mut self, mut state: State) -> State {
        while let Some(coarser) = self.coarsened(&state) {
            state = coarser;
        }
        state
    }

    fn parted(&self, state: &State) -> bool {
        state.u.iter().all(|&u| self.surface.gap(u) > self.surface.peak_gap() + PARTED)
    }

    /// The state with its strains advanced.
    pub(super) fn strained(&self, mut state: State, z: &[f64]) -> State {
        for ((v, &z), &(j, _)) in state.strains.iter_mut().zip(z).zip(&self.chain.terms) {
            v.iter_mut().zip(&state.p).for_each(|(v, p)| *v = (*v + z * j * p) / (1.0 + z));
        }
        state
    }

    /// An implicit Euler step of length h and then, if it is no jump, of growing length, until the state has jumped. Where it has moved as far without a
    /// jump there was no fold: the longest step whose error is allowed is returned, which goes no further than the next instant that is asked for.
    pub(super) fn jump(&mut self, from: &State, drive: &Drive, mut h: f64, instant: f64, end: f64) -> Option<Landing> {
        let (mut straight, mut is_straight): (Option<Landed>, bool) = (None, true);
        // The change of the gap in the step before.
        let mut before: Option<f64> = None;
        for _ in 0..LENGTHS {
            let last = if straight.is_some() { instant } else { end };
            let is_last = h >= last - from.time;
            let time = if is_last { last } else { from.time + h };
            h = h.min(last - from.time);
            let z: Vec<f64> = self.chain.terms.iter().map(|&(_, tau)| self.creep_time(h) / tau).collect();
            let (row, too_fine) = (drive.row(time), self.too_fine);
            let state = self.settle(from, &z, row);
            if straight.is_some() && (state.is_none() || self.too_fine != too_fine) {
                // The shorter step is good as it is.
                self.too_fine = too_fine;
                break;
            }
            let Some(state) = state else {
                // Pulled by a force the surfaces have parted; else the step is too close to the fold, where the descent is endlessly slow.
                if row.penetration == 0.0 && row.value < 0.0 || is_last || self.too_fine.is_some() {
                    return None;
                }
                h *= LONGER;
                continue;
            };
            let old = from.on(&state.mesh, self.mesher, &self.surface);
            let change =
                state.u.iter().zip(&old.u).fold(0.0_f64, |most, (&u, &old)| most.max((self.surface.gap(u) - self.surface.gap(old)).abs()));
            let landed = Landed { h, time, state, old };
            if change > before.map_or(JUMPED, |before| JUMPED.max(STEADY * before)) {
                return Some(self.booked(from, landed, true));
            }
            before = Some(change);
            is_straight = is_straight && straight.as_ref().is_none_or(|shorter| self.is_even(from, shorter, &landed));
            if is_straight {
                straight = Some(landed);
            }
            if change > JUMPED || is_last || !is_straight && time >= instant {
                break;
            }
            h *= LONGER;
        }
        straight.map(|landed| self.booked(from, landed, false))
    }

    /// Whether a step continues a shorter one from the same state so straight that its error is allowed: what they disagree by is 4/3 of it.
    fn is_even(&self, from: &State, shorter: &Landed, longer: &Landed) -> bool {
        let ratio = longer.h / shorter.h;
        let near = shorter.state.on(&longer.state.mesh, self.mesher, &self.surface);
        let gap = |state: &State, i: usize| self.surface.gap(state.u[i]);
        let ahead = |i: usize| gap(&longer.old, i) + ratio * (gap(&near, i) - gap(&longer.old, i));
        let nodes = 0..longer.state.u.len();
        let by_gap = nodes.fold(0.0_f64, |most, i| most.max((gap(&longer.state, i) - ahead(i)).abs()));
        let force = from.force + ratio * (shorter.state.force - from.force);
        let by_force = (longer.state.force - force).abs() / longer.state.force.abs().max(FORCE_SCALE);
        by_gap.max(by_force) <= self.accuracy.step
    }

    /// Time, work and energies of a landing.
    fn booked(&self, from: &State, landed: Landed, jumped: bool) -> Landing {
        let Landed { time, state: mut landed, old, .. } = landed;
        let work = 0.5 * (landed.force + from.force) * (landed.penetration - from.penetration);
        let mut image = vec![0.0; landed.mesh.nodes()];
        landed.mesh.apply(&landed.p, &mut image);
        let crept = |i: usize| landed.strains.iter().zip(&old.strains).map(|(new, old)| new[i] - old[i]).sum::<f64>();
        let viscous = self.coupling * landed.mesh.integral(|i| crept(i) * image[i]);
        let energy = |state: &State| state.instantaneous(&self.surface, &self.chain, self.coupling);
        let released = work - viscous - (energy(&landed) - energy(from));
        landed.time = time;
        landed.work = from.work + work;
        landed.viscous = from.viscous + viscous;
        // What a step loses that is no jump is its error, which the balance of energy is to show.
        landed.released = from.released + if jumped { released } else { 0.0 };
        Landing { state: landed, released, jumped }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::book::Book;
    use super::super::integration::run;
    use super::super::mesh::Mesher;
    use super::super::problem::{Accuracy, Control, Creep, Leg, Motion, Problem, Start};
    use super::*;
    use crate::finite_range::law::{Attraction, Law};

    #[test]
    fn where_there_is_no_fold_a_step_is_returned_and_no_jump() {
        for law in [Law::LennardJones, Law::Exponential, Law::Dugdale { ramp: 0.2 }] {
            let accuracy = Accuracy::of_law(1e-3, &Attraction::new(law.clone(), 1.0, 1.0).unwrap());
            let mut mesher = Mesher::new(accuracy.order);
            let creep = Creep { stiffening: 10.0, fractions: vec![0.4, 0.6], times: vec![1.0, 0.2] };
            let pulled = Leg { control: Control::Penetration, motion: Motion::Ramp { to: -1.0, duration: 5.0 } };
            let mut problem = Problem::new(law.clone(), 0.8, creep, Start::Relaxed(3.0), vec![pulled]);
            let (mut solver, state, _) = Book::open(&problem, accuracy, &mut mesher).unwrap();
            let drive = Drive::new(pulled, &state);
            let landing = solver.jump(&state, &drive, 1e-9, 5.0, 5.0).unwrap();
            assert!(!landing.jumped, "{law:?}");
            let time = landing.state.time;
            assert!(time > 1e-4, "{law:?}: a step of {time}, though longer ones are as straight");
            problem.instants = vec![time];
            let exact = run(&problem, accuracy.tightened(), &mut mesher).unwrap().at(time).unwrap().force;
            let off = (landing.state.force - exact).abs() / exact.abs().max(FORCE_SCALE);
            assert!(off < 2.0 * accuracy.step, "{law:?}: {} instead of {exact}, {off:e}", landing.state.force);
        }
    }
}
