//! A retraction of a sphere: the integration beside dense annuli.

use super::{Diagram, Method, Sample};
use crate::studies::convergence::sphere::{against_stored, annuli, error, forces, retraction, solid, truth};
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::timing::{Timed, timed};
use viscotack::indentation::{integrate, run};
use viscotack::refusal::Refusal;

fn diagram(effort: Effort) -> Result<Diagram, Refusal> {
    let (material, truth) = (solid()?, truth()?);
    let accuracies = effort.choose(vec![1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7], vec![1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]);
    let own = accuracies
        .into_iter()
        .map(|accuracy| {
            let problem = retraction(accuracy);
            let Timed { seconds, runs, result: found } = timed(|| run(&material, &problem));
            let setting = format!("{accuracy:.0e}");
            match found {
                Ok(found) => {
                    let work = [
                        ("evaluations of the closure", found.work.closure_evaluations),
                        ("steps", found.work.steps),
                        ("points updated", found.work.history_updates),
                    ];
                    let counted = work.map(|(counted, count)| (counted, count as f64)).to_vec();
                    Sample { setting, seconds, runs, counted, error: Ok(error(&forces(&found.integration), &truth)) }
                }
                Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
            }
        })
        .collect();
    let tolerances = effort.choose(vec![1e-1, 1e-2, 1e-3, 1e-4, 1e-6], vec![1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]);
    let single = tolerances
        .into_iter()
        .map(|tolerance| {
            let problem = retraction(tolerance);
            let Timed { seconds, runs, result: found } = timed(|| integrate(&material, &problem, tolerance));
            let setting = format!("{tolerance:.0e}");
            match found {
                Ok(trace) => {
                    let counted =
                        vec![("evaluations of the closure", trace.work.closure_evaluations as f64), ("steps", trace.work.steps as f64)];
                    Sample { setting, seconds, runs, counted, error: Ok(error(&forces(&trace), &truth)) }
                }
                Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
            }
        })
        .collect();
    let mut methods = vec![
        Method { name: "this program".into(), own: true, samples: own },
        Method { name: "one integration, no bounds".into(), own: true, samples: single },
    ];
    for (name, keep, meshes) in [
        ("annuli, factors kept", true, effort.choose(vec![2_usize, 4, 8], vec![2, 4, 8, 16, 32])),
        ("annuli, as printed", false, effort.choose(vec![2, 4], vec![2, 4, 8, 16])),
    ] {
        let samples = meshes
            .into_iter()
            .map(|elements| {
                let Timed { seconds, runs, result: found } = timed(|| annuli(elements, keep));
                let setting = format!("{elements} a zone");
                match found {
                    Ok((forces, path)) => {
                        let counted =
                            vec![("evaluations of the closure", path.solutions as f64), ("matrices factored", path.factorizations as f64)];
                        let error = error(&forces, &truth);
                        let error = if error.is_finite() { Ok(error) } else { Err("the contact was lost too early".to_owned()) };
                        Sample { setting, seconds, runs, counted, error }
                    }
                    Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
                }
            })
            .collect();
        methods.push(Method { name: name.to_owned(), own: false, samples });
    }
    let sure = against_stored(&truth).map_or(f64::NAN, |[error, _]| error);
    Ok(Diagram {
        identifier: "sphere_retraction".into(),
        caption: format!(
            "A sphere retracted from a relaxed contact past its largest tension (β = 10, V·ρ/R = 2·10⁻³): largest error of the force at nine instants, over the largest force. \
             Truth: the integration at 10⁻⁹, which the stored annuli of another program meet within {sure:.0e}."
        ),
        error: r"error of $F/F_{\mathrm{max}}$",
        counted: "evaluations of the closure",
        methods,
        headline: true,
    })
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_sphere", "Work and precision: the sphere");
    progress.expect(1);
    section.say(
        "This program tells the numbers of an integration that two others assess, ten and a hundred times tighter: the time is of all three; a single integration gives no error bound, as the rival gives none. The annuli are the thesis's scheme, each trial edge a dense \
         system of its own as printed, or with the factors of an edge kept. An evaluation of theirs costs the square of the number of annuli at least.",
    );
    match diagram(effort) {
        Ok(diagram) => diagram.into_section(&mut section),
        Err(refusal) => section.checks.push(Check::new("sphere_retraction", "the truth is found", refusal.to_string(), false)),
    }
    progress.advance(1);
    section
}
