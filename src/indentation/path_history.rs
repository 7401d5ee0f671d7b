//! The last points of an integration, and the polynomials through them that the next step follows.
//!
//! Between (0, 0) and (1, 1) a step goes as v = x[1 + (x − 1)q(x)], q the polynomial through what earlier points ask of it: a new point costs one unknown,
//! however high the degree. C depends on t(s) − t(s′) with a smooth weight, an equation of the second kind in t(s): any such
//! interpolation is stable, and of the order of its degree plus one. The size of its last term is the error of one degree less.

use super::motion::polynomial;
use super::springs::DEGREE;
use crate::continuation::bracket::halved;
use serde::{Deserialize, Serialize};

/// Part of the term before the last one below which the error is not taken: a last term may be small by accident.
const LEAST: f64 = 0.1;
/// Points kept.
const KEPT: usize = DEGREE;
/// A term that does not fall to this part of the one before is noise, or the path is not smooth.
const FALLS: f64 = 0.9;

/// A point of the integration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Node {
    /// Since the newest point, so zero or less (s): an edge that accelerates unstably takes steps that no clock tells from the time since the start.
    pub(super) time: f64,
    /// y(a), see [`super::motion`].
    pub(super) place: f64,
    pub(super) penetration: f64,
    pub(super) force: f64,
    pub(super) radius: f64,
}

/// Points since the last corner, the newest first.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct PathHistory {
    nodes: Vec<Node>,
    /// Whether the edge was at rest, turning, at the oldest node: its speed is a condition too, then.
    turned: bool,
}

/// A polynomial from (0, 0) to (1, 1) as monomials, with the size of its last term within the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bridge {
    pub(super) coefficients: [f64; DEGREE],
    /// Largest distance within the step from the polynomial of one degree less; 0 for a straight line without a path history.
    pub(super) error: f64,
    pub(super) degree: u32,
}

impl PathHistory {
    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    pub(super) fn restart(&mut self, node: Node) {
        self.nodes.clear();
        self.nodes.push(Node { time: 0.0, ..node });
        self.turned = false;
    }

    /// Starts again where the edge turns.
    pub(super) fn restart_at_turn(&mut self, node: Node) {
        self.restart(node);
        self.turned = true;
    }

    /// A point that is reached after a time.
    pub(super) fn push(&mut self, node: Node, after: f64) {
        for earlier in &mut self.nodes {
            earlier.time -= after;
        }
        self.nodes.insert(0, Node { time: 0.0, ..node });
        self.turned &= self.nodes.len() <= KEPT;
        self.nodes.truncate(KEPT);
    }

    /// v(x) through the path history, with x and v of a node relative to the step: x = 0, v = 0 is now, x = 1, v = 1 its end. Of as high a degree as helps.
    /// `held`: the degree of an earlier trial of the same step, so that the trials are of one smooth function. `rest`: whether v(x) has slope zero
    /// where the edge turned; its inverse has none.
    pub(super) fn bridge(&self, held: Option<u32>, rest: bool, of: impl Fn(&Node) -> (f64, f64)) -> Bridge {
        let mut sum = Newton::new(1.0);
        let mut bridge = Bridge { coefficients: sum.coefficients, error: 0.0, degree: 1 };
        let most = held.map_or(DEGREE - 1, |degree| degree.saturating_sub(1) as usize);
        if self.turned && self.nodes.len() == 1 && rest {
            // From rest: v = x², which nothing has assessed yet.
            if most > 0 && sum.add_rest(0.0, 0.0).is_some() {
                bridge = Bridge { coefficients: sum.coefficients, error: 0.0, degree: 2 };
            }
            return bridge;
        }
        let mut conditions: Vec<(bool, &Node)> = self.nodes.iter().skip(1).map(|node| (false, node)).collect();
        if self.turned {
            let turn = conditions.last().copied();
            if rest {
                conditions.extend(turn.map(|(_, node)| (true, node)));
            } else {
                // t(y) has an infinite slope there.
                conditions.pop();
            }
        }
        let mut last = f64::INFINITY;
        for (count, (at_rest, node)) in conditions.into_iter().take(most.max(1)).enumerate() {
            let (x, v) = of(node);
            let added = if at_rest { sum.add_rest(x, v) } else { sum.add(x, v) };
            let Some(size) = added else { break };
            if count == 0 {
                // A straight line is assessed as well: by the term that it leaves out.
                bridge.error = size;
            }
            if most == 0 || (held.is_none() && size > FALLS * last) {
                break;
            }
            // A path that slows down towards a turn may rise with more terms only.
            if rises(&sum.coefficients) {
                let error = if count == 0 { size } else { size.max(LEAST * last) };
                bridge = Bridge { coefficients: sum.coefficients, error, degree: count as u32 + 2 };
            }
            last = size;
        }
        bridge
    }

    /// Powers of v(x) from (0, 0) to (1, rise) through points of the path history as far as a degree goes, and the size of the last term. Affine in `rise`.
    pub(super) fn powers(&self, rise: f64, degree: u32, of: impl Fn(&Node) -> (f64, f64)) -> ([f64; DEGREE], f64) {
        let mut sum = Newton::new(rise);
        let mut last = 0.0;
        for node in self.nodes.iter().skip(1).take(degree.saturating_sub(1) as usize) {
            let (x, v) = of(node);
            match sum.add(x, v) {
                Some(size) => last = size,
                None => break,
            }
        }
        (sum.coefficients, last)
    }

    /// When the edge stands still between the newest node, or a little before it, and a trial node: time since the newest node.
    /// By the polynomial through the trial and up to three nodes.
    pub(super) fn turn(&self, trial: (f64, f64)) -> Option<f64> {
        let now = self.nodes.first()?;
        let mut points = vec![trial];
        points.extend(self.nodes.iter().take(3).map(|node| (node.time, node.place)));
        if points.len() < 3 {
            return None;
        }
        let span = trial.0;
        // Derivative of the Lagrange form.
        let speed = |t: f64| {
            points
                .iter()
                .enumerate()
                .map(|(k, (own, y))| {
                    let others = || points.iter().enumerate().filter(move |(l, _)| *l != k).map(|(l, point)| (l, point.0));
                    let scale: f64 = others().map(|(_, other)| own - other).product();
                    let slope: f64 = others()
                        .map(|(skipped, _)| others().filter(|(l, _)| *l != skipped).map(|(_, other)| t - other).product::<f64>())
                        .sum();
                    (y - now.place) * slope / scale
                })
                .sum::<f64>()
        };
        let before = self.nodes.get(1)?;
        let reversed = (trial.1 - now.place) * (now.place - before.place) < 0.0;
        let bracket = [-0.02 * span, 1.02 * span];
        let [first, last] = bracket.map(&speed);
        let crosses = first * last < 0.0;
        if !crosses {
            // So far beyond the turn that the polynomial tells nothing: nearer.
            return reversed.then_some(0.5 * span);
        }
        Some(halved(bracket, |place| first * speed(place) > 0.0)[0])
    }

    /// The value at the place 0 of the polynomial through at most `count` points.
    pub(super) fn extrapolated(&self, count: usize, of: impl Fn(&Node) -> (f64, f64)) -> Option<f64> {
        let points: Vec<(f64, f64)> = self.nodes.iter().take(count).map(of).collect();
        let mut total = 0.0;
        for (k, (x, v)) in points.iter().enumerate() {
            let factor: f64 = points.iter().enumerate().filter(|(l, _)| *l != k).map(|(_, (other, _))| other / (other - x)).product();
            total += factor * v;
        }
        (points.len() > 1 && total.is_finite()).then_some(total)
    }
}

/// v = rise·x + x(x − 1)q(x), q by Newton's divided differences.
struct Newton {
    rise: f64,
    count: usize,
    places: [f64; KEPT],
    divided: [f64; KEPT],
    coefficients: [f64; DEGREE],
    /// Monomials of x(x − 1)Π(x − x_j).
    product: [f64; DEGREE],
}

impl Newton {
    const fn new(rise: f64) -> Self {
        Self {
            rise,
            count: 0,
            places: [0.0; KEPT],
            divided: [0.0; KEPT],
            coefficients: [rise, 0.0, 0.0, 0.0, 0.0],
            product: [-1.0, 1.0, 0.0, 0.0, 0.0],
        }
    }

    /// Adds a point further back; the largest change within the step, or none for a point that is not further back.
    fn add(&mut self, x: f64, v: f64) -> Option<f64> {
        let k = self.count;
        let last = self.places[..k].iter().fold(0.0, |least: f64, place| least.min(*place));
        let further = x < last && v.is_finite();
        if !further || k + 1 >= DEGREE {
            return None;
        }
        self.places[k] = x;
        self.divided[k] = (v / x - self.rise) / (x - 1.0);
        for j in (0..k).rev() {
            self.divided[j] = (self.divided[j + 1] - self.divided[j]) / (x - self.places[j]);
        }
        self.next(x)
    }

    /// Adds that the slope is zero at the point that was added last, or at the origin.
    fn add_rest(&mut self, x: f64, v: f64) -> Option<f64> {
        let k = self.count;
        if k + 1 >= DEGREE || !v.is_finite() {
            return None;
        }
        self.places[k] = x;
        if x == 0.0 {
            self.divided[k] = self.rise;
        } else {
            let q = (v / x - self.rise) / (x - 1.0);
            self.divided[k] = q;
            let slope = -(self.rise + (2.0 * x - 1.0) * q) / (x * (x - 1.0));
            for j in (0..k).rev() {
                self.divided[j] = if j + 1 == k { slope } else { (self.divided[j + 1] - self.divided[j]) / (x - self.places[j]) };
            }
        }
        self.next(x)
    }

    fn next(&mut self, x: f64) -> Option<f64> {
        let factor = self.divided[0];
        let size = [0.2, 0.5, 0.8].iter().fold(0.0, |most: f64, x| most.max((factor * polynomial(&self.product, *x)).abs()));
        if !size.is_finite() {
            return None;
        }
        for (sum, term) in self.coefficients.iter_mut().zip(self.product) {
            *sum += factor * term;
        }
        // Times (x − x_k).
        for j in (0..DEGREE).rev() {
            let below = if j == 0 { 0.0 } else { self.product[j - 1] };
            self.product[j] = below - x * self.product[j];
        }
        self.count += 1;
        Some(size)
    }
}

/// Whether a polynomial rises throughout the step.
fn rises(coefficients: &[f64; DEGREE]) -> bool {
    let mut last = 0.0;
    (1..=16).all(|k| {
        let value = polynomial(coefficients, f64::from(k) / 16.0);
        let more = value > last;
        last = value;
        more
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp)]
    use super::*;

    fn node(place: f64) -> Node {
        Node { time: 0.0, place, penetration: 0.0, force: 0.0, radius: place }
    }

    #[test]
    fn a_turn_is_at_rest() {
        // y = −t² + t³/8 from a turn at t = 0.
        let y = |t: f64| -t * t + t * t * t / 8.0;
        let mut path_history = PathHistory::default();
        path_history.restart_at_turn(node(0.0));
        let first = path_history.bridge(None, true, |_| (0.0, 0.0));
        assert_eq!((first.coefficients[0], first.coefficients[1]), (0.0, 1.0));
        path_history.push(node(y(0.1)), 0.1);
        path_history.push(node(y(0.3)), 0.2);
        let (t0, t1) = (0.3, 0.5);
        let bridge = path_history.bridge(None, true, |node| (node.time / (t1 - t0), (node.place - y(t0)) / (y(t1) - y(t0))));
        for x in [0.1, 0.4, 0.77] {
            let exact = (y(t0 + (t1 - t0) * x) - y(t0)) / (y(t1) - y(t0));
            assert!((polynomial(&bridge.coefficients, x) - exact).abs() < 1e-13, "{bridge:?}");
        }
    }

    #[test]
    fn a_polynomial_of_the_degree_is_met() {
        // t = 0.5y + y³/8 − y⁴/50, at places that are not equidistant.
        let t = |y: f64| 0.5 * y + y * y * y / 8.0 - y.powi(4) / 50.0;
        let mut path_history = PathHistory::default();
        path_history.restart(node(0.0));
        for (before, y) in [(0.0, 0.3), (0.3, 0.4), (0.4, 0.8), (0.8, 1.1)] {
            path_history.push(node(y), t(y) - t(before));
        }
        let (y0, y1) = (1.1, 1.5);
        let bridge = path_history.bridge(None, true, |node| ((node.place - y0) / (y1 - y0), node.time / (t(y1) - t(y0))));
        for x in [0.1, 0.4, 0.77] {
            let exact = (t(y0 + (y1 - y0) * x) - t(y0)) / (t(y1) - t(y0));
            assert!((polynomial(&bridge.coefficients, x) - exact).abs() < 1e-13, "{bridge:?}");
        }
    }
}
