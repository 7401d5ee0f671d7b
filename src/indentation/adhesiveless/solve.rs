//! A contact without adhesion with errors: a course, judged by a coarser one.

use super::chain::Chain;
use super::course::{Course, Fineness};
use crate::indentation::checkpoint::Watch;
use crate::indentation::fields::SurfaceFields;
use crate::indentation::judgement::judged;
use crate::indentation::panel::Panel;
use crate::indentation::problem::IndentationProblem;
use crate::indentation::solution::{IndentationSolution, IndentationWork, PathPoint, Trace};
use crate::material::Material;
use crate::refusal::Refusal;

/// Series of the finest course, and how much coarser the other is.
const FINEST: f64 = 1e-13;
const COARSER: f64 = 30.0;
/// Series over the accuracy.
const OF_ACCURACY: f64 = 1e-7;

fn fineness(accuracy: f64, level: u32) -> Fineness {
    let coarser = COARSER.powi(1 - level as i32);
    Fineness {
        series: (OF_ACCURACY * accuracy).clamp(FINEST, 1e-10) * coarser,
        steps: (1e-4 * accuracy).clamp(1e-11, 1e-7) * coarser,
        of_cycle: if level == 0 { 28 } else { 40 },
        ledger: if level == 0 { (1.6, 16) } else { (1.35, 24) },
    }
}

/// Solves a history without adhesion to its accuracy.
pub(in crate::indentation) fn solve(
    material: &Material,
    problem: &IndentationProblem,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    let chain = Chain::new(material)?;
    let course = |level: u32, stops: &[(usize, f64)]| -> Result<Trace, Refusal> {
        Course::new(&chain, problem, fineness(problem.accuracy, level)).watched(watch, level + 1).through(stops)
    };
    let coarse = course(0, &[])?;
    let stops = coarse.shortened.clone();
    let fine = course(1, &stops)?;
    problem.profile.holds(fine.summary.scales[2], 0.0)?;
    let mut work = IndentationWork::default();
    for trace in [&coarse, &fine] {
        work.add(&trace.work);
    }
    let traces = vec![fine, coarse];
    judged(problem, &traces, 0)
        .map(|verdict| verdict.solution(work))
        .ok_or(Refusal::NotConverged { what: "history of contact", detail: "no course is left".into() })
}

/// Grades of the panels of a surface towards the ends of each stretch of the line, more finely and less.
const GRADES: [i32; 2] = [10, 7];

/// The contact at a time of a history that has been solved, and its surface twice: as it is, and with coarser panels, for the error.
pub(in crate::indentation) fn surface_at(
    material: &Material,
    problem: &IndentationProblem,
    solved: &Trace,
    time: f64,
) -> Result<(PathPoint, [SurfaceFields; 2]), Refusal> {
    let chain = Chain::new(material)?;
    let line = Course::new(&chain, problem, fineness(problem.accuracy, 1)).line_at(time, &solved.shortened)?;
    let (depth, profile) = (line.penetration, &problem.profile);
    let surface = |grades: i32| {
        let graded = |low: f64, high: f64, sample: &dyn Fn(f64) -> f64| {
            let half = 0.5 * (high - low);
            let places = (0..grades).map(|k| half * 0.25_f64.powi(k)).collect::<Vec<f64>>();
            let inner = places.iter().rev().map(|way| low + way).chain(places.iter().skip(1).map(|way| high - way));
            let places: Vec<f64> = [low].into_iter().chain(inner).chain([high]).collect();
            let wide = places.windows(2).filter(|pair| pair[1] > pair[0]);
            wide.map(|pair| Panel::sampled(pair[0], pair[1], sample)).collect::<Vec<Panel>>()
        };
        let (mut load, mut displacement) = (Vec::new(), Vec::new());
        for stretch in &line.contact {
            load.extend(graded(stretch.low, stretch.high, &|s| chain.glassy * line.pressing_at(s)));
            displacement.extend(graded(stretch.low, stretch.high, &|s| depth - profile.line(s)));
        }
        for stretch in &line.free {
            displacement.extend(graded(stretch.low, stretch.high, &|s| depth - profile.line(s) - line.pressing_at(s)));
        }
        SurfaceFields::made_of(line.radius(), load, displacement)
    };
    let point = PathPoint {
        time,
        penetration: depth,
        force: line.force(),
        contact_radius: line.radius(),
        stress_intensity_factor: 0.0,
        unresolved_intensity: 0.0,
        residual: 0.0,
        piece: 0,
        energies: None,
    };
    Ok((point, GRADES.map(surface)))
}
