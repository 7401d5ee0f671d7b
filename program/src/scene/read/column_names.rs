//! What headers of tables of materials mean, in English, German and French, and where their unit stands.

use crate::scene::units::{Dimension, parse_quantity};

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Frequency,
    AngularFrequency,
    Time,
    Temperature,
    Storage,
    Loss,
    LossTangent,
    Complex,
    Phase,
    Relaxation,
    Creep,
    Factor,
    LogFactor,
    NaturalLogFactor,
}

/// Role, key in `material.columns`, dimension, symbols, and words that mean it; small letters, without blanks, points and strokes, primes as `'`.
type Entry = (Role, &'static str, Dimension, &'static [&'static str], &'static [&'static str]);

const ROLES: [Entry; 14] = [
    (
        Role::Frequency,
        "frequency",
        Dimension::FREQUENCY,
        &["f"],
        &["frequency", "freq", "frequenz", "fréquence", "frequence", "testfrequency", "messfrequenz", "prüffrequenz"],
    ),
    (
        Role::AngularFrequency,
        "angular_frequency",
        Dimension::FREQUENCY,
        &["ω", "w"],
        &[
            "angularfrequency",
            "angfrequency",
            "angularfreq",
            "angfreq",
            "omega",
            "kreisfrequenz",
            "winkelfrequenz",
            "pulsation",
            "fréquenceangulaire",
        ],
    ),
    (Role::Time, "time", Dimension::TIME, &["t"], &["time", "zeit", "temps", "steptime", "schrittzeit", "abschnittszeit", "tempsd'étape"]),
    (
        Role::Temperature,
        "temperature",
        Dimension::TEMPERATURE,
        &["ts"],
        &["temperature", "temp", "temperatur", "température", "sampletemperature", "sampletemp", "probentemperatur", "ist-temperatur"],
    ),
    (
        Role::Storage,
        "storage_modulus",
        Dimension::PRESSURE,
        &["e'", "g'", "m'"],
        &[
            "storagemodulus",
            "storagemod",
            "storage",
            "estor",
            "estorage",
            "gstor",
            "gstorage",
            "speichermodul",
            "moduledeconservation",
            "moduledestockage",
        ],
    ),
    (
        Role::Loss,
        "loss_modulus",
        Dimension::PRESSURE,
        &["e''", "g''", "m''"],
        &["lossmodulus", "lossmod", "loss", "eloss", "gloss", "verlustmodul", "moduledeperte", "moduledepertes"],
    ),
    (
        Role::LossTangent,
        "loss_tangent",
        Dimension::NUMBER,
        &["tanδ", "tan(δ)", "tandelta", "tan(delta)", "tand", "tan(d)"],
        &[
            "losstangent",
            "lossfactor",
            "dampingfactor",
            "verlustfaktor",
            "facteurdeperte",
            "facteurdepertes",
            "facteurd'amortissement",
            "δtan",
        ],
    ),
    (
        Role::Complex,
        "complex_modulus",
        Dimension::PRESSURE,
        &["e*", "|e*|", "g*", "|g*|", "m*", "|m*|"],
        &["complexmodulus", "complexmod", "komplexermodul", "komplexmodul", "modulecomplexe"],
    ),
    (
        Role::Phase,
        "phase_angle",
        Dimension::NUMBER,
        &["δ", "delta", "φ", "phi"],
        &[
            "phase",
            "phaseangle",
            "phaseshift",
            "phaseshiftangle",
            "lossangle",
            "phasenwinkel",
            "phasenverschiebung",
            "phasenverschiebungswinkel",
            "déphasage",
            "angledephase",
            "angledeperte",
        ],
    ),
    (
        Role::Relaxation,
        "relaxation_modulus",
        Dimension::PRESSURE,
        &["e(t)", "g(t)", "r", "r(t)"],
        &[
            "relaxationmodulus",
            "relaxationmod",
            "relaxmod",
            "stressrelaxationmodulus",
            "erelax",
            "grelax",
            "relaxationsmodul",
            "modulederelaxation",
        ],
    ),
    (
        Role::Creep,
        "creep_compliance",
        Dimension::COMPLIANCE,
        &["j", "j(t)", "d(t)"],
        &["creepcompliance", "compliance", "kriechnachgiebigkeit", "nachgiebigkeit", "complaisance", "complaisancedefluage"],
    ),
    (
        Role::Factor,
        "factor",
        Dimension::NUMBER,
        &["at"],
        &["factor", "shiftfactor", "horizontalshiftfactor", "verschiebungsfaktor", "facteurdeglissement"],
    ),
    (Role::LogFactor, "log10_factor", Dimension::NUMBER, &["logat", "log10at", "log(at)", "log10(at)", "lgat", "lg(at)"], &["log10factor"]),
    (Role::NaturalLogFactor, "ln_factor", Dimension::NUMBER, &["lnat", "ln(at)"], &["lnfactor"]),
];

pub(super) const EXAMPLE: &str = "the header is such as: frequency (Hz), storage modulus (MPa), loss modulus (MPa); or time (s), relaxation modulus (MPa); or name the columns in [material.columns]";

/// The word of a role in messages and in `material.columns`.
pub(super) fn word(role: Role) -> &'static str {
    ROLES.iter().find(|entry| entry.0 == role).map_or("", |entry| entry.1)
}

/// The same as a person says it.
pub(super) fn spoken(role: Role) -> String {
    word(role).replace('_', " ")
}

pub(super) fn dimension(role: Role) -> Dimension {
    ROLES.iter().find(|entry| entry.0 == role).map_or(Dimension::NUMBER, |entry| entry.2)
}

/// All roles with their words, in order.
pub(super) fn roles() -> impl Iterator<Item = (Role, &'static str)> {
    ROLES.iter().map(|entry| (entry.0, entry.1))
}

/// What is said of the way a sample is strained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Strained {
    Shear,
    Tension,
}

/// A name as [`ROLES`] has it.
pub(super) fn plain(name: &str) -> String {
    let mut plain = String::with_capacity(name.len());
    for c in name.to_lowercase().chars() {
        match c {
            ' ' | '\u{a0}' | '_' | '-' | '.' => {}
            '′' | '’' | '‘' | '´' | '`' => plain.push('\''),
            '″' | '”' | '“' | '"' => plain.push_str("''"),
            other => plain.push(other),
        }
    }
    plain
}

/// Words before a name that say how the sample is strained.
const STRAINED: [(&str, Strained); 8] = [
    ("shear", Strained::Shear),
    ("schub", Strained::Shear),
    ("scher", Strained::Shear),
    ("tensile", Strained::Tension),
    ("tension", Strained::Tension),
    ("young's", Strained::Tension),
    ("flexural", Strained::Tension),
    ("bending", Strained::Tension),
];

/// What a name means, and what it says of the strain.
pub(super) fn meaning(name: &str) -> Option<(Role, Option<Strained>)> {
    let plain = plain(name);
    let (rest, said) =
        STRAINED.iter().find_map(|(word, strained)| Some((plain.strip_prefix(word)?, Some(*strained)))).unwrap_or((plain.as_str(), None));
    for (role, _, dimension, symbols, words) in &ROLES {
        let of_modulus = *dimension == Dimension::PRESSURE || *dimension == Dimension::COMPLIANCE;
        let lettered = |text: &str| match text.trim_start_matches(['|', '(']).chars().next() {
            Some('g') if of_modulus => Some(Strained::Shear),
            Some('e') if of_modulus => Some(Strained::Tension),
            _ => None,
        };
        if symbols.contains(&rest) || words.contains(&rest) {
            return Some((*role, said.or_else(|| if *role == Role::Creep { None } else { lettered(rest) })));
        }
        // `Storage modulus E'`, `E' (storage modulus)`, `Verlustmodul, G''`.
        for symbol in *symbols {
            let beside = |text: &str| {
                let inner = text.trim_start_matches([',', ';', ':']);
                let inner = inner.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')).unwrap_or(inner);
                words.contains(&inner)
            };
            let in_brackets = format!("({symbol})");
            if rest.strip_prefix(symbol).is_some_and(beside)
                || [*symbol, in_brackets.as_str()]
                    .iter()
                    .any(|symbol| rest.strip_suffix(symbol).is_some_and(|word| words.contains(&word.trim_end_matches([',', ':']))))
            {
                return Some((*role, said.or_else(|| if *role == Role::Creep { None } else { lettered(symbol) })));
            }
        }
    }
    None
}

/// A header's name and its unit: what stands behind a known name is its unit, whether or not it can be read; `E(t)` is a name.
pub(super) fn split(header: &str, is_known: impl Fn(&str) -> bool) -> (String, Option<String>) {
    let header = header.trim().trim_end_matches(':');
    let parts = |name: &str, unit: &str| (name.trim().trim_end_matches([',', ':']).to_owned(), Some(unit.trim().to_owned()));
    if is_known(header) {
        return (header.trim().to_owned(), None);
    }
    for (open, close) in [('[', ']'), ('(', ')'), ('<', '>')] {
        // A unit may hold brackets of its own: E (N/(mm^2)).
        for (at, _) in header.rmatch_indices(open) {
            if let (Some(name), Some(unit)) = (header.get(..at), header.get(at + 1..).and_then(|rest| rest.trim_end().strip_suffix(close)))
                && !name.trim().is_empty()
                && (is_known(name.trim().trim_end_matches([',', ':'])) || parse_quantity(&format!("1 {unit}")).is_ok())
            {
                return parts(name, unit);
            }
        }
    }
    for mark in [" / ", "/", " in ", ", "] {
        if let Some((name, unit)) = header.split_once(mark)
            && (is_known(name.trim()) || mark == " / ")
        {
            return parts(name, unit);
        }
    }
    // `storage_MPa`, `Storage Modulus MPa`.
    for mark in ['_', ' '] {
        if let Some((name, unit)) = header.rsplit_once(mark)
            && is_known(name.trim())
            && parse_quantity(&format!("1 {unit}")).is_ok()
        {
            return parts(name, unit);
        }
    }
    (header.to_owned(), None)
}

/// The unit in a header that the scene names as a whole: `Modulus of sample 3 (MPa)`.
pub(super) fn unit_within(header: &str) -> Option<String> {
    split(header, |_| false).1.filter(|unit| parse_quantity(&format!("1 {unit}")).is_ok())
}
