//! Bytes of a file as text: UTF-8, UTF-16, or Windows-1252 where they are neither.

/// How the bytes of a text were read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, with or without a byte-order mark.
    Utf8,
    /// UTF-16 of either byte order.
    Utf16,
    /// One byte a character, as programs of Western Europe write it. Chosen where the bytes are no UTF-8.
    Windows1252,
}

impl Encoding {
    /// All of them.
    const ALL: [Self; 3] = [Self::Utf8, Self::Utf16, Self::Windows1252];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "UTF-8",
            Self::Utf16 => "UTF-16",
            Self::Windows1252 => "Windows-1252",
        }
    }

    /// The encoding of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|encoding| encoding.name() == name)
    }

    /// What a person should know of the choice; none where there was none.
    #[must_use]
    pub const fn note(self) -> Option<&'static str> {
        match self {
            Self::Utf8 => None,
            Self::Utf16 => Some("its bytes are read as UTF-16"),
            Self::Windows1252 => Some("its bytes are no UTF-8 and are read as Windows-1252"),
        }
    }
}

/// Characters of the bytes 0x80 to 0x9f; the five that Windows-1252 leaves open are no text.
const WINDOWS_1252: [char; 32] = [
    '€', '\0', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\0', 'Ž', '\0', '\0', '‘', '’', '“', '”', '•', '–', '—', '˜', '™',
    'š', '›', 'œ', '\0', 'ž', 'Ÿ',
];

/// The text of some bytes, without a byte-order mark.
///
/// # Errors
/// A sentence that names the byte that is no text.
pub fn decode(bytes: Vec<u8>) -> Result<(String, Encoding), String> {
    let (text, encoding) = match bytes.as_slice() {
        [0xff, 0xfe, rest @ ..] => (utf16(rest, u16::from_le_bytes)?, Encoding::Utf16),
        [0xfe, 0xff, rest @ ..] => (utf16(rest, u16::from_be_bytes)?, Encoding::Utf16),
        plain => match zeros(plain) {
            [even, odd] if odd > plain.len() / 4 && even <= odd / 8 => (utf16(plain, u16::from_le_bytes)?, Encoding::Utf16),
            [even, odd] if even > plain.len() / 4 && odd <= even / 8 => (utf16(plain, u16::from_be_bytes)?, Encoding::Utf16),
            _ => one_byte(bytes)?,
        },
    };
    match text.find('\0') {
        Some(at) => Err(format!("line {} holds a zero byte: is it a text file?", line_at(&text, at))),
        None => Ok((text, encoding)),
    }
}

/// Zero bytes at even and at odd places: a text of Latin letters in UTF-16 has one in each pair.
fn zeros(bytes: &[u8]) -> [usize; 2] {
    let mut found = [0, 0];
    for pair in bytes.chunks_exact(2) {
        if let [even, odd] = pair {
            found[0] += usize::from(*even == 0);
            found[1] += usize::from(*odd == 0);
        }
    }
    found
}

fn utf16(bytes: &[u8], pair: fn([u8; 2]) -> u16) -> Result<String, String> {
    if bytes.len() % 2 == 1 {
        return Err("it looks like UTF-16, and ends within a character".to_owned());
    }
    let units = bytes.chunks_exact(2).map(|two| pair(two.try_into().unwrap_or_default()));
    let text: Result<String, _> = char::decode_utf16(units).collect();
    text.map(|text| text.trim_start_matches('\u{feff}').to_owned())
        .map_err(|_| "it looks like UTF-16, and holds half a character".to_owned())
}

fn one_byte(bytes: Vec<u8>) -> Result<(String, Encoding), String> {
    let bytes = match String::from_utf8(bytes) {
        Ok(text) => return Ok((text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text), Encoding::Utf8)),
        Err(error) => error.into_bytes(),
    };
    let mut text = String::with_capacity(bytes.len() + bytes.len() / 8);
    for (at, &byte) in bytes.iter().enumerate() {
        let character = match byte {
            0x80..=0x9f => WINDOWS_1252.get(usize::from(byte - 0x80)).copied().unwrap_or('\0'),
            _ => char::from(byte),
        };
        if character == '\0' {
            return Err(format!("byte {at}, in line {}, is neither UTF-8 nor Windows-1252 text", line_at(&text, text.len())));
        }
        text.push(character);
    }
    Ok((text, Encoding::Windows1252))
}

/// The line of a place in a text, counted from one; a line ends with LF, CR LF or CR.
#[must_use]
pub fn line_at(text: &str, at: usize) -> usize {
    let before = text.as_bytes().get(..at.min(text.len())).unwrap_or_default();
    let lone = |(index, byte): (usize, &u8)| *byte == b'\r' && text.as_bytes().get(index + 1) != Some(&b'\n');
    1 + before.iter().filter(|&&byte| byte == b'\n').count() + before.iter().enumerate().filter(|pair| lone(*pair)).count()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const TEXT: &str = "Temp./°C;E''/MPa\r\n–20;1,5\r\n";

    #[test]
    fn every_encoding_gives_the_same_text() {
        let wide = |mark: bool, order: fn(u16) -> [u8; 2]| -> Vec<u8> {
            mark.then_some(0xfeff).into_iter().chain(TEXT.encode_utf16()).flat_map(order).collect()
        };
        let mut marked = vec![0xef, 0xbb, 0xbf];
        marked.extend(TEXT.bytes());
        let western: Vec<u8> = TEXT.chars().map(|c| if c == '–' { 0x96 } else { u8::try_from(u32::from(c)).unwrap() }).collect();
        for (bytes, encoding) in [
            (TEXT.as_bytes().to_vec(), Encoding::Utf8),
            (marked, Encoding::Utf8),
            (wide(true, u16::to_le_bytes), Encoding::Utf16),
            (wide(true, u16::to_be_bytes), Encoding::Utf16),
            (wide(false, u16::to_le_bytes), Encoding::Utf16),
            (wide(false, u16::to_be_bytes), Encoding::Utf16),
            (western, Encoding::Windows1252),
        ] {
            assert_eq!(decode(bytes).unwrap(), (TEXT.to_owned(), encoding));
        }
    }

    #[test]
    fn bytes_that_are_no_text_are_named() {
        assert!(decode(b"a,b\n1,\0\n".to_vec()).unwrap_err().contains("line 2 holds a zero byte"));
        assert!(decode(b"a,b\r1,\x81\r".to_vec()).unwrap_err().contains("byte 6, in line 2"));
        assert!(decode(vec![0xff, 0xfe, b'a', 0, b'b']).unwrap_err().contains("ends within a character"));
        assert!(decode(vec![0xff, 0xfe, 0, 0xd8, b'b', 0]).unwrap_err().contains("half a character"));
        assert_eq!(decode(Vec::new()).unwrap().0, "");
    }
}
