//! A table of a material as blocks of rows whose columns have roles.

use super::column_names::{EXAMPLE, Role, meaning, split, spoken, word};
use super::column_units::unit;
use super::material_columns::{Column, Header, StatedColumn, column, line, stated_columns};
use super::section::Section;
use crate::scene::delimited::{Block, Cell, DelimitedTable, Options};
use crate::scene::diagnostic::{Place, SceneError, SourceText, nearest};
use crate::scene::document::Document;
use crate::scene::units::{Dimension, parse_quantity};

/// A table, its blocks with the roles of their columns, and what the scene states of them.
pub(super) struct MaterialRows {
    pub(super) table: DelimitedTable,
    pub(super) blocks: Vec<Columns>,
    pub(super) stated: Vec<StatedColumn>,
    /// The header of the first block.
    pub(super) header: Place,
    pub(super) notes: Vec<String>,
}

/// The columns of one block.
pub(super) struct Columns {
    found: Vec<(Role, Result<Column, SceneError>)>,
    /// Headers of all columns.
    names: Vec<String>,
    /// Roles of columns whose unit is missing or cannot be read, with the line that gives it.
    without_unit: Vec<(Role, String)>,
    /// The temperature (K) that a line above the rows states.
    pub(super) temperature: Option<f64>,
    pub(super) header: Place,
}

impl Columns {
    pub(super) fn has(&self, role: Role) -> bool {
        self.found.iter().any(|(own, _)| *own == role)
    }

    pub(super) fn count(&self, role: Role) -> usize {
        self.found.iter().filter(|(own, _)| *own == role).count()
    }

    /// The column of a role, if there is one.
    pub(super) fn get(&self, role: Role) -> Result<Option<&Column>, SceneError> {
        let mut columns = self.found.iter().filter(|(own, _)| *own == role).map(|(_, column)| column);
        let (first, second) = (columns.next(), columns.next());
        let Some(second) = second else { return first.map(|column| column.as_ref().map_err(Clone::clone)).transpose() };
        // The time of a step beside the time of the whole test.
        let of_step = |column: &&Result<Column, SceneError>| {
            column.as_ref().is_ok_and(|column| {
                let name = super::column_names::plain(&column.text);
                ["step", "schritt", "abschnitt", "étape"].iter().any(|word| name.contains(word))
            })
        };
        if role == Role::Time
            && let [Some(one), None] = {
                let mut steps = self.found.iter().filter(|(own, _)| *own == role).map(|(_, column)| column).filter(of_step);
                [steps.next(), steps.next()]
            }
        {
            return one.as_ref().map(Some).map_err(Clone::clone);
        }
        let place = second.as_ref().map_or_else(|_| self.header.clone(), |column| column.place.clone());
        let text = |column: &Result<Column, SceneError>| column.as_ref().map_or_else(|_| String::new(), |column| column.text.clone());
        let same = first.is_some_and(|first| text(first) == text(second));
        let help = if same {
            "their headers are the same: rename or delete the one that is not meant".to_owned()
        } else {
            let named = first.map_or_else(String::new, text);
            format!("name the right one in [material.columns], such as: {} = \"{named}\"", word(role))
        };
        Err(SceneError::at(&place, format!("two columns hold the {}", spoken(role)), "the second").help(help))
    }

    /// Lines of [material.columns] for those of the roles whose unit is missing or cannot be read.
    pub(super) fn lines(&self, roles: &[Role]) -> Vec<String> {
        self.without_unit.iter().filter(|(role, _)| roles.contains(role)).map(|(_, line)| line.clone()).collect()
    }

    /// The same for roles that no column has: the columns without a role, in their order.
    pub(super) fn guessed(&self, roles: &[Role]) -> Vec<String> {
        let unknown = self.names.iter().filter(|name| !name.is_empty() && column_without_role(name));
        let lacking = roles.iter().filter(|role| !self.has(**role));
        let mut lines = self.lines(roles);
        lines.extend(lacking.zip(unknown).map(|(role, name)| line(*role, name)));
        lines
    }

    /// Headers of columns that are none of some.
    pub(super) fn others(&self, used: &[usize]) -> Vec<&str> {
        let unused = self.names.iter().enumerate().filter(|(index, name)| !used.contains(index) && !name.is_empty());
        unused.map(|(_, name)| name.as_str()).collect()
    }
}

impl MaterialRows {
    /// Reads the table that `key` names.
    pub(super) fn read(section: &Section<'_>, document: &Document, key: &str, file: &str) -> Result<Self, SceneError> {
        let Some(source) = document.attached(file) else {
            return Err(section.wrong(key, format!("`{}` = {file:?} was not read with the scene", section.full(key)), "this file"));
        };
        let table = DelimitedTable::read(source, &Options { help: EXAMPLE })?;
        let stated = stated_columns(section)?;
        let mut notes = table.notes().to_vec();
        let (mut blocks, mut temperature): (Vec<Columns>, Option<f64>) = (Vec::new(), None);
        for block in table.blocks() {
            if let Some(own) = block_temperature(&table, block, blocks.is_empty(), &mut notes)? {
                temperature = Some(own);
            } else if block.own_header {
                temperature = None;
            }
            blocks.push(columns(&table, block, &stated, temperature));
        }
        let Some(first) = blocks.first() else {
            let nowhere = Place { source: source.clone(), span: 0..0 };
            return Err(SceneError::at(&nowhere, format!("{file:?} has no rows of numbers"), "here").help(EXAMPLE));
        };
        let header = first.header.clone();
        for (role, name, _) in &stated {
            if !first.has(*role) {
                let near = nearest(name, first.names.iter().map(String::as_str))
                    .map_or_else(String::new, |name| format!("; did you mean {name:?}?"));
                let message = format!("`material.columns.{}` = {name:?} is no header of {file:?}{near}", word(*role));
                return Err(SceneError::at(&header, message, "the headers"));
            }
        }
        Ok(Self { table, blocks, stated, header, notes })
    }

    /// Blocks with their columns.
    pub(super) fn blocks(&self) -> impl Iterator<Item = (&Block, &Columns)> {
        self.table.blocks().iter().zip(&self.blocks)
    }

    /// The number of a cell in SI units; none where the cell says that there is none.
    pub(super) fn number(&self, row: &[Cell], column: &Column, buffer: &mut String) -> Result<Option<f64>, SceneError> {
        let Some(cell) = row.get(column.index).copied() else { return Ok(None) };
        if let Some(value) = self.table.number(cell, &column.scale, buffer) {
            return Ok(Some(value));
        }
        if self.table.is_missing(cell) {
            return Ok(None);
        }
        let message = format!("`{}` = {:?} is no number, in line {}", word(column.role), self.table.shown(cell), self.table.line(cell));
        Err(SceneError::at(&self.table.place(cell), message, "must be a finite number without a unit")
            .help("mend the cell; a line that is no row of the table is passed over if it begins with #"))
    }
}

/// Whether a text is a table with a column of a modulus or a compliance.
pub(super) fn holds_material(source: &SourceText) -> bool {
    let Ok(table) = DelimitedTable::read(source, &Options { help: EXAMPLE }) else { return false };
    let mains = [Role::Storage, Role::Complex, Role::Relaxation, Role::Creep];
    table.blocks().first().is_some_and(|block| {
        let columns = columns(&table, block, &[], None);
        columns.found.iter().any(|(role, column)| mains.contains(role) && column.is_ok())
    })
}

/// Whether a header says nothing known.
fn column_without_role(name: &str) -> bool {
    meaning(&split(name, |name| meaning(name).is_some()).0).is_none()
}

fn columns(table: &DelimitedTable, block: &Block, stated: &[StatedColumn], temperature: Option<f64>) -> Columns {
    let names: Vec<String> = block.header.iter().map(|cell| table.text(*cell).into_owned()).collect();
    let (mut found, mut without_unit) = (Vec::new(), Vec::new());
    for (index, (name, cell)) in names.iter().zip(&block.header).enumerate() {
        let below = block.units.get(index).map(|cell| table.text(*cell));
        let header = Header { text: name, index, place: table.place(*cell), unit_below: below.as_deref() };
        let of_header = column(&header, stated);
        if let Some((role, Err(_))) = &of_header {
            without_unit.push((*role, line(*role, name)));
        }
        found.extend(of_header);
    }
    Columns { found, names, without_unit, temperature, header: table.row_place(&block.header) }
}

/// The note on temperatures that stand above blocks.
const OF_LINES: &str = "a line above gives the temperature of the rows below it";

fn place_is_comment(place: &Place) -> bool {
    place.source.text().get(place.span.clone()).is_some_and(|line| line.starts_with(['#', '%', '/']))
}

/// The temperature (K) that a line above a block states, such as `Temperature: 25 °C`.
fn block_temperature(table: &DelimitedTable, block: &Block, first: bool, notes: &mut Vec<String>) -> Result<Option<f64>, SceneError> {
    for stated in block.stated.iter().rev() {
        let of_temperature = |name: &str| name == "T" || meaning(name).is_some_and(|(role, _)| role == Role::Temperature);
        let (name, unit_of_key) = split(&stated.key, of_temperature);
        let place = table.place(stated.line);
        if !of_temperature(&name) {
            // Above the table it is part of what precedes it; among the rows it may matter.
            if !first && !place_is_comment(&place) {
                notes.push(format!("{:?}: line {} is passed over", place.source.name(), table.line(stated.line)));
            }
            continue;
        }
        let Some((digits, own)) = DelimitedTable::quantity(&stated.value) else {
            notes.push(format!(
                "{:?}: line {} states no single temperature and is passed over",
                place.source.name(),
                table.line(stated.line)
            ));
            continue;
        };
        let written = if own.is_empty() { unit_of_key.unwrap_or_default() } else { own };
        let wrong = |message: String| SceneError::at(&place, message, "must be such as: Temperature: 25 °C");
        let known = unit(&written).map_err(|error| wrong(format!("the unit of this temperature cannot be read: {error}")))?;
        if !known.0.dimension.measures(Dimension::TEMPERATURE) {
            return Err(wrong(format!("this temperature has the unit {written:?}")));
        }
        let spelt = crate::scene::delimited::bare_unit(&written).replace(['º', '˚'], "°").replace("° ", "°");
        let kelvin =
            parse_quantity(&format!("{digits} {spelt}")).map_err(|error| wrong(format!("this temperature cannot be read: {error}")))?;
        if !notes.iter().any(|note| note.contains(OF_LINES)) {
            notes.push(format!("{:?}: {OF_LINES}, as in line {}", place.source.name(), table.line(stated.line)));
        }
        return Ok(Some(kelvin.value));
    }
    Ok(None)
}
