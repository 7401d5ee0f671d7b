//! The plots of a steady crack: toughness against speed, what a sweep varies, and the fields at the tip.

use super::SteadyCrackPlan;
use super::columns::at;
use crate::crack::Motion;
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Curve, Figure, Line};
use crate::scene::typed::{Scene, Theory, Units};

/// Most curves that a legend can tell apart; further ones of an outer sweep are thinned evenly.
const MOST_CURVES: usize = 10;

impl SteadyCrackPlan {
    pub(in crate::plan) fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut figures = Vec::new();
        let families = families(scene, rows);
        // One state has no curve.
        if families.iter().any(|family| family.rows.len() > 1) {
            let si = self.units == Units::Si;
            let speed = if si { "crack speed $v$ (m/s)" } else { r"crack speed $v\tau/a_0$" };
            let solid = self.plane_material.relaxed_modulus() > 0.0;
            let (column, stem, label) = match (solid, si) {
                (true, true) => (at::ENERGY_RELEASE_RATE, "energy_release_rate", "energy release rate $G$ (J/m²)"),
                (true, false) => (at::RATIO, "energy_release_rate", r"$G/\Delta\gamma$"),
                (false, _) => (at::STRESS_INTENSITY, "stress_intensity", "stress intensity $K$ (Pa √m)"),
            };
            figures.push((
                format!("{stem}_against_speed"),
                figure(&families, Axis::logarithmic(speed), Axis::logarithmic(label), at::SPEED, column),
            ));
            figures.extend(self.against_swept(scene, &families));
        }
        figures.extend(self.field_figures(scene, rows));
        figures
    }

    /// A plot against the innermost swept number, where that is not the speed itself.
    fn against_swept(&self, scene: &Scene, families: &[Family<'_>]) -> Option<(String, Figure)> {
        let sweep = scene.sweeps.last()?;
        if sweep.key == "crack.speed" {
            return None;
        }
        let load = !matches!(self.crack.control, crate::scene::typed::CrackControl::Speed(_));
        let (column, stem) = if load { (at::SPEED, "speed") } else { (at::RATIO, "toughness") };
        let unit = if sweep.unit == "1" { String::new() } else { format!(" ({})", sweep.unit) };
        let label = format!("{}{unit}", sweep.key.rsplit('.').next().unwrap_or(&sweep.key).replace('_', " "));
        let horizontal = if sweep.logarithmic { Axis::logarithmic(label) } else { Axis::linear(label) };
        let vertical = match (load, self.units) {
            (true, Units::Si) => Axis::logarithmic("crack speed $v$ (m/s)"),
            (true, Units::Reduced) => Axis::logarithmic(r"crack speed $v\tau/a_0$"),
            (false, _) => Axis::logarithmic(r"$G/\Delta\gamma$"),
        };
        let mut drawn = Figure::new(horizontal, vertical);
        for family in families {
            let points = family.rows.iter().map(|row| (row.swept.last().copied().unwrap_or(f64::NAN), value(row, column))).collect();
            drawn = drawn.with_curve(family.curve(points));
        }
        Some((format!("{stem}_against_{}", sweep.key.replace('.', "_")), drawn))
    }

    fn field_figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut states: Vec<&Row> = rows.iter().filter(|row| !row.fields.is_empty()).collect();
        if states.is_empty() {
            return Vec::new();
        }
        states = thinned(states, 6);
        let si = self.units == Units::Si;
        let distance = |side: &str| {
            Axis::logarithmic(if si { format!("distance {side} the tip (m)") } else { format!("distance {side} the tip $s/a_0$") })
        };
        let mut opening = Figure::new(
            distance("behind"),
            Axis::logarithmic(if si {
                "displacement of one face $u$ (m)"
            } else {
                r"displacement of one face $u/\sqrt{a_0 \Delta\gamma/E_0}$"
            }),
        );
        let mut stress = Figure::new(
            distance("ahead of"),
            Axis::logarithmic(if si { r"stress $|\sigma|$ (Pa)" } else { r"stress $|\sigma|/\sqrt{E_0 \Delta\gamma/a_0}$" }),
        );
        for (index, row) in states.iter().enumerate() {
            let label = if scene.sweeps.is_empty() { String::new() } else { swept_label(scene, &row.swept) };
            let points = row.fields.iter().map(|point| (point.distance, point.displacement.value)).collect();
            opening = opening.with_curve(Curve::new(label.clone(), points).with_line(Line::Solid).with_colour(index));
            // Tension solid, compression dashed: one curve of |σ| in two pieces.
            let part = |sign: f64| {
                row.fields
                    .iter()
                    .map(|point| (point.distance, if point.stress.value * sign > 0.0 { point.stress.value.abs() } else { f64::NAN }))
                    .collect()
            };
            let tension = if scene.sweeps.is_empty() { "tension".to_owned() } else { label };
            stress = stress.with_curve(Curve::new(tension, part(1.0)).with_line(Line::Solid).with_colour(index));
            if row.fields.iter().any(|point| point.stress.value < 0.0) {
                let compression = if index == 0 { "compression" } else { "" };
                stress = stress.with_curve(Curve::new(compression, part(-1.0)).with_line(Line::Dashed).with_colour(index));
            }
        }
        if self.crack.motion == Motion::Opening {
            vec![("opening".into(), opening), ("stress".into(), stress)]
        } else {
            vec![("stress".into(), stress), ("opening".into(), opening)]
        }
    }
}

/// Rows of one theory at one set of outer swept values: a curve.
struct Family<'a> {
    label: String,
    theory: Theory,
    colour: usize,
    rows: Vec<&'a Row>,
}

impl Family<'_> {
    /// The theory of the program is solid, its rivals are dashed and dotted; a colour is a set of outer swept values.
    fn curve(&self, points: Vec<(f64, f64)>) -> Curve {
        let line = match self.theory {
            Theory::VirtualWork => Line::Solid,
            Theory::PerssonBrener => Line::Dashed,
            Theory::CohesiveZone => Line::Dotted,
        };
        Curve::new(self.label.clone(), points).with_line(line).with_colour(self.colour)
    }
}

fn value(row: &Row, column: usize) -> f64 {
    row.values.get(column).copied().flatten().map_or(f64::NAN, |estimate| estimate.value)
}

fn figure(families: &[Family<'_>], horizontal: Axis, vertical: Axis, x: usize, y: usize) -> Figure {
    families.iter().fold(Figure::new(horizontal, vertical), |figure, family| {
        let mut points: Vec<(f64, f64)> = family.rows.iter().map(|row| (value(row, x), value(row, y))).collect();
        if points.iter().all(|point| point.0.is_finite()) {
            points.sort_by(|left, right| left.0.total_cmp(&right.0));
        }
        figure.with_curve(family.curve(points))
    })
}

fn families<'a>(scene: &Scene, rows: &'a [Row]) -> Vec<Family<'a>> {
    let outer = scene.sweeps.len().saturating_sub(1);
    let theories: Vec<Theory> = match &scene.problem {
        crate::scene::typed::Problem::SteadyCrack(crack) => crack.theories.clone(),
    };
    let mut sets: Vec<&[f64]> = Vec::new();
    for row in rows {
        let set = row.swept.get(..outer).unwrap_or(&[]);
        if sets.last() != Some(&set) && !sets.contains(&set) {
            sets.push(set);
        }
    }
    let sets = thinned(sets, (MOST_CURVES / theories.len().max(1)).max(1));
    let of = |theory: Theory, set: &[f64]| -> Vec<&'a Row> {
        rows.iter().filter(|row| row.theory == theory.word() && row.swept.get(..outer).unwrap_or(&[]) == set).collect()
    };
    let (mut families, mut indifferent_ones): (Vec<Family<'a>>, Vec<Family<'a>>) = (Vec::new(), Vec::new());
    for (index, set) in sets.iter().enumerate() {
        for (place, &theory) in theories.iter().enumerate() {
            // A theory that does not feel the outer sweep is one curve, drawn once, without its parameters.
            let same = |other: &&[f64]| {
                let (first, second) = (of(theory, set), of(theory, other));
                first.len() == second.len() && first.iter().zip(&second).all(|(left, right)| left.values == right.values)
            };
            let indifferent = sets.len() > 1 && sets.iter().all(same);
            if indifferent && index > 0 {
                continue;
            }
            let rows = of(theory, set);
            let parameters = if outer > 0 && !indifferent { swept_label(scene, set) } else { String::new() };
            let label = match (theories.len() > 1, parameters.is_empty()) {
                (_, true) => theory.name().to_owned(),
                (true, false) => format!("{}, {parameters}", theory.name()),
                (false, false) => parameters,
            };
            let family = Family {
                label,
                theory,
                colour: if indifferent {
                    sets.len()
                } else if outer > 0 {
                    index
                } else {
                    place
                },
                rows,
            };
            if indifferent { indifferent_ones.push(family) } else { families.push(family) }
        }
    }
    // Drawn last, on top of the families.
    families.extend(indifferent_ones);
    families
}

/// `speed = 1e-3 m/s, factor = 2.5`.
fn swept_label(scene: &Scene, values: &[f64]) -> String {
    scene
        .sweeps
        .iter()
        .zip(values)
        .map(|(sweep, &value)| {
            let name = sweep.key.rsplit('.').next().unwrap_or(&sweep.key).replace('_', " ");
            let unit = if sweep.unit == "1" { String::new() } else { format!(" {}", sweep.unit) };
            format!("{name} {}{unit}", short(value))
        })
        .collect::<Vec<_>>()
        .join(", ")
}

/// Three digits, as `2.5` or `$3.2\cdot10^{-7}$`.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-2..1e4).contains(&value.abs()) {
        let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
        return format!("{rounded}");
    }
    let text = format!("{value:.2e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa: f64 = mantissa.parse().unwrap_or(1.0);
    if (mantissa - 1.0).abs() < 1e-9 { format!("$10^{{{exponent}}}$") } else { format!("${mantissa}·10^{{{exponent}}}$") }
}

/// At most `most` items, evenly chosen, first and last kept.
fn thinned<T: Clone>(items: Vec<T>, most: usize) -> Vec<T> {
    if items.len() <= most || most < 2 {
        return items.into_iter().take(most.max(1)).collect();
    }
    let last = items.len() - 1;
    (0..most).filter_map(|index| items.get(index * last / (most - 1)).cloned()).collect()
}
