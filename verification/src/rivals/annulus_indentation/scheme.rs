//! The scheme in time: one dense system per trial edge, the memory in A_h.

use super::influence::{influence_matrix, place};
use crate::rivals::dense::Factors;
use faer::Mat;
use std::collections::HashMap;
use std::f64::consts::PI;
use viscotack::elastic::JkrSphere;
use viscotack::elastic::control::EquilibriumBranch;
use viscotack::refusal::{Refusal, require_finite, require_non_negative, require_positive};

/// A sphere, a one-term solid in moduli E*, and the two sizes of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnulusScheme {
    /// R (m).
    pub sphere_radius: f64,
    /// E0* (Pa).
    pub relaxed_modulus: f64,
    /// E∞* (Pa).
    pub glassy_modulus: f64,
    /// τ (s).
    pub retardation_time: f64,
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// δ (m).
    pub process_zone: f64,
    /// δ/λ.
    pub elements_per_zone: usize,
    /// ε (s), shortened so that every corner of the history is a step.
    pub time_step: f64,
    /// Whether the factors of an edge are kept for the next steps; as printed, each trial edge is a system of its own.
    pub keep_factors: bool,
}

/// Where the history starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AnnulusStart {
    /// The unloaded half-space jumps into contact, glassily.
    Untouched,
    /// The soft elastic contact.
    Relaxed,
}

/// One step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnulusPoint {
    /// t (s).
    pub time: f64,
    /// Δ (m).
    pub penetration: f64,
    /// F (N), compression positive.
    pub force: f64,
    /// a (m), between nodes by interpolation in C.
    pub contact_radius: f64,
}

/// A whole history.
#[derive(Debug, Clone, PartialEq)]
pub struct AnnulusPath {
    /// Steps, until the history or the contact ends.
    pub points: Vec<AnnulusPoint>,
    /// Whether the contact was lost before the end.
    pub detached: bool,
    /// Dense systems solved.
    pub solutions: u64,
    /// Dense matrices factored.
    pub factorizations: u64,
    /// Annuli of the whole mesh.
    pub annuli: usize,
}

/// A trial edge.
struct Trial {
    pressures: Vec<f64>,
    force: f64,
    work: f64,
}

struct Integrator<'s> {
    scheme: &'s AnnulusScheme,
    width: f64,
    influence: Mat<f64>,
    /// LU factors of the influence of the first n annuli.
    kept: HashMap<usize, Factors>,
    /// A_h.
    memory: Vec<f64>,
    edge: usize,
    solutions: u64,
    factorizations: u64,
}

/// How much the largest soft contact is exceeded by the mesh, over itself.
const SPARE: f64 = 1.25;
/// A mesh beyond this would need gigabytes.
const MOST_ANNULI: usize = 8000;

impl AnnulusScheme {
    /// Follows Δ through the corners (t, Δ), straight between them; ends early when the contact is lost.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for numbers out of range or times that do not rise; [`Refusal::NoSuchState`] without a first contact;
    /// [`Refusal::NotConverged`] for a contact that outgrows its mesh.
    pub fn run(&self, start: AnnulusStart, corners: &[(f64, f64)]) -> Result<AnnulusPath, Refusal> {
        let &[(first_time, first_depth), ..] = corners else {
            return Err(Refusal::out_of_range("corners", 0.0, "at least one"));
        };
        let mut integrator = Integrator::new(self, corners)?;
        // The first contact is elastic, with A = 0 (glassy) or p/E0 (soft) in the role of (4.17).
        let modulus = match start {
            AnnulusStart::Untouched => self.glassy_modulus,
            AnnulusStart::Relaxed => self.relaxed_modulus,
        };
        integrator.edge = integrator.influence.nrows() - self.elements_per_zone;
        let first = integrator.settle(first_depth, 1.0 / modulus, 1.0)?.ok_or(Refusal::NoSuchState {
            reason: "no contact larger than its process zone is in equilibrium at the first penetration".into(),
            limit_name: "the process zone",
            limit: self.process_zone,
        })?;
        let mut path =
            AnnulusPath { points: Vec::new(), detached: false, solutions: 0, factorizations: 0, annuli: integrator.memory.len() };
        integrator.remember(&first.0, 1.0 / modulus, 1.0);
        path.points.push(first.1.at(first_time, first_depth));
        'legs: for leg in corners.windows(2) {
            let &[(from_time, from_depth), (to_time, to_depth)] = leg else { continue };
            let duration = to_time - from_time;
            let steps = (duration / self.time_step).ceil().max(1.0);
            let step = duration / steps;
            let implicit = step / self.retardation_time;
            let compliance = 1.0 / self.glassy_modulus + implicit / self.relaxed_modulus;
            for index in 1..=steps as u64 {
                let part = index as f64 / steps;
                let depth = from_depth + (to_depth - from_depth) * part;
                let Some((trial, reading)) = integrator.settle(depth, compliance, 1.0 + implicit)? else {
                    path.detached = true;
                    break 'legs;
                };
                integrator.remember(&trial, compliance, 1.0 + implicit);
                path.points.push(reading.at(from_time + duration * part, depth));
            }
        }
        path.solutions = integrator.solutions;
        path.factorizations = integrator.factorizations;
        Ok(path)
    }
}

/// F and a between two nodes.
struct Reading {
    force: f64,
    contact_radius: f64,
}

impl Reading {
    fn at(&self, time: f64, penetration: f64) -> AnnulusPoint {
        AnnulusPoint { time, penetration, force: self.force, contact_radius: self.contact_radius }
    }
}

impl<'s> Integrator<'s> {
    fn new(scheme: &'s AnnulusScheme, corners: &[(f64, f64)]) -> Result<Self, Refusal> {
        require_positive("time_step", scheme.time_step)?;
        require_positive("retardation_time", scheme.retardation_time)?;
        require_positive("process_zone", scheme.process_zone)?;
        require_positive("glassy_modulus", scheme.glassy_modulus)?;
        if scheme.elements_per_zone == 0 {
            return Err(Refusal::out_of_range("elements_per_zone", 0.0, "at least 1"));
        }
        let soft = JkrSphere::new(scheme.sphere_radius, scheme.relaxed_modulus, scheme.work_of_adhesion)?;
        let mut deepest = 0.0_f64;
        let mut before = f64::NEG_INFINITY;
        for &(time, depth) in corners {
            require_non_negative("time", time)?;
            if time <= before {
                return Err(Refusal::out_of_range("time", time, "larger than the time before it"));
            }
            before = time;
            deepest = deepest.max(require_finite("penetration", depth)?);
        }
        let largest = soft.state_by_penetration(deepest, EquilibriumBranch::Stable)?.contact_radius;
        let width = scheme.process_zone / scheme.elements_per_zone as f64;
        let annuli = (SPARE * largest / width).ceil() + 2.0 * scheme.elements_per_zone as f64;
        if annuli > MOST_ANNULI as f64 {
            return Err(Refusal::out_of_range(
                "elements_per_zone",
                scheme.elements_per_zone as f64,
                "such that at most 8000 annuli are needed",
            ));
        }
        let annuli = annuli as usize;
        let influence = influence_matrix(annuli, width);
        let memory = vec![0.0; annuli];
        Ok(Self { scheme, width, influence, kept: HashMap::new(), memory, edge: 0, solutions: 0, factorizations: 0 })
    }

    fn indenter(&self, index: usize, depth: f64) -> f64 {
        let r = place(index, self.width);
        depth - 0.5 * r / self.scheme.sphere_radius * r
    }

    /// (4.17) on the first `edge` annuli, and the closure there.
    fn trial(&mut self, edge: usize, depth: f64, compliance: f64, lag: f64) -> Result<Trial, Refusal> {
        let side = Mat::from_fn(edge, 1, |h, _| {
            let known = self.memory.get(h).copied().unwrap_or(f64::NAN);
            (lag * self.indenter(h, depth) - known) / compliance
        });
        self.solutions += 1;
        let block = self.influence.as_ref().submatrix(0, 0, edge, edge);
        let solution = if self.scheme.keep_factors {
            let factors = match self.kept.remove(&edge) {
                Some(factors) => factors,
                None => {
                    self.factorizations += 1;
                    Factors::of(block)?
                }
            };
            let solution = factors.solved(side.as_ref());
            // An edge that was passed long ago is not needed again soon: two neighbours to each side stay.
            self.kept.retain(|other, _| other.abs_diff(edge) <= 2);
            self.kept.insert(edge, factors);
            solution?
        } else {
            self.factorizations += 1;
            Factors::of(block)?.solved(side.as_ref())?
        };
        let pressures: Vec<f64> = (0..edge).map(|q| solution[(q, 0)]).collect();
        let ring = |q: usize| PI * self.width * self.width * (2.0 * q as f64 + 1.0);
        let force = pressures.iter().enumerate().map(|(q, p)| p * ring(q)).sum();
        let zone = self.scheme.elements_per_zone;
        let mut work = 0.0;
        let mut overlap = false;
        for (outside, tension) in (edge..).zip(pressures.iter().skip(edge.saturating_sub(zone)).map(|p| -p)) {
            let response: f64 = pressures.iter().enumerate().map(|(q, p)| self.influence[(outside, q)] * p).sum();
            let gap = (compliance * response + self.memory.get(outside).copied().unwrap_or(f64::NAN)) / lag - self.indenter(outside, depth);
            overlap |= outside == edge && gap < 0.0;
            work += tension * gap;
        }
        work /= 2.0 * zone as f64;
        // A pressed edge over an overlapping surface works positively as well; it has to advance.
        let pressed = pressures.last().is_some_and(|p| *p > 0.0);
        Ok(Trial { pressures, force, work: if overlap && pressed { -work.abs() } else { work } })
    }

    /// Lets the edge go, annulus by annulus, to C(n) ≤ Δγ < C(n + 1); none if there is no such place beyond the process zone.
    fn settle(&mut self, depth: f64, compliance: f64, lag: f64) -> Result<Option<(Trial, Reading)>, Refusal> {
        let (goal, zone) = (self.scheme.work_of_adhesion, self.scheme.elements_per_zone);
        let mut low_edge = self.edge;
        let mut low = self.trial(low_edge, depth, compliance, lag)?;
        let mut high = None;
        while low.work > goal {
            if low_edge <= zone + 1 {
                return Ok(None);
            }
            low_edge -= 1;
            high = Some(std::mem::replace(&mut low, self.trial(low_edge, depth, compliance, lag)?));
        }
        let high = match high {
            Some(high) => high,
            None => loop {
                if low_edge + 1 + zone > self.memory.len() {
                    return Err(Refusal::NotConverged { what: "the annulus scheme", detail: "the contact outgrows its mesh".into() });
                }
                let next = self.trial(low_edge + 1, depth, compliance, lag)?;
                if next.work > goal {
                    break next;
                }
                low = next;
                low_edge += 1;
            },
        };
        let part = (goal - low.work) / (high.work - low.work);
        let reading = Reading { force: low.force + part * (high.force - low.force), contact_radius: (low_edge as f64 + part) * self.width };
        let (edge, nearer) = if part < 0.5 { (low_edge, low) } else { (low_edge + 1, high) };
        self.edge = edge;
        Ok(Some((nearer, reading)))
    }

    /// (4.18), with u inside and outside from (4.17).
    fn remember(&mut self, trial: &Trial, compliance: f64, lag: f64) {
        let mut responses = vec![0.0; self.memory.len()];
        // Column by column, as the matrix is stored.
        for (q, pressure) in trial.pressures.iter().enumerate() {
            for (h, response) in responses.iter_mut().enumerate() {
                *response += self.influence[(h, q)] * pressure;
            }
        }
        for (known, response) in self.memory.iter_mut().zip(responses) {
            *known = (compliance * response + *known) / lag - response / self.scheme.glassy_modulus;
        }
    }
}
