//! A crack under a load history, as a scene gives it.

use super::{History, ProcessZoneLaw};
use viscotack::crack::CrackBody;
use viscotack::elastic::PlaneState;
use viscotack::elastic::pure_shear_strip::SidewaysStrain;

/// A crack that opens under a load history, and never heals.
#[derive(Debug, Clone, PartialEq)]
pub struct DelayedFracture {
    /// Which faces deform.
    pub body: CrackBody,
    /// Out-of-plane state; in a reduced scene plane stress, as its moduli are plane moduli already.
    pub plane: PlaneState,
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// How the process zone is given; never Schapery's, which closes.
    pub process_zone: ProcessZoneLaw,
    /// What is done: the stress intensity (Pa √m), or the stress (Pa) of a strip.
    pub history: History,
    /// The strip that is loaded, if the stress is controlled.
    pub strip: Option<LoadedStrip>,
    /// Output times.
    pub output: OutputTimes,
}

/// The geometry of a strip whose stress a history controls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedStrip {
    /// h (m).
    pub half_height: f64,
    /// Whether it contracts along its length.
    pub lateral: SidewaysStrain,
}

/// When the tip is looked at; events are reported whenever they happen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputTimes {
    /// How many times; none for events and summary alone.
    pub points: u32,
    /// The first of times in equal ratios (s); none for equal differences from zero.
    pub first: Option<f64>,
}
