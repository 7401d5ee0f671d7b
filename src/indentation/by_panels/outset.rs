//! How an edge sets out from rest, a corner of the history or a kink of the line: its direction, its speed and its stability, in frozen time.
//!
//! ```text
//! da/dt = −(∂C/∂t)/(∂C/∂a),      ∂C/∂a by one-sided differences of C for an edge moved at once (its passages take no time)
//! ```
//! ∂C/∂t < 0: the edge advances, else it recedes. ∂C/∂a ≤ 0 in that direction: it is unstable, and jumps.

use super::closure::Way;
use super::drive::Instant;
use super::line::Segment;
use super::march::March;
use super::path::{Chart, passed};

/// How an edge sets out.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outset {
    pub(super) advances: bool,
    pub(super) speed: f64,
    pub(super) stable: bool,
}

/// Change of speed at a kink that a panel's prediction still bears.
const SAME_SPEED: f64 = 0.3;

impl March<'_> {
    /// C − Δγ at the edge now, moved at once by a way (a panel without duration).
    pub(super) fn sudden(&mut self, way: f64) -> f64 {
        let mut window = std::mem::take(&mut self.window);
        let advances = way > 0.0 || way == 0.0 && self.past.as_ref().is_some_and(|past| past.0);
        let setting = self.setting(advances);
        let mut now = Instant::default();
        setting.now(0.0, &mut now);
        let value = if way == 0.0 {
            setting.excess(&mut window, None, &now, false).value
        } else {
            let panel = passed(&self.points, &setting, Chart::TimeOfPlace, way, &vec![0.0; self.points.p + 1]);
            setting.excess(&mut window, Some(Way { panel: &panel, advances, theta: 1.0 }), &now, false).value
        };
        self.window = window;
        value
    }

    /// ∂C/∂t now, nothing moving; without adhesion of an edge that advances or recedes.
    pub(super) fn rate(&mut self, advances: bool) -> f64 {
        let mut window = std::mem::take(&mut self.window);
        let setting = self.setting(advances);
        let mut now = Instant::default();
        setting.now(0.0, &mut now);
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
        let way = 0.05 * zone * speed.signum();
        let duration = way / speed;
        // An edge that hardly goes in the time left is followed in time.
        self.span = if duration > 0.5 * left { (Chart::PlaceOfTime, 0.1 * left) } else { (Chart::TimeOfPlace, way) };
        let straight = Segment { places: vec![-way, way], times: vec![-duration, duration], ..Segment::blank(0.0, 0.0) };
        self.past = Some((advances, straight, 1.0));
    }

    /// Whether an edge goes on beyond a kink of the closure about as fast as before; what it does else shows where it sets out.
    pub(super) fn goes_on(&mut self, speed: f64) -> bool {
        let outset = self.sets_out();
        outset.stable && (outset.speed / speed - 1.0).abs() < SAME_SPEED
    }
}
