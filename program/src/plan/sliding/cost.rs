//! What a sliding contact is expected to cost: the one place to tune when the solver changes.

use super::SlidingPlan;
use crate::outcome::Work;
use crate::scene::typed::{BranchParameter, SlidingBranch, SlidingColumns, SlidingContact, SlidingLoad, SlidingTask};
use viscotack::sliding::branch::{Scan, beyond_both_ends};

/// Balances of a contact of a load or penetration. With adhesion: the equilibrium curve, the contact and its stability. Without: the contact alone.
const ON_CURVE: [f64; 2] = [133.0, 45.0];
/// Balances of a contact of a given half-width.
const OF_WIDTH: f64 = 21.0;
/// Balances of the elastic reference contact.
const ELASTIC_REFERENCE: f64 = 140.0;
/// Contacts solved for one balance with adhesion: as it is, and with each edge moved.
const SOLVES: f64 = 3.0;

/// Balances of a branch of every load with its turns, of an elastic contact and of one with memory, which may turn back once more.
const EVERY_LOAD: [f64; 2] = [900.0, 2200.0];
/// Balances of a branch of speeds, the same.
const EVERY_SPEED: [f64; 2] = [330.0, 800.0];
/// Balances of a branch of works of adhesion or process zones.
const EVERY_ADHESION: f64 = 250.0;
/// Balances of a point of a branch: the contact, and what moved edges do to it.
const POINT: f64 = 19.0;

/// Balances of a wave's branch as far as snap-in with three turns, of an elastic contact and of one with memory: for a loose accuracy, and for another.
const TO_SNAP_IN: [[f64; 2]; 2] = [[610.0, 690.0], [945.0, 1045.0]];
/// Balances of the work to separate, each contact with its slopes: two rules of three and four contacts for a loose accuracy, of twelve and twenty for another.
const SEPARATION: [f64; 2] = [100.0, 640.0];
/// From here on an accuracy is loose.
const LOOSE: f64 = 1e-5;
/// Balances of the sensitivities of a contact, and of what one carries.
const SENSITIVITIES: [f64; 2] = [50.0, 1500.0];

/// Points by which is seen how much of a branch lies within a range of loads, and points outside it over those inside.
const PROBES: f64 = 40.0;
const OUTSIDE: f64 = 0.7;

/// Balances of a half-width of a scan: two for the forms, the rest for what comes out as a contact.
const SCANNED: f64 = 6.0;

/// Time of a linear system: of any, and of the square of its terms (s).
const SYSTEM: f64 = 2e-6;
const SYSTEM_OF_TERMS: f64 = 3.3e-7;

impl SlidingPlan {
    /// Time of a linear system (s): 2n + 2 unknowns of n terms.
    pub(super) fn seconds_of_a_system(&self) -> f64 {
        let terms = self.material.relaxation_terms().len() as f64;
        SYSTEM + SYSTEM_OF_TERMS * terms * terms
    }

    /// Balances of a branch.
    fn balances_of_branch(&self, branch: &SlidingBranch) -> f64 {
        let memory = usize::from(!self.material.is_elastic());
        let of = |ways: [f64; 2]| ways.get(memory).copied().unwrap_or(0.0);
        let curve = match branch.parameter {
            BranchParameter::HalfWidth => of(EVERY_LOAD),
            // Followed as a whole, then where it is wanted.
            BranchParameter::MeanPressure | BranchParameter::LoadPerWidth | BranchParameter::Penetration => {
                of(EVERY_LOAD) * if branch.range.is_some() { 2.0 } else { 1.0 }
                    + if branch.range.is_some() { POINT * (PROBES + OUTSIDE * f64::from(branch.points)) } else { 0.0 }
            }
            BranchParameter::Speed if self.is_scanned(branch) => of(EVERY_SPEED) + self.balances_of_scan(branch),
            BranchParameter::Speed => of(EVERY_SPEED),
            BranchParameter::WorkOfAdhesion | BranchParameter::ProcessZone => EVERY_ADHESION,
        };
        let scan = if branch.every && branch.parameter != BranchParameter::Speed { self.balances_of_scan(branch) } else { 0.0 };
        curve + scan + POINT * f64::from(branch.points)
    }

    /// Whether every contact is scanned along speeds: on request, and where neither end carries what is held.
    fn is_scanned(&self, branch: &SlidingBranch) -> bool {
        branch.every
            || self
                .branch_problem(Some(branch.parameter), self.span(branch))
                .is_ok_and(|problem| beyond_both_ends(&self.material, &problem))
    }

    /// Balances of a scan.
    fn balances_of_scan(&self, branch: &SlidingBranch) -> f64 {
        let Ok(problem) = self.branch_problem(Some(branch.parameter), self.span(branch)) else { return 0.0 };
        let Scan { half_widths, parameters } = Scan::of(&problem);
        let parameters = if branch.parameter.is_load() { 1 } else { parameters };
        SCANNED * (half_widths * parameters) as f64
    }

    /// Balances of what a contact carries.
    fn balances_of_strength(&self) -> f64 {
        let tight = usize::from(self.accuracy < LOOSE);
        let of_wave = |memory: usize| TO_SNAP_IN[tight][memory] + SEPARATION[tight];
        let memory = usize::from(!self.material.is_elastic());
        let own = if self.is_wave() { of_wave(memory) } else { EVERY_LOAD[memory] };
        let reference = if self.asks(SlidingColumns::ElasticReference) { of_wave(0) } else { 0.0 };
        own + reference + if self.asks(SlidingColumns::Sensitivities) { SENSITIVITIES[1] } else { 0.0 }
    }

    /// Balances of one contact. Measured over the shipped scenes, see `tests/program/explain_predicts_work.rs`.
    const fn balances(&self, contact: SlidingContact) -> f64 {
        match (self.sliding.control, contact) {
            (SlidingLoad::HalfWidth(_), _) => OF_WIDTH,
            (_, SlidingContact::Adhesive) => ON_CURVE[0],
            (_, SlidingContact::Adhesiveless) => ON_CURVE[1],
        }
    }

    /// Expected work of a sweep of so many states, over the speeds that it runs through.
    pub(super) fn work_of_states(&self, states: u64) -> Work {
        let of_curve = match &self.sliding.task {
            SlidingTask::State => None,
            SlidingTask::Branch(branch) => Some(self.balances_of_branch(branch)),
            SlidingTask::Strength => Some(self.balances_of_strength()),
        };
        if let Some(balances) = of_curve {
            let balances = balances * states as f64;
            return Work {
                closure_evaluations: balances.ceil() as u64,
                linear_solves: (SOLVES * balances).ceil() as u64,
                ..Work::default()
            };
        }
        let of_contact = |contact: SlidingContact| {
            let mut balances = self.balances(contact);
            if contact == SlidingContact::Adhesive {
                balances += if self.asks(SlidingColumns::ElasticReference) { ELASTIC_REFERENCE } else { 0.0 };
                balances += if self.asks(SlidingColumns::Sensitivities) { SENSITIVITIES[0] } else { 0.0 };
            }
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
