//! Vectors: the marks of a page are written as an SVG document, in tenths of a point.

use super::{
    canvas::{Anchor, Mark, Page, Point, UNITS, Writing},
    label::{self, Run},
    style::{self, Rgb},
};

/// SVG readers drop an ordinary space at the edge of a `<tspan>`; librsvg 2.54 drops this one as well unless the document asks it to preserve space.
const NO_BREAK_SPACE: &str = "\u{a0}";

/// The page as an SVG document.
pub(super) fn svg(page: &Page, title: Option<&str>) -> String {
    let millimetres = |length: f64| number(length / style::POINTS_PER_MILLIMETRE);
    let mut document = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}mm" height="{}mm" viewBox="0 0 {} {}" font-family="{}" fill="black" stroke-linejoin="round" xml:space="preserve">"#,
        millimetres(page.width),
        millimetres(page.height),
        (page.width * UNITS).round(),
        (page.height * UNITS).round(),
        style::FONT_FAMILY,
    );
    document.push('\n');
    if let Some(title) = title {
        let text: String = label::parse(title).iter().map(|run| escaped(&run.text)).collect();
        line(&mut document, 1, &format!("<title>{text}</title>"));
    }
    line(&mut document, 1, BACKGROUND);
    let mut depth = 1_usize;
    for mark in &page.marks {
        match mark {
            Mark::GroupOpens(class) => {
                // Cells that touch are filled to whole pixels: softened edges would show as lines between them.
                let crisp = if matches!(*class, "map" | "colours") { r#" shape-rendering="crispEdges""# } else { "" };
                line(&mut document, depth, &format!(r#"<g class="{class}"{crisp}>"#));
                depth += 1;
            }
            Mark::GroupCloses => {
                depth = depth.saturating_sub(1);
                line(&mut document, depth, "</g>");
            }
            Mark::Line { points, closed, colour, width, dashes } => {
                let mut attributes = format!(r#"stroke="{}" stroke-width="{}" fill="none""#, hexadecimal(*colour), number(width * UNITS));
                if !dashes.is_empty() {
                    let pattern: Vec<String> = dashes.iter().map(|length| number(length * UNITS)).collect();
                    attributes.push_str(&format!(r#" stroke-dasharray="{}""#, pattern.join(" ")));
                }
                line(&mut document, depth, &format!(r#"<path d="{}" {attributes} />"#, path_data(points, *closed)));
            }
            Mark::Area { corners, colour } => {
                let attributes = format!(r#"stroke="none" stroke-width="0" fill="{}""#, hexadecimal(*colour));
                line(&mut document, depth, &format!(r#"<path d="{}" {attributes} />"#, path_data(corners, true)));
            }
            Mark::Text(writing) => line(&mut document, depth, &text(writing)),
        }
    }
    document.push_str("</svg>\n");
    document
}

/// The paper of the document.
pub(super) const BACKGROUND: &str = r#"<rect width="100%" height="100%" fill="white" />"#;

fn line(document: &mut String, depth: usize, element: &str) {
    document.extend(std::iter::repeat_n("  ", depth));
    document.push_str(element);
    document.push('\n');
}

/// A colour as `#rrggbb`.
pub(super) fn hexadecimal((red, green, blue): Rgb) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Text as XML wants it, between tags and in attributes.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Two decimals, without trailing zeros.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

fn path_data(points: &[Point], closed: bool) -> String {
    let mut data = String::with_capacity(16 * points.len());
    for (index, (x, y)) in points.iter().enumerate() {
        data.push_str(if index == 0 { "M " } else { " L " });
        data.push_str(&number(x * UNITS));
        data.push(' ');
        data.push_str(&number(y * UNITS));
    }
    if closed {
        data.push_str(" Z");
    }
    data
}

/// Text is placed on whole units, and its sizes are whole units.
fn text(writing: &Writing) -> String {
    let (x, y) = (number((writing.at.0 * UNITS).round()), number((writing.at.1 * UNITS).round()));
    let anchor = match writing.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let turn = if writing.upwards { format!(r#" transform="rotate(-90,{x},{y})""#) } else { String::new() };
    let (size, spans) = (whole_units(writing.size), text_spans(&writing.runs, writing.size));
    format!(r#"<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}"{turn}>{spans}</text>"#)
}

fn whole_units(size: f64) -> u32 {
    (size * UNITS).round().clamp(1.0, 1e4) as u32
}

fn text_spans(runs: &[Run], size: f64) -> String {
    let mut height = 0.0;
    let mut spans = String::new();
    for run in runs {
        let rise = run.rise * size * UNITS;
        let step = number(height - rise);
        height = rise;
        let mut attributes = String::new();
        if step != "0" {
            attributes.push_str(&format!(r#" dy="{step}""#));
        }
        if run.size < 1.0 {
            attributes.push_str(&format!(r#" font-size="{}""#, whole_units(size * run.size)));
        }
        if run.slanted {
            attributes.push_str(r#" font-style="italic""#);
        }
        spans.push_str(&format!("<tspan{attributes}>{}</tspan>", escaped(&run.text.replace(' ', NO_BREAK_SPACE))));
    }
    spans
}
