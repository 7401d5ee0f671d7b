//! Source: `studies::effects`; the README's "a table that is absent is an effect that is not simulated".
//!
//! Goal: the study sees an effect that changes something, and one that costs nothing although it should; its neutral effects change nothing; a thick layer is a
//! half-plane, to the bit, and a thinner one is not.
//!
//! Parameters: three of its effects.
//!
//! Oracle: the scenes themselves, and the same with an effect that is not neutral.
//!
//! Tolerance: as each effect states.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack_verification::studies::effects::scenes::{Effect, effects};
use viscotack_verification::studies::effects::{cheaper, difference, equal, layer, solved};

fn named(name: &str) -> Effect {
    effects().into_iter().find(|effect| effect.name == name).unwrap()
}

fn assessed(effect: &Effect) -> (bool, bool) {
    let (with, without) = (solved(&effect.with, 1).unwrap().0, solved(&effect.without, 1).unwrap().0);
    let (off, compared) = difference(effect, &with, &without);
    println!("{}: {off:e} of {compared}; {} | {}", effect.name, with.work(), without.work());
    (equal(effect.tolerance, off, compared), cheaper(effect, with.work(), without.work()))
}

#[test]
fn neutral_effects_change_nothing_and_others_are_seen() {
    for (name, neutral, real) in [
        ("one more relaxation term (steady crack)", "fraction = 1e-12", "fraction = 1e-3"),
        ("an elastic counter body (sliding)", "modulus = 1e19", "modulus = 1e8"),
        ("fields (steady crack)", "points = 30", "points = 31"),
    ] {
        let effect = named(name);
        assert_eq!(assessed(&effect), (true, true), "{name}");
        assert!(effect.with.contains(neutral), "{name}");
        let changed = Effect { with: effect.with.replace("0.999999999999", "0.999").replace(neutral, real), ..effect.clone() };
        assert_eq!(assessed(&changed).0, name.starts_with("fields"), "{name}");
    }
}

#[test]
fn an_effect_that_costs_nothing_is_seen() {
    let effect = named("fields (steady crack)");
    let idle = Effect { with: effect.without.clone(), ..effect };
    assert_eq!(assessed(&idle), (true, false));
}

#[test]
fn every_effect_has_two_scenes() {
    let all = effects();
    assert!(all.len() >= 20);
    // A piece that is not in its scene would leave the effect as it was, and the comparison without one.
    for effect in all {
        assert!(effect.with != effect.without, "{}", effect.name);
    }
}

#[test]
fn values_that_are_not_there_are_no_agreement() {
    let effect = Effect { columns: &["no such column"], ..named("fields (steady crack)") };
    assert!(!assessed(&effect).0);
}

#[test]
fn a_thick_layer_is_a_half_plane_and_a_thinner_one_is_not() {
    let thick = layer::compared(layer::THICK, 1).unwrap();
    assert!(thick.values > 1000 && thick.difference.to_bits() == 0.0_f64.to_bits(), "{thick:?}");
    assert!(thick.evaluations[1] < thick.evaluations[0], "{thick:?}");
    // A = 4(kd)²e^{−2kd} = 0.0045, of a kernel of order one.
    let thinner = layer::compared(5.0, 1).unwrap();
    assert!((1e-4..1e-2).contains(&thinner.difference), "{thinner:?}");
    assert!(thinner.evaluations[0] > thick.evaluations[0] && thinner.evaluations[1] == thick.evaluations[1]);
    assert!(layer::compared(0.0, 1).is_err());
}
