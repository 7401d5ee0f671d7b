//! What is asked of a contact in time.

use super::history::History;
use super::profile::Profile;

/// Adhesion at the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adhesion {
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// δ (m).
    pub process_zone: f64,
}

/// What is imposed.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// Δ(t) (m).
    Penetration(History),
    /// F(t) (N), compression positive.
    Force(History),
    /// a(t) (m): the penetration follows from the edge condition.
    ContactRadius(History),
}

/// Where the history starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// On an untouched surface: with adhesion it jumps into contact at once, glassily; without it touches at a point.
    Untouched,
    /// From a contact held at the start value until it has relaxed.
    Relaxed,
}

/// How finely a march goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    /// Steps of the edge per process zone (without adhesion: per quarter tenth of the contact's size, that is of a/25).
    pub steps_per_zone: f64,
    /// Largest time step over the time since the last corner of the history, or the last event.
    pub growth: f64,
}

impl Default for Resolution {
    fn default() -> Self {
        Self { steps_per_zone: 25.0, growth: 0.2 }
    }
}

impl Resolution {
    /// Twice as fine.
    #[must_use]
    pub fn halved(self) -> Self {
        Self { steps_per_zone: 2.0 * self.steps_per_zone, growth: 0.5 * self.growth }
    }
}

/// A history of contact: what is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationProblem {
    /// The indenter.
    pub profile: Profile,
    /// Adhesion; none for the contact without (Lee–Radok advancing, Ting receding).
    pub adhesion: Option<Adhesion>,
    /// What is imposed in time.
    pub control: Control,
    /// Where it starts.
    pub start: Start,
    /// Instants to keep in each segment, equally spaced, its end included.
    pub instants_per_segment: u32,
    /// Of the coarser of the two marches.
    pub resolution: Resolution,
}

impl Control {
    /// The imposed history, whatever it is of.
    #[must_use]
    pub const fn history(&self) -> &History {
        match self {
            Self::Penetration(history) | Self::Force(history) | Self::ContactRadius(history) => history,
        }
    }
}
