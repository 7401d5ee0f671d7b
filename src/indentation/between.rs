//! Errors of the points of a path between kept instants: every other integration is looked at where the point is.
//!
//! Integrations take different steps, so the other path is read between its own points. Where it has one at the same time, that counts; where it has one hardly earlier
//! or later (an edge that turns, a contact that is lost), the value goes on from there as steeply as it does anywhere beside; else a cubic goes through four points of
//! one smooth piece, and what it differs by from the straight line and the parabola tells how well. Where none of them is there, nothing is known.

use super::convergence::{Compared, Ladder};
use super::solution::{PathPoint, Trace};

/// Quantities of a point whose errors are known: Δ, F, a, K.
pub(super) const QUANTITIES: usize = 4;

/// Times that differ by less than this part of them are one.
const SAME_TIME: f64 = 64.0 * f64::EPSILON;
/// Part of the time between two points within which a point beside is hardly earlier or later.
const HARDLY: f64 = 1e-3;

fn of(point: &PathPoint) -> [f64; QUANTITIES] {
    [point.penetration, point.force, point.contact_radius, point.stress_intensity_factor]
}

/// Bounds on Δ, F, a and K at every point of the path of the integration whose numbers are shown; infinite where another integration does not show them.
pub(super) fn errors(ladder: &Ladder, compared: Compared<&Trace>, integration: &Trace) -> Vec<[f64; QUANTITIES]> {
    let path = &integration.path;
    let mut places = compared.map(|_| 0);
    let mut found = Vec::with_capacity(path.len());
    for (index, point) in path.iter().enumerate() {
        let mut seen: Compared<[(f64, f64); QUANTITIES]> = compared.map(|_| None);
        for ((seen, other), place) in seen.iter_mut().zip(compared).zip(&mut places) {
            let Some(other) = other else { continue };
            *seen = if std::ptr::eq(other, integration) {
                Some(of(point).map(|value| (value, 0.0)))
            } else {
                read(path, index, &other.path, place)
            };
        }
        found.push(std::array::from_fn(|quantity| {
            let values = seen.map(|seen| seen.and_then(|seen| seen.get(quantity).copied()));
            let reading = values.iter().flatten().fold(0.0, |most: f64, (_, reading)| most.max(*reading));
            ladder.error(values.map(|value| value.map(|(value, _)| value))) + reading
        }));
    }
    found
}

/// Values of another path at a point of a path, and what is not known of them; `place`: where to look on from, which rises along the path.
fn read(path: &[PathPoint], index: usize, other: &[PathPoint], place: &mut usize) -> Option<[(f64, f64); QUANTITIES]> {
    let time = path.get(index)?.time;
    let same = |one: f64| (one - time).abs() <= SAME_TIME * time.abs();
    while other.get(*place).is_some_and(|point| point.time < time && !same(point.time)) {
        *place += 1;
    }
    // Before and after something sudden: in the same order.
    let rank = path.get(..index)?.iter().rev().take_while(|point| same(point.time)).count();
    let together = other.get(*place..)?.iter().take_while(|point| same(point.time)).count();
    if together > 0 {
        return Some(of(other.get(*place + rank.min(together - 1))?).map(|value| (value, 0.0)));
    }
    let (before, after) = (other.get(place.checked_sub(1)?)?, other.get(*place)?);
    let width = after.time - before.time;
    let near = if time - before.time < after.time - time { before } else { after };
    let away = time - near.time;
    let around = [index.checked_sub(1), Some(index), index.checked_add(1)].map(|index| index.and_then(|index| path.get(index)));
    if away.abs() <= HARDLY * width {
        let steepest = |quantity: usize| {
            let slope = |[from, to]: [Option<&PathPoint>; 2]| {
                let (from, to) = (from?, to?);
                (to.time > from.time).then(|| ((of(to)[quantity] - of(from)[quantity]) / (to.time - from.time)).abs())
            };
            let own = [[around[0], around[1]], [around[1], around[2]], [Some(before), Some(after)]];
            own.into_iter().filter_map(slope).fold(0.0, f64::max)
        };
        let values = of(near);
        return Some(std::array::from_fn(|quantity| (values[quantity], steepest(quantity) * away.abs())));
    }
    // A piece begins at the last point of the one before.
    let of_piece = |index: usize| other.get(index).is_some_and(|point| point.piece == after.piece);
    let ahead = (1..=2).take_while(|step| of_piece(*place + step)).count();
    let behind = (1..=2).take_while(|step| place.checked_sub(*step).is_some_and(of_piece)).count();
    // Two points on both sides where the piece has them.
    let from = match (behind, ahead) {
        (0, _) => *place - 1,
        (_, 0) => place.checked_sub(3).filter(|_| behind == 2)?,
        _ => place.checked_sub(2)?,
    };
    let stencil = other.get(from..from + 4)?;
    let whole =
        stencil.iter().skip(1).all(|point| point.piece == after.piece) && stencil.windows(2).all(|pair| pair[0].time < pair[1].time);
    if !whole {
        return None;
    }
    let values: Vec<[f64; QUANTITIES]> = stencil.iter().map(of).collect();
    Some(std::array::from_fn(|quantity| {
        // Aitken's and Neville's table: lines, parabolas, the cubic.
        let mut table: Vec<f64> = values.iter().map(|values| values[quantity]).collect();
        let mut last = [0.0; 2];
        for order in 1..table.len() {
            last = [table[0], table[table.len() - order]];
            for k in 0..table.len() - order {
                let (low, high) = (stencil[k].time, stencil[k + order].time);
                table[k] = ((high - time) * table[k] + (time - low) * table[k + 1]) / (high - low);
            }
        }
        let cubic = table[0];
        (cubic, last.into_iter().fold(0.0, |most: f64, parabola| most.max((parabola - cubic).abs())))
    }))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing)]
mod tests {
    use super::*;

    const OFF: f64 = 1e-5;

    fn point(time: f64, piece: u32, off: f64) -> PathPoint {
        let value = (3.0 * time).sin();
        PathPoint {
            time,
            penetration: value + off,
            force: 2.0 * value + off,
            contact_radius: 3.0 + value + off,
            stress_intensity_factor: 0.0,
            unresolved_intensity: 0.0,
            residual: 0.0,
            piece,
            energies: None,
        }
    }

    fn trace(times: impl Iterator<Item = f64>, piece: u32, off: impl Fn(f64) -> f64) -> Trace {
        Trace { path: times.map(|time| point(time, piece, off(time))).collect(), ..Trace::default() }
    }

    fn found(own: &Trace, finer: &Trace) -> Vec<[f64; QUANTITIES]> {
        let ladder = Ladder { tolerances: [Some(1e-3), Some(1.0), None, None], reported: 1, reduction: None };
        errors(&ladder, [Some(finer), Some(own), None, None], own)
    }

    /// Right at both ends, where something is imposed, and off between: by sin as the truth, which other times of the finer path do not hide.
    #[test]
    fn points_between_imposed_ones_have_their_own_error() {
        let away = |time: f64| OFF * time * (1.0 - time) * 4.0;
        let own = trace((0..=20).map(|k| f64::from(k) / 20.0), 0, away);
        let finer = trace((0..=333).map(|k| f64::from(k) / 333.0), 0, |_| 0.0);
        for (point, errors) in own.path.iter().zip(found(&own, &finer)) {
            for error in errors.iter().take(3) {
                assert!(*error >= away(point.time) && *error <= 1.5 * away(point.time) + 1e-7, "{error:e} at {}", point.time);
            }
        }
    }

    /// An event a little later in the other path: what changes meanwhile is not known.
    #[test]
    fn an_event_that_is_a_little_later_is_as_far_off_as_its_time_makes_it() {
        let late = 1e-6;
        let own = trace([0.0, 0.4, 1.0].into_iter(), 0, |_| 0.0);
        let finer = trace([0.0, 0.4 + late, 1.0].into_iter(), 0, |_| 0.0);
        let errors = found(&own, &finer);
        assert!(errors[1][0] > late && errors[1][0] < 20.0 * late, "{:e}", errors[1][0]);
        assert!(errors[0][0] == 0.0 && errors[2][0] == 0.0);
    }

    /// Where the other path has no point near and no smooth piece, nothing is known.
    #[test]
    fn what_another_path_does_not_show_is_not_known() {
        let own = trace([0.0, 0.4, 1.0].into_iter(), 0, |_| 0.0);
        let finer = trace([0.0, 1.0].into_iter(), 0, |_| 0.0);
        assert!(found(&own, &finer)[1][0].is_infinite());
    }
}
