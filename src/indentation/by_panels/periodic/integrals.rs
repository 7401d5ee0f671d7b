//! What a cycle gives: integrals and extremes, from rows at the Gauss points of its pieces.

use super::super::gauss::{Gauss, NODES};
use super::super::problem::Row;
use super::sinus::Sinus;
use std::f64::consts::PI;

/// Places at which an extreme is looked for in a piece, and sections of its place.
const SAMPLES: usize = 32;
const SECTIONS: usize = 40;

/// Pieces of a cycle, between cuts at which the path may have kinks.
#[derive(Debug, Clone)]
pub(super) struct Pieces(pub(super) Vec<(f64, f64)>);

/// Values of a cycle; ∮F dΔ (J), storage and loss stiffness (N/m), phase (rad), least and largest force (N) and radius (m), their means.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Measured {
    pub(super) work: f64,
    pub(super) storage: f64,
    pub(super) loss: f64,
    pub(super) phase: f64,
    pub(super) force: [f64; 2],
    pub(super) radius: [f64; 2],
    pub(super) mean_force: f64,
    pub(super) mean_radius: f64,
}

impl Pieces {
    /// The instants of the rows that a cycle needs.
    pub(super) fn instants(&self) -> impl Iterator<Item = f64> + '_ {
        self.0.iter().flat_map(|&(from, to)| Gauss::get().nodes.iter().map(move |x| from + (to - from) * x))
    }

    /// Everything of the cycle with these rows.
    pub(super) fn measured(&self, sinus: &Sinus, rows: &[Row]) -> Measured {
        let period = self.0.last().map_or(0.0, |piece| piece.1);
        let mut found = Measured { force: [f64::INFINITY, f64::NEG_INFINITY], ..Measured::default() };
        found.radius = found.force;
        for (&(from, to), rows) in self.0.iter().zip(rows.chunks_exact(NODES)) {
            let span = to - from;
            for ((x, weight), row) in Gauss::get().nodes.iter().zip(Gauss::get().weights).zip(rows) {
                let (time, part) = (from + span * x, weight * span);
                let (sin, cos) = (sinus.omega * time).sin_cos();
                found.work += part * row.force * sinus.rate(time);
                found.storage += part * row.force * sin;
                found.loss += part * row.force * cos;
                found.mean_force += part * row.force;
                found.mean_radius += part * row.contact_radius;
            }
            let of = |value: fn(&Row) -> f64, sign: f64| sign * largest(rows, |row| sign * value(row));
            for (pair, value) in [(&mut found.force, (|row| row.force) as fn(&Row) -> f64), (&mut found.radius, |row| row.contact_radius)] {
                *pair = [pair[0].min(of(value, -1.0)), pair[1].max(of(value, 1.0))];
            }
        }
        found.mean_force /= period;
        found.mean_radius /= period;
        let by_amplitude = 2.0 / (period * sinus.amplitude);
        (found.storage, found.loss) = (found.storage * by_amplitude, found.loss * by_amplitude);
        found.phase = found.loss.atan2(found.storage);
        found
    }
}

impl Measured {
    /// All numbers, with what an error of each is compared with.
    pub(super) fn numbers(&self, sinus: &Sinus) -> [(f64, f64); 10] {
        let stiffness = self.storage.hypot(self.loss);
        let force = self.force[0].abs().max(self.force[1].abs());
        let work = PI * sinus.amplitude * sinus.amplitude * stiffness;
        [
            (self.work, work),
            (self.storage, stiffness),
            (self.loss, stiffness),
            (self.phase, 1.0),
            (self.force[0], force),
            (self.force[1], force),
            (self.radius[0], self.radius[1]),
            (self.radius[1], self.radius[1]),
            (self.mean_force, force),
            (self.mean_radius, self.radius[1]),
        ]
    }
}

/// The largest value of the polynomial through rows at the Gauss points, on the whole piece.
fn largest(rows: &[Row], value: impl Fn(&Row) -> f64) -> f64 {
    let nodes = &Gauss::get().nodes;
    let at = |x: f64| -> f64 {
        let basis = |h: usize| (0..NODES).filter(|&k| k != h).map(|k| (x - nodes[k]) / (nodes[h] - nodes[k])).product::<f64>();
        rows.iter().enumerate().map(|(h, row)| basis(h) * value(row)).sum()
    };
    let place = |k: usize| k as f64 / SAMPLES as f64;
    let Some(best) = (0..=SAMPLES).max_by(|&one, &other| at(place(one)).total_cmp(&at(place(other)))) else { return f64::NAN };
    let (mut low, mut high) = (place(best.saturating_sub(1)), place((best + 1).min(SAMPLES)));
    let mut most = at(place(best));
    for _ in 0..SECTIONS {
        let [one, two] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
        let values = [at(one), at(two)];
        if values[0] > values[1] {
            high = two
        } else {
            low = one
        }
        most = most.max(values[0]).max(values[1]);
    }
    most
}
