//! A scene: what a person types, read, checked against one catalogue of keys, and turned into typed problems.
//!
//! ```text
//! file ──► document (tree with places) ──► check (every key, type, unit, range) ──► read (typed scene, contradictions)
//!                 ▲                              ▲
//!            --set, sweep                    catalogue ──► schema, documentation, nearest key
//! ```
//! A table that is absent is an effect that is not simulated. Every error names file, line, key, value, what is allowed and, for a
//! misspelt key, the nearest one. The reader never panics, whatever the bytes.

pub mod catalogue;
pub mod check;
pub mod delimited;
pub mod diagnostic;
pub mod document;
mod frame;
pub mod key_reference;
mod npy;
mod plausible;
pub mod read;
mod recognise;
pub mod schema;
pub mod suggest;
pub mod sweep;
pub mod template;
pub mod typed;
pub mod units;
mod written;
pub mod written_units;

pub use diagnostic::SceneError;
pub use document::Document;
pub use typed::Scene;
pub use written::history_written_out;
