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

/// Two runs, each tighter than the one before, and others until the last two agree. Where a third or later one is refused, the two before it are what is
/// known.
fn until_they_agree(solved: &mut dyn FnMut(u32) -> Result<Run, Refusal>, agree: impl Fn(&Runs) -> bool) -> Result<Runs, Refusal> {
    let mut runs = Runs::of(solved(1)?, solved(2)?, 0);
    for number in 3..=RUNS {
        if agree(&runs) {
            break;
        }
        match solved(number) {
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

impl FiniteRangePlan {
    /// What the solver is asked.
    pub(super) fn problem(&self) -> Result<Problem, Refusal> {
        Ok(self.course.problem(&self.reduced))
    }

    /// The runs of the state.
    pub(super) fn runs(&self, state_watch: &StateWatch<'_>) -> Result<Runs, Refusal> {
        let problem = self.problem()?;
        let accuracy = Accuracy::of_law(self.solver_accuracy, &self.reduced.law);
        let mut mesher = Mesher::new(accuracy.order);
        let mut next = accuracy;
        let mut solved = |number: u32| {
            let tighter = next.tightened();
            let accuracy = std::mem::replace(&mut next, tighter);
            run_watched(&problem, accuracy, &mut mesher, &mut |part| state_watch.passed(number, part.min(1.0)))
        };
        until_they_agree(&mut solved, |runs| runs.consistent && self.agree(runs) && self.cycles_agree(runs))
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use viscotack::finite_range::law::{Attraction, Law};
    use viscotack::finite_range::sphere::{Control, Creep, Leg, Motion, Start, run};

    fn pulled(accuracy: Accuracy) -> Run {
        let creep = Creep { stiffening: 10.0, fractions: vec![1.0], times: vec![1.0] };
        let history = vec![Leg { control: Control::Penetration, motion: Motion::Ramp { to: -4.0, duration: 5.0 } }];
        let problem = Problem::new(Law::LennardJones, 0.5, creep, Start::Relaxed(1.0), history);
        run(&problem, accuracy, &mut Mesher::new(accuracy.order)).unwrap()
    }

    #[test]
    fn a_refused_third_run_leaves_what_two_runs_know() {
        let accuracy = Accuracy::of_law(1e-3, &Attraction::new(Law::LennardJones, 1.0, 1.0).unwrap());
        let both = [pulled(accuracy), pulled(accuracy.tightened())];
        let iterations: Vec<u64> = both.iter().map(|run| run.certificate.iterations as u64).collect();
        let refusal = || Refusal::NotConverged { what: "the mesh", detail: "too fine".to_owned() };
        // What refuses: the third run, the fourth (the third is the second again), the second.
        let refused_at = |last: u32| {
            let mut solved = |number: u32| if number < last { Ok(both[usize::from(number > 1)].clone()) } else { Err(refusal()) };
            until_they_agree(&mut solved, |_| false)
        };
        let third = refused_at(3).unwrap();
        assert_eq!(third.refused, Some(refusal()));
        assert_eq!((&third.loose, &third.tight), (&both[0], &both[1]));
        assert_eq!(third.systems, iterations[0] + iterations[1]);
        let fourth = refused_at(4).unwrap();
        assert_eq!(fourth.refused, Some(refusal()));
        assert_eq!((&fourth.loose, &fourth.tight), (&both[1], &both[1]));
        assert_eq!(fourth.systems, iterations[0] + 2 * iterations[1]);
        assert_eq!(refused_at(2).err(), Some(refusal()));
        // Runs that agree are not repeated.
        let mut solved = |number: u32| if number < 3 { Ok(both[number as usize - 1].clone()) } else { Err(refusal()) };
        assert_eq!(until_they_agree(&mut solved, |_| true).unwrap().refused, None);
    }
}
