//! The small scenes whose columns make the reference.

/// A scene, and what it shows that the scenes before it do not.
pub(super) struct Variant {
    /// The heading over the columns that it adds.
    pub(super) adds: &'static str,
    pub(super) scene: String,
    /// A table that the scene names.
    pub(super) file: Option<(&'static str, &'static str)>,
}

/// One kind of result.
pub(super) struct Section {
    pub(super) title: &'static str,
    pub(super) about: &'static str,
    /// How the error bounds are made.
    pub(super) bounds: &'static str,
    pub(super) base: Variant,
    pub(super) variants: Vec<Variant>,
}

const SOLID: &str =
    "[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.49\ncreep = [{ fraction = 1, retardation_time = 0.01 }]\n";
const EDGE: &str = "[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = { length = 1e-6 }\n";
const LAW: &str = "[adhesion]\nwork_of_adhesion = 0.05\nlaw = \"lennard_jones\"\nrange = 6e-8\n";
const PULL: &str = "[[history]]\npenetration = 4e-6\nrate = 2e-6\n[[history]]\npenetration = -1e-5\nrate = 2e-6\n";
const SMALL_PULL: &str = "[[history]]\npenetration = 1e-7\nrate = 1e-7\n[[history]]\npenetration = -2e-6\nrate = 1e-7\n";
const RECORD: &str = "[[history]]\ntable = \"record.csv\"\nquantity = \"frame\"\n";
const OSCILLATION: &str = "[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3 }\n";
const SPHERE: &str = "[indentation]\nsphere = { radius = 1e-3 }\nstart = \"untouched\"\n";
const SMALL_SPHERE: &str = "[indentation]\nsphere = { radius = 5e-5 }\nstart = \"untouched\"\npenetration = -4e-7\n";
const WAVE: &str = "[sliding]\nwave = { wavelength = 1e-4, amplitude = 3e-6 }\nspeed = 1e-3\n";
const LOAD: &str = "mean_pressure = 6e3\n";
const CYLINDER: &str = "[sliding]\ncylinder = { radius = 5e-3 }\nspeed = 1e-3\n";
const LINE_LOAD: &str = "load_per_width = 20\n";
const TWO_EDGES: &str = "[adhesion]\ntrailing_work_of_adhesion = 0.05\nleading_work_of_adhesion = 0.02\nprocess_zone = { length = 1e-6 }\n";

fn scene(adds: &'static str, parts: &[&str]) -> Variant {
    Variant { adds, scene: format!("title = \"reference\"\n{}", parts.concat()), file: None }
}

/// A recorded test.
fn recorded(adds: &'static str, parts: &[&str]) -> Variant {
    let file = ("record.csv", "time (s), frame (m), force (N)\n0, 0, 0\n1, 1e-6, 1e-4\n2, 2e-6, 2e-4\n3, 1e-6, 1e-4\n");
    Variant { file: Some(file), ..scene(adds, parts) }
}

/// All of them, in the order of the page.
pub(super) fn sections() -> Vec<Section> {
    vec![steady_crack(), delayed_crack(), indentation(), indentation_at_a_distance(), sliding(), branch(), strength(), surface()]
}

fn steady_crack() -> Section {
    Section {
        title: "Crack at a steady speed",
        about: "A scene with `[crack]` and no history. Each theory gives one row.",
        bounds: "The residual of the one equation that is solved, over its slope, gives the error of the crossing time. Its effect on each value is added to the rounding and the \
                 errors of converted material terms.",
        base: scene("", &[SOLID, EDGE, "[crack]\nmotion = \"opening\"\nbody = \"two_halves\"\nplane = \"stress\"\nspeed = 1e-3\n"]),
        variants: Vec::new(),
    }
}

fn delayed_crack() -> Section {
    let history = "[[history]]\nstress_intensity = 1e2\nduration = 0.1\n[[history]]\nhold = 30\n";
    Section {
        title: "Crack under a load history",
        about: "A scene with `[crack]` and `[[history]]`.",
        bounds: "The history is integrated with 32, 64, 128 and 256 steps a process zone, and with more where the accuracy asks for it. The values are those of the finest run. The \
                 differences of the runs give the bound.",
        base: scene("", &[SOLID, EDGE, "[crack]\nbody = \"two_halves\"\nplane = \"stress\"\n", history]),
        variants: Vec::new(),
    }
}

fn indentation() -> Section {
    Section {
        title: "Indentation",
        about: "A scene with `[indentation]`, with a process zone or without adhesion.",
        bounds: "The history is integrated again with other step sizes. The differences give the bound. Without adhesion the bound is what is left of the series and of the panels.",
        base: scene("", &[SOLID, EDGE, SPHERE, PULL]),
        variants: vec![
            scene("With `frame_stiffness`", &[SOLID, EDGE, SPHERE, "frame_stiffness = 560\n", PULL]),
            recorded("With a recorded table that has a force", &[SOLID, EDGE, SPHERE, "frame_stiffness = 560\n", RECORD]),
            scene("With `[indentation.energies]`", &[SOLID, EDGE, SPHERE, "[indentation.energies]\n", PULL]),
            scene("With an oscillation in the history: one row for each cycle", &[SOLID, EDGE, SPHERE, PULL, OSCILLATION]),
        ],
    }
}

fn indentation_at_a_distance() -> Section {
    Section {
        title: "Indentation with attraction at a distance",
        about: "A scene with `[indentation]` and a law of attraction, `adhesion.law`.",
        bounds: "The history is solved twice, the second time with every tolerance tightened. The change between both gives the bound.",
        base: scene("", &[SOLID, LAW, SMALL_SPHERE, SMALL_PULL]),
        variants: vec![
            scene("With `frame_stiffness`", &[SOLID, LAW, SMALL_SPHERE, "frame_stiffness = 5\n", SMALL_PULL]),
            recorded("With a recorded table that has a force", &[SOLID, LAW, SMALL_SPHERE, "frame_stiffness = 5\n", RECORD]),
            scene("With `[indentation.energies]`", &[SOLID, LAW, SMALL_SPHERE, "[indentation.energies]\n", SMALL_PULL]),
        ],
    }
}

fn sliding() -> Section {
    let pressed = |adds, more: &[&str]| scene(adds, &[SOLID, EDGE, WAVE, LOAD, &more.concat()]);
    Section {
        title: "Sliding wave or cylinder: one contact",
        about: "A scene with `[sliding]`, a wave or a cylinder, and a load.",
        bounds: "The balance of both edges is evaluated at the next finer resolution. What it is off there, carried to the edges by its derivatives, and the change of each value between \
                 both resolutions give the bound, with rounding.",
        base: pressed("", &[]),
        variants: vec![
            scene("Of a cylinder, in place of the columns of a wave", &[SOLID, EDGE, CYLINDER, LINE_LOAD]),
            scene("With `frame_stiffness`", &[SOLID, EDGE, WAVE, "penetration = 1e-7\nframe_stiffness = 1e9\n"]),
            scene("With works of adhesion that differ between the edges, or follow the speed", &[SOLID, TWO_EDGES, WAVE, LOAD]),
            pressed("With `columns = [\"friction_parts\"]`", &["columns = [\"friction_parts\"]\n"]),
            scene("The same of a cylinder", &[SOLID, EDGE, CYLINDER, LINE_LOAD, "columns = [\"friction_parts\"]\n"]),
            pressed("With `columns = [\"elastic_reference_contact\"]`", &["columns = [\"elastic_reference_contact\"]\n"]),
            pressed("With `columns = [\"sensitivities\"]`", &["columns = [\"sensitivities\"]\n"]),
            scene(
                "With `columns = [\"sensitivities\"]` under a penetration",
                &[SOLID, EDGE, WAVE, "penetration = 1e-7\ncolumns = [\"sensitivities\"]\n"],
            ),
            scene("The same of a cylinder with sensitivities", &[SOLID, EDGE, CYLINDER, LINE_LOAD, "columns = [\"sensitivities\"]\n"]),
            scene(
                "The same of a cylinder under a half-width",
                &[SOLID, EDGE, CYLINDER, "half_width = 1e-4\ncolumns = [\"sensitivities\"]\n"],
            ),
        ],
    }
}

fn branch() -> Section {
    let along = "[sliding.branch]\nparameter = \"mean_pressure\"\nfrom = -1e3\nto = 1e4\n";
    Section {
        title: "Sliding wave or cylinder: a branch of contacts",
        about: "A scene with `[sliding.branch]`. It has the columns of one contact and those of its works of adhesion, and some more.",
        bounds: "As of one contact. Turns are solved at one resolution; what their equations are off at the next one gives the bound.",
        base: scene("", &[SOLID, EDGE, WAVE, along]),
        variants: vec![
            scene("With `frame_stiffness`", &[SOLID, EDGE, WAVE, along, "frame_stiffness = 1e9\n"]),
            scene(
                "Of a cylinder, in place of the columns of a wave",
                &[SOLID, EDGE, CYLINDER, "[sliding.branch]\nparameter = \"load_per_width\"\nfrom = -1\nto = 20\n"],
            ),
        ],
    }
}

fn strength() -> Section {
    let sensitive = "columns = [\"sensitivities\"]\n[sliding.strength]\n";
    let elastic = "columns = [\"elastic_reference_contact\"]\n[sliding.strength]\n";
    Section {
        title: "Sliding wave or cylinder: pull-off, snap-in, separation",
        about: "A scene with `[sliding.strength]`.",
        bounds: "As of one contact. The work of separation is integrated by two rules; their difference gives its bound.",
        base: scene("", &[SOLID, EDGE, WAVE, "[sliding.strength]\n"]),
        variants: vec![
            scene("Of a cylinder, in place of the columns of a wave", &[SOLID, EDGE, CYLINDER, "[sliding.strength]\n"]),
            scene(
                "With works of adhesion that differ between the edges, or follow the speed",
                &[SOLID, TWO_EDGES, WAVE, "[sliding.strength]\n"],
            ),
            scene("With `columns = [\"elastic_reference_contact\"]`", &[SOLID, EDGE, WAVE, elastic]),
            scene("With `columns = [\"sensitivities\"]`", &[SOLID, EDGE, WAVE, sensitive]),
            scene("The same of a cylinder", &[SOLID, EDGE, CYLINDER, sensitive]),
        ],
    }
}

fn surface() -> Section {
    let rough = "[sliding]\nspeed = 2e-2\nmean_pressure = 1e5\n[sliding.surface]\nroughness = { hurst = 0.8, rms_height = 5e-7, longest = 1e-4, shortest = 1.2e-5, seed = 2 }\n";
    Section {
        title: "Sliding surface that attracts at a distance",
        about: "A scene with `[sliding]` and a law of attraction, a profile, a rough surface or a coating.",
        bounds: "The grid is refined by factors of two. The bound is the larger of the last changes, and of earlier ones with their decay.",
        base: scene("", &[SOLID, LAW, rough]),
        variants: Vec::new(),
    }
}
