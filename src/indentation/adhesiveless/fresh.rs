//! The elastic contact on a surface that nothing has touched: Φ(a) = a f(a) − ∫₀^a f ds, with F = 2E*Φ and Δ = f(a).

use super::grid::{GRID, NODES, Nodal, dot};
use super::line::{Line, place_of};
use crate::indentation::profile::Profile;
use crate::refusal::Refusal;

/// Halvings of a bracket.
const MOST_ITERATIONS: u32 = 200;

/// Φ of a shape, and what it needs.
#[derive(Debug, Clone)]
pub(super) struct Fresh<'a> {
    /// The face, as if it had no rim.
    profile: &'a Profile,
    rim: f64,
    /// Of a table: its points and ∫f ds up to each.
    running: Vec<(f64, f64)>,
    /// The same between its points, as series.
    parts: Vec<Part>,
}

/// A part of the line of a table, as fine as one series keeps.
#[derive(Debug, Clone)]
struct Part {
    low: f64,
    high: f64,
    /// f and Φ at its end.
    top: f64,
    load: f64,
    /// ∫f ds from the axis to each place.
    sums: Nodal,
}

/// What a series of a part leaves, over f at its end, and halvings of a part.
const LEFT: f64 = 1e-14;
const MOST_HALVINGS: u32 = 40;

impl<'a> Fresh<'a> {
    pub(super) fn of(profile: &'a Profile) -> Self {
        let rim = profile.rim();
        let profile = profile.face();
        let (mut running, mut parts) = (Vec::new(), Vec::new());
        if let Profile::Table(shape) = profile {
            let mut sum = 0.0;
            let knots = profile.breaks(shape.reach());
            running.push((0.0, 0.0));
            for pair in knots.windows(2) {
                sum = cut(profile, (pair[0], pair[1]), sum, MOST_HALVINGS, &mut parts);
                running.push((pair[1], sum));
            }
        }
        Self { profile, rim, running, parts }
    }

    /// Φ(a) (m²) at a place a, with Δ = f(a).
    pub(super) fn at(&self, a: f64) -> f64 {
        a * self.profile.line(a) - self.integral(a)
    }

    /// ∫f ds up to a place (m²).
    pub(super) fn integral(&self, a: f64) -> f64 {
        let cylinder = a * self.profile.line(a);
        match self.profile {
            Profile::Paraboloid { .. } => cylinder / 3.0,
            Profile::Cone { .. } => 0.5 * cylinder,
            Profile::PowerLaw { exponent, .. } => cylinder / (exponent + 1.0),
            Profile::FlatPunch { .. } | Profile::Rimmed { .. } => 0.0,
            Profile::Table(_) => {
                let Some(part) = self.parts.get(self.parts.partition_point(|part| part.high < a)) else {
                    let (place, sum) = self.running.last().copied().unwrap_or_default();
                    return sum + stretch(self.profile, place, a);
                };
                dot(&GRID.at(a - part.low, part.high - a), &part.sums)
            }
        }
    }

    /// Where the undeformed surface lies at a depth, as [`Line::virgin_edge`]: a table is looked up.
    pub(super) fn edge(&self, line: &Line<'_>, depth: f64, from: f64) -> Result<f64, Refusal> {
        match self.parts.get(self.parts.partition_point(|part| part.top < depth)) {
            Some(part) if part.high > from && part.high <= self.rim => {
                let low = part.low.max(from);
                Ok(if self.profile.line(low) >= depth { low } else { self.profile.inverse_coordinate(depth, low, part.high) })
            }
            _ => line.virgin_edge(depth, from),
        }
    }

    /// Places between two at which the slope of the shape has a kink.
    pub(super) fn knots(&self, one: f64, other: f64) -> impl Iterator<Item = f64> {
        let (low, high) = (one.min(other), one.max(other));
        let clear = 1e-9 * high;
        self.running.iter().map(|(place, _)| *place).filter(move |place| *place > low + clear && *place < high - clear)
    }

    /// No less than the penetration of a fresh contact with Φ (m), and little more; none beyond what the shape is known for.
    pub(super) fn at_most(&self, load: f64) -> Option<f64> {
        if !matches!(self.profile, Profile::Table(_)) || load <= 0.0 || load >= self.at(self.rim.min(self.running.last()?.0)) {
            return self.depth(load).ok();
        }
        // dΔ/dΦ = 1/a falls: tangents lie above.
        let index = self.parts.partition_point(|part| part.load < load);
        let above = self.parts.get(index)?;
        let from_above = above.top - (above.load - load) / above.high;
        let below = index.checked_sub(1).and_then(|index| self.parts.get(index));
        Some(below.map_or(from_above, |below| from_above.min(below.top + (load - below.load) / below.high)))
    }

    /// The penetration of a fresh contact with Φ (m), at least 0.
    pub(super) fn depth(&self, load: f64) -> Result<f64, Refusal> {
        if load <= 0.0 {
            return Ok(0.0);
        }
        let profile = self.profile;
        // Within a rim Φ = Δ·rim − ∫f ds.
        if self.rim.is_finite() && load >= self.at(self.rim) {
            return Ok(profile.line(self.rim) + (load - self.at(self.rim)) / self.rim);
        }
        match profile {
            Profile::Paraboloid { radius } => return Ok((1.5 * load * radius).cbrt().powi(2) / radius),
            Profile::Cone { .. } => {
                let slope = profile.line(1.0);
                return Ok((2.0 * load * slope).sqrt());
            }
            Profile::PowerLaw { coefficient, exponent } => {
                let place = (load * (exponent + 1.0) / (exponent * coefficient)).powf(1.0 / (exponent + 1.0));
                return Ok(profile.line(place));
            }
            Profile::Table(_) | Profile::FlatPunch { .. } | Profile::Rimmed { .. } => {}
        }
        let Some(&(reach, _)) = self.running.last() else { return Ok(0.0) };
        if self.at(reach) < load {
            return Err(Refusal::NoSuchState {
                reason: "the force presses the contact out beyond the last point of the table".into(),
                limit_name: "the radius of its last point",
                limit: reach,
            });
        }
        // Φ′ = a f′ ≥ 0: Newton's steps within a bracket.
        let (mut low, mut high) = (0.0, reach);
        let mut place = 0.5 * reach;
        for _ in 0..MOST_ITERATIONS {
            let excess = self.at(place) - load;
            if excess > 0.0 {
                high = place;
            } else {
                low = place;
            }
            let newton = place - excess / (place * profile.line_slope(place));
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - place).abs() <= 2.0 * f64::EPSILON * place {
                break;
            }
            place = next;
        }
        Ok(profile.line(place))
    }
}

/// The parts between two places without a point of a table between them, with ∫f ds up to the first; up to the last one.
fn cut(profile: &Profile, (low, high): (f64, f64), before: f64, halvings: u32, parts: &mut Vec<Part>) -> f64 {
    let heights: Nodal = std::array::from_fn(|k| profile.line(place_of(low, high, k)));
    let top = heights[NODES - 1];
    if GRID.tail(&heights) > LEFT * top && halvings > 0 {
        let middle = 0.5 * (low + high);
        let there = cut(profile, (low, middle), before, halvings - 1, parts);
        return cut(profile, (middle, high), there, halvings - 1, parts);
    }
    let sums = GRID.running(&heights).map(|sum| before + (high - low) * sum);
    parts.push(Part { low, high, top, load: high * top - sums[NODES - 1], sums });
    sums[NODES - 1]
}

/// ∫f ds between two places without a point of a table between them.
fn stretch(profile: &Profile, low: f64, high: f64) -> f64 {
    if high <= low {
        return 0.0;
    }
    let values = std::array::from_fn::<f64, NODES, _>(|k| profile.line(place_of(low, high, k)));
    (high - low) * GRID.integral(&values)
}
