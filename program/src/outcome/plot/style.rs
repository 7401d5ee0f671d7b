//! The look: sizes on paper, colours, dashes. Lengths are in points (1/72 inch).

use super::figure::{Colour, Line, Width};

/// Points in a millimetre.
pub(super) const POINTS_PER_MILLIMETRE: f64 = 72.0 / 25.4;
/// Text of the axis labels and the title.
pub(super) const LABEL_SIZE: f64 = 8.0;
/// Text at the ticks.
pub(super) const TICK_SIZE: f64 = 7.0;
/// Text of the legend.
pub(super) const LEGEND_SIZE: f64 = 6.8;
/// Stroke of a curve.
pub(super) const CURVE_WIDTH: f64 = 1.2;
/// Stroke of the frame and of the long ticks.
pub(super) const FRAME_WIDTH: f64 = 0.6;
/// Stroke of the short ticks.
pub(super) const MINOR_WIDTH: f64 = 0.4;
/// Length of a tick with a label, inwards.
pub(super) const MAJOR_LENGTH: f64 = 3.6;
/// Length of a tick without a label, inwards.
pub(super) const MINOR_LENGTH: f64 = 2.0;
/// Half the size of a marker.
pub(super) const MARKER_RADIUS: f64 = 2.0;
/// Stroke of an open marker.
pub(super) const MARKER_STROKE: f64 = 0.8;
/// Between two sparse markers along a curve.
pub(super) const SPARSE_DISTANCE: f64 = 34.0;
/// White rim of the page.
pub(super) const PAGE_MARGIN: f64 = 3.0;
/// Baseline to baseline, in text sizes.
pub(super) const LEADING: f64 = 1.3;

/// The typefaces an SVG viewer is asked for; widths are reserved for the widest, DejaVu Sans, which is also the one of the PNG.
pub(super) const FONT_FAMILY: &str = "Arial, Helvetica, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// A colour in sRGB.
pub(super) type Rgb = (u8, u8, u8);

/// Text, frame, ticks.
pub(super) const INK: Rgb = (0, 0, 0);
/// The paper.
pub(super) const PAPER: Rgb = (255, 255, 255);

/// Okabe and Ito, "Color Universal Design" (2008), without their yellow, which white paper swallows; neighbours differ in lightness.
pub(super) const PALETTE: [Rgb; 7] =
    [(0, 114, 178), (230, 159, 0), (0, 0, 0), (0, 158, 115), (213, 94, 0), (86, 180, 233), (204, 121, 167)];

/// The order in which [`Line::Automatic`] goes through the strokes.
const STROKES: [Line; 6] = [Line::Solid, Line::LongDashed, Line::DashDotted, Line::Dashed, Line::DashDoubleDotted, Line::Dotted];

/// Width of the page and height of the frame.
pub(super) fn page(width: Width) -> (f64, f64) {
    match width {
        Width::OneColumn => (88.0 * POINTS_PER_MILLIMETRE, 150.0),
        Width::TwoColumns => (180.0 * POINTS_PER_MILLIMETRE, 245.0),
    }
}

/// The colour of the curve at this place of the figure.
pub(super) fn colour(choice: Colour, place: usize) -> Rgb {
    let index = match choice {
        Colour::Automatic => place,
        Colour::Index(index) => index,
        Colour::Sequence { place, of } => {
            let part = place as f64 / of.saturating_sub(1).max(1) as f64;
            return sequential(DARKEST_CURVE + (LIGHTEST_CURVE - DARKEST_CURVE) * part.min(1.0));
        }
    };
    PALETTE[index % PALETTE.len()]
}

/// The part of [`sequential`] that curves take: its light end is lost on white paper.
const DARKEST_CURVE: f64 = 0.0;
const LIGHTEST_CURVE: f64 = 0.8;

/// Viridis of Smith and van der Walt (2015), sixteen even steps of it: perceptually uniform, from dark to light.
const VIRIDIS: [Rgb; 16] = [
    (68, 1, 84),
    (72, 26, 108),
    (71, 47, 125),
    (65, 68, 135),
    (57, 86, 140),
    (49, 104, 142),
    (42, 120, 142),
    (35, 136, 142),
    (31, 152, 139),
    (34, 168, 132),
    (53, 183, 121),
    (84, 197, 104),
    (122, 209, 81),
    (165, 219, 54),
    (210, 226, 27),
    (253, 231, 37),
];

/// The colour of a part, 0 dark to 1 light.
pub(super) fn sequential(part: f64) -> Rgb {
    let place = part.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = (place as usize).min(VIRIDIS.len() - 2);
    let share = place - below as f64;
    let ((r0, g0, b0), (r1, g1, b1)) = (VIRIDIS[below], VIRIDIS[below + 1]);
    let mix = |from: u8, to: u8| (f64::from(from) + (f64::from(to) - f64::from(from)) * share).round() as u8;
    (mix(r0, r1), mix(g0, g1), mix(b0, b1))
}

/// A colour of which little is left on the paper.
pub(super) fn pale((red, green, blue): Rgb) -> Rgb {
    let mix = |colour: u8, paper: u8| (0.22 * f64::from(colour) + 0.78 * f64::from(paper)).round() as u8;
    (mix(red, PAPER.0), mix(green, PAPER.1), mix(blue, PAPER.2))
}

/// Lengths of stroke and gap in turn, in points; empty for a full line, `None` for no line.
pub(super) fn dashes(line: Line, place: usize) -> Option<&'static [f64]> {
    match line {
        Line::Automatic => dashes(STROKES[place % STROKES.len()], place),
        Line::Solid => Some(&[]),
        Line::Dashed => Some(&[4.4, 2.2]),
        Line::Dotted => Some(&[1.2, 1.9]),
        Line::DashDotted => Some(&[6.4, 1.9, 1.2, 1.9]),
        Line::LongDashed => Some(&[9.6, 2.6]),
        Line::DashDoubleDotted => Some(&[6.4, 1.8, 1.2, 1.8, 1.2, 1.8]),
        Line::None => None,
    }
}
