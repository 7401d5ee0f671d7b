//! What a scene of a crack under a load history simulates and leaves out, by which method, and its characteristic numbers.

use super::DelayedFracturePlan;
use crate::outcome::{Effect, Group};
use crate::plan::citations::{Citation, RIVLIN_THOMAS, THESIS};
use crate::scene::typed::{CohesiveLaw, ProcessZoneLaw, Units};

impl DelayedFracturePlan {
    pub(super) fn effect_list(&self) -> Vec<Effect> {
        let terms = self.plane_material.creep_terms().len();
        let elastic = self.plane_material.is_elastic();
        let viscous = self.plane_material.steady_viscosity().is_some();
        let (growing, law) = match self.crack.process_zone {
            ProcessZoneLaw::Length(_) => (false, "adhesion.process_zone.length fixes it"),
            ProcessZoneLaw::Cohesive { law: CohesiveLaw::Constant, .. } => (false, "law = \"constant\": its length at G = Δγ"),
            ProcessZoneLaw::Cohesive { .. } if self.is_one_step() => (false, "law = \"growing\", and the load is constant"),
            ProcessZoneLaw::Cohesive { .. } => (true, "law = \"growing\": δ follows K(t)²"),
        };
        let effect = |name: &'static str, on: bool, why: &str| Effect { name, on, why: why.to_owned() };
        let memory = match (elastic, terms) {
            (true, _) => "the material has no creep or relaxation terms".to_owned(),
            (false, 1) => "1 term".to_owned(),
            (false, terms) => format!("{terms} terms"),
        };
        vec![
            effect("adhesion", true, "[adhesion] is given"),
            effect("memory", !elastic, &memory),
            effect("flow", viscous, if viscous { "the relaxed modulus is 0" } else { "the material is a solid" }),
            effect("process zone follows the load", growing, law),
            effect(
                "load history",
                !self.is_one_step(),
                if self.is_one_step() { "[[history]] is one step, held" } else { "[[history]] changes the load" },
            ),
            effect(
                "strip",
                self.strip.is_some(),
                if self.strip.is_some() { "[crack.strip]: its stress is the load" } else { "no [crack.strip]" },
            ),
            effect("healing", false, "broken faces never join again (thesis Sec 5.4)"),
            effect("sweep", self.swept, if self.swept { "[sweep] is given" } else { "no [sweep]" }),
        ]
    }

    pub(super) fn sentences(&self) -> Vec<String> {
        let mut sentences =
            vec!["virtual work: the double integral of (5.67) collapses exactly to the creep function over the time since each place entered the process zone".to_owned()];
        if self.is_one_step() {
            sentences
                .push("delay and first speed: one root of the creep series, to rounding; the speed at last: the steady theory".to_owned());
        }
        if self.crack.output.points > 0 || !self.is_one_step() {
            let lines = self.resolution().lines_per_zone;
            sentences.push(format!(
                "steps of third order with exact memory of each term, {}, {lines}, {} and {} a process zone; halved further until the bounds meet the accuracy; values are those of the finest, the differences give the error",
                lines.div_ceil(2),
                2 * lines,
                4 * lines
            ));
            sentences.push(
                "slow growth over very many zones is followed by its quasi-steady speed, to first order in the load's rate".to_owned(),
            );
        }
        sentences
    }

    pub(super) fn characteristic_numbers(&self) -> Vec<Group> {
        let unit = |si: &str, reduced: &str| (if self.units == Units::Si { si } else { reduced }).to_owned();
        let material = &self.plane_material;
        let mut groups = vec![
            Group { name: "relaxed plane modulus E0*".into(), value: material.relaxed_modulus(), unit: unit("Pa", "E0") },
            Group { name: "glassy plane modulus E∞*".into(), value: material.glassy_modulus(), unit: unit("Pa", "E0") },
        ];
        if material.relaxed_modulus() > 0.0 {
            groups.push(Group { name: "stiffening β = E∞/E0".into(), value: material.stiffening_ratio(), unit: "1".into() });
        }
        if let Ok(problem) = self.problem() {
            let factor = if self.units == Units::Si { 1.0 } else { 0.5_f64.sqrt() };
            let peak = self.history.peak();
            groups.extend([
                Group { name: "no growth up to K".into(), value: problem.relaxed_limit() * factor, unit: unit("Pa √m", "√(2E0Δγ)") },
                Group {
                    name: "immediate growth from K".into(), value: problem.glassy_limit() * factor, unit: unit("Pa √m", "√(2E0Δγ)")
                },
                Group { name: "greatest K".into(), value: peak * factor, unit: unit("Pa √m", "√(2E0Δγ)") },
                Group { name: "process zone at the greatest K".into(), value: problem.process_zone_at(peak), unit: unit("m", "a₀") },
            ]);
        }
        groups.push(Group { name: "length of the history".into(), value: self.duration, unit: unit("s", "τ") });
        groups
    }

    pub(super) fn papers(&self) -> Vec<&'static Citation> {
        let mut papers = vec![&THESIS];
        if self.strip.is_some() {
            papers.push(&RIVLIN_THOMAS);
        }
        papers
    }
}
