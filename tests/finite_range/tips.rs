//! Tips other than the sphere, with a law of attraction of finite range: flat punches, rims, tables, sharp power laws.
//!
//! Source: Maugis (1992), 10.1016/0021-9797(92)90285-T, eqs. for a cohesive zone of constant stress, of which the flat punch is the case of no
//! curvature; Kendall (1971), 10.1088/0022-3727/4/8/320, the pull-off of a flat punch; Sneddon (1965) for power laws; Boltzmann's integral for a
//! contact of fixed radius.
//! Goal: forces and contact radii of a punch, its pull-off between the rigid and the short-ranged limit, and a fixed contact in time; a shape given in
//! two ways.
//! Parameters: Tabor numbers 0.01 to 5, hard walls and Lennard-Jones.
//! Oracle: as under Source; the same shape by another way.
//! Tolerance: the accuracy of the run; limits by their distance.
#![allow(clippy::unwrap_used, missing_docs)]

use std::f64::consts::PI;
use std::sync::Arc;
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::sphere::{Accuracy, Control, Creep, Leg, Mesher, Motion, Problem, Run, Shape, Start, run};
use viscotack::indentation::TabulatedShape;

fn solved(problem: &Problem, relative: f64) -> Run {
    let law = Attraction::new(problem.law.clone(), 1.0, 1.0).unwrap();
    let accuracy = Accuracy::of_law(relative, &law);
    run(problem, accuracy, &mut Mesher::new(accuracy.order)).unwrap()
}

fn elastic() -> Creep {
    Creep { stiffening: 1.0, fractions: Vec::new(), times: Vec::new() }
}

fn moved(law: Law, tabor: f64, from: f64, to: f64) -> Problem {
    let legs = vec![Leg { control: Control::Penetration, motion: Motion::Ramp { to, duration: (from - to).abs() } }];
    Problem::new(law, tabor, elastic(), Start::Relaxed(from), legs)
}

fn punch(law: Law, tabor: f64, rim: f64, from: f64, to: f64) -> Problem {
    Problem { shape: Shape::Flat, rim: Some(rim), ..moved(law, tabor, from, to) }
}

#[test]
fn a_punch_with_constant_tension_peels_as_the_closed_form_says() {
    // c from Δ = −2mσ√(a² − c²); F = −2σ(c√(a² − c²) + a² arccos(c/a)) as long as the gap at the rim is within the constant part of the law.
    let (tabor, rim) = (0.45_f64, 5.0_f64);
    let m = tabor.powf(1.5);
    let mut problem = punch(Law::Dugdale { ramp: 0.1 }, tabor, rim, 1.0, -2.4);
    problem.instants = vec![0.5, 1.6, 2.2, 2.8, 3.3];
    let done = solved(&problem, 1e-4);
    for time in &problem.instants {
        let row = done.at(*time).unwrap();
        let depth = row.penetration;
        if depth > 0.0 {
            let expected = 2.0 * rim * depth / m;
            assert!((row.force / expected - 1.0).abs() < 1e-3, "{} {expected}", row.force);
            continue;
        }
        let root = -depth / (2.0 * m);
        let contact = (rim * rim - root * root).sqrt();
        let angle = (contact / rim).acos();
        let gap = 4.0 * m / PI * (root * angle - rim + contact);
        assert!(gap < 0.9, "{gap}");
        let force = -2.0 * (contact * root + rim * rim * angle);
        assert!((row.force / force - 1.0).abs() < 2e-4, "{depth}: {} {force}", row.force);
        assert!((row.contact_radius / contact - 1.0).abs() < 2e-3, "{depth}: {} {contact}", row.contact_radius);
    }
}

/// The force at which the gap at the rim of a punch with constant tension has a value.
fn force_at_gap(m: f64, rim: f64, gap: f64) -> f64 {
    let opening = |contact: f64| {
        let root = (rim * rim - contact * contact).sqrt();
        4.0 * m / PI * (root * (contact / rim).acos() - rim + contact)
    };
    let (mut low, mut high) = (0.0, rim);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if opening(middle) > gap { low = middle } else { high = middle }
    }
    2.0 * (low * (rim * rim - low * low).sqrt() + rim * rim * (low / rim).acos())
}

#[test]
fn a_punch_with_constant_tension_leaves_when_its_rim_is_out_of_range() {
    let (rim, ramp) = (8.0, 0.05);
    for tabor in [0.7_f64, 1.5, 3.0] {
        let m = tabor.powf(1.5);
        let done = solved(&punch(Law::Dugdale { ramp }, tabor, rim, 0.5, -40.0), 1e-3);
        // At the largest force the gap at the rim is on the ramp.
        let [least, most] = [1.0 - ramp, 1.0 + ramp].map(|gap| force_at_gap(m, rim, gap));
        let force = done.pull_off_force();
        assert!(force > least * (1.0 - 1e-3) && force < most * (1.0 + 1e-3), "{tabor}: {least} {force} {most}");
    }
}

#[test]
fn the_pull_off_of_a_punch_lies_between_its_limits() {
    let rim = 20.0;
    let pull_off = |tabor: f64, to: f64| solved(&punch(Law::LennardJones, tabor, rim, 0.5, to), 1e-4).pull_off_force();
    let rigid = PI * rim * rim * 16.0 / (9.0 * 3.0_f64.sqrt());
    assert!((pull_off(0.01, -3.0) / rigid - 1.0).abs() < 2e-3);
    // What the law pulls with beyond the gap at the rim is missing, ever less.
    let shortfall = |tabor: f64| 1.0 - pull_off(tabor, -60.0 * tabor.powf(1.5)) / (8.0 * PI * (rim / tabor.sqrt()).powi(3)).sqrt();
    let shortfalls = [1.25, 2.5, 5.0].map(shortfall);
    assert!(shortfalls.windows(2).all(|pair| pair[1] > 0.0 && pair[1] < 0.7 * pair[0]) && shortfalls[2] < 0.05, "{shortfalls:?}");
}

#[test]
fn a_punch_that_stays_in_contact_follows_boltzmann() {
    // E(t) = 1 + (β − 1)e^{−βt} for one Voigt term of time 1; a step to a depth at once, then a ramp.
    let (tabor, rim, stiffening, depth, speed) = (0.8_f64, 3.0, 20.0, 1.0, 4.0);
    let legs = vec![Leg { control: Control::Penetration, motion: Motion::Ramp { to: depth + speed, duration: 1.0 } }];
    let creep = Creep { stiffening, fractions: vec![1.0], times: vec![1.0] };
    let base = Problem::new(Law::Dugdale { ramp: 0.2 }, tabor, creep, Start::Unstrained(depth), legs);
    let problem = Problem { shape: Shape::Flat, rim: Some(rim), instants: vec![0.02, 0.1, 0.5], ..base };
    let done = solved(&problem, 1e-3);
    for time in [0.0_f64, 0.02, 0.1, 0.5, 1.0] {
        let decay = (-stiffening * time).exp();
        let relaxed = 1.0 + (stiffening - 1.0) * decay;
        let ramp = time + (stiffening - 1.0) / stiffening * (1.0 - decay);
        let expected = 2.0 * rim / tabor.powf(1.5) * (depth * relaxed + speed * ramp);
        let force = done.at(time).unwrap().force;
        assert!((force / expected - 1.0).abs() < 1e-3, "{time}: {force} {expected}");
    }
}

#[test]
fn a_sphere_by_a_table_or_with_a_far_rim_is_the_sphere() {
    let mut problem = moved(Law::LennardJones, 2.0, 10.0, -12.0);
    problem.instants = vec![5.0, 10.0, 15.0];
    let sphere = solved(&problem, 1e-5);
    let points: Vec<(f64, f64)> = (0..41).map(f64::from).map(|x| (x, 0.5 * x * x)).collect();
    let table = Shape::Table(Arc::new(TabulatedShape::through(&points).unwrap()));
    let others = [
        (Problem { shape: table, ..problem.clone() }, "table"),
        (Problem { shape: Shape::Power { coefficient: 0.5, exponent: 2.0 }, ..problem.clone() }, "power law"),
        (Problem { rim: Some(60.0), ..problem.clone() }, "rim within the mesh"),
        (Problem { rim: Some(400.0), ..problem.clone() }, "rim beyond the mesh"),
    ];
    for (other, name) in others {
        let done = solved(&other, 1e-5);
        assert!((done.pull_off_force() / sphere.pull_off_force() - 1.0).abs() < 2e-5, "{name}");
        for time in &problem.instants {
            let [a, b] = [&sphere, &done].map(|run| run.at(*time).unwrap());
            assert!((a.force - b.force).abs() < 5e-5 * (1.0 + a.force.abs()), "{name}: {} {}", a.force, b.force);
            assert!((a.contact_radius - b.contact_radius).abs() < 5e-5 * (1.0 + a.contact_radius), "{name}");
        }
    }
}

#[test]
fn a_rim_stops_the_growth_of_a_contact() {
    // Pressed until the face touches out to its rim, a sphere is a spring of the stiffness 2a/m.
    let (tabor, rim) = (1.0, 4.0);
    let mut problem = Problem { rim: Some(rim), ..moved(Law::LennardJones, tabor, 10.0, 40.0) };
    problem.instants = vec![20.0, 25.0];
    let done = solved(&problem, 1e-4);
    let [one, other] = [20.0, 25.0].map(|time| done.at(time).unwrap());
    assert!((one.contact_radius - rim).abs() < 1e-9 && (other.contact_radius - rim).abs() < 1e-9);
    let stiffness = (other.force - one.force) / (other.penetration - one.penetration);
    assert!((stiffness / (2.0 * rim) - 1.0).abs() < 1e-2, "{stiffness}");
    // F = 2(aΔ − ∫f)/m with f = s², but for the small gap of the law.
    let expected = 2.0 * (rim * other.penetration - rim.powi(3) / 3.0);
    assert!((other.force / expected - 1.0).abs() < 2e-2, "{} {expected}", other.force);
}

#[test]
fn sharp_power_laws_carry_what_sneddon_says() {
    for exponent in [0.6_f64, 0.8] {
        let shape = Shape::Power { coefficient: 40.0, exponent };
        let problem = Problem { shape, ..moved(Law::LennardJones, 0.1, 1000.0, 2000.0) };
        let done = solved(&problem, 1e-4);
        let gamma = |x: f64| spec_math::Gamma::gamma(&x);
        let factor = 40.0 * PI.sqrt() * gamma(0.5 * exponent + 1.0) / gamma(0.5 * exponent + 0.5);
        let last = done.rows.last().unwrap();
        let radius = (last.penetration / factor).powf(1.0 / exponent);
        let force = 2.0 * exponent / (exponent + 1.0) * radius * last.penetration / 0.1_f64.powf(1.5);
        assert!((last.force / force - 1.0).abs() < 1e-2, "{exponent}: {} {force}", last.force);
        assert!(done.certificate.energy_residual < 1e-3 * done.certificate.energy_scale);
    }
}

#[test]
fn tips_that_cannot_be_are_refused() {
    let base = moved(Law::LennardJones, 1.0, 1.0, -5.0);
    assert!(Problem { shape: Shape::Flat, ..base.clone() }.check().is_err());
    assert!(Problem { rim: Some(0.0), ..base.clone() }.check().is_err());
    assert!(Problem { shape: Shape::Power { coefficient: 1.0, exponent: 0.5 }, ..base.clone() }.check().is_err());
    let points = [(0.0, 0.0), (1.0, 0.5), (2.0, 2.0), (3.0, 4.5)];
    let table = Shape::Table(Arc::new(TabulatedShape::through(&points).unwrap()));
    assert!(Problem { shape: table.clone(), rim: Some(3.5), ..base.clone() }.check().is_err());
    // The contact grows beyond the last point.
    let accuracy = Accuracy::new(1e-3);
    let deep = Problem { shape: table, ..moved(Law::LennardJones, 1.0, 1.0, 30.0) };
    let refusal = run(&deep, accuracy, &mut Mesher::new(accuracy.order)).unwrap_err();
    assert!(refusal.to_string().contains("last point"), "{refusal}");
}
