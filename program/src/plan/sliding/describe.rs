//! What a sliding scene simulates and leaves out, by which method, and its characteristic numbers.

use super::SlidingPlan;
use crate::outcome::{Effect, Group};
use crate::plan::citations::{Citation, JOHNSON_WAVE, THESIS, WESTERGAARD};
use crate::scene::typed::{BranchParameter, SlidingColumns, SlidingContact, SlidingLoad, SlidingTask, SlidingZone, Units};

impl SlidingPlan {
    fn solves(&self, contact: SlidingContact) -> bool {
        self.sliding.contacts.contains(&contact)
    }

    pub(super) fn effect_list(&self) -> Vec<Effect> {
        let (adhesive, adhesiveless) = (self.solves(SlidingContact::Adhesive), self.solves(SlidingContact::Adhesiveless));
        let terms = self.material.creep_terms().len();
        let adhesion = match (self.sliding.adhesion.is_some(), adhesive) {
            (true, true) => "[adhesion] is given",
            (true, false) => "[adhesion] is given, but sliding.contacts leaves \"adhesive\" out",
            (false, _) => "no [adhesion]",
        };
        let without_adhesion = match (adhesiveless, self.sliding.adhesion.is_some()) {
            (true, false) => "no [adhesion]: both edges without a singular stress",
            (true, true) => "named in sliding.contacts",
            (false, _) => "not named in sliding.contacts",
        };
        let memory = if terms == 0 {
            "the material has no creep or relaxation terms".to_owned()
        } else if terms == 1 {
            "1 term".to_owned()
        } else {
            format!("{terms} terms")
        };
        let counter_body = match self.sliding.counter_body {
            Some(_) => "[sliding.counter_body] is given; it rides with the contact, so only its relaxed modulus matters",
            None => "no [sliding.counter_body]: the sliding body is rigid",
        };
        vec![
            Effect { name: "adhesion", on: adhesive, why: adhesion.into() },
            Effect { name: "adhesiveless twin", on: adhesiveless, why: without_adhesion.into() },
            Effect { name: "memory", on: terms > 0, why: memory },
            Effect { name: "elastic counter body", on: self.sliding.counter_body.is_some(), why: counter_body.into() },
            Effect {
                name: "work of adhesion by speed",
                on: self.sliding.work_by_speed.is_some(),
                why: if self.sliding.work_by_speed.is_some() { "[adhesion.by_speed] is given" } else { "no [adhesion.by_speed]" }.into(),
            },
            Effect {
                name: "fields",
                on: self.sliding.field_points.is_some(),
                why: if self.sliding.field_points.is_some() { "[fields] is given" } else { "no [fields]" }.into(),
            },
            Effect {
                name: "branch",
                on: matches!(self.sliding.task, SlidingTask::Branch(_)),
                why: match &self.sliding.task {
                    SlidingTask::Branch(branch) => format!("[sliding.branch] is given, along {}", branch.parameter.word()),
                    _ => "no [sliding.branch]".into(),
                },
            },
            Effect {
                name: "strength",
                on: self.sliding.task == SlidingTask::Strength,
                why: if self.sliding.task == SlidingTask::Strength { "[sliding.strength] is given" } else { "no [sliding.strength]" }
                    .into(),
            },
            Effect { name: "sweep", on: self.swept, why: if self.swept { "[sweep] is given" } else { "no [sweep]" }.into() },
        ]
    }

    pub(super) fn sentences(&self) -> Vec<String> {
        let mut sentences = vec![
            "a contact with given edges is an elastic one under as many outside loads as there are creep terms: one small linear system each, no mesh"
                .to_owned(),
        ];
        if self.solves(SlidingContact::Adhesive) {
            sentences.push(
                "adhesive: at each edge the work of the tension inside the moved edge on the gap outside the old one equals Δγδ (3.26–3.30); two equations for two edges"
                    .to_owned(),
            );
        }
        if matches!(self.sliding.adhesion.map(|adhesion| adhesion.process_zone), Some(SlidingZone::Cohesive { grows: true, .. })) {
            sentences.push(
                "process zones grow with their edges: αa₀G/Δγ where the contact opens, αa₀Δγ/G where it closes, G of one edge at that speed; where one is longer than a tenth of the contact, a law of attraction (adhesion.law) has no such limit"
                    .to_owned(),
            );
        }
        for (columns, sentence) in [
            (
                SlidingColumns::FrictionParts,
                "friction of the edges is G₁ − G₂ over the wavelength (3.40), that of the bulk the rest of the friction",
            ),
            (
                SlidingColumns::ElasticReference,
                "elastic reference contact: the same contact of an elastic solid with the modulus |E*(ω)| at ω = kv",
            ),
            (SlidingColumns::Sensitivities, "sensitivities: implicit derivatives of the solved equations, two resolutions compared"),
        ] {
            if self.asks(columns) {
                sentences.push(sentence.to_owned());
            }
        }
        if self.solves(SlidingContact::Adhesiveless) {
            sentences.push("adhesiveless: no singular stress at either edge; two equations for two edges".to_owned());
        }
        if self.sliding.task != SlidingTask::State {
            sentences.push(
                "the curve of contacts is followed by arclength in its unknowns, past its turns; turns are solved with the condition that they turn, at two resolutions"
                    .to_owned(),
            );
            sentences.push(match &self.sliding.task {
                SlidingTask::Branch(branch) if branch.parameter == BranchParameter::Speed => {
                    "from the slow contact and, where that turns back, from the fast one; stability by how the work of each edge follows both edges".to_owned()
                }
                SlidingTask::Branch(_) => {
                    "stability by how the work of each edge follows both edges, under a held load and under a held penetration".to_owned()
                }
                _ => "the work to separate is the integral of the load over the penetration, by Gauss's rule in ln tan(a/2), two rules compared (3.41)".to_owned(),
            });
            return sentences;
        }
        sentences.push(
            match (self.sliding.speed == 0.0 && !self.swept, self.material.is_elastic()) {
                (true, _) => "speed zero: the relaxed contact",
                (_, true) => "elastic: the same contact at every speed, without friction",
                _ => "every contact of the speed is found half-width by half-width: the equilibrium curve, which gives the contacts of what is held, their stability and their limits",
            }
            .to_owned(),
        );
        if self.is_wave() && matches!(self.sliding.control, SlidingLoad::MeanPressure(_)) {
            sentences.push("where no partial contact exists above snap-in, the full contact in closed form, state \"full\"".to_owned());
        }
        sentences
    }

    pub(super) fn characteristic_numbers(&self) -> Vec<Group> {
        let si = self.units == Units::Si;
        let (modulus_unit, pressure_unit, length_unit) = match (si, self.is_wave()) {
            (true, _) => ("Pa", "Pa", "m"),
            (false, true) => ("E0*", "E0*kΛ/2", "1/k"),
            (false, false) => ("E0*", "E0*L/2R", "L"),
        };
        let group = |name: &str, value: f64, unit: &str| Group { name: name.into(), value, unit: unit.into() };
        let mut groups = vec![
            group("relaxed plane modulus E0*", self.material.relaxed_modulus(), modulus_unit),
            group("glassy plane modulus E∞*", self.material.glassy_modulus(), modulus_unit),
            group("stiffening β = E∞/E0", self.material.stiffening_ratio(), "1"),
        ];
        if si {
            let (length, slope, pressure) = if self.is_wave() {
                ("unit of length 1/k", "slope kΛ", "pressure of full contact E0*kΛ/2")
            } else {
                ("unit of length L", "slope L/R", "unit of pressure E0*L/2R")
            };
            groups.extend([
                group(length, self.scale.length, length_unit),
                group(slope, self.scale.slope, "1"),
                group(pressure, self.scale.pressure, pressure_unit),
            ]);
        }
        match self.sliding.control {
            SlidingLoad::MeanPressure(load) | SlidingLoad::LoadPerWidth(load) => {
                groups.push(group("reduced load", load / self.scale.load, "1"));
            }
            SlidingLoad::Penetration(depth) => groups.push(group("penetration Δ/Λ", depth / self.scale.displacement, "1")),
            SlidingLoad::HalfWidth(width) => groups.push(group("reduced half-width", width / self.scale.length, "1")),
            SlidingLoad::Every => {}
        }
        if self.solves(SlidingContact::Adhesive)
            && let (Some(adhesion), Some(given)) = (self.reduced_adhesion(), self.sliding.adhesion)
        {
            if self.is_wave() {
                groups.push(group("adhesion Γ = Δγ/(πE0*kΛ²)", adhesion.trailing_work, "1"));
                groups.push(group("Johnson's α = 2√Γ", 2.0 * adhesion.trailing_work.sqrt(), "1"));
            } else {
                groups.push(group("adhesion Γ = ΔγR²/(πE0*L³)", adhesion.trailing_work, "1"));
            }
            if !adhesion.is_even() {
                groups.push(group(
                    "the same of the leading edge, over the trailing one's",
                    adhesion.leading_work / adhesion.trailing_work,
                    "1",
                ));
            }
            match given.process_zone {
                SlidingZone::Lengths { trailing, leading } if trailing.to_bits() != leading.to_bits() => {
                    groups.push(group("trailing process zone", trailing, length_unit));
                    groups.push(group("leading process zone", leading, length_unit));
                }
                SlidingZone::Cohesive { grows: true, .. } => {
                    groups.push(group("trailing process zone, grown", adhesion.trailing_zone * self.scale.length, length_unit));
                    groups.push(group("leading process zone, grown", adhesion.leading_zone * self.scale.length, length_unit));
                }
                _ => groups.push(group("process zone δ", adhesion.trailing_zone * self.scale.length, length_unit)),
            }
        }
        let fastest = self.speeds.iter().fold(0.0, |fastest: f64, speed| fastest.max(speed.abs()));
        let symbol = if self.is_wave() { "kv" } else { "v/L" };
        if let (Some(longest), Some(shortest)) = (self.material.longest_retardation_time(), self.material.creep_terms().last()) {
            let at = if self.speeds.len() > 1 { " at the largest speed" } else { "" };
            groups.push(group(&format!("{symbol}·τ_max{at}"), self.rate(fastest) * longest, "1"));
            if self.material.creep_terms().len() > 1 {
                groups.push(group(&format!("{symbol}·τ_min{at}"), self.rate(fastest) * shortest.retardation_time, "1"));
            }
        }
        groups
    }

    pub(super) fn papers(&self) -> Vec<&'static Citation> {
        let mut papers = vec![&THESIS];
        if self.is_wave() && self.solves(SlidingContact::Adhesive) {
            papers.push(&JOHNSON_WAVE);
        }
        if self.is_wave() && self.solves(SlidingContact::Adhesiveless) {
            papers.push(&WESTERGAARD);
        }
        papers
    }
}
