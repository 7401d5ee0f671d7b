//! Source: issue "Sliding branches", part 4; `reference_data/sliding_hysteresis.csv`, written by `verification/references/sliding_hysteresis.py`; theory section 3
//! (edge amplitudes k² = 8βΓ sin a as δ → 0); thesis Sec 3.1 (Δγ as an apparent work of adhesion).
//!
//! Goal: contacts whose edges take different works, and works that follow the speed.
//!
//! ```text
//!   Γ₁ ←|‾‾‾‾‾‾‾|→ Γ₂       trailing edge opens at Γ₁, leading edge closes at Γ₂, v →       elastic: friction = Γ₁ − Γ₂, lag sin e = (√Γ₂ − √Γ₁)/√(m s c³)
//! ```
//! Parameters: works from 1e-6 to 0.01 with ratios of both signs; elastic, one and three times; all controls; a wave and a cylinder; a law and a table of speeds.
//!
//! Oracle: collocation of the integral equation at given edges; the elastic closed forms, reached as δ → 0; the energy identity of hysteresis; the same contact
//! with the works at its speed written as constants.
//!
//! Tolerance: 3e-11 against the collocation (which confirms 11 digits); what is left of three process zones by extrapolation; bounds elsewhere.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::reference_rows;
use support::sliding::contact_near;
use viscotack::PlaneMaterial;
use viscotack::closure::work_by_speed::{WorkAtSpeed, WorkBySpeed};
use viscotack::material::CreepTerm;
use viscotack::sliding::branch::{BranchProblem, BranchStart, FoldQuantity, strength, trace};
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::sensitivity::state_sensitivities;
use viscotack::sliding::steady::{
    Indenter, PartialContact, PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding,
};

const RELAXED: f64 = 2.3e6;
const RATE: f64 = 7.0;

fn of_terms(terms: &[(f64, f64)]) -> PlaneMaterial {
    let glassy = 1.0 - terms.iter().map(|term| term.0).sum::<f64>();
    let terms: Vec<CreepTerm> =
        terms.iter().map(|&(compliance, ratio)| CreepTerm { compliance: compliance / RELAXED, retardation_time: ratio / RATE }).collect();
    PlaneMaterial::from_creep(RELAXED / glassy, &terms, None).unwrap()
}

fn uneven(trailing_work: f64, leading_work: f64, zone: f64) -> WaveAdhesion {
    WaveAdhesion { leading_work, ..WaveAdhesion::even(trailing_work, zone) }
}

fn problem(adhesion: WaveAdhesion, rate: f64, control: SlidingControl) -> SlidingProblem<'static> {
    SlidingProblem { rate, indenter: Indenter::Wave, adhesion: Some(adhesion), work_by_speed: None, control, accuracy: 1e-11 }
}

fn partial(material: &PlaneMaterial, problem: &SlidingProblem<'_>) -> PartialContact {
    match steady_sliding(material, problem).unwrap_or_else(|refusal| panic!("{refusal}: {problem:?}")) {
        SlidingOutcome::Partial(contact) => *contact,
        SlidingOutcome::Full(_) => panic!("full contact: {problem:?}"),
    }
}

#[test]
fn contacts_of_two_works_meet_the_collocated_ones() {
    let rows = reference_rows("sliding_hysteresis.csv");
    let quantity =
        |case: &str, name: &str| rows.iter().find(|row| row.text("case") == case && row.text("quantity") == name).unwrap().number("value");
    let mut worst = 0.0_f64;
    let mut cases = 0;
    for row in rows.iter().filter(|row| row.text("quantity") == "trailing_work") {
        let terms: Vec<(f64, f64)> = row
            .text("terms")
            .split_whitespace()
            .map(|term| term.split_once(':').map(|(one, two)| (one.parse().unwrap(), two.parse().unwrap())).unwrap())
            .collect();
        let (case, half_width, eccentricity, zone) = (row.text("case"), row.number("a"), row.number("e"), row.number("zone"));
        let memory = ContactMemory::new(&of_terms(&terms), RATE).unwrap();
        let adhesion = uneven(row.number("value"), quantity(case, "leading_work"), zone);
        let start = WaveContact { half_width: 1.03 * half_width, eccentricity: eccentricity - 0.02 };
        let found = contact_near(&memory, Some(adhesion), Prescribed::MeanPressure(row.number("mean_pressure")), start, 1e-12).unwrap();
        assert!(found.admissible);
        let contact = found.state.contact();
        for (name, value, expected) in [
            ("half-width", contact.half_width, half_width),
            ("eccentricity", contact.eccentricity, eccentricity),
            ("penetration", found.state.penetration(), quantity(case, "penetration")),
            ("friction", found.state.friction_stress(), quantity(case, "friction_stress")),
            ("G₁", found.trailing_release, quantity(case, "trailing_release")),
            ("G₂", found.leading_release, quantity(case, "leading_release")),
        ] {
            let error = (value - expected).abs() / expected.abs().max(1.0);
            let tolerance = if name.starts_with('G') { 1e-10 } else { 3e-11 };
            assert!(error < tolerance, "{case} {name}: {value} instead of {expected}");
            worst = worst.max(error);
        }
        cases += 1;
    }
    println!("{cases} contacts of two works: worst error {worst:.1e}");
    assert_eq!(cases, 5);
}

/// Half-width and eccentricity of the elastic contact at vanishing process zone, under a mean pressure: bisection of the closed form.
fn closed_form(trailing: f64, leading: f64, modulus: f64, pressure: f64) -> (f64, f64) {
    let lag = |a: f64| (leading.sqrt() - trailing.sqrt()) / (modulus * (0.5 * a).sin() * (0.5 * a).cos().powi(3)).sqrt();
    let load = |a: f64| {
        let pull = (trailing.sqrt() + leading.sqrt()) * (modulus * (0.5 * a).tan()).sqrt();
        modulus * (1.0 - lag(a).powi(2)).sqrt() * (0.5 * a).sin().powi(2) - pull
    };
    let (mut low, mut high) = (0.3, 1.6);
    assert!(load(low) < pressure && load(high) > pressure);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if load(middle) > pressure { high = middle } else { low = middle }
    }
    (low, lag(low).asin())
}

/// At vanishing process zone from three, by what is left after powers δ and δ².
fn at_vanishing_zone(of_zone: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let [coarse, middle, fine] = [4e-4, 2e-4, 1e-4].map(of_zone);
    (0..coarse.len())
        .map(|index| {
            let (first, second) = (2.0 * middle[index] - coarse[index], 2.0 * fine[index] - middle[index]);
            (4.0 * second - first) / 3.0
        })
        .collect()
}

#[test]
fn an_elastic_wave_with_hysteresis_is_the_closed_form() {
    // The glassy contact as well: m = β far above all times.
    let (elastic, stiff) = (PlaneMaterial::elastic(3.7e5).unwrap(), PlaneMaterial::standard_solid(RELAXED, 6.0 * RELAXED, 1.0).unwrap());
    for (name, material, modulus, rate) in [("elastic", &elastic, 1.0, 0.4), ("glassy", &stiff, 6.0, 1e9)] {
        for (trailing, leading, pressure) in [(0.006, 0.0015, 0.1), (0.002, 0.004, 0.2), (0.004, 0.004, 0.15), (0.008, 2e-5, 0.12)] {
            let found = at_vanishing_zone(|zone| {
                let adhesion = uneven(trailing * modulus, leading * modulus, zone);
                let values = partial(material, &problem(adhesion, rate, SlidingControl::MeanPressure(pressure * modulus))).values;
                vec![values.half_width.value, values.eccentricity.value, values.friction_stress.value / modulus]
            });
            let (half_width, eccentricity) = closed_form(trailing, leading, 1.0, pressure);
            println!(
                "{name} {trailing} {leading}: a off by {:.1e}, e by {:.1e}, friction by {:.1e}",
                found[0] - half_width,
                found[1] - eccentricity,
                found[2] - (trailing - leading)
            );
            // What is left of order δ³ (and, glassy, 1/ζ): 1e-9 is the fourth power of the largest zone over a contact of one.
            let tolerance = 2e-8;
            assert!(
                (found[0] - half_width).abs() < tolerance && (found[1] - eccentricity).abs() < tolerance,
                "{name} {trailing} {leading}"
            );
            // (Δγ₁ − Δγ₂)/λ: what hysteresis takes, and nothing else, in the units of Γ.
            assert!((found[2] - (trailing - leading)).abs() < tolerance, "{name} {trailing} {leading}: friction {}", found[2]);
        }
    }
}

#[test]
fn hysteresis_is_all_the_friction_of_an_elastic_contact() {
    let elastic = PlaneMaterial::elastic(3.7e5).unwrap();
    for control in [SlidingControl::MeanPressure(0.1), SlidingControl::Penetration(0.35), SlidingControl::HalfWidth(0.9)] {
        for zone in [1e-3, 1e-2] {
            let found = partial(&elastic, &problem(uneven(0.006, 0.0015, zone), 3.0, control));
            let adhesive = found.values.adhesion.unwrap();
            // With a finite move nothing is lost either: all work of the interface is stored.
            for release in [adhesive.trailing_release, adhesive.leading_release] {
                assert!((release.value - 1.0).abs() <= release.error + 1e-12 && release.error < 1e-8);
            }
            let edges = adhesive.adhesive_friction_stress;
            assert!((edges.value - 0.0045).abs() <= edges.error + 1e-15);
            // The force itself is the difference of both release rates at the edges as they are, K²/2E*, exactly.
            let (behind, ahead) = found.state.edge_amplitudes();
            let rates = (behind * behind - ahead * ahead) / (8.0 * found.values.half_width.value.sin());
            let friction = found.values.friction_stress;
            assert!((friction.value - rates).abs() < 1e-13, "{} {rates}", friction.value);
            // Both differ by the process zone.
            assert!((friction.value - 0.0045).abs() < 4.0 * zone * 0.0045 + friction.error, "{} at {zone}", friction.value);
            assert!(found.values.eccentricity.value < 0.0);
        }
    }
}

#[test]
fn a_vanishing_leading_work_leaves_the_smooth_leading_edge() {
    // Closing gives nothing back: the leading amplitude vanishes as the root of its work.
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    let amplitude = |leading: f64| {
        let found = partial(&elastic, &problem(uneven(0.004, leading, 1e-5), 1.0, SlidingControl::HalfWidth(0.9)));
        found.state.edge_amplitudes()
    };
    let (first, second) = (amplitude(1e-6), amplitude(1e-8));
    for (trailing, leading, work) in [(first.0, first.1, 1e-6_f64), (second.0, second.1, 1e-8)] {
        assert!((trailing + (8.0 * 0.004 * 0.9_f64.sin()).sqrt()).abs() < 1e-4);
        assert!((leading / -(8.0 * work * 0.9_f64.sin()).sqrt() - 1.0).abs() < 0.05, "{leading}");
    }
}

#[test]
fn a_cylinder_of_two_works_is_the_narrow_wave() {
    // Load of equal works with the same mean root, and e = (√Γ₂ − √Γ₁)/√(ma/2), at vanishing process zone.
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    let (trailing, leading, half_width) = (0.02, 0.005, 0.8_f64);
    let found = at_vanishing_zone(|zone| {
        let control = SlidingControl::HalfWidth(half_width);
        let found = SlidingProblem { indenter: Indenter::Parabola, ..problem(uneven(trailing, leading, zone), 1.0, control) };
        let values = partial(&elastic, &found).values;
        vec![values.mean_pressure.value, values.eccentricity.value, values.friction_stress.value]
    });
    let pull = (trailing.sqrt() + leading.sqrt()) * (0.5 * half_width).sqrt();
    assert!((found[0] - (0.25 * half_width * half_width - pull)).abs() < 1e-8, "{}", found[0]);
    assert!((found[1] - (leading.sqrt() - trailing.sqrt()) / (0.5 * half_width).sqrt()).abs() < 1e-8, "{}", found[1]);
    assert!((found[2] - (trailing - leading)).abs() < 1e-8, "{}", found[2]);
}

const THREE: [(f64, f64); 3] = [(0.4, 3.0), (0.3, 0.4), (0.2, 0.01)];

fn assert_meets(what: &str, found: &PartialValues, expected: &PartialValues) {
    for (name, one, two) in [
        ("a", found.half_width, expected.half_width),
        ("e", found.eccentricity, expected.eccentricity),
        ("Δ", found.penetration, expected.penetration),
        ("p̄", found.mean_pressure, expected.mean_pressure),
        ("friction", found.friction_stress, expected.friction_stress),
    ] {
        assert!((one.value - two.value).abs() <= one.error + two.error + 1e-13, "{what}, {name}: {one:?} {two:?}");
    }
}

#[test]
fn a_contact_has_the_works_of_its_speed() {
    let material = of_terms(&THREE);
    let entry = |speed: f64, trailing: f64, leading: f64| WorkAtSpeed { speed, trailing, leading };
    let laws = [
        WorkBySpeed::power(2.0, 0.5).unwrap(),
        WorkBySpeed::table(&[entry(1e-3, 1.0, 1.0), entry(1.0, 2.5, 0.8), entry(1e4, 4.0, 0.9)]).unwrap(),
    ];
    for law in &laws {
        for rate in [3e-3, 0.4, 30.0, 4e3] {
            for control in [SlidingControl::MeanPressure(0.12), SlidingControl::Penetration(0.3), SlidingControl::HalfWidth(0.7)] {
                let [trailing, leading] = law.factors(rate);
                let constant = problem(uneven(0.002 * trailing, 0.0015 * leading, 4e-3), rate, control);
                let followed = SlidingProblem { work_by_speed: Some(law), ..constant };
                match (steady_sliding(&material, &constant), steady_sliding(&material, &followed)) {
                    (Ok(SlidingOutcome::Partial(one)), Ok(SlidingOutcome::Partial(two))) => {
                        assert_meets(&format!("{rate} {control:?}"), &two.values, &one.values);
                    }
                    (Ok(SlidingOutcome::Full(_)), Ok(SlidingOutcome::Full(_))) => {}
                    (one, two) => panic!("{rate} {control:?}: {:?} {:?}", one.err(), two.err()),
                }
            }
        }
    }
}

#[test]
fn a_law_that_says_nothing_changes_nothing() {
    let material = of_terms(&THREE);
    let entry = |speed: f64| WorkAtSpeed { speed, trailing: 1.0, leading: 1.0 };
    let law = WorkBySpeed::table(&[entry(1e-3), entry(10.0)]).unwrap();
    let plain = problem(WaveAdhesion::even(0.003, 5e-3), 0.3, SlidingControl::MeanPressure(0.1));
    let (one, two) = (partial(&material, &plain), partial(&material, &SlidingProblem { work_by_speed: Some(&law), ..plain }));
    assert_eq!(one.values, two.values);
    let branch =
        BranchProblem { points: 9, ..BranchProblem::speeds(plain.control, [1e-3, 1e3], BranchStart::Slow, plain.adhesion.unwrap(), 1e-9) };
    let followed = BranchProblem { work_by_speed: Some(&law), ..branch };
    let (one, two) = (trace(&material, &branch).unwrap(), trace(&material, &followed).unwrap());
    assert_eq!(one.outline(), two.outline());
}

/// What follows the speed is what follows the times, and the works by the slope of the law.
#[test]
fn contacts_follow_the_slope_of_the_law() {
    let material = of_terms(&THREE);
    let law = WorkBySpeed::power(2.0, 0.5).unwrap();
    let adhesion_at = |rate: f64| WaveAdhesion::even(0.002, 4e-3).with_works_times(law.factors(rate));
    let at = |rate: f64| {
        let given = problem(adhesion_at(0.4), 0.4, SlidingControl::MeanPressure(0.12));
        // The contact at another speed than the one at which the works are given.
        let adhesion = adhesion_at(rate);
        partial(&material, &SlidingProblem { rate, adhesion: Some(adhesion), work_by_speed: Some(&law), ..given }).values
    };
    let base = problem(adhesion_at(0.4), 0.4, SlidingControl::MeanPressure(0.12));
    let found = state_sensitivities(&material, &base, &at(0.4)).unwrap();
    let step = 0.01_f64;
    let (one, two) = (at(0.4 * step.exp()), at(0.4 * (-step).exp()));
    let (far, near) = (at(0.4 * (2.0 * step).exp()), at(0.4 * (-2.0 * step).exp()));
    // d ln(1 + √x)/d ln x = ½√x/(1 + √x).
    let root = (0.4_f64 / 2.0).sqrt();
    let slope = 0.5 * root / (1.0 + root);
    for (name, set, of) in [
        ("half-width", found.half_width, (|values| values.half_width.value) as fn(&PartialValues) -> f64),
        ("friction", found.friction_stress, |values| values.friction_stress.value),
    ] {
        let [_, by_work, .., by_time] = set.map(|value| value.unwrap().value);
        let narrow = (of(&one).ln() - of(&two).ln()) / (2.0 * step);
        let wide = (of(&far).ln() - of(&near).ln()) / (4.0 * step);
        let expected = (4.0 * narrow - wide) / 3.0;
        println!("{name}: {} by differences {expected}", by_time + slope * by_work);
        assert!((by_time + slope * by_work - expected).abs() < 1e-7, "{name}");
    }
}

/// Along speeds the works go with them; where the curve turns, one of constant works turns as well.
#[test]
fn a_branch_of_speeds_follows_the_law() {
    let material = PlaneMaterial::standard_solid(RELAXED, 100.0 * RELAXED, 1.0).unwrap();
    let law = WorkBySpeed::power(1e-3, 0.3).unwrap();
    let adhesion = uneven(0.002, 0.0015, 0.01);
    let control = SlidingControl::MeanPressure(0.05);
    let base = BranchProblem { points: 14, ..BranchProblem::speeds(control, [1e-5, 1e2], BranchStart::Slow, adhesion, 1e-9) };
    let problem = BranchProblem { work_by_speed: Some(&law), ..base };
    let branch = trace(&material, &problem).unwrap();
    let given = law.factors(problem.rate);
    let works = |rate: f64| {
        let [trailing, leading] = law.factors(rate);
        uneven(0.002 * (trailing / given[0]), 0.0015 * (leading / given[1]), 0.01)
    };
    assert!(branch.points.len() >= 12, "{:?}", branch.left_out);
    let mut fastest = 0.0_f64;
    for point in &branch.points {
        let rate = point.parameter.value;
        fastest = fastest.max(rate);
        // The same half-width at that speed with constant works needs the same load.
        let near = BranchProblem {
            start: BranchStart::Near {
                half_width: point.values.half_width.value,
                eccentricity: point.values.eccentricity.value,
                mean_pressure: point.values.mean_pressure.value,
                parameter: 1.0,
            },
            ..BranchProblem::loads(rate, works(rate), 1e-9)
        };
        let half_width = point.values.half_width.value;
        let alone = BranchProblem { half_widths: [half_width - 1e-3, half_width + 1e-3], points: 1, ..near };
        let found = trace(&material, &alone).unwrap();
        let outline = found.outline();
        let closest = outline.iter().min_by(|one, two| (one[0] - half_width).abs().total_cmp(&(two[0] - half_width).abs())).unwrap();
        assert!((closest[2] - 0.05).abs() < 1e-6 + 3.0 * (closest[0] - half_width).abs(), "{rate}: {closest:?}");
    }
    let fold = branch.folds_of(FoldQuantity::LogRate).next().unwrap();
    let at_fold = fold.parameter();
    assert!(fastest <= at_fold.value + at_fold.error && fastest > 0.5 * at_fold.value, "{fastest} {at_fold:?}");
    // A curve turns in speed where the conditions at fixed speed become singular: at the works of that speed, whatever they do elsewhere.
    let held = BranchProblem { adhesion: works(at_fold.value), ..base };
    let other = trace(&material, &held).unwrap();
    let at_another = other.folds_of(FoldQuantity::LogRate).next().unwrap().parameter();
    println!("fold at {at_fold:?}, with works held at {at_another:?}");
    assert!((at_another.value - at_fold.value).abs() <= at_another.error + at_fold.error + 1e-12 * at_fold.value);
    assert!(at_fold.error < 1e-7 * at_fold.value, "{at_fold:?}");
    // Without the law it turns elsewhere, or not at all.
    let constant = trace(&material, &base).unwrap();
    let unlike = constant.folds_of(FoldQuantity::LogRate).next().map(|fold| fold.parameter().value);
    assert!(unlike.is_none_or(|rate| (rate / at_fold.value - 1.0).abs() > 0.1), "{unlike:?}");
    // The contact at the fold is one of constant works there.
    let near = problem_near(&fold.contact, works(at_fold.value), at_fold.value);
    let found = viscotack::sliding::steady::steady_sliding_near(
        &material,
        &near,
        &viscotack::sliding::steady::Start::at(0.05, fold.contact.eccentricity.value),
    )
    .unwrap();
    assert!((found.values.mean_pressure.value - 0.05).abs() < 1e-8, "{:?}", found.values.mean_pressure);
}

fn problem_near(contact: &PartialValues, adhesion: WaveAdhesion, rate: f64) -> SlidingProblem<'static> {
    SlidingProblem { accuracy: 1e-10, ..problem(adhesion, rate, SlidingControl::HalfWidth(contact.half_width.value)) }
}

/// Pull-off, snap-in and stability with two works: where the signs change is where the curve turns; elastic limits in closed form.
#[test]
fn branches_of_two_works_turn_where_the_closed_form_does() {
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    let (trailing, leading) = (0.006_f64, 0.002_f64);
    let load = |a: f64| {
        let (s, c) = (0.5 * a).sin_cos();
        let lag = (leading.sqrt() - trailing.sqrt()) / (s * c.powi(3)).sqrt();
        if lag.abs() >= 1.0 { f64::NAN } else { (1.0 - lag * lag).sqrt() * s * s - (trailing.sqrt() + leading.sqrt()) * (s / c).sqrt() }
    };
    let samples: Vec<f64> = (1..400_000).map(|index| PI * f64::from(index) / 400_000.0).map(load).filter(|load| load.is_finite()).collect();
    let turn = |index: usize| samples[index];
    let smallest = (1..samples.len() - 1).find(|&index| turn(index) < turn(index - 1) && turn(index) < turn(index + 1)).map(turn).unwrap();
    let largest =
        (1..samples.len() - 1).rev().find(|&index| turn(index) > turn(index - 1) && turn(index) > turn(index + 1)).map(turn).unwrap();
    let found = at_vanishing_zone(|zone| {
        let found = strength(&elastic, &BranchProblem::loads(0.5, uneven(trailing, leading, zone), 1e-10)).unwrap();
        let (pull_off, snap_in) = (found.pull_off.unwrap(), found.snap_in.unwrap());
        assert!(pull_off.borders_stable && snap_in.borders_stable);
        vec![pull_off.value.value, snap_in.value.value]
    });
    println!("pull-off {} against {smallest}, snap-in {} against {largest}", found[0], found[1]);
    assert!((found[0] - smallest).abs() < 1e-8 && (found[1] - largest).abs() < 1e-8);
}
