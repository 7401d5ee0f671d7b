//! One step in time: the stages, their error, and the mesh that they need.

use std::sync::Arc;

use super::chain::{Chain, DIAGONAL, ROWS, STAGES, TIMES, WEIGHTS, dot, error_weights, extrapolation};
use super::drive::{Drive, work};
use super::jump::JUMPED;
use super::mesh::{Mesh, Mesher};
use super::newton::{Contact, Equation, Newton, Row};
use super::problem::{Accuracy, Problem};
use super::refine::Watched;
use super::state::State;
use super::surface::Surface;
use crate::refusal::Refusal;

/// What a node without a side on a hard wall may lie beyond it, over the error of the gap in a step.
const OVERLAP: f64 = 0.1;
/// Finer edges of a hard wall that are tried before a step is shortened, or an equilibrium is searched by a descent.
pub(super) const SHIFTS: usize = 2;
/// Forces smaller than this (in RΔγ) are no scale for the error of a force.
pub(super) const FORCE_SCALE: f64 = 5.0;
/// The work of a step may be wrong by this many tolerances of the step, times the force over its scale.
const WORK_SCALE: f64 = 3.0;
/// Error of a step over that of the pressure at its end foreseen from the stages between: 0.24 for a root at the end, 0.45 for a smooth pressure.
const UNFORESEEN: f64 = 0.3;
/// Part of the error of the gap and the force that an element with a kink of the pressure may make.
const AT_A_KINK: f64 = 0.1;
/// Between two nodes on both sides of the largest tension the gap changes by so many ranges at most.
const WIDEST_FRONT: f64 = 0.5;
/// A correction of the gap that does not fall any more is rounding if it is smaller than this times the scale of the displacements.
const ROUNDING: f64 = 1e-11;
/// The same of the scale of the gap at the outer radius, which is half its square.
const ROUNDING_OF_GAPS: f64 = 1e-13;
/// That scale is at least so many ranges.
const DISPLACEMENT: f64 = 10.0;

/// A step that was solved, with its errors over their tolerances (not yet accepted).
pub(super) struct Trial {
    pub(super) state: State,
    pub(super) error: f64,
    /// Whether only the force at the beginning, which may be that of a coarser mesh, does not suit the stages.
    pub(super) odd_beginning: bool,
    pub(super) stages: Stages,
}

/// The unknown and the penetration of every stage of a step: first guesses of the same step on a finer mesh.
pub(super) struct Stages {
    length: f64,
    unknowns: Vec<Vec<f64>>,
    penetrations: [f64; STAGES],
}

impl Stages {
    /// The same on the mesh of another state.
    pub(super) fn carried(mut self, from: &State, to: &State, mesher: &Mesher, surface: &Surface) -> Self {
        self.unknowns.iter_mut().for_each(|unknown| *unknown = from.carried(unknown, to, mesher, surface));
        self
    }
}

/// The solver of one run.
pub(super) struct Solver<'m> {
    pub(super) mesher: &'m mut Mesher,
    pub(super) surface: Surface,
    pub(super) chain: Chain,
    /// m = (Tabor number)^{3/2}.
    pub(super) coupling: f64,
    pub(super) accuracy: Accuracy,
    pub(super) newton: Newton,
    /// Factor on Newton's tolerance: less than one while an extremum is searched, which noise would shift.
    pub(super) sharpness: f64,
    /// The time of a step at once: while it goes on nothing creeps, and the time of a state is the part of the step that is done.
    pub(super) frozen: Option<f64>,
    /// The nodes of a mesh that was needed and is too fine.
    pub(super) too_fine: Option<usize>,
}

impl<'m> Solver<'m> {
    pub(super) fn new(problem: &Problem, accuracy: Accuracy, mesher: &'m mut Mesher) -> Result<Self, Refusal> {
        let surface = Surface::new(problem.law.clone(), problem.shape.clone(), problem.rim)?;
        let coupling = problem.tabor.powf(1.5);
        Ok(Self {
            mesher,
            surface,
            chain: Chain::new(&problem.creep),
            coupling,
            accuracy,
            newton: Newton::default(),
            sharpness: 1.0,
            frozen: None,
            too_fine: None,
        })
    }

    /// A contact whose creep strains are (a_j + z_j J_j p)/(1 + z_j).
    pub(super) fn contact(
        &mut self,
        state: &State,
        forced: &[Vec<f64>],
        z: &[f64],
        row: Row,
        pseudo: Option<(f64, &[f64])>,
        guess: (&[f64], f64),
    ) -> Option<Contact> {
        let mut history = vec![0.0; state.mesh.nodes()];
        let mut compliance = self.chain.instant;
        for ((a, &z), &(j, _)) in forced.iter().zip(z).zip(&self.chain.terms) {
            history.iter_mut().zip(a).for_each(|(sum, a)| *sum += a / (1.0 + z));
            compliance += j * z / (1.0 + z);
        }
        let (mesh, undeformed) = (&*state.mesh, &*state.undeformed);
        let rounding = (ROUNDING * state.penetration.abs().max(DISPLACEMENT)).max(ROUNDING_OF_GAPS * state.mesh.radius().powi(2));
        let tolerance = self.sharpness * self.accuracy.newton * self.accuracy.step;
        let overlap = OVERLAP * self.accuracy.step;
        let equation = Equation {
            mesh,
            undeformed,
            coupling: self.coupling,
            compliance,
            history: &history,
            pseudo,
            row,
            tolerance,
            overlap,
            rounding,
        };
        let mut contact = self.newton.solve(&self.surface, &equation, guess.0, guess.1)?;
        if row.penetration == 0.0 {
            contact.force = row.value / row.force;
        }
        Some(contact)
    }

    /// One step of length h; nothing if a stage has no solution that Newton's method finds.
    pub(super) fn step(&mut self, from: &State, drive: &Drive, h: f64) -> Option<Trial> {
        self.step_again(from, drive, h, None)
    }

    /// The same, with what was found on a coarser mesh.
    pub(super) fn step_again(&mut self, from: &State, drive: &Drive, h: f64, known: Option<&Stages>) -> Option<Trial> {
        let known = known.filter(|known| known.length.total_cmp(&h).is_eq());
        let (n, terms) = (from.mesh.nodes(), self.chain.terms.clone());
        let creep = self.creep_time(h);
        let z: Vec<f64> = terms.iter().map(|&(_, tau)| DIAGONAL * creep / tau).collect();
        let relax =
            |p: &[f64], v: &[f64], (j, tau): (f64, f64)| p.iter().zip(v).map(|(p, v)| creep * (j * p - v) / tau).collect::<Vec<f64>>();
        // h·dv_j/dt at the stages known so far.
        let mut slopes: Vec<Vec<Vec<f64>>> = vec![terms.iter().zip(&from.strains).map(|(&term, v)| relax(&from.p, v, term)).collect()];
        let (mut gaps, mut depths, mut forces) = (vec![from.u.clone()], [from.penetration; STAGES], [from.force; STAGES]);
        let mut strains = from.strains.clone();
        let mut p = from.p.clone();
        // The last pressure less that of the polynomial through those of the stages between.
        let (unforeseen, mut surprise) = (extrapolation(1..STAGES - 1, 1.0), vec![0.0; n]);
        let mut image = vec![0.0; n];
        let mut viscous = [0.0; STAGES];
        viscous[0] = self.viscous_rate(&from.mesh, &slopes[0], &p, &mut image);
        for stage in 1..STAGES {
            let mut forced = from.strains.clone();
            for (k, slope) in slopes.iter().enumerate().filter(|&(k, _)| ROWS[stage][k] != 0.0) {
                for (a, s) in forced.iter_mut().zip(slope) {
                    a.iter_mut().zip(s).for_each(|(a, s)| *a += ROWS[stage][k] * s);
                }
            }
            let (guess, depth) = match known {
                Some(known) => (known.unknowns[stage].clone(), known.penetrations[stage]),
                None => self.guess(from, &gaps, &depths, stage, h),
            };
            let row = drive.row(from.time + TIMES[stage] * h);
            let contact = self.contact(from, &forced, &z, row, None, (&guess, depth))?;
            for (((v, a), &z), &(j, _)) in strains.iter_mut().zip(&forced).zip(&z).zip(&terms) {
                (0..n).for_each(|i| v[i] = (a[i] + z * j * contact.p[i]) / (1.0 + z));
            }
            slopes.push(terms.iter().zip(&strains).map(|(&term, v)| relax(&contact.p, v, term)).collect());
            (depths[stage], forces[stage]) = (contact.penetration, contact.force);
            viscous[stage] = self.viscous_rate(&from.mesh, &slopes[stage], &contact.p, &mut image);
            gaps.push(contact.u);
            p = contact.p;
            let weight = if stage == STAGES - 1 { -1.0 } else { unforeseen[stage] };
            surprise.iter_mut().zip(&p).for_each(|(sum, p)| *sum += weight * p);
        }
        let gap_error = self.gap_error(&from.mesh, &slopes, &surprise, &z, &mut image);
        let (work, work_error) = work(drive, from, &depths, &forces, h);
        let missing =
            |values: &[f64; STAGES], first: usize| (dot(&extrapolation(first..STAGES - 1, 1.0), values) - values[STAGES - 1]).abs();
        let tolerance = self.accuracy;
        let scale = (forces[STAGES - 1].abs() / FORCE_SCALE).max(1.0);
        let row = drive.row(from.time);
        let seen =
            |first: usize| if row.penetration == 0.0 { missing(&depths, first) } else { missing(&forces, first) / (FORCE_SCALE * scale) };
        let odd_beginning = seen(0) > tolerance.force && seen(1) <= tolerance.force;
        let energy_error = work_error.max(dot(&error_weights(), &viscous).abs());
        let error = (gap_error / tolerance.step).max(seen(0) / tolerance.force).max(energy_error / (WORK_SCALE * scale * tolerance.step));
        let rate: Vec<f64> = (0..n).map(|i| (gaps[STAGES - 1][i] - gaps[STAGES - 2][i]) / ((1.0 - TIMES[STAGES - 2]) * h)).collect();
        let depth_rate = (depths[STAGES - 1] - depths[STAGES - 2]) / ((1.0 - TIMES[STAGES - 2]) * h);
        let state = State {
            mesh: Arc::clone(&from.mesh),
            undeformed: Arc::clone(&from.undeformed),
            time: from.time + h,
            penetration: depths[STAGES - 1],
            force: forces[STAGES - 1],
            u: gaps.last()?.clone(),
            p,
            strains,
            rate: Some((rate, depth_rate)),
            work: from.work + work,
            viscous: from.viscous + dot(&WEIGHTS, &viscous),
            released: from.released,
        };
        let stages = Stages { length: h, unknowns: gaps, penetrations: depths };
        error.is_finite().then_some(Trial { state, error, odd_beginning, stages })
    }

    /// A state that was carried to another mesh, in equilibrium there; nothing if none is found near it.
    pub(super) fn in_equilibrium(&mut self, state: &State, drive: &Drive) -> Option<State> {
        let still = vec![0.0; self.chain.terms.len()];
        let found = self.contact(state, &state.strains, &still, drive.row(state.time), None, (&state.u, state.penetration))?;
        let moved = |(&new, &old): (&f64, &f64)| (self.surface.gap(new) - self.surface.gap(old)).abs();
        let far = found.u.iter().zip(&state.u).map(moved).any(|change| change > JUMPED);
        (!far).then(|| State { u: found.u, p: found.p, penetration: found.penetration, force: found.force, ..state.clone() })
    }

    /// How long the body creeps during a step: not at all in a step at once.
    pub(super) fn creep_time(&self, h: f64) -> f64 {
        if self.frozen.is_some() { 0.0 } else { h }
    }

    /// h·m Σ_j v̇_j·A p.
    fn viscous_rate(&self, mesh: &Mesh, slopes: &[Vec<f64>], p: &[f64], image: &mut [f64]) -> f64 {
        if slopes.is_empty() {
            return 0.0;
        }
        mesh.apply(p, image);
        self.coupling * slopes.iter().map(|slope| mesh.integral(|i| slope[i] * image[i])).sum::<f64>()
    }

    /// The largest error of the gap, filtered as usual for stiff terms: by the embedded weights, which are up to nine times too small where the
    /// pressure is a root in time, as before a fold, and by what the last stage has that those before did not foresee.
    fn gap_error(&self, mesh: &Mesh, slopes: &[Vec<Vec<f64>>], surprise: &[f64], z: &[f64], image: &mut [f64]) -> f64 {
        if z.is_empty() {
            return 0.0;
        }
        let weights = error_weights();
        let mut sum = vec![0.0; mesh.nodes()];
        for (slope, weight) in slopes.iter().zip(weights) {
            for (s, z) in slope.iter().zip(z) {
                sum.iter_mut().zip(s).for_each(|(sum, s)| *sum += weight / (1.0 + z) * s);
            }
        }
        let mut largest = |field: &[f64]| {
            mesh.apply(field, image);
            self.coupling * image.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
        };
        let response: f64 = self.chain.terms.iter().zip(z).map(|(&(j, _), z)| j * z / (DIAGONAL * (1.0 + z))).sum();
        largest(&sum).max(UNFORESEEN * response * largest(surprise))
    }

    /// The first guess of a stage: along the last rate, then through the stages before.
    fn guess(&self, from: &State, gaps: &[Vec<f64>], depths: &[f64; STAGES], stage: usize, h: f64) -> (Vec<f64>, f64) {
        let (mut guess, mut depth) = (from.u.clone(), from.penetration);
        if stage == 1 {
            if let Some((rate, depth_rate)) = &from.rate {
                guess.iter_mut().zip(rate).for_each(|(u, rate)| *u += TIMES[1] * h * rate);
                depth += TIMES[1] * h * depth_rate;
            }
        } else {
            let weights = extrapolation(0..stage, TIMES[stage]);
            guess.fill(0.0);
            depth = 0.0;
            for (k, gap) in gaps.iter().enumerate() {
                guess.iter_mut().zip(gap).for_each(|(u, gap)| *u += weights[k] * gap);
                depth += weights[k] * depths[k];
            }
        }
        for (guess, u) in guess.iter_mut().zip(&gaps[stage - 1]) {
            let reach = self.surface.reach(*u);
            if reach.is_finite() {
                *guess = guess.clamp(u - reach, u + reach);
            }
        }
        (guess, depth)
    }

    /// What the mesh must resolve: the pressure, and every creep strain by the gap that it makes.
    fn watched<'a>(&self, state: &'a State) -> Vec<Watched<'a>> {
        let largest = state.p.iter().fold(0.0_f64, |most, p| most.max(p.abs()));
        let of_integral = self.accuracy.mesh / self.coupling;
        // No mesh follows the square root of the pressure at the edge of a hard wall, or a kink: what it moves, and its force, count.
        let (at_a_kink, of_wide_force) = if self.surface.is_singular() { (AT_A_KINK, self.accuracy.mesh) } else { (0.0, f64::INFINITY) };
        let tolerance = self.accuracy.mesh * (0.1 * largest).max(1.0);
        let of_force = at_a_kink * self.accuracy.mesh;
        let pressure = Watched { values: &state.p, tolerance, of_integral: at_a_kink * of_integral, of_force, of_wide_force };
        let strain = |values| Watched { values, tolerance: 0.0, of_integral, of_force: f64::INFINITY, of_wide_force };
        let mut fields = vec![pressure];
        fields.extend(state.strains.iter().map(|values| strain(values)));
        fields
    }

    /// Elements on which a state is not resolved.
    pub(super) fn unresolved(&self, state: &State) -> Vec<bool> {
        let mut flags = self.mesher.unresolved(&state.mesh, &self.watched(state));
        // A zone of tension between two nodes has no pressure of its own: every place of the front would be in equilibrium.
        let (order, peak) = (self.mesher.order(), self.surface.peak_gap());
        for (i, pair) in state.u.windows(2).enumerate() {
            let [inside, outside] = [0, 1].map(|k| self.surface.gap(pair[k]));
            if (inside <= peak) != (outside <= peak) && (inside - outside).abs() > WIDEST_FRONT {
                flags[i / order] = true;
                flags[(i + 1) / order] = true;
            }
        }
        flags
    }

    /// The state on a mesh without needless elements; nothing if there are none.
    pub(super) fn coarsened(&mut self, state: &State) -> Option<State> {
        let fields = self.watched(state);
        let mesh = self.mesher.merge(&state.mesh, &fields)?;
        Some(state.on(&mesh, self.mesher, &self.surface))
    }

    /// The state with other nodes at the edge of a hard wall, where a node may find no side that suits its neighbours; nothing without one.
    pub(super) fn refined_at_edge(&mut self, state: &State) -> Option<State> {
        let order = self.mesher.order();
        let mut flags = vec![false; state.mesh.cells.len()];
        for (i, pair) in state.u.windows(2).enumerate() {
            if self.surface.touches(pair[0]) != self.surface.touches(pair[1]) {
                flags[i / order] = true;
                flags[(i + 1) / order] = true;
            }
        }
        // Nothing needs these nodes: where they are too many, the step is shortened instead.
        let known = self.too_fine;
        let finer = self.refined_if(state, &flags);
        self.too_fine = known;
        finer
    }

    /// The state with the flagged elements halved.
    pub(super) fn refined(&mut self, state: &State, flags: &[bool]) -> State {
        let mesh = self.mesher.build(Mesher::halved(&state.mesh.cells, flags));
        state.on(&mesh, self.mesher, &self.surface)
    }
}
