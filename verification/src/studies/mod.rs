//! The studies behind `viscotack verify`: what accuracy costs, where it is hard, what each effect adds.
//!
//! ```text
//! study: fn(Effort, &Progress) -> Section      paragraphs, tables, plots, checks: plain data, no files, no HTML
//!   STUDIES ──► all sections, side by side; those that measure times afterwards, alone on one core
//!      └─► report: one self-contained page and a CSV for each table and plot
//! ```
//! A study never stops half-way: what goes wrong in it is a failed [`Check`] of its section. Studies may use rivals; no plan may.

pub mod calibration;
mod cells;
mod convergence;
pub mod counters;
pub mod draw;
pub mod effects;
pub mod event_lists;
pub mod finite_spheres;
pub mod fit_coverage;
pub mod fits;
pub mod hard_cases;
pub mod held_contacts;
pub mod known_states;
mod manufactured;
pub mod order;
pub mod pieces;
pub mod precision;
pub mod published_spheres;
pub mod random_lines;
mod reference;
mod report;
mod run;
pub mod scene_bytes;
mod section;
pub mod seeded_sweep;
mod stamp;
pub mod stored;
pub mod timing;
pub mod whole_grammar;

pub use report::{PAGE, files};
pub use run::{Report, StudiesError, chosen, in_shards, run};
pub use section::{
    Cell, Check, CheckResult, Column, Effort, Plot, Progress, Section, Table, failures, ours, rival, stored as stored_curve,
};
pub use stamp::Stamp;

/// One study: what the page calls it, and what computes it.
#[derive(Debug, Clone, Copy)]
pub struct Study {
    /// Short name: the anchor on the page and the beginning of the names of its CSV files.
    pub identifier: &'static str,
    /// It measures times, so nothing else may run beside it.
    pub alone: bool,
    /// It consists of many independent pieces, so that a shard of it can be run.
    pub in_pieces: bool,
    /// Computes the section.
    pub compute: fn(Effort, &Progress) -> Section,
}

/// A study that may run beside others.
const fn beside(identifier: &'static str, compute: fn(Effort, &Progress) -> Section) -> Study {
    Study { identifier, alone: false, in_pieces: false, compute }
}

/// A study that measures times.
const fn alone(identifier: &'static str, compute: fn(Effort, &Progress) -> Section) -> Study {
    Study { identifier, alone: true, in_pieces: false, compute }
}

/// A study that may run beside others, and in shards.
const fn in_pieces(identifier: &'static str, compute: fn(Effort, &Progress) -> Section) -> Study {
    Study { identifier, alone: false, in_pieces: true, compute }
}

/// All studies, in the order of the page.
pub const STUDIES: &[Study] = &[
    alone("precision_sliding", precision::sliding::study),
    alone("precision_strength", precision::strength::study),
    alone("precision_sphere", precision::sphere::study),
    alone("precision_finite_spheres", finite_spheres::cost::study),
    alone("precision_lines", precision::lines::study),
    alone("precision_growth", precision::growth::study),
    alone("precision_steady_crack", precision::steady_crack::study),
    alone("precision_peers", precision::peers::study),
    beside("convergence_sliding", convergence::sliding::study),
    beside("convergence_sphere", convergence::sphere::study),
    beside("convergence_crack", convergence::crack::study),
    beside("process_zone", convergence::zone::study),
    beside("manufactured", manufactured::study),
    beside("calibration", calibration::study),
    beside("grammar", whole_grammar::study),
    beside("hard_cases", hard_cases::study),
    beside("held_contacts", held_contacts::study),
    in_pieces("finite_spheres", finite_spheres::study),
    beside("published_spheres", published_spheres::study),
    in_pieces("random_lines", random_lines::study),
    beside("seeded_sweep", seeded_sweep::study),
    beside("event_lists", event_lists::study),
    beside("scene_bytes", scene_bytes::study),
    alone("fits", fits::study),
    beside("fit_coverage", fit_coverage::study),
    alone("effects", effects::study),
];
