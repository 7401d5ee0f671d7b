//! From a scene with [fit] to tests that can be computed: what belongs together is checked before anything is solved.

use super::compare::{Compared, Comparison, Offsets, Put};
use super::noise;
use crate::plan::Plan;
use crate::scene::check::Units;
use crate::scene::delimited::Scale;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::{Document, Value};
use crate::scene::typed::{FitFree, FitTask, FitTest, Problem};
use crate::scene::units::Dimension;
use crate::scene::{check, read};
use viscotack::fit::Parameter;

/// An offset of the data of one test.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Offset {
    Depth,
    Time,
    Force,
    Drift,
}

/// What a parameter stands for.
#[derive(Debug, Clone)]
pub(super) enum Role {
    /// A number of the scene.
    Scene(Put),
    /// An offset of a test.
    Of(usize, Offset),
}

/// A fit that can be made.
#[derive(Debug, Clone)]
pub struct Setup {
    pub(super) task: FitTask,
    pub(super) title: String,
    pub(super) problem: &'static str,
    pub(super) units: Units,
    /// The scene without [fit].
    pub(super) document: Document,
    pub(super) tests: Vec<Comparison>,
    pub(super) parameters: Vec<Parameter>,
    /// What each parameter stands for, and its unit.
    pub(super) roles: Vec<(Role, String)>,
    /// Whether rows of the data are states.
    pub(super) across: bool,
}

impl Setup {
    /// Sets a fit up.
    ///
    /// # Errors
    /// The first thing that is wrong with the scene, the table `[fit]` or the data.
    pub fn new(document: &mut Document) -> Result<Self, SceneError> {
        let task = read::read_fit(document)?;
        let document = document.without(&["fit"]);
        let scene = read::read(&document)?;
        let units = scene.units;
        let across = task.against_dimension.is_some();
        if !across && !matches!(scene.problem, Problem::Indentation(_)) {
            let message = "data against time belong to an indentation; here each row of the data is a state";
            return Err(SceneError::at(&task.compare_place, message, "of this fit")
                .help("say against which number of the scene the data are given, such as fit.against = \"crack.speed\""));
        }
        let plan = Plan::new(&scene).map_err(|refusal| SceneError::general(refusal.to_string()))?;
        if !across {
            along_words(&task, &scene.problem)?;
        }
        let tests =
            task.tests.iter().map(|test| comparison(&document, &task, test, across, &plan, units)).collect::<Result<Vec<_>, _>>()?;
        let mut setup = Self {
            title: scene.title.clone(),
            problem: plan.problem(),
            units,
            document,
            tests,
            parameters: Vec::new(),
            roles: Vec::new(),
            across,
            task: task.clone(),
        };
        for free in &task.free {
            setup.add(free)?;
        }
        super::inspect::before(&setup)?;
        Ok(setup)
    }

    /// What is written of the data.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.tests.iter().map(|test| test.rows.len() * test.columns.len()).sum()
    }

    fn unit(&self, free: &FitFree) -> String {
        if self.units == Units::Reduced { "1".to_owned() } else { free.dimension.si_unit() }
    }

    pub(super) fn add(&mut self, free: &FitFree) -> Result<(), SceneError> {
        let unit = self.unit(free);
        let offset = match free.key.as_str() {
            "fit.depth_offset" => Offset::Depth,
            "fit.time_offset" => Offset::Time,
            "fit.force_offset" => Offset::Force,
            "fit.force_drift" => Offset::Drift,
            _ => {
                let Some([lower, upper]) = free.bounds else { return Ok(()) };
                let first = match self.document.root.at(&free.key) {
                    Some(node) if matches!(node.value, Value::Number(_) | Value::Text(_)) => {
                        check::number(node, &free.key, free.dimension, self.units).ok().filter(|value| *value >= lower && *value <= upper)
                    }
                    _ => None,
                };
                let logarithmic = lower > 0.0;
                self.parameters.push(Parameter { name: free.key.clone(), lower, upper, logarithmic, first });
                self.roles.push((Role::Scene(Put { key: free.key.clone(), place: free.place.clone() }), unit));
                return Ok(());
            }
        };
        let wrong = |message: String, label: &str| Err(SceneError::at(&free.place, message, label));
        for number in 0..self.tests.len() {
            let Some(test) = self.tests.get(number) else { continue };
            let has = |word: &str| test.columns.iter().any(|column| column.word == word);
            let range = |values: &[f64]| {
                values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
            };
            let forces = test.columns.iter().find(|column| column.word == "force").map(|column| range(&column.values));
            let width = match offset {
                Offset::Depth if matches!(test.against.as_str(), "penetration" | "frame") => Some(range(&test.abscissa)),
                Offset::Depth if has("penetration") || has("frame") => test
                    .columns
                    .iter()
                    .find(|column| matches!(column.word.as_str(), "penetration" | "frame"))
                    .map(|column| range(&column.values)),
                Offset::Time if test.against == "time" => Some(range(&test.abscissa)),
                Offset::Force => forces,
                Offset::Drift => forces.zip(test.time.as_ref().map(|time| range(time))).map(|(force, time)| {
                    let rate = (force.1 - force.0) / (time.1 - time.0);
                    (-0.5 * rate, 0.5 * rate)
                }),
                Offset::Depth | Offset::Time => None,
            };
            let Some((low, high)) = width.filter(|(low, high)| high > low && !self.across) else {
                let why = match offset {
                    Offset::Depth => {
                        "the data are neither given against a depth nor compared with one: write fit.against = \"penetration\" or \"frame\", or free fit.time_offset"
                    }
                    Offset::Time => "the data are not given against the time",
                    Offset::Force => "no force is compared along a history",
                    Offset::Drift => "no force is compared, or the data have no time",
                };
                return wrong(format!("`{}` has no effect on {:?}: {why}", free.key, test.file), "leave it out");
            };
            let half = 0.5 * (high - low);
            let [lower, upper] = free.bounds.unwrap_or([-half, half]);
            let several = self.tests.len() > 1;
            let name = if several { format!("{} of test {}", free.key, number + 1) } else { free.key.clone() };
            self.parameters.push(Parameter { name, lower, upper, logarithmic: false, first: Some(0.0) });
            self.roles.push((Role::Of(number, offset), unit.clone()));
        }
        Ok(())
    }

    /// The data that the model would give at parameters, test after test, column after column: what a fit is tested with, and plans of further tests.
    ///
    /// # Errors
    /// The reason why the model has no numbers there.
    pub fn simulated(&self, values: &[f64], tolerance: f64) -> Result<Vec<f64>, String> {
        let relative = self.tests.iter().any(|test| test.relative);
        Ok(self.model(values, tolerance)?.into_iter().map(|value| if relative { value.exp() } else { value }).collect())
    }

    /// The names of what is free, and between which values.
    #[must_use]
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// The model of all tests at parameters.
    pub(super) fn model(&self, values: &[f64], tolerance: f64) -> Result<Vec<f64>, String> {
        use rayon::prelude::*;
        let put: Vec<(&Put, f64)> = self
            .roles
            .iter()
            .zip(values)
            .filter_map(|((role, _), value)| match role {
                Role::Scene(put) => Some((put, *value)),
                Role::Of(..) => None,
            })
            .collect();
        let of = |(number, test): (usize, &Comparison)| test.model(&put, self.offsets(number, values), tolerance);
        let parts: Vec<Vec<f64>> = self.tests.par_iter().enumerate().map(of).collect::<Result<_, _>>()?;
        Ok(parts.into_iter().flatten().collect())
    }

    pub(super) fn offsets(&self, test: usize, values: &[f64]) -> Offsets {
        let mut offsets = Offsets::default();
        for ((role, _), value) in self.roles.iter().zip(values) {
            match role {
                Role::Of(of, Offset::Depth) if *of == test => offsets.depth = *value,
                Role::Of(of, Offset::Time) if *of == test => offsets.time = *value,
                Role::Of(of, Offset::Force) if *of == test => offsets.force = *value,
                Role::Of(of, Offset::Drift) if *of == test => offsets.drift = *value,
                _ => {}
            }
        }
        offsets
    }
}

fn along_words(task: &FitTask, problem: &Problem) -> Result<(), SceneError> {
    for word in &task.compare {
        if task.against.as_deref() == Some(word.as_str()) {
            return Err(SceneError::at(&task.compare_place, format!("`{word}` is compared against itself"), "name another"));
        }
    }
    if let (Some("frame"), Problem::Indentation(indentation)) = (task.against.as_deref(), problem)
        && indentation.frame_stiffness.is_none()
    {
        let message = "fit.against = \"frame\" needs a frame";
        return Err(SceneError::at(&task.compare_place, message, "of this fit").help("give indentation.frame_stiffness"));
    }
    Ok(())
}

fn comparison(
    document: &Document,
    task: &FitTask,
    test: &FitTest,
    across: bool,
    plan: &Plan,
    units: Units,
) -> Result<Comparison, SceneError> {
    let mut own = document.clone();
    for set in &test.set {
        own.set(set)?;
    }
    if !test.set.is_empty() {
        read::resolve_includes(&mut own)?;
        read::read(&own)?;
    }
    let path = task.against.clone().unwrap_or_else(|| "time".to_owned());
    let word = path.rsplit('.').next().unwrap_or(&path).to_owned();
    let relative = task.relative.unwrap_or(across);
    let values_of = |word: &str| test.table.column(word).map(|column| column.values.clone());
    let abscissa = values_of(&word).unwrap_or_default();
    let unit_of = |dimension: Dimension| if units == Units::Reduced { String::new() } else { dimension.si_unit() };
    let mut columns = Vec::new();
    for word in &task.compare {
        let Some(column) = test.table.column(word) else { continue };
        if across {
            let known = plan.columns();
            let Some(result) = known.iter().find(|known| known.name == word) else {
                let names: Vec<&str> = known.iter().map(|known| known.name).collect();
                let message = format!("`fit.compare` = {word:?} is no column of the result");
                return Err(
                    SceneError::at(&task.compare_place, message, "not known").help(format!("its columns are: {}", names.join(", ")))
                );
            };
            let measured = Scale::of(&result.unit).ok();
            if let Some(scale) = measured.filter(|scale| units == Units::Si && !column.dimension.measures(scale.dimension)) {
                let message = format!("the column `{word}` has the wrong unit: it is measured in {}", column.dimension.si_unit());
                return Err(SceneError::at(&column.place, message, format!("must be measured in {}", scale.dimension.si_unit())));
            }
        }
        if relative && let Some(row) = column.values.iter().position(|value| *value <= 0.0) {
            let message = format!("row {} of `{word}` is not above zero, and the errors are relative", row + 1);
            return Err(SceneError::at(&column.place, message, "has no logarithm").help("write fit.errors = \"absolute\""));
        }
        let noise = if across { guessed(&column.values, relative) } else { noise::noise(&column.values) };
        columns.push(Compared { word: word.clone(), values: column.values.clone(), unit: unit_of(column.dimension), noise });
    }
    if abscissa.len() < 4 {
        let message = format!("{:?} has {} rows", test.table.file, abscissa.len());
        return Err(SceneError::at(&test.table.place, message, "a fit needs at least four"));
    }
    if word == "time"
        && let Some(row) = abscissa.windows(2).position(|pair| matches!(pair, [before, after] if after <= before))
    {
        let message = format!("the time of {:?} does not increase in row {}", test.table.file, row + 2);
        return Err(SceneError::at(&test.table.place, message, "must be later than that of the row before"));
    }
    let place = test.table.place.clone();
    let comparison = Comparison {
        file: test.table.file.clone(),
        document: own,
        across: across.then(|| Put { key: path.clone(), place }),
        unit: test.table.column(&word).map(|column| unit_of(column.dimension)).unwrap_or_default(),
        against: word,
        rows: (0..abscissa.len()).collect(),
        abscissa,
        time: values_of("time"),
        columns,
        gain: None,
        loss: None,
        relative,
        beside: None,
        long_ranges_only: false,
    };
    Ok(if across || relative { comparison } else { comparison.with_jumps() })
}

/// A first guess where rows are too few to show their scatter: 5 % of the value, or of the range.
fn guessed(values: &[f64], relative: bool) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
    if relative { 0.05 } else { (0.05 * (high - low)).max(f64::MIN_POSITIVE) }
}
