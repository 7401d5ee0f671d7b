//! The plots of an indenter that attracts at a distance: curves of every state, pull-off against what is swept, surfaces.

use super::super::agreement;
use super::super::cycle_figures::CycleFigures;
use super::super::figures::{MOST_STATES, State, axis, label, states};
use super::super::rows::LARGEST_TENSION;
use super::FiniteRangePlan;
use super::columns::{at, columns, field, position};
use super::rows::DETACHMENT;
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::plan::curves::{axis_of, innermost, noted, shade, short, swept_axis, swept_label, thinned, thinning, value};
use crate::plan::maps::Answer;
use crate::scene::typed::{HistoryQuantity, Scene, Units};

impl FiniteRangePlan {
    pub(super) fn drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut numbers: Vec<usize> = rows.iter().filter(|row| row.status.has_values()).map(|row| row.state).collect();
        numbers.dedup();
        if numbers.is_empty() {
            return Vec::new();
        }
        let states = states(scene, rows);
        let mut figures = vec![
            ("force_against_penetration".to_owned(), self.figure(&states, at::PENETRATION, at::FORCE)),
            ("contact_radius_against_penetration".to_owned(), self.figure(&states, at::PENETRATION, at::CONTACT_RADIUS)),
        ];
        let by_force = self.timeline.legs.iter().any(|leg| leg.quantity != HistoryQuantity::Penetration);
        if self.timeline.in_time || by_force {
            for (name, column) in [
                ("force_against_time", at::FORCE),
                ("contact_radius_against_time", at::CONTACT_RADIUS),
                ("penetration_against_time", at::PENETRATION),
            ] {
                figures.push((name.to_owned(), self.figure(&states, at::TIME, column)));
            }
        }
        let note = thinning(numbers.len(), MOST_STATES, "states");
        figures = noted(figures, note.clone());
        figures.extend(self.cycle_figures().figures(scene, rows, &states, note.as_ref()));
        figures.extend(self.pull_off_figure(scene, rows));
        let first = (numbers.len() > 1).then(|| format!("of the first of {} states", numbers.len()));
        figures.extend(noted(self.field_figures(&states), first));
        figures
    }

    fn cycle_figures(&self) -> CycleFigures {
        CycleFigures::new(&columns(&self.indentation, self.units), self.units, false)
    }

    fn label(&self, quantity: &str, symbol: &str, unit: &str, reduced: &str) -> String {
        label(self.units, quantity, symbol, unit, reduced)
    }

    fn axis(&self, column: usize) -> Axis {
        axis(column, self.units)
    }

    fn figure(&self, states: &[State<'_>], horizontal: usize, vertical: usize) -> Figure {
        let mut figure = Figure::new(self.axis(horizontal), self.axis(vertical));
        let cycles = self.cycle_figures();
        for state in states {
            let points = cycles.way(state, [horizontal, vertical]);
            figure = figure.with_curve(Curve::new(state.label.clone(), points).with(state.colour).with_line(Line::Solid));
            if horizontal == at::TIME {
                figure = cycles.envelope(state, vertical).into_iter().fold(figure, Figure::with_curve);
            }
        }
        let place = |column: usize| position(&self.indentation, column).filter(|_| vertical == at::FORCE);
        if let (Some(measured), Some(deviation), Some(state)) = (place(at::MEASURED_FORCE), place(at::FORCE_DEVIATION), states.first()) {
            figure = agreement::put_on(figure, &state.rows, [horizontal, measured, deviation], self.units);
        }
        let marked = |word: &str| -> Vec<(f64, f64)> {
            let rows = states.iter().flat_map(|state| &state.rows).filter(|row| row.label(1) == word);
            rows.map(|row| (value(row, horizontal), value(row, vertical))).collect()
        };
        let marks = [(DETACHMENT, Marker::OpenCircle, 2), ("jump_in", Marker::Circle, 1), ("partial_detachment", Marker::Circle, 3)];
        for (word, marker, colour) in marks {
            let points = marked(word);
            if !points.is_empty() {
                let curve = Curve::new(word.replace('_', " "), points);
                figure = figure.with_curve(curve.with_line(Line::None).with_marker(marker).with_colour(colour));
            }
        }
        figure
    }

    /// Loss of an oscillation; else pull-off.
    pub(super) fn main_answer(&self) -> Option<Answer> {
        if self.timeline.oscillates() {
            let label = self.label("loss stiffness", "$k''$", " (N/m)", r"$k''/\pi E_0^* R$");
            return Some(Answer { column: position(&self.indentation, at::LOSS_STIFFNESS)?, axis: Axis::linear(label) });
        }
        let label = self.label("pull-off force", r"$F_\mathrm{off}$", " (N)", r"$F_\mathrm{off}/\pi E_0^* R^2$");
        Some(Answer { column: position(&self.indentation, at::PULL_OFF_FORCE)?, axis: Axis::linear(label) })
    }

    /// The pull-off against the innermost swept number, a curve for each set of outer ones.
    fn pull_off_figure(&self, scene: &Scene, rows: &[Row]) -> Option<(String, Figure)> {
        let sweep = scene.sweeps.last().filter(|sweep| !sweep.key.ends_with(".force"))?;
        let outer = scene.sweeps.len() - 1;
        let ratio = position(&self.indentation, at::PULL_OFF_RATIO)?;
        let found: Vec<&Row> = rows.iter().filter(|row| row.label(1) == LARGEST_TENSION && row.value(ratio).is_some()).collect();
        if found.len() < 2 {
            return None;
        }
        let horizontal =
            if sweep.key == "indentation.speed_factor" { axis_of(sweep, "speed factor".to_owned()) } else { swept_axis(sweep) };
        let mut sets: Vec<&[f64]> = found.iter().map(|row| row.swept.get(..outer).unwrap_or(&[])).collect();
        sets.dedup();
        let note = thinning(sets.len(), MOST_STATES, "values of the outer sweep");
        let sets = thinned(sets, MOST_STATES);
        let mut figure = Figure::new(horizontal, Axis::linear(r"pull-off force $F_\mathrm{off}/F_\mathrm{JKR}$"));
        figure.note = note;
        for (place, set) in sets.iter().enumerate() {
            let own = found.iter().filter(|row| row.swept.get(..outer).unwrap_or(&[]) == *set);
            let points = own.map(|row| (innermost(row), value(row, ratio))).collect();
            let curve = Curve::new(swept_label(scene, set), points);
            figure = figure.with_curve(curve.with(shade(place, sets.len())).with_line(Line::Solid).with_marker(Marker::Circle));
        }
        Some(("pull_off_against_sweep".to_owned(), figure))
    }

    /// Pressure, displacement and gap of the first state at each chosen time, and both surfaces.
    fn field_figures(&self, states: &[State<'_>]) -> Vec<(String, Figure)> {
        let Some(state) = states.first() else { return Vec::new() };
        let rows: Vec<&&Row> = state.rows.iter().filter(|row| !row.fields.is_empty()).collect();
        if rows.is_empty() {
            return Vec::new();
        }
        let draw = |vertical: Axis, place: usize, sign: f64| {
            let mut figure = Figure::new(Axis::linear(self.label("distance from the axis", "$r$", " (m)", "$r/R$")), vertical);
            for (colour, row) in rows.iter().enumerate() {
                let time = row.fields.first().and_then(|point| point.values.get(field::TIME)).map_or(0.0, |time| time.value);
                let unit = if self.units == Units::Si { " s" } else { "" };
                let points = row.fields.iter().filter_map(|point| Some((point.place, sign * point.values.get(place)?.value))).collect();
                figure = figure.with_curve(Curve::new(format!("$t$ = {}{unit}", short(time)), points).with(shade(colour, rows.len())));
            }
            figure
        };
        let axis = |quantity, symbol, unit, reduced| Axis::linear(self.label(quantity, symbol, unit, reduced));
        vec![
            ("pressure_against_radius".to_owned(), draw(axis("pressure", "$p$", " (Pa)", r"$p/\pi E_0^*$"), field::PRESSURE, 1.0)),
            ("surface_against_radius".to_owned(), draw(axis("height of the surface", "$-w$", " (m)", "$-w/R$"), field::DISPLACEMENT, -1.0)),
            ("gap_against_radius".to_owned(), draw(axis("gap", "$g$", " (m)", "$g/R$"), field::GAP, 1.0)),
        ]
    }
}
