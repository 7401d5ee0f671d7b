//! Source: `studies::seeded_sweep` and `studies::known_states`.
//!
//! Goal: scenes made of known states come out right; a state that is falsified comes out wrong, also by the route that knows it.
//!
//! Parameters: forty contacts, eighty cracks, thirty histories, eight spheres of the sweep's own stream.
//!
//! Oracle: the known states themselves; falsification: edges, loads, times and works of adhesion moved by a hundredth or a thousandth.
//!
//! Tolerance: as the study states: 2e-7 (sliding), 5e-9 (cracks), 1e-5 (histories), 1e-3 (spheres).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use viscotack::Estimate;
use viscotack_verification::studies::draw::Draw;
use viscotack_verification::studies::known_states::crack::known_crack;
use viscotack_verification::studies::known_states::delayed::{KnownTime, known_growth};
use viscotack_verification::studies::known_states::sliding::known_contact;
use viscotack_verification::studies::known_states::sphere::known_sphere;
use viscotack_verification::studies::seeded_sweep::{SEED, SweepResult, crack, delayed, sliding, sphere};

fn is_right(result: &SweepResult) -> bool {
    matches!(result, SweepResult::Right(_) | SweepResult::Another(_))
}

#[test]
fn contacts_are_found_again_and_moved_ones_are_not() {
    (0..40_u64).into_par_iter().for_each(|scene| {
        let known = known_contact(&mut Draw::of(SEED ^ 1, scene)).unwrap();
        let result = sliding(&known);
        assert!(is_right(&result), "{scene}: {result:?} {}", known.described());
        let mut moved = known.clone();
        moved.eccentricity += 1e-3;
        assert!(!matches!(sliding(&moved), SweepResult::Right(_)), "{scene}: the drawn eccentricity may be anything");
        if let Some(defect) = known.defect_at(known.half_width, known.eccentricity, known.mean_pressure) {
            let at_another = known.defect_at(known.half_width, known.eccentricity + 0.01, known.mean_pressure).unwrap_or(1.0);
            assert!(defect < 1e-7 && at_another > 1e-4, "{scene}: {defect:e} {at_another:e}");
        }
    });
}

#[test]
fn cracks_are_found_again_and_moved_ones_are_not() {
    for scene in 0..80 {
        let known = known_crack(&mut Draw::of(SEED ^ 2, scene)).unwrap();
        assert!(is_right(&crack(&known)), "{scene}: {:?} {}", crack(&known), known.described());
        let mut moved = known.clone();
        moved.drive *= 1.0 + 1e-6;
        moved.release *= 1.0 + 1e-6;
        assert!(!is_right(&crack(&moved)), "{scene}: {}", known.described());
    }
}

#[test]
fn histories_are_found_again_and_moved_ones_are_not() {
    for scene in 0..30 {
        let known = known_growth(&mut Draw::of(SEED ^ 3, scene)).unwrap();
        assert!(is_right(&delayed(&known)), "{scene}: {:?} {}", delayed(&known), known.described());
        let mut moved = known.clone();
        moved.known = match known.known {
            KnownTime::Start(time) => KnownTime::Start(1.01 * time),
            KnownTime::Place { time, growth, speed } => KnownTime::Place { time, growth, speed: 1.01 * speed },
        };
        assert!(!is_right(&delayed(&moved)), "{scene}: {}", known.described());
    }
}

#[test]
fn spheres_are_found_again_and_moved_ones_are_not() {
    for scene in 0..8 {
        let known = known_sphere(&mut Draw::of(SEED ^ 4, scene)).unwrap();
        assert!(is_right(&sphere(&known)), "{scene}: {:?} {}", sphere(&known), known.described());
        let mut moved = known.clone();
        for (_, [_, _, radius]) in &mut moved.instants {
            *radius *= 1.01;
        }
        assert!(!is_right(&sphere(&moved)), "{scene}: {}", known.described());
    }
}

/// Contacts narrower than the unstable one of a pulled sphere are no reason to refuse the wide one: zones of a thousandth of the contact, relaxed starts under pulls.
#[test]
fn pulled_spheres_with_short_zones_start() {
    use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, run};
    use viscotack_verification::studies::known_states::sphere::elastic_work;
    let material = viscotack::PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap();
    for (part, by_force) in [(2.5, false), (3.5, false), (0.9, true), (1.25, true)] {
        let (a, zone): (f64, f64) = (0.1, 1e-4);
        let depth = a * a * (1.0 - part);
        let force = 2.0 * a * depth - 2.0 / 3.0 * a.powi(3);
        let adhesion = Adhesion { work_of_adhesion: elastic_work(1.0, 1.0, a, depth, zone), process_zone: zone };
        let history = if by_force { History::force(force) } else { History::penetration(depth) };
        let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history.hold(1.0)).relaxed();
        let found = run(&material, &problem).unwrap();
        let Estimate { value, .. } = found.instants[0].contact_radius;
        assert!((value / a - 1.0).abs() < 1e-7, "{part} {by_force}: {value}");
    }
}
