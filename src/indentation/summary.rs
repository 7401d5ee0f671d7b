//! What is reported of every point of an integration, whether or not the path still holds it.

use super::solution::{Event, EventKind, PathPoint};
use serde::{Deserialize, Serialize};

/// Points of a peak that are held before and after its top, and points of the polynomial through it.
const BESIDE: usize = 4;
const POINTS: usize = 5;

/// Largest magnitudes, defects and the largest tension of an integration.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Largest |Δ|, |F|, a and |K_I|.
    pub scales: [f64; 4],
    /// Largest defect of the edge condition, C/Δγ − 1.
    pub residual: f64,
    defect: f64,
    turned: f64,
    /// The last points before the newest one.
    recent: Vec<PathPoint>,
    /// The point of the largest tension with up to [`BESIDE`] on either side, and its place among them.
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

    /// Where the force pulls most, between points by the polynomial through the five nearest; none if nothing pulled.
    #[must_use]
    pub fn peak(&self) -> Option<Event<f64>> {
        let top = self.peak.get(self.top)?;
        // A top at a corner ends one piece of the path and begins the next: the peak may lie on either side of it.
        let next = self.peak.get(self.top + 1).map(|point| point.piece).filter(|piece| *piece != top.piece);
        let peak = [Some(top.piece), next].into_iter().flatten().fold(Event::at(EventKind::LargestTension, top), |peak, piece| {
            let points: Vec<&PathPoint> = self.points_of(piece).collect();
            let place = points.iter().position(|point| std::ptr::eq(*point, top));
            place.and_then(|place| refined(&points, place)).filter(|refined| refined.force < peak.force).unwrap_or(peak)
        });
        (peak.force < 0.0).then_some(peak)
    }

    /// What panels leave unknown of K_I there (Pa√m).
    #[must_use]
    pub fn intensity_floor_of_peak(&self) -> f64 {
        self.peak.get(self.top).map_or(0.0, PathPoint::intensity_floor)
    }

    /// The points of one piece of the path that are held, with the corner that it begins at.
    fn points_of(&self, piece: u32) -> impl Iterator<Item = &PathPoint> {
        let first = self.peak.iter().position(|point| point.piece == piece).unwrap_or(0);
        let own = move |point: &&PathPoint| point.piece == piece && point.contact_radius > 0.0;
        let corner = self.peak.get(first.saturating_sub(1)..first).unwrap_or(&[]).iter().filter(|point| point.contact_radius > 0.0);
        corner.chain(self.peak.iter().filter(own))
    }
}

/// The state of the largest tension between the points next to the one at a place; none where there are too few, or where the polynomial shoots over.
///
/// Over time, or over the radius, which goes on smoothly where the edge accelerates unstably: over that which needs its last point less.
fn refined(points: &[&PathPoint], place: usize) -> Option<Event<f64>> {
    let first = place.saturating_sub(POINTS / 2).min(points.len().saturating_sub(POINTS));
    let near = points.get(first..points.len().min(first + POINTS)).filter(|near| near.len() > 2)?;
    let over = |of: fn(&PathPoint) -> f64| {
        let path: Vec<(f64, f64)> = near.iter().map(|point| (of(point), -point.force)).collect();
        let one_way = path.windows(2).all(|pair| (pair[1].0 - pair[0].0) * (path[1].0 - path[0].0) > 0.0);
        let (refined, change, x) = one_way.then(|| top_of(&path, place - first)).flatten()?;
        Some((refined, change, weights(&path, x, None)))
    };
    // Steps shorter than the clock tells have equal times.
    let ways = [over(|point| point.time), over(|point| point.contact_radius)];
    let (refined, _, weights) = ways.into_iter().flatten().min_by(|one, other| one.1.total_cmp(&other.1))?;
    let top = points.get(place)?;
    // A polynomial through points of one smooth piece rises above them by no more than they differ by.
    let (least, most) = near.iter().fold((top.force, top.force), |(least, most), one| (least.min(one.force), most.max(one.force)));
    let states: Vec<Event<f64>> = near.iter().map(|point| Event::at(EventKind::LargestTension, point)).collect();
    let sum = |of: &dyn Fn(&Event<f64>) -> Option<f64>| -> Option<f64> {
        states.iter().zip(&weights).map(|(state, weight)| Some(weight * of(state)?)).sum()
    };
    let own = Event::at(EventKind::LargestTension, top);
    let there = own.with(|number, own| sum(&|state| state.number(number)).unwrap_or(own), |of, own| Some(sum(&of).unwrap_or(own)));
    (refined + top.force <= most - least).then_some(Event { force: -refined, ..there })
}

/// The part of each value in the polynomial through all of a path, or all but one, at a place.
fn weights(path: &[(f64, f64)], x: f64, without: Option<usize>) -> Vec<f64> {
    let kept = |k: &usize| Some(*k) != without;
    let weight = |(k, own): (usize, f64)| {
        let others = path.iter().enumerate().filter(|(l, _)| *l != k && kept(l));
        if kept(&k) { others.map(|(_, (other, _))| (x - other) / (own - other)).product::<f64>() } else { 0.0 }
    };
    path.iter().enumerate().map(|(k, (own, _))| weight((k, *own))).collect()
}

/// The largest value beside a point of the polynomial through some, what it would differ by there without the point that is furthest away, and where it is.
fn top_of(path: &[(f64, f64)], place: usize) -> Option<(f64, f64, f64)> {
    let (top, before, after) = (path.get(place)?, path.get(place.saturating_sub(1))?, path.get(place + 1).or(path.last())?);
    let at =
        |x: f64, without: Option<usize>| weights(path, x, without).iter().zip(path).map(|(weight, (_, value))| weight * value).sum::<f64>();
    let (mut low, mut high) = (before.0, after.0);
    for _ in 0..60 {
        let (first, second) = (low + 0.382 * (high - low), high - 0.382 * (high - low));
        if at(first, None) < at(second, None) { low = first } else { high = second }
    }
    let x = 0.5 * (low + high);
    let distance = |k: &usize| path.get(*k).map_or(0.0, |point| (point.0 - top.0).abs());
    let furthest = (0..path.len()).max_by(|one, other| distance(one).total_cmp(&distance(other)));
    Some((at(x, None), (at(x, None) - at(x, furthest)).abs(), x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pull whose force is a parabola of the radius, largest between two steps, under times that a clock tells.
    fn pull(times: [f64; 6]) -> Option<f64> {
        let radii = [1.0, 0.9, 0.82, 0.75, 0.69, 0.64];
        let mut summary = Summary::default();
        for (time, contact_radius) in times.into_iter().zip(radii) {
            let off: f64 = contact_radius - 0.8;
            let force = -3.0 + 40.0 * off * off;
            let point = PathPoint {
                time,
                penetration: 0.1,
                force,
                contact_radius,
                stress_intensity_factor: 1.0,
                unresolved_intensity: 0.0,
                residual: 0.0,
                piece: 0,
                energies: None,
            };
            summary.add(&point, None);
        }
        summary.peak().map(|peak| {
            // The radius of the parabola's top, and a penetration that stays.
            assert!((peak.contact_radius - 0.8).abs() < 1e-7 && (peak.penetration - 0.1).abs() < 1e-14, "{peak:?}");
            -peak.force
        })
    }

    fn is_the_peak(found: Option<f64>) -> bool {
        found.is_some_and(|found| (found - 3.0).abs() < 1e-12)
    }

    #[test]
    fn the_largest_tension_of_an_edge_that_accelerates_in_steps_shorter_than_the_clock_resolves() {
        assert!(is_the_peak(pull([1.0, 2.0, 2.5, 2.5, 2.5, 2.5])));
    }

    /// Over time the polynomial needs its last point more.
    #[test]
    fn the_largest_tension_is_taken_over_what_the_force_is_smooth_in() {
        assert!(is_the_peak(pull([1.0, 2.0, 2.5, 2.6, 2.601, 2.601_000_1])));
        // The force over time is the same parabola: both do.
        assert!(is_the_peak(pull([1.0, 1.1, 1.18, 1.25, 1.31, 1.36])));
    }
}
