//! What the rig holds: it decides which equilibria are stable and where the contact is lost.

use serde::{Deserialize, Serialize};

/// What is imposed on the indenter. A rig of finite stiffness lies between the two.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Control {
    /// Dead load: the force or mean pressure is held.
    Load,
    /// Fixed grips: the penetration is held.
    Penetration,
}

/// Which of two equilibria at the same load, or at the same penetration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EquilibriumBranch {
    /// The larger contact, stable under the control that is given.
    Stable,
    /// The smaller contact: an energy barrier, never at rest under that control.
    Unstable,
}
