//! One solved state: values with errors, how it ended, the certificate, the work.

use crate::estimate::Estimate;
use serde::{Deserialize, Serialize};

/// A column of a table: what its numbers are.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Column {
    /// Name in tables, lower case with underscores.
    pub name: &'static str,
    /// Unit, `1` for pure numbers.
    pub unit: String,
    /// One sentence.
    pub meaning: &'static str,
}

/// How a state ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Solved within the wanted accuracy.
    Solved,
    /// Solved; at least one error bound is above the wanted accuracy. The values are given and flagged.
    Inaccurate,
    /// The equations have no such state; the reason names the limit.
    NoSuchState,
    /// The quantity does not exist for this material or model.
    Undefined,
    /// The swept value contradicts the rest of the scene.
    Invalid,
    /// An iteration did not converge: a defect to report.
    NotConverged,
}

impl Status {
    /// Whether the row holds values.
    #[must_use]
    pub const fn has_values(self) -> bool {
        matches!(self, Self::Solved | Self::Inaccurate)
    }

    /// The word in tables.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Inaccurate => "inaccurate",
            Self::NoSuchState => "no_such_state",
            Self::Undefined => "undefined",
            Self::Invalid => "invalid",
            Self::NotConverged => "not_converged",
        }
    }
}

/// Work counters: what was evaluated, never how long it took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Work {
    /// Evaluations of the energy balance at an edge.
    pub closure_evaluations: u64,
    /// Kernel evaluations inside them: relaxation or creep terms times means.
    pub kernel_evaluations: u64,
    /// Points at which a field was evaluated.
    pub field_evaluations: u64,
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.closure_evaluations += other.closure_evaluations;
        self.kernel_evaluations += other.kernel_evaluations;
        self.field_evaluations += other.field_evaluations;
    }
}

/// The evidence that a row is what it says.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Relative residual of the equation solved.
    pub residual: f64,
    /// |d ln(output)/d ln(input)| of the solution: how strongly it feels its input.
    pub condition: f64,
    /// Whether the state was checked to be one that can exist (signs, limits).
    pub admissible: bool,
}

/// A field at one distance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FieldPoint {
    /// Distance from the edge.
    pub distance: f64,
    /// Displacement of one face outside the bonded side.
    pub displacement: Estimate,
    /// Stress inside the bonded side, tension positive.
    pub stress: Estimate,
}

/// The limit that a state which does not exist would have passed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// What the limit is one of.
    pub name: String,
    /// Its value, in the units of the scene.
    pub value: f64,
}

/// One solved state of one theory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Number of the state in the sweep, from 0.
    pub state: usize,
    /// Values of the swept numbers, in the order of the sweeps.
    pub swept: Vec<f64>,
    /// What distinguishes rows of one state: the theory.
    pub theory: String,
    /// How it ended.
    pub status: Status,
    /// Why, for everything but [`Status::Solved`].
    pub reason: Option<String>,
    /// For [`Status::NoSuchState`]: the limit that was passed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<Witness>,
    /// Values in the order of the columns; none where a quantity does not exist.
    pub values: Vec<Option<Estimate>>,
    /// The evidence, for rows with values.
    pub certificate: Option<Certificate>,
    /// What it took.
    pub work: Work,
    /// The numbers that the validity of the model is judged by, in the order of the plan's assumptions; none where one does not apply.
    pub assumptions: Vec<Option<f64>>,
    /// Fields, if asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fields: Vec<FieldPoint>,
}
