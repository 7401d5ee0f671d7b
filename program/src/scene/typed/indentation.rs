//! An indenter in time, as a scene gives it.

use super::ElasticBody;
use super::attraction::SceneAttraction;
use super::history::{History, HistoryQuantity};
use std::sync::Arc;
use viscotack::indentation::EdgeLaw;
use viscotack::indentation::scan::ScannedShape;

/// A rigid round body pressed on, or pulled off, in time.
///
/// Reduced: lengths in R, times in the reference time, moduli in E0*, forces in πE0*R², pressures in πE0*, Δγ as γ̃ = Δγ/(πE0*R), stiffness of a
/// frame in πE0*R.
#[derive(Debug, Clone, PartialEq)]
pub struct Indentation {
    /// Its shape; of two spheres the gap between both, R* = R1 R2/(R1 + R2).
    pub shape: IndentationShape,
    /// The body that presses on the viscoelastic one, if it is elastic, or if both are round.
    pub counter_body: Option<CounterBody>,
    /// The radius at which the shape ends with a sharp corner (m; R in a reduced scene); a flat punch has its own.
    pub rim_radius: Option<f64>,
    /// How the history begins.
    pub start: IndentationStart,
    /// The quantity that is given at time zero, and its value.
    pub at_start: (HistoryQuantity, f64),
    /// What holds the faces together, if anything does.
    pub adhesion: Option<IndentationAdhesion>,
    /// The law by which the surfaces attract at a distance, in place of a process zone at an edge.
    pub attraction: Option<SceneAttraction>,
    /// How the work of adhesion and the process zone follow the edge.
    pub edge_law: EdgeLaw,
    /// k_f (N/m), if a frame is given.
    pub frame_stiffness: Option<f64>,
    /// What is done.
    pub history: History,
    /// How many times faster than it says.
    pub speed_factor: f64,
    /// Instants of a ramp or hold that are rows.
    pub instants: u32,
    /// Whether energies are added up.
    pub energies: bool,
    /// Fields, if asked for.
    pub fields: Option<IndentationFields>,
}

/// The second body of an indentation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CounterBody {
    /// Its elasticity; none for a rigid one.
    pub elastic: Option<ElasticBody>,
    /// The radius (m) of the second sphere; none if that body is flat.
    pub radius: Option<f64>,
}

/// The shape of an indenter.
#[derive(Debug, Clone, PartialEq)]
pub enum IndentationShape {
    /// r²/2R.
    Sphere {
        /// R (m); 1 in a reduced scene.
        radius: f64,
    },
    /// slope·r.
    Cone {
        /// dz/dr.
        slope: f64,
    },
    /// A flat face with a sharp rim.
    FlatPunch {
        /// Of the rim (m); 1 in a reduced scene.
        radius: f64,
    },
    /// r^m/(m R^(m−1)).
    PowerLaw {
        /// R (m); 1 in a reduced scene.
        radius: f64,
        /// m.
        exponent: f64,
    },
    /// Through points, such as a profilometer's.
    Table {
        /// (r, z) (m), both from 0 and rising.
        points: Arc<[(f64, f64)]>,
        /// What they were made of.
        measured: Arc<MeasuredShape>,
    },
}

/// What the points of a shape were made of.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredShape {
    /// The file as named in the scene.
    pub file: String,
    /// The scan, if it was one.
    pub scan: Option<ScannedShape>,
    /// What was chosen when it was read, and what was left out.
    pub notes: Vec<String>,
}

/// How a history begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IndentationStart {
    /// On an unloaded, rested surface.
    Untouched,
    /// From a relaxed contact.
    Relaxed,
}

/// Adhesion of an indenter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IndentationAdhesion {
    /// Δγ (J/m²), of a receding edge at rest; in a reduced scene γ̃.
    pub work_of_adhesion: f64,
    /// The process zone.
    pub process_zone: IndentationZone,
    /// Of the interface potential (m), if given.
    pub interaction_range: Option<f64>,
}

/// The process zone of an indenter as given in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IndentationZone {
    /// δ (m).
    Length(f64),
    /// α a₀, a₀ = E0*Δγ/(πσ_c²).
    Cohesive {
        /// σ_c (Pa).
        cohesive_stress: f64,
        /// α.
        factor: f64,
    },
}

/// Fields at chosen times.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationFields {
    /// The times (s), increasing.
    pub times: Vec<f64>,
    /// The largest distance from the axis (m), if given.
    pub to: Option<f64>,
    /// How many places.
    pub points: u32,
}
