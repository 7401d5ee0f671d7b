//! The other theory of a sticky indenter: a law of attraction with a range in place of an edge with a process zone, and the other way round.
//!
//! Both have one peak of stress: an edge of the zone δ = (π²/4)a₀, a₀ = E0*Δγ/(πσ²), is one of a Dugdale zone with the largest tension σ of the law
//! (Maugis 1992, doi:10.1016/0021-9797(92)90285-T).

use crate::plan::Plan;
use crate::plan::plane_material::plane_material;
use crate::scene::document::{Document, Node, Value};
use crate::scene::read;
use crate::scene::typed::{FitFree, Indentation, IndentationZone, Problem, Scene};
use std::f64::consts::PI;
use viscotack::finite_range::law::{Attraction, Law};

const ZONE: &str = "adhesion.process_zone.length";
const COHESIVE: &str = "adhesion.process_zone.cohesive_stress";
const RANGE: &str = "adhesion.range";
const PEAK: &str = "adhesion.peak_stress";
/// Keys of [adhesion] that belong to one of both theories.
const OF_AN_EDGE: [&str; 2] = ["process_zone", "interaction_range"];
const OF_A_LAW: [&str; 4] = ["law", "range", "peak_stress", "ramp"];
/// Above this glassy Tabor number an edge is the limit of a law: pull-offs of elastic spheres differ by less than 2 %, and a run takes thousands of steps.
const SHORT_RANGE: f64 = 5.0;
/// Below this one the range is so long that the contact is that of DMT.
const LONG_RANGE: f64 = 0.05;
/// Bounds of what takes the place of a free number, about its value, by this factor.
const BOUNDS: f64 = 30.0;

/// What takes the place of what.
#[derive(Debug, Clone)]
pub(super) struct OtherTheory {
    /// The number of this scene, if it may be free, and the one in its place, with its value.
    from: &'static str,
    to: &'static str,
    value: f64,
    /// Bounds of that, if it is free.
    bounds: [f64; 2],
    /// Whether that is a law of attraction.
    pub(super) at_a_distance: bool,
}

impl OtherTheory {
    /// The other theory of a scene.
    pub(super) fn of(scene: &Scene, indentation: &Indentation) -> Result<Self, String> {
        let material =
            plane_material(scene, indentation.counter_body.and_then(|body| body.elastic)).map_err(|refusal| refusal.to_string())?;
        let modulus = material.relaxed_modulus();
        let at_a_distance = indentation.attraction.is_none();
        if let Some(given) = &indentation.attraction {
            if given.word == "table" {
                return Err("the law of this scene is a table, and no process zone follows from one number of it".to_owned());
            }
            let (work, peak) = (given.attraction.work_of_adhesion, given.attraction.peak_stress());
            let value = 0.25 * PI * modulus * work / (peak * peak);
            return Ok(Self { from: RANGE, to: ZONE, value, bounds: [value / BOUNDS, value * BOUNDS], at_a_distance });
        }
        let given = indentation.adhesion.ok_or("the scene has no adhesion")?;
        let of_peak = |peak: f64| {
            Attraction::with_peak_stress(Law::LennardJones, given.work_of_adhesion, peak).map_err(|refusal| refusal.to_string())
        };
        let (from, to, value) = match given.process_zone {
            IndentationZone::Cohesive { cohesive_stress, .. } => (COHESIVE, PEAK, cohesive_stress),
            IndentationZone::Length(zone) => {
                let law = of_peak((0.25 * PI * modulus * given.work_of_adhesion / zone).sqrt())?;
                (ZONE, RANGE, given.interaction_range.unwrap_or(law.range))
            }
        };
        Ok(Self { from, to, value, bounds: [value / BOUNDS, value * BOUNDS], at_a_distance })
    }

    /// With bounds that leave shorter and longer ranges out.
    pub(super) fn bounded(mut self, document: &Document) -> Result<Self, String> {
        if self.at_a_distance {
            let tabor = glassy_tabor_number(&self.put_into(document)?)?;
            // The Tabor number goes with one over the range, and the peak as well.
            let ends = [SHORT_RANGE, LONG_RANGE].map(|end| tabor / end);
            self.bounds = if self.to == PEAK { [self.value / ends[1], self.value / ends[0]] } else { ends.map(|end| self.value * end) };
        }
        Ok(self)
    }

    /// The scene in the other theory.
    pub(super) fn put_into(&self, document: &Document) -> Result<Document, String> {
        let table = document.root.get("adhesion").ok_or("the scene has no [adhesion]")?;
        let gone: &[&str] = if self.at_a_distance { &OF_AN_EDGE } else { &OF_A_LAW };
        let mut own = document.without(&["adhesion"]);
        let mut put = |key: &str, node: Node| own.replace(key, node).map_err(|error| error.to_string());
        for entry in table.entries().iter().filter(|entry| !gone.contains(&entry.key.as_str())) {
            put(&format!("adhesion.{}", entry.key), entry.node.clone())?;
        }
        if self.at_a_distance {
            put("adhesion.law", Node { value: Value::Text("lennard_jones".to_owned()), place: table.place.clone() })?;
        }
        put(self.to, Node { value: Value::Number(self.value), place: table.place.clone() })?;
        if self.at_a_distance {
            has_a_long_range(&own)?;
        }
        Ok(own)
    }

    /// What is free there in place of a number of this scene.
    pub(super) fn free(&self, free: &FitFree) -> FitFree {
        let mut own = free.clone();
        // A scene may give a law by its range or by its peak.
        if free.key == self.from || (!self.at_a_distance && free.key == PEAK) {
            own.key = self.to.to_owned();
            own.bounds = Some(self.bounds);
            own.dimension = if self.to == PEAK { free.dimension } else { crate::scene::units::Dimension::LENGTH };
        }
        own
    }
}

/// That an edge is not the limit of a law of attraction.
pub(super) fn has_a_long_range(document: &Document) -> Result<(), String> {
    let tabor = glassy_tabor_number(document)?;
    if tabor > SHORT_RANGE {
        return Err(format!(
            "glassy Tabor number {tabor:.1}: above {SHORT_RANGE} a range of attraction is so short that an edge is its limit (elastic pull-offs differ by less than 2 %)"
        ));
    }
    Ok(())
}

fn glassy_tabor_number(document: &Document) -> Result<f64, String> {
    let scene = read::read(document).map_err(|error| error.to_string())?;
    let plan = Plan::new(&scene).map_err(|refusal| refusal.to_string())?;
    plan.groups()
        .iter()
        .find(|group| group.name == "glassy Tabor number")
        .map(|group| group.value)
        .ok_or_else(|| "the scene has no Tabor number".to_owned())
}

/// The other theory of a scene in words.
pub(super) const fn words(indentation: &Indentation) -> &'static str {
    if indentation.attraction.is_some() { "viscoelastic, edge with a process zone" } else { "viscoelastic, attraction of finite range" }
}

/// Whether a number is the length over which adhesion acts, which JKR's theory has none of.
pub(super) fn is_length_of_the_edge(key: &str) -> bool {
    key.starts_with("adhesion.process_zone.") || key == RANGE || key == PEAK
}

/// Whether the scene of a document is an indenter that sticks, in either theory.
pub(super) fn sticks(scene: &Scene) -> bool {
    matches!(&scene.problem, Problem::Indentation(indentation) if indentation.adhesion.is_some() || indentation.attraction.is_some())
}
