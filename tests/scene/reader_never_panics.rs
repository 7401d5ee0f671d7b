//! The scene reader answers any text with a scene or an error, and an accepted scene holds finite numbers only.
//!
//! Contract: the scene module ("the reader never panics, whatever the bytes").
//! Goal: parse, include, set, read, plan, and the accessors behind `explain` never panic; neither does the solution of what was accepted, where it is cheap:
//! steady cracks, sliding states and strengths, and a few branches. Histories are not solved here.
//! Parameters: every shipped scene, spoilt by up to six random edits (bytes, lines, tokens, cuts); texts out of nothing; `--set`s.
//! Oracle: no panic (arithmetic overflow panics in this profile); no NaN and no infinity in an accepted scene or in its plan's numbers;
//! only finite values and errors in solved rows.
//! Tolerance: none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::shipped_scenes;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use viscotack_program::plan::Plan;
use viscotack_program::scene::typed::{Problem, SlidingTask};
use viscotack_program::scene::units::parse_quantity;
use viscotack_program::scene::{Document, Scene, catalogue, read, sweep};

/// Values that have broken readers before, and pieces of scenes to put in wrong places.
#[rustfmt::skip]
const NASTY: &[&str] = &[
    "nan", "-nan", "inf", "-inf", "1e400", "-1e400", "1e308", "-1e308", "1.7976931348623157e308", "1e-308", "5e-324", "1e-400", "-0.0", "0", "0.0",
    "-1", "1", "2", "0.5", "1e100", "1e-100", "1e150", "1e-150", "1e200", "1e-200", "0.1", "3.5", "1e-9", "9223372036854775807",
    "-9223372036854775808", "99999999999999999999999999", "0xffffffffffffffffffffffff", "0b1", "0o7", "+1", "1_000", "1__0", "01", ".5", "5.",
    "true", "false", "1979-05-27", "07:32:00", "1979-05-27T07:32:00Z", "[]", "{}", "[[]]", "[{}]", "[1, 2]", "[1, \"2 m\"]", "\"\"", "\" \"", "\"x\"",
    "\"3 µm\"", "\"1e308 MPa\"", "\"1e308 GPa\"", "\"1e-320 s\"", "\"1e-330 fs\"", "\"nan Pa\"", "\"inf\"", "\"5 %\"", "\"1 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9\"",
    "\"1 √√m\"", "\"1 mmm\"", "\"1 /s\"", "\"1 1/s\"", "\"- 1 m\"", "\"1e99999999999999 m\"", "\"1e-2147483648 fs\"", "\"\\u0000\"", "\"😀 µ\\u202e\"", "\"a\\nb\"",
    "'literal'", "\"\"\"\nlong\n\"\"\"", "\"\\uD800\"", "\"si\"", "\"reduced\"", "\"crack.speed\"", "\"material.creep.0.fraction\"", "\"material.creep.9.fraction\"",
    "\"sweep.points\"", "\"fields.points\"", "\"material.creep\"", "\"accuracy\"", "\"crack.0\"", "\"closing\"", "\"schapery\"", "\"strain\"", "\"uniaxial\"", "\"constant\"", "\"adhesive\"", "[\"adhesive\", \"adhesiveless\"]", "\"sliding.speed\"", "-0.02",
    "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
    "{a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a=1}}}}}}}}}}}}}}}}}}}}}}}}}}",
    "a.b.c.d", "\u{feff}", "\u{0}", "=", ".", ",", "[", "]", "{", "}", "#", "\"", "'", "\n", "\r", "\t", "µ", "√", "²",
];

/// One way to spoil a text.
#[derive(Debug, Clone)]
enum Edit {
    Token(Index, &'static str),
    Number(Index, f64),
    Key(Index, &'static str),
    Byte(Index, u8),
    Delete(Index, usize),
    Insert(Index, &'static str),
    DoubleLine(Index),
    DropLine(Index),
    SwapLines(Index, Index),
    Cut(Index),
}

fn any_index() -> impl Strategy<Value = Index> {
    any::<Index>()
}

/// Any magnitude, also those whose squares overflow.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![(-1.0..1.0_f64, -320..309_i32).prop_map(|(mantissa, power)| mantissa * 10f64.powi(power)), any::<f64>(), -3.0..3.0_f64]
}

fn any_edit() -> impl Strategy<Value = Edit> {
    let keys: Vec<&'static str> = catalogue::keys().map(|key| key.path.rsplit(['.', ']']).next().unwrap()).collect();
    prop_oneof![
        6 => (any_index(), select(NASTY)).prop_map(|(at, new)| Edit::Token(at, new)),
        6 => (any_index(), any_number()).prop_map(|(at, new)| Edit::Number(at, new)),
        2 => (any_index(), select(keys)).prop_map(|(at, new)| Edit::Key(at, new)),
        1 => (any_index(), any::<u8>()).prop_map(|(at, byte)| Edit::Byte(at, byte)),
        1 => (any_index(), 1..40_usize).prop_map(|(at, length)| Edit::Delete(at, length)),
        1 => (any_index(), select(NASTY)).prop_map(|(at, new)| Edit::Insert(at, new)),
        1 => any_index().prop_map(Edit::DoubleLine),
        2 => any_index().prop_map(Edit::DropLine),
        1 => (any_index(), any_index()).prop_map(|(left, right)| Edit::SwapLines(left, right)),
        1 => any_index().prop_map(Edit::Cut),
    ]
}

/// Byte ranges of the words and quoted texts of a scene, comments left out; with `keys`, of those before an equals sign.
fn tokens(text: &str, keys: bool) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let code = line.split('#').next().unwrap();
        let mut start = None;
        let mut quoted = false;
        for (offset, character) in code.char_indices().chain([(code.len(), '\n')]) {
            let ends = if quoted { character == '\n' } else { character.is_whitespace() || "=,[]{}".contains(character) };
            if character == '"' {
                quoted = !quoted;
            }
            match (start, ends) {
                (None, false) => start = Some(offset),
                (Some(begin), true) => {
                    let is_key = code[offset.min(code.len())..].trim_start().starts_with('=');
                    if is_key == keys {
                        found.push(at + begin..at + offset.min(code.len()));
                    }
                    start = None;
                }
                _ => {}
            }
        }
        at += line.len();
    }
    found
}

fn character_boundary(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn spoilt(text: String, edit: &Edit) -> String {
    let replaced = |ranges: Vec<std::ops::Range<usize>>, at: &Index, new: &str| {
        let mut text = text.clone();
        if !ranges.is_empty() {
            text.replace_range(at.get(&ranges).clone(), new);
        }
        text
    };
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    match edit {
        _ if text.is_empty() => text,
        Edit::Token(at, new) => replaced(tokens(&text, false), at, new),
        Edit::Number(at, new) => replaced(tokens(&text, false), at, &format!("{new:e}")),
        Edit::Key(at, new) => replaced(tokens(&text, true), at, new),
        Edit::Byte(at, byte) => {
            let mut bytes = text.into_bytes();
            let place = at.index(bytes.len());
            bytes[place] = *byte;
            String::from_utf8_lossy(&bytes).into_owned()
        }
        Edit::Delete(at, length) => {
            let from = character_boundary(&text, at.index(text.len()));
            let to = character_boundary(&text, text.len().min(from + length)).max(from);
            [&text[..from], &text[to..]].concat()
        }
        Edit::Insert(at, new) => {
            let place = character_boundary(&text, at.index(text.len()));
            [&text[..place], new, &text[place..]].concat()
        }
        Edit::DoubleLine(at) => {
            let place = at.index(lines.len());
            lines.insert(place, lines[place]);
            lines.concat()
        }
        Edit::DropLine(at) => {
            lines.remove(at.index(lines.len()));
            lines.concat()
        }
        Edit::SwapLines(left, right) => {
            let (left, right) = (left.index(lines.len()), right.index(lines.len()));
            lines.swap(left, right);
            lines.concat()
        }
        Edit::Cut(at) => text[..character_boundary(&text, at.index(text.len()))].to_owned(),
    }
}

/// The shipped scenes with their folders.
fn scenes() -> &'static [(PathBuf, String)] {
    static SCENES: OnceLock<Vec<(PathBuf, String)>> = OnceLock::new();
    SCENES.get_or_init(|| {
        let read = |path: PathBuf| (path.parent().unwrap().to_owned(), std::fs::read_to_string(&path).unwrap());
        shipped_scenes().into_iter().map(read).collect()
    })
}

/// Every number of a scene, finite; by its debug text, so that no member can be forgotten.
fn assert_finite(scene: &Scene) {
    let mut plain = scene.clone();
    plain.title.clear();
    plain.material.name = None;
    plain.material.cautions.clear();
    for sweep in &mut plain.sweeps {
        assert!(sweep.values.iter().all(|value| value.is_finite()), "{}", sweep.key);
        sweep.values.clear();
        sweep.key.clear();
    }
    // The places of sweeps hold the text of the scene.
    plain.sweeps.clear();
    let text = format!("{plain:?}");
    assert!(!text.contains("inf") && !text.contains("NaN"), "{text}");
}

/// Sliding states solved so far in this process: a state is dear, so that only the first ones are solved.
static SLIDING_SOLVED: AtomicUsize = AtomicUsize::new(0);
const MOST_SLIDING: usize = 600;
/// The same of branches, of which one at other magnitudes may be scanned for a minute; all are read, planned and predicted.
static BRANCHES_SOLVED: AtomicUsize = AtomicUsize::new(0);
const MOST_BRANCHES: usize = 6;

/// Takes a document through everything but the printing; gives whether it was accepted.
fn taken_through(mut document: Document) -> bool {
    if let Err(error) = read::resolve_includes(&mut document) {
        assert!(!error.rendered().is_empty());
        return false;
    }
    let scene = match read::read(&document) {
        Ok(scene) => scene,
        Err(error) => {
            assert!(!error.to_string().is_empty() && error.rendered().contains(&error.to_string()));
            return false;
        }
    };
    assert_finite(&scene);
    let Ok(plan) = Plan::new(&scene) else { return false };
    for group in plan.groups() {
        assert!(group.value.is_finite(), "{group:?} of {scene:?}");
    }
    assert!(!plan.effects().is_empty() && !plan.method().is_empty() && !plan.columns().is_empty() && !plan.citations().is_empty());
    assert_eq!(plan.states(), sweep::states(&scene.sweeps));
    let _ = (plan.predicted_work(), plan.labels(), plan.problem());
    assert!(!plan.field_columns().is_empty());
    let few_fields = match &scene.problem {
        Problem::SteadyCrack(crack) => crack.fields.is_none_or(|fields| fields.points <= 300),
        // A history is dear, and one of other magnitudes may take minutes: random ones are stepped by `crack_sec_5_4_never_nan_never_hangs`, and
        // those of an indenter are integrated by `indentation_error_bars`.
        // A surface of other magnitudes may take many grids: `verify grammar` solves drawn ones.
        Problem::DelayedFracture(_) | Problem::Indentation(_) | Problem::Surface(_) => false,
        Problem::Sliding(sliding) => {
            let (solved, most) = match sliding.task {
                SlidingTask::Branch(_) => (&BRANCHES_SOLVED, MOST_BRANCHES),
                _ => (&SLIDING_SOLVED, MOST_SLIDING),
            };
            sliding.field_points.is_none_or(|points| points <= 400) && solved.fetch_add(1, Ordering::Relaxed) < most
        }
    };
    if few_fields {
        let rows = plan.solve(0, &[]);
        for row in &rows {
            let estimates = row.values.iter().flatten().chain(row.fields.iter().flat_map(|point| &point.values));
            for estimate in estimates {
                assert!(estimate.value.is_finite() && estimate.error.is_finite(), "{row:?} of {scene:?}");
            }
        }
        let _ = plan.validity(&rows);
    }
    true
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 30_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn spoilt_scenes(chosen in any_index(), edits in prop::collection::vec(any_edit(), 1..6)) {
        let (folder, text) = chosen.get(scenes());
        let text = edits.iter().fold(text.clone(), spoilt);
        if let Ok(document) = Document::parse("scene.toml", text, folder) {
            taken_through(document);
        }
    }

    #[test]
    fn scenes_of_other_magnitudes(chosen in any_index(), numbers in prop::collection::vec((any_index(), -200..200_i32), 1..8)) {
        // Edits that keep the scene well formed, so that most of them reach the plan.
        let (folder, text) = chosen.get(scenes());
        let text = numbers.iter().fold(text.clone(), |text, (at, power)| {
            let numeric = |range: &std::ops::Range<usize>| text[range.clone()].trim_matches('"').starts_with(|c: char| c.is_ascii_digit());
            let numbers: Vec<_> = tokens(&text, false).into_iter().filter(numeric).collect();
            let mut text = text.clone();
            if !numbers.is_empty() {
                text.replace_range(at.get(&numbers).clone(), &format!("1.25e{power}"));
            }
            text
        });
        if let Ok(document) = Document::parse("scene.toml", text, folder) {
            taken_through(document);
        }
    }

    #[test]
    fn settings(chosen in any_index(), keys in prop::collection::vec((select(catalogue::keys().map(|key| key.path).collect::<Vec<_>>()), 0..4_usize, select(NASTY)), 1..4)) {
        let (folder, text) = chosen.get(scenes());
        let mut document = Document::parse("scene.toml", text.clone(), folder).unwrap();
        for (key, index, value) in keys {
            let assignment = format!("{}={value}", key.replace("[]", &format!(".{index}")));
            if let Err(error) = document.set(&assignment) {
                prop_assert!(!error.rendered().is_empty());
            }
        }
        taken_through(document);
    }

    #[test]
    fn arbitrary_settings(assignment in prop_oneof![".*", "[a-z.0-9]{0,12}=.*", "crack\\.[a-z]{1,8}=[-+0-9.eE\"']{0,8}", "[.=a-z0-9 ]{0,300}"]) {
        let mut document = Document::parse("scene.toml", scenes()[0].1.clone(), Path::new(".")).unwrap();
        if document.set(&assignment).is_ok() {
            taken_through(document);
        }
    }

    #[test]
    fn arbitrary_texts(text in prop_oneof![".*", "(?s).*", "[\\[\\]{}=.,\"'#a-c0-9\n ]{0,200}", "([a-z]{1,6} = [-+0-9a-z.\"\\[\\]{}]{0,9}\n){0,9}"]) {
        if let Ok(document) = Document::parse("scene.toml", text, Path::new("/nowhere")) {
            taken_through(document);
        }
    }

    #[test]
    fn arbitrary_quantities(text in prop_oneof![".*", "[-+0-9._eE]{0,12} ?[a-zA-Zµμ°Å%√^*/·⋅²³⁻¹0-9 -]{0,16}", "[0-9]{1,3}e[-+]?[0-9]{1,12} [fpnµumckMGT]?(m|g|s|K|N|Pa|J|bar|min|h)([/ ^²-][a-z0-9]{0,3}){0,4}"]) {
        match parse_quantity(&text) {
            Ok(quantity) => prop_assert!(!quantity.value.is_nan(), "{text:?} is {quantity:?}"),
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }
}

/// Edits of the magnitudes must reach the solver in a good part, or the properties above prove little.
#[test]
fn every_shipped_scene_is_accepted_as_it_is() {
    for (folder, text) in scenes() {
        assert!(taken_through(Document::parse("scene.toml", text.clone(), folder).unwrap()), "{text}");
    }
}

#[test]
fn bottomless_texts_are_refused_and_not_followed() {
    for (open, close) in [("[", "]"), ("{a=", "}"), ("[{a=", "}]")] {
        for depth in [50, 1_000, 100_000] {
            let text = format!("title = {}1{}", open.repeat(depth), close.repeat(depth));
            if let Ok(document) = Document::parse("deep.toml", text, Path::new(".")) {
                assert!(!taken_through(document), "{open} {depth}");
            }
        }
    }
    for depth in [10, 1_000, 200_000] {
        let dotted = vec!["a"; depth].join(".");
        for text in [format!("{dotted} = 1"), format!("[{dotted}]\nb = 1"), format!("[[{dotted}]]\nb = 1")] {
            if let Ok(document) = Document::parse("deep.toml", text, Path::new(".")) {
                assert!(!taken_through(document), "{depth}");
            }
        }
        let mut document = Document::parse("scene.toml", scenes()[0].1.clone(), Path::new(".")).unwrap();
        if document.set(&format!("{dotted}=1")).is_ok() {
            assert!(!taken_through(document), "--set {depth}");
        }
    }
}
