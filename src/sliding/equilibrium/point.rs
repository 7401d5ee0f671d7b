//! A contact on the equilibrium curve: how the curve goes on there, and whether the contact stays under what is held.
//!
//! ```text
//! M_ij = ∂(work_i/2πΓ)/∂l_j at what is held       stable if M₁₁ > 0, M₂₂ > 0, det M > 0         (see the second variations of branches)
//! ```

use crate::sliding::contact::{ContactEdges, Indenter};
use crate::sliding::edge_balance::SlidingControl;

/// What is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::sliding) enum HeldQuantity {
    /// p̄.
    MeanPressure,
    /// Δ − 1 of a wave.
    Penetration,
}

/// A contact of a half-width, with how its conditions follow place, eccentricity and load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// ln tan(a/2), of a parabola ln(a/2).
    pub(super) place: f64,
    pub(super) half_width: f64,
    pub(super) eccentricity: f64,
    pub(super) mean_pressure: f64,
    /// Δ − 1 of a wave, which keeps its digits near full contact; of a parabola nothing.
    pub(super) depth: f64,
    /// ∂(work_i/2πΓ)/∂e; without adhesion −∂(amplitude_i)/∂e.
    pub(super) by_shift: [f64; 2],
    /// The same by p̄.
    pub(super) by_load: [f64; 2],
    /// The same by the place.
    pub(super) by_place: [f64; 2],
    /// ∂Δ/∂(place), ∂Δ/∂e and ∂Δ/∂p̄.
    pub(super) depth_slopes: [f64; 3],
}

impl Point {
    /// (place, e, p̄) along the curve, of any length: ∇F₁ × ∇F₂ of both conditions, which turns nowhere on a smooth curve.
    pub(super) const fn tangent(&self) -> [f64; 3] {
        let ([w1, w2], [s1, s2], [l1, l2]) = (self.by_place, self.by_shift, self.by_load);
        [s1 * l2 - s2 * l1, l1 * w2 - l2 * w1, w1 * s2 - w2 * s1]
    }

    /// de/d(place) along the curve.
    pub(super) fn tilt(&self) -> f64 {
        let [along, aside, _] = self.tangent();
        aside / along
    }

    /// How far the contact is from a loss of stability at what is held: the least of what must be positive, each over its size.
    pub(super) fn margin(&self, indenter: Indenter, quantity: HeldQuantity) -> f64 {
        let by_width = 1.0 / ContactEdges::at_place(indenter, self.place, 0.0).width_by_place();
        let [depth_by_place, depth_by_shift, depth_by_load] = self.depth_slopes;
        let rows = [0, 1].map(|edge| {
            let (wider, ahead) = (self.by_place[edge] * by_width, self.by_shift[edge]);
            let (wider, ahead) = match quantity {
                HeldQuantity::MeanPressure => (wider, ahead),
                HeldQuantity::Penetration => {
                    let load = self.by_load[edge] / depth_by_load;
                    (wider - load * depth_by_place * by_width, ahead - load * depth_by_shift)
                }
            };
            // An edge moves out by one: half of it wider, and the middle by half of it to that side.
            [0.5 * (wider - ahead), 0.5 * (wider + ahead)]
        });
        let [[a, b], [c, d]] = rows;
        let size = a.abs().max(b.abs()).max(c.abs()).max(d.abs());
        (a / size).min(d / size).min((a * d - b * c) / ((a * d).abs() + (b * c).abs()))
    }
}

impl HeldQuantity {
    /// A held value as a control.
    pub(super) const fn control(self, value: f64, indenter: Indenter) -> SlidingControl {
        match (self, indenter) {
            (Self::MeanPressure, _) => SlidingControl::MeanPressure(value),
            (Self::Penetration, Indenter::Wave) => SlidingControl::Penetration(1.0 + value),
            (Self::Penetration, Indenter::Parabola) => SlidingControl::Penetration(value),
        }
    }

    pub(super) const fn of(self, point: &Point) -> f64 {
        match self {
            Self::MeanPressure => point.mean_pressure,
            Self::Penetration => point.depth,
        }
    }

    /// How much it changes along the tangent.
    pub(super) fn rise(self, point: &Point) -> f64 {
        let [along, aside, pressed] = point.tangent();
        match self {
            Self::MeanPressure => pressed,
            Self::Penetration => point.depth_slopes[0] * along + point.depth_slopes[1] * aside + point.depth_slopes[2] * pressed,
        }
    }

    /// The same over the change of place.
    pub(super) fn slope(self, point: &Point) -> f64 {
        self.rise(point) / point.tangent()[0]
    }
}
