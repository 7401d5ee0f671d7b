//! How finely the integrals of a contact are resolved: four levels, each the error estimate of the one before.

use crate::special::gauss_legendre::{UNIT_RULE, UNIT_RULE_8, UNIT_RULE_12, UNIT_RULE_20, UnitRule};

/// A level of resolution. Errors fall by some three digits a level, down to rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Resolution {
    /// For paths and starts: about four digits.
    Coarse,
    /// About seven digits.
    Medium,
    /// About ten digits.
    Fine,
    /// Rounding.
    Finest,
}

impl Resolution {
    /// The next finer level.
    #[must_use]
    pub const fn finer(self) -> Option<Self> {
        match self {
            Self::Coarse => Some(Self::Medium),
            Self::Medium => Some(Self::Fine),
            Self::Fine => Some(Self::Finest),
            Self::Finest => None,
        }
    }

    /// The relative error of its integrals, roughly.
    #[must_use]
    pub const fn relative_error(self) -> f64 {
        match self {
            Self::Coarse => 1e-4,
            Self::Medium => 1e-7,
            Self::Fine => 1e-10,
            Self::Finest => 1e-13,
        }
    }

    /// The rule of a panel of an integral along an arc.
    pub(super) fn arc_rule(self) -> &'static UnitRule {
        match self {
            Self::Coarse => &UNIT_RULE_8,
            Self::Medium => &UNIT_RULE_12,
            Self::Fine => &UNIT_RULE,
            Self::Finest => &UNIT_RULE_20,
        }
    }

    /// Where e^{−d/scale} is below the error, in scales; of the finest e^{−40} = 4e-18.
    pub(super) const fn memory_cut(self) -> f64 {
        match self {
            Self::Coarse => 15.0,
            Self::Medium => 22.0,
            Self::Fine => 30.0,
            Self::Finest => 40.0,
        }
    }

    /// Largest ratio of the ends of a panel of a process zone, in the root of the distance.
    pub(super) const fn panel_ratio(self) -> f64 {
        match self {
            Self::Coarse => 4.0,
            Self::Medium => 2.8,
            Self::Fine => 2.1,
            Self::Finest => 1.6,
        }
    }
}
