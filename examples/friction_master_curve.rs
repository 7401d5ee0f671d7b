//! Friction of a rubber that slides over a wavy plate, at two temperatures: the same curve, shifted along the speed.
//!
//! `cargo run --release --example friction_master_curve`

use std::error::Error;
use std::f64::consts::TAU;
use viscotack::PlaneMaterial;
use viscotack::material::RelaxationTerm;
use viscotack::sliding::steady::{SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

fn main() -> Result<(), Box<dyn Error>> {
    let term = |modulus: f64, relaxation_time: f64| RelaxationTerm { modulus, relaxation_time };
    let cold = PlaneMaterial::from_relaxation(1e6, &[term(2e6, 1e-1), term(5e6, 1e-3), term(2e7, 1e-5)])?;
    // All times are a hundred times shorter where it is warm.
    let warm = cold.slowed(1e-2)?;
    let (wave_length, adhesion) = (1e-3, WaveAdhesion::even(0.002, 1e-3));
    let friction = |material: &PlaneMaterial, speed: f64| -> Result<String, viscotack::Refusal> {
        let control = SlidingControl::MeanPressure(0.1);
        let rate = TAU / wave_length * speed;
        let problem = SlidingProblem::wave(rate, Some(adhesion), control, 1e-9);
        Ok(match steady_sliding(material, &problem)? {
            SlidingOutcome::Partial(contact) => {
                format!("{:.6} ± {:.0e}", contact.values.friction_stress.value, contact.values.friction_stress.error)
            }
            SlidingOutcome::Full(_) => "full contact".to_owned(),
        })
    };
    println!("friction stress over E0 k²Λ²/2");
    println!("{:>12} {:>20} {:>20} {:>26}", "speed (m/s)", "cold", "warm", "warm, speed times 100");
    for decade in -6..=0 {
        let speed = 10f64.powi(decade);
        println!("{speed:12.0e} {:>20} {:>20} {:>26}", friction(&cold, speed)?, friction(&warm, speed)?, friction(&warm, 100.0 * speed)?);
    }
    Ok(())
}
