//! Which contacts of the curve can exist, and where they end.

use super::curve::EquilibriumCurve;
use super::held::{Crossing, SegmentEnd, StableSegment};
use super::point::{HeldQuantity, Point};
use super::width::ContactAt;
use crate::sliding::contact::{ContactEdges, WaveContact};

/// Halvings between a contact that exists and none.
const HALVINGS: usize = 44;
/// How far beyond the end of a curve no contact is any more, in ln tan(a/2): more than the finest spacing.
const BEYOND: f64 = 0.2;

/// Contacts nearer than this part of the half-width are one.
const SAME: f64 = 1e-3;

/// Why both edge conditions hold and there is no contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::sliding) enum WhyNot {
    /// The trailing edge, in the contact or with an edge moved, is pressed instead of pulled.
    TrailingPressed,
    /// The leading edge is.
    LeadingPressed,
    /// The faces meet in the gap: a second contact begins there.
    FacesMeet,
}

/// A place of the curve: ln tan(a/2), of a parabola ln(a/2), and e.
pub(in crate::sliding) type Place = (f64, f64);

impl EquilibriumCurve {
    /// Whether a contact can exist.
    pub(in crate::sliding) fn exists(&self, crossing: &Crossing) -> bool {
        self.possible((crossing.place, crossing.eccentricity)).is_some()
    }

    /// How many contacts there are near crossings, besides one that is known.
    pub(in crate::sliding) fn others<'a>(
        &self,
        (quantity, value): (HeldQuantity, f64),
        known: WaveContact,
        crossings: impl Iterator<Item = &'a Crossing>,
    ) -> usize {
        let control = quantity.control(value, self.every.indenter());
        let mut found = vec![known];
        for crossing in crossings {
            let Some(contact) = self.every.solved(control, [crossing.half_width, crossing.eccentricity]) else { continue };
            let same = |other: &WaveContact| {
                (other.half_width - contact.half_width).abs() + (other.eccentricity - contact.eccentricity).abs()
                    < SAME * contact.half_width
            };
            if !found.iter().any(same) {
                found.push(WaveContact { half_width: contact.half_width, eccentricity: contact.eccentricity });
            }
        }
        found.len() - 1
    }

    /// The contacts of a held value that can exist, narrow ones first.
    pub(in crate::sliding) fn contacts(&self, quantity: HeldQuantity, value: f64) -> Vec<ContactAt> {
        let control = quantity.control(value, self.every.indenter());
        let mut found: Vec<ContactAt> = Vec::new();
        for crossing in self.held(quantity, value) {
            let Some(contact) = self.every.solved(control, [crossing.half_width, crossing.eccentricity]) else { continue };
            let same = |other: &ContactAt| {
                (other.half_width - contact.half_width).abs() + (other.eccentricity - contact.eccentricity).abs()
                    < SAME * contact.half_width
            };
            if !found.iter().any(same) {
                found.push(contact);
            }
        }
        found
    }

    /// The contact at a place, if it can exist.
    pub(super) fn possible(&self, (place, eccentricity): Place) -> Option<Point> {
        self.beside(place, eccentricity).filter(|point| self.every.can_exist(point))
    }

    /// Between a contact that can exist and a place where none can: the last value, and what forbids the next; none if the first cannot exist either.
    pub(in crate::sliding) fn last_possible(&self, quantity: HeldQuantity, from: Place, to: Place) -> Option<(f64, WhyNot)> {
        let (last, why) = self.closed_in(from, to)?;
        Some((quantity.of(&last), why?))
    }

    /// Whether any contact of a segment can exist.
    pub(in crate::sliding) fn has_possible(&self, segment: &StableSegment) -> bool {
        segment.along.iter().rev().any(|&(_, place)| self.possible(place).is_some())
    }

    /// Along neighbours on the curve: the last value, seen from the first contact that can exist, before one that cannot; none if the first of all can.
    pub(in crate::sliding) fn end_of_possible(&self, quantity: HeldQuantity, along: impl Iterator<Item = Place>) -> Option<(f64, WhyNot)> {
        let mut impossible = None;
        for place in along {
            if self.possible(place).is_some() {
                return self.last_possible(quantity, place, impossible?);
            }
            impossible = Some(place);
        }
        None
    }

    fn closed_in(&self, from: Place, to: Place) -> Option<(Point, Option<WhyNot>)> {
        let mut good = self.possible(from)?;
        let mut bad = to;
        for _ in 0..HALVINGS {
            let middle = (0.5 * (good.place + bad.0), 0.5 * (good.eccentricity + bad.1));
            match self.possible(middle) {
                Some(point) => good = point,
                None => bad = middle,
            }
        }
        Some((good, self.every.why_not(bad.0, good.eccentricity)))
    }

    /// The last value at the end of a curve, and what forbids the next; none if the curve goes on there.
    pub(in crate::sliding) fn beyond_the_end(&self, quantity: HeldQuantity, end: &SegmentEnd) -> Option<(f64, WhyNot)> {
        [BEYOND, -BEYOND].into_iter().find_map(|step| {
            let beyond = (end.place + step, end.eccentricity);
            if self.possible(beyond).is_some() { None } else { self.last_possible(quantity, (end.place, end.eccentricity), beyond) }
        })
    }

    /// The half-width nearest to one without a contact at which there is one, whether it is wider, and what forbids narrower (or wider) ones.
    pub(in crate::sliding) fn nearest_width(&self, half_width: f64) -> Option<(f64, bool, Option<WhyNot>)> {
        let place = ContactEdges::new(self.every.indenter(), WaveContact { half_width, eccentricity: 0.0 }).place();
        let mut near: Vec<&Point> = self.chains.iter().flatten().collect();
        near.sort_by(|first, second| (first.place - place).abs().total_cmp(&(second.place - place).abs()));
        let found = near.into_iter().find(|point| self.every.can_exist(point))?;
        let (last, why) = self.closed_in((found.place, found.eccentricity), (place, found.eccentricity))?;
        Some((last.half_width, last.half_width > half_width, why))
    }
}
