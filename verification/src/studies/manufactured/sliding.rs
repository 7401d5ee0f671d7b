//! Sliding contacts whose edges, eccentricity and penetration are chosen; the works of adhesion come from the collocation.

use crate::rivals::sliding_collocation::richardson::extrapolated;
use crate::rivals::sliding_collocation::{Layout, SlidingCollocation};
use crate::studies::convergence::sliding::equal_terms;
use crate::studies::section::{Cell, Check, Column, Effort, Section, Table};
use rayon::prelude::*;
use std::f64::consts::PI;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::steady::{
    Indenter, SlidingControl, SlidingOutcome, SlidingProblem, Start, WaveAdhesion, steady_sliding, steady_sliding_near,
};

/// What is chosen: β, ζ_j, a, e, Δ, δ.
struct Chosen {
    beta: f64,
    ratios: &'static [f64],
    half_width: f64,
    eccentricity: f64,
    penetration: f64,
    zone: f64,
}

const CASES: [Chosen; 8] = [
    Chosen { beta: 10.0, ratios: &[0.6], half_width: 1.0, eccentricity: 0.05, penetration: 0.55, zone: 0.01 },
    Chosen { beta: 10.0, ratios: &[0.1], half_width: 1.3, eccentricity: -0.3, penetration: 0.6, zone: 0.01 },
    Chosen { beta: 5.0, ratios: &[3.0], half_width: 0.8, eccentricity: 0.02, penetration: 0.3, zone: 0.005 },
    Chosen { beta: 20.0, ratios: &[3.0, 0.3], half_width: 0.9, eccentricity: -0.06, penetration: 0.4, zone: 0.004 },
    Chosen { beta: 10.0, ratios: &[30.0], half_width: 0.6, eccentricity: 0.01, penetration: 0.12, zone: 0.01 },
    Chosen { beta: 10.0, ratios: &[0.6], half_width: 2.0, eccentricity: -0.1, penetration: 0.9, zone: 0.01 },
    Chosen { beta: 50.0, ratios: &[0.02, 3.0], half_width: 1.0, eccentricity: -0.25, penetration: 0.35, zone: 0.01 },
    Chosen { beta: 100.0, ratios: &[0.03, 0.3, 3.0, 30.0], half_width: 0.5, eccentricity: -0.1, penetration: 0.1, zone: 0.005 },
];

/// Orders of the aligned collocation in its integrals, in turn: 3 with a logarithm, then 4.
const ORDERS: [f64; 3] = [3.0, 3.0, 4.0];
/// Edges within this: the extrapolated works are sure to some 1e-6 of themselves, and edges follow works about as strongly.
const TOLERANCE: f64 = 1e-5;

struct Found {
    works: [f64; 2],
    near: [f64; 2],
    cold: Option<[f64; 2]>,
}

fn one(chosen: &Chosen, meshes: &[usize]) -> Result<Found, Refusal> {
    let material = equal_terms(chosen.beta, chosen.ratios)?;
    let memory = ContactMemory::new(&material, 1.0)?;
    let contact = WaveContact { half_width: chosen.half_width, eccentricity: chosen.eccentricity };
    // The collocation asks for an adhesion only for the lengths of its zones.
    let lengths = WaveAdhesion::even(1.0, chosen.zone);
    let levels = meshes
        .iter()
        .map(|&elements| {
            let scheme = SlidingCollocation::new(memory.kernel(), Layout::WindowAligned { window_elements: elements / 3 }, elements, 2.0)?;
            let found = scheme.closures(&lengths, Prescribed::Penetration(chosen.penetration), contact)?;
            Ok([found.trailing_work, found.leading_work])
        })
        .collect::<Result<Vec<[f64; 2]>, Refusal>>()?;
    let works = [0, 1].map(|edge| extrapolated(&levels.iter().map(|level| level[edge]).collect::<Vec<_>>(), &ORDERS) / (2.0 * PI));
    let adhesion = WaveAdhesion { leading_work: works[1], ..WaveAdhesion::even(works[0], chosen.zone) };
    let problem = SlidingProblem {
        rate: 1.0,
        indenter: Indenter::Wave,
        adhesion: Some(adhesion),
        work_by_speed: None,
        control: SlidingControl::Penetration(chosen.penetration),
        accuracy: 1e-9,
    };
    let near = steady_sliding_near(&material, &problem, &Start::at(1.03 * chosen.half_width, chosen.eccentricity - 0.02))?;
    let cold = match steady_sliding(&material, &problem) {
        Ok(SlidingOutcome::Partial(contact)) => Some([contact.values.half_width.value, contact.values.eccentricity.value]),
        _ => None,
    };
    Ok(Found { works, near: [near.values.half_width.value, near.values.eccentricity.value], cold })
}

pub(super) fn cases(effort: Effort, section: &mut Section) -> Result<(), Refusal> {
    let meshes = effort.choose(vec![50, 100, 200], vec![100, 200, 400, 800]);
    let found: Vec<Result<Found, Refusal>> = CASES.par_iter().map(|chosen| one(chosen, &meshes)).collect();
    let columns =
        ["β", "terms", "a chosen", "e chosen", "Δ chosen", "Γ₁ needed", "Γ₂ needed", "error of a", "error of e", "error of a, no start"];
    let mut table = Table::new(
        "sliding",
        "Chosen edges, the works that the collocation says they need, and how far from them the solver stands: from a start nearby, and from none at all.",
        columns.map(|name| Column::new(name, "1")).to_vec(),
    );
    let (mut worst, mut failed, mut unlike) = (0.0_f64, Vec::new(), 0);
    for (index, (chosen, found)) in CASES.iter().zip(found).enumerate() {
        let given = [chosen.beta, chosen.ratios.len() as f64, chosen.half_width, chosen.eccentricity, chosen.penetration];
        let mut row: Vec<Cell> = given.iter().map(|number| Cell::Number(Some(*number))).collect();
        match found {
            Ok(found) => {
                let errors = [found.near[0] - chosen.half_width, found.near[1] - chosen.eccentricity].map(f64::abs);
                let cold = found.cold.map(|[half_width, _]| (half_width - chosen.half_width).abs());
                worst = errors.iter().fold(worst, |worst, error| if error.is_nan() { f64::INFINITY } else { worst.max(*error) });
                unlike += usize::from(cold.is_none_or(|error| error > TOLERANCE));
                row.extend(found.works.into_iter().chain(errors).map(|number| Cell::Number(Some(number))));
                row.push(Cell::Number(cold));
            }
            Err(refusal) => {
                failed.push(format!("case {}: {refusal}", index + 1));
                row.extend((0..5).map(|_| Cell::Number(None)));
            }
        }
        table.rows.push(row);
    }
    section.tables.push(table);
    let expected = format!("edges within {TOLERANCE:.0e}: the extrapolated works are sure to some 1e-6 of themselves");
    let found = if failed.is_empty() { format!("{worst:.1e} at worst of {} cases", CASES.len()) } else { failed.join("; ") };
    section.checks.push(Check::new(
        "chosen edges of a sliding contact are found again",
        expected,
        found,
        failed.is_empty() && worst <= TOLERANCE,
    ));
    section.checks.push(Check::statement(
        "without a start the same contact is found",
        "at one penetration there may be others; the program takes the one that grows out of the slow or fast contact",
        format!("{} of {}", CASES.len() - unlike, CASES.len()),
        unlike == 0,
    ));
    Ok(())
}
