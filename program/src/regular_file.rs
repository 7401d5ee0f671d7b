//! The one way to read a file that somebody names: a regular file, not larger than is sensible. A pipe may never answer, and a device never ends.

use std::fs::{File, Metadata, metadata};
use std::io::{Error, Read, Result};
use std::path::Path;

/// All bytes of a regular file of at most `most` bytes. A link to such a file is one, too.
///
/// # Errors
/// What the system says, or that it is no regular file, or too large: the sentence names no path.
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>> {
    // Before it is opened: opening a pipe waits for its other end.
    let mut length = regular(&metadata(path)?)?;
    let mut bytes = Vec::new();
    if length <= most {
        let file = File::open(path)?;
        // Another file may be there by now.
        length = regular(&file.metadata()?)?;
        // It may grow while it is read.
        file.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    }
    if length.max(bytes.len() as u64) > most {
        return Err(Error::other(too_large(most)));
    }
    Ok(bytes)
}

/// A regular file of any length, open for reading.
///
/// # Errors
/// What the system says, or that it is no regular file: the sentence names no path.
pub fn open(path: &Path) -> Result<File> {
    regular(&metadata(path)?)?;
    let file = File::open(path)?;
    regular(&file.metadata()?)?;
    Ok(file)
}

/// A stream to its end, of at most `most` bytes.
///
/// # Errors
/// What the system says, or that it is too large.
pub fn read_stream(stream: impl Read, most: u64) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    stream.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(Error::other(too_large(most))) } else { Ok(bytes) }
}

fn too_large(most: u64) -> String {
    format!("it has more than {} MiB", most / (1024 * 1024))
}

/// The length of a regular file.
fn regular(about: &Metadata) -> Result<u64> {
    if about.is_dir() {
        Err(Error::other("it is a folder, not a file"))
    } else if about.is_file() {
        Ok(about.len())
    } else {
        Err(Error::other("it is a pipe or a device: only regular files are read"))
    }
}
