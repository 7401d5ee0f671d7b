//! Bounds of steady cracks.

use super::super::draw::Draw;
use super::super::known_states::crack::{KNOWN_TO, known_crack};
use super::tally::{Assessed, Compared, Truth};
use super::{ANOTHER_ROUTE, SEED};
use viscotack::crack::cohesive_zone::CohesiveZone;
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve, SteadyState, at_drive, at_speed};
use viscotack::estimate::Estimate;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Tolerances of the root, in turn.
const TOLERANCES: [f64; 3] = [1e-3, 1e-5, 1e-8];
/// The truth: rounding.
const TIGHTEST: f64 = 1e-15;

/// A crack of one of three theories, by speed or by a load between its limits.
struct Asked {
    material: PlaneMaterial,
    motion: Motion,
    interface: Interface,
    theory: usize,
    /// Speed (m/s), or drive.
    by_speed: bool,
    value: f64,
}

fn drawn(draw: &mut Draw) -> Result<Asked, Refusal> {
    let terms = 1 + draw.below(12);
    let (relaxed, beta) = (draw.log_between(1e2, 1e9), 1.0 + draw.log_between(0.05, 1e4));
    let (longest, decades) = (draw.log_between(1e-6, 1e6), draw.between(0.5, 10.0));
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let motion = if draw.chance(0.5) { Motion::Opening } else { Motion::Closing };
    let cohesive_stress = relaxed * draw.log_between(1e-2, 1e3);
    let work_of_adhesion = draw.log_between(1e-3, 1e3);
    let length = work_of_adhesion * relaxed / (cohesive_stress * cohesive_stress);
    let process_zone = match draw.below(3) {
        0 => ProcessZone::Constant { length },
        2 if motion == Motion::Closing => ProcessZone::Schapery { cohesive_stress, factor: draw.between(0.3, 1.5) },
        _ => ProcessZone::Growing { cohesive_stress, factor: draw.between(0.1, 2.0) },
    };
    let theory = if matches!(process_zone, ProcessZone::Schapery { .. }) { 0 } else { draw.below(3) };
    let body = if draw.chance(0.5) { CrackBody::AgainstRigid } else { CrackBody::TwoHalves };
    let by_speed = draw.chance(0.6);
    let speed = length / longest * 10f64.powf(draw.between(-6.0, decades + 4.0));
    let part = draw.between(0.02, 0.98);
    let drive = match motion {
        Motion::Opening => relaxed * beta.powf(part),
        Motion::Closing => beta.powf(-part) / relaxed,
    };
    let value = if by_speed { speed } else { drive };
    Ok(Asked { material, motion, interface: Interface { work_of_adhesion, process_zone, body }, theory, by_speed, value })
}

impl Asked {
    fn solved(&self, tolerance: f64) -> Result<SteadyState, Refusal> {
        let (material, motion) = (&self.material, self.motion);
        match (self.theory, self.interface.process_zone) {
            (0, _) => self.on(&VirtualWork::new(material, motion, self.interface)?, tolerance),
            (1, _) => self.on(&PerssonBrener::new(material, motion, self.interface)?, tolerance),
            (_, ProcessZone::Growing { cohesive_stress, .. } | ProcessZone::Schapery { cohesive_stress, .. }) => {
                let Interface { work_of_adhesion, body, .. } = self.interface;
                self.on(&CohesiveZone::new(material, motion, work_of_adhesion, cohesive_stress, body)?, tolerance)
            }
            (_, ProcessZone::Constant { .. }) => self.on(&VirtualWork::new(material, motion, self.interface)?, tolerance),
        }
    }

    fn on(&self, curve: &impl SteadyCurve, tolerance: f64) -> Result<SteadyState, Refusal> {
        if self.by_speed { at_speed(curve, self.value, tolerance) } else { at_drive(curve, self.value, tolerance) }
    }
}

fn listed(state: &SteadyState) -> Vec<(&'static str, Estimate)> {
    let mut list = vec![("speed", state.speed), ("drive", state.drive), ("crossing length", state.crossing_length)];
    list.extend(state.energy_release_rate_ratio.map(|ratio| ("G/Δγ", ratio)));
    list
}

/// A scene, assessed.
#[must_use]
pub fn assessed(scene: u64) -> Assessed {
    let mut draw = Draw::of(SEED ^ 3, scene);
    let tolerance = TOLERANCES[(scene / ANOTHER_ROUTE + scene) as usize % TOLERANCES.len()];
    let another = scene.is_multiple_of(ANOTHER_ROUTE);
    let truth = if another { Truth::Another } else { Truth::Tighter };
    let mut assessed = Assessed { scene, accuracy: tolerance, described: String::new(), compared: Vec::new(), truth, trouble: None };
    let result = if another { against_known(&mut draw, &mut assessed) } else { against_tighter(&mut draw, &mut assessed) };
    match result {
        Ok(compared) => assessed.compared = compared,
        Err(refusal) => assessed.trouble = Some(refusal.to_string()),
    }
    assessed
}

fn against_tighter(draw: &mut Draw, assessed: &mut Assessed) -> Result<Vec<Compared>, Refusal> {
    let asked = drawn(draw)?;
    assessed.described = format!(
        "{:?} {:?} theory {} by speed {} {:e}: {:?}",
        asked.motion, asked.interface, asked.theory, asked.by_speed, asked.value, asked.material
    );
    let (found, exact) = match (asked.solved(assessed.accuracy), asked.solved(TIGHTEST)) {
        // A load may lie beyond a limit of the theory: both say so.
        (Err(Refusal::NoSuchState { .. }), Err(Refusal::NoSuchState { .. })) => return Ok(Vec::new()),
        (found, exact) => (found?, exact?),
    };
    let pairs = listed(&found).into_iter().zip(listed(&exact));
    Ok(pairs.map(|((quantity, found), (_, truth))| Compared { quantity, found, truth, scale: 0.0, floor: 0.0 }).collect())
}

fn against_known(draw: &mut Draw, assessed: &mut Assessed) -> Result<Vec<Compared>, Refusal> {
    let known = known_crack(draw)?;
    assessed.described = known.described();
    let curve = VirtualWork::new(&known.material, known.motion, known.interface)?;
    let found = at_speed(&curve, known.speed, assessed.accuracy)?;
    // What is not known of the drawn speed goes on with the local power of the curve.
    let relative = KNOWN_TO * (2.0 + found.speed_exponent.abs());
    let truth = |value: f64| Estimate::relative(value, relative);
    let mut compared = vec![Compared { quantity: "drive", found: found.drive, truth: truth(known.drive), scale: 0.0, floor: 0.0 }];
    compared.extend(found.energy_release_rate_ratio.map(|ratio| Compared {
        quantity: "G/Δγ",
        found: ratio,
        truth: truth(known.release),
        scale: 0.0,
        floor: 0.0,
    }));
    Ok(compared)
}

/// Points of the curve at 1e-3 and at 1e-9.
#[must_use]
pub fn work(scene: u64) -> Option<[u64; 2]> {
    let asked = drawn(&mut Draw::of(SEED ^ 3, scene)).ok()?;
    Some([asked.solved(1e-3).ok()?.curve_points, asked.solved(1e-9).ok()?.curve_points])
}
