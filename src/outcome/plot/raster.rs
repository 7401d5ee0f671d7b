//! Pixels: the picture is drawn three times too large and reduced, which smooths what kuva's pixel writer leaves ragged.
//!
//! kuva 0.6 measures how much of a pixel a stroke covers along the row only, and paints the joints of finely sampled lines twice: nearly level curves have
//! steps. Nine pixels averaged into one have none.

use std::io::Cursor;

use super::{PlotError, canvas};

/// The resolution of the finished image.
const DOTS_PER_INCH: f64 = 400.0;
/// Drawn pixels per finished pixel, along each side.
const OVERSAMPLING: usize = 3;
/// Drawn pixels per unit of the scene.
pub(super) const PIXELS_PER_UNIT: f64 = DOTS_PER_INCH / 72.0 / canvas::UNITS * OVERSAMPLING as f64;

/// An image in red, green and blue.
pub(super) struct Pixels {
    width: usize,
    height: usize,
    bytes: Vec<u8>,
}

impl Pixels {
    /// Reads the image kuva wrote.
    pub(super) fn from_png(encoded: &[u8]) -> Result<Self, PlotError> {
        let mut reader = png::Decoder::new(Cursor::new(encoded)).read_info().map_err(not_written)?;
        let size = reader.output_buffer_size().ok_or_else(|| not_written("the image is too large"))?;
        let mut bytes = vec![0; size];
        let info = reader.next_frame(&mut bytes).map_err(not_written)?;
        let channels = info.color_type.samples();
        if channels < 3 || info.bit_depth != png::BitDepth::Eight {
            return Err(not_written("the image is not in colour"));
        }
        let bytes = bytes[..info.buffer_size()].chunks_exact(channels).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        Ok(Self { width: info.width as usize, height: info.height as usize, bytes })
    }

    /// Lays a strip, turned to read upwards, on the image; the pixel `anchor` of the strip comes to lie on `at`.
    pub(super) fn darken_turned(&mut self, strip: &Self, anchor: (i64, i64), at: (i64, i64)) {
        for (row, line) in (0_i64..).zip(strip.bytes.chunks_exact(3 * strip.width.max(1))) {
            for (column, pixel) in (0_i64..).zip(line.chunks_exact(3)) {
                let (x, y) = (at.0 + row - anchor.1, at.1 - (column - anchor.0));
                let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) else { continue };
                if x < self.width && y < self.height {
                    let place = 3 * (y * self.width + x);
                    for (below, above) in self.bytes[place..place + 3].iter_mut().zip(pixel) {
                        *below = (*below).min(*above);
                    }
                }
            }
        }
    }

    /// The image at its finished size.
    pub(super) fn reduced(&self) -> Self {
        let (width, height) = ((self.width / OVERSAMPLING).max(1), (self.height / OVERSAMPLING).max(1));
        let mut bytes = Vec::with_capacity(3 * width * height);
        let mut sums = vec![0_u32; 3 * width];
        for y in 0..height {
            sums.fill(0);
            let mut count = 0;
            for row in (y * OVERSAMPLING..(y + 1) * OVERSAMPLING).filter(|row| *row < self.height) {
                count += 1;
                let line = &self.bytes[3 * row * self.width..3 * (row + 1) * self.width];
                for (sum, block) in sums.chunks_exact_mut(3).zip(line.chunks_exact(3 * OVERSAMPLING)) {
                    for pixel in block.chunks_exact(3) {
                        for (channel, value) in sum.iter_mut().zip(pixel) {
                            *channel += u32::from(*value);
                        }
                    }
                }
            }
            let parts = (count * OVERSAMPLING as u32).max(1);
            bytes.extend(sums.iter().map(|sum| u8::try_from((sum + parts / 2) / parts).unwrap_or(u8::MAX)));
        }
        Self { width, height, bytes }
    }

    /// Writes the image, with its resolution.
    pub(super) fn into_png(self) -> Result<Vec<u8>, PlotError> {
        let side = |length: usize| u32::try_from(length).map_err(not_written);
        let mut encoded = Vec::new();
        let mut encoder = png::Encoder::new(&mut encoded, side(self.width)?, side(self.height)?);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let per_metre = (DOTS_PER_INCH / 0.0254).round() as u32;
        encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter }));
        let mut writer = encoder.write_header().map_err(not_written)?;
        writer.write_image_data(&self.bytes).map_err(not_written)?;
        writer.finish().map_err(not_written)?;
        Ok(encoded)
    }
}

fn not_written(reason: impl std::fmt::Display) -> PlotError {
    PlotError::NotWritten { detail: reason.to_string() }
}
