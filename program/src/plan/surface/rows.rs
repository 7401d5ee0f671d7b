//! One state as a row: values with bounds, certificate, labels.

use super::SurfacePlan;
use super::columns::{COLUMNS, Measure, at, columns};
use crate::outcome::{Certificate, Row, Status, Witness, Work};
use crate::scene::typed::{SlidingContact, SurfacePath, Units};
use viscotack::estimate::Estimate;
use viscotack::finite_range::line::{
    Control, Path, Problem, ReachedBy, Request, StateStability, SteadyState, every, follow, full_contact, pull_off, solve,
};
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::Stability;

/// Rounding of the conversion to SI units.
const CONVERSION: f64 = 8.0 * f64::EPSILON;
/// An admissible state violates its inequalities by less than this part of the stress, or of the height.
const ADMISSIBLE: f64 = 1e-6;
/// Steps of a load that is raised or lowered to the wanted one, at least; a step may be halved so often.
const STEPS: u32 = 12;
/// The accuracy of the states on the way, and nodes along x of the first grid that may give them.
const ON_THE_WAY: f64 = 0.05;
const LEAST_ON_THE_WAY: usize = 64;
const HALVINGS: u32 = 6;
/// Where a raised load begins and a lowered one: parts of the pressure that flattens the profile.
const LIGHT: f64 = 0.01;
const HEAVY: f64 = 1.0;

impl SurfacePlan {
    pub(super) fn empty_row(&self, contact: SlidingContact, state: usize, swept: &[f64]) -> Row {
        let labels = vec![String::new(); crate::plan::ProblemPlan::labels(self).len()];
        let mut row = Row::new(state, swept, labels, COLUMNS.len());
        row.labels[0] = contact.word().to_owned();
        row
    }

    /// One row, or one of every state that a search finds.
    pub(super) fn state_rows(&self, contact: SlidingContact, state: usize, swept: &[f64]) -> Vec<Row> {
        let empty = || self.empty_row(contact, state, swept);
        let found = self.problem(contact).and_then(|problem| {
            let found = if self.sliding.reached_by == SurfacePath::Every && problem.attraction.attracts() {
                every(&problem, &self.request()).map(|all| all.into_iter().map(|found| (found, None)).collect())
            } else {
                self.reached(&problem).map(|found| vec![found])
            };
            found.map(|found| (problem.clone(), found)).map_err(|refusal| self.with_fold(&problem, refusal))
        });
        let (problem, found) = match found {
            Ok(found) => found,
            Err(refusal) => {
                let mut row = empty();
                self.refuse(&mut row, &refusal);
                return vec![row];
            }
        };
        let others = (found.len() - 1) as f64;
        let filled = |(found, note): (SteadyState, Option<String>)| {
            let mut row = empty();
            row.reason = note;
            let filled = self.fill(&problem, &found, &mut row);
            if let (Some(points), true) = (self.sliding.field_points, filled.is_ok()) {
                row.fields = self.fields(&found, points as usize);
                row.work.field_evaluations = row.fields.len() as u64;
            }
            if let (Some(Some(known)), SurfacePath::Every) = (row.values.get_mut(at::OTHERS), self.sliding.reached_by) {
                *known = Estimate::exact(others);
            }
            if let Err(refusal) = filled.and_then(|()| row.representable(&columns(self.units))) {
                self.refuse(&mut row, &refusal);
            }
            row
        };
        found.into_iter().map(filled).collect()
    }

    /// Of a pull that no state carries: with the fold at which the contact parts.
    pub(super) fn with_fold(&self, problem: &Problem, refusal: Refusal) -> Refusal {
        let Control::MeanPressure(wanted) = problem.control else { return refusal };
        if wanted >= 0.0 || !problem.attraction.attracts() {
            return refusal;
        }
        match pull_off(problem, &self.request()) {
            Ok(fold) if wanted < fold.numbers.mean_pressure - fold.errors.mean_pressure => {
                let gap = self.in_units(Estimate::new(fold.numbers.mean_gap, fold.errors.mean_gap), Measure::Height);
                let unit = if self.units == Units::Si { " m" } else { "" };
                let reason = format!("the contact parts at its fold, at the mean gap {:.6e}{unit}", gap.value);
                Refusal::NoSuchState { reason, limit_name: "least mean pressure of the contact", limit: fold.numbers.mean_pressure }
            }
            _ => refusal,
        }
    }

    /// The refusal in the units of the scene.
    pub(super) fn refuse(&self, row: &mut Row, refusal: &Refusal) {
        row.refuse(refusal);
        if let Refusal::NoSuchState { reason, limit_name, limit } = refusal {
            let (factor, unit) = if limit_name.contains("gap") { (self.scales.height, " m") } else { (self.scales.pressure, " Pa") };
            let unit = if self.units == Units::Si { unit } else { "" };
            let value = limit * factor;
            row.reason = Some(format!("no such state exists: {reason} ({limit_name}: {value:.6e}{unit})"));
            row.witness = Some(Witness { name: (*limit_name).to_owned(), value });
        }
    }

    /// What is asked of states that only lead to the wanted one: three grids that agree roughly are enough.
    pub(super) fn rough_request(&self) -> Request {
        let request = self.request();
        let own = self.profile.nodes()[0].next_power_of_two();
        Request { accuracy: request.accuracy.max(ON_THE_WAY), least_nodes: own.max(LEAST_ON_THE_WAY).min(request.least_nodes), ..request }
    }

    /// The state by the wanted way, and what happened on it.
    fn reached(&self, problem: &Problem) -> Result<(SteadyState, Option<String>), Refusal> {
        let request = self.request();
        // Without attraction the equations are strictly monotone, since each wave loses energy: one state exists, whatever the way to it.
        let several = matches!(self.sliding.reached_by, SurfacePath::Loading | SurfacePath::Unloading) && problem.attraction.attracts();
        let (Control::MeanPressure(wanted), true) = (problem.control, several) else {
            return solve(problem, &request).map(|state| (state, None));
        };
        let start = match self.sliding.reached_by {
            SurfacePath::Unloading => wanted.max(0.0) + HEAVY,
            _ => LIGHT.min(0.5 * wanted.abs()),
        };
        let at = |load: f64| Problem { control: Control::MeanPressure(load), ..problem.clone() };
        let rough = self.rough_request();
        let asked = |load: f64| if (wanted - load).abs() <= 1e-12 * (1.0 + wanted.abs()) { &request } else { &rough };
        let (mut load, mut jumps) = (start, Vec::new());
        let mut state = solve(&at(load), asked(load))?;
        let mut step = (wanted - start) / f64::from(STEPS);
        let shortest = step.abs() / f64::from(1_u32 << HALVINGS);
        while (wanted - load).abs() > 1e-12 * (1.0 + wanted.abs()) {
            let next = if (wanted - load).abs() <= step.abs() * (1.0 + 1e-9) { wanted } else { load + step };
            match follow(&at(next), &state, asked(next)) {
                Ok(found) => (state, load) = (found, next),
                Err(_) if step.abs() > shortest => step *= 0.5,
                // The branch ends here: the contact jumps to another state.
                Err(_) => {
                    let before = load * self.scales.pressure;
                    state = solve(&at(next), asked(next))?;
                    load = next;
                    jumps.push(format!("on the way the contact jumps beyond the mean pressure {before:.6e}"));
                }
            }
        }
        Ok((state, (!jumps.is_empty()).then(|| jumps.join("; "))))
    }

    /// The word of how a state was reached.
    pub(super) const fn way(&self, state: &SteadyState) -> &'static str {
        match (state.reached_by, self.sliding.reached_by) {
            (ReachedBy::FullContact, _) => "closed_form",
            (ReachedBy::Continuation, SurfacePath::Loading) => "loading",
            (ReachedBy::Continuation, SurfacePath::Unloading) => "unloading",
            (ReachedBy::AnotherLoad, _) => "another_load",
            (ReachedBy::Continuation, SurfacePath::LongRange | SurfacePath::Every) => "neighbour",
            (ReachedBy::ColdStart(Path::Range | Path::RangeThenRamp), _) => "long_range",
            (ReachedBy::ColdStart(Path::ModulusThenRange | Path::RangeThenModulus), _) => "relaxed_solid",
            (ReachedBy::ColdStart(Path::Closed), _) => "closed_gap",
        }
    }

    /// Values, labels and certificate of a state.
    pub(super) fn fill(&self, problem: &Problem, state: &SteadyState, row: &mut Row) -> Result<(), Refusal> {
        let fraction = state.numbers.contact_fraction;
        let kind = if fraction >= 1.0 {
            "full"
        } else if fraction > 0.0 {
            "partial"
        } else {
            "no_touch"
        };
        row.labels[1] = kind.to_owned();
        row.labels[2] = self.way(state).to_owned();
        row.values = self.values(problem, state);
        let stability = state.stability(problem);
        let full = fraction < 1.0 && full_contact(problem, &self.request()).is_ok();
        row.values.extend(self.stabilities(&stability, problem.control));
        row.values.push(Some(Estimate::exact(f64::from(u8::from(full)))));
        if stability.in_frame(problem.control.stiffness()) == Stability::Unstable {
            row.reason = Some(format!("{}a small disturbance leaves this state under what is held", after(row.reason.take())));
        }
        row.work += Work { kernel_evaluations: (state.node_products + stability.node_products()) as u64, ..Work::default() };
        row.assumptions = self.assumptions();
        if !state.accuracy_met {
            row.status = Status::Inaccurate;
            row.reason = Some(format!(
                "{}the accuracy {:.1e} is not met on {} nodes along x; about {} are expected to meet it: give sliding.most_nodes or a larger accuracy",
                after(row.reason.take()),
                self.accuracy,
                state.fields.nx,
                state.nodes_needed
            ));
        }
        let certificate = &state.certificate;
        let stress = state.numbers.repulsive_pressure.max(-state.numbers.adhesive_pressure).max(1e-300);
        let identity = (certificate.friction_by_surface - certificate.friction_by_loss).abs();
        // By the displaced surface and by the loss the friction is the same sum; by the profile it differs by the discretisation, within its bound.
        // Only a hard wall forbids gaps; where repulsion is part of the law they may be negative.
        let has_wall = problem.attraction.wall().is_some();
        let admissible = certificate.least_contact_pressure > -ADMISSIBLE * (1.0 + stress)
            && (!has_wall || certificate.least_gap > -ADMISSIBLE)
            && identity <= ADMISSIBLE * (1.0 + stress);
        if !admissible {
            row.witness = Some(Witness {
                name: "signs of the contact pressure or of the gap are violated, or two routes to the friction disagree; by".into(),
                value: identity.max(-certificate.least_contact_pressure).max(-certificate.least_gap),
            });
        }
        row.certificate = Some(Certificate { residual: certificate.residual.max(identity / (1.0 + stress)), condition: 1.0, admissible });
        row.representable(&columns(self.units))
    }

    /// Whether a state stays under a held pressure, a held gap and in the frame, if there is one.
    pub(super) fn stabilities(&self, stability: &StateStability, control: Control) -> [Option<Estimate>; 3] {
        let frame = matches!(control, Control::Frame { .. }).then(|| stability.in_frame(control.stiffness()));
        [Some(stability.under_mean_pressure()), Some(stability.under_mean_gap()), frame].map(|stability| match stability? {
            Stability::Stable => Some(Estimate::exact(1.0)),
            Stability::Unstable => Some(Estimate::exact(0.0)),
            Stability::Marginal => None,
        })
    }

    /// The values in the units of the scene, but for stability and other states.
    fn values(&self, problem: &Problem, state: &SteadyState) -> Vec<Option<Estimate>> {
        let (n, e) = (&state.numbers, &state.errors);
        let friction = Estimate::new(n.friction_stress, e.friction_stress);
        let coefficient = (n.mean_pressure > 0.0).then(|| {
            let value = n.friction_stress / n.mean_pressure;
            Estimate::new(value, (e.friction_stress + value.abs() * e.mean_pressure) / n.mean_pressure)
        });
        let by = |value: f64| Estimate::new(value, e.friction_stress + (value - n.friction_stress).abs());
        let reduced = [
            Some(Estimate::exact(self.sliding.speed)),
            Some(friction),
            coefficient,
            Some(match problem.control {
                Control::MeanPressure(pressure) => Estimate::exact(pressure),
                _ => Estimate::new(n.mean_pressure, e.mean_pressure),
            }),
            Some(match problem.control {
                Control::MeanGap(gap) => Estimate::exact(gap),
                _ => Estimate::new(n.mean_gap, e.mean_gap),
            }),
            Some(Estimate::new(n.contact_fraction, e.contact_fraction)),
            Some(Estimate::new(state.patches as f64, state.patches_error as f64)),
            Some(Estimate::new(n.adhesive_pressure, e.adhesive_pressure)),
            Some(Estimate::new(n.repulsive_pressure, e.repulsive_pressure)),
            Some(friction.scaled(problem.speed)),
            Some(Estimate::new(n.interface_energy, e.interface_energy)),
            Some(by(state.certificate.friction_by_surface)),
            Some(by(state.certificate.friction_by_profile)),
            Some(Estimate::exact(state.fields.nx as f64)),
        ];
        COLUMNS.iter().zip(reduced).map(|(definition, value)| Some(self.in_units(value?, definition.measure))).collect()
    }

    pub(super) fn in_units(&self, estimate: Estimate, measure: Measure) -> Estimate {
        let factor = measure.factor(&self.scales);
        let value = estimate.value * factor;
        let converts = self.units == Units::Si && !matches!(measure, Measure::Number | Measure::Speed);
        let rounding = if converts { CONVERSION * value.abs() } else { 0.0 };
        Estimate::new(value + 0.0, (estimate.error * factor).abs() + rounding)
    }

    /// What the assumptions are compared with, in the order of `describe::ASSUMPTIONS`.
    pub(super) fn assumptions(&self) -> Vec<Option<f64>> {
        let si = (self.units == Units::Si).then_some(());
        let peak = self.sliding.attraction.as_ref().map(|law| law.attraction.peak_stress() / self.material.glassy_modulus());
        vec![si.map(|()| self.slope()), si.and(peak)]
    }

    /// The root mean square slope of the profile, along x.
    pub(super) fn slope(&self) -> f64 {
        let squares: f64 = self.profile.amplitudes().iter().enumerate().map(|(i, a)| 0.5 * ((i + 1) as f64 * a).powi(2)).sum();
        squares.sqrt() * self.scales.height / self.scales.length
    }
}

/// What was said before, for one more sentence.
fn after(reason: Option<String>) -> String {
    reason.map_or_else(String::new, |reason| format!("{reason}; "))
}
