//! The whole fit: starts, descents, standard deviations, intervals.

use super::at::{At, FIRST_STEP, Weighted};
use super::covariance::Covariance;
use super::descent::descended;
use super::fitted::{Fitted, OtherMinimum};
use super::intervals::{End, Interval};
use super::least_squares::product;
use super::problem::{Fineness, Model, Noise, Problem};
use super::profile::{Minimum, Walk};
use super::quality::Quality;
use super::student::two_sided;
use crate::refusal::Refusal;
use crate::special::split_mix::SplitMix;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Steps of a descent, at most.
const MOST_STEPS: usize = 60;
/// Points of a Latin hypercube that are tried for each parameter before descents begin, and the seed of it.
const TRIED: usize = 8;
const SEED: u64 = 0xf17;
/// Rounds in which standard deviations are estimated anew.
const ROUNDS: usize = 4;
/// Relative change of a standard deviation that is none.
const SETTLED: f64 = 0.01;
/// Differences of the last Jacobian, in standard errors, and their largest step.
const OF_ERRORS: f64 = 4.0;
const WIDEST: f64 = 0.05;
/// Rise of χ² within which descents end in the same minimum, or in one that the data cannot tell from it.
const SAME: f64 = 1.0;
/// Times a profile may find a better minimum.
const MOST_RETURNS: usize = 4;
/// Probability inside an interval.
const INSIDE: f64 = 0.95;

/// Fits a model to data.
///
/// # Errors
/// [`Refusal::Undefined`] with too few data, or if the model gives numbers at no start; [`Refusal::NotConverged`] if the minimum is left again and again.
pub fn fit(problem: &Problem<'_>) -> Result<Fitted, Refusal> {
    let refused = |reason: String| Refusal::Undefined { quantity: "a fit", reason };
    let count = problem.parameters.len();
    if count == 0 || problem.data.len() <= count + problem.groups.len() {
        return Err(refused(format!("{} data cannot fix {count} parameters and their noise", problem.data.len())));
    }
    let evaluations = AtomicUsize::new(0);
    let counted = |values: &[f64], fineness: Fineness| {
        evaluations.fetch_add(1, Ordering::Relaxed);
        (problem.model)(values, fineness)
    };
    let counting: Model<'_> = &counted;
    let problem = Problem { model: counting, ..problem.clone() };
    let coarse = Weighted::new(&problem, Fineness::Coarse);
    let starts = starts(&coarse).map_err(refused)?;
    let descend = |start: &Vec<f64>| {
        let end = descended(At::new(&coarse, start.clone()), MOST_STEPS);
        (end.misfit(), end.coordinates)
    };
    let mut ends: Vec<(f64, Vec<f64>)> = starts.par_iter().map(descend).collect();
    ends.sort_by(|one, other| one.0.total_cmp(&other.0));
    let Some((lowest, first)) = ends.first().cloned() else { return Err(refused("there is no start".to_owned())) };
    let same = ends.iter().filter(|end| end.0 - lowest <= SAME.max(0.02 * lowest)).count();
    let others: Vec<OtherMinimum> = ends
        .iter()
        .skip(same)
        .map(|(misfit, coordinates)| OtherMinimum { values: problem.values(coordinates), rise: misfit - lowest })
        .collect();
    let mut fine = Weighted { fineness: Fineness::Fine, ..coarse.clone() };
    let mut coordinates = first;
    for _ in 0..MOST_RETURNS {
        coordinates = settled(&mut fine, coordinates)?;
        let found = Ending::new(&fine, &coordinates)?;
        match found.intervals() {
            Ok(profiles) => {
                let mut fitted = found.fitted(profiles);
                fitted.others = others;
                fitted.reached_by = (same, ends.len());
                fitted.evaluations = evaluations.load(Ordering::Relaxed);
                return Ok(fitted);
            }
            Err(better) => {
                coordinates = better;
                // Short differences see every scatter of the model: the next descent takes those of the profiles.
                fine.steps.clone_from(&found.weighted.steps);
            }
        }
    }
    Err(Refusal::NotConverged {
        what: "a fit",
        detail: "each profile finds a better minimum: the model scatters more than the data allow".into(),
    })
}

/// The places from which descents begin: the given one, the middle, and the best points of a Latin hypercube.
fn starts(weighted: &Weighted<'_>) -> Result<Vec<Vec<f64>>, String> {
    let parameters = &weighted.problem.parameters;
    let middle: Vec<f64> = parameters.iter().map(|parameter| parameter.part(0.5)).collect();
    let within = |value: &f64| parameters.iter().all(|_| value.is_finite());
    let given: Option<Vec<f64>> = parameters
        .iter()
        .map(|parameter| parameter.first.filter(within).map(|first| parameter.coordinate(first.clamp(parameter.lower, parameter.upper))))
        .collect();
    let mut tried = vec![given.unwrap_or_else(|| middle.clone()), middle];
    let points = TRIED * parameters.len() + 4;
    let columns: Vec<Vec<usize>> = (0..parameters.len()).map(|number| shuffled(points, number as u64)).collect();
    tried.extend((0..points).map(|point| {
        let part = |column: &Vec<usize>| (column.get(point).copied().unwrap_or(0) as f64 + 0.5) / points as f64;
        parameters.iter().zip(&columns).map(|(parameter, column)| parameter.part(part(column))).collect()
    }));
    let mut scored: Vec<(f64, Vec<f64>)> = tried.into_par_iter().map(|start| (weighted.misfit(&start), start)).collect();
    let given = scored.first().cloned();
    scored.sort_by(|one, other| one.0.total_cmp(&other.0));
    scored.retain(|start| start.0.is_finite());
    let Some((_, best)) = scored.first() else {
        return Err(match weighted.differences(&weighted.problem.parameters.iter().map(|one| one.part(0.5)).collect::<Vec<_>>()) {
            Err(reason) => {
                format!("the model has no solution at any of {} starts between the bounds; in their middle: {reason}", points + 2)
            }
            Ok(_) => "the misfit overflows at every start: the data and the model are in other units".to_owned(),
        });
    };
    // Starts that lie in one valley tell no more than one of them: each is at least a tenth of the box away from those before.
    let mut chosen = vec![best.clone()];
    let distance = |one: &[f64], other: &[f64]| {
        let parts = one.iter().zip(other).zip(parameters).map(|((one, other), parameter)| {
            let [low, high] = parameter.ends();
            ((one - other) / (high - low)).abs()
        });
        parts.fold(0.0, f64::max)
    };
    for (_, start) in &scored {
        if chosen.len() < weighted.problem.starts.max(1) && chosen.iter().all(|other| distance(start, other) > 0.1) {
            chosen.push(start.clone());
        }
    }
    if let Some((misfit, given)) = given
        && misfit.is_finite()
        && !chosen.contains(&given)
    {
        chosen.push(given);
    }
    Ok(chosen)
}

/// 0 to `count` − 1 in an order from the seed.
fn shuffled(count: usize, number: u64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    let mut stream = SplitMix::of(SEED, number);
    for last in (1..count).rev() {
        order.swap(last, (stream.bits() % (last as u64 + 1)) as usize);
    }
    order
}

/// The minimum of the fine model, with standard deviations that are those of its residuals.
fn settled(weighted: &mut Weighted<'_>, mut coordinates: Vec<f64>) -> Result<Vec<f64>, Refusal> {
    for _ in 0..ROUNDS {
        coordinates = descended(At::new(weighted, coordinates), MOST_STEPS).coordinates;
        let differences = weighted.differences(&coordinates).map_err(|reason| Refusal::Undefined { quantity: "a fit", reason })?;
        let estimated = estimated(weighted, &differences);
        let change = estimated.iter().zip(&weighted.sigmas).map(|(new, old)| (new / old - 1.0).abs()).fold(0.0, f64::max);
        weighted.sigmas = estimated;
        if change < SETTLED {
            break;
        }
    }
    Ok(coordinates)
}

/// σ of each group: known, or from its residuals, of which the parameters have taken their share.
fn estimated(weighted: &Weighted<'_>, differences: &[f64]) -> Vec<f64> {
    let problem = weighted.problem;
    let all: usize = problem.groups.iter().map(|group| group.places.len()).sum();
    let of = |group: &super::Group| match group.noise {
        Noise::Known(sigma) => sigma,
        Noise::Guess(guess) => {
            let own = differences.get(group.places.clone()).unwrap_or(&[]);
            let count = own.len() as f64;
            let share = problem.parameters.len() as f64 * count / all as f64;
            let sigma = match problem.loss {
                super::Loss::Squares => (super::at::squares(own) / (count - share).max(1.0)).sqrt(),
                // The median of the sizes of normal numbers is 0.6745 standard deviations.
                super::Loss::Huber => {
                    let mut sizes: Vec<f64> = own.iter().map(|difference| difference.abs()).collect();
                    sizes.sort_by(f64::total_cmp);
                    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0) / 0.6745 * (count / (count - share).max(1.0)).sqrt()
                }
            };
            // Residuals of rounding are no noise.
            sigma.max(1e-9 * guess)
        }
    };
    problem.groups.iter().map(of).collect()
}

/// A minimum with its Jacobian.
struct Ending<'w> {
    weighted: Weighted<'w>,
    coordinates: Vec<f64>,
    differences: Vec<f64>,
    misfit: f64,
    jacobian: Vec<Vec<f64>>,
    covariance: Covariance,
    /// What a rise of χ² is compared with.
    threshold: f64,
    freedom: f64,
}

impl<'w> Ending<'w> {
    fn new(weighted: &Weighted<'w>, coordinates: &[f64]) -> Result<Self, Refusal> {
        let mut weighted = weighted.clone();
        let differences = weighted.differences(coordinates).map_err(|reason| Refusal::Undefined { quantity: "a fit", reason })?;
        let scaled = weighted.scaled(&differences);
        let residuals: Vec<f64> = scaled.iter().map(|residual| weighted.problem.loss.root(*residual)).collect();
        // Steps of some standard errors: smaller ones drown in the scatter of the model, larger ones leave the linear picture.
        let rough = weighted.jacobian(coordinates, &residuals, false);
        weighted.steps = rough
            .iter()
            .map(|column| {
                let length = product(column, column).sqrt();
                if length > 0.0 { (OF_ERRORS / length).clamp(1e-5, WIDEST) } else { FIRST_STEP }
            })
            .collect();
        let jacobian = weighted.jacobian(coordinates, &residuals, true);
        let [of_covariance, of_rise] = weighted.problem.loss.factors(&scaled);
        let covariance = Covariance::of(&jacobian, of_covariance);
        let freedom = (weighted.problem.data.len() - weighted.problem.parameters.len()) as f64;
        let t = two_sided(INSIDE, freedom);
        Ok(Self {
            misfit: super::at::squares(&residuals),
            coordinates: coordinates.to_vec(),
            differences,
            jacobian,
            covariance,
            threshold: t * of_rise.sqrt(),
            freedom,
            weighted,
        })
    }

    /// Intervals by profiles, or a better minimum.
    fn intervals(&self) -> Result<Vec<Interval>, Vec<f64>> {
        let minimum =
            Minimum { coordinates: &self.coordinates, misfit: self.misfit, jacobian: &self.jacobian, covariance: &self.covariance };
        let sides: Vec<(usize, f64)> = (0..self.coordinates.len()).flat_map(|place| [(place, -1.0), (place, 1.0)]).collect();
        let walks: Vec<Walk> = sides.par_iter().map(|&(place, side)| minimum.walked(&self.weighted, place, side, self.threshold)).collect();
        let better = walks.iter().filter_map(|walk| match walk {
            Walk::Better(there, misfit) => Some((misfit, there)),
            Walk::End(_) => None,
        });
        if let Some((_, there)) = better.min_by(|one, other| one.0.total_cmp(other.0)) {
            return Err(there.clone());
        }
        let end = |index: usize| match walks.get(index) {
            Some(Walk::End(end)) => *end,
            _ => End::Open(f64::NAN),
        };
        let in_values = |place: usize, end: End| {
            let value = |coordinate: f64| self.weighted.problem.parameters.get(place).map_or(coordinate, |one| one.value(coordinate));
            match end {
                End::At(coordinate) => End::At(value(coordinate)),
                End::Open(coordinate) => End::Open(value(coordinate)),
            }
        };
        Ok((0..self.coordinates.len())
            .map(|place| Interval { lower: in_values(place, end(2 * place)), upper: in_values(place, end(2 * place + 1)) })
            .collect())
    }

    fn fitted(&self, by_profile: Vec<Interval>) -> Fitted {
        let problem = self.weighted.problem;
        let values = problem.values(&self.coordinates);
        let t = two_sided(INSIDE, self.freedom);
        let standard_errors: Vec<f64> = (0..values.len()).map(|place| self.covariance.standard_error(place)).collect();
        let end = |place: usize, side: f64| {
            let (Some(parameter), Some(at), Some(error)) =
                (problem.parameters.get(place), self.coordinates.get(place), standard_errors.get(place))
            else {
                return End::Open(f64::NAN);
            };
            let [low, high] = parameter.ends();
            let reached = at + side * t * error;
            if reached >= low && reached <= high {
                End::At(parameter.value(reached))
            } else {
                End::Open(if side > 0.0 { parameter.upper } else { parameter.lower })
            }
        };
        let by_covariance = (0..values.len()).map(|place| Interval { lower: end(place, -1.0), upper: end(place, 1.0) }).collect();
        let model: Vec<f64> = self.differences.iter().zip(&problem.data).map(|(difference, datum)| datum + difference).collect();
        let quality = |group: &super::Group| {
            let part = group.places.clone();
            Quality::of(self.differences.get(part.clone()).unwrap_or(&[]), problem.data.get(part).unwrap_or(&[]))
        };
        Fitted {
            by_covariance,
            by_profile,
            correlations: self.covariance.correlations(),
            weakest: self.covariance.weakest(),
            quality: problem.groups.iter().map(quality).collect(),
            sigmas: self.weighted.sigmas.clone(),
            misfit: self.misfit,
            freedom: self.freedom,
            jacobian: self.jacobian.clone(),
            reached_by: (0, 0),
            others: Vec::new(),
            evaluations: 0,
            standard_errors,
            model,
            values,
        }
    }
}
