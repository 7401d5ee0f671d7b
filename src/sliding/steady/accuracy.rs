//! From a start to a contact whose every number carries its error.
//!
//! The two conditions are solved at one level of resolution, then evaluated at the next finer one. What they are off there moves the unknowns by the
//! inverse Jacobian and each output by its own derivatives, which differences give as well; that, and the change of the output itself from level to
//! level, is the error of the coarser level but for a small part, as the error falls by two digits or more from one level to the next:
//! ```text
//! error of an output = (1 + margin)·|∂output/∂unknowns · J⁻¹ · finer residual + finer output − output| + bend + rounding
//! ```
//! Large first-order terms may cancel in it; what is left of them is the bend: the derivatives are differences over a step, and moving the unknowns is no straight line.
//! Where it is above the request, the next level follows.

use super::prepared::Prepared;
use super::problem::SlidingProblem;
use super::solution::{AdhesiveValues, PartialContact, PartialValues, SlidingCertificate, SlidingWork};
use super::start::Start;
use crate::continuation::two_unknowns::{Jacobian, TwoResiduals, largest, solve_two_by_two};
use crate::estimate::Estimate;
use crate::refusal::Refusal;
use crate::sliding::contact::Resolution;
use crate::sliding::edge_balance::{EdgeBalance, EdgeStates, SlidingControl, WaveAdhesion};
use std::f64::consts::PI;

/// Share of an error that the finer level may still have.
const MARGIN: f64 = 0.3;
/// Rounding of a condition, and of an output over its size.
const ROUNDING: f64 = 40.0 * f64::EPSILON;
/// Rounding of a sum of a few products, over the size of its terms.
const TERMS: f64 = 4.0 * f64::EPSILON;
/// The residual asked for, over the accuracy.
const RESIDUAL_SHARE: f64 = 0.03;
/// A larger residual would leave errors of second order.
const LOOSEST: f64 = 1e-7;
/// Number of outputs.
const OUTPUTS: usize = 12;

/// Half-width, eccentricity, trailing and leading edge, Δ, p̄, friction stress, μ, U, G₁/Δγ₁, G₂/Δγ₂, Γ₁G₁/Δγ₁ − Γ₂G₂/Δγ₂.
type Outputs = [f64; OUTPUTS];

/// Solves a contact from a start to the accuracy of the problem, or as near to it as double precision allows.
///
/// # Errors
/// [`Refusal::NotConverged`] if no admissible root is near.
pub(super) fn solved(
    prepared: &Prepared,
    problem: &SlidingProblem<'_>,
    start: &Start,
    work: &mut SlidingWork,
) -> Result<PartialContact, Refusal> {
    let balance_at = |resolution| prepared.balance(problem.control, resolution);
    // Starts are contacts of the medium level: at a coarser one the next level would show no error of theirs.
    let mut resolution = if problem.accuracy > 1e-9 { Resolution::Medium } else { Resolution::Fine };
    let mut start = *start;
    let mut balance = balance_at(resolution);
    loop {
        let Some(finer) = resolution.finer() else {
            return Err(Refusal::NotConverged { what: "the accuracy of a sliding contact", detail: "no finer level is left".into() });
        };
        let count = |balance: &EdgeBalance, work: &mut SlidingWork| {
            let evaluations = balance.take_evaluations();
            work.closure_evaluations += evaluations;
            work.contacts += balance.contacts_per_evaluation() * evaluations;
        };
        // Beside full contact an edge moves by the defect of the load over the gap.
        let gap = match problem.control {
            SlidingControl::HalfWidth(_) => 1.0,
            _ => (problem.indenter.widest() - start.unknowns[0]).min(1.0),
        };
        let tolerance = (RESIDUAL_SHARE * problem.accuracy * gap).clamp(ROUNDING, LOOSEST);
        let found = balance.solve_admissible(start.unknowns, start.jacobian, tolerance);
        count(&balance, work);
        let (found, admissibility) = found?;
        let (here, release_rounding) = outputs(&balance, &found.solution)?;
        let Sensitivity { jacobian, outputs: slopes } = sensitivity(&balance, found.unknowns, &found.solution, &here)?;
        let fine_balance = balance_at(finer);
        let fine = fine_balance.evaluate(found.unknowns)?;
        count(&balance, work);
        count(&fine_balance, work);
        // Each set of release rates (here, at both differences, at the finer level) takes the reversed contact as well.
        work.contacts += if problem.adhesion.is_some() { 4 } else { 0 };
        let (fine_outputs, _) = outputs(&fine_balance, &fine)?;
        let singular =
            || Refusal::NotConverged { what: "the edges of a sliding contact", detail: "the Jacobian is singular: a fold is near".into() };
        let inverse = inverse_columns(&jacobian).ok_or_else(singular)?;
        let moved = solve_two_by_two(&jacobian, fine.residual()).ok_or_else(singular)?;
        let own = rounding_of_outputs(&found.solution, problem.adhesion, release_rounding);
        let of_conditions = found.solution.rounding;
        let bend = Bend::new(&balance, found.unknowns, moved, &jacobian);
        let scales = scales_of_outputs(&found.solution, problem.adhesion);
        let estimates: Vec<Estimate> = (0..OUTPUTS)
            .map(|output| {
                let slope = slopes[output];
                let change = fine_outputs[output] - here[output] - slope[0] * moved[0] - slope[1] * moved[1];
                let through = |column: [f64; 2]| (slope[0] * column[0] + slope[1] * column[1]).abs();
                let rounding = own[output] + of_conditions[0] * through(inverse[0]) + of_conditions[1] * through(inverse[1]);
                Estimate::new(here[output], (1.0 + MARGIN) * change.abs() + bend.of(slope, moved, scales[output]) + rounding)
            })
            .collect();
        let partial = partial_values(&estimates, problem.adhesion.is_some());
        let accuracy = achieved(&estimates, problem.adhesion.is_some(), partial.friction_coefficient.is_some());
        if accuracy <= problem.accuracy || finer.finer().is_none() {
            let states = found.solution;
            let condition = states.moved.as_ref().map_or(states.state.condition(), |(trailing, leading)| {
                states.state.condition().max(trailing.condition()).max(leading.condition())
            });
            return Ok(PartialContact {
                values: partial,
                certificate: SlidingCertificate {
                    residual: largest(states.residual()),
                    condition,
                    admissible: admissibility.holds(),
                    accuracy,
                },
                work: *work,
                start: Start { unknowns: found.unknowns, jacobian: Some(jacobian) },
                state: states.state,
                stability: None,
                others: 0,
            });
        }
        start = Start { unknowns: [found.unknowns[0] - moved[0], found.unknowns[1] - moved[1]], jacobian: Some(jacobian) };
        resolution = finer;
        balance = fine_balance;
    }
}

/// What first derivatives leave out of a move of the unknowns.
///
/// A condition changes by one, and its slopes and those of the release rates by as much as themselves, where an unknown moves by 1/|J|; other outputs are products of
/// unknowns, whose second derivatives are their size over two rooms.
struct Bend {
    /// Relative change of slopes over half a difference step and half the move.
    of_slopes: f64,
    /// The square of the move over the room.
    of_products: f64,
}

impl Bend {
    fn new(balance: &EdgeBalance, unknowns: [f64; 2], moved: [f64; 2], jacobian: &Jacobian) -> Self {
        let (steps, room) = (balance.differences(unknowns), balance.room(unknowns));
        let (mut of_slopes, mut part) = (0.0, 0.0);
        for index in 0..2 {
            let bends = jacobian.iter().fold(1.0 / room[index], |most: f64, row| most.max(row[index].abs()));
            of_slopes += 0.5 * (moved[index].abs() + steps[index]) * bends;
            part += moved[index].abs() / room[index];
        }
        Self { of_slopes, of_products: part * part }
    }

    fn of(&self, slope: [f64; 2], moved: [f64; 2], scale: f64) -> f64 {
        self.of_slopes * ((slope[0] * moved[0]).abs() + (slope[1] * moved[1]).abs()) + self.of_products * scale
    }
}

/// How residuals and outputs follow the unknowns.
struct Sensitivity {
    jacobian: Jacobian,
    /// [∂output/∂first, ∂output/∂second] of every output.
    outputs: [[f64; 2]; OUTPUTS],
}

fn sensitivity(balance: &EdgeBalance, unknowns: [f64; 2], states: &EdgeStates, here: &Outputs) -> Result<Sensitivity, Refusal> {
    let small = balance.differences(unknowns);
    let mut jacobian = [[0.0; 2]; 2];
    let mut slopes = [[0.0; 2]; OUTPUTS];
    for index in 0..2 {
        let mut moved = unknowns;
        moved[index] += small[index];
        let step = moved[index] - unknowns[index];
        let there = balance.evaluate(moved)?;
        for (row, entry) in jacobian.iter_mut().enumerate() {
            entry[index] = (there.residual()[row] - states.residual()[row]) / step;
        }
        for (slope, (after, before)) in slopes.iter_mut().zip(outputs(balance, &there)?.0.iter().zip(here)) {
            slope[index] = (after - before) / step;
        }
    }
    Ok(Sensitivity { jacobian, outputs: slopes })
}

/// The columns of the inverse of a 2 × 2 matrix.
fn inverse_columns(matrix: &Jacobian) -> Option<[[f64; 2]; 2]> {
    Some([solve_two_by_two(matrix, [1.0, 0.0])?, solve_two_by_two(matrix, [0.0, 1.0])?])
}

/// The outputs, and what rounding leaves uncertain of both release rates.
fn outputs(balance: &EdgeBalance, states: &EdgeStates) -> Result<(Outputs, [f64; 2]), Refusal> {
    let state = &states.state;
    let contact = state.contact();
    let friction = state.friction_stress();
    let none = Estimate::exact(0.0);
    let (released, gained) = balance.releases(states)?.unwrap_or((none, none));
    let (trailing, leading) = (released.value, gained.value);
    let values = [
        contact.half_width,
        contact.eccentricity,
        contact.eccentricity - contact.half_width,
        contact.eccentricity + contact.half_width,
        state.penetration(),
        state.mean_pressure(),
        friction,
        friction / state.mean_pressure(),
        state.interface_work(),
        trailing,
        leading,
        // So written, the difference of equal works costs no digits.
        balance.adhesion().map_or(0.0, |adhesion| {
            adhesion.trailing_work * (trailing - leading) + (adhesion.trailing_work - adhesion.leading_work) * leading
        }),
    ];
    Ok((values, [released.error, gained.error]))
}

fn rounding_of_outputs(states: &EdgeStates, adhesion: Option<WaveAdhesion>, release_rounding: [f64; 2]) -> Outputs {
    let state = &states.state;
    let sizes = sizes(states);
    let digits = 1.0 + state.condition().ln();
    let unit = ROUNDING * digits;
    let mut rounding = scales_of(&sizes, state.mean_pressure(), adhesion).map(|scale| unit * scale);
    // Stiff solids and narrow contacts: the first harmonic of the wave is a small difference of loads as large as the whole, divided by its small compliance.
    let (friction, energy) = state.harmonic_sizes();
    rounding[6] += TERMS * digits * friction;
    rounding[7] = rounding[6] / state.mean_pressure().abs() + ROUNDING * (state.friction_stress() / state.mean_pressure()).abs();
    rounding[8] += TERMS * digits * energy;
    if let Some(adhesion) = adhesion {
        // Integrals over the same zones as the conditions; the gap of the reversed contact may be the larger one.
        rounding[9] = states.rounding[0].max(release_rounding[0]);
        rounding[10] = states.rounding[1].max(release_rounding[1]);
        rounding[11] = adhesion.larger_work() * (rounding[9] + rounding[10]);
    }
    rounding
}

/// The sizes of all outputs, whose parts of second order they are multiplied with.
fn scales_of_outputs(states: &EdgeStates, adhesion: Option<WaveAdhesion>) -> Outputs {
    scales_of(&sizes(states), states.state.mean_pressure(), adhesion)
}

fn scales_of(sizes: &WaveSizes, mean_pressure: f64, adhesion: Option<WaveAdhesion>) -> Outputs {
    let &WaveSizes { length, pressure, penetration, friction, energy } = sizes;
    let release = if adhesion.is_some() { 1.0 } else { 0.0 };
    let work = adhesion.map_or(0.0, |adhesion| adhesion.larger_work());
    [length, length, length, length, penetration, pressure, friction, friction / mean_pressure.abs(), energy, release, release, work]
}

/// The sizes of the terms that outputs are sums of.
struct WaveSizes {
    length: f64,
    pressure: f64,
    penetration: f64,
    friction: f64,
    energy: f64,
}

fn sizes(states: &EdgeStates) -> WaveSizes {
    let state = &states.state;
    let contact = state.contact();
    let length = contact.half_width + contact.eccentricity.abs();
    let scale = state.indenter().half_angle_scale(contact.half_width);
    let pressure = scale + state.mean_pressure().abs();
    let reach = match state.indenter() {
        crate::sliding::contact::Indenter::Wave => length.min(1.0),
        crate::sliding::contact::Indenter::Parabola => length,
    };
    let stiff = state.stiffness_at_contact();
    let penetration = state.penetration().abs() + pressure;
    // An ulp of an edge shifts what the glassy layer there carries.
    let friction = (stiff + state.glassy_stiffness() / 40.0) * reach * pressure;
    let energy = 2.0 * PI * (penetration * state.mean_pressure().abs() + reach * friction);
    WaveSizes { length, pressure, penetration, friction, energy }
}

fn partial_values(estimates: &[Estimate], adhesive: bool) -> PartialValues {
    let at = |index: usize| estimates.get(index).copied().unwrap_or(Estimate::new(f64::NAN, f64::INFINITY));
    let opposite = |estimate: Estimate| Estimate::new(1.0 - estimate.value, estimate.error + f64::EPSILON);
    let mean_pressure = at(5);
    PartialValues {
        half_width: at(0),
        eccentricity: at(1),
        trailing_edge: at(2),
        leading_edge: at(3),
        penetration: at(4),
        mean_pressure,
        friction_stress: at(6),
        friction_coefficient: (mean_pressure.value > mean_pressure.error).then(|| at(7)),
        interface_work: at(8),
        adhesion: adhesive.then(|| AdhesiveValues {
            trailing_release: at(9),
            leading_release: at(10),
            trailing_nonconservative: opposite(at(9)),
            leading_nonconservative: opposite(at(10)),
            adhesive_friction_stress: at(11),
        }),
    }
}

/// Largest error over max(|value|, 1).
fn achieved(estimates: &[Estimate], adhesive: bool, coefficient: bool) -> f64 {
    let counts = |index: usize| (index != 7 || coefficient) && (index < 9 || adhesive);
    estimates
        .iter()
        .enumerate()
        .filter(|&(index, _)| counts(index))
        .map(|(_, estimate)| estimate.error / estimate.value.abs().max(1.0))
        .fold(0.0, |worst: f64, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) })
}
