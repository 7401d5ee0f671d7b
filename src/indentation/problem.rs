//! What is asked of a contact in time.

use super::edge_law::EdgeLaw;
use super::history::{Controlled, History};
use super::profile::Profile;
use crate::refusal::{Refusal, require_positive};

/// Adhesion at the edge; how it follows the edge says [`EdgeLaw`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adhesion {
    /// Δγ (J/m²); of a receding edge at rest, where they differ.
    pub work_of_adhesion: f64,
    /// δ (m); at G = Δγ, where it grows.
    pub process_zone: f64,
}

/// Where the history starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// On an untouched surface: with adhesion it jumps into contact at once, glassily; without it touches at a point.
    Untouched,
    /// From a contact held at the start value until it has relaxed.
    Relaxed,
}

/// A history of contact: what is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationProblem {
    /// The indenter.
    pub profile: Profile,
    /// Adhesion; none for the contact without (Lee–Radok advancing, Ting receding).
    pub adhesion: Option<Adhesion>,
    /// How work of adhesion and process zone follow the edge.
    pub edge_law: EdgeLaw,
    /// What is imposed in time.
    pub history: History,
    /// k_f (N/m) of the frame that holds the indenter; needed where the history controls [`Controlled::Frame`].
    pub frame_stiffness: Option<f64>,
    /// Where it starts.
    pub start: Start,
    /// Instants to keep in each segment, equally spaced, its end included.
    pub instants_per_segment: u32,
    /// Whether energies are added up.
    pub energies: bool,
    /// Wanted accuracy: errors of Δ, F, a and K at kept instants, over the largest value of each in the history.
    pub accuracy: f64,
}

impl IndentationProblem {
    /// A sphere-like problem under a history, untouched at the start, to 1e-4.
    #[must_use]
    pub const fn new(profile: Profile, adhesion: Option<Adhesion>, history: History) -> Self {
        Self {
            profile,
            adhesion,
            edge_law: EdgeLaw::CONSTANT,
            history,
            frame_stiffness: None,
            start: Start::Untouched,
            instants_per_segment: 1,
            energies: false,
            accuracy: 1e-4,
        }
    }

    /// The same from a relaxed start.
    #[must_use]
    pub fn relaxed(mut self) -> Self {
        self.start = Start::Relaxed;
        self
    }

    /// Whether it is solved without steps in time: without adhesion. Only then may the material flow for ever.
    #[must_use]
    pub const fn is_without_steps(&self) -> bool {
        self.adhesion.is_none()
    }

    /// Checks every number.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`]; [`Refusal::Undefined`] for a frame without its stiffness.
    pub fn checked(&self) -> Result<(), Refusal> {
        self.profile.clone().checked()?;
        self.history.checked()?;
        require_positive("accuracy", self.accuracy)?;
        if let Some(adhesion) = self.adhesion {
            require_positive("work_of_adhesion", adhesion.work_of_adhesion)?;
            require_positive("process_zone", adhesion.process_zone)?;
        }
        self.edge_law.checked()?;
        let withdrawn = self.start == Start::Relaxed && self.history.only_withdraws();
        if self.edge_law.growing_zone && !self.profile.is_flat() && !withdrawn {
            return Err(Refusal::Undefined {
                quantity: "a process zone that grows with the pull",
                reason: "K at an advancing edge does not give it: an indenter that is not flat takes it from a relaxed start, and is only withdrawn".into(),
            });
        }
        let radius_rests = self.edge_law.may_rest() || self.edge_law.growing_zone;
        if radius_rests && self.adhesion.is_some() && self.history.controls(Controlled::ContactRadius) {
            return Err(Refusal::Undefined {
                quantity: "the penetration of a given contact radius",
                reason: "an edge at rest carries any of a range of works of adhesion, or the process zone follows the load".into(),
            });
        }
        let rim = self.profile.rim();
        let starts = std::iter::once((self.history.controlled, self.history.start));
        let ends = self.history.segments.iter().map(|segment| (segment.controlled, segment.end));
        if let Some((_, radius)) = starts.chain(ends).find(|(controlled, value)| *controlled == Controlled::ContactRadius && *value > rim) {
            return Err(Refusal::out_of_range("contact_radius", radius, "at most the radius of the rim"));
        }
        match self.frame_stiffness {
            Some(stiffness) => {
                require_positive("frame_stiffness", stiffness)?;
            }
            None if self.history.controls(Controlled::Frame) => {
                return Err(Refusal::Undefined { quantity: "the place of the frame", reason: "it has no stiffness".into() });
            }
            None => {}
        }
        Ok(())
    }
}
