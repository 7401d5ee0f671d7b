//! A steady contact with given edges on a sliding wave by partial fractions: another reduction than the solver's, with integrals of its own.
//!
//! Reduced units of [`viscotack::sliding`]; W, S, H₀, H₁, X as in [`viscotack::sliding::contact`]. With 1/β + Σj_j/(1 − imζ_j) = Π(1 − imε_i)/Π(1 − imζ_j),
//! ```text
//! Z = e^{ie}Π(1 − iζ_j), A = Re Z, B = −Im Z,  c_i = Π_{l≠i} 1/(1 − ε_l/ε_i),  b_j = Π_{l≠j} 1/(1 − ζ_l/ζ_j)
//! p = C₀H₀ + C₁H₁ + Σ_i M_{ε_i}f_i,   f_i = c_i(A W + B S) + P_iH₀ + Q_iH₁
//! gap = −(C₀/β) asinh(r/s) + Σ_j M_{ζ_j}γ_j,   r = |X|/2,  s = sin(a/2)
//! γ_j = b_j(A g_W − B cos(y/2)|X|) − j_j[C₀ + Σ_iP_i/(1 − ε_i/ζ_j)] asinh(r/s) − j_jζ_j[C₁ + Σ_iQ_i/(1 − ε_i/ζ_j)] sin(y/2)/|X|
//! M_{ε_i}f_i(−a) = 0,  M_{ζ_j}γ_j(a) = 0,  ΣQ_i = −C₁,  p̄ = A s² + D₀/2,  D₀ = C₀ + ΣP_i,  Δ = 1 − A(1 − s² + 2s² ln s) − D₀ ln s + ½ΣQ_iε_i
//! ```
//! Rounding grows with Π_{ζ_j>1} ζ_j: the reason for which the solver does otherwise, and the reason for the narrow range of the known states.

use super::zone_work;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use viscotack::sliding::SlidingMemory;
use viscotack::special::gauss_legendre::UNIT_RULE_20;

/// Beyond so many relaxation lengths a memory has faded.
const FADED: f64 = 40.0;
/// Breaks of a memory integral in relaxation lengths.
const BREAKS: [f64; 8] = [0.25, 1.0, 2.5, 5.0, 10.0, 17.0, 27.0, FADED];
/// The mapped half period is cut into at least so many pieces.
const PIECES: usize = 3;

/// A solid that slides: ratios of both series.
#[derive(Debug, Clone)]
pub struct Spectrum {
    beta: f64,
    compliances: Vec<f64>,
    retardations: Vec<f64>,
    relaxations: Vec<f64>,
}

/// A contact with given edges.
#[derive(Debug, Clone)]
pub struct FractionContact<'a> {
    spectrum: &'a Spectrum,
    half_width: f64,
    wave: (f64, f64),
    /// C₀, C₁.
    now: (f64, f64),
    /// P_i, Q_i.
    remembered: Vec<(f64, f64)>,
    /// p̄ in E0*kΛ/2.
    pub mean_pressure: f64,
    /// Δ in Λ.
    pub penetration: f64,
    /// Friction stress in E0*k²Λ²/2.
    pub friction_stress: f64,
}

/// What is prescribed.
#[derive(Debug, Clone, Copy)]
pub enum Load {
    /// p̄.
    MeanPressure(f64),
    /// Δ.
    Penetration(f64),
}

impl Spectrum {
    /// Of the creep terms of a kernel and its sliding ratios by relaxation times; none for an elastic solid.
    #[must_use]
    pub fn new(kernel: &SlidingMemory, relaxations: Vec<f64>) -> Option<Self> {
        let compliances: Vec<f64> = kernel.terms().iter().map(|term| term.compliance).collect();
        let beta = 1.0 / (1.0 - compliances.iter().sum::<f64>());
        let retardations: Vec<f64> = kernel.terms().iter().map(|term| term.ratio).collect();
        (!compliances.is_empty() && relaxations.len() == compliances.len()).then_some(Self { beta, compliances, retardations, relaxations })
    }

    /// Π ζ_j over the terms with ζ_j > 1: how much rounding grows.
    #[must_use]
    pub fn magnification(&self) -> f64 {
        self.retardations.iter().map(|ratio| ratio.max(1.0)).product()
    }

    /// The smallest ratio.
    fn thinnest(&self) -> f64 {
        self.retardations.iter().chain(&self.relaxations).copied().fold(f64::INFINITY, f64::min)
    }

    /// 1/|Ĉ| of a harmonic.
    #[must_use]
    pub fn stiffness(&self, harmonic: f64) -> f64 {
        let (mut real, mut imaginary) = (1.0 / self.beta, 0.0);
        for (compliance, ratio) in self.compliances.iter().zip(&self.retardations) {
            let product = harmonic * ratio;
            real += compliance / (1.0 + product * product);
            imaginary += compliance * product / (1.0 + product * product);
        }
        1.0 / real.hypot(imaginary)
    }
}

/// Π_{l≠i} 1/(1 − x_l/x_i).
fn fraction(of: &[f64], index: usize) -> f64 {
    let own = of.get(index).copied().unwrap_or(1.0);
    of.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, other)| 1.0 / (1.0 - other / own)).product()
}

/// The angle φ of a point of an arc of width 2h by its distance from the beginning: sin²(φ/2) = distance/2h.
fn angle(from_begin: f64, to_end: f64) -> f64 {
    2.0 * from_begin.max(0.0).sqrt().atan2(to_end.max(0.0).sqrt())
}

/// ∫ e^{−(ξ−y)/ε} f dξ/ε from a point to the end of an arc of half-width h, ξ = −h cos φ; `f` gets (distance from the begin, to the end) and is multiplied by h sin φ.
fn remembered<const N: usize>(h: f64, from_begin: f64, ratio: f64, f: impl Fn(f64, f64) -> [f64; N]) -> [f64; N] {
    let start = angle(from_begin, 2.0 * h - from_begin);
    let reach = (from_begin + FADED * ratio).min(2.0 * h);
    let end = angle(reach, 2.0 * h - reach);
    let mut breaks: Vec<f64> = vec![start, end];
    breaks.extend(
        BREAKS.iter().map(|part| from_begin + part * ratio).filter(|place| *place < reach).map(|place| angle(place, 2.0 * h - place)),
    );
    breaks.extend((1..PIECES).map(|piece| PI * piece as f64 / PIECES as f64).filter(|place| *place > start && *place < end));
    breaks.sort_by(f64::total_cmp);
    let mut sums = [0.0; N];
    for pair in breaks.windows(2) {
        let [low, high] = *pair else { continue };
        for &(node, weight) in UNIT_RULE_20.iter() {
            let phi = low + (high - low) * node;
            let (begin, rest) = (2.0 * h * (0.5 * phi).sin().powi(2), 2.0 * h * (0.5 * phi).cos().powi(2));
            let way = 2.0 * h * (0.5 * (phi + start)).sin() * (0.5 * (phi - start)).sin();
            let factor = (high - low) * weight * (-way / ratio).exp() / ratio * h * phi.sin();
            for (sum, value) in sums.iter_mut().zip(f(begin, rest)) {
                *sum += factor * value;
            }
        }
    }
    sums
}

impl<'a> FractionContact<'a> {
    /// The contact with half-width a and eccentricity e; none if its linear system is singular.
    #[must_use]
    pub fn new(spectrum: &'a Spectrum, half_width: f64, eccentricity: f64, load: Load) -> Option<Self> {
        let count = spectrum.compliances.len();
        let size = 2 * count + 2;
        let s = (0.5 * half_width).sin();
        let wave = spectrum.retardations.iter().fold((eccentricity.cos(), eccentricity.sin()), |(real, imaginary), ratio| {
            (real + ratio * imaginary, imaginary - ratio * real)
        });
        let wave = (wave.0, -wave.1);
        let mut matrix = DMatrix::<f64>::zeros(size, size);
        let mut side = DVector::<f64>::zeros(size);
        // Unknowns C₀, C₁, then P_i, Q_i.
        let (p_of, q_of) = (|index: usize| 2 + index, |index: usize| 2 + count + index);
        for (row, ratio) in spectrum.relaxations.iter().enumerate() {
            let [even, odd, wave_memory] = inside_memory(half_width, 0.0, *ratio, wave);
            matrix[(row, p_of(row))] = even;
            matrix[(row, q_of(row))] = odd;
            side[row] = -fraction(&spectrum.relaxations, row) * wave_memory;
        }
        for (term, (ratio, compliance)) in spectrum.retardations.iter().zip(&spectrum.compliances).enumerate() {
            let row = count + term;
            let [wave_memory, depth, root] = outside_memory(half_width, 0.0, *ratio, wave);
            matrix[(row, 0)] = -compliance * depth;
            matrix[(row, 1)] = -compliance * ratio * root;
            for (index, relaxation) in spectrum.relaxations.iter().enumerate() {
                let pole = 1.0 / (1.0 - relaxation / ratio);
                matrix[(row, p_of(index))] = -compliance * depth * pole;
                matrix[(row, q_of(index))] = -compliance * ratio * root * pole;
            }
            side[row] = -fraction(&spectrum.retardations, term) * wave_memory;
        }
        matrix[(2 * count, 1)] = 1.0;
        for index in 0..count {
            matrix[(2 * count, q_of(index))] = 1.0;
        }
        let last = 2 * count + 1;
        let crest = wave.0 * (1.0 - s * s + 2.0 * s * s * s.ln());
        let flat = |factor: f64, matrix: &mut DMatrix<f64>| {
            matrix[(last, 0)] = factor;
            for index in 0..count {
                matrix[(last, p_of(index))] = factor;
            }
        };
        match load {
            Load::MeanPressure(pressure) => {
                flat(0.5, &mut matrix);
                side[last] = pressure - wave.0 * s * s;
            }
            Load::Penetration(penetration) => {
                flat(-s.ln(), &mut matrix);
                for (index, ratio) in spectrum.relaxations.iter().enumerate() {
                    matrix[(last, q_of(index))] = 0.5 * ratio;
                }
                side[last] = penetration - 1.0 + crest;
            }
        }
        // Rows and columns of like size.
        for row in 0..size {
            let most = matrix.row(row).iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            if !(most > 0.0 && most.is_finite()) {
                return None;
            }
            matrix.row_mut(row).scale_mut(1.0 / most);
            side[row] /= most;
        }
        let scales: Vec<f64> =
            (0..size).map(|column| matrix.column(column).iter().fold(0.0_f64, |most, entry| most.max(entry.abs()))).collect();
        for (column, scale) in scales.iter().enumerate() {
            if !(*scale > 0.0 && scale.is_finite()) {
                return None;
            }
            matrix.column_mut(column).scale_mut(1.0 / scale);
        }
        let mut unknowns = matrix.lu().solve(&side)?;
        for (unknown, scale) in unknowns.iter_mut().zip(&scales) {
            *unknown /= scale;
        }
        if unknowns.iter().any(|unknown| !unknown.is_finite()) {
            return None;
        }
        let remembered: Vec<(f64, f64)> = (0..count).map(|index| (unknowns[p_of(index)], unknowns[q_of(index)])).collect();
        let flat: f64 = unknowns[0] + remembered.iter().map(|(even, _)| even).sum::<f64>();
        let mean_pressure = wave.0 * s * s + 0.5 * flat;
        let shifted: f64 = remembered.iter().zip(&spectrum.relaxations).map(|((_, odd), ratio)| odd * ratio).sum();
        let penetration = 1.0 - crest - flat * s.ln() + 0.5 * shifted;
        let mut contact = Self {
            spectrum,
            half_width,
            wave,
            now: (unknowns[0], unknowns[1]),
            remembered,
            mean_pressure,
            penetration,
            friction_stress: 0.0,
        };
        contact.friction_stress = contact.friction(eccentricity);
        Some(contact)
    }

    /// −Im(e^{−ie}∫p e^{−iy}dy)/2π, with ∫p e^{−iy} = (A − iB)(2πs² − πs⁴)/Π(1 − iε_i) + π(1 − s²)[C₀ + ΣP_i/(1 − iε_i)] − iπs²[C₁ + ΣQ_i/(1 − iε_i)].
    fn friction(&self, eccentricity: f64) -> f64 {
        let square = (0.5 * self.half_width).sin().powi(2);
        // Complex numbers as pairs; z/(1 − iε) = z(1 + iε)/(1 + ε²).
        let divided = |(real, imaginary): (f64, f64), ratio: f64| {
            let norm = 1.0 + ratio * ratio;
            ((real - ratio * imaginary) / norm, (imaginary + ratio * real) / norm)
        };
        let elastic = PI * square * (2.0 - square);
        let mut sum = (self.wave.0 * elastic, -self.wave.1 * elastic);
        for ratio in &self.spectrum.relaxations {
            sum = divided(sum, *ratio);
        }
        let (mut even, mut odd) = ((self.now.0, 0.0), (self.now.1, 0.0));
        for ((p, q), ratio) in self.remembered.iter().zip(&self.spectrum.relaxations) {
            let (more_even, more_odd) = (divided((*p, 0.0), *ratio), divided((*q, 0.0), *ratio));
            even = (even.0 + more_even.0, even.1 + more_even.1);
            odd = (odd.0 + more_odd.0, odd.1 + more_odd.1);
        }
        // −iπs²·odd
        let total =
            (sum.0 + PI * (1.0 - square) * even.0 + PI * square * odd.1, sum.1 + PI * (1.0 - square) * even.1 - PI * square * odd.0);
        let (sin_e, cos_e) = eccentricity.sin_cos();
        -(total.1 * cos_e - total.0 * sin_e) / (2.0 * PI)
    }

    /// k of the trailing and of the leading edge: negative where the edge is pulled.
    #[must_use]
    pub fn edge_amplitudes(&self) -> (f64, f64) {
        let (sine, cosine) = (0.5 * self.half_width).sin_cos();
        (self.now.0 * cosine - self.now.1 * sine, self.now.0 * cosine + self.now.1 * sine)
    }

    /// p at a distance from the trailing edge, and the rest of the width.
    #[must_use]
    pub fn pressure(&self, from_trailing: f64, from_leading: f64) -> f64 {
        let [even, odd, _] = inside(self.half_width, from_trailing, from_leading, self.wave);
        let mut pressure = self.now.0 * even + self.now.1 * odd;
        for (index, ((p, q), ratio)) in self.remembered.iter().zip(&self.spectrum.relaxations).enumerate() {
            let [even, odd, wave] = inside_memory(self.half_width, from_trailing, *ratio, self.wave);
            pressure += fraction(&self.spectrum.relaxations, index) * wave + p * even + q * odd;
        }
        pressure
    }

    /// The gap at a distance ahead of the leading edge.
    #[must_use]
    pub fn gap(&self, ahead: f64) -> f64 {
        let rest = 2.0 * (PI - self.half_width) - ahead;
        let [_, depth, _] = outside(self.half_width, ahead, rest, self.wave);
        let mut gap = -self.now.0 / self.spectrum.beta * depth;
        for (term, (ratio, compliance)) in self.spectrum.retardations.iter().zip(&self.spectrum.compliances).enumerate() {
            let [wave, depth, root] = outside_memory(self.half_width, ahead, *ratio, self.wave);
            let (mut even, mut odd) = self.now;
            for ((p, q), relaxation) in self.remembered.iter().zip(&self.spectrum.relaxations) {
                let pole = 1.0 / (1.0 - relaxation / ratio);
                even += p * pole;
                odd += q * pole;
            }
            gap += fraction(&self.spectrum.retardations, term) * wave - compliance * even * depth - compliance * ratio * odd * root;
        }
        gap
    }

    /// Whether the gap is open at points all along it.
    #[must_use]
    pub fn is_open(&self) -> bool {
        let width = 2.0 * (PI - self.half_width);
        (1..32).all(|index| self.gap(width * (PI * f64::from(index) / 64.0).sin().powi(2)) > 0.0)
    }

    /// (1/2δ)∫ tension₊·gap₋ at the trailing and at the leading edge, the moved contacts at the same penetration; none if one of them is singular or its edge is pressed.
    #[must_use]
    pub fn works(&self, eccentricity: f64, zones: [f64; 2]) -> Option<[f64; 2]> {
        let held = Load::Penetration(self.penetration);
        let thinnest = self.spectrum.thinnest();
        let [first, second] = zones;
        let trailing = FractionContact::new(self.spectrum, self.half_width + 0.5 * first, eccentricity - 0.5 * first, held)?;
        let leading = FractionContact::new(self.spectrum, self.half_width + 0.5 * second, eccentricity + 0.5 * second, held)?;
        let pulled = |contact: &FractionContact<'_>| contact.edge_amplitudes().0 < 0.0 && contact.edge_amplitudes().1 < 0.0;
        if !(pulled(self) && pulled(&trailing) && pulled(&leading)) {
            return None;
        }
        let gap_width = 2.0 * (PI - self.half_width);
        let at_trailing = zone_work(
            first,
            thinnest,
            |distance| -trailing.pressure(distance, 2.0 * trailing.half_width - distance),
            |distance| self.gap(gap_width - distance),
        );
        let at_leading = zone_work(
            second,
            thinnest,
            |distance| -leading.pressure(2.0 * leading.half_width - distance, distance),
            |distance| self.gap(distance),
        );
        Some([at_trailing, at_leading])
    }
}

/// H₀, H₁ and A W + B S at a point inside.
fn inside(half_width: f64, from_trailing: f64, from_leading: f64, (a, b): (f64, f64)) -> [f64; 3] {
    let y = if from_trailing < from_leading { from_trailing - half_width } else { half_width - from_leading };
    let root = 2.0 * ((0.5 * from_trailing).sin() * (0.5 * from_leading).sin()).sqrt();
    let (sine, cosine) = (0.5 * y).sin_cos();
    [cosine / root, sine / root, a * cosine * root + b * (0.5 * sine * root + 2.0 * cosine * cosine * sine / root)]
}

/// M_ε of the same three from a point on.
fn inside_memory(half_width: f64, from_trailing: f64, ratio: f64, wave: (f64, f64)) -> [f64; 3] {
    remembered(half_width, from_trailing, ratio, |begin, rest| inside(half_width, begin, rest, wave))
}

/// A g_W − B cos(y/2)|X|, asinh(r/s) and sin(y/2)/|X| at a point ahead of the leading edge.
fn outside(half_width: f64, ahead: f64, rest: f64, (a, b): (f64, f64)) -> [f64; 3] {
    let root = 2.0 * ((0.5 * ahead).sin() * (0.5 * rest).sin()).sqrt();
    // y runs from a to 2π − a.
    let (sine, cosine) = if ahead < rest {
        (0.5 * (half_width + ahead)).sin_cos()
    } else {
        let (sine, cosine) = (0.5 * (half_width + rest)).sin_cos();
        (sine, -cosine)
    };
    let s = (0.5 * half_width).sin();
    let depth = (0.5 * root / s).asinh();
    let elastic = 2.0 * (sine * 0.5 * root - s * s * depth);
    [a * elastic - b * cosine * root, depth, sine / root]
}

/// M_ζ of the same three from a point on.
fn outside_memory(half_width: f64, ahead: f64, ratio: f64, wave: (f64, f64)) -> [f64; 3] {
    remembered(PI - half_width, ahead, ratio, |begin, rest| outside(half_width, begin, rest, wave))
}
