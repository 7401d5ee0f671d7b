//! Source: Eq 4.9 and Secs 4.2–4.4 of the thesis, solved by panels of the edge's path (`viscotack::indentation::by_panels`).
//!
//! Goal: the room beside the integration meets states of an independent program, agrees with the integration, bounds its own errors, and its work is pinned.
//!
//! ```text
//!   a, F, t_end, F_off of relaxed retractions (1, 2, 6 terms; δ/R 1e-2 … 2e-5), approach–dwell–retract, re-advance, two cycles, no adhesion
//! ```
//! Parameters and oracle: `reference_data/sphere_panels.json`, whose note says how it was made; it shares no code with this crate.
//!
//! Tolerances: degree 7, tolerance 1e-8: the oracle's own error plus 2e-9 of the value (2e-8 of a at the end, where dt/da = 0, and of a and F beside
//! turns); degree 5, tolerance 1e-6: what was measured when this was written, twice.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, missing_docs)]

use serde_json::Value;
use std::f64::consts::TAU;
use viscotack::PlaneMaterial;
use viscotack::indentation::by_panels::{End, Outcome, PanelOptions, integrate_by_panels, solve_by_panels};
use viscotack::indentation::{
    Adhesion, Controlled, History, IndentationProblem, Instant, Oscillation, Profile, integrate, run, surface_of,
};
use viscotack::material::CreepTerm;

fn states() -> Value {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("reference_data/sphere_panels.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn number(state: &Value, name: &str) -> f64 {
    state["inputs"][name].as_f64().unwrap_or_else(|| panic!("{name} in {state}"))
}

/// A value of the oracle and its error.
fn value(state: &Value, name: &str) -> (f64, f64) {
    (state[name]["value"].as_f64().unwrap(), state[name]["err"].as_f64().unwrap())
}

fn material(state: &Value) -> PlaneMaterial {
    let inputs = &state["inputs"]["material"];
    let list = |name: &str| inputs[name].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect::<Vec<_>>();
    let terms = list("J").into_iter().zip(list("tau")).map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time });
    PlaneMaterial::from_creep(inputs["E_inf"].as_f64().unwrap(), &terms.collect::<Vec<_>>(), None).unwrap()
}

fn problem(state: &Value, history: History) -> IndentationProblem {
    let work = number(state, "Dgamma");
    let adhesion = (work > 0.0).then(|| Adhesion { work_of_adhesion: work, process_zone: number(state, "delta") });
    IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history)
}

fn retraction(state: &Value) -> IndentationProblem {
    let depth = number(state, "Delta_B");
    problem(state, History::penetration(depth).at_speed(depth - 2.0, number(state, "V"))).relaxed()
}

const FINE: PanelOptions = PanelOptions { degree: 7, tolerance: 1e-8 };
const USUAL: PanelOptions = PanelOptions { degree: 5, tolerance: 1e-6 };
const RETRACTIONS: [&str; 6] =
    ["retract_1", "retract_2", "retract_3_two_terms", "retract_4_six_terms", "retract_5_short_zone", "retract_6_shortest_zone"];

fn assert_near(what: &str, got: f64, (value, err): (f64, f64), share: f64) {
    assert!((got - value).abs() <= err + share * value.abs(), "{what}: {got:e} is not {value:e} to {err:e}: {:.1e}", got / value - 1.0);
}

fn assert_retraction(name: &str, state: &Value, outcome: &Outcome, share: f64, share_of_radius: f64) {
    let last = outcome.ends.last().unwrap();
    assert_eq!(outcome.end, End::Lost, "{name}");
    assert_near(&format!("{name} a_B"), outcome.start.contact_radius, value(state, "a_B"), 2e-13);
    assert_near(&format!("{name} F_B"), outcome.start.force, value(state, "F_B"), 5e-11);
    assert_near(&format!("{name} F_off"), -outcome.least_force.force, value(state, "F_off"), share);
    assert_near(&format!("{name} t_end"), last.time, value(state, "t_end"), share);
    assert_near(&format!("{name} a_end"), last.contact_radius, value(state, "a_end"), share_of_radius);
}

#[test]
fn relaxed_retractions_meet_the_oracle() {
    let states = states();
    for name in RETRACTIONS {
        let state = &states[name];
        let (material, problem) = (material(state), retraction(state));
        assert_retraction(name, state, &integrate_by_panels(&material, &problem, FINE, &[]).unwrap(), 2e-9, 2e-8);
        assert_retraction(name, state, &integrate_by_panels(&material, &problem, USUAL, &[]).unwrap(), 2e-7, 2e-6);
    }
}

/// No work hides behind a time: closures and their nodes, exactly, so that a change is seen.
#[test]
fn work_is_pinned() {
    let states = states();
    let pinned = PINNED;
    for (name, (closures, nodes)) in RETRACTIONS.iter().zip(pinned) {
        let outcome = integrate_by_panels(&material(&states[name]), &retraction(&states[name]), USUAL, &[]).unwrap();
        let got = (outcome.closures, outcome.kernel_nodes);
        assert!(got.0 <= closures && got.1 <= nodes, "{name}: {got:?} is more than {:?}", (closures, nodes));
    }
}

/// Closures and nodes of the six retractions at degree 5, tolerance 1e-6, with a twentieth for the rounding of another machine.
const PINNED: [(u64, u64); 6] = [(727, 24_900), (525, 18_800), (690, 26_300), (1130, 62_700), (1021, 28_500), (777, 20_400)];

fn assert_rows(state: &Value, outcome: &Outcome, keys: &[&str], share: f64) {
    assert_eq!(outcome.wanted.len(), keys.len());
    for (row, key) in outcome.wanted.iter().zip(keys) {
        assert_near(&format!("a_{key}"), row.contact_radius, value(state, &format!("a_{key}")), share);
        assert_near(&format!("F_{key}"), row.force, value(state, &format!("F_{key}")), share);
    }
}

#[test]
fn approach_dwell_and_retraction_meet_the_oracle() {
    let states = states();
    let state = &states["approach_dwell_retract"];
    let (speed, most, dwell) = (number(state, "V"), number(state, "Delta_max"), number(state, "dwell"));
    let history = History::penetration(0.0).at_speed(most, speed).hold(dwell).at_speed(-1.0, speed);
    let loaded = most / speed;
    let outcome = integrate_by_panels(&material(state), &problem(state, history), FINE, &[loaded, loaded + dwell]).unwrap();
    assert_near("a_jumpin", outcome.start.contact_radius, value(state, "a_jumpin"), 2e-13);
    assert_rows(state, &outcome, &["load_end", "dwell_end"], 2e-9);
    let last = outcome.ends.last().unwrap();
    assert_near("F_off", -outcome.least_force.force, value(state, "F_off"), 2e-9);
    assert_near("t_end", last.time, value(state, "t_end"), 2e-9);
    assert_near("a_end", last.contact_radius, value(state, "a_end"), 2e-8);
}

#[test]
fn an_edge_that_advances_again_over_its_first_place_meets_the_oracle() {
    let states = states();
    let state = &states["readvance"];
    let (speed, reverse, depth) = (number(state, "V"), number(state, "t_reverse"), number(state, "Delta_B"));
    let history = History::penetration(depth).ramp(depth - speed * reverse, reverse).ramp(depth - speed * reverse + 8.0 * speed, 8.0);
    let outcome = integrate_by_panels(&material(state), &problem(state, history).relaxed(), FINE, &[2.0, 3.0, 5.0, 7.0, 10.0]).unwrap();
    assert_eq!(outcome.end, End::History);
    assert_rows(state, &outcome, &["rev", "t3", "t5", "t7", "t10"], 2e-9);
}

#[test]
fn two_cycles_meet_the_oracle() {
    let states = states();
    let state = &states["oscillation_two_cycles"];
    let (amplitude, omega) = (0.0015, 0.8);
    let history = History::penetration(0.022).oscillate(Oscillation::steady(amplitude, omega / TAU), 2.0 * TAU / omega);
    let keys = ["t0.981846", "t1.963692", "t2.945538", "t4.909229", "t6.872921", "end"];
    let instants = [1.0001, 2.0002, 3.0003, 5.0005, 7.0007, 16.0].map(|part| part * TAU / omega / 8.0);
    let outcome = integrate_by_panels(&material(state), &problem(state, history).relaxed(), FINE, &instants).unwrap();
    assert_rows(state, &outcome, &keys, 2e-8);
}

#[test]
fn press_hold_and_retraction_without_adhesion_meet_ting() {
    let states = states();
    let state = &states["adhesiveless_hold_retract"];
    let history = History::penetration(0.0).ramp(0.03, 3.0).hold(2.0).ramp(0.03 - 0.015, 1.0);
    let options = PanelOptions { degree: 7, tolerance: 1e-9 };
    let outcome = integrate_by_panels(&material(state), &problem(state, history), options, &[5.1, 5.3, 5.6]).unwrap();
    // F is stationary in a; a to the tolerance of the integration.
    for (row, key) in outcome.wanted.iter().zip(["t5.1", "t5.3", "t5.6"]) {
        assert_near(key, row.contact_radius, value(state, &format!("a_{key}")), 2e-9);
        assert_near(key, row.force, value(state, &format!("F_{key}")), 2e-11);
    }
}

/// Bounds from two paths hold against the oracle, and are not idle.
#[test]
fn bounds_cover_the_errors() {
    let states = states();
    for accuracy in [1e-4, 1e-6] {
        for name in RETRACTIONS {
            let state = &states[name];
            let solved = solve_by_panels(&material(state), &IndentationProblem { accuracy, ..retraction(state) }).unwrap();
            let (force, force_error) = value(state, "F_off");
            let (end, end_error) = value(state, "t_end");
            let tension = solved.pull_off_force().unwrap();
            assert!((tension.value - force).abs() <= tension.error + force_error, "{name} {accuracy:e}: F_off {tension:?}");
            let last = solved.events.last().unwrap();
            assert!((last.time.value - end).abs() <= last.time.error + end_error, "{name} {accuracy:e}: t_end {last:?}");
            // Not idle.
            assert!(
                tension.error <= accuracy * force && last.time.error <= 5.0 * accuracy * end,
                "{name} {accuracy:e}: {tension:?} {last:?}"
            );
            assert!(solved.reached && solved.by_panels && solved.smallest_gap_factor >= 0.0, "{name}");
        }
    }
}

/// After the contact nothing presses, the indenter goes on, and energy is only lost.
#[test]
fn after_the_contact() {
    let states = states();
    let state = &states[RETRACTIONS[0]];
    let history = History::penetration(0.03).ramp(-0.05, 20.0).ramp(-0.06, 5.0);
    let asked = IndentationProblem { instants_per_segment: 40, energies: true, ..problem(state, history) }.relaxed();
    let (solved, integrated) = (solve_by_panels(&material(state), &asked).unwrap(), run(&material(state), &asked).unwrap());
    assert_eq!(solved.instants.len(), integrated.instants.len());
    assert_eq!(
        solved.events.iter().map(|event| event.kind).collect::<Vec<_>>(),
        integrated.events.iter().map(|event| event.kind).collect::<Vec<_>>()
    );
    let scales = integrated.integration.summary.scales;
    let open = solved.instants.iter().position(|instant| instant.contact_radius.value == 0.0).unwrap();
    assert!(open > 10 && open < 60);
    let energy = |instant: &Instant| instant.energies.unwrap();
    let all = energy(solved.instants.last().unwrap())[3].value;
    for (k, (ours, theirs)) in solved.instants.iter().zip(&integrated.instants).enumerate() {
        assert!((ours.penetration.value - theirs.penetration.value).abs() <= 1e-12);
        assert!((ours.force.value - theirs.force.value).abs() <= 2e-4 * scales[1], "{k}: {ours:?} {theirs:?}");
        for (one, other) in energy(ours).iter().zip(&energy(theirs)).enumerate().filter(|(which, _)| *which != 1).map(|(_, pair)| pair) {
            assert!((one.value - other.value).abs() <= 1e-3 * all, "{k}: {ours:?} {theirs:?}");
        }
        if k > open {
            assert_eq!(ours.force.value.to_bits(), 0.0_f64.to_bits());
            assert!(energy(ours)[0].value < energy(&solved.instants[k - 1])[0].value, "{k}");
        }
    }
    assert!(solved.balance_defect.unwrap() < 1e-6, "{:?}", solved.balance_defect);
}

/// Pressure and displacement of a path by panels, against those of an integration walked again in many pieces.
#[test]
fn surfaces_agree_with_those_of_time_steps() {
    let states = states();
    let state = &states["readvance"];
    let asked =
        IndentationProblem { accuracy: 1e-6, ..problem(state, History::penetration(0.03).ramp(0.022, 2.0).ramp(0.054, 8.0)) }.relaxed();
    let material = material(state);
    let solved = solve_by_panels(&material, &asked).unwrap();
    for time in [1.0, 5.0] {
        let (point, [fine, coarse]) = surface_of(&material, &asked, &solved, time).unwrap().unwrap();
        let a = point.contact_radius;
        assert!((fine.radius() - a).abs() <= 1e-12 * a && (coarse.radius() - a).abs() <= 1e-4 * a);
        // F = ∫p dA, with r² = r₀² + (r₁² − r₀²) sin² φ between the places of roots: the edge, where it turned, and where the first contact ended.
        let mut ends = vec![0.0, a];
        ends.extend(solved.instants[..2].iter().map(|instant| instant.contact_radius.value).filter(|radius| *radius < a));
        ends.sort_by(f64::total_cmp);
        let rule = viscotack::special::gauss_legendre::UNIT_RULE_8.clone();
        let (pieces, mut force) = (64, 0.0);
        for pair in ends.windows(2) {
            let ring = pair[1] * pair[1] - pair[0] * pair[0];
            for (piece, (x, weight)) in (0..pieces).flat_map(|piece| rule.iter().map(move |node| (piece, node))) {
                let angle = std::f64::consts::FRAC_PI_2 * (f64::from(piece) + x) / f64::from(pieces);
                let width = std::f64::consts::FRAC_PI_2 * weight / f64::from(pieces);
                let radius = (pair[0] * pair[0] + ring * angle.sin() * angle.sin()).sqrt();
                force += TAU * ring * angle.sin() * angle.cos() * width * fine.pressure(radius).unwrap();
            }
        }
        assert!((force - point.force).abs() <= 1e-5 * point.force.abs(), "{time}: {force} {}", point.force);
        // Bonded points follow the indenter: w = Δ − r²/2R.
        for part in [0.0, 0.3, 0.9] {
            let radius = part * a;
            let expected = point.penetration - 0.5 * radius * radius;
            assert!((fine.displacement(radius).unwrap() - expected).abs() <= 1e-9 * point.penetration, "{time} {part}");
        }
    }
}

/// F dΔ + G_tip dA = dU + P_d dt, an identity of exact fields: retractions, an approach with its dwell, an edge that comes back, cycles with their merged segments, a
/// held force with its first jump.
#[test]
fn the_power_balance_closes() {
    let states = states();
    let mut cases = Vec::new();
    for name in RETRACTIONS {
        cases.push((name, material(&states[name]), retraction(&states[name]), 1e-11));
    }
    let of = |name: &'static str, history: History, relaxed: bool, share: f64| {
        let problem = problem(&states[name], history);
        (name, material(&states[name]), if relaxed { problem.relaxed() } else { problem }, share)
    };
    cases.push(of("approach_dwell_retract", History::penetration(0.0).at_speed(0.015, 0.05).hold(0.3).at_speed(-1.0, 0.05), false, 1e-9));
    cases.push(of("readvance", History::penetration(0.03).ramp(0.022, 2.0).ramp(0.054, 8.0), true, 1e-9));
    let cycles = History::penetration(0.022).oscillate(Oscillation::steady(0.0015, 0.8 / TAU), 4.0 * TAU / 0.8);
    cases.push(of("oscillation_two_cycles", cycles, true, 1e-8));
    for (name, material, mut problem, share) in cases {
        problem.energies = true;
        let outcome = integrate_by_panels(&material, &problem, USUAL, &[]).unwrap();
        let accounts = outcome.accounts();
        let balance = |k: usize| {
            let (energies, turned) = accounts[k];
            turned.external + turned.tip - turned.dissipated - energies.stored
        };
        let (_, turned) = accounts.last().unwrap();
        let all = turned.external.abs() + turned.tip.abs() + turned.dissipated;
        let drift = (0..accounts.len()).map(|k| (balance(k) - balance(0)).abs()).fold(0.0, f64::max);
        let end = (balance(accounts.len() - 1) - balance(0)).abs();
        println!("{name}: {end:e} at the end, {drift:e} on the way, of {all:e}");
        // Within a panel by interpolation of what is turned over.
        assert!(
            turned.dissipated > 0.0 && end <= share * all && drift <= (10.0 * share).max(1e-9) * all,
            "{name}: {end:e}, {drift:e} of {all:e}"
        );
        assert!(outcome.ends.iter().all(|row| row.stress_intensity > 0.0), "{name}");
    }
}

/// The integration of this crate, another method, at its own tolerance.
#[test]
fn time_steps_agree() {
    let states = states();
    let state = &states["retract_1"];
    let (material, mut problem) = (material(state), retraction(state));
    problem.history = History::penetration(0.028).ramp(0.028 - 0.002 * 20.0, 20.0);
    problem.instants_per_segment = 4;
    let trace = integrate(&material, &problem, 1e-5).unwrap();
    let instants: Vec<f64> = trace.kept.iter().map(|&kept| trace.path[kept].time).collect();
    let panels = integrate_by_panels(&material, &problem, USUAL, &instants).unwrap();
    assert_eq!(panels.wanted.len(), instants.len());
    for (row, &kept) in panels.wanted.iter().zip(&trace.kept) {
        let point = &trace.path[kept];
        assert!((row.contact_radius / point.contact_radius - 1.0).abs() < 1e-6, "{row:?} {point:?}");
        assert!((row.force - point.force).abs() < 1e-6 * 0.008, "{row:?} {point:?}");
    }
}

/// A sudden pull, held: the edge jumps with the penetration, then creeps until it lets go.
#[test]
fn a_constant_force_meets_the_oracle() {
    let states = states();
    let state = &states["constant_force"];
    let pull = -3.0 * std::f64::consts::PI * number(state, "Dgamma");
    let history = History::penetration(number(state, "Delta_B")).then(Controlled::Force, pull, 0.0).then(Controlled::Force, pull, 1e4);
    for options in [USUAL, FINE] {
        let outcome = integrate_by_panels(&material(state), &problem(state, history.clone()).relaxed(), options, &[]).unwrap();
        let (first, last) = (outcome.jumps.first().unwrap(), outcome.ends.last().unwrap());
        assert_near("Delta0", first.penetration, value(state, "Delta0"), 2e-13);
        assert_near("a0", first.contact_radius, value(state, "a0"), 2e-13);
        assert_eq!(outcome.end, End::Lost);
        assert_near("t_detach", last.time, value(state, "t_detach"), 0.0);
        assert_near("Delta_detach", last.penetration, value(state, "Delta_detach"), 0.0);
        assert_near("a_detach", last.contact_radius, value(state, "a_detach"), 0.0);
        assert!((last.force / pull - 1.0).abs() < 1e-7, "{last:?}");
    }
}

/// Against the integration of this crate: a frame, soft and stiff, and a start under a force.
#[test]
fn frames_and_forces_agree_with_time_steps() {
    let states = states();
    let state = &states["readvance"];
    let material = material(state);
    for (history, stiffness) in [
        (History::frame(0.03).ramp(0.0, 5.0), Some(1.0)),
        (History::frame(0.0).ramp(0.04, 5.0).hold(1.0), Some(0.05)),
        (History::force(0.002).ramp(-0.001, 4.0), None),
    ] {
        let mut problem = problem(state, history).relaxed();
        problem.frame_stiffness = stiffness;
        problem.instants_per_segment = 3;
        let trace = integrate(&material, &problem, 1e-5).unwrap();
        let instants: Vec<f64> = trace.kept.iter().map(|&kept| trace.path[kept].time).collect();
        let panels = integrate_by_panels(&material, &problem, USUAL, &instants).unwrap();
        assert!(panels.wanted.len() + 1 >= instants.len(), "{panels:?}");
        for (row, &kept) in panels.wanted.iter().zip(&trace.kept) {
            let point = &trace.path[kept];
            assert!((row.contact_radius / point.contact_radius - 1.0).abs() < 2e-6, "{row:?} {point:?}");
            assert!((row.penetration - point.penetration).abs() < 2e-6 * 0.03, "{row:?} {point:?}");
            assert!((row.force - point.force).abs() < 2e-6 * 0.01, "{row:?} {point:?}");
        }
    }
}

#[test]
fn what_it_does_not_solve_is_refused_with_the_reason() {
    let states = states();
    let state = &states["retract_1"];
    let material = material(state);
    let mut asked = problem(state, History::force(0.0).hold(1.0)).relaxed();
    asked.adhesion = None;
    let refusal = integrate_by_panels(&material, &asked, USUAL, &[]).unwrap_err().to_string();
    assert!(refusal.contains("a force or a sudden step without adhesion"), "{refusal}");
    asked.history = History::penetration(0.02).step(0.01).hold(1.0);
    let refusal = integrate_by_panels(&material, &asked, USUAL, &[]).unwrap_err().to_string();
    assert!(refusal.contains("a force or a sudden step without adhesion"), "{refusal}");
    let refusal = solve_by_panels(&material, &asked).unwrap_err().to_string();
    assert!(refusal.contains("without adhesion"), "{refusal}");
    let rimmed = Profile::FlatPunch { radius: 0.1 };
    let refusal =
        integrate_by_panels(&material, &IndentationProblem { profile: rimmed, ..retraction(state) }, USUAL, &[]).unwrap_err().to_string();
    assert!(refusal.contains("shapes with a rim"), "{refusal}");
    // A sphere of which points are known up to 0.3: pressed to less than that, and beyond.
    let points: Vec<(f64, f64)> = (0..=30).map(|k| f64::from(k) * 0.01).map(|radius| (radius, 0.5 * radius * radius)).collect();
    let table = |depth: f64| {
        let pressed = problem(state, History::penetration(0.02).ramp(depth, 1.0)).relaxed();
        integrate_by_panels(&material, &IndentationProblem { profile: Profile::table(&points).unwrap(), ..pressed }, USUAL, &[])
    };
    let widest = table(0.022).unwrap().ends.iter().map(|row| row.contact_radius).fold(0.0, f64::max);
    assert!(widest < 0.3, "{widest}");
    let refusal = table(0.12).unwrap_err().to_string();
    assert!(refusal.contains("the radius of its last point"), "{refusal}");
    let lifted = problem(state, History::penetration(-0.5).hold(1.0)).relaxed();
    assert!(integrate_by_panels(&material, &lifted, USUAL, &[]).is_err());
}
