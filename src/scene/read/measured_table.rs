//! A CSV file that a history follows; and the reading of such files, which [`super::shape_points`] shares.
//!
//! ```text
//! # a comment
//! time (s), penetration (µm), force (mN)
//! 0.0,      0.00,             0.00
//! 0.5,      1.20,             0.35
//! ```
//! One header line with a name and, in SI scenes, a unit for each column; the first is `time`, one is the controlled quantity. Then numbers
//! without units. Lines that are empty or begin with `#` are passed over. A cell of a column that is not controlled may be empty.

use super::section::Section;
use crate::scene::check::Units;
use crate::scene::diagnostic::{Place, SceneError, SourceText, nearest};
use crate::scene::document::{Document, Node, Value, read_text};
use crate::scene::typed::{HistoryQuantity, MeasuredColumn, MeasuredTable};
use crate::scene::units::{Dimension, parse_quantity};

/// Reads the files that the history and the indenter of a document name, so that the document holds all that its result depends on.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    let mut named: Vec<(&str, String, Place)> = match document.root.get("history").map(|node| &node.value) {
        Some(Value::List(items)) => items.iter().filter_map(|item| file_of("history.table", item.get("table")?)).collect(),
        _ => Vec::new(),
    };
    named.extend(document.root.at("indentation.profile").and_then(|node| file_of("indentation.profile", node)));
    for (key, name, place) in named {
        if document.attached(&name).is_some() {
            continue;
        }
        let text = read_text(&document.folder().join(&name)).map_err(|error| {
            SceneError::at(&place, format!("`{key}` = {name:?} cannot be read: {error}"), "this file")
                .help("relative paths start at the scene")
        })?;
        document.attach(&name, SourceText::new(&name, text));
    }
    Ok(())
}

fn file_of<'k>(key: &'k str, node: &Node) -> Option<(&'k str, String, Place)> {
    match &node.value {
        Value::Text(name) => Some((key, name.clone(), node.place.clone())),
        _ => None,
    }
}

/// A column of the header.
pub(super) struct Header {
    pub(super) name: String,
    dimension: Dimension,
    unit: String,
    place: Place,
}

/// The table that a segment names.
pub(super) fn measured_table(item: &Section<'_>, document: &Document, quantity: HistoryQuantity) -> Result<MeasuredTable, SceneError> {
    let file = item.required_text("table")?;
    let Some(source) = document.attached(file) else {
        let message = format!("`{}` = {file:?} was not read with the scene", item.full("table"));
        return Err(item.wrong("table", message, "this file"));
    };
    let mut lines = lines_of(source);
    let Some(first) = lines.next() else {
        let place = Place { source: source.clone(), span: 0..0 };
        return Err(SceneError::at(&place, format!("{file:?} is empty"), "here").help(example(quantity)));
    };
    let help = example(quantity);
    let known = |name: &str| HistoryQuantity::of_word(name).map(HistoryQuantity::dimension);
    let headers = headers(&first, item.units(), ("time", Dimension::TIME), known, &help)?;
    let Some(controlled) = headers.iter().position(|header| header.name == quantity.word()) else {
        let near = nearest(quantity.word(), headers.iter().map(|header| header.name.as_str()));
        let label = near.map_or_else(|| "no such column".to_owned(), |name| format!("did you mean `{name}` to be it?"));
        return Err(SceneError::at(&first, format!("{file:?} has no column `{}`", quantity.word()), label).help(example(quantity)));
    };
    let mut columns: Vec<Vec<Option<f64>>> = vec![Vec::new(); headers.len()];
    for line in lines {
        let cells = cells_of(&line);
        if cells.len() != headers.len() {
            let message = format!("this row has {} cells, the header {}", cells.len(), headers.len());
            return Err(SceneError::at(&line, message, "in this row"));
        }
        for (index, ((cell, header), column)) in cells.iter().zip(&headers).zip(&mut columns).enumerate() {
            let must = index == 0 || index == controlled;
            let value = number(cell, header, must)?;
            if index == 0
                && let (Some(Some(before)), Some(now)) = (column.last(), value)
                && now <= *before
            {
                let message = format!("`time` = {} does not increase: the row before has {before:e}", written(cell));
                return Err(SceneError::at(cell, message, "must be later"));
            }
            if let (true, Some(value)) = (index == controlled, value)
                && !quantity.range().holds(value)
            {
                let message = format!("`{}` = {} is out of range", header.name, written(cell));
                return Err(SceneError::at(cell, message, format!("must be {}", quantity.range().words())));
            }
            column.push(value);
        }
    }
    let taken = |index: usize| columns.get(index).map_or_else(Vec::new, |column| column.iter().flatten().copied().collect());
    let (mut times, values): (Vec<f64>, Vec<f64>) = (taken(0), taken(controlled));
    if times.len() < 2 {
        return Err(SceneError::at(&first, format!("{file:?} has {} rows", times.len()), "needs at least two below this line"));
    }
    let begin = times.first().copied().unwrap_or(0.0);
    for time in &mut times {
        *time -= begin;
    }
    let further = |(index, _): &(usize, (Header, Vec<Option<f64>>))| *index != 0 && *index != controlled;
    let others = headers
        .into_iter()
        .zip(columns)
        .enumerate()
        .filter(further)
        .map(|(_, (header, values))| MeasuredColumn { name: header.name, dimension: header.dimension, values })
        .collect();
    Ok(MeasuredTable { file: file.to_owned(), times, values, others })
}

fn example(quantity: HistoryQuantity) -> String {
    format!("the header is such as: time (s), {} ({})", quantity.word(), quantity.dimension().si_unit())
}

/// The lines that say something.
pub(super) fn lines_of(source: &SourceText) -> impl Iterator<Item = Place> + '_ {
    let mut start = 0;
    source.text().split_inclusive('\n').filter_map(move |line| {
        let begin = start;
        start += line.len();
        // A byte-order mark is no part of a name.
        let skip = line.len() - line.trim_start_matches(['\u{feff}', ' ', '\t']).len();
        let words = line.trim_start_matches(['\u{feff}', ' ', '\t']).trim_end();
        (!words.is_empty() && !words.starts_with('#'))
            .then(|| Place { source: source.clone(), span: begin + skip..begin + skip + words.len() })
    })
}

pub(super) fn written(place: &Place) -> &str {
    place.source.text().get(place.span.clone()).unwrap_or("")
}

/// The cells of a line, trimmed.
pub(super) fn cells_of(line: &Place) -> Vec<Place> {
    let mut start = line.span.start;
    written(line)
        .split(',')
        .map(|cell| {
            let begin = start + cell.len() - cell.trim_start().len();
            start += cell.len() + 1;
            Place { source: line.source.clone(), span: begin..begin + cell.trim().len() }
        })
        .collect()
}

/// The names of a header line: the first column is given, of the others some are known.
pub(super) fn headers(
    line: &Place,
    units: Units,
    (first, first_dimension): (&str, Dimension),
    known: impl Fn(&str) -> Option<Dimension>,
    help: &str,
) -> Result<Vec<Header>, SceneError> {
    let mut headers: Vec<Header> = Vec::new();
    for (index, place) in cells_of(line).into_iter().enumerate() {
        let text = written(&place);
        let (name, unit) = match text.split_once('(') {
            Some((name, rest)) => match rest.strip_suffix(')') {
                Some(unit) => (name.trim(), unit.trim()),
                None => return Err(SceneError::at(&place, format!("the column `{text}` has no `)`"), "here").help(help)),
            },
            None => (text, ""),
        };
        let wanted = if index == 0 { Some(first_dimension) } else { known(name) };
        if name.is_empty() || (index == 0) != (name == first) {
            let message =
                if index == 0 { format!("the first column is `{name}`, not `{first}`") } else { format!("`{text}` names no column") };
            return Err(SceneError::at(&place, message, "here").help(help));
        }
        if headers.iter().any(|other| other.name == name) {
            return Err(SceneError::at(&place, format!("the column `{name}` stands twice"), "leave one out"));
        }
        let dimension = match (units, unit) {
            (Units::Reduced, "" | "1") => wanted.unwrap_or(Dimension::NUMBER),
            (Units::Reduced, _) => {
                let message = format!("the column `{text}` has a unit, in a scene in reduced units");
                return Err(SceneError::at(&place, message, "leave the unit out"));
            }
            (Units::Si, "") if wanted.is_some() => {
                return Err(SceneError::at(&place, format!("the column `{name}` has no unit"), "here").help(help));
            }
            (Units::Si, unit) => {
                let found = parse_quantity(&format!("1 {unit}")).map_err(|error| {
                    SceneError::at(&place, format!("the unit of the column `{text}` cannot be read: {error}"), "here").help(help)
                })?;
                if let Some(wanted) = wanted.filter(|wanted| !found.dimension.measures(*wanted)) {
                    let message = format!("the column `{text}` has the wrong unit: it is measured in {}", found.dimension.si_unit());
                    return Err(SceneError::at(&place, message, format!("must be measured in {}", wanted.si_unit())));
                }
                wanted.unwrap_or(found.dimension)
            }
        };
        headers.push(Header { name: name.to_owned(), dimension, unit: unit.to_owned(), place });
    }
    Ok(headers)
}

/// A cell in coherent units.
pub(super) fn number(cell: &Place, header: &Header, must: bool) -> Result<Option<f64>, SceneError> {
    let text = written(cell);
    if text.is_empty() && !must {
        return Ok(None);
    }
    let plain = text.parse::<f64>().ok().filter(|value| value.is_finite());
    // Read with its unit, so that it is rounded once.
    let value = plain.and_then(|_| parse_quantity(&format!("{text} {}", header.unit)).ok()).map(|quantity| quantity.value + 0.0);
    value.filter(|value| value.is_finite()).map(Some).ok_or_else(|| {
        let what = if text.is_empty() { "is empty".to_owned() } else { format!("= {text:?} is no number") };
        // An empty cell has no width to point at.
        let place = if text.is_empty() { &header.place } else { cell };
        let line = 1 + cell.source.text().get(..cell.span.start).unwrap_or("").matches('\n').count();
        SceneError::at(place, format!("`{}` {what}, in line {line}", header.name), "must be a finite number without a unit")
    })
}
