//! A heat map: cells whose colours are values, and the scale of the colours beside the frame.

use super::{
    PlotError,
    canvas::{Area, Canvas, Point},
    figure::{Map, Scale},
    interval::{Interval, has_place},
    render,
    render::{Measured, TICK_GAP},
    style,
    ticks::Direction,
};

/// Between the frame and the scale of the colours, and its width.
const GAP: f64 = 8.0;
const BAR: f64 = 9.0;
/// Steps of the scale.
const STEPS: u32 = 64;
/// An overlap that hides the seams between cells.
const SEAM: f64 = 0.12;

/// The scale of the colours.
pub(super) struct Colours {
    interval: Option<Interval>,
    measured: Measured,
}

impl Colours {
    pub(super) fn new(map: &Map, height: f64) -> Result<Self, PlotError> {
        let shown = map.values.iter().copied().filter(|value| has_place(map.colours.scale, *value));
        let extent = shown.fold(None, |extent: Option<(f64, f64)>, value| {
            Some(extent.map_or((value, value), |(least, most)| (least.min(value), most.max(value))))
        });
        let interval = Interval::new(&map.colours, extent, 0.0)?;
        Ok(Self { interval, measured: Measured::new(&map.colours, interval, height, Direction::Vertical) })
    }

    /// Whether a factor of its numbers stands above it.
    pub(super) const fn has_note(&self) -> bool {
        self.measured.has_note()
    }

    /// Room that it takes to the right of the frame.
    pub(super) fn width(&self) -> f64 {
        GAP + BAR + TICK_GAP + self.measured.widest_tick() + self.measured.label_depth()
    }
}

/// Where the cells of these places begin and end.
pub(super) fn span(places: &[f64], scale: Scale) -> Option<(f64, f64)> {
    let edges = edges(places, scale);
    edges.first().copied().zip(edges.last().copied()).map(|(first, last)| (first.min(last), first.max(last)))
}

/// The edges between the cells: half way between neighbours, as the axis counts.
fn edges(places: &[f64], scale: Scale) -> Vec<f64> {
    let logarithmic = scale == Scale::Logarithmic;
    let into = |value: f64| if logarithmic { value.log10() } else { value };
    let back = |place: f64| if logarithmic { 10f64.powf(place) } else { place };
    let places: Vec<f64> = places.iter().copied().filter(|place| has_place(scale, *place)).map(into).collect();
    let (Some(first), Some(last)) = (places.first(), places.last()) else { return Vec::new() };
    let half = |pair: &[f64]| match pair {
        [one, two] => 0.5 * (two - one),
        _ => 0.0,
    };
    let before = places.get(..2).map_or(0.5, half);
    let after = places.get(places.len().saturating_sub(2)..).filter(|pair| pair.len() == 2).map_or(0.5, half);
    let mut edges = vec![back(first - before)];
    edges.extend(places.windows(2).map(|pair| back(pair[0] + half(pair))));
    edges.push(back(last + after));
    edges
}

pub(super) fn draw(canvas: &mut Canvas, map: &Map, colours: &Colours, (across, up): (Interval, Interval), frame: Area) {
    let Some(scale) = colours.interval else { return };
    let x = |value: f64| across.fraction(value).map(|part| frame.left + part.clamp(0.0, 1.0) * (frame.right - frame.left));
    let y = |value: f64| up.fraction(value).map(|part| frame.bottom - part.clamp(0.0, 1.0) * (frame.bottom - frame.top));
    let columns = edges(&map.across, across.scale());
    let rows = edges(&map.up, up.scale());
    canvas.open_group("map");
    for (row, ends) in rows.windows(2).enumerate() {
        let (Some(bottom), Some(top)) = (y(ends[0]), y(ends[1])) else { continue };
        for (column, sides) in columns.windows(2).enumerate() {
            let (Some(left), Some(right)) = (x(sides[0]), x(sides[1])) else { continue };
            let value = map.values.get(row * map.across.len() + column).copied().unwrap_or(f64::NAN);
            if let Some(part) = scale.fraction(value) {
                canvas.filled(rectangle((left, top), (right, bottom)), style::sequential(part));
            }
        }
    }
    canvas.close_group();
    canvas.open_group("colours");
    let bar = Area { left: frame.right + GAP, right: frame.right + GAP + BAR, ..frame };
    for step in 0..STEPS {
        let [low, high] = [step, step + 1].map(|step| f64::from(step) / f64::from(STEPS));
        let [bottom, top] = [low, high].map(|part| bar.bottom - part * (bar.bottom - bar.top));
        canvas.filled(rectangle((bar.left, top), (bar.right, bottom)), style::sequential(0.5 * (low + high)));
    }
    canvas.close_group();
    render::draw_frame(canvas, bar);
    render::draw_scale(canvas, bar, &colours.measured);
    let label = bar.right + TICK_GAP + colours.measured.widest_tick() + colours.measured.label_depth();
    render::draw_turned_label(canvas, frame, &colours.measured, label - 0.25 * style::LABEL_SIZE);
}

fn rectangle((left, top): Point, (right, bottom): Point) -> Vec<Point> {
    let (right, bottom) = (right + SEAM, bottom + SEAM);
    vec![(left, top), (right, top), (right, bottom), (left, bottom)]
}
