//! From a manifest to files: select, compute, measure, draw.

use super::curve::{Curve, curves};
use super::feature::checked;
use super::jobs::{self, Computed, JobError};
use super::manifest::{CurveEntry, FigureEntry, Manifest, ManifestError, PanelEntry};
use super::measure::Scales;
use super::quantity::Quantity;
use super::report::{FigureReport, PanelReport, Report};
use super::source::{Source, SourceError};
use super::store::Store;
use super::{draw, sheet, shown};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::PathBuf;
use thiserror::Error;

/// What is wanted.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Figures (`3.2`), panels (`3.2a`) or chapters (`3`); none: all.
    pub ids: Vec<String>,
    /// The folder for tables, plots and the contact sheet; none: nothing is written.
    pub out: Option<PathBuf>,
    /// Only the figures of the reduced set.
    pub reduced: bool,
}

/// Why a run ended without a report.
#[derive(Debug, Error)]
pub enum FiguresError {
    /// A figure that is not in the manifest.
    #[error("there is no figure `{id}`; {hint}")]
    NoSuchFigure {
        /// What was asked for.
        id: String,
        /// What there is.
        hint: String,
    },
    /// The manifest is wrong.
    #[error("{0}")]
    Manifest(#[from] ManifestError),
    /// A source cannot be computed.
    #[error("{place}: {error}")]
    Source {
        /// Figure and source.
        place: String,
        /// Why.
        error: Box<SourceError>,
    },
    /// A file cannot be written.
    #[error("{0}")]
    Folder(#[from] viscotack_program::outcome::folder::FolderError),
    /// A scene that somebody changed would be lost.
    #[error("`{path}` is not replaced: {why}; move it away, or choose another --scenes")]
    Scenes {
        /// The file.
        path: String,
        /// What it is.
        why: String,
    },
    /// A plot cannot be drawn.
    #[error("panel {panel}: {error}")]
    Plot {
        /// Which.
        panel: String,
        /// Why.
        error: viscotack_program::outcome::plot::PlotError,
    },
    /// A table cannot be written.
    #[error("a table cannot be written: {0}")]
    Table(#[from] csv::Error),
}

/// Makes the figures; `progress` hears of finished sources and their number.
///
/// # Errors
/// [`FiguresError`]; a feature that fails is no error, but a result in the report.
pub fn run(manifest: &Manifest, options: &Options, progress: &(dyn Fn(usize, usize) + Sync)) -> Result<Report, FiguresError> {
    let chosen = selected(manifest, options)?;
    let store = options.out.as_deref().map(Store::open).transpose()?;
    let program = viscotack_program::outcome::build::identity().to_owned();
    let sources: Vec<Vec<Source>> = chosen
        .iter()
        .map(|(figure, panels)| {
            let needed = figure.source.iter().filter(|source| panels.iter().any(|panel| uses(panel, &source.name)));
            needed.map(|source| Source::new(manifest, &figure.id, source, &program)).collect::<Result<_, _>>()
        })
        .collect::<Result<_, _>>()?;
    let tables = jobs::tables(sources.iter().flatten().cloned().collect(), store.as_ref(), progress).map_err(|error| match error {
        JobError::Source(place, error) => FiguresError::Source { place, error },
        JobError::Store(error) => FiguresError::Folder(error),
    })?;
    let mut figures = Vec::with_capacity(chosen.len());
    for ((figure, panels), sources) in chosen.iter().zip(&sources) {
        figures.push(figure_report(figure, panels, sources, &tables)?);
    }
    let whole = options.ids.is_empty() && !options.reduced;
    let not_reproduced = if whole {
        manifest.not_reproduced().into_iter().map(|(id, reason)| (id.to_owned(), reason.to_owned())).collect()
    } else {
        Vec::new()
    };
    let report = Report { figures, not_reproduced, program };
    if let Some(mut out) = store.map(Store::into_folder) {
        let digests = draw::write(&report, &mut out)?;
        let figures = shown::merged(&report, &digests, &mut out)?;
        out.replace("features.csv", &shown::features(&figures)?)?;
        sheet::write(&report, &figures, &mut out)?;
    }
    Ok(report)
}

pub(super) fn uses(panel: &PanelEntry, source: &str) -> bool {
    let inset = panel.inset.iter().flat_map(|inset| &inset.curves);
    panel.curves.iter().chain(inset).any(|curve| curve.source == source || curve.also.iter().any(|also| also == source))
}

/// The figures asked for, each with its panels.
pub(super) fn selected<'a>(manifest: &'a Manifest, options: &Options) -> Result<Vec<(&'a FigureEntry, Vec<&'a PanelEntry>)>, FiguresError> {
    let name = |figure: &FigureEntry, panel: &PanelEntry| format!("{}{}", figure.id, panel.id);
    let matches = |id: &str, figure: &FigureEntry, panel: &PanelEntry| {
        id == figure.id || id == name(figure, panel) || figure.id.split('.').next() == Some(id)
    };
    for id in &options.ids {
        if !manifest.figure.iter().any(|figure| figure.panel.iter().any(|panel| matches(id, figure, panel))) {
            let hint = match manifest.not_reproduced.iter().find(|entry| entry.id == *id) {
                Some(entry) => format!("it is not reproduced: {}", entry.reason),
                None => format!("there are {}", manifest.ids().join(", ")),
            };
            return Err(FiguresError::NoSuchFigure { id: id.clone(), hint });
        }
    }
    let wanted = |figure: &FigureEntry, panel: &PanelEntry| {
        (options.ids.is_empty() || options.ids.iter().any(|id| matches(id, figure, panel))) && (figure.reduced || !options.reduced)
    };
    Ok(manifest
        .figure
        .iter()
        .map(|figure| (figure, figure.panel.iter().filter(|panel| wanted(figure, panel)).collect::<Vec<_>>()))
        .filter(|(_, panels)| !panels.is_empty())
        .collect())
}

fn figure_report(
    figure: &FigureEntry,
    panels: &[&PanelEntry],
    sources: &[Source],
    tables: &BTreeMap<String, Computed>,
) -> Result<FigureReport, FiguresError> {
    let needed: Vec<&super::manifest::SourceEntry> =
        figure.source.iter().filter(|source| panels.iter().any(|panel| uses(panel, &source.name))).collect();
    let computed: BTreeMap<&str, &Computed> =
        needed.iter().zip(sources).filter_map(|(entry, source)| Some((entry.name.as_str(), tables.get(&source.key)?))).collect();
    let mut reports = Vec::with_capacity(panels.len());
    for panel in panels {
        let id = format!("{}{}", figure.id, panel.id);
        let place = format!("panel {id}");
        let own = all_curves(&place, &panel.curves, &computed, (&panel.x.of, &panel.y.of))?;
        let inset = match &panel.inset {
            Some(inset) => {
                let entries = if inset.curves.is_empty() { &panel.curves } else { &inset.curves };
                all_curves(&place, entries, &computed, (&inset.x.of, &inset.y.of))?
            }
            None => Vec::new(),
        };
        let scales = Scales { x_log: panel.x.log, y_log: panel.y.log };
        // Features may be about curves of the inset, too: their names are their own.
        let mut measurable = own.clone();
        measurable.extend(inset.iter().filter(|curve| !own.iter().any(|other| other.name == curve.name)).cloned());
        let features = panel.features.iter().map(|entry| checked(&place, entry, &measurable, scales)).collect::<Result<_, _>>()?;
        reports.push(PanelReport { id, entry: (*panel).clone(), curves: own, inset, features });
    }
    Ok(FigureReport {
        id: figure.id.clone(),
        entry: figure.clone(),
        panels: reports,
        seconds: computed.values().map(|computed| computed.table.seconds).sum(),
        fresh: computed.values().any(|computed| computed.fresh),
        remarks: computed.values().flat_map(|computed| computed.table.remarks.iter().cloned()).collect(),
    })
}

fn all_curves(
    place: &str,
    entries: &[CurveEntry],
    computed: &BTreeMap<&str, &Computed>,
    axes: (&Quantity, &Quantity),
) -> Result<Vec<Curve>, ManifestError> {
    let mut all: Vec<Curve> = Vec::new();
    for entry in entries {
        let find = |name: &String| {
            computed.get(name.as_str()).map(|computed| &computed.table).ok_or_else(|| ManifestError::Unknown {
                place: place.to_owned(),
                what: "source",
                name: name.clone(),
                known: computed.keys().copied().collect::<Vec<_>>().join(", "),
            })
        };
        let mut table = Cow::Borrowed(find(&entry.source)?);
        for name in &entry.also {
            table.to_mut().append(find(name)?);
        }
        let colour = all.iter().map(|curve| curve.colour + 1).max().unwrap_or(0);
        for curve in curves(place, entry, &table, axes, colour)? {
            if all.iter().any(|other| other.name == curve.name) {
                let problem = format!("two curves are named `{}`", curve.name);
                return Err(ManifestError::Contradiction { place: place.to_owned(), problem });
            }
            all.push(curve);
        }
    }
    Ok(all)
}
