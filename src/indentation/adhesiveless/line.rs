//! The line of a contact without adhesion: intervals of a few chains each, those in contact first.
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | S(s) | pressing: Q/E∞* in contact, −D outside; the same function Δ − f − Σe_j of the strains on both sides | m |
//! | u_i | strain of the spring of Maxwell branch i of a chain in contact | m |
//! | e_j | strain of Voigt element j of a free chain | m |
//!
//! The strains are continuous when the edge passes, and S falls along s: ∂e_j/∂s follows −f′ as a chain does that is held at −f′ in contact and
//! let go outside, whose displacement never passes what held it, so that ∂S/∂s = −f′·(1 − a number of 0…1). Hence the contact is one disc, its edge is the one
//! zero of S, and nothing but S ≥ 0 decides what is in contact.

use super::chain::Chain;
use super::grid::{GRID, NODES, Nodal, dot};
use super::moment::Moment;
use crate::indentation::profile::Profile;
use crate::refusal::Refusal;

/// An interval narrower than this, over the edge's place, is none.
pub(super) const NARROWEST: f64 = 4e-15;

/// An interval of the line.
#[derive(Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) heights: Nodal,
    /// u_i or e_j, term after term.
    pub(super) state: Vec<f64>,
    /// What joining has changed in it, and what that makes once the edge has passed it (m).
    pub(super) off: f64,
    pub(super) then: f64,
    /// Whether it may be joined with the next one: not tried since it changed.
    pub(super) fresh: bool,
}

impl Clone for Interval {
    fn clone(&self) -> Self {
        Self { state: self.state.clone(), ..*self }
    }

    fn clone_from(&mut self, other: &Self) {
        let mut state = std::mem::take(&mut self.state);
        state.clone_from(&other.state);
        *self = Self { state, ..*other };
    }
}

impl Interval {
    pub(super) fn place(&self, k: usize) -> f64 {
        place_of(self.low, self.high, k)
    }

    pub(super) fn width(&self) -> f64 {
        self.high - self.low
    }

    pub(super) fn term(&self, index: usize) -> &[f64] {
        self.state.get(index * NODES..(index + 1) * NODES).unwrap_or(&[])
    }

    /// A share of the heights and one of each term.
    pub(super) fn weighted(&self, of_heights: f64, of_terms: impl IntoIterator<Item = f64>) -> Nodal {
        let mut sum = self.heights.map(|height| of_heights * height);
        for (index, share) in of_terms.into_iter().enumerate() {
            for (sum, value) in sum.iter_mut().zip(self.term(index)) {
                *sum += share * value;
            }
        }
        sum
    }

    /// What has these values at its places, at any one.
    pub(super) fn value(&self, place: f64, values: &Nodal) -> f64 {
        dot(&GRID.at(place - self.low, self.high - place), values)
    }

    /// The state at a place, term after term.
    pub(super) fn at(&self, place: f64, into: &mut [f64]) {
        let weights = GRID.at(place - self.low, self.high - place);
        for (index, value) in into.iter_mut().enumerate() {
            *value = dot(&weights, self.term(index));
        }
    }
}

pub(super) fn place_of(low: f64, high: f64, k: usize) -> f64 {
    match k {
        0 => low,
        k if k == NODES - 1 => high,
        k if 2 * k < NODES => low + (high - low) * GRID.parts[k],
        k => high - (high - low) * GRID.parts[NODES - 1 - k],
    }
}

/// All chains at an instant.
#[derive(Debug, Clone)]
pub(super) struct Line<'a> {
    pub(super) chain: &'a Chain,
    pub(super) profile: &'a Profile,
    pub(super) contact: Vec<Interval>,
    pub(super) free: Vec<Interval>,
    pub(super) penetration: f64,
    /// Largest |Δ| so far, or of those to come (m).
    pub(super) depth: f64,
    /// What a series may leave, over the depth.
    pub(super) tolerance: f64,
    /// What is not known of any state (m), since nothing that follows makes a difference larger: everywhere, and the most that joining changed at a place.
    pub(super) everywhere: f64,
    pub(super) joined: f64,
    /// The most that a series or a panel left: another course may have cut the same ones.
    pub(super) cut: f64,
    pub(super) updates: u64,
    pub(super) most_intervals: u64,
}

impl<'a> Line<'a> {
    pub(super) fn untouched(chain: &'a Chain, profile: &'a Profile, tolerance: f64) -> Self {
        Self {
            chain,
            profile,
            contact: Vec::new(),
            free: Vec::new(),
            penetration: 0.0,
            depth: 0.0,
            tolerance,
            everywhere: 0.0,
            joined: 0.0,
            cut: 0.0,
            updates: 0,
            most_intervals: 0,
        }
    }

    /// As another line is, in the place of this one.
    pub(super) fn becomes(&mut self, other: &Self) {
        let (mut contact, mut free) = (std::mem::take(&mut self.contact), std::mem::take(&mut self.free));
        contact.clone_from(&other.contact);
        free.clone_from(&other.free);
        *self = Self { contact, free, ..*other };
    }

    /// What is not known of any strain (m) beyond what another course tells.
    pub(super) fn unknown(&self) -> f64 {
        self.everywhere + self.joined + self.cut
    }

    /// a.
    pub(super) fn radius(&self) -> f64 {
        self.contact.last().map_or(0.0, |interval| interval.high)
    }

    pub(super) fn went_to(&mut self, penetration: f64) {
        self.penetration = penetration;
        self.depth = self.depth.max(penetration.abs());
    }

    /// The place at which the undeformed surface lies at a depth, no less than another one; none beyond the end of a table.
    pub(super) fn virgin_edge(&self, depth: f64, from: f64) -> Result<f64, Refusal> {
        let rim = self.profile.rim();
        if rim.is_finite() && depth > self.profile.line(rim) {
            return Ok(rim);
        }
        if depth <= self.profile.line(from) {
            return Ok(from);
        }
        let mut high = match self.profile {
            Profile::Table(shape) => shape.reach(),
            _ if rim.is_finite() => rim,
            _ => from.max(1e-300),
        };
        if matches!(self.profile, Profile::Table(_)) {
            if self.profile.line(high) < depth {
                return Err(Refusal::NoSuchState {
                    reason: format!("the contact reaches out beyond the last point of the table: the depth of its edge would be {depth:e}"),
                    limit_name: "the radius of its last point",
                    limit: high,
                });
            }
        } else {
            while self.profile.line(high) < depth {
                high *= 16.0;
                if !high.is_finite() {
                    return Err(Refusal::OutOfRange { quantity: "contact radius", value: high, allowed: "a finite number" });
                }
            }
        }
        Ok(self.profile.inverse_coordinate(depth, from, high))
    }

    /// S at the places of an interval in contact, after a moment.
    pub(super) fn pressed(&self, interval: &Interval, moment: &Moment) -> Nodal {
        let soft = self.chain.relaxed / self.chain.glassy;
        let mut sum: Nodal = interval.heights.map(|height| soft * (moment.depth - height));
        for (index, &(modulus, _)) in self.chain.maxwell.iter().enumerate() {
            let share = modulus / self.chain.glassy;
            let (kept, gained) = (moment.kept[index], moment.gained[index]);
            for (sum, u) in sum.iter_mut().zip(interval.term(index)) {
                *sum += share * (u * kept + gained);
            }
        }
        sum
    }

    /// S at the places of a free interval, after a moment.
    pub(super) fn opened(&self, interval: &Interval, moment: &Moment) -> Nodal {
        let mut sum: Nodal = interval.heights.map(|height| moment.depth - height);
        for (index, kept) in moment.recovered.iter().enumerate() {
            for (sum, e) in sum.iter_mut().zip(interval.term(index)) {
                *sum -= e * kept;
            }
        }
        sum
    }

    /// Q now, at the places of an interval in contact.
    pub(super) fn load(&self, interval: &Interval) -> Nodal {
        let mut sum: Nodal = interval.heights.map(|height| self.chain.relaxed * (self.penetration - height));
        for (index, &(modulus, _)) in self.chain.maxwell.iter().enumerate() {
            for (sum, u) in sum.iter_mut().zip(interval.term(index)) {
                *sum += modulus * u;
            }
        }
        sum
    }

    /// F (N).
    pub(super) fn force(&self) -> f64 {
        2.0 * self.contact.iter().map(|interval| interval.width() * GRID.integral(&self.load(interval))).sum::<f64>()
    }

    /// U (J) and P_d (W).
    pub(super) fn energies(&self) -> [f64; 2] {
        let chain = self.chain;
        let [mut stored, mut power] = [0.0; 2];
        let square = |values: &[f64]| {
            let mut squares = [0.0; NODES];
            for (square, value) in squares.iter_mut().zip(values) {
                *square = value * value;
            }
            GRID.integral(&squares)
        };
        for interval in &self.contact {
            let under = interval.heights.map(|height| self.penetration - height);
            stored += interval.width() * chain.relaxed * square(&under);
            for (index, &(modulus, rho)) in chain.maxwell.iter().enumerate() {
                let of_branch = interval.width() * modulus * square(interval.term(index));
                stored += of_branch;
                power += 2.0 * of_branch / rho;
            }
        }
        for interval in &self.free {
            for (index, &(rate, flow)) in chain.voigt.iter().enumerate() {
                // J_j = φ_jτ_j: the strain of a flow stores nothing.
                let of_element = interval.width() * rate / flow * square(interval.term(index));
                stored += of_element;
                power += 2.0 * of_element * rate;
            }
        }
        [stored, power]
    }

    /// ∫e_j ds over what is free.
    pub(super) fn free_strains(&self) -> Vec<f64> {
        let of = |index: usize| self.free.iter().map(|interval| interval.width() * dot(&GRID.weights, interval.term(index))).sum();
        (0..self.chain.terms()).map(of).collect()
    }

    /// ∫u_i ds over the whole line, of which the free part has these strains.
    pub(super) fn whole_springs(&self, free: &[f64]) -> Vec<f64> {
        let mut springs = free.to_vec();
        self.chain.touched(free.iter().sum(), &mut springs, &mut Vec::new());
        for interval in &self.contact {
            for (index, spring) in springs.iter_mut().enumerate() {
                *spring += interval.width() * dot(&GRID.weights, interval.term(index));
            }
        }
        springs
    }

    /// Where the free surface next to the contact is after a time, as a penetration that touches it.
    pub(super) fn surface_after(&self, time: f64) -> f64 {
        let Some(interval) = self.free.first() else { return self.profile.line(self.radius()) };
        let strains = (0..self.chain.terms()).filter_map(|index| interval.term(index).first());
        interval.heights[0] + self.chain.voigt.iter().zip(strains).map(|((rate, _), e)| e * (-rate * time).exp()).sum::<f64>()
    }

    /// The largest place and penetration that the shape is known for.
    pub(super) fn known(&self) -> [f64; 2] {
        if let Profile::Table(shape) = self.profile { [shape.reach(), self.profile.line(shape.reach())] } else { [f64::INFINITY; 2] }
    }

    /// Lets a time pass over all that the edge does not touch.
    pub(super) fn age(&mut self, moment: &Moment) {
        let slowest = |rests: &[f64]| rests.iter().fold(0.0, |most: f64, rest| most.max(*rest));
        let [relaxed, recovered] = [slowest(&moment.kept), slowest(&moment.recovered)];
        for interval in &mut self.contact {
            interval.then *= relaxed;
            for (index, (kept, gained)) in moment.kept.iter().zip(&moment.gained).enumerate() {
                for u in interval.state.iter_mut().skip(index * NODES).take(NODES) {
                    *u = *u * kept + gained;
                }
            }
        }
        for interval in &mut self.free {
            interval.then *= recovered;
            for (index, kept) in moment.recovered.iter().enumerate() {
                for e in interval.state.iter_mut().skip(index * NODES).take(NODES) {
                    *e *= kept;
                }
            }
        }
        self.updates += (self.contact.len() + self.free.len()) as u64 * NODES as u64;
    }
}
