//! What the commands print: nothing in it commands a terminal, and a full disk or a reader that has gone away is no panic.

use super::Failure;
use std::io::{Result, Write};
use viscotack_program::terminal_text::{is_harmful, lines};

/// Writes text to standard output; a reader that has gone away (`| head`) is no error, a full disk is.
pub(super) fn print(text: &str) -> std::result::Result<(), Failure> {
    written(|out| out.write_all(lines(text).as_bytes()))
}

/// Writes JSON to standard output, piece by piece. In its texts harmful characters are written as `\uXXXX`, which any reader of JSON reads as the same text.
pub(super) fn print_json(write: impl FnOnce(&mut (dyn Write + Send)) -> Result<()>) -> std::result::Result<(), Failure> {
    written(|out| {
        let mut escaped = Escaped { inner: out, rest: Vec::new() };
        write(&mut escaped)?;
        escaped.inner.write_all(b"\n")
    })
}

/// Writes to standard error, if anybody reads it.
pub(super) fn note(text: &str) {
    let _ = std::io::stderr().lock().write_all(lines(text).as_bytes());
}

fn written(write: impl FnOnce(&mut (dyn Write + Send)) -> Result<()>) -> std::result::Result<(), Failure> {
    let mut out = std::io::BufWriter::new(std::io::stdout());
    let ended = write(&mut out).and_then(|()| out.flush());
    // What could not be written is not tried again when the buffer goes.
    drop(out.into_parts());
    match ended {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Machine(format!("error: standard output cannot be written: {error}\n")))
        }
        _ => Ok(()),
    }
}

/// JSON on its way to a terminal: harmful characters stand in its texts only, where they can be escaped.
struct Escaped<'w> {
    inner: &'w mut (dyn Write + Send),
    /// Bytes of a character that has not come whole.
    rest: Vec<u8>,
}

impl Write for Escaped<'_> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        // Most pieces are plain; line feeds and blanks of the layout among them.
        if self.rest.is_empty() && bytes.iter().all(|&byte| byte == b'\n' || (b' '..0x7f).contains(&byte)) {
            self.inner.write_all(bytes)?;
            return Ok(bytes.len());
        }
        self.rest.extend_from_slice(bytes);
        let whole = match std::str::from_utf8(&self.rest) {
            Ok(text) => text.len(),
            Err(error) => error.valid_up_to(),
        };
        let text: String = std::str::from_utf8(self.rest.get(..whole).unwrap_or(&[])).unwrap_or("").chars().fold(String::new(), escape);
        self.rest.drain(..whole);
        self.inner.write_all(text.as_bytes())?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        self.inner.flush()
    }
}

fn escape(mut text: String, character: char) -> String {
    if character != '\n' && is_harmful(character) {
        let mut units = [0; 2];
        for unit in character.encode_utf16(&mut units) {
            text.push_str(&format!("\\u{unit:04x}"));
        }
    } else {
        text.push(character);
    }
    text
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn json_reads_as_before_and_commands_nothing() {
        let value = serde_json::json!({ "tit\u{202e}le": "µ\u{1b}[31m\u{9b}\u{7f}\n\"\\ \u{e0041}", "é": [1.5, null] });
        let text = format!("{value:#}");
        // However the bytes come.
        for piece in 1..9 {
            let mut out: Vec<u8> = Vec::new();
            let mut escaped = Escaped { inner: &mut out, rest: Vec::new() };
            text.as_bytes().chunks(piece).for_each(|bytes| escaped.write_all(bytes).unwrap());
            let out = String::from_utf8(out).unwrap();
            assert_eq!(serde_json::from_str::<serde_json::Value>(&out).unwrap(), value);
            assert!(out.chars().all(|character| character == '\n' || !is_harmful(character)), "{out:?}");
        }
    }
}
