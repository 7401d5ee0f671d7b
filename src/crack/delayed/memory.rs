//! The memory of a moving window: three numbers per creep term, whatever the length of the history.
//!
//! Loads over the glassy limit (κ), lengths over the greatest process zone of the history (x; the present zone is z ≤ 1), the history as
//! pieces on which the load is straight in time and the tip's way a parabola, chord + bend·v(1 − v):
//! ```text
//! P_j = g_j ∫ e^{−l_j(t − t₁)} κ(t₁) dt₁        R_j = g_j ∫ e^{−l_j(t − t₁)} κ(t₁) (x − x(t₁)) dt₁        over x(t₁) > x − z
//! M_j = P_j − R_j/z        Q_j = g_jκ − l_jP_j        N_j = g_jκ − l_jM_j = Q_j + l_jR_j/z
//! w/Δγ = κ² + κ Σ M_j                            g_j = E∞J_j/τ_j, l_j = 1/τ_j; flow: g = E∞/η, l = 0
//! ```
//! Q is carried along: for a term much faster than the step it is a small difference of large numbers. A step multiplies by e^{−l_jΔt},
//! moves R by P·Δx and adds one exact integral ([`super::moments`]), so a step costs one exponential per term. What leaves the window is
//! subtracted, and what a growing window takes back is added; the sums are formed anew, forwards and without subtraction, whenever a rest
//! leaves (it may be nearly all of P) and once per window. Pieces are kept until no zone of the history reaches them.

use super::moments::fading_moments;
use crate::material::PlaneMaterial;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;

/// Positions closer than this (in process zones) are the same.
pub(crate) const SAME_PLACE: f64 = 1e-12;

/// Halvings of a piece for the time at a place in it: beyond, the rounding of the place.
const HALVINGS: u32 = 40;

/// One creep term, or the flow: gain (1/s) and rate (1/s).
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Term {
    pub(crate) gain: f64,
    pub(crate) rate: f64,
}

pub(crate) fn terms_of(material: &PlaneMaterial) -> Vec<Term> {
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

/// A time that is summed up from many steps: what one addition rounds off is added by the next. Equal steps would otherwise all be rounded to the same side.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub(crate) struct Clock {
    time: f64,
    rounded_off: f64,
}

impl Clock {
    pub(crate) const fn time(&self) -> f64 {
        self.time
    }

    pub(crate) fn pass(&mut self, duration: f64) {
        let duration = duration + self.rounded_off;
        let sum = self.time + duration;
        // Knuth's exact rest of a sum.
        let added = sum - self.time;
        self.rounded_off = (self.time - (sum - added)) + (duration - added);
        self.time = sum;
    }
}

/// What is left of a value after z retardation times; `zeroth` is n₀(z). Short steps subtract what goes: a factor near one would be rounded to the same side in all
/// of many equal steps.
fn faded(value: f64, z: f64, decay: f64, zeroth: f64) -> f64 {
    if z < 0.5 { value - z * zeroth * value } else { decay * value }
}

/// A piece of history: a parabola in time from x to x, straight from κ to κ, or a rest at one place under any load.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Piece {
    end: f64,
    duration: f64,
    places: [f64; 2],
    /// How far the way bends off the chord: x = chord + bend·v(1 − v).
    bend: f64,
    loads: [f64; 2],
    /// Speeds at both ends, where they are known.
    speeds: Option<[f64; 2]>,
    /// Of a rest: what it left in each term's P and Q at its end. Rests at one place become one piece, whatever the loads were.
    rested: Option<Vec<[f64; 2]>>,
}

impl Piece {
    /// The part of its duration that has passed when the tip is at a place.
    fn when(&self, place: f64) -> f64 {
        // Δσ + bσ(1 − σ) = y, |b| ≤ Δ.
        let [first, last] = self.places;
        let (way, sum) = (place - first, last - first + self.bend);
        let root = (sum * sum - 4.0 * self.bend * way).max(0.0).sqrt();
        (2.0 * way / (sum + root)).clamp(0.0, 1.0)
    }

    /// The part between two places, of a piece that is no rest.
    fn part(&self, from: f64, to: f64) -> Self {
        let at = |place: f64| self.when(place);
        let (start, end) = (at(from), at(to));
        let load = |part: f64| self.loads[0] + part * (self.loads[1] - self.loads[0]);
        Self {
            end: self.end - (1.0 - end) * self.duration,
            duration: (end - start) * self.duration,
            places: [from, to],
            bend: self.bend * (end - start) * (end - start),
            loads: [load(start), load(end)],
            speeds: None,
            rested: None,
        }
    }
}

/// A step from the present: duration (s), advance, load at its start and end, process zone at its end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) duration: f64,
    pub(crate) advance: f64,
    /// See [`Piece::bend`]; the tip does not turn: at most the advance.
    pub(crate) bend: f64,
    pub(crate) loads: [f64; 2],
    pub(crate) zone: f64,
}

impl Step {
    pub(crate) const fn none(load: f64, zone: f64) -> Self {
        Self { duration: 0.0, advance: 0.0, bend: 0.0, loads: [load, load], zone }
    }
}

/// The sums over the terms that the closure and its derivatives need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sums {
    /// ΣM_j.
    pub(crate) memory: f64,
    /// ΣP_j = −z d(ΣM_j)/dx at fixed time.
    pub(crate) exposure: f64,
    /// ΣR_j = z² d(ΣM_j)/dz at fixed time and place.
    pub(crate) lag: f64,
    /// ΣN_j, the rate at which ΣM_j grows at rest in a constant zone (1/s).
    pub(crate) growth: f64,
}

/// What a piece holds of one term, seen from a time and place: P, R, and M in a zone.
struct Held {
    exposure: f64,
    lag: f64,
    weighted: f64,
}

/// The memory and the pieces that are in the window, or may come back into it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Memory {
    pub(crate) terms: Vec<Term>,
    exposure: Vec<f64>,
    lag: Vec<f64>,
    lack: Vec<f64>,
    load: f64,
    /// z.
    pub(crate) zone: f64,
    pieces: VecDeque<Piece>,
    /// Pieces before this one are behind the window.
    first: usize,
    /// Time and place of the tip since the last [`Memory::rebase`].
    clock: Clock,
    pub(crate) place: f64,
    left_since_sum: usize,
    /// Term integrals evaluated.
    pub(crate) kernel_evaluations: u64,
    /// The largest number of pieces ever held.
    pub(crate) most_pieces: usize,
}

impl Memory {
    pub(crate) fn new(terms: Vec<Term>, zone: f64) -> Self {
        let zeros = vec![0.0; terms.len()];
        Self {
            terms,
            exposure: zeros.clone(),
            lag: zeros.clone(),
            lack: zeros,
            load: 0.0,
            zone,
            pieces: VecDeque::new(),
            first: 0,
            clock: Clock::default(),
            place: 0.0,
            left_since_sum: 0,
            kernel_evaluations: 0,
            most_pieces: 0,
        }
    }

    /// The parts of pieces that a window from `back` on leaves, with −1, and those that it takes back, with 1.
    fn exchanged(&self, back: f64) -> Vec<(f64, Piece)> {
        let leaving = self.pieces.range(self.first..).take_while(move |piece| piece.places[0] < back - SAME_PLACE);
        let leaving = leaving.map(|piece| (-1.0, if piece.places[1] <= back { piece.clone() } else { piece.part(piece.places[0], back) }));
        let entering = self.pieces.range(..self.first).rev().take_while(move |piece| piece.places[1] > back + SAME_PLACE);
        let entering = entering.map(|piece| (1.0, if piece.places[0] >= back { piece.clone() } else { piece.part(back, piece.places[1]) }));
        leaving.chain(entering).collect()
    }

    /// One piece for one term, seen from `clock` and `place` with a zone.
    fn held(term: Term, index: usize, piece: &Piece, clock: f64, place: f64, zone: f64) -> Held {
        let fade = (-term.rate * (clock - piece.end)).exp();
        if let Some(rested) = &piece.rested {
            let exposure = rested.get(index).map_or(0.0, |values| values[0]) * fade;
            let distance = place - piece.places[1];
            return Held { exposure, lag: exposure * distance, weighted: exposure * (1.0 - distance / zone) };
        }
        let (_, [n0, n1, n2, n3]) = fading_moments(term.rate * piece.duration);
        let scale = term.gain * piece.duration * fade;
        let [first, last] = piece.loads;
        let load_slope = first - last;
        let distances = piece.places.map(|earlier| place - earlier);
        let weights = distances.map(|distance| 1.0 - distance / zone);
        // ∫ (last + load_slope·v)(a₁ + (a₀ − a₁)v) e^{−…v} dv, v backwards from the end.
        let product = |[before, after]: [f64; 2]| {
            let slope = before - after;
            scale * (last * after * n0 + (last * slope + load_slope * after) * n1 + load_slope * slope * n2)
        };
        let bent = scale * piece.bend * (last * (n1 - n2) + load_slope * (n2 - n3));
        Held { exposure: scale * (last * n0 + load_slope * n1), lag: product(distances) - bent, weighted: product(weights) + bent / zone }
    }

    /// The sums after a step that is not taken.
    pub(crate) fn after(&mut self, step: &Step) -> Sums {
        let (clock, place, zone) = (self.clock.time() + step.duration, self.place + step.advance, step.zone);
        let exchanged = self.exchanged(place - zone);
        let mut sums = Sums { memory: 0.0, exposure: 0.0, lag: 0.0, growth: 0.0 };
        let [first, last] = step.loads;
        for (index, term) in self.terms.iter().enumerate() {
            let (decay, [n0, n1, n2, n3]) = fading_moments(term.rate * step.duration);
            let gain = term.gain * step.duration;
            let z = term.rate * step.duration;
            let old = faded(self.exposure[index], z, decay, n0);
            let behind = faded(self.lag[index], z, decay, n0);
            let own = gain * (last * n0 + (first - last) * n1);
            let mut exposure = old + own;
            let bent = gain * step.bend * (last * (n1 - n2) + (first - last) * (n2 - n3));
            let mut lag = behind + step.advance * (old + gain * (last * n1 + (first - last) * n2)) - bent;
            // 1 − Δx·v/z is the weight of the step itself.
            let advance = step.advance / zone;
            let mut memory = (old - behind / zone - advance * old)
                + gain * (last * n0 + (first - last - last * advance) * n1 - (first - last) * advance * n2)
                + bent / zone;
            let mut lack = self.lack_after(index, step, decay, n0);
            for (sign, piece) in &exchanged {
                let held = Self::held(*term, index, piece, clock, place, zone);
                exposure += sign * held.exposure;
                lag += sign * held.lag;
                memory += sign * held.weighted;
                lack -= sign * term.rate * held.exposure;
            }
            sums.memory += memory;
            sums.exposure += exposure;
            sums.lag += lag;
            sums.growth += lack + term.rate * lag / zone;
        }
        self.kernel_evaluations += (self.terms.len() * (1 + exchanged.len())) as u64;
        sums
    }

    /// What ΣP_j gains after a step when the tip entered the window not on the parabola of its piece but on the cubic with the speeds of its
    /// ends. The window ends anywhere in a piece, and the parabola is off by the cube of the piece there: a part of the speed's error that would
    /// not fall in proportion from run to run. (The closure itself has no weight at the end of the window.)
    pub(crate) fn exposure_beyond_parabola(&self, step: &Step) -> f64 {
        let back = self.place + step.advance - step.zone;
        let after = self.pieces.partition_point(|piece| piece.places[1] <= back);
        let Some(piece) = self.pieces.get(after).filter(|piece| piece.places[0] < back) else { return 0.0 };
        let Some(speeds) = piece.speeds else { return 0.0 };
        let [from, to] = piece.places;
        let (wanted, passed) = ((back - from) / (to - from), piece.when(back));
        // Monotone: Fritsch and Carlson (1980).
        let [first, last] = speeds.map(|speed| (speed * piece.duration / (to - from)).clamp(0.0, 3.0));
        let place = |u: f64| u * u * (3.0 - 2.0 * u) + u * (1.0 - u) * ((1.0 - u) * first - u * last);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if place(middle) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        let earlier = (passed - 0.5 * (low + high)) * piece.duration;
        let ago = self.clock.time() + step.duration - (piece.end - (1.0 - passed) * piece.duration);
        let load = piece.loads[0] + passed * (piece.loads[1] - piece.loads[0]);
        self.terms.iter().map(|term| term.gain * (-term.rate * ago).exp()).sum::<f64>() * load * earlier
    }

    /// ∂(zΣN_j)/∂v: how the rate at which ΣM_j grows follows the slope with which the step's own way ends, over the exposure.
    pub(crate) fn rate_by_last_slope(&self, step: &Step) -> f64 {
        self.terms.iter().map(|term| term.rate * Self::by_last_slope(term, step)).sum()
    }

    /// −∂(zΣM_j)/∂v of the same slope: over the exposure, how much further the closure would have the tip.
    pub(crate) fn place_by_last_slope(&self, step: &Step) -> f64 {
        self.terms.iter().map(|term| Self::by_last_slope(term, step)).sum()
    }

    /// x₁ + εσ²(σ − 1), σ = 1 − v, has ε more slope at its end: δM_j = −(εg_jΔt/z) ∫ e^{−l_jΔt v} κ v(1 − v)² dv, where the load is that at the end
    /// to the order that
    /// counts.
    fn by_last_slope(term: &Term, step: &Step) -> f64 {
        let (_, [_, n1, n2, n3]) = fading_moments(term.rate * step.duration);
        step.loads[1] * term.gain * step.duration * step.duration * (n1 - 2.0 * n2 + n3)
    }

    /// Each term's M_j here and now, in a zone.
    pub(crate) fn memories_in(&self, zone: f64) -> Vec<f64> {
        let exchanged = self.exchanged(self.place - zone);
        let of_term = |(index, term): (usize, &Term)| {
            let change =
                |(sign, piece): &(f64, Piece)| sign * Self::held(*term, index, piece, self.clock.time(), self.place, zone).weighted;
            self.exposure[index] - self.lag[index] / zone + exchanged.iter().map(change).sum::<f64>()
        };
        self.terms.iter().enumerate().map(of_term).collect()
    }

    /// Q_j after a step: by parts, so that the difference of two large numbers is never formed.
    fn lack_after(&self, index: usize, step: &Step, decay: f64, n0: f64) -> f64 {
        let Some(term) = self.terms.get(index) else { return 0.0 };
        let [first, last] = step.loads;
        let lack = self.lack[index] + term.gain * (first - self.load);
        faded(lack, term.rate * step.duration, decay, n0) + term.gain * (last - first) * n0
    }

    /// Takes a step; what is then behind the window goes, and what is again in it comes back.
    pub(crate) fn take(&mut self, step: &Step, speeds: Option<[f64; 2]>) {
        let [first, last] = step.loads;
        for (index, term) in self.terms.iter().enumerate() {
            let (decay, [n0, n1, n2, n3]) = fading_moments(term.rate * step.duration);
            let gain = term.gain * step.duration;
            let z = term.rate * step.duration;
            let old = faded(self.exposure[index], z, decay, n0);
            self.lack[index] = self.lack_after(index, step, decay, n0);
            let bent = gain * step.bend * (last * (n1 - n2) + (first - last) * (n2 - n3));
            self.lag[index] = faded(self.lag[index], z, decay, n0) + step.advance * (old + gain * (last * n1 + (first - last) * n2)) - bent;
            self.exposure[index] = old + gain * (last * n0 + (first - last) * n1);
        }
        self.kernel_evaluations += self.terms.len() as u64;
        let from = self.place;
        self.load = last;
        self.zone = step.zone;
        self.clock.pass(step.duration);
        self.place += step.advance;
        if step.duration > 0.0 {
            self.remember(step, from, speeds);
        }
        let back = self.place - self.zone;
        let mut rest_left = false;
        while let Some(piece) = self.pieces.get(self.first).filter(|piece| piece.places[1] <= back + SAME_PLACE).cloned() {
            rest_left |= piece.rested.is_some();
            self.exchange(&piece, -1.0);
            self.left_since_sum += 1;
            self.first += 1;
        }
        let before = |first: usize| first.checked_sub(1);
        while let Some((index, piece)) = before(self.first)
            .and_then(|index| Some((index, self.pieces.get(index)?.clone())))
            .filter(|(_, piece)| piece.places[1] > back + SAME_PLACE)
        {
            self.exchange(&piece, 1.0);
            self.first = index;
        }
        // The greatest zone is 1.
        while self.first > 0 && self.pieces.front().is_some_and(|piece| piece.places[1] <= self.place - 1.0 + SAME_PLACE) {
            self.pieces.pop_front();
            self.first -= 1;
        }
        if rest_left || self.left_since_sum > self.pieces.len() - self.first {
            self.sum_anew();
        }
    }

    /// Adds a whole piece to the sums, or subtracts it.
    fn exchange(&mut self, piece: &Piece, sign: f64) {
        for (index, term) in self.terms.iter().enumerate() {
            let held = Self::held(*term, index, piece, self.clock.time(), self.place, self.zone);
            self.exposure[index] += sign * held.exposure;
            self.lag[index] += sign * held.lag;
            self.lack[index] -= sign * term.rate * held.exposure;
        }
        self.kernel_evaluations += self.terms.len() as u64;
    }

    /// Adds the step to the pieces; a rest joins a rest at the same place.
    fn remember(&mut self, step: &Step, from: f64, speeds: Option<[f64; 2]>) {
        let mut piece = Piece {
            end: self.clock.time(),
            duration: step.duration,
            places: [from, self.place],
            bend: step.bend,
            loads: step.loads,
            speeds,
            rested: None,
        };
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
                    let (decay, [n0, n1, ..]) = fading_moments(term.rate * step.duration);
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

    /// The time since the last [`Memory::rebase`].
    pub(crate) const fn time(&self) -> f64 {
        self.clock.time()
    }

    /// Lets time pass whose history is replaced afterwards.
    pub(crate) fn wait(&mut self, duration: f64) {
        self.clock.pass(duration);
    }

    /// κ at the last step.
    pub(crate) const fn load(&self) -> f64 {
        self.load
    }

    /// How many pieces are held.
    pub(crate) fn pieces_held(&self) -> usize {
        self.pieces.len()
    }

    /// P, R and Q from the pieces in the window, forwards: no subtraction.
    fn sum_anew(&mut self) {
        self.left_since_sum = 0;
        self.exposure.fill(0.0);
        self.lag.fill(0.0);
        self.lack.fill(0.0);
        let load_now = std::mem::replace(&mut self.load, 0.0);
        let mut last_place = self.pieces.get(self.first).map_or(self.place, |piece| piece.places[0]);
        let pieces = std::mem::take(&mut self.pieces);
        for piece in pieces.range(self.first..) {
            self.jump(piece.places[0] - last_place);
            let [first, last] = piece.loads;
            let advance = piece.places[1] - piece.places[0];
            let step = Step { duration: piece.duration, advance, bend: piece.bend, loads: piece.loads, zone: self.zone };
            for (index, term) in self.terms.iter().enumerate() {
                let (decay, [n0, n1, n2, n3]) = fading_moments(term.rate * piece.duration);
                let gain = term.gain * piece.duration;
                let z = term.rate * piece.duration;
                let old = faded(self.exposure[index], z, decay, n0);
                if let Some([rested, lack]) = piece.rested.as_ref().and_then(|values| values.get(index)) {
                    self.lack[index] = lack - term.rate * old;
                    self.lag[index] = faded(self.lag[index], z, decay, n0);
                    self.exposure[index] = old + rested;
                    continue;
                }
                self.lack[index] = self.lack_after(index, &step, decay, n0);
                let bent = gain * piece.bend * (last * (n1 - n2) + (first - last) * (n2 - n3));
                self.lag[index] = faded(self.lag[index], z, decay, n0) + advance * (old + gain * (last * n1 + (first - last) * n2)) - bent;
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
        self.kernel_evaluations += (self.terms.len() * (self.pieces.len() - self.first)) as u64;
    }

    /// Moves the tip in no time.
    fn jump(&mut self, advance: f64) {
        for (lag, exposure) in self.lag.iter_mut().zip(&self.exposure) {
            *lag += advance * exposure;
        }
    }

    /// Sets clock and place back near zero, so that long histories lose no digits; returns by how much.
    pub(crate) fn rebase(&mut self) -> [f64; 2] {
        let shift = [self.clock.time(), self.place.floor()];
        for piece in &mut self.pieces {
            piece.end -= shift[0];
            piece.places = piece.places.map(|place| place - shift[1]);
        }
        self.clock.time = 0.0;
        self.place -= shift[1];
        shift
    }

    /// Replaces the history: the tip came here through places at these distances behind it (falling to zero), so long ago (s), under
    /// these loads, steadily gaining speed.
    pub(crate) fn replace(&mut self, way: &[[f64; 3]], acceleration: f64) {
        self.pieces.clear();
        self.first = 0;
        for pair in way.windows(2) {
            let [[from, earlier, first], [to, later, last]] = pair else { continue };
            if earlier > later {
                self.pieces.push_back(Piece {
                    end: self.clock.time() - later,
                    duration: earlier - later,
                    places: [self.place - from, self.place - to],
                    bend: (-0.5 * acceleration * (earlier - later) * (earlier - later)).clamp(to - from, from - to),
                    loads: [*first, *last],
                    speeds: None,
                    rested: None,
                });
                self.load = *last;
            }
        }
        let back = self.place - self.zone;
        self.first = self.pieces.iter().take_while(|piece| piece.places[1] <= back + SAME_PLACE).count();
        self.most_pieces = self.most_pieces.max(self.pieces.len());
        self.sum_anew();
    }
}
