//! Curves cut where the load turns: on each piece the load grows or falls with the half-width, so that a held load has at most one contact there.

use super::curve::{Curves, End, Strand};
use super::stability::{Held, Variations};
use super::width::{Bodies, Equilibrium};
use std::f64::consts::PI;
use viscotack::sliding::contact::Indenter;

/// Where a piece ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Border {
    /// The held quantity turns there.
    Turn,
    /// The strand ends there.
    Strand(End),
    /// Stability ends there.
    Stability,
}

/// Contacts of growing half-width along which the held quantity grows or falls.
#[derive(Debug, Clone)]
pub struct Piece {
    /// The contacts, the refined turns at the ends included.
    pub contacts: Vec<Equilibrium>,
    /// At the smallest half-width.
    pub begins: Border,
    /// At the largest.
    pub ends: Border,
    /// Which strand it belongs to.
    pub strand: usize,
}

/// A quantity of a contact.
pub type Quantity = fn(&Equilibrium) -> f64;

/// p̄.
pub fn load(contact: &Equilibrium) -> f64 {
    contact.mean_pressure
}

/// Δ.
pub fn depth(contact: &Equilibrium) -> f64 {
    contact.penetration
}

/// The contact at a place that is nearest to a guess.
pub fn nearest(bodies: &Bodies, place: f64, eccentricity: f64, pressure: f64) -> Option<Equilibrium> {
    let far = |other: &Equilibrium| {
        let mut ahead = other.eccentricity - eccentricity;
        if bodies.indenter == Indenter::Wave {
            ahead -= 2.0 * PI * (ahead / (2.0 * PI)).round();
        }
        ahead.abs() / other.half_width.min(1.0)
            + (other.mean_pressure - pressure).abs() / (other.mean_pressure.abs() + pressure.abs() + 1e-2)
    };
    bodies.contacts(place).ok()?.into_iter().min_by(|one, other| far(one).total_cmp(&far(other)))
}

fn between(one: &Equilibrium, other: &Equilibrium, part: f64) -> (f64, f64, f64) {
    let mix = |from: f64, to: f64| from + part * (to - from);
    let mut ahead = other.eccentricity - one.eccentricity;
    if ahead.abs() > PI && one.half_width < PI {
        ahead -= 2.0 * PI * (ahead / (2.0 * PI)).round();
    }
    (mix(one.place, other.place), one.eccentricity + part * ahead, mix(one.mean_pressure, other.mean_pressure))
}

/// The extreme of a quantity near the middle of three neighbours, by the golden section.
fn turn(bodies: &Bodies, quantity: Quantity, [from, middle, to]: [&Equilibrium; 3]) -> Equilibrium {
    let sign = (quantity(middle) - quantity(from)).signum();
    let at = |place: f64| {
        let (one, other) = if place < middle.place { (from, middle) } else { (middle, to) };
        let part = (place - one.place) / (other.place - one.place);
        let (place, eccentricity, pressure) = between(one, other, part);
        nearest(bodies, place, eccentricity, pressure)
    };
    const GOLDEN: f64 = 0.381_966_011_250_105;
    let (mut low, mut best, mut high) = (from.place, *middle, to.place);
    for _ in 0..26 {
        let upper = high - best.place > best.place - low;
        let place = if upper { best.place + GOLDEN * (high - best.place) } else { best.place - GOLDEN * (best.place - low) };
        let Some(found) = at(place) else { break };
        if sign * quantity(&found) > sign * quantity(&best) {
            if upper {
                low = best.place
            } else {
                high = best.place
            }
            best = found;
        } else if upper {
            high = place;
        } else {
            low = place;
        }
    }
    best
}

/// The pieces of all strands.
#[must_use]
pub fn pieces(bodies: &Bodies, curves: &Curves, quantity: Quantity) -> Vec<Piece> {
    curves.strands.iter().enumerate().flat_map(|(index, strand)| cut(bodies, strand, index, quantity)).collect()
}

/// The strands as they are.
#[must_use]
pub fn whole(curves: &Curves) -> Vec<Piece> {
    let piece = |(index, strand): (usize, &Strand)| Piece {
        contacts: strand.contacts.clone(),
        begins: Border::Strand(strand.begins),
        ends: Border::Strand(strand.ends),
        strand: index,
    };
    curves.strands.iter().enumerate().map(piece).collect()
}

fn cut(bodies: &Bodies, strand: &Strand, index: usize, quantity: Quantity) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut begins = Border::Strand(strand.begins);
    let mut contacts: Vec<Equilibrium> = strand.contacts.first().copied().into_iter().collect();
    for triple in strand.contacts.windows(3) {
        let [from, middle, to] = triple else { continue };
        let (before, after) = (quantity(middle) - quantity(from), quantity(to) - quantity(middle));
        if before * after < 0.0 {
            let found = turn(bodies, quantity, [from, middle, to]);
            if middle.place < found.place {
                contacts.push(*middle);
            }
            contacts.push(found);
            pieces.push(Piece { contacts: std::mem::take(&mut contacts), begins, ends: Border::Turn, strand: index });
            begins = Border::Turn;
            contacts.push(found);
            if middle.place > found.place {
                contacts.push(*middle);
            }
        } else {
            contacts.push(*middle);
        }
    }
    if strand.contacts.len() > 1 {
        contacts.extend(strand.contacts.last());
    }
    pieces.push(Piece { contacts, begins, ends: Border::Strand(strand.ends), strand: index });
    pieces
}

impl Piece {
    /// The smallest and the largest value.
    #[must_use]
    pub fn span(&self, quantity: Quantity) -> [f64; 2] {
        let value = |contact: Option<&Equilibrium>| contact.map_or(f64::NAN, quantity);
        let (first, last) = (value(self.contacts.first()), value(self.contacts.last()));
        [first.min(last), first.max(last)]
    }

    /// The contact with the largest value, or the smallest.
    #[must_use]
    pub fn extreme(&self, quantity: Quantity, largest: bool) -> Option<&Equilibrium> {
        let (first, last) = (self.contacts.first()?, self.contacts.last()?);
        Some(if (quantity(first) > quantity(last)) == largest { first } else { last })
    }

    /// What happens there.
    #[must_use]
    pub fn border(&self, quantity: Quantity, largest: bool) -> Border {
        let value = |contact: Option<&Equilibrium>| contact.map_or(f64::NAN, quantity);
        if (value(self.contacts.first()) > value(self.contacts.last())) == largest { self.begins } else { self.ends }
    }

    /// The contact with a value.
    #[must_use]
    pub fn at(&self, bodies: &Bodies, quantity: Quantity, value: f64) -> Option<Equilibrium> {
        let pair = self.contacts.windows(2).find(|pair| {
            let [one, other] = pair else { return false };
            (quantity(one) - value) * (quantity(other) - value) <= 0.0
        })?;
        let [mut one, mut other] = [*pair.first()?, *pair.get(1)?];
        for step in 0..60 {
            let (begin, end) = (quantity(&one) - value, quantity(&other) - value);
            if begin == 0.0 {
                return Some(one);
            }
            let secant = begin / (begin - end);
            let part = if step % 3 == 2 { 0.5 } else { secant.clamp(1e-3, 0.999) };
            let (place, eccentricity, pressure) = between(&one, &other, part);
            let Some(found) = nearest(bodies, place, eccentricity, pressure) else { break };
            if (quantity(&found) - value) * begin > 0.0 {
                one = found;
            } else {
                other = found;
            }
            if (other.place - one.place).abs() < 1e-13 || (quantity(&found) - value).abs() < 1e-13 * (1.0 + value.abs()) {
                return Some(found);
            }
        }
        Some(if (quantity(&one) - value).abs() < (quantity(&other) - value).abs() { one } else { other })
    }

    /// Margins of stability at some contacts inside.
    #[must_use]
    pub fn margins(&self, bodies: &Bodies, held: Held, count: usize) -> Vec<f64> {
        let inner = self.contacts.len().saturating_sub(1);
        (1..=count)
            .filter_map(|index| self.contacts.get((index * inner) / (count + 1)))
            .map(|contact| Variations::new(bodies, contact, held).map_or(f64::NAN, |found| found.margin()))
            .collect()
    }
}
