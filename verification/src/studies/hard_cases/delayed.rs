//! Cracks under load histories: loads on their limits, long dwells, a million cycles, solids that flow.

use super::super::Effort;
use super::super::known_states::delayed::held_in_cycles;
use super::case::{Expected, Found, HardCase, Kind, near};
use super::material::spread;
use viscotack::crack::delayed::{
    Event, EventKind, GrowthProblem, LoadHistory, LoadSegment, Onset, Resolution, Trajectory, Wave, onset, trajectory,
};
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;

const PROBLEM: &str = "delayed crack";
/// δ (m).
const ZONE: f64 = 1e-6;
/// β of the one-term solid; E0 = τ = Δγ = 1.
const BETA: f64 = 10.0;
/// J(∞) − J(0) of that solid.
const CREEP: f64 = 1.0 - 1.0 / BETA;

const INTERFACE: Interface =
    Interface { work_of_adhesion: 1.0, process_zone: ProcessZone::Constant { length: ZONE }, body: CrackBody::AgainstRigid };

fn one_term() -> Result<PlaneMaterial, Refusal> {
    PlaneMaterial::standard_solid(1.0, BETA, 1.0)
}

fn begun(found: &Trajectory) -> Found {
    match found.events.first() {
        Some(Event { kind: EventKind::GrowthBegins { .. }, time, .. }) => Found::default().with("start", *time),
        Some(_) => Found::default().is("another event first"),
        None => Found::default().is("no growth"),
    }
}

fn first(onset: &Onset) -> Found {
    match onset {
        Onset::Never => Found::default().is("never grows"),
        Onset::AtOnce => Found::default().is("grows at once"),
        Onset::After { delay, initial_speed, .. } => Found::default().with("delay", *delay).with("first speed", *initial_speed),
    }
}

/// The onset of the one-term solid under K = √2·√(part), of which √2 is the relaxed limit.
fn under(release: f64) -> Result<Found, Refusal> {
    let material = one_term()?;
    Ok(first(&onset(&GrowthProblem::new(&material, INTERFACE, 0.0)?, (2.0 * release).sqrt())?))
}

/// J(t_d) = 1/g with g = K²/(2Δγ): t_d = −ln[(1 − 1/g)/(1 − 1/β)].
fn delay(release: f64) -> f64 {
    -((release - 1.0) / release / CREEP).ln()
}

/// The cases.
#[must_use]
pub fn cases(effort: Effort) -> Vec<HardCase> {
    let mut cases = limits();
    cases.extend(long(effort));
    cases.extend(motion());
    cases
}

fn limits() -> Vec<HardCase> {
    let just_above = 1.0 + 1e-10;
    let just_below = BETA * (1.0 - 1e-10);
    vec![
        HardCase::new(
            PROBLEM,
            "a load 1e-10 above the relaxed limit",
            "the delay goes to infinity as the logarithm of the distance",
            "t_d = −τ ln[(1 − 1/g)/(1 − 1/β)] of one term (5.66)",
            // K is rounded: g to 2 ulp, of a distance of 1e-10.
            vec![Expected::Value { quantity: "delay", value: delay(just_above), tolerance: 1e-5 }],
            move || under(just_above),
        ),
        HardCase::new(
            PROBLEM,
            "a load 1e-10 below the glassy limit",
            "the delay goes to zero with the distance",
            "J(t_d) − J(0) = 1e-10/E∞: t_d = 1e-10 τ/(β − 1)",
            vec![near("delay", 1e-10 / (BETA - 1.0), 1e-5)],
            move || under(just_below),
        ),
        HardCase::new(
            PROBLEM,
            "a load 1e-12 below the relaxed limit",
            "rounding may put it on the other side",
            "K²/(2E0) < Δγ: never",
            vec![Expected::Is("never grows")],
            || under(1.0 - 1e-12),
        ),
        HardCase::new(
            PROBLEM,
            "a load 1e-12 above the glassy limit",
            "rounding may put it on the other side",
            "K²/(2E∞) > Δγ: at once",
            vec![Expected::Is("grows at once")],
            || under(BETA * (1.0 + 1e-12)),
        ),
        HardCase::new(
            PROBLEM,
            "a load of 5e-324 (subnormal)",
            "its square is zero",
            "below the relaxed limit",
            vec![Expected::Is("never grows")],
            || {
                let material = one_term()?;
                Ok(first(&onset(&GrowthProblem::new(&material, INTERFACE, 0.0)?, f64::from_bits(1))?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a load of 1e300",
            "its square is infinite",
            "above the glassy limit",
            vec![Expected::Is("grows at once")],
            || {
                let material = one_term()?;
                Ok(first(&onset(&GrowthProblem::new(&material, INTERFACE, 0.0)?, 1e300)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a load that is no number",
            "a NaN passes every comparison",
            "refused",
            vec![Expected::Refused(Kind::OutOfRange)],
            || {
                let material = one_term()?;
                Ok(first(&onset(&GrowthProblem::new(&material, INTERFACE, 0.0)?, f64::NAN)?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a viscous solid under a load 1e-6 of the glassy limit",
            "no load is small enough not to tear it",
            "a Maxwell solid, J = 1/E∞ + t/η: t_d = η(2Δγ/K² − 1/E∞)",
            vec![near("delay", 5.0 * (1e12 - 1.0) / BETA, 1e-12)],
            || {
                let material = PlaneMaterial::from_creep(BETA, &[], Some(5.0))?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                Ok(first(&onset(&problem, 1e-6 * problem.glassy_limit())?))
            },
        ),
        wide(1e-7),
        wide(1e9),
    ]
}

/// 20 terms over 20 decades, the delay drawn and the load made of it.
fn wide(time: f64) -> HardCase {
    HardCase::new(
        PROBLEM,
        format!("20 terms over 20 decades, a delay of {time:e} s"),
        "half of the terms have crept, half have not begun",
        "K from J(t_d), the sum of all terms as it is defined",
        vec![near("delay", time, 1e-11)],
        move || {
            let material = spread(1e6, 20, 20.0, 1e10)?;
            let crept: f64 = material.creep_terms().iter().map(|term| -term.compliance * (-time / term.retardation_time).exp_m1()).sum();
            Ok(first(&onset(&GrowthProblem::new(&material, INTERFACE, 0.0)?, (2.0 / (crept + 1e-6)).sqrt())?))
        },
    )
}

/// Dwells and cycles without end.
fn long(effort: Effort) -> Vec<HardCase> {
    let cycles: u32 = effort.choose(100_000, 1_000_000);
    let dwell = 1e9;
    // After the dwell under k₁ all of J has come: k₂[k₂J(t) + k₁(J(∞) − J(t))] = 2Δγ.
    let (held, stepped) = (0.5 * 2f64.sqrt(), 1.2 * 2f64.sqrt());
    let wanted = (2.0 / stepped - held) / (stepped - held);
    let after = -((1.0 - wanted) / CREEP).ln();
    // A start in the middle of all cycles: period so short that they span one retardation time.
    let period = 2.0 / f64::from(cycles);
    let middle = f64::from(cycles / 2);
    let into = 0.45 * period;
    vec![
        HardCase::new(
            PROBLEM,
            "a dwell of 1e9 times below the limit, then a step",
            "the start is a ten-billionth of the history away from the step",
            "superposition of both loads in one term, the first one relaxed; a time is known to 1e-14 of itself",
            vec![Expected::Value { quantity: "start", value: dwell + after, tolerance: 2e-5 }],
            move || {
                let material = one_term()?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                let history = LoadHistory::from_segments(&[
                    LoadSegment::Step { load: held },
                    LoadSegment::Hold { duration: dwell },
                    LoadSegment::Step { load: stepped },
                ])?;
                Ok(begun(&trajectory(&problem, &history, &[dwell + 1.01 * after], Resolution::default())?))
            },
        ),
        HardCase::new(
            PROBLEM,
            format!("{cycles} cycles at 0.999 of the relaxed limit"),
            "memory must not grow with the cycles, nor must errors",
            "the load never exceeds the relaxed limit: never",
            vec![Expected::Is("no growth"), Expected::Between { quantity: "pieces of memory", low: 1.0, high: 2.0 }],
            move || {
                let material = one_term()?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                let upper = 0.999 * problem.relaxed_limit();
                let wave = LoadSegment::Cycles { count: cycles, period: 0.1, lower: 0.0, upper, wave: Wave::Triangle };
                let history = LoadHistory::from_segments(&[wave])?;
                let resolution = Resolution { most_steps: 100_000_000, ..Resolution::default() };
                let found = trajectory(&problem, &history, &[0.1 * f64::from(cycles)], resolution)?;
                Ok(begun(&found).with("pieces of memory", viscotack::Estimate::exact(found.work.most_pieces as f64)))
            },
        ),
        HardCase::new(
            PROBLEM,
            format!("growth that begins in the {middle}th of {cycles} cycles"),
            "each cycle adds a millionth of the creep that is needed",
            "a geometric series of the cycles before, in one term",
            vec![near("start", (middle - 1.0) * period + into, 1e-9)],
            move || {
                let material = one_term()?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                let compliance = 1.0 / BETA + held_in_cycles(&material, period, middle, into);
                let wave = LoadSegment::Cycles { count: cycles, period, lower: 0.0, upper: (2.0 / compliance).sqrt(), wave: Wave::Square };
                let history = LoadHistory::from_segments(&[wave])?;
                let resolution = Resolution { most_steps: 100_000_000, ..Resolution::default() };
                Ok(begun(&trajectory(&problem, &history, &[(middle - 0.5) * period], resolution)?))
            },
        ),
    ]
}

/// The tip after its start.
fn motion() -> Vec<HardCase> {
    // The steady speed of a crossing time, by the steady theory: z = δ/(vτ).
    let z: f64 = 0.7;
    let mean = 1.0 / BETA + CREEP * (1.0 + (-z).exp_m1() / z);
    let steady = ZONE / z;
    // Two zones of one term in closed form at c = 1/2: w(1⁺) = 1 + B e², B = 1.
    let release = 1.0 / (1.0 - 0.5 * CREEP);
    let at_one_zone = (1.0 + 2f64.exp()).ln();
    vec![
        HardCase::new(
            PROBLEM,
            "the late speed after thirty zones",
            "a delay equation whose kinks fade out",
            "the steady opening crack under the same load",
            vec![near("speed", steady, 1e-7)],
            move || {
                let material = one_term()?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                let load = (2.0 / mean).sqrt();
                let found = trajectory(&problem, &LoadHistory::constant(load)?, &[30.0 * z], Resolution::default())?;
                Ok(last(&found))
            },
        ),
        HardCase::new(
            PROBLEM,
            "the tip at exactly one zone, where its speed jumps",
            "the place of the start leaves the process zone: a kink",
            "the delay equation of one term, c = 1/2; 64 lines a zone",
            vec![near("place", ZONE, 1e-6)],
            move || {
                let material = one_term()?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                let history = LoadHistory::constant((2.0 * release).sqrt())?;
                Ok(last(&trajectory(&problem, &history, &[at_one_zone], Resolution::default())?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "unloading to nothing in the middle of growth",
            "the speed drops from finite to zero at once",
            "without a load there is no work: arrest at the instant",
            vec![Expected::Value { quantity: "arrest", value: at_one_zone, tolerance: 1e-12 }],
            move || {
                let material = one_term()?;
                let problem = GrowthProblem::new(&material, INTERFACE, 0.0)?;
                let history = LoadHistory::from_segments(&[
                    LoadSegment::Step { load: (2.0 * release).sqrt() },
                    LoadSegment::Hold { duration: at_one_zone },
                    LoadSegment::Step { load: 0.0 },
                ])?;
                let found = trajectory(&problem, &history, &[2.0 * at_one_zone], Resolution::default())?;
                let arrest = found.events.iter().find(|event| matches!(event.kind, EventKind::Arrest { .. }));
                Ok(arrest.map_or_else(|| Found::default().is("no arrest"), |event| Found::default().with("arrest", event.time)))
            },
        ),
        HardCase::new(
            PROBLEM,
            "zones of 1e-150 m",
            "squares of lengths underflow",
            "times do not depend on the length of the zone: the steady speed over it is 1/z",
            vec![near("speed over the zone", 1.0 / z, 1e-7)],
            move || {
                let material = one_term()?;
                let length = 1e-150;
                let interface = Interface { process_zone: ProcessZone::Constant { length }, ..INTERFACE };
                let problem = GrowthProblem::new(&material, interface, 0.0)?;
                let history = LoadHistory::constant((2.0 / mean).sqrt())?;
                let found = trajectory(&problem, &history, &[30.0 * z], Resolution::default())?;
                let speed = found.samples.first().and_then(|sample| sample.speed);
                Ok(speed.map_or_else(Found::default, |speed| Found::default().with("speed over the zone", speed.scaled(1.0 / length))))
            },
        ),
        HardCase::new(
            PROBLEM,
            "a term of strength 1e-14 more",
            "its place in the memory is below rounding of the others",
            "the delay without it, changed by 1e-14",
            vec![near("delay", delay(3.0), 1e-12)],
            || {
                let term = |compliance, retardation_time| CreepTerm { compliance, retardation_time };
                let material = PlaneMaterial::from_creep(BETA, &[term(CREEP, 1.0), term(1e-14, 1e-5)], None)?;
                Ok(first(&onset(&GrowthProblem::new(&material, INTERFACE, 0.0)?, 6f64.sqrt())?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "the steady theory knows the same speed",
            "the expected late speed itself rests on one formula",
            "G/Δγ = 1/⟨J⟩ of one term",
            vec![near("D", 1.0 / mean, 1e-13)],
            move || {
                let material = one_term()?;
                let curve = VirtualWork::new(&material, Motion::Opening, INTERFACE)?;
                let point = curve.point(z)?;
                Ok(Found::default().with("D", viscotack::Estimate::relative(point.drive, point.drive_relative_error)))
            },
        ),
    ]
}

fn last(found: &Trajectory) -> Found {
    let sample = found.samples.last();
    let reported = sample.and_then(|sample| Some((sample.growth?, sample.speed?)));
    reported.map_or_else(|| Found::default().is("no growth"), |(place, speed)| Found::default().with("place", place).with("speed", speed))
}
