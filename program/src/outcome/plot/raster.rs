//! Pixels: the marks of a page are drawn with tiny-skia and written as a PNG image.

use std::collections::HashMap;

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};
use ttf_parser::OutlineBuilder;

use super::{
    PlotError,
    canvas::{Mark, Page, Point, UNITS, Writing},
    label,
    style::{self, Rgb},
    typeface,
};

/// The resolution.
const DOTS_PER_INCH: f64 = 400.0;
const PIXELS_PER_POINT: f64 = DOTS_PER_INCH / 72.0;

/// The page as a PNG image.
pub(super) fn png(page: &Page) -> Result<Vec<u8>, PlotError> {
    let too_large = || not_written("the image is too large");
    let mut sheet = Pixmap::new(pixels(page.width), pixels(page.height)).ok_or_else(too_large)?;
    sheet.fill(Color::WHITE);
    for mark in &page.marks {
        match mark {
            Mark::GroupOpens(_) | Mark::GroupCloses => {}
            Mark::Line { points, closed, colour, width, dashes } => {
                if let Some(path) = path(points, *closed) {
                    sheet.stroke_path(&path, &paint(*colour), &stroke(*width, dashes), Transform::identity(), None);
                }
            }
            Mark::Area { corners, colour } => {
                if let Some(path) = path(corners, true) {
                    sheet.fill_path(&path, &paint(*colour), FillRule::Winding, Transform::identity(), None);
                }
            }
            Mark::Text(writing) => {
                if let Some(path) = outlines(writing) {
                    let (x, y) = (pixel(writing.at.0), pixel(writing.at.1));
                    let turn = if writing.upwards { Transform::from_rotate_at(-90.0, x, y) } else { Transform::identity() };
                    sheet.fill_path(&path, &paint(style::INK), FillRule::Winding, turn, None);
                }
            }
        }
    }
    encoded(&sheet)
}

/// The pixels along a side of the page; one that the page fills by more than two thirds counts.
fn pixels(side: f64) -> u32 {
    let thirds = ((side * UNITS).round() / UNITS * PIXELS_PER_POINT * 3.0 - 1e-6).ceil();
    (thirds / 3.0).floor().max(1.0) as u32
}

fn pixel(points: f64) -> f32 {
    (points * PIXELS_PER_POINT) as f32
}

fn paint((red, green, blue): Rgb) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, u8::MAX);
    paint
}

/// A pen with round ends; the strokes of a dashed line are shortened by them, and a dot keeps a hair of length, which makes it a disc.
fn stroke(width: f64, dashes: &[f64]) -> Stroke {
    let shortened =
        dashes.iter().enumerate().map(|(index, length)| if index % 2 == 0 { (length - width).max(0.02) } else { length + width });
    Stroke {
        width: pixel(width),
        line_cap: LineCap::Round,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(shortened.map(pixel).collect(), 0.0),
        ..Stroke::default()
    }
}

fn path(points: &[Point], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (index, (x, y)) in points.iter().enumerate() {
        if index == 0 {
            path.move_to(pixel(*x), pixel(*y));
        } else {
            path.line_to(pixel(*x), pixel(*y));
        }
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// The outlines of all characters of a line of text, not yet turned.
fn outlines(writing: &Writing) -> Option<Path> {
    let mut pen = Pen { path: PathBuilder::new(), origin: (0.0, 0.0), scale: 1.0 };
    let mut left = writing.left();
    for run in &writing.runs {
        let size = writing.size * run.size;
        for glyph in typeface::glyphs(&run.text, run.slanted) {
            let baseline = writing.at.1 - run.rise * writing.size;
            pen.origin = (pixel(left + glyph.right * size), pixel(baseline - glyph.up * size));
            pen.scale = pixel(glyph.scale() * size);
            glyph.outline(&mut pen);
        }
        left += label::run_width(run, writing.size);
    }
    pen.path.finish()
}

/// Puts outlines of the font, whose heights are counted upwards, on the sheet.
struct Pen {
    path: PathBuilder,
    origin: (f32, f32),
    scale: f32,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.origin.0 + self.scale * x, self.origin.1 - self.scale * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

/// The image with its resolution, without row filters, which make drawings of flat colours larger. Means over twelve
/// pictures of `examples/plot_gallery.rs` on a shared core:
///
/// | colours, level | time | size |
/// |---|---|---|
/// | indexed (nine of the twelve), 1 / 4 / 6 | 5 / 8 / 13 ms | 37 / 23 / 22 kB |
/// | red, green and blue, 1 / 4 / 6 | 9 / 23 / 31 ms | 114 / 64 / 61 kB |
/// | red, green and blue, the default of the library | 54 ms | 74 kB |
fn encoded(sheet: &Pixmap) -> Result<Vec<u8>, PlotError> {
    let mut image = Vec::new();
    let mut encoder = png::Encoder::new(&mut image, sheet.width(), sheet.height());
    let bytes = if let Some((palette, indices)) = indexed(sheet) {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette);
        indices
    } else {
        encoder.set_color(png::ColorType::Rgb);
        colours(sheet).flatten().collect()
    };
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(4));
    let per_metre = (DOTS_PER_INCH / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter }));
    let mut writer = encoder.write_header().map_err(not_written)?;
    writer.write_image_data(&bytes).map_err(not_written)?;
    writer.finish().map_err(not_written)?;
    Ok(image)
}

/// Red, green and blue of every pixel; all are opaque.
fn colours(sheet: &Pixmap) -> impl Iterator<Item = [u8; 3]> {
    sheet.data().chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]])
}

/// The colours in the order of their appearance, and for every pixel the place of its colour; `None` if there are more colours than a byte counts.
fn indexed(sheet: &Pixmap) -> Option<(Vec<u8>, Vec<u8>)> {
    let mut places: HashMap<[u8; 3], u8> = HashMap::new();
    let (mut palette, mut indices) = (Vec::new(), Vec::with_capacity(sheet.data().len() / 4));
    let mut last = None;
    for colour in colours(sheet) {
        let place = match last {
            Some((known, place)) if known == colour => place,
            _ => match places.get(&colour) {
                Some(place) => *place,
                None => {
                    let place = u8::try_from(places.len()).ok()?;
                    places.insert(colour, place);
                    palette.extend(colour);
                    place
                }
            },
        };
        last = Some((colour, place));
        indices.push(place);
    }
    Some((palette, indices))
}

fn not_written(reason: impl std::fmt::Display) -> PlotError {
    PlotError::NotWritten { detail: reason.to_string() }
}
