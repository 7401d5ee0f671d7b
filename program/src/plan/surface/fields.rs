//! Pressure, gap and both surfaces of a state, on some of the nodes of its grid.

use super::SurfacePlan;
use super::columns::Measure;
use crate::outcome::FieldPoint;
use std::f64::consts::TAU;
use viscotack::estimate::Estimate;
use viscotack::finite_range::line::SteadyState;

/// Rounding of a transform over the largest value.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl SurfacePlan {
    /// The fields on at most `points` nodes along each direction; each place is a node, nothing is interpolated.
    pub(super) fn fields(&self, state: &SteadyState, points: usize) -> Vec<FieldPoint> {
        let fields = &state.fields;
        let chosen = |nodes: usize| {
            let count = points.clamp(1, nodes);
            (0..count).map(move |k| k * nodes / count)
        };
        let (dx, dy) = (TAU / fields.nx as f64, TAU * self.profile.aspect() / fields.ny as f64);
        let centred = self.sliding.surface.word == "wave";
        let [pressure_errors, gap_errors] = &state.field_errors;
        // Heights on a grid are a sum of waves.
        let rounding = ROUNDING * self.profile.half_height();
        let mut found: Vec<FieldPoint> = Vec::new();
        for j in chosen(fields.ny) {
            for i in chosen(fields.nx) {
                let node = j * fields.nx + i;
                let at = |values: &[f64]| values.get(node).copied().unwrap_or(f64::NAN);
                // A profile that slides towards −x was mirrored for the solver.
                let i = if self.direction() < 0.0 { (fields.nx - i) % fields.nx } else { i };
                let mut x = i as f64 * dx;
                if centred && 2 * i >= fields.nx {
                    x -= TAU;
                }
                let gap_error = at(gap_errors);
                // From its mean the displaced surface is gap + profile − mean gap.
                let displacement_error = gap_error + state.errors.mean_gap + rounding;
                let mut values = Vec::with_capacity(5);
                if !self.is_line() {
                    values.push(Estimate::exact(j as f64 * dy * self.scales.length));
                }
                values.extend([
                    self.in_units(Estimate::new(at(&fields.pressure), at(pressure_errors)), Measure::Pressure),
                    self.in_units(Estimate::new(at(&fields.gap), gap_error), Measure::Height),
                    self.in_units(Estimate::new(at(&fields.surface), displacement_error), Measure::Height),
                    self.in_units(Estimate::new(at(&fields.profile), rounding), Measure::Height),
                ]);
                found.push(FieldPoint { place: x * self.scales.length, values });
            }
        }
        if self.is_line() {
            found.sort_by(|left, right| left.place.total_cmp(&right.place));
        }
        found
    }
}
