//! What comes out of a calculation: so far, its plots.

pub mod plot;
