//! What a solved history has to say beside its numbers: a pull that ends before anything has let go.

use super::known::Ended;

/// Words for the row of a state; `held`: whether the contact holds at the end of the history, under the largest tension.
pub(super) fn remarks(ends: &[Ended], held: bool) -> Option<String> {
    let unmet = ends.iter().any(|end| !end.met).then_some("a segment ended at its limit, before its condition was met");
    let holds =
        held.then_some("the contact still holds at the end of the history, under its largest tension: pull_off_force is no pull-off yet");
    let all: Vec<&str> = unmet.into_iter().chain(holds).collect();
    (!all.is_empty()).then(|| all.join("; "))
}
