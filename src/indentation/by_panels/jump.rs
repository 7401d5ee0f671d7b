//! A jump: the edge moves in no time to the next place where it is in equilibrium.
//!
//! From a fold, or from an outset that is unstable, C − Δγ drives the edge on as long as it keeps its sign. The way is looked through from
//! the start, in strides within one segment of the path history; the first that ends beyond equilibrium is halved down to the landing. Without one
//! the contact is lost.

use super::integration::Integration;
use super::problem::{End, Row};
use crate::indentation::EventKind;

/// A jump outwards beyond so many radii of the contact has no end.
const FURTHEST: f64 = 1e3;
/// Narrowest contact, in process zones.
pub(super) const FLOOR: f64 = 1.05;

impl Integration<'_> {
    /// The edge goes in no time to the next place where it is in equilibrium: the first crossing of the closure. A first stride that finds
    /// it where it started shows that it was stable there after all.
    pub(super) fn jumps(&mut self, advances: bool, first: f64) -> Option<End> {
        // What the last panel left is within its tolerance, and would be taken for a landing.
        let left = self.sudden(0.0);
        let kind = if advances { EventKind::JumpOut } else { EventKind::PartialDetachment };
        // On the way of a sudden step it is a part of the step.
        self.moves_at_once(advances, first, left, Some(kind).filter(|_| self.at_once.is_none()))
    }

    /// The same until C − Δγ is what is left; `kind`: what has happened if it is not the control that moves the edge.
    pub(super) fn moves_at_once(&mut self, advances: bool, first: f64, left: f64, kind: Option<EventKind>) -> Option<End> {
        let from = self.row(None, 0.0);
        self.lands(advances, first, left, (kind, from))
    }

    /// The same for a contact that was in the state of a row before.
    pub(super) fn lands(&mut self, advances: bool, first: f64, left: f64, (kind, from): (Option<EventKind>, Row)) -> Option<End> {
        let zone = self.problem.zone;
        let sign = if advances { 1.0 } else { -1.0 };
        self.start_residual = left;
        let start = self.line.edge;
        let excess = |integration: &mut Self, way: f64| sign * (integration.sudden(sign * way) - left);
        let mut stride = first;
        let mut gone = 0.0;
        self.previous = None;
        loop {
            // Within one segment of the path history.
            let border = self.line.list(!advances).last().map_or(f64::INFINITY, |last| if advances { last.high } else { -last.low });
            let least = if advances { f64::INFINITY } else { self.line.edge - FLOOR * zone };
            // A border within rounding of the edge is passed.
            let next = stride.min(border.max(1e-9 * zone)).min(least);
            if least <= 1e-9 * zone || self.line.edge > FURTHEST * start {
                return Some(End::Lost);
            }
            let landed = excess(self, next) >= 0.0;
            let mut way = next;
            if landed {
                let mut low = 0.0;
                for _ in 0..50 {
                    let middle = 0.5 * (low + way);
                    if excess(self, middle) >= 0.0 { way = middle } else { low = middle }
                }
                if gone == 0.0 && way < 1e-3 * first {
                    return None;
                }
            }
            if gone == 0.0 {
                self.mark(true);
            }
            self.goes_at_once(sign * way);
            self.balance();
            gone += way;
            if landed {
                let to = self.row(None, 0.0);
                if let Some(kind) = kind {
                    self.event(kind, &from);
                }
                self.piece += 1;
                self.step_at_rest((to, 0.0), &from, false);
                self.integrates_at_once(&to);
                self.outcome.jumps.push(to);
                self.mark(true);
                return None;
            }
            stride *= 1.2;
        }
    }
}
