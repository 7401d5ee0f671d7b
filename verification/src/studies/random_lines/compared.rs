//! A random line, and its state against finer grids and another start.

use super::scene::drawn;
use std::time::Instant;
use viscotack::finite_range::line::{Control, Numbers, Problem, ReachedBy, Request, SteadyState, follow, solve};

/// The truth has so many nodes for one of the state.
const FINER: usize = 8;
/// An accuracy that no grid meets.
const NEVER: f64 = 1e-14;
/// The neighbour that the other start is at: its load differs by this much.
const BESIDE: f64 = 2e-3;
/// A difference that rounding leaves, and a bound below which nothing is learnt of it.
const ROUNDING: f64 = 1e-11;
/// Two states are one where their mean gaps and pressures differ by less.
const SAME: f64 = 1e-2;
/// A bound is compared with its error where the truth is known to this part of it.
const KNOWN: f64 = 0.2;

const NAMES: [&str; 7] =
    ["mean pressure", "mean gap", "friction stress", "contact fraction", "adhesive pressure", "repulsive pressure", "interface energy"];

/// What a scene came to.
#[derive(Debug, Clone, Default)]
pub struct Compared {
    /// Numbers that were compared.
    pub values: usize,
    /// Those that differ by more than their bounds, in words.
    pub outside: Vec<String>,
    /// Bounds over errors where these are known.
    pub ratios: Vec<f64>,
    /// Why there is no state.
    pub refused: Option<String>,
    /// The friction by the surface less that by the loss, over the largest stress.
    pub identities: f64,
    /// Time of the state itself.
    pub seconds: f64,
}

const fn list(n: &Numbers) -> [f64; 7] {
    [n.mean_pressure, n.mean_gap, n.friction_stress, n.contact_fraction, n.adhesive_pressure, n.repulsive_pressure, n.interface_energy]
}

/// Draws a scene, solves it and compares.
#[must_use]
pub fn compared(seed: u64, number: u64, nodes: usize) -> Compared {
    let mut compared = Compared::default();
    let (problem, accuracy) = match drawn(seed, number) {
        Ok(drawn) => drawn,
        Err(refusal) => return Compared { refused: Some(refusal.to_string()), ..compared },
    };
    let request = Request { accuracy, least_nodes: 512, most_nodes: nodes };
    let begun = Instant::now();
    let solved = solve(&problem, &request);
    compared.seconds = begun.elapsed().as_secs_f64();
    let state = match solved {
        Ok(state) => state,
        Err(refusal) => return Compared { refused: Some(format!("scene {number}: {refusal}")), ..compared },
    };
    let stress = state.numbers.repulsive_pressure.max(-state.numbers.adhesive_pressure).max(1e-3);
    compared.identities = (state.certificate.friction_by_surface - state.certificate.friction_by_loss).abs() / stress;
    // Full contact has a closed form, which other tests compare.
    if state.reached_by == ReachedBy::FullContact {
        return compared;
    }
    let finest = Request { accuracy: NEVER, most_nodes: FINER * state.fields.nx, ..request };
    if let Ok(fine) = follow(&problem, &state, &finest)
        && fine.fields.nx > state.fields.nx
    {
        compared.add(&format!("scene {number}, finer grids"), &state, &fine, true);
    }
    if let Some(other) = from_beside(&problem, &state, &request) {
        compared.add(&format!("scene {number}, other start"), &state, &other, false);
    }
    compared
}

/// The same state from a neighbouring load; none where it lies on another branch.
fn from_beside(problem: &Problem, state: &SteadyState, request: &Request) -> Option<SteadyState> {
    let beside = match problem.control {
        Control::MeanPressure(pressure) => Control::MeanPressure(pressure + BESIDE),
        Control::MeanGap(gap) => Control::MeanGap(gap - BESIDE),
        Control::Frame { stiffness, position } => Control::Frame { stiffness, position: position - BESIDE },
    };
    let neighbour = follow(&Problem { control: beside, ..problem.clone() }, state, request).ok()?;
    let back = follow(problem, &neighbour, request).ok()?;
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * (1.0 + a.abs());
    let same = near(back.numbers.mean_gap, state.numbers.mean_gap) && near(back.numbers.contact_fraction, state.numbers.contact_fraction);
    same.then_some(back)
}

impl Compared {
    fn add(&mut self, what: &str, state: &SteadyState, other: &SteadyState, is_truth: bool) {
        let (values, truths) = (list(&state.numbers), list(&other.numbers));
        let (bounds, unknown) = (list(&state.errors), list(&other.errors));
        for i in 0..NAMES.len() {
            let off = (values[i] - truths[i]).abs();
            self.values += 1;
            if off > bounds[i] + unknown[i] + ROUNDING {
                self.outside
                    .push(format!("{what}: {} {:e} ± {:.1e}, {:e} ± {:.1e}", NAMES[i], values[i], bounds[i], truths[i], unknown[i]));
            }
            if is_truth && bounds[i] > ROUNDING && unknown[i] < KNOWN * bounds[i] && off > 0.0 {
                self.ratios.push(bounds[i] / off.max(unknown[i]));
            }
        }
    }
}
