//! The reference of all columns as a page in Markdown, made from the plans of small scenes: one scene for each kind of result, and one for each key that adds columns.

use super::Plan;
use crate::outcome::{Column, Layout};
use crate::scene::diagnostic::SourceText;
use crate::scene::key_reference::escaped;
use crate::scene::typed::Units;
use crate::scene::{Document, SceneError, read};
use std::fmt::Write as _;
use std::path::Path;

mod scenes;

use scenes::{Section, Variant};

/// What a scene of the reference gives.
struct Columns {
    si: Vec<Column>,
    reduced: Vec<Column>,
    layout: Option<Layout>,
    fields: [Vec<Column>; 2],
}

/// The page: one section for each kind of result.
///
/// # Errors
/// A scene of the reference that is not accepted: a defect of this program.
pub fn column_reference() -> Result<String, SceneError> {
    let mut page = String::from(
        "# Columns of a result\n\n\
         <!-- Made by `viscotack schema --columns`; do not edit. -->\n\n\
         Every number in `states.csv`, `path.csv` and `fields.csv`. A column `NAME` has its error bound beside it, in `NAME_error`, in the same unit. The second unit is that of scenes with \
         `units = \"reduced\"`. `accuracy` of the scene is the relative bound that you want. The meaning says what it is relative to, where that is not the value itself.\n",
    );
    for section in scenes::sections() {
        of_section(&mut page, &section)?;
    }
    Ok(page)
}

fn of_section(page: &mut String, section: &Section) -> Result<(), SceneError> {
    let _ = write!(page, "\n## {}\n\n{}\n\n**Bounds.** {}\n", section.title, section.about, section.bounds);
    let base = columns(&section.base)?;
    let all: Vec<usize> = (0..base.si.len()).collect();
    match &base.layout {
        Some(layout) => {
            table(page, "`states.csv`: the answer of a state", &base, &layout.states);
            table(page, "`path.csv`: instants and events on the way of a state", &base, &layout.path);
        }
        None => table(page, "`states.csv`", &base, &all),
    }
    let mut known: Vec<&'static str> = base.si.iter().map(|column| column.name).collect();
    for variant in &section.variants {
        let more = columns(variant)?;
        let new: Vec<usize> =
            (0..more.si.len()).filter(|&index| more.si.get(index).is_some_and(|column| !known.contains(&column.name))).collect();
        known.extend(new.iter().filter_map(|&index| more.si.get(index)).map(|column| column.name));
        if !new.is_empty() {
            table(page, variant.adds, &more, &new);
        }
    }
    let [si, reduced] = base.fields;
    if si.len() > 1 {
        let fields = Columns { si, reduced, layout: None, fields: Default::default() };
        let all: Vec<usize> = (0..fields.si.len()).collect();
        table(page, "`fields.csv`, if the scene asks for fields", &fields, &all);
    }
    Ok(())
}

fn table(page: &mut String, heading: &str, columns: &Columns, places: &[usize]) {
    let _ = write!(page, "\n### {heading}\n\n| column | unit | reduced unit | meaning |\n|---|---|---|---|\n");
    for (si, reduced) in places.iter().filter_map(|&place| columns.si.get(place).zip(columns.reduced.get(place))) {
        let _ = writeln!(page, "| `{}` | {} | {} | {} |", si.name, escaped(&si.unit), escaped(&reduced.unit), escaped(si.meaning));
    }
}

/// The columns of a scene in both systems of units: its numbers stay as they are, since a plan solves nothing.
fn columns(variant: &Variant) -> Result<Columns, SceneError> {
    let mut document = Document::parse("scene of the reference", variant.scene.clone(), Path::new("."))?;
    if let Some((name, text)) = variant.file {
        document.provide(vec![(name.to_owned(), SourceText::new(name, text.to_owned()))]);
    }
    read::resolve_includes(&mut document)?;
    let mut scene = read::read(&document)?;
    let plan = |scene: &_| Plan::new(scene).map_err(|refusal| SceneError::general(refusal.to_string()));
    let si = plan(&scene)?;
    scene.units = Units::Reduced;
    let reduced = plan(&scene)?;
    Ok(Columns { layout: si.layout(), fields: [si.field_columns(), reduced.field_columns()], si: si.columns(), reduced: reduced.columns() })
}
