//! COMSOL: a text file with parameters (`name value[unit] "description"`) and, as parameters or as rows of two columns, Maxwell branches.
//!
//! ```text
//! E    3[MPa]            Young's modulus and Poisson ratio, or G and K, or G and nu, of the linear elastic material
//! nu   0.49
//! G1   0.4[MPa]          shear modulus of a branch, with tau1; or rows:   0.4[MPa]   0.01[s]
//! tau1 0.01[s]
//! ```
//! Only the shear modulus relaxes; the bulk modulus is constant. The elastic moduli are long-term, COMSOL's default, unless `material.moduli` says
//! otherwise. Numbers without a unit are in `material.deck_units`. Source: COMSOL Structural Mechanics Module User's Guide, Viscoelasticity.

use super::Deck;
use super::source::{DeckSource, Line, skipped};
use crate::scene::diagnostic::SceneError;
use crate::scene::read::material_solid::{Moduli, Relaxing, Solid, Strength, Volume};
use crate::scene::units::{Dimension, parse_quantity};

/// A word with the line that it stands in.
type Cell<'a> = (&'a str, Line<'a>);

/// The parts of a deck.
#[derive(Default)]
struct Parts<'a> {
    /// Lower-case name without underscores, and value.
    parameters: Vec<(String, Cell<'a>)>,
    /// Rows: shear modulus, time.
    rows: Vec<[Cell<'a>; 2]>,
}

pub(super) fn recognises(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with(['%', '#'])).peekable();
    let unit = |line: &str| line.contains('[') && line.contains(']') && !line.starts_with('[') && !line.contains('=');
    let short = |line: &str| words(line).iter().take(2).count() == 2 && !line.contains(['=', '*']);
    lines.peek().is_some() && lines.clone().any(unit) && lines.all(short)
}

/// The words of a line; a description in quotes is one word.
fn words(line: &str) -> Vec<&str> {
    let bare = line.split('"').next().unwrap_or("");
    bare.split(|c: char| c.is_whitespace() || c == ',' || c == ';').filter(|word| !word.is_empty()).collect()
}

pub(super) fn parse(source: &DeckSource<'_>) -> Result<Deck, SceneError> {
    if source.wanted.is_some() {
        return Err(source.missing("is one material without a name, but material.deck_material names one", "leave deck_material out"));
    }
    let parts = parts(source)?;
    let get = |name: &str| parts.parameters.iter().find(|(key, _)| key == name).map(|(_, cell)| cell);
    let pressure = |(word, line): &Cell<'_>, name: &str| quantity(source, line, word, name, Dimension::PRESSURE);
    let ratio = |(word, line): &Cell<'_>| source.ratio(line, word.trim_end_matches("[1]"), "nu");
    let (shear, volume) = match (get("e"), get("g"), get("k"), get("nu")) {
        (None, Some(g), Some(k), None) => (pressure(g, "G")?, Volume::Bulk(Relaxing::constant(pressure(k, "K")?))),
        (Some(cell), None, None, Some(nu)) => {
            let (youngs, nu) = (pressure(cell, "E")?, ratio(nu)?);
            (youngs / (2.0 * (1.0 + nu)), volume(youngs / (2.0 * (1.0 + nu)), nu))
        }
        (None, Some(cell), None, Some(nu)) => {
            let (shear, nu) = (pressure(cell, "G")?, ratio(nu)?);
            (shear, volume(shear, nu))
        }
        _ => {
            let help = "write two of them as lines of the file, for example:\nG  0.5[MPa]\nK  2[GPa]";
            return Err(source
                .missing("needs either E and nu, or G and K, or G and nu of the linear elastic material", "this file")
                .help(help));
        }
    };
    let mut terms = Vec::new();
    let mut used = vec!["e", "g", "k", "nu"].into_iter().map(str::to_owned).collect::<Vec<_>>();
    for (name, cell) in &parts.parameters {
        let Some(index) = branch(name, "g") else { continue };
        let time_name = format!("tau{index}");
        let Some((_, (word, line))) = parts.parameters.iter().find(|(key, _)| *key == time_name) else {
            return Err(source
                .wrong(&cell.1, format!("the branch {name} has no {time_name}"), "this branch")
                .help(format!("add a line: {time_name} 1[s]")));
        };
        terms.push((pressure(cell, name)?, quantity(source, line, word, &time_name, Dimension::TIME)?));
        used.extend([name.clone(), time_name]);
    }
    for [modulus, (word, line)] in &parts.rows {
        terms.push((
            pressure(modulus, "the shear modulus of a branch")?,
            quantity(source, line, word, "the relaxation time of a branch", Dimension::TIME)?,
        ));
    }
    if let Some((name, (_, line))) = parts.parameters.iter().find(|(name, _)| branch(name, "tau").is_some() && !used.contains(name)) {
        return Err(source.wrong(line, format!("{name} has no shear modulus beside it"), "this time"));
    }
    if terms.is_empty() {
        let help = "add lines such as:\nG1    0.4[MPa]\ntau1  0.01[s]";
        return Err(source.missing("has no Maxwell branch", "this file").help(help));
    }
    let (moduli, mut notes) = match source.moduli() {
        Some("instantaneous") => (Moduli::Instantaneous, Vec::new()),
        Some(_) => (Moduli::LongTerm, Vec::new()),
        None => (
            Moduli::LongTerm,
            vec!["the elastic moduli are taken as long-term, COMSOL's default; material.moduli can say otherwise".to_owned()],
        ),
    };
    notes.push("only the shear modulus relaxes, as in COMSOL".to_owned());
    let idle: Vec<(String, usize)> =
        parts.parameters.iter().filter(|(name, _)| !used.contains(name)).map(|(name, (_, line))| (name.clone(), line.number)).collect();
    notes.extend(skipped(&idle));
    Ok(Deck {
        name: None,
        solid: Solid { shear: Relaxing { modulus: shear, moduli, strength: Strength::Modulus, terms }, volume },
        shift: None,
        notes,
    })
}

/// The constant bulk modulus of a shear modulus and a Poisson ratio.
fn volume(shear: f64, ratio: f64) -> Volume {
    if ratio < 0.5 {
        Volume::Bulk(Relaxing::constant(shear * (2.0 * (1.0 + ratio)) / (3.0 * (1.0 - 2.0 * ratio))))
    } else {
        Volume::PoissonRatio(ratio)
    }
}

/// The digits of a name such as g3 or tau3.
fn branch<'n>(name: &'n str, kind: &str) -> Option<&'n str> {
    name.strip_prefix(kind).filter(|rest| !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit()))
}

fn parts<'a>(source: &DeckSource<'a>) -> Result<Parts<'a>, SceneError> {
    let mut parts = Parts::default();
    for line in source.lines() {
        let text = line.text.trim();
        if text.is_empty() || text.starts_with(['%', '#']) {
            continue;
        }
        let found = words(text);
        let numeric = found.first().is_some_and(|word| word.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+')));
        match found.as_slice() {
            [modulus, time] if numeric => parts.rows.push([(modulus, line), (time, line)]),
            [name, value, ..] if !numeric => {
                let name: String = name.chars().filter(|&c| c != '_').collect::<String>().to_lowercase();
                if parts.parameters.iter().any(|(known, _)| *known == name) {
                    return Err(source.wrong(&line, format!("{name} is given twice"), "leave one out"));
                }
                parts.parameters.push((name, (value, line)));
            }
            _ if numeric => {
                let message = format!("a row of {} columns", found.len());
                return Err(source.wrong(&line, message, "must be: shear modulus, relaxation time"));
            }
            _ => {
                return Err(source.wrong(
                    &line,
                    "neither a parameter nor a branch",
                    "must be: name value[unit], or: shear modulus, relaxation time",
                ));
            }
        }
    }
    Ok(parts)
}

/// A positive number in SI units, with its unit in brackets or in the deck's.
fn quantity(source: &DeckSource<'_>, line: &Line<'_>, word: &str, name: &str, dimension: Dimension) -> Result<f64, SceneError> {
    let value = match word.strip_suffix(']').and_then(|rest| rest.split_once('[')) {
        Some((number, unit)) => {
            source.positive(line, number, name)?;
            match parse_quantity(&format!("{number} {unit}")) {
                Ok(quantity) if quantity.dimension.measures(dimension) => quantity.value,
                _ => {
                    let example = if dimension == Dimension::TIME { "[s] or [ms]" } else { "[Pa] or [MPa]" };
                    return Err(source.wrong(
                        line,
                        format!("{name} = {word:?} is in no unit that fits"),
                        &format!("for example {example}"),
                    ));
                }
            }
        }
        None => {
            let number = source.positive(line, word, name)?;
            if dimension == Dimension::TIME { source.time(number)? } else { source.pressure(number)? }
        }
    };
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(source.wrong(line, format!("{name} = {word:?} is not positive"), "must be greater than 0"))
    }
}
