//! Error bounds of the numbers of a state from its differences between grids.
//!
//! A contact edge or a kink of the law falls between nodes, so that the coefficient of the error changes its sign from grid to grid and
//! one or two differences may be small by chance. The larger of the last two counts, and of the earlier ones what 1/4 a doubling
//! leaves of them: errors with edges fall like N^−1.5 to N^−2. Where the differences fall more slowly, what is left is a geometric series
//! of their ratio. The friction has a bound beside these: by the profile and by the loss it is the same but for the discretisation.
//! Where the body's shortest memory length lies between the nodes, the coefficient changes with every doubling. There the other half of the nodes,
//! those that the grid before has not, is solved as a grid of its own: its difference from the grid before shows what the places of the edges change.
//! A smooth law without a wall converges faster with every doubling: the last difference times a geometric series of the last ratio bounds
//! what is left of every number but those that part where the stress changes its sign.

use super::grid::Equations;
use super::problem::{Control, Problem};
use super::solution::Fields;
use crate::finite_range::law::Attraction;

/// What a doubling of the grid leaves of an error of a number, with edges.
const DECAY: f64 = 0.25;
/// The same of a field next to an edge: 2^−1.5.
const DECAY_OF_FIELDS: f64 = 0.353_553_390_593_273_8;
/// The largest ratio of differences that counts: a larger one is chance.
const SLOWEST: f64 = 0.75;
/// Differences that count: the earliest grids of a search are too coarse to say anything.
pub(super) const AGES: usize = 4;
/// Safety factor of a geometric series.
pub(super) const SAFETY: f64 = 4.0;
/// A change of the modulus over an octave that counts.
const UNSEEN: f64 = 0.05;
/// A number whose difference is small by chance takes this part of the largest relative difference.
const SHARED: f64 = 0.25;
/// Places of the numbers in a list.
const PRESSURE: usize = 0;
const GAP: usize = 1;
const FRICTION: usize = 2;
const CONTACT: usize = 3;
const ADHESIVE: usize = 4;
const REPULSIVE: usize = 5;
const ENERGY: usize = 6;

/// How differences between grids fall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Convergence {
    /// Contact edges, or kinks of the law.
    Edges,
    /// A smooth law without a wall.
    Smooth,
}

impl Convergence {
    pub(super) fn of(law: &Attraction) -> Self {
        if law.wall().is_none() && law.kinks().is_empty() { Self::Smooth } else { Self::Edges }
    }

    /// Grids that an accuracy takes to be met. With edges two differences may both be small by chance; a surface costs too much for a fourth grid.
    pub(super) const fn grids(self, is_line: bool) -> usize {
        if is_line && matches!(self, Self::Edges) { 4 } else { 3 }
    }

    /// How much counts of a difference of a field of an age (0: the last).
    pub(super) fn weight(self, age: usize) -> f64 {
        match self {
            Self::Edges => weight(DECAY_OF_FIELDS, age),
            Self::Smooth => f64::from(u8::from(age == 0)),
        }
    }
}

/// The last two differences count as they are.
fn weight(decay: f64, age: usize) -> f64 {
    decay.powi(age.saturating_sub(1) as i32)
}

/// What is left over the last difference where differences fall slowly: the rest of a geometric series of their ratio, over two doublings where it is known.
fn left(newest_first: &[[f64; 7]], i: usize) -> f64 {
    let ratio = match newest_first {
        [a, _, c, ..] => (a[i] / c[i]).sqrt(),
        [a, b] => a[i] / b[i],
        _ => SLOWEST,
    };
    let ratio = ratio.min(SLOWEST);
    (ratio / (1.0 - ratio)).max(1.0)
}

/// Whether the modulus still changes over the octave beyond the highest wave of a grid: then the grid sees another body next to an edge than finer
/// ones do, and two differences in a row may be small by chance.
pub(super) fn memory_is_unseen(problem: &Problem, nx: usize) -> bool {
    let highest = problem.speed * 0.5 * nx as f64;
    let (seen, beyond) = ((problem.modulus)(highest), (problem.modulus)(2.0 * highest));
    (beyond - seen).norm() > UNSEEN * seen.norm()
}

/// What numbers are compared with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    /// The largest of the mean pressure and its two parts.
    pub(super) stress: f64,
    /// Half of the peak-to-valley height.
    pub(super) half_height: f64,
    /// The largest n Im K: the loss of a wave over the square of its pressure.
    pub(super) loss: f64,
}

impl Scale {
    pub(super) fn new(equations: &Equations, stress: f64, half_height: f64) -> Self {
        let (nx, ny, nodes) = (equations.grid.nx(), equations.grid.ny(), equations.len() as f64);
        let of_wave = |(entry, a): (usize, &rustfft::num_complex::Complex64)| {
            let number = entry / ny;
            if number == 0 || 2 * number >= nx { 0.0 } else { number as f64 * a.inv().im.abs() / nodes }
        };
        Self { stress, half_height, loss: equations.stiffness.iter().enumerate().map(of_wave).fold(0.0, f64::max) }
    }

    /// The error of the friction Σ n Im K |p|² from an error of the pressure.
    pub(super) fn of_friction(&self, friction: f64, pressure: f64) -> f64 {
        2.0 * (friction.abs() * self.loss).sqrt() * pressure + self.loss * pressure * pressure + 64.0 * f64::EPSILON * friction.abs()
    }
}

/// The bound of each number, and the factor from the last differences of a field to its bounds.
/// `spread`: the difference between the friction by the loss and that by the profile.
pub(super) fn of(history: &[[f64; 7]], spread: f64, problem: &Problem, scale: &Scale, residual: f64) -> ([f64; 7], f64) {
    let [.., before, last] = history else { return ([f64::INFINITY; 7], 1.0) };
    if history.len() < 3 {
        return ([f64::INFINITY; 7], 1.0);
    }
    let differences: Vec<[f64; 7]> =
        history.windows(2).rev().take(AGES).map(|pair| std::array::from_fn(|i| (pair[1][i] - pair[0][i]).abs())).collect();
    let grids = Convergence::Edges.grids(problem.profile.is_line());
    // Of fewer grids than an accuracy takes both differences may be small by chance.
    let few = if history.len() < grids { SAFETY } else { 1.0 };
    let envelope = |i: usize| {
        let largest = differences.iter().enumerate().map(|(age, list)| weight(DECAY, age) * list[i]).fold(0.0, f64::max);
        few * left(&differences, i) * largest
    };
    let units = [scale.stress, scale.half_height, scale.stress * scale.half_height];
    let convergence = Convergence::of(&problem.attraction);
    let mut factor = 1.0;
    let mut errors: [f64; 7] = match convergence {
        Convergence::Edges => std::array::from_fn(envelope),
        Convergence::Smooth => {
            let size = |list: &[f64; 7]| (0..3).map(|i| list[i] / units[i]).fold(0.0, f64::max);
            let ratio = size(&differences[0]) / size(&differences[1]);
            factor = if ratio < 0.5 { (SAFETY * ratio / (1.0 - ratio)).min(SAFETY) } else { SAFETY };
            let parts = [CONTACT, ADHESIVE, REPULSIVE];
            std::array::from_fn(|i| if parts.contains(&i) { envelope(i) } else { factor * differences[0][i] })
        }
    };
    errors[FRICTION] = errors[FRICTION].max(spread);
    // All numbers come from one discrete edge.
    let largest = SHARED * (0..3).map(|i| errors[i] / units[i]).fold(0.0, f64::max);
    // The energy changes with the gap by the tension: its last difference alone may be small by chance.
    if convergence == Convergence::Smooth {
        errors[ENERGY] = errors[ENERGY].max(largest / SHARED * scale.half_height * last[ADHESIVE].abs());
    }
    let units = [scale.stress, scale.half_height, last[FRICTION].abs(), 0.0, last[ADHESIVE].abs(), scale.stress, last[ENERGY].abs()];
    for (error, unit) in errors.iter_mut().zip(units) {
        *error = error.max(largest * unit);
    }
    match problem.control {
        Control::MeanPressure(_) => errors[PRESSURE] = (last[PRESSURE] - before[PRESSURE]).abs(),
        Control::MeanGap(_) => errors[GAP] = (last[GAP] - before[GAP]).abs(),
        Control::Frame { .. } => {}
    }
    for (i, error) in errors.iter_mut().enumerate() {
        *error += if i == FRICTION { scale.of_friction(last[FRICTION], 10.0 * residual) } else { 10.0 * residual };
    }
    if !problem.attraction.attracts() {
        errors[ADHESIVE] = 0.0;
        errors[ENERGY] = 0.0;
    }
    (errors, factor)
}

/// The same, with what the places of contact edges between the nodes leave of the contact fraction: each of a line's few edges may be a cell off,
/// the many of a surface lie at random in theirs.
pub(super) fn with_edges(mut errors: [f64; 7], problem: &Problem, fields: &Fields) -> [f64; 7] {
    if problem.attraction.wall().is_some() {
        let row = |row: &[bool]| row.iter().zip(row.iter().cycle().skip(1)).filter(|(a, b)| a != b).count();
        let edges: usize = fields.contact.chunks(fields.nx).map(row).sum();
        let cells = if fields.ny == 1 { edges as f64 } else { (edges as f64 / 12.0).sqrt() };
        errors[CONTACT] += cells / fields.contact.len() as f64;
    }
    errors
}
