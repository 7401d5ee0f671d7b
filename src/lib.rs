//! Adhesive contact and fracture of linear viscoelastic solids, from one energy balance at the edge.

pub mod elastic;
pub mod estimate;
pub mod outcome;
pub mod refusal;

pub use estimate::Estimate;
pub use refusal::Refusal;
