//! `viscotack run`: solve a scene.

use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, interrupt, note, print, print_json};
use crate::outcome::folder::{RunFolder, partial_of};
use crate::outcome::{screen, summary};
use crate::plan::{self, Safe, Stage};
use crate::terminal_text::name;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::path::Path;
use std::time::Duration;

/// Parts of a bar of one state.
const PARTS: u64 = 1000;

pub(super) fn run(arguments: &SceneArguments, out: Option<&Path>, force: bool, json: bool) -> Result<u8, Failure> {
    let source = SceneSource::load(arguments)?;
    crate::threads::prepare();
    // A number that the physics refuses is found before a folder is touched.
    let plan = plan::Plan::new(&source.scene)?;
    let states = plan.states();
    interrupt::explain(out.map(|target| name(&partial_of(target))), states);
    let mut folder = None;
    let mut finished = Vec::new();
    if let Some(target) = out {
        let header = plan::journal_header(&source.document, &source.scene);
        let (mut opened, kept) = RunFolder::open(target, &header, force)?;
        let begun = opened.journal().1.begun(states);
        if !kept.is_empty() || begun > 0 {
            let under_way = if begun > 0 { format!(", {begun} begun") } else { String::new() };
            note(&format!("resuming: {} of {states} states were finished before{under_way}\n", kept.len()));
        }
        interrupt::finished(kept.len());
        (folder, finished) = (Some(opened), kept);
    }
    let bar = progress_bar(states);
    let progress = |stage: Stage| show(&bar, states, stage);
    let safe = folder.as_mut().map(|folder| {
        let (journal, checkpoints) = folder.journal();
        Safe { journal, checkpoints }
    });
    let outcome = plan::run_planned(&plan, &source.document, &source.scene, finished, safe, &progress)?;
    bar.finish_and_clear();
    // Results that cannot be written are printed, and such that cannot be printed are written.
    let files = folder.map(|folder| folder.finish(&outcome, &source.text)).transpose();
    let printed = if json {
        print_json(|out| summary::write_whole(&outcome, out).map_err(Into::into))
    } else {
        print(&screen::render(&outcome)).and_then(|()| match (out, &files) {
            (Some(target), Ok(Some(files))) => {
                let omitted = summary::omitted(&outcome);
                let note =
                    if omitted > 0 { format!(" (summary.json without its {omitted} rows, which states.csv holds)") } else { String::new() };
                print(&format!("wrote      {}: {}{note}\n", name(target), files.join(", ")))
            }
            (None, _) => print("(nothing written; add --out DIR for summary.json, tables and plots)\n"),
            _ => Ok(()),
        })
    };
    files?;
    printed?;
    Ok(outcome.exit_code())
}

/// A bar on a terminal's standard error, for work that takes long enough to be waited for.
fn progress_bar(states: usize) -> ProgressBar {
    let (length, template) = if states == 1 {
        (PARTS, "{bar:40} {percent} %{msg}, {eta} left")
    } else {
        (states as u64, "{bar:40} {pos}/{len} states{msg}, {eta} left")
    };
    let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    // Where nobody sees it, it needs no thread.
    if !bar.is_hidden() && !crate::threads::is_alone() {
        bar.enable_steady_tick(Duration::from_millis(200));
    }
    bar
}

/// Shows a stage: of one state alone the march under way, each of which starts the bar and its clock anew.
fn show(bar: &ProgressBar, states: usize, stage: Stage) {
    if let Stage::States { finished, .. } = stage {
        interrupt::finished(finished);
    }
    match stage {
        Stage::States { finished, .. } if states > 1 => bar.set_position(finished as u64),
        Stage::States { .. } => {}
        Stage::Draws { finished, total, .. } if states == 1 => {
            bar.set_message(" of the draws of the material");
            bar.set_position(PARTS * finished as u64 / total.max(1) as u64);
        }
        Stage::Draws { state, finished, total } => bar.set_message(format!("; state {} at draw {finished} of {total}", state + 1)),
        Stage::March { number, part, .. } if states == 1 => {
            let message = format!(" of march {number}");
            if bar.message() != message {
                bar.set_message(message);
                bar.reset_eta();
            }
            bar.set_position((part * PARTS as f64) as u64);
        }
        Stage::March { state, number, part } => {
            bar.set_message(format!("; state {} at {:.0} % of its march {number}", state + 1, 100.0 * part));
        }
    }
}
