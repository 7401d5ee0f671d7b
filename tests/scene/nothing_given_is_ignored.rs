//! Source: the key catalogue (`src/scene/catalogue`); style.md: "nothing asked for is silently ignored".
//!
//! Goal: every key of every problem, and of every variant of its shape, control and start, changes the result when it is changed or added, or is refused, or
//! stands in [`NO_EFFECT`] with the reason. A new key fails until a scene below holds it.
//!
//! Parameters: the scenes of [`SCENES`], small ones that together hold every key.
//!
//! Oracle: none is needed; the result is the rows (values, bounds, status, fields), the columns, the validity block and the title. What a plan says of a
//! scene (effects, groups, predicted work) and its hash do not count: a key that only changes those is ignored.
//!
//! Tolerance: none, bytes.
#![allow(clippy::type_complexity, clippy::unwrap_used, clippy::panic, clippy::expect_used, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::shipped_scenes;
use rayon::prelude::*;
use std::collections::BTreeSet;
use viscotack::Estimate;
use viscotack::outcome::csv_table::{self, Table};
use viscotack::outcome::summary::summary;
use viscotack::outcome::{FieldPoint, Row};
use viscotack::plan;
use viscotack::scene::catalogue::{Key, Kind, generic_path, keys};
use viscotack::scene::document::{Document, Node, Value};
use viscotack::scene::read;

/// Keys that change nothing where they are allowed: key, scenes ("" all), reason.
const NO_EFFECT: &[(&str, &str, &str)] = &[
    ("material.name", "", "names the material in the tables and plots of `viscotack material` only"),
    ("material.leave_out", "", "only 0 is allowed: all terms are always kept"),
    ("history[].noise", "crack by a table", "a straight record has no noise, and no corner to lose that a crack would show"),
    ("history[].columns.growth", "", "what was measured of a crack is drawn beside its growth"),
    ("indentation.scan.largest_residual", "", "a scan is refused beyond it, and the same within; tests/bad_input has one beyond"),
    ("crack.speed", "swept", "the sweep puts its own values in its place"),
    ("indentation.instants", "by a table", "of tables each corner is one instant"),
    ("indentation.instants", "in cycles", "of cycles each corner is one instant"),
    ("indentation.instants", "by named columns", "of tables each corner is one instant"),
    ("indentation.instants", "by a named", "of tables each corner is one instant"),
    (
        "indentation.rim_radius",
        "sphere by a named radius",
        "an edge that is imposed stays inside of the rims that are tried, or is refused",
    ),
    ("indentation.instants", "that swings", "an oscillation has instants only if twelve and more are asked for"),
    ("indentation.instants", "that settles", "an oscillation has instants only if twelve and more are asked for"),
    ("history[].oscillation.cycles", "that settles", "with `until_stationary` their largest number, which is not reached"),
    (
        "material.temperature_tolerance",
        "data",
        "temperatures of an isotherm are equal there; tests/material/tables.rs has some that wander",
    ),
    ("material.deck_material", "deck of ANSYS", "the number of the only material is compared with the deck's, and changes nothing"),
    ("material.deck_material", "deck of LS-DYNA", "the number of the only material is compared with the deck's, and changes nothing"),
    ("material.columns.of", "data", "tension is the default; tests/material/tables.rs has shear"),
    ("sliding.most_nodes", "", "nodes that the accuracy does not need are not taken; the profile of a file needs more"),
    ("sliding.reached_by", "", "one contact is stable there: which one of several is meant matters to few states"),
    ("sliding.branch.parameter", "branch of all loads", "every contact of a speed is one curve, whatever it is followed by"),
    ("sliding.branch.branches", "branch of", "no branch lies apart there; tests/sliding/sec_3_4_every_branch.rs has some that do"),
];

/// Texts and lists that no generic change makes a valid one of: key, values to try.
const SAMPLES: &[(&str, &[&str])] = &[
    ("material.file", &["\"other.toml\""]),
    ("material.fit_error", &["0.3", "1e-3", "1e-6"]),
    ("material.data", &["\"creep.csv\"", "\"moduli.csv\""]),
    ("material.shift.table", &["\"other_shift.csv\"", "\"shift.csv\""]),
    ("material.columns.frequency", &["\"b in Hz\""]),
    ("material.columns.angular_frequency", &["\"b in rad/s\"", "\"a in rad/ms\""]),
    ("material.columns.time", &["\"a in ms\"", "\"b in s\""]),
    ("material.columns.temperature", &["\"e in K\"", "\"f in K\""]),
    ("material.columns.storage_modulus", &["\"c in kPa\"", "\"d in Pa\""]),
    ("material.columns.loss_modulus", &["\"d in kPa\"", "\"c in Pa\""]),
    ("material.columns.loss_tangent", &["\"c in 1\"", "\"d in 1\""]),
    ("material.columns.complex_modulus", &["\"c in kPa\"", "\"b in Pa\""]),
    ("material.columns.phase_angle", &["\"d in deg\"", "\"d in rad\""]),
    ("material.columns.relaxation_modulus", &["\"c in kPa\"", "\"d in Pa\""]),
    ("material.columns.creep_compliance", &["\"c in 1/kPa\"", "\"d in 1/Pa\""]),
    ("material.abaqus", &["\"other.inp\""]),
    ("material.ansys", &["\"other.dat\""]),
    ("material.ls_dyna", &["\"other.k\""]),
    ("material.comsol", &["\"other.txt\""]),
    ("material.moose", &["\"other.i\""]),
    ("material.deck_material", &["\"one\"", "\"1\""]),
    ("material.deck_units.pressure", &["\"kPa\""]),
    ("material.deck_units.time", &["\"ms\""]),
    ("material.deck_units.temperature", &["\"K\""]),
    ("adhesion.table", &["\"other_law.csv\"", "\"other_wave_law.csv\""]),
    ("adhesion.columns.gap", &["\"u in km\"", "\"u in nm\"", "\"v in m\"", "\"b in mm\"", "\"d in m\""]),
    ("adhesion.columns.stress", &["\"v in Pa\"", "\"c in kPa\"", "\"d in Pa\""]),
    ("adhesion.by_speed.file", &["\"other_works.csv\""]),
    ("indentation.profile", &["\"other_shape.csv\""]),
    ("indentation.scan.columns.r", &["\"v in m\""]),
    ("indentation.scan.columns.x", &["\"v in m\"", "\"u in mm\""]),
    ("indentation.scan.columns.y", &["\"u in m\"", "\"v in mm\""]),
    ("indentation.scan.columns.z", &["\"w in mm\""]),
    ("history[].columns.time", &["\"a in ms\""]),
    ("history[].columns.penetration", &["\"d in m\""]),
    ("history[].columns.force", &["\"d in N\""]),
    ("history[].columns.contact_radius", &["\"d in m\""]),
    ("history[].columns.frame", &["\"d in m\""]),
    ("history[].columns.stress_intensity", &["\"f in Pa √m\""]),
    ("history[].columns.stress", &["\"f in Pa\""]),
    ("history[].table", &["\"other_history.csv\"", "\"other_load.csv\""]),
    ("sliding.profile.file", &["\"other_profile.csv\""]),
    ("sliding.profile.columns.x", &["\"b in m\"", "\"a in mm\""]),
    ("sliding.profile.columns.h", &["\"d in m\""]),
    ("sliding.surface.file", &["\"other_heights.txt\"", "\"other_points.csv\""]),
    ("sliding.surface.columns.x", &["\"a in mm\""]),
    ("sliding.surface.columns.y", &["\"b in mm\""]),
    ("sliding.surface.columns.z", &["\"d in m\""]),
    ("sweep.key", &["\"adhesion.work_of_adhesion\"", "\"material.poisson_ratio\"", "\"crack.speed\""]),
];

/// Files that the scenes name.
const FILES: &[(&str, &str)] = &[
    (
        "steel.toml",
        "[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\ncreep = [{ fraction = 1.0, retardation_time = 1.0 }]\n",
    ),
    (
        "other.toml",
        "[material]\nrelaxed_modulus = 2e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\ncreep = [{ fraction = 1.0, retardation_time = 1.0 }]\n",
    ),
    (
        "moduli.csv",
        "a, b, c, d\n0.01, 0.02, 1.0e6, 1.0e5\n0.1, 0.2, 1.3e6, 5e5\n1, 2, 3.2e6, 1.9e6\n10, 20, 8e6, 2e6\n100, 200, 9.8e6, 5e5\n",
    ),
    (
        "tangent.csv",
        "a, b, c, d\n0.01, 0.02, 1.0e6, 0.1\n0.1, 0.2, 1.3e6, 0.4\n1, 2, 3.2e6, 0.6\n10, 20, 8e6, 0.25\n100, 200, 9.8e6, 0.05\n",
    ),
    (
        "warm.csv",
        "a, b, c, d, e, f\n0.1, 0.2, 1.3e6, 5e5, 293.15, 303.15\n1, 2, 3.2e6, 1.9e6, 293.15, 303.15\n10, 20, 8e6, 2e6, 293.15, 303.15\n0.1, 0.2, 1.1e6, 2e5, 303.15, 313.15\n1, 2, 1.6e6, 9e5, 303.15, 313.15\n10, 20, 4e6, 2e6, 303.15, 313.15\n",
    ),
    (
        "isotherms.csv",
        "a, b, c, d, e\n0.01, 0.01, 1.092e+06, 3.562e+05, 293.15\n0.03, 0.03, 1.488e+06, 7.086e+05, 293.15\n0.1, 0.1, 2.089e+06, 9.363e+05, 293.15\n0.3, 0.3, 2.942e+06, 1.329e+06, 293.15\n1, 1, 3.952e+06, 1.338e+06, 293.15\n3, 3, 4.947e+06, 1.934e+06, 293.15\n10, 10, 7.119e+06, 1.723e+06, 293.15\n0.01, 0.01, 1.062e+06, 6.103e+04, 303.15\n0.03, 0.03, 1.081e+06, 1.805e+05, 303.15\n0.1, 0.1, 1.257e+06, 5.204e+05, 303.15\n0.3, 0.3, 1.808e+06, 8.295e+05, 303.15\n1, 1, 2.463e+06, 1.153e+06, 303.15\n3, 3, 3.558e+06, 1.431e+06, 303.15\n10, 10, 4.462e+06, 1.563e+06, 303.15\n",
    ),
    (
        "relaxation.csv",
        "a, b, c, d\n0.001, 0.002, 9.9e6, 9.8e6\n0.01, 0.02, 9e6, 8.8e6\n0.1, 0.2, 4.3e6, 4e6\n1, 2, 1.05e6, 1.03e6\n10, 20, 1e6, 1e6\n",
    ),
    (
        "creep.csv",
        "a, b, c, d\n0.001, 0.002, 1.01e-7, 1.02e-7\n0.01, 0.02, 1.1e-7, 1.2e-7\n0.1, 0.2, 2e-7, 2.2e-7\n1, 2, 6.7e-7, 6.9e-7\n10, 20, 1e-6, 1e-6\n",
    ),
    ("shift.csv", "temperature (°C), factor\n20, 1\n30, 0.1\n40, 0.02\n"),
    ("other_shift.csv", "temperature (°C), factor\n20, 1\n30, 0.2\n40, 0.03\n"),
    (
        "law.csv",
        "u, w, v\n8.5000e-08, 3.585521e+06, 4.302625e+06\n9.0000e-08, 1.612577e+06, 1.935092e+06\n9.5000e-08, 5.604302e+05, 6.725163e+05\n1.0000e-07, 0.000000e+00, 0.000000e+00\n1.0500e-07, -2.923049e+05, -3.507659e+05\n1.1000e-07, -4.362896e+05, -5.235475e+05\n1.2000e-07, -5.131960e+05, -6.158352e+05\n1.3500e-07, -4.523998e+05, -5.428797e+05\n1.6000e-07, -3.061183e+05, -3.673419e+05\n2.0000e-07, -1.640625e+05, -1.968750e+05\n2.5000e-07, -8.498381e+04, -1.019806e+05\n3.2000e-07, -4.065221e+04, -4.878265e+04\n4.0000e-07, -2.082825e+04, -2.499390e+04\n5.0000e-07, -1.066598e+04, -1.279918e+04\n7.0000e-07, -3.887236e+03, -4.664683e+03\n",
    ),
    (
        "other_law.csv",
        "u, w, v\n8.5000e-08, 5.019729e+06, 4.302625e+06\n9.0000e-08, 2.257608e+06, 1.935092e+06\n9.5000e-08, 7.846023e+05, 6.725163e+05\n1.0000e-07, 0.000000e+00, 0.000000e+00\n1.0500e-07, -4.092269e+05, -3.507659e+05\n1.1000e-07, -6.108054e+05, -5.235475e+05\n1.2000e-07, -7.184744e+05, -6.158352e+05\n1.3500e-07, -6.333597e+05, -5.428797e+05\n1.6000e-07, -4.285656e+05, -3.673419e+05\n2.0000e-07, -2.296875e+05, -1.968750e+05\n2.5000e-07, -1.189773e+05, -1.019806e+05\n3.2000e-07, -5.691309e+04, -4.878265e+04\n4.0000e-07, -2.915955e+04, -2.499390e+04\n5.0000e-07, -1.493238e+04, -1.279918e+04\n7.0000e-07, -5.442131e+03, -4.664683e+03\n",
    ),
    ("works.csv", "speed, work_of_adhesion\n1e-9, 0.02\n1e-3, 0.03\n1e3, 0.05\n"),
    ("other_works.csv", "speed, work_of_adhesion\n1e-9, 0.02\n1e-3, 0.04\n1e3, 0.05\n"),
    ("shape.csv", "r (m), z (m)\n0, 0\n1e-4, 5e-6\n2e-4, 2e-5\n3e-4, 4.5e-5\n4e-4, 8e-5\n"),
    ("other_shape.csv", "r (m), z (m)\n0, 0\n1e-4, 6e-6\n2e-4, 2.4e-5\n3e-4, 5.4e-5\n4e-4, 9.6e-5\n"),
    (
        "card.inp",
        "*MATERIAL, NAME=ONE\n*ELASTIC, MODULI=INSTANTANEOUS\n 10., 0.4\n*VISCOELASTIC, TIME=PRONY\n 0.5, 0., 0.1\n*MATERIAL, NAME=TWO\n*ELASTIC, MODULI=INSTANTANEOUS\n 11., 0.4\n*VISCOELASTIC, TIME=PRONY\n 0.5, 0.1, 0.1\n*TRS\n 20., 8., 100.\n",
    ),
    ("other.inp", "*MATERIAL, NAME=ONE\n*ELASTIC\n 10., 0.4\n"),
    ("card.dat", "MP,EX,1,10\nMP,NUXY,1,0.4\nTB,PRONY,1,,1,SHEAR\nTBDATA,1,0.5,0.1\n"),
    ("other.dat", "MP,EX,1,10\nMP,NUXY,1,0.45\n"),
    ("card.k", "*MAT_006\n1,1e-9,50.,4.,1.,10.\n"),
    ("other.k", "*MAT_006\n1,1e-9,50.,5.,1.,10.\n"),
    ("card.txt", "G 2[MPa]\nK 40\nG1 1\ntau1 0.1\n"),
    ("other.txt", "G 2[MPa]\nK 50\nG1 1\ntau1 0.1\n"),
    (
        "card.i",
        "[m]\ntype = GeneralizedMaxwellModel\nyoung_modulus = 10\npoisson_ratio = 0.4\ncreep_modulus = 5\ncreep_viscosity = 0.1\n[]\n",
    ),
    (
        "other.i",
        "[m]\ntype = GeneralizedMaxwellModel\nyoung_modulus = 10\npoisson_ratio = 0.4\ncreep_modulus = 6\ncreep_viscosity = 0.1\n[]\n",
    ),
    ("history.csv", "time (s), penetration (m)\n0, 0\n1, 1e-6\n2, 2e-6\n"),
    ("other_history.csv", "time (s), penetration (m)\n0, 0\n1, 1.5e-6\n2, 2e-6\n"),
    (
        "named.csv",
        "a, b, c, d, e, f\n0, 0, 0, 0, 0, 0\n1, 1e-6, 1e-4, 2e-6, 1e3, 1.1e3\n2, 1.8e-6, 2e-4, 3e-6, 2e3, 2.2e3\n3, 3.1e-6, 4e-4, 4e-6, 3e3, 3.3e3\n4, 3.8e-6, 5e-4, 5e-6, 5e3, 5.5e3\n5, 5.2e-6, 6e-4, 6e-6, 6e3, 6.6e3\n",
    ),
    ("scan.csv", SCAN),
    ("face.csv", "u, v, w\n0, 0, 0\n1e-4, 1.1e-4, 5e-6\n2e-4, 2.1e-4, 2e-5\n3e-4, 3.1e-4, 4.5e-5\n4e-4, 4.1e-4, 8e-5\n"),
    ("map.csv", MAP),
    ("wave_law.csv", "b, c, d\n0, 5e4, 4e4\n1e-7, 4e4, 3e4\n3e-7, 2e4, 1e4\n6e-7, 5e3, 3e3\n1e-6, 0, 0\n"),
    ("other_wave_law.csv", "b, c, d\n0, 6e4, 4e4\n1e-7, 4e4, 3e4\n3e-7, 2e4, 1e4\n6e-7, 5e3, 3e3\n1e-6, 0, 0\n"),
    ("profile.csv", PROFILE),
    ("other_profile.csv", OTHER_PROFILE),
    ("heights.txt", "# rows\n0 1 2 4 3 1\n1 2 5 6 4 2\n0 3 6 8 5 1\n1 2 4 5 3 0\n0 1 2 2 1 0\n"),
    ("other_heights.txt", "0 1 2 5 3 1\n1 2 5 6 4 2\n0 3 6 8 5 1\n1 2 4 5 3 0\n0 1 2 2 1 0\n"),
    ("points.csv", POINTS),
    ("other_points.csv", OTHER_POINTS),
    ("load.csv", "time (s), stress_intensity (Pa √m)\n0, 0\n1, 1000\n2, 2000\n"),
    ("other_load.csv", "time (s), stress_intensity (Pa √m)\n0, 0\n1, 1100\n2, 2000\n"),
];

const SCAN: &str = "u, v, w\n-0.0005, -0.0004, 0.000126\n-0.00045, -0.00035, 0.00010225\n-0.0004, -0.0003, 8.1e-05\n-0.00035, -0.00025, 6.225e-05\n-0.0003, -0.0002, 4.6e-05\n-0.00025, -0.00015, 3.225e-05\n-0.0002, -0.0001, 2.1e-05\n-0.00015, -5e-05, 1.225e-05\n-0.0001, 0, 6e-06\n-5e-05, 5e-05, 2.25e-06\n0, 0.0001, 1e-06\n5e-05, 0.00015, 2.25e-06\n0.0001, 0.0002, 6e-06\n0.00015, 0.00025, 1.225e-05\n0.0002, 0.0003, 2.1e-05\n0.00025, 0.00035, 3.225e-05\n0.0003, 0.0004, 4.6e-05\n0.00035, 0.00045, 6.225e-05\n0.0004, 0.0005, 8.1e-05\n0.00045, 0.00055, 0.00010225\n0.0005, 0.0006, 0.000126\n";
const MAP: &str = "u, v, w\n-0.0003, -0.00033, 9.945000e-05\n-0.0003, -0.00022, 6.920000e-05\n-0.0003, -0.00011, 5.105000e-05\n-0.0003, 0, 4.500000e-05\n-0.0003, 0.00011, 5.105000e-05\n-0.0003, 0.00022, 6.920000e-05\n-0.0003, 0.00033, 9.945000e-05\n-0.0002, -0.00033, 7.445000e-05\n-0.0002, -0.00022, 4.420000e-05\n-0.0002, -0.00011, 2.605000e-05\n-0.0002, 0, 2.000000e-05\n-0.0002, 0.00011, 2.605000e-05\n-0.0002, 0.00022, 4.420000e-05\n-0.0002, 0.00033, 7.445000e-05\n-0.0001, -0.00033, 5.945000e-05\n-0.0001, -0.00022, 2.920000e-05\n-0.0001, -0.00011, 1.105000e-05\n-0.0001, 0, 5.000000e-06\n-0.0001, 0.00011, 1.105000e-05\n-0.0001, 0.00022, 2.920000e-05\n-0.0001, 0.00033, 5.945000e-05\n0, -0.00033, 5.445000e-05\n0, -0.00022, 2.420000e-05\n0, -0.00011, 6.050000e-06\n0, 0, 0.000000e+00\n0, 0.00011, 6.050000e-06\n0, 0.00022, 2.420000e-05\n0, 0.00033, 5.445000e-05\n0.0001, -0.00033, 5.945000e-05\n0.0001, -0.00022, 2.920000e-05\n0.0001, -0.00011, 1.105000e-05\n0.0001, 0, 5.000000e-06\n0.0001, 0.00011, 1.105000e-05\n0.0001, 0.00022, 2.920000e-05\n0.0001, 0.00033, 5.945000e-05\n0.0002, -0.00033, 7.445000e-05\n0.0002, -0.00022, 4.420000e-05\n0.0002, -0.00011, 2.605000e-05\n0.0002, 0, 2.000000e-05\n0.0002, 0.00011, 2.605000e-05\n0.0002, 0.00022, 4.420000e-05\n0.0002, 0.00033, 7.445000e-05\n0.0003, -0.00033, 9.945000e-05\n0.0003, -0.00022, 6.920000e-05\n0.0003, -0.00011, 5.105000e-05\n0.0003, 0, 4.500000e-05\n0.0003, 0.00011, 5.105000e-05\n0.0003, 0.00022, 6.920000e-05\n0.0003, 0.00033, 9.945000e-05\n";

const PROFILE: &str = "a, b, c, d\n0, 0, 0, 0\n1e-05, 1.1e-05, 5e-07, 6e-07\n2e-05, 2.2e-05, 1.5e-06, 1.7e-06\n3e-05, 3.3e-05, 2.5e-06, 2.5e-06\n4e-05, 4.4e-05, 3e-06, 3.1e-06\n5e-05, 5.5e-05, 2.5e-06, 2.7e-06\n6e-05, 6.6e-05, 2e-06, 2e-06\n7e-05, 7.7e-05, 1e-06, 1.1e-06\n8e-05, 8.8e-05, 5e-07, 7e-07\n9e-05, 9.9e-05, 2.5e-07, 2.5e-07\n0.0001, 0.00011, 5e-07, 6e-07\n0.00011, 0.000121, 0, 2e-07\n";
const OTHER_PROFILE: &str = "a, b, c, d\n0, 0, 0, 0\n1e-05, 1.1e-05, 5.2e-07, 5e-07\n2e-05, 2.2e-05, 1.56e-06, 1.5e-06\n3e-05, 3.3e-05, 2.6e-06, 2.5e-06\n4e-05, 4.4e-05, 3.12e-06, 3e-06\n5e-05, 5.5e-05, 2.6e-06, 2.5e-06\n6e-05, 6.6e-05, 2.08e-06, 2e-06\n7e-05, 7.7e-05, 1.04e-06, 1e-06\n8e-05, 8.8e-05, 5.2e-07, 5e-07\n9e-05, 9.9e-05, 2.6e-07, 2.5e-07\n0.0001, 0.00011, 5.2e-07, 5e-07\n0.00011, 0.000121, 0, 0\n";
const POINTS: &str = "a, b, c, d\n0, 0, 1e-06, 1e-06\n2e-05, 0, 1.89121e-06, 1.99121e-06\n4e-05, 0, 1.8085e-06, 1.8085e-06\n6e-05, 0, 8.42254e-07, 9.42254e-07\n8e-05, 0, 4.83979e-08, 4.83979e-08\n0.0001, 0, 2.9446e-07, 3.9446e-07\n0, 2e-05, 6.2161e-07, 7.2161e-07\n2e-05, 2e-05, 1.55282e-06, 1.55282e-06\n4e-05, 2e-05, 1.51011e-06, 1.61011e-06\n6e-05, 2e-05, 5.83864e-07, 5.83864e-07\n8e-05, 2e-05, -1.69992e-07, -6.99921e-08\n0.0001, 2e-05, 1.1607e-07, 1.1607e-07\n0, 4e-05, -2.27202e-07, -2.27202e-07\n2e-05, 4e-05, 7.44005e-07, 8.44005e-07\n4e-05, 4e-05, 7.41294e-07, 7.41294e-07\n6e-05, 4e-05, -1.44948e-07, -4.49478e-08\n8e-05, 4e-05, -8.58804e-07, -8.58804e-07\n0.0001, 4e-05, -5.32742e-07, -4.32742e-07\n0, 6e-05, -9.04072e-07, -8.04072e-07\n2e-05, 6e-05, 1.07135e-07, 1.07135e-07\n4e-05, 6e-05, 1.44424e-07, 2.44424e-07\n6e-05, 6e-05, -7.01818e-07, -7.01818e-07\n8e-05, 6e-05, -1.37567e-06, -1.27567e-06\n0.0001, 6e-05, -1.00961e-06, -1.00961e-06\n0, 8e-05, -8.96758e-07, -8.96758e-07\n2e-05, 8e-05, 1.54449e-07, 2.54449e-07\n4e-05, 8e-05, 2.31738e-07, 2.31738e-07\n6e-05, 8e-05, -5.74504e-07, -4.74504e-07\n8e-05, 8e-05, -1.20836e-06, -1.20836e-06\n0.0001, 8e-05, -8.02299e-07, -7.02299e-07\n";
const OTHER_POINTS: &str = "a, b, c, d\n0, 0, 1.1e-06, 1.1e-06\n2e-05, 0, 2.08033e-06, 2.18033e-06\n4e-05, 0, 1.98935e-06, 1.98935e-06\n6e-05, 0, 9.2648e-07, 1.02648e-06\n8e-05, 0, 5.32377e-08, 5.32377e-08\n0.0001, 0, 3.23906e-07, 4.23906e-07\n0, 2e-05, 6.83771e-07, 7.83771e-07\n2e-05, 2e-05, 1.7081e-06, 1.7081e-06\n4e-05, 2e-05, 1.66112e-06, 1.76112e-06\n6e-05, 2e-05, 6.42251e-07, 6.42251e-07\n8e-05, 2e-05, -1.86991e-07, -8.69913e-08\n0.0001, 2e-05, 1.27677e-07, 1.27677e-07\n0, 4e-05, -2.49922e-07, -2.49922e-07\n2e-05, 4e-05, 8.18406e-07, 9.18406e-07\n4e-05, 4e-05, 8.15424e-07, 8.15424e-07\n6e-05, 4e-05, -1.59443e-07, -5.94426e-08\n8e-05, 4e-05, -9.44685e-07, -9.44685e-07\n0.0001, 4e-05, -5.86017e-07, -4.86017e-07\n0, 6e-05, -9.94479e-07, -8.94479e-07\n2e-05, 6e-05, 1.17849e-07, 1.17849e-07\n4e-05, 6e-05, 1.58867e-07, 2.58867e-07\n6e-05, 6e-05, -7.72e-07, -7.72e-07\n8e-05, 6e-05, -1.51324e-06, -1.41324e-06\n0.0001, 6e-05, -1.11057e-06, -1.11057e-06\n0, 8e-05, -9.86434e-07, -9.86434e-07\n2e-05, 8e-05, 1.69894e-07, 2.69894e-07\n4e-05, 8e-05, 2.54912e-07, 2.54912e-07\n6e-05, 8e-05, -6.31955e-07, -5.31955e-07\n8e-05, 8e-05, -1.3292e-06, -1.3292e-06\n0.0001, 8e-05, -8.82529e-07, -7.82529e-07\n";

const CREEP: &str = "[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\ncreep = [{ fraction = 0.6, retardation_time = 1.0 }, { fraction = 0.4, retardation_time = 0.1 }]\n";
const SOFT: &str = "[material]\nrelaxed_modulus = 1e6\npoisson_ratio = 0.4\nrelaxation = [{ modulus = 3e6, relaxation_time = 0.1 }]\n";
const REDUCED: &str = "units = \"reduced\"\n[material]\nglassy_modulus = 10\ncreep = [{ fraction = 1.0, retardation_time = 1.0 }]\n";
const TORN: &str = "[adhesion]\nwork_of_adhesion = 10.0\nprocess_zone = { length = 1e-6 }\n[crack]\nbody = \"two_halves\"\nplane = \"strain\"\nspeed = 1e-6\n";
const STICKY: &str = "[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = { length = 2e-6 }\n";
const LAW: &str = "[adhesion]\nwork_of_adhesion = 0.017\nlaw = \"exponential\"\nrange = 3e-7\n";
const WAVE: &str = "[sliding.wave]\nwavelength = 1e-4\namplitude = 3e-6\n";

/// The scenes: what they are, and their text.
fn scenes() -> Vec<(&'static str, String)> {
    let crack_of = |material: &str| format!("{material}{TORN}");
    let press = |head: &str, shape: &str, rest: &str| format!("accuracy = 0.05\n{head}[indentation]\ninstants = 2\n{shape}{rest}");
    let ramp = "[[history]]\npenetration = 2e-6\nduration = 1.0\n";
    vec![
        ("crack at a speed", format!("title = \"torn\"\naccuracy = 1e-6\n{CREEP}[adhesion]\nwork_of_adhesion = 10.0\nprocess_zone = {{ cohesive_stress = 1e6, factor = 0.3, law = \"growing\" }}\n[crack]\nmotion = \"opening\"\nbody = \"two_halves\"\nplane = \"strain\"\ntheories = [\"virtual_work\", \"persson_brener\"]\nspeed = 1e-6\n[fields]\nfrom = 1e-7\nto = 1e-3\npoints = 3\n")),
        ("crack that closes", format!("{CREEP}[adhesion]\nwork_of_adhesion = 10.0\nprocess_zone = {{ cohesive_stress = 1e6, law = \"schapery\" }}\n[crack]\nmotion = \"closing\"\nbody = \"against_rigid\"\nplane = \"stress\"\nspeed = 1e-6\n")),
        ("crack under K", format!("{CREEP}{}", TORN.replace("speed = 1e-6", "stress_intensity = 8e3"))),
        ("crack under G", format!("{CREEP}{}", TORN.replace("speed = 1e-6", "energy_release_rate = 30.0"))),
        ("crack, reduced", format!("{REDUCED}[adhesion]\nprocess_zone = {{ length = 1 }}\n[crack]\nspeed = 1\nbody = \"against_rigid\"\n")),
        ("crack, swept", format!("{}[sweep]\nkey = \"crack.speed\"\nfrom = 1e-6\nto = 1e-4\npoints = 3\nspacing = \"logarithmic\"\n", crack_of(CREEP))),
        ("crack, swept at random", format!("plots = [\"png\"]\n{}[latin_hypercube]\nstates = 3\nseed = 5\n[sweep]\nkey = \"crack.speed\"\nfrom = 1e-6\nto = 1e-4\n", crack_of(CREEP))),
        ("crack, swept by values", format!("{}[sweep]\nkey = \"crack.speed\"\nvalues = [1e-6, 1e-5]\n", crack_of(CREEP))),
        ("crack, work by speed", crack_of(CREEP).replace("work_of_adhesion = 10.0\n", "work_of_adhesion = 10.0\nby_speed = { speed = 1e-5, exponent = 0.3 }\n")),
        ("strip", format!("{CREEP}{}[crack.strip]\nhalf_height = 0.01\nstrain = 0.06\nlateral = \"clamped\"\n", TORN.replace("speed = 1e-6\n", ""))),
        ("strip by stress", format!("{CREEP}{}[crack.strip]\nhalf_height = 0.01\nstress = 1e5\n", TORN.replace("speed = 1e-6\n", ""))),
        ("crack in time", format!("{CREEP}{}points = 3\nspacing = \"logarithmic\"\nfirst_time = 0.01\n[[history]]\nstress_intensity = 5e3\nduration = 0.5\n[[history]]\nhold = 1.0\n", TORN.replace("speed = 1e-6\n", ""))),
        ("crack in cycles", format!("{CREEP}{}points = 3\n[[history]]\nstress_intensity = 2e3\nrate = 4e3\n[[history]]\ncycles = 2\nperiod = 1.0\nlower = 1e3\nupper = 6e3\nwave = \"triangle\"\nquantity = \"stress_intensity\"\n", TORN.replace("speed = 1e-6\n", ""))),
        ("crack by a table", format!("{CREEP}{}points = 3\n[[history]]\ntable = \"load.csv\"\nquantity = \"stress_intensity\"\n[[history]]\nstress_intensity = 6e3\n", TORN.replace("speed = 1e-6\n", ""))),
        ("strip in time", format!("{CREEP}{}points = 3\n[crack.strip]\nhalf_height = 0.01\n[[history]]\nstress = 1e5\nduration = 1.0\n", TORN.replace("speed = 1e-6\n", ""))),
        ("material by compliances", crack_of("[material]\nglassy_modulus = 1e7\npoisson_ratio = 0.4\ncreep = [{ compliance = 9e-7, retardation_time = 1.0 }]\n")),
        ("material that flows", crack_of("[material]\nglassy_modulus = 1e7\npoisson_ratio = 0.4\nviscosity = 1e6\ncreep = [{ compliance = 9e-7, retardation_time = 1.0 }]\n")),
        ("material by moduli", crack_of(SOFT)),
        ("material by parts", crack_of("[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\nrelaxation = [{ fraction = 1.0, relaxation_time = 1.0 }]\n").replace("fraction = 1.0, relaxation_time = 1.0", "fraction = 0.5, relaxation_time = 1.0 }, { fraction = 0.5, relaxation_time = 0.1")),
        ("material of a file", crack_of("[material]\nfile = \"steel.toml\"\nname = \"steel\"\nleave_out = 0\n")),
        ("power law", crack_of("[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\npower_law = { exponent = 0.5, time = 1.0 }\nexpansion = { accuracy = 0.02, slowest_time = 100.0, fastest_time = 0.01 }\n")),
        ("fractional solid", crack_of("[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\nfractional_zener = { exponent = 0.5, time = 1.0 }\nexpansion = { accuracy = 0.02, slowest_time = 100.0, fastest_time = 0.01 }\n")),
        ("wlf", crack_of(&format!("{CREEP}temperature = 300.0\nreference_temperature = 293.0\nshift = {{ wlf = {{ c1 = 10.0, c2 = 100.0 }} }}\n"))),
        ("arrhenius", crack_of(&format!("{CREEP}temperature = 300.0\nreference_temperature = 293.0\nshift = {{ arrhenius = {{ activation_energy = 5e4 }} }}\n"))),
        ("factors", crack_of(&format!("{CREEP}temperature = 298.0\nreference_temperature = 293.0\nshift = {{ factors = [{{ temperature = 293.0, factor = 1.0 }}, {{ temperature = 313.0, factor = 0.1 }}] }}\n"))),
        ("table of factors", crack_of(&format!("{CREEP}temperature = \"25 °C\"\nreference_temperature = \"20 °C\"\nshift = {{ table = \"shift.csv\" }}\n"))),
        ("data, moduli", crack_of("[material]\ndata = \"moduli.csv\"\nfit_error = 0.1\npoisson_ratio = 0.4\n[material.columns]\nangular_frequency = \"a in rad/s\"\nstorage_modulus = \"c in Pa\"\nloss_modulus = \"d in Pa\"\n")),
        ("data, propagated", crack_of("[material]\ndata = \"moduli.csv\"\nfit_error = 0.1\nuncertainty = \"propagate\"\npoisson_ratio = 0.4\n[material.columns]\nangular_frequency = \"a in rad/s\"\nstorage_modulus = \"c in Pa\"\nloss_modulus = \"d in Pa\"\n")),
        ("data, tangent", crack_of("[material]\ndata = \"tangent.csv\"\nfit_error = 0.1\npoisson_ratio = 0.4\n[material.columns]\nfrequency = \"a in Hz\"\nstorage_modulus = \"c in Pa\"\nloss_tangent = \"d in 1\"\n")),
        ("data, phase", crack_of("[material]\ndata = \"tangent.csv\"\nfit_error = 0.1\npoisson_ratio = 0.4\n[material.columns]\nfrequency = \"a in Hz\"\ncomplex_modulus = \"c in Pa\"\nphase_angle = \"d in rad\"\n")),
        ("data, warm", crack_of("[material]\ndata = \"warm.csv\"\nfit_error = 0.2\npoisson_ratio = 0.4\ntemperature = 300.0\nreference_temperature = 293.15\nshift = { wlf = { c1 = 10.0, c2 = 100.0 } }\n[material.columns]\nfrequency = \"a in Hz\"\nstorage_modulus = \"c in Pa\"\nloss_modulus = \"d in Pa\"\ntemperature = \"e in K\"\n")),
        ("data, shift found", crack_of("[material]\ndata = \"isotherms.csv\"\nfit_error = 0.1\npoisson_ratio = 0.4\ntemperature = 300.0\nreference_temperature = 293.15\nshift = \"automatic\"\n[material.columns]\nfrequency = \"a in Hz\"\nstorage_modulus = \"c in Pa\"\nloss_modulus = \"d in Pa\"\ntemperature = \"e in K\"\n")),
        ("data, relaxation", crack_of("[material]\ndata = \"relaxation.csv\"\nfit_error = 0.1\npoisson_ratio = 0.4\n[material.columns]\ntime = \"a in s\"\nrelaxation_modulus = \"c in Pa\"\n")),
        ("data, creep", crack_of("[material]\ndata = \"creep.csv\"\nfit_error = 0.1\npoisson_ratio = 0.4\n[material.columns]\ntime = \"a in s\"\ncreep_compliance = \"c in 1/Pa\"\n")),
        ("solid by shear and volume", crack_of("[material]\nshear_modulus = 3e6\nbulk_modulus = 9e6\nmoduli = \"instantaneous\"\nshear_relaxation = [{ fraction = 0.3, relaxation_time = 1.0 }, { fraction = 0.2, decay_rate = 3.0 }]\nbulk_relaxation = [{ fraction = 0.2, relaxation_time = 1.0 }, { fraction = 0.1, decay_rate = 3.0 }]\n")),
        ("solid by terms of both", crack_of("[material]\nshear_modulus = 1e6\nbulk_modulus = 9e6\nmoduli = \"long_term\"\nshear_relaxation = [{ modulus = 2e6, relaxation_time = 1.0 }]\nbulk_relaxation = [{ modulus = 2e6, decay_rate = 3.0 }]\n")),
        ("solid by decay rates", crack_of("[material]\nglassy_modulus = 1e7\npoisson_ratio = 0.4\nrelaxation = [{ fraction = 0.4, decay_rate = 3.0 }, { fraction = 0.3, relaxation_time = 1.0 }]\n")),
        ("deck of Abaqus", crack_of("[material]\nabaqus = \"card.inp\"\ndeck_material = \"TWO\"\ntemperature = 300.0\ndeck_units = { pressure = \"MPa\", time = \"s\", temperature = \"°C\" }\n")),
        ("deck of ANSYS", crack_of("[material]\nansys = \"card.dat\"\ndeck_units = { pressure = \"MPa\", time = \"s\" }\n")),
        ("deck of LS-DYNA", crack_of("[material]\nls_dyna = \"card.k\"\ndeck_units = { pressure = \"MPa\", time = \"s\" }\n")),
        ("deck of COMSOL", crack_of("[material]\ncomsol = \"card.txt\"\nmoduli = \"long_term\"\ndeck_units = { pressure = \"MPa\", time = \"s\" }\n")),
        ("deck of MOOSE", crack_of("[material]\nmoose = \"card.i\"\ndeck_units = { pressure = \"MPa\", time = \"s\" }\n")),
        ("wave", format!("accuracy = 1e-4\n{CREEP}{}[sliding]\ncontacts = [\"adhesive\", \"adhesiveless\"]\ncolumns = [\"friction_parts\", \"elastic_companion\", \"sensitivities\"]\nspeed = 1e-5\nmean_pressure = 5e3\n{WAVE}[sliding.counter_body]\nmodulus = 1e8\npoisson_ratio = 0.3\n[fields]\npoints = 4\n", STICKY.replace("2e-6", "5e-7"))),
        ("wave by depth, two works", format!("accuracy = 1e-4\n{CREEP}[adhesion]\ntrailing_work_of_adhesion = 0.05\nleading_work_of_adhesion = 0.03\nprocess_zone = {{ trailing_length = 5e-7, leading_length = 4e-7 }}\n[sliding]\nspeed = 1e-5\npenetration = 1e-6\n{WAVE}")),
        ("wave with growing zones", format!("accuracy = 1e-4\n{CREEP}[adhesion]\nwork_of_adhesion = 0.02\nprocess_zone = {{ law = \"dugdale\", peak_stress = 1e6 }}\n[sliding]\nspeed = 1e-5\nmean_pressure = 5e3\n{WAVE}")),
        ("wave in a frame", format!("{CREEP}{STICKY}[sliding]\nspeed = 1e-3\nhalf_width = 1.2e-6\nframe_stiffness = 1e13\n{WAVE}")),
        ("wave, reduced", format!("accuracy = 1e-4\n{REDUCED}[adhesion]\nwork_of_adhesion = 0.01\nprocess_zone = {{ length = 0.01 }}\n[sliding]\nspeed = 0.1\nmean_pressure = 0.1\n[sliding.wave]\n")),
        ("cylinder", format!("accuracy = 1e-4\n{CREEP}[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = {{ cohesive_stress = 2e5, factor = 0.3 }}\n[sliding]\nspeed = 1e-5\nload_per_width = 1.0\n[sliding.cylinder]\nradius = 1e-3\n")),
        ("cylinder by width", format!("accuracy = 1e-4\n{CREEP}[sliding]\nspeed = 1e-5\nhalf_width = 2e-5\n[sliding.cylinder]\nradius = 1e-3\n")),
        ("wave, law of works", format!("accuracy = 1e-4\n{CREEP}[adhesion]\nwork_of_adhesion = 0.02\nby_speed = {{ speed = 1e-5, exponent = 0.3 }}\nprocess_zone = {{ length = 5e-7 }}\n[sliding]\nspeed = 1e-6\nmean_pressure = 5e3\n{WAVE}")),
        ("wave, table of works", format!("accuracy = 1e-4\n{CREEP}[adhesion]\nprocess_zone = {{ length = 5e-7 }}\n[adhesion.by_speed]\ntable = [{{ speed = 1e-6, work_of_adhesion = 0.04 }}, {{ speed = 1e-4, work_of_adhesion = 0.06 }}]\n[sliding]\nspeed = 1e-5\nmean_pressure = 5e3\n{WAVE}")),
        ("wave, table of both works", format!("accuracy = 1e-4\n{CREEP}[adhesion]\nprocess_zone = {{ length = 5e-7 }}\n[adhesion.by_speed]\ntable = [{{ speed = 1e-6, trailing_work_of_adhesion = 0.04, leading_work_of_adhesion = 0.03 }}, {{ speed = 1e-4, trailing_work_of_adhesion = 0.06, leading_work_of_adhesion = 0.04 }}]\n[sliding]\nspeed = 1e-5\nmean_pressure = 5e3\n{WAVE}")),
        ("wave, file of works", format!("accuracy = 1e-4\n{CREEP}[adhesion]\nprocess_zone = {{ length = 5e-7 }}\nby_speed = {{ file = \"works.csv\" }}\n[sliding]\nspeed = 1e-5\nmean_pressure = 5e3\n{WAVE}")),
        ("branch of loads", format!("accuracy = 1e-3\n{CREEP}{}[sliding]\nspeed = 1e-6\n{WAVE}[sliding.branch]\nparameter = \"mean_pressure\"\npoints = 8\nfrom = 700.0\nto = 2e3\n", STICKY.replace("2e-6", "5e-7").replace("0.05", "0.02"))),
        ("branch of all loads", format!("accuracy = 1e-3\n{CREEP}{}[sliding]\nspeed = 1e-6\n{WAVE}[sliding.branch]\nparameter = \"mean_pressure\"\npoints = 8\nframe_stiffness = 1e10\n", STICKY.replace("2e-6", "5e-7").replace("0.05", "0.02"))),
        ("branch of widths", format!("accuracy = 1e-3\n{SOFT}{}[sliding]\nspeed = 1e-5\n{WAVE}[sliding.branch]\nparameter = \"half_width\"\npoints = 3\nfrom = 1e-5\nto = 2e-5\nbranches = \"followed\"\n", STICKY.replace("2e-6", "5e-7"))),
        ("wave with a law", format!("accuracy = 0.02\n{CREEP}{LAW}[sliding]\ncontacts = [\"adhesive\", \"adhesiveless\"]\nspeed = 1e-5\nmean_pressure = 2e4\nreached_by = \"unloading\"\n{WAVE}[sliding.counter_body]\nmodulus = 1e8\npoisson_ratio = 0.3\n[fields]\npoints = 4\n")),
        ("wave with a law, in a frame", format!("accuracy = 0.02\n{CREEP}[adhesion]\nwork_of_adhesion = 0.017\nlaw = \"dugdale\"\npeak_stress = 6e4\nramp = 0.4\n[sliding]\nspeed = 1e-5\nmean_gap = 2e-6\nframe_stiffness = 1e11\n{WAVE}[sliding.layer]\nthickness = 2e-5\nbacking = \"bonded\"\n")),
        ("wave with a law by points", format!("accuracy = 0.02\n{CREEP}[adhesion]\ntable = \"wave_law.csv\"\ncolumns = {{ gap = \"b in m\", stress = \"c in Pa\" }}\n[sliding]\nspeed = 1e-5\nmean_pressure = 2e4\n{WAVE}")),
        ("wave with a law, reduced", format!("accuracy = 0.02\n{REDUCED}[adhesion]\nwork_of_adhesion = 0.006\nlaw = \"lennard_jones\"\nrange = 0.15\n[sliding]\nspeed = 0.5\nmean_pressure = 0.2\nlayer = {{ thickness = 1.0, poisson_ratio = 0.4 }}\n[sliding.wave]\n")),
        ("harmonics", format!("accuracy = 0.02\n{CREEP}{LAW}[sliding]\nspeed = 1e-5\nmean_pressure = 2e4\n[sliding.profile]\nperiod = 1e-4\nharmonics = [{{ number = 1, amplitude = 3e-6, phase = 0.2 }}, {{ number = 2, amplitude = 1e-6 }}]\n")),
        ("profile of a file", format!("accuracy = 1e-6\n{CREEP}[sliding]\nspeed = 1e-5\nmean_pressure = 2e3\nmost_nodes = 2047\n[sliding.profile]\nfile = \"profile.csv\"\ncolumns = {{ x = \"a in m\", h = \"c in m\" }}\nlevelling = \"plane\"\nends = \"mirror\"\n")),
        ("rough profile", format!("accuracy = 0.02\n{CREEP}{LAW}[sliding]\nspeed = 1e-5\nmean_pressure = 2e4\n[sliding.profile]\nperiod = 1.2e-4\nroughness = {{ hurst = 0.8, rms_height = 1.5e-6, longest = 6.1e-5, shortest = 2e-5, seed = 3 }}\n")),
        ("rough profile in a loop", format!("accuracy = 0.02\n{CREEP}{LAW}[sliding]\nspeed = 1e-5\nmean_pressure = 2e4\nloop = {{ to = 3e4, points = 2 }}\n[sliding.profile]\nperiod = 1e-4\nroughness = {{ hurst = 0.8, rms_height = 1.5e-6, longest = 1e-4, shortest = 3e-5 }}\n")),
        ("wave with a law, its branch", format!("accuracy = 0.02\n{CREEP}{LAW}[sliding]\nspeed = 1e-5\nmean_pressure = 2e4\n{WAVE}[sliding.branch]\nparameter = \"mean_pressure\"\npoints = 3\n")),
        ("surface of rows", format!("accuracy = 0.1\n{CREEP}[sliding]\nspeed = 1e-5\nmean_pressure = 3e5\n[sliding.surface]\nfile = \"heights.txt\"\npixel = 2e-5\nheight_unit = 4e-7\ndirection = \"x\"\nlevelling = \"plane\"\nends = \"mirror\"\n")),
        ("surface of points", format!("accuracy = 0.1\n{CREEP}[sliding]\nspeed = 1e-5\nmean_pressure = 3e5\n[sliding.surface]\nfile = \"points.csv\"\ncolumns = {{ x = \"a in m\", y = \"b in m\", z = \"c in m\" }}\n")),
        ("rough surface", format!("accuracy = 0.1\n{CREEP}[sliding]\nspeed = 1e-5\nmean_pressure = 3e5\n[sliding.surface]\nperiod = 1.2e-4\nroughness = {{ hurst = 0.8, rms_height = 1e-6, longest = 1e-4, shortest = 4e-5, seed = 3 }}\n")),
        ("strength", format!("accuracy = 1e-3\n{SOFT}{}[sliding]\nspeed = 1e-5\n{WAVE}[sliding.strength]\n", STICKY.replace("2e-6", "5e-7"))),
        ("sphere", press(&format!("{SOFT}{STICKY}interaction_range = 1e-9\n"), "sphere = { radius = 1e-3 }\nstart = \"untouched\"\nspeed_factor = 1.0\n", &format!("[indentation.energies]\n[indentation.fields]\ntimes = [0.5]\nto = 1e-4\npoints = 3\n{ramp}"))),
        ("sphere, relaxed in a frame", press(&format!("{SOFT}[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = {{ cohesive_stress = 1e5, factor = 0.3 }}\n"), "sphere = { radius = 1e-3 }\nstart = \"relaxed\"\nforce = 1e-3\nframe_stiffness = 100.0\n", "[[history]]\nforce = 5e-4\nrate = 1e-3\n[[history]]\nhold = 0.5\n")),
        ("sphere that attracts at a distance", press(&format!("{CREEP}[adhesion]\nwork_of_adhesion = 0.05\nlaw = \"lennard_jones\"\nrange = 1e-7\n"), "sphere = { radius = 1e-5 }\nstart = \"relaxed\"\npenetration = 2e-7\nframe_stiffness = 1.0\n", "[indentation.energies]\n[indentation.fields]\ntimes = [0.5]\nto = 1e-6\npoints = 3\n[[history]]\npenetration = -3e-7\nduration = 1.0\n")),
        ("cone with a largest tension", press(&format!("{CREEP}[adhesion]\nwork_of_adhesion = 0.05\nlaw = \"cosine\"\npeak_stress = 1e5\n"), "cone = { slope = 0.1 }\nspeed_factor = 2.0\n", "[[history]]\npenetration = 1e-7\nduration = 1.0\n[[history]]\nhold = 1.0\n")),
        ("sphere with a table of its law", press(&format!("{CREEP}[adhesion]\ntable = \"law.csv\"\ncolumns = {{ gap = \"u in m\", stress = \"w in Pa\" }}\n"), "sphere = { radius = 1e-5 }\n", "[[history]]\npenetration = 1e-7\nduration = 1.0\n")),
        ("sphere, no adhesion", press(SOFT, "sphere = { radius = 1e-3 }\n", ramp)),
        ("two spheres", press(SOFT, "sphere = { radius = 1e-3 }\ncounter_body = { modulus = 1e7, poisson_ratio = 0.3, radius = 2e-3 }\n", ramp)),
        ("sphere, relaxed, no adhesion", press(SOFT, "sphere = { radius = 1e-3 }\nstart = \"relaxed\"\npenetration = 2e-6\n", "[[history]]\npenetration = 1e-6\nduration = 1.0\n")),
        ("sphere, its edge held", press(&format!("{SOFT}{STICKY}"), "sphere = { radius = 1e-3 }\nstart = \"relaxed\"\ncontact_radius = 5e-5\n", "[[history]]\ncontact_radius = 4e-5\nduration = 1.0\n")),
        ("sphere by a table", press(SOFT, "sphere = { radius = 1e-3 }\n", "[[history]]\ntable = \"history.csv\"\nquantity = \"penetration\"\n")),
        ("sphere by its frame", press(SOFT, "sphere = { radius = 1e-3 }\nframe_stiffness = 100.0\n", "[[history]]\nframe = 5e-6\nduration = 1.0\n")),
        ("sphere in cycles", press(SOFT, "sphere = { radius = 1e-3 }\n", "[[history]]\ncycles = 1\nperiod = 1.0\nlower = 1e-6\nupper = 2e-6\nwave = \"triangle\"\nquantity = \"penetration\"\n")),
        ("punch that swings", press(SOFT, "flat_punch = { radius = 1e-4 }\n", "[[history]]\npenetration = 2e-6\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1.0, cycles = 2, to = 3e-6 }\n")),
        ("punch that swings faster", press(SOFT, "flat_punch = { radius = 1e-4 }\n", "[[history]]\npenetration = 2e-6\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1.0, to_frequency = 2.0, frequency_sweep = \"linear\", duration = 2.0 }\n")),
        ("punch that settles", press(SOFT, "flat_punch = { radius = 1e-4 }\n", "[[history]]\npenetration = 2e-6\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1.0, cycles = 30, until_stationary = true }\n")),
        ("sphere that swings for ever", press(&format!("{SOFT}{STICKY}"), "sphere = { radius = 1e-3 }\nstart = \"relaxed\"\npenetration = 3e-6\n", "[[history]]\noscillation = { quantity = \"penetration\", amplitude = 3e-7, frequency = 1.0, periodic = true }\n")),
        ("cone", press(SOFT, "cone = { slope = 0.1 }\n", ramp)),
        ("cone with a rim", press(SOFT, "cone = { slope = 0.1 }\nrim_radius = 1e-5\n", ramp)),
        ("body of a power", press(SOFT, "power_law = { radius = 1e-3, exponent = 3.0 }\n", ramp)),
        ("profile", press(SOFT, "profile = \"shape.csv\"\n", ramp)),
        ("profile, named", press(SOFT, "profile = \"face.csv\"\nscan.columns = { r = \"u in m\", z = \"w in m\" }\n", ramp)),
        ("profile of a line", press(SOFT, "profile = \"scan.csv\"\nscan = { apex = \"lowest\", to = 4e-4, largest_residual = 0.1, columns = { x = \"u in m\", z = \"w in m\" } }\n", ramp)),
        ("profile of a map", press(SOFT, "profile = \"map.csv\"\nscan.columns = { x = \"u in m\", y = \"v in m\", z = \"w in m\" }\n", ramp)),
        ("sphere by named columns", press(SOFT, "sphere = { radius = 1e-3 }\n", "[[history]]\ntable = \"named.csv\"\nquantity = \"penetration\"\ncontact_point = 1e-8\ninvert = false\ntolerance = 1e-8\nnoise = \"followed\"\ncolumns = { time = \"a in s\", penetration = \"b in m\", force = \"c in N\" }\n")),
        ("sphere by a named force", press(SOFT, "sphere = { radius = 1e-3 }\n", "[[history]]\ntable = \"named.csv\"\nquantity = \"force\"\ncolumns = { time = \"a in s\", force = \"c in N\" }\n")),
        ("sphere by a named radius", press(SOFT, "sphere = { radius = 1e-3 }\n", "[[history]]\ntable = \"named.csv\"\nquantity = \"contact_radius\"\ncolumns = { time = \"a in s\", contact_radius = \"b in m\" }\n")),
        ("sphere by a named frame", press(SOFT, "sphere = { radius = 1e-3 }\nframe_stiffness = 100.0\n", "[[history]]\ntable = \"named.csv\"\nquantity = \"frame\"\ncolumns = { time = \"a in s\", frame = \"b in m\" }\n")),
        ("crack by named columns", format!("{CREEP}{}points = 3\n[[history]]\ntable = \"named.csv\"\ncolumns = {{ time = \"a in s\", stress_intensity = \"e in Pa √m\" }}\n", TORN.replace("speed = 1e-6\n", ""))),
        ("strip by named columns", format!("{CREEP}{}points = 3\n[crack.strip]\nhalf_height = 1.0\n[[history]]\ntable = \"named.csv\"\ncolumns = {{ time = \"a in s\", stress = \"e in Pa\" }}\n", TORN.replace("speed = 1e-6\n", ""))),
    ]
}

/// A folder with the files that scenes name.
fn folder() -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("viscotack-keys-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for (name, text) in FILES {
        std::fs::write(folder.join(name), text).unwrap();
    }
    folder
}

/// What came out, or why the scene is refused.
fn result(text: &str, folder: &std::path::Path, set: Option<&str>) -> Result<Vec<u8>, String> {
    let mut document = Document::parse("scene.toml", text.to_owned(), folder).map_err(|error| error.to_string())?;
    let is_file = set.is_some_and(|set| set.starts_with("material.file=") || set.starts_with("material.data="));
    if let Some(set) = set.filter(|_| is_file) {
        document.set(set).map_err(|error| error.to_string())?;
    }
    read::resolve_includes(&mut document).map_err(|error| error.to_string())?;
    if let Some(set) = set.filter(|_| !is_file) {
        document.set(set).map_err(|error| error.to_string())?;
        read::resolve_includes(&mut document).map_err(|error| error.to_string())?;
    }
    let scene = read::read(&document).map_err(|error| error.to_string())?;
    let outcome = plan::run(&document, &scene, Vec::new(), None, &|_| ()).map_err(|error| error.to_string())?;
    let whole = summary(&outcome);
    let mut bytes = Vec::new();
    for table in [Table::States, Table::Path, Table::Fields] {
        bytes.extend(csv_table::table(&outcome, table).unwrap().unwrap_or_default());
    }
    bytes.extend(format!("{:?}", outcome.pictures).bytes());
    for part in ["title", "accuracy", "validity", "columns", "swept"] {
        bytes.extend(whole[part].to_string().bytes());
    }
    let mut rows = whole["results"].clone();
    for row in rows.as_array_mut().unwrap() {
        row.as_object_mut().unwrap().remove("work");
    }
    bytes.extend(rows.to_string().bytes());
    Ok(bytes)
}

/// The real paths at which a key stands, or would stand, in a scene; and the node there.
fn places<'a>(root: &'a Node, path: &str) -> Vec<(String, Option<&'a Node>)> {
    let mut found: Vec<(String, Option<&Node>)> = vec![(String::new(), Some(root))];
    for part in path.split('.') {
        let (name, list) = part.strip_suffix("[]").map_or((part, false), |name| (name, true));
        let mut next = Vec::new();
        for (before, node) in found {
            let full = if before.is_empty() { name.to_owned() } else { format!("{before}.{name}") };
            let child = node.and_then(|node| node.get(name));
            match (list, child.map(|child| &child.value)) {
                (false, _) => next.push((full, child)),
                (true, Some(Value::List(items))) => {
                    next.extend(items.iter().enumerate().map(|(index, item)| (format!("{full}.{index}"), Some(item))));
                }
                // A sweep that is one table, or a list that is not there.
                (true, _) => {}
            }
        }
        found = next;
    }
    found
}

/// Keys of scenes that `run` takes: those of [fit] are for `viscotack fit`, and tests/fit_of_scenes.rs changes them.
fn of_runs() -> impl Iterator<Item = &'static Key> {
    keys().filter(|key| key.path != "fit" && !key.path.starts_with("fit."))
}

/// Values to try in place of what is there, as TOML.
fn trials(key: &Key, present: Option<&Node>) -> Vec<String> {
    if let Some((_, samples)) = SAMPLES.iter().find(|(path, _)| *path == key.path) {
        return samples.iter().map(|sample| (*sample).to_owned()).collect();
    }
    let words = |words: &[viscotack::scene::catalogue::Word]| words.iter().map(|word| word.word.to_owned()).collect::<Vec<_>>();
    let written = present.map_or("", Node::written).trim_matches('"').to_owned();
    match key.kind {
        Kind::Number { .. } | Kind::NumberOfSweptKey => match present.map(|node| &node.value) {
            Some(Value::Number(value)) => {
                [1.03, 0.97, 1.3, 0.7, 2.0].iter().map(|factor| format!("{:e}", value * factor)).chain(["0.37".into()]).collect()
            }
            Some(Value::Text(text)) => {
                let (number, unit) = text.split_once(' ').unwrap();
                vec![format!("\"{} {unit}\"", number.parse::<f64>().unwrap() * 1.03)]
            }
            _ => ["0.5", "3.7e-6", "1.3e3", "2.9e5", "290.0", "1.1e-3", "-0.5"].map(str::to_owned).to_vec(),
        },
        Kind::NumbersOfSweptKey => vec!["[0.25, 0.75]".into(), "[2e-6, 3e-6]".into()],
        Kind::Count { least, .. } => match present.map(|node| &node.value) {
            Some(Value::Number(value)) => vec![format!("{}", value + 1.0), format!("{}", value + 4.0)],
            _ => vec![format!("{}", least.max(1) + 2), "3".into(), "7".into()],
        },
        Kind::Choice(list) => words(list).into_iter().filter(|word| *word != written).map(|word| format!("{word:?}")).collect(),
        Kind::Choices(list) => words(list).into_iter().map(|word| format!("[{word:?}]")).collect(),
        Kind::Flag => ["true", "false"].into_iter().filter(|flag| *flag != written).map(str::to_owned).collect(),
        Kind::Text | Kind::Texts => vec!["\"another one\"".into()],
        // Tables are tested by their members; one without members by its being there.
        Kind::TableOrWord(list) if present.is_none_or(|node| matches!(node.value, Value::Text(_))) => {
            words(list).into_iter().filter(|word| *word != written).map(|word| format!("{word:?}")).collect()
        }
        Kind::Table | Kind::Tables | Kind::TableOrTables | Kind::TableOrWord(_) => match present {
            None if !keys().any(|other| other.path.strip_prefix(key.path).is_some_and(|rest| rest.starts_with(['.', '[']))) => {
                vec!["{}".into()]
            }
            _ => Vec::new(),
        },
    }
}

/// Whether a word is the default: the one trial of a choice that may change nothing.
const fn has_default(kind: Kind) -> bool {
    matches!(kind, Kind::Choice(_) | Kind::Choices(_) | Kind::Flag)
}

/// Of every problem and option of the catalogue, and of every shipped scene: a reader by name finds each column.
#[test]
fn no_table_has_two_equal_headers() {
    let folder = folder();
    let mut documents: Vec<(String, Document)> =
        scenes().into_iter().map(|(name, text)| (name.to_owned(), Document::parse("scene.toml", text, &folder).unwrap())).collect();
    documents.extend(shipped_scenes().into_iter().map(|path| (path.display().to_string(), Document::load(&path).unwrap())));
    let wrong: Vec<String> = documents
        .into_par_iter()
        .flat_map_iter(|(name, mut document)| {
            read::resolve_includes(&mut document).unwrap();
            let scene = read::read(&document).unwrap_or_else(|error| panic!("{name}: {error}"));
            let mut outcome = plan::unsolved(&plan::Plan::new(&scene).unwrap(), &document, &scene);
            // A state with a field, so that each table has its header.
            let mut row = Row::new(0, &vec![0.0; outcome.swept.len()], Vec::new(), outcome.columns.len());
            row.fields.push(FieldPoint { place: 0.0, values: vec![Estimate::exact(0.0); outcome.field_columns.len().saturating_sub(1)] });
            outcome.rows.push(row);
            [Table::States, Table::Path, Table::Fields].into_iter().filter_map(move |table| {
                let text = String::from_utf8(csv_table::table(&outcome, table).unwrap()?).unwrap();
                let headers: Vec<&str> = text.lines().next().unwrap().split(',').collect();
                let twice = headers.iter().find(|header| headers.iter().filter(|other| other == header).count() > 1)?;
                Some(format!("{name}: {} has {twice:?} twice", table.file()))
            })
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_key_changes_the_result_or_is_refused_or_is_listed() {
    let folder = folder();
    let scenes = scenes();
    let bases: Vec<(&str, &String, Document, Vec<u8>)> = scenes
        .par_iter()
        .map(|(name, text)| {
            let base = result(text, &folder, None).unwrap_or_else(|error| format!("REFUSED {error}").into_bytes());
            (*name, text, Document::parse("scene.toml", text.clone(), &folder).unwrap(), base)
        })
        .collect();
    // A scene whose state does not exist would show nothing.
    let wrong: Vec<String> = bases
        .iter()
        .map(|(name, .., base)| (name, String::from_utf8_lossy(base)))
        .filter(|(_, base)| base.starts_with("REFUSED") || !(base.contains("solved") || base.contains("inaccurate")))
        .map(|(name, base)| format!("{name}: {base}"))
        .collect();
    assert!(wrong.is_empty(), "scenes of this test are wrong\n{}", wrong.join("\n"));
    let jobs: Vec<(&Key, &(&str, &String, Document, Vec<u8>))> =
        of_runs().flat_map(|key| bases.iter().map(move |base| (key, base))).collect();
    let found: Vec<(&Key, bool, Vec<String>)> = jobs
        .par_iter()
        .map(|(key, (name, text, document, base))| {
            let mut complaints = Vec::new();
            let mut felt = false;
            for (path, present) in places(&document.root, key.path) {
                assert!(!generic_path(&path).is_empty());
                let (mut changed, mut same) = (0, Vec::new());
                let written = present.map_or("", Node::written);
                for trial in trials(key, present).into_iter().filter(|trial| trial != written) {
                    let set = format!("{path}={trial}");
                    let Ok(tried) = std::panic::catch_unwind(|| result(text, &folder, Some(&set))) else {
                        complaints.push(format!("{set} panics in {name:?}"));
                        continue;
                    };
                    match tried {
                        Ok(other) if other == *base => same.push(trial),
                        Ok(_) => changed += 1,
                        Err(_) => {}
                    }
                    // One change is proof for a number; every word of a choice is tried.
                    if changed > 0 && !has_default(key.kind) {
                        break;
                    }
                }
                // A key that is there, and every other value of which is refused, is not ignored; of a table without members, its being there tells.
                felt |= present.is_some() && (changed > 0 || same.is_empty());
                let allowed = usize::from(has_default(key.kind) && present.is_none());
                let ignored = if has_default(key.kind) { same.len() > allowed } else { changed == 0 && !same.is_empty() };
                let listed = NO_EFFECT.iter().any(|(listed, scene, _)| *listed == key.path && name.contains(scene));
                if ignored && !listed {
                    complaints.push(format!("{path} = {same:?} changes nothing in {name:?}, and is not refused"));
                }
            }
            (*key, felt, complaints)
        })
        .collect();
    let mut complaints: Vec<String> = found.iter().flat_map(|(_, _, complaints)| complaints.clone()).collect();
    let felt: BTreeSet<&str> = found.iter().filter(|(_, felt, _)| *felt).map(|(key, ..)| key.path).collect();
    for key in of_runs() {
        let is_leaf = !trials(key, None).is_empty();
        let listed = NO_EFFECT.iter().any(|(listed, ..)| *listed == key.path);
        if is_leaf && !listed && !felt.contains(key.path) {
            complaints.push(format!("{}: no scene of this test holds it and shows what it changes", key.path));
        }
    }
    println!("{} keys, {} scenes", keys().count(), bases.len());
    assert!(complaints.is_empty(), "{} complaints\n{}", complaints.len(), complaints.join("\n"));
}
