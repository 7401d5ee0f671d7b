//! The energy release rate of a sphere, G = dU/dA − F dΔ/dA (thesis Eq 4.25), from the account of energies of an integration: at pull-off of a retraction
//! from a relaxed contact, or at given penetrations of an approach.
//!
//! Over a segment of the path G is −(∫F dΔ − change of U) over the change of the area A = πa²: exact means, no derivative is taken.

use super::super::table::Table;
use serde::Deserialize;
use std::f64::consts::PI;
use viscotack::indentation::{Adhesion, Energies, History, IndentationProblem, PathPoint, Profile, run};
use viscotack::material::{PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct SphereRelease {
    /// γ̃ = Δγ/(πE0*R).
    work_of_adhesion: f64,
    /// δ/R.
    process_zone: f64,
    stiffening_ratio: f64,
    /// Vρ/R of each run.
    speeds: Vec<f64>,
    /// Retraction from this relaxed Δ/R, to `end`; G at pull-off.
    retraction_from: Option<f64>,
    /// Where the history ends.
    end: f64,
    /// Approach of an untouched surface; G at these Δ/R.
    #[serde(default)]
    at: Vec<f64>,
    accuracy: f64,
    /// The change of the area, over the area, that G is a mean over.
    share: f64,
}

impl SphereRelease {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let term = RelaxationTerm { modulus: self.stiffening_ratio - 1.0, relaxation_time: 1.0 };
        let material = PlaneMaterial::from_relaxation(1.0, &[term])?;
        let work = PI * self.work_of_adhesion;
        let adhesion = Adhesion { work_of_adhesion: work, process_zone: self.process_zone };
        let mut columns = [const { Vec::new() }; 4];
        for &speed in &self.speeds {
            let history = History::penetration(self.retraction_from.unwrap_or(0.0)).at_speed(self.end, speed);
            let mut problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history);
            problem.energies = true;
            problem.accuracy = self.accuracy;
            if self.retraction_from.is_some() {
                problem = problem.relaxed();
            }
            let solution = run(&material, &problem)?;
            let path = &solution.integration.path;
            let ratio = solution.pull_off_force().map_or(f64::NAN, |tension| tension.value / (1.5 * work * PI));
            let places: Vec<(f64, usize)> = if self.retraction_from.is_some() {
                let largest = path.iter().enumerate().min_by(|one, other| one.1.force.total_cmp(&other.1.force));
                largest.map(|(index, point)| (point.penetration, index)).into_iter().collect()
            } else {
                let before = |depth: f64| path.partition_point(|point| point.penetration < (1.0 - 1e-12) * depth).saturating_sub(1);
                self.at.iter().map(|&depth| (depth, before(depth))).collect()
            };
            for (depth, index) in places {
                let release = self.release(path, index).map_or(f64::NAN, |release| release / work);
                for (column, number) in columns.iter_mut().zip([speed, depth, release, ratio]) {
                    column.push(number);
                }
            }
        }
        let [speed, penetration, release, ratio] = columns;
        Ok(Table::exact(&[("speed", speed), ("penetration", penetration), ("release", release), ("pull_off_ratio", ratio)]))
    }

    /// The mean of G from a place on, or up to it where the path ends there, until the area has changed by the share.
    fn release(&self, path: &[PathPoint], index: usize) -> Option<f64> {
        let here = path.get(index)?;
        let far = |point: &&PathPoint| (point.contact_radius / here.contact_radius).powi(2) - 1.0;
        let after = path.iter().skip(index + 1).find(|point| far(point).abs() >= self.share && point.contact_radius > 0.0);
        let before = path.iter().take(index).rev().find(|point| far(point).abs() >= self.share);
        let other = after.or(before)?;
        let (one, two): (Energies, Energies) = (here.energies?, other.energies?);
        let area = PI * (other.contact_radius.powi(2) - here.contact_radius.powi(2));
        Some((two.stored - one.stored - (two.external_work - one.external_work)) / area)
    }
}
