//! `viscotack run`: solve a scene.

use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, print};
use crate::outcome::folder::RunFolder;
use crate::outcome::{screen, summary};
use crate::plan;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::path::Path;
use std::time::Duration;

pub(super) fn run(arguments: &SceneArguments, out: Option<&Path>, force: bool, json: bool) -> Result<u8, Failure> {
    let source = SceneSource::load(arguments)?;
    // A number that the physics refuses is found before a folder is touched.
    plan::Plan::new(&source.scene)?;
    let header = plan::journal_header(&source.document, &source.scene);
    let mut folder = None;
    let mut finished = Vec::new();
    if let Some(target) = out {
        let (opened, states) = RunFolder::open(target, &header, force)?;
        if !states.is_empty() {
            eprintln!("resuming: {} of {} states were finished before", states.len(), header.states);
        }
        (folder, finished) = (Some(opened), states);
    }
    let bar = progress_bar(header.states);
    let progress = |done: usize, _total: usize| bar.set_position(done as u64);
    let outcome = plan::run(&source.document, &source.scene, finished, folder.as_mut().map(RunFolder::journal), &progress)?;
    bar.finish_and_clear();
    let files = folder.map(|folder| folder.finish(&outcome, &source.text)).transpose()?;
    if json {
        print(&format!("{:#}\n", summary::summary(&outcome)))?;
    } else {
        print(&screen::render(&outcome))?;
        match (out, files) {
            (Some(target), Some(files)) => print(&format!("wrote      {}: {}\n", target.display(), files.join(", ")))?,
            _ => print("(nothing written; add --out DIR for summary.json, tables and plots)\n")?,
        }
    }
    Ok(outcome.exit_code())
}

/// A bar on a terminal's standard error, for work that takes long enough to be waited for.
fn progress_bar(states: usize) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(states as u64), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} states, {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
