//! One state of a steady crack: the theories' curves at the prescribed speed or load, as rows.

use super::columns::{COLUMNS, columns};
use super::{Prescribed, SteadyCrackPlan};
use crate::outcome::{Certificate, FieldPoint, Row, Status, Witness, Work};
use crate::scene::typed::{Fields, Theory, Units};
use std::f64::consts::{PI, TAU};
use viscotack::crack::near_tip::{ClosingTip, OpeningTip};
use viscotack::crack::{Motion, SteadyState, at_drive, at_speed};
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;

/// The tightest tolerance asked of a root: below it only rounding is left.
const TIGHTEST: f64 = 1e-15;

impl SteadyCrackPlan {
    pub(super) fn row(&self, theory: Theory, state: usize, swept: &[f64]) -> Row {
        let mut row = Row::new(state, swept, vec![theory.word().to_owned()], COLUMNS.len());
        if let Err(refusal) = self.fill(theory, &mut row) {
            row.refuse(&refusal);
        }
        row
    }

    fn fill(&self, theory: Theory, row: &mut Row) -> Result<(), Refusal> {
        // A tenth of the wanted accuracy; if the curve is too steep there for the error bound, once more to rounding.
        let mut state = self.state(theory, (0.1 * self.accuracy).max(TIGHTEST), &mut row.work)?;
        row.values = self.values(theory, &state)?;
        if self.shortfall(&row.values).is_some() {
            state = self.state(theory, TIGHTEST, &mut row.work)?;
            row.values = self.values(theory, &state)?;
        }
        if let Some((name, error)) = self.shortfall(&row.values) {
            row.status = Status::Inaccurate;
            row.reason = Some(format!("the error bound of {name} is {error:.1e}, above the wanted accuracy {:.1e}", self.accuracy));
        }
        let beta = self.plane_material.stiffening_ratio();
        // Between its limits, at which it may lie, by its own error.
        let admissible = state.drive.value > 0.0
            && state.energy_release_rate_ratio.is_none_or(|ratio| {
                let (low, high) = match self.crack.motion {
                    Motion::Opening => (1.0, beta),
                    Motion::Closing => (1.0 / beta, 1.0),
                };
                let uncertainty = ratio.error + 4.0 * f64::EPSILON * ratio.value;
                ratio.value >= low - uncertainty && ratio.value <= high + uncertainty
            });
        row.certificate = Some(Certificate { residual: state.residual, condition: self.condition(&state), admissible });
        if !admissible {
            let value = state.energy_release_rate_ratio.map_or(state.drive.value, |ratio| ratio.value);
            row.witness = Some(Witness { name: "energy release rate over the work of adhesion, beyond its limits".into(), value });
        }
        row.assumptions = self.assumptions(&row.values);
        if let (Some(fields), Theory::VirtualWork) = (self.crack.fields, theory) {
            row.fields = self.fields(&fields, &state)?;
            row.work.field_evaluations += u64::from(fields.points);
        }
        row.representable(&columns(self.units))
    }

    fn state(&self, theory: Theory, tolerance: f64, work: &mut Work) -> Result<SteadyState, Refusal> {
        let curve = self.curve(theory)?;
        let state = match self.prescribed()? {
            Prescribed::Speed(speed) => at_speed(&curve, speed, tolerance)?,
            Prescribed::Drive(drive) => at_drive(&curve, drive, tolerance)?,
        };
        work.closure_evaluations += state.curve_points;
        work.kernel_evaluations += state.kernel_evaluations;
        Ok(state)
    }

    /// How strongly the found quantity feels the given one.
    fn condition(&self, state: &SteadyState) -> f64 {
        match self.prescribed() {
            Ok(Prescribed::Speed(_)) | Err(_) => state.speed_exponent.abs(),
            Ok(Prescribed::Drive(_)) => state.speed_exponent.abs().recip().min(f64::MAX),
        }
    }

    /// √(2ΔγE0/halves): the stress intensity at G = Δγ; zero for a viscous material.
    fn intensity_scale(&self) -> f64 {
        self.crack.body.intensity_squared(self.crack.work_of_adhesion, self.plane_material.relaxed_modulus()).sqrt()
    }

    /// The values of a row in the order of the columns, in the scene's units.
    fn values(&self, theory: Theory, state: &SteadyState) -> Result<Vec<Option<Estimate>>, Refusal> {
        let (work, body, material) = (self.crack.work_of_adhesion, self.crack.body, &self.plane_material);
        let amplitude =
            Estimate::relative(body.intensity_squared(work, state.drive.value), state.drive.relative_error() + f64::EPSILON).powf(0.5);
        let glassy = material.glassy_modulus();
        let (intensity, tip_intensity, displacement) = match self.crack.motion {
            Motion::Opening => (Some(amplitude), Some(amplitude), None),
            Motion::Closing => {
                let remote = material.solid_modulus("").ok().map(|modulus| amplitude.scaled(modulus));
                (remote, Some(amplitude.scaled(glassy)), Some(amplitude))
            }
        };
        let radius = |intensity: Estimate| intensity.powf(2.0).scaled(4.0 / PI);
        let (glassy_radius, relaxed_radius) = match self.crack.motion {
            Motion::Opening => (
                Some(radius(amplitude.scaled(1.0 / glassy))),
                material.solid_modulus("").ok().map(|modulus| radius(amplitude.scaled(1.0 / modulus))),
            ),
            Motion::Closing => (Some(radius(amplitude)), None),
        };
        // The crossing length of Persson and Brener's theory is the cut-off over 2π.
        let zone = if theory == Theory::PerssonBrener { state.crossing_length.scaled(TAU) } else { state.crossing_length };
        // Reduced: K in √(2E0Δγ), K₁/E0 in √(2Δγ/E0), with E0 = Δγ = 1.
        let unit = if self.units == Units::Reduced { 0.5_f64.sqrt() } else { 1.0 };
        Ok(vec![
            Some(state.speed),
            state.energy_release_rate_ratio.map(|ratio| ratio.scaled(work)),
            state.energy_release_rate_ratio,
            intensity.map(|value| value.scaled(unit)),
            tip_intensity.map(|value| value.scaled(unit)),
            displacement.map(|value| value.scaled(unit)),
            Some(zone),
            state.crossing_time.is_finite().then(|| Estimate::relative(state.crossing_time, state.crossing_time_error + f64::EPSILON)),
            Some(Estimate::new(state.speed_exponent, state.speed_exponent_error)),
            glassy_radius,
            relaxed_radius,
        ])
    }

    /// The first column whose error bound is above the wanted accuracy of the larger of its value and its reference scale.
    fn shortfall(&self, values: &[Option<Estimate>]) -> Option<(&'static str, f64)> {
        let unit = if self.units == Units::Reduced { 0.5_f64.sqrt() } else { 1.0 };
        let intensity = self.intensity_scale() * unit;
        let scale = |name: &str| match name {
            "energy_release_rate" => self.crack.work_of_adhesion,
            "energy_release_rate_ratio" | "speed_exponent" => 1.0,
            "stress_intensity" | "tip_stress_intensity" => intensity,
            _ => 0.0,
        };
        COLUMNS.iter().zip(values).find_map(|(column, value)| {
            let estimate = (*value)?;
            let allowed = self.accuracy * estimate.value.abs().max(scale(column.name));
            // An infinite speed limit and an exact zero carry no error.
            (estimate.error > allowed).then(|| (column.name, estimate.error / estimate.value.abs().max(scale(column.name))))
        })
    }

    fn fields(&self, fields: &Fields, state: &SteadyState) -> Result<Vec<FieldPoint>, Refusal> {
        let amplitude = self.crack.body.intensity_squared(self.crack.work_of_adhesion, state.drive.value).sqrt();
        let intensity_error = 0.5 * state.drive.relative_error() + f64::EPSILON;
        let steps = f64::from(fields.points.saturating_sub(1).max(1));
        // What a field changes where the speed moves by its own bound is part of its bound.
        let at = |speed: f64, distance: f64| -> Result<[Estimate; 2], Refusal> {
            Ok(match self.crack.motion {
                Motion::Opening => {
                    let tip = OpeningTip::new(&self.plane_material, self.crack.body, amplitude, speed)?;
                    [tip.displacement(distance)?, Estimate::relative(amplitude / (TAU * distance).sqrt(), 2.0 * f64::EPSILON)]
                }
                Motion::Closing => {
                    let tip = ClosingTip::new(&self.plane_material, self.crack.body, amplitude, speed)?;
                    [tip.displacement(distance)?, tip.stress(distance)?]
                }
            })
        };
        let speed = state.speed;
        (0..fields.points)
            .map(|index| {
                let distance = fields.from * (fields.to / fields.from).powf(f64::from(index) / steps);
                let (here, faster) = (at(speed.value, distance)?, at(speed.value + speed.error, distance)?);
                let widened = here.iter().zip(&faster).map(|(here, faster)| {
                    let moved = (faster.value - here.value).abs();
                    Estimate::new(here.value, here.error + moved + intensity_error * here.value.abs())
                });
                Ok(FieldPoint { place: distance, values: widened.collect() })
            })
            .collect()
    }
}
