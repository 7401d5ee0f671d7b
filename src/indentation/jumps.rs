//! What an edge does at once: it settles after a step of what is imposed, jumps to another equilibrium, loses contact, or touches again.

use super::edge::Imposed;
use super::folds::Fold;
use super::integrator::Integrator;
use super::line::Contact;
use super::solution::EventKind;
use crate::refusal::Refusal;

/// Step of a search for another equilibrium, over the process zone: C varies over a process zone.
const SEARCH: f64 = 0.2;
/// Iterations of a bracketed root.
const MOST_ITERATIONS: u32 = 200;

impl Integrator<'_> {
    /// At a fixed instant, the nearest stable edge the way the residual points.
    pub(super) fn settle(&mut self, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        let a = self.contact.radius();
        let (stayed, here) = if a > 0.0 {
            let (contact, value) = self.edge.jumped(&self.contact, a, imposed)?;
            (Some(contact), value)
        } else {
            (None, -1.0)
        };
        let pinned = a >= self.contact.profile().rim() && here <= 0.0;
        if let Some(contact) = &stayed
            && (here.abs() <= self.edge_tolerance() || pinned)
        {
            self.glide(a, contact.penetration(), 0.0);
            self.went(0.0, 0.0, self.time, if pinned { 0.0 } else { here });
            return Ok(());
        }
        let inwards = here > 0.0;
        if inwards && self.problem.edge_law.levels(f64::INFINITY)[0].is_infinite() {
            // No edge is infinitely fast: it goes from here at a speed of its own.
            self.problem.edge_law.goes(inwards)?;
            if let Some(depth) = stayed.as_ref().map(Contact::penetration) {
                self.glide(a, depth, 0.0);
                self.went(0.0, 0.0, self.time, 0.0);
                return Ok(());
            }
        }
        match self.other_stable_edge(a, inwards, imposed)? {
            Some(place) => self.jump(place, imposed),
            None if inwards => self.detach(EventKind::Detachment, imposed),
            None => Err(no_edge(a)),
        }
    }

    /// No stable neighbour: another equilibrium, or none. `fold`: where ahead of the present edge it was lost.
    pub(super) fn lost(&mut self, inwards: bool, fold: Option<Fold>, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        // Near a fold both sides look unstable: the edge goes on as it went.
        let was_inwards = self.path_history.nodes().get(..2).map(|nodes| nodes[0].radius < nodes[1].radius);
        let inwards = match (fold, was_inwards) {
            (Some(_), Some(was)) => was,
            (None, Some(was)) if was != inwards && self.is_unstable(imposed, 0.0)? == Some(true) => was,
            _ => inwards,
        };
        let found = self.other_stable_edge(self.contact.radius(), inwards, imposed)?;
        let kind = match found {
            Some(_) if inwards => EventKind::PartialDetachment,
            Some(_) => EventKind::JumpOut,
            None if inwards => EventKind::Detachment,
            None => return Err(no_edge(self.contact.radius())),
        };
        match found {
            Some(place) => {
                self.record.happened_at_fold(kind, self.path_history.nodes(), fold);
                self.record.sudden();
                self.jump(place, imposed)?;
                self.restart();
                Ok(())
            }
            None => {
                self.record.happened_at_fold(kind, self.path_history.nodes(), fold);
                self.opened(imposed)
            }
        }
    }

    /// An adhesive indenter touches a surface that it left before: the edge jumps out to the first stable place.
    pub(super) fn touch_again(&mut self, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        self.record.happened(EventKind::JumpIn);
        let profile = self.contact.profile();
        let found = if profile.is_flat() { Some(profile.rim()) } else { self.other_stable_edge(self.smallest(), false, imposed)? };
        match found {
            Some(place) => {
                self.record.sudden();
                self.jump(place, imposed)?;
                self.restart();
                Ok(())
            }
            None => Err(no_edge(0.0)),
        }
    }

    fn jump(&mut self, place: f64, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        let (contact, residual) = self.edge.jumped(&self.contact, place, imposed)?;
        self.glide(place, contact.penetration(), 0.0);
        self.went(0.0, 0.0, self.time, residual);
        Ok(())
    }

    /// The contact opens.
    pub(super) fn detach(&mut self, kind: EventKind, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        self.record.happened(kind);
        self.opened(imposed)
    }

    fn opened(&mut self, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        let depth = match imposed {
            Imposed::Penetration(history) => history(0.0),
            // Without a force a frame's end is where the indenter is; a force lets it fly.
            Imposed::Load { value, stiffness } if *stiffness > 0.0 => value(0.0) / stiffness,
            // from where the event found it: a fold a little ahead of the last step.
            Imposed::Load { .. } => self.record.trace.events.last().map_or(self.contact.penetration(), |event| event.penetration),
        };
        self.record.sudden();
        self.glide(0.0, depth, 0.0);
        self.went(0.0, 0.0, self.time, 0.0);
        self.restart();
        Ok(())
    }

    /// A stable edge somewhere else, at once: the next one inwards or outwards, or none.
    fn other_stable_edge(&mut self, start: f64, inwards: bool, imposed: &Imposed<'_>) -> Result<Option<f64>, Refusal> {
        if !inwards {
            self.problem.edge_law.goes(inwards)?;
        }
        let stride = SEARCH * self.length;
        let rim = self.contact.profile().rim();
        let (least, most) = (self.smallest(), (1e3 * (start + self.length)).min(rim));
        let mut last = (start, if inwards { 1.0 } else { -1.0 });
        let mut place = start;
        loop {
            place = if inwards { place - stride } else { (place + stride).min(most) };
            if inwards && place <= least {
                return Ok(None);
            }
            let (_, value) = self.edge.jumped(&self.contact, place, imposed)?;
            if (inwards && value < 0.0) || (!inwards && value > 0.0) {
                return self.root_between(last.0, place, inwards, imposed).map(Some);
            }
            if !inwards && place >= most {
                // Stopped by the rim, or nowhere.
                return Ok((most >= rim).then_some(rim));
            }
            last = (place, value);
        }
    }

    /// The zero of g between two places, of which the second is the one beyond it.
    fn root_between(&mut self, from: f64, beyond: f64, inwards: bool, imposed: &Imposed<'_>) -> Result<f64, Refusal> {
        let (mut near, mut far) = (from, beyond);
        let mut values: (Option<f64>, Option<f64>) = (None, None);
        for count in 0..MOST_ITERATIONS {
            let chord = match values {
                (Some(one), Some(other)) if count % 3 != 2 => near - one * (far - near) / (other - one),
                _ => 0.5 * (near + far),
            };
            let place = if chord > near.min(far) && chord < near.max(far) { chord } else { 0.5 * (near + far) };
            let (_, value) = self.edge.jumped(&self.contact, place, imposed)?;
            if value.abs() <= self.edge_tolerance() || (far - near).abs() <= 4.0 * f64::EPSILON * near.abs().max(far.abs()) {
                return Ok(place);
            }
            if (value < 0.0) == inwards {
                (far, values.1) = (place, Some(value));
            } else {
                (near, values.0) = (place, Some(value));
            }
        }
        Err(Refusal::NotConverged { what: "a jump of the edge", detail: format!("between {near:e} and {far:e}") })
    }
}

fn no_edge(radius: f64) -> Refusal {
    Refusal::NoSuchState {
        reason: "the edge runs outwards and finds no equilibrium".into(),
        limit_name: "the contact radius from which it runs",
        limit: radius,
    }
}
