//! Problems that other programs have run: their stored runs, and this program beside them where it solves the same problem now.

use super::{Diagram, Method, Sample};
use crate::studies::convergence::sphere::solid;
use crate::studies::reference::{SPHERE_ANNULI, rows};
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::stored::stored_runs;
use crate::studies::timing::{Timed, timed};
use std::f64::consts::PI;
use viscotack::indentation::{Contact, Profile, Springs, Sweep};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::steady::{Indenter, SlidingControl, SlidingOutcome, SlidingProblem, steady_sliding};

/// Diagrams of the other sections, which draw their own stored runs.
const DRAWN_BY_OTHERS: [&str; 7] = [
    "sliding_one_term",
    "sliding_twelve_terms",
    "sphere_retraction",
    "delayed_fracture",
    "steady_crack_opening",
    "steady_crack_closing",
    "line_at_a_distance",
];

/// One of this program's runs: time, error.
fn sample(setting: &str, Timed { seconds, runs, result: found }: Timed<Result<f64, Refusal>>) -> Vec<Method> {
    let error = found.map_err(|refusal| refusal.to_string());
    let sample = Sample { setting: setting.to_owned(), seconds, runs, counted: Vec::new(), error };
    vec![Method { name: "this program".into(), own: true, samples: vec![sample] }]
}

/// Penetration and interface work of an elastic wave at p̄ = ½ against Westergaard's wave.
fn elastic_wave() -> Result<f64, Refusal> {
    let pressure: f64 = 0.5;
    let problem = SlidingProblem {
        rate: 0.0,
        indenter: Indenter::Wave,
        adhesion: None,
        work_by_speed: None,
        control: SlidingControl::MeanPressure(pressure),
        accuracy: 1e-12,
    };
    let SlidingOutcome::Partial(found) = steady_sliding(&PlaneMaterial::elastic(1.1e6)?, &problem)? else {
        return Err(Refusal::Undefined { quantity: "the edges", reason: "full contact".into() });
    };
    let square = pressure;
    let penetration = square * (1.0 - square.ln());
    let work = 0.5 * (2.0 * PI * square - PI * square * square + 2.0 * PI * (penetration - 1.0) * pressure);
    let error = |found: f64, exact: f64| (found - exact).abs() / exact.abs().max(1.0);
    Ok(error(found.values.penetration.value, penetration).max(error(found.values.interface_work.value, work)))
}

/// The force after a retraction along a prescribed edge, over the largest of the history, against the stored annuli.
fn prescribed_edge() -> Result<f64, Refusal> {
    let material = solid()?;
    let springs = Springs::new(&material)?;
    let start = Contact::relaxed(&springs, Profile::Paraboloid { radius: 1.0 }, 0.24, 0.032)?;
    let end = start.moved(0.2, 0.02, 1.0, Sweep::Linear)?.moved(0.16, 0.0, 1.0, Sweep::Linear)?;
    let all = rows(SPHERE_ANNULI);
    let row = all.iter().find(|row| row.text("case") == "retraction" && row.text("quantity") == "force" && row.text("instant") == "1");
    Ok(row.map_or(f64::INFINITY, |row| (end.force() - row.number("value")).abs() / row.number("scale")))
}

/// Caption, what the error is of, and this program's run of a problem.
fn known(problem: &str) -> (String, &'static str, Vec<Method>) {
    match problem {
        "elastic_wave" => (
            "An elastic wave without adhesion at half of full contact: error of penetration and interface work against Westergaard's closed form.".into(),
            "largest error",
            sample("to rounding", timed(elastic_wave)),
        ),
        "sliding_without_adhesion" => (
            "A wave that slides without adhesion over a solid of one time, by Tamaas's generalised Maxwell half-space stepped in time, and by this program (stored in the same run).".into(),
            "largest error",
            Vec::new(),
        ),
        "adhesive_elastic_wave" => (
            "An elastic adhesive wave in the limit of a short range (Johnson's wave): the peers have an exponential attraction of a range, refined with the grid.".into(),
            "error of the mean pressure",
            Vec::new(),
        ),
        "flat_punch_elastic_bulk" => (
            "A flat punch pressed at once and held on a solid of elastic bulk and viscoelastic shear: error of the force, by finite elements.".into(),
            r"error of $F/F_{\mathrm{max}}$",
            Vec::new(),
        ),
        "sphere_prescribed_edge" => (
            "A sphere retracted along a prescribed edge, one relaxation time: error of the force at the end over the largest. Of this program it is the distance from the \
             stored annuli, which are sure to 2·10⁻⁹; it needs two steps, as the line is exact for straight ways."
                .into(),
            r"error of $F/F_{\mathrm{max}}$",
            sample("two steps", timed(prescribed_edge)),
        ),
        other => match other.strip_prefix("material_fit_") {
            Some(data) => (
                format!("Series fitted to dynamic moduli ({data}): root mean square of the relative error against the truth. Both programs stored, in one run."),
                "relative error of the fit",
                Vec::new(),
            ),
            None => (format!("{other}: stored runs of another program."), "error", Vec::new()),
        },
    }
}

pub(in crate::studies) fn study(_: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_peers", "Work and precision: other programs");
    let mut problems: Vec<String> = Vec::new();
    for run in stored_runs() {
        if !problems.contains(&run.problem) && !DRAWN_BY_OTHERS.contains(&run.problem.as_str()) {
            problems.push(run.problem);
        }
    }
    progress.expect(1);
    section.say(
        "Programs that are not part of this one were run once, on the machine and day that the tables name; their runs are drawn hollow. Their times are those of another \
         day, and no result is drawn from them. Tamaas steps a generalised Maxwell half-space, but has no adhesion with it, so on the adhesive sliding wave it has no run.",
    );
    for problem in problems {
        let (caption, error, methods) = known(&problem);
        let identifier: String = problem.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect();
        let failed = methods.iter().flat_map(|method| &method.samples).find_map(|sample| sample.error.as_ref().err().cloned());
        if let Some(reason) = failed {
            section.checks.push(Check::new(identifier.clone(), "this program solves it", reason, false));
        }
        let diagram = Diagram { identifier, caption, error, counted: "", methods, headline: false };
        diagram.of_problem(&problem, &mut section);
    }
    progress.advance(1);
    section
}
