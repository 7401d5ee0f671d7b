//! A random line, and its state against finer grids and another start.

use super::scene::drawn;
use serde::{Deserialize, Serialize};
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
/// Where full contact is reported a partial one is looked for at so many mean gaps, the first of which is this part of the half height.
const GAPS: u32 = 16;
const FARTHEST: f64 = 1.2;
/// Two states are one where their mean gaps and pressures differ by less.
const SAME: f64 = 1e-2;
/// A bound is compared with its error where the truth is known to this part of it.
const KNOWN: f64 = 0.2;

const NAMES: [&str; 7] =
    ["mean pressure", "mean gap", "friction stress", "contact fraction", "adhesive pressure", "repulsive pressure", "interface energy"];

/// What a scene came to.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Compared {
    /// Numbers that were compared.
    pub values: usize,
    /// Those that differ by more than their bounds, in words.
    pub outside: Vec<String>,
    /// Bounds over errors where these are known.
    pub ratios: Vec<f64>,
    /// Why there is no state.
    pub refused: Option<String>,
    /// Whether the state is full contact.
    pub full_contact: bool,
    /// A partial contact at the same input, where full contact was reported.
    pub missed: Option<String>,
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
    // Full contact has a closed form, which other tests compare; whether it is the only state is another question.
    if state.reached_by == ReachedBy::FullContact {
        compared.full_contact = true;
        compared.missed = partial_contact(&problem, &request).map(|partial| {
            format!(
                "scene {number}: full contact, but also a contact of the part {:.3} at {:?}",
                partial.numbers.contact_fraction, problem.control
            )
        });
        return compared;
    }
    let finest = Request { accuracy: NEVER, most_nodes: FINER * state.fields.nx, ..request };
    // On a coarse grid between them the state may have ceased to exist: the start from nothing goes on to finer grids then.
    let followed = follow(&problem, &state, &finest).ok().filter(|fine| is_one_state(&state, fine));
    if let Some(fine) = followed.or_else(|| solve(&problem, &finest).ok())
        && fine.fields.nx > state.fields.nx
    {
        compared.add(&format!("scene {number}, finer grids"), &state, &fine, true);
    }
    if let Some(other) = from_beside(&problem, &state, &request) {
        compared.add(&format!("scene {number}, other start"), &state, &other, false);
    }
    compared
}

/// A partial contact under the wanted load, by held mean gaps from far to near: the load rises until it is met.
fn partial_contact(problem: &Problem, request: &Request) -> Option<SteadyState> {
    let under = |state: &SteadyState| match problem.control {
        Control::MeanPressure(wanted) => state.numbers.mean_pressure >= wanted,
        Control::MeanGap(wanted) => state.numbers.mean_gap <= wanted,
        Control::Frame { stiffness, position } => state.numbers.mean_pressure >= stiffness * (state.numbers.mean_gap - position),
    };
    let half_height = problem.profile.half_height();
    let mut last: Option<SteadyState> = None;
    for step in 0..GAPS {
        let gap = half_height * FARTHEST * (1.0 - f64::from(step) / f64::from(GAPS));
        let held = Problem { control: Control::MeanGap(gap), ..problem.clone() };
        let from_last = last.as_ref().and_then(|last| follow(&held, last, request).ok());
        let Some(state) = from_last.or_else(|| solve(&held, request).ok()) else { continue };
        if under(&state) {
            return [Some(state), last].into_iter().flatten().find_map(|near| {
                let found = follow(problem, &near, request).ok()?;
                (found.numbers.contact_fraction < 1.0).then_some(found)
            });
        }
        last = Some(state);
    }
    None
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
    is_one_state(state, &back).then_some(back)
}

fn is_one_state(a: &SteadyState, b: &SteadyState) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * (1.0 + a.abs());
    near(b.numbers.mean_gap, a.numbers.mean_gap) && near(b.numbers.contact_fraction, a.numbers.contact_fraction)
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
