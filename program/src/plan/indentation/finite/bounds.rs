//! The runs of a state: one, and one with every tolerance tightened, until both agree as well as is wanted.

use super::FiniteRangePlan;
use crate::plan::state_watch::StateWatch;
use viscotack::finite_range::sphere::{Accuracy, Mesher, Problem, Record, Run, row_at, run_watched};
use viscotack::indentation::Watch;
use viscotack::refusal::Refusal;

/// Runs, at most.
const RUNS: u32 = 4;

/// Two runs of which the second is tighter, and what all took.
pub(super) struct Runs {
    pub(super) loose: Run,
    pub(super) tight: Run,
    /// Whether both have the same jumps and the same end.
    pub(super) consistent: bool,
    /// Linear systems of all runs.
    pub(super) systems: u64,
    /// Why there is no tighter run, where these two do not agree as well as is wanted.
    pub(super) refused: Option<Refusal>,
}

impl Runs {
    /// Two runs after others that took so many linear systems.
    fn of(loose: Run, tight: Run, before: u64) -> Self {
        let consistent = loose.jumps.len() == tight.jumps.len()
            && loose.losses.len() == tight.losses.len()
            && loose.detachment.is_some() == tight.detachment.is_some();
        let systems = before + [&loose, &tight].map(|run| run.certificate.iterations as u64).iter().sum::<u64>();
        Self { loose, tight, consistent, systems, refused: None }
    }
}

impl FiniteRangePlan {
    /// What the solver is asked.
    pub(super) fn problem(&self) -> Result<Problem, Refusal> {
        Ok(self.course.problem(&self.reduced))
    }

    /// The runs of the state. Where a third one is refused, the first two are what is known.
    pub(super) fn runs(&self, state_watch: &StateWatch<'_>) -> Result<Runs, Refusal> {
        let problem = self.problem()?;
        let accuracy = Accuracy::of_law(self.solver_accuracy, &self.reduced.law);
        let mut mesher = Mesher::new(accuracy.order);
        let mut solved = |number: u32, accuracy: Accuracy| {
            run_watched(&problem, accuracy, &mut mesher, &mut |part| state_watch.passed(number, part.min(1.0)))
        };
        let tighter = accuracy.tightened();
        let mut runs = Runs::of(solved(1, accuracy)?, solved(2, tighter)?, 0);
        let mut accuracy = tighter;
        for number in 3..=RUNS {
            if runs.consistent && self.agree(&runs) && self.cycles_agree(&runs) {
                break;
            }
            accuracy = accuracy.tightened();
            match solved(number, accuracy) {
                Ok(tight) => {
                    let before = runs.systems - runs.tight.certificate.iterations as u64;
                    runs = Runs::of(runs.tight, tight, before);
                }
                Err(refusal) => {
                    runs.refused = Some(refusal);
                    break;
                }
            }
        }
        Ok(runs)
    }

    /// Whether every instant, and the largest tension, differ by less than the wanted accuracy.
    fn agree(&self, runs: &Runs) -> bool {
        let scale = |of: fn(&Record) -> f64| runs.tight.rows.iter().fold(0.0_f64, |most, row| most.max(of(row).abs()));
        let near = |a: &Record, b: &Record, of: fn(&Record) -> f64, scale: f64| (of(a) - of(b)).abs() <= 0.5 * self.solver_accuracy * scale;
        let mut of: Vec<fn(&Record) -> f64> = vec![|row| row.force, |row| row.penetration, |row| row.contact_radius];
        if self.indentation.energies {
            of.extend([(|row: &Record| row.work) as fn(&Record) -> f64, |row| row.dissipated, |row| row.released]);
        }
        let scales: Vec<f64> = of.iter().map(|of| scale(*of)).collect();
        // Energies turn into each other: the largest is the scale of each.
        let largest = scales.iter().skip(3).copied().fold(0.0, f64::max);
        let scales: Vec<f64> = scales.iter().enumerate().map(|(place, own)| if place < 3 { *own } else { largest }).collect();
        let tension = |run: &Run| run.legs.iter().map(|leg| leg.largest_tension.force).fold(f64::INFINITY, f64::min);
        let (one, other) = (tension(&runs.loose), tension(&runs.tight));
        self.instants(runs).iter().all(|(a, b)| of.iter().zip(&scales).all(|(of, scale)| near(a, b, *of, *scale)))
            && (one - other).abs() <= 0.5 * self.solver_accuracy * other.abs()
    }

    /// The instants that become rows, of both runs.
    pub(super) fn instants<'r>(&self, runs: &'r Runs) -> Vec<(&'r Record, &'r Record)> {
        let (loose, tight) = (self.instants_of(&runs.loose), self.instants_of(&runs.tight));
        loose.into_iter().zip(tight).filter_map(|(a, b)| a.zip(b)).collect()
    }

    /// All instants of a run; none where it ended before.
    fn instants_of<'r>(&self, run: &'r Run) -> Vec<Option<&'r Record>> {
        let mut all = vec![run.rows.first()];
        for (index, piece) in self.course.pieces.iter().enumerate() {
            for time in &piece.instants {
                all.push(row_at(&run.rows, *time));
            }
            all.push(run.legs.get(index).map(|leg| &leg.end));
        }
        all
    }

    /// The states between the legs of the history, of a run.
    pub(super) fn between_legs<'r>(&self, run: &'r Run) -> Vec<Option<&'r Record>> {
        let all = self.instants_of(run);
        self.course.boundaries.iter().map(|place| all.get(*place).copied().flatten()).collect()
    }
}
