//! Roots and curves: the safeguarded scalar root, and later arclength and folds.

pub mod root;
pub mod signed_root;
