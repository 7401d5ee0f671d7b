//! Mistakes about a crack under a load history.

use super::{Case, NONE};

const STEP: &str = "stress_intensity = \"3 kPa √m\"\n";
const HOLD: &str = "hold = \"2 s\"";

/// Mistakes about a crack under a load history.
#[rustfmt::skip]
pub const DELAYED_CASES: &[Case] = &[
    Case { kind: "misspelt key of a segment", edits: &[("stress_intensity =", "stress_intensty =")], place: "stress_intensty", says: &["`history.0.stress_intensty`", "did you mean `stress_intensity`?"], ..NONE },
    Case { kind: "a speed beside a history", edits: &[("points = 5", "points = 5\nspeed = 1")], place: "speed = 1", says: &["`crack.speed` belongs to a steady crack", "[[history]]"], ..NONE },
    Case { kind: "a closing crack under a history", edits: &[("points = 5", "points = 5\nmotion = \"closing\"")], place: "closing", says: &["`crack.motion` = \"closing\"", "never heals"], ..NONE },
    Case { kind: "Schapery's zone under a history", edits: &[("cohesive_stress = \"1 MPa\"", "cohesive_stress = \"1 MPa\", law = \"schapery\"")], place: "process_zone", says: &["`adhesion.process_zone.law` = \"schapery\"", "\"growing\" or \"constant\""], ..NONE },
    Case { kind: "fields under a history", edits: &[("[[history]]\nhold", "[fields]\nfrom = 1\nto = 2\n[[history]]\nhold")], place: "[fields]", says: &["`fields` belongs to a steady crack"], ..NONE },
    Case { kind: "a depth of a crack", edits: &[(STEP, "penetration = 1\n")], place: "penetration", says: &["`history.0.penetration` is not controlled in a crack", "`stress_intensity`"], ..NONE },
    Case { kind: "an oscillation of a crack", edits: &[(HOLD, "oscillation = { quantity = \"force\", amplitude = 1, frequency = 1, cycles = 3 }")], place: "oscillation", says: &["`history.1.oscillation`: nothing oscillates in a crack", "`cycles` with period"], ..NONE },
    Case { kind: "a stress without a strip", edits: &[(STEP, "stress = 1\n")], place: "stress = 1", says: &["`history.0.stress` is not controlled in a crack", "[crack.strip]"], ..NONE },
    Case { kind: "a stress intensity with a strip", edits: &[("[[history]]\nstress", "[crack.strip]\nhalf_height = 1\nlateral = \"uniaxial\"\n[[history]]\nstress")], place: "stress_intensity", says: &["`history.0.stress_intensity` is not controlled in a crack in a strip", "`stress`"], ..NONE },
    Case { kind: "a strain of a strip under a history", edits: &[("[[history]]\nstress", "[crack.strip]\nhalf_height = 1\nstrain = 0.1\n[[history]]\nstress")], place: "strain = 0.1", says: &["`crack.strip.strain` belongs to a steady crack", "controls the stress"], ..NONE },
    Case { kind: "a pressed crack", edits: &[(STEP, "stress_intensity = -1\n")], place: "stress_intensity", says: &["`history.0.stress_intensity` = -1", "0 or more"], ..NONE },
    Case { kind: "a history without time", edits: &[(HOLD, "hold = 0")], place: "[[history]]", says: &["takes no time", "add a hold", "points = 0"], ..NONE },
    Case { kind: "first time without logarithmic times", edits: &[("points = 5", "points = 5\nfirst_time = 1")], place: "first_time", says: &["`crack.first_time`", "spacing = \"logarithmic\""], ..NONE },
    Case { kind: "first time after the end", edits: &[("points = 5", "points = 5\nspacing = \"logarithmic\"\nfirst_time = 3")], place: "first_time", says: &["`crack.first_time` (3e0 s)", "end of the history (2e0 s)"], ..NONE },
    Case { kind: "a table that is not there", edits: &[(HOLD, "table = \"nowhere.csv\"")], place: "nowhere", says: &["`history.table` = \"nowhere.csv\"", "cannot be read"], ..NONE },
    Case { kind: "a table with a falling time", edits: &[(HOLD, "table = \"load.csv\"")], file: Some(("load.csv", "time (s), stress_intensity (kPa √m)\n0, 1\n2, 2\n1, 3\n")), place: "", says: &["`time` = 1 does not increase", "[load.csv:4:"], ..NONE },
    Case { kind: "output times of a steady crack", edits: &[("[[history]]\nstress_intensity = \"3 kPa √m\"\n", ""), ("[[history]]\nhold = \"2 s\"\n", "")], place: "points = 5", says: &["`crack.points` belongs to a crack under a [[history]]"], ..NONE },
    Case { kind: "swept segment that is not there", edits: &[("", "[sweep]\nkey = \"history.7.hold\"\nvalues = [1]\n")], place: "history.7", says: &["`sweep.key` = \"history.7.hold\" does not exist", "2 items"], ..NONE },
    Case { kind: "a swept segment in brackets", edits: &[("", "[sweep]\nkey = \"history[0].stress_intensity\"\nvalues = [1]\n")], place: "history[0].stress_intensity", says: &["did you mean `history.0.stress_intensity`?", "count from 0"], ..NONE },
    Case { kind: "a swept segment without a number", edits: &[("", "[sweep]\nkey = \"history.stress_intensity\"\nvalues = [1]\n")], place: "history.stress_intensity", says: &["did you mean `history.0.stress_intensity`?", "count from 0"], ..NONE },
    Case { kind: "a swept segment in empty brackets", edits: &[("", "[sweep]\nkey = \"history[].stress_intensity\"\nvalues = [1]\n")], place: "history[].stress_intensity", says: &["did you mean `history.0.stress_intensity`?", "count from 0"], ..NONE },
    Case { kind: "a swept key that excludes another", edits: &[("", "[sweep]\nkey = \"history.1.stress_intensity\"\nvalues = [1]\n")], place: "key = \"history.1", says: &["`history.1.stress_intensity` and `history.1.hold` exclude each other", "put there by `sweep.key`"], ..NONE },
    Case { kind: "a force on a strip", edits: &[(STEP, "force = \"50 N\"\n"), ("points = 5", "points = 5\nstrip = { half_height = 1, lateral = \"uniaxial\" }")], place: "force = ", says: &["`history.0.force` is not controlled in a crack in a strip", "`stress`", "width times thickness"], ..NONE },
];
