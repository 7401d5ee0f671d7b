//! Numbers that are right to the reader but a thousand times off what is measured: a unit that was forgotten. Asked about, never refused.

use super::catalogue::{self, Kind};
use super::check::{self, Units};
use super::document::{Node, Value};
use super::sweep::Sweep;
use super::units::Dimension;

/// Endings of the paths of keys, the problem where they are meant, the usual range in SI units, and what is usual.
type Usual = (&'static [&'static str], &'static str, [f64; 2], &'static str);

const WORK: &[&str] = &["work_of_adhesion"];
const OF_CONTACTS: &str = "works of adhesion of contacts are about 0.02 to 1 J/m²";

const USUAL: &[Usual] = &[
    (WORK, "indentation", [1e-6, 10.0], OF_CONTACTS),
    (WORK, "sliding", [1e-6, 10.0], OF_CONTACTS),
    (&["sphere.radius"], "indentation", [1e-9, 0.5], "spheres of contact tests have radii from about 1 µm to some centimetres"),
    (&["cylinder.radius"], "sliding", [1e-9, 5.0], "cylinders of contact tests have radii from about 1 µm to some centimetres"),
    (
        &["crack.speed", "sliding.speed", "test.approach_speed", "test.retraction_speed"],
        "",
        [0.0, 1e3],
        "no problem here has inertia, and sound in rubber travels at about 1 km/s or less",
    ),
    (&["process_zone.length"], "", [0.0, 1e-2], "process zones are about 1 nm to some 100 µm long"),
];

/// What the numbers of a scene in SI units make one ask, a sentence each.
pub(super) fn cautions(root: &Node) -> Vec<String> {
    let mut all = Vec::new();
    if Units::of(root) == Units::Si {
        walk(root, root, "", &mut all);
    }
    all
}

/// The same of the values of a sweep.
pub(super) fn of_sweep(root: &Node, sweep: &Sweep) -> Vec<String> {
    if Units::of(root) != Units::Si {
        return Vec::new();
    }
    let Some(dimension) = dimension_of(&sweep.key) else { return Vec::new() };
    let ends = sweep.values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| [low.min(value), high.max(value)]);
    ends.iter().find_map(|&end| asked(root, &sweep.key, end, dimension)).into_iter().collect()
}

fn dimension_of(path: &str) -> Option<Dimension> {
    match catalogue::key(&catalogue::generic_path(path))?.kind {
        Kind::Number { dimension, .. } => Some(dimension),
        _ => None,
    }
}

fn walk(root: &Node, table: &Node, path: &str, all: &mut Vec<String>) {
    for entry in table.entries() {
        let path = if path.is_empty() { entry.key.clone() } else { format!("{path}.{}", entry.key) };
        match &entry.node.value {
            Value::Table(_) => walk(root, &entry.node, &path, all),
            Value::List(items) => items.iter().enumerate().for_each(|(index, item)| walk(root, item, &format!("{path}.{index}"), all)),
            Value::Number(_) | Value::Text(_) => {
                let number = dimension_of(&path)
                    .and_then(|dimension| Some((check::number(&entry.node, &path, dimension, Units::Si).ok()?, dimension)));
                all.extend(number.and_then(|(value, dimension)| asked(root, &path, value, dimension)));
            }
            _ => {}
        }
    }
}

/// The question about one number; none if it is usual.
fn asked(root: &Node, path: &str, value: f64, dimension: Dimension) -> Option<String> {
    let (.., usual) = USUAL.iter().find(|(paths, problem, [low, high], _)| {
        paths.iter().any(|ending| path.ends_with(ending))
            && (problem.is_empty() || root.get(problem).is_some())
            && value != 0.0
            && !(*low..=*high).contains(&value)
    })?;
    Some(format!("`{path}` is {value:.3e} {}: {usual}; is its unit right?", dimension.si_unit()))
}
