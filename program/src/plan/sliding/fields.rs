//! Pressure, gap and displacement along the surface of a partial contact, with bounds.
//!
//! A field follows from both edges and the load. Its bound is what it changes at its place from its resolution to the next finer one, and where each of these three moves
//! by its own bound, and rounding of the terms that it is a sum of. Nearer to an edge than that edge is known, a place is a distance from it:
//! there a field goes as a root of the distance, at most.

use super::SlidingPlan;
use crate::outcome::FieldPoint;
use std::f64::consts::PI;
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ArcPoint, ContactState};
use viscotack::sliding::steady::{FullContact, PartialContact};

/// Rounding of a field over the size of its terms, a digit of the condition.
const ROUNDING: f64 = 40.0 * f64::EPSILON;
/// A place so many errors of an edge away from it stays inside where the edge moves, and feels no more than its slope.
const CLEAR: f64 = 4.0;

/// A contact and the three that its bounds leave open.
struct Fields<'a> {
    state: &'a ContactState,
    /// The contact itself at the finer resolution.
    finer: Option<ContactState>,
    /// How far both edges move, and the contact then.
    moved: Vec<([f64; 2], ContactState)>,
    /// Errors of the trailing and the leading edge.
    edges: [f64; 2],
    /// Of a contact that cannot move so far.
    accuracy: f64,
    rounding: f64,
}

impl<'a> Fields<'a> {
    fn new(partial: &'a PartialContact) -> Self {
        let (state, values) = (&partial.state, &partial.values);
        let edges = [values.trailing_edge.error, values.leading_edge.error];
        let moves = [([edges[0], 0.0], 0.0), ([0.0, edges[1]], 0.0), ([0.0; 2], values.mean_pressure.error)];
        let moved: Vec<([f64; 2], ContactState)> =
            moves.into_iter().filter_map(|(edges, load)| Some((edges, state.moved(edges, load).ok()?))).collect();
        let lost = moves.len() - moved.len();
        let accuracy = if lost > 0 { partial.certificate.accuracy } else { 0.0 };
        let finer = state.moved([0.0; 2], 0.0).ok();
        Self { state, finer, moved, edges, accuracy, rounding: ROUNDING * (1.0 + state.condition().ln()) }
    }

    /// A field at a point, its distance from the nearer edge being given; `field` is its value and the size of its terms, `outwards` the sign in which
    /// the distance to each
    /// edge grows as the edge moves along x.
    fn bounded(&self, point: ArcPoint, field: impl Fn(&ContactState, ArcPoint) -> (f64, f64), outwards: [f64; 2]) -> Estimate {
        let (value, size) = field(self.state, point);
        let near = [point.from_trailing, point.from_leading];
        let mut error = self.rounding * size + self.accuracy * value.abs().max(1.0);
        for (edge, distance) in self.edges.iter().zip(near) {
            if distance < CLEAR * edge || self.accuracy > 0.0 {
                error += 0.5 * value.abs() * edge / distance;
            }
        }
        let finer = self.finer.as_ref().map_or(value, |state| field(state, point).0);
        error += (finer - value).abs();
        for (edges, state) in &self.moved {
            // A place that is not clear of an edge moves with it.
            let unclear = (0..2).find(|&index| near[index] < CLEAR * self.edges[index]);
            let shift = unclear.map_or(0.0, |index| edges[index]);
            let moved = |index: usize| near[index] + outwards[index] * (edges[index] - shift);
            error += (field(state, ArcPoint { from_trailing: moved(0), from_leading: moved(1) }).0 - finer).abs();
        }
        Estimate::new(value, error)
    }
}

impl SlidingPlan {
    /// Pressure, gap and displacement along the surface: half of the places in the contact, half outside, dense at both edges.
    pub(super) fn fields(&self, partial: &PartialContact, points: u32) -> Result<Vec<FieldPoint>, Refusal> {
        let (state, values) = (&partial.state, &partial.values);
        let fields = Fields::new(partial);
        let (half_width, eccentricity) = (values.half_width.value, values.eccentricity.value);
        let inside = points / 2;
        let outside = points - inside;
        let penetration = if self.is_wave() { values.penetration } else { Estimate::exact(0.0) };
        // Of a wave the whole gap, from edge to edge; of a cylinder as much on each side as the contact is wide.
        let gap_width = if self.is_wave() { 2.0 * (PI - half_width) } else { 4.0 * half_width };
        let zero = Estimate::exact(0.0);
        let mut found = Vec::with_capacity(points as usize);
        for (count, contact) in [(inside, true), (outside, false)] {
            let width = if contact { 2.0 * half_width } else { gap_width };
            for index in 0..count {
                // Distances to the nearer edge, so that none is lost to rounding.
                let part = |index: u32| width * (0.5 * PI * (f64::from(index) + 0.5) / f64::from(count)).sin().powi(2);
                let near_start = 2 * index < count;
                let distance = if near_start { part(index) } else { part(count - 1 - index) };
                let (place, pressure, gap) = if contact {
                    let (point, place) = if near_start {
                        (state.inside_trailing(distance)?, eccentricity - half_width + distance)
                    } else {
                        (state.inside_leading(distance)?, eccentricity + half_width - distance)
                    };
                    (place, fields.bounded(point, ContactState::pressure_and_size, [-1.0, 1.0]), zero)
                } else {
                    let (point, place) = if near_start {
                        (state.ahead_of_leading(distance)?, eccentricity + half_width + distance)
                    } else {
                        (state.behind_trailing(distance)?, eccentricity - half_width - distance)
                    };
                    (place, zero, fields.bounded(point, ContactState::gap_and_size, [1.0, -1.0]))
                };
                let place = if self.is_wave() { wrapped(place) } else { place };
                let profile = if self.is_wave() { -2.0 * (0.5 * place).sin().powi(2) } else { -0.5 * place * place };
                let rounding = ROUNDING * (profile.abs() + penetration.value.abs() + gap.value.abs());
                let edge_error = fields.edges[0].max(fields.edges[1]);
                let slope = if self.is_wave() { place.sin().abs() } else { place.abs() };
                let displacement =
                    Estimate::new(profile + penetration.value + gap.value, gap.error + penetration.error + slope * edge_error + rounding);
                let values = vec![
                    self.in_units(pressure, self.scale.pressure),
                    self.in_units(gap, self.scale.displacement),
                    self.in_units(displacement, self.scale.displacement),
                ];
                found.push(FieldPoint { place: self.direction() * place * self.scale.length, values });
            }
        }
        found.sort_by(|left, right| left.place.total_cmp(&right.place));
        Ok(found)
    }
}

impl SlidingPlan {
    /// The same of a full contact, evenly along a wavelength: the surface is Λ cos kx about its mean, and the pressure one wave about its own;
    /// none without a mean pressure.
    pub(super) fn full_fields(&self, full: &FullContact, points: u32) -> Vec<FieldPoint> {
        let Some(mean) = full.mean_pressure else { return Vec::new() };
        let [along, across] = full.pressure_waves;
        let of = |index: u32| {
            let place = 2.0 * PI * ((f64::from(index) + 0.5) / f64::from(points) - 0.5);
            let (sine, cosine) = place.sin_cos();
            let size = mean.abs() + along.value.abs() + across.value.abs();
            let pressure = Estimate::new(
                mean + along.value * cosine + across.value * sine,
                along.error * cosine.abs() + across.error * sine.abs() + ROUNDING * size,
            );
            let values = vec![
                self.in_units(pressure, self.scale.pressure),
                self.in_units(Estimate::exact(0.0), self.scale.displacement),
                self.in_units(Estimate::new(cosine, ROUNDING), self.scale.displacement),
            ];
            FieldPoint { place: self.direction() * place * self.scale.length, values }
        };
        (0..points).map(of).collect()
    }
}

/// The same place of the wave between −π and π.
fn wrapped(place: f64) -> f64 {
    place - 2.0 * PI * (place / (2.0 * PI)).round()
}
