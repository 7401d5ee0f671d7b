//! How an edge sets out from rest, a corner of the history or a kink of the line: its direction, its speed and its stability, in frozen time.
//!
//! ```text
//! da/dt = −(∂C/∂t)/(∂C/∂a),      ∂C/∂a by one-sided differences of C for an edge moved at once (its passages take no time)
//! ```
//! ∂C/∂t < 0: the edge advances, else it recedes. ∂C/∂a ≤ 0 in that direction: it is unstable, and jumps.

use super::closure::Way;
use super::drive::Instant;
use super::followed::State;
use super::force::force_rate;
use super::integration::{Integration, PATIENCE};
use super::line::Segment;
use super::path::{Chart, passed};

/// How an edge sets out.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outset {
    pub(super) advances: bool,
    pub(super) speed: f64,
    pub(super) stable: bool,
}

/// Way of a first panel over δ and the fourth root of the tolerance: paths that all start alike would err alike.
const FIRST_WAY: f64 = 0.3;
/// Part of the tolerance that a rest beside a turn may leave.
const LINGER: f64 = 0.3;
/// Halvings of such a rest.
const MOST_HALVINGS: u32 = 40;
/// Change of speed at a kink that a panel's prediction still carries.
const SAME_SPEED: f64 = 0.3;

impl Integration<'_> {
    /// C − Δγ at the edge now, moved at once by a way (a panel without duration); Δ follows if it is not given.
    pub(super) fn sudden(&mut self, way: f64) -> f64 {
        let mut window = std::mem::take(&mut self.window);
        let advances = way > 0.0 || way == 0.0 && self.previous.as_ref().is_some_and(|previous| previous.0);
        let setting = self.setting(advances);
        let mut now = Instant::default();
        setting.still(&mut now);
        let panel = (way != 0.0).then(|| passed(&self.points, &setting, Chart::TimeOfPlace, way, &vec![0.0; self.points.p + 1], &[]));
        let way = panel.as_ref().map(|panel| Way { panel, advances, theta: 1.0 });
        let shift = setting.imbalance(way, &now);
        setting.shift(&mut now, shift);
        let value = setting.excess(&mut window, way, &now, false).value;
        self.window = window;
        value
    }

    /// The value that a control is to have at a time since the origin, and its rate.
    pub(super) fn target(&self, time: f64) -> (f64, f64) {
        self.branch.value(self.line.time - self.branch.start + time)
    }

    /// Δ as the control has it, the edge where it is.
    pub(super) fn balance(&mut self) {
        let mut now = Instant::default();
        let setting = self.setting(false);
        setting.still(&mut now);
        let shift = setting.imbalance(None, &now);
        let chain = &self.problem.chain;
        if let Some(state) = &mut self.state {
            state.shift(chain, shift);
        }
    }

    /// The rate of a Δ that follows, of an edge at rest.
    fn follow(&mut self) {
        let (Some(control), Some(state)) = (self.branch.control, &mut self.state) else { return };
        state.rate = 0.0;
        let chain = &self.problem.chain;
        let mut now = Instant::default();
        self.setting(false).still(&mut now);
        // dF/dt while Δ rests: of a field as its own rate.
        let relaxing = force_rate((chain, &self.problem.profile), &self.line, &now);
        let firmness = control.force * 2.0 * chain.glassy * self.line.edge + control.depth;
        let rate = (self.target(0.0).1 - control.force * relaxing) / firmness;
        if let Some(state) = &mut self.state {
            state.rate = rate;
        }
    }

    /// ∂C/∂t now, the edge at rest; without adhesion of an edge that advances or recedes.
    pub(super) fn rate(&mut self, advances: bool) -> f64 {
        self.follow();
        let mut window = std::mem::take(&mut self.window);
        let setting = self.setting(advances);
        let mut now = Instant::default();
        setting.still(&mut now);
        let rate = setting.excess(&mut window, None, &now, true).rate;
        self.window = window;
        rate
    }

    /// Direction, da/dt, and whether an edge that sets out is stable.
    pub(super) fn sets_out(&mut self) -> Outset {
        let outwards = self.rate(true);
        let advances = outwards < 0.0;
        let rate = if advances || self.problem.adhesion.is_some() { outwards } else { self.rate(false).max(0.0) };
        let small = 1e-3 * self.problem.zone * if advances { 1.0 } else { -1.0 };
        let [near, far] = [small, 2.0 * small].map(|way| self.sudden(way));
        // Without adhesion the two sides have a condition each, and both hold.
        let here = if self.problem.adhesion.is_some() { self.sudden(0.0) } else { 0.0 };
        let by_edge = if self.line.edge < small { near / small } else { (4.0 * near - 3.0 * here - far) / (2.0 * small) };
        Outset { advances, speed: -rate / by_edge, stable: by_edge > 0.0 }
    }

    /// The first panel of an edge that sets out.
    pub(super) fn sets(&mut self, outset: Outset, left: f64) {
        let zone = self.problem.zone;
        let Outset { advances, speed, .. } = outset;
        // It sets out with a speed: no turn is behind it.
        self.since_turn = f64::INFINITY;
        self.start_rate = 0.0;
        let way = FIRST_WAY * self.problem.tolerance.powf(0.25) * zone * speed.signum();
        let duration = way / speed;
        // An edge that hardly goes in the time left is followed in time, and one of which panels in place are refused: it may turn at once.
        let in_time = duration > 0.5 * left || self.refusals >= PATIENCE;
        self.span = if in_time { (Chart::PlaceOfTime, 0.1 * left.min(duration)) } else { (Chart::TimeOfPlace, way) };
        let follows = |state: &State| vec![state.depth - state.rate * duration, state.rate * duration];
        let depths = self.state.as_ref().map_or_else(Vec::new, follows);
        let straight = Segment { places: vec![-way, way], times: vec![-duration, duration], depths, ..Segment::blank(0.0, 0.0) };
        self.previous = Some((advances, straight, 1.0));
    }

    /// Whether an edge that rests for a time leaves no more of the closure than would move it by a part of the tolerance.
    pub(super) fn stays(&mut self, time: f64, tolerance: f64) -> bool {
        let (here, left) = (self.sudden(0.0), self.resting(time));
        // Too little work: it would advance.
        let way = if left < here { tolerance } else { -tolerance };
        let softness = way / (self.sudden(way) - here);
        let stays = softness > 0.0 && (left - here).abs() * softness <= LINGER * tolerance;
        if stays {
            self.start_residual = left;
        }
        stays
    }

    /// An edge whose turn is not found rests: for the longest time up to `longest` in which what it leaves of the closure would move it, either way, by a part
    /// of the tolerance only. Then it sets out anew.
    pub(super) fn lingers(&mut self, longest: f64, tolerance: f64) -> bool {
        let until_corner = self.may_end().unwrap_or(f64::INFINITY).min(self.branch.end) - self.line.time;
        if self.state.is_some() || longest > 0.5 * until_corner {
            return false;
        }
        let here = self.sudden(0.0);
        let softest = [tolerance, -tolerance].map(|way| (self.sudden(way) - here) / way).into_iter().fold(f64::INFINITY, f64::min);
        if softest <= 0.0 {
            return false;
        }
        let mut time = longest;
        for _ in 0..MOST_HALVINGS {
            let left = self.resting(time);
            if (left - here).abs() <= LINGER * tolerance * softest {
                self.record_rest(time);
                self.line.waited(time);
                self.start_residual = left;
                let outset = self.sets_out();
                if outset.stable && outset.speed != 0.0 {
                    self.sets(outset, f64::INFINITY);
                    self.span = (Chart::PlaceOfTime, 2.0 * time);
                    (self.to_turn, self.since_turn) = (0.0, 0.0);
                } else {
                    self.previous = None;
                }
                return true;
            }
            time *= 0.5;
        }
        false
    }

    /// C − Δγ of an edge that has rested for a time.
    fn resting(&mut self, time: f64) -> f64 {
        let mut window = std::mem::take(&mut self.window);
        let setting = self.setting(false);
        let mut now = Instant::default();
        setting.along(&[time], &[], 0.0, &mut now);
        let excess = setting.excess(&mut window, None, &now, false).value;
        self.window = window;
        excess
    }

    /// Whether an edge goes on beyond a kink of the closure about as fast as before; what it does else shows where it sets out.
    pub(super) fn goes_on(&mut self, speed: f64) -> bool {
        let outset = self.sets_out();
        outset.stable && (outset.speed / speed - 1.0).abs() < SAME_SPEED
    }
}
