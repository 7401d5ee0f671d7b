//! Convergence of every solver and its rivals, the order seen against the order stated beforehand.
//!
//! | file | solver | fineness | rival |
//! |---|---|---|---|
//! | [`sliding`] | contacts with given edges | Gauss points of a panel | collocation as the thesis prints it, and with aligned windows |
//! | [`sphere`] | the integration | steps of the path | dense annuli |
//! | [`crack`] | growth under a load | grid lines of a process zone | stepping as the thesis prints it |
//! | [`zone`] | all three | 1/δ | closed forms of δ = 0 |
//!
//! Steady cracks have neither nodes nor steps: their closure is a sum of closed terms. What their rival pays is in the work-precision section.

pub(super) mod crack;
mod known_growth;
pub(super) mod sliding;
pub(super) mod sphere;
pub(super) mod stored_sliding;
pub(super) mod zone;

pub(super) use known_growth::KnownGrowth;

use super::order::Convergence;
use super::section::{Column, Plot, Section, Table, ours, rival};
use viscotack_program::outcome::plot::{Axis, Curve, Figure};

/// Errors below this are not drawn: an exact agreement has no place on a logarithmic axis.
const LEAST_DRAWN: f64 = 1e-17;

/// One set of curves on the same axes: a plot, a table and a check for each curve.
pub(super) struct Panel {
    pub(super) identifier: &'static str,
    pub(super) caption: &'static str,
    pub(super) fineness: (&'static str, &'static str),
    pub(super) error: &'static str,
    /// Each with whether it is of this program.
    pub(super) curves: Vec<(Convergence, bool)>,
    pub(super) headline: bool,
}

impl Panel {
    /// Adds plot, table and checks to a section.
    pub(super) fn into_section(self, section: &mut Section) {
        let (plain, label) = self.fineness;
        let mut figure = Figure::new(Axis::logarithmic(label), Axis::logarithmic(self.error));
        let columns = vec![Column::words("method and quantity"), Column::new(plain, "1"), Column::new("error", "1")];
        let mut table = Table::new(self.identifier, format!("Every point of the plot: {}", self.caption), columns).folded();
        for (place, (convergence, own)) in self.curves.iter().enumerate() {
            let drawn = |&(fineness, error): &(f64, f64)| (fineness, error.max(LEAST_DRAWN));
            let points: Vec<(f64, f64)> = convergence.points.iter().map(drawn).collect();
            let draw: fn(String, Vec<(f64, f64)>) -> Curve = if *own { ours } else { rival };
            figure = figure.with_curve(draw(convergence.label(), points).with_colour(place));
            table.rows.extend(convergence.rows());
            section.checks.push(convergence.check());
        }
        let plot = Plot::new(self.identifier, self.caption, figure);
        section.plots.push(if self.headline { plot.headline() } else { plot });
        section.tables.push(table);
    }
}
