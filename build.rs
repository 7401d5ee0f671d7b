//! Hands the commit that is being built, and the compiler, to the program, so that every result can name them.

use std::path::Path;
use std::process::Command;

fn main() {
    let commit = commit().unwrap_or_else(|| "unknown".to_owned());
    println!("cargo:rustc-env=VISCOTACK_COMMIT={commit}");
    let compiler = std::env::var("RUSTC").ok().and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    let compiler = compiler.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_else(|| "unknown compiler".to_owned());
    println!("cargo:rustc-env=VISCOTACK_COMPILER={}", compiler.trim());
    stored_runs();
    // What is built differs from the commit as soon as a file of these does.
    for watched in ["build.rs", "src", "Cargo.toml", "Cargo.lock"] {
        println!("cargo:rerun-if-changed={watched}");
    }
    for file in ["HEAD", "index", "logs/HEAD"] {
        if let Some(watched) = git(&["rev-parse", "--git-path", file]).filter(|path| Path::new(path).exists()) {
            println!("cargo:rerun-if-changed={watched}");
        }
    }
}

/// The commit of this package's own repository: sources that were unpacked inside another repository are not at a commit of that one.
fn commit() -> Option<String> {
    let package = std::fs::canonicalize(std::env::var_os("CARGO_MANIFEST_DIR")?).ok()?;
    let top = std::fs::canonicalize(git(&["rev-parse", "--show-toplevel"])?).ok()?;
    if top != package {
        return None;
    }
    git(&["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])
}

fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
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
