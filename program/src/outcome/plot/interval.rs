//! Which part of an axis is shown, and where on it a value lies.

use super::{
    PlotError,
    figure::{Axis, Scale},
};

/// Places beyond this many frames are drawn as if they were this far: the line leaves the frame in the same direction.
const FARTHEST: f64 = 1e6;
/// A linear axis shorter than this part of its largest number would show rounding, not data.
const NARROWEST_LINEAR: f64 = 1e-12;
/// No linear axis is shorter than this: below it the arithmetic of the ticks would leave the normal numbers.
const SHORTEST_LINEAR: f64 = 1e-300;
/// A logarithmic axis shorter than this many decades would show rounding, not data.
const NARROWEST_LOGARITHMIC: f64 = 1e-11;

/// The ends of an axis; on a logarithmic one those of log10 of the value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval {
    pub(super) scale: Scale,
    pub(super) lower: f64,
    pub(super) upper: f64,
}

impl Interval {
    /// The interval the axis asks for, or else the one that shows all of `extent` (least and greatest value) with `padding` of its length at each end.
    pub(super) fn new(axis: &Axis, extent: Option<(f64, f64)>, padding: f64) -> Result<Option<Self>, PlotError> {
        match axis.range {
            Some((lower, upper)) => Self::asked_for(axis, lower, upper).map(Some),
            None => Ok(extent.map(|(least, greatest)| match axis.scale {
                Scale::Linear => Self::around_linear(least, greatest, padding),
                Scale::Logarithmic => Self::around_logarithmic(least, greatest, padding),
            })),
        }
    }

    fn asked_for(axis: &Axis, lower: f64, upper: f64) -> Result<Self, PlotError> {
        let refuse = |reason| Err(PlotError::UnusableRange { axis: axis.label.clone(), lower, upper, reason });
        if !(lower.is_finite() && upper.is_finite()) {
            return refuse("both ends must be finite");
        }
        if upper <= lower {
            return refuse("the lower end must be less than the upper end");
        }
        match axis.scale {
            Scale::Linear => {
                if upper - lower < SHORTEST_LINEAR || half_length(lower, upper) < NARROWEST_LINEAR * lower.abs().max(upper.abs()) {
                    return refuse("the ends are too close together to be distinguished");
                }
                Ok(Self { scale: axis.scale, lower, upper })
            }
            Scale::Logarithmic => {
                if lower <= 0.0 {
                    return refuse("a logarithmic axis holds positive numbers only");
                }
                let (lower_exponent, upper_exponent) = (lower.log10(), upper.log10());
                if upper_exponent - lower_exponent < NARROWEST_LOGARITHMIC {
                    return refuse("the ends are too close together to be distinguished");
                }
                Ok(Self { scale: axis.scale, lower: lower_exponent, upper: upper_exponent })
            }
        }
    }

    fn around_linear(least: f64, greatest: f64, padding: f64) -> Self {
        let size = least.abs().max(greatest.abs());
        let half = half_length(least, greatest);
        let room = if 2.0 * half > SHORTEST_LINEAR && half > NARROWEST_LINEAR * size {
            2.0 * padding * half
        } else if size > SHORTEST_LINEAR {
            0.1 * size
        } else if size > 0.0 {
            SHORTEST_LINEAR
        } else {
            1.0
        };
        let bounded = |value: f64| value.clamp(-f64::MAX, f64::MAX);
        Self { scale: Scale::Linear, lower: bounded(least - room), upper: bounded(greatest + room) }
    }

    fn around_logarithmic(least: f64, greatest: f64, padding: f64) -> Self {
        let (lower, upper) = (least.log10(), greatest.log10());
        let length = upper - lower;
        let room = if length > NARROWEST_LOGARITHMIC { padding * length } else { 0.5 };
        Self { scale: Scale::Logarithmic, lower: lower - room, upper: upper + room }
    }

    /// How values become places.
    pub(super) const fn scale(&self) -> Scale {
        self.scale
    }

    /// Where the value lies, 0 at the lower and 1 at the upper end; `None` where it has no place on this axis.
    pub(super) fn fraction(&self, value: f64) -> Option<f64> {
        if !has_place(self.scale, value) {
            return None;
        }
        let place = match self.scale {
            Scale::Linear => half_length(self.lower, value) / half_length(self.lower, self.upper),
            Scale::Logarithmic => (value.log10() - self.lower) / (self.upper - self.lower),
        };
        place.is_finite().then_some(place.clamp(-FARTHEST, FARTHEST))
    }
}

/// Half of `upper - lower`, which unlike the whole cannot overflow.
pub(super) fn half_length(lower: f64, upper: f64) -> f64 {
    0.5 * upper - 0.5 * lower
}

/// Whether an axis of this scale can show the value at all.
pub(super) fn has_place(scale: Scale, value: f64) -> bool {
    value.is_finite() && (scale == Scale::Linear || value > 0.0)
}
