//! `viscotack run`: solve a scene.

use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, interrupt, note, print, print_json, shards};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::path::Path;
use std::time::Duration;
use viscotack_program::outcome::folder::{RunFolder, partial_of};
use viscotack_program::outcome::gather::Shards;
use viscotack_program::outcome::shard::Shard;
use viscotack_program::outcome::{Outcome, Row, Status, screen, summary};
use viscotack_program::plan::{self, Safe, Stage};
use viscotack_program::terminal_text::name;

/// What is wanted of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted<'a> {
    pub(super) out: Option<&'a Path>,
    pub(super) force: bool,
    pub(super) json: bool,
    pub(super) no_plots: bool,
}

/// Parts of a bar of one state.
const PARTS: u64 = 1000;

pub(super) fn run(arguments: &SceneArguments, wanted: &Wanted<'_>) -> Result<u8, Failure> {
    let source = SceneSource::load(arguments)?;
    arguments.threads.start();
    carry_out(source, None, wanted)
}

/// Solves a scene; with shards, takes the rows of all states from them.
pub(super) fn carry_out(mut source: SceneSource, shards: Option<&Shards>, wanted: &Wanted<'_>) -> Result<u8, Failure> {
    let &Wanted { out, force, json, no_plots } = wanted;
    if no_plots || out.is_none() {
        source.scene.plots.clear();
    }
    // A number that the physics refuses is found before a folder is touched.
    let plan = plan::Plan::new(&source.scene)?;
    let states = plan.states();
    interrupt::explain(out.map(|target| name(&partial_of(target))), states);
    // The header tells the build, for which the program reads its own file: only where there is a journal.
    let header = || plan::journal_header(&source.document, &source.scene, Shard::WHOLE);
    let mut folder = out.map(|target| RunFolder::open(target, header, force)).transpose()?;
    if let Some(folder) = &mut folder {
        say_what_is_kept(folder, states);
    }
    if let (Some(folder), Some(shards)) = (&mut folder, shards) {
        shards::copy(shards, folder.journal().0)?;
    }
    let bar = progress_bar(states);
    let progress = |stage: Stage| show(&bar, states, stage);
    let safe = folder.as_mut().map(|folder| {
        let (journal, checkpoints) = folder.journal();
        Safe { journal, checkpoints }
    });
    if json && safe.is_none() && !plan.keeps_all_rows() {
        return streamed(&plan, &source, &bar, &progress);
    }
    let outcome = plan::run_planned(&plan, &source.document, &source.scene, safe, None, &progress)?;
    bar.finish_and_clear();
    // Results that cannot be written are printed, and such that cannot be printed are written. The rows of a long sweep are printed from the journal, before
    // the folder takes its place.
    let mut printed = if json { print_json(|out| summary::write_whole(&outcome, out)) } else { Ok(()) };
    let files = folder.map(|folder| folder.finish(&outcome, &source.text)).transpose();
    if !json {
        printed = print(&screen::render(&outcome)).and_then(|()| match (out, &files) {
            (Some(target), Ok(Some(files))) => {
                let omitted = summary::omitted(&outcome);
                let place = summary::omitted_rows_are_in(&outcome);
                let note =
                    if omitted > 0 { format!(" (summary.json without its {omitted} rows, which are in {place})") } else { String::new() };
                print(&format!("wrote      {}: {}{note}\n", name(target), files.join(", ")))
            }
            (None, _) => print("(nothing written; add --out DIR for summary.json, tables and plots)\n"),
            _ => Ok(()),
        });
    }
    files?;
    printed?;
    say_what_is_missing(&outcome);
    let code = outcome.exit_code();
    // The process ends: giving back the memory of many rows one by one would only take time.
    std::mem::forget(outcome);
    Ok(code)
}

/// Of a run that was interrupted before, how much of it is there.
pub(super) fn say_what_is_kept(folder: &mut RunFolder, states: usize) {
    let (journal, checkpoints) = folder.journal();
    let (finished, begun) = (journal.states(), checkpoints.begun());
    if finished > 0 || begun > 0 {
        let under_way = if begun > 0 { format!(", {begun} begun") } else { String::new() };
        note(&format!("resuming: {finished} of {states} states were finished before{under_way}\n"));
    }
    interrupt::finished(finished);
}

/// A long sweep whose rows are printed as they come.
fn streamed(plan: &plan::Plan, source: &SceneSource, bar: &ProgressBar, progress: plan::Progress<'_>) -> Result<u8, Failure> {
    let (swept, columns) = (plan::swept_columns(&source.scene), plan.columns());
    let names = summary::Names { swept: &swept, labels: plan.labels(), columns: &columns };
    let mut code = 0;
    let mut failure = None;
    print_json(|out| {
        let mut text = summary::Streamed::new(names, out)?;
        let mut sink = |rows: &[Row]| rows.iter().try_for_each(|row| text.write(row));
        match plan::run_planned(plan, &source.document, &source.scene, None, Some(&mut sink), progress) {
            Ok(outcome) => {
                bar.finish_and_clear();
                code = outcome.exit_code();
                text.finish(&outcome)?;
                say_what_is_missing(&outcome);
                Ok(())
            }
            // Nothing but the sink writes here.
            Err(plan::RunError::Journal(error)) => Err(error),
            Err(other) => {
                failure = Some(other);
                Ok(())
            }
        }
    })?;
    failure.map_or(Ok(code), |error| Err(error.into()))
}

/// Of a sweep, how many states are the reason for its exit code.
fn say_what_is_missing(outcome: &Outcome) {
    if outcome.exit_code() == 4 && !outcome.swept.is_empty() {
        let count = |status: Status| outcome.tally.ended(status).states.max(usize::from(outcome.tally.ended(status).rows > 0));
        let statuses = [Status::Inaccurate, Status::NotConverged, Status::Inadmissible].into_iter().filter(|status| count(*status) > 0);
        let parts: Vec<String> = statuses.map(|status| format!("{} {}", count(status), status.word())).collect();
        note(&format!("exit code 4: of {} states, {}\n", outcome.tally.states, parts.join(", ")));
    }
}

/// A bar on a terminal's standard error, for work that takes long enough to be waited for.
pub(super) fn progress_bar(states: usize) -> ProgressBar {
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
    if !bar.is_hidden() && !viscotack_program::threads::is_alone() {
        bar.enable_steady_tick(Duration::from_millis(200));
    }
    bar
}

/// Shows a stage: of one state alone the integration under way, each of which starts the bar and its clock anew.
pub(super) fn show(bar: &ProgressBar, states: usize, stage: Stage) {
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
        Stage::Integration { number, part, .. } if states == 1 => {
            let message = format!(" of integration {number}");
            if bar.message() != message {
                bar.set_message(message);
                bar.reset_eta();
            }
            bar.set_position((part * PARTS as f64) as u64);
        }
        Stage::Integration { state, number, part } => {
            bar.set_message(format!("; state {} at {:.0} % of its integration {number}", state + 1, 100.0 * part));
        }
    }
}
