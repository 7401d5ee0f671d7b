//! Source: `tests/inputs/records-*`: recorded histories and measured profiles, and `26-profile.csv`.
//!
//! Goal: a file with a few changed bytes is read or refused with a reason that names it: no panic, no number that is not finite.
//!
//! Parameters: bytes replaced, removed and doubled at places that look random, always the same ones; 40 files made of each.
//!
//! Oracle: none is needed beyond the rules of a history (times rise) and of a shape (both columns rise from zero).
//!
//! Tolerance: none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use std::path::Path;
use viscotack_program::scene::typed::{HistorySegment, IndentationShape, Problem};
use viscotack_program::scene::{Document, read};

const FILES: [(&str, &str); 9] = [
    ("26-line-scan-as-profile", "26-profile.csv"),
    ("records-shape", "records-shape.csv"),
    ("records-one-side", "records-one-side.csv"),
    ("records-worn", "records-worn.txt"),
    ("records-decimal-commas", "records-decimal-commas.csv"),
    ("records-spreadsheet", "records-spreadsheet.txt"),
    ("records-named-columns", "records-named-columns.csv"),
    ("records-load", "records-load.csv"),
    ("records-force-curve", "records-force-curve.txt"),
];
const VARIANTS: u64 = 40;

struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

fn mutated(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    const SIGNS: &[u8] = b",;.\t -#(e\n\"0\xff";
    let mut changed = bytes.to_vec();
    for _ in 0..=random.below(3) {
        // Half of them in the header.
        let reach = if random.below(2) == 0 { changed.len().min(120) } else { changed.len() };
        let place = random.below(reach);
        match random.below(4) {
            0 => changed[place] = SIGNS[random.below(SIGNS.len())],
            1 => {
                changed.remove(place);
            }
            2 => changed.insert(place, SIGNS[random.below(SIGNS.len())]),
            _ => changed[place] = random.below(256) as u8,
        }
    }
    changed
}

#[test]
fn changed_bytes_never_panic_and_give_no_number_that_is_none() {
    let inputs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("tests/inputs");
    let (mut accepted, mut refused) = (0, 0);
    for (scene, file) in FILES {
        let text = std::fs::read_to_string(inputs.join(format!("{scene}.toml"))).unwrap();
        let bytes = std::fs::read(inputs.join(file)).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let mut random = Random(bytes.len() as u64);
        for variant in 0..VARIANTS {
            std::fs::write(folder.path().join(file), mutated(&bytes, &mut random)).unwrap();
            let mut document = Document::parse("scene.toml", text.clone(), folder.path()).unwrap();
            let found = read::resolve_includes(&mut document).and_then(|()| read::read(&document));
            let scene = match found {
                Ok(scene) => scene,
                Err(error) => {
                    let said = error.rendered();
                    assert!(said.contains(file) || said.contains("scene.toml"), "{file} {variant}: {said}");
                    refused += 1;
                    continue;
                }
            };
            accepted += 1;
            let Problem::Indentation(indentation) = &scene.problem else { panic!("{file}") };
            let rises = |values: &[f64]| values.windows(2).all(|pair| pair[1] > pair[0]) && values.iter().all(|value| value.is_finite());
            for segment in &indentation.history.segments {
                if let HistorySegment::Table { table, .. } = segment {
                    assert!(rises(&table.times) && table.values.iter().all(|value| value.is_finite()), "{file} {variant}");
                }
            }
            if let IndentationShape::Table { points, .. } = &indentation.shape {
                let (r, z): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
                assert!(rises(&r) && rises(&z) && points[0] == (0.0, 0.0), "{file} {variant}");
            }
        }
    }
    assert!(accepted > 40 && refused > 40, "{accepted} accepted, {refused} refused");
}

/// The scene of an input with a line added, read as users have it.
fn read_with(input: &str, anchor: &str, added: &str) -> Result<viscotack_program::scene::typed::Scene, String> {
    let inputs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("tests/inputs");
    let text = std::fs::read_to_string(inputs.join(format!("{input}.toml"))).unwrap();
    let at = text.find(anchor).unwrap() + anchor.len();
    let text = format!("{}\n{added}\n{}", &text[..at], &text[at..]);
    let mut document = Document::parse("scene.toml", text, &inputs).map_err(|error| error.rendered())?;
    read::resolve_includes(&mut document).and_then(|()| read::read(&document)).map_err(|error| error.rendered())
}

#[test]
fn what_an_error_offers_works_when_pasted() {
    for (input, anchor, remedy, pasted) in [
        ("records-two-loads", "quantity = \"force\"", "columns = { force = \"force in µN\" }", "columns = { force = \"force in µN\" }"),
        ("records-tolerance-below-the-noise", "quantity = \"penetration\"", "tolerance = 1.9e-9", "noise = \"left_out\""),
        (
            "records-one-side",
            "profile = \"records-one-side.csv\"",
            "scan.columns = { r = \"x (µm)\", z = \"z (nm)\" }",
            "scan.columns = { r = \"x (µm)\", z = \"z (nm)\" }",
        ),
        ("records-cap-with-base", "profile = \"records-cap.csv\"", "[indentation.scan] to = 4.51e-6", "scan = { to = 4.51e-6 }"),
    ] {
        let refused = read_with(input, anchor, "").unwrap_err();
        assert!(refused.contains(remedy), "{input}: {refused}");
        read_with(input, anchor, pasted).unwrap_or_else(|error| panic!("{input}: {error}"));
    }
    let inputs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("tests/inputs");
    let text = std::fs::read_to_string(inputs.join("records-tolerance-below-the-noise.toml")).unwrap();
    let mut document = Document::parse("scene.toml", text.replace("\"0.05 nm\"", "1.9e-9"), &inputs).unwrap();
    read::resolve_includes(&mut document).and_then(|()| read::read(&document)).unwrap();
}
