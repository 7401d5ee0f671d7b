//! What a plan says of itself: effects, method, characteristic numbers, validity, papers.

use super::SurfacePlan;
use crate::outcome::{Effect, Group, Row, Validity};
use crate::plan::assumptions::{Assumption, Limit, assessed, constant_poisson_ratio, not_assessed};
use crate::plan::citations::{CONTMECH, Citation, GREENWOOD_1997, PRIMAL_DUAL, THESIS};
use crate::scene::typed::{SlidingContact, SurfaceLoad, SurfacePath, SurfaceTask, Units};
use viscotack::sliding::layer::Backing;

/// The assumptions, in the order of [`SurfacePlan::assumptions`].
const ASSUMPTIONS: [Assumption; 2] = [
    Assumption {
        name: "root mean square slope of the surface",
        limit: Limit::Below(0.3),
        meaning: "linear elasticity of a half-space wants slopes well below one",
    },
    Assumption {
        name: "largest tension over glassy modulus",
        limit: Limit::Below(0.3),
        meaning: "the material where the law pulls must stay linear",
    },
];

impl SurfacePlan {
    pub(super) fn effect_list(&self) -> Vec<Effect> {
        let effect = |name, on: bool, yes: String, no: &str| Effect { name, on, why: if on { yes } else { no.to_owned() } };
        let sliding = &self.sliding;
        vec![
            effect(
                "adhesion at a distance",
                sliding.contacts.contains(&SlidingContact::Adhesive),
                format!("law {:?}", sliding.attraction.as_ref().map_or("", |law| law.word)),
                "no law of attraction, or only contacts without adhesion are asked for",
            ),
            effect(
                "contact without adhesion",
                sliding.contacts.contains(&SlidingContact::Adhesiveless),
                "asked for".into(),
                "not asked for",
            ),
            effect(
                "dissipation in the solid",
                !self.material.is_elastic() && sliding.speed != 0.0,
                "the solid has a memory and slides".into(),
                "the solid is elastic, or at rest",
            ),
            effect("layer", self.layer.is_some(), "[sliding.layer] is given".into(), "no [sliding.layer]: a half-space"),
            effect(
                "counter body",
                sliding.counter_body.is_some(),
                "[sliding.counter_body] is given".into(),
                "no [sliding.counter_body]: the sliding surface is rigid",
            ),
            effect("both directions", !self.is_line(), "[sliding.surface] is given".into(), "a line: nothing varies across the motion"),
            effect(
                "loop of the load",
                matches!(sliding.task, SurfaceTask::Loop { .. }),
                "[sliding.loop] is given".into(),
                "no [sliding.loop]",
            ),
            effect(
                "branch with its folds",
                matches!(sliding.task, SurfaceTask::Branch { .. }),
                "[sliding.branch] is given".into(),
                "no [sliding.branch]",
            ),
            effect("fields", sliding.field_points.is_some(), "[fields] is given".into(), "no [fields]"),
            effect("sweep", self.swept, "[sweep] is given".into(), "no [sweep]"),
        ]
    }

    pub(super) fn sentences(&self) -> Vec<String> {
        let mut sentences = vec![
            "in the frame of the sliding surface all is steady: each wave of the pressure meets the complex modulus at one frequency, and the stress between the surfaces is the law at their gap; one nonlinear system on a grid, by fast Fourier transforms".to_owned(),
            "contact set and law together by a semi-smooth Newton method; linear systems by GMRES; eigenvalues of the linearised equations by Arnoldi's method".to_owned(),
            "grids are doubled until the accuracy is met; the error of a number is the larger of its last two changes, of earlier ones with their decay".to_owned(),
        ];
        sentences.push(
            match (self.sliding.task, self.sliding.reached_by) {
                (SurfaceTask::Loop { .. }, _) => "each state of the loop is followed from the one before; where that is lost in spite of short steps the contact jumps to the state that a long range of the law leads to",
                (SurfaceTask::Branch { .. }, _) => "the branch is followed by arclength in mean gap and mean pressure, each state then on two finer grids; folds are located on three grids",
                (_, SurfacePath::LongRange) => "the state is the one to which a long range of the law leads at the same load; several may exist",
                (_, SurfacePath::Every) => "every state that a search finds: profiles lifted by several parts of their height, from several ranges of the law; there may be more",
                (_, SurfacePath::Loading) => "the state is followed from a light contact by raising the load; several may exist",
                (_, SurfacePath::Unloading) => "the state is followed from a heavy contact by lowering the load; several may exist",
            }
            .to_owned(),
        );
        sentences.extend(self.sliding.surface.notes.iter().cloned());
        sentences.extend(self.sliding.attraction.iter().flat_map(|law| law.notes.iter().cloned()));
        sentences
    }

    pub(super) fn characteristic_numbers(&self) -> Vec<Group> {
        let si = self.units == Units::Si;
        let unit = |si_unit: &'static str, reduced: &'static str| if si { si_unit } else { reduced };
        let group = |name: &str, value: f64, unit: &str| Group { name: name.into(), value, unit: unit.into() };
        let slope = self.slope();
        let mut groups = vec![
            group("relaxed plane modulus E0*", self.material.relaxed_modulus(), unit("Pa", "E0*")),
            group("glassy plane modulus E∞*", self.material.glassy_modulus(), unit("Pa", "E0*")),
            group("stiffening β = E∞/E0", self.material.stiffening_ratio(), "1"),
            group("period along the sliding direction", self.sliding.surface.period, unit("m", "1/k")),
            group("half of the height from valley to peak", self.profile.half_height() * self.scales.height, unit("m", "Λ")),
            group("root mean square slope", slope, unit("1", "kΛ")),
            group("unit of pressure E0*kΛ/2", self.scales.pressure, unit("Pa", "E0*kΛ/2")),
            group("nodes of the profile", self.profile.nodes()[0] as f64, "1"),
        ];
        if let Some(law) = &self.sliding.attraction {
            let law = &law.attraction;
            groups.extend([
                group("range of the law", law.range, unit("m", "Λ")),
                group("largest tension", law.peak_stress(), unit("Pa", "E0*kΛ/2")),
                group("work of adhesion", law.work_of_adhesion, unit("J/m²", "E0*kΛ²/2")),
            ]);
            if let Ok(reduced) = self.attraction(SlidingContact::Adhesive) {
                groups.push(group("adhesion Γ = Δγ/(πE0*kΛ²)", reduced.work_of_adhesion / std::f64::consts::TAU, "1"));
                let zone = std::f64::consts::FRAC_2_PI * reduced.work_of_adhesion / reduced.peak_stress().powi(2);
                groups.push(group("relaxed zone a₀ = E0*Δγ/(π peak²)", zone * self.scales.length, unit("m", "1/k")));
            }
        }
        if let Some(layer) = self.layer {
            groups.push(group("thickness kd", layer.thickness_times_wave_number(), "1"));
        }
        if let SurfaceLoad::MeanPressure(pressure) = self.sliding.control {
            groups.push(group("reduced load", pressure / self.scales.pressure, "1"));
        }
        if let Some(longest) = self.material.longest_retardation_time() {
            groups.push(group("kv·τ_max", self.frequency() * longest, "1"));
        }
        groups
    }

    pub(super) fn assessments(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = assessed(&ASSUMPTIONS, rows);
        entries.extend(constant_poisson_ratio(self.poisson_ratio));
        entries.push(not_assessed(
            "stability",
            None,
            "of steady disturbances only, by the negative eigenvalues of the linearised equations on two grids: a disturbance may still grow while it oscillates",
        ));
        if self.layer.is_some_and(|layer| layer.backing() == Backing::Free) {
            entries.push(not_assessed(
                "free layer",
                None,
                "its far face is pressed by a uniform pressure that carries the load; thin layers bend far",
            ));
        }
        entries.push(not_assessed(
            "inertia and heat",
            None,
            "left out: speeds must stay far below the shear-wave speed, and the surface isothermal",
        ));
        entries.push(not_assessed(
            "dry contact",
            None,
            "assumed: no fluid, no air trapped in the gap, and no shear stress at the interface itself",
        ));
        entries
    }

    pub(super) fn papers(&self) -> Vec<&'static Citation> {
        let mut papers = vec![&THESIS, &PRIMAL_DUAL];
        if let Some(law) = &self.sliding.attraction {
            if law.word == "lennard_jones" {
                papers.push(&GREENWOOD_1997);
            }
            if law.word == "cosine" {
                papers.push(&CONTMECH);
            }
        }
        papers
    }
}
