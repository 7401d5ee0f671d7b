//! Along a stretch of the history, drive after drive.

use super::course::Course;
use super::drive::{Drive, Wave};
use super::edge::Ended;
use crate::indentation::stretch::Stretch;
use crate::refusal::Refusal;
use std::f64::consts::TAU;

/// Turns and losses of one drive, at most.
const MOST_TURNS: u32 = 100_000;
/// Longest time of one drive of an oscillation (cycles), and of one whose frequency changes.
const LONGEST_OF_CYCLE: f64 = 0.25;
const LONGEST_OF_SWEEP: f64 = 1.0 / 24.0;
/// Halvings of the time to where a contact is lost or found, of points of a cycle.
const NEARER: i32 = 14;
/// Touches of one drive that are looked at so nearly: more are rounding, of a surface that is only grazed.
const MOST_TOUCHES: u32 = 3;

impl Course<'_> {
    /// The next part of a stretch, as a drive of its own quantity.
    pub(super) fn drive(&self, stretch: &Stretch, target: f64) -> Drive {
        let from = self.time;
        let Some(oscillation) = stretch.segment.oscillation else {
            return Drive::straight(stretch.value(from), stretch.value(target), target - from);
        };
        let duration = stretch.segment.duration;
        let swept = oscillation.frequency.to_bits() != oscillation.end_frequency.to_bits();
        let longest = if swept { LONGEST_OF_SWEEP } else { LONGEST_OF_CYCLE } / oscillation.frequency_at(from, duration);
        let target = if from + longest < target { from + longest } else { target };
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

    /// Goes along a drive of the penetration.
    pub(super) fn along(&mut self, drive: &Drive) -> Result<(), Refusal> {
        let end = self.time + drive.duration;
        let mut drive = *drive;
        if drive.start.to_bits() != self.line.penetration.to_bits() {
            self.line.leap(drive.start)?;
        }
        // Where the contact is lost or found F goes with a root of the time: points of a cycle come nearer and nearer.
        let graded = self.meter.is_some();
        let (mut nearer, mut touches) = (0, 0);
        for _ in 0..MOST_TURNS {
            self.evaluations += 1;
            let part = if nearer > 0 { drive.until(drive.duration * 0.5_f64.powi(nearer)) } else { drive };
            let before = graded.then(|| self.line.clone());
            let (time, ended) = self.line.go(&part)?;
            let rest = drive.duration - time;
            self.time = if rest > 0.0 { end - rest } else { end };
            match ended {
                Ended::Whole if nearer == 0 => {
                    self.time = end;
                    return Ok(());
                }
                Ended::Whole => {
                    nearer -= 1;
                    self.point(false);
                }
                Ended::Touched if touches >= MOST_TOUCHES => {}
                Ended::Touched => {
                    touches += 1;
                    self.turned();
                    self.record.new_piece();
                    self.corner();
                    nearer = if graded { NEARER } else { 0 };
                }
                Ended::Turned => self.turned(),
                Ended::Lost => {
                    if let Some(before) = before.filter(|_| time > 0.0 && touches < MOST_TOUCHES) {
                        self.line = before;
                        self.time = end - drive.duration;
                        self.towards_loss(&drive.until(time))?;
                        self.time = if rest > 0.0 { end - rest } else { end };
                    }
                    self.lost();
                }
            }
            if rest <= 4.0 * f64::EPSILON * drive.duration {
                self.line.leap(drive.end())?;
                self.time = end;
                return Ok(());
            }
            drive = drive.rest(time);
        }
        Err(Refusal::NotConverged { what: "the edge", detail: format!("turns again and again at t = {:e}", self.now()) })
    }
    /// Points nearer and nearer to the end of a drive, at which the contact is lost.
    fn towards_loss(&mut self, drive: &Drive) -> Result<(), Refusal> {
        let start = self.time;
        let mut drive = *drive;
        let whole = drive.duration;
        for _ in 0..NEARER {
            let half = 0.5 * drive.duration;
            let (_, ended) = self.line.go(&drive.until(half))?;
            if ended != Ended::Whole {
                break;
            }
            drive = drive.rest(half);
            self.time = start + (whole - drive.duration);
            self.point(false);
        }
        self.line.go(&drive)?;
        self.line.release_all();
        Ok(())
    }
}
