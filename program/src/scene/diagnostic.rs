//! One error about a scene: where, what, what is allowed.

use super::delimited::decode::{Encoding, line_at};
use super::frame::{Frame, Framed};
use crate::terminal_text;
use miette::{GraphicalReportHandler, GraphicalTheme};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A text that keys were read from: a scene file, a material file, or one `--set` of the command line.
#[derive(Debug, Clone)]
pub struct SourceText {
    inner: Arc<(String, String)>,
    encoding: Encoding,
    /// No line of it is shown: it is neither a scene, nor a table, nor a deck.
    hidden: bool,
}

impl SourceText {
    /// A named text.
    #[must_use]
    pub fn new(name: &str, text: String) -> Self {
        Self::decoded(name, text, Encoding::Utf8)
    }

    /// A named text that was bytes of some encoding.
    #[must_use]
    pub fn decoded(name: &str, text: String, encoding: Encoding) -> Self {
        Self { inner: Arc::new((name.to_owned(), text)), encoding, hidden: false }
    }

    /// The same text, of which errors show no line.
    #[must_use]
    pub(super) fn hidden(&self) -> Self {
        Self { hidden: true, ..self.clone() }
    }

    /// How its bytes were read.
    #[must_use]
    pub const fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// The name given to it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.inner.0
    }

    /// Its content.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.inner.1
    }
}

/// A place in a text.
#[derive(Debug, Clone)]
pub struct Place {
    /// The text.
    pub source: SourceText,
    /// Byte range in it.
    pub span: Range<usize>,
}

impl Place {
    /// Line and column of its begin, from 1.
    fn line_and_column(&self) -> [usize; 2] {
        let text = self.source.text();
        let before = text.get(..self.span.start.min(text.len())).unwrap_or("");
        let line = before.rsplit(['\n', '\r']).next().unwrap_or("");
        [line_at(text, before.len()), 1 + line.chars().count()]
    }
}

/// What is wrong with a scene: one sentence, the place, and what to do about it.
#[derive(Debug, Clone)]
pub struct SceneError {
    message: String,
    label: String,
    help: Option<String>,
    place: Option<Place>,
}

impl SceneError {
    /// An error at a place: the message is a full sentence with key and value, the label stands under the caret.
    #[must_use]
    pub fn at(place: &Place, message: impl Into<String>, label: impl Into<String>) -> Self {
        Self { message: one_line(&message.into()), label: one_line(&label.into()), help: None, place: Some(place.clone()) }
    }

    /// An error without a place in a text (a file that cannot be read, a folder that exists).
    #[must_use]
    pub fn general(message: impl Into<String>) -> Self {
        Self { message: one_line(&message.into()), label: String::new(), help: None, place: None }
    }

    /// The same error with a line that says what is allowed, or what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(terminal_text::lines(&help.into()));
        self
    }

    /// The same error at another place, if its message quotes this key: there the key was put into the scene.
    #[must_use]
    pub(super) fn put_by(self, key: &str, place: &Place, by: &str) -> Self {
        if !self.message.contains(&format!("`{key}`")) {
            return self;
        }
        let remedy = self.help.as_ref().map_or_else(String::new, |help| format!("\n{help}"));
        let help = format!("`{key}` is put there by `{by}`{remedy}");
        Self { help: Some(help), place: Some(place.clone()), ..self }
    }

    /// What stands under the caret.
    pub(super) fn label(&self) -> &str {
        &self.label
    }

    /// What is allowed, or what to do.
    pub(super) fn remedy(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// The message with a caret under the place, file, line and column, for a terminal.
    #[must_use]
    pub fn rendered(&self) -> String {
        let mut text = String::new();
        let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor()).with_wrap_lines(false).with_context_lines(1);
        let place = self.place.as_ref();
        let framed = Framed { error: self, frame: place.filter(|place| !place.source.hidden).map(Frame::of) };
        if let Some(place) = place.filter(|place| place.source.hidden) {
            let [line, column] = place.line_and_column();
            text = format!("{}:{line}:{column}\n", terminal_text::one_line(place.source.name()));
        }
        match handler.render_report(&mut text, &framed) {
            Ok(()) => text,
            Err(_) => format!("{self}\n"),
        }
    }
}

impl SceneError {
    /// The same in parts, for programs: message, key, file, line and column from 1, what stands under the caret, remedy, and the text for people.
    #[must_use]
    pub fn report(&self) -> serde_json::Value {
        let place = self.place.as_ref().map(|place| (terminal_text::one_line(place.source.name()), place.line_and_column()));
        serde_json::json!({
            "message": self.message,
            "key": self.key(),
            "file": place.as_ref().map(|(file, _)| file),
            "line": place.as_ref().map(|(_, [line, _])| line),
            "column": place.as_ref().map(|(_, [_, column])| column),
            "label": self.label,
            "remedy": self.help,
            "text": self.rendered(),
        })
    }

    /// The key that the message is about: what it quotes first, if that is written as a key.
    fn key(&self) -> Option<&str> {
        let quoted = self.message.split('`').nth(1)?.split([' ', '=']).next()?;
        let is_key =
            |part: &str| !part.is_empty() && part.chars().all(|character| character.is_ascii_alphanumeric() || "_-".contains(character));
        quoted.split('.').all(is_key).then_some(quoted)
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for SceneError {}

/// A message on one line: keys and values from a file may hold line feeds, or codes that command a terminal.
fn one_line(text: &str) -> String {
    match text.char_indices().nth(LONGEST_MESSAGE) {
        None => terminal_text::one_line(text),
        Some((end, _)) => terminal_text::one_line(text.get(..end).unwrap_or("")) + "…",
    }
}

/// Most characters of a message: what is longer quotes a file that is no table.
const LONGEST_MESSAGE: usize = 600;

/// The known name nearest to a misspelt one, if it is near enough to be meant: a slip for every four letters, in the whole and in every word of it.
/// So `shear_modulus` is not `glassy_modulus`, though most letters are the same.
#[must_use]
pub fn nearest<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known.into_iter().filter_map(|name| slips(given, name).map(|slips| (slips, name))).min_by_key(|&(slips, _)| slips).map(|(_, name)| name)
}

/// Letters that differ, if they are few.
fn slips(given: &str, name: &str) -> Option<usize> {
    let few = |left: &str, right: &str| {
        let slips = strsim::damerau_levenshtein(left, right);
        let allowed = (left.chars().count().max(right.chars().count()).max(1) - 1) / 4 + 1;
        (slips <= allowed).then_some(slips)
    };
    let words = |text: &str| text.split(['_', ' ', '-', '.']).map(str::to_owned).collect::<Vec<_>>();
    let (left, right) = (words(given), words(name));
    let close = left.len() != right.len() || left.iter().zip(&right).all(|(left, right)| few(left, right).is_some());
    // A name of one or two letters is near to every other.
    let long = given.chars().count() > 2;
    few(given, name).filter(|_| close && long)
}
