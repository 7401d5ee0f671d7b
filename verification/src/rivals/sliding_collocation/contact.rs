//! One collocated contact: piecewise-constant pressure that reproduces the indenter at every midpoint (thesis Eqs 3.23, 3.35).
//!
//! The pressure is linear in the penetration, p = p_wave + Δ p_flat with w = cos x − 1 for the first and w = 1 for the second: two right-hand
//! sides of one matrix serve either control. Positions are distances to the two edges of a reference contact, the old one for a moved contact;
//! they are negative in its process zone.

use super::influence::influence_row;
use super::mesh::{Element, separation};
use crate::rivals::dense::solved;
use faer::{Mat, MatRef};
use std::f64::consts::TAU;
use viscotack::refusal::{Refusal, require_finite};
use viscotack::sliding::HalfPlaneGreen;
use viscotack::sliding::contact::{ArcPoint, Prescribed, WaveContact};

/// Midpoints that [`CollocatedContact::pressure`] interpolates.
const STENCIL: usize = 6;

/// A contact with given edges.
#[derive(Debug, Clone)]
pub struct CollocatedContact {
    reference: WaveContact,
    elements: Vec<Element>,
    pressures: Vec<f64>,
    penetration: f64,
    mean_pressure: f64,
}

impl CollocatedContact {
    /// Solves for the pressures of `elements`, whose influence coefficients are `matrix`.
    pub(super) fn new(
        reference: WaveContact,
        elements: Vec<Element>,
        matrix: MatRef<'_, f64>,
        prescribed: Prescribed,
    ) -> Result<Self, Refusal> {
        let sides = Mat::from_fn(elements.len(), 2, |row, side| match (side, elements.get(row)) {
            (0, Some(element)) => indenter(reference, element.middle),
            _ => 1.0,
        });
        let solution = solved(matrix, sides.as_ref())?;
        let mean = |side: usize| elements.iter().enumerate().map(|(row, element)| element.width * solution[(row, side)]).sum::<f64>() / TAU;
        let (wave, flat) = (mean(0), mean(1));
        let penetration = match prescribed {
            Prescribed::Penetration(penetration) => require_finite("penetration", penetration)?,
            Prescribed::MeanSeparation(separation) => require_finite("mean_separation", 1.0 - separation)?,
            Prescribed::MeanPressure(pressure) => require_finite("mean_pressure", (pressure - wave) / flat)?,
        };
        let pressures = (0..elements.len()).map(|row| solution[(row, 0)] + penetration * solution[(row, 1)]).collect();
        Ok(Self { reference, elements, pressures, penetration, mean_pressure: wave + penetration * flat })
    }

    /// Elements, from the trailing edge to the leading one.
    #[must_use]
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// p of each element, in E0*kΛ/2.
    #[must_use]
    pub fn pressures(&self) -> &[f64] {
        &self.pressures
    }

    /// Δ in Λ.
    #[must_use]
    pub const fn penetration(&self) -> f64 {
        self.penetration
    }

    /// p̄ = (1/2π) Σ p h in E0*kΛ/2 (3.19).
    #[must_use]
    pub const fn mean_pressure(&self) -> f64 {
        self.mean_pressure
    }

    /// Friction stress in E0*k²Λ²/2, positive against the motion: −(1/2π) Σ p ∫w′ with w′ = −sin x (3.20 times p̄).
    #[must_use]
    pub fn friction_stress(&self) -> f64 {
        self.summed(|position, width| 2.0 * position.sin() * (0.5 * width).sin()) / TAU
    }

    /// U = ½∫p w in E0*Λ²/2, w the indenter.
    #[must_use]
    pub fn interface_work(&self) -> f64 {
        0.5 * self.summed(|position, width| 2.0 * position.cos() * (0.5 * width).sin() + (self.penetration - 1.0) * width)
    }

    /// p at a point inside, from the six nearest midpoints: the polynomial through p·√(distance · distance to the other edge), whose roots are
    /// those of p at both edges. The scheme itself knows only [`CollocatedContact::pressures`].
    #[must_use]
    pub fn pressure(&self, point: ArcPoint) -> f64 {
        let behind = self.elements.partition_point(|element| separation(element.middle, point) < 0.0);
        let first = behind.saturating_sub(STENCIL / 2).min(self.elements.len().saturating_sub(STENCIL));
        let near = || self.elements.iter().zip(&self.pressures).skip(first).take(STENCIL);
        let mut sum = 0.0;
        for (element, pressure) in near() {
            let mut weight = 1.0;
            for (other, _) in near() {
                if other != element {
                    weight *= separation(point, other.middle) / separation(element.middle, other.middle);
                }
            }
            sum += weight * pressure * self.edge_root(element.middle);
        }
        sum / self.edge_root(point)
    }

    /// The gap in Λ at a point outside: w − (cos x − 1 + Δ), w by the same influence coefficients.
    ///
    /// # Errors
    /// As [`influence_row`].
    pub fn gap(&self, green: &HalfPlaneGreen, point: ArcPoint) -> Result<f64, Refusal> {
        let row = influence_row(green, point, &self.elements)?;
        Ok(self.gap_by_row(point, row.into_iter()))
    }

    /// The same with the influence coefficients at hand.
    pub(super) fn gap_by_row(&self, point: ArcPoint, row: impl Iterator<Item = f64>) -> f64 {
        let displacement: f64 = row.zip(&self.pressures).map(|(influence, pressure)| influence * pressure).sum();
        displacement - indenter(self.reference, point) - self.penetration
    }

    fn summed(&self, weight: impl Fn(f64, f64) -> f64) -> f64 {
        let terms = self.elements.iter().zip(&self.pressures);
        terms.map(|(element, pressure)| pressure * weight(position(self.reference, element.middle), element.width)).sum()
    }

    /// √ of the product of the distances to the edges of THIS contact.
    fn edge_root(&self, point: ArcPoint) -> f64 {
        match (self.elements.first(), self.elements.last()) {
            (Some(first), Some(last)) => (separation(point, first.low) * separation(last.high, point)).sqrt(),
            _ => f64::NAN,
        }
    }
}

/// x of a point, from the crest of the wave.
fn position(reference: WaveContact, point: ArcPoint) -> f64 {
    if point.from_trailing < point.from_leading {
        reference.eccentricity - reference.half_width + point.from_trailing
    } else {
        reference.eccentricity + reference.half_width - point.from_leading
    }
}

/// cos x − 1, the indenter at Δ = 0.
fn indenter(reference: WaveContact, point: ArcPoint) -> f64 {
    let half = (0.5 * position(reference, point)).sin();
    -2.0 * half * half
}
