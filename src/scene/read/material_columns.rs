//! The columns of a material's CSV file: what a header means, and in which unit.

use super::measured_table::written;
use super::section::Section;
use crate::scene::diagnostic::{Place, SceneError};
use crate::scene::units::{Dimension, parse_quantity};

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Frequency,
    AngularFrequency,
    Time,
    Temperature,
    Storage,
    Loss,
    LossTangent,
    Relaxation,
    Creep,
    Factor,
    LogFactor,
}

/// Role, key in `material.columns`, dimension, and headers that mean it (small letters, without spaces and strokes).
const ROLES: [(Role, &str, Dimension, &[&str]); 11] = [
    (Role::Frequency, "frequency", Dimension::FREQUENCY, &["frequency", "freq", "f"]),
    (Role::AngularFrequency, "angular_frequency", Dimension::FREQUENCY, &["angularfrequency", "angfrequency", "omega", "ω", "w"]),
    (Role::Time, "time", Dimension::TIME, &["time", "t", "steptime"]),
    (Role::Temperature, "temperature", Dimension::TEMPERATURE, &["temperature", "temp"]),
    (
        Role::Storage,
        "storage_modulus",
        Dimension::PRESSURE,
        &["storagemodulus", "storage", "e'", "e′", "estor", "estorage", "g'", "g′", "gstor", "gstorage"],
    ),
    (Role::Loss, "loss_modulus", Dimension::PRESSURE, &["lossmodulus", "loss", "e''", "e″", "e\"", "eloss", "g''", "g″", "g\"", "gloss"]),
    (Role::LossTangent, "loss_tangent", Dimension::NUMBER, &["losstangent", "tandelta", "tanδ", "tan(δ)", "tan(delta)", "lossfactor"]),
    (Role::Relaxation, "relaxation_modulus", Dimension::PRESSURE, &["relaxationmodulus", "r", "e(t)", "erelax", "g(t)", "grelax"]),
    (Role::Creep, "creep_compliance", Dimension::COMPLIANCE, &["creepcompliance", "compliance", "j", "j(t)", "d(t)"]),
    (Role::Factor, "factor", Dimension::NUMBER, &["factor", "shiftfactor", "at"]),
    (Role::LogFactor, "log10_factor", Dimension::NUMBER, &["log10factor", "log10at", "logat"]),
];

pub(super) struct Column {
    pub(super) role: Role,
    pub(super) unit: String,
    /// Named like a shear modulus: the header begins with G.
    pub(super) named_shear: bool,
    /// The scene says what the column holds.
    pub(super) by_scene: bool,
    pub(super) place: Place,
}

/// The word of a role in messages and in `material.columns`.
pub(super) fn word(role: Role) -> &'static str {
    ROLES.iter().find(|entry| entry.0 == role).map_or("", |entry| entry.1)
}

fn dimension(role: Role) -> Dimension {
    ROLES.iter().find(|entry| entry.0 == role).map_or(Dimension::NUMBER, |entry| entry.2)
}

pub(super) const EXAMPLE: &str = "the header is such as: frequency (Hz), storage modulus (MPa), loss modulus (MPa); or time (s), relaxation modulus (MPa); or name the columns in [material.columns]";

/// Roles with their headers and units, as `material.columns` states them.
pub(super) fn stated_columns(table: &Section<'_>) -> Result<Vec<(Role, String, Option<String>)>, SceneError> {
    let Some(columns) = table.table("columns") else { return Ok(Vec::new()) };
    let mut stated: Vec<(Role, String, Option<String>)> = Vec::new();
    for (role, key, ..) in ROLES {
        if let Some(text) = columns.text(key) {
            let (name, unit) = match text.rsplit_once(" in ") {
                Some((name, unit)) => (name.trim().to_owned(), Some(unit.trim().to_owned())),
                None => (text.trim().to_owned(), None),
            };
            if stated.iter().any(|other| other.1 == name) {
                return Err(columns.wrong(
                    key,
                    format!("`{}` names a header that another key names, too", columns.full(key)),
                    "one of the two",
                ));
            }
            stated.push((role, name, unit));
        }
    }
    Ok(stated)
}

/// A name as [`ROLES`] has it.
fn plain(name: &str) -> String {
    name.to_lowercase().chars().filter(|c| !matches!(c, ' ' | '_' | '-')).collect()
}

fn role_of(name: &str) -> Option<Role> {
    let plain = plain(name);
    ROLES.iter().find(|entry| entry.3.contains(&plain.as_str())).map(|entry| entry.0)
}

/// A header's name and its unit: what stands behind a known name is its unit, whether or not it can be read; `E(t)` is a name.
fn split(header: &str, is_known: impl Fn(&str) -> bool) -> (String, Option<String>) {
    let parts = |name: &str, unit: &str| (name.trim().to_owned(), Some(unit.trim().to_owned()));
    if is_known(header) {
        return (header.trim().to_owned(), None);
    }
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some((name, rest)) = header.rsplit_once(open)
            && let Some(unit) = rest.trim_end().strip_suffix(close)
            && !name.trim().is_empty()
            && (is_known(name.trim()) || parse_quantity(&format!("1 {unit}")).is_ok())
        {
            return parts(name, unit);
        }
    }
    match (header.rsplit_once(" / "), header.split_once('/')) {
        (Some((name, unit)), _) => parts(name, unit),
        (None, Some((name, unit))) if is_known(name.trim()) => parts(name, unit),
        _ => (header.trim().to_owned(), None),
    }
}

/// What a column holds; none for one that has no role.
pub(super) fn column(
    place: &Place,
    unit_below: Option<String>,
    stated: &[(Role, String, Option<String>)],
) -> Result<Option<Column>, SceneError> {
    let text = written(place);
    let (name, own_unit) = split(text, |name| role_of(name).is_some() || stated.iter().any(|(_, header, _)| header == name));
    let by_scene = stated.iter().find(|(_, header, _)| header == text || *header == name);
    let Some(mut role) = by_scene.map(|entry| entry.0).or_else(|| role_of(&name)) else { return Ok(None) };
    // A role that the scene gives to another header is taken.
    if by_scene.is_none() && stated.iter().any(|entry| entry.0 == role) {
        return Ok(None);
    }
    let unit = by_scene.and_then(|entry| entry.2.clone()).or(own_unit).or(unit_below).unwrap_or_default();
    let quantity = parse_quantity(&format!("1 {unit}")).map_err(|error| {
        let message = format!("the unit of the column `{text}` cannot be read: {error}");
        SceneError::at(place, message, format!("must be that of {}", dimension(role).example())).help(format!(
            "write another unit into the header, or into [material.columns]: {} = \"{text} in {}\"",
            word(role),
            dimension(role).si_unit()
        ))
    })?;
    // `T` with a unit of temperature is no time.
    if role == Role::Time && by_scene.is_none() && quantity.dimension.measures(Dimension::TEMPERATURE) {
        role = Role::Temperature;
    }
    let wanted = dimension(role);
    if unit.is_empty() && wanted != Dimension::NUMBER {
        let message = format!("the column `{text}` has no unit");
        return Err(SceneError::at(place, message, "here").help(format!(
            "write it into the header, or into [material.columns]: {} = \"{text} in {}\"",
            word(role),
            if matches!(role, Role::Frequency) { "Hz".to_owned() } else { wanted.si_unit() }
        )));
    }
    if !quantity.dimension.measures(wanted) {
        let message = format!(
            "the column `{text}` is taken as the {}, and has the wrong unit: it is measured in {}",
            word(role).replace('_', " "),
            quantity.dimension.si_unit()
        );
        return Err(SceneError::at(place, message, format!("must be {}", wanted.example())));
    }
    // Cycles or radians: the unit decides, and may not contradict the name.
    let radians = unit.contains("rad");
    let cycles = unit.contains("Hz");
    match role {
        Role::Frequency if radians => role = Role::AngularFrequency,
        Role::AngularFrequency if cycles => {
            return Err(SceneError::at(
                place,
                format!("the column `{text}` is an angular frequency in Hz"),
                "rad/s, or a frequency in Hz?",
            )
            .help("name it frequency if it counts cycles; write rad/s if it counts radians"));
        }
        Role::Frequency if !cycles => {
            return Err(SceneError::at(
                place,
                format!("the column `{text}` does not say whether it counts cycles or radians"),
                "Hz or rad/s?",
            ));
        }
        _ => {}
    }
    let named_shear = matches!(role, Role::Storage | Role::Loss | Role::Relaxation) && plain(&name).starts_with('g');
    Ok(Some(Column { role, unit, named_shear, by_scene: by_scene.is_some(), place: place.clone() }))
}
