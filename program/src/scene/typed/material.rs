//! What a material was made of: given terms, measured data, or a law; and the temperature it is at.

use crate::scene::check::Units;
use std::sync::Arc;
use viscotack::elastic::PlaneState;
use viscotack::material::broad::{BroadLaw, Expansion};
use viscotack::material::fit::consistency::Consistency;
use viscotack::material::fit::superposition::Superposition;
use viscotack::material::fit::{Plateau, SeriesFit};
use viscotack::material::isotropic::IsotropicSolid;
use viscotack::material::shift::ShiftFactors;
use viscotack::material::{Material, PlaneMaterial};
use viscotack::refusal::Refusal;

/// What the series of a material was made of.
#[derive(Debug, Clone, PartialEq)]
pub enum MaterialOrigin {
    /// Moduli and terms of the scene.
    Terms,
    /// A series fitted to measured data.
    Data(Arc<FittedData>),
    /// A law expanded into terms.
    Law(Arc<ExpandedLaw>),
    /// The deck of a finite-element program.
    Deck(Arc<DeckOrigin>),
}

/// The deck of a finite-element program.
#[derive(Debug, Clone, PartialEq)]
pub struct DeckOrigin {
    /// Its file.
    pub file: String,
    /// The program.
    pub program: &'static str,
    /// What the deck calls the material.
    pub name: Option<String>,
    /// What was taken as what, and what was skipped, a sentence each.
    pub notes: Vec<String>,
}

/// A solid by its shear and its bulk series.
#[derive(Debug, Clone, PartialEq)]
pub struct IsotropicSeries {
    /// At the temperature of the scene.
    pub at_temperature: IsotropicSolid,
    /// At the reference temperature; the same without shift factors.
    pub at_reference: IsotropicSolid,
}

/// What is known of Poisson's ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PoissonRatio {
    /// Nothing.
    NotGiven,
    /// It is taken as constant.
    Constant(f64),
    /// It follows from the shear and the bulk series: of an instantaneous load, and of one held for ever.
    Following([f64; 2]),
}

impl PoissonRatio {
    /// The ratio, if it is constant.
    #[must_use]
    pub const fn constant(self) -> Option<f64> {
        if let Self::Constant(ratio) = self { Some(ratio) } else { None }
    }
}

impl super::SceneMaterial {
    /// What is known of Poisson's ratio.
    #[must_use]
    pub fn poisson(&self) -> PoissonRatio {
        match (&self.isotropic, self.poisson_ratio) {
            (Some(solid), _) => PoissonRatio::Following(solid.at_temperature.poisson_ratios()),
            (None, Some(ratio)) => PoissonRatio::Constant(ratio),
            (None, None) => PoissonRatio::NotGiven,
        }
    }

    /// Whether the modulus of plane strain and of a half-space is known.
    #[must_use]
    pub fn has_plane_strain_modulus(&self) -> bool {
        self.poisson() != PoissonRatio::NotGiven
    }

    /// The series that a contact or a crack sees: the one place where Young's modulus becomes a plane modulus.
    ///
    /// In plane stress it is Young's. In plane strain and on a half-space it is E/(1 − ν²) of a constant Poisson ratio, or the exact series of
    /// 4G(3K + G)/(3K + 4G). A scene in reduced units holds plane moduli already.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a Poisson ratio out of range; [`Refusal::Undefined`] where a modulus overflows.
    pub fn plane_series(&self, units: Units, state: PlaneState) -> Result<PlaneMaterial, Refusal> {
        match (&self.isotropic, self.poisson_ratio) {
            _ if units == Units::Reduced => Ok(PlaneMaterial::of_plane_moduli(self.series.clone())),
            (Some(solid), _) if state == PlaneState::Strain => Ok(solid.at_temperature.plane_strain().clone()),
            (None, Some(ratio)) => PlaneMaterial::of_youngs(&self.series, state, ratio),
            _ => Ok(PlaneMaterial::of_plane_moduli(self.series.clone())),
        }
    }
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
    /// E0 and E∞ at the temperature of the fit.
    pub plateaus: [Plateau; 2],
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
