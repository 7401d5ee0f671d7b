//! One history: a summary, then the tip at the output times and at every event, in order of time.

use super::DelayedFracturePlan;
use super::columns::{COUNT, at, columns, name};
use crate::outcome::{Certificate, Row, Status, Witness, Work};
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::Units;
use viscotack::crack::delayed::trajectory::tends_to;
use viscotack::crack::delayed::{
    Event, EventKind, GrowthProblem, Onset, Regime, Sample, TipState, Trajectory, onset, refined_from, regime,
};
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;

/// What the errors of a history are measured against.
pub(super) struct Scales {
    time: f64,
    zone: f64,
    pub(super) speed: f64,
}

impl DelayedFracturePlan {
    pub(super) fn rows(&self, state: usize, swept: &[f64], state_watch: &StateWatch<'_>) -> Vec<Row> {
        let empty = |record: &str| Row::new(state, swept, vec![record.to_owned(), String::new(), String::new()], COUNT);
        self.solved(&empty, state_watch).unwrap_or_else(|refusal| {
            let mut row = empty("summary");
            row.refuse(&refusal);
            vec![row]
        })
    }

    fn solved(&self, empty: &dyn Fn(&str) -> Row, state_watch: &StateWatch<'_>) -> Result<Vec<Row>, Refusal> {
        let problem = self.problem()?;
        let outputs = self.output_times();
        let only_summary = outputs.is_empty() && self.is_one_step();
        // With no time asked for, events up to the end are still found.
        let asked = if outputs.is_empty() { vec![self.duration] } else { outputs.clone() };
        let excess = |found: &Trajectory| {
            let scales = self.scales(&problem, Some(found));
            let rows = self.rows_of(&problem, found, outputs.len(), empty);
            rows.iter().filter_map(|row| self.longest_bound(row, &scales)).map(|(_, bound)| bound).fold(0.0, f64::max) / self.accuracy
        };
        let found = if only_summary {
            None
        } else {
            Some(refined_from(&problem, &self.history, &asked, self.resolution(), &excess, state_watch.left_off(), state_watch)?)
        };
        let scales = self.scales(&problem, found.as_ref());
        let mut rows = vec![self.summary(&problem, found.as_ref(), empty("summary"), &scales)?];
        rows.extend(found.iter().flat_map(|found| self.rows_of(&problem, found, outputs.len(), empty)));
        for row in &mut rows {
            self.assess(row, &scales);
            row.representable(&columns(self.units))?;
        }
        Ok(rows)
    }

    /// The tip at the first so many samples and at all events, in order of time, and at the end.
    fn rows_of(&self, problem: &GrowthProblem<'_>, found: &Trajectory, outputs: usize, empty: &dyn Fn(&str) -> Row) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut events = found.events.iter().peekable();
        for sample in found.samples.iter().take(outputs) {
            while let Some(event) = events.next_if(|event| event.time.value <= sample.time) {
                rows.push(self.event_row(problem, event, empty("event")));
            }
            rows.push(self.sample_row(problem, sample, empty("sample")));
        }
        rows.extend(events.map(|event| self.event_row(problem, event, empty("event"))));
        if let Some(last) = found.samples.last() {
            let mut row = self.sample_row(problem, last, empty("event"));
            if let Some(event) = row.labels.get_mut(2) {
                *event = "end".into();
            }
            rows.push(row);
        }
        rows
    }

    fn scales(&self, problem: &GrowthProblem<'_>, found: Option<&Trajectory>) -> Scales {
        let samples = found.into_iter().flat_map(|found| &found.samples).filter_map(|sample| sample.speed);
        let events = found.into_iter().flat_map(|found| &found.events).flat_map(|event| match event.kind {
            EventKind::GrowthBegins { speed } | EventKind::Restart { speed } | EventKind::Arrest { speed_before: speed } => vec![speed],
            EventKind::Kink { speed_before, speed_after } => vec![speed_before, speed_after],
            EventKind::Jump { .. } | EventKind::Unbounded => Vec::new(),
        });
        let speed = samples.chain(events).map(|speed| speed.value).fold(0.0, f64::max);
        Scales { time: self.duration, zone: problem.process_zone_at(self.history.peak()), speed }
    }

    /// √2 in reduced units, where K is measured in √(2E0Δγ).
    fn intensity_unit(&self) -> f64 {
        if self.units == Units::Reduced { 0.5_f64.sqrt() } else { 1.0 }
    }

    /// The columns that the load alone decides: at an event it is known as well as the time is.
    fn load_values(&self, problem: &GrowthProblem<'_>, intensity: Estimate, row: &mut Row) {
        let [low, high] = [(intensity.value - intensity.error).max(0.0), intensity.value + intensity.error];
        let mut of_load = |column: usize, function: &dyn Fn(f64) -> f64| {
            let value = function(intensity.value);
            let spread = (function(low) - value).abs().max((function(high) - value).abs());
            put(row, column, Some(Estimate::new(value, spread + 4.0 * f64::EPSILON * value.abs())));
        };
        let modulus = self.plane_material.relaxed_modulus();
        of_load(at::STRESS_INTENSITY, &|load| load * self.intensity_unit());
        of_load(at::PROCESS_ZONE, &|load| problem.process_zone_at(load));
        if modulus > 0.0 {
            of_load(at::RATIO, &|load| self.crack.body.drive(self.crack.work_of_adhesion, load) / modulus);
        }
    }

    fn summary(&self, problem: &GrowthProblem<'_>, found: Option<&Trajectory>, mut row: Row, scales: &Scales) -> Result<Row, Refusal> {
        let (peak, last) = (self.history.peak(), self.history.last());
        let report = regime(problem, peak)?;
        let (inequality, left, right) = report.decision();
        let word = match report.regime {
            Regime::NoGrowth => "no_growth",
            Regime::Delayed => "delayed",
            Regime::Immediate => "immediate",
        };
        let held = if self.is_one_step() { "the load" } else { "the greatest load" };
        row.reason = Some(format!("under {held}: {inequality}, {left:.6e} against {right:.6e} J/m²"));
        if self.units == Units::Reduced {
            row.reason = Some(format!("under {held}: {inequality}, {left:.6e} against {right:.6e} (in Δγ)"));
        }
        // K and the release go as the load and its square.
        let more = (right / left).sqrt();
        if report.regime == Regime::NoGrowth && more.is_finite() {
            row.reason = row
                .reason
                .take()
                .map(|reason| format!("{reason}; held for long enough, a load more than {more:.5} times as large makes it grow"));
        }
        if let Some(state) = row.labels.get_mut(1) {
            *state = word.into();
        }
        self.load_values(problem, Estimate::exact(peak), &mut row);
        let work = self.crack.work_of_adhesion;
        let ratio = |release: f64| release.is_finite().then(|| Estimate::relative(release / work, 6.0 * f64::EPSILON));
        put(&mut row, at::RELAXED_RELEASE, ratio(report.relaxed_release));
        put(&mut row, at::GLASSY_RELEASE, ratio(report.glassy_release));
        let mut condition = 1.0;
        let begun = found.and_then(|found| {
            found.events.iter().find_map(|event| match event.kind {
                EventKind::GrowthBegins { speed } => Some((event.time, speed)),
                _ => None,
            })
        });
        if self.is_one_step() {
            if let Onset::After { delay, initial_speed, evaluations } = onset(problem, last)? {
                put(&mut row, at::DELAY, Some(delay));
                put(&mut row, at::INITIAL_SPEED, Some(initial_speed));
                row.work += self.onset_work(u64::from(evaluations));
                // t dJ/dt against 2J: how the delay feels the load.
                let rate = self.plane_material.creep_rate(delay.value) * delay.value;
                condition = (2.0 * self.plane_material.creep(delay.value) / rate).min(f64::MAX);
            }
        } else if let Some((time, speed)) = begun {
            put(&mut row, at::DELAY, Some(time));
            put(&mut row, at::INITIAL_SPEED, Some(speed));
        }
        match tends_to(problem, last, 1e-15) {
            Ok(steady) if regime(problem, last)?.regime == Regime::Delayed => {
                put(&mut row, at::STEADY_SPEED, Some(steady.speed));
                row.work.closure_evaluations += steady.curve_points;
                row.work.kernel_evaluations += steady.kernel_evaluations;
            }
            _ => {}
        }
        let Some(found) = found else {
            row.certificate = Some(Certificate { residual: f64::EPSILON, condition, admissible: true });
            row.assumptions = self.assumptions(problem, scales);
            return Ok(row);
        };
        put(&mut row, at::TIME, Some(Estimate::exact(self.duration)));
        if let Some(end) = found.samples.last() {
            put(&mut row, at::GROWTH, end.growth);
            put(&mut row, at::SPEED, end.speed);
        }
        put(&mut row, at::STEPS, Some(Estimate::exact(found.work.steps as f64)));
        put(&mut row, at::PIECES, Some(Estimate::exact(found.work.most_pieces as f64)));
        row.work += Work {
            closure_evaluations: found.work.closure_evaluations,
            kernel_evaluations: found.work.kernel_evaluations,
            ..Work::default()
        };
        // A tip that never heals never goes back.
        let places: Vec<Estimate> = found.samples.iter().filter_map(|sample| sample.growth).collect();
        let forward = places.windows(2).all(|pair| matches!(pair, [one, two] if two.value + two.error + one.error >= one.value));
        let admissible = forward && found.samples.iter().filter_map(|sample| sample.speed).all(|speed| speed.value + speed.error >= 0.0);
        row.certificate = Some(Certificate { residual: found.residual, condition, admissible });
        if !admissible {
            let back = places.iter().zip(places.iter().skip(1)).map(|(one, two)| two.value - one.value).fold(0.0, f64::min);
            row.witness = Some(Witness { name: "growth that goes back".into(), value: back });
        }
        row.assumptions = self.assumptions(problem, scales);
        Ok(row)
    }

    fn sample_row(&self, problem: &GrowthProblem<'_>, sample: &Sample, mut row: Row) -> Row {
        let word = match sample.state {
            TipState::Resting => "resting",
            TipState::Growing => "growing",
            TipState::Unbounded => "unbounded",
        };
        if let Some(state) = row.labels.get_mut(1) {
            *state = word.into();
        }
        put(&mut row, at::TIME, Some(Estimate::exact(sample.time)));
        put(&mut row, at::GROWTH, sample.growth);
        put(&mut row, at::SPEED, sample.speed);
        self.load_values(problem, Estimate::exact(sample.intensity), &mut row);
        row
    }

    fn event_row(&self, problem: &GrowthProblem<'_>, event: &Event, mut row: Row) -> Row {
        let (word, state, speed, before, jump) = match event.kind {
            EventKind::GrowthBegins { speed } => ("onset", "growing", Some(speed), None, None),
            EventKind::Restart { speed } => ("restart", "growing", Some(speed), None, None),
            EventKind::Arrest { speed_before } => ("arrest", "resting", Some(Estimate::exact(0.0)), Some(speed_before), None),
            EventKind::Jump { distance } => ("jump", "growing", None, None, Some(distance)),
            EventKind::Kink { speed_before, speed_after } => ("kink", "growing", Some(speed_after), Some(speed_before), None),
            EventKind::Unbounded => ("unbounded", "unbounded", None, None, None),
        };
        row.labels = vec!["event".into(), state.into(), word.into()];
        put(&mut row, at::TIME, Some(event.time));
        put(&mut row, at::GROWTH, Some(event.growth));
        put(&mut row, at::SPEED, speed);
        put(&mut row, at::SPEED_BEFORE, before);
        put(&mut row, at::JUMP, jump);
        self.load_values(problem, self.history.around(event.time), &mut row);
        row
    }

    /// The longest error bound of a row over the larger of its value and its reference scale, and the column.
    fn longest_bound(&self, row: &Row, scales: &Scales) -> Option<(usize, f64)> {
        let scale = |column: usize| match column {
            at::TIME | at::DELAY if !self.is_one_step() => scales.time,
            at::TIME => scales.time,
            at::GROWTH | at::JUMP => scales.zone,
            at::SPEED | at::SPEED_BEFORE | at::INITIAL_SPEED => scales.speed,
            _ => 0.0,
        };
        let bounds = row.values.iter().enumerate().filter_map(|(column, value)| {
            let estimate = (*value)?;
            let measure = estimate.value.abs().max(scale(column));
            (estimate.error > 0.0).then(|| (column, estimate.error / measure))
        });
        bounds.max_by(|(_, one), (_, other)| one.total_cmp(other))
    }

    /// Flags a row with an error bound above the wanted accuracy.
    fn assess(&self, row: &mut Row, scales: &Scales) {
        if let Some((column, error)) = self.longest_bound(row, scales).filter(|(_, error)| *error > self.accuracy) {
            row.status = Status::Inaccurate;
            row.reason =
                Some(format!("the error bound of {} is {error:.1e}, above the wanted accuracy {:.1e}", name(column), self.accuracy));
        }
    }
}

fn put(row: &mut Row, column: usize, value: Option<Estimate>) {
    if let Some(place) = row.values.get_mut(column) {
        *place = value;
    }
}
