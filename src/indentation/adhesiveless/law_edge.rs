//! Where the edge is imposed, and where it passes a place at which series meet.

use super::drive::{DEGREE, Drive};
use super::edge::Way;
use super::law::{Law, Met, places};
use super::linear::Row;
use super::rising::Rising;
use crate::continuation::bracket::halved;
use crate::refusal::Refusal;

impl Law<'_, '_> {
    pub(super) fn met_radius(&self, inside: &Rising<'_>, outside: &Rising<'_>, radii: &Row) -> Result<Met, Refusal> {
        let line = self.line;
        let a = line.radius();
        let rising = radii[DEGREE - 1] > a || a == 0.0;
        let own = radii.map(|radius| radius.max(0.0));
        let mut level = [0.0; DEGREE];
        for (k, level) in level.iter_mut().enumerate() {
            *level = if rising {
                let [limit, _] = line.known();
                if own[k] > limit {
                    return Err(Refusal::NoSuchState {
                        reason: "the contact radius lies beyond the last point of the table".into(),
                        limit_name: "the radius of its last point",
                        limit,
                    });
                }
                outside.value(k, own[k].max(a)).unwrap_or_else(|| line.profile.line(own[k].max(a)))
            } else {
                inside.value(k, own[k].min(a)).or(inside.last(k)).unwrap_or(0.0)
            };
        }
        Ok(Met {
            way: if rising { Way::Outwards } else { Way::Inwards },
            depths: if rising { level } else { self.depths_of(&level) },
            places: own,
            rests: false,
            noise: 0.0,
        })
    }

    /// Part of the duration at which the edge passes a place where intervals meet, the first one on its way.
    pub(super) fn passes(&self, met: &Met) -> Option<f64> {
        let a = self.line.radius();
        let end = met.places[DEGREE - 1];
        let knots = self.fresh.knots(a, end);
        let first = self.line.borders(a, end).chain(knots).min_by(|one, other| (one - a).abs().total_cmp(&(other - a).abs()))?;
        let points: Vec<(f64, f64)> = places().into_iter().zip(met.places.map(|place| place - a)).collect();
        let way = Drive::through(a, 1.0, &points);
        Some(halved([0.0, 1.0], |part| (way.value(part) - first) * (end - a) < 0.0)[1])
    }
}
