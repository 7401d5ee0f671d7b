//! A killed sweep loses no finished state, and ends in the same bytes as one that was never killed.
//!
//! Contract: the outcome section of the design ("finished rows are journalled in DIR.partial and resumed; the final rename is atomic").
//! Goal: whatever instant a run is killed at, and whatever is left of its journal, the next run of the same scene gives the same files.
//! Parameters: a sweep of thousands of states; a real SIGKILL in flight; journals cut at many bytes, emptied, overwritten, tampered with.
//! Oracle: the files of an uninterrupted run, byte by byte; for kept rows, a value changed in the journal that no computation gives.
//! Tolerance: none, bytes are compared.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, GOOD, SLIDING};
use sha2::{Digest, Sha256};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The good scene with that many states and field points; the fields make states slow enough to be caught in flight.
fn long_scene(states: u32, field_points: u32) -> String {
    GOOD.replace("points = 3", &format!("points = {states}")).replace("points = 5", &format!("points = {field_points}"))
}

fn lines(folder: &Folder, name: &str) -> usize {
    std::fs::read(folder.path(name)).map_or(0, |bytes| bytes.iter().filter(|&&byte| byte == b'\n').count())
}

fn start(folder: &Folder) -> Child {
    Command::new(env!("CARGO_BIN_EXE_viscotack"))
        .current_dir(folder.path("."))
        .args(["run", "scene.toml", "--out", "DIR"])
        .env("RAYON_NUM_THREADS", "1")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// Kills the child (SIGKILL) once the journal holds more than `least` lines; gives the lines that are left, or none if it had ended.
fn killed_in_flight(folder: &Folder, mut child: Child, least: usize) -> Option<usize> {
    let begun = Instant::now();
    while lines(folder, "DIR.partial/journal.jsonl") <= least && !folder.path("DIR").exists() {
        assert!(begun.elapsed() < Duration::from_secs(60), "no line was journalled");
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    (!folder.path("DIR").exists()).then(|| lines(folder, "DIR.partial/journal.jsonl"))
}

#[test]
fn a_run_killed_in_flight_is_resumed_to_the_same_bytes() {
    let scene = long_scene(2_000, 200);
    let whole = Folder::with(&scene);
    whole.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);

    let folder = Folder::with(&scene);
    let first = killed_in_flight(&folder, start(&folder), 10).expect("the sweep is long enough to be caught");
    assert!(!folder.path("DIR").exists());
    // Killed once more, further on.
    let second = killed_in_flight(&folder, start(&folder), first + 100);
    assert!(second.is_none_or(|second| second > first), "a resumed run lost lines: {first} then {second:?}");

    let resumed = folder.call(&["run", "scene.toml", "--out", "DIR"]);
    if second.is_some() {
        assert!(resumed.stderr.contains("resuming: "), "{}", resumed.stderr);
        assert!(resumed.stderr.contains("of 2000 states"), "{}", resumed.stderr);
        assert_eq!(resumed.code, 0);
    }
    assert!(!folder.path("DIR.partial").exists());
    assert_eq!(folder.files("DIR").keys().collect::<Vec<_>>(), whole.files("DIR").keys().collect::<Vec<_>>());
    for (name, bytes) in whole.files("DIR") {
        assert!(folder.files("DIR")[&name] == bytes, "{name} differs");
    }
}

#[test]
fn a_sliding_sweep_is_resumed_to_the_same_bytes() {
    let scene = format!("{SLIDING}\n[sweep]\nkey = \"sliding.speed\"\nfrom = \"1 µm/s\"\nto = \"20 µm/s\"\npoints = 48\n");
    let whole = Folder::with(&scene);
    whole.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let folder = Folder::with(&scene);
    let kept = killed_in_flight(&folder, start(&folder), 3);
    let resumed = folder.call(&["run", "scene.toml", "--out", "DIR", "--force"]).ended(0);
    assert!(kept.is_none() || resumed.stderr.contains("of 48 states"), "{}", resumed.stderr);
    assert!(folder.files("DIR") == whole.files("DIR"));
}

/// Lines of a journal with the digests that belong to their contents.
fn sealed(contents: &[String]) -> String {
    let mut before = "viscotack journal 1".to_owned();
    let line = |content: &String| {
        before = Sha256::digest(format!("{before}{content}")).iter().map(|byte| format!("{byte:02x}")).collect();
        format!("[\"{before}\",{content}]\n")
    };
    contents.iter().map(line).collect()
}

/// The contents of the whole lines of a journal.
fn contents(journal: &[u8]) -> Vec<String> {
    let text = String::from_utf8(journal.to_vec()).unwrap();
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    whole.lines().map(|line| line[68..line.len() - 1].to_owned()).collect()
}

/// The mark of a partial folder, without which it is somebody else's.
const MARK: &str = "DIR.partial/.viscotack";

/// A folder with a journal of a sweep killed early, and the bytes of it.
fn interrupted(scene: &str) -> (Folder, Vec<u8>) {
    for _ in 0..20 {
        let folder = Folder::with(scene);
        if killed_in_flight(&folder, start(&folder), 3).is_some() {
            let journal = std::fs::read(folder.path("DIR.partial/journal.jsonl")).unwrap();
            return (folder, journal);
        }
    }
    panic!("the sweep always ended before it was killed");
}

#[test]
fn journals_cut_at_any_point_lead_to_the_same_bytes() {
    let scene = long_scene(600, 60);
    let whole = Folder::with(&scene);
    whole.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let expected = whole.files("DIR");
    let (folder, journal) = interrupted(&scene);
    let mark = std::fs::read(folder.path(MARK)).unwrap();

    let ends: Vec<usize> = journal.iter().enumerate().filter(|&(_, &byte)| byte == b'\n').map(|(at, _)| at + 1).collect();
    let (header, one, two) = (ends[0], ends[1], ends[2]);
    let cut = |length: usize| journal[..length].to_vec();
    let with = |start: usize, more: &[u8]| [&journal[..start], more].concat();
    let third = &journal[one..two];
    let cases: Vec<(&str, Vec<u8>, Option<usize>)> = vec![
        ("empty", Vec::new(), None),
        ("inside the header", cut(header / 2), None),
        ("the header without its line feed", cut(header - 1), None),
        ("the header alone", cut(header), None),
        ("inside the first state", cut(header + 7), None),
        ("one state without its line feed", cut(one - 1), None),
        ("one state", cut(one), Some(1)),
        ("inside the second state", cut(two - 20), Some(1)),
        ("garbage for a state", with(one, b"garbage\n"), Some(1)),
        ("garbage before a state", with(one, &[b"garbage\n", third].concat()), Some(1)),
        ("bytes that are no text", with(one, b"\xff\xfe\x00\n"), Some(1)),
        ("an empty line", with(one, b"\n"), Some(1)),
        ("null for a state", with(one, b"null\n"), Some(1)),
        ("a state of no rows", with(one, b"[]\n"), Some(1)),
        ("a state twice", with(two, third), Some(2)),
        ("a state left out", [&journal[..header], third].concat(), None),
        ("garbage from the start", b"{\"program\": 3}\n[]\n".to_vec(), None),
        ("zeros, as after a crash of the machine", vec![0; 4096], None),
        ("zeros at the end", with(two, &[0; 512]), Some(2)),
        ("all of it", journal.clone(), Some(ends.len() - 1)),
    ];
    for (kind, bytes, kept) in cases {
        folder.write("DIR.partial/journal.jsonl", bytes);
        let answer = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
        match kept {
            Some(states) => assert!(answer.stderr.contains(&format!("resuming: {states} of 600")), "{kind}: {}", answer.stderr),
            None => assert!(!answer.stderr.contains("resuming"), "{kind}: {}", answer.stderr),
        }
        assert!(folder.files("DIR") == expected, "{kind}: other bytes");
        assert!(!folder.path("DIR.partial").exists(), "{kind}");
        std::fs::remove_dir_all(folder.path("DIR")).unwrap();
        std::fs::create_dir(folder.path("DIR.partial")).unwrap();
        folder.write(MARK, &mark);
    }
}

#[test]
fn a_finished_state_is_kept_and_not_computed_again() {
    let (folder, journal) = interrupted(&long_scene(600, 60));
    let mut states = contents(&journal);
    let mut rows: serde_json::Value = serde_json::from_str(&states[2]).unwrap();
    // A speed that no computation gives.
    rows[0]["values"][0]["value"] = serde_json::json!(123.456789e30);
    states[2] = rows.to_string();
    folder.write("DIR.partial/journal.jsonl", sealed(&states));
    folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let table = folder.read("DIR/states.csv");
    assert_eq!(table.lines().filter(|line| line.contains("1.23456789e32")).count(), 1);
    assert!(table.lines().nth(2).unwrap().contains("1.23456789e32"), "the second state");
}

#[test]
fn the_partial_folder_of_another_scene_is_refused_and_left_alone() {
    let (folder, journal) = interrupted(&long_scene(600, 60));
    folder.write("DIR.partial/fields.csv", "of the other scene");
    let before = folder.files("DIR.partial");
    for (name, other) in [
        ("value.toml", long_scene(600, 60).replace("\"1 J/m²\"", "\"2 J/m²\"")),
        ("states.toml", long_scene(601, 60)),
        ("comment.toml", long_scene(600, 60) + "# a comment\n"),
    ] {
        folder.write(name, other);
        let answer = folder.call(&["run", name, "--out", "DIR"]).ended(2);
        assert!(answer.stderr.contains("`DIR.partial`") && answer.stderr.contains("--force"), "{}", answer.stderr);
        assert!(answer.stdout.is_empty());
        assert!(folder.files("DIR.partial") == before && !folder.path("DIR").exists());
    }
    let answer = folder.call(&["run", "scene.toml", "--set", "crack.speed=3", "--out", "DIR"]).ended(2);
    assert!(answer.stderr.contains("another scene"), "{}", answer.stderr);
    // Another build is another run, too.
    let mut other = contents(&journal);
    assert!(journal.starts_with(sealed(&other).as_bytes()), "the format that this test writes is not that of the program");
    other[0] = other[0].replacen("viscotack 0", "viscotack 99.0", 1);
    folder.write("DIR.partial/journal.jsonl", sealed(&other));
    let answer = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(2);
    assert!(answer.stderr.contains("viscotack 99.0"), "{}", answer.stderr);
    folder.write("DIR.partial/journal.jsonl", journal);

    // With --force it goes, and nothing of it gets into the new folder; but not while it holds a file that is not the run's.
    let refused = folder.call(&["run", "value.toml", "--out", "DIR", "--force"]).ended(2);
    assert!(refused.stderr.contains("`fields.csv`"), "{}", refused.stderr);
    assert!(folder.files("DIR.partial") == before);
    std::fs::remove_file(folder.path("DIR.partial/fields.csv")).unwrap();
    let plain = long_scene(3, 5).split("[fields]").next().unwrap().to_owned();
    folder.write("plain.toml", plain);
    let answer = folder.call(&["run", "plain.toml", "--out", "DIR", "--force"]).ended(0);
    assert!(!answer.stderr.contains("resuming"), "{}", answer.stderr);
    assert!(!folder.path("DIR.partial").exists());
    assert!(!folder.path("DIR/fields.csv").exists(), "a file of the other run");
    assert!(!folder.path("DIR/journal.jsonl").exists());
}

#[test]
fn a_run_killed_while_it_replaces_a_folder_leaves_the_old_one_or_the_new_one() {
    let old = GOOD.replace("A scene for tests", "old");
    let folder = Folder::with(&long_scene(600, 60));
    folder.write("old.toml", old);
    folder.call(&["run", "old.toml", "--out", "DIR"]).ended(0);
    let before = folder.files("DIR");
    let mut child = Command::new(env!("CARGO_BIN_EXE_viscotack"))
        .current_dir(folder.path("."))
        .args(["run", "scene.toml", "--out", "DIR", "--force"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while lines(&folder, "DIR.partial/journal.jsonl") < 2 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let title = folder.read("DIR/summary.json").contains("\"title\": \"old\"");
    assert!(!title || folder.files("DIR") == before, "the old folder was touched");
    folder.call(&["run", "scene.toml", "--out", "DIR", "--force"]).ended(0);
    assert!(folder.read("DIR/summary.json").contains("A scene for tests"));
    assert!(!folder.path("DIR.partial").exists());
}

#[test]
fn two_runs_into_one_folder_do_not_meet() {
    let folder = Folder::with(&long_scene(6_000, 200));
    let mut child = start(&folder);
    let begun = Instant::now();
    while lines(&folder, "DIR.partial/journal.jsonl") <= 10 {
        assert!(begun.elapsed() < Duration::from_secs(60), "no line was journalled");
        std::thread::sleep(Duration::from_millis(1));
    }
    let before = lines(&folder, "DIR.partial/journal.jsonl");
    let second = folder.call(&["run", "scene.toml", "--out", "DIR"]);
    assert!(child.try_wait().unwrap().is_none(), "the first run ended too soon for this test to mean anything");
    assert_eq!(second.code, 2, "{}", second.stderr);
    assert!(second.stderr.contains("DIR.partial") && second.stderr.contains("another run"), "{}", second.stderr);
    assert!(lines(&folder, "DIR.partial/journal.jsonl") >= before, "the journal of the first run was touched");
    child.kill().unwrap();
    child.wait().unwrap();
    // The lock goes with the run.
    let resumed = folder.call(&["run", "scene.toml", "--out", "DIR", "--set", "sweep.points=3"]);
    assert_eq!(resumed.code, 2, "another scene's journal is refused, not locked: {}", resumed.stderr);
    assert!(resumed.stderr.contains("unfinished run"), "{}", resumed.stderr);
}

/// A sphere that sticks and swings through so many cycles: one state, an integration of many steps.
fn swinging(cycles: u32) -> String {
    format!(
        r#"title = "A sphere that swings"
accuracy = 1e-2

[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.49
creep = [{{ fraction = 1, retardation_time = "10 ms" }}]

[adhesion]
work_of_adhesion = "50 mJ/m²"
process_zone = {{ length = "1 µm" }}

[indentation]
sphere = {{ radius = "1 mm" }}
start = "relaxed"
penetration = "5 µm"
energies = {{}}
instants = 20

[[history]]
oscillation = {{ quantity = "penetration", amplitude = "2 µm", frequency = "30 Hz", cycles = {cycles} }}
"#
    )
}

#[test]
fn an_integration_killed_in_flight_goes_on_to_the_same_bytes() {
    let checkpoint = "DIR.partial/state-0.checkpoint";
    let mut cycles = 100;
    // A run that is over before its first checkpoint is made longer.
    let (folder, scene) = loop {
        let scene = swinging(cycles);
        let folder = Folder::with(&scene);
        let mut child = start(&folder);
        while !folder.path(checkpoint).exists() && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        if folder.path(checkpoint).exists() && !folder.path("DIR").exists() {
            break (folder, scene);
        }
        cycles *= 4;
        assert!(cycles < 1_000_000, "no checkpoint was left");
    };
    let whole = Folder::with(&scene);
    whole.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let altered = std::fs::read(folder.path(checkpoint)).unwrap();
    let mark = std::fs::read(folder.path(MARK)).unwrap();

    let resumed = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    assert!(resumed.stderr.contains("resuming: 0 of 1 states were finished before, 1 begun"), "{}", resumed.stderr);
    assert!(!folder.path("DIR.partial").exists());
    assert_eq!(folder.files("DIR").keys().collect::<Vec<_>>(), whole.files("DIR").keys().collect::<Vec<_>>());
    for (name, bytes) in whole.files("DIR") {
        assert!(folder.files("DIR")[&name] == bytes, "{name} differs after {cycles} cycles");
    }

    // Half a checkpoint is none.
    let broken = Folder::with(&scene);
    std::fs::create_dir(broken.path("DIR.partial")).unwrap();
    broken.write(MARK, mark);
    broken.write(checkpoint, &altered[..altered.len() / 2]);
    broken.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    assert!(broken.files("DIR") == whole.files("DIR"));
}
