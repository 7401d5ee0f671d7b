//! What is counted over all rows of a run, row by row: how they ended, the work, the worst certificate, how well each column is known.

use super::row::{Row, Status, Work};

/// How many rows ended in one way.
#[derive(Debug, Clone, Default)]
pub struct Ended {
    /// Rows, those on the way of a state too.
    pub rows: usize,
    /// States.
    pub states: usize,
    /// Why the first of them did: of a state, if one ended so.
    pub reason: Option<String>,
    reason_is_of_a_state: bool,
}

/// How well the values of a column are known.
#[derive(Debug, Clone, Copy, Default)]
pub struct Known {
    /// Largest bound over its value, of values that are known to the wanted accuracy.
    pub largest: f64,
    /// Values of solved rows whose bound is above the accuracy times the value: they are small against what errors are relative to.
    pub small: usize,
    /// Values of inaccurate rows whose bound is above the accuracy times the value.
    pub missed: usize,
}

/// Counts over all rows of a run, however few of them are kept.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    accuracy: f64,
    /// All rows.
    pub rows: usize,
    /// States.
    pub states: usize,
    ended: [Ended; Status::ALL.len()],
    /// Solved states with something to say, and the first of them: its last label and its reason.
    pub noted: (usize, Option<(String, String)>),
    /// All work.
    pub work: Work,
    /// Of all certificates.
    pub largest_residual: f64,
    /// Of all certificates.
    pub largest_condition: f64,
    /// Whether no certificate says otherwise.
    pub all_admissible: bool,
    states_known: Vec<Known>,
    path_known: Vec<Known>,
}

impl Tally {
    /// Of no row yet.
    #[must_use]
    pub fn new(accuracy: f64, columns: usize) -> Self {
        let known = vec![Known::default(); columns];
        Self { accuracy, all_admissible: true, states_known: known.clone(), path_known: known, ..Self::default() }
    }

    /// The same of no row yet.
    #[must_use]
    pub fn of_none(&self) -> Self {
        Self::new(self.accuracy, self.states_known.len())
    }

    /// Adds the counts of the rows that follow.
    pub fn join(&mut self, next: &mut Self) {
        self.rows += next.rows;
        self.states += next.states;
        for (ended, next) in self.ended.iter_mut().zip(&mut next.ended) {
            if next.rows > 0 && ended.reason.is_none() || next.states > 0 && !ended.reason_is_of_a_state {
                ended.reason = next.reason.take();
                ended.reason_is_of_a_state = next.reason_is_of_a_state;
            }
            ended.rows += next.rows;
            ended.states += next.states;
        }
        self.noted.0 += next.noted.0;
        self.noted.1 = self.noted.1.take().or_else(|| next.noted.1.take());
        self.work += next.work;
        self.largest_residual = self.largest_residual.max(next.largest_residual);
        self.largest_condition = self.largest_condition.max(next.largest_condition);
        self.all_admissible &= next.all_admissible;
        let own = self.states_known.iter_mut().chain(&mut self.path_known);
        for (known, next) in own.zip(next.states_known.iter().chain(&next.path_known)) {
            known.largest = known.largest.max(next.largest);
            known.small += next.small;
            known.missed += next.missed;
        }
    }

    /// How many ended so.
    #[must_use]
    pub fn ended(&self, status: Status) -> &Ended {
        // One entry each, see `Status::ALL`.
        &self.ended[status as usize]
    }

    /// How well a column is known, in rows of states or on their way.
    #[must_use]
    pub fn known(&self, column: usize, of_states: bool) -> Known {
        let all = if of_states { &self.states_known } else { &self.path_known };
        all.get(column).copied().unwrap_or_default()
    }

    /// Counts a row.
    pub fn add(&mut self, row: &Row, is_state: bool) {
        self.rows += 1;
        self.states += usize::from(is_state);
        let ended = &mut self.ended[row.status as usize];
        ended.rows += 1;
        ended.states += usize::from(is_state);
        if row.status != Status::Solved && (ended.reason.is_none() || is_state && !ended.reason_is_of_a_state) {
            ended.reason.clone_from(&row.reason);
            ended.reason_is_of_a_state = is_state;
        }
        if let (true, Status::Solved, Some(reason)) = (is_state, row.status, &row.reason) {
            self.noted.0 += 1;
            self.noted.1.get_or_insert_with(|| (row.labels.last().cloned().unwrap_or_default(), reason.clone()));
        }
        self.work += row.work;
        if let Some(certificate) = row.certificate {
            self.largest_residual = self.largest_residual.max(certificate.residual);
            self.largest_condition = self.largest_condition.max(certificate.condition);
            self.all_admissible &= certificate.admissible;
        }
        let all = if is_state { &mut self.states_known } else { &mut self.path_known };
        for (known, value) in all.iter_mut().zip(&row.values) {
            let Some(estimate) = value.filter(|estimate| estimate.error > 0.0) else { continue };
            if estimate.error <= self.accuracy * estimate.value.abs() {
                known.largest = known.largest.max(estimate.relative_error());
            } else if row.status == Status::Inaccurate {
                known.missed += 1;
            } else {
                known.small += 1;
            }
        }
    }
}
