//! Panels as files: a table of the curves, and a plot.

use super::curve::{Curve, Point};
use super::manifest::{AxisEntry, Corner};
use super::report::{PanelReport, Report};
use super::run::FiguresError;
use std::collections::BTreeMap;
use viscotack_program::outcome::csv_table::{self, Cell};
use viscotack_program::outcome::owned::{OwnedFolder, digest};
use viscotack_program::outcome::plot::{self, Axis, Figure, Inset, LegendPlace, Line, Marker, PlotError};

/// Writes `ID.csv` and `ID.svg` of every panel; gives the digest of each table by the panel's name.
pub(super) fn write(report: &Report, out: &mut OwnedFolder) -> Result<BTreeMap<String, String>, FiguresError> {
    let mut digests = BTreeMap::new();
    for panel in report.figures.iter().flat_map(|figure| &figure.panels) {
        let table = table(panel)?;
        out.replace(&format!("{}.csv", panel.id), &table)?;
        digests.insert(panel.id.clone(), digest(&table));
        match plot::svg(&figure(panel)) {
            Ok(text) => out.replace(&format!("{}.svg", panel.id), text.as_bytes())?,
            // A build without plots still writes the tables.
            Err(PlotError::NotBuilt) => {}
            Err(error) => return Err(FiguresError::Plot { panel: panel.id.clone(), error }),
        }
    }
    Ok(digests)
}

/// The curves of a panel, one point a row.
fn table(panel: &PanelReport) -> Result<Vec<u8>, csv::Error> {
    let headed = |axis: &AxisEntry| format!("{} [{}]", plain(&axis.label), axis.unit);
    let errors = |axis: &AxisEntry| format!("{}_error [{}]", plain(&axis.label), axis.unit);
    let (x, y) = (&panel.entry.x, &panel.entry.y);
    let header = ["curve".to_owned(), headed(x), errors(x), headed(y), errors(y)];
    let mut rows = Vec::new();
    for curve in panel.curves.iter() {
        let number = |value: f64| Cell::Number(value.is_finite().then_some(value));
        for point in &curve.points {
            rows.push(vec![Cell::Word(curve.name.clone()), number(point.x), number(point.x_error), number(point.y), number(point.y_error)]);
        }
    }
    csv_table::records(&header, &rows)
}

/// A label without its mathematics.
fn plain(label: &str) -> String {
    label.replace(['$', '\\', '{', '}'], "")
}

/// The plot of a panel.
fn figure(panel: &PanelReport) -> Figure {
    let entry = &panel.entry;
    let mut figure = Figure::new(axis(&entry.x), axis(&entry.y));
    figure.curves = drawn(&panel.curves);
    figure.legend = entry.legend.map_or(LegendPlace::Auto, place);
    figure.inset = entry.inset.as_ref().map(|inset| {
        let curves = drawn(&panel.inset).into_iter().map(|curve| plot::Curve { label: String::new(), ..curve }).collect();
        Box::new(Inset { horizontal: axis(&inset.x), vertical: axis(&inset.y), curves, place: place(inset.place) })
    });
    figure
}

fn place(corner: Corner) -> LegendPlace {
    match corner {
        Corner::TopLeft => LegendPlace::TopLeft,
        Corner::TopRight => LegendPlace::TopRight,
        Corner::BottomLeft => LegendPlace::BottomLeft,
        Corner::BottomRight => LegendPlace::BottomRight,
        Corner::Below => LegendPlace::Below,
    }
}

fn axis(entry: &AxisEntry) -> Axis {
    let axis = if entry.log { Axis::logarithmic(entry.label.clone()) } else { Axis::linear(entry.label.clone()) };
    match entry.range {
        Some([low, high]) => axis.with_range(low, high),
        None => axis,
    }
}

/// Curves as they are drawn: in pieces where they are stable and where not; only the first piece is in the legend.
fn drawn(curves: &[Curve]) -> Vec<plot::Curve> {
    let mut all = Vec::new();
    for curve in curves.iter().filter(|curve| !curve.hidden) {
        let mut label = curve.label.clone();
        for (solid, points) in pieces(&curve.points) {
            let line = match (curve.marked, curve.dotted, curve.dashed || !solid) {
                (true, ..) => Line::None,
                (_, true, _) => Line::Dotted,
                (_, _, true) => Line::Dashed,
                _ => Line::Solid,
            };
            // A dashed first piece does not stand for the curve where a solid one follows.
            let solid_follows = !solid && curve.points.iter().any(|point| point.solid);
            let own = if solid_follows { None } else { label.take() };
            let mut piece = plot::Curve::new(own.unwrap_or_default(), points).with_line(line).with_colour(curve.colour);
            if curve.marked {
                piece = piece.with_marker(Marker::Circle);
            }
            all.push(piece);
        }
    }
    all
}

/// Segments of one kind; neighbours share the point between them.
fn pieces(points: &[Point]) -> Vec<(bool, Vec<(f64, f64)>)> {
    let mut pieces: Vec<(bool, Vec<(f64, f64)>)> = Vec::new();
    for point in points {
        let at = (point.x, point.y);
        match pieces.last_mut() {
            Some((solid, piece)) if *solid == point.solid => piece.push(at),
            Some((_, piece)) => {
                let shared = piece.last().copied();
                pieces.push((point.solid, shared.into_iter().chain([at]).collect()));
            }
            None => pieces.push((point.solid, vec![at])),
        }
    }
    pieces
}
