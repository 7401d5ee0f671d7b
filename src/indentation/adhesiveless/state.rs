//! A line looked at: what presses where, what must not be negative, and how two lines differ.

use super::drive::Drive;
use super::grid::{GRID, NODES};
use super::line::Line;
use super::moment::Moment;
use crate::refusal::Refusal;

/// What a point of the path tells of a line.
pub(super) struct Look {
    pub(super) penetration: f64,
    pub(super) force: f64,
    pub(super) radius: f64,
    /// [`Line::least`], where it is looked at.
    pub(super) least: Option<(f64, f64)>,
    /// [`Line::slope_at_edge`].
    pub(super) slope: f64,
    /// [`Line::energies`], where they are asked for.
    pub(super) energies: Option<[f64; 2]>,
}

impl Look {
    pub(super) fn at(line: &Line<'_>, closely: bool, energies: bool) -> Self {
        Self {
            penetration: line.penetration,
            force: line.force(),
            radius: line.radius(),
            least: closely.then(|| line.least()),
            slope: line.slope_at_edge(),
            energies: energies.then(|| line.energies()),
        }
    }
}

/// Part of an interval before its edge over which S is seen to fall.
const CLOSE: f64 = 1e-3;

impl Line<'_> {
    /// What is still in contact a time along a drive in which the edge goes inwards. S falls as steeply outside of it: at the edge a chain in contact and a
    /// free one go on alike.
    pub(super) fn receded(&self, drive: &Drive, time: f64) -> Look {
        let mut moment = Moment::default();
        moment.set(self.chain, drive, time);
        let (mut sum, mut radius, mut slope) = (0.0, 0.0, self.profile.line_slope(0.0));
        for interval in &self.contact {
            let pressed = self.pressed(interval, &moment);
            // What has relaxed presses no more, and is in contact.
            if pressed[0] < 0.0 {
                break;
            }
            let whole = pressed[NODES - 1] >= 0.0;
            let xi = if whole { 1.0 } else { GRID.falling_zero(&pressed) };
            let part = if whole { 1.0 } else { GRID.part(xi) };
            sum += interval.width() * if whole { GRID.integral(&pressed) } else { GRID.integral_to(xi, &pressed) };
            radius = if whole { interval.high } else { interval.low + interval.width() * part };
            let inner = GRID.parts.iter().rposition(|other| *other < part * (1.0 - CLOSE)).unwrap_or(0);
            let edge = if whole { pressed[NODES - 1] } else { 0.0 };
            if part > GRID.parts[inner] {
                slope = (pressed[inner] - edge) / (interval.width() * (part - GRID.parts[inner]));
            }
            if !whole {
                break;
            }
        }
        let force = 2.0 * self.chain.glassy * sum;
        Look { penetration: moment.depth, force, radius, least: None, slope, energies: None }
    }

    /// S at a place now.
    pub(super) fn pressing_at(&self, place: f64) -> f64 {
        let mut state = vec![0.0; self.chain.terms()];
        if let Some(interval) = self.contact.iter().find(|interval| place <= interval.high) {
            interval.at(place, &mut state);
            let soft = self.chain.relaxed / self.chain.glassy * (self.penetration - self.profile.line(place));
            return soft + self.chain.maxwell.iter().zip(&state).map(|((modulus, _), u)| modulus / self.chain.glassy * u).sum::<f64>();
        }
        if let Some(interval) = self.free.iter().find(|interval| place <= interval.high) {
            interval.at(place, &mut state);
        }
        self.penetration - self.profile.line(place) - state.iter().sum::<f64>()
    }

    /// A relaxed contact at a penetration: no spring of a branch holds anything.
    pub(super) fn rested(&mut self, penetration: f64) -> Result<(), Refusal> {
        self.went_to(penetration);
        let edge = self.virgin_edge(penetration, 0.0)?;
        let mut intervals = Vec::new();
        if edge > 0.0 && penetration > 0.0 {
            self.build((0.0, edge), true, &mut |_, _, state| state.fill(0.0), &mut intervals);
        }
        self.contact = intervals;
        Ok(())
    }

    /// All of a punch is touched, at the penetration of now.
    pub(super) fn touch_rim(&mut self) {
        let (rim, depth, chain) = (self.profile.rim(), self.penetration, self.chain);
        let (free, mut scratch, mut intervals) = (std::mem::take(&mut self.free), Vec::new(), Vec::new());
        self.build(
            (0.0, rim),
            true,
            &mut |place, height, state| {
                match free.iter().find(|interval| place <= interval.high) {
                    Some(interval) => interval.at(place, state),
                    None => state.fill(0.0),
                }
                chain.touched(depth - height, state, &mut scratch);
            },
            &mut intervals,
        );
        self.contact = intervals;
    }

    /// The least of what must not be negative, Q/E∞* inside and D outside (m), and what Q leaves at the edge, over the depth.
    pub(super) fn least(&self) -> (f64, f64) {
        let mut least = f64::INFINITY;
        let mut at_edge = 0.0;
        for interval in &self.contact {
            let load = self.load(interval);
            least = load.iter().fold(least, |least: f64, q| least.min(q / self.chain.glassy));
            at_edge = load[NODES - 1] / self.chain.glassy;
        }
        if self.radius() >= self.profile.rim() {
            // A rim may be pressed.
            at_edge = 0.0;
        }
        for interval in &self.free {
            for (k, height) in interval.heights.iter().enumerate() {
                let surface: f64 = (0..self.chain.terms()).map(|index| interval.term(index).get(k).copied().unwrap_or(0.0)).sum();
                least = least.min(surface - (self.penetration - height));
            }
        }
        if self.free.is_empty() && self.radius() < self.profile.rim() {
            least = least.min(self.profile.line(self.radius()) - self.penetration);
        }
        let depth = if self.depth > 0.0 { self.depth } else { 1.0 };
        (least, at_edge / depth)
    }

    /// How steeply S falls at the edge, on the side where it falls less.
    pub(super) fn slope_at_edge(&self) -> f64 {
        let falls = |values: [f64; 2], places: [f64; 2]| (values[0] - values[1]) / (places[1] - places[0]);
        let virgin = self.profile.line_slope(self.radius());
        let inside = self.contact.last().map_or(virgin, |interval| {
            let load = self.load(interval).map(|load| load / self.chain.glassy);
            falls([load[NODES - 2], load[NODES - 1]], [interval.place(NODES - 2), interval.high])
        });
        let outside = self.free.first().map_or(virgin, |interval| {
            let surface = interval.weighted(-1.0, std::iter::repeat_n(-1.0, self.chain.terms()));
            falls([surface[0], surface[1]], [interval.low, interval.place(1)])
        });
        inside.min(outside)
    }

    /// The largest difference of two lines in any strain of a dashpot (m).
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let terms = self.chain.terms();
        let (mut own, mut theirs, mut scratch) = (vec![0.0; terms], vec![0.0; terms], Vec::new());
        let mut most = 0.0_f64;
        let dashpots = |line: &Self, place: f64, state: &mut [f64], scratch: &mut Vec<f64>| {
            if let Some(interval) = line.contact.iter().find(|interval| place <= interval.high) {
                interval.at(place, state);
                let under = line.penetration - line.profile.line(place);
                for u in state.iter_mut() {
                    *u = under - *u;
                }
            } else {
                match line.free.iter().find(|interval| place <= interval.high) {
                    Some(interval) => interval.at(place, state),
                    None => state.fill(0.0),
                }
                line.chain.touched(0.0, state, scratch);
                for u in state.iter_mut() {
                    *u = -*u;
                }
            }
        };
        for (one, another) in [(self, other), (other, self)] {
            for interval in one.contact.iter().chain(&one.free) {
                for k in 0..NODES {
                    let place = interval.place(k);
                    dashpots(one, place, &mut own, &mut scratch);
                    dashpots(another, place, &mut theirs, &mut scratch);
                    most = own.iter().zip(&theirs).fold(most, |most, (own, theirs)| most.max((own - theirs).abs()));
                }
            }
        }
        most
    }
}
