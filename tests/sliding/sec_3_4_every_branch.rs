//! Source: theory of `sliding::branch::every` (both conditions are quadratic forms in cos e, sin e and p̄), thesis Sec 3.7, Johnson (1995); the asymptotics of narrow
//! gaps below are our own.
//!
//! Goal: no contact and no branch is missed. Every contact of a half-width is found; a branch that neither the slow nor the fast contact belongs to is found; between
//! two folds there is none; near full contact and in vanishing contacts the numbers are those of other theories.
//!
//! ```text
//!   gap of width 2c, c ≪ δ_memory:      p̄ = |E| cos(e − φ) − σ,   σ = √(8βΓ/c),   |E| sin(φ − e) = r σ      (r = E′ at once over E∞: (1 − 1/β)/ε for one term)
//!   so that no gap is narrower than     c = 8βΓ (r/|E|)²          E = |E|e^{iφ} the modulus of the first harmonic
//! ```
//! The stress that a gap releases relaxes on the way over it by rσ per length, and only the slope of the pressure of the wave there, |E| sin(φ − e), can make up for it.
//!
//! Parameters: β = 10 to 1000, ζ = 0.1 to 1e4, Γ = 1e-5 to 0.005, δ/a and δ/c from 0.1 to 1e-3, a and π − a from 2 to 1e-6; 80 random problems, Γ =
//! 1e-6 to 1, δ = 1e-6
//! to 0.1.
//!
//! Oracle: Newton's method from random starts; collocation; p_out of the branches of loads (an isola in speed is where it is below its value at both ends of the
//! speeds); the formulas above; Johnson's wave as δ → 0; the cylinder.
//!
//! Tolerance: near full contact 1e-8 of p̄ elastic, extrapolated over four δ; sliding 1e-4 (the next order is c/ε and δ/c squared); cylinder 1e-5 of
//! p̄, extrapolated;
//! folds of the isola where p_out passes the load to 1e-6. Bounds of folds hold in at least 98 of 100, and their median is at most a hundred times the error; of random
//! branches no end is a defect and at most one turn in twenty is unlocated (two in a hundred seen).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use std::sync::Arc;
use support::random::Uniform;
use viscotack::PlaneMaterial;
use viscotack::sliding::branch::{
    BranchEnd, BranchPath, BranchProblem, BranchStart, ContactAt, FoldQuantity, Impossible, Scan, SecondVariations, Stability,
    beyond_both_ends, contacts_of_width, every_branch, speed_folds, trace,
};
use viscotack::sliding::contact::{ContactMemory, Prescribed, Resolution, WaveContact};
use viscotack::sliding::edge_balance::EdgeBalance;
use viscotack::sliding::steady::{
    Indenter, PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, Start, WaveAdhesion, steady_sliding, steady_sliding_near,
};
use viscotack_verification::rivals::sliding_collocation::{Layout, SlidingCollocation};

fn adhesion(reduced_work: f64, zone: f64) -> WaveAdhesion {
    WaveAdhesion::even(reduced_work, zone)
}

fn one_time(beta: f64) -> PlaneMaterial {
    if beta > 1.0 { PlaneMaterial::standard_solid(1.0, beta, 1.0).unwrap() } else { PlaneMaterial::elastic(1.0).unwrap() }
}

/// Loads of any half-width.
fn loads(rate: f64, adhesion: WaveAdhesion) -> BranchProblem<'static> {
    BranchProblem { half_widths: [1e-9, PI - 1e-9], ..BranchProblem::loads(rate, adhesion, 1e-8) }
}

/// The contact of a scan to nine digits.
fn accurate(material: &PlaneMaterial, problem: &BranchProblem, contact: &ContactAt) -> PartialValues {
    let steady = SlidingProblem {
        rate: problem.rate,
        indenter: problem.indenter,
        adhesion: Some(problem.adhesion),
        work_by_speed: None,
        control: SlidingControl::HalfWidth(contact.half_width),
        accuracy: 1e-9,
    };
    steady_sliding_near(material, &steady, &Start::at(contact.mean_pressure, contact.eccentricity)).unwrap().values
}

/// The value at zero of the polynomial through pairs (Neville).
fn at_zero(pairs: &[(f64, f64)]) -> f64 {
    let mut values: Vec<f64> = pairs.iter().map(|pair| pair.1).collect();
    for level in 1..pairs.len() {
        for index in 0..pairs.len() - level {
            let (low, high) = (pairs[index].0, pairs[index + level].0);
            values[index] = (low * values[index + 1] - high * values[index]) / (low - high);
        }
    }
    values[0]
}

#[test]
fn random_starts_find_no_contact_that_is_not_known() {
    let mut uniform = Uniform::new();
    let (mut roots, mut several, mut none) = (0, 0, 0);
    for _ in 0..60 {
        let (beta, rate) = (uniform.log_between(3.0, 1000.0), uniform.log_between(0.01, 100.0));
        let (work, half_width) = (uniform.log_between(1e-5, 0.05), uniform.between(0.1, 2.9));
        let zone = uniform.log_between(0.01, 0.2) * half_width.min(PI - half_width);
        let (material, problem) = (one_time(beta), loads(rate, adhesion(work, zone)));
        let known = contacts_of_width(&material, &problem, half_width).unwrap();
        several += usize::from(known.len() > 1);
        none += usize::from(known.is_empty());
        let memory = Arc::new(ContactMemory::new(&material, rate).unwrap());
        let balance =
            EdgeBalance::new(memory, Indenter::Wave, Some(problem.adhesion), SlidingControl::HalfWidth(half_width), Resolution::Medium);
        for _ in 0..12 {
            let start = [beta.sqrt() * uniform.between(-1.5, 1.5), uniform.between(-PI, PI)];
            let Ok((found, _)) = balance.solve_admissible(start, None, 1e-8) else { continue };
            let [pressure, eccentricity] = found.unknowns;
            let same = |contact: &ContactAt| {
                let ahead = contact.eccentricity - eccentricity;
                (ahead - 2.0 * PI * (ahead / (2.0 * PI)).round()).abs() < 1e-4
                    && (contact.mean_pressure - pressure).abs() < 1e-4 * (1.0 + pressure.abs())
            };
            assert!(
                known.iter().any(same),
                "β = {beta}, ζ = {rate}, Γ = {work}, δ = {zone}, a = {half_width}: p̄ = {pressure}, e = {eccentricity}, known {known:?}"
            );
            roots += 1;
        }
    }
    println!("{roots} roots from random starts, all known; of 60 half-widths {several} have several contacts, {none} have none");
    assert!(roots > 60 && several > 2 && none > 2);
}

#[test]
fn contacts_of_two_works_are_those_of_the_path_and_of_random_starts() {
    let mut uniform = Uniform::new();
    let (mut paths, mut roots) = (0, 0);
    for (ratio, rate) in [(0.3, 0.01), (0.3, 0.3), (0.6, 10.0), (0.9, 1.0), (1.5, 0.1), (3.0, 1.0)] {
        let work = 1e-3;
        let both = WaveAdhesion { trailing_work: work, leading_work: ratio * work, trailing_zone: 0.01, leading_zone: 0.02 };
        let (material, problem) = (one_time(10.0), loads(rate, both));
        for half_width in [0.8, 1.2, 1.8] {
            let known = contacts_of_width(&material, &problem, half_width).unwrap();
            let is_known = |pressure: f64, eccentricity: f64| {
                known.iter().any(|contact| {
                    let ahead = contact.eccentricity - eccentricity;
                    (ahead - 2.0 * PI * (ahead / (2.0 * PI)).round()).abs() < 1e-4
                        && (contact.mean_pressure - pressure).abs() < 1e-4 * (1.0 + pressure.abs())
                })
            };
            let steady = SlidingProblem {
                rate,
                indenter: Indenter::Wave,
                adhesion: Some(both),
                work_by_speed: None,
                control: SlidingControl::HalfWidth(half_width),
                accuracy: 1e-8,
            };
            if let Ok(SlidingOutcome::Partial(path)) = steady_sliding(&material, &steady) {
                let values = path.values;
                // Both edges release what their own work takes.
                assert!(
                    is_known(values.mean_pressure.value, values.eccentricity.value),
                    "{ratio} {rate} {half_width}: {values:?} {known:?}"
                );
                paths += 1;
            }
            let memory = Arc::new(ContactMemory::new(&material, rate).unwrap());
            let balance = EdgeBalance::new(memory, Indenter::Wave, Some(both), SlidingControl::HalfWidth(half_width), Resolution::Medium);
            for _ in 0..8 {
                let start = [uniform.between(-1.5, 1.5), uniform.between(-PI, PI)];
                let Ok((found, _)) = balance.solve_admissible(start, None, 1e-8) else { continue };
                assert!(is_known(found.unknowns[0], found.unknowns[1]), "{ratio} {rate} {half_width}: {:?} {known:?}", found.unknowns);
                roots += 1;
            }
        }
        // The branch of loads is the one that every branch finds.
        let problem = BranchProblem { half_widths: [0.3, 2.5], ..problem };
        let found = every_branch(&material, &problem, Scan { half_widths: 24, parameters: 1 }).unwrap();
        assert!(!found.branches.is_empty() && found.left_over.is_empty(), "{:?}", found.left_over);
    }
    println!("two works: {paths} contacts of paths and {roots} of random starts, all known");
    assert!(paths > 10 && roots > 40, "{paths} {roots}");
}

#[test]
fn a_contact_under_a_trough_is_a_contact_for_collocation_too() {
    let (material, problem) = (one_time(10.0), loads(1.0, adhesion(0.003, 0.01)));
    let known = contacts_of_width(&material, &problem, 2.0).unwrap();
    assert_eq!(known.len(), 2, "{known:?}");
    let memory = ContactMemory::new(&material, 1.0).unwrap();
    for contact in &known {
        let start = WaveContact { half_width: 2.0, eccentricity: contact.eccentricity };
        let off: Vec<f64> = [100, 200]
            .into_iter()
            .map(|elements| {
                let scheme =
                    SlidingCollocation::new(memory.kernel(), Layout::WindowAligned { window_elements: elements / 3 }, elements, 2.0)
                        .unwrap();
                let found =
                    scheme.equilibrium(&problem.adhesion, Prescribed::MeanPressure(contact.mean_pressure), start, 1e-8).unwrap().edges;
                (found.half_width - 2.0).abs().max((found.eccentricity - contact.eccentricity).abs())
            })
            .collect();
        println!(
            "e = {:.6}, p̄ = {:.6}: collocation is off by {:.1e} and {:.1e}",
            contact.eccentricity, contact.mean_pressure, off[0], off[1]
        );
        assert!(off[1] < 1e-3 && off[1] < 0.5 * off[0], "{off:?}");
    }
}

#[test]
fn an_isola_is_where_pull_off_is_strongest_between_the_ends() {
    // p_out against speed has its minimum near ζ = 3 and rises to that of the glassy contact: a load between the two has contacts at those speeds alone.
    let (material, adhesion) = (one_time(10.0), adhesion(0.002, 0.03));
    let pull_off = |rate: f64| {
        let problem = BranchProblem::loads(rate, adhesion, 1e-10);
        trace(&material, &problem).unwrap().pull_off(&problem).unwrap().value.value
    };
    let (slow, middle, fast) = (pull_off(1e-4), pull_off(3.0), pull_off(1e4));
    let load = -0.0365;
    println!("p_out = {slow:.6} slow, {middle:.6} at ζ = 3, {fast:.6} fast; load {load}");
    assert!(middle < load && load < fast && fast < slow);
    let problem = BranchProblem::speeds(SlidingControl::MeanPressure(load), [1e-4, 1e4], BranchStart::Slow, adhesion, 1e-9);
    let found = every_branch(&material, &problem, Scan { half_widths: 36, parameters: 32 }).unwrap();
    assert!(found.left_over.is_empty(), "{:?}", found.left_over);
    let closed: Vec<_> =
        found.branches.iter().filter(|branch| branch.begins == BranchEnd::Closed && branch.ends == BranchEnd::Closed).collect();
    assert_eq!(closed.len(), 1, "{} branches", found.branches.len());
    let folds: Vec<f64> = closed[0].folds_of(FoldQuantity::LogRate).map(|fold| fold.value.value).collect();
    assert_eq!(folds.len(), 2, "{folds:?}");
    for fold in &folds {
        let there = pull_off(fold.exp());
        println!("isola turns at ζ = {:.9}, where p_out = {there:.12}", fold.exp());
        assert!((there - load).abs() < 1e-6 * load.abs(), "{there}");
    }
    // The folds of speeds find it as well, where neither elastic limit carries the load.
    let at_load = |load: f64| BranchProblem { path: BranchPath::Speeds(SlidingControl::MeanPressure(load)), ..problem };
    assert!(beyond_both_ends(&material, &at_load(-0.05)) && !beyond_both_ends(&material, &at_load(-0.01)));
    let both = speed_folds(&material, &problem).unwrap();
    assert!(both.slow.is_err() && both.fast.as_ref().is_some_and(Result::is_err) && both.others.is_empty());
    let isola: Vec<_> = both.isolated.iter().filter(|branch| branch.ends == BranchEnd::Closed).collect();
    assert_eq!(isola.len(), 1, "{} branches", both.isolated.len());
    let turns: Vec<f64> = isola[0].folds_of(FoldQuantity::LogRate).map(|fold| fold.parameter().value).collect();
    assert_eq!(turns.len(), 2);
    for (known, name) in [(1.0263, "smallest"), (5.6409, "largest")] {
        assert!(turns.iter().any(|turn| (turn / known - 1.0).abs() < 1e-4), "{name}: {turns:?}");
        let other = folds.iter().map(|fold| fold.exp()).find(|fold| (fold / known - 1.0).abs() < 1e-4).unwrap();
        assert!(turns.iter().any(|turn| (turn / other - 1.0).abs() < 1e-9), "{other} {turns:?}");
    }
    // No contact narrower than one third of the wave carries more than the middle: the scan is the witness.
    let narrow = [0.03, 1.0];
    let more = speed_folds(&material, &BranchProblem { half_widths: narrow, ..at_load(1.02 * middle) });
    let more = more.unwrap();
    assert!(more.at_no_speed() && more.isolated.is_empty() && more.no_contact.is_none() && more.scan_evaluations > 1000, "{more:?}");
    assert!(more.everywhere.unwrap().scan.parameters > 30 && !both.at_no_speed());
    // A load that the middle does not hold has none.
    let beyond = BranchProblem::speeds(SlidingControl::MeanPressure(1.02 * middle), [1e-4, 1e4], BranchStart::Slow, adhesion, 1e-6);
    let found = every_branch(&material, &beyond, Scan { half_widths: 36, parameters: 12 }).unwrap();
    let narrow = found.branches.iter().filter(|branch| branch.outline().iter().any(|point| point[0] < 1.0)).count();
    assert_eq!(narrow, 0, "{} branches", found.branches.len());
}

#[test]
fn between_two_folds_a_scan_finds_no_contact_and_elsewhere_no_other_branch() {
    for (beta, pressure, work) in [(200.0, 0.3, 0.01), (1000.0, 0.0, 0.01), (1000.0, 0.3, 1e-3)] {
        let (material, control) = (one_time(beta), SlidingControl::MeanPressure(pressure));
        let problem = BranchProblem::speeds(control, [1e-4, 1e4], BranchStart::Slow, adhesion(work, 0.003), 1e-8);
        let folds = speed_folds(&material, &problem).unwrap();
        assert!(folds.others.is_empty());
        let gap = folds.no_contact.unwrap();
        let found = every_branch(&material, &problem, Scan { half_widths: 32, parameters: 20 }).unwrap();
        println!(
            "β = {beta}, p̄ = {pressure}, Γ = {work}: none between {:.4e} and {:.4e}; {} contacts of the scan on {} branches",
            gap.lower.parameter().value,
            gap.upper.parameter().value,
            found.contacts,
            found.branches.len()
        );
        assert!(found.left_over.is_empty() && found.branches.len() == 2 && found.contacts > 10, "{:?}", found.left_over);
        assert!(gap.closed && gap.scanned.0 >= 4);
    }
}

#[test]
fn a_gap_of_a_millionth_has_the_load_of_johnsons_wave() {
    let material = one_time(1.0);
    for (work, gap) in [(0.003, 1e-6), (0.2, 1e-6), (1e-6, 1e-6), (0.01, 1e-3)] {
        let half_width: f64 = PI - gap;
        // What is left of π after the half-width is rounded.
        let gap = (PI - half_width) + 1.224_646_799_147_353_2e-16;
        let pairs: Vec<(f64, f64)> = [0.08, 0.04, 0.02, 0.01]
            .into_iter()
            .map(|part| {
                let problem = loads(0.0, adhesion(work, part * gap));
                let known = contacts_of_width(&material, &problem, half_width).unwrap();
                // The gap may also be on the crest.
                assert!(known.iter().filter(|contact| contact.eccentricity.abs() < 3.0).count() == 1, "{known:?}");
                let trough = known.iter().find(|contact| contact.eccentricity.abs() < 3.0).unwrap();
                let found = accurate(&material, &problem, trough);
                assert!(found.mean_pressure.error < 1e-7 * found.mean_pressure.value.abs().max(1.0), "{found:?}");
                (part, found.mean_pressure.value)
            })
            .collect();
        let limit = at_zero(&pairs);
        let exact = (0.5 * gap).cos().powi(2) - 2.0 * (work / (0.5 * gap).tan()).sqrt();
        println!("Γ = {work}, π − a = {gap:.3e}: p̄ = {limit:.9} extrapolated, {exact:.9} in closed form ({:+.1e})", limit / exact - 1.0);
        assert!((limit / exact - 1.0).abs() < 1e-8, "{limit} {exact}");
        // The branch of loads reaches it.
        let problem = BranchProblem { half_widths: [1.0, half_width], ..BranchProblem::loads(0.0, adhesion(work, 0.1 * gap), 1e-8) };
        let branch = trace(&material, &problem).unwrap();
        assert_eq!(branch.ends, BranchEnd::HalfWidth(half_width));
    }
}

/// E = |E|e^{iφ} of the first harmonic and r, how fast a stress relaxes at once.
fn harmonic(material: &PlaneMaterial, rate: f64) -> (f64, f64, f64) {
    let modulus = material.complex_modulus(rate).unwrap();
    let (storage, loss) = (modulus.storage, modulus.loss);
    let relaxing: f64 = material.relaxation_terms().iter().map(|term| term.modulus / (rate * term.relaxation_time)).sum();
    (storage.hypot(loss), loss.atan2(storage), relaxing / material.stiffening_ratio())
}

#[test]
fn a_sliding_gap_of_a_millionth_relaxes_what_the_wave_makes_up_for() {
    for (beta, rate, work) in [(10.0, 1e4, 1e-4), (10.0, 1e3, 1e-6), (200.0, 1e5, 1e-4), (3.0, 1e4, 0.003)] {
        let material = one_time(beta);
        let (size, angle, relaxing) = harmonic(&material, rate);
        let half_width: f64 = PI - 1e-6;
        let gap = (PI - half_width) + 1.224_646_799_147_353_2e-16;
        let pull = (8.0 * beta * work / gap).sqrt();
        let sine = relaxing * pull / size;
        let (mut pressures, mut places) = (Vec::new(), Vec::new());
        for part in [0.04, 0.02, 0.01] {
            let problem = loads(rate, adhesion(work, part * gap));
            let known = contacts_of_width(&material, &problem, half_width).unwrap();
            let near = known.iter().min_by(|one, two| one.eccentricity.abs().total_cmp(&two.eccentricity.abs())).unwrap();
            let found = accurate(&material, &problem, near);
            assert!(found.mean_pressure.error < 1e-6 * found.mean_pressure.value.abs().max(1.0), "{found:?}");
            pressures.push((part, found.mean_pressure.value));
            places.push((part, found.eccentricity.value));
        }
        let (pressure, place) = (at_zero(&pressures), at_zero(&places));
        let expected = size * (1.0 - sine * sine).sqrt() - pull;
        println!(
            "β = {beta}, ζ = {rate:e}, Γ = {work:e}: p̄ = {pressure:.6} ({expected:.6}), sin(φ − e) = {:.4e} ({sine:.4e})",
            (angle - place).sin()
        );
        assert!((pressure - expected).abs() < 1e-4 * pull, "{pressure} {expected}");
        assert!(((angle - place).sin() - sine).abs() < 0.01 * sine + 1e-5, "{place}");
        // The branch of loads reaches it from a contact of middle width.
        let problem = BranchProblem { half_widths: [1.0, half_width], ..BranchProblem::loads(rate, adhesion(work, 0.1 * gap), 1e-8) };
        let branch = trace(&material, &problem).unwrap();
        assert_eq!(branch.ends, BranchEnd::HalfWidth(half_width), "{:?}", branch.ends);
    }
}

#[test]
fn no_sliding_gap_is_narrower_than_its_relaxation_allows() {
    for (beta, rate, work) in [(10.0, 100.0, 1e-4), (10.0, 30.0, 1e-3), (200.0, 1e3, 0.01), (3.0, 10.0, 1e-3)] {
        let material = one_time(beta);
        let (size, _, relaxing) = harmonic(&material, rate);
        let narrowest = 8.0 * beta * work * (relaxing / size).powi(2);
        let pairs: Vec<(f64, f64)> = [0.1, 0.05, 0.025]
            .into_iter()
            .map(|part| {
                let zone = part * narrowest;
                let problem =
                    BranchProblem { half_widths: [1.0, PI - 2.0 * zone], ..BranchProblem::loads(rate, adhesion(work, zone), 1e-8) };
                let branch = trace(&material, &problem).unwrap();
                let fold = branch.folds_of(FoldQuantity::HalfWidth).next().unwrap();
                (part, (PI - fold.value.value) / narrowest)
            })
            .collect();
        let ratio = at_zero(&pairs);
        let memory = narrowest * relaxing;
        println!("β = {beta}, ζ = {rate:e}, Γ = {work:e}: narrowest half gap {ratio:.6} of {narrowest:.3e}; c/ε = {memory:.1e}");
        assert!((ratio - 1.0).abs() < 1e-3 + memory, "{pairs:?}");
    }
}

#[test]
fn stability_is_known_to_a_gap_of_a_millionth() {
    // Under a held load the determinant of the second variations changes its sign with dp̄/da of the branch alone: from the last turn of the load to full contact it
    // has one sign. There the load falls as the contact widens, and the gap closes by itself.
    for (beta, rate, work) in [(1.0, 0.0, 0.003), (1.0, 0.0, 1e-6), (10.0, 1e4, 1e-4), (3.0, 1e4, 0.003), (200.0, 1e5, 1e-4)] {
        let material = one_time(beta);
        let half_width = PI - 1e-6;
        let problem =
            BranchProblem { half_widths: [1.0, half_width], points: 60, ..BranchProblem::loads(rate, adhesion(work, 1e-7), 1e-7) };
        let branch = trace(&material, &problem).unwrap();
        let last_turn = branch.folds.iter().map(|fold| fold.contact.half_width.value).fold(0.0, f64::max);
        let near: Vec<_> = branch.points.iter().filter(|point| point.values.half_width.value > last_turn.max(PI - 0.1)).collect();
        let narrowest = near.iter().map(|point| PI - point.values.half_width.value).fold(f64::INFINITY, f64::min);
        let reported =
            |of: fn(&SecondVariations) -> Stability| near.iter().filter(|point| of(&point.variations) != Stability::Marginal).count();
        let (load, depth) = (reported(SecondVariations::under_load), reported(SecondVariations::under_penetration));
        println!(
            "β = {beta}, ζ = {rate:e}, Γ = {work:e}: {} contacts to π − a = {narrowest:.1e}, {load} reported under load and {depth} under penetration; {:?}",
            near.len(),
            branch.ends
        );
        assert!(near.len() > 3 && narrowest < 3e-6 && load == near.len(), "{load} of {}", near.len());
        for pair in near.windows(2) {
            let rises = pair[1].values.mean_pressure.value > pair[0].values.mean_pressure.value;
            let stable = pair.iter().map(|point| point.variations.under_load() == Stability::Stable);
            assert!(!rises && stable.into_iter().all(|stable| !stable), "{:?}", pair[0].values.half_width);
        }
    }
}

#[test]
fn a_vanishing_contact_is_that_of_a_cylinder() {
    for (beta, rate, work) in [(10.0, 0.1, 1e-5), (10.0, 1.0, 0.003), (200.0, 100.0, 0.003)] {
        let material = one_time(beta);
        let width = 1e-6;
        let pairs: Vec<(f64, f64)> = [0.08, 0.04, 0.02, 0.01]
            .into_iter()
            .map(|part| {
                let wave = loads(rate, adhesion(work, part * width));
                let cylinder = BranchProblem { indenter: Indenter::Parabola, ..wave };
                let [on_wave, on_cylinder] = [wave, cylinder].map(|problem| {
                    let known = contacts_of_width(&material, &problem, width).unwrap();
                    assert_eq!(known.len(), 1, "{known:?}");
                    accurate(&material, &problem, &known[0]).mean_pressure.value
                });
                (part, on_wave / on_cylinder)
            })
            .collect();
        let limit = at_zero(&pairs);
        println!("β = {beta}, ζ = {rate}, Γ = {work:e}: p̄ over that of the cylinder {:.7} at δ = 0.01a, {limit:.9} as δ → 0", pairs[3].1);
        assert!((limit - 1.0).abs() < 1e-5, "{pairs:?}");
        // The branch of loads reaches it.
        let problem = BranchProblem { half_widths: [width, 1.5], ..BranchProblem::loads(rate, adhesion(work, 0.1 * width), 1e-8) };
        let branch = trace(&material, &problem).unwrap();
        assert!(branch.begins == BranchEnd::HalfWidth(width) && branch.work.curve_points < 200, "{:?} {:?}", branch.begins, branch.work);
    }
}

#[test]
fn a_branch_that_cannot_go_on_says_what_forbids_it() {
    let mut seen = 0;
    for (beta, rate, work, zone) in
        [(10.0, 0.03, 0.003, 0.01), (10.0, 1.0, 0.003, 0.01), (1000.0, 0.01, 1e-3, 1e-3), (100.0, 0.1, 1e-3, 0.01)]
    {
        let material = one_time(beta);
        let branch = trace(&material, &BranchProblem::loads(rate, adhesion(work, zone), 1e-8)).unwrap();
        for (end, last) in [(&branch.begins, branch.outline()[0]), (&branch.ends, *branch.outline().last().unwrap())] {
            match end {
                BranchEnd::Impossible { half_width, witness: Impossible::FacesMeet([before, after]), .. } => {
                    assert!(*before > 0.0 && *after <= 0.0 && before - after < 1e-3, "{end:?}");
                    // The contact at the end, solved on its own: its gap is as good as closed somewhere.
                    let control = SlidingControl::MeanPressure(last[2]);
                    let memory = Arc::new(ContactMemory::new(&material, rate).unwrap());
                    let balance = EdgeBalance::new(memory, Indenter::Wave, Some(adhesion(work, zone)), control, Resolution::Fine);
                    let (found, checked) = balance.solve_admissible([last[0], last[1]], None, 1e-9).unwrap();
                    assert!((found.unknowns[0] - half_width).abs() < 1e-3 && checked.smallest_gap < 1e-3, "{checked:?}");
                    seen += 1;
                }
                BranchEnd::Impossible {
                    witness: Impossible::TrailingPressed([before, after]) | Impossible::LeadingPressed([before, after]),
                    ..
                } => {
                    assert!(*before < 0.0 && *after >= 0.0, "{end:?}");
                    seen += 1;
                }
                BranchEnd::HalfWidth(_) => {}
                _ => panic!("{end:?}"),
            }
        }
    }
    // At a held penetration or half-width and large β the fast contact loses the pull of an edge on the way to slower speeds.
    let mut pressed = 0;
    for control in [SlidingControl::Penetration(0.3), SlidingControl::HalfWidth(1.0)] {
        let problem = BranchProblem::speeds(control, [1e-6, 1e6], BranchStart::Fast, adhesion(0.003, 0.01), 1e-8);
        let branch = trace(&one_time(1000.0), &problem).unwrap();
        match &branch.begins {
            BranchEnd::Impossible { parameter, witness: Impossible::LeadingPressed([before, after]), .. } => {
                assert!(*before < 0.0 && *after >= 0.0 && *parameter > 1.0, "{:?}", branch.begins);
                pressed += 1;
            }
            end => panic!("{end:?}"),
        }
    }
    println!("{seen} ends where faces meet, {pressed} where an edge is pressed");
    assert!(seen >= 4);
}

#[test]
fn no_random_branch_ends_in_a_defect() {
    let mut uniform = Uniform::new();
    let (mut folds, mut unlocated, mut traced) = (0, 0, 0);
    for index in 0..80 {
        let (beta, rate) = (uniform.log_between(2.0, 1000.0), uniform.log_between(1e-4, 1e4));
        let (work, zone) = (uniform.log_between(1e-6, 1.0), uniform.log_between(1e-6, 0.1));
        let (material, adhesion) = (one_time(beta), adhesion(work, zone));
        let control = SlidingControl::MeanPressure(uniform.between(-0.4, 2.0));
        let problem = match index % 4 {
            0 | 1 => BranchProblem::loads(rate, adhesion, 1e-8),
            2 => BranchProblem::speeds(control, [1e-6, 1e6], BranchStart::Slow, adhesion, 1e-8),
            _ => BranchProblem::speeds(control, [1e-6, 1e6], BranchStart::Fast, adhesion, 1e-8),
        };
        match trace(&material, &problem) {
            Ok(branch) => {
                for end in [&branch.begins, &branch.ends] {
                    assert!(!matches!(end, BranchEnd::Lost { .. } | BranchEnd::TooLong), "{index}: {end:?}");
                }
                folds += branch.folds.len();
                unlocated += branch.unlocated.len();
                traced += 1;
            }
            // Beyond both elastic limits, or no contact at all.
            Err(viscotack::Refusal::NoSuchState { .. }) => {}
            Err(refusal) => panic!("{index}: {refusal:?}"),
        }
    }
    println!("{traced} branches with {folds} turns, {unlocated} unlocated");
    assert!(traced >= 40 && unlocated * 20 <= folds);
}

#[test]
fn bounds_of_folds_hold_and_are_not_far_too_wide() {
    let mut uniform = Uniform::new();
    let (mut held, mut count) = (0, 0);
    let mut ratios = Vec::new();
    while count < 60 {
        let (beta, rate) = (uniform.log_between(2.0, 300.0), uniform.log_between(0.01, 100.0));
        let (work, zone) = (uniform.log_between(3e-4, 0.02), uniform.log_between(3e-3, 0.03));
        let asked = 10f64.powf(uniform.between(-8.0, -3.0));
        let material = one_time(beta);
        let problem =
            |accuracy: f64| BranchProblem { half_widths: [0.02, 2.9], ..BranchProblem::loads(rate, adhesion(work, zone), accuracy) };
        let (Ok(rough), Ok(fine)) = (trace(&material, &problem(asked)), trace(&material, &problem(1e-12))) else { continue };
        for fold in &rough.folds {
            let Some(best) = fine.folds.iter().find(|other| {
                other.quantity == fold.quantity && (other.contact.half_width.value - fold.contact.half_width.value).abs() < 1e-3
            }) else {
                continue;
            };
            let off = (fold.value.value - best.value.value).abs();
            assert!(fold.value.error <= asked * fold.value.value.abs().max(1.0), "{fold:?}");
            held += usize::from(off <= fold.value.error + best.value.error);
            ratios.push(fold.value.error / off.max(1e-14));
            count += 1;
        }
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    println!(
        "{held} of {count} bounds hold; over the error: median {median:.1}, a tenth below {:.1}, a tenth above {:.1}",
        ratios[count / 10],
        ratios[count - count / 10 - 1]
    );
    assert!(held * 100 >= 98 * count && median < 100.0 && median > 1.0);
}

#[test]
fn one_and_two_threads_give_the_same_branches() {
    let material = one_time(30.0);
    let problem = BranchProblem::speeds(SlidingControl::MeanPressure(0.05), [1e-3, 1e3], BranchStart::Slow, adhesion(0.003, 0.01), 1e-7);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let found = pool.install(|| every_branch(&material, &problem, Scan { half_widths: 24, parameters: 16 }).unwrap());
        let all: Vec<Vec<[u64; 4]>> =
            found.branches.iter().map(|branch| branch.outline().iter().map(|point| point.map(f64::to_bits)).collect()).collect();
        (found.contacts, all)
    };
    assert_eq!(run(1), run(2));
}
