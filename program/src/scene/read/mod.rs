//! From a checked document to a typed scene: what is required, what excludes what, and which numbers belong together.

mod attraction;
pub(super) mod cache;
mod column_names;
mod column_units;
mod counter_body;
mod crack;
mod crack_history;
pub mod decks;
mod fit;
mod fit_data;
mod force_curve_header;
pub mod history;
mod include;
mod indentation;
mod indentation_at_a_distance;
mod material;
mod material_choice;
mod material_columns;
mod material_data;
mod material_draws;
mod material_fractions;
mod material_rows;
mod material_shift;
mod material_solid;
mod material_source;
mod material_strain;
mod material_table;
mod material_taking;
mod measured_table;
mod periodic;
mod record;
mod record_corners;
mod relative;
mod repeat;
mod section;
mod shape_points;
mod shift_table;
mod sliding;
mod sliding_branch;
mod speed_table;
mod standard_test;
mod surface;
mod surface_points;
mod table_columns;
mod until;
mod works;

use super::catalogue::Range;
use super::check::{Units, check, check_changed};
use super::diagnostic::{Place, SceneError, nearest};
use super::document::{Document, Value};
use super::plausible;
use super::sweep;
use super::typed::{Picture, Problem, Scene, SceneMaterial};
use section::Section;

/// Tables that name a problem; a scene holds exactly one of them.
const PROBLEMS: [&str; 3] = ["crack", "sliding", "indentation"];

/// α where a scene names none: with it the theory of cracks and Persson and Brener's have the same limits.
const DEFAULT_FACTOR: f64 = std::f64::consts::FRAC_1_PI;
/// Wanted accuracy of a crack under a history, and of an indentation, where a scene names none.
const DELAYED_ACCURACY: f64 = 1e-4;
const INDENTATION_ACCURACY: f64 = 1e-3;
/// The same of a line and of a surface that act at a distance.
const SURFACE_ACCURACY: [f64; 2] = [1e-4, 1e-2];
/// Points of a field where a scene names no number.
const DEFAULT_FIELD_POINTS: f64 = 200.0;

/// Replaces a material file by its content and reads the tables of a history; to be done before `--set`s, sweeps and [`read`].
///
/// # Errors
/// A file that cannot be read, or a key that is given twice.
pub fn resolve_includes(document: &mut Document) -> Result<(), SceneError> {
    resolve_material(document)?;
    speed_table::resolve(document)?;
    measured_table::resolve(document)
}

/// Replaces a material file by its content and reads what the material names: all that [`read_material`] needs.
///
/// # Errors
/// A file that cannot be read, or a key that is given twice.
pub fn resolve_material(document: &mut Document) -> Result<(), SceneError> {
    include::resolve(document)?;
    material_table::resolve(document)
}

/// States of a sweep that are tried before a scene is called wrong.
const MOST_TRIES: usize = 1000;

/// Reads a scene, without its sweep being carried out: a swept number stands at its first value that fits the rest of the scene.
///
/// # Errors
/// The first thing that is wrong, at the first values.
pub fn read(document: &Document) -> Result<Scene, SceneError> {
    check(&document.root)?;
    if let Some(fit) = document.root.get("fit") {
        let message = "the scene has a table [fit], which only `viscotack fit` carries out";
        return Err(SceneError::at(&fit.place, message, "this table").help("type: viscotack fit SCENE --out DIR"));
    }
    let units = Units::of(&document.root);
    let sweeps = sweep::read(&document.root, units)?;
    let state = |number: usize| read_varied(document.clone(), &sweeps, number);
    // A value that contradicts the scene is a row that says so, wherever in the sweep it stands; a scene without any state is wrong.
    let mut scene = state(0).or_else(|wrong| (1..sweep::states(&sweeps).min(MOST_TRIES)).find_map(|n| state(n).ok()).ok_or(wrong))?;
    for caution in sweeps.iter().flat_map(|sweep| plausible::of_sweep(&document.root, sweep)) {
        // A swept number stands in the scene, too, and is asked about once.
        if !scene.cautions.contains(&caution) {
            scene.cautions.push(caution);
        }
    }
    scene.sweeps = sweeps;
    Ok(scene)
}

/// Reads one state of a scene, ignoring its sweep.
///
/// # Errors
/// The first thing that is wrong.
pub fn read_state(document: &Document) -> Result<Scene, SceneError> {
    check(&document.root)?;
    read_checked(document)
}

/// Puts the values of one state of a sweep into a document whose scene was read before, and reads that state: nothing but these values is checked again.
///
/// # Errors
/// The first thing that is wrong.
pub fn read_varied(mut document: Document, sweeps: &[sweep::Sweep], state: usize) -> Result<Scene, SceneError> {
    // A key that only the sweep gives stands nowhere else.
    let added: Vec<&sweep::Sweep> = sweeps.iter().filter(|swept| document.root.at(&swept.key).is_none()).collect();
    for (swept, index) in sweeps.iter().zip(sweep::indices(sweeps, state)) {
        swept.put(&mut document, index)?;
    }
    check_changed(&document.root, sweeps.iter().map(|sweep| sweep.key.as_str()))?;
    read_checked(&document).map_err(|error| added.iter().fold(error, |error, swept| error.put_by(&swept.key, swept.place(), "sweep.key")))
}

fn read_checked(document: &Document) -> Result<Scene, SceneError> {
    let root = &document.root;
    let units = Units::of(root);
    let top = Section::top(root, units);
    let file = std::path::Path::new(root.place.source.name());
    let stem = || file.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let mut material = material::read(&top, document)?;
    material.notes.extend(document.notes().iter().cloned());
    let named = the_problem(&top)?;
    if named == "crack" {
        attraction::without(&top, "a crack")?;
    } else if !attraction::is_given(&top) {
        attraction::without(&top, "a scene without `adhesion.law` or `adhesion.table`")?;
    }
    let problem = match named {
        "crack" | "sliding" if root.get("test").is_some() => {
            top.without(&["test"], "an indenter")?;
            return Err(top.missing("indentation"));
        }
        "crack" if root.get("history").is_some() => Problem::DelayedFracture(crack_history::read(&top, document, &material)?),
        "crack" => Problem::SteadyCrack(crack::read(&top, &material)?),
        "indentation" => Problem::Indentation(indentation::read(document, &top, &material)?),
        _ => {
            top.without(&["history"], "a crack or a sphere")?;
            if surface::is_meant(&top) {
                Problem::Surface(surface::read(document, &top, &material)?)
            } else {
                Problem::Sliding(sliding::read(&top, &material)?)
            }
        }
    };
    // Wanted accuracy where a scene names none.
    let default_accuracy = match &problem {
        Problem::SteadyCrack(_) => 1e-9,
        Problem::Sliding(_) => 1e-6,
        Problem::Surface(sliding) if sliding.surface.profile.is_line() => SURFACE_ACCURACY[0],
        Problem::Surface(_) => SURFACE_ACCURACY[1],
        Problem::DelayedFracture(_) => DELAYED_ACCURACY,
        Problem::Indentation(_) => INDENTATION_ACCURACY,
    };
    let owner = match &problem {
        Problem::SteadyCrack(_) => "a steady crack",
        Problem::DelayedFracture(_) => "a crack under a history",
        Problem::Sliding(_) => "a sliding contact",
        Problem::Surface(_) => "a sliding surface",
        Problem::Indentation(_) => "an indentation",
    };
    let scene = Scene {
        // One line, whatever the text or the file's name holds.
        title: top.text("title").map_or_else(stem, str::to_owned).replace(crate::terminal_text::is_harmful, " "),
        units,
        accuracy: top.number("accuracy")?.unwrap_or(default_accuracy),
        material,
        problem,
        sweeps: Vec::new(),
        cautions: plausible::cautions(root),
        plots: if root.get("plots").is_some() {
            top.texts("plots").into_iter().map(|word| if word == "png" { Picture::Png } else { Picture::Svg }).collect()
        } else {
            vec![Picture::Svg]
        },
    };
    top.all_read(&["units", "sweep", "latin_hypercube"], owner)?;
    Ok(scene)
}

/// Reads the material alone, of a scene or of a material file.
///
/// # Errors
/// The first thing that is wrong with it.
pub fn read_material(document: &Document) -> Result<SceneMaterial, SceneError> {
    check(&document.root)?;
    let top = Section::top(&document.root, Units::of(&document.root));
    let material = material::read(&top, document)?;
    top.table("material").map_or(Ok(()), |table| table.all_read(&[], "a material"))?;
    Ok(material)
}

pub use fit::read_fit;

/// Whether a file is delimited text whose header names a modulus or a compliance with a known name.
#[must_use]
pub fn holds_material_table(path: &std::path::Path) -> bool {
    super::delimited::open(path, "").is_ok_and(|source| material_rows::holds_material(&source))
}

/// Reads the table of `material.data` as rows in SI units, before a series is fitted to them; none if the material has no table.
///
/// # Errors
/// The first thing that is wrong with it.
pub fn read_material_table(document: &Document) -> Result<Option<super::typed::MaterialData>, SceneError> {
    check(&document.root)?;
    let top = Section::top(&document.root, Units::of(&document.root));
    let Some(table) = top.table("material").filter(|table| table.node().get("data").is_some()) else { return Ok(None) };
    material_table::material_data(&table, document, table.number("poisson_ratio")?).map(Some)
}

/// The one problem table of a scene.
fn the_problem(top: &Section<'_>) -> Result<&'static str, SceneError> {
    let given: Vec<&'static str> = PROBLEMS.into_iter().filter(|name| top.node().get(name).is_some()).collect();
    match given.as_slice() {
        [one] => Ok(one),
        [] => {
            let known = PROBLEMS.map(|name| format!("[{name}]")).join(", ");
            Err(SceneError::at(&top.end(), "the scene names no problem", "the scene ends here").help(format!("add one of: {known}")))
        }
        [_, second, ..] => {
            let place = top.key_place(second);
            Err(SceneError::at(&place, format!("the scene names more than one problem: {}", given.join(", ")), "leave one out"))
        }
    }
}

/// Refuses the keys of a process zone that only follow from a cohesive stress, where a length is given.
fn without_cohesive_stress(zone: &Section<'_>) -> Result<(), SceneError> {
    for key in ["factor", "law"] {
        if zone.node().get(key).is_some() {
            let message = format!("`{}` belongs to a cohesive stress, but a length is given", zone.full(key));
            return Err(zone.wrong(key, message, "leave it out, or give cohesive_stress instead of length"));
        }
    }
    Ok(())
}

/// The place of a document's last byte: where something is missing.
fn end_of(place: &Place) -> Place {
    let end = place.source.text().trim_end().len();
    // The last character, however many bytes it has.
    let start = place.source.text().get(..end).and_then(|text| text.char_indices().next_back()).map_or(0, |(start, _)| start);
    Place { source: place.source.clone(), span: start..end }
}

/// The words after "did you mean" for a path, if a known one is near.
#[must_use]
pub fn nearest_number(path: &str) -> Option<&'static str> {
    nearest(path, super::catalogue::keys().filter(|key| is_number(key)).map(|key| key.path))
}

/// Whether a key takes a number that may be swept.
#[must_use]
pub fn is_number(key: &super::catalogue::Key) -> bool {
    matches!(key.kind, super::catalogue::Kind::Number { .. } | super::catalogue::Kind::Count { .. })
}

/// The range of a swept key, for checks of its values.
#[must_use]
pub fn range_of(key: &super::catalogue::Key) -> Range {
    match key.kind {
        super::catalogue::Kind::Number { range, .. } => range,
        _ => Range::Finite,
    }
}

/// Whether a table stands in the document.
#[must_use]
pub fn has_table(document: &super::document::Node, path: &str) -> bool {
    path.is_empty() || document.at(path).is_some_and(|node| matches!(node.value, Value::Table(_)))
}
