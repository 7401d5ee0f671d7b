//! What a row owes to a material that its data do not fix: the spread of the row over materials that the data leave possible.

use super::{Column, Row};
use serde::{Deserialize, Serialize};

/// The spread of a row over draws of the material.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct DrawCounts {
    /// Draws that were solved.
    pub draws: usize,
    /// Those that have this row in the same state.
    pub used: usize,
    /// Those that end in another state here.
    pub other_state: usize,
    /// Those that were refused or did not converge.
    pub failed: usize,
    /// Why the first of them failed.
    pub reason: Option<String>,
}

/// The spread of a row over draws of the material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MaterialUncertainty {
    /// How the draws ended.
    pub counts: DrawCounts,
    /// Of each column.
    pub columns: Vec<Spread>,
}

/// The spread of a value.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Standard deviation over the draws, in the unit of the column: one standard uncertainty. None where there is no value, where the column
    /// changes its state, or where fewer than half of the draws have the row.
    pub deviation: Option<f64>,
    /// Draws in which the column has no value though the row has one, or another answer or count.
    pub changed: usize,
}

impl MaterialUncertainty {
    /// The spread of a row over the rows of the draws that are the same state.
    #[must_use]
    pub fn of(row: &Row, same: &[&Row], mut counts: DrawCounts) -> Self {
        counts.used = same.len();
        let enough = 2 * same.len() >= counts.draws && same.len() >= 2;
        let columns = (0..row.values.len())
            .map(|index| {
                let Some(own) = row.values.get(index).copied().flatten() else { return Spread::default() };
                // A count or an answer to yes or no is not averaged.
                let whole = own.error == 0.0 && own.value.fract() == 0.0;
                let found = same.iter().map(|draw| draw.values.get(index).copied().flatten());
                let values: Vec<f64> = found
                    .flatten()
                    .filter(|value| !(whole && value.error == 0.0 && (value.value - own.value).abs() > 0.0))
                    .map(|value| value.value)
                    .collect();
                let changed = same.len() - values.len();
                Spread { deviation: (changed == 0 && enough).then(|| deviation(&values)), changed }
            })
            .collect();
        Self { counts, columns }
    }

    /// What is to be said besides the deviations: draws that are missing, and columns that change their state. None if there is nothing.
    #[must_use]
    pub fn note(&self, columns: &[Column]) -> Option<String> {
        let DrawCounts { draws, used, other_state, failed, reason } = &self.counts;
        let mut parts = Vec::new();
        if used < draws {
            parts.push(format!("{used} of {draws} draws have this state"));
        }
        if *other_state > 0 {
            parts.push(format!("{other_state} end in another"));
        }
        if *failed > 0 {
            parts.push(format!("{failed} were not solved ({})", reason.as_deref().unwrap_or("no reason given")));
        }
        let changing = columns.iter().zip(&self.columns).filter(|(_, spread)| spread.changed > 0);
        parts.extend(changing.map(|(column, spread)| format!("{} changes its state in {} draws", column.name, spread.changed)));
        (!parts.is_empty()).then(|| parts.join(", "))
    }
}

/// Standard deviation about the mean.
fn deviation(values: &[f64]) -> f64 {
    let Some(&first) = values.first() else { return 0.0 };
    // About the first: differences of close values lose nothing.
    let count = values.len() as f64;
    let mean = values.iter().map(|value| value - first).sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - first - mean).powi(2)).sum();
    (squares / (count - 1.0).max(1.0)).sqrt()
}
