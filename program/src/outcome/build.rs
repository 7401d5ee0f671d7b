//! Which build of the program this is. Two builds may round differently, so that neither goes on where the other was interrupted.

use super::owned::digest_of;
use std::sync::OnceLock;

/// Version, commit, and the first digits of the SHA-256 of the program file: a commit alone does not say which sources, compiler and options made it.
///
/// Where the file cannot be read, the process and its time stand instead: such a build shares nothing with any other run.
#[must_use]
pub fn identity() -> &'static str {
    static IDENTITY: OnceLock<String> = OnceLock::new();
    IDENTITY.get_or_init(|| {
        let digest = std::env::current_exe().and_then(|path| digest_of(&path.canonicalize()?));
        let build = digest.map_or_else(|_| unlike_any_other(), |digest| digest.chars().take(32).collect());
        format!("viscotack {} {} build {build}", crate::VERSION, crate::COMMIT)
    })
}

fn unlike_any_other() -> String {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0, |since| since.as_nanos());
    format!("unknown-{}-{now}", std::process::id())
}
