//! What is told of every point of a march, whether or not the path still holds it.

use super::solution::PathPoint;
use serde::{Deserialize, Serialize};

/// Points of a peak before and after its top.
const BESIDE: usize = 2;

/// Largest magnitudes, defects and the largest tension of a march.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Largest |Δ|, |F|, a and |K_I|.
    pub scales: [f64; 4],
    /// Largest defect of the edge condition.
    pub residual: f64,
    defect: f64,
    turned: f64,
    /// The last points before the newest one.
    recent: Vec<PathPoint>,
    /// The point of the largest tension with up to two on either side, and its place among them.
    peak: Vec<PathPoint>,
    top: usize,
}

impl Summary {
    /// Takes a point in; `before` is the one before it.
    pub(super) fn add(&mut self, point: &PathPoint, before: Option<&PathPoint>) {
        let values = [point.penetration, point.force, point.contact_radius, point.stress_intensity_factor];
        for (scale, value) in self.scales.iter_mut().zip(values) {
            *scale = scale.max(value.abs());
        }
        self.residual = self.residual.max(point.residual.abs());
        if let (Some(now), Some(then)) = (point.energies, before.and_then(|before| before.energies)) {
            self.defect += now.balance_defect.abs();
            self.turned += (now.external_work - then.external_work).abs() + (now.tip_work - then.tip_work).abs();
        }
        let highest = self.peak.get(self.top).is_none_or(|top| point.force <= top.force);
        if highest {
            self.peak = self.recent.clone();
            self.top = self.peak.len();
            self.peak.push(*point);
        } else if self.peak.len() <= self.top + BESIDE {
            self.peak.push(*point);
        }
        self.recent.push(*point);
        if self.recent.len() > BESIDE {
            self.recent.remove(0);
        }
    }

    /// Σ|defect| of the power balance over the energy turned over.
    #[must_use]
    pub fn balance_defect(&self) -> f64 {
        if self.turned > 0.0 { self.defect / self.turned } else { 0.0 }
    }

    /// The largest tension −F (N), between points by the polynomial through five; none if nothing pulled.
    #[must_use]
    pub fn largest_tension(&self) -> Option<f64> {
        let top = self.peak.get(self.top)?;
        // A peak at a corner, or at an end, is the point itself.
        let near: Vec<&PathPoint> = self.peak.iter().filter(|point| point.piece == top.piece && point.contact_radius > 0.0).collect();
        let position = near.iter().position(|point| std::ptr::eq(*point, top));
        let mut peak = -top.force;
        if let Some(position) = position.filter(|position| *position > 0 && position + 1 < near.len()) {
            let at = |time: f64| {
                near.iter()
                    .enumerate()
                    .map(|(k, one)| {
                        let others = near.iter().enumerate().filter(|(l, _)| *l != k);
                        -one.force * others.map(|(_, other)| (time - other.time) / (one.time - other.time)).product::<f64>()
                    })
                    .sum::<f64>()
            };
            let (mut low, mut high) = (near[position - 1].time, near[position + 1].time);
            for _ in 0..60 {
                let (first, second) = (low + 0.382 * (high - low), high - 0.382 * (high - low));
                if at(first) < at(second) { low = first } else { high = second }
            }
            let refined = at(0.5 * (low + high));
            let steps = (near[position - 1].force - top.force).abs().max((near[position + 1].force - top.force).abs());
            if refined > peak && refined - peak <= steps {
                peak = refined;
            }
        }
        (peak > 0.0).then_some(peak)
    }
}
