//! Source: the contract of `viscotack_program::outcome::plot` (its module documentation).
//! Goal: a plot shows the data and nothing else: gaps are gaps, equal ratios are equal distances, the same figure gives the same bytes, odd input
//! gives an honest picture or a typed error.
//! Oracle: the SVG text itself, read back here: the strokes of the groups of class `curve`, in tenths of a point.
//! Tolerance: 0.02 units (two decimals are written, each rounded by at most 0.005).
#![cfg(feature = "plots")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::float_cmp)]

use proptest::prelude::*;
use viscotack_program::outcome::plot::{
    self, Axis, Colour, Curve, Figure, LegendPlace, Line, Map, Marker, PlotError, Residuals, Scale, Width,
};

const ROUNDING: f64 = 0.02;

/// The inside of every group of this class.
fn groups<'svg>(svg: &'svg str, class: &str) -> Vec<&'svg str> {
    let opening = format!(r#"<g class="{class}""#);
    svg.split(opening.as_str()).skip(1).map(|rest| rest.split("</g>").next().unwrap()).collect()
}

/// The value of an attribute wherever it occurs.
fn attributes<'svg>(svg: &'svg str, name: &str) -> Vec<&'svg str> {
    let opening = format!(r#" {name}=""#);
    svg.split(opening.as_str()).skip(1).map(|rest| rest.split('"').next().unwrap()).collect()
}

/// The points of every open path of a group (closed paths are dots and markers).
fn strokes(group: &str) -> Vec<Vec<(f64, f64)>> {
    let open = attributes(group, "d").into_iter().filter(|data| !data.ends_with('Z'));
    open.map(|data| {
        let numbers: Vec<f64> = data.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        numbers.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
    })
    .collect()
}

fn dots(group: &str) -> usize {
    attributes(group, "d").into_iter().filter(|data| data.ends_with('Z')).count()
}

/// Left, top, right and bottom of the frame.
fn frame(svg: &str) -> [f64; 4] {
    let corners: Vec<(f64, f64)> = strokes(groups(svg, "frame")[0]).into_iter().flatten().collect();
    let across = || corners.iter().map(|corner| corner.0);
    let down = || corners.iter().map(|corner| corner.1);
    [
        across().fold(f64::INFINITY, f64::min),
        down().fold(f64::INFINITY, f64::min),
        across().fold(f64::NEG_INFINITY, f64::max),
        down().fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// What is written on the page, without markup, one string per text element.
fn texts(svg: &str) -> Vec<String> {
    svg.split("<text")
        .skip(1)
        .map(|rest| {
            let inner = rest.split("</text>").next().unwrap();
            let pieces: String = inner.split('<').filter_map(|piece| piece.split_once('>')).map(|(_, text)| text).collect();
            pieces.replace('\u{a0}', " ")
        })
        .collect()
}

/// Every number of the document is a number, every stroke lies in the frame, every group is closed.
fn assert_sound(svg: &str) {
    for data in attributes(svg, "d").into_iter().chain(attributes(svg, "x")).chain(attributes(svg, "y")).chain(attributes(svg, "viewBox")) {
        let odd =
            data.split_whitespace().find(|word| !matches!(*word, "M" | "L" | "Z") && !word.parse::<f64>().is_ok_and(|n| n.abs() < 1e5));
        assert!(odd.is_none(), "{odd:?} in the document");
    }
    let [left, top, right, bottom] = frame(svg);
    for (x, y) in groups(svg, "curve").into_iter().flat_map(strokes).flatten() {
        assert!(
            x >= left - ROUNDING && x <= right + ROUNDING && y >= top - ROUNDING && y <= bottom + ROUNDING,
            "({x}, {y}) outside the frame"
        );
    }
    assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count());
    assert!(!svg.contains('\u{e000}') && !svg.contains('\u{e001}'));
}

fn both(scale: Scale) -> Figure {
    let axis = |label: &str| Axis { label: label.to_owned(), scale, range: None };
    Figure::new(axis("$x$"), axis("$y$"))
}

fn family() -> Figure {
    let speeds: Vec<f64> = (0..200).map(|i| 10_f64.powf(-12.0 + 0.12 * f64::from(i))).collect();
    (1..6).fold(both(Scale::Logarithmic).with_title("family"), |figure, order| {
        let top = 10_f64.powi(order);
        figure.with_curve(Curve::new(format!("$10^{order}$"), speeds.iter().map(|v| (*v, (1.0 + top * v) / (1.0 + v))).collect()))
    })
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let figure = family();
    assert_eq!(plot::svg(&figure).unwrap(), plot::svg(&figure.clone()).unwrap());
    assert_eq!(plot::png(&figure).unwrap(), plot::png(&figure.clone()).unwrap());
}

#[test]
fn equal_ratios_are_equal_distances() {
    let points: Vec<(f64, f64)> = (-6..=6).map(|n| (10_f64.powi(2 * n), 3.0_f64.powi(n))).collect();
    let svg = plot::svg(&both(Scale::Logarithmic).with_curve(Curve::new("powers", points))).unwrap();
    let drawn = strokes(groups(&svg, "curve")[0]);
    assert_eq!(drawn.len(), 1);
    assert_eq!(drawn[0].len(), 13);
    let (across, down) = (drawn[0][1].0 - drawn[0][0].0, drawn[0][1].1 - drawn[0][0].1);
    assert!(across > 100.0 && down < -80.0, "the curve fills the frame and rises");
    for pair in drawn[0].windows(2) {
        assert!((pair[1].0 - pair[0].0 - across).abs() < ROUNDING);
        assert!((pair[1].1 - pair[0].1 - down).abs() < ROUNDING);
    }
}

#[test]
fn equal_differences_are_equal_distances() {
    let points: Vec<(f64, f64)> = (-5..=5).map(|n| (f64::from(n), 1e-7 - 2e-9 * f64::from(n))).collect();
    let svg = plot::svg(&both(Scale::Linear).with_curve(Curve::new("steps", points))).unwrap();
    let drawn = strokes(groups(&svg, "curve")[0]);
    let (across, down) = (drawn[0][1].0 - drawn[0][0].0, drawn[0][1].1 - drawn[0][0].1);
    assert!(across > 100.0 && down > 80.0);
    for pair in drawn[0].windows(2) {
        assert!((pair[1].0 - pair[0].0 - across).abs() < ROUNDING && (pair[1].1 - pair[0].1 - down).abs() < ROUNDING);
    }
}

#[test]
fn a_label_stands_under_the_value_it_names() {
    // The axis runs from 10^-2 to 10^4: all seven decades are labelled, and 10^1 is in the middle.
    let figure = Figure::new(Axis::logarithmic("").with_range(1e-2, 1e4), Axis::linear(""));
    let svg = plot::svg(&figure.with_curve(Curve::new("", vec![(10.0, 0.0), (10.0, 1.0)]))).unwrap();
    let [left, _, right, _] = frame(&svg);
    let middle = 0.5 * (left + right);
    let axis = groups(&svg, "horizontal axis")[0];
    assert_eq!(texts(axis), ["10−2", "10−1", "100", "101", "102", "103", "104"]);
    let places: Vec<f64> = attributes(axis, "x").into_iter().map(|x| x.parse().unwrap()).collect();
    assert!((places[3] - middle).abs() <= 0.5 + ROUNDING, "text is placed on whole units");
    assert!(strokes(groups(&svg, "curve")[0])[0].iter().all(|(x, _)| (x - middle).abs() < ROUNDING));
}

#[test]
fn gaps_break_the_line() {
    let hole = f64::NAN;
    let before = [(1.0, 1.0), (2.0, 2.0), (3.0, hole), (4.0, 3.0), (5.0, 4.0), (hole, 2.0)];
    let after = [(6.0, 4.5), (7.0, f64::INFINITY), (8.0, 2.0), (9.0, 1.0)];
    let svg = plot::svg(&both(Scale::Linear).with_curve(Curve::new("broken", [before.as_slice(), &after].concat()))).unwrap();
    let group = groups(&svg, "curve")[0];
    assert_eq!(strokes(group).iter().map(Vec::len).collect::<Vec<_>>(), [2, 2, 2]);
    assert_eq!(dots(group), 1, "the point between two gaps is a dot");
    assert_sound(&svg);
}

#[test]
fn what_has_no_logarithm_is_a_gap() {
    let before = [(1.0, 1.0), (2.0, 10.0), (3.0, 0.0), (4.0, 10.0), (5.0, 20.0), (6.0, -3.0)];
    let after = [(7.0, 5.0), (8.0, 6.0), (-1.0, 1.0), (0.0, 1.0)];
    let svg = plot::svg(&both(Scale::Logarithmic).with_curve(Curve::new("partly", [before.as_slice(), &after].concat()))).unwrap();
    assert_eq!(strokes(groups(&svg, "curve")[0]).iter().map(Vec::len).collect::<Vec<_>>(), [2, 2, 2]);
    assert_sound(&svg);
}

#[test]
fn a_curve_leaves_and_enters_the_frame_at_its_edge() {
    let figure = Figure::new(Axis::linear("").with_range(0.0, 10.0), Axis::linear("").with_range(-1.0, 1.0));
    let svg = plot::svg(&figure.with_curve(Curve::new("", vec![(0.0, 0.0), (5.0, 1e300), (10.0, 0.0)]))).unwrap();
    let drawn = strokes(groups(&svg, "curve")[0]);
    let [_, top, ..] = frame(&svg);
    assert_eq!(drawn.len(), 2);
    assert!((drawn[0].last().unwrap().1 - top).abs() < ROUNDING && (drawn[1][0].1 - top).abs() < ROUNDING);
}

#[test]
fn an_empty_figure_says_so() {
    let negative = Curve::new("negative", vec![(-1.0, 1.0), (1.0, 0.0)]);
    let elsewhere = Curve::new("elsewhere", vec![(1.0, 1.0), (2.0, 1.0)]);
    let cases = [
        (both(Scale::Linear), "no data"),
        (both(Scale::Linear).with_curve(Curve::new("empty", vec![])), "no data"),
        (both(Scale::Linear).with_curve(Curve::new("lost", vec![(f64::NAN, 1.0), (1.0, f64::INFINITY)])), "no finite data"),
        (both(Scale::Logarithmic).with_curve(negative), "no positive data for the logarithmic axis"),
        (Figure::new(Axis::linear("").with_range(5.0, 6.0), Axis::linear("")).with_curve(elsewhere), "no data in this range"),
    ];
    for (figure, words) in cases {
        let svg = plot::svg(&figure).unwrap();
        assert!(texts(&svg).contains(&words.to_owned()), "{words}");
        assert_sound(&svg);
        assert!(plot::png(&figure).is_ok());
    }
}

#[test]
fn one_point_is_a_dot_and_equal_points_are_one() {
    for scale in [Scale::Linear, Scale::Logarithmic] {
        for points in [vec![(2.0, 3.0)], vec![(2.0, 3.0); 5], vec![(1e-310, 5e-324)], vec![(f64::MAX, f64::MAX)]] {
            let svg = plot::svg(&both(scale).with_curve(Curve::new("point", points))).unwrap();
            assert_eq!(dots(groups(&svg, "curve")[0]), 1);
            assert_sound(&svg);
        }
    }
}

#[test]
fn impossible_ranges_are_refused() {
    for (scale, lower, upper) in [
        (Scale::Linear, 1.0, 1.0),
        (Scale::Linear, 2.0, 1.0),
        (Scale::Linear, f64::NAN, 1.0),
        (Scale::Linear, 0.0, f64::INFINITY),
        (Scale::Linear, 1.0, 1.0 + f64::EPSILON),
        (Scale::Logarithmic, 0.0, 1.0),
        (Scale::Logarithmic, -1.0, 1.0),
    ] {
        let axis = Axis { label: "the axis".to_owned(), scale, range: Some((lower, upper)) };
        for figure in [Figure::new(axis.clone(), Axis::linear("")), Figure::new(Axis::linear(""), axis)] {
            assert!(matches!(plot::svg(&figure), Err(PlotError::UnusableRange { .. })), "{lower} to {upper}");
            assert!(matches!(plot::png(&figure), Err(PlotError::UnusableRange { .. })));
        }
    }
}

#[test]
fn the_widest_ranges_are_drawn() {
    let points = vec![(1e-300, 1e-300), (1e-150, 1e300), (1.0, 1.0), (1e300, 1e300)];
    let logarithmic = plot::svg(&both(Scale::Logarithmic).with_curve(Curve::new("", points.clone()))).unwrap();
    assert_sound(&logarithmic);
    assert!(texts(groups(&logarithmic, "horizontal axis")[0]).contains(&"10−300".to_owned()));
    let whole = vec![(-f64::MAX, -f64::MAX), (f64::MAX, f64::MAX)];
    let subnormal = vec![(0.0, 0.0), (5e-324, 1e-320)];
    let rounding = vec![(1e300, 1.0), (1e300 * (1.0 + 1e-15), 2.0)];
    for points in [points, whole, subnormal, rounding] {
        let svg = plot::svg(&both(Scale::Linear).with_curve(Curve::new("", points))).unwrap();
        assert_sound(&svg);
        assert!(texts(groups(&svg, "horizontal axis")[0]).len() >= 2, "an axis without numbers says nothing");
    }
}

#[test]
fn a_tiny_range_on_a_large_number_is_readable() {
    let points = (0..20).map(|i| (f64::from(i), 3.0 + 1e-8 * f64::from(i))).collect();
    let svg = plot::svg(&both(Scale::Linear).with_curve(Curve::new("", points))).unwrap();
    let labels = texts(groups(&svg, "vertical axis")[0]);
    assert!(labels.iter().any(|label| label.contains("×10−7 + 3")), "{labels:?}");
    assert!(labels.iter().filter(|label| !label.contains('+')).all(|label| label.chars().count() <= 5), "{labels:?}");
}

#[test]
fn numbers_on_an_axis_never_touch() {
    // Every label needs at least its own width; digits are 0.64 em wide, indices 0.46 em: the latter is a lower bound for all.
    for (lower, upper) in [(1e-12, 1e12), (1e-3, 1e5), (1.0, 9.0), (1e-300, 1e300), (0.99, 1.01), (3.0, 40.0), (1e-7, 2e-7)] {
        for scale in [Scale::Linear, Scale::Logarithmic] {
            let axis = Axis { label: String::new(), scale, range: Some((lower, upper)) };
            let svg = plot::svg(&Figure::new(axis, Axis::linear(""))).unwrap();
            let group = groups(&svg, "horizontal axis")[0];
            let places: Vec<f64> = attributes(group, "x").into_iter().map(|x| x.parse().unwrap()).collect();
            let widths: Vec<f64> = texts(group).iter().map(|text| 0.46 * 70.0 * text.chars().count() as f64).collect();
            assert!((2..=9).contains(&places.len()), "{lower} to {upper}: {:?}", texts(group));
            for index in 1..places.len() {
                let clear = places[index] - places[index - 1] - 0.5 * (widths[index] + widths[index - 1]);
                assert!(clear > 0.0, "{lower} to {upper}: {:?}", texts(group));
            }
        }
    }
}

#[test]
fn the_automatic_legend_touches_no_curve() {
    let straight = |from: (f64, f64), to: (f64, f64)| Curve::new("curve", vec![from, to]).with_line(Line::Solid);
    let square = || Figure::new(Axis::linear("").with_range(0.0, 1.0), Axis::linear("").with_range(0.0, 1.0));
    // A rising line leaves the upper left free; a dozen level lines leave nothing inside.
    let rising = square().with_curve(straight((0.0, 0.0), (1.0, 1.0)));
    let level = (0..12).map(|line| f64::from(line) / 11.0);
    let ruled = level.fold(square(), |figure, height| figure.with_curve(straight((0.0, height), (1.0, height))));
    for (figure, inside) in [(rising, true), (ruled.clone(), false)] {
        let svg = plot::svg(&figure).unwrap();
        let [left, top, right, bottom] = frame(&svg);
        let legend = strokes(groups(&svg, "legend")[0]);
        let within = legend.iter().flatten().all(|(x, y)| *x > left && *x < right && *y > top && *y < bottom);
        assert_eq!(within, inside);
        assert!(inside || legend.iter().flatten().all(|(_, y)| *y > bottom));
    }
    assert!(groups(&plot::svg(&ruled.with_legend(LegendPlace::Hidden)).unwrap(), "legend").is_empty());
}

#[test]
fn labels_are_escaped_and_typeset() {
    let figure = Figure::new(Axis::linear(r"$\Delta\gamma/E_\infty$ < 10³ & more"), Axis::linear("a \u{0}\u{e000}0\u{e001} $ b"))
        .with_title("\"<script>\" $x^{{{{{{{{{{{y}}}}}}}}}}}$ \\$ $\\unknown{")
        .with_curve(Curve::new("</text>", vec![(0.0, 0.0), (1.0, 1.0)]));
    let svg = plot::svg(&figure).unwrap();
    assert_sound(&svg);
    assert!(!svg.contains("<script>") && svg.contains("&lt;/text&gt;"));
    let written = texts(&svg);
    assert!(written.iter().any(|text| text == "Δγ/E∞ &lt; 103 &amp; more"), "{written:?}");
    assert!(svg.contains(r#"font-style="italic">γ</tspan>"#));
    assert!(plot::png(&figure).is_ok());
}

/// An image of a PNG file in red, green and blue, with the pixels in a metre.
struct Image {
    width: usize,
    height: usize,
    per_metre: u32,
    pixels: Vec<[u8; 3]>,
}

fn read(file: &[u8]) -> Image {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let density = reader.info().pixel_dims.unwrap();
    assert!(density.xppu == density.yppu && density.unit == png::Unit::Meter);
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
    let pixels = bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    Image { width: info.width as usize, height: info.height as usize, per_metre: density.xppu, pixels }
}

impl Image {
    /// How black the part of the image is, in whole pixels: columns and rows from, to, in tenths of a point.
    fn ink(&self, columns: [f64; 2], rows: [f64; 2]) -> f64 {
        let pixel = |units: f64| (units / 720.0 * 400.0).round() as usize;
        let row = |y: usize| &self.pixels[y * self.width..(y + 1) * self.width];
        let inside =
            (pixel(rows[0])..pixel(rows[1]).min(self.height)).flat_map(|y| &row(y)[pixel(columns[0])..pixel(columns[1]).min(self.width)]);
        inside.map(|[red, green, blue]| 1.0 - (f64::from(*red) + f64::from(*green) + f64::from(*blue)) / 765.0).sum()
    }
}

#[test]
fn a_picture_has_the_announced_size_and_density() {
    // 88 mm and 180 mm at 400 dots per inch, 15748 in a metre; the last, incomplete pixel does not count.
    let few = both(Scale::Linear).with_curve(Curve::new("", vec![(0.0, 0.0), (1.0, 1.0)]));
    for figure in [family(), few] {
        for (width, across) in [(Width::OneColumn, 1385), (Width::TwoColumns, 2834)] {
            let figure = figure.clone().with_width(width);
            let image = read(&plot::png(&figure).unwrap());
            let svg = plot::svg(&figure).unwrap();
            let tall: f64 = attributes(&svg, "viewBox")[0].split(' ').next_back().unwrap().parse().unwrap();
            assert_eq!((image.width, image.per_metre), (across, 15748));
            assert!((image.height as f64 - tall / 720.0 * 400.0).abs() < 1.0, "{} pixels for {tall} units", image.height);
        }
    }
}

#[test]
fn pixels_lie_where_the_vectors_do() {
    let axis = || Axis::linear("").with_range(0.0, 1.0);
    let figure = Figure::new(axis(), axis()).with_curve(Curve::new("", vec![(0.0, 0.5), (1.0, 0.5)]).with_line(Line::Solid).with_colour(2));
    let image = read(&plot::png(&figure).unwrap());
    let [left, top, right, bottom] = frame(&plot::svg(&figure).unwrap());
    let (middle, inner) = (0.5 * (top + bottom), [left + 100.0, right - 100.0]);
    // A stroke 1.2 points or 6.7 pixels wide along the middle, its edges drawn to a quarter of a pixel, and nothing beside it.
    let expected = (inner[1] - inner[0]) * 12.0 * (400.0_f64 / 720.0).powi(2);
    assert!((image.ink(inner, [middle - 20.0, middle + 20.0]) / expected - 1.0).abs() < 0.04);
    assert_eq!(image.ink(inner, [top + 60.0, middle - 20.0]) + image.ink(inner, [middle + 20.0, bottom - 60.0]), 0.0);
}

#[test]
fn text_leaves_ink_level_and_turned() {
    let figure = |across: &str, up: &str| {
        let axis = |label: &str| Axis::linear(label).with_range(0.0, 1.0);
        Figure::new(axis(across), axis(up)).with_curve(Curve::new("", vec![(0.0, 0.0), (1.0, 1.0)]))
    };
    let ink = |figure: &Figure| {
        let image = read(&plot::png(figure).unwrap());
        let [left, top, _, bottom] = frame(&plot::svg(figure).unwrap());
        let (width, height) = (image.width as f64 * 1.8, image.height as f64 * 1.8);
        // Left of the numbers of the vertical axis, and below those of the horizontal one.
        (image.ink([0.0, left - 180.0], [top, bottom]), image.ink([left, width], [bottom + 120.0, height]))
    };
    let (turned, level) = ink(&figure("abc", "abc"));
    assert!(level > 200.0 && (turned / level - 1.0).abs() < 0.02, "{level} level, {turned} turned");
    // Letters, Greek, accents and indices each add to it; so does a box for a character that the font does not have.
    for more in [r"$\gamma$", r"$E_\infty$", "$x^2$", r"$\dot{a}$", "č", "ж", "\u{4e2d}", "\u{1f600}"] {
        let with_more = ink(&figure(&format!("abc{more}"), "abc")).1;
        assert!(with_more > level + 20.0, "{more}: {level}, {with_more}");
    }
    assert_ne!(plot::png(&figure("$v$", "")), plot::png(&figure("v", "")), "symbols are slanted");
    let bare = ink(&figure(r"$a$", "abc")).1;
    for accent in ["\u{302}", "\u{323}"] {
        assert!(ink(&figure(&format!("$a{accent}$"), "abc")).1 > bare + 3.0);
    }
}

#[test]
fn unknown_characters_and_lone_accents_are_drawn() {
    for label in
        ["\u{4e2d}\u{6587}", "\u{1f600}", "\u{301}", "$\u{302}$", "\u{36f}a\u{36f}", "a\u{200b}b", "\u{5d0}\u{10ffff}", " \u{303} "]
    {
        let figure = Figure::new(Axis::linear(label), Axis::logarithmic(label)).with_title(label);
        let figure = figure.with_curve(Curve::new(label, vec![(1.0, 1.0), (2.0, 2.0)]));
        assert!(plot::png(&figure).is_ok(), "{label}");
        assert_sound(&plot::svg(&figure).unwrap());
    }
}

proptest! {
    #[test]
    fn no_figure_panics(
        points in prop::collection::vec((prop::num::f64::ANY, prop::num::f64::ANY), 0..40),
        more in prop::collection::vec((-1e3..1e3_f64, -1e3..1e3_f64), 0..40),
        ranges in (prop::option::of((prop::num::f64::ANY, prop::num::f64::ANY)), prop::option::of((-10.0..10.0_f64, -10.0..10.0_f64))),
        logarithmic in (any::<bool>(), any::<bool>()),
        label in r"(\PC|[$^_{}\\]){0,12}",
    ) {
        let scale = |logarithmic| if logarithmic { Scale::Logarithmic } else { Scale::Linear };
        let figure = Figure::new(
            Axis { label: label.clone(), scale: scale(logarithmic.0), range: ranges.0 },
            Axis { label: format!("${label}$"), scale: scale(logarithmic.1), range: ranges.1 },
        )
        .with_curve(Curve::new(label.clone(), points))
        .with_curve(Curve::new(format!("$x_{label}"), more).with_sparse_marker(Marker::OpenDiamond).with_line(Line::Dotted));
        if let Ok(svg) = plot::svg(&figure) {
            assert_sound(&svg);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_label_panics(label in r"(\PC|[$^_{}\\]){0,12}") {
        let curve = Curve::new(label.clone(), vec![(-1.0, 2.0), (3.0, 1e3)]).with_sparse_marker(Marker::OpenCircle).with_line(Line::DashDotted);
        let figure = Figure::new(Axis::linear(format!("${label}$")), Axis::linear(label.clone())).with_curve(curve);
        prop_assert!(plot::png(&figure).is_ok());
    }
}

/// A map draws a cell for each value that there is, and a scale of colours; a note stands under the picture.
#[test]
fn a_map_has_a_cell_for_each_value() {
    let mut figure = Figure::new(Axis::logarithmic("speed $v$ (m/s)"), Axis::linear("work (J/m²)"));
    let values = vec![1.0, 10.0, f64::NAN, 100.0, 1e3, 1e4];
    figure.map = Some(Map { across: vec![1e-3, 1e-2, 1e-1], up: vec![1.0, 2.0], values, colours: Axis::logarithmic("$G$ (J/m²)") });
    figure.add_note("white: no value");
    figure.add_note("6 of 60 states are drawn");
    let svg = plot::svg(&figure).unwrap();
    let map = groups(&svg, "map")[0];
    assert_eq!(dots(map), 5, "an empty cell is left white");
    // Every colour is another one, and lighter the larger its value is: in grey print too.
    let lightness: Vec<f64> = attributes(map, "fill")
        .into_iter()
        .map(|fill| {
            let part = |from: usize| f64::from(u8::from_str_radix(&fill[from..from + 2], 16).unwrap());
            0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
        })
        .collect();
    assert!(lightness.windows(2).all(|pair| pair[1] > pair[0] + 10.0), "{lightness:?}");
    let written = texts(&svg);
    assert!(written.iter().any(|text| text == "white: no value; 6 of 60 states are drawn"), "{written:?}");
    assert!(written.iter().any(|text| text == "G (J/m2)"), "{written:?}");
    assert!(plot::png(&figure).is_ok());
}

/// Curves in order go from dark to light evenly, however many there are.
#[test]
fn ordered_curves_go_from_dark_to_light() {
    for count in [3, 7, 10] {
        let mut figure = Figure::new(Axis::linear("x"), Axis::linear("y"));
        for place in 0..count {
            let y = place as f64;
            let curve = Curve::new("", vec![(0.0, y), (1.0, y)]).with_line(Line::Solid).with(Colour::Sequence { place, of: count });
            figure = figure.with_curve(curve);
        }
        let svg = plot::svg(&figure).unwrap();
        let lightness: Vec<f64> = groups(&svg, "curve")
            .into_iter()
            .map(|group| {
                let stroke = attributes(group, "stroke")[0];
                let part = |from: usize| f64::from(u8::from_str_radix(&stroke[from..from + 2], 16).unwrap());
                0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
            })
            .collect();
        let steps: Vec<f64> = lightness.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(steps.iter().all(|step| *step > 60.0 / count as f64), "{lightness:?}");
        assert!(lightness.iter().all(|light| *light < 200.0), "no curve is lost on white paper: {lightness:?}");
    }
}

/// A measured curve with its residuals, in millionths of one.
fn with_residuals(points: Vec<(f64, f64)>, root: Option<f64>, determination: Option<f64>) -> Figure {
    let measured = Curve::new("measured", vec![(1.0, 1e-4), (3.0, 2e-4)]).with_line(Line::None).with_marker(Marker::OpenCircle);
    Figure::new(Axis::linear("time $t$ (s)"), Axis::linear("force (N)")).with_curve(measured).with_residuals(Residuals {
        vertical: Axis::linear("residual (N)"),
        points,
        marker: Marker::Point,
        colour: Colour::Index(1),
        root_mean_square: root,
        determination,
    })
}

/// Residuals stand in a frame of their own below the curves, a quarter of both high, over the same places, about a line at zero.
#[test]
fn residuals_stand_below_the_curves() {
    let svg = plot::svg(&with_residuals(vec![(1.0, -2e-6), (2.0, 0.0), (3.0, 2e-6), (4.0, 1e-6)], Some(1.5e-6), Some(0.9876))).unwrap();
    assert_sound(&svg);
    let (above, below) = (frame(&svg), frame(&svg[svg.find(r#"<g class="residuals""#).unwrap()..]));
    assert!((above[0] - below[0]).abs() < 0.1 && (above[2] - below[2]).abs() < 0.1 && below[1] > above[3]);
    assert!(((below[3] - below[1]) / (below[3] - below[1] + above[3] - above[1]) - 0.25).abs() < 0.01);
    // The horizontal axis has its numbers and its label once, below both; it reaches as far as the residuals do.
    let texts = texts(&svg);
    for once in ["time t (s)", "3.5", "4.0"] {
        assert_eq!(texts.iter().filter(|text| *text == once).count(), 1, "{once}: {texts:?}");
    }
    assert!(texts.iter().any(|text| text.contains("RMS 1.50×10−6 N") && text.contains("R2 = 0.98760")), "{texts:?}");
    // The second point lies on the line at zero, the others as far from it as they are large.
    let curve = groups(&svg[svg.find(r#"<g class="residuals""#).unwrap()..], "curve")[0];
    let heights: Vec<f64> = attributes(curve, "d").iter().map(|data| middle(data).1).collect();
    assert_eq!(heights.len(), 4);
    let (down, up) = (heights[0] - heights[1], heights[1] - heights[2]);
    assert!(down > 0.0 && (down / up - 1.0).abs() < 0.01 && ((heights[1] - heights[3]) / up - 0.5).abs() < 0.01, "{heights:?}");
    let zero = strokes(&svg)
        .into_iter()
        .filter(|line| line.len() == 2 && (line[0].1 - heights[1]).abs() < 0.1 && (line[1].1 - heights[1]).abs() < 0.1);
    assert!(zero.into_iter().any(|line| (line[1].0 - line[0].0 - below[2] + below[0]).abs() < 0.1), "no line at zero");
}

/// The middle of the corners of a closed path.
fn middle(data: &str) -> (f64, f64) {
    let numbers: Vec<f64> = data.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let (mut across, mut down, count) = (0.0, 0.0, (numbers.len() / 2) as f64);
    for pair in numbers.chunks_exact(2) {
        across += pair[0] / count;
        down += pair[1] / count;
    }
    (across, down)
}

/// Residuals of any size are drawn; without a number among them there is no lower frame, and nothing is claimed of a curve that is met exactly.
#[test]
fn residuals_of_any_size_are_drawn() {
    for size in [1e-300, 1e-12, 1.0, 1e12, 1e300, f64::MAX] {
        let svg = plot::svg(&with_residuals(vec![(1.0, -size), (2.0, f64::NAN), (3.0, size)], Some(size), Some(-size))).unwrap();
        assert_sound(&svg);
        assert_eq!(groups(&svg, "frame").len(), 2, "{size:e}");
    }
    let none = plot::svg(&with_residuals(vec![(1.0, f64::NAN)], None, None)).unwrap();
    assert_eq!(groups(&none, "frame").len(), 1);
    let exact = texts(&plot::svg(&with_residuals(vec![(1.0, 0.0)], Some(0.0), Some(1.0 - 1e-9))).unwrap());
    assert!(exact.iter().any(|text| text.contains("RMS 0 N") && text.contains("R2 &gt; 0.99999")), "{exact:?}");
}
