//! Growth of a crack under a constant load: the stepper beside the thesis's stepping, against the closed form.

use super::{Diagram, Method, Sample};
use crate::studies::convergence::crack::case;
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::timing::{Timed, timed};
use viscotack::crack::delayed::{LoadHistory, Resolution, trajectory};
use viscotack::refusal::Refusal;

fn diagram(effort: Effort) -> Result<Diagram, Refusal> {
    let case = case()?;
    let problem = case.problem()?;
    let history = LoadHistory::constant(case.intensity)?;
    let lines = effort.choose(vec![4, 8, 16, 32, 64, 128, 256], vec![4, 8, 16, 32, 64, 128, 256, 512, 1024]);
    let own = lines
        .into_iter()
        .map(|lines_per_zone| {
            let resolution = Resolution { lines_per_zone, ..Resolution::default() };
            let Timed { seconds, runs, result: found } = timed(|| trajectory(&problem, &history, &case.times, resolution));
            let setting = format!("{lines_per_zone} lines");
            match found {
                Ok(found) => {
                    let work = [
                        ("evaluations of the closure", found.work.closure_evaluations),
                        ("steps", found.work.steps),
                        ("kernels", found.work.kernel_evaluations),
                    ];
                    let counted = work.map(|(counted, count)| (counted, count as f64)).to_vec();
                    let places: Vec<f64> = found.samples.iter().filter_map(|sample| sample.growth.map(|growth| growth.value)).collect();
                    Sample { setting, seconds, runs, counted, error: Ok(case.error(&places)) }
                }
                Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
            }
        })
        .collect();
    let steps = effort.choose(vec![4_usize, 8, 16, 32], vec![4, 8, 16, 32, 64, 128]);
    let theirs = steps
        .into_iter()
        .map(|steps| {
            let Timed { seconds, runs, result: found } = timed(|| case.stepped(steps, 12 * steps));
            let setting = format!("{steps} steps a delay");
            match found {
                Ok((places, [evaluations, roots])) => {
                    let counted = vec![("evaluations of the closure", evaluations as f64), ("roots", roots as f64)];
                    Sample { setting, seconds, runs, counted, error: Ok(case.error(&places)) }
                }
                Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
            }
        })
        .collect();
    let methods = vec![
        Method { name: "this program".into(), own: true, samples: own },
        Method { name: "thesis's stepping".into(), own: false, samples: theirs },
    ];
    Ok(Diagram {
        identifier: "delayed_fracture".into(),
        caption: "A crack under a constant load, from its delay to two and a half process zones: largest error of the place, over the zone, against the closed form of one term.".into(),
        error: r"error of $x_0/\delta$",
        counted: "evaluations of the closure",
        methods,
        headline: false,
    })
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_growth", "Work and precision: growth of a crack");
    progress.expect(1);
    section.say(
        "This program carries the memory of the moving zone term by term, so a step costs the same however long the history; the thesis's stepping sums the whole history \
         at every point of the zone. An evaluation of theirs grows with the number of steps, one of ours does not.",
    );
    match diagram(effort) {
        Ok(diagram) => diagram.into_section(&mut section),
        Err(refusal) => section.checks.push(Check::new("delayed_fracture", "every run ends", refusal.to_string(), false)),
    }
    progress.advance(1);
    section
}
