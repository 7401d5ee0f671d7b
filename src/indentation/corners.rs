//! Where the path of an integration has a corner and starts anew: corners of the history, turns of the edge, and the places that the edge meets again.

use super::edge::node_of;
use super::integrator::{Integrator, LOOSEST};
use super::line::NARROWEST;

/// First step of an edge, over the process zone, at a tolerance of 1; it goes with the root of the tolerance.
const FIRST_REACH: f64 = 0.3;
/// Turns and corners of the edge that are remembered; those nearer than this, over the process zone, count as one.
const MOST_TURNS: usize = 4;
const SAME_TURN: f64 = 1e-2;
/// Distance from a kink, over the process zone, that is none; corners of corners that steps end at.
const SAME_KINK_PLACE: f64 = 1e-5;
const GENERATIONS: u32 = 2;
/// Distance to a corner of the path, over the process zone, that is none.
pub(super) const AT_MARK: f64 = 1e-6;
/// Motion of a step, over the tolerance of the path, whose turn does not count.
const STILL: f64 = 1e-4;
/// Narrowest panels within which the place of an edge is noise.
pub(super) const PLACE_NOISE: f64 = 4.0;
/// Accuracy of the instant at which the edge turns, over the step that leads there, at the loosest tolerance; it goes with the cube root. And the least.
const AT_TURN: f64 = 3e-3;
const LEAST_AT_TURN: f64 = 1e-5;

impl Integrator<'_> {
    /// Forgets the smooth path: a corner of the history, or an event.
    pub(super) fn restart(&mut self) {
        let node = node_of(self.contact.profile(), &self.contact, self.record.force());
        self.path_history.restart(node);
        self.record.new_piece();
        self.corner = self.time;
        self.smooth_in_time = false;
        let root = self.tolerance.sqrt();
        self.reach = FIRST_REACH * root * self.length;
        self.dt = self.first_step();
        self.kink_places.clear();
        let (a, zone) = (self.contact.radius(), self.zone_now());
        if zone > 0.0 && a > 0.0 {
            self.kink_places.extend([(a - zone, 1), (a + zone, 1)]);
        }
    }

    /// The same at a corner of the history: where the edge moves it changes its speed there, and the line keeps the place. An edge at rest would meet it again and again.
    pub(super) fn restart_at_corner(&mut self) {
        let a = self.contact.radius();
        let moves = self.moves(a);
        self.restart();
        if moves {
            self.remember_turn(a);
        }
    }

    /// The same where the edge turns: it starts from rest.
    pub(super) fn restart_at_turn(&mut self) {
        self.restart();
        let node = node_of(self.contact.profile(), &self.contact, self.record.force());
        self.path_history.restart_at_turn(node);
        self.remember_turn(self.contact.radius());
    }

    /// δ, at the present K where it grows.
    pub(super) fn zone_now(&self) -> f64 {
        let a = self.contact.radius();
        if a > 0.0 { self.edge.zone_at(&self.contact, a, self.contact.edge_load()).max(self.edge.zone()) } else { self.edge.zone() }
    }

    /// Keeps a place at which the line has a kink: a step ends there when the edge comes back.
    pub(super) fn remember_turn(&mut self, place: f64) {
        self.turns.retain(|turn| (turn - place).abs() > SAME_TURN * self.length);
        self.turns.push(place);
        if self.turns.len() > MOST_TURNS {
            self.turns.remove(0);
        }
    }

    /// The same at a kink: the path has a corner there, and time goes on.
    pub(super) fn restart_at_kink(&mut self) {
        let (corner, dt) = (self.corner, self.dt);
        let mut others = std::mem::take(&mut self.kink_places);
        let (a, zone) = (self.contact.radius(), self.zone_now());
        let way = self.path_history.nodes().get(1).map_or(0.0, |before| (a - before.radius).signum());
        self.restart();
        // The surface keeps the corner: an edge that comes back meets it again.
        self.remember_turn(a);
        self.corner = corner;
        // The edge keeps its pace; a short step begins the new segment of the path, of the edge or, where it is slow, of time.
        self.dt = dt * (self.reach / self.largest_reach()).min(1.0);
        // Kinks of the turn before stay.
        let reached = others.iter().find(|(mark, _)| (mark - a).abs() <= SAME_KINK_PLACE * self.length).map(|(_, generation)| *generation);
        if let Some(generation) = reached.filter(|generation| *generation < GENERATIONS) {
            others.push((a + way * zone, generation + 1));
        }
        self.kink_places = others;
    }

    /// The nearest corner of the path within a way of the edge.
    pub(super) fn mark_within(&self, way: f64) -> Option<f64> {
        let a = self.contact.radius();
        if self.contact.radius() == 0.0 {
            return None;
        }
        let distance = |mark: &f64| (mark - a) * way.signum();
        let marks = self.kink_places.iter().map(|(mark, _)| mark).chain(&self.turns).copied();
        marks
            .filter(|mark| distance(mark) > AT_MARK * self.length && distance(mark) <= way.abs())
            .min_by(|one, other| distance(one).total_cmp(&distance(other)))
    }

    /// See [`AT_TURN`]: just after a turn K goes with the time since.
    pub(super) fn at_turn(&self) -> f64 {
        (AT_TURN * (self.tolerance / LOOSEST).cbrt()).clamp(LEAST_AT_TURN, AT_TURN)
    }

    /// Whether a step to a place goes against the one before: an edge that drives it has turned on the way.
    pub(super) fn reverses(&self, to: f64) -> bool {
        let a = self.contact.radius();
        self.path_history.nodes().get(1).is_some_and(|node| (to - a) * (a - node.radius) < 0.0)
    }

    /// Whether a step to a place, or one of the last before it, is more than the path is known to: steps towards a turn become as short as one likes.
    pub(super) fn moves(&self, to: f64) -> bool {
        let a = self.contact.radius();
        let last = self.path_history.nodes().windows(2).fold(0.0_f64, |most, pair| most.max((pair[0].radius - pair[1].radius).abs()));
        (to - a).abs().max(last) > (STILL * self.tolerance * self.length).max(PLACE_NOISE * NARROWEST * a)
    }
}
