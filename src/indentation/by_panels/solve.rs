//! From a problem of this crate to its panels, and one path of its edge.

use super::checkpoint::{IntegrationState, PanelObserver};
use super::integration::Integration;
use super::jump::FLOOR;
use super::prescribed::{RADIUS, depth_of};
use super::problem::{End, Outcome, Problem};
use super::setup::{chain_of, control_of, drive_of, radius_of, started, supported};
use super::start::elastic_start;
use crate::indentation::{Controlled, IndentationProblem, Start};
use crate::material::PlaneMaterial;
use crate::refusal::{Refusal, require_positive};

/// Part of the widest contact that stands for δ where there is none: a length of first panels only.
const FIRST_LENGTH: f64 = 0.05;

/// How a history is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PanelOptions {
    /// Degree p of the panels, 2 to 9.
    pub degree: usize,
    /// Position error allowed, over √(δa) (over a without adhesion).
    pub tolerance: f64,
}

/// One integration of a history of penetration; rows at `instants`.
///
/// # Errors
/// [`Refusal::Undefined`] for what this room does not solve yet, [`Refusal::NoSuchState`] without a first contact and for one that reaches beyond a table,
/// [`Refusal::NotConverged`].
pub fn integrate_by_panels(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    options: PanelOptions,
    instants: &[f64],
) -> Result<Outcome, Refusal> {
    integrated(material, problem, options, (instants, false), &[])
}

/// A problem in the terms of the room, and its first contact.
pub(super) struct Begun {
    pub(super) problem: Problem,
    /// a and Δ at time zero.
    pub(super) edge: f64,
    pub(super) depth: f64,
}

/// Sets a problem up; `surface`: with the surface at the last of the instants; `stops`: segments that end early.
pub(super) fn begun(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    options: PanelOptions,
    (instants, surface): (&[f64], bool),
    stops: &[(usize, f64)],
) -> Result<Begun, Refusal> {
    problem.checked()?;
    require_positive("tolerance", options.tolerance)?;
    if !(2..=9).contains(&options.degree) {
        return Err(Refusal::out_of_range("degree", options.degree as f64, "from 2 to 9"));
    }
    let chain = chain_of(material)?;
    supported(problem)?;
    let relaxed = problem.start == Start::Relaxed;
    let modulus = if relaxed { chain.relaxed } else { chain.glassy };
    let history = &problem.history;
    let frame = problem.frame_stiffness.unwrap_or(f64::INFINITY);
    let none = |limit_name: &'static str, limit: f64| Refusal::NoSuchState {
        reason: "no contact larger than its process zone is in equilibrium at the start".into(),
        limit_name,
        limit,
    };
    let (adhesion, zone, edge, depth) = match problem.adhesion {
        Some(adhesion) => {
            let (work, zone) = (adhesion.work_of_adhesion, adhesion.process_zone);
            let radius = |depth: f64| elastic_start(&problem.profile, modulus, work, zone, depth);
            let depth = match control_of(history.controlled, frame) {
                None => history.start,
                Some(RADIUS) => 0.0,
                Some(control) => started(&problem.profile, modulus, control, history.start, radius)
                    .ok_or_else(|| none("the value of the control there", history.start))?,
            };
            let edge = match history.controlled {
                Controlled::ContactRadius if history.start > FLOOR * zone => history.start,
                Controlled::ContactRadius => return Err(none("the process zone", zone)),
                _ => radius(depth).ok_or_else(|| none("the process zone", zone))?,
            };
            (Some(work), zone, edge, depth)
        }
        None => {
            let deepest = history.segments.iter().map(|segment| segment.end + segment.oscillation.map_or(0.0, |o| o.amplitude));
            let deepest = deepest.fold(history.start, f64::max);
            require_positive("penetration", deepest)?;
            (None, FIRST_LENGTH * radius_of(&problem.profile, deepest), radius_of(&problem.profile, history.start), history.start)
        }
    };
    let problem = Problem {
        profile: problem.profile.clone(),
        chain,
        adhesion,
        zone,
        drive: drive_of(problem, frame),
        relaxed,
        tolerance: options.tolerance,
        degree: options.degree,
        instants: instants.to_vec(),
        energies: problem.energies,
        cycles: Some(problem.accuracy),
        stops: stops.to_vec(),
        surface,
    };
    let depth = match history.controlled {
        Controlled::ContactRadius => depth_of(&problem, modulus, edge).ok_or_else(|| none("the contact radius there", edge))?,
        _ => depth,
    };
    Ok(Begun { problem, edge, depth })
}

/// One integration; `surface`: with the surface at the last of the instants; `stops`: segments that end early.
pub(super) fn integrated(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    options: PanelOptions,
    instants: (&[f64], bool),
    stops: &[(usize, f64)],
) -> Result<Outcome, Refusal> {
    integrated_from(material, problem, options, instants, stops, (None, None))
}

/// The same from a checkpoint, observed.
pub(super) fn integrated_from(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    options: PanelOptions,
    instants: (&[f64], bool),
    stops: &[(usize, f64)],
    (from, observer): (Option<IntegrationState>, Option<PanelObserver<'_>>),
) -> Result<Outcome, Refusal> {
    let Begun { problem: own, edge, depth } = begun(material, problem, options, instants, stops)?;
    let mut integration = Integration::new(&own, edge, depth);
    if let Some(state) = from {
        integration.restore(state)?;
    }
    integration.observer = observer;
    let outcome = integration.run();
    // The widest contacts are at ends of panels: an edge that turns back ends one.
    for row in outcome.ends.iter().chain(&outcome.jumps).chain([&outcome.start]) {
        problem.profile.holds(row.contact_radius, own.zone)?;
    }
    if outcome.end == End::Failed {
        let last = outcome.ends.last().copied().unwrap_or(outcome.start);
        return Err(Refusal::NotConverged {
            what: "the path of the edge by panels",
            detail: format!(
                "panels of no length at t = {:e} s, a = {:e} m after {} of them",
                last.time, last.contact_radius, outcome.panels
            ),
        });
    }
    Ok(outcome)
}
