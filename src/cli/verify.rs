//! `viscotack verify`: the studies, and their report.

use super::{Failure, print};
use crate::outcome::folder;
use crate::studies::{Effort, Progress, Verdict, chosen, files, run};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::path::Path;
use std::time::Duration;

/// A check failed.
const FAILED: u8 = 1;

pub(super) fn verify(names: &[String], full: bool, out: &Path, force: bool) -> Result<u8, Failure> {
    let wrong = |message: String| Failure::Wrong(format!("error: {message}\n"));
    let studies = chosen(names).map_err(|error| wrong(error.to_string()))?;
    // Before the minutes, not after them.
    folder::writable(out, force)?;
    let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} parts, {elapsed}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    let watched = bar.clone();
    let progress = Progress::new(move |done, expected| {
        watched.set_length(expected);
        watched.set_position(done);
    });
    let report = run(&studies, if full { Effort::Full } else { Effort::Reduced }, &progress);
    bar.finish_and_clear();
    let files = files(&report).map_err(|error| wrong(error.to_string()))?;
    folder::write_whole(out, force, &files)?;
    print(&report.table())?;
    print(&format!("wrote {}: report.html, summary.json and {} tables\n", out.display(), files.len() - 2))?;
    Ok(if report.count(Verdict::Failed) > 0 { FAILED } else { 0 })
}
