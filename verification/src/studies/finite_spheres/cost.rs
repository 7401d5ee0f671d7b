//! What accuracy costs on five states, in one run on one core, beside a prototype of the same method.

use crate::studies::cells::{number, word};
use crate::studies::timing::timed;
use crate::studies::{Check, Column, Effort, Plot, Progress, Section, Table, ours, stored_curve};
use viscotack::finite_range::law::Law;
use viscotack::finite_range::sphere::{Accuracy, Control, Creep, Leg, Mesher, Motion, Problem, Start, run};
use viscotack_program::outcome::plot::{Axis, Figure};

/// Tolerances; the truth is the pull-off of the last run, tighter than all of them.
const TOLERANCES: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
const TRUTH: [f64; 2] = [1e-7, 1e-8];
/// The prototype is to be three times slower.
const FASTER: f64 = 3.0;

/// A state, with the seconds and errors of the prototype (numpy on one shared core) at the tolerances above.
struct State {
    name: &'static str,
    tabor: f64,
    stiffening: f64,
    three: bool,
    depth: f64,
    to: f64,
    rate: f64,
    /// Approach from here and a rest of one time before.
    from: Option<f64>,
    prototype: [(f64, f64); 4],
}

const STATES: [State; 5] = [
    State {
        name: "slow",
        tabor: 3.24,
        stiffening: 10.0,
        three: false,
        depth: 40.0,
        to: -24.0,
        rate: 10.0,
        from: None,
        prototype: [(1e-3, 0.30), (1e-4, 0.28), (1e-5, 0.30), (2e-6, 0.42)],
    },
    State {
        name: "three terms",
        tabor: 2.6,
        stiffening: 14.0,
        three: true,
        depth: 20.0,
        to: -20.0,
        rate: 4.0,
        from: None,
        prototype: [(1e-3, 0.25), (5e-5, 0.22), (5e-6, 0.30), (2e-6, 0.47)],
    },
    State {
        name: "cycle",
        tabor: 1.25,
        stiffening: 25.0,
        three: true,
        depth: 8.0,
        to: -14.0,
        rate: 8.0,
        from: Some(-6.0),
        prototype: [(1e-3, 0.13), (5e-5, 0.14), (1e-6, 0.19), (3e-7, 0.28)],
    },
    State {
        name: "low Tabor number",
        tabor: 0.35,
        stiffening: 80.0,
        three: false,
        depth: 6.0,
        to: -10.0,
        rate: 10.0,
        from: None,
        prototype: [(5e-8, 0.03), (7e-8, 0.03), (2e-8, 0.04), (6e-9, 0.06)],
    },
    State {
        name: "frozen",
        tabor: 2.9,
        stiffening: 12.0,
        three: false,
        depth: 6.0,
        to: -16.0,
        rate: 4000.0,
        from: None,
        prototype: [(2e-6, 0.16), (5e-7, 0.19), (3e-7, 0.22), (1e-8, 0.28)],
    },
];

impl State {
    fn problem(&self) -> Problem {
        let (fractions, times) = if self.three { (vec![0.4, 0.4, 0.2], vec![0.02, 0.5, 8.0]) } else { (vec![1.0], vec![1.0]) };
        let leg = |motion| Leg { control: Control::Penetration, motion };
        let ramp = |from: f64, to: f64| leg(Motion::Ramp { to, duration: (from - to).abs() / self.rate });
        let mut history = vec![ramp(self.depth, self.to)];
        if let Some(from) = self.from {
            history.splice(0..0, [ramp(from, self.depth), leg(Motion::Hold(1.0))]);
        }
        let creep = Creep { stiffening: self.stiffening, fractions, times };
        let start = self.from.map_or(Start::Relaxed(self.depth), Start::Unstrained);
        Problem::new(Law::LennardJones, self.tabor, creep, start, history)
    }
}

/// The study.
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_finite_spheres", "Attraction at a distance: error against time");
    section.paragraphs.push(
        "Five states of a recipe whose prototype in numpy printed its CPU seconds; where the recipe leaves a depth or a term open, it is ours. One run for each tolerance, all meshes new; the error is that of the \
         pull-off against a far tighter run."
            .into(),
    );
    let columns = vec![
        Column::words("state"),
        Column::new("tolerance", "1"),
        Column::new("error", "1"),
        Column::new("seconds", "s"),
        Column::new("prototype's error", "1"),
        Column::new("prototype's seconds", "s"),
        Column::new("steps", "1"),
        Column::new("nodes", "1"),
    ];
    let mut table = Table::new("cost", "Error of the pull-off force and time of one run.", columns);
    let mut figure = Figure::new(Axis::logarithmic("time of one run (s)"), Axis::logarithmic("relative error of the pull-off"));
    // The quick ones.
    let chosen: &[usize] = effort.choose(&[3, 4], &[0, 1, 2, 3, 4]);
    let count = effort.choose(3, TOLERANCES.len());
    progress.expect(chosen.len() as u64);
    for (index, state) in STATES.iter().enumerate().filter(|(index, _)| chosen.contains(index)) {
        let problem = state.problem();
        let solve = |tolerance: f64| {
            let accuracy = Accuracy::new(tolerance);
            run(&problem, accuracy, &mut Mesher::new(accuracy.order)).ok()
        };
        let truth = solve(effort.choose(TRUTH[0], TRUTH[1])).map_or(f64::NAN, |run| run.pull_off_force());
        let mut points = Vec::new();
        let mut fastest = f64::INFINITY;
        for (tolerance, (error, seconds)) in TOLERANCES.into_iter().zip(state.prototype).take(count) {
            let timed = timed(|| solve(tolerance).map(|run| (run.pull_off_force(), run.certificate.steps, run.certificate.nodes)));
            let (force, steps, nodes) = timed.result.unwrap_or((f64::NAN, 0, 0));
            let off = (force / truth - 1.0).abs();
            points.push((timed.seconds, off.max(1e-12)));
            // At equal error: the fastest of ours that is as good as the prototype's 1e-5 run.
            if off <= state.prototype[2].0 {
                fastest = fastest.min(timed.seconds);
            }
            table.rows.push(vec![
                word(state.name),
                number(tolerance),
                number(off),
                number(timed.seconds),
                number(error),
                number(seconds),
                number(steps as f64),
                number(nodes as f64),
            ]);
        }
        let aim = state.prototype[2].1 / FASTER;
        section.checks.push(Check::statement(
            format!("{}: at the error of the prototype's run at 1e-5", state.name),
            format!("at most {aim:.3} s, a third of the prototype's {} s", state.prototype[2].1),
            format!("{fastest:.3} s"),
            fastest <= aim,
        ));
        section.checks.push(Check::new(
            format!("{}: the tolerance is met", state.name),
            "the error at 1e-5 is at most 1e-4",
            format!("{:.1e}", points.get(2).map_or(f64::NAN, |point| point.1)),
            points.get(2).is_some_and(|point| point.1 < 1e-4),
        ));
        figure = figure.with_curve(ours(state.name, points).with_colour(index));
        let theirs = state.prototype.iter().map(|(error, seconds)| (*seconds, *error)).collect();
        figure = figure.with_curve(stored_curve("", theirs).with_colour(index));
        progress.advance(1);
    }
    section.tables.push(table);
    section.plots.push(Plot::new("cost", "Error of the pull-off against time: ours filled, the prototype hollow.", figure));
    section
}
