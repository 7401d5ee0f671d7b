//! Adhesive contact and fracture of linear viscoelastic solids, from one energy balance at the edge.

pub mod closure;
pub mod continuation;
pub mod crack;
pub mod elastic;
pub mod estimate;
pub mod finite_range;
pub mod fit;
pub mod indentation;
pub mod material;
pub mod refusal;
pub mod sliding;
pub mod special;

pub use estimate::Estimate;
pub use material::Material;
pub use refusal::Refusal;
