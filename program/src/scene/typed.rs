//! A scene after reading: typed, in coherent units, free of contradictions; plans are made from it.

mod attraction;
mod delayed;
mod fit;
mod history;
mod indentation;
mod material;
mod surface;

use super::sweep::Sweep;
use std::sync::Arc;
use viscotack::closure::work_by_speed::WorkBySpeed;
use viscotack::crack::{CrackBody, Motion};
use viscotack::elastic::PlaneState;
use viscotack::elastic::pure_shear_strip::SidewaysStrain;
use viscotack::material::Material;
use viscotack::sliding::steady::ReachedBy;

pub use super::check::Units;
pub use attraction::SceneAttraction;
pub use delayed::{DelayedFracture, LoadedStrip, OutputTimes};
pub use fit::{FitColumn, FitFree, FitTable, FitTask, FitTest};
pub use history::{
    Condition, CycleWave, History, HistoryOscillation, HistoryQuantity, HistorySegment, MeasuredColumn, MeasuredTable, OscillationExtent,
    Pace, RecordThinning, Repetition,
};
pub use indentation::{
    CounterBody, Indentation, IndentationAdhesion, IndentationFields, IndentationShape, IndentationStart, IndentationZone, MeasuredShape,
};
pub use material::{
    Climate, DeckOrigin, ExpandedLaw, FittedData, IsotropicSeries, MaterialData, MaterialOrigin, MeasuredRow, MeasuredSort, Overlap,
    PoissonRatio,
};
pub use surface::{SceneLayer, SceneSurface, SurfaceLoad, SurfacePath, SurfaceSliding, SurfaceTask};

/// A whole scene at one point of its sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The line that names it, or the name of its file.
    pub title: String,
    /// What its numbers are measured in. Reduced numbers are coherent with E0* = reference time = 1 and, of a crack, Δγ = a₀ = 1; of a
    /// sliding contact they are in the units of [`viscotack::sliding::steady::Indenter`]; of an indenter those of [`Indentation`].
    pub units: Units,
    /// Wanted relative accuracy.
    pub accuracy: f64,
    /// The material.
    pub material: SceneMaterial,
    /// What is asked.
    pub problem: Problem,
    /// What is varied; empty for a single state.
    pub sweeps: Vec<Sweep>,
    /// Numbers that are far from what is usual, a sentence each.
    pub cautions: Vec<String>,
    /// Which pictures are drawn of each plot.
    pub plots: Vec<Picture>,
}

/// A kind of picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Picture {
    /// Vectors.
    Svg,
    /// Pixels.
    Png,
}

/// The deformable solid.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneMaterial {
    /// What it is called.
    pub name: Option<String>,
    /// Both series, with Young's moduli (in a reduced scene: plane moduli).
    pub series: Material,
    /// Constant Poisson ratio, if given.
    pub poisson_ratio: Option<f64>,
    /// The shear and the bulk series, if they are given in place of a constant Poisson ratio.
    pub isotropic: Option<Arc<IsotropicSeries>>,
    /// What the series was made of.
    pub origin: MaterialOrigin,
    /// Temperature and shift factors, if given.
    pub climate: Option<Climate>,
    /// What was chosen in reading its tables, and those of works of adhesion; a sentence each.
    pub notes: Vec<String>,
    /// What is known against its numbers, a sentence each: from its file, and moduli that no solid has.
    pub cautions: Vec<String>,
    /// Series that the data leave possible, if a scene asks what they change; at the temperature of `series`.
    pub draws: Option<Arc<[Material]>>,
}

/// What a scene asks for.
#[derive(Debug, Clone, PartialEq)]
pub enum Problem {
    /// A crack that opens or closes steadily.
    SteadyCrack(SteadyCrack),
    /// A crack under a load history.
    DelayedFracture(DelayedFracture),
    /// A contact that slides steadily.
    Sliding(Sliding),
    /// A surface that slides steadily and acts at a distance.
    Surface(SurfaceSliding),
    /// A rigid round body pressed on, or pulled off, in time.
    Indentation(Indentation),
}

/// A steady crack.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyCrack {
    /// Which way the tip moves.
    pub motion: Motion,
    /// Which faces deform.
    pub body: CrackBody,
    /// Out-of-plane state; in a reduced scene plane stress, as its moduli are plane moduli already.
    pub plane: PlaneState,
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// How the process zone is given.
    pub process_zone: ProcessZoneLaw,
    /// The theories to solve, in the order named.
    pub theories: Vec<Theory>,
    /// What is prescribed.
    pub control: CrackControl,
    /// Fields around the tip, if asked for.
    pub fields: Option<Fields>,
}

/// A process zone as given in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ProcessZoneLaw {
    /// A length (m).
    Length(f64),
    /// From a cohesive stress.
    Cohesive {
        /// σ_c (Pa).
        cohesive_stress: f64,
        /// α.
        factor: f64,
        /// How the length follows.
        law: CohesiveLaw,
    },
}

/// How a process-zone length follows from a cohesive stress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CohesiveLaw {
    /// At the current load.
    Growing,
    /// At G = Δγ.
    Constant,
    /// Schapery's closing zone.
    Schapery,
}

/// A theory of steady cracks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Theory {
    /// The thesis's.
    VirtualWork,
    /// Persson and Brener's.
    PerssonBrener,
    /// Dugdale, Schapery and Greenwood's.
    CohesiveZone,
}

impl Theory {
    /// The word in scenes and tables.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::VirtualWork => "virtual_work",
            Self::PerssonBrener => "persson_brener",
            Self::CohesiveZone => "cohesive_zone",
        }
    }

    /// The name in plots and sentences.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::VirtualWork => "virtual work",
            Self::PerssonBrener => "Persson–Brener",
            Self::CohesiveZone => "cohesive zone",
        }
    }
}

/// What is prescribed of a steady crack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CrackControl {
    /// v (m/s).
    Speed(f64),
    /// G (J/m²).
    EnergyReleaseRate(f64),
    /// K or K₁ (Pa √m).
    StressIntensity(f64),
    /// A strip.
    Strip(Strip),
}

/// A long strip clamped at both long edges, cracked along its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// h (m).
    pub half_height: f64,
    /// What is prescribed far ahead of the tip.
    pub load: StripLoad,
    /// Whether it contracts along its length.
    pub lateral: SidewaysStrain,
}

/// The load of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StripLoad {
    /// Relaxed strain far ahead of the tip.
    Strain(f64),
    /// Stress (Pa) far ahead of the tip.
    Stress(f64),
}

/// Distances at which fields are evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fields {
    /// The smallest (m).
    pub from: f64,
    /// The largest (m).
    pub to: f64,
    /// How many, in equal ratios.
    pub points: u32,
}

/// A steadily sliding contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Sliding {
    /// The body that slides.
    pub indenter: SlidingIndenter,
    /// Its elasticity; none for a rigid one.
    pub counter_body: Option<ElasticBody>,
    /// v (m/s), of either sign.
    pub speed: f64,
    /// What is prescribed.
    pub control: SlidingLoad,
    /// What is looked for.
    pub task: SlidingTask,
    /// The contacts to solve, in the order named.
    pub contacts: Vec<SlidingContact>,
    /// What holds the faces together at that speed, if anything does.
    pub adhesion: Option<SlidingAdhesion>,
    /// Whether the works of adhesion are given for each edge.
    pub works_per_edge: bool,
    /// How the works of adhesion follow the speed (m/s), if they do.
    pub work_by_speed: Option<WorkBySpeed>,
    /// Columns besides the ones that always are there.
    pub columns: Vec<SlidingColumns>,
    /// Places along the surface at which fields are evaluated, if asked for.
    pub field_points: Option<u32>,
    /// How the load or penetration was reached.
    pub reached_by: ReachedBy,
    /// Stiffness per nominal area (Pa/m) of a frame in which the stability of a contact is reported, of a single state.
    pub frame_stiffness: Option<f64>,
}

/// The body that slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlidingIndenter {
    /// A wave; in a reduced scene 2π and 1.
    Wave {
        /// λ (m).
        wavelength: f64,
        /// Λ (m).
        amplitude: f64,
    },
    /// A cylinder; in a reduced scene 1.
    Cylinder {
        /// R (m).
        radius: f64,
    },
}

/// An elastic body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticBody {
    /// Young's modulus (Pa).
    pub modulus: f64,
    /// Poisson ratio.
    pub poisson_ratio: f64,
}

/// What is prescribed of a sliding contact besides the speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlidingLoad {
    /// p̄ (Pa) of a wave.
    MeanPressure(f64),
    /// F (N/m) of a cylinder.
    LoadPerWidth(f64),
    /// Δ (m) of a wave.
    Penetration(f64),
    /// a (m).
    HalfWidth(f64),
    /// None: every load is met along a curve.
    Every,
}

/// What is looked for of a sliding contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlidingTask {
    /// The contact under the load.
    State,
    /// A curve of contacts.
    Branch(SlidingBranch),
    /// What the contact carries.
    Strength,
}

/// A curve of contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingBranch {
    /// What runs along it.
    pub parameter: BranchParameter,
    /// The smallest and the largest value, if given.
    pub range: Option<[f64; 2]>,
    /// How many contacts are rows.
    pub points: u32,
    /// k_f (Pa/m), if a frame is given.
    pub frame_stiffness: Option<f64>,
    /// Whether a scan looks for branches isolated from those that are followed.
    pub every: bool,
}

/// What runs along a curve of contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BranchParameter {
    /// p̄ (Pa) of a wave.
    MeanPressure,
    /// F (N/m) of a cylinder.
    LoadPerWidth,
    /// Δ (m) of a wave.
    Penetration,
    /// a (m).
    HalfWidth,
    /// v (m/s).
    Speed,
    /// Δγ (J/m²); in a reduced scene Γ.
    WorkOfAdhesion,
    /// δ of the trailing edge (m).
    ProcessZone,
}

impl BranchParameter {
    /// Every parameter with its word.
    pub const WORDS: [(Self, &'static str); 7] = [
        (Self::MeanPressure, "mean_pressure"),
        (Self::LoadPerWidth, "load_per_width"),
        (Self::Penetration, "penetration"),
        (Self::HalfWidth, "half_width"),
        (Self::Speed, "speed"),
        (Self::WorkOfAdhesion, "work_of_adhesion"),
        (Self::ProcessZone, "process_zone"),
    ];

    /// The word in scenes and tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(parameter, _)| *parameter == self).map_or("", |(_, word)| word)
    }

    /// Whether the load varies along the curve, all else being held.
    #[must_use]
    pub const fn is_load(self) -> bool {
        matches!(self, Self::MeanPressure | Self::LoadPerWidth | Self::Penetration | Self::HalfWidth)
    }
}

/// A kind of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SlidingContact {
    /// With the energy balance at both edges.
    Adhesive,
    /// Without a singular stress at either edge.
    Adhesiveless,
}

impl SlidingContact {
    /// The word in scenes, tables and plots.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Adhesive => "adhesive",
            Self::Adhesiveless => "adhesiveless",
        }
    }
}

/// Columns of a sliding contact that are made on request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SlidingColumns {
    /// The elastic contact of the modulus |E(kv)|.
    ElasticReference,
    /// The friction of the edges and of the bulk.
    FrictionParts,
    /// How outputs follow the parameters.
    Sensitivities,
}

impl SlidingColumns {
    /// All of them with their words.
    pub const WORDS: [(Self, &'static str); 3] = [
        (Self::ElasticReference, "elastic_reference_contact"),
        (Self::FrictionParts, "friction_parts"),
        (Self::Sensitivities, "sensitivities"),
    ];
}

/// Adhesion of a sliding contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingAdhesion {
    /// Δγ (J/m²) of the trailing and of the leading edge; in a reduced scene Γ.
    pub works: [f64; 2],
    /// The process zones of both edges.
    pub process_zone: SlidingZone,
}

/// The process zones of a sliding contact as given in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlidingZone {
    /// A length (m) for each edge.
    Lengths {
        /// Of the trailing edge.
        trailing: f64,
        /// Of the leading edge.
        leading: f64,
    },
    /// α a₀ at both edges, a₀ = E0*Δγ/(πσ_c²).
    Cohesive {
        /// σ_c (Pa).
        cohesive_stress: f64,
        /// α.
        factor: f64,
        /// Whether the zones grow with their edges, α a₀ G/Δγ where the contact opens and α a₀ Δγ/G where it closes.
        grows: bool,
    },
}
