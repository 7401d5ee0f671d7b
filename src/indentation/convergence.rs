//! What is left of the error of a number, from its changes over the marches of a ladder.
//!
//! The steps of a march follow its own errors, so that two marches take different ones and the errors of single numbers scatter: a small last change may be
//! an accident. Errors go with the tolerance, so every march before is a witness: its change, over how much looser it was, is a guess of what is left, and the
//! largest guess counts. Where that is the guess of the last change, errors fall slower than the tolerance, and what is left is more than such guesses say: it counts
//! up to three times. Five marches, each √10 times tighter, tell more than three of ten: four witnesses, of which the nearest err nearly as the finest does.

/// Each march is tighter than the one before by this: √0.1.
pub(super) const TIGHTER: f64 = 0.316_227_766_016_837_94;
/// Marches before the finest that are heard.
pub(super) const WITNESSES: usize = 4;

/// What the guess of the last change counts at most, where it is twice the others or more (measured: of 18 000 values of a thousand random spheres one erred by more
/// than seven of the largest guess, by fourteen, and its last change was 1.8 times the others).
const NOT_FALLING: f64 = 3.0;

/// The same of each witness, the newest march first; none where there is none.
pub(super) type Witnesses<T> = [Option<T>; WITNESSES];

/// What is left of the error of a value, by those of the marches before; infinite without the last of them.
pub(super) fn left(value: f64, witnesses: Witnesses<f64>) -> f64 {
    if witnesses[0].is_none() {
        return f64::INFINITY;
    }
    let mut share = 1.0;
    let guesses = witnesses.map(|witness| {
        share *= TIGHTER;
        witness.map_or(0.0, |other| share * (value - other).abs())
    });
    let [newest, older @ ..] = guesses;
    let most = older.into_iter().fold(0.0, f64::max);
    // Errors that fall by r from march to march make the last change √10/(r + 1) times the guess before it.
    if newest > most { newest * (2.0 * newest / most - 1.0).min(NOT_FALLING) } else { most }
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
        // Errors that hardly fall make the last change the largest guess, which counts more.
        let slow = [Some(1.0 + 1.3e-3), Some(1.0 + 1.6e-3), Some(1.0 + 1.7e-3), Some(1.0 + 1.8e-3)];
        let (newest, before) = (shares[0] * 0.3e-3, shares[1] * 0.6e-3);
        assert!((left(finest, slow) - newest * (2.0 * newest / before - 1.0)).abs() < 1e-15);
        assert!((left(finest, [slow[0], Some(finest), None, None]) - 3.0 * newest).abs() < 1e-15);
        assert_eq!(left(finest, [Some(finest), None, None, None]).to_bits(), 0.0_f64.to_bits());
    }
}
