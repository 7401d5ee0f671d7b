//! What an indentation scene simulates and leaves out, by which method, and its characteristic numbers.

use super::IndentationPlan;
use super::columns::has_measured_force;
use crate::outcome::{Effect, Group};
use crate::plan::citations::{Citation, JKR, LEE_RADOK, SNEDDON, THESIS, TING};
use crate::scene::typed::{HistoryQuantity, IndentationShape, IndentationStart, Units};

impl IndentationPlan {
    pub(super) fn effect_list(&self) -> Vec<Effect> {
        let terms = self.material.creep_terms().len();
        let memory = match terms {
            0 => "the material has no creep or relaxation terms".to_owned(),
            1 => "1 term".to_owned(),
            _ => format!("{terms} terms"),
        };
        let start = match self.indentation.start {
            IndentationStart::Relaxed => "indentation.start = \"relaxed\": the body has settled in the contact before time zero",
            IndentationStart::Untouched => "indentation.start = \"untouched\": the body is rested before time zero",
        };
        let given = |on: bool, yes: &str, no: &str| if on { yes.to_owned() } else { no.to_owned() };
        let adhesive = self.indentation.adhesion.is_some();
        let law = &self.indentation.edge_law;
        let two_works = law.leading_ratio < 1.0;
        let frame = self.indentation.frame_stiffness.is_some();
        let overlay = has_measured_force(&self.indentation);
        let fields = self.indentation.fields.is_some();
        vec![
            Effect {
                name: "adhesion",
                on: adhesive,
                why: given(adhesive, "[adhesion] is given", "no [adhesion]: the load vanishes at the edge"),
            },
            Effect {
                name: "two works of adhesion",
                on: two_works,
                why: given(
                    two_works,
                    "the leading work is below the trailing one: an edge between them rests",
                    "the edge takes the same to open as it gives to close",
                ),
            },
            Effect {
                name: "work of adhesion by speed",
                on: law.by_speed.is_some(),
                why: given(
                    law.by_speed.is_some(),
                    "[adhesion.by_speed] is given, of the speed of the edge; beyond a table its ends are held",
                    "no [adhesion.by_speed]",
                ),
            },
            Effect {
                name: "process-zone growth",
                on: law.growing_zone,
                why: given(law.growing_zone, "law = \"growing\": with the square of the stress intensity", "the process zone is constant"),
            },
            Effect { name: "memory", on: terms > 0, why: memory },
            Effect { name: "second body", on: self.indentation.counter_body.is_some(), why: self.second_body() },
            Effect { name: "relaxed start", on: self.indentation.start == IndentationStart::Relaxed, why: start.into() },
            Effect {
                name: "frame",
                on: frame,
                why: given(frame, "indentation.frame_stiffness is given", "no indentation.frame_stiffness: a rigid rig"),
            },
            Effect {
                name: "energies",
                on: self.indentation.energies,
                why: given(self.indentation.energies, "[indentation.energies] is given", "no [indentation.energies]"),
            },
            Effect {
                name: "oscillation",
                on: self.timeline.oscillates(),
                why: match self.oscillating_cycles() {
                    None => "no segment of the history is an `oscillation`".to_owned(),
                    Some(cycles) => format!("the history has about {} cycles; each is a row, of more than 2000 some", cycles.round()),
                },
            },
            Effect { name: "fields", on: fields, why: given(fields, "[indentation.fields] is given", "no [indentation.fields]") },
            Effect {
                name: "measured force",
                on: overlay,
                why: given(
                    overlay,
                    "a table of the history has a column `force`",
                    "no table of the history has a column `force` it does not control",
                ),
            },
            Effect { name: "sweep", on: self.swept, why: given(self.swept, "[sweep] is given", "no [sweep]") },
        ]
    }

    /// What the second body changes.
    fn second_body(&self) -> String {
        let Some(body) = self.indentation.counter_body else { return "no [indentation.counter_body]: the indenter is rigid".into() };
        let elastic = if body.elastic.is_some() {
            "[indentation.counter_body] is elastic: its compliance adds at every time"
        } else {
            "[indentation.counter_body] is rigid"
        };
        match (body.radius, &self.indentation.shape) {
            (Some(_), IndentationShape::Sphere { radius }) => format!("{elastic}; two spheres, R* = R1 R2/(R1 + R2) = {radius:.6e} m"),
            _ => elastic.into(),
        }
    }

    /// Cycles of all oscillations, at most; none without an oscillation.
    fn oscillating_cycles(&self) -> Option<f64> {
        self.timeline.oscillates().then(|| self.timeline.legs.iter().map(super::timeline::Leg::cycles).sum())
    }

    pub(super) fn sentences(&self) -> Vec<String> {
        let mut sentences = vec![
            "the contact is carried to a line on which every place is a spring chain of its own: no mesh of the body, no matrix (Sneddon's transform)".to_owned(),
        ];
        let integrated = !self.without_steps;
        if integrated {
            sentences
                .push("each step of time is exact for an edge and a penetration that move straight, for any number of terms".to_owned());
        }
        if self.flow.is_some() && integrated {
            sentences
                .push("the liquid flows by an element whose retardation time is 1e8 histories: what that changes is in the bounds".into());
        }
        if self.indentation.adhesion.is_some() {
            sentences
                .push("at the edge the work of the tension inside on the gap outside, over the process zone, equals Δγδ (4.9)".to_owned());
            sentences.push(match self.indentation.start {
                IndentationStart::Untouched => "first touch: the glassy contact jumps in".to_owned(),
                IndentationStart::Relaxed => "start: the soft elastic contact at the same process zone".to_owned(),
            });
            if self.profile.rim().is_finite() {
                sentences.push("beyond the rim only opening since the rim last released counts as a gap".to_owned());
            }
            sentences.push("events are found: jumps of the edge to another equilibrium, and detachment where none is left".to_owned());
        } else {
            sentences.push(
                "without adhesion the load vanishes at the edge: Lee and Radok's contact advancing, Ting's and Graham's receding"
                    .to_owned(),
            );
            if !integrated {
                sentences.push(
                    "every place knows when the edge passes it, as a root of its own: exact for any number of terms and turns, without steps in time"
                        .to_owned(),
                );
            }
        }
        if self.timeline.oscillates() {
            let followed = if self.timeline.periodic {
                "one cycle repeats itself for ever: every chain is closed over it, and the path of the edge is the one that a cycle leads back to (Anderson)"
            } else if integrated {
                "every cycle of an oscillation is integrated"
            } else {
                "cycles of an oscillation are followed until each repeats the last one"
            };
            sentences.push(format!("{followed}; its stiffness is that of the fundamental, its work ∮F dΔ"));
        }
        sentences.push(
            if self.timeline.periodic {
                "errors by a second path, of other steps, and by two cycles integrated from the one that was found"
            } else if integrated {
                "errors: the same history again with other steps"
            } else {
                "errors by a second, coarser solution"
            }
            .to_owned(),
        );
        sentences.extend(super::locate::sentence(&self.timeline, 10));
        sentences.extend(self.called_for.clone());
        sentences
    }

    pub(super) fn characteristic_numbers(&self) -> Vec<Group> {
        let si = self.units == Units::Si;
        let pick = |of_si: &'static str, reduced: &'static str| if si { of_si } else { reduced };
        let group = |name: &str, value: f64, unit: &str| Group { name: name.into(), value, unit: unit.into() };
        let glassy = self.material.glassy_modulus();
        let mut groups = vec![
            group("relaxed modulus E0*", if self.flow.is_some() { 0.0 } else { self.relaxed }, pick("Pa", "E0*")),
            group("glassy modulus E∞*", glassy, pick("Pa", "E0*")),
        ];
        // A liquid has no other modulus to be stiffer than.
        groups.push(match self.flow {
            None => group("stiffening β = E∞/E0", self.material.stiffening_ratio(), "1"),
            Some(viscosity) => group("steady viscosity η*", viscosity, "Pa s"),
        });
        if let Some(longest) = self.material.longest_relaxation_time().filter(|_| self.flow.is_none()) {
            groups.push(group("longest relaxation time", longest, pick("s", "reference time")));
        }
        if let Some(adhesion) = self.adhesion() {
            if let IndentationShape::Sphere { radius } = self.indentation.shape {
                if self.flow.is_none() {
                    groups.push(group(
                        "adhesion γ̃ = Δγ/(πE0*R)",
                        adhesion.work_of_adhesion / (std::f64::consts::PI * self.relaxed * radius),
                        "1",
                    ));
                }
                let pull_off = 1.5 * std::f64::consts::PI * radius * adhesion.work_of_adhesion;
                groups.push(group("JKR pull-off (3/2)πRΔγ", pull_off / self.scale.force, pick("N", "πE0*R²")));
            }
            groups.push(group("process zone δ", adhesion.process_zone, pick("m", "R")));
        }
        for leg in &self.timeline.legs {
            let Some(oscillation) = leg.oscillation else { continue };
            let unit = pick("1/s", "1/reference time");
            let (from, to) = (oscillation.frequency, oscillation.end_frequency);
            groups.push(group(&format!("frequency of history.{}", leg.segment), from, unit));
            if to.to_bits() != from.to_bits() {
                groups.push(group(&format!("frequency of history.{} at its end", leg.segment), to, unit));
            }
            if let Some(longest) = self.material.longest_relaxation_time() {
                groups.push(group(&format!("ωρ of history.{}, longest ρ", leg.segment), std::f64::consts::TAU * from * longest, "1"));
            }
            if !self.timeline.periodic {
                groups.push(group(&format!("cycles of history.{}", leg.segment), leg.cycles(), "1"));
            }
        }
        // With a rate after another control, or a condition, it is known when the history is solved.
        if self.timeline.open.is_empty() {
            groups.push(group("duration of the history", self.timeline.duration(), pick("s", "reference time")));
        }
        let way = self.timeline.way(HistoryQuantity::Penetration);
        if way > 0.0 {
            groups.push(group("way of the penetration", way, pick("m", "R")));
        }
        groups
    }

    pub(super) fn papers(&self) -> Vec<&'static Citation> {
        let mut papers = vec![&THESIS, &SNEDDON];
        if self.indentation.adhesion.is_some() {
            papers.push(&JKR);
        } else {
            papers.extend([&LEE_RADOK, &TING]);
        }
        papers
    }
}
