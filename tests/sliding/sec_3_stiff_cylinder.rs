//! Source: problem 197 of `verification/src/studies/held_contacts`: a cylinder far ahead of its contact (e = 3a) on a solid that is 521 times stiffer there than at rest.
//!
//! Goal: loads just below the largest one of a contact are solved, and loads above it are refused with that limit, however far above.
//! Oracle: the scan of the study, which finds the last contact at a load of 790.49955.
//! Tolerance: 1e-5 of the limit; the scan stops within 1e-7 of the half-width, the limit is where an edge loses its pull, by a curve of about six digits.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack::Refusal;
use viscotack::sliding::steady::{ReachedBy, SlidingControl, SlidingOutcome, SlidingProblem, steady_sliding_reached_by};
use viscotack_verification::studies::draw::Draw;
use viscotack_verification::studies::held_contacts::{SEED, draws::drawn};

const LIMIT: f64 = 790.499_55;

#[test]
fn the_largest_load_of_a_stiff_cylinder_is_the_same_from_everywhere() {
    let drawn = drawn(&mut Draw::of(SEED, 197)).unwrap();
    for reached_by in [ReachedBy::Loading, ReachedBy::Unloading] {
        for load in [700.0, 780.0, 790.0, 790.4, 790.6, 790.789_227_722, 793.221_350_291, 809.987_512_851] {
            let problem = SlidingProblem {
                rate: drawn.rate,
                indenter: drawn.indenter,
                adhesion: drawn.adhesion,
                work_by_speed: None,
                control: SlidingControl::MeanPressure(load),
                accuracy: 1e-6,
            };
            match steady_sliding_reached_by(&drawn.material, &problem, reached_by) {
                Ok(SlidingOutcome::Partial(_)) => assert!(load < LIMIT, "{load}"),
                Err(Refusal::NoSuchState { limit, .. }) => {
                    assert!(load > LIMIT && (limit / LIMIT - 1.0).abs() < 1e-5, "{load}: {limit}");
                }
                other => panic!("{load}: {other:?}"),
            }
        }
    }
}
