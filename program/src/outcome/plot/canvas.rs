//! The canvas: lines, signs and text in points, in the order in which they are drawn, for vectors and pixels alike.

use super::{
    figure::Marker,
    label::{self, Run},
    style::{self, Rgb},
};

/// Positions of text and sizes of pages are whole units: so many of them are a point.
pub(super) const UNITS: f64 = 10.0;

/// Where a text stands relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A point of the page, in points from its upper left corner.
pub(super) type Point = (f64, f64);

/// A rectangle of the page.
#[derive(Debug, Clone, Copy)]
pub(super) struct Area {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

/// A line of text.
pub(super) struct Writing {
    pub(super) runs: Vec<Run>,
    /// On the baseline.
    pub(super) at: Point,
    pub(super) size: f64,
    pub(super) anchor: Anchor,
    /// Reads upwards, turned about `at`.
    pub(super) upwards: bool,
}

impl Writing {
    /// Where it begins if it is level.
    pub(super) fn left(&self) -> f64 {
        match self.anchor {
            Anchor::Start => self.at.0,
            Anchor::Middle => self.at.0 - 0.5 * label::width(&self.runs, self.size),
            Anchor::End => self.at.0 - label::width(&self.runs, self.size),
        }
    }
}

/// One thing drawn.
pub(super) enum Mark {
    /// What follows belongs to a group of this class.
    GroupOpens(&'static str),
    /// The group opened last ends.
    GroupCloses,
    /// A line through points.
    Line { points: Vec<Point>, closed: bool, colour: Rgb, width: f64, dashes: Vec<f64> },
    /// A filled polygon.
    Area { corners: Vec<Point>, colour: Rgb },
    /// A line of text.
    Text(Writing),
}

/// A finished page; sizes in points.
pub(super) struct Page {
    pub(super) marks: Vec<Mark>,
    pub(super) width: f64,
    pub(super) height: f64,
}

/// A page in the making.
#[derive(Default)]
pub(super) struct Canvas {
    marks: Vec<Mark>,
}

impl Canvas {
    /// Opens a group, of one class.
    pub(super) fn open_group(&mut self, class: &'static str) {
        self.marks.push(Mark::GroupOpens(class));
    }

    /// Closes the group opened last.
    pub(super) fn close_group(&mut self) {
        self.marks.push(Mark::GroupCloses);
    }

    /// Strokes a line through the points; `dashes` are lengths of stroke and gap in turn.
    pub(super) fn stroke(&mut self, points: &[Point], colour: Rgb, width: f64, dashes: &[f64]) {
        self.marks.push(Mark::Line { points: points.to_vec(), closed: false, colour, width, dashes: dashes.to_vec() });
    }

    /// Draws a marker.
    pub(super) fn marker(&mut self, marker: Marker, at: Point, colour: Rgb) {
        let radius = style::MARKER_RADIUS;
        let around = |corners: &[Point]| -> Vec<Point> { corners.iter().map(|(x, y)| (at.0 + radius * x, at.1 + radius * y)).collect() };
        let square = [(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)];
        let triangle = [(0.0, -1.15), (1.05, 0.72), (-1.05, 0.72)];
        let diamond = [(0.0, -1.25), (1.05, 0.0), (0.0, 1.25), (-1.05, 0.0)];
        match marker {
            Marker::None => {}
            Marker::Circle => self.dot(at, radius, colour),
            Marker::Point => self.dot(at, 0.5 * radius, colour),
            Marker::OpenCircle => self.outlined(circle(at, radius), colour),
            Marker::Square => self.filled(around(&square), colour),
            Marker::OpenSquare => self.outlined(around(&square), colour),
            Marker::Triangle => self.filled(around(&triangle), colour),
            Marker::OpenTriangle => self.outlined(around(&triangle), colour),
            Marker::Diamond => self.filled(around(&diamond), colour),
            Marker::OpenDiamond => self.outlined(around(&diamond), colour),
            Marker::Cross => {
                self.stroke(&around(&[(-0.9, -0.9), (0.9, 0.9)]), colour, 1.0, &[]);
                self.stroke(&around(&[(-0.9, 0.9), (0.9, -0.9)]), colour, 1.0, &[]);
            }
            Marker::Plus => {
                self.stroke(&around(&[(-1.2, 0.0), (1.2, 0.0)]), colour, 1.0, &[]);
                self.stroke(&around(&[(0.0, -1.2), (0.0, 1.2)]), colour, 1.0, &[]);
            }
        }
    }

    /// Draws a disc.
    pub(super) fn dot(&mut self, at: Point, radius: f64, colour: Rgb) {
        self.filled(circle(at, radius), colour);
    }

    pub(super) fn filled(&mut self, corners: Vec<Point>, colour: Rgb) {
        self.marks.push(Mark::Area { corners, colour });
    }

    fn outlined(&mut self, corners: Vec<Point>, colour: Rgb) {
        self.filled(corners.clone(), style::PAPER);
        self.marks.push(Mark::Line { points: corners, closed: true, colour, width: style::MARKER_STROKE, dashes: Vec::new() });
    }

    /// Writes a line of text; `at` is on its baseline.
    pub(super) fn text(&mut self, runs: &[Run], at: Point, size: f64, anchor: Anchor) {
        self.marks.push(Mark::Text(Writing { runs: runs.to_vec(), at, size, anchor, upwards: false }));
    }

    /// Writes a line of text that reads upwards, centred on `at`, which is on its baseline.
    pub(super) fn turned_text(&mut self, runs: &[Run], at: Point, size: f64) {
        self.marks.push(Mark::Text(Writing { runs: runs.to_vec(), at, size, anchor: Anchor::Middle, upwards: true }));
    }

    /// The page of this size in points.
    pub(super) fn into_page(self, width: f64, height: f64) -> Page {
        Page { marks: self.marks, width, height }
    }
}

/// A disc as a polygon with enough corners for print.
fn circle(centre: Point, radius: f64) -> Vec<Point> {
    const CORNERS: u32 = 24;
    (0..CORNERS)
        .map(|corner| {
            let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(CORNERS);
            (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin())
        })
        .collect()
}
