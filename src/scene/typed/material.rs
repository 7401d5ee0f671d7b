//! What a material was made of: given terms, measured data, or a law; and the temperature it is at.

use crate::material::Material;
use crate::material::broad::{BroadLaw, Expansion};
use crate::material::fit::SeriesFit;
use crate::material::fit::consistency::Consistency;
use crate::material::fit::superposition::Superposition;
use crate::material::shift::ShiftFactors;
use std::sync::Arc;

/// What the series of a material was made of.
#[derive(Debug, Clone, PartialEq)]
pub enum MaterialOrigin {
    /// Moduli and terms of the scene.
    Terms,
    /// A series fitted to measured data.
    Data(Arc<FittedData>),
    /// A law expanded into terms.
    Law(Arc<ExpandedLaw>),
}

/// What a table measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeasuredSort {
    /// E′ and E″ against frequency.
    Moduli,
    /// R against time.
    Relaxation,
    /// J against time.
    Creep,
}

/// A row of a material table, in SI units, at its own temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredRow {
    /// Temperature (K), if the table has one.
    pub temperature: Option<f64>,
    /// ω (rad/s) or t (s).
    pub at: f64,
    /// E′, R (Pa) or J (1/Pa).
    pub value: f64,
    /// E″ (Pa), of moduli.
    pub loss: Option<f64>,
}

/// A material table.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialData {
    /// Its file.
    pub file: String,
    /// What it measured.
    pub sort: MeasuredSort,
    /// Its rows, in the order of the file.
    pub rows: Vec<MeasuredRow>,
    /// What is odd about it, a sentence each.
    pub warnings: Vec<String>,
    /// What was chosen in reading it, a sentence each.
    pub notes: Vec<String>,
}

/// A series fitted to a table.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedData {
    /// The table; its frequencies and times shifted to the reference temperature.
    pub data: MaterialData,
    /// The fit.
    pub fit: SeriesFit,
    /// Kramers and Kronig's relations, of moduli.
    pub consistency: Option<Consistency>,
    /// How well curves of neighbouring temperatures lie on each other.
    pub overlap: Option<Overlap>,
    /// Shifts that were found from the data, if the scene asks for them.
    pub superposition: Option<Superposition>,
    /// All that is odd, a sentence each.
    pub warnings: Vec<String>,
}

/// Curves of neighbouring temperatures after their shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Temperatures.
    pub temperatures: usize,
    /// Neighbours whose ranges meet.
    pub meeting: usize,
    /// Largest root-mean-square relative difference of two that meet.
    pub worst: f64,
}

/// A law expanded into terms.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpandedLaw {
    /// The law.
    pub law: BroadLaw,
    /// Its name in sentences.
    pub name: &'static str,
    /// Angular frequencies (rad/s, or reduced) from and to which it was expanded.
    pub range: [f64; 2],
    /// Which of its ends, the lowest and the highest frequency, the scene names.
    pub stated: [bool; 2],
    /// Wanted accuracy.
    pub accuracy: f64,
    /// The expansion.
    pub expansion: Expansion,
}

/// The temperature of a material with shift factors.
#[derive(Debug, Clone, PartialEq)]
pub struct Climate {
    /// The shift factors.
    pub shift: ShiftFactors,
    /// T_ref (K).
    pub reference: f64,
    /// T (K).
    pub temperature: f64,
    /// a_T.
    pub factor: f64,
    /// The series at the reference temperature.
    pub at_reference: Material,
}
