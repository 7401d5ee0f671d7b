//! Contacts with given edges against the stored Chebyshev collocation of another program.

use crate::studies::reference::{Row, SLIDING_WAVE, rows};
use crate::studies::section::Check;
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactMemory, ContactState, Prescribed, WaveContact};

/// The stored Chebyshev collocation at given edges: penetration, friction, interface work.
pub(super) fn against_reference() -> Check {
    let name = "given edges against the stored Chebyshev collocation";
    let expected = "within 1e-10 of the scale: eleven digits are confirmed there, one is left for its last";
    let all = rows(SLIDING_WAVE);
    let (mut worst, mut count) = (0.0_f64, 0);
    for row in all.iter().filter(|row| row.text("asked") == "given_edges") {
        match difference(row) {
            Ok(Some(error)) => {
                worst = worst.max(error);
                count += 1;
            }
            Ok(None) => {}
            Err(refusal) => return Check::new(name, expected, format!("{}: {refusal}", row.text("case")), false),
        }
    }
    Check::new(name, expected, format!("{worst:.1e} at worst of {count} values"), count >= 20 && worst <= 1e-10)
}

/// The relaxation state of a row: terms `j:ζ`.
pub(in crate::studies) fn material_of(row: &Row) -> Result<PlaneMaterial, Refusal> {
    let relaxed = 1.1e6;
    let terms: Vec<CreepTerm> = row
        .text("terms")
        .split_whitespace()
        .filter_map(|term| term.split_once(':'))
        .map(|(compliance, ratio)| CreepTerm {
            compliance: compliance.parse::<f64>().unwrap_or(f64::NAN) / relaxed,
            retardation_time: ratio.parse().unwrap_or(f64::NAN),
        })
        .collect();
    let glassy = 1.0 - terms.iter().map(|term| term.compliance * relaxed).sum::<f64>();
    PlaneMaterial::from_creep(relaxed / glassy, &terms, None)
}

fn difference(row: &Row) -> Result<Option<f64>, Refusal> {
    let quantity = row.text("quantity");
    if !["penetration", "friction_stress", "interface_work"].contains(&quantity) {
        return Ok(None);
    }
    let memory = ContactMemory::new(&material_of(row)?, 1.0)?;
    let contact = WaveContact { half_width: row.number("a"), eccentricity: row.number("e") };
    let state = ContactState::new(&memory, contact, Prescribed::MeanPressure(row.number("mean_pressure")))?;
    let found = match quantity {
        "penetration" => state.penetration(),
        "friction_stress" => state.friction_stress(),
        _ => state.interface_work(),
    };
    Ok(Some((found - row.number("value")).abs() / row.number("scale")))
}
