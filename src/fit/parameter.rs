//! A free parameter and its place between its bounds.

/// A number that is fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// What it is called.
    pub name: String,
    /// Smallest value allowed; greater than zero if it is fitted by its logarithm.
    pub lower: f64,
    /// Largest value allowed; greater than the smallest.
    pub upper: f64,
    /// Whether it is fitted by its logarithm.
    pub logarithmic: bool,
    /// A value to start from, if one is known.
    pub first: Option<f64>,
}

impl Parameter {
    /// The coordinate of a value: its natural logarithm, or its part of the range.
    #[must_use]
    pub fn coordinate(&self, value: f64) -> f64 {
        if self.logarithmic { value.ln() } else { value / (self.upper - self.lower) }
    }

    /// The value at a coordinate, kept between the bounds.
    #[must_use]
    pub fn value(&self, coordinate: f64) -> f64 {
        let value = if self.logarithmic { coordinate.exp() } else { coordinate * (self.upper - self.lower) };
        value.clamp(self.lower, self.upper)
    }

    /// The coordinates of both bounds.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [self.coordinate(self.lower), self.coordinate(self.upper)]
    }

    /// The coordinate at a part (0 to 1) of the way from bound to bound.
    pub(super) fn part(&self, part: f64) -> f64 {
        let [low, high] = self.ends();
        low + part * (high - low)
    }
}
