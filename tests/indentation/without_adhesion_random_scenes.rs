//! Random scenes of an indenter without adhesion that were refused, endless or less accurate than asked for: one for each kind of fault.
//!
//! Contract: scenes without `[adhesion]`, in tests/scenes_without_adhesion (drawn by verification/crosscheck/adhesiveless_scenes.py).
//! Goal: every row is solved. The values of these scenes are compared by the cross-check, which knows them from an independent program.
//! Oracle: here, what needs no solver: an imposed radius, one detachment, the balance of energies by two integrals, and Hertz's energy.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack::indentation::{Adhesion, Controlled, EventKind, History, IndentationProblem, Profile, Watch, run, run_watched};
use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};
use viscotack_program::outcome::{Outcome, Status};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

fn outcome(name: &str) -> Outcome {
    let path = Path::new("tests/scenes_without_adhesion").join(name).with_extension("toml");
    let mut document = Document::load(&path).unwrap();
    read::resolve_includes(&mut document).unwrap();
    let scene = read::read(&document).unwrap();
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap_or_else(|refusal| panic!("{name}: {refusal}"))
}

fn solved(name: &str) -> Outcome {
    let found = outcome(name);
    let failed = found.rows.iter().find(|row| row.status != Status::Solved);
    assert!(failed.is_none(), "{name}: {failed:?}");
    found
}

fn events(outcome: &Outcome, kind: &str) -> usize {
    outcome.rows.iter().filter(|row| row.labels.iter().any(|label| label == kind)).count()
}

/// Newton's steps do not end between two series of the line that differ by what series may leave.
#[test]
fn steps_towards_a_force_end_where_the_series_of_the_line_do() {
    solved("step_to_a_force");
    solved("ramp_to_a_force");
}

/// Near its loss a contact is so small that panels are no better for being shorter.
#[test]
fn a_force_that_falls_to_nothing_takes_no_endless_panels() {
    solved("force_to_nothing");
}

/// What presses a steep shape is less than its series leave long before its force has gone: 95 s, then no end. The event is where the force is zero.
#[test]
fn a_force_that_falls_to_nothing_on_a_steep_shape_lets_go_with_it() {
    let found = solved("force_to_nothing_on_a_steep_shape");
    let time = found.columns.iter().position(|column| column.name == "time").unwrap();
    let lost = found.rows.iter().filter(|row| row.labels.iter().any(|label| label == "detachment"));
    let lost: Vec<f64> = lost.map(|row| row.value(time).unwrap()).collect();
    let right = 17.078_172_658_119_897 + 0.000_808_701_678_717_655_7 / 7.010_051_606_872_836e-5;
    assert!(lost.len() == 1 && (lost[0] - right).abs() < 1e-8, "{lost:?}");
}

/// A panel that follows a force through zero asked for more digits of it than it has.
#[test]
fn a_force_that_has_just_passed_zero_is_known_to_rounding() {
    solved("force_through_zero");
}

/// Strains were kept to a part of a depth that had hardly begun, and a work whose square is no number.
#[test]
fn what_is_little_beside_what_comes_takes_no_time() {
    solved("work_below_the_smallest_number");
}

/// The gap opens with a slope of zero: the edge was put a place further in.
#[test]
fn an_edge_is_found_where_the_gap_opens_flat() {
    solved("edge_where_the_gap_is_flat");
    solved("edge_after_a_long_hold");
}

/// What series leave at little accuracy is no overlap.
#[test]
fn little_accuracy_does_not_overlap() {
    solved("little_accuracy_does_not_overlap");
}

/// Two courses that cut the same panels err alike: what a panel leaves of Δ counts as unknown. Values of the independent program by times of equal radius.
#[test]
fn what_a_panel_leaves_is_within_the_bound() {
    let found = solved("radius_imposed_in_turns");
    let column = |name: &str| found.columns.iter().position(|column| column.name == name).unwrap();
    let (time, penetration) = (column("time"), column("penetration"));
    for (at, right) in [(134.676_837, 7.869_287_532_429_1e-4), (135.246_08, 8.099_768_394_037_3e-4), (280.114_95, 5.761_631_727_418_8e-4)] {
        let away = |row: &&viscotack_program::outcome::Row| (row.value(time).unwrap() - at).abs();
        let instants = found.rows.iter().filter(|row| row.labels[0] == "instant");
        let row = instants.min_by(|one, other| away(one).total_cmp(&away(other))).unwrap();
        let reported = row.values[penetration].unwrap();
        assert!((reported.value - right).abs() <= reported.error + 1e-17, "{at}: {reported:?} {right}");
        assert!(reported.error < 1e-5 * right, "{at}: {reported:?}");
    }
}

/// Instants are looked at on the way through a segment. Each is the end of a history that stops there.
#[test]
fn instants_on_the_way_are_the_ends_of_shorter_histories() {
    const INSTANTS: u32 = 35;
    let one = PlaneMaterial::standard_solid(2.0, 30.0, 0.7).unwrap();
    let terms = [(3.0, 0.01), (1.5, 0.4), (5.0, 20.0)].map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time });
    let three = PlaneMaterial::from_relaxation(0.4, &terms).unwrap();
    let elastic = PlaneMaterial::from_relaxation(3.0, &[]).unwrap();
    let table: Vec<(f64, f64)> = (0..=60).map(|k| f64::from(k) / 100.0).map(|r| (r, 0.5 * r * r + r.powi(4))).collect();
    let shapes = [
        Profile::Paraboloid { radius: 1.0 },
        Profile::Cone { slope: 0.1 },
        Profile::FlatPunch { radius: 0.2 },
        Profile::table(&table).unwrap(),
    ];
    // What is given at the end of each segment, over a scale; and how long the segment takes.
    let legs = [(0.02, 2.0), (0.02, 1.5), (0.008, 0.5), (0.012, 3.0), (-0.01, 1.0), (0.0151, 4.0)];
    let controls: [(Controlled, f64); 3] = [(Controlled::Penetration, 1.0), (Controlled::Force, 0.3), (Controlled::Frame, 1.4)];
    let mut compared = 0;
    for (material, profile) in [&one, &three, &elastic].into_iter().flat_map(|material| shapes.iter().map(move |shape| (material, shape))) {
        for (controlled, scale) in controls {
            // The first segments, of the last of them a share.
            let part = |segments: usize, share: f64| {
                let before = |index: usize| if index == 0 { 0.0 } else { legs[index - 1].0 };
                (0..segments).fold(History::from(controlled, 0.0), |history, index| {
                    let (end, duration) = legs[index];
                    let share = if index + 1 == segments { share } else { 1.0 };
                    history.then(controlled, scale * (before(index) + (end - before(index)) * share), duration * share)
                })
            };
            let problem = |history: History, energies: bool, instants_per_segment: u32| {
                let frame_stiffness = (controlled == Controlled::Frame).then_some(0.4);
                let problem = IndentationProblem::new(profile.clone(), None, history);
                IndentationProblem { frame_stiffness, energies, instants_per_segment, accuracy: 1e-6, ..problem }
            };
            for energies in [false, true] {
                let whole = run(material, &problem(part(legs.len(), 1.0), energies, INSTANTS)).unwrap();
                assert!(whole.reached && whole.instants.len() == 1 + legs.len() * INSTANTS as usize);
                for (segment, instant) in [(0, 12), (1, 1), (2, 20), (3, 34), (4, 3), (5, 30)] {
                    let shorter =
                        run(material, &problem(part(segment + 1, f64::from(instant) / f64::from(INSTANTS)), energies, 1)).unwrap();
                    let pair = [whole.instants[segment * INSTANTS as usize + instant as usize], *shorter.instants.last().unwrap()];
                    assert!((pair[0].time - pair[1].time).abs() < 1e-12 * pair[1].time);
                    let mut numbers = vec![pair.map(|at| at.penetration), pair.map(|at| at.force), pair.map(|at| at.contact_radius)];
                    if energies {
                        numbers.extend((0..4).map(|k| pair.map(|at| at.energies.unwrap()[k])));
                    }
                    // A given depth is not known worse than it can be written.
                    let rounding = 4.0 * f64::EPSILON;
                    for (index, [on_the_way, at_the_end]) in numbers.into_iter().enumerate() {
                        let away = (on_the_way.value - at_the_end.value).abs();
                        let allowed = on_the_way.error + at_the_end.error + rounding * at_the_end.value.abs();
                        assert!(away <= allowed, "{controlled:?} {profile:?} {segment} {instant} {index}: {on_the_way:?} {at_the_end:?}");
                        compared += 1;
                    }
                }
            }
        }
    }
    assert!(compared >= 2000);
}

/// Accuracy costs: panels of the time and places of the line, by what is asked for.
#[test]
fn less_accuracy_takes_less_work() {
    let material = PlaneMaterial::from_relaxation(1.0, &[RelaxationTerm { modulus: 9.0, relaxation_time: 1.0 }]).unwrap();
    let history = History::force(0.0).ramp(1e-3, 1.0).hold(10.0).ramp(3e-4, 2.0).ramp(1.2e-3, 3.0);
    let work = |accuracy: f64| {
        let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, None, history.clone());
        let solution = run(&material, &IndentationProblem { instants_per_segment: 4, accuracy, ..problem }).unwrap();
        assert!(solution.reached, "{accuracy:e}");
        [solution.work.closure_evaluations, solution.work.history_updates]
    };
    let [little, usual, most] = [1e-3, 1e-6, 1e-8].map(work);
    assert!(little[0] <= 95 && usual[0] <= 170 && most[0] <= 310, "{little:?} {usual:?} {most:?}");
    assert!(3 * little[1] < 2 * usual[1] && 3 * usual[1] < 2 * most[1], "{little:?} {usual:?} {most:?}");
}

/// A contact that has just been found was found again and again.
#[test]
fn a_surface_that_is_grazed_is_touched_once() {
    solved("grazed_surface");
}

/// A rate at the edge that is rounding turned the edge again and again.
#[test]
fn a_rate_that_is_rounding_turns_no_edge() {
    solved("turn_at_once");
}

/// What rounding leaves pressing after a loss made a second contact, and a second loss.
#[test]
fn a_frame_that_lifts_off_detaches_once() {
    assert_eq!(events(&solved("frame_lifts_off"), "detachment"), 1);
}

/// A liquid that has flowed carries nothing: its edge rests.
#[test]
fn a_liquid_that_has_flowed_keeps_its_edge() {
    let found = solved("melt_in_a_frame");
    let time = found.columns.iter().position(|column| column.name == "time").unwrap();
    // The frame is held for 58 079.887 s before it lifts off.
    let detached = found.rows.iter().filter(|row| row.labels.iter().any(|label| label == "detachment"));
    assert!(detached.map(|row| row.value(time).unwrap()).all(|time| time > 58_079.887));
}

/// A load that had relaxed below what a panel leaves of Δ was a contact that is lost.
#[test]
fn a_punch_on_a_liquid_stays_in_contact_however_long_it_is_held() {
    let found = solved("punch_held_on_a_liquid");
    let time = found.columns.iter().position(|column| column.name == "time").unwrap();
    let detached: Vec<f64> =
        found.rows.iter().filter(|row| row.labels.iter().any(|label| label == "detachment")).map(|row| row.value(time).unwrap()).collect();
    // The frame is held for 104 249 287 s, pushed, and drawn back within 7.7 s: 1e-11 of the depth, which panels leave, is 1e-3 s of that at most.
    assert!(detached.len() == 1 && (detached[0] - 104_256_372.723_858_4).abs() < 5e-3, "{detached:?}");
}

/// A force that presses hardly deeper than what series leave of a deep indentation was let go at the start of its ramp to nothing, for the instants on the way.
#[test]
fn a_force_is_there_at_every_instant_until_it_is_gone() {
    let maxwell = PlaneMaterial::from_relaxation(0.0, &[RelaxationTerm { modulus: 10.0, relaxation_time: 1.0 }]).unwrap();
    let burgers = PlaneMaterial::from_creep(10.0, &[CreepTerm { compliance: 0.2, retardation_time: 3.0 }], Some(10.0)).unwrap();
    let (force, pull, duration) = (1e-3, -1e-4, 0.65);
    let mut pressed = 0;
    for material in [&maxwell, &burgers] {
        for profile in [Profile::Paraboloid { radius: 1.0 }, Profile::Cone { slope: 0.03 }, Profile::FlatPunch { radius: 0.03 }] {
            for held in [1.0, 1e3, 1e5, 1e7] {
                for accuracy in [1e-3, 1e-6] {
                    let history = History::force(0.0).ramp(force, 0.5).hold(held).ramp(pull, duration);
                    let problem = IndentationProblem::new(profile.clone(), None, history);
                    let solution = run(material, &IndentationProblem { instants_per_segment: 7, accuracy, ..problem }).unwrap();
                    for at in solution.instants.iter().filter(|at| at.time >= 0.5 + held) {
                        let right = force + (pull - force) * (at.time - 0.5 - held) / duration;
                        let rounding = 4.0 * f64::EPSILON * (force - pull) * (1.0 + held / duration);
                        let away = (at.force.value - right.max(0.0)).abs();
                        assert!(away <= at.force.error + rounding, "{profile:?} {held} {at:?}: {right}");
                        assert!((at.contact_radius.value > 0.0) == (right > 0.0), "{profile:?} {held} {at:?}");
                        pressed += u32::from(right > 0.0);
                    }
                    let lost: Vec<_> = solution.events.iter().filter(|event| event.kind == EventKind::Detachment).collect();
                    let right = 0.5 + held + duration * force / (force - pull);
                    assert!(
                        lost.len() == 1 && (lost[0].time.value - right).abs() <= lost[0].time.error + 1e-15 * right,
                        "{lost:?} {right}"
                    );
                }
            }
        }
    }
    assert!(pressed >= 300, "{pressed}");
}

/// The same of other shapes and liquids, then of a penetration, a force and a frame that take over what has relaxed to nothing.
#[test]
fn what_has_relaxed_below_rounding_is_still_in_contact() {
    let maxwell = PlaneMaterial::from_relaxation(0.0, &[RelaxationTerm { modulus: 10.0, relaxation_time: 1.0 }]).unwrap();
    let burgers = PlaneMaterial::from_creep(10.0, &[CreepTerm { compliance: 0.2, retardation_time: 3.0 }], Some(10.0)).unwrap();
    let sphere = Profile::Paraboloid { radius: 1.0 };
    let rounded = Profile::Rimmed { face: std::sync::Arc::new(sphere.clone()), rim: 0.01 };
    for material in [&maxwell, &burgers] {
        for profile in [sphere.clone(), Profile::Cone { slope: 0.03 }, Profile::FlatPunch { radius: 0.03 }, rounded.clone()] {
            for held in [50.0, 1e3, 1e5, 1e8] {
                let history = History::frame(0.0).ramp(2e-3, 0.5).ramp(1.8e-3, 0.5).hold(held);
                let stays = history.clone().then(Controlled::Penetration, 1.8e-3, 1e3).then(Controlled::Force, 1e-4, 1.0).hold(10.0);
                let comes_off = history.then(Controlled::Frame, -1e-3, 1.0);
                for (history, losses) in [(stays, 0), (comes_off, 1)] {
                    let problem = IndentationProblem::new(profile.clone(), None, history);
                    let problem = IndentationProblem { frame_stiffness: Some(0.1), instants_per_segment: 4, accuracy: 1e-3, ..problem };
                    let solution = run(material, &problem).unwrap();
                    let lost: Vec<f64> =
                        solution.events.iter().filter(|event| event.kind == EventKind::Detachment).map(|event| event.time.value).collect();
                    assert!(lost.len() == losses && lost.iter().all(|time| *time >= 1.0 + held), "{profile:?} {held} {lost:?}");
                    let in_contact = |time: f64| time > 0.0 && time <= 1.0 + held;
                    let radii = solution.instants.iter().filter(|at| losses == 0 && at.time > 0.0 || in_contact(at.time));
                    assert!(radii.map(|at| at.contact_radius.value).all(|a| a > 0.0), "{profile:?} {held}");
                }
            }
        }
    }
}

/// What has relaxed to nothing in a hold was said to have lost contact. The radius by a bed of springs, to its three digits.
#[test]
fn a_melt_that_has_relaxed_keeps_its_contact() {
    let found = solved("melt_that_has_relaxed");
    let column = |name: &str| found.columns.iter().position(|column| column.name == name).unwrap();
    let (time, radius) = (column("time"), column("contact_radius"));
    let held: Vec<f64> = found
        .rows
        .iter()
        .filter(|row| row.value(time) > Some(0.42) && row.value(time) < Some(49.0))
        .map(|row| row.value(radius).unwrap())
        .collect();
    assert!(held.len() > 4 && held.iter().all(|a| (a / 4.327e-5 - 1.0).abs() < 3e-3), "{held:?}");
}

/// A contact on a surface that lies close all along: Newton's steps from above led below it, and up again. A few of its radii are known to 3e-8, not 1e-8.
#[test]
fn a_surface_that_lies_close_is_met_in_a_few_panels() {
    let found = outcome("surface_that_lies_close");
    assert!(found.work().closure_evaluations < 3000, "{:?}", found.work());
    assert_eq!(found.rows.iter().filter(|row| row.labels.iter().any(|label| label == "detachment")).count(), 2);
}

/// The radius at the border of a segment of the line was beyond it by rounding, and its penetration none.
#[test]
fn an_imposed_radius_may_jump_to_where_the_line_is_cut() {
    solved("square_wave_of_the_radius");
}

/// The surface recovers faster than the indenter goes away, and slower again before the next instant that is asked for.
#[test]
fn a_surface_that_recovers_catches_up_with_the_indenter() {
    let found = solved("surface_that_catches_up");
    let time = found.columns.iter().position(|column| column.name == "time").unwrap();
    let lost = found.rows.iter().filter(|row| row.labels.iter().any(|label| label == "detachment"));
    let lost: Vec<f64> = lost.map(|row| row.value(time).unwrap()).collect();
    // By the bed of springs and by times of equal radius, seconds.
    let right = [23_975.501_4, 24_109.83, 38_379.84];
    assert_eq!(lost.len(), right.len(), "{lost:?}");
    assert!(lost.iter().zip(right).all(|(lost, right)| (lost - right).abs() < 0.05), "{lost:?}");
}

/// Δ hardly tells where the edge of a steep shape is: the edge goes where it is imposed.
#[test]
fn an_imposed_radius_is_met_whatever_the_shape() {
    let found = solved("steep_radius");
    let place = found.columns.iter().position(|column| column.name == "contact_radius").unwrap();
    let last = found.rows.iter().rfind(|row| !row.labels.iter().any(|label| label == "event")).unwrap();
    assert!((last.value(place).unwrap() / 4.630141264406802e-06 - 1.0).abs() < 1e-14);
}

/// Sums over the time followed points that were not dense enough for what relaxes within a segment, or for a contact that is lost within a cycle.
#[test]
fn energies_and_cycles_are_as_exact_as_asked_for() {
    solved("energies");
    solved("cycles_that_open");
}

fn problem(history: History, accuracy: f64) -> IndentationProblem {
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, None, history);
    IndentationProblem { accuracy, energies: true, instants_per_segment: 3, ..problem }
}

/// Hertz: U = (8/15)E*√R Δ^{5/2}, all of it given back; a viscoelastic cycle loses what both integrals say.
#[test]
fn the_work_is_stored_or_lost() {
    let elastic = PlaneMaterial::from_relaxation(3.0, &[]).unwrap();
    let solution = run(&elastic, &problem(History::penetration(0.0).ramp(0.01, 2.0).ramp(0.002, 5.0), 1e-8)).unwrap();
    for instant in &solution.instants {
        let [stored, _, work, lost] = instant.energies.unwrap();
        let exact = 8.0 / 15.0 * 3.0 * instant.penetration.value.powf(2.5);
        let scale = 8.0 / 15.0 * 3.0 * 0.01_f64.powf(2.5);
        for (value, right) in [(stored, exact), (work, exact), (lost, 0.0)] {
            assert!((value.value - right).abs() <= 1e-9 * scale, "{value:?} {right:e}");
        }
    }
    let rubber = PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap();
    let history = History::penetration(0.0).ramp(0.01, 2.0).hold(1e3).ramp(0.002, 0.05).hold(30.0).ramp(0.012, 4.0);
    let solution = run(&rubber, &problem(history, 1e-6)).unwrap();
    assert!(solution.reached && solution.balance_defect.unwrap() < 1e-5, "{:?}", solution.balance_defect);
    let [.., lost] = solution.instants.last().unwrap().energies.unwrap();
    assert!(lost.value > 1e-3 * solution.instants.last().unwrap().energies.unwrap()[2].value);
}

/// A contact without adhesion is solved from its start: a checkpoint of another one is refused.
#[test]
fn a_checkpoint_is_refused_without_adhesion() {
    struct First(std::sync::Mutex<Option<Vec<u8>>>);
    impl Watch for First {
        fn passed(&self, _: u32, _: f64) {}
        fn wants_checkpoint(&self) -> bool {
            self.0.lock().unwrap().is_none()
        }
        fn checkpoint(&self, checkpoint: &viscotack::indentation::Checkpoint) {
            *self.0.lock().unwrap() = Some(postcard::to_allocvec(checkpoint).unwrap());
        }
    }
    let rubber = PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap();
    let without = IndentationProblem { energies: false, ..problem(History::penetration(0.0).ramp(0.03, 1.0), 1e-2) };
    let adhesion = Some(Adhesion { work_of_adhesion: 5e-4, process_zone: 0.013 });
    let taker = First(std::sync::Mutex::new(None));
    run_watched(&rubber, &IndentationProblem { adhesion, ..without.clone() }, None, Some(&taker)).unwrap();
    let bytes = taker.0.lock().unwrap().clone().unwrap();
    let refusal = run_watched(&rubber, &without, Some(postcard::from_bytes(&bytes).unwrap()), None).unwrap_err().to_string();
    assert!(refusal.contains("without adhesion") && refusal.contains("run it without the checkpoint"), "{refusal}");
}
