//! Ctrl-C: a run says what is kept and how it goes on, then ends as the signal wants. A limit of the size of files becomes an error instead of a death.

use super::output::note;
use std::sync::atomic::{AtomicUsize, Ordering};
use viscotack_program::terminal_text::is_harmful;

/// States that are in the journal.
static FINISHED: AtomicUsize = AtomicUsize::new(0);

/// Counts the states that are finished.
pub(super) fn finished(states: usize) {
    FINISHED.store(states, Ordering::Relaxed);
}

/// From now on an interrupted run says so: with the partial folder, if it has one, in which so many states are kept.
#[cfg(unix)]
pub(super) fn explain(partial: Option<String>, states: usize) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    // Without a thread for it the signal does what it always does.
    let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGTERM, SIGHUP]) else { return };
    let watch = move || {
        if let Some(signal) = signals.forever().next() {
            note(&words(partial.as_deref(), states));
            let _ = signal_hook::low_level::emulate_default_handler(signal);
        }
    };
    // Where no thread is to be had, the handler would swallow the signal.
    if viscotack_program::threads::is_alone() || std::thread::Builder::new().spawn(watch).is_err() {
        for signal in [SIGINT, SIGTERM, SIGHUP] {
            let always = std::sync::Arc::new(std::sync::atomic::AtomicBool::new(true));
            let _ = signal_hook::flag::register_conditional_default(signal, always);
        }
    }
}

/// Elsewhere the system ends the run without a word; its journal is kept all the same.
#[cfg(not(unix))]
pub(super) fn explain(_: Option<String>, _: usize) {}

/// A write beyond a limit of the size of files then fails as on a full disk.
pub(super) fn limits_are_errors() {
    #[cfg(unix)]
    {
        let seen = std::sync::Arc::new(std::sync::atomic::AtomicBool::new(false));
        let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, seen);
    }
}

#[cfg_attr(not(unix), allow(dead_code))]
fn words(partial: Option<&str>, states: usize) -> String {
    let Some(partial) = partial else {
        return "\ninterrupted: nothing is kept; a run with --out DIR goes on where it was interrupted\n".to_owned();
    };
    let finished = FINISHED.load(Ordering::Relaxed);
    let kept =
        format!("\ninterrupted: {finished} of {states} states are finished and kept in `{partial}`, with checkpoints of those under way");
    match command() {
        Some(command) => format!("{kept}; to go on:\n  {command}\n"),
        None => format!("{kept}; the same command goes on\n"),
    }
}

/// The command line, to be pasted into a shell; none if it cannot be shown.
fn command() -> Option<String> {
    std::env::args_os().map(|word| word.to_str().and_then(quoted)).collect::<Option<Vec<_>>>().map(|words| words.join(" "))
}

fn quoted(word: &str) -> Option<String> {
    let plain = |character: char| character.is_ascii_alphanumeric() || "_-./=,:+@%".contains(character);
    if word.chars().any(is_harmful) {
        None
    } else if !word.is_empty() && word.chars().all(plain) {
        Some(word.to_owned())
    } else {
        Some(format!("'{}'", word.replace('\'', "'\\''")))
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn words_are_quoted_for_a_shell() {
        assert_eq!(quoted("--set").as_deref(), Some("--set"));
        assert_eq!(quoted("crack.speed=\"1 mm/s\"").as_deref(), Some("'crack.speed=\"1 mm/s\"'"));
        assert_eq!(quoted("it's").as_deref(), Some("'it'\\''s'"));
        assert_eq!(quoted("a\nb"), None);
        assert_eq!(quoted("").as_deref(), Some("''"));
    }
}
