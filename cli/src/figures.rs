//! `viscotack figures`: the thesis's figures, computed, drawn and checked.

use super::{Failure, print};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::collections::BTreeSet;
use std::path::Path;
use std::time::Duration;
use viscotack_program::regular_file;
use viscotack_program::terminal_text::name;
use viscotack_verification::figures::{FeatureResult, FiguresError, Manifest, Options, PanelScenes, run, write_scenes};

/// No manifest that a person writes is larger (bytes).
const LARGEST: u64 = 16 << 20;

/// A feature failed.
const FAILED: u8 = 1;

fn failure(error: FiguresError) -> Failure {
    match error {
        FiguresError::Folder(error) => error.into(),
        error => Failure::Wrong(format!("error: {error}\n")),
    }
}

/// One line a panel, then how many files there are.
fn write_scenes_of(manifest: &Manifest, options: &Options, folder: &Path) -> Result<u8, Failure> {
    let panels = write_scenes(manifest, options, folder).map_err(failure)?;
    let files: BTreeSet<&String> = panels.iter().flat_map(|panel| &panel.files).collect();
    print(&panels.iter().map(PanelScenes::line).collect::<String>())?;
    let first = files.first().map_or_else(String::new, |file| format!("; solve one: viscotack run {} --out DIR", name(&folder.join(file))));
    print(&format!("{} scenes in {}{first}\n", files.len(), name(folder)))?;
    Ok(0)
}

pub(super) fn figures(options: &Options, scenes: Option<&Path>, manifest: Option<&Path>) -> Result<u8, Failure> {
    let wrong = |message: String| Failure::Wrong(format!("error: {message}\n"));
    let manifest = match manifest {
        Some(path) => {
            let unreadable = |error: &dyn std::fmt::Display| wrong(format!("`{}` cannot be read: {error}", name(path)));
            let bytes = regular_file::read(path, LARGEST).map_err(|error| unreadable(&error))?;
            let text = String::from_utf8(bytes).map_err(|error| unreadable(&error))?;
            Manifest::parse(&text)
        }
        None => Manifest::embedded(),
    }
    .map_err(|error| wrong(error.to_string()))?;
    if let Some(folder) = scenes {
        return write_scenes_of(&manifest, options, folder);
    }
    viscotack_program::threads::prepare(None);
    let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} sources, {elapsed}") {
        bar.set_style(style);
    }
    // Where nobody sees it, it needs no thread.
    if !bar.is_hidden() && !viscotack_program::threads::is_alone() {
        bar.enable_steady_tick(Duration::from_millis(200));
    }
    let progress = |done: usize, total: usize| {
        bar.set_length(total as u64);
        bar.set_position(done as u64);
    };
    let report = run(&manifest, options, &progress).map_err(failure)?;
    bar.finish_and_clear();
    print(&report.table())?;
    match &options.out {
        Some(out) => print(&format!("wrote {}: one CSV and one SVG a panel, features.csv, index.html\n", name(out)))?,
        None => print("(nothing written; add --out DIR for tables, plots and the contact sheet)\n")?,
    }
    Ok(if report.count(FeatureResult::Failed) > 0 { FAILED } else { 0 })
}
