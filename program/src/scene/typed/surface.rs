//! A periodic profile or surface that slides steadily, with a law of attraction or without adhesion, as a scene gives it.

use super::attraction::SceneAttraction;
use super::{ElasticBody, SlidingContact};
use std::sync::Arc;
use viscotack::finite_range::line::Profile;
use viscotack::sliding::layer::Backing;

/// A surface that slides steadily and acts at a distance.
///
/// Reduced: lengths along the surface in 1/k (the period is 2π), heights and gaps in Λ, pressures in E0*kΛ/2.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceSliding {
    /// The sliding surface.
    pub surface: Arc<SceneSurface>,
    /// Its elasticity; none for a rigid one.
    pub counter_body: Option<ElasticBody>,
    /// A layer in place of a half-space.
    pub layer: Option<SceneLayer>,
    /// v (m/s), of either sign.
    pub speed: f64,
    /// What the rig imposes.
    pub control: SurfaceLoad,
    /// The contacts to solve, in the order named.
    pub contacts: Vec<SlidingContact>,
    /// The law of attraction, if there is adhesion.
    pub attraction: Option<SceneAttraction>,
    /// How the state is reached.
    pub reached_by: SurfacePath,
    /// What is looked for.
    pub task: SurfaceTask,
    /// Places along each direction at which fields are given, if asked for.
    pub field_points: Option<u32>,
    /// Most nodes along the sliding direction, if given.
    pub most_nodes: Option<u32>,
}

/// One period of a sliding surface.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneSurface {
    /// What it is: "wave", "harmonics", "profile file", "rough profile", "map", "rough surface".
    pub word: &'static str,
    /// Its heights (m; Λ in a reduced scene), positive towards the viscoelastic body.
    pub profile: Profile,
    /// Its period along the sliding direction (m; 2π in a reduced scene).
    pub period: f64,
    /// What was chosen in reading it, a sentence each.
    pub notes: Vec<String>,
}

/// A layer of finite thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneLayer {
    /// Thickness (m; 1/k in a reduced scene).
    pub thickness: f64,
    /// What holds its far face.
    pub backing: Backing,
    /// ν, the same at all times.
    pub poisson_ratio: f64,
}

/// What the rig imposes on a sliding surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SurfaceLoad {
    /// p̄ (Pa).
    MeanPressure(f64),
    /// Mean gap (m).
    MeanGap(f64),
    /// The far end of a frame.
    Frame {
        /// Stiffness per nominal area (Pa/m).
        stiffness: f64,
        /// The mean gap (m) at which the frame carries nothing.
        mean_gap: f64,
    },
}

/// How a state is reached: several may exist at one load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurfacePath {
    /// From a long range of the law, at the same load.
    LongRange,
    /// By raising the load from a light contact.
    Loading,
    /// By lowering the load from a heavy contact.
    Unloading,
    /// Every state that a search finds.
    Every,
}

/// What is looked for of a sliding surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SurfaceTask {
    /// The state under the load.
    State,
    /// Loading from the given mean pressure to another and back.
    Loop {
        /// The other mean pressure (Pa).
        to: f64,
        /// States on each way.
        points: u32,
    },
    /// The branch of the state through its folds, both ways.
    Branch {
        /// States on each way, at most.
        points: u32,
    },
}
