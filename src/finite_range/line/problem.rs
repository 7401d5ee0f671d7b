//! What is asked: a periodic profile that slides steadily over a viscoelastic body which it attracts.
//!
//! Units are reduced. A height scale Λ and the period λ = 2π/k of the profile along the sliding direction are the user's choice:
//!
//! | quantity | unit |
//! |---|---|
//! | places x, y | 1/k, so that the period along x is 2π |
//! | heights, gaps, displacements, range of the law | Λ |
//! | pressures and stresses | E0*kΛ/2, E0* the relaxed plane modulus |
//! | friction stress | E0*k²Λ²/2 (a pressure times a slope kΛ) |
//! | work of adhesion | E0*kΛ²/2 (a pressure times Λ); it is 2πΓ with the Γ of the sharp edge theory |
//! | speed | angular frequency kv of the first harmonic, in the unit of the modulus function |

use super::fourier::Transform;
use crate::finite_range::law::Attraction;
use crate::material::PlaneMaterial;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use crate::sliding::layer::Layer;
use rustfft::num_complex::Complex64;
use std::sync::Arc;

/// The complex modulus E(ω)/E0 at an angular frequency ω ≥ 0, for strains e^{+iωt}: real part > 0, imaginary part ≥ 0, 1 at rest.
pub type Modulus = Arc<dyn Fn(f64) -> Complex64 + Send + Sync>;

/// The modulus function of a material, with the angular frequency in rad/s.
///
/// # Errors
/// [`Refusal::Undefined`] for a viscous material, which has no relaxed modulus.
pub fn modulus_of(material: &PlaneMaterial) -> Result<Modulus, Refusal> {
    let relaxed = material.solid_modulus("the steady state of a law of finite range")?;
    let material = material.clone();
    // A frequency without a modulus becomes NaN, which `Problem::check` refuses.
    Ok(Arc::new(move |frequency| {
        material.complex_modulus(frequency).map_or(Complex64::new(f64::NAN, 0.0), |m| Complex64::new(m.storage, m.loss) / relaxed)
    }))
}

/// The units of a problem in SI: multiply a reduced number by its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// 1/k (m): places and thickness.
    pub length: f64,
    /// Λ (m): heights, gaps, range of the law.
    pub height: f64,
    /// E0*kΛ/2 (Pa): pressures and stresses of the law.
    pub pressure: f64,
    /// E0*k²Λ²/2 (Pa): friction stress.
    pub friction: f64,
    /// E0*kΛ²/2 (J/m²): work of adhesion, interface energy; times kv (rad/s): dissipated power (W/m²).
    pub work: f64,
}

impl Scales {
    /// The units that belong to a relaxed plane modulus E0* (Pa), a period along x (m) and a height scale Λ (m).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless all three are positive and finite.
    pub fn new(relaxed_plane_modulus: f64, period: f64, height: f64) -> Result<Self, Refusal> {
        let modulus = require_positive("relaxed_plane_modulus", relaxed_plane_modulus)?;
        let length = require_positive("period", period)? / std::f64::consts::TAU;
        let height = require_positive("height", height)?;
        let pressure = 0.5 * modulus * height / length;
        Ok(Self { length, height, pressure, friction: pressure * height / length, work: pressure * height })
    }

    /// kv (rad/s) of a speed in m/s.
    #[must_use]
    pub fn frequency(&self, speed: f64) -> f64 {
        speed / self.length
    }
}

/// One wave of a line profile: amplitude · cos(number · x + phase).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Waves in the period, 1 or more.
    pub number: u32,
    /// Amplitude (Λ), finite.
    pub amplitude: f64,
    /// Phase (rad).
    pub phase: f64,
}

/// A periodic surface of zero mean, given by equally spaced heights (positive towards the body); a line has one row.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    nx: usize,
    ny: usize,
    heights: Vec<f64>,
    /// Period along y over the period along x.
    aspect: f64,
}

impl Profile {
    /// A line profile from its waves.
    ///
    /// # Errors
    /// [`Refusal`] unless there is at least one wave, all numbers lie between 1 and 100 000 and all values are finite.
    pub fn harmonics(waves: &[Harmonic]) -> Result<Self, Refusal> {
        let highest = waves.iter().map(|w| w.number).max().unwrap_or(0);
        if waves.iter().any(|w| w.number == 0) || highest == 0 || highest > 100_000 {
            return Err(Refusal::out_of_range("harmonic number", f64::from(highest), "between 1 and 100000, in at least one wave"));
        }
        let nx = (4 * highest as usize).next_power_of_two().max(8);
        let height = |i: usize| {
            let turn = std::f64::consts::TAU / nx as f64;
            // The product number · i is reduced to one period before it is rounded.
            waves.iter().map(|w| w.amplitude * (turn * ((w.number as usize * i) % nx) as f64 + w.phase).cos()).sum()
        };
        Self::surface(nx, 1, 1.0, (0..nx).map(height).collect())
    }

    /// A line profile from equally spaced heights over one period.
    ///
    /// # Errors
    /// As [`Profile::surface`].
    pub fn samples(heights: Vec<f64>) -> Result<Self, Refusal> {
        Self::surface(heights.len(), 1, 1.0, heights)
    }

    /// A surface from `ny` rows of `nx` equally spaced heights; `aspect` is its period along y over that along x (the sliding direction).
    /// The mean is removed. Between the nodes the surface is its trigonometric interpolation.
    ///
    /// # Errors
    /// [`Refusal`] unless `nx` is even and at least 4, `ny` is 1 or even, the heights are finite and not all equal, and the aspect is positive.
    pub fn surface(nx: usize, ny: usize, aspect: f64, mut heights: Vec<f64>) -> Result<Self, Refusal> {
        require_positive("aspect", aspect)?;
        let shape_allowed = nx >= 4 && nx.is_multiple_of(2) && (ny == 1 || (ny >= 2 && ny.is_multiple_of(2)));
        if !shape_allowed || nx.checked_mul(ny) != Some(heights.len()) {
            return Err(Refusal::Undefined {
                quantity: "the profile",
                reason: format!(
                    "{} heights do not fill {ny} rows of {nx} (an even number of at least 4 along x; 1 or an even number along y)",
                    heights.len()
                ),
            });
        }
        for &h in &heights {
            require_finite("height", h)?;
        }
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        heights.iter_mut().for_each(|h| *h -= mean);
        let profile = Self { nx, ny, heights, aspect };
        require_positive("half of the peak-to-valley height", profile.half_height())?;
        Ok(profile)
    }

    /// The same profile with its heights multiplied by a factor, finite and not zero.
    ///
    /// # Errors
    /// As [`Profile::surface`].
    pub fn scaled(&self, factor: f64) -> Result<Self, Refusal> {
        Self::surface(self.nx, self.ny, self.aspect, self.heights.iter().map(|h| h * factor).collect())
    }

    /// The mirror image x → −x: what slides towards −x over a body slides towards +x over its mirror image.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let row = |row: &[f64]| row.iter().take(1).chain(row.iter().skip(1).rev()).copied().collect::<Vec<_>>();
        Self { heights: self.heights.chunks(self.nx).flat_map(row).collect(), ..self.clone() }
    }

    /// The numbers of its own nodes along x and y.
    #[must_use]
    pub const fn nodes(&self) -> [usize; 2] {
        [self.nx, self.ny]
    }

    /// Its heights (Λ) at its own nodes, row by row along x, of zero mean.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The amplitude (Λ) of each wave number 1, 2 … along x: half of the peak-to-valley height of that wave; of a surface the root of the sum
    /// of squares over all waves across.
    #[must_use]
    pub fn amplitudes(&self) -> Vec<f64> {
        let mut transform = Transform::new(self.nx, self.ny);
        let spectrum = transform.forward(&self.heights);
        let of = |number: usize| {
            let squares: f64 = spectrum[number * self.ny..(number + 1) * self.ny].iter().map(|c| c.norm_sqr()).sum();
            let both = if 2 * number == self.nx { 1.0 } else { 2.0 };
            both * squares.sqrt() / self.heights.len() as f64
        };
        (1..=self.nx / 2).map(of).collect()
    }

    /// Half of the peak-to-valley height (Λ).
    #[must_use]
    pub fn half_height(&self) -> f64 {
        let (low, high) = self.heights.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &h| (a.min(h), b.max(h)));
        0.5 * (high - low)
    }

    /// Whether it is a line.
    #[must_use]
    pub const fn is_line(&self) -> bool {
        self.ny == 1
    }

    /// Nodes along y that belong to `nx` nodes along x.
    pub(super) fn rows(&self, nx: usize) -> usize {
        if self.ny == 1 { 1 } else { ((nx * self.ny / self.nx).max(4) + 1) & !1 }
    }

    pub(super) const fn own_nx(&self) -> usize {
        self.nx
    }

    /// Period along y over the period along x.
    #[must_use]
    pub const fn aspect(&self) -> f64 {
        self.aspect
    }

    /// The heights on another grid, by adding zeros to the spectrum or cutting it.
    pub(super) fn on_grid(&self, grid: &mut Transform) -> Vec<f64> {
        let mut own = Transform::new(self.nx, self.ny);
        let from = own.forward(&self.heights).to_vec();
        let mut out = vec![0.0; grid.len()];
        let (nx, ny) = (grid.nx(), grid.ny());
        let spectrum = grid.forward(&out);
        let (common_x, common_y) = (nx.min(self.nx) / 2, ny.min(self.ny) / 2);
        for x in 0..=common_x {
            // The highest wave number of an even grid stands for both signs: half of it goes to each where the other grid is finer.
            let share_x = if x == self.nx / 2 && nx > self.nx { 0.5 } else { 1.0 };
            for y in -(common_y as isize)..=common_y as isize {
                if y != 0 && y.unsigned_abs() == common_y && y < 0 && ny <= self.ny {
                    continue;
                }
                let share_y = if y != 0 && y.unsigned_abs() == self.ny / 2 && ny > self.ny { 0.5 } else { 1.0 };
                let source = from[x * self.ny + y.rem_euclid(self.ny as isize) as usize];
                spectrum[x * ny + y.rem_euclid(ny as isize) as usize] = source * (share_x * share_y / self.heights.len() as f64);
            }
        }
        spectrum[0] = Complex64::default();
        grid.inverse(&mut out);
        out
    }
}

/// What the rig imposes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Control {
    /// The mean pressure (unit E0*kΛ/2, compression positive).
    MeanPressure(f64),
    /// The mean gap between the profile's mean plane and the mean plane of the deformed body (Λ).
    MeanGap(f64),
    /// A frame: mean pressure = stiffness · (mean gap − position); `stiffness` in pressure per Λ.
    Frame {
        /// Stiffness of the rig per area, positive (pressure unit per Λ).
        stiffness: f64,
        /// The mean gap (Λ) at which the rig carries no load; at a larger gap it presses.
        position: f64,
    },
}

impl Control {
    /// The stiffness with which it is held (pressure unit per Λ): zero of a pressure, infinite of a gap.
    #[must_use]
    pub const fn stiffness(self) -> f64 {
        match self {
            Self::MeanPressure(_) => 0.0,
            Self::MeanGap(_) => f64::INFINITY,
            Self::Frame { stiffness, .. } => stiffness,
        }
    }

    /// The equation gap_factor · mean gap + pressure_factor · mean pressure = value.
    pub(super) const fn row(self) -> [f64; 3] {
        match self {
            Self::MeanPressure(p) => [0.0, 1.0, p],
            Self::MeanGap(s) => [1.0, 0.0, s],
            Self::Frame { stiffness, position } => [-stiffness, 1.0, -stiffness * position],
        }
    }
}

/// A steady state that is asked for.
#[derive(Clone)]
pub struct Problem {
    /// The profile; it moves towards +x.
    pub profile: Profile,
    /// E(ω)/E0, with ω in the unit of `speed`.
    pub modulus: Modulus,
    /// kv ≥ 0, the angular frequency of the first harmonic; zero is the relaxed elastic body.
    pub speed: f64,
    /// The law between the surfaces (range in Λ, stresses in the pressure unit, work of adhesion in their product).
    pub attraction: Attraction,
    /// A layer instead of a half-space; its thickness is kd.
    pub layer: Option<Layer>,
    /// What is imposed: mean pressure, mean gap or the position of a frame.
    pub control: Control,
}

impl Problem {
    /// A half-space; on a layer `Problem { layer, ..Problem::new(…) }`.
    #[must_use]
    pub fn new(profile: Profile, modulus: Modulus, speed: f64, attraction: Attraction, control: Control) -> Self {
        Self { profile, modulus, speed, attraction, layer: None, control }
    }

    /// Refuses what has no meaning, before anything is computed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or infinite speed, a law that [`Attraction::new`] refuses, a control that is not finite, a frame
    /// without positive stiffness, or a modulus that is not one at rest, or is not finite, not positive, or gains energy at a frequency kv·2^j,
    /// j = 0…23; [`Refusal::NoSuchState`] for a hard wall alone that is not pressed.
    pub fn check(&self) -> Result<(), Refusal> {
        require_non_negative("speed", self.speed)?;
        Attraction::new(self.attraction.law.clone(), self.attraction.work_of_adhesion, self.attraction.range)?;
        if let (Control::MeanPressure(pressure), false) = (self.control, self.attraction.attracts())
            && pressure <= 0.0
        {
            return Err(Refusal::NoSuchState {
                reason: "without adhesion nothing holds a contact that is not pressed".to_owned(),
                limit_name: "the mean pressure",
                limit: 0.0,
            });
        }
        for value in self.control.row() {
            require_finite("control", value)?;
        }
        if let Control::Frame { stiffness, .. } = self.control {
            require_positive("frame stiffness", stiffness)?;
        }
        let rest = (self.modulus)(0.0);
        if (rest - 1.0).norm() > 1e-9 {
            return Err(Refusal::out_of_range("modulus at rest over E0", rest.re, "one"));
        }
        for octave in 0..24 {
            let modulus = (self.modulus)(self.speed * f64::from(1_u32 << octave));
            require_positive("storage modulus", modulus.re)?;
            require_non_negative("loss modulus", modulus.im)?;
        }
        Ok(())
    }

    /// The stiffness A(n_x, n_y): pressure over gap for each wave number, zero for the mean. Between the relaxed elastic body
    /// (`stiffening` = 0) and the real one (1) the modulus is E^stiffening, which is a path for continuation.
    pub(super) fn stiffness(&self, grid: &Transform, stiffening: f64) -> Vec<Complex64> {
        let size = (grid.nx() / 2 + 1) * grid.ny();
        let mut last = (usize::MAX, Complex64::default());
        (0..size)
            .map(|entry| {
                let (x, y) = grid.wave_numbers(entry);
                let number = (x as f64).hypot(y as f64 / self.profile.aspect());
                if number == 0.0 {
                    return Complex64::default();
                }
                if last.0 != x {
                    let modulus = (self.modulus)(x as f64 * self.speed);
                    // The highest wave number along x stands for both directions, so its factor is real.
                    let modulus = if 2 * x == grid.nx() { Complex64::from(modulus.norm()) } else { modulus };
                    last = (x, if stiffening < 1.0 { modulus.powf(stiffening) } else { modulus }.conj());
                }
                last.1 * number / self.layer.map_or(1.0, |layer| layer.compliance_factor(number))
            })
            .collect()
    }
}
