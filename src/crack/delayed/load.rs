//! A load history: K(t) as straight segments with jumps between them.
//!
//! Before time zero there is no load; after the last segment the last load holds. Loads are zero or more: faces pressed together are a
//! contact, not a crack. A smooth K(t) is given as a table, and the table is then the load that is solved.

use crate::Estimate;
use crate::elastic::pure_shear_strip::PureShearStrip;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};

/// The form of a load cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wave {
    /// Straight up from `lower` to `upper` in half a period, straight down in the other half.
    Triangle,
    /// Half a period at `upper`, then half a period at `lower`.
    Square,
}

/// One part of a load history; times in s, loads in the unit of the history (Pa √m, or Pa of a strip).
#[derive(Debug, Clone, PartialEq)]
pub enum LoadSegment {
    /// A jump to a load, in no time.
    Step {
        /// The load after the jump.
        load: f64,
    },
    /// The present load for a while.
    Hold {
        /// How long (s), zero or more.
        duration: f64,
    },
    /// A straight line from the present load to another.
    Ramp {
        /// How long (s), greater than zero.
        duration: f64,
        /// The load at the end.
        load: f64,
    },
    /// Straight lines through points (time since the start of this segment, load), times increasing; the first load is stepped to.
    Table {
        /// The points; the first time is zero.
        points: Vec<(f64, f64)>,
    },
    /// Load cycles.
    Cycles {
        /// How many.
        count: u32,
        /// The duration of one (s).
        period: f64,
        /// The least load.
        lower: f64,
        /// The greatest load.
        upper: f64,
        /// The form.
        wave: Wave,
    },
}

/// A segment of time in which the load is a straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearSegment {
    /// Start (s).
    pub start: f64,
    /// Duration (s), greater than zero; infinite for the last one.
    pub duration: f64,
    /// Load at the start (Pa √m), after a jump if there is one.
    pub from: f64,
    /// Load at the end (Pa √m), before the next jump.
    pub to: f64,
}

/// K(t) ≥ 0 for all times from zero on.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadHistory {
    segments: Vec<LinearSegment>,
}

impl LoadHistory {
    /// A load K (Pa √m) applied at time zero and held for ever (thesis Eq 5.47).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a load that is negative or not finite.
    pub fn constant(load: f64) -> Result<Self, Refusal> {
        Self::from_segments(&[LoadSegment::Step { load }])
    }

    /// A history from its segments, one after the other, from no load at time zero.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or non-finite load, a negative or non-finite duration, times of a table that do not
    /// increase from zero.
    pub fn from_segments(segments: &[LoadSegment]) -> Result<Self, Refusal> {
        let mut builder = Builder { segments: Vec::new(), time: 0.0, load: 0.0 };
        for segment in segments {
            match segment {
                LoadSegment::Step { load } => builder.load = require_non_negative("load", *load)?,
                LoadSegment::Hold { duration } => builder.line(require_non_negative("duration", *duration)?, builder.load)?,
                LoadSegment::Ramp { duration, load } => builder.line(require_positive("duration", *duration)?, *load)?,
                LoadSegment::Table { points } => {
                    for (index, &(time, load)) in points.iter().enumerate() {
                        let before = if index == 0 { None } else { points.get(index - 1).map(|point| point.0) };
                        match before {
                            None if time == 0.0 => builder.load = require_non_negative("load", load)?,
                            None => return Err(Refusal::out_of_range("time", time, "zero at the first point of a table")),
                            Some(earlier) if time > earlier => builder.line(time - earlier, load)?,
                            Some(_) => return Err(Refusal::out_of_range("time", time, "greater than the time of the point before")),
                        }
                    }
                }
                LoadSegment::Cycles { count, period, lower, upper, wave } => {
                    let half = 0.5 * require_positive("period", *period)?;
                    require_non_negative("lower", *lower)?;
                    require_non_negative("upper", *upper)?;
                    for _ in 0..*count {
                        match wave {
                            Wave::Triangle => {
                                builder.load = *lower;
                                builder.line(half, *upper)?;
                                builder.line(half, *lower)?;
                            }
                            Wave::Square => {
                                builder.load = *upper;
                                builder.line(half, *upper)?;
                                builder.load = *lower;
                                builder.line(half, *lower)?;
                            }
                        }
                    }
                }
            }
        }
        let last = LinearSegment { start: builder.time, duration: f64::INFINITY, from: builder.load, to: builder.load };
        builder.segments.push(last);
        Ok(Self { segments: builder.segments })
    }

    /// A history from the remote stress on a strip (Pa), by K = σ√(h·…) of [`PureShearStrip`] (thesis Eq 5.46).
    ///
    /// # Errors
    /// As [`LoadHistory::from_segments`].
    pub fn of_strip_stress(segments: &[LoadSegment], strip: &PureShearStrip) -> Result<Self, Refusal> {
        Self::from_segments(segments)?.scaled(strip.stress_intensity_factor(1.0)?)
    }

    /// The same history with every load multiplied.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a factor, or a product, that is negative or not finite.
    pub fn scaled(mut self, factor: f64) -> Result<Self, Refusal> {
        require_non_negative("factor", factor)?;
        for segment in &mut self.segments {
            segment.from = require_non_negative("load", segment.from * factor)?;
            segment.to = require_non_negative("load", segment.to * factor)?;
        }
        Ok(self)
    }

    /// The segments in order, without gaps; the last one lasts for ever.
    #[must_use]
    pub fn segments(&self) -> &[LinearSegment] {
        &self.segments
    }

    /// The greatest load of the history (Pa √m).
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.segments.iter().map(|segment| segment.from.max(segment.to)).fold(0.0, f64::max)
    }

    /// The load that holds after the last segment (Pa √m).
    #[must_use]
    pub fn last(&self) -> f64 {
        self.segments.last().map_or(0.0, |segment| segment.to)
    }

    /// K(t) (Pa √m) at a time (s), after the jump where there is one; zero before time zero.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        let index = self.segments.partition_point(|segment| segment.start <= time);
        match index.checked_sub(1).and_then(|index| self.segments.get(index)) {
            None => 0.0,
            Some(segment) if segment.duration.is_infinite() => segment.from,
            Some(segment) => segment.from + (segment.to - segment.from) * ((time - segment.start) / segment.duration),
        }
    }
}

/// A time known to this part of itself is that of a corner it lies on.
const SAME_TIME: f64 = 1e-13;

impl LoadHistory {
    /// K (Pa √m) at a time (s) that is known to its bound: all loads from the earliest to the latest time. An event on a jump of the load comes after it.
    #[must_use]
    pub fn around(&self, time: Estimate) -> Estimate {
        let [earliest, latest] = [time.value - time.error, time.value + time.error];
        let certain = time.error <= SAME_TIME * time.value;
        // The clock of an event may be an ulp before the corner that the event lies on.
        let reached = if certain { time.value * (1.0 + SAME_TIME) } else { time.value };
        let index = self.segments.partition_point(|segment| segment.start <= reached).saturating_sub(1);
        let start = self.segments.get(index).map_or(0.0, |segment| segment.start);
        let value = self.at(time.value.max(start));
        let first = self.segments.partition_point(|segment| segment.start + segment.duration < earliest).min(index);
        let first = if certain && time.value - start <= SAME_TIME * time.value { index } else { first };
        let mut error = 0.0_f64;
        let last = if certain { start } else { latest };
        for segment in self.segments.iter().skip(first).take_while(|segment| segment.start <= last) {
            let load = |time: f64| {
                let part = if segment.duration.is_finite() { ((time - segment.start) / segment.duration).clamp(0.0, 1.0) } else { 0.0 };
                segment.from + (segment.to - segment.from) * part
            };
            error = error.max((load(earliest) - value).abs()).max((load(latest) - value).abs());
        }
        Estimate::new(value, error)
    }
}

struct Builder {
    segments: Vec<LinearSegment>,
    time: f64,
    load: f64,
}

impl Builder {
    fn line(&mut self, duration: f64, load: f64) -> Result<(), Refusal> {
        require_non_negative("load", load)?;
        require_finite("duration", duration)?;
        let end = require_finite("time", self.time + duration)?;
        // A segment below the resolution of the clock has no duration left.
        if end > self.time {
            self.segments.push(LinearSegment { start: self.time, duration, from: self.load, to: load });
            self.time = end;
        }
        self.load = load;
        Ok(())
    }
}
