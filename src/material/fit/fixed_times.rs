//! Strengths at given times, all positive: what an expansion of a law needs, at the price of a few linear systems.

use super::observation::Observation;
use super::shape::SeriesShape;
use crate::fit::least_squares;
use faer::Mat;

/// Most systems: each leaves out at least one time.
const MOST_SYSTEMS: usize = 40;

impl SeriesShape {
    /// The best strengths at given times beside a given constant; times whose strength comes out negative are left out. Also how many linear systems
    /// that took.
    #[must_use]
    pub fn positive(constant: f64, times: &[f64], data: &[Observation]) -> (Self, usize) {
        let mut times = times.to_vec();
        let right: Vec<f64> =
            data.iter().map(|observation| (observation.value - constant * observation.quantity.constant()) / observation.scale).collect();
        for system in 1..=MOST_SYSTEMS {
            let matrix = Mat::from_fn(data.len(), times.len(), |i, j| {
                let observation = &data[i];
                observation.quantity.kernel(observation.quantity.argument(observation.at, times[j])).0 / observation.scale
            });
            // Columns are nearly dependent where places are close: with pivoting, small strengths stay small.
            let Some(strengths) = least_squares::free(&matrix, &right) else { break };
            if strengths.iter().all(|&strength| strength > 0.0) {
                return (Self::new(constant, strengths.into_iter().zip(times).collect()), system);
            }
            times = strengths.iter().zip(&times).filter(|&(&strength, _)| strength > 0.0).map(|(_, &time)| time).collect();
        }
        (Self::new(constant, Vec::new()), MOST_SYSTEMS)
    }
}
