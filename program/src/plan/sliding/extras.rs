//! The values of the columns on request: works, parts of the friction, the elastic reference contact, sensitivities; reduced, in the order of their definitions.

use super::SlidingPlan;
use super::extra_columns::{has_works, outputs_of_state, outputs_of_strength};
use super::strength_rows::turns_missing;
use crate::outcome::Work;
use crate::scene::typed::SlidingColumns;
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{BranchProblem, Strength};
use viscotack::sliding::elastic_reference::{elastic_reference_contact, elastic_reference_strength};
use viscotack::sliding::sensitivity::{Sensitivity, state_sensitivities, strength_sensitivities};
use viscotack::sliding::steady::{PartialValues, SlidingOutcome, SlidingProblem};

/// Linear systems of one balance with adhesion: the contact as it is, and with each edge moved.
const SOLVES: u64 = 3;
/// A dissipation governs that makes up all friction but this part.
const GOVERNS: f64 = 0.1;
/// A share with a wider bound does not tell which one governs.
const LARGEST_ERROR: f64 = 0.01;

/// Values of columns on request, what they took, and why some are missing.
pub(super) struct Extras {
    pub(super) values: Vec<Option<Estimate>>,
    pub(super) work: Work,
    pub(super) notes: Vec<String>,
}

impl Extras {
    fn new() -> Self {
        Self { values: Vec::new(), work: Work::default(), notes: Vec::new() }
    }

    fn balances(&mut self, closure_evaluations: u64) {
        self.work += Work { closure_evaluations, linear_solves: SOLVES * closure_evaluations, ..Work::default() };
    }
}

/// A quantity of the reference in units of E0 instead of its own modulus.
fn stiffer(value: Estimate, modulus: Estimate) -> Estimate {
    let product = value.value * modulus.value;
    Estimate::new(product, value.error * modulus.value + value.value.abs() * modulus.error + f64::EPSILON * product.abs())
}

/// Friction of the bulk, share of the edges, regime.
fn friction_parts(values: &PartialValues) -> [Option<Estimate>; 3] {
    let (total, Some(edges)) = (values.friction_stress, values.adhesion.map(|adhesion| adhesion.adhesive_friction_stress)) else {
        return [None; 3];
    };
    let bulk = Estimate::new(total.value - edges.value, total.error + edges.error);
    if total.value.abs() <= total.error {
        return [Some(bulk), None, None];
    }
    let ratio = edges.value / total.value;
    let share = Estimate::new(ratio, (edges.error + ratio.abs() * total.error) / (total.value.abs() - total.error));
    let regime = if (1.0 - share.value).abs() <= GOVERNS {
        1.0
    } else if share.value <= GOVERNS {
        -1.0
    } else {
        0.0
    };
    // A share whose bound is wider says nothing that could be relied on.
    let is_known = share.error <= LARGEST_ERROR;
    [Some(bulk), is_known.then_some(share), is_known.then_some(Estimate::exact(regime))]
}

impl SlidingPlan {
    pub(super) fn asks(&self, columns: SlidingColumns) -> bool {
        self.sliding.columns.contains(&columns)
    }

    /// The works of both edges, where they have columns, at given values.
    pub(super) fn works_of(&self, works: [Estimate; 2], with_trailing: bool) -> Vec<Option<Estimate>> {
        if has_works(&self.sliding) { works.into_iter().skip(usize::from(!with_trailing)).map(Some).collect() } else { Vec::new() }
    }

    /// Columns of branches.
    pub(super) fn extras_of_point(&self, values: &PartialValues, works: [Estimate; 2]) -> Vec<Option<Estimate>> {
        let mut extras = self.works_of(works, false);
        if self.asks(SlidingColumns::FrictionParts) {
            extras.extend(friction_parts(values));
        }
        extras
    }

    /// Columns of a state; `partial` is none where the contact is full.
    pub(super) fn extras_of_state(&self, problem: &SlidingProblem<'_>, partial: Option<&PartialValues>) -> Result<Extras, Refusal> {
        let mut extras = Extras::new();
        if let Some(adhesion) = problem.adhesion {
            extras.values = self.works_of([adhesion.trailing_work, adhesion.leading_work].map(Estimate::exact), true);
        } else {
            extras.values = self.works_of([Estimate::exact(0.0); 2], true).into_iter().map(|_| None).collect();
        }
        let adhesive = partial.filter(|_| problem.adhesion.is_some());
        if self.asks(SlidingColumns::FrictionParts) {
            extras.values.extend(adhesive.map_or([None; 3], friction_parts));
        }
        if self.asks(SlidingColumns::ElasticReference) {
            if problem.adhesion.is_some() {
                self.reference_of_state(problem, &mut extras)?;
            } else {
                extras.values.extend([None; 4]);
            }
        }
        if self.asks(SlidingColumns::Sensitivities) {
            let shown = outputs_of_state(&self.sliding);
            let sets: [Option<Sensitivity>; 4] = match adhesive {
                None => [None; 4],
                Some(values) => match state_sensitivities(&self.material, problem, values) {
                    Ok(found) => {
                        extras.balances(found.closure_evaluations);
                        [found.half_width, found.mean_pressure, found.penetration, found.friction_stress].map(Some)
                    }
                    Err(refusal) => {
                        extras.notes.push(format!("no sensitivities: {}", self.sentence(&refusal)));
                        [None; 4]
                    }
                },
            };
            extras.values.extend(listed(sets, shown));
        }
        Ok(extras)
    }

    fn reference_of_state(&self, problem: &SlidingProblem<'_>, extras: &mut Extras) -> Result<(), Refusal> {
        let modulus = viscotack::sliding::elastic_reference::elastic_reference_modulus(&self.material, problem.indenter, problem.rate)?;
        let relaxed = self.material.relaxed_modulus();
        extras.values.push(Some(modulus.scaled(relaxed)));
        match elastic_reference_contact(&self.material, problem) {
            Ok(reference) => match reference.found {
                SlidingOutcome::Partial(contact) => {
                    extras.balances(contact.work.closure_evaluations);
                    let values = contact.values;
                    extras.values.extend([Some(values.half_width), Some(stiffer(values.mean_pressure, modulus)), Some(values.penetration)]);
                }
                SlidingOutcome::Full(_) => {
                    extras.values.extend([None; 3]);
                    extras.notes.push("the elastic reference contact is in full contact".into());
                }
            },
            Err(refusal) => {
                extras.values.extend([None; 3]);
                // Its limits are in units of its own modulus.
                let reason = match refusal {
                    Refusal::NoSuchState { reason, .. } => reason,
                    other => other.to_string(),
                };
                extras.notes.push(format!("no elastic reference contact: {reason}"));
            }
        }
        Ok(())
    }

    /// Columns of a strength.
    pub(super) fn extras_of_strength(&self, problem: &BranchProblem<'_>, strength: &Strength) -> Result<Extras, Refusal> {
        let mut extras = Extras::new();
        let adhesion = problem.adhesion;
        extras.values = self.works_of([adhesion.trailing_work, adhesion.leading_work].map(Estimate::exact), false);
        if self.asks(SlidingColumns::ElasticReference) {
            match elastic_reference_strength(&self.material, problem) {
                Ok(reference) => {
                    let (modulus, elastic) = (reference.modulus, reference.found);
                    extras.balances(elastic.work.closure_evaluations);
                    let pressure = |fold: &Option<viscotack::sliding::branch::Fold>| fold.as_ref().map(|fold| stiffer(fold.value, modulus));
                    extras.values.extend([
                        Some(modulus.scaled(self.material.relaxed_modulus())),
                        pressure(&elastic.pull_off),
                        elastic.pull_off.as_ref().map(|fold| fold.contact.half_width),
                        pressure(&elastic.snap_in),
                        elastic.separation.as_ref().map(|fold| fold.value),
                        elastic.toughness.as_ref().ok().map(|toughness| stiffer(toughness.value, modulus)),
                    ]);
                    extras.notes.extend(turns_missing(&elastic, true, "elastic "));
                    if let Err(refusal) = &elastic.toughness {
                        // Its limits are in units of its own modulus.
                        let reason = match refusal {
                            Refusal::NoSuchState { reason, .. } => reason.clone(),
                            other => other.to_string(),
                        };
                        extras.notes.push(format!("no elastic toughness: {reason}"));
                    }
                }
                Err(refusal) => {
                    extras.values.extend([None; 6]);
                    extras.notes.push(format!("no elastic reference contact: {refusal}"));
                }
            }
        }
        if self.asks(SlidingColumns::Sensitivities) {
            let sets: [Option<Sensitivity>; 4] = match strength_sensitivities(&self.material, problem, strength) {
                Ok(found) => {
                    extras.balances(found.closure_evaluations);
                    [found.pull_off, found.snap_in, found.separation, found.toughness.ok()]
                }
                Err(refusal) => {
                    extras.notes.push(format!("no sensitivities: {}", self.sentence(&refusal)));
                    [None; 4]
                }
            };
            extras.values.extend(listed(sets, outputs_of_strength(&self.sliding)));
        }
        Ok(extras)
    }
}

/// The sensitivities that have columns.
fn listed(sets: [Option<Sensitivity>; 4], shown: [bool; 4]) -> impl Iterator<Item = Option<Estimate>> {
    sets.into_iter().zip(shown).filter(|(_, shown)| *shown).flat_map(|(set, _)| set.unwrap_or([None; 5]))
}
