//! What a plan says and draws of the scan that its shape was made of.

use super::IndentationPlan;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::outcome::{Assessment, Validity};
use crate::plan::curves::thinned;
use crate::plan::measured::note;
use crate::scene::typed::{IndentationShape, MeasuredShape, Units};
use viscotack::indentation::scan::{Apex, ScannedShape};

/// A residual above this share of the height is a caution.
const LARGE: f64 = 0.02;
/// Points of the scan beside its shape, and in the figure of what is left.
const BESIDE: usize = 60;
const LEFT: usize = 800;

impl IndentationPlan {
    fn measured_shape(&self) -> Option<&MeasuredShape> {
        match &self.indentation.shape {
            IndentationShape::Table { measured, .. } => Some(measured),
            _ => None,
        }
    }

    /// How well the scan fits a round shape, and what was chosen when it was read.
    pub(super) fn of_the_scan(&self) -> Vec<Validity> {
        let Some(measured) = self.measured_shape() else { return Vec::new() };
        let mut entries: Vec<Validity> = measured.notes.iter().map(|text| note("shape", text)).collect();
        if let Some(scan) = &measured.scan {
            let share = scan.residual / scan.height();
            entries.push(Validity {
                name: "scan against its shape, over the height".into(),
                value: Some(share),
                assessment: if share <= LARGE { Assessment::Good } else { Assessment::Caution },
                meaning: self.statement(measured, scan),
            });
        }
        entries
    }

    fn statement(&self, measured: &MeasuredShape, scan: &ScannedShape) -> String {
        let unit = if self.units == Units::Si { " m" } else { "" };
        let across = if scan.map { format!(", y = {:.4e}{unit}", scan.centre[1]) } else { String::new() };
        let apex = match scan.apex {
            Apex::Lowest => "lowest",
            Apex::Highest => "highest",
        };
        let tilt = match scan.tilt {
            [0.0, 0.0] => "no tilt is seen".to_owned(),
            [along, across] if scan.map => format!("a tilt of {along:.2e} and {across:.2e} is taken out"),
            [along, _] => format!("a tilt of {along:.2e} is taken out"),
        };
        format!(
            "{:?}: {} of {} points averaged to {} radii up to {:.3e}{unit}; the apex is the {apex} point, at x = {:.4e}{unit}{across}; {tilt}; residual {:.2e}{unit} (root mean square), {:.2e}{unit} (largest)",
            measured.file,
            scan.used,
            scan.levelled.len(),
            scan.points.len(),
            scan.reach(),
            scan.centre[0],
            scan.residual,
            scan.largest_residual,
        )
    }

    /// The levelled scan with its shape, and what is left of it.
    pub(super) fn scan_figures(&self) -> Vec<(String, Figure)> {
        let Some(scan) = self.measured_shape().and_then(|measured| measured.scan.as_ref()) else { return Vec::new() };
        let Some(shape) = self.tabulated() else { return Vec::new() };
        let reach = scan.reach();
        let line: Vec<(f64, f64)> =
            (0..=400).map(|place| reach * (f64::from(place) / 200.0 - 1.0)).map(|r| (r, shape.height(r.abs()))).collect();
        let left: Vec<(f64, f64)> = thinned(scan.levelled.clone(), LEFT)
            .into_iter()
            .filter(|(r, _)| r.abs() <= reach)
            .map(|(r, h)| (r, h - shape.height(r.abs())))
            .collect();
        let radius = || Axis::linear(self.label("distance from the apex", "$r$", " (m)", "$r/R$"));
        let marks =
            |label: &str, points: Vec<(f64, f64)>| Curve::new(label, points).with_line(Line::None).with_marker(Marker::Plus).with_colour(1);
        let height = Axis::linear(self.label("height", "$z$", " (m)", "$z/R$"));
        let residual = Axis::linear(self.label("scan minus shape", r"$z - z(r)$", " (m)", "$(z - z(r))/R$"));
        vec![
            (
                "shape_against_scan".to_owned(),
                Figure::new(radius(), height)
                    .with_curve(marks("scan, levelled", thinned(scan.levelled.clone(), BESIDE)))
                    .with_curve(Curve::new("shape", line).with_line(Line::Solid).with_colour(0)),
            ),
            ("scan_residual".to_owned(), Figure::new(radius(), residual).with_curve(marks("", left))),
        ]
    }
}
