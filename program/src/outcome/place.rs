//! Where a finished folder goes: to its place in one step, the folder that it replaces out of the way first and deleted last.

use super::folder::FolderError;
use super::journal::Journal;
use super::known_digests::KnownDigests;
use super::owned::OwnedFolder;
use crate::terminal_text;
use std::path::{Path, PathBuf};

fn io(path: &Path) -> impl Fn(std::io::Error) -> FolderError + '_ {
    FolderError::io(path)
}

/// A path beside another, its name with an ending.
pub(super) fn beside(target: &Path, ending: &str) -> PathBuf {
    // Collecting the components drops a stroke at the end.
    let mut name = target.components().collect::<PathBuf>().into_os_string();
    name.push(ending);
    PathBuf::from(name)
}

/// Whether anything is there, a link to nothing too.
pub(super) fn is_there(path: &Path) -> bool {
    std::fs::symlink_metadata(beside(path, "")).is_ok()
}

pub(super) fn is_empty(folder: &Path) -> bool {
    !beside(folder, "").is_symlink() && std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none())
}

/// Whether a folder of files may be written there.
///
/// # Errors
/// A folder that exists (without `force`), or holds anything that this program has not written.
pub fn writable(target: &Path, force: bool) -> Result<(), FolderError> {
    may_be_written(target, force, &KnownDigests::default())
}

pub(super) fn may_be_written(target: &Path, force: bool, known: &KnownDigests) -> Result<(), FolderError> {
    if !is_there(target) || (force && is_empty(target)) {
        return Ok(());
    }
    let path = terminal_text::name(target);
    if !force {
        return Err(FolderError::Exists(path));
    }
    let owned = OwnedFolder::open(target, None)?.with_known(known);
    match owned.foreign()? {
        Some(why) => Err(FolderError::NotOwned { path, why }),
        None if !owned.is_sealed() => Err(FolderError::NotOwned { path, why: "it is not the finished folder of a run".to_owned() }),
        None => Ok(()),
    }
}

/// Writes files that are all there already, as a folder of a kind: beside the place of the folder, then moved there in one step.
///
/// # Errors
/// Those of [`writable`], or a file system that refuses.
pub fn write_whole(target: &Path, force: bool, kind: &str, files: &[(String, Vec<u8>)]) -> Result<(), FolderError> {
    let known = KnownDigests::default();
    may_be_written(target, force, &known)?;
    let mut partial = OwnedFolder::make(&beside(target, &format!(".partial-{}", std::process::id())), kind, &[])?;
    let written = files
        .iter()
        .try_for_each(|(name, bytes)| partial.write(name, bytes))
        .and_then(|()| partial.seal())
        .and_then(|()| moved(partial.path(), target, force, &known))
        .and_then(|replaced| replaced.map_or(Ok(()), |aside| remove_replaced(&aside, &known)));
    if written.is_err() && is_there(partial.path()) {
        // The reason is the one before.
        drop(partial.remove());
    }
    written
}

/// Moves a finished folder to its place and deletes what it makes needless: the folder that it replaces, and the journal.
pub(super) fn put_in_place(
    result: &OwnedFolder,
    target: &Path,
    force: bool,
    known: &KnownDigests,
    (journal, partial): (Journal, OwnedFolder),
) -> Result<(), FolderError> {
    let replaced = moved(result.path(), target, force, known)?;
    drop(journal);
    // Long files take a while: side by side.
    let remove_partial = || partial.remove();
    let (removed, partial) = rayon::join(|| replaced.map_or(Ok(()), |aside| remove_replaced(&aside, known)), remove_partial);
    removed.and(partial.map(drop))
}

/// Moves a finished folder to its place; one that is there steps aside first, and is to be deleted.
fn moved(partial: &Path, target: &Path, force: bool, known: &KnownDigests) -> Result<Option<PathBuf>, FolderError> {
    // Somebody may have put something there since the run began.
    may_be_written(target, force, known)?;
    if !is_there(target) {
        return std::fs::rename(partial, target).map(|()| None).map_err(io(target));
    }
    let aside = beside(target, &format!(".replaced-{}", std::process::id()));
    std::fs::rename(target, &aside).map_err(io(target))?;
    if let Err(error) = std::fs::rename(partial, target) {
        // The old one is worth more than none.
        let back = std::fs::rename(&aside, target);
        return Err(io(target)(back.err().unwrap_or(error)));
    }
    Ok(Some(aside))
}

/// Deletes a folder that was replaced.
fn remove_replaced(aside: &Path, known: &KnownDigests) -> Result<(), FolderError> {
    if is_empty(aside) {
        return std::fs::remove_dir(aside).map_err(io(aside));
    }
    match OwnedFolder::open(aside, None)?.with_known(known).remove()? {
        true => Ok(()),
        false => Err(FolderError::NotOwned {
            path: terminal_text::name(aside),
            why: "files were put into the folder that was replaced".to_owned(),
        }),
    }
}
