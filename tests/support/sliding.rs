//! Sliding contacts for tests: found by their speed, or near given edges, with plain numbers.

use std::sync::Arc;
use viscotack::sliding::contact::{ContactMemory, ContactState, Indenter, Prescribed, Resolution, WaveContact};
use viscotack::sliding::edge_balance::EdgeBalance;
use viscotack::sliding::steady::{SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};
use viscotack::{PlaneMaterial, Refusal};

/// A contact of a wave with both releases, zero without adhesion.
#[derive(Debug, Clone)]
pub struct Found {
    pub state: ContactState,
    pub trailing_release: f64,
    pub leading_release: f64,
    pub residual: f64,
    pub admissible: bool,
    pub steps: u64,
}

pub fn control(prescribed: Prescribed) -> SlidingControl {
    match prescribed {
        Prescribed::MeanPressure(pressure) => SlidingControl::MeanPressure(pressure),
        Prescribed::Penetration(penetration) => SlidingControl::Penetration(penetration),
        Prescribed::MeanSeparation(separation) => SlidingControl::Penetration(1.0 - separation),
    }
}

/// The contact at a rate kv (1/s), by the path that the program takes.
pub fn contact_at_rate(
    material: &PlaneMaterial,
    rate: f64,
    adhesion: Option<WaveAdhesion>,
    prescribed: Prescribed,
    accuracy: f64,
) -> Result<Found, Refusal> {
    let problem = SlidingProblem { rate, indenter: Indenter::Wave, adhesion, work_by_speed: None, control: control(prescribed), accuracy };
    match steady_sliding(material, &problem)? {
        SlidingOutcome::Partial(contact) => {
            let (trailing_release, leading_release) =
                contact.values.adhesion.map_or((0.0, 0.0), |values| (values.trailing_release.value, values.leading_release.value));
            Ok(Found {
                state: contact.state,
                trailing_release,
                leading_release,
                residual: contact.certificate.residual,
                admissible: contact.certificate.admissible,
                steps: contact.work.half_widths,
            })
        }
        SlidingOutcome::Full(full) => Err(Refusal::NoSuchState {
            reason: "full contact instead of a partial one".into(),
            limit_name: full.limit_name,
            limit: full.limit,
        }),
    }
}

/// The contact near given edges, at the finest resolution, checked for admissibility; `steps` are the evaluations.
pub fn contact_near(
    memory: &ContactMemory,
    adhesion: Option<WaveAdhesion>,
    prescribed: Prescribed,
    start: WaveContact,
    tolerance: f64,
) -> Result<Found, Refusal> {
    let balance = EdgeBalance::new(Arc::new(memory.clone()), Indenter::Wave, adhesion, control(prescribed), Resolution::Finest);
    let (found, admissibility) = balance.solve_admissible([start.half_width, start.eccentricity], None, tolerance)?;
    let (trailing_release, leading_release) =
        balance.releases(&found.solution)?.map_or((0.0, 0.0), |(trailing, leading)| (trailing.value, leading.value));
    Ok(Found {
        state: found.solution.state,
        trailing_release,
        leading_release,
        residual: found.residual,
        admissible: admissibility.holds(),
        steps: u64::from(found.evaluations),
    })
}
