//! What becomes of any bytes that are given as a scene: the way that the study of spoilt scenes, its test and the fuzzer take.

use super::cells::{count, word};
use super::draw::Draw;
use super::{Check, Column, Effort, Progress, Section, Table};
use rayon::prelude::*;
use std::panic::catch_unwind;
use std::path::Path;
use viscotack_program::plan::Plan;
use viscotack_program::scene::template::TEMPLATES;
use viscotack_program::scene::{Document, SceneError, read};
use viscotack_program::terminal_text::is_harmful;

/// The answer to some bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// A scene with a plan.
    Planned,
    /// A scene whose numbers the physics refuses, in a sentence.
    Refused(String),
    /// No scene: the error as it is printed, with file and line.
    Wrong(String),
    /// No UTF-8 text.
    NoText,
}

/// Reads bytes as a scene and plans it; nothing is solved, and no file is read.
#[must_use]
pub fn answered(bytes: &[u8]) -> Answer {
    let Ok(text) = std::str::from_utf8(bytes) else { return Answer::NoText };
    let planned = || -> Result<Answer, SceneError> {
        // Files that a scene names are looked for where none is.
        let mut document = Document::parse("scene.toml", text.to_owned(), Path::new("/nowhere"))?;
        read::resolve_includes(&mut document)?;
        let scene = read::read(&document)?;
        Ok(match Plan::new(&scene) {
            Ok(plan) => {
                // Everything that `explain` asks of a plan.
                let _ = (plan.effects(), plan.method(), plan.groups(), plan.columns(), plan.citations(), plan.predicted_work());
                Answer::Planned
            }
            Err(refusal) => Answer::Refused(refusal.to_string()),
        })
    };
    planned().unwrap_or_else(|error| Answer::Wrong(error.rendered()))
}

/// The seed of the study.
const SEED: u64 = 0xb17e5;

/// Mutations of the study: the second number takes some minutes.
const MUTATIONS: [u64; 2] = [4_000, 400_000];

/// Shipped scenes to spoil.
fn corpus() -> Vec<Vec<u8>> {
    TEMPLATES.iter().map(|template| template.text.as_bytes().to_vec()).collect()
}

/// Bytes with one to four pieces spoilt, as a disk or an editor does it: bits, lost and doubled pieces, pieces of other scenes; or, of well-formed
/// scenes, words and numbers.
#[must_use]
pub fn spoilt(draw: &mut Draw, scenes: &[Vec<u8>], mut bytes: Vec<u8>) -> Vec<u8> {
    for _ in 0..=draw.below(4) {
        if bytes.is_empty() {
            return bytes;
        }
        let at = draw.below(bytes.len());
        let end = (at + 1 + draw.below(40)).min(bytes.len());
        match draw.below(8) {
            0 => flip(&mut bytes, at, |byte| byte ^ (1 << (at % 8))),
            1 => {
                let new = draw.below(256) as u8;
                flip(&mut bytes, at, |_| new);
            }
            2 => drop(bytes.drain(at..end)),
            3 => {
                let piece = bytes.get(at..end).unwrap_or(&[]).to_vec();
                let place = draw.below(bytes.len());
                bytes.splice(place..place, piece);
            }
            4 => {
                let other = scenes.get(draw.below(scenes.len())).map_or(&[][..], Vec::as_slice);
                let from = draw.below(other.len());
                let piece = other.get(from..(from + 1 + draw.below(120)).min(other.len())).unwrap_or(&[]).to_vec();
                bytes.splice(at..end, piece);
            }
            5 => {
                let place = draw.below(bytes.len());
                bytes.swap(at, place);
            }
            6 => {
                if let Some(word) = word_around(&bytes, at) {
                    let new = NASTY.get(draw.below(NASTY.len())).copied().unwrap_or("");
                    bytes.splice(word, new.bytes());
                }
            }
            _ => bytes.truncate(at),
        }
    }
    bytes
}

fn flip(bytes: &mut [u8], at: usize, new: impl Fn(u8) -> u8) {
    if let Some(byte) = bytes.get_mut(at) {
        *byte = new(*byte);
    }
}

/// Values that have broken readers before.
const NASTY: &[&str] = &[
    "nan",
    "-inf",
    "1e400",
    "1e308",
    "-1e308",
    "5e-324",
    "-0.0",
    "0",
    "-1",
    "1e150",
    "1e-200",
    "9223372036854775808",
    "0xffffffffffffffffff",
    "1_000",
    "true",
    "1979-05-27",
    "[]",
    "{}",
    "[[[[[[[[",
    "\"\"",
    "\"1e308 GPa\"",
    "\"1e-320 s\"",
    "\"1 m^9 m^9 m^9 m^9 m^9\"",
    "\"\\u0000\"",
    "\"µ\\u202e\"",
    "\"reduced\"",
    "\"crack.speed\"",
    "\"sweep.points\"",
    "\"schapery\"",
];

/// The word or number around a place.
fn word_around(bytes: &[u8], at: usize) -> Option<std::ops::Range<usize>> {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || b"_.+-".contains(&byte);
    let from = at - bytes.get(..at)?.iter().rev().take_while(|&&byte| is_word(byte)).count();
    let to = at + bytes.get(at..)?.iter().take_while(|&&byte| is_word(byte)).count();
    (from < to).then_some(from..to)
}

/// What is wrong with an answer; none if it is as it should be: a refusal has a sentence, an error names the file and the line.
#[must_use]
pub fn fault(answer: &Answer) -> Option<&'static str> {
    match answer {
        Answer::Planned | Answer::NoText => None,
        Answer::Refused(sentence) => sentence.is_empty().then_some("a refusal without a sentence"),
        Answer::Wrong(report) => {
            // An error marks the place as file:line:column.
            let line = report.split("scene.toml:").nth(1).and_then(|rest| rest.split(':').next()).map(str::parse::<usize>);
            if !matches!(line, Some(Ok(_))) {
                Some("an error without file and line")
            } else if report.chars().any(|character| !matches!(character, '\n' | '\t') && is_harmful(character)) {
                Some("an error that commands a terminal")
            } else {
                None
            }
        }
    }
}

/// Answers to spoilt scenes of a stream, each with its number; a panic is an answer, too.
#[must_use]
pub fn answers(seed: u64, scenes: &[Vec<u8>], mutations: u64, done: &(dyn Fn() + Sync)) -> Vec<(u64, Option<Answer>)> {
    (0..mutations)
        .into_par_iter()
        .map(|index| {
            let mut draw = Draw::of(seed, index);
            let chosen = scenes.get(draw.below(scenes.len())).cloned().unwrap_or_default();
            let bytes = spoilt(&mut draw, scenes, chosen);
            let answer = catch_unwind(|| answered(&bytes)).ok();
            done();
            (index, answer)
        })
        .collect()
}

/// The study of `viscotack verify`.
pub(super) fn study(effort: Effort, progress: &Progress) -> Section {
    let mutations = effort.choose(MUTATIONS[0], MUTATIONS[1]);
    progress.expect(mutations);
    let all = answers(SEED, &corpus(), mutations, &|| progress.advance(1));
    let mut section = Section::new("scene_bytes", "Scenes with spoilt bytes");
    section.say(format!(
        "The templates with flipped bits, lost, doubled and foreign pieces, and spoilt words and numbers: {mutations} mutations, seeded. Each is read and planned, none is \
         solved. The reader answers with a plan, or with one error that names file and line."
    ));
    let number_of = |wanted: fn(&Answer) -> bool| all.iter().filter(|(_, answer)| answer.as_ref().is_some_and(wanted)).count();
    let planned = number_of(|answer| *answer == Answer::Planned);
    let kinds = [
        ("planned", planned),
        ("refused by the physics", number_of(|answer| matches!(answer, Answer::Refused(_)))),
        ("wrong scene", number_of(|answer| matches!(answer, Answer::Wrong(_)))),
        ("no text", number_of(|answer| *answer == Answer::NoText)),
    ];
    let mut table = Table::new("answers", "What became of them.", vec![Column::words("answer"), Column::new("mutations", "1")]);
    table.rows = kinds.iter().map(|(kind, found)| vec![word(*kind), count(*found)]).collect();
    section.tables.push(table);
    let faults: Vec<String> = all
        .iter()
        .filter_map(|(index, answer)| {
            let fault = answer.as_ref().map_or(Some("a panic"), fault)?;
            Some(format!("mutation {index}: {fault}"))
        })
        .collect();
    let found = faults.first().map_or_else(|| "every answer is".to_owned(), |first| format!("{} are not; {first}", faults.len()));
    section.checks.push(Check::new(
        "answers to spoilt scenes",
        "each is a plan, a sentence, or an error with its place",
        found,
        faults.is_empty(),
    ));
    let enough = planned as u64 >= mutations / 50;
    section.checks.push(Check::new(
        "the mutations mean something",
        "at least one in fifty is still a scene",
        format!("{planned} are"),
        enough,
    ));
    section
}
