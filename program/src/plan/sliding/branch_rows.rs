//! A branch as rows: one for each point and one for each turn, in the order of the curve.

use super::SlidingPlan;
use super::branches::{Found, Item, Traced};
use super::columns::definitions;
use crate::outcome::{Certificate, Row, Status, Work};
use crate::scene::typed::{BranchParameter, SlidingBranch, SlidingContact, Units};
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;

/// Contacts solved for one balance: as it is, and with each edge moved.
const SOLVES: u64 = 3;

impl SlidingPlan {
    pub(super) fn branch_rows(&self, branch: &SlidingBranch, state: usize, swept: &[f64]) -> Vec<Row> {
        let empty = |labels: [&str; 4]| {
            let labels = labels.map(str::to_owned).to_vec();
            Row::new(state, swept, labels, definitions(&self.sliding).len())
        };
        let adhesive = SlidingContact::Adhesive.word();
        let Traced { items, closure_evaluations } = match self.traced(branch) {
            Ok(traced) => traced,
            Err(refusal) => {
                let mut row = empty([adhesive, "", "", ""]);
                self.refuse(&mut row, refusal);
                return vec![row];
            }
        };
        let mut rows: Vec<Row> = Vec::with_capacity(items.len());
        for Item { branch: name, event, found, note } in items {
            let number = 1 + rows.iter().filter(|row| row.label(2) == name).count();
            let mut row = empty([adhesive, "partial", &name, event]);
            row.reason = note;
            let filled = found.and_then(|found| self.fill_point(branch, &found, number, &mut row));
            if let Err(refusal) = filled {
                row.labels = [adhesive, "", &name, event].map(str::to_owned).to_vec();
                self.refuse(&mut row, refusal);
            }
            rows.push(row);
        }
        if let Some(first) = rows.first_mut() {
            first.work = Work { closure_evaluations, linear_solves: SOLVES * closure_evaluations, ..Work::default() };
        }
        rows
    }

    fn fill_point(&self, branch: &SlidingBranch, found: &Found, number: usize, row: &mut Row) -> Result<(), Refusal> {
        let speed = match branch.parameter {
            BranchParameter::Speed => self.in_units(found.rate, self.scale.length),
            _ => Estimate::exact(self.sliding.speed),
        };
        let mut reduced = self.partial_values(&found.values, speed, Some(found.zones));
        if !self.is_wave() {
            reduced.truncate(super::columns::at::PENETRATION);
        }
        let flag = |reported: Option<bool>| reported.map(|reported| Estimate::exact(f64::from(u8::from(reported))));
        reduced.extend([Some(Estimate::exact(number as f64)), Some(found.reduced_works[0]), flag(found.under_load)]);
        if self.is_wave() {
            reduced.push(flag(found.under_penetration));
            if branch.frame_stiffness.is_some() {
                reduced.push(flag(found.in_frame));
            }
        }
        reduced.extend(self.extras_of_point(&found.values, found.reduced_works));
        let note = row.reason.take();
        row.status = Status::Solved;
        let follows = branch.parameter == BranchParameter::WorkOfAdhesion
            || branch.parameter == BranchParameter::Speed && self.work_by_rate.is_some();
        let works_of_adhesion = match (follows, self.units) {
            (true, Units::Si) => found.reduced_works.map(|work| work.value * self.scale.work_of_adhesion),
            _ => self.works_of_adhesion(),
        };
        self.finish(row, reduced, works_of_adhesion)?;
        row.reason = match (row.reason.take(), note) {
            (Some(reason), Some(note)) => Some(format!("{reason}; {note}")),
            (reason, note) => reason.or(note),
        };
        row.certificate = found.residual.map(|residual| Certificate { residual, condition: 1.0, admissible: true });
        row.assumptions = self.assumptions(row);
        Ok(())
    }
}
