//! The legend: how large it is, and where in the frame no curve runs.

use super::{
    canvas::{Anchor, Area, Canvas, Point},
    figure::{LegendPlace, Marker},
    label::{self, Run},
    style::{self, Rgb},
};

/// Length of the line sample.
const SAMPLE: f64 = 21.0;
/// From the line sample to the text.
const SAMPLE_GAP: f64 = 4.0;
/// Between two columns.
const COLUMN_GAP: f64 = 12.0;
/// From the frame to a legend inside it, and from a legend to the nearest curve.
const CLEARANCE: f64 = 6.0;
/// A curve closer than this to the legend counts as running through it.
const HALO: f64 = 2.5;
/// A legend inside the frame takes at most this part of its width...
const WIDEST_INSIDE: f64 = 0.62;
/// ...and at most this part of its height.
const TALLEST_INSIDE: f64 = 0.62;

/// One curve in the legend.
pub(super) struct Entry {
    pub(super) label: Vec<Run>,
    pub(super) dashes: Option<&'static [f64]>,
    pub(super) marker: Marker,
    pub(super) colour: Rgb,
}

/// An entry with its label broken into lines.
type Broken<'entries> = (&'entries Entry, Vec<Vec<Run>>);

/// The entries in columns, each with its width.
struct Block<'entries> {
    columns: Vec<(f64, Vec<Broken<'entries>>)>,
    width: f64,
    height: f64,
}

fn row() -> f64 {
    style::LEADING * style::LEGEND_SIZE
}

impl<'entries> Block<'entries> {
    /// The entries in this many columns, their labels broken so that a column is no wider than `limit`.
    fn new(entries: &'entries [Entry], columns: usize, limit: f64) -> Self {
        let text_limit = limit - SAMPLE - SAMPLE_GAP;
        let per_column = entries.len().div_ceil(columns.max(1)).max(1);
        let columns: Vec<_> = entries
            .chunks(per_column)
            .map(|chunk| {
                let column: Vec<Broken<'_>> =
                    chunk.iter().map(|entry| (entry, label::wrap(&entry.label, style::LEGEND_SIZE, text_limit))).collect();
                let lines = column.iter().flat_map(|(_, lines)| lines);
                let widest = lines.map(|line| label::width(line, style::LEGEND_SIZE)).fold(0.0, f64::max);
                (SAMPLE + SAMPLE_GAP + widest, column)
            })
            .collect();
        let rows = columns.iter().map(|(_, column)| column.iter().map(|(_, lines)| lines.len()).sum::<usize>()).max().unwrap_or(0);
        let gaps = columns.len().saturating_sub(1) as f64 * COLUMN_GAP;
        let width = columns.iter().map(|(width, _)| width).sum::<f64>() + gaps;
        Self { columns, width, height: rows as f64 * row() }
    }

    fn draw(&self, canvas: &mut Canvas, (left, top): Point) {
        canvas.open_group("legend");
        let mut left = left;
        for (width, entries) in &self.columns {
            let mut baseline = top + 0.98 * style::LEGEND_SIZE;
            for (entry, lines) in entries {
                let middle = baseline - 0.34 * style::LEGEND_SIZE;
                if let Some(dashes) = entry.dashes {
                    canvas.stroke(&[(left, middle), (left + SAMPLE, middle)], entry.colour, style::CURVE_WIDTH, dashes);
                }
                canvas.marker(entry.marker, (left + 0.5 * SAMPLE, middle), entry.colour);
                for line in lines {
                    canvas.text(line, (left + SAMPLE + SAMPLE_GAP, baseline), style::LEGEND_SIZE, Anchor::Start);
                    baseline += row();
                }
            }
            left += width + COLUMN_GAP;
        }
        canvas.close_group();
    }
}

/// What the legend must keep clear of.
pub(super) struct Obstacles<'figure> {
    pub(super) strokes: &'figure [Vec<Point>],
    pub(super) signs: &'figure [Point],
}

/// Draws the legend and returns the height it needs below the page.
pub(super) fn draw(
    canvas: &mut Canvas,
    entries: &[Entry],
    place: LegendPlace,
    frame: Area,
    (page_width, page_bottom): Point,
    obstacles: &Obstacles<'_>,
) -> f64 {
    if entries.is_empty() || place == LegendPlace::Hidden {
        return 0.0;
    }
    let (width, height) = (frame.right - frame.left, frame.bottom - frame.top);
    let inside = Block::new(entries, 1, WIDEST_INSIDE * width);
    let corner = match place {
        LegendPlace::Auto if inside.width > WIDEST_INSIDE * width || inside.height > TALLEST_INSIDE * height => None,
        LegendPlace::Auto => free_corner(frame, (inside.width, inside.height), obstacles),
        LegendPlace::TopLeft => corner_at(frame, &inside, 0.0, 0.0),
        LegendPlace::TopRight => corner_at(frame, &inside, 1.0, 0.0),
        LegendPlace::BottomLeft => corner_at(frame, &inside, 0.0, 1.0),
        LegendPlace::BottomRight => corner_at(frame, &inside, 1.0, 1.0),
        LegendPlace::Below | LegendPlace::Hidden => None,
    };
    if let Some(corner) = corner {
        inside.draw(canvas, corner);
        return 0.0;
    }
    let room = page_width - 2.0 * style::PAGE_MARGIN;
    // As many columns as fit; one always does, its labels broken to the width of the page.
    let candidates = (1..=entries.len()).rev().map(|columns| Block::new(entries, columns, room));
    let Some(below) = candidates.into_iter().find(|block| block.width <= room || block.columns.len() == 1) else { return 0.0 };
    below.draw(canvas, ((0.5 * (page_width - below.width)).max(style::PAGE_MARGIN), page_bottom + CLEARANCE));
    below.height + CLEARANCE
}

fn corner_at(frame: Area, block: &Block<'_>, right: f64, down: f64) -> Option<Point> {
    Some(corner(frame, (block.width, block.height), right, down))
}

/// The upper left corner of a legend that is `right` of the way to the right and `down` of the way down the frame.
fn corner(frame: Area, (width, height): Point, right: f64, down: f64) -> Point {
    let (spare_width, spare_height) =
        (frame.right - frame.left - width - 2.0 * CLEARANCE, frame.bottom - frame.top - height - 2.0 * CLEARANCE);
    (frame.left + CLEARANCE + right * spare_width, frame.top + CLEARANCE + down * spare_height)
}

/// The first corner, or else the first place along an edge, where the legend touches nothing.
fn free_corner(frame: Area, (width, height): Point, obstacles: &Obstacles<'_>) -> Option<Point> {
    const PLACES: [Point; 16] = [
        (1.0, 0.0),
        (0.0, 0.0),
        (1.0, 1.0),
        (0.0, 1.0),
        (0.5, 0.0),
        (0.5, 1.0),
        (1.0, 0.5),
        (0.0, 0.5),
        (1.0, 0.25),
        (1.0, 0.75),
        (0.0, 0.25),
        (0.0, 0.75),
        (0.25, 0.0),
        (0.75, 0.0),
        (0.25, 1.0),
        (0.75, 1.0),
    ];
    PLACES.into_iter().map(|(right, down)| corner(frame, (width, height), right, down)).find(|(left, top)| {
        let area = Area { left: left - HALO, top: top - HALO, right: left + width + HALO, bottom: top + height + HALO };
        let reach = style::MARKER_RADIUS;
        let hit = |(x, y): &Point| *x > area.left - reach && *x < area.right + reach && *y > area.top - reach && *y < area.bottom + reach;
        let crossed = |stroke: &Vec<Point>| stroke.windows(2).any(|pair| clip(pair[0], pair[1], area).is_some());
        !obstacles.signs.iter().any(hit) && !obstacles.strokes.iter().any(crossed)
    })
}

/// The part of a segment inside an area (Liang and Barsky 1984).
pub(super) fn clip(from: Point, to: Point, area: Area) -> Option<(Point, Point)> {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (step, room) in
        [(-across, from.0 - area.left), (across, area.right - from.0), (-down, from.1 - area.top), (down, area.bottom - from.1)]
    {
        if step.abs() < f64::MIN_POSITIVE {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else {
            leave = leave.min(room / step);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |part: f64| (from.0 + part * across, from.1 + part * down);
    Some((if enter > 0.0 { at(enter) } else { from }, if leave < 1.0 { at(leave) } else { to }))
}
