//! Mistakes about an indenter and its history.

use super::{Case, NONE};

const PRESSED: &str = "penetration = \"4 µm\"\nrate = \"2 µm/s\"";
const HELD: &str = "hold = \"2 s\"";
const SPHERE: &str = "sphere = { radius = \"1 mm\" }";
const ZONE: &str = "process_zone = { length = \"1 µm\" }";

/// An indentation that is right.
pub const INDENTATION: &str = r#"title = "An indentation for tests"

[material]
relaxed_modulus = "1 MPa"
poisson_ratio = 0.49
relaxation = [{ modulus = "9 MPa", relaxation_time = "1 s" }]

[adhesion]
work_of_adhesion = "50 mJ/m²"
process_zone = { length = "1 µm" }

[indentation]
sphere = { radius = "1 mm" }
start = "untouched"
instants = 5

[[history]]
penetration = "4 µm"
rate = "2 µm/s"

[[history]]
hold = "2 s"
"#;

#[rustfmt::skip]
pub const INDENTATION_CASES: &[Case] = &[
    // Keys that do not exist.
    Case { kind: "misspelt key of an indentation", edits: &[("instants", "instant")], place: "instant =", says: &["`indentation.instant`", "did you mean `instants`?", "[indentation] knows: sphere, cone"], ..NONE },
    Case { kind: "misspelt shape", edits: &[(SPHERE, "spere = { radius = 1 }")], place: "spere", says: &["`indentation.spere`", "did you mean `sphere`?"], ..NONE },
    Case { kind: "misspelt start", edits: &[("\"untouched\"", "\"untuched\"")], place: "untuched", says: &["`indentation.start` = \"untuched\"", "did you mean \"untouched\"?", "allowed: \"untouched\", \"relaxed\""], ..NONE },
    // Numbers and units.
    Case { kind: "sphere of no size", edits: &[("\"1 mm\"", "0")], place: "sphere", says: &["`indentation.sphere.radius` = 0", "greater than 0"], ..NONE },
    Case { kind: "stiffness with a unit of pressure", edits: &[("instants = 5", "frame_stiffness = \"5 Pa\"")], place: "frame_stiffness", says: &["`indentation.frame_stiffness` = \"5 Pa\"", "measured in N/m", "a stiffness such as"], ..NONE },
    Case { kind: "no instants", edits: &[("instants = 5", "instants = 0")], place: "instants", says: &["`indentation.instants` = 0", "1 to 10000"], ..NONE },
    Case { kind: "depth with a unit of force", edits: &[(PRESSED, "penetration = \"4 N\"")], place: "4 N", says: &["`history.0.penetration` = \"4 N\"", "measured in m"], ..NONE },
    Case { kind: "exponent too small", edits: &[(SPHERE, "power_law = { radius = 1, exponent = 0.2 }")], place: "power_law", says: &["`indentation.power_law.exponent` = 0.2", "greater than 0.5"], ..NONE },
    // What is missing.
    Case { kind: "no shape", edits: &[(SPHERE, "")], place: "[indentation]", says: &["`indentation.sphere`", "`indentation.flat_punch`", "exactly one"], ..NONE },
    Case { kind: "no history", edits: &[("[[history]]\npenetration = \"4 µm\"\nrate = \"2 µm/s\"\n\n[[history]]\nhold = \"2 s\"\n", "")], place: "instants", says: &["the history is missing", "add [[history]] tables"], ..NONE },
    Case { kind: "no Poisson ratio of a half-space", edits: &[("poisson_ratio = 0.49\n", "")], place: "[material]", says: &["`material.poisson_ratio` is missing", "half-space"], ..NONE },
    Case { kind: "a relaxed start without its value", edits: &[("\"untouched\"", "\"relaxed\"")], place: "[indentation]", says: &["`indentation.penetration`", "`indentation.contact_radius`", "exactly one"], ..NONE },
    Case { kind: "a frame without its stiffness", edits: &[(PRESSED, "frame = \"4 µm\"\nduration = 1")], place: "[[history]]", says: &["controls `frame`", "indentation.frame_stiffness"], ..NONE },
    Case { kind: "fields without times", edits: &[("", "[indentation.fields]\npoints = 9\n")], place: "[indentation.fields]", says: &["`indentation.fields.times` is missing"], ..NONE },
    Case { kind: "no process zone of an indenter", edits: &[(ZONE, "")], place: "[adhesion]", says: &["`adhesion.process_zone` is missing"], ..NONE },
    Case { kind: "an adhesive contact that grows from no radius", edits: &[(PRESSED, "contact_radius = \"50 µm\"\nduration = 1")], place: "start", says: &["jumps in to a radius of its own", "indentation.contact_radius"], ..NONE },
    // What contradicts.
    Case { kind: "a second rim", edits: &[(SPHERE, "flat_punch = { radius = 1 }\nrim_radius = 0.5")], place: "rim_radius", says: &["`indentation.rim_radius`", "ends at its own radius", "leave it out"], ..NONE },
    Case { kind: "two shapes", edits: &[(SPHERE, "sphere = { radius = 1 }\ncone = { slope = 1 }")], place: "cone", says: &["`indentation.sphere` and `indentation.cone` exclude each other"], ..NONE },
    Case { kind: "two starts", edits: &[("\"untouched\"", "\"relaxed\"\npenetration = 1e-6\nforce = 0")], place: "force", says: &["exclude each other"], ..NONE },
    Case { kind: "a quantity of cracks", edits: &[(PRESSED, "stress_intensity = 1\nduration = 1")], place: "stress_intensity", says: &["not controlled in an indentation", "`penetration`, `force`, `contact_radius`, `frame`"], ..NONE },
    Case { kind: "times of fields that fall", edits: &[("", "[indentation.fields]\ntimes = [2, 1]\n")], place: "times", says: &["`indentation.fields.times`", "not later"], ..NONE },
    Case { kind: "fields of cracks", edits: &[("", "[fields]\npoints = 9\n")], place: "[fields]", says: &["belongs to cracks and sliding contacts", "[indentation.fields]"], ..NONE },
    Case { kind: "a law of cracks for an indenter", edits: &[(ZONE, "process_zone = { cohesive_stress = 1e5, law = \"schapery\" }")], place: "process_zone", says: &["`adhesion.process_zone.law` = \"schapery\"", "must be \"growing\" or \"constant\""], ..NONE },
    Case { kind: "an edge of sliding contacts", edits: &[(ZONE, "process_zone = { trailing_length = 1e-6, leading_length = 1e-6 }")], place: "process_zone", says: &["`adhesion.process_zone.trailing_length` belongs to a sliding contact"], ..NONE },
    Case { kind: "a radius in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle ="), ("\"1 MPa\"", "1"), ("\"9 MPa\"", "9"), ("\"1 s\"", "1"), ("\"50 mJ/m²\"", "1e-4"), ("\"1 µm\"", "0.01"), ("\"1 mm\"", "1"), (PRESSED, "penetration = 0.01\nrate = 1"), ("\"2 s\"", "1")], place: "sphere", says: &["`indentation.sphere.radius`", "is the unit", "sphere = {}"], ..NONE },
    Case { kind: "a shape that cannot be read", edits: &[(SPHERE, "profile = \"nowhere.csv\"")], place: "profile =", says: &["`indentation.profile` = \"nowhere.csv\" cannot be read", "relative paths start at the scene"], ..NONE },
    Case { kind: "a shape without heights", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r (µm), y (µm)\n0, 0\n")), says: &["shape.csv:1:", "no column `z`", "r (µm), z (nm)"], ..NONE },
    Case { kind: "a shape without its unit", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r, z (nm)\n0, 0\n")), says: &["shape.csv:1:", "`r` has no unit"], ..NONE },
    Case { kind: "a shape in seconds", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r (s), z (nm)\n0, 0\n")), says: &["shape.csv:1:", "wrong unit"], ..NONE },
    Case { kind: "a shape that starts off its axis", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r (µm), z (nm)\n1, 0\n2, 1\n3, 2\n4, 5\n")), says: &["shape.csv:2:", "`r` = 1 in the first row", "must be 0"], ..NONE },
    Case { kind: "a shape that falls", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r (µm), z (nm)\n0, 0\n2, 1\n3, 0.5\n4, 5\n")), says: &["shape.csv:4:", "`z` = 0.5 does not increase"], ..NONE },
    Case { kind: "a shape of three rows", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r (µm), z (nm)\n0, 0\n2, 1\n3, 2\n")), says: &["shape.csv:1:", "has 3 rows", "4 to 2000"], ..NONE },
    Case { kind: "a cell of a shape that is no number", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "r (µm), z (nm)\n0, 0\n2, x\n3, 2\n")), says: &["shape.csv:3:", "is no number"], ..NONE },
    Case { kind: "a scan of one side", edits: &[(SPHERE, "profile = \"shape.csv\"")], file: Some(("shape.csv", "x (µm), z (nm)\n0, 0\n1, 1\n2, 4\n3, 9\n4, 16\n5, 25\n6, 36\n7, 49\n8, 64\n")), says: &["shape.csv:1:", "both sides of it are needed"], ..NONE },
    Case { kind: "a scan beyond its largest residual", edits: &[(SPHERE, "profile = \"shape.csv\"\nscan = { largest_residual = 1e-3 }")], file: Some(("shape.csv", "x (µm), z (nm)\n-4, 16\n-3, 10\n-2, 4\n-1, 1\n0, 0\n1, 1.5\n2, 4\n3, 9\n4, 17\n")), says: &["shape.csv:1:", "differs from a round shape", "largest_residual = 0.1"], ..NONE },
    Case { kind: "an apex of a shape over r", edits: &[(SPHERE, "profile = \"shape.csv\"\nscan = { apex = \"lowest\" }")], file: Some(("shape.csv", "r (µm), z (nm)\n0, 0\n1, 1\n2, 4\n3, 9\n")), place: "apex", says: &["`indentation.scan.apex` belongs to a scan of x and z"], ..NONE },
    Case { kind: "a scan of a sphere", edits: &[(SPHERE, "sphere = { radius = 1 }\nscan = { apex = \"lowest\" }")], place: "scan", says: &["`indentation.scan` belongs to a profile"], ..NONE },
    Case { kind: "a table for a sphere", edits: &[(SPHERE, "sphere = { radius = 1 }\nprofile = \"shape.csv\"")], file: Some(("shape.csv", "r (µm), z (nm)\n0, 0\n")), place: "profile", says: &["`indentation.sphere` and `indentation.profile` exclude each other"], ..NONE },
    // Oscillations.
    Case { kind: "misspelt key of an oscillation", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitud = 1e-7, frequency = 1, cycles = 3 }")], place: "amplitud", says: &["`history.1.oscillation.amplitud`", "did you mean `amplitude`?", "knows: quantity, amplitude"], ..NONE },
    Case { kind: "an oscillation of nothing", edits: &[(HELD, "oscillation = { amplitude = 1e-7, frequency = 1, cycles = 3 }")], place: "oscillation", says: &["`history.1.oscillation.quantity` is missing", "\"penetration\", \"force\", \"frame\""], ..NONE },
    Case { kind: "an oscillating radius", edits: &[(HELD, "oscillation = { quantity = \"contact_radius\", amplitude = 1e-7, frequency = 1, cycles = 3 }")], place: "contact_radius", says: &["`history.1.oscillation.quantity` = \"contact_radius\" is not allowed", "allowed: \"penetration\", \"force\", \"frame\""], ..NONE },
    Case { kind: "an oscillation without its amplitude", edits: &[(HELD, "oscillation = { quantity = \"penetration\", frequency = 1, cycles = 3 }")], place: "oscillation", says: &["`history.1.oscillation.amplitude` is missing", "a length such as"], ..NONE },
    Case { kind: "an amplitude of another quantity", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = \"1 mN\", frequency = 1, cycles = 3 }")], place: "1 mN", says: &["`history.1.oscillation.amplitude` = \"1 mN\"", "measured in N", "must be measured in m"], ..NONE },
    Case { kind: "no amplitude", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 0, frequency = 1, cycles = 3 }")], place: "amplitude = 0", says: &["`history.1.oscillation.amplitude` = 0", "greater than 0"], ..NONE },
    Case { kind: "an oscillation without its frequency", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, cycles = 3 }")], place: "oscillation", says: &["`history.1.oscillation.frequency` is missing", "a frequency such as \"5 Hz\""], ..NONE },
    Case { kind: "a frequency in seconds", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = \"2 s\", cycles = 3 }")], place: "2 s", says: &["`history.1.oscillation.frequency` = \"2 s\"", "measured in s", "must be measured in 1/s"], ..NONE },
    Case { kind: "a negative frequency", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = -2, cycles = 3 }")], place: "-2", says: &["`history.1.oscillation.frequency` = -2", "greater than 0"], ..NONE },
    Case { kind: "an oscillation without an end", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1 }")], place: "oscillation", says: &["`history.1.oscillation.cycles`", "`history.1.oscillation.duration`", "exactly one"], ..NONE },
    Case { kind: "an oscillation with two ends", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3, duration = 3 }")], place: "duration", says: &["`history.1.oscillation.cycles` and `history.1.oscillation.duration` exclude each other"], ..NONE },
    Case { kind: "half a cycle", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 0.5 }")], place: "cycles = 0.5", says: &["`history.1.oscillation.cycles` = 0.5", "a whole number from 1"], ..NONE },
    Case { kind: "a way between frequencies without an end", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3, frequency_sweep = \"linear\" }")], place: "frequency_sweep", says: &["`history.1.oscillation.frequency_sweep`", "`to_frequency`, which is missing"], ..NONE },
    Case { kind: "an unknown way between frequencies", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, to_frequency = 2, cycles = 3, frequency_sweep = \"log\" }")], place: "frequency_sweep", says: &["`history.1.oscillation.frequency_sweep` = \"log\"", "\"linear\", \"logarithmic\""], ..NONE },
    Case { kind: "a flag that is a text", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3, until_stationary = \"yes\" }")], place: "until_stationary", says: &["`history.1.oscillation.until_stationary` is a text: \"yes\"", "must be true or false"], ..NONE },
    Case { kind: "a stationary ramp", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3, until_stationary = true, to = 0 }")], place: "to = 0", says: &["`history.1.oscillation.until_stationary` = true excludes `history.1.oscillation.to`", "never stationary"], ..NONE },
    Case { kind: "a stationary sweep of frequency", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, to_frequency = 2, cycles = 3, until_stationary = true }")], place: "to_frequency", says: &["excludes `history.1.oscillation.to_frequency`"], ..NONE },
    Case { kind: "a stationary cycle within a duration", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, duration = 3, until_stationary = true }")], place: "duration", says: &["`history.1.oscillation.until_stationary` = true", "needs `cycles`"], ..NONE },
    Case { kind: "an oscillation about what nobody knows", edits: &[(HELD, "oscillation = { quantity = \"force\", amplitude = 1e-5, frequency = 1, cycles = 3 }")], place: "oscillation", says: &["`history.1.oscillation`", "`penetration` is controlled", "give `to`"], ..NONE },
    Case { kind: "an oscillating frame without its stiffness", edits: &[(PRESSED, "oscillation = { quantity = \"frame\", amplitude = 1e-7, frequency = 1, cycles = 3 }")], place: "[[history]]", says: &["controls `frame`", "indentation.frame_stiffness"], ..NONE },
    Case { kind: "keys beside an oscillation", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3 }\nperiod = 2")], place: "period", says: &["`history.1.period` does not belong to a segment with `oscillation`", "it stands alone"], ..NONE },
    Case { kind: "a cycle for ever among others", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, periodic = true }")], place: "periodic", says: &["`history.1.oscillation.periodic` = true", "other segments", "indentation.penetration"], ..NONE },
    Case { kind: "a number of cycles for ever", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, periodic = true, cycles = 3 }")], place: "cycles = 3", says: &["`history.1.oscillation.periodic` = true excludes `history.1.oscillation.cycles`"], ..NONE },
    Case { kind: "a mean that goes for ever", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, periodic = true, to = 1e-6 }")], place: "to = 1e-6", says: &["excludes `history.1.oscillation.to`"], ..NONE },
    Case { kind: "a cycle for ever from nothing", edits: &[("[[history]]\npenetration = \"4 µm\"\nrate = \"2 µm/s\"\n", ""), (HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, periodic = true }")], place: "start = ", says: &["`history.0.oscillation.periodic` = true needs indentation.start = \"relaxed\""], ..NONE },
    Case { kind: "a swept amplitude of nothing", edits: &[(HELD, "oscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1, cycles = 3 }"), ("", "[sweep]\nkey = \"history.1.oscillation.amplitude\"\nvalues = [0, 1e-7]\n")], place: "values = [0", says: &["`history.1.oscillation.amplitude` = 0", "greater than 0"], ..NONE },
    Case { kind: "a sweep over a hold that is none", edits: &[("", "[sweep]\nkey = \"history.7.hold\"\nvalues = [1]\n")], place: "key = ", says: &["`sweep.key` = \"history.7.hold\""], ..NONE },
    Case { kind: "a table without keys given as a flag", edits: &[(SPHERE, "sphere = { radius = \"1 mm\" }\nenergies = true")], place: "energies", says: &["`indentation.energies`", "must be a table", "this table has no keys", "[indentation.energies] on a line of its own"], ..NONE },
];
