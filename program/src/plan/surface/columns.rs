//! The columns of a sliding surface's table, and what each is measured in.

use crate::outcome::Column;
use crate::scene::typed::Units;
use viscotack::finite_range::line::Scales;

/// What a column measures.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Measure {
    Speed,
    Friction,
    Coefficient,
    Pressure,
    Height,
    Number,
    Power,
    Energy,
}

pub(super) struct Definition {
    pub(super) name: &'static str,
    pub(super) measure: Measure,
    meaning: &'static str,
}

/// Positions of the columns in a row.
pub(super) mod at {
    pub(crate) const FRICTION: usize = 1;
    pub(crate) const COEFFICIENT: usize = 2;
    pub(crate) const PRESSURE: usize = 3;
    pub(crate) const GAP: usize = 4;
    pub(crate) const CONTACT: usize = 5;
    pub(crate) const PATCHES: usize = 6;
    pub(crate) const OTHERS: usize = 17;
}

const fn column(name: &'static str, measure: Measure, meaning: &'static str) -> Definition {
    Definition { name, measure, meaning }
}

pub(super) static COLUMNS: [Definition; 18] = [
    column("speed", Measure::Speed, "v of the sliding surface along +x; a negative one slides the mirrored surface."),
    column(
        "friction_stress",
        Measure::Friction,
        "Resistance to sliding per nominal area, as the loss of all waves of the pressure; accuracy relative to it, or to a thousandth of pressure × slope.",
    ),
    column(
        "friction_coefficient",
        Measure::Coefficient,
        "Friction stress over mean pressure; none where the mean pressure is not positive.",
    ),
    column(
        "mean_pressure",
        Measure::Pressure,
        "Load per nominal area, compression positive; accuracy relative to the largest of it and its two parts.",
    ),
    column(
        "mean_gap",
        Measure::Height,
        "Distance of the mean planes of both surfaces; accuracy relative to the larger of it and half the height of the profile.",
    ),
    column(
        "contact_fraction",
        Measure::Number,
        "Part of the area in contact: on the hard wall, or under repulsion where the law has no wall.",
    ),
    column("patches", Measure::Number, "Connected patches of contact in a period; the error is the change from the grid before."),
    column("adhesive_pressure", Measure::Pressure, "Mean of the tension of the law; negative."),
    column(
        "repulsive_pressure",
        Measure::Pressure,
        "Mean of the contact pressure or repulsion; with the adhesive part it makes the mean pressure.",
    ),
    column("dissipated_power", Measure::Power, "Friction stress times speed: what the solid dissipates per nominal area."),
    column(
        "interface_energy",
        Measure::Energy,
        "Energy of the interface per nominal area: minus the work that the law would still do to part it.",
    ),
    column(
        "friction_by_surface",
        Measure::Friction,
        "Mean of −p w′, w the displaced surface: equal to the friction stress, by another route.",
    ),
    column(
        "friction_by_profile",
        Measure::Friction,
        "Mean of −p h′, h the profile: equal to the friction stress up to the grid, by another route.",
    ),
    column("nodes", Measure::Number, "Nodes along x of the finest grid."),
    column(
        "stable_under_mean_pressure",
        Measure::Number,
        "1 if every small disturbance dies out under a held mean pressure, 0 if one grows; none next to a fold. Growing oscillations are not assessed.",
    ),
    column("stable_under_mean_gap", Measure::Number, "The same under a held mean gap."),
    column("stable_in_frame", Measure::Number, "The same in the frame of the scene; none without a frame."),
    column(
        "other_states",
        Measure::Number,
        "Other states known under what is held: full contact where it holds; with reached_by = every all that the search found. There may be more.",
    ),
];

impl Measure {
    /// The factor from reduced units to those of the scene.
    pub(super) const fn factor(self, scales: &Scales) -> f64 {
        match self {
            Self::Speed | Self::Number => 1.0,
            Self::Friction => scales.friction,
            Self::Coefficient => scales.height / scales.length,
            Self::Pressure => scales.pressure,
            Self::Height => scales.height,
            Self::Power | Self::Energy => scales.work,
        }
    }

    const fn unit(self, units: Units) -> &'static str {
        match (self, units) {
            (Self::Speed, Units::Si) => "m/s",
            (Self::Friction | Self::Pressure, Units::Si) => "Pa",
            (Self::Height, Units::Si) => "m",
            (Self::Power, Units::Si) => "W/m²",
            (Self::Energy, Units::Si) => "J/m²",
            (Self::Number, _) | (Self::Coefficient, Units::Si) => "1",
            (Self::Speed, Units::Reduced) => "1/kτ",
            (Self::Friction, Units::Reduced) => "E0*k²Λ²/2",
            (Self::Coefficient, Units::Reduced) => "kΛ",
            (Self::Pressure, Units::Reduced) => "E0*kΛ/2",
            (Self::Height, Units::Reduced) => "Λ",
            (Self::Power, Units::Reduced) => "E0*kΛ²/2τ",
            (Self::Energy, Units::Reduced) => "E0*kΛ²/2",
        }
    }
}

pub(super) fn columns(units: Units) -> Vec<Column> {
    COLUMNS
        .iter()
        .map(|definition| Column { name: definition.name, unit: definition.measure.unit(units).to_owned(), meaning: definition.meaning })
        .collect()
}

/// Positions of the fields at a place of a line; a surface has y before them.
pub(super) mod field {
    pub(crate) const PRESSURE: usize = 0;
    pub(crate) const GAP: usize = 1;
    pub(crate) const DISPLACEMENT: usize = 2;
    pub(crate) const PROFILE: usize = 3;
}

pub(super) fn field_columns(is_line: bool, units: Units) -> Vec<Column> {
    let (length, pressure, height) = match units {
        Units::Si => ("m", "Pa", "m"),
        Units::Reduced => ("1/k", "E0*kΛ/2", "Λ"),
    };
    let mut columns = vec![("position", length, "x along the sliding direction, in the frame of the sliding surface.")];
    if !is_line {
        columns.push(("across", length, "y across the sliding direction."));
    }
    columns.extend([
        ("pressure", pressure, "Stress between the surfaces, tension negative."),
        ("gap", height, "Gap between the surfaces."),
        ("displacement", height, "Displacement of the viscoelastic surface into the body, from its mean."),
        ("profile", height, "Height of the sliding surface towards the body, from its mean."),
    ]);
    columns.into_iter().map(|(name, unit, meaning)| Column { name, unit: unit.to_owned(), meaning }).collect()
}
