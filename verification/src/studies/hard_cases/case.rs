//! What a hard case is: why it is hard, what must come out, stated before the run, and what did.

use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;

/// What must come out. Tolerances are absolute and hold for the error of the value and for its bound: a wider bound is an accuracy that was not reached.
#[derive(Debug, Clone, PartialEq)]
pub enum Expected {
    /// A value.
    Value {
        /// Which.
        quantity: &'static str,
        /// Its value by theory.
        value: f64,
        /// Largest error, and largest bound.
        tolerance: f64,
    },
    /// A value between two bounds.
    Between {
        /// Which.
        quantity: &'static str,
        /// Smallest.
        low: f64,
        /// Largest.
        high: f64,
    },
    /// An outcome with a name: "never grows", "full contact", …
    Is(&'static str),
    /// No such state, with its witness: the limit that was passed.
    NoSuchState {
        /// The value of the limit by theory.
        limit: f64,
        /// Largest error of the limit.
        tolerance: f64,
    },
    /// The argument is refused, or the quantity does not exist: which of the two.
    Refused(Kind),
}

/// The kind of a refusal that is no witness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// [`Refusal::OutOfRange`].
    OutOfRange,
    /// [`Refusal::Undefined`].
    Undefined,
    /// Either: a number beyond what doubles hold may be found out at the door or inside.
    Either,
}

/// What came out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Found {
    /// Values by name.
    pub values: Vec<(&'static str, Estimate)>,
    /// Named outcomes.
    pub words: Vec<&'static str>,
    /// The refusal, if there was one.
    pub refusal: Option<Refusal>,
}

impl Found {
    /// A refusal.
    #[must_use]
    pub fn refused(refusal: Refusal) -> Self {
        Self { refusal: Some(refusal), ..Self::default() }
    }

    /// With one more value.
    #[must_use]
    pub fn with(mut self, quantity: &'static str, value: Estimate) -> Self {
        self.values.push((quantity, value));
        self
    }

    /// With one more named outcome.
    #[must_use]
    pub fn is(mut self, word: &'static str) -> Self {
        self.words.push(word);
        self
    }

    fn value(&self, quantity: &str) -> Result<Estimate, String> {
        match self.values.iter().find(|(name, _)| *name == quantity) {
            Some((_, value)) if value.value.is_finite() && value.error.is_finite() && value.error >= 0.0 => Ok(*value),
            Some((_, value)) => Err(format!("{quantity} = {:e} ± {:e} is no number with a bound", value.value, value.error)),
            None => Err(format!("no {quantity}: {}", self.reported())),
        }
    }

    /// In words.
    #[must_use]
    pub fn reported(&self) -> String {
        let mut parts: Vec<String> = self.words.iter().map(|word| (*word).to_owned()).collect();
        parts.extend(self.values.iter().map(|(name, value)| format!("{name} {:.12e} ± {:.0e}", value.value, value.error)));
        parts.extend(self.refusal.iter().map(ToString::to_string));
        parts.join("; ")
    }
}

/// A hard case.
pub struct HardCase {
    /// The problem it belongs to.
    pub problem: &'static str,
    /// Its name.
    pub name: String,
    /// Why it is hard.
    pub why: &'static str,
    /// By what theory the outcome is known.
    pub theory: &'static str,
    /// What must come out.
    pub expected: Vec<Expected>,
    /// Computes what does.
    pub run: Box<dyn Fn() -> Found + Send + Sync>,
}

impl HardCase {
    /// A case; a refusal of its run is an outcome like any other.
    pub fn new(
        problem: &'static str,
        name: impl Into<String>,
        why: &'static str,
        theory: &'static str,
        expected: Vec<Expected>,
        run: impl Fn() -> Result<Found, Refusal> + Send + Sync + 'static,
    ) -> Self {
        let run = move || run().unwrap_or_else(Found::refused);
        Self { problem, name: name.into(), why, theory, expected, run: Box::new(run) }
    }
}

/// Whether what was found is what was expected; otherwise what is not.
///
/// # Errors
/// What is not as expected, in words.
pub fn held(expected: &Expected, found: &Found) -> Result<(), String> {
    let ensure = |holds: bool, failure: String| if holds { Ok(()) } else { Err(failure) };
    match expected {
        Expected::Value { quantity, value, tolerance } => {
            let estimate = found.value(quantity)?;
            let off = (estimate.value - value).abs();
            ensure(
                off <= *tolerance,
                format!("{quantity} {:e} is off by {off:.1e} from {value:e}, {tolerance:.1e} allowed", estimate.value),
            )?;
            ensure(estimate.error <= *tolerance, format!("the bound {:.1e} of {quantity} is wider than {tolerance:.1e}", estimate.error))
        }
        Expected::Between { quantity, low, high } => {
            let estimate = found.value(quantity)?;
            ensure(
                estimate.value >= *low && estimate.value <= *high,
                format!("{quantity} {:e} is not between {low:e} and {high:e}", estimate.value),
            )
        }
        Expected::Is(word) => ensure(found.words.contains(word), format!("not \"{word}\": {}", found.reported())),
        Expected::NoSuchState { limit, tolerance } => match &found.refusal {
            Some(Refusal::NoSuchState { limit: witness, limit_name, .. }) => {
                let off = (witness - limit).abs();
                ensure(off <= *tolerance, format!("the witness {limit_name} = {witness:e} is off by {off:.1e} from {limit:e}"))
            }
            _ => Err(format!("a state where none exists: {}", found.reported())),
        },
        Expected::Refused(kind) => {
            let same = matches!(
                (&found.refusal, kind),
                (Some(Refusal::OutOfRange { .. }), Kind::OutOfRange | Kind::Either)
                    | (Some(Refusal::Undefined { .. }), Kind::Undefined | Kind::Either)
            );
            ensure(same, format!("not refused as {kind:?}: {}", found.reported()))
        }
    }
}

/// An expectation that is false where this one holds: the comparison must say no to it.
#[must_use]
pub fn falsified(expected: &Expected) -> Expected {
    match expected.clone() {
        Expected::Value { quantity, value, tolerance } => Expected::Value {
            quantity,
            value: value + 3.0 * tolerance.max(4.0 * f64::EPSILON * value.abs()).max(f64::MIN_POSITIVE),
            tolerance,
        },
        Expected::Between { quantity, low, high } => {
            let width = (high - low).max(high.abs()).max(1.0);
            Expected::Between { quantity, low: high + width, high: high + 2.0 * width }
        }
        Expected::Is(_) => Expected::Is("something else"),
        Expected::NoSuchState { limit, tolerance } => {
            Expected::NoSuchState { limit: limit + 3.0 * tolerance.max(4.0 * f64::EPSILON * limit.abs()).max(f64::MIN_POSITIVE), tolerance }
        }
        Expected::Refused(Kind::OutOfRange) => Expected::Refused(Kind::Undefined),
        Expected::Refused(Kind::Undefined) => Expected::Refused(Kind::OutOfRange),
        Expected::Refused(Kind::Either) => Expected::Is("an answer"),
    }
}

/// A value with a tolerance relative to it.
#[must_use]
pub fn near(quantity: &'static str, value: f64, relative: f64) -> Expected {
    Expected::Value { quantity, value, tolerance: relative * value.abs() }
}
