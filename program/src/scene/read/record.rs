//! A file that a history follows: its columns by name or as the scene says, its rows, and the polyline that is followed.
//!
//! ```text
//! # a comment
//! time (s), penetration (µm), force (mN)
//! 0.0,      0.00,             0.00
//! 0.5,      1.20,             0.35
//! ```
//! A header with names and, in SI scenes, units; then numbers. Several blocks with the same header are one record. Columns that are not controlled are
//! measured data: `force` of an indentation and `growth` of a crack are compared with the result, all others are named in a note.

use super::force_curve_header::laid_open;
use super::record_corners::corners;
use super::section::Section;
use super::table_columns::{Column, Columns, Wanted, plain};
use crate::scene::delimited::{Block, Cell, DelimitedTable, Options};
use crate::scene::diagnostic::{Place, SceneError, SourceText, nearest};
use crate::scene::document::{Document, Value};
use crate::scene::typed::{HistoryQuantity, MeasuredColumn, MeasuredTable};
use crate::scene::units::Dimension;

/// Headers that mean a quantity, as they stand without blanks and in small letters.
const NAMES: &[(&str, &[&str])] = &[
    ("time", &["time", "t", "timestamp", "testtime", "elapsedtime", "zeit", "temps"]),
    ("penetration", &["penetration", "penetrationdepth", "indentation", "indentationdepth", "depth", "eindringtiefe"]),
    ("force", &["force", "load", "normalforce", "normalload", "kraft", "normalkraft"]),
    ("contact_radius", &["contactradius"]),
    ("frame", &["frame"]),
    ("stress_intensity", &["stressintensity", "k"]),
    ("stress", &["stress"]),
    ("growth", &["growth", "cracklength", "crackgrowth"]),
];
/// A time that counts through all segments of a force curve, where `time` begins anew in each.
const THROUGH_ALL: &str = "seriestime";
/// Columns that are compared with the result.
const COMPARED: [(&str, Dimension); 2] = [("force", Dimension::FORCE), ("growth", Dimension::LENGTH)];

pub(super) fn names(word: &str) -> &'static [&'static str] {
    NAMES.iter().find(|entry| entry.0 == word).map_or(&[], |entry| entry.1)
}

/// The record that a segment names; `accuracy` is that of the scene.
pub(super) fn record(
    item: &Section<'_>,
    document: &Document,
    quantity: HistoryQuantity,
    accuracy: f64,
) -> Result<MeasuredTable, SceneError> {
    let file = item.required_text("table")?;
    let Some(attached) = document.attached(file) else {
        let message = format!("`{}` = {file:?} was not read with the scene", item.full("table"));
        return Err(item.wrong("table", message, "this file"));
    };
    let help = example(quantity);
    let source =
        laid_open(attached).map_or_else(|| attached.clone(), |text| SourceText::decoded(attached.name(), text, attached.encoding()));
    let table = DelimitedTable::read(&source, &Options { help: &help })?;
    let stated = item.table("columns");
    let path = ("columns", "in this segment of the history");
    let Some(first) = table.blocks().first() else { return Err(item.wrong("table", format!("{file:?} is empty"), "this file")) };
    let columns = Columns::new(&table, first, file, item.units(), (path, stated.as_ref()), &help);
    columns.checked()?;
    let mut notes = table.notes().to_vec();
    let time = time_column(&columns, file, &help, &mut notes)?;
    let controlled = controlled_column(&columns, quantity, file, &help)?;
    let reading = Reading::of(item, quantity)?;
    let mut compared = Vec::new();
    for (word, dimension) in COMPARED.into_iter().filter(|entry| entry.0 != quantity.word()) {
        if let Some(column) = columns.find(&Wanted { word, dimension, names: names(word) })? {
            compared.push((word, dimension, column));
        }
    }
    if let (Some(stated), Some(word)) = (&stated, stated.as_ref().and_then(|stated| unused_word(stated.node(), quantity))) {
        let message = format!("`{}` has no effect: the record controls `{}`", stated.full(word), quantity.word());
        return Err(stated.wrong(word, message, "leave it out"));
    }
    let reader = Reader { table: &table, time, controlled, compared, reading, quantity };
    let mut rows =
        Rows { times: Vec::new(), values: Vec::new(), others: reader.compared.iter().map(|_| Vec::new()).collect(), repeated: 0 };
    for (number, block) in table.blocks().iter().enumerate() {
        same_columns(&table, first, block, file)?;
        reader.add(&mut rows, &Columns::new(&table, block, file, item.units(), (path, stated.as_ref()), &help), block, number > 0)?;
    }
    let Reader { time, controlled, compared, .. } = reader;
    if rows.times.len() < 2 {
        let message = format!("{file:?} has {} rows", rows.times.len());
        return Err(SceneError::at(&columns.header_place(), message, "needs at least two below this line"));
    }
    let taken: Vec<usize> = [time.index, controlled.index].into_iter().chain(compared.iter().map(|(.., column)| column.index)).collect();
    let begin = rows.times.first().copied().unwrap_or(0.0);
    rows.times.iter_mut().for_each(|time| *time -= begin);
    let mut others: Vec<MeasuredColumn> = compared
        .iter()
        .zip(rows.others)
        .map(|((word, dimension, _), values)| MeasuredColumn { name: (*word).to_owned(), dimension: *dimension, values })
        .collect();
    if rows.repeated == 0 {
        others.extend(further(&columns, &table, &taken));
    } else {
        notes.push(format!("{file:?}: the first row of {} parts repeats the time before it, and is left out", rows.repeated));
    }
    let unused: Vec<String> = columns
        .headers()
        .into_iter()
        .enumerate()
        .filter(|(index, name)| !taken.contains(index) && !name.is_empty())
        .map(|(_, name)| format!("`{name}`"))
        .collect();
    if !unused.is_empty() {
        notes.push(format!("{file:?}: not used: {}", unused.join(", ")));
    }
    let followed = corners(item, quantity, file, rows.times, rows.values, accuracy)?;
    Ok(MeasuredTable {
        file: file.to_owned(),
        times: followed.corners.iter().map(|corner| corner.0).collect(),
        values: followed.corners.iter().map(|corner| corner.1).collect(),
        rows: followed.rows,
        others,
        thinning: followed.thinning,
        notes,
    })
}

fn example(quantity: HistoryQuantity) -> String {
    format!("the header is such as: time (s), {} ({})", quantity.word(), quantity.dimension().si_unit())
}

/// The column of the time; one that counts through all segments of a force curve goes first.
fn time_column(columns: &Columns<'_>, file: &str, help: &str, notes: &mut Vec<String>) -> Result<Column, SceneError> {
    let wanted = |names| Wanted { word: "time", dimension: Dimension::TIME, names };
    let through = columns.find(&wanted(&[THROUGH_ALL]))?;
    if let Some(column) = through {
        if plain(&column.name) == THROUGH_ALL && columns.headers().iter().any(|header| plain(header).starts_with("time")) {
            notes.push(format!("{file:?}: the time is `{}`, which counts through all its segments", column.name));
        }
        return Ok(column);
    }
    columns.find(&wanted(names("time")))?.ok_or_else(|| {
        let message = format!("{file:?} has no column `time`");
        SceneError::at(&columns.header_place(), message, "no such column").help(help)
    })
}

fn controlled_column(columns: &Columns<'_>, quantity: HistoryQuantity, file: &str, help: &str) -> Result<Column, SceneError> {
    let word = quantity.word();
    let wanted = Wanted { word, dimension: quantity.dimension(), names: names(word) };
    columns.find(&wanted)?.ok_or_else(|| {
        let headers = columns.headers();
        let near = nearest(word, headers.iter().map(String::as_str));
        let label = near.map_or_else(|| "no such column".to_owned(), |name| format!("did you mean `{name}` to be it?"));
        let naming = format!(
            "{help}; or name the column in this segment of the history: columns = {{ {word} = \"NAME in {}\" }}",
            quantity.dimension().si_unit()
        );
        SceneError::at(&columns.header_place(), format!("{file:?} has no column `{word}`"), label).help(naming)
    })
}

/// A column that the scene names and nothing reads.
fn unused_word(columns: &crate::scene::document::Node, quantity: HistoryQuantity) -> Option<&str> {
    let read = |word: &str| word == "time" || word == quantity.word() || COMPARED.iter().any(|entry| entry.0 == word);
    columns.entries().iter().map(|entry| entry.key.as_str()).find(|word| !read(word))
}

/// Blocks of one record have the same columns.
fn same_columns(table: &DelimitedTable, first: &Block, block: &Block, file: &str) -> Result<(), SceneError> {
    let names = |block: &Block| block.header.iter().chain(&block.units).map(|cell| table.text(*cell).into_owned()).collect::<Vec<_>>();
    if names(first) == names(block) {
        return Ok(());
    }
    let line = block.header.first().map_or(0, |cell| table.line(*cell));
    let message = format!("{file:?} has other columns from line {line} on than above");
    Err(SceneError::at(&table.row_place(&block.header), message, "all parts of a record have the same columns")
        .help("put the parts into files of their own, one segment of the history each"))
}

/// From what the instrument shows to the controlled quantity.
struct Reading {
    sign: f64,
    zero: f64,
}

impl Reading {
    fn of(item: &Section<'_>, quantity: HistoryQuantity) -> Result<Self, SceneError> {
        let inverted = matches!(item.value("invert").map(|node| &node.value), Some(Value::Flag(true)));
        let zero = match item.value("contact_point") {
            Some(_) => super::history::dependent(item, "contact_point", quantity.dimension(), crate::scene::catalogue::Range::Finite)?,
            None => 0.0,
        };
        Ok(Self { sign: if inverted { -1.0 } else { 1.0 }, zero })
    }

    fn value(&self, shown: f64) -> f64 {
        self.sign * (shown - self.zero) + 0.0
    }
}

struct Rows {
    times: Vec<f64>,
    values: Vec<f64>,
    others: Vec<Vec<Option<f64>>>,
    /// Rows that repeat the time of the last one of the part before.
    repeated: usize,
}

/// Takes the rows of a block.
struct Reader<'r> {
    table: &'r DelimitedTable,
    time: Column,
    controlled: Column,
    compared: Vec<(&'static str, Dimension, Column)>,
    reading: Reading,
    quantity: HistoryQuantity,
}

impl Reader<'_> {
    fn add(&self, rows: &mut Rows, columns: &Columns<'_>, block: &Block, follows: bool) -> Result<(), SceneError> {
        let mut buffer = String::new();
        for (number, row) in self.table.rows(block).enumerate() {
            let now = columns.number(row, &self.time, &mut buffer)?;
            let value = self.reading.value(columns.number(row, &self.controlled, &mut buffer)?);
            if let Some(before) = rows.times.last().copied().filter(|before| now <= *before) {
                let begins = follows && number == 0;
                // The last row of one part and the first of the next may be one.
                if begins && now.total_cmp(&before).is_eq() {
                    rows.repeated += 1;
                    continue;
                }
                let message =
                    format!("`{}` = {} does not increase: the row before has {before:e}", self.time.name, self.shown(row, &self.time));
                let wrong = SceneError::at(&self.place(row, &self.time), message, "must be later");
                let help = "its time begins anew in each part: name a column that counts through all of them, or put the parts into files of their own";
                return Err(if begins { wrong.help(help) } else { wrong });
            }
            if !self.quantity.range().holds(value) {
                let message = format!("`{}` = {} is out of range", self.controlled.name, self.shown(row, &self.controlled));
                return Err(SceneError::at(
                    &self.place(row, &self.controlled),
                    message,
                    format!("must be {}", self.quantity.range().words()),
                ));
            }
            rows.times.push(now);
            rows.values.push(value);
            for ((.., column), values) in self.compared.iter().zip(&mut rows.others) {
                let missing = row.get(column.index).is_none_or(|cell: &Cell| self.table.is_missing(*cell));
                values.push(if missing { None } else { Some(columns.number(row, column, &mut buffer)?) });
            }
        }
        Ok(())
    }

    fn place(&self, row: &[Cell], column: &Column) -> Place {
        row.get(column.index).map_or_else(|| column.place.clone(), |cell| self.table.place(*cell))
    }

    fn shown(&self, row: &[Cell], column: &Column) -> String {
        row.get(column.index).map(|cell| self.table.text(*cell).into_owned()).unwrap_or_default()
    }
}

/// Measured columns without a role: those whose units and numbers can be read.
fn further(columns: &Columns<'_>, table: &DelimitedTable, taken: &[usize]) -> Vec<MeasuredColumn> {
    let mut buffer = String::new();
    (0..columns.headers().len())
        .filter(|index| !taken.contains(index))
        .filter_map(|index| columns.other(index))
        .map(|column| {
            let rows = table.blocks().iter().flat_map(|block| table.rows(block));
            let values = rows.map(|row| table.number(*row.get(column.index)?, &column.scale, &mut buffer)).collect();
            MeasuredColumn { name: column.name, dimension: column.scale.dimension, values }
        })
        .collect()
}
