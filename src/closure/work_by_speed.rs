//! A work of adhesion that depends on the speed of the edge: a law or a table given by the user.
//!
//! ```text
//! law      Δγ(v) = Δγ₀ (1 + (v/v₀)ⁿ)                                  at both edges, n > 0
//! table    ln Δγ_i linear in ln v between two entries, held beyond the ends      i = trailing (opening), leading (closing)
//! ```
//! It stands for what happens inside the process zone (bonds that take time to part or to form), which the viscoelastic solid around it does not know
//! of: G₀(v) in place of Δγ (thesis Sec 3.1). Both edges of a contact that slides steadily move at the sliding speed, whatever the contact does, so
//! that the works are two numbers at each speed; along a path in speed they change with it.

use crate::refusal::{Refusal, require_positive};

/// An entry of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorkAtSpeed {
    /// v (m/s), positive; kv (1/s) of a sliding contact.
    pub speed: f64,
    /// Δγ of the trailing edge, where the contact opens, in any unit; positive.
    pub trailing: f64,
    /// Δγ of the leading edge, where the contact closes, in the same unit; positive.
    pub leading: f64,
}

#[derive(Debug, Clone, PartialEq)]
enum Law {
    Power {
        speed: f64,
        exponent: f64,
    },
    /// Logarithms, speeds growing.
    Table(Vec<WorkAtSpeed>),
}

/// By what a work of adhesion is multiplied at a speed.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkBySpeed(Law);

impl WorkBySpeed {
    /// 1 + (v/v₀)ⁿ at both edges.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless both numbers are positive.
    pub fn power(reference_speed: f64, exponent: f64) -> Result<Self, Refusal> {
        let speed = require_positive("reference_speed", reference_speed)?;
        Ok(Self(Law::Power { speed, exponent: require_positive("exponent", exponent)? }))
    }

    /// The factors of a table, two entries at least, by growing speed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless all numbers are positive and the speeds grow.
    pub fn table(entries: &[WorkAtSpeed]) -> Result<Self, Refusal> {
        if entries.len() < 2 {
            return Err(Refusal::out_of_range("entries", entries.len() as f64, "2 or more: one entry is a constant"));
        }
        let mut logarithms: Vec<WorkAtSpeed> = Vec::with_capacity(entries.len());
        for entry in entries {
            let speed = require_positive("speed", entry.speed)?.ln();
            if logarithms.last().is_some_and(|last| last.speed >= speed) {
                return Err(Refusal::out_of_range("speed", entry.speed, "above the one before"));
            }
            let (trailing, leading) = (require_positive("trailing", entry.trailing)?, require_positive("leading", entry.leading)?);
            logarithms.push(WorkAtSpeed { speed, trailing: trailing.ln(), leading: leading.ln() });
        }
        Ok(Self(Law::Table(logarithms)))
    }

    /// The factors of the trailing and of the leading edge at a speed; that of speed zero is the limit.
    #[must_use]
    pub fn factors(&self, speed: f64) -> [f64; 2] {
        match &self.0 {
            Law::Power { speed: reference, exponent } => [1.0 + (speed / reference).powf(*exponent); 2],
            Law::Table(entries) => {
                let place = speed.ln();
                let after = entries.partition_point(|entry| entry.speed <= place);
                let at = |entry: &WorkAtSpeed| [entry.trailing.exp(), entry.leading.exp()];
                match (after.checked_sub(1).and_then(|before| entries.get(before)), entries.get(after)) {
                    (Some(low), Some(high)) => {
                        let part = (place - low.speed) / (high.speed - low.speed);
                        let between = |low: f64, high: f64| (low + part * (high - low)).exp();
                        [between(low.trailing, high.trailing), between(low.leading, high.leading)]
                    }
                    (Some(end), None) | (None, Some(end)) => at(end),
                    (None, None) => [f64::NAN; 2],
                }
            }
        }
    }

    /// The same law of a speed in another unit: v is given in multiples of `unit`.
    #[must_use]
    pub fn in_unit(&self, unit: f64) -> Self {
        Self(match &self.0 {
            Law::Power { speed, exponent } => Law::Power { speed: speed / unit, exponent: *exponent },
            Law::Table(entries) => {
                Law::Table(entries.iter().map(|entry| WorkAtSpeed { speed: entry.speed - unit.ln(), ..*entry }).collect())
            }
        })
    }

    /// Whether the factors of the trailing and of the leading edge fall, and whether they rise, anywhere with the speed.
    #[must_use]
    pub(crate) fn trends(&self) -> [(bool, bool); 2] {
        match &self.0 {
            Law::Power { .. } => [(false, true); 2],
            Law::Table(entries) => [|entry: &WorkAtSpeed| entry.trailing, |entry: &WorkAtSpeed| entry.leading].map(|of| {
                let changes = || entries.windows(2).filter_map(|pair| Some(of(pair.get(1)?) - of(pair.first()?)));
                (changes().any(|change| change < 0.0), changes().any(|change| change > 0.0))
            }),
        }
    }

    /// The slowest and the fastest speed of a table, beyond which its ends are held; none of a law.
    #[must_use]
    pub fn ends(&self) -> Option<[f64; 2]> {
        match &self.0 {
            Law::Power { .. } => None,
            Law::Table(entries) => Some([entries.first()?.speed.exp(), entries.last()?.speed.exp()]),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn close(found: f64, expected: f64) -> bool {
        (found - expected).abs() <= 1e-14 * expected.abs()
    }

    #[test]
    fn a_law_doubles_at_its_reference_speed() {
        let law = WorkBySpeed::power(3.0, 0.4).unwrap();
        assert!(law.factors(0.0).into_iter().all(|factor| close(factor, 1.0)));
        assert!(law.factors(3.0).into_iter().all(|factor| close(factor, 2.0)));
        // v/v₀ = 2⁵, n = 0.4.
        assert!(law.factors(96.0).into_iter().all(|factor| close(factor, 5.0)));
        assert!(law.in_unit(3.0).factors(32.0).into_iter().all(|factor| close(factor, 5.0)));
    }

    #[test]
    fn a_table_is_a_power_between_its_entries_and_held_beyond() {
        let entry = |speed: f64, trailing: f64, leading: f64| WorkAtSpeed { speed, trailing, leading };
        let table = WorkBySpeed::table(&[entry(1.0, 2.0, 2.0), entry(100.0, 32.0, 0.5), entry(1e4, 32.0, 0.5)]).unwrap();
        // ln v half way: geometric means.
        for (speed, trailing, leading) in
            [(1e-9, 2.0, 2.0), (0.0, 2.0, 2.0), (1.0, 2.0, 2.0), (10.0, 8.0, 1.0), (1e3, 32.0, 0.5), (1e9, 32.0, 0.5)]
        {
            let [first, second] = table.factors(speed);
            assert!(close(first, trailing) && close(second, leading), "{speed} {first} {second}");
            let [first, second] = table.in_unit(0.1).factors(10.0 * speed);
            assert!(close(first, trailing) && close(second, leading), "{speed} {first} {second}");
        }
    }

    #[test]
    fn what_is_no_law_is_refused() {
        let entry = |speed: f64, trailing: f64| WorkAtSpeed { speed, trailing, leading: 1.0 };
        for entries in [
            &[entry(1.0, 1.0)][..],
            &[entry(1.0, 1.0), entry(1.0, 2.0)],
            &[entry(1.0, 1.0), entry(2.0, 0.0)],
            &[entry(0.0, 1.0), entry(2.0, 1.0)],
        ] {
            assert!(WorkBySpeed::table(entries).is_err());
        }
        assert!(WorkBySpeed::power(0.0, 1.0).is_err() && WorkBySpeed::power(1.0, f64::NAN).is_err());
    }
}
