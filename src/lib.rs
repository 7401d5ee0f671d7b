//! Adhesive contact and fracture of linear viscoelastic solids, from one energy balance at the edge.

pub mod cli;
pub mod closure;
pub mod continuation;
pub mod crack;
pub mod elastic;
pub mod estimate;
pub mod figures;
pub mod finite_range;
pub mod fit;
pub mod in_order;
pub mod indentation;
pub mod material;
pub mod outcome;
pub mod plan;
pub mod refusal;
pub mod regular_file;
pub mod rivals;
pub mod scene;
pub mod sliding;
pub mod special;
pub mod studies;
pub mod terminal_text;
pub mod threads;

pub use estimate::Estimate;
pub use material::Material;
pub use refusal::Refusal;
