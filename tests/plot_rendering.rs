//! Source: the contract of `viscotack::outcome::plot` (its module documentation).
//! Goal: a plot shows the data and nothing else: gaps are gaps, equal ratios are equal distances, the same figure gives the same bytes, odd input
//! gives an honest picture or a typed error.
//! Oracle: the SVG text itself, read back here: the strokes of the groups of class `curve`, in tenths of a point.
//! Tolerance: 0.02 units (two decimals are written, each rounded by at most 0.005).
#![cfg(feature = "plots")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::float_cmp)]

use proptest::prelude::*;
use viscotack::outcome::plot::{self, Axis, Curve, Figure, LegendPlace, Line, Marker, PlotError, Scale, Width};

const ROUNDING: f64 = 0.02;

/// The inside of every group of this class.
fn groups<'svg>(svg: &'svg str, class: &str) -> Vec<&'svg str> {
    let opening = format!(r#"<g class="{class}">"#);
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

#[test]
fn a_png_is_an_image_of_the_announced_width() {
    // 88 mm and 180 mm at 400 dots per inch.
    for (width, pixels) in [(Width::OneColumn, 1385_u32), (Width::TwoColumns, 2834)] {
        let image = plot::png(&family().with_width(width)).unwrap();
        assert_eq!(&image[..8], b"\x89PNG\r\n\x1a\n");
        let announced = u32::from_be_bytes(image[16..20].try_into().unwrap());
        assert!(announced.abs_diff(pixels) <= 1, "{announced}");
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
