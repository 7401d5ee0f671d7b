//! Numbers with units: `"0.7 MPa"`, `"3 µm"`, `"1e-7 1/Pa"`, `"50 J/m^2"`, `"2 kPa s"`.
//!
//! A unit is factors separated by spaces, `*` or `·`; `/` divides by the factor that follows it; `^2`, `^-1`, `²`, `⁻¹` raise one factor to
//! a power, and `√` before a factor takes its root. A factor is a symbol with an optional prefix from f to T. Everything is turned into SI
//! base units.

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
            Self::UnknownUnit(unit) => write!(formatter, "`{unit}` is not a unit known here"),
            Self::Malformed(part) => write!(formatter, "its unit cannot be read at `{part}`"),
        }
    }
}

/// Symbol, factor to SI, exponents of metre, kilogram, second, kelvin and mole, and whether a prefix may stand before it.
const SYMBOLS: [(&str, f64, [i8; 5], bool); 22] = [
    ("m", 1.0, [1, 0, 0, 0, 0], true),
    ("g", 1e-3, [0, 1, 0, 0, 0], true),
    ("s", 1.0, [0, 0, 1, 0, 0], true),
    ("K", 1.0, [0, 0, 0, 1, 0], true),
    ("N", 1.0, [1, 1, -2, 0, 0], true),
    ("Pa", 1.0, [-1, 1, -2, 0, 0], true),
    ("bar", 1e5, [-1, 1, -2, 0, 0], true),
    ("J", 1.0, [2, 1, -2, 0, 0], true),
    ("W", 1.0, [2, 1, -3, 0, 0], true),
    ("Hz", 1.0, [0, 0, -1, 0, 0], true),
    ("P", 0.1, [-1, 1, -1, 0, 0], true),
    ("min", 60.0, [0, 0, 1, 0, 0], false),
    ("h", 3600.0, [0, 0, 1, 0, 0], false),
    ("Å", 1e-10, [1, 0, 0, 0, 0], false),
    ("%", 1e-2, [0, 0, 0, 0, 0], false),
    ("rad", 1.0, [0, 0, 0, 0, 0], true),
    ("mol", 1.0, [0, 0, 0, 0, 1], true),
    ("dyn", 1e-5, [1, 1, -2, 0, 0], false),
    ("erg", 1e-7, [2, 1, -2, 0, 0], false),
    // The inch and the pound are exact since 1959, standard gravity since 1901.
    ("in", 0.0254, [1, 0, 0, 0, 0], false),
    ("lbf", 4.448_221_615_260_5, [1, 1, -2, 0, 0], false),
    ("psi", 4.448_221_615_260_5 / (0.0254 * 0.0254), [-1, 1, -2, 0, 0], false),
];

/// Decimal exponents, so that `"0.7 MPa"` is the double nearest to 7e5 and not 0.7 times a rounded factor.
const PREFIXES: [(&str, i32); 12] =
    [("f", -15), ("p", -12), ("n", -9), ("µ", -6), ("μ", -6), ("u", -6), ("m", -3), ("c", -2), ("k", 3), ("M", 6), ("G", 9), ("T", 12)];

/// A number in SI units with its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The value in SI base units.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

/// Reads a number with a unit.
///
/// # Errors
/// [`UnitError`] says which part is not understood.
pub fn parse_quantity(text: &str) -> Result<Quantity, UnitError> {
    let text = text.trim();
    let end = number_length(text);
    let (number, unit) = text.split_at(end);
    let cleaned: String = number.chars().filter(|&c| c != '_').collect();
    let value: f64 = cleaned.parse().map_err(|_| UnitError::NoNumber)?;
    if matches!(unit.trim(), "°C" | "degC" | "deg C") {
        return Ok(Quantity { value: value + 273.15, dimension: Dimension { sense: Sense::Celsius, ..Dimension::TEMPERATURE } });
    }
    if matches!(unit.trim(), "°F" | "degF" | "deg F") {
        let value = (value - 32.0) / 1.8 + 273.15;
        return Ok(Quantity { value, dimension: Dimension { sense: Sense::Celsius, ..Dimension::TEMPERATURE } });
    }
    let unit = parse_unit(unit)?;
    // Powers of ten are folded into the decimal text, so that no second rounding happens.
    let exponent = unit.decimal_halves.div_euclid(2);
    let root = if unit.decimal_halves.rem_euclid(2) == 1 { 10f64.sqrt() } else { 1.0 };
    let folded = fold_exponent(&cleaned, exponent).unwrap_or(value * 10f64.powi(exponent));
    Ok(Quantity { value: folded * unit.factor * root, dimension: unit.dimension })
}

/// `number`·10^`exponent` rounded once.
fn fold_exponent(number: &str, exponent: i32) -> Option<f64> {
    let (mantissa, own) = match number.find(['e', 'E']) {
        Some(place) => (number.get(..place)?, number.get(place + 1..)?.parse::<i32>().ok()?),
        None => (number, 0),
    };
    format!("{mantissa}e{}", own.checked_add(exponent)?).parse().ok()
}

/// The length of the decimal number at the start of a text.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digit = |at: usize| bytes.get(at).is_some_and(|byte| byte.is_ascii_digit());
    let mut at = 0;
    if matches!(bytes.first(), Some(b'+' | b'-')) {
        at += 1;
    }
    while digit(at) || matches!(bytes.get(at), Some(b'.' | b'_')) {
        at += 1;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        if digit(at + 1 + sign) {
            at += 1 + sign;
            while digit(at) {
                at += 1;
            }
        }
    }
    at
}

struct Unit {
    factor: f64,
    /// Power of ten, in halves.
    decimal_halves: i32,
    dimension: Dimension,
}

fn parse_unit(text: &str) -> Result<Unit, UnitError> {
    let mut unit = Unit { factor: 1.0, decimal_halves: 0, dimension: Dimension::NUMBER };
    let mut divide = false;
    let mut expects_factor = false;
    let mut rest = text.trim();
    while let Some(first) = rest.chars().next() {
        match first {
            ' ' | '*' | '·' | '⋅' => {}
            '/' => {
                if divide {
                    return Err(UnitError::Malformed(rest.to_owned()));
                }
                divide = true;
                expects_factor = true;
            }
            '1' if !rest.get(1..).is_some_and(|next| next.starts_with(|c: char| c.is_ascii_digit())) => expects_factor = false,
            _ => {
                let (root, symbols) = rest.strip_prefix('√').map_or((false, rest), |after| (true, after));
                let length: usize = symbols.chars().take_while(|c| c.is_alphabetic() || *c == '%').map(char::len_utf8).sum();
                if length == 0 {
                    return Err(UnitError::Malformed(rest.to_owned()));
                }
                let (symbol, after) = symbols.split_at(length);
                let (power, after) = parse_power(after)?;
                let halves = if root { power } else { 2 * power };
                apply(&mut unit, symbol, if divide { -halves } else { halves })?;
                divide = false;
                expects_factor = false;
                rest = after;
                continue;
            }
        }
        rest = rest.get(first.len_utf8()..).unwrap_or("");
    }
    if expects_factor { Err(UnitError::Malformed(text.trim().to_owned())) } else { Ok(unit) }
}

/// `^-2`, `-2`, `²`, `⁻¹` or nothing (power one).
fn parse_power(text: &str) -> Result<(i8, &str), UnitError> {
    let malformed = || UnitError::Malformed(text.to_owned());
    let bare = text.strip_prefix('-').unwrap_or(text).starts_with(|c: char| c.is_ascii_digit());
    if let Some(after) = text.strip_prefix('^').or(bare.then_some(text)) {
        let length = after.bytes().enumerate().take_while(|&(at, byte)| byte.is_ascii_digit() || (at == 0 && byte == b'-')).count();
        let (digits, rest) = after.split_at(length);
        let power = digits.parse::<i8>().ok().filter(|power| power.abs() <= 9).ok_or_else(malformed)?;
        return Ok((power, rest));
    }
    let superscript = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c);
    let (negative, after) = text.strip_prefix('⁻').map_or((false, text), |after| (true, after));
    match after.chars().next().and_then(|c| superscript(c).map(|digit| (digit, c.len_utf8()))) {
        Some((digit, length)) => {
            let power = i8::try_from(digit).map_err(|_| malformed())?;
            Ok((if negative { -power } else { power }, after.get(length..).unwrap_or("")))
        }
        None if negative => Err(malformed()),
        None => Ok((1, text)),
    }
}

fn apply(unit: &mut Unit, symbol: &str, halves: i8) -> Result<(), UnitError> {
    let unknown = || UnitError::UnknownUnit(symbol.to_owned());
    let plain = SYMBOLS.iter().find(|entry| entry.0 == symbol).map(|entry| (0, entry));
    let prefixed = || {
        PREFIXES.iter().find_map(|&(prefix, exponent)| {
            let rest = symbol.strip_prefix(prefix)?;
            SYMBOLS.iter().find(|entry| entry.0 == rest && entry.3).map(|entry| (exponent, entry))
        })
    };
    let (exponent, &(name, factor, exponents, _)) = plain.or_else(prefixed).ok_or_else(unknown)?;
    // The gram is the one symbol whose SI unit carries a prefix: count it in decimal exponents, too.
    let (factor, exponent) = if name == "g" { (1.0, exponent - 3) } else { (factor, exponent) };
    unit.factor *= if halves % 2 == 0 { factor.powi(i32::from(halves / 2)) } else { factor.sqrt().powi(i32::from(halves)) };
    unit.decimal_halves += exponent * i32::from(halves);
    unit.dimension = unit.dimension.times(exponents, halves).ok_or_else(unknown)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::float_cmp)]
    use super::*;

    #[test]
    fn quantities_are_rounded_once() {
        for (text, value, dimension) in [
            ("0.7 MPa", 7e5, Dimension::PRESSURE),
            ("3 µm", 3e-6, Dimension::LENGTH),
            ("3um", 3e-6, Dimension::LENGTH),
            ("50 mJ/m²", 0.05, Dimension::ENERGY_PER_AREA),
            ("50 mJ/m^2", 0.05, Dimension::ENERGY_PER_AREA),
            ("1.1 N/m", 1.1, Dimension::ENERGY_PER_AREA),
            ("0.4 1/MPa", 4e-7, Dimension::COMPLIANCE),
            ("0.4 MPa^-1", 4e-7, Dimension::COMPLIANCE),
            ("0.4 MPa⁻¹", 4e-7, Dimension::COMPLIANCE),
            ("2 kPa s", 2e3, Dimension::VISCOSITY),
            ("2 kPa·s", 2e3, Dimension::VISCOSITY),
            ("-1.5e-3 nm/s", -1.5e-12, Dimension::SPEED),
            ("90 min", 5400.0, Dimension::TIME),
            ("5 %", 0.05, Dimension::NUMBER),
            ("0.3", 0.3, Dimension::NUMBER),
            ("1_000 m", 1000.0, Dimension::LENGTH),
            ("0.013 ms", 1.3e-5, Dimension::TIME),
            ("20 kPa √m", 2e4, Dimension::STRESS_INTENSITY),
            ("1 MPa √mm", 1e5 / 10f64.sqrt(), Dimension::STRESS_INTENSITY),
        ] {
            let quantity = parse_quantity(text).unwrap();
            assert!((quantity.value - value).abs() <= f64::EPSILON * value.abs() * f64::from(u8::from(text.contains('√'))), "{text}");
            assert_eq!(quantity.dimension, dimension, "{text}");
        }
    }

    /// Exact by the SI Brochure (BIPM): base and derived units, prefixes, minute and hour, degree Celsius; bar, ångström and poise as in its 8th edition.
    #[test]
    fn units_and_prefixes_are_those_of_the_si_brochure() {
        for (text, value) in [
            ("1 m", 1.0),
            ("1 g", 1e-3),
            ("1 s", 1.0),
            ("1 K", 1.0),
            ("1 N", 1.0),
            ("1 Pa", 1.0),
            ("1 bar", 1e5),
            ("1 mbar", 100.0),
            ("1 J", 1.0),
            ("1 W", 1.0),
            ("1 Hz", 1.0),
            ("1 P", 0.1),
            ("1 cP", 1e-3),
            ("1 min", 60.0),
            ("1 h", 3600.0),
            ("1 Å", 1e-10),
            ("1 %", 0.01),
            ("1 rad", 1.0),
            ("1 mol", 1.0),
            ("1 fm", 1e-15),
            ("1 pm", 1e-12),
            ("1 nm", 1e-9),
            ("1 µm", 1e-6),
            ("1 mm", 1e-3),
            ("1 cm", 1e-2),
            ("1 km", 1e3),
            ("1 MPa", 1e6),
            ("1 GPa", 1e9),
            ("1 TPa", 1e12),
            ("0 °C", 273.15),
            ("-273.15 °C", 0.0),
            ("20 degC", 293.15),
            ("212 °F", 373.15),
            ("1 dyn", 1e-5),
            ("1 erg", 1e-7),
            ("1 in", 0.0254),
            ("1 lbf", 4.448_221_615_260_5),
        ] {
            assert_eq!(parse_quantity(text).unwrap().value, value, "{text}");
        }
        // A bar is a pressure, a poise a viscosity, and so on: one of each in base units.
        for (text, same) in [
            ("1 bar", "1 kg/m/s^2"),
            ("1 P", "1 kg/m/s"),
            ("1 J", "1 kg m^2/s^2"),
            ("1 W", "1 kg m^2/s^3"),
            ("1 N", "1 kg m/s^2"),
            ("1 Hz", "1 1/s"),
            ("1 lbf/in2", "1 psi"),
            ("1 erg/cm2", "1 mJ/m^2"),
            ("1 cm²/dyn", "1 m2 N-1"),
        ] {
            assert_eq!(parse_quantity(text).unwrap().dimension, parse_quantity(same).unwrap().dimension, "{text}");
        }
        // NIST SP 811, appendix B.
        let psi = parse_quantity("1 psi").unwrap().value;
        assert!((psi / 6_894.757_293_168_4 - 1.0).abs() < 1e-14, "{psi}");
        assert_eq!(parse_quantity("3 N/mm2").unwrap().value, 3e6);
    }

    #[test]
    fn what_is_no_quantity_says_why() {
        assert_eq!(parse_quantity("MPa"), Err(UnitError::NoNumber));
        assert_eq!(parse_quantity(""), Err(UnitError::NoNumber));
        assert_eq!(parse_quantity("nan Pa"), Err(UnitError::NoNumber));
        assert_eq!(parse_quantity("3 furlong"), Err(UnitError::UnknownUnit("furlong".into())));
        assert!(matches!(parse_quantity("3 m/"), Err(UnitError::Malformed(_))));
        assert!(matches!(parse_quantity("3 m//s"), Err(UnitError::Malformed(_))));
        assert!(matches!(parse_quantity("3 m^"), Err(UnitError::Malformed(_))));
        assert!(matches!(parse_quantity("3 m^99"), Err(UnitError::Malformed(_))));
    }
}
