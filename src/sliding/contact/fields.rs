//! Pressure inside and gap outside of a solved contact, at any point given by its distances to the two edges.

use super::arcs::Place;
use super::edges::ContactEdges;
use super::quadrature::{ArcRange, memory_integrals};
use super::resolution::Resolution;
use super::state::{ContactState, Prescribed};
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

/// A point of an arc by its distances to the two ends, so that neither is lost to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcPoint {
    /// Distance to the trailing edge (1/k).
    pub from_trailing: f64,
    /// Distance to the leading edge (1/k).
    pub from_leading: f64,
}

impl ContactState {
    /// A point of the contact at a distance d (0 < d < 2a) inside the trailing edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the contact.
    pub fn inside_trailing(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * self.edges.half_width;
        checked(distance, width).map(|distance| ArcPoint { from_trailing: distance, from_leading: width - distance })
    }

    /// A point of the contact at a distance d (0 < d < 2a) inside the leading edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the contact.
    pub fn inside_leading(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * self.edges.half_width;
        checked(distance, width).map(|distance| ArcPoint { from_trailing: width - distance, from_leading: distance })
    }

    /// A point of the gap at a distance d (0 < d < 2π − 2a, of a parabola any d > 0) behind the trailing edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the gap.
    pub fn behind_trailing(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * self.edges.half_gap;
        checked(distance, width).map(|distance| ArcPoint { from_trailing: distance, from_leading: width - distance })
    }

    /// A point of the gap at a distance d (0 < d < 2π − 2a, of a parabola any d > 0) ahead of the leading edge.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a distance outside the gap.
    pub fn ahead_of_leading(&self, distance: f64) -> Result<ArcPoint, Refusal> {
        let width = 2.0 * self.edges.half_gap;
        checked(distance, width).map(|distance| ArcPoint { from_trailing: width - distance, from_leading: distance })
    }

    /// p in E0*kΛ/2 at a point of the contact.
    #[must_use]
    pub fn pressure(&self, point: ArcPoint) -> f64 {
        self.pressure_and_size(point).0
    }

    /// p in E0*kΛ/2 at a point of the contact, and the size of the terms that it is a sum of, which rounding is relative to.
    #[must_use]
    pub fn pressure_and_size(&self, point: ArcPoint) -> (f64, f64) {
        let memory = &self.memory;
        let shift = self.indenter.shift(self.edges.eccentricity);
        let Place { root, angle } = self.arcs.inside(point);
        let [flat, odd, wave] = self.indenter.pressures(angle, root, shift);
        let strengths = self.strengths(None);
        let stiff = memory.stiffening_ratio();
        let mut pressure = stiff * (wave + strengths.0 * flat + strengths.1 * odd);
        let mut size = stiff * (wave.abs() + (strengths.0 * flat).abs() + (strengths.1 * odd).abs());
        for (term, relaxation) in memory.relaxation.iter().enumerate() {
            let remembered = relaxation.modulus * self.remembered_inside(point, term);
            pressure -= remembered;
            size += remembered.abs();
        }
        (pressure, size)
    }

    /// The gap in Λ at a point outside the contact.
    #[must_use]
    pub fn gap(&self, point: ArcPoint) -> f64 {
        self.gap_and_size(point).0
    }

    /// The gap in Λ at a point outside the contact, and the size of its terms.
    #[must_use]
    pub fn gap_and_size(&self, point: ArcPoint) -> (f64, f64) {
        let shift = self.indenter.shift(self.edges.eccentricity);
        let Place { root, angle } = self.arcs.outside(point);
        let (wave, depth) = self.indenter.gaps(angle, root, self.arcs.half.0, shift);
        let mut gap = wave - self.flat_strength * depth;
        let mut size = wave.abs() + (self.flat_strength * depth).abs();
        for (term, (load, creep)) in self.loads.iter().zip(self.memory.creep()).enumerate() {
            let remembered = load * 2.0 / PI * creep.ratio * self.remembered_outside(point, term);
            gap -= remembered;
            size += remembered.abs();
        }
        (gap, size)
    }

    /// The contact with both edges, and the load, moved; solved and evaluated at the next finer resolution.
    ///
    /// # Errors
    /// Edges that leave the room of a contact, or a singular system.
    pub fn moved(&self, [trailing, leading]: [f64; 2], load: f64) -> Result<Self, Refusal> {
        let edges = self.edges;
        let half = 0.5 * (leading - trailing);
        let moved = ContactEdges {
            half_width: edges.half_width + half,
            half_gap: edges.half_gap - half,
            eccentricity: edges.eccentricity + 0.5 * (leading + trailing),
        };
        require_positive("half-width", moved.half_width)?;
        // Of a parabola it is infinite.
        if moved.half_gap.is_nan() || moved.half_gap <= 0.0 {
            return Err(Refusal::out_of_range("half the gap", moved.half_gap, "greater than zero"));
        }
        let resolution = self.resolution.finer().unwrap_or(self.resolution);
        let prescribed = Prescribed::MeanPressure(self.totals.mean_pressure + load);
        Self::at_edges(&self.memory, self.indenter, moved, prescribed, resolution)
    }

    /// M_ε f_i(y) = ∫_y^a e^{−(ξ−y)/ε} f_i dξ/ε, from y towards the leading edge; M_ε f_i(−a) = 0.
    pub(super) fn remembered_inside(&self, point: ArcPoint, term: usize) -> f64 {
        let Some(relaxation) = self.memory.relaxation.get(term) else { return 0.0 };
        let strengths = self.strengths(Some(term));
        let between = Between {
            from_near: point.from_trailing,
            from_far: point.from_leading,
            opposite: 2.0 * self.edges.half_gap,
            resolution: self.resolution,
        };
        let shift = self.indenter.shift(self.edges.eccentricity);
        let remembered = between.memory(relaxation.ratio, |from_trailing, from_leading| {
            let Place { root, angle } = self.arcs.inside(ArcPoint { from_trailing, from_leading });
            let [flat, odd, wave] = self.indenter.pressures(angle, root, shift);
            wave + strengths.0 * flat + strengths.1 * odd
        });
        remembered / relaxation.ratio
    }

    /// ∫_y^{2π−a} e^{−(ξ−y)/ζ} (O^c sin(ξ/2) + O^s cos(ξ/2))/|X| dξ/ζ, from y towards the trailing edge of the next period; the integral over
    /// the whole gap vanishes.
    pub(super) fn remembered_outside(&self, point: ArcPoint, term: usize) -> f64 {
        let (Some(creep), Some(&(outside_cosine, outside_sine))) = (self.memory.creep().get(term), self.outside.get(term)) else {
            return 0.0;
        };
        let between = Between {
            from_near: point.from_leading,
            from_far: point.from_trailing,
            opposite: 2.0 * self.edges.half_width,
            resolution: self.resolution,
        };
        let remembered = between.memory(creep.ratio, |from_leading, from_trailing| {
            let Place { root, angle: (sine, cosine) } = self.arcs.outside(ArcPoint { from_trailing, from_leading });
            (outside_cosine * sine + outside_sine * cosine) / root
        });
        remembered / creep.ratio
    }

    /// Strengths of H₀ and H₁ in f₀, or in f_i.
    pub(super) fn strengths(&self, relaxation: Option<usize>) -> (f64, f64) {
        let (mut flat, mut odd) = (self.flat_strength, 0.0);
        for (creep, (load, &(outside_cosine, outside_sine))) in self.loads.iter().zip(&self.outside).enumerate() {
            let pole = relaxation.map_or(1.0, |relaxation| self.memory.pole(creep, relaxation));
            flat -= load * pole * 2.0 / PI * outside_sine;
            odd -= load * pole * 2.0 / PI * outside_cosine;
        }
        (flat, odd)
    }
}

/// A point between the two edges of an arc.
struct Between {
    from_near: f64,
    from_far: f64,
    /// Length of the arcs on both sides.
    opposite: f64,
    resolution: Resolution,
}

impl Between {
    /// ∫ e^{−(ξ−y)/scale} f dξ from the point to the far edge, for an f whose integral over the WHOLE arc (from the near edge) vanishes.
    ///
    /// f has a square root in its denominator at both edges. Nearer to the near edge than one scale, where that root would be almost inside the
    /// range, the vanishing whole is used: the integral is −e^{d/scale} ∫₀^d e^{−t/scale} f dt.
    fn memory(&self, scale: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
        let &Self { from_near, from_far, opposite, resolution } = self;
        // Nearer to the far edge the direct integral is short and harmless, and the whole would cancel against almost itself.
        if from_near < scale && from_near < from_far {
            let arc = ArcRange { length: from_near, before: opposite, behind: from_far, starts_at_edge: true };
            let [before] =
                memory_integrals(arc, f64::INFINITY, resolution, |distance, rest| [(rest / scale).exp() * f(distance, from_far + rest)]);
            -before
        } else {
            let arc = ArcRange { length: from_far, before: from_near, behind: opposite, starts_at_edge: false };
            let [after] = memory_integrals(arc, scale, resolution, |distance, rest| [f(from_near + distance, rest)]);
            after
        }
    }
}

fn checked(distance: f64, width: f64) -> Result<f64, Refusal> {
    require_positive("distance", distance)?;
    if distance < width { Ok(distance) } else { Err(Refusal::out_of_range("distance", distance, "less than the width of the arc")) }
}
