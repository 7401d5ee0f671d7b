//! Which theory a scene calls for: a range of attraction against the zone at the edge of the contact, and what the other theory would cost.

use super::super::IndentationPlan;
use super::FiniteRangePlan;
use crate::plan::curves::short;
use crate::scene::typed::{Indentation, IndentationAdhesion, IndentationShape, IndentationZone, Scene, SceneAttraction, Units};
use std::f64::consts::PI;
use viscotack::finite_range::law::{Attraction, Law};

/// Above this Tabor number zero range is called fair: the 3 of `elastic::tabor`.
const JKR_ABOVE: f64 = 3.0;
/// What the pull-off of an elastic sphere exceeds that of zero range by at a Tabor number of 3, and the power with which that falls
/// (`tests/finite_range_sphere.rs`: 3.4 % and 0.4 % at 3 and 14); never more than Bradley's 4/3.
const EXCESS_AT_THREE: f64 = 0.034;
const FALL: f64 = 1.4;
/// Above this Tabor number an elastic contact takes thousands of steps.
const MANY_STEPS: f64 = 9.0;

/// By how much (relative) a range of attraction raises the pull-off of an elastic sphere over that of zero range.
fn excess(tabor: f64) -> f64 {
    (EXCESS_AT_THREE * (JKR_ABOVE / tabor).powf(FALL)).min(1.0 / 3.0)
}

/// What Tabor numbers (relaxed, glassy) say about both theories; a law is measured for the sphere only.
fn called_for([relaxed, glassy]: [f64; 2], is_sphere: bool) -> String {
    let numbers = format!("Tabor number {} relaxed, {} glassy", short(relaxed), short(glassy));
    if !is_sphere {
        format!(
            "{numbers}, by the radius that scales this tip: what the range changes is known of spheres only; process_zone in place of law shows it"
        )
    } else if glassy > JKR_ABOVE {
        let small = short(100.0 * excess(glassy));
        format!("{numbers}: an edge with a process zone is enough; the range raises an elastic pull-off by {small} % at most")
    } else {
        let large = short(100.0 * excess(glassy));
        let small = short(100.0 * excess(relaxed));
        format!("{numbers}: the range of attraction matters; it raises an elastic pull-off by {small} % (relaxed) to {large} % (glassy)")
    }
}

impl FiniteRangePlan {
    /// Whether the tip is a sphere without a rim.
    pub(super) fn is_sphere(&self) -> bool {
        matches!(self.indentation.shape, IndentationShape::Sphere { .. }) && self.indentation.rim_radius.is_none()
    }

    /// The relaxed and the glassy Tabor number.
    pub(super) fn tabor_numbers(&self) -> [f64; 2] {
        let relaxed = self.reduced.scales.tabor;
        [relaxed, relaxed * self.material.stiffening_ratio().powf(-2.0 / 3.0)]
    }

    /// δ that an edge would have by the peak of the law (coherent): Dugdale's length (π²/4)a₀, a₀ = E0*Δγ/(πσ²).
    pub(super) fn zone(&self) -> f64 {
        let law = &self.reduced.law;
        0.25 * PI * self.material.relaxed_modulus() * law.work_of_adhesion / law.peak_stress().powi(2)
    }

    /// The theory the scene calls for, and what the other would cost.
    pub(super) fn theories(&self, scene: &Scene) -> Vec<String> {
        let mut sentences = vec![called_for(self.tabor_numbers(), self.is_sphere())];
        let zone = self.zone();
        let given = &self.attraction.attraction;
        let adhesion = IndentationAdhesion {
            work_of_adhesion: given.work_of_adhesion,
            process_zone: IndentationZone::Length(zone),
            interaction_range: None,
        };
        let edge = Indentation { adhesion: Some(adhesion), attraction: None, fields: None, ..self.indentation.clone() };
        let unit = if self.units == Units::Si { " m" } else { " R" };
        match IndentationPlan::new(scene, &edge) {
            Ok(plan) => {
                let work = plan.work_of_a_state();
                sentences.push(format!(
                    "the other theory, process_zone = {{ length = {zone:.3e}{unit} }} for the peak of this law, would take about {} energy balances and {} kernel evaluations a state",
                    work.closure_evaluations, work.kernel_evaluations
                ));
            }
            Err(refusal) => sentences.push(format!("the other theory, an edge with a process zone, does not take this scene: {refusal}")),
        }
        if self.tabor_numbers()[1] > MANY_STEPS {
            sentences.push("above a glassy Tabor number of 9 the zone is short against the range of a step: thousands of steps".into());
        }
        sentences
    }
}

/// The same of a scene with an edge that names the range of its interface: which theory it calls for, and what that range would cost.
pub(in crate::plan::indentation) fn beside_an_edge(scene: &Scene, indentation: &Indentation) -> Option<String> {
    let given = indentation.adhesion?;
    let range = given.interaction_range?;
    let law = Attraction::new(Law::LennardJones, given.work_of_adhesion, range).ok()?;
    let attraction = SceneAttraction { attraction: law, word: "lennard_jones", notes: Vec::new() };
    let other = Indentation { adhesion: None, fields: None, ..indentation.clone() };
    let plan = FiniteRangePlan::without_advice(scene, &other, &attraction).ok()?;
    let numbers = called_for(plan.tabor_numbers(), plan.is_sphere());
    let systems = plan.work_of_a_state().linear_solves;
    Some(format!(
        "{numbers}; law = \"lennard_jones\" with this range in place of process_zone would take about {systems} linear systems a state"
    ))
}
