//! Headers of force curves as microscopes export them: names and units in comments, `# columns: …` and `# units: …`.
//!
//! The marks and keys are overwritten with blanks, so that the lines are names and units like those of any table, and every place in the text stays.

use crate::scene::diagnostic::SourceText;

/// The text with its commented names and units laid open; none if it has no such line.
pub(super) fn laid_open(source: &SourceText) -> Option<String> {
    let text = source.text();
    let key_of = |line: &str| {
        let body = line.trim_start().strip_prefix('#')?.trim_start();
        ["columns:", "units:"].into_iter().find(|key| body.starts_with(key)).map(|key| line.len() - body.len() + key.len())
    };
    text.lines().any(|line| key_of(line).is_some()).then(|| {
        text.split_inclusive('\n')
            .map(|line| {
                key_of(line).map_or_else(|| line.to_owned(), |length| format!("{}{}", " ".repeat(length), line.get(length..).unwrap_or("")))
            })
            .collect()
    })
}
