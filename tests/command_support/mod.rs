//! What the tests of the command line share: a folder of its own for each test, the program run in it, and what it said.
#![allow(dead_code, clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, unreachable_pub)]

use assert_cmd::Command;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A scene that is right: every table of a steady crack, a sweep of three speeds, five field points.
pub const GOOD: &str = r#"title = "A scene for tests"

[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "100 MPa"
poisson_ratio = 0.49
creep = [
  { fraction = 0.4, retardation_time = "1 s" },
  { fraction = 0.6, retardation_time = "1 ms" },
]

[adhesion]
work_of_adhesion = "1 J/m²"
process_zone = { cohesive_stress = "1 MPa" }

[crack]
motion = "opening"
body = "against_rigid"
plane = "stress"
theories = ["virtual_work"]
speed = "1 mm/s"

[sweep]
key = "crack.speed"
from = "1 µm/s"
to = "1 m/s"
points = 3

[fields]
from = "1 nm"
to = "1 mm"
points = 5
"#;

/// A crack under a load history that is right: a step, a hold.
pub const DELAYED: &str = r#"title = "A delayed scene for tests"

[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
creep = [{ fraction = 1, retardation_time = "1 s" }]

[adhesion]
work_of_adhesion = "1 J/m²"
process_zone = { cohesive_stress = "1 MPa" }

[crack]
body = "against_rigid"
plane = "stress"
points = 5

[[history]]
stress_intensity = "3 kPa √m"

[[history]]
hold = "2 s"
"#;

/// A sliding contact that is right, with adhesion and without, at one speed.
pub const SLIDING: &str = r#"title = "A sliding scene for tests"

[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.49
creep = [{ fraction = 1, retardation_time = "10 ms" }]

[adhesion]
work_of_adhesion = "20 mJ/m²"
process_zone = { length = "0.16 µm" }

[sliding]
contacts = ["adhesive", "adhesiveless"]
speed = "1 mm/s"
mean_pressure = "6 kPa"

[sliding.wave]
wavelength = "100 µm"
amplitude = "3 µm"

[fields]
points = 40
"#;

/// One load on one crack: what the tests of single states start from.
pub const SINGLE: &str = r#"
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
speed = "1 mm/s"
"#;

/// What a call of the program gave.
pub struct Answer {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Answer {
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error} in\n{}", self.stdout))
    }

    /// The same answer, after checking its exit code.
    pub fn ended(self, code: i32) -> Self {
        assert_eq!(self.code, code, "stdout:\n{}\nstderr:\n{}", self.stdout, self.stderr);
        self
    }
}

/// A folder that is gone after the test.
pub struct Folder {
    inner: TempDir,
}

impl Folder {
    pub fn new() -> Self {
        Self { inner: TempDir::new().unwrap() }
    }

    /// A folder with the text in `scene.toml`.
    pub fn with(scene: &str) -> Self {
        let folder = Self::new();
        folder.write("scene.toml", scene);
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.inner.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        let path = self.path(name);
        std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// A command in this folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_viscotack"));
        command.current_dir(self.inner.path()).args(arguments);
        command
    }

    /// Runs the program in this folder.
    pub fn call(&self, arguments: &[&str]) -> Answer {
        answer(&mut self.command(arguments))
    }

    /// Every file below a folder with its bytes, by name.
    pub fn files(&self, name: &str) -> BTreeMap<String, Vec<u8>> {
        files_of(&self.path(name))
    }
}

pub fn answer(command: &mut Command) -> Answer {
    let output = command.output().unwrap();
    Answer {
        code: output.status.code().expect("an exit code, not a signal"),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

fn files_of(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    std::fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap()))
        .collect()
}

/// What is put into a long scene, so that a test of it takes seconds: fewer cycles of the same kind.
pub fn shortened(path: &Path) -> &'static [&'static str] {
    match path.file_stem().and_then(|stem| stem.to_str()) {
        Some("cyclic_pull") => &["history.1.oscillation.cycles=60"],
        Some("million_steps") => &["history.0.oscillation.cycles=20"],
        Some("frequency_sweep") => &["history.0.oscillation.duration=120", "history.0.oscillation.to_frequency=0.1147"],
        Some("vibrated_retraction") => &["history.0.oscillation.duration=100", "history.0.oscillation.to=4.7e-5", "sweep.values=[0.0557]"],
        Some("pull_off_at_five_ranges") => &["sweep.0.values=[1e-3, 5e-3]", "sweep.1.points=3"],
        Some("periodic_contact") => &["sweep.points=2"],
        Some("finite_range" | "edge") => &["sweep.points=2"],
        Some("dynamic_stiffness") => &["sweep.points=3", "sweep.to=10"],
        _ => &[],
    }
}

/// Every shipped scene that `run` takes, the templates among them; files with materials only are none, and scenes with [fit] have their own tests.
pub fn shipped_scenes() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("scenes")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                if path.file_name().is_none_or(|name| name != "materials" && name != "fits") {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|extension| extension == "toml") {
                found.push(path);
            }
        }
    }
    found.sort();
    assert!(found.len() >= 2, "no scenes found");
    found
}
