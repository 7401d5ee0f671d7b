//! Source: thesis Sec 5.4, Eqs 5.65–5.67; `studies::event_lists`.
//!
//! Goal: what happens to a crack does not depend on how finely it is stepped. A step that ends on a grid line to rounding has reached it, an arrest is a sign of the
//! speed and not a step that gains nothing, and no arrest is undone at once.
//!
//! Parameters: one-term solids under one load, β 1.2–1000, at the lines that scenes of accuracies 1e-2 to 1e-7 took, and at any others; slow arrests under falling loads;
//! zones that follow the load; the input `delayed_100301`; random scenes of the study.
//!
//! Oracle: dw/dq = [w(q) − w(q − 1)]/c, w = e^{t/τ}, c = (1 − 1/k)/(1 − 1/β): a tip under one load starts once, has one kink at q = 1, where w = 1 +
//! (1/c − 1)e^{1/c},
//! and never stops (w grows with q). For the others: equal lists at all resolutions, and numbers within both bounds. `delayed_events.csv` by another route.
//!
//! Tolerance: the bounds that the program states; they must be below 1e-6 of the times.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use viscotack::PlaneMaterial;
use viscotack::crack::delayed::{EventKind, GrowthProblem, LoadHistory, LoadSegment, Resolution, Trajectory, Wave, trajectory};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::material::CreepTerm;
use viscotack_verification::studies::draw::Draw;
use viscotack_verification::studies::event_lists::{SEED, compared, drawn, scenes};

fn word(kind: EventKind) -> &'static str {
    match kind {
        EventKind::GrowthBegins { .. } => "onset",
        EventKind::Arrest { .. } => "arrest",
        EventKind::Restart { .. } => "restart",
        EventKind::Jump { .. } => "jump",
        EventKind::Kink { .. } => "kink",
        EventKind::Unbounded => "unbounded",
    }
}

fn list(found: &Trajectory) -> Vec<&'static str> {
    found.events.iter().map(|event| word(event.kind)).collect()
}

fn lines(lines_per_zone: u32) -> Resolution {
    Resolution { lines_per_zone, most_steps: 40_000_000 }
}

fn interface(length: f64) -> Interface {
    Interface { work_of_adhesion: 1.0, process_zone: ProcessZone::Constant { length }, body: CrackBody::AgainstRigid }
}

/// A one-term crack under one load k = K²/(2ΔγE0): onset and kink, and nothing else.
fn held(beta: f64, ratio: f64, time: f64, until: f64, lines_per_zone: u32) -> Result<(), String> {
    let material = PlaneMaterial::standard_solid(1.0, beta, time).unwrap();
    let problem = GrowthProblem::new(&material, interface(1.0), 0.0).unwrap();
    let history = LoadHistory::constant((2.0 * ratio).sqrt()).unwrap();
    let c = (1.0 - 1.0 / ratio) / (1.0 - 1.0 / beta);
    let kink = time * ((1.0 / c - 1.0) * (1.0 / c).exp()).ln_1p();
    let found = trajectory(&problem, &history, &[(until * time).max(1.01 * kink)], lines(lines_per_zone)).unwrap();
    let case = format!("β {beta} k {ratio} τ {time}, {lines_per_zone} lines");
    if list(&found) != ["onset", "kink"] {
        return Err(format!("{case}: {:?}", list(&found)));
    }
    let time = found.events[1].time;
    let rounding = 1e-12 * kink * (1.0 + 1.0 / c);
    if (time.value - kink).abs() > time.error + rounding {
        return Err(format!("{case}: the kink is at {time:?}, right: {kink:e}"));
    }
    Ok(())
}

/// The lines of accuracies 1e-3 to 1e-7 before steps were halved by need.
const LINES_OF_ACCURACIES: [u32; 5] = [90, 192, 414, 892, 1920];

/// β = 1000, K = √2, hold 10: at 90, 892 and 1920 lines (accuracies 1e-3, 1e-6, 1e-7) a run stopped and started again 2.8e-4 zones before its kink.
#[test]
fn the_hold_of_the_false_arrest_has_one_onset_and_one_kink() {
    let wrong: Vec<String> = LINES_OF_ACCURACIES.par_iter().filter_map(|lines| held(1000.0, 2.0, 1.0, 10.0, *lines).err()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn held_cracks_start_once_and_never_stop() {
    let cases: Vec<u64> = (0..120).collect();
    let wrong: Vec<String> = cases
        .into_par_iter()
        .filter_map(|case| {
            let mut draw = Draw::of(0x365, case);
            let beta = draw.log_between(1.2, 1000.0);
            let ratio = beta.powf(draw.between(0.05, 0.95));
            let (time, until) = (draw.log_between(1e-6, 1e6), draw.log_between(1.0, 1e6));
            held(beta, ratio, time, until, 16 + draw.below(400) as u32).err()
        })
        .collect();
    assert!(wrong.is_empty(), "{} of 120\n{}", wrong.len(), wrong.join("\n"));
}

/// A crack of some terms that runs, slows down under a falling load until it stops, and starts again, at several resolutions.
#[test]
fn slow_arrests_are_not_undone() {
    let wrong: Vec<String> = (0..16_u64)
        .into_par_iter()
        .filter_map(|case| {
            let mut draw = Draw::of(0x366, case);
            let terms = 1 + draw.below(6);
            let beta = draw.log_between(5.0, 500.0);
            let times: Vec<f64> = (0..terms).map(|_| draw.log_between(1e-3, 1.0)).collect();
            let creep: Vec<CreepTerm> =
                times.iter().map(|time| CreepTerm { compliance: (1.0 - 1.0 / beta) / terms as f64, retardation_time: *time }).collect();
            let material = PlaneMaterial::from_creep(beta, &creep, None).unwrap();
            let zone = if draw.chance(0.5) {
                ProcessZone::Growing { cohesive_stress: 1.0, factor: 1.0 }
            } else {
                ProcessZone::Constant { length: 1.0 }
            };
            let problem = GrowthProblem::following(&material, Interface { process_zone: zone, ..interface(1.0) }).unwrap();
            let upper = problem.relaxed_limit() * beta.powf(draw.between(0.1, 0.35));
            let wave = Wave::Triangle;
            let period = draw.log_between(0.3, 3.0);
            let cycles = LoadSegment::Cycles { count: 3, period, lower: draw.between(0.0, 0.6) * upper, upper, wave };
            let history =
                LoadHistory::from_segments(&[LoadSegment::Step { load: upper }, LoadSegment::Hold { duration: 0.5 }, cycles]).unwrap();
            let lists: Vec<Trajectory> = [16, 23, 45, 64]
                .iter()
                .map(|count| trajectory(&problem, &history, &[0.5 + 3.0 * period], lines(*count)).unwrap())
                .collect();
            let all: Vec<String> = lists.iter().map(|found| list(found).join(" ")).collect();
            let finest = lists.last().unwrap();
            if all.iter().any(|one| one != all.last().unwrap()) {
                return Some(format!("{case}: {}", all.join("\n   ")));
            }
            // A rest that is undone at once is none.
            let times: Vec<f64> = finest.events.iter().map(|event| event.time.value).collect();
            let undone = finest.events.windows(2).zip(times.windows(2)).any(|(pair, times)| {
                word(pair[0].kind) == "arrest" && word(pair[1].kind) == "restart" && times[1] - times[0] < 1e-7 * period
            });
            undone.then(|| format!("{case}: {} {times:?}", all[0]))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Lists and numbers of `delayed_100301` at all accuracies: its third kink came and went, so bounds of its kink rows did not cover what a tighter run changed.
#[test]
fn the_kinks_of_100301_are_within_their_bounds_at_any_accuracy() {
    let scene = "units = \"reduced\"\n[material]\npoisson_ratio = 0.49\nglassy_modulus = 9.235390130137661\n\
        creep = [{ fraction = 1.0, retardation_time = 1.0 }]\n[adhesion]\nprocess_zone = { length = 0.4370104457191762 }\n\
        [crack]\npoints = 3\nspacing = \"logarithmic\"\n[[history]]\nstress_intensity = 0.40661801841494966\n\
        [[history]]\nstress_intensity = 2.600073030506302\nrate = 0.020048739398351934\n\
        [[history]]\ncycles = 2\nperiod = 12.547708013883577\nlower = 0.7082012275596731\nupper = 1.1736806081313573\nwave = \"square\"\n\
        [[history]]\nstress_intensity = 0.832487853396297\n";
    let found = compared(scene, &[1e-3, 1e-7, 1e-8, 1e-9]);
    assert!(found.wrong_lists.is_empty(), "{:?}", found.wrong_lists);
    assert!(found.outside.is_empty(), "{:?}", found.outside);
    let words: Vec<&str> = found.events.iter().map(|event| event.split(' ').next().unwrap()).collect();
    assert_eq!(words, ["onset", "kink", "arrest", "restart", "kink", "arrest", "restart", "kink", "arrest", "end"]);
    assert_eq!(found.flagged, 0);
}

/// The library at the fixed lines that scenes took: a third kink of `delayed_100301` came and went with them.
#[test]
fn the_events_of_100301_are_the_same_at_any_lines() {
    let material = PlaneMaterial::standard_solid(1.0, 9.235_390_130_137_661, 1.0).unwrap();
    let problem = GrowthProblem::new(&material, interface(0.437_010_445_719_176_2), 0.0).unwrap();
    let unit = std::f64::consts::SQRT_2;
    let [start, peak] = [0.406_618_018_414_949_66, 2.600_073_030_506_302];
    let cycles = LoadSegment::Cycles {
        count: 2,
        period: 12.547_708_013_883_577,
        lower: 0.708_201_227_559_673_1 * unit,
        upper: 1.173_680_608_131_357_3 * unit,
        wave: Wave::Square,
    };
    let ramp = (peak - start) / 0.020_048_739_398_351_934;
    let segments = [LoadSegment::Step { load: start * unit }, LoadSegment::Ramp { duration: ramp, load: peak * unit }, cycles];
    let history = LoadHistory::from_segments(&segments).unwrap();
    let wrong: Vec<String> = LINES_OF_ACCURACIES
        .par_iter()
        .filter_map(|count| {
            let found = trajectory(&problem, &history, &[ramp + 25.0], lines(*count)).unwrap();
            let right = ["onset", "kink", "arrest", "restart", "kink", "arrest", "restart", "kink", "arrest"];
            let wide = found.events.iter().any(|event| event.time.error > 1e-6 * event.time.value);
            (list(&found) != right || wide).then(|| format!("{count} lines: {:?}", found.events))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every end of a step on a line, however it is rounded: zones of one length and of lengths an ulp or a few away, which shift all roundings.
#[test]
fn roundings_of_the_zone_change_no_event() {
    let wrong: Vec<String> = (0..40_u64)
        .into_par_iter()
        .filter_map(|case| {
            let beta = 1000.0 * (1.0 + 2.3e-16 * case as f64);
            let ratio = 2.0 + 4.5e-16 * (case * case) as f64;
            held(beta, ratio, 1.0 + 1e-15 * case as f64, 4.0, 16 + 7 * case as u32).err()
        })
        .collect();
    assert!(wrong.is_empty(), "{} of 40\n{}", wrong.len(), wrong.join("\n"));
}

/// A long run of cycles and a hold of a million retardation times end, and hold no more pieces than lie in the greatest zone.
#[test]
fn thousands_of_cycles_and_a_very_long_hold_end_within_memory() {
    let material = PlaneMaterial::standard_solid(1.0, 10.0, 1.0).unwrap();
    let problem = GrowthProblem::new(&material, interface(1.0), 0.0).unwrap();
    let unit = std::f64::consts::SQRT_2;
    let most = |count: u32| {
        let cycles = LoadSegment::Cycles { count, period: 0.02, lower: unit, upper: 1.3 * unit, wave: Wave::Triangle };
        let history = LoadHistory::from_segments(&[cycles, LoadSegment::Hold { duration: 1e6 }]).unwrap();
        let found = trajectory(&problem, &history, &[1e6], lines(8)).unwrap();
        let arrests = list(&found).iter().filter(|word| **word == "arrest").count();
        assert!(arrests > count as usize / 2, "{arrests} arrests in {count} cycles");
        found.work.most_pieces
    };
    let (few, many) = (most(300), most(3000));
    assert!(many < 2 * few, "{few} pieces in 300 cycles, {many} in 3000");
}

/// Scenes of the study's own stream that are quick.
#[test]
fn random_histories_have_the_same_events_at_all_accuracies() {
    let wrong: Vec<String> = drawn(0x368, 8, 1_500_000)
        .into_par_iter()
        .filter_map(|(scene, text)| {
            let found = compared(&text, &[1e-3, 1e-7, 1e-8]);
            let bad = !found.wrong_lists.is_empty() || !found.outside.is_empty();
            bad.then(|| format!("{scene}: {:?} {:?} {:?}", found.events, found.wrong_lists, found.outside.first()))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The load at an event is known as well as its time: along a ramp to its slope times the bound; at a jump it is the load after it, also if the clock is an ulp early.
/// A place of slow arrest leaves the zone where a step ends beside it: the speed there goes with the root of what is left, and the last four steps agreed by chance.
#[test]
fn the_speed_before_a_slow_kink_is_known_as_well_as_its_place() {
    let scene = scenes::scene(&mut Draw::of(SEED, 634));
    let found = compared(&scene, &[1e-5, 1e-6, 1e-8, 1e-7]);
    assert!(found.wrong_lists.is_empty() && found.outside.is_empty() && found.numbers > 100, "{found:?}");
}

#[test]
fn loads_at_events_are_known_as_well_as_their_times() {
    use viscotack::Estimate;
    let segments = [LoadSegment::Ramp { duration: 0.3, load: 6.0 }, LoadSegment::Step { load: 1.0 }, LoadSegment::Hold { duration: 2.0 }];
    let history = LoadHistory::from_segments(&segments).unwrap();
    let on_ramp = history.around(Estimate::new(0.1, 1e-6));
    assert!((on_ramp.value - 2.0).abs() < 1e-14 && (on_ramp.error / 2e-5 - 1.0).abs() < 1e-6, "{on_ramp:?}");
    for ulps in [-2.0, -1.0, 0.0, 1.0, 2.0] {
        let on_jump = history.around(Estimate::new(0.3 + ulps * 5.6e-17, 3e-15));
        assert_eq!((on_jump.value.to_bits(), on_jump.error.to_bits()), (1.0_f64.to_bits(), 0), "{ulps}: {on_jump:?}");
    }
    // Where the event may lie on either side, both loads are in the bound.
    let unsure = history.around(Estimate::new(0.3 - 1e-9, 1e-6));
    assert!((unsure.value - 6.0).abs() < 1e-6 && unsure.error > 4.99, "{unsure:?}");
}

/// Scenes of `delayed_scenes/` by another route: all pieces of the history at each instant, no windows, no lines, no speeds (verification/references/delayed_events.py).
#[test]
fn events_are_those_of_another_route() {
    use std::path::Path;
    use viscotack_program::plan::Plan;
    use viscotack_program::scene::{Document, read};
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let table = std::fs::read_to_string(folder.join("reference_data/delayed_events.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect()).collect();
    let mut names: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    names.dedup();
    assert!(names.len() >= 5, "{names:?}");
    for name in names {
        let text = std::fs::read_to_string(folder.join("verification/references/delayed_scenes").join(format!("{name}.toml"))).unwrap();
        let document = Document::parse("scene.toml", text, Path::new(".")).unwrap();
        let plan = Plan::new(&read::read(&document).unwrap()).unwrap();
        let time = plan.columns().iter().position(|column| column.name == "time").unwrap();
        let solved: Vec<(String, f64)> = plan
            .solve(0, &[])
            .iter()
            .filter(|row| row.labels[0] == "event" && row.labels[2] != "end")
            .map(|row| (row.labels[2].clone(), row.values[time].unwrap().value))
            .collect();
        let wanted: Vec<&Vec<&str>> = rows.iter().filter(|row| row[0] == name && row[2] != "none").collect();
        let kinds: Vec<&str> = wanted.iter().map(|row| row[2]).collect();
        assert_eq!(solved.iter().map(|(kind, _)| kind.as_str()).collect::<Vec<_>>(), kinds, "{name}");
        for ((kind, found), row) in solved.iter().zip(&wanted) {
            let [right, uncertain]: [f64; 2] = [row[3].parse().unwrap(), row[4].parse().unwrap()];
            assert!((found - right).abs() <= uncertain, "{name} {kind}: {found} {right} ± {uncertain}");
            assert!(uncertain < 0.05 * right.max(1e-300) || right == 0.0, "{name} {kind}: the other route is too coarse, {uncertain}");
        }
    }
}
