//! The key that is meant by one that the catalogue does not have: by spelling where it is truly close, else by what the field calls it.
//!
//! Every suggestion is a key of the catalogue as it is; a name whose key the catalogue lacks leads nowhere.

use super::catalogue;
use super::diagnostic::nearest;

/// What to type instead of an unknown key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Suggestion {
    /// Path of the key, `[]` for list items; none where the scene has no such thing.
    pub path: Option<&'static str>,
    /// What to know about it.
    pub note: &'static str,
}

/// Names of the field, where they lead, and what is to be known. The paths are tried in order, those below the table of the unknown key first.
type Synonym = (&'static [&'static str], &'static [&'static str], &'static str);

const SYNONYMS: &[Synonym] = &[
    (
        &["youngs_modulus", "young_modulus", "young's_modulus", "young", "elastic_modulus", "e", "e0", "e_0", "modulus", "stiffness"],
        &["material.relaxed_modulus"],
        "Young's modulus after a long time; of an elastic solid the only one",
    ),
    (
        &[
            "long_term_modulus",
            "equilibrium_modulus",
            "rubbery_modulus",
            "rubber_modulus",
            "static_modulus",
            "e_long",
            "relaxation_modulus",
        ],
        &["material.relaxed_modulus"],
        "",
    ),
    (
        &[
            "instantaneous_modulus",
            "unrelaxed_modulus",
            "initial_modulus",
            "glass_modulus",
            "dynamic_modulus",
            "e_inf",
            "einf",
            "e_instantaneous",
        ],
        &["material.glassy_modulus"],
        "Young's modulus at the first instant",
    ),
    (&["shear", "g", "g0", "g_0", "mu", "shear_modulus"], &["material.shear_modulus"], ""),
    (&["shear_modulus", "lame_mu"], &["material.relaxed_modulus"], "Young's modulus is E = 2(1 + ν)G"),
    (&["bulk", "k", "bulk_modulus", "compression_modulus"], &["material.bulk_modulus"], ""),
    (&["bulk_modulus"], &["material.relaxed_modulus"], "Young's modulus is E = 3(1 − 2ν)K"),
    (
        &["nu", "poisson", "poissons_ratio", "poisson's_ratio", "poisson_number", "v", "poissonratio"],
        &["material.poisson_ratio", "sliding.counter_body.poisson_ratio", "indentation.counter_body.poisson_ratio"],
        "",
    ),
    (
        &["youngs_modulus", "young_modulus", "elastic_modulus", "e"],
        &["sliding.counter_body.modulus", "indentation.counter_body.modulus"],
        "",
    ),
    (&["density", "rho", "mass_density", "mass"], &[], "no problem here has inertia: delete this line"),
    (
        &["friction", "friction_coefficient", "coefficient_of_friction", "friction_coeff"],
        &[],
        "the faces slide without friction of their own; friction is a result of memory: delete this line",
    ),
    (
        &["gamma", "surface_energy", "surface_tension", "surface_free_energy"],
        &["adhesion.work_of_adhesion"],
        "of two equal surfaces it is twice the surface energy",
    ),
    (
        &[
            "adhesion_energy",
            "adhesive_energy",
            "interfacial_energy",
            "interface_energy",
            "energy",
            "work",
            "delta_gamma",
            "w",
            "w12",
            "g_c",
            "gc",
            "g0",
            "gamma0",
            "fracture_energy",
            "toughness",
            "adhesion_work",
            "work_adhesion",
        ],
        &["adhesion.work_of_adhesion"],
        "",
    ),
    (
        &[
            "cohesive_strength",
            "cohesive_traction",
            "sigma_c",
            "sigma0",
            "sigma_0",
            "maximum_stress",
            "peak_stress",
            "strength",
            "adhesive_stress",
        ],
        &["adhesion.process_zone.cohesive_stress"],
        "",
    ),
    (&["zone_length", "process_zone_length", "cohesive_length", "cohesive_zone", "delta"], &["adhesion.process_zone.length"], ""),
    (&["range", "z0", "d0", "equilibrium_separation", "interatomic_spacing"], &["adhesion.interaction_range"], ""),
    (&["prony", "prony_series", "maxwell", "generalized_maxwell", "relaxation_terms", "terms"], &["material.relaxation"], ""),
    (&["kelvin", "kelvin_voigt", "voigt", "creep_terms", "retardation"], &["material.creep"], ""),
    (
        &["tau", "time", "time_constant", "tau_i", "characteristic_time"],
        &[
            "material.creep[].retardation_time",
            "material.relaxation[].relaxation_time",
            "material.power_law.time",
            "material.fractional_zener.time",
        ],
        "",
    ),
    (&["g_i", "weight", "gi", "share", "part"], &["material.relaxation[].fraction", "material.creep[].fraction"], "fractions sum to 1"),
    (&["e_i", "ei", "prefactor", "strength"], &["material.relaxation[].modulus"], ""),
    (&["j", "j_i", "ji"], &["material.creep[].compliance"], ""),
    (&["eta", "dynamic_viscosity", "steady_viscosity"], &["material.viscosity"], ""),
    (
        &["alpha", "order", "n", "power"],
        &["material.fractional_zener.exponent", "material.power_law.exponent", "indentation.power_law.exponent"],
        "",
    ),
    (&["t_ref", "tref", "reference", "temperature_reference", "t0"], &["material.reference_temperature"], ""),
    (&["shift_factors", "a_t", "at", "time_temperature", "tts"], &["material.shift"], ""),
    (&["wlf", "williams_landel_ferry"], &["material.shift.wlf"], ""),
    (&["c1"], &["material.shift.wlf.c1"], ""),
    (&["c2"], &["material.shift.wlf.c2"], ""),
    (&["arrhenius"], &["material.shift.arrhenius"], ""),
    (&["activation_energy", "ea", "e_a"], &["material.shift.arrhenius.activation_energy"], ""),
    (
        &["velocity", "v", "sliding_speed", "crack_speed", "tip_speed", "sliding_velocity"],
        &["crack.speed", "sliding.speed", "history[].rate"],
        "",
    ),
    (
        &["load", "force", "normal_load", "normal_force", "f", "preload"],
        &["indentation.force", "sliding.load_per_width", "history[].force"],
        "",
    ),
    (&["pressure", "p", "nominal_pressure", "apparent_pressure"], &["sliding.mean_pressure"], ""),
    (
        &["depth", "indentation_depth", "displacement", "penetration_depth", "approach", "d"],
        &["indentation.penetration", "sliding.penetration", "history[].penetration"],
        "",
    ),
    (&["a", "contact_size", "contact_width"], &["indentation.contact_radius", "sliding.half_width", "history[].contact_radius"], ""),
    (
        &["spring_constant", "cantilever_stiffness", "machine_stiffness", "spring_stiffness", "stiffness", "k_f", "k"],
        &["indentation.frame_stiffness", "sliding.frame_stiffness"],
        "",
    ),
    (&["k", "k_i", "ki", "stress_intensity_factor", "sif"], &["crack.stress_intensity", "history[].stress_intensity"], ""),
    (&["g", "strain_energy_release_rate", "err"], &["crack.energy_release_rate"], ""),
    (
        &["radius", "r", "tip_radius", "curvature_radius", "radius_of_curvature"],
        &["indentation.sphere.radius", "sliding.cylinder.radius"],
        "",
    ),
    (&["diameter"], &["indentation.sphere.radius", "sliding.cylinder.radius"], "half of the diameter"),
    (&["angle", "half_angle", "cone_angle"], &["indentation.cone.slope"], "the tangent of the angle between side and surface"),
    (&["indenter", "tip", "probe", "ball", "bead", "paraboloid"], &["indentation.sphere"], ""),
    (&["punch", "flat", "pillar"], &["indentation.flat_punch"], ""),
    (&["lambda", "period", "wave_length", "pitch"], &["sliding.wave.wavelength"], ""),
    (&["height", "h", "strip_height", "thickness"], &["crack.strip.half_height"], "half of the height between the clamps"),
    (&["height", "h"], &["sliding.wave.amplitude"], "half of the height from valley to peak"),
    (
        &["crack.length", "crack.crack_length", "crack_length", "initial_crack_length", "notch_length", "crack.a", "a0"],
        &[],
        "a crack is long here, so its length does not enter: delete this line",
    ),
    (
        &["speed", "velocity", "rate", "pull_speed", "unloading_speed"],
        &["test.retraction_speed"],
        "test.approach_speed is that of the approach",
    ),
    (
        &["second_body", "counterface", "counter_face", "substrate", "opponent", "body2", "other_body"],
        &["indentation.counter_body", "sliding.counter_body"],
        "",
    ),
    (&["tolerance", "rtol", "precision", "error"], &["accuracy"], ""),
    (&["unit", "unit_system"], &["units"], ""),
    (&["name"], &["title"], ""),
    (
        &["dt", "time_step", "timestep", "steps", "n_steps"],
        &["indentation.instants", "crack.points"],
        "the solver chooses its steps; this many rows are given",
    ),
];

/// Small letters, spaces and dashes as underscores.
fn plain(name: &str) -> String {
    name.to_lowercase().replace([' ', '-'], "_")
}

/// Whether a path lies in a table, or in a table of it.
fn within(path: &str, table: &str) -> bool {
    table.is_empty() || path.strip_prefix(table).is_some_and(|rest| rest.starts_with(['.', '[']))
}

/// What is meant by an unknown key of a table (`[]` for list items): a close name in the same table, a name of the field, or a close name elsewhere.
#[must_use]
pub fn for_key(unknown: &str, table: &str) -> Option<Suggestion> {
    let name = plain(unknown);
    let in_table = |name: &str| {
        let path = if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") };
        catalogue::key(&path).map(|key| key.path)
    };
    let known = |path: Option<&'static str>| path.map(|path| Suggestion { path: Some(path), note: "" });
    // Other capitals or dashes.
    if let Some(found) = known(in_table(&name)) {
        return Some(found);
    }
    let exists = |path: &str| catalogue::key(path).is_some();
    let whole = format!("{table}.{name}");
    let led = || SYNONYMS.iter().filter(|(names, _, _)| names.contains(&name.as_str()) || names.contains(&whole.as_str()));
    let suggested = |path: &'static str, note| Some(Suggestion { path: Some(path), note });
    // A name of the field for a key of this very table, or of one in it.
    for (_, paths, note) in led() {
        let here = |path: &str| if table.is_empty() { !path.contains('.') } else { within(path, table) };
        if let Some(path) = paths.iter().find(|path| exists(path) && here(path)) {
            return suggested(path, note);
        }
    }
    // What the field calls so in this table does not exist here.
    if let Some((.., note)) = SYNONYMS.iter().find(|(names, paths, _)| paths.is_empty() && names.contains(&whole.as_str())) {
        return Some(Suggestion { path: None, note });
    }
    // A slip of a letter or two.
    if let Some(found) = known(nearest(&name, catalogue::names_in(table)).and_then(in_table)) {
        return Some(found);
    }
    // The end of a longer name of this table: `height` for `half_height`.
    let ending = format!("_{name}");
    if let Some(found) = known(catalogue::names_in(table).find(|known| !table.is_empty() && known.ends_with(&ending)).and_then(in_table)) {
        return Some(found);
    }
    let last = |path: &'static str| path.rsplit(['.', ']']).next() == Some(name.as_str());
    let same_name = || catalogue::keys().map(|key| key.path).filter(|path| last(path));
    // The names of columns are those of tables, and lead nowhere from elsewhere.
    let of_columns = |path: &str| path.contains("columns.");
    if let Some(path) =
        same_name().find(|path| !table.is_empty() && within(path, table)).or_else(|| same_name().find(|path| !of_columns(path)))
    {
        return suggested(path, "");
    }
    for (_, paths, note) in led() {
        if let Some(path) = paths.iter().find(|path| exists(path)) {
            return suggested(path, note);
        }
        if paths.is_empty() {
            return Some(Suggestion { path: None, note });
        }
    }
    let other_tables = || {
        let keys = catalogue::keys().filter(|key| !of_columns(key.path));
        keys.filter_map(|key| key.path.rsplit(['.', ']']).next().map(|last| (last, key.path)))
    };
    let near = nearest(&name, other_tables().map(|(last, _)| last))?;
    known(other_tables().find(|(last, _)| *last == near).map(|(_, path)| path))
}
