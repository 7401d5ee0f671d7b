//! One solved state: values with errors, how it ended, the certificate, the work.

use super::material_uncertainty::MaterialUncertainty;
use serde::{Deserialize, Serialize};
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;

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
    /// A state was found that cannot exist (it overlaps, or is pressed where it must pull): a defect to report; the witness says by how much.
    Inadmissible,
}

impl Status {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 7] =
        [Self::Solved, Self::Inaccurate, Self::NoSuchState, Self::Undefined, Self::Invalid, Self::NotConverged, Self::Inadmissible];

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
            Self::Inadmissible => "inadmissible",
        }
    }
}

/// Work counters: what was evaluated, never how long it took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Work {
    /// Evaluations of the energy balance at an edge.
    pub closure_evaluations: u64,
    /// Kernel evaluations inside them: relaxation or creep terms times means; of an indenter, points of the line whose memory was carried on.
    pub kernel_evaluations: u64,
    /// Small linear systems: contacts with given edges.
    pub linear_solves: u64,
    /// Points at which a field was evaluated.
    pub field_evaluations: u64,
}

impl std::fmt::Display for Work {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{} balances, ", self.closure_evaluations)?;
        if self.linear_solves > 0 {
            write!(formatter, "{} linear systems, ", self.linear_solves)?;
        }
        write!(formatter, "{} kernel evaluations, {} field points", self.kernel_evaluations, self.field_evaluations)
    }
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.closure_evaluations += other.closure_evaluations;
        self.kernel_evaluations += other.kernel_evaluations;
        self.linear_solves += other.linear_solves;
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
    /// Whether the state was checked to be one that can exist (signs, limits). A row without it keeps no values, see [`Row::settled`].
    pub admissible: bool,
}

impl std::ops::Mul<u64> for Work {
    type Output = Self;

    /// The work of several states like this one.
    fn mul(self, states: u64) -> Self {
        Self {
            closure_evaluations: self.closure_evaluations * states,
            kernel_evaluations: self.kernel_evaluations * states,
            linear_solves: self.linear_solves * states,
            field_evaluations: self.field_evaluations * states,
        }
    }
}

/// Fields at one place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FieldPoint {
    /// The place: the first of the outcome's field columns.
    pub place: f64,
    /// The fields there, in the order of the further field columns.
    pub values: Vec<Estimate>,
}

/// A limit that was passed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// What the limit is one of.
    pub name: String,
    /// Its value, in the units of the scene.
    pub value: f64,
}

/// One solved state: of a crack by one theory, of a sliding contact with or without adhesion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Number of the state in the sweep, from 0.
    pub state: usize,
    /// Values of the swept numbers, in the order of the sweeps.
    pub swept: Vec<f64>,
    /// Words about it, in the order of the outcome's labels: the first distinguishes the rows of one state. None for [`Status::Invalid`] states.
    pub labels: Vec<String>,
    /// How it ended.
    pub status: Status,
    /// Why, for everything but [`Status::Solved`]; for a full contact, the limit that was passed.
    pub reason: Option<String>,
    /// The limit that was passed, by a state that does not exist or by a full contact; of an inadmissible state, what it violates.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<Witness>,
    /// Values in the order of the columns; none where a quantity does not exist.
    pub values: Vec<Option<Estimate>>,
    /// The evidence, for rows with values.
    pub certificate: Option<Certificate>,
    /// What it took.
    pub work: Work,
    /// The numbers that the validity of the model is assessed by, in the order of the plan's assumptions; none where one does not apply.
    pub assumptions: Vec<Option<f64>>,
    /// Fields, if asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fields: Vec<FieldPoint>,
    /// What the values owe to a material that its data leave open, if asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<MaterialUncertainty>,
}

impl Row {
    /// A row of a state of the sweep before it is solved: no value, no word against it.
    #[must_use]
    pub fn new(state: usize, swept: &[f64], labels: Vec<String>, columns: usize) -> Self {
        Self {
            state,
            swept: swept.to_vec(),
            labels,
            status: Status::Solved,
            reason: None,
            witness: None,
            values: vec![None; columns],
            certificate: None,
            work: Work::default(),
            assumptions: Vec::new(),
            fields: Vec::new(),
            material: None,
        }
    }

    /// Becomes the same as another, in the memory that it has.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        let Self { state, swept, labels, status, reason, witness, values, certificate, work, assumptions, fields, material } = other;
        self.swept.clone_from(swept);
        self.labels.clone_from(labels);
        self.reason.clone_from(reason);
        self.witness.clone_from(witness);
        self.values.clone_from(values);
        self.assumptions.clone_from(assumptions);
        self.fields.clone_from(fields);
        self.material.clone_from(material);
        (self.state, self.status, self.certificate, self.work) = (*state, *status, *certificate, *work);
    }

    /// The spread of a column over draws of the material: one standard uncertainty, if it has one.
    #[must_use]
    pub fn material_deviation(&self, column: usize) -> Option<f64> {
        self.material.as_ref()?.columns.get(column)?.deviation
    }

    /// The label at a place; empty if there is none.
    #[must_use]
    pub fn label(&self, place: usize) -> &str {
        self.labels.get(place).map_or("", String::as_str)
    }

    /// The value of a column, if it has one.
    #[must_use]
    pub fn value(&self, column: usize) -> Option<f64> {
        self.values.get(column).copied().flatten().map(|estimate| estimate.value)
    }

    /// Ends the row by a refusal: its status and reason, no values.
    pub fn refuse(&mut self, refusal: &Refusal) {
        self.status = match refusal {
            Refusal::NoSuchState { .. } => Status::NoSuchState,
            Refusal::Undefined { .. } => Status::Undefined,
            Refusal::OutOfRange { .. } => Status::Invalid,
            Refusal::NotConverged { .. } => Status::NotConverged,
        };
        self.reason = Some(refusal.to_string());
        if let Refusal::NoSuchState { limit_name, limit, .. } = refusal {
            self.witness = Some(Witness { name: (*limit_name).to_owned(), value: *limit });
        }
        self.certificate = None;
        self.emptied();
    }

    /// No value, and nothing that follows from one.
    fn emptied(&mut self) {
        self.values.fill(None);
        self.assumptions.clear();
        self.fields.clear();
    }

    /// The row as it may be shown. A state that cannot exist is never solved: its row ends as [`Status::Inadmissible`], keeps its certificate as evidence, and no value.
    #[must_use]
    pub fn settled(mut self) -> Self {
        if self.status.has_values() && self.certificate.is_some_and(|certificate| !certificate.admissible) {
            self.status = Status::Inadmissible;
            let violated = self.witness.as_ref().map_or_else(String::new, |witness| format!(" ({} = {:e})", witness.name, witness.value));
            self.reason = Some(format!("the state that was found cannot exist{violated}: please report this scene"));
            self.emptied();
        }
        self
    }

    /// Lets a row pass whose every number is finite: infinities and NaNs stand in no table, and JSON has no word for them.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] with the name of the first number that is not.
    pub fn representable(&mut self, columns: &[Column]) -> Result<(), Refusal> {
        for assumption in &mut self.assumptions {
            *assumption = assumption.filter(|value| value.is_finite());
        }
        let finite = |estimate: &Estimate| estimate.value.is_finite() && estimate.error.is_finite();
        let overflow =
            |quantity| Refusal::Undefined { quantity, reason: "the numbers of the scene are so far apart that it overflows".into() };
        if let Some((column, _)) = columns.iter().zip(&self.values).find(|(_, value)| value.as_ref().is_some_and(|value| !finite(value))) {
            return Err(overflow(column.name));
        }
        if self.certificate.is_some_and(|certificate| !(certificate.residual.is_finite() && certificate.condition.is_finite())) {
            return Err(overflow("the certificate"));
        }
        if self.fields.iter().any(|point| !(point.place.is_finite() && point.values.iter().all(finite))) {
            return Err(overflow("a field"));
        }
        Ok(())
    }
}
