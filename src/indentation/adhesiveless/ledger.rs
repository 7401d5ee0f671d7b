//! What is added up along a drive: the work done, the power lost, and the moments and extremes of a cycle, by series in the time that are halved until they end.

use super::course::Course;
use super::drive::Drive;
use super::edge::Way;
use super::grid::{GRID, NODES, Nodal, dot};
use super::line::{Line, place_of};
use super::path_history::Edge;
use super::walk::Walk;
use crate::refusal::Refusal;

/// Halvings of the time of a drive.
const MOST_HALVINGS: u32 = 60;
/// Rounding of a value, and what a series of the line leaves of F, over what it leaves of S.
const ROUNDING: f64 = 1e-14;
const OF_LINE: f64 = 50.0;
/// Part of the least work of a history which a panel may be off by, however little it does itself.
const LITTLE: f64 = 1e-3;
/// How much coarser the power lost may be, which only tells how well the balance holds.
const OF_BALANCE: f64 = 1e3;
/// Parts of a drive, at most.
const MOST_PARTS: u32 = 600;
/// Steps of the search for an extreme, each 0.618 of the one before.
const NARROWINGS: u32 = 45;

/// Sums over the time since the last point.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    /// ∫F dΔ and ∫P_d dt.
    pub(crate) work: f64,
    pub(crate) lost: f64,
    /// ∫x dφ, ∫x sin φ dφ, ∫x cos φ dφ of Δ and of F.
    pub(crate) moments: [[f64; 3]; 2],
    /// Smallest and largest Δ, F and a; none where nothing was added.
    pub(crate) extremes: Option<[[f64; 2]; 3]>,
}

/// A drive that has been gone along one way, from a line before it.
pub(super) struct Gone<'g, 'a> {
    pub(super) before: &'g Line<'a>,
    pub(super) drive: Drive,
    /// None where the edge rested.
    pub(super) way: Option<Way>,
    pub(super) edge: Option<Edge<'g>>,
    /// The time of the interval at its start.
    pub(super) since: f64,
    /// F where it is imposed.
    pub(super) force: Option<&'g dyn Fn(f64) -> f64>,
}

impl<'a> Course<'a> {
    /// Whether anything is added up.
    pub(super) fn adds_up(&self) -> bool {
        self.until.is_infinite() && (self.problem.energies || self.cycle_integrals.is_some())
    }

    /// The line as it is, where something is added up, or instants on the way are wanted.
    pub(super) fn before(&self, wanted: bool) -> Option<Line<'a>> {
        (wanted || self.adds_up()).then(|| self.line.clone())
    }

    /// Adds up what a drive has done: the sums since the last point at each of some times along it (rising, before its end; none where cycles are
    /// measured). What comes after the last of them is kept in the course.
    pub(super) fn add_up(&mut self, gone: &Gone<'_, 'a>, mut times: &[f64]) -> Result<Vec<Sums>, Refusal> {
        let drive = &gone.drive;
        let mut parts = vec![(0.0, drive.duration, MOST_HALVINGS)];
        let mut walk = Walk::along(gone);
        let start = walk.force(0.0)?;
        let mut sums = std::mem::take(&mut self.sums);
        let (mut found, mut depth) = (Vec::with_capacity(times.len()), drive.start);
        let mut swings = [0.0_f64; 2];
        let noise = OF_LINE * self.fineness.series.max(self.chain.noise.iter().flatten().sum()).max(ROUNDING);
        let whole = self.record.trace.summary.scales;
        let mut left = MOST_PARTS;
        while let Some((low, high, halvings)) = parts.pop() {
            left = left.saturating_sub(1);
            let (mut depths, mut forces, mut powers) = ([0.0; NODES], [0.0; NODES], [0.0; NODES]);
            let mut work = [0.0; NODES];
            let mut phases = [[0.0; 3]; NODES];
            for k in 0..NODES {
                let time = place_of(low, high, k);
                depths[k] = drive.value(time);
                (forces[k], powers[k]) = walk.at(time, self.problem.energies)?;
                work[k] = (forces[k] - start) * drive.rate(time);
                if let Some(cycle_integrals) = &self.cycle_integrals {
                    phases[k] = cycle_integrals.weights(self.origin + gone.since + time);
                }
            }
            let range = |values: &Nodal| values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
            let ranges = [range(&depths), range(&forces)];
            for (swing, [least, most]) in swings.iter_mut().zip(ranges) {
                *swing = swing.max(most - least);
            }
            let width = high - low;
            let largest: [f64; 2] = std::array::from_fn(|k| whole[k].max(ranges[k][0].abs()).max(ranges[k][1].abs()));
            // What the work of the whole drive may be off by, and what of it noise leaves.
            let fastest = (0..NODES).fold(0.0, |most: f64, k| most.max(drive.rate(place_of(low, high, k)).abs()));
            let little = LITTLE * self.fineness.sums * self.least_work;
            let of_work = (self.fineness.sums * swings[0] * swings[1]).max(noise * largest[1] * fastest * width).max(little);
            let of_power = (OF_BALANCE * self.fineness.sums * largest[0] * largest[1])
                .max(little)
                .max(noise * width * powers.iter().fold(0.0, |most: f64, p| most.max(*p)));
            let mut ended = width * GRID.tail(&work) <= of_work && width * GRID.tail(&powers) <= of_power;
            let mut moments = [[0.0; 3]; 2];
            let mut left_of = [0.0_f64; 3];
            if self.cycle_integrals.is_some() {
                for (quantity, values) in [&depths, &forces].into_iter().enumerate() {
                    for (index, moment) in moments[quantity].iter_mut().enumerate() {
                        let part: Nodal = std::array::from_fn(|k| phases[k][index] * values[k]);
                        let allowed = (self.fineness.sums * swings[quantity]).max(noise * largest[quantity]);
                        let tail = width * GRID.tail(&part);
                        left_of[quantity] = left_of[quantity].max(tail);
                        ended &= tail <= allowed;
                        *moment = width * GRID.integral(&part);
                    }
                }
                ended &= GRID.tail(&forces) <= (self.fineness.sums * swings[1]).max(noise * largest[1]);
            }
            if !ended && halvings > 0 && left > 0 {
                let middle = 0.5 * (low + high);
                parts.push((middle, high, halvings - 1));
                parts.push((low, middle, halvings - 1));
                continue;
            }
            left_of[2] = width * GRID.tail(&work);
            self.left_work += left_of[2];
            if self.cycle_integrals.is_some() {
                self.left_of_cycle.iter_mut().zip(left_of).for_each(|(left, own)| *left += own);
            }
            let [mut done, mut lost] = [width * GRID.integral(&work), width * GRID.integral(&powers)];
            if times.first().is_some_and(|time| *time < high) {
                let running = [&work, &powers].map(|values| GRID.running(values));
                let mut taken = [0.0; 2];
                while let Some((&time, later)) = times.split_first().filter(|(time, _)| **time < high) {
                    let weights = GRID.at(time - low, high - time);
                    let until = running.map(|values| width * dot(&weights, &values));
                    let there = drive.value(time);
                    sums.work += until[0] - taken[0] + start * (there - depth);
                    sums.lost += until[1] - taken[1];
                    found.push(std::mem::take(&mut sums));
                    (taken, depth, times) = (until, there, later);
                }
                done -= taken[0];
                lost -= taken[1];
            }
            sums.work += done;
            sums.lost += lost;
            for (sum, part) in sums.moments.iter_mut().flatten().zip(moments.iter().flatten()) {
                *sum += part;
            }
            if self.cycle_integrals.is_some() {
                // The edge goes one way.
                let (one, other) = (gone.before.radius(), self.line.radius());
                let found = [extremes(&depths), extremes(&forces), [one.min(other), one.max(other)]];
                sums.extremes = Some(match sums.extremes {
                    None => found,
                    Some(old) => std::array::from_fn(|k| [old[k][0].min(found[k][0]), old[k][1].max(found[k][1])]),
                });
            }
        }
        // Where Δ is found, what it is off by between the ends of a panel does work as the force changes.
        let of_panel = self.left_of_panel * swings[1];
        self.left_work += of_panel;
        self.left_of_cycle[2] += of_panel;
        sums.work += start * (drive.end() - depth);
        self.sums = sums;
        Ok(found)
    }
}

/// Least and largest value of a series.
fn extremes(values: &Nodal) -> [f64; 2] {
    [-1.0, 1.0].map(|sign| {
        let top = (0..NODES).max_by(|one, other| (sign * values[*one]).total_cmp(&(sign * values[*other]))).unwrap_or(0);
        if top == 0 || top == NODES - 1 {
            return values[top];
        }
        let of = |part: f64| sign * dot(&GRID.at(part, 1.0 - part), values);
        let (mut low, mut high) = (GRID.parts[top - 1], GRID.parts[top + 1]);
        for _ in 0..NARROWINGS {
            let (first, second) = (high - 0.618_033_988_75 * (high - low), low + 0.618_033_988_75 * (high - low));
            if of(first) > of(second) { high = second } else { low = first }
        }
        sign * of(0.5 * (low + high)).max(sign * values[top])
    })
}
