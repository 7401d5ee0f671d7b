//! Every unit that is listed is read, with its size.
//!
//! Source: SI Brochure (BIPM, 9th edition; bar, ångström and poise in the 8th);
//! exact definitions of 1959 (inch, pound), 1901 (standard gravity); NIST SP 811, appendix B.
//! Goal: the list that `viscotack units` prints is what is read; an unknown unit leads to the one that is meant.
//! Oracle: the table below, written from the definitions, and the same units in base units.
//! Tolerance: rounding.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::float_cmp, missing_docs)]

use crate::command_support;

use command_support::{Folder, SINGLE};
use viscotack_program::scene::units::{Dimension, UnitError, groups, parse_quantity};

/// Sizes in SI units, from the definitions: pound = 0.45359237 kg · 9.80665 m/s², inch = 25.4 mm.
const POUND: f64 = 0.453_592_37 * 9.806_65;
const SQUARE_INCH: f64 = 25.4e-3 * 25.4e-3;

#[rustfmt::skip]
const SIZES: &[(&str, f64)] = &[
    ("m", 1.0), ("Å", 1e-10), ("micron", 1e-6), ("in", 25.4e-3), ("mil", 25.4e-6), ("ft", 12.0 * 25.4e-3), ("nm", 1e-9), ("µm", 1e-6), ("um", 1e-6), ("mm", 1e-3), ("cm", 1e-2),
    ("s", 1.0), ("sec", 1.0), ("min", 60.0), ("h", 3600.0), ("hr", 3600.0), ("d", 86_400.0), ("ns", 1e-9), ("µs", 1e-6), ("ms", 1e-3),
    ("Hz", 1.0), ("rad/s", 1.0), ("1/s", 1.0), ("s^-1", 1.0), ("1/min", 1.0 / 60.0),
    ("m/s", 1.0), ("mm/s", 1e-3), ("µm/s", 1e-6), ("nm/s", 1e-9), ("mm/min", 1e-3 / 60.0), ("in/min", 25.4e-3 / 60.0),
    ("Pa", 1.0), ("bar", 1e5), ("psi", POUND / SQUARE_INCH), ("ksi", 1000.0 * POUND / SQUARE_INCH), ("atm", 101_325.0), ("Torr", 101_325.0 / 760.0),
    // Density of mercury by convention, 13595.1 kg/m³.
    ("mmHg", 13_595.1 * 9.806_65 * 1e-3), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9), ("N/m2", 1.0), ("N/mm2", 1e6), ("lbf/in2", POUND / SQUARE_INCH), ("dyn/cm2", 0.1),
    ("kgf/cm2", 9.806_65e4), ("kgf/mm2", 9.806_65e6),
    ("1/Pa", 1.0), ("1/MPa", 1e-6), ("1/GPa", 1e-9), ("MPa^-1", 1e-6), ("m2/N", 1.0), ("mm2/N", 1e-6), ("cm²/dyn", 10.0), ("1/psi", SQUARE_INCH / POUND),
    ("P", 0.1), ("Pa s", 1.0), ("kPa·s", 1e3), ("MPa.s", 1e6), ("mPa s", 1e-3), ("N s/m2", 1.0), ("cP", 1e-3),
    ("J/m2", 1.0), ("mJ/m2", 1e-3), ("mJ/m²", 1e-3), ("erg/cm2", 1e-3), ("N/m", 1.0), ("mN/m", 1e-3), ("dyn/cm", 1e-3), ("N/mm", 1e3), ("N/cm", 100.0), ("nN/nm", 1.0),
    ("gf/cm", 0.980_665), ("lbf/in", POUND / 25.4e-3),
    ("N", 1.0), ("dyn", 1e-5), ("gf", 9.806_65e-3), ("kgf", 9.806_65), ("lbf", POUND), ("nN", 1e-9), ("µN", 1e-6), ("mN", 1e-3), ("kN", 1e3),
    ("N/s", 1.0), ("mN/s", 1e-3), ("nN/s", 1e-9), ("N/min", 1.0 / 60.0),
    ("Pa/s", 1.0), ("kPa/s", 1e3), ("MPa/s", 1e6), ("MPa/min", 1e6 / 60.0), ("psi/s", POUND / SQUARE_INCH),
    ("Pa √m", 1.0), ("kPa √m", 1e3), ("MPa √m", 1e6), ("MPa m^0.5", 1e6), ("MPa m^(1/2)", 1e6), ("N/mm^1.5", 31_622.776_601_683_792),
    // √0.0254 = 0.159373774505092...
    ("ksi √in", 1000.0 * POUND / SQUARE_INCH * 0.159_373_774_505_092_2),
    ("Pa √m/s", 1.0), ("MPa √m/s", 1e6),
    ("Pa/m", 1.0), ("kPa/µm", 1e9), ("MPa/mm", 1e9), ("N/m3", 1.0), ("N/mm3", 1e9),
    ("K", 1.0), ("°C", 1.0), ("degC", 1.0), ("deg C", 1.0), ("℃", 1.0), ("°F", 5.0 / 9.0), ("degF", 5.0 / 9.0), ("deg F", 5.0 / 9.0), ("℉", 5.0 / 9.0),
    ("J/mol", 1.0), ("kJ/mol", 1e3), ("kcal/mol", 4184.0),
    ("%", 0.01), ("rad", 1.0),
    ("g", 1e-3), ("mg", 1e-6), ("kg", 1.0), ("J", 1.0), ("erg", 1e-7), ("cal", 4.184), ("nJ", 1e-9), ("µJ", 1e-6), ("mJ", 1e-3), ("kJ", 1e3), ("kcal", 4184.0), ("N m", 1.0),
    ("W", 1.0), ("mW", 1e-3), ("mol", 1.0),
];

#[test]
fn every_listed_unit_has_the_size_of_its_definition() {
    let mut listed = 0;
    for group in groups() {
        assert!(!group.units.is_empty(), "{}", group.what);
        for unit in &group.units {
            let size = SIZES.iter().find(|(name, _)| *name == unit.unit).unwrap_or_else(|| panic!("`{}` is not in the table", unit.unit)).1;
            assert!(
                (unit.size / size - 1.0).abs() <= 4.0 * f64::EPSILON.max(if unit.zero == 0.0 { 0.0 } else { 1e-15 }),
                "{unit:?} {size}"
            );
            let quantity = parse_quantity(&format!("3 {}", unit.unit)).unwrap();
            assert!(quantity.dimension.measures(group.dimension), "{unit:?}");
            assert!((quantity.value / (3.0 * size + unit.zero) - 1.0).abs() <= 4.0 * f64::EPSILON, "{unit:?}");
            listed += 1;
        }
    }
    assert_eq!(listed, SIZES.len(), "a unit of the table is not listed, or twice");
}

#[test]
fn products_powers_and_brackets_are_read_in_every_usual_way() {
    for (text, same) in [
        ("2 J/(m^2)", "2 J/m2"),
        ("2 N/(mm s)", "2 N/mm/s"),
        ("8.3 J/(mol)", "8.3 J/mol"),
        ("2 m**2", "2 m^2"),
        ("2 MPa*m^0.5", "2 MPa √m"),
        ("2 Pa.s", "2 Pa s"),
        ("2 (N/m)/s", "2 N/m/s"),
        ("2 Pa/1 s", "2 Pa s"),
        ("2 1/(Pa s)", "2 Pa^-1 s^-1"),
        ("2 m/(s/m)", "2 m2/s"),
        ("3 \u{212b}", "3 Å"),
        ("3 \u{212a}", "3 K"),
        ("1 m^(-1)", "1 1/m"),
    ] {
        assert_eq!(parse_quantity(text), parse_quantity(same), "{text}");
    }
    for text in ["1 (m", "1 m)", "1 J/()", "1 (N/m)^2", "1 √m^0.5", "1 m^0.3", "1 m^(1/3)", "1 m^.", "1 m^-", "1 m^(", "1 m^99.5"] {
        assert!(matches!(parse_quantity(text), Err(UnitError::Malformed(_))), "{text}: {:?}", parse_quantity(text));
    }
}

#[test]
fn an_unknown_unit_leads_to_the_one_that_is_meant() {
    for (text, meant) in [
        ("3 mpa", "MPa"),
        ("3 Kpa", "kPa"),
        ("3 KG", "kg"),
        ("3 hz", "Hz"),
        ("3 seconds", "s"),
        ("3 lb", "lbf"),
        ("3 inch", "in"),
        ("3 PSI", "psi"),
        ("3 Newton", "N"),
        ("3 microns", "µm"),
        ("20 C", "°C"),
        ("3 barr", "bar"),
        ("3 MPaa", "MPa"),
    ] {
        let error = parse_quantity(text).unwrap_err();
        assert!(error.to_string().contains(&format!("did you mean `{meant}`?")), "{text}: {error}");
        // What is suggested can be typed.
        parse_quantity(&format!("3 {meant}")).unwrap();
    }
    let error = parse_quantity("3 furlong").unwrap_err().to_string();
    assert!(!error.contains("did you mean") && error.contains("viscotack units"), "{error}");
    let folder = Folder::with(&SINGLE.replace("1 mm/s", "1 MM/sec"));
    let answer = folder.call(&["run", "scene.toml"]).ended(2);
    assert!(answer.stderr.contains("`MM` is not a unit known here; did you mean `mm`?"), "{}", answer.stderr);
}

#[test]
fn the_command_lists_them() {
    let folder = Folder::new();
    let said = folder.call(&["units"]).ended(0).stdout;
    let json = folder.call(&["units", "--json"]).ended(0).json();
    let listed = json.as_array().unwrap();
    assert_eq!(listed.len(), groups().len());
    for (group, listed) in groups().iter().zip(listed) {
        assert!(said.contains(group.what) && listed["what"] == group.what, "{}", group.what);
        for (unit, listed) in group.units.iter().zip(listed["units"].as_array().unwrap()) {
            assert!(said.contains(&format!("  {:12} = ", unit.unit)), "{}", unit.unit);
            assert_eq!((listed["unit"].as_str(), listed["size"].as_f64()), (Some(unit.unit), Some(unit.size)));
        }
    }
    assert!(said.lines().all(|line| line == line.trim_end()));
}

#[test]
fn quantities_are_rounded_once() {
    for (text, value, dimension) in [
        ("0.7 MPa", 7e5, Dimension::PRESSURE),
        ("3 µm", 3e-6, Dimension::LENGTH),
        ("3um", 3e-6, Dimension::LENGTH),
        ("50 mJ/m²", 0.05, Dimension::ENERGY_PER_AREA),
        ("50 mJ/m^2", 0.05, Dimension::ENERGY_PER_AREA),
        ("1.1 N/m", 1.1, Dimension::ENERGY_PER_AREA),
        ("0.4 1/MPa", 4e-7, Dimension::COMPLIANCE),
        ("0.4 MPa^-1", 4e-7, Dimension::COMPLIANCE),
        ("0.4 MPa⁻¹", 4e-7, Dimension::COMPLIANCE),
        ("2 kPa s", 2e3, Dimension::VISCOSITY),
        ("2 kPa·s", 2e3, Dimension::VISCOSITY),
        ("-1.5e-3 nm/s", -1.5e-12, Dimension::SPEED),
        ("90 min", 5400.0, Dimension::TIME),
        ("5 %", 0.05, Dimension::NUMBER),
        ("0.3", 0.3, Dimension::NUMBER),
        ("1_000 m", 1000.0, Dimension::LENGTH),
        ("0.013 ms", 1.3e-5, Dimension::TIME),
        ("20 kPa √m", 2e4, Dimension::STRESS_INTENSITY),
        ("1 MPa √mm", 1e5 / 10f64.sqrt(), Dimension::STRESS_INTENSITY),
    ] {
        let quantity = parse_quantity(text).unwrap();
        assert!((quantity.value - value).abs() <= f64::EPSILON * value.abs() * f64::from(u8::from(text.contains('√'))), "{text}");
        assert_eq!(quantity.dimension, dimension, "{text}");
    }
}

/// Exact by the SI Brochure (BIPM): base and derived units, prefixes, minute and hour, degree Celsius; bar, ångström and poise as in its 8th edition.
#[test]
fn units_and_prefixes_are_those_of_the_si_brochure() {
    for (text, value) in [
        ("1 m", 1.0),
        ("1 g", 1e-3),
        ("1 s", 1.0),
        ("1 K", 1.0),
        ("1 N", 1.0),
        ("1 Pa", 1.0),
        ("1 bar", 1e5),
        ("1 mbar", 100.0),
        ("1 J", 1.0),
        ("1 W", 1.0),
        ("1 Hz", 1.0),
        ("1 P", 0.1),
        ("1 cP", 1e-3),
        ("1 min", 60.0),
        ("1 h", 3600.0),
        ("1 Å", 1e-10),
        ("1 %", 0.01),
        ("1 rad", 1.0),
        ("1 mol", 1.0),
        ("1 fm", 1e-15),
        ("1 pm", 1e-12),
        ("1 nm", 1e-9),
        ("1 µm", 1e-6),
        ("1 mm", 1e-3),
        ("1 cm", 1e-2),
        ("1 km", 1e3),
        ("1 MPa", 1e6),
        ("1 GPa", 1e9),
        ("1 TPa", 1e12),
        ("0 °C", 273.15),
        ("-273.15 °C", 0.0),
        ("20 degC", 293.15),
        ("212 °F", 373.15),
        ("1 dyn", 1e-5),
        ("1 erg", 1e-7),
        ("1 in", 0.0254),
        ("1 lbf", 4.448_221_615_260_5),
    ] {
        assert_eq!(parse_quantity(text).unwrap().value, value, "{text}");
    }
    // A bar is a pressure, a poise a viscosity, and so on: one of each in base units.
    for (text, same) in [
        ("1 bar", "1 kg/m/s^2"),
        ("1 P", "1 kg/m/s"),
        ("1 J", "1 kg m^2/s^2"),
        ("1 W", "1 kg m^2/s^3"),
        ("1 N", "1 kg m/s^2"),
        ("1 Hz", "1 1/s"),
        ("1 lbf/in2", "1 psi"),
        ("1 erg/cm2", "1 mJ/m^2"),
        ("1 cm²/dyn", "1 m2 N-1"),
    ] {
        assert_eq!(parse_quantity(text).unwrap().dimension, parse_quantity(same).unwrap().dimension, "{text}");
    }
    // NIST SP 811, appendix B.
    let psi = parse_quantity("1 psi").unwrap().value;
    assert!((psi / 6_894.757_293_168_4 - 1.0).abs() < 1e-14, "{psi}");
    assert_eq!(parse_quantity("3 N/mm2").unwrap().value, 3e6);
}

#[test]
fn what_is_no_quantity_says_why() {
    assert_eq!(parse_quantity("MPa"), Err(UnitError::NoNumber));
    assert_eq!(parse_quantity(""), Err(UnitError::NoNumber));
    assert_eq!(parse_quantity("nan Pa"), Err(UnitError::NoNumber));
    assert_eq!(parse_quantity("3 furlong"), Err(UnitError::UnknownUnit("furlong".into())));
    assert!(matches!(parse_quantity("3 m/"), Err(UnitError::Malformed(_))));
    assert!(matches!(parse_quantity("3 m//s"), Err(UnitError::Malformed(_))));
    assert!(matches!(parse_quantity("3 m^"), Err(UnitError::Malformed(_))));
    assert!(matches!(parse_quantity("3 m^99"), Err(UnitError::Malformed(_))));
}
