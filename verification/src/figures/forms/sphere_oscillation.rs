//! A sphere on a relaxed contact whose penetration oscillates: about one depth with a frequency that rises linearly, or with one frequency upon a
//! slow retraction (thesis Sec 4.8, Fig 4.9).
//!
//! Rows with `cycle` = 0 are points of the path, those with `cycle` = 1 whole cycles: their work, mean frequency and extremes. Units: R, πE0*R²,
//! πE0*R³, the relaxation time; frequencies are angular.

use super::super::table::Table;
use serde::Deserialize;
use std::f64::consts::{PI, TAU};
use viscotack::indentation::{Adhesion, FrequencySweep, History, IndentationProblem, Oscillation, Profile, Start, integrate};
use viscotack::material::{PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;

/// Points of a path that are kept.
const MOST_POINTS: usize = 6000;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct SphereOscillation {
    /// γ̃ = Δγ/(πE0*R).
    work_of_adhesion: f64,
    /// δ/R.
    process_zone: f64,
    stiffening_ratio: f64,
    /// Δ/R of the relaxed start.
    penetration: f64,
    /// Δ/R at the end; that of the start for a sweep.
    end: f64,
    duration: f64,
    amplitude: f64,
    /// ωρ at the start and at the end; none: no oscillation.
    frequencies: Option<[f64; 2]>,
    /// Of one integration, as of [`integrate`]; no second integration assesses it.
    tolerance: f64,
}

impl SphereOscillation {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let term = RelaxationTerm { modulus: self.stiffening_ratio - 1.0, relaxation_time: 1.0 };
        let material = PlaneMaterial::from_relaxation(1.0, &[term])?;
        let work = PI * self.work_of_adhesion;
        let adhesion = Adhesion { work_of_adhesion: work, process_zone: self.process_zone };
        let history = History::penetration(self.penetration);
        let oscillation =
            self.frequencies.map(|[from, to]| Oscillation::swept(self.amplitude, from / TAU, to / TAU, FrequencySweep::Linear));
        let history = match oscillation {
            Some(oscillation) => history.ramp_oscillating(self.end, oscillation, self.duration),
            None => history.ramp(self.end, self.duration),
        };
        let mut problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history);
        problem.start = Start::Relaxed;
        let solution = integrate(&material, &problem, self.tolerance)?;
        let mut columns = [const { Vec::new() }; 7];
        let mut push = |numbers: [f64; 7]| {
            for (column, number) in columns.iter_mut().zip(numbers) {
                column.push(number);
            }
        };
        let frequency = |time: f64| oscillation.map_or(0.0, |oscillation| TAU * oscillation.frequency_at(time, self.duration));
        let path = &solution.path;
        let stride = path.len().div_ceil(MOST_POINTS).max(1);
        for point in path.iter().filter(|point| point.contact_radius > 0.0).step_by(stride) {
            push([0.0, point.time, point.penetration, point.force / PI, point.contact_radius, frequency(point.time), f64::NAN]);
        }
        for cycle in &solution.cycles {
            let mean = TAU / (cycle.end - cycle.start);
            push([
                1.0,
                0.5 * (cycle.start + cycle.end),
                cycle.penetration[0],
                cycle.force[0] / PI,
                cycle.contact_radius[0],
                mean,
                cycle.work / PI,
            ]);
        }
        let [cycle, time, penetration, force, radius, frequency, work] = columns;
        Ok(Table::exact(&[
            ("cycle", cycle),
            ("time", time),
            ("penetration", penetration),
            ("force", force),
            ("contact_radius", radius),
            ("frequency", frequency),
            ("work", work),
        ]))
    }
}
