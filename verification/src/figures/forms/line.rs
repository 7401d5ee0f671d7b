//! A power law y = c·xⁿ, for asymptotes and limits.

use super::super::table::Table;
use super::spaced;
use serde::Deserialize;
use viscotack::refusal::Refusal;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct Line {
    coefficient: f64,
    #[serde(default)]
    exponent: f64,
    from: f64,
    to: f64,
    /// Points at equal ratios; two at the ends are enough where both axes are logarithmic.
    #[serde(default = "two")]
    points: usize,
}

fn two() -> usize {
    2
}

impl Line {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let x = spaced([self.from, self.to], self.points, self.from > 0.0);
        Ok(Table::exact(&[("y", x.iter().map(|x| self.coefficient * x.powf(self.exponent)).collect()), ("x", x)]))
    }
}
