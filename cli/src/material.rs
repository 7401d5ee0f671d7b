//! `viscotack material`: a material by itself, its fit, curves, and the file that scenes include.

use super::{Failure, print, print_json};
use std::path::Path;
use viscotack_program::outcome::folder::{writable, write_whole};
use viscotack_program::outcome::plot;
use viscotack_program::plan::material::{MaterialReport, material_file, screen, summary, tables};
use viscotack_program::scene::read::decks::recognised_file;
use viscotack_program::scene::typed::Units;
use viscotack_program::scene::{Document, SceneError, read};

/// What the command is asked.
pub(super) struct Asked<'a> {
    pub(super) file: &'a Path,
    pub(super) sets: &'a [String],
    pub(super) accuracy: Option<&'a str>,
    pub(super) out: Option<&'a Path>,
    pub(super) force: bool,
    pub(super) json: bool,
}

pub(super) fn material(asked: &Asked<'_>) -> Result<u8, Failure> {
    viscotack_program::threads::prepare(None);
    // A folder that is in the way is known before anything is fitted.
    asked.out.map_or(Ok(()), |target| writable(target, asked.force))?;
    let report = report(asked)?;
    let code = if report.met() { 0 } else { 4 };
    let written = asked.out.map(|target| write(&report, target, asked.force).map(|names| (target, names))).transpose();
    let printed = if asked.json {
        print_json(|out| write!(out, "{:#}", summary(&report)))
    } else {
        print(&screen(&report)).and_then(|()| match &written {
            Ok(Some((target, names))) => {
                let folder = viscotack_program::terminal_text::name(target);
                print(&format!(
                    "\nwrote      {folder}: {}\nto use it  [material] file = \"{folder}/material.toml\" in a scene, with poisson_ratio unless the file has it\n",
                    names.join(", ")
                ))
            }
            Ok(None) => print("\n(nothing written; add --out DIR for material.toml, tables and plots)\n"),
            Err(_) => Ok(()),
        })
    };
    written?;
    printed?;
    Ok(code)
}

/// Whether a file is a table: by its name, or because its header names the moduli or the compliance of a material.
fn is_table(path: &Path) -> bool {
    let named = |word: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(word));
    named("csv") || (!named("toml") && read::holds_material_table(path))
}

fn report(asked: &Asked<'_>) -> Result<MaterialReport, SceneError> {
    let name = asked.file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    // A deck is known by what it holds, and so is a table of another name than .csv.
    let csv = asked.file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"));
    let deck = if csv { None } else { recognised_file(asked.file) };
    let is_data = deck.is_none() && is_table(asked.file);
    let mut document = if is_data || deck.is_some() {
        let key = deck.unwrap_or("data");
        let text = format!("[material]\n{key} = {}\n", viscotack_program::scene::document::toml_text(&name));
        Document::parse(&asked.file.display().to_string(), text, asked.file.parent().unwrap_or_else(|| Path::new(".")))?
    } else {
        Document::load(asked.file)?
    };
    // A file is named before files are read, any other key is set after.
    let named = |set: &&String| ["material.file", "material.data", "material.shift"].iter().any(|key| set.trim_start().starts_with(key));
    for set in asked.sets.iter().filter(named) {
        document.set(set)?;
    }
    read::resolve_material(&mut document)?;
    for set in asked.sets.iter().filter(|set| !named(set)) {
        document.set(set)?;
    }
    if let Some(accuracy) = asked.accuracy {
        let of = |path: &str| document.root.at(path).is_some();
        let key = if of("material.data") {
            "material.fit_error"
        } else if of("material.power_law") || of("material.fractional_zener") {
            "material.expansion.accuracy"
        } else {
            return Err(SceneError::general(
                "`--accuracy` belongs to data or to a law; this material is given by its terms, which are exact",
            ));
        };
        document.set(&format!("{key}={accuracy}"))?;
    }
    read::resolve_material(&mut document)?;
    let material = read::read_material(&document)?;
    let stem = asked.file.file_stem().map_or_else(|| "material".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let title = material.name.clone().unwrap_or(stem).replace(viscotack_program::terminal_text::is_harmful, " ");
    Ok(MaterialReport { material, units: Units::of(&document.root), title })
}

/// Writes all files in one step; gives their names.
fn write(report: &MaterialReport, target: &Path, force: bool) -> Result<Vec<String>, Failure> {
    let wrong = |what: &str, error: &dyn std::fmt::Display| Failure::Wrong(format!("error: {what} cannot be written: {error}\n"));
    let mut files = vec![
        ("summary.json".to_owned(), format!("{:#}\n", summary(report)).into_bytes()),
        ("material.toml".to_owned(), material_file(report).into_bytes()),
    ];
    files.extend(tables(report).map_err(|error| wrong("a table", &error))?);
    for (stem, figure) in report.figures() {
        match plot::svg(&figure) {
            Ok(svg) => {
                files.push((format!("{stem}.svg"), svg.into_bytes()));
                files.push((format!("{stem}.png"), plot::png(&figure).map_err(|error| wrong(&stem, &error))?));
            }
            Err(plot::PlotError::NotBuilt) => {}
            Err(error) => return Err(wrong(&stem, &error)),
        }
    }
    write_whole(target, force, "material", &files)?;
    Ok(files.into_iter().map(|(name, _)| name).collect())
}
