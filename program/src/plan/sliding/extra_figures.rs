//! The plots of columns on request: the share of the edges, the map of regimes, sensitivities.

use super::SlidingPlan;
use super::columns::place_of;
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::plan::curves::{Family, Kind, families, figure, innermost, value};
use crate::scene::sweep::Sweep;
use crate::scene::typed::{Scene, SlidingColumns, SlidingContact};

/// The parameters of sensitivities: the ends of their columns' names and their symbols.
const PARAMETERS: [(&str, &str); 5] = [
    ("_by_process_zone", r"process zone $\delta$"),
    ("_by_work_of_adhesion", r"work of adhesion $\Delta\gamma$"),
    ("_by_relaxed_modulus", "relaxed modulus $E_0$"),
    ("_by_stiffening_ratio", r"stiffening ratio $\beta$"),
    ("_by_time", r"times $\tau$"),
];

/// What governs the friction, by the number in its column.
const REGIMES: [(f64, Marker, &str); 3] = [
    (1.0, Marker::Circle, r"edges: $\mu\approx\mu_a$"),
    (0.0, Marker::OpenCircle, "neither"),
    (-1.0, Marker::Square, r"bulk: $\mu_a\leq 0.1\mu$"),
];

impl SlidingPlan {
    fn adhesive_families<'a>(&self, scene: &Scene, rows: &'a [Row]) -> Vec<Family<'a>> {
        let word = SlidingContact::Adhesive.word();
        families(scene, rows, &[Kind { word, name: word, line: Line::Solid }])
    }

    pub(super) fn extra_drawings(&self, scene: &Scene, rows: &[Row], against: &str, outputs: [(&str, &str); 2]) -> Vec<(String, Figure)> {
        let Some(sweep) = scene.sweeps.last() else { return Vec::new() };
        let families = self.adhesive_families(scene, rows);
        let mut figures = Vec::new();
        if self.asks(SlidingColumns::FrictionParts) {
            figures.push((format!("edge_share_against_{against}"), self.share_figure(&families, self.axis_of_sweep(sweep))));
            if let [.., outer, inner] = scene.sweeps.as_slice() {
                figures.push(("regimes".to_owned(), self.regime_map(rows, scene.sweeps.len() - 2, outer, inner)));
            }
        }
        if self.asks(SlidingColumns::Sensitivities)
            && let Some(family) = families.first()
        {
            // Of several curves the first: five parameters are enough for one figure.
            for (output, symbol) in outputs {
                if let Some(drawn) = self.sensitivity_figure(output, symbol, family, self.axis_of_sweep(sweep)) {
                    figures.push((format!("sensitivity_of_{output}_against_{against}"), drawn));
                }
            }
        }
        figures
    }

    /// A figure with the elastic reference contact of each adhesive curve, dashed, if it is asked for.
    pub(super) fn beside_reference(&self, mut drawn: Figure, families: &[Family<'_>], name: &str, sign: f64) -> Figure {
        let column = place_of(&self.sliding, name);
        let word = SlidingContact::Adhesive.word();
        for (index, family) in families.iter().filter(|family| family.kind.word == word).enumerate() {
            let points = family.points(innermost, |row| sign * value(row, column));
            if points.iter().any(|(_, value)| value.is_finite()) {
                let label = if index == 0 { r"elastic, of modulus $|E(\omega)|$" } else { "" };
                drawn = drawn.with_curve(Curve::new(label, points).with_line(Line::Dashed).with(family.shade));
            }
        }
        drawn
    }

    /// μ_a/μ, with the two shares at which one dissipation governs.
    fn share_figure(&self, families: &[Family<'_>], horizontal: Axis) -> Figure {
        let column = place_of(&self.sliding, "edge_share");
        let share = Axis::linear(r"share of the edges $\mu_a/\mu$");
        let mut drawn = figure(families, (horizontal, share), innermost, column);
        let places = || families.iter().flat_map(|family| family.rows.iter().map(|row| innermost(row)));
        if let (Some(first), Some(last)) = (places().reduce(f64::min), places().reduce(f64::max)) {
            for (height, label) in [(0.9, "limits of the regimes"), (0.1, "")] {
                let points = vec![(first, height), (last, height)];
                drawn = drawn.with_curve(Curve::new(label, points).with_line(Line::Dotted).with_colour(families.len()));
            }
        }
        drawn
    }

    /// Which dissipation governs, over the two inner sweeps.
    fn regime_map(&self, rows: &[Row], place: usize, outer: &Sweep, inner: &Sweep) -> Figure {
        let column = place_of(&self.sliding, "regime");
        let at = |row: &Row, place: usize| row.swept.get(place).copied().unwrap_or(f64::NAN);
        let mut drawn = Figure::new(self.axis_of_sweep(inner), self.axis_of_sweep(outer));
        for (colour, (number, marker, name)) in REGIMES.into_iter().enumerate() {
            let points: Vec<(f64, f64)> = rows
                .iter()
                .filter(|row| row.value(column).is_some_and(|regime| (regime - number).abs() < 0.5))
                .map(|row| (at(row, place + 1), at(row, place)))
                .collect();
            if !points.is_empty() {
                drawn = drawn.with_curve(Curve::new(name, points).with_line(Line::None).with_marker(marker).with_colour(colour));
            }
        }
        let full: Vec<(f64, f64)> =
            rows.iter().filter(|row| row.label(1) == "full").map(|row| (at(row, place + 1), at(row, place))).collect();
        if !full.is_empty() {
            drawn = drawn.with_curve(Curve::new("full contact", full).with_line(Line::None).with_marker(Marker::Diamond).with_colour(3));
        }
        drawn
    }

    fn sensitivity_figure(&self, output: &str, symbol: &str, family: &Family<'_>, horizontal: Axis) -> Option<Figure> {
        let mut drawn = Figure::new(horizontal, Axis::linear(format!(r"sensitivity $\partial\ln {symbol}/\partial\ln$ parameter")));
        let mut any = false;
        for (colour, (suffix, label)) in PARAMETERS.into_iter().enumerate() {
            let column = place_of(&self.sliding, &format!("{output}{suffix}"));
            let points = family.points(innermost, |row| value(row, column));
            if points.iter().any(|(_, sensitivity)| sensitivity.is_finite()) {
                any = true;
                drawn = drawn.with_curve(Curve::new(label, points).with_colour(colour));
            }
        }
        any.then_some(drawn)
    }
}
