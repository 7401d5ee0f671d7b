//! Intervals of parameters.

/// An end of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// The data exclude what lies beyond this value.
    At(f64),
    /// The data do not exclude the bound of the parameter, this value.
    Open(f64),
}

impl End {
    /// Its value, of an open end the bound.
    #[must_use]
    pub const fn value(self) -> f64 {
        match self {
            Self::At(value) | Self::Open(value) => value,
        }
    }

    /// Whether the data leave it open.
    #[must_use]
    pub const fn is_open(self) -> bool {
        matches!(self, Self::Open(_))
    }
}

/// 95 % of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Below.
    pub lower: End,
    /// Above.
    pub upper: End,
}

impl Interval {
    /// Whether a value lies inside; beyond an open end nothing is excluded.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        (self.lower.is_open() || value >= self.lower.value()) && (self.upper.is_open() || value <= self.upper.value())
    }
}
