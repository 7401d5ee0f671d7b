//! The plots of a crack under a load history: place and speed of the tip against time, events marked; over a sweep the delay and the speeds.

use super::DelayedFracturePlan;
use super::columns::at;
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::plan::curves::{innermost, noted, say_what_bands_are, shade, swept_axis, swept_label, thinned, thinning, value};
use crate::plan::maps::Answer;
use crate::scene::typed::{HistorySegment, Scene, Units};

/// Most states whose tips are drawn in one figure.
const MOST_STATES: usize = 7;
/// More events of one kind than these are not marked.
const MOST_MARKS: usize = 60;
/// Speeds below this part of the greatest lie under the frame of a logarithmic plot.
const SLOWEST: f64 = 1e-6;

/// Cracks that grow to lengths further from each other than this are drawn over decades.
const DIFFERENT_GROWTH: f64 = 100.0;

/// Events that are marked.
const MARKS: [(&str, Marker, &str); 5] = [
    ("onset", Marker::Circle, "onset"),
    ("kink", Marker::Diamond, "rest leaves the zone"),
    ("arrest", Marker::Square, "arrest"),
    ("restart", Marker::Triangle, "restart"),
    ("jump", Marker::OpenCircle, "jump with the load"),
];

impl DelayedFracturePlan {
    fn label(&self, name: &str, si: &str, reduced: &str) -> String {
        if self.units == Units::Si { format!("{name} {si}") } else { format!("{name} {reduced}") }
    }

    pub(super) fn drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut figures = Vec::new();
        // A tip that rests all the time has nothing to show.
        let grows = rows.iter().any(|row| row.value(at::GROWTH).is_some_and(|growth| growth > 0.0));
        if grows && rows.iter().any(|row| row.label(0) == "sample") {
            let ends = rows.iter().filter(|row| row.label(0) == "summary").filter_map(|row| row.value(at::GROWTH)).filter(|end| *end > 0.0);
            let (least, most) = ends.fold((f64::INFINITY, 0.0_f64), |(least, most), end| (least.min(end), most.max(end)));
            let logarithmic = self.crack.output.first.is_some() || most > DIFFERENT_GROWTH * least;
            let time = || {
                let label = self.label("time", "$t$ (s)", r"$t/\tau$");
                if logarithmic { Axis::logarithmic(label) } else { Axis::linear(label) }
            };
            let growth = self.label("growth", "$x_0$ (m)", "$x_0/a_0$");
            let growth = if logarithmic { Axis::logarithmic(growth) } else { Axis::linear(growth) };
            let speed = Axis::logarithmic(self.label("speed of the tip", r"$\dot{x}_0$ (m/s)", r"$\dot{x}_0\tau/a_0$"));
            let load = Axis::linear(self.label("stress intensity", "$K$ (Pa √m)", r"$K/\sqrt{2E_0\Delta\gamma}$"));
            figures.push(("growth_against_time".into(), self.against_time(scene, rows, (time(), growth), at::GROWTH)));
            figures.push(("speed_against_time".into(), self.against_time(scene, rows, (time(), speed), at::SPEED)));
            if !self.is_one_step() {
                figures
                    .push(("stress_intensity_against_time".into(), self.against_time(scene, rows, (time(), load), at::STRESS_INTENSITY)));
            }
        }
        figures.extend(self.against_swept(scene, rows));
        figures
    }

    pub(super) fn delay(&self) -> Answer {
        Answer { column: at::DELAY, axis: Axis::logarithmic(self.label("delay", "$t_d$ (s)", r"$t_d/\tau$")) }
    }

    fn against_time(&self, scene: &Scene, rows: &[Row], (horizontal, vertical): (Axis, Axis), column: usize) -> Figure {
        let mut states: Vec<usize> = rows.iter().map(|row| row.state).collect();
        states.dedup();
        let several = states.len() > 1;
        let note = thinning(states.len(), MOST_STATES, "states");
        let states = thinned(states, MOST_STATES);
        let fastest = rows.iter().filter_map(|row| row.value(at::SPEED)).fold(0.0, f64::max);
        let shown = |row: &Row| {
            let y = value(row, column);
            // A resting tip has no speed to draw.
            let y = if column == at::SPEED && (y <= SLOWEST * fastest || row.label(1) == "resting") { f64::NAN } else { y };
            (value(row, at::TIME), y)
        };
        let mut drawn = Figure::new(horizontal, vertical);
        drawn.note = note;
        for (colour, state) in states.iter().enumerate() {
            let own: Vec<&Row> = rows.iter().filter(|row| row.state == *state && row.label(0) != "summary").collect();
            let mut points = Vec::with_capacity(own.len());
            for row in &own {
                // Both sides of an event are drawn.
                if column == at::SPEED
                    && let Some(before) = row.value(at::SPEED_BEFORE)
                {
                    points.push((value(row, at::TIME), before));
                }
                if column == at::GROWTH
                    && let (Some(jump), Some(growth)) = (row.value(at::JUMP), row.value(at::GROWTH))
                {
                    points.push((value(row, at::TIME), growth));
                    points.push((value(row, at::TIME), growth + jump));
                    continue;
                }
                if row.label(2) != "jump" || column != at::SPEED {
                    points.push(shown(row));
                }
            }
            let label = match (several, own.first()) {
                (true, Some(row)) => swept_label(scene, &row.swept),
                _ => String::new(),
            };
            drawn = drawn.with_curve(Curve::new(label, points).with_line(Line::Solid).with(shade(colour, states.len())));
        }
        if column != at::STRESS_INTENSITY {
            for (event, marker, name) in MARKS {
                let of_event = |row: &&Row| states.contains(&row.state) && row.label(0) == "event" && row.label(2) == event;
                let place = |row: &Row| {
                    let y = if column == at::SPEED {
                        row.value(at::SPEED_BEFORE).filter(|_| event == "arrest").or(row.value(at::SPEED))
                    } else {
                        row.value(column)
                    };
                    (value(row, at::TIME), y.unwrap_or(f64::NAN))
                };
                let points: Vec<(f64, f64)> =
                    rows.iter().filter(of_event).map(place).filter(|point| point.1 > 0.0 || column != at::SPEED).collect();
                if points.len() > MOST_MARKS {
                    drawn.add_note(format!("{} events ({name}) are not marked", points.len()));
                } else if !points.is_empty() {
                    drawn = drawn.with_curve(Curve::new(name, points).with_line(Line::None).with_marker(marker).with_colour(2));
                }
            }
        }
        if column == at::GROWTH { self.with_measured(drawn, several) } else { drawn }
    }

    /// Columns called `growth` in the tables of the history: what was measured.
    fn with_measured(&self, mut drawn: Figure, several: bool) -> Figure {
        let mut start = 0.0;
        for segment in &self.crack.history.segments {
            match segment {
                HistorySegment::Table { table, .. } => {
                    if let Some(column) = table.others.iter().find(|column| column.name == "growth").filter(|_| !several) {
                        let points =
                            table.rows.iter().zip(&column.values).map(|(time, place)| (start + time, place.unwrap_or(f64::NAN))).collect();
                        drawn = drawn.with_curve(
                            Curve::new("measured", points).with_line(Line::None).with_marker(Marker::OpenSquare).with_colour(1),
                        );
                    }
                    start += table.times.last().copied().unwrap_or(0.0);
                }
                other => start += super::history::segments(&crate::scene::typed::History::of(vec![other.clone()])).1,
            }
        }
        drawn
    }

    /// Delay and speeds against the load, or against another swept number.
    fn against_swept(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let Some(sweep) = scene.sweeps.last() else { return Vec::new() };
        let load = sweep.key.starts_with("history.") && (sweep.key.ends_with("stress_intensity") || sweep.key.ends_with("stress"));
        // Without units the ratio of the release rates is what a load is seen against.
        let along_release = load && self.units == Units::Reduced && self.plane_material.relaxed_modulus() > 0.0;
        let horizontal =
            || if along_release { Axis::logarithmic(r"relaxed release ratio $cK^2/2\Delta\gamma E_0$") } else { swept_axis(sweep) };
        let across = |row: &Row| if along_release { value(row, at::RELAXED_RELEASE) } else { innermost(row) };
        let outer = scene.sweeps.len() - 1;
        let mut sets: Vec<&[f64]> = Vec::new();
        for row in rows {
            let set = row.swept.get(..outer).unwrap_or(&[]);
            if !sets.contains(&set) {
                sets.push(set);
            }
        }
        let note = thinning(sets.len(), MOST_STATES, "values of the outer sweep");
        let sets = thinned(sets, MOST_STATES);
        let draw = |vertical: Axis, column: usize, line: Line, figure: Option<(Figure, &str)>| {
            let (mut drawn, name) = figure.unwrap_or_else(|| (Figure::new(horizontal(), vertical), ""));
            for (colour, set) in sets.iter().enumerate() {
                let own = || rows.iter().filter(|row| row.label(0) == "summary" && row.swept.get(..outer).unwrap_or(&[]) == *set);
                let points: Vec<(f64, f64)> = own().map(|row| (across(row), value(row, column))).collect();
                let band = own().map(|row| row.material_deviation(column).unwrap_or(0.0)).collect();
                let label = if outer > 0 { swept_label(scene, set) } else { name.to_owned() };
                drawn = drawn.with_curve(Curve::new(label, points).with_line(line).with(shade(colour, sets.len())).with_band(band));
            }
            drawn
        };
        if rows.iter().filter(|row| row.label(0) == "summary").count() < 2 {
            return Vec::new();
        }
        let delay = self.delay().axis;
        let speed = || Axis::logarithmic(self.label("speed of the tip", r"$\dot{x}_0$ (m/s)", r"$\dot{x}_0\tau/a_0$"));
        let first = draw(speed(), at::INITIAL_SPEED, Line::Dashed, Some((Figure::new(horizontal(), speed()), "just after the delay")));
        let mut figures = vec![
            ("delay_against_load".into(), draw(delay, at::DELAY, Line::Solid, None)),
            ("speed_against_load".into(), draw(speed(), at::STEADY_SPEED, Line::Solid, Some((first, "at last")))),
        ];
        figures.iter_mut().for_each(|(_, figure)| say_what_bands_are(figure));
        noted(figures, note)
    }
}
