//! Hands the commit that is being built, and the compiler, to the program, so that every result can name them.

use std::process::Command;

fn main() {
    let commit = Command::new("git")
        .args(["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])
        .output()
        .ok()
        .filter(|output| output.status.success())
        .and_then(|output| String::from_utf8(output.stdout).ok())
        .map_or_else(|| "unknown".to_owned(), |text| text.trim().to_owned());
    println!("cargo:rustc-env=VISCOTACK_COMMIT={commit}");
    let compiler = std::env::var("RUSTC").ok().and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    let compiler = compiler.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_else(|| "unknown compiler".to_owned());
    println!("cargo:rustc-env=VISCOTACK_COMPILER={}", compiler.trim());
    stored_runs();
    for watched in [".git/HEAD", ".git/index", ".git/logs/HEAD"] {
        if std::path::Path::new(watched).exists() {
            println!("cargo:rerun-if-changed={watched}");
        }
    }
    println!("cargo:rerun-if-changed=build.rs");
}

/// The stored runs of other programs in one text, whoever added a file of them: `verification/peers/work_precision*.csv`, one below the other.
fn stored_runs() {
    const FOLDER: &str = "verification/peers";
    println!("cargo:rerun-if-changed={FOLDER}");
    let mut files: Vec<_> = std::fs::read_dir(FOLDER)
        .map(|entries| entries.filter_map(Result::ok).map(|entry| entry.path()).collect::<Vec<_>>())
        .unwrap_or_default();
    files.retain(|path| {
        path.file_name().and_then(|name| name.to_str()).is_some_and(|name| name.starts_with("work_precision") && name.ends_with(".csv"))
    });
    files.sort();
    let text: String = files.iter().filter_map(|path| std::fs::read_to_string(path).ok()).collect();
    if let Ok(folder) = std::env::var("OUT_DIR") {
        let written = std::fs::write(std::path::Path::new(&folder).join("work_precision.csv"), text);
        // Without the file the build stops where it is read.
        drop(written);
    }
}
