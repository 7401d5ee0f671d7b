//! The fit itself, and how far the solver's own error moves it.

use super::inspect;
use super::setup::Setup;
use super::solved::Solved;
use std::ops::Range;
use std::time::Instant;
use viscotack::fit::{Fineness, Fitted, Group, Loss, Noise, Problem, akaike, fit};
use viscotack::refusal::Refusal;

/// The loosest and the tightest tolerance of a way; nearly all values err by less than a hundredth of it.
const LOOSEST: f64 = 1e-2;
const TIGHTEST: f64 = 1e-6;
/// Values of states are cheap: they are known to this accuracy, or better.
const OF_STATES: f64 = 1e-5;
/// Error of the model beside what the noise leaves of a parameter, aimed at.
const SHARE: f64 = 0.25;
/// What a value errs by, over the tolerance.
const ERROR: f64 = 0.01;

/// A group of data: a column of a test, or the place of a jump.
#[derive(Debug, Clone)]
pub(super) struct GroupOf {
    pub(super) test: usize,
    /// The column; none of a place.
    pub(super) column: Option<usize>,
    pub(super) places: Range<usize>,
}

/// A fit that has been made.
#[derive(Debug, Clone)]
pub struct Fit {
    pub(super) setup: Setup,
    pub(super) fitted: Fitted,
    pub(super) groups: Vec<GroupOf>,
    /// Tolerance of the model, and by how much a ten times tighter one moves a parameter, over its standard error, at most.
    pub(super) tolerance: f64,
    pub(super) moved: Option<f64>,
    /// Akaike's criterion.
    pub(super) akaike: f64,
    /// What the data show, and whether the result is of no use.
    pub(super) findings: Vec<(String, bool)>,
    pub(super) seconds: f64,
}

/// Makes a fit.
///
/// # Errors
/// Those of [`fit`].
pub fn carry_out(setup: Setup) -> Result<Fit, Refusal> {
    let clock = Instant::now();
    let (groups, of) = groups(&setup);
    let data: Option<Vec<f64>> =
        setup.tests.iter().map(super::compare::Comparison::data).collect::<Option<Vec<_>>>().map(|parts| parts.concat());
    let data = data.ok_or_else(|| Refusal::Undefined { quantity: "a fit", reason: "a datum has no logarithm".into() })?;
    let tolerance = tolerance(&setup);
    let coarse = if setup.across { tolerance } else { LOOSEST };
    let solved = Solved::default();
    let model = |values: &[f64], fineness: Fineness| {
        let tolerance = if fineness == Fineness::Coarse { coarse } else { tolerance };
        solved.or_else(values, tolerance, || setup.model(values, tolerance))
    };
    let loss = if setup.task.huber { Loss::Huber } else { Loss::Squares };
    let problem = Problem { parameters: setup.parameters.clone(), data, groups, model: &model, loss, starts: setup.task.starts };
    let mut fitted = fit(&problem)?;
    fitted.evaluations = solved.count();
    let moved = setup.model(&fitted.values, 0.1 * tolerance).ok().and_then(|finer| moved(&problem, &fitted, &finer));
    let sums: Vec<(usize, f64)> = of
        .iter()
        .zip(&fitted.quality)
        .filter(|(group, _)| group.column.is_some())
        .map(|(group, quality)| (group.places.len(), quality.root_mean_square.powi(2) * group.places.len() as f64))
        .collect();
    let akaike = akaike(&sums, setup.parameters.len());
    let seconds = clock.elapsed().as_secs_f64();
    let mut made = Fit { setup, fitted, groups: of, tolerance, moved, akaike, findings: Vec::new(), seconds };
    made.findings = inspect::after(&made);
    Ok(made)
}

impl Fit {
    /// Whether the result may be used as it stands.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.findings.iter().all(|finding| !finding.1)
    }

    /// χ² at other parameters, with the noise that the fit found.
    ///
    /// # Errors
    /// The reason why the model has no numbers there.
    pub fn misfit_at(&self, values: &[f64]) -> Result<f64, String> {
        let model = self.setup.model(values, self.tolerance)?;
        let data: Vec<f64> = self.setup.tests.iter().filter_map(super::compare::Comparison::data).flatten().collect();
        let loss = if self.setup.task.huber { Loss::Huber } else { Loss::Squares };
        let of = |(group, sigma): (&GroupOf, &f64)| -> f64 {
            let pairs = model.iter().zip(&data).skip(group.places.start).take(group.places.len());
            pairs.map(|(model, datum)| loss.root((model - datum) / sigma).powi(2)).sum()
        };
        Ok(self.groups.iter().zip(&self.fitted.sigmas).map(of).sum())
    }

    /// How long the fit took (s).
    #[must_use]
    pub const fn seconds(&self) -> f64 {
        self.seconds
    }

    /// What was found, as numbers.
    #[must_use]
    pub const fn fitted(&self) -> &Fitted {
        &self.fitted
    }
}

fn groups(setup: &Setup) -> (Vec<Group>, Vec<GroupOf>) {
    let (mut groups, mut of, mut next) = (Vec::new(), Vec::new(), 0);
    for (number, test) in setup.tests.iter().enumerate() {
        for (column, compared) in test.columns.iter().enumerate() {
            let places = next..next + test.rows.len();
            next = places.end;
            groups.push(Group { name: compared.word.clone(), places: places.clone(), noise: Noise::Guess(compared.noise) });
            of.push(GroupOf { test: number, column: Some(column), places });
        }
        for (_, sigma) in test.jumps() {
            let places = next..next + 1;
            next += 1;
            groups.push(Group { name: test.against.clone(), places: places.clone(), noise: Noise::Known(sigma) });
            of.push(GroupOf { test: number, column: None, places });
        }
    }
    (groups, of)
}

/// The tolerance that the noise needs: the error of a value is a quarter of what the noise of all rows leaves of their mean.
fn tolerance(setup: &Setup) -> f64 {
    if setup.across {
        return OF_STATES;
    }
    let mut relative = f64::INFINITY;
    for test in &setup.tests {
        for column in &test.columns {
            let largest = column.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            relative = relative.min(column.noise / largest / (test.rows.len() as f64).sqrt());
        }
    }
    (SHARE / ERROR * relative).clamp(TIGHTEST, LOOSEST)
}

/// The largest step of a parameter that another model gives, to first order, over its standard error.
fn moved(problem: &Problem<'_>, fitted: &Fitted, finer: &[f64]) -> Option<f64> {
    let mut sigmas = vec![1.0; problem.data.len()];
    for (group, sigma) in problem.groups.iter().zip(&fitted.sigmas) {
        sigmas.get_mut(group.places.clone())?.fill(*sigma);
    }
    let right: Vec<f64> = fitted.model.iter().zip(finer).zip(&sigmas).map(|((one, other), sigma)| (one - other) / sigma).collect();
    let step = viscotack::fit::linear_step(&fitted.jacobian, &right)?;
    let ratios = step.iter().zip(&fitted.standard_errors).filter(|(_, error)| error.is_finite() && **error > 0.0);
    Some(ratios.map(|(step, error)| (step / error).abs()).fold(0.0, f64::max))
}
