//! Profile likelihood: how far a parameter can go until χ², minimised over all others, has risen by t².

use super::at::{Weighted, squares};
use super::covariance::Covariance;
use super::intervals::End;
use super::least_squares::{free, matrix};

/// Places that are tried on a side.
const MOST_TRIES: usize = 8;
/// An end is known well enough when √(rise)/t is this near to one.
const CLOSE: f64 = 0.02;
/// A fall of χ² below the minimum that is no scatter of the model.
const BETTER: f64 = 0.05;

/// Where the walk along a parameter begins.
pub(super) struct Minimum<'m> {
    pub(super) coordinates: &'m [f64],
    pub(super) misfit: f64,
    pub(super) jacobian: &'m [Vec<f64>],
    pub(super) covariance: &'m Covariance,
}

/// What a walk found.
pub(super) enum Walk {
    /// The end of the interval, as a coordinate.
    End(End),
    /// A lower χ² than that of the minimum, and where.
    Better(Vec<f64>, f64),
}

impl Minimum<'_> {
    /// The end of the interval of a parameter on a side (+1, −1); `t` in the root of χ².
    pub(super) fn walked(&self, weighted: &Weighted<'_>, place: usize, side: f64, t: f64) -> Walk {
        let at = self.coordinates.get(place).copied().unwrap_or(0.0);
        let [low, high] = weighted.problem.parameters.get(place).map_or([at, at], super::Parameter::ends);
        let bound = if side > 0.0 { high } else { low };
        let room = (bound - at).abs();
        let mut way = t * self.covariance.standard_error(place);
        // (way, √rise) on both sides of the end.
        let (mut inside, mut outside): ((f64, f64), Option<(f64, f64)>) = ((0.0, 0.0), None);
        for _ in 0..MOST_TRIES {
            let whole = !way.is_finite() || way >= room;
            way = if whole { room } else { way };
            let (there, misfit) = self.minimised(weighted, place, side * way);
            let rise = misfit - self.misfit;
            if rise < -BETTER && misfit.is_finite() {
                return Walk::Better(there, misfit);
            }
            let root = rise.max(0.0).sqrt();
            if whole && root <= t {
                return Walk::End(End::Open(bound));
            }
            if (root / t - 1.0).abs() <= CLOSE {
                return Walk::End(End::At(at + side * way * t / root));
            }
            if root < t {
                inside = (way, root);
            } else {
                outside = Some((way, root));
            }
            way = match outside {
                // The root of the rise is nearly straight.
                None => {
                    let slope = inside.1 / inside.0.max(f64::MIN_POSITIVE);
                    (t / slope).clamp(1.05 * inside.0, 4.0 * inside.0.max(1e-12))
                }
                Some((far, high)) if high.is_finite() => {
                    let part = (t - inside.1) / (high - inside.1);
                    inside.0 + (far - inside.0) * part.clamp(0.05, 0.95)
                }
                Some((far, _)) => 0.5 * (inside.0 + far),
            };
        }
        Walk::End(End::At(at + side * outside.map_or(inside.0, |far| far.0)))
    }

    /// χ² with one coordinate moved by so much, minimised over the others: along the covariance, then twice by the Jacobian of the minimum.
    fn minimised(&self, weighted: &Weighted<'_>, place: usize, way: f64) -> (Vec<f64>, f64) {
        let variance = self.covariance.matrix[(place, place)];
        let along = |other: usize| {
            if other == place {
                way
            } else if variance.is_finite() && variance > 0.0 {
                way * self.covariance.matrix[(other, place)] / variance
            } else {
                0.0
            }
        };
        let within = |coordinates: Vec<f64>| -> Vec<f64> {
            let ends = weighted.problem.parameters.iter().map(super::Parameter::ends);
            coordinates.into_iter().zip(ends).map(|(coordinate, [low, high])| coordinate.clamp(low, high)).collect()
        };
        let mut best = within(self.coordinates.iter().enumerate().map(|(other, at)| at + along(other)).collect());
        let mut residuals = weighted.residuals(&best);
        let mut misfit = squares(&residuals);
        let others: Vec<usize> = (0..self.coordinates.len()).filter(|&other| other != place).collect();
        if others.is_empty() || !misfit.is_finite() {
            return (best, misfit);
        }
        let columns: Vec<&[f64]> = others.iter().filter_map(|&other| self.jacobian.get(other)).map(Vec::as_slice).collect();
        let system = matrix(columns.into_iter(), residuals.len());
        for _ in 0..2 {
            let right: Vec<f64> = residuals.iter().map(|residual| -residual).collect();
            let Some(step) = free(&system, &right) else { break };
            let mut trial = best.clone();
            for (&other, step) in others.iter().zip(&step) {
                if let Some(coordinate) = trial.get_mut(other) {
                    *coordinate += step;
                }
            }
            let trial = within(trial);
            let found = weighted.residuals(&trial);
            let reached = squares(&found);
            if reached.is_nan() || reached >= misfit {
                break;
            }
            let gained = misfit - reached;
            (best, residuals, misfit) = (trial, found, reached);
            if gained < 0.02 {
                break;
            }
        }
        (best, misfit)
    }
}
