//! Work against precision: every solver and its rivals on the same problem, in one run, on one thread.
//!
//! | file | problem | rivals |
//! |---|---|---|
//! | `sliding` | an equilibrium of a sliding wave, one and twelve terms | collocation as printed, aligned, extrapolated |
//! | `strength` | pull-off of a sliding wave | loads lowered, with our contacts and with the thesis's |
//! | `sphere` | a retraction | dense annuli, as printed and with factors kept |
//! | `steady_crack` | G(v) of twelve terms | the raw double integral |
//! | `growth` | delayed growth | stepping as printed |
//! | `lines` | a line and a rough surface that attract at a distance | contMech, stored |
//! | `peers` | what only other programs have run | theirs, stored |
//!
//! Truths come from elsewhere: stored reference values of other programs, or closed forms. Times are medians; they are stated, never failed on.

mod domination;
pub(super) mod growth;
pub(super) mod lines;
pub(super) mod peers;
pub(super) mod sliding;
pub(super) mod sphere;
pub(super) mod steady_crack;
pub(super) mod strength;

pub use domination::{Contest, contest};

use super::counters::{self, Counter};
use super::section::{Cell, Check, Column, Plot, Section, Table, failures, ours, rival, stored};
use super::stored::stored_runs;
use viscotack_program::outcome::plot::{Axis, Curve, Figure};

/// Where failures and lost digits are drawn: an error of one.
const FAILED_AT: f64 = 1.0;
/// Errors below this are drawn here.
const LEAST_DRAWN: f64 = 1e-17;

/// One run of a method.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// What sets its accuracy, as `1e-6` or `N = 100`.
    pub setting: String,
    /// Median time (s).
    pub seconds: f64,
    /// Number of runs behind the median.
    pub runs: usize,
    /// What it took, the first one drawn.
    pub counted: Vec<(&'static str, f64)>,
    /// Its error, or why there is none.
    pub error: Result<f64, String>,
}

/// A method at several accuracies.
#[derive(Debug, Clone, PartialEq)]
pub struct Method {
    /// Its name in the legend.
    pub name: String,
    /// Whether it is this program.
    pub own: bool,
    /// Its runs, from coarse to fine.
    pub samples: Vec<Sample>,
}

/// A problem with all methods on it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Diagram {
    pub(super) identifier: String,
    /// What is solved, and against which truth.
    pub(super) caption: String,
    /// What the error is of.
    pub(super) error: &'static str,
    /// What is counted.
    pub(super) counted: &'static str,
    pub(super) methods: Vec<Method>,
    pub(super) headline: bool,
}

impl Diagram {
    /// Adds both plots, the table, the contest and the counters to a section.
    pub(super) fn into_section(self, section: &mut Section) {
        let problem = self.identifier.clone();
        self.of_problem(&problem, section);
    }

    /// The same, with the stored runs of a problem by another name.
    fn of_problem(self, problem: &str, section: &mut Section) {
        let time = self.figure("time of one solution (s)", |sample| sample.seconds);
        let work = self.figure(self.counted, |sample| sample.counted.first().map_or(f64::NAN, |counted| counted.1));
        let peers: Vec<_> = stored_runs().into_iter().filter(|run| run.problem == problem).collect();
        let time = with_stored(time, &peers);
        let plot = Plot::new(format!("{}_time", self.identifier), format!("{} Error against time.", self.caption), time);
        section.plots.push(if self.headline { plot.headline() } else { plot });
        let counters = self.counters();
        if !counters.is_empty() {
            section.plots.push(Plot::new(format!("{}_work", self.identifier), format!("The same: error against {}.", self.counted), work));
        }
        let columns = [
            Column::words("method"),
            Column::words("setting"),
            Column::new("median time", "s"),
            Column::new("runs", "1"),
            Column::words("work"),
        ];
        let columns = columns.into_iter().chain([Column::new("error", "1"), Column::words("failure or stamp")]).collect();
        let mut table = Table::new(self.identifier.clone(), format!("Every run of {}.", self.identifier), columns).folded();
        for method in &self.methods {
            table.rows.extend(method.samples.iter().map(|sample| row(&method.name, sample)));
        }
        for run in &peers {
            let number = |value: Option<f64>| Cell::Number(value);
            table.rows.push(vec![
                Cell::Word(format!("{} (stored)", run.method)),
                Cell::Word(run.setting.clone()),
                number(Some(run.seconds)),
                number(None),
                Cell::Word(String::new()),
                number(run.error),
                Cell::Word(run.stamp.join(", ")),
            ]);
        }
        section.tables.push(table);
        section.checks.extend(self.contests());
        if !counters.is_empty() {
            let (table, check) = counters::checked(&counters);
            section.tables.push(Table { identifier: format!("{}_counters", self.identifier), ..table });
            section.checks.push(Check { name: format!("{}: {}", self.identifier, check.name), ..check });
        }
    }

    fn figure(&self, across: &str, of: impl Fn(&Sample) -> f64) -> Figure {
        let mut figure = Figure::new(Axis::logarithmic(across), Axis::logarithmic(self.error));
        for (place, method) in self.methods.iter().enumerate() {
            let point = |sample: &Sample| sample.error.as_ref().ok().map(|error| (of(sample), error.max(LEAST_DRAWN)));
            let points = method.samples.iter().filter_map(point).collect();
            let draw: fn(String, Vec<(f64, f64)>) -> Curve = if method.own { ours } else { rival };
            figure = figure.with_curve(draw(method.name.clone(), points).with_colour(place));
            let failed: Vec<&Sample> = method.samples.iter().filter(|sample| sample.error.is_err()).collect();
            if !failed.is_empty() {
                let name = format!(
                    "no result: {}, {}",
                    method.name,
                    failed.iter().map(|sample| sample.setting.as_str()).collect::<Vec<_>>().join(", ")
                );
                let points = failed.into_iter().map(|sample| (of(sample), FAILED_AT)).collect();
                figure = figure.with_curve(failures(name, points).with_colour(place));
            }
        }
        figure
    }

    /// This program's best method against each rival, by time.
    fn contests(&self) -> Vec<Check> {
        let own: Vec<&Method> = self.methods.iter().filter(|method| method.own).collect();
        self.methods
            .iter()
            .filter(|method| !method.own)
            .map(|other| {
                let found = contest(&own, other);
                Check::statement(
                    format!("{}: dominates {}", self.identifier, other.name),
                    "no run of the rival is as accurate in less time",
                    found.text(),
                    found.dominates(),
                )
            })
            .collect()
    }

    fn counters(&self) -> Vec<Counter> {
        let of = |method: &Method| {
            let run = |sample: &Sample| format!("{} {}", method.name, sample.setting);
            method
                .samples
                .iter()
                .flat_map(|sample| {
                    let counter = |&(counted, count): &(&'static str, f64)| Counter {
                        problem: self.identifier.clone(),
                        run: run(sample),
                        counted,
                        count,
                    };
                    sample.counted.iter().map(counter).collect::<Vec<_>>()
                })
                .collect::<Vec<_>>()
        };
        self.methods.iter().filter(|method| method.own).flat_map(of).collect()
    }
}

fn row(method: &str, sample: &Sample) -> Vec<Cell> {
    let work = sample.counted.iter().map(|(counted, count)| format!("{count} {counted}")).collect::<Vec<_>>().join(", ");
    vec![
        Cell::Word(method.to_owned()),
        Cell::Word(sample.setting.clone()),
        Cell::Number(Some(sample.seconds)),
        Cell::Number(Some(sample.runs as f64)),
        Cell::Word(work),
        Cell::Number(sample.error.as_ref().ok().copied()),
        Cell::Word(sample.error.as_ref().err().cloned().unwrap_or_default()),
    ]
}

/// Stored runs drawn hollow, a curve a method; those without an error as crosses.
fn with_stored(mut figure: Figure, peers: &[super::stored::StoredRun]) -> Figure {
    let mut methods: Vec<&str> = Vec::new();
    for run in peers {
        if !methods.contains(&run.method.as_str()) {
            methods.push(&run.method);
        }
    }
    for method in methods {
        let place = figure.curves.len();
        let own = || peers.iter().filter(|run| run.method == method);
        let points = own().filter_map(|run| run.error.map(|error| (run.seconds, error.max(LEAST_DRAWN)))).collect();
        figure = figure.with_curve(stored(format!("{method} (stored)"), points).with_colour(place));
        let failed: Vec<(f64, f64)> = own().filter(|run| run.error.is_none()).map(|run| (run.seconds, FAILED_AT)).collect();
        if !failed.is_empty() {
            figure = figure.with_curve(failures(format!("no result: {method} (stored)"), failed).with_colour(place));
        }
    }
    figure
}
