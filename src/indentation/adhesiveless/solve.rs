//! A contact without adhesion with errors: a course beside a finer one; the finest beside a coarser one.

use super::chain::Chain;
use super::course::{Course, Fineness, Left, Loss, Unknown};
use super::fresh::Fresh;
use super::line::Line;
use crate::estimate::Estimate;
use crate::indentation::assessment::with_errors;
use crate::indentation::checkpoint::Watch;
use crate::indentation::cycle::Cycle;
use crate::indentation::fields::SurfaceFields;
use crate::indentation::history::{Controlled, Segment};
use crate::indentation::panel::Panel;
use crate::indentation::problem::IndentationProblem;
use crate::indentation::profile::Profile;
use crate::indentation::solution::{EventKind, IndentationSolution, IndentationWork, Instant, PathPoint, Trace};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;

/// Series of the finest course, and how much finer each is than the one before.
const FINEST: f64 = 1e-13;
const COARSER: f64 = 10.0;
/// Tolerances that say so to what assesses them: the bound of a course that a finer one is beside is twice the change, of the finest course six times. Three times
/// missed one of 1,178,026 values of 10,000 scenes, by 2 %.
const BY_FINER: f64 = 300.0;
const BY_COARSER: f64 = 50.0;
/// What rounding leaves of the energy lost, over the work done; what series leave of both is mostly more.
const OF_DIFFERENCE: f64 = 1e-13;
/// What a series over the time leaves, over its last coefficients: where a kink is near, they fall slowly.
pub(super) const OF_LAST: f64 = 4.0;
/// Both amplitudes of a cycle are half a swing, of which the sums leave their part.
const OF_AMPLITUDES: f64 = 4.0;
/// Slope of S over f′ that is distinguished from none.
const SOFTEST: f64 = 1e4;
/// Series over the accuracy, and sums over the time: where they leave too much, a finer course shows it and is taken.
const OF_ACCURACY: f64 = 3e-2;
const LOOSEST: f64 = 3e-5;
/// The same with energies, which weigh stiff elements, and with oscillations, of whose cycles small sums count.
const OF_ENERGIES: f64 = 1.0 / 3.0;
const OF_OSCILLATIONS: f64 = 1e-2;
const FINEST_SUMS: f64 = 1e-12;

/// How finely courses go: the coarsest one (level 0), the one that mostly suffices, and finer ones.
fn fineness(accuracy: f64, level: u32) -> Fineness {
    let coarser = COARSER.powi(1 - level as i32);
    let at_least = |finest: f64| if level == 0 { finest * COARSER } else { finest };
    let left = (OF_ACCURACY * accuracy).min(LOOSEST) * coarser;
    Fineness { series: left.max(at_least(FINEST)), sums: left.max(at_least(FINEST_SUMS)) }
}

/// Solves a history without adhesion to its accuracy.
pub(in crate::indentation) fn solve(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    let (chain, fresh) = (Chain::new(material)?, Fresh::of(&problem.profile));
    let mut work = IndentationWork::default();
    let oscillates = problem.history.segments.iter().any(|segment| segment.oscillation.is_some());
    let part = if oscillates {
        OF_OSCILLATIONS
    } else if problem.energies {
        OF_ENERGIES
    } else {
        1.0
    };
    let fineness = |level: u32| fineness(part * problem.accuracy, level);
    let course = |level: u32, watch: Option<&dyn Watch>, stops: &[(usize, f64)]| -> Found {
        Course::new(&chain, problem, &fresh, fineness(level)).watched(watch, level + 1).through(stops)
    };
    // A course tells finer ones where an oscillation ends. Without one, the first two do not wait for each other; many states share the cores anyway.
    let waits = |segment: &Segment| segment.oscillation.is_some_and(|oscillation| oscillation.until_stationary);
    let alone = rayon::current_thread_index().is_none() && !problem.history.segments.iter().any(waits) && !short(problem, &chain);
    let is_finest = |level: u32| fineness(level).series <= FINEST;
    // The numbers are those of the course that mostly suffices: a finer one shows its errors, those too that a coarser one has as well.
    let first = u32::from(!is_finest(1));
    let mut ahead = if alone { side_by_side(|| course(first, None, &[]), || course(first + 1, watch, &[])) } else { [None, None] };
    let solved = |(fine, unknown): &(Trace, Unknown), (coarse, of_coarse): &(Trace, Unknown), shown: usize, work: IndentationWork| {
        let tolerance = fine.tolerance * if shown == 0 { BY_COARSER } else { BY_FINER };
        let courses = [fine.clone(), Trace { tolerance, ..coarse.clone() }];
        let mut solution = with_errors(problem, &courses, shown)?.solution(work);
        // Without adhesion nothing pulls: below zero a force is rounding, or a polynomial between points.
        solution.largest_tension = None;
        widen(&mut solution, &chain, problem, unknown, if shown == 0 { unknown } else { of_coarse });
        Some(solution)
    };
    let mut last: Option<(Trace, Unknown)> = None;
    for level in first.. {
        let stops = last.as_ref().map_or(Vec::new(), |(trace, _)| trace.shortened.clone());
        let found = ahead.get_mut((level - first) as usize).and_then(Option::take).unwrap_or_else(|| course(level, watch, &stops));
        let fine = match (found, last.take()) {
            (Ok(found), before) => {
                problem.profile.holds(found.0.summary.scales[2], 0.0)?;
                work.add(&found.0.work);
                let Some(coarse) = before else {
                    last = Some(found);
                    if is_finest(level) {
                        break;
                    }
                    continue;
                };
                let kinds = |course: &(Trace, Unknown)| course.0.events.iter().map(|event| event.kind).collect::<Vec<_>>();
                let alike = kinds(&found) == kinds(&coarse);
                if level > 1 {
                    let shown = solved(&found, &coarse, 1, work);
                    if let Some(shown) = shown.filter(|shown| alike && shown.reached && within(shown, problem.accuracy)) {
                        return Ok(shown);
                    }
                }
                if is_finest(level) {
                    return solved(&found, &coarse, 0, work).ok_or_else(none_left);
                }
                found
            }
            // What series leave may be too much for a small contact: the course before is shown, by one that is coarser.
            (Err(Refusal::NotConverged { .. }), Some(shown)) if level > 1 => {
                let coarse = course(level - 2, watch, &stops)?;
                work.add(&coarse.0.work);
                return solved(&shown, &coarse, 0, work).ok_or_else(none_left);
            }
            (Err(Refusal::NotConverged { .. }), _) if !is_finest(level) => continue,
            (Err(refusal), _) => return Err(refusal),
        };
        last = Some(fine);
    }
    Err(none_left())
}

fn none_left() -> Refusal {
    Refusal::NotConverged { what: "history of contact", detail: "no course is left".into() }
}

type Found = Result<(Trace, Unknown), Refusal>;

/// Segments times terms along which a course takes less than the tenth of a millisecond in which another thread starts.
const SHORT: usize = 8;

/// Whether courses are over sooner than another thread has started: a few segments of a given penetration, on a shape with a closed line profile.
fn short(problem: &IndentationProblem, chain: &Chain) -> bool {
    let segments = &problem.history.segments;
    let given = |segment: &Segment| segment.controlled == Controlled::Penetration && segment.oscillation.is_none();
    segments.len() * chain.terms().max(1) <= SHORT && segments.iter().all(given) && !matches!(problem.profile.face(), Profile::Table(_))
}

/// What both find, the first one in another thread, as the shorter one; not at all where no thread is to be had.
fn side_by_side(first: impl FnOnce() -> Found + Send, second: impl FnOnce() -> Found) -> [Option<Found>; 2] {
    let (mut one, mut other) = (None, None);
    std::thread::scope(|scope| {
        let _first = std::thread::Builder::new().spawn_scoped(scope, || one = Some(first()));
        other = Some(second());
    });
    [one, other]
}

/// Overlap over the depth that is what series leave.
const OVERLAP: f64 = 1e-8;

/// Whether the numbers at all instants and of all cycles are as accurate as asked, over the largest of their kind, and nothing overlaps.
fn within(solution: &IndentationSolution, accuracy: f64) -> bool {
    let within = |numbers: &[Estimate]| {
        let largest = numbers.iter().fold(0.0, |most: f64, number| most.max(number.value.abs()));
        numbers.iter().all(|number| number.error.is_infinite() || number.error <= accuracy * largest)
    };
    let instants = [|instant: &Instant| instant.penetration, |instant: &Instant| instant.force, |instant: &Instant| instant.contact_radius];
    type OfCycle = fn(&Cycle<Estimate>) -> [Estimate; 2];
    let cycles: [OfCycle; 4] = [
        |cycle| cycle.penetration,
        |cycle| cycle.force,
        |cycle| cycle.contact_radius,
        |cycle| [cycle.storage_stiffness, cycle.loss_stiffness],
    ];
    let accounts: Vec<[Estimate; 4]> = {
        let (instants, events) =
            (solution.instants.iter().map(|instant| instant.energies), solution.events.iter().map(|event| event.energies));
        instants.chain(events).flatten().collect()
    };
    let energies: Vec<Estimate> = accounts.iter().flat_map(|[stored, _, work, lost]| [*stored, *work, *lost]).collect();
    let powers: Vec<Estimate> = accounts.iter().map(|[_, power, ..]| *power).collect();
    solution.smallest_gap_factor >= -OVERLAP * solution.integration.summary.scales[0]
        && instants.iter().all(|of| within(&solution.instants.iter().map(of).collect::<Vec<_>>()))
        && cycles.iter().all(|of| within(&solution.cycles.iter().flat_map(of).collect::<Vec<_>>()))
        && within(&solution.cycles.iter().map(|cycle| cycle.work).collect::<Vec<_>>())
        && within(&energies)
        && within(&powers)
}

/// One course, as fine as an accuracy asks for.
pub(in crate::indentation) fn course(material: &PlaneMaterial, problem: &IndentationProblem, accuracy: f64) -> Result<Trace, Refusal> {
    let (chain, fresh) = (Chain::new(material)?, Fresh::of(&problem.profile));
    let (mut trace, _) = Course::new(&chain, problem, &fresh, fineness(accuracy, 1)).through(&[])?;
    trace.tolerance = accuracy;
    problem.profile.holds(trace.summary.scales[2], 0.0)?;
    Ok(trace)
}

/// What is not known of the strains (m) is not known of Δ where it is not given, of the load 2aE∞* times it, and of the edge that over the slope of S, which
/// is f′ in a fresh contact and at least f′/β: it is known at the instants.
/// Energies weigh stiff elements, whose strains hardly show in S: there what the course itself leaves counts (`own`), not what a finer one does.
fn widen(solution: &mut IndentationSolution, chain: &Chain, problem: &IndentationProblem, not_known: &Unknown, own: &Unknown) {
    let unknown = not_known.strain;
    let softest = (chain.glassy / chain.relaxed).min(SOFTEST);
    let wider = |estimate: &mut Estimate, by: f64| *estimate = Estimate::new(estimate.value, estimate.error + by);
    let of_depth = |controlled: Controlled, unknown: f64| if controlled == Controlled::Penetration { 0.0 } else { unknown };
    let of_force = |a: f64, unknown: f64| 2.0 * a * chain.glassy * unknown;
    // How much further out the surface may touch: the root of what is not known where a contact is small.
    let further = |a: f64, unknown: f64| {
        let reached = problem.profile.line(a) + softest * unknown;
        Line::untouched(chain, &problem.profile, 0.0).virgin_edge(reached, a).map_or(f64::INFINITY, |edge| edge - a)
    };
    let of_edge = |a: f64, own: Option<f64>, unknown: f64| {
        let slope = own.unwrap_or(0.0).max(problem.profile.line_slope(a) / softest);
        // All of a flat punch is in contact.
        let straight = if slope > 0.0 { unknown / slope } else { 0.0 };
        // Inwards an edge is known no worse than the whole contact.
        if straight <= a { straight } else { straight.min(further(a, unknown).max(a)) }
    };
    // What is imposed at each instant: an edge that is imposed is known.
    let kept = |segment: &Segment| {
        let at_once = segment.duration == 0.0 || segment.oscillation.is_some_and(|oscillation| oscillation.until_stationary);
        (segment.controlled, if at_once { 1 } else { problem.instants_per_segment.max(1) as usize })
    };
    let first = std::iter::once((problem.history.controlled, 1));
    let imposed =
        first.chain(problem.history.segments.iter().map(kept)).flat_map(|(controlled, times)| std::iter::repeat_n(controlled, times));
    let works = solution.instants.iter().filter_map(|instant| instant.energies).map(|[_, _, work, _]| work.value.abs());
    let most_work = works.fold(0.0, f64::max);
    let largest = |place: usize| {
        let energies = solution.instants.iter().filter_map(|instant| instant.energies);
        energies.filter_map(|energies| energies.get(place).copied()).fold(0.0, |most: f64, energy| most.max(energy.value.abs()))
    };
    let (most_stored, most_power) = (largest(0), largest(1));
    let depth = solution.integration.summary.scales[0].max(f64::MIN_POSITIVE);
    let widest = solution.integration.summary.scales[2];
    let fastest = 2.0 * chain.maxwell.iter().map(|(modulus, rho)| modulus / rho).sum::<f64>();
    let widen_energies = |[stored, power, work, lost]: &mut [Estimate; 4], left: &Left| {
        // Both are sums of squares of strains, of which each may be off by as much (Cauchy and Schwarz).
        let of_square = |most: f64, stiffness: f64| 2.0 * left.strain * (most / depth).max((most * widest * stiffness).sqrt());
        let of_stored = of_square(most_stored, chain.glassy);
        wider(stored, of_stored);
        wider(power, of_square(most_power, fastest));
        // Both courses may take the same panels of time, and then agree about what these leave.
        wider(work, OF_LAST * left.work);
        // What is lost is a difference of sums.
        wider(lost, OF_DIFFERENCE * most_work + OF_LAST * left.work + of_stored);
    };
    let at_the_end =
        |unknown: &Unknown| Left { slope: 0.0, strain: unknown.strain, work: unknown.kept.last().map_or(0.0, |left| left.work) };
    let [last, own_last] = [not_known, own].map(at_the_end);
    let duration: f64 = problem.history.segments.iter().map(|segment| segment.duration).sum();
    let losses = not_known.losses.iter().copied().chain(std::iter::repeat(Loss::GIVEN));
    for (event, loss) in solution.events.iter_mut().filter(|event| event.kind == EventKind::Detachment).zip(losses) {
        let late = loss.late(unknown, duration);
        wider(&mut event.time, late);
        wider(&mut event.penetration, unknown + loss.depth_rate.abs() * late);
        // Before a step that lets go there is a contact.
        let a = event.contact_radius.value;
        wider(&mut event.force, of_force(a, unknown));
        wider(&mut event.contact_radius, if a > 0.0 { of_edge(a, None, unknown) } else { 0.0 });
        event.energies.iter_mut().for_each(|energies| widen_energies(energies, &own_last));
    }
    // Nothing is in contact, unless the loss may be still to come: not where a step lets go, before which there is a point at the same time.
    let at_a_step =
        |time: f64| solution.integration.path.iter().any(|point| point.time.total_cmp(&time).is_eq() && point.contact_radius > 0.0);
    let lost: Vec<Estimate> = solution.events.iter().map(|event| event.time).filter(|time| !at_a_step(time.value)).collect();
    let of_none = |time: f64, unknown: f64| {
        let beside = lost.iter().any(|lost| (lost.value - time).abs() <= lost.error);
        if beside { further(0.0, unknown) } else { 0.0 }
    };
    // Points between instants: what two instants impose is imposed between them.
    let controls: Vec<Controlled> = imposed.clone().collect();
    for (index, (errors, point)) in solution.path_errors.iter_mut().zip(&solution.integration.path).enumerate() {
        let after = solution.integration.kept.partition_point(|kept| *kept < index);
        let given = |quantity: Controlled| [after.saturating_sub(1), after].iter().all(|kept| controls.get(*kept) == Some(&quantity));
        let a = point.contact_radius;
        let of_radius = if a > 0.0 { of_edge(a, None, unknown) } else { of_none(point.time, unknown) };
        let wider = [
            if given(Controlled::Penetration) { 0.0 } else { unknown },
            of_force(a.max(of_radius), unknown),
            if given(Controlled::ContactRadius) { 0.0 } else { of_radius },
        ];
        errors.iter_mut().zip(wider).for_each(|(error, by)| *error += by);
    }
    let lefts = not_known.kept.iter().chain(std::iter::repeat(&last)).zip(own.kept.iter().chain(std::iter::repeat(&own_last)));
    for ((instant, controlled), (left, own)) in solution.instants.iter_mut().zip(imposed).zip(lefts) {
        let a = instant.contact_radius.value;
        wider(&mut instant.penetration, of_depth(controlled, left.strain));
        let of_radius = if a > 0.0 { of_edge(a, Some(left.slope), left.strain) } else { of_none(instant.time, left.strain) };
        wider(&mut instant.force, of_force(a.max(of_radius), left.strain));
        wider(&mut instant.contact_radius, if controlled == Controlled::ContactRadius { 0.0 } else { of_radius });
        instant.energies.iter_mut().for_each(|energies| widen_energies(energies, own));
    }
    for cycle in &mut solution.cycles {
        // Fundamental amplitudes are sums over the time as well, of depth and of force.
        let swing = |range: &[Estimate; 2]| (range[1].value - range[0].value).abs();
        // What is not known of the force does work there and back.
        let unknown_force = of_force(cycle.contact_radius[1].value.abs(), unknown);
        // Cycles that repeat the last one leave as much.
        let of_cycles = &own.of_cycles;
        let of_cycle = of_cycles.partition_point(|(which, _)| *which <= (cycle.segment, cycle.number)).checked_sub(1);
        let left = of_cycle.and_then(|place| of_cycles.get(place)).map_or([0.0; 3], |(_, left)| *left);
        wider(&mut cycle.work, OF_LAST * left[2] + 2.0 * swing(&cycle.penetration) * unknown_force);
        let part = |left: f64, swing: f64| if left > 0.0 { OF_AMPLITUDES * left / swing.max(f64::MIN_POSITIVE) } else { 0.0 };
        let of_amplitudes = part(left[0], swing(&cycle.penetration)) + part(left[1], swing(&cycle.force));
        let stiffness = cycle.storage_stiffness.value.hypot(cycle.loss_stiffness.value);
        wider(&mut cycle.storage_stiffness, of_amplitudes * stiffness);
        wider(&mut cycle.loss_stiffness, of_amplitudes * stiffness);
        wider(&mut cycle.phase, of_amplitudes);
        let controlled = problem.history.segments.get(cycle.segment).map_or(Controlled::Force, |segment| segment.controlled);
        for k in 0..2 {
            let a = cycle.contact_radius[k].value;
            wider(&mut cycle.penetration[k], of_depth(controlled, unknown));
            // The least force may be at another time than the least radius.
            wider(&mut cycle.force[k], unknown_force);
            wider(&mut cycle.contact_radius[k], if a > 0.0 { of_edge(a, None, unknown) } else { 0.0 });
        }
    }
}

/// Fineness of the course behind a surface: the error of a surface counts its panels only.
const OF_SURFACE: Fineness = Fineness { series: 1e-12, sums: FINEST_SUMS };
/// Grades of the panels of a surface towards the ends of each interval of the line, more finely and less, and what a panel that needs no more may leave, over
/// the largest value there.
const GRADES: [(i32, f64); 2] = [(10, 1e-13), (7, 1e-11)];

/// The contact at a time of a history that has been solved, and its surface twice: as it is, and with coarser panels, for the error.
pub(in crate::indentation) fn surface_at(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    solved: &Trace,
    time: f64,
) -> Result<(PathPoint, [SurfaceFields; 2]), Refusal> {
    let (chain, fresh) = (Chain::new(material)?, Fresh::of(&problem.profile));
    let line = Course::new(&chain, problem, &fresh, OF_SURFACE).line_at(time, &solved.shortened)?;
    let (depth, profile) = (line.penetration, &problem.profile);
    let surface = |(grades, leaves): (i32, f64)| {
        let graded = |low: f64, high: f64, sample: &dyn Fn(f64) -> f64| graded((low, high), grades, leaves, sample);
        let (mut load, mut displacement) = (Vec::new(), Vec::new());
        let soft = chain.relaxed / chain.glassy;
        for interval in &line.contact {
            let springs = interval.weighted(0.0, chain.maxwell.iter().map(|(modulus, _)| modulus / chain.glassy));
            let pressing = |s: f64| soft * (depth - profile.line(s)) + interval.value(s, &springs);
            load.extend(graded(interval.low, interval.high, &|s| chain.glassy * pressing(s)));
            displacement.extend(graded(interval.low, interval.high, &|s| depth - profile.line(s)));
        }
        for interval in &line.free {
            let strains = interval.weighted(0.0, std::iter::repeat_n(1.0, chain.terms()));
            displacement.extend(graded(interval.low, interval.high, &|s| interval.value(s, &strains)));
        }
        SurfaceFields::made_of(line.radius(), load, displacement)
    };
    let point = PathPoint {
        time,
        penetration: depth,
        force: line.force(),
        contact_radius: line.radius(),
        stress_intensity_factor: 0.0,
        unresolved_intensity: 0.0,
        residual: 0.0,
        piece: 0,
        energies: None,
    };
    Ok((point, GRADES.map(surface)))
}

/// Panels of an interval, each a quarter of the one before towards both ends, until one is enough.
fn graded((low, high): (f64, f64), grades: i32, leaves: f64, sample: &dyn Fn(f64) -> f64) -> Vec<Panel> {
    let half = 0.5 * (high - low);
    let mut largest = 0.0_f64;
    let mut enough = |from: f64, to: f64| {
        let panel = Panel::sampled(from, to, sample);
        largest = panel.values.iter().fold(largest, |most, value| most.max(value.abs()));
        let leaves = leaves * largest;
        ([from, 0.5 * (from + to), to].into_iter().all(|s| (panel.at(s) - sample(s)).abs() <= leaves), panel)
    };
    let (suffices, whole) = enough(low, high);
    if suffices {
        return vec![whole];
    }
    // From the middle outwards.
    let mut towards = |end: f64, sign: f64| {
        let mut panels = Vec::new();
        let ordered = |one: f64, other: f64| if one < other { (one, other) } else { (other, one) };
        for k in 0..grades {
            let (outer, inner) = (half * 0.25_f64.powi(k), if k + 1 < grades { half * 0.25_f64.powi(k + 1) } else { 0.0 });
            let (from, to) = ordered(end, end + sign * outer);
            let (suffices, rest) = enough(from, to);
            if suffices || inner == 0.0 {
                panels.push(rest);
                break;
            }
            let (from, to) = ordered(end + sign * inner, end + sign * outer);
            if to > from {
                panels.push(enough(from, to).1);
            }
        }
        panels
    };
    let mut panels = towards(low, 1.0);
    panels.reverse();
    panels.extend(towards(high, -1.0));
    panels
}
