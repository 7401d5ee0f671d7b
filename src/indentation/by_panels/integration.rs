//! The history of a contact, panel by panel.
//!
//! Each panel is solved, checked between its points (the defect, as a position error), and cut at the first event on its polynomial: a
//! corner of the history, a fold (T′ = 0), a turn (s′ = 0), a kink of the line. The step follows the defect alone; there is no limit in δ.

use super::at_once::AtOnce;
use super::check::checked;
use super::checkpoint::PanelObserver;
use super::closure::Window;
use super::cycles::Cycles;
use super::drive::{Branch, DriveSegment};
use super::events::{MERGE, Mark, first_crossing, turning};
use super::followed::{State, solved_with_depth};
use super::jump::FLOOR;
use super::line::{Line, Segment, series};
use super::newton::{Target, solved};
use super::path::{Chart, Points, continued};
use super::problem::{End, Outcome, Problem, Row};
use super::start::{breaks, glassy};
use crate::indentation::EventKind;
use crate::indentation::record::Record;

/// Residual of C over Δγ between points, in tolerances: where an edge creeps it acts as an error of Δγ, however small it is as a position.
const RESIDUAL: f64 = 3.0;
/// Rounding of a time, over it: of a sum of durations.
const ROUNDING_OF_TIME: f64 = 1e-14;
/// Refusals after which nothing fades.
const FADES: u32 = 2;
/// Excess over Δγ that a sudden change of a control makes at least.
const SUDDEN: f64 = 1e-3;
/// Refusals in a row after which the edge sets out anew from its present state, in time.
pub(super) const PATIENCE: u32 = 5;
/// Way of a held edge, in process zones, that is rounding.
const REST: f64 = 1e-9;

/// The state of the integration.
pub(super) struct Integration<'a> {
    pub(super) problem: &'a Problem,
    pub(super) observer: Option<PanelObserver<'a>>,
    pub(super) points: Points,
    pub(super) window: Window,
    pub(super) line: Line,
    /// Which segment of the history comes next, and the branch of the one under way.
    pub(super) upcoming: usize,
    pub(super) branch: Branch,
    /// A sudden step under way.
    pub(super) at_once: Option<AtOnce>,
    /// Kinks of the line.
    pub(super) marks: Vec<Mark>,
    /// Whether the edge advances, and its path so far up to a parameter.
    pub(super) previous: Option<(bool, Segment, f64)>,
    pub(super) span: (Chart, f64),
    /// How far the edge would go until it turns, were its deceleration to last.
    pub(super) to_turn: f64,
    /// How far it has come since it turned or set out, and whether it slows down.
    pub(super) since_turn: f64,
    pub(super) slows: bool,
    /// C − Δγ at the last point, and |∂C/∂a| of the last panel.
    pub(super) start_residual: f64,
    /// ∂C/∂t of the edge at rest where it turned.
    pub(super) start_rate: f64,
    pub(super) stiffness: f64,
    pub(super) refusals: u32,
    pub(super) flips: u32,
    /// Δ and its memory, where it is not given.
    pub(super) state: Option<State>,
    /// Counts corners and jumps.
    pub(super) piece: u32,
    /// C/Δγ − 1 on the last panel, at most.
    pub(super) panel_residual: f64,
    /// Instants wanted, those that come after a segment that ended early moved with it, and how many of them have been met.
    pub(super) instants: Vec<f64>,
    pub(super) met: usize,
    /// The oscillation under way, and the rows of its cycles.
    pub(super) cycles: Option<Cycles>,
    pub(super) rows: Record<'static>,
    /// Panels, accepted or not, before the segment or cycle under way.
    pub(super) budget_from: u64,
    pub(super) outcome: Outcome,
}

impl<'a> Integration<'a> {
    pub(super) fn new(problem: &'a Problem, edge: f64, depth: f64) -> Self {
        let mut line = Line::new(edge, &breaks(&problem.profile, edge));
        if !problem.relaxed {
            glassy(problem, &mut line, depth);
        }
        let still = DriveSegment { control: None, end: depth, duration: 0.0, oscillation: None, segment: 0 };
        let branch = still.branch(0.0, depth, vec![0.0; problem.chain.terms()]);
        let row = Row::default();
        let outcome = Outcome {
            start: row,
            ends: vec![],
            wanted: vec![],
            least_force: row,
            jumps: vec![],
            path: vec![],
            events: vec![],
            surface: None,
            smallest_gap: f64::INFINITY,
            most_segments: 0,
            end: End::Failed,
            panels: 0,
            refused: 0,
            closures: 0,
            kernel_nodes: 0,
            cycles: vec![],
            spreads: vec![],
            shortened: vec![],
        };
        let mut integration = Self {
            problem,
            observer: None,
            points: Points::new(problem.degree),
            window: Window::new(problem.zone),
            line,
            upcoming: 0,
            branch,
            at_once: None,
            marks: vec![Mark { place: 0.0, jump: true }],
            previous: None,
            span: (Chart::TimeOfPlace, 0.0),
            to_turn: f64::INFINITY,
            since_turn: 0.0,
            slows: false,
            start_residual: 0.0,
            start_rate: 0.0,
            stiffness: 0.0,
            refusals: 0,
            flips: 0,
            state: None,
            piece: 0,
            panel_residual: 0.0,
            instants: problem.instants.clone(),
            met: 0,
            cycles: None,
            rows: Record::without_contact(),
            budget_from: 0,
            outcome,
        };
        integration.window.blur = MERGE * problem.tolerance * integration.displacement();
        let row = integration.row(None, 0.0);
        (integration.outcome.start, integration.outcome.least_force) = (row, row);
        integration.record_rest(0.0);
        if !problem.relaxed && problem.adhesion.is_some() {
            integration.event(EventKind::JumpIn, &row);
        }
        integration.begins();
        integration
    }

    /// One panel, accepted or refused; or a jump; or a rest.
    pub(super) fn panel(&mut self) -> Option<End> {
        let zone = self.problem.zone;
        let tolerance = self.problem.tolerance * self.length();
        if self.branch.is_over() {
            return self.next_segment();
        }
        if self.branch.end - self.line.time <= ROUNDING_OF_TIME * self.branch.end {
            // A panel that ended where the segment does, but for rounding.
            self.mark(false);
            return self.next_segment();
        }
        if self.is_prescribed() {
            return self.prescribed();
        }
        if self.previous.is_none() {
            let left = self.branch.end - self.line.time;
            if self.state.is_some() {
                self.balance();
                let excess = self.sudden(0.0);
                if (excess - self.start_residual).abs() > SUDDEN * self.scale() {
                    return self.moves_at_once(excess < 0.0, zone / 16.0, 0.0, None);
                }
            }
            let outset = self.sets_out();
            // Under a force that is held a contact may rest as well, if Δ does.
            let still = self.state.as_ref().is_none_or(|state| state.rate.abs() * left <= REST * self.displacement());
            let held = still && self.branch.is_held();
            // Held, everything relaxes. However little an edge goes it has another K than one that rests: it is followed, down to rounding or where panels end.
            let least = if self.refusals >= PATIENCE && self.state.is_none() { tolerance } else { REST * zone };
            // What is left of a segment may be rounding, if the last panel ended on a kink there.
            let brief = still && left <= REST * (self.branch.end - self.branch.start) && outset.speed.abs() * left <= REST * zone;
            if outset.speed == 0.0 || brief || held && outset.speed.abs() * left <= least || self.is_idle(outset.speed * left) {
                return self.rests(left);
            }
            if held && self.state.is_none() && self.refusals >= PATIENCE && self.stays(left, tolerance) {
                return self.rests(left);
            }
            if !outset.stable {
                return self.jumps(outset.advances, zone / 16.0);
            }
            self.sets(outset, left);
        }
        let (advances, previous, theta) = self.previous.clone()?;
        let (chart, mut span) = self.span;
        let mut floor = false;
        if chart == Chart::TimeOfPlace {
            let (kink, strong, _) = self.next_kink(advances);
            if span.abs() > kink.abs() && (strong || span.abs() < 1e3 * kink.abs()) {
                span = kink;
            } else if span.abs() > 0.6 * kink.abs() && span.abs() < kink.abs() {
                span = 0.5 * kink;
            }
            if let Some(kink) = self.kink_of_shape(span) {
                span = kink;
            }
            let least = if self.problem.adhesion.is_some() { FLOOR * zone - self.line.edge } else { -self.line.edge };
            if span < least {
                (span, floor) = (least, true);
                if least > -1e-9 * zone {
                    return Some(End::Floor);
                }
            }
        }
        let (mut guess, mut depths) = continued(&self.points, &previous, theta, chart, span);
        if chart == Chart::PlaceOfTime {
            // States jump at a strong kink: it is landed on, in place; before that the edge goes on in time as long as it stays clear of it.
            let (kink, strong, _) = self.next_kink(advances);
            let crosses = |guess: &[f64]| strong && guess.iter().any(|s| s / kink >= 1.0);
            if crosses(&guess) {
                let v = previous.place_at(theta).1 / series(&previous.times, theta).1;
                if v * kink > 0.0 && self.to_turn > 1.5 * kink.abs() {
                    self.span = (Chart::TimeOfPlace, kink);
                    return None;
                }
                while crosses(&guess) && span > 0.0 {
                    span *= 0.7;
                    (guess, depths) = continued(&self.points, &previous, theta, chart, span);
                }
            }
        }
        let expected = if chart == Chart::TimeOfPlace { span.abs() } else { guess.iter().fold(0.0_f64, |far, s| far.max(s.abs())) };
        let sign = if advances { 1.0 } else { -1.0 };
        let firmness = (chart == Chart::PlaceOfTime && self.state.is_none() && expected > 0.0)
            .then(|| (self.sudden(sign * expected) - self.sudden(0.0)) / (sign * expected));
        let mut window = std::mem::take(&mut self.window);
        let setting = self.setting(advances);
        // What the last cut left of the closure fades, by a fiftieth of the way at most; beside a turn there is no way to speak of, and
        // where panels are refused C may have become so soft that this bends the path.
        let turns = chart == Chart::PlaceOfTime && self.to_turn < expected || self.refusals > FADES;
        let fades = if turns {
            0.0
        } else if self.start_residual == 0.0 {
            1.0
        } else {
            (0.02 * expected * self.stiffness / self.start_residual.abs()).min(1.0)
        };
        let target = Target { residual: self.start_residual, fades, rate: self.start_rate };
        let wanted = (5e-3 * tolerance).min(1e-3 * expected.max(1e-300));
        let points = &self.points;
        let panel = match self.branch.control {
            None => solved(points, &mut window, &setting, (chart, span), guess, (target, wanted), firmness),
            Some(control) => {
                let value = |time: f64| self.target(time).0;
                solved_with_depth(points, &mut window, &setting, (control, &value), (chart, span), (guess, depths), (target, wanted))
            }
        };
        let checked = panel.as_ref().map(|panel| checked(&self.points, &mut window, &setting, panel, (target, tolerance)));
        self.window = window;
        let (Some(panel), Some(checked)) = (panel, checked) else {
            let beside_turn = self.since_turn == 0.0 || self.slows && self.to_turn < 0.1 * tolerance;
            if chart == Chart::PlaceOfTime && beside_turn && self.refusals >= FADES && self.lingers(span, tolerance) {
                self.outcome.refused += 1;
                return None;
            }
            return self.refuses(span, 0.3, sign * expected);
        };
        let least = tolerance.min(RESIDUAL * self.problem.tolerance * self.scale() / panel.stiffness);
        // A motion that its error could have made is none.
        let added = target.added(span) / panel.stiffness;
        let error = (checked.defect / least.min(0.02 * checked.way.max(1e-300))).max(panel.tail.max(added) / least);
        let factor = (0.85 * (1.0 / error.max(1e-300)).powf(1.0 / (self.points.p as f64 + 1.0))).clamp(0.3, 3.0);
        if error > 1.0 {
            return self.refuses(span, factor.min(0.9), sign * expected);
        }
        if !checked.first {
            return self.refuses(span, 0.3, sign * expected);
        }
        if chart == Chart::PlaceOfTime {
            let (kink, strong, _) = self.next_kink(advances);
            if let Some(x) = first_crossing(|x| panel.segment.place_at(x).0 / kink - 1.0).filter(|_| strong) {
                return self.refuses(span, (0.45 * (x + 1.0)).max(0.1), 0.0);
            }
        }
        // The wrong way from the start: at once, or by the end with no turn on the way.
        let against = |x: f64| sign * panel.segment.place_at(x).0 < 0.0;
        let turns = || turning(|x| -sign * panel.segment.place_at(x).1).is_some();
        if chart == Chart::PlaceOfTime && (against(self.points.nodes[1]) || against(1.0) && !turns()) {
            // It turned where the last panel ended, or did not turn there after all: the same span the other way, once; then less.
            self.flips += 1;
            if self.flips > 1 {
                self.flips = 0;
                return if self.lingers(span, tolerance) { None } else { self.refuses(span, 0.3, 0.0) };
            }
            self.previous = Some((!advances, previous, theta));
            self.mark(false);
            return None;
        }
        let left = checked.defect * panel.stiffness + self.start_residual.abs();
        self.panel_residual = left.max(panel.end_residual.abs()) / self.scale();
        self.outcome.panels += 1;
        (self.refusals, self.flips) = (0, 0);
        self.stiffness = panel.stiffness;
        (self.start_residual, self.start_rate) = (panel.end_residual, 0.0);
        self.accept(advances, panel, factor, floor)
    }
}
