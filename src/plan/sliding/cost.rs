//! What a sliding contact is expected to cost: the one place to tune when the solver changes.

use super::SlidingPlan;
use crate::outcome::Work;
use crate::scene::typed::SlidingContact;

/// Balances of an elastic contact, whatever its speed.
const ELASTIC: f64 = 5.0;
/// Balances at a rate so slow that the relaxed contact is all but the answer.
const SLOW: f64 = 8.0;
/// Further balances per factor e of the rate, on the path from the slow contact, of a single term; the more terms, the smoother the path.
const PER_LOGARITHM: [f64; 2] = [6.0, 10.0];
/// The path begins at this part of a process zone in the longest retardation time.
const START: f64 = 0.1;
/// The zone that stands for it where there is no adhesion (in 1/k).
const NO_ZONE: f64 = 0.1;
/// Contacts solved for one balance with adhesion: as it is, and with each edge moved.
const SOLVES: f64 = 3.0;

impl SlidingPlan {
    /// Balances of one contact at a speed. Measured over the shipped scenes, see `tests/explain_predicts_work.rs`.
    fn balances(&self, contact: SlidingContact, speed: f64) -> f64 {
        let Some(time) = self.material.longest_retardation_time() else { return ELASTIC };
        let (zone, per_logarithm) = match (contact, self.reduced_adhesion()) {
            (SlidingContact::Adhesive, Some(adhesion)) => (adhesion.trailing_zone.min(adhesion.leading_zone), PER_LOGARITHM[0]),
            _ => (NO_ZONE, PER_LOGARITHM[1]),
        };
        let smoothness = (self.material.creep_terms().len() as f64).sqrt();
        SLOW + per_logarithm / smoothness * (self.rate(speed) * time / (START * zone)).max(1.0).ln()
    }

    /// Expected work of a sweep of so many states, over the speeds that it runs through.
    pub(super) fn work_of_states(&self, states: u64) -> Work {
        let of_contact = |contact: SlidingContact| {
            let balances = self.speeds.iter().map(|&speed| self.balances(contact, speed)).sum::<f64>() / self.speeds.len().max(1) as f64;
            let solves = if contact == SlidingContact::Adhesive { SOLVES } else { 1.0 };
            (balances * states as f64, solves * balances * states as f64)
        };
        let (mut balances, mut solves) = (0.0, 0.0);
        for &contact in &self.sliding.contacts {
            let (more_balances, more_solves) = of_contact(contact);
            balances += more_balances;
            solves += more_solves;
        }
        let fields = u64::from(self.sliding.field_points.unwrap_or(0)) * self.sliding.contacts.len() as u64;
        Work {
            closure_evaluations: balances.ceil() as u64,
            kernel_evaluations: 0,
            linear_solves: solves.ceil() as u64,
            field_evaluations: fields * states,
        }
    }
}
