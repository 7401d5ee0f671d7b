//! NumPy's `.npy` arrays of two dimensions, as a text of rows that the reader of maps takes.
//!
//! Format (NumPy, "NEP 1", versions 1 to 3): the magic `\x93NUMPY`, two bytes of version, the length of the header, the header (a
//! Python dictionary with `descr`, `fortran_order`, `shape`), then the values.

use super::diagnostic::SourceText;
use crate::regular_file;
use std::fmt::Write as _;
use std::path::Path;

/// The largest array (bytes).
const LARGEST: u64 = 64 * 1024 * 1024;

/// Whether a file is named as an array.
pub(super) fn is_named(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("npy"))
}

/// The array as text: a row a line, each number in its shortest exact form.
///
/// # Errors
/// A sentence that says why it cannot be read.
pub(super) fn open(path: &Path, name: &str) -> Result<SourceText, String> {
    let bytes = regular_file::read(path, LARGEST).map_err(|error| error.to_string())?;
    rows(&bytes).map(|text| SourceText::new(name, text))
}

fn rows(bytes: &[u8]) -> Result<String, String> {
    let short = || "the file ends too early for an array of NumPy".to_owned();
    if bytes.get(..6) != Some(b"\x93NUMPY".as_slice()) {
        return Err("it is no array of NumPy: its first bytes are not \\x93NUMPY".to_owned());
    }
    let byte = |at: usize| bytes.get(at).copied().map(usize::from).ok_or_else(short);
    let (length, start) = match byte(6)? {
        1 => (byte(8)? + 256 * byte(9)?, 10),
        2 | 3 => (byte(8)? + 256 * (byte(9)? + 256 * (byte(10)? + 256 * byte(11)?)), 12),
        version => return Err(format!("its version of the format is {version}, and 1 to 3 are known")),
    };
    let header = bytes.get(start..start + length).ok_or_else(short)?;
    let header = std::str::from_utf8(header).map_err(|_| "its header is no text".to_owned())?;
    let kind = quoted(header, "descr").ok_or_else(|| "its header names no type of numbers".to_owned())?;
    let column_major = after(header, "fortran_order").is_some_and(|rest| rest.starts_with("True"));
    let shape = after(header, "shape").and_then(|rest| rest.strip_prefix('(')?.split_once(')')).map_or("", |(shape, _)| shape);
    let counts: Vec<usize> = shape.split(',').filter_map(|count| count.trim().parse().ok()).collect();
    let [up, across] = counts.as_slice() else {
        return Err(format!("its shape is ({shape}), and a map has two dimensions"));
    };
    let (up, across) = (*up, *across);
    let (big, letters) = match kind.split_at_checked(1) {
        Some((">", letters)) => (true, letters),
        Some(("<" | "|" | "=", letters)) => (false, letters),
        _ => (false, kind),
    };
    let size = match letters {
        "f4" | "i4" | "u4" => 4,
        "f8" => 8,
        "i2" | "u2" => 2,
        "u1" => 1,
        _ => return Err(format!("its numbers are of the type {kind:?}: f4, f8, i2, i4, u1, u2 and u4 are read")),
    };
    let values = bytes.get(start + length..).ok_or_else(short)?;
    let count = up.checked_mul(across).and_then(|count| count.checked_mul(size)).ok_or_else(short)?;
    let values = values.get(..count).ok_or_else(short)?;
    let value = |index: usize| -> f64 {
        let mut own = [0_u8; 8];
        let from = values.get(index * size..(index + 1) * size).unwrap_or(&[]);
        for (place, byte) in from.iter().enumerate() {
            let place = if big { size - 1 - place } else { place };
            own[place] = *byte;
        }
        let word = u64::from_le_bytes(own);
        match letters {
            "f4" => f64::from(f32::from_bits(word as u32)),
            "i4" => f64::from(word as u32 as i32),
            "i2" => f64::from(word as u16 as i16),
            "u1" | "u2" | "u4" => word as f64,
            _ => f64::from_bits(word),
        }
    };
    let mut text = String::with_capacity(16 * up * across);
    for row in 0..up {
        for column in 0..across {
            let index = if column_major { column * up + row } else { row * across + column };
            let _ = write!(text, "{}{:e}", if column > 0 { " " } else { "" }, value(index));
        }
        text.push('\n');
    }
    Ok(text)
}

/// What follows a key of the header.
fn after<'h>(header: &'h str, key: &str) -> Option<&'h str> {
    let (_, rest) = header.split_once(&format!("'{key}'"))?;
    Some(rest.trim_start().strip_prefix(':')?.trim_start())
}

fn quoted<'h>(header: &'h str, key: &str) -> Option<&'h str> {
    after(header, key)?.strip_prefix('\'')?.split_once('\'').map(|(text, _)| text)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn array(kind: &str, order: &str, shape: &str, values: &[u8]) -> Vec<u8> {
        let header = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': ({shape}), }}\n");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((header.len() as u16).to_le_bytes());
        bytes.extend(header.bytes());
        bytes.extend(values);
        bytes
    }

    #[test]
    fn rows_of_every_order_are_read() {
        let little: Vec<u8> = [1.5_f64, -2.0, 0.25, 1e-9].iter().flat_map(|v| v.to_le_bytes()).collect();
        let big: Vec<u8> = [1.5_f64, -2.0, 0.25, 1e-9].iter().flat_map(|v| v.to_be_bytes()).collect();
        assert_eq!(rows(&array("<f8", "False", "2, 2", &little)).unwrap(), "1.5e0 -2e0\n2.5e-1 1e-9\n");
        assert_eq!(rows(&array(">f8", "True", "2, 2", &big)).unwrap(), "1.5e0 2.5e-1\n-2e0 1e-9\n");
        let short: Vec<u8> = [1_i16, -3].iter().flat_map(|v| v.to_le_bytes()).collect();
        assert_eq!(rows(&array("<i2", "False", "1, 2", &short)).unwrap(), "1e0 -3e0\n");
    }

    #[test]
    fn what_is_no_map_is_refused_in_words() {
        assert!(rows(b"text").unwrap_err().contains("no array"));
        assert!(rows(&array("<f8", "False", "4,", &[0; 32])).unwrap_err().contains("two dimensions"));
        assert!(rows(&array("<c16", "False", "1, 1", &[0; 16])).unwrap_err().contains("type"));
        assert!(rows(&array("<f8", "False", "2, 2", &[0; 8])).unwrap_err().contains("too early"));
        assert!(rows(&array("<f8", "False", "99999999999, 99999999999", &[0; 8])).is_err());
    }
}
