//! The shift between two neighbouring isotherms along the frequency, from the values that both reach.

use super::observation::{Observation, Quantity};
use super::overlap::{LogCurve, differences};

/// A curve of moduli that rise with frequency: ln ω or −ln t, and ln E′, ln R or −ln J; with E″ beside it.
pub(super) struct Isotherm {
    rising: LogCurve,
    loss: LogCurve,
}

/// Most points of a curve: more are averaged.
const MOST_POINTS: usize = 200;
/// Points that both curves must have in common.
const LEAST_POINTS: usize = 3;
/// The first guess is improved within this many decades, in steps of this many.
const REACH: [f64; 2] = [1.0, 0.02];

impl Isotherm {
    pub(super) fn new(data: &[Observation]) -> Self {
        let of = |wanted: &dyn Fn(Quantity) -> bool| {
            let chosen = data.iter().filter(|one| wanted(one.quantity) && one.value > 0.0);
            let mut points: LogCurve = chosen
                .map(|one| {
                    let (at, value) = (one.at.ln(), one.value.ln());
                    (if one.quantity.by_frequency() { at } else { -at }, if one.quantity == Quantity::Creep { -value } else { value })
                })
                .collect();
            points.sort_by(|left, right| left.0.total_cmp(&right.0));
            averaged(&points)
        };
        Self { rising: of(&|quantity| quantity != Quantity::Loss), loss: of(&|quantity| quantity == Quantity::Loss) }
    }

    /// What is added to ln ω of `self` so that it lies on `other`; or how many points they have in common, too few.
    pub(super) fn onto(&self, other: &Self, vertical: bool) -> Result<f64, usize> {
        let (own, others) = (monotone(&self.rising), monotone(&other.rising));
        let (mut weight, mut sum, mut common) = (0.0, 0.0, 0);
        for (points, line, sign) in [(&own, &others, 1.0), (&others, &own, -1.0)] {
            for pair in points.windows(2) {
                let [(from, low), (to, high)] = [pair[0], pair[1]];
                let middle = 0.5 * (low + high);
                let Some((place, slope)) = reached(line, middle) else { continue };
                common += 1;
                // Noise moves a place by noise over slope.
                let slope = slope.min((high - low) / (to - from));
                weight += slope * slope;
                sum += sign * slope * slope * (place - 0.5 * (from + to));
            }
        }
        if common < LEAST_POINTS || weight <= 0.0 {
            return Err(common);
        }
        let start = sum / weight;
        let count = |shift: f64| self.off(other, shift).0;
        let least = (0.6 * count(start) as f64) as usize;
        let [reach, step] = REACH.map(|decades| decades * std::f64::consts::LN_10);
        let steps = (reach / step) as i32;
        let best = (-steps..=steps)
            .map(|index| start + step * f64::from(index))
            .filter(|&shift| count(shift) >= least.max(LEAST_POINTS))
            .map(|shift| {
                let (count, mean, square) = self.off(other, shift);
                (square / count as f64 - if vertical { mean * mean } else { 0.0 }, shift)
            })
            .min_by(|left, right| left.0.total_cmp(&right.0));
        Ok(best.map_or(start, |(_, shift)| shift))
    }

    /// Number, mean and sum of squares of the differences after a shift.
    fn off(&self, other: &Self, shift: f64) -> (usize, f64, f64) {
        let moved = |curve: &LogCurve| -> LogCurve { curve.iter().map(|&(at, value)| (at + shift, value)).collect() };
        let mut all = Vec::new();
        for (own, others) in [(&self.rising, &other.rising), (&self.loss, &other.loss)] {
            let own = moved(own);
            all.extend(differences(&own, others));
            all.extend(differences(others, &own).into_iter().map(|difference| -difference));
        }
        let mean = all.iter().sum::<f64>() / all.len().max(1) as f64;
        (all.len(), mean, all.iter().map(|difference| difference * difference).sum())
    }
}

/// At most so many points, neighbours averaged.
fn averaged(points: &LogCurve) -> LogCurve {
    let size = points.len().div_ceil(MOST_POINTS).max(1);
    let mean = |chunk: &[(f64, f64)]| {
        let count = chunk.len() as f64;
        (chunk.iter().map(|point| point.0).sum::<f64>() / count, chunk.iter().map(|point| point.1).sum::<f64>() / count)
    };
    points.chunks(size).map(mean).collect()
}

/// The curve that never falls and is nearest: neighbours that fall are pooled (Ayer et al., 1955, *Ann. Math. Stat.* 26, 641).
fn monotone(points: &LogCurve) -> LogCurve {
    // Sum of places, sum of values, count.
    let mut pools: Vec<(f64, f64, f64)> = Vec::with_capacity(points.len());
    for &(at, value) in points {
        let mut pool = (at, value, 1.0);
        while let Some(last) = pools.last().filter(|last| last.1 / last.2 >= pool.1 / pool.2) {
            pool = (pool.0 + last.0, pool.1 + last.1, pool.2 + last.2);
            pools.pop();
        }
        pools.push(pool);
    }
    pools.into_iter().map(|(at, value, count)| (at / count, value / count)).collect()
}

/// Where a rising curve reaches a value, and its slope there.
fn reached(line: &LogCurve, value: f64) -> Option<(f64, f64)> {
    line.windows(2).find(|pair| pair[0].1 <= value && value <= pair[1].1 && pair[1].1 > pair[0].1 && pair[1].0 > pair[0].0).map(|pair| {
        let slope = (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
        (pair[0].0 + (value - pair[0].1) / slope, slope)
    })
}
