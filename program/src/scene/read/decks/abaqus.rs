//! Abaqus: `*MATERIAL`, `*ELASTIC`, `*VISCOELASTIC, TIME=PRONY`, `*TRS`.
//!
//! G(t) = G∞ [1 − Σ g_i (1 − e^{−t/τ_i})] and K likewise with k_i: fractions of the INSTANTANEOUS moduli. `*ELASTIC` holds long-term moduli
//! unless it says `MODULI=INSTANTANEOUS`. `*TRS` holds θ0, C1, C2 with log₁₀ a = −C1 (θ − θ0)/(C2 + θ − θ0). Comments begin with `**`; a
//! keyword line that ends with a comma goes on; case does not matter. Source: Abaqus Analysis User's Guide, Time domain viscoelasticity.

use super::source::{DeckSource, Line, skipped};
use super::{Deck, by_youngs};
use crate::scene::diagnostic::SceneError;
use crate::scene::read::material_solid::Moduli;

/// Data pairs: fraction and time.
type Terms = Vec<(f64, f64)>;

/// A keyword with its parameters and its data lines.
struct Keyword<'a> {
    name: String,
    parameters: Vec<(String, String)>,
    line: Line<'a>,
    data: Vec<Line<'a>>,
}

impl Keyword<'_> {
    fn parameter(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }
}

/// A material: its name and its keywords.
struct Block<'a> {
    name: Option<String>,
    keywords: Vec<Keyword<'a>>,
}

pub(super) fn recognises(text: &str) -> bool {
    text.lines().any(|line| {
        let word: String = line.chars().take_while(|&c| c != ',').filter(|c| !c.is_whitespace()).collect();
        matches!(word.to_ascii_uppercase().as_str(), "*VISCOELASTIC" | "*ELASTIC" | "*MATERIAL")
    })
}

pub(super) fn parse(source: &DeckSource<'_>) -> Result<Deck, SceneError> {
    let mut others = Vec::new();
    let blocks = blocks(keywords(source), &mut others);
    let block = source.chosen(
        &blocks,
        |block| vec![block.name.clone().unwrap_or_else(|| "(without a name)".to_owned())],
        "*MATERIAL with *ELASTIC and *VISCOELASTIC",
    )?;
    let find = |name: &str| -> Result<Option<&Keyword<'_>>, SceneError> {
        let mut found = block.keywords.iter().filter(|keyword| keyword.name == name);
        let first = found.next();
        match found.next() {
            Some(second) => Err(source.wrong(&second.line, format!("a second *{name} of the same material"), "leave one out")),
            None => Ok(first),
        }
    };
    let mut notes = Vec::new();
    let (elastic, viscoelastic) = (find("ELASTIC")?, find("VISCOELASTIC")?);
    let Some(elastic) = elastic else {
        let line = block.keywords.iter().find(|keyword| keyword.name.starts_with("HYPER")).map(|keyword| keyword.line);
        let help = "add the moduli of small strains, for example:\n*ELASTIC, MODULI=LONG TERM\n 3.0, 0.49";
        let message = "the material has no *ELASTIC";
        let error = line.map_or_else(
            || source.missing(message, "this deck"),
            |line| source.wrong(&line, message, "this law of large strains is not read"),
        );
        return Err(error.help(help));
    };
    let (youngs, ratio) = elastic_constants(source, elastic)?;
    let moduli = match elastic.parameter("MODULI") {
        Some(word) if word.eq_ignore_ascii_case("INSTANTANEOUS") => Moduli::Instantaneous,
        Some(word) if word.split_whitespace().collect::<String>().eq_ignore_ascii_case("LONGTERM") => Moduli::LongTerm,
        Some(other) => {
            let message = format!("MODULI={other} is unknown");
            return Err(source.wrong(&elastic.line, message, "must be MODULI=INSTANTANEOUS or MODULI=LONG TERM"));
        }
        None => {
            if viscoelastic.is_some() {
                notes.push("*ELASTIC without MODULI is taken as long-term, which is the default of Abaqus".to_owned());
            }
            Moduli::LongTerm
        }
    };
    let (shear, bulk) = match viscoelastic {
        Some(keyword) => prony(source, keyword)?,
        None => {
            notes.push("the material has no *VISCOELASTIC: it is elastic".to_owned());
            (Vec::new(), Vec::new())
        }
    };
    let shift = match find("TRS")? {
        Some(keyword) => trs(source, keyword, &mut notes)?,
        None => None,
    };
    let unused = block.keywords.iter().filter(|keyword| !matches!(keyword.name.as_str(), "ELASTIC" | "VISCOELASTIC" | "TRS"));
    let mut names: Vec<(String, usize)> = unused.map(|keyword| (format!("*{}", keyword.name), keyword.line.number)).collect();
    names.extend(others);
    notes.extend(skipped(&names));
    let solid =
        by_youngs(source.pressure(youngs)?, ratio, moduli, shear, bulk).map_err(|message| source.wrong(&elastic.line, message, "here"))?;
    Ok(Deck { name: block.name.clone(), solid, shift, notes })
}

/// The keywords of the deck, comments and empty lines left out.
fn keywords<'a>(source: &DeckSource<'a>) -> Vec<Keyword<'a>> {
    let mut found: Vec<Keyword<'a>> = Vec::new();
    let mut goes_on = false;
    for line in source.lines() {
        let text = line.text.trim();
        if text.is_empty() || text.starts_with("**") {
            continue;
        }
        if let Some(rest) = text.strip_prefix('*') {
            found.push(Keyword { name: String::new(), parameters: Vec::new(), line, data: Vec::new() });
            read_parameters(&mut found, rest, true);
            goes_on = text.ends_with(',');
        } else if goes_on {
            read_parameters(&mut found, text, false);
            goes_on = text.ends_with(',');
        } else if let Some(keyword) = found.last_mut() {
            keyword.data.push(line);
        }
    }
    found
}

/// Adds the words of a keyword line to the last keyword; the first word of its first line is its name.
fn read_parameters(found: &mut [Keyword<'_>], text: &str, first: bool) {
    let Some(keyword) = found.last_mut() else { return };
    for (index, word) in text.split(',').enumerate() {
        let (key, value) = word.split_once('=').unwrap_or((word, ""));
        let key: String = key.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
        if first && index == 0 {
            keyword.name = key;
        } else if !key.is_empty() {
            keyword.parameters.push((key, value.trim().trim_matches('"').to_owned()));
        }
    }
}

/// The materials; a deck without `*MATERIAL` is one. Keywords of no material are skipped.
fn blocks<'a>(keywords: Vec<Keyword<'a>>, others: &mut Vec<(String, usize)>) -> Vec<Block<'a>> {
    let whole = !keywords.iter().any(|keyword| keyword.name == "MATERIAL");
    let mut blocks: Vec<Block<'a>> = if whole { vec![Block { name: None, keywords: Vec::new() }] } else { Vec::new() };
    for keyword in keywords {
        if keyword.name == "MATERIAL" {
            blocks.push(Block { name: keyword.parameter("NAME").map(str::to_owned), keywords: Vec::new() });
        } else if let Some(block) = blocks.last_mut() {
            block.keywords.push(keyword);
        } else {
            others.push((format!("*{}", keyword.name), keyword.line.number));
        }
    }
    blocks
}

/// The words of a data line, without the empty one after a last comma.
fn cells<'a>(line: &Line<'a>) -> Vec<&'a str> {
    let mut cells: Vec<&str> = line.text.split(',').map(str::trim).collect();
    while cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

fn elastic_constants(source: &DeckSource<'_>, keyword: &Keyword<'_>) -> Result<(f64, f64), SceneError> {
    if let Some(other) = keyword.parameter("TYPE").filter(|word| !word.to_ascii_uppercase().starts_with("ISO")) {
        return Err(source.wrong(&keyword.line, format!("TYPE={other} is not isotropic"), "only TYPE=ISOTROPIC is read"));
    }
    match keyword.data.as_slice() {
        [line] => match cells(line).as_slice() {
            [youngs, ratio, ..] => Ok((source.positive(line, youngs, "Young's modulus")?, source.ratio(line, ratio, "Poisson's ratio")?)),
            _ => Err(source.wrong(line, "*ELASTIC needs Young's modulus and Poisson's ratio", "two numbers")),
        },
        [] => Err(source.wrong(&keyword.line, "*ELASTIC has no data line", "write: modulus, ratio below")),
        [_, second, ..] => {
            let message = "moduli that depend on temperature or a field are not read: a shift of times is, by *TRS or material.shift";
            Err(source.wrong(second, message, "keep one line"))
        }
    }
}

fn prony(source: &DeckSource<'_>, keyword: &Keyword<'_>) -> Result<(Terms, Terms), SceneError> {
    let word = keyword.parameter("TIME").unwrap_or("");
    if !word.eq_ignore_ascii_case("PRONY") {
        let given: Vec<String> = keyword.parameters.iter().map(|(key, value)| format!("{key}={value}")).collect();
        let message = format!("*VISCOELASTIC with {} is not read", if given.is_empty() { "no TIME=".to_owned() } else { given.join(", ") });
        return Err(source
            .wrong(&keyword.line, message, "only TIME=PRONY is")
            .help("measured curves: write them as a CSV file and give material.data; or let Abaqus fit them and copy its Prony terms"));
    }
    let (mut shear, mut bulk) = (Vec::new(), Vec::new());
    for line in &keyword.data {
        let cells = cells(line);
        let (Some(g), Some(k), Some(tau)) = (cells.first(), cells.get(1), cells.get(2)) else {
            return Err(source.wrong(line, "a Prony line needs g, k and tau", "three numbers: for a constant bulk modulus k is 0"));
        };
        if cells.len() > 3 {
            return Err(source.wrong(line, "a Prony line has more than g, k and tau", "terms that depend on temperature are not read"));
        }
        let fraction = |cell: &str, name: &str| if cell.is_empty() { Ok(0.0) } else { source.non_negative(line, cell, name) };
        let (g, k, tau) = (fraction(g, "g")?, fraction(k, "k")?, source.time(source.positive(line, tau, "tau")?)?);
        shear.extend((g > 0.0).then_some((g, tau)));
        bulk.extend((k > 0.0).then_some((k, tau)));
    }
    if keyword.data.is_empty() {
        return Err(source.wrong(&keyword.line, "*VISCOELASTIC, TIME=PRONY has no data line", "write: g, k, tau below"));
    }
    Ok((shear, bulk))
}

fn trs(source: &DeckSource<'_>, keyword: &Keyword<'_>, notes: &mut Vec<String>) -> Result<Option<[f64; 3]>, SceneError> {
    if let Some(other) = keyword.parameter("DEFINITION").filter(|word| !word.eq_ignore_ascii_case("WLF")) {
        notes.push(format!("*TRS, DEFINITION={other} is not read (only WLF is): the terms hold at its reference temperature"));
        return Ok(None);
    }
    let [line] = keyword.data.as_slice() else {
        return Err(source.wrong(&keyword.line, "*TRS needs one data line", "write: reference temperature, C1, C2 below"));
    };
    let cells = cells(line);
    let [reference, c1, c2] = cells.as_slice() else {
        return Err(source.wrong(line, "*TRS needs the reference temperature, C1 and C2", "three numbers"));
    };
    let reference = source.temperature(source.number(line, reference, "the reference temperature")?)?;
    let c2 = source.temperature_difference(source.positive(line, c2, "C2")?)?;
    Ok(Some([reference, source.positive(line, c1, "C1")?, c2]))
}
