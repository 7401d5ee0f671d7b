//! A scene from a file or standard input and `--set`s, read and typed.

use super::SceneArguments;
use std::path::Path;
use viscotack_program::outcome::gather::{InputFile, Inputs};
use viscotack_program::scene::delimited::decode::Encoding;
use viscotack_program::scene::diagnostic::SourceText;
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

    /// The scene of a shard, from the texts that it was read from.
    pub(super) fn of_inputs(inputs: &Inputs) -> Result<Self, SceneError> {
        let mut document = Document::parse(&inputs.name, inputs.text.clone(), Path::new("."))?;
        let files = inputs.files.iter().map(|file| {
            let encoding = Encoding::named(&file.encoding).unwrap_or(Encoding::Utf8);
            (file.name.clone(), SourceText::decoded(&file.name, file.text.clone(), encoding))
        });
        document.provide(files.collect());
        let text = completed(&mut document, &inputs.sets)?;
        let scene = read::read(&document)?;
        Ok(Self { document, scene, text })
    }

    /// All that the scene was read from.
    pub(super) fn inputs(&self, sets: &[String]) -> Inputs {
        let source = &self.document.root.place.source;
        let file = |(name, source): (&str, &SourceText)| InputFile {
            name: name.to_owned(),
            encoding: source.encoding().name().to_owned(),
            text: source.text().to_owned(),
        };
        Inputs {
            name: source.name().to_owned(),
            text: source.text().to_owned(),
            sets: sets.to_vec(),
            files: self.document.files().map(file).collect(),
        }
    }
}

/// The document of a scene with its files and `--set`s, and its text.
pub(super) fn document(arguments: &SceneArguments) -> Result<(Document, String), SceneError> {
    let mut document = if arguments.scene.as_os_str() == "-" {
        Document::from_stream("standard input", std::io::stdin().lock())?
    } else {
        Document::load(&arguments.scene)?
    };
    let text = completed(&mut document, &arguments.sets)?;
    Ok((document, text))
}

/// Reads the files that a document names and puts values into it; gives its text, headed by the `--set`s.
fn completed(document: &mut Document, sets: &[String]) -> Result<String, SceneError> {
    let mut text: String = sets.iter().map(|set| format!("# --set {}\n", set.replace(['\n', '\r'], " "))).collect();
    text.push_str(document.root.place.source.text());
    // Another material file is named before files are read, any other key is set after.
    let (files, others): (Vec<&String>, Vec<&String>) =
        sets.iter().partition(|set| ["material.file", "material.data"].iter().any(|key| set.trim_start().starts_with(key)));
    for set in files {
        document.set(set)?;
    }
    read::resolve_includes(document)?;
    for set in others {
        document.set(set)?;
    }
    // A whole [material] given by --set may name a file, too.
    read::resolve_includes(document)?;
    Ok(text)
}
