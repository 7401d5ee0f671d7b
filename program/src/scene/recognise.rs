//! Whether a text looks like what a scene may name: an error shows no line of a file that does not, whatever its reader was given.

use super::catalogue::names_in;
use super::read::decks::recognised;

/// Whether a text is binary: it holds control characters that no text has.
fn is_binary(text: &str) -> bool {
    text.chars().any(|character| character.is_control() && !matches!(character, '\t' | '\n' | '\r' | '\u{c}' | '\u{1a}' | '\u{85}'))
}

/// Whether a line of it names a key or a table of a scene.
pub(super) fn is_scene(text: &str) -> bool {
    let names_key = |line: &str| {
        let word = line.trim_start_matches([' ', '\t', '[']);
        let end = word.find(|character: char| !character.is_ascii_alphanumeric() && character != '_').unwrap_or(word.len());
        let (name, rest) = word.split_at(end);
        rest.trim_start().starts_with(['=', '.', ']']) && names_in("").chain(names_in("material")).any(|known| known == name)
    };
    !is_binary(text) && text.lines().any(names_key)
}

/// Whether a line of it is a row of numbers, or the whole is a material card.
pub(super) fn is_table_or_deck(text: &str) -> bool {
    let is_row = |line: &str| {
        let cells = || line.split([',', ';', '\t', '|', ' ', '"', '\'']).filter(|cell| !cell.is_empty());
        cells().next().is_some() && cells().all(|cell| cell.parse::<f64>().is_ok())
    };
    !is_binary(text) && (text.trim().is_empty() || text.lines().any(is_row) || recognised(text).is_some())
}

#[cfg(test)]
mod tests {
    use super::{is_scene, is_table_or_deck};

    #[test]
    fn files_of_other_kinds_are_none() {
        for other in [
            "root:x:0:0:root:/root:/bin/sh\nbin:x:1:1::/:\n",
            "-----BEGIN KEY-----\nb3BlbnNzaC1r\n",
            "password = secret\n",
            "1 2\n\u{1b}[31m",
            "a\u{7}",
        ] {
            assert!(!is_scene(other) && !is_table_or_deck(other), "{other:?}");
        }
        assert!(is_scene("titel = 3\n [ material ]\n") || is_scene("accuracy = [\n"));
        assert!(is_table_or_deck("t [s];G [Pa]\n1,5;2,0\n") && is_table_or_deck("'1' 2e3\n") && is_table_or_deck(""));
    }
}
