//! Laws of attraction: the stress between two surfaces as a function of their gap.
//!
//! A law is a shape, a work of adhesion W and a range r. With u = g/r the stress is (W/r) s(u), so that every law does the same work
//! ∫ tension dg = W from its place of zero stress (or its hard wall) to infinity. **Stress is positive in compression** like every
//! pressure here; tension is negative.
//!
//! | law | s(u) | largest tension × r/W | at u | below |
//! |---|---|---|---|---|
//! | exponential | −e^{−u} | 1 | 0 | hard wall at 0 |
//! | Dugdale | −1 up to u = 1−η, then a cubic ramp to zero at 1+η | 1 | 0…1−η | hard wall at 0 |
//! | Lennard-Jones 3-9 | (8/3)(u⁻⁹ − u⁻³) | 16/(9√3) = 1.0264 | 3^{1/6} | steep repulsion, no wall |
//! | cosine | −(π/2) sin πu for 0 < u < 1, −(π²/2) u for u < 0 | π/2 | ½ | linear repulsion, no wall |
//! | table | a monotone cubic through the given points | of the table | of the table | wall at the first gap, or linear repulsion |
//! | hard wall | 0: no attraction, no work | 0 | | hard wall at 0 |
//!
//! Sources: Greenwood (1997) for 3-9; the cosine law with its harmonic wall is the one of Wang & Müser's contMech runs.
//! Lengths and stresses are in any one consistent set of units (SI, or the reduced units of the problem that uses the law).

mod table;

pub use table::Table;

use std::f64::consts::PI;

use crate::refusal::{Refusal, require_positive};

/// The shape of a law of attraction, for unit work of adhesion and unit range.
#[derive(Debug, Clone, PartialEq)]
pub enum Law {
    /// 3-9 Lennard-Jones between half-spaces; the range is the gap of zero stress.
    LennardJones,
    /// Exponential decay on a hard wall; the range is the decay length.
    Exponential,
    /// Constant tension on a hard wall; the tension ends over a smooth ramp of half-width `ramp` times the range, 0 < `ramp` < 1.
    Dugdale {
        /// η, the half-width of the ramp over the range (0.1 is the usual choice).
        ramp: f64,
    },
    /// Sine-shaped tension that starts from zero at contact, with a harmonic wall of the same slope; zero beyond the range.
    Cosine,
    /// Measured or computed points; made by [`Attraction::from_table`].
    Table(Table),
    /// No attraction: the control case of every other law; made by [`Attraction::hard_wall`].
    HardWall,
}

/// A law of attraction with its two constants.
#[derive(Debug, Clone, PartialEq)]
pub struct Attraction {
    /// The shape.
    pub law: Law,
    /// W > 0: the work per area from the place of zero stress (or the wall) to infinity; zero of a hard wall alone.
    pub work_of_adhesion: f64,
    /// r > 0: the length that scales the gap (see [`Law`] for its meaning in each law).
    pub range: f64,
}

impl Attraction {
    /// A law with its work of adhesion and range. A hard wall ignores both constants.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless both constants are positive and finite and a Dugdale ramp lies between 0 and 1.
    pub fn new(law: Law, work_of_adhesion: f64, range: f64) -> Result<Self, Refusal> {
        if law == Law::HardWall {
            return Ok(Self::hard_wall());
        }
        require_positive("work_of_adhesion", work_of_adhesion)?;
        require_positive("range", range)?;
        if let Law::Dugdale { ramp } = law
            && !(ramp > 0.0 && ramp < 1.0)
        {
            return Err(Refusal::out_of_range("ramp", ramp, "between 0 and 1, both excluded"));
        }
        Ok(Self { law, work_of_adhesion, range })
    }

    /// No attraction, only a hard wall at the gap zero.
    #[must_use]
    pub const fn hard_wall() -> Self {
        Self { law: Law::HardWall, work_of_adhesion: 0.0, range: 1.0 }
    }

    /// Whether there is any attraction.
    #[must_use]
    pub const fn attracts(&self) -> bool {
        !matches!(self.law, Law::HardWall)
    }

    /// The same law with its gaps and stresses in other units: divided by these two, both positive. The work of adhesion is divided by their product.
    ///
    /// # Errors
    /// As [`Attraction::new`], where the quotients are no positive numbers.
    pub fn in_units(&self, gap: f64, stress: f64) -> Result<Self, Refusal> {
        if !self.attracts() {
            return Ok(self.clone());
        }
        Self::new(self.law.clone(), self.work_of_adhesion / (gap * stress), self.range / gap)
    }

    /// A law with its work of adhesion and its largest tension (a positive number); the range follows.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless the tension is positive and finite; otherwise as [`Attraction::new`].
    pub fn with_peak_stress(law: Law, work_of_adhesion: f64, peak_stress: f64) -> Result<Self, Refusal> {
        require_positive("peak_stress", peak_stress)?;
        let unit = Self::new(law, work_of_adhesion, 1.0)?;
        let range = unit.peak_stress() / peak_stress;
        Self::new(unit.law, work_of_adhesion, range)
    }

    /// A law through points (gap, stress), stress positive in compression. From the last gap on the stress is zero,
    /// whatever the last stress says. Between the points: monotone cubics (Fritsch & Carlson, 1980).
    /// The work of adhesion is the integral of the tension; the range is that work over the largest tension.
    /// If the first stress is compressive the repulsion goes on linearly below it, otherwise there is a hard wall at the first gap.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] unless there are at least three increasing finite gaps with as many finite stresses, tension somewhere, and no
    /// repulsion beyond the first tension; [`Refusal::OutOfRange`] if the work or the largest tension is not positive.
    pub fn from_table(gaps: &[f64], stresses: &[f64]) -> Result<Self, Refusal> {
        let (table, work, range) = Table::reduced(gaps, stresses)?;
        Self::new(Law::Table(table), work, range)
    }

    /// The stress at a gap (unit W/r), positive in compression. Below a hard wall it has no meaning.
    #[must_use]
    pub fn stress(&self, gap: f64) -> f64 {
        self.work_of_adhesion / self.range * self.law.stress(gap / self.range)
    }

    /// The derivative of [`Attraction::stress`] with respect to the gap: positive where the tension falls as the surfaces part
    /// (unit W/r²).
    #[must_use]
    pub fn slope(&self, gap: f64) -> f64 {
        self.work_of_adhesion / (self.range * self.range) * self.law.slope(gap / self.range)
    }

    /// The integral of the tension (−stress) from the gap to infinity: the work per area still to be done to part the
    /// surfaces. It is W at [`Attraction::equilibrium_gap`] and zero at infinity.
    #[must_use]
    pub fn work_left(&self, gap: f64) -> f64 {
        self.work_of_adhesion * self.law.work_left(gap / self.range)
    }

    /// The largest tension, a positive number (unit W/r); zero for a hard wall alone.
    #[must_use]
    pub fn peak_stress(&self) -> f64 {
        self.work_of_adhesion / self.range * self.law.peak()
    }

    /// The gap at which the tension is largest (the smallest one, where several are).
    #[must_use]
    pub fn peak_gap(&self) -> f64 {
        self.range
            * match &self.law {
                Law::LennardJones => 3.0_f64.powf(1.0 / 6.0),
                Law::Cosine => 0.5,
                Law::Exponential | Law::Dugdale { .. } | Law::HardWall => 0.0,
                Law::Table(table) => table.peak_gap(),
            }
    }

    /// The largest rise of the stress with the gap (unit W/r², zero or more): the stiffness per area below which surfaces jump.
    #[must_use]
    pub fn steepest_slope(&self) -> f64 {
        self.work_of_adhesion / (self.range * self.range) * self.law.steepest()
    }

    /// Gaps where the slope or the curvature of the law jumps, in increasing order (the hard wall is not among them).
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        self.law.kinks().into_iter().map(|u| u * self.range).collect()
    }

    /// Whether the pressure has a kink or a square root somewhere: a hard wall, or a kink of the stress.
    #[must_use]
    pub fn is_kinked(&self) -> bool {
        self.wall().is_some() || !self.kinks().is_empty()
    }

    /// The gap at which the stress is zero and below which it repels; of a law with a hard wall, the wall.
    #[must_use]
    pub fn equilibrium_gap(&self) -> f64 {
        self.range
            * match &self.law {
                Law::LennardJones => 1.0,
                Law::Cosine | Law::Exponential | Law::Dugdale { .. } | Law::HardWall => 0.0,
                Law::Table(table) => table.wall().unwrap_or_else(|| table.zero()),
            }
    }

    /// The gap of the hard wall, if the law has one: no smaller gap is allowed.
    #[must_use]
    pub fn wall(&self) -> Option<f64> {
        self.law.wall().map(|u| u * self.range)
    }
}

impl Law {
    fn stress(&self, u: f64) -> f64 {
        match self {
            Self::LennardJones => {
                let c = 1.0 / (u * u * u);
                8.0 / 3.0 * (c * c * c - c)
            }
            Self::Exponential => -(-u).exp(),
            Self::Dugdale { ramp } => {
                let t = ramp_place(u, *ramp);
                t * t * (3.0 - 2.0 * t) - 1.0
            }
            Self::Cosine if u < 0.0 => -0.5 * PI * PI * u,
            Self::Cosine if u < 1.0 => -0.5 * PI * (PI * u).sin(),
            Self::Cosine => 0.0,
            Self::Table(table) => table.stress(u),
            Self::HardWall => 0.0,
        }
    }

    fn slope(&self, u: f64) -> f64 {
        match self {
            Self::LennardJones => {
                let c = 1.0 / (u * u * u);
                8.0 * (c - 3.0 * c * c * c) / u
            }
            Self::Exponential => (-u).exp(),
            Self::Dugdale { ramp } => {
                let t = ramp_place(u, *ramp);
                3.0 * t * (1.0 - t) / ramp
            }
            Self::Cosine if u < 0.0 => -0.5 * PI * PI,
            Self::Cosine if u < 1.0 => -0.5 * PI * PI * (PI * u).cos(),
            Self::Cosine => 0.0,
            Self::Table(table) => table.slope(u),
            Self::HardWall => 0.0,
        }
    }

    fn work_left(&self, u: f64) -> f64 {
        match self {
            Self::LennardJones => {
                let s = 1.0 / (u * u);
                8.0 / 3.0 * s * (0.5 - s * s * s / 8.0)
            }
            Self::Exponential => (-u).exp(),
            Self::Dugdale { ramp } => {
                let t = ramp_place(u, *ramp);
                let plateau = (1.0 - ramp - u).max(0.0);
                plateau + 2.0 * ramp * (0.5 - t + t * t * t * (1.0 - 0.5 * t))
            }
            Self::Cosine if u < 0.0 => 1.0 - 0.25 * PI * PI * u * u,
            Self::Cosine if u < 1.0 => 0.5 * (1.0 + (PI * u).cos()),
            Self::Cosine => 0.0,
            Self::Table(table) => table.work_left(u),
            Self::HardWall => 0.0,
        }
    }

    fn peak(&self) -> f64 {
        match self {
            Self::LennardJones => 16.0 / (9.0 * 3.0_f64.sqrt()),
            Self::Cosine => 0.5 * PI,
            Self::Exponential | Self::Dugdale { .. } | Self::Table(_) => 1.0,
            Self::HardWall => 0.0,
        }
    }

    fn steepest(&self) -> f64 {
        match self {
            Self::LennardJones => self.slope(7.5_f64.powf(1.0 / 6.0)),
            Self::Exponential => 1.0,
            Self::Dugdale { ramp } => 0.75 / ramp,
            Self::Cosine => 0.5 * PI * PI,
            Self::Table(table) => table.steepest(),
            Self::HardWall => 0.0,
        }
    }

    fn kinks(&self) -> Vec<f64> {
        match self {
            Self::LennardJones | Self::Exponential | Self::HardWall => Vec::new(),
            Self::Dugdale { ramp } => vec![1.0 - ramp, 1.0 + ramp],
            Self::Cosine => vec![1.0],
            Self::Table(table) => table.points().to_vec(),
        }
    }

    fn wall(&self) -> Option<f64> {
        match self {
            Self::LennardJones | Self::Cosine => None,
            Self::Exponential | Self::Dugdale { .. } | Self::HardWall => Some(0.0),
            Self::Table(table) => table.wall(),
        }
    }
}

/// Where a gap lies on the ramp of the Dugdale law: 0 before it, 1 beyond it.
fn ramp_place(u: f64, ramp: f64) -> f64 {
    ((u - 1.0 + ramp) / (2.0 * ramp)).clamp(0.0, 1.0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::needless_range_loop)]
mod tests {
    use super::*;

    fn laws() -> Vec<Attraction> {
        let mut all: Vec<Attraction> = [Law::LennardJones, Law::Exponential, Law::Dugdale { ramp: 0.1 }, Law::Cosine]
            .into_iter()
            .map(|law| Attraction::new(law, 0.7, 0.3).unwrap())
            .collect();
        let gaps: Vec<f64> = (0..60).map(|i| 0.22 + 0.02 * f64::from(i)).collect();
        let stresses: Vec<f64> = gaps.iter().map(|&g| all[0].stress(g)).collect();
        all.push(Attraction::from_table(&gaps, &stresses).unwrap());
        all
    }

    #[test]
    fn the_slope_and_the_work_are_the_derivative_and_the_integral_of_the_stress() {
        for law in laws() {
            for i in 0..40 {
                let (g, h) = (0.262 + 0.0171 * f64::from(i), 1e-6);
                let difference = (law.stress(g + h) - law.stress(g - h)) / (2.0 * h);
                assert!((difference - law.slope(g)).abs() < 1e-5 * law.steepest_slope().max(difference.abs()), "{law:?} at {g}");
                let tension = (law.work_left(g - h) - law.work_left(g + h)) / (2.0 * h);
                assert!((tension + law.stress(g)).abs() < 1e-6 * law.peak_stress().max(tension.abs()), "{law:?} at {g}");
                assert!(law.slope(g) <= law.steepest_slope() * (1.0 + 1e-12));
                assert!(-law.stress(g) <= law.peak_stress() * (1.0 + 1e-12));
            }
        }
    }

    #[test]
    fn each_law_does_its_work_from_its_place_of_zero_stress() {
        for law in laws() {
            let start = match law.law {
                Law::LennardJones => law.range,
                Law::Table(_) => 0.3,
                _ => 0.0,
            };
            assert!((law.work_left(start) / law.work_of_adhesion - 1.0).abs() < 1e-3, "{law:?}");
        }
    }
}
