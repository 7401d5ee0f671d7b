//! What is kept of the rows of a run: all of a short one; of a long sweep counts, the states that pictures and the screen show, and the worst rows.

use crate::outcome::tally::Tally;
use crate::outcome::{Layout, Row, is_state};
use crate::scene::sweep::{self, Sweep};

/// Most rows that are kept of a sweep that is not kept as a whole.
const MOST_ROWS: usize = 20_000;
/// Most values of one sweep alone, of the last of several, of the last but one, and of each further one whose states are then kept.
const ALONE: usize = 2000;
const LATTICE: [usize; 3] = [200, 50, 2];
/// First and last states, which the screen shows.
const ENDS: usize = 24;

/// Which rows are kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Which {
    All,
    Shown,
    None,
}

/// The rows of a run as they come in.
pub(super) struct Kept<'s> {
    sweeps: &'s [Sweep],
    states: usize,
    layout: Option<&'s Layout>,
    which: Which,
    /// How many values of each sweep are kept, from the last on.
    limits: Vec<usize>,
    pub(super) rows: Vec<Row>,
    /// Of each assumption, and of the draws of the material, the rows with the smallest and the largest number.
    extremes: Vec<[Option<(f64, Row)>; 2]>,
    pub(super) tally: Tally,
}

impl<'s> Kept<'s> {
    /// Of a sweep whose states have so many rows each, at most; `all` keeps them whatever their number.
    pub(super) fn new(sweeps: &'s [Sweep], layout: Option<&'s Layout>, tally: Tally, rows_of_a_state: u64, all: bool) -> Self {
        let states = sweep::states(sweeps);
        let limits = limits(sweeps, rows_of_a_state);
        let which = if all || few(states, rows_of_a_state) { Which::All } else { Which::Shown };
        Self { sweeps, states, layout, which, limits, rows: Vec::new(), extremes: Vec::new(), tally }
    }

    /// Nothing but the counts.
    pub(super) fn counts(sweeps: &'s [Sweep], layout: Option<&'s Layout>, tally: Tally) -> Self {
        Self { sweeps, states: 0, layout, which: Which::None, limits: Vec::new(), rows: Vec::new(), extremes: Vec::new(), tally }
    }

    /// The same with no row yet: for a part of the states, which is [joined](Self::join) to those before it.
    pub(super) fn part(&self) -> Self {
        let &Self { sweeps, states, layout, which, .. } = self;
        Self {
            sweeps,
            states,
            layout,
            which,
            limits: self.limits.clone(),
            rows: Vec::new(),
            extremes: Vec::new(),
            tally: self.tally.of_none(),
        }
    }

    /// Takes what was kept of the states that follow, as if each had been added here.
    pub(super) fn join(&mut self, next: &mut Self) {
        self.tally.join(&mut next.tally);
        self.rows.append(&mut next.rows);
        for (place, [least, most]) in next.extremes.iter().enumerate() {
            for (number, row) in least.iter().chain(most) {
                self.compare(place, *number, row);
            }
        }
    }

    /// Takes the rows of a state.
    pub(super) fn add(&mut self, rows: Vec<Row>) {
        for row in &rows {
            self.tally.add(row, is_state(self.layout, row));
        }
        let Some(state) = rows.first().map(|row| row.state) else { return };
        match self.which {
            Which::None => return,
            Which::Shown if !self.is_shown(state) => {}
            Which::All | Which::Shown => {
                self.rows.extend(rows);
                return;
            }
        }
        for mut row in rows {
            row.fields.clear();
            let material = row.material.as_ref().map(|material| material.counts.used as f64 / material.counts.draws.max(1) as f64);
            for (place, number) in row.assumptions.iter().copied().chain([material]).enumerate() {
                if let Some(number) = number.filter(|number| !number.is_nan()) {
                    self.compare(place, number, &row);
                }
            }
        }
    }

    /// Keeps a row where its number is the smallest or the largest so far.
    fn compare(&mut self, place: usize, number: f64, row: &Row) {
        while self.extremes.len() <= place {
            self.extremes.push([None, None]);
        }
        let Some([least, most]) = self.extremes.get_mut(place) else { return };
        // Into the memory of the row before: of one that another thread has made, none is given back.
        let keep = |kept: &mut Option<(f64, Row)>| match kept {
            Some((known, of)) => {
                *known = number;
                of.copy_from(row);
            }
            None => *kept = Some((number, row.clone())),
        };
        if least.as_ref().is_none_or(|(known, _)| number < *known) {
            keep(least);
        }
        if most.as_ref().is_none_or(|(known, _)| number > *known) {
            keep(most);
        }
    }

    /// Whether the rows of a state are kept: on a lattice over the sweeps, so that curves and maps are whole, and at both ends.
    fn is_shown(&self, state: usize) -> bool {
        if state < ENDS || state + ENDS >= self.states {
            return true;
        }
        let indices = sweep::indices(self.sweeps, state);
        let lengths = self.sweeps.iter().map(|sweep| sweep.values.len());
        let own = indices.iter().zip(lengths).rev().zip(&self.limits);
        own.into_iter().all(|((&index, length), &most)| on_lattice(index, length, most))
    }

    /// The rows, the worst that are not kept behind them, the number of those kept, and the counts.
    pub(super) fn into_parts(self) -> (Vec<Row>, usize, Tally) {
        let mut rows = self.rows;
        let kept = rows.len();
        rows.extend(self.extremes.into_iter().flatten().flatten().map(|(_, row)| row));
        (rows, kept, self.tally)
    }
}

/// Whether so many states are kept as a whole.
pub(super) fn few(states: usize, rows_of_a_state: u64) -> bool {
    (states as u64).saturating_mul(rows_of_a_state) <= MOST_ROWS as u64
}

/// How many values of each sweep are kept, from the last on: the more rows a state has, the fewer states.
fn limits(sweeps: &[Sweep], rows_of_a_state: u64) -> Vec<usize> {
    let room = (MOST_ROWS as u64 / rows_of_a_state.max(1)) as usize;
    if sweeps.len() == 1 || sweep::is_together(sweeps) {
        return vec![room.clamp(2, ALONE); sweeps.len()];
    }
    let [inner, outer, further] = LATTICE;
    let inner = (room / 8).clamp(2, inner);
    let outer = (room / inner).clamp(2, outer);
    (0..sweeps.len()).map(|place| [inner, outer].get(place).copied().unwrap_or(further)).collect()
}

/// Most states whose rows are kept of a sweep that is not kept as a whole.
pub(super) fn most_states(sweeps: &[Sweep], rows_of_a_state: u64) -> usize {
    let kept = sweeps.iter().rev().zip(limits(sweeps, rows_of_a_state)).map(|(sweep, most)| sweep.values.len().min(most));
    let kept = if sweep::is_together(sweeps) { kept.max().unwrap_or(1) } else { kept.product() };
    (kept + 2 * ENDS).min(sweep::states(sweeps))
}

/// Whether an index is one of at most so many that are evenly chosen, the first and the last among them.
fn on_lattice(index: usize, length: usize, most: usize) -> bool {
    let last = length.saturating_sub(1);
    if length <= most || last == 0 {
        return true;
    }
    let number = (index * (most - 1)).div_ceil(last);
    number * last / (most - 1) == index
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::outcome::{Certificate, Status};
    use crate::scene::{Document, read};
    use std::path::Path;
    use viscotack::estimate::Estimate;

    fn row(state: usize, place: usize) -> Row {
        let random = |salt: usize| ((state * 31 + place * 7 + salt) * 7919 % 1009) as f64;
        let mut row = Row::new(state, &[state as f64], vec![if place == 0 { "summary" } else { "way" }.to_owned()], 2);
        row.status = Status::ALL[random(1) as usize % Status::ALL.len()];
        row.reason = (random(2) as usize).is_multiple_of(3).then(|| format!("reason {state} {place}"));
        row.assumptions = vec![Some(random(3)), (random(4) > 500.0).then(|| random(5))];
        row.values = vec![Some(Estimate { value: random(6), error: random(7) * 1e-3 }), None];
        row.certificate = Some(Certificate { residual: random(8), condition: random(9), admissible: random(10) > 5.0 });
        row
    }

    /// Whatever parts the states are counted in, the end is that of all states one by one.
    #[test]
    fn parts_are_joined_as_if_each_state_had_been_added() {
        let states = 30_000;
        let text = format!(
            "[material]\nrelaxed_modulus = 1e6\npoisson_ratio = 0.49\nrelaxation = [{{ modulus = 3e6, relaxation_time = 0.1 }}]\n[adhesion]\n\
             work_of_adhesion = 10.0\nprocess_zone = {{ length = 1e-6 }}\n[crack]\nbody = \"two_halves\"\nplane = \"strain\"\nspeed = 1e-6\n\
             [sweep]\nkey = \"crack.speed\"\nfrom = 1e-8\nto = 1.0\npoints = {states}\n"
        );
        let document = Document::parse("scene.toml", text, Path::new(".")).unwrap();
        let sweeps = read::read(&document).unwrap().sweeps;
        let layout = Layout { labels: vec![0], states: vec![0], path: vec![1] };
        let kept = || Kept::new(&sweeps, Some(&layout), Tally::new(1e-3, 2), 2, false);
        let rows = |state: usize| vec![row(state, 1), row(state, 0)];
        let mut one_by_one = kept();
        (0..states).for_each(|state| one_by_one.add(rows(state)));
        for size in [1, 7, 64, 20_000] {
            let mut joined = kept();
            for first in (0..states).step_by(size) {
                let mut part = joined.part();
                (first..states.min(first + size)).for_each(|state| part.add(rows(state)));
                joined.join(&mut part);
            }
            assert_eq!(format!("{:?}", joined.tally), format!("{:?}", one_by_one.tally), "parts of {size}");
            assert!(joined.rows == one_by_one.rows && joined.extremes == one_by_one.extremes, "parts of {size}");
            assert!(joined.rows.len() < states && joined.extremes.iter().flatten().any(Option::is_some));
        }
    }
}
