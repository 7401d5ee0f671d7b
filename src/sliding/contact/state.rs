//! A contact with given edges: the linear system for the memory loads, and the totals.

use super::indenter::{Indenter, inverse_hyperbolic_sine};
use super::memory::ContactMemory;
use super::quadrature::{ArcRange, memory_integrals};
use super::resolution::Resolution;
use crate::refusal::{Refusal, require_finite};
use nalgebra::DMatrix;
use std::f64::consts::PI;
use std::sync::Arc;

/// What is prescribed besides the two edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Prescribed {
    /// Mean pressure over a wavelength, in E0*kΛ/2.
    MeanPressure(f64),
    /// Penetration Δ in Λ: 0 where the crest touches, 1 at the mean level of full contact. Of a parabola: relative to a datum one unit away.
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
    pub(super) indenter: Indenter,
    pub(super) resolution: Resolution,
    pub(super) memory: Arc<ContactMemory>,
    /// D.
    pub(super) flat_strength: f64,
    /// j_jV_j of every creep term.
    pub(super) loads: Vec<f64>,
    /// (O^c_j, O^s_j) of every creep term.
    pub(super) outside: Vec<(f64, f64)>,
    mean_pressure: f64,
    penetration: f64,
    totals: Totals,
    condition: f64,
}

/// Weighted integrals of the pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Totals {
    /// ∫p e^{−iy}dy.
    Harmonic { real: f64, imaginary: f64 },
    /// ∫p y dy and ∫p y² dy.
    Moments { first: f64, second: f64 },
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
    /// Solves the contact of a wave with given edges, to rounding.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a half-width outside 0 < a < π or a prescription that is not finite; [`Refusal::NotConverged`] if the linear
    /// system is singular to rounding.
    pub fn new(memory: &ContactMemory, contact: WaveContact, prescribed: Prescribed) -> Result<Self, Refusal> {
        Self::at_resolution(&Arc::new(memory.clone()), Indenter::Wave, contact, prescribed, Resolution::Finest)
    }

    /// Solves a contact with given edges.
    ///
    /// # Errors
    /// As [`ContactState::new`].
    pub fn at_resolution(
        memory: &Arc<ContactMemory>,
        indenter: Indenter,
        contact: WaveContact,
        prescribed: Prescribed,
        resolution: Resolution,
    ) -> Result<Self, Refusal> {
        let WaveContact { half_width, eccentricity } = contact;
        if !(half_width > 0.0 && half_width < indenter.widest()) {
            return Err(Refusal::out_of_range("half_width", half_width, "greater than 0 and, of a wave, below π (in 1/k)"));
        }
        require_finite("eccentricity", eccentricity)?;
        let s = indenter.half_sine(half_width);
        let square = s * s;
        let shift = indenter.shift(eccentricity);
        let outside: Vec<OutsideIntegrals> =
            memory.creep().iter().map(|mode| outside_integrals(indenter, half_width, mode.ratio, resolution)).collect();
        // Rows M_{ε_i} f_i(−a) = 0: the loads j_jV_j under cos e W − sin e S, and under H₀.
        let count = memory.creep().len();
        let mut matrix = DMatrix::zeros(count, count);
        let mut sides = DMatrix::zeros(count, 2);
        for (row, relaxation) in memory.relaxation.iter().enumerate() {
            let [flat, odd, wave] = inside_integrals(indenter, half_width, relaxation.ratio, shift, resolution);
            // Rows are divided by M_ε H₀(−a), columns by their O^s: everything is then of order one.
            sides[(row, 0)] = wave / flat;
            sides[(row, 1)] = 1.0;
            for (column, integrals) in outside.iter().enumerate() {
                matrix[(row, column)] = 2.0 / PI * memory.pole(column, row) * (integrals.cosine / integrals.sine * (odd / flat) + 1.0);
            }
        }
        let condition_of = matrix.clone();
        if count > 0 && !matrix.lu().solve_mut(&mut sides) {
            return Err(Refusal::NotConverged { what: "the memory loads of a sliding contact", detail: "the linear system is singular".into() });
        }
        let scaled = |side: usize| -> Vec<f64> {
            outside.iter().enumerate().map(|(row, integrals)| sides[(row, side)] / integrals.sine).collect()
        };
        let (wave_loads, flat_loads) = (scaled(0), scaled(1));
        let depth_of = |loads: &[f64]| loads.iter().zip(&outside).map(|(load, integrals)| load * integrals.depth).sum::<f64>() / PI;
        // Δ and p̄ are linear in D.
        let crest = match indenter {
            // 1 − cos e (1 − s² + 2s² ln s), without cancellation at small s and e.
            Indenter::Wave => {
                let half = (0.5 * eccentricity).sin();
                2.0 * half * half + shift.1 * square * (1.0 - 2.0 * s.ln())
            }
            Indenter::Parabola => 0.5 * eccentricity * eccentricity + square * (1.0 - 2.0 * s.ln()),
        };
        let fixed = crest - depth_of(&wave_loads);
        let per_flat = -s.ln() - depth_of(&flat_loads);
        let flat_strength = match prescribed {
            Prescribed::MeanPressure(pressure) => 2.0 * (require_finite("mean_pressure", pressure)? - square * shift.1),
            Prescribed::Penetration(penetration) => (require_finite("penetration", penetration)? - fixed) / per_flat,
        };
        let loads: Vec<f64> = wave_loads.iter().zip(&flat_loads).map(|(wave, flat)| wave + flat_strength * flat).collect();
        let mean_pressure = square * shift.1 + 0.5 * flat_strength;
        let penetration = fixed + flat_strength * per_flat;
        let totals = totals(memory, indenter, contact, flat_strength, mean_pressure, &loads, &outside);
        let state = Self {
            contact,
            indenter,
            resolution,
            memory: Arc::clone(memory),
            flat_strength,
            loads,
            outside: outside.iter().map(|integrals| (integrals.cosine, integrals.sine)).collect(),
            mean_pressure,
            penetration,
            totals,
            condition: condition_number(&condition_of),
        };
        require_finite("mean_pressure", state.mean_pressure)?;
        require_finite("penetration", state.penetration)?;
        require_finite("friction_stress", state.friction_stress())?;
        Ok(state)
    }

    /// The mirror image of the contact with the same edges and penetration (of a parabola: load) that slides the other way: a contact with the
    /// opposite eccentricity. What is ahead of its leading edge lies behind the trailing edge of the contact that slides backward.
    ///
    /// # Errors
    /// As [`ContactState::new`].
    pub fn reversed(&self) -> Result<Self, Refusal> {
        let contact = WaveContact { eccentricity: -self.contact.eccentricity, ..self.contact };
        Self::at_resolution(&self.memory, self.indenter, contact, self.held(), self.resolution)
    }

    /// The edges.
    #[must_use]
    pub const fn contact(&self) -> WaveContact {
        self.contact
    }

    /// β, or 1 at rest: how much stiffer than relaxed the edges are.
    #[must_use]
    pub fn stiffest(&self) -> f64 {
        self.memory.stiffening_ratio()
    }

    /// The indenter.
    #[must_use]
    pub const fn indenter(&self) -> Indenter {
        self.indenter
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

    /// Friction stress in E0*k²Λ²/2, positive against the motion: −Im[e^{−ie} ∫p e^{−iy}dy]/2π, of a parabola ∫p (y + e)dy/2π.
    #[must_use]
    pub fn friction_stress(&self) -> f64 {
        let eccentricity = self.contact.eccentricity;
        match self.totals {
            Totals::Harmonic { real, imaginary } => {
                let (sin_e, cos_e) = eccentricity.sin_cos();
                -(imaginary * cos_e - real * sin_e) / (2.0 * PI)
            }
            Totals::Moments { first, .. } => first / (2.0 * PI) + eccentricity * self.mean_pressure,
        }
    }

    /// U = ½∫p w in E0*Λ²/2: ½[Re(e^{−ie}∫p e^{−iy}) + 2π(Δ − 1)p̄], of a parabola ½[2πp̄Δ − ½∫p (y + e)²].
    #[must_use]
    pub fn interface_work(&self) -> f64 {
        0.5 * (self.profile_work() + 2.0 * PI * self.penetration * self.mean_pressure)
    }

    /// What the release rate is the rise of as an edge moves out: U at fixed penetration; of a parabola, whose load is kept, ½[∫p h − 2πp̄Δ] with
    /// the profile h = −(y + e)²/2 (the limit of U as the compliance of the half-plane grows without bound).
    #[must_use]
    pub fn potential(&self) -> f64 {
        match self.indenter {
            Indenter::Wave => self.interface_work(),
            Indenter::Parabola => 0.5 * (self.profile_work() - 2.0 * PI * self.penetration * self.mean_pressure),
        }
    }

    /// ∫p h over the contact with the profile h measured from the crest.
    fn profile_work(&self) -> f64 {
        let eccentricity = self.contact.eccentricity;
        match self.totals {
            Totals::Harmonic { real, imaginary } => {
                let (sin_e, cos_e) = eccentricity.sin_cos();
                real * cos_e + imaginary * sin_e - 2.0 * PI * self.mean_pressure
            }
            Totals::Moments { first, second } => {
                -0.5 * second - eccentricity * first - PI * eccentricity * eccentricity * self.mean_pressure
            }
        }
    }

    /// Sizes of what cancels in the first and second moment of a parabola's pressure: 2πp̄Σjζ and 2πp̄Σjζ². Nothing does for a wave.
    pub(in crate::sliding) fn cancelled_moments(&self) -> (f64, f64) {
        match self.indenter {
            Indenter::Wave => (0.0, 0.0),
            Indenter::Parabola => {
                let load = 2.0 * PI * self.mean_pressure.abs();
                let moment = |power: i32| self.memory.creep().iter().map(|mode| mode.compliance * mode.ratio.powi(power)).sum::<f64>();
                (load * moment(1), load * moment(2))
            }
        }
    }

    /// What a contact with a moved edge keeps of this one: the penetration, of a parabola the load.
    #[must_use]
    pub const fn held(&self) -> Prescribed {
        match self.indenter {
            Indenter::Wave => Prescribed::Penetration(self.penetration),
            Indenter::Parabola => Prescribed::MeanPressure(self.mean_pressure),
        }
    }

    /// Edge amplitudes (trailing, leading): p ~ k/√(2 sin a·d) at a distance d inside; negative where the edge is pulled.
    #[must_use]
    pub fn edge_amplitudes(&self) -> (f64, f64) {
        let (sine, cosine) = self.indenter.half_sine_cosine(self.contact.half_width);
        let (sin_e, _) = self.indenter.shift(self.contact.eccentricity);
        // f₀·X at ±a: −sin e·(±2 sin(a/2) cos²(a/2)) + D cos(a/2) − Σ loads·(2/π)(±O^c sin(a/2) + O^s cos(a/2)).
        let (mut odd, mut even) = (-2.0 * sin_e * cosine * cosine * sine, self.flat_strength * cosine);
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

/// Weighted integrals of the pressure from those of the effective pressure q.
fn totals(
    memory: &ContactMemory,
    indenter: Indenter,
    contact: WaveContact,
    flat_strength: f64,
    mean_pressure: f64,
    loads: &[f64],
    outside: &[OutsideIntegrals],
) -> Totals {
    let WaveContact { half_width, eccentricity } = contact;
    let square = indenter.half_sine(half_width).powi(2);
    let root = |part: fn(&OutsideIntegrals) -> f64| loads.iter().zip(outside).map(|(load, integrals)| load * part(integrals)).sum::<f64>();
    let (root_cosine, root_sine) = (root(|integrals| integrals.root_cosine), root(|integrals| integrals.root_sine));
    match indenter {
        Indenter::Wave => {
            // ∫q e^{−iy}: e^{ie}(2πs² − πs⁴) + πD(1 − s²) − iΣ loads·∫|X| e_j e^{−iη/2}.
            let (sin_e, cos_e) = eccentricity.sin_cos();
            let elastic = PI * square * (2.0 - square);
            let effective = (cos_e * elastic + PI * flat_strength * (1.0 - square) - root_sine, sin_e * elastic - root_cosine);
            let (real, imaginary) = memory.kernel().harmonic_compliance(1.0);
            let norm = real * real + imaginary * imaginary;
            Totals::Harmonic {
                real: (effective.0 * real + effective.1 * imaginary) / norm,
                imaginary: (effective.1 * real - effective.0 * imaginary) / norm,
            }
        }
        Indenter::Parabola => {
            // Moments of q: X, −e y/X and D/X inside, and the loads; ∫|X|e_j and ∫|X|e_j (a + v) are −root_cosine and 2 root_sine.
            let squared = half_width * half_width;
            let first = -0.5 * PI * eccentricity * squared + root_cosine;
            let second = PI * squared * squared / 8.0 + 0.5 * PI * flat_strength * squared + 2.0 * root_sine;
            // Ĉ(κ) = 1 + iκΣjζ − κ²Σjζ² takes them to p.
            let (mut once, mut twice) = (0.0, 0.0);
            for mode in memory.creep() {
                once += mode.compliance * mode.ratio;
                twice += mode.compliance * mode.ratio * mode.ratio;
            }
            let load = 2.0 * PI * mean_pressure;
            let first = first + once * load;
            Totals::Moments { first, second: second + 2.0 * once * first - 2.0 * twice * load }
        }
    }
}

/// M_ε at the trailing edge of H₀, H₁ and cos e W − sin e S.
fn inside_integrals(indenter: Indenter, half_width: f64, ratio: f64, shift: (f64, f64), resolution: Resolution) -> [f64; 3] {
    let gap = indenter.gap_width(half_width);
    let arc = ArcRange { length: 2.0 * half_width, before: gap, behind: gap, starts_at_edge: true };
    memory_integrals(arc, ratio, resolution.arc_rule(), |distance, rest| {
        let root = 2.0 * (indenter.half_sine(distance) * indenter.half_sine(rest)).sqrt();
        let y = if distance < rest { distance - half_width } else { half_width - rest };
        indenter.pressures(indenter.half_sine_cosine(y), root, shift).map(|value| value / ratio)
    })
}

/// The integrals over the gap with e^{−v/ζ}, v the distance behind the trailing edge.
fn outside_integrals(indenter: Indenter, half_width: f64, ratio: f64, resolution: Resolution) -> OutsideIntegrals {
    let width = 2.0 * half_width;
    let arc = ArcRange { length: indenter.gap_width(half_width), before: width, behind: width, starts_at_edge: true };
    let s = indenter.half_sine(half_width);
    let [cosine, sine, depth, root_cosine, root_sine] = memory_integrals(arc, ratio, resolution.arc_rule(), |distance, rest| {
        let other = if rest < distance { indenter.half_sine(rest) } else { indenter.half_sine(width + distance) };
        let root = 2.0 * (indenter.half_sine(distance) * other).sqrt();
        // η/2 = π − (a + v)/2.
        let (sine, cosine) = indenter.half_sine_cosine(half_width + distance);
        [-cosine / root, sine / root, inverse_hyperbolic_sine(0.5 * root / s), -root * cosine, root * sine]
    });
    OutsideIntegrals { cosine, sine, depth, root_cosine, root_sine }
}

/// 1-norm condition number by the explicit inverse: n is at most some twenty.
fn condition_number(matrix: &DMatrix<f64>) -> f64 {
    let norm = |matrix: &DMatrix<f64>| matrix.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max);
    if matrix.is_empty() { 1.0 } else { matrix.clone().try_inverse().map_or(f64::INFINITY, |inverse| norm(matrix) * norm(&inverse)) }
}
