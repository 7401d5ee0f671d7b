//! The reference of all keys as a page in Markdown, made from the catalogue.

use super::catalogue::{self, Key, Kind, Word};
use std::fmt::Write;

/// The page: one section for each table of a scene, one row for each of its keys.
#[must_use]
pub fn key_reference() -> String {
    let mut page = String::from(
        "# Keys of a scene\n\n\
         <!-- Made by `viscotack schema --markdown`; do not edit. -->\n\n\
         Every key that a scene may hold. A number is a plain number in SI units or a text with a unit. In scenes with `units = \"reduced\"` it is a plain number in the unit \
         that the second column names last.\n",
    );
    section(&mut page, "", "The scene itself", "");
    for key in catalogue::keys() {
        let (path, title) = match key.kind {
            Kind::Table | Kind::TableOrWord(_) => (key.path.to_owned(), format!("`[{}]`", key.path)),
            Kind::TableOrTables => (key.path.to_owned(), format!("`[{0}]` or `[[{0}]]`", key.path)),
            Kind::Tables => (format!("{}[]", key.path), format!("`[[{}]]`", key.path)),
            _ => continue,
        };
        if catalogue::names_in(&path).next().is_some() {
            section(&mut page, &path, &title, key.meaning);
        }
    }
    page
}

fn section(page: &mut String, table: &str, title: &str, meaning: &str) {
    let _ = write!(page, "\n## {title}\n\n");
    if !meaning.is_empty() {
        let _ = write!(page, "{}\n\n", escaped(meaning));
    }
    page.push_str("| key | takes | meaning |\n|---|---|---|\n");
    for name in catalogue::names_in(table) {
        let path = if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") };
        if let Some(key) = catalogue::key(&path) {
            let _ = writeln!(page, "| `{name}` | {} | {} |", escaped(&takes(key)), escaped(key.meaning));
        }
    }
}

/// What a key takes, in words.
fn takes(key: &Key) -> String {
    match key.kind {
        Kind::Number { dimension, range, reduced } => {
            format!("a number, {} [{}; reduced: {reduced}]", range.words(), dimension.si_unit())
        }
        Kind::NumberOfSweptKey => "a number of the key that is varied".into(),
        Kind::NumbersOfSweptKey => "a list of numbers of the key that is varied".into(),
        Kind::Count { least, most } => format!("a whole number, {least} to {most}"),
        Kind::Choice(words) => format!("one of {}", list(words)),
        Kind::Choices(words) => format!("a list of {}", list(words)),
        Kind::Text => "a text".into(),
        Kind::Texts => "a text or a list of texts".into(),
        Kind::Flag => "`true` or `false`".into(),
        Kind::Table => "a table".into(),
        Kind::Tables => "a list of tables".into(),
        Kind::TableOrTables => "a table or a list of tables".into(),
        Kind::TableOrWord(words) => format!("a table, or one of {}", list(words)),
    }
}

fn list(words: &[Word]) -> String {
    words.iter().map(|word| format!("`\"{}\"` ({})", word.word, word.meaning)).collect::<Vec<_>>().join(", ")
}

/// A text for a cell of a table: a bar would end it, `<` would begin a tag, and the stars of two moduli would make what is between them slanted.
pub(crate) fn escaped(text: &str) -> String {
    let in_text = |part: &str| part.replace('*', "\\*").replace('<', "&lt;");
    let parts = text.split('`').enumerate().map(|(place, part)| if place % 2 == 0 { in_text(part) } else { part.to_owned() });
    parts.collect::<Vec<_>>().join("`").replace('|', "\\|")
}
