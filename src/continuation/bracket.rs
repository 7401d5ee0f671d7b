//! Where between two places a condition ceases to hold, by halves: for conditions, and for functions without a useful slope.

use std::convert::Infallible;

/// Halvings, at most: 53 lead from one to its last digit, and a place a hundred million times smaller than the bracket needs 27 more.
const MOST_HALVINGS: u32 = 80;

/// The two ends of a bracket, which may be in either order, closed in on the place where `is_before` ceases to hold.
///
/// That it holds at the first end and does not at the second is taken on trust. Ends with neighbouring numbers or after 80 halvings.
pub fn halved(bracket: [f64; 2], mut is_before: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(ends) = halved_if(bracket, |place| Ok::<bool, Infallible>(is_before(place)));
    ends
}

/// The same for a condition that may be refused.
///
/// # Errors
/// The first refusal.
pub fn halved_if<E>([mut before, mut after]: [f64; 2], mut is_before: impl FnMut(f64) -> Result<bool, E>) -> Result<[f64; 2], E> {
    for _ in 0..MOST_HALVINGS {
        let middle = 0.5 * (before + after);
        if middle.total_cmp(&before).is_eq() || middle.total_cmp(&after).is_eq() {
            break;
        }
        if is_before(middle)? {
            before = middle;
        } else {
            after = middle;
        }
    }
    Ok([before, after])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bracket_closes_on_neighbours_from_either_side() {
        let [low, high] = halved([1.0, 2.0], |x| x * x < 2.0);
        assert!(low * low < 2.0 && high * high >= 2.0 && high - low <= 2.0 * f64::EPSILON);
        let other_way = halved([2.0, 1.0], |x| x * x >= 2.0);
        assert_eq!(other_way.map(f64::to_bits), [high, low].map(f64::to_bits));
        assert_eq!(halved_if([0.0, 1.0], |_| Err("no")), Err("no"));
    }
}
