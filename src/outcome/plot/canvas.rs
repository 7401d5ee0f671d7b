//! The sheet: strokes, signs and text in points, put down with the primitives of kuva, once for vectors and once for pixels.
//!
//! What kuva 0.6 does not do well is worked round here, so that both pictures show the same:
//! its pixel writer starts a dash pattern anew at every point of a line (a finely sampled dashed curve comes out full), so dashes are cut here;
//! its text has one size and no height, so every run of a label is its own piece of text in pixels and its own `<tspan>` in SVG;
//! its SVG size is in pixels and its numbers carry rounding noise, so paths are written here and the head of the document is replaced.

use kuva::{
    backend::{raster::RasterBackend, svg::SvgBackend},
    render::{
        color::Color,
        render::{PathData, Primitive, Scene, TextAnchor, TextSpan},
    },
};

use super::{
    PlotError,
    figure::Marker,
    label::{self, Run},
    raster::{self, Pixels},
    style::{self, Rgb},
};

/// Units of the kuva scene in a point; kuva's text sizes are whole numbers of units.
pub(super) const UNITS: f64 = 10.0;
/// Marks the places where the SVG gets its runs of text; labels cannot contain these characters.
const PLACE_OPENS: char = '\u{e000}';
const PLACE_CLOSES: char = '\u{e001}';

/// SVG readers drop an ordinary space at the edge of a `<tspan>`; librsvg 2.54 drops this one as well unless the document asks it to preserve space.
const NO_BREAK_SPACE: &str = "\u{a0}";

/// What is being made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    Vector,
    Pixels,
}

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

/// A line of text that reads upwards.
struct Turned {
    at: Point,
    runs: Vec<Run>,
    size: f64,
}

/// A picture in the making.
pub(super) struct Canvas {
    target: Target,
    scene: Scene,
    places: Vec<String>,
    turned: Vec<Turned>,
}

impl Canvas {
    /// An empty sheet; its size is given when the picture is taken off.
    pub(super) fn new(target: Target) -> Self {
        Self { target, scene: Scene::new(0.0, 0.0), places: Vec::new(), turned: Vec::new() }
    }

    /// Opens a group of the SVG document, of one class.
    pub(super) fn open_group(&mut self, class: &str) {
        self.scene.add(Primitive::GroupStart { transform: None, title: None, extra_attrs: Some(format!(r#"class="{class}""#)) });
    }

    /// Closes the group opened last.
    pub(super) fn close_group(&mut self) {
        self.scene.add(Primitive::GroupEnd);
    }

    /// Strokes a line through the points.
    pub(super) fn stroke(&mut self, points: &[Point], colour: Rgb, width: f64, dashes: &[f64]) {
        match self.target {
            Target::Vector => {
                let pattern: Vec<String> = dashes.iter().map(|length| number(length * UNITS)).collect();
                let pattern = (!pattern.is_empty()).then(|| pattern.join(" "));
                self.path(path_data(points, false), None, Some((colour, width)), pattern);
            }
            Target::Pixels => {
                // kuva's pixel strokes have round ends, half a width long.
                for piece in cut_into_dashes(points, dashes, width) {
                    let points = piece.into_iter().map(|(x, y)| (x * UNITS, y * UNITS)).collect();
                    self.scene.add(Primitive::PolyLine {
                        points,
                        stroke: kuva_colour(colour),
                        stroke_width: width * UNITS,
                        stroke_dasharray: None,
                    });
                }
            }
        }
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
            Marker::OpenCircle => self.outlined(&circle(at, radius), colour),
            Marker::Square => self.filled(&around(&square), colour),
            Marker::OpenSquare => self.outlined(&around(&square), colour),
            Marker::Triangle => self.filled(&around(&triangle), colour),
            Marker::OpenTriangle => self.outlined(&around(&triangle), colour),
            Marker::Diamond => self.filled(&around(&diamond), colour),
            Marker::OpenDiamond => self.outlined(&around(&diamond), colour),
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
        self.filled(&circle(at, radius), colour);
    }

    fn filled(&mut self, corners: &[Point], colour: Rgb) {
        self.path(path_data(corners, true), Some(colour), None, None);
    }

    fn outlined(&mut self, corners: &[Point], colour: Rgb) {
        self.path(path_data(corners, true), Some(style::PAPER), None, None);
        match self.target {
            Target::Vector => self.path(path_data(corners, true), None, Some((colour, style::MARKER_STROKE)), None),
            Target::Pixels => {
                let closed: Vec<Point> = corners.iter().chain(corners.first()).copied().collect();
                self.stroke(&closed, colour, style::MARKER_STROKE, &[]);
            }
        }
    }

    fn path(&mut self, data: String, fill: Option<Rgb>, stroke: Option<(Rgb, f64)>, dashes: Option<String>) {
        let (colour, width) = stroke.map_or((Color::None, 0.0), |(colour, width)| (kuva_colour(colour), width));
        self.scene.add(Primitive::Path(Box::new(PathData {
            d: data,
            fill: fill.map(kuva_colour),
            stroke: colour,
            stroke_width: width * UNITS,
            opacity: None,
            stroke_dasharray: dashes,
        })));
    }

    /// Writes a line of text; `at` is on its baseline.
    pub(super) fn text(&mut self, runs: &[Run], at: Point, size: f64, anchor: Anchor) {
        match self.target {
            Target::Vector => self.placed_text(runs, at, size, anchor, None),
            Target::Pixels => {
                let mut left = match anchor {
                    Anchor::Start => at.0,
                    Anchor::Middle => at.0 - 0.5 * label::width(runs, size),
                    Anchor::End => at.0 - label::width(runs, size),
                };
                for run in runs {
                    let span = TextSpan { italic: run.slanted, ..TextSpan::plain(run.text.clone()) };
                    self.scene.add(Primitive::RichText {
                        x: left * UNITS,
                        y: (at.1 - run.rise * size) * UNITS,
                        spans: vec![span],
                        size: units_of_text(size * run.size),
                        anchor: TextAnchor::Start,
                        color: Some(kuva_colour(style::INK)),
                    });
                    left += label::run_width(run, size);
                }
            }
        }
    }

    /// Writes a line of text that reads upwards, centred on `at`, which is on its baseline.
    pub(super) fn turned_text(&mut self, runs: &[Run], at: Point, size: f64) {
        match self.target {
            Target::Vector => self.placed_text(runs, at, size, Anchor::Middle, Some(-90.0)),
            Target::Pixels => self.turned.push(Turned { at, runs: runs.to_vec(), size }),
        }
    }

    fn placed_text(&mut self, runs: &[Run], at: Point, size: f64, anchor: Anchor, rotate: Option<f64>) {
        let content = format!("{PLACE_OPENS}{}{PLACE_CLOSES}", self.places.len());
        self.places.push(text_spans(runs, size));
        self.scene.add(Primitive::Text {
            x: (at.0 * UNITS).round(),
            y: (at.1 * UNITS).round(),
            content,
            size: units_of_text(size),
            anchor: match anchor {
                Anchor::Start => TextAnchor::Start,
                Anchor::Middle => TextAnchor::Middle,
                Anchor::End => TextAnchor::End,
            },
            rotate,
            bold: false,
            color: None,
        });
    }

    /// Takes the picture off as an SVG document of this size in points.
    pub(super) fn into_svg(mut self, width: f64, height: f64, title: Option<&str>) -> String {
        (self.scene.width, self.scene.height) = ((width * UNITS).round(), (height * UNITS).round());
        let raw = SvgBackend::new().with_pretty(true).render_scene(&self.scene);
        let body = raw.split_once('>').map_or("", |(_, body)| body);
        let millimetres = |length: f64| number(length / style::POINTS_PER_MILLIMETRE);
        let mut document = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}mm" height="{}mm" viewBox="0 0 {} {}" font-family="{}" fill="black" stroke-linejoin="round" xml:space="preserve">"#,
            millimetres(width),
            millimetres(height),
            self.scene.width,
            self.scene.height,
            style::FONT_FAMILY,
        );
        if let Some(title) = title {
            let text: String = label::parse(title).iter().map(|run| escaped(&run.text)).collect();
            document.push_str(&format!("\n  <title>{text}</title>"));
        }
        for (index, piece) in body.split(PLACE_OPENS).enumerate() {
            let place = if index == 0 { None } else { piece.split_once(PLACE_CLOSES) };
            match place.and_then(|(number, rest)| Some((self.places.get(number.parse::<usize>().ok()?)?, rest))) {
                Some((spans, rest)) => {
                    document.push_str(spans);
                    document.push_str(rest);
                }
                None => document.push_str(piece),
            }
        }
        document
    }

    /// Takes the picture off as a PNG image of this size in points.
    pub(super) fn into_png(mut self, width: f64, height: f64) -> Result<Vec<u8>, PlotError> {
        (self.scene.width, self.scene.height) = ((width * UNITS).round(), (height * UNITS).round());
        let mut sheet = draw(&self.scene)?;
        for turned in &self.turned {
            // kuva turns text by interpolating pixels and cannot turn slanted text: here it is written level on its own strip, and the strip is turned.
            let (length, size) = (label::width(&turned.runs, turned.size), turned.size);
            let mut strip = Self::new(Target::Pixels);
            strip.text(&turned.runs, (0.5 * length + size, 2.0 * size), size, Anchor::Middle);
            (strip.scene.width, strip.scene.height) = (((length + 2.0 * size) * UNITS).ceil(), (3.0 * size * UNITS).ceil());
            let pixel = |points: f64| (points * UNITS * raster::PIXELS_PER_UNIT).round() as i64;
            let anchor = (pixel(0.5 * length + size), pixel(2.0 * size));
            sheet.darken_turned(&draw(&strip.scene)?, anchor, (pixel(turned.at.0), pixel(turned.at.1)));
        }
        sheet.reduced().into_png()
    }
}

fn draw(scene: &Scene) -> Result<Pixels, PlotError> {
    let backend = RasterBackend::new().with_scale(raster::PIXELS_PER_UNIT as f32);
    let bytes = backend.render_scene(scene).map_err(|detail| PlotError::NotWritten { detail })?;
    Pixels::from_png(&bytes)
}

fn kuva_colour((red, green, blue): Rgb) -> Color {
    Color::Rgb(red, green, blue)
}

fn units_of_text(size: f64) -> u32 {
    (size * UNITS).round().clamp(1.0, 1e4) as u32
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

/// Two decimals, without trailing zeros.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

fn path_data(points: &[Point], closed: bool) -> String {
    let mut data = String::with_capacity(16 * points.len());
    for (index, (x, y)) in points.iter().enumerate() {
        data.push_str(if index == 0 { "M " } else { " L " });
        data.push_str(&number(x * UNITS));
        data.push(' ');
        data.push_str(&number(y * UNITS));
    }
    if closed {
        data.push_str(" Z");
    }
    data
}

fn text_spans(runs: &[Run], size: f64) -> String {
    let mut height = 0.0;
    let mut spans = String::new();
    for run in runs {
        let rise = run.rise * size * UNITS;
        let step = number(height - rise);
        height = rise;
        let mut attributes = String::new();
        if step != "0" {
            attributes.push_str(&format!(r#" dy="{step}""#));
        }
        if run.size < 1.0 {
            attributes.push_str(&format!(r#" font-size="{}""#, units_of_text(size * run.size)));
        }
        if run.slanted {
            attributes.push_str(r#" font-style="italic""#);
        }
        spans.push_str(&format!("<tspan{attributes}>{}</tspan>", escaped(&run.text.replace(' ', NO_BREAK_SPACE))));
    }
    spans
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The strokes of a dashed line, along the whole line; each is shortened for its round ends of half a `width`.
fn cut_into_dashes(points: &[Point], dashes: &[f64], width: f64) -> Vec<Vec<Point>> {
    if dashes.is_empty() {
        return vec![points.to_vec()];
    }
    let mut pieces = Vec::new();
    let mut piece: Vec<Point> = Vec::new();
    // The pattern with the strokes shortened and the gaps lengthened; a dot keeps a hair of length, which makes it a disc.
    let lengths: Vec<f64> =
        dashes.iter().enumerate().map(|(index, length)| if index % 2 == 0 { (length - width).max(0.02) } else { length + width }).collect();
    let (mut turn, mut left) = (0, lengths[0]);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let at = |travelled: f64| {
            let part = travelled / length;
            (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1))
        };
        let mut travelled = 0.0;
        while length - travelled > left {
            if turn % 2 == 0 {
                if piece.is_empty() {
                    piece.push(at(travelled));
                }
                piece.push(at(travelled + left));
                pieces.push(std::mem::take(&mut piece));
            }
            travelled += left;
            turn = (turn + 1) % lengths.len();
            left = lengths[turn];
        }
        if turn % 2 == 0 && length > 0.0 {
            if piece.is_empty() {
                piece.push(at(travelled));
            }
            piece.push(to);
        }
        left -= length - travelled;
    }
    if piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}
