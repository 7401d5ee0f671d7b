//! The line of a contact without adhesion: stretches of seventeen chains each, those in contact first.
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
use super::drive::Moment;
use super::grid::{GRID, NODES, Nodal, dot};
use crate::indentation::profile::Profile;
use crate::refusal::Refusal;

/// Halvings of a stretch that is not resolved.
const MOST_HALVINGS: u32 = 48;
/// A stretch narrower than this, over the edge's place, is none.
pub(super) const NARROWEST: f64 = 4e-15;
/// Strains of this part of the depth are none.
const DEAD: f64 = 1e-18;
/// Stretches from which on they are joined more readily.
const MANY: usize = 3000;

/// A stretch of the line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stretch {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) heights: Nodal,
    /// u_i or e_j, term after term.
    pub(super) state: Vec<f64>,
    /// Whether it may be joined with the next one: not tried since it changed.
    fresh: bool,
}

impl Stretch {
    pub(super) fn place(&self, k: usize) -> f64 {
        place_of(self.low, self.high, k)
    }

    pub(super) fn width(&self) -> f64 {
        self.high - self.low
    }

    pub(super) fn term(&self, index: usize) -> &[f64] {
        self.state.get(index * NODES..(index + 1) * NODES).unwrap_or(&[])
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
    pub(super) contact: Vec<Stretch>,
    pub(super) free: Vec<Stretch>,
    pub(super) penetration: f64,
    /// Largest |Δ| so far (m).
    pub(super) depth: f64,
    /// What a series may leave, over the depth.
    pub(super) tolerance: f64,
    /// Σ of what joining stretches changed (m): no state is off by more, since nothing that follows makes a difference larger.
    pub(super) joined: f64,
    pub(super) updates: u64,
    pub(super) most_stretches: u64,
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
            joined: 0.0,
            updates: 0,
            most_stretches: 0,
        }
    }

    /// a.
    pub(super) fn radius(&self) -> f64 {
        self.contact.last().map_or(0.0, |stretch| stretch.high)
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

    /// S at the places of a stretch in contact, after a moment.
    pub(super) fn pressed(&self, stretch: &Stretch, moment: &Moment) -> Nodal {
        let soft = self.chain.relaxed / self.chain.glassy;
        let mut sum: Nodal = stretch.heights.map(|height| soft * (moment.depth - height));
        for (index, &(modulus, _)) in self.chain.maxwell.iter().enumerate() {
            let share = modulus / self.chain.glassy;
            let (kept, gained) = (moment.kept[index], moment.gained[index]);
            for (sum, u) in sum.iter_mut().zip(stretch.term(index)) {
                *sum += share * (u * kept + gained);
            }
        }
        sum
    }

    /// S at the places of a free stretch, after a moment.
    pub(super) fn opened(&self, stretch: &Stretch, moment: &Moment) -> Nodal {
        let mut sum: Nodal = stretch.heights.map(|height| moment.depth - height);
        for (index, kept) in moment.recovered.iter().enumerate() {
            for (sum, e) in sum.iter_mut().zip(stretch.term(index)) {
                *sum -= e * kept;
            }
        }
        sum
    }

    /// Q now, at the places of a stretch in contact.
    pub(super) fn load(&self, stretch: &Stretch) -> Nodal {
        let mut sum: Nodal = stretch.heights.map(|height| self.chain.relaxed * (self.penetration - height));
        for (index, &(modulus, _)) in self.chain.maxwell.iter().enumerate() {
            for (sum, u) in sum.iter_mut().zip(stretch.term(index)) {
                *sum += modulus * u;
            }
        }
        sum
    }

    /// F (N).
    pub(super) fn force(&self) -> f64 {
        2.0 * self.contact.iter().map(|stretch| stretch.width() * GRID.integral(&self.load(stretch))).sum::<f64>()
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
        for stretch in &self.contact {
            let under = stretch.heights.map(|height| self.penetration - height);
            stored += stretch.width() * chain.relaxed * square(&under);
            for (index, &(modulus, rho)) in chain.maxwell.iter().enumerate() {
                let of_branch = stretch.width() * modulus * square(stretch.term(index));
                stored += of_branch;
                power += 2.0 * of_branch / rho;
            }
        }
        for stretch in &self.free {
            for (index, &(rate, flow)) in chain.voigt.iter().enumerate() {
                // J_j = φ_jτ_j: the strain of a flow stores nothing.
                let of_element = stretch.width() * rate / flow * square(stretch.term(index));
                stored += of_element;
                power += 2.0 * of_element * rate;
            }
        }
        [stored, power]
    }

    /// 2∫e_j ds over the whole line, for the force as what drives them all.
    pub(super) fn whole_strains(&self) -> Vec<f64> {
        let terms = self.chain.terms();
        let mut sums = vec![0.0; terms];
        let (mut state, mut scratch) = (vec![0.0; terms], Vec::new());
        for stretch in &self.contact {
            for index in 0..terms {
                if let Some(value) = state.get_mut(index) {
                    *value = stretch.width() * dot(&GRID.weights, stretch.term(index));
                }
            }
            let under = stretch.heights.map(|height| self.penetration - height);
            self.chain.released(stretch.width() * GRID.integral(&under), &mut state, &mut scratch);
            for (sum, value) in sums.iter_mut().zip(&state) {
                *sum += 2.0 * value;
            }
        }
        for stretch in &self.free {
            for (index, sum) in sums.iter_mut().enumerate() {
                *sum += 2.0 * stretch.width() * dot(&GRID.weights, stretch.term(index));
            }
        }
        sums
    }

    /// What each term of a state weighs in S.
    fn shares(&self, in_contact: bool) -> Vec<f64> {
        if in_contact {
            self.chain.maxwell.iter().map(|(modulus, _)| modulus / self.chain.glassy).collect()
        } else {
            vec![1.0; self.chain.terms()]
        }
    }

    /// Stretches between two places with the states of a function of place and height, halved until series keep them.
    pub(super) fn build(
        &mut self,
        (low, high): (f64, f64),
        in_contact: bool,
        at: &mut dyn FnMut(f64, f64, &mut [f64]),
        into: &mut Vec<Stretch>,
    ) {
        if high - low <= 0.0 {
            return;
        }
        let shares = self.shares(in_contact);
        let noise = &self.chain.noise[usize::from(!in_contact)];
        let breaks = if let Profile::Table(_) = self.profile { self.profile.breaks(high) } else { Vec::new() };
        let mut start = low;
        for end in breaks.into_iter().filter(|place| *place > low * (1.0 + 1e-9) && *place < high * (1.0 - 1e-9)).chain([high]) {
            self.build_smooth((start, end), (&shares, noise), at, into, MOST_HALVINGS);
            start = end;
        }
    }

    fn build_smooth(
        &mut self,
        (low, high): (f64, f64),
        (shares, noise): (&[f64], &[f64]),
        at: &mut dyn FnMut(f64, f64, &mut [f64]),
        into: &mut Vec<Stretch>,
        halvings: u32,
    ) {
        let terms = self.chain.terms();
        let mut stretch = Stretch { low, high, heights: [0.0; NODES], state: vec![0.0; terms * NODES], fresh: true };
        let mut state = vec![0.0; terms];
        for k in 0..NODES {
            let place = stretch.place(k);
            let height = self.profile.line(place);
            stretch.heights[k] = height;
            at(place, height, &mut state);
            for (index, value) in state.iter().enumerate() {
                if let Some(cell) = stretch.state.get_mut(index * NODES + k) {
                    *cell = *value;
                }
            }
        }
        self.updates += NODES as u64;
        let allowed = self.tolerance * self.depth;
        let left = |values: &[f64]| <&Nodal>::try_from(values).map_or(0.0, |values| GRID.tail(values));
        let resolved = left(&stretch.heights) <= allowed
            && shares
                .iter()
                .zip(noise)
                .enumerate()
                .all(|(index, (share, noise))| share * left(stretch.term(index)) <= allowed.max(noise * self.depth));
        let middle = 0.5 * (low + high);
        if resolved || halvings == 0 || high - low <= 1e3 * NARROWEST * high {
            into.push(stretch);
        } else {
            self.build_smooth((low, middle), (shares, noise), at, into, halvings - 1);
            self.build_smooth((middle, high), (shares, noise), at, into, halvings - 1);
        }
    }

    /// Lets a time pass over all that the edge does not touch.
    pub(super) fn age(&mut self, moment: &Moment) {
        for stretch in &mut self.contact {
            for (index, (kept, gained)) in moment.kept.iter().zip(&moment.gained).enumerate() {
                for u in stretch.state.iter_mut().skip(index * NODES).take(NODES) {
                    *u = *u * kept + gained;
                }
            }
        }
        for stretch in &mut self.free {
            for (index, kept) in moment.recovered.iter().enumerate() {
                for e in stretch.state.iter_mut().skip(index * NODES).take(NODES) {
                    *e *= kept;
                }
            }
        }
        self.updates += (self.contact.len() + self.free.len()) as u64 * NODES as u64;
    }

    /// Joins neighbours that one series keeps, and forgets what has recovered.
    pub(super) fn tidy(&mut self, all: bool) {
        let dead = DEAD * self.depth;
        while self.free.last().is_some_and(|stretch| stretch.state.iter().all(|e| e.abs() <= dead)) {
            self.free.pop();
        }
        self.most_stretches = self.most_stretches.max((self.contact.len() + self.free.len()) as u64);
        let many = self.contact.len() + self.free.len() > MANY;
        for in_contact in [true, false] {
            let shares = self.shares(in_contact);
            let noise: f64 = self.chain.noise[usize::from(!in_contact)].iter().sum();
            let allowed = (self.tolerance.max(noise)) * self.depth * if many { 100.0 } else { 1.0 };
            let list = std::mem::take(if in_contact { &mut self.contact } else { &mut self.free });
            let mut kept: Vec<Stretch> = Vec::with_capacity(list.len());
            for stretch in list {
                let mut next = stretch;
                while let Some(before) = kept.last() {
                    if !(all || before.fresh || next.fresh) {
                        break;
                    }
                    let Some((joined, change)) = self.joined(before, &next, &shares, allowed) else { break };
                    self.joined += change;
                    kept.pop();
                    next = joined;
                }
                kept.push(next);
            }
            for stretch in &mut kept {
                stretch.fresh = false;
            }
            *(if in_contact { &mut self.contact } else { &mut self.free }) = kept;
        }
    }

    /// Two neighbours as one, and what that changes in S at most; none where it would be more than is allowed.
    fn joined(&self, first: &Stretch, second: &Stretch, shares: &[f64], allowed: f64) -> Option<(Stretch, f64)> {
        let (low, high) = (first.low, second.high);
        let terms = self.chain.terms();
        let mut whole = Stretch { low, high, heights: [0.0; NODES], state: vec![0.0; terms * NODES], fresh: true };
        for k in 0..NODES {
            let place = whole.place(k);
            whole.heights[k] = self.profile.line(place);
            let of = if place <= first.high { first } else { second };
            let weights = GRID.at(place - of.low, of.high - place);
            for index in 0..terms {
                if let Some(cell) = whole.state.get_mut(index * NODES + k) {
                    *cell = dot(&weights, of.term(index));
                }
            }
        }
        let mut most = 0.0_f64;
        // The middle of both first: where it fails, it mostly fails at their border.
        for of in [first, second] {
            for k in (0..NODES).rev() {
                let place = of.place(k);
                let weights = GRID.at(place - low, high - place);
                let mut change = (dot(&weights, &whole.heights) - of.heights[k]).abs();
                for (index, share) in shares.iter().enumerate() {
                    let there = of.term(index).get(k).copied().unwrap_or(0.0);
                    change += share * (dot(&weights, whole.term(index)) - there).abs();
                }
                most = most.max(change);
                if most > allowed {
                    return None;
                }
            }
        }
        Some((whole, most))
    }
}
