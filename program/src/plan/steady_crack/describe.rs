//! What a steady-crack scene simulates and leaves out, by which method, and its characteristic numbers.

use super::SteadyCrackPlan;
use crate::outcome::{Effect, Group};
use crate::plan::citations::{Citation, GREENWOOD, PERSSON_BRENER, RIVLIN_THOMAS, SCHAPERY_CLOSING, SCHAPERY_OPENING, THESIS};
use crate::scene::typed::{CohesiveLaw, CrackControl, ProcessZoneLaw, Theory, Units};
use viscotack::crack::Motion;

impl SteadyCrackPlan {
    pub(super) fn effect_list(&self) -> Vec<Effect> {
        let terms = match self.crack.motion {
            Motion::Opening => self.plane_material.creep_terms().len(),
            Motion::Closing => self.plane_material.relaxation_terms().len(),
        };
        let elastic = self.plane_material.is_elastic();
        let (growing, law) = match self.crack.process_zone {
            ProcessZoneLaw::Length(_) => (false, "adhesion.process_zone.length fixes it"),
            ProcessZoneLaw::Cohesive { law: CohesiveLaw::Constant, .. } => (false, "law = \"constant\": its length at G = Δγ"),
            ProcessZoneLaw::Cohesive { law: CohesiveLaw::Growing, .. } => {
                (true, "law = \"growing\": with the square of the stress intensity")
            }
            ProcessZoneLaw::Cohesive { law: CohesiveLaw::Schapery, .. } => (true, "law = \"schapery\": by Schapery's closing zone"),
        };
        let theory = |theory: Theory| self.crack.theories.contains(&theory);
        let named = |on: bool| if on { "named in crack.theories, or the default" } else { "not named in crack.theories" }.to_owned();
        vec![
            Effect { name: "adhesion", on: true, why: "[adhesion] is given".into() },
            Effect {
                name: "memory",
                on: !elastic,
                why: if elastic {
                    "the material has no creep or relaxation terms".into()
                } else {
                    if terms == 1 { "1 term".into() } else { format!("{terms} terms") }
                },
            },
            Effect {
                name: "flow",
                on: self.plane_material.steady_viscosity().is_some(),
                why: if self.plane_material.steady_viscosity().is_some() {
                    "the relaxed modulus is 0".into()
                } else {
                    "the material is a solid".into()
                },
            },
            Effect { name: "process-zone growth", on: growing, why: law.into() },
            Effect { name: "virtual work", on: theory(Theory::VirtualWork), why: named(theory(Theory::VirtualWork)) },
            Effect { name: "Persson–Brener", on: theory(Theory::PerssonBrener), why: named(theory(Theory::PerssonBrener)) },
            Effect { name: "cohesive zone", on: theory(Theory::CohesiveZone), why: named(theory(Theory::CohesiveZone)) },
            self.strip_effect(),
            self.field_effect(),
            Effect { name: "sweep", on: self.swept, why: if self.swept { "[sweep] is given" } else { "no [sweep]" }.into() },
        ]
    }

    fn strip_effect(&self) -> Effect {
        let on = matches!(self.crack.control, CrackControl::Strip(_));
        Effect { name: "strip", on, why: if on { "[crack.strip] is the load" } else { "the load or speed is given directly" }.into() }
    }

    fn field_effect(&self) -> Effect {
        let virtual_work = self.crack.theories.contains(&Theory::VirtualWork);
        let (on, why) = match (self.crack.fields.is_some(), virtual_work) {
            (true, true) => (true, "[fields] is given; for the virtual-work theory"),
            (true, false) => (false, "[fields] is given, but crack.theories leaves virtual_work out"),
            (false, _) => (false, "no [fields]"),
        };
        Effect { name: "fields", on, why: why.into() }
    }

    pub(super) fn sentences(&self) -> Vec<String> {
        let mut sentences = Vec::new();
        for &theory in &self.crack.theories {
            sentences.push(
                match (theory, self.crack.motion) {
                    (Theory::VirtualWork, Motion::Opening) => {
                        "virtual work, opening: the double integral (5.19) collapses exactly to the running mean of the creep function"
                    }
                    (Theory::VirtualWork, Motion::Closing) => {
                        "virtual work, closing: the double integral (5.37) collapses exactly to the running mean of the relaxation function"
                    }
                    (Theory::PerssonBrener, _) => {
                        "Persson–Brener: loss integral over the modes outside a cut-off, in closed form for each term"
                    }
                    (Theory::CohesiveZone, _) => {
                        "cohesive zone: means of the creep function over a zone of constant stress, by Dawson's integral"
                    }
                }
                .to_owned(),
            );
        }
        sentences.push(
            match self.crack.control {
                CrackControl::Speed(0.0) => "speed zero: the exact limit, no root",
                CrackControl::Speed(_) => "one monotone root in the logarithm of the crossing time at the given speed",
                _ => "one monotone root in the logarithm of the crossing time under the given load",
            }
            .to_owned(),
        );
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
            groups.push(Group {
                name: "stress intensity at G = Δγ".into(),
                value: self.crack.body.intensity_squared(self.crack.work_of_adhesion, material.relaxed_modulus()).sqrt()
                    * if self.units == Units::Si { 1.0 } else { 0.5_f64.sqrt() },
                unit: unit("Pa √m", "√(2E0Δγ)"),
            });
        }
        if let ProcessZoneLaw::Cohesive { cohesive_stress, .. } = self.crack.process_zone
            && material.relaxed_modulus() > 0.0
        {
            let zone = self.relaxed_zone(cohesive_stress);
            groups.push(Group { name: "relaxed zone a₀".into(), value: zone, unit: unit("m", "a₀") });
            if let Some(time) = material.longest_retardation_time() {
                groups.push(Group { name: "slowest speed scale a₀/τ_max".into(), value: zone / time, unit: unit("m/s", "a₀/τ") });
            }
            if let Some(term) = material.creep_terms().last() {
                groups.push(Group {
                    name: "fastest speed scale a₀/τ_min".into(),
                    value: zone / term.retardation_time,
                    unit: unit("m/s", "a₀/τ"),
                });
            }
        }
        groups
    }

    pub(super) fn papers(&self) -> Vec<&'static Citation> {
        let mut papers = vec![&THESIS];
        for &theory in &self.crack.theories {
            match (theory, self.crack.motion) {
                (Theory::PerssonBrener, _) => papers.push(&PERSSON_BRENER),
                (Theory::CohesiveZone, Motion::Opening) => papers.extend([&SCHAPERY_OPENING, &GREENWOOD]),
                (Theory::CohesiveZone, Motion::Closing) => papers.extend([&SCHAPERY_CLOSING, &GREENWOOD]),
                (Theory::VirtualWork, _) => {}
            }
        }
        if let ProcessZoneLaw::Cohesive { law: CohesiveLaw::Schapery, .. } = self.crack.process_zone
            && !papers.contains(&&SCHAPERY_CLOSING)
        {
            papers.push(&SCHAPERY_CLOSING);
        }
        if matches!(self.crack.control, CrackControl::Strip(_)) {
            papers.push(&RIVLIN_THOMAS);
        }
        papers
    }
}
