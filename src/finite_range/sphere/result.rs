//! What a run gives: rows, events, and the evidence for them. Units as in [`super::problem`].

use super::kept_surface::Surface;
use super::problem::Accuracy;
use super::state::Energies;

/// What sums of the durations of a history may be rounded by, relative.
pub const SUM_OF_DURATIONS: f64 = 1e-12;
/// A time that is passed but for rounding, relative: a step ended on it.
pub(super) const LANDED: f64 = 1e-14;

/// The state at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Record {
    /// Time since the start, in the unit of the retardation times.
    pub time: f64,
    /// Penetration (h₀), positive into the body.
    pub penetration: f64,
    /// Force (RΔγ), positive in compression.
    pub force: f64,
    /// Radius (√(R h₀)) at which the gap equals that of the law's largest tension; zero if the gap is wider everywhere.
    pub contact_radius: f64,
    /// Radius (√(R h₀)) at which the tension is largest; zero at the centre.
    pub tension_radius: f64,
    /// Stored energies (RΔγh₀).
    pub energies: Energies,
    /// ∫ F dΔ since the start (RΔγh₀): positive where work was put in.
    pub work: f64,
    /// Energy lost in the Voigt elements since the start (RΔγh₀).
    pub dissipated: f64,
    /// Energy lost in jumps since the start (RΔγh₀).
    pub released: f64,
    /// Work − change of the energies − losses (RΔγh₀): zero but for the errors of the method.
    pub residual: f64,
}

/// A sudden change to the next equilibrium down the energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// Time at which it was over.
    pub time: f64,
    /// Contact radius before it (√(R h₀)).
    pub radius_before: f64,
    /// Penetration before it (h₀); known to about 1e-5.
    pub penetration: f64,
    /// Force before it (RΔγ). Near a fold it varies by up to 3e-3 (relative) with the tolerances.
    pub force_before: f64,
    /// Force after it (RΔγ).
    pub force_after: f64,
    /// Penetration after it (h₀); differs from the one before where the penetration is not imposed.
    pub penetration_after: f64,
    /// Contact radius after it (√(R h₀)); zero if separated.
    pub radius_after: f64,
    /// Energy lost in it (RΔγh₀).
    pub released: f64,
}

/// What happened in one leg of the history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegSummary {
    /// The first state.
    pub begin: Record,
    /// The largest tension (the most negative force) of the leg.
    pub largest_tension: Record,
    /// The last instant at which the force went from compression to tension, if it did.
    pub zero_of_force: Option<Record>,
    /// The last state.
    pub end: Record,
}

impl LegSummary {
    /// Work ∫ F dΔ (RΔγh₀) from the zero of force (or from the beginning, if the force is not positive there) to the end.
    #[must_use]
    pub fn work_of_separation(&self) -> f64 {
        self.end.work - self.tension_begins().work
    }

    /// As [`LegSummary::work_of_separation`], to the largest tension only.
    #[must_use]
    pub fn work_to_pull_off(&self) -> f64 {
        self.largest_tension.work - self.tension_begins().work
    }

    fn tension_begins(&self) -> &Record {
        self.zero_of_force.as_ref().unwrap_or(&self.begin)
    }
}

/// Evidence of one run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// The largest energy residual of a row, in RΔγh₀.
    pub energy_residual: f64,
    /// The largest energy or work of a row, in RΔγh₀: the scale of the residual.
    pub energy_scale: f64,
    /// The largest number of nodes.
    pub nodes: usize,
    /// Accepted steps.
    pub steps: usize,
    /// Steps repeated because of their error.
    pub rejected: usize,
    /// Steps given up because Newton's method found no solution.
    pub failed: usize,
    /// Steps repeated on a finer mesh.
    pub refined: usize,
    /// Jacobians factored.
    pub factorisations: usize,
    /// Iterations of Newton's method.
    pub iterations: usize,
    /// The last correction of the gap of the last contact, in h₀.
    pub newton_residual: f64,
    /// The tolerances of the run.
    pub accuracy: Accuracy,
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Every accepted step, the start and the landings of jumps, in the order of time.
    pub rows: Vec<Record>,
    /// One for each leg that ended.
    pub legs: Vec<LegSummary>,
    /// At the times that were asked for and reached.
    pub surfaces: Vec<Surface>,
    /// In the order of time.
    pub jumps: Vec<Jump>,
    /// Where a contact ended, smoothly or by a jump: the gap became wider everywhere than that of the largest tension.
    pub losses: Vec<Record>,
    /// Under force control: the last state before no equilibrium exists any more. The run ends there.
    pub detachment: Option<Record>,
    /// Evidence.
    pub certificate: Certificate,
}

impl Run {
    /// The largest tension of the last leg (RΔγ), positive; zero if no leg ended.
    #[must_use]
    pub fn pull_off_force(&self) -> f64 {
        self.legs.last().map_or(0.0, |leg| -leg.largest_tension.force)
    }

    /// The row at a time, if there is one ([`row_at`]).
    #[must_use]
    pub fn at(&self, time: f64) -> Option<&Record> {
        row_at(&self.rows, time)
    }
}

/// Of rows in the order of time the one at a time, the first of equal ones; nothing if none is there but for the rounding of sums of durations.
///
/// Steps end on instants to the last digit, and after a long rest a quick leg has many rows within that rounding: the nearest is meant.
#[must_use]
pub fn row_at(rows: &[Record], time: f64) -> Option<&Record> {
    let off = |row: &Record| (row.time - time).abs();
    let after = rows.partition_point(|row| row.time < time * (1.0 - SUM_OF_DURATIONS));
    let around = rows.get(after..)?.iter().take_while(|row| off(row) <= SUM_OF_DURATIONS * time.abs());
    around.min_by(|a, b| off(a).total_cmp(&off(b)))
}
