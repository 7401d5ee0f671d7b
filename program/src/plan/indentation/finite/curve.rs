//! The way of an indenter that attracts at a distance by one run, without bounds: what a fit compares with data.

use super::super::curve::{columns, row};
use super::FiniteRangePlan;
use crate::plan::path_curve::PathCurve;
use crate::plan::state_watch::StateWatch;
use viscotack::finite_range::sphere::{Accuracy, Jump, Mesher, Record, Run, run_watched};
use viscotack::refusal::Refusal;

/// Points of a run in the order of time: time, penetration, force and contact radius in the units of the solver.
#[derive(Default)]
struct Points {
    states: Vec<[f64; 4]>,
    /// Smooth piece of each point.
    pieces: Vec<u32>,
    piece: u32,
}

impl Points {
    fn add(&mut self, state: [f64; 4]) {
        self.states.push(state);
        self.pieces.push(self.piece);
    }
}

/// The steps of a run; before the landing of each jump the state that it begins in. Legs and jumps end a piece.
fn points(run: &Run) -> Points {
    let mut points = Points::default();
    let (mut legs, mut jumps) = (run.legs.iter().peekable(), run.jumps.iter().peekable());
    for row in &run.rows {
        let lands = |jump: &&&Jump| jump.time <= row.time && jump.radius_after.to_bits() == row.contact_radius.to_bits();
        let landed = jumps.peek().filter(lands).copied().copied();
        if let Some(jump) = landed {
            jumps.next();
            points.add([jump.time, jump.penetration, jump.force_before, jump.radius_before]);
            points.piece += 1;
        }
        points.add([row.time, row.penetration, row.force, row.contact_radius]);
        let ended = legs.peek().is_some_and(|leg| leg.end == *row);
        if ended {
            legs.next();
        }
        if ended || landed.is_some() {
            points.piece += 1;
        }
    }
    points
}

impl FiniteRangePlan {
    /// The way at a tolerance.
    pub(super) fn way(&self, tolerance: f64) -> Result<PathCurve, Refusal> {
        let watch = StateWatch::new(0, None, &|_| ());
        if let Some(resolved) = self.resolved(&watch)? {
            return resolved.way(tolerance);
        }
        let accuracy = Accuracy::of_law(tolerance, &self.reduced.law);
        let run = run_watched(&self.problem()?, accuracy, &mut Mesher::new(accuracy.order), &mut |_| {})?;
        let units = &self.reduced.scales;
        let shown = |[time, penetration, force, radius]: [f64; 4]| {
            let depth = self.reduced.penetration(penetration, 0.0).value;
            row([time, depth, force * units.force, radius * units.radius], self.indentation.frame_stiffness, &self.scale)
        };
        let points = points(&run);
        let touching = |state: &[f64; 4]| state[3] > 0.0;
        let states = &points.states;
        let contact = states.iter().position(touching).zip(states.iter().rposition(touching)).map(|(first, last)| [first, last]);
        let of_record = |record: &Record| shown([record.time, record.penetration, record.force, record.contact_radius]);
        let open = states.last().is_some_and(|state| state[3] == 0.0);
        let lost = run.detachment.as_ref().or_else(|| run.losses.last().filter(|_| open)).map(of_record);
        // Of a surface that comes nearer without a jump there is no such place.
        let into = run.jumps.iter().find(|jump| jump.radius_before == 0.0 && jump.radius_after > 0.0);
        let gained = into.map(|jump| shown([jump.time, jump.penetration, jump.force_before, jump.radius_before]));
        let rows: Vec<Vec<f64>> = states.iter().copied().map(shown).collect();
        Ok(PathCurve { columns: columns(&rows), pieces: points.pieces, contact, gained, lost, at_a_distance: true })
    }
}
