//! The place of a fold, with its error from three grids.
//!
//! Around the fold one quantity (gap or pressure) runs straight through while the other turns. Seven states at equal steps of the
//! first are fitted by a quartic: it smooths the noise of edges that pass from node to node, which a local search would follow.

use super::bounds::{self, Convergence};
use super::branch::{FoldKind, RoughFold};
use super::grid::{Equations, State};
use super::newton;
use super::problem::{Control, Problem};
use super::reach::{self, Place};
use super::solution::{self, Numbers};
use crate::refusal::Refusal;

/// States on each side of the middle one.
const SIDE: i32 = 3;
/// Relative misfit of the turning quantity below which closer samples would gain nothing.
const FLAT: f64 = 1e-7;
/// Grids, each twice as fine as the one before.
const GRIDS: usize = 3;

/// A located fold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fold {
    /// What turns.
    pub kind: FoldKind,
    /// The numbers at the fold on the finest grid.
    pub numbers: Numbers,
    /// Their errors: the larger of the last two differences between grids (four times it for lines with edges), plus the misfit of the curve.
    pub errors: Numbers,
    /// Nodes along x of the finest grid.
    pub nodes: usize,
}

/// Locates a fold of the branch on its grid and two finer ones.
///
/// # Errors
/// [`Refusal::NotConverged`] where the states around it cannot be followed to the finer grids.
pub fn locate(problem: &Problem, rough: &RoughFold) -> Result<Fold, Refusal> {
    let place = Place { range: problem.attraction.range, stiffening: 1.0, ramp: None };
    let by_gap = matches!(rough.kind, FoldKind::LeastPressure | FoldKind::LargestPressure);
    let mut control = problem.clone();
    // Entry of the numbers that turns: the pressure (0) or the gap (1).
    let (turning, width) = if by_gap { (0, rough.spacing[0]) } else { (1, rough.spacing[1]) };
    let limit = 0.02 * problem.profile.half_height();
    let mut step = width.clamp(0.05 * limit, limit) / f64::from(SIDE);
    let mut middle = if by_gap { rough.point.mean_gap } else { rough.point.mean_pressure };
    control.control = if by_gap { Control::MeanGap(middle) } else { Control::MeanPressure(middle) };
    let mut equations = Equations::new(&control, rough.nodes, 1.0, place.range);
    let mut state = rough.state.clone();
    let mut found: Vec<[f64; 7]> = Vec::new();
    let mut misfit = [f64::INFINITY; 7];
    let mut lost = None;
    for grid in 0..GRIDS {
        if grid > 0 {
            (equations, state) = reach::refined(&control, &equations, &state, place);
        }
        // The middle follows the fold and the samples close up while that improves the fit; above the noise of the grid it does.
        for _ in 0..10 {
            // Samples beyond the end of the branch are no states: closer ones are taken.
            let samples = match sample(&mut equations, &mut state, middle, step, by_gap) {
                Ok(samples) => samples,
                Err(refusal) => {
                    lost = Some(refusal);
                    step *= 0.5;
                    continue;
                }
            };
            let (at, values) = extremum(&samples, turning);
            middle += at.clamp(-1.0, 1.0) * f64::from(SIDE) * step;
            if at.abs() > 0.7 {
                continue;
            }
            let fit: [f64; 7] = std::array::from_fn(|i| misfit_of(&samples, i));
            let improved = fit[turning] < 0.5 * misfit[turning];
            if improved || found.len() <= grid {
                misfit = fit;
                found.truncate(grid);
                found.push(values);
            }
            if !improved || fit[turning] < FLAT * values[turning].abs() {
                break;
            }
            step *= 0.5;
        }
        if found.len() <= grid {
            break;
        }
    }
    let [a, b, c] = found.as_slice() else {
        return Err(lost.unwrap_or_else(|| Refusal::NotConverged {
            what: "the place of the fold",
            detail: format!("it leaves the samples around {middle:.6}"),
        }));
    };
    // Of fewer grids than an accuracy takes both differences may be small by chance, as for a state.
    let wanted = Convergence::of(&problem.attraction).grids(problem.profile.is_line());
    let few = if GRIDS < wanted { bounds::SAFETY } else { 1.0 };
    let errors = std::array::from_fn(|i| few * (c[i] - b[i]).abs().max((b[i] - a[i]).abs()) + misfit[i]);
    Ok(Fold { kind: rough.kind, numbers: Numbers::from_list(*c), errors: Numbers::from_list(errors), nodes: equations.grid.nx() })
}

/// The numbers at equal steps around the middle; `state` ends at the middle.
fn sample(equations: &mut Equations, state: &mut State, middle: f64, step: f64, by_gap: bool) -> Result<Vec<[f64; 7]>, Refusal> {
    let mut samples = vec![[0.0; 7]; 2 * SIDE as usize + 1];
    let mut centre = None;
    for side in [1, -1] {
        let mut here = centre.clone().unwrap_or_else(|| state.clone());
        for index in (if side == 1 { 0 } else { 1 })..=SIDE {
            let value = middle + step * f64::from(side * index);
            equations.row = if by_gap { [1.0, 0.0, value] } else { [0.0, 1.0, value] };
            let report = newton::solve(equations, &mut here, newton::FINE, 6000).map_err(|stalled| Refusal::NotConverged {
                what: "a state near the fold",
                detail: format!("residual {:.1e} on {} nodes at {value:.6}", stalled.residual, equations.grid.nx()),
            })?;
            samples[(SIDE + side * index) as usize] = solution::evaluate(equations, &here, report).0.list();
            if index == 0 {
                centre = Some(here.clone());
            }
        }
    }
    if let Some(centre) = centre {
        *state = centre;
    }
    Ok(samples)
}

/// Where the quartic through entry `turning` (0: pressure, 1: gap) has its extremum (−1 … 1 spans the samples), and all numbers there.
fn extremum(samples: &[[f64; 7]], turning: usize) -> (f64, [f64; 7]) {
    let curve = quartic(samples, turning);
    let slope = |x: f64| curve[1] + x * (2.0 * curve[2] + x * (3.0 * curve[3] + x * 4.0 * curve[4]));
    let bend = |x: f64| 2.0 * curve[2] + x * (6.0 * curve[3] + x * 12.0 * curve[4]);
    let mut x = 0.0_f64;
    for _ in 0..50 {
        let change = -slope(x) / bend(x);
        if !change.is_finite() {
            break;
        }
        x = (x + change.clamp(-0.5, 0.5)).clamp(-3.0, 3.0);
    }
    let values = std::array::from_fn(|i| {
        let c = quartic(samples, i);
        c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])))
    });
    (x, values)
}

/// Least-squares quartic through one entry of seven samples at −1, −2/3 … 1, by its moments (closed form for symmetric samples).
fn quartic(samples: &[[f64; 7]], entry: usize) -> [f64; 5] {
    let x = |k: usize| (k as f64 - f64::from(SIDE)) / f64::from(SIDE);
    let sum = |power: i32| samples.iter().enumerate().map(|(k, s)| x(k).powi(power) * s[entry]).sum::<f64>();
    let moment = |power: i32| (0..samples.len()).map(|k| x(k).powi(power)).sum::<f64>();
    // Odd part: c1, c3; even part: c0, c2, c4.
    let (m2, m4, m6, m8) = (moment(2), moment(4), moment(6), moment(8));
    let (s0, s1, s2, s3, s4) = (sum(0), sum(1), sum(2), sum(3), sum(4));
    let odd = m2 * m6 - m4 * m4;
    let (c1, c3) = ((s1 * m6 - s3 * m4) / odd, (m2 * s3 - m4 * s1) / odd);
    let m0 = samples.len() as f64;
    // Cramer's rule for [m0 m2 m4; m2 m4 m6; m4 m6 m8].
    let det = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1])
    };
    let (u, v, w, s) = ([m0, m2, m4], [m2, m4, m6], [m4, m6, m8], [s0, s2, s4]);
    let whole = det(u, v, w);
    [det(s, v, w) / whole, c1, det(u, s, w) / whole, c3, det(u, v, s) / whole]
}

/// The largest distance of the samples from their quartic.
fn misfit_of(samples: &[[f64; 7]], entry: usize) -> f64 {
    let c = quartic(samples, entry);
    let distance = |(k, s): (usize, &[f64; 7])| {
        let x = (k as f64 - f64::from(SIDE)) / f64::from(SIDE);
        (s[entry] - (c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4]))))).abs()
    };
    samples.iter().enumerate().map(distance).fold(0.0, f64::max)
}
