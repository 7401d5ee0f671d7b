//! What only a solution knows of a history: where a segment at a rate starts, and when a condition ends one.

use crate::scene::typed::Condition;

/// What is not known yet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Open {
    /// Where a segment starts: its quantity was not controlled before.
    Start(usize),
    /// When a segment ends.
    Stop {
        segment: usize,
        /// When it begins.
        began: f64,
        /// How long it takes if its condition is never met.
        full: f64,
        /// Coherent.
        condition: Condition,
    },
}

/// Where a segment starts: found by solving the history before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start {
    /// Which segment.
    pub(super) segment: usize,
    /// The value of its quantity there, coherent.
    pub(super) value: f64,
    /// The error of that value over the way of the segment: by so much its rate is off.
    pub(super) error: f64,
}

/// When a segment ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stop {
    /// Which segment.
    pub(super) segment: usize,
    /// How long it takes.
    pub(super) duration: f64,
    /// Whether its condition is met; if not, it ends by itself.
    pub(super) met: bool,
    /// Whether the condition is met by a jump, and the segment ends right after it.
    pub(super) sudden: bool,
}

/// What is known.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Known {
    pub(super) starts: Vec<Start>,
    pub(super) stops: Vec<Stop>,
}

/// The end of a segment with a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ended {
    pub(super) segment: usize,
    pub(super) began: f64,
    pub(super) time: f64,
    /// Coherent.
    pub(super) condition: Condition,
    /// Whether it was met.
    pub(super) met: bool,
    /// Whether its time follows from the history alone.
    pub(super) exact: bool,
    /// Whether a jump met it.
    pub(super) sudden: bool,
}
