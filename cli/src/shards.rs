//! `viscotack run --shard i/n` and `viscotack gather`: a sweep in parts, which many machines solve.

use super::run::{Wanted, carry_out, progress_bar, say_what_is_kept, show};
use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, interrupt, print};
use std::path::{Path, PathBuf};
use viscotack_program::outcome::Status;
use viscotack_program::outcome::build;
use viscotack_program::outcome::folder::{RunFolder, partial_of};
use viscotack_program::outcome::gather::Shards;
use viscotack_program::outcome::journal::Journal;
use viscotack_program::outcome::shard::Shard;
use viscotack_program::plan::{self, Safe, Stage};
use viscotack_program::terminal_text::name;

/// States that are copied together.
const TOGETHER: usize = 256;

/// Solves the states of a shard. However they end, they are kept: the exit code of the whole sweep is that of `gather`.
pub(super) fn run(arguments: &SceneArguments, out: &Path, force: bool, shard: Shard) -> Result<u8, Failure> {
    let mut source = SceneSource::load(arguments)?;
    arguments.threads.start();
    let inputs = source.inputs(&arguments.sets);
    // Pictures are drawn by `gather`.
    source.scene.plots.clear();
    let plan = plan::Plan::new(&source.scene)?;
    let header = plan::journal_header(&source.document, &source.scene, shard);
    let states = header.own_states();
    interrupt::explain(Some(name(&partial_of(out))), states);
    let mut folder = RunFolder::open(out, || header.clone(), force)?;
    say_what_is_kept(&mut folder, states);
    let bar = progress_bar(states);
    let progress = |stage: Stage| show(&bar, states, stage);
    let (journal, checkpoints) = folder.journal();
    let tally = plan::run_shard(&plan, &source.document, &source.scene, &header, Safe { journal, checkpoints }, &progress)?;
    bar.finish_and_clear();
    folder.finish_shard(&inputs)?;
    let ended = Status::ALL.into_iter().map(|status| (tally.ended(status).rows, status.word())).filter(|(rows, _)| *rows > 0);
    let ended: Vec<String> = ended.map(|(rows, word)| format!("{rows} {word}")).collect();
    print(&format!(
        "shard {shard}: {states} of {} states in {} rows ({})\nwrote      {}; once all shards are there: viscotack gather DIR … --out RESULT\n",
        header.states,
        tally.rows,
        if ended.is_empty() { "none".to_owned() } else { ended.join(", ") },
        name(out)
    ))?;
    Ok(0)
}

/// Brings shards together.
pub(super) fn gather(folders: &[PathBuf], wanted: &Wanted<'_>) -> Result<u8, Failure> {
    let shards = Shards::open(folders, build::identity())?;
    let source = SceneSource::of_inputs(shards.inputs())?;
    if source.document.hash() != shards.header().scene {
        return Err(Failure::Wrong("error: the scene in shard.json is not the one that was solved: solve the shards again\n".to_owned()));
    }
    carry_out(source, Some(&shards), wanted)
}

/// Copies the rows of all states that a journal does not hold yet.
pub(super) fn copy(shards: &Shards, journal: &mut Journal) -> Result<(), Failure> {
    let from = journal.states();
    let mut together: Vec<Vec<u8>> = Vec::with_capacity(TOGETHER);
    let mut hand_over = |together: &mut Vec<Vec<u8>>| -> Result<(), Failure> {
        journal.append_encoded(together.iter().map(Vec::as_slice)).map_err(plan::RunError::Journal)?;
        together.clear();
        Ok(())
    };
    shards.each_from(from, |content| {
        together.push(content.to_vec());
        if together.len() < TOGETHER { Ok(()) } else { hand_over(&mut together) }
    })?;
    hand_over(&mut together)
}
