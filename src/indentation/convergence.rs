//! What is left of the error of a number, from its changes over three marches.
//!
//! The steps of a march follow its own errors, so that two marches take different ones and the errors of single numbers scatter: a small last change may be
//! an accident. The change before it, ten times as large by rights, is the witness: the last one counts as no less than a tenth of it. In regular marches the
//! finest is some eight times better than its last change, which pays for the scatter.

/// Each march is tighter than the one before by this.
pub(super) const TIGHTER: f64 = 0.1;

/// What is left of the error of a value, by those of the marches before, the newest first; infinite without any.
pub(super) fn left(value: f64, others: [Option<f64>; 2]) -> f64 {
    let last = others[0].map_or(f64::INFINITY, |other| (value - other).abs());
    let before = others[0].zip(others[1]).map_or(0.0, |(second, first)| (second - first).abs());
    last.max(TIGHTER * before)
}
