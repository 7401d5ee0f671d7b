//! The columns of a sliding contact's table, and what each is measured in.

use super::scale::Scale;
use crate::outcome::Column;
use crate::scene::typed::{Sliding, SlidingIndenter, SlidingTask, Units};

/// What a column measures.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Measure {
    Speed,
    Length,
    Displacement,
    Load,
    Friction,
    Coefficient,
    /// An energy release rate of the trailing edge, over its work of adhesion.
    Release,
    /// The same of the leading edge.
    LeadingRelease,
    Energy,
    Adhesion,
    Modulus,
    Number,
    /// A quotient of outputs: as accurate as they are, which its own bound tells.
    Ratio,
}

/// A column, with the name that it has for a cylinder.
pub(super) struct Definition {
    pub(super) name: &'static str,
    pub(super) of_cylinder: &'static str,
    pub(super) measure: Measure,
    pub(super) meaning: &'static str,
}

/// Positions of the columns in a row.
pub(super) mod at {
    pub(crate) const SPEED: usize = 0;
    pub(crate) const HALF_WIDTH: usize = 1;
    pub(crate) const ECCENTRICITY: usize = 2;
    pub(crate) const FRICTION: usize = 3;
    pub(crate) const COEFFICIENT: usize = 4;
    pub(crate) const TRAILING_RELEASE: usize = 5;
    pub(crate) const LEADING_RELEASE: usize = 6;
    pub(crate) const LOAD: usize = 7;
    pub(crate) const ADHESIVE_FRICTION: usize = 10;
    pub(crate) const TRAILING_NONCONSERVATIVE: usize = 11;
    pub(crate) const LEADING_NONCONSERVATIVE: usize = 12;
    pub(crate) const TRAILING_ZONE: usize = 13;
    pub(crate) const LEADING_ZONE: usize = 14;
    /// A cylinder's columns end before this one.
    pub(crate) const PENETRATION: usize = 15;
}

/// Positions of the columns of a strength.
pub(super) mod strength {
    pub(crate) const PULL_OFF: usize = 2;
    pub(crate) const SNAP_IN: usize = 7;
    pub(crate) const TOUGHNESS: usize = 13;
}

pub(super) const fn column(name: &'static str, measure: Measure, meaning: &'static str) -> Definition {
    Definition { name, of_cylinder: name, measure, meaning }
}

pub(super) static COLUMNS: [Definition; 17] = [
    column("speed", Measure::Speed, "v of the sliding body along +x; negative mirrors the contact."),
    column("half_width", Measure::Length, "a, half the width of the contact; accuracy relative to at least 1/k, of a cylinder L."),
    column("eccentricity", Measure::Length, "e, the middle of the contact ahead of the crest along +x; accuracy as of the half-width."),
    Definition {
        name: "friction_stress",
        of_cylinder: "friction_per_width",
        measure: Measure::Friction,
        meaning: "Force against the motion, of a wave over the nominal area; accuracy relative to at least its unit in reduced scenes.",
    },
    column(
        "friction_coefficient",
        Measure::Coefficient,
        "Friction over load, where the load presses; accuracy relative to at least kΛ, of a cylinder L/R.",
    ),
    column(
        "trailing_energy_release_rate",
        Measure::Release,
        "G₁ of the edge that opens: what ½∫p·w loses for each area if it moves by one process zone; negative where that would gain. Accuracy relative to at least Δγ of that edge.",
    ),
    column(
        "leading_energy_release_rate",
        Measure::LeadingRelease,
        "G₂ of the edge that closes, likewise; accuracy relative to at least Δγ.",
    ),
    Definition {
        name: "mean_pressure",
        of_cylinder: "load_per_width",
        measure: Measure::Load,
        meaning: "Load, of a wave over the nominal area; accuracy relative to at least its unit in reduced scenes.",
    },
    column("trailing_edge", Measure::Length, "x of the edge that opens; accuracy as of the half-width."),
    column("leading_edge", Measure::Length, "x of the edge that closes; accuracy as of the half-width."),
    Definition {
        name: "adhesive_friction_stress",
        of_cylinder: "adhesive_friction_per_width",
        measure: Measure::Friction,
        meaning: "The part of the friction that adhesion adds at the edges: G₁ − G₂, of a wave over the wavelength (3.40).",
    },
    column(
        "trailing_nonconservative_work",
        Measure::Release,
        "Δγ − G₁: work of the interface at the opening edge that is not stored (3.21).",
    ),
    column(
        "leading_nonconservative_work",
        Measure::LeadingRelease,
        "Δγ − G₂: work of the interface at the closing edge that is not stored (3.22).",
    ),
    column("trailing_process_zone", Measure::Length, "δ of the edge that opens."),
    column("leading_process_zone", Measure::Length, "δ of the edge that closes."),
    column(
        "penetration",
        Measure::Displacement,
        "Δ: 0 where the crest touches the mean surface, Λ in full contact; accuracy relative to at least Λ.",
    ),
    column("interface_work", Measure::Energy, "U = ½∫p w over a wavelength, per width; accuracy relative to at least E0*Λ²/2."),
];

/// What a point of a branch has besides; those from the third on are of a wave.
static BRANCH_COLUMNS: [Definition; 5] = [
    column("point", Measure::Number, "Number of the row along its branch, from 1; turns count."),
    column("work_of_adhesion", Measure::Adhesion, "Δγ, where the edges differ that of the trailing one; in a reduced scene Γ."),
    column(
        "stable_under_load",
        Measure::Number,
        "1 if every small move of the edges is undone under a held load, 0 if one grows; none at a turn.",
    ),
    column("stable_under_penetration", Measure::Number, "The same under a held penetration."),
    column("stable_in_frame", Measure::Number, "The same as stable_under_load in the frame of the scene."),
];

/// Of a single contact: how many others there are.
static OTHERS: Definition = column(
    "other_contacts",
    Measure::Number,
    "How many other contacts there are: stable ones of the load or penetration that is held, any of a half-width.",
);

/// Positions of the stabilities among the columns of a branch.
const STABILITIES: usize = 2;

/// What a contact carries; those of the penetration are of a wave.
static STRENGTH_COLUMNS: [Definition; 14] = [
    column("speed", Measure::Speed, "v of the sliding body along +x."),
    column("work_of_adhesion", Measure::Adhesion, "Δγ, where the edges differ that of the trailing one; in a reduced scene Γ."),
    Definition {
        name: "pull_off_pressure",
        of_cylinder: "pull_off_load_per_width",
        measure: Measure::Load,
        meaning: "p_out, the smallest load of a contact, below zero: under a held load it is lost there.",
    },
    column("pull_off_half_width", Measure::Length, "a at pull-off."),
    column("pull_off_penetration", Measure::Displacement, "Δ at pull-off."),
    column("zero_load_half_width", Measure::Length, "a of the stable contact without load."),
    column("zero_load_penetration", Measure::Displacement, "Δ of the stable contact without load."),
    column("snap_in_pressure", Measure::Load, "p_IN, the largest load of a partial contact: above it the contact is full."),
    column("snap_in_half_width", Measure::Length, "a at snap-in."),
    column("snap_in_penetration", Measure::Displacement, "Δ at snap-in."),
    column(
        "separation_penetration",
        Measure::Displacement,
        "Δ_out, the smallest penetration: under a held penetration the contact is lost there.",
    ),
    column("separation_half_width", Measure::Length, "a at separation."),
    column("separation_pressure", Measure::Load, "p̄ at separation."),
    column(
        "toughness",
        Measure::Energy,
        "T, the work to separate the contact from no load on under a held penetration, per width and wavelength (3.41).",
    ),
];

/// Those of a cylinder's strength.
pub(super) const CYLINDER_STRENGTH: [usize; 5] = [0, 1, 2, 3, 5];

/// The definitions of a scene's columns: a cylinder sinks into a half-plane without bound and has neither Δ nor U.
pub(super) fn definitions(sliding: &Sliding) -> Vec<&'static Definition> {
    let wave = matches!(sliding.indenter, SlidingIndenter::Wave { .. });
    let mut definitions: Vec<&'static Definition> = match &sliding.task {
        SlidingTask::State | SlidingTask::Branch(_) => {
            let mut definitions: Vec<&'static Definition> =
                COLUMNS.iter().take(if wave { COLUMNS.len() } else { at::PENETRATION }).collect();
            if let SlidingTask::Branch(branch) = &sliding.task {
                let framed = usize::from(branch.frame_stiffness.is_some());
                definitions.extend(BRANCH_COLUMNS.iter().take(if wave { 4 + framed } else { 3 }));
            } else {
                let framed = usize::from(sliding.frame_stiffness.is_some());
                definitions.extend(BRANCH_COLUMNS.iter().skip(STABILITIES).take(if wave { 2 + framed } else { 1 }));
                definitions.push(&OTHERS);
            }
            definitions
        }
        SlidingTask::Strength => STRENGTH_COLUMNS
            .iter()
            .enumerate()
            .filter(|(index, _)| wave || CYLINDER_STRENGTH.contains(index))
            .map(|(_, definition)| definition)
            .collect(),
    };
    definitions.extend(super::extra_columns::extra_definitions(sliding));
    definitions
}

/// The position of a column of a scene by its name.
pub(super) fn place_of(sliding: &Sliding, name: &str) -> usize {
    definitions(sliding).iter().position(|definition| definition.name == name).unwrap_or(usize::MAX)
}

impl Definition {
    /// Its factor from reduced units to those of the scene.
    pub(super) fn factor(&self, scale: &Scale, [trailing, leading]: [f64; 2]) -> f64 {
        match self.measure {
            Measure::Speed => 1.0,
            Measure::Length => scale.length,
            Measure::Displacement => scale.displacement,
            Measure::Load => scale.load,
            Measure::Friction => scale.friction,
            Measure::Coefficient => scale.slope,
            Measure::Release => trailing,
            Measure::LeadingRelease => leading,
            Measure::Energy => scale.energy_per_width,
            Measure::Adhesion => scale.work_of_adhesion,
            // The material's own unit.
            Measure::Modulus | Measure::Number | Measure::Ratio => 1.0,
        }
    }

    fn unit(&self, indenter: SlidingIndenter, units: Units) -> &'static str {
        let wave = matches!(indenter, SlidingIndenter::Wave { .. });
        match (self.measure, units, wave) {
            (Measure::Speed, Units::Si, _) => "m/s",
            (Measure::Length | Measure::Displacement, Units::Si, _) => "m",
            (Measure::Load | Measure::Friction, Units::Si, true) => "Pa",
            (Measure::Load | Measure::Friction, Units::Si, false) => "N/m",
            (Measure::Coefficient, Units::Si, _) => "1",
            (Measure::Release | Measure::LeadingRelease, Units::Si, _) => "J/m²",
            (Measure::Energy, Units::Si, _) => "J/m",
            (Measure::Adhesion, Units::Si, _) => "J/m²",
            (Measure::Modulus, Units::Si, _) => "Pa",
            (Measure::Modulus, Units::Reduced, _) => "E0*",
            (Measure::Number | Measure::Ratio, ..) => "1",
            (Measure::Adhesion, Units::Reduced, true) => "πE0*kΛ²",
            (Measure::Adhesion, Units::Reduced, false) => "πE0*L³/R²",
            (Measure::Speed, Units::Reduced, true) => "1/kτ",
            (Measure::Speed, Units::Reduced, false) => "L/τ",
            (Measure::Length, Units::Reduced, true) => "1/k",
            (Measure::Length, Units::Reduced, false) => "L",
            (Measure::Displacement, Units::Reduced, true) => "Λ",
            (Measure::Displacement, Units::Reduced, false) => "L²/R",
            (Measure::Load, Units::Reduced, true) => "E0*kΛ/2",
            (Measure::Load, Units::Reduced, false) => "πE0*L²/R",
            (Measure::Friction, Units::Reduced, true) => "E0*k²Λ²/2",
            (Measure::Friction, Units::Reduced, false) => "πE0*L³/R²",
            (Measure::Coefficient, Units::Reduced, true) => "kΛ",
            (Measure::Coefficient, Units::Reduced, false) => "L/R",
            (Measure::Release | Measure::LeadingRelease, Units::Reduced, _) => "Δγ",
            (Measure::Energy, Units::Reduced, true) => "E0*Λ²/2",
            (Measure::Energy, Units::Reduced, false) => "E0*L⁴/2R²",
        }
    }
}

pub(super) fn columns(sliding: &Sliding, units: Units) -> Vec<Column> {
    let wave = matches!(sliding.indenter, SlidingIndenter::Wave { .. });
    definitions(sliding)
        .into_iter()
        .map(|definition| Column {
            name: if wave { definition.name } else { definition.of_cylinder },
            unit: definition.unit(sliding.indenter, units).to_owned(),
            meaning: definition.meaning,
        })
        .collect()
}

/// Positions of the fields at a place.
pub(super) mod field {
    pub(crate) const PRESSURE: usize = 0;
    pub(crate) const DISPLACEMENT: usize = 2;
}

pub(super) fn field_columns(indenter: SlidingIndenter, units: Units) -> Vec<Column> {
    let units = match (units, indenter) {
        (Units::Si, _) => ["m", "Pa", "m", "m"],
        (Units::Reduced, SlidingIndenter::Wave { .. }) => ["1/k", "E0*kΛ/2", "Λ", "Λ"],
        (Units::Reduced, SlidingIndenter::Cylinder { .. }) => ["L", "E0*L/2R", "L²/R", "L²/R"],
    };
    let columns = [
        ("position", "x along the surface, 0 at the crest, in the frame of the sliding body."),
        ("pressure", "Pressure, tension negative; 0 outside the contact."),
        ("gap", "Gap between the faces; 0 in the contact."),
        ("displacement", "Displacement of the surface into the body, from its mean; under a cylinder, from the point below its crest."),
    ];
    columns.into_iter().zip(units).map(|((name, meaning), unit)| Column { name, unit: unit.to_owned(), meaning }).collect()
}
