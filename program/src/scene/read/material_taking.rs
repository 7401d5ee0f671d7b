//! Rows of a material's table, taken one by one into SI units.

use super::column_names::{Role, word};
use super::material_choice::{Choice, complex_parts};
use super::material_rows::{Columns, MaterialRows};
use crate::scene::delimited::Cell;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::MeasuredRow;
use std::f64::consts::{FRAC_PI_2, TAU};

/// E″ and tan δ beside each other.
#[derive(Default)]
pub(super) struct Agreement {
    rows: usize,
    off: usize,
    worst: f64,
}

impl Agreement {
    /// Digits of a table are a few: less than this is rounding (relative, absolute).
    const ROUNDING: [f64; 2] = [0.02, 2e-3];

    fn add(&mut self, tangent: f64, right: f64) {
        let difference = (tangent - right).abs();
        self.rows += 1;
        if difference > Self::ROUNDING[0] * right.abs() + Self::ROUNDING[1] {
            self.off += 1;
            self.worst = self.worst.max(difference / right.abs().max(Self::ROUNDING[1]));
        }
    }

    /// A note where they agree, and a warning where they do not.
    pub(super) fn compared(&self, file: &str) -> Option<Result<String, String>> {
        let used = format!("{file:?}: the loss modulus is used, and the loss tangent beside it is not");
        match (self.rows, self.off) {
            (0, _) => None,
            (_, 0) => Some(Ok(format!("{used}; they agree"))),
            (rows, off) => Some(Err(format!(
                "{used}; in {off} of {rows} rows it is off E″/E′, by up to {:.0} %: is a unit or a column wrong?",
                100.0 * self.worst
            ))),
        }
    }
}

/// Rows as they are taken from the table.
pub(super) struct Taking<'t> {
    rows: &'t MaterialRows,
    buffer: String,
    /// Rows without a value in a column that is used, and the line of the first.
    pub(super) lacking: Option<(usize, usize)>,
    pub(super) tangent: Agreement,
}

impl<'t> Taking<'t> {
    pub(super) fn of(rows: &'t MaterialRows) -> Self {
        Self { rows, buffer: String::new(), lacking: None, tangent: Agreement::default() }
    }

    /// One row in SI units, of tension; none if a used column has no value there.
    pub(super) fn row(
        &mut self,
        row: &[Cell],
        columns: &Columns,
        choice: &Choice,
        stretch: f64,
    ) -> Result<Option<MeasuredRow>, SceneError> {
        let value = self.number(row, columns, Some(choice.main))?;
        let place = self.number(row, columns, Some(choice.place))?;
        let second = self.number(row, columns, choice.second)?;
        let temperature = self.number(row, columns, columns.has(Role::Temperature).then_some(Role::Temperature))?;
        let tangent = self.number(row, columns, choice.tangent_beside)?;
        let frequency = self.number(row, columns, choice.frequency_beside)?;
        let every = [Some(choice.main), Some(choice.place), choice.second].iter().flatten().count();
        let found = [value, place, second].iter().flatten().count();
        let (Some(value), Some(place)) = (value, place) else { return Ok(self.lacks(row)) };
        if found < every || (columns.has(Role::Temperature) && temperature.is_none()) {
            return Ok(self.lacks(row));
        }
        let at = place * if choice.place == Role::Frequency { TAU } else { 1.0 };
        if frequency.is_some_and(|frequency| (frequency * TAU / at - 1.0).abs() > 0.01) {
            let place = self.rows.table.row_place(row);
            let message = format!("in line {} the angular frequency is not 2π times the frequency", self.line(row));
            return Err(SceneError::at(&place, message, "in this row").help("delete the column that is wrong"));
        }
        let (value, loss) = match second.zip(choice.second) {
            Some((second, role)) => {
                let (storage, loss) = complex_parts(choice.main, value, role, second);
                (storage, Some(loss))
            }
            None => (value, None),
        };
        if let (Some(tangent), Some(loss)) = (tangent, loss) {
            self.tangent.add(tangent, loss / value);
        }
        let temperature = temperature.or(columns.temperature);
        Ok(Some(MeasuredRow { temperature, at, value: value * stretch, loss: loss.map(|loss| loss * stretch) }))
    }

    fn line(&self, row: &[Cell]) -> usize {
        row.first().map_or(0, |cell| self.rows.table.line(*cell))
    }

    fn lacks(&mut self, row: &[Cell]) -> Option<MeasuredRow> {
        let line = self.line(row);
        let (rows, first) = self.lacking.unwrap_or((0, line));
        self.lacking = Some((rows + 1, first));
        None
    }

    /// The value of a role in a row, in its range.
    fn number(&mut self, row: &[Cell], columns: &Columns, role: Option<Role>) -> Result<Option<f64>, SceneError> {
        let Some(role) = role else { return Ok(None) };
        let Some(column) = columns.get(role)? else { return Ok(None) };
        let Some(value) = self.rows.number(row, column, &mut self.buffer)? else { return Ok(None) };
        let wrong = |rest: &str, label: &str| {
            let cell = row.get(column.index).copied().unwrap_or(Cell::NONE);
            let message = format!("`{}` = {} in line {} {rest}", word(role), self.rows.table.shown(cell), self.rows.table.line(cell));
            SceneError::at(&self.rows.table.place(cell), message, label)
        };
        match role {
            Role::Loss | Role::LossTangent | Role::Phase if value < 0.0 => {
                Err(wrong("is negative: a passive solid loses energy, it gives none", "must be 0 or more"))
            }
            Role::Phase if value >= FRAC_PI_2 => Err(wrong("is a right angle or more: no storage modulus is left", "must be below 90°")),
            Role::Loss | Role::LossTangent | Role::Phase => Ok(Some(value)),
            _ if value > 0.0 => Ok(Some(value)),
            _ => Err(wrong("is not positive", "must be greater than 0")),
        }
    }
}
