//! The manifest as data: figures, their sources, panels, curves and features.

use super::forms::Form;
use super::measure::Take;
use super::quantity::Quantity;
use serde::Deserialize;
use std::collections::BTreeMap;
use thiserror::Error;

/// The manifest that the program carries.
const EMBEDDED: &str = include_str!("../../figures.toml");

/// What is wrong with a manifest.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ManifestError {
    /// The text cannot be read.
    #[error("the manifest cannot be read: {0}")]
    Unreadable(String),
    /// A name that nothing has.
    #[error("{place}: {what} `{name}` does not exist; there are: {known}")]
    Unknown {
        /// Figure and panel.
        place: String,
        /// What is meant.
        what: &'static str,
        /// The name.
        name: String,
        /// What exists.
        known: String,
    },
    /// An entry that contradicts itself.
    #[error("{place}: {problem}")]
    Contradiction {
        /// Figure and panel.
        place: String,
        /// What is wrong.
        problem: String,
    },
}

/// All figures.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Beginnings of scenes, by name.
    #[serde(default)]
    pub(super) base: BTreeMap<String, String>,
    /// The figures, in the order of the thesis.
    pub(super) figure: Vec<FigureEntry>,
    /// Figures that are not computed, and why.
    #[serde(default)]
    pub(super) not_reproduced: Vec<NotReproduced>,
}

/// A figure that is not computed.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct NotReproduced {
    pub(super) id: String,
    pub(super) reason: String,
}

/// A figure of the thesis.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FigureEntry {
    /// Its number.
    pub(super) id: String,
    /// What it shows, in our words.
    pub(super) title: String,
    /// The section that discusses it.
    pub(super) section: String,
    /// Parameters that the thesis states.
    pub(super) stated: String,
    /// Parameters that it leaves out, and what we chose.
    pub(super) chosen: String,
    /// Whether it belongs to the reduced set.
    #[serde(default)]
    pub(super) reduced: bool,
    /// How far its measured numbers may drift from the baseline, relative to the larger of themselves and one.
    #[serde(default = "default_drift")]
    pub(super) drift: f64,
    #[serde(default)]
    pub(super) source: Vec<SourceEntry>,
    pub(super) panel: Vec<PanelEntry>,
}

fn one() -> f64 {
    1.0
}

fn default_drift() -> f64 {
    1e-6
}

/// Where numbers come from: a scene, or a closed form.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SourceEntry {
    pub(super) name: String,
    /// The beginning of the scene.
    pub(super) base: Option<String>,
    /// The rest of the scene.
    pub(super) scene: Option<String>,
    /// Values put into the scene, as in `--set`.
    #[serde(default)]
    pub(super) set: Vec<String>,
    /// Take the points of the fields, not the rows.
    #[serde(default)]
    pub(super) fields: bool,
    /// A closed form instead of a scene.
    pub(super) form: Option<Form>,
}

/// A panel.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PanelEntry {
    /// Its letter; empty for a figure of one panel.
    #[serde(default)]
    pub(super) id: String,
    #[serde(default)]
    pub(super) title: String,
    pub(super) x: AxisEntry,
    pub(super) y: AxisEntry,
    pub(super) curves: Vec<CurveEntry>,
    #[serde(default)]
    pub(super) features: Vec<FeatureEntry>,
    /// A magnified part of the panel.
    pub(super) inset: Option<InsetEntry>,
    /// Where the legend goes, if not placed automatically.
    pub(super) legend: Option<Corner>,
}

/// A corner of the frame, or below it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Corner {
    TopLeft,
    TopRight,
    BottomLeft,
    BottomRight,
    Below,
}

/// A picture in the picture: the same curves on a part of the axes, or other quantities of them.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct InsetEntry {
    pub(super) x: AxisEntry,
    pub(super) y: AxisEntry,
    /// Its corner.
    pub(super) place: Corner,
    /// Its curves; without them, those of the panel.
    #[serde(default)]
    pub(super) curves: Vec<CurveEntry>,
}

/// An axis.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisEntry {
    /// What it shows of every curve that does not say otherwise.
    pub(super) of: Quantity,
    pub(super) label: String,
    /// The unit in tables.
    pub(super) unit: String,
    #[serde(default)]
    pub(super) log: bool,
    pub(super) range: Option<[f64; 2]>,
}

/// Curves selected from a source.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CurveEntry {
    pub(super) source: String,
    /// Further sources with the same columns: their rows follow.
    #[serde(default)]
    pub(super) also: Vec<String>,
    /// Its name in tables and features; `{}` stands for the value of `each`.
    pub(super) name: String,
    /// Its line in the legend; `{}` as above. None: not in the legend.
    pub(super) label: Option<String>,
    /// One curve for each value of this column.
    pub(super) each: Option<String>,
    /// Of which only these.
    #[serde(default)]
    pub(super) only: Vec<f64>,
    /// Rows that it is made of.
    #[serde(default)]
    pub(super) when: BTreeMap<String, Condition>,
    /// Only the rows up to the one in which this column is largest.
    pub(super) until_largest: Option<String>,
    /// Only the rows from the one in which this column is largest.
    pub(super) from_largest: Option<String>,
    pub(super) x: Option<Quantity>,
    pub(super) y: Option<Quantity>,
    /// Sorted by x.
    #[serde(default)]
    pub(super) sorted: bool,
    /// Drawn dashed: without adhesion, unstable, or the rival.
    #[serde(default)]
    pub(super) dashed: bool,
    /// Drawn dashed in the rows where this column is 0.
    pub(super) solid_where: Option<String>,
    #[serde(default)]
    pub(super) dotted: bool,
    /// Points only.
    #[serde(default)]
    pub(super) marked: bool,
    /// Colour of the first curve; the others follow.
    pub(super) colour: Option<usize>,
    /// All in that colour.
    #[serde(default)]
    pub(super) one_colour: bool,
    /// Values of `each` are shown times this in labels, for a handier unit.
    #[serde(default = "one")]
    pub(super) shown_times: f64,
    /// Measured, not drawn.
    #[serde(default)]
    pub(super) hidden: bool,
}

/// What a row must be to belong to a curve.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(super) enum Condition {
    Word(String),
    Number(f64),
    Range(Range),
}

/// Bounds of a number, either of them optional.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Range {
    pub(super) above: Option<f64>,
    pub(super) below: Option<f64>,
}

/// Something that the panel must show.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FeatureEntry {
    /// In our own words.
    pub(super) claim: String,
    /// Section or equation of the thesis that states it; without it, the claim is ours.
    #[serde(default)]
    pub(super) source: String,
    /// What comes out instead, and why.
    pub(super) not_confirmed: Option<String>,
    /// Bounds on what comes out instead.
    pub(super) comes_out: Option<[f64; 2]>,
    /// What is measured.
    pub(super) take: Take,
    /// On which curve.
    pub(super) curve: Option<String>,
    /// Or on several, in this order.
    #[serde(default)]
    pub(super) curves: Vec<String>,
    /// At this x.
    pub(super) at: Option<f64>,
    /// In this part of the x axis.
    pub(super) over: Option<[f64; 2]>,
    /// Measured as on logarithmic axes, whatever those of the panel.
    #[serde(default)]
    pub(super) log: bool,
    /// The y that is crossed.
    pub(super) level: Option<f64>,
    /// Divided by the same of another curve.
    pub(super) per: Option<Other>,
    /// The curve that it is compared with, point by point.
    pub(super) than: Option<String>,
    pub(super) equals: Option<f64>,
    /// Relative to `equals`, or absolute where that is zero.
    pub(super) within: Option<f64>,
    pub(super) above: Option<f64>,
    pub(super) below: Option<f64>,
    pub(super) between: Option<[f64; 2]>,
    pub(super) order: Option<Order>,
}

/// What a measured number is divided by.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Other {
    pub(super) curve: String,
    /// Plus the same of this one.
    pub(super) plus: Option<String>,
    /// Measured in the same way unless said.
    pub(super) take: Option<Take>,
    pub(super) at: Option<f64>,
    pub(super) over: Option<[f64; 2]>,
}

/// Which way a list of measured numbers runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Order {
    Increasing,
    Decreasing,
}

impl Manifest {
    /// The figures of the thesis, as the program carries them.
    ///
    /// # Errors
    /// None unless the program was built with a broken manifest.
    pub fn embedded() -> Result<Self, ManifestError> {
        Self::parse(EMBEDDED)
    }

    /// A manifest from its text.
    ///
    /// # Errors
    /// [`ManifestError::Unreadable`] with the place of what is wrong.
    pub fn parse(text: &str) -> Result<Self, ManifestError> {
        toml::from_str(text).map_err(|error| {
            // The place in words: the line itself may be of any file.
            let before = error.span().and_then(|span| text.get(..span.start)).unwrap_or("");
            let line = 1 + before.matches('\n').count();
            ManifestError::Unreadable(format!("line {line}: {}", error.message()))
        })
    }

    /// The numbers of all figures.
    #[must_use]
    pub fn ids(&self) -> Vec<&str> {
        self.figure.iter().map(|figure| figure.id.as_str()).collect()
    }

    /// The names of all panels, as `3.2a`.
    #[must_use]
    pub fn panel_ids(&self) -> Vec<String> {
        self.figure.iter().flat_map(|figure| figure.panel.iter().map(move |panel| format!("{}{}", figure.id, panel.id))).collect()
    }

    /// Number of features of each figure.
    #[must_use]
    pub fn features(&self) -> Vec<(&str, usize)> {
        self.figure.iter().map(|figure| (figure.id.as_str(), figure.panel.iter().map(|panel| panel.features.len()).sum())).collect()
    }

    /// Figures that are not computed, with the reason.
    #[must_use]
    pub fn not_reproduced(&self) -> Vec<(&str, &str)> {
        self.not_reproduced.iter().map(|entry| (entry.id.as_str(), entry.reason.as_str())).collect()
    }

    /// How far measured numbers of a figure may drift from their baseline.
    #[must_use]
    pub fn drift(&self, id: &str) -> Option<f64> {
        self.figure.iter().find(|figure| figure.id == id).map(|figure| figure.drift)
    }
}
