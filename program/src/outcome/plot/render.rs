//! From the data of a figure to a picture: the frame is measured, the curves are traced into it, the legend finds its place.
//!
//! The picture is laid out here, in points, and put down on a [`Canvas`]; [`vector`] and [`raster`] draw the same page.

use super::{
    PlotError,
    canvas::{Anchor, Area, Canvas, Page, Point},
    figure::{Axis, Curve, Figure, Marker, MarkerSpacing},
    inset,
    interval::{Interval, has_place},
    label::{self, Run},
    legend, map, panel, raster, style,
    ticks::{self, Direction, Ticks},
    vector,
};

/// From the frame to the text at the ticks.
pub(super) const TICK_GAP: f64 = 3.2;
/// From the text at the ticks to the label of the axis.
const LABEL_GAP: f64 = 4.0;
/// Part of the length left free at both ends of an axis whose range is not given.
const ROOM_BEYOND_DATA: f64 = 0.05;
/// Points of a line closer than this to the last one drawn are left out; a twentieth of the stroke.
const FINEST: f64 = 0.06;

/// The figure as an SVG document.
pub(super) fn svg(figure: &Figure) -> Result<String, PlotError> {
    Ok(vector::svg(&compose(figure)?, figure.title.as_deref()))
}

/// The figure as a PNG image.
pub(super) fn png(figure: &Figure) -> Result<Vec<u8>, PlotError> {
    raster::png(&compose(figure)?)
}

/// An axis with everything about it decided.
pub(super) struct Measured {
    pub(super) interval: Option<Interval>,
    ticks: Ticks,
    label: Vec<Vec<Run>>,
}

impl Measured {
    pub(super) fn new(axis: &Axis, interval: Option<Interval>, length: f64, direction: Direction) -> Self {
        Self {
            interval,
            ticks: interval.map_or_else(Ticks::default, |interval| ticks::ticks(interval, length, direction)),
            label: label::wrap(&label::parse(&axis.label), style::LABEL_SIZE, length),
        }
    }

    pub(super) fn label_depth(&self) -> f64 {
        if self.label.iter().all(Vec::is_empty) { 0.0 } else { LABEL_GAP + self.label.len() as f64 * style::LEADING * style::LABEL_SIZE }
    }

    /// Room to the left of its frame.
    pub(super) fn beside(&self) -> f64 {
        self.label_depth() + self.widest_tick() + TICK_GAP
    }

    pub(super) fn widest_tick(&self) -> f64 {
        self.ticks.major.iter().map(|(_, runs)| label::width(runs, style::TICK_SIZE)).fold(0.0, f64::max)
    }

    pub(super) const fn has_note(&self) -> bool {
        self.ticks.note.is_some()
    }

    /// How far the last label sticks out beyond the end of an axis of this length.
    pub(super) fn overhang(&self, length: f64) -> f64 {
        let beyond = |(place, runs): &(f64, Vec<Run>)| 0.5 * label::width(runs, style::TICK_SIZE) - (1.0 - place) * length;
        self.ticks.major.iter().map(beyond).fold(0.0, f64::max)
    }
}

/// One curve on the page.
#[derive(Default)]
pub(super) struct Trace {
    pub(super) strokes: Vec<Vec<Point>>,
    /// Points that no stroke reaches.
    pub(super) lonely: Vec<Point>,
    pub(super) signs: Vec<Point>,
}

fn compose(figure: &Figure) -> Result<Page, PlotError> {
    let (page_width, frame_height) = style::page(figure.width);
    let (horizontal, vertical) = intervals(figure)?;
    let vertical = Measured::new(&figure.vertical, vertical, frame_height, Direction::Vertical);

    let title = figure
        .title
        .as_ref()
        .map_or_else(Vec::new, |title| label::wrap(&label::parse(title), style::LABEL_SIZE, page_width - 2.0 * style::PAGE_MARGIN));
    let title_height = if title.iter().all(Vec::is_empty) { 0.0 } else { title.len() as f64 * style::LEADING * style::LABEL_SIZE };
    let colours = figure.map.as_ref().map(|map| map::Colours::new(map, frame_height)).transpose()?;
    let noted = vertical.has_note() || colours.as_ref().is_some_and(map::Colours::has_note);
    let note_height = if noted { 1.4 * style::TICK_SIZE } else { 0.0 };
    let panel =
        figure.residuals.as_deref().map(|residuals| panel::Panel::new(residuals, &figure.horizontal, frame_height)).transpose()?.flatten();
    let beside = vertical.beside().max(panel.as_ref().map_or(0.0, panel::Panel::beside));
    let left = style::PAGE_MARGIN + beside;
    let top = style::PAGE_MARGIN + title_height + note_height + 0.5 * style::TICK_SIZE;

    let mut right = page_width - style::PAGE_MARGIN - 1.0;
    right -= colours.as_ref().map_or(0.0, map::Colours::width);
    let mut measured = Measured::new(&figure.horizontal, horizontal, right - left, Direction::Horizontal);
    let overhang = measured.overhang(right - left);
    if overhang > 1.0 {
        right -= overhang;
        measured = Measured::new(&figure.horizontal, horizontal, right - left, Direction::Horizontal);
    }
    let horizontal = measured;
    let frame = Area { left, top, right, bottom: top + frame_height };

    let mut canvas = Canvas::default();
    if let (Some(map), Some(colours), Some(across), Some(up)) = (&figure.map, &colours, horizontal.interval, vertical.interval) {
        map::draw(&mut canvas, map, colours, (across, up), frame);
    }
    draw_title(&mut canvas, &title, page_width);
    draw_frame(&mut canvas, frame);
    draw_ticks(&mut canvas, frame, (&horizontal, &vertical), panel.is_none());
    let mut bottom = match &panel {
        Some(panel) => {
            draw_vertical_label(&mut canvas, frame, &vertical, style::PAGE_MARGIN);
            panel.draw(&mut canvas, frame, &horizontal)
        }
        None => draw_labels(&mut canvas, frame, (&horizontal, &vertical), style::PAGE_MARGIN),
    };

    let traces: Vec<Trace> = match (horizontal.interval, vertical.interval) {
        (Some(across), Some(up)) => figure.curves.iter().map(|curve| trace(curve, across, up, frame)).collect(),
        _ => Vec::new(),
    };
    if figure.map.is_none() && traces.iter().all(|trace| trace.strokes.is_empty() && trace.lonely.is_empty() && trace.signs.is_empty()) {
        draw_absence(&mut canvas, figure, frame);
    }
    if let (Some(across), Some(up)) = (horizontal.interval, vertical.interval) {
        draw_bands(&mut canvas, figure, (across, up), frame);
    }
    draw_curves(&mut canvas, figure, &traces);

    let mut strokes: Vec<Vec<Point>> = traces.iter().flat_map(|trace| trace.strokes.iter().cloned()).collect();
    if let Some(inset) = &figure.inset {
        strokes.push(inset::draw(&mut canvas, inset, frame)?);
    }
    let signs: Vec<Point> = traces.iter().flat_map(|trace| trace.signs.iter().chain(&trace.lonely).copied()).collect();
    let obstacles = legend::Obstacles { strokes: &strokes, signs: &signs };
    bottom += legend::draw(&mut canvas, &legend_entries(figure, &traces), figure.legend, frame, (page_width, bottom), &obstacles);
    if let Some(note) = &figure.note {
        for line in label::wrap(&label::parse(note), style::LEGEND_SIZE, page_width - 2.0 * style::PAGE_MARGIN) {
            bottom += style::LEADING * style::LEGEND_SIZE;
            canvas.text(&line, (page_width - style::PAGE_MARGIN, bottom), style::LEGEND_SIZE, Anchor::End);
        }
    }
    Ok(canvas.into_page(page_width, bottom + style::PAGE_MARGIN))
}

/// The two intervals shown; `None` where there is nothing to show and no range given.
pub(super) fn intervals(figure: &Figure) -> Result<(Option<Interval>, Option<Interval>), PlotError> {
    let banded = figure.curves.iter().flat_map(|curve| banded(curve).flat_map(|(x, ends)| ends.map(|y| (x, y))));
    let shown: Vec<Point> = figure
        .curves
        .iter()
        .flat_map(|curve| &curve.points)
        .copied()
        .chain(banded)
        .filter(|(x, y)| has_place(figure.horizontal.scale, *x) && has_place(figure.vertical.scale, *y))
        .collect();
    let within = |range: Option<(f64, f64)>, value: f64| range.is_none_or(|(lower, upper)| value >= lower && value <= upper);
    let extent = |values: &mut dyn Iterator<Item = f64>| {
        values.fold(None, |extent: Option<(f64, f64)>, value| {
            Some(extent.map_or((value, value), |(least, greatest)| (least.min(value), greatest.max(value))))
        })
    };
    let below = figure.residuals.iter().flat_map(|residuals| &residuals.points).map(|point| point.0);
    let below = below.filter(|x| has_place(figure.horizontal.scale, *x));
    let across = extent(&mut shown.iter().filter(|(_, y)| within(figure.vertical.range, *y)).map(|(x, _)| *x).chain(below));
    let up = extent(&mut shown.iter().filter(|(x, _)| within(figure.horizontal.range, *x)).map(|(_, y)| *y));
    if let Some(map) = &figure.map {
        let [across, up] =
            [(&map.across, &figure.horizontal), (&map.up, &figure.vertical)].map(|(places, axis)| map::span(places, axis.scale));
        return Ok((Interval::new(&figure.horizontal, across, 0.0)?, Interval::new(&figure.vertical, up, 0.0)?));
    }
    let beside = if figure.curves.iter().all(may_touch_the_sides) { 0.0 } else { ROOM_BEYOND_DATA };
    Ok((Interval::new(&figure.horizontal, across, beside)?, Interval::new(&figure.vertical, up, ROOM_BEYOND_DATA)?))
}

/// A line that runs in one direction may begin and end on the frame; markers and the turns of a folded branch may not lie on it.
fn may_touch_the_sides(curve: &Curve) -> bool {
    let marked = curve.marker != Marker::None && curve.marker_spacing == MarkerSpacing::EveryPoint;
    let places = || curve.points.iter().map(|(x, _)| *x).filter(|x| x.is_finite());
    let single = places().nth(1).is_none() && places().next().is_some();
    !marked && !single && (places().is_sorted() || places().is_sorted_by(|earlier, later| earlier >= later))
}

/// The curve on the page: cut at the frame, broken at gaps.
pub(super) fn trace(curve: &Curve, across: Interval, up: Interval, frame: Area) -> Trace {
    let place = |(x, y): &Point| {
        let (right, above) = (across.fraction(*x)?, up.fraction(*y)?);
        Some((frame.left + right * (frame.right - frame.left), frame.bottom - above * (frame.bottom - frame.top)))
    };
    let mut trace = Trace::default();
    let drawn: Vec<Option<Point>> = curve.points.iter().map(place).collect();
    for unbroken in drawn.split(Option::is_none) {
        let points: Vec<Point> = unbroken.iter().flatten().copied().collect();
        let extended = points.iter().any(|point| distance(*point, points[0]) >= FINEST);
        if !extended {
            trace.lonely.extend(points.first().filter(|point| inside(**point, frame)));
        } else if curve.line != super::Line::None {
            trace.strokes.extend(cut_at_frame(&thinned(&points), frame));
        }
    }
    if curve.marker != Marker::None {
        trace.signs = match curve.marker_spacing {
            MarkerSpacing::EveryPoint => drawn.iter().flatten().copied().filter(|point| inside(*point, frame)).collect(),
            MarkerSpacing::Sparse => trace.strokes.iter().flat_map(|stroke| spread(stroke)).collect(),
        };
    }
    trace
}

fn distance(from: Point, to: Point) -> f64 {
    (to.0 - from.0).hypot(to.1 - from.1)
}

/// A hair wider than the frame, so that rounding does not cost the end points.
fn inside((x, y): Point, frame: Area) -> bool {
    const HAIR: f64 = 1e-6;
    x >= frame.left - HAIR && x <= frame.right + HAIR && y >= frame.top - HAIR && y <= frame.bottom + HAIR
}

/// The line without points that lie on the one before.
fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for (index, point) in points.iter().enumerate() {
        let far = kept.last().is_none_or(|last| distance(*last, *point) >= FINEST);
        if far {
            kept.push(*point);
        } else if index + 1 == points.len() && kept.len() > 1 {
            kept.pop(); // the end of the line is exact
            kept.push(*point);
        }
    }
    kept
}

fn cut_at_frame(points: &[Point], frame: Area) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut piece: Vec<Point> = Vec::new();
    for pair in points.windows(2) {
        let Some((from, to)) = legend::clip(pair[0], pair[1], frame) else {
            pieces.extend((piece.len() > 1).then(|| std::mem::take(&mut piece)));
            piece.clear();
            continue;
        };
        if piece.last().is_none_or(|last| distance(*last, from) > 1e-9) {
            pieces.extend((piece.len() > 1).then(|| std::mem::take(&mut piece)));
            piece = vec![from];
        }
        if distance(from, to) > 1e-9 {
            piece.push(to);
        }
    }
    pieces.extend((piece.len() > 1).then_some(piece));
    pieces
}

/// A few places evenly along a line, half a distance from its ends.
fn spread(stroke: &[Point]) -> Vec<Point> {
    let length: f64 = stroke.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    let count = (length / style::SPARSE_DISTANCE).round().max(1.0);
    let step = length / count;
    let (mut places, mut next, mut travelled) = (Vec::new(), 0.5 * step, 0.0);
    for pair in stroke.windows(2) {
        let piece = distance(pair[0], pair[1]);
        while next <= travelled + piece && piece > 0.0 && next < length {
            let part = (next - travelled) / piece;
            places.push((pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1)));
            next += step;
        }
        travelled += piece;
    }
    places
}

/// The points of a curve with the ends of the band below and above them.
fn banded(curve: &Curve) -> impl Iterator<Item = (f64, [f64; 2])> + '_ {
    curve.points.iter().zip(&curve.band).map(|(&(x, y), half)| (x, [y - half, y + half]))
}

/// Pale bands around curves, under all of them, within the frame.
fn draw_bands(canvas: &mut Canvas, figure: &Figure, (across, up): (Interval, Interval), frame: Area) {
    for (place, curve) in figure.curves.iter().enumerate().filter(|(_, curve)| !curve.band.is_empty()) {
        let ends: Vec<Option<(f64, [f64; 2])>> = banded(curve)
            .map(|(x, [below, above])| {
                let x = across.fraction(x).filter(|x| (0.0..=1.0).contains(x))?;
                // Below all decades of a logarithmic axis is its lower end.
                let [below, above] = [up.fraction(below).unwrap_or(0.0), up.fraction(above)?].map(|part| part.clamp(0.0, 1.0));
                let height = frame.bottom - frame.top;
                let right = frame.left + x * (frame.right - frame.left);
                Some((right, [frame.bottom - below * height, frame.bottom - above * height]))
            })
            .collect();
        for unbroken in ends.split(Option::is_none).filter(|unbroken| unbroken.len() > 1) {
            let side = |which: usize| unbroken.iter().flatten().map(move |(x, ends)| (*x, ends[which]));
            let corners: Vec<Point> = side(1).chain(side(0).collect::<Vec<_>>().into_iter().rev()).collect();
            canvas.open_group("band");
            canvas.filled(corners, style::pale(style::colour(curve.colour, place)));
            canvas.close_group();
        }
    }
}

pub(super) fn draw_curves(canvas: &mut Canvas, figure: &Figure, traces: &[Trace]) {
    for (place, (curve, trace)) in figure.curves.iter().zip(traces).enumerate() {
        let colour = style::colour(curve.colour, place);
        canvas.open_group("curve");
        for stroke in &trace.strokes {
            canvas.stroke(stroke, colour, style::CURVE_WIDTH, style::dashes(curve.line, place).unwrap_or_default());
        }
        for point in &trace.lonely {
            canvas.dot(*point, if curve.marker == Marker::None { style::MARKER_RADIUS } else { 0.5 * style::CURVE_WIDTH }, colour);
        }
        for sign in &trace.signs {
            canvas.marker(curve.marker, *sign, colour);
        }
        canvas.close_group();
    }
}

fn legend_entries(figure: &Figure, traces: &[Trace]) -> Vec<legend::Entry> {
    let labelled = figure.curves.iter().enumerate().filter(|(_, curve)| !curve.label.trim().is_empty());
    labelled
        .map(|(place, curve)| {
            let dots_only = traces.get(place).is_some_and(|trace| trace.strokes.is_empty() && !trace.lonely.is_empty());
            legend::Entry {
                label: label::parse(&curve.label),
                dashes: if dots_only { None } else { style::dashes(curve.line, place) },
                marker: if dots_only && curve.marker == Marker::None { Marker::Circle } else { curve.marker },
                colour: style::colour(curve.colour, place),
            }
        })
        .collect()
}

fn draw_title(canvas: &mut Canvas, title: &[Vec<Run>], page_width: f64) {
    let mut baseline = style::PAGE_MARGIN + style::LABEL_SIZE;
    for line in title {
        canvas.text(line, (0.5 * page_width, baseline), style::LABEL_SIZE, Anchor::Middle);
        baseline += style::LEADING * style::LABEL_SIZE;
    }
}

pub(super) fn draw_frame(canvas: &mut Canvas, frame: Area) {
    canvas.open_group("frame");
    let corners = [(frame.left, frame.top), (frame.right, frame.top), (frame.right, frame.bottom), (frame.left, frame.bottom)];
    for (index, corner) in corners.into_iter().enumerate() {
        canvas.stroke(&[corner, corners[(index + 1) % 4]], style::INK, style::FRAME_WIDTH, &[]);
    }
    canvas.close_group();
}

/// The ticks of both axes; the horizontal ones with or without their numbers.
pub(super) fn draw_ticks(canvas: &mut Canvas, frame: Area, (horizontal, vertical): (&Measured, &Measured), numbered: bool) {
    draw_horizontal_ticks(canvas, frame, &horizontal.ticks, numbered);
    draw_vertical_ticks(canvas, frame, &vertical.ticks);
}

/// Writes the labels of both axes, that of the vertical one from `left` on, and returns where the page ends below them.
pub(super) fn draw_labels(canvas: &mut Canvas, frame: Area, (horizontal, vertical): (&Measured, &Measured), left: f64) -> f64 {
    draw_vertical_label(canvas, frame, vertical, left);
    draw_horizontal_label(canvas, frame, horizontal)
}

fn draw_horizontal_ticks(canvas: &mut Canvas, frame: Area, ticks: &Ticks, numbered: bool) {
    canvas.open_group("horizontal axis");
    let both = |canvas: &mut Canvas, place: f64, length: f64, width: f64| {
        let x = frame.left + place * (frame.right - frame.left);
        canvas.stroke(&[(x, frame.bottom), (x, frame.bottom - length)], style::INK, width, &[]);
        canvas.stroke(&[(x, frame.top), (x, frame.top + length)], style::INK, width, &[]);
    };
    for place in &ticks.minor {
        both(canvas, *place, style::MINOR_LENGTH, style::MINOR_WIDTH);
    }
    for (place, runs) in &ticks.major {
        both(canvas, *place, style::MAJOR_LENGTH, style::FRAME_WIDTH);
        if !numbered {
            continue;
        }
        let x = frame.left + place * (frame.right - frame.left);
        canvas.text(runs, (x, tick_baseline(frame)), style::TICK_SIZE, Anchor::Middle);
    }
    canvas.close_group();
}

/// The line under the frame on which the numbers stand; raised exponents stay clear of the frame.
fn tick_baseline(frame: Area) -> f64 {
    frame.bottom + TICK_GAP + 0.98 * style::TICK_SIZE
}

fn draw_vertical_ticks(canvas: &mut Canvas, frame: Area, ticks: &Ticks) {
    canvas.open_group("vertical axis");
    let both = |canvas: &mut Canvas, place: f64, length: f64, width: f64| {
        let y = frame.bottom - place * (frame.bottom - frame.top);
        canvas.stroke(&[(frame.left, y), (frame.left + length, y)], style::INK, width, &[]);
        canvas.stroke(&[(frame.right, y), (frame.right - length, y)], style::INK, width, &[]);
    };
    for place in &ticks.minor {
        both(canvas, *place, style::MINOR_LENGTH, style::MINOR_WIDTH);
    }
    for (place, runs) in &ticks.major {
        both(canvas, *place, style::MAJOR_LENGTH, style::FRAME_WIDTH);
        let y = frame.bottom - place * (frame.bottom - frame.top);
        canvas.text(runs, (frame.left - TICK_GAP, y + 0.36 * style::TICK_SIZE), style::TICK_SIZE, Anchor::End);
    }
    if let Some(note) = &ticks.note {
        canvas.text(note, (frame.left, frame.top - 0.5 * style::TICK_SIZE), style::TICK_SIZE, Anchor::Start);
    }
    canvas.close_group();
}

/// Ticks with their numbers to the right of a scale of colours.
pub(super) fn draw_scale(canvas: &mut Canvas, bar: Area, axis: &Measured) {
    canvas.open_group("colour axis");
    for (place, runs) in &axis.ticks.major {
        let y = bar.bottom - place * (bar.bottom - bar.top);
        canvas.stroke(&[(bar.right, y), (bar.right - style::MINOR_LENGTH, y)], style::INK, style::FRAME_WIDTH, &[]);
        canvas.text(runs, (bar.right + TICK_GAP, y + 0.36 * style::TICK_SIZE), style::TICK_SIZE, Anchor::Start);
    }
    if let Some(note) = &axis.ticks.note {
        canvas.text(note, (bar.right, bar.top - 0.5 * style::TICK_SIZE), style::TICK_SIZE, Anchor::End);
    }
    canvas.close_group();
}

/// The label of a scale of colours: it reads upwards, its last line at `right`.
pub(super) fn draw_turned_label(canvas: &mut Canvas, frame: Area, axis: &Measured, right: f64) {
    let middle = 0.5 * (frame.top + frame.bottom);
    let lines = axis.label.len();
    for (index, line) in axis.label.iter().enumerate() {
        let back = lines.saturating_sub(index + 1) as f64 * style::LEADING * style::LABEL_SIZE;
        canvas.turned_text(line, (right - back, middle), style::LABEL_SIZE);
    }
}

/// Writes the label of the horizontal axis and returns where the page ends below it.
fn draw_horizontal_label(canvas: &mut Canvas, frame: Area, axis: &Measured) -> f64 {
    let middle = 0.5 * (frame.left + frame.right);
    let mut bottom = tick_baseline(frame);
    if axis.ticks.major.is_empty() {
        bottom = frame.bottom;
    }
    let mut baseline = bottom + LABEL_GAP + style::LABEL_SIZE;
    if let Some(note) = &axis.ticks.note {
        let room = 0.5 * (frame.right - frame.left) - label::width(note, style::TICK_SIZE) - style::LABEL_SIZE;
        let beside = axis.label.iter().all(|line| 0.5 * label::width(line, style::LABEL_SIZE) < room);
        canvas.text(note, (frame.right, baseline), style::TICK_SIZE, Anchor::End);
        bottom = baseline;
        if !beside {
            baseline += style::LEADING * style::LABEL_SIZE;
        }
    }
    for line in axis.label.iter().filter(|line| !line.is_empty()) {
        canvas.text(line, (middle, baseline), style::LABEL_SIZE, Anchor::Middle);
        bottom = baseline;
        baseline += style::LEADING * style::LABEL_SIZE;
    }
    bottom + 0.3 * style::LABEL_SIZE
}

fn draw_vertical_label(canvas: &mut Canvas, frame: Area, axis: &Measured, left: f64) {
    let middle = 0.5 * (frame.top + frame.bottom);
    for (index, line) in axis.label.iter().enumerate() {
        let baseline = left + (0.95 + index as f64 * style::LEADING) * style::LABEL_SIZE;
        canvas.turned_text(line, (baseline, middle), style::LABEL_SIZE);
    }
}

/// Says why the frame is empty.
fn draw_absence(canvas: &mut Canvas, figure: &Figure, frame: Area) {
    let points = || figure.curves.iter().flat_map(|curve| &curve.points);
    let reason = if points().next().is_none() {
        "no data"
    } else if points().all(|(x, y)| !(x.is_finite() && y.is_finite())) {
        "no finite data"
    } else if points().all(|(x, y)| !(has_place(figure.horizontal.scale, *x) && has_place(figure.vertical.scale, *y))) {
        "no positive data for the logarithmic axis"
    } else {
        "no data in this range"
    };
    let middle = (0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom));
    canvas.text(&label::plain(reason), middle, style::LABEL_SIZE, Anchor::Middle);
}
