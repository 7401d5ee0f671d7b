//! LS-DYNA: `*MAT_GENERAL_VISCOELASTIC` (`*MAT_076`) and `*MAT_VISCOELASTIC` (`*MAT_006`).
//!
//! ```text
//! 076   G(t) = Σ G_i e^{−β_i t},  K constant (BULK) or K(t) = Σ K_i e^{−βk_i t}; a term without decay is the long-term part
//! 006   G(t) = GI + (G0 − GI) e^{−βt},  K constant
//! ```
//! Cards have fields of 10 columns, or commas. Comments begin with `$`; `_TITLE` puts a line with the name first; an empty line is a card
//! of zeros. Source: LS-DYNA Keyword User's Manual, Vol. II.

use super::Deck;
use super::source::{DeckSource, Line, skipped};
use crate::scene::diagnostic::SceneError;
use crate::scene::read::material_solid::{Moduli, Relaxing, Solid, Strength, Volume};

/// Columns of a field.
const WIDTH: usize = 10;

/// A material keyword that is read.
struct Block<'a> {
    keyword: Line<'a>,
    general: bool,
    title: Option<String>,
    cards: Vec<Line<'a>>,
}

impl Block<'_> {
    fn number(&self) -> String {
        let first = self.cards.first().map_or("", |card| card.text);
        let field: String =
            if first.contains(',') { first.split(',').next().unwrap_or("").to_owned() } else { first.chars().take(WIDTH).collect() };
        field.trim().to_owned()
    }
}

pub(super) fn recognises(text: &str) -> bool {
    text.lines().any(|line| {
        let word = line.trim().to_ascii_uppercase();
        word.starts_with("*MAT_") || word == "*KEYWORD" || word.starts_with("*KEYWORD ")
    })
}

pub(super) fn parse(source: &DeckSource<'_>) -> Result<Deck, SceneError> {
    let mut names = Vec::new();
    let blocks = blocks(source, &mut names)?;
    let names_of = |block: &Block<'_>| std::iter::once(block.number()).chain(block.title.clone()).collect();
    let block = source.chosen(&blocks, names_of, "*MAT_GENERAL_VISCOELASTIC (076) or *MAT_VISCOELASTIC (006)")?;
    let mut notes = Vec::new();
    let solid = if block.general { general(source, block, &mut notes)? } else { single(source, block)? };
    notes.extend(skipped(&names));
    Ok(Deck { name: block.title.clone(), solid, shift: None, notes })
}

fn blocks<'a>(source: &DeckSource<'a>, skipped: &mut Vec<(String, usize)>) -> Result<Vec<Block<'a>>, SceneError> {
    let mut blocks: Vec<Block<'a>> = Vec::new();
    let (mut open, mut titled) = (false, false);
    for line in source.lines() {
        let text = line.text.trim();
        if text.starts_with('$') {
            continue;
        }
        let Some(rest) = text.strip_prefix('*') else {
            let Some(block) = blocks.last_mut().filter(|_| open) else { continue };
            if std::mem::take(&mut titled) {
                block.title = Some(text.to_owned()).filter(|title| !title.is_empty());
            } else {
                block.cards.push(line);
            }
            continue;
        };
        let word = rest.split_whitespace().next().unwrap_or("").to_ascii_uppercase();
        let (name, title) = match word.strip_suffix("_TITLE") {
            Some(name) => (name, true),
            None => (word.as_str(), false),
        };
        (open, titled) = (false, title);
        let general = matches!(name, "MAT_GENERAL_VISCOELASTIC" | "MAT_076" | "MAT_76");
        if general || matches!(name, "MAT_VISCOELASTIC" | "MAT_006" | "MAT_6") {
            open = true;
            blocks.push(Block { keyword: line, general, title: None, cards: Vec::new() });
        } else if name.contains("VISCOELASTIC") || name.starts_with("PARAMETER") || name.ends_with(['+', '-', '%']) {
            let help = "read are *MAT_GENERAL_VISCOELASTIC and *MAT_VISCOELASTIC with numbers in fields of 10 columns, or with commas";
            return Err(source.wrong(&line, format!("*{word} is not read"), "this keyword").help(help));
        } else if !matches!(name, "KEYWORD" | "END" | "TITLE") {
            skipped.push((format!("*{word}"), line.number));
        }
    }
    Ok(blocks)
}

/// The numbers of a card; an empty field is zero.
fn fields(source: &DeckSource<'_>, line: &Line<'_>, names: &[&str]) -> Result<Vec<f64>, SceneError> {
    let words: Vec<String> = if line.text.contains(',') {
        line.text.split(',').map(|word| word.trim().to_owned()).collect()
    } else {
        if line.text.contains('\t') {
            return Err(source.wrong(line, "a tab in a card of fixed columns", "write spaces, or commas between the fields"));
        }
        let characters: Vec<char> = line.text.trim_end().chars().collect();
        characters.chunks(WIDTH).map(|field| field.iter().collect::<String>().trim().to_owned()).collect()
    };
    let mut numbers = Vec::with_capacity(names.len());
    for (index, word) in words.iter().enumerate() {
        let Some(name) = names.get(index) else {
            if word.is_empty() {
                continue;
            }
            return Err(source.wrong(line, format!("field {} of this card, {word:?}, has no meaning here", index + 1), "leave it out"));
        };
        if word.contains(char::is_whitespace) {
            let message =
                format!("columns {} to {} hold {word:?}: the card is not in fields of 10 columns", index * WIDTH + 1, (index + 1) * WIDTH);
            return Err(source.wrong(line, message, "align it, or write commas between the fields"));
        }
        numbers.push(if word.is_empty() { 0.0 } else { source.number(line, word, name)? });
    }
    numbers.resize(names.len(), 0.0);
    Ok(numbers)
}

fn general(source: &DeckSource<'_>, block: &Block<'_>, notes: &mut Vec<String>) -> Result<Solid, SceneError> {
    let first = block.cards.first().ok_or_else(|| source.wrong(&block.keyword, "the material has no cards", "here"))?;
    let [_, _, bulk, pressure, layer, _, a, b] = known(fields(source, first, &["MID", "RO", "BULK", "PCF", "EF", "TREF", "A", "B"])?);
    for (name, value) in [("PCF", pressure), ("EF", layer)] {
        if value != 0.0 {
            notes.push(format!("{name} = {value} is not used"));
        }
    }
    if a != 0.0 || b != 0.0 {
        notes.push("the shift by TREF, A and B is not read: the terms hold at the reference temperature; give material.shift".to_owned());
    }
    let curve = ["LCID", "NT", "BSTART", "TRAMP", "LCIDK", "NTK", "BSTARTK", "TRAMPK"];
    if let Some(second) = block.cards.get(1) {
        let values: [f64; 8] = known(fields(source, second, &curve)?);
        if values.iter().any(|&value| value != 0.0) {
            let help = "viscotack reads terms, not load curves. If this line holds GI and BETAI, put an empty line above it: the second card of *MAT_GENERAL_VISCOELASTIC";
            return Err(source.wrong(second, "the second card of the material, LCID and so on, is not empty", "this card").help(help));
        }
    }
    let (mut shear, mut volume) = (Vec::new(), Vec::new());
    let (mut lasting_shear, mut lasting_bulk) = (0.0, 0.0);
    for line in block.cards.iter().skip(2) {
        let [g, beta, k, beta_k] = known(fields(source, line, &["GI", "BETAI", "KI", "BETAKI"])?);
        for (strength, rate, terms, lasting, name) in
            [(g, beta, &mut shear, &mut lasting_shear, "GI"), (k, beta_k, &mut volume, &mut lasting_bulk, "KI")]
        {
            if strength < 0.0 || rate < 0.0 {
                return Err(source.wrong(
                    line,
                    format!("{name} = {strength} with the decay rate {rate}: one is negative"),
                    "must be 0 or more",
                ));
            }
            if strength > 0.0 && rate == 0.0 {
                *lasting += source.pressure(strength)?;
            } else if strength > 0.0 {
                terms.push((source.pressure(strength)?, source.time(1.0 / rate)?));
            }
        }
    }
    if shear.is_empty() && lasting_shear == 0.0 {
        let help = "after the first card and an empty line, write cards with GI, BETAI, KI, BETAKI";
        return Err(source.wrong(&block.keyword, "the material has no shear term", "this material").help(help));
    }
    let by_terms = !volume.is_empty() || lasting_bulk > 0.0;
    let bulk = match (bulk > 0.0, by_terms) {
        (true, false) => Relaxing::constant(source.pressure(bulk)?),
        (false, true) if lasting_bulk == 0.0 => {
            let help = "a solid keeps a bulk modulus: add a card whose KI does not decay, for example 0.0,0.0,900.0,0.0";
            return Err(source
                .wrong(&block.keyword, "every KI decays, so nothing holds the volume in the end", "this material")
                .help(help));
        }
        (false, true) => Relaxing { modulus: lasting_bulk, moduli: Moduli::LongTerm, strength: Strength::Modulus, terms: volume },
        (true, true) => {
            let help = "set BULK to 0 if the KI are the whole bulk modulus, or leave KI and BETAKI out if it is constant";
            return Err(source.wrong(first, "BULK and KI are both given", "which is the bulk modulus?").help(help));
        }
        (false, false) => return Err(source.wrong(first, "BULK is 0 and no KI is given", "the third field must be greater than 0")),
    };
    let shear = Relaxing { modulus: lasting_shear, moduli: Moduli::LongTerm, strength: Strength::Modulus, terms: shear };
    Ok(Solid { shear, volume: Volume::Bulk(bulk) })
}

fn single(source: &DeckSource<'_>, block: &Block<'_>) -> Result<Solid, SceneError> {
    let [line, rest @ ..] = block.cards.as_slice() else {
        return Err(source.wrong(&block.keyword, "the material has no cards", "here"));
    };
    if let Some(more) = rest.iter().find(|card| !card.text.trim().is_empty()) {
        return Err(source.wrong(more, "*MAT_VISCOELASTIC has one card", "leave this line out"));
    }
    let [_, _, bulk, short, long, beta] = known(fields(source, line, &["MID", "RO", "BULK", "G0", "GI", "BETA"])?);
    if !(bulk > 0.0 && short > 0.0 && long >= 0.0 && beta > 0.0) {
        let message = format!("BULK = {bulk}, G0 = {short}, GI = {long}, BETA = {beta}");
        return Err(source.wrong(line, message, "BULK, G0 and BETA must be greater than 0, GI 0 or more"));
    }
    if long > short {
        return Err(source.wrong(line, format!("GI = {long} is above G0 = {short}"), "the long-term modulus is the smaller one"));
    }
    let terms = vec![(source.pressure(short - long)?, source.time(1.0 / beta)?)];
    let shear = Relaxing { modulus: source.pressure(long)?, moduli: Moduli::LongTerm, strength: Strength::Modulus, terms };
    Ok(Solid { shear, volume: Volume::Bulk(Relaxing::constant(source.pressure(bulk)?)) })
}

/// As many numbers as a card has fields.
fn known<const N: usize>(values: Vec<f64>) -> [f64; N] {
    values.try_into().unwrap_or([0.0; N])
}
