//! Roots and curves: brackets by halves, the safeguarded scalar root, two and three equations, curves by arclength and their folds, polylines beside records.

pub mod arclength;
pub mod bracket;
pub mod curve;
pub mod fold;
pub mod polyline;
pub mod root;
pub mod signed_root;
pub mod three_unknowns;
pub mod two_unknowns;
