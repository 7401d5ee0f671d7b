//! The equations on one grid, and their linear part for the iterative solver.
//!
//! With the gap g, the profile h, the stiffness A (see [`super::problem`]), the mean pressure P and the law's stress s:
//! ```text
//! pressure      p = A(g + h) + P
//! off contact   p = s(g)                         contact: g = wall, p − s(wall) ≥ 0
//! control       a·mean(g) + b·P = c
//! ```
//! A law without a hard wall has no contact set: its repulsion is part of s.

use super::fourier::Transform;
use super::gmres::LinearSystem;
use super::problem::Problem;
use crate::finite_range::law::{Attraction, Law};
use rustfft::num_complex::Complex64;

/// The shift of the preconditioner 1/(A + shift): one wave of a half-space has A = 1.
const SHIFT: f64 = 1.0;

/// Steps to a gap of a wanted repulsion, and the length of those towards it over the range.
const REPULSION_STEPS: usize = 40;
const REPULSION_STEP: f64 = 0.04;

/// A state on one grid.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    /// Gap at the nodes.
    pub(super) gap: Vec<f64>,
    /// Nodes in contact with the hard wall.
    pub(super) contact: Vec<bool>,
    /// Mean pressure.
    pub(super) mean_pressure: f64,
}

impl State {
    /// Mean gap.
    pub(super) fn mean_gap(&self) -> f64 {
        mean(&self.gap)
    }
}

/// The equations on one grid for one law, stiffness and control.
#[derive(Clone)]
pub(super) struct Equations {
    pub(super) grid: Transform,
    pub(super) heights: Vec<f64>,
    pub(super) law: Attraction,
    /// a, b, c of the control.
    pub(super) row: [f64; 3],
    /// A over the number of nodes.
    pub(super) stiffness: Vec<Complex64>,
    /// 1/(A + shift) over the number of nodes, zero for the mean.
    softness: Vec<Complex64>,
    /// Largest |A|.
    pub(super) stiffest: f64,
    /// Products with the matrix, and transforms of any kind, so far.
    pub(super) products: usize,
    wall: f64,
    /// −s′(g) off contact; NaN marks a node in contact.
    law_stiffness: Vec<f64>,
    free: Vec<bool>,
    scaling: Option<Vec<f64>>,
    /// 1/(A + the law's mean stiffness where it repels) over the number of nodes.
    stiff_softness: Vec<Complex64>,
    work: Vec<f64>,
    spare: Vec<f64>,
}

impl Equations {
    /// The equations of a problem on a grid of `nx` nodes along x, with the modulus to the power `stiffening` and the given range.
    pub(super) fn new(problem: &Problem, nx: usize, stiffening: f64, range: f64) -> Self {
        let mut grid = Transform::new(nx, problem.profile.rows(nx));
        let heights = problem.profile.on_grid(&mut grid);
        let n = grid.len();
        let mut law = problem.attraction.clone();
        law.range = range;
        let mut equations = Self {
            heights,
            law,
            row: problem.control.row(),
            stiffness: Vec::new(),
            softness: Vec::new(),
            stiffest: 0.0,
            products: 0,
            wall: 0.0,
            law_stiffness: vec![0.0; n],
            free: vec![true; n],
            scaling: None,
            stiff_softness: Vec::new(),
            work: vec![0.0; n],
            spare: vec![0.0; n],
            grid,
        };
        equations.set_stiffness(problem, stiffening);
        equations.set_range(range);
        equations
    }

    /// Another power of the modulus.
    pub(super) fn set_stiffness(&mut self, problem: &Problem, stiffening: f64) {
        let nodes = self.len() as f64;
        let symbol = problem.stiffness(&self.grid, stiffening);
        self.stiffest = symbol.iter().map(|a| a.norm()).fold(0.0, f64::max);
        self.softness = symbol.iter().map(|a| ((a + SHIFT) * nodes).inv()).collect();
        self.softness[0] = Complex64::default();
        self.stiffness = symbol.into_iter().map(|a| a / nodes).collect();
    }

    /// Another range of the law, at the same work of adhesion.
    pub(super) fn set_range(&mut self, range: f64) {
        self.law.range = range;
        self.wall = self.law.wall().unwrap_or(f64::NEG_INFINITY);
    }

    /// The stress at a gap; beyond the wall, where a step may lead for a while, that of the wall.
    pub(super) fn stress(&self, gap: f64) -> f64 {
        self.law.stress(gap.max(self.wall))
    }

    /// Another range of the law, and the gaps of a state at which the new law repels as the old one did: the steep part of a law without a wall.
    pub(super) fn set_range_of(&mut self, state: &mut State, range: f64) {
        let old = self.law.clone();
        self.set_range(range);
        if self.wall.is_finite() {
            return;
        }
        let (before, after) = (old.equilibrium_gap(), self.law.equilibrium_gap());
        for gap in state.gap.iter_mut().filter(|gap| **gap < before) {
            let wanted = old.stress(*gap);
            let mut next = after;
            for _ in 0..REPULSION_STEPS {
                // From below the root these steps stay below it: repulsion is convex.
                let lack = self.law.stress(next) - wanted;
                next -= if lack < 0.0 { REPULSION_STEP * range } else { lack / self.law.slope(next) };
            }
            *gap = next;
        }
    }

    /// Another ramp of a Dugdale law; other laws have none.
    pub(super) fn set_ramp(&mut self, wanted: Option<f64>) {
        if let (Law::Dugdale { ramp }, Some(wanted)) = (&mut self.law.law, wanted) {
            *ramp = wanted;
        }
    }

    /// The gap of the hard wall, minus infinity for a law without one.
    pub(super) const fn wall(&self) -> f64 {
        self.wall
    }

    /// Nodes.
    pub(super) const fn len(&self) -> usize {
        self.grid.len()
    }

    /// The pressure A(g + h) + P of a state.
    pub(super) fn pressure(&mut self, state: &State, out: &mut [f64]) {
        for (sum, (g, h)) in self.work.iter_mut().zip(state.gap.iter().zip(&self.heights)) {
            *sum = g + h;
        }
        self.products += 1;
        self.grid.apply(&self.stiffness, &self.work, out);
        out.iter_mut().for_each(|p| *p += state.mean_pressure);
    }

    /// What the control still lacks.
    pub(super) fn control_residual(&self, state: &State) -> f64 {
        self.row[2] - self.row[0] * state.mean_gap() - self.row[1] * state.mean_pressure
    }

    /// Takes the linear part at a state.
    pub(super) fn linearise(&mut self, state: &State) {
        for i in 0..self.len() {
            self.free[i] = !state.contact[i];
            self.law_stiffness[i] = if self.free[i] { -self.law.slope(state.gap[i].max(self.wall)) } else { 0.0 };
        }
        self.scale();
    }

    /// Adds a stiffness to every node off contact.
    pub(super) fn damp(&mut self, stiffness: f64) {
        for (k, free) in self.law_stiffness.iter_mut().zip(&self.free) {
            *k += if *free { stiffness } else { 0.0 };
        }
        self.scale();
    }

    /// Splits the nodes, smoothly, into soft ones and those where a spring stiffer than one wave of the body stands (repulsion without a wall).
    /// The squares of both parts add up to one; each part has a preconditioner of its own, 1/(A + shift) and 1/(A + the springs' mean).
    fn scale(&mut self) {
        let steepest = self.law_stiffness.iter().copied().fold(0.0, f64::max);
        self.scaling = (steepest > SHIFT).then(|| self.law_stiffness.iter().map(|k| (SHIFT / (SHIFT + k.max(0.0))).sqrt()).collect());
        let Some(scaling) = &self.scaling else { return };
        let stiff = || scaling.iter().map(|s| 1.0 - s * s);
        let logarithms: f64 = stiff().zip(&self.law_stiffness).map(|(part, k)| part * k.max(SHIFT).ln()).sum();
        let spring = (logarithms / stiff().sum::<f64>()).exp();
        let nodes = self.grid.len() as f64;
        self.stiff_softness = self.stiffness.iter().map(|a| (nodes * (a * nodes + spring)).inv()).collect();
    }
}

/// Disturbances at a held mean gap: zero in contact, zero in the mean.
impl Equations {
    /// Takes from a field what the wall and the held mean gap forbid.
    pub(super) fn onto_held_gap(&self, field: &mut [f64]) {
        let free = self.free.iter().filter(|free| **free).count().max(1) as f64;
        let middle = field.iter().zip(&self.free).filter(|(_, free)| **free).map(|(v, _)| v).sum::<f64>() / free;
        field.iter_mut().zip(&self.free).for_each(|(v, free)| *v = if *free { *v - middle } else { 0.0 });
    }

    /// A symmetric positive operator of the size of the inverse: it leaves a stiffness that only loses energy on the right of the imaginary axis.
    pub(super) fn positive_softness(&self) -> Vec<Complex64> {
        let nodes = self.len() as f64;
        let mut symbol: Vec<Complex64> =
            self.stiffness.iter().map(|a| Complex64::from(((a.norm() * nodes + SHIFT) * nodes).recip())).collect();
        symbol.iter_mut().take(1).for_each(|mean| *mean = Complex64::default());
        symbol
    }

    /// The linear part times that operator, among these disturbances.
    pub(super) fn held_gap_product(&mut self, softness: &[Complex64], input: &[f64], output: &mut [f64]) {
        let scale = |scaling: &Option<Vec<f64>>, i: usize| scaling.as_ref().map_or(1.0, |s| s[i]);
        self.products += 1;
        self.work.iter_mut().enumerate().for_each(|(i, w)| *w = input[i] * scale(&self.scaling, i));
        self.grid.apply(softness, &self.work, output);
        output.iter_mut().enumerate().for_each(|(i, v)| *v *= scale(&self.scaling, i));
        self.onto_held_gap(output);
        self.work.copy_from_slice(output);
        self.grid.apply(&self.stiffness, &self.work, output);
        output.iter_mut().zip(self.work.iter().zip(&self.law_stiffness)).for_each(|(v, (z, k))| *v += k * z);
        self.onto_held_gap(output);
    }
}

impl LinearSystem for Equations {
    fn multiply(&mut self, input: &[f64], output: &mut [f64]) {
        let n = self.len();
        let border = (n as f64).sqrt();
        let pressure = input[n] * border;
        self.products += 1;
        self.grid.apply(&self.stiffness, &input[..n], &mut output[..n]);
        for i in 0..n {
            output[i] = if self.free[i] { output[i] + pressure + self.law_stiffness[i] * input[i] } else { 0.0 };
        }
        output[n] = (self.row[0] * mean(&input[..n]) + self.row[1] * pressure) * border;
    }

    fn precondition(&mut self, input: &[f64], output: &mut [f64]) {
        let n = self.len();
        let border = (n as f64).sqrt();
        match &self.scaling {
            Some(scaling) => self.work.iter_mut().zip(input.iter().zip(scaling)).for_each(|(w, (v, s))| *w = v * s),
            None => self.work.copy_from_slice(&input[..n]),
        }
        // The mean of the gap and the mean pressure together: shift·m + P = m₀, a·m + b·P = r.
        let (m0, r) = (mean(&self.work), input[n] / border);
        let [a, b, _] = self.row;
        let shift = if (SHIFT * b - a).abs() >= (SHIFT * b + a).abs() { SHIFT } else { -SHIFT };
        let mean_gap = (b * m0 - r) / (shift * b - a);
        self.grid.apply(&self.softness, &self.work, &mut output[..n]);
        for i in 0..n {
            let scale = self.scaling.as_ref().map_or(1.0, |s| s[i]);
            output[i] = if self.free[i] { (output[i] + mean_gap) * scale } else { 0.0 };
        }
        if let Some(scaling) = &self.scaling {
            let stiff = |s: &f64| (1.0 - s * s).sqrt();
            self.work.iter_mut().zip(input.iter().zip(scaling)).for_each(|(w, (v, s))| *w = v * stiff(s));
            self.grid.apply(&self.stiff_softness, &self.work, &mut self.spare);
            let nodes = output.iter_mut().zip(&self.spare).zip(scaling).zip(&self.free);
            nodes.for_each(|(((v, z), s), free)| *v += if *free { z * stiff(s) } else { 0.0 });
        }
        output[n] = (shift * r - a * m0) / (shift * b - a) / border;
        output[n] = if output[n].is_finite() { output[n] } else { 0.0 };
    }
}

/// The mean of some values.
pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
