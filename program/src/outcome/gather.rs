//! Shards of a sweep brought together: their folders are checked, and their rows are read in the order of the whole sweep.
//!
//! A shard's folder holds `shard.json` (the run that it belongs to, and every text that its scene was read from) and its journal. All that is checked about a
//! journal holds here, too: a line that was altered, or is missing, has the wrong digest.

use super::folder::FolderError;
use super::journal::{JournalHeader, Lines};
use super::owned::OwnedFolder;
use super::shard::Shard;
use crate::{regular_file, terminal_text};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A file that a scene names, as it was read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputFile {
    /// Its name in the scene.
    pub name: String,
    /// How its bytes were read.
    pub encoding: String,
    /// Its text.
    pub text: String,
}

/// All that a scene was read from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Inputs {
    /// The name of the scene's file.
    pub name: String,
    /// Its text.
    pub text: String,
    /// The values that were put into it, as they were typed.
    pub sets: Vec<String>,
    /// The files that it names.
    pub files: Vec<InputFile>,
}

/// What `shard.json` holds.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct ShardFile {
    pub(super) header: JournalHeader,
    pub(super) inputs: Inputs,
}

/// Why folders are not the shards of one run.
#[derive(Debug, Error)]
pub enum GatherError {
    /// A folder that no shard has written, or that is still being written.
    #[error("`{path}` is not the finished folder of a shard: {why}")]
    NoShard {
        /// The folder.
        path: String,
        /// What is there instead, and what to do.
        why: String,
    },
    /// Two runs are mixed.
    #[error("`{one}` and `{other}` are shards of different runs: {what}")]
    Mixed {
        /// A folder.
        one: String,
        /// Another.
        other: String,
        /// What differs.
        what: String,
    },
    /// The shards were solved by another program than this one.
    #[error("the shards were solved by {theirs}, and this is {own}: gather them with the program that solved them")]
    OtherProgram {
        /// Theirs.
        theirs: String,
        /// This one.
        own: String,
    },
    /// A part is there twice.
    #[error("shard {shard} is given twice: `{one}` and `{other}`: leave one out")]
    Twice {
        /// Which.
        shard: Shard,
        /// A folder.
        one: String,
        /// Another.
        other: String,
    },
    /// Parts are not there.
    #[error(
        "{missing} of {of} shards are missing ({names}): solve them with `viscotack run SCENE --shard i/{of} --out DIR`, and name their folders, too"
    )]
    Missing {
        /// How many.
        missing: usize,
        /// Of how many.
        of: usize,
        /// The first of them.
        names: String,
    },
    /// Rows of a shard were altered, or cut short.
    #[error("`{path}`: the rows of state {state} were altered or are missing: solve this shard again")]
    Altered {
        /// The journal.
        path: String,
        /// Which state of the sweep, from 1.
        state: usize,
    },
    /// Nothing to gather.
    #[error("no folder of a shard is named")]
    NoFolder,
    /// A file that cannot be read.
    #[error("`{path}` cannot be read: {error}")]
    Io {
        /// The file.
        path: String,
        /// The system's words.
        error: String,
    },
}

/// Names of missing shards that are listed.
const LISTED: usize = 8;
/// No `shard.json` is larger (bytes): a scene and its tables.
const LARGEST: u64 = 1 << 30;
/// Memory for reading all shards (bytes), and the least and the most for one of them.
const READ_AHEAD: usize = 32 << 20;
const LEAST_AHEAD: usize = 4 << 10;
const MOST_AHEAD: usize = 256 << 10;

/// The shards of one run, complete.
#[derive(Debug)]
pub struct Shards {
    /// In the order of their parts.
    folders: Vec<PathBuf>,
    header: JournalHeader,
    inputs: Inputs,
}

impl Shards {
    /// Checks folders: each is a finished shard, all are of one run by this program, no part is missing or there twice.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn open(folders: &[PathBuf], program: &str) -> Result<Self, GatherError> {
        let mut first: Option<(&Path, ShardFile)> = None;
        let mut places: Vec<Option<&Path>> = Vec::new();
        for path in folders {
            let found = read(path)?;
            let shard = found.header.shard;
            if let Some((one, known)) = &first {
                if let Some(what) = difference(&known.header, &found.header) {
                    return Err(GatherError::Mixed { one: shown(one), other: shown(path), what });
                }
            } else {
                places = vec![None; shard.of()];
                first = Some((path, found));
            }
            match places.get_mut(shard.part()) {
                Some(Some(other)) => return Err(GatherError::Twice { shard, one: shown(other), other: shown(path) }),
                Some(place) => *place = Some(path),
                None => {}
            }
        }
        let Some((_, ShardFile { header, inputs })) = first else { return Err(GatherError::NoFolder) };
        if header.program != program {
            return Err(GatherError::OtherProgram { theirs: terminal_text::one_line(&header.program), own: program.to_owned() });
        }
        let missing: Vec<usize> = places.iter().enumerate().filter(|(_, path)| path.is_none()).map(|(part, _)| part).collect();
        let of = places.len();
        if !missing.is_empty() {
            let mut names = missing.iter().take(LISTED).map(|part| format!("{part}/{of}")).collect::<Vec<_>>().join(", ");
            if missing.len() > LISTED {
                names.push_str(", …");
            }
            return Err(GatherError::Missing { missing: missing.len(), of, names });
        }
        let folders = places.into_iter().flatten().map(Path::to_owned).collect();
        Ok(Self { folders, header: JournalHeader { shard: Shard::WHOLE, ..header }, inputs })
    }

    /// The header of the whole run.
    #[must_use]
    pub const fn header(&self) -> &JournalHeader {
        &self.header
    }

    /// What its scene was read from.
    #[must_use]
    pub const fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// Hands over the rows of all states from one on, as journals hold them, in the order of the sweep.
    ///
    /// # Errors
    /// A journal that was altered or is too short, and what the caller reports.
    pub fn each_from<E: From<GatherError>>(&self, from: usize, mut take: impl FnMut(&[u8]) -> Result<(), E>) -> Result<(), E> {
        let ahead = (READ_AHEAD / self.folders.len().max(1)).clamp(LEAST_AHEAD, MOST_AHEAD);
        let mut journals = Vec::with_capacity(self.folders.len());
        for (part, folder) in self.folders.iter().enumerate() {
            let path = folder.join(super::folder::JOURNAL);
            let mut lines = Lines::piecewise(&path, ahead).map_err(|error| unreadable(&path, &error))?;
            let head = lines.next().map_err(|error| unreadable(&path, &error))?;
            let header = head.and_then(|content| serde_json::from_slice::<JournalHeader>(content).ok());
            let expected = Shard::new(part, self.folders.len()).map(|shard| JournalHeader { shard, ..self.header.clone() });
            if header.is_none() || header != expected {
                return Err(GatherError::NoShard {
                    path: shown(folder),
                    why: "its journal belongs to another run: solve this shard again".to_owned(),
                }
                .into());
            }
            journals.push((path, lines));
        }
        let parts = journals.len();
        for state in 0..self.header.states {
            let Some((path, lines)) = journals.get_mut(state % parts) else { break };
            let content = lines.next().map_err(|error| unreadable(path, &error))?;
            let Some(content) = content else {
                return Err(GatherError::Altered { path: shown(path), state: state + 1 }.into());
            };
            if state >= from {
                take(content)?;
            }
        }
        Ok(())
    }
}

/// What a shard's folder says about itself.
fn read(path: &Path) -> Result<ShardFile, GatherError> {
    let not = |why: String| GatherError::NoShard { path: shown(path), why };
    if !path.exists() {
        let partial = super::folder::partial_of(path);
        let why = if partial.exists() {
            format!("it is under way or was interrupted in `{}`: give the same command again to end it", shown(&partial))
        } else {
            "it does not exist".to_owned()
        };
        return Err(not(why));
    }
    let file = path.join(super::folder::SHARD_FILE);
    if !file.exists() {
        return Err(not("it holds no shard.json: solve it with `viscotack run SCENE --shard i/n --out DIR`".to_owned()));
    }
    let folder = OwnedFolder::open(path, Some(super::folder::SHARD)).map_err(|error| match error {
        FolderError::NotOwned { why, .. } => not(format!("{why}: solve this shard again")),
        other => not(other.to_string()),
    })?;
    let bytes = regular_file::read(&file, LARGEST).map_err(|error| unreadable(&file, &error))?;
    let found = if folder.is_sealed_as(super::folder::SHARD_FILE, &bytes) { serde_json::from_slice(&bytes).ok() } else { None };
    found.ok_or_else(|| not("its shard.json was altered: solve this shard again".to_owned()))
}

/// In what two runs differ.
fn difference(one: &JournalHeader, other: &JournalHeader) -> Option<String> {
    let programs = [one, other].map(|header| terminal_text::one_line(&header.program));
    if one.scene != other.scene {
        Some("their scenes differ".to_owned())
    } else if one.program != other.program {
        let [one, other] = programs;
        Some(format!("one was solved by {one}, the other by {other}"))
    } else if one.shard.of() != other.shard.of() {
        Some(format!("one is of {} shards, the other of {}", one.shard.of(), other.shard.of()))
    } else if one.states != other.states {
        Some(format!("one is of {} states, the other of {}", one.states, other.states))
    } else {
        None
    }
}

fn shown(path: &Path) -> String {
    terminal_text::name(path)
}

fn unreadable(path: &Path, error: &std::io::Error) -> GatherError {
    GatherError::Io { path: shown(path), error: error.to_string() }
}
