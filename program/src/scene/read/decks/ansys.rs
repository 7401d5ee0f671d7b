//! ANSYS: `MP,EX`, `MP,NUXY` or `PRXY`, `MP,GXY`, and `TB,PRONY` with `TBDATA`.
//!
//! G(t) = G∞ [α_∞ + Σ α_i e^{−t/τ_i}] with `SHEAR`, K likewise with `BULK`: α_i are fractions of the INSTANTANEOUS moduli, which `MP` holds.
//! Comments begin with `!`, `$` separates commands of a line, case does not matter. Source: ANSYS Material Reference, Prony series.

use super::source::{DeckSource, Line, skipped};
use super::{Deck, by_youngs};
use crate::scene::diagnostic::SceneError;
use crate::scene::read::material_solid::Moduli;

/// A table of `TB,PRONY`.
struct Prony<'a> {
    shear: bool,
    line: Line<'a>,
    /// NPTS, if it is given.
    stated: Option<usize>,
    /// Constants by their place from 1, in the order written.
    data: Vec<(usize, f64, Line<'a>)>,
}

/// A material by its number.
struct Block<'a> {
    number: String,
    properties: Vec<(String, f64, Line<'a>)>,
    tables: Vec<Prony<'a>>,
}

pub(super) fn recognises(text: &str) -> bool {
    text.lines().any(|line| {
        let word: String = line.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
        ["TB,PRONY", "MP,EX,", "MP,GXY,"].iter().any(|start| word.starts_with(start))
    })
}

pub(super) fn parse(source: &DeckSource<'_>) -> Result<Deck, SceneError> {
    let mut names = Vec::new();
    let blocks = blocks(source, &mut names)?;
    let block = source.chosen(&blocks, |block| vec![block.number.clone()], "TB,PRONY and MP,EX of a material")?;
    let property = |name: &str| block.properties.iter().rev().find(|(key, ..)| key == name);
    let ratio = match (property("NUXY"), property("PRXY")) {
        (Some((_, minor, _)), Some((_, major, line))) if (minor - major).abs() > 0.0 => {
            return Err(source.wrong(line, format!("NUXY = {minor} and PRXY = {major} differ"), "the solid must be isotropic"));
        }
        (Some((_, ratio, line)), _) | (None, Some((_, ratio, line))) => source.ratio(line, &ratio.to_string(), "Poisson's ratio")?,
        (None, None) => {
            let help = format!("add for example: MP,NUXY,{},0.49", block.number);
            return Err(source.missing("the material has no Poisson ratio (MP,NUXY or MP,PRXY)", "this deck").help(help));
        }
    };
    let youngs = match (property("EX"), property("GXY")) {
        (Some((_, youngs, line)), None) => source.positive(line, &youngs.to_string(), "EX")?,
        (None, Some((_, shear, line))) => 2.0 * (1.0 + ratio) * source.positive(line, &shear.to_string(), "GXY")?,
        (Some((_, youngs, _)), Some((_, shear, line))) => {
            if (youngs / (2.0 * (1.0 + ratio)) / shear - 1.0).abs() > 1e-3 {
                let message = format!("GXY = {shear} is not EX/(2(1 + NUXY)) = {}", youngs / (2.0 * (1.0 + ratio)));
                return Err(source.wrong(line, message, "the solid must be isotropic: leave GXY out"));
            }
            *youngs
        }
        (None, None) => {
            let help = format!("add for example: MP,EX,{},3.0", block.number);
            return Err(source.missing("the material has no modulus (MP,EX or MP,GXY)", "this deck").help(help));
        }
    };
    let (mut shear, mut bulk) = (Vec::new(), Vec::new());
    for table in &block.tables {
        let terms = if table.shear { &mut shear } else { &mut bulk };
        if !terms.is_empty() {
            return Err(source.wrong(&table.line, "a second TB,PRONY of the same kind", "leave one out"));
        }
        *terms = pairs(source, table)?;
    }
    let mut notes = vec!["the moduli of MP are taken as instantaneous, as ANSYS does with TB,PRONY".to_owned()];
    if block.tables.is_empty() {
        notes = vec!["the material has no TB,PRONY: it is elastic".to_owned()];
    }
    notes.extend(skipped(&names));
    let solid = by_youngs(source.pressure(youngs)?, ratio, Moduli::Instantaneous, shear, bulk)
        .map_err(|message| source.missing(message, "this deck"))?;
    Ok(Deck { name: None, solid, shift: None, notes })
}

/// All materials, in order of appearance.
fn blocks<'a>(source: &DeckSource<'a>, skipped: &mut Vec<(String, usize)>) -> Result<Vec<Block<'a>>, SceneError> {
    let mut blocks: Vec<Block<'a>> = Vec::new();
    // The material whose table takes TBDATA, if it is one of TB,PRONY.
    let mut open: Option<usize> = None;
    let mut temperatures = 0;
    for line in source.lines() {
        for command in line.text.split('!').next().unwrap_or("").split('$') {
            let words: Vec<&str> = command.split(',').map(str::trim).collect();
            let Some(first) = words.first().filter(|word| !word.is_empty()) else { continue };
            let word = |index: usize| words.get(index).copied().unwrap_or("");
            match (first.to_ascii_uppercase().as_str(), word(1).to_ascii_uppercase().as_str()) {
                ("TB", "PRONY") => {
                    let kind = word(5).to_ascii_uppercase();
                    temperatures = 0;
                    if kind.starts_with("INTE") {
                        skipped.push(("TB,PRONY,…,INTEGRATION".to_owned(), line.number));
                        open = None;
                        continue;
                    }
                    let shear = kind.starts_with("SHEA");
                    if !shear && kind != "BULK" {
                        let message = format!("TB,PRONY of the kind {kind:?}");
                        return Err(source.wrong(&line, message, "the sixth word must be SHEAR or BULK"));
                    }
                    let stated = word(4).parse().ok();
                    let at = block_of(&mut blocks, word(2));
                    if let Some(block) = blocks.get_mut(at) {
                        block.tables.push(Prony { shear, line, stated, data: Vec::new() });
                    }
                    open = Some(at);
                }
                ("TB", other) => {
                    skipped.push((format!("TB,{other}"), line.number));
                    open = None;
                }
                ("TBTEMP", _) if open.is_some() => {
                    temperatures += 1;
                    if temperatures > 1 {
                        let message = "Prony terms at several temperatures are not read";
                        return Err(source.wrong(&line, message, "keep one temperature, and give material.shift in the scene"));
                    }
                }
                ("TBDATA", _) => {
                    let Some(table) = open.and_then(|at| blocks.get_mut(at)).and_then(|block| block.tables.last_mut()) else { continue };
                    let start = match word(1) {
                        "" => table.data.last().map_or(1, |last| last.0 + 1),
                        place => source.positive(&line, place, "the first place of TBDATA")? as usize,
                    };
                    for (index, constant) in words.iter().skip(2).enumerate().filter(|(_, constant)| !constant.is_empty()) {
                        table.data.push((start + index, source.non_negative(&line, constant, "a constant of TBDATA")?, line));
                    }
                }
                ("MP", name @ ("EX" | "NUXY" | "PRXY" | "GXY")) => {
                    if words.iter().skip(4).any(|cell| !cell.is_empty() && cell.parse() != Ok(0.0)) {
                        let message = format!("MP,{name} depends on temperature");
                        return Err(source.wrong(&line, message, "only a constant is read"));
                    }
                    let value = source.number(&line, word(3), &format!("MP,{name}"))?;
                    let at = block_of(&mut blocks, word(2));
                    if let Some(block) = blocks.get_mut(at) {
                        block.properties.push((name.to_owned(), value, line));
                    }
                }
                ("MP", other) => skipped.push((format!("MP,{other}"), line.number)),
                (other, _) => skipped.push((other.to_owned(), line.number)),
            }
        }
    }
    Ok(blocks)
}

/// The place of a material by its number; 1 where none is said, as in ANSYS.
fn block_of(blocks: &mut Vec<Block<'_>>, number: &str) -> usize {
    let number = if number.is_empty() { "1" } else { number };
    blocks.iter().position(|block| block.number == number).unwrap_or_else(|| {
        blocks.push(Block { number: number.to_owned(), properties: Vec::new(), tables: Vec::new() });
        blocks.len() - 1
    })
}

/// The pairs α, τ of a table.
fn pairs(source: &DeckSource<'_>, table: &Prony<'_>) -> Result<Vec<(f64, f64)>, SceneError> {
    let mut data = table.data.iter().collect::<Vec<_>>();
    data.sort_by_key(|constant| constant.0);
    if let Some((_, (place, _, line))) = data.iter().enumerate().find(|(index, constant)| constant.0 != index + 1) {
        return Err(source.wrong(line, format!("constant {place} of TBDATA is given twice, or one before it is missing"), "here"));
    }
    if data.is_empty() || data.len() % 2 == 1 {
        return Err(source.wrong(&table.line, format!("TB,PRONY has {} constants", data.len()), "needs pairs alpha, tau in TBDATA"));
    }
    if let Some(stated) = table.stated.filter(|stated| 2 * stated != data.len()) {
        let message = format!("TB,PRONY announces {stated} pairs, and TBDATA holds {}", data.len() / 2);
        return Err(source.wrong(&table.line, message, "make both agree"));
    }
    let mut terms = Vec::with_capacity(data.len() / 2);
    for pair in data.chunks_exact(2) {
        let [(_, fraction, _), (_, time, line)] = pair else { continue };
        let time = source.time(source.positive(line, &time.to_string(), "tau")?)?;
        terms.extend((*fraction > 0.0).then_some((*fraction, time)));
    }
    Ok(terms)
}
