//! `viscotack verify`: the studies, and their report.

use super::{Failure, note, print};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use viscotack_program::outcome::folder;
use viscotack_verification::studies::{CheckResult, Effort, Progress, chosen, files, run};

/// A check failed.
const FAILED: u8 = 1;
/// Without a terminal: no longer than this without a line, as long as pieces are done.
const QUIET: Duration = Duration::from_secs(30);

pub(super) fn verify(names: &[String], full: bool, out: &Path, force: bool) -> Result<u8, Failure> {
    let wrong = |message: String| Failure::Wrong(format!("error: {message}\n"));
    let studies = chosen(names).map_err(|error| wrong(error.to_string()))?;
    viscotack_program::threads::prepare(None);
    // Before the minutes, not after them.
    folder::writable(out, force)?;
    let effort = if full { Effort::Full } else { Effort::Reduced };
    let report = if std::io::stderr().is_terminal() {
        let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} parts, {elapsed}") {
            bar.set_style(style);
        }
        if !viscotack_program::threads::is_alone() {
            bar.enable_steady_tick(Duration::from_millis(200));
        }
        let watched = bar.clone();
        let progress = Progress::new(move |done, expected| {
            watched.set_length(expected);
            watched.set_position(done);
        });
        let report = run(&studies, effort, &progress);
        bar.finish_and_clear();
        report
    } else {
        run(&studies, effort, &plain_progress())
    };
    let files = files(&report).map_err(|error| wrong(error.to_string()))?;
    // What was found is not lost with a folder that somebody else has made meanwhile.
    print(&report.table())?;
    folder::write_whole(out, force, "report", &files)?;
    print(&format!("wrote {}: report.html, summary.json and {} tables\n", viscotack_program::terminal_text::name(out), files.len() - 2))?;
    Ok(if report.count(CheckResult::Failed) > 0 { FAILED } else { 0 })
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
