//! A wrong scene or call is answered by one error that a person can act on.
//!
//! Contract: the scene section of the design ("an error that names file, line, key, value, what is allowed, and the nearest key").
//! Goal: every kind of mistake ends with exit code 2, exactly one error on standard error, nothing on standard output, and no folder.
//! Parameters: a crack and a sliding contact that are right, and for each kind of mistake the edits that spoil it.
//! Oracle: for each kind, the line that must be named (found in the spoilt text by a marker) and the words that must be said.
//! Tolerance: none; the words are key, value, what is allowed and the nearest key, wherever these exist for the kind.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::bad_input;
use crate::command_support;

use bad_input::delayed::DELAYED_CASES;
use bad_input::indentation::{INDENTATION, INDENTATION_CASES};
use bad_input::sliding::SLIDING_CASES;
use bad_input::{Case, NONE};
use command_support::{Answer, DELAYED, Folder, GOOD, SLIDING};

const SPEED: &str = "speed = \"1 mm/s\"";
const SWEPT: &str = "key = \"crack.speed\"\nfrom = \"1 µm/s\"\nto = \"1 m/s\"\npoints = 3";
const ZONE: &str = "process_zone = { cohesive_stress = \"1 MPa\" }";
const CREEP: &str = "creep = [
  { fraction = 0.4, retardation_time = \"1 s\" },
  { fraction = 0.6, retardation_time = \"1 ms\" },
]";
const FIELDS: &str = "[fields]\nfrom = \"1 nm\"\nto = \"1 mm\"\npoints = 5\n";

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Keys that do not exist.
    Case { kind: "unknown key of the scene", edits: &[("title =", "titel =")], place: "titel", says: &["`titel`", "did you mean `title`?", "knows: title, units"], ..NONE },
    Case { kind: "unknown key of a table", edits: &[("body =", "bodie =")], place: "bodie", says: &["`crack.bodie`", "did you mean `body`?", "[crack] knows: motion, body"], ..NONE },
    Case { kind: "unknown key of an inline table", edits: &[("cohesive_stress", "cohesive_stres")], place: "process_zone", says: &["`adhesion.process_zone.cohesive_stres`", "did you mean `cohesive_stress`?", "knows: length"], ..NONE },
    Case { kind: "unknown key of a list item", edits: &[("retardation_time = \"1 ms\"", "relaxation_time = \"1 ms\"")], place: "\"1 ms\"", says: &["relaxation_time", "did you mean `retardation_time`?", "knows: compliance, fraction, retardation_time"], ..NONE },
    Case { kind: "unknown table", edits: &[("[adhesion]", "[adhesin]")], place: "[adhesin]", says: &["`adhesin`", "did you mean `adhesion`?"], ..NONE },
    Case { kind: "a key of another table", edits: &[(SPEED, "work_of_adhesion = 1")], place: "work_of_adhesion = 1", says: &["`crack.work_of_adhesion`", "`adhesion.work_of_adhesion` exists"], ..NONE },
    Case { kind: "a key like no other", edits: &[(SPEED, "zzz = 1")], place: "zzz", says: &["`crack.zzz`", "unknown key", "[crack] knows: motion"], ..NONE },
    // Numbers and units.
    Case { kind: "unit of another dimension", edits: &[(SPEED, "speed = \"1 mm\"")], place: "speed = \"1 mm\"", says: &["`crack.speed` = \"1 mm\"", "measured in m/s", "a speed such as"], ..NONE },
    Case { kind: "unit that does not exist", edits: &[(SPEED, "speed = \"1 furlong/s\"")], place: "furlong", says: &["`crack.speed` = \"1 furlong/s\"", "`furlong` is not a unit", "a speed such as"], ..NONE },
    Case { kind: "unit cut short", edits: &[(SPEED, "speed = \"1 mm/\"")], place: "\"1 mm/\"", says: &["`crack.speed` = \"1 mm/\"", "cannot be read", "a speed such as"], ..NONE },
    Case { kind: "two strokes in a unit", edits: &[(SPEED, "speed = \"1 mm//s\"")], place: "\"1 mm//s\"", says: &["`crack.speed`", "cannot be read at `/s`", "a speed such as"], ..NONE },
    Case { kind: "power that is no number", edits: &[(SPEED, "speed = \"1 mm^x\"")], place: "\"1 mm^x\"", says: &["`crack.speed`", "cannot be read at `^x`"], ..NONE },
    Case { kind: "unit without a number", edits: &[(SPEED, "speed = \"mm/s\"")], place: "\"mm/s\"", says: &["`crack.speed` = \"mm/s\"", "does not begin with a number", "a speed such as"], ..NONE },
    Case { kind: "empty text for a number", edits: &[(SPEED, "speed = \"\"")], place: "speed = \"\"", says: &["`crack.speed` = \"\"", "does not begin with a number"], ..NONE },
    Case { kind: "not a number", edits: &[(SPEED, "speed = nan")], place: "nan", says: &["`crack.speed` = nan", "must be finite"], ..NONE },
    Case { kind: "infinity", edits: &[(SPEED, "speed = inf")], place: "inf", says: &["`crack.speed` = inf", "must be finite"], ..NONE },
    Case { kind: "minus infinity", edits: &[(SPEED, "speed = -inf")], place: "-inf", says: &["`crack.speed` = -inf", "must be finite"], ..NONE },
    Case { kind: "not a number, as a text", edits: &[(SPEED, "speed = \"nan m/s\"")], place: "nan", says: &["`crack.speed` = \"nan m/s\"", "does not begin with a number"], ..NONE },
    Case { kind: "a number beyond all doubles", edits: &[(SPEED, "speed = 1e400")], place: "1e400", says: &["`crack.speed` = 1e400", "must be finite"], ..NONE },
    Case { kind: "a text beyond all doubles", edits: &[(SPEED, "speed = \"1e400 m/s\"")], place: "1e400", says: &["`crack.speed` = \"1e400 m/s\"", "must be finite"], ..NONE },
    Case { kind: "negative speed", edits: &[(SPEED, "speed = -1")], place: "speed = -1", says: &["`crack.speed` = -1", "0 or more"], ..NONE },
    Case { kind: "negative modulus", edits: &[("\"100 MPa\"", "\"-100 MPa\"")], place: "glassy", says: &["`material.glassy_modulus` = \"-100 MPa\"", "greater than 0"], ..NONE },
    Case { kind: "zero time", edits: &[("retardation_time = \"1 s\"", "retardation_time = 0")], place: "retardation_time = 0", says: &["retardation_time` = 0", "greater than 0"], ..NONE },
    Case { kind: "work of adhesion of zero", edits: &[("\"1 J/m²\"", "0")], place: "work_of_adhesion", says: &["`adhesion.work_of_adhesion` = 0", "greater than 0"], ..NONE },
    Case { kind: "Poisson ratio above one half", edits: &[("0.49", "0.6")], place: "0.6", says: &["`material.poisson_ratio` = 0.6", "greater than -1 and at most 0.5"], ..NONE },
    Case { kind: "accuracy of zero", edits: &[("title =", "accuracy = 0\ntitle =")], place: "accuracy", says: &["`accuracy` = 0", "greater than 0 and at most 0.1"], ..NONE },
    Case { kind: "accuracy of one", edits: &[("title =", "accuracy = 1\ntitle =")], place: "accuracy", says: &["`accuracy` = 1", "at most 0.1"], ..NONE },
    Case { kind: "an effect with a zero length", edits: &[("from = \"1 nm\"", "from = 0")], place: "from = 0", says: &["`fields.from` = 0", "greater than 0"], ..NONE },
    // Types.
    Case { kind: "a table for a number", edits: &[(SPEED, "speed = { value = 1 }")], place: "{ value = 1 }", says: &["`crack.speed` is a table", "{ value = 1 }", "a speed such as"], ..NONE },
    Case { kind: "a list for a number", edits: &[(SPEED, "speed = [1, 2]")], place: "[1, 2]", says: &["`crack.speed` is a list", "[1, 2]", "a speed such as"], ..NONE },
    Case { kind: "a flag for a number", edits: &[(SPEED, "speed = true")], place: "true", says: &["`crack.speed` is true or false", "a speed such as"], ..NONE },
    Case { kind: "a date for a number", edits: &[(SPEED, "speed = 2024-01-01")], place: "2024-01-01", says: &["`crack.speed` is a date: 2024-01-01", "a speed such as"], ..NONE },
    Case { kind: "a number for a text", edits: &[("\"A scene for tests\"", "3")], place: "title = 3", says: &["`title` is a number: 3", "a text in quotes"], ..NONE },
    Case { kind: "a number for a word", edits: &[("\"opening\"", "3")], place: "motion = 3", says: &["`crack.motion` is a number: 3", "\"opening\", \"closing\""], ..NONE },
    Case { kind: "a text for a list of words", edits: &[("[\"virtual_work\"]", "\"virtual_work\"")], place: "theories", says: &["`crack.theories` is a text", "a list of texts", "\"virtual_work\", \"persson_brener\", \"cohesive_zone\""], ..NONE },
    Case { kind: "a number among words", edits: &[("[\"virtual_work\"]", "[3]")], place: "theories", says: &["`crack.theories` is a number: 3", "\"persson_brener\""], ..NONE },
    Case { kind: "a text for a table", edits: &[(ZONE, "process_zone = \"1 MPa\"")], place: "process_zone", says: &["`adhesion.process_zone` is a text: \"1 MPa\"", "must be a table", "length, cohesive_stress"], ..NONE },
    Case { kind: "a table for a list of tables", edits: &[(CREEP, "creep = { fraction = 1 }")], place: "creep", says: &["`material.creep` is a table", "a list of tables"], ..NONE },
    Case { kind: "numbers for a list of tables", edits: &[(CREEP, "creep = [1, 2]")], place: "creep", says: &["`material.creep.0` is a number: 1", "must be a table", "compliance, fraction, retardation_time"], ..NONE },
    Case { kind: "a text for a count", edits: &[("points = 5", "points = \"5\"")], place: "points = \"5\"", says: &["`fields.points` is a text: \"5\"", "a whole number from 2 to 100000"], ..NONE },
    Case { kind: "a fractional count", edits: &[("points = 5", "points = 5.5")], place: "5.5", says: &["`fields.points` = 5.5", "a whole number from 2"], ..NONE },
    Case { kind: "a text for the sweep", edits: &[("[sweep]\n", ""), (SWEPT, ""), ("title =", "sweep = \"crack.speed\"\ntitle =")], place: "sweep = ", says: &["`sweep` is a text", "must be a table"], ..NONE },
    Case { kind: "a number for the swept key", edits: &[("key = \"crack.speed\"", "key = 3")], place: "key = 3", says: &["`sweep.key` is a number: 3", "a text in quotes"], ..NONE },
    // Words.
    Case { kind: "misspelt word", edits: &[("\"opening\"", "\"openning\"")], place: "openning", says: &["`crack.motion` = \"openning\"", "did you mean \"opening\"?", "allowed: \"opening\", \"closing\""], ..NONE },
    Case { kind: "misspelt word in a list", edits: &[("[\"virtual_work\"]", "[\"virtual work\"]")], place: "theories", says: &["`crack.theories` = \"virtual work\"", "did you mean \"virtual_work\"?", "\"cohesive_zone\""], ..NONE },
    Case { kind: "word like no other", edits: &[("\"stress\"", "\"xyz\"")], place: "xyz", says: &["`crack.plane` = \"xyz\"", "allowed: \"stress\", \"strain\""], ..NONE },
    Case { kind: "unknown unit system", edits: &[("title =", "units = \"cgs\"\ntitle =")], place: "cgs", says: &["`units` = \"cgs\"", "allowed: \"si\", \"reduced\""], ..NONE },
    Case { kind: "empty list of words", edits: &[("[\"virtual_work\"]", "[]")], place: "theories", says: &["`crack.theories` is an empty list", "name at least one", "\"virtual_work\""], ..NONE },
    Case { kind: "a word twice", edits: &[("[\"virtual_work\"]", "[\"virtual_work\", \"virtual_work\"]")], place: "theories", says: &["`crack.theories` names \"virtual_work\" twice", "leave one out"], ..NONE },
    // What is missing.
    Case { kind: "no problem", edits: &[("[crack]\nmotion = \"opening\"\nbody = \"against_rigid\"\nplane = \"stress\"\ntheories = [\"virtual_work\"]\nspeed = \"1 mm/s\"\n", ""), ("[sweep]\n", ""), (SWEPT, "")], place: "points = 5", says: &["names no problem", "[crack]"], ..NONE },
    Case { kind: "no material", edits: &[("[material]\nrelaxed_modulus = \"1 MPa\"\nglassy_modulus = \"100 MPa\"\npoisson_ratio = 0.49\n", ""), (CREEP, "")], place: "points = 5", says: &["[material] is missing", "material.relaxed_modulus"], ..NONE },
    Case { kind: "no adhesion", edits: &[("[adhesion]\nwork_of_adhesion = \"1 J/m²\"\n", ""), (ZONE, "")], place: "points = 5", says: &["[adhesion] is missing", "adhesion.work_of_adhesion"], ..NONE },
    Case { kind: "required number missing", edits: &[("work_of_adhesion = \"1 J/m²\"\n", "")], place: "[adhesion]", says: &["`adhesion.work_of_adhesion` is missing", "Δγ", "an energy per area such as"], ..NONE },
    Case { kind: "required table missing", edits: &[(ZONE, "")], place: "[adhesion]", says: &["`adhesion.process_zone` is missing"], ..NONE },
    Case { kind: "required word missing", edits: &[("body = \"against_rigid\"\n", "")], place: "[crack]", says: &["`crack.body` is missing", "\"against_rigid\", \"two_halves\""], ..NONE },
    Case { kind: "required number of a list item missing", edits: &[(", retardation_time = \"1 ms\"", "")], place: "0.6", says: &["`material.creep.1.retardation_time` is missing", "a time such as"], ..NONE },
    Case { kind: "fields without an end", edits: &[("to = \"1 mm\"\n", "")], place: "[fields]", says: &["`fields.to` is missing", "a length such as"], ..NONE },
    Case { kind: "none of several controls", edits: &[("\nspeed = \"1 mm/s\"", ""), ("[sweep]\n", ""), (SWEPT, "")], place: "[crack]", says: &["`crack.speed`", "`crack.energy_release_rate`", "`crack.stress_intensity`", "`crack.strip`", "exactly one"], ..NONE },
    Case { kind: "no process-zone length nor stress", edits: &[("cohesive_stress = \"1 MPa\"", "factor = 1")], place: "process_zone", says: &["`adhesion.process_zone.length`", "`adhesion.process_zone.cohesive_stress`", "exactly one"], ..NONE },
    Case { kind: "no modulus", edits: &[("relaxed_modulus = \"1 MPa\"\n", ""), ("glassy_modulus = \"100 MPa\"\n", "")], place: "[material]", says: &["`material.relaxed_modulus` is missing", "a pressure such as"], ..NONE },
    Case { kind: "plane strain without a Poisson ratio", edits: &[("poisson_ratio = 0.49\n", ""), ("\"stress\"", "\"strain\"")], place: "[material]", says: &["material.poisson_ratio", "plane strain"], ..NONE },
    // What contradicts.
    Case { kind: "speed and load", edits: &[(SPEED, "speed = \"1 mm/s\"\nenergy_release_rate = 3")], place: "energy_release_rate", says: &["`crack.speed` and `crack.energy_release_rate` exclude each other", "leave one"], ..NONE },
    Case { kind: "creep and relaxation", edits: &[("[adhesion]", "relaxation = [{ fraction = 1, relaxation_time = 1 }]\n[adhesion]")], place: "relaxation = ", says: &["`material.creep` and `material.relaxation` exclude each other"], ..NONE },
    Case { kind: "length and cohesive stress", edits: &[("cohesive_stress = \"1 MPa\"", "cohesive_stress = \"1 MPa\", length = \"1 µm\"")], place: "process_zone", says: &["`adhesion.process_zone.length` and `adhesion.process_zone.cohesive_stress` exclude each other"], ..NONE },
    Case { kind: "values and from", edits: &[("points = 3", "points = 3\nvalues = [1]")], place: "values", says: &["`sweep.values`", "exclude each other"], ..NONE },
    Case { kind: "relaxed above glassy", edits: &[("\"1 MPa\"\nglassy", "\"1 GPa\"\nglassy")], place: "\"1 GPa\"", says: &["`material.relaxed_modulus`", "is above `material.glassy_modulus`", "must be at most"], ..NONE },
    Case { kind: "both moduli with absolute terms", edits: &[("fraction = 0.4", "compliance = \"1 1/GPa\""), ("fraction = 0.6", "compliance = \"1 1/GPa\"")], place: "glassy_modulus", says: &["both moduli", "`compliance`", "leave one of the two moduli out"], ..NONE },
    Case { kind: "fractions that do not sum to one", edits: &[("0.6", "0.5")], place: "0.5", says: &["sum to 0.9", "to 1"], ..NONE },
    Case { kind: "terms given in two ways", edits: &[("fraction = 0.6", "compliance = \"1 1/GPa\"")], place: "compliance", says: &["`material.creep.1.compliance`", "the same way"], ..NONE },
    Case { kind: "a term given twice", edits: &[("fraction = 0.6", "fraction = 0.6, compliance = 1")], place: "compliance", says: &["`material.creep.1.compliance` and `material.creep.1.fraction` exclude each other"], ..NONE },
    Case { kind: "compliances above the relaxed one", edits: &[("glassy_modulus = \"100 MPa\"\n", ""), ("fraction = 0.4", "compliance = \"1 1/MPa\""), ("fraction = 0.6", "compliance = \"1 1/MPa\"")], place: "relaxed_modulus", says: &["the compliances sum to", "no positive glassy compliance"], ..NONE },
    Case { kind: "relaxation moduli above the glassy one", edits: &[("relaxed_modulus = \"1 MPa\"\n", ""), (CREEP, "relaxation = [{ modulus = \"200 MPa\", relaxation_time = 1 }]")], place: "glassy_modulus", says: &["sum to", "more than the glassy modulus"], ..NONE },
    Case { kind: "two moduli without terms", edits: &[(CREEP, "")], place: "glassy_modulus", says: &["no creep or relaxation terms", "material.creep"], ..NONE },
    Case { kind: "no terms in the series", edits: &[(CREEP, "creep = []")], place: "creep", says: &["`material.creep` is an empty list", "leave the key out"], ..NONE },
    Case { kind: "an automatic shift without data", edits: &[(CREEP, "shift = \"automatic\"\ncreep = [{ fraction = 1, retardation_time = 1 }]")], place: "shift = ", says: &["`material.shift` = \"automatic\"", "material.data", "wlf, arrhenius, factors or table"], ..NONE },
    Case { kind: "a word that is no shift", edits: &[(CREEP, "shift = \"auto\"\ncreep = [{ fraction = 1, retardation_time = 1 }]")], place: "shift = ", says: &["`material.shift` = \"auto\"", "automatic"], ..NONE },
    Case { kind: "viscosity with a relaxation series", edits: &[(CREEP, "viscosity = \"1 kPa s\"\nrelaxation = [{ fraction = 1, relaxation_time = 1 }]")], place: "viscosity", says: &["`material.viscosity`", "creep series", "leave it out"], ..NONE },
    Case { kind: "viscosity with a relaxed modulus", edits: &[("poisson_ratio = 0.49", "viscosity = \"1 kPa s\"")], place: "relaxed_modulus", says: &["`material.viscosity` makes the relaxed modulus zero"], ..NONE },
    Case { kind: "viscosity of an elastic material", edits: &[(CREEP, ""), ("relaxed_modulus = \"1 MPa\"\n", "viscosity = \"1 kPa s\"\n")], place: "viscosity", says: &["`material.viscosity`", "add material.creep"], ..NONE },
    Case { kind: "cohesive-zone theory with a length", edits: &[("[\"virtual_work\"]", "[\"cohesive_zone\"]"), ("cohesive_stress = \"1 MPa\"", "length = \"1 µm\"")], place: "theories", says: &["cohesive stress", "adhesion.process_zone.cohesive_stress"], ..NONE },
    Case { kind: "a factor of a given length", edits: &[("cohesive_stress = \"1 MPa\"", "length = \"1 µm\", factor = 1")], place: "process_zone", says: &["`adhesion.process_zone.factor`", "belongs to a cohesive stress"], ..NONE },
    Case { kind: "closing law of an opening crack", edits: &[("cohesive_stress = \"1 MPa\"", "cohesive_stress = \"1 MPa\", law = \"schapery\"")], place: "schapery", says: &["`adhesion.process_zone.law`", "\"schapery\"", "closing"], ..NONE },
    Case { kind: "fields that end before they begin", edits: &[("to = \"1 mm\"", "to = \"1 pm\"")], place: "\"1 pm\"", says: &["`fields.to`", "not above `fields.from`", "larger"], ..NONE },
    Case { kind: "two loads of a strip", edits: &[(SPEED, "[crack.strip]\nhalf_height = 1\nstrain = 0.1\nstress = 3"), ("[sweep]\n", ""), (SWEPT, "")], place: "stress = 3", says: &["`crack.strip.strain` and `crack.strip.stress` exclude each other"], ..NONE },
    Case { kind: "clamped strip without a Poisson ratio", edits: &[("poisson_ratio = 0.49\n", ""), (SPEED, "[crack.strip]\nhalf_height = 1\nstrain = 0.1"), ("[sweep]\n", ""), (SWEPT, "")], place: "[material]", says: &["`material.poisson_ratio` is missing", "poisson_ratio = 0.49", "lateral = \"uniaxial\""], ..NONE },
    Case { kind: "the whole height of a strip", edits: &[(SPEED, "[crack.strip]\nheight = 1\nstrain = 0.1"), ("[sweep]\n", ""), (SWEPT, "")], place: "height = 1", says: &["`crack.strip.height`", "did you mean `half_height`?", "half of the height"], ..NONE },
    Case { kind: "the length of a crack", edits: &[(SPEED, "speed = 1\nlength = 1")], place: "length = 1", says: &["`crack.length` is not a key", "its length does not enter"], ..NONE },
    Case { kind: "a text without a unit", edits: &[("\"1 J/m²\"", "\"80\"")], place: "work_of_adhesion", says: &["`adhesion.work_of_adhesion` = \"80\" has no unit", "must be measured in J/m²"], ..NONE },
    Case { kind: "a table given as its length", edits: &[(ZONE, "process_zone = \"1 µm\"")], place: "process_zone", says: &["must be a table", "process_zone = { length = \"1 µm\" }"], ..NONE },
    Case { kind: "a sweep over a name without its table", edits: &[("\"crack.speed\"", "\"speed\"")], place: "\"speed\"", says: &["`sweep.key` = \"speed\" is not a key", "did you mean `crack.speed`?"], ..NONE },
    // Reduced scenes.
    Case { kind: "a unit in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle =")], place: "relaxed_modulus", says: &["`material.relaxed_modulus` = \"1 MPa\"", "reduced units", "a plain number", "units = \"si\""], ..NONE },
    Case { kind: "a strip in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle ="), ("\"1 MPa\"\n", "1\n"), ("\"100 MPa\"", "100"), ("\"1 s\"", "1"), ("\"1 ms\"", "0.1"), ("\"1 J/m²\"", "1"), (ZONE, ""), (SPEED, "[crack.strip]\nhalf_height = 1\nstrain = 0.1"), ("[sweep]\n", ""), (SWEPT, ""), (FIELDS, "")], place: "[crack.strip]", says: &["strip", "units = \"si\""], ..NONE },
    Case { kind: "another relaxed modulus in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle ="), ("\"1 MPa\"\n", "2\n"), ("\"100 MPa\"", "100"), ("\"1 s\"", "1"), ("\"1 ms\"", "0.1"), ("\"1 J/m²\"", "1"), (ZONE, ""), (SPEED, "speed = 1"), ("[sweep]\n", ""), (SWEPT, ""), (FIELDS, "")], place: "relaxed_modulus", says: &["relaxed modulus is the unit", "2", "must be 1"], ..NONE },
    Case { kind: "a cohesive stress in a reduced scene", edits: &[("title =", "units = \"reduced\"\ntitle ="), ("\"1 MPa\"\n", "1\n"), ("\"100 MPa\"", "100"), ("\"1 s\"", "1"), ("\"1 ms\"", "0.1"), ("\"1 J/m²\"", "1"), ("cohesive_stress = \"1 MPa\"", "cohesive_stress = 1"), (SPEED, "speed = 1"), ("[sweep]\n", ""), (SWEPT, ""), (FIELDS, "")], place: "process_zone", says: &["cohesive stress", "fixed by the unit of length", "leave it out"], ..NONE },
    // Sweeps.
    Case { kind: "a sweep without a key", edits: &[("key = \"crack.speed\"\n", "")], place: "[sweep]", says: &["`sweep.key` is missing", "dotted path"], ..NONE },
    Case { kind: "a sweep without an end", edits: &[("to = \"1 m/s\"\n", "")], place: "[sweep]", says: &["`sweep.to` is missing"], ..NONE },
    Case { kind: "a sweep over a key that is none", edits: &[("\"crack.speed\"", "\"crack.sped\"")], place: "crack.sped", says: &["`sweep.key` = \"crack.sped\"", "is not a key", "did you mean `crack.speed`?"], ..NONE },
    Case { kind: "a sweep over a text", edits: &[("\"crack.speed\"", "\"crack.motion\"")], place: "\"crack.motion\"", says: &["`sweep.key` = \"crack.motion\"", "takes no number"], ..NONE },
    Case { kind: "a sweep over an absent table", edits: &[("\"crack.speed\"", "\"crack.strip.strain\"")], place: "crack.strip.strain", says: &["`sweep.key` = \"crack.strip.strain\"", "[crack.strip]", "does not have"], ..NONE },
    Case { kind: "a sweep past the end of a list", edits: &[("\"crack.speed\"", "\"material.creep.2.retardation_time\"")], place: "material.creep.2", says: &["`sweep.key` = \"material.creep.2.retardation_time\"", "2 items", "counted from 0"], ..NONE },
    Case { kind: "a sweep over the sweep", edits: &[("\"crack.speed\"", "\"sweep.points\"")], place: "\"sweep.points\"", says: &["`sweep.key` = \"sweep.points\"", "itself"], ..NONE },
    Case { kind: "no sweep values", edits: &[(SWEPT, "key = \"crack.speed\"\nvalues = []")], place: "values", says: &["`sweep.values` is an empty list", "at least one"], ..NONE },
    Case { kind: "a flag among sweep values", edits: &[(SWEPT, "key = \"crack.speed\"\nvalues = [1, true]")], place: "values", says: &["`sweep.values` is true or false", "numbers"], ..NONE },
    Case { kind: "a single number for sweep values", edits: &[(SWEPT, "key = \"crack.speed\"\nvalues = 1")], place: "values", says: &["`sweep.values` is a number: 1", "a list of numbers"], ..NONE },
    Case { kind: "no sweep tables", edits: &[("[sweep]\n", ""), (SWEPT, ""), ("title =", "sweep = []\ntitle =")], place: "sweep = []", says: &["`sweep` is an empty list", "leave it out"], ..NONE },
    Case { kind: "a sweep of no points", edits: &[("points = 3", "points = 0")], place: "points = 0", says: &["`sweep.points` = 0", "a whole number from 1 to"], ..NONE },
    Case { kind: "a sweep of a fractional number of points", edits: &[("points = 3", "points = 3.5")], place: "points = 3.5", says: &["`sweep.points` = 3.5", "a whole number"], ..NONE },
    Case { kind: "a sweep of too many points", edits: &[("points = 3", "points = 1e12")], place: "points = 1e12", says: &["`sweep.points` = 1e12", "to 10000000"], ..NONE },
    Case { kind: "sweeps of too many states", edits: &[("[sweep]\n", ""), (SWEPT, "[[sweep]]\nkey = \"crack.speed\"\nfrom = 1\nto = 2\npoints = 100000\n[[sweep]]\nkey = \"accuracy\"\nfrom = 1e-9\nto = 1e-2\npoints = 100000")], place: "[[sweep]]", says: &["more than", "states", "smaller"], ..NONE },
    Case { kind: "a logarithmic sweep from zero", edits: &[("from = \"1 µm/s\"", "from = 0")], place: "from = 0", says: &["logarithmic", "greater than 0", "spacing = \"linear\""], ..NONE },
    Case { kind: "a spacing of listed values", edits: &[(SWEPT, "key = \"crack.speed\"\nvalues = [1]\nspacing = \"linear\"")], place: "spacing", says: &["`sweep.spacing`", "leave it out"], ..NONE },
    Case { kind: "a swept value out of range", edits: &[(SWEPT, "key = \"material.poisson_ratio\"\nvalues = [0.3, 0.6]")], place: "values", says: &["`material.poisson_ratio` = 0.6", "at most 0.5"], ..NONE },
    Case { kind: "a swept value of another dimension", edits: &[("to = \"1 m/s\"", "to = \"1 m\"")], place: "to = \"1 m\"", says: &["`crack.speed` = \"1 m\"", "measured in m/s"], ..NONE },
    Case { kind: "a key swept twice", edits: &[("[sweep]\n", ""), (SWEPT, "[[sweep]]\nkey = \"crack.speed\"\nvalues = [1]\n[[sweep]]\nkey = 'crack.speed'\nvalues = [2]")], place: "key = 'crack.speed'", says: &["`crack.speed` is swept twice"], ..NONE },
    Case { kind: "a swept load beside a given speed", edits: &[("key = \"crack.speed\"", "key = \"crack.energy_release_rate\""), ("\"1 µm/s\"", "1"), ("\"1 m/s\"", "2")], place: "key = \"crack.energy_release_rate\"", says: &["`crack.speed` and `crack.energy_release_rate` exclude each other"], ..NONE },
    // TOML.
    Case { kind: "no TOML", edits: &[(SPEED, "speed = = 3")], place: "speed = =", says: &["not TOML"], ..NONE },
    Case { kind: "text without its end", edits: &[(SPEED, "speed = \"1 mm/s")], place: "speed = \"1 mm/s", says: &["not TOML"], ..NONE },
    Case { kind: "key twice", edits: &[(SPEED, "speed = \"1 mm/s\"\nspeed = 2")], place: "speed = 2", says: &["not TOML", "duplicate key"], ..NONE },
    Case { kind: "table twice", edits: &[("", "[crack]\n")], says: &["not TOML", "duplicate key"], ..NONE },
    // Material files.
    Case { kind: "material file that is not there", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], place: "rubber.toml", says: &["`material.file` = \"rubber.toml\"", "No such file", "start at the scene"], ..NONE },
    Case { kind: "material file without its table", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], file: Some(("rubber.toml", "poisson_ratio = 0.49")), place: "rubber.toml", says: &["\"rubber.toml\"", "no [material] table"], ..NONE },
    Case { kind: "material file with another table", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], file: Some(("rubber.toml", "[material]\npoisson_ratio = 0.49\n[crack]\nspeed = 1\n")), says: &["rubber.toml:3:", "`crack` does not belong", "[material]"], ..NONE },
    Case { kind: "key in the scene and in its material file", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], file: Some(("rubber.toml", "[material]\nglassy_modulus = 1\n")), place: "glassy_modulus", says: &["`material.glassy_modulus`", "\"rubber.toml\"", "leave one"], ..NONE },
    Case { kind: "material file in a material file", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], file: Some(("rubber.toml", "[material]\nfile = \"wood.toml\"\n")), says: &["rubber.toml:2:", "cannot name another file"], ..NONE },
    Case { kind: "unknown key in a material file", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], file: Some(("rubber.toml", "[material]\npoisson = 0.3\n")), says: &["rubber.toml:2:", "`material.poisson`", "did you mean `poisson_ratio`?"], ..NONE },
    Case { kind: "material file that is no TOML", edits: &[("poisson_ratio = 0.49", "file = \"rubber.toml\"")], file: Some(("rubber.toml", "[material")), says: &["rubber.toml:1:", "not TOML"], ..NONE },
    Case { kind: "number for a material file", edits: &[("poisson_ratio = 0.49", "file = 3")], place: "file = 3", says: &["`material.file` is a number: 3", "a text in quotes"], ..NONE },
    // Values from the command line.
    Case { kind: "--set without =", arguments: &["--set", "crack.speed"], says: &["`--set crack.speed`", "no `=`", "--set table.key=value"], ..NONE },
    Case { kind: "--set without a value", arguments: &["--set", "crack.speed="], place: "--set crack.speed", says: &["crack.speed", "value"], ..NONE },
    Case { kind: "--set without a key", arguments: &["--set", "=3"], says: &["`--set =3`", "no key", "--set table.key=value"], ..NONE },
    Case { kind: "--set with an empty part", arguments: &["--set", "crack..speed=3"], place: "--set crack..speed", says: &["`crack..speed` is not a key"], ..NONE },
    Case { kind: "--set of an unknown key", arguments: &["--set", "crack.sped=3"], place: "--set crack.sped", says: &["`crack.sped`", "did you mean `speed`?"], ..NONE },
    Case { kind: "--set of an unknown table", arguments: &["--set", "crak.speed=3"], place: "--set crak.speed", says: &["`crak`", "did you mean `crack`?"], ..NONE },
    Case { kind: "--set through a number", arguments: &["--set", "material.poisson_ratio.x=3"], place: "--set material.poisson_ratio.x", says: &["`material.poisson_ratio.x` does not exist", "below a number"], ..NONE },
    Case { kind: "--set past the end of a list", arguments: &["--set", "material.creep.2.fraction=0.5"], place: "--set material.creep.2.fraction", says: &["`material.creep.2.fraction`", "2 items", "counted from 0"], ..NONE },
    Case { kind: "--set of a wrong unit", arguments: &["--set", "crack.speed=3 kg"], place: "--set crack.speed", says: &["`crack.speed` = \"3 kg\"", "measured in m/s"], ..NONE },
    Case { kind: "--set out of range", arguments: &["--set", "crack.speed=-3"], place: "--set crack.speed", says: &["`crack.speed` = -3", "0 or more"], ..NONE },
    Case { kind: "--set of a second control", arguments: &["--set", "crack.energy_release_rate=3"], place: "--set crack.energy_release_rate", says: &["exclude each other"], ..NONE },
];

/// Mistakes about a crack that only a sliding contact knows.
#[rustfmt::skip]
const CRACK_CASES: &[Case] = &[
    Case { kind: "zones of a sliding contact", edits: &[("cohesive_stress = \"1 MPa\"", "trailing_length = 1e-6, leading_length = 1e-6")], place: "process_zone", says: &["`adhesion.process_zone.trailing_length` belongs to a sliding contact"], ..NONE },
];

/// A good scene with the edits of a case.
fn spoilt(good: &str, case: &Case) -> String {
    let mut text = good.to_owned();
    for (from, to) in case.edits {
        if from.is_empty() {
            text.push_str(to);
            continue;
        }
        assert_eq!(text.matches(from).count(), 1, "{}: {from:?} does not stand in the scene exactly once", case.kind);
        text = text.replacen(from, to, 1);
    }
    text
}

/// What is wrong with an answer to a wrong call; nothing if it is as it should be.
fn failures(answer: &Answer, says: &[&str]) -> Vec<String> {
    let mut failures = Vec::new();
    if answer.code != 2 {
        failures.push(format!("exit code {}", answer.code));
    }
    if !answer.stdout.is_empty() {
        failures.push(format!("standard output is not empty: {}", answer.stdout));
    }
    let errors = answer.stderr.matches('×').count() + answer.stderr.matches("error:").count();
    if errors != 1 {
        failures.push(format!("{errors} errors"));
    }
    failures.extend(says.iter().filter(|word| !answer.stderr.contains(**word)).map(|word| format!("does not say {word:?}")));
    failures
}

#[test]
fn every_kind_of_wrong_scene_is_one_error_with_its_place() {
    assert!(CASES.len() >= 40);
    let mut report = String::new();
    let of_cracks = CASES.iter().chain(CRACK_CASES).map(|case| (GOOD, case));
    let of_histories = DELAYED_CASES.iter().map(|case| (DELAYED, case));
    let of_spheres = INDENTATION_CASES.iter().map(|case| (INDENTATION, case));
    for (good, case) in of_cracks.chain(SLIDING_CASES.iter().map(|case| (SLIDING, case))).chain(of_histories).chain(of_spheres) {
        let text = spoilt(good, case);
        let folder = Folder::with(&text);
        if let Some((name, content)) = case.file {
            folder.write(name, content);
        }
        let mut arguments = vec!["run", "scene.toml", "--out", "DIR"];
        arguments.extend(case.arguments);
        let answer = folder.call(&arguments);
        let place = match case.place {
            "" => String::new(),
            set if set.starts_with("--set") => format!("[{set}:1:"),
            marker => {
                let line = text.lines().position(|line| line.contains(marker)).unwrap_or_else(|| panic!("{}: no {marker:?}", case.kind));
                format!("[scene.toml:{}:", line + 1)
            }
        };
        let mut says = case.says.to_vec();
        says.push(&place);
        let mut wrong = failures(&answer, &says);
        for name in ["DIR", "DIR.partial"] {
            if folder.path(name).exists() {
                wrong.push(format!("{name} was made"));
            }
        }
        // `explain` reads the same scene by the same way.
        let mut arguments = vec!["explain", "scene.toml"];
        arguments.extend(case.arguments);
        let explained = folder.call(&arguments);
        if (explained.code, &explained.stderr) != (2, &answer.stderr) {
            wrong.push(format!("explain says otherwise: {}", explained.stderr));
        }
        if !wrong.is_empty() {
            report.push_str(&format!("── {}\n{}\n{}\n", case.kind, wrong.join("\n"), answer.stderr));
        } else if std::env::var_os("SHOW_ERRORS").is_some() {
            println!("── {}\n{}", case.kind, answer.stderr);
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

#[test]
fn the_scene_that_is_spoilt_above_is_right() {
    for good in [GOOD, SLIDING] {
        let folder = Folder::with(good);
        folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
        assert!(folder.path("DIR/states.csv").is_file());
        assert!(!folder.path("DIR.partial").exists());
    }
}

/// Asserts one error that says all of these.
fn refused(answer: &Answer, says: &[&str]) {
    let wrong = failures(answer, says);
    assert!(wrong.is_empty(), "{}\n{}", wrong.join("\n"), answer.stderr);
}

#[test]
fn scene_files_that_cannot_be_read_are_named() {
    let folder = Folder::with(GOOD);
    refused(&folder.call(&["run", "none.toml"]), &["`none.toml`", "cannot be read", "No such file"]);
    refused(&folder.call(&["run", "."]), &["`.`", "cannot be read"]);
    folder.write("latin.toml", b"title = \"caf\xe9\"\n");
    refused(&folder.call(&["run", "latin.toml"]), &["`latin.toml`", "UTF-8", "line 1"]);
    folder.write("bytes.toml", b"\x00\x01\x02\xff");
    refused(&folder.call(&["explain", "bytes.toml"]), &["`bytes.toml`", "UTF-8"]);
    folder.write("empty.toml", b"");
    refused(&folder.call(&["run", "empty.toml"]), &["empty.toml:1:1", "missing"]);
    folder.write("mark.toml", [b"\xef\xbb\xbf".as_slice(), GOOD.as_bytes()].concat());
    folder.call(&["explain", "mark.toml"]).ended(0);
    folder.write("dos.toml", GOOD.replace('\n', "\r\n"));
    folder.call(&["explain", "dos.toml"]).ended(0);
}

#[test]
fn calls_that_contradict_themselves_are_refused() {
    let folder = Folder::with(GOOD);
    refused(&folder.call(&["run", "scene.toml", "--force"]), &["--out <DIR>", "--force"]);
    refused(&folder.call(&["run"]), &["<SCENE>"]);
    refused(&folder.call(&["run", "scene.toml", "--jsn"]), &["--jsn", "--json"]);
    refused(&folder.call(&["runn", "scene.toml"]), &["runn", "similar", "'run'"]);
    refused(&folder.call(&["new", "crak"]), &["`crak`", "Did you mean crack?", "strip"]);
    refused(&folder.call(&["completions", "tcsh"]), &["tcsh", "bash", "zsh", "fish"]);
    refused(&folder.call(&["cite", "none.toml"]), &["`none.toml`", "cannot be read"]);
    refused(&folder.call(&["new", "crack", "--out", "scene.toml"]), &["`scene.toml`", "exists"]);
    assert_eq!(folder.read("scene.toml"), GOOD, "an existing file was overwritten");
}

#[test]
fn an_existing_folder_is_kept_without_force() {
    let folder = Folder::with(GOOD);
    folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let before = folder.files("DIR");
    refused(&folder.call(&["run", "scene.toml", "--out", "DIR", "--set", "title=other"]), &["`DIR`", "exists already", "--force"]);
    refused(&folder.call(&["run", "scene.toml", "--out", "DIR/", "--set", "title=other"]), &["`DIR/`", "exists already", "--force"]);
    assert_eq!(folder.files("DIR"), before);
    folder.call(&["run", "scene.toml", "--out", "DIR", "--set", "title=other", "--force"]).ended(0);
    assert!(folder.read("DIR/summary.json").contains("\"title\": \"other\""));
}

#[test]
fn force_replaces_only_what_a_run_has_written() {
    let folder = Folder::with(GOOD);
    std::fs::create_dir(folder.path("thesis")).unwrap();
    folder.write("thesis/chapter.tex", "years of work");
    folder.write("notes.txt", "more work");
    for target in ["thesis", "notes.txt", "."] {
        refused(&folder.call(&["run", "scene.toml", "--out", target, "--force"]), &[&format!("`{target}`"), "not replaced"]);
    }
    assert_eq!(folder.read("thesis/chapter.tex"), "years of work");
    assert_eq!(folder.read("notes.txt"), "more work");
    std::fs::create_dir(folder.path("empty")).unwrap();
    folder.call(&["run", "scene.toml", "--out", "empty", "--force"]).ended(0);
    // A folder below a file cannot be made: the machine refuses.
    let answer = folder.call(&["run", "scene.toml", "--out", "notes.txt/deep"]).ended(5);
    assert!(answer.stderr.contains("notes.txt/deep") && answer.stderr.contains("cannot be written"), "{}", answer.stderr);
}

#[test]
fn a_folder_may_be_named_as_shells_complete_it() {
    let folder = Folder::with(GOOD);
    folder.call(&["run", "scene.toml", "--out", "DIR/"]).ended(0);
    assert!(folder.path("DIR/states.csv").is_file());
    folder.call(&["run", "scene.toml", "--out", "a/b/c"]).ended(0);
    assert!(folder.path("a/b/c/states.csv").is_file());
    let left: Vec<_> = std::fs::read_dir(folder.path(".")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left.len(), 3, "{left:?}");
}
