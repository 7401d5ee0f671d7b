//! Material cards of finite-element programs: `material.abaqus = "card.inp"` and so on, one parser a program, one result.
//!
//! | key | program | moduli of the card | what relaxes |
//! |---|---|---|---|
//! | `abaqus` | Abaqus, `*VISCOELASTIC, TIME=PRONY` | long-term unless `*ELASTIC, MODULI=INSTANTANEOUS` | g_i, k_i: fractions of the instantaneous G and K |
//! | `ansys` | ANSYS, `TB,PRONY` | instantaneous | α_i: fractions of the instantaneous G or K |
//! | `ls_dyna` | LS-DYNA, `*MAT_076`, `*MAT_006` | long-term are the terms without decay | G_i and K_i with decay rates |
//! | `comsol` | COMSOL, generalized Maxwell branches | long-term unless `material.moduli` says otherwise | shear moduli; the bulk modulus is constant |
//! | `moose` | MOOSE, `GeneralizedMaxwellModel` | instantaneous | stiffnesses, by Young's modulus and Poisson ratio |
//!
//! A deck states no units, so the scene does, in `material.deck_units`. What a parser does not use it names in a note.

mod abaqus;
mod ansys;
mod comsol;
mod ls_dyna;
mod moose;
mod source;

use super::material_solid::{MadeSolid, Moduli, Relaxing, Solid, Strength, Volume};
use super::section::Section;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::DeckOrigin;
use source::DeckSource;
use viscotack::material::shift::ShiftFactors;

/// A parser.
type Parser = fn(&DeckSource<'_>) -> Result<Deck, SceneError>;

/// A program: its key, its name, its parser, and whether a text looks like its deck.
struct Program {
    key: &'static str,
    name: &'static str,
    parse: Parser,
    recognises: fn(&str) -> bool,
}

const PROGRAMS: [Program; 5] = [
    Program { key: "ls_dyna", name: "LS-DYNA", parse: ls_dyna::parse, recognises: ls_dyna::recognises },
    Program { key: "abaqus", name: "Abaqus", parse: abaqus::parse, recognises: abaqus::recognises },
    Program { key: "ansys", name: "ANSYS", parse: ansys::parse, recognises: ansys::recognises },
    Program { key: "moose", name: "MOOSE", parse: moose::parse, recognises: moose::recognises },
    Program { key: "comsol", name: "COMSOL", parse: comsol::parse, recognises: comsol::recognises },
];

/// What a deck holds, in SI units.
struct Deck {
    /// What it calls the material.
    name: Option<String>,
    solid: Solid,
    /// Williams, Landel and Ferry's reference temperature (K), c1, and c2 (K).
    shift: Option<[f64; 3]>,
    /// What was taken as what, and what was skipped, a sentence each without its full stop.
    notes: Vec<String>,
}

/// A deck's solid and shift factors.
pub(super) struct ReadDeck {
    pub(super) solid: MadeSolid,
    pub(super) shift: Option<ShiftFactors>,
    pub(super) reference: Option<f64>,
    pub(super) origin: DeckOrigin,
}

/// The keys of `material` that name a deck.
pub(super) const PATHS: [&str; 5] = ["material.abaqus", "material.ansys", "material.ls_dyna", "material.comsol", "material.moose"];

pub(super) fn is_deck(key: &str) -> bool {
    PROGRAMS.iter().any(|program| program.key == key)
}

/// The key of `[material]` that a text belongs to, by what it holds; none if it is no deck.
#[must_use]
pub fn recognised(text: &str) -> Option<&'static str> {
    let is_scene = text.lines().any(|line| {
        let line = line.trim();
        line.starts_with("[material]") || line.starts_with("[material.") || line.starts_with("material.") || line.starts_with("material =")
    });
    PROGRAMS.iter().find(|program| !is_scene && (program.recognises)(text)).map(|program| program.key)
}

/// As [`recognised`], of a file; none if it cannot be read, which another reader says better.
#[must_use]
pub fn recognised_file(path: &std::path::Path) -> Option<&'static str> {
    crate::scene::document::read_text(path).ok().and_then(|text| recognised(&text))
}

/// Reads the deck that `material.FORM` names.
pub(super) fn read(table: &Section<'_>, document: &Document, form: &'static str) -> Result<ReadDeck, SceneError> {
    let file = table.required_text(form)?;
    if table.units() == Units::Reduced {
        return Err(table.wrong(
            form,
            format!("`material.{form}` is a deck in units, and the scene is in reduced ones"),
            "write units = \"si\"",
        ));
    }
    let Some(text) = document.attached(file) else {
        return Err(table.wrong(form, format!("`material.{form}` = {file:?} was not read"), "this file"));
    };
    let Some(program) = PROGRAMS.iter().find(|program| program.key == form) else { return Err(table.missing(form)) };
    let source = DeckSource::new(table, form, text)?;
    let deck = (program.parse)(&source).map_err(|error| match recognised(text.text()) {
        Some(other) if other != form && !(program.recognises)(text.text()) => {
            table.wrong(form, format!("{file:?} looks like the deck of another program: {error}"), format!("write {other} = {file:?}"))
        }
        _ => error,
    })?;
    let solid = deck.solid.made().map_err(|message| table.wrong(form, format!("{file:?}: {message}"), "this deck"))?;
    let mut notes = deck.notes;
    notes.extend(source.unused_units());
    if let Some(isotropic) = &solid.isotropic {
        let [glassy, relaxed] = isotropic.poisson_ratios();
        notes.push(format!("Poisson's ratio follows from the shear and the bulk modulus: {glassy:.4} at once, {relaxed:.4} in the end"));
    }
    let (mut shift, mut reference) = (None, None);
    if let Some([temperature, c1, c2]) = deck.shift {
        if let Some(key) = ["shift", "reference_temperature"].into_iter().find(|key| table.node().get(key).is_some()) {
            let message = format!("`material.{key}` is given, and the deck {file:?} has shift factors of its own");
            return Err(table.wrong(key, message, "leave it out"));
        }
        shift = Some(ShiftFactors::WilliamsLandelFerry { c1, c2, reference: temperature });
        reference = Some(temperature);
        notes.push(format!("shift factors by Williams, Landel and Ferry: c1 = {c1}, c2 = {c2} K, reference {temperature:.2} K"));
    }
    let origin = DeckOrigin { file: file.to_owned(), program: program.name, name: deck.name, notes };
    Ok(ReadDeck { solid, shift, reference, origin })
}

/// A solid by Young's modulus and Poisson ratio of a kind, with fractions of the instantaneous shear and bulk modulus that relax.
fn by_youngs(modulus: f64, ratio: f64, moduli: Moduli, shear: Vec<(f64, f64)>, bulk: Vec<(f64, f64)>) -> Result<Solid, String> {
    let of = |modulus: f64, terms: Vec<(f64, f64)>| Relaxing { modulus, moduli, strength: Strength::Fraction, terms };
    // Both moduli relax alike: Poisson's ratio is constant. Without a term the solid is elastic.
    let alike = shear == bulk;
    let volume = if alike || (ratio >= 0.5 && bulk.is_empty()) {
        Volume::PoissonRatio(ratio)
    } else if ratio < 0.5 {
        Volume::Bulk(of(modulus / (3.0 * (1.0 - 2.0 * ratio)), bulk))
    } else {
        return Err("a Poisson ratio of 0.5 has no finite bulk modulus that could relax".into());
    };
    Ok(Solid { shear: of(modulus / (2.0 * (1.0 + ratio)), shear), volume })
}
