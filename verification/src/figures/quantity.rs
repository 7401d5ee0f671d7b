//! A quantity of a row: a column, or a simple form of one.

use super::table::Table;
use serde::Deserialize;

/// A column, or one times a factor, over another, or without its sign.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(super) enum Quantity {
    Column(String),
    Form(QuantityForm),
}

/// See [`Quantity`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct QuantityForm {
    column: String,
    #[serde(default = "one")]
    times: f64,
    /// Minus these columns, before it is divided.
    #[serde(default)]
    minus: Vec<String>,
    /// Times this column.
    by: Option<String>,
    /// Over this column.
    per: Option<String>,
    /// To this power, of what the columns give.
    #[serde(default = "one")]
    power: f64,
    /// Plus this number, after all else.
    #[serde(default)]
    plus: f64,
    #[serde(default)]
    absolute: bool,
}

fn one() -> f64 {
    1.0
}

impl Quantity {
    /// The columns it needs.
    pub(super) fn columns(&self) -> Vec<&str> {
        match self {
            Self::Column(name) => vec![name],
            Self::Form(form) => std::iter::once(form.column.as_str())
                .chain(form.per.as_deref())
                .chain(form.by.as_deref())
                .chain(form.minus.iter().map(String::as_str))
                .collect(),
        }
    }

    /// Its formula in the names of columns.
    pub(super) fn words(&self) -> String {
        match self {
            Self::Column(name) => name.clone(),
            Self::Form(form) => {
                let is_one = |value: f64| value.to_bits() == 1.0_f64.to_bits();
                let mut text =
                    std::iter::once(form.column.as_str()).chain(form.minus.iter().map(String::as_str)).collect::<Vec<_>>().join(" - ");
                if !form.minus.is_empty() {
                    text = format!("({text})");
                }
                for (sign, other) in [(" * ", &form.by), (" / ", &form.per)] {
                    if let Some(other) = other {
                        text = format!("{text}{sign}{other}");
                    }
                }
                if !is_one(form.power) {
                    text = format!("({text})^{}", form.power);
                }
                if !is_one(form.times) {
                    text = format!("{} * {text}", form.times);
                }
                if form.absolute {
                    text = format!("|{text}|");
                }
                if form.plus != 0.0 {
                    text = format!("{text} + {}", form.plus);
                }
                text
            }
        }
    }

    /// Its value and error bound in a row.
    pub(super) fn at(&self, table: &Table, row: usize) -> Option<(f64, f64)> {
        match self {
            Self::Column(name) => table.number(name, row),
            Self::Form(form) => {
                let (mut value, mut error) = table.number(&form.column, row)?;
                for other in &form.minus {
                    let (other, other_error) = table.number(other, row)?;
                    (value, error) = (value - other, error + other_error);
                }
                if let Some(by) = &form.by {
                    let (other, other_error) = table.number(by, row)?;
                    error = error * other.abs() + value.abs() * other_error;
                    value *= other;
                }
                if let Some(per) = &form.per {
                    let (other, other_error) = table.number(per, row)?;
                    error = (error + (value / other).abs() * other_error) / other.abs();
                    value /= other;
                }
                if form.power.to_bits() != 1.0_f64.to_bits() {
                    let raised = value.powf(form.power);
                    error = if value == 0.0 { error } else { (form.power * raised / value * error).abs() };
                    value = raised;
                }
                (value, error) = (form.times * value, form.times.abs() * error);
                value = if form.absolute { value.abs() } else { value } + form.plus;
                (value.is_finite() && error.is_finite()).then_some((value, error))
            }
        }
    }
}
