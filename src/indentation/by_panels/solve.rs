//! From a problem of this crate to its panels, and bounds of what comes back.
//!
//! Bounds: a march of degree p and one of p + 2 at the same tolerance; the second is given, each value with [`SAFETY`] times its distance to the first.

use super::chain::Chain;
use super::drive::Drive;
use super::march::March;
use super::problem::{End, Outcome, Problem, Row};
use super::start::elastic_start;
use crate::indentation::{Controlled, EdgeLaw, IndentationProblem, Profile, Start};
use crate::material::Material;
use crate::refusal::{Refusal, require_positive};

/// A bound over the distance of the two marches. Of 64 values in 16 retractions 3 leave 2 to 5 errors outside, 10 none at tolerances up to 1e-4: the panels
/// of the two differ, so that their errors are not in a fixed proportion.
const SAFETY: f64 = 10.0;
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

/// A row and its bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundedRow {
    /// Of the better march.
    pub row: Row,
    /// Of each number of the row.
    pub bound: Row,
}

/// A history with bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounded {
    /// The wanted instants while there is contact.
    pub wanted: Vec<BoundedRow>,
    /// The least force of the history.
    pub least_force: BoundedRow,
    /// The last row.
    pub last: BoundedRow,
    /// The better march.
    pub fine: Outcome,
    /// Closures of both marches.
    pub closures: u64,
}

/// One march of a history of penetration; rows at `instants`.
///
/// # Errors
/// [`Refusal::Undefined`] for what this room does not solve yet, [`Refusal::NoSuchState`] without a first contact, [`Refusal::NotConverged`].
pub fn march_by_panels(material: &Material, problem: &IndentationProblem, options: PanelOptions, instants: &[f64]) -> Result<Outcome, Refusal> {
    problem.checked()?;
    require_positive("tolerance", options.tolerance)?;
    if !(2..=9).contains(&options.degree) {
        return Err(Refusal::out_of_range("degree", options.degree as f64, "from 2 to 9"));
    }
    let chain = chain_of(material)?;
    let drive = drive_of(&chain, problem)?;
    let relaxed = problem.start == Start::Relaxed;
    let modulus = if relaxed { chain.relaxed } else { chain.glassy };
    let depth = problem.history.start;
    let (adhesion, zone, edge) = match problem.adhesion {
        Some(adhesion) => {
            let (work, zone) = (adhesion.work_of_adhesion, adhesion.process_zone);
            let edge = elastic_start(&problem.profile, modulus, work, zone, depth);
            let none = || Refusal::NoSuchState {
                reason: "no contact larger than its process zone is in equilibrium at the start".into(),
                limit_name: "the process zone",
                limit: zone,
            };
            (Some(work), zone, edge.ok_or_else(none)?)
        }
        None => {
            let deepest = drive.deepest(&chain).max(depth);
            let touching = |depth: f64| Ok::<f64, Refusal>(if depth > 0.0 { radius_of(&problem.profile, depth) } else { 0.0 });
            (None, FIRST_LENGTH * touching(deepest)?, touching(depth)?)
        }
    };
    require_positive("penetration", if zone > 0.0 { zone } else { drive.deepest(&chain) })?;
    let own = Problem {
        profile: problem.profile.clone(),
        chain,
        adhesion,
        zone,
        drive,
        relaxed,
        tolerance: options.tolerance,
        degree: options.degree,
        instants: instants.to_vec(),
    };
    let outcome = March::new(&own, edge).run();
    if outcome.end == End::Failed {
        let last = outcome.ends.last().copied().unwrap_or(outcome.start);
        return Err(Refusal::NotConverged {
            what: "the path of the edge by panels",
            detail: format!("panels of no length at t = {:e} s, a = {:e} m after {} of them", last.time, last.contact_radius, outcome.panels),
        });
    }
    Ok(outcome)
}

/// The history with bounds, by degrees p and p + 2.
///
/// # Errors
/// As [`march_by_panels`]; [`Refusal::NotConverged`] too if the two marches end differently.
pub fn solve_by_panels(material: &Material, problem: &IndentationProblem, options: PanelOptions, instants: &[f64]) -> Result<Bounded, Refusal> {
    let coarse = march_by_panels(material, problem, options, instants)?;
    let fine = march_by_panels(material, problem, PanelOptions { degree: options.degree + 2, ..options }, instants)?;
    if coarse.end != fine.end || coarse.wanted.len() != fine.wanted.len() || coarse.jumps.len() != fine.jumps.len() {
        return Err(Refusal::NotConverged {
            what: "the path of the edge by panels",
            detail: format!("degrees {} and {} end or jump differently", options.degree, options.degree + 2),
        });
    }
    let wanted = fine.wanted.iter().zip(&coarse.wanted).map(|(fine, coarse)| bounded(fine, coarse)).collect();
    let last = |outcome: &Outcome| outcome.ends.last().copied().unwrap_or(outcome.start);
    Ok(Bounded {
        wanted,
        least_force: bounded(&fine.least_force, &coarse.least_force),
        last: bounded(&last(&fine), &last(&coarse)),
        closures: coarse.closures + fine.closures,
        fine,
    })
}

fn bounded(fine: &Row, coarse: &Row) -> BoundedRow {
    let bound = |x: f64, y: f64| SAFETY * (x - y).abs() + 4.0 * f64::EPSILON * x.abs();
    let bound = Row {
        time: bound(fine.time, coarse.time),
        penetration: bound(fine.penetration, coarse.penetration),
        contact_radius: bound(fine.contact_radius, coarse.contact_radius),
        force: bound(fine.force, coarse.force),
    };
    BoundedRow { row: *fine, bound }
}

fn chain_of(material: &Material) -> Result<Chain, Refusal> {
    let relaxed = material.solid_modulus("the relaxed contact")?;
    let creep: Vec<_> = material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect();
    let relaxation: Vec<_> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
    Ok(Chain::new(material.glassy_modulus(), relaxed, &creep, &relaxation))
}

fn drive_of(chain: &Chain, problem: &IndentationProblem) -> Result<Drive, Refusal> {
    let refused = |what: &str| Err(Refusal::Undefined { quantity: "the march by panels", reason: format!("it does not solve {what} yet") });
    if !matches!(problem.profile, Profile::Paraboloid { .. } | Profile::Cone { .. }) {
        return refused("other shapes than spheres and cones");
    }
    if problem.edge_law != EdgeLaw::CONSTANT {
        return refused("edge laws");
    }
    if problem.energies {
        return refused("energies");
    }
    let mut drive = Drive::from(problem.history.start);
    let mut value = problem.history.start;
    for segment in &problem.history.segments {
        if segment.controlled != Controlled::Penetration || problem.history.controlled != Controlled::Penetration {
            return refused("controls other than the penetration");
        }
        if segment.duration <= 0.0 {
            return refused("sudden steps");
        }
        let rate = (segment.end - value) / segment.duration;
        drive = match segment.oscillation {
            None => drive.ramp(chain, rate, segment.duration),
            Some(o) if o.frequency.to_bits() == o.end_frequency.to_bits() && !o.until_stationary => {
                drive.oscillate(chain, rate, o.amplitude, std::f64::consts::TAU * o.frequency, segment.duration)
            }
            Some(_) => return refused("sweeps of the frequency, nor oscillations until they are stationary"),
        };
        value = segment.value(value, segment.duration);
    }
    Ok(drive)
}

/// The radius at which f is a depth.
fn radius_of(profile: &Profile, depth: f64) -> f64 {
    match profile {
        Profile::Paraboloid { radius } => (radius * depth).sqrt(),
        _ => depth / profile.line(1.0),
    }
}
