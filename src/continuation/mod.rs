//! Roots and curves: the safeguarded scalar root, two and three equations, curves by arclength and their folds.

pub mod arclength;
pub mod curve;
pub mod fold;
pub mod root;
pub mod signed_root;
pub mod three_unknowns;
pub mod two_unknowns;
