//! A contact with given edges: the linear system for the memory loads, and the totals.

use super::memory::ContactMemory;
use super::quadrature::memory_integrals;
use crate::refusal::{Refusal, require_finite};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// What is prescribed besides the two edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Prescribed {
    /// Mean pressure over a wavelength, in E0*kΛ/2.
    MeanPressure(f64),
    /// Penetration Δ in Λ: 0 where the crest touches, 1 at the mean level of full contact.
    Penetration(f64),
}

/// The edges of a contact on a wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveContact {
    /// a, half the contact width, in 1/k: between 0 and π.
    pub half_width: f64,
    /// e, the middle of the contact ahead of the crest, in 1/k.
    pub eccentricity: f64,
}

/// A solved contact with given edges.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactState {
    pub(super) contact: WaveContact,
    pub(super) memory: ContactMemory,
    /// D.
    pub(super) flat_strength: f64,
    /// j_jV_j of every creep term.
    pub(super) loads: Vec<f64>,
    /// (O^c_j, O^s_j) of every creep term.
    pub(super) outside: Vec<(f64, f64)>,
    mean_pressure: f64,
    penetration: f64,
    first_harmonic: (f64, f64),
    condition: f64,
}

/// Integrals over the gap with the memory of one creep term.
struct OutsideIntegrals {
    cosine: f64,
    sine: f64,
    depth: f64,
    root_cosine: f64,
    root_sine: f64,
}

impl ContactState {
    /// Solves the contact with given edges.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a half-width outside 0 < a < π or a prescription that is not finite; [`Refusal::NotConverged`] if the linear
    /// system is singular to rounding.
    pub fn new(memory: &ContactMemory, contact: WaveContact, prescribed: Prescribed) -> Result<Self, Refusal> {
        let WaveContact { half_width, eccentricity } = contact;
        if !(half_width > 0.0 && half_width < PI) {
            return Err(Refusal::out_of_range("half_width", half_width, "greater than 0 and below π (in 1/k)"));
        }
        require_finite("eccentricity", eccentricity)?;
        let sine = (0.5 * half_width).sin();
        let square = sine * sine;
        let (sin_e, cos_e) = eccentricity.sin_cos();
        let outside: Vec<OutsideIntegrals> = memory.creep().iter().map(|mode| outside_integrals(half_width, mode.ratio)).collect();
        // Rows M_{ε_i} f_i(−a) = 0: the loads j_jV_j under cos e W − sin e S, and under H₀.
        let count = memory.creep().len();
        let mut matrix = DMatrix::zeros(count, count);
        let mut wave_side = DVector::zeros(count);
        let mut flat_side = DVector::zeros(count);
        for (row, relaxation) in memory.relaxation.iter().enumerate() {
            let [flat, odd, wave] = inside_integrals(half_width, relaxation.ratio, cos_e, sin_e);
            // Rows are divided by M_ε H₀(−a), columns by their O^s: everything is then of order one.
            wave_side[row] = wave / flat;
            flat_side[row] = 1.0;
            for (column, creep) in memory.creep().iter().enumerate() {
                let OutsideIntegrals { cosine, sine, .. } = outside[column];
                let pole = creep.ratio / (creep.ratio - relaxation.ratio);
                matrix[(row, column)] = 2.0 / PI * pole * (cosine / sine * (odd / flat) + 1.0);
            }
        }
        let singular =
            || Refusal::NotConverged { what: "the memory loads of a sliding contact", detail: "the linear system is singular".into() };
        let condition = condition_number(&matrix);
        let factors = matrix.lu();
        let scaled = |side: &DVector<f64>| -> Result<Vec<f64>, Refusal> {
            if count == 0 {
                return Ok(Vec::new());
            }
            let solution = factors.solve(side).ok_or_else(singular)?;
            Ok(solution.iter().zip(&outside).map(|(load, integrals)| load / integrals.sine).collect())
        };
        let (wave_loads, flat_loads) = (scaled(&wave_side)?, scaled(&flat_side)?);
        let depth_of = |loads: &[f64]| loads.iter().zip(&outside).map(|(load, integrals)| load * integrals.depth).sum::<f64>() / PI;
        // Δ = fixed − D·(ln s + ...): both controls are linear in D.
        let fixed = 1.0 - cos_e * (1.0 - square + 2.0 * square * sine.ln()) - depth_of(&wave_loads);
        let per_flat = -sine.ln() - depth_of(&flat_loads);
        let flat_strength = match prescribed {
            Prescribed::MeanPressure(pressure) => 2.0 * (require_finite("mean_pressure", pressure)? - square * cos_e),
            Prescribed::Penetration(penetration) => (require_finite("penetration", penetration)? - fixed) / per_flat,
        };
        let loads: Vec<f64> = wave_loads.iter().zip(&flat_loads).map(|(wave, flat)| wave + flat_strength * flat).collect();
        let mean_pressure = square * cos_e + 0.5 * flat_strength;
        let penetration = fixed + flat_strength * per_flat;
        // ∫q e^{−iy}: e^{ie}(2πs² − πs⁴) + πD(1 − s²) − iΣ loads·∫|X| e_j e^{−iη/2}.
        let elastic = PI * square * (2.0 - square);
        let root =
            |part: fn(&OutsideIntegrals) -> f64| loads.iter().zip(&outside).map(|(load, integrals)| load * part(integrals)).sum::<f64>();
        let (root_cosine, root_sine) = (root(|integrals| integrals.root_cosine), root(|integrals| integrals.root_sine));
        let effective = (cos_e * elastic + PI * flat_strength * (1.0 - square) - root_sine, sin_e * elastic - root_cosine);
        let (real, imaginary) = memory.kernel().harmonic_compliance(1.0);
        let norm = real * real + imaginary * imaginary;
        let first_harmonic = ((effective.0 * real + effective.1 * imaginary) / norm, (effective.1 * real - effective.0 * imaginary) / norm);
        let state = Self {
            contact,
            memory: memory.clone(),
            flat_strength,
            loads,
            outside: outside.iter().map(|integrals| (integrals.cosine, integrals.sine)).collect(),
            mean_pressure,
            penetration,
            first_harmonic,
            condition,
        };
        require_finite("mean_pressure", state.mean_pressure)?;
        require_finite("penetration", state.penetration)?;
        require_finite("first_harmonic", state.first_harmonic.0 + state.first_harmonic.1)?;
        Ok(state)
    }

    /// The edges.
    #[must_use]
    pub const fn contact(&self) -> WaveContact {
        self.contact
    }

    /// p̄ in E0*kΛ/2.
    #[must_use]
    pub const fn mean_pressure(&self) -> f64 {
        self.mean_pressure
    }

    /// Δ in Λ.
    #[must_use]
    pub const fn penetration(&self) -> f64 {
        self.penetration
    }

    /// Friction stress in E0*k²Λ²/2, positive against the motion: −Im[e^{−ie} ∫p e^{−iy}dy]/2π.
    #[must_use]
    pub fn friction_stress(&self) -> f64 {
        let (sin_e, cos_e) = self.contact.eccentricity.sin_cos();
        -(self.first_harmonic.1 * cos_e - self.first_harmonic.0 * sin_e) / (2.0 * PI)
    }

    /// U = ½∫p w in E0*Λ²/2: ½[Re(e^{−ie}∫p e^{−iy}) + 2π(Δ − 1)p̄].
    #[must_use]
    pub fn interface_work(&self) -> f64 {
        let (sin_e, cos_e) = self.contact.eccentricity.sin_cos();
        0.5 * (self.first_harmonic.0 * cos_e + self.first_harmonic.1 * sin_e + 2.0 * PI * (self.penetration - 1.0) * self.mean_pressure)
    }

    /// Edge amplitudes (trailing, leading): p ~ k/√(2 sin a·d) at a distance d inside; negative where the edge is pulled.
    #[must_use]
    pub fn edge_amplitudes(&self) -> (f64, f64) {
        let half = 0.5 * self.contact.half_width;
        let (sine, cosine) = half.sin_cos();
        let sin_e = self.contact.eccentricity.sin();
        // f₀·X at ±a: −sin e·(±cos(a/2) sin a) + D cos(a/2) − Σ loads·(2/π)(±O^c sin(a/2) + O^s cos(a/2)).
        let (mut odd, mut even) = (-sin_e * cosine * self.contact.half_width.sin(), self.flat_strength * cosine);
        for (load, &(outside_cosine, outside_sine)) in self.loads.iter().zip(&self.outside) {
            odd -= load * 2.0 / PI * outside_cosine * sine;
            even -= load * 2.0 / PI * outside_sine * cosine;
        }
        let beta = self.memory.stiffening_ratio();
        (beta * (even - odd), beta * (even + odd))
    }

    /// Condition number of the scaled linear system (1-norm).
    #[must_use]
    pub const fn condition(&self) -> f64 {
        self.condition
    }
}

/// X at a distance from one edge of an arc and the rest of the arc to the other: 2√(sin(d/2) sin(rest/2)).
pub(super) fn root_factor(distance: f64, rest: f64) -> f64 {
    2.0 * ((0.5 * distance).sin() * (0.5 * rest).sin()).sqrt()
}

/// M_ε at the trailing edge of H₀, H₁ and cos e W − sin e S.
fn inside_integrals(half_width: f64, ratio: f64, cos_e: f64, sin_e: f64) -> [f64; 3] {
    memory_integrals(2.0 * half_width, ratio, |distance, rest| {
        let x = root_factor(distance, rest);
        let y = if distance < rest { distance - half_width } else { half_width - rest };
        let (sine, cosine) = (0.5 * y).sin_cos();
        let wave = cosine * x;
        let slope = 0.5 * sine * x + cosine * y.sin() / x;
        [cosine / x, sine / x, cos_e * wave - sin_e * slope].map(|value| value / ratio)
    })
}

/// The integrals over the gap with e^{−v/ζ}, v the distance behind the trailing edge.
fn outside_integrals(half_width: f64, ratio: f64) -> OutsideIntegrals {
    let length = 2.0 * (PI - half_width);
    let s = (0.5 * half_width).sin();
    let [cosine, sine, depth, root_cosine, root_sine] = memory_integrals(length, ratio, |distance, rest| {
        let x = root_factor(distance, rest);
        // η/2 = π − (a + v)/2.
        let half = 0.5 * (half_width + distance);
        let (cosine, sine) = (-half.cos(), half.sin());
        [cosine / x, sine / x, (0.5 * x / s).asinh(), x * cosine, x * sine]
    });
    OutsideIntegrals { cosine, sine, depth, root_cosine, root_sine }
}

/// 1-norm condition number by the explicit inverse: n is at most some twenty.
fn condition_number(matrix: &DMatrix<f64>) -> f64 {
    let norm = |matrix: &DMatrix<f64>| matrix.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max);
    if matrix.is_empty() { 1.0 } else { matrix.clone().try_inverse().map_or(f64::INFINITY, |inverse| norm(matrix) * norm(&inverse)) }
}
