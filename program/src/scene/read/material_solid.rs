//! A solid as its shear modulus with a bulk modulus or a Poisson ratio: what keys and finite-element decks have in common.

use super::material_fractions::FRACTION_SLACK;
use super::section::Section;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use viscotack::material::isotropic::IsotropicSolid;
use viscotack::material::{Material, RelaxationTerm};

/// Which modulus is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Moduli {
    /// Of an instantaneous load, before anything relaxes.
    Instantaneous,
    /// Of a load held for ever.
    LongTerm,
}

/// The strengths of relaxation terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Strength {
    /// Fractions of the instantaneous modulus; what they leave of 1 is the long-term part.
    Fraction,
    /// Moduli (Pa).
    Modulus,
}

/// A modulus that relaxes: the number given, and terms (strength, time in s).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Relaxing {
    pub(super) modulus: f64,
    pub(super) moduli: Moduli,
    pub(super) strength: Strength,
    pub(super) terms: Vec<(f64, f64)>,
}

/// How the solid changes its volume.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Volume {
    /// A Poisson ratio that holds at all times.
    PoissonRatio(f64),
    /// A bulk modulus, constant or relaxing.
    Bulk(Relaxing),
}

/// A solid.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solid {
    pub(super) shear: Relaxing,
    pub(super) volume: Volume,
}

/// What is made of a solid.
pub(super) struct MadeSolid {
    /// Young's series.
    pub(super) youngs: Material,
    /// Poisson ratio, if constant.
    pub(super) poisson_ratio: Option<f64>,
    /// Both series, if the bulk modulus is given.
    pub(super) isotropic: Option<IsotropicSolid>,
}

impl Relaxing {
    /// A modulus without terms.
    pub(super) const fn constant(modulus: f64) -> Self {
        Self { modulus, moduli: Moduli::Instantaneous, strength: Strength::Modulus, terms: Vec::new() }
    }

    /// The series, or what is wrong with it in one sentence.
    pub(super) fn series(&self, name: &str) -> Result<Material, String> {
        let sum: f64 = self.terms.iter().map(|term| term.0).sum();
        let whole = self.strength == Strength::Fraction && (sum - 1.0).abs() <= FRACTION_SLACK;
        let (relaxed, unit) = match (self.strength, self.moduli) {
            (Strength::Fraction, _) if sum > 1.0 + FRACTION_SLACK => {
                return Err(format!("the fractions of the {name} sum to {sum}, more than the whole instantaneous modulus"));
            }
            (Strength::Fraction, Moduli::Instantaneous) if whole => (0.0, self.modulus),
            (Strength::Fraction, Moduli::Instantaneous) => (self.modulus * (1.0 - sum), self.modulus),
            (Strength::Fraction, Moduli::LongTerm) if whole => {
                return Err(format!(
                    "the fractions of the {name} sum to 1, which leaves no long-term part, but its long-term value is given"
                ));
            }
            (Strength::Fraction, Moduli::LongTerm) => (self.modulus, self.modulus / (1.0 - sum)),
            (Strength::Modulus, Moduli::LongTerm) => (self.modulus, 1.0),
            (Strength::Modulus, Moduli::Instantaneous) => {
                let left = self.modulus - sum;
                if left < -FRACTION_SLACK * self.modulus {
                    return Err(format!(
                        "the terms of the {name} sum to {sum:e} Pa, more than its instantaneous value {:e} Pa",
                        self.modulus
                    ));
                }
                // A sum of decimal numbers that is meant to be the whole modulus differs from it by rounding.
                (if left <= FRACTION_SLACK * self.modulus && !self.terms.is_empty() { 0.0 } else { left }, 1.0)
            }
        };
        let terms: Vec<RelaxationTerm> =
            self.terms.iter().map(|&(strength, relaxation_time)| RelaxationTerm { modulus: strength * unit, relaxation_time }).collect();
        Material::from_relaxation(relaxed, &terms).map_err(|refusal| format!("the {name} cannot be used: {refusal}"))
    }
}

impl Solid {
    /// The solid's series, or what is wrong with it in one sentence.
    pub(super) fn made(&self) -> Result<MadeSolid, String> {
        let shear = self.shear.series("shear modulus")?;
        let refused = |refusal| format!("the solid cannot be made: {refusal}");
        match &self.volume {
            Volume::PoissonRatio(ratio) => {
                let youngs = shear.stiffened(2.0 * (1.0 + ratio)).map_err(refused)?;
                Ok(MadeSolid { youngs, poisson_ratio: Some(*ratio), isotropic: None })
            }
            Volume::Bulk(bulk) => {
                let bulk = bulk.series("bulk modulus")?;
                if bulk.relaxed_modulus() == 0.0 {
                    return Err("the bulk modulus relaxes to zero: its terms must leave a long-term part".to_owned());
                }
                let isotropic = IsotropicSolid::new(shear, bulk).map_err(refused)?;
                Ok(MadeSolid { youngs: isotropic.youngs().clone(), poisson_ratio: None, isotropic: Some(isotropic) })
            }
        }
    }
}

/// The solid of `material.shear_modulus` and the keys beside it.
pub(super) fn from_keys(table: &Section<'_>) -> Result<MadeSolid, SceneError> {
    if table.units() == Units::Reduced {
        let message = "a scene in reduced units holds plane moduli, so a shear modulus has no place in it";
        return Err(table.wrong("shear_modulus", message, "write units = \"si\", or give relaxed_modulus and glassy_modulus"));
    }
    let given = |key: &str| table.node().get(key).is_some();
    let shear_modulus = table.required_number("shear_modulus")?;
    let (shear, bulk) = (terms(table, "shear_relaxation")?, terms(table, "bulk_relaxation")?);
    let moduli = match (shear.is_some() || bulk.is_some(), table.text("moduli")) {
        (true, None) => {
            let message = "`material.moduli` is missing: are the moduli those of an instantaneous load, or of one held for ever?";
            return Err(table.wrong("shear_modulus", message, "which one is this?").help(
                "write moduli = \"instantaneous\" or moduli = \"long_term\" in [material]; the fractions of terms are always of the instantaneous modulus",
            ));
        }
        (false, Some(_)) => {
            let message = "`material.moduli` has no effect without shear_relaxation or bulk_relaxation: nothing relaxes";
            return Err(table.wrong("moduli", message, "leave it out"));
        }
        (_, Some("long_term")) => Moduli::LongTerm,
        _ => Moduli::Instantaneous,
    };
    let relaxing = |modulus: f64, terms: Option<(Strength, Vec<(f64, f64)>)>| match terms {
        Some((strength, terms)) => Relaxing { modulus, moduli, strength, terms },
        None => Relaxing::constant(modulus),
    };
    let volume = match (table.number("bulk_modulus")?, table.number("poisson_ratio")?) {
        (Some(_), Some(_)) => {
            let message = "`material.bulk_modulus` and `material.poisson_ratio` exclude each other: of a constant bulk modulus, Poisson's ratio changes with time";
            return Err(table.wrong("poisson_ratio", message, "leave one of the two out"));
        }
        (None, Some(_)) if given("bulk_relaxation") => {
            let message = "`material.bulk_relaxation` belongs to material.bulk_modulus, and there is none";
            return Err(table.wrong("bulk_relaxation", message, "give bulk_modulus in place of poisson_ratio"));
        }
        (None, Some(ratio)) => Volume::PoissonRatio(ratio),
        (Some(modulus), None) => Volume::Bulk(relaxing(modulus, bulk)),
        (None, None) => {
            let message = "a shear modulus needs `material.bulk_modulus`, or `material.poisson_ratio` if that is constant";
            let help = "for a nearly incompressible rubber write bulk_modulus = \"2 GPa\" (1 to 3 GPa for most), or poisson_ratio = 0.5";
            return Err(table.wrong("shear_modulus", message, "of this solid").help(help));
        }
    };
    Solid { shear: relaxing(shear_modulus, shear), volume }.made().map_err(|message| {
        table.wrong(if given("shear_relaxation") { "shear_relaxation" } else { "shear_modulus" }, message, "from these numbers")
    })
}

/// The strengths and times of a list of relaxation terms, if it is given.
#[allow(clippy::type_complexity)]
fn terms(table: &Section<'_>, key: &str) -> Result<Option<(Strength, Vec<(f64, f64)>)>, SceneError> {
    if table.node().get(key).is_none() {
        return Ok(None);
    }
    let items = table.items(key);
    let mut found: Option<Strength> = None;
    let mut terms = Vec::with_capacity(items.len());
    for item in &items {
        let (way, strength) = match item.exactly_one(&["fraction", "modulus"])? {
            "fraction" => ("fraction", Strength::Fraction),
            other => (other, Strength::Modulus),
        };
        if *found.get_or_insert(strength) != strength {
            let message = format!("`{}` among terms given in another way", item.full(way));
            return Err(item.wrong(way, message, "give all terms in the same way"));
        }
        terms.push((item.required_number(way)?, time(item)?));
    }
    match found {
        Some(strength) => Ok(Some((strength, terms))),
        None => Err(table.wrong(key, format!("`material.{key}` is an empty list"), "add a term, or leave the key out")),
    }
}

/// The relaxation time of a term, given itself or by its decay rate.
pub(super) fn time(term: &Section<'_>) -> Result<f64, SceneError> {
    match term.exactly_one(&["relaxation_time", "decay_rate"])? {
        "decay_rate" => {
            if let Some(word) = term.text("decay_rate").filter(|word| word.contains("Hz")) {
                let message =
                    format!("`{}` = {word:?} is measured in cycles, and a decay rate is 1/relaxation time", term.full("decay_rate"));
                return Err(term.wrong("decay_rate", message, "write it in 1/s"));
            }
            Ok(1.0 / term.required_number("decay_rate")?)
        }
        _ => term.required_number("relaxation_time"),
    }
}
