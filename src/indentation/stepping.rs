//! One step: either the edge goes a given way and the time follows from the edge condition, or a time goes by and the place of the edge follows.
//!
//! A step of the edge takes the FIRST instant at which g changes sign there (C is a product: later sign changes may be compressed
//! edges). If g(a − h) ≥ 0 at once the edge has no stable neighbour on that side.

use super::edge::{Drive, Edge, Imposed, Trial};
use super::line::Contact;
use super::path_history::PathHistory;
use crate::refusal::Refusal;

/// Trials of one root; with a good guess four suffice, and each doubling of an unknown time is one.
const MOST_TRIALS: u32 = 300;
/// Trials after which rounding is taken as reached, and the residual accepted then.
const PATIENCE: u32 = 60;
const LAST_RESORT: f64 = 1e-10;
/// Residual at which a closed bracket is opened again.
const REOPENED: f64 = 1e-9;
/// Residual from which secants go straight to the root.
const NEAR: f64 = 0.05;
/// Part of a residual that is no progress.
const STALLS: f64 = 0.9;
/// Growth of a trial time without a bracket.
const STRIDE: f64 = 4.0;

/// The smallest contact that is one, over its process zone.
pub(super) const SMALLEST: f64 = 1.05;

/// Where a step of the edge ended.
pub(super) enum EdgeStep {
    /// There, in this time.
    Found(Trial),
    /// Not there by the end of the allowed time.
    Late,
    /// It would be there at once: unstable.
    Unstable,
}

/// Where a step of time ended.
pub(super) enum TimeStep {
    /// At this place.
    Found(Trial),
    /// Further away than allowed: inwards (true) or outwards.
    Far(bool),
}

/// What is known of the way that the edge goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    /// Either, or none.
    Any,
    /// It rests.
    None,
    Inwards,
    Outwards,
}

/// One step from a state.
pub(super) struct Stepper<'m, 'a> {
    pub(super) edge: &'m mut Edge,
    pub(super) contact: &'m Contact<'a>,
    pub(super) path_history: &'m PathHistory,
    /// Accepted |g|.
    pub(super) tolerance: f64,
    /// dg/d ln t and dg/da·reach of the last steps: first guesses of a secant.
    pub(super) slopes: &'m mut (f64, f64),
}

/// A bracket that a secant narrows.
#[derive(Clone, Copy)]
struct Search {
    low: Option<(f64, f64)>,
    high: Option<(f64, f64)>,
    last: Option<(f64, f64)>,
}

impl Search {
    const fn new() -> Self {
        Self { low: None, high: None, last: None }
    }

    /// Takes a value in; the point that the last two suggest.
    fn narrowed(&mut self, point: f64, value: f64) -> Option<f64> {
        let before = self.last.replace((point, value));
        if value < 0.0 {
            self.low = Some((point, value))
        } else {
            self.high = Some((point, value))
        }
        let (other, other_value) = before?;
        let secant = point - value * (point - other) / (value - other_value);
        secant.is_finite().then_some(secant)
    }

    /// A point inside the bracket, as near to a suggestion as allowed.
    fn inside(&self, suggestion: Option<f64>) -> Option<f64> {
        let ((low, low_value), (high, high_value)) = (self.low?, self.high?);
        let (left, right) = (low.min(high), low.max(high));
        let within = |point: &f64| *point > left && *point < right;
        let chord = (low * high_value - high * low_value) / (high_value - low_value);
        Some(suggestion.filter(within).or(Some(chord).filter(within)).unwrap_or(0.5 * (low + high)))
    }

    /// The end at which the value is smallest.
    fn best(&self) -> Option<(f64, f64)> {
        [self.low?, self.high?].into_iter().min_by(|one, other| one.1.abs().total_cmp(&other.1.abs()))
    }

    fn width(&self) -> f64 {
        match (self.low, self.high) {
            (Some((low, _)), Some((high, _))) => (high - low).abs(),
            _ => f64::INFINITY,
        }
    }
}

/// How quickly a search converges.
#[derive(Default)]
struct Pace {
    before: Option<f64>,
    slow: u32,
}

impl Pace {
    /// Whether two values in a row did not fall to a tenth: halving is due, then.
    fn is_slow(&mut self, value: f64) -> bool {
        let fell = self.before.is_none_or(|before| value.abs() < 0.1 * before);
        self.before = Some(value.abs());
        self.slow = if fell { 0 } else { self.slow + 1 };
        let due = self.slow >= 2;
        if due {
            self.slow = 0;
        }
        due
    }

    /// Part of the way to a suggested root: a little beyond it, for a bracket, unless it is near.
    fn overshoot(&mut self, value: f64) -> f64 {
        let near = value.abs() < NEAR && self.before.is_none_or(|before| value.abs() < before);
        self.before = Some(value.abs());
        if near { 1.0 } else { 1.1 }
    }
}

impl Stepper<'_, '_> {
    /// The edge to `target` in at most `cap`, probably in about `guess`.
    pub(super) fn edge_driven(&mut self, target: f64, guess: f64, cap: f64, imposed: &Imposed<'_>) -> Result<EdgeStep, Refusal> {
        let sign = if target < self.contact.radius() { 1.0 } else { -1.0 };
        let (mut search, mut pace) = (Search::new(), Pace::default());
        self.edge.held = None;
        let mut time = guess.min(cap);
        let (mut reopened, mut degree, mut raised) = (0, 0, false);
        for count in 0..MOST_TRIALS {
            let trial = self.edge.trial(self.contact, self.path_history, (target, time), Drive::Edge, imposed)?;
            let value = sign * trial.residual;
            if count > 0 && trial.degree < degree {
                search = Search::new();
            }
            degree = trial.degree;
            let before = search.last;
            let secant = search.narrowed(time, value);
            if let Some((other, other_value)) = before
                && (time - other).abs() > 1e-9 * time
            {
                let slope = (value - other_value) / (time - other) * time;
                if slope > 0.0 && slope.is_finite() {
                    self.slopes.0 = slope;
                }
            }
            let accepted = if count < PATIENCE { self.tolerance } else { self.tolerance.max(LAST_RESORT) };
            if value.abs() > REOPENED && search.width() <= 64.0 * f64::EPSILON * time && reopened < 3 {
                // The bracket closed upon a seam between two gradings of the window: once more, on this one.
                reopened += 1;
                self.edge.forget();
                search = Search::new();
                time *= 0.999;
                continue;
            }
            if value.abs() <= accepted && !raised && self.is_cramped((target, time), trial.degree, Drive::Edge) {
                raised = true;
                (search, degree) = (Search::new(), 0);
                continue;
            }
            if value.abs() <= accepted || search.width() <= 64.0 * f64::EPSILON * time {
                // What is found must not have been there from the start.
                let at_once = sign * self.edge.trial(self.contact, self.path_history, (target, 0.0), Drive::Edge, imposed)?.residual;
                return Ok(if at_once >= 0.0 { EdgeStep::Unstable } else { EdgeStep::Found(Trial { drive: -at_once, ..trial }) });
            }
            if value < 0.0 && time >= cap {
                return Ok(EdgeStep::Late);
            }
            let newton = if self.slopes.0 > 0.0 { Some(time * (1.0 - value / self.slopes.0)) } else { None };
            let suggestion = secant.or(newton);
            time = match (search.low, search.high) {
                (Some(_), Some(_)) => {
                    if pace.is_slow(value) {
                        0.5 * (search.low.map_or(0.0, |low| low.0) + search.high.map_or(0.0, |high| high.0))
                    } else {
                        search.inside(suggestion).unwrap_or(time)
                    }
                }
                // A slope of another step points a hair further on, again and again: then by strides.
                (Some((low, _)), None) => {
                    match suggestion.filter(|point| *point > low && before.is_none_or(|(_, other)| value > STALLS * other)) {
                        Some(point) => (low + pace.overshoot(value) * (point - low)).clamp(low * (1.0 + 1e-9), STRIDE * low).min(cap),
                        None => (STRIDE * low).min(cap),
                    }
                }
                _ => {
                    // The first sign change is earlier: at once, or on the way.
                    let at_once = sign * self.edge.trial(self.contact, self.path_history, (target, 0.0), Drive::Edge, imposed)?.residual;
                    if at_once >= 0.0 {
                        return Ok(EdgeStep::Unstable);
                    }
                    search.low = Some((0.0, at_once));
                    search.inside(suggestion.filter(|point| *point > 0.2 * time)).unwrap_or(0.5 * time)
                }
            };
        }
        Err(Refusal::NotConverged { what: "the edge condition", detail: format!("no time found at which the edge is at {target:e}") })
    }

    /// Whether the path to what was found can be of a higher degree than the one that a first guess far from it could carry; the search then begins anew from here.
    fn is_cramped(&mut self, (place, time): (f64, f64), degree: u32, drive: Drive) -> bool {
        let cramped = self.edge.free_degree(self.contact, self.path_history, (place, time), drive) > degree;
        if cramped {
            self.edge.held = None;
        }
        cramped
    }

    /// The edge after `dt`, probably near `guess`, at most `reach` from here.
    pub(super) fn time_driven(&mut self, dt: f64, way: Way, guess: f64, reach: f64, imposed: &Imposed<'_>) -> Result<TimeStep, Refusal> {
        self.edge.held = None;
        let here = self.contact.radius();
        let rim = self.contact.profile().rim();
        // A contact no larger than its process zone has no closure: further in is far.
        let zone = self.edge.zone_at(self.contact, here, self.contact.edge_load()).max(self.edge.zone());
        let inner = (here - reach).max(SMALLEST * zone).min(here);
        let outer = (here + reach).min(rim);
        let (mut search, mut pace) = (Search::new(), Pace::default());
        // Without a path history, a little to either side of the edge tells which way it goes.
        let mut stride = 1e-3 * reach;
        let (mut degree, mut raised) = (0, false);
        let mut place = guess.clamp(inner, outer);
        if here == 0.0 {
            // A contact about to grow from a point: no contact is too little.
            search.low = Some((0.0, -1.0));
            place = place.max(stride);
        }
        if way != Way::Any {
            let mut trial = self.edge.trial(self.contact, self.path_history, (here, dt), Drive::Time, imposed)?;
            let value = trial.residual;
            if way == Way::None || value.abs() <= self.tolerance || (value > 0.0) != (way == Way::Inwards) {
                trial.residual = 0.0;
                return Ok(TimeStep::Found(trial));
            }
            // The edge goes one way only, and here is one end of it.
            if way == Way::Inwards {
                search.high = Some((here, value));
                place = place.min(here - stride).max(inner);
            } else {
                search.low = Some((here, value));
                place = place.max(here + stride).min(outer);
            }
        }
        let begun = search;
        for count in 0..MOST_TRIALS {
            let mut trial = self.edge.trial(self.contact, self.path_history, (place, dt), Drive::Time, imposed)?;
            let value = trial.residual;
            if count > 0 && trial.degree < degree {
                // A polynomial that ceased to rise: what was found of a higher degree is of another function.
                search = begun;
            }
            degree = trial.degree;
            let before = search.last;
            let secant = search.narrowed(place, value);
            if let Some((other, other_value)) = before
                && (place - other).abs() > 1e-12 * here
            {
                let slope = (value - other_value) / (place - other);
                if slope > 0.0 && slope.is_finite() {
                    self.slopes.1 = slope;
                }
            }
            if place >= rim && value <= 0.0 {
                // Nothing to touch beyond the rim: the edge stays there.
                trial.residual = 0.0;
                return Ok(TimeStep::Found(trial));
            }
            let accepted = if count < PATIENCE { self.tolerance } else { self.tolerance.max(LAST_RESORT) };
            let closed = search.width() <= 16.0 * f64::EPSILON * here.max(place);
            if value.abs() <= accepted && !raised && self.is_cramped((place, dt), trial.degree, Drive::Time) {
                raised = true;
                (search, degree) = (begun, 0);
                continue;
            }
            if closed && way != Way::Any && value.abs() > REOPENED && degree > 1 {
                // The speed of the edge jumps where a polynomial ceases to rise; that of a straight way does not.
                self.edge.held = Some(1);
                (search, raised) = (begun, true);
                continue;
            }
            if closed
                && way != Way::Any
                && let Some((best, _)) = search.best().filter(|best| best.1.abs() < value.abs())
            {
                // Places have no more digits, and the speed of a short way has few: the better end.
                return Ok(TimeStep::Found(self.edge.trial(self.contact, self.path_history, (best, dt), Drive::Time, imposed)?));
            }
            if value.abs() <= accepted || closed {
                return Ok(TimeStep::Found(trial));
            }
            let newton = if self.slopes.1 > 0.0 { Some(place - value / self.slopes.1) } else { None };
            let suggestion = secant.or(newton);
            place = if search.low.is_some() && search.high.is_some() {
                if pace.is_slow(value) {
                    0.5 * (search.low.map_or(0.0, |low| low.0) + search.high.map_or(0.0, |high| high.0))
                } else {
                    search.inside(suggestion).unwrap_or(place)
                }
            } else {
                let outwards = value < 0.0;
                if (outwards && place >= outer) || (!outwards && place <= inner) {
                    return Ok(TimeStep::Far(!outwards));
                }
                let ahead = suggestion.filter(|point| if outwards { *point > place } else { *point < place });
                let least = if outwards { place + stride } else { place - stride };
                stride *= STRIDE;
                let next = ahead.map_or(least, |point| {
                    let beyond = place + pace.overshoot(value) * (point - place);
                    // Never further than the stride allows: a flat slope points anywhere.
                    if outwards { beyond.min(place + 10.0 * stride) } else { beyond.max(place - 10.0 * stride) }
                });
                next.clamp(inner, outer)
            };
        }
        Err(Refusal::NotConverged { what: "the edge condition", detail: format!("no place found for the edge after {dt:e}") })
    }
}
