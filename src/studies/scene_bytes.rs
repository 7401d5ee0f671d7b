//! What becomes of any bytes that are given as a scene: the way that the mutation test and the fuzzer take.

use crate::plan::Plan;
use crate::scene::{Document, SceneError, read};
use std::path::Path;

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
