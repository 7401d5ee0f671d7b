//! The columns of a material's table: what the scene states, and what a header and its unit say.

use super::column_names::{Role, Strained, dimension, meaning, roles, split, unit_within, word};
use super::column_units::{Counted, unit};
use super::section::Section;
use crate::scene::delimited::{Scale, bare_unit};
use crate::scene::diagnostic::{Place, SceneError};
use crate::scene::document::toml_text;
use crate::scene::units::Dimension;

pub(super) struct Column {
    pub(super) role: Role,
    /// Of the cell in its row.
    pub(super) index: usize,
    pub(super) scale: Scale,
    /// What the name says of the strain.
    pub(super) strained: Option<Strained>,
    /// The scene says what the column holds.
    pub(super) by_scene: bool,
    pub(super) place: Place,
    /// The header.
    pub(super) text: String,
}

/// A role that the scene gives to a header, perhaps with a unit.
pub(super) type StatedColumn = (Role, String, Option<String>);

/// Roles with their headers and units, as `material.columns` states them.
pub(super) fn stated_columns(table: &Section<'_>) -> Result<Vec<StatedColumn>, SceneError> {
    let Some(columns) = table.table("columns") else { return Ok(Vec::new()) };
    let mut stated: Vec<StatedColumn> = Vec::new();
    for (role, key) in roles() {
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

/// A header as it stands in a table.
pub(super) struct Header<'h> {
    pub(super) text: &'h str,
    pub(super) index: usize,
    pub(super) place: Place,
    pub(super) unit_below: Option<&'h str>,
}

/// What a column holds; none for one that has no role. The inner error is one of its unit: it counts where the column is used.
pub(super) fn column(header: &Header<'_>, stated: &[StatedColumn]) -> Option<(Role, Result<Column, SceneError>)> {
    let text = header.text;
    let known = |name: &str| meaning(name).is_some() || stated.iter().any(|(_, header, _)| header == name);
    let (name, own_unit) = split(text, known);
    let by_scene = stated.iter().find(|(_, header, _)| header == text || *header == name);
    let own_unit = own_unit.or_else(|| by_scene.and_then(|_| unit_within(text)));
    let said = meaning(&name);
    let role = by_scene.map(|entry| entry.0).or(said.map(|entry| entry.0))?;
    // A role that the scene gives to another header is taken.
    if by_scene.is_none() && stated.iter().any(|entry| entry.0 == role) {
        return None;
    }
    let of_scene = by_scene.and_then(|entry| entry.2.clone());
    if let (None, Some(own), Some(below)) = (&of_scene, &own_unit, header.unit_below)
        && !matches!(bare_unit(below), "" | "-" | "1")
        && bare_unit(own) != bare_unit(below)
    {
        let message = format!("the column `{text}` has two units, and below it stands {below:?}");
        let error = SceneError::at(&header.place, message, "which of the two?")
            .help(format!("write one of them, or state it in [material.columns]: {} = \"{text} in UNIT\"", word(role)));
        return Some((role, Err(error)));
    }
    let unit = of_scene.or(own_unit).or_else(|| header.unit_below.map(str::to_owned)).unwrap_or_default();
    let strained = said.and_then(|entry| entry.1).or_else(|| {
        // `G prime` means nothing here, and still begins with the letter of shear.
        let letter = super::column_names::plain(&name).starts_with('g');
        (by_scene.is_some() && letter).then_some(Strained::Shear)
    });
    let made = with_unit(header, role, &unit, by_scene.is_some()).map(|(role, scale)| Column {
        role,
        index: header.index,
        scale,
        strained,
        by_scene: by_scene.is_some(),
        place: header.place.clone(),
        text: text.to_owned(),
    });
    Some((made.as_ref().map_or(role, |column| column.role), made))
}

/// The unit that is likely meant by a misspelt one.
fn meant(written: &str) -> Option<&'static str> {
    let plain = bare_unit(written).to_lowercase();
    let known = ["Pa", "kPa", "MPa", "GPa", "Hz", "mHz", "kHz", "rad/s", "s", "ms", "min", "h", "1/Pa", "1/MPa", "psi", "K", "°C", "°F"];
    match plain.as_str() {
        "c" | "celsius" => Some("°C"),
        "f" | "fahrenheit" => Some("°F"),
        "kelvin" => Some("K"),
        _ => known.into_iter().find(|unit| unit.to_lowercase() == plain),
    }
}

/// The line of [material.columns] that gives a column its unit: what is likely meant, or what is usual.
pub(super) fn line(role: Role, header: &str) -> String {
    let (name, unit) = split(header, |name| meaning(name).is_some());
    let (name, unit) = match unit.as_deref().and_then(meant) {
        Some(unit) => (header.to_owned(), unit),
        None if unit.is_some() => (header.to_owned(), usual(role)),
        None => (name, usual(role)),
    };
    let value = if dimension(role) == Dimension::NUMBER && role != Role::Phase { name } else { format!("{name} in {unit}") };
    format!("{} = {}", word(role), toml_text(&value))
}

/// What to type where columns have no unit or an unknown name: lines of a scene, and the same for a command.
pub(super) fn lines_to_type(lines: &[String]) -> String {
    let sets: Vec<String> = lines
        .iter()
        .filter_map(|line| {
            let (key, value) = line.split_once(" = ")?;
            // A shell takes everything between single quotes as it is.
            let set = format!("material.columns.{key}={value}");
            Some(if set.contains('\'') { format!("--set \"{}\"", set.replace('"', "\\\"")) } else { format!("--set '{set}'") })
        })
        .collect();
    format!(
        "write the units into the header; or into the scene:\n[material.columns]\n{}\nor add to the command: {}",
        lines.join("\n"),
        sets.join(" ")
    )
}

/// A unit in which a role is often given.
const fn usual(role: Role) -> &'static str {
    match role {
        Role::Frequency => "Hz",
        Role::AngularFrequency => "rad/s",
        Role::Time => "s",
        Role::Temperature => "°C",
        Role::Creep => "1/MPa",
        Role::Phase => "deg",
        _ => "MPa",
    }
}

/// The role that a unit leaves, and the scale.
fn with_unit(header: &Header<'_>, role: Role, written: &str, by_scene: bool) -> Result<(Role, Scale), SceneError> {
    let (text, place) = (header.text, &header.place);
    let as_in = |unit: &str| format!("{} = \"{text} in {unit}\"", word(role));
    let (scale, counted) = unit(written).map_err(|error| {
        let message = format!("the unit of the column `{text}` cannot be read: {error}");
        SceneError::at(place, message, format!("must be that of {}", dimension(role).example())).help(match meant(written) {
            Some(unit) => format!("if {unit} is meant, write it into the header, or into [material.columns]: {}", as_in(unit)),
            None => format!("write another unit into the header, or into [material.columns] in place of UNIT: {}", as_in("UNIT")),
        })
    })?;
    // `T` with a unit of temperature is no time.
    if role == Role::Time && !by_scene && scale.dimension.measures(Dimension::TEMPERATURE) {
        return Ok((Role::Temperature, scale));
    }
    let wanted = dimension(role);
    if (written.is_empty() || (counted.is_none() && role == Role::Phase)) && (wanted != Dimension::NUMBER || role == Role::Phase) {
        let help = if role == Role::Phase { format!("{}, or in rad", as_in("deg")) } else { as_in(usual(role)) };
        return Err(SceneError::at(place, format!("the column `{text}` has no unit"), "here")
            .help(format!("write it into the header, or into [material.columns], such as: {help}")));
    }
    if !scale.dimension.measures(wanted) {
        let message = format!(
            "the column `{text}` is taken as the {}, and has the wrong unit: it is measured in {}",
            word(role).replace('_', " "),
            scale.dimension.si_unit()
        );
        return Err(SceneError::at(place, message, format!("must be {}", wanted.example())));
    }
    // Cycles or radians: the unit decides, and may not contradict the name.
    match (role, counted) {
        (Role::Frequency, Some(Counted::Radians)) => Ok((Role::AngularFrequency, scale)),
        (Role::AngularFrequency, Some(Counted::Cycles)) => {
            let message = format!("the column `{text}` is an angular frequency in {}", bare_unit(written));
            Err(SceneError::at(place, message, "rad/s, or a frequency in Hz?")
                .help("name it frequency if it counts cycles; write rad/s if it counts radians"))
        }
        (Role::Frequency, None) => {
            let message = format!("the column `{text}` does not say whether it counts cycles or radians");
            Err(SceneError::at(place, message, "Hz or rad/s?")
                .help(format!("write into [material.columns]: frequency = \"{text} in Hz\", or angular_frequency = \"{text} in rad/s\"")))
        }
        _ => Ok((role, scale)),
    }
}
