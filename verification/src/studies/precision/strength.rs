//! Pull-off of a sliding wave: the turn of the branch of loads beside loads that are lowered until no contact is left.

use super::sliding::State;
use super::{Diagram, Method, Sample};
use crate::rivals::sliding_collocation::{Layout, SlidingCollocation};
use crate::studies::calibration::strength::least_load;
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::timing::{Timed, timed};
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{BranchProblem, strength};
use viscotack::sliding::contact::{Prescribed, WaveContact};
use viscotack::sliding::steady::{SlidingControl, SlidingProblem, Start, steady_sliding_near};

/// Accuracies of this program.
const ACCURACIES: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];
/// First step of a lowered load, over its size.
const FIRST_STEP: f64 = 0.1;
/// Last step of the collocation's loads, over their size: its meshes err by more.
const LAST_STEP: f64 = 1e-4;
/// Half-widths beside that of pull-off, over it, of the truth.
const BESIDE: f64 = 0.002;
const COUNTED: &str = "evaluations of both edge conditions";

/// The last load held when loads are lowered, each from the contact before, and the step is halved where there is none: how pull-off is found without a branch.
/// `contact` gives edges and evaluations.
fn lowered(
    (mut load, mut at): (f64, WaveContact),
    size: f64,
    last_step: f64,
    contact: impl Fn(f64, WaveContact) -> Result<(WaveContact, u64), Refusal>,
) -> Result<(f64, u64), Refusal> {
    let (found, mut evaluations) = contact(load, at)?;
    at = found;
    let mut step = FIRST_STEP * size;
    while step > last_step * size {
        // A contact that widens under a falling load is of another branch.
        match contact(load - step, at) {
            Ok((found, more)) if found.half_width < at.half_width => {
                (load, at) = (load - step, found);
                evaluations += more;
            }
            _ => step *= 0.5,
        }
    }
    Ok((load, evaluations))
}

fn sample(setting: String, truth: f64, timed: Timed<Result<(f64, u64), Refusal>>) -> Sample {
    let Timed { seconds, runs, result } = timed;
    let counted = result.as_ref().map_or_else(|_| Vec::new(), |(_, evaluations)| vec![(COUNTED, *evaluations as f64)]);
    let error = result.map(|(load, _)| (load / truth - 1.0).abs()).map_err(|refusal| refusal.to_string());
    Sample { setting, seconds, runs, counted, error }
}

fn diagram(effort: Effort) -> Result<Diagram, Refusal> {
    let state = State::stored("one")?;
    let loads = |accuracy: f64| BranchProblem::loads(1.0, state.adhesion, accuracy);
    let none = || Refusal::NotConverged { what: "pull-off of the stored wave", detail: "no turn of the load was found".into() };
    let fold = strength(&state.material, &loads(1e-8))?.pull_off.ok_or_else(none)?;
    let truth = least_load(&state.material, &loads(1e-8), fold.contact.half_width.value, BESIDE).ok_or_else(none)?;
    let own = ACCURACIES.map(|accuracy| {
        let found = timed(|| {
            let found = strength(&state.material, &loads(accuracy))?;
            Ok((found.pull_off.ok_or_else(none)?.value.value, found.work.closure_evaluations))
        });
        sample(format!("{accuracy:.0e}"), truth, found)
    });
    let size = truth.abs();
    let begin = (state.pressure, state.start());
    let by_loads = effort.choose(vec![1e-2, 1e-4, 1e-6], vec![1e-2, 1e-4, 1e-6, 1e-8]).into_iter().map(|accuracy| {
        let problem = |load: f64| SlidingProblem { control: SlidingControl::MeanPressure(load), ..state.problem(accuracy) };
        let contact = |load: f64, at: WaveContact| {
            let start = Start::at(at.half_width, at.eccentricity);
            let found = steady_sliding_near(&state.material, &problem(load), &start)?;
            let edges = WaveContact { half_width: found.values.half_width.value, eccentricity: found.values.eccentricity.value };
            Ok((edges, found.work.closure_evaluations))
        };
        sample(format!("{accuracy:.0e}"), truth, timed(|| lowered(begin, size, accuracy, contact)))
    });
    let by_loads = by_loads.collect();
    let meshes = effort.choose(vec![25, 50], vec![25, 50, 100]);
    let collocated = meshes.into_iter().map(|elements| {
        let found = timed(|| {
            let scheme = SlidingCollocation::new(state.memory.kernel(), Layout::Mapped, elements, 1.0)?;
            lowered(begin, size, LAST_STEP, |load, at| {
                let found = scheme.equilibrium(&state.adhesion, Prescribed::MeanPressure(load), at, 1e-6)?;
                Ok((found.edges, u64::from(found.evaluations)))
            })
        });
        sample(format!("N = {elements}"), truth, found)
    });
    let collocated = collocated.collect();
    Ok(Diagram {
        identifier: "sliding_pull_off".into(),
        caption: "The pull-off load of a sliding wave (β = 10, ζ = 0.6): relative error against the least load of contacts of five held half-widths, without a branch and \
                  without fold equations."
            .into(),
        error: "error of the pull-off load",
        counted: COUNTED,
        methods: vec![
            Method { name: "this program, branch and turn".into(), own: true, samples: own.to_vec() },
            Method { name: "its contacts, loads lowered".into(), own: false, samples: by_loads },
            Method { name: "thesis's contacts, loads lowered".into(), own: false, samples: collocated },
        ],
        headline: false,
    })
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_strength", "Work and precision: strengths of sliding contacts");
    progress.expect(1);
    section.say(
        "This program follows the branch of loads and solves for its turn; in the same run it finds snap-in, separation and toughness. The rivals begin at a known contact and lower \
         the load, each contact being the start of the next, with half the step wherever there is none: with this program's contacts, and with the thesis's collocation. Evaluations \
         of theirs that led to no contact are not counted.",
    );
    match diagram(effort) {
        Ok(diagram) => diagram.into_section(&mut section),
        Err(refusal) => section.checks.push(Check::new("sliding_pull_off", "the truth is found", refusal.to_string(), false)),
    }
    progress.advance(1);
    section
}
