//! Pictures of the main answer over several swept numbers: a map over two of them, or marks over each of a Latin hypercube.

use super::Plan;
use super::curves::{thinned, value};
use crate::outcome::plot::{Axis, Curve, Figure, Line, Map, Marker};
use crate::outcome::{Row, is_state};
use crate::scene::sweep::{self, Sweep};
use crate::scene::typed::Scene;

/// The number that a state is solved for.
#[derive(Debug, Clone)]
pub(super) struct Answer {
    /// Its column.
    pub(super) column: usize,
    /// Its axis.
    pub(super) axis: Axis,
}

/// Values of a sweep from which on a map says more than its curves.
const FEWEST: usize = 3;
/// Most cells of a map in each direction.
const MOST_CELLS: usize = 100;

/// The maps of a grid of two sweeps; the marks of a Latin hypercube.
pub(super) fn figures(plan: &Plan, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
    let Some(answer) = plan.problem.answer(rows) else { return Vec::new() };
    let columns = plan.columns();
    let name = columns.get(answer.column).map_or("answer", |column| column.name);
    let layout = plan.layout();
    let states: Vec<&Row> = rows.iter().filter(|row| !row.labels.is_empty() && is_state(layout.as_ref(), row)).collect();
    let mut kinds: Vec<&str> = states.iter().map(|row| row.label(0)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let mut figures = Vec::new();
    for kind in &kinds {
        let own: Vec<&Row> = states.iter().copied().filter(|row| row.label(0) == *kind).collect();
        let ending = if kinds.len() > 1 { format!("_{kind}") } else { String::new() };
        if sweep::is_together(&scene.sweeps) {
            for (place, swept) in scene.sweeps.iter().enumerate() {
                let against = swept.key.replace('.', "_");
                figures.push((format!("{name}_against_{against}{ending}"), marks(&own, place, plan.problem.swept_axis(swept), &answer)));
            }
        } else if let [outer, inner] = scene.sweeps.as_slice()
            && outer.values.len().min(inner.values.len()) >= FEWEST
        {
            figures.push((format!("map_of_{name}{ending}"), map(plan, &own, (outer, inner), &answer)));
        }
    }
    figures
}

fn marks(rows: &[&Row], place: usize, horizontal: Axis, answer: &Answer) -> Figure {
    let points = rows.iter().map(|row| (row.swept.get(place).copied().unwrap_or(f64::NAN), value(row, answer.column))).collect();
    Figure::new(horizontal, answer.axis.clone())
        .with_curve(Curve::new("", points).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(0))
}

/// The inner sweep across, the outer one up.
fn map(plan: &Plan, rows: &[&Row], (outer, inner): (&Sweep, &Sweep), answer: &Answer) -> Figure {
    let places = |sweep: usize| {
        let mut places: Vec<f64> = rows.iter().filter_map(|row| row.swept.get(sweep).copied()).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let all = places.len();
        (thinned(places, MOST_CELLS), all)
    };
    let ((up, all_up), (across, all_across)) = (places(0), places(1));
    let mut values = vec![f64::NAN; up.len() * across.len()];
    for row in rows {
        let at = |places: &[f64], sweep: usize| {
            row.swept.get(sweep).and_then(|value| places.binary_search_by(|place| place.total_cmp(value)).ok())
        };
        if let (Some(column), Some(line)) = (at(&across, 1), at(&up, 0))
            && let Some(cell) = values.get_mut(line * across.len() + column)
        {
            *cell = value(row, answer.column);
        }
    }
    let mut figure = Figure::new(plan.problem.swept_axis(inner), plan.problem.swept_axis(outer));
    if all_up > up.len() || all_across > across.len() {
        figure.add_note(format!("{} × {} of {all_across} × {all_up} states are drawn", across.len(), up.len()));
    }
    if values.iter().any(|value| !value.is_finite()) {
        figure.add_note("white: no value");
    }
    figure.map = Some(Map { across, up, values, colours: answer.axis.clone() });
    figure
}
