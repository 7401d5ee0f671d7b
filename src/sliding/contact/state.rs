//! A contact with given edges: the linear system for the memory loads, and the totals.

use super::arcs::Arcs;
use super::edges::ContactEdges;
use super::indenter::Indenter;
use super::integrals::{OutsideIntegrals, condition_number, inside_integrals, outside_integrals};
use super::memory::ContactMemory;
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
    /// 1 − Δ of a wave in Λ, the distance of the two mean surfaces: keeps the digits that the penetration loses near full contact.
    MeanSeparation(f64),
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
    pub(super) edges: ContactEdges,
    pub(super) indenter: Indenter,
    pub(super) arcs: Arcs,
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
    separation: f64,
    /// ∫p e^{−iy}dy of a wave; a parabola has moments instead ([`super::moments`]).
    first_harmonic: (f64, f64),
    /// The sizes of the terms that both parts of it are sums of.
    harmonic_sizes: (f64, f64),
    condition: f64,
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
        Self::at_edges(memory, indenter, ContactEdges::new(indenter, contact), prescribed, resolution)
    }

    /// Solves a contact with given edges, of which half the gap is known to its own digits.
    ///
    /// # Errors
    /// As [`ContactState::new`].
    pub fn at_edges(
        memory: &Arc<ContactMemory>,
        indenter: Indenter,
        edges: ContactEdges,
        prescribed: Prescribed,
        resolution: Resolution,
    ) -> Result<Self, Refusal> {
        let ContactEdges { half_width, half_gap, eccentricity } = edges;
        if !(half_width > 0.0 && half_gap > 0.0) {
            return Err(Refusal::out_of_range("half_width", half_width, "greater than 0 and, of a wave, below π (in 1/k)"));
        }
        require_finite("eccentricity", eccentricity)?;
        let arcs = Arcs::new(edges, indenter);
        let square = arcs.half.0 * arcs.half.0;
        let shift = indenter.shift(eccentricity);
        let outside: Vec<OutsideIntegrals> =
            memory.creep().iter().map(|mode| outside_integrals(&arcs, edges, mode.ratio, resolution)).collect();
        // Rows M_{ε_i} f_i(−a) = 0: the loads j_jV_j under cos e W − sin e S, and under H₀.
        let count = memory.creep().len();
        let mut matrix = DMatrix::zeros(count, count);
        let mut sides = DMatrix::zeros(count, 2);
        for (row, relaxation) in memory.relaxation.iter().enumerate() {
            let [flat, odd, wave] = inside_integrals(&arcs, edges, relaxation.ratio, shift, resolution);
            // Rows are divided by M_ε H₀(−a), columns by their O^s: everything is then of order one.
            sides[(row, 0)] = wave / flat;
            sides[(row, 1)] = 1.0;
            for (column, integrals) in outside.iter().enumerate() {
                matrix[(row, column)] = 2.0 / PI * memory.pole(column, row) * (integrals.cosine / integrals.sine * (odd / flat) + 1.0);
            }
        }
        let condition_of = matrix.clone();
        if count > 0 && !matrix.lu().solve_mut(&mut sides) {
            return Err(Refusal::NotConverged {
                what: "the memory loads of a sliding contact",
                detail: "the linear system is singular".into(),
            });
        }
        let scaled =
            |side: usize| -> Vec<f64> { outside.iter().enumerate().map(|(row, integrals)| sides[(row, side)] / integrals.sine).collect() };
        let (wave_loads, flat_loads) = (scaled(0), scaled(1));
        let depth_of = |loads: &[f64]| loads.iter().zip(&outside).map(|(load, integrals)| load * integrals.depth).sum::<f64>() / PI;
        // Δ and p̄ are linear in D: Δ from the crest, 1 − Δ from the trough, each without the digits that it would lose in the other.
        let log_sine = log_half_sine(&arcs);
        let crest = match indenter {
            Indenter::Wave => {
                let half = (0.5 * eccentricity).sin();
                2.0 * half * half + shift.1 * square * (1.0 - 2.0 * log_sine)
            }
            Indenter::Parabola => 0.5 * eccentricity * eccentricity + square * (1.0 - 2.0 * log_sine),
        };
        let (fixed, per_flat) = (crest - depth_of(&wave_loads), -log_sine - depth_of(&flat_loads));
        let trough = shift.1 * separation_of_wave(&arcs) + depth_of(&wave_loads);
        let flat_strength = match prescribed {
            Prescribed::MeanPressure(pressure) => 2.0 * (require_finite("mean_pressure", pressure)? - square * shift.1),
            Prescribed::Penetration(penetration) => (require_finite("penetration", penetration)? - fixed) / per_flat,
            Prescribed::MeanSeparation(_) if indenter == Indenter::Parabola => {
                return Err(Refusal::Undefined {
                    quantity: "the mean separation of a cylinder",
                    reason: "its gap grows without bound".into(),
                });
            }
            Prescribed::MeanSeparation(separation) => (trough - require_finite("mean_separation", separation)?) / per_flat,
        };
        let loads: Vec<f64> = wave_loads.iter().zip(&flat_loads).map(|(wave, flat)| wave + flat_strength * flat).collect();
        let mean_pressure = square * shift.1 + 0.5 * flat_strength;
        let penetration = fixed + flat_strength * per_flat;
        let separation = trough - flat_strength * per_flat;
        let (first_harmonic, harmonic_sizes) = match indenter {
            Indenter::Wave => first_harmonic(memory, (square, eccentricity), flat_strength, &loads, &outside),
            Indenter::Parabola => ((0.0, 0.0), (0.0, 0.0)),
        };
        let state = Self {
            edges,
            indenter,
            arcs,
            resolution,
            memory: Arc::clone(memory),
            flat_strength,
            loads,
            outside: outside.iter().map(|integrals| (integrals.cosine, integrals.sine)).collect(),
            mean_pressure,
            penetration,
            separation,
            first_harmonic,
            harmonic_sizes,
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
        let edges = ContactEdges { eccentricity: -self.edges.eccentricity, ..self.edges };
        Self::at_edges(&self.memory, self.indenter, edges, self.held(), self.resolution)
    }

    /// The same contact with its fields evaluated at another resolution; the loads stay.
    #[must_use]
    pub fn evaluated_at(&self, resolution: Resolution) -> Self {
        Self { resolution, ..self.clone() }
    }

    /// Half-width and eccentricity.
    #[must_use]
    pub const fn contact(&self) -> WaveContact {
        self.edges.contact()
    }

    /// The edges, with half the gap.
    #[must_use]
    pub const fn edges(&self) -> ContactEdges {
        self.edges
    }

    /// β, or 1 at rest: how much stiffer than relaxed the edges are.
    #[must_use]
    pub fn glassy_stiffness(&self) -> f64 {
        self.memory.stiffening_ratio()
    }

    /// How much stiffer than relaxed the solid is on the scale of the contact: 1/|Ĉ| of the harmonic 1/a.
    #[must_use]
    pub fn stiffness_at_contact(&self) -> f64 {
        let (real, imaginary) = self.memory.kernel().harmonic_compliance(1.0 / self.edges.half_width);
        1.0 / real.hypot(imaginary)
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
        let eccentricity = self.edges.eccentricity;
        match self.indenter {
            Indenter::Wave => {
                let (sin_e, cos_e) = eccentricity.sin_cos();
                -(self.first_harmonic.1 * cos_e - self.first_harmonic.0 * sin_e) / (2.0 * PI)
            }
            Indenter::Parabola => self.first_moment() / (2.0 * PI) + eccentricity * self.mean_pressure,
        }
    }

    /// The sizes of the terms that friction stress and interface work of a wave are sums of, which rounding is relative to; of a parabola none are told.
    pub(in crate::sliding) fn harmonic_sizes(&self) -> (f64, f64) {
        let (sin_e, cos_e) = self.edges.eccentricity.sin_cos();
        let (real, imaginary) = self.harmonic_sizes;
        let friction = (imaginary * cos_e.abs() + real * sin_e.abs()) / (2.0 * PI);
        let profile = real * cos_e.abs() + imaginary * sin_e.abs();
        (friction, 0.5 * profile + PI * (1.0 + self.penetration.abs()) * self.mean_pressure.abs())
    }

    /// U = ½∫p w in E0*Λ²/2: ½[Re(e^{−ie}∫p e^{−iy}) + 2π(Δ − 1)p̄], of a parabola ½[2πp̄Δ − ½∫p (y + e)²].
    #[must_use]
    pub fn interface_work(&self) -> f64 {
        0.5 * (self.profile_work() + 2.0 * PI * self.penetration * self.mean_pressure)
    }

    /// ∫p h over the contact with the profile h measured from the crest.
    fn profile_work(&self) -> f64 {
        let eccentricity = self.edges.eccentricity;
        match self.indenter {
            Indenter::Wave => {
                let (sin_e, cos_e) = eccentricity.sin_cos();
                self.first_harmonic.0 * cos_e + self.first_harmonic.1 * sin_e - 2.0 * PI * self.mean_pressure
            }
            Indenter::Parabola => {
                -0.5 * self.second_moment() - eccentricity * self.first_moment() - PI * eccentricity * eccentricity * self.mean_pressure
            }
        }
    }

    /// 1 − Δ in Λ, of a wave: vanishes with the gap at full contact, to its last digits.
    #[must_use]
    pub const fn mean_separation(&self) -> f64 {
        self.separation
    }

    /// What a contact with a moved edge keeps of this one: the penetration (its smaller side), of a parabola the load.
    #[must_use]
    pub const fn held(&self) -> Prescribed {
        match self.indenter {
            Indenter::Wave if self.penetration > 0.5 => Prescribed::MeanSeparation(self.separation),
            Indenter::Wave => Prescribed::Penetration(self.penetration),
            Indenter::Parabola => Prescribed::MeanPressure(self.mean_pressure),
        }
    }

    /// Edge amplitudes (trailing, leading): p ~ k/√(2 sin a·d) at a distance d inside; negative where the edge is pulled.
    #[must_use]
    pub fn edge_amplitudes(&self) -> (f64, f64) {
        let (sine, cosine) = self.arcs.half;
        let (sin_e, _) = self.indenter.shift(self.edges.eccentricity);
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

/// ln sin(a/2), ln(a/2) of a parabola.
fn log_half_sine(arcs: &Arcs) -> f64 {
    let (sine, cosine) = arcs.half;
    if arcs.indenter == Indenter::Wave && cosine * cosine < 0.5 { 0.5 * (-cosine * cosine).ln_1p() } else { sine.ln() }
}

/// 1 − s² + 2s² ln s with s = sin(a/2), from x = cos²(a/2): x + (1 − x) ln(1 − x) = Σ_{k≥2} xᵏ/(k(k − 1)).
fn separation_of_wave(arcs: &Arcs) -> f64 {
    let x = arcs.half.1.powi(2);
    if x > 0.25 {
        return x + (1.0 - x) * 2.0 * arcs.half.0.ln();
    }
    let (mut power, mut sum) = (x, 0.0);
    for k in 2..32 {
        power *= x;
        sum += power / f64::from(k * (k - 1));
    }
    sum
}

/// ∫p e^{−iy} of a wave from that of q: e^{ie}(2πs² − πs⁴) + πD(1 − s²) − iΣ loads·∫|X| e_j e^{−iη/2}; and the size of these terms.
fn first_harmonic(
    memory: &ContactMemory,
    (square, eccentricity): (f64, f64),
    flat_strength: f64,
    loads: &[f64],
    outside: &[OutsideIntegrals],
) -> ((f64, f64), (f64, f64)) {
    let root = |part: fn(&OutsideIntegrals) -> f64| loads.iter().zip(outside).map(|(load, integrals)| load * part(integrals)).sum::<f64>();
    let (sin_e, cos_e) = eccentricity.sin_cos();
    let elastic = PI * square * (2.0 - square);
    let effective = (
        cos_e * elastic + PI * flat_strength * (1.0 - square) - root(|integrals| integrals.root_sine),
        sin_e * elastic - root(|integrals| integrals.root_cosine),
    );
    let (real, imaginary) = memory.kernel().harmonic_compliance(1.0);
    let norm = real * real + imaginary * imaginary;
    let remembered =
        |part: fn(&OutsideIntegrals) -> f64| loads.iter().zip(outside).map(|(load, integrals)| (load * part(integrals)).abs()).sum::<f64>();
    let sizes = (
        cos_e.abs() * elastic + PI * flat_strength.abs() * (1.0 - square) + remembered(|integrals| integrals.root_sine),
        sin_e.abs() * elastic + remembered(|integrals| integrals.root_cosine),
    );
    let turned = |(first, second): (f64, f64)| ((first * real + second * imaginary) / norm, (second * real - first * imaginary) / norm);
    let (real_size, imaginary_size) = (real.abs() / norm, imaginary.abs() / norm);
    (turned(effective), (sizes.0 * real_size + sizes.1 * imaginary_size, sizes.1 * real_size + sizes.0 * imaginary_size))
}
