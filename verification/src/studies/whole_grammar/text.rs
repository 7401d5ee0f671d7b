//! A scene as text, written key by key: every number in SI in units that are drawn, or plain in reduced groups.

use super::super::draw::Draw;

/// Units of a kind of number: the word, and what it is in SI.
pub(super) type Units = &'static [(&'static str, f64)];

pub(super) const NUMBER: Units = &[];
pub(super) const LENGTH: Units = &[("m", 1.0), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9)];
pub(super) const TIME: Units = &[("s", 1.0), ("ms", 1e-3), ("min", 60.0)];
pub(super) const RATE: Units = &[("1/s", 1.0), ("1/min", 1.0 / 60.0)];
pub(super) const FREQUENCY: Units = &[("Hz", 1.0), ("kHz", 1e3)];
pub(super) const PRESSURE: Units = &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6)];
pub(super) const COMPLIANCE: Units = &[("1/Pa", 1.0), ("1/MPa", 1e-6)];
pub(super) const VISCOSITY: Units = &[("Pa s", 1.0)];
pub(super) const SPEED: Units = &[("m/s", 1.0), ("mm/s", 1e-3), ("µm/s", 1e-6)];
pub(super) const ENERGY_PER_AREA: Units = &[("J/m²", 1.0), ("mJ/m²", 1e-3)];
pub(super) const LOAD_PER_WIDTH: Units = &[("N/m", 1.0), ("mN/m", 1e-3)];
pub(super) const STIFFNESS: Units = &[("N/m", 1.0), ("mN/m", 1e-3)];
pub(super) const STIFFNESS_PER_AREA: Units = &[("Pa/m", 1.0), ("N/m3", 1.0)];
pub(super) const INTENSITY: Units = &[("Pa √m", 1.0), ("kPa √m", 1e3), ("MPa √m", 1e6)];
pub(super) const INTENSITY_RATE: Units = &[("Pa √m/s", 1.0)];
pub(super) const PRESSURE_RATE: Units = &[("Pa/s", 1.0), ("kPa/s", 1e3)];
pub(super) const FORCE: Units = &[("N", 1.0), ("mN", 1e-3), ("µN", 1e-6)];
pub(super) const FORCE_RATE: Units = &[("N/s", 1.0), ("mN/s", 1e-3)];
pub(super) const TEMPERATURE: Units = &[("K", 1.0)];
pub(super) const ENERGY_PER_MOLE: Units = &[("J/mol", 1.0), ("kJ/mol", 1e3)];

/// A text or word as TOML.
pub(super) fn quoted(word: &str) -> String {
    format!("{word:?}")
}

/// A scene while it is written.
#[derive(Debug)]
pub(super) struct Text {
    /// What the scene is.
    pub(super) draw: Draw,
    /// How its numbers are written: another stream, so that the same scene can be written in other units.
    units: Draw,
    /// Plain numbers in reduced groups.
    pub(super) reduced: bool,
    /// Plain numbers now: what is fitted to them turns on their last digits.
    pub(super) plain: bool,
    pub(super) lines: Vec<String>,
    /// Files that it names.
    pub(super) files: Vec<(String, String)>,
    /// Where they are not those of its problem.
    pub(super) accuracies: Option<Accuracies>,
}

/// Accuracies that are asked for, one of them of a scene, and the tightest that a truth is asked for.
pub(super) type Accuracies = ([f64; 4], f64);

impl Text {
    pub(super) fn new(draw: Draw, units: Draw) -> Self {
        Self { draw, units, reduced: false, plain: false, lines: Vec::new(), files: Vec::new(), accuracies: None }
    }

    /// A number of `reduced` units of `scale` (SI).
    pub(super) fn number(&mut self, reduced: f64, scale: f64, units: Units) -> String {
        if self.reduced {
            return format!("{reduced:e}");
        }
        let value = reduced * scale;
        if self.plain {
            return format!("{value:e}");
        }
        // Plain numbers are SI.
        let choice = self.units.below(units.len() + 1);
        match units.get(choice) {
            Some((word, size)) => format!("\"{:e} {word}\"", value / size),
            None => format!("{value:e}"),
        }
    }

    /// `key = value`, the value as TOML.
    pub(super) fn put(&mut self, key: &str, value: impl AsRef<str>) {
        self.lines.push(format!("{key} = {}", value.as_ref()));
    }

    /// A number under a key.
    pub(super) fn put_number(&mut self, key: &str, reduced: f64, scale: f64, units: Units) {
        let number = self.number(reduced, scale, units);
        self.put(key, number);
    }

    /// Names a file under a key.
    pub(super) fn put_file(&mut self, key: &str, name: &str, text: impl Into<String>) {
        self.put(key, quoted(name));
        self.files.push((name.to_owned(), text.into()));
    }

    /// One of some words.
    pub(super) fn word<'w>(&mut self, words: &[&'w str]) -> &'w str {
        words.get(self.draw.below(words.len())).copied().unwrap_or_default()
    }

    /// True this often.
    pub(super) fn chance(&mut self, probability: f64) -> bool {
        self.draw.chance(probability)
    }

    /// The whole scene.
    pub(super) fn written(self) -> (String, Vec<(String, String)>) {
        (self.lines.join("\n") + "\n", self.files)
    }
}
