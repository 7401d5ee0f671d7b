//! From a problem of this crate to its panels, and bounds of what comes back.
//!
//! Bounds: a march of degree p and one of p + 2 at the same tolerance; the second is given, each value with [`SAFETY`] times its distance
//! to the first.

use super::march::March;
use super::problem::{End, Outcome, Problem, Row};
use super::setup::{chain_of, control_of, drive_of, radius_of, started, supported};
use super::start::elastic_start;
use crate::indentation::{IndentationProblem, Start};
use crate::material::Material;
use crate::refusal::{Refusal, require_positive};

/// A bound over the distance of the two marches. Of 64 values in 16 retractions 3 leave 2 to 5 errors outside, 10 none at tolerances up to
/// 1e-4: the panels of the two differ, so that their errors are not in a fixed proportion.
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
/// [`Refusal::Undefined`] for what this room does not solve yet, [`Refusal::NoSuchState`] without a first contact and for one that reaches beyond a table,
/// [`Refusal::NotConverged`].
pub fn march_by_panels(
    material: &Material,
    problem: &IndentationProblem,
    options: PanelOptions,
    instants: &[f64],
) -> Result<Outcome, Refusal> {
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
                Some(control) => started(&problem.profile, modulus, control, history.start, radius)
                    .ok_or_else(|| none("the value of the control there", history.start))?,
            };
            (Some(work), zone, radius(depth).ok_or_else(|| none("the process zone", zone))?, depth)
        }
        None => {
            let deepest = history.segments.iter().map(|segment| segment.end + segment.oscillation.map_or(0.0, |o| o.amplitude));
            let deepest = deepest.fold(history.start, f64::max);
            require_positive("penetration", deepest)?;
            (None, FIRST_LENGTH * radius_of(&problem.profile, deepest), radius_of(&problem.profile, history.start), history.start)
        }
    };
    let own = Problem {
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
    };
    let outcome = March::new(&own, edge, depth).run();
    // The widest contacts are at ends of panels: an edge that turns back ends one.
    for row in outcome.ends.iter().chain(&outcome.jumps).chain([&outcome.start]) {
        problem.profile.holds(row.contact_radius, zone)?;
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

/// The history with bounds, by degrees p and p + 2.
///
/// # Errors
/// As [`march_by_panels`]; [`Refusal::NotConverged`] too if the two marches end differently.
pub fn solve_by_panels(
    material: &Material,
    problem: &IndentationProblem,
    options: PanelOptions,
    instants: &[f64],
) -> Result<Bounded, Refusal> {
    let coarse = march_by_panels(material, problem, options, instants)?;
    // The better march is asked at the panel ends of the other one too.
    let mut asked: Vec<(f64, Option<Row>)> = instants.iter().map(|&time| (time, None)).collect();
    // At a sudden step two ends have one time: the rows that are asked for say which is which.
    let steps: Vec<u64> =
        coarse.ends.windows(2).filter(|pair| pair[0].time.to_bits() == pair[1].time.to_bits()).map(|pair| pair[0].time.to_bits()).collect();
    asked.extend(coarse.ends.iter().filter(|row| !steps.contains(&row.time.to_bits())).map(|row| (row.time, Some(*row))));
    asked.sort_by(|one, two| one.0.total_cmp(&two.0));
    let times: Vec<f64> = asked.iter().map(|(time, _)| *time).collect();
    let mut fine = march_by_panels(material, problem, PanelOptions { degree: options.degree + 2, ..options }, &times)?;
    let rows: Vec<(Row, Option<Row>)> = fine.wanted.iter().zip(&asked).map(|(row, (_, end))| (*row, *end)).collect();
    fine.wanted = rows.iter().filter(|(_, end)| end.is_none()).map(|(row, _)| *row).collect();
    if coarse.end != fine.end || coarse.wanted.len() != fine.wanted.len() || coarse.jumps.len() != fine.jumps.len() {
        return Err(Refusal::NotConverged {
            what: "the path of the edge by panels",
            detail: format!("degrees {} and {} end or jump differently", options.degree, options.degree + 2),
        });
    }
    let mut apart = Row::default();
    let mut wanted = Vec::new();
    let mut coarse_wanted = coarse.wanted.iter();
    for (row, end) in &rows {
        match end {
            Some(end) => apart = largest(&apart, &distance(row, end)),
            None => {
                if let Some(other) = coarse_wanted.next() {
                    apart = largest(&apart, &distance(row, other));
                }
                wanted.push(bounded(row, &apart));
            }
        }
    }
    let last = |outcome: &Outcome| outcome.ends.last().copied().unwrap_or(outcome.start);
    let least = largest(&apart_until(&rows, fine.least_force.time), &distance(&fine.least_force, &coarse.least_force));
    Ok(Bounded {
        wanted,
        least_force: bounded(&fine.least_force, &least),
        last: bounded(&last(&fine), &distance(&last(&fine), &last(&coarse))),
        closures: coarse.closures + fine.closures,
        fine,
    })
}

/// Largest distance of the two marches at panel ends up to a time.
fn apart_until(rows: &[(Row, Option<Row>)], time: f64) -> Row {
    let ends = rows.iter().filter(|(row, _)| row.time <= time).filter_map(|(row, end)| end.map(|end| distance(row, &end)));
    ends.fold(Row::default(), |most, next| largest(&most, &next))
}

fn distance(one: &Row, two: &Row) -> Row {
    combined(one, two, |x, y| (x - y).abs())
}

fn largest(one: &Row, two: &Row) -> Row {
    combined(one, two, f64::max)
}

fn combined(one: &Row, two: &Row, of: impl Fn(f64, f64) -> f64) -> Row {
    Row {
        time: of(one.time, two.time),
        penetration: of(one.penetration, two.penetration),
        contact_radius: of(one.contact_radius, two.contact_radius),
        force: of(one.force, two.force),
        stress_intensity: of(one.stress_intensity, two.stress_intensity),
    }
}

fn bounded(row: &Row, apart: &Row) -> BoundedRow {
    BoundedRow { row: *row, bound: combined(row, apart, |value, apart| SAFETY * apart + 4.0 * f64::EPSILON * value.abs()) }
}
