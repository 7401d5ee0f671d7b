//! What the index of a folder shows: the panels of this run, and those that earlier runs left there.
//!
//! `panels.json` keeps each panel with the day, the program and the digest of its table. An earlier panel stays in the index while its table is in the folder.

use super::feature::{Checked, FeatureResult};
use super::report::{FigureReport, PanelReport, Report};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use viscotack_program::outcome::csv_table::{self, Cell};
use viscotack_program::outcome::folder::FolderError;
use viscotack_program::outcome::owned::{OwnedFolder, digest};
use viscotack_program::regular_file;

/// The file that keeps them.
const FILE: &str = "panels.json";
/// Neither it nor a table is larger (bytes).
const LARGEST: u64 = 1 << 28;

/// A figure of the index.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct ShownFigure {
    pub(super) id: String,
    pub(super) title: String,
    pub(super) section: String,
    pub(super) stated: String,
    pub(super) chosen: String,
    pub(super) panels: Vec<ShownPanel>,
    /// What the sources of the latest run took (s).
    pub(super) seconds: f64,
    pub(super) remarks: Vec<String>,
}

/// A panel of the index.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct ShownPanel {
    pub(super) id: String,
    pub(super) title: String,
    /// Day of the run, universal time.
    pub(super) date: String,
    /// Program that made it.
    pub(super) program: String,
    /// SHA-256 of its table.
    pub(super) digest: String,
    pub(super) features: Vec<ShownFeature>,
    /// Whether an earlier run left it.
    #[serde(skip)]
    pub(super) earlier: bool,
    /// Whether its table is another one now.
    #[serde(skip)]
    pub(super) altered: bool,
}

/// A feature of the index.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct ShownFeature {
    pub(super) claim: String,
    pub(super) source: String,
    #[serde(rename = "verdict")]
    pub(super) result: FeatureResult,
    /// Texts, so that numbers which are not finite are kept, too.
    pub(super) measured: Vec<String>,
    pub(super) expected: String,
    pub(super) why: String,
    pub(super) broken_by: Vec<String>,
}

impl ShownFigure {
    /// Number of features that ended in a way.
    pub(super) fn count(&self, result: FeatureResult) -> usize {
        self.panels.iter().flat_map(|panel| &panel.features).filter(|feature| feature.result == result).count()
    }
}

/// The figures of a run and the earlier ones of its folder, in the order of their numbers; keeps them in the folder.
pub(super) fn merged(report: &Report, digests: &BTreeMap<String, String>, out: &mut OwnedFolder) -> Result<Vec<ShownFigure>, FolderError> {
    let date = crate::date::today();
    let mut figures: Vec<ShownFigure> = report.figures.iter().map(|figure| of_figure(figure, &report.program, &date, digests)).collect();
    for old in earlier(out) {
        match figures.iter_mut().find(|figure| figure.id == old.id) {
            Some(figure) => {
                let missing = old.panels.into_iter().filter(|panel| !report.has_panel(&panel.id));
                figure.panels.extend(missing);
            }
            None => figures.push(old),
        }
    }
    for figure in &mut figures {
        figure.panels.sort_by(|one, other| one.id.cmp(&other.id));
    }
    figures.sort_by_cached_key(|figure| place(&figure.id));
    let text = serde_json::to_vec(&figures).map_err(|error| FolderError::io(&out.path().join(FILE))(error.into()))?;
    out.replace(FILE, &text)?;
    Ok(figures)
}

/// What earlier runs left; a file that cannot be read counts as none, a panel whose table is gone as well.
fn earlier(out: &OwnedFolder) -> Vec<ShownFigure> {
    let kept = regular_file::read(&out.path().join(FILE), LARGEST).ok();
    let mut figures: Vec<ShownFigure> = kept.and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default();
    for figure in &mut figures {
        figure.panels.retain_mut(|panel| match regular_file::read(&out.path().join(format!("{}.csv", panel.id)), LARGEST) {
            Ok(table) => {
                panel.earlier = true;
                panel.altered = digest(&table) != panel.digest;
                true
            }
            Err(_) => false,
        });
    }
    figures.retain(|figure| !figure.panels.is_empty());
    figures
}

/// Chapter and number: 3.2 stands before 3.10.
fn place(id: &str) -> (Vec<u32>, String) {
    (id.split('.').map(|part| part.parse().unwrap_or(u32::MAX)).collect(), id.to_owned())
}

fn of_figure(figure: &FigureReport, program: &str, date: &str, digests: &BTreeMap<String, String>) -> ShownFigure {
    let entry = &figure.entry;
    let of_panel = |panel: &PanelReport| ShownPanel {
        id: panel.id.clone(),
        title: panel.entry.title.clone(),
        date: date.to_owned(),
        program: program.to_owned(),
        digest: digests.get(&panel.id).cloned().unwrap_or_default(),
        features: panel.features.iter().map(of_feature).collect(),
        earlier: false,
        altered: false,
    };
    ShownFigure {
        id: figure.id.clone(),
        title: entry.title.clone(),
        section: entry.section.clone(),
        stated: entry.stated.clone(),
        chosen: entry.chosen.clone(),
        panels: figure.panels.iter().map(of_panel).collect(),
        seconds: figure.seconds,
        remarks: figure.remarks.clone(),
    }
}

fn of_feature(feature: &Checked) -> ShownFeature {
    ShownFeature {
        claim: feature.claim.clone(),
        source: feature.source.clone(),
        result: feature.result,
        measured: feature.measured.iter().map(|number| format!("{number:e}")).collect(),
        expected: feature.expected.clone(),
        why: feature.why.clone(),
        broken_by: feature.broken_by.iter().map(|mutation| mutation.word().to_owned()).collect(),
    }
}

/// Every feature with what was measured, as `features.csv`.
pub(super) fn features(figures: &[ShownFigure]) -> Result<Vec<u8>, csv::Error> {
    let header = ["figure", "panel", "claim", "source", "verdict", "measured", "expected", "broken_by", "why", "date"].map(str::to_owned);
    let mut rows = Vec::new();
    for figure in figures {
        for panel in &figure.panels {
            for feature in &panel.features {
                let words = [
                    figure.id.clone(),
                    panel.id.clone(),
                    feature.claim.clone(),
                    feature.source.clone(),
                    feature.result.word().to_owned(),
                    feature.measured.join(" "),
                    feature.expected.clone(),
                    feature.broken_by.join(" "),
                    feature.why.clone(),
                    panel.date.clone(),
                ];
                rows.push(words.into_iter().map(Cell::Word).collect());
            }
        }
    }
    csv_table::records(&header, &rows)
}
