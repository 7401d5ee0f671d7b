//! Keys of the material: one linear viscoelastic solid, by creep terms or by relaxation terms.

use super::{Key, Kind, Range, Word};
use crate::scene::units::Dimension;

const MODULUS: Kind = Kind::Number { dimension: Dimension::PRESSURE, range: Range::Positive, reduced: "relaxed modulus E0" };
const TIME: Kind = Kind::Number { dimension: Dimension::TIME, range: Range::Positive, reduced: "reference time" };
const RATE: Kind = Kind::Number { dimension: Dimension::DECAY_RATE, range: Range::Positive, reduced: "1/reference time" };
const FRACTION: Kind = Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 1.0), reduced: "1" };

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "material",
        kind: Kind::Table,
        meaning: "The deformable solid. Without creep or relaxation terms it is elastic: no memory is simulated.",
    },
    Key {
        path: "material.file",
        kind: Kind::Text,
        meaning: "A TOML file whose [material] table is read in place of keys given here; relative to the scene.",
    },
    Key { path: "material.name", kind: Kind::Text, meaning: "What the material is called in tables and plots." },
    Key {
        path: "material.cautions",
        kind: Kind::Texts,
        meaning: "What is known against these numbers, a sentence each. `viscotack material` writes its cautions here, and every result shows them under its validity.",
    },
    Key {
        path: "material.relaxed_modulus",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::NonNegative, reduced: "1 (it is the unit)" },
        meaning: "Young's modulus E0 of a load held for ever; 0 is a viscous material.",
    },
    Key { path: "material.glassy_modulus", kind: MODULUS, meaning: "Young's modulus E∞ of an instantaneous load." },
    Key {
        path: "material.poisson_ratio",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(-1.0, 0.5), reduced: "1" },
        meaning: "Constant Poisson ratio; in plane strain and on a half-space this or material.bulk_modulus is needed.",
    },
    Key {
        path: "material.viscosity",
        kind: Kind::Number { dimension: Dimension::VISCOSITY, range: Range::Positive, reduced: "not available" },
        meaning: "Steady viscosity of a creep series that flows: adds t/η to the compliance and makes the relaxed modulus 0.",
    },
    Key { path: "material.creep", kind: Kind::Tables, meaning: "Terms J_j (1 − exp(−t/τ_j)) of the compliance." },
    Key {
        path: "material.creep[].compliance",
        kind: Kind::Number { dimension: Dimension::COMPLIANCE, range: Range::Positive, reduced: "1/E0" },
        meaning: "J_j; with exactly one of the two moduli.",
    },
    Key {
        path: "material.creep[].fraction",
        kind: FRACTION,
        meaning: "J_j as a fraction of 1/E0 − 1/E∞; with both moduli, all fractions summing to 1.",
    },
    Key { path: "material.creep[].retardation_time", kind: TIME, meaning: "τ_j, the time of a creep test." },
    Key { path: "material.relaxation", kind: Kind::Tables, meaning: "Terms E_i exp(−t/ρ_i) of the modulus." },
    Key { path: "material.relaxation[].modulus", kind: MODULUS, meaning: "E_i; with exactly one of the two moduli." },
    Key {
        path: "material.relaxation[].fraction",
        kind: FRACTION,
        meaning: "E_i as a fraction. With glassy_modulus or relaxed_modulus alone: of the instantaneous modulus E∞, and what the fractions leave of 1 is the long-term part. With both moduli: of E∞ − E0, all summing to 1.",
    },
    Key { path: "material.relaxation[].relaxation_time", kind: TIME, meaning: "ρ_i, the time of a relaxation test." },
    Key { path: "material.relaxation[].decay_rate", kind: RATE, meaning: "1/ρ_i, in place of relaxation_time." },
    Key {
        path: "material.shear_modulus",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::NonNegative, reduced: "not available" },
        meaning: "Shear modulus G, in place of Young's moduli, with material.bulk_modulus or a constant material.poisson_ratio. If something relaxes, material.moduli says which modulus this is.",
    },
    Key {
        path: "material.bulk_modulus",
        kind: Kind::Number { dimension: Dimension::PRESSURE, range: Range::Positive, reduced: "not available" },
        meaning: "Bulk modulus K beside material.shear_modulus: constant, unless material.bulk_relaxation is given. Young's and the plane modulus follow exactly, and Poisson's ratio changes with time.",
    },
    Key {
        path: "material.moduli",
        kind: Kind::Choice(&[
            Word {
                word: "instantaneous",
                meaning: "of a load before anything relaxes, as MODULI=INSTANTANEOUS of Abaqus and the moduli of ANSYS",
            },
            Word { word: "long_term", meaning: "of a load held for ever, as MODULI=LONG TERM of Abaqus and COMSOL's default" },
        ]),
        meaning: "Which moduli shear_modulus and bulk_modulus are (and those of material.comsol); fractions of terms are of the instantaneous one in both cases.",
    },
    Key { path: "material.shear_relaxation", kind: Kind::Tables, meaning: "Terms g_i exp(−t/ρ_i) of the shear modulus." },
    Key {
        path: "material.shear_relaxation[].fraction",
        kind: FRACTION,
        meaning: "g_i as a fraction of the instantaneous shear modulus; what the fractions leave of 1 is the long-term part.",
    },
    Key { path: "material.shear_relaxation[].modulus", kind: MODULUS, meaning: "g_i itself, in place of a fraction." },
    Key { path: "material.shear_relaxation[].relaxation_time", kind: TIME, meaning: "ρ_i." },
    Key { path: "material.shear_relaxation[].decay_rate", kind: RATE, meaning: "1/ρ_i, in place of relaxation_time." },
    Key {
        path: "material.bulk_relaxation",
        kind: Kind::Tables,
        meaning: "Terms k_i exp(−t/ρ_i) of the bulk modulus; without them it is constant.",
    },
    Key {
        path: "material.bulk_relaxation[].fraction",
        kind: FRACTION,
        meaning: "k_i as a fraction of the instantaneous bulk modulus; what the fractions leave of 1 is the long-term part.",
    },
    Key { path: "material.bulk_relaxation[].modulus", kind: MODULUS, meaning: "k_i itself, in place of a fraction." },
    Key { path: "material.bulk_relaxation[].relaxation_time", kind: TIME, meaning: "ρ_i." },
    Key { path: "material.bulk_relaxation[].decay_rate", kind: RATE, meaning: "1/ρ_i, in place of relaxation_time." },
    Key {
        path: "material.abaqus",
        kind: Kind::Text,
        meaning: "An Abaqus deck with *ELASTIC and *VISCOELASTIC, TIME=PRONY (and *TRS); relative to the scene, with material.deck_units.",
    },
    Key {
        path: "material.ansys",
        kind: Kind::Text,
        meaning: "An ANSYS deck with MP,EX (or GXY), MP,NUXY (or PRXY) and TB,PRONY; relative to the scene, with material.deck_units.",
    },
    Key {
        path: "material.ls_dyna",
        kind: Kind::Text,
        meaning: "An LS-DYNA deck with *MAT_GENERAL_VISCOELASTIC (076) or *MAT_VISCOELASTIC (006); relative to the scene, with material.deck_units.",
    },
    Key {
        path: "material.comsol",
        kind: Kind::Text,
        meaning: "A COMSOL text file with parameters (E and nu, or G and K; G1, tau1, …) and rows of shear modulus and relaxation time; relative to the scene, with material.deck_units where a number has no unit in brackets.",
    },
    Key {
        path: "material.moose",
        kind: Kind::Text,
        meaning: "A MOOSE input with a block of type GeneralizedMaxwellModel; relative to the scene, with material.deck_units.",
    },
    Key {
        path: "material.deck_material",
        kind: Kind::Text,
        meaning: "Which material of the deck is meant, by its name or number; needed where the deck has several.",
    },
    Key { path: "material.deck_units", kind: Kind::Table, meaning: "What the numbers of the deck are measured in: a deck has no units." },
    Key { path: "material.deck_units.pressure", kind: Kind::Text, meaning: "The unit of moduli, such as \"MPa\"." },
    Key {
        path: "material.deck_units.time",
        kind: Kind::Text,
        meaning: "The unit of times, such as \"s\"; decay rates are in one over it.",
    },
    Key {
        path: "material.deck_units.temperature",
        kind: Kind::Text,
        meaning: "The unit of temperatures, such as \"°C\"; needed where the deck has shift factors.",
    },
    Key {
        path: "material.data",
        kind: Kind::Text,
        meaning: "A table (CSV or other delimited text, as instruments export it) with storage and loss moduli against frequency (at one temperature or several), or with a creep or relaxation curve; a series is fitted to it. Relative to the scene.",
    },
    Key {
        path: "material.fit_error",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 0.5), reduced: "not available" },
        meaning: "Wanted root-mean-square relative error of the fit: it takes the fewest terms that reach it. Without it, as many terms as the scatter of the data justifies.",
    },
    Key {
        path: "material.columns",
        kind: Kind::Table,
        meaning: "The columns of the table, where their headers do not tell: each is a header, or \"HEADER in UNIT\".",
    },
    Key {
        path: "material.columns.of",
        kind: Kind::Choice(&[
            Word { word: "tension", meaning: "Young's modulus, or the compliance of tension; the default, unless a header names G" },
            Word { word: "shear", meaning: "a shear modulus or compliance: converted by E = 2(1 + ν)G with material.poisson_ratio" },
        ]),
        meaning: "What the moduli or compliances of the file are of; must be said where a header that this table names begins with G.",
    },
    Key {
        path: "material.uncertainty",
        kind: Kind::Choice(&[
            Word { word: "none", meaning: "errors are those of the numbers alone; the default" },
            Word {
                word: "propagate",
                meaning: "every state is solved again for 32 materials drawn from what the data leave open; each output gets their standard deviation as `material_uncertainty`, one standard uncertainty, beside its numerical error",
            },
        ]),
        meaning: "Whether the error of a fit to material.data reaches the results. Fields, and points of a branch that differ between draws, get none.",
    },
    Key { path: "material.columns.frequency", kind: Kind::Text, meaning: "Cycles per time." },
    Key { path: "material.columns.angular_frequency", kind: Kind::Text, meaning: "Radians per time." },
    Key { path: "material.columns.time", kind: Kind::Text, meaning: "Time since a step." },
    Key { path: "material.columns.temperature", kind: Kind::Text, meaning: "Temperature of the measurement." },
    Key { path: "material.columns.storage_modulus", kind: Kind::Text, meaning: "E′." },
    Key { path: "material.columns.loss_modulus", kind: Kind::Text, meaning: "E″." },
    Key { path: "material.columns.loss_tangent", kind: Kind::Text, meaning: "tan δ = E″/E′, in place of E″." },
    Key {
        path: "material.columns.complex_modulus",
        kind: Kind::Text,
        meaning: "|E*|, with a phase angle or a loss tangent, in place of E′.",
    },
    Key { path: "material.columns.phase_angle", kind: Kind::Text, meaning: "δ, the phase between stress and strain, in deg or rad." },
    Key { path: "material.columns.relaxation_modulus", kind: Kind::Text, meaning: "R(t)." },
    Key { path: "material.columns.creep_compliance", kind: Kind::Text, meaning: "J(t)." },
    Key {
        path: "material.temperature",
        kind: Kind::Number { dimension: Dimension::TEMPERATURE, range: Range::Positive, reduced: "not available" },
        meaning: "Temperature of the solid; needs material.shift. Without it, the reference temperature.",
    },
    Key {
        path: "material.reference_temperature",
        kind: Kind::Number { dimension: Dimension::TEMPERATURE, range: Range::Positive, reduced: "not available" },
        meaning: "Temperature at which the terms hold, and to which data are shifted; with an automatic shift, the middle one of the measured temperatures by default.",
    },
    Key {
        path: "material.temperature_tolerance",
        kind: Kind::Number { dimension: Dimension::TEMPERATURE_DIFFERENCE, range: Range::NonNegative, reduced: "not available" },
        meaning: "Rows of material.data whose temperatures differ by no more are one isotherm (default 1 K); a table of shift factors covers temperatures that lie outside it by no more.",
    },
    Key {
        path: "material.shift",
        kind: Kind::TableOrWord(&[
            Word {
                word: "automatic",
                meaning: "factors a_T found from material.data, where the curves of neighbouring temperatures overlap",
            },
            Word {
                word: "automatic_with_vertical",
                meaning: "the same, and a vertical factor b_T for each temperature: E(a_T ω; T_ref) = b_T E(ω; T)",
            },
        ]),
        meaning: "Time–temperature shift: every time is multiplied by a_T. A table with exactly one of wlf, arrhenius, factors, table; or a word: the factors are found from the data, each with its error.",
    },
    Key {
        path: "material.shift.wlf",
        kind: Kind::Table,
        meaning: "Williams, Landel and Ferry: log₁₀ a_T = −c1 (T − T_ref)/(c2 + T − T_ref).",
    },
    Key {
        path: "material.shift.wlf.c1",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "not available" },
        meaning: "c1, for logarithms to base ten.",
    },
    Key {
        path: "material.shift.wlf.c2",
        kind: Kind::Number { dimension: Dimension::TEMPERATURE_DIFFERENCE, range: Range::Positive, reduced: "not available" },
        meaning: "c2.",
    },
    Key { path: "material.shift.arrhenius", kind: Kind::Table, meaning: "ln a_T = (E_a/R)(1/T − 1/T_ref)." },
    Key {
        path: "material.shift.arrhenius.activation_energy",
        kind: Kind::Number { dimension: Dimension::ENERGY_PER_MOLE, range: Range::Positive, reduced: "not available" },
        meaning: "E_a.",
    },
    Key {
        path: "material.shift.factors",
        kind: Kind::Tables,
        meaning: "Given shift factors, interpolated in 1/T; relative to any temperature: they are divided by that at the reference temperature.",
    },
    Key {
        path: "material.shift.factors[].temperature",
        kind: Kind::Number { dimension: Dimension::TEMPERATURE, range: Range::Positive, reduced: "not available" },
        meaning: "T.",
    },
    Key {
        path: "material.shift.factors[].factor",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::Positive, reduced: "not available" },
        meaning: "a_T (not its logarithm): above 1 where the material is slower than at the reference temperature.",
    },
    Key {
        path: "material.shift.table",
        kind: Kind::Text,
        meaning: "A table with columns `temperature` and `factor`, `log10_factor` or `ln_factor`, as in factors; its path is relative to the scene.",
    },
    Key {
        path: "material.power_law",
        kind: Kind::Table,
        meaning: "Williams's modified power law R = E0 + (E∞ − E0)(1 + t/τ)^(−n), with both moduli; expanded into relaxation terms.",
    },
    Key {
        path: "material.power_law.exponent",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 10.0), reduced: "1" },
        meaning: "n.",
    },
    Key { path: "material.power_law.time", kind: TIME, meaning: "τ." },
    Key {
        path: "material.fractional_zener",
        kind: Kind::Table,
        meaning: "Fractional Zener solid E = E0 + (E∞ − E0)(iωτ)^α/(1 + (iωτ)^α), with both moduli; expanded into relaxation terms.",
    },
    Key {
        path: "material.fractional_zener.exponent",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 1.0), reduced: "1" },
        meaning: "α, below 1.",
    },
    Key { path: "material.fractional_zener.time", kind: TIME, meaning: "τ." },
    Key {
        path: "material.leave_out",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::NonNegative, reduced: "1" },
        meaning: "All terms are always kept: only 0, which says so, is allowed.",
    },
    Key { path: "material.expansion", kind: Kind::Table, meaning: "How a law is expanded into terms." },
    Key {
        path: "material.expansion.accuracy",
        kind: Kind::Number { dimension: Dimension::NUMBER, range: Range::AboveUpTo(0.0, 0.1), reduced: "1" },
        meaning: "Largest error of the complex modulus, relative to its magnitude; default 1e-6, at least 1e-10.",
    },
    Key {
        path: "material.expansion.slowest_time",
        kind: TIME,
        meaning: "The law is expanded down to the angular frequency 1/this; default 1e6 times the law's own time, or further where the scene lasts longer.",
    },
    Key {
        path: "material.expansion.fastest_time",
        kind: TIME,
        meaning: "The law is expanded up to the angular frequency 1/this; default 1e-6 times the law's own time, or further where the scene is faster.",
    },
];
