//! Attraction beside a contact that does not deform it: Hertz's contact under the force F + 2πRΔγ (Derjaguin, Muller and Toporov, J. Colloid Interface Sci. 53
//! (1975) 314). It holds for stiff small spheres, Tabor numbers below about 0.1.
//!
//! A scene without adhesion is solved under controls that are moved by the attraction, and the attraction is taken off the forces that it gives.

use crate::plan::PathCurve;
use crate::scene::typed::{HistoryQuantity, HistorySegment, IndentationShape, Problem, Scene};
use std::f64::consts::PI;

/// The attraction of a scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Attraction {
    /// 2πRΔγ (N).
    force: f64,
    /// What it moves the far end of a frame by (m); zero without a frame.
    far_end: f64,
}

/// Takes adhesion out of a scene and moves its controls by 2πRΔγ.
pub(super) fn attracted(scene: &mut Scene, work: f64) -> Result<Attraction, String> {
    let Problem::Indentation(indentation) = &mut scene.problem else { return Err("only an indenter has this model".to_owned()) };
    let IndentationShape::Sphere { radius } = indentation.shape else { return Err("only a sphere has this model".to_owned()) };
    indentation.adhesion = None;
    let force = 2.0 * PI * radius * work;
    let attraction = Attraction { force, far_end: indentation.frame_stiffness.map_or(0.0, |stiffness| force / stiffness) };
    let moved = |quantity: HistoryQuantity| match quantity {
        HistoryQuantity::Force => attraction.force,
        HistoryQuantity::Frame => attraction.far_end,
        _ => 0.0,
    };
    indentation.at_start.1 += moved(indentation.at_start.0);
    for segment in &mut indentation.history.segments {
        match segment {
            HistorySegment::Step { quantity, value } | HistorySegment::Ramp { quantity, value, .. } => *value += moved(*quantity),
            HistorySegment::Hold { .. } | HistorySegment::By { .. } => {}
            HistorySegment::Table { quantity, .. } | HistorySegment::Cycles { quantity, .. } if moved(*quantity) == 0.0 => {}
            _ => return Err("this model takes ramps, steps and holds only".to_owned()),
        }
    }
    Ok(attraction)
}

impl Attraction {
    /// Takes the attraction off the forces in contact.
    pub(super) fn put_into(self, curve: &mut PathCurve) {
        let Some([first, last]) = curve.contact else { return };
        let off = |word: &str| match word {
            "force" => self.force,
            "frame" => self.far_end,
            _ => 0.0,
        };
        let count = curve.pieces.len();
        for (word, values) in &mut curve.columns {
            let off = off(word);
            // The far end is where it is whether the sphere touches or not.
            let range = if *word == "frame" { 0..count } else { first..last + 1 };
            values.get_mut(range).into_iter().flatten().for_each(|value| *value -= off);
        }
        if last + 1 < count {
            curve.lost = Some(curve.columns.iter().filter_map(|(_, values)| values.get(last).copied()).collect());
        }
    }
}
