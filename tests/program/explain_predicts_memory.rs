//! Source: `Plan::predicted_memory`, what `explain` says about the memory of a run.
//!
//! Goal: a run takes no more memory than was predicted, and the prediction is no empty one.
//!
//! Parameters: scenes of every problem: many rows, many field points, long oscillations, a tabulated shape with a relaxed start and a long hold.
//!
//! Oracle: the largest resident set of a child process, as GNU time or the kernel's high-water mark (VmHWM) tells it.
//!
//! Tolerance: at most the prediction; at least a quarter of it, but for indenters without adhesion, which take less.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, GOOD, SLIDING};
use std::process::{Command, Stdio};

const HEADS: &str =
    "accuracy = 1e-2\n[material]\nrelaxed_modulus = 1e6\npoisson_ratio = 0.4\nrelaxation = [{ modulus = 3e6, relaxation_time = 0.1 }]\n";
const STICKY: &str = "[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = { length = 2e-6 }\n";
const PUNCH: &str = "[indentation]\nflat_punch = { radius = 1e-4 }\n[[history]]\npenetration = 2e-6\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 1.0, cycles = 300 }\n";
const WORN: &str = "[indentation]\nprofile = \"shape.csv\"\nstart = \"relaxed\"\npenetration = 6e-6\n[[history]]\nhold = 1e4\n[[history]]\npenetration = 5e-6\nduration = 1.0\n";
const DELAYED: &str = "[crack]\nbody = \"against_rigid\"\nplane = \"strain\"\npoints = 30000\n[[history]]\nstress_intensity = 300.0\n[[history]]\nhold = 1.0\n";

/// The peak of the resident set of a run (bytes); 0 where the system does not tell it.
///
/// The kernel tells it as long as the run lives, so what is read is at most the peak: a run that ends before the next reading shows less.
/// Runs are therefore repeated until one shows `enough`, thirty times at most, and the greatest counts.
fn peak(folder: &Folder, scene: &str, enough: u64) -> u64 {
    let mut most = 0;
    for _ in 0..30 {
        most = most.max(one_peak(folder, scene));
        if most == 0 || most >= enough {
            break;
        }
    }
    most
}

fn one_peak(folder: &Folder, scene: &str) -> u64 {
    let mut child = Command::new(env!("CARGO_BIN_EXE_viscotack"))
        .args(["run", scene])
        .current_dir(folder.path("."))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0;
    loop {
        if let Ok(text) = std::fs::read_to_string(&status)
            && let Some(kilobytes) =
                text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok())
        {
            most = most.max(1024 * kilobytes);
        }
        if let Some(ended) = child.try_wait().unwrap() {
            assert!(matches!(ended.code(), Some(0 | 4)), "{scene}: {ended}");
            return most;
        }
        std::thread::yield_now();
    }
}

#[test]
fn a_run_takes_the_memory_that_was_predicted() {
    let folder = Folder::new();
    let knots: Vec<String> = (0..60)
        .map(|k| f64::from(k) * 4e-6)
        .map(|r| format!("{r:e}, {:e}", if r < 5e-5 { r * r / 16e-3 } else { 1.5625e-7 + (r - 5e-5) * 0.02 + (r - 5e-5).powi(2) / 2e-3 }))
        .collect();
    folder.write("shape.csv", format!("r (m), z (m)\n{}\n", knots.join("\n")));
    let adhesive = |rest: &str| format!("{HEADS}{STICKY}{rest}");
    let scenes = [
        ("few rows", GOOD.to_owned(), true),
        (
            "many rows",
            GOOD.replace("points = 3", "points = 40000").replace("[fields]\nfrom = \"1 nm\"\nto = \"1 mm\"\npoints = 5\n", ""),
            true,
        ),
        ("many fields", GOOD.replace("points = 5", "points = 100000"), true),
        ("sliding", SLIDING.to_owned(), true),
        ("delayed", adhesive(DELAYED), true),
        ("punch that swings", adhesive(PUNCH), true),
        ("punch that swings, no adhesion", format!("{HEADS}{PUNCH}"), false),
        ("worn tip, long hold", adhesive(WORN), true),
        ("worn tip, long hold, no adhesion", format!("{HEADS}{WORN}"), false),
    ];
    for (name, text, both) in scenes {
        folder.write("scene.toml", text);
        let predicted = folder.call(&["explain", "scene.toml", "--json"]).ended(0).json()["predicted_memory_bytes"].as_u64().unwrap();
        let measured = peak(&folder, "scene.toml", predicted.div_ceil(4));
        println!("{name}: predicted {} MB, measured {:.1} MB", predicted / 1_000_000, measured as f64 / 1e6);
        assert!(measured <= predicted, "{name}");
        assert!(measured == 0 || !both || 4 * measured >= predicted, "{name}");
    }
}
