//! A scene from a file or standard input and `--set`s, read and typed.

use super::SceneArguments;
use viscotack_program::scene::typed::Scene;
use viscotack_program::scene::{Document, SceneError, read};

/// A scene, as a document to vary and as a typed whole.
pub(super) struct SceneSource {
    pub(super) document: Document,
    pub(super) scene: Scene,
    /// The text of the file, headed by the `--set`s as comments.
    pub(super) text: String,
}

impl SceneSource {
    pub(super) fn load(arguments: &SceneArguments) -> Result<Self, SceneError> {
        let (document, text) = document(arguments)?;
        let scene = read::read(&document)?;
        Ok(Self { document, scene, text })
    }
}

/// The document of a scene with its files and `--set`s, and its text.
pub(super) fn document(arguments: &SceneArguments) -> Result<(Document, String), SceneError> {
    let mut document = if arguments.scene.as_os_str() == "-" {
        Document::from_stream("standard input", std::io::stdin().lock())?
    } else {
        Document::load(&arguments.scene)?
    };
    let mut text: String = arguments.sets.iter().map(|set| format!("# --set {}\n", set.replace(['\n', '\r'], " "))).collect();
    text.push_str(document.root.place.source.text());
    // Another material file is named before files are read, any other key is set after.
    let (files, others): (Vec<&String>, Vec<&String>) =
        arguments.sets.iter().partition(|set| ["material.file", "material.data"].iter().any(|key| set.trim_start().starts_with(key)));
    for set in files {
        document.set(set)?;
    }
    read::resolve_includes(&mut document)?;
    for set in others {
        document.set(set)?;
    }
    // A whole [material] given by --set may name a file, too.
    read::resolve_includes(&mut document)?;
    Ok((document, text))
}
