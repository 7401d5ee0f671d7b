//! The delay of a crack under a steady load, from the load below which nothing happens to the one that breaks at once.
//!
//! `cargo run --release --example delay_time`

use std::error::Error;
use viscotack::PlaneMaterial;
use viscotack::crack::delayed::{GrowthProblem, Onset, onset};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::material::CreepTerm;

fn main() -> Result<(), Box<dyn Error>> {
    let term = |compliance: f64, retardation_time: f64| CreepTerm { compliance, retardation_time };
    let gel = PlaneMaterial::from_creep(1e5, &[term(4e-4, 1e3), term(4e-4, 10.0), term(1e-4, 0.1)], None)?;
    let process_zone = ProcessZone::Constant { length: 1e-5 };
    let interface = Interface { work_of_adhesion: 1.0, process_zone, body: CrackBody::TwoHalves };
    let limits = GrowthProblem::new(&gel, interface, 1.0)?;
    println!("no growth below K = {:.3} Pa √m, at once above {:.3}", limits.relaxed_limit(), limits.glassy_limit());
    println!("{:>12} {:>16} {:>12} {:>22}", "K (Pa √m)", "delay (s)", "error (s)", "first speed (m/s)");
    for load in [20.0, 30.0, 33.4, 34.0, 36.0, 40.0, 60.0, 100.0, 200.0, 300.0, 400.0] {
        match onset(&GrowthProblem::new(&gel, interface, load)?, load)? {
            Onset::Never => println!("{load:12.1} {:>16}", "never"),
            Onset::AtOnce => println!("{load:12.1} {:>16}", "at once"),
            Onset::After { delay, initial_speed, .. } => {
                println!("{load:12.1} {:16.9e} {:12.0e} {:22.6e}", delay.value, delay.error, initial_speed.value);
            }
        }
    }
    Ok(())
}
