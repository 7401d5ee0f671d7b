//! Standard normal numbers from a seed, by Box and Muller's transform.

use super::split_mix::SplitMix;

/// A stream of numbers.
#[derive(Debug, Clone)]
pub struct Normal(SplitMix);

impl Normal {
    /// The stream of one draw of a seed: any draw can be made alone.
    #[must_use]
    pub fn of(seed: u64, draw: u64) -> Self {
        Self(SplitMix::of(seed, draw))
    }

    /// Uniform in (0, 1].
    pub fn unit(&mut self) -> f64 {
        ((self.0.bits() >> 11) as f64 + 1.0) / (1_u64 << 53) as f64
    }

    /// A standard normal number.
    pub fn sample(&mut self) -> f64 {
        (-2.0 * self.unit().ln()).sqrt() * (std::f64::consts::TAU * self.unit()).cos()
    }
}

#[cfg(test)]
mod tests {
    use super::Normal;

    #[test]
    fn mean_and_variance_are_those_of_a_standard_normal() {
        let mut stream = Normal::of(7, 3);
        let numbers: Vec<f64> = (0..20_000).map(|_| stream.sample()).collect();
        let mean = numbers.iter().sum::<f64>() / 2e4;
        let variance = numbers.iter().map(|number| (number - mean).powi(2)).sum::<f64>() / 2e4;
        // Four standard deviations of both.
        assert!(mean.abs() < 4.0 / 2e4_f64.sqrt() && (variance - 1.0).abs() < 4.0 * (2.0 / 2e4_f64).sqrt());
    }
}
