//! What a run of figures gives.

use super::curve::Curve;
use super::feature::{Checked, FeatureResult};
use super::manifest::{FigureEntry, PanelEntry};

/// All figures of a run.
#[derive(Debug, Clone)]
pub struct Report {
    /// In the order of the manifest.
    pub figures: Vec<FigureReport>,
    /// Figures that are not computed, with the reason.
    pub not_reproduced: Vec<(String, String)>,
    /// What program made it.
    pub program: String,
}

/// One figure.
#[derive(Debug, Clone)]
pub struct FigureReport {
    /// Its number.
    pub id: String,
    pub(super) entry: FigureEntry,
    /// Its panels.
    pub panels: Vec<PanelReport>,
    /// What its sources took (s).
    pub seconds: f64,
    /// Whether any source was computed now.
    pub fresh: bool,
    /// Rows without values, with the reason.
    pub remarks: Vec<String>,
}

/// One panel.
#[derive(Debug, Clone)]
pub struct PanelReport {
    /// Figure and letter, as `3.2a`.
    pub id: String,
    pub(super) entry: PanelEntry,
    pub(super) curves: Vec<Curve>,
    pub(super) inset: Vec<Curve>,
    /// Its features.
    pub features: Vec<Checked>,
}

impl FigureReport {
    /// Number of features that ended in a way.
    #[must_use]
    pub fn count(&self, result: FeatureResult) -> usize {
        self.panels.iter().flat_map(|panel| &panel.features).filter(|feature| feature.result == result).count()
    }
}

impl Report {
    /// Whether the run made this panel.
    pub(super) fn has_panel(&self, id: &str) -> bool {
        self.figures.iter().flat_map(|figure| &figure.panels).any(|panel| panel.id == id)
    }

    /// Number of features that ended in a way.
    #[must_use]
    pub fn count(&self, result: FeatureResult) -> usize {
        self.figures.iter().map(|figure| figure.count(result)).sum()
    }

    /// The table: figure, passed, not confirmed, failed, seconds; then every feature that failed.
    #[must_use]
    pub fn table(&self) -> String {
        let mut text =
            format!("{:<8} {:>6} {:>8} {:>13} {:>6} {:>8}\n", "figure", "panels", "passed", "not confirmed", "failed", "seconds");
        let line = |name: &str, panels: usize, [passed, open, failed]: [usize; 3], seconds: String| {
            format!("{name:<8} {panels:>6} {passed:>8} {open:>13} {failed:>6} {seconds:>8}\n")
        };
        const RESULTS: [FeatureResult; 3] = [FeatureResult::Passed, FeatureResult::NotConfirmed, FeatureResult::Failed];
        for figure in &self.figures {
            let seconds = if figure.fresh { format!("{:.2}", figure.seconds) } else { "kept".to_owned() };
            text.push_str(&line(&figure.id, figure.panels.len(), RESULTS.map(|result| figure.count(result)), seconds));
        }
        let panels = self.figures.iter().map(|figure| figure.panels.len()).sum();
        let seconds =
            self.figures.iter().filter(|figure| figure.fresh).map(|figure| figure.seconds).fold(0.0, |sum, seconds| sum + seconds);
        text.push_str(&line("all", panels, RESULTS.map(|result| self.count(result)), format!("{seconds:.2}")));
        for (id, reason) in &self.not_reproduced {
            text.push_str(&format!("{id:<8} not reproduced: {reason}\n"));
        }
        for panel in self.figures.iter().flat_map(|figure| &figure.panels) {
            for feature in panel.features.iter().filter(|feature| feature.result == FeatureResult::Failed) {
                let numbers = feature.measured.iter().map(|number| format!("{number:.6e}")).collect::<Vec<_>>().join(", ");
                text.push_str(&format!(
                    "FAILED {}: {} (expected {}, measured {numbers}: {})\n",
                    panel.id, feature.claim, feature.expected, feature.why
                ));
            }
        }
        text
    }
}
