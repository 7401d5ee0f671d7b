//! A law with a hard wall on a sphere pressed deep at a low Tabor number: contact without adhesion, but for the pull of a rigid sphere.
//!
//! Source: Lee & Radok (1960) while the contact grows, Ting (1966) while it shrinks, by quadrature; Derjaguin, Muller & Toporov (1975): the attraction of a
//! stiff sphere is 2πRΔγ (what it raises of the surface beside a deep contact gives a part of that back).
//! Goal: forces on the way in and out, steps that do not fail at the edge of the wall, whatever their tolerance.
//! Parameters: Tabor number 0.1, stiffening 10 to 1000, both laws with a wall, contact times beside the relaxation time.
//! Oracle: as under Source.
//! Tolerance: a tenth of the tolerance of a step, and 1.3 times that attraction, where it is below 1 % of the force.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::sphere::{Accuracy, Control, Creep, Leg, Mesher, Motion, Problem, Start, run};

fn ramp(to: f64, duration: f64) -> Leg {
    Leg { control: Control::Penetration, motion: Motion::Ramp { to, duration } }
}

/// A standard solid of relaxed modulus 1 and retardation time 1.
struct Solid {
    stiffening: f64,
}

impl Solid {
    fn modulus(&self, time: f64) -> f64 {
        1.0 + (self.stiffening - 1.0) * (-self.stiffening * time).exp()
    }

    /// ∫ E over a time.
    fn integral(&self, time: f64) -> f64 {
        time - (1.0 - 1.0 / self.stiffening) * (-self.stiffening * time).exp_m1()
    }
}

/// The force on a sphere that goes to `depth` within `contact` and back at the same speed, at a time, over that of unit modulus, depth and coupling.
fn without_adhesion(solid: &Solid, depth: f64, contact: f64, time: f64) -> f64 {
    let speed = depth / contact;
    // The time on the way in at which the contact was as large.
    let since = if time <= contact {
        time
    } else {
        let way_out = solid.integral(time - contact);
        let (mut low, mut high) = (0.0, contact);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            let way_in = solid.integral(time - middle) - way_out;
            if way_in > way_out { low = middle } else { high = middle }
        }
        low
    };
    // s = since·x², by Simpson's rule: the root at first contact is gone.
    let count = 20_000;
    let value = |k: usize| {
        let x = k as f64 / count as f64;
        let s = since * x * x;
        solid.modulus(time - s) * 1.5 * (speed * s).sqrt() * speed * 2.0 * since * x
    };
    let inner: f64 = (1..count).map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * value(k)).sum();
    4.0 / 3.0 * (value(0) + inner + value(count)) / (3.0 * count as f64)
}

#[test]
fn deep_contacts_at_a_low_tabor_number_are_those_without_adhesion() {
    let tabor: f64 = 0.1;
    for (law, stiffening, depth, contact) in [
        (Law::Exponential, 100.0, 8.0, 0.03),
        (Law::Dugdale { ramp: 0.2 }, 10.0, 20.0, 0.3),
        (Law::Dugdale { ramp: 0.3 }, 1000.0, 5.0, 0.001),
    ] {
        let solid = Solid { stiffening };
        let creep = Creep { stiffening, fractions: vec![1.0], times: vec![1.0] };
        let far = 8.0;
        let speed = depth / contact;
        let begin = far / speed;
        let history = vec![ramp(depth, begin + contact), ramp(-far, contact + begin)];
        let instants: Vec<f64> = (4..14).map(|k| begin + contact * f64::from(k) / 10.0).collect();
        let problem = Problem { instants: instants.clone(), ..Problem::new(law.clone(), tabor, creep, Start::Unstrained(-far), history) };
        let accuracy = Accuracy::of_law(1e-3, &Attraction::new(law.clone(), 1.0, 1.0).unwrap());
        let found = run(&problem, accuracy, &mut Mesher::new(accuracy.order)).unwrap();
        let mut compared = 0;
        for time in &instants {
            let expected = without_adhesion(&solid, depth, contact, time - begin) / tabor.powf(1.5);
            let attraction = 2.0 * PI;
            if attraction < 0.01 * expected {
                let force = found.at(*time).unwrap().force;
                let allowed = 0.1 * accuracy.step * expected + 1.3 * attraction;
                assert!((force - expected).abs() < allowed, "{law:?} at {time}: {force}, {expected} within {allowed}");
                compared += 1;
            }
        }
        assert!(compared >= 9, "{compared}");
    }
}

/// A step that once found no side for the last node of the contact, on a sphere that was pressed for long and is torn off.
#[test]
fn steps_do_not_fail_at_the_edge_of_a_wall() {
    let law = Law::Dugdale { ramp: 0.2 };
    let creep = Creep { stiffening: 970.0, fractions: vec![0.4, 0.43, 0.17], times: vec![0.047, 1.07, 23.6] };
    let history = vec![ramp(4.45, 238.0), ramp(2.23, 0.0), ramp(-5.7, 8.8e-4)];
    let problem = Problem::new(law.clone(), 0.114, creep, Start::Unstrained(-8.0), history);
    let mut accuracy = Accuracy::of_law(1e-3, &Attraction::new(law, 1.0, 1.0).unwrap());
    for most_steps in [200, 400] {
        let certificate = run(&problem, accuracy, &mut Mesher::new(accuracy.order)).unwrap().certificate;
        assert!(certificate.failed == 0 && certificate.steps < most_steps, "{certificate:?}");
        accuracy = accuracy.tightened();
    }
}
