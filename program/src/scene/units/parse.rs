//! A text read as a number with a unit.

use super::list::{CELSIUS, FAHRENHEIT, PREFIXES, SYMBOLS};
use super::{Dimension, Quantity, Sense, UnitError};

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
    if CELSIUS.contains(&unit.trim()) {
        return Ok(Quantity { value: value + 273.15, dimension: Dimension { sense: Sense::Celsius, ..Dimension::TEMPERATURE } });
    }
    if FAHRENHEIT.contains(&unit.trim()) {
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

/// The unit of a text that is a number with one, as it is written; empty without.
#[must_use]
pub fn unit_of(text: &str) -> &str {
    let text = text.trim();
    text.split_at(number_length(text)).1.trim()
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
    let (mut divide, mut expects_factor) = (false, false);
    // In brackets: whether they are divided by.
    let mut brackets = None;
    let mut rest = text.trim();
    while let Some(first) = rest.chars().next() {
        let digit_follows = || rest.get(first.len_utf8()..).is_some_and(|next| next.starts_with(|c: char| c.is_ascii_digit()));
        match first {
            ' ' | '\u{a0}' | '*' | '·' | '⋅' => {}
            '.' if !digit_follows() => {}
            '/' => {
                if divide {
                    return Err(UnitError::Malformed(rest.to_owned()));
                }
                (divide, expects_factor) = (true, true);
            }
            '(' if brackets.is_none() => {
                brackets = Some(divide);
                (divide, expects_factor) = (false, true);
            }
            ')' if brackets.is_some() && !expects_factor => brackets = None,
            '1' if !digit_follows() => (divide, expects_factor) = (false, false),
            _ => {
                let (root, symbols) = rest.strip_prefix('√').map_or((false, rest), |after| (true, after));
                let length: usize = symbols.chars().take_while(|c| c.is_alphabetic() || *c == '%').map(char::len_utf8).sum();
                if length == 0 {
                    return Err(UnitError::Malformed(rest.to_owned()));
                }
                let (symbol, after) = symbols.split_at(length);
                let (halves, after) = parse_power(after)?;
                if root && halves % 2 != 0 {
                    return Err(UnitError::Malformed(rest.to_owned()));
                }
                let halves = if root { halves / 2 } else { halves };
                apply(&mut unit, symbol, if divide == brackets.unwrap_or(false) { halves } else { -halves })?;
                (divide, expects_factor) = (false, false);
                rest = after;
                continue;
            }
        }
        rest = rest.get(first.len_utf8()..).unwrap_or("");
    }
    if expects_factor || brackets.is_some() { Err(UnitError::Malformed(text.trim().to_owned())) } else { Ok(unit) }
}

/// `^-2`, `**2`, `-2`, `²`, `⁻¹`, `^0.5`, `^(1/2)` or nothing (power one), counted in halves.
fn parse_power(text: &str) -> Result<(i8, &str), UnitError> {
    let malformed = || UnitError::Malformed(text.to_owned());
    let halves_of = |digits: &str| {
        let halves = match digits.strip_suffix("/2") {
            Some(numerator) => numerator.parse::<i8>().ok(),
            None => digits.parse::<f32>().ok().map(|power| 2.0 * power).filter(|halves| halves.fract() == 0.0).map(|halves| halves as i8),
        };
        halves.filter(|halves| (-18..=18).contains(halves) && digits.contains(|c: char| c.is_ascii_digit())).ok_or_else(malformed)
    };
    if let Some(after) = text.strip_prefix('^').or_else(|| text.strip_prefix("**")) {
        if let Some((inside, rest)) = after.strip_prefix('(').and_then(|inside| inside.split_once(')')) {
            return Ok((halves_of(inside.trim())?, rest));
        }
        let length =
            after.bytes().enumerate().take_while(|&(at, byte)| byte.is_ascii_digit() || byte == b'.' || (at == 0 && byte == b'-')).count();
        let (digits, rest) = after.split_at(length);
        return Ok((halves_of(digits)?, rest));
    }
    if text.strip_prefix('-').unwrap_or(text).starts_with(|c: char| c.is_ascii_digit()) {
        let length = text.bytes().enumerate().take_while(|&(at, byte)| byte.is_ascii_digit() || (at == 0 && byte == b'-')).count();
        let (digits, rest) = text.split_at(length);
        return Ok((halves_of(digits)?, rest));
    }
    let superscript = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c);
    let (negative, after) = text.strip_prefix('⁻').map_or((false, text), |after| (true, after));
    match after.chars().next().and_then(|c| superscript(c).map(|digit| (digit, c.len_utf8()))) {
        Some((digit, length)) => {
            let power = i8::try_from(2 * digit).map_err(|_| malformed())?;
            Ok((if negative { -power } else { power }, after.get(length..).unwrap_or("")))
        }
        None if negative => Err(malformed()),
        None => Ok((2, text)),
    }
}

fn apply(unit: &mut Unit, symbol: &str, halves: i8) -> Result<(), UnitError> {
    let unknown = || UnitError::UnknownUnit(symbol.to_owned());
    // The signs of the ångström and the kelvin are letters of their own.
    let written = symbol.replace('\u{212b}', "Å").replace('\u{212a}', "K");
    let plain = SYMBOLS.iter().find(|entry| entry.symbol == written).map(|entry| (0, entry));
    let with_prefix = || {
        PREFIXES.iter().find_map(|&(prefix, exponent)| {
            let rest = written.strip_prefix(prefix)?;
            SYMBOLS.iter().find(|entry| entry.prefixed && entry.symbol == rest).map(|entry| (exponent, entry))
        })
    };
    let (exponent, entry) = plain.or_else(with_prefix).ok_or_else(unknown)?;
    // The gram is the one symbol whose SI unit carries a prefix: count it in decimal exponents, too.
    let (factor, exponent) = if entry.symbol == "g" { (1.0, exponent - 3) } else { (entry.size, exponent) };
    unit.factor *= if halves % 2 == 0 { factor.powi(i32::from(halves / 2)) } else { factor.sqrt().powi(i32::from(halves)) };
    unit.decimal_halves += exponent * i32::from(halves);
    unit.dimension = unit.dimension.times(entry.exponents, halves).ok_or_else(unknown)?;
    Ok(())
}
