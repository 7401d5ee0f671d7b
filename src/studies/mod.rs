//! The studies behind `viscotack verify`: what accuracy costs, where it is hard, what each effect adds.
//!
//! ```text
//! study: fn(Effort, &Progress) -> Section      paragraphs, tables, plots, checks: plain data, no files, no HTML
//!   STUDIES ──► all sections, side by side; those that measure times afterwards, alone on one core
//!      └─► report: one self-contained page and a CSV for each table and plot
//! ```
//! A study never stops half-way: what goes wrong in it is a failed [`Check`] of its section. Studies may use rivals; no plan may.

mod cells;
pub mod draw;
pub mod effects;
pub mod hard_cases;
pub mod honesty;
pub mod known_states;
pub mod scene_bytes;
pub mod seeded_sweep;

mod section;

pub use section::{Cell, Check, Column, Effort, Plot, Progress, Section, Table, Verdict, failures, ours, rival, stored};

/// One study: what the page calls it, and what computes it.
#[derive(Clone, Copy)]
pub struct Study {
    /// Short name: the anchor on the page and the beginning of the names of its CSV files.
    pub identifier: &'static str,
    /// It measures times, so nothing else may run beside it.
    pub alone: bool,
    /// Computes the section.
    pub compute: fn(Effort, &Progress) -> Section,
}

/// All studies, in the order of the page.
pub const STUDIES: &[Study] = &[
    Study { identifier: "honesty", alone: false, compute: honesty::study },
    Study { identifier: "hard-cases", alone: false, compute: hard_cases::study },
    Study { identifier: "seeded-sweep", alone: false, compute: seeded_sweep::study },
    Study { identifier: "effects", alone: true, compute: effects::study },
];
