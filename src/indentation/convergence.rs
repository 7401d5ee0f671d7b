//! What is left of the error of a number, shown by integrations that are tighter than the one that it is of.
//!
//! The steps of an integration follow its own errors, so that two integrations take different ones and the errors of single numbers scatter, through zero as well: no
//! integration can tell from looser ones how far off it happens to be. Tighter ones can. The number is that of an integration with two behind it, a hundred times
//! tighter in all ([`TIGHTER`]): its change to the finest is its error but for that of the finest, which is a hundredth as large as a rule. What the finest errs by is
//! guessed from how far every other integration is off from it, over how much looser that one was; the largest guess counts [`SAFETY_FACTOR`] times.

/// Each integration is tighter than the one before by this.
pub(super) const TIGHTER: f64 = 0.1;
/// Integrations behind the one whose numbers are reported.
pub(super) const BEHIND: usize = 2;
/// Integrations that are compared, at most: one looser, should the accuracy need it, the one whose numbers are reported, and those behind it.
pub(super) const COMPARED: usize = BEHIND + 2;
/// Error of a number of the finest integration, at most, over the largest guess of it. Needed were 218 and 88 once each and 61 otherwise in 100 000 values of 360
/// random spheres at eleven tolerances.
const SAFETY_FACTOR: f64 = 300.0;

/// Error of a number of the finest path by panels, at most, over what is expected of it: the change of the one before to it, or of the looser one over one reduction
/// more, reduced again for every tenth of a tolerance to the finest but one. Errors swing through zero along a path, where all paths may agree: the changes are the
/// largest of the number and of its neighbours.
const OF_PANELS: f64 = 4.0;

/// The same of each integration that is compared, the finest first; none where there is none.
pub(super) type Compared<T> = [Option<T>; COMPARED];

/// Integrations by their tolerances, the finest first, and the place among them of the one whose numbers are reported.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ladder {
    pub(super) tolerances: Compared<f64>,
    pub(super) reported: usize,
    /// What the change between a looser path and the finest is over that of the one before, as observed over a whole history: of paths by panels.
    pub(super) reduction: Option<f64>,
}

impl Ladder {
    /// A bound on the error of the value reported; infinite where the integrations behind it do not have the value, or no other integration has.
    pub(super) fn error(&self, values: Compared<f64>) -> f64 {
        let (Some(finest), [Some(tightest), ..]) = (values[0], self.tolerances) else { return f64::INFINITY };
        let others = self.tolerances.iter().zip(values).enumerate().skip(1);
        let mut guess: Option<f64> = None;
        for (place, (tolerance, value)) in others {
            match (tolerance, value) {
                (Some(tolerance), Some(value)) => guess = Some(guess.unwrap_or(0.0).max(tightest / tolerance * (value - finest).abs())),
                _ if place <= self.reported => return f64::INFINITY,
                _ => {}
            }
        }
        let reported = values.get(self.reported).copied().flatten();
        let change = reported.map_or(f64::INFINITY, |value| (value - finest).abs());
        if self.reduction.is_some() {
            return change + self.of_finest(self.expected(&values).unwrap_or(f64::INFINITY));
        }
        guess.map_or(f64::INFINITY, |guess| change + SAFETY_FACTOR * guess)
    }

    /// What the neighbours of a number along a path by panels add to its bound; nothing to what is imposed, which is exact.
    pub(super) fn of_neighbours(&self, values: Compared<f64>, neighbours: [Compared<f64>; 2]) -> f64 {
        let Some(own) = self.expected(&values).filter(|own| *own > 0.0) else { return 0.0 };
        let most = neighbours.iter().filter_map(|neighbour| self.expected(neighbour)).fold(own, f64::max);
        self.of_finest(most - own)
    }

    /// Error of a number of the finest path by panels, by the change expected of the number reported.
    fn of_finest(&self, expected: f64) -> f64 {
        let [finest, reported] = [0, self.reported].map(|place| self.tolerances.get(place).copied().flatten().unwrap_or(1.0));
        let tenths = ((finest / reported).ln() / TIGHTER.ln() - 1.0).max(0.0);
        OF_PANELS * self.reduction.map_or(0.0, |reduction| reduction.powf(tenths)) * expected
    }

    /// Change of the number reported to the finest, or what that of a looser path makes one expect of it.
    fn expected(&self, values: &Compared<f64>) -> Option<f64> {
        let [finest, reported, looser] = [0, self.reported, self.reported + 1].map(|place| values.get(place).copied().flatten());
        let (finest, reported, looser, reduction) = (finest?, reported?, looser?, self.reduction?);
        Some((reported - finest).abs().max(reduction * (looser - finest).abs().max((looser - reported).abs())))
    }
}

#[cfg(test)]
#[allow(clippy::indexing_slicing)]
mod tests {
    use super::*;

    /// Three integrations at 1e-4, 1e-5 and 1e-6, the first reported.
    const LADDER: Ladder = Ladder { tolerances: [Some(1e-6), Some(1e-5), Some(1e-4), None], reported: 2, reduction: None };

    fn off(errors: [f64; 3]) -> f64 {
        LADDER.error([Some(1.0 + errors[0]), Some(1.0 + errors[1]), Some(1.0 + errors[2]), None])
    }

    #[test]
    fn errors_that_go_with_the_tolerance_have_a_bound_of_some_times_themselves() {
        let bar = off([1e-9, 1e-8, 1e-7]);
        // The change to the finest, 0.99e-7, and SAFETY_FACTOR times the guesses (1e-7 − 1e-9)/100 and (1e-8 − 1e-9)/10 of its error, of which the first is larger.
        assert!((bar - 0.99e-7 * (1.0 + SAFETY_FACTOR / 100.0)).abs() < 1e-13, "{bar:e}");
    }

    #[test]
    fn errors_that_are_small_by_accident_have_bounds() {
        // The one reported errs as the finest does, so that its change is nothing: the one in between tells.
        let bar = off([1e-9, 1e-8, 1e-9]);
        assert!((bar - SAFETY_FACTOR * 0.9e-9).abs() < 1e-14 && bar > 1e-9, "{bar:e}");
        // The one in between errs as the finest does: the change of the one reported is as large as it should be.
        assert!(off([1e-9, 1e-9, 1e-7]) > 1e-7);
    }

    /// A finest integration that errs by as much as the one reported, the other way.
    #[test]
    fn errors_that_do_not_fall_are_in_the_change() {
        let tight = Ladder { tolerances: [Some(1e-9), Some(1e-7), Some(1e-5), None], ..LADDER };
        assert!(tight.error([Some(1.0 - 1e-7), Some(1.0 - 1e-7), Some(1.0 + 1e-7), None]) > 2e-7);
    }

    /// Paths by panels at 1e-8, 1e-6 and 1e-5, the middle one given, of which each tenth of a tolerance takes half of the error.
    #[test]
    fn paths_that_agree_by_accident_have_the_bounds_of_their_neighbours() {
        let ladder = |finest| Ladder { tolerances: [Some(finest), Some(1e-6), Some(1e-5), None], reported: 1, reduction: Some(0.5) };
        let values = |errors: [f64; 3]| [Some(1.0 + errors[0]), Some(1.0 + errors[1]), Some(1.0 + errors[2]), None];
        let (agree, differ) = (values([1e-9, 1.1e-9, 0.9e-9]), values([0.0, 1e-8, 1e-8]));
        assert!(ladder(1e-8).error(agree) < 1e-9);
        // 4·½ of what the one beside changes by, beyond its own.
        let beside = ladder(1e-8).of_neighbours(agree, [differ, agree]);
        assert!((beside - 2.0 * (1e-8 - 1e-10)).abs() < 1e-14, "{beside:e}");
        // Where rounding allows a finest path of one tenth only, none of it is left out.
        let near = ladder(1e-7).of_neighbours(agree, [agree, differ]);
        assert!((near - 2.0 * beside).abs() < 1e-14, "{near:e}");
        // What is imposed is exact.
        assert_eq!(ladder(1e-8).of_neighbours(values([0.0; 3]), [differ, differ]).to_bits(), 0.0_f64.to_bits());
    }

    #[test]
    fn nothing_is_reported_without_the_integrations_behind() {
        let [fine, middle, reported] = [Some(1.0), Some(1.0), Some(1.0)];
        assert_eq!(LADDER.error([fine, middle, reported, None]).to_bits(), 0.0_f64.to_bits());
        for values in [[None, middle, reported, None], [fine, None, reported, None], [fine, middle, None, None]] {
            assert!(LADDER.error(values).is_infinite(), "{values:?}");
        }
        // The finest of all, by looser ones alone: one does.
        let finest = Ladder { reported: 0, ..LADDER };
        let bar = finest.error([Some(1.0), Some(1.0 + 1e-8), None, None]);
        assert!((bar - SAFETY_FACTOR * 1e-9).abs() < 1e-14, "{bar:e}");
        assert!(finest.error([Some(1.0), None, None, None]).is_infinite());
    }
}
