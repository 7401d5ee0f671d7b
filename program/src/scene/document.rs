//! A TOML text as a tree whose every key and value knows its place, open to replacement by `--set` and by sweeps.

use super::diagnostic::{Place, SceneError, SourceText};
use super::read::cache::{Cache, OfTable};
use super::recognise;
use super::typed::{MaterialOrigin, MeasuredShape, MeasuredTable, SceneSurface};
use crate::{regular_file, terminal_text};
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::io::Read;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value of the tree.
#[derive(Debug, Clone)]
pub enum Value {
    /// A finite or non-finite number: TOML writes `nan` and `inf`, the check refuses them.
    Number(f64),
    /// A text, also a number with a unit.
    Text(String),
    /// true or false.
    Flag(bool),
    /// A date or time, which no key takes.
    Date,
    /// A list.
    List(Vec<Node>),
    /// A table.
    Table(Vec<Entry>),
}

/// A value with its place.
#[derive(Debug, Clone)]
pub struct Node {
    /// The value.
    pub value: Value,
    /// Where it stands.
    pub place: Place,
}

/// A key of a table.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Where the key stands.
    pub key_place: Place,
    /// Its value.
    pub node: Node,
}

impl Node {
    /// The entries of a table; none for anything else.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        match &self.value {
            Value::Table(entries) => entries,
            _ => &[],
        }
    }

    /// The value under a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Node> {
        self.entries().iter().find(|entry| entry.key == key).map(|entry| &entry.node)
    }

    /// The value under a dotted path; a number selects an item of a list.
    #[must_use]
    pub fn at(&self, path: &str) -> Option<&Node> {
        path.split('.').try_fold(self, |node, part| match &node.value {
            Value::List(items) => items.get(part.parse::<usize>().ok()?),
            _ => node.get(part),
        })
    }

    /// What kind of value this is, for messages.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match self.value {
            Value::Number(_) => "a number",
            Value::Text(_) => "a text",
            Value::Flag(_) => "true or false",
            Value::Date => "a date",
            Value::List(_) => "a list",
            Value::Table(_) => "a table",
        }
    }

    /// The value as it stands in its text.
    #[must_use]
    pub fn written(&self) -> &str {
        self.place.source.text().get(self.place.span.clone()).unwrap_or("?").trim()
    }
}

/// A scene as a tree, with the folder that relative paths in it start from.
#[derive(Debug, Clone)]
pub struct Document {
    /// The top-level table.
    pub root: Node,
    folder: PathBuf,
    hash: String,
    /// Further files that the scene names, by the names it gives them.
    attached: Vec<(String, SourceText)>,
    /// Files that are given with the scene, and are not read again.
    provided: Vec<(String, SourceText)>,
    /// Files that were put into the tree.
    included: Vec<(String, SourceText)>,
    /// What was chosen in reading tables.
    notes: Vec<String>,
    /// What was made of the material's data or law, so that states of a sweep do not make it again.
    materials: Cache<MaterialOrigin>,
    /// The same of records that the history follows.
    records: OfTable<MeasuredTable>,
    /// The same of shapes of indenters.
    shapes: OfTable<(Vec<(f64, f64)>, MeasuredShape)>,
    /// The same of sliding surfaces.
    surfaces: OfTable<SceneSurface>,
}

/// No scene that a person writes is larger (bytes).
const LARGEST_FILE: u64 = 16 * 1024 * 1024;

/// No key lies deeper (parts of a path): a longer one is refused before tables are made for it.
const DEEPEST_PATH: usize = 32;

impl Document {
    /// Reads a scene file.
    ///
    /// # Errors
    /// A file that cannot be read or is no UTF-8, or a TOML syntax error with its place.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let name = path.display().to_string();
        let unreadable = |reason: String| SceneError::general(format!("the scene file `{name}` cannot be read: {reason}"));
        let text = read_text(path).map_err(unreadable)?;
        Self::parse(&name, text, path.parent().unwrap_or_else(|| Path::new(".")))
    }

    /// Reads a scene from a stream, such as standard input; relative paths in it start at the working folder.
    ///
    /// # Errors
    /// As [`Document::load`].
    pub fn from_stream(name: &str, stream: impl Read) -> Result<Self, SceneError> {
        let text = text_of(regular_file::read_stream(stream, LARGEST_FILE));
        let text = text.map_err(|reason| SceneError::general(format!("the scene on {name} cannot be read: {reason}")))?;
        Self::parse(name, text, Path::new("."))
    }

    /// Reads a scene from a text; `folder` is where relative paths in it start.
    ///
    /// # Errors
    /// A TOML syntax error with its place.
    pub fn parse(name: &str, text: String, folder: &Path) -> Result<Self, SceneError> {
        let source = SourceText::new(name, text);
        let root = parse_tree(&source)?;
        let mut document = Self {
            root,
            folder: folder.to_owned(),
            hash: String::new(),
            attached: Vec::new(),
            provided: Vec::new(),
            included: Vec::new(),
            notes: Vec::new(),
            materials: Cache::default(),
            records: OfTable::default(),
            shapes: OfTable::default(),
            surfaces: OfTable::default(),
        };
        document.add_to_hash(&source);
        Ok(document)
    }

    /// The same without its sweep, which the states of the sweep need not carry.
    #[must_use]
    pub fn without_sweep(&self) -> Self {
        self.without(&["sweep", "latin_hypercube"])
    }

    /// The same without some of its tables.
    #[must_use]
    pub fn without(&self, tables: &[&str]) -> Self {
        let mut document = self.clone();
        if let Value::Table(entries) = &mut document.root.value {
            entries.retain(|entry| !tables.contains(&entry.key.as_str()));
        }
        document
    }

    /// Further files that the scene names, by the names that it gives them.
    pub fn attachments(&self) -> impl Iterator<Item = (&str, &SourceText)> {
        self.attached.iter().map(|(name, source)| (name.as_str(), source))
    }

    /// Every file that was read, with the name that it has in the scene or beside its material file: with them the scene can be read where they are not.
    pub fn files(&self) -> impl Iterator<Item = (&str, &SourceText)> {
        self.included.iter().chain(&self.attached).map(|(name, source)| (name.as_str(), source))
    }

    /// Gives files, by their names, that are taken instead of those on disk.
    pub fn provide(&mut self, files: Vec<(String, SourceText)>) {
        self.provided = files;
    }

    /// A file that is given with the scene.
    pub(super) fn provided(&self, name: &str) -> Option<&SourceText> {
        self.provided.iter().find(|(known, _)| known == name).map(|(_, source)| source)
    }

    /// Keeps the text of a file that was put into the tree, and adds it to the hash.
    pub(super) fn include(&mut self, name: &str, source: SourceText) {
        self.add_to_hash(&source);
        self.included.push((name.to_owned(), source));
    }

    /// The folder that relative paths start from.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// A file that the scene names, if it was attached.
    #[must_use]
    pub fn attached(&self, name: &str) -> Option<&SourceText> {
        self.attached.iter().find(|(known, _)| known == name).map(|(_, source)| source)
    }

    /// Attaches a file under the name that the scene gives it, and adds it to the hash.
    pub fn attach(&mut self, name: &str, source: SourceText) {
        self.add_to_hash(&source);
        self.attached.push((name.to_owned(), source));
    }

    /// Reads the table that `key` of the scene names, and attaches it; once for a name.
    ///
    /// # Errors
    /// A file that cannot be read or holds no text.
    pub(super) fn attach_table(&mut self, key: &str, name: &str, place: &Place) -> Result<(), SceneError> {
        if self.attached(name).is_some() {
            return Ok(());
        }
        if let Some(source) = self.provided(name).cloned() {
            self.attach(name, source);
            return Ok(());
        }
        let path = self.folder.join(name);
        let opened = if super::npy::is_named(name) { super::npy::open(&path, name) } else { super::delimited::open(&path, name) };
        let source = opened.map_err(|error| {
            SceneError::at(place, format!("`{key}` = {name:?} cannot be read: {error}"), "this file")
                .help("relative paths start at the scene")
        })?;
        self.attach(name, source);
        Ok(())
    }

    /// Adds what was chosen in reading a table.
    pub(super) fn note(&mut self, notes: Vec<String>) {
        self.notes.extend(notes);
    }

    /// What was chosen in reading tables whose rows stand in the tree, a sentence each.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Materials made before from the same data, shared by all copies of the document.
    pub(super) const fn materials(&self) -> &Cache<MaterialOrigin> {
        &self.materials
    }

    /// Records read before from the same file, shared by all copies of the document.
    pub(super) const fn records(&self) -> &OfTable<MeasuredTable> {
        &self.records
    }

    /// Shapes of indenters read before from the same file.
    pub(super) const fn shapes(&self) -> &OfTable<(Vec<(f64, f64)>, MeasuredShape)> {
        &self.shapes
    }

    /// Sliding surfaces made before of the same words and file.
    pub(super) const fn surfaces(&self) -> &OfTable<SceneSurface> {
        &self.surfaces
    }

    /// SHA-256 of everything that was read: the scene, included files, and `--set`s, in order.
    #[must_use]
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// Adds a text that the result depends on to the hash.
    pub fn add_to_hash(&mut self, source: &SourceText) {
        let mut hasher = Sha256::new();
        hasher.update(self.hash.as_bytes());
        hasher.update(source.text().as_bytes());
        self.hash = hasher.finalize().iter().fold(String::new(), |mut text, byte| {
            // Writing to a String cannot fail.
            let _ = write!(text, "{byte:02x}");
            text
        });
    }

    /// Applies one `--set key=value`; the value is TOML, and anything that is not is taken as a text.
    ///
    /// # Errors
    /// An assignment without `=`, or a path through something that is no table.
    pub fn set(&mut self, assignment: &str) -> Result<(), SceneError> {
        let Some((path, value)) = assignment.split_once('=') else {
            return Err(SceneError::general(format!("`--set {assignment}` has no `=`")).help("write --set table.key=value"));
        };
        let (path, value) = (path.trim(), value.trim());
        if path.is_empty() {
            return Err(SceneError::general(format!("`--set {assignment}` names no key")).help("write --set table.key=value"));
        }
        let as_written = SourceText::new(&format!("--set {path}"), format!("value = {value}"));
        let source = match parse_tree(&as_written) {
            Ok(_) => as_written,
            Err(_) => SourceText::new(&format!("--set {path}"), format!("value = {}", toml_text(value))),
        };
        let tree = parse_tree(&source)?;
        let Some(node) = tree.get("value") else {
            return Err(SceneError::general(format!("`--set {assignment}` gives no value")));
        };
        self.add_to_hash(&SourceText::new("--set", format!("{path}={value}")));
        self.replace(path, node.clone())
    }

    /// Puts a value under a dotted path, replacing what is there; tables on the way are made if they are missing.
    ///
    /// # Errors
    /// A path through a value that is no table, past the end of a list, or deeper than any key.
    pub fn replace(&mut self, path: &str, node: Node) -> Result<(), SceneError> {
        if path.split('.').nth(DEEPEST_PATH).is_some() {
            let start: String = path.chars().take(60).collect();
            return Err(SceneError::at(&node.place, format!("`{start}…` is not a key"), "no key lies so deep"));
        }
        replace_in(&mut self.root, path, path, node)
    }
}

fn replace_in(node: &mut Node, path: &str, whole: &str, new: Node) -> Result<(), SceneError> {
    let (head, tail) = path.split_once('.').map_or((path, None), |(head, tail)| (head, Some(tail)));
    if head.is_empty() {
        return Err(SceneError::at(&new.place, format!("`{whole}` is not a key"), "an empty part in the path"));
    }
    let kind = node.kind();
    let child = match &mut node.value {
        Value::List(items) => {
            let length = items.len();
            match head.parse::<usize>().ok().and_then(|index| items.get_mut(index)) {
                Some(item) => item,
                None => {
                    let message =
                        format!("`{whole}` does not exist: the list has {length} items, counted from 0, and `{head}` is none of them");
                    return Err(SceneError::at(&new.place, message, "for this key"));
                }
            }
        }
        Value::Table(entries) => {
            let index = match entries.iter().position(|entry| entry.key == head) {
                Some(index) => index,
                None => {
                    let place = new.place.clone();
                    let empty = Node { value: Value::Table(Vec::new()), place: place.clone() };
                    entries.push(Entry { key: head.to_owned(), key_place: place, node: empty });
                    entries.len() - 1
                }
            };
            match entries.get_mut(index) {
                Some(entry) => &mut entry.node,
                None => return Ok(()),
            }
        }
        _ => {
            let message = format!("`{whole}` does not exist: `{head}` lies below {kind}, not below a table");
            return Err(SceneError::at(&new.place, message, "for this key"));
        }
    };
    match tail {
        Some(tail) => replace_in(child, tail, whole, new),
        None => {
            *child = new;
            Ok(())
        }
    }
}

/// The text of a file, or the reason why it cannot be read.
pub(super) fn read_text(path: &Path) -> Result<String, String> {
    text_of(regular_file::read(path, LARGEST_FILE))
}

fn text_of(bytes: std::io::Result<Vec<u8>>) -> Result<String, String> {
    String::from_utf8(bytes.map_err(|error| error.to_string())?).map_err(|error| {
        let whole = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes().iter().take(whole).filter(|&&byte| byte == b'\n').count();
        format!("byte {whole}, in line {line}, is not UTF-8 text")
    })
}

/// A text as a TOML basic string.
pub fn toml_text(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => {
                quoted.push('\\');
                quoted.push(character);
            }
            harmful if terminal_text::is_harmful(harmful) => {
                let _ = match u32::from(harmful) {
                    short @ ..=0xffff => write!(quoted, "\\u{short:04X}"),
                    long => write!(quoted, "\\U{long:08X}"),
                };
            }
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}

/// Parses a TOML text into a tree.
///
/// # Errors
/// A syntax error with its place.
pub fn parse_tree(source: &SourceText) -> Result<Node, SceneError> {
    let table = DeTable::parse(source.text()).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        let words = source.text().get(span.clone()).filter(|words| !words.trim().is_empty() && words.len() <= 60);
        let what = words.map_or_else(|| error.message().to_owned(), |words| format!("{} `{}`", error.message(), words.trim()));
        if !recognise::is_scene(source.text()) {
            let place = Place { source: source.hidden(), span };
            return SceneError::at(&place, "this is not a scene, and not TOML", "here");
        }
        let place = Place { source: source.clone(), span };
        SceneError::at(&place, format!("this is not TOML: {what}"), "here")
    })?;
    Ok(Node { place: Place { source: source.clone(), span: table.span() }, value: table_value(table.get_ref(), source) })
}

fn table_value(table: &DeTable<'_>, source: &SourceText) -> Value {
    let mut entries: Vec<Entry> = table
        .iter()
        .map(|(key, value)| Entry {
            key: key.get_ref().to_string(),
            key_place: Place { source: source.clone(), span: key.span() },
            node: node_of(value, source),
        })
        .collect();
    entries.sort_by_key(|entry| entry.key_place.span.start);
    Value::Table(entries)
}

fn node_of(value: &Spanned<DeValue<'_>>, source: &SourceText) -> Node {
    let converted = match value.get_ref() {
        DeValue::String(text) => Value::Text(text.to_string()),
        // An integer beyond 64 bits is still a number.
        DeValue::Integer(integer) => Value::Number(
            i64::from_str_radix(integer.as_str(), integer.radix())
                .map_or_else(|_| integer.as_str().parse().unwrap_or(f64::NAN), |n| n as f64),
        ),
        DeValue::Float(float) => Value::Number(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(flag) => Value::Flag(*flag),
        DeValue::Datetime(_) => Value::Date,
        DeValue::Array(items) => Value::List(items.iter().map(|item| node_of(item, source)).collect()),
        DeValue::Table(table) => table_value(table, source),
    };
    Node { value: converted, place: Place { source: source.clone(), span: value.span() } }
}
