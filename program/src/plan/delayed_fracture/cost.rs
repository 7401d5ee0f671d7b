//! What a history is expected to cost: the zones that the tip crosses at the steady speed of each load, times the lines of a zone.

use super::DelayedFracturePlan;
use crate::outcome::Work;
use std::collections::HashMap;
use viscotack::crack::delayed::trajectory::tends_to;
use viscotack::crack::delayed::{GrowthProblem, Onset, onset};

/// Steps of four runs with ½, 1, 2 and 4 times the lines.
const RUNS: f64 = 7.5;
/// Balances of a step, and integrals of a term in a balance: measured over the shipped scenes, 6 to 9 and 2 to 2.5.
const BALANCES: f64 = 7.5;
const INTEGRALS: f64 = 2.3;
/// Balances of a step in a ramp over those under a constant load.
const RAMP: f64 = 1.2;
/// Zones after which growth under a constant load is uniform to rounding: measured, 7 to 14.
const ZONES_UNTIL_UNIFORM: f64 = 10.0;
/// Balances of a start that is looked for, and of the steady speed.
const BALANCES_OF_A_REST: f64 = 60.0;
const BALANCES_OF_THE_SUMMARY: f64 = 9.0;
/// Evaluations of the creep series for a delay: measured, 6 to 25.
const EVALUATIONS_OF_A_DELAY: f64 = 9.0;
/// Points in a ramp at which the speed is looked at.
const LOOKS: u32 = 8;

impl DelayedFracturePlan {
    /// What finding the delay took.
    pub(super) fn onset_work(&self, evaluations: u64) -> Work {
        Work {
            closure_evaluations: evaluations,
            kernel_evaluations: evaluations * self.plane_material.creep_terms().len() as u64,
            ..Work::default()
        }
    }

    /// What one state is expected to take.
    pub(super) fn work_of_a_state(&self) -> Work {
        let Ok(problem) = self.problem() else { return Work::default() };
        let terms = self.plane_material.creep_kernel_count() as f64;
        let delayed = |load: f64| matches!(onset(&problem, load), Ok(Onset::After { .. }));
        let mut balances = if delayed(self.history.last()) { BALANCES_OF_THE_SUMMARY } else { 0.0 };
        if self.is_one_step() && delayed(self.history.last()) {
            balances += EVALUATIONS_OF_A_DELAY;
        }
        let mut integrals = balances;
        if self.crack.output.points > 0 || !self.is_one_step() {
            let (steps, rests) = self.expected_steps(&problem);
            let stepped = BALANCES * steps + BALANCES_OF_A_REST * rests;
            balances += stepped;
            integrals += INTEGRALS * stepped;
        }
        Work { closure_evaluations: balances as u64, kernel_evaluations: (terms * integrals) as u64, ..Work::default() }
    }

    /// Steps of growth, and segments at rest, of all four runs.
    fn expected_steps(&self, problem: &GrowthProblem<'_>) -> (f64, f64) {
        let lines = f64::from(self.resolution().lines_per_zone);
        // Cycles look at the same loads again and again.
        let mut known: HashMap<u64, (f64, f64)> = HashMap::new();
        let mut look = |load: f64| {
            *known.entry(load.to_bits()).or_insert_with(|| {
                let speed = tends_to(problem, load, 1e-3).map_or(0.0, |state| state.speed.value / problem.process_zone_at(load));
                match onset(problem, load) {
                    Ok(Onset::After { delay, .. }) => (speed, delay.value),
                    _ => (0.0, f64::INFINITY),
                }
            })
        };
        let (mut steps, mut rests, mut waited, mut started) = (0.0, 0.0, 0.0, false);
        for segment in self.history.segments() {
            let duration = segment.duration.min(self.duration - segment.start);
            if duration <= 0.0 {
                continue;
            }
            let constant = segment.from.to_bits() == segment.to.to_bits();
            let looks = if constant { 1 } else { LOOKS };
            let part = duration / f64::from(looks);
            let mut zones = 0.0;
            for index in 0..looks {
                let middle = (f64::from(index) + 0.5) / f64::from(looks);
                let (speed, delay) = look(segment.from + (segment.to - segment.from) * middle);
                // The waiting is used up by every part at its own rate; a tip that has run waits only for the load.
                let before: f64 = if started { 1.0 } else { waited };
                waited += part / delay;
                let moving = if waited <= 1.0 { 0.0 } else { (part - (1.0 - before).max(0.0) * delay).max(0.0) };
                started |= moving > 0.0;
                zones += speed * moving;
            }
            let zones = if constant { zones.min(ZONES_UNTIL_UNIFORM) } else { zones.min(16.0 * lines) };
            if zones > 0.0 {
                // In a ramp a step is bounded in time as well, to half as many as there are lines; and the ends of growth are looked for.
                steps += RUNS * lines * if constant { zones } else { RAMP * (zones + 0.5) };
            }
            rests += 3.0;
        }
        (steps, rests)
    }
}
