//! A number as instruments of any country write it, and what its marks tell of the decimal sign.

/// The sign between whole and broken part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decimal {
    /// 1234.5, or 1,234.5 with groups.
    Point,
    /// 1234,5, or 1.234,5 with groups.
    Comma,
}

/// What a cell can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// No number.
    Text,
    /// Nothing, or a word for it.
    Missing,
    /// Digits without a mark.
    Whole,
    /// One point or comma that can only be the decimal sign.
    Broken(Decimal),
    /// One point or comma before exactly three digits: the decimal sign, or a mark of thousands beside the other sign. The sign if it is one.
    Ambiguous(Decimal),
    /// Points or commas that group thousands: the decimal sign is the other one.
    Grouped(Decimal),
}

impl Shape {
    pub(super) const fn is_number(self) -> bool {
        !matches!(self, Self::Text | Self::Missing)
    }
}

/// Words for no value.
const NOTHING: [&str; 8] = ["-", "--", "---", "nan", "n/a", "na", "#n/a", "null"];

/// The length of an exponent at the start of some bytes, if they are one to their end.
fn is_exponent(bytes: &[u8]) -> bool {
    let digits = match bytes {
        [b'e' | b'E' | b'd' | b'D', b'+' | b'-', rest @ ..] | [b'e' | b'E' | b'd' | b'D', rest @ ..] => rest,
        _ => return false,
    };
    !digits.is_empty() && digits.len() <= 4 && digits.iter().all(u8::is_ascii_digit)
}

/// A cell without its sign; the typographic minus is one, too.
fn unsigned(text: &str) -> (&str, bool) {
    match text.strip_prefix(['-', '−', '–']) {
        Some(rest) => (rest, true),
        None => (text.strip_prefix('+').unwrap_or(text), false),
    }
}

/// What a cell, without blanks around it, can be.
pub(super) fn shape(text: &str) -> Shape {
    let (body, _) = unsigned(text);
    if !body.starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == ',') {
        return if text.is_empty() || NOTHING.iter().any(|word| text.eq_ignore_ascii_case(word)) { Shape::Missing } else { Shape::Text };
    }
    // Digits since the last mark, marks so far, the last mark, whether all groups before it are such of thousands.
    let (mut run, mut points, mut commas, mut blanks, mut last) = (0_usize, 0_u32, 0_u32, 0_u32, ' ');
    let (mut first_run, mut groups, mut exponent) = (0, true, false);
    for (at, mark) in body.char_indices() {
        match mark {
            '0'..='9' => {
                run += 1;
                continue;
            }
            '.' => points += 1,
            ',' => commas += 1,
            ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}' | '\'' | '’' => blanks += 1,
            _ if is_exponent(body.as_bytes().get(at..).unwrap_or_default()) => {
                exponent = true;
                break;
            }
            _ => return Shape::Text,
        }
        let marks = points + commas + blanks;
        if marks == 1 {
            first_run = run;
        }
        groups &= if marks == 1 { (1..=3).contains(&run) } else { run == 3 };
        (run, last) = (0, mark);
    }
    let three = run == 3 && groups;
    let leading_zero = body.starts_with('0');
    let of = |decimal: char| if decimal == '.' { Decimal::Point } else { Decimal::Comma };
    match (points, commas, blanks) {
        (0, 0, 0) => Shape::Whole,
        (1, 0, 0) | (0, 1, 0) => {
            // `.` alone is no number, and neither is `5,`.
            if first_run + run == 0 || (run == 0 && commas == 1) {
                Shape::Text
            } else if three && !leading_zero && !exponent {
                Shape::Ambiguous(of(last))
            } else {
                Shape::Broken(of(last))
            }
        }
        // Groups alone.
        (0, 0, 1..) if three => Shape::Whole,
        (0, 2.., 0) if three => Shape::Grouped(Decimal::Point),
        (2.., 0, 0) if three => Shape::Grouped(Decimal::Comma),
        // Groups, then one decimal sign.
        (1, 1.., 0) if groups && last == '.' => Shape::Grouped(Decimal::Point),
        (1.., 1, 0) if groups && last == ',' => Shape::Grouped(Decimal::Comma),
        (1, 0, 1..) | (0, 1, 1..) if groups && matches!(last, '.' | ',') && run > 0 => Shape::Broken(of(last)),
        _ => Shape::Text,
    }
}

/// The value of a cell; `power` of ten is folded into its digits, so that the value is rounded once. None for a cell that is no number with this decimal sign.
pub(super) fn value(text: &str, decimal: Decimal, power: i32, buffer: &mut String) -> Option<f64> {
    let fits = match shape(text) {
        Shape::Text | Shape::Missing => false,
        Shape::Whole => true,
        Shape::Broken(sign) | Shape::Grouped(sign) => sign == decimal,
        // The other sign groups: the file as a whole has been checked for that.
        Shape::Ambiguous(_) => true,
    };
    if !fits {
        return None;
    }
    let plain = |byte: u8| matches!(byte, b'0'..=b'9' | b'.' | b'-' | b'e' | b'E');
    if power == 0 && decimal == Decimal::Point && text.bytes().all(plain) {
        return finite(text);
    }
    buffer.clear();
    let (body, negative) = unsigned(text);
    if negative {
        buffer.push('-');
    }
    let sign = if decimal == Decimal::Point { '.' } else { ',' };
    let mut own = 0;
    for (at, mark) in body.char_indices() {
        match mark {
            '0'..='9' => buffer.push(mark),
            _ if mark == sign => buffer.push('.'),
            'e' | 'E' | 'd' | 'D' => {
                own = body.get(at + 1..)?.parse::<i32>().ok()?;
                break;
            }
            _ => {}
        }
    }
    let exponent = own.checked_add(power)?;
    if exponent != 0 {
        use std::fmt::Write as _;
        write!(buffer, "e{exponent}").ok()?;
    }
    finite(buffer)
}

/// A number and the unit behind it, perhaps none.
pub(super) fn quantity(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let of_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '−' | '+' | 'e' | 'E');
    let (digits, unit) = text.split_at(text.find(|c: char| !of_number(c)).unwrap_or(text.len()));
    let decimal = match shape(digits) {
        Shape::Whole | Shape::Ambiguous(Decimal::Point) => Decimal::Point,
        Shape::Broken(sign) | Shape::Grouped(sign) => sign,
        _ => return None,
    };
    Some((value(digits, decimal, 0, &mut String::new())?, unit.trim()))
}

/// What a cell can be, where a number may carry its unit.
pub(super) fn shape_with_unit(text: &str, quantities: bool) -> Shape {
    match shape(text) {
        Shape::Text if quantities && quantity(text).is_some() => Shape::Whole,
        own => own,
    }
}

fn finite(text: &str) -> Option<f64> {
    // No minus zero.
    text.parse::<f64>().ok().filter(|value| value.is_finite()).map(|value| value + 0.0)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp)]
    use super::*;
    use Decimal::{Comma, Point};

    #[test]
    fn shapes() {
        for (text, right) in [
            ("", Shape::Missing),
            ("NaN", Shape::Missing),
            ("--", Shape::Missing),
            ("12", Shape::Whole),
            ("-12e+03", Shape::Whole),
            ("1 234 567", Shape::Whole),
            ("1'234", Shape::Whole),
            ("12 34", Shape::Text),
            ("0.123", Shape::Broken(Point)),
            ("0,123", Shape::Broken(Comma)),
            (".5", Shape::Broken(Point)),
            ("5.", Shape::Broken(Point)),
            ("5,", Shape::Text),
            (".", Shape::Text),
            ("1.234", Shape::Ambiguous(Point)),
            ("1,234", Shape::Ambiguous(Comma)),
            ("1,234e5", Shape::Broken(Comma)),
            ("1234,567", Shape::Broken(Comma)),
            ("1,234,567", Shape::Grouped(Point)),
            ("1,234.5", Shape::Grouped(Point)),
            ("1.234,5", Shape::Grouped(Comma)),
            ("1,23.4", Shape::Text),
            ("1 234,567", Shape::Broken(Comma)),
            ("12.03.2021", Shape::Text),
            ("10:11", Shape::Text),
            ("1e", Shape::Text),
            ("e5", Shape::Text),
            ("−2,5", Shape::Broken(Comma)),
            ("inf", Shape::Text),
            ("0x10", Shape::Text),
            ("1,2,3", Shape::Text),
        ] {
            assert_eq!(shape(text), right, "{text}");
        }
    }

    #[test]
    fn values() {
        let mut buffer = String::new();
        for (text, decimal, power, right) in [
            ("1,234.5", Point, 0, Some(1234.5)),
            ("1.234,5", Comma, 0, Some(1234.5)),
            ("1 234,5", Comma, 3, Some(1_234_500.0)),
            ("−2,5", Comma, 0, Some(-2.5)),
            ("0.7", Point, 6, Some(7e5)),
            ("1.0D-03", Point, 0, Some(1e-3)),
            ("+1,5E+02", Comma, 0, Some(150.0)),
            ("0,5", Point, 0, None),
            ("0.5", Comma, 0, None),
            ("1e999", Point, 0, None),
            ("-0", Point, 0, Some(0.0)),
        ] {
            assert_eq!(value(text, decimal, power, &mut buffer), right, "{text}");
        }
    }
}
