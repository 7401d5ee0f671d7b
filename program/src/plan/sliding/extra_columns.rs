//! Columns of a sliding contact that are made on request, after those that always are there.

use super::columns::{Definition, Measure, column};
use crate::scene::typed::{Sliding, SlidingColumns, SlidingIndenter, SlidingLoad, SlidingTask};

/// The works of adhesion where they differ or follow the speed: of a state both; of branches and strengths, which have the trailing one, the other.
static WORKS: [Definition; 2] = [
    column("trailing_work_of_adhesion", Measure::Adhesion, "Δγ of the edge that opens, at this speed; in a reduced scene Γ."),
    column("leading_work_of_adhesion", Measure::Adhesion, "Δγ of the edge that closes, at this speed; in a reduced scene Γ."),
];

static FRICTION_PARTS: [Definition; 3] = [
    Definition {
        name: "bulk_friction_stress",
        of_cylinder: "bulk_friction_per_width",
        measure: Measure::Friction,
        meaning: "Friction less the part of the edges: what is dissipated away from them, also because they widen the contact.",
    },
    column("edge_share", Measure::Ratio, "μ_a/μ: the part of the edges, G₁ − G₂ (3.40), over all friction; may be negative or above 1."),
    column(
        "regime",
        Measure::Number,
        "1: small-scale dissipation governs, μ_a within a tenth of μ; −1: the bulk does, μ_a at most a tenth of μ; 0: neither.",
    ),
];

static ELASTIC_REFERENCE: [Definition; 4] = [
    column("dynamic_modulus", Measure::Modulus, "|E*(ω)| at ω = kv, the modulus of the elastic reference contact."),
    column(
        "elastic_half_width",
        Measure::Length,
        "a of the elastic reference contact; none where its contact is full, or where it has none.",
    ),
    column("elastic_mean_pressure", Measure::Load, "p̄ of the elastic reference contact."),
    column("elastic_penetration", Measure::Displacement, "Δ of the elastic reference contact."),
];

static ELASTIC_REFERENCE_STRENGTH: [Definition; 6] = [
    column("dynamic_modulus", Measure::Modulus, "|E*(ω)| at ω = kv, the modulus of the elastic reference contact."),
    column("elastic_pull_off_pressure", Measure::Load, "p_out of the elastic reference contact (thesis Fig 3.14c)."),
    column("elastic_pull_off_half_width", Measure::Length, "a of the elastic reference contact at pull-off."),
    column("elastic_snap_in_pressure", Measure::Load, "p_IN of the elastic reference contact."),
    column("elastic_separation_penetration", Measure::Displacement, "Δ_out of the elastic reference contact."),
    column("elastic_toughness", Measure::Energy, "T of the elastic reference contact (3.41)."),
];

/// The five sensitivities of an output.
macro_rules! by_parameters {
    ($name:literal, $of_cylinder:literal) => {
        [
            by_parameters!($name, $of_cylinder, "_by_process_zone", "∂ln|·|/∂ln δ, both process zones in a fixed ratio."),
            by_parameters!($name, $of_cylinder, "_by_work_of_adhesion", "∂ln|·|/∂ln Δγ, both works in a fixed ratio, process zones held."),
            by_parameters!($name, $of_cylinder, "_by_relaxed_modulus", "∂ln|·|/∂ln E0 at fixed β, load, work and process zones."),
            by_parameters!($name, $of_cylinder, "_by_stiffening_ratio", "∂ln|·|/∂ln β at fixed E0 and retardation times; none of an elastic solid."),
            by_parameters!($name, $of_cylinder, "_by_time", "∂ln|·|/∂ln τ, all times of the solid in a fixed ratio, works of adhesion held."),
        ]
    };
    ($name:literal, $of_cylinder:literal, $suffix:literal, $meaning:literal) => {
        Definition {
            name: concat!($name, $suffix),
            of_cylinder: concat!($of_cylinder, $suffix),
            measure: Measure::Ratio,
            meaning: $meaning,
        }
    };
}

/// Outputs of a state: half-width, load, penetration, friction.
static OF_STATE: [[Definition; 5]; 4] = [
    by_parameters!("half_width", "half_width"),
    by_parameters!("mean_pressure", "load_per_width"),
    by_parameters!("penetration", "penetration"),
    by_parameters!("friction_stress", "friction_per_width"),
];

/// Outputs of a strength: pull-off, snap-in, separation, toughness.
static OF_STRENGTH: [[Definition; 5]; 4] = [
    by_parameters!("pull_off_pressure", "pull_off_load_per_width"),
    by_parameters!("snap_in_pressure", ""),
    by_parameters!("separation_penetration", ""),
    by_parameters!("toughness", ""),
];

/// Whether the works of a scene have columns of their own.
pub(super) fn has_works(sliding: &Sliding) -> bool {
    sliding.work_by_speed.is_some() || sliding.works_per_edge
}

/// The sensitivities of a state that are no zeros: not of what is prescribed, and not of a cylinder's penetration.
pub(super) fn outputs_of_state(sliding: &Sliding) -> [bool; 4] {
    let wave = matches!(sliding.indenter, SlidingIndenter::Wave { .. });
    let load = matches!(sliding.control, SlidingLoad::MeanPressure(_) | SlidingLoad::LoadPerWidth(_));
    let (depth, width) = (matches!(sliding.control, SlidingLoad::Penetration(_)), matches!(sliding.control, SlidingLoad::HalfWidth(_)));
    [!width, !load, wave && !depth, true]
}

/// Those of a strength: a cylinder has a pull-off only.
pub(super) fn outputs_of_strength(sliding: &Sliding) -> [bool; 4] {
    let wave = matches!(sliding.indenter, SlidingIndenter::Wave { .. });
    [true, wave, wave, wave]
}

/// The definitions that a scene asks for besides.
pub(super) fn extra_definitions(sliding: &Sliding) -> Vec<&'static Definition> {
    let asks = |columns: SlidingColumns| sliding.columns.contains(&columns);
    let state = sliding.task == SlidingTask::State;
    let strength = sliding.task == SlidingTask::Strength;
    let mut definitions: Vec<&'static Definition> = Vec::new();
    if has_works(sliding) {
        definitions.extend(WORKS.iter().skip(usize::from(!state)));
    }
    if asks(SlidingColumns::FrictionParts) {
        definitions.extend(&FRICTION_PARTS);
    }
    if asks(SlidingColumns::ElasticReference) {
        if strength { definitions.extend(&ELASTIC_REFERENCE_STRENGTH) } else { definitions.extend(&ELASTIC_REFERENCE) }
    }
    if asks(SlidingColumns::Sensitivities) {
        let (sets, shown) = if strength { (&OF_STRENGTH, outputs_of_strength(sliding)) } else { (&OF_STATE, outputs_of_state(sliding)) };
        definitions.extend(sets.iter().zip(shown).filter(|(_, shown)| *shown).flat_map(|(set, _)| set));
    }
    definitions
}
