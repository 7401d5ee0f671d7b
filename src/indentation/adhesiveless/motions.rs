//! Along a stretch of the history, drive after drive.

use super::course::Course;
use super::drive::{Drive, Wave};
use super::edge::{Ended, Way};
use super::ledger::Gone;
use super::line::Line;
use super::state::Look;
use crate::indentation::stretch::Stretch;
use crate::refusal::Refusal;
use std::f64::consts::TAU;

/// Turns and losses of one drive, at most.
const MOST_TURNS: u32 = 100_000;
/// Longest time of one drive of an oscillation (cycles), and of one whose frequency changes.
const LONGEST_OF_CYCLE: f64 = 0.25;
const LONGEST_OF_SWEEP: f64 = 1.0 / 24.0;

/// Instants between which stretches are not joined.
const UNTIDY: usize = 32;

impl<'a> Course<'a> {
    /// The next part of a stretch, as a drive of its own quantity.
    pub(super) fn drive(&self, stretch: &Stretch, target: f64) -> Drive {
        let from = self.time;
        let Some(oscillation) = stretch.segment.oscillation else {
            return Drive::straight(stretch.value(from), stretch.value(target), target - from);
        };
        let duration = stretch.segment.duration;
        let swept = oscillation.frequency.to_bits() != oscillation.end_frequency.to_bits();
        let longest = if swept { LONGEST_OF_SWEEP } else { LONGEST_OF_CYCLE } / oscillation.frequency_at(from, duration);
        // Not so little left that it is none.
        let target = if from + longest * (1.0 + 1e-9) < target { from + longest } else { target };
        if swept {
            return Drive::fitted(stretch.value(from), target - from, |time| stretch.value(from + time));
        }
        let cycles = oscillation.cycles_at(from, duration);
        let phase = TAU * (cycles - cycles.round());
        let mean = |time: f64| stretch.from + (stretch.segment.end - stretch.from) * (time / duration);
        let wave = Wave { amplitude: oscillation.amplitude, pace: TAU * oscillation.frequency, phase };
        let start = stretch.value(from);
        Drive::straight(start, start + (mean(target) - mean(from)), target - from).with_wave(wave)
    }

    /// Goes along a drive of the penetration, whose values are kept at wanted times (of the stretch) before its end.
    pub(super) fn along(&mut self, drive: &Drive, mut wanted: &[(f64, f64)]) -> Result<(), Refusal> {
        let end = self.time + drive.duration;
        let mut drive = *drive;
        if drive.start.to_bits() != self.line.penetration.to_bits() {
            self.line.leap(drive.start, None)?;
        }
        let mut touched = false;
        for _ in 0..MOST_TURNS {
            self.evaluations += 1;
            let since = end - drive.duration;
            while let Some(&(time, _)) = wanted.first().filter(|(time, _)| *time <= since) {
                let look = Look::at(&self.line, true);
                self.kept_at(time, &look);
                wanted = &wanted[1..];
            }
            let before = if wanted.is_empty() { self.before() } else { Some(self.line.clone()) };
            let inside: Vec<f64> = wanted.iter().map(|(time, _)| time - since).collect();
            let had = self.line.radius() > 0.0;
            let (time, way, ended) = self.line.go(&drive, touched, &inside)?;
            if let Some(before) = &before {
                let count = inside.partition_point(|at| *at < time);
                self.see(before, &drive, way, wanted.iter().zip(&inside).take(count))?;
                wanted = &wanted[count..];
            }
            if let Some(before) = before.filter(|_| time > 0.0 && self.adds_up()) {
                let part = drive.until(time);
                self.add_up(&Gone { before, drive: part, way, edge: None, since, force: None })?;
            }
            let rest = drive.duration - time;
            self.time = if rest > 0.0 { end - rest } else { end };
            touched = ended == Ended::Touched;
            match ended {
                Ended::Whole => {
                    self.time = end;
                    if had && self.line.radius() == 0.0 {
                        self.lost();
                    }
                    return Ok(());
                }
                Ended::Touched => {
                    self.turned();
                    self.record.new_piece();
                    self.corner();
                }
                Ended::Turned | Ended::Faint => self.turned(),
                Ended::Lost => self.lost(),
            }
            if rest <= 4.0 * f64::EPSILON * drive.duration {
                self.line.leap(drive.end(), None)?;
                self.time = end;
                return Ok(());
            }
            drive = drive.rest(time);
        }
        Err(Refusal::NotConverged { what: "the edge", detail: format!("turns again and again at t = {:e}", self.now()) })
    }

    /// Keeps instants along a drive that a line has been gone along one way: wanted times and penetrations, and the times of the drive.
    fn see<'w>(
        &mut self,
        before: &Line<'a>,
        drive: &Drive,
        way: Option<Way>,
        wanted: impl Iterator<Item = (&'w (f64, f64), &'w f64)>,
    ) -> Result<(), Refusal> {
        if way == Some(Way::Inwards) {
            // What is still in contact does not know of what has left it.
            for (&(time, depth), at) in wanted {
                let look = Look { penetration: depth, ..before.receded(drive, *at) };
                self.kept_at(time, &look);
            }
            return Ok(());
        }
        let (mut line, mut rest, mut gone) = (before.clone(), *drive, 0.0);
        for (index, (&(time, depth), at)) in wanted.enumerate() {
            let part = rest.until(at - gone);
            match way {
                Some(way) => line.passed(&part, way, None)?,
                None => line.pass_nothing(&part),
            }
            if index % UNTIDY == UNTIDY - 1 {
                line.tidy(false);
            }
            (rest, gone) = (rest.rest(at - gone), *at);
            self.line.cut = self.line.cut.max(line.cut);
            self.line.joined = self.line.joined.max(line.joined);
            self.kept_at(time, &Look { penetration: depth, ..Look::at(&line, true) });
        }
        self.line.updates += line.updates - before.updates;
        Ok(())
    }

    /// Keeps an instant.
    fn kept_at(&mut self, time: f64, look: &Look) {
        let now = std::mem::replace(&mut self.time, time);
        self.point_of(look, false);
        self.keep(look.slope);
        self.time = now;
    }
}
