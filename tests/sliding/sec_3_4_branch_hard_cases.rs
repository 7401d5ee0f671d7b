//! Source: thesis Sec 3.7; Johnson (1995) with α = 2√(Γ/m), m the modulus over E0; Barquins' cylinder; the narrowest gap of `sliding_sec_3_4_every_branch.rs`.
//!
//! Goal: every hard branch turns and ends as theory said before it was run, without a panic, a NaN or a number without a bound.
//!
//! Parameters: Γ from 1e-6 to 1, δ from 1e-7 to 0.1, β from 1 to 1000, ζ from 0 to 1e7; one and twelve times; π − a and a down to 1e-6; speeds over twelve decades; wrong
//! numbers.
//!
//! Oracle, named with each case: Johnson's wave of the relaxed or the glassy modulus (which turns there are, and their loads); a scan of every contact at 60 half-widths
//! (how load and penetration turn from one to the next, or that there is no contact), which follows no branch; the strength against speed (folds in speed at a held
//! load are where it is the snap-in load of their speed); the narrowest gap that a sliding contact can have; the cylinder. No outcome was recorded from a run.
//!
//! Tolerance: loads of turns against Johnson 3δ over the half-width of the turn (a finite δ shifts a by 0.65δ; two edges, and the square root of a); snap-in load at
//! folds in speed and adhesion 1e-6; bounds of folds below 1e-7 (relative above one).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use std::f64::consts::PI;
use viscotack::elastic::johnson_wave::{PARTIAL_CONTACT_LIMIT, SPONTANEOUS_FULL_CONTACT};
use viscotack::elastic::{Control, JohnsonWave, WestergaardWave};
use viscotack::material::CreepTerm;
use viscotack::sliding::branch::{
    Branch, BranchEnd, BranchPath, BranchProblem, BranchStart, ContactAt, FoldQuantity, contacts_of_width, speed_folds, trace,
};
use viscotack::sliding::steady::{Indenter, PartialValues, SlidingControl, WaveAdhesion};
use viscotack::{Estimate, PlaneMaterial, Refusal};

fn adhesion(reduced_work: f64, zone: f64) -> WaveAdhesion {
    WaveAdhesion::even(reduced_work, zone)
}

fn one_time(beta: f64) -> PlaneMaterial {
    if beta > 1.0 { PlaneMaterial::standard_solid(1.0, beta, 1.0).unwrap() } else { PlaneMaterial::elastic(1.0).unwrap() }
}

fn many_times() -> PlaneMaterial {
    let terms: Vec<CreepTerm> =
        (0..12).map(|index| CreepTerm { compliance: (1.0 - 1.0 / 100.0) / 12.0, retardation_time: 10f64.powi(-index) }).collect();
    PlaneMaterial::from_creep(100.0, &terms, None).unwrap()
}

/// No number of a result may be a NaN or lack its bound.
fn checked(values: &PartialValues) {
    let mut all = vec![
        values.half_width,
        values.eccentricity,
        values.trailing_edge,
        values.leading_edge,
        values.penetration,
        values.mean_pressure,
        values.friction_stress,
        values.interface_work,
    ];
    let adhesive = values.adhesion.unwrap();
    all.extend([adhesive.trailing_release, adhesive.leading_release, adhesive.adhesive_friction_stress]);
    for Estimate { value, error } in all {
        assert!(value.is_finite() && error.is_finite() && error >= 0.0, "{values:?}");
    }
}

/// A branch none of whose numbers is without a bound, and none of whose ends is a defect.
fn sound(branch: Branch) -> Branch {
    for fold in &branch.folds {
        checked(&fold.contact);
        assert!(fold.value.value.is_finite() && fold.value.error.is_finite(), "{fold:?}");
    }
    for point in &branch.points {
        checked(&point.values);
        assert!(point.parameter.value.is_finite());
    }
    branch.zero_load.iter().for_each(|point| checked(&point.values));
    for end in [&branch.begins, &branch.ends] {
        assert!(!matches!(end, BranchEnd::Lost { .. } | BranchEnd::TooLong), "{end:?}");
    }
    branch
}

/// What was found, or what is not as stated.
type Outcome = Result<String, String>;

fn ensure(holds: bool, text: impl Fn() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(text()) }
}

fn traced(material: &PlaneMaterial, problem: &BranchProblem) -> Result<Branch, String> {
    trace(material, problem).map(sound).map_err(|refusal| format!("{refusal:?}"))
}

fn held_loads(rate: f64, work: f64, zone: f64) -> BranchProblem<'static> {
    BranchProblem { points: 4, half_widths: [zone, PI - 2.0 * zone], ..BranchProblem::loads(rate, adhesion(work, zone), 1e-7) }
}

/// So slow that the solid is relaxed, or so fast that it is glassy: the turns of Johnson's wave of that modulus, where they are wider than three process zones.
fn as_johnson(beta: f64, rate: f64, modulus: f64, work: f64, zone: f64) -> Outcome {
    let problem = held_loads(rate, work, zone);
    let branch = traced(&one_time(beta), &problem)?;
    let wave = JohnsonWave::new(WestergaardWave::new(1.0, 2.0 * PI, 1.0).unwrap(), PI * work / modulus).unwrap();
    let alpha = 2.0 * (work / modulus).sqrt();
    let mut reported = format!("α = {alpha:.4}:");
    let found = [("pull-off", branch.pull_off(&problem)), ("snap-in", branch.snap_in()), ("separation", branch.separation())];
    let expected = [
        (alpha < PARTIAL_CONTACT_LIMIT).then(|| wave.pull_off(Control::Load).unwrap()),
        (alpha < PARTIAL_CONTACT_LIMIT).then(|| wave.snap_in().unwrap()),
        Some(wave.pull_off(Control::Penetration).unwrap()),
    ];
    for ((name, fold), state) in found.into_iter().zip(expected) {
        match (fold, state) {
            (None, None) => reported += &format!(" no {name}"),
            (Some(fold), Some(state)) => {
                let near = state.contact_half_width.min(PI - state.contact_half_width);
                let (value, exact) = match fold.quantity {
                    FoldQuantity::Penetration => (fold.value.value, state.penetration),
                    _ => (fold.value.value, 2.0 * modulus * state.mean_pressure),
                };
                // What presses and what pulls there.
                let half = 0.5 * state.contact_half_width;
                let size = match fold.quantity {
                    FoldQuantity::Penetration => half.sin().powi(2) - 4.0 * (work * half.tan() / modulus).sqrt() * half.sin().ln(),
                    _ => modulus * half.sin().powi(2) + 2.0 * (modulus * work * half.tan()).sqrt(),
                };
                reported += &format!(" {name} {value:.5} ({exact:.5})");
                ensure(fold.value.error < 1e-7 * value.abs().max(1.0), || format!("{name}: {:?}", fold.value))?;
                ensure((value - exact).abs() < 3.0 * zone / near * size, || format!("{name}: {value}, Johnson {exact}"))?;
            }
            (None, Some(state)) if state.contact_half_width < 3.0 * zone => reported += &format!(" {name} within the zone"),
            (fold, state) => return Err(format!("{name}: found {:?}, stated {state:?}", fold.map(|fold| fold.value))),
        }
    }
    // Without load only below the smaller critical adhesion.
    let unloaded = branch.zero_load.iter().any(|point| branch.snap_in().is_some_and(|snap_in| point.arclength < snap_in.arclength));
    ensure(unloaded == (alpha < SPONTANEOUS_FULL_CONTACT), || format!("{} contacts without load at α = {alpha}", branch.zero_load.len()))?;
    Ok(reported)
}

/// The contacts of a row of half-widths that continue one of a middle width of the smallest eccentricity, from narrow to wide; none if there is none at that width.
fn row(material: &PlaneMaterial, problem: &BranchProblem, middle: f64) -> Vec<ContactAt> {
    let place = |width: f64| (0.5 * width).tan().ln();
    let [from, to] = problem.half_widths.map(place);
    let at = |place: f64| contacts_of_width(material, problem, 2.0 * place.exp().atan()).unwrap_or_default();
    let step = (to - from) / 60.0;
    let nearest = |contacts: Vec<ContactAt>, eccentricity: f64| {
        let far = |contact: &ContactAt| (contact.eccentricity - eccentricity).abs();
        contacts.into_iter().min_by(|one, two| far(one).total_cmp(&far(two))).filter(|found| far(found) < 0.35)
    };
    let Some(first) = at(place(middle)).into_iter().min_by(|one, two| one.eccentricity.abs().total_cmp(&two.eccentricity.abs())) else {
        return Vec::new();
    };
    let walk = |sign: f64| {
        let (mut all, mut last, mut here) = (Vec::new(), first, place(middle) + sign * step);
        while here > from && here < to {
            let Some(next) = nearest(at(here), last.eccentricity) else { break };
            all.push(next);
            (last, here) = (next, here + sign * step);
        }
        all
    };
    let mut all = walk(-1.0);
    all.reverse();
    all.push(first);
    all.extend(walk(1.0));
    all
}

/// How a quantity turns along a row: −1 at a minimum, 1 at a maximum, with the half-widths between which it does.
fn turns(row: &[ContactAt], value: impl Fn(&ContactAt) -> f64) -> Vec<(i32, f64, f64)> {
    row.windows(3)
        .filter_map(|triple| {
            let [before, here, after] = triple else { return None };
            let (first, second) = (value(here) - value(before), value(after) - value(here));
            (first * second < 0.0).then_some((if first > 0.0 { 1 } else { -1 }, before.half_width, after.half_width))
        })
        .collect()
}

/// The turns of load and penetration of a branch are those of the scan, each between the half-widths where the scan has it.
fn as_scanned(material: &PlaneMaterial, problem: &BranchProblem, middle: f64) -> Outcome {
    let row = row(material, problem, middle);
    let found = traced(material, problem);
    if row.is_empty() {
        return Err(format!("no contact of half-width {middle}: {:?}", found.map(|branch| branch.ends)));
    }
    let branch = found?;
    let mut reported = format!("{} contacts;", row.len());
    let pressure: fn(&ContactAt) -> f64 = |contact| contact.mean_pressure;
    let depth: fn(&ContactAt) -> f64 = |contact| contact.penetration;
    for (quantity, value) in [(FoldQuantity::MeanPressure, pressure), (FoldQuantity::Penetration, depth)] {
        for (sign, narrow, wide) in turns(&row, value) {
            let fold = branch.folds_of(quantity).find(|fold| {
                let width = fold.contact.half_width.value;
                width > narrow && width < wide && (fold.turn == viscotack::sliding::branch::Turn::Maximum) == (sign > 0)
            });
            reported += &format!(" {quantity:?} {} at {narrow:.3} to {wide:.3}", if sign > 0 { "largest" } else { "smallest" });
            ensure(fold.is_some(), || {
                format!(
                    "{quantity:?} turns at {narrow}..{wide} in the scan; folds {:?}",
                    branch.folds.iter().map(|fold| (fold.quantity, fold.contact.half_width.value)).collect::<Vec<_>>()
                )
            })?;
        }
        // And no other one inside the row, away from its ends.
        let inside = |width: f64| row.len() > 4 && width > row[2].half_width && width < row[row.len() - 3].half_width;
        for fold in branch.folds_of(quantity).filter(|fold| inside(fold.contact.half_width.value)) {
            let width = fold.contact.half_width.value;
            let of_row = row.iter().min_by(|one, two| (one.half_width - width).abs().total_cmp(&(two.half_width - width).abs())).unwrap();
            // Beyond a turn of the half-width another contact has that half-width.
            if (of_row.eccentricity - fold.contact.eccentricity.value).abs() < 0.2 {
                let known = turns(&row, value).into_iter().any(|(_, narrow, wide)| width > narrow && width < wide);
                ensure(known, || format!("{quantity:?} turns at {width}, not in the scan"))?;
            }
        }
    }
    Ok(reported)
}

/// No contact at any of 97 half-widths: the branch is refused, with that reason.
fn nowhere(material: &PlaneMaterial, problem: &BranchProblem) -> Outcome {
    for index in 0..97 {
        let [from, to] = problem.half_widths;
        let width = from + (to - from) * (f64::from(index) + 0.5) / 97.0;
        let found = contacts_of_width(material, problem, width).map_err(|refusal| format!("{refusal:?}"))?;
        ensure(found.is_empty(), || format!("{found:?}"))?;
    }
    match trace(material, problem) {
        Err(Refusal::NoSuchState { reason, .. }) if reason.contains("no steady partial contact exists") => Ok(reason),
        other => Err(format!("{:?}", other.map(|branch| branch.ends))),
    }
}

/// Folds in speed are where the held load is the snap-in load of the speed; between them there is no contact at the load.
fn gap_of_snap_in(beta: f64, pressure: f64, work: f64) -> Outcome {
    let (material, adhesion) = (one_time(beta), adhesion(work, 0.003));
    let problem = BranchProblem {
        points: 4,
        ..BranchProblem::speeds(SlidingControl::MeanPressure(pressure), [1e-6, 1e6], BranchStart::Slow, adhesion, 1e-8)
    };
    let found = speed_folds(&material, &problem).map_err(|refusal| format!("{refusal:?}"))?;
    let gap = found.no_contact.ok_or("no gap between folds")?;
    for branch in [&found.slow, found.fast.as_ref().unwrap()] {
        sound(branch.clone().unwrap());
        ensure(branch.as_ref().unwrap().folds.len() == 1, || "more than one fold".into())?;
    }
    let snap_in = |rate: f64| {
        let branch = trace(&material, &BranchProblem::loads(rate, adhesion, 1e-8));
        branch.ok().and_then(|branch| branch.snap_in().map(|fold| fold.value.value))
    };
    let mut reported = String::new();
    for fold in [&gap.lower, &gap.upper] {
        let rate = fold.parameter().value;
        ensure(fold.value.error < 1e-7, || format!("{:?}", fold.value))?;
        let there = snap_in(rate).ok_or(format!("no snap-in at {rate}"))?;
        reported += &format!("p_IN = {there:.9} at ζ = {rate:.4e}; ");
        ensure((there - pressure).abs() < 1e-6 * pressure.abs().max(1.0), || format!("p_IN = {there} at ζ = {rate}"))?;
    }
    let middle = snap_in((gap.lower.parameter().value * gap.upper.parameter().value).sqrt());
    ensure(middle.is_none_or(|there| there < pressure), || format!("p_IN = {middle:?} between"))?;
    Ok(format!("{reported}p_IN = {middle:?} between"))
}

/// A load that neither Johnson's relaxed nor his glassy wave carries: no branch from either side.
fn beyond_both(pressure: f64) -> Outcome {
    let (beta, work) = (1000.0, 0.003);
    for modulus in [1.0, beta] {
        let wave = JohnsonWave::new(WestergaardWave::new(1.0, 2.0 * PI, 1.0).unwrap(), PI * work / modulus).unwrap();
        let (least, most) = (wave.pull_off(Control::Load).unwrap().mean_pressure, wave.snap_in().unwrap().mean_pressure);
        ensure(pressure < 2.0 * modulus * least || pressure > 2.0 * modulus * most, || format!("{least} {most}"))?;
    }
    let problem = BranchProblem::speeds(SlidingControl::MeanPressure(pressure), [1e-6, 1e6], BranchStart::Slow, adhesion(work, 0.01), 1e-8);
    let found = speed_folds(&one_time(beta), &problem).map_err(|refusal| format!("{refusal:?}"))?;
    match (&found.slow, &found.fast) {
        (Err(Refusal::NoSuchState { limit_name, .. }), Some(Err(Refusal::NoSuchState { .. }))) => Ok((*limit_name).to_owned()),
        _ => Err("a branch where there should be none".into()),
    }
}

/// Whether the branch of loads reaches a gap: where it is wider than the narrowest one, and not where it is narrower.
fn to_gap(beta: f64, rate: f64, work: f64, gap: f64) -> Outcome {
    let material = one_time(beta);
    let narrowest = if beta > 1.0 {
        let modulus = material.complex_modulus(rate).unwrap();
        let size = modulus.storage.hypot(modulus.loss);
        8.0 * beta * work * ((beta - 1.0) / rate / size).powi(2)
    } else {
        0.0
    };
    ensure(!(0.6..1.7).contains(&(gap / narrowest)), || "too near to tell".into())?;
    let problem = BranchProblem { half_widths: [1.0, PI - gap], ..BranchProblem::loads(rate, adhesion(work, 0.05 * gap), 1e-7) };
    let branch = traced(&material, &problem)?;
    let reached = branch.ends == BranchEnd::HalfWidth(PI - gap);
    ensure(reached == (gap > narrowest), || format!("{:?}, narrowest gap {narrowest:e}", branch.ends))?;
    Ok(format!("narrowest half gap {narrowest:.2e}: {}", if reached { "reached" } else { "turns back" }))
}

/// A contact far narrower than all layers is a glassy one, which exists: reached, with p̄ = −√(2βΓa) but for the process zone.
fn to_width(beta: f64, rate: f64, work: f64, width: f64) -> Outcome {
    let problem = BranchProblem { half_widths: [width, 1.5], ..BranchProblem::loads(rate, adhesion(work, 0.02 * width), 1e-7) };
    let branch = traced(&one_time(beta), &problem)?;
    ensure(branch.begins == BranchEnd::HalfWidth(width), || format!("{:?}", branch.begins))?;
    let [half_width, _, pressure, _] = branch.outline()[0];
    let expected = -(2.0 * beta * work * half_width).sqrt();
    ensure((pressure / expected - 1.0).abs() < 0.05, || format!("p̄ = {pressure}, {expected}"))?;
    Ok(format!("p̄ = {pressure:.4e} ({expected:.4e})"))
}

/// Along the work of adhesion a load turns where it is the pull-off or the snap-in load of the work: once if no load is held (snap-in), twice under a pull.
fn along_adhesion(pressure: f64, expected: usize) -> Outcome {
    let material = one_time(10.0);
    let base = BranchProblem::loads(1.0, adhesion(0.003, 0.01), 1e-8);
    let problem =
        BranchProblem { path: BranchPath::Adhesions(SlidingControl::MeanPressure(pressure)), parameters: [1e-6, 1.0], points: 6, ..base };
    let branch = traced(&material, &problem)?;
    ensure(branch.folds.len() == expected, || format!("{} folds", branch.folds.len()))?;
    for fold in &branch.folds {
        let loads = BranchProblem::loads(1.0, adhesion(fold.parameter().value, 0.01), 1e-8);
        let turned = traced(&material, &loads)?;
        let near =
            turned.folds_of(FoldQuantity::MeanPressure).map(|turn| (turn.value.value - pressure).abs()).fold(f64::INFINITY, f64::min);
        ensure(near < 1e-6, || format!("nearest turn of the load {near} away at Γ = {}", fold.parameter().value))?;
    }
    Ok(format!("{expected} folds, each a turn of the load"))
}

/// A cylinder so slow or so fast that it is elastic: p_out = −¾(2Γ/m)^⅔ m.
fn cylinder(rate: f64, modulus: f64) -> Outcome {
    let (work, zone) = (0.003, 1e-3);
    let problem = BranchProblem {
        indenter: Indenter::Parabola,
        half_widths: [0.01, 20.0],
        points: 4,
        ..BranchProblem::loads(rate, adhesion(work, zone), 1e-8)
    };
    let branch = traced(&one_time(10.0), &problem)?;
    let folds: Vec<f64> = branch.folds.iter().map(|fold| fold.value.value).collect();
    let width = (2.0 * work / modulus).cbrt();
    let exact = -0.75 * modulus * width * width;
    ensure(folds.len() == 1 && (folds[0] / exact - 1.0).abs() < 3.0 * zone / width, || format!("{folds:?} {exact}"))?;
    ensure(branch.separation().is_none(), || "a turn of a penetration that has no datum".into())?;
    Ok(format!("p_out = {:.6} ({exact:.6})", folds[0]))
}

/// A wrong number is refused by its name.
fn refused(problem: &BranchProblem, quantity: &str) -> Outcome {
    match trace(&one_time(10.0), problem) {
        Err(Refusal::OutOfRange { quantity: found, .. } | Refusal::Undefined { quantity: found, .. }) if found == quantity => {
            Ok(found.into())
        }
        other => Err(format!("{:?}", other.map(|branch| branch.ends))),
    }
}

struct Case {
    name: String,
    reason: &'static str,
    run: Box<dyn Fn() -> Outcome + Send + Sync>,
}

fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let mut add = |name: String, reason: &'static str, run: Box<dyn Fn() -> Outcome + Send + Sync>| cases.push(Case { name, reason, run });
    for (work, zone) in
        [(1e-6, 1e-4), (1e-3, 1e-3), (0.01, 1e-7), (0.1, 1e-2), (0.1, 1e-6), (0.28, 1e-3), (0.29, 1e-3), (1.0, 1e-3), (1.0, 0.1)]
    {
        add(
            format!("elastic, Γ = {work:e}, δ = {zone:e}"),
            "Johnson: pull-off and snap-in below α = 1.0652, none above; contact without load below α = 0.5699",
            Box::new(move || as_johnson(1.0, 0.0, 1.0, work, zone)),
        );
    }
    for (beta, rate, work, zone) in
        [(10.0, 1e-6, 1e-6, 1e-3), (10.0, 1e-6, 1e-3, 1e-3), (10.0, 1e-5, 0.1, 0.01), (1000.0, 1e-6, 1e-3, 1e-3), (1000.0, 1e-6, 0.1, 0.01)]
    {
        // The zones of the weakest adhesion are as wide as its contacts.
        let zone = if work < 1e-5 { 1e-4 } else { zone };
        let rate = rate * zone;
        add(
            format!("slow, β = {beta}, ζ = {rate:e}, Γ = {work:e}, δ = {zone:e}"),
            "ζ is a millionth of δ: the edges are relaxed, Johnson's wave at modulus 1",
            Box::new(move || as_johnson(beta, rate, 1.0, work, zone)),
        );
    }
    for (beta, rate, work, zone) in [
        (10.0, 1e6, 1e-3, 1e-3),
        (10.0, 1e6, 0.1, 0.01),
        (10.0, 1e6, 3.0, 0.01),
        (1000.0, 1e7, 0.1, 0.01),
        (1000.0, 1e7, 1.0, 1e-3),
        (10.0, 1e6, 1.0, 0.1),
    ] {
        add(
            format!("fast, β = {beta}, ζ = {rate:e}, Γ = {work:e}, δ = {zone:e}"),
            "no layer relaxes on the way over the contact: Johnson's wave at modulus β, adhesion Γ/β",
            Box::new(move || as_johnson(beta, rate, beta, work, zone)),
        );
    }
    for (beta, rate, work, zone) in [
        (10.0, 0.1, 1e-6, 1e-4),
        (10.0, 0.1, 1e-3, 1e-3),
        (10.0, 1.0, 0.01, 0.01),
        (200.0, 100.0, 0.01, 0.003),
        (1000.0, 0.01, 1e-6, 1e-4),
        (1000.0, 0.01, 1e-3, 1e-3),
        (1000.0, 1.0, 1e-6, 1e-4),
        (1000.0, 1e3, 1e-3, 1e-3),
        (1000.0, 1e3, 0.1, 0.01),
    ] {
        add(
            format!("between, β = {beta}, ζ = {rate:e}, Γ = {work:e}, δ = {zone:e}"),
            "every contact of 60 half-widths, found without following anything, turns so",
            Box::new(move || as_scanned(&one_time(beta), &held_loads(rate, work, zone), 0.8)),
        );
    }
    add(
        "twelve times, slowest ζ = 1".into(),
        "every contact of 60 half-widths turns so",
        Box::new(|| {
            let problem = BranchProblem { half_widths: [0.05, 0.8], ..BranchProblem::loads(1.0, adhesion(0.003, 0.01), 1e-7) };
            as_scanned(&many_times(), &problem, 0.3)
        }),
    );
    for (beta, rate, work, zone) in [
        (10.0, 0.1, 0.1, 0.01),
        (10.0, 0.1, 1.0, 1e-3),
        (1000.0, 0.01, 1.0, 1e-3),
        (1000.0, 1.0, 1e-3, 1e-3),
        (1000.0, 1.0, 0.1, 0.01),
        (1000.0, 1.0, 1.0, 1e-3),
    ] {
        add(
            format!("no contact, β = {beta}, ζ = {rate:e}, Γ = {work:e}, δ = {zone:e}"),
            "losses raise the adhesion of the trailing edge above what any partial contact carries: none at 97 half-widths, whatever the load",
            Box::new(move || nowhere(&one_time(beta), &held_loads(rate, work, zone))),
        );
    }
    for (beta, pressure, work) in [
        (200.0, 0.0, 0.01),
        (200.0, 0.3, 1e-3),
        (200.0, 0.3, 0.01),
        (500.0, 0.0, 0.01),
        (500.0, 0.3, 0.01),
        (1000.0, 0.0, 1e-3),
        (1000.0, 0.3, 1e-3),
        (1000.0, 0.3, 0.01),
    ] {
        add(
            format!("speeds β = {beta}, p̄ = {pressure}, Γ = {work:e}"),
            "snap-in falls below the load at some speed and rises above it again at a higher one: the two folds, and no contact in between",
            Box::new(move || gap_of_snap_in(beta, pressure, work)),
        );
    }
    for pressure in [2000.0, -5.0] {
        add(
            format!("speeds β = 1000, p̄ = {pressure}"),
            "beyond snap-in or pull-off of Johnson's wave at both moduli: neither a slow nor a fast contact",
            Box::new(move || beyond_both(pressure)),
        );
    }
    for (beta, rate, work, gap) in [
        (1.0, 0.0, 0.003, 1e-2),
        (1.0, 0.0, 0.003, 1e-4),
        (1.0, 0.0, 0.003, 1e-6),
        (1.0, 0.0, 1.0, 1e-6),
        (10.0, 1e4, 1e-4, 1e-3),
        (10.0, 1e4, 1e-4, 1e-6),
        (10.0, 30.0, 1e-3, 1e-3),
        (10.0, 30.0, 1e-3, 1e-5),
        (200.0, 1e3, 0.01, 1e-4),
        (200.0, 1e3, 0.01, 2e-6),
        (1000.0, 1e6, 1e-3, 1e-6),
    ] {
        add(
            format!("near full β = {beta}, ζ = {rate:e}, Γ = {work:e}, π − a = {gap:e}"),
            "no gap is narrower than 8βΓ(r/|E|)²; an elastic one may be as narrow as it likes",
            Box::new(move || to_gap(beta, rate, work, gap)),
        );
    }
    for (beta, rate, work, width) in [
        (1.0, 0.0, 0.003, 1e-4),
        (1.0, 0.0, 0.003, 1e-6),
        (10.0, 1.0, 0.003, 1e-4),
        (10.0, 1.0, 0.003, 1e-6),
        (200.0, 100.0, 0.003, 1e-6),
        (1000.0, 1e3, 1e-3, 1e-6),
    ] {
        add(
            format!("vanishing β = {beta}, ζ = {rate:e}, Γ = {work:e}, a = {width:e}"),
            "a contact far narrower than its layers is a glassy line contact under the pull of its two edges",
            Box::new(move || to_width(beta, rate, work, width)),
        );
    }
    for (pressure, folds) in [(0.0, 1), (-0.02, 2)] {
        add(
            format!("along Γ at p̄ = {pressure}"),
            "the load is pull-off load of one work of adhesion (under a pull) and snap-in load of another",
            Box::new(move || along_adhesion(pressure, folds)),
        );
    }
    for (rate, modulus) in [(1e-6, 1.0), (1e6, 10.0)] {
        add(
            format!("cylinder, ζ = {rate:e}"),
            "Barquins: one turn of the load, at −¾m(2Γ/m)^⅔; a penetration has no datum",
            Box::new(move || cylinder(rate, modulus)),
        );
    }
    let base = BranchProblem::loads(1.0, adhesion(0.003, 0.01), 1e-8);
    let wrong: Vec<(&str, BranchProblem, &'static str)> = vec![
        ("half-width beyond π", BranchProblem { half_widths: [0.1, 3.5], ..base }, "widest half_width"),
        ("half-widths exchanged", BranchProblem { half_widths: [2.0, 1.0], ..base }, "widest half_width"),
        ("half-width not a number", BranchProblem { half_widths: [f64::NAN, 1.0], ..base }, "narrowest half_width"),
        ("Γ = 0", BranchProblem { adhesion: adhesion(0.0, 0.01), ..base }, "reduced_work"),
        ("δ infinite", BranchProblem { adhesion: adhesion(0.003, f64::INFINITY), half_widths: [0.1, 3.0], ..base }, "trailing_zone"),
        ("rate negative", BranchProblem { rate: -1.0, ..base }, "rate"),
        ("accuracy 0", BranchProblem { accuracy: 0.0, ..base }, "accuracy"),
        (
            "Δ of a parabola",
            BranchProblem {
                indenter: Indenter::Parabola,
                path: BranchPath::Adhesions(SlidingControl::Penetration(0.1)),
                parameters: [1e-3, 1.0],
                ..base
            },
            "the penetration of a cylinder",
        ),
        (
            "speeds exchanged",
            BranchProblem { path: BranchPath::Speeds(SlidingControl::MeanPressure(0.1)), parameters: [1.0, 0.1], ..base },
            "largest parameter",
        ),
    ];
    for (name, problem, quantity) in wrong {
        add(format!("wrong: {name}"), "refused by its name before anything is solved", Box::new(move || refused(&problem, quantity)));
    }
    cases
}

#[test]
fn every_hard_case_is_as_stated_beforehand() {
    let results: Vec<(String, &str, Outcome, f64)> = cases()
        .into_par_iter()
        .map(|Case { name, reason, run }| {
            let begin = std::time::Instant::now();
            let outcome = run();
            (name, reason, outcome, begin.elapsed().as_secs_f64())
        })
        .collect();
    let mut wrong = Vec::new();
    for (name, reason, outcome, time) in &results {
        println!("{name}: {outcome:?} ({:.0} ms)", 1e3 * time);
        if let Err(found) = outcome {
            wrong.push(format!("{name}: {found}\n    stated: {reason}"));
        }
    }
    println!("{} cases", results.len());
    assert!(wrong.is_empty(), "not as stated:\n{}", wrong.join("\n"));
    assert!(results.len() >= 60);
}
