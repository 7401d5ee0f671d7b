//! How the edge goes through a stretch of time while Δ(x) is given: one way at a time, until it turns, is lost, or the time is over.
//!
//! Each chain knows when the edge passes it: in contact when its own S falls through zero, free when it rises through zero. No chain waits for another one.

use super::drive::{Drive, Moment};
use super::grid::{GRID, NODES, Nodal};
use super::line::{Line, NARROWEST, Stretch};
use crate::refusal::Refusal;

/// S that rounding leaves, over the depth.
const ROUNDING: f64 = 2e-15;
/// Instants looked at evenly, and halvings of the time towards its start.
const EVEN: u32 = 8;
const MOST_HALVINGS: i32 = 70;
/// Part of the shortest relaxation time below which nothing turns by itself.
const SHORTEST: f64 = 0.05;
/// Iterations of a bracketed root.
const MOST_ITERATIONS: u32 = 100;

/// What ended a stretch of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ended {
    /// It is over.
    Whole,
    /// The edge turned.
    Turned,
    /// The contact was lost, at this instant.
    Lost,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Inwards,
    Outwards,
}

impl Line<'_> {
    fn noise(&self) -> f64 {
        ROUNDING * self.depth
    }

    /// S at the edge after a moment, by the chains inside and outside; none on a side without chains.
    fn at_edge(&self, moment: &Moment) -> (Option<f64>, Option<f64>) {
        let inside = self.contact.last().map(|stretch| self.pressed(stretch, moment)[NODES - 1]);
        let a = self.radius();
        let outside = match self.free.first() {
            Some(stretch) => Some(self.opened(stretch, moment)[0]),
            None if a < self.profile.rim() => Some(moment.depth - self.profile.line(a)),
            None => None,
        };
        (inside, outside)
    }

    /// Where the edge is after a moment of going one way; none where an edge that goes inwards has passed the axis.
    fn edge_after(&self, moment: &Moment, way: Way) -> Result<Option<f64>, Refusal> {
        match way {
            Way::Inwards => {
                for stretch in self.contact.iter().rev() {
                    let pressed = self.pressed(stretch, moment);
                    if pressed[0] >= 0.0 {
                        if pressed[NODES - 1] >= 0.0 {
                            return Ok(Some(stretch.high));
                        }
                        return Ok(Some(stretch.low + stretch.width() * GRID.falling_zero(&pressed)));
                    }
                }
                Ok(None)
            }
            Way::Outwards => {
                let mut reached = self.radius();
                for stretch in &self.free {
                    let opened = self.opened(stretch, moment);
                    if opened[NODES - 1] < 0.0 {
                        if opened[0] < 0.0 {
                            return Ok(Some(reached));
                        }
                        return Ok(Some(stretch.low + stretch.width() * GRID.falling_zero(&opened)));
                    }
                    reached = stretch.high;
                }
                let rim = self.profile.rim();
                if reached >= rim {
                    return Ok(Some(rim));
                }
                self.virgin_edge(moment.depth, reached).map(Some)
            }
        }
    }

    /// dS/dt at the edge, a moment after which it is at a place.
    fn rate_at(&self, place: f64, moment: &Moment, way: Way) -> f64 {
        let terms = self.chain.terms();
        let mut state = vec![0.0; terms];
        match way {
            Way::Inwards => {
                let Some(stretch) = self.contact.iter().rev().find(|stretch| stretch.low <= place) else { return moment.rate };
                stretch.at(place, &mut state);
                let branches = self.chain.maxwell.iter().zip(&state).zip(moment.kept.iter().zip(&moment.gained));
                let relaxing: f64 =
                    branches.map(|((&(modulus, rho), u), (kept, gained))| modulus / self.chain.glassy * (u * kept + gained) / rho).sum();
                moment.rate - relaxing
            }
            Way::Outwards => {
                let Some(stretch) = self.free.iter().find(|stretch| stretch.high >= place) else { return moment.rate };
                stretch.at(place, &mut state);
                let elements = self.chain.voigt.iter().zip(&state).zip(&moment.recovered);
                moment.rate + elements.map(|((&(rate, _), e), kept)| rate * e * kept).sum::<f64>()
            }
        }
    }

    /// Instants at which the edge is looked at.
    fn looked_at(&self, drive: &Drive) -> Vec<f64> {
        let whole = drive.duration;
        let even = (1..=EVEN).map(|k| whole * f64::from(k) / f64::from(EVEN));
        let shortest = SHORTEST * self.chain.shortest_time();
        let halved = (4..MOST_HALVINGS).map(|k| whole * 0.5_f64.powi(k)).take_while(|time| *time > shortest);
        let mut times: Vec<f64> = halved.chain(even).collect();
        times.sort_by(f64::total_cmp);
        times
    }

    /// Goes on along a drive, as far as the edge goes one way: how far, and why it ended there.
    pub(super) fn go(&mut self, drive: &Drive) -> Result<(f64, Ended), Refusal> {
        self.depth = self.depth.max(drive.start.abs()).max(drive.end().abs());
        let mut moment = Moment::default();
        let mut way: Option<Way> = None;
        let mut before = 0.0;
        for time in self.looked_at(drive) {
            moment.set(self.chain, drive, time);
            moment.set_free(self.chain, drive, time);
            if way.is_none() {
                let (inside, outside) = self.at_edge(&moment);
                let (inwards, outwards) = (inside.map_or(0.0, |s| -s), outside.unwrap_or(0.0));
                if inwards.max(outwards) <= self.noise() {
                    before = time;
                    continue;
                }
                way = Some(if inwards > outwards { Way::Inwards } else { Way::Outwards });
            }
            let Some(heading) = way else { continue };
            let place = self.edge_after(&moment, heading)?;
            // Less than rounding in all the time since it was last looked at is no turn.
            let least = 8.0 * self.noise() / (time - before);
            let wrong = |rate: f64| match heading {
                Way::Inwards => rate > least,
                Way::Outwards => rate < -least,
            };
            let turned = match place {
                None => false,
                Some(place) if heading == Way::Outwards && place >= self.profile.rim() => false,
                Some(place) => wrong(self.rate_at(place, &moment, heading)),
            };
            if turned {
                let turn = self.turn(drive, heading, (before, time))?;
                if turn > 0.0 {
                    let drive = drive.until(turn);
                    self.pass(&drive, heading)?;
                    return Ok((turn, Ended::Turned));
                }
                // It turned at once: it goes the other way.
                way = Some(if heading == Way::Inwards { Way::Outwards } else { Way::Inwards });
                before = time;
                continue;
            }
            if place.is_none() {
                // The axis is the last to lose contact.
                let lost = self.lost_at(drive, time);
                if lost < drive.duration {
                    // What has flowed to the end holds nothing: it is lost before any time has gone by.
                    if lost > 0.0 {
                        self.pass(&drive.until(lost), heading)?;
                    }
                    self.release_all();
                    return Ok((lost, Ended::Lost));
                }
                self.pass(drive, heading)?;
                self.release_all();
                return Ok((drive.duration, Ended::Lost));
            }
            before = time;
        }
        match way {
            Some(way) => self.pass(drive, way)?,
            None => self.pass_nothing(drive),
        }
        Ok((drive.duration, Ended::Whole))
    }

    /// When the chain on the axis leaves contact, at most at a time.
    fn lost_at(&self, drive: &Drive, by: f64) -> f64 {
        let mut state = vec![0.0; self.chain.terms()];
        let Some(stretch) = self.contact.first() else { return 0.0 };
        stretch.at(stretch.low, &mut state);
        let mut moment = Moment::default();
        leaving(self, drive, stretch.heights[0], &state, by, by, &mut moment)
    }

    /// When, between two times, the edge turns: where dS/dt at the edge vanishes.
    fn turn(&self, drive: &Drive, way: Way, (from, to): (f64, f64)) -> Result<f64, Refusal> {
        let mut moment = Moment::default();
        let mut rate = |time: f64| -> Result<f64, Refusal> {
            moment.set(self.chain, drive, time);
            moment.set_free(self.chain, drive, time);
            let place = match self.edge_after(&moment, way)? {
                Some(place) => match way {
                    Way::Inwards => place.min(self.radius()),
                    Way::Outwards => place.max(self.radius()),
                },
                None => 0.0,
            };
            let rate = self.rate_at(place, &moment, way);
            Ok(if way == Way::Inwards { -rate } else { rate })
        };
        let (mut low, mut high) = (from, to);
        let (mut good, mut bad) = (rate(low)?, rate(high)?);
        if good <= 0.0 {
            return Ok(from);
        }
        if bad >= 0.0 {
            return Ok(to);
        }
        let mut side = 0;
        for _ in 0..MOST_ITERATIONS {
            let chord = low + (high - low) * good / (good - bad);
            let time = if chord > low && chord < high { chord } else { 0.5 * (low + high) };
            let value = rate(time)?;
            if value >= 0.0 {
                (low, good) = (time, value);
                if side == 1 {
                    bad *= 0.5;
                }
                side = 1;
            } else {
                (high, bad) = (time, value);
                if side == -1 {
                    good *= 0.5;
                }
                side = -1;
            }
            if high - low <= 4.0 * f64::EPSILON * high || value == 0.0 {
                break;
            }
        }
        Ok(low)
    }

    /// A time in which the edge rests.
    pub(super) fn pass_nothing(&mut self, drive: &Drive) {
        let moment = Moment::new(self.chain, drive, drive.duration);
        self.age(&moment);
        self.went_to(moment.depth);
    }

    /// A whole drive along which the edge goes one way.
    fn pass(&mut self, drive: &Drive, way: Way) -> Result<(), Refusal> {
        let end = Moment::new(self.chain, drive, drive.duration);
        let this = self.without_stretches();
        let (mut moment, mut scratch, mut guess) = (Moment::default(), Vec::new(), 0.0);
        match way {
            Way::Inwards => self.recede(&end, &mut |height, state| {
                let time = leaving(&this, drive, height, state, drive.duration, guess, &mut moment);
                guess = time;
                for ((u, kept), gained) in state.iter_mut().zip(&moment.kept).zip(&moment.gained) {
                    *u = *u * kept + gained;
                }
                this.chain.released(moment.depth - height, state, &mut scratch);
                for (e, &(rate, _)) in state.iter_mut().zip(&this.chain.voigt) {
                    *e *= (-rate * (drive.duration - time)).exp();
                }
            }),
            Way::Outwards => self.advance(&end, &mut |height, state| {
                let time = touching(&this, drive, height, state, guess, &mut moment);
                guess = time;
                for (e, kept) in state.iter_mut().zip(&moment.recovered) {
                    *e *= kept;
                }
                this.chain.touched(moment.depth - height, state, &mut scratch);
                moment.set(this.chain, drive, time);
                let passed = moment.gained.iter().zip(&this.chain.maxwell).zip(&end.gained);
                for (u, ((gained, &(_, rho)), whole)) in state.iter_mut().zip(passed) {
                    let kept = (-(drive.duration - time) / rho).exp();
                    *u = *u * kept + (whole - gained * kept);
                }
            })?,
        }
        self.went_to(end.depth);
        self.tidy(false);
        Ok(())
    }

    /// A step of the penetration, at once: whether the contact was lost.
    pub(super) fn leap(&mut self, to: f64) -> Result<bool, Refusal> {
        let had = self.radius() > 0.0;
        let before = self.penetration;
        self.depth = self.depth.max(to.abs());
        let terms = self.chain.terms();
        // No dashpot moves: every spring takes the step.
        let end = Moment {
            depth: to,
            kept: vec![1.0; terms],
            gained: vec![to - before; terms],
            recovered: vec![1.0; terms],
            ..Moment::default()
        };
        let (chain, mut scratch) = (self.chain, Vec::new());
        if to < before {
            self.recede(&end, &mut |height, state| chain.released(before - height, state, &mut scratch));
        } else {
            self.advance(&end, &mut |height, state| chain.touched(to - height, state, &mut scratch))?;
        }
        self.went_to(to);
        self.tidy(false);
        Ok(had && self.radius() == 0.0)
    }

    /// The edge goes inwards: `released` takes a chain with its height from u_i at the start to e_j at the end.
    fn recede(&mut self, end: &Moment, released: &mut dyn FnMut(f64, &mut [f64])) {
        let mut freed: Vec<Stretch> = Vec::new();
        let mut cut = None;
        while let Some(stretch) = self.contact.pop() {
            let place = snapped(&stretch, zero_in(&stretch, &self.pressed(&stretch, end)));
            if place >= stretch.high {
                self.contact.push(stretch);
                break;
            }
            let mut parts = Vec::new();
            self.build(
                (place, stretch.high),
                false,
                &mut |s, height, state| {
                    stretch.at(s, state);
                    released(height, state);
                },
                &mut parts,
            );
            parts.append(&mut freed);
            freed = parts;
            if place > stretch.low {
                cut = Some((stretch, place));
                break;
            }
        }
        if let Some((whole, place)) = cut {
            let mut parts = Vec::new();
            self.build((whole.low, place), true, &mut |s, _, state| whole.at(s, state), &mut parts);
            self.contact.append(&mut parts);
        }
        self.age(end);
        freed.append(&mut self.free);
        self.free = freed;
    }

    /// The edge goes outwards: `touched` takes a chain with its height from e_j at the start to u_i at the end.
    fn advance(&mut self, end: &Moment, touched: &mut dyn FnMut(f64, &mut [f64])) -> Result<(), Refusal> {
        let (mut gained, mut rest): (Vec<Stretch>, Vec<Stretch>) = (Vec::new(), Vec::new());
        let (mut reached, mut stopped) = (self.radius(), false);
        for stretch in std::mem::take(&mut self.free) {
            if stopped {
                rest.push(stretch);
                continue;
            }
            let place = snapped(&stretch, zero_in(&stretch, &self.opened(&stretch, end)));
            if place > stretch.low {
                self.build(
                    (stretch.low, place),
                    true,
                    &mut |s, height, state| {
                        stretch.at(s, state);
                        touched(height, state);
                    },
                    &mut gained,
                );
                reached = place;
            }
            stopped = place < stretch.high;
            if stopped && place > stretch.low {
                self.build((place, stretch.high), false, &mut |s, _, state| stretch.at(s, state), &mut rest);
            } else if stopped {
                rest.push(stretch);
            }
        }
        self.free = rest;
        if !stopped {
            let edge = self.virgin_edge(end.depth, reached)?;
            if edge - reached > NARROWEST * edge {
                self.build(
                    (reached, edge),
                    true,
                    &mut |_, height, state| {
                        state.fill(0.0);
                        touched(height, state);
                    },
                    &mut gained,
                );
            }
        }
        self.age(end);
        self.contact.append(&mut gained);
        Ok(())
    }

    /// What rounding has left in contact when it was lost.
    pub(super) fn release_all(&mut self) {
        let depth = self.penetration;
        let chain = self.chain;
        let mut freed = Vec::new();
        let mut scratch = Vec::new();
        for stretch in std::mem::take(&mut self.contact) {
            self.build(
                (stretch.low, stretch.high),
                false,
                &mut |s, height, state| {
                    stretch.at(s, state);
                    chain.released(depth - height, state, &mut scratch);
                },
                &mut freed,
            );
        }
        freed.append(&mut self.free);
        self.free = freed;
    }

    fn without_stretches(&self) -> Self {
        Self { contact: Vec::new(), free: Vec::new(), ..*self }
    }
}

/// Where S passes zero in a stretch; an end where it does not.
fn zero_in(stretch: &Stretch, values: &Nodal) -> f64 {
    if values[NODES - 1] >= 0.0 {
        stretch.high
    } else if values[0] < 0.0 {
        stretch.low
    } else {
        stretch.low + stretch.width() * GRID.falling_zero(values)
    }
}

/// The same, at an end where it is next to one.
fn snapped(stretch: &Stretch, place: f64) -> f64 {
    let near = NARROWEST * stretch.high;
    if place - stretch.low <= near {
        stretch.low
    } else if stretch.high - place <= near {
        stretch.high
    } else {
        place
    }
}

/// When a chain in contact with u_i (now) leaves: `moment` is then set to it.
fn leaving(line: &Line<'_>, drive: &Drive, height: f64, state: &[f64], by: f64, guess: f64, moment: &mut Moment) -> f64 {
    let chain = line.chain;
    let soft = chain.relaxed / chain.glassy;
    let mut pressing = |time: f64, moment: &mut Moment| {
        moment.set(chain, drive, time);
        let (mut value, mut slope) = (soft * (moment.depth - height), moment.rate);
        for ((&(modulus, rho), u), (kept, gained)) in chain.maxwell.iter().zip(state).zip(moment.kept.iter().zip(&moment.gained)) {
            let share = modulus / chain.glassy * (u * kept + gained);
            value += share;
            slope -= share / rho;
        }
        (-value, -slope)
    };
    rising_zero(by, guess, moment, &mut pressing)
}

/// When a free chain with e_j (now) touches: `moment` is then set to it.
fn touching(line: &Line<'_>, drive: &Drive, height: f64, state: &[f64], guess: f64, moment: &mut Moment) -> f64 {
    let chain = line.chain;
    let mut overlap = |time: f64, moment: &mut Moment| {
        moment.set_free(chain, drive, time);
        let (mut value, mut slope) = (moment.depth - height, moment.rate);
        for ((&(rate, _), e), kept) in chain.voigt.iter().zip(state).zip(&moment.recovered) {
            value -= e * kept;
            slope += rate * e * kept;
        }
        (value, slope)
    };
    rising_zero(drive.duration, guess, moment, &mut overlap)
}

/// The time of 0…`by` at which a function rises through zero, by Newton's steps within a bracket.
fn rising_zero(by: f64, guess: f64, moment: &mut Moment, function: &mut dyn FnMut(f64, &mut Moment) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (0.0, by);
    let mut time = if guess > 0.0 && guess < by { guess } else { by };
    let (mut step, mut last_step) = (by, by);
    for _ in 0..MOST_ITERATIONS {
        let (value, slope) = function(time, moment);
        if value == 0.0 {
            return time;
        }
        if value > 0.0 {
            high = time;
        } else {
            low = time;
        }
        if time >= by && value < 0.0 {
            // Rounding alone keeps it from being passed.
            return by;
        }
        if high - low <= f64::EPSILON * high {
            break;
        }
        let newton = time - value / slope;
        // Where Newton's steps do not halve, the bracket is.
        let fine = newton > low && newton < high && (newton - time).abs() < 0.5 * last_step;
        let next = if fine {
            newton
        } else if low == 0.0 && high > 0.0 {
            // Times may be far shorter than the stretch.
            0.1 * high
        } else {
            0.5 * (low + high)
        };
        last_step = step;
        step = (next - time).abs();
        if step <= 0.5 * f64::EPSILON * time {
            break;
        }
        time = next;
        if high <= 1e-25 * by {
            time = 0.0;
            function(time, moment);
            break;
        }
    }
    if (moment.time - time).abs() > 0.0 {
        function(time, moment);
    }
    time
}
