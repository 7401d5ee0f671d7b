//! Which build of the program this is. Two builds may round differently, so that neither goes on where the other was interrupted.

use super::owned::{digest, digest_of_read};
use rayon::prelude::*;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::OnceLock;

/// Bytes of the program file that are digested at once: the file is long, and the work waits for it.
const PART: u64 = 1 << 20;

/// Version, commit, and the first digits of a digest of the program file (the SHA-256 of those of its parts): a commit alone does not say which sources, compiler and options made it.
///
/// Where the file cannot be read, the process and its time stand instead: such a build shares nothing with any other run.
#[must_use]
pub fn identity() -> &'static str {
    static IDENTITY: OnceLock<String> = OnceLock::new();
    IDENTITY.get_or_init(|| {
        let digest = std::env::current_exe().and_then(|path| digest_of_parts(&path.canonicalize()?));
        let build = digest.map_or_else(|_| unlike_any_other(), |digest| digest.chars().take(32).collect());
        format!("viscotack {} {} build {build}", crate::VERSION, crate::COMMIT)
    })
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
