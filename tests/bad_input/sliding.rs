//! Mistakes about a sliding contact and its branches.

use super::{Case, NONE};

const LOAD: &str = "mean_pressure = \"6 kPa\"";
const WAVE: &str = "[sliding.wave]\nwavelength = \"100 µm\"\namplitude = \"3 µm\"\n";
const SLIDING_ZONE: &str = "process_zone = { length = \"0.16 µm\" }";
const CYLINDER: &str = "[sliding.cylinder]\nradius = \"5 mm\"\n";

/// In place of the fields.
const BRANCH: &str = "\n[sliding.branch]\nparameter = \"half_width\"\nfrom = \"2 µm\"\nto = \"40 µm\"\npoints = 9\n";

/// Mistakes about a sliding contact.
#[rustfmt::skip]
pub const SLIDING_CASES: &[Case] = &[
    // Keys that do not exist.
    Case { kind: "misspelt key of sliding", edits: &[("mean_pressure", "mean_presure")], place: "mean_presure", says: &["`sliding.mean_presure`", "did you mean `mean_pressure`?", "[sliding] knows: wave, cylinder"], ..NONE },
    Case { kind: "misspelt key of the wave", edits: &[("wavelength", "wave_length")], place: "wave_length", says: &["`sliding.wave.wave_length`", "did you mean `wavelength`?", "[sliding.wave] knows: wavelength, amplitude"], ..NONE },
    Case { kind: "misspelt table of sliding", edits: &[("[sliding.wave]", "[sliding.waves]")], place: "waves", says: &["`sliding.waves`", "did you mean `wave`?"], ..NONE },
    Case { kind: "a key of a crack", edits: &[(LOAD, "energy_release_rate = 3")], place: "energy_release_rate", says: &["`sliding.energy_release_rate`", "`crack.energy_release_rate` exists"], ..NONE },
    Case { kind: "misspelt kind of contact", edits: &[("\"adhesiveless\"", "\"adhesionless\"")], place: "adhesionless", says: &["`sliding.contacts` = \"adhesionless\"", "did you mean \"adhesiveless\"?", "allowed: \"adhesive\", \"adhesiveless\""], ..NONE },
    // Numbers and units.
    Case { kind: "pressure with a unit of force", edits: &[(LOAD, "mean_pressure = \"6 N\"")], place: "6 N", says: &["`sliding.mean_pressure` = \"6 N\"", "measured in Pa", "a pressure such as"], ..NONE },
    Case { kind: "speed with a unit of length", edits: &[("speed = \"1 mm/s\"", "speed = \"1 mm\"")], place: "speed = ", says: &["`sliding.speed` = \"1 mm\"", "measured in m/s"], ..NONE },
    Case { kind: "line load with a unit of pressure", edits: &[(WAVE, CYLINDER), (LOAD, "load_per_width = \"6 kPa\"")], place: "load_per_width", says: &["`sliding.load_per_width` = \"6 kPa\"", "measured in N/m", "a load per width such as"], ..NONE },
    Case { kind: "wavelength of zero", edits: &[("wavelength = \"100 µm\"", "wavelength = 0")], place: "wavelength", says: &["`sliding.wave.wavelength` = 0", "greater than 0"], ..NONE },
    Case { kind: "negative amplitude", edits: &[("amplitude = \"3 µm\"", "amplitude = -1")], place: "amplitude", says: &["`sliding.wave.amplitude` = -1", "greater than 0"], ..NONE },
    Case { kind: "half-width of zero", edits: &[(LOAD, "half_width = 0")], place: "half_width", says: &["`sliding.half_width` = 0", "greater than 0"], ..NONE },
    Case { kind: "half-width beyond half a wavelength", edits: &[(LOAD, "half_width = \"60 µm\"")], place: "half_width", says: &["`sliding.half_width` (6e-5)", "half the wavelength", "no edges"], ..NONE },
    Case { kind: "a speed that is no number", edits: &[("speed = \"1 mm/s\"", "speed = nan")], place: "speed = nan", says: &["`sliding.speed` = nan", "must be finite"], ..NONE },
    // What is missing.
    Case { kind: "no body that slides", edits: &[(WAVE, "")], place: "[sliding]", says: &["`sliding.wave`", "`sliding.cylinder`", "exactly one"], ..NONE },
    Case { kind: "no speed", edits: &[("speed = \"1 mm/s\"\n", "")], place: "[sliding]", says: &["`sliding.speed` is missing", "a speed such as"], ..NONE },
    Case { kind: "no load of a wave", edits: &[(LOAD, "")], place: "[sliding]", says: &["`sliding.mean_pressure`", "`sliding.penetration`", "`sliding.half_width`", "exactly one"], ..NONE },
    Case { kind: "no load of a cylinder", edits: &[(WAVE, CYLINDER), (LOAD, "")], place: "[sliding]", says: &["`sliding.load_per_width`", "`sliding.half_width`", "exactly one"], ..NONE },
    Case { kind: "no amplitude", edits: &[("amplitude = \"3 µm\"\n", "")], place: "[sliding.wave]", says: &["`sliding.wave.amplitude` is missing", "a length such as"], ..NONE },
    Case { kind: "no Poisson ratio", edits: &[("poisson_ratio = 0.49\n", "")], place: "[material]", says: &["`material.poisson_ratio` is missing", "plane strain"], ..NONE },
    Case { kind: "adhesive contacts without adhesion", edits: &[("[adhesion]\nwork_of_adhesion = \"20 mJ/m²\"\nprocess_zone = { length = \"0.16 µm\" }\n", "")], place: "contacts", says: &["`sliding.contacts` names an adhesive contact", "add [adhesion]"], ..NONE },
    Case { kind: "no work of adhesion", edits: &[("work_of_adhesion = \"20 mJ/m²\"\n", "")], place: "[adhesion]", says: &["`adhesion.work_of_adhesion` is missing"], ..NONE },
    Case { kind: "no process zone", edits: &[(SLIDING_ZONE, "")], place: "[adhesion]", says: &["`adhesion.process_zone` is missing"], ..NONE },
    Case { kind: "one of two process zones", edits: &[("{ length = ", "{ trailing_length = ")], place: "process_zone", says: &["`adhesion.process_zone.leading_length` is missing"], ..NONE },
    Case { kind: "no modulus of the counter body", edits: &[("", "[sliding.counter_body]\npoisson_ratio = 0.3\n")], place: "[sliding.counter_body]", says: &["`sliding.counter_body.modulus` is missing"], ..NONE },
    Case { kind: "no Poisson ratio of the counter body", edits: &[("", "[sliding.counter_body]\nmodulus = \"1 GPa\"\n")], place: "[sliding.counter_body]", says: &["`sliding.counter_body.poisson_ratio` is missing"], ..NONE },
    // What contradicts.
    Case { kind: "a wave and a cylinder", edits: &[("", CYLINDER)], place: "[sliding.cylinder]", says: &["`sliding.wave` and `sliding.cylinder` exclude each other"], ..NONE },
    Case { kind: "two loads", edits: &[(LOAD, "mean_pressure = 1\npenetration = \"1 µm\"")], place: "penetration", says: &["`sliding.mean_pressure` and `sliding.penetration` exclude each other", "leave one"], ..NONE },
    Case { kind: "a load and a width", edits: &[(LOAD, "half_width = \"9 µm\"\nmean_pressure = 1")], place: "half_width", says: &["`sliding.mean_pressure` and `sliding.half_width` exclude each other"], ..NONE },
    Case { kind: "a line load of a wave", edits: &[(LOAD, "load_per_width = 3")], place: "load_per_width", says: &["`sliding.load_per_width` does not belong to this body", "a wave carries a mean pressure", "`sliding.mean_pressure`"], ..NONE },
    Case { kind: "a mean pressure of a cylinder", edits: &[(WAVE, CYLINDER)], place: "mean_pressure", says: &["`sliding.mean_pressure` does not belong to this body", "`sliding.load_per_width`"], ..NONE },
    Case { kind: "a penetration of a cylinder", edits: &[(WAVE, CYLINDER), (LOAD, "penetration = 1e-6")], place: "penetration", says: &["`sliding.penetration` does not belong to this body", "without bound"], ..NONE },
    Case { kind: "a growing zone", edits: &[("length = \"0.16 µm\"", "cohesive_stress = 1e6, law = \"growing\"")], place: "process_zone", says: &["`adhesion.process_zone.law` = \"growing\"", "cracks", "\"constant\""], ..NONE },
    Case { kind: "Schapery's zone", edits: &[("length = \"0.16 µm\"", "cohesive_stress = 1e6, law = \"schapery\"")], place: "process_zone", says: &["\"schapery\"", "cracks"], ..NONE },
    Case { kind: "a factor of a given zone", edits: &[("length = \"0.16 µm\"", "length = \"0.16 µm\", factor = 1")], place: "process_zone", says: &["`adhesion.process_zone.factor`", "belongs to a cohesive stress"], ..NONE },
    Case { kind: "one zone and two", edits: &[("length = \"0.16 µm\"", "length = 1e-7, leading_length = 1e-7")], place: "process_zone", says: &["`adhesion.process_zone.length` and `adhesion.process_zone.leading_length` exclude each other"], ..NONE },
    Case { kind: "distances of fields", edits: &[("points = 40", "from = \"1 nm\"")], place: "from = \"1 nm\"", says: &["`fields.from` belongs to a crack", "leave it out"], ..NONE },
    // Works of both edges and by speed; columns on request.
    Case { kind: "one of two works", edits: &[("work_of_adhesion = \"20 mJ/m²\"", "leading_work_of_adhesion = 1")], place: "[adhesion]", says: &["`adhesion.trailing_work_of_adhesion` is missing", "where the contact opens"], ..NONE },
    Case { kind: "one work and two", edits: &[("work_of_adhesion = \"20 mJ/m²\"", "work_of_adhesion = 1\ntrailing_work_of_adhesion = 1\nleading_work_of_adhesion = 1")], place: "trailing_work_of_adhesion", says: &["`adhesion.work_of_adhesion` and `adhesion.trailing_work_of_adhesion` exclude each other"], ..NONE },
    Case { kind: "misspelt key of a law by speed", edits: &[(SLIDING_ZONE, "process_zone = { length = 1e-7 }\nby_speed = { speed = 1, exponant = 1 }")], place: "by_speed", says: &["`adhesion.by_speed.exponant`", "did you mean `exponent`?"], ..NONE },
    Case { kind: "a law by speed and a table", edits: &[(SLIDING_ZONE, "process_zone = { length = 1e-7 }\nby_speed = { speed = 1, exponent = 1, table = [] }")], place: "by_speed", says: &["`adhesion.by_speed.speed` and `adhesion.by_speed.table` exclude each other"], ..NONE },
    Case { kind: "misspelt columns", edits: &[(LOAD, "mean_pressure = 1\ncolumns = [\"sensitivity\"]")], place: "columns", says: &["`sliding.columns` = \"sensitivity\"", "did you mean \"sensitivities\"?", "\"friction_parts\""], ..NONE },
    Case { kind: "friction of a strength", edits: &[(LOAD, "columns = [\"friction_parts\"]"), ("\n[fields]\npoints = 40\n", "\n[sliding.strength]\n"), ("[\"adhesive\", \"adhesiveless\"]", "[\"adhesive\"]")], place: "columns", says: &["a strength has no friction", "leave \"friction_parts\" out"], ..NONE },
    // Branches and strengths.
    Case { kind: "misspelt key of a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("parameter = ", "parametre = ")], place: "parametre", says: &["`sliding.branch.parametre`", "did you mean `parameter`?"], ..NONE },
    Case { kind: "misspelt parameter of a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"halfwidth\"")], place: "halfwidth", says: &["`sliding.branch.parameter` = \"halfwidth\"", "did you mean \"half_width\"?"], ..NONE },
    Case { kind: "no parameter of a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("parameter = \"half_width\"\n", "")], place: "[sliding.branch]", says: &["`sliding.branch.parameter` is missing", "allowed: \"mean_pressure\""], ..NONE },
    Case { kind: "a branch along a line load of a wave", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"load_per_width\"")], place: "parameter", says: &["does not belong to this body", "\"mean_pressure\""], ..NONE },
    Case { kind: "one end of a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("to = \"40 µm\"\n", "")], place: "[sliding.branch]", says: &["`sliding.branch.to` is missing"], ..NONE },
    Case { kind: "ends of a branch the wrong way round", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("to = \"40 µm\"", "to = \"1 µm\"")], place: "to = ", says: &["`sliding.branch.to` (1e-6) is not above `sliding.branch.from`"], ..NONE },
    Case { kind: "an end of a branch in another unit", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("to = \"40 µm\"", "to = \"40 kPa\"")], place: "40 kPa", says: &["`sliding.branch.to` = \"40 kPa\"", "measured in m"], ..NONE },
    Case { kind: "a branch beyond half a wavelength", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("to = \"40 µm\"", "to = \"60 µm\"")], place: "to = ", says: &["`sliding.branch.to` (6e-5)", "half the wavelength"], ..NONE },
    Case { kind: "a half-width of zero on a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("from = \"2 µm\"", "from = 0")], place: "from = ", says: &["`sliding.branch.from` is out of range along half_width", "greater than 0"], ..NONE },
    Case { kind: "misspelt branches of a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("points = 9", "points = 9\nbranches = \"evry\"")], place: "evry", says: &["`sliding.branch.branches` = \"evry\"", "did you mean \"every\"?"], ..NONE },
    Case { kind: "every branch over a range of loads", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"penetration\""), ("points = 9", "points = 9\nbranches = \"every\"")], place: "branches = ", says: &["`sliding.branch.branches` = \"every\" goes through every load", "a range of penetration is given", "leave `from` and `to` out"], ..NONE },
    Case { kind: "too few points of a branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("points = 9", "points = 1")], place: "points = 1", says: &["`sliding.branch.points` = 1", "from 2 to 10000"], ..NONE },
    Case { kind: "a load and a branch of loads", edits: &[("\n[fields]\npoints = 40\n", BRANCH)], place: "mean_pressure", says: &["`sliding.mean_pressure` is given, but [sliding.branch] goes through every load", "leave it out"], ..NONE },
    Case { kind: "a speed and a branch of speeds", edits: &[("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"speed\""), ("\"2 µm\"", "\"2 µm/s\""), ("\"40 µm\"", "\"40 µm/s\"")], place: "speed = ", says: &["`sliding.speed` is given, and runs along the branch", "leave it out"], ..NONE },
    Case { kind: "no load of a branch of speeds", edits: &[(LOAD, ""), ("speed = \"1 mm/s\"\n", ""), ("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"speed\""), ("\"2 µm\"", "\"2 µm/s\""), ("\"40 µm\"", "\"40 µm/s\"")], place: "[sliding]", says: &["`sliding.mean_pressure`", "exactly one"], ..NONE },
    Case { kind: "a branch that does not reach its start", edits: &[("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"work_of_adhesion\""), ("\"2 µm\"", "\"30 mJ/m²\""), ("\"40 µm\"", "\"40 mJ/m²\"")], place: "from = ", says: &["the branch begins at adhesion.work_of_adhesion (2e-2)", "must reach to"], ..NONE },
    Case { kind: "works of adhesion with a cohesive stress", edits: &[("length = \"0.16 µm\"", "cohesive_stress = \"1 MPa\""), ("\n[fields]\npoints = 40\n", BRANCH), ("\"half_width\"", "\"work_of_adhesion\""), ("\"2 µm\"", "\"2 mJ/m²\""), ("\"40 µm\"", "\"40 mJ/m²\"")], place: "parameter", says: &["holds the process zones", "needs a process zone by length"], ..NONE },
    Case { kind: "fields of a branch", edits: &[(LOAD, ""), ("[fields]", "[sliding.branch]\nparameter = \"half_width\"\n[fields]")], place: "fields", says: &["[fields] belongs to a contact under one load"], ..NONE },
    Case { kind: "an adhesiveless branch", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH)], place: "contacts", says: &["branches and strengths are of adhesive ones"], ..NONE },
    Case { kind: "a branch without adhesion", edits: &[("[adhesion]\nwork_of_adhesion = \"20 mJ/m²\"\nprocess_zone = { length = \"0.16 µm\" }\n", ""), (LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH)], place: "branch", says: &["[sliding.branch] is about adhesive contacts", "needs [adhesion]"], ..NONE },
    Case { kind: "a branch and a strength", edits: &[(LOAD, ""), ("[fields]", "[sliding.branch]\nparameter = \"half_width\"\n[sliding.strength]\n[fields]")], place: "[sliding.strength]", says: &["`sliding.branch` and `sliding.strength` exclude each other"], ..NONE },
    Case { kind: "a load and a strength", edits: &[("\n[fields]\npoints = 40\n", "\n[sliding.strength]\n")], place: "mean_pressure", says: &["[sliding.strength] goes through every load"], ..NONE },
    Case { kind: "a key of a strength", edits: &[(LOAD, ""), ("\n[fields]\npoints = 40\n", "\n[sliding.strength]\npoints = 3\n")], place: "points", says: &["`sliding.strength.points` is not a key"], ..NONE },
    Case { kind: "a frame of a cylinder", edits: &[(WAVE, CYLINDER), (LOAD, ""), ("\n[fields]\npoints = 40\n", BRANCH), ("\"40 µm\"", "\"400 µm\"\nframe_stiffness = \"1 kPa/µm\"")], place: "frame_stiffness", says: &["`sliding.branch.frame_stiffness`", "a cylinder has no penetration"], ..NONE },
    Case { kind: "a crack besides", edits: &[("", "[crack]\nspeed = 1\n")], place: "[sliding]", says: &["more than one problem: crack, sliding"], ..NONE },
    // Reduced scenes.
    Case { kind: "a wavelength in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle ="), ("\"1 MPa\"", "1"), ("\"10 MPa\"", "10"), ("\"10 ms\"", "1"), ("\"20 mJ/m²\"", "0.01"), ("\"0.16 µm\"", "0.01"), ("\"1 mm/s\"", "1"), ("\"6 kPa\"", "0.05"), ("\"100 µm\"", "6"), ("\"3 µm\"", "1")], place: "wavelength", says: &["`sliding.wave.wavelength`", "is the unit", "leave it out"], ..NONE },
    Case { kind: "a counter body in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle ="), ("\"1 MPa\"", "1"), ("\"10 MPa\"", "10"), ("\"10 ms\"", "1"), ("\"20 mJ/m²\"", "0.01"), ("\"0.16 µm\"", "0.01"), ("\"1 mm/s\"", "1"), ("\"6 kPa\"", "0.05"), (WAVE, "[sliding.wave]\n[sliding.counter_body]\nmodulus = 3\npoisson_ratio = 0.3\n")], place: "[sliding.counter_body]", says: &["`sliding.counter_body`", "both bodies together"], ..NONE },
    // Sweeps.
    Case { kind: "a sweep over an absent counter body", edits: &[("", "[sweep]\nkey = \"sliding.counter_body.modulus\"\nvalues = [1]\n")], place: "key = ", says: &["`sweep.key` = \"sliding.counter_body.modulus\"", "add [sliding.counter_body]"], ..NONE },
    Case { kind: "a sweep over contacts", edits: &[("", "[sweep]\nkey = \"sliding.contacts\"\nvalues = [1]\n")], place: "key = ", says: &["`sweep.key` = \"sliding.contacts\"", "takes no number"], ..NONE },
    Case { kind: "a logarithmic sweep of speeds of both signs", edits: &[("", "[sweep]\nkey = \"sliding.speed\"\nfrom = -1\nto = 1\npoints = 3\n")], place: "from = -1", says: &["logarithmic", "spacing = \"linear\""], ..NONE },
    Case { kind: "columns of an adhesive contact without adhesion", edits: &[("[adhesion]\nwork_of_adhesion = \"20 mJ/m²\"\n", ""), (SLIDING_ZONE, ""), (LOAD, "mean_pressure = 1\ncolumns = [\"friction_parts\"]")], place: "columns", says: &["`sliding.columns` names \"friction_parts\"", "the scene has no [adhesion]", "add [adhesion], or delete this line", "work_of_adhesion ="], ..NONE },
];
