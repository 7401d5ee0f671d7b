//! One state of an indentation as rows: its answer first, then the kept instants, the events, the largest tension, and the instants of fields, in the order of time.

use super::IndentationPlan;
use super::columns::{COLUMNS, Measure, at, columns, present};
use super::events::{is_held_at_its_end, word};
use super::remarks::remarks;
use super::shift::{Shift, widened};
use crate::outcome::{Certificate, Row, Status, Witness, Work};
use crate::plan::curves::thinned;
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::IndentationShape;
use viscotack::elastic::JkrSphere;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Cycle, IndentationSolution, Instant, PathPoint};
use viscotack::refusal::Refusal;

/// Rounding of the way from a scene to coherent units and back, relative.
const CONVERSION: f64 = 4.0 * f64::EPSILON;

/// Overlap and pressed edges that rounding leaves, over the largest penetration and stress intensity.
const ADMISSIBLE: f64 = 1e-7;

/// The words of the row of a state, and of rows of instants and cycles.
pub(super) const SUMMARY: &str = crate::outcome::SUMMARY;
pub(super) const INSTANT: &str = "instant";
pub(super) const CYCLE: &str = "cycle";
pub(super) const REPETITION: &str = "repetition";

/// The word of the row of the largest tension.
pub(super) const LARGEST_TENSION: &str = "largest_tension";

/// Values of a row in the order of the columns, coherent.
pub(super) type Values = Vec<Option<Estimate>>;

impl IndentationPlan {
    pub(super) fn rows(&self, state: usize, swept: &[f64], state_watch: &StateWatch<'_>) -> Vec<Row> {
        let solved = self.solution(state_watch).and_then(|solution| {
            let rows = self.rows_of(&solution, state, swept)?;
            Ok(rows)
        });
        solved.unwrap_or_else(|refusal| vec![self.refused(state, swept, &refusal)])
    }

    /// The row of a state that is refused.
    pub(super) fn refused(&self, state: usize, swept: &[f64], refusal: &Refusal) -> Row {
        let mut row = self.row(state, swept, [SUMMARY, ""]);
        row.refuse(refusal);
        row
    }

    fn row(&self, state: usize, swept: &[f64], labels: [&str; 2]) -> Row {
        Row::new(state, swept, labels.map(str::to_owned).to_vec(), present(&self.indentation).len())
    }

    fn rows_of(&self, solution: &IndentationSolution, state: usize, swept: &[f64]) -> Result<Vec<Row>, Refusal> {
        let mut timed: Vec<(f64, Row)> = Vec::new();
        let scales = self.reference_scales(solution);
        let ends = self.ends_of_segments(solution)?;
        let shifts: Vec<Shift> = ends.iter().filter_map(|end| end.2).collect();
        let mut add = |labels: [&str; 2], mut values: Values, residual: f64| -> Result<(), Refusal> {
            let mut row = self.row(state, swept, labels);
            let time = values.get(at::TIME).copied().flatten().map_or(0.0, |time| time.value);
            widened(&mut values, &COLUMNS.map(|column| (column.name, column.measure)), &scales, &shifts);
            self.fill(&mut row, values, &scales, residual, solution)?;
            timed.push((time, row));
            Ok(())
        };
        for event in &solution.events {
            add(["event", word(event.kind)], self.of_event(event, &scales), 0.0)?;
        }
        for (word, values, _) in &ends {
            add(["event", word], values.clone(), 0.0)?;
        }
        let last = solution.instants.len().saturating_sub(1);
        for (index, instant) in solution.instants.iter().enumerate() {
            let mut values = self.of_instant(instant);
            if index == last {
                let count = |number: u64| Some(Estimate::exact(number as f64));
                let [steps, panels] = [solution.integration.work.steps, solution.integration.work.most_panels].map(count);
                let reported =
                    [(at::BALANCE_DEFECT, solution.balance_defect.map(Estimate::exact)), (at::STEPS, steps), (at::PANELS, panels)];
                for (place, value) in reported {
                    if let Some(cell) = values.get_mut(place) {
                        *cell = value;
                    }
                }
            }
            add([INSTANT, ""], values, instant.residual)?;
        }
        if let Some(values) = self.of_largest_tension(solution, &scales) {
            add(["event", LARGEST_TENSION], values, 0.0)?;
        }
        for (index, point) in self.between_instants(solution, &scales) {
            add([INSTANT, ""], self.of_path_point(solution, index, point), point.residual)?;
        }
        let cycles = self.cycles(solution);
        for cycle in cycles.shown() {
            let mut values: Values = vec![None; COLUMNS.len()];
            cycles.put(&mut values, cycle, &scales);
            add([CYCLE, ""], values, 0.0)?;
        }
        for repetition in self.repetitions_shown() {
            if let Some(values) = self.of_repetition(solution, repetition) {
                add([REPETITION, ""], values, 0.0)?;
            }
        }
        let mut field_rows = Vec::new();
        if let Some(wanted) = &self.indentation.fields {
            for found in self.fields_of(solution, wanted)? {
                let mut row = self.row(state, swept, ["fields", ""]);
                let time = found.values.get(at::TIME).copied().flatten().map_or(0.0, |time| time.value);
                self.fill(&mut row, found.values, &scales, 0.0, solution)?;
                row.fields = found.points;
                row.work.field_evaluations = row.fields.len() as u64;
                field_rows.push((time, row));
            }
        }
        timed.extend(field_rows);
        timed.sort_by(|first, second| first.0.total_cmp(&second.0));
        let mut rows: Vec<Row> = timed.into_iter().map(|(_, row)| row).collect();
        let mut answer = self.row(state, swept, [SUMMARY, ""]);
        let mut values = self.of_state(solution, &scales);
        widened(&mut values, &COLUMNS.map(|column| (column.name, column.measure)), &scales, &shifts);
        self.put(&mut answer, values, solution.residual, &scales, solution);
        // A state is known as well as all that lies on its way.
        let inaccurate = || rows.iter().filter(|row| row.status == Status::Inaccurate);
        if let Some(first) = inaccurate().next() {
            answer.status = Status::Inaccurate;
            let more = inaccurate().count();
            answer.reason = first.reason.as_ref().map(|reason| format!("{reason} ({more} of {} rows on the way)", rows.len()));
        } else {
            answer.reason = remarks(&self.timeline.ends, is_held_at_its_end(solution));
        }
        rows.insert(0, answer);
        if let Some(first) = rows.first_mut() {
            first.work.closure_evaluations = solution.work.closure_evaluations;
            first.work.kernel_evaluations = solution.work.history_updates;
        }
        let table = columns(&self.indentation, self.units);
        for row in &mut rows {
            row.representable(&table)?;
        }
        Ok(rows)
    }

    /// The largest magnitude of each quantity in the history: what errors are relative to where it passes through zero.
    fn reference_scales(&self, solution: &IndentationSolution) -> Vec<f64> {
        let mut scales = vec![0.0_f64; COLUMNS.len()];
        for instant in &solution.instants {
            for (scale, value) in scales.iter_mut().zip(self.of_instant(instant)) {
                *scale = scale.max(value.map_or(0.0, |value| value.value.abs()));
            }
        }
        // As the accuracy of the integration is over the largest force.
        let force = scales.get(at::FORCE).copied().unwrap_or(0.0).max(solution.pull_off_force().map_or(0.0, |tension| tension.value));
        let mut at_least = |place: usize, least: f64| {
            if let Some(scale) = scales.get_mut(place) {
                *scale = scale.max(least);
            }
        };
        at_least(at::FORCE, force);
        at_least(at::PULL_OFF_RATIO, self.jkr_pull_off().map_or(0.0, |unit| force / unit));
        at_least(at::TIME, self.timeline.duration());
        for (place, scale) in self.cycles(solution).scales() {
            at_least(place, scale);
        }
        if let Some(adhesion) = self.adhesion() {
            at_least(at::STRESS_INTENSITY, (2.0 * self.material.glassy_modulus() * adhesion.work_of_adhesion).sqrt());
        }
        // Release rates by the larger of both, and at least by what the interface takes.
        let release = [at::TIP_RELEASE_RATE, at::ENERGY_RELEASE_RATE].iter().filter_map(|&place| scales.get(place));
        let release = release.fold(self.adhesion().map_or(0.0, |adhesion| adhesion.work_of_adhesion), |most: f64, scale| most.max(*scale));
        for place in [at::TIP_RELEASE_RATE, at::ENERGY_RELEASE_RATE] {
            if let Some(scale) = scales.get_mut(place) {
                *scale = release;
            }
        }
        // Energies turn into each other: all are assessed by the largest.
        let energy = [at::STORED_ENERGY, at::EXTERNAL_WORK, at::DISSIPATED_ENERGY]
            .iter()
            .filter_map(|&place| scales.get(place))
            .fold(0.0, |most: f64, scale| most.max(*scale));
        for place in [at::STORED_ENERGY, at::EXTERNAL_WORK, at::DISSIPATED_ENERGY] {
            if let Some(scale) = scales.get_mut(place) {
                *scale = energy;
            }
        }
        scales
    }

    /// (3/2)πRΔγ, coherent: JKR's pull-off force does not feel the modulus.
    pub(super) fn jkr_pull_off(&self) -> Option<f64> {
        match (self.adhesion(), &self.indentation.shape) {
            (Some(adhesion), &IndentationShape::Sphere { radius }) if self.profile.rim().is_infinite() => {
                JkrSphere::new(radius, self.relaxed, adhesion.work_of_adhesion).ok().map(|sphere| sphere.pull_off_force().abs())
            }
            _ => None,
        }
    }

    /// The far end of the frame, if there is one.
    fn far_end(&self, penetration: Estimate, force: Estimate) -> Option<Estimate> {
        let stiffness = self.indentation.frame_stiffness? * self.scale.force;
        Some(Estimate::new(penetration.value + force.value / stiffness, penetration.error + force.error / stiffness))
    }

    /// The values that every row has, and the places of the others empty.
    pub(super) fn basic(&self, time: Estimate, penetration: Estimate, force: Estimate, contact_radius: Estimate) -> Values {
        let mut values: Values = vec![None; COLUMNS.len()];
        let far_end = self.far_end(penetration, force);
        let measured = self.timeline.measured_force(time.value, &self.scale).map(Estimate::exact);
        for (place, value) in [
            (at::TIME, Some(time)),
            (at::PENETRATION, Some(penetration)),
            (at::FORCE, Some(force)),
            (at::CONTACT_RADIUS, Some(contact_radius)),
            (at::FRAME, far_end),
            (at::MEASURED_FORCE, measured),
        ] {
            if let Some(cell) = values.get_mut(place) {
                *cell = value;
            }
        }
        values
    }

    pub(super) fn of_instant(&self, instant: &Instant) -> Values {
        let mut values = self.basic(Estimate::exact(instant.time), instant.penetration, instant.force, instant.contact_radius);
        // Without adhesion they are found for the work of repetitions, asked for or not.
        let energies = instant.energies.filter(|_| self.indentation.energies);
        let energy = |which: usize| energies.and_then(|energies| energies.get(which).copied());
        for (place, value) in [
            (at::STRESS_INTENSITY, self.indentation.adhesion.map(|_| instant.stress_intensity_factor)),
            (at::STORED_ENERGY, energy(0)),
            (at::DISSIPATED_POWER, energy(1)),
            (at::EXTERNAL_WORK, energy(2)),
            (at::DISSIPATED_ENERGY, energy(3)),
            (at::TIP_RELEASE_RATE, instant.tip_release_rate.filter(|_| self.indentation.energies)),
            (at::ENERGY_RELEASE_RATE, instant.energy_release_rate.filter(|_| self.indentation.energies)),
            (at::RESIDUAL, Some(Estimate::exact(instant.residual))),
        ] {
            if let Some(cell) = values.get_mut(place) {
                *cell = value;
            }
        }
        values
    }

    /// Points of the path inside ramps that begin where only the solver knows, and inside oscillations: those that the other paths show to the accuracy. Beside a corner
    /// another path has no point, and between its points no more is known than their distance tells.
    fn between_instants<'p>(&self, solution: &'p IndentationSolution, scales: &[f64]) -> Vec<(usize, &'p PathPoint)> {
        let columns = [at::PENETRATION, at::FORCE, at::CONTACT_RADIUS, at::STRESS_INTENSITY];
        let columns = columns.get(..if self.indentation.adhesion.is_some() { 4 } else { 3 }).unwrap_or(&columns);
        let known = |&(index, _): &(usize, &PathPoint)| {
            let errors = solution.path_errors.get(index);
            let within = |(error, column): (&f64, &usize)| *error <= self.solver_accuracy * scales.get(*column).copied().unwrap_or(0.0);
            errors.is_some_and(|errors| errors.iter().zip(columns).all(within))
        };
        let path = || solution.integration.path.iter().enumerate();
        let inside = |&(from, to): &(f64, f64)| {
            let points: Vec<_> = path().filter(|(_, point)| point.time > from && point.time < to).filter(known).collect();
            thinned(points, self.indentation.instants as usize)
        };
        self.timeline.open_ramps.iter().flat_map(inside).chain(self.in_oscillations(solution).into_iter().filter(known)).collect()
    }

    /// A point between two kept instants, known as the other integrations show it and no better than the worse of both: there a quantity may be imposed, and have no
    /// error.
    pub(super) fn of_path_point(&self, solution: &IndentationSolution, index: usize, point: &PathPoint) -> Values {
        let after = solution.instants.partition_point(|instant| instant.time < point.time).min(solution.instants.len().saturating_sub(1));
        let own = solution.path_errors.get(index).copied().unwrap_or([f64::INFINITY; 4]);
        let known = |value: f64, own: f64, of: fn(&Instant) -> Estimate| {
            let neighbours = [after.saturating_sub(1), after].into_iter().filter_map(|place| solution.instants.get(place));
            Estimate::new(value, neighbours.fold(own, |most: f64, instant| most.max(of(instant).error)))
        };
        // Within a cycle not better than its extremes.
        let cycle = solution.cycles.iter().find(|cycle| cycle.start <= point.time && point.time <= cycle.end);
        let within = |estimate: Estimate, of: fn(&Cycle<Estimate>) -> &[Estimate; 2]| {
            let errors = cycle.into_iter().flat_map(of).map(|extreme| extreme.error).filter(|error| error.is_finite());
            Estimate::new(estimate.value, errors.fold(estimate.error, f64::max))
        };
        let mut values = self.basic(
            Estimate::exact(point.time),
            within(known(point.penetration, own[0], |instant| instant.penetration), |cycle| &cycle.penetration),
            within(known(point.force, own[1], |instant| instant.force), |cycle| &cycle.force),
            within(known(point.contact_radius, own[2], |instant| instant.contact_radius), |cycle| &cycle.contact_radius),
        );
        if let (Some(cell), true) = (values.get_mut(at::STRESS_INTENSITY), self.indentation.adhesion.is_some()) {
            *cell = Some(known(point.stress_intensity_factor, own[3], |instant| instant.stress_intensity_factor));
        }
        values
    }

    /// Puts coherent values into a row in the units of the scene, with its certificate; flags a row whose bounds are too wide.
    fn fill(&self, row: &mut Row, values: Values, scales: &[f64], residual: f64, solution: &IndentationSolution) -> Result<(), Refusal> {
        // When and where the tension is largest is a matter of how flat the curve is; only the tension itself is assessed.
        // G divides by the speed of the edge: beside a turn it is known as its bound says, and no better. Drift and spread are what is left between cycles.
        let assessed = |place: usize| {
            row.label(0) != REPETITION
                && (row.label(1) != LARGEST_TENSION || matches!(place, at::FORCE | at::PULL_OFF_RATIO))
                && !matches!(place, at::ENERGY_RELEASE_RATE | at::DRIFT | at::SPREAD)
        };
        let shortfall = COLUMNS.iter().zip(&values).zip(scales).enumerate().find_map(|(place, ((definition, value), scale))| {
            let estimate = (*value)?;
            let size = estimate.value.abs().max(*scale);
            (assessed(place) && estimate.error > self.accuracy * size).then(|| (definition.name, estimate.error / size))
        });
        if let Some((name, error)) = shortfall {
            row.status = Status::Inaccurate;
            row.reason = Some(format!("the error bound of {name} is {error:.1e}, above the wanted accuracy {:.1e}", self.accuracy));
        }
        self.put(row, values, residual, scales, solution);
        row.assumptions = self.assumptions(row);
        row.work = Work::default();
        Ok(())
    }

    /// The values of a row in the units of the scene, and its certificate.
    fn put(&self, row: &mut Row, values: Values, residual: f64, scales: &[f64], solution: &IndentationSolution) {
        let shown = |place: usize| Some(self.in_units(values.get(place).copied().flatten()?, COLUMNS.get(place)?.measure));
        row.values = present(&self.indentation).into_iter().map(shown).collect();
        // Rounding of the edge condition leaves 1e-9 of either scale.
        let [intensity, depth] = [at::STRESS_INTENSITY, at::PENETRATION].map(|place| scales.get(place).copied().unwrap_or(0.0));
        // Of the whole history: what overlapped once has spoiled all that follows.
        let violated = [
            ("smallest gap outside the contact", solution.smallest_gap_factor, depth, true),
            ("smallest stress intensity", solution.smallest_stress_intensity_factor, intensity, self.indentation.adhesion.is_some()),
        ]
        .into_iter()
        .find(|(_, least, scale, assessed)| *assessed && (least.is_nan() || *least < -ADMISSIBLE * scale));
        row.certificate = Some(Certificate { residual, condition: 1.0, admissible: violated.is_none() });
        row.witness = violated.map(|(name, value, ..)| Witness { name: name.into(), value });
    }

    /// A coherent value in the units of the scene.
    pub(super) fn in_units(&self, estimate: Estimate, measure: Measure) -> Estimate {
        let converted = match measure {
            Measure::Force | Measure::Energy | Measure::Power | Measure::EnergyPerArea | Measure::Stiffness => {
                let scaled = estimate.scaled(1.0 / self.scale.force);
                Estimate::new(scaled.value, scaled.error + if scaled.error > 0.0 { CONVERSION * scaled.value.abs() } else { 0.0 })
            }
            Measure::Time | Measure::Length | Measure::Intensity | Measure::Frequency | Measure::Angle | Measure::Number => estimate,
        };
        // An open contact has the force 0, not −0.
        Estimate::new(converted.value + 0.0, converted.error)
    }
}
