//! The contact of a wave or cylinder without adhesion: one for each load, so that a bracket of half-widths finds it.
//!
//! The compliance of every harmonic has a positive real part, so pressures and gaps that are nowhere negative are unique, and stable: load and penetration rise with the
//! half-width. No curve is needed to tell which contact is meant.

use super::held::Crossing;
use super::point::{HeldQuantity, Point};
use super::width::ContactsOfWidth;
use crate::sliding::contact::{ContactEdges, WaveContact};

/// Steps of the search.
const STEPS: usize = 60;
/// The contact is found where what is held is met to this part of itself, or the bracket is this narrow in ln tan(a/2): Newton's method goes on from there.
const CLOSE: f64 = 1e-6;

impl ContactsOfWidth {
    /// The contact of a held value between two half-widths; none if it is not there, or a half-width has another number of contacts than one.
    pub(in crate::sliding) fn only_contact(&self, quantity: HeldQuantity, value: f64, half_widths: [f64; 2]) -> Option<Crossing> {
        let indenter = self.indenter();
        let one_at = |place: f64| match self.points(place)[..] {
            [point] => Some(point),
            _ => None,
        };
        // The load rises like a power of the half-width while the contact is narrow; a penetration may start below zero.
        let level = |held: f64| if quantity == HeldQuantity::MeanPressure { held.ln() } else { held };
        let wanted = level(value);
        let off = |point: &Point| level(quantity.of(point)) - wanted;
        let [low, high] = half_widths.map(|half_width| ContactEdges::new(indenter, WaveContact { half_width, eccentricity: 0.0 }).place());
        let (mut low, mut high) = (one_at(low)?, one_at(high)?);
        let (mut below, mut above) = (off(&low), off(&high));
        if !(below < 0.0 && above > 0.0) {
            return None;
        }
        let between = [low.half_width, high.half_width];
        let mut kept = 0;
        let mut nearest = low;
        for step in 0..STEPS {
            let part = if step % 4 == 3 { 0.5 } else { (below / (below - above)).clamp(0.01, 0.99) };
            nearest = one_at(low.place + part * (high.place - low.place))?;
            let here = off(&nearest);
            if here.is_nan() {
                return None;
            }
            if here.abs() < CLOSE || high.place - low.place < CLOSE {
                break;
            }
            // False position; the side that stays twice counts half.
            if here < 0.0 {
                (low, below) = (nearest, here);
                above *= if kept == -1 { 0.5 } else { 1.0 };
                kept = -1;
            } else {
                (high, above) = (nearest, here);
                below *= if kept == 1 { 0.5 } else { 1.0 };
                kept = 1;
            }
        }
        Some(Crossing { place: nearest.place, half_width: nearest.half_width, eccentricity: nearest.eccentricity, stable: true, between })
    }
}
