//! One page of HTML: head, style and words that all reports of this program share. No scripts, nothing from the net, light and dark.

use super::plot;
use std::fmt::Write as _;

const STYLE: &str = include_str!("style.css");

/// The beginning of a page, up to its open body.
#[must_use]
pub fn opened(title: &str) -> String {
    let colours: String = plot::curve_colours().iter().enumerate().fold(String::new(), |mut all, (index, colour)| {
        let _ = write!(all, "--curve-{index}:{colour};");
        all
    });
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n:root{{{colours}}}\n{STYLE}</style>\n</head>\n<body>\n",
        escaped(title)
    )
}

/// Its end, with a last line that says what made it.
#[must_use]
pub fn closed(stamp: &str) -> String {
    format!("<footer><p>{}</p></footer>\n</body>\n</html>\n", escaped(stamp))
}

/// For text and attributes of HTML.
#[must_use]
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Four digits, powers of ten raised, minus signs as such.
#[must_use]
pub fn number(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() { "none".to_owned() } else { format!("{}∞", if value < 0.0 { "−" } else { "" }) };
    }
    let size = value.abs();
    let whole = value.fract() == 0.0 && size < 1e7;
    let text = if whole {
        format!("{value:.0}")
    } else if (1e-2..1e5).contains(&size) {
        let decimals = (3 - size.log10().floor() as i32).clamp(0, 6) as usize;
        format!("{value:.decimals$}")
    } else {
        let scientific = format!("{value:.2e}");
        match scientific.split_once('e') {
            Some((digits, exponent)) => format!("{digits}·10{}", raised(exponent)),
            None => scientific,
        }
    };
    text.replace('-', "−")
}

fn raised(exponent: &str) -> String {
    let raise = |sign: char| match sign {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        digit => char::from_u32(digit as u32 - '4' as u32 + '⁴' as u32).unwrap_or(digit),
    };
    exponent.chars().map(raise).collect()
}

/// Seconds and minutes.
#[must_use]
pub fn duration(seconds: f64) -> String {
    if seconds < 60.0 { format!("{seconds:.1} s") } else { format!("{:.0} min {:.0} s", (seconds / 60.0).floor(), seconds % 60.0) }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short() {
        let shown = [
            (0.0, "0"),
            (12.0, "12"),
            (1.0 / 3.0, "0.3333"),
            (-1.5e-7, "−1.50·10⁻⁷"),
            (123.456, "123.5"),
            (4.56e12, "4.56·10¹²"),
            (1e5 + 0.5, "1.00·10⁵"),
        ];
        for (value, text) in shown {
            assert_eq!(number(value), text);
        }
    }
}
