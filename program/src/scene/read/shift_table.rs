//! A table of shift factors.

use super::column_names::{Role, word};
use super::material_rows::MaterialRows;
use super::section::Section;
use crate::scene::delimited::Cell;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;

/// A table of shift factors as points (K, a_T), and what was chosen in reading it.
pub(super) struct ShiftTable {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) notes: Vec<String>,
}

/// Temperatures and shift factors of the table that `material.shift.table` names.
pub(super) fn shift_table(shift: &Section<'_>, document: &Document) -> Result<ShiftTable, SceneError> {
    let file = shift.required_text("table")?;
    let rows = MaterialRows::read(shift, document, "table", file)?;
    let help = "the header is such as: temperature (°C), log10_factor";
    let (mut points, mut notes, mut buffer) = (Vec::new(), rows.notes.clone(), String::new());
    for (block, columns) in rows.blocks() {
        let wrong = |message: String| SceneError::at(&columns.header, message, "in this header").help(help);
        let Some(temperature) = columns.get(Role::Temperature)? else {
            return Err(wrong(format!("{file:?} has no column `temperature`")));
        };
        let given: Vec<Role> =
            [Role::Factor, Role::LogFactor, Role::NaturalLogFactor].into_iter().filter(|role| columns.has(*role)).collect();
        let [role] = given.as_slice() else {
            return Err(wrong(format!("{file:?} needs one column `factor`, `log10_factor` or `ln_factor`")));
        };
        let Some(column) = columns.get(*role)? else { continue };
        let others = columns.others(&[temperature.index, column.index]);
        if !others.is_empty() {
            let names: Vec<String> = others.iter().map(|name| format!("`{name}`")).collect();
            notes.push(format!("{file:?}: columns that are not used: {}", names.join(", ")));
        }
        for row in rows.table.rows(block) {
            let (kelvin, value) = (rows.number(row, temperature, &mut buffer)?, rows.number(row, column, &mut buffer)?);
            let (Some(kelvin), Some(value)) = (kelvin, value) else {
                let line = row.first().map_or(0, |cell| rows.table.line(*cell));
                let message = format!("line {line} of {file:?} lacks a temperature or a factor");
                return Err(SceneError::at(&rows.table.row_place(row), message, "in this row").help("complete the row, or delete it"));
            };
            let factor = match role {
                Role::Factor => value,
                Role::LogFactor => 10f64.powf(value),
                _ => value.exp(),
            };
            if !(factor.is_finite() && factor > 0.0) {
                let cell = row.get(column.index).copied().unwrap_or(Cell::NONE);
                let message =
                    format!("`{}` = {} in line {} is no shift factor", word(*role), rows.table.shown(cell), rows.table.line(cell));
                return Err(SceneError::at(&rows.table.place(cell), message, "a factor is greater than 0"));
            }
            points.push((kelvin, factor));
        }
    }
    points.sort_by(|left, right| left.0.total_cmp(&right.0));
    Ok(ShiftTable { points, notes })
}
