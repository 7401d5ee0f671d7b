//! Full contact: a closed form for any law with a hard wall.

use super::grid::{Equations, State};
use super::newton::Report;
use super::problem::{Control, Problem};
use super::solution::{self, Numbers};
use super::steady::{ReachedBy, Request, SteadyState};
use crate::refusal::Refusal;

/// The state in which the gap is the wall's everywhere: p = A h + P, admissible while the wall nowhere pulls more than the law.
///
/// # Errors
/// As [`Problem::check`]; [`Refusal::Undefined`] for a law without a wall; [`Refusal::NoSuchState`] where the surface would part, with the least mean
/// pressure of full contact as the witness, or where a mean gap other than the wall's is imposed.
pub fn full_contact(problem: &Problem, request: &Request) -> Result<SteadyState, Refusal> {
    problem.check()?;
    let Some(wall) = problem.attraction.wall() else {
        return Err(Refusal::Undefined { quantity: "full contact", reason: "this law has no hard wall".to_owned() });
    };
    let nx = problem.profile.own_nx().next_power_of_two().max(request.least_nodes).min(request.most_nodes);
    let mut equations = Equations::new(problem, nx, 1.0, problem.attraction.range);
    let n = equations.len();
    let [a, b, c] = problem.control.row();
    if b == 0.0 && (c - a * wall).abs() > 1e-12 * problem.profile.half_height() {
        return Err(Refusal::NoSuchState {
            reason: "full contact has the mean gap of the wall".to_owned(),
            limit_name: "mean gap",
            limit: wall,
        });
    }
    // Under an imposed gap any sufficient pressure would do; the least one is taken.
    let mut state = State { gap: vec![wall; n], contact: vec![true; n], mean_pressure: 0.0 };
    let mut pressure = vec![0.0; n];
    equations.pressure(&state, &mut pressure);
    let deepest = pressure.iter().copied().fold(f64::INFINITY, f64::min);
    let least = problem.attraction.stress(wall) - deepest;
    state.mean_pressure = if b == 0.0 { least } else { (c - a * wall) / b };
    if state.mean_pressure < least {
        let reason = "the surface would part from full contact".to_owned();
        return Err(Refusal::NoSuchState { reason, limit_name: "least mean pressure of full contact", limit: least });
    }
    let report = Report { steps: 0, products: 1, residual: 0.0, mean_residual: 0.0, least_contact_pressure: state.mean_pressure - least };
    let (numbers, certificate, fields) = solution::evaluate(&mut equations, &state, report);
    let rounding = 16.0 * f64::EPSILON * equations.stiffest * problem.profile.half_height();
    let mut errors = Numbers::from_list(numbers.list().map(|v| 64.0 * f64::EPSILON * v.abs() + rounding));
    errors.friction_stress = super::bounds::Scale::new(&equations, 1.0, 1.0).of_friction(numbers.friction_stress, rounding);
    Ok(SteadyState {
        numbers,
        errors,
        patches: 1,
        patches_error: 0,
        field_errors: [vec![rounding; n], vec![0.0; n]],
        certificate,
        fields,
        reached_by: ReachedBy::FullContact,
        accuracy_met: true,
        nodes_needed: nx,
        products: 2,
        node_products: 2 * n,
        coarser: vec![(nx, state)],
    })
}

impl Control {
    /// The same control with another value (mean pressure, mean gap, or position of the frame).
    #[must_use]
    pub const fn with_value(self, value: f64) -> Self {
        match self {
            Self::MeanPressure(_) => Self::MeanPressure(value),
            Self::MeanGap(_) => Self::MeanGap(value),
            Self::Frame { stiffness, .. } => Self::Frame { stiffness, position: value },
        }
    }
}
