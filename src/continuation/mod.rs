//! Roots and curves: the safeguarded scalar root, two equations in two unknowns, and later arclength and folds.

pub mod root;
pub mod signed_root;
pub mod two_unknowns;
