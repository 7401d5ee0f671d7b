//! What is asked of a contact under a given penetration, and what comes back.

use super::chain::Chain;
use super::drive::Drive;
use super::energies::{Energies, TurnedOver};
use crate::indentation::Profile;

/// What is asked.
#[derive(Debug, Clone)]
pub(super) struct Problem {
    pub profile: Profile,
    pub chain: Chain,
    /// Δγ; None without adhesion, where δ is only a length for first steps.
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
}

/// A point of the history.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
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

/// Why a march ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The history is over.
    History,
    /// No stable contact is left: the edge ran away.
    Lost,
    /// The contact is hardly wider than its process zone.
    Floor,
    /// Panels do not converge.
    Failed,
}

/// What a march gives.
#[derive(Debug, Clone, PartialEq)]
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
    /// At the end of every panel and rest, and after jumps, if the problem asks for energies.
    pub accounts: Vec<(Energies, TurnedOver)>,
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
}
