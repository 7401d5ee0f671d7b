//! What an indentation is expected to cost: the one place to tune when the solver changes.

use super::IndentationPlan;
use super::cycles::MOST_ROWS as MOST_CYCLE_ROWS;
use super::timeline::Leg;
use crate::outcome::Work;
use crate::scene::typed::{HistoryQuantity, IndentationShape};
use viscotack::material::RelaxationTerm;

/// Balances of a history without instants to land on, and of each such instant, at an accuracy of 1e-3.
const HISTORY: f64 = 1220.0;
const INSTANT: f64 = 27.0;
/// Further balances for each decade between the relaxation times, relative: after each corner time steps grow through all of them.
const DECADE: f64 = 0.35;
/// Power of the accuracy that balances grow with.
const ORDER: f64 = 0.25;
/// Points of the line updated for a balance, and relative growth with the square of the decades: the finer the layers behind the edge.
const UPDATES: f64 = 200.0;
const LAYERS: f64 = 0.12;

/// The same where a force or a frame is imposed: Δ is found as well, from two loads.
const LOADED: f64 = 2.0;

/// Balances of a cycle at an accuracy of 1e-2 where an edge moves, and power of the accuracy they grow with.
const CYCLE: f64 = 2600.0;
const CYCLE_ORDER: f64 = 0.25;
/// Points of the line updated for a balance of a first cycle: they grow with the root of the cycles, as each turn of the edge leaves a layer.
const CYCLE_UPDATES: f64 = 330.0;
/// The same where the rim of a punch holds the edge: a few panels.
const HELD_CYCLE: f64 = 60.0;
const HELD_CYCLE_ORDER: f64 = 0.4;
const HELD_UPDATES: f64 = 32.0;
/// The same outside cycles, where the edge may leave the rim.
const HELD_HISTORY_UPDATES: f64 = 110.0;
/// Cycles until they are stationary: the first few, and those in which what a slow term still changes, over the modulus, falls to the accuracy; with many terms the
/// root of the longest memory counts if it is more.
const STATIONARY: f64 = 3.0;
const SETTLING: f64 = 0.06;
const MANY_TERMS: f64 = 2.0;

/// Balances of a periodic state at an accuracy of 1e-4, power of the accuracy they grow with, and points of the line for each.
const PERIODIC: f64 = 60_000.0;
const PERIODIC_ORDER: f64 = 0.25;
const PERIODIC_UPDATES: f64 = 120.0;

/// Without steps in time: moves of both courses for each segment, and where something else than the penetration is given; moves of a cycle of the penetration, or of
/// something else; cycles of the longest memory until each is the last one; points of the line updated for a move.
const MOVES: f64 = 2.0;
const LOADED_MOVES: f64 = 22.0;
const CYCLE_MOVES: f64 = 20.0;
const LOADED_CYCLE_MOVES: f64 = 90.0;
const REPEATING: f64 = 20.0;
const MOVE_UPDATES: f64 = 66.0;
/// Power of the relaxation times that they grow with: strains of more times are cut more finely. The points of a table cut the line, too.
const OF_TERMS: f64 = 0.67;
const OF_TABLE: f64 = 3.0;
/// Points of the line updated by both courses for an instant on the way, and how many times as many where energies are added up between instants.
const LOOK_UPDATES: f64 = 100.0;
const OF_ENERGIES: f64 = 2.0;
/// The same where the rim of a punch holds the edge: moves of few points.
const HELD_CYCLE_MOVES: f64 = 24.0;
const HELD_MOVE_UPDATES: f64 = 22.0;

/// No prediction is larger.
const MOST: f64 = 1e11;

/// Rows of events besides instants and cycles.
const EVENTS: u64 = 64;
/// Memory of a point of the path in all integrations that assess each other, and of the line with its trials (bytes).
const POINT_OF_THE_PATH: u64 = 900;
const LINE: u64 = 3 << 20;
/// Memory of a cycle in all integrations (bytes), and most cycles that are held.
const CYCLE_HELD: u64 = 2000;
const MOST_CYCLES: u64 = 4096;
/// Most points of a path that are held, as `indentation::record` has it, and points for each predicted balance.
const MOST_POINTS: u64 = 40_000;
const POINTS_A_BALANCE: u64 = 1;

impl IndentationPlan {
    /// Rows of a state, at most.
    pub(super) fn most_rows(&self) -> u64 {
        let instants = u64::from(self.indentation.instants);
        let cycles: f64 = self.timeline.legs.iter().map(Leg::cycles).sum();
        let fields = self.indentation.fields.as_ref().map_or(0, |fields| fields.times.len() as u64);
        let swings = if self.timeline.oscillates() { instants + (cycles.ceil() as u64).min(MOST_CYCLE_ROWS as u64) } else { 0 };
        self.timeline.legs.len() as u64 + instants * self.timeline.open_ramps.len() as u64 + swings + fields + EVENTS + 1
    }

    /// Memory of a state besides its rows (bytes), at most: paths are thinned, and the line is coarsened, so neither grows with the length of a history.
    pub(super) fn most_memory(&self) -> u64 {
        let kept = self.timeline.legs.len() as u64;
        // Of oscillations every path comes to its most points.
        let points = if self.timeline.oscillates() {
            MOST_POINTS
        } else {
            MOST_POINTS.min(POINTS_A_BALANCE * self.work_of_a_state().closure_evaluations)
        };
        let cycles: f64 = self.timeline.legs.iter().map(Leg::cycles).sum();
        LINE + POINT_OF_THE_PATH * (points + kept) + CYCLE_HELD * (cycles.ceil() as u64).min(MOST_CYCLES)
    }

    /// Expected balances and updates of all cycles.
    fn work_of_cycles(&self) -> (f64, f64) {
        let expected = |leg: &Leg| match leg.oscillation {
            Some(oscillation) if oscillation.until_stationary => leg.cycles().min(self.cycles_until_stationary(oscillation.frequency)),
            _ => leg.cycles(),
        };
        let cycles: f64 = self.timeline.legs.iter().map(expected).sum();
        let finer = 1e-2 / self.solver_accuracy;
        if matches!(self.indentation.shape, IndentationShape::FlatPunch { .. }) {
            let balances = cycles * HELD_CYCLE * finer.powf(HELD_CYCLE_ORDER);
            return (balances, balances * HELD_UPDATES);
        }
        let balances = cycles * CYCLE * finer.powf(CYCLE_ORDER);
        (balances, balances * CYCLE_UPDATES * cycles.sqrt())
    }

    /// Expected cycles until they are stationary: each term settles by its own memory, and a slow one changes little in a cycle.
    fn cycles_until_stationary(&self, frequency: f64) -> f64 {
        let of_term = |term: &RelaxationTerm| {
            let (share, memory) = (term.modulus / self.material.glassy_modulus(), frequency * term.relaxation_time);
            let settling = memory * (SETTLING * share / (memory * self.solver_accuracy)).ln();
            settling.max(MANY_TERMS * memory.sqrt())
        };
        STATIONARY + self.material.relaxation_terms().iter().map(of_term).fold(0.0, f64::max)
    }

    /// Expected moves and updates without steps in time.
    fn work_of_moves(&self) -> (f64, f64) {
        let longest = self.material.longest_relaxation_time().unwrap_or(0.0);
        let held = self.profile.rim().is_finite() && self.timeline.oscillates();
        let cut = if matches!(self.indentation.shape, IndentationShape::Table { .. }) { OF_TABLE } else { 1.0 };
        let terms = self.material.relaxation_terms().len().max(1) as f64;
        let updates = if held { HELD_MOVE_UPDATES } else { MOVE_UPDATES * cut * terms.powf(OF_TERMS) };
        let instants = f64::from(self.indentation.instants.max(1));
        let (mut looks, of_look) = (0.0, LOOK_UPDATES * if self.indentation.energies { OF_ENERGIES } else { 1.0 });
        let moves: f64 = self
            .timeline
            .legs
            .iter()
            .map(|leg| match leg.oscillation {
                Some(oscillation) => {
                    let memory = oscillation.frequency * longest;
                    let repeated = if oscillation.until_stationary {
                        self.cycles_until_stationary(oscillation.frequency)
                    } else {
                        STATIONARY + REPEATING * memory
                    };
                    let cycle = match leg.quantity {
                        _ if held => HELD_CYCLE_MOVES,
                        HistoryQuantity::Penetration => CYCLE_MOVES,
                        _ => LOADED_CYCLE_MOVES,
                    };
                    cycle * leg.cycles().min(repeated)
                }
                // At one pace from instant to instant.
                None => {
                    looks += of_look;
                    (if leg.quantity == HistoryQuantity::Penetration { MOVES } else { LOADED_MOVES }) / instants
                }
            })
            .sum();
        (moves, moves * updates + looks * cut)
    }

    /// Expected work of one state.
    pub(super) fn work_of_a_state(&self) -> Work {
        let (balances, updates) = if self.without_steps { self.work_of_moves() } else { self.work_of_an_integration() };
        let fields = self.indentation.fields.as_ref().map_or(0, |fields| u64::from(fields.points) * fields.times.len() as u64);
        Work {
            closure_evaluations: balances.min(MOST).ceil() as u64,
            kernel_evaluations: updates.min(MOST).ceil() as u64,
            field_evaluations: fields,
            ..Work::default()
        }
    }

    /// Expected balances and updates of a periodic state, by panels.
    fn work_of_a_periodic_state(&self) -> (f64, f64) {
        let balances = PERIODIC * (1e-4 / self.solver_accuracy).powf(PERIODIC_ORDER);
        (balances, balances * PERIODIC_UPDATES)
    }

    /// Expected balances and updates of all integrations of a state.
    fn work_of_an_integration(&self) -> (f64, f64) {
        if self.timeline.periodic {
            return self.work_of_a_periodic_state();
        }
        let times = self.material.relaxation_terms().iter().map(|term| term.relaxation_time);
        let (shortest, longest) = times.fold((f64::INFINITY, 0.0_f64), |(low, high), time| (low.min(time), high.max(time)));
        let decades = if longest > 0.0 { (longest / shortest).log10() } else { 0.0 };
        let balances =
            (HISTORY + INSTANT * self.timeline.legs.len() as f64) * (1.0 + DECADE * decades) * (1e-3 / self.solver_accuracy).powf(ORDER);
        // More than any integration may do; a product with the states of a sweep must stay a number.
        let balances = balances.min(MOST);
        let by_load = self.timeline.legs.iter().any(|leg| matches!(leg.quantity, HistoryQuantity::Force | HistoryQuantity::Frame));
        let each = UPDATES * if by_load { LOADED } else { 1.0 };
        // A rim that holds the edge leaves no layers.
        let punch = matches!(self.indentation.shape, IndentationShape::FlatPunch { .. });
        let (each, layers) = if punch { (HELD_HISTORY_UPDATES, 0.0) } else { (each, LAYERS) };
        let updates = (balances * each * (1.0 + layers * decades * decades)).min(MOST);
        let (cycle_balances, cycle_updates) = self.work_of_cycles();
        (balances + cycle_balances, updates + cycle_updates)
    }
}
