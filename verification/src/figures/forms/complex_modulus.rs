//! Storage and loss modulus of one term over frequency (thesis Eq 2.9): moduli in E0, frequency times the retardation time.

use super::super::table::Table;
use super::spaced;
use serde::Deserialize;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct ComplexModulus {
    stiffening_ratio: f64,
    frequencies: [f64; 2],
    points: usize,
}

impl ComplexModulus {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let material = PlaneMaterial::standard_solid(1.0, self.stiffening_ratio, 1.0)?;
        let frequencies = spaced(self.frequencies, self.points, true);
        let moduli = frequencies.iter().map(|frequency| material.complex_modulus(*frequency)).collect::<Result<Vec<_>, _>>()?;
        Ok(Table::exact(&[
            ("frequency", frequencies),
            ("storage", moduli.iter().map(|modulus| modulus.storage).collect()),
            ("loss", moduli.iter().map(|modulus| modulus.loss).collect()),
            ("loss_tangent", moduli.iter().map(viscotack::material::ComplexModulus::loss_tangent).collect()),
        ]))
    }
}
