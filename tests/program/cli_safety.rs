//! Nothing of the user's is lost, and nothing that is given commands the terminal or keeps the program waiting.
//!
//! Contract: `program/src/outcome/owned.rs` (folders with a mark), `program/src/outcome/journal.rs` (digests), `program/src/regular_file.rs`,
//! `program/src/terminal_text.rs`, `program/src/threads.rs`.
//! Goal: files that the program has not written stay; flipped bits, foreign builds, full disks, refused threads, pipes and devices, Ctrl-C, escape sequences.
//! Parameters: the faults themselves, made as they happen: bits flipped in files, a small tmpfs, a limit of the size of files, stacks too large to be
//! given, FIFOs, signals.
//! Oracle: the bytes before, or those of an undisturbed run; exit codes; paths in messages. Tolerance: none.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Answer, DELAYED, Folder, GOOD, answer};
use std::cell::RefCell;
use std::fs;
use std::io::Read;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use viscotack::PlaneMaterial;
use viscotack::crack::delayed::{FinishedRuns, GrowthProblem, GrowthWatch, LoadHistory, Resolution, Trajectory, Unwatched, refined_from};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::material::CreepTerm;
use viscotack_program::outcome::Row;
use viscotack_program::outcome::journal::{Found, Journal, JournalHeader, each, read};
use viscotack_program::outcome::shard::Shard;
use viscotack_program::scene::template::template;
use viscotack_program::terminal_text::is_harmful;

const PROGRAM: &str = env!("CARGO_BIN_EXE_viscotack");

/// The good scene with that many states.
fn long_scene(states: u32) -> String {
    GOOD.replace("points = 3", &format!("points = {states}")).replace("points = 5", "points = 60")
}

/// Runs a command that must end within seconds.
fn within_seconds(command: &mut Command) -> Answer {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).stdin(Stdio::null()).spawn().unwrap();
    let (mut out, mut err) = (child.stdout.take().unwrap(), child.stderr.take().unwrap());
    let reader = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        out.read_to_end(&mut bytes).unwrap();
        bytes
    });
    let errors = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        err.read_to_end(&mut bytes).unwrap();
        bytes
    });
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if begun.elapsed() > Duration::from_secs(30) {
            child.kill().unwrap();
            panic!("it does not end: {command:?}");
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Answer { code: status.code().expect("an exit code"), stdout: text(reader.join().unwrap()), stderr: text(errors.join().unwrap()) }
}

fn program(folder: &Folder, arguments: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command.current_dir(folder.path(".")).args(arguments);
    command
}

fn lines(path: &Path) -> usize {
    fs::read(path).map_or(0, |bytes| bytes.iter().filter(|&&byte| byte == b'\n').count())
}

/// A run under way, with some states in its journal.
fn under_way(folder: &Folder, arguments: &[&str]) -> Child {
    let child = program(folder, arguments).env("RAYON_NUM_THREADS", "1").stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let begun = Instant::now();
    while lines(&folder.path("DIR.partial/journal.jsonl")) < 4 {
        assert!(begun.elapsed() < Duration::from_secs(60), "no line was journalled");
        std::thread::sleep(Duration::from_millis(1));
    }
    child
}

fn ended(child: Child) -> Answer {
    let output = child.wait_with_output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    Answer { code: output.status.code().unwrap_or(-1), stdout: text(&output.stdout), stderr: text(&output.stderr) }
}

// --- (a) Files that the program has not written.

#[test]
fn force_deletes_nothing_that_the_program_has_not_written() {
    let folder = Folder::with(GOOD);
    let run = |target: &str| folder.call(&["run", "scene.toml", "--out", target, "--force"]);
    // Other programs write a summary.json, too.
    fs::create_dir(folder.path("other")).unwrap();
    folder.write("other/summary.json", "{\"years\": \"of work\"}");
    let message = run("other").ended(2).stderr;
    assert!(message.contains("`other` is not replaced: it holds `summary.json`"), "{message}");
    assert_eq!(folder.read("other/summary.json"), "{\"years\": \"of work\"}");
    // A result with something put into it, altered, or with a folder in it.
    type Spoil = fn(&Folder);
    let spoils: [(&str, Spoil, &str); 5] = [
        ("a note", |folder| folder.write("DIR/notes.txt", "mine"), "`notes.txt`"),
        ("an altered table", |folder| folder.write("DIR/states.csv", "corrected by hand"), "`states.csv` in it was altered"),
        ("a folder", |folder| fs::create_dir(folder.path("DIR/figures")).unwrap(), "`figures`"),
        ("a link", |folder| symlink("/etc/hostname", folder.path("DIR/link")).unwrap(), "`link`"),
        ("an altered mark", |folder| folder.write("DIR/.viscotack", "viscotack folder 1\nkind run\n"), "was altered"),
    ];
    for (kind, spoil, says) in spoils {
        run("DIR").ended(0);
        run("DIR").ended(0);
        spoil(&folder);
        let names = |folder: &Folder| {
            let mut names: Vec<_> = fs::read_dir(folder.path("DIR")).unwrap().map(|entry| entry.unwrap().path()).collect();
            names.sort();
            names.into_iter().map(|path| (fs::read(&path).ok(), path)).collect::<Vec<_>>()
        };
        let before = names(&folder);
        let answer = run("DIR").ended(2);
        assert!(answer.stderr.contains(says) && answer.stderr.contains("not replaced"), "{kind}: {}", answer.stderr);
        assert!(answer.stdout.is_empty() && names(&folder) == before, "{kind}");
        assert!(!folder.path("DIR.partial").exists(), "{kind}");
        fs::remove_dir_all(folder.path("DIR")).unwrap();
    }
    // A file that is missing from a result is no loss.
    run("DIR").ended(0);
    fs::remove_file(folder.path("DIR/states.csv")).unwrap();
    run("DIR").ended(0);
    // Links to folders are left alone, with the stroke of a shell too, and links to nothing.
    symlink(folder.path("DIR"), folder.path("link")).unwrap();
    symlink(folder.path("nowhere"), folder.path("dangling")).unwrap();
    for link in ["link", "link/", "dangling"] {
        let message = run(link).ended(2).stderr;
        assert!(message.contains("it is a symbolic link"), "{link}: {message}");
    }
    assert!(folder.path("DIR/states.csv").is_file());
    // `material` and `verify` share the rule.
    folder.write(
        "material.toml",
        GOOD.split("[adhesion]").next().unwrap().split_once("[material]").map(|(_, rest)| format!("[material]{rest}")).unwrap(),
    );
    folder.call(&["material", "material.toml", "--out", "other", "--force"]).ended(2);
    folder.call(&["material", "material.toml", "--out", "MAT"]).ended(0);
    folder.write("MAT/mine.txt", "mine");
    folder.call(&["material", "material.toml", "--out", "MAT", "--force"]).ended(2);
    fs::remove_file(folder.path("MAT/mine.txt")).unwrap();
    folder.call(&["material", "material.toml", "--out", "MAT", "--force"]).ended(0);
    // So do figures: a folder of somebody else's that happens to hold the same names.
    fs::create_dir_all(folder.path("pictures/.computed")).unwrap();
    folder.write("pictures/index.html", "my page");
    let answer = folder.call(&["figures", "1.2", "--out", "pictures"]).ended(2);
    assert!(answer.stderr.contains("`pictures` is not replaced"), "{}", answer.stderr);
    assert_eq!(folder.read("pictures/index.html"), "my page");
}

#[test]
fn a_partial_folder_of_the_users_is_refused_and_left_alone() {
    for force in [&[][..], &["--force"]] {
        let folder = Folder::with(GOOD);
        fs::create_dir(folder.path("DIR.partial")).unwrap();
        folder.write("DIR.partial/journal.jsonl", "my own journal\n");
        folder.write("DIR.partial/draft.tex", "draft");
        let before = folder.files("DIR.partial");
        let answer = folder.call(&[&["run", "scene.toml", "--out", "DIR"], force].concat()).ended(2);
        assert!(answer.stderr.contains("`DIR.partial`") && answer.stderr.contains("`draft.tex`"), "{}", answer.stderr);
        assert!(folder.files("DIR.partial") == before && !folder.path("DIR").exists());
    }
}

#[test]
fn files_put_beside_a_journal_are_not_swept_into_the_result() {
    let folder = Folder::with(&long_scene(2_000));
    let child = under_way(&folder, &["run", "scene.toml", "--out", "DIR"]);
    folder.write("DIR.partial/notes.txt", "mine");
    assert_eq!(ended(child).code, 0);
    assert!(folder.path("DIR/states.csv").is_file() && !folder.path("DIR/notes.txt").exists());
    assert_eq!(folder.files("DIR.partial").keys().collect::<Vec<_>>(), ["notes.txt"]);
}

// --- (b) Bits that flip, and other builds.

fn rows(states: usize) -> Vec<Vec<Row>> {
    (0..states).map(|state| vec![Row::new(state, &[0.1 * state as f64], vec!["a".into()], 2)]).collect()
}

#[test]
fn every_flipped_bit_of_a_journal_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.jsonl");
    let header = JournalHeader { program: "viscotack test".into(), scene: "00".into(), states: 4, shard: Shard::WHOLE };
    let whole = rows(3);
    let mut journal = Journal::open(&path, &header, 0).unwrap();
    journal.append(&whole[..1]).unwrap();
    drop(journal);
    let mut journal = Journal::open(&path, &header, 1).unwrap();
    journal.append(&whole[1..]).unwrap();
    let kept = |found: Found| match found {
        Found::States(states) => {
            let mut rows = Vec::new();
            let visited = each(&path, Ok, |states| {
                rows.append(states);
                Ok(())
            });
            // Where a line is altered both stop before it.
            assert!(rows.len() == states && visited.is_ok() == (states == 3), "{states}: {visited:?}");
            rows
        }
        Found::Nothing => Vec::new(),
        Found::Other(other) => panic!("another run's: {other:?}"),
    };
    assert_eq!(kept(read(&path, &header).unwrap()), whole);
    let bytes = fs::read(&path).unwrap();
    for bit in 0..8 * bytes.len() {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        fs::write(&path, &flipped).unwrap();
        let line = bytes[..bit / 8].iter().filter(|&&byte| byte == b'\n').count();
        let found = kept(read(&path, &header).unwrap());
        // The lines before it are kept, and none from it on.
        assert_eq!(found, whole[..line.saturating_sub(1)], "bit {bit}");
    }
}

#[test]
fn a_journal_with_a_flipped_bit_leads_to_the_same_results() {
    let scene = long_scene(300);
    let whole = Folder::with(&scene);
    whole.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let folder = Folder::with(&scene);
    let mut child = under_way(&folder, &["run", "scene.toml", "--out", "DIR"]);
    child.kill().unwrap();
    child.wait().unwrap();
    let Ok(journal) = fs::read(folder.path("DIR.partial/journal.jsonl")) else {
        panic!("it ended too soon for this test to mean anything")
    };
    let mark = fs::read(folder.path("DIR.partial/.viscotack")).unwrap();
    for case in 0..12 {
        let place = (journal.len() / 12) * case + 37;
        let mut flipped = journal.clone();
        flipped[place] ^= 1 << (case % 8);
        fs::create_dir_all(folder.path("DIR.partial")).unwrap();
        folder.write("DIR.partial/.viscotack", &mark);
        folder.write("DIR.partial/journal.jsonl", flipped);
        folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
        assert!(folder.files("DIR") == whole.files("DIR"), "byte {place}");
        fs::remove_dir_all(folder.path("DIR")).unwrap();
    }
}

#[test]
fn another_build_of_the_same_commit_does_not_go_on() {
    let folder = Folder::with(&long_scene(2_000));
    let mut child = under_way(&folder, &["run", "scene.toml", "--out", "DIR"]);
    child.kill().unwrap();
    child.wait().unwrap();
    // What follows the end of a program file is not run: same version, same commit, another file.
    let other = folder.path("viscotack-other");
    fs::copy(PROGRAM, &other).unwrap();
    let mut bytes = fs::OpenOptions::new().append(true).open(&other).unwrap();
    std::io::Write::write_all(&mut bytes, b"another build").unwrap();
    drop(bytes);
    let before = folder.files("DIR.partial");
    let answer = within_seconds(Command::new(&other).current_dir(folder.path(".")).args(["run", "scene.toml", "--out", "DIR"]));
    assert!(answer.code == 2 && answer.stderr.contains("another scene or build"), "{}", answer.stderr);
    assert!(folder.files("DIR.partial") == before);
    // The first build does.
    let answer = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    assert!(answer.stderr.contains("resuming"), "{}", answer.stderr);
}

/// The build script, in a folder that lies inside another repository and in one that is a repository of its own.
#[test]
fn a_tarball_inside_another_repository_reports_no_commit() {
    let folder = Folder::new();
    let script = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("program/build.rs");
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let compiled = Command::new(compiler).args(["--edition", "2024", "-o"]).arg(folder.path("script")).arg(script).status().unwrap();
    assert!(compiled.success());
    let git = |arguments: &[&str]| {
        let user = ["-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main"];
        assert!(Command::new("git").current_dir(folder.path("outer")).args(user).args(arguments).output().unwrap().status.success());
    };
    fs::create_dir_all(folder.path("outer/viscotack-0.1.0/program")).unwrap();
    fs::create_dir_all(folder.path("outer/program")).unwrap();
    git(&["init"]);
    git(&["commit", "--allow-empty", "-m", "of another project"]);
    let commit = |place: &str| {
        let path = folder.path(place).join("program");
        let output = Command::new(folder.path("script"))
            .current_dir(&path)
            .env("CARGO_MANIFEST_DIR", &path)
            .env("OUT_DIR", folder.path("."))
            .output()
            .unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        text.lines().find_map(|line| line.strip_prefix("cargo:rustc-env=VISCOTACK_COMMIT=")).unwrap().to_owned()
    };
    assert_eq!(commit("outer/viscotack-0.1.0"), "unknown");
    let own = commit("outer");
    assert!(own.len() == 12 && own.chars().all(|digit| digit.is_ascii_hexdigit()), "{own}");
}

// --- (c) Folders that are gone, disks that are full, threads that are refused.

#[test]
fn results_are_given_even_if_the_folder_is_gone() {
    let folder = Folder::with(&long_scene(2_000));
    let child = under_way(&folder, &["run", "scene.toml", "--out", "DIR"]);
    fs::remove_dir_all(folder.path("DIR.partial")).unwrap();
    let answer = ended(child);
    assert_eq!(answer.code, 0, "{}", answer.stderr);
    assert!(answer.stdout.contains("A scene for tests") && folder.path("DIR/states.csv").is_file());
    fs::remove_dir_all(folder.path("DIR")).unwrap();
    // A file in its place cannot be replaced by a folder: the results are on the screen, and the path is named.
    let child = under_way(&folder, &["run", "scene.toml", "--out", "DIR"]);
    fs::remove_dir_all(folder.path("DIR.partial")).unwrap();
    folder.write("DIR.partial", "a file now");
    let answer = ended(child);
    assert_eq!(answer.code, 5, "{}", answer.stderr);
    assert!(answer.stdout.contains("A scene for tests") && answer.stdout.contains("validity"), "{}", answer.stdout);
    assert!(answer.stderr.contains("DIR.partial") && folder.read("DIR.partial") == "a file now", "{}", answer.stderr);
}

/// What a full disk must give: exit code 5, the path, no panic; and later the same command goes on.
fn machine_fault(answer: &Answer, path: &str) {
    assert_eq!(answer.code, 5, "{}\n{}", answer.stdout, answer.stderr);
    assert!(
        answer.stderr.contains(path) && answer.stderr.contains("cannot be written") && !answer.stderr.contains("panicked"),
        "{}",
        answer.stderr
    );
}

#[test]
fn a_full_disk_is_a_machine_fault_that_names_the_path() {
    let folder = Folder::with(&long_scene(2_000));
    // A limit of the size of files, in blocks of 512 or 1024 bytes.
    let limited = |blocks: u32, more: &str| {
        let line = format!("ulimit -f {blocks}; exec '{PROGRAM}' run scene.toml --out DIR {more}");
        within_seconds(Command::new("sh").current_dir(folder.path(".")).args(["-c", &line]))
    };
    machine_fault(&limited(64, ""), "DIR.partial/journal.jsonl");
    let kept = lines(&folder.path("DIR.partial/journal.jsonl"));
    assert!(kept > 2, "{kept}");
    machine_fault(&limited(0, ""), "DIR.partial");
    let answer = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    assert!(answer.stderr.contains("resuming"), "{}", answer.stderr);
    let whole = Folder::with(&long_scene(2_000));
    whole.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    assert!(whole.files("DIR") == folder.files("DIR"));
    // A small disk of its own, where that is allowed.
    fs::create_dir(folder.path("disk")).unwrap();
    let script = format!("mount -t tmpfs -o size=96k none disk || exit 77; '{PROGRAM}' run scene.toml --out disk/DIR");
    let answer = within_seconds(Command::new("unshare").current_dir(folder.path(".")).args(["-rm", "sh", "-c", &script]));
    if answer.code == 77 || answer.stderr.contains("unshare") {
        println!("no tmpfs here: {}", answer.stderr);
    } else {
        machine_fault(&answer, "disk/DIR.partial");
    }
}

#[test]
fn a_full_screen_is_no_panic_and_loses_no_file() {
    let Ok(_) = fs::metadata("/dev/full") else { return };
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let folder = Folder::with(&long_scene(2_000));
    // Standard error is full while there is something to say: that a run is resumed.
    let mut child = under_way(&folder, &["run", "scene.toml", "--out", "DIR"]);
    child.kill().unwrap();
    child.wait().unwrap();
    let status = program(&folder, &["run", "scene.toml", "--out", "DIR"]).stdout(Stdio::null()).stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(0));
    for (arguments, code) in [
        (&["run", "scene.toml", "--out", "NEW"][..], 5),
        (&["run", "scene.toml", "--json"], 5),
        (&["explain", "scene.toml"], 5),
        (&["units"], 5),
        (&["schema"], 5),
        (&["--help"], 5),
        (&["run", "none.toml"], 2),
        (&["runn"], 2),
    ] {
        let status = program(&folder, arguments).stdout(full()).stderr(full()).status().unwrap();
        assert_eq!(status.code(), Some(code), "{arguments:?}");
    }
    assert!(folder.path("NEW/states.csv").is_file());
}

#[test]
fn refused_threads_are_done_without() {
    let folder = Folder::with(&long_scene(40));
    let usual = folder.call(&["run", "scene.toml", "--json"]).ended(0).stdout;
    // No machine gives a stack of that size: every thread is refused.
    let alone = |arguments: &[&str]| within_seconds(program(&folder, arguments).env("RUST_MIN_STACK", "1000000000000000"));
    let answer = alone(&["run", "scene.toml", "--json"]);
    assert_eq!((answer.code, answer.stderr.as_str()), (0, ""));
    assert!(answer.stdout == usual);
    let answer = alone(&["run", "scene.toml", "--out", "DIR"]);
    assert_eq!((answer.code, answer.stderr.as_str()), (0, ""));
    let answer = alone(&["figures", "1.2", "--out", "FIGURES"]);
    assert_eq!((answer.code, answer.stderr.as_str()), (0, ""));
    // A limit of processes, where it binds: not for the administrator.
    let script = format!("ulimit -u 1 2>/dev/null; exec '{PROGRAM}' run scene.toml --json");
    let answer = within_seconds(Command::new("sh").current_dir(folder.path(".")).args(["-c", &script]));
    assert!(answer.code == 0 && answer.stdout == usual, "{}", answer.stderr);
}

// --- (d) Pipes, devices, endless files.

#[test]
fn only_regular_files_of_a_sensible_size_are_read() {
    let folder = Folder::with(GOOD);
    assert!(Command::new("mkfifo").arg(folder.path("pipe")).status().unwrap().success());
    fs::File::create(folder.path("huge")).unwrap().set_len(1 << 40).unwrap();
    for name in ["pipe.csv", "pipe.toml", "pipe.inp"] {
        symlink(folder.path("pipe"), folder.path(name)).unwrap();
    }
    symlink("/dev/zero", folder.path("zero.csv")).unwrap();
    folder.write("delayed.toml", DELAYED);
    folder.write("sphere.toml", template("indentation").unwrap().text);
    fs::create_dir(folder.path("folder")).unwrap();
    let refused = |arguments: &[&str], says: &str| {
        let answer = within_seconds(&mut program(&folder, arguments));
        assert!(answer.code == 2 && answer.stderr.contains(says), "{arguments:?}: {}", answer.stderr);
    };
    let kinds = [("pipe", "a pipe or a device"), ("/dev/zero", "a pipe or a device"), ("huge", "MiB"), ("folder", "a folder")];
    for (name, says) in kinds {
        refused(&["run", name], says);
        refused(&["explain", name], says);
        refused(&["cite", name], says);
        refused(&["figures", "--manifest", name], says);
        refused(&["material", name], says);
        for key in ["file", "data", "abaqus", "ansys", "ls_dyna", "comsol", "moose"] {
            let set = format!("material={{ {key} = \"{name}\" }}");
            refused(&["run", "scene.toml", "--set", &set], says);
        }
        refused(&["run", "scene.toml", "--set", &format!("material.shift={{ table = \"{name}\" }}")], says);
        refused(&["run", "delayed.toml", "--set", &format!("history=[{{ table = \"{name}\" }}]")], says);
        refused(&["run", "scene.toml", "--set", &format!("adhesion.by_speed={{ file = \"{name}\" }}")], says);
        let set = format!("indentation={{ profile = \"{name}\" }}");
        refused(&["run", "sphere.toml", "--set", &set], says);
    }
    refused(&["material", "pipe.csv"], "a pipe or a device");
    refused(&["material", "zero.csv"], "a pipe or a device");
    refused(&["material", "pipe.inp"], "a pipe or a device");
    // A link to a regular file is one.
    symlink(folder.path("scene.toml"), folder.path("link.toml")).unwrap();
    within_seconds(&mut program(&folder, &["explain", "link.toml"])).ended(0);
    // A pipe where the program keeps its own: the mark, the journal.
    for (partial, own) in [(".viscotack", true), ("journal.jsonl", false)] {
        let folder = Folder::with(GOOD);
        fs::create_dir(folder.path("DIR.partial")).unwrap();
        assert!(Command::new("mkfifo").arg(folder.path("DIR.partial").join(partial)).status().unwrap().success());
        let answer = within_seconds(&mut program(&folder, &["run", "scene.toml", "--out", "DIR"]));
        assert!(answer.code == 2 && answer.stderr.contains("DIR.partial"), "{partial} {own}: {}", answer.stderr);
    }
}

// --- (e) Characters that command a terminal; lines of other files.

/// Commands of terminals, a bell, C1 controls, marks of direction, characters without width.
const HARMFUL: &str = "\u{1b}[31m\u{7}\u{9b}2J\u{202e}evil\u{2066}\u{200f}\u{61c}\u{feff}\u{7f}";

fn harmless(answer: &Answer, what: &str) {
    for text in [&answer.stdout, &answer.stderr] {
        assert!(text.chars().all(|character| matches!(character, '\n' | '\t') || !is_harmful(character)), "{what}: {text:?}");
    }
    assert!(!answer.stdout.is_empty() || !answer.stderr.is_empty(), "{what}");
}

#[test]
fn no_character_of_the_users_commands_the_terminal() {
    let folder = Folder::with(GOOD);
    let escaped: String = HARMFUL.chars().map(|character| format!("\\u{:04X}", u32::from(character))).collect();
    let name = format!("s{HARMFUL}.toml");
    folder.write(&name, GOOD.replace("A scene for tests", &escaped));
    let broken = format!("b{HARMFUL}.toml");
    folder.write(&broken, GOOD.replace("\"1 MPa\"", &format!("\"1 {escaped}\"")));
    folder.write(
        "comment.toml",
        GOOD.replace("[adhesion]", &format!("[adhesion] # {}\nwrong key\n", HARMFUL.replace(|c: char| c.is_control(), ""))),
    );
    let out = format!("o{HARMFUL}");
    let none = format!("none{HARMFUL}");
    let key = format!("crack.{HARMFUL}=1");
    let value = format!("crack.speed=1 {HARMFUL}");
    let data = format!("material.data={HARMFUL}.csv");
    for arguments in [
        &["run", &name][..],
        &["run", &name, "--json"],
        &["run", &name, "--out", &out],
        &["run", &name, "--out", &out],
        &["explain", &name],
        &["explain", &name, "--json"],
        &["cite", &name],
        &["run", &broken],
        &["run", "comment.toml"],
        &["run", &none],
        &["run", "scene.toml", "--set", &key],
        &["run", "scene.toml", "--set", &value],
        &["run", "scene.toml", "--set", HARMFUL],
        &["run", "scene.toml", "--set", &data],
        &[HARMFUL],
        &["run", "scene.toml", HARMFUL],
        &["new", HARMFUL],
        &["new", "crack", "--out", &name],
        &["verify", HARMFUL],
        &["figures", HARMFUL],
        &["figures", "--manifest", &none],
        &["material", &name],
        &["material", &none],
        &["completions", HARMFUL],
    ] {
        harmless(&answer(&mut folder.command(arguments)), &format!("{arguments:?}"));
    }
    // The text is the same to a reader of JSON.
    let json = folder.call(&["run", &name, "--json"]).ended(0).json();
    assert!(json["title"].as_str().unwrap().contains("evil"));
}

#[test]
fn a_code_frame_shows_little_of_a_line_and_nothing_of_other_files() {
    let folder = Folder::with(GOOD);
    folder.write("secret", "root:x:0:0:SECRET:/root:/bin/sh\nalice:x:1000:1000:SECRET::/bin/sh\n");
    folder.write("key.pem", "-----BEGIN PRIVATE KEY-----\nSECRETb3BlbnNzaC1rZXk\n-----END PRIVATE KEY-----\n");
    folder.write("binary", b"SECRET\x01\x02 = [3\n");
    folder.write("long.toml", GOOD.replace("[adhesion]", &format!("[adhesion]\nwork_of_adhesive = \"{}\"", "x".repeat(5000))));
    let long = folder.call(&["run", "long.toml"]).ended(2);
    let frame: Vec<&str> = long.stderr.lines().filter(|line| line.contains('│')).collect();
    assert!(frame.len() > 2 && frame.iter().all(|line| line.chars().count() <= 180), "{}", long.stderr);
    for name in ["secret", "key.pem", "binary"] {
        let direct = folder.call(&["run", name]).ended(2);
        assert!(!direct.stderr.contains("SECRET") && direct.stderr.contains(&format!("{name}:")), "{}", direct.stderr);
        for key in ["file", "data", "abaqus", "ansys", "ls_dyna", "comsol", "moose"] {
            let answer = folder.call(&["run", "scene.toml", "--set", &format!("material={{ {key} = \"{name}\" }}")]);
            assert!(answer.code == 2 && !answer.stderr.contains("SECRET"), "{key} {name}: {}", answer.stderr);
        }
        let answer = folder.call(&["figures", "--manifest", name]);
        assert!(answer.code == 2 && !answer.stderr.contains("SECRET"), "{}", answer.stderr);
    }
}

// --- (f) Ctrl-C.

#[test]
fn an_interrupted_run_says_how_it_goes_on() {
    let scene = long_scene(3_000);
    let whole = Folder::with(&scene);
    whole.call(&["run", "scene.toml", "--set", "title=It's a test", "--out", "DIR"]).ended(0);
    let folder = Folder::with(&scene);
    let child = under_way(&folder, &["run", "scene.toml", "--set", "title=It's a test", "--out", "DIR"]);
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(std::os::unix::process::ExitStatusExt::signal(&output.status), Some(2), "it ends as the signal wants");
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.contains("interrupted: ") && stderr.contains("of 3000 states") && stderr.contains("`DIR.partial`"), "{stderr}");
    // The command that is offered does go on.
    let command = stderr.lines().find(|line| line.contains(" run ")).unwrap().trim().to_owned();
    let resumed = within_seconds(Command::new("sh").current_dir(folder.path(".")).args(["-c", &command]));
    assert!(resumed.code == 0 && resumed.stderr.contains("resuming"), "{command}: {}", resumed.stderr);
    assert!(folder.files("DIR") == whole.files("DIR"));
    // Without a folder there is nothing to go on from.
    let child = program(&folder, &["run", "scene.toml", "--set", "sweep.points=60000"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(300));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let stderr = String::from_utf8(child.wait_with_output().unwrap().stderr).unwrap();
    assert!(stderr.contains("nothing is kept") && stderr.contains("--out DIR"), "{stderr}");
}

// --- (g) A scene on standard input.

#[test]
fn a_scene_is_read_from_standard_input() {
    let folder = Folder::with(GOOD);
    let given = |arguments: &[&str], input: &[u8]| answer(folder.command(arguments).write_stdin(input));
    for command in [&["run"][..], &["explain"], &["cite"]] {
        let by_name = folder.call(&[command, &["scene.toml"]].concat()).ended(0).stdout;
        assert_eq!(given(&[command, &["-"]].concat(), GOOD.as_bytes()).ended(0).stdout, by_name);
    }
    // The same run: the same folder, and the same hash.
    folder.call(&["run", "scene.toml", "--out", "NAMED"]).ended(0);
    given(&["run", "-", "--out", "GIVEN"], GOOD.as_bytes()).ended(0);
    assert!(folder.files("NAMED") == folder.files("GIVEN"));
    // Files in it are found from the working folder.
    let material = GOOD.split("[adhesion]").next().unwrap().split_once("[material]").unwrap().1.to_owned();
    folder.write("rubber.toml", format!("[material]{material}"));
    let rest = GOOD.split_once("[adhesion]").unwrap().1;
    let scene = format!("title = \"A scene for tests\"\n[material]\nfile = \"rubber.toml\"\n[adhesion]{rest}");
    given(&["run", "-"], scene.as_bytes()).ended(0);
    // Errors name it, with the line.
    let wrong = given(&["run", "-"], GOOD.replace("[crack]", "[crak]").as_bytes()).ended(2);
    assert!(
        wrong.stderr.contains("standard input:") && wrong.stderr.contains("[crack]") || wrong.stderr.contains("crack"),
        "{}",
        wrong.stderr
    );
    assert!(given(&["run", "-"], b"").ended(2).stderr.contains("standard input:1:1"));
    assert!(given(&["run", "-"], b"\xff\xfe\xfd").ended(2).stderr.contains("not UTF-8"));
    // Input without an end.
    let zeros = fs::File::open("/dev/zero").unwrap();
    let output = program(&folder, &["run", "-"]).stdin(zeros).output().unwrap();
    assert!(output.status.code() == Some(2) && String::from_utf8(output.stderr).unwrap().contains("more than 16 MiB"));
}

// --- (f) A crack under a history goes on from where it was killed.

#[test]
fn a_killed_history_of_growth_goes_on_to_the_same_numbers() {
    let creep = [CreepTerm { compliance: 0.9e-6, retardation_time: 1.0 }];
    let material = PlaneMaterial::from_creep(1e7, &creep, None).unwrap();
    let process_zone = ProcessZone::Constant { length: 1.3e-6 };
    let interface = Interface { work_of_adhesion: 0.17, process_zone, body: CrackBody::AgainstRigid };
    let problem = GrowthProblem::new(&material, interface, 0.0).unwrap();
    let load = (problem.relaxed_limit() * problem.glassy_limit()).sqrt();
    let history = LoadHistory::constant(load).unwrap();
    let outputs = [0.1, 1.0, 3.0];
    let resolution = Resolution { lines_per_zone: 16, ..Resolution::default() };
    // Two more runs than the first four.
    let wanted = |steps: u64| move |found: &Trajectory| if found.work.steps < steps { 2.0 } else { 0.5 };
    let first = refined_from(&problem, &history, &outputs, resolution, &|_| 0.0, None, &Unwatched).unwrap();
    let excess = wanted(3 * first.work.steps);
    let solved = |from: Option<FinishedRuns>, watch: &dyn GrowthWatch| {
        format!("{:?}", refined_from(&problem, &history, &outputs, resolution, &excess, from, watch).unwrap())
    };
    let whole = solved(None, &Unwatched);
    let killed = Kept(RefCell::new(Vec::new()));
    assert_eq!(solved(None, &killed), whole);
    let kept: Vec<FinishedRuns> = killed.0.into_inner().iter().map(|bytes| postcard::from_bytes(bytes).unwrap()).collect();
    // Six runs, and of the longer ones what was under way.
    let under_way = kept.iter().filter(|kept| kept.steps_under_way() > 0).count();
    assert!(kept.iter().filter(|kept| kept.count() >= 5).count() > 1 && under_way > 10, "{} kept, {under_way} under way", kept.len());
    for from in kept {
        let killed_at = (from.count(), from.steps_under_way());
        let after = Kept(RefCell::new(Vec::new()));
        assert_eq!(solved(Some(from), &after), whole, "killed after run {}, step {}", killed_at.0, killed_at.1);
        // What was finished is not run again, and the run under way goes on from its step.
        let next: Option<FinishedRuns> = after.0.into_inner().first().map(|bytes| postcard::from_bytes(bytes).unwrap());
        if let Some(next) = next {
            assert!((next.count(), next.steps_under_way()) > killed_at, "{killed_at:?}");
        }
    }
}

/// Keeps what it is handed, whenever it can.
struct Kept(RefCell<Vec<Vec<u8>>>);

impl GrowthWatch for Kept {
    fn is_due(&self) -> bool {
        true
    }

    fn keep(&self, finished: &FinishedRuns) {
        self.0.borrow_mut().push(postcard::to_allocvec(finished).unwrap());
    }
}

// --- A bound as long as its value.

#[test]
fn a_sweep_with_an_inaccurate_row_says_so_and_ends_with_4() {
    let folder = Folder::with(GOOD);
    let answer = folder.call(&["run", "scene.toml", "--set", "accuracy=1e-15"]).ended(4);
    assert!(answer.stdout.contains("NOT known to the accuracy 1e-15"), "{}", answer.stdout);
    // Where all are within it there are no such words.
    let fine = Folder::with(GOOD).call(&["run", "scene.toml"]).ended(0);
    assert!(!fine.stdout.contains("NOT known") && fine.stdout.contains("error bounds: at most ±"), "{}", fine.stdout);
}
