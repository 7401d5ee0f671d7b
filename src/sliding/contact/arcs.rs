//! The two arcs of a contact, inside and outside, as the elastic fields see them: root and half angle of a point, from one sine and cosine.
//!
//! ```text
//! inside   y = ∓(a − d),   |X| = 2√(sin(d/2) sin(a − d/2)),       d from the nearer (trailing: −, leading: +) edge
//! outside  y = ∓(a + d),   |X| = 2√(sin(d/2) sin(a + d/2))        (behind the trailing edge y counts from the next period: y + 2π)
//! ```
//! d is at most half the arc, so that no difference loses digits.

use super::edges::ContactEdges;
use super::fields::ArcPoint;
use super::indenter::Indenter;

/// Indenter and half-width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arcs {
    pub(super) indenter: Indenter,
    /// sin(a/2), cos(a/2).
    pub(super) half: (f64, f64),
    /// sin a, cos a.
    whole: (f64, f64),
}

/// |X|, and sin(y/2) and cos(y/2).
pub(super) struct Place {
    pub(super) root: f64,
    pub(super) angle: (f64, f64),
}

impl Arcs {
    /// Of the narrower one of contact and gap, whose sine keeps its digits.
    pub(super) fn new(edges: ContactEdges, indenter: Indenter) -> Self {
        let ContactEdges { half_width, half_gap, .. } = edges;
        if half_gap < half_width {
            let ((half_sine, half_cosine), (sine, cosine)) =
                (indenter.half_sine_cosine(half_gap), indenter.half_sine_cosine(2.0 * half_gap));
            Self { indenter, half: (half_cosine, half_sine), whole: (sine, -cosine) }
        } else {
            Self { indenter, half: indenter.half_sine_cosine(half_width), whole: indenter.half_sine_cosine(2.0 * half_width) }
        }
    }

    /// A point of the contact.
    pub(super) fn inside(&self, point: ArcPoint) -> Place {
        let behind = point.from_trailing < point.from_leading;
        self.inside_at(self.indenter.half_sine_cosine(point.from_trailing.min(point.from_leading)), behind)
    }

    /// A point of the contact by half sine and cosine of its distance to the trailing (or leading) edge.
    pub(super) fn inside_at(&self, (sine, cosine): (f64, f64), from_trailing: bool) -> Place {
        let root = 2.0 * (sine * (self.whole.0 * cosine - self.whole.1 * sine)).sqrt();
        let half = self.half.0 * cosine - self.half.1 * sine;
        Place { root, angle: (if from_trailing { -half } else { half }, self.indenter.cosine_of_sum(self.half, (-sine, cosine))) }
    }

    /// A point of the gap.
    pub(super) fn outside(&self, point: ArcPoint) -> Place {
        let behind = point.from_trailing < point.from_leading;
        self.outside_at(self.indenter.half_sine_cosine(point.from_trailing.min(point.from_leading)), behind)
    }

    /// A point of the gap by half sine and cosine of its distance to the trailing (or leading) edge.
    pub(super) fn outside_at(&self, (sine, cosine): (f64, f64), from_trailing: bool) -> Place {
        let root = 2.0 * (sine * (self.whole.0 * cosine + self.whole.1 * sine)).sqrt();
        let across = self.indenter.cosine_of_sum(self.half, (sine, cosine));
        Place { root, angle: (self.half.0 * cosine + self.half.1 * sine, if from_trailing { -across } else { across }) }
    }
}
