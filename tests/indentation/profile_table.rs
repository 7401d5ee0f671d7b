//! Indenters given by points.
//!
//! Source: Sneddon 1965, f(s) = s∫₀^s z′(r)/√(s² − r²) dr; `reference_data/indentation_shape.csv` (mpmath, closed form at 60 and quadrature at 42 digits).
//! Goal: the line profile of the cubic through given points, its slope; convergence to the line profile of the shape that was sampled; contacts; refusals.
//! Parameters: even and uneven points, a sharp tip, a worn flat; paraboloid, cone, power 2.7, sphere, with 9 to 129 points.
//! Oracle: mpmath; f = s²/R, (π/2)·slope·s, the Beta function for a power, (s/2)ln((R + s)/(R − s)) for a sphere; the integration of the paraboloid itself.
//! Tolerance: 1e-12 for what rounding alone limits; for sampled shapes what the number of points leaves, stated with each.
#![allow(clippy::expect_used, clippy::unwrap_used, clippy::panic, clippy::float_cmp, missing_docs)]

use crate::support;

use std::f64::consts::{FRAC_PI_2, PI};
use support::indentation::{SPHERE, WORK, ZONE, rubber};
use support::reference_rows;
use viscotack::Refusal;
use viscotack::indentation::{
    Adhesion, History, IndentationProblem, Panel, Profile, Zone, elastic_contact, elastic_contact_of_radius, integrate, zone_work,
};

fn sampled(points: usize, end: f64, z: impl Fn(f64) -> f64) -> Profile {
    let last = points - 1;
    let points: Vec<(f64, f64)> = (0..points).map(|k| end * k as f64 / last as f64).map(|r| (r, z(r))).collect();
    Profile::table(&points).unwrap()
}

/// Largest errors of f over f(end) and of f′ over f′(end), at places that are no points.
fn errors(profile: &Profile, end: f64, line: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> [f64; 2] {
    let places = (1..=1000).map(|k| end * f64::from(k) / 1000.0);
    places.fold([0.0, 0.0], |[f, g], s| {
        let (off, tilt) = ((profile.line(s) - line(s)).abs() / line(end), (profile.line_slope(s) - slope(s)).abs() / slope(end));
        [f.max(off), g.max(tilt)]
    })
}

/// 1e-13 of f, and of f′ against f′ or f/s, whichever is larger: sums of some 1e2 numbers.
#[test]
fn line_profile_of_given_points() {
    let rows = reference_rows("indentation_shape.csv");
    let mut worst = [0.0f64; 2];
    for row in &rows {
        assert!(row.number("confirmed_digits") >= 20.0);
        let points: Vec<(f64, f64)> = row
            .text("points")
            .split(';')
            .map(|pair| pair.split_once(',').map(|(r, z)| (r.parse().unwrap(), z.parse().unwrap())).unwrap())
            .collect();
        let profile = Profile::table(&points).unwrap();
        let (s, line, slope) = (row.number("place"), row.number("line"), row.number("line_slope"));
        let off = [(profile.line(s) / line - 1.0).abs(), (profile.line_slope(s) - slope).abs() / slope.abs().max(line / s)];
        if off[0].max(off[1]) > 1e-14 {
            println!("{} {s:e}: {off:?}", row.text("case"));
        }
        worst = [worst[0].max(off[0]), worst[1].max(off[1])];
    }
    println!("{} values of f and f′, worst {worst:?}", 2 * rows.len());
    assert!(rows.len() > 70 && worst[0] < 1e-13 && worst[1] < 1e-13, "{worst:?}");
}

/// Paraboloids and cones are cubics: rounding only, whatever the points. 1e-13 of f; of f′ 1e-12, because it holds z″, a second difference of the
/// heights, whose rounding grows with the number of points.
#[test]
fn paraboloid_and_cone_are_reproduced() {
    for points in [5, 9, 65] {
        let off = errors(&sampled(points, 0.7, |r| 0.5 * r * r / 3.0), 0.7, |s| s * s / 3.0, |s| 2.0 * s / 3.0);
        let other = errors(&sampled(points, 0.7, |r| 0.2 * r), 0.7, |s| FRAC_PI_2 * 0.2 * s, |_| FRAC_PI_2 * 0.2);
        println!("{points} points: paraboloid {off:?} cone {other:?}");
        assert!(off[0].max(other[0]) < 1e-13 && off[1].max(other[1]) < 1e-12);
    }
}

/// z′ of the spline is off by h³, and the root in the integral sees half a piece more: f is off by h^3.5, f′ by h^2.5 (a sphere to half of its radius).
/// A power m = 2.7 is no cubic at its tip: f is off by h^2.7, f′ by h^1.7. The orders of the two finest tables, less 0.2.
#[test]
fn sphere_and_power_converge() {
    let exact = |s: f64| 0.5 * s * ((1.0 + s) / (1.0 - s)).ln();
    let slope = |s: f64| 0.5 * ((1.0 + s) / (1.0 - s)).ln() + s / (1.0 - s * s);
    // f = s^m m ∫₀¹ x^{m−1}/√(1 − x²) dx of z = r^m, m = 2.7: m (√π/2) Γ(1.35)/Γ(1.85).
    let factor = 2.7 * 0.5 * PI.sqrt() * 0.891_151_441_945_156_6 / 0.945_611_177_846_806_2;
    let mut before: Option<[f64; 4]> = None;
    let (mut last, mut order) = ([0.0; 4], [0.0; 4]);
    for points in [9, 17, 33, 65, 129] {
        let sphere = errors(&sampled(points, 0.5, |r| r * r / (1.0 + (1.0 - r * r).sqrt())), 0.5, exact, slope);
        let power = errors(&sampled(points, 1.0, |r| r.powf(2.7)), 1.0, |s| factor * s.powf(2.7), |s| 2.7 * factor * s.powf(1.7));
        last = [sphere[0], sphere[1], power[0], power[1]];
        let orders = before.map(|before| [0, 1, 2, 3].map(|k| (before[k] / last[k]).log2()));
        println!(
            "{points:4} points: sphere f {:.1e} f′ {:.1e}, power f {:.1e} f′ {:.1e}; orders {orders:.2?}",
            last[0], last[1], last[2], last[3]
        );
        order = orders.unwrap_or_default();
        before = Some(last);
    }
    assert!(order.iter().zip([3.5, 2.5, 2.7, 1.7]).all(|(found, expected)| *found > expected - 0.2), "{order:?}");
    assert!(last[0] < 2e-8 && last[1] < 5e-6 && last[2] < 2e-7 && last[3] < 1e-5, "{last:?}");
}

/// Forces of the paraboloid and of its points: one path, the same steps; 1e-9 of the largest force, what roots of the closure leave.
#[test]
fn an_integration_with_points_is_that_of_the_paraboloid() {
    let table = sampled(41, 0.6, |r| 0.5 * r * r);
    for adhesion in [Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE }), None] {
        let integrated = |profile: Profile| {
            let history = History::penetration(0.0).ramp(0.02, 1.0).hold(1.0).ramp(-0.03, 2.0);
            let problem = IndentationProblem { instants_per_segment: 5, ..IndentationProblem::new(profile, adhesion, history) };
            integrate(&rubber(), &problem, 1e-5).unwrap()
        };
        let (own, other) = (integrated(SPHERE), integrated(table.clone()));
        let largest = own.path.iter().fold(0.0f64, |most, point| most.max(point.force.abs()));
        let mut worst: f64 = 0.0;
        for (first, second) in own.kept.iter().zip(&other.kept) {
            worst = worst.max((own.path[*first].force - other.path[*second].force).abs() / largest);
        }
        println!(
            "adhesion {}: {} and {} steps, largest panels {} {}, worst force {worst:.1e}",
            adhesion.is_some(),
            own.work.steps,
            other.work.steps,
            own.work.most_panels,
            other.work.most_panels
        );
        assert_eq!(own.kept.len(), other.kept.len());
        assert!(own.kept.len() >= 15 && worst < 1e-6, "{worst:e}");
    }
}

/// The elastic adhesive contact of a sphere's own shape against one that does not know of points: JKR's with f = (s/2)ln((R + s)/(R − s)),
/// F = 2E*[aΔ − ∫f ds], Δ = f(a) − √(2πaΔγ/E*), as δ → 0. It is met with O(δ/a), and by the table of the paraboloid beside its own at equal δ.
#[test]
fn elastic_contact_of_a_sphere_itself() {
    let (a, work): (f64, f64) = (0.35, 1e-3);
    let table = sampled(201, 0.6, |r| r * r / (1.0 + (1.0 - r * r).sqrt()));
    let line = |s: f64| 0.5 * s * ((1.0 + s) / (1.0 - s)).ln();
    // ∫₀^a (s/2) ln((1 + s)/(1 − s)) ds = [a + (a² − 1)/2 ln((1 + a)/(1 − a))]/2.
    let integral = 0.5 * (a + 0.5 * (a * a - 1.0) * ((1.0 + a) / (1.0 - a)).ln());
    let depth = line(a) - (2.0 * PI * a * work).sqrt();
    let force = 2.0 * (a * depth - integral);
    let mut before: Option<f64> = None;
    for zone in [4e-3, 2e-3, 1e-3, 5e-4] {
        let state = elastic_contact_of_radius(&table, 1.0, work, zone, a).unwrap();
        let off = (state.force / force - 1.0).abs();
        println!("δ {zone:e}: F {:.9} against {force:.9}, off {off:.2e}, ratio {:?}", state.force, before.map(|before| before / off));
        if let Some(before) = before {
            // First order in δ, and less of the second: the ratio goes to 2.
            assert!((before / off - 2.0).abs() < 100.0 * zone);
        }
        before = Some(off);
        // At equal δ: the closure and the force of this state with the sphere's own f, which knows no points.
        let height = state.penetration;
        let kernel = Zone::new(a, zone).unwrap();
        let inside: Vec<Panel> =
            (0..20).map(|k| Panel::sampled(a * f64::from(k) / 20.0, a * f64::from(k + 1) / 20.0, |s| height - line(s))).collect();
        let outside = Panel::sampled(a, a + zone, |s| line(s) - height);
        let balance = zone_work(&kernel, &inside, &[outside]) / work - 1.0;
        let own_force = 2.0 * inside.iter().map(Panel::integral).sum::<f64>();
        println!("  with its own f: C/Δγ − 1 = {balance:.1e}, F off {:.1e}", state.force / own_force - 1.0);
        assert!(balance.abs() < 1e-7 && (state.force / own_force - 1.0).abs() < 1e-7);
        let found = elastic_contact(&table, 1.0, work, zone, state.penetration).unwrap();
        assert!((found.contact_radius / a - 1.0).abs() < 1e-9);
    }
    // Equal δ: paraboloid and its points, 1e-10.
    let points = sampled(31, 0.6, |r| 0.5 * r * r);
    let (own, other) =
        (elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.032).unwrap(), elastic_contact(&points, 1.0, WORK, ZONE, 0.032).unwrap());
    println!("point B: a {:.12} {:.12}, F {:.12e} {:.12e}", own.contact_radius, other.contact_radius, own.force, other.force);
    assert!((own.contact_radius / other.contact_radius - 1.0).abs() < 1e-10 && (own.force / other.force - 1.0).abs() < 1e-10);
}

#[test]
fn beyond_the_last_point_is_refused() {
    let table = sampled(41, 0.2, |r| 0.5 * r * r);
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    for adhesion in [adhesion, None] {
        for history in [History::penetration(0.0).ramp(0.2, 1.0), History::force(0.0).ramp(0.5, 1.0)] {
            for relaxed in [false, true] {
                let problem = IndentationProblem::new(table.clone(), adhesion, history.clone());
                let problem = if relaxed { problem.relaxed() } else { problem };
                match integrate(&rubber(), &problem, 1e-3) {
                    Err(Refusal::NoSuchState { limit_name, limit, .. }) => {
                        assert_eq!((limit_name, limit), ("the radius of its last point", 0.2));
                    }
                    other => panic!("{:?}", other.map(|trace| trace.path.len())),
                }
            }
        }
    }
    assert!(matches!(elastic_contact(&table, 1.0, WORK, ZONE, 0.032), Err(Refusal::NoSuchState { .. })));
}

#[test]
fn wrong_points_are_refused() {
    let good = [(0.0, 0.0), (1.0, 1.0), (2.0, 4.0), (3.0, 9.0), (4.0, 16.0)];
    assert!(Profile::table(&good).is_ok());
    let mut worse: Vec<Vec<(f64, f64)>> = vec![Vec::new(), good[..3].to_vec(), vec![(0.0, 0.0); 5]];
    for (index, point) in [
        (0, (0.1, 0.0)),
        (0, (0.0, 0.1)),
        (2, (1.0, 4.0)),
        (2, (2.0, 1.0)),
        (2, (2.0, f64::NAN)),
        (2, (f64::INFINITY, 4.0)),
        (4, (4.0, f64::INFINITY)),
    ] {
        let mut points = good.to_vec();
        points[index] = point;
        worse.push(points);
    }
    worse.push((0..3000).map(|k| (f64::from(k), f64::from(k))).collect());
    worse.push(good.iter().map(|(r, z)| (r * 1e-300, z * 1e300)).collect());
    for points in worse {
        assert!(matches!(Profile::table(&points), Err(Refusal::OutOfRange { .. })), "{points:?}");
    }
    // A step with a plateau: its line profile falls behind the step.
    let plateau: Vec<(f64, f64)> =
        (0..40).map(|k| f64::from(k) * 0.1).map(|r| (r, 1e-3 * r * r + (5.0 * (r - 1.0)).tanh() + 5.0f64.tanh())).collect();
    assert!(matches!(Profile::table(&plateau), Err(Refusal::NoSuchState { .. })));
}

/// Rough tables: heights that rise by noise, of a rough tip, of steps, of a flat with one asperity. Where terms of f′ cancel, its series must be taken to end where
/// rounding begins: 2e-15 of a small difference is never reached, and halving for it fills the memory. Oracle: f by Gauss's rule in θ from point to point, r = s sin θ,
/// of the slopes of the cubic. 1e-12: sums of a few hundred numbers.
#[test]
fn rough_points_end_with_a_shape_or_a_refusal() {
    const NODES: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_3),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
        (0.960_289_856_497_536_2, 0.101_228_536_290_376_3),
    ];
    let (reported, tell) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        let mut seed = 20_261_125_u64;
        let mut drawn = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut shapes, mut refused) = (0, 0);
        for table in 0..200 {
            let count = 4 + (drawn() * 40.0) as usize;
            let (kind, noise) = (table % 4, drawn() * 0.4);
            let (mut r, mut z, mut points) = (0.0, 0.0, vec![(0.0, 0.0)]);
            for k in 1..count {
                let step = if drawn() < 0.2 { 1e-3 } else { 1.0 } * (0.5 + drawn());
                let mean = match kind {
                    0 => r + 0.5 * step,
                    1 => 1.0 + 0.2 * drawn(),
                    2 => {
                        if k % 5 == 0 {
                            3.0
                        } else {
                            1e-3
                        }
                    }
                    _ => {
                        if r < 5.0 {
                            1e-2
                        } else {
                            r
                        }
                    }
                };
                r += step;
                z += step * mean * (1.0 + noise * (drawn() - 0.5));
                points.push((r, z));
            }
            match Profile::table(&points) {
                Ok(profile) => {
                    let Profile::Table(shape) = &profile else { panic!("not a table") };
                    shapes += 1;
                    for _ in 0..5 {
                        let s = r * drawn().max(1e-3);
                        let angle = |r: f64| (r / s).min(1.0).asin();
                        let mut knots: Vec<f64> = points.iter().map(|point| point.0).filter(|r| *r < s).map(angle).collect();
                        knots.push(FRAC_PI_2);
                        let mut sum = 0.0;
                        for pair in knots.windows(2) {
                            for part in 0..8 {
                                let width = (pair[1] - pair[0]) / 8.0;
                                let middle = pair[0] + width * (f64::from(part) + 0.5);
                                for (node, weight) in NODES {
                                    let at = |theta: f64| shape.slope(s * theta.sin());
                                    sum += 0.5 * width * weight * (at(middle + 0.5 * width * node) + at(middle - 0.5 * width * node));
                                }
                            }
                        }
                        assert!(
                            (profile.line(s) - s * sum).abs() < 1e-12 * s * sum.abs(),
                            "{table} {s:e} {:e} {:e}",
                            profile.line(s),
                            s * sum
                        );
                    }
                }
                Err(refusal) => {
                    refused += 1;
                    assert!(matches!(refusal, Refusal::NoSuchState { .. }), "{table}: {refusal}");
                }
            }
        }
        reported.send((shapes, refused)).unwrap();
    });
    let (shapes, refused) = tell.recv_timeout(std::time::Duration::from_secs(120)).expect("a shape does not end, or is wrong");
    println!("{shapes} shapes, {refused} that flatten outwards");
    assert!(shapes > 30 && refused > 10);
}
