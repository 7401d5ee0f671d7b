//! The material that a contact or a crack sees: its moduli are plane moduli.
//!
//! | symbol | plane modulus of | |
//! |---|---|---|
//! | E* = E/(1 − ν²) | plane strain, and every half-space | [`PlaneState::Strain`] |
//! | E* = E | plane stress | [`PlaneState::Stress`] |

use super::conversion::ConversionError;
use super::{ComplexModulus, CreepTerm, GivenSeries, Material, RelaxationTerm, WeightedMean};
use crate::elastic::PlaneState;
use crate::refusal::Refusal;

/// A material whose moduli are plane moduli E* (Pa).
///
/// Contacts, cracks and surfaces take this type, so that Young's modulus cannot be handed to them by mistake:
/// ```compile_fail,E0308
/// use viscotack::Material;
/// use viscotack::indentation::{History, IndentationProblem, Profile, run};
/// let youngs = Material::standard_solid(1e6, 1e8, 0.1)?;
/// let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1e-3 }, None, History::penetration(2e-6));
/// run(&youngs, &problem)?; // Young's moduli: see [`PlaneMaterial::of_youngs`]
/// # Ok::<(), viscotack::Refusal>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneMaterial(Material);

impl PlaneMaterial {
    /// That of a material in Young's moduli, of a constant Poisson ratio. [`IsotropicSolid`](super::isotropic::IsotropicSolid) makes that of one which
    /// relaxes in volume, too.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside −1 < ν ≤ 0.5; [`Refusal::Undefined`] where a modulus overflows.
    pub fn of_youngs(youngs: &Material, state: PlaneState, poisson_ratio: f64) -> Result<Self, Refusal> {
        Ok(Self(youngs.stiffened(state.stiffening(poisson_ratio)?)?))
    }

    /// A material whose moduli are plane moduli already: given as such, or in reduced units.
    #[must_use]
    pub const fn of_plane_moduli(material: Material) -> Self {
        Self(material)
    }

    /// [`Material::elastic`] of a plane modulus (Pa).
    ///
    /// # Errors
    /// As there.
    pub fn elastic(modulus: f64) -> Result<Self, Refusal> {
        Material::elastic(modulus).map(Self)
    }

    /// [`Material::from_creep`] of plane moduli (Pa) and compliances (1/Pa).
    ///
    /// # Errors
    /// As there.
    pub fn from_creep(glassy_modulus: f64, terms: &[CreepTerm], steady_viscosity: Option<f64>) -> Result<Self, Refusal> {
        Material::from_creep(glassy_modulus, terms, steady_viscosity).map(Self)
    }

    /// [`Material::from_relaxation`] of plane moduli (Pa).
    ///
    /// # Errors
    /// As there.
    pub fn from_relaxation(relaxed_modulus: f64, terms: &[RelaxationTerm]) -> Result<Self, Refusal> {
        Material::from_relaxation(relaxed_modulus, terms).map(Self)
    }

    /// [`Material::standard_solid`] of plane moduli (Pa).
    ///
    /// # Errors
    /// As there.
    pub fn standard_solid(relaxed_modulus: f64, glassy_modulus: f64, retardation_time: f64) -> Result<Self, Refusal> {
        Material::standard_solid(relaxed_modulus, glassy_modulus, retardation_time).map(Self)
    }

    /// [`Material::stiffened`]: every plane modulus multiplied by `factor`.
    ///
    /// # Errors
    /// As there.
    pub fn stiffened(&self, factor: f64) -> Result<Self, Refusal> {
        self.0.stiffened(factor).map(Self)
    }

    /// [`Material::slowed`]: every time multiplied by `factor`.
    ///
    /// # Errors
    /// As there.
    pub fn slowed(&self, factor: f64) -> Result<Self, Refusal> {
        self.0.slowed(factor).map(Self)
    }
}

/// The functions of a [`Material`] that are the same of plane moduli. There is no coercion to a [`Material`]: what takes Young's moduli takes none of these.
macro_rules! as_of_material {
    ($($name:ident($($argument:ident: $kind:ty),*) -> $found:ty;)*) => {
        impl PlaneMaterial {
            /// The same numbers as a material.
            #[must_use]
            pub const fn as_material(&self) -> &Material {
                &self.0
            }

            $(
                #[doc = concat!("[`Material::", stringify!($name), "`], of plane moduli.")]
                #[allow(clippy::missing_errors_doc, clippy::must_use_candidate, reason = "as said there")]
                pub fn $name(&self, $($argument: $kind),*) -> $found {
                    self.0.$name($($argument),*)
                }
            )*
        }
    };
}

as_of_material! {
    glassy_modulus() -> f64;
    relaxed_modulus() -> f64;
    solid_modulus(quantity: &'static str) -> Result<f64, Refusal>;
    stiffening_ratio() -> f64;
    creep_terms() -> &[CreepTerm];
    relaxation_terms() -> &[RelaxationTerm];
    steady_viscosity() -> Option<f64>;
    is_elastic() -> bool;
    given() -> GivenSeries;
    conversion_errors() -> &[ConversionError];
    modulus_rounding() -> f64;
    longest_retardation_time() -> Option<f64>;
    longest_relaxation_time() -> Option<f64>;
    creep(time: f64) -> f64;
    creep_rate(time: f64) -> f64;
    relaxation(time: f64) -> f64;
    relaxation_rate(time: f64) -> f64;
    complex_modulus(angular_frequency: f64) -> Result<ComplexModulus, Refusal>;
    creep_mean(time: f64, glassy: f64, flow: f64, kernel: impl Fn(f64) -> (f64, f64)) -> WeightedMean;
    relaxation_mean(time: f64, relaxed: f64, kernel: impl Fn(f64) -> (f64, f64)) -> WeightedMean;
    mean_creep(time: f64) -> WeightedMean;
    mean_relaxation(time: f64) -> WeightedMean;
    creep_kernel_count() -> u64;
    relaxation_kernel_count() -> u64;
}
