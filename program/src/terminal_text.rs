//! Text on its way to a terminal: names, titles and arguments may hold characters that command a terminal or turn the direction of a line.

/// What is shown of a character: control characters, and marks that turn the direction of a line or take no width, are blanks.
#[must_use]
pub fn shown(character: char) -> char {
    if is_harmful(character) { ' ' } else { character }
}

/// Whether a character commands a terminal or changes how its neighbours look.
#[must_use]
pub fn is_harmful(character: char) -> bool {
    matches!(
        character,
        '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}'
    ) || character.is_control()
}

/// A text on one line.
#[must_use]
pub fn one_line(text: &str) -> String {
    text.chars().map(shown).collect()
}

/// A text of lines: line feeds and tabulators stay.
#[must_use]
pub fn lines(text: &str) -> String {
    text.chars().map(|character| if matches!(character, '\n' | '\t') { character } else { shown(character) }).collect()
}

/// The name of a file, on one line.
#[must_use]
pub fn name(path: &std::path::Path) -> String {
    one_line(&path.display().to_string())
}

#[cfg(test)]
mod tests {
    use super::{lines, one_line};

    #[test]
    fn only_what_is_harmless_is_left() {
        assert_eq!(one_line("a\u{1b}[31m\n\u{9b}b\u{202e}µ\u{7f}"), "a [31m  b µ ");
        assert_eq!(lines("a\n\tb\r\u{2066}é\u{61c}"), "a\n\tb  é ");
    }
}
