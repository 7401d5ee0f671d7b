//! A load that is raised and lowered again, and the branch of a state through its folds.

use super::SurfacePlan;
use super::columns::{COLUMNS, columns};
use crate::outcome::{Certificate, Row, Status, Work};
use viscotack::estimate::Estimate;
use viscotack::finite_range::line::{
    Branch, Certificate as Identities, Control, Direction, End, FoldKind, Numbers, Problem, ReachedBy, StateStability, SteadyState, follow,
    locate, solve, trace_refined,
};
use viscotack::refusal::Refusal;

/// A step of the load may be halved so often before the contact is said to jump.
const HALVINGS: u32 = 5;
/// The contact fraction may change by so much in one step; where the shortest step changes it by more, the contact jumps.
const MOST_CHANGE: f64 = 0.04;
/// Nodes along x on which a branch is followed: each state is then solved on grids twice and four times as fine.
const BRANCH_NODES: [usize; 2] = [1024, 64];

/// What a branch gives at a point.
struct Point<'a> {
    numbers: &'a Numbers,
    errors: &'a Numbers,
    patches: Option<(usize, usize)>,
    certificate: Option<&'a Identities>,
    nodes: usize,
    /// None at a fold.
    stability: Option<&'a StateStability>,
}

impl SurfacePlan {
    pub(super) fn loop_rows(&self, to: f64, points: u32, state: usize, swept: &[f64]) -> Vec<Row> {
        let contact = self.sliding.contacts.first().copied().unwrap_or(crate::scene::typed::SlidingContact::Adhesive);
        let problem = match self.problem(contact) {
            Ok(problem) => problem,
            Err(refusal) => {
                let mut row = self.empty_row(contact, state, swept);
                self.refuse(&mut row, &refusal);
                return vec![row];
            }
        };
        let Control::MeanPressure(from) = problem.control else { return Vec::new() };
        let to = to / self.scales.pressure;
        let load = |index: u32| from + (to - from) * f64::from(index) / f64::from(points - 1);
        let way = (0..points).map(|index| ("loading", load(index))).chain((0..points).rev().map(|index| ("unloading", load(index))));
        let mut last: Option<(f64, SteadyState)> = None;
        way.map(|(word, load)| {
            let mut row = self.empty_row(contact, state, swept);
            word.clone_into(&mut row.labels[3]);
            match self.next_of_loop(&problem, last.take(), load) {
                Ok((found, jumped)) => {
                    let here = Problem { control: Control::MeanPressure(load), ..problem.clone() };
                    if let Err(refusal) = self.fill(&here, &found, &mut row) {
                        self.refuse(&mut row, &refusal);
                    }
                    word.clone_into(&mut row.labels[2]);
                    if jumped {
                        row.labels[3] = "jump".to_owned();
                    }
                    last = Some((load, found));
                }
                Err(refusal) => {
                    let here = Problem { control: Control::MeanPressure(load), ..problem.clone() };
                    self.refuse(&mut row, &self.with_fold(&here, refusal));
                }
            }
            row
        })
        .collect()
    }

    /// The next state of the loop: beside the last one, or, where its branch ends, by a start of its own.
    fn next_of_loop(&self, problem: &Problem, last: Option<(f64, SteadyState)>, load: f64) -> Result<(SteadyState, bool), Refusal> {
        let request = self.request();
        let at = |load: f64| Problem { control: Control::MeanPressure(load), ..problem.clone() };
        let Some((mut here, mut state)) = last else { return solve(&at(load), &request).map(|state| (state, false)) };
        // Full contact has a closed form; whether it still holds is asked first.
        if state.reached_by == ReachedBy::FullContact
            && let Ok(full) = viscotack::finite_range::line::full_contact(&at(load), &request)
        {
            return Ok((full, false));
        }
        if (load - here).abs() <= 1e-14 * (1.0 + load.abs()) {
            return Ok((state, false));
        }
        let mut step = load - here;
        let shortest = step.abs() / f64::from(1_u32 << HALVINGS);
        let mut jumped = false;
        loop {
            let next = if (load - here).abs() <= step.abs() * (1.0 + 1e-9) { load } else { here + step };
            let short = step.abs() <= shortest * (1.0 + 1e-9);
            match follow(&at(next), &state, &request) {
                Ok(found) => {
                    let change = (found.numbers.contact_fraction - state.numbers.contact_fraction).abs();
                    if change > MOST_CHANGE && !short {
                        step *= 0.5;
                        continue;
                    }
                    jumped |= change > MOST_CHANGE;
                    (state, here) = (found, next);
                    if (load - next).abs() <= 1e-14 * (1.0 + load.abs()) {
                        return Ok((state, jumped));
                    }
                }
                Err(_) if !short => step *= 0.5,
                Err(_) => return solve(&at(load), &request).map(|state| (state, true)),
            }
        }
    }

    pub(super) fn branch_rows(&self, points: u32, state: usize, swept: &[f64]) -> Vec<Row> {
        let contact = self.sliding.contacts.first().copied().unwrap_or(crate::scene::typed::SlidingContact::Adhesive);
        let nodes = BRANCH_NODES[usize::from(!self.is_line())].max(self.profile.nodes()[0].next_power_of_two());
        let traced = self.problem(contact).and_then(|problem| {
            let way = |direction| trace_refined(&problem, nodes, direction, points as usize);
            Ok((way(Direction::Unloading)?, way(Direction::Loading)?, problem))
        });
        let (unloading, loading, problem) = match traced {
            Ok(traced) => traced,
            Err(refusal) => {
                let mut row = self.empty_row(contact, state, swept);
                self.refuse(&mut row, &refusal);
                return vec![row];
            }
        };
        let mut rows = Vec::new();
        // One curve: from the end of the unloading way to the start, then on along the loading way, which has the start, too.
        let empty = || self.empty_row(contact, state, swept);
        for (branch, backwards) in [(&unloading, true), (&loading, false)] {
            let mut own: Vec<Row> = self.branch_points(branch, &empty);
            for fold in &branch.folds {
                let mut row = empty();
                match locate(&problem, fold) {
                    Ok(found) => {
                        let point = Point {
                            numbers: &found.numbers,
                            errors: &found.errors,
                            patches: None,
                            certificate: None,
                            nodes: found.nodes,
                            stability: None,
                        };
                        self.fill_point(&problem, &point, &mut row);
                    }
                    Err(refusal) => self.refuse(&mut row, &refusal),
                }
                row.labels[3] = event(fold.kind).to_owned();
                // A fold stands after the point that it is near.
                let place = branch.points.iter().position(|point| *point == fold.point).map_or(own.len(), |place| place + 1);
                let shift = own.iter().take(place).filter(|row| !row.labels[3].is_empty()).count();
                own.insert((place + shift).min(own.len()), row);
            }
            if let (Some(row), End::Lost(reason)) = (own.last_mut(), &branch.end) {
                row.reason = Some(row.reason.take().map_or_else(|| reason.clone(), |before| format!("{before}; {reason}")));
            }
            if backwards {
                own.reverse();
                own.pop();
            }
            rows.append(&mut own);
        }
        rows
    }

    fn branch_points(&self, branch: &Branch, empty: &impl Fn() -> Row) -> Vec<Row> {
        let problem = self.problem(self.sliding.contacts.first().copied().unwrap_or(crate::scene::typed::SlidingContact::Adhesive));
        let Ok(problem) = problem else { return Vec::new() };
        branch
            .refined
            .iter()
            .map(|refined| {
                let mut row = empty();
                match refined {
                    Some(found) => {
                        row.work = Work { kernel_evaluations: found.node_products as u64, ..Work::default() };
                        let point = Point {
                            numbers: &found.numbers,
                            errors: &found.errors,
                            patches: Some((found.patches, found.patches_error)),
                            certificate: Some(&found.certificate),
                            nodes: found.nodes,
                            stability: Some(&found.stability),
                        };
                        self.fill_point(&problem, &point, &mut row);
                    }
                    None => row.refuse(&Refusal::NotConverged {
                        what: "the error of a state of the branch",
                        detail: "the finer grids do not have it".to_owned(),
                    }),
                }
                row
            })
            .collect()
    }

    fn fill_point(&self, problem: &Problem, point: &Point<'_>, row: &mut Row) {
        let (n, e) = (point.numbers, point.errors);
        let friction = Estimate::new(n.friction_stress, e.friction_stress);
        let coefficient = (n.mean_pressure > 10.0 * e.mean_pressure && n.mean_pressure > 0.0).then(|| {
            let value = n.friction_stress / n.mean_pressure;
            Estimate::new(value, (e.friction_stress + value.abs() * e.mean_pressure) / n.mean_pressure)
        });
        let by = |value: f64| Estimate::new(value, e.friction_stress + (value - n.friction_stress).abs());
        let reduced = [
            Some(Estimate::exact(self.sliding.speed)),
            Some(friction),
            coefficient,
            Some(Estimate::new(n.mean_pressure, e.mean_pressure)),
            Some(Estimate::new(n.mean_gap, e.mean_gap)),
            Some(Estimate::new(n.contact_fraction, e.contact_fraction)),
            point.patches.map(|(patches, error)| Estimate::new(patches as f64, error as f64)),
            Some(Estimate::new(n.adhesive_pressure, e.adhesive_pressure)),
            Some(Estimate::new(n.repulsive_pressure, e.repulsive_pressure)),
            Some(friction.scaled(problem.speed)),
            Some(Estimate::new(n.interface_energy, e.interface_energy)),
            point.certificate.map(|identities| by(identities.friction_by_surface)),
            point.certificate.map(|identities| by(identities.friction_by_profile)),
            Some(Estimate::exact(point.nodes as f64)),
        ];
        row.values = COLUMNS.iter().zip(reduced).map(|(definition, value)| Some(self.in_units(value?, definition.measure))).collect();
        let stabilities = point.stability.map_or([None; 3], |stability| self.stabilities(stability, problem.control));
        row.values.extend(stabilities.into_iter().chain([None]));
        row.labels[1] = if n.contact_fraction >= 1.0 {
            "full"
        } else if n.contact_fraction > 0.0 {
            "partial"
        } else {
            "no_touch"
        }
        .to_owned();
        row.labels[2] = "branch".to_owned();
        let half_height = problem.profile.half_height();
        let stress = n.mean_pressure.abs().max(n.repulsive_pressure).max(-n.adhesive_pressure).max(1e-12);
        let worst = [
            e.friction_stress / n.friction_stress.abs().max(1e-3 * stress * half_height),
            e.mean_gap / n.mean_gap.abs().max(half_height),
            e.mean_pressure / stress,
        ]
        .into_iter()
        .fold(0.0, f64::max);
        if worst > self.accuracy {
            row.status = Status::Inaccurate;
            row.reason = Some(format!(
                "its error bound is {worst:.1e}, above the wanted accuracy {:.1e}: a branch is followed on {} nodes",
                self.accuracy, point.nodes
            ));
        }
        row.assumptions = self.assumptions();
        row.certificate = point.certificate.map(|identities| Certificate {
            residual: identities.residual.max((identities.friction_by_surface - identities.friction_by_loss).abs() / (1.0 + stress)),
            condition: 1.0,
            admissible: identities.least_contact_pressure > -1e-6 * (1.0 + stress)
                && (problem.attraction.wall().is_none() || identities.least_gap > -1e-6),
        });
        if let Err(refusal) = row.representable(&columns(self.units)) {
            self.refuse(row, &refusal);
        }
    }
}

/// The event at a fold.
const fn event(kind: FoldKind) -> &'static str {
    match kind {
        FoldKind::LeastPressure => "least_pressure",
        FoldKind::LargestPressure => "largest_pressure",
        FoldKind::LargestGap => "separation",
        FoldKind::LeastGap => "snap_in",
    }
}
