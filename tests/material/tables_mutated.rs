//! Source: the tables of materials in `tests/inputs` (written by `tests/inputs/make_tables.py`), with spoilt bytes.
//!
//! Goal: a byte that is flipped, lost, inserted or doubled never gives numbers that the file does not hold. The table is refused, or a strict reader
//! agrees, or a note says what was chosen that was not chosen for the table as it was.
//!
//! Oracle: [`reference`], a reader of its own that knows separator, decimal sign and the few headers of these tables, and reads nothing else.
//!
//! Tolerance: 1e-12, rounding of units.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use viscotack_program::scene::Document;
use viscotack_program::scene::read::{read_material_table, resolve_material};
use viscotack_program::scene::typed::MaterialData;
use viscotack_verification::studies::draw::Draw;

const MUTATIONS: u64 = 1500;

fn inputs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/inputs")
}

/// Reads bytes as the table of a scene.
fn read(scene: &str, file: &str, bytes: &[u8]) -> Result<MaterialData, String> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(file), bytes).unwrap();
    let mut document = Document::parse("scene.toml", scene.to_owned(), folder.path()).unwrap();
    resolve_material(&mut document).and_then(|()| read_material_table(&document)).map(Option::unwrap).map_err(|error| error.rendered())
}

/// One to three bytes or pieces spoilt.
fn spoilt(draw: &mut Draw, mut bytes: Vec<u8>) -> Vec<u8> {
    for _ in 0..=draw.below(3) {
        if bytes.is_empty() {
            return bytes;
        }
        let at = draw.below(bytes.len());
        let end = (at + 1 + draw.below(12)).min(bytes.len());
        match draw.below(6) {
            0 => bytes[at] ^= 1 << draw.below(8),
            // Bytes that mean something in a table are the likelier ones.
            1 => bytes[at] = b"0123456789.,;\t eE-+\"'#\n\r:="[draw.below(26)],
            2 => drop(bytes.drain(at..end)),
            3 => drop(bytes.remove(at)),
            4 => bytes.insert(at, b"0123456789.,;\t eE-+\"'#\n\r:="[draw.below(26)]),
            _ => {
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
        }
    }
    bytes
}

/// What the strict reader finds.
enum Found {
    Rows(Vec<[f64; 3]>),
    /// The table is not as it was written.
    Refused,
    /// A header that this reader does not know.
    Unknown,
}

/// Reads a table of one header line and rows, with a given separator and decimal sign.
/// Rows are frequency or time (rad/s or s), value and loss (SI; 0 where there is none).
fn reference(bytes: &[u8], separator: char, decimal: char) -> Found {
    let Ok(text) = std::str::from_utf8(bytes) else { return Found::Unknown };
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let mut lines =
        text.split('\n').map(str::trim).filter(|line| !line.is_empty() && !line.starts_with(['#', '%']) && !line.starts_with("//"));
    let Some(header) = lines.next() else { return Found::Refused };
    let turn = std::f64::consts::TAU;
    let column = |cell: &str| -> Option<(usize, f64)> {
        Some(match cell.trim() {
            "frequency (Hz)" | "Frequency (Hz)" | "f (Hz)" => (0, turn),
            "Frequency (rpm)" => (0, turn / 60.0),
            "time (min)" => (0, 60.0),
            "Zeit/s" | "t (s)" => (0, 1.0),
            "storage modulus (MPa)" | "Storage modulus (MPa)" | "E' (MPa)" | "E(t)/MPa" => (1, 1e6),
            "creep compliance (1/MPa)" => (1, 1e-6),
            "loss modulus (MPa)" | "Loss modulus (MPa)" => (2, 1e6),
            "tan(delta)" => (3, 1.0),
            _ => return None,
        })
    };
    let columns: Option<Vec<(usize, f64)>> = header.split(separator).map(column).collect();
    let Some(columns) = columns else { return Found::Unknown };
    let distinct: HashSet<usize> = columns.iter().map(|column| column.0).collect();
    if distinct.len() != columns.len() {
        return Found::Unknown;
    }
    let mut rows = Vec::new();
    for line in lines {
        let mut cells: Vec<&str> = line.split(separator).map(str::trim).collect();
        // An empty cell behind the last column holds nothing.
        while cells.len() > columns.len() && cells.last().is_some_and(|cell| cell.is_empty()) {
            cells.pop();
        }
        if cells.len() != columns.len() {
            return Found::Refused;
        }
        let mut row = [0.0; 4];
        for (cell, (index, factor)) in cells.iter().zip(&columns) {
            let digits = cell.strip_prefix(['+', '-']).unwrap_or(cell);
            let other = if decimal == '.' { ',' } else { '.' };
            if !digits.starts_with(|c: char| c.is_ascii_digit() || c == decimal) || cell.contains(other) {
                return Found::Refused;
            }
            let Ok(value) = cell.replace(decimal, ".").parse::<f64>() else { return Found::Refused };
            row[*index] = value * factor;
        }
        let loss = if row[3] > 0.0 { row[1] * row[3] } else { row[2] };
        rows.push([row[0], row[1], loss]);
    }
    Found::Rows(rows)
}

fn agree(data: &MaterialData, rows: &[[f64; 3]]) -> bool {
    let near = |one: f64, other: f64| (one - other).abs() <= 1e-12 * other.abs();
    data.rows.len() == rows.len()
        && data.rows.iter().zip(rows).all(|(row, right)| {
            near(row.at, right[0])
                && near(row.value, right[1])
                && row.loss.is_none_or(|loss| near(loss, right[2]))
                && row.temperature.is_none()
        })
}

fn notes(data: &MaterialData) -> HashSet<String> {
    // Numbers of lines and cells in a note move with the table.
    data.notes.iter().chain(&data.warnings).map(|note| note.chars().filter(|c| !c.is_ascii_digit()).collect()).collect()
}

#[test]
fn spoilt_tables_give_what_they_hold_or_say_what_was_chosen() {
    for (name, separator, decimal) in [
        ("table_plain", ',', '.'),
        ("table_tangent", ',', '.'),
        ("table_rpm", ',', '.'),
        ("table_relaxation", ';', ','),
        ("table_creep", ',', '.'),
    ] {
        let bytes = std::fs::read(inputs().join(format!("{name}.csv"))).unwrap();
        let scene = std::fs::read_to_string(inputs().join(format!("{name}.toml"))).unwrap();
        let file = format!("{name}.csv");
        let whole = read(&scene, &file, &bytes).unwrap();
        let Found::Rows(right) = reference(&bytes, separator, decimal) else { panic!("{name}") };
        assert!(agree(&whole, &right), "{name}: the table as it is");
        let known = notes(&whole);
        let counts: Vec<[usize; 4]> = (0..4 * MUTATIONS)
            .into_par_iter()
            .map(|index| {
                let mutated = spoilt(&mut Draw::of(0x7ab1e5, index), bytes.clone());
                let Ok(data) = read(&scene, &file, &mutated) else { return [1, 0, 0, 0] };
                if !notes(&data).is_subset(&known) {
                    return [0, 0, 1, 0];
                }
                match reference(&mutated, separator, decimal) {
                    Found::Unknown => [0, 0, 0, 1],
                    Found::Rows(rows) if agree(&data, &rows) => [0, 1, 0, 0],
                    Found::Rows(_) => panic!("{name}, mutation {index}: other numbers\n{}", String::from_utf8_lossy(&mutated)),
                    Found::Refused => panic!("{name}, mutation {index}: read, and not stated\n{}", String::from_utf8_lossy(&mutated)),
                }
            })
            .collect();
        let sum = |part: usize| counts.iter().map(|count| count[part]).sum::<usize>();
        println!("{name}: {} refused, {} agree, {} with a note, {} of another header", sum(0), sum(1), sum(2), sum(3));
        assert!(sum(1) > counts.len() / 10 && sum(3) < counts.len() / 10, "{name}");
    }
}

/// The line of a byte, if it holds numbers alone.
fn row_of_numbers(bytes: &[u8], at: usize) -> bool {
    let ends = |byte: &u8| matches!(byte, b'\n' | b'\r');
    let begin = bytes[..at].iter().rposition(ends).map_or(0, |place| place + 1);
    let end = bytes[at..].iter().position(ends).map_or(bytes.len(), |length| at + length);
    bytes[begin..end].iter().any(u8::is_ascii_digit)
        && bytes[begin..end].iter().all(|byte| byte.is_ascii_digit() || b" .,;\t'\"-+eE\xa0".contains(byte))
}

/// In every form of table: one byte of a row, changed, changes that row alone, or the table is refused, or a note is new. (A line end joins two rows.)
#[test]
fn one_byte_changes_its_own_row_alone() {
    let files: Vec<PathBuf> = std::fs::read_dir(inputs()).unwrap().map(|entry| entry.unwrap().path()).collect();
    let tables: Vec<&PathBuf> = files
        .iter()
        .filter(|path| path.file_stem().is_some_and(|stem| stem.to_str().unwrap().starts_with("table_")))
        .filter(|path| path.extension().is_some_and(|one| one != "toml"))
        .collect();
    let accepted: usize = tables
        .par_iter()
        .map(|path| {
            let bytes = std::fs::read(path).unwrap();
            let scene = std::fs::read_to_string(path.with_extension("toml")).unwrap();
            let file = path.file_name().unwrap().to_str().unwrap();
            // The refused ones, and UTF-16, whose rows are no rows of bytes.
            let Some(whole) = read(&scene, file, &bytes).ok().filter(|_| !bytes.contains(&0)) else { return 0 };
            let known = notes(&whole);
            let key = |row: &viscotack_program::scene::typed::MeasuredRow| {
                [row.temperature.unwrap_or(0.0), row.at, row.value, row.loss.unwrap_or(0.0)].map(f64::to_bits)
            };
            let right: HashSet<_> = whole.rows.iter().map(key).collect();
            let mut accepted = 0;
            for index in 0..MUTATIONS / 5 {
                let mut draw = Draw::of(0x0b17e, index);
                let at = draw.below(bytes.len());
                if !row_of_numbers(&bytes, at) {
                    continue;
                }
                let mut mutated = bytes.clone();
                mutated[at] = b"0123456789.,;\t eE-+\"'#\n\r:="[draw.below(26)];
                let Ok(data) = read(&scene, file, &mutated) else { continue };
                if !notes(&data).is_subset(&known) {
                    continue;
                }
                let found: HashSet<_> = data.rows.iter().map(key).collect();
                let (lost, new) = (right.difference(&found).count(), found.difference(&right).count());
                assert!(lost <= 2 && new <= 1, "{file}, byte {at}: {lost} rows lost, {new} new\n{}", String::from_utf8_lossy(&mutated));
                accepted += 1;
            }
            accepted
        })
        .sum();
    println!("{accepted} tables with one other byte are read");
    assert!(accepted > 500, "{accepted}");
}

/// Every table: no panic, and an error that names its file and a line.
#[test]
fn every_spoilt_table_is_answered() {
    let files: Vec<PathBuf> = std::fs::read_dir(inputs()).unwrap().map(|entry| entry.unwrap().path()).collect();
    let tables = files.iter().filter(|path| {
        path.file_stem().is_some_and(|stem| stem.to_str().unwrap().starts_with("table_"))
            && path.extension().is_some_and(|one| one != "toml")
    });
    for path in tables {
        let bytes = std::fs::read(path).unwrap();
        let scene = std::fs::read_to_string(path.with_extension("toml")).unwrap();
        let file = path.file_name().unwrap().to_str().unwrap();
        (0..MUTATIONS / 4).into_par_iter().for_each(|index| {
            let mutated = spoilt(&mut Draw::of(0xa15e5, index), bytes.clone());
            if let Err(report) = read(&scene, file, &mutated) {
                assert!(report.contains(file), "{report}");
                assert!(report.chars().all(|c| c == '\n' || !c.is_control()), "{report:?}");
                assert!(report.lines().all(|line| line.chars().count() < 720), "{report}");
            }
        });
    }
}
