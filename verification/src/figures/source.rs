//! Computing a source: a scene is read, planned and solved as by `viscotack run`; a closed form is evaluated.

use super::manifest::{Manifest, ManifestError, SourceEntry};
use super::table::Table;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::time::Instant;
use thiserror::Error;
use viscotack::refusal::Refusal;
use viscotack_program::plan::{self, Plan, RunError};
use viscotack_program::scene::{Document, SceneError, read, typed::Scene};

/// Why a source has no table.
#[derive(Debug, Error)]
pub enum SourceError {
    /// The scene is wrong.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The scene cannot be run.
    #[error("{0}")]
    Run(#[from] RunError),
    /// A closed form refuses its numbers.
    #[error("{0}")]
    Refused(#[from] Refusal),
    /// Nothing came out.
    #[error("no row came out")]
    Empty,
}

/// A source with everything that its table depends on.
#[derive(Debug, Clone)]
pub(super) struct Source {
    /// Figure and name, for messages.
    pub(super) place: String,
    entry: SourceEntry,
    text: String,
    /// SHA-256 of the entry, and of what the program is.
    pub(super) key: String,
}

impl Source {
    pub(super) fn new(manifest: &Manifest, figure: &str, entry: &SourceEntry, program: &str) -> Result<Self, ManifestError> {
        let place = format!("figure {figure}, source `{}`", entry.name);
        if entry.form.is_some() == entry.scene.is_some() {
            let problem = "needs either a `scene` or a `form`".to_owned();
            return Err(ManifestError::Contradiction { place, problem });
        }
        let mut text = String::new();
        if let Some(base) = &entry.base {
            let known = || manifest.base.keys().map(String::as_str).collect::<Vec<_>>().join(", ");
            let unknown = || ManifestError::Unknown { place: place.clone(), what: "base", name: base.clone(), known: known() };
            text.push_str(manifest.base.get(base).ok_or_else(unknown)?);
        }
        text.push_str(entry.scene.as_deref().unwrap_or_default());
        let mut hash = Sha256::new();
        for part in [program, text.as_str(), &entry.set.join("\n"), &format!("{} {:?}", entry.fields, entry.form)] {
            hash.update(part.as_bytes());
            hash.update([0]);
        }
        let key = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { place, entry: entry.clone(), text, key })
    }

    fn scene(&self) -> Result<(Document, Scene), SceneError> {
        let mut document = Document::parse(&self.place, self.text.clone(), Path::new("."))?;
        for set in &self.entry.set {
            document.set(set)?;
        }
        let scene = read::read(&document)?;
        Ok((document, scene))
    }

    /// The text of the scene, with the values of `set` in their places.
    pub(super) fn scene_text(&self) -> Result<String, ManifestError> {
        let wrong = |problem: String| ManifestError::Contradiction { place: self.place.clone(), problem };
        let mut text = self.text.clone();
        for set in &self.entry.set {
            let (key, value) = set.split_once('=').ok_or_else(|| wrong(format!("`{set}` has no `=`")))?;
            let (key, value) = (key.trim(), value.trim());
            let document = Document::parse(&self.place, text.clone(), Path::new(".")).map_err(|error| wrong(error.to_string()))?;
            match document.root.at(key) {
                Some(node) => text.replace_range(node.place.span.clone(), value),
                None => return Err(wrong(format!("`{set}` sets a key that the scene does not write"))),
            }
        }
        Ok(text)
    }

    /// What it will cost, to start the longest first: predicted linear systems and balances.
    pub(super) fn cost(&self) -> u64 {
        let planned = self.scene().ok().and_then(|(_, scene)| Plan::new(&scene).ok());
        planned.map_or(0, |plan| {
            let work = plan.predicted_work();
            work.linear_solves + work.closure_evaluations
        })
    }

    /// Its table.
    pub(super) fn compute(&self) -> Result<Table, SourceError> {
        let start = Instant::now();
        let mut table = match &self.entry.form {
            Some(form) => form.table()?,
            None => {
                let (document, scene) = self.scene()?;
                let outcome = plan::run(&document, &scene, Vec::new(), None, &|_| ())?;
                Table::of_outcome(&outcome, self.entry.fields)?
            }
        };
        table.seconds = start.elapsed().as_secs_f64();
        Ok(table)
    }
}
