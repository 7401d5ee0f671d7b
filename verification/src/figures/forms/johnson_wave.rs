//! The elastic wave of Johnson (1995) with a modulus m (1 relaxed, β glassy), in the reduced units of sliding (theory of δ → 0):
//! p̄ = m s² − 2√(mΓ tan(a/2)), Δ = s²(1 − 2 ln s) + 4√(Γ tan(a/2)/m) ln s, s = sin(a/2).

use super::super::table::Table;
use super::spaced;
use serde::Deserialize;
use viscotack::refusal::Refusal;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct JohnsonCurve {
    /// Γ.
    work_of_adhesion: f64,
    /// m.
    modulus: f64,
    /// From and to this ka.
    half_widths: [f64; 2],
    points: usize,
}

impl JohnsonCurve {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let (work, modulus) = (self.work_of_adhesion, self.modulus);
        let widths = spaced(self.half_widths, self.points, false);
        let of = |width: &f64| {
            let (sine, tangent) = ((0.5 * width).sin(), (0.5 * width).tan());
            let pull = (work * tangent / modulus).sqrt();
            (modulus * (sine * sine - 2.0 * pull), sine * sine * (1.0 - 2.0 * sine.ln()) + 4.0 * pull * sine.ln())
        };
        Ok(Table::exact(&[
            ("mean_pressure", widths.iter().map(|width| of(width).0).collect()),
            ("penetration", widths.iter().map(|width| of(width).1).collect()),
            ("half_width", widths),
        ]))
    }
}
