//! A sphere whose contact radius a(t) is chosen: Δ(t) by the integration driven by the edge; a(t) again by the integration driven in time and by dense annuli.

use crate::rivals::annulus_indentation::{AnnulusScheme, AnnulusStart};
use crate::studies::convergence::sphere::{WORK, ZONE, solid};
use crate::studies::order::{Convergence, Expectation, FINEST};
use crate::studies::section::{Cell, Check, Column, Effort, Section, Table};
use rayon::prelude::*;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, integrate};
use viscotack::refusal::Refusal;

/// a goes from the first to the last radius in this time (s), straight.
const FIRST: f64 = 0.24;
const LAST: f64 = 0.18;
const DURATION: f64 = 12.0;
/// Radii are compared so often.
const INSTANTS: u32 = 8;

fn chosen(time: f64) -> f64 {
    FIRST + (LAST - FIRST) * time / DURATION
}

fn problem(history: History, instants: u32) -> IndentationProblem {
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history).relaxed();
    IndentationProblem { instants_per_segment: instants, ..problem }
}

/// (t, Δ) that the chosen radius needs, at equally spaced times, the start first.
fn depths(count: u32) -> Result<Vec<(f64, f64)>, Refusal> {
    let trace = integrate(&solid()?, &problem(History::contact_radius(FIRST).ramp(LAST, DURATION), count), 1e-8)?;
    Ok(trace.kept.iter().filter_map(|kept| trace.path.get(*kept)).map(|point| (point.time, point.penetration)).collect())
}

/// The largest error of the radius over the first one when Δ is straight between so many points.
fn in_time(depths: &[(f64, f64)]) -> Result<f64, Refusal> {
    let Some((_, start)) = depths.first() else { return Ok(f64::INFINITY) };
    let mut history = History::penetration(*start);
    for pair in depths.windows(2) {
        if let [before, after] = pair {
            history = history.ramp(after.1, after.0 - before.0);
        }
    }
    let trace = integrate(&solid()?, &problem(history, 1), 1e-8)?;
    let points = trace.kept.iter().filter_map(|kept| trace.path.get(*kept));
    Ok(points.map(|point| (point.contact_radius - chosen(point.time)).abs() / FIRST).fold(0.0, f64::max))
}

/// The same by dense annuli.
fn by_annuli(depths: &[(f64, f64)], elements_per_zone: usize) -> Result<f64, Refusal> {
    let scheme = AnnulusScheme {
        sphere_radius: 1.0,
        relaxed_modulus: 1.0,
        glassy_modulus: 10.0,
        retardation_time: 10.0,
        work_of_adhesion: WORK,
        process_zone: ZONE,
        elements_per_zone,
        time_step: DURATION / (32.0 * elements_per_zone as f64) * (1.0 + 1e-12),
        keep_factors: true,
    };
    let path = scheme.run(AnnulusStart::Relaxed, depths)?;
    let step = DURATION / f64::from(INSTANTS);
    let mut worst = 0.0_f64;
    for instant in 1..=INSTANTS {
        let time = f64::from(instant) * step;
        let found = path.points.iter().find(|point| (point.time - time).abs() < 1e-9 * DURATION);
        worst = worst.max(found.map_or(f64::INFINITY, |point| (point.contact_radius - chosen(time)).abs() / FIRST));
    }
    Ok(worst)
}

pub(super) fn cases(effort: Effort, section: &mut Section) -> Result<(), Refusal> {
    let tables = effort.choose(vec![8_u32, 16, 32, 64], vec![8, 16, 32, 64, 128]);
    let meshes = effort.choose(vec![2_usize, 4, 8, 16], vec![2, 4, 8, 16, 32]);
    let finest = depths(tables.last().copied().unwrap_or(8))?;
    let thinned = |count: u32| -> Vec<(f64, f64)> { finest.iter().copied().step_by((finest.len() - 1) / count as usize).collect() };
    let ours: Vec<(f64, f64)> =
        tables.par_iter().map(|&count| Ok((f64::from(count), in_time(&thinned(count))?))).collect::<Result<_, Refusal>>()?;
    let theirs: Vec<(f64, f64)> =
        meshes.par_iter().map(|&elements| Ok((elements as f64, by_annuli(&finest, elements)?))).collect::<Result<_, Refusal>>()?;
    let columns = vec![
        Column::words("driven by Δ(t)"),
        Column::new("points of Δ, or annuli of a zone", "1"),
        Column::new("largest error of a", "first a"),
    ];
    let mut table = Table::new("sphere", "The radius that is found again under the penetration that it needs.", columns);
    for (name, points) in [("this program, in time", &ours), ("dense annuli", &theirs)] {
        for (fineness, error) in points {
            table.rows.push(vec![Cell::Word(name.to_owned()), Cell::Number(Some(*fineness)), Cell::Number(Some(*error))]);
        }
    }
    section.tables.push(table);
    let last = |points: &[(f64, f64)]| points.last().map_or(f64::INFINITY, |point| point.1);
    let own = last(&ours);
    let second = Expectation::Order { order: 2.0, least: 1.6, most: 3.0, reason: "Δ is straight between the points of its table" };
    section.checks.push(
        Convergence { name: "chosen radius, integration in time".into(), points: ours, floor: 1e-8, fitted: FINEST, expected: second }
            .check(),
    );
    let widths: Vec<f64> = theirs.iter().map(|(elements, error)| error * FIRST * elements / ZONE).collect();
    section.checks.push(Check::new(
        "a chosen radius is found again by dense annuli",
        "within one annulus on every mesh: the edge of their memory sits on nodes, which is a scatter of a fraction of an annulus, not an order",
        format!("off by {} annuli", widths.iter().map(|width| format!("{width:.2}")).collect::<Vec<_>>().join(", ")),
        widths.iter().all(|width| *width < 1.0),
    ));
    section.checks.push(Check::new(
        "a chosen radius is found again by the integration in time",
        "within 1e-4 of itself with the finest table: what straight segments of Δ leave",
        format!("{own:.1e}"),
        own <= 1e-4,
    ));
    Ok(())
}
