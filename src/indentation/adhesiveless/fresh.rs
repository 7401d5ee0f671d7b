//! The elastic contact on a surface that nothing has touched: Φ(a) = a f(a) − ∫₀^a f ds, with F = 2E*Φ and Δ = f(a).

use super::grid::{GRID, NODES};
use super::line::place_of;
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
}

impl<'a> Fresh<'a> {
    pub(super) fn of(profile: &'a Profile) -> Self {
        let rim = profile.rim();
        let profile = profile.face();
        let mut running = Vec::new();
        if let Profile::Table(shape) = profile {
            let mut sum = 0.0;
            let knots = profile.breaks(shape.reach());
            running.push((0.0, 0.0));
            for pair in knots.windows(2) {
                sum += stretch(profile, pair[0], pair[1]);
                running.push((pair[1], sum));
            }
        }
        Self { profile, rim, running }
    }

    /// Φ(a) (m²) at a place a, with Δ = f(a).
    fn at(&self, a: f64) -> f64 {
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
                let next = self.running.partition_point(|(place, _)| *place <= a).max(1);
                let (place, sum) = self.running.get(next - 1).copied().unwrap_or_default();
                sum + stretch(self.profile, place, a)
            }
        }
    }

    /// Places between two at which the slope of the shape has a kink.
    pub(super) fn knots(&self, one: f64, other: f64) -> impl Iterator<Item = f64> {
        let (low, high) = (one.min(other), one.max(other));
        let clear = 1e-9 * high;
        self.running.iter().map(|(place, _)| *place).filter(move |place| *place > low + clear && *place < high - clear)
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

/// ∫f ds between two places without a point of a table between them.
fn stretch(profile: &Profile, low: f64, high: f64) -> f64 {
    if high <= low {
        return 0.0;
    }
    let values = std::array::from_fn::<f64, NODES, _>(|k| profile.line(place_of(low, high, k)));
    (high - low) * GRID.integral(&values)
}
