//! The elastic contact on a surface that nothing has touched: Φ(a) = a f(a) − ∫₀^a f ds, with F = 2E*Φ and Δ = f(a).

use super::grid::{GRID, NODES, Nodal, dot};
use super::line::{Line, place_of};
use crate::indentation::profile::Profile;
use crate::refusal::Refusal;
use std::sync::OnceLock;

/// Halvings of a bracket.
const MOST_ITERATIONS: u32 = 200;

/// Φ of a shape, and what it needs.
#[derive(Debug, Clone)]
pub(super) struct Fresh<'a> {
    /// The face, as if it had no rim.
    profile: &'a Profile,
    rim: f64,
    /// Of a table: the axis and its points, and the parts of the line from each to the next, cut one after the other as far as they are asked for.
    knots: Vec<f64>,
    sections: Vec<OnceLock<Vec<Part>>>,
}

/// A part of the line of a table, as fine as one series keeps.
#[derive(Debug, Clone)]
struct Part {
    low: f64,
    high: f64,
    /// f and Φ at its start and at its end.
    start: [f64; 2],
    end: [f64; 2],
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
        let knots = if let Profile::Table(shape) = profile { profile.breaks(shape.reach()) } else { Vec::new() };
        let sections = knots.windows(2).map(|_| OnceLock::new()).collect();
        Self { profile, rim, knots, sections }
    }

    /// The first part whose end is enough.
    fn part(&self, enough: impl Fn(&Part) -> bool) -> Option<&Part> {
        let ends = |section: &OnceLock<Vec<Part>>| section.get().and_then(|parts| parts.last()).is_some_and(&enough);
        let known = self.sections.partition_point(|section| section.get().is_some());
        let first = self.sections.get(..known)?.partition_point(|section| !ends(section));
        let mut before = first.checked_sub(1).and_then(|index| self.sections.get(index)?.get()?.last()).map_or(0.0, Part::sum);
        for (section, pair) in self.sections.iter().zip(self.knots.windows(2)).skip(first) {
            let parts = section.get_or_init(|| {
                let mut parts = Vec::new();
                cut(self.profile, (pair[0], pair[1]), before, MOST_HALVINGS, &mut parts);
                parts
            });
            let last = parts.last()?;
            if enough(last) {
                return parts.get(parts.partition_point(|part| !enough(part)));
            }
            before = last.sum();
        }
        None
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
                let Some(part) = self.part(|part| part.high >= a) else {
                    let last = self.sections.last().and_then(|section| section.get()?.last());
                    return last.map_or(0.0, |last| last.sum() + interval(self.profile, last.high, a));
                };
                dot(&GRID.at(a - part.low, part.high - a), &part.sums)
            }
        }
    }

    /// Where the undeformed surface lies at a depth, as [`Line::virgin_edge`]: a table is looked up.
    pub(super) fn edge(&self, line: &Line<'_>, depth: f64, from: f64) -> Result<f64, Refusal> {
        match self.part(|part| part.end[0] >= depth) {
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
        self.knots.iter().copied().filter(move |place| *place > low + clear && *place < high - clear)
    }

    /// No less than the penetration of a fresh contact with Φ (m), and little more; none beyond what the shape is known for.
    pub(super) fn at_most(&self, load: f64) -> Option<f64> {
        if !matches!(self.profile, Profile::Table(_)) || load <= 0.0 || (self.rim.is_finite() && load >= self.at(self.rim)) {
            return self.depth(load).ok();
        }
        // dΔ/dΦ = 1/a falls: tangents lie above.
        let part = self.part(|part| part.end[1] >= load)?;
        let tangent = |[depth, there]: [f64; 2], a: f64| depth + (load - there) / a;
        let from_above = tangent(part.end, part.high);
        Some(if part.low > 0.0 { from_above.min(tangent(part.start, part.low)) } else { from_above })
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
        let Some(&reach) = self.knots.last() else { return Ok(0.0) };
        let Some(part) = self.part(|part| part.end[1] >= load) else {
            return Err(Refusal::NoSuchState {
                reason: "the force presses the contact out beyond the last point of the table".into(),
                limit_name: "the radius of its last point",
                limit: reach,
            });
        };
        // Φ′ = a f′ ≥ 0: Newton's steps within a bracket.
        let (mut low, mut high) = (part.low, part.high);
        let mut place = 0.5 * (low + high);
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

impl Part {
    /// ∫f ds from the axis to its end.
    const fn sum(&self) -> f64 {
        self.sums[NODES - 1]
    }
}

/// The parts between two places without a point of a table between them, with ∫f ds up to the first; up to the last one.
fn cut(profile: &Profile, (low, high): (f64, f64), before: f64, halvings: u32, parts: &mut Vec<Part>) -> f64 {
    let heights: Nodal = std::array::from_fn(|k| profile.line(place_of(low, high, k)));
    let [bottom, top] = [heights[0], heights[NODES - 1]];
    if GRID.tail(&heights) > LEFT * top && halvings > 0 {
        let middle = 0.5 * (low + high);
        let there = cut(profile, (low, middle), before, halvings - 1, parts);
        return cut(profile, (middle, high), there, halvings - 1, parts);
    }
    let sums = GRID.running(&heights).map(|sum| before + (high - low) * sum);
    let after = sums[NODES - 1];
    parts.push(Part { low, high, start: [bottom, low * bottom - before], end: [top, high * top - after], sums });
    after
}

/// ∫f ds between two places without a point of a table between them.
fn interval(profile: &Profile, low: f64, high: f64) -> f64 {
    if high <= low {
        return 0.0;
    }
    let values = std::array::from_fn::<f64, NODES, _>(|k| profile.line(place_of(low, high, k)));
    (high - low) * GRID.integral(&values)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A paraboloid is a cubic: Φ = 2a³/3R, Δ = a²/R, to rounding; in whatever order a table is asked, the digits are the same.
    #[test]
    fn a_table_is_cut_as_far_as_it_is_asked() -> Result<(), Refusal> {
        let (radius, end) = (3.0, 0.7);
        let points: Vec<(f64, f64)> = (0..=40).map(|k| end * f64::from(k) / 40.0).map(|r| (r, 0.5 * r * r / radius)).collect();
        let profile = Profile::table(&points)?;
        let places: Vec<f64> = (1..=100).map(|k| end * f64::from(k) / 101.0).collect();
        let (outwards, inwards) = (Fresh::of(&profile), Fresh::of(&profile));
        let rising: Vec<f64> = places.iter().map(|a| outwards.at(*a)).collect();
        let falling: Vec<f64> = places.iter().rev().map(|a| inwards.at(*a)).collect();
        for ((a, load), other) in places.iter().zip(rising).zip(falling.into_iter().rev()) {
            let exact = 2.0 * a.powi(3) / (3.0 * radius);
            assert!(load.total_cmp(&other).is_eq() && (load / exact - 1.0).abs() < 1e-13, "{a}: {load:e} {other:e} {exact:e}");
            // Each of a table that nothing was asked before.
            let (depth, above) = (Fresh::of(&profile).depth(exact)?, Fresh::of(&profile).at_most(exact).unwrap_or_default());
            let own = a * a / radius;
            assert!(
                (depth / own - 1.0).abs() < 1e-13 && above >= own * (1.0 - 1e-13) && above < 1.4 * own,
                "{a}: {depth:e} {above:e} {own:e}"
            );
        }
        let whole = Fresh::of(&profile);
        assert!(matches!(whole.depth(2.0 * end.powi(3) / radius), Err(Refusal::NoSuchState { .. })) && whole.at_most(1.0).is_none());
        Ok(())
    }
}
