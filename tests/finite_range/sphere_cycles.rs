//! Cycles of a sphere with a law of attraction: stiffness, loss and work of what oscillates.
//!
//! Source: the equations of the solver, linearised about a relaxed contact; Voigt elements under a sine; closed forms of the sine.
//! Goal: the complex stiffness of small oscillations, whole cycles of every control and phase, jumps within cycles.
//! Parameters: Tabor numbers 0.4 to 3, stiffening 1.5 and 10, two terms, frequencies over two decades.
//! Oracle: uniform rings of pressure with complete elliptic integrals, a dense complex system; it shares the surface at rest with the solver, and no code.
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs)]

use std::f64::consts::{PI, TAU};
use viscotack::finite_range::law::Law;
use viscotack::finite_range::sphere::{Accuracy, Control, Creep, Leg, Mesher, Motion, Problem, Run, Start, cycles, run};
use viscotack::indentation::{Cycle, FrequencySweep, Oscillation};

const ORDER: usize = 10;

fn creep() -> Creep {
    Creep { stiffening: 10.0, fractions: vec![0.6, 0.4], times: vec![0.1, 1.0] }
}

fn swing(to: f64, duration: f64, oscillation: Oscillation) -> Leg {
    Leg { control: Control::Penetration, motion: Motion::Swing { to, duration, oscillation } }
}

fn solved(problem: &Problem, relative: f64) -> (Run, Vec<Cycle<f64>>) {
    let run = run(problem, Accuracy::new(relative), &mut Mesher::new(ORDER)).unwrap();
    let found = cycles(problem, &run).0;
    (run, found)
}

/// K(m) and E(m) by the arithmetic-geometric mean, m = k².
fn elliptic(m: f64) -> (f64, f64) {
    let (mut a, mut b, mut c) = (1.0, (1.0 - m).sqrt(), m.sqrt());
    let (mut sum, mut factor) = (0.5 * c * c, 1.0);
    while c.abs() > 1e-16 {
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        sum += factor * c * c;
        factor *= 2.0;
    }
    let whole = PI / (2.0 * a);
    (whole, whole * (1.0 - sum))
}

/// Displacement at a radius by unit pressure within another, of a half-space of unit modulus (Johnson 1985, 3.29).
fn disk(radius: f64, loaded: f64) -> f64 {
    if radius < loaded {
        4.0 / PI * loaded * elliptic((radius / loaded).powi(2)).1
    } else {
        let m = (loaded / radius).powi(2);
        let (k, e) = elliptic(m);
        4.0 / PI * radius * (e - (1.0 - m) * k)
    }
}

/// F̂/Δ̂ of an infinitesimal oscillation: (1 − m J A s′)δg = −δΔ with the complex compliance J, on so many rings.
fn linear(gap: &dyn Fn(f64) -> f64, reach: f64, coupling: f64, compliance: [f64; 2], rings: usize) -> [f64; 2] {
    let width = reach / rings as f64;
    let middle = |i: usize| (i as f64 + 0.5) * width;
    // s = (8/3)(g⁻⁹ − g⁻³), compression positive.
    let slope: Vec<f64> = (0..rings).map(|i| 8.0 / 3.0 * (3.0 * gap(middle(i)).powi(-4) - 9.0 * gap(middle(i)).powi(-10))).collect();
    // Real parts first, imaginary ones behind: a real system of twice the size.
    let n = 2 * rings;
    let mut rows: Vec<Vec<f64>> = vec![vec![0.0; n + 1]; n];
    for i in 0..rings {
        for j in 0..rings {
            let ring = disk(middle(i), (j + 1) as f64 * width) - if j == 0 { 0.0 } else { disk(middle(i), j as f64 * width) };
            let part = coupling * ring * slope[j];
            let one = f64::from(u8::from(i == j));
            rows[i][j] = one - compliance[0] * part;
            rows[i][j + rings] = compliance[1] * part;
            rows[i + rings][j] = -compliance[1] * part;
            rows[i + rings][j + rings] = one - compliance[0] * part;
        }
        rows[i][n] = -1.0;
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs())).unwrap();
        rows.swap(k, pivot);
        let (above, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / above[k][k];
            (k..=n).for_each(|c| row[c] -= factor * above[k][c]);
        }
    }
    for k in (0..n).rev() {
        rows[k][n] = (rows[k][n] - (k + 1..n).map(|c| rows[k][c] * rows[c][n]).sum::<f64>()) / rows[k][k];
    }
    // Beyond the rings nothing is deformed, and ∫2πx s′ dx = −2πs, as dg = x dx.
    let beyond = TAU * 8.0 / 3.0 * (gap(reach).powi(-9) - gap(reach).powi(-3));
    [(0, beyond), (rings, 0.0)]
        .map(|(part, beyond)| beyond + (0..rings).map(|j| TAU * middle(j) * width * slope[j] * rows[j + part][n]).sum::<f64>())
}

#[test]
fn small_oscillations_have_the_complex_stiffness_of_the_linearised_contact() {
    let body = creep();
    for (tabor, depth) in [(0.4, 0.0), (1.0, 0.5), (1.5, 1.0)] {
        for omega in [0.3, 3.0, 30.0] {
            let whole = 2.0 + (12.0 * omega / TAU).ceil();
            let oscillation = Oscillation::steady(1e-3, omega / TAU);
            let history = vec![swing(depth, whole * TAU / omega, oscillation)];
            let problem =
                Problem { surfaces: vec![0.0], ..Problem::new(Law::LennardJones, tabor, body.clone(), Start::Relaxed(depth), history) };
            let (run, found) = solved(&problem, 1e-5);
            let last = found.last().unwrap();
            assert_eq!(found.len(), whole as usize);
            let glassy = 1.0 / body.stiffening;
            let term = |which: usize| -> f64 {
                let part = |(f, t): (&f64, &f64)| f * [1.0, -omega * t][which] / (1.0 + (omega * t).powi(2));
                (1.0 - glassy) * body.fractions.iter().zip(&body.times).map(part).sum::<f64>()
            };
            let compliance = [glassy + term(0), term(1)];
            let reach = 5.0 + run.rows[0].contact_radius;
            let of = |rings: usize| linear(&|x| run.surfaces[0].at(x).gap, reach, tabor.powf(1.5), compliance, rings);
            let [coarse, fine] = [200, 400].map(of);
            let size = fine[0].hypot(fine[1]);
            let of_rings = (fine[0] - coarse[0]).hypot(fine[1] - coarse[1]) / size;
            let off = (last.storage_stiffness - fine[0]).hypot(last.loss_stiffness - fine[1]) / size;
            println!("Tabor {tabor}, ω {omega}: {fine:?}, rings {of_rings:.1e}, off {off:.1e}, phase {:.3}", last.phase);
            assert!(of_rings < 5e-3 && off < 1.5 * of_rings + 1e-4, "{tabor} {omega}: {off:e} {of_rings:e}");
            // The ellipse of a sine: π k″ A².
            let ellipse = PI * last.loss_stiffness * 1e-6;
            assert!((last.work / ellipse - 1.0).abs() < 1e-3, "{} {ellipse}", last.work);
        }
    }
}

/// Under a force or a frame, from any phase and on a ramp that is slow beside it, one and the same small oscillation has one stiffness.
#[test]
fn one_stiffness_under_every_control_and_phase() {
    let (omega, depth, amplitude) = (3.0, 2.0, 1e-3);
    let duration = 6.0 * TAU / omega;
    let of = |leg: Leg| {
        let problem = Problem::new(Law::LennardJones, 1.0, creep(), Start::Relaxed(depth), vec![leg]);
        let (_, found) = solved(&problem, 1e-5);
        assert_eq!(found.len(), 6);
        let last = found.last().unwrap();
        [last.storage_stiffness, last.loss_stiffness]
    };
    let steady = Oscillation::steady(amplitude, omega / TAU);
    let plain = of(swing(depth, duration, steady));
    let size = plain[0].hypot(plain[1]);
    let start = Problem::new(Law::LennardJones, 1.0, creep(), Start::Relaxed(depth), vec![swing(depth, duration, steady)]);
    let held = solved(&start, 1e-5).0.rows[0].force;
    let force = Oscillation::steady(amplitude * size, omega / TAU);
    let frame = 2.0 * size;
    let of_frame = Control::Frame(frame);
    for (name, leg) in [
        ("phase", swing(depth, duration, Oscillation { phase: 2.0, ..steady })),
        ("ramp", swing(depth + 3.0 * amplitude, duration, steady)),
        ("ramp and phase", swing(depth + 3.0 * amplitude, duration, Oscillation { phase: -1.0, ..steady })),
        ("force", Leg { control: Control::Force, motion: Motion::Swing { to: held, duration, oscillation: force } }),
        ("frame", Leg { control: of_frame, motion: Motion::Swing { to: depth + held / frame, duration, oscillation: steady } }),
    ] {
        let found = of(leg);
        let off = (found[0] - plain[0]).hypot(found[1] - plain[1]) / size;
        println!("{name}: off {off:.1e}");
        assert!(off < 3e-3, "{name}: {found:?} {plain:?}");
    }
}

/// What a cycle of a record sums up is what sixteen times as many rows show: instants all through the cycles, straight lines between them.
#[test]
fn cycles_are_those_of_many_more_instants() {
    // The contact opens and closes in each cycle, with jumps.
    let oscillation = Oscillation::swept(6.0, 0.5, 1.0, FrequencySweep::Logarithmic);
    let duration = 4.0;
    let history = vec![swing(1.0, duration, oscillation)];
    let body = Creep { stiffening: 1.5, ..creep() };
    let plain = Problem::new(Law::LennardJones, 3.0, body, Start::Relaxed(1.0), history);
    let rows = 4000;
    let dense = Problem { instants: (1..rows).map(|k| duration * f64::from(k) / f64::from(rows)).collect(), ..plain.clone() };
    let (run, found) = solved(&plain, 1e-5);
    let (fine, _) = solved(&dense, 1e-5);
    assert!(
        found.len() == oscillation.cycles_at(duration, duration).floor() as usize && run.jumps.len() >= found.len(),
        "{} {}",
        found.len(),
        run.jumps.len()
    );
    for cycle in &found {
        let begin = oscillation.time_of(cycle.number as f64 - 1.0, duration).unwrap();
        let end = oscillation.time_of(cycle.number as f64, duration).unwrap();
        assert!((cycle.start - begin).abs() < 1e-9 && (cycle.end - end).abs() < 1e-9);
        let way: Vec<_> = fine.rows.iter().filter(|row| row.time >= begin - 1e-9 && row.time <= end + 1e-9).collect();
        let (first, last) = (way[0], way[way.len() - 1]);
        let (mut work, mut moments) = (0.0, [[0.0; 2]; 2]);
        for pair in way.windows(2) {
            let values = |row: &viscotack::finite_range::sphere::Record| [row.penetration, row.force];
            work += 0.5 * (pair[0].force + pair[1].force) * (pair[1].penetration - pair[0].penetration);
            let angles = [pair[0].time, pair[1].time].map(|time| oscillation.angle(time, duration));
            let step = (oscillation.cycles_at(pair[1].time, duration) - oscillation.cycles_at(pair[0].time, duration)) * TAU;
            for (quantity, moments) in moments.iter_mut().enumerate() {
                let [a, b] = [values(pair[0])[quantity], values(pair[1])[quantity]];
                moments[0] += 0.5 * step * (a * angles[0].sin() + b * angles[1].sin());
                moments[1] += 0.5 * step * (a * angles[0].cos() + b * angles[1].cos());
            }
        }
        let rise = [last.penetration - first.penetration, last.force - first.force];
        let [depth, force] = [0, 1].map(|quantity| [(moments[quantity][0] + rise[quantity]) / PI, moments[quantity][1] / PI]);
        let square = depth[0].powi(2) + depth[1].powi(2);
        let storage = (force[0] * depth[0] + force[1] * depth[1]) / square;
        let loss = (force[1] * depth[0] - force[0] * depth[1]) / square;
        let size = storage.hypot(loss);
        let off = (cycle.storage_stiffness - storage).hypot(cycle.loss_stiffness - loss) / size;
        println!("cycle {}: {storage} {loss}, off {off:.1e}, work {work} {}", cycle.number, cycle.work);
        assert!(off < 3e-5 && (cycle.work / work - 1.0).abs() < 3e-5, "{off:e} {} {work}", cycle.work);
        let extremes = |of: fn(&viscotack::finite_range::sphere::Record) -> f64| {
            way.iter().map(|row| of(row)).fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
        };
        for (ours, theirs) in [
            (cycle.penetration, extremes(|row| row.penetration)),
            (cycle.force, extremes(|row| row.force)),
            (cycle.contact_radius, extremes(|row| row.contact_radius)),
        ] {
            let scale = theirs[1] - theirs[0];
            assert!((0..2).all(|k| (ours[k] - theirs[k]).abs() < 3e-3 * scale), "{ours:?} {theirs:?}");
        }
    }
}
