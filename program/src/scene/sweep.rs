//! Sweeps: any number of a scene, at many values.

mod latin_hypercube;
mod meant;

use super::catalogue::{self, Key, Kind, Range};
use super::check::{self, Units};
use super::diagnostic::{Place, SceneError};
use super::document::{Document, Node, Value};
use super::read::history::dependent_kind;
use super::read::{has_table, is_number, range_of};
use super::units::Dimension;
use super::written_units::WrittenUnits;
use latin_hypercube::Cube;

/// One swept number.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// Its dotted path.
    pub key: String,
    /// Its values in SI (or reduced) units, in order.
    pub values: Vec<f64>,
    /// Its SI unit.
    pub unit: String,
    /// Whether the values have equal ratios: a plot of them is then logarithmic.
    pub logarithmic: bool,
    /// Whether all sweeps of the scene go through their values side by side instead of in all combinations.
    pub together: bool,
    /// The units of its values as they are written.
    pub written: WrittenUnits,
    place: Place,
}

impl PartialEq for Sweep {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key && self.values == other.values
    }
}

impl Sweep {
    /// Where its key stands.
    pub(super) const fn place(&self) -> &Place {
        &self.place
    }

    /// Puts value number `index` into a document.
    ///
    /// # Errors
    /// A path that does not exist.
    pub fn put(&self, document: &mut Document, index: usize) -> Result<(), SceneError> {
        let Some(&value) = self.values.get(index) else { return Ok(()) };
        document.replace(&self.key, Node { value: Value::Number(value), place: self.place.clone() })
    }
}

/// The number of states of several sweeps.
#[must_use]
pub fn states(sweeps: &[Sweep]) -> usize {
    if let Some(first) = sweeps.first().filter(|_| is_together(sweeps)) {
        return first.values.len();
    }
    sweeps.iter().map(|sweep| sweep.values.len()).product()
}

/// Whether all sweeps go through their values side by side.
#[must_use]
pub fn is_together(sweeps: &[Sweep]) -> bool {
    sweeps.iter().any(|sweep| sweep.together)
}

/// The value indices of state number `state`, the last sweep varying fastest.
#[must_use]
pub fn indices(sweeps: &[Sweep], mut state: usize) -> Vec<usize> {
    if is_together(sweeps) {
        return vec![state; sweeps.len()];
    }
    let mut indices: Vec<usize> = sweeps
        .iter()
        .rev()
        .map(|sweep| {
            let length = sweep.values.len().max(1);
            let index = state % length;
            state /= length;
            index
        })
        .collect();
    indices.reverse();
    indices
}

/// More states than this are a slip of the keyboard, or need another program.
const MOST_STATES: usize = 20_000_000;

/// Reads the `sweep` of a scene.
pub(super) fn read(root: &Node, units: Units) -> Result<Vec<Sweep>, SceneError> {
    let cube = root.get("latin_hypercube").map(Cube::read).transpose()?;
    let Some(node) = root.get("sweep") else {
        return match root.get("latin_hypercube") {
            None => Ok(Vec::new()),
            Some(cube) => Err(SceneError::at(&first_line(&cube.place), "`latin_hypercube` has nothing to vary", "no `sweep` is given")
                .help("add [[sweep]] with key, from and to for each number to vary")),
        };
    };
    let tables: Vec<&Node> = match &node.value {
        Value::List(items) => items.iter().collect(),
        _ => vec![node],
    };
    if tables.is_empty() {
        return Err(SceneError::at(&node.place, "`sweep` is an empty list", "leave it out for a single state"));
    }
    let mut sweeps: Vec<Sweep> = Vec::with_capacity(tables.len());
    for (number, table) in tables.into_iter().enumerate() {
        let sweep = read_one(root, table, units, cube.as_ref().map(|cube| (cube, number as u64)))?;
        if sweeps.iter().any(|other| other.key == sweep.key) {
            return Err(SceneError::at(&sweep.place, format!("`{}` is swept twice", sweep.key), "leave one out"));
        }
        sweeps.push(sweep);
    }
    if cube.is_some() {
        return Ok(sweeps);
    }
    let total = sweeps.iter().try_fold(1_usize, |product, sweep| product.checked_mul(sweep.values.len()));
    if total.is_none_or(|states| states > MOST_STATES) {
        return Err(SceneError::at(&node.place, format!("the sweep has more than {MOST_STATES} states"), "make it smaller"));
    }
    Ok(sweeps)
}

fn read_one(root: &Node, table: &Node, units: Units, cube: Option<(&Cube, u64)>) -> Result<Sweep, SceneError> {
    let missing = |key: &str, place: &Place| {
        let meaning = catalogue::key(&format!("sweep.{key}")).map_or("", |entry| entry.meaning);
        SceneError::at(place, format!("`sweep.{key}` is missing"), "in this table").help(format!("sweep.{key}: {meaning}"))
    };
    let header = first_line(&table.place);
    let key_node = table.get("key").ok_or_else(|| missing("key", &header))?;
    let Value::Text(path) = &key_node.value else { return Err(missing("key", &header)) };
    let (key, dimension, range) = varied_key(root, path, &key_node.place, "sweep.key")?;
    let unit = if units == Units::Si { dimension.si_unit() } else { "1".to_owned() };
    let value_of = |node: &Node| -> Result<f64, SceneError> {
        let value = check::number(node, path, dimension, units)?;
        match key.kind {
            Kind::Count { least, most } => check::count(node, path, least, most).map(f64::from),
            _ => check::check_range(node, path, value, range).map(|()| value),
        }
    };
    if let (Some(_), Some((name, given))) = (cube, ["values", "points"].into_iter().find_map(|name| Some((name, table.get(name)?)))) {
        let message = format!("`sweep.{name}` has no place beside [latin_hypercube], which chooses the values");
        return Err(SceneError::at(&given.place, message, "leave it out, and give `from` and `to`"));
    }
    let (values, logarithmic) = match (table.get("values"), table.get("from"), table.get("to"), table.get("points")) {
        (Some(list), None, None, None) => {
            let Value::List(items) = &list.value else { return Err(missing("values", &header)) };
            if items.is_empty() {
                return Err(SceneError::at(&list.place, "`sweep.values` is an empty list", "name at least one value"));
            }
            if let Some(spacing) = table.get("spacing") {
                return Err(SceneError::at(&spacing.place, "`sweep.spacing` belongs to from, to and points", "leave it out"));
            }
            let values = items.iter().map(value_of).collect::<Result<Vec<_>, _>>()?;
            let spread = values.iter().all(|&value| value > 0.0) && ratio(&values) > 30.0;
            (values, spread)
        }
        (Some(list), ..) => {
            let message = "`sweep.values` and `sweep.from`, `to`, `points` exclude each other";
            return Err(SceneError::at(&list.place, message, "give one or the other"));
        }
        (None, from, to, points) => {
            let from = from.ok_or_else(|| missing("from", &header))?;
            let to = to.ok_or_else(|| missing("to", &header))?;
            let linear = matches!(table.get("spacing").map(|node| &node.value), Some(Value::Text(word)) if word == "linear");
            let (first, last) = (value_of(from)?, value_of(to)?);
            if !linear && (first <= 0.0 || last <= 0.0) {
                let place = if first <= 0.0 { &from.place } else { &to.place };
                let message = "a logarithmic sweep runs over positive values only";
                return Err(SceneError::at(place, message, "must be greater than 0").help("or write spacing = \"linear\""));
            }
            let mut values = match cube {
                Some((cube, number)) => cube.parts(number).into_iter().map(|part| between(first, last, part, linear)).collect(),
                None => {
                    let points = points.ok_or_else(|| missing("points", &header))?;
                    spread(first, last, check::count(points, "sweep.points", 1, 10_000_000)?, linear)
                }
            };
            if matches!(key.kind, Kind::Count { .. }) {
                values.iter_mut().for_each(|value| *value = value.round());
            }
            (values, !linear)
        }
    };
    // A temperature in °C is more than a number of units.
    let written = if dimension == Dimension::TEMPERATURE { WrittenUnits::default() } else { WrittenUnits::of(table) };
    Ok(Sweep { key: path.clone(), values, unit, logarithmic, together: cube.is_some(), written, place: key_node.place.clone() })
}

/// The catalogue entry of the path of a number that `named_by` gives, after checking that it is a number and that its table exists; with what it is measured in.
pub(super) fn varied_key(root: &Node, path: &str, place: &Place, named_by: &str) -> Result<(&'static Key, Dimension, Range), SceneError> {
    let key = swept_key(root, path, place, named_by)?;
    let (dimension, range) = match key.kind {
        Kind::Number { dimension, .. } => (dimension, range_of(key)),
        _ => dependent_kind(root, path, key).unwrap_or((Dimension::NUMBER, range_of(key))),
    };
    Ok((key, dimension, range))
}

fn swept_key(root: &Node, path: &str, place: &Place, named_by: &str) -> Result<&'static Key, SceneError> {
    let generic = catalogue::generic_path(path);
    if generic == "sweep" || generic.starts_with("sweep.") || generic.starts_with("sweep[]") {
        return Err(SceneError::at(place, format!("`{named_by}` = {path:?}: a sweep cannot vary itself"), "name a number outside [sweep]"));
    }
    // `history[]` is every segment, not one.
    let is_place = !path.contains('[');
    let Some(key) = catalogue::key(&generic).filter(|key| is_place && (is_number(key) || dependent_kind(root, path, key).is_some())) else {
        let what = if is_place && catalogue::key(&generic).is_some() { "takes no number" } else { "is not a key" };
        let meant = meant::number(root, path);
        let label = meant.as_ref().map_or_else(|| "no number of a scene".to_owned(), |name| format!("did you mean `{name}`?"));
        let error = SceneError::at(place, format!("`{named_by}` = {path:?} {what}"), label);
        // A segment has no name: it is found by its number.
        let counted = meant.filter(|name| name.split('.').any(|part| part.bytes().all(|byte| byte.is_ascii_digit())));
        return Err(match counted.as_deref().and_then(|name| name.split('.').next()) {
            Some(list) => error.help(format!("the tables of [[{list}]] count from 0: {list}.0 is the first")),
            None => error,
        });
    };
    let table = path.rsplit_once('.').map_or("", |(table, _)| table);
    if has_table(root, table) {
        Ok(key)
    } else {
        if let Some((list, index)) = table.rsplit_once('.')
            && let Some(Node { value: Value::List(items), .. }) = root.at(list)
        {
            let message = format!("`{named_by}` = {path:?} does not exist: `{list}` has {} items, counted from 0", items.len());
            return Err(SceneError::at(place, message, format!("{index} is none of them")));
        }
        let message = format!("`{named_by}` = {path:?} lies in [{table}], which the scene does not have");
        Err(SceneError::at(place, message, "a table that is absent is an effect that is not simulated").help(format!("add [{table}]")))
    }
}

fn spread(first: f64, last: f64, count: u32, linear: bool) -> Vec<f64> {
    let steps = f64::from(count.saturating_sub(1).max(1));
    (0..count)
        .map(|index| {
            // Both ends are met exactly.
            let part = f64::from(index) / steps;
            if index == 0 {
                first
            } else if index + 1 == count {
                last
            } else {
                between(first, last, part, linear)
            }
        })
        .collect()
}

/// The value at a part of the way from the first to the last.
fn between(first: f64, last: f64, part: f64, linear: bool) -> f64 {
    let value = if linear { first + (last - first) * part } else { 10f64.powf(first.log10() + (last.log10() - first.log10()) * part) };
    // Rounding must not carry a value past an end, which may be the end of what is allowed.
    value.clamp(first.min(last), first.max(last))
}

fn ratio(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), &value| (low.min(value), high.max(value)));
    high / low
}

fn first_line(place: &Place) -> Place {
    let text = place.source.text().get(place.span.clone()).unwrap_or("");
    let length = text.find('\n').unwrap_or(text.len());
    Place { source: place.source.clone(), span: place.span.start..place.span.start + length }
}
