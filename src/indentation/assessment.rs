//! Numbers of an integration with errors, shown by those behind it.

use super::between;
use super::convergence::{COMPARED, Compared, Ladder};
use super::cycle::Cycle;
use super::problem::IndentationProblem;
use super::solution::{Energies, Event, IndentationSolution, IndentationWork, Instant, NUMBERS, PathPoint, Trace};
use crate::estimate::Estimate;
use std::f64::consts::PI;

/// Error of the radius of an event, over the accuracy of radii, that is allowed: at a fold it goes with the root of what is not known of the load.
const AT_FOLDS: f64 = 12.0;
/// The place of K among the quantities: what panels leave unknown of it all integrations have alike.
const INTENSITY: usize = 3;
const DISSIPATED: usize = 7;
/// The place of ∫P_d dt among the numbers of an event.
const LOST: usize = NUMBERS - 1;
/// What the tolerance of the edge condition leaves.
const ROUNDING: f64 = 1e-10;
/// Last digits of the largest value of a quantity: what a sum of parts, some of them larger, leaves where it vanishes.
const LAST_DIGITS: f64 = 256.0 * f64::EPSILON;
/// Part of the largest force below which a tension is rounding of none.
const NO_FORCE: f64 = 1e-12;

/// One of some paths, with the errors of its numbers.
#[derive(Debug)]
pub(super) struct WithErrors {
    solution: IndentationSolution,
    /// The largest error over what was allowed: at most one where the accuracy is reached.
    pub(super) excess: f64,
}

impl WithErrors {
    /// The solution, with the work of all paths.
    pub(super) fn solution(self, work: IndentationWork) -> IndentationSolution {
        IndentationSolution { reached: self.excess <= 1.0, work, ..self.solution }
    }
}

/// The largest error so far, over what was allowed.
struct Excess(f64);

impl Excess {
    fn hear(&mut self, error: f64, allowed: f64) {
        // A NaN is more than any; nothing is allowed where only an exact value will do.
        let excess = if error <= allowed { error / allowed.max(f64::MIN_POSITIVE) } else { f64::max(error / allowed, 2.0) };
        self.0 = self.0.max(excess);
    }
}

/// One of some paths, the finest first, with errors by those behind it; nothing without a path there.
pub(super) fn with_errors(problem: &IndentationProblem, integrations: &[Trace], shown: usize) -> Option<WithErrors> {
    compared(problem, integrations, shown, None)
}

/// The same; `reduction`: of paths by panels, as observed from one to the next.
pub(super) fn compared(problem: &IndentationProblem, integrations: &[Trace], shown: usize, reduction: Option<f64>) -> Option<WithErrors> {
    let compared: Compared<&Trace> = std::array::from_fn(|k| integrations.get(k));
    let ladder =
        Ladder { tolerances: compared.map(|integration| integration.map(|integration| integration.tolerance)), reported: shown, reduction };
    let integration = integrations.get(shown)?;
    let mut instants = Vec::with_capacity(integration.kept.len());
    let mut scales = integration.summary.scales;
    let [_, force, a, _] = scales;
    if problem.adhesion.is_none() {
        // Without adhesion K is rounding; it is seen against the one that the force would have at the rim of a punch.
        scales[3] = if a > 0.0 { force / (2.0 * a * (PI * a).sqrt()) } else { 0.0 };
    }
    let mut excess = Excess(0.0);
    // What does not balance up to a point is not known of what is dissipated.
    let (mut unbalanced, mut summed) = (0.0, 0);
    for (index, &place) in integration.kept.iter().enumerate() {
        let Some(point) = integration.path.get(place) else { continue };
        if reduction.is_some() {
            let since = integration.path.iter().take(place + 1).skip(summed);
            unbalanced += since.filter_map(|point| point.energies).map(|energies| energies.balance_defect.abs()).sum::<f64>();
            summed = place + 1;
        }
        let at = |index: usize| compared.map(|trace| trace.and_then(|trace| trace.path.get(*trace.kept.get(index)?)));
        let neighbours = [index.checked_sub(1), index.checked_add(1)].map(|index| index.map_or([None; COMPARED], at));
        let compared = at(index);
        // An indenter that flies is where its contact let go.
        let flies = |(event, _): &(&Event<f64>, &[f64; NUMBERS])| event.penetration.to_bits() == point.penetration.to_bits();
        let let_go = integration.events.iter().zip(&integration.unknown_of_events).find(flies).filter(|_| point.contact_radius == 0.0);
        let of_its_place = let_go.map_or(0.0, |(_, unknown)| unknown[1]);
        let mut estimate = |quantity: usize, of: &dyn Fn(&PathPoint) -> f64| {
            let value = of(point);
            let scale = scales.get(quantity);
            let digits = LAST_DIGITS * scale.copied().unwrap_or(0.0);
            let unresolved = if quantity == INTENSITY { point.intensity_floor() } else { 0.0 };
            let unresolved = if quantity == DISSIPATED { unbalanced } else { unresolved };
            let unresolved = if quantity == 0 { of_its_place } else { unresolved };
            let numbers = |compared: Compared<&PathPoint>| compared.map(|point| point.map(of));
            let unresolved = unresolved + ladder.of_neighbours(numbers(compared), neighbours.map(numbers));
            let error = ladder.error(compared.map(|point| point.map(of))) + unresolved + ROUNDING * value.abs() + digits;
            if let Some(scale) = scale {
                excess.hear(error, problem.accuracy * scale);
            }
            Estimate::new(value, error)
        };
        let energy = |which: usize| {
            move |point: &PathPoint| {
                point.energies.map_or(0.0, |energies| match which {
                    0 => energies.stored,
                    1 => energies.dissipated_power,
                    2 => energies.external_work,
                    _ => energies.dissipated,
                })
            }
        };
        let (penetration, force) = (estimate(0, &|point| point.penetration), estimate(1, &|point| point.force));
        let contact_radius = estimate(2, &|point| point.contact_radius);
        instants.push(Instant {
            time: point.time,
            penetration,
            force,
            contact_radius,
            stress_intensity_factor: estimate(3, &|point| point.stress_intensity_factor),
            energies: point
                .energies
                .is_some()
                .then(|| [estimate(4, &energy(0)), estimate(5, &energy(1)), estimate(6, &energy(2)), estimate(7, &energy(3))]),
            tip_release_rate: release(&ladder, point, compared, |energies| Some(energies.tip_release_rate)),
            energy_release_rate: release(&ladder, point, compared, |energies| energies.energy_release_rate),
            residual: point.residual,
        });
    }
    let on_the_way = OnTheWay { ladder: &ladder, integration, scales, by_panels: reduction.is_some() };
    let events: Vec<Event<Estimate>> = integration
        .events
        .iter()
        .enumerate()
        .map(|(index, event)| {
            let compared = compared.map(|integration| {
                integration.and_then(|integration| integration.events.get(index)).filter(|other| other.kind == event.kind)
            });
            on_the_way.estimated(event, compared, integration.unknown_of_events.get(index).copied().unwrap_or_default())
        })
        .collect();
    let largest_tension = integration.summary.peak().filter(|peak| -peak.force > NO_FORCE * scales[1]).map(|peak| {
        let peaks = compared.map(|integration| integration.map(|integration| integration.summary.peak()));
        let mut unknown = [0.0; NUMBERS];
        unknown[4] = integration.summary.intensity_floor_of_peak();
        let found = on_the_way.estimated(&peak, peaks.each_ref().map(|peak| peak.as_ref()?.as_ref()), unknown);
        // One that does not pull has the tension zero.
        let error = ladder.error(peaks.map(|peak| peak.map(|peak| peak.map_or(0.0, |peak| peak.force))));
        Event { force: Estimate::new(peak.force, error + ROUNDING * peak.force.abs()), ..found }
    });
    if let Some(tension) = largest_tension {
        excess.hear(tension.force.error, problem.accuracy * scales[1]);
    }
    for event in &events {
        let radius_scale = AT_FOLDS * scales[2];
        let intensity = (event.stress_intensity_factor, AT_FOLDS * scales[3]);
        for (estimate, scale) in [(event.penetration, scales[0]), (event.force, scales[1]), (event.contact_radius, radius_scale), intensity]
        {
            excess.hear(estimate.error, problem.accuracy * scale);
        }
    }
    let cycles = assessed_cycles(problem, &ladder, compared, integration, &mut excess);
    let residual = integration.summary.residual;
    // A state that is out of balance by more than was asked for is none, however well its integrations agree.
    excess.hear(residual, problem.accuracy);
    let solution = IndentationSolution {
        instants,
        events,
        cycles,
        largest_tension,
        balance_defect: integration.balance_defect(),
        smallest_stress_intensity_factor: integration.smallest_stress_intensity_factor,
        smallest_gap_factor: integration.smallest_gap_factor,
        reached: excess.0 <= 1.0,
        residual,
        path_errors: between::errors(&ladder, compared, integration),
        integration: integration.clone(),
        by_panels: false,
        work: IndentationWork::default(),
    };
    Some(WithErrors { solution, excess: excess.0 })
}

/// Events and other states between the kept instants of an integration.
struct OnTheWay<'a> {
    ladder: &'a Ladder,
    integration: &'a Trace,
    scales: [f64; 4],
    by_panels: bool,
}

impl OnTheWay<'_> {
    /// With errors by the same event of other integrations, and by what none of them tells.
    fn estimated(&self, event: &Event<f64>, compared: Compared<&Event<f64>>, unknown: [f64; NUMBERS]) -> Event<Estimate> {
        let passed = self.integration.path.iter().take_while(|point| self.by_panels && point.time <= event.time);
        let unbalanced: f64 = passed.filter_map(|point| point.energies).map(|energies| energies.balance_defect.abs()).sum();
        let estimate = |number: usize, value: f64| {
            let error = self.ladder.error(compared.map(|event| event?.number(number)));
            let digits = LAST_DIGITS * number.checked_sub(1).and_then(|place| self.scales.get(place)).copied().unwrap_or(0.0);
            let lost = if number == LOST { unbalanced } else { 0.0 };
            Estimate::new(value, error + unknown[number] + lost + ROUNDING * value.abs() + digits)
        };
        // G_tip goes with K².
        let intensity = unknown[4] / event.stress_intensity_factor.abs();
        let rate = |of: fn(&Event<f64>) -> Option<f64>, value: f64| {
            let error = self.ladder.error(compared.map(|event| of(event?))) + ROUNDING * value.abs();
            let tip = event.tip_release_rate.unwrap_or(0.0);
            let error = if tip > 0.0 { error + 2.0 * intensity * tip } else { error };
            (error <= value.abs()).then(|| Estimate::new(value, error))
        };
        event.with(estimate, rate)
    }
}

/// A release rate with its error; none where nothing of it is known.
fn release(ladder: &Ladder, point: &PathPoint, compared: Compared<&PathPoint>, of: impl Fn(&Energies) -> Option<f64>) -> Option<Estimate> {
    let value = of(&point.energies?)?;
    let error = ladder.error(compared.map(|point| point.and_then(|point| of(&point.energies?))));
    let error = error + point.tip_release_rate_floor() + ROUNDING * value.abs();
    (error <= value.abs()).then(|| Estimate::new(value, error))
}

/// Cycles with errors, over the scales of all cycles.
fn assessed_cycles(
    problem: &IndentationProblem,
    ladder: &Ladder,
    compared: Compared<&Trace>,
    integration: &Trace,
    excess: &mut Excess,
) -> Vec<Cycle<Estimate>> {
    let largest = |of: fn(&Cycle<f64>) -> f64| integration.cycles.iter().fold(0.0, |most: f64, cycle| most.max(of(cycle).abs()));
    let stiffness = largest(|cycle| cycle.storage_stiffness.hypot(cycle.loss_stiffness));
    let scales = [
        largest(|cycle| cycle.work.abs().max(0.25 * (cycle.force[1] - cycle.force[0]) * (cycle.penetration[1] - cycle.penetration[0]))),
        stiffness,
        stiffness,
        1.0,
        integration.summary.scales[0],
        integration.summary.scales[0],
        integration.summary.scales[1],
        integration.summary.scales[1],
        integration.summary.scales[2],
        integration.summary.scales[2],
    ];
    let mut cycles = Vec::with_capacity(integration.cycles.len());
    for (index, cycle) in integration.cycles.iter().enumerate() {
        let compared = compared.map(|integration| {
            let other = integration.and_then(|integration| integration.cycles.get(index));
            other.filter(|other| (other.segment, other.number) == (cycle.segment, cycle.number))
        });
        cycles.push(cycle.assessed(compared, |place, value, compared| {
            let scale = scales.get(place);
            let error = ladder.error(compared) + ROUNDING * value.abs() + LAST_DIGITS * scale.copied().unwrap_or(0.0);
            // A drift is what is left between cycles: nothing is promised of it.
            if let Some(scale) = scale {
                excess.hear(error, problem.accuracy * scale);
            }
            Estimate::new(value, error)
        }));
    }
    cycles
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::solution::EventKind;
    use super::super::{Adhesion, History, Profile};
    use super::*;

    const ACCURACY: f64 = 1e-4;

    fn problem() -> IndentationProblem {
        let history = History::force(1.0).ramp(-1.0, 2.0);
        let adhesion = Some(Adhesion { work_of_adhesion: 0.2, process_zone: 0.05 });
        IndentationProblem { accuracy: ACCURACY, ..IndentationProblem::new(Profile::Paraboloid { radius: 3.0 }, adhesion, history) }
    }

    fn point(time: f64, contact_radius: f64, residual: f64) -> PathPoint {
        PathPoint {
            time,
            penetration: 0.5,
            force: 1.0 - time,
            contact_radius,
            stress_intensity_factor: 2.0,
            unresolved_intensity: 0.0,
            residual,
            piece: 0,
            energies: None,
        }
    }

    /// An integration that pulls until the contact lets go at a depth that is known to a part of it, and flies from there.
    fn pulled(residual: f64, unknown_depth: f64) -> Trace {
        let path = vec![point(0.0, 1.0, 0.0), point(1.0, 0.8, residual), point(2.0, 0.0, 0.0)];
        let mut trace = Trace { kept: vec![0, 1, 2], tolerance: ACCURACY, ..Trace::default() };
        for (k, point) in path.iter().enumerate() {
            trace.summary.add(point, k.checked_sub(1).and_then(|before| path.get(before)));
        }
        trace.path = path;
        trace.events = vec![Event::at(EventKind::Detachment, &PathPoint { force: -0.5, ..point(1.5, 0.6, 0.0) })];
        trace.unknown_of_events = vec![[0.0, unknown_depth, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]];
        trace
    }

    fn assessed_alike(trace: &Trace) -> IndentationSolution {
        with_errors(&problem(), &vec![trace.clone(); 3], 2).unwrap().solution(IndentationWork::default())
    }

    /// Integrations that agree to the last bit about a state out of balance.
    #[test]
    fn a_state_out_of_balance_is_not_reached() {
        assert!(assessed_alike(&pulled(0.9 * ACCURACY, 0.0)).reached);
        assert!(!assessed_alike(&pulled(1.1 * ACCURACY, 0.0)).reached);
        assert!(!assessed_alike(&pulled(-1.1 * ACCURACY, 0.0)).reached);
    }

    /// What is not known of the depth at which a contact let go is not known of the indenter that flies from there.
    #[test]
    fn an_indenter_that_flies_is_known_as_well_as_where_its_contact_let_go() {
        let unknown = 1e-6;
        let (sure, uncertain) = (assessed_alike(&pulled(0.0, 0.0)), assessed_alike(&pulled(0.0, unknown)));
        let last = |found: &IndentationSolution| found.instants.last().unwrap().penetration.error;
        assert!(last(&sure) < 1e-9 && last(&uncertain) > unknown && last(&uncertain) < 1.01 * unknown);
        let event = |found: &IndentationSolution| found.events.first().unwrap().penetration.error;
        assert!(event(&sure) < 1e-9 && event(&uncertain) > unknown);
        // At the same depth before, in contact, it is held.
        for instant in uncertain.instants.iter().take(2) {
            assert!(instant.penetration.error < 1e-9);
        }
    }
}
