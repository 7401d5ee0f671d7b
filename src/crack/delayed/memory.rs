//! The memory of a moving window: two numbers per creep term, whatever the length of the history.
//!
//! Loads over the glassy limit (κ), lengths over the process zone (x), the history as pieces on which both are straight in time:
//! ```text
//! P_j = g_j ∫ e^{−l_j(t − t₁)} κ(t₁) dt₁        R_j = g_j ∫ e^{−l_j(t − t₁)} κ(t₁) (x − x(t₁)) dt₁        M_j = P_j − R_j        N_j = g_jκ − l_jM_j
//! w/Δγ = κ² + κ Σ M_j                            g_j = E∞J_j/τ_j, l_j = 1/τ_j; flow: g = E∞/η, l = 0
//! ```
//! N is carried along: for a term much faster than the step it is a small difference of large numbers. Both integrals run over the window x(t₁) > x − 1. A step multiplies by e^{−l_jΔt}, moves R by P·Δx and adds one exact integral
//! ([`super::moments`]), so a step costs one exponential per term. What leaves the window is subtracted; the sums are formed anew, forwards
//! and without subtraction, whenever a rest leaves (it may be nearly all of P) and once per window.

use super::moments::fading_moments;
use crate::material::Material;
use std::collections::VecDeque;

/// Positions closer than this (in process zones) are the same.
pub(crate) const SAME_PLACE: f64 = 1e-12;

/// One creep term, or the flow: gain (1/s) and rate (1/s).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Term {
    pub(crate) gain: f64,
    pub(crate) rate: f64,
}

pub(crate) fn terms_of(material: &Material) -> Vec<Term> {
    let glassy = material.glassy_modulus();
    let mut terms: Vec<Term> = material
        .creep_terms()
        .iter()
        .map(|term| Term { gain: glassy * term.compliance / term.retardation_time, rate: 1.0 / term.retardation_time })
        .collect();
    if let Some(viscosity) = material.steady_viscosity() {
        terms.push(Term { gain: glassy / viscosity, rate: 0.0 });
    }
    terms
}

/// A piece of history: straight in time from (x, κ) to (x, κ), or a rest at one place under any load.
#[derive(Debug, Clone)]
struct Piece {
    end: f64,
    duration: f64,
    places: [f64; 2],
    loads: [f64; 2],
    /// Of a rest: what it left in each term's P and N at its end. Rests at one place become one piece, whatever the loads were.
    rested: Option<Vec<[f64; 2]>>,
}

/// A step from the present: duration (s), advance (process zones), load at its start and end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) duration: f64,
    pub(crate) advance: f64,
    pub(crate) loads: [f64; 2],
}

impl Step {
    pub(crate) const fn none(load: f64) -> Self {
        Self { duration: 0.0, advance: 0.0, loads: [load, load] }
    }
}

/// The sums over the terms that the closure and its derivatives need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sums {
    /// ΣM_j.
    pub(crate) memory: f64,
    /// ΣP_j = −d(ΣM_j)/dx at fixed time.
    pub(crate) exposure: f64,
    /// ΣN_j, the rate at which ΣM_j grows at rest (1/s).
    pub(crate) growth: f64,
}

/// The memory and the pieces that are in the window.
#[derive(Debug, Clone)]
pub(crate) struct Memory {
    pub(crate) terms: Vec<Term>,
    exposure: Vec<f64>,
    lag: Vec<f64>,
    lack: Vec<f64>,
    load: f64,
    pieces: VecDeque<Piece>,
    /// Time and place of the tip since the last [`Memory::rebase`].
    pub(crate) clock: f64,
    pub(crate) place: f64,
    left_since_sum: usize,
    /// Term integrals evaluated.
    pub(crate) kernel_evaluations: u64,
    /// The largest number of pieces ever held.
    pub(crate) most_pieces: usize,
}

impl Memory {
    pub(crate) fn new(terms: Vec<Term>) -> Self {
        let zeros = vec![0.0; terms.len()];
        Self {
            terms,
            exposure: zeros.clone(),
            lag: zeros.clone(),
            lack: zeros,
            load: 0.0,
            pieces: VecDeque::new(),
            clock: 0.0,
            place: 0.0,
            left_since_sum: 0,
            kernel_evaluations: 0,
            most_pieces: 0,
        }
    }

    /// The parts of pieces behind the window of a tip at `place`, oldest first.
    fn behind(&self, place: f64) -> impl Iterator<Item = Piece> + '_ {
        let back = place - 1.0;
        self.pieces.iter().take_while(move |piece| piece.places[0] < back - SAME_PLACE).map(move |piece| {
            let [from, to] = piece.places;
            if to <= back {
                return piece.clone();
            }
            let part = (back - from) / (to - from);
            Piece {
                end: piece.end - (1.0 - part) * piece.duration,
                duration: part * piece.duration,
                places: [from, back],
                loads: [piece.loads[0], piece.loads[0] + part * (piece.loads[1] - piece.loads[0])],
                rested: None,
            }
        })
    }

    /// P and M of one piece for one term, seen from `clock` and `place`.
    fn integrals(term: Term, index: usize, piece: &Piece, clock: f64, place: f64) -> [f64; 2] {
        if let Some(rested) = &piece.rested {
            let exposure = rested.get(index).map_or(0.0, |values| values[0]) * (-term.rate * (clock - piece.end)).exp();
            return [exposure, exposure * (1.0 - (place - piece.places[1]))];
        }
        let (_, [n0, n1, n2]) = fading_moments(term.rate * piece.duration);
        let scale = term.gain * piece.duration * (-term.rate * (clock - piece.end)).exp();
        let [first, last] = piece.loads;
        let weights = piece.places.map(|earlier| 1.0 - (place - earlier));
        let (load_slope, weight_slope) = (first - last, weights[0] - weights[1]);
        [
            scale * (last * n0 + load_slope * n1),
            scale * (last * weights[1] * n0 + (last * weight_slope + load_slope * weights[1]) * n1 + load_slope * weight_slope * n2),
        ]
    }

    /// The sums after a step that is not taken, and each term's M_j if a place for them is given.
    pub(crate) fn after(&mut self, step: &Step, mut each: Option<&mut Vec<f64>>) -> Sums {
        let (clock, place) = (self.clock + step.duration, self.place + step.advance);
        let leaving: Vec<Piece> = self.behind(place).collect();
        let mut sums = Sums { memory: 0.0, exposure: 0.0, growth: 0.0 };
        let [first, last] = step.loads;
        for (index, term) in self.terms.iter().enumerate() {
            let (decay, [n0, n1, n2]) = fading_moments(term.rate * step.duration);
            let gain = term.gain * step.duration;
            let old = decay * self.exposure[index];
            let mut exposure = old + gain * (last * n0 + (first - last) * n1);
            // 1 − Δx·v is the weight of the step itself.
            let mut memory = (old - decay * self.lag[index] - step.advance * old)
                + gain * (last * n0 + (first - last - last * step.advance) * n1 - (first - last) * step.advance * n2);
            let mut lack = self.lack_after(index, step, decay, [n0, n1]);
            for piece in &leaving {
                let [outside, weighted] = Self::integrals(*term, index, piece, clock, place);
                exposure -= outside;
                memory -= weighted;
                lack += term.rate * weighted;
            }
            sums.memory += memory;
            sums.exposure += exposure;
            sums.growth += lack;
            if let Some(each) = each.as_mut() {
                each.push(memory);
            }
        }
        self.kernel_evaluations += (self.terms.len() * (1 + leaving.len())) as u64;
        sums
    }

    /// N_j after a step: by parts, so that the difference of two large numbers is never formed.
    fn lack_after(&self, index: usize, step: &Step, decay: f64, [n0, n1]: [f64; 2]) -> f64 {
        let Some(term) = self.terms.get(index) else { return 0.0 };
        let [first, last] = step.loads;
        let before = self.lack[index] + term.gain * (first - self.load);
        let exposed = term.gain * first - term.rate * self.exposure[index];
        let fall = first - last;
        decay * (before - step.advance * exposed) - term.gain * ((fall - step.advance * last) * n0 - 2.0 * step.advance * fall * n1)
    }

    /// Takes a step, and lets what is behind the window go.
    pub(crate) fn take(&mut self, step: &Step) {
        let [first, last] = step.loads;
        for (index, term) in self.terms.iter().enumerate() {
            let (decay, [n0, n1, n2]) = fading_moments(term.rate * step.duration);
            let gain = term.gain * step.duration;
            let old = decay * self.exposure[index];
            self.lack[index] = self.lack_after(index, step, decay, [n0, n1]);
            self.lag[index] = decay * self.lag[index] + step.advance * (old + gain * (last * n1 + (first - last) * n2));
            self.exposure[index] = old + gain * (last * n0 + (first - last) * n1);
        }
        self.kernel_evaluations += self.terms.len() as u64;
        let from = self.place;
        self.load = last;
        self.clock += step.duration;
        self.place += step.advance;
        if step.duration > 0.0 {
            self.remember(step, from);
        }
        let mut rest_left = false;
        while let Some(piece) = self.pieces.front().cloned() {
            if piece.places[1] > self.place - 1.0 + SAME_PLACE {
                break;
            }
            rest_left |= piece.rested.is_some();
            for (index, term) in self.terms.iter().enumerate() {
                let [outside, weighted] = Self::integrals(*term, index, &piece, self.clock, self.place);
                self.exposure[index] -= outside;
                self.lag[index] -= outside - weighted;
                self.lack[index] += term.rate * weighted;
            }
            self.kernel_evaluations += self.terms.len() as u64;
            self.left_since_sum += 1;
            self.pieces.pop_front();
        }
        if rest_left || self.left_since_sum > self.pieces.len() {
            self.sum_anew();
        }
    }

    /// Adds the step to the pieces; a rest joins a rest at the same place.
    fn remember(&mut self, step: &Step, from: f64) {
        let mut piece = Piece { end: self.clock, duration: step.duration, places: [from, self.place], loads: step.loads, rested: None };
        if step.advance == 0.0 {
            let joined = match self.pieces.back_mut() {
                Some(last) if last.rested.is_some() && last.places[1].to_bits() == from.to_bits() => self.pieces.pop_back(),
                _ => None,
            };
            let earlier = joined.as_ref().and_then(|last| last.rested.as_deref());
            let earlier_load = joined.as_ref().map_or(0.0, |last| last.loads[1]);
            let [first, last] = step.loads;
            let exposures = self
                .terms
                .iter()
                .enumerate()
                .map(|(index, term)| {
                    let (decay, [n0, n1, _]) = fading_moments(term.rate * step.duration);
                    let [before, lack] = earlier.and_then(|values| values.get(index)).copied().unwrap_or([0.0; 2]);
                    let lack = lack + term.gain * (first - earlier_load);
                    [
                        decay * before + term.gain * step.duration * (last * n0 + (first - last) * n1),
                        decay * lack - term.gain * (first - last) * n0,
                    ]
                })
                .collect();
            piece.rested = Some(exposures);
            piece.duration += joined.map_or(0.0, |last| last.duration);
        }
        self.pieces.push_back(piece);
        self.most_pieces = self.most_pieces.max(self.pieces.len());
    }

    /// How many pieces the window holds.
    pub(crate) fn pieces_held(&self) -> usize {
        self.pieces.len()
    }

    /// P, R and N from the pieces, forwards: no subtraction.
    fn sum_anew(&mut self) {
        self.left_since_sum = 0;
        self.exposure.fill(0.0);
        self.lag.fill(0.0);
        self.lack.fill(0.0);
        let load_now = std::mem::replace(&mut self.load, 0.0);
        let mut last_place = self.pieces.front().map_or(self.place, |piece| piece.places[0]);
        let pieces = std::mem::take(&mut self.pieces);
        for piece in &pieces {
            self.jump(piece.places[0] - last_place);
            let [first, last] = piece.loads;
            let step = Step { duration: piece.duration, advance: piece.places[1] - piece.places[0], loads: piece.loads };
            for (index, term) in self.terms.iter().enumerate() {
                let (decay, [n0, n1, n2]) = fading_moments(term.rate * piece.duration);
                let gain = term.gain * piece.duration;
                let old = decay * self.exposure[index];
                if let Some([rested, lack]) = piece.rested.as_ref().and_then(|values| values.get(index)) {
                    self.lack[index] = lack - term.rate * decay * (self.exposure[index] - self.lag[index]);
                    self.lag[index] *= decay;
                    self.exposure[index] = old + rested;
                    continue;
                }
                self.lack[index] = self.lack_after(index, &step, decay, [n0, n1]);
                self.lag[index] = decay * self.lag[index] + step.advance * (old + gain * (last * n1 + (first - last) * n2));
                self.exposure[index] = old + gain * (last * n0 + (first - last) * n1);
            }
            self.load = last;
            last_place = piece.places[1];
        }
        self.pieces = pieces;
        self.jump(self.place - last_place);
        for (lack, term) in self.lack.iter_mut().zip(&self.terms) {
            *lack += term.gain * (load_now - self.load);
        }
        self.load = load_now;
        self.kernel_evaluations += (self.terms.len() * self.pieces.len()) as u64;
    }

    /// Moves the tip in no time.
    fn jump(&mut self, advance: f64) {
        for (index, term) in self.terms.iter().enumerate() {
            self.lag[index] += advance * self.exposure[index];
            self.lack[index] += advance * term.rate * self.exposure[index];
        }
    }

    /// Sets clock and place back near zero, so that long histories lose no digits; returns by how much.
    pub(crate) fn rebase(&mut self) -> [f64; 2] {
        let shift = [self.clock, self.place.floor()];
        for piece in &mut self.pieces {
            piece.end -= shift[0];
            piece.places = piece.places.map(|place| place - shift[1]);
        }
        self.clock = 0.0;
        self.place -= shift[1];
        shift
    }

    /// Replaces the window by a uniform motion: one process zone in `crossing_time` under one load.
    pub(crate) fn make_steady(&mut self, crossing_time: f64, load: f64) {
        self.pieces.clear();
        let places = [self.place - 1.0, self.place];
        self.pieces.push_back(Piece { end: self.clock, duration: crossing_time, places, loads: [load, load], rested: None });
        self.load = load;
        self.sum_anew();
    }
}
