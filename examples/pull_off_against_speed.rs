//! Pull-off force of an adhesive sphere against the speed of retraction, between the two elastic limits.
//!
//! `cargo run --release --example pull_off_against_speed`

use std::error::Error;
use std::f64::consts::PI;
use viscotack::elastic::PlaneState;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, run};
use viscotack::{Material, PlaneMaterial};

fn main() -> Result<(), Box<dyn Error>> {
    let (radius, work_of_adhesion) = (1e-3, 0.05);
    let youngs = Material::standard_solid(1e6, 1e8, 0.1)?;
    // The contact problem is stated in E* = E/(1 − ν²).
    let plane = PlaneMaterial::of_youngs(&youngs, PlaneState::Strain, 0.5)?;
    let adhesion = Adhesion { work_of_adhesion, process_zone: 1e-7 };
    let elastic = 1.5 * PI * radius * work_of_adhesion;
    println!("{:>12} {:>14} {:>12} {:>18}", "speed (m/s)", "pull-off (mN)", "error (mN)", "over 1.5 pi R work");
    for tenth in (-80..=-30).step_by(10) {
        let speed = 10f64.powf(0.1 * f64::from(tenth));
        // A contact that has relaxed at 2 µm is pulled off.
        let history = History::penetration(2e-6).at_speed(-100e-6, speed);
        let problem = IndentationProblem::new(Profile::Paraboloid { radius }, Some(adhesion), history).relaxed();
        let pull_off = run(&plane, &problem)?.pull_off_force().ok_or("nothing pulled")?;
        println!("{speed:12.1e} {:14.6} {:12.1e} {:18.4}", 1e3 * pull_off.value, 1e3 * pull_off.error, pull_off.value / elastic);
    }
    Ok(())
}
