//! The integration of a sphere: steps of ours, annuli of the rival, on the retraction that the stored annuli have.

use super::Panel;
use crate::rivals::annulus_indentation::{AnnulusPath, AnnulusScheme, AnnulusStart};
use crate::studies::order::{Convergence, Expectation, FINEST};
use crate::studies::reference::{SPHERE_ANNULI, rows};
use crate::studies::section::{Check, Effort, Progress, Section};
use rayon::prelude::*;
use std::f64::consts::PI;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, Trace, integrate};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// γ̃ = 1.6e-4, δ̃ = 0.013, β = 10 (thesis chapter 4), E0* = R = ρ = 1, τ = 10.
pub(in crate::studies) const WORK: f64 = 1.6e-4 * PI;
/// See [`WORK`].
pub(in crate::studies) const ZONE: f64 = 0.013;
/// Speed of the retraction, and how long it is followed: past the largest tension.
const SPEED: f64 = 2e-3;
const END: f64 = 18.0;
/// Speeds and durations over which the order of the integration is a mean: from slow to fast, the fastest until after the contact has let go.
const PULLED: [(f64, f64); 7] = [(2e-4, 180.0), (4e-4, 90.0), (1e-3, 36.0), (SPEED, END), (4e-3, 6.6), (1e-2, 1.65), (2e-2, 0.6)];
/// Instants that are compared: every two seconds.
pub(in crate::studies) const INSTANTS: u32 = 9;
/// The loosest tolerance of the order: above some three times of it steps are as large as they may be and follow it no more.
const LOOSEST: f64 = 1e-2;
/// The relaxed contact of radius 0.24 at this process zone; the stored annuli give the same to nine digits.
const START: f64 = 3.280_536_944_6e-2;

/// β = 10, τ = 10.
pub(in crate::studies) fn solid() -> Result<PlaneMaterial, Refusal> {
    PlaneMaterial::standard_solid(1.0, 10.0, 10.0)
}

/// The retraction at an accuracy.
pub(in crate::studies) fn retraction(accuracy: f64) -> IndentationProblem {
    pulled(SPEED, END, accuracy)
}

/// A retraction at a speed for a time.
fn pulled(speed: f64, duration: f64, accuracy: f64) -> IndentationProblem {
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    let history = History::penetration(START).ramp(START - speed * duration, duration);
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history).relaxed();
    IndentationProblem { accuracy, instants_per_segment: INSTANTS, ..problem }
}

/// Forces at t = 2, 4, …, 18.
pub(in crate::studies) fn forces(trace: &Trace) -> Vec<f64> {
    trace.kept.iter().filter_map(|kept| trace.path.get(*kept)).filter(|point| point.time > 0.0).map(|point| point.force).collect()
}

/// The largest difference of force over the largest force.
pub(in crate::studies) fn error(found: &[f64], truth: &[f64]) -> f64 {
    let scale = truth.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    if found.len() != truth.len() || truth.is_empty() {
        return f64::INFINITY;
    }
    let worst = found
        .iter()
        .zip(truth)
        .map(|(found, truth)| (found - truth).abs())
        .fold(0.0, |worst: f64, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) });
    worst / scale
}

/// The same in the root mean square.
fn root_mean_square(found: &[f64], truth: &[f64]) -> f64 {
    let scale = truth.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    if found.len() != truth.len() || truth.is_empty() {
        return f64::INFINITY;
    }
    let squares: f64 = found.iter().zip(truth).map(|(found, truth)| (found - truth) * (found - truth)).sum();
    (squares / truth.len() as f64).sqrt() / scale
}

/// The thesis's scheme with so many annuli a process zone, the step of time with them.
pub(in crate::studies) fn annuli(elements_per_zone: usize, keep_factors: bool) -> Result<(Vec<f64>, AnnulusPath), Refusal> {
    // Thirty-six steps of time an annulus of the zone: two seconds are a whole number of steps.
    let steps = f64::from(INSTANTS) * 4.0 * elements_per_zone as f64;
    let scheme = AnnulusScheme {
        sphere_radius: 1.0,
        relaxed_modulus: 1.0,
        glassy_modulus: 10.0,
        retardation_time: 10.0,
        work_of_adhesion: WORK,
        process_zone: ZONE,
        elements_per_zone,
        time_step: END / steps * (1.0 + 1e-12),
        keep_factors,
    };
    let path = scheme.run(AnnulusStart::Relaxed, &[(0.0, START), (END, START - SPEED * END)])?;
    let spacing = END / f64::from(INSTANTS);
    let at = |instant: u32| {
        let time = f64::from(instant) * spacing;
        path.points.iter().find(|point| (point.time - time).abs() < 1e-9 * END).map(|point| point.force)
    };
    Ok(((1..=INSTANTS).filter_map(at).collect(), path))
}

/// The largest distance of forces from the stored annuli over its scale, and how far those are sure.
pub(in crate::studies) fn against_stored(forces: &[f64]) -> Option<[f64; 2]> {
    let all = rows(SPHERE_ANNULI);
    let mut worst: Option<[f64; 2]> = None;
    for row in all.iter().filter(|row| row.text("case") == "closed, retraction" && row.text("quantity") == "force") {
        let instant = (row.number("time") / 2.0).round() as usize;
        let Some(force) = instant.checked_sub(1).and_then(|place| forces.get(place)) else { continue };
        let error = (force - row.number("value")).abs() / row.number("scale");
        let [most, sure] = worst.unwrap_or([0.0; 2]);
        worst = Some([most.max(error), sure.max(row.number("change"))]);
    }
    worst
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("convergence_sphere", "Convergence: the integration of a sphere");
    progress.expect(1);
    section.say(
        "A sphere is retracted from a relaxed contact past its largest tension (thesis Fig 4.5: γ̃ = 1.6·10⁻⁴, δ̃ = 0.013, β = 10, V = 2·10⁻³). This program chooses its \
         steps by a tolerance, so the fineness is the number of steps that came out. The thesis's annuli have the edge on nodes. The truth is the integration at 10⁻⁹ \
         with its own error far below, confirmed by the stored, extrapolated annuli of another program.",
    );
    match computed(effort) {
        Ok((panel, checks)) => {
            panel.into_section(&mut section);
            section.checks.extend(checks);
        }
        Err(refusal) => {
            section.checks.push(Check::new("the integration of a sphere", "every integration ends", refusal.to_string(), false))
        }
    }
    progress.advance(1);
    section
}

/// The truth of both studies: forces of the integration at its tightest.
pub(in crate::studies) fn truth() -> Result<Vec<f64>, Refusal> {
    Ok(forces(&integrate(&solid()?, &retraction(1e-9), 1e-9)?))
}

fn computed(effort: Effort) -> Result<(Panel, Vec<Check>), Refusal> {
    let (material, truth) = (solid()?, truth()?);
    let half_decades: u32 = effort.choose(10, 12);
    let truths: Vec<Vec<f64>> = PULLED
        .par_iter()
        .map(|&(speed, duration)| Ok(forces(&integrate(&material, &pulled(speed, duration, 1e-9), 1e-9)?)))
        .collect::<Result<_, Refusal>>()?;
    let ours: Vec<(f64, f64)> = (0..=half_decades)
        .into_par_iter()
        .map(|step| {
            let tolerance = LOOSEST * 10f64.powf(-0.5 * f64::from(step));
            let (mut steps, mut errors) = (0.0, 0.0);
            for ((speed, duration), truth) in PULLED.iter().zip(&truths) {
                let trace = integrate(&material, &pulled(*speed, *duration, tolerance), tolerance)?;
                steps += (trace.work.steps as f64).ln();
                errors += root_mean_square(&forces(&trace), truth).max(1e-18).ln();
            }
            let count = PULLED.len() as f64;
            Ok(((steps / count).exp(), (errors / count).exp()))
        })
        .collect::<Result<_, Refusal>>()?;
    let meshes = effort.choose(vec![2, 4, 8, 16], vec![2, 4, 8, 16, 32]);
    let theirs: Vec<(f64, f64)> = meshes
        .par_iter()
        .map(|&elements| Ok((elements as f64, error(&annuli(elements, true)?.0, &truth))))
        .collect::<Result<_, Refusal>>()?;
    let curves = vec![
        (
            Convergence {
                name: "this program, steps".into(),
                points: ours,
                // Errors go with the tolerance, and the truth is an integration at 1e-9.
                floor: 1e-12,
                fitted: 20,
                expected: Expectation::Order {
                    order: 6.0,
                    least: 5.0,
                    most: 7.5,
                    reason: "the path goes along the polynomial through the last points, up to the sixth order, and of less where it starts anew; steps follow a \
                             tolerance and not a halving, so single points scatter and all above the floor are fitted",
                },
            },
            true,
        ),
        (
            Convergence {
                name: "dense annuli, annuli a zone".into(),
                points: theirs,
                floor: 1e-6,
                fitted: FINEST,
                expected: Expectation::Order {
                    order: 1.0,
                    least: 0.6,
                    most: 1.7,
                    reason: "backward Euler in time and an edge whose memory sits on nodes: first order with a scatter of a fraction of an annulus",
                },
            },
            false,
        ),
    ];
    let panel = Panel {
        identifier: "steps",
        caption: "Error of the force at nine instants, over the largest force: of this program against its steps (root mean square, geometric mean over seven speeds), \
                  of the annuli against annuli of a process zone (largest, V = 2·10⁻³).",
        fineness: ("steps or annuli", "steps of the integration, annuli of a zone"),
        error: r"error of $F/F_{\mathrm{max}}$",
        curves,
        headline: false,
    };
    let (found, passed) = match against_stored(&truth) {
        Some([error, sure]) => (format!("{error:.1e}; they are sure to {sure:.1e}"), error <= 3.0 * sure),
        None => ("no stored value".to_owned(), false),
    };
    let check =
        Check::new("the truth against stored annuli of another program", "within three times what those are sure to", found, passed);
    Ok((panel, vec![check]))
}
