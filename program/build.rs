//! Hands the commit that is being built, and the compiler, to the program, so that every result can name them.

use std::path::Path;
use std::process::Command;

fn main() {
    let commit = commit().unwrap_or_else(|| "unknown".to_owned());
    println!("cargo:rustc-env=VISCOTACK_COMMIT={commit}");
    let compiler = std::env::var("RUSTC").ok().and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    let compiler = compiler.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_else(|| "unknown compiler".to_owned());
    println!("cargo:rustc-env=VISCOTACK_COMPILER={}", compiler.trim());
    // What is built differs from the commit as soon as a file of these does.
    for watched in ["build.rs", "src", "Cargo.toml", "../src", "../verification/src", "../cli/src", "../Cargo.toml", "../Cargo.lock"] {
        println!("cargo:rerun-if-changed={watched}");
    }
    // Not the index: git itself writes it anew, for this program too, and all would be built again.
    for file in ["HEAD", "logs/HEAD"] {
        if let Some(watched) = git(&["rev-parse", "--git-path", file]).filter(|path| Path::new(path).exists()) {
            println!("cargo:rerun-if-changed={watched}");
        }
    }
}

/// The commit of the repository whose folder this package is: sources that were unpacked inside another repository are not at a commit of that one.
fn commit() -> Option<String> {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR")?;
    let home = std::fs::canonicalize(Path::new(&folder).parent()?).ok()?;
    let top = std::fs::canonicalize(git(&["rev-parse", "--show-toplevel"])?).ok()?;
    if top != home {
        return None;
    }
    git(&["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])
}

fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}
