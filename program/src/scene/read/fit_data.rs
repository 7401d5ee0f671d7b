//! The data of a fit: the columns that are compared, and what they are given against.

use super::fit::along;
use super::force_curve_header::laid_open;
use super::record::names;
use super::section::Section;
use super::table_columns::{Column, Columns, Wanted, plain};
use crate::scene::check::Units;
use crate::scene::delimited::{DelimitedTable, Options};
use crate::scene::diagnostic::{Place, SceneError, SourceText, nearest};
use crate::scene::typed::{FitColumn, FitTable};
use crate::scene::units::Dimension;

/// A column that a fit looks for.
pub(super) struct Wish {
    pub(super) word: String,
    /// What it must be measured in, if the scene knows.
    pub(super) dimension: Option<Dimension>,
    pub(super) required: bool,
}

impl Wish {
    pub(super) fn of(word: &str, required: bool, along_a_history: bool) -> Self {
        Self { word: word.to_owned(), dimension: along(word).filter(|_| along_a_history), required }
    }
}

const HELP: &str = "the header is such as: time (s), force (mN)";

/// Reads the columns of a file; every row must hold a number in each.
pub(super) fn table(
    file: &str,
    place: Place,
    source: &SourceText,
    wishes: &[Wish],
    stated: Option<&Section<'_>>,
    units: Units,
) -> Result<FitTable, SceneError> {
    let source = laid_open(source).map_or_else(|| source.clone(), |text| SourceText::decoded(source.name(), text, source.encoding()));
    let read = DelimitedTable::read(&source, &Options { help: HELP })?;
    let Some(first) = read.blocks().first() else { return Err(SceneError::at(&place, format!("{file:?} is empty"), "this file")) };
    let columns = Columns::new(&read, first, file, units, (("columns", "in its [[fit.test]]"), stated), HELP);
    columns.checked()?;
    let mut found: Vec<(Column, &Wish)> = Vec::new();
    for wish in wishes {
        if found.iter().any(|(_, other)| other.word == wish.word) {
            continue;
        }
        match column(&columns, wish)? {
            Some(column) => found.push((column, wish)),
            None if wish.required => {
                let headers = columns.headers();
                let near = nearest(&wish.word, headers.iter().map(String::as_str));
                let label = near.map_or_else(|| "no such column".to_owned(), |near| format!("did you mean `{near}` to be it?"));
                let message = format!("{file:?} has no column `{}`", wish.word);
                return Err(
                    SceneError::at(&columns.header_place(), message, label).help(format!("its columns are: {}", headers.join(", ")))
                );
            }
            None => {}
        }
    }
    let mut values: Vec<Vec<f64>> = vec![Vec::new(); found.len()];
    let mut buffer = String::new();
    for block in read.blocks() {
        for row in read.rows(block) {
            for ((column, _), values) in found.iter().zip(&mut values) {
                values.push(columns.number(row, column, &mut buffer)?);
            }
        }
    }
    let columns = found
        .into_iter()
        .zip(values)
        .map(|((column, wish), values)| FitColumn {
            word: wish.word.clone(),
            dimension: column.scale.dimension,
            place: column.place,
            values,
        })
        .collect();
    Ok(FitTable { file: file.to_owned(), place, columns })
}

/// The column of a wish: by its names along a history, else by its own word.
fn column(columns: &Columns<'_>, wish: &Wish) -> Result<Option<Column>, SceneError> {
    if let Some(dimension) = wish.dimension {
        let own = plain(&wish.word);
        let mut all: Vec<&str> = names(&wish.word).to_vec();
        if !all.contains(&own.as_str()) {
            all.push(&own);
        }
        return columns.find(&Wanted { word: &wish.word, dimension, names: &all });
    }
    let wanted = plain(&wish.word);
    let is = |index: &usize| columns.other(*index).is_some_and(|column| plain(&column.name) == wanted);
    Ok((0..columns.headers().len()).find(is).and_then(|index| columns.other(index)))
}
