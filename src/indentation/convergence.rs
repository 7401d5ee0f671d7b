//! What is left of the error of a number, from its changes over the marches of a ladder.
//!
//! The steps of a march follow its own errors, so that two marches take different ones and the errors of single numbers scatter: a small last change may be
//! an accident. Errors go with the tolerance, so every march before is a witness: its change, over how much looser it was, is a guess of what is left, and the
//! largest guess counts. Five marches, each √10 times tighter, tell more than three of ten: four witnesses, of which the nearest err nearly as the finest does. (A last
//! change that is the largest guess, of errors that fall slower than the tolerance, was heard up to three times before: a larger factor over all guesses covers more
//! with bars as wide in the median, `verification/pages/named_gaps.md`.)

/// Each march is tighter than the one before by this: √0.1.
pub(super) const TIGHTER: f64 = 0.316_227_766_016_837_94;
/// Marches before the finest that are heard.
pub(super) const WITNESSES: usize = 4;

/// The same of each witness, the newest march first; none where there is none.
pub(super) type Witnesses<T> = [Option<T>; WITNESSES];

/// What is left of the error of a value, by those of the marches before; infinite without the last of them.
pub(super) fn left(value: f64, witnesses: Witnesses<f64>) -> f64 {
    if witnesses[0].is_none() {
        return f64::INFINITY;
    }
    let mut share = 1.0;
    witnesses
        .map(|witness| {
            share *= TIGHTER;
            witness.map_or(0.0, |other| share * (value - other).abs())
        })
        .into_iter()
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_that_go_with_the_tolerance_are_guessed_alike_by_every_witness() {
        // x = 1 + e·tolerance: each witness tells e·(1/share − 1)·share.
        let finest = 1.0 + 1e-3;
        let shares: [f64; WITNESSES] = std::array::from_fn(|k| TIGHTER.powi(k as i32 + 1));
        let witnesses = shares.map(|share| Some(1.0 + 1e-3 / share));
        assert!((left(finest, witnesses) - 1e-3 * (1.0 - shares[3])).abs() < 1e-15);
        // A last change that is small by accident is outvoted, an older one heard less.
        let mut accident = witnesses;
        accident[0] = Some(finest);
        assert!(left(finest, accident) > 0.8e-3);
        assert!(left(finest, [None; WITNESSES]).is_infinite());
        // Errors that hardly fall make the last change the largest guess.
        let slow = [Some(1.0 + 1.3e-3), Some(1.0 + 1.6e-3), Some(1.0 + 1.7e-3), Some(1.0 + 1.8e-3)];
        assert!((left(finest, slow) - shares[0] * 0.3e-3).abs() < 1e-15);
        assert_eq!(left(finest, [Some(finest), None, None, None]).to_bits(), 0.0_f64.to_bits());
    }
}
