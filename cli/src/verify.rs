//! `viscotack verify`: the studies, and their report.

use super::{Failure, note, print};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::fs::File;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use viscotack_program::outcome::folder::{self, FolderError};
use viscotack_program::outcome::owned::OwnedFolder;
use viscotack_program::outcome::shard::Shard;
use viscotack_program::terminal_text::name;
use viscotack_verification::studies::pieces::Pieces;
use viscotack_verification::studies::{CheckResult, Effort, Progress, chosen, files, in_shards, run};

/// A check failed.
const FAILED: u8 = 1;
/// Without a terminal: no longer than this without a line, as long as pieces are done.
const QUIET: Duration = Duration::from_secs(30);
/// Finished pieces of long studies.
const PIECES: &str = "pieces.txt";

/// `DIR.partial` with the finished pieces of long studies.
struct Kept {
    folder: OwnedFolder,
    file: PathBuf,
    _lock: Option<File>,
}

impl Kept {
    fn open(out: &Path) -> Result<Self, Failure> {
        let mut folder = OwnedFolder::open_or_make(&folder::partial_of(out), "studies", &[PIECES])?;
        let lock = folder.lock()?;
        if lock.is_none() {
            return Err(Failure::Wrong(format!("error: another run of `verify` writes to {}\n", name(folder.path()))));
        }
        let file = folder.file(PIECES)?;
        Ok(Self { folder, file, _lock: lock })
    }
}

pub(super) fn verify(names: &[String], full: bool, shard: Option<Shard>, out: &Path, force: bool) -> Result<u8, Failure> {
    let wrong = |message: String| Failure::Wrong(format!("error: {message}\n"));
    let studies = chosen(names).map_err(|error| wrong(error.to_string()))?;
    if shard.is_some() {
        in_shards(&studies).map_err(|error| wrong(error.to_string()))?;
    }
    viscotack_program::threads::prepare(None);
    // Before the minutes, not after them.
    folder::writable(out, force)?;
    let effort = if full { Effort::Full } else { Effort::Reduced };
    // Hours are not lost with a run that is killed.
    let kept = if full { Some(Kept::open(out)?) } else { None };
    let with_pieces = |progress: Progress| {
        let progress = progress.with_shard(shard.unwrap_or_default());
        match &kept {
            Some(kept) => Pieces::open(&kept.file).map(|pieces| progress.with_pieces(pieces)).map_err(FolderError::io(&kept.file)),
            None => Ok(progress),
        }
    };
    let report = |progress: &Progress| {
        let report = run(&studies, effort, progress);
        if let Some(why) = progress.not_kept() {
            note(&format!("warning: what was finished could not be kept for a further run: {why}\n"));
        }
        report
    };
    let report = if std::io::stderr().is_terminal() {
        let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} parts, {elapsed}") {
            bar.set_style(style);
        }
        if !viscotack_program::threads::is_alone() {
            bar.enable_steady_tick(Duration::from_millis(200));
        }
        let watched = bar.clone();
        let progress = with_pieces(Progress::new(move |done, expected| {
            watched.set_length(expected);
            watched.set_position(done);
        }))?;
        let report = report(&progress);
        bar.finish_and_clear();
        report
    } else {
        report(&with_pieces(plain_progress())?)
    };
    let files = files(&report).map_err(|error| wrong(error.to_string()))?;
    // What was found is not lost with a folder that somebody else has made meanwhile.
    print(&report.table())?;
    let result = if report.count(CheckResult::Failed) > 0 { FAILED } else { 0 };
    if let (Some(kept), false) = (&kept, report.shard.is_whole()) {
        print(&format!("kept its pieces in {}: without --shard the report is made of those of all shards\n", name(kept.folder.path())))?;
        return Ok(result);
    }
    folder::write_whole(out, force, "report", &files)?;
    if let Some(kept) = kept {
        kept.folder.remove()?;
    }
    print(&format!("wrote {}: report.html, summary.json and {} tables\n", name(out), files.len() - 2))?;
    Ok(result)
}

/// Plain lines for a log: one as each section ends, and the parts done where none has for a while.
fn plain_progress() -> Progress {
    let begin = Instant::now();
    let last = Arc::new(Mutex::new(begin));
    let of_sections = Arc::clone(&last);
    Progress::new(move |done, expected| {
        // Whoever holds the clock writes the line.
        if let Ok(mut last) = last.try_lock()
            && last.elapsed() >= QUIET
        {
            *last = Instant::now();
            note(&format!("{done} of {expected} parts after {:.0} s\n", begin.elapsed().as_secs_f64()));
        }
    })
    .with_sections(move |identifier, seconds| {
        if let Ok(mut last) = of_sections.lock() {
            *last = Instant::now();
        }
        note(&format!("section {identifier}: {seconds:.1} s\n"));
    })
}
