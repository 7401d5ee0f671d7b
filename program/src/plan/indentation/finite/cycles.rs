//! Cycles of oscillations of an indenter that attracts at a distance: what two runs know of each.

use super::super::cycles::Cycles;
use super::super::locate::State;
use super::super::rows::Values;
use super::FiniteRangePlan;
use super::bounds::Runs;
use super::columns::at;
use super::widened::EXTREMES;
use std::f64::consts::{FRAC_PI_4, PI};
use viscotack::estimate::Estimate;
use viscotack::finite_range::sphere::{Margins, cycles};
use viscotack::indentation::{Cycle, Spread};
use viscotack::refusal::Refusal;

/// The cycles that both runs of a state go through, coherent, and by how much those of the tighter run differ.
pub(super) struct Known {
    cycles: Vec<Cycle<Estimate>>,
    spreads: Vec<Spread>,
}

impl FiniteRangePlan {
    /// The cycles of two runs. The changes between them are the bounds.
    pub(super) fn cycles_of(&self, runs: &Runs) -> Result<Known, Refusal> {
        let problem = self.problem()?;
        let [(loose, _), (tight, spreads)] = [&runs.loose, &runs.tight].map(|run| cycles(&problem, run));
        let number = |cycle: &Cycle<f64>| (cycle.segment, cycle.number);
        let pairs = tight.iter().filter_map(|tight| {
            let at = loose.binary_search_by(|loose| number(loose).cmp(&number(tight))).ok()?;
            // What only one run has is not known.
            loose.get(at).filter(|loose| loose.storage_stiffness.is_finite() && loose.loss_stiffness.is_finite()).zip(Some(tight))
        });
        let mut cycles: Vec<Cycle<Estimate>> = pairs.map(|(loose, tight)| self.of_cycle(loose, tight)).collect();
        for segment in cycles.chunk_by_mut(|one, other| one.segment == other.segment) {
            widen(segment);
        }
        Ok(Known { cycles, spreads })
    }

    /// As rows have them.
    pub(super) fn as_rows<'k>(&self, known: &'k Known) -> Cycles<'k> {
        let segments = self.course.pieces.iter().map(|piece| piece.segment);
        Cycles::new((&known.cycles, &known.spreads), segments, self.material.longest_relaxation_time(), at::SEGMENT)
    }

    /// Whether the cycles of two runs are known as well as is wanted: extremes over the largest values of the history, as its instants are.
    pub(super) fn cycles_agree(&self, runs: &Runs) -> bool {
        let Ok(known) = self.cycles_of(runs) else { return true };
        let cycles = self.as_rows(&known);
        let states: Vec<State<f64>> = runs.tight.rows.iter().map(|row| self.state(row)).collect();
        let largest = |of: fn(&State<f64>) -> f64| states.iter().map(of).fold(0.0_f64, |most, value| most.max(value.abs()));
        let of_instants = [largest(|s| s.penetration), largest(|s| s.force), largest(|s| s.contact_radius)];
        let mut scales = vec![0.0_f64; at::ALL];
        let extremes = EXTREMES.iter().map(|(place, of)| (*place, of_instants.get(of - at::PENETRATION).copied().unwrap_or(0.0)));
        let held: Vec<(usize, f64)> = cycles.scales().into_iter().chain(extremes).collect();
        for (place, least) in &held {
            if let Some(scale) = scales.get_mut(*place) {
                *scale = scale.max(*least);
            }
        }
        let mut values: Values = vec![None; at::ALL];
        known.cycles.iter().all(|cycle| {
            cycles.put(&mut values, cycle, &scales);
            held.iter().all(|(place, _)| {
                let scale = scales.get(*place).copied().unwrap_or(0.0);
                let estimate = values.get(*place).copied().flatten();
                estimate.is_none_or(|estimate| estimate.error <= self.solver_accuracy * scale.max(estimate.value.abs()))
            })
        })
    }

    /// A cycle of the tighter run with the changes to it as its bounds.
    fn of_cycle(&self, loose: &Cycle<f64>, tight: &Cycle<f64>) -> Cycle<Estimate> {
        let units = self.reduced.scales;
        // The stiffness is one complex number.
        let (storage, loss) = (tight.storage_stiffness, tight.loss_stiffness);
        let off = (loose.storage_stiffness - storage).hypot(loose.loss_stiffness - loss);
        let stiffness = storage.hypot(loss);
        let unit = units.force / units.gap;
        // Slopes and areas of a small swing show what both meshes have in common: two runs agree by chance more often than about a force.
        let by_chance = Margins::of_law(&self.reduced.law).by_chance * self.solver_accuracy;
        let of_stiffness = |value: f64| self.reduced.of(value, self.change(stiffness + off, stiffness) + by_chance * stiffness, unit);
        let width = |pair: [f64; 2]| pair[1] - pair[0];
        let turned = tight.work.abs().max(FRAC_PI_4 * width(tight.penetration) * width(tight.force));
        // Work and stiffness are of one motion: the work is not known better than the loss.
        let of_work = (loose.work - tight.work).abs().max(if stiffness > 0.0 { turned * off / stiffness } else { 0.0 });
        let work = self.reduced.of(tight.work, self.change(turned + of_work, turned) + by_chance * turned, units.work);
        let pair = |loose: [f64; 2], tight: [f64; 2], of: &dyn Fn(f64, f64) -> Estimate| [of(loose[0], tight[0]), of(loose[1], tight[1])];
        Cycle {
            segment: tight.segment,
            number: tight.number,
            start: tight.start,
            end: tight.end,
            work,
            storage_stiffness: of_stiffness(storage),
            loss_stiffness: of_stiffness(loss),
            phase: Estimate::exact(tight.phase),
            penetration: pair(loose.penetration, tight.penetration, &|loose, tight| self.depth(loose, tight)),
            force: pair(loose.force, tight.force, &|loose, tight| self.between(loose, tight, units.force)),
            contact_radius: pair(loose.contact_radius, tight.contact_radius, &|loose, tight| self.between(loose, tight, units.radius)),
            drift: tight.drift,
            drift_error: if tight.drift.is_finite() { self.change(loose.drift, tight.drift) } else { 0.0 },
        }
    }
}

/// The estimates of a cycle, but for its phase.
fn estimates(cycle: &mut Cycle<Estimate>) -> [&mut Estimate; 9] {
    let Cycle { work, storage_stiffness, loss_stiffness, penetration: [a, b], force: [c, d], contact_radius: [e, f], .. } = cycle;
    [work, storage_stiffness, loss_stiffness, a, b, c, d, e, f]
}

/// No cycle is known better than the worst of its segment: what a transient is wrong by outlasts the change that shows it. The phase has its own bound.
fn widen(cycles: &mut [Cycle<Estimate>]) {
    let errors = cycles.iter_mut().map(|cycle| estimates(cycle).map(|estimate| estimate.error));
    let largest = errors.fold([0.0; 9], |most: [f64; 9], own| std::array::from_fn(|place| most[place].max(own[place])));
    for cycle in cycles {
        estimates(cycle).into_iter().zip(largest).for_each(|(estimate, error)| estimate.error = error);
        let stiffness = cycle.storage_stiffness.value.hypot(cycle.loss_stiffness.value);
        let off = cycle.storage_stiffness.error;
        cycle.phase.error = if off < stiffness { (off / stiffness).asin() } else { PI };
    }
}
