//! A law of attraction with a range, as a scene gives it.

use viscotack::finite_range::law::Attraction;

/// What the surfaces do to each other at a distance: `adhesion.law` or `adhesion.table`, in place of a process zone.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneAttraction {
    /// The law, in SI units; in a reduced scene in its units of length and pressure, the work of adhesion in pressure times length.
    pub attraction: Attraction,
    /// The word of the law in scenes and tables; "table" of a table.
    pub word: &'static str,
    /// What was chosen in reading a table, a sentence each.
    pub notes: Vec<String>,
}
