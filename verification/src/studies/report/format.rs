//! Labels of plots as tables show them.

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
