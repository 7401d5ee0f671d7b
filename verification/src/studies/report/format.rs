//! Words and numbers as a page shows them.

/// For text and attributes of HTML.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A label of a plot without its mathematics.
pub(super) fn plain(label: &str) -> String {
    let mut text = label.replace("\\mathrm", "").replace("\\bar{p}", "p̄");
    for (command, letter) in [
        ("\\delta", "δ"),
        ("\\zeta", "ζ"),
        ("\\Gamma", "Γ"),
        ("\\Delta", "Δ"),
        ("\\gamma", "γ"),
        ("\\beta", "β"),
        ("\\tau", "τ"),
        ("\\infty", "∞"),
        ("\\pi", "π"),
    ] {
        text = text.replace(command, letter);
    }
    text.replace(['$', '\\', '{', '}'], "")
}

/// Four digits, powers of ten raised, minus signs as such.
pub(super) fn number(value: f64) -> String {
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
pub(super) fn duration(seconds: f64) -> String {
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
