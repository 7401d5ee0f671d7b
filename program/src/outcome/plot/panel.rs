//! The lower frame: residuals over the horizontal axis of the curves, with a line at zero, and how large they are in words.

use super::{
    PlotError,
    canvas::{Anchor, Area, Canvas, Point},
    figure::{Axis, Curve, Figure, Line, Residuals},
    interval::{Interval, has_place},
    label,
    render::{Measured, draw_curves, draw_frame, draw_labels, draw_ticks, trace},
    style,
    ticks::Direction,
};

/// Its height over that of the frame above: a quarter of both together.
const SHARE: f64 = 1.0 / 3.0;
/// Between the two frames; a factor of the numbers needs room of its own.
const GAP: f64 = 7.0;
/// Part of its height left free above and below the points.
const ROOM: f64 = 0.12;
/// From the frame to the words.
const CLEARANCE: f64 = 6.0;
/// Below this, one less the determination is not shown by its five decimals.
const NEARLY_ONE: f64 = 5e-6;

/// The lower frame, measured.
pub(super) struct Panel<'figure> {
    residuals: &'figure Residuals,
    vertical: Measured,
    words: Vec<label::Run>,
    height: f64,
    gap: f64,
}

impl<'figure> Panel<'figure> {
    /// Of residuals below a frame of this height; none without a point that the axes can show.
    pub(super) fn new(residuals: &'figure Residuals, across: &Axis, above: f64) -> Result<Option<Self>, PlotError> {
        let height = SHARE * above;
        let words = label::parse(&words(residuals));
        let shown = |(x, y): &&Point| has_place(across.scale, *x) && has_place(residuals.vertical.scale, *y);
        let mut ends = residuals.points.iter().filter(shown).map(|point| point.1).peekable();
        if ends.peek().is_none() {
            return Ok(None);
        }
        let (least, most) = ends.fold((0.0_f64, 0.0_f64), |(least, most), value| (least.min(value), most.max(value)));
        let strip = if words.is_empty() { 0.0 } else { CLEARANCE + style::LEGEND_SIZE + style::MARKER_RADIUS };
        let interval = Interval::new(&residuals.vertical, Some((least, most)), ROOM)?.map(|interval| with_strip(interval, strip / height));
        let vertical = Measured::new(&residuals.vertical, interval, height, Direction::Vertical);
        let gap = GAP + if vertical.has_note() { style::TICK_SIZE } else { 0.0 };
        Ok(Some(Self { residuals, vertical, words, height, gap }))
    }

    /// Room to the left of its frame.
    pub(super) fn beside(&self) -> f64 {
        self.vertical.beside()
    }

    /// Draws it below a frame and returns where the page ends below it.
    pub(super) fn draw(&self, canvas: &mut Canvas, above: Area, horizontal: &Measured) -> f64 {
        let top = above.bottom + self.gap;
        let frame = Area { top, bottom: top + self.height, ..above };
        canvas.open_group("residuals");
        draw_frame(canvas, frame);
        draw_ticks(canvas, frame, (horizontal, &self.vertical), true);
        let bottom = draw_labels(canvas, frame, (horizontal, &self.vertical), style::PAGE_MARGIN);
        if let (Some(across), Some(up)) = (horizontal.interval, self.vertical.interval) {
            let Residuals { points, marker, colour, vertical, .. } = self.residuals;
            let curve = Curve::new("", points.clone()).with_line(Line::None).with_marker(*marker).with(*colour);
            let traces = [trace(&curve, across, up, frame)];
            let figure = Figure { curves: vec![curve], ..Figure::new(vertical.clone(), vertical.clone()) };
            draw_curves(canvas, &figure, &traces);
            if let Some(part) = up.fraction(0.0).filter(|part| (0.0..=1.0).contains(part)) {
                let y = frame.bottom - part * (frame.bottom - frame.top);
                canvas.stroke(&[(frame.left, y), (frame.right, y)], style::INK, style::FRAME_WIDTH, &[]);
            }
        }
        let at = (frame.right - CLEARANCE, frame.top + CLEARANCE + 0.75 * style::LEGEND_SIZE);
        canvas.text(&self.words, at, style::LEGEND_SIZE, Anchor::End);
        canvas.close_group();
        bottom
    }
}

/// Leaves a part of the height free at the top of a linear axis, where words stand.
fn with_strip(interval: Interval, part: f64) -> Interval {
    let upper = interval.upper + part / (1.0 - part) * (interval.upper - interval.lower);
    if upper.is_finite() { Interval { upper, ..interval } } else { interval }
}

/// How large the residuals are.
fn words(residuals: &Residuals) -> String {
    let unit = residuals.vertical.label.strip_suffix(')').and_then(|label| label.rsplit_once('(')).map_or("", |(_, unit)| unit);
    let root = residuals.root_mean_square.map(|root| format!("RMS {} {unit}", rounded(root)).trim_end().to_owned());
    let determination = residuals.determination.map(|part| {
        if (0.0..NEARLY_ONE).contains(&(1.0 - part)) {
            "$R^2$ > 0.99999".to_owned()
        } else if part.abs() < 10.0 {
            format!("$R^2$ = {}", format!("{part:.5}").replace('-', "−"))
        } else {
            format!("$R^2$ = {}", rounded(part))
        }
    });
    root.into_iter().chain(determination).collect::<Vec<_>>().join(",  ")
}

/// Three digits, with a power of ten where zeros would be many.
fn rounded(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.2e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let power = exponent.parse::<i32>().unwrap_or(0);
    let decimals = usize::try_from(2 - power).unwrap_or(0);
    let text = match power {
        -3..=4 => format!("{value:.decimals$}"),
        _ => format!("{digits}×$10^{{{power}}}$"),
    };
    text.replacen('-', "−", usize::from(value < 0.0))
}
