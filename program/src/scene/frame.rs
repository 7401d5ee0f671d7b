//! The lines of a text that an error shows: cut to a width, without characters that command a terminal.

use super::diagnostic::{Place, SceneError};
use crate::terminal_text;
use miette::{Diagnostic, LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use std::fmt;
use std::ops::Range;

/// Most characters of a line that are shown.
const WIDEST: usize = 160;
/// Characters before a place that stay where a long line is cut.
const AHEAD: usize = 60;
/// Most lines of a place that are shown.
const MOST_LINES: usize = 12;

/// A piece of a text, with the place in it.
#[derive(Debug)]
pub(super) struct Frame {
    name: String,
    text: String,
    /// Lines before the piece.
    lines_before: usize,
    /// Bytes cut off at the start of the line of the place, less those put in their stead.
    cut: usize,
    span: Range<usize>,
}

impl Frame {
    pub(super) fn of(place: &Place) -> Self {
        let text = place.source.text();
        let start = boundary(text, place.span.start);
        let end = boundary(text, place.span.end).max(start);
        let first = line_start(text, start);
        let mut lines = Vec::new();
        let mut at = line_start(text, first.saturating_sub(1));
        if first >= 2 && text.get(first - 2..first) == Some("\r\n") {
            at = line_start(text, first - 2);
        }
        let begin = at;
        // One line before the place, and one behind it.
        let mut behind = false;
        while lines.len() < MOST_LINES && !behind {
            let length = text.get(at..).unwrap_or("").find(['\n', '\r']).unwrap_or(text.len().saturating_sub(at));
            lines.push(at..at + length);
            behind = at > end;
            let next = match text.as_bytes().get(at + length..) {
                Some([b'\r', b'\n', ..]) => at + length + 2,
                Some([_, ..]) => at + length + 1,
                _ => break,
            };
            at = next;
        }
        let mut frame = Self {
            name: terminal_text::one_line(place.source.name()),
            text: String::new(),
            lines_before: super::delimited::decode::line_at(text, begin) - 1,
            cut: 0,
            span: 0..0,
        };
        let (mut from, mut to) = (None, None);
        for (index, line) in lines.iter().enumerate() {
            if index > 0 {
                frame.text.push('\n');
            }
            let holds = |place: usize| line.start <= place && place <= line.end;
            let shown = window(text, line, if holds(start) { start } else { line.start });
            if shown.start > line.start {
                frame.text.push('…');
            }
            if holds(start) && from.is_none() {
                from = Some(frame.text.len() + clean_length(text, shown.start, start.clamp(shown.start, shown.end)));
                frame.cut = (shown.start - line.start).saturating_sub(if shown.start > line.start { '…'.len_utf8() } else { 0 });
            }
            if holds(end) {
                to = Some(frame.text.len() + clean_length(text, shown.start, end.clamp(shown.start, shown.end)));
            }
            frame.text.extend(text.get(shown.clone()).unwrap_or("").chars().map(clean));
            if shown.end < line.end {
                frame.text.push('…');
            }
        }
        let from = from.unwrap_or(0);
        frame.span = from..to.unwrap_or(frame.text.len()).max(from);
        frame
    }
}

/// The part of a line that is shown, around a place.
fn window(text: &str, line: &Range<usize>, place: usize) -> Range<usize> {
    let words = text.get(line.clone()).unwrap_or("");
    let length = words.chars().count();
    if length <= WIDEST {
        return line.clone();
    }
    let column = text.get(line.start..place).unwrap_or("").chars().count();
    let first = column.saturating_sub(AHEAD).min(length - (WIDEST - 2));
    let byte = |count: usize| words.char_indices().nth(count).map_or(line.end, |(at, _)| line.start + at);
    byte(first)..byte(first + WIDEST - 2)
}

/// What is shown of a character; a tabulator stays.
fn clean(character: char) -> char {
    if character == '\t' { '\t' } else { terminal_text::shown(character) }
}

fn clean_length(text: &str, from: usize, to: usize) -> usize {
    text.get(from..to).unwrap_or("").chars().map(|character| clean(character).len_utf8()).sum()
}

fn line_start(text: &str, at: usize) -> usize {
    text.get(..at).unwrap_or("").rfind(['\n', '\r']).map_or(0, |place| place + 1)
}

/// The nearest place at or before one that lies between two characters.
fn boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl SourceCode for Frame {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let inner = self.text.read_span(span, lines_before, lines_after)?;
        let own = inner.span().offset() == self.span.start;
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            inner.data(),
            *inner.span(),
            inner.line() + self.lines_before,
            inner.column() + if own { self.cut } else { 0 },
            inner.line_count(),
        )))
    }
}

/// An error with the lines that it shows.
#[derive(Debug)]
pub(super) struct Framed<'e> {
    pub(super) error: &'e SceneError,
    pub(super) frame: Option<Frame>,
}

impl fmt::Display for Framed<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.fmt(formatter)
    }
}

impl std::error::Error for Framed<'_> {}

impl Diagnostic for Framed<'_> {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.error.remedy().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.frame.as_ref().map(|frame| frame as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span = &self.frame.as_ref()?.span;
        let label = self.error.label();
        let label = (!label.is_empty()).then(|| label.to_owned());
        Some(Box::new(std::iter::once(LabeledSpan::new(label, span.start, span.len()))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::diagnostic::SourceText;

    fn shown(text: &str, span: Range<usize>) -> String {
        let place = Place { source: SourceText::new("t.csv", text.to_owned()), span };
        SceneError::at(&place, "m", "here").rendered()
    }

    #[test]
    fn long_lines_are_cut_around_the_place() {
        let line = format!("{}WRONG{}", "a;".repeat(500), ";b".repeat(500));
        let report = shown(&format!("x\n{line}\ny\n"), 1002..1007);
        assert!(report.contains("WRONG") && report.contains("t.csv:2:1001"), "{report}");
        assert!(report.lines().all(|line| line.chars().count() <= WIDEST + 20), "{report}");
        assert!(report.contains("x\n") && report.contains('y'), "{report}");
    }

    #[test]
    fn no_character_commands_a_terminal() {
        let report = shown("a\u{1b}[31m\u{7}b\u{202e}\r\nWRONG\u{9b}\rc", 13..18);
        assert!(report.chars().all(|c| c == '\n' || !c.is_control()), "{report:?}");
        assert!(!report.contains('\u{202e}') && report.contains("t.csv:2:"), "{report}");
    }

    /// Every line end counts, and every span is drawn, whatever it is.
    #[test]
    fn any_place_is_shown() {
        for text in ["", "a", "a\r\rb\r", "ä\nö\r\nü", "\n\n\n"] {
            for start in 0..text.len() + 3 {
                for end in start..text.len() + 3 {
                    assert!(shown(text, start..end).contains("t.csv:"), "{text:?} {start} {end}");
                }
            }
        }
        assert!(shown("a\rb\rWRONG\rc", 4..9).contains("t.csv:3:1"));
    }
}
