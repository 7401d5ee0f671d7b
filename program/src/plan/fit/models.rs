//! Which model: the same data by simpler models of the same scene, compared by Akaike's criterion and by where each holds.

use super::carry_out::{Fit, carry_out};
use super::compare::WORK;
use super::setup::Setup;
use crate::outcome::Verdict;
use crate::plan::Plan;
use crate::scene::catalogue::Range;
use crate::scene::check::{Units, number};
use crate::scene::document::{Document, Node, Value};
use crate::scene::read;
use crate::scene::typed::{FitFree, Problem};
use crate::scene::units::Dimension;

/// How far the modulus of an elastic model may lie beyond the two of the solid.
const BEYOND: f64 = 30.0;
/// A criterion higher by this much is that of a model for which the data speak hardly at all (evidence e⁻⁵).
const HARDLY: f64 = 10.0;

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

/// The model of the scene and the simpler ones that it contains: without memory (JKR, or Hertz without adhesion; attraction beside the contact, DMT), without
/// adhesion. Of other problems than an indentation the scene's own alone.
#[must_use]
pub fn models(setup: &Setup, own: &Fit) -> Vec<Alternative> {
    let mut found = vec![alternative("the scene as it is", Ok(own.clone()))];
    let Ok(scene) = read::read(&setup.document) else { return found };
    let Problem::Indentation(indentation) = &scene.problem else { return found };
    let adhesion = indentation.adhesion.is_some();
    let memory = !scene.material.series.relaxation_terms().is_empty();
    let elastic = memory && setup.units == Units::Si && scene.material.series.relaxed_modulus() > 0.0;
    let mut add = |name: &'static str, variant: Result<Setup, String>| {
        let fit = variant.and_then(|variant| carry_out(variant).map_err(|refusal| refusal.to_string()));
        found.push(alternative(name, fit));
    };
    if adhesion && memory {
        add("viscoelastic, without adhesion", variant(setup, true, false, false));
    }
    if elastic && adhesion {
        add("elastic, adhesion at the edge (JKR)", variant(setup, false, true, false));
    }
    if adhesion && (elastic || !memory) {
        add("elastic, attraction beside the contact (DMT)", variant(setup, true, elastic, true));
    }
    if elastic {
        add("elastic, without adhesion (Hertz)", variant(setup, true, true, false));
    }
    found
}

fn alternative(name: &'static str, fit: Result<Fit, String>) -> Alternative {
    let fails = fit.as_ref().map_or_else(|_| Vec::new(), fails);
    Alternative { name, fit, fails }
}

/// The setup without some of its effects: `smooth` leaves adhesion out, `elastic` memory; `beside` puts attraction beside the contact.
fn variant(setup: &Setup, smooth: bool, elastic: bool, beside: bool) -> Result<Setup, String> {
    let mut changed = setup.clone();
    let place = setup.task.compare_place.clone();
    let series = read::read(&setup.document).map_err(|error| error.to_string())?.material;
    let change = |document: &Document| -> Result<Document, String> {
        let mut own = if smooth { document.without(&["adhesion"]) } else { document.clone() };
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
    }
    let gone =
        |key: &str| (smooth && key.starts_with("adhesion.") && !(beside && key == WORK)) || (elastic && key.starts_with("material."));
    let mut free: Vec<FitFree> = setup.task.free.iter().filter(|free| !gone(&free.key)).cloned().collect();
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
    for ((role, _), value) in fit.setup.roles.iter().zip(&fit.fitted.values) {
        if let super::setup::Role::Scene(put) = role
            && document.replace(&put.key, Node { value: Value::Number(*value), place: put.place.clone() }).is_err()
        {
            return Vec::new();
        }
    }
    let Ok(mut scene) = read::read_state(&document) else { return Vec::new() };
    scene.accuracy = 1e-2;
    let Ok(plan) = Plan::new(&scene) else { return Vec::new() };
    let rows = plan.solve(0, &[]);
    let sentence = |validity: crate::outcome::Validity| {
        let value = validity.value.map_or_else(String::new, |value| format!(" = {value:.2e}"));
        (validity.verdict == Verdict::Caution).then(|| format!("{}{value}: {}", validity.name, validity.meaning))
    };
    plan.validity(&rows).into_iter().filter_map(sentence).collect()
}
