//! Source: Sneddon, Int. J. Eng. Sci. 3 (1965) 47; Lee & Radok, J. Appl. Mech. 27 (1960) 438; Ting, J. Appl. Mech. 33 (1966) 845; thesis Eqs 4.19, 4.20.
//!
//! Goal: the line is exact for any number of terms and any history of the edge, re-advancing too.
//!
//! ```text
//! flat punch      a const, Δ steps or ramps:    F = 2a ∫R dΔ
//! cone            a const after a step of Δ:    F = (2/π) R Δ²/slope, Δ = (π/2)·slope·a
//! advancing       Lee–Radok:                    F = ∫R(t − t′) d(4a³/3R)
//! receding        Ting:                         F = ∫₀^{t₁}R(t − t′) d(4a³/3R), t₁ the time at which the advancing edge stood here
//! re-advancing    point by point                Q = ∫R(t − t′) d(W − residual of the first contact)
//! ```
//! Parameters: solids of 1, 3 and 6 terms over 5 decades, in Pa and in MPa; R = 2 mm, a up to 0.2 mm.
//!
//! Oracle: Gauss quadrature of the hereditary integrals with the relaxation function itself, here in the test.
//!
//! Tolerance: 1e-8 of the largest force: the line is exact at its nodes, what remains is interpolation where the edge returns.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack::PlaneMaterial;
use viscotack::indentation::{Contact, History, IndentationProblem, Profile, Springs, Sweep, integrate};
use viscotack::material::{CreepTerm, RelaxationTerm};
use viscotack::special::gauss_legendre::UNIT_RULE_20;

const RADIUS: f64 = 2e-3;
const SPHERE: Profile = Profile::Paraboloid { radius: RADIUS };

fn solids() -> Vec<PlaneMaterial> {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    let creep = |compliance, retardation_time| CreepTerm { compliance, retardation_time };
    vec![
        PlaneMaterial::standard_solid(0.7e6, 9e6, 3.0).unwrap(),
        PlaneMaterial::from_relaxation(1.1, &[term(3.0, 0.02), term(5.0, 0.7), term(0.4, 40.0)]).unwrap(),
        PlaneMaterial::from_creep(
            2e9,
            &[creep(1e-9, 1e-3), creep(3e-10, 2e-2), creep(5e-9, 0.1), creep(1e-10, 0.13), creep(2e-8, 5.0), creep(1e-9, 90.0)],
            None,
        )
        .unwrap(),
    ]
}

/// ∫ f from `low` to `high` with panels graded towards `high`, where R(t − t′) is sharp.
fn integral(low: f64, high: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    if high <= low {
        return 0.0;
    }
    let mut total = 0.0;
    let mut ends = vec![low];
    for k in 1..40 {
        ends.push(high - (high - low) * 0.6f64.powi(k));
    }
    ends.push(high);
    for pair in ends.windows(2) {
        for &(x, w) in UNIT_RULE_20.iter() {
            total += w * (pair[1] - pair[0]) * f(pair[0] + (pair[1] - pair[0]) * x);
        }
    }
    total
}

#[test]
fn flat_punch_steps_and_ramps() {
    for material in solids() {
        let springs = Springs::new(&material).unwrap();
        let a = 3e-4;
        let mut punch = Contact::untouched(&springs, Profile::FlatPunch { radius: a }, a, 1e-6).unwrap();
        let mut time = 0.0;
        for dt in [1e-3, 0.1, 2.0, 30.0] {
            punch = punch.moved(a, 1e-6, dt, Sweep::Linear).unwrap();
            time += dt;
            let exact = 2.0 * a * 1e-6 * material.relaxation(time);
            assert!((punch.force() / exact - 1.0).abs() < 1e-12, "{:e}", punch.force() / exact - 1.0);
        }
        let mut punch = Contact::untouched(&springs, Profile::FlatPunch { radius: a }, a, 0.0).unwrap();
        punch = punch.moved(a, 2e-6, 7.0, Sweep::Linear).unwrap();
        let exact = 2.0 * a * 2e-6 * material.mean_relaxation(7.0).value;
        assert!((punch.force() / exact - 1.0).abs() < 1e-12);
    }
}

/// Sneddon's cone of half angle α to its axis, elastic: Δ = (π/2) a cot α and F = (2/π) E* Δ² tan α; pressed in at once, a viscoelastic one holds F = R(t)·(2/π) Δ² tan α
/// with a at rest. Pressure (E*/2) cot α · acosh(a/r).
#[test]
fn a_cone_is_sneddons() {
    for (modulus, angle) in [(1.3, 1.2_f64), (4.1e6, 1.5)] {
        let slope = 1.0 / angle.tan();
        let springs_of = |material: &PlaneMaterial| Springs::new(material).unwrap();
        let solid = PlaneMaterial::elastic(modulus);
        let elastic = springs_of(&solid.unwrap());
        let a = 2e-4;
        let depth = 0.5 * std::f64::consts::PI * a * slope;
        let cone = Contact::untouched(&elastic, Profile::Cone { slope }, a, depth).unwrap();
        let exact = 2.0 / std::f64::consts::PI * modulus * depth * depth * angle.tan();
        assert!((cone.force() / exact - 1.0).abs() < 1e-12, "{} {exact}", cone.force());
        // Without adhesion the edge carries nothing.
        assert!(cone.stress_intensity_factor().abs() < 1e-12 * modulus * slope * a.sqrt());
        let problem =
            IndentationProblem { accuracy: 1e-8, ..IndentationProblem::new(Profile::Cone { slope }, None, History::penetration(depth)) };
        let trace = integrate(&PlaneMaterial::elastic(modulus).unwrap(), &problem, 1e-6).unwrap();
        let start = trace.path[0];
        assert!((start.contact_radius / a - 1.0).abs() < 1e-12 && (start.force / exact - 1.0).abs() < 1e-12, "{start:?}");
    }
    for material in solids() {
        let springs = Springs::new(&material).unwrap();
        let (slope, a) = (0.2, 2e-4);
        let depth = 0.5 * std::f64::consts::PI * a * slope;
        let mut cone = Contact::untouched(&springs, Profile::Cone { slope }, a, depth).unwrap();
        let mut time = 0.0;
        for dt in [1e-3, 0.1, 2.0, 30.0] {
            cone = cone.moved(a, depth, dt, Sweep::Linear).unwrap();
            time += dt;
            let exact = 2.0 / std::f64::consts::PI * depth * depth / slope * material.relaxation(time);
            assert!((cone.force() / exact - 1.0).abs() < 1e-12, "{:e}", cone.force() / exact - 1.0);
        }
    }
}

/// Advance to a_m in T_1, back to a_r in T_2, hold none, forward to a_m in T_3; the penetration moves linearly as well, in any way.
#[test]
fn any_history_of_the_edge() {
    for material in solids() {
        let springs = Springs::new(&material).unwrap();
        let (a0, a_m, a_r) = (0.02e-3, 0.2e-3, 0.09e-3);
        let depth = [0.0, 2e-5, -1e-5, 1.5e-5];
        let times = [0.0, 1.3, 3.1, 5.5];
        let path = |t: f64, values: &[f64; 4]| {
            let k = (0..2).find(|&k| t < times[k + 1]).unwrap_or(2);
            values[k] + (values[k + 1] - values[k]) * (t - times[k]) / (times[k + 1] - times[k])
        };
        let edges = [a0, a_m, a_r, a_m];
        let mut contact = Contact::untouched(&springs, SPHERE, a0, depth[0]).unwrap();
        let steps = 60;
        for k in 0..3 {
            for i in 1..=steps {
                let t = times[k] + (times[k + 1] - times[k]) * f64::from(i) / f64::from(steps);
                contact =
                    contact.moved(path(t, &edges), path(t, &depth), (times[k + 1] - times[k]) / f64::from(steps), Sweep::Linear).unwrap();
            }
        }
        let end = times[3];
        let rate = |k: usize| (depth[k + 1] - depth[k]) / (times[k + 1] - times[k]);
        let relax = |t: f64| material.relaxation(t);
        // Q(s, t) of a point bonded at t0 with residual surface W_r(t′) = Σ e_j e^{−(t′ − t_e)/τ_j}.
        let load = |s: f64| {
            let f = s * s / RADIUS;
            let crossing = |k: usize| times[k] + (times[k + 1] - times[k]) * (s - edges[k]) / (edges[k + 1] - edges[k]);
            let first = if s <= a0 { 0.0 } else { crossing(0) };
            // Load in the first contact: the jump at its start, then the ramps.
            let first_load = |t: f64| {
                let mut q = relax(t - first) * (path(first, &depth) - f);
                for k in 0..3 {
                    q += integral(times[k].max(first).min(t), times[k + 1].min(t), &|x| relax(t - x) * rate(k));
                }
                q
            };
            if s <= a_r {
                return first_load(end);
            }
            let (off, on) = (crossing(1), crossing(2));
            let strains: Vec<f64> = material
                .creep_terms()
                .iter()
                .map(|term| {
                    let kernel =
                        |x: f64| term.compliance / term.retardation_time * (-(off - x) / term.retardation_time).exp() * first_load(x);
                    // Q is smooth between the corners of its history, and sharp after its jump.
                    let mirror = |low: f64, high: f64| integral(low, high, &|y| kernel(low + high - y));
                    let corner = times[1].max(first);
                    let halves = |low: f64, high: f64| {
                        let m = 0.5 * (low + high);
                        mirror(low, m) + integral(m, high, &kernel)
                    };
                    halves(first, corner) + halves(corner, off)
                })
                .collect();
            let terms = material.creep_terms();
            let residual = |t: f64| strains.iter().zip(terms).map(|(e, term)| e * (-(t - off) / term.retardation_time).exp()).sum::<f64>();
            let residual_rate = |t: f64| {
                strains
                    .iter()
                    .zip(terms)
                    .map(|(e, term)| -e / term.retardation_time * (-(t - off) / term.retardation_time).exp())
                    .sum::<f64>()
            };
            let jump = relax(end - on) * (path(on, &depth) - f - residual(on));
            jump + integral(on, end, &|x| relax(end - x) * (rate(2) - residual_rate(x)))
        };
        let loads = contact.line_load();
        let mut worst: f64 = 0.0;
        let scale = loads.iter().flat_map(|panel| panel.values).fold(0.0f64, |most, value| most.max(value.abs()));
        for s in [0.01, 0.05, 0.085, 0.0905, 0.1, 0.12, 0.15, 0.17, 0.199].map(|s| s * 1e-3) {
            let index = loads.partition_point(|panel| panel.upper < s);
            worst = worst.max((loads[index].at(s) - load(s)).abs() / scale);
        }
        println!("{} terms: re-advanced line load, worst {worst:e}, {} panels", springs.terms(), loads.len());
        assert!(worst < 1e-8);
    }
}

/// Adhesiveless: a prescribed edge, up and down, gives the force of Lee & Radok, then of Ting.
#[test]
fn lee_radok_and_ting() {
    for material in solids().into_iter().take(2) {
        let (a_m, up, down) = (0.2e-3, 2.0, 1.5);
        let problem = |history| IndentationProblem { instants_per_segment: 4, ..IndentationProblem::new(SPHERE, None, history) };
        let history = History::contact_radius(1e-9 * a_m).ramp(a_m, up).ramp(0.25 * a_m, down);
        let trace = integrate(&material, &problem(history), 1e-9).unwrap();
        let peak = trace.path.iter().fold(0.0f64, |most, point| most.max(point.force));
        let mut worst: f64 = 0.0;
        for &kept in &trace.kept[1..] {
            let point = trace.path[kept];
            let (t, a) = (point.time, point.contact_radius);
            let last = a / a_m * up;
            let exact = integral(0.0, last, &|x| material.relaxation(t - x) * 4.0 * (a_m / up).powi(3) * x * x / RADIUS);
            worst = worst.max((point.force - exact).abs() / peak);
            if t <= up {
                assert!((point.penetration - a * a / RADIUS).abs() < 1e-12 * a_m * a_m / RADIUS);
            }
        }
        println!("prescribed edge: worst {worst:e}, steps {}", trace.work.steps);
        assert!(worst < 1e-8);
        // The same under penetration: Δ = f(a) while advancing.
        let depth = a_m * a_m / RADIUS;
        let solved = problem(History::penetration(0.0).ramp(depth, up).ramp(0.3 * depth, down));
        for tolerance in [1e-6, 1e-7] {
            let trace = integrate(&material, &solved, tolerance).unwrap();
            let mut worst: f64 = 0.0;
            let mut worst_down: f64 = 0.0;
            for &kept in &trace.kept[1..] {
                let point = trace.path[kept];
                let (t, a) = (point.time, point.contact_radius);
                // a = √(RΔ) while advancing: 4a³/3R = (4/3)√R Δ^{3/2}; substitution x = y² takes the root away.
                let last = a * a / RADIUS / depth * up;
                let rate = depth / up;
                let exact = integral(0.0, last.sqrt(), &|y| material.relaxation(t - y * y) * 4.0 * RADIUS.sqrt() * rate.powf(1.5) * y * y);
                let error = (point.force - exact).abs() / peak;
                if t <= up { worst = worst.max(error) } else { worst_down = worst_down.max(error) }
            }
            println!(
                "penetration: up {worst:e} down {worst_down:e} steps {} closures {}",
                trace.work.steps, trace.work.closure_evaluations
            );
            assert!(worst < 1e-8 && worst_down < 1e-8);
        }
    }
}
