//! Every contact of a held load, penetration or half-width at one speed, and every branch of a problem: also those that neither the slow nor the fast contact
//! belongs to.
//!
//! At each of a row of half-widths all contacts are known; where the load (or penetration) of neighbours along the row passes the one that
//! is held, a contact of it lies between ([`crate::sliding::equilibrium`]). A branch is missed only if it fits between two half-widths and two speeds of the scan.

use super::conditions::{BranchPath, BranchProblem, BranchStart};
use super::start::place_of;
use super::trace::{Branch, trace};
use crate::continuation::fold::interpolated;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, ContactMemory, Indenter, Resolution};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use crate::sliding::equilibrium::{ContactAt, ContactsOfWidth, EquilibriumCurve, HeldQuantity};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::Arc;

/// The resolution of a scan.
const RESOLUTION: Resolution = Resolution::Coarse;
/// A contact nearer than this to a curve, in scaled unknowns, lies on it.
const ON_CURVE: f64 = 0.05;
/// Half-widths of a scan of usual fineness.
const HALF_WIDTHS: usize = 36;
/// Values of its parameter per factor e.
const PER_LOGARITHM: f64 = 2.0;
/// The fewest of them.
const FEWEST_PARAMETERS: usize = 8;
/// The most of them.
const MOST_PARAMETERS: usize = 200;
/// Branches that are followed at most.
const MOST_BRANCHES: usize = 16;

/// How fine a scan is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scan {
    /// Half-widths, evenly in ln tan(a/2).
    pub half_widths: usize,
    /// Values of the parameter, evenly in its logarithm; along loads of no meaning.
    pub parameters: usize,
}

impl Scan {
    /// Two values of the parameter per factor e, eight at least, and 36 half-widths: a closed branch whose speeds span less than a factor 1.6 may be missed.
    #[must_use]
    pub fn of(problem: &BranchProblem) -> Self {
        let [smallest, largest] = problem.parameters.map(f64::ln);
        let parameters = if problem.path == BranchPath::Loads { 1.0 } else { (PER_LOGARITHM * (largest - smallest)).ceil() };
        Self { half_widths: HALF_WIDTHS, parameters: (parameters as usize).clamp(FEWEST_PARAMETERS, MOST_PARAMETERS) }
    }
}

/// The branches of a problem, with what was looked at.
#[derive(Debug, Clone)]
pub struct EveryBranch {
    /// The branches in the order in which they were found: of speeds first the slow and the fast one.
    pub branches: Vec<Branch>,
    /// Contacts that the scan found.
    pub contacts: usize,
    /// Evaluations of both edge conditions by the scan; those of the branches are counted there.
    pub scan_evaluations: u64,
    /// Contacts that lie on no branch, with the third unknown (p̄, rate kv, Γ or factor) and why none was followed from there.
    pub left_over: Vec<(ContactAt, f64, Refusal)>,
}

/// Every contact of a half-width (in 1/k) at the rate and adhesion of a problem, at a few digits.
///
/// # Errors
/// Those of the problem and of its contacts.
pub fn contacts_of_width(material: &PlaneMaterial, problem: &BranchProblem, half_width: f64) -> Result<Vec<ContactAt>, Refusal> {
    problem.checked()?;
    let memory = Arc::new(ContactMemory::new(material, problem.rate)?);
    ContactsOfWidth::new(conditions(memory, problem.indenter, problem.adhesion, Resolution::Medium)).at(half_width)
}

fn conditions(memory: Arc<ContactMemory>, indenter: Indenter, adhesion: WaveAdhesion, resolution: Resolution) -> EdgeBalance {
    EdgeBalance::new(memory, indenter, Some(adhesion), SlidingControl::MeanPressure(0.0), resolution)
}

/// The half-widths of a scan.
fn row(problem: &BranchProblem, count: usize) -> Vec<f64> {
    let [narrowest, widest] = problem.half_widths.map(|width| place_of(problem, width));
    let count = count.max(2);
    (0..count)
        .map(|index| {
            let place = narrowest + (widest - narrowest) * (index as f64 + 0.5) / count as f64;
            ContactEdges::at_place(problem.indenter, place, 0.0).half_width
        })
        .collect()
}

/// The contacts of a control, and how often both edge conditions were evaluated, at the rate and adhesion of a value of the third unknown.
pub(in crate::sliding) fn contacts_of(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    control: Option<SlidingControl>,
    third: f64,
    half_widths: usize,
) -> Result<(Vec<ContactAt>, u64), Refusal> {
    let (rate, adhesion) = problem.at(third);
    let memory = Arc::new(ContactMemory::new(material, rate)?);
    let every = ContactsOfWidth::new(conditions(memory, problem.indenter, adhesion, RESOLUTION));
    // A contact that a width refuses is a gap in the row: the zone may be wider than the room there.
    let at = |width: f64| every.at(width).unwrap_or_default();
    let (quantity, value) = match control {
        None => {
            let found = row(problem, half_widths).into_iter().flat_map(at).collect();
            return Ok((found, every.evaluations()));
        }
        Some(SlidingControl::HalfWidth(half_width)) => {
            let found = at(half_width);
            return Ok((found, every.evaluations()));
        }
        Some(SlidingControl::MeanPressure(pressure)) => (HeldQuantity::MeanPressure, pressure),
        Some(SlidingControl::Penetration(penetration)) => (HeldQuantity::Penetration, penetration - 1.0),
    };
    let curve = EquilibriumCurve::within(every, problem.half_widths);
    let found = curve.contacts(quantity, value);
    Ok((found, curve.evaluations()))
}

/// Every branch of a problem: that of its start (of speeds: from the slow and the fast side), and those of the contacts that a scan finds on none.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem.
pub fn every_branch(material: &PlaneMaterial, problem: &BranchProblem, scan: Scan) -> Result<EveryBranch, Refusal> {
    problem.checked()?;
    let starts =
        if matches!(problem.path, BranchPath::Speeds(_)) { &[BranchStart::Slow, BranchStart::Fast][..] } else { &[BranchStart::Slow] };
    let (mut open, scan_evaluations) = contacts_at(material, problem, &scanned_parameters(problem, scan), scan.half_widths)?;
    let contacts = open.len();
    let mut branches: Vec<Branch> = Vec::new();
    for &start in starts {
        if let Ok(branch) = trace(material, &BranchProblem { start, ..*problem }) {
            let before = open.len();
            open.retain(|(third, contact)| !lies_on(problem, &branch, *third, contact));
            // From the fast side the same branch may come back.
            if branches.is_empty() || open.len() < before {
                branches.push(branch);
            }
        }
    }
    let (branches, left_over) = branches_through(material, problem, branches, open);
    Ok(EveryBranch { branches, contacts, scan_evaluations, left_over })
}

/// The values of the third unknown that a scan looks at; along loads one of no meaning.
pub(super) fn scanned_parameters(problem: &BranchProblem, scan: Scan) -> Vec<f64> {
    if problem.path == BranchPath::Loads {
        return vec![0.0];
    }
    let [smallest, largest] = problem.parameters.map(f64::ln);
    (0..scan.parameters).map(|index| smallest + (largest - smallest) * (index as f64 + 0.5) / scan.parameters as f64).collect()
}

/// Every contact of the control that is held at values of the third unknown, with that value; and how often both edge conditions were evaluated.
pub(super) fn contacts_at(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    thirds: &[f64],
    half_widths: usize,
) -> Result<(Vec<(f64, ContactAt)>, u64), Refusal> {
    let seen: Result<Vec<(f64, Vec<ContactAt>, u64)>, Refusal> = thirds
        .par_iter()
        .map(|&third| {
            let (contacts, evaluations) = contacts_of(material, problem, problem.held(), third, half_widths)?;
            Ok((third, contacts, evaluations))
        })
        .collect();
    let seen = seen?;
    let evaluations = seen.iter().map(|(_, _, evaluations)| evaluations).sum();
    let contacts = seen.into_iter().flat_map(|(third, contacts, _)| contacts.into_iter().map(move |contact| (third, contact))).collect();
    Ok((contacts, evaluations))
}

/// A contact with the third unknown that it has, and why no branch was followed from it.
type LeftOver = (ContactAt, f64, Refusal);

/// The branches through contacts that lie on none of those known, after these.
pub(super) fn branches_through(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    mut branches: Vec<Branch>,
    mut open: Vec<(f64, ContactAt)>,
) -> (Vec<Branch>, Vec<LeftOver>) {
    let mut left_over = Vec::new();
    while let Some((third, contact)) = open.pop() {
        let parameter = if problem.path == BranchPath::Loads { contact.mean_pressure } else { third.exp() };
        if branches.len() >= MOST_BRANCHES {
            let reason = Refusal::NotConverged { what: "the branches of a problem", detail: format!("more than {MOST_BRANCHES}") };
            left_over.push((contact, parameter, reason));
            continue;
        }
        let ContactAt { half_width, eccentricity, mean_pressure, .. } = contact;
        let start = BranchStart::Near { half_width, eccentricity, mean_pressure, parameter };
        match trace(material, &BranchProblem { start, ..*problem }) {
            Ok(branch) if lies_on(problem, &branch, third, &contact) => {
                open.retain(|(third, contact)| !lies_on(problem, &branch, *third, contact));
                branches.push(branch);
            }
            Ok(_) => {
                let reason = Refusal::NotConverged { what: "a branch", detail: "followed from this contact it does not pass it".into() };
                left_over.push((contact, parameter, reason));
            }
            Err(refusal) => left_over.push((contact, parameter, refusal)),
        }
    }
    (branches, left_over)
}

/// Whether a contact of the scan lies on a branch.
fn lies_on(problem: &BranchProblem, branch: &Branch, third: f64, contact: &ContactAt) -> bool {
    let half_width_held = matches!(problem.held(), Some(SlidingControl::HalfWidth(_)));
    let first = if half_width_held { contact.mean_pressure } else { place_of(problem, contact.half_width) };
    let here = [first, contact.eccentricity, if problem.path == BranchPath::Loads { contact.mean_pressure } else { third }];
    branch.curve.windows(2).any(|pair| {
        let [from, to] = pair else { return false };
        let near = |unknowns: [f64; 3]| {
            let [first, mut ahead, third]: [f64; 3] = std::array::from_fn(|index| unknowns[index] - here[index]);
            if problem.indenter == Indenter::Wave {
                // A wave repeats.
                ahead -= 2.0 * PI * (ahead / (2.0 * PI)).round();
            }
            [first, ahead, third].iter().zip(from.scales).map(|(off, scale)| (off / scale).abs()).fold(0.0, f64::max)
        };
        let length = (to.arclength - from.arclength).abs();
        if near(from.unknowns) > 2.0 * length + ON_CURVE {
            return false;
        }
        let nearest = (0..=20).map(|index| near(interpolated(from, to, f64::from(index) / 20.0))).fold(f64::INFINITY, f64::min);
        nearest < ON_CURVE + 0.05 * length
    })
}
