//! The two edges of a contact, with the gap beside the width.

use super::indenter::Indenter;
use super::state::WaveContact;
use std::f64::consts::PI;

/// π − its nearest double.
const REST_OF_PI: f64 = 1.224_646_799_147_353_2e-16;

/// The edges of a contact. Near full contact half the gap π − a keeps the digits that the half-width has lost: an ulp of a is 4e-10 of a gap of 1e-6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactEdges {
    /// a, half the contact width, in 1/k.
    pub half_width: f64,
    /// c = π − a, half the width of the gap in 1/k; infinite for a parabola.
    pub half_gap: f64,
    /// e, the middle of the contact ahead of the crest, in 1/k.
    pub eccentricity: f64,
}

impl ContactEdges {
    /// From half-width and eccentricity.
    #[must_use]
    pub fn new(indenter: Indenter, WaveContact { half_width, eccentricity }: WaveContact) -> Self {
        let half_gap = match indenter {
            Indenter::Wave => (PI - half_width) + REST_OF_PI,
            Indenter::Parabola => f64::INFINITY,
        };
        Self { half_width, half_gap, eccentricity }
    }

    /// From ln tan(a/2), of a parabola ln(a/2): a number that tells narrow contacts and narrow gaps alike to their last digits.
    #[must_use]
    pub fn at_place(indenter: Indenter, place: f64, eccentricity: f64) -> Self {
        match indenter {
            Indenter::Wave => Self { half_width: 2.0 * place.exp().atan(), half_gap: 2.0 * (-place).exp().atan(), eccentricity },
            Indenter::Parabola => Self { half_width: 2.0 * place.exp(), half_gap: f64::INFINITY, eccentricity },
        }
    }

    /// ln tan(a/2), of a parabola ln(a/2).
    #[must_use]
    pub fn place(&self) -> f64 {
        if self.half_gap.is_infinite() {
            (0.5 * self.half_width).ln()
        } else if self.half_gap < self.half_width {
            -(0.5 * self.half_gap).tan().ln()
        } else {
            (0.5 * self.half_width).tan().ln()
        }
    }

    /// d(half-width)/d(place): sin a, of a parabola a.
    #[must_use]
    pub(crate) fn width_by_place(&self) -> f64 {
        if self.half_gap.is_infinite() { self.half_width } else { self.half_gap.min(self.half_width).sin() }
    }

    /// Half the width of the contact or of the gap (1/k), whichever is narrower.
    #[must_use]
    pub const fn narrower(&self) -> f64 {
        self.half_width.min(self.half_gap)
    }

    /// The edges with the leading one (or the trailing one, of a negative length) moved out.
    pub(in crate::sliding) fn moved_out(&self, leading: f64) -> Self {
        let half = 0.5 * leading.abs();
        Self { half_width: self.half_width + half, half_gap: self.half_gap - half, eccentricity: self.eccentricity + 0.5 * leading }
    }

    /// Half-width and eccentricity alone.
    #[must_use]
    pub const fn contact(&self) -> WaveContact {
        WaveContact { half_width: self.half_width, eccentricity: self.eccentricity }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_keep_the_digits_of_contact_and_gap() {
        for narrow in [1e-6, 1e-3, 0.7] {
            let place = (0.5_f64 * narrow).tan().ln();
            let contact = ContactEdges::at_place(Indenter::Wave, place, 0.1);
            let gap = ContactEdges::at_place(Indenter::Wave, -place, 0.1);
            assert!((contact.half_width / narrow - 1.0).abs() < 1e-14 && (gap.half_gap / narrow - 1.0).abs() < 1e-14, "{narrow}");
            assert!((contact.place() - place).abs() < 1e-14 && (gap.place() + place).abs() < 1e-14);
            let moved = gap.moved_out(-0.1 * narrow);
            assert!((moved.half_gap / narrow - 0.95).abs() < 1e-14 && (moved.eccentricity - 0.1 + 0.05 * narrow).abs() < 1e-16);
        }
        let same = ContactEdges::new(Indenter::Wave, WaveContact { half_width: 3.0, eccentricity: 0.0 });
        // π − 3 to 33 digits: 0.141592653589793238462643383279503.
        assert!((same.half_gap / 0.141_592_653_589_793_24 - 1.0).abs() < 1e-16);
    }
}
