//! The plots of oscillations: envelopes, stiffness and loss against frequency or time, the last cycle.

use super::columns::at;
use super::figures::{LOSSES, State, axis, label};
use super::rows::{CYCLE, INSTANT, LARGEST_TENSION};
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line, Marker, Scale};
use crate::outcome::{Column, Row};
use crate::plan::curves::{noted, value};
use crate::scene::typed::{Scene, Units};

/// Frequencies that differ more than this make an axis; more than the second a logarithmic one.
const DIFFERENT: f64 = 1.1;
const DECADE: f64 = 10.0;
/// Frequencies of one segment that differ by less are one, as the times of its cycles round them.
const ROUNDED: f64 = 1e-6;
/// Points fewer than these are marked.
const FEW: usize = 60;

/// Draws cycles by the names of their columns, which both theories of an indenter have.
pub(super) struct CycleFigures {
    names: Vec<&'static str>,
    units: Units,
    /// Whether force and radius fall to zero at once where contact is lost, as those of an edge do.
    falls: bool,
}

impl CycleFigures {
    pub(super) fn new(columns: &[Column], units: Units, falls: bool) -> Self {
        Self { names: columns.iter().map(|column| column.name).collect(), units, falls }
    }

    /// A column of a row.
    fn of(&self, row: &Row, column: &str) -> f64 {
        self.names.iter().position(|name| *name == column).and_then(|place| row.value(place)).unwrap_or(f64::NAN)
    }

    fn label(&self, quantity: &str, symbol: &str, unit: &str, reduced: &str) -> String {
        label(self.units, quantity, symbol, unit, reduced)
    }

    /// Whether a cycle lies between two instants that follow each other.
    fn whole_cycles_between(&self, state: &State<'_>, from: f64, to: f64) -> bool {
        let after = state.cycles.partition_point(|row| value(row, at::TIME) <= from);
        state.cycles.get(after).is_some_and(|row| self.of(row, "cycle_start") >= from && value(row, at::TIME) <= to)
    }

    /// Two columns of the instants and events of a state; cycles of which no instant is a row are a gap.
    pub(super) fn way(&self, state: &State<'_>, [horizontal, vertical]: [usize; 2]) -> Vec<(f64, f64)> {
        let mut points = Vec::with_capacity(state.rows.len());
        let mut before = f64::NEG_INFINITY;
        for row in &state.rows {
            let time = value(row, at::TIME);
            if self.whole_cycles_between(state, before, time) {
                // A point alone is no curve.
                if row.label(1) == LARGEST_TENSION {
                    continue;
                }
                points.push((f64::NAN, f64::NAN));
            }
            before = time;
            let point = (value(row, horizontal), value(row, vertical));
            points.push(point);
            // Force and radius of an edge that is lost fall to zero at once.
            if self.falls && LOSSES.contains(&row.label(1)) && vertical != at::PENETRATION {
                points.push((point.0, 0.0));
            }
        }
        points
    }

    /// The smallest and the largest value in each cycle against its middle, where not all cycles are drawn.
    pub(super) fn envelope(&self, state: &State<'_>, column: usize) -> Vec<Curve> {
        let ends = match column {
            at::FORCE => ["smallest_force", "largest_force"],
            at::CONTACT_RADIUS => ["smallest_contact_radius", "largest_contact_radius"],
            _ => ["smallest_penetration", "largest_penetration"],
        };
        // A way that is drawn itself needs none.
        let times: Vec<f64> = state.rows.iter().map(|row| value(row, at::TIME)).collect();
        if !times.windows(2).any(|pair| self.whole_cycles_between(state, pair[0], pair[1])) {
            return Vec::new();
        }
        ends.into_iter()
            .map(|end| {
                let mut segment = f64::INFINITY;
                let mut points = Vec::with_capacity(state.cycles.len());
                for row in &state.cycles {
                    let own = self.of(row, "segment");
                    if own > segment {
                        points.push((f64::NAN, f64::NAN));
                    }
                    segment = own;
                    points.push((0.5 * (self.of(row, "cycle_start") + value(row, at::TIME)), self.of(row, end)));
                }
                Curve::new("", points).with_line(Line::Dashed).with(state.colour)
            })
            .collect()
    }

    /// Stiffness and work of cycles, and the last cycle of each state. `note`: that `states` are not all; the last cycles against the frequency are of all.
    pub(super) fn figures(&self, scene: &Scene, rows: &[Row], states: &[State<'_>], note: Option<&String>) -> Vec<(String, Figure)> {
        let repeated: Vec<Set<'_>> = states
            .iter()
            .filter(|state| state.repetitions.len() > 1)
            .map(|state| Set { label: state.label.clone(), colour: state.colour, rows: state.repetitions.clone() })
            .collect();
        let mut figures = Vec::new();
        if !repeated.is_empty() {
            figures.push(("work_against_repetition".to_owned(), self.work_figure(&Axis::linear("repetition"), "cycle", &repeated)));
        }
        if states.iter().all(|state| state.cycles.is_empty()) {
            return noted(figures, note.cloned());
        }
        let mut whole = Vec::new();
        let within = |state: &State<'_>| spread(state.cycles.iter().map(|row| self.of(row, "frequency")));
        // A frequency that goes is the axis of each state; frequencies of several states are the axis of their last cycles.
        let last_cycles = Self::last_cycles(rows);
        let across = spread(last_cycles.iter().map(|row| self.of(row, "frequency")));
        if let Some(ratio) = states.iter().map(within).reduce(f64::max).filter(|ratio| *ratio > DIFFERENT) {
            let sets: Vec<Set<'_>> = states
                .iter()
                .map(|state| Set { label: state.label.clone(), colour: state.colour, rows: self.settled(&state.cycles) })
                .collect();
            figures.extend(self.against(&self.frequency_axis(ratio), "frequency", "frequency", &sets));
        } else {
            if across > DIFFERENT && scene.sweeps.len() == 1 {
                let sets = [Set { label: String::new(), colour: Colour::Index(0), rows: last_cycles }];
                whole = self.against(&self.frequency_axis(across), "frequency", "frequency", &sets);
            }
            let sets: Vec<Set<'_>> = states
                .iter()
                .filter(|state| state.cycles.len() > 1)
                .map(|state| Set { label: state.label.clone(), colour: state.colour, rows: state.cycles.clone() })
                .collect();
            if !sets.is_empty() {
                figures.extend(self.against(&Axis::linear("cycle"), "cycle", "cycle", &sets));
            }
        }
        figures.extend(self.last_cycle_figure(states));
        whole.extend(noted(figures, note.cloned()));
        whole
    }

    /// Of each segment at one frequency the last cycle; of a sweep all.
    fn settled<'r>(&self, cycles: &[&'r Row]) -> Vec<&'r Row> {
        let segments = cycles.chunk_by(|one, other| self.of(one, "segment").total_cmp(&self.of(other, "segment")).is_eq());
        let own = segments.map(|segment| {
            let one_frequency = spread(segment.iter().map(|row| self.of(row, "frequency"))) < 1.0 + ROUNDED;
            if one_frequency { segment.get(segment.len() - 1..).unwrap_or_default() } else { segment }
        });
        own.flatten().copied().collect()
    }

    /// The last cycle of every state.
    fn last_cycles(rows: &[Row]) -> Vec<&Row> {
        let cycles: Vec<&Row> = rows.iter().filter(|row| row.status.has_values() && row.label(0) == CYCLE).collect();
        cycles.chunk_by(|one, other| one.state == other.state).filter_map(|state| state.last().copied()).collect()
    }

    fn frequency_axis(&self, ratio: f64) -> Axis {
        let label = if self.units == Units::Si { "frequency $f$ (1/s)" } else { "frequency $f t_0$" };
        if ratio > DECADE { Axis::logarithmic(label) } else { Axis::linear(label) }
    }

    /// Stiffness and work against a column.
    fn against(&self, across: &Axis, name: &str, horizontal: &str, sets: &[Set<'_>]) -> Vec<(String, Figure)> {
        let stiffness = self.label("stiffness", "$k$", " (N/m)", r"$k/\pi E_0^* R$");
        let columns = ["storage_stiffness", "loss_stiffness"];
        let values = || sets.iter().flat_map(|set| &set.rows).flat_map(|row| columns.map(|column| self.of(row, column)));
        let decades = across.scale == Scale::Logarithmic && values().all(|value| value > 0.0) && spread(values()) > DECADE;
        let mut first = Figure::new(across.clone(), if decades { Axis::logarithmic(stiffness) } else { Axis::linear(stiffness) });
        for set in sets {
            first = first.with_curve(self.curve_of(set, "storage", [horizontal, "storage_stiffness"], Line::Solid));
            first = first.with_curve(self.curve_of(set, "loss", [horizontal, "loss_stiffness"], Line::Dashed));
        }
        vec![
            (format!("stiffness_against_{name}"), first),
            (format!("work_per_cycle_against_{name}"), self.work_figure(across, horizontal, sets)),
        ]
    }

    /// The work of cycles or repetitions against a column.
    fn work_figure(&self, across: &Axis, horizontal: &str, sets: &[Set<'_>]) -> Figure {
        let vertical = Axis::linear(self.label("work per cycle", "$w$", " (J)", r"$w/\pi E_0^* R^3$"));
        let curves = sets.iter().map(|set| self.curve_of(set, "", [horizontal, "work_per_cycle"], Line::Solid));
        curves.fold(Figure::new(across.clone(), vertical), Figure::with_curve)
    }

    fn curve_of(&self, set: &Set<'_>, label: &str, [horizontal, vertical]: [&str; 2], line: Line) -> Curve {
        let points: Vec<(f64, f64)> = set.rows.iter().map(|row| (self.of(row, horizontal), self.of(row, vertical))).collect();
        let joined = match (label.is_empty(), set.label.is_empty()) {
            (true, _) => set.label.clone(),
            (false, true) => label.to_owned(),
            (false, false) => format!("{label}, {}", set.label),
        };
        let marker = if points.len() < FEW { Marker::Circle } else { Marker::None };
        Curve::new(joined, points).with_line(line).with(set.colour).with_marker(marker)
    }

    /// Force against penetration in the last cycle of each state, where its instants are rows.
    fn last_cycle_figure(&self, states: &[State<'_>]) -> Option<(String, Figure)> {
        let mut figure = Figure::new(axis(at::PENETRATION, self.units), axis(at::FORCE, self.units));
        for state in states {
            let Some(cycle) = state.cycles.last() else { continue };
            let (from, to) = (self.of(cycle, "cycle_start"), value(cycle, at::TIME));
            let inside = |row: &&&Row| row.label(0) == INSTANT && (from..=to).contains(&value(row, at::TIME));
            let points: Vec<(f64, f64)> =
                state.rows.iter().filter(inside).map(|row| (value(row, at::PENETRATION), value(row, at::FORCE))).collect();
            if points.len() > 3 {
                figure = figure.with_curve(Curve::new(state.label.clone(), points).with(state.colour).with_line(Line::Solid));
            }
        }
        (!figure.curves.is_empty()).then(|| ("last_cycle".to_owned(), figure))
    }
}

/// Cycles that make one curve.
struct Set<'a> {
    label: String,
    colour: Colour,
    rows: Vec<&'a Row>,
}

/// The largest over the smallest.
fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) =
        values.filter(|value| value.is_finite()).fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    if high > 0.0 { high / low } else { 1.0 }
}
