//! One state of a sliding contact: a row for each kind of contact, from the solver's reduced numbers.

use super::SlidingPlan;
use super::columns::{COLUMNS, Measure, at, columns, definitions};
use crate::outcome::{Certificate, Row, Status, Witness, Work};
use crate::scene::typed::{Sliding, SlidingContact, SlidingTask, SlidingZone, Units};
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::Stability;
use viscotack::sliding::steady::{FullContact, PartialContact, PartialValues, SlidingOutcome, SlidingWork, steady_sliding_reached_by};

/// Rounding of the way from a scene to reduced units and back, relative: a dozen products.
const CONVERSION: f64 = 6.0 * f64::EPSILON;

/// What is said of a contact whose adhesion no digit of the load feels.
const NEGLIGIBLE: &str =
    "adhesion is negligible beside the last digits of the load: values are those without it, and their bounds cover what it would change";

/// A limit in the units of the scene.
pub(super) struct PassedLimit {
    name: &'static str,
    value: f64,
    unit: String,
}

impl std::fmt::Display for PassedLimit {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{} = {:e}", self.name, self.value)?;
        if self.unit.is_empty() { Ok(()) } else { write!(formatter, " {}", self.unit) }
    }
}

impl From<PassedLimit> for Witness {
    fn from(limit: PassedLimit) -> Self {
        Self { name: limit.name.to_owned(), value: limit.value }
    }
}

impl SlidingPlan {
    pub(super) fn row(&self, contact: SlidingContact, state: usize, swept: &[f64]) -> Row {
        let mut row = Row::new(state, swept, vec![contact.word().to_owned(), String::new()], definitions(&self.sliding).len());
        if let Err(refusal) = self.fill(contact, &mut row) {
            row.labels = vec![contact.word().to_owned(), String::new()];
            self.refuse(&mut row, refusal);
        }
        row
    }

    /// Ends a row by a refusal, limits in the units of the scene.
    pub(super) fn refuse(&self, row: &mut Row, refusal: Refusal) {
        row.refuse(&refusal);
        if let Refusal::NoSuchState { limit_name, limit, .. } = refusal {
            row.reason = Some(self.sentence(&refusal));
            row.witness = Some(self.limit(limit_name, limit).into());
        }
    }

    /// A refusal in words, limits in the units of the scene.
    pub(super) fn sentence(&self, refusal: &Refusal) -> String {
        match refusal {
            Refusal::NoSuchState { reason, limit_name, limit } => {
                format!("no such state exists: {reason} ({})", self.limit(limit_name, *limit))
            }
            other => other.to_string(),
        }
    }

    fn fill(&self, contact: SlidingContact, row: &mut Row) -> Result<(), Refusal> {
        let problem = self.problem(contact)?;
        let mut stability = vec![None; self.stabilities().count() + 1];
        let (mut reduced, extras) = match steady_sliding_reached_by(&self.material, &problem, self.sliding.reached_by)? {
            SlidingOutcome::Partial(partial) => {
                row.labels = vec![contact.word().to_owned(), "partial".to_owned()];
                row.work = counted(&partial.work);
                row.certificate = Some(Certificate {
                    residual: partial.certificate.residual,
                    condition: partial.certificate.condition,
                    admissible: partial.certificate.admissible,
                });
                if !partial.certificate.admissible {
                    row.witness = Some(Witness {
                        name: "signs of both edges or of the gap are violated; residual".into(),
                        value: partial.certificate.residual,
                    });
                }
                if problem.adhesion.is_some() && partial.values.adhesion.is_none() {
                    row.reason = Some(NEGLIGIBLE.to_owned());
                }
                if let Some(points) = self.sliding.field_points {
                    row.fields = self.fields(&partial, points)?;
                    row.work.field_evaluations = u64::from(points);
                }
                stability = self.stability_values(&partial);
                let speed = Estimate::exact(self.sliding.speed);
                let zones = self.zones().filter(|_| contact == SlidingContact::Adhesive);
                (self.partial_values(&partial.values, speed, zones), self.extras_of_state(&problem, Some(&partial.values))?)
            }
            SlidingOutcome::Full(full) => {
                row.labels = vec![contact.word().to_owned(), "full".to_owned()];
                row.work = counted(&full.work);
                row.certificate = Some(Certificate { residual: 0.0, condition: 1.0, admissible: true });
                let limit = self.limit(full.limit_name, full.limit);
                row.reason = Some(format!("past {limit}"));
                row.witness = Some(limit.into());
                if let Some(points) = self.sliding.field_points {
                    row.fields = self.full_fields(&full, points);
                    row.work.field_evaluations = row.fields.len() as u64;
                    if row.fields.is_empty() {
                        let without = "no fields: full contact carries any mean pressure, and none is given".to_owned();
                        row.reason = Some(row.reason.take().into_iter().chain([without]).collect::<Vec<_>>().join("; "));
                    }
                }
                (self.full_values(&full), self.extras_of_state(&problem, None)?)
            }
        };
        reduced.truncate(if self.is_wave() { COLUMNS.len() } else { at::PENETRATION });
        reduced.extend(stability);
        reduced.extend(extras.values);
        row.work += extras.work;
        self.finish(row, reduced, self.works_of_adhesion())?;
        row.assumptions = self.assumptions(row);
        if !extras.notes.is_empty() {
            row.reason = Some(row.reason.take().into_iter().chain(extras.notes).collect::<Vec<_>>().join("; "));
        }
        row.representable(&columns(&self.sliding, self.units))
    }

    /// What is held, one after the other: a load, of a wave a penetration, and a frame if there is one; as the stiffness of a frame in reduced units.
    fn stabilities(&self) -> impl Iterator<Item = f64> {
        let frame = self.sliding.frame_stiffness.map(|stiffness| stiffness * self.scale.displacement / self.scale.load);
        [Some(0.0), self.is_wave().then_some(f64::INFINITY), frame].into_iter().flatten()
    }

    /// Whether a contact stays where it is under each of these, and how many others there are.
    fn stability_values(&self, contact: &PartialContact) -> Vec<Option<Estimate>> {
        let flag = |stability: Stability| match stability {
            Stability::Stable => Some(Estimate::exact(1.0)),
            Stability::Unstable => Some(Estimate::exact(0.0)),
            Stability::Marginal => None,
        };
        let stays = |frame: f64| contact.stability.as_ref().and_then(|stability| flag(stability.in_frame(frame)));
        let others = Some(Estimate::exact(contact.others as f64));
        self.stabilities().map(stays).chain(std::iter::once(others)).collect()
    }

    /// Δγ of both edges as the units of their energy release rates.
    pub(super) fn works_of_adhesion(&self) -> [f64; 2] {
        match (self.units, self.sliding.adhesion) {
            (Units::Si, Some(adhesion)) => adhesion.works,
            _ => [1.0; 2],
        }
    }

    /// Puts reduced values into a row in the units of the scene; the first, the speed, is in them already. Flags a row whose bounds are too wide.
    pub(super) fn finish(&self, row: &mut Row, reduced: Vec<Option<Estimate>>, works_of_adhesion: [f64; 2]) -> Result<(), Refusal> {
        let columns = columns(&self.sliding, self.units);
        // Every reference scale is one reduced unit.
        let definitions = definitions(&self.sliding);
        let shortfall = columns.iter().zip(&definitions).zip(&reduced).skip(1).find_map(|((column, definition), value)| {
            let estimate = value.filter(|_| definition.measure != Measure::Ratio)?;
            let error = estimate.error / estimate.value.abs().max(1.0);
            (error > self.accuracy).then_some((column.name, error))
        });
        if let Some((name, error)) = shortfall {
            row.status = Status::Inaccurate;
            row.reason = Some(format!("the error bound of {name} is {error:.1e}, above the wanted accuracy {:.1e}", self.accuracy));
        }
        row.values = definitions
            .into_iter()
            .zip(reduced)
            .map(|(definition, value)| Some(self.in_units(value?, definition.factor(&self.scale, works_of_adhesion))))
            .collect();
        row.representable(&columns)
    }

    /// A reduced number in the units of the scene.
    pub(super) fn in_units(&self, estimate: Estimate, factor: f64) -> Estimate {
        let value = estimate.value * factor;
        let rounding = if self.units == Units::Si && estimate.error > 0.0 { CONVERSION * value.abs() } else { 0.0 };
        // No minus zero.
        Estimate::new(value + 0.0, (estimate.error * factor).abs() + rounding)
    }

    /// The process zones, reduced.
    pub(super) fn zones(&self) -> Option<[Estimate; 2]> {
        let error = match self.sliding.adhesion.map(|adhesion| adhesion.process_zone) {
            Some(SlidingZone::Cohesive { .. }) => 8.0 * f64::EPSILON,
            _ => 0.0,
        };
        self.reduced_adhesion().map(|zones| [zones.trailing_zone, zones.leading_zone].map(|zone| Estimate::relative(zone, error)))
    }

    /// The values of a partial contact in the order of the columns, reduced; the speed is in the scene's units already.
    pub(super) fn partial_values(&self, values: &PartialValues, speed: Estimate, zones: Option<[Estimate; 2]>) -> Vec<Option<Estimate>> {
        let mirrored = |estimate: Estimate| Some(Estimate::new(self.direction() * estimate.value, estimate.error));
        let adhesion = values.adhesion.as_ref();
        vec![
            Some(speed),
            Some(values.half_width),
            mirrored(values.eccentricity),
            Some(values.friction_stress),
            values.friction_coefficient,
            adhesion.map(|values| values.trailing_release),
            adhesion.map(|values| values.leading_release),
            Some(values.mean_pressure),
            mirrored(values.trailing_edge),
            mirrored(values.leading_edge),
            adhesion.map(|values| values.adhesive_friction_stress),
            adhesion.map(|values| values.trailing_nonconservative),
            adhesion.map(|values| values.leading_nonconservative),
            zones.map(|[trailing, _]| trailing),
            zones.map(|[_, leading]| leading),
            Some(values.penetration),
            Some(values.interface_work),
        ]
    }

    /// The values of a full contact, which has no edges.
    fn full_values(&self, full: &FullContact) -> Vec<Option<Estimate>> {
        let mut values = vec![None; COLUMNS.len()];
        for (place, value) in [
            (at::SPEED, Some(Estimate::exact(self.sliding.speed))),
            (at::FRICTION, Some(full.friction_stress)),
            (at::COEFFICIENT, full.friction_coefficient),
            (at::LOAD, full.mean_pressure.map(Estimate::exact)),
            // The displacement of the surface is counted from its mean, and a wave has its crests one amplitude from there.
            (at::PENETRATION, self.is_wave().then_some(Estimate::exact(1.0))),
        ] {
            if let Some(slot) = values.get_mut(place) {
                *slot = value;
            }
        }
        values
    }

    /// −1 where the body slides along −x.
    pub(super) fn direction(&self) -> f64 {
        if self.sliding.speed < 0.0 { -1.0 } else { 1.0 }
    }

    /// A limit of the solver, which measure it has following from its name, in the units of the scene.
    pub(super) fn limit(&self, name: &'static str, value: f64) -> PassedLimit {
        let plain = Sliding { task: SlidingTask::State, ..self.sliding.clone() };
        let of_column = |column: usize| columns(&plain, self.units).into_iter().nth(column).map_or_else(String::new, |c| c.unit);
        let (name, value, unit) = if name.contains("half-width of") {
            (name, value * self.scale.length, of_column(at::HALF_WIDTH))
        } else if name.contains("narrowest half-width") {
            ("the narrowest half-width", value * self.scale.length, of_column(at::HALF_WIDTH))
        } else if name.contains("penetration") {
            (name, value * self.scale.displacement, of_column(at::PENETRATION))
        } else if name.contains("pressure") || name.contains("load") {
            (name, value * self.scale.load, of_column(at::LOAD))
        } else {
            (name, value, String::new())
        };
        PassedLimit { name, value, unit }
    }
}

fn counted(work: &SlidingWork) -> Work {
    Work { closure_evaluations: work.closure_evaluations, linear_solves: work.contacts, ..Work::default() }
}
