//! A key that does not exist leads to the one that is meant, or to none.
//!
//! Source: the names that the field and other programs use.
//! Goal: close spelling in the same table first, then the name of the field with its table; never a key that only shares its ending.
//! Oracle: what a reader of the catalogue would type.
//! Tolerance: none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, SINGLE};
use viscotack_program::scene::catalogue;
use viscotack_program::scene::suggest::for_key;

/// Table, unknown key, the path that it leads to ("" for none).
#[rustfmt::skip]
const LEADS: &[(&str, &str, &str)] = &[
    ("material", "relaxed_moduls", "material.relaxed_modulus"),
    ("material", "Relaxed_Modulus", "material.relaxed_modulus"),
    ("material", "relaxed-modulus", "material.relaxed_modulus"),
    ("material", "youngs_modulus", "material.relaxed_modulus"),
    ("material", "E", "material.relaxed_modulus"),
    ("material", "modulus", "material.relaxed_modulus"),
    ("material", "instantaneous_modulus", "material.glassy_modulus"),
    ("material", "nu", "material.poisson_ratio"),
    ("material", "poisson", "material.poisson_ratio"),
    ("material", "Poissons_ratio", "material.poisson_ratio"),
    ("material", "density", ""),
    ("material", "prony", "material.relaxation"),
    ("material", "kelvin_voigt", "material.creep"),
    ("material", "eta", "material.viscosity"),
    ("material", "wlf", "material.shift.wlf"),
    ("material", "a_T", "material.shift"),
    ("material.creep[]", "tau", "material.creep[].retardation_time"),
    ("material.relaxation[]", "tau", "material.relaxation[].relaxation_time"),
    ("material.relaxation[]", "g_i", "material.relaxation[].fraction"),
    ("material.creep[]", "relaxation_time", "material.creep[].retardation_time"),
    ("adhesion", "gamma", "adhesion.work_of_adhesion"),
    ("adhesion", "surface_energy", "adhesion.work_of_adhesion"),
    ("adhesion", "adhesion_energy", "adhesion.work_of_adhesion"),
    ("adhesion", "sigma_c", "adhesion.process_zone.cohesive_stress"),
    ("material", "surface_energy", "adhesion.work_of_adhesion"),
    ("indentation", "radius", "indentation.sphere.radius"),
    ("indentation", "diameter", "indentation.sphere.radius"),
    ("indentation", "indenter", "indentation.sphere"),
    ("indentation", "load", "indentation.force"),
    ("indentation", "depth", "indentation.penetration"),
    ("indentation", "spring_constant", "indentation.frame_stiffness"),
    ("indentation", "second_body", "indentation.counter_body"),
    ("sliding", "radius", "sliding.cylinder.radius"),
    ("sliding", "velocity", "sliding.speed"),
    ("sliding", "friction_coefficient", ""),
    ("sliding", "pressure", "sliding.mean_pressure"),
    ("crack", "velocity", "crack.speed"),
    ("crack", "K", "crack.stress_intensity"),
    ("crack", "G", "crack.energy_release_rate"),
    ("crack", "poison_ratio", "material.poisson_ratio"),
    ("crack.strip", "height", "crack.strip.half_height"),
    ("crack", "length", ""),
    ("test", "speed", "test.retraction_speed"),
    ("", "tolerance", "accuracy"),
    ("", "adhesin", "adhesion"),
    ("", "work_of_adhesion", "adhesion.work_of_adhesion"),
    ("crack", "zzz", "nowhere"),
    ("material", "x", "nowhere"),
    ("material", "colour", "nowhere"),
];

#[test]
fn unknown_keys_lead_to_the_one_that_is_meant() {
    for &(table, key, meant) in LEADS {
        let found = for_key(key, table);
        match (meant, &found) {
            ("nowhere", None) => {}
            ("", Some(suggestion)) => assert!(suggestion.path.is_none() && !suggestion.note.is_empty(), "{table} {key}: {found:?}"),
            (meant, Some(suggestion)) => {
                assert_eq!(suggestion.path, Some(meant), "{table} {key}: {found:?}");
                assert!(catalogue::key(meant).is_some(), "{meant}");
            }
            (_, None) => panic!("[{table}] {key} leads nowhere"),
        }
    }
}

#[test]
fn a_shared_ending_is_not_close() {
    for (table, key, never) in [
        ("material", "shear_modulus", "material.glassy_modulus"),
        ("material", "bulk_modulus", "material.glassy_modulus"),
        ("indentation", "counter_body", "indentation.cone"),
        ("indentation", "substrate", "indentation.start"),
        ("material", "storage_modulus", "material.glassy_modulus"),
    ] {
        assert_ne!(for_key(key, table).and_then(|found| found.path), Some(never), "{key}");
    }
    // The right key is known by the catalogue, or the message says what to do.
    let folder = Folder::with(&SINGLE.replace("relaxed_modulus = \"1 MPa\"", "shear_modulus = \"1 MPa\""));
    if catalogue::key("material.shear_modulus").is_none() {
        let answer = folder.call(&["run", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains("did you mean `relaxed_modulus`?") && answer.stderr.contains("E = 2(1 + ν)G"), "{}", answer.stderr);
    }
}

#[test]
fn every_suggestion_is_a_key_and_says_its_table() {
    let paths: Vec<&str> = catalogue::keys().map(|key| key.path).collect();
    // Whatever is typed, what is suggested exists.
    for table in ["", "material", "adhesion", "crack", "sliding", "indentation", "history[]"] {
        for path in &paths {
            let name = path.rsplit(['.', ']']).next().unwrap();
            if let Some(found) = for_key(name, table).and_then(|found| found.path) {
                assert!(paths.contains(&found), "{found}");
            }
        }
    }
    let folder = Folder::with(&SINGLE.replace("body =", "surface_energy = 0.1\nbody ="));
    let answer = folder.call(&["run", "scene.toml"]).ended(2);
    for says in ["`crack.surface_energy` is not a key", "did you mean `adhesion.work_of_adhesion`?", "twice the surface energy"] {
        assert!(answer.stderr.contains(says), "{says}: {}", answer.stderr);
    }
}
