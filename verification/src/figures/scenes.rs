//! The scenes behind panels, as files that `viscotack run` solves: a source that is a scene is a file, with comments on how the panels draw it.

use super::manifest::{Condition, CurveEntry, FigureEntry, Manifest, ManifestError, PanelEntry, SourceEntry};
use super::quantity::Quantity;
use super::run::{FiguresError, Options, selected, uses};
use super::source::Source;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Write as _;
use std::path::Path;
use viscotack_program::outcome::folder::FolderError;
use viscotack_program::regular_file;
use viscotack_program::terminal_text::name;

/// No scene that is there already is read beyond this (bytes).
const LARGEST: u64 = 1 << 24;

/// What a panel is drawn from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PanelScenes {
    /// Figure and letter, as `3.2a`.
    pub id: String,
    /// Names of its scene files.
    pub files: Vec<String>,
    /// Its sources that are no scenes, each with the reason.
    pub no_scene: Vec<(String, &'static str)>,
}

impl PanelScenes {
    /// One line: the files, and why other curves have none.
    #[must_use]
    pub fn line(&self) -> String {
        let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
        for (source, reason) in &self.no_scene {
            match reasons.iter_mut().find(|(known, _)| known == reason) {
                Some((_, sources)) => sources.push(source),
                None => reasons.push((reason, vec![source])),
            }
        }
        let none: Vec<String> = reasons.iter().map(|(reason, sources)| format!("no scene for {}: {reason}", sources.join(", "))).collect();
        let parts: Vec<String> = self.files.iter().cloned().chain(none).collect();
        format!("{:<6} {}\n", self.id, parts.join("; "))
    }
}

/// Writes the scenes of the panels that are asked for, computes nothing, and says what each panel is drawn from.
///
/// # Errors
/// A figure that is not in the manifest, or a file that is there with another text.
pub fn write_scenes(manifest: &Manifest, options: &Options, folder: &Path) -> Result<Vec<PanelScenes>, FiguresError> {
    let (mut texts, mut panels_of_all) = (BTreeMap::new(), Vec::new());
    for (figure, panels) in selected(manifest, options)? {
        for panel in &panels {
            let id = format!("{}{}", figure.id, panel.id);
            let (mut files, mut no_scene) = (Vec::new(), Vec::new());
            for source in figure.source.iter().filter(|source| uses(panel, &source.name)) {
                match &source.form {
                    Some(form) => no_scene.push((source.name.clone(), form.no_scene())),
                    None => {
                        let file = format!("{}_{}.toml", figure.id, source.name);
                        texts.insert(file.clone(), text_of(manifest, figure, source)?);
                        files.push(file);
                    }
                }
            }
            panels_of_all.push(PanelScenes { id, files, no_scene });
        }
    }
    fs::create_dir_all(folder).map_err(FolderError::io(folder))?;
    let mut fresh = Vec::new();
    for (file, text) in &texts {
        let path = folder.join(file);
        if fs::symlink_metadata(&path).is_err() {
            fresh.push((path, text));
        } else if regular_file::read(&path, LARGEST).ok().as_deref() != Some(text.as_bytes()) {
            let why = "it holds another text than the scene of the figure".to_owned();
            return Err(FiguresError::Scenes { path: name(&path), why });
        }
    }
    for (path, text) in fresh {
        File::create_new(&path).and_then(|mut file| file.write_all(text.as_bytes())).map_err(FolderError::io(&path))?;
    }
    Ok(panels_of_all)
}

/// The file of a source: title, comments, scene.
fn text_of(manifest: &Manifest, figure: &FigureEntry, source: &SourceEntry) -> Result<String, ManifestError> {
    let scene = Source::new(manifest, &figure.id, source, "")?.scene_text()?;
    let mut text = format!("# Behind Figure {} of the thesis (Sec {}).\n", figure.id, figure.section);
    text.push_str(&format!("# Stated there: {}\n# Chosen here: {}\n#\n", figure.stated, figure.chosen));
    if source.fields {
        text.push_str("# Its curves are in `fields.csv`, which `viscotack run SCENE --out DIR` writes.\n");
    }
    for panel in figure.panel.iter().filter(|panel| uses(panel, &source.name)) {
        let inset = panel.inset.as_ref();
        let of_inset = inset.map(|inset| (&inset.x.of, &inset.y.of, if inset.curves.is_empty() { &panel.curves } else { &inset.curves }));
        for (x, y, curves) in [Some((&panel.x.of, &panel.y.of, &panel.curves)), of_inset].into_iter().flatten() {
            for curve in curves.iter().filter(|curve| curve.source == source.name || curve.also.contains(&source.name)) {
                text.push_str(&comment(figure, panel, curve, (x, y)));
            }
        }
    }
    text.push_str(&format!(
        "title = {}\n",
        viscotack_program::scene::document::toml_text(&format!("Figure {}: {}", figure.id, figure.title))
    ));
    Ok(text + &scene)
}

/// How a panel draws the rows.
fn comment(figure: &FigureEntry, panel: &PanelEntry, curve: &CurveEntry, (x, y): (&Quantity, &Quantity)) -> String {
    let (x, y) = (curve.x.as_ref().unwrap_or(x), curve.y.as_ref().unwrap_or(y));
    let mut text = format!("# {}{}: {} against {}", figure.id, panel.id, y.words(), x.words());
    if let Some(each) = &curve.each {
        text.push_str(&format!(", a curve for each {each}"));
    }
    for (column, condition) in &curve.when {
        text.push_str(&match condition {
            Condition::Word(word) => format!(", {column} = {word}"),
            Condition::Number(value) => format!(", {column} = {value}"),
            Condition::Range(range) => {
                let bound = |sign: &str, bound: Option<f64>| bound.map_or_else(String::new, |bound| format!(", {column} {sign} {bound}"));
                bound(">", range.above) + &bound("<", range.below)
            }
        });
    }
    for (word, column) in [("up to", &curve.until_largest), ("from", &curve.from_largest)] {
        if let Some(column) = column {
            text.push_str(&format!(", {word} the row of the largest {column}"));
        }
    }
    text + "\n"
}
