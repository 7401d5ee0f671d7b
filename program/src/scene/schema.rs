//! The editor schema of a scene (JSON Schema), made from the catalogue.

use super::catalogue::{self, Key, Kind, Range, Word};
use serde_json::{Map, Value, json};

/// JSON Schema (draft 2020-12) of a scene.
#[must_use]
pub fn schema() -> Value {
    let mut root = table("");
    if let Value::Object(members) = &mut root {
        members.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
        members.insert("title".into(), json!("viscotack scene"));
    }
    root
}

/// The schema of the table at a path.
fn table(path: &str) -> Value {
    let mut properties = Map::new();
    for name in catalogue::names_in(path) {
        let below = if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
        if let Some(key) = catalogue::key(&below) {
            properties.insert(name.to_owned(), of_key(key));
        }
    }
    json!({ "type": "object", "additionalProperties": false, "properties": properties })
}

fn of_key(key: &Key) -> Value {
    let mut value = match key.kind {
        Kind::Number { range, .. } => {
            let mut number = Map::from_iter([("type".to_owned(), json!("number"))]);
            match range {
                Range::Positive => number.insert("exclusiveMinimum".into(), json!(0)),
                Range::NonNegative => number.insert("minimum".into(), json!(0)),
                Range::AboveUpTo(low, high) => {
                    number.insert("maximum".into(), json!(high));
                    number.insert("exclusiveMinimum".into(), json!(low))
                }
                Range::Finite => None,
            };
            json!({ "anyOf": [number, { "type": "string" }] })
        }
        Kind::NumberOfSweptKey => json!({ "type": ["number", "string"] }),
        Kind::NumbersOfSweptKey => json!({ "type": "array", "minItems": 1, "items": { "type": ["number", "string"] } }),
        Kind::Count { least, most } => json!({ "type": "integer", "minimum": least, "maximum": most }),
        Kind::Choice(words) => choice(words),
        Kind::Choices(words) => json!({ "type": "array", "minItems": 1, "uniqueItems": true, "items": choice(words) }),
        Kind::Text => json!({ "type": "string" }),
        Kind::Texts => json!({ "anyOf": [{ "type": "string" }, { "type": "array", "minItems": 1, "items": { "type": "string" } }] }),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Table => table(key.path),
        Kind::Tables => json!({ "type": "array", "items": table(&format!("{}[]", key.path)) }),
        Kind::TableOrWord(words) => json!({ "anyOf": [table(key.path), choice(words)] }),
        Kind::TableOrTables => json!({ "anyOf": [table(key.path), { "type": "array", "items": table(key.path) }] }),
    };
    if let Value::Object(members) = &mut value {
        let unit = match key.kind {
            Kind::Number { dimension, range, reduced } => {
                format!(" Unit: {} (reduced: {reduced}); {}.", dimension.si_unit(), range.words())
            }
            _ => String::new(),
        };
        members.insert("description".into(), json!(format!("{}{unit}", key.meaning)));
    }
    value
}

fn choice(words: &[Word]) -> Value {
    json!({ "oneOf": words.iter().map(|word| json!({ "const": word.word, "description": word.meaning })).collect::<Vec<_>>() })
}
