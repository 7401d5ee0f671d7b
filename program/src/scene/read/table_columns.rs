//! Columns of a record or a scan: which header means what, by its name or as the scene says, and in which unit.

use super::section::Section;
use crate::scene::check::Units;
use crate::scene::delimited::{Block, Cell, DelimitedTable, Scale, bare_unit};
use crate::scene::diagnostic::{Place, SceneError, nearest};
use crate::scene::units::Dimension;

/// What a reader looks for.
pub(super) struct Wanted<'w> {
    /// The word in messages, and the key in the table of columns.
    pub(super) word: &'w str,
    pub(super) dimension: Dimension,
    /// Headers that mean it, as [`plain`] writes them.
    pub(super) names: &'w [&'w str],
}

/// A column that was found.
#[derive(Debug, Clone)]
pub(super) struct Column {
    pub(super) index: usize,
    /// Its name in the header, without the unit.
    pub(super) name: String,
    pub(super) scale: Scale,
    pub(super) place: Place,
}

/// The header of a block and what the scene says about it.
pub(super) struct Columns<'c> {
    table: &'c DelimitedTable,
    block: &'c Block,
    /// The file, as the scene names it.
    file: &'c str,
    units: Units,
    /// The table of columns of the scene, if there is one, and what it is called in messages.
    stated: Option<&'c Section<'c>>,
    /// The key of that table as a remedy writes it, and where.
    path: (&'c str, &'c str),
    help: &'c str,
}

/// A unit in the spelling of scenes.
fn spelt(unit: &str) -> &str {
    match unit {
        "sec" | "secs" | "seconds" => "s",
        "msec" => "ms",
        "micron" | "microns" | "mic" => "µm",
        "Angstrom" | "angstrom" | "Ang" => "Å",
        other => other,
    }
}

/// A name in small letters, without blanks and strokes.
pub(super) fn plain(name: &str) -> String {
    name.to_lowercase().chars().filter(|c| !matches!(c, ' ' | '_' | '-' | '.' | '*')).collect()
}

/// The name and the unit of a header: `force (mN)`, `force [mN]`, `force / mN`, `Lateral(um)`.
fn split(header: &str) -> (&str, Option<&str>) {
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some((name, rest)) = header.rsplit_once(open)
            && let Some(unit) = rest.trim_end().strip_suffix(close)
            && !name.trim().is_empty()
        {
            return (name.trim(), Some(unit.trim()));
        }
    }
    match header.split_once('/') {
        Some((name, unit)) if !name.trim().is_empty() && !unit.trim().is_empty() => (name.trim(), Some(unit.trim())),
        _ => (header.trim(), None),
    }
}

impl<'c> Columns<'c> {
    pub(super) const fn new(
        table: &'c DelimitedTable,
        block: &'c Block,
        file: &'c str,
        units: Units,
        (path, stated): ((&'c str, &'c str), Option<&'c Section<'c>>),
        help: &'c str,
    ) -> Self {
        Self { table, block, file, units, stated, path, help }
    }

    /// All headers, whole.
    pub(super) fn headers(&self) -> Vec<String> {
        self.block.header.iter().map(|cell| self.table.text(*cell).into_owned()).collect()
    }

    pub(super) fn place(&self, index: usize) -> Place {
        self.block.header.get(index).map_or_else(|| self.table.row_place(&self.block.header), |cell| self.table.place(*cell))
    }

    /// The whole header.
    pub(super) fn header_place(&self) -> Place {
        self.table.row_place(&self.block.header)
    }

    /// Refuses brackets that do not close, and a name that stands twice.
    pub(super) fn checked(&self) -> Result<(), SceneError> {
        let headers = self.headers();
        for (index, header) in headers.iter().enumerate() {
            if header.contains('(') && !header.contains(')') {
                return Err(SceneError::at(&self.place(index), format!("the column `{header}` has no `)`"), "here").help(self.help));
            }
            let name = split(header).0;
            if !name.is_empty() && headers.iter().take(index).any(|other| split(other).0 == name) {
                return Err(SceneError::at(&self.place(index), format!("the column `{name}` stands twice"), "leave one out"));
            }
        }
        Ok(())
    }

    /// The column of a quantity, if there is one; the scene's word goes before all names.
    pub(super) fn find(&self, wanted: &Wanted<'_>) -> Result<Option<Column>, SceneError> {
        let headers = self.headers();
        if let Some((columns, text)) = self.stated.and_then(|columns| Some((columns, columns.text(wanted.word)?))) {
            return self.stated(columns, text, wanted, &headers).map(Some);
        }
        let meant = |header: &&(usize, &String)| wanted.names.contains(&plain(split(header.1).0).as_str());
        let all: Vec<(usize, &String)> = headers.iter().enumerate().collect();
        let mut found = all.iter().filter(meant);
        let (Some(&(index, header)), second) = (found.next(), found.next()) else { return Ok(None) };
        if let Some((other, second)) = second {
            let message = format!("`{header}` and `{second}` in {:?} can both be the {}", self.file, wanted.word.replace('_', " "));
            return Err(SceneError::at(&self.place(*other), message, "which of the two?").help(self.naming(wanted, header)));
        }
        let (name, unit) = split(header);
        self.column(index, name, unit, None, wanted).map(Some)
    }

    /// What to type for a column that is meant.
    fn naming(&self, wanted: &Wanted<'_>, header: &str) -> String {
        let (name, unit) = split(header);
        let unit = unit.filter(|unit| Scale::of(unit).is_ok_and(|scale| scale.dimension.measures(wanted.dimension)));
        let unit = match (self.units, unit) {
            (Units::Reduced, _) => String::new(),
            (Units::Si, Some(unit)) => format!(" in {unit}"),
            (Units::Si, None) => format!(" in {}", wanted.dimension.si_unit()),
        };
        format!("say which {}: {} = {{ {} = \"{name}{unit}\" }}", self.path.1, self.path.0, wanted.word)
    }

    /// The column that the scene names.
    fn stated(&self, columns: &Section<'_>, text: &str, wanted: &Wanted<'_>, headers: &[String]) -> Result<Column, SceneError> {
        let is = |name: &str| headers.iter().position(|header| header == name || split(header).0 == name);
        let (index, unit) = match (is(text.trim()), text.rsplit_once(" in ")) {
            (Some(index), _) => (Some(index), None),
            (None, Some((name, unit))) => (is(name.trim()), Some(unit.trim())),
            (None, None) => (None, None),
        };
        let Some((index, header)) = index.and_then(|index| Some((index, headers.get(index)?))) else {
            let message = format!("`{}` = {text:?}: {:?} has no such column", columns.full(wanted.word), self.file);
            let label = nearest(text, headers.iter().map(String::as_str))
                .map_or_else(|| "no such column".to_owned(), |near| format!("did you mean `{near}`?"));
            return Err(columns.wrong(wanted.word, message, label).help(format!("its columns are: {}", headers.join(", "))));
        };
        let (name, own) = split(header);
        self.column(index, name, own, unit, wanted)
    }

    /// The unit below a name.
    fn unit_below(&self, index: usize) -> Option<String> {
        let cell: Cell = *self.block.units.get(index)?;
        let text = self.table.text(cell).into_owned();
        let unit = bare_unit(&text);
        (!unit.is_empty()).then(|| if matches!(unit, "-" | "—") { "1".to_owned() } else { unit.to_owned() })
    }

    /// A column with its unit: that of the scene, else that of the header, else that of the line below.
    fn column(&self, index: usize, name: &str, own: Option<&str>, stated: Option<&str>, wanted: &Wanted<'_>) -> Result<Column, SceneError> {
        let place = self.place(index);
        let text = self.headers().get(index).cloned().unwrap_or_default();
        let unit = stated.or(own).map(str::to_owned).or_else(|| self.unit_below(index)).unwrap_or_default();
        let scale = match (self.units, spelt(&unit)) {
            (Units::Reduced, "" | "1") => {
                let mut scale = Scale::ONE;
                scale.dimension = wanted.dimension;
                scale
            }
            (Units::Reduced, _) => {
                let message = format!("the column `{text}` has a unit, in a scene in reduced units");
                return Err(SceneError::at(&place, message, "leave the unit out"));
            }
            (Units::Si, "") if wanted.dimension != Dimension::NUMBER => {
                let help = format!(
                    "write it into the header; or, if it is {1}, {2}: {3} = {{ {0} = \"{name} in {1}\" }}",
                    wanted.word,
                    wanted.dimension.si_unit(),
                    self.path.1,
                    self.path.0
                );
                return Err(SceneError::at(&place, format!("the column `{name}` has no unit"), "here").help(help));
            }
            // Å without its ring, as profilometers write it: no current is measured here.
            (Units::Si, "A") if wanted.dimension == Dimension::LENGTH => Scale::of("Å").unwrap_or(Scale::ONE),
            (Units::Si, unit) => Scale::of(unit).map_err(|error| {
                let help = format!(
                    "it must be {4}; if its numbers are in {1} whatever the header says, {2}: {3} = {{ {0} = \"{name} in {1}\" }}",
                    wanted.word,
                    wanted.dimension.si_unit(),
                    self.path.1,
                    self.path.0,
                    wanted.dimension.example()
                );
                SceneError::at(&place, format!("the unit of the column `{text}` cannot be read: {error}"), "here").help(help)
            })?,
        };
        if !scale.dimension.measures(wanted.dimension) {
            let message = format!("the column `{text}` has the wrong unit: it is measured in {}", scale.dimension.si_unit());
            return Err(SceneError::at(&place, message, format!("must be measured in {}", wanted.dimension.si_unit())));
        }
        Ok(Column { index, name: name.to_owned(), scale, place })
    }

    /// A measured column without a role, with whatever unit it has; none if that cannot be read.
    pub(super) fn other(&self, index: usize) -> Option<Column> {
        let header = self.headers().get(index).cloned()?;
        let (name, own) = split(&header);
        let unit = own.map(str::to_owned).or_else(|| self.unit_below(index)).unwrap_or_default();
        if self.units == Units::Reduced && !matches!(unit.as_str(), "" | "1") {
            return None;
        }
        let scale = Scale::of(&unit).ok()?;
        Some(Column { index, name: name.to_owned(), scale, place: self.place(index) })
    }

    /// The number of a cell in coherent units.
    pub(super) fn number(&self, row: &[Cell], column: &Column, buffer: &mut String) -> Result<f64, SceneError> {
        let cell = row.get(column.index).copied();
        if let Some(value) = cell.and_then(|cell| self.table.number(cell, &column.scale, buffer)) {
            // Minus zero is zero.
            return Ok(value + 0.0);
        }
        let words = cell.map(|cell| self.table.text(cell).into_owned()).unwrap_or_default();
        let what = if words.is_empty() { "is empty".to_owned() } else { format!("= {words:?} is no number") };
        // An empty cell has no width to point at.
        let place = cell.filter(|_| !words.is_empty()).map_or_else(|| column.place.clone(), |cell| self.table.place(cell));
        let line = row.first().map_or(0, |cell| self.table.line(*cell));
        Err(SceneError::at(&place, format!("`{}` {what}, in line {line}", column.name), "must be a finite number without a unit"))
    }
}
