//! Source: the command line, `viscotack verify`.
//!
//! Goal: wrong calls end with 2 and write nothing; an existing folder is refused before the work, not after it, and replaced only by force and only if it is
//! a report; a run ends with 0 and leaves one whole folder; without a terminal standard error gets one plain line a section.
//!
//! Parameters: the quickest study. Oracle: exit codes, files. Tolerance: none.
#![allow(clippy::unwrap_used, missing_docs)]

use assert_cmd::Command;
use std::path::Path;

fn verify(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    Command::cargo_bin("viscotack").unwrap().current_dir(folder).arg("verify").args(arguments).assert()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn wrong_calls_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [&["--ful"][..], &["--out"], &["no_such_study"], &["--full=yes"], &["--effort", "full"]] {
        let assert = verify(folder.path(), arguments).code(2);
        assert!(!text(&assert.get_output().stderr).is_empty());
    }
    let assert = verify(folder.path(), &["no_such_study"]).code(2);
    let message = text(&assert.get_output().stderr);
    assert!(message.contains("`no_such_study`") && message.contains("convergence_crack"), "{message}");
    assert!(std::fs::read_dir(folder.path()).unwrap().next().is_none(), "nothing was written");
}

#[test]
fn a_report_is_written_whole_and_an_existing_folder_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let assert = verify(folder.path(), &["convergence_crack", "--out", "report"]).code(0);
    let out = text(&assert.get_output().stdout);
    assert!(out.contains("verify (reduced):") && out.contains("0 failed") && out.contains("wrote report"), "{out}");
    // No terminal here: a line that a log can hold, and nothing else.
    let log = text(&assert.get_output().stderr);
    assert_eq!(log.lines().filter(|line| line.starts_with("section convergence_crack: ") && line.ends_with(" s")).count(), 1, "{log}");
    assert!(log.lines().all(|line| line.starts_with("section ") || line.contains(" parts after ")), "{log}");
    assert!(log.ends_with('\n') && log.chars().all(|letter| letter == '\n' || !letter.is_control()), "{log:?}");
    let report = folder.path().join("report");
    for name in ["report.html", "summary.json", "checks.csv", "convergence_crack_lines.csv", "convergence_crack_lines_plot.csv"] {
        assert!(report.join(name).is_file(), "{name}");
    }
    assert!(std::fs::read_dir(folder.path()).unwrap().count() == 1, "nothing half-written beside it");
    // Refused at once, and untouched.
    let before = std::fs::metadata(report.join("report.html")).unwrap().modified().unwrap();
    let message = text(&verify(folder.path(), &["convergence_crack", "--out", "report"]).code(2).get_output().stderr);
    assert!(message.contains("exists already"), "{message}");
    assert!(std::fs::metadata(report.join("report.html")).unwrap().modified().unwrap() == before);
    verify(folder.path(), &["convergence_crack", "--out", "report", "--force"]).code(0);
    assert!(std::fs::metadata(report.join("report.html")).unwrap().modified().unwrap() > before);
    // Other work is not replaced, force or not.
    let other = folder.path().join("other");
    std::fs::create_dir(&other).unwrap();
    std::fs::write(other.join("thesis.txt"), "years of work").unwrap();
    let message = text(&verify(folder.path(), &["convergence_crack", "--out", "other", "--force"]).code(2).get_output().stderr);
    assert!(message.contains("not replaced"), "{message}");
    assert!(other.join("thesis.txt").is_file());
}

/// The pieces that the file of a run holds.
fn pieces(file: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(file).unwrap_or_default();
    let piece = |line: &str| Some(line.split_once(" [")?.1.split_once(",{")?.0.to_owned());
    text.lines().skip(1).filter_map(piece).collect()
}

#[test]
fn a_killed_full_run_goes_on_behind_its_finished_pieces() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("report.partial/pieces.txt");
    let mut finished = Vec::new();
    for _ in 0..2 {
        let mut run = std::process::Command::new(assert_cmd::cargo::cargo_bin("viscotack"))
            .current_dir(folder.path())
            .args(["verify", "--full", "--shard", "1/3", "--out", "report", "random_lines"])
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        for _ in 0..600 {
            if pieces(&file).len() >= finished.len() + 3 {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(100));
        }
        run.kill().unwrap();
        run.wait().unwrap();
        let now = pieces(&file);
        assert!(now.len() >= finished.len() + 3, "{now:?} after {finished:?}");
        assert_eq!(now[..finished.len()], finished);
        finished = now;
    }
    let mut different = finished.clone();
    different.sort();
    different.dedup();
    assert_eq!(different.len(), finished.len(), "a piece was computed twice");
    let of_the_shard = |piece: &String| piece.rsplit_once(',').is_some_and(|(_, number)| number.parse::<u64>().unwrap() % 3 == 1);
    assert!(finished.iter().all(of_the_shard), "{finished:?}");
    let message = text(&verify(folder.path(), &["convergence_crack", "--full", "--shard", "1/3"]).code(2).get_output().stderr);
    assert!(message.contains("convergence_crack") && message.contains("random_lines"), "{message}");
    // A folder of somebody else's is not used.
    let other = folder.path().join("other.partial");
    std::fs::create_dir(&other).unwrap();
    std::fs::write(other.join("thesis.txt"), "years of work").unwrap();
    let message = text(&verify(folder.path(), &["random_lines", "--full", "--out", "other"]).code(2).get_output().stderr);
    assert!(message.contains("other.partial"), "{message}");
    assert!(other.join("thesis.txt").is_file());
}
