//! What a contact carries, as one row: a quantity that does not exist is an empty cell, and the row says why.

use super::SlidingPlan;
use super::columns::definitions;
use crate::outcome::{Certificate, Row, Work};
use crate::scene::typed::SlidingContact;
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{Fold, FoldQuantity, Strength, strength};
use viscotack::sliding::steady::PartialValues;

/// Contacts solved for one balance: as it is, and with each edge moved.
const SOLVES: u64 = 3;

impl SlidingPlan {
    pub(super) fn strength_row(&self, state: usize, swept: &[f64]) -> Row {
        let labels = vec![SlidingContact::Adhesive.word().to_owned()];
        let mut row = Row::new(state, swept, labels, definitions(&self.sliding).len());
        if let Err(refusal) = self.fill_strength(&mut row) {
            self.refuse(&mut row, refusal);
        }
        row
    }

    fn fill_strength(&self, row: &mut Row) -> Result<(), Refusal> {
        let problem = self.every_load()?;
        let found = strength(&self.material, &problem)?;
        let extras = self.extras_of_strength(&problem, &found)?;
        let Strength { pull_off, snap_in, separation, zero_load, toughness, work, .. } = &found;
        let adhesion = self.reduced_adhesion();
        let contact = |fold: &Option<Fold>| fold.as_ref().map(|fold| fold.contact);
        let (pulled, snapped, separated) = (contact(pull_off), contact(snap_in), contact(separation));
        let of = |values: Option<PartialValues>, part: fn(&PartialValues) -> Estimate| values.as_ref().map(part);
        let half_width = |values: &PartialValues| values.half_width;
        let penetration = |values: &PartialValues| values.penetration;
        let turned = |fold: &Option<Fold>| fold.as_ref().map(|fold| fold.value);
        let all = [
            Some(Estimate::exact(self.sliding.speed)),
            adhesion.map(|adhesion| Estimate::exact(adhesion.trailing_work)),
            turned(pull_off),
            of(pulled, half_width),
            of(pulled, penetration),
            of(*zero_load, half_width),
            of(*zero_load, penetration),
            turned(snap_in),
            of(snapped, half_width),
            of(snapped, penetration),
            turned(separation),
            of(separated, half_width),
            of(separated, |values| values.mean_pressure),
            toughness.as_ref().ok().map(|toughness| toughness.value),
        ];
        let mut reduced: Vec<Option<Estimate>> = if self.is_wave() {
            all.to_vec()
        } else {
            super::columns::CYLINDER_STRENGTH.iter().filter_map(|&place| all.get(place).copied()).collect()
        };
        reduced.extend(extras.values);
        self.finish(row, reduced, self.works_of_adhesion())?;
        let residual = [pull_off, snap_in, separation].into_iter().flatten().map(|fold| fold.residual).fold(0.0, f64::max);
        row.certificate = Some(Certificate { residual, condition: 1.0, admissible: true });
        let closure_evaluations = work.closure_evaluations;
        row.work = Work { closure_evaluations, linear_solves: SOLVES * closure_evaluations, ..Work::default() };
        row.work += extras.work;
        let zones = adhesion.map(|adhesion| [adhesion.trailing_zone, adhesion.leading_zone].map(|zone| Some(zone * self.scale.length)));
        // The narrowest contact that is spoken of.
        let narrowest = [pulled, separated, *zero_load].into_iter().flatten().map(|values| values.half_width.value).reduce(f64::min);
        row.assumptions = self.assumed(narrowest.map(|width| width * self.scale.length), zones.unwrap_or([None, None]));
        let mut missing = extras.notes;
        if zero_load.is_none() {
            missing.push("no zero load: no stable contact is without load".into());
        }
        missing.extend(turns_missing(&found, self.is_wave(), ""));
        if let (Err(refusal), true) = (toughness, self.is_wave()) {
            missing.push(format!("no toughness: {}", self.sentence(refusal)));
        }
        if !missing.is_empty() {
            row.reason = Some(row.reason.take().into_iter().chain(missing).collect::<Vec<_>>().join("; "));
        }
        Ok(())
    }
}

/// Which turns of a strength are not there and why, each after a word of whom it is spoken.
pub(super) fn turns_missing(found: &Strength, is_wave: bool, of: &str) -> Vec<String> {
    let Strength { pull_off, snap_in, separation, .. } = found;
    let (load, penetration) = (FoldQuantity::MeanPressure, FoldQuantity::Penetration);
    let turns = [
        (pull_off.is_some(), "pull-off", load, "no load of the branch is smallest"),
        (snap_in.is_some() || !is_wave, "snap-in", load, "no load of the branch is largest"),
        (separation.is_some() || !is_wave, "separation", penetration, "no penetration of the branch is smallest"),
    ];
    turns
        .into_iter()
        .filter(|(is_there, ..)| !is_there)
        .map(|(_, name, quantity, why)| match found.why_not(quantity) {
            Some(refusal) => format!("no {of}{name}: {refusal}"),
            None => format!("no {of}{name}: {why}"),
        })
        .collect()
}
