//! Which build of the program this is. Two builds may round differently, so that neither goes on where the other was interrupted.

use super::owned::{digest, digest_of_read};
use rayon::prelude::*;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::OnceLock;

/// Bytes of the program file that are digested at once: the file is long, and the work waits for it.
const PART: u64 = 1 << 20;

/// Where a linker puts its note, at most.
const HEAD: u64 = 64 << 10;
/// Of a note of a linker: four bytes of a name, the length of the number, the kind 3, and the name.
const NOTE: [&[u8]; 3] = [&[4, 0, 0, 0], &[0, 0, 0], &[3, 0, 0, 0, b'G', b'N', b'U', 0]];
/// Lengths of such a number (bytes).
const LENGTHS: std::ops::RangeInclusive<u8> = 8..=64;

/// Version, commit, and the first digits of a digest of the number that the linker gave the program, which is one of all its bytes, and of the length of the file;
/// without such a number of the whole file. A commit alone does not say which sources, compiler and options made it.
///
/// Where the file cannot be read, the process and its time stand instead: such a build shares nothing with any other run.
#[must_use]
pub fn identity() -> &'static str {
    static IDENTITY: OnceLock<String> = OnceLock::new();
    IDENTITY.get_or_init(|| {
        let digest = std::env::current_exe().and_then(|path| digest_of_program(&path.canonicalize()?));
        let build = digest.map_or_else(|_| unlike_any_other(), |digest| digest.chars().take(32).collect());
        format!("viscotack {} {} build {build}", crate::VERSION, crate::COMMIT)
    })
}

fn digest_of_program(path: &Path) -> std::io::Result<String> {
    let mut head = Vec::new();
    let mut file = File::open(path)?;
    file.by_ref().take(HEAD).read_to_end(&mut head)?;
    match linkers_number(&head) {
        Some(number) => Ok(digest(&[number, &file.metadata()?.len().to_le_bytes()].concat())),
        None => digest_of_parts(path),
    }
}

/// The number in the linker's note, `.note.gnu.build-id`.
fn linkers_number(head: &[u8]) -> Option<&[u8]> {
    let [name, length, kind] = NOTE;
    let parts =
        |note: &[u8]| note.starts_with(name) && LENGTHS.contains(&note[4]) && note[5..].starts_with(length) && note[8..].starts_with(kind);
    let place = head.windows(16).position(parts)?;
    let number = usize::from(*head.get(place + 4)?);
    head.get(place + 16..place + 16 + number)
}

fn digest_of_parts(path: &Path) -> std::io::Result<String> {
    let parts = std::fs::metadata(path)?.len().div_ceil(PART);
    let of_part = |part: u64| -> std::io::Result<String> {
        let mut file = File::open(path)?;
        file.seek(SeekFrom::Start(part * PART))?;
        digest_of_read(file.take(PART))
    };
    let digests = (0..parts).into_par_iter().map(of_part).collect::<std::io::Result<Vec<_>>>()?;
    Ok(digest(digests.concat().as_bytes()))
}

fn unlike_any_other() -> String {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0, |since| since.as_nanos());
    format!("unknown-{}-{now}", std::process::id())
}

#[cfg(test)]
mod tests {
    use super::linkers_number;

    #[test]
    fn the_number_of_a_linker_is_found_and_nothing_else() {
        let note = |length: u8, kind: u8| [&[9, 4, 0, 0, 0, length, 0, 0, 0, kind, 0, 0, 0][..], b"GNU\0", &[7; 20], &[1; 9]].concat();
        assert_eq!(linkers_number(&note(20, 3)), Some(&[7; 20][..]));
        assert_eq!(linkers_number(&note(20, 1)), None);
        assert_eq!(linkers_number(&note(200, 3)), None);
        assert_eq!(note(20, 3).get(..30).and_then(linkers_number), None);
        assert_eq!(linkers_number(&[]), None);
    }
}
