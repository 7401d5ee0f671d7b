//! The path of the edge, where it is kept: the panels that it went along, without the states that they left.

use super::line::{Segment, series};
use serde::{Deserialize, Serialize};

/// What the edge has passed, from its first place and instant on.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Trail {
    /// Way (m) and time (s) gone so far.
    pub(super) way: f64,
    pub(super) time: f64,
    pub(super) passed: Vec<Passed>,
}

/// A piece of it: where and when it starts, how long it takes.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Passed {
    pub(super) way: f64,
    pub(super) time: f64,
    pub(super) duration: f64,
    /// Its panel with place and time exchanged; none for a rest.
    by_time: Option<Segment>,
}

impl Trail {
    /// A panel up to a parameter.
    pub(super) fn goes(&mut self, panel: &Segment, theta: f64) {
        let duration = panel.time_at(theta);
        let by_time = Segment {
            theta_high: theta,
            straight: !panel.straight,
            places: panel.times.clone(),
            times: panel.places.clone(),
            ..Segment::blank(0.0, duration)
        };
        self.passed.push(Passed { way: self.way, time: self.time, duration, by_time: Some(by_time) });
        self.way += panel.place_at(theta).0;
        self.time += duration;
    }

    /// A rest.
    pub(super) fn waits(&mut self, duration: f64) {
        self.passed.push(Passed { way: self.way, time: self.time, duration, by_time: None });
        self.time += duration;
    }

    /// The way gone by a time.
    pub(super) fn at(&self, time: f64) -> f64 {
        let after = self.passed.partition_point(|passed| passed.time <= time);
        let Some(passed) = self.passed.get(after.saturating_sub(1)) else { return 0.0 };
        let since = (time - passed.time).clamp(0.0, passed.duration);
        passed.way + passed.by_time.as_ref().map_or(0.0, |panel| series(&panel.times, panel.theta_at(since)).0)
    }
}
