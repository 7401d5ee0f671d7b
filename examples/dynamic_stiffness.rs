//! Storage and loss stiffness of a sphere that oscillates in adhesive contact, against the frequency, beside the same without adhesion.
//!
//! `cargo run --release --example dynamic_stiffness`

use std::error::Error;
use viscotack::elastic::PlaneState;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Oscillation, Profile, run};
use viscotack::{Material, PlaneMaterial};

fn main() -> Result<(), Box<dyn Error>> {
    let plane = PlaneMaterial::of_youngs(&Material::standard_solid(1e6, 1e7, 0.1)?, PlaneState::Strain, 0.5)?;
    let adhesion = Adhesion { work_of_adhesion: 0.05, process_zone: 1e-6 };
    println!("{:>14} {:>14} {:>12} {:>14} {:>12} {:>10}", "frequency (Hz)", "storage (N/m)", "error", "loss (N/m)", "error", "phase");
    for frequency in [0.01, 0.1, 1.0, 10.0, 100.0] {
        // Relaxed at 10 µm, then ten cycles of 50 nm: the edge stays, and the last cycle is stationary.
        let history = History::penetration(10e-6).oscillate(Oscillation::steady(50e-9, frequency), 10.0 / frequency);
        let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1e-3 }, Some(adhesion), history).relaxed();
        let solution = run(&plane, &problem)?;
        let cycle = solution.cycles.last().ok_or("no whole cycle")?;
        let (storage, loss) = (cycle.storage_stiffness, cycle.loss_stiffness);
        println!(
            "{frequency:14.2} {:14.4} {:12.0e} {:14.5} {:12.0e} {:10.5}",
            storage.value, storage.error, loss.value, loss.error, cycle.phase.value
        );
    }
    Ok(())
}
