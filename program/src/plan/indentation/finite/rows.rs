//! One state as rows: its answer first, then instants, events, the largest tension and the instants of fields, in the order of time.

use super::super::columns::Measure;
use super::super::locate::State;
use super::super::remarks::remarks;
use super::super::rows::{CYCLE, INSTANT, LARGEST_TENSION, REPETITION, SUMMARY, Values};
use super::super::shift::{self, CONDITION_MET, LIMIT_REACHED, Shift};
use super::FiniteRangePlan;
use super::bounds::Runs;
use super::columns::{COLUMNS, at, columns, present};
use super::widened::{EXTREMES, Floors, widened};
use crate::outcome::{Certificate, Row, Status, Witness, Work};
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::Condition;
use std::f64::consts::PI;
use viscotack::estimate::Estimate;
use viscotack::finite_range::sphere::{Accuracy, Jump, LegSummary, Margins, Record, Run};
use viscotack::refusal::Refusal;

/// The word of the row where a contact ends.
pub(super) const DETACHMENT: &str = "detachment";

/// Heat that may be negative by rounding and truncation, over the energies turned over.
const ADMISSIBLE: f64 = 1e-3;
/// The end of a contact comes slowly, so that its instant settles later than all else: so many times the change between two runs.
const SOFT: f64 = 4.0;
/// A bound is never smaller than this part of its value.
const ROUNDING: f64 = 1e-11;

/// The end of a segment with a condition: the word, the values there, and what follows from the bound on its time.
type End = (&'static str, Values, Option<Shift>);

impl FiniteRangePlan {
    pub(super) fn rows(&self, state: usize, swept: &[f64], state_watch: &StateWatch<'_>) -> Vec<Row> {
        let solved = self.runs(state_watch).and_then(|runs| self.rows_of(&runs, state, swept));
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

    fn rows_of(&self, runs: &Runs, state: usize, swept: &[f64]) -> Result<Vec<Row>, Refusal> {
        let instants: Vec<Values> = self.instants(runs).iter().map(|(loose, tight)| self.of_record(loose, tight, runs)).collect();
        let floors = Floors::of(&instants);
        let mut all: Vec<([&str; 2], Values)> = widened(&instants).into_iter().map(|values| ([INSTANT, ""], values)).collect();
        let jumps =
            runs.tight.jumps.iter().enumerate().map(|(index, jump)| (runs.loose.jumps.get(index).filter(|_| runs.consistent), jump));
        for (loose, tight) in jumps.filter(|(_, jump)| jump.radius_after > 0.0) {
            let word = if tight.radius_after > tight.radius_before { "jump_in" } else { "partial_detachment" };
            all.push((["event", word], self.of_jump(loose, tight, runs)));
        }
        for (index, tight) in runs.tight.losses.iter().enumerate() {
            let loose = runs.loose.losses.get(index).filter(|_| runs.consistent);
            all.push((["event", DETACHMENT], self.of_loss(loose, tight, runs)));
        }
        if let Some(values) = self.of_largest_tension(runs, &floors) {
            all.push((["event", LARGEST_TENSION], values));
        }
        let ends = self.ends_of_segments(runs)?;
        all.extend(ends.iter().map(|(word, values, _)| (["event", *word], values.clone())));
        let repetitions = self.of_repetitions(runs);
        let last_repetition = repetitions.last().cloned();
        all.extend(repetitions.into_iter().map(|values| ([REPETITION, ""], values)));
        all.iter_mut().for_each(|(_, values)| floors.raise(values));
        let end = all.iter().rfind(|(labels, _)| labels[0] == INSTANT).map(|(_, values)| values.clone());
        let mut scales = vec![0.0_f64; COLUMNS.len()];
        for (_, values) in &all {
            scales.iter_mut().zip(values).for_each(|(scale, value)| *scale = scale.max(value.map_or(0.0, |value| value.value.abs())));
        }
        let energy = at::ENERGIES.iter().filter_map(|&place| scales.get(place)).fold(0.0_f64, |most, scale| most.max(*scale));
        for place in at::ENERGIES {
            if let Some(scale) = scales.get_mut(place) {
                *scale = energy;
            }
        }
        // What is far smaller than the range and the scale of the force is no scale for either.
        let units = &self.reduced.scales;
        let least = [
            (at::TIME, self.timeline.duration()),
            (at::PENETRATION, units.gap),
            (at::FORCE, units.force),
            (at::CONTACT_RADIUS, units.radius),
        ];
        let known = self.cycles_of(runs)?;
        let cycles = self.as_rows(&known);
        for (place, least) in cycles.scales().into_iter().chain(least) {
            if let Some(scale) = scales.get_mut(place) {
                *scale = scale.max(least);
            }
        }
        for (extreme, place) in EXTREMES {
            let of_instants = scales.get(place).copied().unwrap_or(0.0);
            if let Some(scale) = scales.get_mut(extreme) {
                *scale = scale.max(of_instants);
            }
        }
        let mut last_cycle = None;
        for cycle in cycles.shown() {
            let mut values: Values = vec![None; COLUMNS.len()];
            cycles.put(&mut values, cycle, &scales);
            floors.raise_extremes(&mut values);
            last_cycle = Some(values.clone());
            all.push(([CYCLE, ""], values));
        }
        let shifts: Vec<Shift> = ends.iter().filter_map(|end| end.2).collect();
        let mut timed: Vec<(f64, Row)> = Vec::new();
        for (labels, mut values) in all {
            let mut row = self.row(state, swept, labels);
            let time = values.first().copied().flatten().map_or(0.0, |time| time.value);
            shift::widened(&mut values, &COLUMNS.map(|column| (column.name, column.measure)), &scales, &shifts);
            self.fill(&mut row, values, &scales, runs);
            timed.push((time, row));
        }
        for (mut values, points) in self.fields_of(runs) {
            floors.raise(&mut values);
            let mut row = self.row(state, swept, ["fields", ""]);
            let time = values.first().copied().flatten().map_or(0.0, |time| time.value);
            shift::widened(&mut values, &COLUMNS.map(|column| (column.name, column.measure)), &scales, &shifts);
            self.fill(&mut row, values, &scales, runs);
            row.work.field_evaluations = points.len() as u64;
            row.fields = points;
            timed.push((time, row));
        }
        timed.sort_by(|first, second| first.0.total_cmp(&second.0));
        let mut rows: Vec<Row> = timed.into_iter().map(|(_, row)| row).collect();
        let mut answer = self.row(state, swept, [SUMMARY, ""]);
        let mut values = self.of_state(runs, &floors, end.as_ref());
        let cell = |row: &Option<Values>, place: usize| row.as_ref().and_then(|row| row.get(place).copied().flatten());
        set(&mut values, at::OF_THE_LAST_CYCLE.map(|place| (place, cell(&last_cycle, place))));
        // Of whatever repeats last.
        let ended = |row: &Option<Values>| cell(row, at::TIME).map(|time| time.value);
        if ended(&last_repetition) > ended(&last_cycle) {
            set(&mut values, [(at::WORK_PER_CYCLE, cell(&last_repetition, at::WORK_PER_CYCLE))]);
        }
        shift::widened(&mut values, &COLUMNS.map(|column| (column.name, column.measure)), &scales, &shifts);
        self.put(&mut answer, values, runs);
        self.conclude(&mut answer, &rows, runs);
        rows.insert(0, answer);
        let table = columns(&self.indentation, self.units);
        for row in &mut rows {
            row.representable(&table)?;
        }
        Ok(rows)
    }

    /// A state with its bounds, coherent.
    pub(super) fn of_record_state(&self, loose: &Record, tight: &Record) -> State<Estimate> {
        State {
            time: tight.time,
            penetration: self.depth(loose.penetration, tight.penetration),
            force: self.between(loose.force, tight.force, self.reduced.scales.force),
            contact_radius: self.between(loose.contact_radius, tight.contact_radius, self.reduced.scales.radius),
        }
    }

    /// Where segments with a condition end: the word, the values there, and what follows from the bound on the time.
    fn ends_of_segments(&self, runs: &Runs) -> Result<Vec<End>, Refusal> {
        let compliance = self.indentation.frame_stiffness.map_or(0.0, |stiffness| 1.0 / (stiffness * self.scale.force));
        let mut ends = Vec::new();
        let instants = self.instants(runs);
        for ended in &self.timeline.ends {
            let far = |record: &Record| (record.time - ended.time).abs();
            let Some((loose, tight)) = instants.iter().min_by(|one, other| far(one.1).total_cmp(&far(other.1))) else { continue };
            let at_end = self.of_record_state(loose, tight);
            let values = self.basic(Estimate::exact(ended.time), at_end.penetration, at_end.force, at_end.contact_radius);
            if !ended.met || ended.exact {
                ends.push((if ended.met { CONDITION_MET } else { LIMIT_REACHED }, values, None));
                continue;
            }
            let states: Vec<State<f64>> = runs.tight.rows.iter().filter(|row| row.time <= ended.time).map(|row| self.state(row)).collect();
            let within = |time: f64| time >= ended.began && time <= ended.time;
            let times: [Option<f64>; 2] = [&runs.loose, &runs.tight].map(|run| {
                let losses = run.losses.iter().map(|loss| loss.time);
                losses.chain(run.jumps.iter().map(|jump| jump.time)).filter(|time| within(*time)).reduce(f64::max)
            });
            let lost = match times {
                [Some(loose), Some(tight)] => Some(Estimate::new(tight, (loose - tight).abs())),
                _ => None,
            };
            if ended.condition == Condition::Detachment && lost.is_none() {
                return Err(Refusal::NotConverged {
                    what: "the end of a segment by detachment",
                    detail: "a tighter solution detaches later; ask for a higher accuracy".into(),
                });
            }
            ends.push((CONDITION_MET, values, Some(Shift::of(ended, &at_end, &states, lost, compliance))));
        }
        Ok(ends)
    }

    /// A state is known as well as all that lies on its way.
    fn conclude(&self, answer: &mut Row, rows: &[Row], runs: &Runs) {
        answer.work.linear_solves = runs.systems;
        let inaccurate = || rows.iter().filter(|row| row.status == Status::Inaccurate);
        if let Some(first) = inaccurate().next() {
            answer.status = Status::Inaccurate;
            let more = inaccurate().count();
            answer.reason = first.reason.as_ref().map(|reason| format!("{reason} ({more} of {} rows on the way)", rows.len()));
        } else if !runs.consistent {
            answer.status = Status::Inaccurate;
            answer.reason =
                Some("runs of different tolerances disagree about jumps or the end of contact; ask for a higher accuracy".into());
        } else {
            let end = runs.tight.rows.last().filter(|_| runs.tight.detachment.is_none());
            let held = end.zip(self.pulling(runs)).is_some_and(|(end, (_, tight))| tight.largest_tension.time >= end.time);
            answer.reason = remarks(&self.timeline.ends, held);
        }
        if let Some(refusal) = &runs.refused {
            let before = answer.reason.take().map_or_else(String::new, |reason| format!("{reason}; "));
            answer.reason = Some(format!("{before}a finer solution is refused: {refusal}"));
        }
    }

    /// The tighter value, with the change between both runs as its bound.
    pub(super) fn between(&self, loose: f64, tight: f64, unit: f64) -> Estimate {
        self.reduced.of(tight, self.change(loose, tight), unit)
    }

    pub(super) fn depth(&self, loose: f64, tight: f64) -> Estimate {
        self.reduced.penetration(tight, self.change(loose, tight))
    }

    /// The bound of a tighter value.
    pub(super) fn change(&self, loose: f64, tight: f64) -> f64 {
        let Margins { of_change: factor, by_chance } = Margins::of_law(&self.reduced.law);
        let by_chance = by_chance * Accuracy::of_law(self.solver_accuracy, &self.reduced.law).tightened().step;
        factor * (loose - tight).abs() + (by_chance + ROUNDING) * tight.abs()
    }

    /// The far end of the frame, if there is one.
    fn far_end(&self, penetration: Estimate, force: Estimate) -> Option<Estimate> {
        let stiffness = self.indentation.frame_stiffness? * self.scale.force;
        Some(Estimate::new(penetration.value + force.value / stiffness, penetration.error + force.error / stiffness))
    }

    /// The values that every row has, and the places of the others empty.
    pub(super) fn basic(&self, time: Estimate, penetration: Estimate, force: Estimate, contact_radius: Estimate) -> Values {
        let mut values: Values = vec![None; COLUMNS.len()];
        let cells = [
            (at::TIME, Some(time)),
            (at::PENETRATION, Some(penetration)),
            (at::FORCE, Some(force)),
            (at::CONTACT_RADIUS, Some(contact_radius)),
            (at::FRAME, self.far_end(penetration, force)),
            (at::MEASURED_FORCE, self.timeline.measured_force(time.value, &self.scale).map(Estimate::exact)),
        ];
        set(&mut values, cells);
        values
    }

    fn of_event(&self, loose: Option<&Record>, tight: &Record, runs: &Runs) -> Values {
        let whole = runs.tight.rows.last().map_or(0.0, |row| row.time);
        // What only one run has is not known better than the whole.
        let time = loose.map_or(whole, |loose| self.between(loose.time, tight.time, 1.0).error);
        let nothing = Record { penetration: 0.0, force: 0.0, contact_radius: 0.0, ..*tight };
        let loose = loose.unwrap_or(&nothing);
        self.basic(
            Estimate::new(tight.time, time),
            self.depth(loose.penetration, tight.penetration),
            self.between(loose.force, tight.force, self.reduced.scales.force),
            self.between(loose.contact_radius, tight.contact_radius, self.reduced.scales.radius),
        )
    }

    pub(super) fn of_record(&self, loose: &Record, tight: &Record, runs: &Runs) -> Values {
        let mut values = self.of_event(Some(loose), tight, runs);
        let work = self.reduced.scales.work;
        let energy = |of: fn(&Record) -> f64| Some(self.between(of(loose), of(tight), work));
        let scale = runs.tight.certificate.energy_scale.max(f64::MIN_POSITIVE);
        let cells = [
            (at::TIME, Some(Estimate::exact(tight.time))),
            (at::STORED_ENERGY, energy(|row| row.energies.instant + row.energies.delayed)),
            (at::INTERFACE_ENERGY, energy(|row| row.energies.interface)),
            (at::EXTERNAL_WORK, energy(|row| row.work)),
            (at::DISSIPATED_ENERGY, energy(|row| row.dissipated)),
            (at::RELEASED_ENERGY, energy(|row| row.released)),
            (at::RESIDUAL, Some(Estimate::exact((tight.residual / scale).abs()))),
        ];
        set(&mut values, cells);
        values
    }

    /// A state that is found on the way, with its energies where both runs have it.
    fn of_found(&self, loose: Option<&Record>, tight: &Record, runs: &Runs) -> Values {
        let event = self.of_event(loose, tight, runs);
        let Some(loose) = loose else { return event };
        let mut values = self.of_record(loose, tight, runs);
        set(&mut values, [(at::TIME, event.get(at::TIME).copied().flatten()), (at::RESIDUAL, None)]);
        values
    }

    /// A jump: where it lands is sharp, the force before it is soft.
    fn of_jump(&self, loose: Option<&Jump>, tight: &Jump, runs: &Runs) -> Values {
        let record = |jump: &Jump| {
            let blank = runs.tight.rows.first().copied();
            blank.map(|row| Record {
                time: jump.time,
                penetration: jump.penetration_after,
                force: jump.force_after,
                contact_radius: jump.radius_after,
                ..row
            })
        };
        let loose = loose.and_then(record);
        record(tight).map_or_else(|| vec![None; COLUMNS.len()], |tight| self.of_event(loose.as_ref(), &tight, runs))
    }

    /// (3/2)πRΔγ, coherent, of a sphere.
    fn jkr_pull_off(&self) -> Option<f64> {
        self.is_sphere().then_some(1.5 * PI * self.reduced.scales.force)
    }

    /// The segment with the largest tension, of both runs.
    fn pulling(&self, runs: &Runs) -> Option<(LegSummary, LegSummary)> {
        let legs = runs.loose.legs.iter().zip(&runs.tight.legs);
        let least = legs.min_by(|a, b| a.1.largest_tension.force.total_cmp(&b.1.largest_tension.force));
        least.filter(|(_, tight)| tight.largest_tension.force < 0.0).map(|(loose, tight)| (*loose, *tight))
    }

    fn of_largest_tension(&self, runs: &Runs, floors: &Floors) -> Option<Values> {
        let (loose, tight) = self.pulling(runs)?;
        let mut values = self.of_found(Some(&loose.largest_tension), &tight.largest_tension, runs);
        floors.raise(&mut values);
        let force = values.get(at::FORCE).copied().flatten()?;
        self.soften(&mut values, &tight.largest_tension, &runs.tight, force.error / self.reduced.scales.force);
        let ratio = self.jkr_pull_off().map(|unit| Estimate::new(-force.value, force.error).scaled(1.0 / unit));
        set(&mut values, [(at::PULL_OFF_RATIO, ratio)]);
        Some(values)
    }

    /// The values where a contact ends.
    fn of_loss(&self, loose: Option<&Record>, tight: &Record, runs: &Runs) -> Values {
        let mut values = self.of_found(loose, tight, runs);
        for place in [at::TIME, at::PENETRATION] {
            let soft = values.get(place).copied().flatten().map(|event| Estimate::new(event.value, SOFT * event.error));
            set(&mut values, [(place, soft)]);
        }
        values
    }

    /// Widens the bounds of where the tension is largest to all places at which it is the same within the error of the force: two runs may agree
    /// about the place of a flat maximum by chance.
    fn soften(&self, values: &mut Values, peak: &Record, run: &Run, force_error: f64) {
        let after = run.rows.partition_point(|row| row.time <= peak.time * (1.0 + ROUNDING));
        let before = run.rows.partition_point(|row| row.time < peak.time * (1.0 - ROUNDING));
        let beside = [before.checked_sub(1).and_then(|place| run.rows.get(place)), run.rows.get(after)];
        let units = self.reduced.scales;
        for row in beside.into_iter().flatten().filter(|row| row.force > peak.force) {
            // The force rises with the square of the way from its extreme.
            let part = (force_error / (row.force - peak.force)).sqrt().min(1.0);
            for (place, way) in [
                (at::TIME, row.time - peak.time),
                (at::PENETRATION, (row.penetration - peak.penetration) * units.gap),
                (at::CONTACT_RADIUS, (row.contact_radius - peak.contact_radius) * units.radius),
            ] {
                let known = values.get(place).copied().flatten();
                set(values, [(place, known.map(|known| Estimate::new(known.value, known.error.max(part * way.abs()))))]);
            }
        }
    }

    /// The values of the state as a whole, coherent.
    fn of_state(&self, runs: &Runs, floors: &Floors, end: Option<&Values>) -> Values {
        let mut values: Values = vec![None; COLUMNS.len()];
        let tension = self.of_largest_tension(runs, floors);
        let pull = |place: usize| tension.as_ref().and_then(|row| row.get(place).copied().flatten());
        let mut lost = runs.tight.losses.last().map(|tight| self.of_loss(runs.loose.losses.last(), tight, runs));
        if let Some(values) = &mut lost {
            floors.raise(values);
        }
        let loss = |place: usize| lost.as_ref().and_then(|row| row.get(place).copied().flatten());
        let protocol = self.protocol(runs);
        let pulled = self.pulling(runs).map_or(f64::INFINITY, |(_, tight)| tight.largest_tension.time);
        let dwell = protocol.dwell(pulled);
        let retraction = loss(at::TIME).and_then(|lost| protocol.retraction(lost.value));
        let last = |place: usize| end.and_then(|row| row.get(place).copied().flatten());
        let units = self.reduced.scales;
        let wider = |estimate: Estimate, place: usize| Estimate::new(estimate.value, estimate.error.max(floors.at(place)));
        let work = |of: fn(&LegSummary) -> f64| {
            self.pulling(runs).map(|(loose, tight)| wider(self.between(of(&loose), of(&tight), units.work), at::EXTERNAL_WORK))
        };
        // It ends where the tension is largest, which is known as well as its depth.
        let at_the_end = pull(at::FORCE).zip(pull(at::PENETRATION)).map_or(0.0, |(force, depth)| force.value.abs() * depth.error);
        let to_pull_off = work(LegSummary::work_to_pull_off).map(|work| Estimate::new(work.value, work.error + at_the_end));
        let largest = |of: fn(&Record) -> f64, unit: f64, place: usize| {
            let [loose, tight] = [&runs.loose, &runs.tight].map(|run| run.rows.iter().map(of).fold(0.0, f64::max));
            // Between two steps it may be larger, by less than what it falls to both sides.
            let open = runs.tight.rows.windows(3).map(|rows| match rows {
                [a, b, c] if of(b) >= tight => (of(b) - of(a)).max(of(b) - of(c)).max(0.0),
                _ => 0.0,
            });
            let estimate = self.between(loose, tight, unit);
            Some(wider(Estimate::new(estimate.value, estimate.error + unit * open.fold(0.0, f64::max)), place))
                .filter(|largest| largest.value > 0.0)
        };
        let count = |number: usize| Some(Estimate::exact(number as f64));
        let certificate = &runs.tight.certificate;
        let released = [&runs.loose, &runs.tight].map(|run| run.jumps.iter().map(|jump| jump.released).sum::<f64>());
        let glassy = self.tabor_numbers()[1];
        let cells = [
            (at::PULL_OFF_FORCE, pull(at::FORCE).map(|force| Estimate::new(-force.value, force.error))),
            (at::PULL_OFF_TIME, pull(at::TIME)),
            (at::PULL_OFF_PENETRATION, pull(at::PENETRATION)),
            (at::PULL_OFF_RADIUS, pull(at::CONTACT_RADIUS)),
            (at::PULL_OFF_RATIO, pull(at::PULL_OFF_RATIO)),
            (at::WORK_OF_SEPARATION, work(LegSummary::work_of_separation)),
            (at::WORK_TO_PULL_OFF, to_pull_off),
            (at::DWELL_RADIUS, dwell.and_then(|place| self.radius_between_legs(runs, place))),
            (at::TIME_TO_DETACH, loss(at::TIME).zip(retraction).map(|(lost, begin)| Estimate::new(lost.value - begin, lost.error))),
            (at::DETACHMENT_TIME, loss(at::TIME)),
            (at::DETACHMENT_PENETRATION, loss(at::PENETRATION)),
            (at::LARGEST_RADIUS, largest(|row| row.contact_radius, units.radius, at::CONTACT_RADIUS)),
            (at::LARGEST_COMPRESSION, largest(|row| row.force, units.force, at::FORCE)),
            (at::END_PENETRATION, last(at::PENETRATION)),
            (at::END_FORCE, last(at::FORCE)),
            (at::END_RADIUS, last(at::CONTACT_RADIUS)),
            (at::JUMPS, count(runs.tight.jumps.len())),
            (at::JUMP_LOSS, Some(self.between(released[0], released[1], units.work))),
            (at::TABOR, Some(Estimate::relative(units.tabor, ROUNDING))),
            (at::GLASSY_TABOR, Some(Estimate::relative(glassy, ROUNDING))),
            (at::ENERGY_DEFECT, Some(Estimate::exact(certificate.energy_residual / certificate.energy_scale.max(f64::MIN_POSITIVE)))),
            (at::STEPS, count(certificate.steps)),
            (at::NODES, count(certificate.nodes)),
        ];
        set(&mut values, cells);
        values
    }

    /// Puts coherent values into a row in the units of the scene; flags a row whose bounds are too wide.
    fn fill(&self, row: &mut Row, values: Values, scales: &[f64], runs: &Runs) {
        let event = row.label(0) == "event";
        // Repetitions are stated, and so is what is left between cycles.
        let stated = row.label(0) == REPETITION;
        // Of events only the largest tension is held to the accuracy: when and where it acts, and where a fold is, is soft.
        let present = present(&self.indentation);
        let held = |place: usize| {
            present.contains(&place)
                && !stated
                && !matches!(place, at::DRIFT | at::SPREAD)
                && (!event || (row.label(1) == LARGEST_TENSION && matches!(place, at::FORCE | at::PULL_OFF_RATIO)))
        };
        let shortfall = COLUMNS.iter().zip(&values).zip(scales).enumerate().find_map(|(place, ((definition, value), scale))| {
            let estimate = (*value)?;
            let size = estimate.value.abs().max(*scale);
            (held(place) && estimate.error > self.accuracy * size).then(|| (definition.name, estimate.error / size))
        });
        if let Some((name, error)) = shortfall {
            row.status = Status::Inaccurate;
            row.reason = Some(format!("the error bound of {name} is {error:.1e}, above the wanted accuracy {:.1e}", self.accuracy));
        }
        self.put(row, values, runs);
        row.assumptions = self.assumptions(row);
    }

    /// The values of a row in the units of the scene, and its certificate.
    fn put(&self, row: &mut Row, values: Values, runs: &Runs) {
        let shown = |place: usize| Some(self.in_units(values.get(place).copied().flatten()?, COLUMNS.get(place)?.measure));
        row.values = present(&self.indentation).into_iter().map(shown).collect();
        let certificate = &runs.tight.certificate;
        let scale = certificate.energy_scale.max(f64::MIN_POSITIVE);
        // A body that gives more than it took, or a jump up the energy, cannot exist.
        let least = runs.tight.rows.iter().fold(0.0_f64, |least, row| least.min(row.dissipated).min(row.released)) / scale;
        let admissible = least >= -ADMISSIBLE.max(self.accuracy);
        row.certificate = Some(Certificate { residual: certificate.energy_residual / scale, condition: 1.0, admissible });
        row.witness = (!admissible).then(|| Witness { name: "smallest dissipated energy over the largest energy".into(), value: least });
        row.work = Work::default();
    }

    /// A coherent value in the units of the scene.
    fn in_units(&self, estimate: Estimate, measure: Measure) -> Estimate {
        let converted = match measure {
            Measure::Force | Measure::Energy | Measure::Power | Measure::EnergyPerArea | Measure::Stiffness => {
                estimate.scaled(1.0 / self.scale.force)
            }
            Measure::Time | Measure::Length | Measure::Intensity | Measure::Frequency | Measure::Angle | Measure::Number => estimate,
        };
        // An open contact has the force 0, not −0.
        Estimate::new(converted.value + 0.0, converted.error)
    }
}

/// Puts values into their places.
pub(super) fn set<const N: usize>(values: &mut Values, cells: [(usize, Option<Estimate>); N]) {
    for (place, value) in cells {
        if let Some(cell) = values.get_mut(place) {
            *cell = value;
        }
    }
}
