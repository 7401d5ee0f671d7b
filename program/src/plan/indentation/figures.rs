//! The plots of an indentation: a curve for every state, elastic limits, measured forces, fields.

use super::columns::{at, columns, field, position};
use super::cycle_figures::CycleFigures;
use super::rows::{CYCLE, LARGEST_TENSION, REPETITION, SUMMARY};
use super::{IndentationPlan, agreement};
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line, Marker};
use crate::plan::curves::{axis_of, innermost, noted, say_what_bands_are, shade, swept_axis, swept_label, thinned, thinning, value};
use crate::plan::maps::Answer;
use crate::scene::typed::{HistoryQuantity, IndentationShape, Scene, Units};
use viscotack::elastic::JkrSphere;

/// Most states that one figure distinguishes.
pub(super) const MOST_STATES: usize = 7;
/// Events after which there is no contact.
pub(super) const LOSSES: [&str; 2] = ["detachment", "zone_reached"];
/// Histories whose durations differ more than this are drawn over the logarithm of time.
const DIFFERENT_ENDS: f64 = 10.0;
/// Times of two histories that are the same, within rounding.
const SAME_TIME: f64 = 1e-9;
/// What is shown beside the contact, over the way on which it holds.
const BESIDE: f64 = 0.2;
/// Points of an elastic curve.
const ELASTIC_POINTS: usize = 200;

/// The rows of one state.
pub(super) struct State<'a> {
    pub(super) label: String,
    pub(super) colour: Colour,
    /// Instants, events and fields.
    pub(super) rows: Vec<&'a Row>,
    /// Cycles of oscillations.
    pub(super) cycles: Vec<&'a Row>,
    /// Groups of segments that repeat.
    pub(super) repetitions: Vec<&'a Row>,
}

/// States with values, in order, not more than a legend can distinguish.
pub(super) fn states<'a>(scene: &Scene, rows: &'a [Row]) -> Vec<State<'a>> {
    let mut numbers: Vec<usize> = rows.iter().filter(|row| row.status.has_values()).map(|row| row.state).collect();
    numbers.dedup();
    let of = |state: usize| rows.iter().filter(|row| row.state == state && row.status.has_values()).collect::<Vec<_>>();
    let numbers = thinned(numbers, MOST_STATES);
    let count = numbers.len();
    numbers
        .into_iter()
        .enumerate()
        .map(|(place, state)| {
            let own = of(state).into_iter().filter(|row| row.label(0) != SUMMARY);
            let (cycles, rows): (Vec<&Row>, Vec<&Row>) = own.partition(|row| row.label(0) == CYCLE);
            let (repetitions, rows): (Vec<&Row>, Vec<&Row>) = rows.into_iter().partition(|row| row.label(0) == REPETITION);
            let label = rows.first().map_or_else(String::new, |row| swept_label(scene, &row.swept));
            State { label, colour: shade(place, count), rows, cycles, repetitions }
        })
        .collect()
}

/// A quantity with its symbol and unit, in either system of units.
pub(super) fn label(units: Units, quantity: &str, symbol: &str, unit: &str, reduced: &str) -> String {
    if units == Units::Si { format!("{quantity} {symbol}{unit}") } else { format!("{quantity} {reduced}") }
}

/// The axis of a column of instants, of which the first four are those of both theories.
pub(super) fn axis(column: usize, units: Units) -> Axis {
    Axis::linear(match column {
        at::FORCE => label(units, "force", "$F$", " (N)", r"$F/\pi E_0^* R^2$"),
        at::CONTACT_RADIUS => label(units, "contact radius", "$a$", " (m)", "$a/R$"),
        at::PENETRATION => label(units, "penetration", r"$\Delta$", " (m)", r"$\Delta/R$"),
        at::FRAME => label(units, "frame displacement", r"$\Delta_\mathrm{f}$", " (m)", r"$\Delta_\mathrm{f}/R$"),
        _ => label(units, "time", "$t$", " (s)", r"$t/t_0$"),
    })
}

impl IndentationPlan {
    fn cycle_figures(&self) -> CycleFigures {
        CycleFigures::new(&columns(&self.indentation, self.units), self.units, true)
    }

    pub(super) fn drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let states = states(scene, rows);
        if states.is_empty() {
            return Vec::new();
        }
        let mut figures = vec![
            ("force_against_penetration".to_owned(), self.equilibrium_figure(&states, at::FORCE)),
            ("contact_radius_against_penetration".to_owned(), self.equilibrium_figure(&states, at::CONTACT_RADIUS)),
        ];
        figures.extend(
            position(&self.indentation, at::FRAME).map(|frame| ("force_against_frame".to_owned(), self.frame_figure(&states, frame))),
        );
        let by_force = self.timeline.legs.iter().any(|leg| leg.quantity != HistoryQuantity::Penetration);
        if self.timeline.in_time || by_force {
            for (name, column) in [
                ("force_against_time", at::FORCE),
                ("contact_radius_against_time", at::CONTACT_RADIUS),
                ("penetration_against_time", at::PENETRATION),
            ] {
                figures.push((name.to_owned(), self.time_figure(&states, column)));
            }
        }
        figures.extend(self.own_time_figure(&states).map(|figure| ("force_against_own_time".to_owned(), figure)));
        let mut numbers: Vec<usize> = rows.iter().filter(|row| row.status.has_values()).map(|row| row.state).collect();
        numbers.dedup();
        let note = thinning(numbers.len(), MOST_STATES, "states");
        figures = noted(figures, note.clone());
        figures.extend(self.cycle_figures().figures(scene, rows, &states, note.as_ref()));
        figures.extend(self.pull_off_figures(scene, rows));
        let first = (numbers.len() > 1).then(|| format!("of the first of {} states", numbers.len()));
        figures.extend(noted(self.field_figures(&states), first));
        figures.extend(self.scan_figures());
        figures
    }

    pub(super) fn label(&self, quantity: &str, symbol: &str, unit: &str, reduced: &str) -> String {
        label(self.units, quantity, symbol, unit, reduced)
    }

    fn axis(&self, column: usize) -> Axis {
        axis(column, self.units)
    }

    fn curve(&self, state: &State<'_>, horizontal: usize, vertical: usize) -> Curve {
        // The largest tension belongs to the curve; fields repeat what is between its instants.
        let points = self.cycle_figures().way(state, [horizontal, vertical]);
        Curve::new(state.label.clone(), points).with(state.colour).with_line(Line::Solid)
    }

    /// A quantity against the penetration, with the elastic limits, and a mark where the contact was lost.
    fn equilibrium_figure(&self, states: &[State<'_>], column: usize) -> Figure {
        let mut figure = Figure::new(self.in_contact(self.axis(at::PENETRATION), states, at::PENETRATION), self.axis(column));
        for curve in self.elastic_curves(states, column) {
            figure = figure.with_curve(curve);
        }
        for state in states {
            figure = figure.with_curve(self.curve(state, at::PENETRATION, column));
        }
        let lost: Vec<(f64, f64)> = states
            .iter()
            .flat_map(|state| &state.rows)
            .filter(|row| LOSSES.contains(&row.label(1)))
            .map(|row| (value(row, at::PENETRATION), value(row, column)))
            .collect();
        if !lost.is_empty() {
            figure = figure.with_curve(Curve::new("detachment", lost).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(2));
        }
        if column == at::FORCE {
            figure = self.with_measured(figure, states, at::PENETRATION);
        }
        figure
    }

    /// The force against the far end of the frame: what a testing machine records.
    fn frame_figure(&self, states: &[State<'_>], frame: usize) -> Figure {
        let mut figure = Figure::new(self.in_contact(self.axis(at::FRAME), states, frame), self.axis(at::FORCE));
        for state in states {
            figure = figure.with_curve(self.curve(state, frame, at::FORCE));
        }
        self.with_measured(figure, states, frame)
    }

    /// An axis without most of the way on which nothing touches any more; a measured curve goes on there.
    fn in_contact(&self, axis: Axis, states: &[State<'_>], column: usize) -> Axis {
        let span = |held: bool| {
            let touches = |row: &&&Row| !held || row.value(at::CONTACT_RADIUS).is_some_and(|radius| radius > 0.0);
            let values = states.iter().flat_map(|state| &state.rows).filter(touches).filter_map(|row| row.value(column));
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
        };
        let ((low, high), (least, most)) = (span(true), span(false));
        let room = BESIDE * (high - low);
        if high > low && most - least > high - low + 2.0 * room && position(&self.indentation, at::MEASURED_FORCE).is_none() {
            let margin = 0.25 * room;
            return axis.with_range(least.max(low - room) - margin, most.min(high + room) + margin);
        }
        axis
    }

    /// JKR's curves of both moduli over the penetrations that the states have; nothing for shapes without a closed form.
    fn elastic_curves(&self, states: &[State<'_>], column: usize) -> Vec<Curve> {
        let (Some(adhesion), &IndentationShape::Sphere { radius }) = (self.adhesion(), &self.indentation.shape) else { return Vec::new() };
        if self.profile.rim().is_finite() {
            return Vec::new();
        }
        let spans = |column: usize| {
            let values = states.iter().flat_map(|state| &state.rows).filter_map(move |row| row.value(column));
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
        };
        let (low, high) = spans(at::PENETRATION);
        let (least, most) = spans(column);
        let room = 0.1 * (most - least);
        let of = |modulus: f64, label: &str, line: Line| {
            let sphere = JkrSphere::new(radius, modulus, adhesion.work_of_adhesion).ok()?;
            let first = sphere.pull_off(viscotack::elastic::Control::Penetration).ok()?.contact_radius;
            let last = sphere.state_by_penetration(high, viscotack::elastic::EquilibriumBranch::Stable).ok()?.contact_radius;
            let points: Vec<(f64, f64)> = (0..=ELASTIC_POINTS)
                .filter_map(|index| {
                    let a = first + (last - first) * index as f64 / ELASTIC_POINTS as f64;
                    let state = sphere.state_by_contact_radius(a).ok()?;
                    let shown = if column == at::FORCE { state.force / self.scale.force } else { a };
                    let inside = state.penetration >= low && shown >= least - room && shown <= most + room;
                    inside.then_some((state.penetration, shown))
                })
                .collect();
            (points.len() > 1).then(|| Curve::new(label, points).with_line(line).with_colour(2))
        };
        let relaxed = if self.flow.is_some() { None } else { of(self.relaxed, r"JKR, $E_0$", Line::Dashed) };
        [relaxed, of(self.material.glassy_modulus(), r"JKR, $E_\infty$", Line::Dotted)].into_iter().flatten().collect()
    }

    /// A quantity against time.
    fn time_figure(&self, states: &[State<'_>], column: usize) -> Figure {
        let mut horizontal = self.axis(at::TIME);
        let ends = states.iter().filter_map(|state| state.rows.last()?.value(at::TIME));
        let (shortest, longest) = ends.fold((f64::INFINITY, 0.0_f64), |(low, high), end| (low.min(end), high.max(end)));
        if longest > DIFFERENT_ENDS * shortest {
            // From the first instant on, at most a thousandth of the shortest history: what starts at zero has no place on a logarithmic axis.
            let times = states.iter().flat_map(|state| &state.rows).filter_map(|row| row.value(at::TIME)).filter(|time| *time > 0.0);
            let first = times.fold(shortest, f64::min).max(1e-3 * shortest);
            horizontal = Axis::logarithmic(horizontal.label).with_range(first, longest);
        }
        let mut figure = Figure::new(horizontal, self.axis(column));
        for state in states {
            figure = figure.with_curve(self.curve(state, at::TIME, column));
            for envelope in self.cycle_figures().envelope(state, column) {
                figure = figure.with_curve(envelope);
            }
        }
        if column == at::FORCE { self.with_measured(figure, states, at::TIME) } else { figure }
    }

    /// The force against the time since the histories differ, where what follows takes much longer in some of them: retractions at several speeds after one dwell.
    fn own_time_figure(&self, states: &[State<'_>]) -> Option<Figure> {
        let time = |row: &&Row| value(row, at::TIME);
        let (first, others) = states.split_first()?;
        let all_at = |&(place, now): &(usize, f64)| {
            let same = |row: &&Row| (time(row) - now).abs() <= SAME_TIME * now;
            others.iter().all(|state| state.rows.get(place).is_some_and(same))
        };
        let begin = first.rows.iter().map(time).enumerate().take_while(all_at).last().filter(|(_, begin)| *begin > 0.0)?.1;
        let ends = states.iter().filter_map(|state| state.rows.last().map(time)).map(|end| end - begin);
        let (shortest, longest) = ends.fold((f64::INFINITY, 0.0_f64), |(low, high), end| (low.min(end), high.max(end)));
        if !(longest > DIFFERENT_ENDS * shortest && shortest > SAME_TIME * begin) {
            return None;
        }
        let words = format!("time since {}", crate::plan::curves::short(begin));
        let label = if self.units == Units::Si { format!("{words} s (s)") } else { words };
        let later = states.iter().map(|state| {
            let mut curve = self.curve(state, at::TIME, at::FORCE);
            curve.points.retain(|point| point.0 > begin * (1.0 + SAME_TIME));
            curve.points.iter_mut().for_each(|point| point.0 -= begin);
            curve
        });
        let figure = later.fold(Figure::new(Axis::logarithmic(label), self.axis(at::FORCE)), Figure::with_curve);
        Some(figure)
    }

    /// The measured force of the first state, as marks, and below the curves how far the computed force is from it.
    fn with_measured(&self, figure: Figure, states: &[State<'_>], horizontal: usize) -> Figure {
        let place = |column: usize| position(&self.indentation, column);
        let (Some(measured), Some(deviation), Some(state)) = (place(at::MEASURED_FORCE), place(at::FORCE_DEVIATION), states.first()) else {
            return figure;
        };
        agreement::put_on(figure, &state.rows, [horizontal, measured, deviation], self.units)
    }

    /// Loss of an oscillation; else the pull-off force, or without adhesion the largest force.
    pub(super) fn main_answer(&self) -> Option<Answer> {
        let (place, label) = if self.timeline.oscillates() {
            (at::LOSS_STIFFNESS, self.label("loss stiffness", "$k''$", " (N/m)", r"$k''/\pi E_0^* R$"))
        } else if self.indentation.adhesion.is_some() {
            (at::PULL_OFF_FORCE, self.label("pull-off force", r"$F_\mathrm{off}$", " (N)", r"$F_\mathrm{off}/\pi E_0^* R^2$"))
        } else {
            (at::LARGEST_COMPRESSION, self.label("largest force", "$F$", " (N)", r"$F/\pi E_0^* R^2$"))
        };
        Some(Answer { column: position(&self.indentation, place)?, axis: Axis::linear(label) })
    }

    /// F_off/F_JKR, and F_off itself, against the innermost swept number.
    fn pull_off_figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let force = position(&self.indentation, at::PULL_OFF_FORCE).and_then(|place| {
            let label = self.label("pull-off force", r"$F_\mathrm{off}$", " (N)", r"$F_\mathrm{off}/\pi E_0^* R^2$");
            self.pull_off_figure(scene, rows, place, label)
        });
        let ratio = self.pull_off_figure(scene, rows, at::PULL_OFF_RATIO, r"pull-off force $F_\mathrm{off}/F_\mathrm{JKR}$".to_owned());
        let named = |name: &str, figure: Option<Figure>| figure.map(|figure| (name.to_owned(), figure));
        [named("pull_off_against_sweep", ratio), named("pull_off_force_against_sweep", force)].into_iter().flatten().collect()
    }

    fn pull_off_figure(&self, scene: &Scene, rows: &[Row], column: usize, vertical: String) -> Option<Figure> {
        // An imposed force is no pull-off force to be found.
        let sweep = scene.sweeps.last().filter(|sweep| !sweep.key.ends_with(".force"))?;
        let outer = scene.sweeps.len() - 1;
        let of_a_state = |row: &Row| if column == at::PULL_OFF_RATIO { row.label(1) == LARGEST_TENSION } else { row.label(0) == SUMMARY };
        let found: Vec<&Row> = rows.iter().filter(|row| of_a_state(row) && row.value(column).is_some()).collect();
        if found.len() < 2 {
            return None;
        }
        let horizontal =
            if sweep.key == "indentation.speed_factor" { axis_of(sweep, "speed factor".to_owned()) } else { swept_axis(sweep) };
        let mut sets: Vec<&[f64]> = found.iter().map(|row| row.swept.get(..outer).unwrap_or(&[])).collect();
        sets.dedup();
        let note = thinning(sets.len(), MOST_STATES, "values of the outer sweep");
        let sets = thinned(sets, MOST_STATES);
        let mut figure = Figure::new(horizontal, Axis::linear(vertical));
        figure.note = note;
        for (colour, set) in sets.iter().enumerate() {
            let own = || found.iter().filter(|row| row.swept.get(..outer).unwrap_or(&[]) == *set);
            figure = figure.with_curve(
                Curve::new(swept_label(scene, set), own().map(|row| (innermost(row), value(row, column))).collect())
                    .with_band(own().map(|row| row.material_deviation(column).unwrap_or(0.0)).collect())
                    .with(shade(colour, sets.len()))
                    .with_line(Line::Solid)
                    .with_marker(Marker::Circle),
            );
        }
        say_what_bands_are(&mut figure);
        Some(figure)
    }

    /// Pressure and surface of the first state at each chosen time.
    fn field_figures(&self, states: &[State<'_>]) -> Vec<(String, Figure)> {
        let Some(state) = states.first() else { return Vec::new() };
        let rows: Vec<&&Row> = state.rows.iter().filter(|row| !row.fields.is_empty()).collect();
        if rows.is_empty() {
            return Vec::new();
        }
        let radius = || Axis::linear(self.label("distance from the axis", "$r$", " (m)", "$r/R$"));
        let draw = |vertical: Axis, place: usize| {
            let mut figure = Figure::new(radius(), vertical);
            for (colour, row) in rows.iter().enumerate() {
                let time = row.fields.first().and_then(|point| point.values.get(field::TIME)).map_or(0.0, |time| time.value);
                let unit = if self.units == Units::Si { " s" } else { "" };
                let label = format!("$t$ = {}{unit}", crate::plan::curves::short(time));
                let points = row.fields.iter().filter_map(|point| Some((point.place, point.values.get(place)?.value))).collect();
                figure = figure.with_curve(Curve::new(label, points).with(shade(colour, rows.len())));
            }
            figure
        };
        // The edge is infinite: the axis shows what the middle of the contacts holds, a few times over.
        let mut pressures: Vec<f64> =
            rows.iter().flat_map(|row| &row.fields).filter_map(|point| point.values.get(field::PRESSURE)).map(|p| p.value).collect();
        pressures.sort_by(f64::total_cmp);
        let quantile = |part: f64| pressures.get((part * (pressures.len().saturating_sub(1)) as f64) as usize).copied().unwrap_or(0.0);
        let (low, high) = (quantile(0.08), quantile(1.0));
        let span = (high - low).max(f64::MIN_POSITIVE);
        let pressure =
            Axis::linear(self.label("pressure", "$p$", " (Pa)", r"$p/\pi E_0^*$")).with_range(low - 0.15 * span, high + 0.1 * span);
        let surface = Axis::linear(self.label("surface displacement", "$w$", " (m)", "$w/R$"));
        vec![
            ("pressure_against_radius".to_owned(), draw(pressure, field::PRESSURE)),
            ("displacement_against_radius".to_owned(), draw(surface, field::DISPLACEMENT)),
        ]
    }
}
