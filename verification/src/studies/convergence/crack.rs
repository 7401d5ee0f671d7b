//! Growth of a crack under a constant load: grid lines of a process zone, against the closed form of one term.

use super::{KnownGrowth, Panel};
use crate::rivals::growth_stepping::GrowthStepping;
use crate::studies::order::{Convergence, Expectation, FINEST};
use crate::studies::section::{Check, Effort, Progress, Section};
use viscotack::crack::delayed::trajectory::places_of_one_run;
use viscotack::crack::delayed::{GrowthProblem, LoadHistory, Resolution, trajectory};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;

/// A solid and an interface whose numbers are nothing like one.
pub(in crate::studies) struct Case {
    pub(in crate::studies) material: PlaneMaterial,
    pub(in crate::studies) interface: Interface,
    pub(in crate::studies) zone: f64,
    pub(in crate::studies) intensity: f64,
    pub(in crate::studies) known: KnownGrowth,
    /// When the tip is looked at (s): whole numbers of delays.
    pub(in crate::studies) times: Vec<f64>,
}

const RELAXED: f64 = 1.1e6;
const BETA: f64 = 10.0;
const TIME: f64 = 0.37;
const WORK: f64 = 0.31;
const ZONE: f64 = 2.3e-6;
/// k = K²/(2ΔγE0).
const LOAD: f64 = 3.0;
/// The last output, over the delay: some two and a half zones.
pub(in crate::studies) const LAST: usize = 6;

/// The case of the convergence and of the work-precision study.
pub(in crate::studies) fn case() -> Result<Case, Refusal> {
    let material = PlaneMaterial::standard_solid(RELAXED, BETA * RELAXED, TIME)?;
    let process_zone = ProcessZone::Constant { length: ZONE };
    let interface = Interface { work_of_adhesion: WORK, process_zone, body: CrackBody::AgainstRigid };
    let known = KnownGrowth::new(TIME, BETA, LOAD, 8);
    let times = (2..=LAST).map(|delays| delays as f64 * known.delay()).collect();
    Ok(Case { material, interface, zone: ZONE, intensity: (2.0 * WORK * LOAD * RELAXED).sqrt(), known, times })
}

impl Case {
    pub(in crate::studies) fn problem(&self) -> Result<GrowthProblem<'_>, Refusal> {
        GrowthProblem::new(&self.material, self.interface, self.intensity)
    }

    /// The largest |x₀ − exact|/δ over the times.
    pub(in crate::studies) fn error(&self, places: &[f64]) -> f64 {
        if places.len() != self.times.len() {
            return f64::INFINITY;
        }
        let error = |(time, place): (&f64, &f64)| (place / self.zone - self.known.place(*time)).abs();
        self.times
            .iter()
            .zip(places)
            .map(error)
            .fold(0.0, |worst: f64, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) })
    }

    /// By the scheme of the thesis: places at the times, evaluations of the closure, roots taken.
    pub(in crate::studies) fn stepped(&self, steps_a_delay: usize, points: usize) -> Result<(Vec<f64>, [u64; 2]), Refusal> {
        let scheme = GrowthStepping {
            work_of_adhesion: WORK,
            process_zone: ZONE,
            deformable_halves: 1.0,
            intensity: self.intensity,
            end: LAST as f64 * self.known.delay(),
            steps: LAST * steps_a_delay,
            points,
        };
        let grown = scheme.run(&self.material)?;
        let places = (2..=LAST).filter_map(|delays| grown.places.get(delays * steps_a_delay).copied()).collect();
        Ok((places, [grown.closure_evaluations, grown.kernel_evaluations]))
    }
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("convergence_crack", "Convergence: growth of a crack");
    progress.expect(1);
    section.say(
        "A crack under a constant load in a solid of one retardation time has a closed solution, piece by piece over its process zones. The stepper is run \
         on ever more grid lines of a zone, alone and as the program uses it: the finest of four runs. The thesis's own stepping sums the uncollapsed closure. \
         Steady cracks have neither nodes nor steps: their closure is a sum of closed terms.",
    );
    match computed(effort) {
        Ok((panel, check)) => {
            panel.into_section(&mut section);
            section.checks.push(check);
        }
        Err(refusal) => section.checks.push(Check::new("growth of a crack", "every run ends", refusal.to_string(), false)),
    }
    progress.advance(1);
    section
}

fn computed(effort: Effort) -> Result<(Panel, Check), Refusal> {
    let case = case()?;
    let problem = case.problem()?;
    let history = LoadHistory::constant(case.intensity)?;
    let (mut single, mut of_four, mut outside) = (Vec::new(), Vec::new(), 0);
    for lines in effort.choose(vec![4, 8, 16, 32, 64, 128], vec![4, 8, 16, 32, 64, 128, 256, 512, 1024]) {
        let found = places_of_one_run(&problem, &history, &case.times, lines)?;
        let places: Vec<f64> = found.iter().map(|place| place * case.zone).collect();
        single.push((f64::from(lines), case.error(&places)));
        let found = trajectory(&problem, &history, &case.times, Resolution { lines_per_zone: lines, ..Resolution::default() })?;
        let growth: Vec<_> = found.samples.iter().filter_map(|sample| sample.growth).collect();
        outside += growth
            .iter()
            .zip(&case.times)
            .filter(|(growth, time)| (growth.value - case.zone * case.known.place(**time)).abs() > growth.error + 1e-12 * case.zone)
            .count();
        of_four.push((f64::from(lines), case.error(&growth.iter().map(|growth| growth.value).collect::<Vec<_>>())));
    }
    let mut stepped = Vec::new();
    for steps in effort.choose(vec![4, 8, 16, 32], vec![4, 8, 16, 32, 64, 128]) {
        stepped.push((steps as f64, case.error(&case.stepped(steps, 12 * steps)?.0)));
    }
    let curves = vec![
        (
            Convergence {
                name: "this program".into(),
                points: of_four,
                floor: 1e-13,
                fitted: FINEST,
                expected: Expectation::Order {
                    order: 3.0,
                    least: 2.7,
                    most: 3.4,
                    reason: "the run with 4 times the lines, to which the other three are the error bound",
                },
            },
            true,
        ),
        (
            Convergence {
                name: "one of its runs".into(),
                points: single,
                floor: 1e-13,
                fitted: FINEST,
                expected: Expectation::Order {
                    order: 3.0,
                    least: 2.7,
                    most: 3.4,
                    reason: "the step of time follows from the closure at the end of a line; the motion within it is the parabola with the speed at its start, off by a \
                             third power",
                },
            },
            true,
        ),
        (
            Convergence {
                name: "thesis's stepping".into(),
                points: stepped,
                floor: 1e-13,
                fitted: FINEST,
                expected: Expectation::Order {
                    order: 2.0,
                    least: 1.6,
                    most: 2.4,
                    reason: "trapezoidal rule in time, midpoints of the zone refined with it, the start on a step; the kink of (…)₊ within a step costs a scatter of second order",
                },
            },
            false,
        ),
    ];
    let panel = Panel {
        identifier: "lines",
        caption: "Largest error of the tip's place, over the process zone, against grid lines of a zone (this program) and steps of a delay (the thesis's stepping).",
        fineness: ("lines or steps", "lines of a zone, steps of a delay"),
        error: r"error of $x_0/\delta$",
        curves,
        headline: false,
    };
    let check = Check::new(
        "error bounds of growth hold against the closed form",
        "no place off by more than its bound, at any number of lines",
        format!("{outside} outside"),
        outside == 0,
    );
    Ok((panel, check))
}

/// Equal creep terms a decade apart, as slow as the slowest time; E0 and β with it.
pub(in crate::studies) fn decades(relaxed: f64, beta: f64, slowest: f64, terms: i32) -> Result<PlaneMaterial, Refusal> {
    let compliance = (1.0 - 1.0 / beta) / relaxed / f64::from(terms);
    let terms: Vec<CreepTerm> = (0..terms).map(|index| CreepTerm { compliance, retardation_time: slowest * 10f64.powi(-index) }).collect();
    PlaneMaterial::from_creep(relaxed * beta, &terms, None)
}
