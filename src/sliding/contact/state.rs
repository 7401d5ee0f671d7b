//! A contact with given edges: the linear system for the memory loads, and the totals.

use super::arcs::Arcs;
use super::edges::ContactEdges;
use super::indenter::Indenter;
use super::integrals::OutsideIntegrals;
use super::memory::ContactMemory;
use super::resolution::Resolution;
use super::system::ContactSystem;
use crate::refusal::Refusal;
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
    pub(super) totals: Totals,
    pub(super) condition: f64,
}

/// The totals of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Totals {
    pub(super) mean_pressure: f64,
    pub(super) penetration: f64,
    pub(super) separation: f64,
    /// ∫p e^{−iy}dy of a wave; a parabola has moments instead ([`super::moments`]).
    pub(super) first_harmonic: (f64, f64),
    /// The sizes of the terms that both parts of it are sums of.
    pub(super) harmonic_sizes: (f64, f64),
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
        ContactSystem::new(memory, indenter, edges, resolution)?.state(edges.eccentricity, prescribed)
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
    pub(crate) fn evaluated_at(&self, resolution: Resolution) -> Self {
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
    pub(crate) fn glassy_stiffness(&self) -> f64 {
        self.memory.stiffening_ratio()
    }

    /// How much stiffer than relaxed the solid is on the scale of the contact: 1/|Ĉ| of the harmonic 1/a.
    #[must_use]
    pub(crate) fn stiffness_at_contact(&self) -> f64 {
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
        self.totals.mean_pressure
    }

    /// Δ in Λ.
    #[must_use]
    pub const fn penetration(&self) -> f64 {
        self.totals.penetration
    }

    /// Friction stress in E0*k²Λ²/2, positive against the motion: −Im[e^{−ie} ∫p e^{−iy}dy]/2π, of a parabola ∫p (y + e)dy/2π.
    #[must_use]
    pub fn friction_stress(&self) -> f64 {
        let eccentricity = self.edges.eccentricity;
        match self.indenter {
            Indenter::Wave => {
                let (sin_e, cos_e) = eccentricity.sin_cos();
                -(self.totals.first_harmonic.1 * cos_e - self.totals.first_harmonic.0 * sin_e) / (2.0 * PI)
            }
            Indenter::Parabola => self.first_moment() / (2.0 * PI) + eccentricity * self.totals.mean_pressure,
        }
    }

    /// The sizes of the terms that friction stress and interface work of a wave are sums of, which rounding is relative to; of a parabola none are reported.
    pub(in crate::sliding) fn harmonic_sizes(&self) -> (f64, f64) {
        let (sin_e, cos_e) = self.edges.eccentricity.sin_cos();
        let (real, imaginary) = self.totals.harmonic_sizes;
        let friction = (imaginary * cos_e.abs() + real * sin_e.abs()) / (2.0 * PI);
        let profile = real * cos_e.abs() + imaginary * sin_e.abs();
        (friction, 0.5 * profile + PI * (1.0 + self.totals.penetration.abs()) * self.totals.mean_pressure.abs())
    }

    /// U = ½∫p w in E0*Λ²/2: ½[Re(e^{−ie}∫p e^{−iy}) + 2π(Δ − 1)p̄], of a parabola ½[2πp̄Δ − ½∫p (y + e)²].
    #[must_use]
    pub fn interface_work(&self) -> f64 {
        0.5 * (self.profile_work() + 2.0 * PI * self.totals.penetration * self.totals.mean_pressure)
    }

    /// ∫p h over the contact with the profile h measured from the crest.
    fn profile_work(&self) -> f64 {
        let eccentricity = self.edges.eccentricity;
        match self.indenter {
            Indenter::Wave => {
                let (sin_e, cos_e) = eccentricity.sin_cos();
                self.totals.first_harmonic.0 * cos_e + self.totals.first_harmonic.1 * sin_e - 2.0 * PI * self.totals.mean_pressure
            }
            Indenter::Parabola => {
                -0.5 * self.second_moment()
                    - eccentricity * self.first_moment()
                    - PI * eccentricity * eccentricity * self.totals.mean_pressure
            }
        }
    }

    /// 1 − Δ in Λ, of a wave: vanishes with the gap at full contact, to its last digits.
    #[must_use]
    pub const fn mean_separation(&self) -> f64 {
        self.totals.separation
    }

    /// What a contact with a moved edge keeps of this one: the penetration (its smaller side), of a parabola the load.
    #[must_use]
    pub const fn held(&self) -> Prescribed {
        match self.indenter {
            Indenter::Wave if self.totals.penetration > 0.5 => Prescribed::MeanSeparation(self.totals.separation),
            Indenter::Wave => Prescribed::Penetration(self.totals.penetration),
            Indenter::Parabola => Prescribed::MeanPressure(self.totals.mean_pressure),
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
pub(super) fn log_half_sine(arcs: &Arcs) -> f64 {
    let (sine, cosine) = arcs.half;
    if arcs.indenter == Indenter::Wave && cosine * cosine < 0.5 { 0.5 * (-cosine * cosine).ln_1p() } else { sine.ln() }
}

/// 1 − s² + 2s² ln s with s = sin(a/2), from x = cos²(a/2): x + (1 − x) ln(1 − x) = Σ_{k≥2} xᵏ/(k(k − 1)).
pub(super) fn separation_of_wave(arcs: &Arcs) -> f64 {
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
pub(super) fn first_harmonic(
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
