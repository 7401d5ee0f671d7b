//! The units that a scene writes, and which of them suit numbers that it is answered with: micrometres where it says `"3 µm"`, with a prefix for what it does not say.

use super::document::{Node, Value};
use super::units::{Dimension, parse_quantity, unit_of};

/// Dimensions with one meaning each: any unit of them may stand for another one. J/m² is not a stiffness, and rad/s no frequency.
const ONE_MEANING: [Dimension; 5] = [Dimension::LENGTH, Dimension::TIME, Dimension::SPEED, Dimension::PRESSURE, Dimension::FORCE];
/// Prefixes of what a scene does not write, with their powers of ten; seconds and metres take small ones only.
const PREFIXES: [(&str, i32); 7] = [("p", -12), ("n", -9), ("µ", -6), ("m", -3), ("k", 3), ("M", 6), ("G", 9)];
/// Numbers stay below this in a unit of the scene.
const MOST_OF_A_UNIT: f64 = 2000.0;
/// Numbers that need no prefix.
const PLAIN: std::ops::Range<f64> = 0.1..1e4;

/// A unit as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenUnit {
    /// Its name.
    pub name: String,
    /// Its size in SI.
    pub size: f64,
    dimension: Dimension,
}

/// The units of all texts of a scene, or of a part of it, that are numbers with a unit.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WrittenUnits(Vec<WrittenUnit>);

/// How numbers are spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// From zero to the largest.
    Even,
    /// Over decades.
    Decades,
}

impl WrittenUnits {
    /// Of all texts under a node.
    #[must_use]
    pub fn of(node: &Node) -> Self {
        let mut found = Self::default();
        found.collect(node);
        found
    }

    /// Whether the scene writes plain numbers only.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn collect(&mut self, node: &Node) {
        match &node.value {
            Value::Table(entries) => entries.iter().for_each(|entry| self.collect(&entry.node)),
            Value::List(items) => items.iter().for_each(|item| self.collect(item)),
            Value::Text(text) => {
                let name = unit_of(text);
                if let Some(one) = (!name.is_empty()).then(|| parse_quantity(&format!("1 {name}")).ok()).flatten()
                    && parse_quantity(text).is_ok()
                    && !self.0.iter().any(|known| known.name == name)
                {
                    self.0.push(WrittenUnit { name: name.to_owned(), size: one.value, dimension: one.dimension });
                }
            }
            Value::Number(_) | Value::Flag(_) | Value::Date => {}
        }
    }

    /// The unit for numbers in the SI unit `base` whose largest magnitude is `largest`; none where `base` itself suits them.
    #[must_use]
    pub fn suiting(&self, base: &str, largest: f64, spread: Spread) -> Option<(String, f64)> {
        if self.is_empty() {
            return None;
        }
        let plain =
            parse_quantity(&format!("1 {base}")).ok().filter(|plain| same(plain.value, 1.0) && largest > 0.0 && largest.is_finite())?;
        let mut written: Vec<(String, f64)> = self
            .0
            .iter()
            .filter(|unit| ONE_MEANING.contains(&plain.dimension) && unit.dimension.measures(plain.dimension))
            .map(|unit| (unit.name.clone(), unit.size))
            .collect();
        written.sort_by(|one, other| other.1.total_cmp(&one.1));
        let decades = spread == Spread::Decades;
        // Over decades from far below to far above it, SI itself is read most easily.
        let around = written.first().is_some_and(|largest| largest.1 > 1.0) && written.last().is_some_and(|least| least.1 < 1.0);
        if decades && around {
            return None;
        }
        // From the largest unit on: the first in which the numbers reach one.
        if let Some(last) = written.last().cloned() {
            let reached = written.into_iter().find(|(_, size)| largest >= *size);
            if decades {
                return Some(reached.unwrap_or(last));
            }
            // A unit for atoms is none for the size of a sphere.
            if let Some(fitting) = reached.filter(|(_, size)| largest / size < MOST_OF_A_UNIT) {
                return Some(fitting);
            }
        }
        if decades || PLAIN.contains(&largest) {
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

    /// Of units of one dimension, the largest that a number reaches, else the smallest: `0.5 µm/s` and `5 mm/s` in one list.
    #[must_use]
    pub fn reached(&self, number: f64) -> Option<&WrittenUnit> {
        let reaches = |unit: &&WrittenUnit| number.abs() >= unit.size * (1.0 - 1e-12);
        let by_size = |one: &&WrittenUnit, other: &&WrittenUnit| one.size.total_cmp(&other.size);
        self.0.iter().filter(reaches).max_by(by_size).or_else(|| self.0.iter().min_by(by_size))
    }
}

fn same(size: f64, expected: f64) -> bool {
    (size / expected - 1.0).abs() < 1e-12
}
