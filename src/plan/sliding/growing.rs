//! Process zones that grow with their edges: δ = α a₀ G/Δγ where the contact opens, α a₀ Δγ/G where it closes.
//!
//! With a short zone a cohesive law acts on the far field as an edge does whose zone has this length: α = 2∫ tension · gap dx/(Δγ a₀) over
//! the zone, π²/6 for a constant tension and 6.497 for an exponential one; a₀ = E0*Δγ/(π peak²) is the relaxed zone. The relative error
//! of the friction then falls linearly in a₀ (measured against `finite_range`, see `docs/src/guides/surfaces.md`).

use super::SlidingPlan;
use crate::outcome::Row;
use crate::refusal::Refusal;
use crate::scene::typed::{SlidingContact, SlidingZone};
use crate::sliding::steady::{SlidingOutcome, WaveAdhesion, steady_sliding_reached_by};

/// Most contacts that are solved for one pair of zones.
const MOST: u32 = 60;
/// Zones and edges agree if they differ by less than this part of the accuracy.
const SHARE: f64 = 0.1;
/// Starts: powers of β in the zones.
const STARTS: [f64; 3] = [0.0, 0.5, 1.0];

/// Contacts expected for one pair of zones.
pub(super) const EXPECTED: f64 = 9.0;

impl SlidingPlan {
    /// Whether the process zones grow with their edges.
    pub(super) fn zones_grow(&self) -> bool {
        matches!(self.sliding.adhesion.map(|adhesion| adhesion.process_zone), Some(SlidingZone::Cohesive { grows: true, .. }))
    }

    /// The row of a contact whose zones follow from its own edges.
    pub(super) fn fill_grown(&self, contact: SlidingContact, row: &mut Row) -> Result<(), Refusal> {
        let Some(start) = self.reduced_adhesion() else { return self.fill(contact, row) };
        let mut first = None;
        for power in STARTS {
            let factor = self.material.stiffening_ratio().powf(power);
            match self.grown(contact, start, [start.trailing_zone * factor, start.leading_zone * factor]) {
                Ok((plan, lack)) => {
                    plan.fill(contact, row)?;
                    // Outputs follow the logarithm of a zone by at most about themselves.
                    row.values
                        .iter_mut()
                        .flatten()
                        .filter(|value| value.error > 0.0)
                        .for_each(|value| value.error += lack * value.value.abs());
                    return Ok(());
                }
                Err(refusal) => first = first.or(Some(refusal)),
            }
        }
        // No pair of zones belongs to a partial contact: what the zones of a relaxed edge give is the answer, such as a full contact.
        let (plan, full) = self.with_zones_of(contact, start)?;
        if full {
            return plan.fill(contact, row);
        }
        Err(first.unwrap_or_else(|| Refusal::NotConverged { what: "the process zones", detail: "no start led to a contact".to_owned() }))
    }

    /// The plan with given zones, and whether they lead to full contact.
    fn with_zones_of(&self, contact: SlidingContact, zones: WaveAdhesion) -> Result<(Self, bool), Refusal> {
        let plan = self.with_zones([zones.trailing_zone, zones.leading_zone]);
        let full = {
            let problem = plan.problem(contact)?;
            matches!(steady_sliding_reached_by(&plan.material, &problem, plan.sliding.reached_by)?, SlidingOutcome::Full(_))
        };
        Ok((plan, full))
    }

    fn with_zones(&self, [trailing, leading]: [f64; 2]) -> Self {
        let mut plan = self.clone();
        if let Some(adhesion) = &mut plan.sliding.adhesion {
            let length = self.scale.length;
            adhesion.process_zone = SlidingZone::Lengths { trailing: trailing * length, leading: leading * length };
        }
        plan
    }

    /// The plan with the zones that the edges of its contact ask for, and by how much the logarithms of both differ.
    fn grown(&self, contact: SlidingContact, relaxed: WaveAdhesion, zones: [f64; 2]) -> Result<(Self, f64), Refusal> {
        let mut logs = zones.map(f64::ln);
        let mut before: Option<([f64; 2], [f64; 2])> = None;
        let mut lack = f64::INFINITY;
        for _ in 0..MOST {
            let plan = self.with_zones(logs.map(f64::exp));
            let outcome = {
                let problem = plan.problem(contact)?;
                steady_sliding_reached_by(&plan.material, &problem, plan.sliding.reached_by)?
            };
            let SlidingOutcome::Partial(partial) = outcome else {
                return Err(Refusal::NotConverged {
                    what: "the process zones",
                    detail: "zones of this length lead to full contact".to_owned(),
                });
            };
            let Some(edges) = partial.values.adhesion else { return Ok((plan, 0.0)) };
            let wanted =
                [(relaxed.trailing_zone * edges.trailing_release.value).ln(), (relaxed.leading_zone / edges.leading_release.value).ln()];
            let defect = [wanted[0] - logs[0], wanted[1] - logs[1]];
            lack = defect[0].abs().max(defect[1].abs());
            if lack < SHARE * self.accuracy.max(1e-12) {
                return Ok((plan, lack));
            }
            if !lack.is_finite() {
                break;
            }
            // A secant for each edge, within what damping by a half and no damping would do.
            let here = logs;
            for edge in 0..2 {
                let slope = before.map_or(-0.5, |(place, old)| {
                    let way = here[edge] - place[edge];
                    if way == 0.0 { -0.5 } else { ((defect[edge] - old[edge]) / way + 1.0).clamp(-2.0, 0.5) }
                });
                logs[edge] += (defect[edge] / (1.0 - slope)).clamp(-2.0, 2.0);
            }
            before = Some((here, defect));
        }
        Err(Refusal::NotConverged {
            what: "the process zones",
            detail: format!("zones and edges still differ by {lack:.1e} after {MOST} contacts"),
        })
    }
}
