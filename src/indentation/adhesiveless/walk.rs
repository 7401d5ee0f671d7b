//! Looks at a line one after the other along a drive that has been gone: a later one goes on from what an earlier one found.

use super::drive::Drive;
use super::edge::Way;
use super::grid::GRID;
use super::ledger::Gone;
use super::line::Line;
use super::moment::Moment;
use super::path_history::Earlier;
use crate::refusal::Refusal;

/// Intervals that are gone on with, at most: each look adds one of its own, however short, and all of them are looked at.
const MOST_INTERVALS: usize = 24;

/// Looks along a drive.
pub(super) struct Walk<'w, 'g, 'a> {
    gone: &'w Gone<'g, 'a>,
    line: Line<'a>,
    /// The last look, and how many intervals the edge has passed there.
    last: Option<(Moment, usize)>,
}

impl<'w, 'g, 'a> Walk<'w, 'g, 'a> {
    pub(super) fn along(gone: &'w Gone<'g, 'a>) -> Self {
        Self { gone, line: gone.before.clone(), last: None }
    }

    /// The line at a time.
    pub(super) fn line(&mut self, time: f64) -> Result<&Line<'a>, Refusal> {
        let (gone, way) = (self.gone, self.gone.way.filter(|_| time > 0.0));
        let earlier = way.and_then(|way| self.earlier(time, way));
        self.line.becomes(gone.before);
        if let Some(way) = way {
            self.last = Some(self.line.passed(&gone.drive, time, way, gone.edge.as_ref(), earlier)?);
        } else if time > 0.0 {
            self.line.pass_nothing(&gone.drive.until(time));
        }
        Ok(&self.line)
    }

    /// What the last look found, if a later one can go on from there.
    fn earlier(&mut self, time: f64, way: Way) -> Option<Earlier> {
        let (end, count) = self.last.take().filter(|(end, count)| end.time <= time && *count <= MOST_INTERVALS)?;
        let place = self.line.radius();
        let intervals = match way {
            Way::Inwards => self.line.free.drain(..count.min(self.line.free.len())).collect(),
            Way::Outwards => self.line.contact.split_off(self.line.contact.len().saturating_sub(count)),
        };
        Some(Earlier { end, place, intervals })
    }

    /// F at a time.
    pub(super) fn force(&mut self, time: f64) -> Result<f64, Refusal> {
        Ok(self.at(time, false)?.0)
    }

    /// F and P_d at a time; P_d only where energies are asked for.
    pub(super) fn at(&mut self, time: f64, energies: bool) -> Result<(f64, f64), Refusal> {
        let gone = self.gone;
        if let (false, Some(force)) = (energies, gone.force) {
            return Ok((force(time), 0.0));
        }
        if !energies && gone.edge.is_none() && gone.way != Some(Way::Outwards) {
            let force = match gone.way {
                Some(_) => gone.before.receded(&gone.drive, time).force,
                None => gone.before.pressing_after(&gone.drive, time),
            };
            return Ok((force, 0.0));
        }
        let line = self.line(time)?;
        let power = if energies { line.energies()[1] } else { 0.0 };
        Ok((gone.force.map_or_else(|| line.force(), |force| force(time)), power))
    }
}

impl Line<'_> {
    /// F of what is in contact, a time along a drive in which the edge rests.
    fn pressing_after(&self, drive: &Drive, time: f64) -> f64 {
        let mut moment = Moment::default();
        moment.set(self.chain, drive, time);
        let sum: f64 = self.contact.iter().map(|interval| interval.width() * GRID.integral(&self.pressed(interval, &moment))).sum();
        2.0 * self.chain.glassy * sum
    }
}
