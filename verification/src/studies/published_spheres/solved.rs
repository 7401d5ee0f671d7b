//! A published row solved by the law of finite range, and by the theory of an edge.

use super::published::Published;
use std::f64::consts::PI;
use viscotack::finite_range::sphere::{Accuracy, Mesher, run};
use viscotack::indentation::{self, Adhesion, EdgeLaw, History, IndentationProblem, Profile};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;

/// Tolerances of both runs.
const TOLERANCES: [f64; 2] = [3e-5, 3e-6];
/// Where the pull ends, in ranges: −(first + second·μ); if the tension is still rising there, twice as far, up to so many times.
const FIRST: f64 = 6.0;
const BY_TABOR: f64 = 4.0;
const LONGER: usize = 4;
/// Of the edge: range over radius (a half-space is all that counts), accuracy.
const RANGE: f64 = 1e-3;
const EDGE_ACCURACY: f64 = 1e-3;
/// Peak of the law over Δγ/r.
const PEAK: f64 = 1.026_400_5;

/// What came out.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    /// Largest tension over 1.5πRΔγ.
    pub(super) ratio: f64,
    /// The change between both runs.
    pub(super) error: f64,
    /// What the energy balance leaves, over the largest energy.
    pub(super) defect: f64,
    pub(super) nodes: usize,
    pub(super) steps: usize,
    /// The ratio by the theory of an edge; none where it was not asked, or where it has no contact.
    pub(super) edge: [Option<f64>; ZONES.len()],
}

/// Process zones of the edge: constant, and growing with the pull.
pub(super) const ZONES: [(&str, bool); 2] = [("constant zone", false), ("growing zone", true)];

/// Solves a row.
pub(super) fn solved(row: &Published, with_edge: bool) -> Result<Solved, String> {
    let mut to = -(FIRST + BY_TABOR * row.tabor);
    let mut mesher = Mesher::new(Accuracy::new(TOLERANCES[1]).order);
    for _ in 0..LONGER {
        let problem = row.problem(to);
        let [loose, tight] = TOLERANCES.map(|tolerance| run(&problem, Accuracy::new(tolerance), &mut mesher));
        let (loose, tight) = (loose.map_err(|refusal| refusal.to_string())?, tight.map_err(|refusal| refusal.to_string())?);
        let rising = tight.legs.last().is_none_or(|leg| leg.largest_tension.time >= leg.end.time);
        if rising {
            to *= 2.0;
            continue;
        }
        let unit = 1.5 * PI;
        let certificate = tight.certificate;
        return Ok(Solved {
            ratio: tight.pull_off_force() / unit,
            error: (tight.pull_off_force() - loose.pull_off_force()).abs() / unit,
            defect: certificate.energy_residual / certificate.energy_scale,
            nodes: certificate.nodes,
            steps: certificate.steps,
            edge: ZONES.map(|(_, growing)| if with_edge { edge(row, to, growing).ok().flatten() } else { None }),
        });
    }
    Err("the tension rises to the end of every pull".into())
}

/// The same by an edge with the process zone (π²/4)a₀ of the law's peak, constant or times G/Δγ: R = E0* = 1.
fn edge(row: &Published, to: f64, growing: bool) -> Result<Option<f64>, Refusal> {
    let creep = row.creep();
    let gained = 1.0 - 1.0 / creep.stiffening;
    let terms: Vec<CreepTerm> = creep
        .fractions
        .iter()
        .zip(&creep.times)
        .map(|(fraction, &retardation_time)| CreepTerm { compliance: gained * fraction, retardation_time })
        .collect();
    let material = PlaneMaterial::from_creep(creep.stiffening, &terms, None)?;
    let work = (row.tabor * RANGE).powf(1.5);
    let stress = PEAK * work / RANGE;
    let adhesion = Adhesion { work_of_adhesion: work, process_zone: 0.25 * PI * work / (stress * stress) };
    let history = History::penetration(row.preload * RANGE).ramp(to * RANGE, (row.preload - to) / row.rate);
    let problem = IndentationProblem {
        accuracy: EDGE_ACCURACY,
        edge_law: EdgeLaw { growing_zone: growing, ..EdgeLaw::CONSTANT },
        ..IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history).relaxed()
    };
    let solution = indentation::run(&material, &problem)?;
    Ok(solution.pull_off_force().map(|tension| tension.value / (1.5 * PI * work)))
}
