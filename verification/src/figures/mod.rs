//! The figures of the thesis, from one manifest: scenes, curves, plots, and what each figure must show.
//!
//! ```text
//! verification/figures.toml ──► sources: scenes and closed forms, computed in parallel, kept by their hash
//!                                  └─► panels: curves selected from them ──► CSV, SVG
//!                                         └─► features: a number measured on a curve, held against what the thesis says or a limit demands
//! ```
//! A feature that holds is *passed*. A claim of the thesis that does not come out stays in as *not confirmed*, with what comes out instead and why; if it
//! should come out one day, or something else does, it fails. Every feature is measured again on mutated curves ([`Mutation`]): one that no mutation
//! breaks would be a decoration, and fails.

mod curve;
mod draw;
mod feature;
mod forms;
mod jobs;
mod manifest;
mod measure;
mod mutation;
mod quantity;
mod report;
mod run;
mod scenes;
mod sheet;
mod shown;
mod source;
mod store;
mod table;

pub use feature::{Checked, FeatureResult};
pub use manifest::{Manifest, ManifestError};
pub use mutation::Mutation;
pub use report::{FigureReport, PanelReport, Report};
pub use run::{FiguresError, Options, run};
pub use scenes::{PanelScenes, write_scenes};
