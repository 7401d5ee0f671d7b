//! Sliding contacts on, just before and just after folds; wrong roots; scenes with more than one contact.
//!
//! Folds of elastic waves are Johnson's; those of viscoelastic ones come from the fold equations of a branch ([`viscotack::sliding::branch`]), or are the largest load
//! of contacts of given half-widths. All of these are found before the case runs.

use super::case::{Expected, Found, HardCase, near};
use super::sliding::solved;
use std::f64::consts::PI;
use std::sync::Arc;
use viscotack::elastic::johnson_wave::WaveBranch;
use viscotack::elastic::{Control, JohnsonWave, WestergaardWave};
use viscotack::estimate::Estimate;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{BranchProblem, BranchStart, SpeedFolds, contacts_of_width, speed_folds, strength, trace};
use viscotack::sliding::contact::{ContactMemory, Indenter, Resolution};
use viscotack::sliding::edge_balance::EdgeBalance;
use viscotack::sliding::steady::{
    SlidingControl, SlidingOutcome, SlidingProblem, Start, WaveAdhesion, steady_sliding, steady_sliding_near,
};

const PROBLEM: &str = "sliding folds";

fn solid(beta: f64) -> Result<PlaneMaterial, Refusal> {
    if beta > 1.0 { PlaneMaterial::standard_solid(1.0, beta, 1.0) } else { PlaneMaterial::elastic(1.0) }
}

fn wave(rate: f64, adhesion: WaveAdhesion, control: SlidingControl) -> SlidingProblem<'static> {
    SlidingProblem { rate, indenter: Indenter::Wave, adhesion: Some(adhesion), work_by_speed: None, control, accuracy: 1e-7 }
}

/// The cases.
#[must_use]
pub fn cases() -> Vec<HardCase> {
    let mut cases = elastic();
    cases.extend(viscoelastic(10.0, 1.0, WaveAdhesion::even(3e-3, 0.01)));
    cases.extend(viscoelastic(3.0, 0.1, WaveAdhesion::even(1e-3, 1e-3)));
    cases.extend(in_speed());
    cases.extend(several());
    cases
}

/// Pull-off and snap-in of an elastic wave with a zone of a millionth, 1e-4 before and after.
fn elastic() -> Vec<HardCase> {
    let (work, zone) = (2e-3, 1e-6);
    let Ok(johnson) = WestergaardWave::new(1.0, 2.0 * PI, 1.0).and_then(|wave| JohnsonWave::new(wave, PI * work)) else {
        return Vec::new();
    };
    let mut cases = Vec::new();
    for (name, fold) in [("pull-off", johnson.pull_off(Control::Load)), ("snap-in", johnson.snap_in())] {
        let Ok(fold) = fold else { continue };
        let limit = 2.0 * fold.mean_pressure;
        let inside = if name == "snap-in" { -1.0 } else { 1.0 };
        for part in [1e-4, -1e-4] {
            let pressure = limit + inside * part * limit.abs();
            let state = johnson.state_by_mean_pressure(0.5 * pressure, WaveBranch::Stable);
            let expected = match (&state, name) {
                // Near a fold a goes with the root of the distance. The zone moves the fold by a part of its own length: two lengths tell the fold without it.
                (Ok(state), _) => vec![
                    Expected::Is("partial contact"),
                    Expected::Value { quantity: "a", value: state.contact_half_width, tolerance: 2e-3 * state.contact_half_width },
                ],
                (Err(_), "snap-in") => vec![Expected::Is("full contact"), near("limit", limit, 1e-9)],
                (Err(_), _) => vec![Expected::NoSuchState { limit, tolerance: 1e-9 }],
            };
            let place = if part > 0.0 { "before" } else { "after" };
            cases.push(HardCase::new(
                PROBLEM,
                format!("elastic, a ten-thousandth {place} {name}"),
                "two contacts meet there: Newton's method slows down, and a wrong step finds the other one",
                "Johnson's wave: the larger contact until the fold; then none, or full contact, with the fold as the limit",
                expected,
                move || {
                    let of_zone =
                        |zone| solved(&solid(1.0)?, &wave(0.0, WaveAdhesion::even(work, zone), SlidingControl::MeanPressure(pressure)));
                    without_zone(of_zone(zone), of_zone(0.5 * zone))
                },
            ));
        }
        let a = fold.contact_half_width;
        cases.push(HardCase::new(
            PROBLEM,
            format!("elastic, on {name} to the last digit"),
            "the Jacobian is singular",
            "Johnson: the contact of the fold, or its limit as the witness; nothing else",
            vec![Expected::Is("the fold or its limit")],
            move || {
                let found = solved(&solid(1.0)?, &wave(0.0, WaveAdhesion::even(work, zone), SlidingControl::MeanPressure(limit)));
                Ok(match found {
                    Ok(found) => {
                        let width = found.values.iter().find(|(quantity, _)| *quantity == "a").map(|(_, value)| value.value);
                        let there = width.map_or_else(|| found.words.contains(&"full contact"), |width| (width / a - 1.0).abs() < 0.05);
                        if there { found.is("the fold or its limit") } else { found }
                    }
                    Err(Refusal::NoSuchState { limit: witness, .. }) if (witness / limit - 1.0).abs() < 1e-4 => {
                        Found::default().is("the fold or its limit")
                    }
                    Err(refusal) => Found::refused(refusal),
                })
            },
        ));
    }
    cases
}

/// What was found of a zone, with the limit that is left without it, from that of half the zone.
fn without_zone(whole: Result<Found, Refusal>, half: Result<Found, Refusal>) -> Result<Found, Refusal> {
    match (whole, half) {
        (Err(Refusal::NoSuchState { reason, limit_name, limit }), Err(Refusal::NoSuchState { limit: other, .. })) => {
            Err(Refusal::NoSuchState { reason, limit_name, limit: 2.0 * other - limit })
        }
        (Ok(mut found), Ok(other)) => {
            let of = |found: &Found| found.values.iter().find(|(quantity, _)| *quantity == "limit").map(|(_, value)| *value);
            if let Some((limit, other)) = of(&found).zip(of(&other)) {
                let value = Estimate::new(2.0 * other.value - limit.value, 2.0 * other.error + limit.error);
                found.values.retain(|(quantity, _)| *quantity != "limit");
                found = found.with("limit", value);
            }
            Ok(found)
        }
        (whole, _) => whole,
    }
}

/// Pull-off and snap-in of a sliding contact with memory.
fn viscoelastic(beta: f64, rate: f64, adhesion: WaveAdhesion) -> Vec<HardCase> {
    let found = solid(beta).and_then(|material| strength(&material, &BranchProblem::loads(rate, adhesion, 1e-9)));
    let folds = found.map(|found| (found.pull_off.map(|fold| fold.value.value), found.snap_in.map(|fold| fold.value.value)));
    let (pull_off, snap_in) = match folds {
        Ok((Some(pull_off), Some(snap_in))) => (pull_off, snap_in),
        // Then every case below fails, and says so.
        _ => (f64::NAN, f64::NAN),
    };
    let case = |name: String, pressure: f64, expected: Vec<Expected>| {
        HardCase::new(
            PROBLEM,
            name,
            "two contacts of the load meet there: a thousandth before it both are near each other, a thousandth after it there is none",
            "the fold equations of the branch of loads",
            expected,
            move || solved(&solid(beta)?, &wave(rate, adhesion, SlidingControl::MeanPressure(pressure))),
        )
    };
    let part = 1e-3;
    let setting = format!("β = {beta}, ζ = {rate}");
    vec![
        case(format!("{setting}, a thousandth before snap-in"), snap_in * (1.0 - part), vec![Expected::Is("partial contact")]),
        case(format!("{setting}, a thousandth after snap-in"), snap_in * (1.0 + part), vec![Expected::Is("full contact")]),
        case(format!("{setting}, a thousandth before pull-off"), pull_off * (1.0 - part), vec![Expected::Is("partial contact")]),
        case(
            format!("{setting}, a hundredth after pull-off"),
            pull_off * 1.01,
            vec![Expected::NoSuchState { limit: pull_off, tolerance: 5e-3 * pull_off.abs() }],
        ),
    ]
}

/// Folds in speed at a held load: the slow contact ends, the fast one begins, and between them there is none.
fn in_speed() -> Vec<HardCase> {
    let (beta, load, adhesion) = (100.0, 0.05, WaveAdhesion::even(5e-3, 0.01));
    let control = SlidingControl::MeanPressure(load);
    let problem = BranchProblem::speeds(control, [1e-6, 1e6], BranchStart::Slow, adhesion, 1e-8);
    let found = solid(beta).and_then(|material| speed_folds(&material, &problem));
    let (lower, upper) = match &found {
        Ok(SpeedFolds { no_contact: Some(gap), .. }) => (gap.lower.parameter().value, gap.upper.parameter().value),
        _ => (f64::NAN, f64::NAN),
    };
    let snap_in = |rate: f64| largest_load(beta, rate, adhesion);
    let case = |name: &'static str, rate: f64, expected: Vec<Expected>| {
        HardCase::new(
            PROBLEM,
            name,
            "between both speeds the load has no contact, and contacts of other loads and of the neighbouring speeds are near",
            "both folds by arclength, and a scan of every contact between them",
            expected,
            move || solved(&solid(beta)?, &wave(rate, adhesion, control)),
        )
    };
    vec![
        case("β = 100, 0.5 % before the fold of the slow contact", 0.995 * lower, vec![Expected::Is("partial contact")]),
        case(
            "β = 100, 0.5 % after the fold of the slow contact",
            1.005 * lower,
            vec![Expected::Is("full contact"), near("limit", snap_in(1.005 * lower), 1e-6)],
        ),
        case(
            "β = 100, midway between both folds",
            (lower * upper).sqrt(),
            vec![Expected::Is("full contact"), near("limit", snap_in((lower * upper).sqrt()), 1e-6)],
        ),
        case("β = 100, a hundredth before the fold of the fast contact", 0.99 * upper, vec![Expected::Is("full contact")]),
        case("β = 100, a hundredth after the fold of the fast contact", 1.01 * upper, vec![Expected::Is("partial contact")]),
    ]
}

/// The largest load of contacts about as wide as that of snap-in, each found at its half-width: the golden section; no fold equations.
fn largest_load(beta: f64, rate: f64, adhesion: WaveAdhesion) -> f64 {
    let Ok(material) = solid(beta) else { return f64::NAN };
    let branch = trace(&material, &BranchProblem::loads(rate, adhesion, 1e-8));
    let Some(about) = branch.ok().and_then(|branch| branch.snap_in().map(|fold| fold.contact.half_width.value)) else { return f64::NAN };
    let load = |half_width: f64| {
        let problem = SlidingProblem { accuracy: 1e-9, ..wave(rate, adhesion, SlidingControl::HalfWidth(half_width)) };
        match steady_sliding(&material, &problem) {
            Ok(SlidingOutcome::Partial(found)) => found.values.mean_pressure.value,
            _ => f64::NAN,
        }
    };
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let (mut low, mut high) = (about - 0.1 * (PI - about), about + 0.1 * (PI - about));
    let (mut one, mut other) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_one, mut at_other) = (load(one), load(other));
    for _ in 0..24 {
        if at_one > at_other {
            (high, other, at_other) = (other, one, at_one);
            one = high - GOLDEN * (high - low);
            at_one = load(one);
        } else {
            (low, one, at_one) = (one, other, at_other);
            other = low + GOLDEN * (high - low);
            at_other = load(other);
        }
    }
    at_one.max(at_other)
}

/// The half-width of the contact that grows out of the slow one: the curve by arclength up to the rate, and the contact next to where it gets there; NaN if it folds
/// before.
fn slow_contact(material: &PlaneMaterial, load: f64, adhesion: WaveAdhesion, rate: f64) -> f64 {
    let control = SlidingControl::MeanPressure(load);
    let problem = BranchProblem::speeds(control, [1e-6, 2.0 * rate], BranchStart::Slow, adhesion, 1e-9);
    let Ok(branch) = trace(material, &problem) else { return f64::NAN };
    let places: Vec<(f64, [f64; 4])> = branch.outline_parameters(&problem).into_iter().zip(branch.outline()).collect();
    let crossing = places.windows(2).find_map(|pair| match pair {
        [(before, one), (after, other)] if *before < rate && *after >= rate => {
            let part = (rate / before).ln() / (after / before).ln();
            Some([one[0] + part * (other[0] - one[0]), one[1] + part * (other[1] - one[1])])
        }
        _ => None,
    });
    let near = crossing
        .and_then(|[a, e]| steady_sliding_near(material, &wave(rate, adhesion, control), &Start::at(a, e)).ok().map(|found| (a, found)));
    // Between two points of the curve the contact is where they say, to a hundredth.
    let near = near.filter(|(a, found)| (found.values.half_width.value - a).abs() < 0.02);
    near.map_or(f64::NAN, |(_, found)| found.values.half_width.value)
}

/// Wrong roots, and contacts of which a load has several.
fn several() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for (beta, rate, work) in [(20.0, 0.3, 2e-3), (10.0, 3.0, 3e-3)] {
        cases.push(HardCase::new(
            PROBLEM,
            format!("400 starts, β = {beta}, ζ = {rate}: wrong roots"),
            "each contact has four roots or six; three and more have pressed edges and interpenetrating faces, with residuals of 1e-15",
            "every contact of a half-width, known without a start: one exists at that penetration",
            vec![
                Expected::Between { quantity: "starts that lead to the contact", low: 40.0, high: 400.0 },
                Expected::Value { quantity: "starts that lead elsewhere", value: 0.0, tolerance: 0.0 },
            ],
            move || starts(beta, rate, WaveAdhesion::even(work, 1e-3)),
        ));
    }
    let adhesion = WaveAdhesion::even(1.5e-3, 1e-3);
    for rate in [0.3, 0.5, 0.55, 0.6, 0.7] {
        let expected = solid(100.0).map_or(f64::NAN, |material| slow_contact(&material, 0.0, adhesion, rate));
        cases.push(HardCase::new(
            PROBLEM,
            format!("β = 100, Γ = 0.0015, no load, ζ = {rate}: two contacts"),
            "a second, larger contact exists near by: a path that steps too far falls on it",
            "the branch of the slow contact by arclength",
            vec![Expected::Value { quantity: "a", value: expected, tolerance: 1e-5 }],
            move || solved(&solid(100.0)?, &wave(rate, adhesion, SlidingControl::MeanPressure(0.0))),
        ));
    }
    for (beta, rate, a) in [(100.0, 3.0, 0.4), (1000.0, 0.01, 1.0), (10.0, 100.0, 2.6)] {
        let adhesion = WaveAdhesion::even(1e-3, 3e-3);
        let every = solid(beta)
            .and_then(|material| contacts_of_width(&material, &BranchProblem::loads(rate, adhesion, 1e-8), a))
            .unwrap_or_default();
        let expected = match every.as_slice() {
            [one] => vec![
                Expected::Value { quantity: "e", value: one.eccentricity, tolerance: 1e-5 },
                Expected::Value { quantity: "p̄", value: one.mean_pressure, tolerance: 1e-5 * one.mean_pressure.abs().max(1.0) },
            ],
            _ => vec![Expected::Between { quantity: "contacts of that width", low: every.len() as f64, high: every.len() as f64 }],
        };
        cases.push(HardCase::new(
            PROBLEM,
            format!("β = {beta}, ζ = {rate}, half-width {a}: the one contact"),
            "the path from the slow contact is long, and its eccentricity large",
            "every contact of a half-width, from a resultant of both closures, without a start",
            expected,
            move || solved(&solid(beta)?, &wave(rate, adhesion, SlidingControl::HalfWidth(a))),
        ));
    }
    cases
}

/// Solves the edges from many starts at the penetration of a known contact.
fn starts(beta: f64, rate: f64, adhesion: WaveAdhesion) -> Result<Found, Refusal> {
    let material = solid(beta)?;
    let known = solved(&material, &wave(rate, adhesion, SlidingControl::MeanPressure(0.1)))?;
    let at = |name: &str| known.values.iter().find(|(quantity, _)| *quantity == name).map_or(f64::NAN, |(_, value)| value.value);
    let control = SlidingControl::Penetration(at("Δ"));
    let balance =
        EdgeBalance::new(Arc::new(ContactMemory::new(&material, rate)?), Indenter::Wave, Some(adhesion), control, Resolution::Fine);
    let (mut here, mut elsewhere) = (0, 0);
    for index in 0..400 {
        // An additive lattice of irrational steps covers the square evenly.
        let (first, second) = ((f64::from(index) * 0.754_877_666_246_692_7).fract(), (f64::from(index) * 0.569_840_290_998_053_2).fract());
        if let Ok((found, _)) = balance.solve_admissible([0.02 + 3.0 * first, 1.6 * (second - 0.5)], None, 1e-9) {
            let same = (found.unknowns[0] - at("a")).abs() < 1e-6 && (found.unknowns[1] - at("e")).abs() < 1e-6;
            if same {
                here += 1;
            } else {
                elsewhere += 1;
            }
        }
    }
    let counted = |count: i32| viscotack::Estimate::exact(f64::from(count));
    Ok(Found::default().with("starts that lead to the contact", counted(here)).with("starts that lead elsewhere", counted(elsewhere)))
}
