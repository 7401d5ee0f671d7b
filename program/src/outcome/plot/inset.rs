//! A smaller picture in a corner of the frame.

use super::{
    PlotError,
    canvas::{Area, Canvas, Point},
    figure::{Figure, Inset, LegendPlace},
    render::{Measured, TICK_GAP, draw_curves, draw_frame, draw_labels, draw_ticks, intervals, trace},
    style,
    ticks::Direction,
};

/// Its frame over that of the figure, across and down.
const SHARE: (f64, f64) = (0.36, 0.36);
/// From the frame of the figure to its outermost mark.
const CLEARANCE: f64 = 6.0;

/// Draws it and returns its outline with ticks and labels, which the legend keeps clear of.
pub(super) fn draw(canvas: &mut Canvas, inset: &Inset, frame: Area) -> Result<Vec<Point>, PlotError> {
    let figure = Figure { curves: inset.curves.clone(), ..Figure::new(inset.horizontal.clone(), inset.vertical.clone()) };
    let (across, up) = intervals(&figure)?;
    let (width, height) = (SHARE.0 * (frame.right - frame.left), SHARE.1 * (frame.bottom - frame.top));
    let horizontal = Measured::new(&inset.horizontal, across, width, Direction::Horizontal);
    let vertical = Measured::new(&inset.vertical, up, height, Direction::Vertical);
    let beside = vertical.beside();
    let above = if vertical.has_note() { 1.4 * style::TICK_SIZE } else { 0.5 * style::TICK_SIZE };
    let below = TICK_GAP + style::TICK_SIZE + horizontal.label_depth();
    let to_the_right = matches!(inset.place, LegendPlace::TopLeft | LegendPlace::BottomLeft);
    let left = if to_the_right { frame.left + CLEARANCE + beside } else { frame.right - CLEARANCE - horizontal.overhang(width) - width };
    let low = matches!(inset.place, LegendPlace::BottomLeft | LegendPlace::BottomRight);
    let top = if low { frame.bottom - CLEARANCE - below - height } else { frame.top + CLEARANCE + above };
    let own = Area { left, top, right: left + width, bottom: top + height };
    canvas.open_group("inset");
    draw_frame(canvas, own);
    draw_ticks(canvas, own, (&horizontal, &vertical), true);
    draw_labels(canvas, own, (&horizontal, &vertical), left - beside);
    if let (Some(across), Some(up)) = (across, up) {
        let traces: Vec<_> = figure.curves.iter().map(|curve| trace(curve, across, up, own)).collect();
        draw_curves(canvas, &figure, &traces);
    }
    canvas.close_group();
    let (left, bottom) = (left - beside, own.bottom + below);
    Ok(vec![(left, top - above), (own.right, top - above), (own.right, bottom), (left, bottom), (left, top - above), (own.right, bottom)])
}
