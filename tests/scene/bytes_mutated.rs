//! Shipped scenes with spoilt bytes: the reader answers with a plan or with an error that names the file and the line.
//!
//! Contract: the scene module; `fuzz/fuzz_targets/scene.rs` takes the same way with a fuzzer's bytes (`viscotack_verification::studies::scene_bytes`), and so does
//! `viscotack verify`.
//! Goal: bytes as a disk or an editor spoils them: flipped bits, lost and doubled pieces, pieces of other scenes, bytes that are no UTF-8. Spoilt words and numbers,
//! which keep a scene well formed, are in `scene_reader_never_panics`. Parameters: every shipped scene, 60 000 mutations, seeded. Oracle: no panic (arithmetic overflow
//! panics in this profile); an accepted scene has a plan or a refusal in a sentence; a refused one names the file, and a syntax error or a wrong key the line.
//! Tolerance: none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::shipped_scenes;
use viscotack_verification::studies::scene_bytes::{Answer, answered, answers, fault};

const MUTATIONS: u64 = 60_000;

#[test]
fn spoilt_bytes_are_read_or_refused_with_their_place() {
    let scenes: Vec<Vec<u8>> = shipped_scenes().iter().map(|path| std::fs::read(path).unwrap()).collect();
    let answers = answers(0xb17e5, &scenes, MUTATIONS, &|| ());
    let (mut planned, mut refused, mut no_text) = (0, 0, 0);
    for (index, answer) in &answers {
        let answer = answer.as_ref().unwrap_or_else(|| panic!("mutation {index}: a panic"));
        assert_eq!(fault(answer), None, "mutation {index}: {answer:?}");
        match answer {
            Answer::Planned => planned += 1,
            Answer::Refused(_) => refused += 1,
            Answer::NoText => no_text += 1,
            Answer::Wrong(_) => {}
        }
    }
    println!("{planned} planned, {refused} refused by the physics, {no_text} no text, of {}", answers.len());
    // Some must be accepted, or they would show little.
    assert!(planned > 2000 && no_text > 500, "{planned} {no_text}");
}

/// The check that the study makes finds answers that are wrong.
#[test]
fn a_wrong_answer_is_a_fault() {
    assert!(fault(&Answer::Refused(String::new())).is_some());
    assert!(fault(&Answer::Wrong("no place".into())).is_some());
    assert!(fault(&Answer::Wrong("scene.toml:3:1 \u{1b}[31m".into())).is_some());
    assert!(fault(&Answer::Wrong("scene.toml:3:1".into())).is_none());
}

#[test]
fn the_scenes_themselves_are_planned() {
    for path in shipped_scenes() {
        let bytes = std::fs::read(&path).unwrap();
        // Scenes that name further files are read from their own folder by the program; here there is none.
        if !String::from_utf8_lossy(&bytes).contains(".csv") && !String::from_utf8_lossy(&bytes).contains("file =") {
            assert!(matches!(answered(&bytes), Answer::Planned), "{}", path.display());
        }
    }
}
