//! The scenes of the effects: each effect once with its value neutral, once left out.

/// What the values of both scenes may differ by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// Not a bit.
    Exact,
    /// This part of the largest value of the column, for a reason.
    Relative(f64, &'static str),
}

/// An effect.
#[derive(Debug, Clone)]
pub struct Effect {
    /// Its name.
    pub name: &'static str,
    /// How it is made neutral.
    pub neutral: &'static str,
    /// What both may differ by.
    pub tolerance: Tolerance,
    /// The scene that leaves it out.
    pub without: String,
    /// The scene that has it, neutral.
    pub with: String,
    /// Columns to compare; the rows that have no partner are left out.
    pub columns: &'static [&'static str],
    /// Whether it costs evaluations; some effects only change numbers that go into the same equations.
    pub costs: bool,
}

const CRACK: &str = r#"
accuracy = 1e-12
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "100 MPa"
creep = [{ fraction = 1, retardation_time = "1 s" }]

[adhesion]
work_of_adhesion = "1 J/m²"
process_zone = { cohesive_stress = "1 MPa" }

[crack]
body = "against_rigid"
plane = "stress"
theories = ["virtual_work"]
speed = "1 mm/s"

[sweep]
key = "crack.speed"
from = "1 µm/s"
to = "1 m/s"
points = 40
"#;

const DELAYED: &str = r#"
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
creep = [{ fraction = 1, retardation_time = "1 s" }]

[adhesion]
work_of_adhesion = "1 J/m²"
process_zone = { length = "1.4323944878270581 µm" }

[crack]
body = "against_rigid"
plane = "stress"
points = 5

[[history]]
stress_intensity = "3 kPa √m"

[[history]]
hold = "2 s"
"#;

const SLIDING: &str = r#"
accuracy = 1e-9
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.49
creep = [{ fraction = 1, retardation_time = "10 ms" }]

[adhesion]
work_of_adhesion = "20 mJ/m²"
process_zone = { length = "0.16 µm" }

[sliding]
contacts = ["adhesive"]
speed = "1 mm/s"
mean_pressure = "6 kPa"

[sliding.wave]
wavelength = "100 µm"
amplitude = "3 µm"

[sweep]
key = "sliding.speed"
from = "10 µm/s"
to = "100 mm/s"
points = 6
"#;

const SPHERE: &str = r#"
units = "reduced"
accuracy = 1e-3

[material]
glassy_modulus = 10
relaxation = [{ fraction = 1, relaxation_time = 1 }]

[adhesion]
work_of_adhesion = 1.6e-4
process_zone = { length = 0.013 }

[indentation]
sphere = {}
start = "relaxed"
penetration = 0.032
instants = 8

[[history]]
penetration = 0.025
rate = 0.02

[[history]]
hold = 2
"#;

/// A scene with some of its text replaced.
fn changed(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
}

const TERM: &str = "creep = [{ fraction = 1, retardation_time = \"1 s\" }]";
const SLIDING_TERM: &str = "creep = [{ fraction = 1, retardation_time = \"10 ms\" }]";
const RETRACTION: &str = "[[history]]\npenetration = 0.025\nrate = 0.02\n\n";
const EDGES: &[&str] = &["half_width", "eccentricity", "friction_stress", "penetration"];
const CONTACT: &[&str] = &["penetration", "force", "contact_radius"];

/// All effects.
#[must_use]
pub fn effects() -> Vec<Effect> {
    let mut effects = cracks();
    effects.extend(sliding());
    effects.extend(spheres());
    effects
}

fn cracks() -> Vec<Effect> {
    let release: &[&str] = &["energy_release_rate", "stress_intensity", "process_zone"];
    vec![
        Effect {
            name: "relaxation (steady crack)",
            neutral: "E∞ = (1 + 10⁻¹²)E0",
            tolerance: Tolerance::Relative(4e-12, "G changes by β − 1 = 10⁻¹² at most, K and δ with it"),
            without: changed(
                CRACK,
                &[("relaxed_modulus = \"1 MPa\"\n", ""), ("glassy_modulus = \"100 MPa\"", "glassy_modulus = \"1 MPa\""), (TERM, "")],
            ),
            with: changed(CRACK, &[("glassy_modulus = \"100 MPa\"", "glassy_modulus = \"1.000000000001 MPa\"")]),
            columns: release,
            costs: true,
        },
        Effect {
            name: "one more relaxation term (steady crack)",
            neutral: "a term of 10⁻¹² of the compliance",
            tolerance: Tolerance::Relative(1e-9, "J changes by 10⁻¹² of 1/E0, which is 10⁻¹⁰ of 1/E∞"),
            without: CRACK.to_owned(),
            with: changed(
                CRACK,
                &[(
                    TERM,
                    "creep = [{ fraction = 0.999999999999, retardation_time = \"1 s\" }, { fraction = 1e-12, retardation_time = \"1 ms\" }]",
                )],
            ),
            columns: release,
            costs: true,
        },
        Effect {
            name: "further theories (steady crack)",
            neutral: "other theories do not touch this one",
            tolerance: Tolerance::Exact,
            without: CRACK.to_owned(),
            with: changed(CRACK, &[("[\"virtual_work\"]", "[\"virtual_work\", \"persson_brener\", \"cohesive_zone\"]")]),
            columns: release,
            costs: true,
        },
        Effect {
            name: "fields (steady crack)",
            neutral: "fields are computed from the state",
            tolerance: Tolerance::Exact,
            without: CRACK.to_owned(),
            with: format!("{CRACK}\n[fields]\nfrom = \"1 nm\"\nto = \"1 mm\"\npoints = 30\n"),
            columns: release,
            costs: true,
        },
        Effect {
            name: "a process zone that follows the load (delayed crack)",
            neutral: "the load is constant",
            tolerance: Tolerance::Relative(1e-12, "the length α(K/(√(2π)σ_c))² is given to seventeen digits"),
            without: DELAYED.to_owned(),
            with: changed(DELAYED, &[("{ length = \"1.4323944878270581 µm\" }", "{ cohesive_stress = \"1 MPa\", factor = 1 }")]),
            columns: &["growth", "speed", "delay"],
            costs: false,
        },
        Effect {
            name: "one more relaxation term (delayed crack)",
            neutral: "a term of 10⁻¹² of the compliance",
            tolerance: Tolerance::Relative(1e-8, "several terms are not extrapolated the same way; 64 lines a zone"),
            without: DELAYED.to_owned(),
            with: changed(
                DELAYED,
                &[(
                    TERM,
                    "creep = [{ fraction = 0.999999999999, retardation_time = \"1 s\" }, { fraction = 1e-12, retardation_time = \"0.5 s\" }]",
                )],
            ),
            columns: &["growth", "delay"],
            costs: true,
        },
    ]
}

fn sliding() -> Vec<Effect> {
    vec![
        Effect {
            name: "adhesion (sliding)",
            neutral: "Δγ = 10⁻¹² J/m², Γ = 4·10⁻¹³",
            tolerance: Tolerance::Relative(1e-4, "a pull goes with 2√(βΓ) = 4·10⁻⁶, of a load of 0.05"),
            without: changed(
                SLIDING,
                &[
                    ("[adhesion]\nwork_of_adhesion = \"20 mJ/m²\"\nprocess_zone = { length = \"0.16 µm\" }\n", ""),
                    ("[\"adhesive\"]", "[\"adhesiveless\"]"),
                ],
            ),
            with: changed(SLIDING, &[("\"20 mJ/m²\"", "1e-12"), ("\"0.16 µm\"", "1e-14")]),
            columns: EDGES,
            costs: true,
        },
        Effect {
            name: "relaxation (sliding)",
            neutral: "E∞ = (1 + 10⁻¹²)E0",
            tolerance: Tolerance::Relative(1e-9, "the accuracy that is asked for"),
            without: changed(
                SLIDING,
                &[("relaxed_modulus = \"1 MPa\"\n", ""), ("glassy_modulus = \"10 MPa\"", "glassy_modulus = \"1 MPa\""), (SLIDING_TERM, "")],
            ),
            with: changed(SLIDING, &[("glassy_modulus = \"10 MPa\"", "glassy_modulus = \"1.000000000001 MPa\"")]),
            columns: &["half_width", "penetration"],
            // The equilibrium curve takes as many balances; each is cheaper, as it has no system: about half the time.
            costs: false,
        },
        Effect {
            name: "one more relaxation term (sliding)",
            neutral: "a term of 10⁻¹² of the compliance",
            tolerance: Tolerance::Relative(1e-9, "the accuracy that is asked for"),
            without: SLIDING.to_owned(),
            with: changed(
                SLIDING,
                &[(
                    SLIDING_TERM,
                    "creep = [{ fraction = 0.999999999999, retardation_time = \"10 ms\" }, { fraction = 1e-12, retardation_time = \"1 ms\" }]",
                )],
            ),
            columns: EDGES,
            costs: false,
        },
        Effect {
            name: "an elastic counter body (sliding)",
            neutral: "10¹³ times stiffer",
            tolerance: Tolerance::Relative(1e-9, "the accuracy that is asked for"),
            without: SLIDING.to_owned(),
            with: format!("{SLIDING}\n[sliding.counter_body]\nmodulus = 1e19\npoisson_ratio = 0.3\n"),
            columns: EDGES,
            costs: false,
        },
        Effect {
            name: "two works of adhesion (sliding)",
            neutral: "both edges take the same",
            tolerance: Tolerance::Exact,
            without: SLIDING.to_owned(),
            with: changed(
                SLIDING,
                &[("work_of_adhesion = \"20 mJ/m²\"", "trailing_work_of_adhesion = \"20 mJ/m²\"\nleading_work_of_adhesion = \"20 mJ/m²\"")],
            ),
            columns: EDGES,
            costs: false,
        },
        Effect {
            name: "works that follow the speed (sliding)",
            neutral: "v₀ = 10³⁰ m/s",
            tolerance: Tolerance::Relative(2e-9, "the accuracy that is asked for, of both"),
            without: SLIDING.to_owned(),
            with: changed(
                SLIDING,
                &[("work_of_adhesion = \"20 mJ/m²\"", "work_of_adhesion = \"20 mJ/m²\"\nby_speed = { speed = 1e30, exponent = 1 }")],
            ),
            columns: EDGES,
            costs: false,
        },
        Effect {
            name: "fields (sliding)",
            neutral: "fields are computed from the state",
            tolerance: Tolerance::Exact,
            without: SLIDING.to_owned(),
            with: format!("{SLIDING}\n[fields]\npoints = 200\n"),
            columns: EDGES,
            costs: true,
        },
        Effect {
            name: "elastic reference contact and sensitivities (sliding)",
            neutral: "columns besides do not touch the others",
            tolerance: Tolerance::Exact,
            without: SLIDING.to_owned(),
            with: changed(
                SLIDING,
                &[("speed = \"1 mm/s\"", "speed = \"1 mm/s\"\ncolumns = [\"elastic_reference_contact\", \"sensitivities\"]")],
            ),
            columns: EDGES,
            costs: true,
        },
    ]
}

fn spheres() -> Vec<Effect> {
    vec![
        Effect {
            name: "adhesion (sphere)",
            neutral: "γ̃ = 10⁻¹⁶, a zone of 10⁻¹⁰ R; held, as each step of an edge goes a part of its zone",
            tolerance: Tolerance::Relative(1e-4, "a pull goes with √(8πE*a³Δγ), 10⁻⁶ of the force; bounds are 3·10⁻⁷ of it"),
            without: changed(
                SPHERE,
                &[("[adhesion]\nwork_of_adhesion = 1.6e-4\nprocess_zone = { length = 0.013 }\n", ""), (RETRACTION, "")],
            ),
            with: changed(SPHERE, &[("1.6e-4", "1e-16"), ("0.013", "1e-10"), (RETRACTION, "")]),
            columns: CONTACT,
            costs: true,
        },
        Effect {
            name: "two works of adhesion (sphere)",
            neutral: "the edge takes the same either way",
            tolerance: Tolerance::Exact,
            without: SPHERE.to_owned(),
            with: changed(
                SPHERE,
                &[("work_of_adhesion = 1.6e-4", "trailing_work_of_adhesion = 1.6e-4\nleading_work_of_adhesion = 1.6e-4")],
            ),
            columns: CONTACT,
            costs: false,
        },
        Effect {
            name: "works that follow the speed (sphere)",
            neutral: "the same work at all speeds",
            tolerance: Tolerance::Relative(2e-3, "the accuracy that is asked for, of both"),
            without: SPHERE.to_owned(),
            with: changed(
                SPHERE,
                &[(
                    "work_of_adhesion = 1.6e-4",
                    "by_speed = { table = [{ speed = 1e-9, work_of_adhesion = 1.6e-4 }, { speed = 1e9, work_of_adhesion = 1.6e-4 }] }",
                )],
            ),
            columns: CONTACT,
            costs: false,
        },
        Effect {
            name: "relaxation (sphere)",
            neutral: "E∞ = (1 + 10⁻⁹)E0",
            tolerance: Tolerance::Relative(2e-3, "the accuracy that is asked for, of both"),
            without: changed(
                SPHERE,
                &[("glassy_modulus = 10\nrelaxation = [{ fraction = 1, relaxation_time = 1 }]", "glassy_modulus = 1")],
            ),
            with: changed(SPHERE, &[("glassy_modulus = 10", "glassy_modulus = 1.000000001")]),
            columns: CONTACT,
            costs: true,
        },
        Effect {
            name: "one more relaxation term (sphere)",
            neutral: "a term of 10⁻⁹ of the modulus",
            tolerance: Tolerance::Relative(1e-3, "the accuracy that is asked for: other last digits take other steps"),
            without: SPHERE.to_owned(),
            with: changed(
                SPHERE,
                &[(
                    "relaxation = [{ fraction = 1, relaxation_time = 1 }]",
                    "relaxation = [{ fraction = 0.999999999, relaxation_time = 1 }, { fraction = 1e-9, relaxation_time = 0.1 }]",
                )],
            ),
            columns: CONTACT,
            costs: false,
        },
        Effect {
            name: "energies (sphere)",
            neutral: "they are added up from the states",
            tolerance: Tolerance::Exact,
            without: SPHERE.to_owned(),
            with: changed(SPHERE, &[("instants = 8", "instants = 8\nenergies = {}")]),
            columns: CONTACT,
            // Integrals over the line at each step: the time tells.
            costs: false,
        },
        Effect {
            name: "fields (sphere)",
            neutral: "fields are computed along the same integration",
            tolerance: Tolerance::Exact,
            without: SPHERE.to_owned(),
            with: changed(SPHERE, &[("instants = 8", "instants = 8\n\n[indentation.fields]\ntimes = [0.1, 2]\npoints = 50")]),
            columns: CONTACT,
            costs: true,
        },
        Effect {
            name: "frame stiffness (sphere)",
            neutral: "a frame of 10¹⁰ πE0*R",
            tolerance: Tolerance::Relative(
                1e-4,
                "the frame yields by F/k_f = 10⁻¹²; another control takes other steps, within the accuracy",
            ),
            without: SPHERE.to_owned(),
            with: changed(
                SPHERE,
                &[
                    ("instants = 8", "instants = 8\nframe_stiffness = 1e10"),
                    ("penetration = 0.025\nrate = 0.02", "frame = 0.025\nduration = 0.35"),
                ],
            ),
            columns: CONTACT,
            costs: true,
        },
        Effect {
            name: "oscillation (sphere)",
            neutral: "an amplitude of 10⁻¹² R",
            tolerance: Tolerance::Relative(1e-3, "the accuracy that is asked for"),
            without: changed(SPHERE, &[("hold = 2", "hold = 2\n\n[[history]]\nhold = 3")]),
            with: changed(
                SPHERE,
                &[(
                    "hold = 2",
                    "hold = 2\n\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-12, frequency = 1, cycles = 3 }",
                )],
            ),
            columns: CONTACT,
            costs: true,
        },
    ]
}
