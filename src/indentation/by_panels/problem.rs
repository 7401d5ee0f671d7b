//! What is asked of a contact under a given penetration, and what comes back.

use super::chain::Chain;
use super::drive::Drive;
use super::energies::{Energies, TurnedOver};
use crate::indentation::{Cycle, Event, Profile, Spread, SurfaceFields};
use serde::{Deserialize, Serialize};

/// What is asked.
#[derive(Debug, Clone)]
pub(super) struct Problem {
    pub profile: Profile,
    pub chain: Chain,
    /// Δγ (J/m²); None without adhesion, where δ is only a length for first steps.
    pub adhesion: Option<f64>,
    pub zone: f64,
    pub drive: Drive,
    /// Of the initial contact: bonded long ago (relaxed) or just now.
    pub relaxed: bool,
    pub tolerance: f64,
    pub degree: usize,
    /// Instants wanted.
    pub instants: Vec<f64>,
    /// Whether energies are accounted for.
    pub energies: bool,
    /// Accuracy to which cycles of an oscillation are stationary; None where no cycles are asked for.
    pub cycles: Option<f64>,
    /// Segments known to end early: which, and how long they take (s).
    pub stops: Vec<(usize, f64)>,
    /// Whether the surface at the last instant wanted is.
    pub surface: bool,
}

/// A point of the path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(in crate::indentation) struct Step {
    pub row: Row,
    /// C/Δγ − 1 there, at most.
    pub residual: f64,
    /// Counts the corners and jumps before it.
    pub piece: u32,
    /// dA/dt (m²/s).
    pub area_rate: f64,
    pub account: Option<(Energies, TurnedOver)>,
    /// Whether it is one of the instants wanted.
    pub wanted: bool,
}

/// A point of the history.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// t (s).
    pub time: f64,
    /// Δ (m).
    pub penetration: f64,
    /// a (m).
    pub contact_radius: f64,
    /// F (N), compression positive.
    pub force: f64,
    /// K_I (Pa√m), tension positive.
    pub stress_intensity: f64,
}

/// Why an integration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum End {
    /// The history is over.
    History,
    /// No stable contact is left: the edge ran away.
    Lost,
    /// The contact is hardly wider than its process zone.
    Floor,
    /// Panels do not converge.
    Failed,
    /// The surfaces touch again, but away from the axis, under a given radius, or where no contact wider than a process zone is in equilibrium.
    TouchesAgain,
}

/// What an integration gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// At time zero.
    pub start: Row,
    /// At the end of every panel.
    pub ends: Vec<Row>,
    /// At the instants wanted, while there is contact.
    pub wanted: Vec<Row>,
    /// Of the least force.
    pub least_force: Row,
    /// Where jumps landed.
    pub jumps: Vec<Row>,
    /// Every point of the path, in contact and after it.
    pub(in crate::indentation) path: Vec<Step>,
    pub(in crate::indentation) events: Vec<Event<f64>>,
    /// The surface at the last instant wanted, if the problem asks for it.
    #[serde(skip)]
    pub(in crate::indentation) surface: Option<SurfaceFields>,
    /// Smallest D outside the contact (m).
    pub smallest_gap: f64,
    /// Most segments of the line.
    pub most_segments: usize,
    /// Why it ended.
    pub end: End,
    /// Panels accepted.
    pub panels: u64,
    /// Panels refused.
    pub refused: u64,
    /// Closures evaluated: Newton, checks, frozen slopes and jumps.
    pub closures: u64,
    /// Nodes of the window in all of them.
    pub kernel_nodes: u64,
    /// Whole cycles of segments that oscillate, by how much they differ, and segments that ended early.
    pub cycles: Vec<Cycle<f64>>,
    pub(in crate::indentation) spreads: Vec<Spread>,
    pub(in crate::indentation) shortened: Vec<(usize, f64)>,
}

impl Outcome {
    /// What is stored, lost and turned over at every point of the path, if the problem asks for energies.
    #[must_use]
    pub fn accounts(&self) -> Vec<(Energies, TurnedOver)> {
        self.path.iter().filter_map(|step| step.account).collect()
    }
}
