//! What is wrong with a scene, and what must be said about it.
#![allow(unreachable_pub, missing_docs)]

pub mod delayed;
pub mod indentation;
pub mod sliding;

/// One kind of mistake.
pub struct Case {
    pub kind: &'static str,
    /// What is replaced by what in the good scene; each must stand there exactly once. An empty text to replace: appended at the end.
    pub edits: &'static [(&'static str, &'static str)],
    /// Further arguments of `run`.
    pub arguments: &'static [&'static str],
    /// A file beside the scene.
    pub file: Option<(&'static str, &'static str)>,
    /// A text in the line that the error must name, or `--set KEY`, or nothing where no line can be blamed.
    pub place: &'static str,
    /// What the error must say.
    pub says: &'static [&'static str],
}

/// Nothing wrong: what a case does not say.
pub const NONE: Case = Case { kind: "", edits: &[], arguments: &[], file: None, place: "", says: &[] };
