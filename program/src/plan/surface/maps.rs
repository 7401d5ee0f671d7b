//! Pressure, gap and height of a surface as maps.

use super::SurfacePlan;
use super::columns::field;
use super::figures::component;
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Figure, Map};

/// Cells of a map along each direction, at most.
const MOST_CELLS: usize = 160;

impl SurfacePlan {
    /// Maps of the first state that has fields.
    pub(super) fn field_maps(&self, states: &[&Row]) -> Vec<(String, Figure)> {
        let Some(row) = states.first() else { return Vec::new() };
        let places = |of: &dyn Fn(usize) -> f64| {
            let mut places: Vec<f64> = (0..row.fields.len()).map(of).collect();
            places.sort_by(f64::total_cmp);
            places.dedup();
            places
        };
        let x_of = |i: usize| row.fields.get(i).map_or(f64::NAN, |point| point.place);
        let y_of = |i: usize| row.fields.get(i).map_or(f64::NAN, |point| component(point, 0));
        let (all_across, all_up) = (places(&x_of), places(&y_of));
        let every = |places: &[f64]| places.len().div_ceil(MOST_CELLS).max(1);
        let (step_x, step_y) = (every(&all_across), every(&all_up));
        let across: Vec<f64> = all_across.iter().copied().step_by(step_x).collect();
        let up: Vec<f64> = all_up.iter().copied().step_by(step_y).collect();
        let index = |places: &[f64], value: f64| places.binary_search_by(|place| place.total_cmp(&value)).ok();
        let wanted = [
            ("pressure_map", field::PRESSURE, self.stress_label()),
            ("gap_map", field::GAP, self.label("gap", "$g$", " (m)", r"$g/\Lambda$")),
            ("surface_map", field::PROFILE, self.label("height of the sliding surface", "$h$", " (m)", r"$h/\Lambda$")),
        ];
        wanted
            .into_iter()
            .map(|(name, place, label)| {
                let mut values = vec![f64::NAN; across.len() * up.len()];
                for point in &row.fields {
                    if let (Some(column), Some(line)) = (index(&across, point.place), index(&up, component(point, 0)))
                        && let Some(cell) = values.get_mut(line * across.len() + column)
                    {
                        *cell = component(point, 1 + place);
                    }
                }
                let vertical = Axis::linear(self.label("position across", "$y$", " (m)", "$ky$"));
                let mut figure = Figure::new(self.place_axis(), vertical);
                if states.len() > 1 {
                    figure.add_note(format!("the first of {} states", states.len()));
                }
                if step_x > 1 || step_y > 1 {
                    figure.add_note(format!("every {step_x}. and {step_y}. place is drawn"));
                }
                figure.map = Some(Map { across: across.clone(), up: up.clone(), values, colours: Axis::linear(label) });
                (name.to_owned(), figure)
            })
            .collect()
    }
}
