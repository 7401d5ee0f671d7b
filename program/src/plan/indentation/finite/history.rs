//! The history of a scene as legs of the solver, with the instants that become rows.

use super::super::scale::Scale;
use super::super::timeline::{Leg, Timeline};
use super::scales::Reduced;
use crate::scene::typed::{HistoryQuantity, Indentation, IndentationStart};
use viscotack::finite_range::sphere::{self, Control, Motion, Problem, Start};
use viscotack::indentation::Oscillation;

/// Two rates nearer than this, relative, are one.
const SAME_RATE: f64 = 1e-9;

/// A leg of the solver: instants of one pace, or an oscillation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    pub(super) leg: sphere::Leg,
    /// Times inside it that are rows.
    pub(super) instants: Vec<f64>,
    /// When it ends.
    pub(super) end: f64,
    pub(super) segment: usize,
    quantity: HistoryQuantity,
    /// Where it starts, if that is known.
    from: Option<f64>,
    /// Whether it ends where it starts.
    held: bool,
}

impl Piece {
    /// Whether what is imposed changes.
    pub(super) fn moves(&self) -> bool {
        !(self.held && matches!(self.leg.motion, Motion::Ramp { .. }))
    }
}

/// All of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Course {
    pub(super) start: Start,
    pub(super) pieces: Vec<Piece>,
    /// The instant at the start of the history, and that at the end of each of its legs.
    pub(super) boundaries: Vec<usize>,
    /// Times of surfaces, coherent.
    pub(super) surfaces: Vec<f64>,
}

impl Course {
    pub(super) fn new(indentation: &Indentation, timeline: &Timeline, reduced: &Reduced, scale: &Scale) -> Self {
        let control = |quantity: HistoryQuantity| match quantity {
            HistoryQuantity::Force => Control::Force,
            HistoryQuantity::Frame => {
                // Scenes that control a frame have one.
                let stiffness = indentation.frame_stiffness.unwrap_or(f64::INFINITY) * scale.force;
                Control::Frame(stiffness * reduced.scales.gap / reduced.scales.force)
            }
            _ => Control::Penetration,
        };
        let (quantity, value) = timeline.start;
        let relaxed = indentation.start == IndentationStart::Relaxed;
        let start = match (control(quantity), reduced.imposed(quantity, value)) {
            (Control::Penetration, depth) if relaxed => Start::Relaxed(depth),
            (Control::Penetration, depth) => Start::Unstrained(depth),
            (control, value) => Start::Held { control, value, relaxed },
        };
        let mut pieces: Vec<Piece> = Vec::new();
        let mut boundaries = vec![0];
        let mut ended = |instants: usize| boundaries.push(boundaries.last().copied().unwrap_or(0) + instants);
        let mut time = 0.0;
        let mut here = Some((quantity, value));
        for leg in &timeline.legs {
            let from = here.filter(|(held, _)| *held == leg.quantity).map(|(_, value)| value);
            let begin = time;
            time += leg.duration;
            here = Some((leg.quantity, leg.end));
            let to = reduced.imposed(leg.quantity, leg.end);
            if let Some(oscillation) = leg.oscillation {
                let amplitude = reduced.change(leg.quantity, oscillation.amplitude);
                let swing = Oscillation { amplitude, ..oscillation };
                let motion = Motion::Swing { to, duration: leg.duration, oscillation: swing };
                let instants = instants_of_a_swing(indentation.instants, &swing, begin, leg.duration);
                let solver_leg = sphere::Leg { control: control(leg.quantity), motion };
                ended(instants.len() + 1);
                pieces.push(Piece {
                    leg: solver_leg,
                    instants,
                    end: time,
                    segment: leg.segment,
                    quantity: leg.quantity,
                    from: None,
                    held: false,
                });
                here = Some((leg.quantity, leg.end + oscillation.deviation(leg.duration, leg.duration)));
                continue;
            }
            let goes_on = pieces.last_mut().filter(|piece| continues(piece, leg, from));
            if let Some(piece) = goes_on {
                piece.instants.push(begin);
                ended(1);
                piece.end = time;
                if let Motion::Ramp { to: end, duration } = &mut piece.leg.motion {
                    (*end, *duration) = (to, *duration + leg.duration);
                }
                continue;
            }
            // What begins where only the solver knows is one leg: its rows are evenly spread.
            let open = from.is_none() && leg.duration > 0.0;
            let count = if open { indentation.instants } else { 1 };
            let instants: Vec<f64> = (1..count).map(|k| begin + leg.duration * f64::from(k) / f64::from(count)).collect();
            ended(instants.len() + 1);
            let motion = Motion::Ramp { to, duration: leg.duration };
            let solver_leg = sphere::Leg { control: control(leg.quantity), motion };
            pieces.push(Piece {
                leg: solver_leg,
                instants,
                end: time,
                segment: leg.segment,
                quantity: leg.quantity,
                from,
                held: from.is_some_and(|from| from.to_bits() == leg.end.to_bits()),
            });
        }
        let surfaces = indentation.fields.iter().flat_map(|fields| &fields.times).map(|time| time / indentation.speed_factor);
        Self { start, pieces, boundaries, surfaces: surfaces.map(|wanted| wanted.min(time)).collect() }
    }

    /// What the solver is asked.
    pub(super) fn problem(&self, reduced: &Reduced) -> Problem {
        Problem {
            law: reduced.law.law.clone(),
            tabor: reduced.scales.tabor,
            shape: reduced.shape.clone(),
            rim: reduced.rim,
            creep: reduced.creep.clone(),
            start: self.start,
            history: self.pieces.iter().map(|piece| piece.leg).collect(),
            instants: self.pieces.iter().flat_map(|piece| piece.instants.iter().copied()).collect(),
            surfaces: self.surfaces.clone(),
        }
    }
}

/// Whether a leg goes on at the pace of a piece.
fn continues(piece: &Piece, leg: &Leg, from: Option<f64>) -> bool {
    let (Motion::Ramp { duration, .. }, Some(start), Some(from)) = (piece.leg.motion, piece.from, from) else { return false };
    if piece.segment != leg.segment || piece.quantity != leg.quantity || duration == 0.0 || leg.duration == 0.0 {
        return false;
    }
    let (before, after) = ((from - start) / duration, (leg.end - from) / leg.duration);
    (before - after).abs() <= SAME_RATE * before.abs().max(after.abs())
}

/// Even instants: over all cycles if there are enough for each, else over the last one; none if fewer than twelve.
fn instants_of_a_swing(count: u32, oscillation: &Oscillation, begin: f64, duration: f64) -> Vec<f64> {
    const INSTANTS_PER_CYCLE: f64 = 12.0;
    let cycles = oscillation.cycles_at(duration, duration);
    if f64::from(count) < INSTANTS_PER_CYCLE {
        return Vec::new();
    }
    let first = if f64::from(count) >= INSTANTS_PER_CYCLE * cycles { 0.0 } else { cycles.floor() - 1.0 };
    let last = if first == 0.0 { cycles } else { cycles.floor() };
    (0..=count)
        .filter_map(|k| oscillation.time_of(first + (last - first) * f64::from(k) / f64::from(count), duration))
        .map(|since| begin + since)
        .filter(|time| *time > begin && *time < begin + duration * (1.0 - 1e-12))
        .collect()
}
