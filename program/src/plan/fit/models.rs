//! Which model: the same data by simpler models of the same scene, compared by Akaike's criterion and by where each holds.

use super::carry_out::{Fit, carry_out};
use super::compare::WORK;
use super::noise::noise;
use super::other_theory::{OtherTheory, is_length_of_the_edge, sticks, words};
use super::setup::{Offset, Role, Setup};
use super::words::quantity;
use crate::outcome::Assessment;
use crate::plan::Plan;
use crate::scene::catalogue::Range;
use crate::scene::check::{Units, number};
use crate::scene::diagnostic::SceneError;
use crate::scene::document::{Document, Node, Value};
use crate::scene::read;
use crate::scene::typed::{FitFree, Problem};
use crate::scene::units::Dimension;

/// How far the modulus of an elastic model may lie beyond the two of the solid.
const BEYOND: f64 = 30.0;
/// A criterion higher by this much is that of a model for which the data speak hardly at all (evidence e⁻⁵).
const HARDLY: f64 = 10.0;
/// Part by which a number has to differ from that of the best model to be named.
const MOVED: f64 = 0.02;
/// How many times the noise a force has to pull.
const PULLS: f64 = 5.0;

/// A model of the data.
#[derive(Debug, Clone)]
pub struct Alternative {
    /// What it is called.
    pub name: &'static str,
    /// Its fit, or why there is none.
    pub fit: Result<Fit, String>,
    /// Where its assumptions do not hold at the fitted values, a sentence each.
    pub fails: Vec<String>,
}

impl Alternative {
    /// Akaike's criterion above that of the best of all.
    #[must_use]
    pub fn rise(&self, all: &[Self]) -> Option<f64> {
        let best = all.iter().filter_map(|one| one.fit.as_ref().ok()).map(|fit| fit.akaike).fold(f64::INFINITY, f64::min);
        self.fit.as_ref().ok().map(|fit| fit.akaike - best)
    }

    /// Whether the data speak for it hardly at all beside the best of all.
    #[must_use]
    pub fn is_excluded(&self, all: &[Self]) -> bool {
        self.rise(all).is_some_and(|rise| rise > HARDLY)
    }
}

/// The model of the scene, the other theory of its adhesion (an edge, or a range of attraction), and the simpler ones: without memory (JKR, or Hertz without
/// adhesion; attraction beside the contact, DMT), without adhesion. Of other problems than an indentation the scene's own alone.
#[must_use]
pub fn models(setup: &Setup, own: &Fit) -> Vec<Alternative> {
    let mut found = vec![alternative("the scene as it is", Ok(own.clone()))];
    let Ok(scene) = read::read(&setup.document) else { return found };
    let Problem::Indentation(indentation) = &scene.problem else { return found };
    let adhesion = sticks(&scene);
    let memory = !scene.material.series.relaxation_terms().is_empty();
    let elastic = memory && setup.units == Units::Si && scene.material.series.relaxed_modulus() > 0.0;
    let mut add = |name: &'static str, variant: Result<Setup, String>| {
        let fit = variant.and_then(|variant| carry_out(variant).map_err(|refusal| refusal.to_string()));
        found.push(alternative(name, fit));
    };
    let own_theory = Change::default();
    if adhesion && setup.units == Units::Si {
        let other = put_found(setup, own).and_then(|found| {
            let scene = read::read(&found.document).map_err(|error| error.to_string())?;
            let Problem::Indentation(indentation) = &scene.problem else { return Err("the scene is of no indenter".to_owned()) };
            variant(&found, &Change { other: Some(OtherTheory::of(&scene, indentation)?.bounded(&found.document)?), ..Change::default() })
        });
        add(words(indentation), other);
    }
    if adhesion && memory {
        add("viscoelastic, without adhesion", variant(setup, &Change { smooth: true, ..own_theory.clone() }));
    }
    if elastic && adhesion {
        let edge = if indentation.attraction.is_some() { OtherTheory::of(&scene, indentation).map(Some) } else { Ok(None) };
        let jkr = edge.and_then(|other| variant(setup, &Change { elastic: true, other, ..own_theory.clone() }));
        add("elastic, adhesion at the edge (JKR)", jkr);
    }
    if adhesion && (elastic || !memory) {
        add(
            "elastic, attraction beside the contact (DMT)",
            variant(setup, &Change { smooth: true, elastic, beside: true, ..own_theory.clone() }),
        );
    }
    if elastic || (adhesion && !memory) {
        add("elastic, without adhesion (Hertz)", variant(setup, &Change { smooth: true, elastic, ..own_theory }));
    }
    let off: Vec<Vec<String>> = found.iter().map(|model| moved_numbers(model, &found)).collect();
    for (model, off) in found.iter_mut().zip(off) {
        model.fails.extend(off);
    }
    found
}

/// Numbers of an excluded model that it shares with the best one, and that it gets otherwise.
fn moved_numbers(model: &Alternative, all: &[Alternative]) -> Vec<String> {
    let fits = all.iter().filter_map(|one| Some((one.name, one.fit.as_ref().ok()?)));
    let Some((name, best)) = fits.min_by(|one, other| one.1.akaike.total_cmp(&other.1.akaike)) else { return Vec::new() };
    let Some(fit) = model.fit.as_ref().ok().filter(|_| model.is_excluded(all)) else { return Vec::new() };
    let numbers = |fit: &Fit| -> Vec<(String, f64)> {
        fit.setup.parameters.iter().zip(&fit.fitted.values).map(|(parameter, value)| (parameter.name.clone(), *value)).collect()
    };
    let best = numbers(best);
    let moved = |(key, value): (String, f64)| {
        let ratio = value / best.iter().find(|(other, _)| *other == key)?.1;
        ((ratio - 1.0).abs() > MOVED && ratio.is_finite()).then(|| format!("its {key} is {ratio:.3} times that of {name}"))
    };
    numbers(fit).into_iter().filter_map(moved).collect()
}

/// That a model without adhesion cannot pull, where the data do.
fn cannot_pull(fit: &Fit) -> Option<String> {
    fit.groups.iter().find_map(|group| {
        let test = fit.setup.tests.get(group.test).filter(|test| !test.relative && test.beside.is_none())?;
        let column = test.columns.get(group.column?).filter(|column| column.word == "force")?;
        let adhesive = test.document.root.at("adhesion").is_some();
        let offset = fit.setup.roles.iter().any(|(role, _)| matches!(role, Role::Of(_, Offset::Force)));
        let data: Vec<f64> = test.rows.iter().filter_map(|row| column.values.get(*row)).copied().collect();
        let (pull, noise) = (-data.iter().copied().fold(0.0, f64::min), noise(&data));
        (!adhesive && !offset && pull > PULLS * noise).then(|| {
            format!(
                "without adhesion nothing pulls; these data pull with up to {} ({:.0} times their noise)",
                quantity(pull, if fit.setup.units == Units::Si { "N" } else { "1" }),
                pull / noise
            )
        })
    })
}

fn alternative(name: &'static str, fit: Result<Fit, String>) -> Alternative {
    let mut fails = fit.as_ref().map_or_else(|_| Vec::new(), fails);
    fails.extend(fit.as_ref().ok().and_then(cannot_pull));
    Alternative { name, fit, fails }
}

/// How a model differs from that of the scene.
#[derive(Debug, Clone, Default)]
struct Change {
    /// Without adhesion.
    smooth: bool,
    /// Without memory.
    elastic: bool,
    /// With attraction beside the contact.
    beside: bool,
    /// By the other theory of adhesion.
    other: Option<OtherTheory>,
}

/// The setup with the numbers that a fit has found in place of those of the scene.
fn put_found(setup: &Setup, fit: &Fit) -> Result<Setup, String> {
    let mut changed = setup.clone();
    for document in std::iter::once(&mut changed.document).chain(changed.tests.iter_mut().map(|test| &mut test.document)) {
        put_values(document, fit).map_err(|error| error.to_string())?;
    }
    Ok(changed)
}

/// Puts the numbers that a fit has found into a scene.
fn put_values(document: &mut Document, fit: &Fit) -> Result<(), SceneError> {
    for ((role, _), value) in fit.setup.roles.iter().zip(&fit.fitted.values) {
        if let Role::Scene(put) = role {
            document.replace(&put.key, Node { value: Value::Number(*value), place: put.place.clone() })?;
        }
    }
    Ok(())
}

/// The setup of a model that differs from that of the scene.
fn variant(setup: &Setup, wanted: &Change) -> Result<Setup, String> {
    let &Change { smooth, elastic, beside, .. } = wanted;
    let mut changed = setup.clone();
    let place = setup.task.compare_place.clone();
    let series = read::read(&setup.document).map_err(|error| error.to_string())?.material;
    let change = |document: &Document| -> Result<Document, String> {
        let mut own = match &wanted.other {
            _ if smooth => document.without(&["adhesion"]),
            Some(other) => other.put_into(document)?,
            None => document.clone(),
        };
        if elastic {
            own = own.without(&["material"]);
            let middle = (series.series.relaxed_modulus() * series.series.glassy_modulus()).sqrt();
            let mut put = |key: &str, value: f64| {
                own.replace(key, Node { value: Value::Number(value), place: place.clone() }).map_err(|error| error.to_string())
            };
            put("material.relaxed_modulus", middle)?;
            if let Some(ratio) = series.poisson_ratio {
                put("material.poisson_ratio", ratio)?;
            }
        }
        read::read(&own).map_err(|error| error.to_string())?;
        Ok(own)
    };
    changed.document = change(&setup.document)?;
    for test in &mut changed.tests {
        if beside {
            let given = test.document.root.at(WORK).and_then(|node| number(node, WORK, Dimension::ENERGY_PER_AREA, setup.units).ok());
            test.beside = Some(given.ok_or("the scene gives no work of adhesion")?);
        }
        test.document = change(&test.document)?;
        test.long_ranges_only = wanted.other.as_ref().is_some_and(|other| other.at_a_distance);
    }
    let gone = |key: &str| {
        (smooth && key.starts_with("adhesion.") && !(beside && key == WORK))
            || (elastic && (key.starts_with("material.") || is_length_of_the_edge(key)))
    };
    let kept = setup.task.free.iter().filter(|free| !gone(&free.key));
    let mut free: Vec<FitFree> = kept.map(|free| wanted.other.as_ref().map_or_else(|| free.clone(), |other| other.free(free))).collect();
    if wanted.other.as_ref().is_some_and(|other| other.at_a_distance) {
        // A run takes a hundred times as long as one of an edge, and begins beside the numbers of that.
        changed.task.starts = 1;
    }
    if elastic {
        let bounds = Some([series.series.relaxed_modulus() / BEYOND, series.series.glassy_modulus() * BEYOND]);
        let key = "material.relaxed_modulus".to_owned();
        free.push(FitFree {
            key,
            place: setup.task.compare_place.clone(),
            bounds,
            dimension: Dimension::PRESSURE,
            range: Range::NonNegative,
        });
    }
    changed.parameters.clear();
    changed.roles.clear();
    if free.is_empty() {
        return Err("nothing that is free belongs to this model".to_owned());
    }
    for one in &free {
        changed.add(one).map_err(|error| error.to_string())?;
    }
    changed.task.free = free;
    Ok(changed)
}

/// What the scene with the fitted values says of its own assumptions.
fn fails(fit: &Fit) -> Vec<String> {
    let Some(test) = fit.setup.tests.first() else { return Vec::new() };
    if test.beside.is_some() {
        return vec!["holds for Tabor numbers below about 0.1 only: stiff small spheres".to_owned()];
    }
    let mut document = test.document.clone();
    if put_values(&mut document, fit).is_err() {
        return Vec::new();
    }
    let Ok(mut scene) = read::read_state(&document) else { return Vec::new() };
    scene.accuracy = 1e-2;
    let Ok(plan) = Plan::new(&scene) else { return Vec::new() };
    let rows = plan.solve(0, &[]);
    let sentence = |validity: crate::outcome::Validity| {
        let value = validity.value.map_or_else(String::new, |value| format!(" = {value:.2e}"));
        (validity.assessment == Assessment::Caution).then(|| format!("{}{value}: {}", validity.name, validity.meaning))
    };
    plan.validity(&rows).into_iter().filter_map(sentence).collect()
}
