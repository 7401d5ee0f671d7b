//! The SVG of a figure as a part of an HTML page: it takes the width of its place, and its ink, paper and colours from the page.
//!
//! | in the picture | on the page |
//! |---|---|
//! | ink | `currentColor` |
//! | paper, as inside open markers | `var(--paper)`; the page behind the picture shows through |
//! | the colour of index n | `var(--curve-n)`, see [`palette`] |
//! | a stroke of another colour | mixed with `var(--ink)` by `var(--lift)` |

use super::{
    style,
    vector::{BACKGROUND, escaped, hexadecimal},
};

/// The colours of curves on white paper, as `#rrggbb`, by index: what a page sets `--curve-n` to where it is light.
pub(super) fn palette() -> Vec<String> {
    style::PALETTE.iter().map(|colour| hexadecimal(*colour)).collect()
}

/// Turns a document of this room into such a part, described by `label` for readers that do not see it.
pub(super) fn inline(document: &str, label: &str) -> String {
    let mut text = document.to_owned();
    // The head gives a size in millimetres and a namespace; a page wants neither.
    if let Some((head, body)) = document.split_once('>') {
        let attribute = |name: &str| {
            let (_, rest) = head.split_once(&format!(" {name}=\""))?;
            rest.split_once('"').map(|(value, _)| value)
        };
        text = format!(
            r#"<svg class="plot" role="img" aria-label="{}" viewBox="{}" font-family="{}" fill="currentColor" stroke-linejoin="round" xml:space="preserve">{body}"#,
            escaped(label),
            attribute("viewBox").unwrap_or("0 0 1 1"),
            attribute("font-family").unwrap_or("sans-serif"),
        );
    }
    text = text.replace(BACKGROUND, "");
    text = text.replace(&format!("\"{}\"", hexadecimal(style::PAPER)), "\"var(--paper)\"");
    for (index, colour) in style::PALETTE.iter().enumerate() {
        let themed = if *colour == style::INK { "currentColor".to_owned() } else { format!("var(--curve-{index})") };
        text = text.replace(&format!("\"{}\"", hexadecimal(*colour)), &format!("\"{themed}\""));
    }
    lifted(&text)
}

/// Strokes of other colours, as those of a sequence, are mixed with ink by the page's `--lift`: the darkest would be lost on a dark page.
fn lifted(text: &str) -> String {
    const STROKE: &str = " stroke=\"#";
    let mut parts = text.split(STROKE);
    let mut whole = parts.next().unwrap_or("").to_owned();
    for part in parts {
        whole.push_str(STROKE);
        match part.split_once('"') {
            Some((colour, rest)) => {
                whole.push_str(&format!("{colour}\" style=\"stroke:color-mix(in srgb,#{colour},var(--ink) var(--lift))\"{rest}"));
            }
            None => whole.push_str(part),
        }
    }
    whole
}
