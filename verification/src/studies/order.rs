//! Orders of convergence: what is expected beforehand and why, what is seen, and whether that is it.
//!
//! ```text
//! ln error │ ·  ·                       fineness: nodes, steps, 1/δ; the order is the slope of the last points that
//!          │      · \ p                 stand above ten times the floor (rounding, or what the truth itself leaves open)
//!    floor │__________·_·__ ln fineness
//! ```

use super::section::{Cell, Check};

/// Points above this many floors count as error and not as rounding.
const ABOVE_FLOOR: f64 = 10.0;
/// The asymptotic part, unless a study says otherwise: the finest points above the floor, at most so many.
pub const FINEST: usize = 4;
/// An order needs at least so many.
const FEWEST_POINTS: usize = 3;
/// Digits a node need at least so many: a geometric method is on the floor after a few nodes.
const FEWEST_GEOMETRIC: usize = 2;

/// What is expected of a method, stated before it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Expectation {
    /// error ∝ fineness^(−order), the order seen between `least` and `most`.
    Order {
        /// The order.
        order: f64,
        /// The least that passes.
        least: f64,
        /// The most that passes: a higher order than a method has is a mistake of the study.
        most: f64,
        /// Why.
        reason: &'static str,
    },
    /// Each unit of fineness brings at least so many decimal digits.
    Digits {
        /// Digits per unit of fineness.
        least: f64,
        /// Why.
        reason: &'static str,
    },
    /// It does not converge: some error of the finer half of the points is at least this large.
    Erratic {
        /// An error that remains.
        least_error: f64,
        /// Why.
        reason: &'static str,
    },
}

/// A rate seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Slope of −ln error over ln fineness, or decimal digits per unit of fineness.
    pub rate: f64,
    /// Number of points behind it.
    pub points: usize,
}

/// Errors of a method over its fineness, and what is expected of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Convergence {
    /// The method and quantity.
    pub name: String,
    /// (fineness, error), the fineness growing.
    pub points: Vec<(f64, f64)>,
    /// Errors near it are rounding, or what the truth leaves open.
    pub floor: f64,
    /// How many of the finest points above the floor are fitted: [`FINEST`], or more where single points scatter.
    pub fitted: usize,
    /// What is expected.
    pub expected: Expectation,
}

/// Slope of y over x by least squares; none for fewer points than `fewest`.
fn slope(points: &[(f64, f64)], fewest: usize) -> Option<Fit> {
    if points.len() < fewest {
        return None;
    }
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|point| point.0), mean(&|point| point.1));
    let (mut above, mut below) = (0.0, 0.0);
    for point in points {
        above += (point.0 - x) * (point.1 - y);
        below += (point.0 - x) * (point.0 - x);
    }
    let rate = above / below;
    rate.is_finite().then_some(Fit { rate, points: points.len() })
}

/// The order of errors ∝ fineness^(−order), on the `most` finest points above the floor; none where there are fewer than three.
#[must_use]
pub fn fitted_order(points: &[(f64, f64)], floor: f64, most: usize) -> Option<Fit> {
    let above: Vec<(f64, f64)> = finite(points).filter(|(_, error)| *error > ABOVE_FLOOR * floor).collect();
    let finest = above.get(above.len().saturating_sub(most)..).unwrap_or_default();
    slope(&finest.iter().map(|(fineness, error)| (fineness.ln(), -error.ln())).collect::<Vec<_>>(), FEWEST_POINTS)
}

/// The decimal digits that each unit of fineness brings, on the points above the floor and the first one upon it, which counts with the floor: the least
/// that the method brings. None for fewer than two.
#[must_use]
pub fn fitted_digits(points: &[(f64, f64)], floor: f64) -> Option<Fit> {
    let above = finite(points).take_while(|(_, error)| *error > ABOVE_FLOOR * floor).count();
    let counted: Vec<(f64, f64)> = finite(points).take(above + 1).map(|(fineness, error)| (fineness, -error.max(floor).log10())).collect();
    slope(&counted, FEWEST_GEOMETRIC)
}

fn finite(points: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> {
    points.iter().copied().filter(|(fineness, error)| *fineness > 0.0 && fineness.is_finite() && error.is_finite())
}

impl Convergence {
    /// The rate seen; none where the points do not show one.
    #[must_use]
    pub fn fit(&self) -> Option<Fit> {
        match self.expected {
            Expectation::Digits { .. } => fitted_digits(&self.points, self.floor),
            _ => fitted_order(&self.points, self.floor, self.fitted),
        }
    }

    /// The line in the legend: the name and the rate seen.
    #[must_use]
    pub fn label(&self) -> String {
        match (self.fit(), self.expected) {
            (_, Expectation::Erratic { .. }) => format!("{}: no order", self.name),
            (None, _) => format!("{}: too few points", self.name),
            (Some(fit), Expectation::Digits { .. }) => format!("{}: {:.2} digits a node", self.name, fit.rate),
            (Some(fit), Expectation::Order { .. }) => format!("{}: order {:.2}", self.name, fit.rate),
        }
    }

    /// Expected against found.
    #[must_use]
    pub fn check(&self) -> Check {
        let name = format!("order: {}", self.name);
        let points = |fit: Fit| format!("{:.2} from {} points above the floor {:.0e}", fit.rate, fit.points, self.floor);
        match (self.expected, self.fit()) {
            (Expectation::Order { order, least, most, reason }, fit) => {
                let expected = format!("order {order} ({least} to {most}): {reason}");
                let passed = fit.is_some_and(|fit| fit.rate >= least && fit.rate <= most);
                Check::new(name, expected, fit.map_or_else(|| "too few points".to_owned(), |fit| format!("order {}", points(fit))), passed)
            }
            (Expectation::Digits { least, reason }, fit) => {
                let expected = format!("at least {least} digits a node: {reason}");
                let found = fit.map_or_else(|| "too few points".to_owned(), |fit| format!("digits {}", points(fit)));
                Check::new(name, expected, found, fit.is_some_and(|fit| fit.rate >= least))
            }
            (Expectation::Erratic { least_error, reason }, _) => {
                let finer = self.points.get(self.points.len() / 2..).unwrap_or_default();
                let worst = finer.iter().map(|point| point.1).fold(0.0, f64::max);
                let expected = format!("no order, errors above {least_error:.0e} among the finer meshes: {reason}");
                Check::new(name, expected, format!("an error of {worst:.1e} among the finer meshes"), worst >= least_error)
            }
        }
    }

    /// Rows of a table: name, fineness, error.
    #[must_use]
    pub fn rows(&self) -> Vec<Vec<Cell>> {
        let row =
            |&(fineness, error): &(f64, f64)| vec![Cell::Word(self.name.clone()), Cell::Number(Some(fineness)), Cell::Number(Some(error))];
        self.points.iter().map(row).collect()
    }
}
