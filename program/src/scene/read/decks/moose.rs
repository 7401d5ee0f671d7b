//! MOOSE: a block with `type = GeneralizedMaxwellModel`.
//!
//! σ = C ε − Σ Cₙ αₙ with αₙ following ε in the time ηₙ: `young_modulus` and `poisson_ratio` make the INSTANTANEOUS stiffness C, `creep_modulus` and
//! `creep_ratio` (or `poisson_ratio`) the parts Cₙ that relax, `creep_viscosity` the relaxation times (s). Comments begin with `#`. Source: MOOSE
//! documentation of the solid mechanics module, GeneralizedMaxwellModel.

use super::source::{DeckSource, Line, skipped};
use super::{Deck, by_youngs};
use crate::scene::diagnostic::SceneError;
use crate::scene::read::material_solid::{Moduli, Relaxing, Solid, Strength, Volume};

const MODEL: &str = "GeneralizedMaxwellModel";

/// A block with its parameters and where they stand.
struct Block<'a> {
    name: String,
    line: Line<'a>,
    parameters: Vec<(String, String, Line<'a>)>,
}

pub(super) fn recognises(text: &str) -> bool {
    text.contains(MODEL) || text.lines().any(|line| line.trim() == "[Materials]")
}

pub(super) fn parse(source: &DeckSource<'_>) -> Result<Deck, SceneError> {
    let mut blocks = blocks(source)?;
    if let Some(block) = blocks.iter().find(|block| value(block, "type").is_some_and(|(word, _)| word == "GeneralizedKelvinVoigtModel")) {
        let help = "give its chain as material.creep terms: compliance 1/creep_modulus, retardation_time creep_viscosity";
        return Err(source.wrong(&block.line, "GeneralizedKelvinVoigtModel is not read", "this block").help(help));
    }
    let others: Vec<(String, usize)> = blocks
        .extract_if(.., |block| value(block, "type").is_none_or(|(word, _)| word != MODEL))
        .map(|block| {
            let kind = value(&block, "type").map_or_else(String::new, |(word, _)| format!(" ({word})"));
            (format!("[{}]{kind}", block.name), block.line.number)
        })
        .collect();
    let block = source.chosen(&blocks, |block| vec![block.name.clone()], "block with type = GeneralizedMaxwellModel")?;
    let needed = |name: &str, example: &str| {
        value(block, name).ok_or_else(|| {
            source.wrong(&block.line, format!("{name} is missing"), "in this block").help(format!("write {name} = {example}"))
        })
    };
    let (youngs, line) = needed("young_modulus", "10e9")?;
    let youngs = source.positive(line, youngs, "young_modulus")?;
    let (ratio, line) = needed("poisson_ratio", "0.3")?;
    let ratio = source.ratio(line, ratio, "poisson_ratio")?;
    let list = |(words, line): (&str, &Line<'_>), name: &str| -> Result<Vec<f64>, SceneError> {
        words.split_whitespace().map(|word| source.non_negative(line, word, name)).collect()
    };
    let (moduli, times) = (needed("creep_modulus", "'3e9 3e9'")?, needed("creep_viscosity", "'1 10'")?);
    let (moduli_line, times_line) = (moduli.1, times.1);
    let (moduli, times) = (list(moduli, "creep_modulus")?, list(times, "creep_viscosity")?);
    if moduli.len() != times.len() {
        let message = format!("creep_modulus has {} numbers and creep_viscosity {}", moduli.len(), times.len());
        return Err(source.wrong(moduli_line, message, "both must have as many"));
    }
    if times.contains(&0.0) {
        return Err(source.wrong(times_line, "a time of creep_viscosity is 0", "must be greater than 0"));
    }
    let times: Vec<f64> = times.into_iter().map(|time| source.time(time)).collect::<Result<_, _>>()?;
    let ratios = match value(block, "creep_ratio") {
        Some((words, line)) => {
            let ratios: Vec<f64> =
                words.split_whitespace().map(|word| source.ratio(line, word, "creep_ratio")).collect::<Result<_, _>>()?;
            if ratios.len() != moduli.len() {
                let message = format!("creep_ratio has {} numbers and creep_modulus {}", ratios.len(), moduli.len());
                return Err(source.wrong(line, message, "both must have as many"));
            }
            ratios
        }
        None => vec![ratio; moduli.len()],
    };
    let solid = if ratios.iter().all(|one| one.to_bits() == ratio.to_bits()) {
        let terms: Vec<(f64, f64)> = moduli.iter().zip(&times).map(|(modulus, time)| (modulus / youngs, *time)).collect();
        by_youngs(source.pressure(youngs)?, ratio, Moduli::Instantaneous, terms.clone(), terms)
            .map_err(|message| source.wrong(line, message, "here"))?
    } else if ratio >= 0.5 || ratios.iter().any(|&one| one >= 0.5) {
        return Err(source.wrong(line, "a Poisson ratio of 0.5 has no finite bulk modulus that could relax", "must be below 0.5"));
    } else {
        let relaxing = |part: &dyn Fn(f64, f64) -> f64| -> Result<Relaxing, SceneError> {
            let parts = moduli.iter().zip(&ratios).zip(&times);
            let terms = parts
                .map(|((&modulus, &ratio), &time)| Ok((source.pressure(part(modulus, ratio))?, time)))
                .collect::<Result<_, SceneError>>()?;
            let modulus = source.pressure(part(youngs, ratio))?;
            Ok(Relaxing { modulus, moduli: Moduli::Instantaneous, strength: Strength::Modulus, terms })
        };
        let shear = relaxing(&|modulus, ratio| modulus / (2.0 * (1.0 + ratio)))?;
        Solid { shear, volume: Volume::Bulk(relaxing(&|modulus, ratio| modulus / (3.0 * (1.0 - 2.0 * ratio)))?) }
    };
    let known = ["type", "young_modulus", "poisson_ratio", "creep_modulus", "creep_viscosity", "creep_ratio"];
    let idle =
        block.parameters.iter().filter(|(name, ..)| !known.contains(&name.as_str())).map(|(name, _, line)| (name.clone(), line.number));
    let names: Vec<(String, usize)> = idle.chain(others).collect();
    let mut notes =
        vec!["young_modulus and poisson_ratio are taken as instantaneous, creep_viscosity as relaxation times, as MOOSE does".to_owned()];
    notes.extend(skipped(&names));
    Ok(Deck { name: Some(block.name.clone()), solid, shift: None, notes })
}

fn value<'b, 'a>(block: &'b Block<'a>, name: &str) -> Option<(&'b str, &'b Line<'a>)> {
    block.parameters.iter().find(|(key, ..)| key == name).map(|(_, value, line)| (value.as_str(), line))
}

/// All blocks with parameters, each by its innermost name.
fn blocks<'a>(source: &DeckSource<'a>) -> Result<Vec<Block<'a>>, SceneError> {
    let mut done: Vec<Block<'a>> = Vec::new();
    let mut open: Vec<Block<'a>> = Vec::new();
    // A quoted value that goes on in the next line.
    let mut quoted: Option<(String, String, Line<'a>)> = None;
    for line in source.lines() {
        let text = line.text.split('#').next().unwrap_or("").trim();
        if let Some((key, mut value, begun)) = quoted.take() {
            let end = text.find(['\'', '"']);
            value.push(' ');
            value.push_str(end.map_or(text, |end| text.get(..end).unwrap_or("")));
            if end.is_some() {
                open.last_mut().into_iter().for_each(|block| block.parameters.push((key.clone(), value.clone(), begun)));
            } else {
                quoted = Some((key, value, begun));
            }
        } else if let Some(name) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            let name = name.trim().trim_start_matches("./");
            if name.is_empty() || name == "../" || name == ".." {
                done.extend(open.pop());
            } else {
                open.push(Block { name: name.to_owned(), line, parameters: Vec::new() });
            }
        } else if let Some((key, value)) = text.split_once('=') {
            let (key, value) = (key.trim().to_owned(), value.trim());
            match value.strip_prefix(['\'', '"']) {
                Some(rest) if !rest.contains(['\'', '"']) => quoted = Some((key, rest.to_owned(), line)),
                _ => open.last_mut().into_iter().for_each(|block| {
                    block.parameters.push((key.clone(), value.trim_matches(['\'', '"']).to_owned(), line));
                }),
            }
        }
    }
    if let Some((key, _, line)) = quoted {
        return Err(source.wrong(&line, format!("the quoted value of {key} has no end"), "close the quote"));
    }
    done.extend(open);
    done.retain(|block| !block.parameters.is_empty());
    Ok(done)
}
