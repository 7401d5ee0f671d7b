//! The file of a table, opened with care and decoded.

use super::decode::decode;
use crate::regular_file;
use crate::scene::diagnostic::SourceText;
use crate::scene::recognise::is_table_or_deck;
use std::path::Path;

/// The largest table (bytes): it is held in memory as a whole, beside a few words for each cell.
const LARGEST_TABLE: u64 = 64 * 1024 * 1024;

/// Reads a file that a scene names as a table; `name` is what the scene calls it.
///
/// # Errors
/// A sentence that says why it cannot be read: no regular file, too large, no text.
pub fn open(path: &Path, name: &str) -> Result<SourceText, String> {
    let bytes = regular_file::read(path, LARGEST_TABLE).map_err(|error| error.to_string())?;
    let (text, encoding) = decode(bytes)?;
    let source = SourceText::decoded(name, text, encoding);
    Ok(if is_table_or_deck(source.text()) { source } else { source.hidden() })
}
