//! The one list of units: what is read, what `viscotack units` prints, and which unit is meant by an unknown one.

use super::{Dimension, parse_quantity};

/// A symbol that a unit is made of.
pub(super) struct Symbol {
    pub(super) symbol: &'static str,
    /// Its size in SI units.
    pub(super) size: f64,
    /// Exponents of metre, kilogram, second, kelvin and mole.
    pub(super) exponents: [i8; 5],
    /// Whether a prefix may stand before it.
    pub(super) prefixed: bool,
}

const fn of(symbol: &'static str, size: f64, exponents: [i8; 5]) -> Symbol {
    Symbol { symbol, size, exponents, prefixed: false }
}

const fn prefixed(symbol: &'static str, size: f64, exponents: [i8; 5]) -> Symbol {
    Symbol { symbol, size, exponents, prefixed: true }
}

const NUMBER: [i8; 5] = [0; 5];
const LENGTH: [i8; 5] = [1, 0, 0, 0, 0];
const TIME: [i8; 5] = [0, 0, 1, 0, 0];
const FORCE: [i8; 5] = [1, 1, -2, 0, 0];
const PRESSURE: [i8; 5] = [-1, 1, -2, 0, 0];
const ENERGY: [i8; 5] = [2, 1, -2, 0, 0];

// The inch and the pound are exact since 1959, standard gravity since 1901.
const INCH: f64 = 0.0254;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
const POUND_PER_SQUARE_INCH: f64 = POUND_FORCE / (INCH * INCH);

/// Every symbol. A new one needs a row in `tests/scene/units.rs`, too.
pub(super) const SYMBOLS: [Symbol; 35] = [
    prefixed("m", 1.0, LENGTH),
    of("Å", 1e-10, LENGTH),
    of("micron", 1e-6, LENGTH),
    of("in", INCH, LENGTH),
    of("mil", 2.54e-5, LENGTH),
    of("ft", 0.3048, LENGTH),
    prefixed("s", 1.0, TIME),
    prefixed("sec", 1.0, TIME),
    of("min", 60.0, TIME),
    of("h", 3600.0, TIME),
    of("hr", 3600.0, TIME),
    of("d", 86_400.0, TIME),
    prefixed("Hz", 1.0, [0, 0, -1, 0, 0]),
    prefixed("N", 1.0, FORCE),
    prefixed("dyn", 1e-5, FORCE),
    of("gf", 9.806_65e-3, FORCE),
    of("kgf", 9.806_65, FORCE),
    of("lbf", POUND_FORCE, FORCE),
    prefixed("Pa", 1.0, PRESSURE),
    prefixed("bar", 1e5, PRESSURE),
    of("psi", POUND_PER_SQUARE_INCH, PRESSURE),
    of("ksi", 1e3 * POUND_PER_SQUARE_INCH, PRESSURE),
    of("atm", 101_325.0, PRESSURE),
    of("Torr", 101_325.0 / 760.0, PRESSURE),
    of("mmHg", 133.322_387_415, PRESSURE),
    prefixed("P", 0.1, [-1, 1, -1, 0, 0]),
    prefixed("K", 1.0, [0, 0, 0, 1, 0]),
    of("%", 1e-2, NUMBER),
    prefixed("rad", 1.0, NUMBER),
    prefixed("g", 1e-3, [0, 1, 0, 0, 0]),
    prefixed("J", 1.0, ENERGY),
    of("erg", 1e-7, ENERGY),
    prefixed("cal", 4.184, ENERGY),
    prefixed("W", 1.0, [2, 1, -3, 0, 0]),
    prefixed("mol", 1.0, [0, 0, 0, 0, 1]),
];

/// Decimal exponents, so that `"0.7 MPa"` is the double nearest to 7e5 and not 0.7 times a rounded factor.
pub(super) const PREFIXES: [(&str, i32); 12] =
    [("M", 6), ("k", 3), ("G", 9), ("m", -3), ("µ", -6), ("μ", -6), ("u", -6), ("n", -9), ("c", -2), ("p", -12), ("f", -15), ("T", 12)];

/// How °C and °F are written: only alone, as their zero is not that of the kelvin.
pub(super) const CELSIUS: [&str; 4] = ["°C", "degC", "deg C", "℃"];
pub(super) const FAHRENHEIT: [&str; 4] = ["°F", "degF", "deg F", "℉"];

/// What is measured, and its usual units besides the symbols themselves.
const GROUPS: [(&str, Dimension, &[&str]); 21] = [
    ("length", Dimension::LENGTH, &["nm", "µm", "um", "mm", "cm"]),
    ("time", Dimension::TIME, &["ns", "µs", "ms"]),
    ("frequency", Dimension::FREQUENCY, &["rad/s", "1/s", "s^-1", "1/min"]),
    ("speed", Dimension::SPEED, &["m/s", "mm/s", "µm/s", "nm/s", "mm/min", "in/min"]),
    ("modulus, stress, pressure", Dimension::PRESSURE, &["kPa", "MPa", "GPa", "N/m2", "N/mm2", "lbf/in2", "dyn/cm2", "kgf/cm2", "kgf/mm2"]),
    ("compliance", Dimension::COMPLIANCE, &["1/Pa", "1/MPa", "1/GPa", "MPa^-1", "m2/N", "mm2/N", "cm²/dyn", "1/psi"]),
    ("viscosity", Dimension::VISCOSITY, &["Pa s", "kPa·s", "MPa.s", "mPa s", "N s/m2", "cP"]),
    (
        "work of adhesion, energy per area; load per width; stiffness",
        Dimension::ENERGY_PER_AREA,
        &["J/m2", "mJ/m2", "mJ/m²", "erg/cm2", "N/m", "mN/m", "dyn/cm", "N/mm", "N/cm", "nN/nm", "gf/cm", "lbf/in"],
    ),
    ("force", Dimension::FORCE, &["nN", "µN", "mN", "kN"]),
    ("rate of a force", Dimension::FORCE_RATE, &["N/s", "mN/s", "nN/s", "N/min"]),
    ("rate of a stress", Dimension::PRESSURE_RATE, &["Pa/s", "kPa/s", "MPa/s", "MPa/min", "psi/s"]),
    ("stress intensity", Dimension::STRESS_INTENSITY, &["Pa √m", "kPa √m", "MPa √m", "MPa m^0.5", "MPa m^(1/2)", "N/mm^1.5", "ksi √in"]),
    ("rate of a stress intensity", Dimension::STRESS_INTENSITY_RATE, &["Pa √m/s", "MPa √m/s"]),
    ("stiffness per area", Dimension::STIFFNESS_PER_AREA, &["Pa/m", "kPa/µm", "MPa/mm", "N/m3", "N/mm3"]),
    ("temperature", Dimension::TEMPERATURE, &[]),
    ("activation energy", Dimension::ENERGY_PER_MOLE, &["J/mol", "kJ/mol", "kcal/mol"]),
    ("plain number", Dimension::NUMBER, &[]),
    ("mass (in products)", Dimension::new([0, 1, 0, 0]), &["mg", "kg"]),
    ("energy (in products)", Dimension::new([2, 1, -2, 0]), &["nJ", "µJ", "mJ", "kJ", "kcal", "N m"]),
    ("power (in products)", Dimension::new([2, 1, -3, 0]), &["mW"]),
    ("amount (in products)", Dimension { halves: [0, 0, 0, 0, 2], sense: super::Sense::Plain }, &[]),
];

/// Units of one dimension.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitGroup {
    /// What is measured.
    pub what: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// The symbols of this dimension, then usual units made of several.
    pub units: Vec<ListedUnit>,
}

/// A unit of the list.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedUnit {
    /// As it is written.
    pub unit: &'static str,
    /// Its size in the SI unit of the group.
    pub size: f64,
    /// Where its zero lies in the SI unit: 0 but for °C and °F.
    pub zero: f64,
    /// Whether a prefix from f to T may stand before it.
    pub prefixes: bool,
}

/// Every unit, by what it measures.
#[must_use]
pub fn groups() -> Vec<UnitGroup> {
    GROUPS
        .iter()
        .map(|&(what, dimension, usual)| {
            let whole = |symbol: &Symbol| symbol.exponents.map(|exponent| 2 * exponent) == dimension.halves;
            let symbols = SYMBOLS.iter().filter(|symbol| whole(symbol)).map(|symbol| (symbol.symbol, symbol.prefixed));
            let mut units: Vec<ListedUnit> = symbols
                .chain(usual.iter().map(|unit| (*unit, false)))
                .filter_map(|(unit, prefixes)| {
                    Some(ListedUnit { unit, size: parse_quantity(&format!("1 {unit}")).ok()?.value, zero: 0.0, prefixes })
                })
                .collect();
            if dimension == Dimension::TEMPERATURE {
                let with_zero = |unit: &'static str| {
                    let at = |number: &str| parse_quantity(&format!("{number} {unit}")).map(|quantity| quantity.value);
                    let (zero, hundred) = (at("0").ok()?, at("100").ok()?);
                    Some(ListedUnit { unit, size: (hundred - zero) / 100.0, zero, prefixes: false })
                };
                units.extend(CELSIUS.into_iter().chain(FAHRENHEIT).filter_map(with_zero));
            }
            UnitGroup { what, dimension, units }
        })
        .collect()
}

/// What is often written for a symbol.
const SYNONYMS: [(&str, &str); 24] = [
    ("second", "s"),
    ("seconds", "s"),
    ("minute", "min"),
    ("minutes", "min"),
    ("hour", "h"),
    ("hours", "h"),
    ("hrs", "h"),
    ("day", "d"),
    ("days", "d"),
    ("meter", "m"),
    ("metre", "m"),
    ("microns", "µm"),
    ("angstrom", "Å"),
    ("inch", "in"),
    ("inches", "in"),
    ("newton", "N"),
    ("pascal", "Pa"),
    ("joule", "J"),
    ("dyne", "dyn"),
    ("lb", "lbf"),
    ("lbs", "lbf"),
    ("kelvin", "K"),
    ("c", "°C"),
    ("f", "°F"),
];

/// The unit that is meant by an unknown one: another name of it, other capitals, or one letter more, less or else.
pub(super) fn nearest(unknown: &str) -> Option<String> {
    let small = unknown.to_lowercase();
    if let Some((_, symbol)) = SYNONYMS.iter().find(|(name, _)| *name == small) {
        return Some((*symbol).to_owned());
    }
    let prefixes = || std::iter::once("").chain(PREFIXES.iter().map(|(prefix, _)| *prefix));
    let every = || {
        SYMBOLS.iter().flat_map(move |symbol| {
            prefixes().filter(|prefix| prefix.is_empty() || symbol.prefixed).map(move |prefix| format!("{prefix}{}", symbol.symbol))
        })
    };
    // Of `mpa` and `mm` in other capitals, mega is meant of pressures and frequencies only.
    let mega = |name: &str| name.starts_with('M') && !name.ends_with("Pa") && !name.ends_with("Hz");
    let same = || every().filter(|name| name.to_lowercase() == small);
    same()
        .find(|name| !mega(name))
        .or_else(|| same().next())
        // Two letters are one letter away from nearly everything.
        .or_else(|| {
            every().find(|name| name.chars().count() >= 3 && small.chars().count() >= 3 && strsim::damerau_levenshtein(name, unknown) == 1)
        })
}
