//! The text of a deck with its units: lines with places for messages, numbers, and which of several materials is meant.

use crate::scene::diagnostic::{Place, SceneError, SourceText};
use crate::scene::read::section::Section;
use crate::scene::units::{Dimension, parse_quantity};
use std::cell::RefCell;
use std::collections::HashSet;

/// Most skipped keywords that a note names.
const MOST_NAMED: usize = 12;

/// A line of a deck.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    /// From 1.
    pub(super) number: usize,
    /// Bytes before it.
    pub(super) start: usize,
    /// Without its end.
    pub(super) text: &'a str,
}

/// A deck and what the scene says of it.
pub(super) struct DeckSource<'a> {
    section: &'a Section<'a>,
    form: &'static str,
    text: &'a SourceText,
    /// The deck's material that is meant.
    pub(super) wanted: Option<&'a str>,
    used: RefCell<HashSet<&'static str>>,
}

impl<'a> DeckSource<'a> {
    pub(super) fn new(section: &'a Section<'a>, form: &'static str, text: &'a SourceText) -> Result<Self, SceneError> {
        let source = Self { section, form, text, wanted: section.text("deck_material"), used: RefCell::default() };
        for (key, dimension) in [("pressure", Dimension::PRESSURE), ("time", Dimension::TIME), ("temperature", Dimension::TEMPERATURE)] {
            source.unit(key, dimension)?;
        }
        Ok(source)
    }

    /// What `material.moduli` says.
    pub(super) fn moduli(&self) -> Option<&'a str> {
        self.section.text("moduli")
    }

    /// The lines, without a byte-order mark.
    pub(super) fn lines(&self) -> Vec<Line<'a>> {
        let text = self.text.text();
        let mut start = 0;
        let mut lines = Vec::new();
        for (index, whole) in text.split_inclusive('\n').enumerate() {
            let line = whole.trim_end_matches(['\n', '\r']);
            let (line, begin) = match line.strip_prefix('\u{feff}') {
                Some(rest) => (rest, start + '\u{feff}'.len_utf8()),
                None => (line, start),
            };
            lines.push(Line { number: index + 1, start: begin, text: line });
            start += whole.len();
        }
        lines
    }

    /// An error at a line.
    pub(super) fn wrong(&self, line: &Line<'_>, message: impl Into<String>, label: &str) -> SceneError {
        let lead = line.text.len() - line.text.trim_start().len();
        let place = Place { source: self.text.clone(), span: line.start + lead..line.start + line.text.trim_end().len().max(lead) };
        SceneError::at(&place, format!("line {} of {:?}: {}", line.number, self.text.name(), message.into()), label)
    }

    /// An error about the whole deck, at the key that names it.
    pub(super) fn missing(&self, message: impl Into<String>, label: &str) -> SceneError {
        self.section.wrong(self.form, format!("{:?}: {}", self.text.name(), message.into()), label)
    }

    /// A finite number; `D` exponents as Fortran writes them are read.
    pub(super) fn number(&self, line: &Line<'_>, word: &str, name: &str) -> Result<f64, SceneError> {
        let plain = word.trim().replace(['d', 'D'], "e");
        match plain.parse::<f64>() {
            // "inf" and "nan" are no numbers of a deck.
            Ok(value) if value.is_finite() => Ok(value),
            _ => {
                let message = format!("{name} = {:?} is no number", word.trim());
                Err(self
                    .wrong(line, message, "here")
                    .help("viscotack reads numbers only: write the value in place of a parameter or a formula"))
            }
        }
    }

    /// A number that is zero or more.
    pub(super) fn non_negative(&self, line: &Line<'_>, word: &str, name: &str) -> Result<f64, SceneError> {
        let value = self.number(line, word, name)?;
        if value < 0.0 { Err(self.wrong(line, format!("{name} = {value} is negative"), "must be 0 or more")) } else { Ok(value) }
    }

    /// A number above zero.
    pub(super) fn positive(&self, line: &Line<'_>, word: &str, name: &str) -> Result<f64, SceneError> {
        let value = self.number(line, word, name)?;
        if value > 0.0 { Ok(value) } else { Err(self.wrong(line, format!("{name} = {value} is not positive"), "must be greater than 0")) }
    }

    /// A Poisson ratio.
    pub(super) fn ratio(&self, line: &Line<'_>, word: &str, name: &str) -> Result<f64, SceneError> {
        let value = self.number(line, word, name)?;
        if value > -1.0 && value <= 0.5 {
            Ok(value)
        } else {
            Err(self.wrong(line, format!("{name} = {value} is no Poisson ratio of a stable solid"), "must be above -1 and at most 0.5"))
        }
    }

    /// A pressure of the deck in Pa.
    pub(super) fn pressure(&self, value: f64) -> Result<f64, SceneError> {
        Ok(value * self.stated("pressure", Dimension::PRESSURE)?)
    }

    /// A time of the deck in s.
    pub(super) fn time(&self, value: f64) -> Result<f64, SceneError> {
        Ok(value * self.stated("time", Dimension::TIME)?)
    }

    /// A temperature of the deck in K.
    pub(super) fn temperature(&self, value: f64) -> Result<f64, SceneError> {
        let unit = self.temperature_unit()?;
        Ok(parse_quantity(&format!("{value} {unit}")).map_or(f64::NAN, |quantity| quantity.value))
    }

    /// A difference of temperatures of the deck in K.
    pub(super) fn temperature_difference(&self, value: f64) -> Result<f64, SceneError> {
        Ok(value * if self.temperature_unit()?.ends_with('F') { 1.0 / 1.8 } else { 1.0 })
    }

    fn temperature_unit(&self) -> Result<&'a str, SceneError> {
        self.stated("temperature", Dimension::TEMPERATURE)?;
        let word = self.section.table("deck_units").and_then(|units| units.text("temperature"));
        word.ok_or_else(|| self.no_unit("temperature"))
    }

    fn stated(&self, key: &'static str, dimension: Dimension) -> Result<f64, SceneError> {
        self.used.borrow_mut().insert(key);
        self.unit(key, dimension)?.ok_or_else(|| self.no_unit(key))
    }

    /// One unit of the deck in SI units, if the scene says what it is.
    fn unit(&self, key: &'static str, dimension: Dimension) -> Result<Option<f64>, SceneError> {
        let Some(units) = self.section.table("deck_units") else { return Ok(None) };
        let Some(word) = units.text(key) else { return Ok(None) };
        match parse_quantity(&format!("1 {word}")) {
            Ok(quantity) if quantity.dimension.measures(dimension) => Ok(Some(quantity.value)),
            _ => {
                let message = format!("`{}` = {word:?} is no unit of {key}", units.full(key));
                let allowed = match key {
                    "pressure" => "allowed: \"Pa\", \"kPa\", \"MPa\", \"GPa\", \"psi\" and the like",
                    "time" => "allowed: \"s\", \"ms\", \"µs\", \"min\", \"h\" and the like",
                    _ => "allowed: \"°C\", \"K\", \"°F\"",
                };
                Err(units.wrong(key, message, "a unit without a number").help(allowed))
            }
        }
    }

    fn no_unit(&self, key: &str) -> SceneError {
        let also = if key == "temperature" { ", temperature = \"°C\"" } else { "" };
        let message = format!("a deck has no units, and `material.deck_units.{key}` does not say what its {key} is measured in");
        let line = format!("deck_units = {{ pressure = \"MPa\", time = \"s\"{also} }}");
        self.missing(message, "the units of this deck")
            .help(format!("with the units of your deck, write in [material]: {line}; on the command line: --set 'material.{line}'"))
    }

    /// A note on units that no number of the deck needed, if there are any.
    pub(super) fn unused_units(&self) -> Option<String> {
        let units = self.section.table("deck_units")?;
        let used = self.used.borrow();
        let idle: Vec<&str> =
            ["pressure", "time", "temperature"].into_iter().filter(|key| units.text(key).is_some() && !used.contains(key)).collect();
        (!idle.is_empty()).then(|| format!("no number of the deck is measured in deck_units.{}: not used", idle.join(" or ")))
    }

    /// The one material that is meant: the only one, or the one that the scene names. Names are compared without regard to case.
    pub(super) fn chosen<'m, M>(&self, materials: &'m [M], names: impl Fn(&M) -> Vec<String>, what: &str) -> Result<&'m M, SceneError> {
        let list = || materials.iter().filter_map(|material| names(material).into_iter().next()).collect::<Vec<_>>().join(", ");
        match (self.wanted, materials) {
            (_, []) => Err(self.missing(format!("holds no {what}"), "this deck")),
            (Some(wanted), _) => {
                let is = |material: &&M| names(material).iter().any(|name| name.eq_ignore_ascii_case(wanted));
                let mut found = materials.iter().filter(is);
                let one = found.next().ok_or_else(|| {
                    let message = format!("`material.deck_material` = {wanted:?} is not in {:?}", self.text.name());
                    self.section.wrong("deck_material", message, "this name").help(format!("it holds: {}", list()))
                })?;
                if found.next().is_some() {
                    return Err(self.missing(format!("holds the material {wanted:?} more than once"), "leave one out"));
                }
                Ok(one)
            }
            (None, [one]) => Ok(one),
            (None, [first, ..]) => {
                let name = names(first).into_iter().next().unwrap_or_default();
                let message = format!("holds {} materials: {}", materials.len(), list());
                Err(self
                    .missing(message, "which one is meant?")
                    .help(format!("write deck_material = {name:?} in [material], or another of them")))
            }
        }
    }
}

/// A note on what was skipped, if anything was: each name once, with its first line.
pub(super) fn skipped(names: &[(String, usize)]) -> Option<String> {
    let mut once: Vec<&(String, usize)> = Vec::new();
    for one in names {
        if !once.iter().any(|known| known.0 == one.0) {
            once.push(one);
        }
    }
    let named: Vec<String> = once.iter().take(MOST_NAMED).map(|(name, line)| format!("{name} (line {line})")).collect();
    let more = once.len().saturating_sub(MOST_NAMED);
    let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
    (!named.is_empty()).then(|| format!("skipped, as no part of the relaxation: {}{rest}", named.join(", ")))
}
