//! Along a segment of the history, drive after drive.

use super::course::Course;
use super::drive::{Drive, Wave};
use super::edge::{Ended, Way};
use super::ledger::Gone;
use super::state::Look;
use super::walk::Walk;
use crate::indentation::current_segment::CurrentSegment;
use crate::refusal::Refusal;
use std::f64::consts::TAU;

/// Turns and losses of one drive, at most.
const MOST_TURNS: u32 = 100_000;
/// Longest time of one drive of an oscillation (cycles), and of one whose frequency changes.
const LONGEST_OF_CYCLE: f64 = 0.25;
const LONGEST_OF_SWEEP: f64 = 1.0 / 24.0;

/// An instant that is kept on the way through an interval.
pub(super) struct Wanted {
    /// Since the start of the interval (s).
    pub(super) time: f64,
    /// Where it is imposed (m).
    pub(super) penetration: Option<f64>,
}

impl<'a> Course<'a> {
    /// The next part of an interval, as a drive of its own quantity.
    pub(super) fn drive(&self, current: &CurrentSegment, target: f64) -> Drive {
        let from = self.time;
        let Some(oscillation) = current.segment.oscillation else {
            return Drive::straight(current.value(from), current.value(target), target - from);
        };
        let duration = current.segment.duration;
        let swept = oscillation.frequency.to_bits() != oscillation.end_frequency.to_bits();
        let longest = if swept { LONGEST_OF_SWEEP } else { LONGEST_OF_CYCLE } / oscillation.frequency_at(from, duration);
        // Not so little left that it is none.
        let target = if from + longest * (1.0 + 1e-9) < target { from + longest } else { target };
        if swept {
            return Drive::fitted(current.value(from), target - from, |time| current.value(from + time));
        }
        let phase = oscillation.angle(from, duration);
        let mean = |time: f64| current.from + (current.segment.end - current.from) * (time / duration);
        let wave = Wave { amplitude: oscillation.amplitude, pace: TAU * oscillation.frequency, phase };
        let start = current.value(from);
        Drive::straight(start, start + (mean(target) - mean(from)), target - from).with_wave(wave)
    }

    /// Goes along a drive of the penetration; instants before its end are kept on the way.
    pub(super) fn along(&mut self, drive: &Drive, mut wanted: &[Wanted]) -> Result<(), Refusal> {
        self.left_of_panel = 0.0;
        let end = self.time + drive.duration;
        let mut drive = *drive;
        if drive.start.to_bits() != self.line.penetration.to_bits() {
            self.line.leap(drive.start, None)?;
        }
        let mut touched = false;
        for _ in 0..MOST_TURNS {
            self.evaluations += 1;
            let since = end - drive.duration;
            self.keep_reached(&mut wanted, since);
            let before = self.before(!wanted.is_empty());
            let inside: Vec<f64> = wanted.iter().map(|instant| instant.time - since).collect();
            let had = self.line.radius() > 0.0;
            let (time, way, ended) = self.line.go(&drive, touched, &inside)?;
            if let Some(before) = before.filter(|_| time > 0.0) {
                self.gone(&Gone { before: &before, drive: drive.until(time), way, edge: None, since, force: None }, &mut wanted)?;
            }
            let rest = drive.duration - time;
            self.time = if rest > 0.0 { end - rest } else { end };
            touched = ended == Ended::Touched;
            match ended {
                Ended::Whole => {
                    self.time = end;
                    if had && self.line.radius() == 0.0 {
                        self.lost(Some(drive.rate(drive.duration)));
                    }
                    self.keep_reached(&mut wanted, f64::INFINITY);
                    return Ok(());
                }
                Ended::Touched => {
                    self.turned();
                    self.record.new_piece();
                    self.corner();
                }
                Ended::Turned | Ended::Unresolved => self.turned(),
                Ended::Lost => self.lost(Some(drive.rate(time))),
            }
            if rest <= 4.0 * f64::EPSILON * drive.duration {
                self.line.leap(drive.end(), None)?;
                self.time = end;
                self.keep_reached(&mut wanted, f64::INFINITY);
                return Ok(());
            }
            drive = drive.rest(time);
        }
        Err(Refusal::NotConverged { what: "the edge", detail: format!("turns again and again at t = {:e}", self.now()) })
    }

    /// Adds up what a drive has done, and keeps the instants inside of it.
    pub(super) fn gone(&mut self, gone: &Gone<'_, 'a>, wanted: &mut &[Wanted]) -> Result<(), Refusal> {
        let all = *wanted;
        let count = all.partition_point(|instant| instant.time - gone.since < gone.drive.duration);
        let (seen, later) = all.split_at(count);
        *wanted = later;
        let inside: Vec<f64> = seen.iter().map(|instant| (instant.time - gone.since).max(0.0)).collect();
        let sums = if self.adds_up() { self.add_up(gone, &inside)? } else { Vec::new() };
        let rest = std::mem::take(&mut self.sums);
        let energies = self.problem.energies;
        let mut walk = Walk::along(gone);
        for (index, (instant, &at)) in seen.iter().zip(&inside).enumerate() {
            self.sums = sums.get(index).copied().unwrap_or_default();
            let look = if gone.way == Some(Way::Inwards) && gone.edge.is_none() && !energies {
                // What is still in contact does not know of what has left it.
                gone.before.receded(&gone.drive, at)
            } else {
                let line = walk.line(at)?;
                self.line.updates += line.updates.saturating_sub(gone.before.updates);
                self.line.cut = self.line.cut.max(line.cut);
                self.line.joined = self.line.joined.max(line.joined);
                Look::at(line, true, energies)
            };
            self.kept_at(instant, look);
        }
        self.sums = rest;
        Ok(())
    }

    /// Keeps the instants that a time of the interval has reached, as the line is now.
    pub(super) fn keep_reached(&mut self, wanted: &mut &[Wanted], time: f64) {
        while let Some((instant, later)) = wanted.split_first().filter(|(instant, _)| instant.time <= time) {
            *wanted = later;
            self.kept_at(instant, Look::at(&self.line, true, self.problem.energies));
        }
    }

    /// Keeps an instant.
    fn kept_at(&mut self, instant: &Wanted, look: Look) {
        let look = Look { penetration: instant.penetration.unwrap_or(look.penetration), ..look };
        let now = std::mem::replace(&mut self.time, instant.time);
        self.point_of(&look, false);
        self.keep(look.slope);
        self.time = now;
    }
}
