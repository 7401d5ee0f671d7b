//! Pressure, displacement and gap at chosen times.

use super::super::fields::places;
use super::super::rows::Values;
use super::FiniteRangePlan;
use super::bounds::Runs;
use crate::outcome::FieldPoint;
use viscotack::estimate::Estimate;
use viscotack::finite_range::sphere::{Place, Record, Surface};

/// A field is never known better than this part of its largest value.
const ROUNDING: f64 = 1e-11;
/// Without any contact fields reach out so many lateral lengths √(R h₀).
const REACH_OF_NO_CONTACT: f64 = 4.0;

impl FiniteRangePlan {
    /// The rows of the wanted times that were reached, with their fields.
    pub(super) fn fields_of(&self, runs: &Runs) -> Vec<(Values, Vec<FieldPoint>)> {
        let Some(wanted) = &self.indentation.fields else { return Vec::new() };
        let pairs: Vec<(&Surface, &Surface)> = runs.loose.surfaces.iter().zip(&runs.tight.surfaces).collect();
        let units = &self.reduced.scales;
        let record = |runs: &[Record], surface: &Surface| runs.get(surface.row).copied();
        let found: Vec<(Record, Record, &Surface, &Surface)> = pairs
            .into_iter()
            .filter_map(|(loose, tight)| Some((record(&runs.loose.rows, loose)?, record(&runs.tight.rows, tight)?, loose, tight)))
            .collect();
        let largest = found.iter().fold(0.0_f64, |most, (_, record, ..)| most.max(record.contact_radius)) * units.radius;
        let reach = wanted.to.unwrap_or(if largest > 0.0 { 2.0 * largest } else { REACH_OF_NO_CONTACT * units.radius });
        found
            .iter()
            .map(|(loose_row, row, loose, tight)| {
                let radii = places(row.contact_radius * units.radius, reach, wanted.points);
                (self.of_record(loose_row, row, runs), self.points(row.time, loose, tight, &radii))
            })
            .collect()
    }

    fn points(&self, time: f64, loose: &Surface, tight: &Surface, radii: &[f64]) -> Vec<FieldPoint> {
        let units = &self.reduced.scales;
        let both: Vec<(f64, Place, Place)> =
            radii.iter().map(|&radius| (radius, loose.at(radius / units.radius), tight.at(radius / units.radius))).collect();
        let of = [|place: &Place| place.pressure, |place: &Place| place.displacement, |place: &Place| place.gap];
        let in_scene = [units.pressure / self.scale.force, units.gap, units.gap];
        let most = of.map(|of| both.iter().fold(0.0_f64, |most, (.., place)| most.max(of(place).abs())));
        both.iter()
            .map(|(radius, loose, tight)| {
                let mut values = vec![Estimate::exact(time)];
                for ((of, unit), most) in of.iter().zip(in_scene).zip(most) {
                    let error = (of(loose) - of(tight)).abs() + ROUNDING * most;
                    values.push(Estimate::new(of(tight) * unit, error * unit));
                }
                FieldPoint { place: *radius, values }
            })
            .collect()
    }
}
