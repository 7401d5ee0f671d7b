//! Source: `reference_data/sliding_wave.csv`, written by `verification/references/sliding_wave.py` (thesis Eqs 3.23, 3.24).
//!
//! Goal: every total, edge amplitude, pressure and gap of contacts with given edges, the edges of contacts without and with adhesion, the energy release of
//! both edges, and the friction of full contact against a second method that shares no reduction with the solver.
//!
//! ```text
//! solver:     effective pressure, loads behind the contact as unknowns, memory operator inverted in closed form
//! reference:  p = Σ c_n T_n(t)/√(1 − t²) as unknown, t = tan(y/2)/tan(a/2), the integral equation collocated, memory as thesis (3.24) defines it
//! ```
//! Parameters: 1, 2, 6 and 12 terms, β from 4 to 40, sliding ratios from 0.01 to 1e6, half-widths from 0.6 to 2.2; E0 = 2.3 MPa and kv = 7/s, no units.
//!
//! Oracle: the file, whose values agree between two resolutions to `confirmed_digits` (11, the most that is stated) of their scale.
//!
//! Tolerance: three units of the last confirmed digit of the scale of the value (one, or the value if that is larger).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::sliding::{contact_at_rate, contact_near};
use support::{Row, reference_rows};
use viscotack::PlaneMaterial;
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactMemory, ContactState, Prescribed, WaveContact};
use viscotack::sliding::steady::WaveAdhesion;
use viscotack::sliding::steady::full_contact_friction;

const RELAXED: f64 = 2.3e6;
const RATE: f64 = 7.0;

/// The solid of a row, at the rate `RATE`.
fn material(row: &Row) -> PlaneMaterial {
    let terms: Vec<(f64, f64)> = row
        .text("terms")
        .split_whitespace()
        .map(|term| {
            let (compliance, ratio) = term.split_once(':').unwrap();
            (compliance.parse().unwrap(), ratio.parse().unwrap())
        })
        .collect();
    let glassy = 1.0 - terms.iter().map(|term| term.0).sum::<f64>();
    let terms: Vec<CreepTerm> = terms
        .into_iter()
        .map(|(compliance, ratio)| CreepTerm { compliance: compliance / RELAXED, retardation_time: ratio / RATE })
        .collect();
    PlaneMaterial::from_creep(RELAXED / glassy, &terms, None).unwrap()
}

/// The error over the scale, after checking it against what the reference confirms.
fn assess(row: &Row, value: f64) -> f64 {
    let error = (value - row.number("value")).abs() / row.number("scale");
    let digits = row.number("confirmed_digits");
    assert!(digits >= 11.0, "the reference itself is not converged");
    let name = format!("{} {} {} {}", row.text("asked"), row.text("case"), row.text("quantity"), row.text("position"));
    assert!(error < 3.0 * 10f64.powf(-digits), "{name}: {value:e} instead of {:e}, error {error:e}", row.number("value"));
    error
}

#[test]
fn contacts_with_given_edges() {
    let rows = reference_rows("sliding_wave.csv");
    let (mut count, mut worst) = (0, 0.0_f64);
    for row in rows.iter().filter(|row| row.text("asked") == "given_edges") {
        let memory = ContactMemory::new(&material(row), RATE).unwrap();
        let contact = WaveContact { half_width: row.number("a"), eccentricity: row.number("e") };
        let state = ContactState::new(&memory, contact, Prescribed::MeanPressure(row.number("mean_pressure"))).unwrap();
        let value = match row.text("quantity") {
            "penetration" => state.penetration(),
            "friction_stress" => state.friction_stress(),
            "interface_work" => state.interface_work(),
            "trailing_amplitude" => state.edge_amplitudes().0,
            "leading_amplitude" => state.edge_amplitudes().1,
            "pressure" => {
                let part = row.number("position");
                let point = if part < 0.0 {
                    state.inside_trailing((1.0 + part) * contact.half_width)
                } else {
                    state.inside_leading((1.0 - part) * contact.half_width)
                };
                state.pressure(point.unwrap())
            }
            "gap" => state.gap(state.behind_trailing(row.number("position") * 2.0 * (PI - contact.half_width)).unwrap()),
            other => panic!("quantity {other}"),
        };
        let error = assess(row, value);
        worst = worst.max(error);
        count += 1;
        // The other control, from the penetration of the reference, returns the mean pressure.
        if row.text("quantity") == "penetration" {
            let held = ContactState::new(&memory, contact, Prescribed::Penetration(row.number("value"))).unwrap();
            let pressure_error = (held.mean_pressure() - row.number("mean_pressure")).abs();
            println!("{}: condition {:.1}, mean pressure by penetration {pressure_error:.1e}", row.text("case"), state.condition());
            assert!(pressure_error < 1e-12, "{}: {pressure_error:e}", row.text("case"));
        }
    }
    println!("given edges, {count} values: worst error {worst:.1e} of the scale");
    assert_eq!(count, 96);
}

#[test]
fn contacts_without_adhesion() {
    let rows = reference_rows("sliding_wave.csv");
    let (mut count, mut worst) = (0, 0.0_f64);
    for row in rows.iter().filter(|row| row.text("asked") == "adhesiveless" && row.text("quantity") == "mean_pressure") {
        let found = contact_at_rate(&material(row), RATE, None, Prescribed::MeanPressure(row.number("value")), 1e-12).unwrap();
        let contact = found.state.contact();
        // The half-width is exact in the file; it is the mean pressure that carries its error.
        let error = (contact.half_width - row.number("a")).abs();
        assert!(error < 3e-11, "{}: half-width {} instead of {}", row.text("case"), contact.half_width, row.number("a"));
        worst = worst.max(error);
        for other in rows.iter().filter(|other| other.text("asked") == "adhesiveless" && other.text("case") == row.text("case")) {
            let value = match other.text("quantity") {
                "eccentricity" => contact.eccentricity,
                "mean_pressure" => found.state.mean_pressure(),
                "penetration" => found.state.penetration(),
                "friction_stress" => found.state.friction_stress(),
                name => panic!("quantity {name}"),
            };
            worst = worst.max(assess(other, value));
            count += 1;
        }
    }
    println!("without adhesion, {count} values: worst error {worst:.1e}");
    assert_eq!(count, 16);
}

/// From edges a few per cent off. Tolerance: what the reference confirms; the releases lose U/(2πΓδ), up to 4 digits, of its 14.
#[test]
fn contacts_with_adhesion() {
    let rows: Vec<Row> = reference_rows("sliding_wave.csv").into_iter().filter(|row| row.text("asked") == "equilibrium").collect();
    let quantity =
        |case: &str, name: &str| rows.iter().find(|row| row.text("case") == case && row.text("quantity") == name).unwrap().number("value");
    let (mut count, mut worst) = (0, 0.0_f64);
    for row in rows.iter().filter(|row| row.text("quantity") == "reduced_work") {
        let (case, half_width, zone) = (row.text("case"), row.number("a"), row.number("zone"));
        let memory = ContactMemory::new(&material(row), RATE).unwrap();
        let adhesion = WaveAdhesion::even(row.number("value"), zone);
        let start = WaveContact { half_width: 1.03 * half_width, eccentricity: quantity(case, "eccentricity") - 0.02 };
        let found = contact_near(&memory, Some(adhesion), Prescribed::MeanPressure(row.number("mean_pressure")), start, 1e-12).unwrap();
        let contact = found.state.contact();
        println!(
            "{case}: Γ = {:.6}, a off by {:.1e}, e by {:.1e}, G₁ {:.6}, G₂ {:.6}, residual {:.0e}",
            adhesion.trailing_work,
            contact.half_width - half_width,
            contact.eccentricity - quantity(case, "eccentricity"),
            found.trailing_release,
            found.leading_release,
            found.residual
        );
        assert!((contact.half_width - half_width).abs() < 3e-11, "{case}: {} {half_width}", contact.half_width);
        for other in rows.iter().filter(|other| other.text("case") == case) {
            let value = match other.text("quantity") {
                "eccentricity" => contact.eccentricity,
                "reduced_work" => continue,
                "penetration" => found.state.penetration(),
                "friction_stress" => found.state.friction_stress(),
                "trailing_release" => found.trailing_release,
                "leading_release" => found.leading_release,
                name => panic!("quantity {name}"),
            };
            let error = (value - other.number("value")).abs() / other.number("scale");
            let tolerance = if other.text("quantity").ends_with("release") { 1e-10 } else { 3e-11 };
            assert!(error < tolerance, "{case} {}: {value} instead of {}, error {error:e}", other.text("quantity"), other.number("value"));
            worst = worst.max(error);
            count += 1;
        }
    }
    println!("with adhesion, {count} values: worst error {worst:.1e}");
    assert_eq!(count, 85);
}

#[test]
fn friction_of_full_contact() {
    let mut count = 0;
    for row in reference_rows("sliding_wave.csv").iter().filter(|row| row.text("asked") == "full") {
        assess(row, full_contact_friction(&material(row), RATE).unwrap().value);
        count += 1;
    }
    assert_eq!(count, 8);
}
