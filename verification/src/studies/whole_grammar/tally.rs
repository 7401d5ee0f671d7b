//! Counts by problem and column.

use super::compared::{Assessed, Value};
use super::drawn::Problem;
use std::collections::BTreeMap;

/// Numbers of a column.
#[derive(Debug, Clone, Default)]
pub struct Count {
    /// How many.
    pub values: usize,
    /// How many bounds do not cover the truth.
    pub outside: usize,
    /// Error over bound, the largest.
    pub worst: f64,
    /// Of how many the truth is known less well than the bound says.
    pub unsure: usize,
    /// How many state no error.
    pub exact: usize,
    /// Bound over error, sorted; of values above rounding.
    pub ratios: Vec<f64>,
}

impl Count {
    fn add(&mut self, value: &Value) {
        let compared = value.compared;
        self.values += 1;
        self.exact += usize::from(value.exact);
        self.unsure += usize::from(compared.truth.error > compared.found.error);
        self.ratios.extend(compared.width());
        if compared.is_missed() {
            self.outside += 1;
            let off = (compared.found.value - compared.truth.value).abs();
            let times = off / (compared.found.error + compared.truth.error);
            self.worst = if times.is_nan() { f64::INFINITY } else { self.worst.max(times) };
        }
    }

    /// Adds another count; the ratios are then to be sorted.
    pub fn join(&mut self, other: &Self) {
        self.values += other.values;
        self.outside += other.outside;
        self.worst = self.worst.max(other.worst);
        self.unsure += other.unsure;
        self.exact += other.exact;
        self.ratios.extend(&other.ratios);
    }

    /// A quantile of bound over error.
    #[must_use]
    pub fn ratio(&self, part: f64) -> Option<f64> {
        let last = self.ratios.len().checked_sub(1)?;
        self.ratios.get((part * last as f64).round() as usize).copied()
    }
}

/// All counts.
#[must_use]
pub fn counted(assessed: &[Assessed]) -> BTreeMap<(Problem, String), Count> {
    let mut counts: BTreeMap<(Problem, String), Count> = BTreeMap::new();
    for scene in assessed {
        for value in &scene.values {
            counts.entry((scene.drawn.problem, value.column.clone())).or_default().add(value);
        }
    }
    counts.values_mut().for_each(|count| count.ratios.sort_by(f64::total_cmp));
    counts
}
