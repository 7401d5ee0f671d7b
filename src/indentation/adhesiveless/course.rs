//! One course through a history: the segments of the history, the instants to keep, cycles, events and energies.

use super::chain::Chain;
use super::fresh::Fresh;
use super::ledger::Sums;
use super::line::Line;
use super::motions::Wanted;
use crate::indentation::checkpoint::Watch;
use crate::indentation::current_segment::{CurrentSegment, part, weight};
use crate::indentation::cycle_integrals::CycleIntegrals;
use crate::indentation::history::{Controlled, Segment};
use crate::indentation::problem::{IndentationProblem, Start};
use crate::indentation::record::Record;
use crate::indentation::solution::{EventKind, Trace};
use crate::refusal::Refusal;

/// Relative change of a rate that is no corner.
const SAME_PACE: f64 = 1e-9;

/// Cycles of a segment whose sums are kept one by one.
const MOST_CYCLES: u64 = 10_000;

/// How finely a course goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    /// What series leave, over the depth.
    pub(super) series: f64,
    /// What sums over the time leave, over what they are of.
    pub(super) sums: f64,
}

/// What is not known of a course.
pub(super) struct Unknown {
    /// Of any strain (m).
    pub(super) strain: f64,
    /// At each kept instant.
    pub(super) kept: Vec<Left>,
    /// What series over the time leave in each cycle, by segment and number, of the sums of Δ, of F and of the work.
    pub(super) of_cycles: Vec<((usize, u64), [f64; 3])>,
    /// How the contact was lost, each time.
    pub(super) losses: Vec<Loss>,
}

/// A loss of contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Loss {
    /// Δ̇ (m/s).
    pub(super) depth_rate: f64,
    /// How fast S falls on the axis (m/s): what the time makes of a strain.
    pub(super) falling: f64,
}

impl Loss {
    /// At a time that is given.
    pub(super) const GIVEN: Self = Self { depth_rate: 0.0, falling: f64::INFINITY };

    /// What is not known of its time, at most so much, for what is not known of a strain.
    pub(super) fn late(self, unknown: f64, most: f64) -> f64 {
        if self.falling > 0.0 { (unknown / self.falling).min(most) } else { most }
    }
}

/// What is left open at an instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Left {
    /// How steeply S falls at the edge: what the edge makes of a strain.
    pub(super) slope: f64,
    /// What is not known of any strain until then (m).
    pub(super) strain: f64,
    /// What series over the time leave of the work until then (J).
    pub(super) work: f64,
}

/// A course under way.
pub(super) struct Course<'a> {
    pub(super) chain: &'a Chain,
    pub(super) problem: &'a IndentationProblem,
    pub(super) line: Line<'a>,
    pub(super) fineness: Fineness,
    pub(super) fresh: &'a Fresh<'a>,
    /// Start of the interval under way and the time since.
    pub(super) origin: f64,
    pub(super) time: f64,
    pub(super) record: Record<'a>,
    pub(super) cycle_integrals: Option<CycleIntegrals>,
    /// What has been added up since the last point.
    pub(super) sums: Sums,
    /// The work of a relaxed contact as deep as the history reaches at least (J).
    pub(super) least_work: f64,
    /// What the last panel was allowed to leave of Δ, and what it left (m).
    pub(super) left: f64,
    pub(super) left_of_panel: f64,
    pace: Option<(Controlled, f64)>,
    pub(super) evaluations: u64,
    /// What series over the time have left so far of the work (J), and of the sums of Δ, of F and of the work in the cycle under way and in those before.
    pub(super) left_work: f64,
    pub(super) left_of_cycle: [f64; 3],
    left_of_cycles: Vec<((usize, u64), [f64; 3])>,
    kept: Vec<Left>,
    pub(super) losses: Vec<Loss>,
    /// How long the next panel may be, and Δ̇ so far; 0 and none after a corner.
    pub(super) panel_length: f64,
    pub(super) depth_rate: Option<f64>,
    watch: Option<(&'a dyn Watch, u32)>,
    stop: Option<Line<'a>>,
    pub(super) until: f64,
    /// The time of the interval from which on a point is seen to be admissible.
    pub(super) look_at: f64,
}

impl<'a> Course<'a> {
    pub(super) fn new(chain: &'a Chain, problem: &'a IndentationProblem, fresh: &'a Fresh<'a>, fineness: Fineness) -> Self {
        let line = Line::untouched(chain, &problem.profile, fineness.series);
        Self {
            chain,
            problem,
            line,
            fineness,
            fresh,
            origin: 0.0,
            time: 0.0,
            record: Record::without_contact(),
            cycle_integrals: None,
            sums: Sums::default(),
            least_work: 0.0,
            left: 0.0,
            left_of_panel: 0.0,
            pace: None,
            evaluations: 0,
            left_work: 0.0,
            left_of_cycle: [0.0; 3],
            left_of_cycles: Vec::new(),
            kept: Vec::new(),
            losses: Vec::new(),
            panel_length: 0.0,
            depth_rate: None,
            watch: None,
            stop: None,
            until: f64::INFINITY,
            look_at: 0.0,
        }
    }

    pub(super) fn watched(mut self, watch: Option<&'a dyn Watch>, number: u32) -> Self {
        self.watch = watch.map(|watch| (watch, number));
        self
    }

    /// The whole history; `stops`: intervals that end early, and how long they take. The path, and what is not known of any strain of it beyond what another course
    /// tells.
    pub(super) fn through(mut self, stops: &[(usize, f64)]) -> Result<(Trace, Unknown), Refusal> {
        self.record.trace.shortened = stops.to_vec();
        self.run()?;
        let mut trace = self.record.finished();
        trace.work.closure_evaluations = self.evaluations;
        trace.work.history_updates = self.line.updates;
        trace.work.most_panels = self.line.most_intervals;
        trace.tolerance = self.fineness.series;
        Ok((trace, Unknown { strain: self.line.unknown(), kept: self.kept, of_cycles: self.left_of_cycles, losses: self.losses }))
    }

    /// The line at a time of the history.
    pub(super) fn line_at(mut self, time: f64, stops: &[(usize, f64)]) -> Result<Line<'a>, Refusal> {
        self.record.trace.shortened = stops.to_vec();
        self.until = time;
        self.run()?;
        Ok(self.stop.unwrap_or(self.line))
    }

    /// The deepest that an elastic contact as stiff as at once would come: none that creeps stays above it.
    fn reaches(&self) -> f64 {
        let history = &self.problem.history;
        let imposed = history.segments.iter().map(|segment| (segment.controlled, segment.end));
        let depths = std::iter::once((history.controlled, history.start)).chain(imposed).map(|(controlled, value)| match controlled {
            Controlled::Penetration => value,
            Controlled::ContactRadius => self.problem.profile.line(value.max(0.0)),
            Controlled::Force => self.fresh.at_most(0.5 * value / self.chain.glassy).unwrap_or(0.0),
            Controlled::Frame => self.problem.frame_stiffness.map_or(0.0, |stiffness| {
                // Half of the way, or less where the load of half the spring does not press so deep.
                self.fresh.at_most(0.25 * stiffness * value / self.chain.glassy).map_or(0.5 * value, |depth| depth.min(0.5 * value))
            }),
        });
        depths.fold(0.0, f64::max)
    }

    fn run(&mut self) -> Result<(), Refusal> {
        let history = &self.problem.history;
        // Nothing counts that is little beside what is still to come.
        self.line.depth = self.reaches();
        let radius = self.line.virgin_edge(self.line.depth, 0.0).unwrap_or(0.0);
        self.least_work = 2.0 * self.chain.relaxed * self.fresh.at(radius) * self.line.depth;
        self.begin()?;
        let mut last = history.start;
        let mut before = history.controlled;
        let mut index = 0;
        while let Some(segment) = history.segments.get(index) {
            if self.stop.is_some() {
                return Ok(());
            }
            if segment.controlled != before {
                (before, last) = (segment.controlled, self.present(segment.controlled));
            }
            let goes_on = self.goes_on(index, last);
            if goes_on.len() * self.problem.instants_per_segment.max(1) as usize > 1 {
                index += goes_on.len();
                last = self.seen_through(goes_on, last)?;
                self.observe(index - 1, None);
                continue;
            }
            let current = CurrentSegment { from: last, segment: *segment };
            let duration = if segment.duration == 0.0 {
                self.at_once(segment.controlled, segment.end)?;
                self.pace = None;
                self.keep(self.line.slope_at_edge());
                0.0
            } else {
                self.current(index, &current)?
            };
            last = segment.value(last, duration);
            self.observe(index, None);
            index += 1;
        }
        Ok(())
    }

    /// The segments from one on through which a penetration goes on at one pace.
    fn goes_on(&self, index: usize, from: f64) -> &'a [Segment] {
        let rest = self.problem.history.segments.get(index..).unwrap_or(&[]);
        let Some(first) = rest.first() else { return &[] };
        let steady = |segment: &Segment| segment.controlled == first.controlled && segment.oscillation.is_none() && segment.duration > 0.0;
        let rate = (first.end - from) / first.duration;
        // What is held relaxes until rounding is left, which tells no way of the edge for long.
        if first.controlled == Controlled::Penetration && first.end.to_bits() == from.to_bits() {
            return &[];
        }
        let mut last = from;
        let same = rest.iter().take_while(|segment| {
            let own = (segment.end - std::mem::replace(&mut last, segment.end)) / segment.duration;
            steady(segment) && (own - rate).abs() <= SAME_PACE * rate.abs()
        });
        let count = same.count();
        &rest[..count]
    }

    /// Goes through segments at one pace, as one interval: instants are looked at along its way.
    fn seen_through(&mut self, segments: &'a [Segment], from: f64) -> Result<f64, Refusal> {
        let Some((first, last)) = segments.first().zip(segments.last()) else { return Ok(from) };
        let instants = self.problem.instants_per_segment.max(1);
        let (mut wanted, mut passed, mut value) = (Vec::new(), 0.0, from);
        for segment in segments {
            for k in 1..=instants {
                let time = segment.duration * if k == instants { 1.0 } else { f64::from(k) / f64::from(instants) };
                let penetration = (segment.controlled == Controlled::Penetration).then(|| segment.value(value, time));
                wanted.push(Wanted { time: passed + time, penetration });
            }
            (passed, value) = (passed + segment.duration, segment.end);
        }
        wanted.pop();
        if self.until.is_finite() {
            // Fields look at one time only.
            wanted.clear();
        }
        let current = CurrentSegment { from, segment: Segment { duration: passed, end: last.end, ..*first } };
        self.begin_segment(&current);
        if self.origin + passed >= self.until {
            let time = self.until - self.origin;
            if time > 0.0 {
                self.reach(&current, time)?;
            }
            self.stop = Some(self.line.clone());
            return Ok(last.end);
        }
        self.look_at = passed;
        self.go(&current, passed, &wanted)?;
        self.point(false);
        self.keep(self.line.slope_at_edge());
        self.end_segment(&current, passed);
        Ok(last.end)
    }

    /// A corner, where an interval does not go on as the last one.
    fn begin_segment(&mut self, current: &CurrentSegment) {
        let (segment, rate) = (current.segment, current.rate());
        let same = segment.oscillation.is_none()
            && self
                .pace
                .is_some_and(|(controlled, last)| controlled == segment.controlled && (rate - last).abs() <= SAME_PACE * rate.abs());
        if !same {
            self.record.new_piece();
            self.corner();
        }
    }

    fn end_segment(&mut self, current: &CurrentSegment, duration: f64) {
        self.pace = current.segment.oscillation.is_none().then(|| (current.segment.controlled, current.rate()));
        self.origin += duration;
        (self.time, self.look_at) = (0.0, 0.0);
    }

    /// Keeps the last point as an instant, where S falls so steeply at the edge.
    pub(super) fn keep(&mut self, slope: f64) {
        self.record.keep();
        self.kept.push(Left { slope, strain: self.line.unknown(), work: self.left_work });
    }

    /// What a quantity is now.
    fn present(&self, controlled: Controlled) -> f64 {
        match controlled {
            Controlled::Penetration => self.line.penetration,
            // Below zero it is rounding: what has relaxed pulls nothing.
            Controlled::Force => self.line.force().max(0.0),
            Controlled::ContactRadius => self.line.radius(),
            Controlled::Frame => self.line.penetration + self.problem.frame_stiffness.map_or(0.0, |k| self.line.force() / k),
        }
    }

    fn observe(&self, index: usize, inside: Option<&Segment>) {
        let Some((watch, number)) = self.watch else { return };
        let segments = &self.problem.history.segments;
        let all: f64 = segments.iter().map(weight).sum();
        let done = index + usize::from(inside.is_none());
        let before: f64 = segments.iter().take(done).map(weight).sum();
        let under_way = inside.map_or(0.0, |segment| weight(segment) * part(segment, self.time));
        watch.passed(number, (before + under_way) / all);
    }

    pub(super) fn now(&self) -> f64 {
        self.origin + self.time
    }

    fn begin(&mut self) -> Result<(), Refusal> {
        let history = &self.problem.history;
        match self.problem.start {
            Start::Untouched => self.settle(history.controlled, history.start)?,
            Start::Relaxed => self.relaxed(history.controlled, history.start)?,
        }
        self.point(false);
        self.keep(self.line.slope_at_edge());
        Ok(())
    }

    /// A step of what is controlled.
    fn at_once(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        self.record.sudden();
        self.corner();
        let had = self.line.radius() > 0.0;
        self.settle(controlled, value)?;
        if had && self.line.radius() == 0.0 {
            self.losses.push(Loss::GIVEN);
            self.record.happened(EventKind::Detachment);
        }
        self.point(true);
        self.record.new_piece();
        Ok(())
    }

    /// Nothing behind counts for what follows.
    pub(super) fn corner(&mut self) {
        (self.panel_length, self.depth_rate) = (0.0, None);
    }

    /// A segment of the history, to each kept instant and the end of each cycle: how long it took.
    fn current(&mut self, index: usize, current: &CurrentSegment) -> Result<f64, Refusal> {
        let segment = current.segment;
        self.begin_segment(current);
        self.cycle_integrals = segment.oscillation.map(|oscillation| {
            CycleIntegrals::new(
                index,
                (oscillation, segment.duration),
                self.origin,
                self.chain.longest_time(),
                self.record.trace.path.last(),
            )
        });
        let stop = self.record.end_of(index);
        let mut duration = stop.unwrap_or(segment.duration);
        let until_stationary = segment.oscillation.is_some_and(|oscillation| oscillation.until_stationary);
        // Fields look at one time only.
        let instants = if until_stationary || self.until.is_finite() { 1 } else { self.problem.instants_per_segment.max(1) };
        let (mut instant, mut cycle) = (1_u32, 1_u64);
        let mut at_start: Option<Line<'a>> = None;
        while self.time < duration {
            let next_instant = duration * if instant == instants { 1.0 } else { f64::from(instant) / f64::from(instants) };
            let end_of_cycle = current.end_of_cycle(cycle);
            let target = end_of_cycle.map_or(next_instant, |end| end.min(next_instant));
            for time in self.between(current, target) {
                if self.origin + time >= self.until {
                    let time = self.until - self.origin;
                    if time > self.time {
                        self.reach(current, time)?;
                    }
                    self.stop = Some(self.line.clone());
                    return Ok(duration);
                }
                self.reach(current, time)?;
            }
            if end_of_cycle.is_some_and(|end| end <= target) {
                self.cycle_left((index, cycle));
                cycle += 1;
                self.line.tidy(true);
                self.observe(index, Some(&segment));
                let stationary = self
                    .cycle_integrals
                    .as_mut()
                    .and_then(|cycle_integrals| self.record.cycle(cycle_integrals, self.origin + target, self.problem.accuracy));
                if until_stationary && stop.is_none() && stationary == Some(true) {
                    duration = target;
                    self.record.trace.shortened.push((index, target));
                }
                let skipped = self.repeated(current, &mut at_start, cycle, next_instant);
                cycle += skipped;
            }
            if self.time >= next_instant || self.time >= duration {
                self.keep(self.line.slope_at_edge());
                instant += 1;
            }
        }
        self.record.last_cycle(self.cycle_integrals.take());
        self.end_segment(current, duration);
        Ok(duration)
    }

    /// What sums over a cycle have left; of very many cycles the last one has the most of those after.
    fn cycle_left(&mut self, which: (usize, u64)) {
        let left = std::mem::take(&mut self.left_of_cycle);
        match self.left_of_cycles.last_mut().filter(|(last, _)| last.0 == which.0 && last.1 >= MOST_CYCLES) {
            Some((_, most)) => most.iter_mut().zip(left).for_each(|(most, left)| *most = most.max(left)),
            None => self.left_of_cycles.push((which, left)),
        }
    }

    /// Goes towards a time of an interval; an oscillation takes some of these.
    fn go(&mut self, current: &CurrentSegment, target: f64, wanted: &[Wanted]) -> Result<(), Refusal> {
        match current.segment.controlled {
            Controlled::Penetration => self.along(&self.drive(current, target), wanted),
            _ => self.toward(current, target, wanted),
        }
    }

    /// Goes on to a time of an interval, and adds the state there to the path.
    fn reach(&mut self, current: &CurrentSegment, target: f64) -> Result<(), Refusal> {
        self.look_at = target;
        while self.time < target {
            self.go(current, target, &[])?;
        }
        self.point(false);
        Ok(())
    }
}
