//! The penetration within an interval of time, Δ(x) = Δ₀ + Σ w_k (x/T)^k + A(sin(φ + ωx) − sin φ), 0 ≤ x ≤ T, and what it does to a point in contact.

/// Highest power of the time.
pub(super) const DEGREE: usize = 8;

/// An oscillation of one frequency upon a polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wave {
    pub(super) amplitude: f64,
    /// ω (rad/s) and φ (rad).
    pub(super) pace: f64,
    pub(super) phase: f64,
}

/// Δ(x).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drive {
    pub(super) start: f64,
    /// T (s).
    pub(super) duration: f64,
    powers: [f64; DEGREE],
    used: usize,
    wave: Option<Wave>,
}

impl Drive {
    pub(super) fn straight(start: f64, end: f64, duration: f64) -> Self {
        let mut powers = [0.0; DEGREE];
        powers[0] = end - start;
        Self { start, duration, powers, used: 1, wave: None }
    }

    pub(super) fn with_wave(mut self, wave: Wave) -> Self {
        self.wave = Some(wave);
        self
    }

    /// The polynomial through places x/T of 0…1, none of them 0, with Δ − Δ₀ there.
    pub(super) fn through(start: f64, duration: f64, points: &[(f64, f64)]) -> Self {
        // Newton's divided differences of (Δ − Δ₀)/(x/T), a polynomial of one degree less, then as powers.
        let points = points.get(..points.len().min(DEGREE)).unwrap_or(points);
        let count = points.len();
        let mut divided: Vec<f64> = points.iter().map(|(place, rise)| rise / place).collect();
        for order in 1..count {
            for k in (order..count).rev() {
                divided[k] = (divided[k] - divided[k - 1]) / (points[k].0 - points[k - order].0);
            }
        }
        let mut powers = [0.0; DEGREE];
        for k in (0..count).rev() {
            // p ← p·(y − y_k) + d_k
            for l in (1..DEGREE).rev() {
                powers[l] = powers[l - 1] - points[k].0 * powers[l];
            }
            powers[0] = divided[k] - points[k].0 * powers[0];
        }
        Self { start, duration, powers, used: count.max(1), wave: None }
    }

    /// The polynomial of highest degree through a function of the time.
    pub(super) fn fitted(start: f64, duration: f64, mut value: impl FnMut(f64) -> f64) -> Self {
        let points: [(f64, f64); DEGREE] = std::array::from_fn(|k| {
            let place = (0.5 - 0.5 * (std::f64::consts::PI * (k as f64 + 1.0) / DEGREE as f64).cos()).min(1.0);
            (place, value(place * duration) - start)
        });
        Self::through(start, duration, &points)
    }

    pub(super) fn value(&self, x: f64) -> f64 {
        let y = x / self.duration;
        let polynomial = self.powers[..self.used].iter().rev().fold(0.0, |sum, power| (sum + power) * y);
        // sin(φ + ωx) − sin φ without loss for short times.
        let wave = self.wave.map_or(0.0, |w| {
            let half = 0.5 * w.pace * x;
            2.0 * w.amplitude * half.sin() * (w.phase + half).cos()
        });
        self.start + polynomial + wave
    }

    pub(super) fn rate(&self, x: f64) -> f64 {
        let y = x / self.duration;
        let slope = self.powers[..self.used].iter().enumerate().rev().fold(0.0, |sum, (k, power)| sum * y + (k as f64 + 1.0) * power);
        slope / self.duration + self.wave.map_or(0.0, |w| w.amplitude * w.pace * (w.phase + w.pace * x).cos())
    }

    /// What a slow or a fast term gains, as powers of the time: u′ = Δ′ − (T/ρ)u, from u = 0. A fast one follows Δ′ with a lag, which the rest forgets.
    pub(super) fn series(&self, rho: f64) -> Option<Gain> {
        let z = self.duration / rho;
        if self.wave.is_some() {
            return None;
        }
        let mut powers = [0.0; LONGEST_SERIES];
        if z >= (FAST * self.used as f64).max(SLOW) {
            // zP_k = (k + 1)(w_{k+1} − P_{k+1}), downwards, where it shrinks.
            let (mut above, over) = (0.0, z.recip());
            for k in (0..self.used).rev() {
                if let Some(power) = powers.get_mut(k) {
                    *power = above;
                }
                above = (k as f64 + 1.0) * over * (self.powers[k] - above);
            }
            return Some(Gain { powers, used: self.used, lag: above });
        }
        if z > SLOW {
            return None;
        }
        let (mut last, mut used) = (0.0, LONGEST_SERIES);
        let largest = self.powers[..self.used].iter().fold(0.0, |most: f64, power| most.max(power.abs()));
        for (k, power) in powers.iter_mut().enumerate() {
            let order = (k + 1) as f64;
            last = self.powers.get(k).copied().unwrap_or(0.0) - z * last / order;
            *power = last;
            if k >= self.used && last.abs() <= 1e-3 * f64::EPSILON * largest {
                used = k;
                break;
            }
        }
        Some(Gain { powers, used, lag: 0.0 })
    }

    pub(super) fn end(&self) -> f64 {
        self.value(self.duration)
    }

    /// What is left of it after a time.
    pub(super) fn rest(&self, x: f64) -> Self {
        let part = x / self.duration;
        let left = 1.0 - part;
        let mut shifted = [0.0; DEGREE];
        shift(&self.powers[..self.used], part, left, &mut shifted);
        let wave = self.wave.map(|w| Wave { phase: w.phase + w.pace * x, ..w });
        Self { start: self.value(x), duration: self.duration - x, powers: shifted, used: self.used, wave }
    }

    /// The first part of it.
    pub(super) fn until(&self, x: f64) -> Self {
        let part = x / self.duration;
        let mut scale = 1.0;
        let powers = self.powers.map(|power| {
            scale *= part;
            power * scale
        });
        Self { duration: x, powers, ..*self }
    }

    /// ∫₀^x e^{−(x − x′)/ρ}Δ̇ dx′; `kept`: e^{−x/ρ}.
    pub(super) fn gained(&self, rho: f64, x: f64, kept: f64) -> f64 {
        let z = x / rho;
        let y = x / self.duration;
        let lost = || -(-z).exp_m1();
        let mut gained = if self.used == 1 {
            self.powers[0] * y * if z > 0.0 { lost() / z } else { 1.0 }
        } else {
            let factors = means(z, kept);
            self.powers[..self.used].iter().zip(factors).rev().fold(0.0, |sum, (power, factor)| (sum + power * factor) * y)
        };
        if let Some(w) = self.wave {
            // A·Im[c(e^{iωx} − e^{−x/ρ})e^{iφ}], c = iωρ/(1 + iωρ), by parts that vanish with x.
            let a = w.pace * rho;
            let (real, imaginary) = (a / (1.0 / a + a), 1.0 / (1.0 / a + a));
            let half = (0.5 * w.pace * x).sin();
            let (along, across) = (-2.0 * half * half + lost(), (w.pace * x).sin());
            let (first, second) = (real * along - imaginary * across, real * across + imaginary * along);
            gained += w.amplitude * (first * w.phase.sin() + second * w.phase.cos());
        }
        gained
    }
}

/// Σ w_k (part + left·y)^k as powers of y, without the constant.
fn shift(powers: &[f64], part: f64, left: f64, shifted: &mut [f64; DEGREE]) {
    let mut value = 0.0;
    for power in powers.iter().rev() {
        value += power;
        for k in (0..DEGREE).rev() {
            let below = if k == 0 { value } else { shifted[k - 1] };
            shifted[k] = shifted[k] * part + below * left;
        }
        value *= part;
    }
}

/// What a term gains along a polynomial: lag·(1 − e^{−x/ρ}) and powers 1… of the time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gain {
    powers: [f64; LONGEST_SERIES],
    used: usize,
    lag: f64,
}

impl Gain {
    pub(super) const NONE: Self = Self { powers: [0.0; LONGEST_SERIES], used: 0, lag: 0.0 };

    pub(super) const fn lag(&self) -> f64 {
        self.lag
    }

    /// All but what decays, at a part of the time.
    pub(super) fn steady(&self, y: f64) -> f64 {
        // Four sums at a time: one waits for itself.
        let square = y * y;
        let fourth = square * square;
        let mut sums = [0.0; 4];
        for powers in self.powers.chunks_exact(4).take(self.used.div_ceil(4)).rev() {
            for (sum, power) in sums.iter_mut().zip(powers) {
                *sum = *sum * fourth + power;
            }
        }
        self.lag + y * ((sums[0] + square * sums[2]) + y * (sums[1] + square * sums[3]))
    }

    pub(super) fn add(&mut self, weight: f64, other: &Self) {
        self.used = self.used.max(other.used);
        self.lag += weight * other.lag;
        for (own, power) in self.powers.iter_mut().zip(&other.powers).take(other.used) {
            *own += weight * power;
        }
    }
}

/// Terms of a series, four by four.
const LONGEST_SERIES: usize = DEGREE + 28;
/// Longest drive, over the time of a term, of which a slow term's series is of use, and shortest one, over that and the powers of Δ, of a fast one.
const SLOW: f64 = 2.0;
const FAST: f64 = 0.5;

/// e^{−z}: what has decayed below all digits takes no time.
pub(super) fn decayed(z: f64) -> f64 {
    if z > 740.0 { 0.0 } else { (-z).exp() }
}

/// 1/k, k = 1…: divisions would take most of the time of a drive.
const RECIPROCALS: [f64; DEGREE + 60] = {
    let mut values = [0.0; DEGREE + 60];
    let mut k = 0;
    while k < values.len() {
        values[k] = 1.0 / (k + 1) as f64;
        k += 1;
    }
    values
};

/// χ_k(z) = ∫₀¹ k s^{k−1}e^{−z(1−s)}ds: χ_k = (k/z)(1 − χ_{k−1}), upwards while k < z, and downwards from a series to there: errors shrink both ways.
pub(super) fn means(z: f64, kept: f64) -> [f64; DEGREE] {
    let mut values = [0.0; DEGREE];
    let turn = (z as usize).min(DEGREE);
    let (mut last, over) = (kept, z.recip());
    for (k, value) in values.iter_mut().take(turn).enumerate() {
        last = (k as f64 + 1.0) * over * (1.0 - last);
        *value = last;
    }
    if turn == DEGREE {
        return values;
    }
    let (mut term, mut sum): (f64, f64) = (1.0, 0.0);
    for over in RECIPROCALS.iter().skip(DEGREE) {
        let next = sum + term;
        if next.to_bits() == sum.to_bits() {
            break;
        }
        sum = next;
        term *= -z * over;
    }
    for (value, over) in values.iter_mut().zip(&RECIPROCALS).skip(turn).rev() {
        *value = sum;
        sum = 1.0 - z * sum * over;
    }
    values
}
