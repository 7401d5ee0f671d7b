//! What a scene with attraction at a distance simulates and leaves out, by which method, and its characteristic numbers.

use super::super::columns::has_measured_force;
use super::FiniteRangePlan;
use crate::outcome::{Effect, Group};
use crate::plan::citations::{Citation, GREENWOOD_1997, JKR, KENNEDY_CARPENTER, MAGHAMI};
use crate::scene::typed::{IndentationShape, IndentationStart, Units};

impl FiniteRangePlan {
    pub(super) fn effect_list(&self) -> Vec<Effect> {
        let terms = self.material.creep_terms().len();
        let memory = match terms {
            0 => "the material has no creep or relaxation terms".to_owned(),
            1 => "1 term".to_owned(),
            _ => format!("{terms} terms"),
        };
        let given = |on: bool, yes: &str, no: &str| if on { yes.to_owned() } else { no.to_owned() };
        let relaxed = self.indentation.start == IndentationStart::Relaxed;
        let frame = self.indentation.frame_stiffness.is_some();
        let overlay = has_measured_force(&self.indentation);
        let fields = self.indentation.fields.is_some();
        let body = self.indentation.counter_body;
        let second = match body {
            None => "no [indentation.counter_body]: the indenter is rigid",
            Some(body) if body.elastic.is_some() => "[indentation.counter_body] is elastic: its compliance adds at every time",
            Some(_) => "[indentation.counter_body] is rigid; of two spheres R* = R1 R2/(R1 + R2) counts",
        };
        let word = self.attraction.word;
        let effect = |name, on, why| Effect { name, on, why };
        vec![
            effect("attraction of finite range", true, format!("adhesion gives the law \"{word}\": the surfaces attract at every gap")),
            effect("process zone", false, "no adhesion.process_zone: there is no edge".into()),
            effect("memory", terms > 0, memory),
            effect("second body", body.is_some(), second.into()),
            effect(
                "relaxed start",
                relaxed,
                given(
                    relaxed,
                    "indentation.start = \"relaxed\": the body has settled in the contact before time zero",
                    "indentation.start = \"untouched\": the body is without creep at time zero",
                ),
            ),
            effect("frame", frame, given(frame, "indentation.frame_stiffness is given", "no indentation.frame_stiffness: a rigid rig")),
            effect(
                "energies",
                self.indentation.energies,
                given(self.indentation.energies, "[indentation.energies] is given", "no [indentation.energies]"),
            ),
            effect(
                "oscillation",
                self.timeline.oscillates(),
                given(
                    self.timeline.oscillates(),
                    "every cycle is integrated; each is a row, of more than 2000 some",
                    "no segment of the history is an `oscillation`",
                ),
            ),
            effect("fields", fields, given(fields, "[indentation.fields] is given", "no [indentation.fields]")),
            effect(
                "measured force",
                overlay,
                given(
                    overlay,
                    "a table of the history has a column `force`",
                    "no table of the history has a column `force` it does not control",
                ),
            ),
            effect("sweep", self.swept, given(self.swept, "[sweep] is given", "no [sweep]")),
        ]
    }

    pub(super) fn sentences(&self) -> Vec<String> {
        let start = match self.indentation.start {
            IndentationStart::Relaxed => "start: the contact of the relaxed body",
            IndentationStart::Untouched => {
                "start: the body without creep, glassy; if it is near enough, its surface jumps into contact at once"
            }
        };
        let mut sentences: Vec<String> = [
            "the stress between the surfaces follows from their gap everywhere: no edge, no process zone",
            "collocation in the radius with elements of ten nodes that are halved and joined as the front moves",
            "each step of time is one of five implicit stages with one elastic contact each (ESDIRK 4(3)); a stage is solved by Newton's method",
            start,
            "events are found: the largest tension and the end of contact by a search inside of steps, jumps by descent to the next equilibrium down the energy",
            "errors by a second run with every tolerance tightened; the energy balance is checked over the whole history",
            "penetration 0: the undeformed apex is at the law's gap of zero stress; contact radius: where the gap is that of the largest tension",
        ]
        .map(str::to_owned)
        .to_vec();
        sentences.extend(super::super::locate::sentence(&self.timeline, 3));
        sentences.extend(self.advice.iter().cloned());
        sentences
    }

    pub(super) fn characteristic_numbers(&self) -> Vec<Group> {
        let si = self.units == Units::Si;
        let pick = |of_si: &'static str, reduced: &'static str| if si { of_si } else { reduced };
        let group = |name: &str, value: f64, unit: &str| Group { name: name.into(), value, unit: unit.into() };
        let law = &self.reduced.law;
        let [relaxed, glassy] = self.tabor_numbers();
        let mut groups = vec![
            group("relaxed modulus E0*", self.material.relaxed_modulus(), pick("Pa", "E0*")),
            group("glassy modulus E∞*", self.material.glassy_modulus(), pick("Pa", "E0*")),
            group("stiffening β = E∞/E0", self.material.stiffening_ratio(), "1"),
        ];
        if let Some(longest) = self.material.longest_relaxation_time() {
            groups.push(group("longest relaxation time", longest, pick("s", "reference time")));
        }
        groups.push(group("range of the law", law.range, pick("m", "R")));
        groups.push(group("largest tension of the law", law.peak_stress() / self.scale.force, pick("Pa", "πE0*")));
        groups.push(group("gap of zero stress", law.equilibrium_gap(), pick("m", "R")));
        groups.push(group("relaxed Tabor number", relaxed, "1"));
        groups.push(group("glassy Tabor number", glassy, "1"));
        groups.push(group("process zone of an edge with this peak", self.zone(), pick("m", "R")));
        if let IndentationShape::Sphere { radius } = self.indentation.shape {
            let pull_off = 1.5 * std::f64::consts::PI * radius * law.work_of_adhesion;
            groups.push(group("JKR pull-off (3/2)πRΔγ", pull_off / self.scale.force, pick("N", "πE0*R²")));
        }
        groups.push(group("duration of the history", self.timeline.duration(), pick("s", "reference time")));
        groups
    }

    pub(super) fn papers(&self) -> Vec<&'static Citation> {
        vec![&GREENWOOD_1997, &MAGHAMI, &KENNEDY_CARPENTER, &JKR]
    }
}
