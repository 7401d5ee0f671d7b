//! Shipped scenes with spoilt bytes: the reader answers with a plan or with an error that names the file and the line.
//!
//! Contract: the scene module; `fuzz/fuzz_targets/scene.rs` takes the same way with a fuzzer's bytes (`viscotack::studies::scene_bytes`).
//! Goal: bytes as a disk or an editor spoils them: flipped bits, lost and doubled pieces, pieces of other scenes, bytes that are no UTF-8. Spoilt words and numbers, which
//! keep a scene well formed, are in `scene_reader_never_panics`.
//! Parameters: every shipped scene, 60 000 mutations, seeded.
//! Oracle: no panic (arithmetic overflow panics in this profile); an accepted scene has a plan or a refusal in a sentence; a refused one names the file, and a syntax
//! error or a wrong key the line.
//! Tolerance: none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod command_support;

use command_support::shipped_scenes;
use rayon::prelude::*;
use viscotack::studies::draw::Draw;
use viscotack::studies::scene_bytes::{Answer, answered};

const MUTATIONS: u64 = 60_000;

/// One to four pieces of the bytes spoilt.
fn spoilt(draw: &mut Draw, scenes: &[Vec<u8>], mut bytes: Vec<u8>) -> Vec<u8> {
    for _ in 0..=draw.below(4) {
        if bytes.is_empty() {
            return bytes;
        }
        let at = draw.below(bytes.len());
        let end = (at + 1 + draw.below(40)).min(bytes.len());
        match draw.below(7) {
            0 => bytes[at] ^= 1 << draw.below(8),
            1 => bytes[at] = draw.below(256) as u8,
            2 => drop(bytes.drain(at..end)),
            3 => {
                let piece = bytes[at..end].to_vec();
                let place = draw.below(bytes.len());
                bytes.splice(place..place, piece);
            }
            4 => {
                let other = &scenes[draw.below(scenes.len())];
                let from = draw.below(other.len());
                let piece = other[from..(from + 1 + draw.below(120)).min(other.len())].to_vec();
                bytes.splice(at..end, piece);
            }
            5 => {
                let place = draw.below(bytes.len());
                bytes.swap(at, place);
            }
            _ => bytes.truncate(at),
        }
    }
    bytes
}

#[test]
fn spoilt_bytes_are_read_or_refused_with_their_place() {
    let scenes: Vec<Vec<u8>> = shipped_scenes().iter().map(|path| std::fs::read(path).unwrap()).collect();
    let answers: Vec<(u64, Answer)> = (0..MUTATIONS)
        .into_par_iter()
        .map(|index| {
            let mut draw = Draw::of(0xb17e5, index);
            let chosen = scenes[draw.below(scenes.len())].clone();
            (index, answered(&spoilt(&mut draw, &scenes, chosen)))
        })
        .collect();
    let (mut planned, mut refused, mut no_text) = (0, 0, 0);
    for (index, answer) in &answers {
        match answer {
            Answer::Planned => planned += 1,
            Answer::Refused(sentence) => {
                assert!(!sentence.is_empty(), "mutation {index}");
                refused += 1;
            }
            Answer::NoText => no_text += 1,
            Answer::Wrong(report) => {
                assert!(report.contains("scene.toml"), "mutation {index} names no file:\n{report}");
                // miette marks the place as file:line:column.
                let line = report.split("scene.toml:").nth(1).and_then(|rest| rest.split(':').next()).map(str::parse::<usize>);
                assert!(matches!(line, Some(Ok(_))), "mutation {index} names no line:\n{report}");
            }
        }
    }
    println!("{planned} planned, {refused} refused by the physics, {no_text} no text, of {}", answers.len());
    // Some must be accepted, or they would show little.
    assert!(planned > 2000 && no_text > 500, "{planned} {no_text}");
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
