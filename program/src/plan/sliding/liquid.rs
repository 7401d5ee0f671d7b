//! A liquid under a sliding wave: the limit of solids that get softer at rest.
//!
//! Every wavelength of a periodic pressure that slides is met by a finite modulus |E(kv)|, whatever the material does at rest. So the contact of a liquid
//! is the limit of solids whose flow t/η is an element of a long retardation time, with E0 → 0. It is approached linearly in E0/|E(kv)|: three solids
//! and the polynomial through them. A single cylinder has wavelengths without end, and its friction on a liquid grows without bound.

use super::SlidingPlan;
use super::columns::{Measure, definitions};
use super::scale::Scale;
use crate::outcome::{Row, Status};
use crate::plan::plane_material::flow_as_element;
use crate::scene::typed::{Sliding, SlidingContact, SlidingIndenter, SlidingTask, SlidingZone};
use std::f64::consts::TAU;
use viscotack::estimate::Estimate;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// E0/|E(kv)| of the solids, the softest first; each is ten times as soft as the next.
const PARTS: [f64; 3] = [1e-5, 1e-4, 1e-3];
/// A column that has a limit changes ten times less from one solid to the next; one that changes by more than this part of it has none.
const LEAST_GAIN: f64 = 0.3;

/// The softest solid and the stiffer ones that stand for a liquid; a solid alone.
pub(super) fn solids(sliding: &Sliding, material: PlaneMaterial) -> Result<(PlaneMaterial, Vec<PlaneMaterial>), Refusal> {
    let Some(viscosity) = material.steady_viscosity() else { return Ok((material, Vec::new())) };
    let refused = |quantity, reason: &str| {
        Err(Refusal::Undefined { quantity, reason: format!("the material is a liquid (relaxed modulus 0): {reason}") })
    };
    let SlidingIndenter::Wave { wavelength, .. } = sliding.indenter else {
        return refused(
            "the friction of a single cylinder",
            "every wavelength has a part in it, the longest as much as the others, so it is infinite; give a wave",
        );
    };
    if sliding.task != SlidingTask::State {
        return refused("a branch or a strength of sliding contacts", "it is measured in the relaxed modulus; sweep the load instead");
    }
    if !sliding.columns.is_empty() {
        return refused("a column of sliding.columns", "it is measured in the relaxed modulus; leave sliding.columns out");
    }
    if sliding.frame_stiffness.is_some() {
        return refused("the stability in a frame", "a load at rest sinks in without end; leave sliding.frame_stiffness out");
    }
    if sliding.speed == 0.0 {
        return refused("a contact at rest", "it spreads until it is full; give a speed");
    }
    if let Some(SlidingZone::Cohesive { .. }) = sliding.adhesion.map(|adhesion| adhesion.process_zone) {
        return refused("the process zone of a cohesive stress", "the zone is αE0*Δγ/(πσ_c²); give process_zone = { length = ... }");
    }
    let modulus = material.complex_modulus(TAU * sliding.speed.abs() / wavelength)?.magnitude();
    let [softest, middle, stiffest] = PARTS.map(|part| flow_as_element(&material, viscosity / (part * modulus)));
    Ok((softest?, vec![middle?, stiffest?]))
}

impl SlidingPlan {
    /// The row of a contact; of a liquid the limit of those of its solids.
    pub(super) fn limit_row(&self, contact: SlidingContact, state: usize, swept: &[f64]) -> Row {
        let mut row = self.row(contact, state, swept);
        let [middle, stiffest] = self.stiffer.as_slice() else { return row };
        let others = [middle, stiffest].map(|plan| plan.row(contact, state, swept));
        others.iter().for_each(|other| row.work += other.work);
        if !row.status.has_values() {
            return row;
        }
        if others.iter().any(|other| !other.status.has_values() || other.labels != row.labels || other.fields.len() != row.fields.len()) {
            row.refuse(&Refusal::NotConverged {
                what: "the limit of solids that a liquid is",
                detail: "they are not all the same state".into(),
            });
            return row;
        }
        let [middle, stiffest] = &others;
        for (index, value) in row.values.iter_mut().enumerate() {
            let of = |row: &Row| row.values.get(index).copied().flatten();
            *value = limit(*value, of(middle), of(stiffest));
        }
        for (index, point) in row.fields.iter_mut().enumerate() {
            for (column, value) in point.values.iter_mut().enumerate() {
                let of = |row: &Row| row.fields.get(index).and_then(|point| point.values.get(column)).copied();
                if let Some(found) = limit(Some(*value), of(middle), of(stiffest)) {
                    *value = found;
                }
            }
        }
        self.assess_limit(&mut row);
        row
    }
}

impl SlidingPlan {
    /// Flags a limit whose bounds are too wide. Its scales are those of a solid of |E(kv)|, as it has no modulus at rest.
    fn assess_limit(&self, row: &mut Row) {
        if row.status == Status::Inaccurate {
            (row.status, row.reason) = (Status::Solved, None);
        }
        let scale = Scale::new(&self.sliding, self.material.relaxed_modulus() / PARTS[0], self.units);
        let definitions = definitions(&self.sliding);
        let works = self.works_of_adhesion();
        let shortfall = definitions.iter().zip(&row.values).skip(1).find_map(|(definition, value)| {
            let estimate = value.filter(|_| definition.measure != Measure::Ratio)?;
            let error = estimate.error / estimate.value.abs().max(definition.factor(&scale, works));
            (error > self.accuracy).then_some((definition.name, error))
        });
        if let Some((name, error)) = shortfall {
            row.status = Status::Inaccurate;
            row.reason = Some(format!("the error bound of {name} is {error:.1e}, above the wanted accuracy {:.1e}", self.accuracy));
        }
    }
}

/// The limit of three values at E0, 10 E0 and 100 E0; none without one.
fn limit(soft: Option<Estimate>, middle: Option<Estimate>, stiff: Option<Estimate>) -> Option<Estimate> {
    let (soft, middle, stiff) = (soft?, middle?, stiff?);
    let (near, far) = (soft.value - middle.value, middle.value - stiff.value);
    let noise = soft.error + middle.error + stiff.error + 8.0 * f64::EPSILON * soft.value.abs();
    if near.abs() > LEAST_GAIN * far.abs() + 4.0 * noise {
        return None;
    }
    let (line, wide) = (soft.value + near / 9.0, middle.value + far / 9.0);
    let value = line + (line - wide) / 99.0;
    // What the last order adds, and the bounds of all three with their weights.
    let error = 2.0 * (value - line).abs() + 1.2 * soft.error + 0.2 * middle.error + 0.01 * stiff.error;
    Some(if noise > 0.0 && (soft.error > 0.0 || near != 0.0) {
        Estimate::new(value, error + 4.0 * f64::EPSILON * value.abs())
    } else {
        soft
    })
}
