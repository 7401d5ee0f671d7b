//! Numbers with units: `"0.7 MPa"`, `"3 µm"`, `"1e-7 1/Pa"`, `"50 J/m^2"`, `"2 kPa s"`.
//!
//! A unit is factors separated by spaces, `*`, `·` or `.`; `/` divides by the factor, or the factors in brackets, that follow it; `^2`, `^-1`, `²`,
//! `⁻¹`, `**2`, `^0.5` and `^(1/2)` raise one factor to a power, and `√` before a factor takes its root. A factor is a symbol of the list
//! (`units/list.rs`) with an optional prefix from f to T. Everything is turned into SI base units.

mod list;
mod parse;

pub use list::{ListedUnit, UnitGroup, groups};
pub use parse::{parse_quantity, unit_of};

use std::fmt;

/// Exponents of metre, kilogram, second, kelvin and mole, counted in halves (a stress intensity has Pa √m).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dimension {
    halves: [i8; 5],
    /// What one dimension is called in three places.
    sense: Sense,
}

/// What a number is of, where one dimension has several names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sense {
    /// The first name: of N/m, an energy per area.
    Plain,
    /// A load per width.
    Load,
    /// A stiffness.
    Stiffness,
    /// A temperature, not a difference of two.
    Temperature,
    /// A temperature that was given in °C: no difference of two can be meant.
    Celsius,
    /// A decay rate, where both could be meant.
    Decay,
}

impl Dimension {
    /// A dimension from its whole exponents of metre, kilogram, second and kelvin.
    const fn new([metre, kilogram, second, kelvin]: [i8; 4]) -> Self {
        Self { halves: [2 * metre, 2 * kilogram, 2 * second, 2 * kelvin, 0], sense: Sense::Plain }
    }

    /// A pure number.
    pub const NUMBER: Self = Self::new([0, 0, 0, 0]);
    /// m.
    pub const LENGTH: Self = Self::new([1, 0, 0, 0]);
    /// s.
    pub const TIME: Self = Self::new([0, 0, 1, 0]);
    /// 1/s.
    pub const FREQUENCY: Self = Self::new([0, 0, -1, 0]);
    /// 1/s of a decay, which is no number of cycles.
    pub const DECAY_RATE: Self = Self { sense: Sense::Decay, ..Self::FREQUENCY };
    /// m/s.
    pub const SPEED: Self = Self::new([1, 0, -1, 0]);
    /// Pa.
    pub const PRESSURE: Self = Self::new([-1, 1, -2, 0]);
    /// 1/Pa.
    pub const COMPLIANCE: Self = Self::new([1, -1, 2, 0]);
    /// Pa s.
    pub const VISCOSITY: Self = Self::new([-1, 1, -1, 0]);
    /// J/m².
    pub const ENERGY_PER_AREA: Self = Self::new([0, 1, -2, 0]);
    /// N/m, which is J/m².
    pub const LOAD_PER_WIDTH: Self = Self { sense: Sense::Load, ..Self::ENERGY_PER_AREA };
    /// N/m of a spring.
    pub const STIFFNESS: Self = Self { sense: Sense::Stiffness, ..Self::ENERGY_PER_AREA };
    /// N.
    pub const FORCE: Self = Self::new([1, 1, -2, 0]);
    /// N/s.
    pub const FORCE_RATE: Self = Self::new([1, 1, -3, 0]);
    /// Pa/s.
    pub const PRESSURE_RATE: Self = Self::new([-1, 1, -3, 0]);
    /// Pa √m/s.
    pub const STRESS_INTENSITY_RATE: Self = Self { halves: [-1, 2, -6, 0, 0], sense: Sense::Plain };
    /// Pa √m.
    pub const STRESS_INTENSITY: Self = Self { halves: [-1, 2, -4, 0, 0], sense: Sense::Plain };
    /// Pa/m.
    pub const STIFFNESS_PER_AREA: Self = Self::new([-2, 1, -2, 0]);
    /// K of a temperature, which may be given in °C.
    pub const TEMPERATURE: Self = Self { sense: Sense::Temperature, ..Self::TEMPERATURE_DIFFERENCE };
    /// K of a difference of temperatures.
    pub const TEMPERATURE_DIFFERENCE: Self = Self::new([0, 0, 0, 1]);
    /// J/mol.
    pub const ENERGY_PER_MOLE: Self = Self { halves: [4, 2, -4, 0, -2], sense: Sense::Plain };
    /// √m.
    pub const ROOT_LENGTH: Self = Self { halves: [1, 0, 0, 0, 0], sense: Sense::Plain };

    /// What a value of this dimension looks like, for messages and documentation.
    #[must_use]
    pub const fn example(self) -> &'static str {
        match self {
            Self::NUMBER => "a plain number",
            Self::LENGTH => "a length such as \"3 µm\"",
            Self::TIME => "a time such as \"2 ms\"",
            Self::FREQUENCY => "a frequency such as \"5 Hz\"",
            Self::DECAY_RATE => "a decay rate such as \"10 1/s\"",
            Self::SPEED => "a speed such as \"10 µm/s\"",
            Self::PRESSURE => "a pressure such as \"0.7 MPa\"",
            Self::COMPLIANCE => "a compliance such as \"0.4 1/MPa\"",
            Self::VISCOSITY => "a viscosity such as \"2 kPa s\"",
            Self::ENERGY_PER_AREA => "an energy per area such as \"50 mJ/m²\"",
            Self::LOAD_PER_WIDTH => "a load per width such as \"20 N/m\"",
            Self::STIFFNESS => "a stiffness such as \"20 N/m\"",
            Self::STIFFNESS_PER_AREA => "a stiffness per area such as \"5 kPa/µm\"",
            Self::STRESS_INTENSITY => "a stress intensity such as \"20 kPa √m\"",
            Self::STRESS_INTENSITY_RATE => "a rate such as \"5 kPa √m/s\"",
            Self::PRESSURE_RATE => "a rate such as \"2 kPa/s\"",
            Self::FORCE => "a force such as \"20 mN\"",
            Self::FORCE_RATE => "a rate such as \"1 mN/s\"",
            Self::TEMPERATURE => "a temperature such as \"20 °C\" or \"293.15 K\"",
            Self::TEMPERATURE_DIFFERENCE => "a temperature difference such as \"51.6 K\"",
            Self::ENERGY_PER_MOLE => "an energy per mole such as \"120 kJ/mol\"",
            _ => "a number with the unit named in the documentation of the key",
        }
    }

    /// The SI unit, as written in tables.
    #[must_use]
    pub fn si_unit(self) -> String {
        match self {
            Self::NUMBER => "1".into(),
            Self::PRESSURE => "Pa".into(),
            Self::COMPLIANCE => "1/Pa".into(),
            Self::VISCOSITY => "Pa s".into(),
            Self::ENERGY_PER_AREA => "J/m²".into(),
            Self::LOAD_PER_WIDTH | Self::STIFFNESS => "N/m".into(),
            Self::STRESS_INTENSITY => "Pa √m".into(),
            Self::STRESS_INTENSITY_RATE => "Pa √m/s".into(),
            Self::PRESSURE_RATE => "Pa/s".into(),
            Self::FORCE => "N".into(),
            Self::FORCE_RATE => "N/s".into(),
            Self::STIFFNESS_PER_AREA => "Pa/m".into(),
            Self::ENERGY_PER_MOLE => "J/mol".into(),
            Self { sense: Sense::Celsius, .. } => "°C".into(),
            other => written_out(other.halves),
        }
    }

    /// Whether both are the same powers of the base units.
    #[must_use]
    pub fn measures(self, other: Self) -> bool {
        self.halves == other.halves && (self.sense != Sense::Celsius || other.sense == Sense::Temperature)
    }

    /// self·(whole exponents)^(halves/2).
    fn times(self, exponents: [i8; 5], halves: i8) -> Option<Self> {
        let mut product = self.halves;
        for (exponent, step) in product.iter_mut().zip(exponents) {
            *exponent = exponent.checked_add(step.checked_mul(halves)?)?;
        }
        Some(Self { halves: product, sense: self.sense })
    }
}

/// m s⁻¹ as `m/s`, and so on; exponents in halves.
fn written_out(halves: [i8; 5]) -> String {
    let part = |sign: i8| {
        halves
            .iter()
            .zip(["m", "kg", "s", "K", "mol"])
            .filter(|(half, _)| half.signum() == sign)
            .map(|(half, symbol)| match half.unsigned_abs() {
                1 => format!("√{symbol}"),
                2 => symbol.to_owned(),
                even if even % 2 == 0 => format!("{symbol}^{}", even / 2),
                odd => format!("√{symbol}^{odd}"),
            })
            .collect::<Vec<_>>()
            .join(" ")
    };
    let (above, below) = (part(1), part(-1));
    match (above.is_empty(), below.is_empty()) {
        (_, true) => above,
        (true, false) => format!("1/{below}"),
        (false, false) => format!("{above}/{below}"),
    }
}

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UnitError {
    /// The text does not begin with a number.
    NoNumber,
    /// A factor is not a known unit.
    UnknownUnit(String),
    /// The unit is cut short or has stray characters.
    Malformed(String),
}

impl fmt::Display for UnitError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoNumber => write!(formatter, "it does not begin with a number"),
            Self::UnknownUnit(unit) => {
                write!(formatter, "`{unit}` is not a unit known here")?;
                list::nearest(unit).map_or(Ok(()), |meant| write!(formatter, "; did you mean `{meant}`?"))?;
                write!(formatter, " (`viscotack units` lists all)")
            }
            Self::Malformed(part) => write!(formatter, "its unit cannot be read at `{part}`"),
        }
    }
}

/// A number in SI units with its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The value in SI base units.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
}
