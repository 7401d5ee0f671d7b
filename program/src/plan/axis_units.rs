//! Axes of plots in the units that a scene writes: micrometres where it says `"3 µm"`, with a prefix for what it does not say.
//!
//! A label ends with the SI unit of its numbers, as in `contact radius $a$ (m)`. The axis takes a unit of the scene for the same dimension: of
//! several the largest that its numbers reach. A linear axis whose numbers suit no unit of the scene takes a prefix. A scene that writes plain numbers keeps SI.

use crate::outcome::plot::{Axis, Figure, Scale};
use crate::scene::document::{Document, Node, Value};
use crate::scene::units::{Dimension, parse_quantity, unit_of};

/// Dimensions with one meaning each: any unit of them may stand for another one. J/m² is not a stiffness, and rad/s no frequency.
const ONE_MEANING: [Dimension; 5] = [Dimension::LENGTH, Dimension::TIME, Dimension::SPEED, Dimension::PRESSURE, Dimension::FORCE];
/// Prefixes of what a scene does not write, with their powers of ten; seconds and metres take small ones only.
const PREFIXES: [(&str, i32); 7] = [("p", -12), ("n", -9), ("µ", -6), ("m", -3), ("k", 3), ("M", 6), ("G", 9)];
/// Numbers on a linear axis stay below this, in a unit of the scene.
const MOST_OF_A_UNIT: f64 = 2000.0;
/// Numbers that need no prefix.
const PLAIN: std::ops::Range<f64> = 0.1..1e4;

/// The units that stand in a scene.
pub(super) struct WrittenUnits(Vec<(String, Dimension, f64)>);

impl WrittenUnits {
    /// Of all texts of a scene that are numbers with a unit.
    pub(super) fn of(document: &Document) -> Self {
        let mut found = Vec::new();
        collect(&document.root, &mut found);
        Self(found)
    }

    /// Changes the axes of a figure, and its numbers with them.
    pub(super) fn put_on(&self, figure: &mut Figure) {
        if self.0.is_empty() {
            return;
        }
        let inset = figure.inset.as_deref_mut();
        let map = figure.map.as_mut();
        let across = map.iter().flat_map(|map| &map.across).copied();
        let up = map.iter().flat_map(|map| &map.up).copied();
        let points = || figure.curves.iter().flat_map(|curve| &curve.points);
        let horizontal = self.unit(&mut figure.horizontal, points().map(|point| point.0).chain(across));
        let vertical = self.unit(&mut figure.vertical, points().map(|point| point.1).chain(up));
        for point in figure.curves.iter_mut().flat_map(|curve| &mut curve.points) {
            *point = (point.0 / horizontal, point.1 / vertical);
        }
        if let Some(map) = map {
            let colours = self.unit(&mut map.colours, map.values.iter().copied());
            map.across.iter_mut().for_each(|place| *place /= horizontal);
            map.up.iter_mut().for_each(|place| *place /= vertical);
            map.values.iter_mut().for_each(|value| *value /= colours);
        }
        if let Some(residuals) = figure.residuals.as_deref_mut() {
            let vertical = self.unit(&mut residuals.vertical, residuals.points.iter().map(|point| point.1));
            residuals.points.iter_mut().for_each(|point| *point = (point.0 / horizontal, point.1 / vertical));
            residuals.root_mean_square = residuals.root_mean_square.map(|root| root / vertical);
        }
        if let Some(inset) = inset {
            let horizontal = self.unit(&mut inset.horizontal, inset.curves.iter().flat_map(|curve| &curve.points).map(|point| point.0));
            let vertical = self.unit(&mut inset.vertical, inset.curves.iter().flat_map(|curve| &curve.points).map(|point| point.1));
            for point in inset.curves.iter_mut().flat_map(|curve| &mut curve.points) {
                *point = (point.0 / horizontal, point.1 / vertical);
            }
        }
    }

    /// Relabels an axis with a unit that suits its numbers; its size in the unit before.
    fn unit(&self, axis: &mut Axis, numbers: impl Iterator<Item = f64>) -> f64 {
        let largest = axis.range.map_or_else(
            || numbers.filter(|number| number.is_finite()).fold(0.0, |most: f64, number| most.max(number.abs())),
            |(lower, upper)| lower.abs().max(upper.abs()),
        );
        let Some((unit, size)) = self.choice(axis, largest) else { return 1.0 };
        if let Some((words, _)) = axis.label.rsplit_once('(') {
            axis.label = format!("{words}({unit})");
        }
        axis.range = axis.range.map(|(lower, upper)| (lower / size, upper / size));
        size
    }

    /// The unit for numbers up to `largest` of an axis, with its size.
    fn choice(&self, axis: &Axis, largest: f64) -> Option<(String, f64)> {
        let base = axis.label.strip_suffix(')')?.rsplit_once('(')?.1;
        let same = |size: f64, expected: f64| (size / expected - 1.0).abs() < 1e-12;
        let plain =
            parse_quantity(&format!("1 {base}")).ok().filter(|plain| same(plain.value, 1.0) && largest > 0.0 && largest.is_finite())?;
        let mut written: Vec<(String, f64)> = self
            .0
            .iter()
            .filter(|(_, dimension, _)| ONE_MEANING.contains(&plain.dimension) && dimension.measures(plain.dimension))
            .map(|(unit, _, size)| (unit.clone(), *size))
            .collect();
        written.sort_by(|one, other| other.1.total_cmp(&one.1));
        let logarithmic = axis.scale == Scale::Logarithmic;
        // Over decades from far below to far above it, SI itself is read most easily.
        let around = written.first().is_some_and(|largest| largest.1 > 1.0) && written.last().is_some_and(|least| least.1 < 1.0);
        if logarithmic && around {
            return None;
        }
        // From the largest unit on: the first in which the numbers reach one.
        if let Some(last) = written.last().cloned() {
            let reached = written.into_iter().find(|(_, size)| largest >= *size);
            if logarithmic {
                return Some(reached.unwrap_or(last));
            }
            // A unit for atoms is none for the size of a sphere.
            if let Some(fitting) = reached.filter(|(_, size)| largest / size < MOST_OF_A_UNIT) {
                return Some(fitting);
            }
        }
        if logarithmic || PLAIN.contains(&largest) {
            return None;
        }
        let small_only = matches!(base.chars().next(), Some('s' | 'm'));
        let prefixed = |(prefix, power): (&str, i32)| {
            let unit = format!("{prefix}{base}");
            let size = parse_quantity(&format!("1 {unit}")).ok()?.value;
            let right = same(size, 10f64.powi(power)) && (power < 0 || !small_only);
            (right && (1.0..1000.0).contains(&(largest / size))).then_some((unit, size))
        };
        PREFIXES.into_iter().find_map(prefixed)
    }
}

/// The units of all texts under a node.
fn collect(node: &Node, found: &mut Vec<(String, Dimension, f64)>) {
    match &node.value {
        Value::Table(entries) => entries.iter().for_each(|entry| collect(&entry.node, found)),
        Value::List(items) => items.iter().for_each(|item| collect(item, found)),
        Value::Text(text) => {
            let unit = unit_of(text);
            if let Some(one) = (!unit.is_empty()).then(|| parse_quantity(&format!("1 {unit}")).ok()).flatten()
                && parse_quantity(text).is_ok()
                && !found.iter().any(|(known, ..)| known == unit)
            {
                found.push((unit.to_owned(), one.dimension, one.value));
            }
        }
        Value::Number(_) | Value::Flag(_) | Value::Date => {}
    }
}
