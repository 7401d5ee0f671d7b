//! A law expanded over the times that a scene visits, where the scene does not say over which.

use crate::scene::typed::{ExpandedLaw, MaterialOrigin, Scene};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};
use viscotack::material::broad::{BroadLaw, Expansion, expand};

/// The expansions that were made last: a scene is planned before it is solved, and so is each state of a sweep.
static MADE: Mutex<VecDeque<Made>> = Mutex::new(VecDeque::new());
/// How many are kept.
const KEPT: usize = 16;

/// An expansion, or none that could be made, of a law over a range to an accuracy.
struct Made {
    of: (BroadLaw, [f64; 2], f64),
    expansion: Option<Expansion>,
}

/// The expansion of a law, made once; others that want one wait meanwhile.
fn expanded(law: &BroadLaw, range: [f64; 2], accuracy: f64) -> Option<Expansion> {
    let of = (*law, range, accuracy);
    let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = made.iter().find(|known| known.of == of) {
        return known.expansion.clone();
    }
    let expansion = expand(law, range, accuracy).ok();
    made.truncate(KEPT - 1);
    made.push_front(Made { of, expansion: expansion.clone() });
    expansion
}

/// Beyond the visited times, on both sides: what follows them by powers decays as fast.
const MARGIN: f64 = 10.0;

/// The scene with its law expanded as far as the visited times reach; none if it is already, or the scene names the range, or none can be made so
/// wide: its assessment then says so.
pub(in crate::plan) fn widened(scene: &Scene, visited: Option<[f64; 2]>) -> Option<Scene> {
    let MaterialOrigin::Law(law) = &scene.material.origin else { return None };
    let [from, to] = visited?;
    // The temperature moves the law along the times.
    let factor = scene.material.climate.as_ref().map_or(1.0, |climate| climate.factor);
    let [mut low, mut high] = law.range;
    // Whole decades, so that neighbouring states of a sweep share one expansion. An open end is kept by both limits of the law.
    if !law.stated[0] && to.is_finite() && factor / to < low {
        low = 10f64.powf((factor / (MARGIN * to)).log10().floor());
    }
    if !law.stated[1] && from > 0.0 && factor / from > high {
        high = 10f64.powf((factor * MARGIN / from).log10().ceil());
    }
    if low >= law.range[0] && high <= law.range[1] {
        return None;
    }
    let expansion = expanded(&law.law, [low, high], law.accuracy)?;
    let mut wide = scene.clone();
    wide.material.series = expansion.material.slowed(factor).ok()?;
    if let Some(climate) = &mut wide.material.climate {
        climate.at_reference = expansion.material.clone();
    }
    wide.material.origin = MaterialOrigin::Law(Arc::new(ExpandedLaw { range: [low, high], expansion, ..law.as_ref().clone() }));
    Some(wide)
}
