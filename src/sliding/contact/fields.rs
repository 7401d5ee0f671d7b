//! Pressure inside and gap outside of a solved contact, at any point given by its distances to the two edges.

use super::quadrature::memory_integrals;
use super::state::{ContactState, root_factor};
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

/// A point of an arc by its distances to the two ends, so that neither is lost to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcPoint {
    /// Distance to the trailing edge.
    pub from_trailing: f64,
    /// Distance to the leading edge.
    pub from_leading: f64,
}

impl ContactState {
    /// A point of the contact at a distance d (0 < d < 2a) inside the trailing edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the contact.
    pub fn inside_trailing(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * self.contact.half_width;
        checked(distance, width).map(|distance| ArcPoint { from_trailing: distance, from_leading: width - distance })
    }

    /// A point of the contact at a distance d (0 < d < 2a) inside the leading edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the contact.
    pub fn inside_leading(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * self.contact.half_width;
        checked(distance, width).map(|distance| ArcPoint { from_trailing: width - distance, from_leading: distance })
    }

    /// A point of the gap at a distance d (0 < d < 2π − 2a) behind the trailing edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the gap.
    pub fn behind_trailing(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * (PI - self.contact.half_width);
        checked(distance, width).map(|distance| ArcPoint { from_trailing: distance, from_leading: width - distance })
    }

    /// A point of the gap at a distance d (0 < d < 2π − 2a) ahead of the leading edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the gap.
    pub fn ahead_of_leading(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * (PI - self.contact.half_width);
        checked(distance, width).map(|distance| ArcPoint { from_trailing: width - distance, from_leading: distance })
    }

    /// p in E0*kΛ/2 at a point of the contact.
    #[must_use]
    pub fn pressure(&self, point: ArcPoint) -> f64 {
        let memory = &self.memory;
        let [flat, odd, wave] = self.elastic_fields(point);
        let field = |strengths: (f64, f64)| wave + strengths.0 * flat + strengths.1 * odd;
        let mut pressure = memory.stiffening_ratio() * field(self.strengths(None));
        for relaxation in &memory.relaxation {
            // M_ε f(y) = ∫_y^a e^{−(ξ−y)/ε} f dξ/ε, from y towards the leading edge; M_ε f(−a) = 0.
            let strengths = self.strengths(Some(relaxation.ratio));
            let remembered =
                memory_between_edges(point.from_trailing, point.from_leading, relaxation.ratio, |from_trailing, from_leading| {
                    let [flat, odd, wave] = self.elastic_fields(ArcPoint { from_trailing, from_leading });
                    wave + strengths.0 * flat + strengths.1 * odd
                });
            pressure -= relaxation.modulus * remembered / relaxation.ratio;
        }
        pressure
    }

    /// The gap in Λ at a point outside the contact.
    #[must_use]
    pub fn gap(&self, point: ArcPoint) -> f64 {
        let s = (0.5 * self.contact.half_width).sin();
        let (sin_e, cos_e) = self.contact.eccentricity.sin_cos();
        let (cosine, sine) = self.outside_angle(point);
        let x = root_factor(point.from_trailing, point.from_leading);
        let (half_root, depth) = (0.5 * x, (0.5 * x / s).asinh());
        let wave = 2.0 * (sine * half_root - s * s * depth);
        let mut gap = cos_e * wave + sin_e * cosine * x - self.flat_strength * depth;
        for ((load, &(outside_cosine, outside_sine)), creep) in self.loads.iter().zip(&self.outside).zip(self.memory.creep()) {
            // From y towards the trailing edge of the next period: the integral over the whole gap vanishes, like M_ε f over the contact.
            let remembered = memory_between_edges(point.from_leading, point.from_trailing, creep.ratio, |from_leading, from_trailing| {
                let (cosine, sine) = self.outside_angle(ArcPoint { from_trailing, from_leading });
                (outside_cosine * sine + outside_sine * cosine) / root_factor(from_trailing, from_leading)
            });
            gap -= load * 2.0 / PI * remembered;
        }
        gap
    }

    /// Strengths of H₀ and H₁ in f₀, or in f_i for a relaxation ratio ε_i.
    fn strengths(&self, relaxation_ratio: Option<f64>) -> (f64, f64) {
        let (mut flat, mut odd) = (self.flat_strength, 0.0);
        for ((load, &(outside_cosine, outside_sine)), creep) in self.loads.iter().zip(&self.outside).zip(self.memory.creep()) {
            let pole = relaxation_ratio.map_or(1.0, |ratio| creep.ratio / (creep.ratio - ratio));
            flat -= load * pole * 2.0 / PI * outside_sine;
            odd -= load * pole * 2.0 / PI * outside_cosine;
        }
        (flat, odd)
    }

    /// H₀, H₁ and cos e W − sin e S inside the contact.
    fn elastic_fields(&self, point: ArcPoint) -> [f64; 3] {
        let a = self.contact.half_width;
        let (sin_e, cos_e) = self.contact.eccentricity.sin_cos();
        let y = if point.from_trailing < point.from_leading { point.from_trailing - a } else { a - point.from_leading };
        let (sine, cosine) = (0.5 * y).sin_cos();
        let x = root_factor(point.from_trailing, point.from_leading);
        [cosine / x, sine / x, cos_e * cosine * x - sin_e * (0.5 * sine * x + cosine * y.sin() / x)]
    }

    /// (cos(y/2), sin(y/2)) in the gap, a < y < 2π − a.
    fn outside_angle(&self, point: ArcPoint) -> (f64, f64) {
        let a = self.contact.half_width;
        if point.from_trailing < point.from_leading {
            let half = 0.5 * (a + point.from_trailing);
            (-half.cos(), half.sin())
        } else {
            let half = 0.5 * (a + point.from_leading);
            (half.cos(), half.sin())
        }
    }
}

/// ∫ e^{−(ξ−y)/scale} f dξ from a point to the far edge of its arc, for an f whose integral over the WHOLE arc (from the near edge) vanishes.
///
/// f has a square root in its denominator at both edges. Nearer to the near edge than one scale, where that root would be almost inside the
/// range, the vanishing whole is used: the integral is −e^{d/scale} ∫₀^d e^{−t/scale} f dt.
fn memory_between_edges(from_near: f64, from_far: f64, scale: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
    // Nearer to the far edge the direct integral is short and harmless, and the whole would cancel against almost itself.
    if from_near < scale && from_near < from_far {
        let [before] = memory_integrals(from_near, f64::INFINITY, |distance, rest| [(rest / scale).exp() * f(distance, from_far + rest)]);
        -before
    } else {
        let [after] = memory_integrals(from_far, scale, |distance, rest| [f(from_near + distance, rest)]);
        after
    }
}

fn checked(distance: f64, width: f64) -> Result<f64, Refusal> {
    require_positive("distance", distance)?;
    if distance < width { Ok(distance) } else { Err(Refusal::out_of_range("distance", distance, "less than the width of the arc")) }
}
