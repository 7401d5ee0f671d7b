//! Source: the contract of sweeps that scale: threads do not change a byte, and shards that are gathered give the bytes of one run.
//!
//! Goal: `--jobs` changes no byte; `run --shard i/n` and `gather` give what one run gives, whatever n; a mixture or a gap is refused with one sentence.
//!
//! Parameters: a sweep over speeds with fields and plots, of 1 to more shards than states; a scene with states on the way of others and states that fail; a scene
//! whose material lies in another file and whose values are put in by `--set`; journals cut and altered; another scene, another build, another number of shards.
//!
//! Oracle: the files of one run of the same scene. Tolerance: none, bytes are compared.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, GOOD, SLIDING, answer};
use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

fn points(states: u32) -> String {
    GOOD.replace("points = 3", &format!("points = {states}"))
}

/// A sphere that is pulled off at some speeds: rows of states and rows on their way.
const PULLED: &str = "accuracy = 1e-2\n[material]\nrelaxed_modulus = 1.3e6\nglassy_modulus = 9e6\npoisson_ratio = 0.47\n\
     relaxation = [{ fraction = 1, relaxation_time = 0.2 }]\n[adhesion]\nwork_of_adhesion = 0.08\nprocess_zone = { length = 4e-6 }\n\
     [indentation]\nsphere = { radius = 2.1e-3 }\nstart = \"relaxed\"\npenetration = 1e-5\ninstants = 4\n\
     [[history]]\npenetration = -6e-5\nduration = 3.0\n[[sweep]]\nkey = \"indentation.speed_factor\"\nfrom = 0.1\nto = 10\npoints = 5\n";

fn shards(folder: &Folder, of: usize, more: &[&str]) -> Vec<String> {
    let names: Vec<String> = (0..of).map(|part| format!("S{part}of{of}")).collect();
    for (part, name) in names.iter().enumerate() {
        let shard = format!("{part}/{of}");
        let said = folder.call(&[&["run", "scene.toml", "--shard", &shard, "--out", name], more].concat()).ended(0);
        assert!(said.stdout.contains(&format!("shard {shard}: ")), "{}", said.stdout);
    }
    names
}

fn gather(folder: &Folder, names: &[String], out: &str) -> command_support::Answer {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    folder.call(&[&["gather"], names.as_slice(), &["--out", out]].concat())
}

fn assert_same(folder: &Folder, one: &str, other: &str) {
    let (one, other) = (folder.files(one), folder.files(other));
    assert_eq!(one.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
    for (name, bytes) in &one {
        assert!(*bytes == other[name], "{name} differs");
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    for scene in [
        points(700),
        PULLED.to_owned(),
        SLIDING.replace("[fields]", "[sweep]\nkey = \"sliding.speed\"\nfrom = 1e-5\nto = 1e-1\npoints = 150\n[fields]"),
    ] {
        let folder = Folder::with(&scene);
        let said: Vec<String> =
            ["1", "2", "7"].map(|jobs| folder.call(&["run", "scene.toml", "--jobs", jobs, "--out", jobs, "--json"]).ended(0).stdout).into();
        assert!(said[0] == said[1] && said[0] == said[2]);
        assert_same(&folder, "1", "2");
        assert_same(&folder, "1", "7");
    }
    let folder = Folder::with(GOOD);
    for wrong in ["0", "many", "5000"] {
        let said = folder.call(&["run", "scene.toml", "--jobs", wrong]).ended(2);
        assert!(said.stderr.contains("--jobs"), "{}", said.stderr);
    }
}

#[test]
fn gathered_shards_give_the_bytes_of_one_run() {
    for (scene, numbers) in [(points(41), [1, 2, 7]), (points(3), [2, 3, 5]), (PULLED.to_owned(), [2, 3, 5])] {
        let folder = Folder::with(&scene);
        let whole = folder.call(&["run", "scene.toml", "--out", "WHOLE"]).ended(0);
        for of in numbers {
            let mut names = shards(&folder, of, &[]);
            // In any order.
            names.rotate_left(of / 2);
            let out = format!("G{of}");
            let said = gather(&folder, &names, &out).ended(0);
            assert_same(&folder, "WHOLE", &out);
            assert_eq!(said.stdout.replace(&out, "WHOLE"), whole.stdout);
        }
    }
}

/// More rows than are held at once: both ways stream them.
#[test]
fn a_long_sweep_is_gathered_as_it_is_run() {
    let scene = points(21_000).split("[fields]").next().unwrap().to_owned();
    let folder = Folder::with(&scene);
    folder.call(&["run", "scene.toml", "--out", "WHOLE"]).ended(0);
    let names = shards(&folder, 3, &[]);
    gather(&folder, &names, "G").ended(0);
    assert_same(&folder, "WHOLE", "G");
}

/// The shards hold all that the scene was read from, so that they can be gathered where its files are not.
#[test]
fn shards_need_no_file_of_the_scene() {
    let (head, rest) = GOOD.split_once("[adhesion]").unwrap();
    let (title, material) = head.split_once("[material]").unwrap();
    let folder = Folder::with(&format!("{title}[material]\nfile = \"parts/rubber.toml\"\n[adhesion]{rest}"));
    fs::create_dir(folder.path("parts")).unwrap();
    folder.write("parts/rubber.toml", format!("[material]{material}"));
    let sets = ["--set", "crack.plane=strain", "--set", "sweep.points=9", "--set", "plots=[\"svg\", \"png\"]"];
    folder.call(&[&["run", "scene.toml", "--out", "WHOLE"], sets.as_slice()].concat()).ended(0);
    let names = shards(&folder, 2, &sets);
    fs::remove_dir_all(folder.path("parts")).unwrap();
    fs::remove_file(folder.path("scene.toml")).unwrap();
    gather(&folder, &names, "G").ended(0);
    assert_same(&folder, "WHOLE", "G");
}

/// Rows that fail are rows as any: the code of the whole is that of `gather`. They leave nothing behind: the work of the next state is its own.
#[test]
fn states_that_fail_are_gathered() {
    let scene = format!(
        "{}[sweep]\nkey = \"sliding.mean_pressure\"\nvalues = [6e3, 9e5, 7e3, -9e5, 8e3]\n",
        SLIDING.split("[fields]").next().unwrap()
    );
    let folder = Folder::with(&scene);
    let whole = folder.call(&["run", "scene.toml", "--out", "WHOLE"]);
    let names = shards(&folder, 2, &[]);
    let said = gather(&folder, &names, "G");
    assert_eq!((said.code, said.stdout.replace("wrote      G", "wrote      WHOLE")), (whole.code, whole.stdout));
    assert_same(&folder, "WHOLE", "G");
}

#[test]
fn gaps_and_mixtures_are_refused() {
    let folder = Folder::with(&points(12));
    let good = shards(&folder, 3, &[]);
    let list = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    folder.call(&["run", "scene.toml", "--shard", "1/3", "--out", "COPY"]).ended(0);
    folder.call(&["run", "scene.toml", "--shard", "1/4", "--out", "FOURTH"]).ended(0);
    folder.call(&["run", "scene.toml", "--shard", "2/3", "--set", "crack.plane=strain", "--out", "OTHER"]).ended(0);
    folder.call(&["run", "scene.toml", "--out", "WHOLE"]).ended(0);
    fs::create_dir(folder.path("EMPTY")).unwrap();
    // Same version, same commit, another file: what follows the end of a program file is not run.
    let program = folder.path("viscotack-other");
    fs::copy(env!("CARGO_BIN_EXE_viscotack"), &program).unwrap();
    let mut bytes = fs::OpenOptions::new().append(true).open(&program).unwrap();
    std::io::Write::write_all(&mut bytes, b"another build").unwrap();
    drop(bytes);
    let other = |arguments: &[&str]| answer(assert_cmd::Command::new(&program).current_dir(folder.path(".")).args(arguments));
    other(&["run", "scene.toml", "--shard", "2/3", "--out", "BUILD"]).ended(0);
    for (names, words) in [
        (list(&["S0of3", "S2of3"]), ["1 of 3 shards are missing", "1/3"]),
        (list(&["S1of3"]), ["2 of 3 shards are missing", "0/3, 2/3"]),
        (list(&["S0of3", "S1of3", "S2of3", "COPY"]), ["shard 1/3 is given twice", "`COPY`"]),
        (list(&["S0of3", "S0of3", "S2of3"]), ["shard 0/3 is given twice", "`S0of3`"]),
        (list(&["S0of3", "FOURTH", "S2of3"]), ["shards of different runs", "3 shards, the other of 4"]),
        (list(&["S0of3", "S1of3", "OTHER"]), ["shards of different runs", "scenes differ"]),
        (list(&["S0of3", "S1of3", "BUILD"]), ["shards of different runs", "was solved by"]),
        (list(&["S0of3", "S1of3", "WHOLE"]), ["`WHOLE` is not the finished folder of a shard", "--shard"]),
        (list(&["S0of3", "S1of3", "EMPTY"]), ["`EMPTY` is not the finished folder of a shard", "--shard"]),
        (list(&["S0of3", "S1of3", "NONE"]), ["`NONE` is not the finished folder of a shard", "does not exist"]),
    ] {
        let said = gather(&folder, &names, "G").ended(2);
        assert!(words.iter().all(|word| said.stderr.contains(word)), "{names:?}: {}", said.stderr);
        assert_eq!(said.stderr.lines().count(), 1, "{}", said.stderr);
        assert!(!folder.path("G").exists() && !folder.path("G.partial").exists());
    }
    // Another build gathers nothing of this one.
    let said = other(&["gather", "S0of3", "S1of3", "S2of3", "--out", "G"]).ended(2);
    assert!(said.stderr.contains("gather them with the program that solved them"), "{}", said.stderr);
    // Nothing is replaced unasked.
    gather(&folder, &good, "WHOLE").ended(2);
    gather(&folder, &good, "G").ended(0);
    assert_same(&folder, "WHOLE", "G");
}

#[test]
fn wrong_shards_are_refused_before_anything_is_solved() {
    let folder = Folder::with(GOOD);
    for wrong in ["3/3", "1/0", "a/b", "2", "1/99999999999"] {
        let said = folder.call(&["run", "scene.toml", "--shard", wrong, "--out", "S"]).ended(2);
        assert!(said.stderr.contains("--shard"), "{wrong}: {}", said.stderr);
    }
    let said = folder.call(&["run", "scene.toml", "--shard", "0/3"]).ended(2);
    assert!(said.stderr.contains("--out"), "{}", said.stderr);
    folder.call(&["run", "scene.toml", "--shard", "0/3", "--out", "S", "--json"]).ended(2);
    assert!(!folder.path("S").exists() && !folder.path("S.partial").exists());
}

/// A line of a shard's journal that is altered, cut or left out: the state that cannot be read is named, and no result is written.
#[test]
fn altered_rows_are_not_gathered() {
    let folder = Folder::with(&points(12));
    let names = shards(&folder, 3, &[]);
    let path = folder.path("S1of3/journal.jsonl");
    let journal = fs::read(&path).unwrap();
    let lines: Vec<&[u8]> = journal.split_inclusive(|&byte| byte == b'\n').collect();
    let mut altered = journal.clone();
    let place = lines[0].len() + lines[1].len() + 200;
    altered[place] ^= 1;
    let cut = journal[..journal.len() - 3].to_vec();
    let left_out = [lines[0], lines[1], lines[3], lines[4]].concat();
    // States 1, 4, 7, 10 from 0 lie in it: 2, 5, 8, 11 from 1.
    for (bytes, state) in [(altered, 5), (cut, 11), (left_out, 5), (lines[..4].concat(), 11)] {
        folder.write("S1of3/journal.jsonl", bytes);
        let said = gather(&folder, &names, "G").ended(2);
        assert!(said.stderr.contains(&format!("the rows of state {state} were altered or are missing")), "{}", said.stderr);
        assert!(!folder.path("G").exists());
    }
    folder.write("S1of3/journal.jsonl", &journal);
    gather(&folder, &names, "G").ended(0);
    folder.call(&["run", "scene.toml", "--out", "WHOLE"]).ended(0);
    assert_same(&folder, "WHOLE", "G");
}

/// What a shard says about its scene is altered, in the first folder or in another: no result is written, and the scene's own file is not blamed.
#[test]
fn an_altered_scene_of_a_shard_is_not_gathered() {
    let folder = Folder::with(&points(12));
    let names = shards(&folder, 3, &["--set", "crack.plane=strain"]);
    for shard in &names {
        for (file, old, new, words) in [
            ("shard.json", "crack.plane=strain", "crack.plane=stress", "its shard.json was altered: solve this shard again"),
            ("shard.json", "creep", "creeq", "its shard.json was altered: solve this shard again"),
            (".viscotack", "shard.json", "shard.jsom", "its mark, .viscotack, was altered: solve this shard again"),
        ] {
            let path = format!("{shard}/{file}");
            let good = folder.read(&path);
            assert!(good.contains(old), "{path}");
            folder.write(&path, good.replacen(old, new, 1));
            let said = gather(&folder, &names, "G").ended(2);
            assert!(said.stderr.contains(words) && said.stderr.contains(&format!("`{shard}`")), "{path}, {old}: {}", said.stderr);
            assert_eq!(said.stderr.lines().count(), 1, "{}", said.stderr);
            assert!(!folder.path("G").exists());
            folder.write(&path, good);
        }
    }
    gather(&folder, &names, "G").ended(0);
}

/// A shard that is killed goes on where it was; while it is not finished it is not gathered.
#[test]
fn a_killed_shard_is_resumed() {
    let scene = points(4_000).replace("points = 5", "points = 200");
    let folder = Folder::with(&scene);
    let start = || {
        Command::new(env!("CARGO_BIN_EXE_viscotack"))
            .current_dir(folder.path("."))
            .args(["run", "scene.toml", "--shard", "1/2", "--out", "S1of2", "--jobs", "1"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    let mut child = start();
    let begun = Instant::now();
    let lines =
        || fs::read(folder.path("S1of2.partial/journal.jsonl")).map_or(0, |bytes| bytes.iter().filter(|&&byte| byte == b'\n').count());
    while lines() < 20 {
        assert!(begun.elapsed() < Duration::from_secs(60), "no line was journalled");
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!folder.path("S1of2").exists(), "the shard is long enough to be caught");
    let kept = lines();
    folder.call(&["run", "scene.toml", "--shard", "0/2", "--out", "S0of2"]).ended(0);
    let names = ["S0of2".to_owned(), "S1of2".to_owned()];
    let said = gather(&folder, &names, "G").ended(2);
    assert!(said.stderr.contains("`S1of2.partial`") && said.stderr.contains("same command again"), "{}", said.stderr);
    // Another shard does not go on with it.
    let said = folder.call(&["run", "scene.toml", "--shard", "0/2", "--out", "S1of2"]).ended(2);
    assert!(said.stderr.contains("shard 1/2"), "{}", said.stderr);
    let said = folder.call(&["run", "scene.toml", "--shard", "1/2", "--out", "S1of2"]).ended(0);
    assert!(said.stderr.contains("resuming: ") && said.stderr.contains("of 2000 states"), "{}", said.stderr);
    assert!(kept >= 20);
    gather(&folder, &names, "G").ended(0);
    folder.call(&["run", "scene.toml", "--out", "WHOLE"]).ended(0);
    assert_same(&folder, "WHOLE", "G");
}
