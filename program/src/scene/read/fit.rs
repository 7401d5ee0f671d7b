//! `[fit]`: what is free, what is compared, which tests.

use super::fit_data::{Wish, table};
use super::section::Section;
use crate::scene::catalogue::Range;
use crate::scene::check::{Units, check, check_range, number};
use crate::scene::diagnostic::{Place, SceneError};
use crate::scene::document::{Document, Value};
use crate::scene::sweep::varied_key;
use crate::scene::typed::{FitFree, FitTask, FitTest, HistoryQuantity};
use crate::scene::units::Dimension;

/// Descents, where the scene names no number.
const STARTS: f64 = 3.0;
/// What data of a history may be given against.
const ALONG: [&str; 3] = ["time", "penetration", "frame"];
/// What is compared along a history.
const COMPARED: [&str; 3] = ["force", "contact_radius", "penetration"];
/// Offsets of the data: key, dimension, what it is.
const OFFSETS: [(&str, Dimension); 4] = [
    ("fit.depth_offset", Dimension::LENGTH),
    ("fit.time_offset", Dimension::TIME),
    ("fit.force_offset", Dimension::FORCE),
    ("fit.force_drift", Dimension::FORCE_RATE),
];

/// Reads the table `[fit]` of a scene and the data that it names.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn read_fit(document: &mut Document) -> Result<FitTask, SceneError> {
    check(&document.root)?;
    let root = document.root.clone();
    let units = Units::of(&root);
    let top = Section::top(&root, units);
    let fit = top.required_table("fit", "it says which numbers are found from which data")?;
    for other in ["sweep", "latin_hypercube"] {
        if let Some(node) = root.get(other) {
            let message = format!("[fit] and `{other}` exclude each other");
            return Err(SceneError::at(&node.place, message, "leave it out"));
        }
    }
    let compare: Vec<String> = fit.texts_of("compare")?;
    let compare_place = fit.key_place("compare");
    let against = fit.text("against").map(str::to_owned);
    let along_a_history = against.as_ref().is_none_or(|against| ALONG.contains(&against.as_str()));
    if let Some(word) = compare.iter().find(|word| along_a_history && !COMPARED.contains(&word.as_str())) {
        let message = format!("`fit.compare` = {word:?}: a history has no such curve");
        let help = format!(
            "allowed along a history: {}; or give the data against a number of the scene: fit.against = \"crack.speed\"",
            COMPARED.join(", ")
        );
        return Err(SceneError::at(&compare_place, message, "not known").help(help));
    }
    let against_dimension = match against.as_ref().filter(|_| !along_a_history) {
        Some(path) => Some(varied_key(&root, path, &fit.key_place("against"), "fit.against")?.1),
        None => None,
    };
    let free = fit.items("free").iter().map(|item| free_number(item, document, units)).collect::<Result<Vec<_>, _>>()?;
    if free.is_empty() {
        return Err(fit.wrong("free", "`fit.free` names no number to find".to_owned(), "add free = [{ key = ..., from = ..., to = ... }]"));
    }
    for (number, one) in free.iter().enumerate() {
        if free.iter().take(number).any(|other| other.key == one.key) {
            return Err(SceneError::at(&one.place, format!("`{}` is free twice", one.key), "leave one out"));
        }
    }
    let mut wishes: Vec<Wish> = compare.iter().map(|word| Wish::of(word, true, along_a_history)).collect();
    match &against {
        Some(path) => wishes.push(Wish {
            word: path.rsplit('.').next().unwrap_or(path).to_owned(),
            dimension: against_dimension.or_else(|| along(path)),
            required: true,
        }),
        None => wishes.push(Wish::of("time", true, true)),
    }
    if along_a_history {
        wishes.push(Wish::of("time", false, true));
    }
    let items = fit.items("test");
    if items.is_empty() {
        return Err(fit.wrong("test", "`fit.test` names no data".to_owned(), "add [[fit.test]] with data = \"FILE.csv\""));
    }
    let tests = items
        .iter()
        .map(|item| {
            let file = item.required_text("data")?.to_owned();
            let place = item.key_place("data");
            document.attach_table(&item.full("data"), &file, &place)?;
            let set = if item.node().get("set").is_some() { item.texts_of("set")? } else { Vec::new() };
            let Some(source) = document.attached(&file).cloned() else {
                return Err(item.wrong("data", format!("{file:?} was not read"), "this file"));
            };
            Ok(FitTest { table: table(&file, place, &source, &wishes, item.table("columns").as_ref(), units)?, set })
        })
        .collect::<Result<Vec<_>, SceneError>>()?;
    let relative = fit.text("errors").map(|word| word == "relative");
    let huber = fit.text("loss") == Some("huber");
    let starts = fit.number("starts")?.unwrap_or(STARTS) as usize;
    fit.all_read(&[], "a fit")?;
    Ok(FitTask { compare, compare_place, against, against_dimension, free, tests, relative, huber, starts })
}

/// What a quantity along a history is measured in.
pub(super) fn along(word: &str) -> Option<Dimension> {
    if word == "time" { Some(Dimension::TIME) } else { HistoryQuantity::of_word(word).map(HistoryQuantity::dimension) }
}

fn free_number(item: &Section<'_>, document: &Document, units: Units) -> Result<FitFree, SceneError> {
    let key = item.required_text("key")?.to_owned();
    let place: Place = item.key_place("key");
    let offset = OFFSETS.iter().find(|(name, ..)| *name == key);
    let (dimension, range) = match offset {
        Some((_, dimension)) => (*dimension, Range::Finite),
        None if key.starts_with("fit.") => {
            let known: Vec<&str> = OFFSETS.iter().map(|offset| offset.0).collect();
            let message = format!("`{}` = {key:?} is no offset of the data", item.full("key"));
            return Err(SceneError::at(&place, message, "not known").help(format!("known are: {}", known.join(", "))));
        }
        None => {
            let (_, dimension, range) = varied_key(&document.root, &key, &place, &item.full("key"))?;
            (dimension, range)
        }
    };
    let end = |name: &str| -> Result<Option<f64>, SceneError> {
        let Some(node) = item.value(name) else { return Ok(None) };
        let value = number(node, &item.full(name), dimension, units)?;
        check_range(node, &item.full(name), value, range).map(|()| Some(value))
    };
    let bounds = match (end("from")?, end("to")?) {
        (Some(from), Some(to)) if from < to => Some([from, to]),
        (Some(_), Some(_)) => {
            let message = format!("`{}` is not below `{}`", item.full("from"), item.full("to"));
            return Err(item.wrong("from", message, "must be smaller"));
        }
        (None, None) if offset.is_some() => None,
        (from, _) => {
            let missing = if from.is_none() { "from" } else { "to" };
            let message = format!("`{}` is missing: between which values may `{key}` lie?", item.full(missing));
            return Err(SceneError::at(&place, message, "of this number").help(format!(
                "allowed: {}, or a plain number in {}",
                dimension.example(),
                dimension.si_unit()
            )));
        }
    };
    Ok(FitFree { key, place, bounds, dimension, range })
}

impl Section<'_> {
    /// A text, or the texts of a list; at least one.
    fn texts_of(&self, key: &str) -> Result<Vec<String>, SceneError> {
        let texts: Vec<String> = match self.value(key).map(|node| &node.value) {
            Some(Value::Text(text)) => vec![text.clone()],
            Some(Value::List(_)) => self.texts(key).into_iter().map(str::to_owned).collect(),
            _ => self.required_text(key).map(|text| vec![text.to_owned()])?,
        };
        for (number, text) in texts.iter().enumerate() {
            if key == "compare" && texts.iter().take(number).any(|other| other == text) {
                return Err(self.wrong(key, format!("`{}` names {text:?} twice", self.full(key)), "leave one out"));
            }
        }
        Ok(texts)
    }
}
